/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Friction: forces and energies of the springs, and the lists that they are gone through by; how springs are carried
 * along is in vti_friction_carry.c (EQUATIONS 6.5). The load f is what a spring holds back with: with the arms s_i d
 * and s_j d
 *
 *     F_i -= f, F_j += f, T_i += s_i d x f, T_j += s_j d x f       (sliding)
 *     T_i -= f, T_j += f                                           (rolling; twisting with f n)                      */
#include "../contacts/vti_cage.h"
#include "vti_friction_touches.h"
#include "vti_spring.h"
#include "../contacts/vti_touch.h"
#include "../vti_ready.h"

/* ---- the history ------------------------------------------------------------------------------------------------- */

static int has_slots(const vti_history *t)
{
    return t->slots > 0 && t->slots <= INT64_C(1) << 31 && (t->slots & (t->slots - 1)) == 0;
}

/** Whether a body, from 1, holds on to another or to a wall, with loads that are finite. */
static int is_held(const vti_held *h)
{
    double zero = 0.0 * h->twisting;
    for (int k = 0; k < 3; ++k)
        zero += 0.0 * h->sliding[k] + 0.0 * h->rolling[k];
    return h->i > 0 && h->j != 0 && h->j != h->i && zero == 0.0;
}

int vti_history_add(vti_history *history, const vti_held *held)
{
    if (history == NULL || history->slot == NULL || history->held == NULL || held == NULL)
        return VTI_E_NULL;
    if (!has_slots(history) || history->used < 0 || history->used >= history->slots || !is_held(held))
        return VTI_E_HISTORY;
    vti_held *at = vti_history_find(history, held->i, held->j);
    if (at == NULL)
        at = vti_history_begin(history, held->i, held->j);
    if (at == NULL)
        return VTI_E_HISTORY;
    *at = *held;
    return VTI_OK;
}

/* ---- all touches, in the order of the lists ---------------------------------------------------------------------- */

typedef void visitor(void *context, const struct vti_touch *touch, vti_held *held);

/** Calls visit for all pairs that hold something. */
static void visit_pairs(const vti_friction *p, const vti_bodies *b, visitor *visit, void *context)
{
    struct vti_touch touch;
    int64_t next = 0;
    for (int64_t k = 0; p->contacts != NULL && k < p->contacts->count; ++k) {
        if (!vti_touch_pair(&touch, p->contacts, b, k, 0.0))
            continue;
        vti_held *const held = vti_friction_held(p, k, &next);
        if (held != NULL)
            visit(context, &touch, held);
    }
}

/** And for all bodies at wall w. */
static void visit_wall(const vti_friction *p, const vti_bodies *b, int64_t w, visitor *visit, void *context)
{
    const int64_t end = b->first + b->count;
    struct vti_touch touch;
    for (int64_t first = b->first; first < end; first += VTI_TOUCHES) {
        uint64_t near = vti_friction_near_wall(p, b, w, first);
        for (; near != 0; near &= near - 1) {
            const int64_t i = first + vti_first_bit(near);
            vti_held *const held = vti_history_find(p->history, 1 + i, -1 - w);
            if (held != NULL && vti_touch_wall(&touch, p->walls, b, w, i, 0.0))
                visit(context, &touch, held);
        }
    }
}

/* ---- forces and energies ----------------------------------------------------------------------------------------- */

/** Pairs that hold something, as many at once as a kernel takes. */
static void push_pairs(const vti_friction *p, const vti_bodies *b)
{
    const vti_contacts *const list = p->contacts;
    int64_t pair[VTI_TOUCHES], count = 0, next = 0;
    vti_held *held[VTI_TOUCHES];
    for (int64_t k = 0; k < list->count; ++k) {
        pair[count] = k;
        held[count] = vti_friction_held(p, k, &next);
        count += held[count] != NULL;
        if (count < VTI_TOUCHES && k < list->count - 1)
            continue;
        vti_touch_kernels_for(count)->push(p, b, count, pair, held);
        count = 0;
    }
}

/** Bodies that hold something at wall w, likewise. */
static void push_at_wall(const vti_friction *p, const vti_bodies *b, int64_t w)
{
    const int64_t end = b->first + b->count;
    int64_t body[VTI_TOUCHES], count = 0;
    vti_held *held[VTI_TOUCHES];
    for (int64_t first = b->first; first < end; first += VTI_TOUCHES) {
        uint64_t near = vti_friction_near_wall(p, b, w, first);
        count = 0;
        for (; near != 0; near &= near - 1) {
            const int64_t i = body[count] = first + vti_first_bit(near);
            held[count] = vti_history_find(p->history, 1 + i, -1 - w);
            count += held[count] != NULL;
        }
        if (count > 0)
            vti_touch_kernels_for(count)->push_at(p, b, w, count, body, held);
    }
}

static void apply(const void *self, const vti_bodies *b)
{
    const vti_friction *p = self;
    if (p->contacts != NULL)
        push_pairs(p, b);
    for (int64_t w = 0; w < vti_faces(p->walls); ++w)
        push_at_wall(p, b, w);
}

struct energies {
    const vti_friction *p;
    vti_sum sum[VTI_FRICTION_BOOKS];
};

/** |f|^2/(2 k) */
static void add_energy(void *context, const struct vti_touch *touch, vti_held *held)
{
    struct energies *e = context;
    const double k = vti_carry_stiffness(e->p, touch, touch->delta);
    if (k > 0.0)
        vti_sum_add(&e->sum[0], 0.5 * vti_dot(held->sliding, held->sliding) / k);
    if (e->p->rolling > 0.0)
        vti_sum_add(&e->sum[1], 0.5 * vti_dot(held->rolling, held->rolling) / e->p->rolling_stiffness);
    if (e->p->twisting > 0.0)
        vti_sum_add(&e->sum[2], 0.5 * held->twisting * held->twisting / e->p->twisting_stiffness);
}

static int terms_of(const vti_friction *p)
{
    return p->twisting > 0.0 ? 3 : p->rolling > 0.0 ? 2 : 1;
}

static void energy(const void *self, const vti_bodies *b, double *energies)
{
    struct energies e = {.p = self};
    visit_pairs(self, b, add_energy, &e);
    for (int64_t w = 0; w < vti_faces(e.p->walls); ++w)
        visit_wall(e.p, b, w, add_energy, &e);
    for (int k = 0; k < terms_of(self); ++k)
        energies[k] = vti_sum_value(&e.sum[k]);
}

/* ---- the stable step (EQUATIONS 6.10) ---------------------------------------------------------------------------- */

/** k of sliding at the overlap o, a share of the length; NaN where that is NaN or negative. */
static double sliding_stiffness(const vti_friction *p, const struct vti_touch *touch, double o)
{
    if (!(p->sliding > 0.0))
        return 0.0;
    return o >= 0.0 ? vti_carry_stiffness(p, touch, o * touch->length) : NAN;
}

/** The springs of a touch as it is (at NULL), or at the overlap of *at. */
static void show(const vti_friction *p, struct vti_touch *touch, int64_t element, const vti_deformation *at,
                 vti_spring_visit *visit, void *context)
{
    if (at == NULL && touch->delta <= 0.0)
        return;
    const double o = at != NULL ? at->overlap : touch->delta / touch->length;
    const double arm = touch->length * fmax(1.0, o - 1.0); /* |r|, a sphere's centre may be behind a wall */
    const vti_spring s = {.element = element,
                          .i = touch->i,
                          .j = touch->j,
                          .length = arm,
                          .shear = sliding_stiffness(p, touch, o) * arm * arm,
                          .arm_i = touch->s_i,
                          .arm_j = touch->s_j,
                          .bend = p->rolling > 0.0 ? p->rolling_stiffness : 0.0,
                          .twist = p->twisting > 0.0 ? p->twisting_stiffness : 0.0};
    visit(context, &s);
}

/** Touches at bodies that are nowhere count: a step that is 0 tells of NaN. */
static int pair_found(struct vti_touch *touch, const vti_friction *p, const vti_bodies *b, int64_t k)
{
    touch->r = touch->delta = touch->stiffness = NAN;
    return vti_touch_pair(touch, p->contacts, b, k, INFINITY) || isnan(touch->r);
}

static int body_found(struct vti_touch *touch, const vti_friction *p, const vti_bodies *b, int64_t w, int64_t i)
{
    touch->stiffness = NAN;
    const int found = vti_touch_wall(touch, p->walls, b, w, i, INFINITY);
    touch->i = i;
    return found || isnan(touch->delta);
}

/** Any two may touch: each body is held by twice its neighbours' springs to its place, as in vti_contact.c. */
static int cages(const vti_friction *p, const vti_bodies *b, const vti_deformation *at, vti_spring_visit *visit,
                 void *context)
{
    struct vti_cages cages;
    const int status = vti_cages_of(p->contacts, b, &cages);
    for (int64_t i = b->first; status == VTI_OK && b->count > 1 && i < b->first + b->count; ++i) {
        const double radius = 0.5 * vti_scalar(&p->contacts->diameter, i);
        const struct vti_cage cage = vti_cage_at(&cages, i, at->overlap);
        const struct vti_touch touch = {.i = i, .j = -1, .length = cage.length, .stiffness = cage.stiffness};
        const double z = 2.0 * cage.z, k = sliding_stiffness(p, &touch, at->overlap);
        const vti_spring s = {.element = i,
                              .i = i,
                              .j = -1,
                              .length = radius,
                              .shear = z * k * radius * radius,
                              .arm_i = 1.0,
                              .bend = p->rolling > 0.0 ? z * p->rolling_stiffness : 0.0,
                              .twist = p->twisting > 0.0 ? z * p->twisting_stiffness : 0.0};
        visit(context, &s);
    }
    return status;
}

static int springs(const void *self, const vti_bodies *b, const vti_deformation *at, vti_spring_visit *visit,
                   void *context)
{
    const vti_friction *p = self;
    struct vti_touch touch;
    const int meet = at != NULL && at->meet;
    const int status = p->contacts != NULL && meet ? cages(p, b, at, visit, context) : VTI_OK;
    for (int64_t k = 0; p->contacts != NULL && !meet && k < p->contacts->count; ++k) {
        if (vti_pair_check(b, vti_contact_body(p->contacts, k, 0), vti_contact_body(p->contacts, k, 1)) != VTI_OK)
            return VTI_E_BOND;
        if (pair_found(&touch, p, b, k))
            show(p, &touch, k, at, visit, context);
    }
    for (int64_t w = 0; w < vti_faces(p->walls); ++w)
        for (int64_t i = b->first; i < b->first + b->count; ++i)
            if (body_found(&touch, p, b, w, i))
                show(p, &touch, w, at, visit, context);
    return status;
}

/* ---- the effect -------------------------------------------------------------------------------------------------- */

static const int64_t needs =
    1 << VTI_QUANTITY_X | 1 << VTI_QUANTITY_V | 1 << VTI_QUANTITY_ALPHA | 1 << VTI_QUANTITY_OMEGA;

static int check(const void *self, const vti_bodies *b)
{
    const vti_friction *p = self;
    const double all[] = {p->stiffness, p->mindlin, p->rolling_stiffness, p->twisting_stiffness};
    int good = p->reach > 0.0 && (p->sliding == 0.0 || (p->stiffness > 0.0) + (p->mindlin > 0.0) == 1);
    good &= vti_friction_has_limits(p, p->walls);
    for (int k = 0; k < 4; ++k)
        good &= isfinite(all[k]) && all[k] >= 0.0;
    good &= !(p->rolling > 0.0) || p->rolling_stiffness > 0.0;
    good &= !(p->twisting > 0.0) || p->twisting_stiffness > 0.0;
    if (!good)
        return VTI_E_DAMPING;
    if (p->lost == NULL || p->history == NULL || p->history->slot == NULL || p->history->held == NULL)
        return VTI_E_NULL;
    const int status = vti_touches_ready(p->contacts, p->walls, b, needs);
    if (status != VTI_OK)
        return status;
    return has_slots(p->history) && p->history->missed == 0 && vti_history_is_whole(p->history) ? VTI_OK
                                                                                                : VTI_E_HISTORY;
}

vti_effect vti_friction_effect(const vti_friction *friction)
{
    static const char *const term[] = {"friction_sliding", "friction_rolling", "friction_twisting"};
    static const char *const book[VTI_FRICTION_BOOKS] = {"lost_friction_sliding", "lost_friction_rolling",
                                                         "lost_friction_twisting"};
    const vti_friction *p = friction;
    if (p == NULL || p->lost == NULL || p->history == NULL || (p->contacts == NULL && p->walls == NULL))
        return vti_effect_none();
    const vti_effect effect = {.name = "friction",
                               .apply = apply,
                               .energy = energy,
                               .check = check,
                               .springs = springs,
                               .carry = vti_friction_carry,
                               .self = p,
                               .needs = needs,
                               .gives = 1 << VTI_QUANTITY_FORCE | 1 << VTI_QUANTITY_MOMENT,
                               .breaks = p->walls != NULL ? VTI_BREAKS_LINEAR | VTI_BREAKS_ANGULAR | VTI_BREAKS_SPINS
                                                          : VTI_BREAKS_SPINS,
                               .dissipates = 1,
                               .terms = terms_of(p),
                               .term = term,
                               .books = terms_of(p),
                               .book = book,
                               .booked = p->lost,
                               .by_body = p->by_body,
                               .of_body = VTI_FRICTION_BOOKS};
    return effect;
}
