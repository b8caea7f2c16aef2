/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Rigid walls (EQUATIONS 3, E4): Hertzian contact with a particle of radius zero at the foot point, o = [1 -
 * g/(D/2)]_+. Bodies are gone through once, some at a time, and each meets the walls in their order.
 *
 * A wall that moves at V puts in the work F.V t: at the ends of a drift half of it each, which is what the kicks there
 * give (EQUATIONS 6.1), so that the ledger is as good as that of a wall at rest. */
#include "vti_face.h"
#include "vti_touch_table.h"
#include "../vti_shares.h"
#include "../vti_ready.h"

/* ---- checks ------------------------------------------------------------------------------------------------------ */

static int is_unit(const double n[3])
{
    return fabs(vti_dot(n, n) - 1.0) < 1e-12;
}

/** Whether so many numbers are finite; else *value is the first that is not. */
static int are_finite(const double *numbers, int count, double *value)
{
    for (int k = 0; k < count; ++k)
        if (!isfinite(numbers[k])) {
            *value = numbers[k];
            return 0;
        }
    return 1;
}

static int is_list(const vti_walls *p)
{
    return (p->count <= 0 || p->plane != NULL) && (p->cylinders <= 0 || p->cylinder != NULL) &&
           (vti_faces(p) <= 0 || p->diameter.p != NULL) && (p->motion == NULL || p->work != NULL);
}

static int has_good_axis(const vti_walls *p, int64_t w, double *value)
{
    const double *const axis = vti_face_axis(p, w);
    const int is_plane = w < p->count;
    if (!are_finite(axis, is_plane ? 4 : 7, value))
        return 0;
    *value = sqrt(vti_dot(axis, axis));
    if (!is_unit(axis))
        return 0;
    *value = is_plane ? 1.0 : axis[6];
    return *value > 0.0;
}

/** Whether wall w has an axis of length 1, a positive radius, K and modulus that may be, and all else finite; else
 *  *value is what is wrong, of an axis its length. */
static int is_good(const vti_walls *p, int64_t w, double *value)
{
    const vti_wall_motion *const m = vti_face_motion(p, w);
    *value = p->each != NULL ? p->each[w] : p->stiffness;
    if (!(isfinite(*value) && *value >= 0.0))
        return 0;
    *value = p->moduli != NULL ? p->moduli[w] : 1.0;
    return vti_is_positive(*value) && has_good_axis(p, w, value) &&
           (m == NULL || (are_finite(m->velocity, 3, value) && are_finite(m->centre, 3, value) &&
                          are_finite(m->moved, 3, value) && are_finite(&m->spin, 1, value)));
}

/** The first wall that is not good, and in *value what is wrong with it; -1 if all are. */
static int64_t first_bad(const vti_walls *p, double *value)
{
    for (int64_t w = 0; w < vti_faces(p); ++w)
        if (!is_good(p, w, value))
            return w;
    return -1;
}

/** Whether K has one source. */
static int is_one(const vti_walls *p)
{
    return p->modulus.p == NULL || (p->each == NULL && p->stiffness == 0.0);
}

static int ends_or_is_bad(const vti_scalars *s, int64_t i)
{
    return vti_ends_before(s, i) || !vti_is_positive(vti_scalar(s, i));
}

/** vti_walls_check for the bodies first <= i < end. */
static int check_for(const vti_walls *walls, int64_t first, int64_t end, vti_fault *fault)
{
    double value;
    vti_refuse_none(VTI_OK, fault);
    if (walls == NULL || !is_list(walls))
        return VTI_E_NULL;
    if (walls->count < 0 || walls->cylinders < 0 || end < 0)
        return VTI_E_COUNT;
    const int64_t bad = first_bad(walls, &value);
    if (bad >= 0)
        return vti_refuse(VTI_E_CONTACT, bad, value, VTI_QUANTITY_NONE, fault);
    if (!is_one(walls))
        return vti_refuse(VTI_E_CONTACT, -1, walls->stiffness, VTI_QUANTITY_NONE, fault);
    for (int64_t i = first; vti_faces(walls) > 0 && i < end; ++i)
        if (ends_or_is_bad(&walls->diameter, i) || (walls->modulus.p != NULL && ends_or_is_bad(&walls->modulus, i)))
            return vti_refuse(VTI_E_CONTACT, -1, (double)i, VTI_QUANTITY_NONE, fault);
    return VTI_OK;
}

int vti_walls_check(const vti_walls *walls, int64_t n, vti_fault *fault)
{
    return check_for(walls, 0, n, fault);
}

/** Walls are few, and looked at always; of bodies a wall acts on those of the slice. */
int vti_walls_ready(const vti_walls *p, const vti_bodies *b)
{
    double value;
    if (VTI_LOOKS)
        return check_for(p, b->first, b->first + b->count, NULL);
    if (!is_list(p))
        return VTI_E_NULL;
    if (p->count < 0 || p->cylinders < 0)
        return VTI_E_COUNT;
    return first_bad(p, &value) < 0 && is_one(p) ? VTI_OK : VTI_E_CONTACT;
}

static int check(const void *self, const vti_bodies *b)
{
    return vti_walls_ready(self, b);
}

/* ---- forces ------------------------------------------------------------------------------------------------------ */

/** 1 - g/(D/2) of a body of that radius: positive if they touch; NaN if a number is, which must show. */
static inline double overlap(const vti_walls *p, int64_t w, const double x[3], double radius, double n[3])
{
    return 1.0 - vti_face_gap(p, w, x, n) / radius;
}

/** Of so many bodies at once the places stay in the first-level cache from wall to wall. */
enum { TOGETHER = 256 };

static void apply(const void *self, const vti_bodies *b)
{
    const vti_walls *p = self;
    const int64_t walls = vti_has(&b->force) ? vti_faces(p) : 0, last = b->first + b->count;
    for (int64_t first = b->first; first < last; first += TOGETHER) {
        const int64_t count = last - first < TOGETHER ? last - first : TOGETHER;
        for (int64_t w = 0; w < walls; ++w)
            vti_touch_kernels_for(count)->press_at(p, b, w, first, count);
    }
}

static void energy(const void *self, const vti_bodies *b, double *energies)
{
    const vti_walls *p = self;
    vti_sum sum = {0.0, 0.0};
    for (int64_t w = 0; w < vti_faces(p); ++w)
        for (int64_t i = b->first; i < b->first + b->count; ++i) {
            const double radius = 0.5 * vti_scalar(&p->diameter, i);
            double x[3], n[3];
            vti_load(&b->x, i, x);
            const double o = overlap(p, w, x, radius, n);
            if (!(o <= 0.0))
                vti_sum_add(&sum, vti_hertz_energy(vti_face_stiffness(p, w, i, radius), o));
        }
    energies[0] = vti_sum_value(&sum);
}

/** Every body at every wall, or those that touch one, as they do. */
static int springs(const void *self, const vti_bodies *b, const vti_deformation *at, vti_spring_visit *visit,
                   void *context)
{
    const vti_walls *p = self;
    for (int64_t w = 0; w < vti_faces(p); ++w)
        for (int64_t i = b->first; i < b->first + b->count; ++i) {
            const double radius = 0.5 * vti_scalar(&p->diameter, i);
            double x[3], n[3];
            vti_load(&b->x, i, x);
            const double o = at != NULL ? at->overlap : overlap(p, w, x, radius, n);
            const vti_spring s = {.element = w,
                                  .i = i,
                                  .j = -1,
                                  .length = radius,
                                  .axial = vti_hertz_stiffness(vti_face_stiffness(p, w, i, radius), o)};
            if (at != NULL || !(o <= 0.0))
                visit(context, &s);
        }
    return p->count < 0 || p->cylinders < 0 ? VTI_E_COUNT : VTI_OK;
}

/* ---- walls that move --------------------------------------------------------------------------------------------- */

/** F.V of wall w on body i at x. */
static double power(const vti_walls *p, int64_t w, const double x[3], int64_t i)
{
    double n[3];
    const double radius = 0.5 * vti_scalar(&p->diameter, i), o = overlap(p, w, x, radius, n);
    return o > 0.0 ? vti_hertz_force(vti_face_stiffness(p, w, i, radius), radius, o) * vti_dot(n, p->motion[w].velocity)
                   : 0.0;
}

/** What wall w puts into all bodies over a drift of time t, by whose beginning (at = 0) or end (1) the bodies and the
 *  wall are: each of the two is half of it. */
static void book(const vti_walls *p, int64_t w, const vti_bodies *b, double t, int at_end)
{
    for (int64_t i = b->first; i < b->first + b->count; ++i) {
        double x[3], v[3];
        vti_load(&b->x, i, x);
        vti_load(&b->v, i, v);
        for (int k = 0; k < 3 && !at_end; ++k)
            x[k] -= t * v[k];
        const double put_in = power(p, w, x, i);
        if (put_in != 0.0)
            vti_sum_add(p->work, -0.5 * t * put_in);
        if (put_in != 0.0 && p->by_body != NULL)
            vti_share(p->by_body, 1, 0, i, -1, -0.5 * t * put_in);
    }
}

static void carry(const void *self, const vti_bodies *b, const vti_drifted *drifted)
{
    const vti_walls *p = self;
    for (int64_t w = 0; p->motion != NULL && w < vti_faces(p); ++w) { /* they may have come to stand */
        vti_wall_motion *const m = &p->motion[w];
        if (vti_dot(m->velocity, m->velocity) == 0.0)
            continue;
        book(p, w, b, drifted->t, 0);
        for (int k = 0; k < 3; ++k)
            m->moved[k] += drifted->t * m->velocity[k];
        book(p, w, b, drifted->t, 1);
    }
}

/* ---- the effect -------------------------------------------------------------------------------------------------- */

/** Forces across an axis through the origin keep momentum along it, linear and angular, if it is x, y or z, and has not
 *  left it. */
static int64_t broken_by_cylinder(const double cylinder[7], const vti_wall_motion *m)
{
    const int64_t all = VTI_BREAKS_LINEAR | VTI_BREAKS_ANGULAR;
    for (int k = 0; k < 3; ++k) {
        const int across[2] = {(k + 1) % 3, (k + 2) % 3};
        int is_axis = 1, stays = 1;
        for (int j = 0; j < 2; ++j) {
            is_axis &= cylinder[across[j]] == 0.0;
            stays &= cylinder[3 + across[j]] == 0.0 &&
                     (m == NULL || (m->velocity[across[j]] == 0.0 && m->moved[across[j]] == 0.0));
        }
        if (is_axis)
            return all & ~(INT64_C(1) << k) & ~(stays ? INT64_C(8) << k : 0);
    }
    return all;
}

static int64_t broken_by(const vti_walls *p)
{
    int64_t breaks = 0;
    for (int64_t w = 0; w < vti_faces(p); ++w)
        breaks |= w < p->count ? vti_broken_along(vti_face_axis(p, w))
                               : broken_by_cylinder(vti_face_axis(p, w), vti_face_motion(p, w));
    return breaks;
}

vti_effect vti_walls_effect(const vti_walls *walls)
{
    static const char *const term[] = {"wall"}, *const entry[] = {"work_wall"};
    if (walls == NULL || !is_list(walls))
        return vti_effect_none();
    const int moves = walls->motion != NULL;
    const vti_effect effect = {.name = "wall",
                               .apply = apply,
                               .energy = energy,
                               .check = check,
                               .springs = springs,
                               .carry = moves ? carry : NULL,
                               .self = walls,
                               .needs = 1 << VTI_QUANTITY_X | (moves ? 1 << VTI_QUANTITY_V : 0),
                               .gives = 1 << VTI_QUANTITY_FORCE,
                               .terms = 1,
                               .term = term,
                               .breaks = broken_by(walls),
                               .books = moves,
                               .book = entry,
                               .booked = walls->work,
                               .by_body = walls->by_body,
                               .of_body = moves};
    return effect;
}

double vti_walls_stiffness(const vti_walls *walls, int64_t w, int64_t i)
{
    if (walls == NULL || !is_list(walls) || w < 0 || w >= vti_faces(walls) || i < 0 ||
        vti_ends_before(&walls->diameter, i) || vti_ends_before(&walls->modulus, i))
        return NAN;
    return vti_face_stiffness(walls, w, i, 0.5 * vti_scalar(&walls->diameter, i));
}

double vti_walls_gap(const vti_walls *walls, int64_t w, const double x[3], double n[3])
{
    if (walls == NULL || x == NULL || n == NULL || !is_list(walls) || w < 0 || w >= vti_faces(walls))
        return NAN;
    return vti_face_gap(walls, w, x, n);
}
