! SPDX-License-Identifier: BSD-3-Clause
!
!> vti_c -- the types, constants and functions of vti.h as C has them. Programs use the module vti, which passes on what
!> needs no more than this and replaces the functions named c_ by ones that take Fortran's arrays, texts and numbering.
module vti_c
    use, intrinsic :: iso_c_binding, only: c_char, c_double, c_funptr, c_int, c_int64_t, c_null_funptr, c_null_ptr, &
        c_ptr, c_size_t
    implicit none
    public
    private :: c_char, c_double, c_funptr, c_int, c_int64_t, c_null_funptr, c_null_ptr, c_ptr, c_size_t

    integer(c_int64_t), parameter :: VTI_ABI = 1

    integer(c_int), parameter :: VTI_OK = 0, VTI_E_NULL = -1, VTI_E_ABI = -2, VTI_E_COUNT = -3, VTI_E_VIEW = -4, &
        VTI_E_STRIDE = -5, VTI_E_ALIAS = -6, VTI_E_TIME = -7, VTI_E_MASS = -8, VTI_E_INERTIA = -9, &
        VTI_E_TOO_LARGE = -10, VTI_E_STAGE = -11, VTI_E_STEPPER = -12, VTI_E_FRAME = -13, VTI_E_BOND = -14
    integer(c_int), parameter :: VTI_LAW_CLOSED = 1, VTI_LAW_CAYLEY = 2
    integer(c_int), parameter :: VTI_FRAME_SPACE = 1, VTI_FRAME_BODY = -1

    !> Where and why a call failed: the body (of the procedures of module vti: counted from 1, 0 if no body is to blame)
    !> and the value.
    type, bind(c) :: vti_fault
        integer(c_int64_t) :: body = 0
        real(c_double) :: value = 0
    end type

    !> n three-vectors in the caller's arrays: the addresses of the first one's components, the stride in doubles.
    type, bind(c) :: vti_view
        type(c_ptr) :: c(3) = c_null_ptr
        integer(c_int64_t) :: stride = 0
    end type

    !> n quaternions in the caller's arrays, components in the order x, y, z, w.
    type, bind(c) :: vti_quat_view
        type(c_ptr) :: xyzw(4) = c_null_ptr
        integer(c_int64_t) :: stride = 0
    end type

    !> n positive numbers; stride 0 is one value for all.
    type, bind(c) :: vti_scalars
        type(c_ptr) :: p = c_null_ptr
        integer(c_int64_t) :: stride = 0
    end type

    !> A slice of the caller's bodies. What is not given is absent, and with it the physics that needs it; the members
    !> are explained in vti.h. first counts from 0 as in C: set it by vti_bodies_slice.
    type, bind(c) :: vti_bodies
        integer(c_int64_t) :: abi = VTI_ABI, sealed = 0, first = 0, count = 0
        type(vti_view) :: x, v, force, alpha
        type(vti_quat_view) :: quat
        type(vti_view) :: omega, moment
        type(vti_scalars) :: mass, inertia
        type(vti_view) :: x_low, v_low, alpha_low, omega_low
    end type

    !> A stepper as data. vti_text reads name and about; c_f_pointer gives kick(stages + 1) and drift(stages).
    type, bind(c) :: vti_stepper
        type(c_ptr) :: name = c_null_ptr
        integer(c_int64_t) :: law = 0, frame = 0, order = 0, reversible = 0, stages = 0
        real(c_double) :: lag = 0
        type(c_ptr) :: kick = c_null_ptr, drift = c_null_ptr, about = c_null_ptr
    end type

    !> One line of physics. apply(self, bodies) and energy(self, bodies, energies) are bind(c) subroutines with
    !> type(c_ptr), value :: self; type(vti_bodies), intent(in) :: bodies; real(c_double), intent(inout) :: energies(*).
    type, bind(c) :: vti_effect
        type(c_ptr) :: name = c_null_ptr
        type(c_funptr) :: apply = c_null_funptr, energy = c_null_funptr
        type(c_ptr) :: self = c_null_ptr
        integer(c_int64_t) :: terms = 0
        type(c_ptr) :: term = c_null_ptr
        integer(c_int64_t) :: breaks = 0
    end type

    !> Bodies that hang by their body-fixed arm rho0 from pivots in a field along +e3; weight is m g.
    type, bind(c) :: vti_pendulum
        real(c_double) :: weight = 0, rho0(3) = 0
    end type

    interface
        !> The checks that cost nothing per body; every call that moves bodies makes them.
        function vti_bodies_check(bodies) result(status) bind(c)
            import :: c_int, vti_bodies
            type(vti_bodies), intent(in) :: bodies
            integer(c_int) :: status
        end function
        !> vti_bodies_check once and for all: later calls with these bodies do not check again.
        function vti_bodies_seal(bodies) result(status) bind(c)
            import :: c_int, vti_bodies
            type(vti_bodies), intent(inout) :: bodies
            integer(c_int) :: status
        end function

        !> v += t F/m, Omega += t RM/J. t finite, of either sign.
        function vti_kick(t, bodies) result(status) bind(c)
            import :: c_double, c_int, vti_bodies
            real(c_double), value :: t
            type(vti_bodies), intent(in) :: bodies
            integer(c_int) :: status
        end function

        !> Number of steppers that vti_stepper_at knows.
        function vti_stepper_count() result(n) bind(c)
            import :: c_int64_t
            integer(c_int64_t) :: n
        end function

        !> Sum of m|v|^2/2; 0 if nothing translates.
        function vti_kinetic_translation(bodies) result(energy) bind(c)
            import :: c_double, vti_bodies
            type(vti_bodies), intent(in) :: bodies
            real(c_double) :: energy
        end function

        !> Sum of J|Omega|^2/2; 0 if nothing turns.
        function vti_kinetic_rotation(bodies) result(energy) bind(c)
            import :: c_double, vti_bodies
            type(vti_bodies), intent(in) :: bodies
            real(c_double) :: energy
        end function

        !> p = sum of m v.
        subroutine vti_momentum(bodies, p) bind(c)
            import :: c_double, vti_bodies
            type(vti_bodies), intent(in) :: bodies
            real(c_double), intent(out) :: p(3)
        end subroutine

        !> s = sum of J Omega.
        subroutine vti_spin(bodies, s) bind(c)
            import :: c_double, vti_bodies
            type(vti_bodies), intent(in) :: bodies
            real(c_double), intent(out) :: s(3)
        end subroutine

        !> l = sum of (x - about) x m v + J Omega.
        subroutine vti_angular_momentum(bodies, about, l) bind(c)
            import :: c_double, vti_bodies
            type(vti_bodies), intent(in) :: bodies
            real(c_double), intent(in) :: about(3)
            real(c_double), intent(out) :: l(3)
        end subroutine

        !> Largest h|Omega|: the rotation per step, radians.
        function vti_max_turn(h, bodies) result(turn) bind(c)
            import :: c_double, vti_bodies
            real(c_double), value :: h
            type(vti_bodies), intent(in) :: bodies
            real(c_double) :: turn
        end function

        !> Sum over bodies of |x|^2 + |v|^2 + theta^2 + |Omega|^2, of the views that are present.
        function vti_h1_density(bodies) result(density) bind(c)
            import :: c_double, vti_bodies
            type(vti_bodies), intent(in) :: bodies
            real(c_double) :: density
        end function

        !> The same of the differences, attitudes by |log(R_h R^T)|. Both slices have the same views and equal counts.
        function vti_h1_distance(bodies, reference) result(distance) bind(c)
            import :: c_double, vti_bodies
            type(vti_bodies), intent(in) :: bodies, reference
            real(c_double) :: distance
        end function

        !> Largest attitude distance |log(R_h R^T)| over the slice, radians; 0 if nothing turns.
        function vti_attitude_distance(bodies, reference) result(distance) bind(c)
            import :: c_double, vti_bodies
            type(vti_bodies), intent(in) :: bodies, reference
            real(c_double) :: distance
        end function

        ! ---- called by module vti only ------------------------------------------------------------------------------

        function c_bodies_check_values(bodies, fault) result(status) bind(c, name='vti_bodies_check_values')
            import :: c_int, vti_bodies, vti_fault
            type(vti_bodies), intent(in) :: bodies
            type(vti_fault), intent(inout) :: fault
            integer(c_int) :: status
        end function

        function c_drift(law, frame, t, bodies, fault) result(status) bind(c, name='vti_drift')
            import :: c_double, c_int, vti_bodies, vti_fault
            integer(c_int), value :: law, frame
            real(c_double), value :: t
            type(vti_bodies), intent(in) :: bodies
            type(vti_fault), intent(inout) :: fault
            integer(c_int) :: status
        end function

        function c_stepper_find(name) result(method) bind(c, name='vti_stepper_find')
            import :: c_char, c_ptr
            character(kind=c_char), intent(in) :: name(*)
            type(c_ptr) :: method
        end function

        function c_stepper_at(index) result(method) bind(c, name='vti_stepper_at')
            import :: c_int64_t, c_ptr
            integer(c_int64_t), value :: index
            type(c_ptr) :: method
        end function

        function c_step_stage(method, k, h, bodies, fault) result(status) bind(c, name='vti_step_stage')
            import :: c_double, c_int, c_int64_t, c_ptr, vti_bodies, vti_fault
            type(c_ptr), value :: method
            integer(c_int64_t), value :: k
            real(c_double), value :: h
            type(vti_bodies), intent(in) :: bodies
            type(vti_fault), intent(inout) :: fault
            integer(c_int) :: status
        end function

        function c_step_finish(method, h, bodies) result(status) bind(c, name='vti_step_finish')
            import :: c_double, c_int, c_ptr, vti_bodies
            type(c_ptr), value :: method
            real(c_double), value :: h
            type(vti_bodies), intent(in) :: bodies
            integer(c_int) :: status
        end function

        function c_step_start(method, h, bodies) result(status) bind(c, name='vti_step_start')
            import :: c_double, c_int, c_ptr, vti_bodies
            type(c_ptr), value :: method
            real(c_double), value :: h
            type(vti_bodies), intent(in) :: bodies
            integer(c_int) :: status
        end function

        function c_step_sync(method, h, bodies) result(status) bind(c, name='vti_step_sync')
            import :: c_double, c_int, c_ptr, vti_bodies
            type(c_ptr), value :: method
            real(c_double), value :: h
            type(vti_bodies), intent(in) :: bodies
            integer(c_int) :: status
        end function

        function c_apply(effects, n, bodies) result(status) bind(c, name='vti_apply')
            import :: c_int, c_int64_t, vti_bodies, vti_effect
            type(vti_effect), intent(in) :: effects(*)
            integer(c_int64_t), value :: n
            type(vti_bodies), intent(in) :: bodies
            integer(c_int) :: status
        end function

        function c_energy(effects, n, bodies) result(energy) bind(c, name='vti_energy')
            import :: c_double, c_int64_t, vti_bodies, vti_effect
            type(vti_effect), intent(in) :: effects(*)
            integer(c_int64_t), value :: n
            type(vti_bodies), intent(in) :: bodies
            real(c_double) :: energy
        end function

        function c_pendulum_effect(pendulum) result(effect) bind(c, name='vti_pendulum_effect')
            import :: c_ptr, vti_effect
            type(c_ptr), value :: pendulum
            type(vti_effect) :: effect
        end function

        subroutine c_pendulum_arm(pendulum, bodies, i, arm) bind(c, name='vti_pendulum_arm')
            import :: c_double, c_int64_t, vti_bodies, vti_pendulum
            type(vti_pendulum), intent(in) :: pendulum
            type(vti_bodies), intent(in) :: bodies
            integer(c_int64_t), value :: i
            real(c_double), intent(out) :: arm(3)
        end subroutine

        function c_packed_begin(stepper, h, n, x, v, force, alpha, omega, moment, masses, mass, inertias, inertia, &
            body, value) result(status) bind(c, name='vti_packed_begin')
            import :: c_double, c_int, c_int64_t, c_ptr
            integer(c_int64_t), value :: stepper, n, masses, inertias
            real(c_double), value :: h
            type(c_ptr), value :: x, v, force, alpha, omega, moment, mass, inertia
            integer(c_int64_t), intent(inout) :: body
            real(c_double), intent(inout) :: value
            integer(c_int) :: status
        end function

        function c_packed_finish(stepper, h, n, v, force, omega, moment, masses, mass, inertias, inertia) &
            result(status) bind(c, name='vti_packed_finish')
            import :: c_double, c_int, c_int64_t, c_ptr
            integer(c_int64_t), value :: stepper, n, masses, inertias
            real(c_double), value :: h
            type(c_ptr), value :: v, force, omega, moment, mass, inertia
            integer(c_int) :: status
        end function

        function c_status_text(status) result(text) bind(c, name='vti_status_text')
            import :: c_int, c_ptr
            integer(c_int), value :: status
            type(c_ptr) :: text
        end function

        function c_version() result(text) bind(c, name='vti_version')
            import :: c_ptr
            type(c_ptr) :: text
        end function

        function c_strlen(text) result(length) bind(c, name='strlen')
            import :: c_ptr, c_size_t
            type(c_ptr), value :: text
            integer(c_size_t) :: length
        end function
    end interface
end module
