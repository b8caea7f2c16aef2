! SPDX-License-Identifier: BSD-3-Clause
!> Bonded spheres on a lattice, for the tests of effects: a chain, and a block with more bonds than the layer for codes
!> without modules hands on at once. No two spheres are alike; some touch each other and the walls of shim_lattice.c.
module lattice
    use, intrinsic :: iso_c_binding, only: c_char, c_double, c_int, c_int64_t, c_null_char
    use common, only: expect, expect_status, number, same_bits
    use vti
    implicit none

    integer(c_int64_t), parameter :: steps = 1000
    real(c_double), parameter :: h = 1.0_c_double/512
    real(c_double), parameter :: bond_energy(3) = [10.0_c_double, 200.0_c_double, 150.0_c_double]

    type :: crowd
        real(c_double), allocatable :: x(:, :), v(:, :), alpha(:, :), omega(:, :), mass(:), inertia(:), diameter(:)
        real(c_double), allocatable :: rest(:, :)
        integer(c_int64_t), allocatable :: pair(:, :)
        real(c_double) :: results(4) = 0
    end type

    interface
        function shim_lattice(name, h, steps, n, x, v, alpha, omega, mass, inertia, diameter, bonds, pair, rest, &
            effects, results) result(status) bind(c)
            import :: c_char, c_double, c_int, c_int64_t
            character(kind=c_char), intent(in) :: name(*)
            real(c_double), value :: h
            integer(c_int64_t), value :: steps, n, bonds, effects
            real(c_double), intent(inout) :: x(3, *), v(3, *), alpha(3, *), omega(3, *), rest(4, *)
            real(c_double), intent(in) :: mass(*), inertia(*), diameter(*)
            integer(c_int64_t), intent(in) :: pair(2, *)
            real(c_double), intent(out) :: results(4)
            integer(c_int) :: status
        end function
    end interface

contains

    !> counts(1) x counts(2) x counts(3) spheres, neighbours along the axes bonded.
    function new_crowd(counts) result(c)
        integer, intent(in) :: counts(3)
        type(crowd) :: c
        integer :: i, n, stride(3), axis, place(3), bonds
        n = product(counts)
        stride = [1, counts(1), counts(1)*counts(2)]
        allocate (c%x(3, n), c%v(3, n), c%alpha(3, n), c%omega(3, n), c%mass(n), c%inertia(n), c%diameter(n))
        allocate (c%pair(2, 3*n))
        bonds = 0
        do i = 1, n
            place = [mod(i - 1, stride(2)), mod(i - 1, stride(3))/stride(2), (i - 1)/stride(3)]
            c%x(:, i) = place + [number(9*i), number(9*i + 1), number(9*i + 2)]/32
            c%v(:, i) = [number(9*i + 3), number(9*i + 4), number(9*i + 5)]/4
            c%alpha(:, i) = 0
            c%omega(:, i) = [number(9*i + 6), number(9*i + 7), number(9*i + 8)]
            c%mass(i) = 1 + number(i)/4
            c%inertia(i) = 0.2_c_double + number(2*i)/16
            c%diameter(i) = 1 + number(3*i)/16
            do axis = 1, 3
                if (place(axis) + 1 == counts(axis)) cycle
                bonds = bonds + 1
                c%pair(:, bonds) = [i, i + stride(axis)]
            end do
        end do
        c%pair = c%pair(:, :bonds)
        allocate (c%rest(4, bonds), source=0.0_c_double)
    end function

    !> The crowd after the run in C with the first so many of its effects.
    function run_in_c(name, counts, effects) result(c)
        character(len=*), intent(in) :: name
        integer, intent(in) :: counts(3), effects
        type(crowd) :: c
        c = new_crowd(counts)
        call expect_status(shim_lattice(name//c_null_char, h, steps, size(c%x, 2, c_int64_t), c%x, c%v, c%alpha, &
            c%omega, &
            c%mass, c%inertia, c%diameter, size(c%pair, 2, c_int64_t), c%pair, c%rest, int(effects, c_int64_t), &
            c%results), VTI_OK, 'the run in C')
        call expect(all(abs(c%x) < 1e3_c_double), name//': the run in C stays in place')
    end function

    subroutine compare(c, x, v, alpha, omega, rest, what)
        type(crowd), intent(in) :: c
        real(c_double), intent(in) :: x(:, :), v(:, :), alpha(:, :), omega(:, :), rest(:, :)
        character(len=*), intent(in) :: what
        call expect(same_bits(x, c%x), what//', x')
        call expect(same_bits(v, c%v), what//', v')
        call expect(same_bits(alpha, c%alpha), what//', alpha')
        call expect(same_bits(omega, c%omega), what//', omega')
        call expect(same_bits(rest, c%rest), what//', rest')
    end subroutine
end module
