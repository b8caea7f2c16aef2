/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A load on a body that is turned already shows in which frame it acts: the direction of the kick that it gives to a
 * body at rest, whatever its size and sign. */
#include "check.h"

#include <string.h>

static const double start_turn[3] = {0.6, -0.5, 0.7}, load[3] = {2e-3, -1e-3, 3e-3};

static void constant(const void *self, const vti_bodies *b)
{
    (void)self;
    for (int k = 0; k < 3; ++k) {
        b->force.c[k][0] += load[k];
        b->moment.c[k][0] += load[k];
    }
}

static double off(const double a[3], const double b[3])
{
    return difference(a, b) / vti_norm(b);
}

struct sentences {
    const char *line, *turned, *back, *other;
};

static const struct sentences of_force = {
    "force on a turned body: direction of its kick, off by",
    "forces are turned by the attitude while velocities are spatial",
    "forces are turned into the body's frame while velocities are spatial",
    "the kick by a force has another direction than the force",
};
static const struct sentences of_moment = {
    "moment on a turned body: direction of its kick, off by",
    "attitude increments act in the body's frame while moments are spatial: they kick a spin of the body's frame",
    "moments are turned into the body's frame while spins are spatial",
    "the kick by a moment has another direction than the moment",
};

/** Returns whether the kick has a direction, and another one than the load. */
static int judge(struct kit *kit, const struct sentences *say, const double kick[3], const double alpha[3])
{
    double turned[3], back[3];
    const double size = vti_norm(kick) / vti_norm(load);
    const double sign = vti_dot(kick, load) < 0.0 && off(kick, load) > 1.9 * size ? -1.0 : 1.0;
    const double k[3] = {sign * kick[0] / size, sign * kick[1] / size, sign * kick[2] / size};
    const double in_space = size > 0.0 ? off(k, load) : NAN;
    vti_rrv_rotate(alpha, load, turned);
    vti_rrv_rotate_back(alpha, load, back);
    vti_kit_line(kit, say->line, in_space, -1, 1e-3, VTI_CHECK_FAIL);
    if (!(in_space > 1e-3))
        return 0;
    if (!kit->masked)
        vti_kit_fault(kit, "%s", off(k, turned) < 1e-3 ? say->turned : off(k, back) < 1e-3 ? say->back : say->other);
    return 1;
}

void vti_kit_frame(struct kit *kit)
{
    enum { STEPS = 2 };
    struct field field;
    struct bodies b = vti_kit_bodies_none(1);
    double alpha[3];
    memset(&field, 0, sizeof field);
    field.effect.apply = constant;
    field.count = 1;
    vti_rrv_from_rotvec(start_turn, alpha);
    vti_kit_bodies_set_alpha(&b, 0, alpha);
    vti_kit_host_advance(&kit->host, &b, &field, 0.1, STEPS);
    judge(kit, &of_force, b.v, alpha);
    if (judge(kit, &of_moment, b.w, alpha))
        kit->attitude_lost = 1;
}
