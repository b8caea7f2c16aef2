/* SPDX-License-Identifier: BSD-3-Clause
 * A host with threads (OpenMP): each steps a slice of the spheres, a chain of bonded spheres, by VTI-2.
 *     host_threads chain/bodies.csv */
#include <stdio.h>
#include <stdlib.h>

#include "vti.h"

enum { N = 10, BONDS = N - 1, STEPS = 5120, SLICES = 4 };

static double x[N][3], v[N][3], force[N][3], alpha[N][3], omega[N][3], moment[N][3], mass[N], inertia[N];

static void must(int status)
{
    if (status != VTI_OK) {
        fprintf(stderr, "host_threads: %s\n", vti_status_text(status));
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
    for (int i = 0; i < N && fields != EOF; ++i)
        fields = fscanf(file, "%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf", &x[i][0], &x[i][1], &x[i][2],
                        &v[i][0], &v[i][1], &v[i][2], &alpha[i][0], &alpha[i][1], &alpha[i][2], &omega[i][0],
                        &omega[i][1], &omega[i][2], &mass[i], &inertia[i]);
    if (fields != 14) {
        fprintf(stderr, "%s: not %d spheres\n", path, N);
        exit(EXIT_FAILURE);
    }
    fclose(file);
}

static void print_spheres(void)
{
    for (int i = 0; i < N; ++i) {
        const double *const q[] = {x[i], v[i], alpha[i], omega[i]};
        for (int k = 0; k < 12; ++k)
            printf("%.17g%c", q[k / 3][k % 3], k < 11 ? ' ' : '\n');
    }
}

static vti_bodies slice(const vti_bodies *bodies, int s)
{
    const int64_t first = bodies->count * s / SLICES, end = bodies->count * (s + 1) / SLICES;
    return vti_bodies_slice(*bodies, first, end - first);
}

/** Spheres are stepped by all threads at once, and loaded too, as a slice's loads are written by nobody else. Here
 *  every thread looks at all bonds; a host with many gives each slice those of vti_pairs_of_slice. */
static void run(const vti_bodies *bodies, const vti_effect *binder, double h)
{
    const vti_stepper *method = vti_stepper_find("vti2");
    vti_bodies part[SLICES];
    for (int s = 0; s < SLICES; ++s)
        part[s] = slice(bodies, s);

    must(vti_apply(binder, 1, bodies));
    for (int k = 0; k < STEPS; ++k) {
#pragma omp parallel for
        for (int s = 0; s < SLICES; ++s)
            must(vti_step_begin(method, h, &part[s], NULL));
#pragma omp parallel for
        for (int s = 0; s < SLICES; ++s) {
            must(vti_apply(binder, 1, &part[s])); /* once all have moved */
            must(vti_step_finish(method, h, &part[s]));
        }
    }
}

int main(int argc, char **argv)
{
    static int64_t pair[BONDS][2];
    static double rest[BONDS][4];
    const double stiffness[3] = {10.0, 200.0, 200.0};
    read_spheres(argc > 1 ? argv[1] : "chain/bodies.csv");

    vti_bodies bodies = vti_bodies_none(N);
    bodies.x = vti_view_packed(x[0]);
    bodies.x.count = N; /* lists name bodies outside of a slice, which a library with -Dchecked=true has to know of */
    bodies.v = vti_view_packed(v[0]);
    bodies.force = vti_view_packed(force[0]);
    bodies.alpha = vti_view_packed(alpha[0]);
    bodies.omega = vti_view_packed(omega[0]);
    bodies.moment = vti_view_packed(moment[0]);
    bodies.mass = vti_scalars_array(mass);
    bodies.inertia = vti_scalars_array(inertia);
    must(vti_bodies_check_values(&bodies, NULL));

    for (int k = 0; k < BONDS; ++k)
        pair[k][0] = k, pair[k][1] = k + 1;
    must(vti_bonds_rest(BONDS, pair[0], 0, &bodies.x, rest[0], NULL));
    const vti_bonds bonds = {.count = BONDS,
                             .pair = pair[0],
                             .rest = rest[0],
                             .moment = vti_scalars_one(&stiffness[0]),
                             .axial = vti_scalars_one(&stiffness[1]),
                             .shear = vti_scalars_one(&stiffness[2]),
                             .shear_form = VTI_SHEAR_OBJECTIVE};
    must(vti_bonds_check(&bonds, N, NULL));
    const vti_effect binder = vti_bonds_effect(&bonds);
    run(&bodies, &binder, 1.0 / 512.0);
    print_spheres();
    return EXIT_SUCCESS;
}
