! SPDX-License-Identifier: BSD-3-Clause
!> test_misuse.c from Fortran: every way to spoil bodies through every procedure that takes them, times that are none, lists
!> that are not there. A status with a text where there is one, no number where there is none, nothing written, no crash.
program test_fortran_misuse
    use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_is_nan, ieee_negative_inf, ieee_positive_inf, &
        ieee_quiet_nan, ieee_value
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_loc, c_null_ptr
    use common
    implicit none

    real(c_double), parameter :: h = 1.0_c_double/64
    type(state), target :: s
    type(state) :: before
    real(c_double), target :: force(3, n), moment(3, n), low(3, n), other(3, n), value, rest(4, 1), plane(4, 1), diameter(n)
    integer(c_int64_t), target :: pair(2, 1)
    type(vti_bonds), target :: bonds
    type(vti_contacts), target :: contacts
    type(vti_walls), target :: walls
    type(vti_gravity), target :: gravity
    type(vti_pendulum), target :: pendulum
    type(vti_effect) :: effects(5)
    type(vti_bodies) :: good, b
    type(vti_stepper) :: vti2, chin4

    s = initial()
    before = s
    force = 0.5_c_double
    moment = 0.25_c_double
    low = 0
    other = 0
    value = 1
    diameter = 1.5_c_double
    pair(:, 1) = [1, 2]
    plane(:, 1) = [0, 0, 1, 0]
    good = vti_bodies_none(n)
    good%x = vti_view_columns(s%x)
    good%v = vti_view_columns(s%v)
    good%force = vti_view_columns(force)
    good%alpha = vti_view_columns(s%alpha)
    good%omega = vti_view_columns(s%omega)
    good%moment = vti_view_columns(moment)
    good%x_low = vti_view_columns(low)
    good%mass = vti_scalars_array(s%mass)
    good%inertia = vti_scalars_array(s%inertia)
    vti2 = vti_stepper_find('vti2')
    chin4 = vti_stepper_find('chin4')
    call expect_status(vti_bonds_rest(pair, good, rest), VTI_OK, 'rest')
    bonds = vti_bonds_between(pair, rest)
    bonds%moment = vti_scalars_one(value)
    bonds%axial = vti_scalars_one(value)
    bonds%shear = vti_scalars_one(value)
    contacts = vti_contacts_between(pair, vti_scalars_array(diameter), 1.0_c_double)
    walls = vti_walls_at(plane, vti_scalars_array(diameter), 1.0_c_double)
    effects = [vti_bonds_effect(bonds), vti_contacts_effect(contacts), vti_walls_effect(walls), &
        vti_gravity_effect(gravity), vti_pendulum_effect(pendulum)]

    call counts_and_versions()
    call views()
    call masses()
    call times()
    call lists()
    call finish()

contains

    subroutine counts_and_versions()
        b = good
        b%abi = VTI_ABI + 1
        call refused(VTI_E_ABI, VTI_QUANTITY_NONE, 'a module of another version')
        b = vti_bodies_slice(good, 1_c_int64_t, -1_c_int64_t)
        call refused(VTI_E_COUNT, VTI_QUANTITY_NONE, 'fewer bodies than none')
        b = vti_bodies_slice(good, 0_c_int64_t, 2_c_int64_t)
        call refused(VTI_E_COUNT, VTI_QUANTITY_NONE, 'a slice from body 0')
        b = vti_bodies_slice(good, huge(n), 2_c_int64_t)
        call refused(VTI_E_COUNT, VTI_QUANTITY_NONE, 'a slice that ends nowhere')
    end subroutine

    !> View k of the bodies.
    function view(bodies, k) result(p)
        type(vti_bodies), intent(inout), target :: bodies
        integer, intent(in) :: k
        type(vti_view), pointer :: p
        select case (k)
        case (1)
            p => bodies%x
        case (2)
            p => bodies%v
        case (3)
            p => bodies%force
        case (4)
            p => bodies%alpha
        case (5)
            p => bodies%omega
        case (6)
            p => bodies%moment
        case default
            p => bodies%x_low
        end select
    end function

    subroutine views()
        type(vti_view), pointer :: p, q
        type(vti_bodies), target :: spoiled, source
        integer(c_int64_t), parameter :: quantity(7) = [VTI_QUANTITY_X, VTI_QUANTITY_V, VTI_QUANTITY_FORCE, &
            VTI_QUANTITY_ALPHA, VTI_QUANTITY_OMEGA, VTI_QUANTITY_MOMENT, VTI_QUANTITY_X_LOW]
        integer :: k, j, c
        do k = 1, 7
            p => view(spoiled, k)
            do c = 1, 3
                spoiled = good
                p%c(c) = c_null_ptr
                b = spoiled
                call refused(VTI_E_VIEW, quantity(k), 'half a view')
            end do
            spoiled = good
            p%stride = 0
            b = spoiled
            call refused(VTI_E_STRIDE, quantity(k), 'stride 0')
            source = good
            do j = 1, k - 1
                spoiled = good
                q => view(source, j)
                p = q
                b = spoiled
                call refused(VTI_E_ALIAS, quantity(k), 'two quantities in one place')
            end do
        end do
        b = good
        b%quat = vti_quat_view_columns(s%quat)
        call refused(VTI_E_VIEW, VTI_QUANTITY_QUAT, 'the attitude twice')
        b%alpha = vti_view()
        b%quat%xyzw(4) = c_null_ptr
        call refused(VTI_E_VIEW, VTI_QUANTITY_QUAT, 'three quarters of a quaternion')
        b%quat = vti_quat_view_columns(s%quat)
        b%quat%stride = 0
        call refused(VTI_E_STRIDE, VTI_QUANTITY_QUAT, 'quaternions of stride 0')
    end subroutine

    subroutine masses()
        real(c_double), target :: bad(4)
        integer :: k
        bad = [0.0_c_double, -1.0_c_double, ieee_value(h, ieee_quiet_nan), ieee_value(h, ieee_positive_inf)]
        do k = 1, 4
            b = good
            b%mass = vti_scalars_one(bad(k))
            call refused(VTI_E_MASS, VTI_QUANTITY_MASS, 'one mass for all')
            b = good
            b%inertia = vti_scalars_one(bad(k))
            call refused(VTI_E_INERTIA, VTI_QUANTITY_INERTIA, 'one inertia for all')
            call blamed(s%mass, bad(k), VTI_E_MASS, VTI_QUANTITY_MASS, 'a mass')
            call blamed(s%inertia, bad(k), VTI_E_INERTIA, VTI_QUANTITY_INERTIA, 'an inertia')
            call expect_status(vti_packed_begin(2_c_int64_t, h, n, v=s%v, force=force, masses=1_c_int64_t, &
                mass=bad(k:k), inertias=1_c_int64_t), VTI_E_MASS, 'packed, one mass for all')
        end do
        b = good
        b%mass = vti_scalars()
        call refused(VTI_E_MASS, VTI_QUANTITY_MASS, 'no mass')
        b = good
        b%inertia = vti_scalars()
        call refused(VTI_E_INERTIA, VTI_QUANTITY_INERTIA, 'no inertia')
    end subroutine

    !> One of the values is bad, and its body is named.
    subroutine blamed(values, bad, wanted, quantity, what)
        real(c_double), intent(inout) :: values(n)
        real(c_double), intent(in) :: bad
        integer(c_int), intent(in) :: wanted
        integer(c_int64_t), intent(in) :: quantity
        character(len=*), intent(in) :: what
        type(vti_fault) :: fault
        real(c_double) :: keep
        keep = values(3)
        values(3) = bad
        call expect_status(vti_bodies_check_values(good, fault), wanted, what)
        call expect(fault%body == 3 .and. fault%quantity == quantity, what//': the body and the quantity')
        values(3) = keep
    end subroutine

    subroutine times()
        real(c_double) :: bad(5)
        integer :: k
        type(vti_bodies) :: probed
        probed = good
        probed%x = vti_view_columns(other)
        probed%x_low = vti_view()
        bad = [0.0_c_double, -h, ieee_value(h, ieee_quiet_nan), ieee_value(h, ieee_positive_inf), &
            ieee_value(h, ieee_negative_inf)]
        do k = 1, 5
            call expect_status(vti_step_begin(vti2, bad(k), good), VTI_E_TIME, 'begin, h')
            call expect_status(vti_step_stage(vti2, 0_c_int64_t, bad(k), good), VTI_E_TIME, 'stage, h')
            call expect_status(vti_step_finish(vti2, bad(k), good), VTI_E_TIME, 'finish, h')
            call expect_status(vti_step_start(vti2, bad(k), good), VTI_E_TIME, 'start, h')
            call expect_status(vti_step_sync(vti2, bad(k), good), VTI_E_TIME, 'sync, h')
            call expect_status(vti_step_probe(chin4, 0_c_int64_t, bad(k), good, probed), VTI_E_TIME, 'probe, h')
            call expect_status(vti_packed_begin(2_c_int64_t, bad(k), n, x=s%x, v=s%v, masses=1_c_int64_t, &
                inertias=1_c_int64_t), VTI_E_TIME, 'packed, h')
            call expect_status(vti_packed_finish(2_c_int64_t, bad(k), n, v=s%v, masses=1_c_int64_t, &
                inertias=1_c_int64_t), VTI_E_TIME, 'packed finish, h')
            if (ieee_is_finite(bad(k))) cycle
            call expect_status(vti_kick(bad(k), good), VTI_E_TIME, 'kick, t')
            call expect_status(vti_drift(VTI_LAW_CAYLEY, VTI_FRAME_SPACE, bad(k), good), VTI_E_TIME, 'drift, t')
        end do
        call unchanged('times')
    end subroutine

    !> Lists that are not there, or no longer; bonds of bodies without positions or attitudes.
    subroutine lists()
        type(vti_contacts), target :: c
        c = contacts
        c%pair = c_null_ptr
        call no_effect(vti_contacts_effect(c), good, 'contacts without pairs')
        c%pair = c_loc(pair)
        c%count = -1
        call no_effect(vti_contacts_effect(c), good, 'fewer contacts than none')
        contacts%pair = c_null_ptr
        call no_effect(effects(2), good, 'contacts that lose their pairs')
        call expect(ieee_is_nan(vti_energy(effects(2:2), good)), 'energy of contacts that lose their pairs')
        contacts%pair = c_loc(pair)
        b = good
        b%x = vti_view()
        b%x_low = vti_view()
        call no_effect(effects(1), b, 'bonds without positions')
        b = good
        b%alpha = vti_view()
        call no_effect(effects(1), b, 'bonds without attitudes')
        call expect_status(vti_apply(effects, good), VTI_OK, 'all effects are sound again')
    end subroutine

    subroutine no_effect(effect, bodies, what)
        type(vti_effect), intent(in) :: effect
        type(vti_bodies), intent(in) :: bodies
        character(len=*), intent(in) :: what
        call expect_status(vti_apply([effects(4), effect], bodies), VTI_E_NULL, what)
        call unchanged(what)
    end subroutine

    !> Every procedure refuses b and, where it says more than a status, names the quantity; and nothing has changed.
    subroutine refused(wanted, quantity, what)
        integer(c_int), intent(in) :: wanted
        integer(c_int64_t), intent(in) :: quantity
        character(len=*), intent(in) :: what
        type(vti_bodies) :: copy, probed
        type(vti_fault) :: fault(3)
        real(c_double) :: scratch(n)
        type(vti_stable) :: stable
        integer :: k
        copy = b
        call expect_status(vti_bodies_check(b), wanted, what//', check')
        call expect_status(vti_bodies_check_values(b, fault(1)), wanted, what//', values')
        call expect_status(vti_bodies_seal(copy), wanted, what//', seal')
        call expect(copy%sealed == 0, what//', not sealed')
        call expect_status(vti_kick(h, b), wanted, what//', kick')
        call expect_status(vti_drift(VTI_LAW_EXACT, VTI_FRAME_BODY, h, b, fault(2)), wanted, what//', drift')
        call expect_status(vti_step_begin(vti2, h, b, fault(3)), wanted, what//', begin')
        call expect(all(fault%body == 0) .and. all(fault%quantity == quantity), what//', the quantity to blame')
        call expect_status(vti_step_stage(chin4, 1_c_int64_t, h, b), wanted, what//', stage')
        call expect_status(vti_step_finish(vti2, h, b), wanted, what//', finish')
        call expect_status(vti_step_start(vti2, h, b), wanted, what//', start')
        call expect_status(vti_step_sync(vti2, h, b), wanted, what//', sync')
        probed = good
        probed%x = vti_view_columns(other)
        probed%x_low = vti_view()
        call expect_status(vti_step_probe(chin4, 0_c_int64_t, h, b, probed), wanted, what//', probe')
        call expect_status(vti_step_probe(chin4, 0_c_int64_t, h, good, b), wanted, what//', probed')
        do k = 1, 5
            call expect_status(vti_apply(effects(k:k), b), wanted, what//', apply')
            call expect(ieee_is_nan(vti_energy(effects(k:k), b)), what//', energy')
        end do
        stable%h = -3
        call expect_status(vti_stable_step(effects, b, scratch, stable), wanted, what//', stable step')
        call expect(abs(stable%h + 3) <= 0, what//', stable step is not written')
        if (wanted == VTI_E_ABI .or. wanted == VTI_E_COUNT) call expect(vti_bonds_rest(pair, b, rest) /= VTI_OK, what//', rest')
        call no_number(what)
        call unchanged(what)
    end subroutine

    subroutine no_number(what)
        character(len=*), intent(in) :: what
        real(c_double) :: r(3, 4)
        call vti_momentum(b, r(:, 1))
        call vti_spin(b, r(:, 2))
        call vti_angular_momentum(b, [0.0_c_double, 0.0_c_double, 0.0_c_double], r(:, 3))
        call vti_pendulum_arm(pendulum, b, 1_c_int64_t, r(:, 4))
        call expect(all(ieee_is_nan(r)), what//', vectors')
        call expect(all(ieee_is_nan([vti_kinetic_translation(b), vti_kinetic_rotation(b), vti_max_turn(h, b), &
            vti_h1_density(b), vti_h1_distance(b, good), vti_h1_distance(good, b), vti_attitude_distance(b, good), &
            vti_attitude_distance(good, b)])), what//', measures')
    end subroutine

    subroutine unchanged(what)
        character(len=*), intent(in) :: what
        call expect(same_bits(s%x, before%x) .and. same_bits(s%v, before%v) .and. same_bits(s%alpha, before%alpha) .and. &
            same_bits(s%omega, before%omega) .and. same_bits(s%quat, before%quat) .and. same_bits(s%mass, before%mass) &
            .and. all(abs(force - 0.5_c_double) <= 0) .and. all(abs(moment - 0.25_c_double) <= 0) .and. &
            all(abs(low) <= 0) .and. all(abs(other) <= 0), what//', nothing has changed')
    end subroutine
end program
