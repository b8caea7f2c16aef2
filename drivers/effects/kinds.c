/* SPDX-License-Identifier: BSD-3-Clause */
#include "kinds.h"

#include <string.h>

#include "kind.h"
#include "model.h"
#include "table.h"

#define POINTER(NAME) &effect_##NAME,
static const struct effect_kind *const kinds[] = {EFFECT_KINDS(POINTER)};
#define TEXT(NAME) #NAME,
static const char *const names[] = {EFFECT_KINDS(TEXT)};

const struct effect_kind *kinds_at(int k)
{
    return k >= 0 && k < EFFECT_COUNT ? kinds[k] : NULL;
}

const struct effect_kind *kinds_find(const char *path)
{
    const size_t n = strcspn(path, ".");
    for (int k = 0; k < EFFECT_COUNT; ++k)
        if (kinds[k]->key != NULL && strncmp(kinds[k]->key, path, n) == 0 && kinds[k]->key[n] == '\0')
            return kinds[k];
    return NULL;
}

/* ---- settings ---------------------------------------------------------------------------------------------------- */

/** Bytes of the settings before those of kind k, each rounded up to what any of them may start at. */
static size_t settings_before(int k)
{
    const size_t unit = 16;
    size_t bytes = 0;
    for (int before = 0; before < k; ++before)
        bytes += (kinds[before]->settings + unit - 1) / unit * unit;
    return bytes;
}

void *kinds_settings(const struct effect_kind *kind, union effect_settings *all)
{
    return all->bytes + settings_before((int)kind->number);
}

const void *kinds_settings_of(const struct effect_kind *kind, const union effect_settings *all)
{
    return all->bytes + settings_before((int)kind->number);
}

void kinds_defaults(union effect_settings *all)
{
    memset(all, 0, sizeof *all);
    for (int k = 0; k < EFFECT_COUNT; ++k)
        if (kinds[k]->defaults != NULL)
            kinds[k]->defaults(kinds_settings(kinds[k], all));
}

vti_effect kinds_draft(const struct effect_kind *kind, const union effect_settings *all, const struct table *table)
{
    return kind->draft(kinds_settings_of(kind, all), table);
}

int kinds_has(const struct effect_kind *kind, const union effect_settings *all, enum effect_trait trait)
{
    const vti_effect draft = kinds_draft(kind, all, NULL);
    const int translates =
        (draft.gives & EFFECT_FORCE) != 0 || (draft.needs & 1 << VTI_QUANTITY_X) != 0 || kind->lines != NULL;
    return trait == EFFECT_TRANSLATING  ? translates
           : trait == EFFECT_STIFF      ? translates && kind->field == NULL
           : trait == EFFECT_SPHERES    ? kind->spheres
           : trait == EFFECT_SURFACES   ? kind->surfaces != NULL
           : trait == EFFECT_BONDS      ? kind->bonds != NULL
           : trait == EFFECT_NEAR       ? kind->near
           : trait == EFFECT_ON_SPHERES ? kind->spheres || (kind->on_spheres != NULL && kind->on_spheres(all))
                                        : !draft.smooth;
}

/* ---- what must not be forgotten ---------------------------------------------------------------------------------- */

static int fail(int k, const char *about, const char *what, struct message *message)
{
    return message_set(message, "effect %s: %s%s%s", names[k], about, about[0] != '\0' ? ": " : "", what);
}

static int is_sentence(const char *text)
{
    return text != NULL && text[0] != '\0' && text[strlen(text) - 1] == '.';
}

static int check_field(int k, const struct effect_kind *kind, const struct scene_field *field, struct message *message)
{
    if (field->path == NULL)
        return fail(k, "fields", "a row without a path; fields_count is more than there are", message);
    if (kinds_find(field->path) != kinds[k])
        return fail(k, field->path, "does not begin with the effect's key", message);
    if (field->about == NULL || field->about[0] == '\0')
        return fail(k, field->path, "does not say what it is (about)", message);
    if (!is_sentence(field->says))
        return fail(k, field->path, "has no sentence that documents it (says)", message);
    if (field->kind == SCENE_WORD && field->words == NULL)
        return fail(k, field->path, "has no words", message);
    if ((field->kind == SCENE_SECTION) != (field->offset == SCENE_NOWHERE))
        return fail(k, field->path, "sections go nowhere, and all else to a member of the settings (offset)", message);
    if (field->kind != SCENE_SECTION && field->offset >= kind->settings)
        return fail(k, field->path, "goes behind the end of the settings", message);
    return 0;
}

static int check_fields(int k, const struct effect_kind *kind, struct message *message)
{
    int paths = 0;
    for (int f = 0; f < kind->fields_count; ++f) {
        if (check_field(k, kind, &kind->fields[f], message) != 0)
            return -1;
        paths += kind->fields[f].kind == SCENE_PATH;
    }
    if (strcmp(kind->fields[0].path, kind->key) != 0)
        return fail(k, kind->fields[0].path, "is not the effect's key, whose row comes first", message);
    if (paths != (kind->table != NULL))
        return fail(k, "table", "goes with one key of a path, and a path with a table", message);
    if (kind->table != NULL && kind->table->columns > TABLE_COLUMNS)
        return fail(k, "table", "has more columns than TABLE_COLUMNS (table.h)", message);
    return 0;
}

/** The one of the first count terms that has that colour; NULL if none has. */
static const struct effect_term *drawn_by(const struct effect_term *terms, int count, const char *colour)
{
    for (int t = 0; t < count; ++t)
        if (strcmp(terms[t].colour, colour) == 0)
            return &terms[t];
    return NULL;
}

static int check_terms(int k, const struct effect_kind *kind, struct message *message)
{
    for (int t = 0; t < kind->terms_count; ++t) {
        const struct effect_term *term = &kind->terms[t];
        if (term->name == NULL || term->symbol == NULL || term->meaning == NULL || term->colour == NULL)
            return fail(k, "terms", "one of them lacks its name, symbol, meaning or colour", message);
        const struct effect_term *other = drawn_by(kind->terms, t, term->colour);
        for (int before = 0; before < k && other == NULL; ++before)
            other = drawn_by(kinds[before]->terms, kinds[before]->terms_count, term->colour);
        if (other != NULL)
            return message_set(message, "effect %s: terms: %s has the colour %s, which is that of %s; take another one",
                               names[k], term->name, term->colour, other->name);
    }
    return 0;
}

/** What is taken of many states at once is all that it keeps, or has. */
static int check_states(int k, const struct effect_kind *kind, struct message *message)
{
    const struct effect_invariants *own = kind->invariants;
    if (kind->each != NULL && kind->terms_count != 1)
        return fail(k, "each", "its energy is not one term", message);
    if (own == NULL)
        return 0;
    for (int i = 0; i < own->count; ++i)
        if (own->list[i].is_momentum != (i < own->momenta))
            return fail(k, "invariants", "those that are momenta have to be counted, and to stand first", message);
    return own->values != NULL && own->of_states != NULL ? 0 : fail(k, "invariants", "has no values", message);
}

int kinds_check_kind(int k, const struct effect_kind *kind, struct message *message)
{
    if ((int)kind->number != k)
        return fail(k, "number", "is not that of the list in kinds.h", message);
    if (kind->key == NULL || kind->fields == NULL || kind->fields_count < 1)
        return fail(k, "", "has no key, or no row for it", message);
    if (kind->draft == NULL)
        return fail(k, "", "has no draft", message);
    if (kind->lines != NULL && kind->lines->quantities > EFFECT_QUANTITIES)
        return fail(k, "lines", "has more quantities than EFFECT_QUANTITIES", message);
    for (int before = 0; before < k && kind->lines != NULL; ++before)
        if (kinds[before]->find_pairs != NULL)
            return fail(k, "lines", "it must stand before those that search for pairs in kinds.h", message);
    if (check_states(k, kind, message) != 0)
        return -1;
    return check_fields(k, kind, message) != 0 || check_terms(k, kind, message) != 0 ? -1 : 0;
}

int kinds_check(struct message *message)
{
    int terms = 0;
    for (int k = 0; k < EFFECT_COUNT; ++k) {
        if (kinds_check_kind(k, kinds[k], message) != 0)
            return -1;
        terms += kinds[k]->terms_count;
    }
    if (terms > EFFECT_TERMS_OF_ALL)
        return fail(EFFECT_COUNT - 1, "terms",
                    "more of all effects than there are columns for; enlarge EFFECT_TERMS_OF_ALL in kinds.h", message);
    if (settings_before(EFFECT_COUNT) > sizeof(union effect_settings))
        return fail(EFFECT_COUNT - 1, "settings", "more than there is room for; enlarge effect_settings in kinds.h",
                    message);
    return 0;
}

/** Each has a row in terms. */
static int check_names(const struct effect_kind *kind, const char *const *name, int64_t count, struct message *message)
{
    for (int64_t j = 0; j < count; ++j) {
        int found = 0;
        for (int t = 0; t < kind->terms_count; ++t)
            found |= strcmp(kind->terms[t].name, name[j]) == 0;
        if (!found)
            return fail((int)kind->number, name[j], "the term has no row in terms", message);
    }
    return 0;
}

int kinds_check_made(const struct effect_kind *kind, const vti_effect *draft, const vti_effect *made,
                     struct message *message)
{
    const int acts = made->apply != NULL ? made->energy != NULL : made->flow != NULL;
    if (made->name == NULL || made->self == NULL || !acts)
        return fail((int)kind->number, "make", "its effect lacks name, apply, energy or self", message);
    if ((made->apply != NULL && draft->gives != made->gives) || draft->needs != made->needs ||
        draft->smooth != made->smooth)
        return fail((int)kind->number, "draft",
                    "needs or gives something else than the effect, or is smooth where it is not", message);
    if (made->apply != NULL && (made->terms > 0) != (kind->terms_count > 0))
        return fail((int)kind->number, "terms", "the effect has some and there are no rows for them, or the reverse",
                    message);
    return check_names(kind, made->term, made->terms, message) != 0
               ? -1
               : check_names(kind, made->book, made->books, message);
}
