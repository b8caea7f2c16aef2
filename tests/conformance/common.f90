! SPDX-License-Identifier: BSD-3-Clause
!> What the Fortran conformance tests share: the C side, a seeded state of seven bodies, and the count of failures.
module common
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_ptr
    use, intrinsic :: iso_fortran_env, only: error_unit, int64
    use vti
    implicit none

    integer(c_int64_t), parameter :: n = 7
    integer, private :: failures = 0

    interface
        !> The first numbers of C's table of sizes and offsets, and how many there are.
        function shim_layout(room, values) result(count) bind(c)
            import :: c_int64_t
            integer(c_int64_t), value :: room
            integer(c_int64_t), intent(out) :: values(room)
            integer(c_int64_t) :: count
        end function

        subroutine shim_forces(bodies) bind(c)
            import :: vti_bodies
            type(vti_bodies), intent(in) :: bodies
        end subroutine

        !> The run in C; stepper counts from 0 there.
        function shim_run(stepper, h, steps, n, x, v, alpha, quat, omega, mass, inertia) result(status) bind(c)
            import :: c_double, c_int, c_int64_t, c_ptr
            integer(c_int64_t), value :: stepper, steps, n
            real(c_double), value :: h
            type(c_ptr), value :: x, v, alpha, quat, omega, mass, inertia
            integer(c_int) :: status
        end function

        subroutine shim_measures(bodies, other, values) bind(c)
            import :: c_double, vti_bodies
            type(vti_bodies), intent(in) :: bodies, other
            real(c_double), intent(out) :: values(21)
        end subroutine
    end interface

    !> Seven bodies, no two alike; the attitude both ways.
    type :: state
        real(c_double) :: x(3, n), v(3, n), alpha(3, n), quat(4, n), omega(3, n), mass(n), inertia(n)
    end type

    interface same_bits
        module procedure same_bits_1, same_bits_2
    end interface

contains

    function initial() result(s)
        type(state) :: s
        integer :: i
        s%x = reshape([(number(i), i=1, 21)], [3, 7])
        s%v = reshape([(number(i), i=22, 42)], [3, 7])
        s%alpha = reshape([(4*number(i), i=43, 63)], [3, 7])
        s%omega = reshape([(3*number(i), i=64, 84)], [3, 7])
        s%mass = [(2 + number(i), i=85, 91)]
        s%inertia = [(1.5_c_double + number(i), i=92, 98)]
        do i = 1, int(n)
            s%quat(:, i) = [s%alpha(:, i), 2.0_c_double]
            s%quat(:, i) = s%quat(:, i)/norm2(s%quat(:, i))
        end do
    end function

    !> Number i of a fixed pseudo-random sequence in (-1, 1).
    pure function number(i) result(r)
        integer, intent(in) :: i
        real(c_double) :: r
        integer(int64) :: seed
        integer :: k
        seed = 20240229_int64 + i
        do k = 1, 5
            seed = modulo(48271_int64*seed, 2147483647_int64)
        end do
        r = 2*real(seed, c_double)/2147483647_c_double - 1
    end function

    pure function same_bits_1(a, b) result(same)
        real(c_double), intent(in) :: a(:), b(:)
        logical :: same
        same = size(a) == size(b) .and. all(transfer(a, [0_int64]) == transfer(b, [0_int64]))
    end function

    pure function same_bits_2(a, b) result(same)
        real(c_double), intent(in) :: a(:, :), b(:, :)
        logical :: same
        same = all(shape(a) == shape(b)) .and. all(transfer(a, [0_int64]) == transfer(b, [0_int64]))
    end function

    subroutine expect(condition, what)
        logical, intent(in) :: condition
        character(len=*), intent(in) :: what
        if (condition) return
        failures = failures + 1
        write (error_unit, '(2a)') 'failed: ', what
    end subroutine

    subroutine expect_status(status, wanted, what)
        integer(c_int), intent(in) :: status, wanted
        character(len=*), intent(in) :: what
        call expect(status == wanted, what//': '//vti_status_text(status))
    end subroutine

    !> Ends the program, with a failure if anything has failed.
    subroutine finish()
        if (failures > 0) stop 1
    end subroutine
end module
