! SPDX-License-Identifier: BSD-3-Clause
!
!> vti -- vti.h in Fortran: the same names, the caller's arrays, the same bits. Frames, units and contracts are those
!> of vti.h. Every integer function returns VTI_OK or a negative status and has then changed nothing; nothing stops or
!> prints.
!>
!> What is different because Fortran is:
!>  - Bodies and steppers are counted from 1, in arguments and in vti_fault (0: no body is to blame). Two things keep
!>    the numbers of C: first in vti_bodies, which vti_bodies_slice sets, and stages (vti_step_begin is stage 0).
!>  - An array behind a view must have the TARGET attribute, which the compiler checks where the view is made, and must
!>    stay where it is while the view is used. A procedure that takes a step and has the array as a dummy argument says
!>    TARGET there too; without it the compiler may assume that the step leaves the array alone.
!>  - fault is optional wherever C takes NULL; the number of effects is the size of the array.
!>  - Steppers are values. Where C answers NULL, stages is 0, and every call with that stepper returns VTI_E_NULL.
!>
!> Views are made by module vti_views, types and measures come from module vti_c; use vti brings it all.
module vti
    use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_double, c_f_pointer, c_int, c_int64_t, c_loc, &
        c_null_char, c_null_ptr, c_ptr
    use vti_c
    use vti_views
    implicit none
    public
    private :: c_associated, c_char, c_double, c_f_pointer, c_int, c_int64_t, c_loc, c_null_char, c_null_ptr, c_ptr
    private :: c_bodies_check_values, c_drift, c_stepper_find, c_stepper_at, c_step_stage, c_step_finish, &
        c_step_start, c_step_sync, c_apply, c_energy, c_pendulum_effect, c_pendulum_arm, c_packed_begin, &
        c_packed_finish, c_status_text, c_version, c_strlen
    private :: location, stepper_value, handle, blame

contains

    ! ---- checks and the two primitives ----------------------------------------------------------------------------

    !> vti_bodies_check, and every mass and inertia of the slice finite and > 0.
    function vti_bodies_check_values(bodies, fault) result(status)
        type(vti_bodies), intent(in) :: bodies
        type(vti_fault), intent(out), optional :: fault
        integer(c_int) :: status
        type(vti_fault) :: found
        status = c_bodies_check_values(bodies, found)
        if (present(fault)) fault = blame(found)
    end function

    !> x += t v, alpha <- alpha (+) dalpha(t Omega) by the law and frame. t finite, of either sign. If any body breaks
    !> the closed form's bound t|Omega| < 1, VTI_E_TOO_LARGE and nothing is written.
    function vti_drift(law, frame, t, bodies, fault) result(status)
        integer(c_int), intent(in) :: law, frame
        real(c_double), intent(in) :: t
        type(vti_bodies), intent(in) :: bodies
        type(vti_fault), intent(out), optional :: fault
        integer(c_int) :: status
        type(vti_fault) :: found
        status = c_drift(law, frame, t, bodies, found)
        if (present(fault)) fault = blame(found)
    end function

    !> A fault of C in the numbering of this module.
    pure function blame(found) result(fault)
        type(vti_fault), intent(in) :: found
        type(vti_fault) :: fault
        fault = vti_fault(found%body + 1, found%value)
    end function

    ! ---- steppers -------------------------------------------------------------------------------------------------

    !> "vti1", "vti2", "vti3", "vti3-leapfrog", "vti1-body"; trailing blanks do not matter.
    function vti_stepper_find(name) result(method)
        character(len=*), intent(in) :: name
        type(vti_stepper) :: method
        method = stepper_value(c_stepper_find(trim(name)//c_null_char))
    end function

    !> 1 <= index <= vti_stepper_count(); 1 is vti1, 2 vti2, 3 vti3.
    function vti_stepper_at(index) result(method)
        integer(c_int64_t), intent(in) :: index
        type(vti_stepper) :: method
        method = stepper_value(c_stepper_at(index - 1))
    end function

    function stepper_value(p) result(method)
        type(c_ptr), intent(in) :: p
        type(vti_stepper) :: method
        type(vti_stepper), pointer :: constant
        if (.not. c_associated(p)) return
        call c_f_pointer(p, constant)
        method = constant
    end function

    !> What C is to be given for method: its address, or NULL if it is none.
    function handle(method) result(p)
        type(vti_stepper), intent(in), target :: method
        type(c_ptr) :: p
        p = c_null_ptr
        if (c_associated(method%kick) .and. c_associated(method%drift)) p = c_loc(method)
    end function

    !  The loop of a host:
    !
    !      forces and moments at t = 0                          once; the first kick needs them
    !      status = vti_step_start(method, h, bodies)           does nothing but for "vti3-leapfrog"
    !      for every step
    !          status = vti_step_begin(method, h, bodies, fault)
    !          forces and moments at the new positions
    !          status = vti_step_finish(method, h, bodies)
    !
    !  Between begin and finish nothing but force and moment may be written. Methods with more than one stage call
    !  vti_step_stage for k = 1 ... stages-1, each followed by forces, before finish. h is finite and > 0.

    !> Kick and drift of all bodies or, on failure, of none. On VTI_E_TOO_LARGE fault names the body with the largest
    !> h|Omega| (or the first that is not a number) and that value.
    function vti_step_begin(method, h, bodies, fault) result(status)
        type(vti_stepper), intent(in), target :: method
        real(c_double), intent(in) :: h
        type(vti_bodies), intent(in) :: bodies
        type(vti_fault), intent(out), optional :: fault
        integer(c_int) :: status
        status = vti_step_stage(method, 0_c_int64_t, h, bodies, fault)
    end function

    !> Stage k; vti_step_begin is stage 0.
    function vti_step_stage(method, k, h, bodies, fault) result(status)
        type(vti_stepper), intent(in), target :: method
        integer(c_int64_t), intent(in) :: k
        real(c_double), intent(in) :: h
        type(vti_bodies), intent(in) :: bodies
        type(vti_fault), intent(out), optional :: fault
        integer(c_int) :: status
        type(vti_fault) :: found
        status = c_step_stage(handle(method), k, h, bodies, found)
        if (present(fault)) fault = blame(found)
    end function

    !> The last kick.
    function vti_step_finish(method, h, bodies) result(status)
        type(vti_stepper), intent(in), target :: method
        real(c_double), intent(in) :: h
        type(vti_bodies), intent(in) :: bodies
        integer(c_int) :: status
        status = c_step_finish(handle(method), h, bodies)
    end function

    !> Moves velocities from t to t - lag h, where the method keeps them.
    function vti_step_start(method, h, bodies) result(status)
        type(vti_stepper), intent(in), target :: method
        real(c_double), intent(in) :: h
        type(vti_bodies), intent(in) :: bodies
        integer(c_int) :: status
        status = c_step_start(handle(method), h, bodies)
    end function

    !> Moves velocities back to t. To read without disturbing the run, call it on bodies whose v and omega are copies.
    function vti_step_sync(method, h, bodies) result(status)
        type(vti_stepper), intent(in), target :: method
        real(c_double), intent(in) :: h
        type(vti_bodies), intent(in) :: bodies
        integer(c_int) :: status
        status = c_step_sync(handle(method), h, bodies)
    end function

    ! ---- effects --------------------------------------------------------------------------------------------------

    !> force = moment = 0 on the slice, then every effect in order.
    function vti_apply(effects, bodies) result(status)
        type(vti_effect), intent(in) :: effects(:)
        type(vti_bodies), intent(in) :: bodies
        integer(c_int) :: status
        status = c_apply(effects, size(effects, kind=c_int64_t), bodies)
    end function

    !> Kinetic energies and all energies of the effects.
    function vti_energy(effects, bodies) result(energy)
        type(vti_effect), intent(in) :: effects(:)
        type(vti_bodies), intent(in) :: bodies
        real(c_double) :: energy
        energy = c_energy(effects, size(effects, kind=c_int64_t), bodies)
    end function

    !> The effect of a pendulum, which must be associated and outlive the effect.
    function vti_pendulum_effect(pendulum) result(effect)
        type(vti_pendulum), pointer, intent(in) :: pendulum
        type(vti_effect) :: effect
        effect = c_pendulum_effect(c_loc(pendulum))
    end function

    !> arm = R rho0 of body i, which counts from 1, in the inertial frame.
    subroutine vti_pendulum_arm(pendulum, bodies, i, arm)
        type(vti_pendulum), intent(in) :: pendulum
        type(vti_bodies), intent(in) :: bodies
        integer(c_int64_t), intent(in) :: i
        real(c_double), intent(out) :: arm(3)
        call c_pendulum_arm(pendulum, bodies, i - 1, arm)
    end subroutine

    ! ---- the packed door ------------------------------------------------------------------------------------------
    !
    ! For codes with plain x(3,n) arrays that want neither types nor TARGET. stepper as in vti_stepper_at. Arrays that
    ! are left out (call by keyword) are absent physics. masses and inertias: 1 (one value for all) or n. Same
    ! arithmetic, same bits as through views.

    !> vti_step_begin. On failure body receives the culprit, counted from 1 (or 0), and value its h|Omega|.
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

    ! ---- texts ----------------------------------------------------------------------------------------------------

    !> One English sentence for a status, remedy included.
    function vti_status_text(status) result(text)
        integer(c_int), intent(in) :: status
        character(len=:), allocatable :: text
        text = vti_text(c_status_text(status))
    end function

    !> Version of the library that is running.
    function vti_version() result(text)
        character(len=:), allocatable :: text
        text = vti_text(c_version())
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
