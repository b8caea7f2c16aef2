/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Energies, momenta and the integrands of the norms (EQUATIONS 4). All sums are compensated: what they show of a
 * conservation law is the integrator's rounding, not their own. */
#include "vti_moments.h"
#include "vti_ready.h"

/** Whether r can be measured. If the bodies are refused, or needed is NULL, r is set to NaN. */
static int can_measure(const vti_bodies *b, const void *needed, double r[3])
{
    if (r == NULL)
        return 0;
    if (needed != NULL && vti_bodies_ready(b) == VTI_OK)
        return 1;
    r[0] = r[1] = r[2] = NAN;
    return 0;
}

/** Whether their angular velocities are known too. */
static int turns_generally(const vti_bodies *b)
{
    return vti_spins_generally(b) && vti_has_attitude(b);
}

static double sum_of_squares(const vti_view *view, const vti_scalars *weight, const vti_bodies *b)
{
    vti_sum sum = {0.0, 0.0};
    for (int64_t i = b->first; i < b->first + b->count; ++i) {
        double a[3];
        vti_load(view, i, a);
        vti_sum_add(&sum, (weight != NULL ? vti_scalar(weight, i) : 1.0) * vti_dot(a, a));
    }
    return vti_sum_value(&sum);
}

double vti_kinetic_translation(const vti_bodies *b)
{
    if (vti_bodies_ready(b) != VTI_OK)
        return NAN;
    return vti_has(&b->v) && b->mass.p != NULL ? 0.5 * sum_of_squares(&b->v, &b->mass, b) : 0.0;
}

double vti_kinetic_rotation(const vti_bodies *b)
{
    if (vti_bodies_ready(b) != VTI_OK)
        return NAN;
    if (turns_generally(b)) {
        vti_sum sum = {0.0, 0.0};
        for (int64_t i = b->first; i < b->first + b->count; ++i)
            vti_sum_add(&sum, vti_rotor_rates_of(b, i).energy);
        return vti_sum_value(&sum);
    }
    return vti_has(&b->omega) && b->inertia.p != NULL ? 0.5 * sum_of_squares(&b->omega, &b->inertia, b) : 0.0;
}

double vti_energy(const vti_effect *effects, int64_t n, const vti_bodies *b)
{
    vti_sum sum = {0.0, 0.0};
    if (vti_effects_fault(effects, n, b, NULL) != VTI_OK)
        return NAN;
    vti_sum_add(&sum, vti_kinetic_translation(b));
    vti_sum_add(&sum, vti_kinetic_rotation(b));
    for (int64_t k = 0; k < n; ++k) {
        double energies[VTI_TERMS] = {0.0};
        if (effects[k].energy == NULL && effects[k].apply != NULL)
            return NAN;
        if (effects[k].energy != NULL && b->count > 0)
            effects[k].energy(effects[k].self, b, energies);
        for (int64_t j = 0; j < effects[k].terms; ++j)
            vti_sum_add(&sum, energies[j]);
    }
    return vti_sum_value(&sum);
}

void vti_angular_momentum(const vti_bodies *b, const double about[3], double l[3])
{
    if (!can_measure(b, about, l))
        return;
    const int orbits = vti_has(&b->x) && vti_has(&b->v) && b->mass.p != NULL;
    const int general = vti_spins_generally(b), spins = vti_has(&b->omega) && b->inertia.p != NULL;
    vti_sum sum[3] = {{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}};
    for (int64_t i = b->first; i < b->first + b->count; ++i) {
        double x[3], v[3], w[3], c[3];
        if (orbits) {
            vti_load(&b->x, i, x);
            vti_load(&b->v, i, v);
            for (int k = 0; k < 3; ++k)
                x[k] -= about[k];
            vti_cross(x, v, c);
            for (int k = 0; k < 3; ++k)
                vti_sum_add(&sum[k], vti_scalar(&b->mass, i) * c[k]);
        }
        if (general) {
            vti_rotor_spin(b, i, w);
            for (int k = 0; k < 3; ++k)
                vti_sum_add(&sum[k], w[k]);
        } else if (spins) {
            vti_load(&b->omega, i, w);
            for (int k = 0; k < 3; ++k)
                vti_sum_add(&sum[k], vti_scalar(&b->inertia, i) * w[k]);
        }
    }
    for (int k = 0; k < 3; ++k)
        l[k] = vti_sum_value(&sum[k]);
}

static void weighted_sum(const vti_view *view, const vti_scalars *weight, const vti_bodies *b, double r[3])
{
    vti_sum sum[3] = {{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}};
    for (int64_t i = b->first; vti_has(view) && weight->p != NULL && i < b->first + b->count; ++i)
        for (int k = 0; k < 3; ++k)
            vti_sum_add(&sum[k], vti_scalar(weight, i) * view->c[k][i * view->stride]);
    for (int k = 0; k < 3; ++k)
        r[k] = vti_sum_value(&sum[k]);
}

void vti_momentum(const vti_bodies *b, double p[3])
{
    if (can_measure(b, b, p))
        weighted_sum(&b->v, &b->mass, b, p);
}

void vti_spin(const vti_bodies *b, double s[3])
{
    const double about[3] = {0.0, 0.0, 0.0};
    if (!can_measure(b, b, s))
        return;
    if (!vti_has(&b->moments)) {
        weighted_sum(&b->omega, &b->inertia, b, s);
        return;
    }
    vti_bodies still = *b;
    still.sealed = 0;
    still.v = vti_view_none();
    vti_angular_momentum(&still, about, s);
}

double vti_max_turn(double h, const vti_bodies *b)
{
    double most = 0.0;
    if (vti_bodies_ready(b) != VTI_OK)
        return NAN;
    for (int64_t i = b->first; turns_generally(b) && i < b->first + b->count; ++i)
        most = vti_larger(most, fabs(h) * vti_rotor_rates_of(b, i).most);
    for (int64_t i = b->first; !vti_has(&b->moments) && vti_has(&b->omega) && i < b->first + b->count; ++i) {
        double w[3];
        vti_load(&b->omega, i, w);
        const double turn = fabs(h) * vti_norm(w);
        most = vti_larger(most, turn);
    }
    return most;
}

/* ---- norms ------------------------------------------------------------------------------------------------------ */

static double attitude_distance(const vti_bodies *b, int64_t i, const vti_bodies *r, int64_t j)
{
    double p[4], q[4];
    vti_load_pair(b, i, p);
    vti_load_pair(r, j, q);
    return vti_pair_distance(p, q);
}

double vti_h1_density(const vti_bodies *b)
{
    if (vti_bodies_ready(b) != VTI_OK)
        return NAN;
    vti_sum sum = {0.0, 0.0};
    const vti_view *const vectors[3] = {&b->x, &b->v, &b->omega};
    for (int k = 0; k < 3; ++k)
        if (vti_has(vectors[k]))
            vti_sum_add(&sum, sum_of_squares(vectors[k], NULL, b));
    for (int64_t i = b->first; vti_has_attitude(b) && i < b->first + b->count; ++i) {
        double q[4];
        vti_load_pair(b, i, q);
        const double theta = vti_pair_angle(q);
        vti_sum_add(&sum, theta * theta);
    }
    return vti_sum_value(&sum);
}

/** Both are sound, of one length, and have the same of what is compared. */
static int comparable(const vti_bodies *b, const vti_bodies *r, int attitudes_only)
{
    if (vti_bodies_ready(b) != VTI_OK || vti_bodies_ready(r) != VTI_OK || b->count != r->count)
        return 0;
    if (b->count == 0)
        return 1;
    const int attitudes = vti_has_attitude(b) == vti_has_attitude(r);
    const int vectors = vti_has(&b->x) == vti_has(&r->x) && vti_has(&b->v) == vti_has(&r->v) &&
                        vti_has(&b->omega) == vti_has(&r->omega);
    return attitudes && (attitudes_only || vectors);
}

static double squared_difference(const vti_view *a, int64_t i, const vti_view *b, int64_t j)
{
    double p[3], q[3];
    vti_load(a, i, p);
    vti_load(b, j, q);
    for (int k = 0; k < 3; ++k)
        p[k] -= q[k];
    return vti_dot(p, p);
}

double vti_h1_distance(const vti_bodies *b, const vti_bodies *r)
{
    if (!comparable(b, r, 0))
        return NAN;
    vti_sum sum = {0.0, 0.0};
    const vti_view *const ours[3] = {&b->x, &b->v, &b->omega}, *const theirs[3] = {&r->x, &r->v, &r->omega};
    for (int64_t n = 0; n < b->count; ++n) {
        for (int k = 0; k < 3; ++k)
            if (vti_has(ours[k]))
                vti_sum_add(&sum, squared_difference(ours[k], b->first + n, theirs[k], r->first + n));
        if (vti_has_attitude(b)) {
            const double theta = attitude_distance(b, b->first + n, r, r->first + n);
            vti_sum_add(&sum, theta * theta);
        }
    }
    return vti_sum_value(&sum);
}

double vti_attitude_distance(const vti_bodies *b, const vti_bodies *r)
{
    double most = 0.0;
    if (!comparable(b, r, 1))
        return NAN;
    for (int64_t n = 0; vti_has_attitude(b) && n < b->count; ++n) {
        const double d = attitude_distance(b, b->first + n, r, r->first + n);
        most = vti_larger(most, d);
    }
    return most;
}
