/* SPDX-License-Identifier: BSD-3-Clause
 * The C side of the tests of effects in Fortran: bonded spheres under all effects, on x[n][3] arrays. */
#include <stddef.h>

#include "vti.h"

enum { MOST = 256, EFFECTS = 5 };

static const double bond_energy[3] = {10.0, 200.0, 150.0};
static const vti_gravity gravity = {{0.125, -0.25, -1.0}};
static const vti_pendulum pendulum = {0.5, {0.25, -0.5, 0.75}};
static const double planes[2][4] = {{1.0, 0.0, 0.0, -0.25}, {0.0, 0.6, 0.8, -0.25}};

int shim_lattice(const char *name, double h, int64_t steps, int64_t n, double *x, double *v, double *alpha,
                 double *omega, const double *mass, const double *inertia, const double *diameter, int64_t bonds,
                 const int64_t *pair, double *rest, int64_t effects, double results[4]);

/** Runs the first so many effects of bonds, contacts, walls, gravity, pendulum. Bodies in pair count from 1. results
 *  are the stable step, and at the end the energy of all and of two terms. */
int shim_lattice(const char *name, double h, int64_t steps, int64_t n, double *x, double *v, double *alpha,
                 double *omega, const double *mass, const double *inertia, const double *diameter, int64_t count,
                 const int64_t *pair, double *rest, int64_t effects, double results[4])
{
    const vti_stepper *method = vti_stepper_find(name);
    double force[MOST][3], moment[MOST][3], scratch[MOST], energies[VTI_TERMS];
    if (n > MOST || method == NULL)
        return VTI_E_COUNT;
    vti_bodies b = vti_bodies_none(n);
    b.x = vti_view_packed(x);
    b.v = vti_view_packed(v);
    b.force = vti_view_packed(force[0]);
    b.alpha = vti_view_packed(alpha);
    b.omega = vti_view_packed(omega);
    b.moment = vti_view_packed(moment[0]);
    b.mass = vti_scalars_array(mass);
    b.inertia = vti_scalars_array(inertia);

    const vti_bonds bonds = {count,
                             pair,
                             1,
                             rest,
                             vti_scalars_one(&bond_energy[0]),
                             vti_scalars_one(&bond_energy[1]),
                             vti_scalars_one(&bond_energy[2]),
                             VTI_SHEAR_OBJECTIVE,
                             NULL};
    const vti_contacts contacts = {
        .count = count, .pair = pair, .base = 1, .diameter = vti_scalars_array(diameter), .stiffness = 80.0};
    const vti_walls walls = {
        .count = 2, .plane = planes[0], .diameter = vti_scalars_array(diameter), .stiffness = 90.0};
    const vti_effect all[EFFECTS] = {vti_bonds_effect(&bonds), vti_contacts_effect(&contacts), vti_walls_effect(&walls),
                                     vti_gravity_effect(&gravity), vti_pendulum_effect(&pendulum)};
    const vti_deformation at = {0.25, 0.125, 1};
    vti_stable stable = {0.0, 0, 0, 0, 0};

    int status = vti_bonds_rest(count, pair, 1, &b.x, rest, NULL);
    status = status != VTI_OK ? status : vti_stable_step(all, EFFECTS, &b, &at, scratch, &stable);
    results[0] = stable.h;
    status = status != VTI_OK ? status : vti_apply(all, effects, &b);
    status = status != VTI_OK ? status : vti_step_start(method, h, &b);
    for (int64_t i = 0; status == VTI_OK && i < steps; ++i) {
        for (int64_t k = 0; status == VTI_OK && k < method->stages; ++k) {
            status = vti_step_stage(method, k, h, &b, NULL);
            status = status != VTI_OK ? status : vti_apply(all, effects, &b);
        }
        status = status != VTI_OK ? status : vti_step_finish(method, h, &b);
    }
    status = status != VTI_OK ? status : vti_step_sync(method, h, &b);
    results[1] = vti_energy(all, effects, &b);
    all[0].energy(all[0].self, &b, energies);
    results[2] = energies[1];
    results[3] = energies[2];
    return status;
}
