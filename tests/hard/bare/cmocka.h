/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A stand-in for CMocka on machines for which there is none: what the tests of the core use of it. The first failure
 * ends the program. */
#ifndef VTI_TESTS_BARE_CMOCKA_H
#define VTI_TESTS_BARE_CMOCKA_H

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct CMUnitTest {
    const char *name;
    void (*test)(void **state);
    int (*setup)(void **state);
};

#define cmocka_unit_test(test)                                                                                         \
    {                                                                                                                  \
#test, test, NULL                                                                                              \
    }
#define cmocka_unit_test_setup(test, setup)                                                                            \
    {                                                                                                                  \
#test, test, setup                                                                                             \
    }
#define cmocka_run_group_tests(tests, setup, teardown)                                                                 \
    bare_run(tests, sizeof(tests) / sizeof((tests)[0]), setup, teardown)

#define assert_true(x) bare_must((x) ? 1 : 0, #x, __FILE__, __LINE__)
#define assert_false(x) bare_must((x) ? 0 : 1, "not " #x, __FILE__, __LINE__)
#define assert_null(x) assert_true((x) == NULL)
#define assert_non_null(x) assert_true((x) != NULL)
#define assert_ptr_equal(a, b) assert_true((a) == (b))
#define assert_int_equal(a, b) bare_must((long long)(a) == (long long)(b), #a " == " #b, __FILE__, __LINE__)
#define assert_int_not_equal(a, b) bare_must((long long)(a) != (long long)(b), #a " != " #b, __FILE__, __LINE__)
#define assert_in_range(a, least, most) assert_true((a) >= (least) && (a) <= (most))
#define assert_string_equal(a, b) assert_true(strcmp(a, b) == 0)
#define assert_string_not_equal(a, b) assert_true(strcmp(a, b) != 0)
#define assert_memory_equal(a, b, bytes) assert_true(memcmp(a, b, bytes) == 0)
#define assert_memory_not_equal(a, b, bytes) assert_true(memcmp(a, b, bytes) != 0)
#define skip() return
#define fail() _fail(__FILE__, __LINE__)
#define fail_msg(...) (print_error(__VA_ARGS__), fail())
#define print_message(...) ((void)printf(__VA_ARGS__))

static inline void print_error(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    vfprintf(stderr, format, args);
    va_end(args);
}

static inline void _fail(const char *file, int line)
{
    print_error("%s:%d: failed\n", file, line);
    exit(1);
}

static inline void bare_must(int holds, const char *what, const char *file, int line)
{
    if (!holds) {
        print_error("%s does not hold\n", what);
        _fail(file, line);
    }
}

static inline int bare_run(const struct CMUnitTest *tests, size_t count, int (*setup)(void **),
                           int (*teardown)(void **))
{
    void *group = NULL;
    if (setup != NULL)
        bare_must(setup(&group) == 0, "the group's setup", __FILE__, __LINE__);
    for (size_t k = 0; k < count; ++k) {
        void *state = group;
        if (tests[k].setup != NULL)
            bare_must(tests[k].setup(&state) == 0, tests[k].name, __FILE__, __LINE__);
        tests[k].test(&state);
    }
    return teardown != NULL ? teardown(&group) : 0;
}

#endif
