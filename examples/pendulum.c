/* SPDX-License-Identifier: BSD-3-Clause
 * A complete host: the paper's pendulum by VTI-2. The moment is this program's own; the library moves the body. */
#include <stdio.h>
#include <stdlib.h>

#include "vti.h"

enum { N = 1, STEPS = 640 };

static const double weight = 1.0, inertia = 1.0, rho0[3] = {0.0, 0.0, 1.0};

/** RM = weight (R rho0) x e3 */
static void own_moments(double (*alpha)[3], double (*moment)[3])
{
    for (int i = 0; i < N; ++i) {
        double arm[3];
        vti_rrv_rotate(alpha[i], rho0, arm);
        moment[i][0] = weight * arm[1];
        moment[i][1] = -weight * arm[0];
        moment[i][2] = 0.0;
    }
}

static void must(int status)
{
    if (status != VTI_OK) {
        fprintf(stderr, "pendulum: %s\n", vti_status_text(status));
        exit(EXIT_FAILURE);
    }
}

int main(void)
{
    const double h = 1.0 / 64.0;
    double alpha[N][3] = {{0.0, 4.82842712474619, 0.0}}; /* 2 tan(3 pi/8): turned by 3 pi/4 about e2 */
    double omega[N][3] = {{0.2, 0.0, 0.2}}, moment[N][3], arm[3];

    vti_bodies bodies = vti_bodies_none(N);
    bodies.alpha = vti_view_packed(alpha[0]);
    bodies.omega = vti_view_packed(omega[0]);
    bodies.moment = vti_view_packed(moment[0]);
    bodies.inertia = vti_scalars_one(&inertia);
    must(vti_bodies_check_values(&bodies, NULL));

    const vti_stepper *method = vti_stepper_find("vti2");
    own_moments(alpha, moment);
    must(vti_step_start(method, h, &bodies));
    for (int k = 0; k < STEPS; ++k) {
        must(vti_step_begin(method, h, &bodies, NULL));
        own_moments(alpha, moment);
        must(vti_step_finish(method, h, &bodies));
    }

    vti_rrv_rotate(alpha[0], rho0, arm);
    printf("t = %g  energy = %.12f  R rho0 . Omega = %.1e\n", STEPS * h,
           vti_kinetic_rotation(&bodies) - weight * arm[2], vti_dot(arm, omega[0]));
    return EXIT_SUCCESS;
}
