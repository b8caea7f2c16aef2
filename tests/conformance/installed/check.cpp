// SPDX-License-Identifier: BSD-3-Clause
// A user of the conformance kit in C++: a step that is right, and one that forgets the moments.
#include "vti.h"
#include "vti_check.h"

extern "C" int advance(void *self, double h, int64_t steps, int64_t n, double *x, double *v, double *quat,
                       double *omega, const double *mass, const double *inertia, vti_check_forces *forces, void *kit)
{
    const bool forgets = *static_cast<const bool *>(self);
    double force[3 * VTI_CHECK_BODIES], moment[3 * VTI_CHECK_BODIES];
    vti_bodies bodies = vti_bodies_none(n);
    bodies.x = vti_view_packed(x);
    bodies.v = vti_view_packed(v);
    bodies.force = vti_view_packed(force);
    for (int k = 0; k < 4; ++k)
        bodies.quat.xyzw[k] = quat + k;
    bodies.quat.stride = 4;
    bodies.omega = vti_view_packed(omega);
    bodies.moment = forgets ? vti_view_none() : vti_view_packed(moment);
    bodies.mass = vti_scalars_array(mass);
    bodies.inertia = vti_scalars_array(inertia);
    const vti_stepper *method = vti_stepper_find("vti2");
    forces(kit, n, x, quat, force, moment);
    for (int64_t k = 0; k < steps; ++k) {
        if (vti_step_begin(method, h, &bodies, nullptr) != VTI_OK)
            return 1;
        forces(kit, n, x, quat, force, moment);
        if (vti_step_finish(method, h, &bodies) != VTI_OK)
            return 1;
    }
    return 0;
}

int main()
{
    bool forgets = false;
    if (vti_check("right", advance, &forgets) != 0)
        return 1;
    forgets = true;
    return vti_check("without moments", advance, &forgets) != 0 ? 0 : 1;
}
