! SPDX-License-Identifier: BSD-3-Clause
!> What hosts call that do a step's work in parts: the passes of bonds, lists for a slice, a step's end and the next
!> one's start at once, stages and drifts of their own, a restart with what touches hold. Each against the plain way, to
!> the bit.
program test_fortran_calls
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_loc
    use common, only: expect, expect_status, finish, same_bits
    use lattice
    use vti
    implicit none

    integer, parameter :: block(3) = [5, 4, 3]
    integer(c_int64_t), parameter :: n = product(block)
    type(crowd), target :: c
    real(c_double), target :: force(3, n), moment(3, n), stiffness(3)
    integer(c_int64_t), pointer, contiguous :: pair(:, :)
    real(c_double), pointer, contiguous :: rest(:, :)
    type(vti_bonds), target :: bonds
    type(vti_gravity), target :: gravity
    type(vti_effect) :: effects(2)
    type(vti_bodies) :: b

    stiffness = bond_energy
    gravity%g = [0.125_c_double, -0.25_c_double, -1.0_c_double]
    c = new_crowd(block)
    b = bodies_of(c)
    pair => c%pair
    rest => c%rest
    call expect_status(vti_bonds_rest(c%pair, b, c%rest), VTI_OK, 'rest')
    c%x = c%x + c%v/8 ! so that bonds pull
    c%alpha = c%omega/8
    bonds = bonds_of(pair, rest)
    effects = [vti_bonds_effect(bonds), vti_gravity_effect(gravity)]
    call passes()
    call slices()
    call next()
    call stages()
    call drifts()
    call walls()
    call increments()
    call methods()
    call finish()

contains

    function bodies_of(c) result(b)
        type(crowd), intent(in), target :: c
        type(vti_bodies) :: b
        b = vti_bodies_none(n)
        b%x = vti_view_columns(c%x)
        b%v = vti_view_columns(c%v)
        b%alpha = vti_view_columns(c%alpha)
        b%omega = vti_view_columns(c%omega)
        b%force = vti_view_columns(force)
        b%moment = vti_view_columns(moment)
        b%mass = vti_scalars_array(c%mass)
        b%inertia = vti_scalars_array(c%inertia)
    end function

    function bonds_of(pair, rest) result(bonds)
        integer(c_int64_t), pointer, contiguous, intent(in) :: pair(:, :)
        real(c_double), pointer, contiguous, intent(in) :: rest(:, :)
        type(vti_bonds) :: bonds
        bonds = vti_bonds_between(pair, rest)
        bonds%moment = vti_scalars_one(stiffness(1))
        bonds%axial = vti_scalars_one(stiffness(2))
        bonds%shear = vti_scalars_one(stiffness(3))
    end function

    !> Loads of two ranges of bonds, then their sums for two slices of the bodies.
    subroutine passes()
        real(c_double) :: loads(VTI_BOND_LOADS, bonds%count), f(3, n), t(3, n)
        integer(c_int64_t) :: first(2), last(2)
        type(vti_bodies) :: part
        integer :: i, k
        call expect_status(vti_apply(effects(1:1), b), VTI_OK, 'bonds at once')
        f = force
        t = moment
        first = [1_c_int64_t, bonds%count/3 + 1]
        last = [bonds%count/3, bonds%count]
        do k = 2, 1, -1
            call expect_status(vti_bonds_loads(bonds, b, first(k), last(k), loads(:, first(k):last(k))), VTI_OK, &
                'loads')
        end do
        force = 0
        moment = 0
        do k = 1, 2
            part = vti_bodies_slice(b, merge(1_c_int64_t, 20_c_int64_t, k == 1), merge(19_c_int64_t, n - 19, k == 1))
            do i = 1, 2
                call expect_status(vti_bonds_sum(bonds, loads(:, first(i):last(i)), first(i), last(i), part), VTI_OK, &
                    'sum')
            end do
        end do
        call expect(same_bits(force, f) .and. same_bits(moment, t), 'two passes are the effect')
        call expect(norm2(f) > 1 .and. norm2(t) > 1, 'bonds that pull and twist')
        call expect_status(vti_bonds_loads(bonds, b, 1_c_int64_t, 2_c_int64_t, loads), VTI_E_COUNT, 'loads of others')
        call expect_status(vti_bonds_sum(bonds, loads(2:, :2), 1_c_int64_t, 2_c_int64_t, b), VTI_E_COUNT, &
            'parts of loads')
        call expect_status(vti_bonds_loads(bonds, b, bonds%count, bonds%count + 1, loads(:, :2)), VTI_E_COUNT, &
            'a bond that there is not')
    end subroutine

    !> The bonds that act on a slice, counted by hand; they alone give it its loads.
    subroutine slices()
        integer(c_int64_t), parameter :: first(3) = [1, 23, int(n)], bodies(3) = [4, 17, 1]
        integer(c_int64_t), allocatable :: which(:), by_hand(:)
        integer(c_int64_t), allocatable, target :: few(:, :)
        real(c_double), allocatable, target :: few_rest(:, :)
        integer(c_int64_t), pointer, contiguous :: of(:, :)
        real(c_double), pointer, contiguous :: at(:, :)
        type(vti_bonds), target :: part
        real(c_double) :: f(3, n)
        integer(c_int64_t) :: last, k
        integer :: s
        call expect_status(vti_apply(effects(1:1), b), VTI_OK, 'all bonds')
        f = force
        do s = 1, 3
            last = first(s) + bodies(s) - 1
            which = vti_pairs_of_slice(c%pair, first(s), bodies(s))
            by_hand = pack([(k, k=1, bonds%count)], any(c%pair >= first(s) .and. c%pair <= last, 1))
            call expect(size(which) == size(by_hand) .and. size(which) > 0, 'how many pairs a slice has')
            if (size(which) /= size(by_hand)) cycle
            call expect(all(which == by_hand), 'the pairs of a slice')
            few = c%pair(:, which)
            few_rest = c%rest(:, which)
            of => few
            at => few_rest
            part = bonds_of(of, at)
            force = 7
            call expect_status(vti_apply([vti_bonds_effect(part)], vti_bodies_slice(b, first(s), bodies(s))), VTI_OK, &
                'bonds of a slice')
            call expect(same_bits(force(:, first(s):last), f(:, first(s):last)), 'loads of a slice')
        end do
        call expect(size(vti_pairs_of_slice(c%pair(1:1, :), 1_c_int64_t, n)) == 0, 'pairs of one body each')
    end subroutine

    !> Three steps, whose ends and starts are one call or two.
    subroutine next()
        type(crowd), target :: one, two
        type(vti_bodies) :: of_one, of_two
        type(vti_stepper) :: method
        type(vti_fault) :: fault
        integer :: k
        one = c
        two = c
        of_one = bodies_of(one)
        of_two = bodies_of(two)
        method = vti_stepper_find('vti2')
        do k = 1, 3
            call expect_status(vti_apply(effects, of_two), VTI_OK, 'apply')
            call expect_status(vti_step_begin(method, h, of_two), VTI_OK, 'begin')
            call expect_status(vti_apply(effects, of_two), VTI_OK, 'apply')
            call expect_status(vti_step_finish(method, h, of_two), VTI_OK, 'finish')
        end do
        call expect_status(vti_apply(effects, of_one), VTI_OK, 'apply')
        call expect_status(vti_step_begin(method, h, of_one), VTI_OK, 'begin')
        do k = 1, 2
            call expect_status(vti_apply(effects, of_one), VTI_OK, 'apply')
            call expect_status(vti_step_next(method, h, of_one, fault), VTI_OK, 'next')
        end do
        call expect_status(vti_apply(effects, of_one), VTI_OK, 'apply')
        call expect_status(vti_step_finish(method, h, of_one), VTI_OK, 'finish')
        call compare(two, one%x, one%v, one%alpha, one%omega, two%rest, 'next')
        call expect_status(vti_step_next(vti_stepper_find('srkn14'), h, of_one), VTI_E_STAGE, 'a drift at the end')
        one%omega(:, 9) = 2/h
        call expect_status(vti_step_next(vti_stepper_find('vti1'), h, of_one, fault), VTI_E_TOO_LARGE, &
            'a turn too large')
        call expect(fault%body == 9, 'of the ninth body')
    end subroutine

    !> A step of several stages with effects that do not flow is that without them.
    subroutine stages()
        type(crowd), target :: one, two
        type(vti_bodies) :: of_one, of_two
        type(vti_stepper) :: method
        integer(c_int64_t) :: k
        one = c
        two = c
        of_one = bodies_of(one)
        of_two = bodies_of(two)
        method = vti_stepper_find('srkn6')
        call expect_status(vti_apply(effects, of_one), VTI_OK, 'apply')
        do k = 0, method%stages - 1
            call expect_status(vti_effects_stage(method, k, h, effects, of_one), VTI_OK, 'stage of effects')
            call expect_status(vti_apply(effects, of_one), VTI_OK, 'apply')
        end do
        call expect_status(vti_effects_finish(method, h, effects, of_one), VTI_OK, 'end of effects')
        call expect_status(vti_apply(effects, of_two), VTI_OK, 'apply')
        do k = 0, method%stages - 1
            call expect_status(vti_step_stage(method, k, h, of_two), VTI_OK, 'stage')
            call expect_status(vti_apply(effects, of_two), VTI_OK, 'apply')
        end do
        call expect_status(vti_step_finish(method, h, of_two), VTI_OK, 'end')
        call compare(two, one%x, one%v, one%alpha, one%omega, two%rest, 'stages')
        call expect_status(vti_effects_stage(method, method%stages, h, effects, of_one), VTI_E_STAGE, &
            'a stage too many')
    end subroutine

    !> A host's own kick and drift with friction, which it tells of the drift, is vti_effects_begin; and a history that
    !> is put together anew, entry by entry, goes on as the one that was there.
    subroutine drifts()
        type(crowd), target :: one, two
        type(vti_bodies) :: of_one, of_two
        type(vti_stepper) :: method
        type(vti_contacts), target :: contacts
        type(vti_friction), target :: friction, again
        type(vti_history), target :: history, other
        type(vti_held), target :: held(256), others(256)
        integer(c_int64_t), target :: slot(256), slots(256)
        type(vti_sum), target :: lost(3), lost_again(3)
        type(vti_effect) :: mine(2), theirs(2)
        integer(c_int64_t) :: k
        one = c
        two = c
        of_one = bodies_of(one)
        of_two = bodies_of(two)
        method = vti_stepper_find('vti2')
        slot = 0
        slots = 0
        contacts = vti_contacts_between(pair, vti_scalars_array(c%diameter), 80.0_c_double)
        history = vti_history(slots=256, held=c_loc(held), slot=c_loc(slot))
        other = vti_history(slots=256, held=c_loc(others), slot=c_loc(slots))
        friction%contacts = c_loc(contacts)
        friction%sliding = 0.5_c_double
        friction%mindlin = 0.8_c_double
        friction%reach = huge(1.0_c_double)
        friction%history = c_loc(history)
        friction%lost = c_loc(lost)
        again = friction
        again%history = c_loc(other)
        again%lost = c_loc(lost_again)
        mine = [vti_contacts_effect(contacts), vti_friction_effect(friction)]
        theirs = [vti_contacts_effect(contacts), vti_friction_effect(again)]

        call step(method, theirs, of_two)
        call expect_status(vti_apply(mine, of_one), VTI_OK, 'apply')
        call expect_status(vti_kick(h/2, of_one), VTI_OK, 'kick')
        call expect_status(vti_drift(int(method%law, c_int), int(method%frame, c_int), h, of_one), VTI_OK, 'drift')
        call expect_status(vti_effects_carry(mine, vti_drifted(t=h, law=method%law, frame=method%frame), of_one), &
            VTI_OK, 'carry')
        call expect_status(vti_apply(mine, of_one), VTI_OK, 'apply')
        call expect_status(vti_kick(h/2, of_one), VTI_OK, 'kick')
        call compare(two, one%x, one%v, one%alpha, one%omega, two%rest, 'friction by hand')
        call expect(history%used > 3 .and. history%used == other%used, 'touches that hold something')
        call expect_status(vti_effects_carry(mine, vti_drifted(t=h, frame=VTI_FRAME_BODY), of_one), VTI_E_FRAME, &
            'a drift in the frame of the bodies')

        others = vti_held()
        slots = 0
        other = vti_history(slots=256, held=c_loc(others), slot=c_loc(slots))
        do k = history%used, 1, -1
            call expect_status(vti_history_add(other, held(k)), VTI_OK, 'what a touch holds')
        end do
        call expect(other%used == history%used, 'all of it')
        call expect_status(vti_history_add(other, vti_held(i=0, j=1)), VTI_E_HISTORY, 'of body 0')
        call expect_status(vti_history_add(other, vti_held(i=3, j=3)), VTI_E_HISTORY, 'of a body and itself')
        call expect(other%used == history%used, 'nothing is added then')
        call step(method, mine, of_one)
        call step(method, theirs, of_two)
        call compare(two, one%x, one%v, one%alpha, one%omega, two%rest, 'a history anew')
        call expect(maxval(abs(one%v - c%v)) > 1e-3_c_double, 'contacts that push')
    end subroutine

    subroutine step(method, effects, b)
        type(vti_stepper), intent(in) :: method
        type(vti_effect), intent(in) :: effects(:)
        type(vti_bodies), intent(in) :: b
        call expect_status(vti_apply(effects, b), VTI_OK, 'apply')
        call expect_status(vti_effects_begin(method, h, effects, b), VTI_OK, 'begin')
        call expect_status(vti_apply(effects, b), VTI_OK, 'apply')
        call expect_status(vti_effects_finish(method, h, effects, b), VTI_OK, 'finish')
    end subroutine

    subroutine walls()
        type(vti_walls) :: of
        type(vti_fault) :: fault
        real(c_double), target :: plane(4, 2)
        real(c_double), pointer, contiguous :: planes(:, :)
        plane = reshape([1.0_c_double, 0.0_c_double, 0.0_c_double, -2.0_c_double, &
            0.0_c_double, 0.6_c_double, 0.8_c_double, -2.0_c_double], [4, 2])
        planes => plane
        of = vti_walls_at(planes, vti_scalars_array(c%diameter), 90.0_c_double)
        call expect_status(vti_walls_check(of, n, fault), VTI_OK, 'walls')
        call expect(fault%body == 0, 'nothing is wrong with them')
        call expect_status(vti_walls_check(of, n + 1), VTI_E_CONTACT, 'walls of more bodies than there are')
        plane(2, 2) = 0.5_c_double
        call expect_status(vti_walls_check(of, n, fault), VTI_E_CONTACT, 'a normal too short')
        call expect(fault%body == 2, 'of the second wall')
    end subroutine

    !> What a drift turns by: t Omega by Cayley's law, 2 t Omega/(1 + sqrt(1 - s^2)) by the closed one, for which s < 1.
    subroutine increments()
        real(c_double) :: omega(3), dalpha(3)
        omega = [0.5_c_double, -0.25_c_double, 1.0_c_double]
        call vti_drift_increment(VTI_LAW_CAYLEY, 0.5_c_double, omega, dalpha)
        call expect(same_bits(dalpha, 0.5_c_double*omega), 'increment by Cayley''s law')
        call vti_drift_increment(VTI_LAW_CLOSED, 0.5_c_double, omega, dalpha)
        call expect(all(abs(dalpha - omega/(1 + sqrt(1 - sum((0.5_c_double*omega)**2)))) < 1e-15_c_double), &
            'increment by the closed law')
        call vti_drift_increment(VTI_LAW_CLOSED, 1.0_c_double, omega, dalpha)
        call expect(same_bits(dalpha, 2*omega), 'a turn that the closed law does not have')
    end subroutine

    !> The list of multistep methods is those that are found by name.
    subroutine methods()
        type(vti_multistep) :: at, found
        integer(c_int64_t) :: k
        call expect(vti_multistep_count() > 3, 'how many multistep methods there are')
        do k = 1, vti_multistep_count()
            at = vti_multistep_at(k)
            found = vti_multistep_find(vti_text(at%name))
            call expect(at%depth > 0 .and. at%depth == found%depth .and. same_bits([at%c, at%u, at%reach], &
                [found%c, found%u, found%reach]), vti_text(at%name)//' by its number and by its name')
        end do
        at = vti_multistep_at(1_c_int64_t)
        call expect(vti_text(at%name) == 'an4', 'the first is an4')
        at = vti_multistep_at(vti_multistep_count() + 1)
        found = vti_multistep_at(0_c_int64_t)
        call expect(at%depth == 0 .and. found%depth == 0, 'numbers of none')
    end subroutine
end program
