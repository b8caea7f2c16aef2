! SPDX-License-Identifier: BSD-3-Clause
!
!> vti_types -- the types and constants of vti.h. Part of module vti.
module vti_types
    use, intrinsic :: iso_c_binding, only: c_double, c_funptr, c_int, c_int64_t, c_null_funptr, c_null_ptr, c_ptr
    implicit none
    public
    private :: c_double, c_funptr, c_int, c_int64_t, c_null_funptr, c_null_ptr, c_ptr

    integer(c_int64_t), parameter :: VTI_ABI = 1

    integer(c_int), parameter :: VTI_OK = 0, VTI_E_NULL = -1, VTI_E_ABI = -2, VTI_E_COUNT = -3, VTI_E_VIEW = -4, &
        VTI_E_STRIDE = -5, VTI_E_ALIAS = -6, VTI_E_TIME = -7, VTI_E_MASS = -8, VTI_E_INERTIA = -9, &
        VTI_E_TOO_LARGE = -10, VTI_E_STAGE = -11, VTI_E_STEPPER = -12, VTI_E_FRAME = -13, VTI_E_BOND = -14, &
        VTI_E_DISSIPATES = -15, VTI_E_CONTACT = -16, VTI_E_STATE = -17, VTI_E_SPRINGS = -18, VTI_E_NEEDS = -19, &
        VTI_E_DAMPING = -20, VTI_E_HISTORY = -21, VTI_E_PAST = -22, VTI_E_CONTROL = -23, &
        VTI_E_MOMENTS = -24, VTI_E_CLUMP = -25
    integer(c_int), parameter :: VTI_LAW_CLOSED = 1, VTI_LAW_CAYLEY = 2, VTI_LAW_EXACT = 3, VTI_LAW_EXACT9 = 4
    integer(c_int), parameter :: VTI_FRAME_SPACE = 1, VTI_FRAME_BODY = -1
    integer(c_int64_t), parameter :: VTI_BREAKS_LINEAR = 7, VTI_BREAKS_ANGULAR = 56, VTI_BREAKS_SPINS = 448
    integer(c_int64_t), parameter :: VTI_SHEAR_OBJECTIVE = 1, VTI_SHEAR_QUARTIC = 2, VTI_SHEAR_PRINTED = 3
    integer(c_int64_t), parameter :: VTI_TERMS = 8, VTI_BOND_LOADS = 9
    integer(c_int64_t), parameter :: VTI_DRAG_BOOKS = 2, VTI_DASHPOT_BOOKS = 4, VTI_FRICTION_BOOKS = 3, &
        VTI_BOND_DASHPOT_BOOKS = 4, VTI_RUPTURE_BOOKS = 1
    !> What vti_bonds_measure says of a bond: its row, counted from 0 as in C, and how many there are.
    integer(c_int64_t), parameter :: VTI_BOND_NORMAL = 0, VTI_BOND_ACROSS = 1, VTI_BOND_BENDING = 2, &
        VTI_BOND_TORSION = 3, VTI_BOND_ENERGY = 4, VTI_BOND_STRETCH = 5, VTI_BOND_MEASURES = 6

    !> What bodies consist of, in the order of the members of vti_bodies.
    integer(c_int64_t), parameter :: VTI_QUANTITY_NONE = 0, VTI_QUANTITY_X = 1, VTI_QUANTITY_V = 2, &
        VTI_QUANTITY_FORCE = 3, VTI_QUANTITY_ALPHA = 4, VTI_QUANTITY_QUAT = 5, VTI_QUANTITY_OMEGA = 6, &
        VTI_QUANTITY_MOMENT = 7, VTI_QUANTITY_MASS = 8, VTI_QUANTITY_INERTIA = 9, VTI_QUANTITY_X_LOW = 10, &
        VTI_QUANTITY_V_LOW = 11, VTI_QUANTITY_ALPHA_LOW = 12, VTI_QUANTITY_OMEGA_LOW = 13, &
        VTI_QUANTITY_MOMENTS = 14, VTI_QUANTITY_SPIN = 15, VTI_QUANTITY_PRINCIPAL = 16, VTI_QUANTITY_SPIN_LOW = 17

    !> Where and why a call failed: the body (of the procedures of module vti: counted from 1, 0 if it is not about
    !> one), the value, and the quantity that it is a value of (vti_quantity_text names it).
    type, bind(c) :: vti_fault
        integer(c_int64_t) :: body = 0
        real(c_double) :: value = 0
        integer(c_int64_t) :: quantity = VTI_QUANTITY_NONE
    end type

    !> n three-vectors in the caller's arrays: the addresses of the first one's components, the stride in doubles, and
    !> how many there are (0: not known), so that a view of fewer than the bodies is refused.
    type, bind(c) :: vti_view
        type(c_ptr) :: c(3) = c_null_ptr
        integer(c_int64_t) :: stride = 0, count = 0
    end type

    !> n quaternions in the caller's arrays, components in the order x, y, z, w.
    type, bind(c) :: vti_quat_view
        type(c_ptr) :: xyzw(4) = c_null_ptr
        integer(c_int64_t) :: stride = 0, count = 0
    end type

    !> n positive numbers; stride 0 is one value for all.
    type, bind(c) :: vti_scalars
        type(c_ptr) :: p = c_null_ptr
        integer(c_int64_t) :: stride = 0, count = 0
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
        type(vti_view) :: moments, spin
        type(vti_quat_view) :: principal
        type(vti_view) :: spin_low
    end type

    !> A stepper as data. vti_text reads name and about; c_f_pointer gives kick, drift and, unless it is null, probe, of
    !> stages + 1 numbers each, and estimate, unless it is null, of the shape [stages + 1, estimates].
    type, bind(c) :: vti_stepper
        type(c_ptr) :: name = c_null_ptr
        integer(c_int64_t) :: law = 0, frame = 0, order = 0, reversible = 0, symplectic = 0, stages = 0, evals = 0
        real(c_double) :: lag = 0, reach = 0
        type(c_ptr) :: kick = c_null_ptr, drift = c_null_ptr, probe = c_null_ptr, about = c_null_ptr
        integer(c_int64_t) :: estimate_order = 0, estimates = 0
        type(c_ptr) :: estimate = c_null_ptr
        integer(c_int64_t) :: rotor = 0
    end type

    !> Sums of a step for vti_step_error: memory is the address of an array (6, rows, bodies) of the caller's.
    type, bind(c) :: vti_errors
        type(c_ptr) :: memory = c_null_ptr
        integer(c_int64_t) :: rows = 0
    end type

    !> What step control goes by, and its state; vti_control_start sets all of it, and what stands up to least may then
    !> be changed.
    type, bind(c) :: vti_control
        real(c_double) :: tolerance = 0, speed = 1, turning = 1, most = 0, least = 0, power = 0, h = 0, error = 0
        integer(c_int64_t) :: held = 0, accepted = 0, rejected = 0
    end type

    !> Bodies as they stood: memory is the address of an array (width, bodies) of the caller's.
    type, bind(c) :: vti_kept
        type(c_ptr) :: memory = c_null_ptr
        integer(c_int64_t) :: width = 0
    end type

    !> The density of steps of the integrating controller; h is the step to be made next.
    type, bind(c) :: vti_density
        real(c_double) :: epsilon = 0, rho = 0, h = 0
    end type

    !> AN(K, c), a multistep method as data; vti_text reads name and about.
    type, bind(c) :: vti_multistep
        type(c_ptr) :: name = c_null_ptr
        integer(c_int64_t) :: depth = 0
        real(c_double) :: c = 0, u = 0, reach = 0
        type(c_ptr) :: about = c_null_ptr
    end type

    !> What bodies have felt: memory is the address of an array (6, depth, bodies) of the caller's.
    type, bind(c) :: vti_past
        type(c_ptr) :: memory = c_null_ptr
        integer(c_int64_t) :: depth = 0, known = 0
    end type

    !> A drift that has been done, as effects are told of it.
    type, bind(c) :: vti_drifted
        real(c_double) :: t = 0
        integer(c_int64_t) :: law = VTI_LAW_CAYLEY, frame = VTI_FRAME_SPACE, rotor = 0
        type(c_ptr) :: clumps = c_null_ptr, bodies = c_null_ptr
    end type

    !> One line of physics. apply(self, bodies) and energy(self, bodies, energies) are bind(c) subroutines with
    !> type(c_ptr), value :: self; type(vti_bodies), intent(in) :: bodies; real(c_double), intent(inout) :: energies(*).
    !> flow(self, bodies, t, drift) is one with real(c_double), value :: t, drift, flow_clumps(self, clumps, bodies, t,
    !> drift) the same with type(vti_clumps), intent(in) :: clumps; carry(self, bodies, drifted) is one with
    !> type(vti_drifted), intent(in) :: drifted; rupture(self, bodies) is a bind(c) function of an integer(c_int64_t).
    !> needs and gives have a bit for each quantity: ibset(0_c_int64_t, VTI_QUANTITY_X). booked is the address of an
    !> array of as many type(vti_sum) as books says; by_body is null, or that of an array (of_body, bodies) of them:
    !> what of booked each body has lost, in the first books of a column. springs(self, bodies, at, visit, context) is a
    !> bind(c) function of an integer(c_int), VTI_OK if all is well, that calls vti_show_spring(visit, context, spring)
    !> for each of its springs; type(c_ptr), value :: at, context (at is null or the address of a vti_deformation);
    !> type(c_funptr), value :: visit. Without springs an effect has no bound on the step; c_funloc(vti_springs_none)
    !> says that its force does not change with position. needs to of_body are what the parameters were when the effect
    !> was made: make it again when a term appears or goes, or walls begin to move.
    type, bind(c) :: vti_effect
        type(c_ptr) :: name = c_null_ptr
        type(c_funptr) :: apply = c_null_funptr, energy = c_null_funptr, check = c_null_funptr, &
            springs = c_null_funptr, flow = c_null_funptr, flow_clumps = c_null_funptr, carry = c_null_funptr, &
            rupture = c_null_funptr
        type(c_ptr) :: self = c_null_ptr
        integer(c_int64_t) :: needs = 0, gives = 0, smooth = 0, settles = 0, breaks = 0, dissipates = 0, terms = 0
        type(c_ptr) :: term = c_null_ptr
        integer(c_int64_t) :: books = 0
        type(c_ptr) :: book = c_null_ptr, booked = c_null_ptr, by_body = c_null_ptr
        integer(c_int64_t) :: of_body = 0
    end type

    !> Bodies that hang by their body-fixed arm rho0 from pivots in a field along +e3; weight is m g.
    type, bind(c) :: vti_pendulum
        real(c_double) :: weight = 0, rho0(3) = 0
    end type

    !> Uniform field: F = m g.
    type, bind(c) :: vti_gravity
        real(c_double) :: g(3) = 0
    end type

    !> Drag: F = -linear u - quadratic |u| u with u = v - medium, RM = -angular Omega; coefficients that are absent do
    !> nothing. lost is the address of an array of two type(vti_sum), zeros at the start: what drag has taken out of
    !> translation and out of rotation. Here and in the types below by_body is null, or the address of an array of
    !> type(vti_sum), zeros at the start, of a column for each body, each as long as lost: what that body has lost, half
    !> of what it loses together with another one.
    type, bind(c) :: vti_drag
        type(vti_scalars) :: linear, quadratic, angular
        real(c_double) :: medium(3) = 0
        type(c_ptr) :: lost = c_null_ptr, by_body = c_null_ptr
    end type

    !> Bonds between bodies; vti_bonds_between makes them from arrays. A stiffness that is absent is a term that is
    !> absent. turn is the address of turn(4,count), unit quaternions (x, y, z, w) of the rotations Q0 of bonds whose
    !> bodies are not at R = I when they are at rest (vti_bonds_rest_now); where it is null, all are.
    type, bind(c) :: vti_bonds
        integer(c_int64_t) :: count = 0
        type(c_ptr) :: pair = c_null_ptr
        integer(c_int64_t) :: base = 1
        type(c_ptr) :: rest = c_null_ptr
        type(vti_scalars) :: moment, axial, shear
        integer(c_int64_t) :: shear_form = VTI_SHEAR_OBJECTIVE
        type(c_ptr) :: turn = c_null_ptr
    end type

    !> What bonds bear: bonds is the address of a vti_bonds, id that of as many numbers, 1, 2, 3 ..., and lost that of
    !> one type(vti_sum), zero at the start. pair, rest, turn, the bonds' arrays of stiffnesses and id are written when
    !> bonds leave: what has left stands behind the bonds%count that hold. Limits that are absent are none.
    type, bind(c) :: vti_rupture
        type(c_ptr) :: bonds = c_null_ptr, id = c_null_ptr
        type(vti_scalars) :: stretch, normal, shear, bending, torsion, energy
        type(c_ptr) :: lost = c_null_ptr, by_body = c_null_ptr
    end type

    !> Dashpots of bonds: bonds is the address of a vti_bonds, lost that of an array of four type(vti_sum), zeros at the
    !> start.
    type, bind(c) :: vti_bond_dashpots
        type(c_ptr) :: bonds = c_null_ptr
        real(c_double) :: zeta = 0, axial = 0, shear = 0, bending = 0, twisting = 0
        type(c_ptr) :: lost = c_null_ptr, by_body = c_null_ptr
    end type

    !> What the springs of one touch hold: i and j count from 1 (j of plane w, which counts from 1 too: -w).
    type, bind(c) :: vti_held
        integer(c_int64_t) :: i = 0, j = 0
        real(c_double) :: sliding(3) = 0, rolling(3) = 0, twisting = 0
    end type

    !> What touches hold; slots is a power of 2, held the address of an array of as many type(vti_held), of which the
    !> first used hold something, slot that of an array of as many integer(c_int64_t), zeros at the start. A restart
    !> puts what was held into an empty one by vti_history_add, which writes the slots.
    type, bind(c) :: vti_history
        integer(c_int64_t) :: slots = 0, used = 0, missed = 0
        type(c_ptr) :: held = c_null_ptr, slot = c_null_ptr
    end type

    !> Friction of contacts and planes: contacts and walls as in vti_dashpots; history is the address of a vti_history,
    !> lost that of an array of three type(vti_sum), zeros at the start. by_pair is null, or the address of an array of
    !> real(c_double), (3, pairs of the list): what each pair has lost in the last drift, which by_body then has not.
    type, bind(c) :: vti_friction
        type(c_ptr) :: contacts = c_null_ptr, walls = c_null_ptr
        real(c_double) :: sliding = 0, rolling = 0, twisting = 0, stiffness = 0, mindlin = 0, rolling_stiffness = 0, &
            twisting_stiffness = 0, reach = 0
        type(c_ptr) :: history = c_null_ptr, lost = c_null_ptr, wall_sliding = c_null_ptr, by_body = c_null_ptr, &
            by_pair = c_null_ptr
    end type

    !> Dashpots of contacts and planes. contacts, walls and friction are the addresses of such types, or null; lost is
    !> that of an array of four type(vti_sum), zeros at the start: what the normal, tangential, rolling and twisting
    !> motions have lost. reach, which has to be given, is what gap the lists go up to; huge(1d0) where they have all
    !> pairs.
    type, bind(c) :: vti_dashpots
        type(c_ptr) :: contacts = c_null_ptr, walls = c_null_ptr, friction = c_null_ptr
        real(c_double) :: zeta = 0, normal = 0, tangential = 0, ratio = 0, rolling = 0, twisting = 0
        integer(c_int64_t) :: pull = 0
        real(c_double) :: reach = 0
        type(c_ptr) :: lost = c_null_ptr, wall_zeta = c_null_ptr, by_body = c_null_ptr
    end type

    !> Hertzian contact between the pairs of a list; vti_contacts_between makes it from arrays. All pairs share one
    !> stiffness, or it follows from the bodies' modulus E/(1 - nu^2); length is the distance at which each pair begins
    !> to touch, where that is not the mean of the diameters.
    type, bind(c) :: vti_contacts
        integer(c_int64_t) :: count = 0
        type(c_ptr) :: pair = c_null_ptr
        integer(c_int64_t) :: base = 1
        type(vti_scalars) :: diameter
        real(c_double) :: stiffness = 0
        type(vti_scalars) :: modulus, length
    end type

    !> How a wall moves; moved is how far it has come, zeros at the start.
    type, bind(c) :: vti_wall_motion
        real(c_double) :: velocity(3) = 0, spin = 0, centre(3) = 0, moved(3) = 0
    end type

    !> Rigid walls: planes n.x = offset, which vti_walls_at makes from an array, and cylinders from inside. each,
    !> cylinder and motion are the addresses of arrays, (walls), (7,cylinders) and type(vti_wall_motion) (walls), or
    !> null; work that of a type(vti_sum), zeros at the start. With modulus, E/(1 - nu^2) of the bodies, K follows from
    !> the materials; moduli is the address of those of the walls, or null: they are rigid.
    type, bind(c) :: vti_walls
        integer(c_int64_t) :: count = 0
        type(c_ptr) :: plane = c_null_ptr
        type(vti_scalars) :: diameter
        real(c_double) :: stiffness = 0
        type(c_ptr) :: each = c_null_ptr
        integer(c_int64_t) :: cylinders = 0
        type(c_ptr) :: cylinder = c_null_ptr, motion = c_null_ptr, work = c_null_ptr
        type(vti_scalars) :: modulus
        type(c_ptr) :: moduli = c_null_ptr, by_body = c_null_ptr
    end type

    !> The spheres of clumps; vti_clumps_of makes it from arrays. spheres are the spheres as bodies of their own, views
    !> of arrays that are not those of the bodies.
    type, bind(c) :: vti_clumps
        integer(c_int64_t) :: count = 0
        type(c_ptr) :: body = c_null_ptr
        integer(c_int64_t) :: base = 1
        type(c_ptr) :: offset = c_null_ptr
        type(vti_bodies) :: spheres
    end type

    !> The solid that spheres make: moments ascend, principal is x, y, z, w.
    type, bind(c) :: vti_solid
        real(c_double) :: mass = 0, centre(3) = 0, moments(3) = 0, principal(4) = 0
    end type

    !> An effect on the spheres of clumps: the addresses of a vti_clumps and of a vti_effect.
    type, bind(c) :: vti_clumped
        type(c_ptr) :: clumps = c_null_ptr, effect = c_null_ptr
    end type

    !> A spring for vti_show_spring, between the bodies i and j or, for j = 0, between i and what does not move; element
    !> is its number in the effect. All count from 1. The members are explained in vti.h: stiffnesses are energies.
    type, bind(c) :: vti_spring
        integer(c_int64_t) :: element = 0, i = 0, j = 0
        real(c_double) :: length = 1, axial = 0, across = 0, shear = 0, arm_i = 0.5_c_double, arm_j = 0.5_c_double, &
            bend = 0, twist = 0, lever_i = 0, lever_j = 0
    end type

    !> How far bodies may get from rest: overlap of contacts as a share of D, strain of bonds as one of L0; meet = 1 if
    !> any two bodies may touch, 0 if those of the lists may.
    type, bind(c) :: vti_deformation
        real(c_double) :: overlap = 0, strain = 0
        integer(c_int64_t) :: meet = 0
    end type

    !> A bound on the step and what sets it: numbers of the effect in the array, of its spring and of the bodies of
    !> that, from 1; 0 is none.
    type, bind(c) :: vti_stable
        real(c_double) :: h = 0
        integer(c_int64_t) :: effect = 0, element = 0, i = 0, j = 0
    end type

    !> Sum with its rounding error carried along.
    type, bind(c) :: vti_sum
        real(c_double) :: high = 0, low = 0
    end type

    !> Integral over time by the trapezoid rule at the steps, fed one value per step.
    type, bind(c) :: vti_integral
        type(vti_sum) :: sum
        real(c_double) :: last = 0
        integer(c_int64_t) :: values = 0
    end type
end module
