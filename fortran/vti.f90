! SPDX-License-Identifier: BSD-3-Clause
!
!> vti -- vti.h in Fortran: the same names, the caller's arrays, the same bits. Frames, units and contracts are those
!> of vti.h. Every integer function returns VTI_OK or a negative status and has then changed nothing; nothing stops or
!> prints.
!>
!> What is different because Fortran is:
!>  - Bodies and steppers are counted from 1, in arguments and in vti_fault (0: it is not about one). Two things keep
!>    the numbers of C: first in vti_bodies, which vti_bodies_slice sets, and stages (vti_step_begin is stage 0).
!>  - An array behind a view must have the TARGET attribute, which the compiler checks where the view is made, and must
!>    stay where it is while the view is used. A procedure that takes a step and has the array as a dummy argument says
!>    TARGET there too; without it the compiler may assume that the step leaves the array alone.
!>  - fault is optional wherever C takes NULL; the number of effects is the size of the array.
!>  - Steppers are values. Where C answers NULL, stages is 0, and every call with that stepper returns VTI_E_STEPPER.
!>
!> use vti brings it all: types (vti_types), views of arrays (vti_views), measures (vti_c, vti_sums), steps (vti_steps,
!> vti_multisteps), effects (vti_effects, vti_effects_bonds, vti_effects_contacts), packed arrays (vti_packed), the
!> algebra of rotations (vti_rrv).
module vti
    use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_f_pointer, c_int, c_int64_t, c_ptr
    use vti_c
    use vti_effects
    use vti_effects_bonds
    use vti_effects_contacts
    use vti_controls
    use vti_multisteps
    use vti_packed
    use vti_rrv
    use vti_steps
    use vti_sums
    use vti_views
    implicit none
    public
    private :: c_associated, c_char, c_f_pointer, c_int, c_int64_t, c_ptr
    private :: c_bodies_check_values, c_drift, c_stepper_find, c_stepper_at, c_step_stage, c_step_finish, &
        c_step_next, c_step_probe, c_step_start, c_step_sync, c_packed_begin, c_packed_finish, c_status_text, &
        c_quantity_text, c_version, c_vector_units, c_strlen
    private :: from_one, handle

contains

    ! ---- texts ----------------------------------------------------------------------------------------------------

    !> One English sentence for a status, remedy included.
    function vti_status_text(status) result(text)
        integer(c_int), intent(in) :: status
        character(len=:), allocatable :: text
        text = vti_text(c_status_text(status))
    end function

    !> The member of vti_bodies that a quantity of vti_fault is, by its name; 'value' if it is none.
    function vti_quantity_text(quantity) result(text)
        integer(c_int64_t), intent(in) :: quantity
        character(len=:), allocatable :: text
        text = vti_text(c_quantity_text(quantity))
    end function

    !> Version of the library that is running.
    function vti_version() result(text)
        character(len=:), allocatable :: text
        text = vti_text(c_version())
    end function

    !> The vector units that its kernels use on this machine: 'AVX-512 and AVX2', 'AVX2' or 'those of the build'. The
    !> bits do not depend on them.
    function vti_vector_units() result(text)
        character(len=:), allocatable :: text
        text = vti_text(c_vector_units())
    end function

    !> Any text of the types of this module, as method%name or effect%name; empty if there is none.
    function vti_text(p) result(text)
        type(c_ptr), intent(in) :: p
        character(len=:), allocatable :: text
        character(kind=c_char), pointer :: letters(:)
        integer :: i
        text = ''
        if (.not. c_associated(p)) return
        call c_f_pointer(p, letters, [c_strlen(p)])
        text = repeat(' ', size(letters))
        do i = 1, size(letters)
            text(i:i) = letters(i)
        end do
    end function
end module
