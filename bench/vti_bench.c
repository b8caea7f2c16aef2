/* SPDX-License-Identifier: BSD-3-Clause
 * vti-bench: what a body, a bond and a contact cost on this machine, beside a loop that moves the same bytes. */
#define _POSIX_C_SOURCE 200809L
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "bench.h"
#include "message.h"
#include "number.h"
#include "options.h"

static int64_t most = 1000000, rounds = 15, only;

static const struct option_row rows[] = {
    OPTION_PARAGRAPH(
        "Times steps of n bodies in each layout, n = 8 ... 1e6, loops that move the same bytes, drifts of\n"
        "bodies of three moments, and every effect on lattices. Prints CSV: median and least of rounds, in each of "
        "which every case has its\n"
        "turn. Times of other runs, or of other rounds, say little; ratios within a round do.\n"),
    {"--most", "N", OPTION_WHOLE, &most, 0, 1e8, "1e6", "largest n (default 1e6)"},
    {"--only", "N", OPTION_WHOLE, &only, 0, 1e8, "1000", "this n alone"},
    {"--rounds", "N", OPTION_WHOLE, &rounds, 1, 250, "15",
     "rounds (default 15); up to four times as many until every median is known to 2 %"},
    {0}};

static const struct options options = {"vti-bench", "", "[options]", rows, 0};

enum { MOST_ROUNDS = 1000 };

/** Of one case. */
struct timing {
    int64_t calls; /* in one turn */
    double ns[MOST_ROUNDS];
};

/** Of the processor for this process: what others do in between does not count. */
static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double turn(const struct bench_case *c, int64_t calls)
{
    const double start = seconds();
    for (int64_t k = 0; k < calls; ++k)
        c->call(c->self);
    return seconds() - start;
}

/** As many calls as take a millisecond, which the clock resolves to 1e-4. */
static int64_t calls_of(const struct bench_case *c)
{
    int64_t calls = 1;
    while (turn(c, calls) < 1e-3)
        calls *= 2;
    return calls;
}

/** Half of the times lie between the first and the third quartile, q; the median of r times that scatter as Gauss has
 *  it errs by 0.93 (q3 - q1)/sqrt(r). */
static int is_known(const struct timing *t, int64_t r)
{
    enum { SHARE = 50 };
    double ns[MOST_ROUNDS];
    memcpy(ns, t->ns, (size_t)r * sizeof *ns);
    qsort(ns, (size_t)r, sizeof *ns, number_ascending);
    return 0.93 * (ns[3 * r / 4] - ns[r / 4]) * SHARE <= sqrt((double)r) * ns[r / 2];
}

static void print_row(const struct bench_case *c, int64_t n, int64_t r, struct timing *t)
{
    qsort(t->ns, (size_t)r, sizeof *t->ns, number_ascending);
    printf("%s,%s,%lld,%lld,%.0f,%.5g,%.5g\n", c->what, c->layout, (long long)n, (long long)c->items, c->bytes,
           t->ns[r / 2], t->ns[0]);
    fflush(stdout);
}

/** Nanoseconds per item. What the cases before have thrown out of the caches is fetched first: a shared cache keeps it
 *  after the third pass only. */
static double nanoseconds(const struct bench_case *c, int64_t calls)
{
    turn(c, 3);
    return 1e9 * turn(c, calls) / ((double)calls * (double)c->items);
}

/** Another order of so many cases in each round: a case that follows one on other memory finds less of its own in a
 *  large cache, however often that is fetched first, than one that follows one on its own. */
static void shuffle(int *order, int count, uint64_t *seed)
{
    for (int k = 0; k < count; ++k) {
        const int other = (int)(0.5 * (bench_random(seed) + 1.0) * (k + 1));
        order[k] = order[other];
        order[other] = k;
    }
}

/** Rounds of all cases, and more of them where some median is not known yet: a machine that does other things for a
 *  second would else leave its mark on the sizes that take less. */
static int run(const struct bench_case *cases, int count, int64_t n)
{
    enum { MORE = 4 };
    struct timing *t = calloc((size_t)count, sizeof *t);
    if (t == NULL)
        return -1;
    for (int k = 0; k < count; ++k)
        t[k].calls = calls_of(&cases[k]);
    int order[BENCH_CASES];
    uint64_t seed = 1;
    int64_t done = 0;
    for (int known = 0; done < rounds || (!known && done < MORE * rounds);) {
        shuffle(order, count, &seed);
        for (int k = 0; k < count; ++k)
            t[order[k]].ns[done] = nanoseconds(&cases[order[k]], t[order[k]].calls);
        ++done;
        known = 1;
        for (int k = 0; k < count && known && done >= rounds; ++k)
            known = is_known(&t[k], done);
    }
    for (int k = 0; k < count; ++k)
        print_row(&cases[k], n, done, &t[k]);
    free(t);
    return 0;
}

static int bench_bodies(int64_t n)
{
    struct bench_bodies of[BENCH_LAYOUTS];
    struct bench_case cases[BENCH_CASES];
    int count = 0, made = 0, result = 0;
    for (; made < BENCH_LAYOUTS && result == 0; ++made) {
        result = bench_bodies_make(&of[made], (enum bench_layout)made, n);
        count = result == 0 ? bench_bodies_cases(&of[made], cases, count) : count;
    }
    if (result == 0)
        result = run(cases, bench_peak_cases(cases, count), n);
    for (int k = 0; k < made; ++k)
        bench_bodies_free(&of[k]);
    return result;
}

static int bench_tops(int64_t n)
{
    struct bench_tops tops;
    struct bench_case cases[BENCH_CASES];
    int result = bench_tops_make(&tops, n);
    if (result == 0)
        result = run(cases, bench_tops_cases(&tops, cases, 0), n);
    bench_tops_free(&tops);
    return result;
}

static int bench_lattice(int64_t n)
{
    struct bench_lattice lattice;
    struct bench_case cases[BENCH_CASES];
    const int64_t side = (int64_t)floor(cbrt((double)n) + 0.5);
    int result = bench_lattice_make(&lattice, side);
    if (result == 0)
        result = run(cases, bench_lattice_cases(&lattice, cases, 0), lattice.of.n);
    bench_lattice_free(&lattice);
    return result;
}

static int bench(int64_t n, struct message *message)
{
    if (bench_bodies(n) != 0 || bench_tops(n) != 0 || bench_lattice(n) != 0)
        return message_set(message, "no memory for %lld bodies; choose a smaller --most", (long long)n);
    return 0;
}

int main(int argc, char **argv)
{
    static const int64_t sizes[] = {8, 64, 512, 1000, 8000, 97336, 1000000, 8000000, 97336000}; /* cubes */
    struct message message = {""};
    const char *const *none;
    int count, result = 0;
    const enum options_end asked = options_read(&options, argc, argv, 1, &none, &count, &message);
    if (asked == OPTIONS_GO) {
        printf("what,layout,n,items,bytes,median_ns,least_ns\n");
        for (size_t k = 0; k < sizeof sizes / sizeof *sizes && only == 0 && result == 0; ++k)
            if (sizes[k] <= most)
                result = bench(sizes[k], &message);
        if (only > 0)
            result = bench(only, &message);
    }
    if (asked != OPTIONS_WRONG && result == 0)
        result = options_output_end(&message);
    if (message.text[0] != '\0')
        fprintf(stderr, "vti-bench: %s\n", message.text);
    return asked == OPTIONS_WRONG || result != 0;
}
