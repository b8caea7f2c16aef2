! SPDX-License-Identifier: BSD-3-Clause
!
!> vti_effects_bonds -- bonds, what breaks them, their dashpots. Part of module vti.
!>
!> As in vti_effects what an effect points to has TARGET, stays where it is, and outlives it; bodies in pairs count from
!> 1. Arrays of the wrong shape give a count of -1: vti_bonds_check refuses it, and its effect as it does one of
!> nothing.
module vti_effects_bonds
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_int, c_int64_t, c_loc
    use vti_c, only: vti_bodies_check
    use vti_c_bonds
    use vti_steps, only: from_one
    use vti_types
    implicit none
    private
    public :: vti_bonds_between, vti_bonds_rest, vti_bonds_rest_now, vti_bonds_check, vti_bonds_effect
    public :: vti_bonds_loads, vti_bonds_sum, vti_bonds_measure
    public :: vti_rupture_effect, vti_rupture_check, vti_rupture_take_out, vti_bond_dashpots_effect

contains

    ! ---- bonds -------------------------------------------------------------------------------------------------------

    !> Bonds between the bodies pair(1,k) and pair(2,k), at rest as rest(4,k) and, if it is given, turn(4,k) say, still
    !> without stiffnesses.
    function vti_bonds_between(pair, rest, turn) result(bonds)
        integer(c_int64_t), pointer, contiguous, intent(in) :: pair(:, :)
        real(c_double), pointer, contiguous, intent(in) :: rest(:, :)
        real(c_double), pointer, contiguous, intent(in), optional :: turn(:, :)
        type(vti_bonds) :: bonds
        bonds%count = -1
        if (.not. (associated(pair) .and. associated(rest))) return
        if (size(pair, 1) /= 2 .or. size(rest, 1) /= 4 .or. size(rest, 2) /= size(pair, 2)) return
        if (present(turn)) then
            if (.not. associated(turn)) return
            if (size(turn, 1) /= 4 .or. size(turn, 2) /= size(pair, 2)) return
            if (size(pair, 2) > 0) bonds%turn = c_loc(turn)
        end if
        bonds%count = size(pair, 2, c_int64_t)
        if (bonds%count == 0) return
        bonds%pair = c_loc(pair)
        bonds%rest = c_loc(rest)
    end function

    !> rest(4,k), n0 and L0, of the pairs at the positions of bodies. VTI_E_BOND, with fault%body the number of the bond
    !> (from 1) and fault%value what is wrong, if a body does not exist or two coincide; rest is then of no use.
    function vti_bonds_rest(pair, bodies, rest, fault) result(status)
        integer(c_int64_t), intent(in), contiguous :: pair(:, :)
        type(vti_bodies), intent(in) :: bodies
        real(c_double), intent(inout), contiguous :: rest(:, :)
        type(vti_fault), intent(out), optional :: fault
        integer(c_int) :: status
        integer(c_int64_t) :: k, body
        type(vti_fault) :: found
        type(vti_bodies) :: centres
        if (present(fault)) fault = vti_fault()
        status = VTI_E_COUNT
        if (size(pair, 1) /= 2 .or. size(rest, 1) /= 4 .or. size(rest, 2) /= size(pair, 2)) return
        status = VTI_OK
        if (size(pair, 2) == 0) return ! arrays of no bodies are absent views
        centres = vti_bodies(abi=bodies%abi, first=bodies%first, count=bodies%count, x=bodies%x)
        status = vti_bodies_check(centres)
        if (.not. all([(c_associated(bodies%x%c(k)), k=1, 3)])) status = VTI_E_VIEW
        if (present(fault) .and. any(status == [VTI_E_VIEW, VTI_E_STRIDE, VTI_E_ALIAS])) fault%quantity = VTI_QUANTITY_X
        if (status /= VTI_OK) return
        do k = 1, size(pair, 2, c_int64_t)
            body = maxval(pair(:, k))
            if (minval(pair(:, k)) < 1) body = minval(pair(:, k))
            status = VTI_E_BOND
            if (present(fault)) fault = vti_fault(k, real(body, c_double))
            if (body < 1 .or. body > bodies%first + bodies%count) return
        end do
        status = c_bonds_rest(size(pair, 2, c_int64_t), pair, 1_c_int64_t, bodies%x, rest, found)
        if (present(fault)) fault = from_one(found)
    end function

    !> rest(4,k) and turn(4,k) of pairs that are to be at rest where the bodies are now, turned as they are. Errors as
    !> those of vti_bonds_rest; nothing has been written then.
    function vti_bonds_rest_now(pair, bodies, rest, turn, fault) result(status)
        integer(c_int64_t), intent(in), contiguous :: pair(:, :)
        type(vti_bodies), intent(in) :: bodies
        real(c_double), intent(inout), contiguous :: rest(:, :), turn(:, :)
        type(vti_fault), intent(out), optional :: fault
        integer(c_int) :: status
        type(vti_fault) :: found
        if (present(fault)) fault = vti_fault()
        status = VTI_E_COUNT
        if (size(pair, 1) /= 2 .or. size(rest, 1) /= 4 .or. size(rest, 2) /= size(pair, 2)) return
        if (size(turn, 1) /= 4 .or. size(turn, 2) /= size(pair, 2)) return
        status = c_bonds_rest_now(size(pair, 2, c_int64_t), pair, 1_c_int64_t, bodies, rest, turn, found)
        if (present(fault)) fault = from_one(found)
    end function

    !> Once before use: every pair names two different bodies of the n that exist, L0 > 0, |n0| = |Q0| = 1, stiffnesses
    !> finite and >= 0. VTI_E_BOND, with fault%body the number of the bond (from 1) and fault%value what is wrong.
    function vti_bonds_check(bonds, n, fault) result(status)
        type(vti_bonds), intent(in) :: bonds
        integer(c_int64_t), intent(in) :: n
        type(vti_fault), intent(out), optional :: fault
        integer(c_int) :: status
        type(vti_fault) :: found
        status = c_bonds_check(bonds, n, found)
        if (present(fault)) fault = from_one(found)
    end function

    !> The effect of the bonds in two passes that threads can share, with its bits: here the loads of the bonds first to
    !> last (from 1), each thread those of its own range. Errors as in C, VTI_E_COUNT also unless loads is
    !> (VTI_BOND_LOADS, last - first + 1).
    function vti_bonds_loads(bonds, bodies, first, last, loads) result(status)
        type(vti_bonds), intent(in) :: bonds
        type(vti_bodies), intent(in) :: bodies
        integer(c_int64_t), intent(in) :: first, last
        real(c_double), contiguous, intent(inout) :: loads(:, :)
        integer(c_int) :: status
        status = VTI_E_COUNT
        if (size(loads, 1) /= VTI_BOND_LOADS .or. size(loads, 2, c_int64_t) /= last - first + 1) return
        status = c_bonds_loads(bonds, bodies, first - 1, last, loads)
    end function

    !> The other pass: adds loads(VTI_BOND_LOADS, last - first + 1) of the bonds first to last to force and moment of
    !> those of their bodies that are in the slice. No two threads may sum for the same body.
    function vti_bonds_sum(bonds, loads, first, last, bodies) result(status)
        type(vti_bonds), intent(in) :: bonds
        real(c_double), contiguous, intent(in) :: loads(:, :)
        integer(c_int64_t), intent(in) :: first, last
        type(vti_bodies), intent(in) :: bodies
        integer(c_int) :: status
        status = VTI_E_COUNT
        if (size(loads, 1) /= VTI_BOND_LOADS .or. size(loads, 2, c_int64_t) /= last - first + 1) return
        status = c_bonds_sum(bonds, loads, first - 1, last, bodies)
    end function

    !> What the springs of the bonds first to last (from 1) hold: measures(VTI_BOND_MEASURES, last - first + 1), with N
    !> in row VTI_BOND_NORMAL + 1, and so on for VTI_BOND_ACROSS, VTI_BOND_BENDING, VTI_BOND_TORSION, VTI_BOND_ENERGY
    !> and VTI_BOND_STRETCH. VTI_E_COUNT for another shape.
    function vti_bonds_measure(bonds, bodies, first, last, measures) result(status)
        type(vti_bonds), intent(in) :: bonds
        type(vti_bodies), intent(in) :: bodies
        integer(c_int64_t), intent(in) :: first, last
        real(c_double), contiguous, intent(inout) :: measures(:, :)
        integer(c_int) :: status
        status = VTI_E_COUNT
        if (size(measures, 1) /= VTI_BOND_MEASURES .or. size(measures, 2, c_int64_t) /= last - first + 1) return
        status = c_bonds_measure(bonds, bodies, first - 1, last, measures)
    end function

    function vti_bonds_effect(bonds) result(effect)
        type(vti_bonds), pointer, intent(in) :: bonds
        type(vti_effect) :: effect
        if (.not. associated(bonds)) return
        if (bonds%count >= 0) effect = c_bonds_effect(c_loc(bonds))
    end function

    ! ---- what breaks and damps them ---------------------------------------------------------------------------------

    function vti_rupture_effect(rupture) result(effect)
        type(vti_rupture), pointer, intent(in) :: rupture
        type(vti_effect) :: effect
        if (associated(rupture)) effect = c_rupture_effect(c_loc(rupture))
    end function

    !> Once before use, after vti_bonds_check: numbers ascend from 1, every limit is > 0. VTI_E_BOND, with fault%body
    !> the place of the bond (from 1) and fault%value what is wrong.
    function vti_rupture_check(rupture, fault) result(status)
        type(vti_rupture), intent(in) :: rupture
        type(vti_fault), intent(out), optional :: fault
        integer(c_int) :: status
        type(vti_fault) :: found
        status = c_rupture_check(rupture, found)
        if (present(fault)) fault = from_one(found)
    end function

    !> Takes the bonds of these numbers, which ascend, out of the list, and books nothing. VTI_E_BOND where one is not
    !> in it.
    function vti_rupture_take_out(rupture, id) result(status)
        type(vti_rupture), intent(in) :: rupture
        integer(c_int64_t), contiguous, intent(in) :: id(:)
        integer(c_int) :: status
        status = c_rupture_take_out(rupture, size(id, kind=c_int64_t), id)
    end function

    function vti_bond_dashpots_effect(dashpots) result(effect)
        type(vti_bond_dashpots), pointer, intent(in) :: dashpots
        type(vti_effect) :: effect
        if (associated(dashpots)) effect = c_bond_dashpots_effect(c_loc(dashpots))
    end function
end module
