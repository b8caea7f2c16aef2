/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Drag against the closed forms of its equations of motion, which it is the exact flow of, and against what a fall
 * through a medium tends to. */
#include "crowd.h"

static vti_sum lost[VTI_DRAG_BOOKS];
static crowd c;
static vti_bodies b;

/** One body of mass m and inertia j that moves and turns. */
static void body(double m, double j, const double v[3], const double omega[3])
{
    crowd_clear(&c, 1, CROWD_ALPHA);
    c.mass[0] = m;
    c.inertia[0] = j;
    memcpy(c.v[0], v, sizeof c.v[0]);
    memcpy(c.omega[0], omega, sizeof c.omega[0]);
    b = crowd_bodies(&c);
    memset(lost, 0, sizeof lost);
}

/** By how much what is expected may be off, however small: all of it below 2^-500, which is 0. */
static long double least_error(long double expected)
{
    return fabsl(expected) < 0x1p-500L ? 0x1p-500L : DBL_MIN;
}

static void flow(const vti_drag *drag, double t)
{
    const vti_effect effect = vti_drag_effect(drag);
    assert_int_equal(vti_effects_flow(&effect, 1, t, t, &b), VTI_OK);
}

/** u(t)/u(0) of m u' = -c u - k |u| u: w' = -(c w + k w^2)/m is of Bernoulli's kind. */
static long double slowed(long double m, long double coefficient, long double k, long double speed, long double t)
{
    const long double z = coefficient * t / m, phi = t / m * (z > 0 ? -expm1l(-z) / z : 1);
    return expl(-z) / (1 + k * speed * phi);
}

/** Over all rates, gentle ones in which the loss is nearly nothing and hard ones that stop a body at once. */
TEST(closed_forms)
{
    rng g = rng_seed(1401);
    for (int trial = 0; trial < 20000; ++trial) {
        double v[3], omega[3];
        const double m = uniform(&g, 0.1, 10), j = uniform(&g, 0.1, 10), t = uniform(&g, 0.01, 2);
        const double coefficients[3] = {trial % 3 == 0 ? 0 : pow(10, uniform(&g, -13, 2.6)),
                                        trial % 3 == 1 ? 0 : pow(10, uniform(&g, -13, 3)),
                                        pow(10, uniform(&g, -13, 2.6))};
        random_vector(&g, 3, v);
        random_vector(&g, 3, omega);
        body(m, j, v, omega);
        const vti_drag drag = {.linear = vti_scalars_one(&coefficients[0]),
                               .quadratic = vti_scalars_one(&coefficients[1]),
                               .angular = vti_scalars_one(&coefficients[2]),
                               .lost = lost};
        flow(&drag, t);
        const long double w2 = (long double)v[0] * v[0] + (long double)v[1] * v[1] + (long double)v[2] * v[2],
                          s2 = (long double)omega[0] * omega[0] + (long double)omega[1] * omega[1] +
                               (long double)omega[2] * omega[2];
        const long double f = slowed(m, coefficients[0], coefficients[1], sqrtl(w2), t),
                          q = expl(-(long double)coefficients[2] * t / j);
        const long double z = (long double)coefficients[0] * t / m, r = (long double)coefficients[2] * t / j,
                          phi = t / m * (z > 0 ? -expm1l(-z) / z : 1), x = coefficients[1] * sqrtl(w2) * phi,
                          gone = (-expm1l(-z) + x) / (1 + x);
        for (int k = 0; k < 3; ++k) { /* z and r round, which their exponentials magnify */
            assert_close(c.v[0][k], f * v[k], least_error(f * v[k]) + fabsl(f * v[k]) * (16 + 2 * z) * EPS);
            assert_close(c.omega[0][k], q * omega[k],
                         least_error(q * omega[k]) + fabsl(q * omega[k]) * (8 + 2 * r) * EPS);
        }
        assert_close(vti_sum_value(&lost[0]), m * w2 / 2 * gone * (1 + f), m * w2 * gone * 24 * EPS);
        assert_close(vti_sum_value(&lost[1]), j * s2 / 2 * -expm1l(-2 * r), j * s2 * -expm1l(-2 * r) * 16 * EPS);
    }
}

/** One flow of t is two of t/2, and in a medium that moves speeds tend to its velocity and never grow beside it. */
TEST(a_medium_that_moves)
{
    rng g = rng_seed(1402);
    const double still[3] = {0, 0, 0};
    for (int trial = 0; trial < 2000; ++trial) {
        double v[3], whole[3], before = 0, after = 0;
        const double linear = uniform(&g, 0, 3), quadratic = uniform(&g, 0, 3), m = uniform(&g, 0.1, 10);
        vti_drag drag = {.linear = vti_scalars_one(&linear), .quadratic = vti_scalars_one(&quadratic), .lost = lost};
        random_vector(&g, 3, v);
        random_vector(&g, 3, drag.medium);
        body(m, 1, v, still);
        flow(&drag, 1);
        memcpy(whole, c.v[0], sizeof whole);
        const double kinetic = vti_kinetic_translation(&b) + vti_sum_value(&lost[0]);
        body(m, 1, v, still);
        assert_close(kinetic, vti_kinetic_translation(&b), 32 * EPS * (kinetic + 27 * m));
        flow(&drag, 0.5);
        flow(&drag, 0.5);
        assert_close3(c.v[0], whole, 64 * EPS);
        for (int k = 0; k < 3; ++k) {
            before += pow(v[k] - drag.medium[k], 2);
            after += pow(whole[k] - drag.medium[k], 2);
        }
        assert_below(after, before);
        flow(&drag, 1e6);
        assert_close3(c.v[0], drag.medium, quadratic > 0 && linear > 1e-3 ? 8 * EPS : 1e-3);
    }
}

/** A fall from rest with linear drag: v = g (m/c) (1 - exp(-c t/m)); the error and the ledger's fall fourfold with
 *  h/2. */
TEST(a_fall)
{
    const double linear = 1.5, still[3] = {0, 0, 0}, m = 2, end = 3, exact = m / linear * -expm1(-linear * end / m);
    const vti_gravity gravity = {{0, 0, -1}};
    const vti_drag drag = {.linear = vti_scalars_one(&linear), .lost = lost};
    const vti_effect effects[] = {vti_drag_effect(&drag), vti_gravity_effect(&gravity)};
    const vti_stepper *const exactly = vti_stepper_find("exact");
    double error[3], ledger[3];
    for (int level = 0; level < 3; ++level) {
        const int steps = 30 << level;
        body(m, 1, still, still);
        assert_int_equal(vti_apply(effects, 2, &b), VTI_OK);
        for (int step = 0; step < steps; ++step) {
            assert_int_equal(vti_effects_begin(exactly, end / steps, effects, 2, &b, NULL), VTI_OK);
            assert_int_equal(vti_apply(effects, 2, &b), VTI_OK);
            assert_int_equal(vti_effects_finish(exactly, end / steps, effects, 2, &b), VTI_OK);
        }
        error[level] = fabs(c.v[0][2] + exact);
        ledger[level] = fabs(vti_energy(effects, 2, &b) + vti_booked(effects, 2));
    }
    for (int level = 0; level < 2; ++level)
        assert_close(log2(error[level] / error[level + 1]), 2, 0.02);
    assert_below(ledger[0], 64 * EPS); /* Verlet is exact in a uniform field, and what flows take is booked */
}

/** What falls on moves F/c times (z/2) coth(z/2) on, z = c h/m, by Verlet and by VTI-3 alike. */
TEST(the_steady_fall)
{
    static const char *const names[] = {"vti1", "vti2", "exact", "vti3", "vti3-leapfrog"};
    const double linear = 1.5, still[3] = {0, 0, 0}, m = 2;
    const vti_gravity gravity = {{0, 0, -1}};
    const vti_drag drag = {.linear = vti_scalars_one(&linear), .lost = lost};
    const vti_effect effects[] = {vti_drag_effect(&drag), vti_gravity_effect(&gravity)};
    for (int k = 0; k < 5; ++k)
        for (double z = 1.0 / 16; z < 40; z *= 4) {
            const double h = z * m / linear;
            double before = 0;
            body(m, 1, still, still);
            assert_int_equal(vti_apply(effects, 2, &b), VTI_OK);
            for (int step = 0; step < 2000; ++step) {
                before = c.x[0][2];
                assert_int_equal(vti_effects_begin(vti_stepper_find(names[k]), h, effects, 2, &b, NULL), VTI_OK);
                assert_int_equal(vti_apply(effects, 2, &b), VTI_OK);
                assert_int_equal(vti_effects_finish(vti_stepper_find(names[k]), h, effects, 2, &b), VTI_OK);
            }
            assert_close((before - c.x[0][2]) / h / (m / linear), z / 2 / tanh(z / 2), 1e-11 * z);
        }
}

/** Coefficients and velocities whose products leave the range of numbers stop a body, and book what it had. */
TEST(beyond_all_measure)
{
    static const double far[][5] = {/* c, k, m, t, speed */
                                    {0, 1e300, 1, 1, 1e10},
                                    {1, 1e308, 1e-300, 1e10, 1e100},
                                    {1e300, 1e300, 1e-300, 1, 1e10},
                                    {1e-300, 1e300, 1, 1e300, 1e100}};
    for (int k = 0; k < 4; ++k) {
        const double v[3] = {0, -far[k][4], 0}, omega[3] = {0, 0, 0};
        const vti_drag drag = {
            .linear = vti_scalars_one(&far[k][0]), .quadratic = vti_scalars_one(&far[k][1]), .lost = lost};
        body(far[k][2], 1, v, omega);
        flow(&drag, far[k][3]);
        assert_true(vti_norm(c.v[0]) <= 1);
        const double had = 0.5 * far[k][2] * far[k][4] * far[k][4];
        assert_close(vti_sum_value(&lost[0]), had, 4 * EPS * had);
    }
}

/** The residual of a compensated sum decays with what it belongs to, though v alone has too few bits to show it; a mass
 *  that is no number shows. */
TEST(residuals)
{
    const double k = 2, angular = 0.7, v[3] = {3, 0, 4}, omega[3] = {1, 2, 3}, low = 1e-17;
    double v_low[3] = {low, -low, 0}, omega_low[3] = {0, low, low};
    vti_drag drag = {.quadratic = vti_scalars_one(&k), .lost = lost};
    body(1.5, 0.5, v, omega);
    b.v_low = vti_view_packed(v_low);
    b.omega_low = vti_view_packed(omega_low);
    flow(&drag, 0.25);
    const double kept = 1 / (1 + k * 5 * 0.25 / 1.5);
    assert_close(v_low[0], low * kept, 4 * EPS * low);
    assert_close(v_low[1], -low * kept, 4 * EPS * low);
    assert_close(c.v[0][2], 4 * kept, 8 * EPS);
    assert_true(omega_low[1] == low && c.omega[0][1] == 2 && lost[1].high == 0);
    drag = (vti_drag){.angular = vti_scalars_one(&angular), .lost = lost};
    flow(&drag, 0.25);
    assert_close(omega_low[2], low * exp(-angular * 0.25 / 0.5), 4 * EPS * low);
    assert_close(v_low[0], low * kept, 4 * EPS * low);
    drag = (vti_drag){.linear = vti_scalars_one(&angular), .lost = lost};
    c.mass[0] = NAN;
    flow(&drag, 0.25);
    assert_true(isnan(c.v[0][0]) && isnan(lost[0].high) && c.omega[0][0] != 0);
}

/** Velocities that decay end at 0, and do not go on as subnormal numbers: of spheres, of their residuals, and of bodies
 *  with moments. */
TEST(rest)
{
    const double rate = 0.1, v[3] = {3, 0, -4}, omega[3] = {1, -2, 3}, moments[3] = {1, 2, 3},
                 upright[4] = {0, 0, 0, 1};
    const vti_drag drag = {.linear = vti_scalars_one(&rate), .angular = vti_scalars_one(&rate), .lost = lost};
    const vti_effect effect = vti_drag_effect(&drag);
    for (int which = 0; which < 3; ++which) {
        double low[2][3] = {{1e-17, -1e-17, 0}, {0, 1e-17, 1e-17}}, spin[3] = {1, -4, 9}, m[3], q[4];
        memcpy(m, moments, sizeof m);
        memcpy(q, upright, sizeof q);
        body(1, 1, v, omega);
        if (which == 1) {
            b.v_low = vti_view_packed(low[0]);
            b.omega_low = vti_view_packed(low[1]);
        } else if (which == 2) {
            b.inertia.p = NULL;
            b.moments = vti_view_packed(m);
            b.principal = quats_packed(q);
            b.spin = vti_view_packed(spin);
        }
        for (int k = 0; k < 12000; ++k) {
            assert_true(k > 3000 || vti_norm(c.v[0]) > 0);
            assert_int_equal(vti_effects_flow(&effect, 1, 1, -1, &b), VTI_OK);
        }
        for (int k = 0; k < 3; ++k) {
            assert_true(c.v[0][k] == 0 && c.omega[0][k] == 0);
            assert_true(which != 1 || (low[0][k] == 0 && low[1][k] == 0));
            assert_true(which != 2 || spin[k] == 0);
        }
    }
}

/** A body with moments: L about each principal axis decays by its own moment, with Omega shown or alone. */
TEST(three_moments)
{
    rng g = rng_seed(1402);
    for (int trial = 0; trial < 300; ++trial) {
        double v[3], spin[3], moments[3] = {uniform(&g, 1, 2), uniform(&g, 1, 2), uniform(&g, 1, 2)}, q[4], p[3], is[3];
        const double t = uniform(&g, 0.01, 2), coefficient = pow(10, uniform(&g, -6, 1));
        const vti_drag drag = {.angular = vti_scalars_one(&coefficient), .lost = lost};
        random_vector(&g, 3, v);
        random_vector(&g, 3, spin);
        random_unit(&g, 4, q);
        body(1, 1, v, spin);
        crowd_tumble(&c, &g);
        const rotor axes = quat_times(crowd_attitude(&c, 0), quat_of_xyzw(q));
        b.inertia.p = NULL;
        b.moments = vti_view_packed(moments);
        b.principal = quats_packed(q);
        quat_rotate(quat_conj(axes), spin, p);
        for (int k = 0; k < 3; ++k)
            p[k] /= moments[k];
        quat_rotate(axes, p, c.omega[0]);
        if (trial % 2)
            b.spin = vti_view_packed(spin);
        const vti_effect effect = vti_drag_effect(&drag);
        const double energy = vti_energy(&effect, 1, &b);
        flow(&drag, t);
        for (int k = 0; k < 3; ++k)
            p[k] *= exp(-coefficient * t / moments[k]);
        quat_rotate(axes, p, is);
        assert_close3(c.omega[0], is, 100 * EPS);
        if (trial % 2) {
            for (int k = 0; k < 3; ++k)
                p[k] *= moments[k];
            quat_rotate(axes, p, is);
            assert_close3(spin, is, 100 * EPS);
        }
        assert_close(vti_energy(&effect, 1, &b) + lost[1].high, energy, 40 * EPS * energy);
        assert_true(lost[1].high > 0);
    }
}

/** Many bodies, in any layout, have the bits of those with residuals of 0, which are done one by one: with rest, speeds
 *  the squares of which are out of range, and coefficients of some alone. */
TEST(many)
{
    enum { MOST = 40 };
    rng g = rng_seed(1403);
    for (int trial = 0; trial < 400; ++trial) {
        double value[3][MOST], apart[2][3][MOST], zero[2][MOST][3] = {{{0}}};
        const int n = 1 + (int)uniform(&g, 0, MOST - 0.1), separate = trial % 2;
        vti_drag drag = {.linear = vti_scalars_array(value[0]), .angular = vti_scalars_array(value[2]), .lost = lost};
        if (trial % 3 > 0)
            drag.quadratic = vti_scalars_array(value[1]);
        if (trial % 5 > 0)
            random_vector(&g, 3, drag.medium);
        crowd_clear(&c, n, CROWD_ALPHA);
        for (int i = 0; i < n; ++i) {
            const double sizes[] = {0, pow(10, uniform(&g, -300, -130)), pow(10, uniform(&g, 140, 152.5))},
                         size = trial % 4 == 0 && i % 4 < 3 ? sizes[i % 4] : 1;
            c.mass[i] = uniform(&g, 0.1, 10);
            c.inertia[i] = uniform(&g, 0.1, 10);
            for (int k = 0; k < 3; ++k) {
                value[k][i] = uniform(&g, -1, 1) < -0.5 ? 0 : pow(10, uniform(&g, -6, 3));
                apart[0][k][i] = c.v[i][k] = size * uniform(&g, -1, 1);
                apart[1][k][i] = c.omega[i][k] = uniform(&g, -1, 1);
            }
            if (size > 0 && size < 1e-100)
                value[1][i] = 1 / size;
        }
        vti_sum singly[VTI_DRAG_BOOKS];
        b = crowd_bodies(&c);
        memset(lost, 0, sizeof lost);
        if (separate) {
            b.v = vti_view_separate(apart[0][0], apart[0][1], apart[0][2]);
            b.omega = vti_view_separate(apart[1][0], apart[1][1], apart[1][2]);
            flow(&drag, 0.25);
            b = crowd_bodies(&c);
        } else {
            crowd all = c;
            b = crowd_bodies(&all);
            flow(&drag, 0.25);
            for (int i = 0; i < n; ++i)
                for (int k = 0; k < 3; ++k) {
                    apart[0][k][i] = all.v[i][k];
                    apart[1][k][i] = all.omega[i][k];
                }
            b = crowd_bodies(&c);
        }
        memcpy(singly, lost, sizeof lost);
        memset(lost, 0, sizeof lost);
        b.v_low = vti_view_packed(zero[0][0]);
        b.omega_low = vti_view_packed(zero[1][0]);
        flow(&drag, 0.25);
        assert_memory_equal(singly, lost, sizeof lost);
        for (int i = 0; i < n; ++i)
            for (int k = 0; k < 3; ++k)
                assert_true(apart[0][k][i] == c.v[i][k] && apart[1][k][i] == c.omega[i][k]);
    }
}

TEST(what_it_needs_and_refuses)
{
    const double one = 1, some[] = {1, 2}, v[3] = {1, 2, 3}, bad[] = {-1, INFINITY, NAN};
    vti_drag drag = {.linear = vti_scalars_array(some), .angular = vti_scalars_one(&one), .lost = lost};
    body(1, 1, v, v);
    vti_effect effect = vti_drag_effect(&drag);
    assert_true(effect.books == 2 && effect.breaks == 0777 && effect.dissipates && effect.apply == NULL);
    assert_int_equal(vti_effects_check(&effect, 1, &b, NULL), VTI_OK);
    assert_int_equal(vti_step_check(vti_stepper_find("srkn6"), &effect, 1), VTI_E_DISSIPATES);
    for (int k = 0; k < 3; ++k) {
        drag.quadratic = vti_scalars_one(&bad[k]);
        assert_int_equal(vti_effects_check(&effect, 1, &b, NULL), VTI_E_DAMPING);
        drag.quadratic.p = NULL;
        drag.medium[k] = bad[1 + k % 2];
        assert_int_equal(vti_effects_flow(&effect, 1, 1, 1, &b), VTI_E_DAMPING);
        drag.medium[k] = 0;
    }
    drag.linear.count = 0; /* not known */
    assert_int_equal(vti_effects_check(&effect, 1, &b, NULL), VTI_OK);
    drag.linear = (vti_scalars){some, 1, 1};
    assert_int_equal(vti_effects_check(&effect, 1, &b, NULL), VTI_OK);
    b.first = 1; /* of which there is none */
    assert_int_equal(vti_effects_flow(&effect, 1, 1, 1, &b), VTI_E_COUNT);
    b.first = 0;
    assert_true(c.v[0][0] == 1 && lost[0].high == 0);
    b.moment = vti_view_none();
    b.inertia.p = NULL;
    assert_int_equal(vti_effects_check(&effect, 1, &b, NULL), VTI_E_INERTIA);
    b.omega = vti_view_none();
    assert_int_equal(vti_effects_check(&effect, 1, &b, NULL), VTI_E_NEEDS);
    drag.angular.p = NULL;
    effect = vti_drag_effect(&drag);
    drag.lost = NULL;
    assert_int_equal(vti_effects_check(&effect, 1, &b, NULL), VTI_E_NULL);
    drag.lost = lost;
    assert_int_equal(vti_effects_check(&effect, 1, &b, NULL), VTI_OK);
    assert_true(effect.books == 1 && effect.booked == lost && effect.breaks == 077);
    assert_string_equal(effect.book[0], "lost_drag_translation");
    drag.linear.p = NULL;
    drag.angular = vti_scalars_one(&one);
    effect = vti_drag_effect(&drag);
    assert_true(effect.books == 1 && effect.booked == lost + 1 && effect.breaks == 0770);
    assert_string_equal(effect.book[0], "lost_drag_rotation");
    vti_scalars *const each[] = {&drag.linear, &drag.quadratic, &drag.angular};
    const vti_scalars none = {NULL, 0, 0};
    body(1, 1, v, v);
    b.first = 1;
    for (int k = 0; k < 3; ++k) { /* of each by itself there have to be as many as bodies */
        drag.linear = drag.quadratic = drag.angular = none;
        *each[k] = (vti_scalars){some, 1, 1};
        effect = vti_drag_effect(&drag);
        assert_int_equal(vti_effects_check(&effect, 1, &b, NULL), VTI_E_COUNT);
        each[k]->count = 2;
        assert_int_equal(vti_effects_check(&effect, 1, &b, NULL), VTI_OK);
    }
    drag.lost = NULL;
    effect = vti_drag_effect(&drag);
    assert_int_equal(vti_effects_check(&effect, 1, &b, NULL), VTI_E_NULL);
    effect = vti_drag_effect(NULL);
    assert_int_equal(vti_effects_check(&effect, 1, &b, NULL), VTI_E_NULL);
}

RUN_TESTS(cmocka_unit_test(closed_forms), cmocka_unit_test(a_medium_that_moves), cmocka_unit_test(a_fall),
          cmocka_unit_test(the_steady_fall), cmocka_unit_test(beyond_all_measure), cmocka_unit_test(residuals),
          cmocka_unit_test(rest), cmocka_unit_test(three_moments), cmocka_unit_test(many),
          cmocka_unit_test(what_it_needs_and_refuses))
