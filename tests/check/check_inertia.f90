! SPDX-License-Identifier: BSD-3-Clause
!> Fortran hosts of bodies with three moments, by the conformance kit: the library's own steps on arrays, without a
!> fault; and with moments in the wrong order.
module solids
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use vti
    use vti_check_kit
    implicit none

contains

    function advance(h, steps, n, x, v, quat, spin, mass, moments, kit) result(status)
        real(c_double), intent(in) :: h
        integer(c_int64_t), intent(in) :: steps, n
        real(c_double), intent(inout) :: x(3, n), v(3, n), quat(4, n), spin(3, n)
        real(c_double), intent(in) :: mass(n), moments(3, n)
        type(vti_kit), intent(in) :: kit
        integer(c_int) :: status
        real(c_double), target :: q(4, n), l(3, n), i(3, n), force(3, n), moment(3, n)
        type(vti_bodies) :: bodies
        type(vti_stepper) :: method
        integer(c_int64_t) :: k
        q = quat
        l = spin
        i = moments
        bodies = vti_bodies_none(n)
        bodies%quat = vti_quat_view_columns(q)
        bodies%spin = vti_view_columns(l)
        bodies%moments = vti_view_columns(i)
        bodies%moment = vti_view_columns(moment)
        method = vti_stepper_find('exact')
        call vti_check_forces(kit, x, q, force, moment)
        status = merge(0_c_int, 1_c_int, all(abs(v) < 1) .and. all(mass > 0))
        do k = 1, steps
            if (status == 0) status = vti_step_begin(method, h, bodies)
            call vti_check_forces(kit, x, q, force, moment)
            if (status == 0) status = vti_step_finish(method, h, bodies)
        end do
        quat = q
        spin = l
    end function

    function disordered(h, steps, n, x, v, quat, spin, mass, moments, kit) result(status)
        real(c_double), intent(in) :: h
        integer(c_int64_t), intent(in) :: steps, n
        real(c_double), intent(inout) :: x(3, n), v(3, n), quat(4, n), spin(3, n)
        real(c_double), intent(in) :: mass(n), moments(3, n)
        type(vti_kit), intent(in) :: kit
        integer(c_int) :: status
        status = advance(h, steps, n, x, v, quat, spin, mass, moments([2, 3, 1], :), kit)
    end function
end module

program check_inertia
    use solids
    implicit none
    if (vti_check_inertia('exact', advance) /= 0) stop 1
    if (vti_check_inertia('disordered', disordered) /= 1) stop 2
end program
