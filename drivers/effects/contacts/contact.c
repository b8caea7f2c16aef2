/* SPDX-License-Identifier: BSD-3-Clause
 * Contact: Hertzian, between spheres that overlap (EQUATIONS 3). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "contact.h"
#include "hertz.h"
#include "model.h"
#include "scene_reader.h"
#include "shape.h"
#include "tables.h"

struct contact_settings {
    double stiffness;      /* 0: that of a material */
    double young, poisson; /* of the material, if there is one */
    int64_t bonded;        /* 1: also between bodies that are held together */
};

/* ---- what a scene says ------------------------------------------------------------------------------------------- */

static const struct scene_field fields[] = {
    {"contact", SCENE_SECTION, SCENE_MAY, SCENE_ANY, SCENE_NOWHERE, "contact of the spheres",
     "Hertzian contact between spheres that overlap; pairs are searched for.", NULL},
    {"contact.stiffness", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, offsetof(struct contact_settings, stiffness),
     "stiffness K^pp",
     "Energy, the same for all pairs: an overlap costs 2/5 K^pp (1 - r/D)^(5/2), D being the mean diameter.", NULL},
    {"contact.young", SCENE_NUMBER, SCENE_MAY, SCENE_POSITIVE, offsetof(struct contact_settings, young),
     "Young's modulus E",
     "Force per area, 70e9 of glass in SI units; with contact.poisson in place of contact.stiffness: K^pp of a pair "
     "follows from its radii, 2/3 E/(1 - nu^2) sqrt(R) D^(5/2), 1/R = 1/R_i + 1/R_j. Bodies of several materials have "
     "columns young and poisson in their table, and contact gives none: 1/E* = (1 - nu_i^2)/E_i + (1 - nu_j^2)/E_j.",
     NULL},
    {"contact.poisson", SCENE_NUMBER, SCENE_MAY, SCENE_POISSON, offsetof(struct contact_settings, poisson),
     "Poisson's ratio nu", "Of the same material.", NULL},
    {"contact.bonded", SCENE_YES_NO, SCENE_MAY, SCENE_ANY, offsetof(struct contact_settings, bonded),
     "contact inside bonds", "yes: bodies of a common bond touch too; no (default): they do not.", NULL},
};

static int check(const struct scene_reader *reader, const struct scene *scene, const void *settings)
{
    const int young = scene_reader_has(reader, "contact.young"), poisson = scene_reader_has(reader, "contact.poisson");
    (void)settings;
    if (scene_reader_has(reader, "contact.stiffness")) {
        if (young || poisson)
            return scene_reader_fail(reader, young ? "contact.young" : "contact.poisson",
                                     "given with contact.stiffness; keep one of them");
        return 0;
    }
    if (!young && !poisson && scene->arrangement == SCENE_IN_TABLE) /* which may have the bodies' own */
        return 0;
    if (!young || !poisson)
        return scene_reader_fail(reader, "contact",
                                 "no stiffness; give contact.stiffness, or contact.young and contact.poisson");
    return 0;
}

/** Stiffness has one source: the scene or the material of the bodies. */
static int check_tables(const struct model *model, const void *settings, const struct tables *tables,
                        struct message *message)
{
    const struct contact_settings *contact = settings;
    const struct table *bodies = &tables->bodies;
    (void)model;
    if (contact->young > 0.0 && table_has(bodies, BODY_YOUNG))
        return table_fail_whole(bodies, message,
                                "gives young, which the scene gives as contact.young too; keep one of them");
    if (contact->stiffness == 0.0 && contact->young == 0.0 && !table_has(bodies, BODY_YOUNG))
        return table_fail_whole(bodies, message,
                                "no columns young and poisson; contact needs them, or contact.stiffness, or "
                                "contact.young and contact.poisson");
    return 0;
}

/* ---- what it does ------------------------------------------------------------------------------------------------ */

static vti_effect draft(const void *settings, const struct table *table)
{
    static const double any = 1.0;
    static const vti_contacts none = {.diameter = {&any, 0, 0}};
    (void)settings, (void)table;
    return vti_contacts_effect(&none);
}

/** K of two bodies of the smallest size, and of the softest material. */
static double least_stiffness(const struct contact_self *self, int64_t bodies)
{
    static const int64_t pair[2] = {0, 1};
    double least = INFINITY;
    for (int64_t i = 0; i < bodies; ++i)
        least = fmin(least, self->contacts.diameter.p[i * self->contacts.diameter.stride]);
    vti_contacts two = self->contacts;
    two.count = 1;
    two.pair = pair;
    two.diameter = vti_scalars_one(&least);
    double softest = INFINITY;
    for (int64_t i = 0; two.modulus.p != NULL && i < bodies; ++i)
        softest = fmin(softest, self->contacts.modulus.p[i * self->contacts.modulus.stride]);
    if (two.modulus.p != NULL)
        two.modulus = vti_scalars_one(&softest);
    return vti_contacts_stiffness(&two, 0);
}

static int make(struct effect *e, const struct model *model, const struct table *table, vti_effect *made,
                struct message *message)
{
    const struct contact_settings *contact = e->settings;
    struct contact_self *self = effect_memory(e, sizeof *self, message);
    const int64_t held = contact->bonded ? 0 : shape_lines(model), spheres = model_spheres(model)->count;
    int64_t *pair = calloc(held > 0 ? (size_t)(2 * held) : 1, sizeof *pair);
    (void)table;
    if (self == NULL || pair == NULL) {
        free(pair);
        return scene_no_memory(model->scene, message);
    }
    if (held > 0 && model_has_clumps(model) && !shape_lines_join_spheres(model)) {
        free(pair);
        return message_set(message,
                           "%s: contact.bonded: spheres of clumps touch, whether these are bonded or not; give yes",
                           model->scene->name);
    }
    for (int64_t k = 0; k < held; ++k)
        shape_ends(model, k, pair + 2 * k);
    self->contacts.diameter = model->diameter;
    self->contacts.stiffness = contact->stiffness;
    self->parts = !contact->bonded && shape_breaking(model) != NULL;
    self->modulus = hertz_modulus(contact->young, contact->poisson);
    if (contact->young > 0.0)
        self->contacts.modulus = vti_scalars_one(&self->modulus);
    else if (contact->stiffness == 0.0)
        self->contacts.modulus = model->modulus;
    self->stiffness = least_stiffness(self, spheres);
    made->self = &self->contacts;
    const int result = neighbours_create(&self->neighbours, spheres, &model->diameter, 0.0, held, pair, message);
    self->neighbours.owner = model->clumps.list.body;
    self->neighbours.number = model->number;
    free(pair);
    if (result != 0 || scene_first_with(model->scene, EFFECT_NEAR) == NULL)
        return result;
    /* No two come nearer by more in a step that resolves their contact: 0.02 of the mean diameter. Half the skin took 4
     * to 7 % more time (scenes heap, drum, column). The verdict says where two do (judgement.c). */
    self->neighbours.reach = 0.1 * self->neighbours.skin;
    if (!model_has_clumps(model) && chunks_create(&self->chunks, spheres) != 0)
        return scene_no_memory(model->scene, message);
    return 0;
}

static void destroy(struct effect *e)
{
    struct contact_self *self = e->self;
    neighbours_destroy(&self->neighbours);
    chunks_destroy(&self->chunks);
    partings_destroy(&self->partings);
    free(self->length);
}

static void surfaces(const struct effect *e, struct effect_surfaces *surfaces)
{
    const struct contact_self *self = e->self;
    surfaces->contacts = &self->contacts;
    surfaces->reach = self->neighbours.reach;
    surfaces->chunks = self->chunks.count > 1 ? &self->chunks : NULL;
}

/* ---- what it tells ----------------------------------------------------------------------------------------------- */

/** How deep the pair is, as a share of the distance at which it begins to touch. */
static double share_of(const vti_contacts *contacts, const vti_view *x, int64_t k)
{
    const int64_t i = contacts->pair[2 * k], j = contacts->pair[2 * k + 1];
    return 1.0 - partings_distance(x, i, j) / contact_length(contacts, k);
}

/** Two that begin deep in each other: more than contacts are made for, and mostly a mistake in a table. Else
 *  what the scene asks for and cannot have. */
static void note(const struct effect *e, const struct model *model, char *text, size_t size_of_text)
{
    const struct contact_self *self = e->self;
    const vti_contacts *contacts = &self->contacts;
    const vti_view *x = &model_spheres(model)->x;
    const double most = 0.1;
    double deepest = most;
    int64_t at = -1, body[2];
    for (int64_t k = 0; k < contacts->count; ++k) {
        const double share = share_of(contacts, x, k);
        at = share > deepest ? k : at;
        deepest = fmax(deepest, share);
    }
    text[0] = '\0';
    if (((const struct contact_settings *)e->settings)->bonded && !model_has_clumps(model) &&
        scene_first_with(model->scene, EFFECT_BONDS) == NULL)
        snprintf(text, size_of_text, "contact.bonded: yes: nothing bonds bodies in this scene; leave it out");
    if (at < 0)
        return;
    contact_name_pair(&self->neighbours, at, body);
    snprintf(
        text, size_of_text,
        "bodies %lld and %lld overlap by %.3g of the length of their contact at t = 0, and no others by more; move "
        "them apart if that is not meant",
        (long long)body[0], (long long)body[1], deepest);
}

static void limit(const struct effect *e, const vti_deformation *at, const vti_stable *stable, char *text, size_t size)
{
    (void)e;
    if (at != NULL && at->meet)
        snprintf(text, size, "future contacts of body %lld", (long long)stable->i);
    else if (stable->j < 0) /* of clumps */
        snprintf(text, size, "pull of contacts on body %lld", (long long)stable->i);
    else
        snprintf(text, size, "contact of bodies %lld and %lld", (long long)stable->i, (long long)stable->j);
}

static void deform(const struct effect *e, const vti_bodies *bodies, double energy, vti_deformation *at)
{
    (void)bodies;
    hertz_deform(((const struct contact_self *)e->self)->stiffness, energy, at);
    at->meet = 1;
}

static double held(const struct effect *e, const vti_bodies *bodies)
{
    const vti_contacts *contacts = &((const struct contact_self *)e->self)->contacts;
    double most = 0.0;
    for (int64_t k = 0; k < contacts->count; ++k)
        most = fmax(most, hertz_held(vti_contacts_stiffness(contacts, k), share_of(contacts, &bodies->x, k)));
    return most;
}

static double deepest(const struct effect *e, const vti_bodies *spheres)
{
    const vti_contacts *contacts = &((const struct contact_self *)e->self)->contacts;
    double most = 0.0;
    for (int64_t k = 0; k < contacts->count; ++k)
        most = fmax(most, share_of(contacts, &spheres->x, k));
    return most;
}

static int touching(const struct effect *e)
{
    return ((const struct contact_settings *)e->settings)->bonded ? EFFECT_TOUCH_ALL : EFFECT_TOUCH_APART;
}

static int by_material(const struct effect *e)
{
    const struct contact_settings *contact = e->settings;
    return contact->stiffness == 0.0 && contact->young == 0.0;
}

static const struct effect_term terms[] = {{"contact", "$U^{\\mathrm{pp}}$", "particle-particle", "#332288"}};

const struct effect_kind effect_contact = {.number = EFFECT_contact,
                                           .key = "contact",
                                           EFFECT_FIELDS(fields),
                                           .settings = sizeof(struct contact_settings),
                                           .check = check,
                                           .draft = draft,
                                           .check_tables = check_tables,
                                           .spheres = 1,
                                           .make = make,
                                           .destroy = destroy,
                                           .find_pairs = contact_find_pairs,
                                           .release = contact_release,
                                           .take_part = contact_take_part,
                                           EFFECT_TERMS(terms),
                                           .note = note,
                                           .limit = limit,
                                           .deform = deform,
                                           .held = held,
                                           .deepest = deepest,
                                           .missed = contact_missed,
                                           .surfaces = surfaces,
                                           .by_material = by_material,
                                           .touching = touching,
                                           .memory = &contact_memory};
