/* SPDX-License-Identifier: BSD-3-Clause
 * Damaged scene files: every truncation of the shipped scenes that are the arguments, and seeded changes of bytes and of
 * pieces of YAML. Each gives a scene whose numbers make sense or one whole line; sanitizers watch the memory. */
#define _POSIX_C_SOURCE 200809L
#include "scene_support.h"

enum { MUTATIONS = 20000 };

/** The scenes to be damaged; overrides are damaged on top of the first. */
enum { ORIGINALS = 2 };
static char original[ORIGINALS][TEXT_SIZE];
static size_t original_size[ORIGINALS];
static int originals;

static int positive(double x)
{
    return isfinite(x) && x > 0.0;
}

static int is_unit(const double *n)
{
    return fabs(vti_norm(n) - 1.0) <= 4 * EPS;
}

static void check_effects(const struct scene *s)
{
    const int64_t bodies = scene_bodies(s);
    const int known = s->arrangement != SCENE_IN_TABLE;
    if (calls_for(s, "binder")) {
        assert_true(!known || bodies > 1);
        assert_true(*(char *)setting(s, "binder.table") != '\0' || *number_setting(s, "binder.moment") > 0.0 ||
                    *number_setting(s, "binder.axial") > 0.0 || *number_setting(s, "binder.shear.stiffness") > 0.0);
        assert_in_range(*(int64_t *)setting(s, "binder.shear.form"), VTI_SHEAR_OBJECTIVE, VTI_SHEAR_PRINTED);
    }
    assert_true(!known || s->translates || !scene_has_trait(s, EFFECT_TRANSLATING));
    assert_true(!calls_for(s, "contact") || (positive(*number_setting(s, "contact.stiffness")) &&
                                             *(int64_t *)setting(s, "contact.bonded") >> 1 == 0));
    if (calls_for(s, "wall")) {
        const struct scene_planes *planes = setting(s, "wall.planes");
        assert_true(positive(*number_setting(s, "wall.stiffness")));
        assert_in_range(planes->count, 1, SCENE_PLANES_MAX);
        for (int64_t k = 0; k < planes->count; ++k)
            assert_true(is_unit(planes->plane[k]) && isfinite(planes->plane[k][3]));
    }
    assert_true(!calls_for(s, "pendulum") ||
                (s->turns && !s->translates && *number_setting(s, "pendulum.weight") >= 0.0));
    assert_true(all_finite(number_setting(s, "pendulum.rho0"), 3) && all_finite(number_setting(s, "gravity"), 3));
}

static void check_scene(const struct scene *s)
{
    const int known = s->arrangement != SCENE_IN_TABLE, formula = known && s->arrangement != SCENE_SINGLE;
    const int sphere = positive(s->mass) && (positive(s->diameter) || formula);
    assert_true(!known || s->translates || s->turns);
    assert_true(!known || !s->translates || positive(s->mass));
    assert_true(!known || !s->turns || positive(s->inertia) || sphere);
    assert_true(all_finite(s->x, 3) && all_finite(s->v, 3) && all_finite(s->alpha, 3) && all_finite(s->omega, 3));
    assert_true(known ? scene_bodies(s) >= 1 && scene_bodies(s) <= SCENE_BODIES_MAX : s->table[0] != '\0');
    assert_true(s->arrangement != SCENE_IN_RING || s->ring.count >= 3);
    check_effects(s);
    assert_true(positive(s->h) && positive(s->t_end) && s->t_end / s->h <= 0x1p53);
    assert_non_null(s->stepper);
    assert_in_range(strlen(s->name), 1, sizeof s->name - 1);
}

/** Returns 1 if the text is a scene. */
static int try_text(const char *text, size_t size, const char *const *sets, int n)
{
    struct scene scene;
    struct message message;
    write_bytes("t.yaml", text, size);
    const int result = scene_read("t.yaml", sets, n, &scene, &message);
    assert_true(result == 0 || result == -1);
    if (result == 0) {
        check_scene(&scene);
    } else {
        assert_one_line(&message);
        assert_memory_equal(message.text, n > 0 ? "" : "t.yaml:", n > 0 ? 0 : 7);
    }
    return result == 0;
}

static void every_truncation(void **state)
{
    (void)state;
    assert_int_equal(originals, ORIGINALS);
    for (int k = 0; k < originals; ++k)
        for (size_t size = 0; size <= original_size[k]; ++size)
            assert_true(try_text(original[k], size, NULL, 0) || size < original_size[k]);
}

/** Changes, removes or inserts a byte. */
static size_t mutate_byte(rng *g, char *text, size_t size)
{
    const size_t at = (size_t)rng_below(g, (int)size);
    switch (rng_below(g, 4)) {
    case 0:
        text[at] = (char)rng_below(g, 256);
        return size;
    case 1:
        text[at] = (char)(text[at] ^ (1 << rng_below(g, 8)));
        return size;
    case 2:
        memmove(text + at, text + at + 1, size - at - 1);
        return size - 1;
    default:
        memmove(text + at + 1, text + at, size - at);
        text[at] = (char)(0x20 + rng_below(g, 0x5f));
        return size + 1;
    }
}

static void put(char *to, const char *from, size_t n)
{
    for (size_t k = 0; k < n; ++k)
        to[k] = from[k];
}

/** Writes a piece of YAML over what stands there, or inserts it. */
static size_t mutate_piece(rng *g, char *text, size_t size)
{
    static const char *const pieces[] = {"[",
                                         "]",
                                         "{",
                                         "}",
                                         ": ",
                                         "- ",
                                         "? ",
                                         "\n",
                                         "\n  ",
                                         "&a ",
                                         "*a",
                                         "!!x ",
                                         "|\n",
                                         ">\n",
                                         "'",
                                         "\"",
                                         "\"\\0\"",
                                         "---\n",
                                         "...\n",
                                         "%YAML 1.1\n",
                                         "<<: ",
                                         "h: ",
                                         "x: [1, 2, 3]\n",
                                         "bodies:",
                                         "pendulum:",
                                         "binder: {axial: 1}\n",
                                         "ring: ",
                                         "[[1, 0, 0, 0]]",
                                         "table: a.csv",
                                         "[4, 4, 4]",
                                         "yes",
                                         "1e9",
                                         "# ",
                                         "\xc3",
                                         "\xff\xfe",
                                         "1/0",
                                         "1e999",
                                         "nan",
                                         "~",
                                         ","};
    const char *piece = pieces[rng_below(g, (int)(sizeof pieces / sizeof pieces[0]))];
    const size_t n = strlen(piece), at = (size_t)rng_below(g, (int)size);
    if (rng_below(g, 2)) {
        memmove(text + at + n, text + at, size - at);
        put(text + at, piece, n);
        return size + n;
    }
    put(text + at, piece, n);
    return at + n > size ? at + n : size;
}

static void mutations(void **state)
{
    rng g = rng_seed(20240229);
    (void)state;
    for (int from = 0; from < originals; ++from) {
        int scenes = 0;
        for (int k = 0; k < MUTATIONS; ++k) {
            char text[TEXT_SIZE + 256];
            size_t size = original_size[from];
            memcpy(text, original[from], size);
            for (int changes = 1 + rng_below(&g, 4); changes > 0; --changes)
                size = rng_below(&g, 2) ? mutate_byte(&g, text, size) : mutate_piece(&g, text, size);
            scenes += try_text(text, size, NULL, 0);
        }
        /* comments can be damaged without harm, keys and numbers cannot: both must have been met */
        assert_in_range(scenes, MUTATIONS / 50, MUTATIONS - MUTATIONS / 50);
    }
}

/** The same damage to what follows --set. */
static void mutated_overrides(void **state)
{
    static const char *const arguments[] = {"bodies.omega=[0.1, 2e-3, 1/64]", "pendulum.weight=2^-6", "stepper=vti3",
                                            "wall.planes=[[1, 0, 0, 0], [0, 1, 0, 2]]", "binder.shear.form=printed"};
    rng g = rng_seed(5);
    (void)state;
    for (int k = 0; k < MUTATIONS / 4; ++k) {
        char text[512];
        const char *const sets[] = {text};
        snprintf(text, sizeof text, "%s", arguments[rng_below(&g, 5)]);
        size_t size = strlen(text);
        for (int changes = 1 + rng_below(&g, 3); changes > 0; --changes)
            size = rng_below(&g, 2) ? mutate_byte(&g, text, size) : mutate_piece(&g, text, size);
        text[size] = '\0';
        try_text(original[0], original_size[0], sets, 1);
    }
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_truncation), cmocka_unit_test(mutations),
                                       cmocka_unit_test(mutated_overrides)};
    originals = argc - 1 < ORIGINALS ? argc - 1 : ORIGINALS;
    for (int k = 0; k < originals; ++k)
        original_size[k] = read_bytes(argv[k + 1], original[k]);
    return cmocka_run_group_tests(tests, enter_directory, leave_directory);
}
