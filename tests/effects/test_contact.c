/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Contact of spheres with each other and with walls, and gravity: values, gradients, and what must not act. */
#include "crowd.h"

/* ---- values ------------------------------------------------------------------------------------------------------ */

/** 2/5 K o^{5/2} and (K/D) o^{3/2} with o = [1 - gap/D]_+ in long double. */
static void hertz(double stiffness, long double length, long double gap, long double *energy, long double *force)
{
    const long double o = gap < length ? (length - gap) / length : 0;
    *energy = stiffness * powl(o, 2.5L) * 2 / 5;
    *force = stiffness * powl(o, 1.5L) / length;
}

/** The overlap rounds by 4 eps of (gap/D + o), and the force and the energy by 4 eps more of themselves; their
 *  derivatives by o are 3/2 K/D o^{1/2} and K o^{3/2}. */
static double force_tolerance(double stiffness, long double length, long double o, long double rounding)
{
    return (double)(stiffness / length * (1.5L * sqrtl(o + rounding) * rounding + 4 * EPS * powl(o, 1.5L)));
}

static double energy_tolerance(double stiffness, long double o, long double rounding)
{
    return (double)(stiffness * (powl(o + rounding, 1.5L) * rounding + 4 * EPS * powl(o, 2.5L)));
}

TEST(pairs_have_their_values)
{
    rng g = rng_seed(3051);
    int touching = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        crowd c;
        double diameter[2], d[3], energy;
        long double u, f, r = 0;
        const int base = trial & 1;
        const int64_t pair[2] = {base, base + 1};
        crowd_clear(&c, 2, CROWD_ALPHA);
        random_vector(&g, 1, c.x[1]);
        random_unit(&g, 3, d);
        for (int i = 0; i < 2; ++i)
            diameter[i] = uniform(&g, 0.1, 2);
        const long double length = ((long double)diameter[0] + diameter[1]) / 2;
        const double gap = trial % 3 ? uniform(&g, 0, 1.2) : 1 - pow(10, uniform(&g, -15, 0));
        for (int k = 0; k < 3; ++k) {
            c.x[0][k] = c.x[1][k] + (double)length * gap * d[k];
            r += powl((long double)c.x[0][k] - c.x[1][k], 2);
        }
        r = sqrtl(r);
        const vti_contacts contacts = {.count = 1,
                                       .pair = pair,
                                       .base = base,
                                       .diameter = vti_scalars_array(diameter),
                                       .stiffness = uniform(&g, 1, 3000)};
        const vti_effect effect = vti_contacts_effect(&contacts);
        const vti_bodies b = crowd_bodies(&c);
        vti_apply(&effect, 1, &b);
        effect.energy(effect.self, &b, &energy);
        hertz(contacts.stiffness, length, r, &u, &f);
        const long double o = fmaxl(0, 1 - r / length), rounding = 4 * EPS * (r / length + o);
        touching += o > 0;
        assert_close(energy, u, energy_tolerance(contacts.stiffness, o, rounding));
        for (int k = 0; k < 3; ++k) {
            const long double n = ((long double)c.x[0][k] - c.x[1][k]) / r;
            assert_close(c.force[0][k], f * n, force_tolerance(contacts.stiffness, length, o, rounding));
            assert_true(c.force[0][k] == -c.force[1][k] && c.moment[0][k] == 0 && c.moment[1][k] == 0);
        }
    }
    assert_true(touching > 12000 && touching < 20000);
}

/** Any number of oblique planes, any slice; bodies on either side of them. */
TEST(walls_have_their_values)
{
    rng g = rng_seed(3052);
    for (int trial = 0; trial < 3000; ++trial) {
        crowd c;
        double plane[7][4], diameter[6], energy, slack = 0;
        long double total = 0, sums[6][3] = {{0}}, slacks[6] = {0};
        crowd_clear(&c, 6, CROWD_ALPHA);
        vti_walls walls = {.count = trial % 8,
                           .plane = plane[0],
                           .diameter = vti_scalars_array(diameter),
                           .stiffness = uniform(&g, 1, 3000)};
        for (int64_t k = 0; k < walls.count; ++k) {
            random_unit(&g, 3, plane[k]);
            plane[k][3] = uniform(&g, -0.5, 0.5);
        }
        const int first = rng_below(&g, 4), count = 1 + rng_below(&g, 3);
        for (int i = 0; i < 6; ++i) {
            random_vector(&g, 1, c.x[i]);
            diameter[i] = uniform(&g, 0.3, 2);
            for (int64_t k = 0; k < walls.count && i >= first && i < first + count; ++k) {
                long double u, f, gap = -(long double)plane[k][3], radius = diameter[i] / 2;
                for (int a = 0; a < 3; ++a)
                    gap += (long double)plane[k][a] * c.x[i][a];
                hertz(walls.stiffness, radius, gap, &u, &f);
                const long double o = fmaxl(0, 1 - gap / radius), rounding = 4 * EPS * (2.5L / radius + o);
                total += u;
                slack += energy_tolerance(walls.stiffness, o, rounding);
                slacks[i] += force_tolerance(walls.stiffness, radius, o, rounding);
                for (int a = 0; a < 3; ++a)
                    sums[i][a] += f * plane[k][a];
            }
        }
        const vti_effect effect = vti_walls_effect(&walls);
        const vti_bodies b = vti_bodies_slice(crowd_bodies(&c), first, count);
        vti_apply(&effect, 1, &b);
        effect.energy(effect.self, &b, &energy);
        assert_close(energy, total, slack + 8 * EPS * total);
        for (int i = 0; i < 6; ++i)
            for (int a = 0; a < 3; ++a) {
                assert_close(c.force[i][a], sums[i][a], 2 * slacks[i]); /* their sum rounds as much again */
                assert_true(c.moment[i][a] == 0);
            }
    }
}

/** o = 1/4: U = K/80, |F| = K/(8 D). With a wall D/2 is the length, so that the force of the same overlap is twice as
 *  large. Weight is m g. Powers of two throughout, so that all is exact but 0.4. */
TEST(exact_values)
{
    crowd c;
    const int64_t pair[2] = {0, 1};
    const double diameter[2] = {3, 1}, plane[4] = {0, 0, 1, -1};
    double energy;
    crowd_clear(&c, 2, CROWD_ALPHA);
    const vti_bodies b = crowd_bodies(&c);
    const vti_contacts contacts = {.count = 1, .pair = pair, .diameter = vti_scalars_array(diameter), .stiffness = 64};
    const vti_effect contact = vti_contacts_effect(&contacts);
    c.x[0][1] = 1.5; /* of D = 2 */
    vti_apply(&contact, 1, &b);
    contact.energy(contact.self, &b, &energy);
    assert_close(energy, 0.8, EPS);
    assert_true(c.force[0][1] == 4 && c.force[1][1] == -4 && c.force[0][0] == 0 && c.force[0][2] == 0);

    const vti_walls walls = {.count = 1, .plane = plane, .diameter = vti_scalars_array(diameter + 1), .stiffness = 64};
    const vti_effect wall = vti_walls_effect(&walls);
    const vti_bodies second = vti_bodies_slice(b, 0, 1);
    c.x[0][2] = -1 + 0.375; /* of D/2 = 1/2 */
    vti_apply(&wall, 1, &second);
    wall.energy(wall.self, &second, &energy);
    assert_close(energy, 0.8, EPS);
    assert_true(c.force[0][2] == 16 && c.force[0][0] == 0 && c.force[0][1] == 0);

    const vti_gravity gravity = {{0.5, -1, 2}};
    const vti_effect weight = vti_gravity_effect(&gravity);
    c.mass[1] = 4;
    c.x[1][0] = 3, c.x[1][1] = 0.5, c.x[1][2] = -2;
    const vti_bodies last = vti_bodies_slice(b, 1, 1);
    vti_apply(&weight, 1, &last);
    weight.energy(weight.self, &last, &energy);
    assert_true(c.force[1][0] == 2 && c.force[1][1] == -4 && c.force[1][2] == 8 && energy == 12);
}

/* ---- nothing where nothing touches ------------------------------------------------------------------------------- */

/** At exact touch and beyond there is neither force nor energy; coincident centres have energy but no direction. */
TEST(touch_and_coincidence)
{
    const int64_t pair[2] = {1, 0};
    const double diameter[2] = {0.75, 1.25}, plane[4] = {0, 1, 0, 0}, at[4] = {1, nextafter(1, 2), 1.5, 0};
    for (int k = 0; k < 4; ++k) {
        crowd c;
        double energies[2];
        crowd_clear(&c, 2, CROWD_ALPHA);
        c.x[0][1] = at[k] / 2;
        c.x[1][1] = -at[k] / 2;
        const vti_contacts contacts = {
            .count = 1, .pair = pair, .diameter = vti_scalars_array(diameter), .stiffness = 10};
        const double radius_one = 1; /* diameter of a body that touches at y = 1/2 */
        const vti_walls walls = {.count = 1, .plane = plane, .diameter = vti_scalars_one(&radius_one), .stiffness = 10};
        const vti_effect effects[2] = {vti_contacts_effect(&contacts), vti_walls_effect(&walls)};
        const vti_bodies b = crowd_bodies(&c), upper = vti_bodies_slice(b, 0, 1);
        vti_apply(effects, 1, &b);
        effects[0].energy(effects[0].self, &b, energies);
        for (int a = 0; a < 3; ++a)
            assert_true(c.force[0][a] == 0 && c.force[1][a] == 0);
        assert_close(energies[0], k < 3 ? 0 : 4, 4 * EPS); /* 2/5 K where the centres coincide */
        if (k == 3)
            continue;
        vti_apply(effects + 1, 1, &upper);
        effects[1].energy(effects[1].self, &upper, energies + 1);
        assert_true(c.force[0][0] == 0 && c.force[0][1] == 0 && c.force[0][2] == 0 && energies[1] == 0);
    }
}

/* ---- gradients --------------------------------------------------------------------------------------------------- */

/** All three effects at once on a crowd that overlaps, against central differences of the sum of their energies. */
TEST(forces_are_minus_the_gradient)
{
    rng g = rng_seed(3053);
    for (int trial = 0; trial < 300; ++trial) {
        enum { N = 5, PAIRS = N * (N - 1) / 2 };
        crowd c;
        int64_t pair[PAIRS][2], count = 0;
        double diameter[N], plane[3][4];
        crowd_clear(&c, N, CROWD_ALPHA);
        crowd_scatter(&c, &g, 0.6, 0.3);
        for (int i = 0; i < N; ++i) {
            diameter[i] = uniform(&g, 0.5, 1.5);
            c.mass[i] = uniform(&g, 0.1, 10);
            for (int j = 0; j < i; ++j, ++count) {
                pair[count][0] = i + 1;
                pair[count][1] = j + 1;
            }
        }
        for (int k = 0; k < 3; ++k) {
            random_unit(&g, 3, plane[k]);
            plane[k][3] = uniform(&g, -0.5, 0);
        }
        vti_gravity gravity;
        random_vector(&g, 5, gravity.g);
        const vti_contacts contacts = {.count = PAIRS,
                                       .pair = pair[0],
                                       .base = 1,
                                       .diameter = vti_scalars_array(diameter),
                                       .stiffness = uniform(&g, 1, 20)};
        const vti_walls walls = {
            .count = 3, .plane = plane[0], .diameter = vti_scalars_array(diameter), .stiffness = uniform(&g, 1, 20)};
        const vti_effect all[3] = {vti_contacts_effect(&contacts), vti_walls_effect(&walls),
                                   vti_gravity_effect(&gravity)};
        const vti_bodies b = crowd_bodies(&c);
        vti_apply(all, 3, &b);
        const crowd at = c;
        vti_bodies still = b;
        still.v = still.omega = vti_view_none();
        for (int i = 0; i < N; ++i)
            for (int k = 0; k < 3; ++k) {
                /* U'' of a contact jumps in its slope at touch, U''' ~ o^{-1/2}: within t of touch the difference
                 * errs by K/D (t/D)^{3/2}, elsewhere by less. At most 7 contacts act on a body, K <= 20, D >= 1/2
                 * (pairs) and 1/4 (walls). Energies up to 4000 round by 4 eps. */
                const double t = 1e-6;
                double energy[2];
                for (int side = 0; side < 2; ++side) {
                    c.x[i][k] = at.x[i][k] + (side ? t : -t);
                    energy[side] = vti_energy(all, 3, &still);
                }
                c.x[i][k] = at.x[i][k];
                const double error = (4 * 20 / 0.5 * pow(t / 0.5, 1.5) + 3 * 20 / 0.25 * pow(t / 0.25, 1.5));
                assert_close(at.force[i][k], -(energy[1] - energy[0]) / (2 * t), error + 4 * EPS * fabs(energy[0]) / t);
            }
    }
}

RUN_TESTS(cmocka_unit_test(pairs_have_their_values), cmocka_unit_test(walls_have_their_values),
          cmocka_unit_test(exact_values), cmocka_unit_test(touch_and_coincidence),
          cmocka_unit_test(forces_are_minus_the_gradient))
