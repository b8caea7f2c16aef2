! SPDX-License-Identifier: BSD-3-Clause
!
!> vti_effects -- what a scene calls for: forces, moments and energies, and the steps with them. Part of module vti;
!> bonds are in vti_effects_bonds, contacts, walls and clumps in vti_effects_contacts.
!>
!> An effect keeps the address of what it is the effect of (pendulum, bonds, ...), and that keeps the addresses of its
!> arrays: all of them have TARGET, stay where they are, and outlive the effect. Bodies in pairs count from 1.
!> The effect of a pointer to nothing is refused by vti_effects_check (VTI_E_NULL) and by all that ask it, and has
!> energy NaN.
module vti_effects
    use, intrinsic :: iso_c_binding, only: c_double, c_f_procpointer, c_funptr, c_int, c_int64_t, c_loc, c_null_ptr, &
        c_ptr
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
    public :: vti_pendulum_effect, vti_pendulum_potential, vti_pendulum_arm, vti_gravity_effect, vti_drag_effect

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
    !> VTI_E_MASS or VTI_E_INERTIA if a spring pulls bodies that have v and no mass, or turns bodies that have omega and
    !> neither inertia nor moments. VTI_E_SPRINGS if an effect does not report its springs: stable%effect is its number.
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

    ! ---- pendulum, gravity, drag ------------------------------------------------------------------------------------

    function vti_pendulum_effect(pendulum) result(effect)
        type(vti_pendulum), pointer, intent(in) :: pendulum
        type(vti_effect) :: effect
        if (associated(pendulum)) effect = c_pendulum_effect(c_loc(pendulum))
    end function

    !> U of a body whose arm R rho0 is arm.
    pure function vti_pendulum_potential(pendulum, arm) result(energy)
        type(vti_pendulum), intent(in) :: pendulum
        real(c_double), intent(in) :: arm(3)
        real(c_double) :: energy
        energy = -pendulum%weight*arm(3)
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
end module
