/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The torus over long times, h = 1e-3: test_torus_long [t]. Energy and momentum stay; with t = 500 it is looked at
 * whether the energy drifts. */
#include "torus.h"

/* samples; averages over BLOCK, from t = FROM on */
enum { STEPS = 10, PER_TIME = 1000 / STEPS, BLOCK = 20, FROM = 20 };

static const double h = 1e-3;
static int until = 35;

/* ---- the energy that the steps conserve -------------------------------------------------------------------------- */

/** F.v + T.Omega after a free drift by t. */
static double power(torus *s, double t)
{
    static crowd kept;
    const vti_bodies b = crowd_bodies(&s->c);
    double p = 0;
    kept = s->c;
    vti_drift(VTI_LAW_CAYLEY, VTI_FRAME_SPACE, t, &b, NULL);
    vti_apply(s->effects, 3, &b);
    for (int i = 0; i < RING; ++i)
        p += vti_dot(s->c.force[i], s->c.v[i]) + vti_dot(s->c.moment[i], s->c.omega[i]);
    s->c = kept;
    return p;
}

/** VTI-2 conserves E + h^2 (v V'' v/12 - |F|^2/24 - Omega^4/48) + O(h^4): the Baker-Campbell-Hausdorff series of
 *  kick, drift, kick, in which v V'' v = -dP/dt along the free motion, and the kinetic energy of a drift that turns
 *  by 2 atan(h Omega/2). This is the part with h^2. m = J = 1. */
static double correction(torus *s)
{
    const double t = 1e-5; /* the difference errs by (t omega)^2/6 = 1e-6 of itself */
    double squares = 0, fourths = 0;
    for (int i = 0; i < RING; ++i) {
        squares += vti_dot(s->c.force[i], s->c.force[i]) + vti_dot(s->c.moment[i], s->c.moment[i]);
        fourths += pow(vti_dot(s->c.omega[i], s->c.omega[i]), 2);
    }
    return h * h * ((power(s, -t) - power(s, t)) / (2 * t) / 12 - squares / 24 - fourths / 48);
}

/* ---- statistics -------------------------------------------------------------------------------------------------- */

typedef struct series {
    int n;
    double y[1000];
} series;

typedef struct line {
    double slope, error; /* and its standard error */
} line;

/** Least squares over blocks from `first`, which are 1 apart. */
static line fit(const series *s, int first)
{
    const int n = s->n - first;
    const double middle = 0.5 * (n - 1);
    double mean = 0, tt = 0, ty = 0, rest = 0;
    for (int k = 0; k < n; ++k)
        mean += s->y[first + k] / n;
    for (int k = 0; k < n; ++k) {
        tt += (k - middle) * (k - middle);
        ty += (k - middle) * (s->y[first + k] - mean);
    }
    for (int k = 0; k < n; ++k)
        rest += pow(s->y[first + k] - mean - ty / tt * (k - middle), 2);
    const line l = {ty / tt, sqrt(rest / (n - 2) / tt)};
    return l;
}

/** The correlation of neighbours in what the line leaves. */
static double correlation(const series *s)
{
    const line l = fit(s, 0);
    double mean = 0, near = 0, all = 0, last = 0;
    for (int k = 0; k < s->n; ++k)
        mean += (s->y[k] - l.slope * k) / s->n;
    for (int k = 0; k < s->n; ++k) {
        const double now = s->y[k] - l.slope * k - mean;
        near += now * last;
        all += now * now;
        last = now;
    }
    return near / all;
}

/* ---- runs -------------------------------------------------------------------------------------------------------- */

static series energy, corrected;

static void run(int form, int times)
{
    static torus s;
    double off = 0, p[2] = {0, 0}, e[2] = {0, 0};
    torus_start(&s, form);
    const vti_bodies b = crowd_bodies(&s.c);
    energy.n = corrected.n = 0;
    for (int k = 0; k < times * PER_TIME; ++k) {
        double now[3];
        crowd_steps(&s.c, vti_stepper_find("vti2"), h, STEPS, s.effects, 3);
        vti_momentum(&b, now);
        p[0] = fmax(p[0], fabs(now[1]));
        p[1] = fmax(p[1], fabs(now[2]));
        const double total = vti_energy(s.effects, 3, &b);
        if (!isfinite(total))
            fail_msg("not finite at t = %g", (k + 1) * STEPS * h);
        off = fmax(off, fabs(total - 40));
        if (k < FROM * PER_TIME)
            continue;
        e[0] += total / (BLOCK * PER_TIME);
        e[1] += (total + correction(&s)) / (BLOCK * PER_TIME);
        if ((k + 1) % (BLOCK * PER_TIME) == 0) {
            energy.y[energy.n++] = e[0];
            corrected.y[corrected.n++] = e[1];
            e[0] = e[1] = 0;
        }
    }
    print_message("form %d to t = %d: |E - 40| <= %.4g, |P_y| <= %.2g, |P_z| <= %.2g\n", form, times, off, p[0], p[1]);
    assert_true(all_finite(s.c.x[0], 3 * RING) && all_finite(s.c.alpha[0], 3 * RING));
    /* 0.1 %: the part with h^2 is at most (h omega)^2/4 = 1.4 % of an energy that is all in the fastest mode; the
     * bonds that make it have a tenth or two of the energy, half of which is potential */
    assert_below(off, 1e-3 * 40);
    /* nothing leaves the plane, and of 80 momenta of the size 0.5 and 5e5 steps the roundings are sqrt(4e7) * 0.5 *
     * eps/2 */
    assert_true(p[1] == 0);
    assert_below(p[0], 1e-12);
}

TEST(objective)
{
    run(VTI_SHEAR_OBJECTIVE, until);
}

/** Chaotic, but no less conservative. */
TEST(as_printed)
{
    run(VTI_SHEAR_PRINTED, 35);
}

/** E itself moves for as long as energy finds its way from the slow motions into the fast ones, whose share in the
 *  h^2 part is larger: by as much as that part, the other way round. What the steps conserve has no slope within the
 *  99 % interval of Student's t with 22 degrees of freedom, in blocks that are not correlated (|r| < 2.6/sqrt 24);
 *  and after t = 100, when no contacts disturb it any more (their stiffness has a kink, of which the series knows
 *  nothing), what is left of a slope is the next part of the series, (h omega)^2 of the change of this one. */
TEST(no_drift)
{
    const int n = energy.n, late = (100 - FROM) / BLOCK;
    const line raw = fit(&energy, 0), slope = fit(&corrected, 0), after = fit(&corrected, late);
    const double moved = energy.y[n - 1] - energy.y[0], explained = moved - (corrected.y[n - 1] - corrected.y[0]);
    print_message("per unit of time: E %.3g +- %.2g, corrected %.3g +- %.2g (r = %.2f), after t = 100 %.3g +- %.2g\n",
                  raw.slope / BLOCK, raw.error / BLOCK, slope.slope / BLOCK, slope.error / BLOCK,
                  correlation(&corrected), after.slope / BLOCK, after.error / BLOCK);
    print_message("E moves by %.4g from block to block, %.4g of it by its h^2 part\n", moved, explained);
    assert_int_equal(n, 24);
    assert_below(fabs(correlation(&corrected)), 2.6 / sqrt(n));
    assert_below(fabs(slope.slope), 2.819 * slope.error);
    const double omega = 2 / 8.328e-3;
    const double change = (corrected.y[n - 1] - energy.y[n - 1]) - (corrected.y[late] - energy.y[late]);
    assert_below(fabs(after.slope) * (n - late), pow(h * omega, 2) * fabs(change));
    assert_close(explained, moved, 0.1 * fabs(moved));
}

int main(int argc, char **argv)
{
    if (argc > 1)
        until = (int)strtol(argv[1], NULL, 10);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(as_printed),
        cmocka_unit_test(objective),
    };
    const struct CMUnitTest long_tests[] = {
        cmocka_unit_test(objective),
        cmocka_unit_test(no_drift),
    };
    return until < 500 ? cmocka_run_group_tests(tests, NULL, NULL) : cmocka_run_group_tests(long_tests, NULL, NULL);
}
