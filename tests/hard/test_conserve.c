/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Energy over very many steps of the paper's pendulum: test_conserve [evaluations]. A straight line through the
 * averages of blocks has no slope but what chance gives it. Steppers of more stages play fewer steps, so that all cost
 * alike. */
#include "rig.h"

#include "hard.h"

enum { BLOCKS = 40, EVERY = 16 };

static long evaluations = 1000000;

typedef struct line {
    double slope, error; /* per block, and its standard error */
} line;

static line fit(const double *y)
{
    const double middle = 0.5 * (BLOCKS - 1);
    double mean = 0, tt = 0, ty = 0, rest = 0;
    for (int k = 0; k < BLOCKS; ++k)
        mean += y[k] / BLOCKS;
    for (int k = 0; k < BLOCKS; ++k) {
        tt += (k - middle) * (k - middle);
        ty += (k - middle) * (y[k] - mean);
    }
    for (int k = 0; k < BLOCKS; ++k)
        rest += pow(y[k] - mean - ty / tt * (k - middle), 2);
    const line l = {ty / tt, sqrt(rest / (BLOCKS - 2) / tt)};
    return l;
}

/** Averages of E - E_0 over blocks of the run. */
static long blocks(const vti_stepper *method, double h, double *y)
{
    rig p = rig_of_the_paper(RIG_ALPHA);
    const vti_bodies b = rig_bodies(&p);
    p.frame = (int)method->frame;
    if (p.frame == VTI_FRAME_BODY)
        vti_rrv_rotate_back(p.alpha, p.omega, p.omega);
    const double start = rig_energy(&p);
    const long samples = evaluations / (long)method->evals / EVERY / BLOCKS;
    rig_moment(&p);
    vti_step_start(method, h, &b);
    for (int k = 0; k < BLOCKS; ++k) {
        vti_sum sum = {0, 0};
        for (long i = 0; i < samples; ++i) {
            rig_steps(&p, method, h, EVERY);
            rig read = p;
            const vti_bodies copy = rig_bodies(&read);
            vti_step_sync(method, h, &copy);
            vti_sum_add(&sum, rig_energy(&read) - start);
        }
        y[k] = vti_sum_value(&sum) / (double)samples;
    }
    return samples * BLOCKS * EVERY;
}

/** Independent blocks: 3.3 standard errors of the slope, the 99.8 % interval of Student's t with 38 degrees of freedom.
 *  Roundings walk, and blocks of a walk are not independent: its line over N steps rises by sqrt(6/5) of its standard
 *  deviation, which is 0.6 eps sqrt(N evals) of an energy of the size 1 to 2; three times that. */
TEST(energy_has_no_drift)
{
    const double h = 1.0 / 64;
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        const vti_stepper *method = vti_stepper_at(k);
        double y[BLOCKS];
        const long steps = blocks(method, h, y);
        const line l = fit(y);
        const double walk = 3 * sqrt(1.2) * 0.6 * 2 * EPS * sqrt((double)(steps * method->evals));
        print_message("%-14s %ld steps: E rises by %.1e, standard error %.1e, roundings may %.1e\n", method->name,
                      steps, BLOCKS * l.slope, BLOCKS * l.error, walk);
        assert_below(BLOCKS * fabs(l.slope), BLOCKS * 3.3 * l.error + walk);
        robust("energy of the pendulum, 1e6 evaluations (1e8 in the long test)", method->name,
               "bounded, no drift: the slope is within its interval of 0");
    }
}

int main(int argc, char **argv)
{
    if (argc > 1)
        evaluations = strtol(argv[1], NULL, 10);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(energy_has_no_drift),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
