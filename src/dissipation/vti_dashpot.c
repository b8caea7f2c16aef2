/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Dashpots of contacts and walls as flows of velocities: the order of the touches (EQUATIONS 6.4), restitution, and the
 * effect. What a touch does is in vti_dashpot_flow.h. */
#include "vti_colour.h"
#include "vti_dashpot_flow.h"
#include "vti_joint.h"
#include "../vti_shares.h"
#include "../contacts/vti_touch.h"
#include "../contacts/vti_touch_table.h"
#include "../vti_ready.h"

/* ---- pairs ------------------------------------------------------------------------------------------------------- */

/** So many pairs within reach are found at once at most. */
enum { FOUND = 8 * VTI_WINDOW };

struct places {
    int64_t found[FOUND]; /* in the order of the list, as vti_touch_kernels.near has them */
    int64_t guess[VTI_GUESSES];
    struct vti_window window;
};

static int64_t least_of(int64_t a, int64_t b)
{
    return a < b ? a : b;
}

/** Of so many pairs, VTI_TOUCHES at most, no two of which share a body, those that overlap, or will at the other end of
 *  the drift, in their order: returns how many. */
static int64_t touching(const struct vti_sweep *s, int64_t count, const int64_t *found, int64_t pair[VTI_TOUCHES])
{
    int64_t apart[VTI_TOUCHES], closing[VTI_TOUCHES], gaps = 0, next = 0, all = 0;
    for (int64_t n = 0; n < count; ++n) {
        pair[n] = apart[gaps] = vti_touch_number(found[n]);
        gaps += found[n] < 0;
    }
    if (gaps == 0)
        return count;
    const int64_t late = vti_touch_kernels_for(gaps)->soon(s, gaps, apart, closing);
    for (int64_t n = 0; n < count; ++n) {
        const int closes = next < late && closing[next] == pair[n];
        pair[all] = pair[n];
        all += found[n] >= 0 || closes;
        next += closes;
    }
    return all;
}

/** So many pairs of one colour in this order, at most so many at once. */
static void flow_colour(const void *sweep, const int64_t *found, int64_t count, int64_t most)
{
    const struct vti_sweep *const s = sweep;
    int64_t pair[VTI_TOUCHES];
    for (int64_t first = 0; first < count; first += most) {
        const int64_t all = touching(s, least_of(count - first, most), found + first, pair);
        if (all > 0)
            vti_touch_kernels_for(all)->flow(s, all, pair);
    }
}

/** The same one by one, so that what each pair loses is known. */
static void flow_singly(const void *sweep, const int64_t *found, int64_t count, int64_t most)
{
    const struct vti_sweep *const s = sweep;
    vti_dashpots own = *s->p;
    struct vti_sweep one = *s;
    (void)most;
    one.p = &own;
    for (int64_t n = 0; n < count; ++n) {
        vti_sum lost[VTI_DASHPOT_BOOKS] = {{0.0, 0.0}};
        int64_t pair[VTI_TOUCHES];
        own.lost = lost;
        if (touching(&one, 1, found + n, pair) == 0)
            continue;
        vti_touch_kernels_for(1)->flow(&one, 1, pair);
        vti_share_out(lost, VTI_DASHPOT_BOOKS, s->p->lost, s->p->by_body, vti_contact_body(own.contacts, pair[0], 0),
                      vti_contact_body(own.contacts, pair[0], 1));
    }
}

/** Finds what springs hold in the order of the list, in which it lies in memory, but that the friction's list may have
 *  a few pairs between them. */
static void find_held(const struct vti_sweep *s, const int64_t *found, int64_t count, int64_t guess[VTI_GUESSES])
{
    const vti_history *const history = s->p->friction->history;
    const vti_contacts *const list = s->p->contacts;
    const int64_t few = 4;
    int64_t next = history->used;
    for (int64_t n = 0; n < count; ++n) {
        const int64_t k = vti_touch_number(found[n]);
        vti_history_next(history, 1 + vti_contact_body(list, k, 0), 1 + vti_contact_body(list, k, 1), few, &next);
        guess[k % VTI_GUESSES] = next - 1;
    }
}

/** Forwards or backwards. */
static void flow_window(const struct vti_sweep *s, struct places *w, const int64_t *found, int64_t count)
{
    if (s->guess != NULL)
        find_held(s, found, count, w->guess);
    vti_window_work(&w->window, s->p->contacts->pair, found, count, s->drift < 0.0,
                    s->p->by_body == NULL ? flow_colour : flow_singly, s);
}

/** Windows from the first pair on. */
static void flow_forwards(const struct vti_sweep *s, struct places *w)
{
    const vti_contacts *const list = s->p->contacts;
    const struct vti_touch_kernels *const kernels = vti_touch_kernels_for(list->count);
    int64_t count = 0;
    for (int64_t first = 0, most; first < list->count; first += most) {
        int64_t done = 0;
        most = least_of(list->count - first, FOUND - count);
        count += kernels->near(list, s->b, s->p->reach, first, most, w->found + count);
        for (; count - done >= VTI_WINDOW; done += VTI_WINDOW)
            flow_window(s, w, w->found + done, VTI_WINDOW);
        count -= done;
        memmove(w->found, w->found + done, (size_t)count * sizeof *w->found);
    }
    if (count > 0)
        flow_window(s, w, w->found, count);
}

/** How many pairs the last of the windows of so many has. */
static int64_t last_window(int64_t all)
{
    return (all - 1) % VTI_WINDOW + 1;
}

/** The same windows from the last on, of a list of which all pairs are found at once. */
static void flow_few_backwards(const struct vti_sweep *s, struct places *w)
{
    const vti_contacts *const list = s->p->contacts;
    int64_t all = vti_touch_kernels_for(list->count)->near(list, s->b, s->p->reach, 0, list->count, w->found);
    while (all > 0) {
        const int64_t size = last_window(all);
        all -= size;
        flow_window(s, w, w->found + all, size);
    }
}

/** And of any other. */
static void flow_many_backwards(const struct vti_sweep *s, struct places *w)
{
    const vti_contacts *const list = s->p->contacts;
    const struct vti_touch_kernels *const kernels = vti_touch_kernels_for(list->count);
    int64_t all = kernels->near(list, s->b, s->p->reach, 0, list->count, NULL), count = 0;
    for (int64_t end = list->count, most; all > 0; end -= most) { /* from the window's end on */
        const int64_t size = last_window(all), free = size - count;
        most = least_of(end, free);
        const int64_t found = kernels->near(list, s->b, s->p->reach, end - most, most, w->window.sorted);
        memcpy(w->found + free - found, w->window.sorted, (size_t)found * sizeof *w->found);
        count += found;
        if (count < size)
            continue;
        flow_window(s, w, w->found, size);
        all -= size;
        count = 0;
    }
}

/* ---- walls ------------------------------------------------------------------------------------------------------- */

/** Whether somebody asks what each body loses at walls, or takes from them. */
static int tells(const vti_dashpots *p)
{
    return p->by_body != NULL || p->walls->by_body != NULL;
}

/** Body i, so that what it loses is known. */
static void flow_singly_at(const struct vti_sweep *s, int64_t w, int64_t i)
{
    vti_sum lost[VTI_DASHPOT_BOOKS] = {{0.0, 0.0}}, work = {0.0, 0.0};
    vti_dashpots own = *s->p;
    vti_walls walls = *s->p->walls;
    struct vti_sweep one = *s;
    one.p = &own;
    own.lost = lost;
    own.walls = &walls;
    walls.work = &work;
    vti_touch_kernels_for(1)->flow_at(&one, w, 1, &i);
    vti_share_out(lost, VTI_DASHPOT_BOOKS, s->p->lost, s->p->by_body, i, -1);
    if (walls.motion != NULL)
        vti_share_out(&work, 1, s->p->walls->work, s->p->walls->by_body, i, -1);
}

/** All bodies at wall w, in their order: as many at once as a kernel takes. */
static void flow_wall(const struct vti_sweep *s, int64_t w)
{
    const vti_walls *const walls = s->p->walls;
    const int64_t end = s->b->first + s->b->count;
    const int single = tells(s->p);
    int64_t body[2 * VTI_TOUCHES], waiting = 0;
    for (int64_t i = s->b->first; i < end; i += VTI_TOUCHES) {
        const int64_t some = least_of(end - i, VTI_TOUCHES);
        uint64_t near = vti_touch_kernels_for(some)->near_wall(walls, s->b, s->p->reach, 0.0, w, i, some);
        for (; near != 0; near &= near - 1)
            body[waiting++] = i + vti_first_bit(near);
        if (waiting < VTI_TOUCHES && i + VTI_TOUCHES < end)
            continue;
        for (int64_t k = 0; single && k < waiting; ++k)
            flow_singly_at(s, w, body[k]);
        if (!single && waiting > 0)
            vti_touch_kernels_for(waiting)->flow_at(s, w, waiting, body);
        waiting = 0;
    }
}

/** Wall by wall, in the order of the walls, forwards or backwards: flows of different bodies at walls do not meet. */
static void flow_walls(const struct vti_sweep *s)
{
    const int64_t count = vti_faces(s->p->walls);
    for (int64_t k = 0; k < count; ++k)
        flow_wall(s, s->drift < 0.0 ? count - 1 - k : k);
}

/** Whether springs hold so much that it pays to know where it stands. */
static int has_many(const vti_friction *friction)
{
    return friction != NULL && friction->history != NULL && friction->history->used > 1024;
}

static void flow(const void *self, const vti_bodies *b, double t, double drift)
{
    const vti_dashpots *p = self;
    const int pairs = p->contacts != NULL && p->contacts->count > 0;
    struct vti_sweep s = {.p = p, .b = b, .t = t, .drift = drift};
    struct places w;
    if (vti_has(&b->moments)) {
        vti_dashpots_flow_joints(p, NULL, b, t, drift);
        return;
    }
    vti_damping_all(p, s.damped);
    if (has_many(p->friction)) {
        memset(w.guess, 0, sizeof w.guess);
        s.guess = w.guess;
    }
    if (drift < 0.0)
        flow_walls(&s);
    if (pairs && !(drift < 0.0))
        flow_forwards(&s, &w);
    else if (pairs && p->contacts->count <= FOUND)
        flow_few_backwards(&s, &w);
    else if (pairs)
        flow_many_backwards(&s, &w);
    if (!(drift < 0.0))
        flow_walls(&s);
}

/* ---- restitution ------------------------------------------------------------------------------------------------- */

/** atan(sqrt(s))/sqrt(s), atanh(sqrt(-s))/sqrt(-s) of s = t - 1 > -1: halved by atan x = 2 atan(x/(1 + sqrt(1 + x^2))),
 *  by which t becomes 2 sqrt(t)/(1 + sqrt(t)), until the series 1 - s/3 + s^2/5 - ... ends at s^8 < 2^-60. */
static double arc(double t)
{
    double factor = 1.0, sum = 0.0;
    while (fabs(t - 1.0) > 1.0 / 256.0) {
        const double root = sqrt(t), half = 1.0 + root;
        factor *= 2.0 / half;
        t = 2.0 * root / half;
    }
    for (int n = 8; n >= 0; --n)
        sum = 1.0 / (2 * n + 1) - (t - 1.0) * sum;
    return factor * sum;
}

/** e of zeta: with arccos(zeta)/sqrt(1 - zeta^2) = (2/(1 + zeta)) atan(sqrt(s))/sqrt(s), s = 2/(1 + zeta) - 1 */
static double restitution(double zeta, int64_t pull)
{
    const double pi = 3.14159265358979323846;
    if (pull)
        return vti_decay(pi * zeta / sqrt((1.0 - zeta) * (1.0 + zeta))).kept;
    return vti_decay(4.0 * zeta / (1.0 + zeta) * arc(2.0 / (1.0 + zeta))).kept;
}

double vti_dashpots_zeta(double e, int64_t pull)
{
    double low = 0.0, high = 1.0;
    if (!(e > 0.0 && e <= 1.0))
        return NAN;
    while (!pull && restitution(high, pull) > e)
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

/** Of both bodies of a pair, whatever the motion. */
static const int64_t needs = 1 << VTI_QUANTITY_X | 1 << VTI_QUANTITY_V | 1 << VTI_QUANTITY_MASS;

/** Whether they turn bodies, and whether they brake what slides. */
static int turns(const vti_dashpots *p)
{
    return p->rolling > 0.0 || p->twisting > 0.0;
}

static int slides(const vti_dashpots *p)
{
    return p->tangential > 0.0 || p->ratio > 0.0;
}

static int check(const void *self, const vti_bodies *b)
{
    const vti_dashpots *p = self;
    const double all[] = {p->zeta, p->normal, p->tangential, p->ratio, p->rolling, p->twisting};
    int good = p->reach > 0.0 && (p->friction == NULL || vti_friction_has_limits(p->friction, p->walls));
    for (int k = 0; k < 6; ++k)
        good &= isfinite(all[k]) && all[k] >= 0.0;
    for (int64_t w = 0; p->wall_zeta != NULL && w < vti_faces(p->walls); ++w)
        good &= isfinite(p->wall_zeta[w]) && p->wall_zeta[w] >= 0.0;
    if (!good)
        return VTI_E_DAMPING;
    if (turns(p) && !vti_has(&b->omega))
        return VTI_E_NEEDS;
    if (p->lost == NULL)
        return VTI_E_NULL;
    const int status = vti_touches_ready(p->contacts, p->walls, b, needs);
    return status != VTI_OK ? status : vti_inertia_check(b);
}

vti_effect vti_dashpots_effect(const vti_dashpots *dashpots)
{
    static const char *const book[VTI_DASHPOT_BOOKS] = {"lost_dashpot_normal", "lost_dashpot_tangential",
                                                        "lost_dashpot_rolling", "lost_dashpot_twisting"};
    const vti_dashpots *p = dashpots;
    if (p == NULL || p->lost == NULL || (p->contacts == NULL && p->walls == NULL))
        return vti_effect_none();
    const int rubs = turns(p) || slides(p);
    int64_t breaks = rubs ? VTI_BREAKS_SPINS : 0;
    if (p->walls != NULL)
        breaks |= rubs ? VTI_BREAKS_LINEAR | VTI_BREAKS_ANGULAR | VTI_BREAKS_SPINS : vti_walls_effect(p->walls).breaks;
    const vti_effect effect = {.name = "dashpot",
                               .check = check,
                               .springs = vti_springs_none,
                               .flow = flow,
                               .flow_clumps = vti_dashpots_flow_joints,
                               .self = p,
                               .needs = needs | (turns(p) ? 1 << VTI_QUANTITY_OMEGA : 0),
                               .breaks = breaks,
                               .dissipates = 1,
                               .books = p->twisting > 0.0  ? 4
                                        : p->rolling > 0.0 ? 3
                                        : slides(p)        ? 2
                                                           : 1,
                               .book = book,
                               .booked = p->lost,
                               .by_body = p->by_body,
                               .of_body = VTI_DASHPOT_BOOKS};
    return effect;
}
