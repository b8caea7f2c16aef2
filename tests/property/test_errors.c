/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Estimates of a step's error: their weights vanish on every tree of Runge-Kutta-Nystroem theory up to the order that
 * the stepper states and not beyond; what is summed is what the definition says; it falls as h^(q+1), is not far below
 * the true error of a step, sees a NaN, and changes nothing. */
#include "chain.h"

enum { BODIES = 4, ROWS = 3, STAGES = 16, TREES = 64 };

static const char *const names[] = {"srkn6", "srkn11", "srkn14"};

enum { NAMES = sizeof names / sizeof names[0] };

/* ---- weights ----------------------------------------------------------------------------------------------------- */

/** Trees of f-nodes, by their elementary weights Phi_j at the kicks j of a stepper. */
struct trees {
    const vti_stepper *s;
    int count, order[TREES];
    long double phi[TREES][STAGES];
};

/** The time of kick j. */
static long double time_of(const vti_stepper *s, int64_t j)
{
    long double c = 0;
    for (int64_t l = 0; l < j; ++l)
        c += s->drift[l];
    return c;
}

/** sum_l a_jl Phi_l(t), a_jl = b_l (c_j - c_l) for l < j: what the kicks by the forces of a tree move before kick j. */
static long double moved(const vti_stepper *s, const long double *phi, int64_t j)
{
    long double sum = 0;
    for (int64_t l = 0; l < j; ++l)
        sum += s->kick[l] * (time_of(s, j) - time_of(s, l)) * phi[l];
    return sum;
}

/** Adds all trees of so many more orders on the given node: branches are velocities (one order), which come first, and
 *  trees numbered from least on (one order more than their own). */
static void grow(struct trees *t, const long double *node, int order, int left, int least)
{
    if (left == 0) {
        t->order[t->count] = order;
        memcpy(t->phi[t->count++], node, STAGES * sizeof *node);
        return;
    }
    long double next[STAGES] = {0};
    for (int64_t j = 0; j <= t->s->stages && least < 0; ++j)
        next[j] = node[j] * time_of(t->s, j);
    if (least < 0)
        grow(t, next, order, left - 1, -1);
    const int known = t->count;
    for (int k = least < 0 ? 0 : least; k < known; ++k)
        if (t->order[k] + 1 <= left) {
            for (int64_t j = 0; j <= t->s->stages; ++j)
                next[j] = node[j] * moved(t->s, t->phi[k], j);
            grow(t, next, order, left - 1 - t->order[k], k);
        }
}

/** All trees up to that order, smallest first. */
static void plant(struct trees *t, const vti_stepper *s, int most)
{
    memset(t, 0, sizeof *t);
    t->s = s;
    for (int order = 1; order <= most; ++order) {
        long double leaf[STAGES];
        for (int j = 0; j < STAGES; ++j)
            leaf[j] = 1;
        grow(t, leaf, order, order - 1, -1);
    }
}

TEST(weights_vanish_on_trees)
{
    static const int trees_to[] = {0, 1, 2, 4, 7, 13, 23}; /* of the special equation of second order */
    for (int m = 0; m < NAMES; ++m) {
        static struct trees t;
        const vti_stepper *s = vti_stepper_find(names[m]);
        plant(&t, s, (int)s->estimate_order + 1);
        assert_int_equal(t.count, trees_to[s->estimate_order + 1]);
        long double beyond = 0; /* the even row of srkn6 vanishes on the next trees as well */
        for (int64_t row = 0; row < s->estimates; ++row)
            for (int k = 0; k < t.count; ++k) {
                long double sum = 0;
                for (int64_t j = 0; j <= s->stages; ++j)
                    sum += s->estimate[row * (s->stages + 1) + j] * t.phi[k][j];
                if (t.order[k] <= s->estimate_order)
                    assert_close(sum, 0, 1e-15);
                else
                    beyond = fmaxl(beyond, fabsl(sum));
            }
        assert_true(beyond > 1e-6);
    }
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        const vti_stepper *s = vti_stepper_at(k);
        assert_int_equal(s->estimate != NULL, s->estimates > 0);
        assert_int_equal(s->estimate != NULL, s->estimate_order > 0);
    }
}

/* ---- a step that is watched -------------------------------------------------------------------------------------- */

struct watched {
    chain c;
    vti_bodies b;
    double memory[BODIES][ROWS][6], sums[BODIES][ROWS][6];
    vti_errors errors;
};

static void make(struct watched *w, enum chain_storage storage)
{
    memset(w, 0, sizeof *w);
    chain_make(&w->c, BODIES, 7, storage);
    w->b = chain_bodies(&w->c);
    w->errors.memory = w->memory[0][0];
    w->errors.rows = ROWS;
    memset(w->memory, 0x7f, sizeof w->memory); /* the first kick sets what the others add to */
    chain_load(&w->c, &w->b);
}

/** The same by the definition. */
static void sum_up(struct watched *w, const vti_stepper *s, int64_t k, double h)
{
    for (int i = 0; i < BODIES; ++i)
        for (int64_t row = 0; row < s->estimates; ++row)
            for (int c = 0; c < 3; ++c) {
                const double weight = h * s->estimate[row * (s->stages + 1) + k];
                w->sums[i][row][c] += weight * (w->c.force[i][c] / w->c.mass[i]);
                w->sums[i][row][3 + c] += weight * (w->c.moment[i][c] / w->c.inertia[i]);
            }
}

static void watched_step(struct watched *w, const vti_stepper *s, double h, double *velocity, double *spin)
{
    memset(w->sums, 0, sizeof w->sums);
    for (int64_t k = 0; k <= s->stages; ++k) {
        assert_int_equal(vti_step_watch(s, k, h, &w->b, &w->errors), VTI_OK);
        sum_up(w, s, k, h);
        if (k < s->stages) {
            assert_int_equal(vti_step_stage(s, k, h, &w->b, NULL), VTI_OK);
            chain_load(&w->c, &w->b);
        } else
            assert_int_equal(vti_step_finish(s, h, &w->b), VTI_OK);
    }
    assert_int_equal(vti_step_error(s, &w->b, &w->errors, velocity, spin), VTI_OK);
}

TEST(sums_are_those_of_the_definition)
{
    for (int m = 0; m < NAMES; ++m) {
        const vti_stepper *s = vti_stepper_find(names[m]);
        for (int storage = CHAIN_ALPHA; storage <= CHAIN_QUAT; ++storage) {
            struct watched w, plain;
            double velocity, spin, most[2] = {0, 0};
            make(&w, (enum chain_storage)storage);
            make(&plain, (enum chain_storage)storage);
            for (int step = 0; step < 3; ++step) {
                watched_step(&w, s, 0.05, &velocity, &spin);
                play_step(s, 0.05, &plain.b, NULL, chain_load, &plain.c);
            }
            assert_memory_equal(&w.c, &plain.c, sizeof w.c);
            for (int i = 0; i < BODIES; ++i)
                for (int part = 0; part < 2; ++part) {
                    double square = 0;
                    for (int64_t row = 0; row < s->estimates; ++row) {
                        assert_same_bits(w.memory[i][row], w.sums[i][row], 6);
                        square += vti_dot(w.sums[i][row] + 3 * part, w.sums[i][row] + 3 * part);
                    }
                    most[part] = fmax(most[part], sqrt(square));
                }
            assert_close(velocity, most[0], 0);
            assert_close(spin, most[1], 0);
        }
    }
}

/** A step of h, and one by many of a method of higher order: how far apart their velocities and spins are. */
static void true_error(const vti_stepper *s, double h, double error[2])
{
    enum { PARTS = 8 };
    struct watched one, exact;
    make(&one, CHAIN_QUAT);
    make(&exact, CHAIN_QUAT);
    play_step(s, h, &one.b, NULL, chain_load, &one.c);
    for (int k = 0; k < PARTS; ++k)
        play_step(vti_stepper_find("kl8"), h / PARTS, &exact.b, NULL, chain_load, &exact.c);
    error[0] = error[1] = 0;
    for (int i = 0; i < BODIES; ++i) {
        double v[3], w[3];
        for (int c = 0; c < 3; ++c) {
            v[c] = one.c.v[i][c] - exact.c.v[i][c];
            w[c] = one.c.omega[i][c] - exact.c.omega[i][c];
        }
        error[0] = fmax(error[0], vti_norm(v));
        error[1] = fmax(error[1], vti_norm(w));
    }
}

TEST(estimates_fall_with_their_order)
{
    for (int m = 0; m < NAMES; ++m) {
        const vti_stepper *s = vti_stepper_find(names[m]);
        double velocity[2], spin[2], error[2];
        const double h = m == 0 ? 0.1 : 0.2;
        for (int level = 0; level < 2; ++level) {
            struct watched w;
            make(&w, CHAIN_QUAT);
            watched_step(&w, s, level == 0 ? h : 0.5 * h, &velocity[level], &spin[level]);
        }
        true_error(s, h, error);
        print_message("%s at h = %g: v %.2e (truly %.2e), order %.2f; Omega %.2e (%.2e), %.2f\n", s->name, h,
                      velocity[0], error[0], log2(velocity[0] / velocity[1]), spin[0], error[1],
                      log2(spin[0] / spin[1]));
        assert_close(log2(velocity[0] / velocity[1]), (double)s->estimate_order + 1, 0.5);
        assert_close(log2(spin[0] / spin[1]), (double)s->estimate_order + 1, 0.5);
        assert_true(velocity[0] > error[0] && spin[0] > error[1]); /* the step is the better formula */
    }
}

/* ---- slices, what is absent, and refusals ------------------------------------------------------------------------ */

TEST(slices_share_the_memory)
{
    const vti_stepper *s = vti_stepper_find("srkn11");
    struct watched w;
    double velocity, spin, v, o, most[2] = {0, 0};
    make(&w, CHAIN_ALPHA);
    watched_step(&w, s, 0.1, &velocity, &spin);
    for (int i = 0; i < BODIES; ++i) {
        vti_bodies one = w.b;
        one.first = i;
        one.count = 1;
        assert_int_equal(vti_step_error(s, &one, &w.errors, &v, &o), VTI_OK);
        most[0] = fmax(most[0], v);
        most[1] = fmax(most[1], o);
    }
    assert_close(velocity, most[0], 0);
    assert_close(spin, most[1], 0);
}

TEST(bodies_without_moments)
{
    const vti_stepper *s = vti_stepper_find("srkn6");
    double v, o;
    struct watched w;
    make(&w, CHAIN_ALPHA);
    w.b.omega = w.b.moment = w.b.alpha = vti_view_none();
    for (int64_t k = 0; k <= s->stages; ++k)
        assert_int_equal(vti_step_watch(s, k, 0.1 * (double)(k + 1), &w.b, &w.errors), VTI_OK);
    assert_int_equal(vti_step_error(s, &w.b, &w.errors, &v, &o), VTI_OK);
    assert_true(v > 0 && o == 0);
    w.b.v = vti_view_none(); /* what has loads and does not move */
    w.b.mass.p = NULL;
    for (int64_t k = 0; k <= s->stages; ++k)
        assert_int_equal(vti_step_watch(s, k, 0.1, &w.b, &w.errors), VTI_OK);
    assert_int_equal(vti_step_error(s, &w.b, &w.errors, &v, &o), VTI_OK);
    assert_true(v == 0 && o == 0);
    make(&w, CHAIN_ALPHA);
    w.b.omega = vti_view_none();
    w.b.inertia.p = NULL;
    for (int64_t k = 0; k <= s->stages; ++k)
        assert_int_equal(vti_step_watch(s, k, 0.1, &w.b, &w.errors), VTI_OK);
    assert_int_equal(vti_step_error(s, &w.b, &w.errors, &v, &o), VTI_OK);
    assert_true(v > 0 && o == 0);
    w.b.x = w.b.v = w.b.force = w.b.moment = vti_view_none();
    for (int64_t k = 0; k <= s->stages; ++k)
        assert_int_equal(vti_step_watch(s, k, 0.1, &w.b, &w.errors), VTI_OK);
    assert_int_equal(vti_step_error(s, &w.b, &w.errors, &v, &o), VTI_OK);
    assert_true(v == 0 && o == 0);
}

TEST(what_is_not_a_number_shows)
{
    const vti_stepper *s = vti_stepper_find("srkn14");
    for (int i = 0; i < BODIES; i += BODIES - 1) {
        struct watched w;
        double v, o;
        make(&w, CHAIN_ALPHA);
        w.c.force[i][1] = NAN;
        assert_int_equal(vti_step_watch(s, 0, 0.1, &w.b, &w.errors), VTI_OK);
        assert_int_equal(vti_step_error(s, &w.b, &w.errors, &v, &o), VTI_OK);
        assert_true(isnan(v) && !isnan(o));
        w.c.force[i][1] = 0;
        w.c.moment[i][2] = NAN;
        assert_int_equal(vti_step_watch(s, 0, 0.1, &w.b, &w.errors), VTI_OK);
        assert_int_equal(vti_step_error(s, &w.b, &w.errors, &v, &o), VTI_OK);
        assert_true(!isnan(v) && isnan(o));
    }
}

TEST(refusals)
{
    const vti_stepper *s = vti_stepper_find("srkn11");
    struct watched w;
    double v = 7, o = 7;
    make(&w, CHAIN_ALPHA);
    vti_errors few = {w.memory[0][0], 1}, none = {NULL, ROWS};
    vti_bodies bad = w.b;
    bad.count = -1;
    const struct refusal {
        const vti_stepper *s;
        int64_t k;
        double h;
        const vti_bodies *b;
        const vti_errors *errors;
        int status;
    } all[] = {{NULL, 0, 0.1, &w.b, &w.errors, VTI_E_STEPPER},
               {vti_stepper_find("vti2"), 0, 0.1, &w.b, &w.errors, VTI_E_STEPPER},
               {s, 0, 0.1, &w.b, NULL, VTI_E_NULL},
               {s, 0, 0.1, &w.b, &none, VTI_E_NULL},
               {s, 0, 0.1, &w.b, &few, VTI_E_COUNT},
               {s, 0, 0.1, NULL, &w.errors, VTI_E_NULL},
               {s, 0, 0.1, &bad, &w.errors, VTI_E_COUNT},
               {s, -1, 0.1, &w.b, &w.errors, VTI_E_STAGE},
               {s, 12, 0.1, &w.b, &w.errors, VTI_E_STAGE},
               {s, 0, 0.0, &w.b, &w.errors, VTI_E_TIME},
               {s, 0, NAN, &w.b, &w.errors, VTI_E_TIME}};
    for (size_t i = 0; i < sizeof all / sizeof *all; ++i) {
        assert_int_equal(vti_step_watch(all[i].s, all[i].k, all[i].h, all[i].b, all[i].errors), all[i].status);
        if (i < 7)
            assert_int_equal(vti_step_error(all[i].s, all[i].b, all[i].errors, &v, &o), all[i].status);
    }
    assert_int_equal(vti_step_error(s, &w.b, &w.errors, NULL, &o), VTI_E_NULL);
    assert_int_equal(vti_step_error(s, &w.b, &w.errors, &v, NULL), VTI_E_NULL);
    assert_true(v == 7 && o == 7);
}

RUN_TESTS(cmocka_unit_test(weights_vanish_on_trees), cmocka_unit_test(sums_are_those_of_the_definition),
          cmocka_unit_test(estimates_fall_with_their_order), cmocka_unit_test(slices_share_the_memory),
          cmocka_unit_test(bodies_without_moments), cmocka_unit_test(what_is_not_a_number_shows),
          cmocka_unit_test(refusals))
