/* SPDX-License-Identifier: BSD-3-Clause */
#include "scene_field.h"

#include <string.h>

#include "kind.h"
#include "quote.h"
#include "scene.h"

#define AT(member) offsetof(struct scene, member)

/** Before and behind those of the effects. */
static const struct scene_field head[] = {
    {"name", SCENE_NAME, SCENE_MAY, SCENE_ANY, AT(name), "name of the scene in files",
     "Outputs are called after it; without it, after the scene's file.", NULL},

    {"bodies", SCENE_SECTION, SCENE_MUST, SCENE_ANY, SCENE_NOWHERE, "spheres",
     "Their positions come from one of ring, chain, lattice, table and x; without any of them nothing translates.",
     NULL},
    {"bodies.ring", SCENE_SECTION, SCENE_MAY, SCENE_ANY, SCENE_NOWHERE, "ring in the plane z = 0",
     "Body k stands at the angle 2 pi k/count from +x about the centre; neighbours are k and k + 1, and the last and "
     "the first.",
     NULL},
    {"bodies.ring.count", SCENE_COUNT, SCENE_MUST, SCENE_POSITIVE, AT(ring.count), "number of bodies", "At least 3.",
     NULL},
    {"bodies.ring.diameter", SCENE_NUMBER, SCENE_MUST, SCENE_POSITIVE, AT(ring.diameter), "diameter of the ring",
     "Length, through the bodies' centres.", NULL},
    {"bodies.ring.center", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(ring.center), "centre of the ring",
     "Lengths; the origin without it.", NULL},
    {"bodies.chain", SCENE_SECTION, SCENE_MAY, SCENE_ANY, SCENE_NOWHERE, "straight chain",
     "Body k stands at start + k spacing along the direction; neighbours are k and k + 1.", NULL},
    {"bodies.chain.count", SCENE_COUNT, SCENE_MUST, SCENE_POSITIVE, AT(chain.count), "number of bodies", "1 or more.",
     NULL},
    {"bodies.chain.spacing", SCENE_NUMBER, SCENE_MUST, SCENE_POSITIVE, AT(chain.spacing), "distance of neighbours",
     "Length from centre to centre, and the diameter of bodies that are given none.", NULL},
    {"bodies.chain.start", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(chain.start), "first body",
     "Lengths; the origin without it.", NULL},
    {"bodies.chain.direction", SCENE_VECTOR, SCENE_MAY, SCENE_NOT_ZERO, AT(chain.direction), "direction of the chain",
     "Of any length; +x without it.", NULL},
    {"bodies.lattice", SCENE_SECTION, SCENE_MAY, SCENE_ANY, SCENE_NOWHERE, "simple cubic lattice",
     "Bodies stand at corner + spacing (i, j, k), i running fastest; neighbours are those along x, y and z.", NULL},
    {"bodies.lattice.counts", SCENE_COUNTS, SCENE_MUST, SCENE_POSITIVE, AT(lattice.counts), "bodies along x, y, z",
     "1 or more along each axis.", NULL},
    {"bodies.lattice.spacing", SCENE_NUMBER, SCENE_MUST, SCENE_POSITIVE, AT(lattice.spacing), "distance of neighbours",
     "Length from centre to centre, and the diameter of bodies that are given none.", NULL},
    {"bodies.lattice.corner", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(lattice.corner), "first body",
     "Lengths; the origin without it.", NULL},
    {"bodies.table", SCENE_PATH, SCENE_MAY, SCENE_ANY, AT(table), "file of bodies",
     "CSV or HDF5, relative to the scene's folder: a row for each body, columns of x y z, vx vy vz, alpha_x alpha_y "
     "alpha_z, omega_x omega_y omega_z, moment_a moment_b moment_c, principal_x principal_y principal_z, mass, "
     "inertia, diameter, young and poisson, and clump as far as they differ.",
     NULL},
    {"bodies.mass", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(mass), "mass m",
     "Of each body; needed by bodies that translate.", NULL},
    {"bodies.density", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(density), "density",
     "Mass per volume of solid spheres, in the place of mass: each has that of its diameter.", NULL},
    {"bodies.inertia", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(inertia), "moment of inertia J",
     "Of each body about its centre; that of a solid sphere without it, if mass and diameter are known.", NULL},
    {"bodies.moments", SCENE_VECTOR, SCENE_MAY, SCENE_POSITIVE, AT(moments), "principal moments of inertia A, B, C",
     "Of each body about its centre, in place of inertia; none is more than the sum of the others. Not with multistep "
     "methods; of the rivals, with those that vti-run --list steppers marks \"bodies of three moments\" and with "
     "Runge-Kutta methods.",
     NULL},
    {"bodies.principal", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(principal),
     "attitude of the principal axes in the body",
     "As alpha: turns x, y and z of the body to the axes of A, B and C; without it, they are those.", NULL},
    {"bodies.diameter", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(diameter), "diameter D",
     "Of each sphere, a length; without it neighbours of a ring, chain or lattice just touch.", NULL},
    {"bodies.clumps", SCENE_SECTION, SCENE_MAY, SCENE_ANY, SCENE_NOWHERE, "bodies of several spheres each",
     "Each body moves as one solid and stands where its centre of mass is; contacts and walls act on its spheres, all "
     "else on the body, drag and bonds on either. Mass, moments and principal axes are those of the spheres' union, by "
     "256 lines across a sphere that overlaps others. All templates together have at most 128 spheres. Bonds of clumps "
     "neither break nor are made on the way.",
     NULL},
    {"bodies.clumps.spheres", SCENE_SPHERES, SCENE_MUST, SCENE_ANY, AT(clumps.spheres), "spheres of the templates",
     "Lengths: centre and diameter of each in the body at alpha = 0, from any point.", NULL},
    {"bodies.clumps.counts", SCENE_NUMBERS, SCENE_MAY, SCENE_POSITIVE, AT(clumps.counts), "spheres of each template",
     "How many of the spheres, one behind the other, make each; all make one without it. Body k is of template k "
     "modulo their number, or of that in column clump of the table, from 0.",
     NULL},
    {"bodies.clumps.density", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(clumps.density), "density",
     "Mass per volume of all spheres, in the place of bodies.mass.", NULL},
    {"bodies.x", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(x), "position",
     "Of a single body's centre, lengths; goes with bodies.v.", NULL},
    {"bodies.v", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(v), "velocity", "Of each body's centre at t = 0.", NULL},
    {"bodies.alpha", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(alpha), "attitude",
     "At t = 0 as a rescaled Rodrigues vector, 2 tan(theta/2) along the axis; 0 is unturned. Goes with bodies.omega "
     "where a single body is given by them.",
     NULL},
    {"bodies.omega", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(omega), "angular velocity",
     "Of each body at t = 0 in space, radians per unit of time.", NULL},
    {"bodies.random", SCENE_SECTION, SCENE_MAY, SCENE_ANY, SCENE_NOWHERE, "random velocities",
     "Added to v, omega and alpha of each body at t = 0, uniform in each component.", NULL},
    {"bodies.random.seed", SCENE_COUNT, SCENE_MUST, SCENE_NOT_NEGATIVE, AT(random.seed), "seed",
     "The same seed gives the same velocities on every machine.", NULL},
    {"bodies.random.v", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(random.v), "largest component of random v",
     "Velocity: each component lies in [-v, v).", NULL},
    {"bodies.random.omega", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(random.omega),
     "largest component of random omega", "Angular velocity: each component lies in [-omega, omega).", NULL},
    {"bodies.random.alpha", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(random.alpha),
     "largest component of random alpha", "Attitude: each component lies in [-alpha, alpha); 2 is a quarter of a turn.",
     NULL},
};

static const struct scene_word rotors[] = {{"2", 2}, {"4", 4}, {"6", 6}, {NULL, 0}};

static const struct scene_word controls[] = {{"integrating", SCENE_INTEGRATING}, {"naive", SCENE_NAIVE}, {NULL, 0}};

static const struct scene_field tail[] = {
    {"stepper", SCENE_STEPPER, SCENE_MAY, SCENE_ANY, AT(stepper), "integrator",
     "vti2 without it; vti-run --list steppers names them all.", NULL},
    {"rotor", SCENE_WORD, SCENE_MAY, SCENE_ANY, AT(rotor), "order of the free rotation",
     "Of bodies of three moments: 2, 4 or 6, by 3, 5 or 21 turns per drift. Default: 4 with exact, srkn6 and chin4, 6 "
     "with srkn11 and srkn14, else 2. Rivals have their own.",
     rotors},
    {"h", SCENE_NUMBER, SCENE_MUST, SCENE_POSITIVE, AT(h), "time step", "Time.", NULL},
    {"tolerance", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(tolerance), "estimated error of a step",
     "Velocity and angular velocity; the stepper, srkn11, srkn14 or srkn6, chooses its steps by it; h is then what is "
     "between rows and the first step that is tried, and 2^-26 h the shortest step.",
     NULL},
    {"control", SCENE_WORD, SCENE_MAY, SCENE_ANY, AT(control), "steps that follow how fast bodies turn",
     "A step is about h/sqrt(1 + |Omega|^2/turning^2), |Omega|^2 the mean over the bodies: integrating leaves no drift "
     "of the energy, naive is there to compare with; of reversible steppers such as srkn6 and srkn11, without contacts "
     "and dissipation, and h is also what rows are multiples of.",
     controls},
    {"speed", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(speed), "unit of a step's error in velocity",
     "Velocity; 1 without it. Goes with a tolerance.", NULL},
    {"turning", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(turning), "angular velocity of the scene",
     "Angular velocity; 1 without it. With a tolerance the unit of a step's error in angular velocity, with a control "
     "that of the bodies' turning.",
     NULL},
    {"t_end", SCENE_NUMBER, SCENE_MUST, SCENE_POSITIVE, AT(t_end), "time at which the run ends",
     "Time, counted from t = 0; the run ends at the last multiple of h that is not later.", NULL},
};

enum { HEAD = sizeof head / sizeof head[0], TAIL = sizeof tail / sizeof tail[0] };

const char *scene_control_word(const struct scene *scene)
{
    for (const struct scene_word *w = controls; w->word != NULL; ++w)
        if (w->value == scene->control)
            return w->word;
    return NULL;
}

const struct scene_rows *scene_rows_of(enum scene_kind kind)
{
    static const struct scene_rows planes = {
        4, SCENE_PLANES_MAX, "planes", "four numbers nx, ny, nz, d", "[1, 0, 0, 0]", "[[1, 0, 0, 0], [0, 1, 0, 0]]"};
    static const struct scene_rows cylinders = {7,
                                                SCENE_CYLINDERS_MAX,
                                                "cylinders",
                                                "seven numbers ax, ay, az, x, y, z, R",
                                                "[0, 1, 0, 0, 0, 0, 5]",
                                                "[[0, 1, 0, 0, 0, 0, 5]]"};
    static const struct scene_rows spheres = {
        4, SCENE_SPHERES_MAX, "spheres", "four numbers x, y, z, D", "[0, 0, 0, 1]", "[[0, 0, 0, 1], [1, 0, 0, 1]]"};
    static const struct scene_rows vectors = {3,           SCENE_WALLS_MAX,         "vectors", "three numbers",
                                              "[0, 0, 1]", "[[0, 0, 1], [0, 0, 0]]"};
    static const struct scene_rows numbers = {1, SCENE_WALLS_MAX, "numbers", NULL, NULL, "[1, 2]"};
    return kind == SCENE_PLANES      ? &planes
           : kind == SCENE_CYLINDERS ? &cylinders
           : kind == SCENE_SPHERES   ? &spheres
           : kind == SCENE_VECTORS   ? &vectors
           : kind == SCENE_NUMBERS   ? &numbers
                                     : NULL;
}

const struct scene_field *scene_field_at(int k)
{
    if (k >= 0 && k < HEAD)
        return &head[k];
    k -= HEAD;
    for (int e = 0; k >= 0 && e < EFFECT_COUNT; ++e) {
        if (k < kinds_at(e)->fields_count)
            return &kinds_at(e)->fields[k];
        k -= kinds_at(e)->fields_count;
    }
    return k >= 0 && k < TAIL ? &tail[k] : NULL;
}

const struct scene_field *scene_field_find(const char *path)
{
    for (int k = 0; scene_field_at(k) != NULL; ++k)
        if (strcmp(scene_field_at(k)->path, path) == 0)
            return scene_field_at(k);
    return NULL;
}

const char *scene_field_key(const struct scene_field *field, const char *section)
{
    const size_t n = strlen(section);
    const char *key = field->path;
    if (n > 0) {
        if (strncmp(key, section, n) != 0 || key[n] != '.')
            return NULL;
        key += n + 1;
    }
    return strchr(key, '.') == NULL ? key : NULL;
}

char *scene_field_list(const char *section, char *out, size_t size)
{
    out[0] = '\0';
    for (int k = 0; scene_field_at(k) != NULL; ++k) {
        const char *key = scene_field_key(scene_field_at(k), section);
        if (key != NULL)
            quote_append(quote_append(out, size, out[0] != '\0' ? ", " : ""), size, key);
    }
    return out;
}

void *scene_field_place(const struct scene_field *field, struct scene *scene)
{
    const struct effect_kind *kind = kinds_find(field->path);
    if (field->offset == SCENE_NOWHERE)
        return NULL;
    return (char *)(kind != NULL ? kinds_settings(kind, &scene->settings) : scene) + field->offset;
}

void scene_path_up(char *path)
{
    char *end = path + strlen(path);
    while (end > path && *end != '.' && *end != '[')
        --end;
    *end = '\0';
}
