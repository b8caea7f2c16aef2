/* SPDX-License-Identifier: BSD-3-Clause
 * What a study keeps: a million small results, each found by its number, without reading all into memory; programs that
 * begin and end in one folder all the time never hold one file twice. */
#define _POSIX_C_SOURCE 200809L
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "scratch.h"
#include "support.h"
#include "tasks.h"

static char folder[1024];
static char path[sizeof folder + 2];

struct result {
    int64_t task;
    double values[24];
};

static void open_as(struct tasks *tasks, int resume, size_t bytes)
{
    struct message message = {""};
    if (tasks_open(tasks, folder, "j", resume, "h: 1\n", bytes, &message) != 0)
        fail_msg("%s", message.text);
}

TEST(test_million)
{
    const int64_t n = 1 << 20, most = 40 << 10;
    struct tasks tasks;
    struct message message = {""};
    struct result result;
    struct rusage before, after;
    memset(&result, 0, sizeof result);
    getrusage(RUSAGE_SELF, &before);
    open_as(&tasks, 0, sizeof result);
    struct store store = tasks_store(&tasks);
    for (int64_t k = 0; k < n; ++k) { /* nearly in order, as ranks send them */
        result.task = k ^ 1023;
        assert_int_equal(store.keep(store.self, result.task, (int)(result.task % 3), &result, &message), 0);
    }
    assert_int_equal(tasks_commit(&tasks, &message), 0);
    tasks_end(&tasks, 0);
    open_as(&tasks, 1, sizeof result);
    store = tasks_store(&tasks);
    assert_int_equal(tasks.kept, n);
    for (int64_t k = 0; k < n; k += 997) {
        int rank = -1;
        result.task = -1;
        assert_int_equal(store.recall(store.self, k, &rank, &result), 1);
        assert_int_equal(result.task, k);
        assert_int_equal(rank, k % 3);
    }
    tasks_end(&tasks, 1);
    getrusage(RUSAGE_SELF, &after);
    if (getenv("ASAN_OPTIONS") == NULL) /* the sanitizer of addresses takes memory of its own */
        assert_true(after.ru_maxrss - before.ru_maxrss < most);
    assert_int_equal(access(path, F_OK), -1);
}

/** Opens and removes the file again and again; nobody else may have it between. */
static int take_turns(const char *held, int times)
{
    struct tasks tasks;
    for (int turns = 0; turns < times;) {
        struct message message = {""};
        if (tasks_open(&tasks, folder, "j", 0, "h: 1\n", 8, &message) != 0) {
            if (strstr(message.text, "another vti-study is writing there") == NULL)
                return fprintf(stderr, "%s\n", message.text);
            continue;
        }
        if (mkdir(held, 0777) != 0 || rmdir(held) != 0)
            return fprintf(stderr, "held twice\n");
        tasks_end(&tasks, 1);
        ++turns;
    }
    return 0;
}

TEST(test_many_at_once)
{
    enum { PROCESSES = 4, TURNS = 200 };
    char held[sizeof path + 5];
    int code, wrong = 0;
    snprintf(held, sizeof held, "%s.held", path);
    for (int k = 0; k < PROCESSES; ++k) {
        const pid_t child = fork();
        assert_int_not_equal(child, -1);
        if (child == 0)
            _exit(take_turns(held, TURNS) != 0);
    }
    for (int k = 0; k < PROCESSES; ++k)
        wrong += wait(&code) < 0 || code != 0;
    assert_int_equal(wrong, 0);
    assert_int_equal(access(path, F_OK), -1);
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
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_million), cmocka_unit_test(test_many_at_once)};
    return cmocka_run_group_tests(tests, enter, leave);
}
