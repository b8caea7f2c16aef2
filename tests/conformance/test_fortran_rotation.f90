! SPDX-License-Identifier: BSD-3-Clause
!> The algebra of rotations from Fortran: every function gives C's bits, and a matrix is the right way round.
program test_fortran_rotation
    use, intrinsic :: ieee_arithmetic, only: ieee_is_nan
    use, intrinsic :: iso_c_binding, only: c_double
    use, intrinsic :: iso_fortran_env, only: int64
    use common, only: expect, finish
    use vti
    implicit none
    interface
        subroutine shim_rotations(a, b, c, r) bind(c)
            import :: c_double
            real(c_double), intent(in) :: a(3), b(3)
            real(c_double), value :: c
            real(c_double), intent(out) :: r(56)
        end subroutine
    end interface
    real(c_double), parameter :: sizes(7) = [0d0, 1d-9, 0.3d0, 2d0, 50d0, 1d9, 1d18]
    real(c_double) :: a(3), b(3), c, quarter(3), p(3)
    integer :: i, k

    do i = 1, size(sizes)
        do k = 1, size(sizes)
            a = sizes(i)*[0.5d0, -0.7d0, 0.25d0]
            b = sizes(k)*[-0.1d0, 0.9d0, 0.45d0]
            c = 0.25d0*(i + k)
            call compare()
        end do
    end do
    quarter = vti_rrv_from_rotvec([0d0, 0d0, 2*atan(1d0)]) ! a quarter turn about z takes x to y
    p = matmul(vti_rrv_to_matrix(quarter), [1d0, 0d0, 0d0])
    call expect(maxval(abs(p - [0d0, 1d0, 0d0])) < 4*epsilon(p), 'a matrix turns x to y, not to -y')
    p = vti_rrv_rotate(quarter, [1d0, 0d0, 0d0])
    call expect(maxval(abs(p - [0d0, 1d0, 0d0])) < 4*epsilon(p), 'a vector is turned from x to y')
    call without_modules()
    call measures_of_nothing_sound()
    call finish()

contains
    !> What codes without modules call.
    subroutine without_modules()
        external :: vtirot, vtirel
        real(c_double) :: r(3)
        a = [0.3d0, -0.7d0, 0.25d0]
        b = [-0.1d0, 0.9d0, 0.45d0]
        call vtirot(a, b, r)
        call expect(all(transfer(r, [0_int64]) == transfer(vti_rrv_rotate(a, b), [0_int64])), 'VTIROT')
        call vtirel(a, b, r)
        r = vti_rrv_compose(b, vti_rrv_from_rotvec(r)) ! first b, then what takes it to a
        call expect(maxval(abs(r - a)) < 16*epsilon(r), 'VTIREL takes B to A')
    end subroutine

    !> Bodies that every call refuses measure as no number.
    subroutine measures_of_nothing_sound()
        type(vti_bodies) :: stale
        real(c_double) :: s(3)
        stale%abi = VTI_ABI + 1
        s = 0
        call vti_momentum(stale, s)
        call expect(all(ieee_is_nan(s)), 'momentum of bodies of another version')
        call expect(ieee_is_nan(vti_kinetic_rotation(stale)), 'energy of bodies of another version')
    end subroutine

    subroutine compare()
        real(c_double) :: ours(56), theirs(56), matrix(3, 3)
        matrix = vti_rrv_to_matrix(a)
        ours = 0
        ours(1:24) = [vti_rrv_compose(a, b), vti_rrv_inverse(a), vti_rrv_relative(a, b), vti_rrv_turn(c, b, a), &
            vti_rrv_turn_body(c, b, a), vti_rrv_rotate(a, b), vti_rrv_rotate_back(a, b), vti_rrv_angle(a), &
            vti_rrv_distance(a, b), 0d0]
        ours(24:36) = [vti_rrv_from_rotvec(b), vti_rrv_to_rotvec(a), vti_rrv_from_quat_xyzw([b, c]), &
            vti_rrv_to_quat_xyzw(a)]
        ours(37:48) = [reshape(transpose(matrix), [9]), vti_rrv_from_matrix(matrix)]
        ours(49:51) = [matrix(1, 1)*b(1) + matrix(1, 2)*b(2) + matrix(1, 3)*b(3), &
            matrix(2, 1)*b(1) + matrix(2, 2)*b(2) + matrix(2, 3)*b(3), &
            matrix(3, 1)*b(1) + matrix(3, 2)*b(2) + matrix(3, 3)*b(3)]
        ours(52:54) = vti_rrv_relative_printed(a, b)
        call shim_rotations(a, b, c, theirs)
        call expect(all(transfer(ours, [0_int64]) == transfer(theirs, [0_int64])), 'the bits are those of C')
    end subroutine
end program
