/* SPDX-License-Identifier: BSD-3-Clause
 *
 * AN(K, c): orders K + 1 on a chain of bonds, the reach of each from the growth of an oscillator, what is kept, and
 * that slices, layouts and copies of the past keep the bits. */
#include "chain.h"

enum { DEPTH = 10, BODIES = 4 };

/** A chain and what it has felt. */
typedef struct flight {
    chain c;
    double memory[BODIES][DEPTH][6];
    vti_past past;
} flight;

static void flight_make(flight *f, enum chain_storage storage, int64_t depth)
{
    chain_make(&f->c, BODIES, 7, storage);
    const vti_past none = {f->memory[0][0], depth, 0};
    f->past = none;
    const vti_bodies b = chain_bodies(&f->c);
    chain_load(&f->c, &b);
}

static void step(flight *f, const vti_multistep *m, double h)
{
    const vti_bodies b = chain_bodies(&f->c);
    assert_int_equal(vti_multistep_predict(m, h, &f->past, &b, NULL), VTI_OK);
    chain_load(&f->c, &b);
    assert_int_equal(vti_multistep_correct(m, h, &f->past, &b), VTI_OK);
}

/** K - 1 steps of h by a method that is accurate enough, the accelerations remembered before each and after the
 *  last. */
static void start(flight *f, const vti_multistep *m, double h)
{
    const vti_bodies b = chain_bodies(&f->c);
    while (f->past.known < m->depth - 1) {
        assert_int_equal(vti_multistep_record(&f->past, &b), VTI_OK);
        const int parts = m->depth < 9 ? 1 : 4;
        for (int k = 0; k < parts; ++k)
            play_step(vti_stepper_find(parts == 1 ? "srkn11" : "kl8"), h / parts, &b, NULL, chain_load, &f->c);
    }
    assert_int_equal(vti_multistep_record(&f->past, &b), VTI_OK);
}

static void fly(flight *f, const vti_multistep *m, double h, int steps)
{
    start(f, m, h);
    for (int k = (int)m->depth - 1; k < steps; ++k)
        step(f, m, h);
}

/** Largest difference of positions, attitudes and spins. */
static double distance(const chain *a, const chain *b)
{
    double worst = 0.0;
    for (int i = 0; i < BODIES; ++i)
        for (int k = 0; k < 3; ++k) {
            worst = fmax(worst, fabs(a->x[i][k] - b->x[i][k]));
            worst = fmax(worst, fabs(a->omega[i][k] - b->omega[i][k]));
            worst = fmax(worst, quat_distance(chain_attitude(a, i), chain_attitude(b, i)));
        }
    return worst;
}

/** At t = 4 by kl8, another method of another kind, at a step where its own error is rounding. */
static void solve(chain *c, enum chain_storage storage)
{
    chain_make(c, BODIES, 7, storage);
    const vti_bodies b = chain_bodies(c);
    chain_load(c, &b);
    for (int k = 0; k < 400; ++k)
        play_step(vti_stepper_find("kl8"), 0.01, &b, NULL, chain_load, c);
}

static void orders(void **state)
{
    (void)state;
    static const double finest[] = {0.01, 0.02, 0.025, 4.0 / 140, 4.0 / 180};
    chain exact;
    solve(&exact, CHAIN_ALPHA);
    for (int64_t k = 0; k < vti_multistep_count(); ++k) {
        const vti_multistep *m = vti_multistep_at(k);
        double error[2];
        for (int level = 0; level < 2; ++level) {
            flight f;
            const double h = finest[k] * (level == 0 ? 2 : 1);
            flight_make(&f, CHAIN_ALPHA, m->depth);
            fly(&f, m, h, (int)lround(4.0 / h));
            error[level] = distance(&f.c, &exact);
        }
        const double order = log2(error[0] / error[1]);
        print_message("%s: errors %.2e, %.2e, order %.2f\n", m->name, error[0], error[1], order);
        const double expected = (double)m->depth + (m->u == 0.0);
        /* at steps of which an10-fine errs by more than rounding, its next term shows too */
        assert_true(order > expected - 0.6 && order < expected + (m->reach < 0.2 ? 1.6 : 1.0));
    }
}

/** Growth per step of x'' = -x, from a past that excites all roots. */
static double growth(const vti_multistep *m, double h)
{
    double x[3] = {1.0, 0.0, 0.0}, v[3] = {0.0, 0.0, 0.0}, f[3] = {0.0, 0.0, 0.0}, memory[DEPTH][6], size[2];
    const double mass = 1.0;
    vti_bodies b = vti_bodies_none(1);
    vti_past past = {memory[0], DEPTH, 0};
    b.x = vti_view_packed(x);
    b.v = vti_view_packed(v);
    b.force = vti_view_packed(f);
    b.mass = vti_scalars_one(&mass);
    for (int k = 0; k < m->depth; ++k) {
        f[0] = k % 2 == 0 ? 1.0 : -0.5;
        assert_int_equal(vti_multistep_record(&past, &b), VTI_OK);
    }
    for (int half = 0; half < 2; ++half) {
        size[half] = 0.0;
        for (int k = 0; k < 60000; ++k) {
            assert_int_equal(vti_multistep_predict(m, h, &past, &b, NULL), VTI_OK);
            f[0] = -x[0];
            if (fabs(x[0]) > 1e100)
                return INFINITY;
            assert_int_equal(vti_multistep_correct(m, h, &past, &b), VTI_OK);
            size[half] = k >= 59900 ? fmax(size[half], hypot(x[0], v[0])) : 0.0;
        }
    }
    return pow(size[1] / size[0], 1.0 / 60000);
}

static void reaches(void **state)
{
    (void)state;
    for (int64_t k = 0; k < vti_multistep_count(); ++k) {
        const vti_multistep *m = vti_multistep_at(k);
        const double below = 0.985 * m->reach, above = 1.015 * m->reach;
        print_message("%s: %.3g of h a step below its reach, %.3g above\n", m->name, (growth(m, below) - 1.0) / below,
                      (growth(m, above) - 1.0) / above);
        assert_true(growth(m, below) < 1.0 + 1e-3 * below);
        assert_true(growth(m, above) > 1.0 + 1e-3 * above);
    }
}

static void linear_momentum(void **state)
{
    (void)state;
    for (int64_t k = 0; k < vti_multistep_count(); ++k) {
        flight f;
        double before[3], after[3];
        flight_make(&f, CHAIN_ALPHA, DEPTH);
        const vti_bodies b = chain_bodies(&f.c);
        vti_momentum(&b, before);
        fly(&f, vti_multistep_at(k), 0.01, 400);
        vti_momentum(&b, after);
        for (int c = 0; c < 3; ++c)
            assert_true(fabs(after[c] - before[c]) < 1e-13);
    }
}

static void steady_spin(void **state)
{
    (void)state;
    double alpha[3] = {0.0, 0.0, 0.0}, omega[3] = {0.3, -0.2, 0.6}, force[3] = {1.0, 2.0, 3.0}, memory[4][6] = {{0.0}};
    vti_bodies b = vti_bodies_none(1);
    vti_past past = {memory[0], 4, 4};
    b.alpha = vti_view_packed(alpha);
    b.omega = vti_view_packed(omega);
    b.force = vti_view_packed(force); /* on what does not translate, and has no mass */
    assert_int_equal(vti_multistep_record(&past, &b), VTI_OK);
    for (int k = 0; k < 100; ++k) {
        assert_int_equal(vti_multistep_predict(vti_multistep_find("an4"), 0.1, &past, &b, NULL), VTI_OK);
        assert_int_equal(vti_multistep_correct(vti_multistep_find("an4"), 0.1, &past, &b), VTI_OK);
    }
    const double theta[3] = {3.0, -2.0, 6.0};
    double exact[3];
    vti_rrv_from_rotvec(theta, exact);
    assert_true(vti_rrv_distance(alpha, exact) < 1e-12);
}

/** By two slices, each with a past of its own on the same memory, and after a copy: the bits of one flight. */
static void slices_and_copies(void **state)
{
    (void)state;
    const vti_multistep *m = vti_multistep_find("an7");
    for (int storage = CHAIN_ALPHA; storage <= CHAIN_QUAT; ++storage) {
        flight whole, parts;
        flight_make(&whole, (enum chain_storage)storage, m->depth);
        fly(&whole, m, 0.02, 40);
        flight_make(&parts, (enum chain_storage)storage, m->depth);
        fly(&parts, m, 0.02, 20);
        flight copy = parts;
        copy.past.memory = copy.memory[0][0];
        const vti_bodies b = chain_bodies(&copy.c);
        for (int k = 20; k < 40; ++k) {
            vti_past own[2] = {copy.past, copy.past};
            const vti_bodies half[2] = {vti_bodies_slice(b, 0, 1), vti_bodies_slice(b, 1, BODIES - 1)};
            for (int s = 0; s < 2; ++s)
                assert_int_equal(vti_multistep_predict(m, 0.02, &own[s], &half[s], NULL), VTI_OK);
            chain_load(&copy.c, &b);
            for (int s = 0; s < 2; ++s)
                assert_int_equal(vti_multistep_correct(m, 0.02, &own[s], &half[s]), VTI_OK);
        }
        assert_memory_equal(&copy.c, &whole.c, sizeof copy.c);
        assert_memory_equal(copy.memory, whole.memory, sizeof copy.memory[0] * BODIES * (size_t)m->depth / DEPTH);
    }
}

/** Bodies that only fly, only turn, or have no attitude: what is absent stays out, and what is there moves as with the
 *  rest. */
static void parts(void **state)
{
    (void)state;
    const vti_multistep *m = vti_multistep_find("an4");
    flight whole;
    flight_make(&whole, CHAIN_ALPHA, m->depth);
    start(&whole, m, 0.02);
    const chain at = whole.c;
    const vti_bodies b = chain_bodies(&whole.c);
    assert_int_equal(vti_multistep_predict(m, 0.02, &whole.past, &b, NULL), VTI_OK);
    for (int part = 0; part < 4; ++part) {
        flight one = whole;
        one.c = at;
        one.past.memory = one.memory[0][0];
        vti_bodies some = chain_bodies(&one.c);
        if (part == 0) /* flies */
            some.omega = some.alpha = some.moment = vti_view_none();
        if (part == 1) /* turns */
            some.v = some.x = some.force = vti_view_none();
        if (part >= 2) /* v and omega without x and attitude, and without loads */
            some.x = some.alpha = vti_view_none();
        if (part == 3)
            some.force = some.moment = vti_view_none();
        assert_int_equal(vti_multistep_predict(m, 0.02, &one.past, &some, NULL), VTI_OK);
        assert_int_equal(memcmp(one.c.v, whole.c.v, sizeof one.c.v) == 0, part != 1);
        assert_int_equal(memcmp(one.c.omega, whole.c.omega, sizeof one.c.omega) == 0, part != 0);
        assert_int_equal(memcmp(one.c.x, whole.c.x, sizeof one.c.x) == 0, part == 0);
        assert_int_equal(memcmp(one.c.alpha, whole.c.alpha, sizeof one.c.alpha) == 0, part == 1);
        assert_int_equal(vti_multistep_correct(m, 0.02, &one.past, &some), VTI_OK);
    }
}

/** A step; the larger of what is told of it and *told. */
static void corrected(flight *f, const vti_multistep *m, double h, double told[2])
{
    double most[2] = {0.0, 0.0}, now[2];
    const vti_bodies b = chain_bodies(&f->c);
    assert_int_equal(vti_multistep_predict(m, h, &f->past, &b, NULL), VTI_OK);
    chain_load(&f->c, &b);
    const chain before = f->c;
    assert_int_equal(vti_multistep_error(m, h, &f->past, &b, &now[0], &now[1]), VTI_OK);
    assert_memory_equal(&f->c, &before, sizeof before);
    assert_int_equal(vti_multistep_correct(m, h, &f->past, &b), VTI_OK);
    for (int i = 0; i < BODIES; ++i) {
        double off[2] = {0.0, 0.0};
        for (int c = 0; c < 3; ++c) {
            off[0] = hypot(off[0], f->c.v[i][c] - before.v[i][c]);
            off[1] = hypot(off[1], f->c.omega[i][c] - before.omega[i][c]);
        }
        most[0] = fmax(most[0], off[0]);
        most[1] = fmax(most[1], off[1]);
    }
    for (int part = 0; part < 2; ++part) { /* differences of numbers of order 1 */
        assert_true(fabs(now[part] - most[part]) < 4.0 * EPS);
        told[part] = fmax(told[part], now[part]);
    }
}

/** What is told before the correction is by how much v and Omega are corrected, at most; it falls as h^(K+1). */
static void estimates(void **state)
{
    (void)state;
    for (int64_t k = 0; k < vti_multistep_count(); ++k) {
        const vti_multistep *m = vti_multistep_at(k);
        double told[2][2];
        for (int level = 0; level < 2; ++level) {
            flight f;
            const double h = (m->depth < 8 ? 0.08 : 0.05) / (level + 1);
            flight_make(&f, CHAIN_QUAT, m->depth);
            start(&f, m, h);
            told[level][0] = told[level][1] = 0.0;
            for (int step = (int)m->depth - 1; step < (int)lround(2.0 / h); ++step)
                corrected(&f, m, h, told[level]);
        }
        for (int part = 0; part < 2; ++part) {
            const double order = log2(told[0][part] / told[1][part]);
            print_message("%s: %.2e, %.2e, order %.2f\n", m->name, told[0][part], told[1][part], order);
            assert_true(fabs(order - (double)m->depth - 1.0) < 1.0);
        }
    }
}

/** A past may be deeper than its method: what that tells, and does, is as of a past that ends where the method does. */
static void deep_pasts(void **state)
{
    (void)state;
    const vti_multistep *m = vti_multistep_find("an4");
    const double h = 0.02;
    flight deep, flat;
    double told[2][2];
    flight_make(&deep, CHAIN_ALPHA, DEPTH);
    start(&deep, vti_multistep_find("an10-mid"), h);
    flat = deep;
    flat.past = (vti_past){flat.memory[0][0], m->depth, m->depth};
    for (int64_t i = 0; i < BODIES; ++i)
        memcpy(flat.past.memory + 6 * m->depth * i, deep.memory[i][0], sizeof deep.memory[i][0] * (size_t)m->depth);
    deep.past.memory = deep.memory[0][0];
    flight *const both[2] = {&deep, &flat};
    for (int k = 0; k < 2; ++k) {
        const vti_bodies b = chain_bodies(&both[k]->c);
        assert_int_equal(vti_multistep_predict(m, h, &both[k]->past, &b, NULL), VTI_OK);
        chain_load(&both[k]->c, &b);
        assert_int_equal(vti_multistep_error(m, h, &both[k]->past, &b, &told[k][0], &told[k][1]), VTI_OK);
        assert_int_equal(vti_multistep_correct(m, h, &both[k]->past, &b), VTI_OK);
    }
    assert_same_bits(told[0], told[1], 2);
    assert_memory_equal(&deep.c, &flat.c, sizeof deep.c);
    for (int part = 0; part < 2; ++part) { /* and of a number that is none every body that follows is told */
        const vti_bodies b = chain_bodies(&flat.c);
        chain_load(&flat.c, &b);
        (part == 0 ? flat.c.force : flat.c.moment)[1][2] = NAN;
        assert_int_equal(vti_multistep_error(m, h, &flat.past, &b, &told[0][0], &told[0][1]), VTI_OK);
        assert_true(isnan(told[0][part]) && !isnan(told[0][1 - part]));
    }
}

static void refusals(void **state)
{
    (void)state;
    flight f;
    const vti_multistep *m = vti_multistep_find("an7");
    vti_multistep wrong[] = {*m, *m, *m, *m};
    wrong[0].depth = 0;
    wrong[1].depth = 11;
    wrong[2].c = NAN;
    wrong[3].u = INFINITY;
    flight_make(&f, CHAIN_ALPHA, DEPTH);
    const chain before = f.c;
    vti_bodies b = chain_bodies(&f.c);
    vti_fault fault;
    assert_null(vti_multistep_find("an5"));
    assert_null(vti_multistep_find(NULL));
    assert_null(vti_multistep_at(vti_multistep_count()));
    assert_null(vti_multistep_at(-1));
    assert_int_equal(vti_multistep_predict(NULL, 0.1, &f.past, &b, &fault), VTI_E_STEPPER);
    for (int k = 0; k < 4; ++k)
        assert_int_equal(vti_multistep_predict(&wrong[k], 0.1, &f.past, &b, &fault), VTI_E_STEPPER);
    assert_int_equal(vti_multistep_predict(m, 0.1, NULL, &b, &fault), VTI_E_NULL);
    assert_int_equal(vti_multistep_predict(m, 0.1, &f.past, NULL, &fault), VTI_E_NULL);
    assert_int_equal(vti_multistep_predict(m, 0.1, &f.past, &b, &fault), VTI_E_PAST);
    assert_true(fault.value == 0.0);
    f.past.known = 8;
    double told = 7.0;
    assert_int_equal(vti_multistep_correct(m, -0.1, &f.past, &b), VTI_E_TIME);
    assert_int_equal(vti_multistep_error(m, -0.1, &f.past, &b, &told, &told), VTI_E_TIME);
    assert_int_equal(vti_multistep_error(m, 0.1, &f.past, &b, NULL, &told), VTI_E_NULL);
    assert_int_equal(vti_multistep_error(m, 0.1, &f.past, &b, &told, NULL), VTI_E_NULL);
    assert_true(told == 7.0);
    assert_int_equal(vti_multistep_predict(m, NAN, &f.past, &b, &fault), VTI_E_TIME);
    vti_view *const low[] = {&b.x_low, &b.v_low, &b.alpha_low, &b.omega_low, &b.spin_low};
    static const int64_t named[] = {VTI_QUANTITY_X_LOW, VTI_QUANTITY_V_LOW, VTI_QUANTITY_ALPHA_LOW,
                                    VTI_QUANTITY_OMEGA_LOW, VTI_QUANTITY_SPIN_LOW};
    for (int k = 0; k < 5; ++k) {
        *low[k] = vti_view_packed(f.memory[0][0]);
        assert_int_equal(vti_multistep_predict(m, 0.1, &f.past, &b, &fault), VTI_E_VIEW);
        assert_int_equal(fault.quantity, named[k]);
        *low[k] = vti_view_none();
    }
    const vti_past no_past[] = {{NULL, 8, 8}, {f.memory[0][0], 0, 0}, {f.memory[0][0], 8, -1}, {f.memory[0][0], 8, 9}};
    for (int k = 0; k < 4; ++k) {
        vti_past past = no_past[k];
        assert_int_equal(vti_multistep_record(&past, &b), VTI_E_PAST);
    }
    assert_memory_equal(&f.c, &before, sizeof before);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(orders),      cmocka_unit_test(reaches),           cmocka_unit_test(linear_momentum),
        cmocka_unit_test(steady_spin), cmocka_unit_test(slices_and_copies), cmocka_unit_test(parts),
        cmocka_unit_test(estimates),   cmocka_unit_test(deep_pasts),        cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
