/* SPDX-License-Identifier: BSD-3-Clause
 * What an effect of scenes must not forget: each of a kind's parts in turn is taken from a copy, and the line names the
 * file. */
#include "support.h"

#include "kind.h"
#include "message.h"

static struct effect_kind kind;
static struct scene_field fields[8];
static struct effect_term terms[1];

/** A copy of the wall's, with rows of its own. */
static void copy(void)
{
    kind = effect_wall;
    memcpy(fields, effect_wall.fields, sizeof *fields * (size_t)effect_wall.fields_count);
    terms[0] = effect_wall.terms[0];
    kind.fields = fields;
    kind.terms = terms;
}

static void refused(const char *line)
{
    struct message message = {""};
    if (kinds_check_kind(EFFECT_wall, &kind, &message) == 0)
        fail_msg("accepted, and not '%s'", line);
    assert_string_equal(message.text, line);
    copy();
}

static void parts(void **state)
{
    struct message message;
    static const struct effect_lines lines = {"line", NULL, EFFECT_QUANTITIES + 1, NULL, NULL, NULL};
    static const struct effect_lines one = {"line", NULL, 1, NULL, NULL, NULL};
    (void)state;
    copy();
    assert_int_equal(kinds_check_kind(EFFECT_wall, &kind, &message), 0);
    kind.number = EFFECT_contact;
    refused("effects/wall.c: number: is not that of the list in kinds.h");
    kind.key = NULL;
    refused("effects/wall.c: has no key, or no row for it");
    kind.fields = NULL;
    refused("effects/wall.c: has no key, or no row for it");
    kind.settings = 0;
    refused("effects/wall.c: wall.stiffness: goes behind the end of the settings");
    kind.traits &= ~EFFECT_TRANSLATING;
    refused("effects/wall.c: traits: a force acts on bodies that translate: EFFECT_TRANSLATING");
    kind.kink = NULL;
    refused("effects/wall.c: kink: where surfaces meet (EFFECT_SPHERES) forces set in with a kink, and only there");
    kind.gives = 0;
    refused("effects/wall.c: gives neither force nor moment: one of gives, gives_by and EFFECT_FLOWS");
    kind.make = NULL;
    refused("effects/wall.c: has no make");
    kind.table = effect_binder.table;
    refused("effects/wall.c: table: goes with one key of a path, and a path with a table");
    kind.lines = &lines;
    refused("effects/wall.c: lines: has more quantities than EFFECT_QUANTITIES");
    kind.lines = &one;
    refused("effects/wall.c: lines: it must stand before those that search for pairs in kinds.h");
}

static void rows(void **state)
{
    (void)state;
    copy();
    fields[0].path = "wall.stiffness";
    refused("effects/wall.c: wall.stiffness: is not the effect's key, whose row comes first");
    fields[1].path = NULL;
    refused("effects/wall.c: fields: a row without a path; fields_count is more than there are");
    fields[1].path = "walls.stiffness";
    refused("effects/wall.c: walls.stiffness: does not begin with the effect's key");
    fields[1].about = "";
    refused("effects/wall.c: wall.stiffness: does not say what it is (about)");
    fields[2].says = NULL;
    refused("effects/wall.c: wall.planes: has no sentence that documents it (says)");
    fields[2].says = "no full stop";
    refused("effects/wall.c: wall.planes: has no sentence that documents it (says)");
    fields[1].kind = SCENE_WORD;
    refused("effects/wall.c: wall.stiffness: has no words");
    fields[1].offset = SCENE_NOWHERE;
    refused("effects/wall.c: wall.stiffness: sections go nowhere, and all else to a member of the settings (offset)");
    terms[0].colour = NULL;
    refused("effects/wall.c: terms: one of them lacks its name, symbol, meaning or colour");
}

/** What make hands over: all that is called, and terms that pictures know. */
static void effects(void **state)
{
    static const char *const term[] = {"wall", "friction"};
    const vti_walls walls = {0};
    vti_effect made = vti_walls_effect(&walls);
    struct message message = {""};
    (void)state;
    assert_int_equal(kinds_check_made(&effect_wall, &made, &message), 0);
    made.term = term;
    made.terms = 2;
    assert_int_equal(kinds_check_made(&effect_wall, &made, &message), -1);
    assert_string_equal(message.text, "effects/wall.c: friction: the term has no row in terms");
    made.terms = 0;
    assert_int_equal(kinds_check_made(&effect_wall, &made, &message), -1);
    assert_string_equal(message.text,
                        "effects/wall.c: terms: the effect has some and there are no rows for them, or the reverse");
    made.gives = 1 << VTI_QUANTITY_MOMENT;
    assert_int_equal(kinds_check_made(&effect_wall, &made, &message), -1);
    assert_string_equal(message.text, "effects/wall.c: gives: is not what its effect gives");
    made.gives = 1 << VTI_QUANTITY_FORCE;
    made.smooth = 1;
    assert_int_equal(kinds_check_made(&effect_wall, &made, &message), -1);
    assert_string_equal(message.text, "effects/wall.c: kink: its effect is smooth and it is not, or the reverse");
    made.energy = NULL;
    assert_int_equal(kinds_check_made(&effect_wall, &made, &message), -1);
    assert_string_equal(message.text, "effects/wall.c: make: its effect lacks name, apply, energy or self");
}

/** All kinds there are say all that they must, and find their own settings. */
static void all(void **state)
{
    static union effect_settings settings;
    struct message message = {""};
    (void)state;
    if (kinds_check(&message) != 0)
        fail_msg("%s", message.text);
    unsigned char *end = settings.bytes;
    for (int k = 0; kinds_at(k) != NULL; ++k) {
        unsigned char *place = kinds_settings(kinds_at(k), &settings);
        assert_true(place >= end && kinds_settings_of(kinds_at(k), &settings) == place);
        assert_ptr_equal(kinds_find(kinds_at(k)->fields[kinds_at(k)->fields_count - 1].path), kinds_at(k));
        end = place + kinds_at(k)->settings;
    }
    assert_true(end <= settings.bytes + sizeof settings);
    assert_null(kinds_find("bodies.mass"));
    assert_null(kinds_find("wal"));
    assert_null(kinds_find("walls.stiffness"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(parts), cmocka_unit_test(rows), cmocka_unit_test(effects),
                                       cmocka_unit_test(all)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
