! SPDX-License-Identifier: BSD-3-Clause
!
!> vti_rrv -- the algebra of vti_rrv.h: rotations as rescaled Rodrigues vectors alpha(3), |alpha| = 2 tan(theta/2). Its
!> contracts are those of vti_rrv.h, its bits too: each function calls the one of C. Quaternions are (4), in the order
!> x, y, z, w; matrices are (3,3), so that matmul(vti_rrv_to_matrix(a), p) is vti_rrv_rotate(a, p). Part of module vti.
module vti_rrv
    use, intrinsic :: iso_c_binding, only: c_double
    implicit none
    private
    public :: vti_rrv_compose, vti_rrv_inverse, vti_rrv_relative, vti_rrv_relative_printed
    public :: vti_rrv_turn, vti_rrv_turn_body
    public :: vti_rrv_rotate, vti_rrv_rotate_back, vti_rrv_angle, vti_rrv_distance
    public :: vti_rrv_from_rotvec, vti_rrv_to_rotvec, vti_rrv_from_quat_xyzw, vti_rrv_to_quat_xyzw
    public :: vti_rrv_from_matrix, vti_rrv_to_matrix

    interface
        pure subroutine c_compose(a, b, r) bind(c, name='vti_rrv_compose_f')
            import :: c_double
            real(c_double), intent(in) :: a(3), b(3)
            real(c_double), intent(out) :: r(3)
        end subroutine
        pure subroutine c_inverse(a, r) bind(c, name='vti_rrv_inverse_f')
            import :: c_double
            real(c_double), intent(in) :: a(3)
            real(c_double), intent(out) :: r(3)
        end subroutine
        pure subroutine c_relative(a, b, r) bind(c, name='vti_rrv_relative_f')
            import :: c_double
            real(c_double), intent(in) :: a(3), b(3)
            real(c_double), intent(out) :: r(3)
        end subroutine
        pure subroutine c_from_rotvec(theta, a) bind(c, name='vti_rrv_from_rotvec_f')
            import :: c_double
            real(c_double), intent(in) :: theta(3)
            real(c_double), intent(out) :: a(3)
        end subroutine
        pure subroutine c_to_rotvec(a, theta) bind(c, name='vti_rrv_to_rotvec_f')
            import :: c_double
            real(c_double), intent(in) :: a(3)
            real(c_double), intent(out) :: theta(3)
        end subroutine
        pure subroutine c_to_quat_xyzw(a, q) bind(c, name='vti_rrv_to_quat_xyzw_f')
            import :: c_double
            real(c_double), intent(in) :: a(3)
            real(c_double), intent(out) :: q(4)
        end subroutine
        pure subroutine c_from_quat_xyzw(q, a) bind(c, name='vti_rrv_from_quat_xyzw_f')
            import :: c_double
            real(c_double), intent(in) :: q(4)
            real(c_double), intent(out) :: a(3)
        end subroutine
        pure subroutine c_to_matrix(a, r) bind(c, name='vti_rrv_to_matrix_f')
            import :: c_double
            real(c_double), intent(in) :: a(3)
            real(c_double), intent(out) :: r(9)
        end subroutine
        pure subroutine c_from_matrix(r, a) bind(c, name='vti_rrv_from_matrix_f')
            import :: c_double
            real(c_double), intent(in) :: r(9)
            real(c_double), intent(out) :: a(3)
        end subroutine
        pure subroutine c_turn_side(c, u, side, a) bind(c, name='vti_rrv_turn_side_f')
            import :: c_double
            real(c_double), value :: c, side
            real(c_double), intent(in) :: u(3)
            real(c_double), intent(inout) :: a(3)
        end subroutine
        pure subroutine c_rotate_side(a, side, p, r) bind(c, name='vti_rrv_rotate_side_f')
            import :: c_double
            real(c_double), intent(in) :: a(3), p(3)
            real(c_double), value :: side
            real(c_double), intent(out) :: r(3)
        end subroutine
        pure function c_angle(a) result(theta) bind(c, name='vti_rrv_angle_f')
            import :: c_double
            real(c_double), intent(in) :: a(3)
            real(c_double) :: theta
        end function
        pure function c_distance(a, b) result(theta) bind(c, name='vti_rrv_distance_f')
            import :: c_double
            real(c_double), intent(in) :: a(3), b(3)
            real(c_double) :: theta
        end function
    end interface

contains

    !> r = a (+) b, R(r) = R(b) R(a): first a, then b.
    pure function vti_rrv_compose(a, b) result(r)
        real(c_double), intent(in) :: a(3), b(3)
        real(c_double) :: r(3)
        call c_compose(a, b, r)
    end function

    !> r = -a, R(r) = R(a)^T.
    pure function vti_rrv_inverse(a) result(r)
        real(c_double), intent(in) :: a(3)
        real(c_double) :: r(3)
        call c_inverse(a, r)
    end function

    !> R(r) = R(a) R(b)^T: what turns b into a.
    pure function vti_rrv_relative(a, b) result(r)
        real(c_double), intent(in) :: a(3), b(3)
        real(c_double) :: r(3)
        call c_relative(a, b, r)
    end function

    !> R(r) = R(b) R(a)^T: what the paper prints as alpha_(ij) (erratum E5).
    pure function vti_rrv_relative_printed(a, b) result(r)
        real(c_double), intent(in) :: a(3), b(3)
        real(c_double) :: r(3)
        call c_relative(b, a, r)
    end function

    !> a, turned further by the increment 2 u/c in space, R(r) = R(2 u/c) R(a); c and u not both 0.
    pure function vti_rrv_turn(c, u, a) result(r)
        real(c_double), intent(in) :: c, u(3), a(3)
        real(c_double) :: r(3)
        r = a
        call c_turn_side(c, u, 1.0_c_double, r)
    end function

    !> The same increment in the body's frame, R(r) = R(a) R(2 u/c).
    pure function vti_rrv_turn_body(c, u, a) result(r)
        real(c_double), intent(in) :: c, u(3), a(3)
        real(c_double) :: r(3)
        r = a
        call c_turn_side(c, u, -1.0_c_double, r)
    end function

    !> R(a) p, body to space.
    pure function vti_rrv_rotate(a, p) result(r)
        real(c_double), intent(in) :: a(3), p(3)
        real(c_double) :: r(3)
        call c_rotate_side(a, 1.0_c_double, p, r)
    end function

    !> R(a)^T p, space to body.
    pure function vti_rrv_rotate_back(a, p) result(r)
        real(c_double), intent(in) :: a(3), p(3)
        real(c_double) :: r(3)
        call c_rotate_side(a, -1.0_c_double, p, r)
    end function

    !> Angle by which a turns, in [0, pi].
    pure function vti_rrv_angle(a) result(theta)
        real(c_double), intent(in) :: a(3)
        real(c_double) :: theta
        theta = c_angle(a)
    end function

    !> Angle between two attitudes, in [0, pi].
    pure function vti_rrv_distance(a, b) result(theta)
        real(c_double), intent(in) :: a(3), b(3)
        real(c_double) :: theta
        theta = c_distance(a, b)
    end function

    !> alpha of a rotation vector (radians).
    pure function vti_rrv_from_rotvec(theta) result(a)
        real(c_double), intent(in) :: theta(3)
        real(c_double) :: a(3)
        call c_from_rotvec(theta, a)
    end function

    !> Rotation vector of a, |theta| in [0, pi].
    pure function vti_rrv_to_rotvec(a) result(theta)
        real(c_double), intent(in) :: a(3)
        real(c_double) :: theta(3)
        call c_to_rotvec(a, theta)
    end function

    !> alpha of a quaternion, which need not be normalised.
    pure function vti_rrv_from_quat_xyzw(q) result(a)
        real(c_double), intent(in) :: q(4)
        real(c_double) :: a(3)
        call c_from_quat_xyzw(q, a)
    end function

    !> Unit quaternion of a, with w >= 0.
    pure function vti_rrv_to_quat_xyzw(a) result(q)
        real(c_double), intent(in) :: a(3)
        real(c_double) :: q(4)
        call c_to_quat_xyzw(a, q)
    end function

    !> alpha of a rotation matrix.
    pure function vti_rrv_from_matrix(matrix) result(a)
        real(c_double), intent(in) :: matrix(3, 3)
        real(c_double) :: a(3)
        call c_from_matrix(reshape(transpose(matrix), [9]), a) ! of C, row by row
    end function

    !> R(a).
    pure function vti_rrv_to_matrix(a) result(matrix)
        real(c_double), intent(in) :: a(3)
        real(c_double) :: matrix(3, 3), rows(9)
        call c_to_matrix(a, rows)
        matrix = transpose(reshape(rows, [3, 3]))
    end function
end module
