/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Bonded bodies that have turned by half a turn against each other: the moment has a kink there, the shear a pole. */
#include "hard.h"

static const double axis[3] = {0.6, -0.64, 0.48};
static web w;
static vti_effect effect;

static int bond(void **state)
{
    (void)state;
    memset(&w, 0, sizeof w);
    w.pair[0][1] = 1;
    w.rest[0][0] = w.rest[0][3] = w.moment[0] = w.axial[0] = w.shear[0] = 1;
    return 0;
}

static void terms(int mask, int form)
{
    web_terms(&w, 1, mask, form);
    effect = vti_bonds_effect(&w.bonds);
}

/** Bodies 0 and 1 at rest length, body 0 turned by the quaternion (axis, cos) against body 1. */
static void pose(crowd *c, enum crowd_storage storage, const double about[3], double cosine)
{
    crowd_clear(c, 2, storage);
    c->x[0][0] = 1;
    for (int k = 0; k < 3; ++k)
        c->quat[0][k] = about[k];
    c->quat[0][3] = cosine;
    vti_rrv_from_quat_xyzw(c->quat[0], c->alpha[0]);
}

/** T_i = -K theta axis with theta = 2 atan2(1, w) below half a turn; above it theta - 2 pi, which pulls the other
 *  way. */
TEST(moment_on_both_sides)
{
    static crowd c;
    terms(MOMENT, 0);
    for (int storage = CROWD_ALPHA; storage <= CROWD_QUAT; ++storage) {
        for (int e = 0; e <= 1075; ++e)
            for (int side = -1; side <= 1; side += 2) {
                pose(&c, (enum crowd_storage)storage, axis, ldexp(side, -e));
                const vti_bodies b = crowd_bodies(&c);
                vti_apply(&effect, 1, &b);
                const double theta = 2 * atan2(1, ldexp(1, -e)), energy = vti_energy(&effect, 1, &b);
                const int below = side > 0 || (storage == CROWD_QUAT && e == 1075); /* w = -0 is no further than 0 */
                for (int k = 0; k < 3; ++k) {
                    assert_close(c.moment[0][k], (below ? -1 : 1) * theta * axis[k], 8 * EPS * PI);
                    assert_true(c.moment[1][k] == -c.moment[0][k]);
                }
                assert_close(energy, theta * theta / 2, 8 * EPS * PI * PI);
            }
        robust("bonded bodies turned by pi and beside it by 1 to 5e-324 rad",
               storage == CROWD_ALPHA ? "binder: moment, alpha" : "binder: moment, quaternions",
               "exact: |T| = K pi, back to the nearer side, and at pi itself to where alpha (or the quaternion's axis) "
               "points from");
    }
}

/** About an axis across n0 half a turn makes b_i = -b_j: the middle has no direction, c = 0 and no loads. Beside it the
 *  moment is K/|m|, as the gradient says. */
TEST(shear_without_a_middle)
{
    static crowd c;
    const double across[3] = {0, 0, 1};
    for (int form = VTI_SHEAR_OBJECTIVE; form <= VTI_SHEAR_PRINTED; ++form) {
        const double expected = form == VTI_SHEAR_OBJECTIVE ? 1 : form == VTI_SHEAR_QUARTIC ? 0.5 : 2;
        terms(SHEAR, form);
        for (int e = 1; e <= 1075; ++e) {
            pose(&c, CROWD_QUAT, across, ldexp(1, -e));
            const vti_bodies b = crowd_bodies(&c);
            vti_apply(&effect, 1, &b);
            assert_true(all_finite(c.force[0], 3) && all_finite(c.moment[0], 3));
            /* |m| = 2 w/sqrt(1 + w^2), and |T| <= K/|m|; below eps m is made of rounding, of eps/2 or nothing */
            const double m = fmax(2 * ldexp(1, -e) / sqrt(1 + ldexp(1, -2 * e)), 0.125 * EPS);
            assert_below(vti_norm(c.moment[0]), form == VTI_SHEAR_PRINTED ? 2 : 1.01 / m);
        }
        const vti_bodies b = crowd_bodies(&c);
        assert_close(vti_energy(&effect, 1, &b), expected, 4 * EPS);
        for (int k = 0; k < 3; ++k)
            assert_true(fabs(c.force[0][k]) <= 4 * EPS && fabs(c.moment[0][k]) <= 4 * EPS);
        robust("bonded bodies turned by pi across the bond",
               form == VTI_SHEAR_OBJECTIVE ? "binder: shear, objective"
               : form == VTI_SHEAR_QUARTIC ? "binder: shear, quartic"
                                           : "binder: shear, as printed",
               form == VTI_SHEAR_PRINTED
                   ? "exact: no load at it, bounded beside it"
                   : "defined: no load at it (no middle of b_i and b_j), finite K/|b_i + b_j| beside it");
    }
}

/** Two bodies that tumble through the kink again and again: nothing is lost of J (Omega_i + Omega_j). */
static void tumble(const vti_stepper *method, double h)
{
    enum { STEPS = 20000 };
    static troupe t;
    double spin[3], total[3];
    int crossings = 0, above = 0;
    crowd_clear(&t.c, 2, CROWD_ALPHA);
    for (int i = 0; i < 3; ++i) {
        t.c.omega[0][i] = 5 * axis[i];
        t.c.omega[1][i] = i;
    }
    troupe_ready(&t, method, &effect, 1);
    vti_spin(&t.b, spin);
    vti_step_start(method, h, &t.b);
    for (int i = 0; i < STEPS; ++i) {
        assert_int_equal(troupe_step(&t, h, NULL), VTI_OK);
        const int now = vti_rrv_distance(t.c.alpha[0], t.c.alpha[1]) > 0.9 * PI;
        crossings += now && !above;
        above = now;
    }
    vti_step_sync(method, h, &t.b);
    if (method->frame == VTI_FRAME_BODY)
        for (int i = 0; i < 2; ++i)
            vti_rrv_rotate(t.c.alpha[i], t.c.omega[i], t.c.omega[i]);
    vti_spin(&t.b, total);
    assert_true(crossings > 10);
    /* each kick rounds Omega, of the size 5, by eps/2 at random; R^T Omega by more, in each of its turns */
    assert_close3(total, spin, 2 * EPS * 5 * sqrt(STEPS * (double)method->evals));
    assert_below(fabs(troupe_energy(&t)), 100);
}

/** In the body's frame too, at every h: the factor R_{k+1}^T R_k changes nothing of omega (E16). */
TEST(tumble_through_the_kink)
{
    terms(MOMENT, 0);
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        const vti_stepper *method = vti_stepper_at(k);
        tumble(method, 0.02);
        if (method->frame == VTI_FRAME_BODY) {
            tumble(method, 0.005);
            tumble(method, 0.08);
        }
        robust("bonded pair tumbling through pi", method->name, "finite; sum of J Omega exact to rounding");
    }
}

RUN_TESTS(cmocka_unit_test_setup(moment_on_both_sides, bond), cmocka_unit_test_setup(shear_without_a_middle, bond),
          cmocka_unit_test_setup(tumble_through_the_kink, bond))
