/* SPDX-License-Identifier: BSD-3-Clause
 * A host whose spheres are an array of structs: a chain of bonded spheres, by VTI-2.
 *     host_structs chain/bodies.csv */
#include <stdio.h>
#include <stdlib.h>

#include "vti.h"

enum { N = 10, BONDS = N - 1, STEPS = 5120 };

struct sphere {
    int id;
    double x[3], v[3], force[3], alpha[3], omega[3], moment[3], mass, inertia;
};

static struct sphere spheres[N];

static void must(int status, const vti_fault *fault)
{
    if (status != VTI_OK) {
        fprintf(stderr, "sphere %d, %s %g: %s\n", (int)fault->body, vti_quantity_text(fault->quantity), fault->value,
                vti_status_text(status));
        exit(EXIT_FAILURE);
    }
}

static void read_spheres(const char *path)
{
    FILE *file = fopen(path, "r");
    if (file == NULL) {
        fprintf(stderr, "%s: cannot be opened; call this in the folder examples, or with the path of the table\n",
                path);
        exit(EXIT_FAILURE);
    }
    int fields = fscanf(file, "%*[^\n]");
    for (int i = 0; i < N && fields != EOF; ++i) {
        struct sphere *s = &spheres[i];
        s->id = i;
        fields = fscanf(file, "%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf", &s->x[0], &s->x[1], &s->x[2],
                        &s->v[0], &s->v[1], &s->v[2], &s->alpha[0], &s->alpha[1], &s->alpha[2], &s->omega[0],
                        &s->omega[1], &s->omega[2], &s->mass, &s->inertia);
    }
    if (fields != 14) {
        fprintf(stderr, "%s: not %d spheres\n", path, N);
        exit(EXIT_FAILURE);
    }
    fclose(file);
}

static void print_spheres(void)
{
    for (int i = 0; i < N; ++i) {
        const double *const q[] = {spheres[i].x, spheres[i].v, spheres[i].alpha, spheres[i].omega};
        for (int k = 0; k < 12; ++k)
            printf("%.17g%c", q[k / 3][k % 3], k < 11 ? ' ' : '\n');
    }
}

/** The spheres as the library sees them: where each member is, and how far it is to the next. */
static vti_bodies view_spheres(void)
{
    vti_bodies bodies = vti_bodies_none(N);
    bodies.x = vti_view_member(spheres[0].x, sizeof spheres[0]);
    bodies.v = vti_view_member(spheres[0].v, sizeof spheres[0]);
    bodies.force = vti_view_member(spheres[0].force, sizeof spheres[0]);
    bodies.alpha = vti_view_member(spheres[0].alpha, sizeof spheres[0]);
    bodies.omega = vti_view_member(spheres[0].omega, sizeof spheres[0]);
    bodies.moment = vti_view_member(spheres[0].moment, sizeof spheres[0]);
    bodies.mass = vti_scalars_member(&spheres[0].mass, sizeof spheres[0]);
    bodies.inertia = vti_scalars_member(&spheres[0].inertia, sizeof spheres[0]);
    return bodies;
}

/** This host's forces: those of the library's binder. A host with forces of its own computes them here. */
static void forces(const vti_effect *binder, const vti_bodies *bodies)
{
    vti_apply(binder, 1, bodies);
}

int main(int argc, char **argv)
{
    static int64_t pair[BONDS][2];
    static double rest[BONDS][4];
    const double h = 1.0 / 512.0, moment = 10.0, axial = 200.0, shear = 200.0;
    vti_fault fault = {-1, 0.0, VTI_QUANTITY_NONE};
    read_spheres(argc > 1 ? argv[1] : "chain/bodies.csv");

    vti_bodies bodies = view_spheres();
    must(vti_bodies_check_values(&bodies, &fault), &fault);
    for (int k = 0; k < BONDS; ++k)
        pair[k][0] = k, pair[k][1] = k + 1;
    must(vti_bonds_rest(BONDS, pair[0], 0, &bodies.x, rest[0], &fault), &fault);
    const vti_bonds bonds = {.count = BONDS,
                             .pair = pair[0],
                             .rest = rest[0],
                             .moment = vti_scalars_one(&moment),
                             .axial = vti_scalars_one(&axial),
                             .shear = vti_scalars_one(&shear),
                             .shear_form = VTI_SHEAR_OBJECTIVE};
    must(vti_bonds_check(&bonds, N, &fault), &fault);
    const vti_effect binder = vti_bonds_effect(&bonds);

    const vti_stepper *method = vti_stepper_find("vti2");
    forces(&binder, &bodies); /* prime: the first kick needs them */
    for (int k = 0; k < STEPS; ++k) {
        must(vti_step_begin(method, h, &bodies, &fault), &fault);
        forces(&binder, &bodies); /* at the new positions and attitudes */
        must(vti_step_finish(method, h, &bodies), &fault);
    }
    print_spheres();
    return EXIT_SUCCESS;
}
