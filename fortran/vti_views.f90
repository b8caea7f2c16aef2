! SPDX-License-Identifier: BSD-3-Clause
!
!> vti_views -- views of Fortran arrays: addresses and strides, never a copy. Part of module vti.
!>
!> Any section of an array of reals will do: a step along the bodies, three rows of a wider table, an array backwards.
!> Members of an array of a derived type go by vti_view_member and vti_scalars_member, not as body%x(1) or body%mass:
!> gfortran hands on the address of body(1) itself. The checks then refuse three such components (VTI_E_ALIAS) and
!> such scalars (VTI_E_MASS, VTI_E_INERTIA).
!>
!> The dummies are pointers so that the compiler refuses what has no address to keep: expressions, arrays without
!> TARGET. (gfortran lets a vector subscript pass, as a copy: do not use one.) An array of no bodies, or a disassociated
!> pointer, gives the absent view. An array of the wrong shape gives one that every call refuses with VTI_E_VIEW, so
!> that constructors need no status. An array has its extent, which the view keeps: one of fewer bodies than are moved
!> is refused with VTI_E_COUNT. Of members (vti_view_member, vti_scalars_member) no extent is known.
module vti_views
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_int64_t, c_intptr_t, &
        c_loc, c_null_ptr, c_ptr
    use vti_types, only: vti_bodies, vti_quat_view, vti_scalars, vti_view
    implicit none
    private
    public :: vti_view_columns, vti_view_rows, vti_view_separate, vti_view_member
    public :: vti_quat_view_columns, vti_quat_view_rows
    public :: vti_scalars_one, vti_scalars_array, vti_scalars_member
    public :: vti_bodies_none, vti_bodies_slice

    !> One value that every check refuses, NaN: for scalars of the wrong shape, and where views of it begin.
    real(c_double), target, protected :: refused = transfer(9221120237041090560_c_int64_t, 0._c_double)

contains

    !> a(3,n): one body in each column.
    function vti_view_columns(a) result(view)
        real(c_double), pointer, intent(in) :: a(:, :)
        type(vti_view) :: view
        integer :: i
        if (.not. associated(a)) return
        if (size(a, 2) == 0) return
        i = lbound(a, 1)
        if (size(a, 1) == 3) then
            view = vti_view_separate(a(i, :), a(i + 1, :), a(i + 2, :))
        else
            view%c(1) = c_loc(refused) ! given in part
        end if
    end function

    !> a(n,3): one body in each row.
    function vti_view_rows(a) result(view)
        real(c_double), pointer, intent(in) :: a(:, :)
        type(vti_view) :: view
        integer :: i
        if (.not. associated(a)) return
        if (size(a, 1) == 0) return
        i = lbound(a, 2)
        if (size(a, 2) == 3) then
            view = vti_view_separate(a(:, i), a(:, i + 1), a(:, i + 2))
        else
            view%c(1) = c_loc(refused) ! given in part
        end if
    end function

    !> Three arrays of n, or sections with equal strides.
    function vti_view_separate(x, y, z) result(view)
        real(c_double), pointer, intent(in) :: x(:), y(:), z(:)
        type(vti_view) :: view
        view%c = [address(x), address(y), address(z)]
        view%stride = stride(x)
        if (stride(y) /= stride(x) .or. stride(z) /= stride(x)) view%c(2:) = c_null_ptr ! given in part
        view%count = min(extent(x), extent(y), extent(z))
    end function

    !> A member x(3) of an array of a derived type: c_loc(body(1)%x), and storage_size(body, c_int64_t)/8 bytes from one
    !> body to the next, which must be whole doubles.
    function vti_view_member(p, bytes) result(view)
        type(c_ptr), intent(in) :: p
        integer(c_int64_t), intent(in) :: bytes
        type(vti_view) :: view
        real(c_double), pointer :: x(:)
        if (.not. c_associated(p)) return
        call c_f_pointer(p, x, [3])
        view%c = [c_loc(x(1)), c_loc(x(2)), c_loc(x(3))]
        view%stride = doubles(bytes)
    end function

    !> q(4,n): one quaternion x, y, z, w in each column.
    function vti_quat_view_columns(q) result(view)
        real(c_double), pointer, intent(in) :: q(:, :)
        type(vti_quat_view) :: view
        integer :: i
        if (.not. associated(q)) return
        if (size(q, 2) == 0) return
        i = lbound(q, 1)
        view%xyzw(1) = c_loc(refused) ! given in part
        if (size(q, 1) /= 4) return
        view%xyzw = [address(q(i, :)), address(q(i + 1, :)), address(q(i + 2, :)), address(q(i + 3, :))]
        view%stride = stride(q(i, :))
        view%count = size(q, 2, c_int64_t)
    end function

    !> q(n,4): one quaternion x, y, z, w in each row.
    function vti_quat_view_rows(q) result(view)
        real(c_double), pointer, intent(in) :: q(:, :)
        type(vti_quat_view) :: view
        integer :: i
        if (.not. associated(q)) return
        if (size(q, 1) == 0) return
        i = lbound(q, 2)
        view%xyzw(1) = c_loc(refused) ! given in part
        if (size(q, 2) /= 4) return
        view%xyzw = [address(q(:, i)), address(q(:, i + 1)), address(q(:, i + 2)), address(q(:, i + 3))]
        view%stride = stride(q(:, i))
        view%count = size(q, 1, c_int64_t)
    end function

    !> One value for all bodies.
    function vti_scalars_one(value) result(scalars)
        real(c_double), pointer, intent(in) :: value
        type(vti_scalars) :: scalars
        if (associated(value)) scalars%p = c_loc(value)
    end function

    !> values(n): one value for each body, without gaps.
    function vti_scalars_array(values) result(scalars)
        real(c_double), pointer, intent(in) :: values(:)
        type(vti_scalars) :: scalars
        scalars = vti_scalars(address(values), stride(values), extent(values))
        if (c_associated(scalars%p) .and. scalars%stride /= 1) scalars = vti_scalars(p=c_loc(refused))
    end function

    !> A member or a section: c_loc(body(1)%mass), and bytes from one body to the next, which must be whole doubles.
    function vti_scalars_member(p, bytes) result(scalars)
        type(c_ptr), intent(in) :: p
        integer(c_int64_t), intent(in) :: bytes
        type(vti_scalars) :: scalars
        scalars = vti_scalars(p=p, stride=doubles(bytes))
        if (scalars%stride == 0) scalars%p = c_loc(refused)
    end function

    !> n bodies of which nothing is known yet.
    pure function vti_bodies_none(n) result(bodies)
        integer(c_int64_t), intent(in) :: n
        type(vti_bodies) :: bodies
        bodies%count = n
    end function

    !> The same bodies, restricted to count of them from body first, which counts from 1.
    pure function vti_bodies_slice(bodies, first, count) result(part)
        type(vti_bodies), intent(in) :: bodies
        integer(c_int64_t), intent(in) :: first, count
        type(vti_bodies) :: part
        part = bodies
        part%first = first - 1
        part%count = count
        part%sealed = 0
    end function

    !> Where x begins; null if there is nothing.
    function address(x) result(p)
        real(c_double), pointer, intent(in) :: x(:)
        type(c_ptr) :: p
        p = c_null_ptr
        if (.not. associated(x)) return
        if (size(x) > 0) p = c_loc(x(lbound(x, 1)))
    end function

    !> How many there are.
    function extent(x) result(n)
        real(c_double), pointer, intent(in) :: x(:)
        integer(c_int64_t) :: n
        n = 0
        if (associated(x)) n = size(x, kind=c_int64_t)
    end function

    !> Distance of x(2) from x(1) in doubles.
    function stride(x) result(s)
        real(c_double), pointer, intent(in) :: x(:)
        integer(c_int64_t) :: s
        integer :: i
        s = 0
        if (.not. associated(x)) return
        s = 1 ! of one body any will do
        if (size(x) < 2) return
        i = lbound(x, 1)
        s = doubles(int(transfer(c_loc(x(i + 1)), 0_c_intptr_t) - transfer(c_loc(x(i)), 0_c_intptr_t), c_int64_t))
    end function

    !> The same distance in doubles; 0, which the checks refuse, if it is not a whole number of them.
    pure function doubles(bytes) result(s)
        integer(c_int64_t), intent(in) :: bytes
        integer(c_int64_t) :: s
        s = merge(bytes/8, 0_c_int64_t, mod(bytes, 8_c_int64_t) == 0)
    end function
end module
