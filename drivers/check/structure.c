/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What the continuous motion has and a scheme may keep: momenta, reversibility, the energy. (The two-form is in
 * two_form.c.) */
#include "check.h"

/* ---- momentum ---------------------------------------------------------------------------------------------------- */

static void momenta(const struct bodies *b, double p[3], double l[3])
{
    const double origin[3] = {0, 0, 0};
    const vti_bodies bodies = vti_kit_bodies_views(b);
    vti_momentum(&bodies, p);
    vti_angular_momentum(&bodies, origin, l);
}

void vti_kit_momentum(struct kit *kit)
{
    enum { STEPS = 640 };
    struct field field;
    struct bodies b = vti_kit_scene_bonded(kit, &field);
    double p[3], l[3], p_end[3], l_end[3];
    momenta(&b, p, l);
    vti_kit_host_advance(&kit->host, &b, &field, 1.0 / 64.0, STEPS);
    momenta(&b, p_end, l_end);
    const double linear = difference(p_end, p), angular = difference(l_end, l);
    vti_kit_line(kit, "momentum of a bonded pair after t = 10, off by", linear, -1, 1e-11, VTI_CHECK_FAIL);
    /* methods that merely approximate it do so to their order; h = 1/64 */
    vti_kit_line(kit, "angular momentum, off by", angular, -1, 1e-10, angular < 1e-5 ? VTI_CHECK_NOTE : VTI_CHECK_FAIL);
}

/* ---- reversibility ----------------------------------------------------------------------------------------------- */

void vti_kit_reversal(struct kit *kit)
{
    enum { STEPS = 64 };
    struct field field;
    const struct bodies start = vti_kit_scene_bonded(kit, &field);
    struct bodies b = start;
    for (int way = 0; way < 2; ++way) {
        vti_kit_host_advance(&kit->host, &b, &field, 1.0 / 32.0, STEPS);
        for (int64_t k = 0; k < 3 * b.n; ++k) {
            b.v[k] = -b.v[k];
            b.w[k] = -b.w[k];
        }
    }
    const struct apart d = vti_kit_bodies_apart(&b, &start);
    const double off = fmax(fmax(d.x, d.v), kit->rotates ? d.attitude + d.w : 0.0);
    vti_kit_line(kit, "reversibility: there and back, off by", off, -1, kit->rotates ? 1e-8 : 1e-10, VTI_CHECK_NOTE);
}

/* ---- energy ------------------------------------------------------------------------------------------------------ */

/** What swings, with an energy that a host may keep: by rotation, or by translation only. */
struct swing {
    struct bodies (*scene)(struct field *field);
    const char *name, *size, *growth;
    double most; /* steppers of order 1 that are symplectic swing by 0.04 on the pendulum, about the energy 0.75 */
};

static const struct swing pendulum = {vti_kit_scene_pendulum, "pendulum",
                                      "energy of the pendulum: swing to t = 199 with h = 1/16",
                                      "energy of the pendulum: swing in units of that to t = 74", 0.15};
static const struct swing pair = {vti_kit_scene_spring, "pair", "energy of the pair: swing to t = 199 with h = 1/16",
                                  "energy of the pair: swing in units of that to t = 74", 0.5};

/** Mean and largest size of E - E_0 over steps that follow the last one given, every one a run of its own: whatever a
 *  host does at a start it does once. */
static double energy_after(struct kit *kit, const struct swing *of, int64_t last, double *largest)
{
    enum { SAMPLES = 16, EVERY = 12 };
    struct field field;
    const struct bodies start = of->scene(&field);
    const double before = vti_kit_bodies_energy(&start, &field);
    double sum = 0.0;
    *largest = 0.0;
    for (int k = 0; k < SAMPLES; ++k) {
        struct bodies b = start;
        vti_kit_host_advance(&kit->host, &b, &field, 1.0 / 16.0, last + (int64_t)k * EVERY);
        const double off = vti_kit_bodies_energy(&b, &field) - before;
        sum += off / SAMPLES;
        *largest = larger(*largest, fabs(off));
    }
    return sum;
}

/** Change per unit of time of the mean energy, against how far the energy swings at first: what swings about its start
 *  does not grow. */
void vti_kit_energy(struct kit *kit)
{
    const struct swing *of = kit->rotates ? &pendulum : &pair;
    const double h = 1.0 / 16.0;
    double early_swing, late_swing;
    const int64_t early = 1000, late = 3000;
    const double early_mean = energy_after(kit, of, early, &early_swing);
    const double late_mean = energy_after(kit, of, late, &late_swing);
    const double rate = (late_mean - early_mean) / (h * (double)(late - early));
    const double grown = late_swing / (early_swing + 1e-12);
    vti_kit_line(kit, of->size, late_swing, -1, of->most, VTI_CHECK_FAIL);
    vti_check_line *line = vti_kit_line(kit, of->growth, grown, -1, 2.0, VTI_CHECK_FAIL);
    vti_kit_line_say(line, "swing %.2e, mean changes by %+.1e per unit of time", late_swing, rate);
    if (line->verdict == VTI_CHECK_PASS)
        return;
    if (isfinite(late_swing) && late_swing < 1e-3) {
        line->verdict = VTI_CHECK_NOTE;
        vti_kit_remark(kit, "not symplectic: energy %s by %.1e per unit of time on the %s with h = 1/16",
                       rate > 0.0 ? "grows" : "decays", fabs(rate), of->name);
    } else if (kit->report->faults == 0)
        vti_kit_fault(kit, "energy %s", rate < 0.0 ? "decays" : "grows");
}
