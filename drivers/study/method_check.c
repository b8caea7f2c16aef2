/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A model without a scene: the kit's bodies, and one effect that asks the kit for its forces. */
#include "method_check.h"

#include <string.h>

/** What the effect needs, and the model's memory. Rivals want packed arrays of the model's own. */
struct adapter {
    struct model model;
    struct scene scene;
    vti_check_forces *forces;
    void *kit;
    double x[3 * VTI_CHECK_BODIES], v[3 * VTI_CHECK_BODIES], force[3 * VTI_CHECK_BODIES];
    double alpha[3 * VTI_CHECK_BODIES], omega[3 * VTI_CHECK_BODIES], moment[3 * VTI_CHECK_BODIES];
    double spin[3 * VTI_CHECK_BODIES], moments[3 * VTI_CHECK_BODIES];
};

/** What the kit has its host advance: arrays of n bodies, with one moment of inertia each, or inertia is NULL. */
struct asked {
    int64_t n;
    double *x, *v, *quat, *omega;
    const double *mass, *inertia;
    vti_check_forces *forces;
    void *kit;
};

/** The attitude of body i, as alpha or quaternion, whichever the method holds. */
static void attitude(const vti_bodies *b, int64_t i, double quat[4])
{
    double alpha[3];
    if (b->quat.xyzw[0] != NULL) {
        for (int k = 0; k < 4; ++k)
            quat[k] = b->quat.xyzw[k][i * b->quat.stride];
        return;
    }
    for (int k = 0; k < 3; ++k)
        alpha[k] = b->alpha.c[k][i * b->alpha.stride];
    vti_rrv_to_quat_xyzw(alpha, quat);
}

static void ask(const void *self, const vti_bodies *b)
{
    const struct adapter *adapter = self;
    double x[3 * VTI_CHECK_BODIES], quat[4 * VTI_CHECK_BODIES], force[3 * VTI_CHECK_BODIES],
        moment[3 * VTI_CHECK_BODIES];
    for (int64_t i = 0; i < b->count; ++i) {
        for (int k = 0; k < 3; ++k)
            x[3 * i + k] = b->x.c[k][i * b->x.stride];
        attitude(b, i, quat + 4 * i);
    }
    adapter->forces(adapter->kit, b->count, x, quat, force, moment);
    for (int64_t i = 0; i < b->count; ++i)
        for (int k = 0; k < 3; ++k) {
            b->force.c[k][i * b->force.stride] += force[3 * i + k];
            b->moment.c[k][i * b->moment.stride] += moment[3 * i + k];
        }
}

static int set_up(struct adapter *g, const struct asked *asked)
{
    const size_t size = (size_t)(3 * asked->n) * sizeof *asked->x;
    memset(g, 0, sizeof *g);
    if (asked->n < 1 || asked->n > VTI_CHECK_BODIES)
        return -1;
    g->forces = asked->forces;
    g->kit = asked->kit;
    memcpy(g->x, asked->x, size);
    memcpy(g->v, asked->v, size);
    memcpy(g->omega, asked->omega, size);
    for (int64_t i = 0; i < asked->n; ++i)
        vti_rrv_from_quat_xyzw(asked->quat + 4 * i, g->alpha + 3 * i);
    strcpy(g->scene.name, "vti-check");
    struct model *m = &g->model;
    m->scene = &g->scene;
    m->translates = m->turns = 1;
    m->bodies = vti_bodies_none(asked->n);
    m->bodies.x = vti_view_packed(g->x);
    m->bodies.v = vti_view_packed(g->v);
    m->bodies.force = vti_view_packed(g->force);
    m->bodies.alpha = vti_view_packed(g->alpha);
    m->bodies.omega = vti_view_packed(g->omega);
    m->bodies.moment = vti_view_packed(g->moment);
    m->bodies.mass = vti_scalars_array(asked->mass);
    if (asked->inertia != NULL)
        m->bodies.inertia = vti_scalars_array(asked->inertia);
    m->effects[0].name = "vti-check";
    m->effects[0].apply = ask;
    /* the kit does not tell its springs: whoever wants a bound goes by h and the spins */
    m->effects[0].springs = vti_springs_none;
    m->effects[0].self = g;
    m->effects_count = 1;
    return 0;
}

static void read_back(const vti_bodies *b, const struct asked *to)
{
    for (int64_t i = 0; i < b->count; ++i) {
        for (int k = 0; k < 3; ++k) {
            to->x[3 * i + k] = b->x.c[k][i * b->x.stride];
            to->v[3 * i + k] = b->v.c[k][i * b->v.stride];
            to->omega[3 * i + k] = b->omega.c[k][i * b->omega.stride];
        }
        attitude(b, i, to->quat + 4 * i);
    }
}

/** Steps the adapter's model and reads it back, omega from the view of it or, where there are moments, that of L. */
static int go(struct adapter *adapter, const vti_stepper *stepper, double h, int64_t steps, const struct asked *asked)
{
    struct travel travel;
    struct message message;
    if (travel_create(&travel, stepper, &adapter->model, h, &message) != 0)
        return -1;
    const int result = travel_go(&travel, steps, &message);
    if (result == 0) {
        vti_bodies b = travel_bodies(&travel);
        if (b.spin.c[0] != NULL)
            b.omega = b.spin;
        read_back(&b, asked);
    }
    travel_destroy(&travel);
    return result;
}

int method_check_advance(void *self, double h, int64_t steps, int64_t n, double *x, double *v, double *quat,
                         double *omega, const double *mass, const double *inertia, vti_check_forces *forces, void *kit)
{
    const struct asked asked = {n, x, v, quat, omega, mass, inertia, forces, kit};
    struct adapter adapter;
    return set_up(&adapter, &asked) != 0 ? -1 : go(&adapter, self, h, steps, &asked);
}

int method_check_advance_inertia(void *self, double h, int64_t steps, int64_t n, double *x, double *v, double *quat,
                                 double *spin, const double *mass, const double *moments, vti_check_forces *forces,
                                 void *kit)
{
    const struct asked asked = {n, x, v, quat, spin, mass, NULL, forces, kit};
    struct adapter adapter;
    if (set_up(&adapter, &asked) != 0)
        return -1;
    memcpy(adapter.spin, spin, (size_t)(3 * n) * sizeof *spin);
    memcpy(adapter.moments, moments, (size_t)(3 * n) * sizeof *moments);
    adapter.model.bodies.spin = vti_view_packed(adapter.spin);
    adapter.model.bodies.moments = vti_view_packed(adapter.moments);
    if (vti_kick(0.0, &adapter.model.bodies) != VTI_OK) /* which shows Omega, for those who go by it */
        return -1;
    return go(&adapter, self, h, steps, &asked);
}
