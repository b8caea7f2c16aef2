/* SPDX-License-Identifier: BSD-3-Clause
 * Files that are no scene files at all: missing, huge, deeply nested, oddly named. */
#define _POSIX_C_SOURCE 200809L
#include "scene_support.h"

static const char spin[] = "bodies: {inertia: 1, alpha: [0, 0, 0], omega: [0, 0, 1]}\nh: 1/64\nt_end: 1\n";

TEST(names_of_files)
{
    static const char *const refused[] = {"a b.yaml", "a.b.yaml", ".yaml", "\xc3\xa4.yaml"};
    for (size_t k = 0; k < sizeof refused / sizeof refused[0]; ++k) {
        struct scene scene;
        struct message message;
        char line[256], base[64];
        snprintf(base, sizeof base, "%s", refused[k]);
        *strrchr(base, '.') = '\0';
        snprintf(line, sizeof line,
                 "%s:1:1: name: '%s' (from the file's name, for there is no key 'name') cannot name files; "
                 "write 1 to 63 letters, digits, _ or -",
                 refused[k], base);
        write_bytes(refused[k], spin, sizeof spin - 1);
        assert_refused(refused[k], scene_read(refused[k], NULL, 0, &scene, &message), &message, line);
        remove(refused[k]);
    }
}

TEST(what_is_no_file)
{
    struct scene scene;
    struct message message;
    assert_refused("missing", scene_read("no/such.yaml", NULL, 0, &scene, &message), &message,
                   "no/such.yaml: cannot be read: No such file or directory; give the path of a scene file");
    assert_refused("directory", scene_read(".", NULL, 0, &scene, &message), &message,
                   ".: cannot be read: Is a directory; give the path of a scene file");
    assert_refused("no name", scene_read("", NULL, 0, &scene, &message), &message,
                   ": cannot be read: No such file or directory; give the path of a scene file");
}

/** The end of a long path is shown, and nothing that could be mistaken for a second line. */
TEST(long_and_wild_paths)
{
    char path[1100];
    struct scene scene;
    struct message message;
    memset(path, 'd', sizeof path);
    snprintf(path + 1000, sizeof path - 1000, "%s", "/a\nb\x1b[31m.yaml");
    assert_int_equal(scene_read(path, NULL, 0, &scene, &message), -1);
    assert_one_line(&message);
    assert_memory_equal(message.text, "...ddd", 6);
    assert_non_null(strstr(message.text, "ddd/a?b?[31m.yaml: cannot be read: "));
    for (size_t k = 0; k < 1000; ++k) /* of two bytes each, cut in the middle of one */
        path[k] = (k & 1) != 0 ? '\xa4' : '\xc3';
    assert_int_equal(scene_read(path, NULL, 0, &scene, &message), -1);
    assert_memory_equal(message.text, "...\xc3\xa4\xc3\xa4", 7);
}

/** Whatever a message quotes is one line of UTF-8 without commands for terminals. */
TEST(messages_are_readable)
{
    struct message message;
    assert_int_equal(message_set(&message, "%s", "a\n\x1b[31m\x7f\xff \xc3\xa4\xc2\x9bz"), -1);
    assert_string_equal(message.text, "a??[31m?? \xc3\xa4??z");
}

/** What libfyaml reads as the end of the text, without a word. */
TEST(a_zero_inside)
{
    static const char text[] = "bodies: {inertia: 1, alpha: [0, 0, 0], omega: [0, 0, 1]}\nh: 1/64\nt_end: 1\n\0h: 2\n";
    struct scene scene;
    struct message message;
    write_bytes("t.yaml", text, sizeof text - 1);
    assert_refused("0 inside", scene_read("t.yaml", NULL, 0, &scene, &message), &message,
                   "t.yaml:4:1: a control character; give a text file in UTF-8");
}

/** 100 MB of holes: refused after the first megabyte. */
TEST(a_huge_file)
{
    struct scene scene;
    struct message message;
    write_bytes("t.yaml", spin, sizeof spin - 1);
    assert_int_equal(truncate("t.yaml", 100 * 1000 * 1000), 0);
    assert_refused("100 MB", scene_read("t.yaml", NULL, 0, &scene, &message), &message,
                   "t.yaml: is larger than 1 MiB; a scene is short, is this the right file?");
}

/** A text of a megabyte costs no more than a second, however it is nested: what libfyaml takes the square of the size
 *  for is refused before. */
TEST(deep_and_long_texts)
{
    static const struct {
        const char *unit, *line;
    } deep[] = {
        {"[", "t.yaml:1:17: nested too deeply; a scene has sections, keys and lists and no more"},
        {"{h: ", "t.yaml:1:65: nested too deeply; a scene has sections, keys and lists and no more"},
        {"- ", "t.yaml:1:33: nested too deeply; a scene has sections, keys and lists and no more"},
        {"? ", "t.yaml:1:3: a list or section stands where a key belongs; write 'key: value'"},
        {"h: 1\n", "t.yaml:2:1: h: given a second time, first on line 1; keep one of them"},
        {"z\n", NULL},
        {" ", "t.yaml:1:1002: 1000 blanks in a row; a scene needs fewer, remove some"},
        {"%", "t.yaml:1:1002: a directive or tag of 1000 characters; a scene needs none, remove it"},
        {"!<", "t.yaml:1:1002: a directive or tag of 1000 characters; a scene needs none, remove it"},
        {"\n", "t.yaml:1002:1: 1000 empty lines; a scene is short, is this the right file?"},
    };
    enum { SIZE = 1 << 20 };
    char *text = malloc(SIZE);
    assert_non_null(text);
    for (size_t k = 0; k < sizeof deep / sizeof deep[0]; ++k) {
        const size_t n = strlen(deep[k].unit);
        struct scene scene;
        struct message message;
        for (size_t i = 0; i < SIZE; ++i)
            text[i] = deep[k].unit[i % n];
        write_bytes("t.yaml", text, SIZE / n * n);
        const int result = scene_read("t.yaml", NULL, 0, &scene, &message);
        assert_refused(deep[k].unit, result, &message, deep[k].line != NULL ? deep[k].line : message.text);
    }
    free(text);
}

RUN_TESTS_IN_FOLDER(cmocka_unit_test(names_of_files), cmocka_unit_test(what_is_no_file),
                    cmocka_unit_test(long_and_wild_paths), cmocka_unit_test(messages_are_readable),
                    cmocka_unit_test(a_huge_file), cmocka_unit_test(a_zero_inside),
                    cmocka_unit_test(deep_and_long_texts))
