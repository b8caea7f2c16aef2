/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Drag on the velocity a of what has mass or inertia m, with u = a - toward (EQUATIONS 6.3):
 *
 *     u(t) = u E/(1 + k |u| phi),     E = exp(-z),     z = c t/m,     phi = (t/m) (1 - E)/z
 *
 * For lanes of bodies, or for one, as in vti_touch_motion.h. */
#ifndef VTI_DRAG_FLOW_H
#define VTI_DRAG_FLOW_H

#include <float.h>

#include "vti_decay.h"

/** What is kept of u, and what goes, by the coefficients c and k; speed is |u|. */
VTI_INLINE struct vti_decay vti_drag_decay(lanes c, lanes k, lanes speed, lanes m, double t)
{
    const lanes z = c * t / m;
    const struct vti_decay e = vti_decay(z);
    const lanes phi = t / m * vti_decay_mean(z, &e);
    const lanes product = lanes_where(k > 0.0, k * speed * phi, lanes_of(0.0)), most = lanes_of(DBL_MAX);
    const lanes more = lanes_where(product <= most, product, most), per = 1.0 + more; /* nothing is kept of u then */
    return (struct vti_decay){e.kept / per, (e.gone + more) / per};
}

/** The same of c alone. */
VTI_INLINE struct vti_decay vti_drag_decay_linear(lanes c, lanes m, double t)
{
    return vti_decay(c * t / m);
}

/** a = toward + u (1 - gone). Returns what the impulse on the medium takes, -m (a' - a).(a + a')/2. */
VTI_INLINE lanes vti_drag_slow(const struct vti_decay *e, const double toward[3], lanes m, lanes a[3])
{
    lanes change[3], mean[3];
    for (int d = 0; d < 3; ++d) {
        const lanes before = a[d], u = before - toward[d];
        change[d] = -e->gone * u;
        a[d] = lanes_where(e->gone < 0.5, before + change[d], toward[d] + e->kept * u); /* each where it rounds less */
        a[d] = lanes_settled(a[d]);
        mean[d] = 0.5 * (before + a[d]);
    }
    return -m * lanes_dot(change, mean);
}

#endif
