/* SPDX-License-Identifier: BSD-3-Clause */
#include <math.h>
#include <mpi.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include "host.h"

void *reserve(void *old, int64_t values, size_t size)
{
    void *room = realloc(old, (size_t)(values + 1) * size);
    if (!room)
        give_up("no memory", values);
    return room;
}

void say(const struct host *host, const char *format, ...)
{
    va_list words;
    va_start(words, format);
    if (host->rank == 0)
        vprintf(format, words);
    va_end(words);
}

/** What LAMMPS holds of all spheres, in the order of their tags. */
static double *gather(struct host *host, char *name)
{
    double *all = reserve(NULL, 3 * host->scene.bodies, sizeof *all);
    lammps_gather_atoms(host->lammps, name, 1, 3, all);
    return all;
}

/** The forces and moments that LAMMPS has summed up, against those of all bonds at once in one place. */
static void compare_forces(struct host *host, double *x)
{
    struct scene *scene = &host->scene;
    double *theirs[2] = {gather(host, "f"), gather(host, "torque")};
    double *ours[2] = {gather(host, "f"), gather(host, "torque")}; /* room, written over */
    vti_bodies bodies = vti_bodies_none(scene->bodies);
    bodies.x = vti_view_packed(x);
    bodies.quat = quat_view(host->quat);
    bodies.force = vti_view_packed(ours[0]);
    bodies.moment = vti_view_packed(ours[1]);
    scene_apply(scene->bonds, scene->pair, scene->rest, &bodies, 0);
    for (int what = 0; what < 2; ++what) {
        double error = 0.0, size = 0.0;
        for (int64_t k = 0; k < 3 * scene->bodies; ++k) {
            error = fmax(error, fabs(theirs[what][k] - ours[what][k]));
            size = fmax(size, fabs(ours[what][k]));
        }
        say(host, "%s %.17g %.17g\n", what == 0 ? "force" : "moment", error, size);
        free(theirs[what]);
        free(ours[what]);
    }
}

static void print_end(struct host *host, const double *x)
{
    double *v = gather(host, "v"), *spin = gather(host, "angmom");
    for (int64_t i = 0; i < host->scene.bodies; ++i) {
        double alpha[3];
        vti_rrv_from_quat_xyzw(host->quat + 4 * i, alpha);
        for (int k = 0; k < 3; ++k)
            spin[3 * i + k] /= host->scene.inertia[i];
        const double *part[4] = {x + 3 * i, v + 3 * i, alpha, spin + 3 * i};
        for (int p = 0; p < 12; ++p)
            say(host, "%.17g%c", part[p / 3][p % 3], p == 11 ? '\n' : ' ');
    }
    free(v);
    free(spin);
}

/** How many spheres and bonds each rank has. */
static void print_shares(struct host *host)
{
    int ranks, mine[2] = {lammps_extract_setting(host->lammps, "nlocal"), (int)host->here.bonds};
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    int *all = reserve(NULL, 2 * ranks, sizeof *all);
    MPI_Gather(mine, 2, MPI_INT, all, 2, MPI_INT, 0, MPI_COMM_WORLD);
    for (int r = 0; r < ranks; ++r)
        say(host, "rank %d %d %d\n", r, host->rank == 0 ? all[2 * r] : 0, host->rank == 0 ? all[2 * r + 1] : 0);
    free(all);
}

void report(struct host *host)
{
    double *x = gather(host, "x");
    compare_forces(host, x);
    print_shares(host);
    print_end(host, x);
    free(x);
}
