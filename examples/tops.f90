! SPDX-License-Identifier: BSD-3-Clause
! Bodies that are not spheres in a code without types: n free tops, thrown about their middle axis, turn over again and
! again. Plain arrays: three moments of each body in the place of its inertia, its angular momentum L in that of omega.
program tops
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use, intrinsic :: iso_fortran_env, only: error_unit
    use vti
    implicit none
    integer(c_int64_t), parameter :: n = 3, steps = 20000
    real(c_double), parameter :: h = 0.01_c_double, none(3, n) = 0
    real(c_double) :: alpha(3, n), spin(3, n), start(3, n), moments(3, n), energy(n), least(n), most(n), middle(n)
    integer(c_int64_t) :: exact, i, k
    integer :: flips(n)

    do i = 1, n
        moments(:, i) = [1.0_c_double, 2.0_c_double, 3.0_c_double]*i
        spin(:, i) = moments(:, i)*[1e-3_c_double, 1.0_c_double, 1e-3_c_double] ! L = I Omega, unturned
    end do
    start = spin
    alpha = 0
    energy = [(kinetic(i), i=1, n)]
    least = energy
    most = energy
    middle = spin(2, :)
    flips = 0
    do k = 1, vti_stepper_count()
        if (stepper_name(k) == 'exact') exact = k
    end do
    do k = 1, steps
        call must(vti_packed_begin(exact, h, n, alpha=alpha, omega=spin, moment=none, masses=1_c_int64_t, &
            inertias=3*n, inertia=moments))
        ! forces and moments of the code's own would be computed here
        call must(vti_packed_finish(exact, h, n, omega=spin, moment=none, masses=1_c_int64_t, &
            inertias=3*n, inertia=moments))
        do i = 1, n
            least(i) = min(least(i), kinetic(i))
            most(i) = max(most(i), kinetic(i))
            if (along(2_c_int64_t, i)*middle(i) < 0) then
                middle(i) = -middle(i)
                flips(i) = flips(i) + 1
            end if
        end do
    end do
    do i = 1, n
        print '(a, i0, a, i0, a, es8.1)', 'top ', i, ' turns over ', flips(i), ' times; energy within ', &
            (most(i) - least(i))/energy(i)
    end do
    ! L is not touched by a drift; the list of turns is of order 4, so that the energy swings by little and stays.
    if (any(abs(spin - start) > 0)) call stop_for('L of a free body has changed')
    if (any(flips < 5)) call stop_for('a top does not turn over')
    if (any(most - least > 1e-10_c_double*energy)) call stop_for('the energy leaves its band')

contains
    function stepper_name(k) result(name)
        integer(c_int64_t), intent(in) :: k
        character(len=:), allocatable :: name
        type(vti_stepper) :: method
        method = vti_stepper_at(k)
        name = vti_text(method%name)
    end function

    !> Component of L along the body's own axis a, R e_a . L
    function along(a, i) result(p)
        integer(c_int64_t), intent(in) :: a, i
        real(c_double) :: p, axis(3), e(3)
        e = 0
        e(a) = 1
        axis = vti_rrv_rotate(alpha(:, i), e)
        p = dot_product(axis, spin(:, i))
    end function

    !> Sum of p_a^2/(2 I_a)
    function kinetic(i) result(t)
        integer(c_int64_t), intent(in) :: i
        real(c_double) :: t
        integer(c_int64_t) :: a
        t = sum([(along(a, i)**2/(2*moments(a, i)), a=1, 3)])
    end function

    subroutine must(status)
        integer(c_int), intent(in) :: status
        if (status /= VTI_OK) call stop_for(vti_status_text(status))
    end subroutine

    subroutine stop_for(what)
        character(len=*), intent(in) :: what
        write (error_unit, '(2a)') 'tops: ', what
        stop 1
    end subroutine
end program
