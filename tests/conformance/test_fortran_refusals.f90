! SPDX-License-Identifier: BSD-3-Clause
!> Effects that cannot be computed are refused from Fortran with a status and a text: nothing, wrong shapes, bad pairs, bad
!> stiffnesses, a method that steps back where something dissipates. Sums and probes are here too.
program test_fortran_refusals
    use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_is_nan
    use, intrinsic :: iso_c_binding, only: c_double, c_f_pointer, c_int, c_int64_t, c_loc, c_null_funptr
    use common, only: expect, expect_status, finish, number, same_bits
    use lattice, only: crowd, new_crowd
    use vti
    implicit none

    type(crowd), target :: c
    real(c_double), allocatable, target :: force(:, :), moment(:, :), wrong(:, :)
    integer(c_int64_t), allocatable, target :: pair(:, :), wrong_pair(:, :)
    real(c_double), target :: stiffness = 10
    type(vti_bodies) :: b
    type(vti_bonds), target :: bonds
    type(vti_fault) :: fault
    integer(c_int64_t), parameter :: n = 10

    c = new_crowd([10, 1, 1])
    allocate (force, moment, mold=c%x)
    allocate (wrong(3, 9), source=0.0_c_double)
    allocate (wrong_pair(3, 9), source=1_c_int64_t)
    pair = c%pair
    b = vti_bodies_none(n)
    b%x = vti_view_columns(c%x)
    b%v = vti_view_columns(c%v)
    b%force = vti_view_columns(force)
    b%alpha = vti_view_columns(c%alpha)
    b%omega = vti_view_columns(c%omega)
    b%moment = vti_view_columns(moment)
    b%mass = vti_scalars_array(c%mass)
    b%inertia = vti_scalars_array(c%inertia)
    call rest_vectors()
    call bond_lists()
    call absent_effects()
    call wrong_arrays()
    call steps_back()
    call stale()
    call stable_step()
    call probe()
    call sums()
    call finish()

contains

    subroutine blamed(status, wanted, culprit, what)
        integer(c_int), intent(in) :: status, wanted
        integer, intent(in) :: culprit
        character(len=*), intent(in) :: what
        call expect_status(status, wanted, what)
        call expect(fault%body == culprit, what//': the one to blame')
        call expect(len(vti_status_text(status)) > 7, what//': a text')
    end subroutine

    subroutine rest_vectors()
        type(vti_bodies) :: other
        call blamed(vti_bonds_rest(pair, b, c%rest, fault), VTI_OK, 0, 'rest vectors')
        call blamed(vti_bonds_rest(wrong_pair, b, c%rest, fault), VTI_E_COUNT, 0, 'pairs of three')
        call blamed(vti_bonds_rest(pair, b, wrong, fault), VTI_E_COUNT, 0, 'rest vectors of three')
        call blamed(vti_bonds_rest(pair(:, :8), b, c%rest, fault), VTI_E_COUNT, 0, 'fewer pairs than rest vectors')
        other = b
        other%x = vti_view()
        call blamed(vti_bonds_rest(pair, other, c%rest, fault), VTI_E_VIEW, 0, 'no positions')
        call expect(fault%quantity == VTI_QUANTITY_X, 'no positions: which are named')
        other%x = b%x
        other%x%stride = 0
        call blamed(vti_bonds_rest(pair, other, c%rest, fault), VTI_E_STRIDE, 0, 'positions of stride 0')
        call expect(fault%quantity == VTI_QUANTITY_X, 'positions of stride 0: which are named')
        pair(1, 4) = 0
        call blamed(vti_bonds_rest(pair, b, c%rest, fault), VTI_E_BOND, 4, 'body 0')
        call expect(fault%quantity == VTI_QUANTITY_NONE, 'body 0: no quantity is to blame')
        call expect(abs(fault%value) <= 0, 'body 0: the value')
        pair(2, 4) = n + 1
        pair(1, 4) = 1
        call blamed(vti_bonds_rest(pair, b, c%rest, fault), VTI_E_BOND, 4, 'a body behind the last')
        call expect(nint(fault%value) == n + 1, 'a body behind the last: the value')
        pair(:, 4) = [5, 5]
        call blamed(vti_bonds_rest(pair, b, c%rest, fault), VTI_E_BOND, 4, 'a body and itself')
        pair = c%pair
        call blamed(vti_bonds_rest(pair, b, c%rest, fault), VTI_OK, 0, 'rest vectors again')
    end subroutine

    subroutine bond_lists()
        bonds = vti_bonds_between(pair, c%rest)
        bonds%axial = vti_scalars_one(stiffness)
        call blamed(vti_bonds_check(bonds, n, fault), VTI_OK, 0, 'good bonds')
        call blamed(vti_bonds_check(bonds, n - 1, fault), VTI_E_BOND, 9, 'a bond to a body too many')
        pair(1, 2) = 0
        call blamed(vti_bonds_check(bonds, n, fault), VTI_E_BOND, 2, 'a bond to body 0')
        pair = c%pair
        stiffness = -1
        call blamed(vti_bonds_check(bonds, n, fault), VTI_E_BOND, 1, 'a negative stiffness')
        call expect(abs(fault%value + 1) <= 0, 'a negative stiffness: the value')
        stiffness = 10
        c%rest(1:3, 7) = 2*c%rest(1:3, 7)
        call blamed(vti_bonds_check(bonds, n, fault), VTI_E_BOND, 7, 'a rest vector that is no direction')
        c%rest(1:3, 7) = c%rest(1:3, 7)/2
        bonds = vti_bonds_between(wrong_pair, c%rest)
        call blamed(vti_bonds_check(bonds, n, fault), VTI_E_COUNT, 0, 'bonds of pairs of three')
        bonds = vti_bonds_between(pair, wrong)
        call blamed(vti_bonds_check(bonds, n, fault), VTI_E_COUNT, 0, 'bonds of rest vectors of three')
        bonds = vti_bonds_between(pair(:, 1:0), c%rest(:, 1:0))
        call blamed(vti_bonds_check(bonds, n, fault), VTI_OK, 0, 'no bonds')
        call expect_status(vti_apply([vti_bonds_effect(bonds)], b), VTI_OK, 'the effect of no bonds')
    end subroutine

    !> What does not exist is no effect, and that is refused before anything is written.
    subroutine absent_effects()
        type(vti_bonds), pointer :: no_bonds
        type(vti_contacts), pointer :: no_contacts
        type(vti_walls), pointer :: no_walls
        type(vti_gravity), pointer :: no_gravity
        type(vti_pendulum), pointer :: no_pendulum
        type(vti_effect) :: half
        type(vti_gravity), target :: gravity
        nullify (no_bonds, no_contacts, no_walls, no_gravity, no_pendulum)
        call refused(vti_bonds_effect(no_bonds), 'no bonds')
        call refused(vti_contacts_effect(no_contacts), 'no contacts')
        call refused(vti_walls_effect(no_walls), 'no walls')
        call refused(vti_gravity_effect(no_gravity), 'no gravity')
        call refused(vti_pendulum_effect(no_pendulum), 'no pendulum')
        half = vti_gravity_effect(gravity)
        half%energy = c_null_funptr
        call refused(half, 'an effect without energy')
    end subroutine

    subroutine wrong_arrays()
        type(vti_contacts), target :: contacts
        type(vti_walls), target :: walls
        type(vti_bonds), target :: bad
        bad = vti_bonds_between(wrong_pair, c%rest)
        call refused(vti_bonds_effect(bad), 'bonds of the wrong shape')
        contacts = vti_contacts_between(wrong_pair, vti_scalars_array(c%diameter), 1.0_c_double)
        call refused(vti_contacts_effect(contacts), 'contacts of the wrong shape')
        call blamed(vti_contacts_check(contacts, n, fault), VTI_E_COUNT, 0, 'contacts of the wrong shape, checked')
        contacts = vti_contacts_between(pair, vti_scalars_array(c%diameter), 1.0_c_double)
        call blamed(vti_contacts_check(contacts, n, fault), VTI_OK, 0, 'good contacts')
        call blamed(vti_contacts_check(contacts, n - 1, fault), VTI_E_CONTACT, 9, 'a contact with a body too many')
        contacts%stiffness = -1
        call blamed(vti_contacts_check(contacts, n, fault), VTI_E_CONTACT, 0, 'contacts that pull')
        contacts = vti_contacts_between(pair, vti_scalars(), 1.0_c_double)
        call refused(vti_contacts_effect(contacts), 'contacts without diameters')
        walls = vti_walls_at(wrong, vti_scalars_array(c%diameter), 1.0_c_double)
        call refused(vti_walls_effect(walls), 'planes of the wrong shape')
        walls = vti_walls_at(c%rest, vti_scalars(), 1.0_c_double)
        call refused(vti_walls_effect(walls), 'walls without diameters')
    end subroutine

    subroutine refused(effect, what)
        type(vti_effect), intent(in) :: effect
        character(len=*), intent(in) :: what
        force = 5
        call expect_status(vti_apply([effect], b), VTI_E_NULL, what)
        call expect_status(vti_step_check(vti_stepper_find('vti2'), [effect]), VTI_E_NULL, what//', step check')
        call expect(ieee_is_nan(vti_energy([effect], b)), what//', energy')
        call expect(all(abs(force - 5) <= 0), what//', nothing has changed')
    end subroutine

    subroutine steps_back()
        type(vti_gravity), target :: gravity
        type(vti_effect) :: effect
        effect = vti_gravity_effect(gravity)
        call expect_status(vti_step_check(vti_stepper_find('srkn14'), [effect]), VTI_OK, 'srkn14 under gravity')
        effect%dissipates = 1
        call expect_status(vti_step_check(vti_stepper_find('srkn14'), [effect]), VTI_E_DISSIPATES, 'srkn14 with friction')
        call expect_status(vti_step_check(vti_stepper_find('vti2'), [effect]), VTI_OK, 'vti2 with friction')
        call expect_status(vti_step_check(vti_stepper_find('no such'), [effect]), VTI_E_STEPPER, 'no stepper')
    end subroutine

    !> Bodies that another version of the module has made.
    subroutine stale()
        type(vti_bodies) :: old
        type(vti_gravity), target :: gravity
        real(c_double) :: scratch(n)
        type(vti_stable) :: stable
        old = b
        old%abi = VTI_ABI + 1
        force = 5
        call expect_status(vti_apply([vti_gravity_effect(gravity)], old), VTI_E_ABI, 'apply, another ABI')
        call expect_status(vti_stable_step([vti_gravity_effect(gravity)], old, scratch, stable), VTI_E_ABI, &
            'stable step, another ABI')
        call expect(all(abs(force - 5) <= 0), 'another ABI, nothing has changed')
    end subroutine

    subroutine stable_step()
        real(c_double) :: scratch(n)
        type(vti_stable) :: stable
        type(vti_bonds), pointer :: no_bonds
        type(vti_effect) :: none, binder
        stable%h = -3
        nullify (no_bonds)
        none = vti_bonds_effect(no_bonds)
        bonds = vti_bonds_between(pair, c%rest)
        bonds%axial = vti_scalars_one(stiffness)
        binder = vti_bonds_effect(bonds)
        call expect_status(vti_stable_step([binder], b, scratch(:9), stable), VTI_E_COUNT, 'stable step with too little room')
        call expect_status(vti_stable_step([binder, none], b, scratch, stable), VTI_E_NULL, 'stable step of no effect')
        call expect(abs(stable%h + 3) <= 0, 'stable step that is refused')
        call expect_status(vti_stable_step([vti_effect ::], b, scratch, stable), VTI_OK, 'stable step of nothing')
        call expect(.not. ieee_is_finite(stable%h) .and. stable%effect == 0 .and. stable%i == 0, 'nothing oscillates')
        call expect_status(vti_stable_step([binder], b, scratch, stable), VTI_OK, 'stable step')
        call expect(stable%h > 0 .and. stable%h < 2, 'bonds oscillate')
    end subroutine

    !> chin4 takes the forces of a kick at x + probe h^2 F/m.
    subroutine probe()
        type(vti_stepper) :: method
        type(vti_bodies) :: probed
        real(c_double), target :: x(3, n), alpha(3, n)
        real(c_double), pointer :: factor(:)
        real(c_double), parameter :: h = 0.125_c_double
        integer :: i, k
        method = vti_stepper_find('chin4')
        call c_f_pointer(method%probe, factor, [method%stages + 1])
        k = maxloc(abs(factor), 1)
        do i = 1, int(n)
            force(:, i) = [number(i), number(i + 20), number(i + 40)]
        end do
        moment = 0
        probed = b
        probed%x = vti_view_columns(x)
        probed%alpha = vti_view_columns(alpha)
        call expect_status(vti_step_probe(method, int(k - 1, c_int64_t), h, b, probed), VTI_OK, 'probe')
        call expect(all(abs(x - c%x - factor(k)*h**2*force/spread(c%mass, 1, 3)) <= 4*epsilon(h)*abs(x) + epsilon(h)), &
            'probe, positions') ! two sums and three products, each good to eps/2
        call expect(maxval(abs(x - c%x)) > 1e-6_c_double, 'probe, bodies are displaced')
        call expect_status(vti_step_probe(vti_stepper_find('no such'), 0_c_int64_t, h, b, probed), VTI_E_STEPPER, &
            'probe of no stepper')
    end subroutine

    !> A sum of terms that cancel keeps what doubles alone lose, and the trapezoid rule is exact for a straight line.
    subroutine sums()
        type(vti_sum) :: s
        type(vti_integral) :: q
        real(c_double) :: plain
        integer :: i
        plain = 0
        do i = 1, 1000
            call vti_sum_add(s, 1e16_c_double)
            call vti_sum_add(s, 1.0_c_double)
            call vti_sum_add(s, -1e16_c_double)
            plain = ((plain + 1e16_c_double) + 1) - 1e16_c_double
        end do
        call expect(abs(vti_sum_value(s) - 1000) <= 0, 'sum')
        call expect(abs(plain - 1000) > 100, 'a sum that doubles alone lose')
        do i = 0, 64
            call vti_integral_add(q, 0.125_c_double, 3*0.125_c_double*i)
        end do
        call expect(abs(vti_integral_value(q) - 96) <= 0 .and. q%values == 65, 'integral of 3 t up to t = 8')
        call expect(same_bits([q%last], [24.0_c_double]), 'last value of the integral')
    end subroutine
end program
