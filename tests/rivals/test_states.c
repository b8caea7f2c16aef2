/* SPDX-License-Identifier: BSD-3-Clause
 * Many states at once have the bits of each alone: integrands of the norms, energies, momenta, and panels that are read
 * in blocks. */
#include "support.h"

#include "states.h"

enum { BODIES = 3, WIDTH = 13 };

/** A state of some bodies, seen as alpha and as a quaternion: ordinary ones, and some at and near half turns. */
struct sample {
    double x[BODIES][3], v[BODIES][3], alpha[BODIES][3], omega[BODIES][3], quat[BODIES][4];
};

static void draw(rng *g, struct sample *s)
{
    for (int i = 0; i < BODIES; ++i) {
        const double size = i == 1 ? ldexp(1.0, (int)uniform(g, -40, 80)) : 1.0;
        for (int c = 0; c < 3; ++c) {
            s->x[i][c] = uniform(g, -1, 1);
            s->v[i][c] = uniform(g, -1, 1);
            s->alpha[i][c] = size * uniform(g, -3, 3);
            s->omega[i][c] = uniform(g, -1, 1);
        }
        vti_rrv_to_quat_xyzw(s->alpha[i], s->quat[i]);
    }
}

static vti_bodies seen(const struct states *s, struct sample *a, int by_quat)
{
    vti_bodies b = vti_bodies_none(s->bodies);
    const vti_quat_view quat = {{&a->quat[0][0], &a->quat[0][1], &a->quat[0][2], &a->quat[0][3]}, 4, 0};
    b.mass = s->mass;
    b.inertia = s->inertia;
    if (s->translates) {
        b.x = vti_view_packed(&a->x[0][0]);
        b.v = vti_view_packed(&a->v[0][0]);
    }
    if (s->turns) {
        if (by_quat)
            b.quat = quat;
        else
            b.alpha = vti_view_packed(&a->alpha[0][0]);
        b.omega = vti_view_packed(&a->omega[0][0]);
    }
    return b;
}

/** As the reference's states lie: attitudes as quaternions that need no length. */
static void put_quats(const struct states *s, const struct sample *a, int64_t k, double *state)
{
    const int64_t width = states_width(s);
    const int quat = s->translates ? 6 : 0;
    for (int64_t i = 0; s->turns && i < s->bodies; ++i)
        for (int c = 0; c < 4; ++c)
            state[(i * width + quat + c) * PANELS_BLOCK + k] = a->quat[i][c];
}

static void compare(rng *g, const struct states *s, int64_t n)
{
    static struct sample one[PANELS_BLOCK], other[PANELS_BLOCK];
    static double state[BODIES * WIDTH * PANELS_BLOCK], exact[BODIES * WIDTH * PANELS_BLOCK];
    double density[PANELS_BLOCK], distance[PANELS_BLOCK];
    for (int64_t k = 0; k < n; ++k) {
        draw(g, &one[k]);
        draw(g, &other[k]);
        const vti_bodies a = seen(s, &one[k], 0), b = seen(s, &other[k], 0);
        states_put(s, &a, k, state);
        states_put(s, &b, k, exact);
        put_quats(s, &other[k], k, exact);
    }
    states_densities(s, state, n, density);
    states_distances(s, state, exact, n, distance);
    for (int64_t k = 0; k < n; ++k) {
        const vti_bodies a = seen(s, &one[k], 0), b = seen(s, &other[k], 1);
        const double expected[2] = {vti_h1_density(&a), vti_h1_distance(&a, &b)}, found[2] = {density[k], distance[k]};
        assert_true(all_finite(expected, 2) && expected[0] > 0 && expected[1] > 0);
        assert_same_bits(found, expected, 2);
    }
}

TEST(integrands)
{
    rng g = rng_seed(11);
    for (int kind = 1; kind < 4; ++kind)
        for (int64_t n = 1; n <= PANELS_BLOCK; ++n) {
            const struct states s = {kind == 2 ? 1 : BODIES, kind & 1, kind >> 1, {NULL, 0, 0}, {NULL, 0, 0}};
            compare(&g, &s, n);
        }
}

/** An effect with energies of its own, whatever the bodies are. */
enum { TERMS = 3 };

static void nothing(const void *self, const vti_bodies *b)
{
    (void)self;
    (void)b;
}

static void drawn(const void *self, const vti_bodies *b, double *energies)
{
    (void)b;
    memcpy(energies, self, TERMS * sizeof *energies);
}

static void conserved(rng *g, const struct states *s, int64_t n)
{
    static struct sample one[PANELS_BLOCK];
    static double state[BODIES * WIDTH * PANELS_BLOCK], terms[TERMS][PANELS_BLOCK], each[PANELS_BLOCK][TERMS];
    double energy[PANELS_BLOCK], momentum[3][3][PANELS_BLOCK];
    for (int64_t k = 0; k < n; ++k) {
        draw(g, &one[k]);
        const vti_bodies a = seen(s, &one[k], 0);
        states_put(s, &a, k, state);
        for (int j = 0; j < TERMS; ++j)
            terms[j][k] = each[k][j] = uniform(g, -9, 9);
    }
    states_energies(s, state, terms[0], TERMS, n, energy);
    for (int which = 0; which < 3; ++which)
        states_momenta(s, (enum states_momentum)which, state, n, momentum[which][0]);
    for (int64_t k = 0; k < n; ++k) {
        const double origin[3] = {0.0, 0.0, 0.0};
        const vti_bodies a = seen(s, &one[k], 0);
        vti_effect effect = {.name = "drawn"};
        effect.energy = drawn;
        effect.apply = nothing;
        effect.self = each[k];
        effect.terms = TERMS;
        const double expected = vti_energy(&effect, 1, &a);
        double vector[3][3];
        vti_momentum(&a, vector[STATES_LINEAR]);
        vti_angular_momentum(&a, origin, vector[STATES_ANGULAR]);
        vti_spin(&a, vector[STATES_SPIN]);
        assert_true(isfinite(expected));
        assert_same_bits(&energy[k], &expected, 1);
        for (int which = 0; which < 3; ++which)
            for (int c = 0; c < 3; ++c) {
                assert_true(isfinite(vector[which][c]));
                assert_same_bits(&momentum[which][c][k], &vector[which][c], 1);
            }
    }
}

TEST(energies_and_momenta)
{
    static const double mass[BODIES] = {1.0, 0.3, 7.0}, inertia[BODIES] = {0.1, 2.0, 0.7};
    rng g = rng_seed(14);
    for (int kind = 1; kind < 4; ++kind)
        for (int64_t n = 1; n <= PANELS_BLOCK; ++n) {
            struct states s = {kind == 2 ? 1 : BODIES, kind & 1, kind >> 1, vti_scalars_array(mass),
                               vti_scalars_array(inertia)};
            if (n % 2 == 0)
                s.mass = vti_scalars_one(&mass[1]);
            conserved(&g, &s, n);
        }
}

/** A kick over all states at once; loads of those that owe none are zeros. */
TEST(kicks)
{
    static struct sample one[PANELS_BLOCK], loads[PANELS_BLOCK];
    static double numbers[BODIES * WIDTH * PANELS_BLOCK], load[BODIES * 6 * PANELS_BLOCK];
    static const double mass[BODIES] = {1.0, 0.3, 7.0}, inertia[BODIES] = {0.1, 2.0, 0.7};
    rng g = rng_seed(15);
    for (int kind = 1; kind < 4; ++kind) {
        const struct states s = {BODIES, kind & 1, kind >> 1, vti_scalars_array(mass), vti_scalars_array(inertia)};
        for (int64_t k = 0; k < PANELS_BLOCK; ++k) {
            draw(&g, &one[k]);
            draw(&g, &loads[k]);
            vti_bodies b = seen(&s, &one[k], 0);
            if (s.translates)
                b.force = vti_view_packed(&loads[k].v[0][0]);
            if (s.turns)
                b.moment = vti_view_packed(&loads[k].omega[0][0]);
            states_put(&s, &b, k, numbers);
            states_put_loads(&s, &b, k % 5 != 0, k, load);
            if (k % 5 != 0)
                assert_int_equal(vti_kick(0.3, &b), VTI_OK);
        }
        for (int64_t i = 0; i < BODIES; ++i) {
            const vti_bodies body = states_of_body(&s, i, numbers, load);
            assert_int_equal(vti_kick(0.3, &body), VTI_OK);
            for (int k = 0; k < PANELS_BLOCK; ++k)
                for (int c = 0; c < 3; ++c) {
                    if (s.translates)
                        assert_same_bits(&body.v.c[c][k], &one[k].v[i][c], 1);
                    if (s.turns)
                        assert_same_bits(&body.omega.c[c][k], &one[k].omega[i][c], 1);
                }
        }
    }
}

/** The pendulum's energy and spin about its arm, of bodies in any attitude. */
TEST(pendulums)
{
    static struct sample one[PANELS_BLOCK];
    static double numbers[BODIES * WIDTH * PANELS_BLOCK], load[BODIES * 6 * PANELS_BLOCK];
    static const double inertia[BODIES] = {0.1, 2.0, 0.7};
    const vti_pendulum pendulum = {1.7, {0.3, -0.2, 1.1}};
    const struct effect effect = {.kind = &effect_pendulum, .settings = &pendulum};
    const vti_effect made = vti_pendulum_effect(&pendulum);
    const struct states s = {BODIES, 0, 1, {NULL, 0, 0}, vti_scalars_array(inertia)};
    double energy[PANELS_BLOCK], spin[PANELS_BLOCK];
    vti_bodies body[BODIES];
    rng g = rng_seed(16);
    for (int64_t k = 0; k < PANELS_BLOCK; ++k) {
        draw(&g, &one[k]);
        const vti_bodies b = seen(&s, &one[k], 0);
        states_put(&s, &b, k, numbers);
    }
    for (int64_t i = 0; i < BODIES; ++i)
        body[i] = states_of_body(&s, i, numbers, load);
    states_sum_each(&s, &effect, body, energy);
    effect_pendulum.invariants->of_states(&effect, body, spin, PANELS_BLOCK);
    for (int64_t k = 0; k < PANELS_BLOCK; ++k) {
        const vti_bodies b = seen(&s, &one[k], 0);
        double expected, values[2];
        made.energy(&pendulum, &b, &expected);
        effect_pendulum.invariants->values(&effect, &b, values);
        assert_same_bits(&energy[k], &expected, 1);
        assert_same_bits(&spin[k], values, 1);
    }
}

/** The farthest may stand anywhere; a NaN, there or before, stays. */
TEST(farthest)
{
    double value[PANELS_BLOCK];
    rng g = rng_seed(17);
    for (int64_t n = 1; n <= PANELS_BLOCK; ++n)
        for (int64_t k = 0; k < n; ++k) {
            double most = 0.0, none = NAN, more = 20.0;
            for (int64_t i = 0; i < PANELS_BLOCK; ++i)
                value[i] = i < n ? uniform(&g, -1, 1) : 100.0;
            value[k] = k % 2 == 0 ? 9.0 : -9.0;
            states_farthest(value, 0.5, n, &most);
            states_farthest(value, 0.5, n, &none);
            states_farthest(value, 0.5, n, &more);
            assert_true(most == (k % 2 == 0 ? 8.5 : 9.5) && isnan(none) && more == 20.0);
            value[k] = INFINITY;
            states_farthest(value, 0.5, n, &more);
            assert_true(isinf(more));
            value[k] = NAN;
            states_farthest(value, 0.5, n, &most);
            assert_true(isnan(most));
        }
}

/** tau anywhere and at nodes, where the formula divides by 0. */
TEST(panels)
{
    enum { COUNT = 2, COMPONENTS = 5 };
    static double block[COMPONENTS * PANELS_BLOCK];
    struct panels p = {0};
    rng g = rng_seed(12);
    assert_int_equal(panels_create(&p, COMPONENTS, COUNT, COUNT, 1.0), 0);
    for (int k = 0; k < COUNT * PANELS_NODES * COMPONENTS; ++k)
        p.values[k] = uniform(&g, -1, 1);
    for (int64_t n = 1; n <= PANELS_BLOCK; ++n) {
        double tau[PANELS_BLOCK], one[COMPONENTS], exact;
        for (int64_t k = 0; k < PANELS_BLOCK; ++k)
            tau[k] = k % 5 == n % 5 ? p.node[k % PANELS_NODES] : uniform(&g, -1, 1);
        panels_read_block(&p, n % COUNT, tau, n, block);
        for (int k = 0; k < n; ++k) {
            panels_read(&p, n % COUNT, tau[k], one);
            for (int64_t c = 0; c < COMPONENTS; ++c) {
                exact = panels_read_one(&p, n % COUNT, tau[k], c);
                assert_same_bits(&block[c * PANELS_BLOCK + k], &one[c], 1);
                assert_same_bits(&exact, &one[c], 1);
                if (k % 5 == n % 5)
                    assert_close(one[c], panels_row(&p, n % COUNT, k % PANELS_NODES)[c], 4 * EPS);
            }
        }
    }
    panels_destroy(&p);
}

/** tau^c comes back at any tau; at the ends, beyond all nodes, too. */
TEST(powers)
{
    enum { COMPONENTS = PANELS_NODES };
    struct panels p = {0};
    rng g = rng_seed(13);
    assert_int_equal(panels_create(&p, COMPONENTS, 1, 1, 1.0), 0);
    for (int k = 0; k < PANELS_NODES; ++k)
        for (int c = 0; c < COMPONENTS; ++c)
            panels_row(&p, 0, k)[c] = pow(p.node[k], c);
    for (int trial = 0; trial < 1000; ++trial) {
        const double tau = trial < 2 ? 2.0 * trial - 1.0 : uniform(&g, -1, 1);
        double found[COMPONENTS];
        panels_read(&p, 0, tau, found);
        for (int c = 0; c < COMPONENTS; ++c)
            assert_close(found[c], pow(tau, c), 32 * EPS); /* a rounding for each of 2 x 16 factors */
    }
    panels_destroy(&p);
}

RUN_TESTS(cmocka_unit_test(integrands), cmocka_unit_test(energies_and_momenta), cmocka_unit_test(kicks),
          cmocka_unit_test(pendulums), cmocka_unit_test(farthest), cmocka_unit_test(panels), cmocka_unit_test(powers))
