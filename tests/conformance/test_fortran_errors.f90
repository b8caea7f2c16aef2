! SPDX-License-Identifier: BSD-3-Clause
!> What is refused from Fortran, with which status, which body (counted from 1) is named, and that nothing has changed.
program test_fortran_errors
    use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_int, c_int64_t, c_loc, c_null_ptr
    use common
    implicit none

    type :: triple
        integer :: id = 0
        real(c_double) :: a(3) = 0
    end type

    type(state), target :: s
    type(state) :: before
    type(triple), target :: triples(n)
    real(c_double), target :: force(3, n), moment(3, n), wrong(4, n), none(3, 0)
    real(c_double), pointer :: nowhere(:, :)
    real(c_double), parameter :: h = 1.0_c_double/64
    type(vti_bodies) :: good, b
    type(vti_stepper) :: vti1, vti2, unknown
    type(vti_fault) :: fault
    integer(c_int64_t) :: body
    integer(c_int) :: status
    real(c_double) :: value

    s = initial()
    force = 0
    moment = 0
    wrong = 0
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
    unknown = vti_stepper_find('vti')

    call steppers()
    call views()
    call arguments()
    call values()
    call too_large()
    call finish()

contains

    subroutine steppers()
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
        call expect_status(vti_step_begin(unknown, h, good, fault), VTI_E_STEPPER, 'begin with no stepper')
        call expect(fault%body == 0, 'no body is to blame for the stepper')
        call expect(index(vti_status_text(VTI_E_STEPPER), ' vti3-leapfrog, ') > 0, 'the text names the steppers')
        call expect_status(vti_step_finish(unknown, h, good), VTI_E_STEPPER, 'finish with no stepper')
        call expect_status(vti_step_start(unknown, h, good), VTI_E_STEPPER, 'start with no stepper')
        call expect_status(vti_step_sync(unknown, h, good), VTI_E_STEPPER, 'sync with no stepper')
        call expect_status(vti_step_stage(vti1, 1_c_int64_t, h, good), VTI_E_STAGE, 'a stage too many')
    end subroutine

    subroutine views()
        call expect_status(vti_bodies_check(good), VTI_OK, 'the bodies are good')
        b = good
        b%alpha%c(2) = c_null_ptr
        call refused(VTI_E_VIEW, 'a half-given view')
        b = good
        b%alpha = vti_view_columns(wrong)
        call refused(VTI_E_VIEW, 'columns of the wrong shape')
        b%alpha = vti_view_rows(s%alpha(:, 1:4))
        call refused(VTI_E_VIEW, 'rows of the wrong shape')
        b%alpha = vti_view_separate(s%alpha(1, :), s%alpha(2, ::2), s%alpha(3, :))
        call refused(VTI_E_VIEW, 'components with strides of their own')
        b%alpha = vti_view_separate(s%alpha(1, :), none(1, :), s%alpha(3, :))
        call refused(VTI_E_VIEW, 'a component of no bodies')
        b%alpha = vti_view_separate(triples%a(1), triples%a(2), triples%a(3))
        status = vti_bodies_check(b)
        call expect(status == VTI_OK .or. status == VTI_E_ALIAS, 'members as sections: right, or refused')
        b%alpha = vti_view()
        b%quat = vti_quat_view_columns(s%alpha)
        call refused(VTI_E_VIEW, 'quaternions in columns of the wrong shape')
        b%quat = vti_quat_view_rows(s%alpha)
        call refused(VTI_E_VIEW, 'quaternions in rows of the wrong shape')
        b = good
        b%quat = vti_quat_view_columns(s%quat)
        call refused(VTI_E_VIEW, 'the attitude given twice')
        b = good
        b%v = b%x
        call refused(VTI_E_ALIAS, 'two quantities on one array')
        b = good
        b%x%stride = 0
        call refused(VTI_E_STRIDE, 'a stride of 0')
        b = good
        b%x = vti_view_member(c_loc(s%x), 20_c_int64_t)
        call refused(VTI_E_STRIDE, 'a member at no whole distance')
        b = good
        b%x = vti_view_member(c_loc(s%x), 16_c_int64_t)
        call refused(VTI_E_STRIDE, 'a member of three doubles in two')
        b = good
        b%v = vti_view_columns(s%v(:, 2:))
        b%mass = vti_scalars_one(s%mass(1))
        b%count = n - 1
        call expect_status(vti_bodies_check(b), VTI_OK, 'fewer bodies, of which the others are not moved')
        b%x = vti_view_columns(s%v(:, :n - 1))
        call refused(VTI_E_ALIAS, 'positions and velocities shifted over each other by one body')
        call short_views()
        b = good
        b%mass = vti_scalars_member(c_loc(s%mass), 4_c_int64_t)
        call refused(VTI_E_MASS, 'a mass at no whole distance')
        b = good
        b%inertia = vti_scalars_array(triples%a(2))
        call refused(VTI_E_INERTIA, 'members as a section, inertia')
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
        b%v = vti_view_columns(s%v(:, 2:))
        call short(VTI_QUANTITY_X, 'columns, of which the first is named')
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
        b%mass = vti_scalars_array(s%mass(:n - 1))
        call short(VTI_QUANTITY_MASS, 'masses')
        b = good
        b%inertia = vti_scalars_array(s%inertia(n:))
        call short(VTI_QUANTITY_INERTIA, 'an array of one inertia')
    end subroutine

    !> All of b are refused, but not those that every view shows.
    subroutine short(quantity, what)
        integer(c_int64_t), intent(in) :: quantity
        character(len=*), intent(in) :: what
        type(vti_bodies) :: part
        call refused(VTI_E_COUNT, 'a view that is too short, '//what)
        status = vti_bodies_check_values(b, fault)
        call expect(fault%quantity == quantity .and. fault%body == 0 .and. fault%value < n .and. fault%value > 0, &
            'it is named, '//what)
        part = vti_bodies_slice(b, 1_c_int64_t, nint(fault%value, c_int64_t))
        call expect_status(vti_bodies_check(part), VTI_OK, 'as many as it shows, '//what)
    end subroutine

    subroutine arguments()
        call expect_status(vti_bodies_check(vti_bodies_none(-1_c_int64_t)), VTI_E_COUNT, 'a negative number of bodies')
        b = vti_bodies_slice(good, 0_c_int64_t, 1_c_int64_t)
        call refused(VTI_E_COUNT, 'a slice from body 0')
        b = good
        b%abi = VTI_ABI + 1
        call refused(VTI_E_ABI, 'another ABI')
        call expect_status(vti_step_begin(vti1, 0.0_c_double, good, fault), VTI_E_TIME, 'h = 0')
        call expect_status(vti_step_begin(vti1, -h, good, fault), VTI_E_TIME, 'h < 0')
        call expect(fault%body == 0 .and. abs(fault%value + h) <= 0, 'h is to blame, no body')
        call expect_status(vti_step_finish(vti1, -h, good), VTI_E_TIME, 'finish with h < 0')
        call expect_status(vti_kick(not_a_number(), good), VTI_E_TIME, 'a kick for no time')
        call expect_status(vti_drift(0_c_int, VTI_FRAME_SPACE, h, good), VTI_E_STEPPER, 'no such law')
        call expect_status(vti_drift(VTI_LAW_CAYLEY, 0_c_int, h, good, fault), VTI_E_FRAME, 'no such frame')
        call expect(fault%body == 0, 'no body is to blame for the frame')
        call expect_status(packed(1_c_int64_t, h, -n, n), VTI_E_COUNT, 'packed, a negative number of bodies')
        call expect_status(packed(1_c_int64_t, -h, n, n), VTI_E_TIME, 'packed, h < 0')
        call expect_status(packed(1_c_int64_t, h, n, n - 1), VTI_E_COUNT, 'packed, masses neither 1 nor n')
        call expect_status(packed(0_c_int64_t, h, n, n), VTI_E_STEPPER, 'packed, steppers count from 1')
        call expect_status(vti_packed_finish(0_c_int64_t, h, n, masses=1_c_int64_t, inertias=1_c_int64_t), &
            VTI_E_STEPPER, 'packed finish, steppers count from 1')
        call expect_status(vti_packed_begin(1_c_int64_t, h, n, x=s%x, masses=1_c_int64_t, inertias=1_c_int64_t), &
            VTI_OK, 'packed, what is left out is absent')
    end subroutine

    subroutine values()
        b = good
        b%mass = vti_scalars()
        call refused(VTI_E_MASS, 'no mass')
        s%mass(3) = -1
        call expect_status(vti_bodies_check_values(good, fault), VTI_E_MASS, 'a negative mass')
        call expect(fault%body == 3 .and. abs(fault%value + 1) <= 0, 'body 3 has it')
        call expect(vti_quantity_text(fault%quantity) == 'mass', 'and it is a mass')
        s%mass(3) = 1
        s%inertia(n) = not_a_number()
        call expect_status(vti_bodies_check_values(good, fault), VTI_E_INERTIA, 'an inertia that is no number')
        call expect(fault%body == n, 'the last body has it')
        s%inertia(n) = 1
        call expect_status(vti_bodies_check_values(good, fault), VTI_OK, 'mass and inertia are good again')
        call expect(fault%body == 0 .and. fault%quantity == VTI_QUANTITY_NONE, 'and no body is to blame')
        call states()
    end subroutine

    !> What is not finite before the first step is named.
    subroutine states()
        call not_finite(s%x(2, 4), VTI_QUANTITY_X)
        call not_finite(s%v(1, 4), VTI_QUANTITY_V)
        call not_finite(s%alpha(3, 4), VTI_QUANTITY_ALPHA)
        call not_finite(s%omega(2, 4), VTI_QUANTITY_OMEGA)
        b = good
        b%alpha = vti_view()
        b%quat = vti_quat_view_columns(s%quat)
        before = s
        s%quat(:, 4) = 0
        call expect_status(vti_bodies_check_values(b, fault), VTI_E_STATE, 'a quaternion of cleared memory')
        call expect(fault%body == 4 .and. fault%quantity == VTI_QUANTITY_QUAT, 'a quaternion of cleared memory is named')
        s = before
    end subroutine

    !> One number of body 4.
    subroutine not_finite(number, quantity)
        real(c_double), intent(inout) :: number
        integer(c_int64_t), intent(in) :: quantity
        real(c_double) :: keep
        keep = number
        number = not_a_number()
        call expect_status(vti_bodies_check_values(good, fault), VTI_E_STATE, vti_quantity_text(quantity)//' is no number')
        call expect(fault%body == 4 .and. fault%quantity == quantity, vti_quantity_text(quantity)//' of body 4 is named')
        number = keep
    end subroutine

    !> The bound of VTI-1: all or nothing, and the culprit counts from 1 through every door.
    subroutine too_large()
        s%omega(:, 5) = [0.0_c_double, 80.0_c_double, 0.0_c_double]
        s%omega(:, 2) = [0.0_c_double, 0.0_c_double, 70.0_c_double]
        before = s
        status = vti_step_begin(vti1, h, good, fault)
        call culprit(5_c_int64_t, 1.25_c_double, 'begin')
        status = vti_step_begin(vti1, h, vti_bodies_slice(good, 2_c_int64_t, 3_c_int64_t), fault)
        call culprit(2_c_int64_t, 1.09375_c_double, 'a slice')
        status = vti_drift(VTI_LAW_CLOSED, VTI_FRAME_SPACE, h, good, fault)
        call culprit(5_c_int64_t, 1.25_c_double, 'drift')
        status = packed(1_c_int64_t, h, n, n)
        fault = vti_fault(body, value, VTI_QUANTITY_OMEGA) ! which that door does not say
        call culprit(5_c_int64_t, 1.25_c_double, 'packed')
        call expect_status(vti_step_begin(vti1, h, good), VTI_E_TOO_LARGE, 'begin without a fault to fill')
        s%omega(1, 1) = not_a_number()
        before%omega(1, 1) = s%omega(1, 1)
        status = vti_step_begin(vti1, h, good, fault)
        call expect(status == VTI_E_TOO_LARGE .and. fault%body == 1, 'a body that is no number is named')
        s%omega(1, 1) = 0
        call expect_status(vti_step_begin(vti2, h, good, fault), VTI_OK, 'vti2 has no limit')
        call expect(.not. same_bits(s%x, before%x), 'and moves the bodies')
    end subroutine

    subroutine culprit(wanted, turn, what)
        integer(c_int64_t), intent(in) :: wanted
        real(c_double), intent(in) :: turn
        character(len=*), intent(in) :: what
        call expect_status(status, VTI_E_TOO_LARGE, 'too large, '//what)
        call expect(fault%body == wanted .and. abs(fault%value - turn) <= 0, 'the culprit, '//what)
        call expect(fault%quantity == VTI_QUANTITY_OMEGA, 'the spin of the culprit, '//what)
        call expect(same_bits(s%x, before%x) .and. same_bits(s%v, before%v) .and. same_bits(s%alpha, before%alpha) &
            .and. same_bits(s%omega, before%omega), 'nothing has changed, '//what)
    end subroutine

    !> Every door refuses b, and nothing has changed.
    subroutine refused(wanted, what)
        integer(c_int), intent(in) :: wanted
        character(len=*), intent(in) :: what
        before = s
        call expect_status(vti_bodies_check(b), wanted, what)
        call expect_status(vti_bodies_check_values(b), wanted, what//', with values')
        call expect_status(vti_kick(h, b), wanted, what//', kick')
        call expect_status(vti_drift(VTI_LAW_CAYLEY, VTI_FRAME_SPACE, h, b), wanted, what//', drift')
        call expect_status(vti_step_begin(vti1, h, b), wanted, what//', begin')
        call expect_status(vti_step_finish(vti1, h, b), wanted, what//', finish')
        call expect_status(vti_step_start(vti1, h, b), wanted, what//', start')
        call expect_status(vti_step_sync(vti1, h, b), wanted, what//', sync')
        call expect_status(vti_apply([vti_effect ::], b), wanted, what//', apply')
        call expect(same_bits(s%x, before%x) .and. same_bits(s%v, before%v) .and. same_bits(s%alpha, before%alpha) &
            .and. same_bits(s%omega, before%omega), what//', nothing has changed')
    end subroutine

    function packed(stepper, h, bodies, masses) result(status)
        integer(c_int64_t), intent(in) :: stepper, bodies, masses
        real(c_double), intent(in) :: h
        integer(c_int) :: status
        status = vti_packed_begin(stepper, h, bodies, s%x, s%v, force, s%alpha, s%omega, moment, masses, s%mass, n, &
            s%inertia, body, value)
    end function

    function not_a_number() result(r)
        real(c_double) :: r
        r = ieee_value(r, ieee_quiet_nan)
    end function
end program
