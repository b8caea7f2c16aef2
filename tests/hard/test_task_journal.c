/* SPDX-License-Identifier: BSD-3-Clause
 * The journal of a study: cut at every byte, with every byte of its head and many behind it flipped, foreign, of another
 * study, in use by other processes, on a disk that is full. What is refused stays as it was. */
#define _POSIX_C_SOURCE 200809L
#include <stdio.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "scratch.h"
#include "support.h"
#include "task_journal.h"

enum {
    TASKS = 5,
    BYTES = 40,
    KEPT = 3,
    PARTS = 16 + 16 + 8 + 8,
    HEAD = PARTS + 8 * TASK_PARTS + 8,
    RECORD = 16 + BYTES + 8
};

static char folder[1024];
static char path[sizeof folder + 2];

static struct task_identity identity(void)
{
    struct task_identity id;
    memset(&id, 0, sizeof id);
    memcpy(id.version, "1.2.3", 6);
    id.tasks = TASKS;
    id.bytes = BYTES;
    for (int k = 0; k < TASK_PARTS; ++k)
        id.part[k] = (uint64_t)k + 17;
    return id;
}

/** What task t gives. */
static void fill(int64_t t, unsigned char result[BYTES])
{
    for (int k = 0; k < BYTES; ++k)
        result[k] = (unsigned char)(37 * t + k);
}

static size_t read_file(unsigned char *bytes, size_t size)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    const size_t n = fread(bytes, 1, size, file);
    fclose(file);
    return n;
}

static void write_file(const unsigned char *bytes, size_t size)
{
    unlink(path); /* some file systems flush a file that is cut to 0 and written again */
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
}

static void keep(struct task_journal *journal, int64_t task)
{
    unsigned char result[BYTES];
    struct message message = {""};
    const struct store store = task_journal_store(journal);
    fill(task, result);
    assert_int_equal(store.keep(store.self, task, (int)task + 1, result, &message), 0);
}

/** A journal with the first KEPT results; returns its size. */
static size_t make(unsigned char bytes[4096])
{
    struct task_journal journal;
    struct message message = {""};
    const struct task_identity id = identity();
    unlink(path);
    assert_int_equal(task_journal_open(&journal, folder, "j", 0, &id, &message), 0);
    for (int64_t t = 0; t < KEPT; ++t)
        keep(&journal, t);
    task_journal_close(&journal);
    const size_t size = read_file(bytes, 4096);
    assert_int_equal(size, HEAD + KEPT * RECORD);
    return size;
}

static void assert_one_line(const struct message *message)
{
    const size_t n = strlen(message->text);
    assert_in_range(n, 1, sizeof message->text - 2);
    assert_null(strchr(message->text, '\n'));
    assert_non_null(strstr(message->text, path));
}

/** Is refused with these words, and the file stays as it is. */
static void refused(int resume, const struct task_identity *id, const char *words)
{
    static unsigned char before[8192], after[8192];
    struct task_journal journal;
    struct message message = {""};
    const size_t size = read_file(before, sizeof before);
    if (task_journal_open(&journal, folder, "j", resume, id, &message) != -1)
        fail_msg("not refused: %s", words);
    assert_one_line(&message);
    if (strstr(message.text, words) == NULL)
        fail_msg("'%s' is not in '%s'", words, message.text);
    assert_int_equal(read_file(after, sizeof after), size);
    assert_memory_equal(before, after, size);
}

/** Goes on with so many results, which are the right ones, and with no others; what is added then is there next time. */
static void goes_on(int64_t results)
{
    unsigned char result[BYTES], want[BYTES];
    struct message message = {""};
    const struct task_identity id = identity();
    for (int again = 0; again < 2; ++again) {
        int rank = -1;
        struct task_journal journal;
        assert_int_equal(task_journal_open(&journal, folder, "j", 1, &id, &message), 0);
        const struct store store = task_journal_store(&journal);
        assert_int_equal(journal.kept, again ? results + 1 : results);
        for (int64_t t = 0; t < results; ++t) {
            assert_int_equal(store.recall(store.self, t, &rank, result), 1);
            fill(t, want);
            assert_memory_equal(result, want, BYTES);
            assert_int_equal(rank, t + 1);
        }
        assert_int_equal(store.recall(store.self, TASKS - 1, &rank, result), again);
        if (!again)
            keep(&journal, TASKS - 1);
        task_journal_close(&journal);
    }
}

static void cut_anywhere(void **state)
{
    unsigned char bytes[4096];
    const size_t size = make(bytes);
    struct task_identity other = identity();
    (void)state;
    other.part[0] ^= 1;
    for (size_t length = 0; length <= size; ++length) {
        write_file(bytes, length);
        if (length > PARTS && length < HEAD) /* killed as it began, which only the same study may do again */
            refused(1, &other, "damaged");
        goes_on(length < HEAD ? 0 : (int64_t)((length - HEAD) / RECORD));
    }
}

static void flipped_anywhere(void **state)
{
    unsigned char bytes[4096];
    const size_t size = make(bytes);
    const struct task_identity id = identity();
    (void)state;
    for (size_t at = 0; at < size; ++at)
        for (int bit = 0; bit < 8; ++bit) {
            bytes[at] = (unsigned char)(bytes[at] ^ 1 << bit);
            write_file(bytes, size);
            refused(1, &id, "damaged");
            bytes[at] = (unsigned char)(bytes[at] ^ 1 << bit);
        }
}

static void foreign(void **state)
{
    unsigned char bytes[4096];
    const struct task_identity id = identity();
    rng g = rng_seed(11);
    (void)state;
    for (int k = 0; k < 200; ++k) {
        const size_t size = 1 + (size_t)rng_below(&g, (int)sizeof bytes - 1);
        for (size_t i = 0; i < size; ++i)
            bytes[i] = (unsigned char)rng_below(&g, 256);
        write_file(bytes, size);
        refused(1, &id, "no journal of vti-study");
    }
}

static void another_study(void **state)
{
    static const char *const words[TASK_PARTS] = {"scene", "bodies",  "bonds",  "--steppers",
                                                  "--h",   "--t-end", "--evals"};
    unsigned char bytes[4096];
    struct task_identity id = identity();
    (void)state;
    make(bytes);
    refused(0, &id, "--resume");
    for (int k = 0; k < TASK_PARTS; ++k) {
        id.part[k] ^= 1;
        refused(1, &id, words[k]);
        id.part[k] ^= 1;
    }
    id.version[0] = '9';
    refused(1, &id, "is of vti 1.2.3 and this is vti 9.2.3");
    id = identity();
    ++id.tasks;
    refused(1, &id, "other quantities");
    goes_on(KEPT);
}

/** Another process holds the journal; when it is killed nothing of its lock is left. */
static void two_at_once(void **state)
{
    int ready[2];
    char c = 0;
    struct message message = {""};
    const struct task_identity id = identity();
    (void)state;
    unlink(path);
    assert_int_equal(pipe(ready), 0);
    const pid_t other = fork();
    assert_int_not_equal(other, -1);
    if (other == 0) {
        struct task_journal journal;
        if (task_journal_open(&journal, folder, "j", 0, &id, &message) == 0 && write(ready[1], "r", 1) == 1)
            pause();
        _exit(1);
    }
    assert_int_equal(read(ready[0], &c, 1), 1);
    refused(0, &id, "another vti-study is writing there");
    refused(1, &id, "another vti-study is writing there");
    kill(other, SIGKILL);
    waitpid(other, NULL, 0);
    goes_on(0);
    close(ready[0]);
    close(ready[1]);
}

/** Opens and removes the journal again and again; nobody else may have it between. */
static int take_turns(const char *held, int times)
{
    struct task_journal journal;
    const struct task_identity id = identity();
    int turns = 0;
    while (turns < times) {
        struct message message = {""};
        if (task_journal_open(&journal, folder, "j", 0, &id, &message) != 0) {
            if (strstr(message.text, "another vti-study is writing there") == NULL)
                return 1;
            continue;
        }
        if (mkdir(held, 0777) != 0 || rmdir(held) != 0)
            return 1;
        task_journal_remove(&journal);
        ++turns;
    }
    return 0;
}

/** Studies that begin and end in one folder all the time: a journal is never locked when it has been removed already. */
static void many_at_once(void **state)
{
    enum { PROCESSES = 4, TURNS = 1000 };
    char held[sizeof path + 5];
    int code, wrong = 0;
    (void)state;
    unlink(path);
    snprintf(held, sizeof held, "%s.held", path);
    for (int k = 0; k < PROCESSES; ++k) {
        const pid_t child = fork();
        assert_int_not_equal(child, -1);
        if (child == 0)
            _exit(take_turns(held, TURNS));
    }
    for (int k = 0; k < PROCESSES; ++k)
        wrong += wait(&code) < 0 || code != 0;
    assert_int_equal(wrong, 0);
    assert_int_equal(access(path, F_OK), -1);
}

static void full_disk(void **state)
{
    struct task_journal journal;
    struct message message = {""};
    const struct task_identity id = identity();
    (void)state;
    unlink(path);
    if (access("/dev/full", W_OK) != 0 || symlink("/dev/full", path) != 0)
        skip();
    assert_int_equal(task_journal_open(&journal, folder, "j", 0, &id, &message), -1);
    assert_one_line(&message);
    assert_non_null(strstr(message.text, "make space"));
    unlink(path);
}

static void removed(void **state)
{
    struct task_journal journal;
    struct message message = {""};
    const struct task_identity id = identity();
    (void)state;
    unlink(path);
    for (int results = 0; results < 2; ++results) {
        assert_int_equal(task_journal_open(&journal, folder, "j", 0, &id, &message), 0);
        if (results == 0) {
            task_journal_close(&journal); /* without a result there is nothing to keep */
        } else {
            keep(&journal, 1);
            task_journal_remove(&journal);
        }
        assert_int_equal(access(path, F_OK), -1);
    }
}

static int enter(void **state)
{
    (void)state;
    assert_true(scratch_make(folder, sizeof folder));
    snprintf(path, sizeof path, "%s/j", folder);
    return 0;
}

static int leave(void **state)
{
    (void)state;
    unlink(path);
    return rmdir(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(cut_anywhere), cmocka_unit_test(flipped_anywhere),
                                       cmocka_unit_test(foreign),      cmocka_unit_test(another_study),
                                       cmocka_unit_test(two_at_once),  cmocka_unit_test(many_at_once),
                                       cmocka_unit_test(full_disk),    cmocka_unit_test(removed)};
    return cmocka_run_group_tests(tests, enter, leave);
}
