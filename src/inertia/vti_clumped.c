/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Wraps an effect on the spheres of clumps as an effect on the clumps (EQUATIONS 7.5). */
#include "vti_clump_spheres.h"
#include "../vti_moments.h"
#include "../vti_ready.h"

static int check(const void *self, const vti_bodies *b)
{
    const vti_clumped *p = self;
    const int status = vti_clump_ready(p->clumps, b);
    if (status != VTI_OK)
        return status;
    if (p->effect->flow != NULL && p->effect->flow_clumps == NULL)
        return VTI_E_CLUMP;
    if (p->effect->flow != NULL && vti_has(&b->v) && b->mass.p == NULL)
        return VTI_E_MASS;
    if (p->effect->flow != NULL && vti_inertia_check(b) != VTI_OK)
        return VTI_E_INERTIA;
    if (VTI_LOOKS) /* at where the spheres will be */
        vti_clump_spread(p->clumps, b, 0, p->clumps->count);
    return vti_effects_fault(p->effect, 1, &p->clumps->spheres, NULL);
}

/** All spheres where they are; returns those of the slice. */
static vti_bodies place(const vti_clumps *c, const vti_bodies *b)
{
    vti_clump_spread(c, b, 0, c->count);
    return vti_clumps_spheres(c, b);
}

static void apply(const void *self, const vti_bodies *b)
{
    const vti_clumped *p = self;
    const vti_bodies spheres = place(p->clumps, b);
    vti_apply(p->effect, 1, &spheres);
    vti_clump_gather(p->clumps, b, spheres.first, spheres.first + spheres.count);
}

static void energy(const void *self, const vti_bodies *b, double *energies)
{
    const vti_clumped *p = self;
    const vti_bodies spheres = place(p->clumps, b);
    p->effect->energy(p->effect->self, &spheres, energies);
}

static void flow(const void *self, const vti_bodies *b, double t, double drift)
{
    const vti_clumped *p = self;
    vti_clump_spread(p->clumps, b, 0, p->clumps->count);
    p->effect->flow_clumps(p->effect->self, p->clumps, b, t, drift);
}

static int64_t rupture(const void *self, const vti_bodies *b)
{
    const vti_clumped *p = self;
    const vti_bodies spheres = place(p->clumps, b);
    return p->effect->rupture(p->effect->self, &spheres);
}

/** v_s = v + (r - r before)/t, so that t v_s is the way that the sphere has come, along an arc. */
static void put_chord(const vti_clumps *c, const vti_bodies *b, const vti_drifted *drifted, int64_t s)
{
    const int64_t i = c->body[s] - c->base;
    double r[3], before[3], omega[3], turn[3], v[3];
    vti_clump_lever(c, b, s, i, r);
    if (vti_spins_generally(b))
        vti_rotor_turned(b, i, drifted, 0, turn);
    else {
        vti_load_or_zero(&b->omega, i, omega);
        vti_drift_increment((int)drifted->law, drifted->t, omega, turn);
    }
    vti_rrv_rotate_back(turn, r, before);
    vti_load_or_zero(&b->v, i, v);
    for (int k = 0; k < 3; ++k)
        v[k] += (r[k] - before[k]) / drifted->t;
    vti_store(&c->spheres.v, s, v);
}

static void carry(const void *self, const vti_bodies *b, const vti_drifted *drifted)
{
    const vti_clumped *p = self;
    const vti_bodies spheres = place(p->clumps, b);
    for (int64_t s = 0; s < p->clumps->count && vti_has(&spheres.v) && drifted->t != 0.0; ++s)
        put_chord(p->clumps, b, drifted, s);
    vti_drifted of_spheres = *drifted;
    of_spheres.clumps = p->clumps;
    of_spheres.bodies = b;
    p->effect->carry(p->effect->self, &spheres, &of_spheres);
    vti_clump_spread(p->clumps, b, 0, p->clumps->count);
}

/* ---- springs (EQUATIONS 5) --------------------------------------------------------------------------------------- */

struct levered {
    const vti_clumps *clumps;
    vti_spring_visit *visit;
    void *context;
    double deformed; /* of springs, as a share of their length */
};

/** A force F at r = R rho holds its body against turning, as the weight of a pendulum does: of the energy -F.R rho the
 *  second derivative is at most |F||rho|. element: of the effect that gives it; -1 of all of them. */
static void show_pull(const struct levered *l, int64_t element, int64_t s, double force)
{
    const double stiffness = force * vti_norm(l->clumps->offset + 3 * s);
    const vti_spring pull = {.element = element,
                             .i = l->clumps->body[s] - l->clumps->base,
                             .j = -1,
                             .length = 1.0,
                             .bend = stiffness,
                             .twist = stiffness};
    if (stiffness != 0.0)
        l->visit(l->context, &pull);
}

/** The spring between spheres as one between their bodies. Its own pull, while it is deformed by the share d of its
 *  length, is at most d K/L, as it is none that softens. Two spheres of one body do not move against each other. */
static void show_levered(void *context, const vti_spring *between)
{
    const struct levered *l = context;
    const vti_clumps *c = l->clumps;
    vti_spring s = *between;
    if (s.i < 0 || s.i >= c->count || s.j >= c->count) {
        s.i = -1; /* no such sphere: a body that does not exist, which is refused */
        l->visit(l->context, &s);
        return;
    }
    const double pull = l->deformed > 0.0 ? l->deformed * (s.axial + s.shear) / s.length : 0.0;
    s.i = c->body[between->i] - c->base;
    s.lever_i += vti_norm(c->offset + 3 * between->i);
    if (between->j >= 0) {
        s.j = c->body[between->j] - c->base;
        s.lever_j += vti_norm(c->offset + 3 * between->j);
    }
    if (s.i == s.j)
        return;
    l->visit(l->context, &s);
    show_pull(l, between->element, between->i, pull);
    if (between->j >= 0)
        show_pull(l, between->element, between->j, pull);
}

static int springs(const void *self, const vti_bodies *b, const vti_deformation *at, vti_spring_visit *visit,
                   void *context)
{
    const vti_clumped *p = self;
    if (b->count == 0)
        return VTI_OK;
    const vti_bodies spheres = place(p->clumps, b);
    struct levered levered = {p->clumps, visit, context, at != NULL ? fmax(at->overlap, at->strain) : 0.0};
    const int status = p->effect->springs(p->effect->self, &spheres, at, show_levered, &levered);
    if (status != VTI_OK || p->effect->apply == NULL || !vti_has(&spheres.force))
        return status;
    vti_apply(p->effect, 1, &spheres);
    for (int64_t s = spheres.first; s < spheres.first + spheres.count; ++s) {
        double force[3];
        vti_load(&spheres.force, s, force);
        show_pull(&levered, -1, s, vti_norm(force));
    }
    return VTI_OK;
}

vti_effect vti_clumped_effect(const vti_clumped *clumped)
{
    const int64_t force = 1 << VTI_QUANTITY_FORCE, moment = 1 << VTI_QUANTITY_MOMENT;
    if (clumped == NULL || clumped->effect == NULL || vti_clump_list_check(clumped->clumps) != VTI_OK)
        return vti_effect_none();
    const vti_effect *e = clumped->effect;
    vti_effect effect = *e;
    effect.apply = e->apply != NULL ? apply : NULL;
    effect.energy = e->energy != NULL ? energy : NULL;
    effect.check = check;
    effect.springs = e->springs != NULL ? springs : NULL;
    effect.flow = e->flow != NULL ? flow : NULL;
    effect.flow_clumps = NULL;
    effect.carry = e->carry != NULL ? carry : NULL;
    effect.rupture = e->rupture != NULL ? rupture : NULL;
    effect.self = clumped;
    effect.by_body = NULL; /* that of the spheres */
    effect.needs = 1 << VTI_QUANTITY_ALPHA;
    effect.gives = (e->gives & force) != 0 ? force | moment : e->gives;
    effect.breaks |= VTI_BREAKS_SPINS;
    return effect;
}
