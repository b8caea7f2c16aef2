/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The same maps written in other ways: VTI-2 as velocity Verlet with q <- normalise(q + (h/2) Omega q), VTI-3 as VTI-2
 * between half kicks, VTI-1 in the body's frame. The other ways are written out here, in long double, so that what is
 * seen is the rounding of the library alone. */
#include "rig.h"

enum { STEPS = 1000 };

/** How far roundings carry two runs apart. In each of N = 1000 steps Omega and the attitude err by some eps at random,
 *  and an error in Omega has the rest of the time t to grow: sqrt(N) eps (1 + t) = 1.2e-13, thrice that for the worst
 *  of 27 random pendulums. The paper's pendulum, from trial 0 to 2, has to keep 1e-13. */
static double rounding(int trial)
{
    return trial < 3 ? 1e-13 : 3 * sqrt(STEPS) * EPS * (1 + STEPS / 64.0);
}

typedef struct state {
    rotor q;
    long double w[3];
} state;

static state state_of(const rig *p)
{
    const state s = {rig_attitude(p), {p->omega[0], p->omega[1], p->omega[2]}};
    return s;
}

/** Omega += t RM/J, RM = m g (R rho0) x e3 */
static void kick(state *s, const rig *p, long double t)
{
    const double *rho = p->pendulum.rho0;
    const rotor v = {rho[0], rho[1], rho[2], 0}, arm = quat_times(quat_times(s->q, v), quat_conj(s->q));
    const long double k = t * p->pendulum.weight / p->inertia;
    s->w[0] += k * arm.y;
    s->w[1] -= k * arm.x;
}

/** q <- normalise(q + (t/2) Omega q) */
static void drift(state *s, long double t)
{
    const rotor omega = {s->w[0], s->w[1], s->w[2], 0}, dq = quat_times(omega, s->q);
    s->q.x += t / 2 * dq.x;
    s->q.y += t / 2 * dq.y;
    s->q.z += t / 2 * dq.z;
    s->q.w += t / 2 * dq.w;
    s->q = quat_unit(s->q);
}

static double difference(const state *s, const rig *p)
{
    double d = quat_distance(s->q, rig_attitude(p));
    for (int k = 0; k < 3; ++k)
        d = fmax(d, fabs((double)(s->w[k] - p->omega[k])));
    return d;
}

static rig some_rig(rng *g, int trial, int free)
{
    const enum rig_storage storage = (enum rig_storage)(trial % 3);
    rig p = trial < 3 ? rig_of_the_paper(storage) : rig_random(g, storage);
    if (free)
        p.pendulum.weight = 0;
    return p;
}

static void vti2_is_quaternion_verlet(void **unused)
{
    (void)unused;
    const double h = 1.0 / 64;
    rng g = rng_seed(231);
    for (int trial = 0; trial < 30; ++trial)
        for (int free = 0; free < 2; ++free) {
            rig p = some_rig(&g, trial, free);
            state s = state_of(&p);
            rig_run(&p, vti_stepper_find("vti2"), h, STEPS);
            for (int i = 0; i < STEPS; ++i) {
                kick(&s, &p, 0.5L * h);
                drift(&s, h);
                kick(&s, &p, 0.5L * h);
            }
            assert_below(difference(&s, &p), rounding(trial));
        }
}

/** VTI-3 by itself is symplectic Euler; started and read with half kicks it is VTI-2. */
static void vti3_is_vti2_between_half_kicks(void **unused)
{
    (void)unused;
    const double h = 1.0 / 64;
    rng g = rng_seed(232);
    for (int trial = 0; trial < 30; ++trial) {
        const rig start = some_rig(&g, trial, 0);
        rig verlet = start, leapfrog = start, euler = start, by_hand = start;
        state s = state_of(&start);
        rig_run(&verlet, vti_stepper_find("vti2"), h, STEPS);
        rig_run(&leapfrog, vti_stepper_find("vti3-leapfrog"), h, STEPS);
        assert_below(rig_difference(&leapfrog, &verlet), rounding(trial));

        /* kick(h/2) after, kick(-h/2) before, through the public primitive */
        const vti_bodies b = rig_bodies(&by_hand);
        rig_moment(&by_hand);
        vti_kick(-0.5 * h, &b);
        rig_steps(&by_hand, vti_stepper_find("vti3"), h, STEPS);
        vti_kick(0.5 * h, &b);
        assert_below(rig_difference(&by_hand, &verlet), rounding(trial));

        rig_run(&euler, vti_stepper_find("vti3"), h, STEPS);
        for (int i = 0; i < STEPS; ++i) {
            kick(&s, &euler, h);
            drift(&s, h);
        }
        assert_below(difference(&s, &euler), rounding(trial));
        assert_true(rig_difference(&euler, &verlet) > 1e-4); /* first order */
    }
}

/** Where the moment at t = 0 is nothing the start's half kick is nothing: VTI-3 goes through VTI-2's attitudes. */
static void they_coincide_from_equilibrium(void **unused)
{
    (void)unused;
    const double h = 1.0 / 64;
    for (int storage = 0; storage < 3; ++storage) {
        rig a = rig_of_the_paper((enum rig_storage)storage), b;
        const rotor upright = {0, 0, 0, 1};
        rig_set_attitude(&a, upright);
        b = a;
        rig_run(&a, vti_stepper_find("vti2"), h, STEPS);
        rig_run(&b, vti_stepper_find("vti3"), h, STEPS);
        assert_close(quat_distance(rig_attitude(&a), rig_attitude(&b)), 0, rounding(0));
    }
}

/** omega = R^T Omega and M = R^T RM: the same motion (E16). */
static void vti1_in_the_bodys_frame(void **unused)
{
    (void)unused;
    const double h = 1.0 / 64;
    rng g = rng_seed(233);
    for (int trial = 0; trial < 30; ++trial) {
        rig space = some_rig(&g, trial, 0), body = space;
        body.frame = VTI_FRAME_BODY;
        quat_rotate(quat_conj(rig_attitude(&space)), space.omega, body.omega);
        rig_run(&space, vti_stepper_find("vti1"), h, STEPS);
        rig_run(&body, vti_stepper_find("vti1-body"), h, STEPS);
        quat_rotate(rig_attitude(&body), body.omega, body.omega);
        assert_below(rig_difference(&body, &space), rounding(trial));
    }
}

RUN_TESTS(cmocka_unit_test(vti2_is_quaternion_verlet), cmocka_unit_test(vti3_is_vti2_between_half_kicks),
          cmocka_unit_test(they_coincide_from_equilibrium), cmocka_unit_test(vti1_in_the_bodys_frame))
