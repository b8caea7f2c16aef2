! SPDX-License-Identifier: BSD-3-Clause
!
!> vti_f77_arrays -- what stands behind the procedures of vti_f77.f90: arrays that may have any layout with constant
!> distances, default integers, no types. The dummies have TARGET here, so that views of them are valid until the call
!> returns.
module vti_f77_arrays
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_loc
    use vti
    implicit none
    private
    public :: view_of, give_fault
    public :: arrays_stage, arrays_finish, arrays_shift, arrays_kick, arrays_drift, arrays_turn, arrays_turn_quat, &
        arrays_check, arrays_kinetic, arrays_momenta

contains

    !> The stepper of that number; if there is none the status says so.
    function method_of(m, status) result(method)
        integer, intent(in) :: m
        integer(c_int), intent(inout) :: status
        type(vti_stepper) :: method
        method = vti_stepper_at(int(m, c_int64_t))
        if (method%stages == 0 .and. status == VTI_OK) status = VTI_E_STEPPER
    end function

    !> n vectors from a on: lb doubles from a body to the next, lc from a component to the next. Those by which
    !> components meet are refused where the view is used.
    function view_of(n, lb, lc, a) result(view)
        integer, intent(in) :: n, lb, lc
        real(c_double), intent(in), target :: a(*)
        type(vti_view) :: view
        view%c = c_loc(a(1))
        if (n < 1 .or. lc < 1) return ! components on one another: VTI_E_ALIAS
        view%c(2) = c_loc(a(1 + lc))
        view%c(3) = c_loc(a(1 + 2*lc))
        view%stride = lb
    end function

    !> values numbers, 1 or n; anything else is refused.
    function scalars_of(n, values, p, status) result(scalars)
        integer, intent(in) :: n, values
        real(c_double), intent(in), target :: p(*)
        integer(c_int), intent(inout) :: status
        type(vti_scalars) :: scalars
        if (values /= 1 .and. values /= n) status = VTI_E_COUNT
        scalars = vti_scalars(c_loc(p(1)), merge(0_c_int64_t, 1_c_int64_t, values == 1), 0)
    end function

    !> All that a step needs, as bodies.
    subroutine describe(n, lb, lc, x, v, f, a, w, t, nm, rm, ni, ri, bodies, status)
        integer, intent(in) :: n, lb, lc, nm, ni
        real(c_double), intent(in), target :: x(*), v(*), f(*), a(*), w(*), t(*), rm(*), ri(*)
        type(vti_bodies), intent(out) :: bodies
        integer(c_int), intent(out) :: status
        status = VTI_OK
        bodies%count = n
        bodies%x = view_of(n, lb, lc, x)
        bodies%v = view_of(n, lb, lc, v)
        bodies%force = view_of(n, lb, lc, f)
        bodies%alpha = view_of(n, lb, lc, a)
        bodies%omega = view_of(n, lb, lc, w)
        bodies%moment = view_of(n, lb, lc, t)
        bodies%mass = scalars_of(n, nm, rm, status)
        if (n > 0 .and. modulo(ni, 3) == 0 .and. ni/3 == n) then ! three moments of each, and w is L
            bodies%moments = view_of(n, lb, lc, ri)
            bodies%spin = bodies%omega
            bodies%omega = vti_view()
        else
            bodies%inertia = scalars_of(n, ni, ri, status)
        end if
    end subroutine

    subroutine give_fault(fault, ibody, value)
        type(vti_fault), intent(in) :: fault
        integer, intent(out) :: ibody
        real(c_double), intent(out) :: value
        ibody = int(fault%body)
        value = fault%value
    end subroutine

    ! ---- steps ------------------------------------------------------------------------------------------------------

    subroutine arrays_stage(m, k, h, n, lb, lc, x, v, f, a, w, t, nm, rm, ni, ri, fault, status)
        integer, intent(in) :: m, k, n, lb, lc, nm, ni
        real(c_double), intent(in) :: h
        real(c_double), intent(inout), target :: x(*), v(*), a(*), w(*)
        real(c_double), intent(in), target :: f(*), t(*), rm(*), ri(*)
        type(vti_fault), intent(out) :: fault
        integer(c_int), intent(out) :: status
        type(vti_bodies) :: bodies
        type(vti_stepper) :: method
        call describe(n, lb, lc, x, v, f, a, w, t, nm, rm, ni, ri, bodies, status)
        method = method_of(m, status)
        if (status == VTI_OK) status = vti_step_stage(method, int(k, c_int64_t), h, bodies, fault)
    end subroutine

    subroutine arrays_finish(m, h, n, lb, lc, x, v, f, a, w, t, nm, rm, ni, ri, status)
        integer, intent(in) :: m, n, lb, lc, nm, ni
        real(c_double), intent(in) :: h
        real(c_double), intent(inout), target :: x(*), v(*), a(*), w(*)
        real(c_double), intent(in), target :: f(*), t(*), rm(*), ri(*)
        integer(c_int), intent(out) :: status
        type(vti_bodies) :: bodies
        type(vti_stepper) :: method
        call describe(n, lb, lc, x, v, f, a, w, t, nm, rm, ni, ri, bodies, status)
        method = method_of(m, status)
        if (status == VTI_OK) status = vti_step_finish(method, h, bodies)
    end subroutine

    !> Velocities to where the method keeps them (side = -1), or back to the time of the positions (side = 1).
    subroutine arrays_shift(m, side, h, n, lb, lc, v, f, w, t, nm, rm, ni, ri, status)
        integer, intent(in) :: m, side, n, lb, lc, nm, ni
        real(c_double), intent(in) :: h
        real(c_double), intent(inout), target :: v(*), w(*)
        real(c_double), intent(in), target :: f(*), t(*), rm(*), ri(*)
        integer(c_int), intent(out) :: status
        type(vti_bodies) :: bodies
        type(vti_stepper) :: method
        call describe(n, lb, lc, v, v, f, w, w, t, nm, rm, ni, ri, bodies, status)
        method = method_of(m, status)
        bodies%x = vti_view()
        bodies%alpha = vti_view()
        if (status == VTI_OK .and. side < 0) status = vti_step_start(method, h, bodies)
        if (status == VTI_OK .and. side > 0) status = vti_step_sync(method, h, bodies)
    end subroutine

    ! ---- the primitives ---------------------------------------------------------------------------------------------

    !> One formula, so that v, F, m and Omega, RM, J go by the same call.
    subroutine arrays_kick(t, n, lb, lc, v, f, nm, rm, status)
        integer, intent(in) :: n, lb, lc, nm
        real(c_double), intent(in) :: t
        real(c_double), intent(inout), target :: v(*)
        real(c_double), intent(in), target :: f(*), rm(*)
        integer(c_int), intent(out) :: status
        type(vti_bodies) :: bodies
        status = VTI_OK
        bodies%count = n
        bodies%v = view_of(n, lb, lc, v)
        bodies%force = view_of(n, lb, lc, f)
        bodies%mass = scalars_of(n, nm, rm, status)
        if (status == VTI_OK) status = vti_kick(t, bodies)
    end subroutine

    subroutine arrays_drift(t, n, lb, lc, x, v, status)
        integer, intent(in) :: n, lb, lc
        real(c_double), intent(in) :: t
        real(c_double), intent(inout), target :: x(*)
        real(c_double), intent(in), target :: v(*)
        integer(c_int), intent(out) :: status
        type(vti_bodies) :: bodies
        bodies%count = n
        bodies%x = view_of(n, lb, lc, x)
        bodies%v = view_of(n, lb, lc, v)
        status = vti_drift(VTI_LAW_CAYLEY, VTI_FRAME_SPACE, t, bodies)
    end subroutine

    subroutine arrays_turn(m, t, n, lb, lc, a, w, fault, status)
        integer, intent(in) :: m, n, lb, lc
        real(c_double), intent(in) :: t
        real(c_double), intent(inout), target :: a(*)
        real(c_double), intent(in), target :: w(*)
        type(vti_fault), intent(out) :: fault
        integer(c_int), intent(out) :: status
        type(vti_bodies) :: bodies
        type(vti_stepper) :: method
        status = VTI_OK
        bodies%count = n
        bodies%alpha = view_of(n, lb, lc, a)
        bodies%omega = view_of(n, lb, lc, w)
        method = method_of(m, status)
        if (status == VTI_OK) &
            status = vti_drift(int(method%law, c_int), int(method%frame, c_int), t, bodies, fault)
    end subroutine

    subroutine arrays_turn_quat(m, t, n, lq, lcq, q, lb, lc, w, fault, status)
        integer, intent(in) :: m, n, lq, lcq, lb, lc
        real(c_double), intent(in) :: t
        real(c_double), intent(inout), target :: q(*)
        real(c_double), intent(in), target :: w(*)
        type(vti_fault), intent(out) :: fault
        integer(c_int), intent(out) :: status
        type(vti_bodies) :: bodies
        type(vti_stepper) :: method
        integer :: k
        status = VTI_OK
        bodies%count = n
        bodies%omega = view_of(n, lb, lc, w)
        bodies%quat%xyzw = [(c_loc(q(1 + k*max(lcq, 0))), k=0, 3)]
        bodies%quat%stride = lq
        method = method_of(m, status)
        if (status == VTI_OK) &
            status = vti_drift(int(method%law, c_int), int(method%frame, c_int), t, bodies, fault)
    end subroutine

    ! ---- checks and measures ----------------------------------------------------------------------------------------

    subroutine arrays_check(n, lb, lc, x, v, f, a, w, t, nm, rm, ni, ri, fault, status)
        integer, intent(in) :: n, lb, lc, nm, ni
        real(c_double), intent(in), target :: x(*), v(*), f(*), a(*), w(*), t(*), rm(*), ri(*)
        type(vti_fault), intent(out) :: fault
        integer(c_int), intent(out) :: status
        type(vti_bodies) :: bodies
        call describe(n, lb, lc, x, v, f, a, w, t, nm, rm, ni, ri, bodies, status)
        if (status == VTI_OK) status = vti_bodies_check_values(bodies, fault)
    end subroutine

    subroutine arrays_kinetic(n, lb, lc, v, nm, rm, energy, status)
        integer, intent(in) :: n, lb, lc, nm
        real(c_double), intent(in), target :: v(*), rm(*)
        real(c_double), intent(out) :: energy
        integer(c_int), intent(out) :: status
        type(vti_bodies) :: bodies
        status = VTI_OK
        energy = 0
        bodies%count = n
        bodies%v = view_of(n, lb, lc, v)
        bodies%mass = scalars_of(n, nm, rm, status)
        if (status == VTI_OK) status = vti_bodies_check(bodies)
        if (status == VTI_OK) energy = vti_kinetic_translation(bodies)
    end subroutine

    !> Linear momentum, and angular momentum about a point.
    subroutine arrays_momenta(n, lb, lc, x, v, w, nm, rm, ni, ri, about, p, l, status)
        integer, intent(in) :: n, lb, lc, nm, ni
        real(c_double), intent(in), target :: x(*), v(*), w(*), rm(*), ri(*)
        real(c_double), intent(in) :: about(3)
        real(c_double), intent(out) :: p(3), l(3)
        integer(c_int), intent(out) :: status
        type(vti_bodies) :: bodies
        p = 0
        l = 0
        call describe(n, lb, lc, x, v, v, w, w, w, nm, rm, ni, ri, bodies, status)
        bodies%force = vti_view()
        bodies%alpha = vti_view()
        bodies%moment = vti_view()
        if (status == VTI_OK) status = vti_bodies_check(bodies)
        if (status /= VTI_OK) return
        call vti_momentum(bodies, p)
        call vti_angular_momentum(bodies, about, l)
    end subroutine
end module
