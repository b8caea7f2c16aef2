/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Pairs of bodies as lanes, a pair to a lane: where they are and what they have, from any layout, and the way back.
 * Included by vti_touch_kernels.h only. */
#ifndef VTI_TOUCH_GATHER_H
#define VTI_TOUCH_GATHER_H

#include "../lanes/vti_lanes.h"

#include "vti_face.h"
#include "vti_touch_motion.h"
#include "vti_touch_table.h"

/** PACKED: all vectors lie as x[n][3]. ANY: whatever the views say. */
enum touch_layout { ANY, PACKED };

/** act(layout, ...): literal arguments, so that each layout has code of its own. */
#define BY_LAYOUT(is_packed, act, ...) ((is_packed) ? act(PACKED, __VA_ARGS__) : act(ANY, __VA_ARGS__))

static inline int is_packed(const vti_bodies *b)
{
    return vti_is_packed(&b->x) && vti_is_packed(&b->v) && (!vti_has(&b->omega) || vti_is_packed(&b->omega));
}

/** Bodies of one side of the pairs. */
struct side {
    int64_t body[WIDTH], packed[WIDTH]; /* their numbers; where their vectors begin, if they lie packed */
};

VTI_INLINE void sides_of(const int64_t *list, int64_t base, const int64_t *which, struct side *i, struct side *j)
{
    for (int l = 0; l < WIDTH; ++l) {
        i->body[l] = list[2 * which[l]] - base;
        j->body[l] = list[2 * which[l] + 1] - base;
        i->packed[l] = 3 * i->body[l];
        j->packed[l] = 3 * j->body[l];
    }
}

/** One body to a lane. */
VTI_INLINE void side_of(const int64_t body[WIDTH], struct side *i)
{
    for (int l = 0; l < WIDTH; ++l) {
        i->body[l] = body[l];
        i->packed[l] = 3 * body[l];
    }
}

VTI_INLINE void times(const struct side *side, int64_t stride, int64_t at[WIDTH])
{
    for (int l = 0; l < WIDTH; ++l)
        at[l] = side->body[l] * stride;
}

VTI_INLINE void gather(enum touch_layout layout, const vti_view *view, const struct side *side, lanes r[3])
{
    int64_t at[WIDTH];
    if (layout == PACKED) {
        lanes_triples(view->c[0], side->packed, r);
        return;
    }
    times(side, view->stride, at);
    for (int k = 0; k < 3; ++k)
        r[k] = lanes_gather(view->c[k], at);
}

/** a_i - a_j */
VTI_INLINE void gather_difference(enum touch_layout layout, const vti_view *view, const struct side *i,
                                  const struct side *j, lanes r[3])
{
    lanes a[3];
    gather(layout, view, i, r);
    gather(layout, view, j, a);
    for (int k = 0; k < 3; ++k)
        r[k] -= a[k];
}

VTI_INLINE void scatter(enum touch_layout layout, const vti_view *view, const struct side *side, const lanes r[3])
{
    int64_t at[WIDTH];
    if (layout == PACKED) {
        lanes_untriple(view->c[0], side->packed, r);
        return;
    }
    times(side, view->stride, at);
    for (int k = 0; k < 3; ++k)
        lanes_scatter(view->c[k], at, r[k]);
}

/** To one body. */
VTI_INLINE void add_row(enum touch_layout layout, const vti_view *view, int64_t i, const double row[3])
{
    if (layout == PACKED)
        triple_store(view->c[0] + 3 * i, triple_plus(triple_load(view->c[0] + 3 * i), triple_load(row)));
    else
        vti_add(view, i, row);
}

VTI_INLINE lanes scalars(const vti_scalars *s, const struct side *side)
{
    int64_t at[WIDTH];
    if (s->stride == 0)
        return lanes_of(*s->p);
    times(side, s->stride, at);
    return lanes_gather(s->p, at);
}

/** The length from which on they touch, as vti_contact_length has it. */
VTI_INLINE lanes gather_length(const vti_contacts *p, const int64_t *which, lanes diameter_i, lanes diameter_j)
{
    double each[WIDTH];
    if (p->length.p == NULL)
        return 0.5 * diameter_i + 0.5 * diameter_j;
    for (int l = 0; l < WIDTH; ++l)
        each[l] = vti_scalar(&p->length, which[l]);
    return lanes_load(each);
}

/** K, as vti_contact_stiffness has it. */
VTI_INLINE lanes gather_stiffness(const vti_contacts *p, const struct side *i, const struct side *j, lanes length)
{
    double each[WIDTH];
    if (p->modulus.p == NULL)
        return lanes_of(p->stiffness);
    for (int l = 0; l < WIDTH; ++l)
        each[l] = vti_contact_stiffness(p, i->body[l], j->body[l], lanes_get(length, l));
    return lanes_load(each);
}

/** Pairs of one diameter and one stiffness: with a copy that says so literally, what they do not have takes no
 *  instruction. */
VTI_INLINE int are_alike(const vti_contacts *p)
{
    return p->length.p == NULL && p->modulus.p == NULL && p->diameter.stride == 0;
}

VTI_INLINE vti_contacts alike_of(const vti_contacts *p)
{
    vti_contacts alike = *p;
    alike.length = alike.modulus = (vti_scalars){NULL, 0, 0};
    alike.diameter = vti_scalars_one(p->diameter.p);
    return alike;
}

/** The WIDTH pairs from the first on; where count ends before, the last one is repeated, in place. */
VTI_INLINE const int64_t *whole(const int64_t *which, int64_t first, int64_t count, int64_t place[WIDTH])
{
    if (first + WIDTH <= count)
        return which + first;
    for (int l = 0; l < WIDTH; ++l)
        place[l] = which[first + l < count ? first + l : count - 1];
    return place;
}

/** Where pairs touch; sides become theirs. */
VTI_INLINE void gather_touches(enum touch_layout layout, const vti_contacts *p, const vti_bodies *b,
                               const int64_t *which, struct vti_touch *at, struct side *i, struct side *j)
{
    lanes d[3];
    sides_of(p->pair, p->base, which, i, j);
    at->i = at->j = 0;
    at->moves = 0;
    gather_difference(layout, &b->x, i, j, d);
    const lanes diameter_i = scalars(&p->diameter, i), diameter_j = scalars(&p->diameter, j);
    at->length = gather_length(p, which, diameter_i, diameter_j);
    at->stiffness = gather_stiffness(p, i, j, at->length);
    /* of one diameter D/(D + D) is exact */
    vti_touch_between(at, d, p->diameter.stride == 0 ? lanes_of(0.5) : diameter_i / (diameter_i + diameter_j));
}

/** K of bodies at wall w, as vti_face_stiffness has it. */
VTI_INLINE lanes gather_stiffness_at(const vti_walls *p, int64_t w, const struct side *i, lanes radius)
{
    double each[WIDTH];
    if (p->modulus.p == NULL)
        return lanes_of(vti_face_stiffness(p, w, 0, 0.0));
    for (int l = 0; l < WIDTH; ++l)
        each[l] = vti_face_stiffness(p, w, i->body[l], lanes_get(radius, l));
    return lanes_load(each);
}

/** Where bodies touch wall w, at x. */
VTI_INLINE void gather_at_wall(enum touch_layout layout, const vti_walls *p, const vti_bodies *b, int64_t w,
                               const struct side *i, struct vti_touch *at, lanes x[3])
{
    gather(layout, &b->x, i, x);
    vti_face_touch(at, p, w, x, 0.5 * scalars(&p->diameter, i));
    at->stiffness = gather_stiffness_at(p, w, i, at->length);
    vti_face_move(at, p, x);
}

/** Where loads stand in vti_held, in numbers. */
enum {
    SLIDING_AT = offsetof(vti_held, sliding) / sizeof(double),
    ROLLING_AT = offsetof(vti_held, rolling) / sizeof(double),
    TWISTING_AT = offsetof(vti_held, twisting) / sizeof(double)
};

/** What the springs that there are hold, 0 of others; it stands so many numbers behind the first. */
VTI_INLINE void gather_loads(const vti_friction *p, const vti_held *first, const int64_t at[WIDTH], struct vti_loads *f)
{
    const double *const table = (const double *)(const void *)first;
    for (int k = 0; k < 3; ++k)
        f->sliding[k] = f->rolling[k] = lanes_of(0.0);
    f->twisting = lanes_of(0.0);
    if (p->sliding > 0.0)
        lanes_triples(table + SLIDING_AT, at, f->sliding);
    if (p->rolling > 0.0)
        lanes_triples(table + ROLLING_AT, at, f->rolling);
    if (p->twisting > 0.0)
        f->twisting = lanes_gather(table + TWISTING_AT, at);
}

/** Where it stands, so. */
VTI_INLINE int64_t place_of(const vti_held *first, const vti_held *held)
{
    return (const double *)(const void *)held - (const double *)(const void *)first;
}

/** Those of WIDTH pairs from the first on; where count ends before, the last one is repeated. */
VTI_INLINE void whole_places(const vti_held *from, vti_held *const *held, int64_t first, int64_t count,
                             int64_t at[WIDTH])
{
    for (int l = 0; l < WIDTH; ++l)
        at[l] = place_of(from, held[first + l < count ? first + l : count - 1]);
}

/** What is booked of up to four motions: each a sum as vti_sum has it, all side by side. */
enum { BOOKS = 4 };
#if VTI_WIDTH > 1
typedef double book_row VECTOR(4);
typedef double book_row_there THERE(4);
#else
typedef double book_row, book_row_there;
#endif
enum { BOOK_ROWS = BOOKS * sizeof(double) / sizeof(book_row) };
struct books {
    book_row high[BOOK_ROWS], low[BOOK_ROWS];
};

VTI_INLINE void books_open(struct books *books, const vti_sum *from, int motions)
{
    double high[BOOKS] = {0.0}, low[BOOKS] = {0.0};
    for (int m = 0; m < motions; ++m) {
        high[m] = from[m].high;
        low[m] = from[m].low;
    }
    memcpy(books->high, high, sizeof high);
    memcpy(books->low, low, sizeof low);
}

VTI_INLINE void books_close(const struct books *books, vti_sum *to, int motions)
{
    double high[BOOKS], low[BOOKS];
    memcpy(high, books->high, sizeof high);
    memcpy(low, books->low, sizeof low);
    for (int m = 0; m < motions; ++m) {
        to[m].high = high[m];
        to[m].low = low[m];
    }
}

/** Adds of each motion the first count lanes, at most WIDTH, in their order. What rounding takes is exact whether or
 *  not one asks which number is the larger, as vti_sum_add does: the bits are those of that. */
VTI_INLINE void book_lanes(struct books *books, const lanes lost[BOOKS], int64_t count)
{
    double each[BOOKS * WIDTH];
    int64_t at[WIDTH];
    lanes_strided(BOOKS, at);
    lanes_unquad(each, at, lost);
    for (int l = 0; l < WIDTH && l < count; ++l)
        for (int m = 0; m < BOOK_ROWS; ++m) {
            const book_row a = ((const book_row_there *)(each + BOOKS * l))[m], high = books->high[m];
            const book_row sum = high + a, share = sum - high;
            books->low[m] += (high - (sum - share)) + (a - share);
            books->high[m] = sum;
        }
}

/** The same of one, a sum of its own. */
VTI_INLINE void sum_lanes(vti_sum *to, lanes a, int64_t count)
{
    for (int l = 0; l < WIDTH && l < count; ++l)
        vti_sum_add(to, lanes_get(a, l));
}

/** 1/m, or 1/J */
VTI_INLINE lanes per(const vti_scalars *s, const struct side *side)
{
    return s->stride == 0 ? lanes_of(1.0 / *s->p) : 1.0 / scalars(s, side);
}

/** Velocities, and what resists their change. */
VTI_INLINE void gather_velocities(enum touch_layout layout, const vti_bodies *b, const struct side *i,
                                  const struct side *j, struct vti_touch *touch, struct vti_touch_motion *m)
{
    const lanes zero = lanes_of(0.0);
    m->turns = vti_has(&b->omega);
    gather(layout, &b->v, i, m->v_i);
    gather(layout, &b->v, j, m->v_j);
    touch->per_m_i = per(&b->mass, i);
    touch->per_m_j = per(&b->mass, j);
    touch->per_j_i = touch->per_j_j = zero;
    for (int k = 0; k < 3; ++k)
        m->w_i[k] = m->w_j[k] = zero;
    if (!m->turns)
        return;
    gather(layout, &b->omega, i, m->w_i);
    gather(layout, &b->omega, j, m->w_j);
    touch->per_j_i = per(&b->inertia, i);
    touch->per_j_j = per(&b->inertia, j);
}

VTI_INLINE void scatter_velocities(enum touch_layout layout, const vti_bodies *b, const struct side *i,
                                   const struct side *j, const struct vti_touch_motion *m)
{
    scatter(layout, &b->v, i, m->v_i);
    scatter(layout, &b->v, j, m->v_j);
    if (!m->turns)
        return;
    scatter(layout, &b->omega, i, m->w_i);
    scatter(layout, &b->omega, j, m->w_j);
}

#endif
