/* SPDX-License-Identifier: BSD-3-Clause */
#include "scene_field.h"

#include <string.h>

#include "quote.h"
#include "scene.h"

#define AT(member) offsetof(struct scene, member)

static const struct scene_field fields[] = {
    {"name", SCENE_NAME, SCENE_MAY, SCENE_ANY, AT(name), "name of the scene in files"},

    {"bodies", SCENE_SECTION, SCENE_MUST, SCENE_ANY, SCENE_NOWHERE, "spheres"},
    {"bodies.ring", SCENE_SECTION, SCENE_MAY, SCENE_ANY, SCENE_NOWHERE, "ring in the plane z = 0"},
    {"bodies.ring.count", SCENE_COUNT, SCENE_MUST, SCENE_POSITIVE, AT(ring.count), "number of bodies"},
    {"bodies.ring.diameter", SCENE_NUMBER, SCENE_MUST, SCENE_POSITIVE, AT(ring.diameter), "diameter of the ring"},
    {"bodies.ring.center", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(ring.center), "centre of the ring"},
    {"bodies.chain", SCENE_SECTION, SCENE_MAY, SCENE_ANY, SCENE_NOWHERE, "straight chain"},
    {"bodies.chain.count", SCENE_COUNT, SCENE_MUST, SCENE_POSITIVE, AT(chain.count), "number of bodies"},
    {"bodies.chain.spacing", SCENE_NUMBER, SCENE_MUST, SCENE_POSITIVE, AT(chain.spacing), "distance of neighbours"},
    {"bodies.chain.start", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(chain.start), "first body"},
    {"bodies.chain.direction", SCENE_VECTOR, SCENE_MAY, SCENE_NOT_ZERO, AT(chain.direction), "direction of the chain"},
    {"bodies.lattice", SCENE_SECTION, SCENE_MAY, SCENE_ANY, SCENE_NOWHERE, "simple cubic lattice"},
    {"bodies.lattice.counts", SCENE_COUNTS, SCENE_MUST, SCENE_POSITIVE, AT(lattice.counts), "bodies along x, y, z"},
    {"bodies.lattice.spacing", SCENE_NUMBER, SCENE_MUST, SCENE_POSITIVE, AT(lattice.spacing), "distance of neighbours"},
    {"bodies.lattice.corner", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(lattice.corner), "first body"},
    {"bodies.table", SCENE_PATH, SCENE_MAY, SCENE_ANY, AT(table), "file of bodies"},
    {"bodies.mass", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(mass), "mass m"},
    {"bodies.inertia", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(inertia), "moment of inertia J"},
    {"bodies.diameter", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(diameter), "diameter D"},
    {"bodies.x", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(x), "position"},
    {"bodies.v", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(v), "velocity"},
    {"bodies.alpha", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(alpha), "attitude"},
    {"bodies.omega", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(omega), "angular velocity"},
    {"bodies.random", SCENE_SECTION, SCENE_MAY, SCENE_ANY, SCENE_NOWHERE, "random velocities"},
    {"bodies.random.seed", SCENE_COUNT, SCENE_MUST, SCENE_NOT_NEGATIVE, AT(random.seed), "seed"},
    {"bodies.random.v", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(random.v), "largest component of random v"},
    {"bodies.random.omega", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(random.omega),
     "largest component of random omega"},

    {"binder", SCENE_SECTION, SCENE_MAY, SCENE_ANY, AT(has_binder), "bonds"},
    {"binder.table", SCENE_PATH, SCENE_MAY, SCENE_ANY, AT(binder.table), "file of bonds"},
    {"binder.moment", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(binder.moment), "stiffness K^m"},
    {"binder.axial", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(binder.axial), "stiffness K^a"},
    {"binder.shear", SCENE_SECTION, SCENE_MAY, SCENE_ANY, SCENE_NOWHERE, "shear of bonds"},
    {"binder.shear.stiffness", SCENE_NUMBER, SCENE_MUST, SCENE_POSITIVE, AT(binder.shear), "stiffness K^s"},
    {"binder.shear.form", SCENE_SHEAR, SCENE_MAY, SCENE_ANY, AT(binder.shear_form), "form of the shear energy"},

    {"contact", SCENE_SECTION, SCENE_MAY, SCENE_ANY, AT(has_contact), "contact of the spheres"},
    {"contact.stiffness", SCENE_NUMBER, SCENE_MUST, SCENE_POSITIVE, AT(contact.stiffness), "stiffness K^pp"},
    {"contact.bonded", SCENE_YES_NO, SCENE_MAY, SCENE_ANY, AT(contact.bonded), "contact inside bonds"},

    {"wall", SCENE_SECTION, SCENE_MAY, SCENE_ANY, AT(has_wall), "rigid planes"},
    {"wall.stiffness", SCENE_NUMBER, SCENE_MUST, SCENE_POSITIVE, AT(wall.stiffness), "stiffness K^pw"},
    {"wall.planes", SCENE_PLANES, SCENE_MAY, SCENE_ANY, AT(wall.planes), "planes nx x + ny y + nz z = d"},

    {"gravity", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(gravity), "acceleration g"},

    {"pendulum", SCENE_SECTION, SCENE_MAY, SCENE_ANY, AT(has_pendulum), "pivot and weight"},
    {"pendulum.weight", SCENE_NUMBER, SCENE_MUST, SCENE_NOT_NEGATIVE, AT(pendulum.weight), "weight m g"},
    {"pendulum.rho0", SCENE_VECTOR, SCENE_MUST, SCENE_NOT_ZERO, AT(pendulum.rho0), "arm in the body's frame"},

    {"stepper", SCENE_STEPPER, SCENE_MAY, SCENE_ANY, AT(stepper), "integrator"},
    {"h", SCENE_NUMBER, SCENE_MUST, SCENE_POSITIVE, AT(h), "time step"},
    {"t_end", SCENE_NUMBER, SCENE_MUST, SCENE_POSITIVE, AT(t_end), "time at which the run ends"},
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

void scene_path_up(char *path)
{
    char *end = path + strlen(path);
    while (end > path && *end != '.' && *end != '[')
        --end;
    *end = '\0';
}
