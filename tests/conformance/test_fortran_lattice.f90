! SPDX-License-Identifier: BSD-3-Clause
!> Every effect from Fortran, on arrays of any layout: a chain and a block of bonded spheres are after 1000 steps where the
!> same run in C puts them, to the last bit, and so are rest vectors, energies and the stable step.
program test_fortran_lattice
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_int, c_int64_t, c_loc
    use common, only: expect, expect_status, finish, same_bits
    use lattice
    use vti
    implicit none

    type :: sphere
        integer :: id
        real(c_double) :: x(3), v(3), f(3), alpha(3), omega(3), m(3), mass, inertia, diameter
    end type

    integer, parameter :: chain(3) = [10, 1, 1], block(3) = [7, 6, 5]
    real(c_double), parameter :: planes(4, 2) = reshape([1.0_c_double, 0.0_c_double, 0.0_c_double, -0.25_c_double, &
        0.0_c_double, 0.6_c_double, 0.8_c_double, -0.25_c_double], [4, 2])
    character(len=6), parameter :: names(3) = ['vti2  ', 'vti1  ', 'srkn14']
    integer :: k

    do k = 1, size(names)
        call layouts(trim(names(k)), chain, 'chain')
    end do
    call layouts('vti2', block, 'block')
    call finish()

contains

    subroutine layouts(name, counts, what)
        character(len=*), intent(in) :: name, what
        integer, intent(in) :: counts(3)
        type(crowd) :: theirs
        character(len=:), allocatable :: title
        theirs = run_in_c(name, counts, 5)
        title = name//', '//what
        call columns(name, counts, theirs, title)
        call sections(name, counts, theirs, title)
        call members(name, counts, theirs, title)
        if (name == 'vti2') call packed(counts, theirs, title)
    end subroutine

    !> The loop of a host with all five effects; rest and results become what the C side gives.
    subroutine run(name, bodies, diameter, pair, rest, results, title)
        character(len=*), intent(in) :: name, title
        type(vti_bodies), intent(in) :: bodies
        type(vti_scalars), intent(in) :: diameter
        integer(c_int64_t), intent(in), target, contiguous :: pair(:, :)
        real(c_double), intent(inout), target, contiguous :: rest(:, :)
        real(c_double), intent(out) :: results(4)
        real(c_double), target :: stiffness(3), plane(4, 2)
        type(vti_bonds), target :: bonds
        type(vti_contacts), target :: contacts
        type(vti_walls), target :: walls
        type(vti_gravity), target :: gravity
        type(vti_pendulum), target :: pendulum
        type(vti_effect) :: effects(5)
        type(vti_stepper) :: method
        type(vti_fault) :: fault
        real(c_double), allocatable :: scratch(:)
        integer :: i
        integer(c_int64_t) :: stage
        integer(c_int) :: status
        type(vti_stable) :: stable

        stiffness = bond_energy
        plane = planes
        call expect_status(vti_bonds_rest(pair, bodies, rest, fault), VTI_OK, title//', rest')
        bonds = vti_bonds_between(pair, rest)
        bonds%moment = vti_scalars_one(stiffness(1))
        bonds%axial = vti_scalars_one(stiffness(2))
        bonds%shear = vti_scalars_one(stiffness(3))
        call expect_status(vti_bonds_check(bonds, bodies%count, fault), VTI_OK, title//', bonds')
        contacts = vti_contacts_between(pair, diameter, 80.0_c_double)
        walls = vti_walls_at(plane, diameter, 90.0_c_double)
        gravity%g = [0.125_c_double, -0.25_c_double, -1.0_c_double]
        pendulum = vti_pendulum(0.5_c_double, [0.25_c_double, -0.5_c_double, 0.75_c_double])
        effects = [vti_bonds_effect(bonds), vti_contacts_effect(contacts), vti_walls_effect(walls), &
            vti_gravity_effect(gravity), vti_pendulum_effect(pendulum)]
        allocate (scratch(bodies%count))
        call expect_status(vti_stable_step(effects, bodies, scratch, stable, vti_deformation(0.25_c_double, 0.125_c_double, 1)), &
            VTI_OK, title//', stable step')
        results(1) = stable%h

        method = vti_stepper_find(name)
        call expect_status(vti_step_check(method, effects), VTI_OK, title//', step check')
        status = vti_apply(effects, bodies)
        do i = 1, int(steps)
            do stage = 0, method%stages - 1
                if (status == VTI_OK) status = vti_step_stage(method, stage, h, bodies, fault)
                if (status == VTI_OK) status = vti_apply(effects, bodies)
            end do
            if (status == VTI_OK) status = vti_step_finish(method, h, bodies)
        end do
        call expect_status(status, VTI_OK, title//', steps')
        results(2) = vti_energy(effects, bodies)
        results(3:4) = energies_of(effects(1), bodies)
    end subroutine

    !> Energies 2 and 3 of an effect: axial and shear of the bonds.
    function energies_of(effect, bodies) result(two)
        use, intrinsic :: iso_c_binding, only: c_f_procpointer, c_ptr
        type(vti_effect), intent(in) :: effect
        type(vti_bodies), intent(in) :: bodies
        real(c_double) :: two(2), all_terms(VTI_TERMS)
        interface
            subroutine energy_of(self, bodies, energies) bind(c)
                import :: c_double, c_ptr, vti_bodies
                type(c_ptr), value :: self
                type(vti_bodies), intent(in) :: bodies
                real(c_double), intent(inout) :: energies(*)
            end subroutine
        end interface
        procedure(energy_of), pointer :: energy
        all_terms = 0
        call c_f_procpointer(effect%energy, energy)
        call energy(effect%self, bodies, all_terms)
        two = all_terms(2:3)
    end function

    subroutine same_results(c, results, title)
        type(crowd), intent(in) :: c
        real(c_double), intent(in) :: results(4)
        character(len=*), intent(in) :: title
        call expect(same_bits(results, c%results), title//', stable step and energies')
        call expect(results(1) > h .and. minval(abs(results(2:4))) > 1e-3_c_double, title//', results that say something')
    end subroutine

    subroutine columns(name, counts, theirs, title)
        character(len=*), intent(in) :: name, title
        integer, intent(in) :: counts(3)
        type(crowd), intent(in) :: theirs
        type(crowd), target :: c
        real(c_double), allocatable, target :: force(:, :), moment(:, :)
        type(vti_bodies) :: b
        c = new_crowd(counts)
        allocate (force, moment, mold=c%x)
        b = vti_bodies_none(size(c%mass, kind=c_int64_t))
        b%x = vti_view_columns(c%x)
        b%v = vti_view_columns(c%v)
        b%force = vti_view_columns(force)
        b%alpha = vti_view_columns(c%alpha)
        b%omega = vti_view_columns(c%omega)
        b%moment = vti_view_columns(moment)
        b%mass = vti_scalars_array(c%mass)
        b%inertia = vti_scalars_array(c%inertia)
        call run(name, b, vti_scalars_array(c%diameter), c%pair, c%rest, c%results, title//', columns')
        call compare(theirs, c%x, c%v, c%alpha, c%omega, c%rest, title//', columns')
        call same_results(theirs, c%results, title//', columns')
    end subroutine

    !> (n,3), every other row of a longer one, columns of a wider table, backwards.
    subroutine sections(name, counts, theirs, title)
        character(len=*), intent(in) :: name, title
        integer, intent(in) :: counts(3)
        type(crowd), intent(in) :: theirs
        type(crowd), target :: c
        real(c_double), allocatable, target :: x(:, :), v(:, :), table(:, :), omega(:, :), force(:, :), moment(:, :)
        real(c_double), allocatable, target :: scalars(:, :)
        type(vti_bodies) :: b
        integer :: n
        c = new_crowd(counts)
        n = size(c%mass)
        allocate (x(n, 3), v(2*n, 3), table(8, n), omega(n, 3), force(n, 3), moment(3, n), scalars(3, n))
        x = transpose(c%x)
        v(2::2, :) = transpose(c%v)
        table(2:4, :) = c%alpha
        omega(n:1:-1, :) = transpose(c%omega)
        scalars(1, :) = c%mass
        scalars(2, :) = c%inertia
        scalars(3, :) = c%diameter
        b = vti_bodies_none(int(n, c_int64_t))
        b%x = vti_view_rows(x)
        b%v = vti_view_rows(v(2::2, :))
        b%force = vti_view_rows(force)
        b%alpha = vti_view_columns(table(2:4, :))
        b%omega = vti_view_rows(omega(n:1:-1, :))
        b%moment = vti_view_columns(moment)
        b%mass = vti_scalars_member(c_loc(scalars(1, 1)), 24_c_int64_t)
        b%inertia = vti_scalars_member(c_loc(scalars(2, 1)), 24_c_int64_t)
        call run(name, b, vti_scalars_member(c_loc(scalars(3, 1)), 24_c_int64_t), c%pair, c%rest, c%results, &
            title//', sections')
        call compare(theirs, transpose(x), transpose(v(2::2, :)), table(2:4, :), transpose(omega(n:1:-1, :)), c%rest, &
            title//', sections')
        call same_results(theirs, c%results, title//', sections')
    end subroutine

    subroutine members(name, counts, theirs, title)
        character(len=*), intent(in) :: name, title
        integer, intent(in) :: counts(3)
        type(crowd), intent(in) :: theirs
        type(crowd), target :: c
        type(sphere), allocatable, target :: p(:)
        type(vti_bodies) :: b
        integer(c_int64_t) :: bytes
        integer :: i
        c = new_crowd(counts)
        allocate (p(size(c%mass)))
        bytes = storage_size(p, c_int64_t)/8
        do i = 1, size(p)
            p(i) = sphere(i, c%x(:, i), c%v(:, i), 0, c%alpha(:, i), c%omega(:, i), 0, c%mass(i), c%inertia(i), &
                c%diameter(i))
        end do
        b = vti_bodies_none(size(p, kind=c_int64_t))
        b%x = vti_view_member(c_loc(p(1)%x), bytes)
        b%v = vti_view_member(c_loc(p(1)%v), bytes)
        b%force = vti_view_member(c_loc(p(1)%f), bytes)
        b%alpha = vti_view_member(c_loc(p(1)%alpha), bytes)
        b%omega = vti_view_member(c_loc(p(1)%omega), bytes)
        b%moment = vti_view_member(c_loc(p(1)%m), bytes)
        b%mass = vti_scalars_member(c_loc(p(1)%mass), bytes)
        b%inertia = vti_scalars_member(c_loc(p(1)%inertia), bytes)
        call run(name, b, vti_scalars_member(c_loc(p(1)%diameter), bytes), c%pair, c%rest, c%results, title//', members')
        do i = 1, size(p)
            c%x(:, i) = p(i)%x
            c%v(:, i) = p(i)%v
            c%alpha(:, i) = p(i)%alpha
            c%omega(:, i) = p(i)%omega
        end do
        call compare(theirs, c%x, c%v, c%alpha, c%omega, c%rest, title//', members')
        call same_results(theirs, c%results, title//', members')
    end subroutine

    !> The packed door moves the bodies; the effects still need views.
    subroutine packed(counts, theirs, title)
        integer, intent(in) :: counts(3)
        type(crowd), intent(in) :: theirs
        character(len=*), intent(in) :: title
        type(crowd), target :: c
        real(c_double), allocatable, target :: force(:, :), moment(:, :)
        real(c_double), target :: stiffness(3)
        type(vti_bodies) :: b
        type(vti_bonds), target :: bonds
        type(vti_effect) :: effect
        type(crowd) :: only_bonds
        integer(c_int64_t) :: n
        integer(c_int) :: status(3)
        integer :: i
        only_bonds = run_in_c('vti2', counts, 1)
        call expect(.not. same_bits(only_bonds%x, theirs%x), title//': the other effects do something')
        c = new_crowd(counts)
        n = size(c%mass, kind=c_int64_t)
        allocate (force, moment, mold=c%x)
        stiffness = bond_energy
        b = vti_bodies_none(n)
        b%x = vti_view_columns(c%x)
        b%alpha = vti_view_columns(c%alpha)
        b%force = vti_view_columns(force)
        b%moment = vti_view_columns(moment)
        status(1) = vti_bonds_rest(c%pair, b, c%rest)
        bonds = vti_bonds_between(c%pair, c%rest)
        bonds%moment = vti_scalars_one(stiffness(1))
        bonds%axial = vti_scalars_one(stiffness(2))
        bonds%shear = vti_scalars_one(stiffness(3))
        effect = vti_bonds_effect(bonds)
        status(2) = vti_apply([effect], b)
        do i = 1, int(steps)
            status(1) = vti_packed_begin(2_c_int64_t, h, n, c%x, c%v, force, c%alpha, c%omega, moment, n, c%mass, n, &
                c%inertia)
            status(2) = vti_apply([effect], b)
            status(3) = vti_packed_finish(2_c_int64_t, h, n, c%v, force, c%omega, moment, n, c%mass, n, c%inertia)
            if (any(status /= VTI_OK)) call expect_status(minval(status), VTI_OK, title//', packed')
        end do
        call compare(only_bonds, c%x, c%v, c%alpha, c%omega, c%rest, title//', packed')
    end subroutine
end program
