/* SPDX-License-Identifier: BSD-3-Clause */
#include "interval.h"

#include <math.h>

/** The best so far; nothing of libm's that a processor's units could round another way decides. */
struct choice {
    int64_t every, steps, about;
    double off; /* ratio, of at least 1, of the number of records and the number that is wanted */
};

/** Takes it if it gives from half to twice the records and comes closer to their number. */
static void offer(struct choice *best, int64_t every)
{
    const double ratio = (double)best->steps / ((double)every * (double)best->about);
    const double off = ratio < 1.0 ? 1.0 / ratio : ratio;
    if (off <= 2.0 && off < best->off) {
        best->off = off;
        best->every = every;
    }
}

/** Steps of h that take the time, 0 if that is no whole number of them. */
static int64_t steps_of(double time, double h)
{
    const double ratio = time / h, whole = rint(ratio);
    return whole >= 1.0 && whole < 0x1p53 && fabs(ratio - whole) <= 1e-12 * whole ? (int64_t)whole : 0;
}

/** The times 1, 2, 2.5 and 5 times a power of ten; if so wanted only those that the run ends with. */
static void offer_round(struct choice *best, double h, int must_end)
{
    static const double digits[] = {10.0, 20.0, 25.0, 50.0};
    double ten = 1.0; /* powers up to 10^22 are exact, and so each time is rounded once */
    for (int p = 0; p <= 20; ++p) {
        for (int k = 0; k < 8; ++k) {
            const int64_t every = steps_of(k < 4 ? digits[k] * ten : digits[k - 4] / (10.0 * ten), h);
            if (every > 0 && (!must_end || best->steps % every == 0))
                offer(best, every);
        }
        ten *= 10.0;
    }
}

static void offer_divisors(struct choice *best)
{
    for (int64_t records = best->about / 2; records <= 2 * best->about; ++records)
        if (records > 0 && best->steps % records == 0)
            offer(best, best->steps / records);
}

int64_t interval_choose(double h, int64_t steps, int64_t about)
{
    struct choice best = {1, steps, about, INFINITY};
    if (steps <= about)
        return 1;
    offer_round(&best, h, 1);
    if (isinf(best.off))
        offer_divisors(&best);
    if (isinf(best.off))
        offer_round(&best, h, 0);
    if (isinf(best.off))
        offer_round(&best, 1.0, 0);
    return best.every;
}

int64_t interval_records(int64_t steps, int64_t every)
{
    return steps / every + 1 + (steps % every != 0);
}

int64_t interval_within(double h, int64_t steps, int64_t about, int64_t most)
{
    for (int64_t wanted = about; wanted > 0; --wanted) {
        const int64_t every = interval_choose(h, steps, wanted);
        if (interval_records(steps, every) <= most)
            return every;
    }
    return steps;
}
