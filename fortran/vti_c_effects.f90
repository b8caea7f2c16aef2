! SPDX-License-Identifier: BSD-3-Clause
!
!> vti_c_effects -- the functions of vti_effect.h and of the effects' headers as C has them, but those of bonds, which
!> are in vti_c_bonds; called by module vti_effects and its two other files only.
module vti_c_effects
    use, intrinsic :: iso_c_binding, only: c_double, c_funptr, c_int, c_int64_t, c_ptr
    use vti_types
    implicit none
    public
    private :: c_double, c_funptr, c_int, c_int64_t, c_ptr

    interface
        function c_apply(effects, n, bodies) result(status) bind(c, name='vti_apply')
            import :: c_int, c_int64_t, vti_bodies, vti_effect
            type(vti_effect), intent(in) :: effects(*)
            integer(c_int64_t), value :: n
            type(vti_bodies), intent(in) :: bodies
            integer(c_int) :: status
        end function

        function c_effects_check(effects, n, bodies, fault) result(status) bind(c, name='vti_effects_check')
            import :: c_int, c_int64_t, vti_bodies, vti_effect, vti_fault
            type(vti_effect), intent(in) :: effects(*)
            integer(c_int64_t), value :: n
            type(vti_bodies), intent(in) :: bodies
            type(vti_fault), intent(out) :: fault
            integer(c_int) :: status
        end function

        function c_effects_flow(effects, n, t, drift, bodies) result(status) bind(c, name='vti_effects_flow')
            import :: c_double, c_int, c_int64_t, vti_bodies, vti_effect
            type(vti_effect), intent(in) :: effects(*)
            integer(c_int64_t), value :: n
            real(c_double), value :: t, drift
            type(vti_bodies), intent(in) :: bodies
            integer(c_int) :: status
        end function

        function c_effects_carry(effects, n, drifted, bodies) result(status) bind(c, name='vti_effects_carry')
            import :: c_int, c_int64_t, vti_bodies, vti_drifted, vti_effect
            type(vti_effect), intent(in) :: effects(*)
            integer(c_int64_t), value :: n
            type(vti_drifted), intent(in) :: drifted
            type(vti_bodies), intent(in) :: bodies
            integer(c_int) :: status
        end function

        function c_effects_rupture(effects, n, bodies, broken) result(status) bind(c, name='vti_effects_rupture')
            import :: c_int, c_int64_t, vti_bodies, vti_effect
            type(vti_effect), intent(in) :: effects(*)
            integer(c_int64_t), value :: n
            type(vti_bodies), intent(in) :: bodies
            integer(c_int64_t), intent(inout) :: broken
            integer(c_int) :: status
        end function

        function c_effects_stage(method, k, h, effects, n, bodies, fault) result(status) &
            bind(c, name='vti_effects_stage')
            import :: c_double, c_int, c_int64_t, c_ptr, vti_bodies, vti_effect, vti_fault
            type(c_ptr), value :: method
            integer(c_int64_t), value :: k, n
            real(c_double), value :: h
            type(vti_effect), intent(in) :: effects(*)
            type(vti_bodies), intent(in) :: bodies
            type(vti_fault), intent(out) :: fault
            integer(c_int) :: status
        end function

        function c_effects_finish(method, h, effects, n, bodies) result(status) bind(c, name='vti_effects_finish')
            import :: c_double, c_int, c_int64_t, c_ptr, vti_bodies, vti_effect
            type(c_ptr), value :: method
            real(c_double), value :: h
            type(vti_effect), intent(in) :: effects(*)
            integer(c_int64_t), value :: n
            type(vti_bodies), intent(in) :: bodies
            integer(c_int) :: status
        end function

        function c_booked(effects, n) result(energy) bind(c, name='vti_booked')
            import :: c_double, c_int64_t, vti_effect
            type(vti_effect), intent(in) :: effects(*)
            integer(c_int64_t), value :: n
            real(c_double) :: energy
        end function

        function c_booked_of_body(effects, n, i) result(energy) bind(c, name='vti_booked_of_body')
            import :: c_double, c_int64_t, vti_effect
            type(vti_effect), intent(in) :: effects(*)
            integer(c_int64_t), value :: n, i
            real(c_double) :: energy
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

        function c_clumps_check(clumps, n, fault) result(status) bind(c, name='vti_clumps_check')
            import :: c_int, c_int64_t, vti_clumps, vti_fault
            type(vti_clumps), intent(in) :: clumps
            integer(c_int64_t), value :: n
            type(vti_fault), intent(out) :: fault
            integer(c_int) :: status
        end function

        !> The spheres of the bodies of the slice, as a slice of clumps%spheres.
        function vti_clumps_spheres(clumps, bodies) result(spheres) bind(c)
            import :: vti_bodies, vti_clumps
            type(vti_clumps), intent(in) :: clumps
            type(vti_bodies), intent(in) :: bodies
            type(vti_bodies) :: spheres
        end function

        !> Puts the spheres of the slice's bodies where they are: x + R rho, v + Omega x R rho, attitude and Omega.
        function vti_clumps_spread(clumps, bodies) result(status) bind(c)
            import :: c_int, vti_bodies, vti_clumps
            type(vti_clumps), intent(in) :: clumps
            type(vti_bodies), intent(in) :: bodies
            integer(c_int) :: status
        end function

        !> Adds the loads of the spheres to those of the slice's bodies, with the moments of their forces.
        function vti_clumps_gather(clumps, bodies) result(status) bind(c)
            import :: c_int, vti_bodies, vti_clumps
            type(vti_clumps), intent(in) :: clumps
            type(vti_bodies), intent(in) :: bodies
            integer(c_int) :: status
        end function

        function c_clump_solid(n, centre, diameter, density, lines, solid, fault) result(status) &
            bind(c, name='vti_clump_solid')
            import :: c_double, c_int, c_int64_t, vti_fault, vti_solid
            integer(c_int64_t), value :: n, lines
            real(c_double), intent(in) :: centre(3, *), diameter(*)
            real(c_double), value :: density
            type(vti_solid), intent(inout) :: solid
            type(vti_fault), intent(out) :: fault
            integer(c_int) :: status
        end function

        function c_clumped_effect(clumped) result(effect) bind(c, name='vti_clumped_effect')
            import :: c_ptr, vti_effect
            type(c_ptr), value :: clumped
            type(vti_effect) :: effect
        end function

        function c_gravity_effect(gravity) result(effect) bind(c, name='vti_gravity_effect')
            import :: c_ptr, vti_effect
            type(c_ptr), value :: gravity
            type(vti_effect) :: effect
        end function

        function c_drag_effect(drag) result(effect) bind(c, name='vti_drag_effect')
            import :: c_ptr, vti_effect
            type(c_ptr), value :: drag
            type(vti_effect) :: effect
        end function

        function c_dashpots_effect(dashpots) result(effect) bind(c, name='vti_dashpots_effect')
            import :: c_ptr, vti_effect
            type(c_ptr), value :: dashpots
            type(vti_effect) :: effect
        end function

        !> By which bodies part with the share e of the velocity with which they meet; NaN unless 0 < e <= 1.
        function vti_dashpots_zeta(e, pull) result(zeta) bind(c)
            import :: c_double, c_int64_t
            real(c_double), value :: e
            integer(c_int64_t), value :: pull
            real(c_double) :: zeta
        end function

        function c_friction_effect(friction) result(effect) bind(c, name='vti_friction_effect')
            import :: c_ptr, vti_effect
            type(c_ptr), value :: friction
            type(vti_effect) :: effect
        end function

        !> Puts what a touch holds into the table; VTI_E_HISTORY if there is no room. A restart begins with an empty
        !> table: it writes the slots.
        function vti_history_add(history, held) result(status) bind(c)
            import :: c_int, vti_held, vti_history
            type(vti_history), intent(inout) :: history
            type(vti_held), intent(in) :: held
            integer(c_int) :: status
        end function

        function c_contacts_effect(contacts) result(effect) bind(c, name='vti_contacts_effect')
            import :: c_ptr, vti_effect
            type(c_ptr), value :: contacts
            type(vti_effect) :: effect
        end function

        function c_walls_gap(walls, w, x, n) result(gap) bind(c, name='vti_walls_gap')
            import :: c_double, c_int64_t, c_ptr
            type(c_ptr), value :: walls
            integer(c_int64_t), value :: w
            real(c_double), intent(in) :: x(3)
            real(c_double), intent(inout) :: n(3)
            real(c_double) :: gap
        end function

        function c_walls_stiffness(walls, w, i) result(stiffness) bind(c, name='vti_walls_stiffness')
            import :: c_double, c_int64_t, c_ptr
            type(c_ptr), value :: walls
            integer(c_int64_t), value :: w, i
            real(c_double) :: stiffness
        end function

        function c_walls_check(walls, n, fault) result(status) bind(c, name='vti_walls_check')
            import :: c_int, c_int64_t, vti_walls, vti_fault
            type(vti_walls), intent(in) :: walls
            integer(c_int64_t), value :: n
            type(vti_fault), intent(out) :: fault
            integer(c_int) :: status
        end function

        function c_walls_effect(walls) result(effect) bind(c, name='vti_walls_effect')
            import :: c_ptr, vti_effect
            type(c_ptr), value :: walls
            type(vti_effect) :: effect
        end function

        function c_contacts_check(contacts, n, fault) result(status) bind(c, name='vti_contacts_check')
            import :: c_int, c_int64_t, vti_contacts, vti_fault
            type(vti_contacts), intent(in) :: contacts
            integer(c_int64_t), value :: n
            type(vti_fault), intent(out) :: fault
            integer(c_int) :: status
        end function

        function c_contacts_stiffness(contacts, k) result(stiffness) bind(c, name='vti_contacts_stiffness')
            import :: c_double, c_int64_t, vti_contacts
            type(vti_contacts), intent(in) :: contacts
            integer(c_int64_t), value :: k
            real(c_double) :: stiffness
        end function

        function c_pairs_of_slice(count, pair, base, first, bodies, which) result(n) bind(c, name='vti_pairs_of_slice')
            import :: c_int64_t
            integer(c_int64_t), value :: count, base, first, bodies
            integer(c_int64_t), intent(in) :: pair(2, *)
            integer(c_int64_t), intent(inout) :: which(*)
            integer(c_int64_t) :: n
        end function

        function c_step_check(method, effects, n) result(status) bind(c, name='vti_step_check')
            import :: c_int, c_int64_t, c_ptr, vti_effect
            type(c_ptr), value :: method
            type(vti_effect), intent(in) :: effects(*)
            integer(c_int64_t), value :: n
            integer(c_int) :: status
        end function

        function vti_springs_none(self, bodies, at, visit, context) result(status) bind(c, name='vti_springs_none')
            import :: c_funptr, c_int, c_ptr, vti_bodies
            type(c_ptr), value :: self, at, context
            type(vti_bodies), intent(in) :: bodies
            type(c_funptr), value :: visit
            integer(c_int) :: status
        end function

        function c_stable_step(effects, n, bodies, at, scratch, stable) result(status) bind(c, name='vti_stable_step')
            import :: c_double, c_int, c_int64_t, c_ptr, vti_bodies, vti_effect, vti_stable
            type(vti_effect), intent(in) :: effects(*)
            integer(c_int64_t), value :: n
            type(vti_bodies), intent(in) :: bodies
            type(c_ptr), value :: at
            real(c_double), intent(inout) :: scratch(*)
            type(vti_stable), intent(inout) :: stable
            integer(c_int) :: status
        end function
    end interface
end module
