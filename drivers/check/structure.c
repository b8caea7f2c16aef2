/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What the continuous motion has and a scheme may keep: momenta, reversibility, the symplectic two-form, the energy. */
#include "check.h"

#include <float.h>

/* ---- momentum -------------------------------------------------------------------------------------------------------- */

static void momenta(const struct bed *b, double p[3], double l[3])
{
    const double origin[3] = {0, 0, 0};
    const vti_bodies bodies = bed_bodies(b);
    vti_momentum(&bodies, p);
    vti_angular_momentum(&bodies, origin, l);
}

static double change(const double a[3], const double b[3])
{
    const double d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    return vti_norm(d);
}

void check_momentum(struct kit *kit)
{
    enum { STEPS = 640 };
    struct field field;
    struct bed b = scene_pair(&field);
    double p[3], l[3], p_end[3], l_end[3];
    momenta(&b, p, l);
    bed_advance(&kit->host, &b, &field, 1.0 / 64.0, STEPS);
    momenta(&b, p_end, l_end);
    const double linear = change(p_end, p), angular = change(l_end, l);
    kit_line(kit, "momentum of a bonded pair after t = 10, off by", linear, -1, 1e-11, VTI_CHECK_FAIL);
    /* methods that merely approximate it do so to their order; h = 1/64 */
    kit_line(kit, "angular momentum, off by", angular, -1, 1e-10, angular < 1e-5 ? VTI_CHECK_NOTE : VTI_CHECK_FAIL);
}

/* ---- reversibility --------------------------------------------------------------------------------------------------- */

void check_reversal(struct kit *kit)
{
    enum { STEPS = 64 };
    struct field field;
    const struct bed start = scene_pair(&field);
    struct bed b = start;
    for (int way = 0; way < 2; ++way) {
        bed_advance(&kit->host, &b, &field, 1.0 / 32.0, STEPS);
        for (int64_t k = 0; k < 3 * b.n; ++k) {
            b.v[k] = -b.v[k];
            b.w[k] = -b.w[k];
        }
    }
    const struct apart d = bed_apart(&b, &start);
    kit_line(kit, "reversibility: there and back, off by", fmax(fmax(d.x, d.v), d.attitude + d.w), -1, 1e-8,
             VTI_CHECK_NOTE);
}

/* ---- the two-form ---------------------------------------------------------------------------------------------------- */

/* A tangent vector at (R, mu), mu = J Omega, is (eta, dmu) with dR = S(eta) R; d theta(1, 2) = dmu1.eta2 - dmu2.eta1 +
 * mu.(eta1 x eta2). The map's derivative is by central differences of e, which cost e^2 and eps/e. */

static const double e = 1e-5;

static struct bed moved(const struct bed *b, int direction, double by)
{
    struct bed m = *b;
    double a[3], turn[3] = {0, 0, 0};
    if (direction >= 3) {
        m.w[direction - 3] += by;
        return m;
    }
    turn[direction] = 2.0 * tan(0.5 * by);
    bed_alpha(b, 0, a);
    vti_rrv_compose(a, turn, a);
    bed_set_alpha(&m, 0, a);
    return m;
}

static void quotient(const struct bed *plus, const struct bed *minus, double tangent[6])
{
    double a[3], b[3], r[3], theta[3];
    bed_alpha(plus, 0, a);
    bed_alpha(minus, 0, b);
    vti_rrv_relative(a, b, r);
    vti_rrv_to_rotvec(r, theta);
    for (int k = 0; k < 3; ++k) {
        tangent[k] = theta[k] / (2.0 * e);
        tangent[3 + k] = (plus->w[k] - minus->w[k]) / (2.0 * e);
    }
}

static double two_form(const double mu[3], const double s[6], const double t[6])
{
    double bracket[3];
    vti_cross(s, t, bracket);
    return vti_dot(s + 3, t) - vti_dot(t + 3, s) + vti_dot(mu, bracket);
}

/** Two large steps of the pendulum, so that methods of high order show what they are. */
void check_two_form(struct kit *kit)
{
    enum { STEPS = 2 };
    const double h = 0.5;
    struct field field;
    const struct bed start = scene_pendulum(&field);
    struct bed end = start;
    double image[6][6], most = 0.0;
    bed_advance(&kit->host, &end, &field, h, STEPS);
    int finite = bed_is_finite(&end);
    for (int k = 0; k < 6; ++k) {
        struct bed plus = moved(&start, k, e), minus = moved(&start, k, -e);
        bed_advance(&kit->host, &plus, &field, h, STEPS);
        bed_advance(&kit->host, &minus, &field, h, STEPS);
        finite = finite && bed_is_finite(&plus) && bed_is_finite(&minus);
        if (finite)
            quotient(&plus, &minus, image[k]);
    }
    for (int i = 0; i < 6 && finite; ++i)
        for (int j = 0; j < i; ++j) {
            double ei[6] = {0}, ej[6] = {0};
            ei[i] = ej[j] = 1.0;
            most = fmax(most, fabs(two_form(end.w, image[i], image[j]) - two_form(start.w, ei, ej)));
        }
    kit_line(kit, "symplecticity: two-form of the pendulum, off by", finite ? most : NAN, -1, 1e-7, VTI_CHECK_NOTE);
}

/* ---- energy ---------------------------------------------------------------------------------------------------------- */

/** Mean and largest size of E - E_0 over steps that follow the last one given, every one a run of its own: whatever a host
 *  does at a start it does once. */
static double energy_after(struct kit *kit, int64_t last, double *largest)
{
    enum { SAMPLES = 16, EVERY = 12 };
    struct field field;
    const struct bed start = scene_pendulum(&field);
    const double before = bed_energy(&start, &field);
    double sum = 0.0;
    *largest = 0.0;
    for (int k = 0; k < SAMPLES; ++k) {
        struct bed b = start;
        bed_advance(&kit->host, &b, &field, 1.0 / 16.0, last + (int64_t)k * EVERY);
        const double off = bed_energy(&b, &field) - before;
        sum += off / SAMPLES;
        *largest = fabs(off) <= *largest ? *largest : fabs(off);
    }
    return sum;
}

/** Change per unit of time of the pendulum's mean energy, against how far the energy swings at first: what swings about its
 *  start does not grow. */
void check_energy(struct kit *kit)
{
    const double h = 1.0 / 16.0;
    double early_swing, late_swing;
    const int64_t early = 1000, late = 3000;
    const double early_mean = energy_after(kit, early, &early_swing), late_mean = energy_after(kit, late, &late_swing);
    const double rate = (late_mean - early_mean) / (h * (double)(late - early));
    const double grown = late_swing / (early_swing + 1e-12);
    /* steppers of order 1 that are symplectic swing by 0.04, about the energy 0.75 */
    kit_line(kit, "energy of the pendulum: swing to t = 199 with h = 1/16", late_swing, -1, 0.15, VTI_CHECK_FAIL);
    vti_check_line *line =
        kit_line(kit, "energy of the pendulum: swing in units of that to t = 74", grown, -1, 2.0, VTI_CHECK_FAIL);
    line_say(line, "swing %.2e, mean changes by %+.1e per unit of time", late_swing, rate);
    if (line->verdict == VTI_CHECK_PASS)
        return;
    if (isfinite(late_swing) && late_swing < 1e-3) {
        line->verdict = VTI_CHECK_NOTE;
        kit_remark(kit, "not symplectic: energy %s by %.1e per unit of time on the pendulum with h = 1/16",
                   rate > 0.0 ? "grows" : "decays", fabs(rate));
    } else if (!kit->energy_known && kit->report->faults == 0)
        kit_fault(kit, "energy %s", rate < 0.0 ? "decays" : "grows");
}
