! SPDX-License-Identifier: BSD-3-Clause
!
!> vti_c -- the functions of vti.h as C has them. Programs use the module vti, which passes on what needs no more than
!> this and replaces the functions named c_ by ones that take Fortran's arrays, texts and numbering.
module vti_c
    use, intrinsic :: iso_c_binding, only: c_char, c_double, c_int, c_int64_t, c_ptr, c_size_t
    use vti_types
    implicit none
    public
    private :: c_char, c_double, c_int, c_int64_t, c_ptr, c_size_t

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

        !> dalpha of the turn by omega for the time t: what a drift composes with an attitude.
        subroutine vti_drift_increment(law, t, omega, dalpha) bind(c)
            import :: c_double, c_int
            integer(c_int), value :: law
            real(c_double), value :: t
            real(c_double), intent(in) :: omega(3)
            real(c_double), intent(out) :: dalpha(3)
        end subroutine

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

        function c_step_next(method, h, bodies, fault) result(status) bind(c, name='vti_step_next')
            import :: c_double, c_int, c_ptr, vti_bodies, vti_fault
            type(c_ptr), value :: method
            real(c_double), value :: h
            type(vti_bodies), intent(in) :: bodies
            type(vti_fault), intent(inout) :: fault
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

        function c_step_probe(method, k, h, bodies, probed) result(status) bind(c, name='vti_step_probe')
            import :: c_double, c_int, c_int64_t, c_ptr, vti_bodies
            type(c_ptr), value :: method
            integer(c_int64_t), value :: k
            real(c_double), value :: h
            type(vti_bodies), intent(in) :: bodies, probed
            integer(c_int) :: status
        end function

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

        function c_quantity_text(quantity) result(text) bind(c, name='vti_quantity_text')
            import :: c_int64_t, c_ptr
            integer(c_int64_t), value :: quantity
            type(c_ptr) :: text
        end function

        function c_version() result(text) bind(c, name='vti_version')
            import :: c_ptr
            type(c_ptr) :: text
        end function

        function c_vector_units() result(text) bind(c, name='vti_vector_units')
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
