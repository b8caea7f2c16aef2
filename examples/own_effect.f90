! SPDX-License-Identifier: BSD-3-Clause
! A host's own effect, stepped, bounded, refused and measured like the library's: a trap F = -k x with a drag -c v.
module trap
    use, intrinsic :: iso_c_binding, only: c_double, c_f_pointer, c_funloc, c_funptr, c_int, c_int64_t, c_loc, c_ptr
    use vti
    implicit none
    integer(c_int64_t), parameter :: n = 2
    real(c_double), target :: x(3, n), v(3, n), force(3, n), mass(n)

    type :: fluid
        real(c_double) :: stiffness, drag
        type(vti_sum) :: lost ! what the drag has taken
    end type

contains
    !> F = -k x
    subroutine pull(self, bodies) bind(c)
        type(c_ptr), value :: self
        type(vti_bodies), intent(in) :: bodies
        type(fluid), pointer :: f
        integer(c_int64_t) :: i
        call c_f_pointer(self, f)
        do i = bodies%first + 1, bodies%first + bodies%count
            force(:, i) = force(:, i) - f%stiffness*x(:, i)
        end do
    end subroutine

    !> U = k/2 |x|^2
    subroutine energy(self, bodies, energies) bind(c)
        type(c_ptr), value :: self
        type(vti_bodies), intent(in) :: bodies
        real(c_double), intent(inout) :: energies(*)
        type(fluid), pointer :: f
        call c_f_pointer(self, f)
        energies(1) = f%stiffness/2*sum(x(:, bodies%first + 1:bodies%first + bodies%count)**2)
    end subroutine

    !> The stiffness k at every body, along any direction: an energy, k times the length squared.
    function springs(self, bodies, at, visit, context) result(status) bind(c)
        type(c_ptr), value :: self, at, context
        type(vti_bodies), intent(in) :: bodies
        type(c_funptr), value :: visit
        integer(c_int) :: status
        type(fluid), pointer :: f
        integer(c_int64_t) :: i
        call c_f_pointer(self, f)
        associate (anywhere => at) ! the same wherever the bodies are
        end associate
        do i = bodies%first + 1, bodies%first + bodies%count
            call vti_show_spring(visit, context, vti_spring(element=i, i=i, axial=f%stiffness, across=f%stiffness))
        end do
        status = VTI_OK
    end function

    !> v <- v exp(-c t/m), exactly, whatever t is.
    subroutine damp(self, bodies, t, drift) bind(c)
        type(c_ptr), value :: self
        type(vti_bodies), intent(in) :: bodies
        real(c_double), value :: t, drift
        type(fluid), pointer :: f
        real(c_double) :: keeps
        integer(c_int64_t) :: i
        call c_f_pointer(self, f)
        associate (anywhere => drift) ! the drag does not depend on positions
        end associate
        do i = bodies%first + 1, bodies%first + bodies%count
            keeps = exp(-f%drag*t/mass(i))
            call vti_sum_add(f%lost, mass(i)/2*dot_product(v(:, i), v(:, i))*(1 - keeps**2))
            v(:, i) = v(:, i)*keeps
        end do
    end subroutine
end module

program own_effect
    use, intrinsic :: iso_fortran_env, only: error_unit
    use trap
    implicit none
    integer, parameter :: steps = 200
    type(fluid), target :: own = fluid(4.0_c_double, 0.3_c_double, vti_sum())
    type(vti_effect) :: effect
    type(vti_bodies) :: bodies
    type(vti_stepper) :: method
    type(vti_stable) :: stable
    type(vti_fault) :: fault
    real(c_double) :: h, start, off, scratch(n)
    integer(c_int) :: status
    integer :: k

    x = reshape([1.0_c_double, 0.0_c_double, 0.5_c_double, 0.0_c_double, -2.0_c_double, 0.0_c_double], [3, 2])
    v = reshape([0.0_c_double, 1.0_c_double, 0.0_c_double, 0.5_c_double, 0.0_c_double, 0.5_c_double], [3, 2])
    mass = [1, 2]
    effect%self = c_loc(own)
    effect%apply = c_funloc(pull)
    effect%energy = c_funloc(energy)
    effect%springs = c_funloc(springs)
    effect%flow = c_funloc(damp)
    effect%needs = ibset(ibset(ibset(0_c_int64_t, VTI_QUANTITY_X), VTI_QUANTITY_V), VTI_QUANTITY_MASS)
    effect%gives = ibset(0_c_int64_t, VTI_QUANTITY_FORCE)
    effect%smooth = 1
    effect%breaks = VTI_BREAKS_LINEAR + VTI_BREAKS_ANGULAR
    effect%dissipates = 1
    effect%terms = 1
    effect%books = 1
    effect%booked = c_loc(own%lost)
    bodies = vti_bodies_none(n)
    bodies%v = vti_view_columns(v)
    bodies%force = vti_view_columns(force)
    bodies%mass = vti_scalars_array(mass)

    status = vti_effects_check([effect], bodies, fault)
    print '(a, i0, 4a)', 'without positions: effect ', fault%body, ' needs ', vti_quantity_text(fault%quantity), ': ', &
        vti_status_text(status)
    bodies%x = vti_view_columns(x)
    call must(vti_bodies_check_values(bodies))
    call must(vti_effects_check([effect], bodies))
    print '(2a)', 'by srkn14: ', vti_status_text(vti_step_check(vti_stepper_find('srkn14'), [effect]))

    call must(vti_stable_step([effect], bodies, scratch, stable, vti_deformation()))
    print '(a, f17.15, 2(a, i0))', 'stable below h = ', stable%h, ', by effect ', stable%effect, ' at body ', stable%i

    method = vti_stepper_find('vti2')
    h = stable%h/50
    start = vti_energy([effect], bodies)
    call must(vti_apply([effect], bodies))
    do k = 1, steps
        call must(vti_effects_begin(method, h, [effect], bodies))
        call must(vti_apply([effect], bodies))
        call must(vti_effects_finish(method, h, [effect], bodies))
    end do
    off = vti_energy([effect], bodies) + vti_booked([effect]) - start
    print '(3(a, f9.6), a, es8.1)', 'energy ', start, ' -> ', vti_energy([effect], bodies), ', booked ', &
        vti_booked([effect]), ', together off by ', off
    if (.not. (abs(stable%h - 1) < 1e-15_c_double .and. abs(off) < 1e-3_c_double*start)) stop 1

contains
    subroutine must(status)
        integer(c_int), intent(in) :: status
        if (status == VTI_OK) return
        write (error_unit, '(2a)') 'own_effect: ', vti_status_text(status)
        stop 1
    end subroutine
end program
