/* SPDX-License-Identifier: BSD-3-Clause
 * What a scene says of walls. */
#include <math.h>

#include "scene.h"
#include "scene_reader.h"
#include "wall.h"

const struct scene_field wall_fields[WALL_FIELDS] = {
    {"wall", SCENE_SECTION, SCENE_MAY, SCENE_ANY, SCENE_NOWHERE, "rigid walls",
     "Rigid planes that keep bodies on one side, and cylinders that keep them inside; at least one of them.", NULL},
    {"wall.stiffness", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, offsetof(struct wall_settings, stiffness),
     "stiffness K^pw", "Energy: an overlap costs 2/5 K^pw (1 - g/(D/2))^(5/2), g being the distance of the centre.",
     NULL},
    {"wall.young", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, offsetof(struct wall_settings, young), "Young's modulus E",
     "Of all walls, with wall.poisson in place of wall.stiffness: K^pw of a body follows from its radius and both "
     "materials, 4/3 E* R^3, 1/E* = (1 - nu_i^2)/E_i + (1 - nu^2)/E; that of the bodies is contact.young, or columns "
     "young and poisson of their table.",
     NULL},
    {"wall.poisson", SCENE_NUMBER, SCENE_MAY, SCENE_POISSON, offsetof(struct wall_settings, poisson),
     "Poisson's ratio nu", "Of the same material.", NULL},
    {"wall.planes", SCENE_PLANES, SCENE_MAY, SCENE_ANY, offsetof(struct wall_settings, planes),
     "planes nx x + ny y + nz z = d", "Rows nx, ny, nz, d; bodies stay where n.x > d; n need not be of unit length.",
     NULL},
    {"wall.stiffnesses", SCENE_NUMBERS, SCENE_MAY, SCENE_POSITIVE, offsetof(struct wall_settings, each),
     "stiffness K^pw of each wall", "In place of stiffness: a number for each plane, then for each cylinder.", NULL},
    {"wall.cylinders", SCENE_CYLINDERS, SCENE_MAY, SCENE_ANY, offsetof(struct wall_settings, cylinders),
     "cylinders about an axis",
     "Rows ax, ay, az, x, y, z, R: the axis, a point on it and the radius; bodies stay inside; a need not be of unit "
     "length.",
     NULL},
    {"wall.velocities", SCENE_VECTORS, SCENE_MAY, SCENE_ANY, offsetof(struct wall_settings, velocities),
     "velocity of each wall",
     "A row for each plane, then for each cylinder; what they put in is the column work_wall, negative. Multistep "
     "steppers and those with negative coefficients are refused.",
     NULL},
    {"wall.spins", SCENE_NUMBERS, SCENE_MAY, SCENE_ANY, offsetof(struct wall_settings, spins), "spin of each wall",
     "A number for each plane, then for each cylinder, radians per unit of time: cylinders turn about their axes, "
     "planes about those normals that go through the origin at t = 0, axes moving with their walls; friction and "
     "dashpots feel it. Steppers as with velocities.",
     NULL},
};

/** A list of walls has a row for each of them, or is left out. */
static int check_list(const struct scene_reader *reader, const char *path, int64_t rows, int64_t walls)
{
    if (!scene_reader_has(reader, path) || rows == walls)
        return 0;
    return scene_reader_fail(reader, path, "%lld rows for %lld walls; give one for each plane, then for each cylinder",
                             (long long)rows, (long long)walls);
}

/** But for rounding of unit vectors. */
static int is_near(double a, double b, double unit)
{
    static const double rounding = 1e-14;
    return fabs(a - b) <= rounding * unit;
}

static int is_along(const double a[3], const double b[3], double sign)
{
    return is_near(a[0], sign * b[0], 1.0) && is_near(a[1], sign * b[1], 1.0) && is_near(a[2], sign * b[2], 1.0);
}

static int is_same_plane(const struct wall_settings *wall, int64_t first, int64_t second)
{
    const double *a = wall->planes.plane[first], *b = wall->planes.plane[second];
    return is_along(a, b, 1.0) && is_near(a[3], b[3], fmax(fabs(a[3]), fabs(b[3])));
}

/** Axes may point either way, from any of their points. */
static int is_same_cylinder(const struct wall_settings *wall, int64_t first, int64_t second)
{
    const double *a = wall->cylinders.cylinder[first], *b = wall->cylinders.cylinder[second];
    double apart[3], off = 0.0, size = 0.0;
    for (int k = 0; k < 3; ++k) {
        apart[k] = b[3 + k] - a[3 + k];
        size = fmax(size, fmax(fabs(a[3 + k]), fabs(b[3 + k])));
    }
    const double along = vti_dot(apart, a);
    for (int k = 0; k < 3; ++k)
        off = fmax(off, fabs(apart[k] - along * a[k]));
    return (is_along(a, b, 1.0) || is_along(a, b, -1.0)) && is_near(a[6], b[6], a[6]) &&
           is_near(off, 0.0, fmax(a[6], size));
}

/** Whether two walls go the same way, so that what is in one place stays so. */
static int go_together(const struct wall_settings *wall, int64_t a, int64_t b)
{
    const double(*v)[3] = wall->velocities.vector;
    return wall->velocities.count == 0 || (v[a][0] == v[b][0] && v[a][1] == v[b][1] && v[a][2] == v[b][2]);
}

/** What is listed twice would push twice; the list begins with wall number first. */
static int check_twice(const struct scene_reader *reader, const char *path, const struct wall_settings *wall,
                       int64_t first, int64_t count,
                       int (*is_same)(const struct wall_settings *wall, int64_t a, int64_t b))
{
    for (int64_t w = 1; w < count; ++w)
        for (int64_t k = 0; k < w; ++k)
            if (is_same(wall, k, w) && go_together(wall, first + k, first + w))
                return scene_reader_fail(reader, path,
                                         "row [%lld] is there a second time, first by row [%lld]; keep one",
                                         (long long)w, (long long)k);
    return 0;
}

int wall_check(const struct scene_reader *reader, const struct scene *scene, const void *settings)
{
    const struct wall_settings *wall = settings;
    const int64_t walls = wall_settings_count(wall);
    const int one = scene_reader_has(reader, "wall.stiffness"), each = scene_reader_has(reader, "wall.stiffnesses");
    const int young = scene_reader_has(reader, "wall.young"), poisson = scene_reader_has(reader, "wall.poisson");
    (void)scene;
    if ((young || poisson) && (one || each))
        return scene_reader_fail(reader, young ? "wall.young" : "wall.poisson", "given with wall.%s; keep one of them",
                                 one ? "stiffness" : "stiffnesses");
    if (young != poisson)
        return scene_reader_fail(reader, young ? "wall.young" : "wall.poisson", "needs wall.%s; give both",
                                 young ? "poisson" : "young");
    if (!young && !one && !each)
        return scene_reader_fail(reader, "wall.stiffness", "missing; add 'stiffness:', the stiffness K^pw");
    if (one && each)
        return scene_reader_fail(reader, "wall.stiffnesses", "given with wall.stiffness; keep one of them");
    if (walls == 0)
        return scene_reader_fail(reader, "wall.planes", "no planes; give a list of them, such as [[1, 0, 0, 0]]");
    return check_list(reader, "wall.stiffnesses", wall->each.count, walls) != 0 ||
                   check_list(reader, "wall.velocities", wall->velocities.count, walls) != 0 ||
                   check_list(reader, "wall.spins", wall->spins.count, walls) != 0 ||
                   check_twice(reader, "wall.planes", wall, 0, wall->planes.count, is_same_plane) != 0 ||
                   check_twice(reader, "wall.cylinders", wall, wall->planes.count, wall->cylinders.count,
                               is_same_cylinder) != 0
               ? -1
               : 0;
}
