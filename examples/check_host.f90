! SPDX-License-Identifier: BSD-3-Clause
! A Fortran host has its own time step looked at by the conformance kit: the step, behind the kit's callback.
!     pkg-config --cflags --libs vti-fortran vti-check
module own_step
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use vti_check_kit
    implicit none

contains

    !> Velocity Verlet; q <- normalise(q + (h/2) omega q).
    function advance(h, steps, n, x, v, quat, omega, mass, inertia, kit) result(status)
        real(c_double), intent(in) :: h
        integer(c_int64_t), intent(in) :: steps, n
        real(c_double), intent(inout) :: x(3, n), v(3, n), quat(4, n), omega(3, n)
        real(c_double), intent(in) :: mass(n), inertia(n)
        type(vti_kit), intent(in) :: kit
        integer(c_int) :: status
        real(c_double) :: force(3, n), moment(3, n)
        integer(c_int64_t) :: i, k
        call vti_check_forces(kit, x, quat, force, moment) ! prime: the first kick needs them
        do k = 1, steps
            call kick()
            do i = 1, n
                x(:, i) = x(:, i) + h*v(:, i)
                quat(:, i) = quat(:, i) + h/2*times(omega(:, i), quat(:, i))
                quat(:, i) = quat(:, i)/norm2(quat(:, i))
            end do
            call vti_check_forces(kit, x, quat, force, moment)
            call kick()
        end do
        status = 0

    contains

        subroutine kick()
            integer(c_int64_t) :: j
            do j = 1, n
                v(:, j) = v(:, j) + h/2*force(:, j)/mass(j)
                omega(:, j) = omega(:, j) + h/2*moment(:, j)/inertia(j)
            end do
        end subroutine
    end function

    !> The product of the quaternion (w, 0) with q, in the order x, y, z, w.
    pure function times(w, q) result(r)
        real(c_double), intent(in) :: w(3), q(4)
        real(c_double) :: r(4)
        r = [q(4)*w(1) + w(2)*q(3) - w(3)*q(2), q(4)*w(2) + w(3)*q(1) - w(1)*q(3), q(4)*w(3) + w(1)*q(2) - w(2)*q(1), &
            -dot_product(w, q(1:3))]
    end function
end module

program check_host
    use own_step
    implicit none
    if (vti_check('my code', advance) /= 0) stop 1
end program
