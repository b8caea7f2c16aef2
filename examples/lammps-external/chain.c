/* SPDX-License-Identifier: BSD-3-Clause
 * The chain of examples/chain with LAMMPS as the host: LAMMPS owns, moves and communicates the spheres (fix nve/asphere
 * on its own domain decomposition), and asks us for the binder's forces and moments through fix external, on any number
 * of ranks.
 *     mpirun -n 2 lammps_chain ../chain/bodies.csv ../chain/bonds.csv STEP STEPS
 * Rank 0 prints what check.py reads: energies, the check of the forces, and the end in the columns of the other
 * hosts. */
#include <math.h>
#include <mpi.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include "host.h"

/** To LAMMPS: commands, one a line. */
static void command(struct host *host, const char *format, ...)
{
    char text[1024];
    va_list words;
    va_start(words, format);
    vsnprintf(text, sizeof text, format, words);
    va_end(words);
    lammps_commands_string(host->lammps, text);
}

/** Room for all spheres that this rank owns or sees as ghosts. */
static void make_room(struct local *here, int64_t atoms)
{
    if (atoms <= here->room)
        return;
    here->force = reserve(here->force, 3 * atoms, sizeof *here->force);
    here->moment = reserve(here->moment, 3 * atoms, sizeof *here->moment);
    here->quat = reserve(here->quat, 4 * atoms, sizeof *here->quat);
    here->room = atoms;
}

/** Attitudes of all spheres by tag. LAMMPS keeps those of ghosts too, but its C library shows only those that a rank
 *  owns, so they are exchanged here. Each is summed from one value and zeros: the bits stay. */
static void share_attitudes(struct host *host, int owned, const int *tag)
{
    double **own = lammps_extract_compute(host->lammps, "attitude", LMP_STYLE_ATOM, LMP_TYPE_ARRAY);
    for (int64_t k = 0; k < 4 * host->scene.bodies; ++k)
        host->quat[k] = 0.0;
    for (int a = 0; a < owned; ++a)
        for (int k = 0; k < 4; ++k)
            host->quat[4 * (tag[a] - 1) + k] = own[a][k];
    MPI_Allreduce(MPI_IN_PLACE, host->quat, (int)(4 * host->scene.bodies), MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
}

/** Where each tag is on this rank, or -1. A sphere that is owned comes before its images. */
static void locate(struct host *host, int atoms, const int *tag)
{
    for (int64_t i = 0; i < host->scene.bodies; ++i)
        host->here.place[i] = -1;
    for (int a = atoms - 1; a >= 0; --a)
        host->here.place[tag[a] - 1] = a;
}

/** The bonds that pull at spheres of this rank, those whose first sphere is owned in front: their energy is this
 *  rank's. The rank of the other end computes a bond that crosses a border too, so that no force travels. */
static void choose_bonds(struct host *host, int owned)
{
    struct local *here = &host->here;
    here->bonds = here->ours = 0;
    for (int second = 0; second < 2; ++second) {
        for (int64_t b = 0; b < host->scene.bonds; ++b) {
            const int64_t i = here->place[host->scene.pair[2 * b]], j = here->place[host->scene.pair[2 * b + 1]];
            const int i_owned = i >= 0 && i < owned, j_owned = j >= 0 && j < owned;
            if (second ? i_owned || !j_owned : !i_owned)
                continue;
            if (i < 0 || j < 0)
                give_up("a bond is longer than comm_modify cutoff", b);
            here->pair[2 * here->bonds] = i;
            here->pair[2 * here->bonds + 1] = j;
            for (int k = 0; k < 4; ++k)
                here->rest[4 * here->bonds + k] = host->scene.rest[4 * b + k];
            ++here->bonds;
        }
        if (!second)
            here->ours = here->bonds;
    }
}

/** Our views of LAMMPS' positions and of this rank's attitudes, forces and moments. */
static vti_bodies local_bodies(struct host *host, double **x, int atoms, const int *tag)
{
    struct local *here = &host->here;
    vti_bodies bodies = vti_bodies_none(atoms);
    make_room(here, atoms);
    for (int a = 0; a < atoms; ++a)
        for (int k = 0; k < 4; ++k)
            here->quat[4 * a + k] = host->quat[4 * (tag[a] - 1) + k];
    bodies.x = vti_view_packed(x[0]);
    bodies.quat = quat_view(here->quat);
    bodies.force = vti_view_packed(here->force);
    bodies.moment = vti_view_packed(here->moment);
    return bodies;
}

/** What fix external calls in each step, when LAMMPS has moved the spheres and is ready for forces. */
static void forces(void *self, int64_t step, int owned, int *tag, double **x, double **force)
{
    struct host *host = self;
    const int atoms = owned + lammps_extract_setting(host->lammps, "nghost");
    double **torque = lammps_extract_atom(host->lammps, "torque");
    (void)step;
    share_attitudes(host, owned, tag);
    locate(host, atoms, tag);
    choose_bonds(host, owned);
    double energy = 0.0;
    if (atoms > 0) {
        const vti_bodies bodies = local_bodies(host, x, atoms, tag);
        energy = scene_apply(host->here.bonds, host->here.pair, host->here.rest, &bodies, host->here.ours);
    }
    for (int a = 0; a < owned; ++a) {
        for (int k = 0; k < 3; ++k) {
            force[a][k] = host->here.force[3 * a + k];
            torque[a][k] += host->here.moment[3 * a + k]; /* the fix has no place for moments: into the sum itself */
        }
    }
    /* Every rank has to tell LAMMPS the energy of all. */
    MPI_Allreduce(MPI_IN_PLACE, &energy, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    lammps_fix_external_set_energy_global(host->lammps, "binder", energy);
}

/** Attitudes and spins, as commands with all their digits. */
static void turn(struct host *host, int i)
{
    const struct scene *scene = &host->scene;
    const double J = scene->inertia[i], *w = scene->omega + 3 * i, d = 2.0 * sqrt(2.5 * J / scene->mass[i]);
    double t[3], e[3] = {1.0, 0.0, 0.0};
    vti_rrv_to_rotvec(scene->alpha + 3 * i, t);
    const double angle = vti_norm(t);
    for (int k = 0; k < 3 && angle > 0.0; ++k)
        e[k] = t[k] / angle;
    command(host, "set atom %d shape %.17g %.17g %.17g", i + 1, d, d, d); /* J = 2/5 m (d/2)^2 */
    command(host, "set atom %d mass %.17g", i + 1, scene->mass[i]);
    command(host, "set atom %d quat %.17g %.17g %.17g %.17g", i + 1, e[0], e[1], e[2], angle * 180.0 / acos(-1.0));
    command(host, "set atom %d angmom %.17g %.17g %.17g", i + 1, J * w[0], J * w[1], J * w[2]);
}

static void create(struct host *host)
{
    const int n = (int)host->scene.bodies;
    /* Ranks share the chain along its length; a ghost is at most one bond away, and bonds stay far below a length of
     * 2. */
    command(host,
            "units lj\natom_style ellipsoid\natom_modify map array\nboundary s s s\nprocessors * 1 1\n"
            "region all block -1 %d -1 1 -1 1\ncreate_box 1 all\ncomm_modify cutoff 2\npair_style none",
            n);
    int *id = reserve(NULL, 2 * n, sizeof *id);
    for (int i = 0; i < n; ++i) {
        id[i] = i + 1;
        id[n + i] = 1; /* its type */
    }
    lammps_create_atoms(host->lammps, n, id, id + n, host->scene.x, host->scene.v, NULL, 1);
    free(id);
    for (int i = 0; i < n; ++i)
        turn(host, i);
}

static double energy(struct host *host)
{
    return lammps_get_thermo(host->lammps, "pe") +
           *(double *)lammps_extract_compute(host->lammps, "moving", LMP_STYLE_GLOBAL, LMP_TYPE_SCALAR) +
           *(double *)lammps_extract_compute(host->lammps, "turning", LMP_STYLE_GLOBAL, LMP_TYPE_SCALAR);
}

static void run(struct host *host, double h, int steps)
{
    command(host,
            "compute attitude all property/atom quati quatj quatk quatw\ncompute moving all ke\n"
            "compute turning all erotate/asphere\nthermo_style custom step pe c_moving c_turning\n"
            "thermo_modify norm no\nfix move all nve/asphere\nfix binder all external pf/callback 1 1\n"
            "fix_modify binder energy yes\ntimestep %.17g\nthermo %d",
            h, steps);
    lammps_set_fix_external_callback(host->lammps, "binder", forces, host);
    command(host, "run 0");
    const double start = energy(host);
    /* LAMMPS must not take the attitudes of the first run for those of the second: it may have sorted its spheres. */
    command(host, "uncompute attitude\ncompute attitude all property/atom quati quatj quatk quatw\nrun %d", steps);
    const double end = energy(host);
    say(host, "energy %.17g %.17g\n", start, end);
}

int main(int argc, char **argv)
{
    char *quiet[] = {"lammps", "-log", "none", "-screen", "none"};
    struct host host = {0};
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &host.rank);
    if (argc != 5)
        give_up("needs BODIES BONDS STEP STEPS", argc - 1);
    scene_read(&host.scene, argv[1], argv[2]);
    host.quat = reserve(NULL, 4 * host.scene.bodies, sizeof *host.quat);
    host.here.place = reserve(NULL, host.scene.bodies, sizeof *host.here.place);
    host.here.pair = reserve(NULL, 2 * host.scene.bonds, sizeof *host.here.pair);
    host.here.rest = reserve(NULL, 4 * host.scene.bonds, sizeof *host.here.rest);
    host.lammps = lammps_open(5, quiet, MPI_COMM_WORLD, NULL);
    if (!host.lammps)
        give_up("LAMMPS does not start", 0);
    create(&host);
    run(&host, atof(argv[3]), atoi(argv[4]));
    report(&host);
    lammps_close(host.lammps);
    MPI_Finalize();
    return 0;
}
