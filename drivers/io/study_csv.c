/* SPDX-License-Identifier: BSD-3-Clause */
#include "study_csv.h"

#include <math.h>
#include <string.h>

#include "number.h"

/** ",good,0.001,...\n" */
static void write_judgement(const struct judgement *judgement, FILE *file)
{
    fprintf(file, ",%s", verdict_word(judgement->verdict));
    for (int k = 1; k < VERDICT_NUMBERS; ++k) {
        const char *at = (const char *)judgement + verdict_numbers[k].offset;
        int64_t whole;
        double number;
        memcpy(&whole, at, sizeof whole);
        memcpy(&number, at, sizeof number);
        if (verdict_numbers[k].is_integer)
            fprintf(file, ",%lld", (long long)whole);
        else
            fprintf(file, ",%s", NUMBER(number));
    }
    fputc('\n', file);
}

void study_csv_write(const struct study *study, FILE *file)
{
    fputs("scene,stepper,h,t_end,steps,force_evals,e_error,q_error,h1_error,attitude_error,momentum_error", file);
    for (int k = 0; k < VERDICT_NUMBERS; ++k)
        fprintf(file, ",%s", verdict_numbers[k].name);
    fputc('\n', file);
    for (int64_t r = 0; r < study->runs; ++r) {
        const struct trial *trial = &study->trials[r];
        const struct outcome *o = &study->outcomes[r];
        fprintf(file, "%s,%s,%s,%s,%lld,%lld,%s,%s,%s,%s,%s", study->plan->scene->name, trial->stepper->name,
                NUMBER(trial->h), NUMBER(trial->t_end), (long long)o->steps, (long long)o->force_evals,
                NUMBER(o->e_error), NUMBER(o->q_error), NUMBER(o->h1_error), NUMBER(o->attitude_error),
                NUMBER(o->momentum_error));
        write_judgement(&o->judgement, file);
    }
}

void timing_csv_write(const struct study *study, FILE *file)
{
    fputs("scene,stepper,h,seconds,ns_per_step,rank\n", file);
    for (int64_t r = 0; r < study->runs; ++r) {
        const struct trial *trial = &study->trials[r];
        const double seconds = study->outcomes[r].seconds;
        fprintf(file, "%s,%s,%s,%.9g,%.6g,%d\n", study->plan->scene->name, trial->stepper->name, NUMBER(trial->h),
                seconds, 1e9 * seconds / (double)trial->steps, study->ranks[r]);
    }
}

/** 1/64 where h is the inverse of a whole number, a decimal number elsewhere. */
static void print_h(double h, FILE *file)
{
    char text[32];
    const double inverse = rint(1.0 / h);
    if (h < 1.0 && inverse < 1e9 && 1.0 / inverse == h)
        snprintf(text, sizeof text, "1/%.0f", inverse);
    else
        snprintf(text, sizeof text, "%.6g", h);
    fprintf(file, "%9s", text);
}

static void print_order(const struct order *order, FILE *file)
{
    if (isnan(order->order))
        fprintf(file, "  %18s", "-");
    else
        fprintf(file, "  %8.5f +- %.0e", order->order, order->interval);
}

/** How many runs can be believed, and what is said against each of the others. */
static void write_verdicts(const struct study *study, FILE *file)
{
    int64_t count[VERDICT_BAD + 1] = {0};
    for (int64_t r = 0; r < study->runs; ++r)
        ++count[study->outcomes[r].judgement.verdict];
    fputc('\n', file);
    for (int64_t r = 0; r < study->runs; ++r)
        if (study->outcomes[r].judgement.verdict != VERDICT_GOOD) {
            fprintf(file, "%s at h =", study->trials[r].stepper->name);
            print_h(study->trials[r].h, file);
            fprintf(file, ": %s\n", study->outcomes[r].verdict.text);
        }
    fprintf(file, "verdict: of %lld runs %lld are good, %lld doubtful, %lld bad\n", (long long)study->runs,
            (long long)count[VERDICT_GOOD], (long long)count[VERDICT_DOUBTFUL], (long long)count[VERDICT_BAD]);
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
        print_h(study->trials[r].h, file);
        fprintf(file, " %9lld  %10.3e %10.3e %10.3e %10.3e %10.2e\n", (long long)o->steps, o->e_error, o->q_error,
                o->h1_error, o->attitude_error, o->momentum_error);
    }
    write_verdicts(study, file);
    fprintf(file, "\n%-*s  %18s  %18s  %18s  %18s\n", width, "fitted order", "E-error", "q-error", "H1-error",
            "attitude");
    for (int64_t s = 0; s < plan->steppers_count; ++s) {
        fprintf(file, "%-*s", width, plan->steppers[s]->name);
        for (int m = 0; m < STUDY_MEASURES; ++m)
            print_order(&study->orders[s][m], file);
        fputc('\n', file);
    }
    for (int64_t k = 0; k < plan->steppers_count * STUDY_MEASURES; ++k)
        if (isnan(study->orders[k / STUDY_MEASURES][k % STUDY_MEASURES].order)) {
            fprintf(
                file,
                "- no order: fewer than three errors above rounding and above what the solution is known to (%.0e)\n",
                study->reference_uncertainty);
            return;
        }
}
