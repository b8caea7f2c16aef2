/* SPDX-License-Identifier: BSD-3-Clause
 * The pendulum: bodies that hang by an arm from pivots that do not move (EQUATIONS 3). */
#include "kind.h"
#include "model.h"
#include "scene_reader.h"
#include "tables.h"
#include "wide.h"

/* ---- what a scene says ------------------------------------------------------------------------------------------- */

static const struct scene_field fields[] = {
    {"pendulum", SCENE_SECTION, SCENE_MAY, SCENE_ANY, SCENE_NOWHERE, "pivot and weight",
     "Each body hangs by its arm from a pivot that does not move, in a field along +z; bodies turn and cannot "
     "translate.",
     NULL},
    {"pendulum.weight", SCENE_NUMBER, SCENE_MUST, SCENE_NOT_NEGATIVE, offsetof(vti_pendulum, weight), "weight m g",
     "Force: the mass times the acceleration of the field.", NULL},
    {"pendulum.rho0", SCENE_VECTOR, SCENE_MUST, SCENE_NOT_ZERO, offsetof(vti_pendulum, rho0), "arm in the body's frame",
     "Length and direction at alpha = 0, from the pivot to where the weight acts.", NULL},
};

static int check(const struct scene_reader *reader, const struct scene *scene, const void *settings)
{
    (void)settings;
    if (!scene->translates)
        return 0;
    return scene_reader_fail(reader, "pendulum",
                             "hangs bodies on fixed pivots, where they turn and cannot translate; remove it or %s",
                             scene_positions_key(scene));
}

static int check_tables(const struct model *model, const void *settings, const struct tables *tables,
                        struct message *message)
{
    (void)settings;
    if (!model->translates)
        return 0;
    return table_fail_whole(
        &tables->bodies, message,
        "has columns x, y, z; a pendulum hangs bodies on fixed pivots, where they cannot translate");
}

/* ---- what it does ------------------------------------------------------------------------------------------------ */

static vti_effect draft(const void *settings, const struct table *table)
{
    (void)table;
    return vti_pendulum_effect(settings);
}

static void centre(const struct effect *e, const vti_bodies *bodies, int64_t i, double x[3])
{
    vti_pendulum_arm(e->settings, bodies, i, x);
}

/* ---- of many states at once -------------------------------------------------------------------------------------- */

VTI_INLINE void potentials_loops(const vti_pendulum *p, double *const q[4], int64_t n, double *restrict energy)
{
    for (int64_t k = 0; k < n; ++k) {
        const double pair[4] = {q[0][k], q[1][k], q[2][k], q[3][k]};
        double arm[3];
        vti_pair_rotate(pair, 1.0, p->rho0, arm);
        energy[k] = vti_pendulum_potential(p, arm);
    }
}

VTI_INLINE double spin_about(const double arm[3], const double omega[3])
{
    return arm[0] * omega[0] + arm[1] * omega[1] + arm[2] * omega[2];
}

VTI_INLINE void spins_loops(const vti_pendulum *p, double *const q[4], double *const omega[3], int64_t n,
                            double *restrict value)
{
    for (int64_t k = 0; k < n; ++k) {
        const double pair[4] = {q[0][k], q[1][k], q[2][k], q[3][k]}, w[3] = {omega[0][k], omega[1][k], omega[2][k]};
        double arm[3];
        vti_pair_rotate(pair, 1.0, p->rho0, arm);
        value[k] = spin_about(arm, w);
    }
}

static void potentials(const vti_pendulum *p, double *const q[4], int64_t n, double *energy);
static void spins(const vti_pendulum *p, double *const q[4], double *const omega[3], int64_t n, double *value);
WIDE(potentials, (const vti_pendulum *p, double *const q[4], int64_t n, double *energy), (p, q, n, energy))
WIDE(spins, (const vti_pendulum *p, double *const q[4], double *const omega[3], int64_t n, double *value),
     (p, q, omega, n, value))

static void each(const struct effect *e, const vti_bodies *bodies, double *energy)
{
    potentials(e->settings, bodies->quat.xyzw, bodies->count, energy);
}

/* ---- what it keeps: the sphere's spin about its arm, and the arm's length ---------------------------------------- */

static const struct invariant kept[] = {{"arm_dot_omega", "$R\\rho_0\\cdot\\Omega$", 1},
                                        {"arm_length", "$|R\\rho_0|$", 0}};

/** Of body 0. */
static void kept_values(const struct effect *e, const vti_bodies *b, double *values)
{
    const double omega[3] = {b->omega.c[0][0], b->omega.c[1][0], b->omega.c[2][0]};
    double arm[3];
    vti_pendulum_arm(e->settings, b, 0, arm);
    values[0] = spin_about(arm, omega);
    values[1] = vti_norm(arm);
}

static void kept_of_states(const struct effect *e, const vti_bodies *states, double *value, int64_t stride)
{
    (void)stride;
    spins(e->settings, states->quat.xyzw, states->omega.c, states->count, value);
}

static const struct effect_invariants invariants = {kept, sizeof kept / sizeof kept[0], kept_values, 1, kept_of_states};

static const struct effect_term terms[] = {{"pendulum", "$U$", "pendulum", "#B07AA1"}};

const struct effect_kind effect_pendulum = {.number = EFFECT_pendulum,
                                            .key = "pendulum",
                                            EFFECT_FIELDS(fields),
                                            .settings = sizeof(vti_pendulum),
                                            .check = check,
                                            .draft = draft,
                                            .check_tables = check_tables,
                                            EFFECT_TERMS(terms),
                                            .centre = centre,
                                            .invariants = &invariants,
                                            .each = each};
