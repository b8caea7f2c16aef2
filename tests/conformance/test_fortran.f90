! SPDX-License-Identifier: BSD-3-Clause
!> Fortran arrays of any layout, and packed arrays, move as C moves them: the same bits after 1000 steps, for every
!> stepper of the library, and nothing else in the caller's arrays is touched.
program test_fortran
    use, intrinsic :: iso_c_binding, only: c_double, c_f_pointer, c_int, c_int64_t, c_loc, c_null_ptr
    use common
    implicit none

    !> A host's own type: vectors as members, among other things.
    type :: particle
        integer :: id
        real(c_double) :: radius, x(3), v(3), f(3), alpha(3), omega(3), m(3), mass, inertia
    end type

    integer(c_int64_t), parameter :: steps = 1000
    real(c_double), parameter :: h = 1.0_c_double/128, untouched = -7777
    type(vti_stepper) :: method
    type(state) :: alpha_run, quat_run
    integer(c_int64_t) :: k

    do k = 1, vti_stepper_count()
        method = vti_stepper_at(k)
        alpha_run = run_in_c(k, .true.)
        quat_run = run_in_c(k, .false.)
        call expect(.not. same_bits(alpha_run%omega, quat_run%omega), title()//'the two attitudes are two codes')
        call columns()
        call rows()
        call sections()
        call members()
        call quaternions()
        call slices()
        call packed(k)
    end do
    call watched()
    call controlled()
    call density()
    call multistep()
    call finish()

contains

    function title() result(text)
        character(len=:), allocatable :: text
        text = vti_text(method%name)//': '
    end function

    function run_in_c(k, as_alpha) result(s)
        integer(c_int64_t), intent(in) :: k
        logical, intent(in) :: as_alpha
        type(state), target :: s
        integer(c_int) :: status
        s = initial()
        if (as_alpha) then
            status = shim_run(k - 1, h, steps, n, c_loc(s%x), c_loc(s%v), c_loc(s%alpha), c_null_ptr, c_loc(s%omega), &
                c_loc(s%mass), c_loc(s%inertia))
        else
            status = shim_run(k - 1, h, steps, n, c_loc(s%x), c_loc(s%v), c_null_ptr, c_loc(s%quat), c_loc(s%omega), &
                c_loc(s%mass), c_loc(s%inertia))
        end if
        call expect_status(status, VTI_OK, title()//'the run in C')
    end function

    !> The loop of a host, over one or more slices of the same bodies.
    subroutine run(parts, what)
        type(vti_bodies), intent(in) :: parts(:)
        character(len=*), intent(in) :: what
        integer :: i, p
        integer(c_int64_t) :: stage
        integer(c_int) :: status
        type(vti_fault) :: fault
        do p = 1, size(parts)
            call expect_status(vti_bodies_check_values(parts(p)), VTI_OK, title()//what//', check')
            call shim_forces(parts(p))
            call expect_status(vti_step_start(method, h, parts(p)), VTI_OK, title()//what//', start')
        end do
        do i = 1, int(steps)
            do p = 1, size(parts)
                do stage = 0, method%stages - 1
                    if (stage == 0) status = vti_step_begin(method, h, parts(p), fault)
                    if (stage > 0) status = vti_step_stage(method, stage, h, parts(p), fault)
                    if (status /= VTI_OK) call expect_status(status, VTI_OK, title()//what//', stage')
                    call shim_forces(parts(p))
                end do
                status = vti_step_finish(method, h, parts(p))
                if (status /= VTI_OK) call expect_status(status, VTI_OK, title()//what//', finish')
            end do
        end do
        do p = 1, size(parts)
            call expect_status(vti_step_sync(method, h, parts(p)), VTI_OK, title()//what//', sync')
        end do
    end subroutine

    subroutine compare(x, v, alpha, omega, what)
        real(c_double), intent(in) :: x(:, :), v(:, :), alpha(:, :), omega(:, :)
        character(len=*), intent(in) :: what
        call expect(same_bits(x, alpha_run%x), title()//what//', x')
        call expect(same_bits(v, alpha_run%v), title()//what//', v')
        call expect(same_bits(alpha, alpha_run%alpha), title()//what//', alpha')
        call expect(same_bits(omega, alpha_run%omega), title()//what//', omega')
    end subroutine

    !> Views of the (3,n) arrays of s, with its alpha.
    function on_columns(s, force, moment) result(b)
        type(state), intent(in), target :: s
        real(c_double), intent(in), target :: force(3, n), moment(3, n)
        type(vti_bodies) :: b
        b = vti_bodies_none(n)
        b%x = vti_view_columns(s%x)
        b%v = vti_view_columns(s%v)
        b%force = vti_view_columns(force)
        b%alpha = vti_view_columns(s%alpha)
        b%omega = vti_view_columns(s%omega)
        b%moment = vti_view_columns(moment)
        b%mass = vti_scalars_array(s%mass)
        b%inertia = vti_scalars_array(s%inertia)
    end function

    subroutine columns()
        type(state), target :: s
        real(c_double), target :: force(3, n), moment(3, n)
        s = initial()
        call run([on_columns(s, force, moment)], 'columns')
        call compare(s%x, s%v, s%alpha, s%omega, 'columns')
    end subroutine

    !> A step of srkn11 whose error is estimated: by its weights, as read in Fortran.
    subroutine watched()
        type(state), target :: s
        real(c_double), target :: force(3, n), moment(3, n), sums(6, 2, n)
        real(c_double) :: expected(3, 2, n), velocity, spin
        real(c_double), pointer :: weight(:, :)
        type(vti_bodies) :: b
        type(vti_errors) :: errors
        integer(c_int64_t) :: j
        real(c_double), parameter :: long_step = 0.25_c_double ! whose error stands clear of rounding
        integer :: row
        s = initial()
        b = on_columns(s, force, moment)
        errors%memory = c_loc(sums)
        errors%rows = 2
        method = vti_stepper_find('srkn11')
        call c_f_pointer(method%estimate, weight, [method%stages + 1, method%estimates])
        expected = 0
        call shim_forces(b)
        do j = 0, method%stages
            call expect_status(vti_step_watch(method, j, long_step, b, errors), VTI_OK, 'watch')
            do row = 1, 2
                expected(:, row, :) = expected(:, row, :) &
                    + long_step*weight(j + 1, row)*force/spread(s%mass, 1, 3)
            end do
            if (j == method%stages) exit
            call expect_status(vti_step_stage(method, j, long_step, b), VTI_OK, 'stage')
            call shim_forces(b)
        end do
        call expect_status(vti_step_finish(method, long_step, b), VTI_OK, 'finish')
        call expect_status(vti_step_error(method, b, errors, velocity, spin), VTI_OK, 'error')
        call expect(abs(velocity - sqrt(maxval(sum(sum(expected**2, 1), 1)))) <= &
            1e-14_c_double + 1e-6_c_double*velocity, &
            'the estimate is that of the weights')
        call expect(velocity > 0 .and. spin > 0, 'both are estimated')
        call expect_status(vti_step_watch(vti_stepper_find('vti2'), 0_c_int64_t, h, b, errors), VTI_E_STEPPER, &
            'vti2 has no estimates')
    end subroutine

    !> A step by a tolerance: undone while it is too long, and forces are put back with the bodies; then one accepted.
    subroutine controlled()
        type(state), target :: s
        type(state) :: before
        real(c_double), target :: force(3, n), moment(3, n), sums(6, 2, n), memory(34, n)
        real(c_double) :: force_before(3, n), velocity, spin, tried
        type(vti_bodies) :: b
        type(vti_errors) :: errors
        type(vti_control) :: control
        type(vti_kept) :: kept
        integer(c_int64_t) :: accepted, j
        integer :: tries
        s = initial()
        b = on_columns(s, force, moment)
        errors%memory = c_loc(sums)
        errors%rows = 2
        kept%memory = c_loc(memory)
        kept%width = vti_step_keeps(b)
        call expect(kept%width == 18, 'x, v, alpha, omega, force and moment are kept')
        kept%width = 34
        method = vti_stepper_find('srkn11')
        call expect_status(vti_control_start(method, 1e-10_c_double, 0.5_c_double, control), VTI_OK, 'start')
        call shim_forces(b)
        before = s
        force_before = force
        accepted = 0
        tries = 0
        do while (accepted == 0 .and. tries < 20)
            tries = tries + 1
            tried = control%h
            call expect_status(vti_step_keep(b, kept), VTI_OK, 'keep')
            do j = 0, method%stages - 1
                call expect_status(vti_step_watch(method, j, tried, b, errors), VTI_OK, 'watch')
                call expect_status(vti_step_stage(method, j, tried, b), VTI_OK, 'stage')
                call shim_forces(b)
            end do
            call expect_status(vti_step_watch(method, method%stages, tried, b, errors), VTI_OK, 'watch')
            call expect_status(vti_step_finish(method, tried, b), VTI_OK, 'finish')
            call expect_status(vti_step_error(method, b, errors, velocity, spin), VTI_OK, 'error')
            call expect_status(vti_control_judge(control, tried, velocity, spin, accepted), VTI_OK, 'judge')
            if (accepted == 1) exit
            call expect(control%h < tried, 'the next try is shorter')
            call expect_status(vti_step_undo(b, kept), VTI_OK, 'undo')
            call expect(all(abs(s%x - before%x) <= 0) .and. all(abs(s%omega - before%omega) <= 0) &
                .and. all(abs(force - force_before) <= 0), 'all is put back')
        end do
        call expect(accepted == 1 .and. tries > 1 .and. control%rejected == tries - 1, 'it was too long, then not')
        call expect(max(velocity, spin) <= 1e-10_c_double, 'the error is below the tolerance')
        call expect_status(vti_control_start(vti_stepper_find('vti2'), 1e-3_c_double, h, control), VTI_E_STEPPER, &
            'vti2 has no estimates')
        call expect_status(vti_control_start(method, 0.0_c_double, h, control), VTI_E_CONTROL, 'no tolerance')
    end subroutine

    subroutine density()
        type(vti_density) :: d
        call expect_status(vti_density_start(0.5_c_double, 0.25_c_double, 8.0_c_double, d), VTI_OK, 'density')
        call expect(abs(d%h - 0.5_c_double/6) < 1e-15_c_double, 'h = epsilon/(1/s + epsilon G/2)')
        call expect_status(vti_density_next(d, -4.0_c_double), VTI_OK, 'next')
        call expect(abs(d%h - 0.125_c_double) < 1e-15_c_double, 'rho goes by epsilon G')
        call expect_status(vti_density_next(d, -80.0_c_double), VTI_E_TIME, 'no step comes out')
    end subroutine

    !> an4 from a start by srkn11: it tells by how much it corrects the velocity, and follows srkn11.
    subroutine multistep()
        type(state), target :: s, other
        real(c_double), target :: force(3, n), moment(3, n), memory(6, 4, n), force2(3, n), moment2(3, n)
        real(c_double) :: before(3, n), velocity, spin
        type(vti_bodies) :: b, c
        type(vti_past) :: past
        type(vti_multistep) :: an4
        integer :: i
        s = initial()
        other = s
        b = on_columns(s, force, moment)
        c = on_columns(other, force2, moment2)
        call shim_forces(b)
        call shim_forces(c)
        an4 = vti_multistep_find('an4')
        past%memory = c_loc(memory)
        past%depth = an4%depth
        method = vti_stepper_find('srkn11')
        do i = 1, 12
            call play(c)
            if (past%known < an4%depth) call expect_status(vti_multistep_record(past, b), VTI_OK, 'record')
            if (past%known < an4%depth) then
                call play(b)
                cycle
            end if
            call expect_status(vti_multistep_predict(an4, h, past, b), VTI_OK, 'predict')
            call shim_forces(b)
            before = s%v
            call expect_status(vti_multistep_error(an4, h, past, b, velocity, spin), VTI_OK, 'multistep error')
            call expect_status(vti_multistep_correct(an4, h, past, b), VTI_OK, 'correct')
            call expect(abs(velocity - sqrt(maxval(sum((s%v - before)**2, 1)))) < 1e-14_c_double .and. spin >= 0, &
                'the error is the correction')
        end do
        call expect(maxval(abs(s%v - other%v)) < 1e-6_c_double, 'an4 follows srkn11')
        call touch(s, b)
    end subroutine

    !> A pair that has met in the last step moves, and a wall that nothing met does not; momentum stays.
    subroutine touch(s, b)
        type(state), intent(inout) :: s
        type(vti_bodies), intent(in) :: b
        real(c_double), target :: before(3, n), diameter, plane(4, 1)
        real(c_double) :: velocity(3, n), stiffness
        integer(c_int64_t), target :: pair(2, 1)
        type(vti_contacts) :: contacts
        type(vti_walls) :: walls
        velocity = s%v
        before = s%x
        before(:, 1) = before(:, 1) + 0.5_c_double*h*(before(:, 1) - before(:, 2))
        diameter = (1 + 0.25_c_double*h)*norm2(s%x(:, 1) - s%x(:, 2))
        pair(:, 1) = [1, 2]
        plane(:, 1) = [0, 0, 1, -100]
        stiffness = 10
        contacts = vti_contacts_between(pair, vti_scalars_one(diameter), stiffness)
        walls = vti_walls_at(plane, vti_scalars_one(diameter), stiffness)
        call expect_status(vti_multistep_touch(h, vti_view_columns(before), b, walls=walls), VTI_OK, 'touch a wall')
        call expect(same_bits(s%v, velocity), 'no wall is near')
        call expect_status(vti_multistep_touch(h, vti_view_columns(before), b, contacts), VTI_OK, 'touch')
        velocity = s%v - velocity
        call expect(norm2(velocity(:, 1)) > 0 .and. all(abs(velocity(:, 3:)) <= 0), 'the pair is moved')
        call expect(norm2(s%mass(1)*velocity(:, 1) + s%mass(2)*velocity(:, 2)) < 1e-14_c_double, 'momentum is kept')
    end subroutine

    !> One step of method.
    subroutine play(b)
        type(vti_bodies), intent(in) :: b
        integer(c_int64_t) :: j
        do j = 0, method%stages - 1
            call expect_status(vti_step_stage(method, j, h, b), VTI_OK, 'stage')
            call shim_forces(b)
        end do
        call expect_status(vti_step_finish(method, h, b), VTI_OK, 'finish')
    end subroutine

    subroutine slices()
        type(state), target :: s
        real(c_double), target :: force(3, n), moment(3, n)
        type(vti_bodies) :: b
        s = initial()
        b = on_columns(s, force, moment)
        call run([vti_bodies_slice(b, 4_c_int64_t, n - 3), vti_bodies_slice(b, 1_c_int64_t, 3_c_int64_t)], 'slices')
        call compare(s%x, s%v, s%alpha, s%omega, 'slices')
    end subroutine

    subroutine rows()
        real(c_double), target :: x(n, 3), v(n, 3), force(n, 3), alpha(n, 3), omega(n, 3), moment(n, 3)
        real(c_double), target :: mass(n), inertia(n)
        type(state) :: s
        type(vti_bodies) :: b
        s = initial()
        x = transpose(s%x)
        v = transpose(s%v)
        alpha = transpose(s%alpha)
        omega = transpose(s%omega)
        mass = s%mass
        inertia = s%inertia
        b = vti_bodies_none(n)
        b%x = vti_view_separate(x(:, 1), x(:, 2), x(:, 3))
        b%v = vti_view_rows(v)
        b%force = vti_view_rows(force)
        b%alpha = vti_view_rows(alpha)
        b%omega = vti_view_rows(omega)
        b%moment = vti_view_rows(moment)
        b%mass = vti_scalars_array(mass)
        b%inertia = vti_scalars_array(inertia)
        call run([b], 'rows')
        call compare(transpose(x), transpose(v), transpose(alpha), transpose(omega), 'rows')
    end subroutine

    !> Every other column of a wider array, rows of a table with bounds of its own, arrays backwards.
    subroutine sections()
        real(c_double), target :: wide(3, 2*n), backward(n, 3), scalars(2, n), force(-1:1, n), moment(n, 3)
        real(c_double), allocatable, target :: table(:, :)
        type(state) :: s
        type(vti_bodies) :: b
        allocate (table(-4:6, 0:int(n) - 1))
        wide = untouched
        table = untouched
        s = initial()
        wide(:, 2::2) = s%x
        table(-3:-1, :) = s%v
        table(2:6:2, :) = s%alpha
        backward(n:1:-1, :) = transpose(s%omega)
        scalars(1, :) = s%mass
        scalars(2, :) = s%inertia
        b = vti_bodies_none(n)
        b%x = vti_view_columns(wide(:, 2::2))
        b%v = vti_view_columns(table(-3:-1, :))
        b%force = vti_view_columns(force(1:-1:-1, :))
        b%alpha = vti_view_columns(table(2:6:2, :))
        b%omega = vti_view_rows(backward(n:1:-1, :))
        b%moment = vti_view_rows(moment(:, 3:1:-1))
        b%mass = vti_scalars_member(c_loc(scalars(1, 1)), 16_c_int64_t)
        b%inertia = vti_scalars_member(c_loc(scalars(2, 1)), 16_c_int64_t)
        call run([b], 'sections')
        call compare(wide(:, 2::2), table(-3:-1, :), table(2:6:2, :), transpose(backward(n:1:-1, :)), 'sections')
        call expect(all(wide(:, 1::2) <= untouched) .and. all(table(-4, :) <= untouched) .and. &
            all(table(0:1, :) <= untouched) .and. all(table(3:5:2, :) <= untouched), title()//'sections, the rest')
    end subroutine

    subroutine members()
        type(particle), target :: p(n)
        integer(c_int64_t), parameter :: bytes = storage_size(p, c_int64_t)/8
        type(state) :: s
        type(vti_bodies) :: b
        integer :: i
        s = initial()
        do i = 1, int(n)
            p(i) = particle(i, untouched, s%x(:, i), s%v(:, i), 0, s%alpha(:, i), s%omega(:, i), 0, s%mass(i), &
                s%inertia(i))
        end do
        b = vti_bodies_none(n)
        b%x = vti_view_member(c_loc(p(1)%x), bytes)
        b%v = vti_view_member(c_loc(p(1)%v), bytes)
        b%force = vti_view_member(c_loc(p(1)%f), bytes)
        b%alpha = vti_view_member(c_loc(p(1)%alpha), bytes)
        b%omega = vti_view_member(c_loc(p(1)%omega), bytes)
        b%moment = vti_view_member(c_loc(p(1)%m), bytes)
        b%mass = vti_scalars_member(c_loc(p(1)%mass), bytes)
        b%inertia = vti_scalars_member(c_loc(p(1)%inertia), bytes)
        call run([b], 'members')
        do i = 1, int(n)
            s%x(:, i) = p(i)%x
            s%v(:, i) = p(i)%v
            s%alpha(:, i) = p(i)%alpha
            s%omega(:, i) = p(i)%omega
        end do
        call compare(s%x, s%v, s%alpha, s%omega, 'members')
        call expect(all(p%id == [(i, i=1, int(n))]) .and. all(p%radius <= untouched), title()//'members, the rest')
    end subroutine

    subroutine quaternions()
        type(state), target :: s, r
        real(c_double), target :: force(3, n), moment(3, n), quat(n, 4)
        type(vti_bodies) :: b
        s = initial()
        b = on_columns(s, force, moment)
        b%alpha = vti_view()
        b%quat = vti_quat_view_columns(s%quat)
        call run([b], 'quaternions')
        call expect(same_bits(s%quat, quat_run%quat), title()//'quaternions in columns')
        call expect(same_bits(s%omega, quat_run%omega), title()//'omega with quaternions in columns')
        r = initial()
        quat = transpose(r%quat)
        b = on_columns(r, force, moment)
        b%alpha = vti_view()
        b%quat = vti_quat_view_rows(quat)
        call run([b], 'quaternions')
        call expect(same_bits(transpose(quat), quat_run%quat), title()//'quaternions in rows')
    end subroutine

    !> Packed arrays know steppers of one stage and no start and sync.
    subroutine packed(k)
        integer(c_int64_t), intent(in) :: k
        type(state), target :: s
        real(c_double), target :: force(3, n), moment(3, n)
        type(vti_bodies) :: b
        integer(c_int) :: status(2)
        integer :: i
        if (method%stages /= 1 .or. abs(method%lag) > 0) return
        s = initial()
        b = on_columns(s, force, moment) ! for the forces
        call shim_forces(b)
        do i = 1, int(steps)
            status(1) = vti_packed_begin(k, h, n, s%x, s%v, force, s%alpha, s%omega, moment, n, s%mass, n, s%inertia)
            call shim_forces(b)
            status(2) = vti_packed_finish(k, h, n, s%v, force, s%omega, moment, n, s%mass, n, s%inertia)
            if (any(status /= VTI_OK)) call expect(.false., title()//'packed: '//vti_status_text(minval(status)))
        end do
        call compare(s%x, s%v, s%alpha, s%omega, 'packed')
    end subroutine
end program
