/* SPDX-License-Identifier: BSD-3-Clause
 * What there is to step by: the core's steppers, its multistep methods, rivals, and steps of variable length. */
#include <assert.h>
#include <string.h>

#include "rival.h"
#include "scene_stepper.h"
#include "travel.h"

enum { METHODS_MAX = 96 };

static const vti_stepper *methods[METHODS_MAX];
static int64_t methods_count, methods_all; /* those that are listed, and with those that are only found by name */

/* ---- families ---------------------------------------------------------------------------------------------------- */

static const struct rival *integrating_at(int64_t i)
{
    return density_at(i, 0);
}

static const struct rival *naive_at(int64_t i)
{
    return density_at(i, 1);
}

/** What there is beside the steppers of the core: first what is listed, then what scenes may name too, then what is
 *  found by name alone, and last what the control of a scene calls for. */
static const struct rival *(*const families[])(int64_t) = {multistep_at,   rival_at,       tolerance_at, rival_general,
                                                           rival_unlisted, integrating_at, naive_at};

enum { MULTISTEP, LISTED_RIVAL, CONTROLLED, GENERAL, UNLISTED, INTEGRATING, NAIVE, FAMILIES };
enum { LISTED = CONTROLLED, ADMITTED = UNLISTED, FOUND = INTEGRATING };

/* Sets of families. */
enum {
    RIVALS = 1 << LISTED_RIVAL | 1 << GENERAL | 1 << UNLISTED,
    ESTIMATING = 1 << MULTISTEP | 1 << CONTROLLED,
    VARIED = 1 << INTEGRATING | 1 << NAIVE,
    ALL = RIVALS | ESTIMATING | VARIED
};

/** What runs the stepper, of the families of the set; NULL if none of these does. */
static const struct rival *engine_of(const vti_stepper *stepper, int set)
{
    for (int family = 0; family < FAMILIES; ++family)
        for (int64_t i = 0; (set >> family & 1) != 0 && families[family](i) != NULL; ++i)
            if (stepper == &families[family](i)->stepper)
                return families[family](i);
    return NULL;
}

/** The member of a family that is the stepper, or chooses its steps; NULL if none does. */
static const vti_stepper *chooser_of(const vti_stepper *stepper, int family)
{
    for (int64_t i = 0; families[family](i) != NULL; ++i)
        if (stepper == &families[family](i)->stepper || stepper == families[family](i)->table)
            return &families[family](i)->stepper;
    return NULL;
}

static void add(const vti_stepper *method)
{
    assert(methods_all < METHODS_MAX);
    methods[methods_all++] = method;
}

static void collect(void)
{
    for (int64_t i = 0; i < vti_stepper_count(); ++i)
        if (vti_stepper_at(i)->frame == VTI_FRAME_SPACE)
            add(vti_stepper_at(i));
    for (int family = 0; family < FOUND; ++family) {
        for (int64_t i = 0; families[family](i) != NULL; ++i)
            add(&families[family](i)->stepper);
        methods_count = family < LISTED ? methods_all : methods_count;
    }
}

/** What scenes may name beside the steppers of the core. */
static const vti_stepper *admitted_at(int64_t i)
{
    for (int family = 0; family < ADMITTED; ++family)
        for (int64_t k = 0; families[family](k) != NULL; ++k)
            if (i-- == 0)
                return &families[family](k)->stepper;
    return NULL;
}

/* ---- methods ----------------------------------------------------------------------------------------------------- */

void method_admit(void)
{
    scene_stepper_admit(admitted_at);
}

int64_t method_count(void)
{
    if (methods_count == 0)
        collect();
    return methods_count;
}

const vti_stepper *method_at(int64_t i)
{
    return i >= 0 && i < method_count() ? methods[i] : NULL;
}

const vti_stepper *method_named_at(int64_t i)
{
    return i >= 0 && method_count() > 0 && i < methods_all ? methods[i] : NULL;
}

int method_moves(const vti_stepper *method, int moments)
{
    const struct rival *rival = method_rival(method);
    if (rival == NULL)
        return !moments || vti_stepper_find(method->name) != NULL;
    return rival->general == RIVAL_OF_BOTH || moments == (rival->general == RIVAL_OF_MOMENTS);
}

const vti_stepper *method_general_at(int64_t i)
{
    int64_t left = i;
    for (int64_t k = 0; k < method_count(); ++k)
        if (method_moves(method_at(k), 1) && left-- == 0)
            return method_at(k);
    return rival_general(left) != NULL ? &rival_general(left)->stepper : NULL;
}

const vti_stepper *method_find(const char *name)
{
    if (methods_count == 0)
        collect();
    for (int64_t i = 0; name != NULL && i < methods_all; ++i)
        if (strcmp(name, methods[i]->name) == 0)
            return methods[i];
    return NULL;
}

const struct rival *method_rival(const vti_stepper *stepper)
{
    return engine_of(stepper, RIVALS);
}

const struct rival *method_engine(const vti_stepper *stepper)
{
    return engine_of(stepper, ALL);
}

const vti_stepper *method_controlled(const vti_stepper *stepper)
{
    return chooser_of(stepper, CONTROLLED);
}

const vti_stepper *method_for(const struct scene *scene, const vti_stepper *stepper)
{
    if (scene->control != 0)
        return chooser_of(stepper, scene->control == SCENE_NAIVE ? NAIVE : INTEGRATING);
    return scene->tolerance > 0.0 ? chooser_of(stepper, CONTROLLED) : stepper;
}

int method_estimates(const vti_stepper *stepper)
{
    return stepper->estimates > 0 || engine_of(stepper, ESTIMATING) != NULL;
}

int method_is_varied(const vti_stepper *stepper)
{
    return engine_of(stepper, VARIED) != NULL;
}

int method_chooses(const vti_stepper *stepper)
{
    const struct rival *engine = method_engine(stepper);
    return engine != NULL && engine->tally != NULL;
}

int method_varies(const vti_stepper *stepper)
{
    return method_chooses(stepper) || (method_rival(stepper) != NULL && stepper->evals == 0);
}

const char *method_kind(const vti_stepper *stepper)
{
    return method_rival(stepper) != NULL ? "rival" : strncmp(stepper->name, "vti", 3) == 0 ? "paper" : "ours";
}

static int unknown(const char *option, const char *name, size_t length, struct message *message)
{
    char known[768] = "";
    for (int64_t i = 0; i < method_count(); ++i) {
        strncat(known, i > 0 ? ", " : "", sizeof known - strlen(known) - 1);
        strncat(known, method_at(i)->name, sizeof known - strlen(known) - 1);
    }
    return message_set(message, "%s: '%.*s' is not a stepper; known are %s", option, (int)(length < 100 ? length : 100),
                       name, known);
}

int64_t methods_read(const char *option, const char *text, const vti_stepper **list, int64_t most,
                     struct message *message)
{
    int64_t n = 0;
    for (const char *part = text; part != NULL;) {
        const char *comma = strchr(part, ',');
        const size_t length = comma != NULL ? (size_t)(comma - part) : strlen(part);
        char name[64] = "";
        memcpy(name, part, length < sizeof name ? length : 0);
        const vti_stepper *stepper = method_find(name);
        if (stepper == NULL)
            return unknown(option, part, length, message);
        for (int64_t k = 0; k < n; ++k)
            if (list[k] == stepper)
                return message_set(message, "%s: '%s' appears twice; name every stepper once", option, name);
        if (n == most)
            return message_set(message, "%s: more than %lld; use fewer", option, (long long)most);
        list[n++] = stepper;
        part = comma != NULL ? comma + 1 : NULL;
    }
    return n;
}

int methods_width(const vti_stepper *const *list, int64_t n)
{
    size_t width = 14;
    for (int64_t k = 0; k < n; ++k)
        width = strlen(list[k]->name) > width ? strlen(list[k]->name) : width;
    return (int)width;
}
