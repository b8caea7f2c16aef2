/* SPDX-License-Identifier: BSD-3-Clause
 * A study from its plan to its files, on all ranks. */
#ifndef VTI_STUDY_GO_H
#define VTI_STUDY_GO_H

#include <stdio.h>

#include "cost.h"
#include "cost_plan.h"
#include "message.h"
#include "overwrite.h"
#include "survey.h"
#include "tables.h"

/** Where it goes and whether one that was interrupted there goes on. */
struct study_place {
    const char *folder;
    int resume;
    int force; /* replace files that are not ours */
    const struct input *inputs;
    int inputs_count;
    const char *const *pictures; /* that will be drawn of study.h5 there, up to NULL; may be NULL itself */
};

/** Says what will be done, runs the plan, writes its files and says what came out. SIGTERM, SIGINT and their like
 *  end it as soon as what is done is kept. Collective. Returns, on all ranks, 0, 1 if all is written but the verdict
 *  on some run is bad, or when one line has been said about it WATCH_ASKED if it was ended so, or -1 if something
 *  failed. */
int study_go(const struct plan *plan, const struct study_place *place, int rank);
int study_go_survey(const struct survey_plan *plan, const struct study_place *place, int rank);
int study_go_cost(const struct cost_plan *plan, const struct study_place *place, int rank);

/** For people: errors of every run, then the fitted orders. */
void study_table_write(const struct study *study, FILE *file);
/** Mean and spread of errors and orders of the first groups. Returns 0, or -1 with one line in *message. */
int survey_table_write(const struct survey *survey, FILE *file, struct message *message);
/** Nine letters: 1/64 where h is the inverse of a whole number, a decimal number elsewhere. */
void study_print_h(double h, FILE *file);
/** Twenty letters: 1.93 +- 0.02, the interval rounded up to one digit and the order to the same place, of five decimals
 *  at most (as with_interval of drivers/plot/words.py); no interval where it is not known, "-" where there is no
 *  order. */
void study_print_order(double order, double interval, FILE *file);
/** The price list of every case, and what the next digit costs. */
void study_table_write_cost(const struct cost *cost, FILE *file);

/* ---- files beside the programs ----------------------------------------------------------------------------------- */

/* Files that belong to the programs, found relative to the running program: in the build tree as when installed. */

enum { BESIDE_PATH = 4096 };

/** The path of a shipped scene, "pendulum.yaml". Returns 0, or -1 if there is none. */
int beside_scene(const char *name, char path[BESIDE_PATH]);
/** Pictures: runs "vti-plot folder/name" and waits for it. Returns 0, or -1 with one line in *message. */
int beside_draw(const char *folder, const char *name, struct message *message);

/* ---- the scenes of a cost study ---------------------------------------------------------------------------------- */

/* The scenes of a cost study, as they are named on the command line: SCENE.yaml, or SCENE.yaml@10,100 with their
 * ends. */

/** Scenes and what their tables hold. Must not be moved while a plan looks at it. */
struct cost_scenes {
    int count;
    char paths[COST_CASES][SCENE_PATH_SIZE]; /* of the scenes' files */
    struct scene scenes[COST_CASES];
    struct tables tables[COST_CASES];
};

/** Reads n scenes, with the overrides sets, and adds them to the plan; t_end (may be NULL) holds the ends of those
 *  without "@", as --t-end has them. Returns 0, or -1 with one line in *message; cost_scenes_destroy in either case. */
int cost_scenes_read(const char *const *names, int n, const char *const *sets, int sets_count, const char *t_end,
                     struct cost_scenes *scenes, struct cost_plan *plan, struct message *message);
void cost_scenes_destroy(struct cost_scenes *scenes);

/* ---- what a study is --------------------------------------------------------------------------------------------- */

/* What a study is: what its scenes mean, and what it does with them. It goes on with --resume only as the same. */

/** Write the lines "key: value" (identity.h); self is a struct plan, survey_plan or cost_plan. */
void study_identify(FILE *text, const void *self);
void study_identify_survey(FILE *text, const void *self);
void study_identify_cost(FILE *text, const void *self);

#endif
