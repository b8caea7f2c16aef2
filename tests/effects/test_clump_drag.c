/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Drag on the spheres of clumps: flows against the equations of motion in long double, what is booked, order, and that
 * nothing gains, whatever the coefficients. */
#include "linear.h"

static uneven m;
static const double still[3] = {0, 0, 0};

/** One clump of so many spheres, whose centres move. */
static void clump(rng *g, int kind, int state, int spheres)
{
    linear_bodies(&m, g, kind, state, 1, spheres);
}

static double booked(void)
{
    return vti_sum_value(&m.lost[0]) + vti_sum_value(&m.lost[1]);
}

static void flow(const vti_drag *drag, double t, double drift)
{
    m.count = 0;
    uneven_add(&m, vti_drag_effect(drag));
    assert_int_equal(vti_effects_flow(m.effects, 1, t, drift, &m.b), VTI_OK);
}

static vti_drag linear_drag(const double *c, const double *angular)
{
    const vti_scalars none = {NULL, 0, 0};
    const vti_drag drag = {.linear = c != NULL ? vti_scalars_array(c) : none,
                           .angular = angular != NULL ? vti_scalars_array(angular) : none,
                           .lost = m.lost};
    return drag;
}

/** All spheres at once, with coefficients of their own, in the frame of the medium: dy/dt = A y. */
static void reference(const double *c, const double *angular, const double medium[3], int spheres, double t, vec y[4])
{
    struct linear at[4];
    const vec v = vec_of(medium);
    for (int s = 0; s < spheres; ++s)
        at[s] = (struct linear){
            .plane = 1, .n = {{0, 0, 1}}, .arm = {linear_lever(&m, s)}, .c = {c[s], c[s], angular[s], angular[s]}};
    linear_state(&m, y);
    y[0] = vec_add(y[0], -1, v);
    linear_flow(&m, at, spheres, t, 64, y);
    y[0] = vec_add(y[0], 1, v);
}

/** One sphere, its drag alone or its angular drag alone: the exponential of the whole system, in a medium that
 *  moves. */
TEST(one_sphere)
{
    rng g = rng_seed(5301);
    for (int trial = 0; trial < 144; ++trial) {
        const int turns = trial % 2;
        const double c = pow(10, uniform(&g, -3, 0.3)), none = 0, t = uniform(&g, 0.05, 1);
        double w[3];
        vec y[4], is[4];
        clump(&g, 1 + trial / 2 % 2, trial / 4 % UNEVEN_STATES, 1);
        vti_drag drag = linear_drag(turns ? NULL : &c, turns ? &c : NULL);
        random_vector(&g, 1, drag.medium);
        reference(turns ? &none : &c, turns ? &c : &none, drag.medium, 1, t, y);
        const double energy = vti_energy(m.effects, 0, &m.b);
        flow(&drag, t, trial % 3 - 1);
        linear_state(&m, is);
        for (int q = 0; q < 2; ++q) /* some 200 operations on numbers below 5 */
            for (int k = 0; k < 3; ++k)
                assert_close(is[q].c[k], y[q].c[k], 1000 * EPS);
        if (m.b.omega.c[0] != NULL) { /* the read-out follows */
            uneven_omega(&m, 0, w);
            assert_close3(m.t.c.omega[0], w, 200 * EPS);
        }
        assert_close(vti_energy(m.effects, 0, &m.b) + booked(), energy, 100 * EPS * (energy + 5));
        assert_true(m.lost[turns].high != 0 && m.lost[1 - turns].high == 0);
    }
}

/** A sphere at the centre has the closed form of a sphere, linear and quadratic drag together. */
TEST(at_the_centre)
{
    rng g = rng_seed(5302);
    for (int trial = 0; trial < 500; ++trial) {
        const double c = trial % 3 == 0 ? 0 : pow(10, uniform(&g, -13, 2)),
                     k = trial % 3 == 1 ? 0 : pow(10, uniform(&g, -13, 6)), t = uniform(&g, 0.01, 2);
        double v[3];
        clump(&g, 1 + trial % 2, UNEVEN_BOTH, 1);
        memset(m.t.offset[0], 0, sizeof m.t.offset[0]);
        memcpy(v, m.t.c.v[0], sizeof v);
        const vti_drag drag = {.linear = vti_scalars_one(&c), .quadratic = vti_scalars_one(&k), .lost = m.lost};
        flow(&drag, t, 1);
        const long double mass = m.t.c.mass[0], z = c * t / mass, speed = vec_norm(vec_of(v)),
                          phi = t / mass * (z > 0 ? -expm1l(-z) / z : 1), f = expl(-z) / (1 + k * speed * phi);
        const long double tau = z + log1pl(k * speed * phi); /* rounds, which the exponential magnifies */
        for (int d = 0; d < 3; ++d)
            assert_close(m.t.c.v[0][d], f * v[d], 8 * EPS * fabs(v[d]) + fabsl(f * v[d]) * 8 * tau * EPS);
    }
}

/** du/dt = -(c + k |u|) K u of one sphere by so many steps of the classical method of order 4, in long double. */
static void quadratic_reference(double c, double k, double t, int steps, vec y[4])
{
    struct linear at = {.plane = 1, .n = {{0, 0, 1}}, .arm = {linear_lever(&m, 0)}};
    linear_state(&m, y);
    for (int step = 0; step < steps; ++step) {
        static const long double ahead[4] = {0, 0.5L, 0.5L, 1}, weight[4] = {1 / 6.0L, 1 / 3.0L, 1 / 3.0L, 1 / 6.0L};
        const long double h = (long double)t / steps;
        vec f[4] = {{{0}}}, sum[4] = {{{0}}};
        for (int stage = 0; stage < 4; ++stage) {
            vec here[4];
            for (int q = 0; q < 4; ++q)
                here[q] = vec_add(y[q], ahead[stage] * h, f[q]);
            const vec u = vec_add(here[0], 1, vec_cross(linear_over(&m, 0, here[1], -1), at.arm[0]));
            at.c[0] = at.c[1] = c + k * vec_norm(u);
            memset(f, 0, sizeof f);
            linear_rate(&m, &at, here, f);
            for (int q = 0; q < 4; ++q)
                sum[q] = vec_add(sum[q], weight[stage], f[q]);
        }
        for (int q = 0; q < 4; ++q)
            y[q] = vec_add(y[q], h, sum[q]);
    }
}

/** Quadratic drag off the centre: a flow errs by t^3, so that steps are of second order. */
TEST(quadratic_drag)
{
    rng g = rng_seed(5303);
    double worst[3] = {0};
    for (int trial = 0; trial < 40; ++trial) {
        const double c = trial % 2 ? 0.4 : 0, k = uniform(&g, 0.5, 2);
        const rng before = g;
        for (int level = 0; level < 3; ++level) {
            vec y[4], is[4];
            const double t = 0.005 / (1 << level);
            g = before;
            clump(&g, UNEVEN_CLUMPS, UNEVEN_BOTH, 1);
            quadratic_reference(c, k, t, 40, y);
            const vti_drag drag = {.linear = vti_scalars_one(&c), .quadratic = vti_scalars_one(&k), .lost = m.lost};
            flow(&drag, t, 1);
            linear_state(&m, is);
            for (int q = 0; q < 2; ++q)
                worst[level] = fmax(worst[level], (double)vec_norm(vec_add(is[q], -1, y[q])));
        }
    }
    print_message("a flow errs by %.1e %.1e %.1e\n", worst[0], worst[1], worst[2]);
    for (int level = 0; level < 2; ++level)
        assert_close(log2(worst[level] / worst[level + 1]), 3, 0.25);
}

/** Spheres of one body do not commute: forwards and backwards by turns are of second order, towards the exponential of
 *  all of them together. */
TEST(order_of_the_spheres)
{
    const double c[4] = {0.3, 0.9, 0.5, 0.2}, angular[4] = {0.02, 0.1, 0.05, 0.03}, medium[3] = {0.5, -0.2, 0.3};
    for (int kind = UNEVEN_CLUMPS; kind < UNEVEN_KINDS; ++kind) {
        double error[2];
        for (int level = 0; level < 2; ++level) {
            rng g = rng_seed(5304);
            vec y[4], is[4];
            const int halves = 8 << level;
            clump(&g, kind, UNEVEN_BOTH, 4);
            vti_drag drag = linear_drag(c, angular);
            memcpy(drag.medium, medium, sizeof medium);
            reference(c, angular, medium, 4, 1, y);
            for (int k = 0; k < 2 * halves; ++k)
                flow(&drag, 0.5 / halves, k % 2 ? -1 : 1);
            linear_state(&m, is);
            error[level] = 0;
            for (int q = 0; q < 2; ++q)
                error[level] = fmax(error[level], (double)vec_norm(vec_add(is[q], -1, y[q])));
        }
        print_message("8, 16 flows: %.1e %.1e\n", error[0], error[1]);
        assert_close(log2(error[0] / error[1]), 2, 0.1);
    }
}

/** Whatever the coefficients and the time, of needles and plates too: the energy beside the medium never grows, and
 *  what is gone is booked. */
TEST(never_gains)
{
    rng g = rng_seed(5305);
    for (int trial = 0; trial < 500; ++trial) {
        double c[3][4];
        clump(&g, UNEVEN_CLUMPS, UNEVEN_BOTH, 4);
        if (trial % 4 == 0) {
            m.moments[0][0] = 1e-6;
            m.moments[0][1] = m.moments[0][2] = 1;
            uneven_spin_up(&m);
        }
        for (int s = 0; s < 4; ++s)
            for (int k = 0; k < 3; ++k)
                c[k][s] = pow(10, uniform(&g, -6, trial % 2 ? 1 : 12));
        const vti_drag drag = {.linear = vti_scalars_array(c[0]),
                               .quadratic = vti_scalars_array(c[1]),
                               .angular = vti_scalars_array(c[2]),
                               .lost = m.lost};
        const double energy = vti_energy(m.effects, 0, &m.b);
        flow(&drag, pow(10, uniform(&g, -3, 3)), trial % 2 ? 1 : -1);
        const double left = vti_energy(m.effects, 0, &m.b);
        assert_true(left <= energy * (1 + 1e-9) && all_finite(m.spin[0], 3) && all_finite(m.t.c.v[0], 3));
        assert_close(left + booked(), energy, 1e-9 * energy); /* of L across a thin axis it is known to eps 1e6 */
    }
}

/** A clump that falls and turns through a medium, to where it is at the end. What is lost is booked: Verlet is exact in
 *  a uniform field, and the turn keeps the energy of a body to far less than this. */
static void fall(double end, int steps, vec y[4])
{
    rng g = rng_seed(5306);
    const double c[4] = {0.5, 0.9, 0.3, 0.4}, k = 0.2, angular = 0.05;
    const vti_gravity gravity = {{0, 0, -1}};
    clump(&g, UNEVEN_CLUMPS, UNEVEN_BOTH, 4);
    const vti_drag drag = {.linear = vti_scalars_array(c),
                           .quadratic = vti_scalars_one(&k),
                           .angular = vti_scalars_one(&angular),
                           .lost = m.lost};
    uneven_add(&m, vti_drag_effect(&drag));
    m.effects[m.count++] = vti_gravity_effect(&gravity);
    const double before = uneven_ledger(&m);
    uneven_go(&m, vti_stepper_find("exact"), end / steps, steps);
    assert_close(uneven_ledger(&m), before, 1e-9);
    linear_state(&m, y);
}

/** Of second order, and the velocity tends to the one at which drag bears the weight. */
TEST(a_fall)
{
    vec fine[4], y[4];
    double error[2] = {0};
    fall(2, 3200, fine);
    for (int level = 0; level < 2; ++level) {
        fall(2, 100 << level, y);
        for (int q = 0; q < 2; ++q)
            error[level] = fmax(error[level], (double)vec_norm(vec_add(y[q], -1, fine[q])));
    }
    print_message("100, 200 steps: %.1e %.1e\n", error[0], error[1]);
    assert_close(log2(error[0] / error[1]), 2, 0.1);
    fall(60, 3000, y);
    double force[3] = {0, 0, -m.t.c.mass[0]};
    assert_int_equal(vti_clumps_spread(&m.t.clumps, &m.b), VTI_OK);
    static const double c[4] = {0.5, 0.9, 0.3, 0.4};
    for (int s = 0; s < 4; ++s)
        for (int d = 0; d < 3; ++d)
            force[d] -= (c[s] + 0.2 * vti_norm(m.t.s.v[s])) * m.t.s.v[s][d];
    assert_close3(force, still, 1e-3);
}

/** A body on a pivot has no v: it is slowed as far as it turns; one that nothing turns is slowed as a whole. */
TEST(absent_motions)
{
    rng g = rng_seed(5307);
    const double c = 1e3, k = 1;
    clump(&g, UNEVEN_CLUMPS, UNEVEN_SPIN, 1);
    vti_drag drag = {.linear = vti_scalars_one(&c), .quadratic = vti_scalars_one(&k), .lost = m.lost};
    m.b.v = vti_view_none();
    const double energy = vti_energy(m.effects, 0, &m.b);
    flow(&drag, 10, 1);
    assert_int_equal(vti_clumps_spread(&m.t.clumps, &m.b), VTI_OK);
    assert_close3(m.t.s.v[0], still, 1e-12);
    assert_close(vti_energy(m.effects, 0, &m.b) + booked(), energy, 100 * EPS * energy);
    assert_true(m.lost[0].high > 0);
    memset(m.t.offset, 0, sizeof m.t.offset);
    flow(&drag, 10, 1);
    assert_true(all_finite(m.spin[0], 3) && all_finite(&m.lost[0].high, 1));
    m.b.v = crowd_bodies(&m.t.c).v;
    m.b.omega = m.b.spin = m.b.moment = m.b.moments = vti_view_none();
    m.b.principal = vti_bodies_none(1).quat;
    m.t.offset[0][0] = 0.3;
    flow(&drag, 10, 1);
    assert_close3(m.t.c.v[0], still, 1e-12);
}

/** What moves with the medium and does not turn loses nothing, by quadratic drag either. */
TEST(at_rest)
{
    rng g = rng_seed(5309);
    const double c = 2, k = 3;
    for (int trial = 0; trial < 4; ++trial) {
        clump(&g, UNEVEN_CLUMPS + trial % 2, UNEVEN_BOTH, 3);
        vti_drag drag = {.quadratic = vti_scalars_one(&k), .medium = {1, -2, 0.5}, .lost = m.lost};
        if (trial >= 2)
            drag.linear = vti_scalars_one(&c);
        memcpy(m.t.c.v[0], drag.medium, sizeof drag.medium);
        memset(m.t.c.omega[0], 0, sizeof m.t.c.omega[0]);
        memset(m.spin[0], 0, sizeof m.spin[0]);
        flow(&drag, 0.3, 1);
        flow(&drag, 0.3, -1);
        assert_same_bits(m.t.c.v[0], drag.medium, 3);
        assert_close3(m.t.c.omega[0], still, 0);
        assert_close3(m.spin[0], still, 0);
        assert_true(booked() == 0);
    }
}

/** A flow that does nothing leaves steps with several drifts as they are, the turns of bodies with moments too. */
TEST(idle_flows)
{
    const double none = 0;
    const vti_stepper *const method = vti_stepper_find("chin4");
    for (int kind = UNEVEN_CLUMPS; kind < UNEVEN_KINDS; ++kind) {
        static crowd free;
        double spin[3];
        for (int flows = 0; flows < 2; ++flows) {
            rng g = rng_seed(5308);
            clump(&g, kind, UNEVEN_BOTH, 1);
            const vti_drag drag = linear_drag(NULL, &none);
            uneven_add(&m, vti_drag_effect(&drag));
            for (int step = 0; step < 10; ++step) {
                assert_int_equal(vti_effects_begin(method, 0.1, m.effects, flows, &m.b, NULL), VTI_OK);
                assert_int_equal(vti_effects_stage(method, 1, 0.1, m.effects, flows, &m.b, NULL), VTI_OK);
                assert_int_equal(vti_effects_finish(method, 0.1, m.effects, flows, &m.b), VTI_OK);
            }
            if (flows) {
                assert_same_bits(m.t.c.alpha[0], free.alpha[0], 3);
                assert_same_bits(m.t.c.quat[0], free.quat[0], 4);
                assert_same_bits(m.spin[0], spin, 3);
            }
            free = m.t.c;
            memcpy(spin, m.spin[0], sizeof spin);
        }
    }
}

RUN_TESTS(cmocka_unit_test(one_sphere), cmocka_unit_test(at_the_centre), cmocka_unit_test(quadratic_drag),
          cmocka_unit_test(order_of_the_spheres), cmocka_unit_test(never_gains), cmocka_unit_test(a_fall),
          cmocka_unit_test(absent_motions), cmocka_unit_test(at_rest), cmocka_unit_test(idle_flows))
