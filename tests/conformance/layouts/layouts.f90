! SPDX-License-Identifier: BSD-3-Clause
!> The scene of test_layouts.py in Fortran: (3,n), (n,3), sections, members of a derived type, the packed door, slices.
!> layouts_fortran TABLE
program layouts
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_loc
    use, intrinsic :: iso_fortran_env, only: error_unit
    use vti
    implicit none

    type :: sphere
        integer :: id
        real(c_double) :: x(3), v(3), alpha(3), omega(3), force(3), moment(3), mass, inertia
    end type

    integer(c_int64_t) :: n, steps
    integer(c_int64_t), allocatable, target :: pair(:, :)
    real(c_double) :: h
    real(c_double), target :: stiffness(4)
    real(c_double), allocatable, target :: plane(:, :), body(:, :), rest(:, :), diameter(:), mass(:), inertia(:)
    integer(c_int64_t) :: parts(3)
    integer :: k

    call read_table()
    parts = [1_c_int64_t, 3_c_int64_t, n]
    do k = 1, 3
        call columns(parts(k))
        call rows(parts(k))
        call sections(parts(k))
        call members(parts(k))
    end do
    call packed()

contains

    subroutine read_table()
        character(len=4096) :: path
        integer(c_int64_t) :: bonds, planes
        integer :: unit
        call get_command_argument(1, path)
        open (newunit=unit, file=trim(path), status='old', action='read')
        read (unit, *) n, bonds, planes, steps, h
        allocate (plane(4, planes), body(15, n), pair(2, bonds), rest(4, bonds))
        read (unit, *) stiffness
        if (planes > 0) read (unit, *) plane
        read (unit, *) body
        read (unit, *) pair
        close (unit)
        pair = pair + 1
        mass = body(13, :)
        inertia = body(14, :)
        diameter = body(15, :)
    end subroutine

    subroutine must(status)
        integer(c_int), intent(in) :: status
        if (status == VTI_OK) return
        write (error_unit, '(2a)') 'layouts_fortran: ', vti_status_text(status)
        stop 1
    end subroutine

    !> Bodies whose vectors are still to be viewed.
    function start() result(b)
        type(vti_bodies) :: b
        b = vti_bodies_none(n)
        b%mass = vti_scalars_array(mass)
        b%inertia = vti_scalars_array(inertia)
    end function

    subroutine run(b, slices)
        type(vti_bodies), intent(in) :: b
        integer(c_int64_t), intent(in) :: slices
        type(vti_bonds), target :: bonds
        type(vti_walls), target :: walls
        integer(c_int64_t) :: step
        call must(vti_bodies_check_values(b))
        call scene(b, bonds, walls)
        call forces(b, bonds, walls)
        do step = 1, steps
            call half(1, b, slices)
            call forces(b, bonds, walls)
            call half(2, b, slices)
        end do
    end subroutine

    !> The first or the second half of a step of each slice.
    subroutine half(which, b, slices)
        integer, intent(in) :: which
        type(vti_bodies), intent(in) :: b
        integer(c_int64_t), intent(in) :: slices
        type(vti_bodies) :: part
        type(vti_stepper) :: method
        integer(c_int64_t) :: s, first, next
        method = vti_stepper_find('vti2')
        do s = 0, slices - 1
            first = n*s/slices
            next = n*(s + 1)/slices
            part = vti_bodies_slice(b, first + 1, next - first)
            if (which == 1) call must(vti_step_begin(method, h, part))
            if (which == 2) call must(vti_step_finish(method, h, part))
        end do
    end subroutine

    subroutine scene(b, bonds, walls)
        type(vti_bodies), intent(in) :: b
        type(vti_bonds), intent(out) :: bonds
        type(vti_walls), intent(out) :: walls
        call must(vti_bonds_rest(pair, b, rest))
        bonds = vti_bonds_between(pair, rest)
        bonds%moment = vti_scalars_one(stiffness(1))
        bonds%axial = vti_scalars_one(stiffness(2))
        bonds%shear = vti_scalars_one(stiffness(3))
        call must(vti_bonds_check(bonds, n))
        walls = vti_walls_at(plane, vti_scalars_array(diameter), stiffness(4))
    end subroutine

    subroutine forces(b, bonds, walls)
        type(vti_bodies), intent(in) :: b
        type(vti_bonds), intent(in), target :: bonds
        type(vti_walls), intent(in), target :: walls
        if (walls%count > 0) then
            call must(vti_apply([vti_bonds_effect(bonds), vti_walls_effect(walls)], b))
        else
            call must(vti_apply([vti_bonds_effect(bonds)], b))
        end if
    end subroutine

    subroutine report(name, slices, x, v, alpha, omega)
        character(len=*), intent(in) :: name
        integer(c_int64_t), intent(in) :: slices
        real(c_double), intent(in) :: x(:, :), v(:, :), alpha(:, :), omega(:, :)
        integer :: i
        print '(3a, i0, a)', '= ', name, ', ', slices, ' slices'
        do i = 1, int(n)
            print '(12es25.16e3)', x(:, i), v(:, i), alpha(:, i), omega(:, i)
        end do
    end subroutine

    subroutine columns(slices)
        integer(c_int64_t), intent(in) :: slices
        real(c_double), dimension(3, n), target :: x, v, alpha, omega, force, moment
        type(vti_bodies) :: b
        x = body(1:3, :)
        v = body(4:6, :)
        alpha = body(7:9, :)
        omega = body(10:12, :)
        b = start()
        b%x = vti_view_columns(x)
        b%v = vti_view_columns(v)
        b%alpha = vti_view_columns(alpha)
        b%omega = vti_view_columns(omega)
        b%force = vti_view_columns(force)
        b%moment = vti_view_columns(moment)
        call run(b, slices)
        call report('(3,n)', slices, x, v, alpha, omega)
    end subroutine

    subroutine rows(slices)
        integer(c_int64_t), intent(in) :: slices
        real(c_double), dimension(n, 3), target :: x, v, alpha, omega, force, moment
        type(vti_bodies) :: b
        x = transpose(body(1:3, :))
        v = transpose(body(4:6, :))
        alpha = transpose(body(7:9, :))
        omega = transpose(body(10:12, :))
        b = start()
        b%x = vti_view_rows(x)
        b%v = vti_view_rows(v)
        b%alpha = vti_view_rows(alpha)
        b%omega = vti_view_rows(omega)
        b%force = vti_view_rows(force)
        b%moment = vti_view_rows(moment)
        call run(b, slices)
        call report('(n,3)', slices, transpose(x), transpose(v), transpose(alpha), transpose(omega))
    end subroutine

    !> Rows of one table, every other row of a longer array, arrays backwards.
    subroutine sections(slices)
        integer(c_int64_t), intent(in) :: slices
        real(c_double), target :: table(15, n), v(2*n, 3), omega(n, 3), loads(0:6, n)
        type(vti_bodies) :: b
        table = body
        v = 0
        v(2::2, :) = transpose(body(4:6, :))
        omega(n:1:-1, :) = transpose(body(10:12, :))
        b = start()
        b%x = vti_view_columns(table(1:3, :))
        b%v = vti_view_rows(v(2::2, :))
        b%alpha = vti_view_columns(table(7:9, :))
        b%omega = vti_view_rows(omega(n:1:-1, :))
        b%force = vti_view_columns(loads(5:1:-2, :))
        b%moment = vti_view_columns(loads(0:4:2, :))
        call run(b, slices)
        call report('sections', slices, table(1:3, :), transpose(v(2::2, :)), table(7:9, :), transpose(omega(n:1:-1, :)))
    end subroutine

    subroutine members(slices)
        integer(c_int64_t), intent(in) :: slices
        type(sphere), target :: s(n)
        type(vti_bodies) :: b
        integer(c_int64_t) :: bytes
        real(c_double) :: last(12, n)
        integer :: i
        bytes = storage_size(s, c_int64_t)/8
        do i = 1, int(n)
            s(i) = sphere(i, body(1:3, i), body(4:6, i), body(7:9, i), body(10:12, i), 0, 0, mass(i), inertia(i))
        end do
        b = vti_bodies_none(n)
        b%x = vti_view_member(c_loc(s(1)%x), bytes)
        b%v = vti_view_member(c_loc(s(1)%v), bytes)
        b%alpha = vti_view_member(c_loc(s(1)%alpha), bytes)
        b%omega = vti_view_member(c_loc(s(1)%omega), bytes)
        b%force = vti_view_member(c_loc(s(1)%force), bytes)
        b%moment = vti_view_member(c_loc(s(1)%moment), bytes)
        b%mass = vti_scalars_member(c_loc(s(1)%mass), bytes)
        b%inertia = vti_scalars_member(c_loc(s(1)%inertia), bytes)
        call run(b, slices)
        do i = 1, int(n)
            last(:, i) = [s(i)%x, s(i)%v, s(i)%alpha, s(i)%omega]
        end do
        call report('members of a derived type', slices, last(1:3, :), last(4:6, :), last(7:9, :), last(10:12, :))
    end subroutine

    !> The packed door moves the bodies; the effects have views of the same arrays.
    subroutine packed()
        real(c_double), dimension(3, n), target :: x, v, alpha, omega, force, moment
        type(vti_bodies) :: b
        type(vti_bonds), target :: bonds
        type(vti_walls), target :: walls
        integer(c_int64_t) :: step
        x = body(1:3, :)
        v = body(4:6, :)
        alpha = body(7:9, :)
        omega = body(10:12, :)
        b = vti_bodies_none(n)
        b%x = vti_view_columns(x)
        b%alpha = vti_view_columns(alpha)
        b%force = vti_view_columns(force)
        b%moment = vti_view_columns(moment)
        call scene(b, bonds, walls)
        call forces(b, bonds, walls)
        do step = 1, steps
            call must(vti_packed_begin(2_c_int64_t, h, n, x, v, force, alpha, omega, moment, n, mass, n, inertia))
            call forces(b, bonds, walls)
            call must(vti_packed_finish(2_c_int64_t, h, n, v, force, omega, moment, n, mass, n, inertia))
        end do
        call report('the packed door', 1_c_int64_t, x, v, alpha, omega)
    end subroutine
end program
