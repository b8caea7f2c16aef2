/* SPDX-License-Identifier: BSD-3-Clause
 * A host has its own time step looked at by the conformance kit: the step, behind the kit's callback. This one turns
 * its attitudes by exactly h|omega|.      pkg-config --cflags --libs vti-check */
#include <math.h>

#include "vti_check.h"

/* attitude <- exp(h omega/2) attitude, quaternions x, y, z, w */
static void turn(double h, const double *w, double *q)
{
    const double size = sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    const double k = size > 0.0 ? sin(0.5 * h * size) / size : 0.0, c = cos(0.5 * h * size);
    const double u[3] = {k * w[0], k * w[1], k * w[2]}, p[4] = {q[0], q[1], q[2], q[3]};
    q[0] = c * p[0] + p[3] * u[0] + u[1] * p[2] - u[2] * p[1];
    q[1] = c * p[1] + p[3] * u[1] + u[2] * p[0] - u[0] * p[2];
    q[2] = c * p[2] + p[3] * u[2] + u[0] * p[1] - u[1] * p[0];
    q[3] = c * p[3] - u[0] * p[0] - u[1] * p[1] - u[2] * p[2];
}

static int advance(void *self, double h, int64_t steps, int64_t n, double *x, double *v, double *quat, double *omega,
                   const double *mass, const double *inertia, vti_check_forces *forces, void *kit)
{
    double force[3 * VTI_CHECK_BODIES], moment[3 * VTI_CHECK_BODIES];
    (void)self;
    forces(kit, n, x, quat, force, moment); /* prime: the first kick needs them */
    for (int64_t k = 0; k < 2 * steps; ++k) {
        for (int64_t j = 0; j < 3 * n; ++j) { /* half a kick */
            v[j] += 0.5 * h * force[j] / mass[j / 3];
            omega[j] += 0.5 * h * moment[j] / inertia[j / 3];
        }
        if (k % 2 == 1) /* that was the second half */
            continue;
        for (int64_t j = 0; j < 3 * n; ++j)
            x[j] += h * v[j];
        for (int64_t i = 0; i < n; ++i)
            turn(h, omega + 3 * i, quat + 4 * i);
        forces(kit, n, x, quat, force, moment);
    }
    return 0;
}

int main(void)
{
    return vti_check("my code", advance, NULL) == 0 ? 0 : 1;
}
