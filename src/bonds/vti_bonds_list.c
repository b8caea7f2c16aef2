/* SPDX-License-Identifier: BSD-3-Clause
 * The rest configuration of bonds, and checks of a list of bonds. */
#include "vti_binder_table.h"
#include "../vti_ready.h"

/* ---- making it --------------------------------------------------------------------------------------------------- */

/** d = x_i - x_j of one pair; returns |d|. */
static double separation(const int64_t pair[2], int64_t base, const vti_view *x, double d[3])
{
    (void)vti_difference(x, pair[0] - base, pair[1] - base, d);
    return vti_norm(d);
}

/** How many bodies there are only x may know; none comes before the first. */
static int rest_check(int64_t count, const int64_t *pair, int64_t base, const vti_view *x, vti_fault *fault)
{
    const int64_t n = x->count != 0 ? x->count : INT64_MAX;
    for (int64_t k = 0; k < count; ++k) {
        for (int side = 0; side < 2; ++side)
            if (!vti_is_body(pair[2 * k + side], base, n))
                return vti_refuse(VTI_E_BOND, k, (double)pair[2 * k + side], VTI_QUANTITY_NONE, fault);
        double d[3];
        const double length = separation(pair + 2 * k, base, x, d);
        if (!(length > 0.0) || !isfinite(length))
            return vti_refuse(VTI_E_BOND, k, length, VTI_QUANTITY_NONE, fault);
    }
    return VTI_OK;
}

int vti_bonds_rest(int64_t count, const int64_t *pair, int64_t base, const vti_view *x, double *rest, vti_fault *fault)
{
    vti_refuse_none(VTI_OK, fault);
    if (count < 0)
        return VTI_E_COUNT;
    if (count == 0)
        return VTI_OK;
    if (pair == NULL || x == NULL || rest == NULL)
        return VTI_E_NULL;
    if (x->c[0] == NULL || x->c[1] == NULL || x->c[2] == NULL)
        return vti_refuse(VTI_E_VIEW, -1, 0.0, VTI_QUANTITY_X, fault);
    const int status = rest_check(count, pair, base, x, fault);
    for (int64_t k = 0; status == VTI_OK && k < count; ++k) {
        double d[3];
        const double length = separation(pair + 2 * k, base, x, d);
        for (int c = 0; c < 3; ++c)
            rest[4 * k + c] = d[c] / length;
        rest[4 * k + 3] = length;
    }
    return status;
}

/** R_i^T n and Q0 = R_i^T R_j of one bond, of which rest has n. Returns 0 where an attitude is none. */
static int turn_now(const int64_t pair[2], int64_t base, const vti_bodies *b, double rest[4], double turn[4])
{
    double q[2][4] = {{0.0, 0.0, 0.0, 1.0}, {0.0, 0.0, 0.0, 1.0}}, x[3];
    for (int side = 0; side < 2 && vti_has_attitude(b); ++side)
        vti_load_pair(b, pair[side] - base, q[side]);
    vti_cross(q[0], q[1], x);
    for (int c = 0; c < 3; ++c)
        turn[c] = (q[0][3] * q[1][c] - q[1][3] * q[0][c]) - x[c];
    turn[3] = q[0][3] * q[1][3] + vti_dot(q[0], q[1]);
    const double square = vti_dot(turn, turn) + turn[3] * turn[3], length = sqrt(square);
    for (int c = 0; c < 4; ++c)
        turn[c] /= length;
    vti_pair_rotate(q[0], -1.0, rest, rest);
    return square > 0.0 && isfinite(square);
}

/** Bodies that do not exist, and attitudes that are none. */
static int now_check(int64_t count, const int64_t *pair, int64_t base, const vti_bodies *b, vti_fault *fault)
{
    const int64_t bodies = vti_bodies_named(b, 1 << VTI_QUANTITY_X | 1 << VTI_QUANTITY_ALPHA);
    for (int64_t k = 0; k < count; ++k) {
        double n[4] = {1.0, 0.0, 0.0, 0.0}, turn[4];
        for (int side = 0; side < 2; ++side)
            if (!vti_is_body(pair[2 * k + side], base, bodies))
                return vti_refuse(VTI_E_BOND, k, (double)pair[2 * k + side], VTI_QUANTITY_NONE, fault);
        if (!turn_now(pair + 2 * k, base, b, n, turn))
            return vti_refuse(VTI_E_BOND, k, NAN, VTI_QUANTITY_NONE, fault);
    }
    return VTI_OK;
}

/** Which view of what is read is given in part: of an empty slice vti_bodies_check looks at none. */
static int64_t partial(const vti_bodies *b)
{
    const vti_view *const x = &b->x, *const alpha = &b->alpha;
    if (x->c[1] == NULL || x->c[2] == NULL)
        return VTI_QUANTITY_X;
    if (vti_has(alpha))
        return alpha->c[1] == NULL || alpha->c[2] == NULL ? VTI_QUANTITY_ALPHA : VTI_QUANTITY_NONE;
    for (int k = 1; k < 4; ++k)
        if (vti_has_attitude(b) && b->quat.xyzw[k] == NULL)
            return VTI_QUANTITY_QUAT;
    return VTI_QUANTITY_NONE;
}

int vti_bonds_rest_now(int64_t count, const int64_t *pair, int64_t base, const vti_bodies *b, double *rest,
                       double *turn, vti_fault *fault)
{
    vti_refuse_none(VTI_OK, fault);
    if (count < 0)
        return VTI_E_COUNT;
    if (b == NULL || (count > 0 && (pair == NULL || rest == NULL || turn == NULL)))
        return VTI_E_NULL;
    int status = vti_bodies_ready_or(b, fault);
    if (status == VTI_OK && count > 0 && !vti_has(&b->x))
        return vti_refuse(VTI_E_NEEDS, -1, 0.0, VTI_QUANTITY_X, fault);
    if (status == VTI_OK && count > 0 && partial(b) != VTI_QUANTITY_NONE)
        return vti_refuse(VTI_E_VIEW, -1, 0.0, partial(b), fault);
    if (status == VTI_OK)
        status = now_check(count, pair, base, b, fault);
    if (status == VTI_OK && count > 0)
        status = vti_bonds_rest(count, pair, base, &b->x, rest, fault);
    for (int64_t k = 0; status == VTI_OK && k < count; ++k)
        turn_now(pair + 2 * k, base, b, rest + 4 * k, turn + 4 * k);
    return status;
}

/* ---- checking it ------------------------------------------------------------------------------------------------- */

static int stiffness_is_bad(const vti_scalars *s, int64_t k)
{
    return s->p != NULL && (vti_ends_before(s, k) || !(isfinite(vti_scalar(s, k)) && vti_scalar(s, k) >= 0.0));
}

int vti_bonds_check(const vti_bonds *bonds, int64_t n, vti_fault *fault)
{
    static const double unturned[4] = {0.0, 0.0, 0.0, 1.0};
    vti_refuse_none(VTI_OK, fault);
    if (bonds == NULL || !vti_bonds_has_list(bonds))
        return VTI_E_NULL;
    if (bonds->count < 0 || n < 0)
        return VTI_E_COUNT;
    if (bonds->count > 0 && bonds->shear.p != NULL && !vti_bonds_form_is_known(bonds))
        return vti_refuse(VTI_E_BOND, -1, (double)bonds->shear_form, VTI_QUANTITY_NONE, fault);
    for (int64_t k = 0; k < bonds->count; ++k) {
        const int64_t *pair = bonds->pair + 2 * k;
        const double *rest = bonds->rest + 4 * k;
        for (int side = 0; side < 2; ++side)
            if (!vti_is_body(pair[side], bonds->base, n) || (side == 1 && pair[0] == pair[1]))
                return vti_refuse(VTI_E_BOND, k, (double)pair[side], VTI_QUANTITY_NONE, fault);
        if (!(rest[3] > 0.0) || !isfinite(rest[3]) || !(fabs(vti_dot(rest, rest) - 1.0) < 1e-12))
            return vti_refuse(VTI_E_BOND, k, rest[3], VTI_QUANTITY_NONE, fault);
        const double *turn = bonds->turn != NULL ? bonds->turn + 4 * k : unturned;
        const double square = vti_dot(turn, turn) + turn[3] * turn[3];
        if (!(fabs(square - 1.0) < 1e-12))
            return vti_refuse(VTI_E_BOND, k, sqrt(square), VTI_QUANTITY_NONE, fault);
        const vti_scalars *const all[] = {&bonds->moment, &bonds->axial, &bonds->shear};
        for (int c = 0; c < TERMS; ++c)
            if (stiffness_is_bad(all[c], k))
                return vti_refuse(VTI_E_BOND, k,
                                  vti_ends_before(all[c], k) ? (double)all[c]->count : vti_scalar(all[c], k),
                                  VTI_QUANTITY_NONE, fault);
    }
    return VTI_OK;
}
