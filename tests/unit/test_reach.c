/* SPDX-License-Identifier: BSD-3-Clause
 *
 * vti_stepper.reach: a harmonic oscillator of frequency f, of a centre or of an attitude about a fixed axis, is stable
 * for all h f below it and not shortly above. The step is played; its matrix is of determinant 1, so that it is stable
 * where its trace lies between -2 and 2. */
#include "play.h"

typedef struct body {
    double x[3], v[3], force[3];
    double alpha[3], omega[3], moment[3];
} body;

static vti_bodies bodies(body *p)
{
    static const double one = 1;
    vti_bodies b = vti_bodies_none(1);
    b.x = vti_view_packed(p->x);
    b.v = vti_view_packed(p->v);
    b.force = vti_view_packed(p->force);
    b.alpha = vti_view_packed(p->alpha);
    b.omega = vti_view_packed(p->omega);
    b.moment = vti_view_packed(p->moment);
    b.mass = b.inertia = vti_scalars_one(&one);
    return b;
}

/** F = -x, RM = -theta to first order. */
static void spring(void *self, const vti_bodies *b)
{
    (void)self;
    for (int k = 0; k < 3; ++k) {
        *b->force.c[k] = -*b->x.c[k];
        *b->moment.c[k] = -*b->alpha.c[k];
    }
}

/* of the attitude: a turn so small that its square is nothing */
static const double tiny = 0x1p-40;

/** Half the traces of the step by h, of the centre and of the attitude. */
static void half_traces(const vti_stepper *method, double h, double trace[2])
{
    trace[0] = trace[1] = 0;
    for (int column = 0; column < 2; ++column) {
        body p, elsewhere;
        memset(&p, 0, sizeof p);
        memset(&elsewhere, 0, sizeof elsewhere);
        const vti_bodies b = bodies(&p);
        vti_bodies probed = bodies(&elsewhere);
        probed.force = b.force;
        probed.moment = b.moment;
        (column ? p.v : p.x)[0] = 1;
        (column ? p.omega : p.alpha)[0] = tiny;
        spring(NULL, &b);
        play_step(method, h, &b, &probed, spring, NULL);
        trace[0] += 0.5 * (column ? p.v : p.x)[0];
        trace[1] += 0.5 * (column ? p.omega : p.alpha)[0] / tiny;
    }
}

TEST(stable_below_and_not_above)
{
    enum { POINTS = 10000 };
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        const vti_stepper *method = vti_stepper_at(k);
        double trace[2], above[2] = {0, 0};
        for (int i = 1; i <= POINTS; ++i) {
            half_traces(method, method->reach * i / POINTS, trace);
            /* tens of sums of numbers up to 10 that cancel to 1 */
            for (int what = 0; what < 2; ++what)
                assert_below(fabs(trace[what]), 1 + 256 * EPS);
        }
        /* reach has six digits. Within 1e-4 of it there is what is not stable: by the cube of the distance in chin4,
         * whose trace is -2 - (z - 12)^3/432 with z = (h f)^2, and that is 2e-11 */
        for (int i = 0; i <= 100; ++i) {
            half_traces(method, method->reach * (1 + 1e-6 * i), trace);
            for (int what = 0; what < 2; ++what)
                above[what] = fmax(above[what], fabs(trace[what]) - 1);
        }
        print_message("%-14s reach %.5f, then |trace|/2 - 1 = %.1e, %.1e\n", method->name, method->reach, above[0],
                      above[1]);
        if (!(above[0] > 1e-12 && above[1] > 1e-12))
            fail_msg("%s is stable above %.6g too: its reach is larger", method->name, method->reach);
    }
}

RUN_TESTS(cmocka_unit_test(stable_below_and_not_above))
