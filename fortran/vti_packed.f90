! SPDX-License-Identifier: BSD-3-Clause
!
!> vti_packed -- calls for codes with plain x(3,n) arrays that want neither types nor TARGET. Part of module vti.
!> stepper as in vti_stepper_at. Arrays that are left out (call by keyword) are absent physics. masses and inertias: 1
!> (one value for all) or n; or inertias = 3n for bodies that are not spheres: then inertia(3,n) are the three moments
!> of each, about the body's own axes, and omega(3,n) is its angular momentum L. Same arithmetic, same bits as through
!> views.
module vti_packed
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_loc, c_null_ptr, c_ptr
    use vti_c
    implicit none
    private
    public :: vti_packed_begin, vti_packed_finish

contains

    !> vti_step_begin. On VTI_E_TOO_LARGE body receives the number of the body, from 1, and value its h|Omega|;
    !> VTI_E_STEPPER and VTI_E_COUNT leave 0 and h there.
    function vti_packed_begin(stepper, h, n, x, v, force, alpha, omega, moment, masses, mass, inertias, inertia, body, &
        value) result(status)
        integer(c_int64_t), intent(in) :: stepper, n, masses, inertias
        real(c_double), intent(in) :: h
        real(c_double), intent(inout), optional, target :: x(3, n), v(3, n), alpha(3, n), omega(3, n)
        real(c_double), intent(in), optional, target :: force(3, n), moment(3, n), mass(masses), inertia(inertias)
        integer(c_int64_t), intent(out), optional :: body
        real(c_double), intent(out), optional :: value
        integer(c_int) :: status
        type(vti_fault) :: found
        status = c_packed_begin(stepper - 1, h, n, location(x), location(v), location(force), location(alpha), &
            location(omega), location(moment), masses, location(mass), inertias, location(inertia), found%body, &
            found%value)
        if (present(body)) body = found%body + 1
        if (present(value)) value = found%value
    end function

    !> vti_step_finish.
    function vti_packed_finish(stepper, h, n, v, force, omega, moment, masses, mass, inertias, inertia) result(status)
        integer(c_int64_t), intent(in) :: stepper, n, masses, inertias
        real(c_double), intent(in) :: h
        real(c_double), intent(inout), optional, target :: v(3, n), omega(3, n)
        real(c_double), intent(in), optional, target :: force(3, n), moment(3, n), mass(masses), inertia(inertias)
        integer(c_int) :: status
        status = c_packed_finish(stepper - 1, h, n, location(v), location(force), location(omega), location(moment), &
            masses, location(mass), inertias, location(inertia))
    end function

    !> Where a begins; null if it is left out.
    function location(a) result(p)
        real(c_double), intent(in), optional, target :: a(*)
        type(c_ptr) :: p
        p = c_null_ptr
        if (present(a)) p = c_loc(a)
    end function
end module
