/* SPDX-License-Identifier: BSD-3-Clause
 * Contact: Hertzian, between spheres that overlap (EQUATIONS 3). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "chunks.h"
#include "hertz.h"
#include "kind.h"
#include "model.h"
#include "neighbours.h"
#include "partings.h"
#include "scene_reader.h"
#include "shape.h"
#include "table.h"

struct contact_settings {
    double stiffness;      /* 0: that of a material */
    double young, poisson; /* of the material, if there is one */
    int64_t bonded;        /* 1: also between bodies that are held together */
};

struct contact_self {
    vti_contacts contacts; /* its list is that of neighbours, as of the last find_pairs */
    struct neighbours neighbours;
    int parts;                /* 1 if bonds, whose bodies do not touch, may break */
    struct partings partings; /* of those that have */
    double *length;           /* of the list, of room for so many; while some pair has one of its own */
    int64_t room;
    int64_t age;          /* how often pairs or lengths have changed */
    int begun;            /* pairs have been found before */
    struct chunks chunks; /* of the list; all zeros where nobody asks for them */
    double modulus;       /* of the material */
    double stiffness;     /* K of the softest pair that there may be */
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
    {"contact.poisson", SCENE_NUMBER, SCENE_MAY, SCENE_NOT_NEGATIVE, offsetof(struct contact_settings, poisson),
     "Poisson's ratio nu", "Of the same material, at most 0.5.", NULL},
    {"contact.bonded", SCENE_YES_NO, SCENE_MAY, SCENE_ANY, offsetof(struct contact_settings, bonded),
     "contact inside bonds", "yes: bodies of a common bond touch too; no (default): they do not.", NULL},
};

static int check(const struct scene_reader *reader, const struct scene *scene, const void *settings)
{
    const int young = scene_reader_has(reader, "contact.young"), poisson = scene_reader_has(reader, "contact.poisson");
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
    if (((const struct contact_settings *)settings)->poisson > 0.5)
        return scene_reader_fail(reader, "contact.poisson", "'%s' is above 0.5; no material has that",
                                 scene_reader_value(reader, "contact.poisson"));
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
        return message_set(message, "%s: out of memory; use fewer bodies", model->scene->name);
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
    /* No two come nearer by more in a step that resolves their contact: 0.02 of the mean diameter. Half the skin took 4 to 7 %
     * more time (scenes heap, drum, column). The verdict says where two do (judgement.c). */
    self->neighbours.reach = 0.1 * self->neighbours.skin;
    if (!model_has_clumps(model) && chunks_create(&self->chunks, spheres) != 0)
        return message_set(message, "%s: out of memory; use fewer bodies", model->scene->name);
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

/** Distances at which the pairs of the list begin to touch, where some of them have one of their own. Returns 0, or -1
 *  with one line in *message. */
static int find_lengths(struct contact_self *self, struct message *message)
{
    const vti_scalars none = {NULL, 0, 0};
    const int64_t count = self->contacts.count;
    self->contacts.length = none;
    ++self->age;
    if (self->partings.own == 0)
        return 0;
    if (count > self->room) {
        free(self->length);
        self->length = malloc((size_t)count * sizeof *self->length);
        self->room = self->length != NULL ? count : 0;
    }
    if (count > self->room)
        return message_set(message, "contacts: out of memory for %lld pairs; use fewer bodies", (long long)count);
    partings_lengths(&self->partings, &self->contacts.diameter, count, self->contacts.pair, self->length);
    if (count > 0)
        self->contacts.length = vti_scalars_array(self->length);
    return 0;
}

/** The list is another one, or lengths are. */
static int take_list(struct contact_self *self, struct message *message)
{
    if (find_lengths(self, message) != 0)
        return -1;
    if (self->chunks.count > 1 && chunks_take(&self->chunks, &self->contacts) != 0)
        return message_set(message, "contacts: out of memory for %lld pairs; use fewer bodies",
                           (long long)self->contacts.count);
    return 0;
}

/** The bodies of pair k as people number them; of clumps those whose spheres they are. */
static void name_pair(const struct neighbours *list, int64_t k, int64_t body[2])
{
    for (int n = 0; n < 2; ++n) {
        const int64_t i = list->pair[2 * k + n], of = list->owner != NULL ? list->owner[i] : i;
        body[n] = list->number != NULL ? list->number[of] : of;
    }
}

/** How far the centres of a pair are apart. */
static double distance(const vti_view *x, const int64_t pair[2])
{
    double d[3];
    for (int c = 0; c < 3; ++c)
        d[c] = x->c[c][pair[0] * x->stride] - x->c[c][pair[1] * x->stride];
    return vti_norm(d);
}

/** At the start: of centres that are one there is no direction in which they could part. The core takes those for one
 *  that are nearer than 3.1e-151. */
static int check_directions(const struct contact_self *self, const vti_view *x, struct message *message)
{
    static const double one = 3.2e-151; /* that, rounded up */
    const struct neighbours *list = &self->neighbours;
    for (int64_t k = 0; k < list->count; ++k) {
        if (distance(x, list->pair + 2 * k) > one)
            continue;
        int64_t body[2];
        name_pair(list, k, body);
        return message_set(
            message, "the centres of %s %lld and %lld give no direction to their contact; move one of them",
            list->owner != NULL ? "spheres of bodies" : "bodies", (long long)body[0], (long long)body[1]);
    }
    return 0;
}

static int find_pairs(struct effect *e, const vti_bodies *bodies, struct message *message)
{
    struct contact_self *self = e->self;
    const int result = neighbours_update(&self->neighbours, &bodies->x, message);
    self->contacts.count = self->neighbours.count;
    self->contacts.pair = self->neighbours.pair;
    if (result == 1 && !self->begun && check_directions(self, &bodies->x, message) != 0)
        return -1;
    self->begun = 1;
    return result == 1 ? take_list(self, message) : result;
}

static int release(struct effect *e, const vti_bodies *bodies, int64_t count, const int64_t *pair,
                   struct message *message)
{
    struct contact_self *self = e->self;
    const vti_scalars *diameter = &self->contacts.diameter;
    if (!self->parts)
        return 0;
    const int64_t ended = partings_end(&self->partings, &bodies->x, diameter);
    for (int64_t k = 0; k < count; ++k) {
        const int64_t i = pair[2 * k], j = pair[2 * k + 1];
        if (partings_add(&self->partings, i, j, partings_distance(&bodies->x, i, j), diameter) != 0)
            return message_set(message, "contacts: out of memory for bonds that have broken; use fewer bodies");
        neighbours_release(&self->neighbours, i, j);
    }
    return ended > 0 ? take_list(self, message) : 0;
}

static int64_t size(const struct effect *e)
{
    const struct contact_self *self = e->self;
    return self->parts ? partings_size(&self->partings) : 0;
}

static void get(const struct effect *e, double *memory)
{
    const struct contact_self *self = e->self;
    if (self->parts)
        partings_get(&self->partings, memory);
}

static int64_t put(struct effect *e, const double *memory, int64_t left)
{
    struct contact_self *self = e->self;
    const int64_t taken = self->parts ? partings_put(&self->partings, memory, left) : 0;
    for (int64_t k = 0; taken > 0 && k < self->partings.count; ++k)
        neighbours_release(&self->neighbours, self->partings.list[k].i, self->partings.list[k].j);
    return taken;
}

static const struct effect_memory_of remembered = {size, get, put};

static int take_part(const struct effect *e, const vti_bodies *slice, struct effect_part *part)
{
    const struct contact_self *self = e->self;
    const vti_contacts *all = &self->contacts;
    if (part->age == self->age)
        return 0;
    const int64_t n = vti_pairs_of_slice(all->count, all->pair, all->base, slice->first, slice->count, NULL);
    int64_t *pair = effect_part_room(part, 3 * n);
    if (pair == NULL)
        return -1;
    double *length = (double *)(void *)(pair + 2 * n);
    part->age = self->age;
    part->contacts = *all;
    part->contacts.count = 0;
    part->contacts.pair = pair;
    for (int64_t k = 0; k < all->count; ++k)
        if (vti_pairs_of_slice(1, all->pair + 2 * k, all->base, slice->first, slice->count, NULL) > 0) {
            int64_t *to = pair + 2 * part->contacts.count;
            to[0] = all->pair[2 * k];
            to[1] = all->pair[2 * k + 1];
            length[part->contacts.count++] = all->length.p != NULL ? all->length.p[k] : 0.0;
        }
    if (all->length.p != NULL)
        part->contacts.length = vti_scalars_array(length);
    part->made = vti_contacts_effect(&part->contacts);
    return 0;
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
    const vti_scalars *D = &contacts->diameter;
    const double length =
        contacts->length.p != NULL ? contacts->length.p[k] : 0.5 * (D->p[i * D->stride] + D->p[j * D->stride]);
    return 1.0 - distance(x, contacts->pair + 2 * k) / length;
}

/** Two that begin deep in each other: more than contacts are made for, and mostly a mistake in a table. */
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
    if (at < 0)
        return;
    name_pair(&self->neighbours, at, body);
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
        snprintf(text, size, "contacts that may come to body %lld", (long long)stable->i);
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
                                           .find_pairs = find_pairs,
                                           .release = release,
                                           .take_part = take_part,
                                           EFFECT_TERMS(terms),
                                           .note = note,
                                           .limit = limit,
                                           .deform = deform,
                                           .held = held,
                                           .deepest = deepest,
                                           .surfaces = surfaces,
                                           .touching = touching,
                                           .memory = &remembered};
