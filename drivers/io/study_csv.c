/* SPDX-License-Identifier: BSD-3-Clause */
#include "study_files.h"

#include <math.h>
#include <string.h>

#include "number.h"

void study_csv_text(const char *text, FILE *file)
{
    fputc(',', file);
    if (strpbrk(text, ",\"\n") == NULL) {
        fputs(text, file);
        return;
    }
    fputc('"', file);
    for (; *text != '\0'; ++text) {
        if (*text == '"')
            fputc('"', file);
        fputc(*text, file);
    }
    fputc('"', file);
}

/** ",good,0.001,..." */
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
}

void study_csv_header(FILE *file)
{
    fputs("scene,stepper,h,t_end,steps,force_evals", file);
    for (int m = 0; m < OUTCOME_ERRORS; ++m)
        fprintf(file, ",%s", outcome_errors[m]);
    for (int k = 0; k < VERDICT_NUMBERS; ++k)
        fprintf(file, ",%s", verdict_numbers[k].name);
}

void study_csv_row(const char *scene, const struct trial *trial, int64_t force_evals, const double error[],
                   const struct judgement *judgement, FILE *file)
{
    fprintf(file, "%s,%s,%s,%s,%lld,%lld", scene, trial->stepper->name, NUMBER(trial->h), NUMBER(trial->t_end),
            (long long)trial->steps, (long long)force_evals);
    for (int m = 0; m < OUTCOME_ERRORS; ++m)
        fprintf(file, ",%s", NUMBER(error[m]));
    write_judgement(judgement, file);
}

void study_csv_write(const void *what, FILE *file)
{
    const struct study *study = what;
    study_csv_header(file);
    fputs(",failure\n", file);
    for (int64_t r = 0; r < study->runs; ++r) {
        const struct outcome *o = &study->outcomes[r];
        study_csv_row(study->plan->scene->name, &study->trials[r], o->force_evals, o->error, &o->judgement, file);
        study_csv_text(o->failed ? o->message.text : "", file);
        fputc('\n', file);
    }
}

void study_csv_timing_header(FILE *file)
{
    fputs("scene,stepper,h,seconds,ns_per_step,rank", file);
}

void study_csv_timing_row(const char *scene, const struct trial *trial, double seconds, int rank, FILE *file)
{
    fprintf(file, "%s,%s,%s,%.9g,%.6g,%d", scene, trial->stepper->name, NUMBER(trial->h), seconds,
            trial->steps > 0 ? 1e9 * seconds / (double)trial->steps : NAN, rank);
}

void study_csv_timing_write(const void *what, FILE *file)
{
    const struct study *study = what;
    study_csv_timing_header(file);
    fputc('\n', file);
    for (int64_t r = 0; r < study->runs; ++r) {
        study_csv_timing_row(study->plan->scene->name, &study->trials[r], study->outcomes[r].seconds, study->ranks[r],
                             file);
        fputc('\n', file);
    }
}
