/* SPDX-License-Identifier: BSD-3-Clause */
#include "scene_field.h"

#include <string.h>

#include "quote.h"
#include "scene.h"

#define AT(member) offsetof(struct scene, member)

static const struct scene_field fields[] = {
    {"name", SCENE_NAME, SCENE_MAY, SCENE_ANY, AT(name), "name of the scene in files"},

    {"bodies", SCENE_SECTION, SCENE_MUST, SCENE_ANY, SCENE_NOWHERE, "spheres"},
    {"bodies.mass", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(mass), "mass m"},
    {"bodies.inertia", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, AT(inertia), "moment of inertia J"},
    {"bodies.x", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(x), "position"},
    {"bodies.v", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(v), "velocity"},
    {"bodies.alpha", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(alpha), "attitude"},
    {"bodies.omega", SCENE_VECTOR, SCENE_MAY, SCENE_ANY, AT(omega), "angular velocity"},

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
