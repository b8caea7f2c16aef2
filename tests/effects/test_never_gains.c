/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Dissipation does not gain energy: test_never_gains [impacts clusters]. Random impacts and dense clusters with
 * dashpots and friction of all kinds, by steps of 0.25 and 0.5 of the bound, beside the same ones without either. */
#include "impact.h"

enum { SLOTS = 1024 };

static long impacts = 1800, clusters = 12;

static impact m;
static vti_held entries[SLOTS];
static int64_t slots[SLOTS];
static vti_history history;
static vti_sum rubbed[VTI_FRICTION_BOOKS];
static vti_friction friction;
static vti_dashpots dashpots;

/** Coefficients from none to strong of all that dissipates; k, a stiffness of the contact, and size, of bodies, are
 *  their scales. */
static void random_losses(rng *g, double k, double size, double inertia)
{
    const int mindlin = rng_below(g, 2);
    friction = (vti_friction){.sliding = uniform(g, 0, 1),
                              .rolling = uniform(g, 0, 0.2) * size,
                              .twisting = uniform(g, 0, 0.2) * size,
                              .rolling_stiffness = uniform(g, 0.01, 0.5) * k * size * size,
                              .twisting_stiffness = uniform(g, 0.01, 0.5) * k * size * size,
                              .reach = INFINITY,
                              .history = &history,
                              .lost = rubbed};
    friction.mindlin = mindlin ? uniform(g, 0.5, 1) : 0;
    friction.stiffness = mindlin ? 0 : uniform(g, 0.1, 1) * k;
    dashpots = (vti_dashpots){.zeta = uniform(g, 0, 1.5),
                              .ratio = uniform(g, 0, 2),
                              .rolling = uniform(g, 0, 10) * inertia,
                              .twisting = uniform(g, 0, 10) * inertia,
                              .pull = rng_below(g, 2),
                              .friction = &friction,
                              .reach = INFINITY,
                              .lost = m.lost};
}

/** Contacts and walls, and where lossy what takes their energy. */
static void act(int lossy, int walls)
{
    memset(slots, 0, sizeof slots);
    memset(rubbed, 0, sizeof rubbed);
    memset(m.lost, 0, sizeof m.lost);
    history = (vti_history){SLOTS, 0, 0, entries, slots};
    m.count = 0;
    impact_add(&m, vti_contacts_effect(&m.contacts));
    if (walls)
        impact_add(&m, vti_walls_effect(&m.walls));
    friction.contacts = dashpots.contacts = &m.contacts;
    friction.walls = dashpots.walls = walls ? &m.walls : NULL;
    if (lossy) {
        impact_add(&m, vti_friction_effect(&friction));
        impact_add(&m, vti_dashpots_effect(&dashpots));
    }
}

static double bound(double overlap)
{
    const vti_deformation at = {overlap, 0, 0};
    double scratch[CROWD_MAX];
    vti_stable stable;
    assert_int_equal(vti_stable_step(m.effects, m.count, &m.b, &at, scratch, &stable), VTI_OK);
    return stable.h;
}

/** Largest gain over the energy at the start, as a share of it, looked at every so many steps. */
static double gain(double h, int64_t steps, int64_t every)
{
    const vti_stepper *method = vti_stepper_find("vti2");
    const double before = vti_energy(m.effects, m.count, &m.b);
    double most = -1;
    for (int64_t done = 0; done < steps; done += every) {
        impact_go(&m, method, h, every);
        most = fmax(most, vti_energy(m.effects, m.count, &m.b) / before - 1);
    }
    assert_int_equal(history.missed, 0);
    return most;
}

/* ---- impacts ----------------------------------------------------------------------------------------------------- */

/** Two spheres, or one and a plane, or one and a corner of three: radii to 1:5, densities to 1:1000, any spins; they
 *  meet. Returns the speed at which they may; *length is where they touch. */
static double random_approach(rng *g, int kind, double *length)
{
    double n[3], u = 0;
    impact_clear(&m, 2, kind == 0 ? 0 : kind == 1 ? 1 : 3, 1e4);
    random_unit(g, 3, n);
    for (int i = 0; i < 2; ++i) {
        m.diameter[i] = 0.4 * pow(5, uniform(g, 0, 1));
        m.c.mass[i] = pow(1000, uniform(g, 0, 1)) * pow(m.diameter[i], 3);
        m.c.inertia[i] = uniform(g, 0.05, 0.17) * m.c.mass[i] * m.diameter[i] * m.diameter[i];
        random_vector(g, 2, m.c.v[i]);
        random_vector(g, 4 / m.diameter[i], m.c.omega[i]);
    }
    if (kind == 2)
        for (int w = 0; w < 3; ++w)
            m.plane[w][w] = 1;
    *length = kind > 0 ? 0.5 * m.diameter[0] : 0.5 * (m.diameter[0] + m.diameter[1]);
    for (int k = 0; k < 3; ++k) {
        n[k] = kind == 2 ? fabs(n[k]) / vti_norm(n) : n[k];
        m.plane[0][k] = kind == 2 ? m.plane[0][k] : n[k];
        m.c.x[1][k] = kind > 0 ? 40 * n[k] : 0; /* out of the way */
        m.c.x[0][k] = kind == 2 ? *length * uniform(g, 1, 1.1) : 1.02 * *length * n[k];
        m.c.v[1][k] = kind > 0 ? 0 : m.c.v[1][k];
        m.c.omega[1][k] = kind > 0 ? 0 : m.c.omega[1][k];
        u += (m.c.v[0][k] - m.c.v[1][k]) * n[k];
    }
    const double speed = fabs(u) + 0.1;
    for (int k = 0; k < 3; ++k)
        m.c.v[0][k] -= (u + speed) * n[k];
    return kind == 2 ? vti_norm(m.c.v[0]) : speed; /* of which one wall of a corner may get all */
}

/** After the impact there is no more energy than before, or than the same impact gains by the step alone. */
TEST(random_impacts)
{
    rng g = rng_seed(1461);
    long gaining = 0, losing = 0;
    double most = -1, bare = -1;
    for (long trial = 0; trial < impacts; ++trial) {
        const int kind = (int)(trial % 3);
        const rng start = g;
        double gains[2], h = 0, length, lasts = 0;
        for (int lossy = 1; lossy >= 0; --lossy) {
            g = start;
            const double speed = random_approach(&g, kind, &length);
            const double mass = kind > 0 ? m.c.mass[0] : 1 / (1 / m.c.mass[0] + 1 / m.c.mass[1]);
            const double overlap = pow(1.25 * mass * speed * speed / 1e4, 0.4);
            random_losses(&g, 1.5e4 / (length * length) * sqrt(overlap), 0.5 * length, m.c.inertia[0]);
            act(lossy, kind > 0);
            if (lossy) { /* of the bound with friction, which is the smaller one */
                h = (trial / 3 % 2 ? 0.25 : 0.5) * bound(overlap);
                lasts = 4 * impact_duration(mass, 1e4 / pow(length, 2.5), speed) + 0.1 * length / speed;
            }
            const int64_t steps = (int64_t)fmin(lasts / h, 1000) + 1;
            gains[lossy] = gain(h, steps, steps);
        }
        gaining += gains[1] > 0;
        losing += gains[1] < -1e-6;
        most = fmax(most, gains[1]);
        bare = fmax(bare, gains[0]);
        assert_below(gains[1], fmax(gains[0], 0) + 1e-12);
    }
    print_message("%ld impacts: at most %.1e gained, by %ld of them, %ld lose; without dissipation up to %.1e gained\n",
                  impacts, most, gaining, losing, bare);
    assert_true(losing > impacts * 9 / 10);
    assert_true(bare > 0);
}

/* ---- clusters ---------------------------------------------------------------------------------------------------- */

/** So many bodies of all sizes between six planes, pressed into each other by up to a tenth of their diameters. */
static void random_cluster(rng *g, int n)
{
    const double half = 0.42 * cbrt(n), apart = 0.8;
    impact_clear(&m, n, 6, 1e4);
    for (int w = 0; w < 6; ++w) {
        m.plane[w][w / 2] = w % 2 ? -1 : 1;
        m.plane[w][3] = -half - 0.4;
    }
    crowd_scatter(&m.c, g, half, apart);
    for (int i = 0; i < n; ++i) {
        m.diameter[i] = uniform(g, 0.7, 1);
        m.c.mass[i] = pow(100, uniform(g, 0, 1)) * pow(m.diameter[i], 3);
        m.c.inertia[i] = 0.1 * m.c.mass[i] * m.diameter[i] * m.diameter[i];
        random_vector(g, 1 / sqrt(m.c.mass[i]), m.c.v[i]);
        random_vector(g, 1 / sqrt(m.c.inertia[i]), m.c.omega[i]);
    }
}

/** At no time is there more energy than at the start, or than the same cluster gains by the step alone. */
TEST(dense_clusters)
{
    rng g = rng_seed(1462);
    double most = -1, bare = -1, least = 1;
    for (long trial = 0; trial < clusters; ++trial) {
        const int n = 8 + 4 * (int)(trial % 3);
        const rng start = g;
        double gains[2], h = 0;
        for (int lossy = 1; lossy >= 0; --lossy) {
            g = start;
            random_cluster(&g, n);
            random_losses(&g, 1e4, 0.5, 0.1);
            act(lossy, 1);
            if (lossy)
                h = (trial % 2 ? 0.25 : 0.5) * bound(0.25);
            const double before = vti_energy(m.effects, m.count, &m.b);
            gains[lossy] = gain(h, 240, 8);
            if (lossy)
                least = fmin(least, vti_energy(m.effects, m.count, &m.b) / before);
        }
        most = fmax(most, gains[1]);
        bare = fmax(bare, gains[0]);
        assert_below(gains[1], fmax(gains[0], 0) + 1e-12);
    }
    print_message("%ld clusters: at most %.1e gained, down to %.1e left; without dissipation up to %.1e gained\n",
                  clusters, most, least, bare);
    assert_below(least, 0.9);
}

int main(int argc, char **argv)
{
    if (argc > 2) {
        impacts = strtol(argv[1], NULL, 10);
        clusters = strtol(argv[2], NULL, 10);
    }
    const struct CMUnitTest tests[] = {cmocka_unit_test(random_impacts), cmocka_unit_test(dense_clusters)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
