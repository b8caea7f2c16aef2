/* SPDX-License-Identifier: BSD-3-Clause
 * The C side of the Fortran conformance tests: what C says of the shared types, and the runs that Fortran must repeat
 * bit by bit. The forces are here only, so that both sides compute them by the same code. */
#include <stddef.h>

#include "vti.h"

/* ---- types and constants -------------------------------------------------------------------------------------- */

#define SIZE(type) (int64_t)sizeof(type)
#define AT(type, member) (int64_t) offsetof(type, member)

/* each type: its size, then where each of its members is */
static const int64_t layout[] = {
    SIZE(vti_fault),
    AT(vti_fault, body),
    AT(vti_fault, value),
    AT(vti_fault, quantity),
    SIZE(vti_view),
    AT(vti_view, c),
    AT(vti_view, stride),
    AT(vti_view, count),
    SIZE(vti_quat_view),
    AT(vti_quat_view, xyzw),
    AT(vti_quat_view, stride),
    AT(vti_quat_view, count),
    SIZE(vti_scalars),
    AT(vti_scalars, p),
    AT(vti_scalars, stride),
    AT(vti_scalars, count),
    SIZE(vti_bodies),
    AT(vti_bodies, abi),
    AT(vti_bodies, sealed),
    AT(vti_bodies, first),
    AT(vti_bodies, count),
#define AT_MEMBER(constant, number, member, type, role) AT(vti_bodies, member),
    VTI_QUANTITIES(AT_MEMBER) SIZE(vti_stepper),
    AT(vti_stepper, name),
    AT(vti_stepper, law),
    AT(vti_stepper, frame),
    AT(vti_stepper, order),
    AT(vti_stepper, reversible),
    AT(vti_stepper, symplectic),
    AT(vti_stepper, stages),
    AT(vti_stepper, evals),
    AT(vti_stepper, lag),
    AT(vti_stepper, reach),
    AT(vti_stepper, kick),
    AT(vti_stepper, drift),
    AT(vti_stepper, probe),
    AT(vti_stepper, about),
    AT(vti_stepper, estimate_order),
    AT(vti_stepper, estimates),
    AT(vti_stepper, estimate),
    AT(vti_stepper, rotor),
    SIZE(vti_errors),
    AT(vti_errors, memory),
    AT(vti_errors, rows),
    SIZE(vti_control),
    AT(vti_control, tolerance),
    AT(vti_control, speed),
    AT(vti_control, turning),
    AT(vti_control, most),
    AT(vti_control, least),
    AT(vti_control, power),
    AT(vti_control, h),
    AT(vti_control, error),
    AT(vti_control, held),
    AT(vti_control, accepted),
    AT(vti_control, rejected),
    SIZE(vti_kept),
    AT(vti_kept, memory),
    AT(vti_kept, width),
    SIZE(vti_density),
    AT(vti_density, epsilon),
    AT(vti_density, rho),
    AT(vti_density, h),
    SIZE(vti_effect),
    AT(vti_effect, name),
    AT(vti_effect, apply),
    AT(vti_effect, energy),
    AT(vti_effect, check),
    AT(vti_effect, springs),
    AT(vti_effect, flow),
    AT(vti_effect, flow_clumps),
    AT(vti_effect, carry),
    AT(vti_effect, rupture),
    AT(vti_effect, self),
    AT(vti_effect, needs),
    AT(vti_effect, gives),
    AT(vti_effect, smooth),
    AT(vti_effect, settles),
    AT(vti_effect, breaks),
    AT(vti_effect, dissipates),
    AT(vti_effect, terms),
    AT(vti_effect, term),
    AT(vti_effect, books),
    AT(vti_effect, book),
    AT(vti_effect, booked),
    AT(vti_effect, by_body),
    AT(vti_effect, of_body),
    SIZE(vti_drifted),
    AT(vti_drifted, t),
    AT(vti_drifted, law),
    AT(vti_drifted, frame),
    AT(vti_drifted, rotor),
    AT(vti_drifted, clumps),
    AT(vti_drifted, bodies),
    SIZE(vti_pendulum),
    AT(vti_pendulum, weight),
    AT(vti_pendulum, rho0),
    SIZE(vti_gravity),
    AT(vti_gravity, g),
    SIZE(vti_drag),
    AT(vti_drag, linear),
    AT(vti_drag, quadratic),
    AT(vti_drag, angular),
    AT(vti_drag, medium),
    AT(vti_drag, lost),
    AT(vti_drag, by_body),
    SIZE(vti_held),
    AT(vti_held, i),
    AT(vti_held, j),
    AT(vti_held, sliding),
    AT(vti_held, rolling),
    AT(vti_held, twisting),
    SIZE(vti_history),
    AT(vti_history, slots),
    AT(vti_history, used),
    AT(vti_history, missed),
    AT(vti_history, held),
    AT(vti_history, slot),
    SIZE(vti_friction),
    AT(vti_friction, contacts),
    AT(vti_friction, walls),
    AT(vti_friction, sliding),
    AT(vti_friction, rolling),
    AT(vti_friction, twisting),
    AT(vti_friction, stiffness),
    AT(vti_friction, mindlin),
    AT(vti_friction, rolling_stiffness),
    AT(vti_friction, twisting_stiffness),
    AT(vti_friction, reach),
    AT(vti_friction, history),
    AT(vti_friction, lost),
    AT(vti_friction, wall_sliding),
    AT(vti_friction, by_body),
    AT(vti_friction, by_pair),
    SIZE(vti_multistep),
    AT(vti_multistep, name),
    AT(vti_multistep, depth),
    AT(vti_multistep, c),
    AT(vti_multistep, u),
    AT(vti_multistep, reach),
    AT(vti_multistep, about),
    SIZE(vti_past),
    AT(vti_past, memory),
    AT(vti_past, depth),
    AT(vti_past, known),
    SIZE(vti_bond_dashpots),
    AT(vti_bond_dashpots, bonds),
    AT(vti_bond_dashpots, zeta),
    AT(vti_bond_dashpots, axial),
    AT(vti_bond_dashpots, shear),
    AT(vti_bond_dashpots, bending),
    AT(vti_bond_dashpots, twisting),
    AT(vti_bond_dashpots, lost),
    AT(vti_bond_dashpots, by_body),
    SIZE(vti_rupture),
    AT(vti_rupture, bonds),
    AT(vti_rupture, id),
    AT(vti_rupture, stretch),
    AT(vti_rupture, normal),
    AT(vti_rupture, shear),
    AT(vti_rupture, bending),
    AT(vti_rupture, torsion),
    AT(vti_rupture, energy),
    AT(vti_rupture, lost),
    AT(vti_rupture, by_body),
    SIZE(vti_dashpots),
    AT(vti_dashpots, contacts),
    AT(vti_dashpots, walls),
    AT(vti_dashpots, friction),
    AT(vti_dashpots, zeta),
    AT(vti_dashpots, normal),
    AT(vti_dashpots, tangential),
    AT(vti_dashpots, ratio),
    AT(vti_dashpots, rolling),
    AT(vti_dashpots, twisting),
    AT(vti_dashpots, pull),
    AT(vti_dashpots, reach),
    AT(vti_dashpots, lost),
    AT(vti_dashpots, wall_zeta),
    AT(vti_dashpots, by_body),
    SIZE(vti_bonds),
    AT(vti_bonds, count),
    AT(vti_bonds, pair),
    AT(vti_bonds, base),
    AT(vti_bonds, rest),
    AT(vti_bonds, moment),
    AT(vti_bonds, axial),
    AT(vti_bonds, shear),
    AT(vti_bonds, shear_form),
    AT(vti_bonds, turn),
    SIZE(vti_contacts),
    AT(vti_contacts, count),
    AT(vti_contacts, pair),
    AT(vti_contacts, base),
    AT(vti_contacts, diameter),
    AT(vti_contacts, stiffness),
    AT(vti_contacts, modulus),
    AT(vti_contacts, length),
    SIZE(vti_wall_motion),
    AT(vti_wall_motion, velocity),
    AT(vti_wall_motion, spin),
    AT(vti_wall_motion, centre),
    AT(vti_wall_motion, moved),
    SIZE(vti_walls),
    AT(vti_walls, count),
    AT(vti_walls, plane),
    AT(vti_walls, diameter),
    AT(vti_walls, stiffness),
    AT(vti_walls, each),
    AT(vti_walls, cylinders),
    AT(vti_walls, cylinder),
    AT(vti_walls, motion),
    AT(vti_walls, work),
    AT(vti_walls, modulus),
    AT(vti_walls, moduli),
    AT(vti_walls, by_body),
    SIZE(vti_spring),
    AT(vti_spring, element),
    AT(vti_spring, i),
    AT(vti_spring, j),
    AT(vti_spring, length),
    AT(vti_spring, axial),
    AT(vti_spring, across),
    AT(vti_spring, shear),
    AT(vti_spring, arm_i),
    AT(vti_spring, arm_j),
    AT(vti_spring, bend),
    AT(vti_spring, twist),
    AT(vti_spring, lever_i),
    AT(vti_spring, lever_j),
    SIZE(vti_clumps),
    AT(vti_clumps, count),
    AT(vti_clumps, body),
    AT(vti_clumps, base),
    AT(vti_clumps, offset),
    AT(vti_clumps, spheres),
    SIZE(vti_solid),
    AT(vti_solid, mass),
    AT(vti_solid, centre),
    AT(vti_solid, moments),
    AT(vti_solid, principal),
    SIZE(vti_clumped),
    AT(vti_clumped, clumps),
    AT(vti_clumped, effect),
    SIZE(vti_deformation),
    AT(vti_deformation, overlap),
    AT(vti_deformation, strain),
    AT(vti_deformation, meet),
    SIZE(vti_stable),
    AT(vti_stable, h),
    AT(vti_stable, effect),
    AT(vti_stable, element),
    AT(vti_stable, i),
    AT(vti_stable, j),
    SIZE(vti_sum),
    AT(vti_sum, high),
    AT(vti_sum, low),
    SIZE(vti_integral),
    AT(vti_integral, sum),
    AT(vti_integral, last),
    AT(vti_integral, values),
};

int64_t shim_layout(int64_t room, int64_t *values);

/** Writes at most room numbers and returns how many there are. */
int64_t shim_layout(int64_t room, int64_t *values)
{
    const int64_t n = (int64_t)(sizeof layout / sizeof layout[0]);
    for (int64_t i = 0; i < n && i < room; ++i)
        values[i] = layout[i];
    return n;
}

/* ---- runs ------------------------------------------------------------------------------------------------------- */

static const vti_pendulum arm = {0.75, {0.3, -0.4, 0.8}};
static const double field[3] = {0.5, -0.25, 0.75};

void shim_forces(const vti_bodies *b);
int shim_run(int64_t stepper, double h, int64_t steps, int64_t n, double *x, double *v, double *alpha, double *quat,
             double *omega, const double *mass, const double *inertia);
void shim_measures(const vti_bodies *b, const vti_bodies *other, double values[21]);

/** force = -x; moment = (R rho0) x field, a moment of the attitude with no component that stays 0. */
void shim_forces(const vti_bodies *b)
{
    for (int64_t i = b->first; i < b->first + b->count; ++i) {
        double a[3], moment[3];
        vti_pendulum_arm(&arm, b, i, a);
        vti_cross(a, field, moment);
        for (int k = 0; k < 3; ++k) {
            b->force.c[k][i * b->force.stride] = -b->x.c[k][i * b->x.stride];
            b->moment.c[k][i * b->moment.stride] = moment[k];
        }
    }
}

enum { MOST = 16 };

/** The loop of a host on x[n][3] arrays; the attitude is quat[n][4] if alpha is NULL. */
int shim_run(int64_t stepper, double h, int64_t steps, int64_t n, double *x, double *v, double *alpha, double *quat,
             double *omega, const double *mass, const double *inertia)
{
    const vti_stepper *method = vti_stepper_at(stepper);
    double force[MOST][3], moment[MOST][3];
    if (n > MOST || method == NULL)
        return VTI_E_COUNT;

    vti_bodies b = vti_bodies_none(n);
    b.x = vti_view_packed(x);
    b.v = vti_view_packed(v);
    b.force = vti_view_packed(force[0]);
    b.omega = vti_view_packed(omega);
    b.moment = vti_view_packed(moment[0]);
    b.mass = vti_scalars_array(mass);
    b.inertia = vti_scalars_array(inertia);
    if (alpha != NULL) {
        b.alpha = vti_view_packed(alpha);
    } else {
        const vti_quat_view view = {{quat, quat + 1, quat + 2, quat + 3}, 4, 0};
        b.quat = view;
    }

    shim_forces(&b);
    int status = vti_step_start(method, h, &b);
    for (int64_t i = 0; status == VTI_OK && i < steps; ++i) {
        for (int64_t k = 0; status == VTI_OK && k < method->stages; ++k) {
            status = vti_step_stage(method, k, h, &b, NULL);
            shim_forces(&b);
        }
        if (status == VTI_OK)
            status = vti_step_finish(method, h, &b);
    }
    return status == VTI_OK ? vti_step_sync(method, h, &b) : status;
}

/** Every measure, as C gets it from the bodies that Fortran describes. */
void shim_measures(const vti_bodies *b, const vti_bodies *other, double values[21])
{
    const double about[3] = {0.25, -0.5, 1.0};
    const vti_effect effect = vti_pendulum_effect(&arm);
    values[0] = vti_kinetic_translation(b);
    values[1] = vti_kinetic_rotation(b);
    values[2] = vti_energy(&effect, 1, b);
    values[3] = vti_max_turn(0.5, b);
    values[4] = vti_h1_density(b);
    values[5] = vti_h1_distance(b, other);
    values[6] = vti_attitude_distance(b, other);
    vti_momentum(b, values + 7);
    vti_spin(b, values + 10);
    vti_angular_momentum(b, about, values + 13);
    vti_pendulum_arm(&arm, b, 4, values + 16); /* body 5 of Fortran */
    values[19] = (double)effect.terms;
    values[20] = (double)effect.breaks;
}
