/* SPDX-License-Identifier: BSD-3-Clause
 * A study from its plan to its files, on all ranks. */
#ifndef VTI_STUDY_GO_H
#define VTI_STUDY_GO_H

#include <stdio.h>

#include "cost.h"
#include "overwrite.h"
#include "survey.h"

/** Where it goes and whether one that was interrupted there goes on. */
struct study_place {
    const char *folder;
    int resume;
    int force; /* replace files that are not ours */
    const struct input *inputs;
    int inputs_count;
};

/** Ends a stage on all ranks: 0 if it went well on all of them; else one line from one of them and -1. Collective. */
int study_agree(int failed, int rank, const struct message *message);

/** Says what will be done, runs the plan, writes its files and says what came out. SIGTERM, SIGINT and their like
 *  end it as soon as what is done is kept. Collective. Returns, on all ranks, 0, 1 if all is written but the verdict
 *  on some run is bad, or when one line has been said about it WATCH_ASKED if it was ended so, or -1 if something
 *  failed. */
int study_go(const struct plan *plan, const struct study_place *place, int rank);
int survey_go(const struct survey_plan *plan, const struct study_place *place, int rank);
int cost_go(const struct cost_plan *plan, const struct study_place *place, int rank);

/** For people: errors of every run, then the fitted orders. */
void study_table_write(const struct study *study, FILE *file);
/** Mean and spread of errors and orders of the first groups. Returns 0, or -1 with one line in *message. */
int survey_table_write(const struct survey *survey, FILE *file, struct message *message);
/** Nine letters: 1/64 where h is the inverse of a whole number, a decimal number elsewhere. */
void study_print_h(double h, FILE *file);
/** The price list of every case, and what the next digit costs. */
void cost_table_write(const struct cost *cost, FILE *file);

#endif
