! SPDX-License-Identifier: BSD-3-Clause
!> Every effect from Fortran: a chain and a block of bonded spheres are after 1000 steps where the same run in C puts
!> them, to the last bit, and so are rest vectors, energies and the stable step. Arrays of other layouts are in
!> test_fortran.f90.
program test_fortran_lattice
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use common, only: expect, expect_status, finish, same_bits
    use lattice
    use vti
    implicit none

    integer, parameter :: chain(3) = [10, 1, 1], block(3) = [7, 6, 5]
    real(c_double), parameter :: planes(4, 2) = reshape([1.0_c_double, 0.0_c_double, 0.0_c_double, -0.25_c_double, &
        0.0_c_double, 0.6_c_double, 0.8_c_double, -0.25_c_double], [4, 2])
    character(len=6), parameter :: names(3) = ['vti2  ', 'vti1  ', 'srkn14']
    integer :: k

    do k = 1, size(names)
        call columns(trim(names(k)), chain, trim(names(k))//', chain')
    end do
    call columns('vti2', block, 'vti2, block')
    call finish()

contains

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
        call expect_status(vti_stable_step(effects, bodies, scratch, stable, vti_deformation(0.25_c_double, &
            0.125_c_double, 1)), VTI_OK, title//', stable step')
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
        call expect(results(1) > h .and. minval(abs(results(2:4))) > 1e-3_c_double, &
            title//', results that say something')
    end subroutine

    subroutine columns(name, counts, title)
        character(len=*), intent(in) :: name, title
        integer, intent(in) :: counts(3)
        type(crowd) :: theirs
        type(crowd), target :: c
        real(c_double), allocatable, target :: force(:, :), moment(:, :)
        type(vti_bodies) :: b
        theirs = run_in_c(name, counts, 5)
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
        call run(name, b, vti_scalars_array(c%diameter), c%pair, c%rest, c%results, title)
        call compare(theirs, c%x, c%v, c%alpha, c%omega, c%rest, title)
        call same_results(theirs, c%results, title)
    end subroutine
end program
