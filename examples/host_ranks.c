/* SPDX-License-Identifier: BSD-3-Clause
 * A host under MPI: each rank steps its own part of a chain of bonded spheres by VTI-2, and has its neighbours' as
 * ghosts.
 *     mpirun -n 3 host_ranks chain/bodies.csv                                                                        */
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>

#include "vti.h"

enum { N = 10, BONDS = N - 1, STEPS = 5120 };

/** x and alpha lie together: they are what the bonds read of a ghost, and what travels. */
struct sphere {
    double x[3], alpha[3], v[3], omega[3], force[3], moment[3], mass, inertia;
};
enum { TRAVELS = 6, DOUBLES = sizeof(struct sphere) / sizeof(double) };

static struct sphere spheres[N];
static int rank, ranks;

static void must(int status)
{
    if (status != VTI_OK) {
        fprintf(stderr, "host_ranks: %s\n", vti_status_text(status));
        MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
    }
}

static int read_spheres(const char *path)
{
    FILE *file = fopen(path, "r");
    if (file == NULL) {
        fprintf(stderr, "%s: cannot be opened; call this in the folder examples, or with the path of the table\n",
                path);
        return 0;
    }
    int fields = fscanf(file, "%*[^\n]");
    for (struct sphere *s = spheres; s < spheres + N && fields != EOF; ++s)
        fields = fscanf(file, "%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf", &s->x[0], &s->x[1], &s->x[2],
                        &s->v[0], &s->v[1], &s->v[2], &s->alpha[0], &s->alpha[1], &s->alpha[2], &s->omega[0],
                        &s->omega[1], &s->omega[2], &s->mass, &s->inertia);
    fclose(file);
    if (fields != 14)
        fprintf(stderr, "%s: not %d spheres\n", path, N);
    return fields == 14;
}

/** The first sphere of a rank; the next rank's first is the end of its own. */
static int first_of(int owner)
{
    return N * owner / ranks;
}

/** The last sphere of each rank is a ghost of the next one, the first a ghost of the one before. */
static void exchange(void)
{
    const int first = first_of(rank), end = first_of(rank + 1);
    const int before = rank > 0 ? rank - 1 : MPI_PROC_NULL, after = rank < ranks - 1 ? rank + 1 : MPI_PROC_NULL;
    struct sphere *left = &spheres[first > 0 ? first - 1 : 0], *right = &spheres[end < N ? end : N - 1];
    MPI_Sendrecv(spheres[end - 1].x, TRAVELS, MPI_DOUBLE, after, 0, left->x, TRAVELS, MPI_DOUBLE, before, 0,
                 MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    MPI_Sendrecv(spheres[first].x, TRAVELS, MPI_DOUBLE, before, 1, right->x, TRAVELS, MPI_DOUBLE, after, 1,
                 MPI_COMM_WORLD, MPI_STATUS_IGNORE);
}

/** near: own spheres and ghosts; binder: every bond of an own sphere, so that two ranks compute a bond between them. */
static void run(const vti_bodies *own, const vti_bodies *near, const vti_effect *binder, double h)
{
    const vti_stepper *method = vti_stepper_find("vti2");
    exchange();
    must(vti_apply(binder, 1, near));
    for (int k = 0; k < STEPS; ++k) {
        must(vti_step_begin(method, h, own, NULL));
        exchange();
        must(vti_apply(binder, 1, near));
        must(vti_step_finish(method, h, own));
    }
}

static void print_spheres(void)
{
    for (int owner = 0; owner < ranks; ++owner)
        MPI_Bcast(&spheres[first_of(owner)], (first_of(owner + 1) - first_of(owner)) * DOUBLES, MPI_DOUBLE, owner,
                  MPI_COMM_WORLD);
    for (int i = 0; i < N && rank == 0; ++i) {
        const double *const q[] = {spheres[i].x, spheres[i].v, spheres[i].alpha, spheres[i].omega};
        for (int k = 0; k < 12; ++k)
            printf("%.17g%c", q[k / 3][k % 3], k < 11 ? ' ' : '\n');
    }
}

static vti_bodies all_spheres(void)
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
    must(vti_bodies_check_values(&bodies, NULL));
    return bodies;
}

int main(int argc, char **argv)
{
    static int64_t pair[BONDS][2];
    static double rest[BONDS][4];
    const double stiffness[3] = {10.0, 200.0, 200.0};
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    if (ranks > N)
        fprintf(stderr, "host_ranks: no more ranks than spheres, %d\n", N);
    if (ranks > N || !read_spheres(argc > 1 ? argv[1] : "chain/bodies.csv")) {
        MPI_Finalize();
        return EXIT_FAILURE;
    }
    const vti_bodies bodies = all_spheres();
    for (int k = 0; k < BONDS; ++k)
        pair[k][0] = k, pair[k][1] = k + 1;
    must(vti_bonds_rest(BONDS, pair[0], 0, &bodies.x, rest[0], NULL));

    const int first = first_of(rank), end = first_of(rank + 1), low = first > 0 ? first - 1 : 0,
              high = end < N ? end + 1 : N;
    const vti_bodies own = vti_bodies_slice(bodies, first, end - first),
                     near = vti_bodies_slice(bodies, low, high - low);
    const vti_bonds bonds = {.count = high - 1 - low,
                             .pair = pair[low],
                             .rest = rest[low],
                             .moment = vti_scalars_one(&stiffness[0]),
                             .axial = vti_scalars_one(&stiffness[1]),
                             .shear = vti_scalars_one(&stiffness[2]),
                             .shear_form = VTI_SHEAR_OBJECTIVE};
    must(vti_bonds_check(&bonds, N, NULL));
    const vti_effect binder = vti_bonds_effect(&bonds);
    run(&own, &near, &binder, 1.0 / 512.0);
    print_spheres();
    MPI_Finalize();
    return EXIT_SUCCESS;
}
