! SPDX-License-Identifier: BSD-3-Clause
!
!> vti_effects -- what a scene calls for: forces, moments and energies. Part of module vti.
!>
!> An effect keeps the address of what it is the effect of (pendulum, bonds, ...), and that keeps the addresses of its
!> arrays: all of them have TARGET, stay where they are, and outlive the effect. Bodies in pairs count from 1.
!>
!> Arrays of the wrong shape give a count of -1: vti_bonds_check refuses it, and its effect, like that of a pointer to
!> nothing, is refused by vti_effects_check (VTI_E_NULL) and by all that ask it, and has energy NaN.
module vti_effects
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_procpointer, c_funptr, c_int, c_int64_t, c_loc, &
        c_null_ptr, c_ptr
    use vti_c, only: vti_bodies_check
    use vti_c_effects
    use vti_steps, only: from_one, handle
    use vti_types
    implicit none
    private
    public :: vti_apply, vti_energy, vti_booked, vti_booked_of_body, vti_step_check, vti_stable_step, &
        vti_show_spring, vti_springs_none
    public :: vti_pairs_of_slice
    public :: vti_effects_check, vti_effects_begin, vti_effects_stage, vti_effects_finish
    public :: vti_effects_flow, vti_effects_carry, vti_effects_rupture
    public :: vti_pendulum_effect, vti_pendulum_arm, vti_gravity_effect, vti_drag_effect, &
        vti_dashpots_effect, vti_dashpots_zeta, vti_friction_effect, vti_history_add, vti_bond_dashpots_effect
    public :: vti_bonds_rest_now
    public :: vti_bonds_between, vti_bonds_rest, vti_bonds_check, vti_bonds_effect, vti_bonds_loads, vti_bonds_sum
    public :: vti_bonds_measure, vti_rupture_effect, vti_rupture_check, vti_rupture_take_out
    public :: vti_contacts_between, vti_contacts_check, vti_contacts_effect, vti_contacts_stiffness
    public :: vti_walls_at, vti_walls_effect, vti_walls_gap, vti_walls_stiffness
    public :: vti_clumps_of, vti_clumps_check, vti_clumps_spheres, vti_clumps_spread, vti_clumps_gather
    public :: vti_clumped_effect, vti_clump_solid

    abstract interface
        subroutine c_visit(context, spring) bind(c)
            import :: c_ptr, vti_spring
            type(c_ptr), value :: context
            type(vti_spring), intent(in) :: spring
        end subroutine
    end interface

contains

    ! ---- all of a scene ---------------------------------------------------------------------------------------------

    !> force = moment = 0 on the slice, then every effect in order.
    function vti_apply(effects, bodies) result(status)
        type(vti_effect), intent(in) :: effects(:)
        type(vti_bodies), intent(in) :: bodies
        integer(c_int) :: status
        status = c_apply(effects, size(effects, kind=c_int64_t), bodies)
    end function

    !> The numbers, from 1 and ascending, of those pairs of the list pair(2,:) that act on bodies of the slice
    !> first ... first + bodies - 1. A list of these alone, of bonds with their rest and stiffnesses or of contacts,
    !> gives that slice the loads of the whole list, to the bit. Of size 0 where pair has the wrong shape.
    function vti_pairs_of_slice(pair, first, bodies) result(which)
        integer(c_int64_t), contiguous, intent(in) :: pair(:, :)
        integer(c_int64_t), intent(in) :: first, bodies
        integer(c_int64_t), allocatable :: which(:)
        integer(c_int64_t) :: n
        allocate (which(size(pair, 2)))
        n = 0
        if (size(pair, 1) == 2) &
            n = c_pairs_of_slice(size(pair, 2, c_int64_t), pair, 1_c_int64_t, first - 1, bodies, which)
        which = which(:n) + 1
    end function

    !> Kinetic energies and all energies of the effects.
    function vti_energy(effects, bodies) result(energy)
        type(vti_effect), intent(in) :: effects(:)
        type(vti_bodies), intent(in) :: bodies
        real(c_double) :: energy
        energy = c_energy(effects, size(effects, kind=c_int64_t), bodies)
    end function

    !> Sum of all booked energies: with vti_energy, what is constant.
    function vti_booked(effects) result(energy)
        type(vti_effect), intent(in) :: effects(:)
        real(c_double) :: energy
        energy = c_booked(effects, size(effects, kind=c_int64_t))
    end function

    !> What of it body i, from 1, has lost: the sum over the effects whose by_body is the address of an array
    !> type(vti_sum) :: by_body(entries, bodies), zeros at the start, which goes up to i.
    function vti_booked_of_body(effects, i) result(energy)
        type(vti_effect), intent(in) :: effects(:)
        integer(c_int64_t), intent(in) :: i
        real(c_double) :: energy
        energy = c_booked_of_body(effects, size(effects, kind=c_int64_t), i - 1)
    end function

    !> Whether all of them may be used with the bodies. VTI_E_NEEDS, with fault%body the number of the effect and
    !> fault%quantity what is missing, if one needs what the bodies do not have.
    function vti_effects_check(effects, bodies, fault) result(status)
        type(vti_effect), intent(in) :: effects(:)
        type(vti_bodies), intent(in) :: bodies
        type(vti_fault), intent(out), optional :: fault
        integer(c_int) :: status
        type(vti_fault) :: found
        status = c_effects_check(effects, size(effects, kind=c_int64_t), bodies, found)
        if (present(fault)) fault = from_one(found)
    end function

    !> Once before a run: VTI_E_DISSIPATES if method has a negative coefficient and some effect dissipates, flows,
    !> carries or ruptures. vti_effects_begin asks it, vti_step_begin does not.
    function vti_step_check(method, effects) result(status)
        type(vti_stepper), intent(in), target :: method
        type(vti_effect), intent(in) :: effects(:)
        integer(c_int) :: status
        status = c_step_check(handle(method), effects, size(effects, kind=c_int64_t))
    end function

    ! ---- steps with effects that flow, carry or rupture --------------------------------------------------------------

    !> vti_step_begin with the effects' flows and carries. On VTI_E_TOO_LARGE the flow before the kick has been done.
    function vti_effects_begin(method, h, effects, bodies, fault) result(status)
        type(vti_stepper), intent(in), target :: method
        real(c_double), intent(in) :: h
        type(vti_effect), intent(in) :: effects(:)
        type(vti_bodies), intent(in) :: bodies
        type(vti_fault), intent(out), optional :: fault
        integer(c_int) :: status
        status = vti_effects_stage(method, 0_c_int64_t, h, effects, bodies, fault)
    end function

    !> vti_step_stage with them.
    function vti_effects_stage(method, k, h, effects, bodies, fault) result(status)
        type(vti_stepper), intent(in), target :: method
        integer(c_int64_t), intent(in) :: k
        real(c_double), intent(in) :: h
        type(vti_effect), intent(in) :: effects(:)
        type(vti_bodies), intent(in) :: bodies
        type(vti_fault), intent(out), optional :: fault
        integer(c_int) :: status
        type(vti_fault) :: found
        status = c_effects_stage(handle(method), k, h, effects, size(effects, kind=c_int64_t), bodies, found)
        if (present(fault)) fault = from_one(found)
    end function

    !> vti_step_finish with them.
    function vti_effects_finish(method, h, effects, bodies) result(status)
        type(vti_stepper), intent(in), target :: method
        real(c_double), intent(in) :: h
        type(vti_effect), intent(in) :: effects(:)
        type(vti_bodies), intent(in) :: bodies
        integer(c_int) :: status
        status = c_effects_finish(handle(method), h, effects, size(effects, kind=c_int64_t), bodies)
    end function

    !> What breaks at the end of a step; broken is how many, and where it is not 0 vti_apply comes before the next step.
    function vti_effects_rupture(effects, bodies, broken) result(status)
        type(vti_effect), intent(in) :: effects(:)
        type(vti_bodies), intent(in) :: bodies
        integer(c_int64_t), intent(inout) :: broken
        integer(c_int) :: status
        status = c_effects_rupture(effects, size(effects, kind=c_int64_t), bodies, broken)
    end function

    !> The flows of all effects for the time t >= 0 before a drift of that time, or after one of -drift.
    function vti_effects_flow(effects, t, drift, bodies) result(status)
        type(vti_effect), intent(in) :: effects(:)
        real(c_double), intent(in) :: t, drift
        type(vti_bodies), intent(in) :: bodies
        integer(c_int) :: status
        status = c_effects_flow(effects, size(effects, kind=c_int64_t), t, drift, bodies)
    end function

    !> Tells all effects that carry of a drift that has been done.
    function vti_effects_carry(effects, drifted, bodies) result(status)
        type(vti_effect), intent(in) :: effects(:)
        type(vti_drifted), intent(in) :: drifted
        type(vti_bodies), intent(in) :: bodies
        integer(c_int) :: status
        status = c_effects_carry(effects, size(effects, kind=c_int64_t), drifted, bodies)
    end function

    ! ---- the stable step ---------------------------------------------------------------------------------------------

    !> A step that is stable for every stepper whose limit is h < 2/omega_max, while nothing is deformed by more than
    !> `at`, or where the bodies are. scratch has room for the bodies of the slice, which are all that the springs name.
    !> VTI_E_SPRINGS if an effect does not report its springs: stable%effect is its number.
    function vti_stable_step(effects, bodies, scratch, stable, at) result(status)
        type(vti_effect), intent(in) :: effects(:)
        type(vti_bodies), intent(in) :: bodies
        real(c_double), intent(inout), contiguous :: scratch(:)
        type(vti_stable), intent(inout) :: stable
        type(vti_deformation), intent(in), target, optional :: at
        integer(c_int) :: status
        type(c_ptr) :: place
        place = c_null_ptr
        if (present(at)) place = c_loc(at)
        status = VTI_E_COUNT
        if (size(scratch, kind=c_int64_t) < bodies%count) return
        status = c_stable_step(effects, size(effects, kind=c_int64_t), bodies, place, scratch, stable)
        if (status /= VTI_OK .and. status /= VTI_E_SPRINGS) return
        stable%effect = stable%effect + 1
        stable%element = stable%element + 1
        stable%i = stable%i + 1
        stable%j = stable%j + 1
    end function

    !> What the springs of a host's own effect call for each of them, with the visit and context that they were given.
    subroutine vti_show_spring(visit, context, spring)
        type(c_funptr), intent(in) :: visit
        type(c_ptr), intent(in) :: context
        type(vti_spring), intent(in) :: spring
        type(vti_spring) :: from_zero
        procedure(c_visit), pointer :: show
        from_zero = spring
        from_zero%element = spring%element - 1
        from_zero%i = spring%i - 1
        from_zero%j = spring%j - 1
        call c_f_procpointer(visit, show)
        call show(context, from_zero)
    end subroutine

    ! ---- pendulum, gravity, drag, dashpots, friction ---------------------------------------------------------------

    function vti_pendulum_effect(pendulum) result(effect)
        type(vti_pendulum), pointer, intent(in) :: pendulum
        type(vti_effect) :: effect
        if (associated(pendulum)) effect = c_pendulum_effect(c_loc(pendulum))
    end function

    !> arm = R rho0 of body i, which counts from 1, in the inertial frame.
    subroutine vti_pendulum_arm(pendulum, bodies, i, arm)
        type(vti_pendulum), intent(in) :: pendulum
        type(vti_bodies), intent(in) :: bodies
        integer(c_int64_t), intent(in) :: i
        real(c_double), intent(out) :: arm(3)
        call c_pendulum_arm(pendulum, bodies, i - 1, arm)
    end subroutine

    function vti_gravity_effect(gravity) result(effect)
        type(vti_gravity), pointer, intent(in) :: gravity
        type(vti_effect) :: effect
        if (associated(gravity)) effect = c_gravity_effect(c_loc(gravity))
    end function

    function vti_drag_effect(drag) result(effect)
        type(vti_drag), pointer, intent(in) :: drag
        type(vti_effect) :: effect
        if (associated(drag)) effect = c_drag_effect(c_loc(drag))
    end function

    function vti_dashpots_effect(dashpots) result(effect)
        type(vti_dashpots), pointer, intent(in) :: dashpots
        type(vti_effect) :: effect
        if (associated(dashpots)) effect = c_dashpots_effect(c_loc(dashpots))
    end function

    function vti_friction_effect(friction) result(effect)
        type(vti_friction), pointer, intent(in) :: friction
        type(vti_effect) :: effect
        if (associated(friction)) effect = c_friction_effect(c_loc(friction))
    end function

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

    ! ---- contacts and walls ------------------------------------------------------------------------------------------

    !> Contacts between the bodies pair(1,k) and pair(2,k), of which some may not touch: of one stiffness, an energy,
    !> for all, or of the bodies' modulus E/(1 - nu^2). length is the distance at which each pair begins to touch,
    !> (D_i + D_j)/2 where it is absent.
    function vti_contacts_between(pair, diameter, stiffness, modulus, length) result(contacts)
        integer(c_int64_t), pointer, contiguous, intent(in) :: pair(:, :)
        type(vti_scalars), intent(in) :: diameter
        real(c_double), intent(in), optional :: stiffness
        type(vti_scalars), intent(in), optional :: modulus, length
        type(vti_contacts) :: contacts
        contacts%diameter = diameter
        if (present(stiffness)) contacts%stiffness = stiffness
        if (present(modulus)) contacts%modulus = modulus
        if (present(length)) contacts%length = length
        contacts%count = -1
        if (.not. associated(pair)) return
        if (size(pair, 1) /= 2) return
        contacts%count = size(pair, 2, c_int64_t)
        if (contacts%count > 0) contacts%pair = c_loc(pair)
    end function

    !> When the list has changed: every pair names two different bodies of the n that exist, diameters, moduli and
    !> lengths are finite and > 0 and as many as are needed, and the stiffness is finite and >= 0, or 0 with a modulus.
    !> VTI_E_CONTACT, with fault%body the number of the pair (from 1; 0 for the stiffness).
    function vti_contacts_check(contacts, n, fault) result(status)
        type(vti_contacts), intent(in) :: contacts
        integer(c_int64_t), intent(in) :: n
        type(vti_fault), intent(out), optional :: fault
        integer(c_int) :: status
        type(vti_fault) :: found
        status = c_contacts_check(contacts, n, found)
        if (present(fault)) fault = from_one(found)
    end function

    !> K of pair k; NaN if there is none.
    function vti_contacts_stiffness(contacts, k) result(stiffness)
        type(vti_contacts), intent(in) :: contacts
        integer(c_int64_t), intent(in) :: k
        real(c_double) :: stiffness
        stiffness = c_contacts_stiffness(contacts, k - 1)
    end function

    !> The effect; the list of contacts may change between steps.
    function vti_contacts_effect(contacts) result(effect)
        type(vti_contacts), pointer, intent(in) :: contacts
        type(vti_effect) :: effect
        if (.not. associated(contacts)) return
        if (contacts%count >= 0 .and. c_associated(contacts%diameter%p)) effect = c_contacts_effect(c_loc(contacts))
    end function

    !> Planes with the unit normal plane(1:3,k), towards the bodies, and the offset plane(4,k).
    function vti_walls_at(plane, diameter, stiffness) result(walls)
        real(c_double), pointer, contiguous, intent(in) :: plane(:, :)
        type(vti_scalars), intent(in) :: diameter
        real(c_double), intent(in) :: stiffness
        type(vti_walls) :: walls
        walls%diameter = diameter
        walls%stiffness = stiffness
        walls%count = -1
        if (.not. associated(plane)) return
        if (size(plane, 1) /= 4) return
        walls%count = size(plane, 2, c_int64_t)
        if (walls%count > 0) walls%plane = c_loc(plane)
    end function

    function vti_walls_effect(walls) result(effect)
        type(vti_walls), pointer, intent(in) :: walls
        type(vti_effect) :: effect
        if (.not. associated(walls)) return
        if (walls%count >= 0 .and. c_associated(walls%diameter%p)) effect = c_walls_effect(c_loc(walls))
    end function

    !> K of body i at wall w, both from 1; NaN if there is no such wall.
    function vti_walls_stiffness(walls, w, i) result(stiffness)
        type(vti_walls), pointer, intent(in) :: walls
        integer(c_int64_t), intent(in) :: w, i
        real(c_double) :: stiffness
        type(c_ptr) :: p
        p = c_null_ptr
        if (associated(walls)) p = c_loc(walls)
        stiffness = c_walls_stiffness(p, w - 1_c_int64_t, i - 1_c_int64_t)
    end function

    !> The distance of the place x from wall w, from 1, where it is now, and in n the unit normal there; NaN, and n = 0,
    !> if there is no such wall.
    function vti_walls_gap(walls, w, x, n) result(gap)
        type(vti_walls), pointer, intent(in) :: walls
        integer(c_int64_t), intent(in) :: w
        real(c_double), intent(in) :: x(3)
        real(c_double), intent(out) :: n(3)
        real(c_double) :: gap
        type(c_ptr) :: p
        n = 0
        p = c_null_ptr
        if (associated(walls)) p = c_loc(walls)
        gap = c_walls_gap(p, w - 1_c_int64_t, x, n)
    end function

    ! ---- clumps ------------------------------------------------------------------------------------------------------

    !> Spheres at offset(3,s) in the bodies body(s), which ascend from 1; spheres shows them as bodies of their own.
    function vti_clumps_of(body, offset, spheres) result(clumps)
        integer(c_int64_t), pointer, contiguous, intent(in) :: body(:)
        real(c_double), pointer, contiguous, intent(in) :: offset(:, :)
        type(vti_bodies), intent(in) :: spheres
        type(vti_clumps) :: clumps
        clumps%spheres = spheres
        clumps%count = -1
        if (.not. (associated(body) .and. associated(offset))) return
        if (size(offset, 1) /= 3 .or. size(offset, 2) /= size(body)) return
        clumps%count = size(body, kind=c_int64_t)
        if (clumps%count == 0) return
        clumps%body = c_loc(body)
        clumps%offset = c_loc(offset)
    end function

    !> When the list has changed: every sphere belongs to one of the n bodies, the list ascends, offsets are finite.
    !> VTI_E_CLUMP, with fault%body the number of the sphere (from 1) and fault%value what is wrong.
    function vti_clumps_check(clumps, n, fault) result(status)
        type(vti_clumps), intent(in) :: clumps
        integer(c_int64_t), intent(in) :: n
        type(vti_fault), intent(out), optional :: fault
        integer(c_int) :: status
        type(vti_fault) :: found
        status = c_clumps_check(clumps, n, found)
        if (present(fault)) fault = from_one(found)
    end function

    !> Mass, centre and moments of spheres centre(3,s), diameter(s) of one density, counted once where they overlap:
    !> exact if none do, else along lines x lines lines. Errors as in C, VTI_E_COUNT also for another shape; fault%body
    !> is the sphere, from 1.
    function vti_clump_solid(centre, diameter, density, lines, solid, fault) result(status)
        real(c_double), contiguous, intent(in) :: centre(:, :), diameter(:)
        real(c_double), intent(in) :: density
        integer(c_int64_t), intent(in) :: lines
        type(vti_solid), intent(inout) :: solid
        type(vti_fault), intent(out), optional :: fault
        integer(c_int) :: status
        type(vti_fault) :: found
        if (present(fault)) fault = vti_fault()
        status = VTI_E_COUNT
        if (size(centre, 1) /= 3 .or. size(centre, 2) /= size(diameter)) return
        status = c_clump_solid(size(diameter, kind=c_int64_t), centre, diameter, density, lines, solid, found)
        if (present(fault)) fault = from_one(found)
    end function

    !> The effect on the bodies that an effect on the spheres of their clumps is.
    function vti_clumped_effect(clumped) result(effect)
        type(vti_clumped), pointer, intent(in) :: clumped
        type(vti_effect) :: effect
        if (associated(clumped)) effect = c_clumped_effect(c_loc(clumped))
    end function
end module
