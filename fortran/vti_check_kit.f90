! SPDX-License-Identifier: BSD-3-Clause
!
!> vti_check_kit -- the conformance kit (vti_check.h) for a time step that is a Fortran procedure. Link with -lvti_check
!> too.
!>
!>     faults = vti_check('my code', advance)       the report goes to stdout; the number of faults
!>     faults = vti_check('my code', advance, translation=.true.)     of a code that moves positions only
!>
!>     faults = vti_check_inertia('my code', advance)     how it moves bodies of three moments
!>
!> advance is a procedure of the interface vti_check_advance, or of vti_check_advance_inertia. Arrays are x(3,n),
!> quat(4,n) in the order x, y, z, w; it gets forces and moments by call vti_check_forces(kit, x, quat, force, moment).
!> Frames are those of vti_check.h.
module vti_check_kit
    use, intrinsic :: iso_c_binding, only: c_char, c_double, c_f_pointer, c_f_procpointer, c_funloc, c_funptr, c_int, &
        c_int64_t, c_loc, c_null_char, c_ptr
    implicit none
    private
    public :: vti_check, vti_check_advance, vti_check_advance_inertia, vti_check_forces, vti_check_inertia, vti_kit

    !> Where forces come from.
    type :: vti_kit
        private
        type(c_funptr) :: forces
        type(c_ptr) :: kit
    end type

    abstract interface
        !> Takes n bodies so many steps of h further, with all that the host does before its first step. Returns 0, or
        !> anything else if the host refuses.
        function vti_check_advance(h, steps, n, x, v, quat, omega, mass, inertia, kit) result(status)
            import :: c_double, c_int, c_int64_t, vti_kit
            real(c_double), intent(in) :: h
            integer(c_int64_t), intent(in) :: steps, n
            real(c_double), intent(inout) :: x(3, n), v(3, n), quat(4, n), omega(3, n)
            real(c_double), intent(in) :: mass(n), inertia(n)
            type(vti_kit), intent(in) :: kit
            integer(c_int) :: status
        end function

        !> The same of bodies with the principal moments A, B, C about their own axes and the spatial angular momentum
        !> L.
        function vti_check_advance_inertia(h, steps, n, x, v, quat, spin, mass, moments, kit) result(status)
            import :: c_double, c_int, c_int64_t, vti_kit
            real(c_double), intent(in) :: h
            integer(c_int64_t), intent(in) :: steps, n
            real(c_double), intent(inout) :: x(3, n), v(3, n), quat(4, n), spin(3, n)
            real(c_double), intent(in) :: mass(n), moments(3, n)
            type(vti_kit), intent(in) :: kit
            integer(c_int) :: status
        end function

        subroutine c_forces(kit, n, x, quat, force, moment) bind(c)
            import :: c_double, c_int64_t, c_ptr
            type(c_ptr), value :: kit
            integer(c_int64_t), value :: n
            real(c_double), intent(in) :: x(3, n), quat(4, n)
            real(c_double), intent(out) :: force(3, n), moment(3, n)
        end subroutine
    end interface

    interface
        function c_check(name, advance, self) result(faults) bind(c, name='vti_check')
            import :: c_char, c_funptr, c_int, c_ptr
            character(kind=c_char), intent(in) :: name(*)
            type(c_funptr), value :: advance
            type(c_ptr), value :: self
            integer(c_int) :: faults
        end function

        function c_check_inertia(name, advance, self) result(faults) bind(c, name='vti_check_inertia')
            import :: c_char, c_funptr, c_int, c_ptr
            character(kind=c_char), intent(in) :: name(*)
            type(c_funptr), value :: advance
            type(c_ptr), value :: self
            integer(c_int) :: faults
        end function

        function c_check_translation(name, advance, self) result(faults) bind(c, name='vti_check_translation')
            import :: c_char, c_funptr, c_int, c_ptr
            character(kind=c_char), intent(in) :: name(*)
            type(c_funptr), value :: advance
            type(c_ptr), value :: self
            integer(c_int) :: faults
        end function
    end interface

    !> What goes through C as self.
    type :: host
        procedure(vti_check_advance), pointer, nopass :: advance
    end type

    type :: host_inertia
        procedure(vti_check_advance_inertia), pointer, nopass :: advance
    end type

contains

    !> Runs all checks, or those of translation only, and prints what they find. Returns the number of faults.
    function vti_check(name, advance, translation) result(faults)
        character(len=*), intent(in) :: name
        procedure(vti_check_advance) :: advance
        logical, intent(in), optional :: translation
        integer(c_int) :: faults
        type(host), target :: own
        logical :: only
        own%advance => advance
        only = .false.
        if (present(translation)) only = translation
        if (only) then
            faults = c_check_translation(letters(name), c_funloc(advance_for_c), c_loc(own))
        else
            faults = c_check(letters(name), c_funloc(advance_for_c), c_loc(own))
        end if
    end function

    !> The checks of bodies of three moments, printed. Returns the number of faults.
    function vti_check_inertia(name, advance) result(faults)
        character(len=*), intent(in) :: name
        procedure(vti_check_advance_inertia) :: advance
        integer(c_int) :: faults
        type(host_inertia), target :: own
        own%advance => advance
        faults = c_check_inertia(letters(name), c_funloc(advance_inertia_for_c), c_loc(own))
    end function

    !> Forces and moments at the positions x(3,n) and attitudes quat(4,n), any norm but 0: written, not added.
    subroutine vti_check_forces(kit, x, quat, force, moment)
        type(vti_kit), intent(in) :: kit
        real(c_double), intent(in) :: x(:, :), quat(:, :)
        real(c_double), intent(out) :: force(:, :), moment(:, :)
        procedure(c_forces), pointer :: forces
        call c_f_procpointer(kit%forces, forces)
        call forces(kit%kit, size(x, 2, c_int64_t), x, quat, force, moment)
    end subroutine

    !> The callback of C, which hands over to that of Fortran.
    function advance_for_c(self, h, steps, n, x, v, quat, omega, mass, inertia, forces, kit) result(status) &
            bind(c, name='vti_kit_advance_for_c')
        type(c_ptr), value :: self, kit
        real(c_double), value :: h
        integer(c_int64_t), value :: steps, n
        real(c_double), intent(inout) :: x(3, n), v(3, n), quat(4, n), omega(3, n)
        real(c_double), intent(in) :: mass(n), inertia(n)
        type(c_funptr), value :: forces
        integer(c_int) :: status
        type(host), pointer :: own
        call c_f_pointer(self, own)
        status = own%advance(h, steps, n, x, v, quat, omega, mass, inertia, vti_kit(forces, kit))
    end function

    !> The same of bodies of three moments.
    function advance_inertia_for_c(self, h, steps, n, x, v, quat, spin, mass, moments, forces, kit) &
            result(status) bind(c, name='vti_kit_advance_inertia_for_c')
        type(c_ptr), value :: self, kit
        real(c_double), value :: h
        integer(c_int64_t), value :: steps, n
        real(c_double), intent(inout) :: x(3, n), v(3, n), quat(4, n), spin(3, n)
        real(c_double), intent(in) :: mass(n), moments(3, n)
        type(c_funptr), value :: forces
        integer(c_int) :: status
        type(host_inertia), pointer :: own
        call c_f_pointer(self, own)
        status = own%advance(h, steps, n, x, v, quat, spin, mass, moments, vti_kit(forces, kit))
    end function

    pure function letters(text) result(c)
        character(len=*), intent(in) :: text
        character(kind=c_char) :: c(len(text) + 1)
        integer :: i
        do i = 1, len(text)
            c(i) = text(i:i)
        end do
        c(len(text) + 1) = c_null_char
    end function
end module
