! SPDX-License-Identifier: BSD-3-Clause
!> The types and constants that Fortran declares are C's: sizes, the place of every member, texts.
program test_fortran_layout
    use, intrinsic :: iso_c_binding, only: c_int, c_int64_t, c_intptr_t, c_loc, c_ptr, c_size_t, c_sizeof
    use common
    implicit none
    integer(c_int64_t) :: theirs(300), count
    integer(c_int64_t) :: ours(300) = 0
    integer :: entries = 0
    integer(c_int64_t), parameter :: quantity(17) = [VTI_QUANTITY_X, VTI_QUANTITY_V, VTI_QUANTITY_FORCE, &
        VTI_QUANTITY_ALPHA, VTI_QUANTITY_QUAT, VTI_QUANTITY_OMEGA, VTI_QUANTITY_MOMENT, VTI_QUANTITY_MASS, &
        VTI_QUANTITY_INERTIA, VTI_QUANTITY_X_LOW, VTI_QUANTITY_V_LOW, VTI_QUANTITY_ALPHA_LOW, VTI_QUANTITY_OMEGA_LOW, &
        VTI_QUANTITY_MOMENTS, VTI_QUANTITY_SPIN, VTI_QUANTITY_PRINCIPAL, VTI_QUANTITY_SPIN_LOW]
    character(len=9), parameter :: name(17) = [character(len=9) :: 'x', 'v', 'force', 'alpha', 'quat', 'omega', &
        'moment', 'mass', 'inertia', 'x_low', 'v_low', 'alpha_low', 'omega_low', 'moments', 'spin', &
        'principal', 'spin_low']
    integer :: k

    call members()
    count = shim_layout(300_c_int64_t, theirs)
    call compare('size or offset')

    call expect(index(vti_version(), '.') > 1, 'version '//vti_version())
    call expect(index('AVX-512 and AVX2, those of the build', vti_vector_units()) > 0, 'units '//vti_vector_units())
    call expect(vti_status_text(VTI_OK) == 'no error', 'text of VTI_OK')
    call expect(index(vti_status_text(99_c_int), 'unknown') == 1, 'text of no status')
    do k = 1, 17
        call expect(vti_quantity_text(quantity(k)) == trim(name(k)), 'text of the quantity '//name(k))
    end do
    call expect(vti_quantity_text(VTI_QUANTITY_NONE) == 'value', 'text of no quantity')
    call expect(vti_quantity_text(18_c_int64_t) == 'value', 'text of a quantity that there is not')
    call finish()

contains

    subroutine compare(what)
        character(len=*), intent(in) :: what
        character(len=8) :: place
        integer :: i
        call expect(count == entries, 'number of entries, '//what)
        do i = 1, min(int(count), entries)
            write (place, '(i0)') i
            call expect(ours(i) == theirs(i), what//' '//trim(place)//' of the table')
        end do
    end subroutine

    !> The size of a variable, and the bytes from its beginning to each of its members.
    subroutine add(bytes, base, members)
        integer(c_size_t), intent(in) :: bytes
        type(c_ptr), intent(in) :: base, members(:)
        integer :: last
        last = entries + 1 + size(members)
        ours(entries + 1) = int(bytes, c_int64_t)
        ours(entries + 2:last) = int(transfer(members, [0_c_intptr_t]) - transfer(base, 0_c_intptr_t), c_int64_t)
        entries = last
    end subroutine

    !> Of each type its size and the places of its members, in the order of shim_layout.
    subroutine members()
        type(vti_fault), target :: fault
        type(vti_view), target :: view
        type(vti_quat_view), target :: quat_view
        type(vti_scalars), target :: scalars
        type(vti_bodies), target :: bodies
        type(vti_stepper), target :: stepper
        type(vti_errors), target :: errors
        type(vti_control), target :: control
        type(vti_kept), target :: kept
        type(vti_density), target :: density
        type(vti_effect), target :: effect
        type(vti_drifted), target :: drifted
        type(vti_pendulum), target :: pendulum
        type(vti_gravity), target :: gravity
        type(vti_drag), target :: drag
        type(vti_held), target :: held
        type(vti_history), target :: history
        type(vti_friction), target :: friction
        type(vti_bond_dashpots), target :: bond_dashpots
        type(vti_rupture), target :: rupture
        type(vti_dashpots), target :: dashpots
        type(vti_multistep), target :: multistep
        type(vti_past), target :: past
        type(vti_bonds), target :: bonds
        type(vti_contacts), target :: contacts
        type(vti_wall_motion), target :: motion
        type(vti_walls), target :: walls
        type(vti_spring), target :: spring
        type(vti_clumps), target :: clumps
        type(vti_clumped), target :: clumped
        type(vti_solid), target :: solid
        type(vti_deformation), target :: deformation
        type(vti_stable), target :: stable
        type(vti_sum), target :: sum
        type(vti_integral), target :: integral
        call add(c_sizeof(fault), c_loc(fault), [c_loc(fault%body), c_loc(fault%value), c_loc(fault%quantity)])
        call add(c_sizeof(view), c_loc(view), [c_loc(view%c), c_loc(view%stride), c_loc(view%count)])
        call add(c_sizeof(quat_view), c_loc(quat_view), [c_loc(quat_view%xyzw), c_loc(quat_view%stride), &
            c_loc(quat_view%count)])
        call add(c_sizeof(scalars), c_loc(scalars), [c_loc(scalars%p), c_loc(scalars%stride), &
            c_loc(scalars%count)])
        call add(c_sizeof(bodies), c_loc(bodies), [c_loc(bodies%abi), c_loc(bodies%sealed), c_loc(bodies%first), &
            c_loc(bodies%count), c_loc(bodies%x), c_loc(bodies%v), c_loc(bodies%force), c_loc(bodies%alpha), &
            c_loc(bodies%quat), c_loc(bodies%omega), c_loc(bodies%moment), c_loc(bodies%mass), &
            c_loc(bodies%inertia), c_loc(bodies%x_low), c_loc(bodies%v_low), c_loc(bodies%alpha_low), &
            c_loc(bodies%omega_low), c_loc(bodies%moments), c_loc(bodies%spin), c_loc(bodies%principal), &
            c_loc(bodies%spin_low)])
        call add(c_sizeof(stepper), c_loc(stepper), [c_loc(stepper%name), c_loc(stepper%law), &
            c_loc(stepper%frame), c_loc(stepper%order), c_loc(stepper%reversible), c_loc(stepper%symplectic), &
            c_loc(stepper%stages), c_loc(stepper%evals), c_loc(stepper%lag), c_loc(stepper%reach), &
            c_loc(stepper%kick), c_loc(stepper%drift), c_loc(stepper%probe), c_loc(stepper%about), &
            c_loc(stepper%estimate_order), c_loc(stepper%estimates), c_loc(stepper%estimate), &
            c_loc(stepper%rotor)])
        call add(c_sizeof(errors), c_loc(errors), [c_loc(errors%memory), c_loc(errors%rows)])
        call add(c_sizeof(control), c_loc(control), [c_loc(control%tolerance), c_loc(control%speed), &
            c_loc(control%turning), c_loc(control%most), c_loc(control%least), c_loc(control%power), &
            c_loc(control%h), c_loc(control%error), c_loc(control%held), c_loc(control%accepted), &
            c_loc(control%rejected)])
        call add(c_sizeof(kept), c_loc(kept), [c_loc(kept%memory), c_loc(kept%width)])
        call add(c_sizeof(density), c_loc(density), [c_loc(density%epsilon), c_loc(density%rho), c_loc(density%h)])
        call add(c_sizeof(effect), c_loc(effect), [c_loc(effect%name), c_loc(effect%apply), &
            c_loc(effect%energy), c_loc(effect%check), c_loc(effect%springs), c_loc(effect%flow), &
            c_loc(effect%flow_clumps), c_loc(effect%carry), c_loc(effect%rupture), c_loc(effect%self), &
            c_loc(effect%needs), c_loc(effect%gives), c_loc(effect%smooth), c_loc(effect%settles), &
            c_loc(effect%breaks), c_loc(effect%dissipates), c_loc(effect%terms), c_loc(effect%term), &
            c_loc(effect%books), c_loc(effect%book), c_loc(effect%booked), &
            c_loc(effect%by_body), c_loc(effect%of_body)])
        call add(c_sizeof(drifted), c_loc(drifted), [c_loc(drifted%t), c_loc(drifted%law), &
            c_loc(drifted%frame), c_loc(drifted%rotor), c_loc(drifted%clumps), c_loc(drifted%bodies)])
        call add(c_sizeof(pendulum), c_loc(pendulum), [c_loc(pendulum%weight), c_loc(pendulum%rho0)])
        call add(c_sizeof(gravity), c_loc(gravity), [c_loc(gravity%g)])
        call add(c_sizeof(drag), c_loc(drag), [c_loc(drag%linear), c_loc(drag%quadratic), c_loc(drag%angular), &
            c_loc(drag%medium), c_loc(drag%lost), c_loc(drag%by_body)])
        call add(c_sizeof(held), c_loc(held), [c_loc(held%i), c_loc(held%j), c_loc(held%sliding), &
            c_loc(held%rolling), c_loc(held%twisting)])
        call add(c_sizeof(history), c_loc(history), [c_loc(history%slots), c_loc(history%used), &
            c_loc(history%missed), c_loc(history%held), c_loc(history%slot)])
        call add(c_sizeof(friction), c_loc(friction), [c_loc(friction%contacts), c_loc(friction%walls), &
            c_loc(friction%sliding), c_loc(friction%rolling), c_loc(friction%twisting), c_loc(friction%stiffness), &
            c_loc(friction%mindlin), c_loc(friction%rolling_stiffness), c_loc(friction%twisting_stiffness), &
            c_loc(friction%reach), c_loc(friction%history), c_loc(friction%lost), c_loc(friction%wall_sliding), &
            c_loc(friction%by_body), c_loc(friction%by_pair)])
        call add(c_sizeof(multistep), c_loc(multistep), [c_loc(multistep%name), c_loc(multistep%depth), &
            c_loc(multistep%c), c_loc(multistep%u), c_loc(multistep%reach), c_loc(multistep%about)])
        call add(c_sizeof(past), c_loc(past), [c_loc(past%memory), c_loc(past%depth), c_loc(past%known)])
        call add(c_sizeof(bond_dashpots), c_loc(bond_dashpots), [c_loc(bond_dashpots%bonds), &
            c_loc(bond_dashpots%zeta), c_loc(bond_dashpots%axial), c_loc(bond_dashpots%shear), &
            c_loc(bond_dashpots%bending), c_loc(bond_dashpots%twisting), c_loc(bond_dashpots%lost), &
            c_loc(bond_dashpots%by_body)])
        call add(c_sizeof(rupture), c_loc(rupture), [c_loc(rupture%bonds), c_loc(rupture%id), c_loc(rupture%stretch), &
            c_loc(rupture%normal), c_loc(rupture%shear), c_loc(rupture%bending), c_loc(rupture%torsion), &
            c_loc(rupture%energy), c_loc(rupture%lost), c_loc(rupture%by_body)])
        call add(c_sizeof(dashpots), c_loc(dashpots), [c_loc(dashpots%contacts), c_loc(dashpots%walls), &
            c_loc(dashpots%friction), c_loc(dashpots%zeta), c_loc(dashpots%normal), c_loc(dashpots%tangential), &
            c_loc(dashpots%ratio), c_loc(dashpots%rolling), c_loc(dashpots%twisting), c_loc(dashpots%pull), &
            c_loc(dashpots%reach), c_loc(dashpots%lost), c_loc(dashpots%wall_zeta), &
            c_loc(dashpots%by_body)])
        call add(c_sizeof(bonds), c_loc(bonds), [c_loc(bonds%count), c_loc(bonds%pair), c_loc(bonds%base), &
            c_loc(bonds%rest), c_loc(bonds%moment), c_loc(bonds%axial), c_loc(bonds%shear), &
            c_loc(bonds%shear_form), c_loc(bonds%turn)])
        call add(c_sizeof(contacts), c_loc(contacts), [c_loc(contacts%count), c_loc(contacts%pair), &
            c_loc(contacts%base), c_loc(contacts%diameter), c_loc(contacts%stiffness), c_loc(contacts%modulus), &
            c_loc(contacts%length)])
        call add(c_sizeof(motion), c_loc(motion), [c_loc(motion%velocity), c_loc(motion%spin), c_loc(motion%centre), &
            c_loc(motion%moved)])
        call add(c_sizeof(walls), c_loc(walls), [c_loc(walls%count), c_loc(walls%plane), c_loc(walls%diameter), &
            c_loc(walls%stiffness), c_loc(walls%each), c_loc(walls%cylinders), c_loc(walls%cylinder), &
            c_loc(walls%motion), c_loc(walls%work), c_loc(walls%modulus), c_loc(walls%moduli), &
            c_loc(walls%by_body)])
        call add(c_sizeof(spring), c_loc(spring), [c_loc(spring%element), c_loc(spring%i), c_loc(spring%j), &
            c_loc(spring%length), c_loc(spring%axial), c_loc(spring%across), c_loc(spring%shear), &
            c_loc(spring%arm_i), c_loc(spring%arm_j), c_loc(spring%bend), c_loc(spring%twist), &
            c_loc(spring%lever_i), c_loc(spring%lever_j)])
        call add(c_sizeof(clumps), c_loc(clumps), [c_loc(clumps%count), c_loc(clumps%body), c_loc(clumps%base), &
            c_loc(clumps%offset), c_loc(clumps%spheres)])
        call add(c_sizeof(solid), c_loc(solid), [c_loc(solid%mass), c_loc(solid%centre), c_loc(solid%moments), &
            c_loc(solid%principal)])
        call add(c_sizeof(clumped), c_loc(clumped), [c_loc(clumped%clumps), c_loc(clumped%effect)])
        call add(c_sizeof(deformation), c_loc(deformation), [c_loc(deformation%overlap), &
            c_loc(deformation%strain), c_loc(deformation%meet)])
        call add(c_sizeof(stable), c_loc(stable), [c_loc(stable%h), c_loc(stable%effect), c_loc(stable%element), &
            c_loc(stable%i), c_loc(stable%j)])
        call add(c_sizeof(sum), c_loc(sum), [c_loc(sum%high), c_loc(sum%low)])
        call add(c_sizeof(integral), c_loc(integral), [c_loc(integral%sum), c_loc(integral%last), &
            c_loc(integral%values)])
    end subroutine
end program
