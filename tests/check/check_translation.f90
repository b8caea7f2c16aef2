! SPDX-License-Identifier: BSD-3-Clause
!> A Fortran code that moves positions only, by the conformance kit with and without rotation.
module flight
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use vti_check_kit
    implicit none

contains

    !> Velocity Verlet; attitudes and spins are left as they are.
    function advance(h, steps, n, x, v, quat, omega, mass, inertia, kit) result(status)
        real(c_double), intent(in) :: h
        integer(c_int64_t), intent(in) :: steps, n
        real(c_double), intent(inout) :: x(3, n), v(3, n), quat(4, n), omega(3, n)
        real(c_double), intent(in) :: mass(n), inertia(n)
        type(vti_kit), intent(in) :: kit
        integer(c_int) :: status
        real(c_double) :: force(3, n), moment(3, n)
        integer(c_int64_t) :: k
        status = merge(0_c_int, 1_c_int, size(omega) == size(x) .and. all(inertia > 0))
        call vti_check_forces(kit, x, quat, force, moment)
        do k = 1, steps
            v = v + h/2*force/spread(mass, 1, 3)
            x = x + h*v
            call vti_check_forces(kit, x, quat, force, moment)
            v = v + h/2*force/spread(mass, 1, 3)
        end do
    end function
end module

program check_translation
    use flight
    implicit none
    if (vti_check('translation', advance, translation=.true.) /= 0) stop 1
    if (vti_check('all', advance) == 0) stop 2
    if (vti_check('all', advance, translation=.false.) == 0) stop 3
end program
