/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Orders of convergence on a free chain of bonded spheres: attitudes, Omega, positions and velocities against GSL's
 * Prince-Dormand 8(9), whose forces are the library's at quaternions that GSL integrates. */
#include "chain.h"
#include "fit.h"
#include "march.h"

enum { NUMBERS = 13 }; /* of a body: x, v, q, Omega */

static const double t_end = 2;

static void from_numbers(const double *y, chain *c)
{
    for (int i = 0; i < c->n; ++i, y += NUMBERS) {
        memcpy(c->x[i], y, sizeof c->x[i]);
        memcpy(c->v[i], y + 3, sizeof c->v[i]);
        memcpy(c->quat[i], y + 6, sizeof c->quat[i]);
        memcpy(c->omega[i], y + 10, sizeof c->omega[i]);
    }
}

static void to_numbers(const chain *c, double *y)
{
    for (int i = 0; i < c->n; ++i, y += NUMBERS) {
        memcpy(y, c->x[i], sizeof c->x[i]);
        memcpy(y + 3, c->v[i], sizeof c->v[i]);
        memcpy(y + 6, c->quat[i], sizeof c->quat[i]);
        memcpy(y + 10, c->omega[i], sizeof c->omega[i]);
    }
}

/** x' = v, v' = F/m, q' = Omega q/2, Omega' = RM/J */
static int motion(double t, const double y[], double dydt[], void *params)
{
    (void)t;
    chain *c = params;
    from_numbers(y, c);
    const vti_bodies b = chain_bodies(c);
    chain_load(c, &b);
    for (int i = 0; i < c->n; ++i) {
        const double *q = c->quat[i], *w = c->omega[i];
        double *d = dydt + NUMBERS * i, cross[3];
        vti_cross(w, q, cross);
        for (int k = 0; k < 3; ++k) {
            d[k] = c->v[i][k];
            d[3 + k] = c->force[i][k] / c->mass[i];
            d[6 + k] = 0.5 * (q[3] * w[k] + cross[k]);
            d[10 + k] = c->moment[i][k] / c->inertia[i];
        }
        d[9] = -0.5 * vti_dot(w, q);
    }
    return GSL_SUCCESS;
}

static chain reference(const chain *start)
{
    chain c = *start;
    double y[NUMBERS * LINKS];
    c.storage = CHAIN_QUAT;
    gsl_odeiv2_system system = {motion, NULL, (size_t)(NUMBERS * c.n), &c};
    to_numbers(&c, y);
    fit_reference(&system, t_end, y);
    from_numbers(y, &c);
    return c;
}

static void shows(const vti_stepper *method, int links, enum chain_storage storage, double order, int coarsest)
{
    static const char *const quantity[] = {"attitude", "Omega", "x", "v"};
    chain start;
    chain_make(&start, links, 411, storage);
    const chain exact = reference(&start);
    int n[RUNGS];
    double e[4][RUNGS];
    for (int i = 0; i < RUNGS; ++i) {
        chain c = start;
        double all[4];
        n[i] = fit_steps(coarsest, i);
        chain_run(&c, method, t_end / n[i], n[i]);
        chain_difference(&c, &exact, all);
        for (int k = 0; k < 4; ++k)
            e[k][i] = all[k];
    }
    for (int k = 0; k < 4; ++k) {
        char what[64];
        snprintf(what, sizeof what, "%s, %d links: %s", method->name, links, quantity[k]);
        assert_order(what, n, e[k], order, 0.05 * order);
    }
}

/* As in test_order.c; the chain is stiffer. */
static const struct {
    const char *name;
    int order, coarsest;
} table[] = {
    {"vti1", 2, 32}, {"vti2", 2, 32}, {"vti3", 1, 256}, {"vti3-leapfrog", 2, 32}, {"exact", 2, 32}, {"suzuki4", 4, 16},
    {"kl6", 6, 10},  {"kl8", 8, 8},   {"srkn6", 4, 16}, {"srkn11", 6, 10},        {"srkn14", 6, 8}, {"chin4", 4, 16},
};

enum { METHODS = sizeof table / sizeof table[0] };

/** Every stepper has a row but vti1-body: bonds give moments in space, not in the body's frame. */
static void nothing_is_missed(void)
{
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        const vti_stepper *method = vti_stepper_at(k);
        int rows = method->frame == VTI_FRAME_BODY;
        for (int m = 0; m < METHODS; ++m)
            rows += strcmp(table[m].name, method->name) == 0;
        if (rows != 1)
            fail_msg("%s has %d rows", method->name, rows);
    }
}

TEST(every_stepper_shows_its_order)
{
    nothing_is_missed();
    for (int m = 0; m < METHODS; ++m)
        for (int links = 3; links <= LINKS; links += 7)
            for (int storage = 0; storage < 2; ++storage)
                shows(vti_stepper_find(table[m].name), links, (enum chain_storage)storage, table[m].order,
                      table[m].coarsest);
}

enum { STARTS = 8 };

struct problem {
    chain start, exact; /* exact: at the end */
};

/** The square of all errors after n steps. */
static double march_error(const vti_multistep *method, const void *all, int i, int n)
{
    const chain *exact = &((const struct problem *)all)[i].exact;
    chain c = ((const struct problem *)all)[i].start;
    double memory[LINKS][MARCH_DEPTH][6], e[4];
    vti_past past = {memory[0][0], method->depth, 0};
    const vti_bodies b = chain_bodies(&c);
    chain_load(&c, &b);
    march_start(method, t_end / n, &past, &b, chain_load, &c);
    march_on(method, t_end / n, n + 1 - method->depth, &past, &b, chain_load, &c);
    chain_difference(&c, exact, e);
    return e[0] * e[0] + e[1] * e[1] + e[2] * e[2] + e[3] * e[3];
}

/** AN(K, c) is of order K + 1 whatever c, and of order K where u is not 0. */
TEST(multistep_methods_show_theirs)
{
    static const struct {
        double c, u;
        int depth, coarsest;
    } rows[] = {{0.75, 0, 1, 80},     {0.75, 0, 2, 80},  {0.75, 0, 3, 160},   {0.75, 0, 4, 90},     {0.75, 0, 5, 100},
                {0.75, 0, 6, 60},     {0.75, 0, 7, 70},  {-0.75, 0, 8, 64},   {-0.75, 0, 9, 64},    {-0.75, 0, 10, 61},
                {-0.3, -0.07, 9, 80}, {-0.5, 0, 10, 62}, {0.75, -0.1, 6, 60}, {0, -3.0 / 80, 4, 90}};
    struct problem problem[STARTS];
    for (int i = 0; i < STARTS; ++i) {
        chain_make(&problem[i].start, 3, (uint64_t)(411 + i), CHAIN_QUAT);
        problem[i].exact = reference(&problem[i].start);
    }
    for (size_t r = 0; r < sizeof rows / sizeof rows[0]; ++r) {
        const vti_multistep method = {"own", rows[r].depth, rows[r].c, rows[r].u, 0.0, ""};
        assert_multistep_order(&method, rows[r].coarsest, rows[r].depth + (rows[r].u == 0.0), STARTS, march_error,
                               problem);
    }
}

RUN_TESTS(cmocka_unit_test(every_stepper_shows_its_order), cmocka_unit_test(multistep_methods_show_theirs))
