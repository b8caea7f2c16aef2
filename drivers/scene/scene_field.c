/* SPDX-License-Identifier: BSD-3-Clause */
#include "scene_field.h"

#include <string.h>

#include "quote.h"
#include "scene.h"

#define AT(member) offsetof(struct scene, member)

static const struct scene_word shear_forms[] = {
    {"objective", VTI_SHEAR_OBJECTIVE}, {"quartic", VTI_SHEAR_QUARTIC}, {"printed", VTI_SHEAR_PRINTED}, {NULL, 0}};

static const struct scene_field fields[] = {
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
     "alpha_z, omega_x omega_y omega_z, mass, inertia and diameter as far as they differ.",
     NULL},
    {"bodies.mass", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(mass), "mass m",
     "Of each body; needed by bodies that translate.", NULL},
    {"bodies.inertia", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(inertia), "moment of inertia J",
     "Of each body about its centre; that of a solid sphere without it, if mass and diameter are known.", NULL},
    {"bodies.diameter", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(diameter), "diameter D",
     "Of each sphere, a length; without it neighbours of a ring, chain or lattice just touch.", NULL},
    {"bodies.x", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(x), "position", "Of a single body's centre, lengths.", NULL},
    {"bodies.v", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(v), "velocity", "Of each body's centre at t = 0.", NULL},
    {"bodies.alpha", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(alpha), "attitude",
     "At t = 0 as a rescaled Rodrigues vector, 2 tan(theta/2) along the axis; 0 is unturned.", NULL},
    {"bodies.omega", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(omega), "angular velocity",
     "Of each body at t = 0 in space, radians per unit of time.", NULL},
    {"bodies.random", SCENE_SECTION, SCENE_MAY, SCENE_ANY, SCENE_NOWHERE, "random velocities",
     "Added to v and omega of each body at t = 0, uniform in each component.", NULL},
    {"bodies.random.seed", SCENE_COUNT, SCENE_MUST, SCENE_NOT_NEGATIVE, AT(random.seed), "seed",
     "The same seed gives the same velocities on every machine.", NULL},
    {"bodies.random.v", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(random.v), "largest component of random v",
     "Velocity: each component lies in [-v, v).", NULL},
    {"bodies.random.omega", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(random.omega),
     "largest component of random omega", "Angular velocity: each component lies in [-omega, omega).", NULL},

    {"binder", SCENE_SECTION, SCENE_MAY, SCENE_ANY, AT(has_binder), "bonds",
     "Elastic bonds between neighbours, or between the bodies of a table; at least one of moment, axial and shear.",
     NULL},
    {"binder.table", SCENE_PATH, SCENE_MAY, SCENE_ANY, AT(binder.table), "file of bonds",
     "CSV or HDF5, relative to the scene's folder: a row for each bond, bodies i and j from 0, and moment, axial and "
     "shear as far as they differ.",
     NULL},
    {"binder.moment", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(binder.moment), "stiffness K^m",
     "Energy: bending and torsion cost K^m/2 |theta|^2, theta being the angle between the bodies.", NULL},
    {"binder.axial", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(binder.axial), "stiffness K^a",
     "Energy: stretching costs K^a/2 (r/L0 - 1)^2.", NULL},
    {"binder.shear", SCENE_SECTION, SCENE_MAY, SCENE_ANY, SCENE_NOWHERE, "shear of bonds",
     "Turning of the bond against its bodies.", NULL},
    {"binder.shear.stiffness", SCENE_NUMBER, SCENE_MUST, SCENE_POSITIVE, AT(binder.shear), "stiffness K^s",
     "Energy: small shear angles gamma cost K^s/2 gamma^2 in the objective form.", NULL},
    {"binder.shear.form", SCENE_WORD, SCENE_MAY, SCENE_ANY, AT(binder.shear_form), "form of the shear energy",
     "objective: unchanged by turning the whole; quartic: the same with the paper's exponent; printed: as in the "
     "paper, not objective.",
     shear_forms},

    {"contact", SCENE_SECTION, SCENE_MAY, SCENE_ANY, AT(has_contact), "contact of the spheres",
     "Hertzian contact between spheres that overlap; pairs are searched for.", NULL},
    {"contact.stiffness", SCENE_NUMBER, SCENE_MUST, SCENE_POSITIVE, AT(contact.stiffness), "stiffness K^pp",
     "Energy: an overlap costs 2/5 K^pp (1 - r/D)^(5/2), D being the mean diameter.", NULL},
    {"contact.bonded", SCENE_YES_NO, SCENE_MAY, SCENE_ANY, AT(contact.bonded), "contact inside bonds",
     "yes: bodies of a common bond touch too; no (default): they do not.", NULL},

    {"wall", SCENE_SECTION, SCENE_MAY, SCENE_ANY, AT(has_wall), "rigid planes",
     "Rigid planes that keep bodies on one side.", NULL},
    {"wall.stiffness", SCENE_NUMBER, SCENE_MUST, SCENE_POSITIVE, AT(wall.stiffness), "stiffness K^pw",
     "Energy: an overlap costs 2/5 K^pw (1 - g/(D/2))^(5/2), g being the distance of the centre.", NULL},
    {"wall.planes", SCENE_PLANES, SCENE_MAY, SCENE_ANY, AT(wall.planes), "planes nx x + ny y + nz z = d",
     "Rows nx, ny, nz, d; bodies stay where n.x > d; n need not be of unit length.", NULL},

    {"gravity", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(gravity), "acceleration g",
     "A uniform field that acts on bodies that translate.", NULL},

    {"pendulum", SCENE_SECTION, SCENE_MAY, SCENE_ANY, AT(has_pendulum), "pivot and weight",
     "Each body hangs by its arm from a pivot that does not move, in a field along +z; bodies turn and cannot "
     "translate.",
     NULL},
    {"pendulum.weight", SCENE_NUMBER, SCENE_MUST, SCENE_NOT_NEGATIVE, AT(pendulum.weight), "weight m g",
     "Force: the mass times the acceleration of the field.", NULL},
    {"pendulum.rho0", SCENE_VECTOR, SCENE_MUST, SCENE_NOT_ZERO, AT(pendulum.rho0), "arm in the body's frame",
     "Length and direction at alpha = 0, from the pivot to where the weight acts.", NULL},

    {"stepper", SCENE_STEPPER, SCENE_MAY, SCENE_ANY, AT(stepper), "integrator",
     "vti2 without it; vti-run --list steppers names them all.", NULL},
    {"h", SCENE_NUMBER, SCENE_MUST, SCENE_POSITIVE, AT(h), "time step", "Time.", NULL},
    {"t_end", SCENE_NUMBER, SCENE_MUST, SCENE_POSITIVE, AT(t_end), "time at which the run ends",
     "Time, counted from t = 0; the run ends at the last multiple of h that is not later.", NULL},
};

enum { FIELDS = sizeof fields / sizeof fields[0] };
typedef char table_fits[(int)FIELDS <= (int)SCENE_FIELDS_MAX ? 1 : -1];

const struct scene_field *scene_field_at(int k)
{
    return k >= 0 && k < FIELDS ? &fields[k] : NULL;
}

const struct scene_field *scene_field_find(const char *path)
{
    for (int k = 0; k < FIELDS; ++k)
        if (strcmp(fields[k].path, path) == 0)
            return &fields[k];
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
    for (int k = 0; k < FIELDS; ++k) {
        const char *key = scene_field_key(&fields[k], section);
        if (key != NULL)
            append(append(out, size, out[0] != '\0' ? ", " : ""), size, key);
    }
    return out;
}

void *scene_field_place(const struct scene_field *field, struct scene *scene)
{
    return field->offset != SCENE_NOWHERE ? (char *)scene + field->offset : NULL;
}

void scene_path_up(char *path)
{
    char *end = path + strlen(path);
    while (end > path && *end != '.' && *end != '[')
        --end;
    *end = '\0';
}
