/* SPDX-License-Identifier: BSD-3-Clause
 * Runs the array of effects: checks, forces (vti_apply), the pairs that act on a slice. */
#include <string.h>

#include "vti_ready.h"

static void clear(const vti_view *view, int64_t begin, int64_t end)
{
    double *const *c = view->c;
    if (vti_is_packed(view)) {
        /* in small parts, for which no C library falls back to storing bytes; of no size that compilers know, for which
           they store narrow vectors themselves */
        const int64_t parts = (end - begin + VTI_LANES - 1) / VTI_LANES, size = (end - begin) / parts;
        for (int64_t first = begin; first < end; first += size)
            memset(c[0] + 3 * first, 0, (size_t)(end - first < size ? end - first : size) * 3 * sizeof(double));
        return;
    }
    for (int64_t i = begin; i < end; ++i)
        for (int k = 0; k < 3; ++k)
            c[k][i * view->stride] = 0.0;
}

VTI_INLINE void clear_few(const vti_view *view, int64_t begin, int64_t end)
{
    for (int64_t i = begin; i < end; ++i) {
        view->c[0][i * view->stride] = 0.0;
        view->c[1][i * view->stride] = 0.0;
        view->c[2][i * view->stride] = 0.0;
    }
}

VTI_INLINE void clear_load(const vti_bodies *b, const vti_view *load)
{
    if (!vti_has(load))
        return;
    if (b->count <= VTI_FEW)
        clear_few(load, b->first, b->first + b->count);
    else
        clear(load, b->first, b->first + b->count);
}

/** force = moment = 0 */
static inline void clear_loads(const vti_bodies *b)
{
    clear_load(b, &b->force);
    clear_load(b, &b->moment);
}

/** Bits of what effects may need: of what steps read, as most do, and of all. */
#define BIT_STATE(constant) | 1 << (constant)
#define BIT_CONSTANT(constant) | 1 << (constant)
#define BIT_LOAD(constant)
#define BIT_LOW(constant)
#define BIT_READ(constant, number, member, type, role) BIT_##role(constant)
#define BIT_ANY(constant, number, member, type, role) | 1 << (constant)
static const int64_t what_is_read = 0 VTI_QUANTITIES(BIT_READ), what_there_is = 0 VTI_QUANTITIES(BIT_ANY);

#define START_vti_view(member) b->member.c[0]
#define START_vti_quat_view(member) b->member.xyzw[0]
#define START_vti_scalars(member) b->member.p
#define LACKS_ANY(constant, member, type)                                                                              \
    if (needs & 1 << (constant) && START_##type(member) == NULL)                                                       \
        return constant;
#define LACKS_NONE(constant, member, type)

/** The first of the states and constants that is needed and absent, or VTI_QUANTITY_NONE. An attitude is one in either
 *  form. */
static inline int64_t lacking(int64_t needed, const vti_bodies *b)
{
    const int64_t attitude = 1 << VTI_QUANTITY_ALPHA | 1 << VTI_QUANTITY_QUAT, needs = needed & ~attitude;
    if (needed & attitude && !vti_has_attitude(b))
        return VTI_QUANTITY_ALPHA;
#define READ_STATE(constant, member, type) LACKS_ANY(constant, member, type)
#define READ_CONSTANT(constant, member, type) LACKS_ANY(constant, member, type)
#define READ_LOAD(constant, member, type) LACKS_NONE(constant, member, type)
#define READ_LOW(constant, member, type) LACKS_NONE(constant, member, type)
#define READ(constant, number, member, type, role) READ_##role(constant, member, type)
    VTI_QUANTITIES(READ)
    return VTI_QUANTITY_NONE;
}

/** The same of loads and rounding errors, which few need. */
VTI_APART int64_t lacking_else(int64_t needs, const vti_bodies *b)
{
#define ELSE_STATE(constant, member, type) LACKS_NONE(constant, member, type)
#define ELSE_CONSTANT(constant, member, type) LACKS_NONE(constant, member, type)
#define ELSE_LOAD(constant, member, type) LACKS_ANY(constant, member, type)
#define ELSE_LOW(constant, member, type) LACKS_ANY(constant, member, type)
#define ELSE(constant, number, member, type, role) ELSE_##role(constant, member, type)
    VTI_QUANTITIES(ELSE)
    return VTI_QUANTITY_NONE;
}

/** VTI_E_NEEDS where something is needed that the bodies do not have, or that is no quantity. */
VTI_INLINE int needs_check(int64_t needs, const vti_bodies *b, int64_t *quantity)
{
    *quantity = lacking(needs, b);
    if ((needs & ~what_is_read) != 0 && *quantity == VTI_QUANTITY_NONE) {
        *quantity = lacking_else(needs, b);
        if ((needs & ~what_there_is) != 0)
            return VTI_E_NEEDS;
    }
    return *quantity != VTI_QUANTITY_NONE ? VTI_E_NEEDS : VTI_OK;
}

VTI_INLINE int effect_check(const vti_effect *e, const vti_bodies *b, int64_t *quantity)
{
    *quantity = VTI_QUANTITY_NONE;
    if (e->apply == NULL && e->flow == NULL && e->rupture == NULL)
        return VTI_E_NULL;
    if (e->terms < 0 || e->terms > VTI_TERMS || e->books < 0 || e->books > VTI_TERMS)
        return VTI_E_COUNT;
    if (e->books > 0 && (e->booked == NULL || (e->by_body != NULL && e->of_body < e->books)))
        return VTI_E_NULL;
    if (b->count == 0) /* nothing is called, and arrays of no bodies may be absent */
        return VTI_OK;
    if (e->needs != 0 && needs_check(e->needs, b, quantity) != VTI_OK)
        return VTI_E_NEEDS;
    return e->check != NULL ? e->check(e->self, b) : VTI_OK;
}

VTI_INLINE int look(const vti_effect *effects, int64_t n, const vti_bodies *b, vti_fault *fault)
{
    const int status = vti_bodies_ready_or(b, fault);
    if (status != VTI_OK)
        return status;
    if (n <= 0)
        return n < 0 ? VTI_E_COUNT : VTI_OK;
    if (effects == NULL)
        return VTI_E_NULL;
    for (int64_t k = 0; k < n; ++k) {
        int64_t quantity;
        const int refused = effect_check(&effects[k], b, &quantity);
        if (refused != VTI_OK)
            return vti_refuse(refused, k, 0.0, quantity, fault);
    }
    return VTI_OK;
}

int vti_effects_fault(const vti_effect *effects, int64_t n, const vti_bodies *b, vti_fault *fault)
{
    return look(effects, n, b, fault);
}

int vti_effects_check(const vti_effect *effects, int64_t n, const vti_bodies *b, vti_fault *fault)
{
    vti_refuse_none(VTI_OK, fault);
    return vti_effects_fault(effects, n, b, fault);
}

int vti_apply(const vti_effect *effects, int64_t n, const vti_bodies *b)
{
    const int status = look(effects, n, b, NULL);
    if (status != VTI_OK)
        return status;
    clear_loads(b);
    for (int64_t k = 0; b->count > 0 && k < n; ++k)
        if (effects[k].apply != NULL)
            effects[k].apply(effects[k].self, b);
    return VTI_OK;
}

int64_t vti_pairs_of_slice(int64_t count, const int64_t *pair, int64_t base, int64_t first, int64_t bodies,
                           int64_t *which)
{
    int64_t n = 0;
    for (int64_t k = 0; pair != NULL && k < count; ++k) {
        if (!vti_is_body(pair[2 * k], first + base, bodies) && !vti_is_body(pair[2 * k + 1], first + base, bodies))
            continue;
        if (which != NULL)
            which[n] = k;
        ++n;
    }
    return n;
}
