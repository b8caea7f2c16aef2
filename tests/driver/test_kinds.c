/* SPDX-License-Identifier: BSD-3-Clause
 * What an effect of scenes must not forget: each of a kind's parts in turn is taken from a copy, and the line names the
 * file. */
#include "support.h"

#include "kind.h"
#include "message.h"

static struct effect_kind kind;
static struct scene_field fields[16];
static struct effect_term terms[2];

/** A copy of the wall's, with rows of its own. */
static void copy(void)
{
    kind = effect_wall;
    memcpy(fields, effect_wall.fields, sizeof *fields * (size_t)effect_wall.fields_count);
    memcpy(terms, effect_wall.terms, sizeof terms);
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
    static const struct effect_lines lines = {"line", NULL, EFFECT_QUANTITIES + 1, NULL, NULL, NULL, NULL};
    static const struct effect_lines one = {"line", NULL, 1, NULL, NULL, NULL, NULL};
    (void)state;
    copy();
    assert_int_equal(kinds_check_kind(EFFECT_wall, &kind, &message), 0);
    kind.number = EFFECT_contact;
    refused("effect wall: number: is not that of the list in kinds.h");
    kind.key = NULL;
    refused("effect wall: has no key, or no row for it");
    kind.fields = NULL;
    refused("effect wall: has no key, or no row for it");
    kind.settings = 0;
    refused("effect wall: wall.stiffness: goes behind the end of the settings");
    kind.draft = NULL;
    refused("effect wall: has no draft");
    kind.table = effect_binder.table;
    refused("effect wall: table: goes with one key of a path, and a path with a table");
    kind.lines = &lines;
    refused("effect wall: lines: has more quantities than EFFECT_QUANTITIES");
    kind.lines = &one;
    refused("effect wall: lines: it must stand before those that search for pairs in kinds.h");
}

static void rows(void **state)
{
    (void)state;
    copy();
    fields[0].path = "wall.stiffness";
    refused("effect wall: wall.stiffness: is not the effect's key, whose row comes first");
    fields[1].path = NULL;
    refused("effect wall: fields: a row without a path; fields_count is more than there are");
    fields[1].path = "walls.stiffness";
    refused("effect wall: walls.stiffness: does not begin with the effect's key");
    fields[1].about = "";
    refused("effect wall: wall.stiffness: does not say what it is (about)");
    fields[2].says = NULL;
    refused("effect wall: wall.young: has no sentence that documents it (says)");
    fields[2].says = "no full stop";
    refused("effect wall: wall.young: has no sentence that documents it (says)");
    fields[1].kind = SCENE_WORD;
    refused("effect wall: wall.stiffness: has no words");
    fields[1].offset = SCENE_NOWHERE;
    refused("effect wall: wall.stiffness: sections go nowhere, and all else to a member of the settings (offset)");
    terms[0].colour = NULL;
    refused("effect wall: terms: one of them lacks its name, symbol, meaning or colour");
    terms[1].colour = terms[0].colour;
    refused("effect wall: terms: work_wall has the colour #009E73, which is that of wall; take another one");
    terms[0].colour = effect_contact.terms[0].colour;
    refused("effect wall: terms: wall has the colour #332288, which is that of contact; take another one");
}

/** What make hands over: all that is called, and terms that pictures know. */
static void effects(void **state)
{
    static const char *const term[] = {"wall", "friction"};
    const vti_walls walls = {0};
    const vti_effect draft = vti_walls_effect(&walls);
    vti_effect made = draft;
    struct message message = {""};
    (void)state;
    assert_int_equal(kinds_check_made(&effect_wall, &draft, &made, &message), 0);
    made.term = term;
    made.terms = 2;
    assert_int_equal(kinds_check_made(&effect_wall, &draft, &made, &message), -1);
    assert_string_equal(message.text, "effect wall: friction: the term has no row in terms");
    made.terms = 0;
    assert_int_equal(kinds_check_made(&effect_wall, &draft, &made, &message), -1);
    assert_string_equal(message.text,
                        "effect wall: terms: the effect has some and there are no rows for them, or the reverse");
    for (int k = 0; k < 3; ++k) {
        int64_t *const says[] = {&made.gives, &made.needs, &made.smooth};
        *says[k] ^= 1;
        assert_int_equal(kinds_check_made(&effect_wall, &draft, &made, &message), -1);
        assert_string_equal(message.text, "effect wall: draft: needs or gives something else than the effect, or is "
                                          "smooth where it is not");
        *says[k] ^= 1;
    }
    made.energy = NULL;
    assert_int_equal(kinds_check_made(&effect_wall, &draft, &made, &message), -1);
    assert_string_equal(message.text, "effect wall: make: its effect lacks name, apply, energy or self");
}

/** What of a scene decides whether its effects act on positions. */
static void drafts(void **state)
{
    static union effect_settings settings;
    (void)state;
    kinds_defaults(&settings);
    for (int k = 0; kinds_at(k) != NULL; ++k) /* without any stiffness too: bonds hold bodies somewhere */
        assert_int_equal(kinds_has(kinds_at(k), &settings, EFFECT_TRANSLATING),
                         k != EFFECT_pendulum && k != EFFECT_drag);
    static const struct {
        enum effect_number number;
        int spheres, kinked, stiff;
    } want[] = {{EFFECT_binder, 0, 0, 1}, {EFFECT_contact, 1, 1, 1}, {EFFECT_wall, 1, 1, 1}, {EFFECT_gravity, 0, 0, 0}};
    for (size_t k = 0; k < sizeof want / sizeof want[0]; ++k) {
        const struct effect_kind *of = kinds_at((int)want[k].number);
        assert_int_equal(kinds_has(of, &settings, EFFECT_SPHERES), want[k].spheres);
        assert_int_equal(kinds_has(of, &settings, EFFECT_KINKED), want[k].kinked);
        assert_int_equal(kinds_has(of, &settings, EFFECT_STIFF), want[k].stiff);
    }
    assert_int_equal(kinds_draft(&effect_binder, &settings, NULL).gives, 0);
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
                                       cmocka_unit_test(drafts), cmocka_unit_test(all)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
