/* SPDX-License-Identifier: BSD-3-Clause */
#include "study_files.h"

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
