! SPDX-License-Identifier: BSD-3-Clause
!
!> vti_steps -- kick and drift, steppers, and the step around the host's forces. Part of module vti.
module vti_steps
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_int, c_int64_t, c_loc, c_null_char, &
        c_null_ptr, c_ptr
    use vti_c
    implicit none
    private
    public :: vti_bodies_check_values, vti_drift, vti_stepper_find, vti_stepper_at
    public :: vti_step_begin, vti_step_stage, vti_step_finish, vti_step_next, vti_step_probe, vti_step_start, &
        vti_step_sync, vti_step_watch, vti_step_error
    public :: from_one, handle ! for the other modules here

    interface
        !> Adds the forces and moments of kick k, 0 <= k <= stages, to the sums of a step; k = 0 begins anew. To be
        !> called before vti_step_begin (k = 0), before vti_step_stage(k), and before vti_step_finish (k = stages).
        function vti_step_watch(method, k, h, bodies, errors) result(status) bind(c)
            import :: c_double, c_int, c_int64_t, vti_bodies, vti_errors, vti_stepper
            type(vti_stepper), intent(in) :: method
            integer(c_int64_t), value :: k
            real(c_double), value :: h
            type(vti_bodies), intent(in) :: bodies
            type(vti_errors), intent(in) :: errors
            integer(c_int) :: status
        end function

        !> After that: the largest estimate of a body, of its velocity and of its spin.
        function vti_step_error(method, bodies, errors, velocity, omega) result(status) bind(c)
            import :: c_double, c_int, vti_bodies, vti_errors, vti_stepper
            type(vti_stepper), intent(in) :: method
            type(vti_bodies), intent(in) :: bodies
            type(vti_errors), intent(in) :: errors
            real(c_double), intent(out) :: velocity, omega
            integer(c_int) :: status
        end function
    end interface

contains

    ! ---- checks and the two primitives ----------------------------------------------------------------------------

    !> vti_bodies_check, and of the slice every mass and inertia finite and > 0, every position, velocity, attitude and
    !> spin finite, no quaternion zero or of no normal length (1.5e-154 to 1.3e154). fault says what is wrong with which
    !> body.
    function vti_bodies_check_values(bodies, fault) result(status)
        type(vti_bodies), intent(in) :: bodies
        type(vti_fault), intent(out), optional :: fault
        integer(c_int) :: status
        type(vti_fault) :: found
        status = c_bodies_check_values(bodies, found)
        if (present(fault)) fault = from_one(found)
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
        if (present(fault)) fault = from_one(found)
    end function

    !> A fault of C in the numbering of this module.
    pure function from_one(found) result(fault)
        type(vti_fault), intent(in) :: found
        type(vti_fault) :: fault
        fault = found
        fault%body = found%body + 1
    end function

    ! ---- steppers -------------------------------------------------------------------------------------------------

    !> By its name in vti_step.h ("vti1", "vti2", "exact", ...); trailing blanks do not matter.
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
    !  vti_step_stage for k = 1 ... stages-1, each followed by forces, before finish; where probe is not null, each kick
    !  k with probe(k) /= 0 comes after vti_step_probe and the forces at what it has filled in. h is finite and > 0.

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
        if (present(fault)) fault = from_one(found)
    end function

    !> The last kick, and the last drift where there is one.
    function vti_step_finish(method, h, bodies) result(status)
        type(vti_stepper), intent(in), target :: method
        real(c_double), intent(in) :: h
        type(vti_bodies), intent(in) :: bodies
        integer(c_int) :: status
        status = c_step_finish(handle(method), h, bodies)
    end function

    !> vti_step_finish and the vti_step_begin of the next step in one pass, for steps after which nobody looks at
    !> velocities: the same bits. VTI_E_STAGE, and nothing is written, for methods whose step ends with a drift.
    function vti_step_next(method, h, bodies, fault) result(status)
        type(vti_stepper), intent(in), target :: method
        real(c_double), intent(in) :: h
        type(vti_bodies), intent(in) :: bodies
        type(vti_fault), intent(out), optional :: fault
        integer(c_int) :: status
        type(vti_fault) :: found
        status = c_step_next(handle(method), h, bodies, found)
        if (present(fault)) fault = from_one(found)
    end function

    !> Where the forces of kick k are to be taken, by the methods that have a probe: writes x + probe(k) h^2 F/m and the
    !> attitude turned by probe(k) h^2 RM/J into probed, whose x and attitude are arrays of their own and whose force
    !> and moment may be those of bodies.
    function vti_step_probe(method, k, h, bodies, probed) result(status)
        type(vti_stepper), intent(in), target :: method
        integer(c_int64_t), intent(in) :: k
        real(c_double), intent(in) :: h
        type(vti_bodies), intent(in) :: bodies, probed
        integer(c_int) :: status
        status = c_step_probe(handle(method), k, h, bodies, probed)
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
end module
