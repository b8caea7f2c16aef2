/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Contacts with a law of their own per pair: of the bodies' material, and of a distance at which the pair begins to
 * touch (EQUATIONS 6.6, 6.7). Forces and energies against closed forms and gradients; dashpots and friction read the
 * same law. */
#include "impact.h"

/* ---- values ------------------------------------------------------------------------------------------------------ */

enum { N = 6, PAIRS = N * (N - 1) / 2 };

static crowd c;
static double diameter[N], modulus[N], length[PAIRS];
static int64_t pair[PAIRS][2];

/** All pairs of N spheres of moduli within a ratio of 100, some of which begin to touch nearer or farther than by their
 *  diameters. */
static vti_contacts cluster(rng *g)
{
    int64_t k = 0;
    crowd_clear(&c, N, CROWD_ALPHA);
    crowd_scatter(&c, g, 0.8, 0.2);
    for (int i = 0; i < N; ++i) {
        diameter[i] = uniform(g, 0.5, 1.5);
        modulus[i] = 100 * pow(10, uniform(g, -1, 1));
        for (int j = 0; j < i; ++j, ++k) {
            pair[k][0] = i + 1;
            pair[k][1] = j + 1;
            length[k] = 0.5 * (diameter[i] + diameter[j]) * (k % 2 ? 1 : uniform(g, 0.8, 1.1));
        }
    }
    const vti_contacts contacts = {.count = PAIRS,
                                   .pair = pair[0],
                                   .base = 1,
                                   .diameter = vti_scalars_array(diameter),
                                   .modulus = vti_scalars_array(modulus),
                                   .length = vti_scalars_array(length)};
    return contacts;
}

/** d = x_i - x_j of pair k in long double; returns L - r. */
static long double overlap(int64_t k, long double d[3])
{
    const int64_t i = pair[k][0] - 1, j = pair[k][1] - 1;
    long double r = 0;
    for (int a = 0; a < 3; ++a) {
        d[a] = (long double)c.x[i][a] - c.x[j][a];
        r += d[a] * d[a];
    }
    return length[k] - sqrtl(r);
}

/** k_H = (4/3) E* sqrt(R*) */
static long double k_h(int64_t k)
{
    const int64_t i = pair[k][0] - 1, j = pair[k][1] - 1;
    const long double curvature = 2.0L / diameter[i] + 2.0L / diameter[j];
    return 4.0L / 3 / (1.0L / modulus[i] + 1.0L / modulus[j]) / sqrtl(curvature);
}

/** F = k_H delta^{3/2}, U = (2/5) k_H delta^{5/2}. Of L <= 1.7 the overlap rounds by 8 eps, and its powers by 16 eps of
 *  themselves. */
TEST(of_a_material)
{
    rng g = rng_seed(6601);
    int touching = 0;
    for (int trial = 0; trial < 400; ++trial) {
        const vti_contacts contacts = cluster(&g);
        const vti_effect effect = vti_contacts_effect(&contacts);
        const vti_bodies b = crowd_bodies(&c);
        long double force[N][3] = {{0}}, slack[N] = {0}, energy = 0, energy_slack = 0, d[3];
        double energies[1];
        assert_int_equal(vti_contacts_check(&contacts, N, NULL), VTI_OK);
        assert_int_equal(vti_apply(&effect, 1, &b), VTI_OK);
        effect.energy(effect.self, &b, energies);
        for (int64_t k = 0; k < PAIRS; ++k) {
            const long double delta = overlap(k, d), rounding = 16 * EPS, stiff = k_h(k) * powl(length[k], 2.5L);
            const int64_t ends[2] = {pair[k][0] - 1, pair[k][1] - 1};
            assert_close(vti_contacts_stiffness(&contacts, k), stiff, (double)(16 * EPS * stiff));
            if (!(delta > -rounding))
                continue;
            const long double at = fmaxl(delta, 0), f = k_h(k) * powl(at, 1.5L);
            const long double error = k_h(k) * 1.5L * sqrtl(at + rounding) * rounding + 32 * EPS * f;
            ++touching;
            energy += k_h(k) * powl(at, 2.5L) * 2 / 5;
            energy_slack += f * rounding + 32 * EPS * k_h(k) * powl(at + rounding, 2.5L);
            for (int side = 0; side < 2; ++side) {
                slack[ends[side]] += error;
                for (int a = 0; a < 3; ++a)
                    force[ends[side]][a] += (side ? -f : f) * d[a] / (length[k] - delta);
            }
        }
        assert_close(energies[0], energy, (double)(2 * energy_slack));
        for (int i = 0; i < N; ++i)
            for (int a = 0; a < 3; ++a)
                assert_close(c.force[i][a], force[i][a], (double)(2 * slack[i]));
    }
    assert_true(touching > 1000);
}

/** F = -grad U where nothing begins to touch within the difference; total momentum and angular momentum are kept. */
TEST(forces_are_minus_the_gradient)
{
    rng g = rng_seed(6602);
    for (int trial = 0; trial < 100; ++trial) {
        const double t = 1e-6;
        const vti_contacts contacts = cluster(&g);
        const vti_effect effect = vti_contacts_effect(&contacts);
        const vti_bodies b = crowd_bodies(&c);
        vti_bodies still = b;
        still.v = still.omega = vti_view_none();
        vti_apply(&effect, 1, &b);
        const crowd at = c;
        double total[3] = {0, 0, 0}, turning[3] = {0, 0, 0}, most = 0;
        for (int i = 0; i < N; ++i) {
            double moment[3];
            vti_cross(at.x[i], at.force[i], moment);
            for (int k = 0; k < 3; ++k) {
                double energy[2];
                total[k] += at.force[i][k];
                turning[k] += moment[k];
                most = fmax(most, fabs(at.force[i][k]));
                for (int side = 0; side < 2; ++side) {
                    c.x[i][k] = at.x[i][k] + (side ? t : -t);
                    energy[side] = vti_energy(&effect, 1, &still);
                }
                c.x[i][k] = at.x[i][k];
                /* U''' ~ k_H/sqrt(delta), which within t of touch is an error of k_H t^{3/2}; k_H < 1000, 5 contacts */
                assert_close(at.force[i][k], -(energy[1] - energy[0]) / (2 * t),
                             5 * 1000 * pow(t, 1.5) + 4 * EPS * fabs(energy[0]) / t);
            }
        }
        assert_close3(total, ((double[3]){0, 0, 0}), 2 * N * EPS * most);
        assert_close3(turning, ((double[3]){0, 0, 0}), 16 * N * EPS * most);
    }
}

/** Which of the two bodies is named first makes no difference. */
TEST(either_way_round)
{
    rng g = rng_seed(6603);
    double force[2][N][3];
    const vti_contacts contacts = cluster(&g);
    const vti_effect effect = vti_contacts_effect(&contacts);
    const vti_bodies b = crowd_bodies(&c);
    for (int way = 0; way < 2; ++way) {
        vti_apply(&effect, 1, &b);
        memcpy(force[way], c.force, sizeof force[way]);
        for (int64_t k = 0; k < PAIRS; ++k) {
            const int64_t first = pair[k][0];
            pair[k][0] = pair[k][1];
            pair[k][1] = first;
        }
    }
    assert_same_bits(force[0], force[1], 3 * N);
}

/* ---- beads ------------------------------------------------------------------------------------------------------- */

/** Two glass beads of 2 and 3 mm (E = 70 GPa, nu = 0.22, 2500 kg/m3) that meet at 0.2 m/s touch for 2.943 (5 m/(4
 *  k_H))^{2/5} v^{-1/5} and overlap by (5 m v^2/(4 k_H))^{2/5} (Hertz). At 2000 steps a contact its end is known to a
 *  step, and the overlap to the square of that. */
TEST(glass_beads)
{
    static impact m;
    const double glass = 70e9 / (1 - 0.22 * 0.22), pi = acos(-1), v = 0.2;
    double speed = v, deepest = 0;
    impact_clear(&m, 2, 0, 0);
    m.contacts.modulus = vti_scalars_one(&glass);
    for (int i = 0; i < 2; ++i) {
        m.diameter[i] = 2e-3 + 1e-3 * i;
        m.c.mass[i] = 2500 * pi / 6 * pow(m.diameter[i], 3);
    }
    const double mass = m.c.mass[0] * m.c.mass[1] / (m.c.mass[0] + m.c.mass[1]);
    const double stiff = 4.0 / 3 * glass / 2 * sqrt(1e-3 * 1.5e-3 / 2.5e-3), lasts = impact_duration(mass, stiff, v);
    const double h = lasts / 2000;
    m.c.x[0][1] = 2.5e-3;
    m.c.v[0][1] = -v;
    impact_add(&m, vti_contacts_effect(&m.contacts));
    assert_int_equal(vti_contacts_check(&m.contacts, 2, NULL), VTI_OK);
    for (int step = 0; step < 1999; ++step) {
        impact_go(&m, vti_stepper_find("vti2"), h, 1);
        deepest = fmax(deepest, 2.5e-3 - (m.c.x[0][1] - m.c.x[1][1]));
    }
    assert_true(m.c.force[0][1] > 0); /* they touch still, and part with the speed with which they have met */
    impact_go(&m, vti_stepper_find("vti2"), h, 4);
    assert_true(m.c.force[0][1] == 0);
    speed = m.c.v[0][1] - m.c.v[1][1];
    assert_close(speed, v, 1e-5 * v);
    assert_close(deepest, pow(1.25 * mass * v * v / stiff, 0.4), 1e-5 * deepest);
}

/* ---- what reads the same law ------------------------------------------------------------------------------------- */

enum { SLOTS = 8 };

struct collision {
    impact m;
    vti_held entries[SLOTS];
    int64_t slots[SLOTS];
    vti_history history;
    vti_sum lost[VTI_FRICTION_BOOKS];
    vti_friction friction;
    vti_dashpots dashpots;
};

/** Two spheres that are about to meet off their centres, with dashpots and friction. */
static void prepare(struct collision *s, double size)
{
    memset(s, 0, sizeof *s);
    impact_clear(&s->m, 2, 0, 0);
    s->m.diameter[0] = size;
    s->m.c.x[0][0] = 1.01;
    s->m.c.x[0][1] = 0.3;
    s->m.c.v[0][0] = -1;
    s->m.c.omega[0][2] = 2;
    s->history = (vti_history){SLOTS, 0, 0, s->entries, s->slots};
    s->friction = (vti_friction){.contacts = &s->m.contacts,
                                 .sliding = 0.3,
                                 .mindlin = 0.8,
                                 .rolling = 0.01,
                                 .rolling_stiffness = 10,
                                 .reach = INFINITY,
                                 .history = &s->history,
                                 .lost = s->lost};
    s->dashpots = (vti_dashpots){.contacts = &s->m.contacts,
                                 .friction = &s->friction,
                                 .zeta = 0.1,
                                 .ratio = 0.5,
                                 .reach = INFINITY,
                                 .lost = s->m.lost};
}

/** What becomes of it, where contacts are what the caller has made of them. */
static void collide(struct collision *s)
{
    assert_int_equal(vti_contacts_check(&s->m.contacts, 2, NULL), VTI_OK);
    impact_add(&s->m, vti_dashpots_effect(&s->dashpots));
    impact_add(&s->m, vti_contacts_effect(&s->m.contacts));
    impact_add(&s->m, vti_friction_effect(&s->friction));
    const double before = impact_ledger(&s->m);
    impact_go(&s->m, vti_stepper_find("vti2"), 1e-3, 600);
    assert_true(s->m.c.force[0][0] == 0 && s->m.c.v[0][0] - s->m.c.v[1][0] > 0.1); /* it is over */
    assert_true(vti_sum_value(&s->m.lost[0]) > 0.01 && vti_sum_value(&s->lost[0]) > 0.01);
    assert_close(impact_ledger(&s->m), before, 1e-4);
}

static void same(const struct collision *a, const struct collision *b)
{
    assert_same_bits(a->m.c.x, b->m.c.x, 6);
    assert_same_bits(a->m.c.v, b->m.c.v, 6);
    assert_same_bits(a->m.c.alpha, b->m.c.alpha, 6);
    assert_same_bits(a->m.c.omega, b->m.c.omega, 6);
    assert_same_bits(a->m.lost, b->m.lost, 8);
    assert_same_bits(a->lost, b->lost, 6);
}

/** A material is the K that follows from it: (4/3) E* sqrt(R* L^5) = (2/3) E* here. */
TEST(dashpots_and_friction_of_a_material)
{
    static struct collision one, other;
    const double moduli[2] = {4096, 8192};
    prepare(&one, 1);
    one.m.contacts.stiffness = 4.0 / 3 * (1 / (1.0 / 4096 + 1.0 / 8192)) * 0.5;
    collide(&one);
    prepare(&other, 1);
    other.m.contacts.modulus = vti_scalars_array(moduli);
    collide(&other);
    same(&one, &other);
}

/** Two spheres of diameter 1.25 that begin to touch at 1 do as two of diameter 1. */
TEST(dashpots_and_friction_of_a_length)
{
    static struct collision one, other;
    const double begins[1] = {1};
    prepare(&one, 1);
    one.m.contacts.stiffness = 2000;
    collide(&one);
    prepare(&other, 1.25);
    other.m.diameter[1] = 1.25;
    other.m.contacts.stiffness = 2000;
    other.m.contacts.length = vti_scalars_array(begins);
    collide(&other);
    same(&one, &other);
}

RUN_TESTS(cmocka_unit_test(of_a_material), cmocka_unit_test(forces_are_minus_the_gradient),
          cmocka_unit_test(either_way_round), cmocka_unit_test(glass_beads),
          cmocka_unit_test(dashpots_and_friction_of_a_material), cmocka_unit_test(dashpots_and_friction_of_a_length))
