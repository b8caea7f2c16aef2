/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The digest of what few scenes have: dissipation with its books and springs, bodies of three moments, steps of
 * multistep methods. */
#ifndef VTI_TESTS_DIGEST_MORE_H
#define VTI_TESTS_DIGEST_MORE_H

#include "digest.h"

static inline void say(const char *what, const char *which, uint64_t hash)
{
    printf("%s %s %016" PRIx64 "\n", what, which, hash);
}

static inline void must(int status, const char *what)
{
    if (status == VTI_OK)
        return;
    fprintf(stderr, "digest: %s: %s\n", what, vti_status_text(status));
    exit(1);
}

static inline void add_state(uint64_t *hash, const scene *s)
{
    hash_add(hash, s->x[0], 3 * BODIES);
    hash_add(hash, s->v[0], 3 * BODIES);
    hash_add(hash, s->alpha[0], 3 * BODIES);
    hash_add(hash, s->quat[0], 4 * BODIES);
    hash_add(hash, s->omega[0], 3 * BODIES);
    hash_add(hash, s->low[0][0], 4 * 3 * BODIES);
}

/* ---- dissipation ------------------------------------------------------------------------------------------------- */

enum { ALL = EFFECTS + 4, SLOTS = 1024, BOOKS = VTI_DRAG_BOOKS + VTI_DASHPOT_BOOKS + VTI_FRICTION_BOOKS };

/** A scene of every effect with drag, dashpots of touches and bonds, and friction. */
typedef struct damped {
    scene s;
    double moments[BODIES][3], linear, quadratic, angular;
    vti_held held[SLOTS];
    int64_t slot[SLOTS];
    vti_sum lost[BOOKS + VTI_BOND_DASHPOT_BOOKS];
    vti_history history;
    vti_drag drag;
    vti_dashpots dashpots;
    vti_friction friction;
    vti_bond_dashpots bond_dashpots;
    vti_effect effects[ALL];
} damped;

static inline void damped_make(damped *d)
{
    const double reach = 0.3;
    memset(d, 0, sizeof *d);
    scene_make(&d->s, 4);
    scene_effects(&d->s, d->effects + 4);
    d->linear = 0.01;
    d->quadratic = 0.02;
    d->angular = 0.03;
    d->history = (vti_history){SLOTS, 0, 0, d->held, d->slot};
    d->drag = (vti_drag){.linear = vti_scalars_one(&d->linear),
                         .quadratic = vti_scalars_one(&d->quadratic),
                         .angular = vti_scalars_one(&d->angular),
                         .medium = {0.1, -0.2, 0.3},
                         .lost = d->lost};
    d->friction = (vti_friction){.contacts = &d->s.contacts,
                                 .walls = &d->s.walls,
                                 .sliding = 0.4,
                                 .rolling = 0.05,
                                 .twisting = 0.06,
                                 .mindlin = 0.8,
                                 .rolling_stiffness = 2.0,
                                 .twisting_stiffness = 1.0,
                                 .reach = reach,
                                 .history = &d->history,
                                 .lost = d->lost + VTI_DRAG_BOOKS};
    d->dashpots = (vti_dashpots){.contacts = &d->s.contacts,
                                 .walls = &d->s.walls,
                                 .friction = &d->friction,
                                 .zeta = 0.1,
                                 .normal = 0.2,
                                 .ratio = 0.5,
                                 .rolling = 0.01,
                                 .twisting = 0.02,
                                 .reach = reach,
                                 .lost = d->lost + VTI_DRAG_BOOKS + VTI_FRICTION_BOOKS};
    d->bond_dashpots = (vti_bond_dashpots){.bonds = &d->s.bonds, .zeta = 0.05, .shear = 0.1, .lost = d->lost + BOOKS};
    d->effects[0] = vti_drag_effect(&d->drag);
    d->effects[1] = vti_dashpots_effect(&d->dashpots);
    d->effects[2] = vti_friction_effect(&d->friction);
    d->effects[3] = vti_bond_dashpots_effect(&d->bond_dashpots);
    for (int i = 0; i < BODIES; ++i)
        for (int k = 0; k < 3; ++k)
            d->moments[i][k] = d->s.inertia[i] * (1.0 + 0.1 * k);
}

/** As scene_bodies, of three moments too. */
static inline vti_bodies damped_bodies(damped *d, enum storage storage, int general)
{
    vti_bodies b = scene_bodies(&d->s, storage);
    if (general) {
        b.inertia = vti_scalars_one(NULL);
        b.omega_low = vti_view_none();
        b.moments = vti_view_packed(d->moments[0]);
    }
    return b;
}

static inline void add_books(uint64_t *hash, const damped *d)
{
    for (int k = 0; k < BOOKS + VTI_BOND_DASHPOT_BOOKS; ++k) {
        const double lost = vti_sum_value(&d->lost[k]);
        hash_add(hash, &lost, 1);
    }
    for (int64_t k = 0; k < d->history.used; ++k) {
        hash_add(hash, d->held[k].sliding, 3);
        hash_add(hash, d->held[k].rolling, 3);
        hash_add(hash, &d->held[k].twisting, 1);
    }
}

static inline void dissipation(const char *name, int general, double h, int steps)
{
    static damped d;
    const vti_stepper *const method = vti_stepper_find(name);
    uint64_t hash = HASH_START;
    for (int storage = 0; storage < STORAGES; ++storage) {
        damped_make(&d);
        const vti_bodies b = damped_bodies(&d, (enum storage)storage, general);
        must(vti_apply(d.effects, ALL, &b), "vti_apply");
        for (int k = 0; k < steps; ++k) {
            must(vti_effects_begin(method, h, d.effects, ALL, &b, NULL), "vti_effects_begin");
            must(vti_apply(d.effects, ALL, &b), "vti_apply");
            must(vti_effects_finish(method, h, d.effects, ALL, &b), "vti_effects_finish");
        }
        add_state(&hash, &d.s);
        add_books(&hash, &d);
    }
    say(general ? "dissipation,moments" : "dissipation", name, hash);
}

/* ---- three moments ----------------------------------------------------------------------------------------------- */

/** Stage k of a step, or its end: of many bodies at once, of the last few one by one. */
static inline void tops_move(const vti_stepper *method, int64_t k, double h, const vti_bodies *b)
{
    enum { AT_ONCE = 64 };
    for (int64_t i = 0; i < BODIES; i += i < AT_ONCE ? AT_ONCE : 1) {
        const vti_bodies slice = vti_bodies_slice(*b, i, i < AT_ONCE ? AT_ONCE : 1);
        must(k < method->stages ? vti_step_stage(method, k, h, &slice, NULL) : vti_step_finish(method, h, &slice),
             method->name);
    }
}

/** Steps of bodies of three moments, of those steppers that have a rotor in space. */
static inline void tops(const vti_stepper *method, double h, int steps)
{
    static damped d;
    uint64_t hash = HASH_START;
    for (int storage = 0; storage < STORAGES; ++storage) {
        damped_make(&d);
        const vti_bodies b = damped_bodies(&d, (enum storage)storage, 1);
        must(vti_apply(d.effects + 4, EFFECTS, &b), "vti_apply");
        for (int k = 0; k < steps; ++k) {
            for (int64_t stage = 0; stage < method->stages; ++stage) {
                tops_move(method, stage, h, &b);
                must(vti_apply(d.effects + 4, EFFECTS, &b), "vti_apply");
            }
            tops_move(method, method->stages, h, &b);
        }
        add_state(&hash, &d.s);
    }
    say("moments", method->name, hash);
}

/* ---- multistep methods ------------------------------------------------------------------------------------------- */

enum { DEPTH = 10 };

static inline void multistep(const vti_multistep *method, double h, int steps)
{
    static scene s;
    static double memory[6 * DEPTH * BODIES];
    const vti_stepper *const first = vti_stepper_find("srkn6");
    uint64_t hash = HASH_START;
    for (int by_quat = 0; by_quat < 2; ++by_quat) {
        vti_effect effects[EFFECTS];
        vti_past past = {memory, method->depth, 0};
        scene_make(&s, 1);
        scene_effects(&s, effects);
        memset(memory, 0, sizeof memory);
        const vti_bodies b = scene_bodies(&s, by_quat ? BY_QUATERNION : BY_ALPHA);
        must(vti_apply(effects, EFFECTS, &b), "vti_apply");
        must(vti_multistep_record(&past, &b), "vti_multistep_record");
        while (past.known < method->depth) {
            for (int64_t stage = 0; stage < first->stages; ++stage) {
                must(vti_step_stage(first, stage, h, &b, NULL), first->name);
                must(vti_apply(effects, EFFECTS, &b), "vti_apply");
            }
            must(vti_step_finish(first, h, &b), "vti_step_finish");
            must(vti_multistep_record(&past, &b), "vti_multistep_record");
        }
        for (int k = 0; k < steps; ++k) {
            double error[2];
            must(vti_multistep_predict(method, h, &past, &b, NULL), method->name);
            must(vti_apply(effects, EFFECTS, &b), "vti_apply");
            must(vti_multistep_error(method, h, &past, &b, &error[0], &error[1]), "vti_multistep_error");
            must(vti_multistep_correct(method, h, &past, &b), method->name);
            hash_add(&hash, error, 2);
        }
        add_state(&hash, &s);
    }
    say("multistep", method->name, hash);
}

#endif
