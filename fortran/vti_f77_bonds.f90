! SPDX-License-Identifier: BSD-3-Clause
!
!> vti_f77_bonds -- bonds for vti_f77.f90: pairs are default integers there, and are handed on in parts.
module vti_f77_bonds
    use, intrinsic :: iso_c_binding, only: c_double, c_f_procpointer, c_int, c_int64_t, c_loc, c_ptr
    use vti
    use vti_f77_arrays, only: view_of
    implicit none
    private
    public :: arrays_rest, arrays_bonds, arrays_bond_energies

    integer, parameter :: room = 256

    abstract interface
        subroutine apply_of(self, bodies) bind(c)
            import :: c_ptr, vti_bodies
            type(c_ptr), value :: self
            type(vti_bodies), intent(in) :: bodies
        end subroutine
        subroutine energy_of(self, bodies, energies) bind(c)
            import :: c_double, c_ptr, vti_bodies
            type(c_ptr), value :: self
            type(vti_bodies), intent(in) :: bodies
            real(c_double), intent(inout) :: energies(*)
        end subroutine
    end interface

contains

    !> The first bond that is not between two different bodies of n, 0 if there is none.
    pure function bad_pair(nb, ipair, n) result(k)
        integer, intent(in) :: nb, n
        integer, intent(in) :: ipair(2, nb)
        integer :: k
        do k = 1, nb
            if (minval(ipair(:, k)) < 1 .or. maxval(ipair(:, k)) > n .or. ipair(1, k) == ipair(2, k)) return
        end do
        k = 0
    end function

    subroutine arrays_rest(nb, ipair, n, lb, lc, x, rest, fault, status)
        integer, intent(in) :: nb, ipair(2, *), n, lb, lc
        real(c_double), intent(in), target :: x(*)
        real(c_double), intent(inout) :: rest(4, *)
        type(vti_fault), intent(out) :: fault
        integer(c_int), intent(out) :: status
        type(vti_bodies) :: bodies
        real(c_double) :: found(4, 1)
        integer :: k, writes
        status = VTI_E_COUNT
        if (nb < 0) return
        bodies%count = n
        bodies%x = view_of(n, lb, lc, x)
        status = vti_bodies_check(bodies)
        if (status /= VTI_OK) return
        do writes = 0, 1 ! all are looked at before one is written
            do k = 1, nb
                status = vti_bonds_rest(int(ipair(:, k:k), c_int64_t), bodies, found, fault)
                if (status /= VTI_OK) fault%body = k
                if (status /= VTI_OK) return
                if (writes == 1) rest(:, k) = found(:, 1)
            end do
        end do
    end subroutine

    !> What can be wrong with a list of bonds, before anything is touched; k is the bond that is refused.
    subroutine check(nb, ipair, n, sk, iform, bodies, k, status)
        integer, intent(in) :: nb, ipair(2, *), n, iform
        real(c_double), intent(in) :: sk(3)
        type(vti_bodies), intent(in) :: bodies
        integer, intent(out) :: k
        integer(c_int), intent(out) :: status
        k = 0
        status = VTI_E_COUNT
        if (nb < 0) return
        status = vti_bodies_check(bodies)
        if (status /= VTI_OK) return
        k = bad_pair(nb, ipair, n)
        if (k > 0 .or. .not. all(sk >= 0 .and. sk <= huge(sk))) status = VTI_E_BOND
        if (iform < VTI_SHEAR_OBJECTIVE .or. iform > VTI_SHEAR_PRINTED) status = VTI_E_BOND
    end subroutine

    !> Bonds first ... last of the list, with the terms whose K is not 0; pair is theirs.
    function part(first, last, ipair, rest, sk, iform, pair) result(bonds)
        integer, intent(in) :: first, last, ipair(2, *), iform
        real(c_double), intent(in), target :: rest(4, *), sk(3)
        integer(c_int64_t), intent(inout), target :: pair(2, room)
        type(vti_bonds) :: bonds
        bonds%count = last - first + 1
        pair(:, :bonds%count) = ipair(:, first:last)
        bonds%pair = c_loc(pair)
        bonds%rest = c_loc(rest(1, first))
        if (sk(1) > 0) bonds%moment%p = c_loc(sk(1))
        if (sk(2) > 0) bonds%axial%p = c_loc(sk(2))
        if (sk(3) > 0) bonds%shear%p = c_loc(sk(3))
        bonds%shear_form = iform
    end function

    !> Adds forces to f and moments to t. Parts in order add what the whole adds, in the same order: the same bits.
    subroutine arrays_bonds(nb, ipair, rest, sk, iform, n, lb, lc, x, a, f, t, k, status)
        integer, intent(in) :: nb, ipair(2, *), iform, n, lb, lc
        real(c_double), intent(in), target :: rest(4, *), sk(3), x(*), a(*)
        real(c_double), intent(inout), target :: f(*), t(*)
        integer, intent(out) :: k
        integer(c_int), intent(out) :: status
        type(vti_bodies) :: bodies
        type(vti_bonds), target :: bonds
        type(vti_effect) :: effect
        integer(c_int64_t), target :: pair(2, room)
        procedure(apply_of), pointer :: apply
        integer :: first
        bodies%count = n
        bodies%x = view_of(n, lb, lc, x)
        bodies%alpha = view_of(n, lb, lc, a)
        bodies%force = view_of(n, lb, lc, f)
        bodies%moment = view_of(n, lb, lc, t)
        call check(nb, ipair, n, sk, iform, bodies, k, status)
        if (status /= VTI_OK) return
        do first = 1, nb, room
            bonds = part(first, min(first + room - 1, nb), ipair, rest, sk, iform, pair)
            effect = vti_bonds_effect(bonds)
            call c_f_procpointer(effect%apply, apply)
            call apply(effect%self, bodies)
        end do
    end subroutine

    !> Energies of the moment, axial and shear terms; sums of the parts' sums, so equal to C's up to rounding.
    subroutine arrays_bond_energies(nb, ipair, rest, sk, iform, n, lb, lc, x, a, energies, k, status)
        integer, intent(in) :: nb, ipair(2, *), iform, n, lb, lc
        real(c_double), intent(in), target :: rest(4, *), sk(3), x(*), a(*)
        real(c_double), intent(out) :: energies(3)
        integer, intent(out) :: k
        integer(c_int), intent(out) :: status
        type(vti_bodies) :: bodies
        type(vti_bonds), target :: bonds
        type(vti_effect) :: effect
        type(vti_sum) :: sums(3)
        integer(c_int64_t), target :: pair(2, room)
        procedure(energy_of), pointer :: energy
        real(c_double) :: present_terms(3), found(3)
        integer :: first, c
        energies = 0
        bodies%count = n
        bodies%x = view_of(n, lb, lc, x)
        bodies%alpha = view_of(n, lb, lc, a)
        call check(nb, ipair, n, sk, iform, bodies, k, status)
        if (status /= VTI_OK) return
        do first = 1, nb, room
            bonds = part(first, min(first + room - 1, nb), ipair, rest, sk, iform, pair)
            effect = vti_bonds_effect(bonds)
            call c_f_procpointer(effect%energy, energy)
            call energy(effect%self, bodies, present_terms)
            found = unpack(present_terms, sk > 0, spread(0.0_c_double, 1, 3))
            do c = 1, 3
                call vti_sum_add(sums(c), found(c))
            end do
        end do
        energies = [(vti_sum_value(sums(c)), c=1, 3)]
    end subroutine
end module
