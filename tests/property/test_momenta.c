/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What a symmetry conserves, every stepper conserves to rounding: P and L of a free bonded chain, e3 . J Omega and R
 * rho0 . J Omega of the pendulum, for those that are exactly symplectic. chin4 keeps P; its L is as good as its
 * order. */
#include "chain.h"
#include "rig.h"

static void momenta(chain *c, double p[6])
{
    const double origin[3] = {0, 0, 0};
    const vti_bodies b = chain_bodies(c);
    vti_momentum(&b, p);
    vti_angular_momentum(&b, origin, p + 3);
}

/** The largest change of P and of L in a run to t = 10. */
static void drift_of_chain(const vti_stepper *method, int storage, double h, double off[2])
{
    chain c;
    double before[6], after[6];
    chain_make(&c, 8, 321, (enum chain_storage)storage);
    momenta(&c, before);
    chain_run(&c, method, h, lround(10 / h));
    momenta(&c, after);
    off[0] = off[1] = 0;
    for (int k = 0; k < 6; ++k)
        off[k / 3] = fmax(off[k / 3], fabs(after[k] - before[k]));
}

/** Each stage rounds 8 momenta of order 1 and 8 arms of up to 8, by eps/2 a piece, at random: sqrt(8 N stages), times
 *  8. */
static double rounding(const vti_stepper *method, double h)
{
    return 8 * EPS * sqrt(8 * 10 / h * (double)(method->stages + 1));
}

TEST(of_a_free_chain)
{
    const double h = 1.0 / 16;
    for (int64_t k = 0; k < vti_stepper_count(); ++k)
        for (int storage = 0; storage < 2; ++storage) {
            const vti_stepper *method = vti_stepper_at(k);
            double off[2];
            if (method->frame == VTI_FRAME_BODY)
                continue; /* bonds give moments in space */
            drift_of_chain(method, storage, h, off);
            print_message("%-14s P %.1e, L %.1e\n", method->name, off[0], off[1]);
            assert_below(off[0], rounding(method, h));
            if (method->symplectic)
                assert_below(off[1], rounding(method, h));
            else
                assert_true(off[1] > 100 * rounding(method, h));
        }
}

/** Sums of m v and of x x m v + J Omega, or of what each body sees of them in its own frame. */
static void sums(const chain *c, int of_bodies, double sum[6])
{
    memset(sum, 0, 6 * sizeof *sum);
    for (int i = 0; i < c->n; ++i) {
        const rotor none = {0, 0, 0, 1}, q = of_bodies ? quat_conj(chain_attitude(c, i)) : none;
        double l[3];
        vti_cross(c->x[i], c->v[i], l);
        for (int k = 0; k < 3; ++k)
            l[k] = c->mass[i] * l[k] + c->inertia[i] * c->omega[i][k];
        double v[3];
        quat_rotate(q, c->v[i], v);
        quat_rotate(q, l, l);
        for (int k = 0; k < 3; ++k) {
            sum[k] += c->mass[i] * v[k];
            sum[3 + k] += l[k];
        }
    }
}

/** The momenta that are conserved are vectors of the inertial frame, not of the bodies' frames as printed (E9). */
TEST(in_the_inertial_frame)
{
    const double h = 1.0 / 16;
    const vti_stepper *method = vti_stepper_find("vti1");
    chain c;
    double before[2][6], after[2][6];
    chain_make(&c, 2, 324, CHAIN_QUAT);
    for (int of_bodies = 0; of_bodies < 2; ++of_bodies)
        sums(&c, of_bodies, before[of_bodies]);
    chain_run(&c, method, h, lround(10 / h));
    for (int of_bodies = 0; of_bodies < 2; ++of_bodies)
        sums(&c, of_bodies, after[of_bodies]);
    for (int half = 0; half < 6; half += 3) {
        double moved[3];
        assert_close3(after[0] + half, before[0] + half, rounding(method, h));
        for (int k = 0; k < 3; ++k)
            moved[k] = after[1][half + k] - before[1][half + k];
        assert_true(vti_norm(moved) > 0.1);
    }
}

/** Forces are taken at displaced bodies and act at the others: L is kept to the order of the displacement's square,
 *  h^4. */
TEST(of_chin4)
{
    double coarse[2], fine[2];
    drift_of_chain(vti_stepper_find("chin4"), 0, 1.0 / 8, coarse);
    drift_of_chain(vti_stepper_find("chin4"), 0, 1.0 / 32, fine);
    const double order = log(coarse[1] / fine[1]) / log(4);
    print_message("chin4: L off by %.2e and %.2e, order %.2f\n", coarse[1], fine[1], order);
    assert_true(order > 3.8);
}

/** e3 . J Omega and R rho0 . J Omega, in space. */
static void pendulum_momenta(rig *p, double m[2])
{
    const vti_bodies b = rig_bodies(p);
    double arm[3], w[3];
    memcpy(w, p->omega, sizeof w);
    if (p->frame == VTI_FRAME_BODY)
        quat_rotate(rig_attitude(p), p->omega, w);
    vti_pendulum_arm(&p->pendulum, &b, 0, arm);
    m[0] = p->inertia * w[2];
    m[1] = p->inertia * vti_dot(arm, w);
}

TEST(of_the_pendulum)
{
    enum { STEPS = 500 };
    rng g = rng_seed(322);
    for (int64_t k = 0; k < vti_stepper_count(); ++k)
        for (int trial = 0; trial < 12; ++trial) {
            const vti_stepper *method = vti_stepper_at(k);
            rig p = rig_random(&g, (enum rig_storage)(trial % 3));
            double before[2], after[2];
            p.frame = (int)method->frame;
            pendulum_momenta(&p, before);
            rig_run(&p, method, 1.0 / 32, STEPS);
            pendulum_momenta(&p, after);
            /* roundings of Omega, up to 4, and of the arm, at random; chin4 keeps both too: its kicks at a displaced
             * attitude are normal to e3, but to an arm that is displaced */
            const double bound = 16 * EPS * sqrt(STEPS * (double)method->stages);
            assert_close(after[0], before[0], bound);
            if (method->symplectic)
                assert_close(after[1], before[1], bound);
            else
                assert_close(after[1], before[1], 1e-3);
        }
}

/** alpha and quaternion are two ways to write one motion. */
TEST(storage_does_not_matter)
{
    const double h = 1.0 / 16;
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        const vti_stepper *method = vti_stepper_at(k);
        chain alpha, quat;
        double off[4];
        if (method->frame == VTI_FRAME_BODY)
            continue;
        chain_make(&alpha, 6, 323, CHAIN_ALPHA);
        chain_make(&quat, 6, 323, CHAIN_QUAT);
        chain_run(&alpha, method, h, 32);
        chain_run(&quat, method, h, 32);
        chain_difference(&alpha, &quat, off);
        /* roundings of stages at random, each growing with the motion, e^(3t) at the worst to t = 2 */
        for (int i = 0; i < 4; ++i)
            assert_below(off[i], 8 * EPS * sqrt(32 * (double)method->stages) * 400);
    }
}

RUN_TESTS(cmocka_unit_test(of_a_free_chain), cmocka_unit_test(in_the_inertial_frame), cmocka_unit_test(of_chin4),
          cmocka_unit_test(of_the_pendulum), cmocka_unit_test(storage_does_not_matter))
