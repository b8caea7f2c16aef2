! SPDX-License-Identifier: BSD-3-Clause
!> How errors cross from C to Fortran: every procedure hands on the status, faults count from 1, what the constructors
!> of views know of shapes is refused, and nothing has changed. Which input has which status is C's: tests/unit.
program test_fortran_errors
    use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_is_nan, ieee_quiet_nan, ieee_value
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_int, c_int64_t, c_loc
    use common
    implicit none

    real(c_double), parameter :: h = 1.0_c_double/64
    type(state), target :: s
    type(state) :: before
    real(c_double), target :: force(3, n), moment(3, n), other(3, n), wrong(4, n), triples(3, 2) = 0, none(3, 0)
    real(c_double), target :: one = 1, rest(4, 2), plane(4, 1)
    integer(c_int64_t), target :: pair(2, 2) = reshape([1_c_int64_t, 2_c_int64_t, 2_c_int64_t, 3_c_int64_t], [2, 2])
    integer(c_int64_t), target :: wrong_pair(3, 2) = 1
    type(vti_bonds), target :: bonds
    type(vti_contacts), target :: contacts
    type(vti_walls), target :: walls
    type(vti_gravity), target :: gravity
    type(vti_pendulum), target :: pendulum
    type(vti_effect) :: effects(5)
    type(vti_bodies) :: good, b
    type(vti_stepper) :: vti1, vti2, chin4, unknown
    type(vti_fault) :: fault

    s = initial()
    force = 0.5_c_double
    moment = 0.25_c_double
    wrong = 0
    other = 0
    plane(:, 1) = [0, 0, 1, 0]
    good = vti_bodies_none(n)
    good%x = vti_view_columns(s%x)
    good%v = vti_view_columns(s%v)
    good%force = vti_view_columns(force)
    good%alpha = vti_view_columns(s%alpha)
    good%omega = vti_view_columns(s%omega)
    good%moment = vti_view_columns(moment)
    good%mass = vti_scalars_array(s%mass)
    good%inertia = vti_scalars_array(s%inertia)
    vti1 = vti_stepper_find('vti1')
    vti2 = vti_stepper_find('vti2  ') ! as a fixed-length variable holds it
    chin4 = vti_stepper_find('chin4')
    unknown = vti_stepper_find('vti')
    call expect_status(vti_bonds_rest(pair, good, rest, fault), VTI_OK, 'rest')
    call lists_are_good()
    effects = [vti_bonds_effect(bonds), vti_contacts_effect(contacts), vti_walls_effect(walls), &
        vti_gravity_effect(gravity), vti_pendulum_effect(pendulum)]
    before = s

    call steppers()
    call spoiled_bodies()
    call shapes()
    call short_views()
    call values()
    call too_large()
    call lists()
    call no_effects()
    call stable_steps()
    call packed_arrays()
    call finish()

contains

    subroutine lists_are_good()
        bonds = vti_bonds_between(pair, rest)
        bonds%moment = vti_scalars_one(one)
        bonds%axial = vti_scalars_one(one)
        bonds%shear = vti_scalars_one(one)
        contacts = vti_contacts_between(pair, vti_scalars_one(one), 1.0_c_double)
        walls = vti_walls_at(plane, vti_scalars_one(one), 1.0_c_double)
    end subroutine

    subroutine steppers()
        type(vti_effect) :: friction
        call expect(vti_text(vti1%name) == 'vti1', 'vti1 is found')
        call expect(vti_text(vti2%name) == 'vti2', 'vti2 is found')
        call expect(vti1%law == VTI_LAW_CLOSED .and. vti1%frame == VTI_FRAME_SPACE .and. vti1%order == 2 .and. &
            vti1%reversible == 1 .and. vti1%stages == 1, 'what vti1 is')
        call expect(unknown%stages == 0, 'vti is not found')
        call expect(vti_text(unknown%name) == '', 'and has no name')
        unknown = vti_stepper_at(vti_stepper_count() + 1)
        call expect(unknown%stages == 0, 'the steppers end')
        unknown = vti_stepper_at(0_c_int64_t)
        call expect(unknown%stages == 0, 'the steppers count from 1')
        call expect(index(vti_status_text(VTI_E_STEPPER), ' vti3-leapfrog, ') > 0, 'the text names the steppers')
        call expect_status(vti_step_begin(unknown, h, good, fault), VTI_E_STEPPER, 'no stepper')
        call expect(fault%body == 0, 'no stepper: no body')
        call expect_status(vti_step_begin(vti1, -h, good, fault), VTI_E_TIME, 'h < 0')
        call expect(fault%body == 0 .and. abs(fault%value + h) <= 0, 'h < 0: the value, no body')
        call expect_status(vti_step_stage(vti1, 1_c_int64_t, h, good), VTI_E_STAGE, 'a stage too many')
        call expect_status(vti_drift(VTI_LAW_CAYLEY, 0_c_int, h, good, fault), VTI_E_FRAME, 'no such frame')
        friction = effects(4)
        call expect_status(vti_step_check(vti_stepper_find('srkn14'), [friction]), VTI_OK, 'srkn14 under gravity')
        friction%dissipates = 1
        call expect_status(vti_step_check(vti_stepper_find('srkn14'), [friction]), VTI_E_DISSIPATES, &
            'srkn14 with friction')
    end subroutine

    !> One fault of each kind through every procedure.
    subroutine spoiled_bodies()
        b = good
        b%abi = VTI_ABI + 1
        call refused(VTI_E_ABI, VTI_QUANTITY_NONE, 'another ABI')
        b = vti_bodies_slice(good, 0_c_int64_t, 1_c_int64_t)
        call refused(VTI_E_COUNT, VTI_QUANTITY_NONE, 'a slice from body 0')
        b = good
        b%x%stride = 0
        call refused(VTI_E_STRIDE, VTI_QUANTITY_X, 'a stride of 0')
        b = good
        b%v = b%x
        call refused(VTI_E_ALIAS, VTI_QUANTITY_V, 'two quantities in one place')
        b = good
        b%mass = vti_scalars()
        call refused(VTI_E_MASS, VTI_QUANTITY_MASS, 'no mass')
    end subroutine

    !> What the constructors of views know of arrays.
    subroutine shapes()
        real(c_double), pointer :: nowhere(:, :)
        real(c_double), target :: no_rows(0, n), no_columns(n, 0)
        b = good
        b%alpha = vti_view_columns(no_rows)
        call refused(VTI_E_VIEW, VTI_QUANTITY_ALPHA, 'columns of nothing')
        b%alpha = vti_view_rows(no_columns)
        call refused(VTI_E_VIEW, VTI_QUANTITY_ALPHA, 'rows of nothing')
        b%alpha = vti_view()
        b%quat = vti_quat_view_columns(no_rows)
        call refused(VTI_E_VIEW, VTI_QUANTITY_QUAT, 'quaternions in columns of nothing')
        b%quat = vti_quat_view_rows(no_columns)
        call refused(VTI_E_VIEW, VTI_QUANTITY_QUAT, 'quaternions in rows of nothing')
        b = good
        b%alpha = vti_view_columns(wrong)
        call refused(VTI_E_VIEW, VTI_QUANTITY_ALPHA, 'columns of the wrong shape')
        b%alpha = vti_view_rows(s%alpha(:, 1:4))
        call refused(VTI_E_VIEW, VTI_QUANTITY_ALPHA, 'rows of the wrong shape')
        b%alpha = vti_view_separate(s%alpha(1, :), s%alpha(2, ::2), s%alpha(3, :))
        call refused(VTI_E_VIEW, VTI_QUANTITY_ALPHA, 'components with strides of their own')
        b%alpha = vti_view_separate(s%alpha(1, :), none(1, :), s%alpha(3, :))
        call refused(VTI_E_VIEW, VTI_QUANTITY_ALPHA, 'a component of no bodies')
        b%alpha = vti_view()
        b%quat = vti_quat_view_columns(s%alpha)
        call refused(VTI_E_VIEW, VTI_QUANTITY_QUAT, 'quaternions in columns of the wrong shape')
        b%quat = vti_quat_view_rows(s%alpha)
        call refused(VTI_E_VIEW, VTI_QUANTITY_QUAT, 'quaternions in rows of the wrong shape')
        b = good
        b%x = vti_view_member(c_loc(s%x), 20_c_int64_t)
        call refused(VTI_E_STRIDE, VTI_QUANTITY_X, 'members not whole doubles apart')
        b = good
        b%mass = vti_scalars_member(c_loc(s%mass), 4_c_int64_t)
        call refused(VTI_E_MASS, VTI_QUANTITY_MASS, 'masses not whole doubles apart')
        nullify (nowhere)
        b = vti_bodies_none(0_c_int64_t)
        b%x = vti_view_columns(none)
        b%v = vti_view_rows(s%v(1:0, :))
        b%alpha = vti_view_columns(nowhere)
        b%omega = vti_view_separate(none(1, :), none(2, :), none(3, :))
        call expect(.not. (c_associated(b%x%c(1)) .or. c_associated(b%v%c(1)) .or. c_associated(b%alpha%c(1)) .or. &
            c_associated(b%omega%c(1))), 'views of no bodies are absent')
        call expect_status(vti_step_begin(vti1, h, b), VTI_OK, 'no bodies')
    end subroutine

    !> Arrays of fewer bodies than there are, by every constructor that knows how many.
    subroutine short_views()
        real(c_double), target :: rows(n - 1, 3), quats(4, n - 1), quat_rows(n - 1, 4)
        rows = 0
        quats = 1
        quat_rows = 1
        b = good
        b%x = vti_view_columns(s%x(:, :n - 1))
        call short(VTI_QUANTITY_X, 'columns')
        b = good
        b%moment = vti_view_rows(rows)
        call short(VTI_QUANTITY_MOMENT, 'rows')
        b = good
        b%omega = vti_view_separate(s%omega(1, :), s%omega(2, :n - 1), s%omega(3, :))
        call short(VTI_QUANTITY_OMEGA, 'one of three components')
        b = good
        b%alpha = vti_view()
        b%quat = vti_quat_view_columns(quats)
        call short(VTI_QUANTITY_QUAT, 'quaternions in columns')
        b%quat = vti_quat_view_rows(quat_rows)
        call short(VTI_QUANTITY_QUAT, 'quaternions in rows')
        b = good
        b%inertia = vti_scalars_array(s%inertia(n:))
        call short(VTI_QUANTITY_INERTIA, 'an array of one inertia')
    end subroutine

    !> All of b are refused, but not those that every view shows.
    subroutine short(quantity, what)
        integer(c_int64_t), intent(in) :: quantity
        character(len=*), intent(in) :: what
        call refused(VTI_E_COUNT, quantity, 'too short, '//what)
        call expect_status(vti_bodies_check_values(b, fault), VTI_E_COUNT, what)
        call expect(fault%body == 0 .and. fault%value < n .and. fault%value > 0, 'as many as it shows, '//what)
        call expect_status(vti_bodies_check(vti_bodies_slice(b, 1_c_int64_t, nint(fault%value, c_int64_t))), VTI_OK, &
            what)
    end subroutine

    subroutine values()
        s%mass(3) = -1
        call expect_status(vti_bodies_check_values(good, fault), VTI_E_MASS, 'a negative mass')
        call expect(fault%body == 3 .and. abs(fault%value + 1) <= 0, 'a negative mass: body 3')
        call expect(vti_quantity_text(fault%quantity) == 'mass', 'and it is a mass')
        s = before
        s%omega(2, n) = ieee_value(h, ieee_quiet_nan)
        call expect_status(vti_bodies_check_values(good, fault), VTI_E_STATE, 'a NaN')
        call expect(fault%body == n .and. fault%quantity == VTI_QUANTITY_OMEGA, 'a NaN: the last body')
        s = before
        call expect_status(vti_bodies_check_values(good, fault), VTI_OK, 'good bodies')
        call expect(fault%body == 0 .and. fault%quantity == VTI_QUANTITY_NONE, 'good bodies: no fault')
    end subroutine

    !> The bound of VTI-1: all or nothing.
    subroutine too_large()
        real(c_double) :: value
        integer(c_int64_t) :: body
        integer(c_int) :: status
        s%omega(:, 5) = [0.0_c_double, 80.0_c_double, 0.0_c_double]
        s%omega(:, 2) = [0.0_c_double, 0.0_c_double, 70.0_c_double]
        moment = 0
        call too_far(vti_step_begin(vti1, h, good, fault), 5_c_int64_t, 1.25_c_double, 'begin')
        call too_far(vti_step_begin(vti1, h, vti_bodies_slice(good, 2_c_int64_t, 3_c_int64_t), fault), 2_c_int64_t, &
            1.09375_c_double, 'a slice')
        call too_far(vti_drift(VTI_LAW_CLOSED, VTI_FRAME_SPACE, h, good, fault), 5_c_int64_t, 1.25_c_double, 'drift')
        status = vti_packed_begin(1_c_int64_t, h, n, s%x, s%v, force, s%alpha, s%omega, moment, n, s%mass, n, &
            s%inertia, body, value)
        fault = vti_fault(body, value, VTI_QUANTITY_OMEGA) ! packed arrays have no quantity
        call too_far(status, 5_c_int64_t, 1.25_c_double, 'packed')
        call expect_status(vti_step_begin(vti1, h, good), VTI_E_TOO_LARGE, 'begin without a fault to fill')
        moment = 0.25_c_double
        s = before
    end subroutine

    subroutine too_far(status, wanted, turn, what)
        integer(c_int), intent(in) :: status
        integer(c_int64_t), intent(in) :: wanted
        real(c_double), intent(in) :: turn
        character(len=*), intent(in) :: what
        call expect_status(status, VTI_E_TOO_LARGE, 'too large, '//what)
        call expect(fault%body == wanted .and. abs(fault%value - turn) <= 0 .and. &
            fault%quantity == VTI_QUANTITY_OMEGA, 'the body that turns too far, '//what)
        call expect(same_bits(s%x, before%x) .and. same_bits(s%v, before%v) .and. same_bits(s%alpha, before%alpha), &
            'nothing has changed, '//what)
    end subroutine

    subroutine element_is(status, wanted, element, what)
        integer(c_int), intent(in) :: status, wanted
        integer, intent(in) :: element
        character(len=*), intent(in) :: what
        call expect_status(status, wanted, what)
        call expect(fault%body == element, what//': the element')
    end subroutine

    !> Bonds, contacts and their bodies count from 1.
    subroutine lists()
        call element_is(vti_bonds_rest(wrong_pair, good, rest, fault), VTI_E_COUNT, 0, 'pairs of three')
        call element_is(vti_bonds_rest(pair, good, triples, fault), VTI_E_COUNT, 0, 'rest vectors of three')
        call element_is(vti_bonds_rest(pair(:, :1), good, rest, fault), VTI_E_COUNT, 0, 'fewer pairs than rest vectors')
        pair(1, 2) = 0
        call element_is(vti_bonds_rest(pair, good, rest, fault), VTI_E_BOND, 2, 'body 0')
        call element_is(vti_bonds_check(bonds, n, fault), VTI_E_BOND, 2, 'a bond to body 0')
        call expect(abs(fault%value) <= 0 .and. fault%quantity == VTI_QUANTITY_NONE, 'body 0: the value')
        pair(:, 2) = [n + 1, 2_c_int64_t]
        call element_is(vti_bonds_rest(pair, good, rest, fault), VTI_E_BOND, 2, 'a body behind the last')
        call expect(nint(fault%value, c_int64_t) == n + 1, 'a body behind the last: the value')
        call element_is(vti_contacts_check(contacts, n, fault), VTI_E_CONTACT, 2, &
            'a contact with a body behind the last')
        pair(:, 2) = [2, 3]
        call element_is(vti_bonds_check(bonds, n, fault), VTI_OK, 0, 'good bonds')
        bonds%axial = vti_scalars_array(s%x(1, :))
        call element_is(vti_bonds_check(bonds, n, fault), VTI_E_BOND, 1, 'stiffnesses with gaps')
        bonds%axial = vti_scalars_one(one)
        call element_is(vti_contacts_check(contacts, n, fault), VTI_OK, 0, 'good contacts')
        contacts = vti_contacts_between(pair, vti_scalars_one(one), modulus=vti_scalars_one(one), &
            length=vti_scalars_one(one))
        call element_is(vti_contacts_check(contacts, n, fault), VTI_OK, 0, 'contacts of a material')
        call expect(abs(vti_contacts_stiffness(contacts, 2_c_int64_t) - 1 / 3.0_c_double) < 1e-15_c_double, &
            'stiffness of a material')
        call expect(ieee_is_nan(vti_contacts_stiffness(contacts, 3_c_int64_t)), 'stiffness of no pair')
        contacts%stiffness = 1
        call element_is(vti_contacts_check(contacts, n, fault), VTI_E_CONTACT, 0, 'a stiffness and a modulus')
        bonds = vti_bonds_between(wrong_pair, rest)
        call element_is(vti_bonds_check(bonds, n, fault), VTI_E_COUNT, 0, 'bonds of pairs of three')
        bonds = vti_bonds_between(pair, triples)
        call element_is(vti_bonds_check(bonds, n, fault), VTI_E_COUNT, 0, 'bonds of rest vectors of three')
        bonds = vti_bonds_between(pair(:, 1:0), rest(:, 1:0))
        call element_is(vti_bonds_check(bonds, n, fault), VTI_OK, 0, 'no bonds')
        contacts = vti_contacts_between(wrong_pair, vti_scalars_one(one), 1.0_c_double)
        call element_is(vti_contacts_check(contacts, n, fault), VTI_E_COUNT, 0, 'contacts of the wrong shape')
        call lists_are_good()
    end subroutine

    !> A bond that is made of bodies that have turned is at rest, to rounding; its rotation is that of
    !> alpha = (0, 0, 1.5).
    subroutine bond_made_now()
        real(c_double), target :: x(3, 2), alpha(3, 2), rest(4, 1), turn(4, 1), stiffness
        real(c_double) :: measures(VTI_BOND_MEASURES, 1)
        integer(c_int64_t), target :: pair(2, 1)
        integer(c_int64_t), pointer, contiguous :: pairs(:, :)
        real(c_double), pointer, contiguous :: rests(:, :), turns(:, :)
        type(vti_bonds), target :: one
        type(vti_bodies) :: two
        x = reshape([1.5_c_double, 0.0_c_double, 2.0_c_double, 0.0_c_double, 0.0_c_double, 0.0_c_double], [3, 2])
        alpha = 0
        alpha(3, 1) = -1.5_c_double
        pair(:, 1) = [1_c_int64_t, 2_c_int64_t]
        stiffness = 8
        pairs => pair
        rests => rest
        turns => turn
        two = vti_bodies_none(2_c_int64_t)
        two%x = vti_view_columns(x)
        two%alpha = vti_view_columns(alpha)
        call expect_status(vti_bonds_rest_now(pair, two, rest, turn), VTI_OK, 'a bond made now')
        call expect(all(abs(rest(:, 1) - [0.168_c_double, 0.576_c_double, 0.8_c_double, 2.5_c_double]) &
            < 1e-15_c_double), 'its direction and length')
        call expect(all(abs(turn(:, 1) - [0.0_c_double, 0.0_c_double, 0.6_c_double, 0.8_c_double]) < 1e-15_c_double), &
            'its rotation')
        one = vti_bonds_between(pairs, rests, turns)
        one%moment = vti_scalars_one(stiffness)
        one%shear = vti_scalars_one(stiffness)
        call element_is(vti_bonds_check(one, 2_c_int64_t, fault), VTI_OK, 0, 'a bond made now, checked')
        call expect_status(vti_bonds_measure(one, two, 1_c_int64_t, 1_c_int64_t, measures), VTI_OK, 'what it holds')
        call expect(all(abs(measures) < 1e-14_c_double), 'a bond made now holds nothing')
        turn = 2*turn
        call element_is(vti_bonds_check(one, 2_c_int64_t, fault), VTI_E_BOND, 1, 'a rotation of length 2')
        pair(2, 1) = 3
        call element_is(vti_bonds_rest_now(pair, two, rest, turn, fault), VTI_E_BOND, 1, 'a bond to no body')
        call expect_status(vti_bonds_rest_now(pair, two, rest(:3, :), turn), VTI_E_COUNT, 'rest of the wrong shape')
        call expect_status(vti_bonds_rest_now(pair, two, rest, turn(:3, :)), VTI_E_COUNT, 'turn of the wrong shape')
        turns => turn(:, 1:0)
        one = vti_bonds_between(pairs, rests, turns)
        call expect(one%count == -1, 'bonds without their rotations')
        nullify(turns)
        one = vti_bonds_between(pairs, rests, turns)
        call expect(one%count == -1, 'bonds of no rotations')
    end subroutine

    !> A bond that is stretched from 1 to 3/2 holds N = K/2 and U = K/8; it breaks, and cannot be taken out twice.
    subroutine rupture_of_one()
        real(c_double), target :: x(3, 2), rest(4, 1), stiffness, limit, measures(VTI_BOND_MEASURES, 1)
        integer(c_int64_t), target :: pair(2, 1), id(1)
        integer(c_int64_t), pointer, contiguous :: pairs(:, :)
        real(c_double), pointer, contiguous :: rests(:, :)
        type(vti_bonds), target :: one
        type(vti_rupture), target :: rupture
        type(vti_rupture), pointer :: at
        type(vti_sum), target :: lost
        type(vti_bodies) :: two
        type(vti_effect) :: effects(1)
        type(vti_fault) :: fault
        integer(c_int64_t) :: broken
        x = reshape([1.5_c_double, 0.0_c_double, 0.0_c_double, 0.0_c_double, 0.0_c_double, 0.0_c_double], [3, 2])
        rest(:, 1) = [1.0_c_double, 0.0_c_double, 0.0_c_double, 1.0_c_double]
        pair(:, 1) = [1_c_int64_t, 2_c_int64_t]
        stiffness = 8
        limit = 0.5_c_double
        id = 1
        lost = vti_sum()
        pairs => pair
        rests => rest
        one = vti_bonds_between(pairs, rests)
        one%axial = vti_scalars_one(stiffness)
        two = vti_bodies_none(2_c_int64_t)
        two%x = vti_view_columns(x)
        rupture%bonds = c_loc(one)
        rupture%id = c_loc(id)
        rupture%lost = c_loc(lost)
        rupture%stretch = vti_scalars_one(limit)
        at => rupture
        call expect_status(vti_bonds_measure(one, two, 1_c_int64_t, 1_c_int64_t, measures), VTI_OK, 'what a bond holds')
        call expect(all(abs(measures(:, 1) - [4.0_c_double, 0.0_c_double, 0.0_c_double, 0.0_c_double, 1.0_c_double, &
            0.5_c_double]) < 1e-14_c_double), 'N, U and the stretch')
        call expect_status(vti_bonds_measure(one, two, 1_c_int64_t, 2_c_int64_t, measures), VTI_E_COUNT, &
            'too few measures')
        call expect_status(vti_rupture_check(rupture), VTI_OK, 'limits')
        limit = 0
        call expect_status(vti_rupture_check(rupture, fault), VTI_E_BOND, 'a limit of 0')
        call expect(fault%body == 1, 'of the first bond')
        limit = 0.5_c_double
        effects(1) = vti_rupture_effect(at)
        call expect_status(vti_effects_rupture(effects, two, broken), VTI_OK, 'rupture')
        call expect(broken == 1 .and. one%count == 0 .and. abs(lost%high - 1) < 1e-14_c_double, 'a bond less')
        call expect_status(vti_rupture_take_out(rupture, id), VTI_E_BOND, 'taken out a second time')
    end subroutine

    !> Effects of what does not exist, or has the wrong shape, are refused before anything is written.
    subroutine no_effects()
        type(vti_bonds), pointer :: no_bonds
        type(vti_contacts), pointer :: no_contacts
        type(vti_walls), pointer :: no_walls
        type(vti_gravity), pointer :: no_gravity
        type(vti_drag), pointer :: no_drag
        type(vti_dashpots), pointer :: no_dashpots
        type(vti_bond_dashpots), pointer :: no_bond_dashpots
        type(vti_rupture), pointer :: no_rupture
        type(vti_friction), pointer :: no_friction
        type(vti_pendulum), pointer :: no_pendulum
        type(vti_bonds), target :: other_bonds
        type(vti_contacts), target :: other_contacts
        type(vti_walls), target :: other_walls
        type(vti_walls), pointer :: gap_of
        real(c_double) :: normal(3), place(3)
        place = [1.0_c_double, 2.0_c_double, 3.0_c_double]
        gap_of => walls
        nullify (no_bonds, no_contacts, no_walls, no_gravity, no_drag, no_dashpots, no_friction, no_bond_dashpots, &
            no_rupture, no_pendulum)
        call no_effect(vti_bonds_effect(no_bonds), 'no bonds')
        call no_effect(vti_contacts_effect(no_contacts), 'no contacts')
        call no_effect(vti_walls_effect(no_walls), 'no walls')
        call no_effect(vti_gravity_effect(no_gravity), 'no gravity')
        call no_effect(vti_drag_effect(no_drag), 'no drag')
        call no_effect(vti_dashpots_effect(no_dashpots), 'no dashpots')
        call expect(abs(vti_dashpots_zeta(exp(-2.0_c_double), 0_c_int64_t) - 1) < 1e-7_c_double, 'zeta of exp(-2)')
        call no_effect(vti_friction_effect(no_friction), 'no friction')
        call no_effect(vti_bond_dashpots_effect(no_bond_dashpots), 'no dashpots of bonds')
        call no_effect(vti_rupture_effect(no_rupture), 'no rupture')
        call rupture_of_one()
    call bond_made_now()
        call no_effect(vti_pendulum_effect(no_pendulum), 'no pendulum')
        other_bonds = vti_bonds_between(wrong_pair, rest)
        call no_effect(vti_bonds_effect(other_bonds), 'bonds of the wrong shape')
        other_contacts = vti_contacts_between(wrong_pair, vti_scalars_one(one), 1.0_c_double)
        call no_effect(vti_contacts_effect(other_contacts), 'contacts of the wrong shape')
        other_walls = vti_walls_at(triples, vti_scalars_one(one), 1.0_c_double)
        call no_effect(vti_walls_effect(other_walls), 'planes of the wrong shape')
        call expect(ieee_is_nan(vti_walls_gap(no_walls, 1_c_int64_t, place, normal)), 'no walls, no gap')
        call expect(abs(vti_walls_gap(gap_of, 1_c_int64_t, place, normal) - 3) < tiny(one), 'gap of a wall')
        call expect(norm2(normal - [0, 0, 1]) < tiny(one), 'normal of a wall')
        call expect(ieee_is_nan(vti_walls_gap(gap_of, 2_c_int64_t, place, normal)), 'gap of a wall that there is not')
        call expect(abs(vti_walls_stiffness(gap_of, 1_c_int64_t, 1_c_int64_t) - 1) <= 0, 'stiffness of a wall')
        call expect(ieee_is_nan(vti_walls_stiffness(gap_of, 2_c_int64_t, 1_c_int64_t)), &
            'stiffness of a wall there is not')
        call expect(ieee_is_nan(vti_walls_stiffness(no_walls, 1_c_int64_t, 1_c_int64_t)), 'no walls, no stiffness')
        b = good
        b%alpha = vti_view()
        call expect_status(vti_apply(effects(:1), b), VTI_E_NEEDS, 'bonds without attitudes')
    end subroutine

    subroutine no_effect(effect, what)
        type(vti_effect), intent(in) :: effect
        character(len=*), intent(in) :: what
        call expect_status(vti_apply([effects(4), effect], good), VTI_E_NULL, what)
        call expect_status(vti_step_check(vti2, [effect]), VTI_E_NULL, what//', step check')
        call expect(ieee_is_nan(vti_energy([effect], good)), what//', energy')
        call unchanged(what)
    end subroutine

    subroutine stable_steps()
        real(c_double) :: scratch(n)
        type(vti_stable) :: stable
        stable%h = -3
        call expect_status(vti_stable_step(effects(:1), good, scratch(:2), stable), VTI_E_COUNT, 'too little scratch')
        call expect(abs(stable%h + 3) <= 0, 'stable step that is refused')
        call expect_status(vti_stable_step([vti_effect ::], good, scratch, stable), VTI_OK, 'stable step of nothing')
        call expect(.not. ieee_is_finite(stable%h) .and. stable%effect == 0 .and. stable%i == 0, 'nothing oscillates')
    end subroutine

    subroutine packed_arrays()
        call expect_status(vti_packed_begin(0_c_int64_t, h, n, masses=1_c_int64_t, inertias=1_c_int64_t), &
            VTI_E_STEPPER, 'packed, steppers count from 1')
        call expect_status(vti_packed_finish(0_c_int64_t, h, n, masses=1_c_int64_t, inertias=1_c_int64_t), &
            VTI_E_STEPPER, 'packed finish, steppers count from 1')
        call expect_status(vti_packed_begin(1_c_int64_t, h, n, s%x, s%v, masses=n - 1, mass=s%mass, &
            inertias=1_c_int64_t), VTI_E_COUNT, 'packed, masses neither 1 nor n')
        call expect_status(vti_packed_begin(1_c_int64_t, h, n, x=s%x, masses=1_c_int64_t, inertias=1_c_int64_t), &
            VTI_OK, 'packed, what is left out is absent')
    end subroutine

    !> Every procedure refuses b and, where it says more than a status, names the quantity; and nothing has changed.
    subroutine refused(wanted, quantity, what)
        integer(c_int), intent(in) :: wanted
        integer(c_int64_t), intent(in) :: quantity
        character(len=*), intent(in) :: what
        type(vti_bodies) :: copy, probed
        type(vti_fault) :: faults(3)
        type(vti_stable) :: stable
        real(c_double) :: scratch(n), r(3, 4)
        copy = b
        probed = good
        probed%x = vti_view_columns(other)
        call expect_status(vti_bodies_check(b), wanted, what//', check')
        call expect_status(vti_bodies_check_values(b, faults(1)), wanted, what//', values')
        call expect_status(vti_bodies_seal(copy), wanted, what//', seal')
        call expect_status(vti_kick(h, b), wanted, what//', kick')
        call expect_status(vti_drift(VTI_LAW_EXACT, VTI_FRAME_BODY, h, b, faults(2)), wanted, what//', drift')
        call expect_status(vti_step_begin(vti2, h, b, faults(3)), wanted, what//', begin')
        call expect(all(faults%body == 0) .and. all(faults%quantity == quantity), what//', the quantity')
        call expect_status(vti_step_stage(chin4, 1_c_int64_t, h, b), wanted, what//', stage')
        call expect_status(vti_step_finish(vti2, h, b), wanted, what//', finish')
        call expect_status(vti_step_start(vti2, h, b), wanted, what//', start')
        call expect_status(vti_step_sync(vti2, h, b), wanted, what//', sync')
        call expect_status(vti_step_probe(chin4, 0_c_int64_t, h, b, probed), wanted, what//', probe')
        call expect_status(vti_apply(effects, b), wanted, what//', apply')
        call expect_status(vti_stable_step(effects, b, scratch, stable), wanted, what//', stable step')
        call vti_momentum(b, r(:, 1))
        call vti_spin(b, r(:, 2))
        call vti_angular_momentum(b, [0.0_c_double, 0.0_c_double, 0.0_c_double], r(:, 3))
        call vti_pendulum_arm(pendulum, b, 1_c_int64_t, r(:, 4))
        call expect(all(ieee_is_nan(r)), what//', vectors')
        call expect(all(ieee_is_nan([vti_energy(effects, b), vti_kinetic_translation(b), vti_kinetic_rotation(b), &
            vti_max_turn(h, b), vti_h1_density(b), vti_h1_distance(b, good), vti_attitude_distance(b, good)])), &
            what//', measures')
        call unchanged(what)
    end subroutine

    subroutine unchanged(what)
        character(len=*), intent(in) :: what
        call expect(same_bits(s%x, before%x) .and. same_bits(s%v, before%v) .and. &
            same_bits(s%alpha, before%alpha) .and. same_bits(s%omega, before%omega) .and. &
            same_bits(s%mass, before%mass) .and. all(abs(force - 0.5_c_double) <= 0) .and. &
            all(abs(moment - 0.25_c_double) <= 0) .and. all(abs(other) <= 0), what//', nothing has changed')
    end subroutine
end program
