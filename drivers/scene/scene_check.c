/* SPDX-License-Identifier: BSD-3-Clause */
#include "scene_value.h"

#include <math.h>
#include <string.h>

#include "kind.h"
#include "number.h"
#include "quote.h"

static int has(const struct scene_reader *reader, const char *path)
{
    return scene_reader_has(reader, path);
}

/* ---- where the bodies are ---------------------------------------------------------------------------------------- */

#define POSITIONS "bodies.x and bodies.v, or bodies.ring, chain, lattice or table"

/** In the order of enum scene_arrangement. */
static const char *const arrangements[] = {"bodies.x", "bodies.ring", "bodies.chain", "bodies.lattice", "bodies.table"};
enum { ARRANGEMENTS = sizeof arrangements / sizeof arrangements[0] };

static int check_arrangement(const struct scene_reader *reader, struct scene *scene)
{
    const char *first = NULL;
    for (int k = 0; k < ARRANGEMENTS; ++k) {
        if (!has(reader, arrangements[k]))
            continue;
        if (first != NULL)
            return scene_reader_fail(reader, arrangements[k],
                                     "given besides %s; positions come from one of x, ring, chain, lattice and table",
                                     first);
        first = arrangements[k];
        scene->arrangement = (enum scene_arrangement)k;
    }
    return 0;
}

const char *scene_positions_key(const struct scene *scene)
{
    return arrangements[scene->arrangement];
}

static int check_count(const struct scene_reader *reader, const char *path, int64_t count)
{
    if (count <= SCENE_BODIES_MAX)
        return 0;
    return scene_reader_fail(reader, path, "more than %d bodies; give fewer", SCENE_BODIES_MAX);
}

/** Their number, factor by factor, so that no product overflows. */
static int check_lattice(const struct scene_reader *reader, const struct scene_lattice *lattice)
{
    double count = 1.0;
    for (int k = 0; k < 3; ++k)
        count *= (double)lattice->counts[k];
    return check_count(reader, "bodies.lattice.counts", count > 0x1p62 ? INT64_MAX : (int64_t)count);
}

static int check_counts(const struct scene_reader *reader, const struct scene *scene)
{
    switch (scene->arrangement) {
    case SCENE_IN_RING:
        if (scene->ring.count < 3)
            return scene_reader_fail(reader, "bodies.ring.count", "'%lld' bodies make no ring; give at least 3",
                                     (long long)scene->ring.count);
        return check_count(reader, "bodies.ring.count", scene->ring.count);
    case SCENE_IN_CHAIN:
        return check_count(reader, "bodies.chain.count", scene->chain.count);
    case SCENE_IN_LATTICE:
        return check_lattice(reader, &scene->lattice);
    case SCENE_SINGLE:
    case SCENE_IN_TABLE:
        break;
    }
    return 0;
}

/** The ring, chain or lattice, of which positions and the diameter are known. */
static int is_formula(const struct scene *scene)
{
    return scene->arrangement != SCENE_SINGLE && scene->arrangement != SCENE_IN_TABLE;
}

int64_t scene_bodies(const struct scene *scene)
{
    const int64_t *n = scene->lattice.counts;
    return scene->arrangement == SCENE_IN_RING      ? scene->ring.count
           : scene->arrangement == SCENE_IN_CHAIN   ? scene->chain.count
           : scene->arrangement == SCENE_IN_LATTICE ? n[0] * n[1] * n[2]
           : scene->arrangement == SCENE_IN_TABLE   ? 0
                                                    : 1;
}

int64_t scene_templates(const struct scene *scene)
{
    return !scene->clumps.given ? 0 : scene->clumps.counts.count > 0 ? scene->clumps.counts.count : 1;
}

/* ---- how they move ----------------------------------------------------------------------------------------------- */

/** Both fields or neither, of a single body. */
static int check_pair(const struct scene_reader *reader, const struct scene *scene, const char *a, const char *b)
{
    const int has_a = has(reader, a), has_b = has(reader, b);
    if (scene->arrangement != SCENE_SINGLE || has_a == has_b)
        return 0;
    return scene_reader_fail(reader, has_a ? a : b, "given without %s; give both or neither", has_a ? b : a);
}

static int check_random(const struct scene_reader *reader, const struct scene *scene)
{
    if (!has(reader, "bodies.random"))
        return 0;
    if (scene->random.v == 0.0 && scene->random.omega == 0.0 && scene->random.alpha == 0.0)
        return scene_reader_fail(reader, "bodies.random", "none of v, omega and alpha; give one of them or more");
    if (scene->random.v != 0.0 && !scene->translates && scene->arrangement != SCENE_IN_TABLE)
        return scene_reader_fail(reader, "bodies.random.v", "nothing translates; give " POSITIONS);
    return 0;
}

static int check_motion(const struct scene_reader *reader, struct scene *scene)
{
    if (check_pair(reader, scene, "bodies.x", "bodies.v") != 0 ||
        check_pair(reader, scene, "bodies.alpha", "bodies.omega") != 0)
        return -1;
    scene->has_v = has(reader, "bodies.v");
    scene->has_alpha = has(reader, "bodies.alpha");
    scene->has_omega = has(reader, "bodies.omega");
    for (int k = 0; k < EFFECT_COUNT; ++k)
        scene->has[k] = has(reader, kinds_at(k)->key);
    scene->translates = is_formula(scene) || has(reader, "bodies.x");
    scene->clumps.given = has(reader, "bodies.clumps");
    scene->turns = scene->has_alpha || scene->has_omega || scene->random.omega != 0.0 || scene->random.alpha != 0.0 ||
                   scene->clumps.given;
    for (int k = 0; k < EFFECT_COUNT; ++k)
        scene->turns |= scene->has[k] && (kinds_draft(kinds_at(k), &scene->settings, NULL).gives & EFFECT_MOMENT) != 0;
    if (!scene->translates && !scene->turns && scene->arrangement != SCENE_IN_TABLE)
        return scene_reader_fail(reader, "bodies",
                                 "nothing moves; give " POSITIONS ", or bodies.alpha and bodies.omega");
    return check_random(reader, scene);
}

/* ---- what they need ---------------------------------------------------------------------------------------------- */

static int check_needed(const struct scene_reader *reader, int missing, const char *path, const char *who)
{
    if (!missing)
        return 0;
    return scene_reader_fail(reader, path, "missing; %s need it, the %s", who, scene_field_find(path)->about);
}

/** Three moments that a body can have, and nothing else that says the same. */
static int check_moments(const struct scene_reader *reader, const struct scene *scene)
{
    vti_bodies body = vti_bodies_none(1);
    double moments[3] = {scene->moments[0], scene->moments[1], scene->moments[2]};
    body.moments = (vti_view){{moments, moments + 1, moments + 2}, 0, 0};
    if (!has(reader, "bodies.moments") && !has(reader, "bodies.principal"))
        return 0;
    if (!has(reader, "bodies.moments"))
        return scene_reader_fail(reader, "bodies.principal", "given without bodies.moments; give both or neither");
    if (has(reader, "bodies.inertia"))
        return scene_reader_fail(reader, "bodies.moments",
                                 "given besides bodies.inertia, which spheres have; keep one");
    for (int k = 0; k < 3; ++k)
        if (!number_divides(moments[k]))
            return scene_reader_fail(reader, "bodies.moments",
                                     "%s is too small to divide by; choose units in which it is larger",
                                     NUMBER(moments[k]));
    if (vti_bodies_check(&body) != VTI_OK)
        return scene_reader_fail(reader, "bodies.moments",
                                 "one of %.10g, %.10g, %.10g is more than the sum of the others; no body has such "
                                 "moments, give smaller ones",
                                 moments[0], moments[1], moments[2]);
    return 0;
}

/** Numbers of spheres that make up all of them. */
static int check_counts_of_spheres(const struct scene_reader *reader, const struct scene_clumps *clumps)
{
    double sum = 0.0;
    for (int64_t k = 0; k < clumps->counts.count; ++k) {
        if (clumps->counts.number[k] != floor(clumps->counts.number[k]))
            return scene_reader_fail(reader, "bodies.clumps.counts", "%s is not a whole number; spheres are counted",
                                     NUMBER(clumps->counts.number[k]));
        sum += clumps->counts.number[k];
    }
    if (clumps->counts.count == 0 || sum == (double)clumps->spheres.count)
        return 0;
    return scene_reader_fail(reader, "bodies.clumps.counts", "%s spheres in all, and there are %lld; count each once",
                             NUMBER(sum), (long long)clumps->spheres.count);
}

/** A sphere that a template has twice would feel all that acts on it twice. */
static int check_twice(const struct scene_reader *reader, const struct scene_clumps *clumps)
{
    const int64_t templates = clumps->counts.count > 0 ? clumps->counts.count : 1;
    int64_t first = 0;
    for (int64_t t = 0; t < templates; ++t) {
        const int64_t end =
            clumps->counts.count > 0 ? first + (int64_t)clumps->counts.number[t] : clumps->spheres.count;
        for (int64_t s = first; s < end; ++s)
            for (int64_t k = first; k < s; ++k) {
                const double *a = clumps->spheres.sphere[k], *b = clumps->spheres.sphere[s];
                if (a[0] == b[0] && a[1] == b[1] && a[2] == b[2] && a[3] == b[3])
                    return scene_reader_fail(reader, "bodies.clumps.spheres",
                                             "row [%lld] is there a second time, first by row [%lld]; keep one",
                                             (long long)s, (long long)k);
            }
        first = end;
    }
    return 0;
}

/** Spheres say how large their clump is and how it turns. */
static int check_clumps(const struct scene_reader *reader, const struct scene *scene)
{
    static const char *const instead[] = {"bodies.inertia", "bodies.moments", "bodies.diameter", "bodies.density"};
    if (!scene->clumps.given)
        return 0;
    for (size_t k = 0; k < sizeof instead / sizeof instead[0]; ++k)
        if (has(reader, instead[k]))
            return scene_reader_fail(reader, instead[k],
                                     "given besides bodies.clumps, whose spheres say it; leave it out");
    if (scene->clumps.spheres.count == 0)
        return scene_reader_fail(reader, "bodies.clumps.spheres", "no spheres; give rows x, y, z, D");
    if (scene->clumps.density != 0.0 && has(reader, "bodies.mass"))
        return scene_reader_fail(reader, "bodies.clumps.density", "given besides bodies.mass; keep one of them");
    if (!scene->translates && scene->arrangement != SCENE_IN_TABLE)
        return scene_reader_fail(reader, "bodies.clumps", "has no position; give " POSITIONS);
    return check_counts_of_spheres(reader, &scene->clumps) != 0 ? -1 : check_twice(reader, &scene->clumps);
}

struct scene_known scene_knows(const struct scene *scene, struct scene_known table)
{
    struct scene_known known = table;
    known.mass |= scene->mass != 0.0 || scene->density != 0.0 || scene->clumps.density != 0.0;
    known.diameter |= scene->diameter != 0.0 || scene->clumps.given || is_formula(scene);
    known.inertia |=
        scene->inertia != 0.0 || scene->moments[0] != 0.0 || scene->clumps.given || (known.mass && known.diameter);
    return known;
}

/** Without a table nobody else says. */
static int check_properties(const struct scene_reader *reader, const struct scene *scene)
{
    const struct scene_known none = {0, 0, 0}, known = scene_knows(scene, none);
    if (check_moments(reader, scene) != 0 || check_clumps(reader, scene) != 0)
        return -1;
    if (scene->density != 0.0 && has(reader, "bodies.mass"))
        return scene_reader_fail(reader, "bodies.density", "given besides bodies.mass; keep one of them");
    if (scene->arrangement == SCENE_IN_TABLE)
        return 0;
    if (check_needed(reader, scene->translates && !known.mass, "bodies.mass", "bodies that translate") != 0 ||
        check_needed(reader, scene->density != 0.0 && !known.diameter, "bodies.diameter", "spheres of a density") !=
            0 ||
        check_needed(reader, scene->turns && !known.inertia, "bodies.inertia", "bodies that turn") != 0)
        return -1;
    return check_needed(reader, scene_first_with(scene, EFFECT_SPHERES) != NULL && !known.diameter, "bodies.diameter",
                        "spheres in contact");
}

/* ---- effects ----------------------------------------------------------------------------------------------------- */

const char *scene_first_with(const struct scene *scene, enum effect_trait trait)
{
    for (int k = 0; k < EFFECT_COUNT; ++k)
        if (scene->has[k] && kinds_has(kinds_at(k), &scene->settings, trait))
            return kinds_at(k)->key;
    return NULL;
}

static int check_effect(const struct scene_reader *reader, const struct scene *scene, const struct effect_kind *kind)
{
    if (kind->check != NULL && kind->check(reader, scene, kinds_settings_of(kind, &scene->settings)) != 0)
        return -1;
    if (!kinds_has(kind, &scene->settings, EFFECT_TRANSLATING) || scene->translates ||
        scene->arrangement == SCENE_IN_TABLE)
        return 0;
    return scene_reader_fail(reader, kind->key, "acts on bodies that translate; give " POSITIONS);
}

static int check_effects(const struct scene_reader *reader, const struct scene *scene)
{
    for (int k = 0; k < EFFECT_COUNT; ++k)
        if (scene->has[k] && check_effect(reader, scene, kinds_at(k)) != 0)
            return -1;
    return 0;
}

/* ---- time -------------------------------------------------------------------------------------------------------- */

/** Steps are counted in a double (t = step h), which holds whole numbers up to 2^53. */
static int check_steps(const struct scene_reader *reader, const struct scene *scene)
{
    if (scene->t_end / scene->h <= 0x1p53)
        return 0;
    char t_end[QUOTE_SIZE], h[QUOTE_SIZE];
    return scene_reader_fail(reader, "t_end", "'%s' is more than 2^53 steps of h = %s; take a larger h",
                             quote(t_end, sizeof t_end, scene_reader_value(reader, "t_end")),
                             quote(h, sizeof h, scene_reader_value(reader, "h")));
}

/** Bodies whose turn has parts, and a stepper that is made of them. */
static int check_rotor(const struct scene_reader *reader, const struct scene *scene)
{
    if (scene->rotor == 0)
        return 0;
    if (scene->stepper->kick == NULL)
        return scene_reader_fail(reader, "rotor",
                                 "the stepper %s is no list of kicks and drifts, and turns bodies in its own way; take "
                                 "vti2 or leave it out",
                                 scene->stepper->name);
    if (has(reader, "bodies.moments") || scene->clumps.given || scene->arrangement == SCENE_IN_TABLE)
        return 0;
    return scene_reader_fail(reader, "rotor",
                             "a sphere's turn is one, of any order; give bodies.moments or bodies.clumps, or leave it "
                             "out");
}

/** Steps go by a tolerance or by a control, and only then have units. */
static int check_control(const struct scene_reader *reader, const struct scene *scene)
{
    const int steered = scene->control != 0 || scene->tolerance > 0.0;
    if (scene->control != 0 && scene->tolerance > 0.0)
        return scene_reader_fail(reader, "control",
                                 "given besides tolerance: steps go by how fast bodies turn or by their errors; keep "
                                 "one");
    if (scene->speed > 0.0 && !(scene->tolerance > 0.0))
        return scene_reader_fail(reader, "speed", "given without a tolerance, whose unit it is; give both or neither");
    if (scene->turning > 0.0 && !steered)
        return scene_reader_fail(reader, "turning",
                                 "given without a tolerance or a control, whose unit it is; give one of them, or leave "
                                 "it out");
    return 0;
}

int scene_check(const struct scene_reader *reader, struct scene *scene)
{
    if (check_arrangement(reader, scene) != 0 || check_counts(reader, scene) != 0 || check_motion(reader, scene) != 0 ||
        check_effects(reader, scene) != 0 || check_properties(reader, scene) != 0)
        return -1;
    if (check_rotor(reader, scene) != 0 || check_control(reader, scene) != 0)
        return -1;
    return check_steps(reader, scene);
}
