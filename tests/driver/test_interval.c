/* SPDX-License-Identifier: BSD-3-Clause
 * How often a run is recorded: at times that people like, evenly to the end, about as often as wanted. */
#include "support.h"

#include "interval.h"
#include "loop.h"

/** The time between records in print: few digits. */
static int digits_of(double time)
{
    char text[40];
    int digits = 0, zeros = 0;
    snprintf(text, sizeof text, "%.12e", time);
    for (const char *p = text; *p != 'e'; ++p)
        if (*p >= '0' && *p <= '9') {
            zeros = *p == '0' ? zeros + 1 : 0;
            ++digits;
        }
    return digits - zeros;
}

/** By hand: a run to t_end by steps of h, wanted records, and the time between them. */
TEST(known_ones)
{
    static const struct {
        double h, t_end, time;
        int64_t about;
    } known[] = {
        {1e-3, 35.0, 0.25, 100},                                /* the torus: 140 */
        {1e-3, 5.0, 0.05, 100},                                 /* 5000 steps, where it was every 51st */
        {1e-3, 5.0, 0.005, 1000},                               /* and its rows */
        {1e-3, 10.0, 0.1, 100},       {1e-2, 10.0, 0.01, 1000}, /* every step */
        {0.1, 10.0, 0.1, 100},        {1e-3, 0.05, 1e-3, 100},  /* fewer steps than that */
        {1e-6, 1.0, 0.01, 100},       {2.5e-4, 20.0, 0.2, 100},
        {1.0 / 64, 10.0, 0.125, 100}, /* 640 steps: 8 of them, 80 records; 0.25 would be 40 */
        {1.0 / 3000, 1.0, 0.01, 100}, /* 30 steps, though h is no decimal number */
        {1e-3, 9.973, 0.1, 100},      /* a prime number of steps: not all is even, the time is */
    };
    for (size_t k = 0; k < sizeof known / sizeof known[0]; ++k) {
        const double h = known[k].h;
        const int64_t every = interval_choose(h, loop_steps(known[k].t_end, h), known[k].about);
        if (every != llrint(known[k].time / h))
            fail_msg("h = %g to %g, %d records: every %g", h, known[k].t_end, (int)known[k].about, (double)every * h);
    }
}

/** For any run: from half to twice the records; where steps allow it they end with the run or have round times. */
TEST(any_run)
{
    rng g = rng_seed(3);
    for (int k = 0; k < 20000; ++k) {
        const int64_t about = k % 2 == 0 ? 100 : 1000;
        const int64_t steps = 1 + (int64_t)(rng_bits(&g) >> (24 + rng_bits(&g) % 40));
        const double h = k % 3 == 0 ? (double)(1 + rng_bits(&g) % 9) * pow(10.0, -(double)(rng_bits(&g) % 6))
                                    : 1.0 / (double)(1 + rng_bits(&g) % 5000);
        const int64_t every = interval_choose(h, steps, about), records = steps / every;
        if (steps <= about) {
            assert_int_equal(every, 1);
            continue;
        }
        if (records < about / 2 || records > 2 * about)
            fail_msg("%lld steps, about %lld records: every %lld", (long long)steps, (long long)about,
                     (long long)every);
        if (steps % every != 0 && digits_of((double)every * h) > 2)
            assert_true(every == 1 || digits_of((double)every) <= 2);
    }
}

/** No more records than are allowed, the start and the end among them; at least a quarter of them, as a choice is from
 *  half to twice of what is tried, and that goes down until it fits; else as without a limit. */
TEST(limited)
{
    assert_int_equal(interval_records(10, 5), 3);
    assert_int_equal(interval_records(11, 5), 4);
    assert_int_equal(interval_within(1e-3, 5000, 100, 1000), interval_choose(1e-3, 5000, 100));
    assert_int_equal(interval_within(1e-3, 5000, 100, 11), 500); /* every 0.5 */
    assert_int_equal(interval_within(1e-3, 5000, 100, 10), 1000);
    assert_int_equal(interval_within(1e-3, 5, 100, 5), 5); /* evenly to the end */
    for (int64_t most = 2; most < 102; ++most)
        for (int64_t steps = 1; steps < 3000; steps += 1 + steps / 7) {
            const int64_t every = interval_within(1e-3, steps, 100, most), records = interval_records(steps, every);
            if (records > most || every > steps || (records < most / 4 && records <= steps / 2))
                fail_msg("%lld steps, at most %lld records: %lld", (long long)steps, (long long)most,
                         (long long)records);
        }
    assert_int_equal(interval_within(1e-3, 7, 100, 1), 7);
}

RUN_TESTS(cmocka_unit_test(limited), cmocka_unit_test(known_ones), cmocka_unit_test(any_run))
