/* SPDX-License-Identifier: BSD-3-Clause */
#include "scene.h"

#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>

void give_up(const char *what, int64_t number)
{
    fprintf(stderr, "lammps_chain: %s (%lld)\n", what, (long long)number);
    MPI_Abort(MPI_COMM_WORLD, 1);
    abort();
}

/** The numbers of a table with a line of names and `columns` columns; returns the number of rows. */
static int64_t read_table(const char *path, int columns, double **values)
{
    int64_t n = 0, room = 0;
    FILE *file = fopen(path, "r");
    if (!file)
        give_up(path, 0);
    while (fgetc(file) != '\n' && !feof(file))
        ;
    for (double value; fscanf(file, "%lf%*[,]", &value) == 1; ++n) {
        if (n == room) {
            room = 2 * room + 64;
            *values = realloc(*values, (size_t)room * sizeof **values);
            if (!*values)
                give_up("no memory", room);
        }
        (*values)[n] = value;
    }
    if (!feof(file) || n == 0 || n % columns != 0)
        give_up(path, n);
    fclose(file);
    return n / columns;
}

static double *columns_of(const double *table, int64_t rows, int width, int first, int count)
{
    double *part = malloc((size_t)(rows * count) * sizeof *part);
    if (!part)
        give_up("no memory", rows);
    for (int64_t i = 0; i < rows; ++i)
        for (int k = 0; k < count; ++k)
            part[count * i + k] = table[width * i + first + k];
    return part;
}

void scene_read(struct scene *scene, const char *bodies, const char *bonds)
{
    double *table = NULL, *ends = NULL;
    vti_fault fault = {-1, 0.0, VTI_QUANTITY_NONE};
    scene->bodies = read_table(bodies, 14, &table);
    scene->x = columns_of(table, scene->bodies, 14, 0, 3);
    scene->v = columns_of(table, scene->bodies, 14, 3, 3);
    scene->alpha = columns_of(table, scene->bodies, 14, 6, 3);
    scene->omega = columns_of(table, scene->bodies, 14, 9, 3);
    scene->mass = columns_of(table, scene->bodies, 14, 12, 1);
    scene->inertia = columns_of(table, scene->bodies, 14, 13, 1);
    scene->bonds = read_table(bonds, 2, &ends);
    scene->pair = malloc((size_t)(2 * scene->bonds) * sizeof *scene->pair);
    scene->rest = malloc((size_t)(4 * scene->bonds) * sizeof *scene->rest);
    if (!scene->pair || !scene->rest)
        give_up("no memory", scene->bonds);
    for (int64_t k = 0; k < 2 * scene->bonds; ++k) {
        scene->pair[k] = (int64_t)ends[k];
        if (scene->pair[k] < 0 || scene->pair[k] >= scene->bodies)
            give_up("a bond names no body", k / 2);
    }
    const vti_view x = vti_view_packed(scene->x);
    const int status = vti_bonds_rest(scene->bonds, scene->pair, 0, &x, scene->rest, &fault);
    if (status != VTI_OK)
        give_up(vti_status_text(status), fault.body);
    free(table);
    free(ends);
}

double scene_apply(int64_t bonds, const int64_t *pair, const double *rest, const vti_bodies *bodies, int64_t ours)
{
    static const double stiffness[3] = {10.0, 200.0, 200.0}; /* as chain.yaml has it */
    double part[VTI_TERMS], energy = 0.0;
    vti_bonds binder = {bonds,
                        pair,
                        0,
                        rest,
                        vti_scalars_one(&stiffness[0]),
                        vti_scalars_one(&stiffness[1]),
                        vti_scalars_one(&stiffness[2]),
                        VTI_SHEAR_OBJECTIVE,
                        NULL};
    const vti_effect effect = vti_bonds_effect(&binder);
    const int status = vti_apply(&effect, 1, bodies);
    if (status != VTI_OK)
        give_up(vti_status_text(status), bonds);
    binder.count = ours;
    effect.energy(effect.self, bodies, part);
    for (int64_t k = 0; k < effect.terms; ++k)
        energy += part[k];
    return energy;
}
