/* SPDX-License-Identifier: BSD-3-Clause
 * The scene of test_layouts.py in C: in every layout of arrays, in slices and by threads (OpenMP).        layouts_c TABLE
 * The table: bodies, bonds, planes, steps, h; stiffnesses; planes; bodies; bonds. After "= NAME" one line for each body. */
#include <stdio.h>
#include <stdlib.h>

#include "vti.h"

enum { MOST = 128, BONDS = 512, PLANES = 4, VECTORS = 6, ROOM = 8 * MOST };
enum layout { PACKED, SEPARATE, SPREAD, BACKWARDS, STRUCTS, LAYOUTS };

struct sphere {
    int id;
    double vector[VECTORS][3], mass, inertia;
};

static int64_t n, bonds, planes, steps, pair[BONDS][2];
static double h, stiffness[4], plane[PLANES][4], body[MOST][15], diameter[MOST], rest[BONDS][4];
static double memory[VECTORS][ROOM], mass[MOST], inertia[MOST];
static struct sphere spheres[MOST];
static vti_bonds binder;
static vti_walls walls;

static void must(int good, const char *what)
{
    if (!good) {
        fprintf(stderr, "layouts_c: %s\n", what);
        exit(EXIT_FAILURE);
    }
}

static void ok(int status)
{
    must(status == VTI_OK, vti_status_text(status));
}

static void read_numbers(FILE *file, double *p, int64_t count)
{
    for (int64_t k = 0; k < count; ++k)
        must(fscanf(file, "%lf", &p[k]) == 1, "the table ends early");
}

static void read_table(const char *path)
{
    double head[5], ends[2];
    FILE *file = fopen(path, "r");
    must(file != NULL, path);
    read_numbers(file, head, 5);
    n = (int64_t)head[0], bonds = (int64_t)head[1], planes = (int64_t)head[2], steps = (int64_t)head[3], h = head[4];
    must(n <= MOST && bonds <= BONDS && planes <= PLANES, "too much");
    read_numbers(file, stiffness, 4);
    read_numbers(file, plane[0], 4 * planes);
    read_numbers(file, body[0], 15 * n);
    for (int64_t k = 0; k < bonds; ++k) {
        read_numbers(file, ends, 2);
        pair[k][0] = (int64_t)ends[0], pair[k][1] = (int64_t)ends[1];
    }
    fclose(file);
    for (int64_t i = 0; i < n; ++i)
        diameter[i] = body[i][14];
}

static vti_view view(enum layout layout, int q)
{
    double *p = memory[q];
    const vti_view backwards = {{p + 3 * n - 3, p + 3 * n - 2, p + 3 * n - 1}, -3, 0};
    const vti_view spread = {{p + 5, p, p + 2}, 8, 0};
    switch (layout) {
    case PACKED:
        return vti_view_packed(p);
    case SEPARATE:
        return vti_view_separate(p, p + MOST, p + 2 * MOST);
    case SPREAD:
        return spread;
    case BACKWARDS:
        return backwards;
    default:
        return vti_view_member(spheres[0].vector[q], sizeof spheres[0]);
    }
}

/** The bodies of the table in a layout, loads not yet known. */
static vti_bodies start(enum layout layout)
{
    vti_bodies b = vti_bodies_none(n);
    vti_view *const views[VECTORS] = {&b.x, &b.v, &b.alpha, &b.omega, &b.force, &b.moment};
    for (int q = 0; q < VECTORS; ++q) {
        *views[q] = view(layout, q);
        for (int64_t i = 0; i < n; ++i)
            for (int c = 0; c < 3; ++c)
                views[q]->c[c][i * views[q]->stride] = q < 4 ? body[i][3 * q + c] : -7.0;
    }
    for (int64_t i = 0; i < n; ++i) {
        mass[i] = spheres[i].mass = body[i][12];
        inertia[i] = spheres[i].inertia = body[i][13];
    }
    b.mass = layout == STRUCTS ? vti_scalars_member(&spheres[0].mass, sizeof spheres[0]) : vti_scalars_array(mass);
    b.inertia =
        layout == STRUCTS ? vti_scalars_member(&spheres[0].inertia, sizeof spheres[0]) : vti_scalars_array(inertia);
    ok(vti_bonds_rest(bonds, pair[0], 0, &b.x, rest[0], NULL));
    return b;
}

static void print(const char *name, const vti_bodies *b, int64_t slices)
{
    const vti_view *const views[4] = {&b->x, &b->v, &b->alpha, &b->omega};
    printf("= %s, %lld slices\n", name, (long long)slices);
    for (int64_t i = 0; i < n; ++i)
        for (int k = 0; k < 12; ++k)
            printf("%.17g%c", views[k / 3]->c[k % 3][i * views[k / 3]->stride], k < 11 ? ' ' : '\n');
}

/** What the spheres do to each other and to the walls, on all of them at once. */
static void forces(const vti_bodies *b)
{
    const vti_effect effects[2] = {vti_bonds_effect(&binder), vti_walls_effect(&walls)};
    ok(vti_apply(effects, planes > 0 ? 2 : 1, b));
}

static void each_slice(const vti_bodies *b, int64_t slices, int begins)
{
    const vti_stepper *method = vti_stepper_find("vti2");
#ifdef _OPENMP
#pragma omp parallel for
#endif
    for (int64_t s = 0; s < slices; ++s) {
        const int64_t first = n * s / slices, end = n * (s + 1) / slices;
        const vti_bodies part = vti_bodies_slice(*b, first, end - first);
        ok(begins ? vti_step_begin(method, h, &part, NULL) : vti_step_finish(method, h, &part));
    }
}

static void run(const char *name, enum layout layout, int64_t slices)
{
    const vti_bodies b = start(layout);
    forces(&b);
    for (int64_t k = 0; k < steps; ++k) {
        each_slice(&b, slices, 1);
        forces(&b);
        each_slice(&b, slices, 0);
    }
    print(name, &b, slices);
}

static void run_packed(void)
{
    const vti_bodies b = start(PACKED);
    forces(&b);
    for (int64_t k = 0; k < steps; ++k) {
        ok(vti_packed_begin(1, h, n, memory[0], memory[1], memory[4], memory[2], memory[3], memory[5], n, mass, n,
                            inertia, NULL, NULL));
        forces(&b);
        ok(vti_packed_finish(1, h, n, memory[1], memory[4], memory[3], memory[5], n, mass, n, inertia));
    }
    print("packed arrays", &b, 1);
}

int main(int argc, char **argv)
{
    static const char *const names[LAYOUTS] = {"x[n][3]", "x[n], y[n], z[n]", "columns of a table", "backwards",
                                               "structs"};
    must(argc == 2, "layouts_c TABLE");
    read_table(argv[1]);
    const vti_bonds b = {bonds,
                         pair[0],
                         0,
                         rest[0],
                         vti_scalars_one(&stiffness[0]),
                         vti_scalars_one(&stiffness[1]),
                         vti_scalars_one(&stiffness[2]),
                         VTI_SHEAR_OBJECTIVE};
    const vti_walls w = {planes, plane[0], vti_scalars_array(diameter), stiffness[3]};
    const int64_t slices[] = {1, 2, 3, 7, n};
    binder = b;
    walls = w;
    for (int layout = 0; layout < LAYOUTS; ++layout)
        for (int k = 0; k < 5; ++k)
            run(names[layout], (enum layout)layout, slices[k]);
    run_packed();
    return EXIT_SUCCESS;
}
