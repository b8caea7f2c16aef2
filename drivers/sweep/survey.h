/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A survey: studies of the same kind at all points of scenes and a sweep. Point by point a rank makes the reference and
 * all runs; what it found goes into the store and is read back in order when files are written, so that memory does not
 * grow with the number of points. Bits depend on the point only. */
#ifndef VTI_SURVEY_H
#define VTI_SURVEY_H

#include "ensemble.h"
#include "store.h"
#include "study.h"
#include "sweep.h"
#include "tables.h"

enum { SURVEY_SCENES = 32, SURVEY_REASON = 240 };

/** A table when it was first read. */
struct survey_table {
    char path[SCENE_PATH_SIZE];
    int kind; /* its number among those of a scene */
    uint64_t digest;
};

/** What the files held as they were first read. Zeros: none has been. To the end of the program. */
struct survey_files {
    struct scene_text scene[SURVEY_SCENES];
    struct survey_table *tables; /* [tables_count] in the order of reading, which survey_check does */
    int64_t tables_count;
};

/** What is asked for. */
struct survey_plan {
    const char *const *scenes; /* [scenes_count]: paths */
    int scenes_count;
    const struct scene *first; /* [scenes_count]: at their first points, with their tables */
    const char *const *sets;   /* overrides of all */
    int sets_count;
    const struct sweep *sweep;
    struct plan each[SURVEY_SCENES]; /* of each scene, that at its first point; t_end = 0: the scene's own */
    struct survey_files *files;
    int (*read_tables)(struct scene *scene, struct tables *tables, struct message *message); /* io/table_hdf5.h */
};

/** A run as it is kept. Flat. */
struct survey_run {
    int64_t failed, steps, force_evals;
    double t_end;
    double error[OUTCOME_ERRORS]; /* NaN of a failed run */
    double seconds;
    struct judgement judgement;
    char reason[SURVEY_REASON]; /* of a failed run: its own, its reference's or its scene's */
};

/** What a point has besides its runs; NaN if it failed. */
struct survey_facts {
    double energy0, norm_squared, reference_energy_error, reference_uncertainty;
};

/** A point as it is kept. Flat. */
struct survey_point {
    struct survey_facts facts;
    int64_t ends_all;        /* not kept: the survey ends for the reason of the first run */
    struct survey_run run[]; /* stepper r / h_count at h r % h_count */
};

/** What came out, on rank 0. */
struct survey {
    const struct survey_plan *plan;
    const struct store *store;
    int64_t points, runs; /* of all scenes */
    double seconds;
};

/** The plan of the scene that point p is of. Points of one scene follow each other. */
const struct plan *survey_plan_of(const struct survey_plan *plan, int64_t p);
int survey_scene(const struct survey_plan *plan, int64_t p);
/** Value of an axis at point p, cut off at size. Returns out. */
char *survey_value(const struct survey_plan *plan, int64_t p, int axis, char *out, size_t size);
/** How many there are of all scenes. */
int64_t survey_points(const struct survey_plan *plan);
int64_t survey_runs(const struct survey_plan *plan);
int64_t survey_groups(const struct survey_plan *plan);
/** Of a struct survey_point with as many runs as a point has at most. */
int64_t survey_bytes(const struct survey_plan *plan);

/* ---- scenes at their points -------------------------------------------------------------------------------------- */

enum { SURVEY_CHANGED = -2 };

/** Reads scene k at a place of the sweep; tables_destroy(tables) is due. Returns 0, or with one line in *message -1 if
 *  the scene is refused, or SURVEY_CHANGED if a table is not what it was when it was first read. */
int survey_read(const struct survey_plan *plan, int k, int64_t place, struct scene *scene, struct tables *tables,
                struct message *message);

/** The plan of scene k as it was read so. */
struct plan survey_plan_with(const struct survey_plan *plan, int k, const struct scene *scene);

/** Reads scene k at its first point. Returns 0, or -1 with one line in *message. */
int survey_read_first(const struct survey_plan *plan, int k, struct scene *scene, struct tables *tables,
                      struct message *message);

/** Reads every scene at its first point, and with every end of a range and every value of a list; checks numbers of
 *  runs and steps, and that no two scenes have one name. Returns 0, or -1 with one line in *message. */
int survey_check(const struct survey_plan *plan, struct message *message);

/** Runs all points that the store does not hold on all ranks of comm. Collective. Returns 0, or -1 on all ranks with
 *  one line in *message on rank 0, or WATCH_ASKED. On rank 0 there must be a store, which must outlive *survey. */
int survey_run(const struct survey_plan *plan, MPI_Comm comm, const struct study_watch *watch,
               const struct store *store, struct survey *survey, struct message *message);

/** Calls take for every point in order, with the rank that did it; it returns 0 to go on. Returns 0, or -1 with one
 *  line in *message or if take did not return 0. */
int survey_each(const struct survey *survey,
                int (*take)(void *self, int64_t p, int rank, const struct survey_point *point), void *self,
                struct message *message);

/** The order of a measure that the runs of a stepper show at a point. */
struct order survey_order(const struct plan *plan, const struct survey_point *point, int64_t stepper, int measure);

/* ---- means and spreads ------------------------------------------------------------------------------------------- */

/** Of one scene at one value of each axis but the first, the ensemble. */
struct survey_group {
    int64_t number, first; /* from 0; its first point */
    /* of each run of a point: how many went to their ends, how many did not; of the first those with infinite errors */
    int64_t runs[STUDY_STEPPERS * LADDER_MOST], failed[STUDY_STEPPERS * LADDER_MOST];
    int64_t infinite[STUDY_STEPPERS * LADDER_MOST];
    struct ensemble error[STUDY_STEPPERS * LADDER_MOST][OUTCOME_ERRORS]; /* of each run of a point */
    struct ensemble order[STUDY_STEPPERS][STUDY_MEASURES];
};

/** Takes point p in, after all before it. Returns 1 if it was the last of its group, which is complete until the next
 *  call, else 0. */
int survey_group_add(const struct survey_plan *plan, struct survey_group *group, int64_t p,
                     const struct survey_point *point);

#endif
