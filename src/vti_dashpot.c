/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Dashpots of contacts and walls as flows of velocities: the order of the touches (EQUATIONS 6.4), restitution, and the
 * effect. What a touch does is in vti_dashpot_flow.h. */
#include "vti_dashpot_flow.h"
#include "vti_joint.h"
#include "vti_touch.h"
#include "vti_touch_table.h"

/* ---- pairs ------------------------------------------------------------------------------------------------------- */

/** Pairs within reach are taken together, so many at once in the order of the list, and given colours: each the
 *  smallest that neither of its bodies has yet. They are worked colour by colour; pairs of the last colour may share
 *  bodies, and are worked one by one. What else the list holds does not matter. */
enum { WINDOW = 256, COLOURS = 64, LAST = COLOURS - 1, BODIES = 4 * WINDOW };

struct window {
    int64_t count;
    struct vti_seat seat[WINDOW]; /* in the order of the list */
    int64_t touches[WINDOW];      /* whether they do where they are */
    int64_t colour[WINDOW];
    int64_t order[WINDOW];     /* of their numbers, colour by colour */
    int64_t ends[COLOURS + 1]; /* of the colours in it */
    int64_t body[BODIES];      /* table of bodies, from 1; 0: nobody */
    uint64_t coloured[BODIES]; /* colours of their pairs, as bits */
};

/** Whether pair k is within reach, and where. */
VTI_INLINE int find_seat(const struct vti_sweep *s, int64_t k, struct vti_seat *seat, int64_t *touches)
{
    const vti_contacts *p = s->p->contacts;
    double d[3], x[3];
    seat->i = p->pair[2 * k] - p->base;
    seat->j = p->pair[2 * k + 1] - p->base;
    seat->k = k;
    vti_load(&s->b->x, seat->i, d);
    vti_load(&s->b->x, seat->j, x);
    for (int c = 0; c < 3; ++c)
        d[c] -= x[c];
    const double length = vti_contact_length(p, k, seat->i, seat->j), far = length + s->p->reach, r2 = vti_dot(d, d);
    *touches = r2 < length * length;
    return r2 <= far * far && r2 > VTI_COINCIDENT * VTI_COINCIDENT;
}

/** Where body i stands in the table of so many slots, a power of 2. */
VTI_INLINE int64_t slot_of(struct window *w, int64_t slots, int64_t i)
{
    int64_t at = (int64_t)((uint64_t)i * UINT64_C(0x9e3779b97f4a7c15) >> 40) & (slots - 1);
    while (w->body[at] != 0 && w->body[at] != i + 1)
        at = (at + 1) & (slots - 1);
    if (w->body[at] == 0) {
        w->body[at] = i + 1;
        w->coloured[at] = 0;
    }
    return at;
}

static void colour(struct window *w)
{
    int64_t slots = 8, begin = 0, of[COLOURS] = {0};
    while (slots < 4 * w->count)
        slots *= 2;
    memset(w->body, 0, (size_t)slots * sizeof *w->body);
    for (int64_t n = 0; n < w->count; ++n) {
        uint64_t *const i = &w->coloured[slot_of(w, slots, w->seat[n].i)],
                        *const j = &w->coloured[slot_of(w, slots, w->seat[n].j)];
        int64_t c = 0;
        while (c < LAST && ((*i | *j) >> c & 1) != 0)
            ++c;
        *i |= UINT64_C(1) << c;
        *j |= UINT64_C(1) << c;
        w->colour[n] = c;
        ++of[c];
    }
    for (int c = 0; c < COLOURS; ++c) {
        w->ends[c] = begin;
        begin += of[c];
    }
    for (int64_t n = 0; n < w->count; ++n)
        w->order[w->ends[w->colour[n]]++] = n;
}

/** Whether a pair that does not touch will at the other end of the drift: delta - drift u.n > 0. */
static int will_touch(const struct vti_sweep *s, const struct vti_seat *seat)
{
    double d[3], x[3], u[3], v[3];
    vti_load(&s->b->x, seat->i, d);
    vti_load(&s->b->x, seat->j, x);
    vti_load(&s->b->v, seat->i, u);
    vti_load(&s->b->v, seat->j, v);
    for (int c = 0; c < 3; ++c) {
        d[c] -= x[c];
        u[c] -= v[c];
    }
    const double r = sqrt(vti_dot(d, d));
    return !(vti_contact_length(s->p->contacts, seat->k, seat->i, seat->j) - r - s->drift * (vti_dot(u, d) / r) <= 0.0);
}

/** The pairs of one colour from begin on, forwards or backwards. */
static void flow_colour(const struct vti_sweep *s, const struct window *w, int64_t begin, int64_t end)
{
    const int64_t most = w->colour[w->order[begin]] == LAST ? 1 : VTI_TOUCHES;
    struct vti_seat seat[VTI_TOUCHES];
    int64_t count = 0;
    for (int64_t n = begin; n < end; ++n) {
        const int64_t at = w->order[s->drift < 0.0 ? begin + end - 1 - n : n];
        if (w->touches[at] || will_touch(s, &w->seat[at]))
            seat[count++] = w->seat[at];
        if (count == 0 || (count < most && n < end - 1))
            continue;
        for (int64_t k = count; k % VTI_LANES_MOST != 0; ++k)
            seat[k] = seat[count - 1];
        vti_touch_kernels_for(count)->flow(s, count, seat);
        count = 0;
    }
}

static void flow_window(const struct vti_sweep *s, struct window *w)
{
    if (w->count == 0)
        return;
    colour(w);
    for (int k = 0; k < COLOURS; ++k) {
        const int c = s->drift < 0.0 ? LAST - k : k;
        const int64_t begin = c > 0 ? w->ends[c - 1] : 0;
        if (begin < w->ends[c])
            flow_colour(s, w, begin, w->ends[c]);
    }
    w->count = 0;
}

/** Windows from the first pair on. */
static void flow_forwards(const struct vti_sweep *s, struct window *w)
{
    for (int64_t k = 0; k < s->p->contacts->count; ++k) {
        w->count += find_seat(s, k, &w->seat[w->count], &w->touches[w->count]);
        if (w->count == WINDOW)
            flow_window(s, w);
    }
    flow_window(s, w);
}

/** The same windows from the last on. */
static void flow_backwards(const struct vti_sweep *s, struct window *w)
{
    const int64_t pairs = s->p->contacts->count;
    int64_t all = 0;
    for (int64_t k = 0; k < pairs; ++k)
        all += find_seat(s, k, &w->seat[0], &w->touches[0]);
    for (int64_t k = pairs - 1; all > 0; --k) {
        const int64_t first = (all - 1) / WINDOW * WINDOW, at = all - 1 - first;
        if (!find_seat(s, k, &w->seat[at], &w->touches[at]))
            continue;
        ++w->count;
        if (--all > first)
            continue;
        flow_window(s, w);
    }
}

/* ---- walls ------------------------------------------------------------------------------------------------------- */

/** The bodies that wait. */
static void flow_waiting(const struct vti_sweep *s, struct vti_at_wall *at)
{
    const int64_t last = at->count - 1;
    for (int64_t to = at->count; at->count > 0 && to % VTI_LANES_MOST != 0; ++to) {
        at->body[to] = at->body[last];
        at->r[to] = at->r[last];
        at->delta[to] = at->delta[last];
        at->length[to] = at->length[last];
        at->stiffness[to] = at->stiffness[last];
        for (int c = 0; c < 3; ++c) {
            at->n[c][to] = at->n[c][last];
            at->v_j[c][to] = at->v_j[c][last];
            at->w_j[c][to] = at->w_j[c][last];
        }
    }
    if (at->count > 0)
        vti_touch_kernels_for(at->count)->flow_at(s, at);
    at->count = 0;
}

/** A body within reach joins those that wait, if it touches, or will at the other end of the drift. */
static void wait_at_wall(const struct vti_sweep *s, const struct vti_touch *touch, struct vti_at_wall *at)
{
    const int64_t to = at->count;
    double u[3];
    vti_load(&s->b->v, touch->i, u);
    for (int c = 0; c < 3 && touch->moves; ++c)
        u[c] -= touch->v_j[c];
    if (touch->delta <= 0.0 && touch->delta - s->drift * vti_dot(u, touch->n) <= 0.0)
        return;
    at->moves = touch->moves;
    at->body[to] = touch->i;
    at->r[to] = touch->r;
    at->delta[to] = touch->delta;
    at->length[to] = touch->length;
    at->stiffness[to] = touch->stiffness;
    for (int c = 0; c < 3; ++c) {
        at->n[c][to] = touch->n[c];
        at->v_j[c][to] = touch->moves ? touch->v_j[c] : 0.0;
        at->w_j[c][to] = touch->moves ? touch->w_j[c] : 0.0;
    }
    if (++at->count == VTI_TOUCHES)
        flow_waiting(s, at);
}

/** Wall by wall, in the order of the walls, forwards or backwards: flows of different bodies at walls do not meet. */
static void flow_walls(const struct vti_sweep *s)
{
    const vti_walls *walls = s->p->walls;
    const int64_t first = s->b->first, count = vti_faces(walls);
    struct vti_touch touch;
    struct vti_at_wall at;
    at.count = 0;
    for (int64_t k = 0; k < count; ++k) {
        at.wall = s->drift < 0.0 ? count - 1 - k : k;
        for (int64_t i = first; i < first + s->b->count; ++i)
            if (vti_touch_wall(&touch, walls, s->b, at.wall, i, s->p->reach))
                wait_at_wall(s, &touch, &at);
        flow_waiting(s, &at);
    }
}

static void flow(const void *self, const vti_bodies *b, double t, double drift)
{
    const vti_dashpots *p = self;
    const int pairs = p->contacts != NULL && p->contacts->count > 0;
    struct vti_sweep s = {.p = p, .b = b, .t = t, .drift = drift};
    struct window w;
    if (vti_has(&b->moments)) {
        vti_dashpots_flow_joints(p, NULL, b, t, drift);
        return;
    }
    w.count = 0;
    vti_damping_all(p, s.damped);
    if (drift < 0.0)
        flow_walls(&s);
    if (pairs && drift < 0.0)
        flow_backwards(&s, &w);
    else if (pairs)
        flow_forwards(&s, &w);
    if (!(drift < 0.0))
        flow_walls(&s);
}

/* ---- restitution ------------------------------------------------------------------------------------------------- */

/** atan(sqrt(s))/sqrt(s), atanh(sqrt(-s))/sqrt(-s) of s > -1: halved by atan x = 2 atan(x/(1 + sqrt(1 + x^2))) until
 *  the series 1 - s/3 + s^2/5 - ... ends at s^8 < 2^-60. */
static double arc(double s)
{
    double factor = 1.0, sum = 0.0;
    while (fabs(s) > 1.0 / 256.0) {
        const double half = 1.0 + sqrt(1.0 + s);
        factor *= 2.0 / half;
        s /= half * half;
    }
    for (int n = 8; n >= 0; --n)
        sum = 1.0 / (2 * n + 1) - s * sum;
    return factor * sum;
}

/** e of zeta: with arccos(zeta)/sqrt(1 - zeta^2) = (2/(1 + zeta)) atan(sqrt(s))/sqrt(s), s = (1 - zeta)/(1 + zeta) */
static double restitution(double zeta, int64_t pull)
{
    const double pi = 3.14159265358979323846;
    if (pull)
        return vti_decay(pi * zeta / sqrt((1.0 - zeta) * (1.0 + zeta))).kept;
    return vti_decay(4.0 * zeta / (1.0 + zeta) * arc((1.0 - zeta) / (1.0 + zeta))).kept;
}

double vti_dashpots_zeta(double e, int64_t pull)
{
    double low = 0.0, high = 1.0;
    if (!(e > 0.0 && e <= 1.0))
        return NAN;
    while (!pull && high < 1e12 && restitution(high, pull) > e)
        high *= 2.0;
    for (int k = 0; k < 100; ++k) { /* halved until no number is left between them */
        const double middle = 0.5 * (low + high);
        if (restitution(middle, pull) > e)
            low = middle;
        else
            high = middle;
    }
    return e < 1.0 ? high : 0.0;
}

/* ---- the effect -------------------------------------------------------------------------------------------------- */

static int check(const void *self, const vti_bodies *b)
{
    const vti_dashpots *p = self;
    const double all[] = {p->zeta, p->normal, p->tangential, p->ratio, p->rolling, p->twisting};
    int good = p->reach >= 0.0;
    for (int k = 0; k < 6; ++k)
        good &= isfinite(all[k]) && all[k] >= 0.0;
    for (int64_t w = 0; p->wall_zeta != NULL && w < vti_faces(p->walls); ++w)
        good &= isfinite(p->wall_zeta[w]) && p->wall_zeta[w] >= 0.0;
    if (!good)
        return VTI_E_DAMPING;
    if (p->contacts != NULL &&
        (p->contacts->diameter.p == NULL || (p->contacts->count > 0 && p->contacts->pair == NULL)))
        return VTI_E_NULL;
    return vti_has(&b->omega) && !vti_has(&b->moments) && b->inertia.p == NULL ? VTI_E_INERTIA : VTI_OK;
}

vti_effect vti_dashpots_effect(const vti_dashpots *dashpots)
{
    static const char *const book[VTI_DASHPOT_BOOKS] = {"lost_dashpot_normal", "lost_dashpot_tangential",
                                                        "lost_dashpot_rolling", "lost_dashpot_twisting"};
    const vti_dashpots *p = dashpots;
    if (p == NULL || p->lost == NULL || (p->contacts == NULL && p->walls == NULL))
        return vti_effect_none();
    const int turns = p->rolling > 0.0 || p->twisting > 0.0, slides = p->tangential > 0.0 || p->ratio > 0.0;
    int64_t breaks = turns || slides ? 0700 : 0;
    if (p->walls != NULL)
        breaks |= turns || slides ? 0777 : vti_walls_effect(p->walls).breaks;
    const vti_effect effect = {.name = "dashpot",
                               .check = check,
                               .springs = vti_springs_none,
                               .flow = flow,
                               .flow_clumps = vti_dashpots_flow_joints,
                               .self = p,
                               .needs = 1 << VTI_QUANTITY_X | 1 << VTI_QUANTITY_V | 1 << VTI_QUANTITY_MASS |
                                        (turns ? 1 << VTI_QUANTITY_OMEGA : 0),
                               .breaks = breaks,
                               .dissipates = 1,
                               .books = p->twisting > 0.0  ? 4
                                        : p->rolling > 0.0 ? 3
                                        : slides           ? 2
                                                           : 1,
                               .book = book,
                               .booked = p->lost};
    return effect;
}
