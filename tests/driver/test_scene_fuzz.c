/* SPDX-License-Identifier: BSD-3-Clause
 * Damaged scene files: every truncation of the shipped pendulum (the argument), and seeded changes of bytes and of
 * pieces of YAML. Each gives a scene whose numbers make sense or one whole line; sanitizers watch the memory. */
#define _POSIX_C_SOURCE 200809L
#include "scene_support.h"

enum { MUTATIONS = 20000 };

static char original[TEXT_SIZE];
static size_t original_size;

static int positive(double x)
{
    return isfinite(x) && x > 0.0;
}

static void check_scene(const struct scene *s)
{
    assert_true(s->translates || s->turns);
    assert_true(!s->translates || (positive(s->mass) && all_finite(s->x, 3) && all_finite(s->v, 3)));
    assert_true(!s->turns || (positive(s->inertia) && all_finite(s->alpha, 3) && all_finite(s->omega, 3)));
    assert_true(!s->has_pendulum || (s->turns && s->pendulum.weight >= 0.0 && all_finite(s->pendulum.rho0, 3)));
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
    for (size_t size = 0; size <= original_size; ++size)
        assert_true(try_text(original, size, NULL, 0) || size < original_size);
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
    int scenes = 0;
    (void)state;
    for (int k = 0; k < MUTATIONS; ++k) {
        char text[TEXT_SIZE + 256];
        size_t size = original_size;
        memcpy(text, original, size);
        for (int changes = 1 + rng_below(&g, 4); changes > 0; --changes)
            size = rng_below(&g, 2) ? mutate_byte(&g, text, size) : mutate_piece(&g, text, size);
        scenes += try_text(text, size, NULL, 0);
    }
    /* comments can be damaged without harm, keys and numbers cannot: both must have been met */
    assert_in_range(scenes, MUTATIONS / 50, MUTATIONS - MUTATIONS / 50);
}

/** The same damage to what follows --set. */
static void mutated_overrides(void **state)
{
    static const char *const arguments[] = {"bodies.omega=[0.1, 2e-3, 1/64]", "pendulum.weight=2^-6", "stepper=vti3"};
    rng g = rng_seed(5);
    (void)state;
    for (int k = 0; k < MUTATIONS / 4; ++k) {
        char text[512];
        const char *const sets[] = {text};
        snprintf(text, sizeof text, "%s", arguments[rng_below(&g, 3)]);
        size_t size = strlen(text);
        for (int changes = 1 + rng_below(&g, 3); changes > 0; --changes)
            size = rng_below(&g, 2) ? mutate_byte(&g, text, size) : mutate_piece(&g, text, size);
        text[size] = '\0';
        try_text(original, original_size, sets, 1);
    }
}

int main(int argc, char **argv)
{
    static const char *const names[] = {"t.yaml"};
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_truncation), cmocka_unit_test(mutations),
                                       cmocka_unit_test(mutated_overrides)};
    char directory[64];
    original_size = read_bytes(argc > 1 ? argv[1] : "pendulum.yaml", original);
    enter_directory(directory);
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    leave_directory(directory, names, 1);
    return failed;
}
