/* SPDX-License-Identifier: BSD-3-Clause
 * What the tests of the scene reader share: scene files in a directory of their own, written and read back. */
#ifndef VTI_SCENE_SUPPORT_H
#define VTI_SCENE_SUPPORT_H

#include "scratch.h"
#include "support.h"

#include <dirent.h>

#include "quote.h"
#include "scene.h"
#include "settings.h"

enum { TEXT_SIZE = 8192 };

static char own_directory[1024];

/** Group fixtures: the tests run in a directory of their own, which goes with all files in it. */
static inline int enter_directory(void **state)
{
    (void)state;
    assert_true(scratch_make(own_directory, sizeof own_directory));
    assert_int_equal(chdir(own_directory), 0);
    return 0;
}

static inline int leave_directory(void **state)
{
    (void)state;
    DIR *files = opendir(".");
    assert_non_null(files);
    for (const struct dirent *entry; (entry = readdir(files)) != NULL;)
        if (strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0)
            assert_int_equal(remove(entry->d_name), 0);
    closedir(files);
    assert_int_equal(chdir(".."), 0);
    assert_int_equal(rmdir(strrchr(own_directory, '/') + 1), 0);
    return 0;
}

#define RUN_TESTS_IN_FOLDER(...)                                                                                       \
    int main(void)                                                                                                     \
    {                                                                                                                  \
        const struct CMUnitTest tests[] = {__VA_ARGS__};                                                               \
        return cmocka_run_group_tests(tests, enter_directory, leave_directory);                                        \
    }

static inline void write_bytes(const char *path, const char *bytes, size_t size)
{
    remove(path); /* some file systems flush a file that is cut to 0 and written again, which takes 1000 times longer */
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
}

static inline size_t read_bytes(const char *path, char text[TEXT_SIZE])
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    const size_t n = fread(text, 1, TEXT_SIZE - 1, file);
    fclose(file);
    text[n] = '\0';
    return n;
}

/** A refusal is one line, whole and not empty. */
static inline void assert_one_line(const struct message *message)
{
    const size_t n = strlen(message->text);
    assert_in_range(n, 1, sizeof message->text - 2);
    for (size_t k = 0; k < n; ++k)
        if ((unsigned char)message->text[k] < 0x20)
            fail_msg("control character in '%s'", message->text);
}

/** The refusal of what, word by word. */
static inline void assert_refused(const char *what, int result, const struct message *message, const char *line)
{
    if (result != -1)
        fail_msg("accepted: %s", what);
    if (strcmp(message->text, line) != 0) {
        print_error("of: %s\n", what);
        assert_string_equal(message->text, line);
    }
    assert_one_line(message);
}

/** A scene's text, or what follows --set, and the refusal behind its place, "t.yaml:" or "--set ...: ". */
struct refusal {
    const char *text, *line;
};

static inline void assert_files_refused(const struct refusal *refused, size_t n)
{
    for (size_t k = 0; k < n; ++k) {
        struct scene scene;
        struct message message;
        char line[4096];
        write_bytes("t.yaml", refused[k].text, strlen(refused[k].text));
        snprintf(line, sizeof line, "t.yaml:%s", refused[k].line);
        assert_refused(refused[k].text, scene_read("t.yaml", NULL, 0, &scene, &message), &message, line);
    }
}

/** On the scene in t.yaml. */
static inline void assert_sets_refused(const struct refusal *refused, size_t n)
{
    for (size_t k = 0; k < n; ++k) {
        struct scene scene;
        struct message message;
        char line[4096];
        snprintf(line, sizeof line, "--set %s: %s", refused[k].text, refused[k].line);
        for (char *p = line; *p != '\0'; ++p)
            *p = *p == '\n' ? '?' : *p;
        assert_refused(refused[k].text, scene_read("t.yaml", &refused[k].text, 1, &scene, &message), &message, line);
    }
}

#endif
