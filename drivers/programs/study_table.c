/* SPDX-License-Identifier: BSD-3-Clause
 * Prints the tables of vti-study at the terminal: errors and orders of a study, prices of a study of cost. */
#include "study_go.h"

#include <math.h>

#include "number.h"

/* ---- convergence ------------------------------------------------------------------------------------------------ */

/** 1/64 where h is the inverse of a whole number, a decimal number elsewhere. */
void study_print_h(double h, FILE *file)
{
    char text[32];
    const double inverse = rint(1.0 / h);
    if (h < 1.0 && inverse < 1e9 && 1.0 / inverse == h)
        snprintf(text, sizeof text, "1/%.0f", inverse);
    else
        snprintf(text, sizeof text, "%.6g", h);
    fprintf(file, "%9s", text);
}

static double ten_to(int places)
{
    double power = 1.0;
    for (int k = 0; k < places; ++k)
        power *= 10.0;
    return power;
}

/** An interval in units of its last decimal, rounded up; what was rounded to a digit already stays. */
static double units(double interval, int places)
{
    return ceil((1.0 - 1e-9) * interval * ten_to(places));
}

void study_print_order(double order, double interval, FILE *file)
{
    enum { PLACES = 5, LARGEST = 9 };
    char text[64] = "-";
    int places = 0;
    while (places < PLACES && units(interval, places + 1) <= LARGEST)
        ++places;
    const double shown = fabs(order) * ten_to(places) > 0.5 ? order : 0.0; /* never -0 */
    if (!isnan(order) && isfinite(interval))
        snprintf(text, sizeof text, "%.*f +- %.*f", places, shown, places,
                 fmax(1.0, units(interval, places)) / ten_to(places));
    else if (!isnan(order))
        snprintf(text, sizeof text, "%.2f", order);
    fprintf(file, "  %18s", text);
}

/** How many runs can be believed, and what is said against the others; why runs failed stands in their rows. */
static void write_verdicts(const struct study *study, FILE *file)
{
    int64_t count[VERDICT_BAD + 1] = {0}, failed = 0;
    fputc('\n', file);
    for (int64_t r = 0; r < study->runs; ++r) {
        const struct outcome *o = &study->outcomes[r];
        failed += o->failed;
        count[o->judgement.verdict] += !o->failed;
        if (o->failed || o->judgement.verdict == VERDICT_GOOD)
            continue;
        fprintf(file, "%s at h =", study->trials[r].stepper->name);
        study_print_h(study->trials[r].h, file);
        fprintf(file, ": %s\n", o->verdict.text);
    }
    fprintf(file, "verdict: of %lld runs %lld are good, %lld doubtful, %lld bad", (long long)study->runs,
            (long long)count[VERDICT_GOOD], (long long)count[VERDICT_DOUBTFUL], (long long)count[VERDICT_BAD]);
    if (failed > 0)
        fprintf(file, ", and %lld failed", (long long)failed);
    fputc('\n', file);
}

/** What an order lacks. By a tolerance errors follow that, and the steps that are compared say nothing of them. */
static void write_why_no_order(const struct study *study, FILE *file)
{
    enum { FEWEST = 3 };
    const struct plan *plan = study->plan;
    int lacking = 0;
    for (int64_t k = 0; k < plan->steppers_count * STUDY_MEASURES; ++k)
        lacking |= isnan(study->orders[k / STUDY_MEASURES][k % STUDY_MEASURES].order) != 0;
    if (plan->scene->tolerance > 0.0)
        fprintf(file, "- steps go by the tolerance, not by h: there is no order of h; compare several tolerances\n");
    else if (lacking && plan->h_count < FEWEST)
        fprintf(file, "- no order: that takes three steps at the least; name more, such as --h %s:%s\n",
                NUMBER(plan->h[0]), NUMBER(0.25 * plan->h[0]));
    else if (lacking)
        fprintf(file,
                "- no order: fewer than three errors above rounding and above what the solution is known to (%.0e)\n",
                study->reference_uncertainty);
}

void study_table_write(const struct study *study, FILE *file)
{
    const struct plan *plan = study->plan;
    const int width = methods_width(plan->steppers, plan->steppers_count);
    fprintf(file, "%-*s %9s %9s  %10s %10s %10s %10s %10s\n", width, "stepper", "h", "steps", "E-error", "q-error",
            "H1-error", "attitude", "momentum");
    for (int64_t r = 0; r < study->runs; ++r) {
        const struct outcome *o = &study->outcomes[r];
        fprintf(file, "%-*s ", width, study->trials[r].stepper->name);
        study_print_h(study->trials[r].h, file);
        fprintf(file, " %9lld  ", (long long)o->steps);
        if (o->failed)
            fprintf(file, "failed: %s\n", o->message.text);
        else
            fprintf(file, "%10.3e %10.3e %10.3e %10.3e %10.2e\n", number_plain(o->error[E_ERROR]),
                    number_plain(o->error[Q_ERROR]), number_plain(o->error[H1_ERROR]),
                    number_plain(o->error[ATTITUDE_ERROR]), number_plain(o->error[MOMENTUM_ERROR]));
    }
    write_verdicts(study, file);
    fprintf(file, "\n%-*s  %18s  %18s  %18s  %18s\n", width, "fitted order", "E-error", "q-error", "H1-error",
            "attitude");
    for (int64_t s = 0; s < plan->steppers_count; ++s) {
        fprintf(file, "%-*s", width, plan->steppers[s]->name);
        for (int m = 0; m < STUDY_MEASURES; ++m)
            study_print_order(study->orders[s][m].order, study->orders[s][m].interval, file);
        fputc('\n', file);
    }
    write_why_no_order(study, file);
}

/* ---- cost ------------------------------------------------------------------------------------------------------- */

enum { NAME = 18, CELL = 9, SORTED_BY = 4 /* 1e-6 */ };

static const struct cost_price *prices_of(const struct cost *cost, int64_t c, int64_t m)
{
    return cost->prices[c * cost->plan->methods_count + m][cost->facts[c].main];
}

/** 1 if method a comes before b: by its time to 1e-6; among those that do not get there by the time to 1e-5, and so
 *  on. */
static int is_before(const struct cost *cost, int64_t c, int64_t a, int64_t b)
{
    for (int e = SORTED_BY; e >= 0; --e) {
        const double x = prices_of(cost, c, a)[e].seconds, y = prices_of(cost, c, b)[e].seconds;
        if (isnan(x) != isnan(y))
            return isnan(y);
        if (!isnan(x))
            return x < y;
    }
    return 0;
}

static void sort(const struct cost *cost, int64_t c, int64_t order[COST_METHODS])
{
    for (int64_t m = 0; m < cost->plan->methods_count; ++m) {
        int64_t k = m;
        for (; k > 0 && is_before(cost, c, m, order[k - 1]); --k)
            order[k] = order[k - 1];
        order[k] = m;
    }
}

/** A number of three digits with a letter for its thousands: 12.3 k. */
static void print_short(double value, const char *const units[], int units_count, FILE *file)
{
    char text[32];
    int u = 0;
    for (; u + 1 < units_count && value >= 999.5; ++u)
        value /= 1000.0;
    snprintf(text, sizeof text, "%.3g%s", value, units[u]);
    fprintf(file, "%*s", CELL, text);
}

static void print_seconds(double seconds, FILE *file)
{
    static const char *const units[] = {" us", " ms", " s"};
    print_short(1e6 * seconds, units, 3, file);
}

static void print_evals(double evals, FILE *file)
{
    static const char *const units[] = {"", " k", " M", " G"};
    print_short(evals, units, 4, file);
}

/** Rows methods, columns errors. */
static void write_block(const struct cost *cost, int64_t c, const int64_t *order, const char *title,
                        void (*print)(double, FILE *), int seconds, FILE *file)
{
    fprintf(file, "%-*s %-5s ", NAME, title, "");
    for (int e = 0; e < COST_TARGETS; ++e)
        fprintf(file, "%*.0e", CELL, cost_targets[e]);
    fputc('\n', file);
    for (int64_t k = 0; k < cost->plan->methods_count; ++k) {
        const vti_stepper *method = cost->plan->methods[order[k]];
        fprintf(file, "%-*s %-5s ", NAME, method->name, method_kind(method));
        for (int e = 0; e < COST_TARGETS; ++e) {
            const struct cost_price *price = &prices_of(cost, c, order[k])[e];
            if (isnan(price->force_evals))
                fprintf(file, "%*s", CELL, "-");
            else
                print(seconds ? price->seconds : price->force_evals, file);
        }
        fputc('\n', file);
    }
}

static void write_factors(const struct cost *cost, int64_t c, const int64_t *order, FILE *file)
{
    for (int64_t k = 0; k < cost->plan->methods_count; ++k) {
        const struct cost_price factor = cost_price_factor(prices_of(cost, c, order[k]));
        if (!isnan(factor.seconds))
            fprintf(file, "%s: a factor of ten in accuracy costs %.2f times the time and %.2f times the evaluations\n",
                    cost->plan->methods[order[k]]->name, factor.seconds, factor.force_evals);
    }
}

static void write_failures(const struct cost *cost, int64_t c, FILE *file)
{
    for (int64_t m = 0; m < cost->plan->methods_count; ++m) {
        const struct cost_ladder *ladder = &cost->ladders[c * cost->plan->methods_count + m];
        if (ladder->failures > 0)
            fprintf(file, "left out: %lld run%s of %s that failed, the last one: %s\n", (long long)ladder->failures,
                    ladder->failures > 1 ? "s" : "", cost->plan->methods[m]->name, ladder->failure.text);
        else if (ladder->count == 0)
            fprintf(file, "left out: %s, which has no run with an error below 1; allow more with --evals\n",
                    cost->plan->methods[m]->name);
    }
}

/** The least error of any run: what two solutions that have nothing in common but the forces differ by. */
static double nearest(const struct cost *cost, int64_t c)
{
    double least = INFINITY;
    for (int64_t m = 0; m < cost->plan->methods_count; ++m) {
        const struct cost_ladder *ladder = &cost->ladders[c * cost->plan->methods_count + m];
        for (int64_t r = 0; r < ladder->count; ++r)
            least = fmin(least, cost_error(&ladder->runs[r], cost->facts[c].main));
    }
    return least;
}

void study_table_write_cost(const struct cost *cost, FILE *file)
{
    for (int64_t c = 0; c < cost->plan->cases_count; ++c) {
        int64_t order[COST_METHODS];
        const struct cost_facts *facts = &cost->facts[c];
        sort(cost, c, order);
        fprintf(file, "== %s: what an error of %s at t = %.10g costs\n", cost->plan->cases[c].name,
                facts->main == COST_ATTITUDE ? "the attitudes, radians," : "the velocities, relative,",
                cost->plan->cases[c].t_end);
        fprintf(file,
                "reference: rk8pd, by its own estimate good to %.0e; the nearest run of any method is %.0e off\n\n",
                facts->uncertainty, nearest(cost, c));
        write_block(cost, c, order, "time", print_seconds, 1, file);
        fputc('\n', file);
        write_block(cost, c, order, "evaluations", print_evals, 0, file);
        fputc('\n', file);
        write_factors(cost, c, order, file);
        write_failures(cost, c, file);
        if (cost->plan->h_count > 0)
            fprintf(file, "steps are those of --h alone: what the longest of them reaches may cost less\n");
        fputc('\n', file);
    }
}
