/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Variable steps without drift: with the integrating controller a reversible stepper goes back the way it came, and the
 * energy of a pendulum stays where it is; with steps that follow the same wish from state to state it does not. */
#include "rig.h"

/* ---- the wish of a pendulum -------------------------------------------------------------------------------------- */

/** s = (1/2 + |Omega|^2)^(-1/2). */
static double wish(const rig *p)
{
    return 1.0 / sqrt(0.5 + vti_dot(p->omega, p->omega));
}

/** G = -(1/s) ds/dt = Omega.(RM/J)/(1/2 + |Omega|^2). */
static double rate(const rig *p)
{
    return vti_dot(p->omega, p->moment) / p->inertia / (0.5 + vti_dot(p->omega, p->omega));
}

struct journey {
    double energy;  /* the largest |E - E_0| of the way */
    double half[2]; /* the mean of E - E_0 of its two halves */
    double shortest, longest, t;
};

/** So many steps of about epsilon s: by a density, or as the state says. */
static struct journey travel(rig *p, const char *name, double epsilon, int64_t steps, int naive)
{
    const vti_stepper *method = vti_stepper_find(name);
    const vti_bodies b = rig_bodies(p);
    struct journey j = {.shortest = INFINITY};
    vti_density density;
    rig_moment(p);
    const double start = rig_energy(p);
    assert_int_equal(vti_density_start(epsilon, wish(p), rate(p), &density), VTI_OK);
    for (int64_t k = 0; k < steps; ++k) {
        const double h = naive ? epsilon * wish(p) : density.h;
        play_step(method, h, &b, NULL, rig_load, p);
        if (!naive)
            assert_int_equal(vti_density_next(&density, rate(p)), VTI_OK);
        const double off = rig_energy(p) - start;
        j.energy = fmax(j.energy, fabs(off));
        j.half[2 * k >= steps] += 2 * off / (double)steps;
        j.shortest = fmin(j.shortest, h);
        j.longest = fmax(j.longest, h);
        j.t += h;
    }
    return j;
}

/* ---- tests ------------------------------------------------------------------------------------------------------- */

TEST(equation)
{
    vti_density d;
    assert_int_equal(vti_density_start(0.5, 0.25, 8, &d), VTI_OK);
    assert_close(d.rho, 6, 0); /* 1/s + epsilon G/2 */
    assert_close(d.h, 0.5 / 6, 0);
    assert_int_equal(vti_density_next(&d, -4), VTI_OK);
    assert_close(d.rho, 4, 0);
    assert_close(d.h, 0.125, 0);
    const vti_density before = d;
    assert_int_equal(vti_density_next(&d, -8), VTI_E_TIME); /* rho = 0 */
    assert_int_equal(vti_density_next(&d, -9), VTI_E_TIME);
    assert_int_equal(vti_density_next(&d, NAN), VTI_E_TIME);
    assert_int_equal(vti_density_next(NULL, 1), VTI_E_NULL);
    assert_int_equal(vti_density_start(0.5, 0.25, 8, NULL), VTI_E_NULL);
    assert_int_equal(vti_density_start(0, 0.25, 8, &d), VTI_E_TIME);
    assert_int_equal(vti_density_start(0.5, -1, 8, &d), VTI_E_TIME);
    assert_int_equal(vti_density_start(0.5, 0.25, -16, &d), VTI_E_TIME);
    assert_memory_equal(&d, &before, sizeof d);
}

/** Forward, all velocities turned round, the same density: back at the start. Steps that follow the state are not. */
TEST(back_the_way_it_came)
{
    const vti_stepper *method = vti_stepper_find("srkn11");
    for (int naive = 0; naive < 2; ++naive) {
        rig p = rig_of_the_paper(RIG_QUAT);
        const rig start = p;
        const vti_bodies b = rig_bodies(&p);
        vti_density d;
        enum { STEPS = 200 };
        const double epsilon = 0.5;
        rig_moment(&p);
        assert_int_equal(vti_density_start(epsilon, wish(&p), rate(&p), &d), VTI_OK);
        for (int way = 0; way < 2; ++way) {
            for (int k = 0; k < STEPS; ++k) {
                play_step(method, naive ? epsilon * wish(&p) : d.h, &b, NULL, rig_load, &p);
                if (!naive && k < STEPS - 1) /* the step that ends here is the first of the way back */
                    assert_int_equal(vti_density_next(&d, rate(&p)), VTI_OK);
            }
            for (int c = 0; c < 3; ++c)
                p.omega[c] = -p.omega[c];
        }
        const double off = rig_difference(&p, &start);
        if (naive)
            assert_true(off > 1e-9);
        else
            assert_close(off, 0, 1e-11); /* 400 steps of eleven stages, rounding, and the growth of differences */
    }
}

/** The energy on the pendulum: the two halves of the way have the same mean, far inside the largest deviation. The
 *  naive one is further off at the end than all that. */
static void no_drift(const char *name, double epsilon, int64_t steps)
{
    rig p = rig_of_the_paper(RIG_QUAT), q = p;
    const struct journey good = travel(&p, name, epsilon, steps, 0), naive = travel(&q, name, epsilon, steps, 1);
    print_message(
        "%s, %lld steps of %.3g to %.3g (t = %.3g): |E - E_0| at most %.2e, means of its halves %.3e and %.3e; "
        "naive: %.2e, %.3e and %.3e\n",
        name, (long long)steps, good.shortest, good.longest, good.t, good.energy, good.half[0], good.half[1],
        naive.energy, naive.half[0], naive.half[1]);
    assert_true(good.longest > 1.5 * good.shortest); /* steps do vary */
    assert_true(fabs(good.half[1] - good.half[0]) < 0.01 * good.energy);
    assert_true(fabs(naive.half[1] - naive.half[0]) > 0.3 * naive.energy);
    assert_true(naive.energy > 10 * good.energy);
}

TEST(no_drift_of_energy)
{
    const char *asked = getenv("VTI_TEST_STEPS");
    const int64_t steps = asked != NULL ? atoll(asked) : 20000;
    no_drift("srkn6", 0.5, steps);
    no_drift("srkn11", 0.5, steps);
}

RUN_TESTS(cmocka_unit_test(equation), cmocka_unit_test(back_the_way_it_came), cmocka_unit_test(no_drift_of_energy))
