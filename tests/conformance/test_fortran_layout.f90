! SPDX-License-Identifier: BSD-3-Clause
!> The types and constants that Fortran declares are C's: sizes, the place of every member, texts.
program test_fortran_layout
    use, intrinsic :: iso_c_binding, only: c_int, c_int64_t, c_intptr_t, c_loc, c_ptr, c_sizeof
    use common
    implicit none
    integer(c_int64_t) :: theirs(200), count
    integer(c_int64_t) :: ours(200) = 0
    integer :: entries = 0
    integer(c_int64_t), parameter :: quantity(13) = [VTI_QUANTITY_X, VTI_QUANTITY_V, VTI_QUANTITY_FORCE, &
        VTI_QUANTITY_ALPHA, VTI_QUANTITY_QUAT, VTI_QUANTITY_OMEGA, VTI_QUANTITY_MOMENT, VTI_QUANTITY_MASS, &
        VTI_QUANTITY_INERTIA, VTI_QUANTITY_X_LOW, VTI_QUANTITY_V_LOW, VTI_QUANTITY_ALPHA_LOW, VTI_QUANTITY_OMEGA_LOW]
    character(len=9), parameter :: name(13) = [character(len=9) :: 'x', 'v', 'force', 'alpha', 'quat', 'omega', 'moment', &
        'mass', 'inertia', 'x_low', 'v_low', 'alpha_low', 'omega_low']
    integer :: k

    call fault()
    call view()
    call quat_view()
    call scalars()
    call bodies()
    call stepper()
    call effect()
    call drifted()
    call pendulum()
    call gravity()
    call drag()
    call held()
    call history()
    call friction()
    call dashpots()
    call bonds()
    call contacts()
    call walls()
    call spring()
    call deformation()
    call stable()
    call sum()
    call integral()
    count = shim_layout(200_c_int64_t, theirs)
    call compare('size or offset')

    call expect(index(vti_version(), '.') > 1, 'version '//vti_version())
    call expect(index('AVX-512 and AVX2, those of the build', vti_vector_units()) > 0, 'units '//vti_vector_units())
    call expect(vti_status_text(VTI_OK) == 'no error', 'text of VTI_OK')
    call expect(index(vti_status_text(99_c_int), 'unknown') == 1, 'text of no status')
    do k = 1, 13
        call expect(vti_quantity_text(quantity(k)) == trim(name(k)), 'text of the quantity '//name(k))
    end do
    call expect(vti_quantity_text(VTI_QUANTITY_NONE) == 'value', 'text of no quantity')
    call expect(vti_quantity_text(14_c_int64_t) == 'value', 'text of a quantity that there is not')
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

    subroutine add(numbers)
        integer(c_int64_t), intent(in) :: numbers(:)
        ours(entries + 1:entries + size(numbers)) = numbers
        entries = entries + size(numbers)
    end subroutine

    !> Bytes from the beginning of a variable to each of its members.
    function offsets(base, members) result(bytes)
        type(c_ptr), intent(in) :: base, members(:)
        integer(c_int64_t) :: bytes(size(members))
        bytes = int(transfer(members, [0_c_intptr_t]) - transfer(base, 0_c_intptr_t), c_int64_t)
    end function

    subroutine fault()
        type(vti_fault), target :: t
        call add([int(c_sizeof(t), c_int64_t), offsets(c_loc(t), [c_loc(t%body), c_loc(t%value), c_loc(t%quantity)])])
    end subroutine

    subroutine view()
        type(vti_view), target :: t
        call add([int(c_sizeof(t), c_int64_t), offsets(c_loc(t), [c_loc(t%c), c_loc(t%stride), c_loc(t%count)])])
    end subroutine

    subroutine quat_view()
        type(vti_quat_view), target :: t
        call add([int(c_sizeof(t), c_int64_t), offsets(c_loc(t), [c_loc(t%xyzw), c_loc(t%stride), c_loc(t%count)])])
    end subroutine

    subroutine scalars()
        type(vti_scalars), target :: t
        call add([int(c_sizeof(t), c_int64_t), offsets(c_loc(t), [c_loc(t%p), c_loc(t%stride), c_loc(t%count)])])
    end subroutine

    subroutine bodies()
        type(vti_bodies), target :: t
        call add([int(c_sizeof(t), c_int64_t), offsets(c_loc(t), [c_loc(t%abi), c_loc(t%sealed), c_loc(t%first), &
            c_loc(t%count), c_loc(t%x), c_loc(t%v), c_loc(t%force), c_loc(t%alpha), c_loc(t%quat), c_loc(t%omega), &
            c_loc(t%moment), c_loc(t%mass), c_loc(t%inertia), c_loc(t%x_low), c_loc(t%v_low), c_loc(t%alpha_low), &
            c_loc(t%omega_low)])])
    end subroutine

    subroutine stepper()
        type(vti_stepper), target :: t
        call add([int(c_sizeof(t), c_int64_t), offsets(c_loc(t), [c_loc(t%name), c_loc(t%law), c_loc(t%frame), &
            c_loc(t%order), c_loc(t%reversible), c_loc(t%symplectic), c_loc(t%stages), c_loc(t%evals), c_loc(t%lag), &
            c_loc(t%reach), c_loc(t%kick), c_loc(t%drift), c_loc(t%probe), c_loc(t%about)])])
    end subroutine

    subroutine effect()
        type(vti_effect), target :: t
        call add([int(c_sizeof(t), c_int64_t), offsets(c_loc(t), [c_loc(t%name), c_loc(t%apply), c_loc(t%energy), &
            c_loc(t%check), c_loc(t%springs), c_loc(t%flow), c_loc(t%carry), c_loc(t%rupture), c_loc(t%self), c_loc(t%needs), &
            c_loc(t%gives), c_loc(t%smooth), c_loc(t%breaks), c_loc(t%dissipates), c_loc(t%terms), c_loc(t%term), &
            c_loc(t%books), c_loc(t%book), c_loc(t%booked)])])
    end subroutine

    subroutine drifted()
        type(vti_drifted), target :: t
        call add([int(c_sizeof(t), c_int64_t), offsets(c_loc(t), [c_loc(t%t), c_loc(t%law), c_loc(t%frame)])])
    end subroutine

    subroutine pendulum()
        type(vti_pendulum), target :: t
        call add([int(c_sizeof(t), c_int64_t), offsets(c_loc(t), [c_loc(t%weight), c_loc(t%rho0)])])
    end subroutine

    subroutine gravity()
        type(vti_gravity), target :: t
        call add([int(c_sizeof(t), c_int64_t), offsets(c_loc(t), [c_loc(t%g)])])
    end subroutine

    subroutine drag()
        type(vti_drag), target :: t
        call add([int(c_sizeof(t), c_int64_t), offsets(c_loc(t), [c_loc(t%linear), c_loc(t%quadratic), &
            c_loc(t%angular), c_loc(t%medium), c_loc(t%lost)])])
    end subroutine

    subroutine held()
        type(vti_held), target :: t
        call add([int(c_sizeof(t), c_int64_t), offsets(c_loc(t), [c_loc(t%i), c_loc(t%j), c_loc(t%sliding), &
            c_loc(t%rolling), c_loc(t%twisting)])])
    end subroutine

    subroutine history()
        type(vti_history), target :: t
        call add([int(c_sizeof(t), c_int64_t), offsets(c_loc(t), [c_loc(t%slots), c_loc(t%used), c_loc(t%missed), &
            c_loc(t%slot)])])
    end subroutine

    subroutine friction()
        type(vti_friction), target :: t
        call add([int(c_sizeof(t), c_int64_t), offsets(c_loc(t), [c_loc(t%contacts), c_loc(t%walls), &
            c_loc(t%sliding), c_loc(t%rolling), c_loc(t%twisting), c_loc(t%stiffness), c_loc(t%mindlin), &
            c_loc(t%rolling_stiffness), c_loc(t%twisting_stiffness), c_loc(t%reach), c_loc(t%history), c_loc(t%lost)])])
    end subroutine

    subroutine dashpots()
        type(vti_dashpots), target :: t
        call add([int(c_sizeof(t), c_int64_t), offsets(c_loc(t), [c_loc(t%contacts), c_loc(t%walls), &
            c_loc(t%friction), c_loc(t%zeta), c_loc(t%normal), c_loc(t%tangential), c_loc(t%ratio), &
            c_loc(t%rolling), c_loc(t%twisting), &
            c_loc(t%pull), c_loc(t%reach), c_loc(t%lost)])])
    end subroutine

    subroutine bonds()
        type(vti_bonds), target :: t
        call add([int(c_sizeof(t), c_int64_t), offsets(c_loc(t), [c_loc(t%count), c_loc(t%pair), c_loc(t%base), &
            c_loc(t%rest), c_loc(t%moment), c_loc(t%axial), c_loc(t%shear), c_loc(t%shear_form)])])
    end subroutine

    subroutine contacts()
        type(vti_contacts), target :: t
        call add([int(c_sizeof(t), c_int64_t), offsets(c_loc(t), [c_loc(t%count), c_loc(t%pair), c_loc(t%base), &
            c_loc(t%diameter), c_loc(t%stiffness)])])
    end subroutine

    subroutine walls()
        type(vti_walls), target :: t
        call add([int(c_sizeof(t), c_int64_t), offsets(c_loc(t), [c_loc(t%count), c_loc(t%plane), c_loc(t%diameter), &
            c_loc(t%stiffness)])])
    end subroutine

    subroutine spring()
        type(vti_spring), target :: t
        call add([int(c_sizeof(t), c_int64_t), offsets(c_loc(t), [c_loc(t%element), c_loc(t%i), c_loc(t%j), &
            c_loc(t%length), c_loc(t%axial), c_loc(t%across), c_loc(t%shear), c_loc(t%arm_i), c_loc(t%arm_j), &
            c_loc(t%bend), c_loc(t%twist)])])
    end subroutine

    subroutine deformation()
        type(vti_deformation), target :: t
        call add([int(c_sizeof(t), c_int64_t), offsets(c_loc(t), [c_loc(t%overlap), c_loc(t%strain), c_loc(t%meet)])])
    end subroutine

    subroutine stable()
        type(vti_stable), target :: t
        call add([int(c_sizeof(t), c_int64_t), offsets(c_loc(t), [c_loc(t%h), c_loc(t%effect), c_loc(t%element), &
            c_loc(t%i), c_loc(t%j)])])
    end subroutine

    subroutine sum()
        type(vti_sum), target :: t
        call add([int(c_sizeof(t), c_int64_t), offsets(c_loc(t), [c_loc(t%high), c_loc(t%low)])])
    end subroutine

    subroutine integral()
        type(vti_integral), target :: t
        call add([int(c_sizeof(t), c_int64_t), offsets(c_loc(t), [c_loc(t%sum), c_loc(t%last), c_loc(t%values)])])
    end subroutine
end program
