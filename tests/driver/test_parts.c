/* SPDX-License-Identifier: BSD-3-Clause
 * Threads do every part of every call once, see what the caller has written, and are waited for. */
#define _POSIX_C_SOURCE 200809L
#include "support.h"

#include <sched.h>
#include <time.h>

#include "threads.h"

enum { PARTS = 40 };

struct load {
    int64_t call, parts, done[PARTS];
    int64_t slow; /* the part that takes its time, -1 for none */
};

static int64_t do_part(void *self, int64_t part)
{
    struct load *load = self;
    for (int k = 0; part == load->slow && k < 1000; ++k)
        sched_yield();
    load->done[part] += load->call;
    return part + load->call;
}

static void call(struct load *load, int64_t number, int64_t parts, int64_t slow)
{
    load->call = number;
    load->slow = slow;
    assert_int_equal(threads_sum(parts, do_part, load), parts * (parts - 1) / 2 + parts * number);
    for (int64_t k = 0; k < PARTS; ++k) {
        assert_int_equal(load->done[k], k < parts ? number : 0);
        load->done[k] = 0;
    }
}

/** More threads than parts, as many, and fewer; calls that follow each other at once. */
TEST(every_part_once)
{
    static const int64_t used[] = {1, 2, 3, 7, 2};
    struct load load = {0};
    assert_int_equal(threads_used(), 1);
    for (size_t u = 0; u < sizeof used / sizeof used[0]; ++u) {
        threads_use(used[u]);
        assert_int_equal(threads_used(), used[u]);
        for (int64_t number = 1; number <= 200; ++number)
            call(&load, number, 1 + number % PARTS, -1);
    }
}

/** Threads go to sleep between calls, and the caller does before the end of one. */
TEST(who_waits)
{
    const struct timespec rest = {0, 2000000};
    struct load load = {0};
    threads_use(3);
    for (int64_t number = 1; number <= 9; ++number) {
        nanosleep(&rest, NULL);
        call(&load, number, 3, number % 4 - 1);
    }
}

TEST(how_many)
{
    assert_in_range(threads_most(), 1, THREADS_MOST);
    threads_use(THREADS_MOST + 1);
    assert_int_equal(threads_used(), THREADS_MOST);
    threads_use(1);
}

RUN_TESTS(cmocka_unit_test(every_part_once), cmocka_unit_test(who_waits), cmocka_unit_test(how_many))
