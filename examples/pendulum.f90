! SPDX-License-Identifier: BSD-3-Clause
! A complete host: the paper's pendulum by VTI-2. The moment is this program's own; the library moves the body.
program pendulum
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use, intrinsic :: iso_fortran_env, only: error_unit
    use vti
    implicit none
    integer(c_int64_t), parameter :: n = 1, steps = 640
    real(c_double), parameter :: h = 1.0_c_double/64, weight = 1, rho0(3) = [0, 0, 1]
    real(c_double), target :: alpha(3, n), omega(3, n), moment(3, n), inertia = 1
    real(c_double) :: arm(3)
    integer(c_int64_t) :: i, k
    type(vti_bodies) :: bodies
    type(vti_stepper) :: method

    alpha(:, 1) = [0.0_c_double, 4.82842712474619_c_double, 0.0_c_double] ! 2 tan(3 pi/8): turned by 3 pi/4 about e2
    omega(:, 1) = [0.2_c_double, 0.0_c_double, 0.2_c_double]
    bodies = vti_bodies_none(n)
    bodies%alpha = vti_view_columns(alpha)
    bodies%omega = vti_view_columns(omega)
    bodies%moment = vti_view_columns(moment)
    bodies%inertia = vti_scalars_one(inertia)
    call must(vti_bodies_check_values(bodies))

    method = vti_stepper_find('vti2')
    call own_moments()
    call must(vti_step_start(method, h, bodies))
    do k = 1, steps
        call must(vti_step_begin(method, h, bodies))
        call own_moments()
        call must(vti_step_finish(method, h, bodies))
    end do
    arm = vti_rrv_rotate(alpha(:, 1), rho0)
    print '(a, f4.1, a, f14.12, a, es8.1)', 't = ', steps*h, '  energy = ', &
        vti_kinetic_rotation(bodies) - weight*arm(3), '  R rho0 . Omega = ', dot_product(arm, omega(:, 1))

contains
    !> RM = weight (R rho0) x e3
    subroutine own_moments()
        do i = 1, n
            arm = vti_rrv_rotate(alpha(:, i), rho0)
            moment(:, i) = weight*[arm(2), -arm(1), 0.0_c_double]
        end do
    end subroutine

    subroutine must(status)
        integer(c_int), intent(in) :: status
        if (status == VTI_OK) return
        write (error_unit, '(2a)') 'pendulum: ', vti_status_text(status)
        stop 1
    end subroutine
end program
