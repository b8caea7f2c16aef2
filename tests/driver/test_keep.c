/* SPDX-License-Identifier: BSD-3-Clause
 * What survives a kill, part by part: pieces that are committed or taken back, damage, identities, streams of records,
 * files that come together or not at all. Programs that are killed: test_run_resume.py, tests/hard. */
#define _POSIX_C_SOURCE 200809L
#include <sqlite3.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include "identity.h"
#include "journal.h"
#include "scratch.h"
#include "support.h"

static char folder[1024], path[sizeof folder + 8];
static const char piece[] = "these bytes are kept";

static int open_as(struct keep *keep, const char *identity, int resume, struct message *message)
{
    return keep_open(keep, path, "run", identity, resume, message);
}

static void assert_kept(struct keep *keep, int64_t number, int is_there)
{
    const void *bytes;
    size_t size;
    struct message message = {""};
    assert_int_equal(keep_get(keep, KEEP_ROWS, number, &bytes, &size, &message), is_there);
    if (is_there) {
        assert_int_equal(size, sizeof piece);
        assert_memory_equal(bytes, piece, sizeof piece);
    }
}

TEST(committed_or_taken_back)
{
    struct keep keep;
    struct message message = {""};
    struct stat info;
    assert_int_equal(open_as(&keep, "h: 1\n", 0, &message), 0);
    assert_int_equal(keep_put(&keep, KEEP_ROWS, 1, piece, sizeof piece, &message), 0);
    assert_int_equal(keep_commit(&keep, &message), 0);
    assert_int_equal(keep_put(&keep, KEEP_ROWS, 2, piece, sizeof piece, &message), 0);
    keep_close(&keep);
    assert_int_equal(open_as(&keep, "h: 1\n", 0, &message), -1);
    assert_non_null(strstr(message.text, "holds a run that was interrupted; go on with it by --resume"));
    assert_int_equal(open_as(&keep, "h: 2\n", 1, &message), -1);
    assert_non_null(strstr(message.text, "is of another run: h: 1 there, 2 here"));
    assert_int_equal(open_as(&keep, "h: 1\n", 1, &message), 0);
    assert_kept(&keep, 1, 1);
    assert_kept(&keep, 2, 0);
    keep_remove(&keep);
    assert_int_not_equal(stat(path, &info), 0);
}

/** One byte of what is kept is another one. */
TEST(damage_is_seen)
{
    struct keep keep;
    struct message message = {""};
    static char all[1 << 18];
    const void *bytes;
    size_t size;
    int64_t count;
    assert_int_equal(open_as(&keep, "h: 1\n", 0, &message), 0);
    assert_int_equal(keep_put(&keep, KEEP_ROWS, 7, piece, sizeof piece, &message), 0);
    assert_int_equal(keep_commit(&keep, &message), 0);
    keep_close(&keep);
    FILE *file = fopen(path, "r+b");
    assert_non_null(file);
    const size_t length = fread(all, 1, sizeof all, file);
    size_t at = 0;
    while (at + sizeof piece <= length && memcmp(all + at, piece, sizeof piece) != 0)
        ++at;
    assert_true(at + sizeof piece <= length);
    assert_int_equal(fseek(file, (long)at + 3, SEEK_SET), 0);
    fputc('?', file);
    fclose(file);
    assert_int_equal(open_as(&keep, "h: 1\n", 1, &message), 0);
    assert_int_equal(keep_get(&keep, KEEP_ROWS, 7, &bytes, &size, &message), -1);
    assert_non_null(strstr(message.text, "is damaged; delete it and start the run anew"));
    assert_int_equal(keep_check(&keep, KEEP_ROWS, &count, &message), -1);
    keep_remove(&keep);
}

/** A text is left as it is. What cannot be written is said with its reason, each time anew. */
TEST(reasons)
{
    enum { TEXT = 100 };
    static char large[1 << 20];
    struct keep keep;
    struct message message = {""};
    struct stat info;
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    for (int k = 0; k < TEXT; ++k)
        fputc(k % 20 == 19 ? '\n' : 'a', file);
    fclose(file);
    assert_int_equal(open_as(&keep, "h: 1\n", 0, &message), -1);
    assert_non_null(strstr(message.text, "is none of vti's, or is damaged; delete it and start the run anew"));
    assert_int_equal(stat(path, &info), 0);
    assert_int_equal(info.st_size, TEXT);
    assert_int_equal(unlink(path), 0);

    assert_int_equal(open_as(&keep, "h: 1\n", 0, &message), 0);
    assert_int_equal(sqlite3_exec(keep.db, "PRAGMA max_page_count = 1", NULL, NULL, NULL), SQLITE_OK);
    for (int k = 0; k < 3; ++k) {
        message.text[0] = '\0';
        assert_int_equal(keep_put(&keep, KEEP_ROWS, k, large, sizeof large, &message), -1);
        assert_non_null(strstr(message.text, "No space left on device; make space there"));
    }
    keep_remove(&keep);

    assert_int_equal(open_as(&keep, "h: 1\n", 0, &message), 0);
    assert_int_equal(sqlite3_exec(keep.db, "DROP TABLE rows", NULL, NULL, NULL), SQLITE_OK);
    for (int k = 0; k < 3; ++k) {
        message.text[0] = '\0';
        assert_int_equal(keep_put(&keep, KEEP_ROWS, k, piece, sizeof piece, &message), -1);
        assert_non_null(strstr(message.text, "is none of vti's, or is damaged; delete it"));
        if (k == 1)
            assert_int_equal(sqlite3_exec(keep.db, "ROLLBACK", NULL, NULL, NULL), SQLITE_OK);
    }
    assert_int_equal(keep_commit(&keep, &message), -1);
    assert_non_null(strstr(message.text, "is none of vti's, or is damaged; delete it"));
    keep_remove(&keep);

    char deep[FOLDER_PATH], name[101] = "";
    struct keep far;
    memset(name, 'd', sizeof name - 1);
    snprintf(deep, sizeof deep, "%s", folder);
    for (int k = 0; k < 6; ++k) { /* longer than SQLite takes */
        snprintf(deep + strlen(deep), sizeof deep - strlen(deep), "/%s", name);
        assert_int_equal(mkdir(deep, 0700), 0);
    }
    snprintf(deep + strlen(deep), sizeof deep - strlen(deep), "/out.run");
    assert_int_equal(keep_open(&far, deep, "run", "h: 1\n", 0, &message), -1);
    assert_non_null(strstr(message.text, "characters, and at most 511 can be used; use a shorter one with -o"));
    assert_int_equal(stat(deep, &info), -1);
    for (char *end = strrchr(deep, '/'); strlen(deep) > strlen(folder); end = strrchr(deep, '/')) {
        *end = '\0';
        if (strlen(deep) > strlen(folder))
            assert_int_equal(rmdir(deep), 0);
    }

    if (getuid() == 0) /* may write anywhere */
        return;
    assert_int_equal(chmod(folder, 0500), 0);
    assert_int_equal(open_as(&keep, "h: 1\n", 0, &message), -1);
    assert_int_equal(chmod(folder, 0700), 0);
    assert_non_null(strstr(message.text, "Permission denied; allow writing there"));
}

TEST(identities)
{
    static const struct {
        const char *there, *here, *difference;
    } cases[] = {
        {"h: 1\nt: 2\n", "h: 1\nt: 2\n", NULL},
        {"h: 1\nt: 2\n", "h: 1\nt: 3\n", "t: 2 there, 3 here"},
        {"h: 1\nwall: 2\n", "h: 1\n", "wall: 2 there, nothing here"},
        {"h: 1\n", "g: 0\nh: 1\n", "g: 0 here, nothing there"},
        {"k: 111111111 222222222 333333333 444444444 5\n", "k: 111111111 222222222 333333333 444444444 6\n",
         "k: ... 5 there, ... 6 here"},
        {"k:1\n", "k: 2\n", "k: 1 there, 2 here"},
    };
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; ++k) {
        struct message difference = {""};
        const int same = identity_is(cases[k].there, strlen(cases[k].there), cases[k].here, &difference);
        assert_int_equal(same, cases[k].difference == NULL);
        if (!same)
            assert_string_equal(difference.text, cases[k].difference);
    }
}

/** Records that do not fit into pieces come back as they were, from any of them on. */
TEST(streams_of_records)
{
    enum { DOUBLES = 50000, RECORDS = 4 };
    static double record[DOUBLES], back[2 * DOUBLES];
    static struct journal journal;
    struct message message = {""};
    assert_int_equal(open_as(&journal.keep, "h: 1\n", 0, &message), 0);
    const struct journal_marks marks = {journal_mark_start(DOUBLES), journal_mark_start(1), journal_mark_start(0)};
    assert_int_equal(journal_start(&journal, &marks, &message), 0);
    for (int r = 0; r < RECORDS; ++r) {
        for (int k = 0; k < DOUBLES; ++k)
            record[k] = 1e6 * r + k;
        assert_int_equal(journal_add(&journal, &journal.rows, record, &message), 0);
    }
    assert_int_equal(journal_flush(&journal, &message), 0);
    assert_int_equal(journal.rows.mark.count, RECORDS);
    assert_int_equal(journal_read(&journal, &journal.rows, 1, 2, back, &message), 0);
    for (int k = 0; k < 2 * DOUBLES; ++k)
        assert_true(back[k] == record[k % DOUBLES] - 1e6 * (k < DOUBLES ? 2 : 1));
    assert_int_equal(journal_read(&journal, &journal.rows, RECORDS + 2, 1, back, &message), -1);
    journal_end(&journal, 1);
}

/** What stands in folder/name, one letter; 0 if nothing does. */
static int letter_of(const char *name, int part)
{
    char file[FOLDER_PATH];
    struct message message;
    assert_int_equal(folder_path(folder, name, part, file, &message), 0);
    FILE *open = fopen(file, "rb");
    const int letter = open != NULL ? fgetc(open) : 0;
    if (open != NULL)
        fclose(open);
    return letter;
}

static void put_letter(const char *name, int letter)
{
    struct message message;
    FILE *file = folder_open(folder, name, &message);
    assert_non_null(file);
    fputc(letter, file);
    assert_int_equal(folder_close(file, folder, name, &message), 0);
}

TEST(together_or_not_at_all)
{
    static const char *const names[] = {"a", "b"};
    struct message message = {""};
    for (int failed = 0; failed >= -1; --failed) {
        put_letter("a", failed == 0 ? '1' : '2');
        put_letter("b", failed == 0 ? '3' : '4');
        assert_int_equal(folder_finish(folder, names, 2, failed, &message), failed);
        assert_int_equal(letter_of("a", 0), '1');
        assert_int_equal(letter_of("b", 0), '3');
        assert_int_equal(letter_of("a", 1) + letter_of("b", 1), 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(committed_or_taken_back),
                                       cmocka_unit_test(damage_is_seen),
                                       cmocka_unit_test(reasons),
                                       cmocka_unit_test(identities),
                                       cmocka_unit_test(streams_of_records),
                                       cmocka_unit_test(together_or_not_at_all)};
    if (!scratch_make(folder, sizeof folder))
        return 1;
    snprintf(path, sizeof path, "%s/r.run", folder);
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    char command[sizeof folder + 16];
    snprintf(command, sizeof command, "rm -r '%s'", folder);
    return system(command) != 0 || failed != 0; /* NOLINT(cert-env33-c): a folder of its own */
}
