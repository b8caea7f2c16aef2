/* SPDX-License-Identifier: BSD-3-Clause
 * What the tests of the scene reader share: scene files in a directory of their own, written and read back. */
#ifndef VTI_SCENE_SUPPORT_H
#define VTI_SCENE_SUPPORT_H

#include "support.h"

#include <unistd.h>

#include "quote.h"
#include "scene.h"

enum { TEXT_SIZE = 8192 };

/** Moves into a new directory below the present one; leave_directory empties it of the files named and removes it. */
static inline void enter_directory(char directory[64])
{
    snprintf(directory, 64, "scene-XXXXXX");
    assert_non_null(mkdtemp(directory));
    assert_int_equal(chdir(directory), 0);
}

static inline void leave_directory(const char *directory, const char *const *files, int n)
{
    for (int k = 0; k < n; ++k)
        remove(files[k]);
    assert_int_equal(chdir(".."), 0);
    assert_int_equal(rmdir(directory), 0);
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

#endif
