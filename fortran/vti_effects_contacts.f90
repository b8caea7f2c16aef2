! SPDX-License-Identifier: BSD-3-Clause
!
!> vti_effects_contacts -- contacts, walls, their dashpots and friction, and clumps. Part of module vti.
!>
!> As in vti_effects what an effect points to has TARGET, stays where it is, and outlives it; bodies in pairs count from
!> 1. Arrays of the wrong shape give a count of -1, whose effect is refused as one of nothing is.
module vti_effects_contacts
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_int, c_int64_t, c_loc, c_null_ptr, c_ptr
    use vti_c_effects
    use vti_steps, only: from_one
    use vti_types
    implicit none
    private
    public :: vti_contacts_between, vti_contacts_check, vti_contacts_effect, vti_contacts_stiffness
    public :: vti_walls_at, vti_walls_check, vti_walls_effect, vti_walls_gap, vti_walls_stiffness
    public :: vti_dashpots_effect, vti_dashpots_zeta, vti_friction_effect, vti_history_add
    public :: vti_clumps_of, vti_clumps_check, vti_clumps_spheres, vti_clumps_spread, vti_clumps_gather
    public :: vti_clumped_effect, vti_clump_solid

contains

    ! ---- contacts and walls ------------------------------------------------------------------------------------------

    !> Contacts between the bodies pair(1,k) and pair(2,k), of which some may not touch: of one stiffness, an energy,
    !> for all, or of the bodies' modulus E/(1 - nu^2). length is the distance at which each pair begins to touch,
    !> (D_i + D_j)/2 where it is absent.
    function vti_contacts_between(pair, diameter, stiffness, modulus, length) result(contacts)
        integer(c_int64_t), pointer, contiguous, intent(in) :: pair(:, :)
        type(vti_scalars), intent(in) :: diameter
        real(c_double), intent(in), optional :: stiffness
        type(vti_scalars), intent(in), optional :: modulus, length
        type(vti_contacts) :: contacts
        contacts%diameter = diameter
        if (present(stiffness)) contacts%stiffness = stiffness
        if (present(modulus)) contacts%modulus = modulus
        if (present(length)) contacts%length = length
        contacts%count = -1
        if (.not. associated(pair)) return
        if (size(pair, 1) /= 2) return
        contacts%count = size(pair, 2, c_int64_t)
        if (contacts%count > 0) contacts%pair = c_loc(pair)
    end function

    !> When the list has changed: every pair names two different bodies of the n that exist, diameters, moduli and
    !> lengths are finite and > 0 and as many as are needed, and the stiffness is finite and >= 0, or 0 with a modulus.
    !> VTI_E_CONTACT, with fault%body the number of the pair (from 1; 0 for the stiffness).
    function vti_contacts_check(contacts, n, fault) result(status)
        type(vti_contacts), intent(in) :: contacts
        integer(c_int64_t), intent(in) :: n
        type(vti_fault), intent(out), optional :: fault
        integer(c_int) :: status
        type(vti_fault) :: found
        status = c_contacts_check(contacts, n, found)
        if (present(fault)) fault = from_one(found)
    end function

    !> K of pair k; NaN if there is none.
    function vti_contacts_stiffness(contacts, k) result(stiffness)
        type(vti_contacts), intent(in) :: contacts
        integer(c_int64_t), intent(in) :: k
        real(c_double) :: stiffness
        stiffness = c_contacts_stiffness(contacts, k - 1)
    end function

    !> The effect; the list of contacts may change between steps.
    function vti_contacts_effect(contacts) result(effect)
        type(vti_contacts), pointer, intent(in) :: contacts
        type(vti_effect) :: effect
        if (.not. associated(contacts)) return
        if (contacts%count >= 0 .and. c_associated(contacts%diameter%p)) effect = c_contacts_effect(c_loc(contacts))
    end function

    !> Whether they may be walls of n bodies: of unit normals and axes, finite numbers, stiffnesses >= 0 of one source,
    !> diameters and moduli > 0. VTI_E_CONTACT, with fault%body the number of the wall, from 1; 0 for a body, from 0 in
    !> fault%value, or for a stiffness beside a modulus.
    function vti_walls_check(walls, n, fault) result(status)
        type(vti_walls), intent(in) :: walls
        integer(c_int64_t), intent(in) :: n
        type(vti_fault), intent(out), optional :: fault
        integer(c_int) :: status
        type(vti_fault) :: found
        status = c_walls_check(walls, n, found)
        if (present(fault)) fault = from_one(found)
    end function

    !> Planes with the unit normal plane(1:3,k), towards the bodies, and the offset plane(4,k).
    function vti_walls_at(plane, diameter, stiffness) result(walls)
        real(c_double), pointer, contiguous, intent(in) :: plane(:, :)
        type(vti_scalars), intent(in) :: diameter
        real(c_double), intent(in) :: stiffness
        type(vti_walls) :: walls
        walls%diameter = diameter
        walls%stiffness = stiffness
        walls%count = -1
        if (.not. associated(plane)) return
        if (size(plane, 1) /= 4) return
        walls%count = size(plane, 2, c_int64_t)
        if (walls%count > 0) walls%plane = c_loc(plane)
    end function

    function vti_walls_effect(walls) result(effect)
        type(vti_walls), pointer, intent(in) :: walls
        type(vti_effect) :: effect
        if (.not. associated(walls)) return
        if (walls%count >= 0 .and. c_associated(walls%diameter%p)) effect = c_walls_effect(c_loc(walls))
    end function

    !> K of body i at wall w, both from 1; NaN if there is no such wall.
    function vti_walls_stiffness(walls, w, i) result(stiffness)
        type(vti_walls), pointer, intent(in) :: walls
        integer(c_int64_t), intent(in) :: w, i
        real(c_double) :: stiffness
        type(c_ptr) :: p
        p = c_null_ptr
        if (associated(walls)) p = c_loc(walls)
        stiffness = c_walls_stiffness(p, w - 1_c_int64_t, i - 1_c_int64_t)
    end function

    !> The distance of the place x from wall w, from 1, where it is now, and in n the unit normal there; NaN, and n = 0,
    !> if there is no such wall.
    function vti_walls_gap(walls, w, x, n) result(gap)
        type(vti_walls), pointer, intent(in) :: walls
        integer(c_int64_t), intent(in) :: w
        real(c_double), intent(in) :: x(3)
        real(c_double), intent(out) :: n(3)
        real(c_double) :: gap
        type(c_ptr) :: p
        n = 0
        p = c_null_ptr
        if (associated(walls)) p = c_loc(walls)
        gap = c_walls_gap(p, w - 1_c_int64_t, x, n)
    end function

    ! ---- what damps and rubs ----------------------------------------------------------------------------------------

    function vti_dashpots_effect(dashpots) result(effect)
        type(vti_dashpots), pointer, intent(in) :: dashpots
        type(vti_effect) :: effect
        if (associated(dashpots)) effect = c_dashpots_effect(c_loc(dashpots))
    end function

    function vti_friction_effect(friction) result(effect)
        type(vti_friction), pointer, intent(in) :: friction
        type(vti_effect) :: effect
        if (associated(friction)) effect = c_friction_effect(c_loc(friction))
    end function

    ! ---- clumps ------------------------------------------------------------------------------------------------------

    !> Spheres at offset(3,s) in the bodies body(s), which ascend from 1; spheres shows them as bodies of their own.
    function vti_clumps_of(body, offset, spheres) result(clumps)
        integer(c_int64_t), pointer, contiguous, intent(in) :: body(:)
        real(c_double), pointer, contiguous, intent(in) :: offset(:, :)
        type(vti_bodies), intent(in) :: spheres
        type(vti_clumps) :: clumps
        clumps%spheres = spheres
        clumps%count = -1
        if (.not. (associated(body) .and. associated(offset))) return
        if (size(offset, 1) /= 3 .or. size(offset, 2) /= size(body)) return
        clumps%count = size(body, kind=c_int64_t)
        if (clumps%count == 0) return
        clumps%body = c_loc(body)
        clumps%offset = c_loc(offset)
    end function

    !> When the list has changed: every sphere belongs to one of the n bodies, the list ascends, offsets are finite.
    !> VTI_E_CLUMP, with fault%body the number of the sphere (from 1) and fault%value what is wrong.
    function vti_clumps_check(clumps, n, fault) result(status)
        type(vti_clumps), intent(in) :: clumps
        integer(c_int64_t), intent(in) :: n
        type(vti_fault), intent(out), optional :: fault
        integer(c_int) :: status
        type(vti_fault) :: found
        status = c_clumps_check(clumps, n, found)
        if (present(fault)) fault = from_one(found)
    end function

    !> Mass, centre and moments of spheres centre(3,s), diameter(s) of one density, counted once where they overlap:
    !> those that overlap none exactly, others along lines x lines lines through their own boxes. Errors as in C,
    !> VTI_E_COUNT also for another shape; fault%body is the sphere, from 1.
    function vti_clump_solid(centre, diameter, density, lines, solid, fault) result(status)
        real(c_double), contiguous, intent(in) :: centre(:, :), diameter(:)
        real(c_double), intent(in) :: density
        integer(c_int64_t), intent(in) :: lines
        type(vti_solid), intent(inout) :: solid
        type(vti_fault), intent(out), optional :: fault
        integer(c_int) :: status
        type(vti_fault) :: found
        if (present(fault)) fault = vti_fault()
        status = VTI_E_COUNT
        if (size(centre, 1) /= 3 .or. size(centre, 2) /= size(diameter)) return
        status = c_clump_solid(size(diameter, kind=c_int64_t), centre, diameter, density, lines, solid, found)
        if (present(fault)) fault = from_one(found)
    end function

    !> The effect on the bodies that an effect on the spheres of their clumps is.
    function vti_clumped_effect(clumped) result(effect)
        type(vti_clumped), pointer, intent(in) :: clumped
        type(vti_effect) :: effect
        if (associated(clumped)) effect = c_clumped_effect(c_loc(clumped))
    end function
end module
