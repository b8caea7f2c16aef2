/* SPDX-License-Identifier: BSD-3-Clause
 *
 * /scenes, /steppers, /measures: texts, which stepper, scene and measure below are numbers of, from 0. /sweep/KEY
 * [values]: what a key goes through, numbers if all are, else texts; the first is the ensemble (attribute of the
 * root). /points [points]: scene; the number of the value of each KEY; energy0, norm_squared and the reference's
 * errors. /runs [runs]: point, stepper, h, and what study.csv has; failed = 1: errors are NaN. /failures [failed
 * runs]: run and the reason. /orders [points x steppers x measures]: point, stepper, measure, and the fit. /ensemble
 * [groups x steppers x steps]: over the values of the first key at each value of the others and in each scene; point
 * is the first of the group, runs how many did not fail, infinite how many of these have an error that is not
 * finite, and leave an infinite mean; mean and spread (standard deviation) of each error.
 * /ensemble_orders [groups x steppers x measures]: the same of fitted orders. */
#include "study_files.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "hdf5_sink.h"
#include "number.h"

enum { NAME = 64, MEASURES = STUDY_MEASURES, COLUMNS_MOST = 32 };

/* ---- rows and their columns -------------------------------------------------------------------------------------- */

struct run_row {
    int64_t point, stepper;
    double h;
    struct survey_run run;
};

struct failure_row {
    int64_t run;
    char reason[SURVEY_REASON];
};

struct point_row {
    int64_t scene, value[SWEEP_AXES];
    struct survey_facts facts;
};

struct order_row {
    int64_t point, stepper, measure;
    struct order order;
};

struct mean_row {
    int64_t point, stepper;
    double h;
    int64_t runs, failed, infinite;
    double value[2 * OUTCOME_ERRORS]; /* mean and spread of each error */
};

struct mean_order_row {
    int64_t point, stepper, measure, fits;
    double mean_order, spread_order;
};

struct columns_of {
    struct hdf5_column column[COLUMNS_MOST];
    char name[2 * OUTCOME_ERRORS][NAME]; /* that are made here */
    int count;
};

static void add(struct columns_of *all, const char *name, size_t offset, int is_integer)
{
    all->column[all->count++] = (struct hdf5_column){name, offset, is_integer, 0};
}

#define WHOLE(STRUCT, NAME) add(&c, #NAME, offsetof(struct STRUCT, NAME), 1)
#define REAL(STRUCT, NAME) add(&c, #NAME, offsetof(struct STRUCT, NAME), 0)
/** A member of a member. */
#define INNER(STRUCT, MEMBER, NAME, IS_INTEGER) add(&c, #NAME, offsetof(struct STRUCT, MEMBER.NAME), IS_INTEGER)

static struct columns_of run_columns(void)
{
    struct columns_of c = {.count = 0};
    WHOLE(run_row, point);
    WHOLE(run_row, stepper);
    REAL(run_row, h);
    INNER(run_row, run, t_end, 0);
    INNER(run_row, run, steps, 1);
    INNER(run_row, run, force_evals, 1);
    for (int m = 0; m < OUTCOME_ERRORS; ++m)
        add(&c, outcome_errors[m], offsetof(struct run_row, run.error) + (size_t)m * sizeof(double), 0);
    INNER(run_row, run, failed, 1);
    for (int k = 0; k < VERDICT_NUMBERS; ++k)
        add(&c, verdict_numbers[k].name, offsetof(struct run_row, run.judgement) + verdict_numbers[k].offset,
            verdict_numbers[k].is_integer);
    return c;
}

static struct columns_of point_columns(const struct sweep *sweep)
{
    struct columns_of c = {.count = 0};
    WHOLE(point_row, scene);
    INNER(point_row, facts, energy0, 0);
    INNER(point_row, facts, norm_squared, 0);
    INNER(point_row, facts, reference_energy_error, 0);
    INNER(point_row, facts, reference_uncertainty, 0);
    for (int k = 0; k < sweep->count; ++k)
        add(&c, sweep->axis[k].key, offsetof(struct point_row, value) + (size_t)k * sizeof(int64_t), 1);
    return c;
}

static struct columns_of order_columns(void)
{
    struct columns_of c = {.count = 0};
    WHOLE(order_row, point);
    WHOLE(order_row, stepper);
    WHOLE(order_row, measure);
    INNER(order_row, order, order, 0);
    INNER(order_row, order, interval, 0);
    INNER(order_row, order, h_min, 0);
    INNER(order_row, order, h_max, 0);
    INNER(order_row, order, points, 1);
    INNER(order_row, order, log2_constant, 0);
    return c;
}

/** Names are made in *c. */
static void mean_columns(struct columns_of *all)
{
    struct columns_of c = {.count = 0};
    WHOLE(mean_row, point);
    WHOLE(mean_row, stepper);
    REAL(mean_row, h);
    WHOLE(mean_row, runs);
    WHOLE(mean_row, failed);
    WHOLE(mean_row, infinite);
    *all = c;
    for (int m = 0; m < 2 * OUTCOME_ERRORS; ++m) {
        snprintf(all->name[m], NAME, "%s_%s", m % 2 == 0 ? "mean" : "spread", outcome_errors[m / 2]);
        add(all, all->name[m], offsetof(struct mean_row, value) + (size_t)m * sizeof(double), 0);
    }
}

static struct columns_of mean_order_columns(void)
{
    struct columns_of c = {.count = 0};
    WHOLE(mean_order_row, point);
    WHOLE(mean_order_row, stepper);
    WHOLE(mean_order_row, measure);
    WHOLE(mean_order_row, fits);
    REAL(mean_order_row, mean_order);
    REAL(mean_order_row, spread_order);
    return c;
}

static struct columns_of failure_columns(void)
{
    struct columns_of c = {.count = 0};
    WHOLE(failure_row, run);
    REAL(failure_row, reason);
    c.column[1].text = SURVEY_REASON;
    return c;
}

/* ---- tables ------------------------------------------------------------------------------------------------------ */

struct writer {
    const struct survey_plan *plan;
    struct hdf5_table runs, failures, points, orders, means, mean_orders;
    struct survey_group group;
    int64_t run; /* the next */
};

static void write_runs(struct writer *w, int64_t p, const struct plan *plan, const struct survey_point *point)
{
    for (int64_t r = 0; r < plan->steppers_count * plan->h_count; ++r, ++w->run) {
        const struct run_row row = {p, r / plan->h_count, plan->h[r % plan->h_count], point->run[r]};
        struct failure_row failure = {w->run, ""};
        hdf5_table_add(&w->runs, &row);
        memcpy(failure.reason, row.run.reason, sizeof failure.reason);
        if (row.run.failed)
            hdf5_table_add(&w->failures, &failure);
    }
}

static void write_orders(struct writer *w, int64_t p, const struct plan *plan, const struct survey_point *point)
{
    for (int64_t s = 0; s < plan->steppers_count; ++s)
        for (int m = 0; m < MEASURES; ++m) {
            const struct order_row row = {p, s, m, survey_order(plan, point, s, m)};
            hdf5_table_add(&w->orders, &row);
        }
}

static void write_group(struct writer *w, const struct plan *plan)
{
    const struct survey_group *g = &w->group;
    for (int64_t r = 0; r < plan->steppers_count * plan->h_count; ++r) {
        const struct ensemble *e = g->error[r];
        struct mean_row row = {
            g->first, r / plan->h_count, plan->h[r % plan->h_count], g->runs[r], g->failed[r], g->infinite[r], {0.0}};
        for (int m = 0; m < OUTCOME_ERRORS; ++m) {
            row.value[2 * m] = ensemble_mean(&e[m]);
            row.value[2 * m + 1] = ensemble_spread(&e[m]);
        }
        hdf5_table_add(&w->means, &row);
    }
    for (int64_t s = 0; s < plan->steppers_count; ++s)
        for (int m = 0; m < MEASURES; ++m) {
            const struct ensemble *e = &g->order[s][m];
            const struct mean_order_row row = {g->first, s, m, e->count, ensemble_mean(e), ensemble_spread(e)};
            hdf5_table_add(&w->mean_orders, &row);
        }
}

static int write_point(void *self, int64_t p, int rank, const struct survey_point *point)
{
    struct writer *w = self;
    const struct plan *plan = survey_plan_of(w->plan, p);
    struct point_row row = {survey_scene(w->plan, p), {0}, point->facts};
    (void)rank;
    for (int k = 0; k < w->plan->sweep->count; ++k)
        row.value[k] = sweep_index(w->plan->sweep, p % sweep_points(w->plan->sweep), k);
    hdf5_table_add(&w->points, &row);
    write_runs(w, p, plan, point);
    write_orders(w, p, plan, point);
    if (survey_group_add(w->plan, &w->group, p, point))
        write_group(w, plan);
    return 0;
}

/** Rows of all scenes, from rows of each of their steppers and so many points or groups. */
static int64_t rows_of(const struct survey_plan *plan, int64_t each, int with_steps)
{
    int64_t n = 0;
    for (int k = 0; k < plan->scenes_count; ++k)
        n += each * plan->each[k].steppers_count * (with_steps ? plan->each[k].h_count : MEASURES);
    return n;
}

static struct hdf5_table begin(struct hdf5_sink *file, const char *name, const struct columns_of *columns, size_t size,
                               int64_t rows)
{
    return hdf5_table_begin(file, name, columns->column, columns->count, size, rows);
}

static int write_tables(const struct survey *survey, struct hdf5_sink *file, int64_t failed, struct message *message)
{
    static struct writer w;
    const struct survey_plan *plan = survey->plan;
    const int64_t groups = survey_groups(plan) / plan->scenes_count, places = sweep_points(plan->sweep);
    const struct columns_of points = point_columns(plan->sweep), runs = run_columns(), failures = failure_columns(),
                            orders = order_columns(), mean_orders = mean_order_columns();
    struct columns_of means;
    mean_columns(&means);
    memset(&w, 0, sizeof w);
    w.plan = plan;
    w.points = begin(file, "points", &points, sizeof(struct point_row), survey->points);
    w.runs = begin(file, "runs", &runs, sizeof(struct run_row), survey->runs);
    w.failures = begin(file, "failures", &failures, sizeof(struct failure_row), failed);
    w.orders = begin(file, "orders", &orders, sizeof(struct order_row), rows_of(plan, places, 0));
    w.means = begin(file, "ensemble", &means, sizeof(struct mean_row), rows_of(plan, groups, 1));
    w.mean_orders =
        begin(file, "ensemble_orders", &mean_orders, sizeof(struct mean_order_row), rows_of(plan, groups, 0));
    const int unread = survey_each(survey, write_point, &w, message);
    struct hdf5_table *const tables[] = {&w.points, &w.runs, &w.failures, &w.orders, &w.means, &w.mean_orders};
    for (size_t k = 0; k < sizeof tables / sizeof tables[0]; ++k)
        hdf5_table_end(file, tables[k]);
    return unread;
}

/* ---- lists ------------------------------------------------------------------------------------------------------- */

static const char *scene_at(const void *plan, int64_t k)
{
    return ((const struct survey_plan *)plan)->first[k].name;
}

static const char *stepper_at(const void *plan, int64_t k)
{
    return ((const struct survey_plan *)plan)->each[0].steppers[k]->name;
}

static const char *measure_at(const void *plan, int64_t k)
{
    (void)plan;
    return outcome_errors[k];
}

struct value_row {
    double number;
    char text[NAME];
};

static struct value_row value_of(const struct sweep_axis *axis, int64_t k)
{
    char text[SWEEP_VALUE];
    struct value_row row = {NAN, ""};
    sweep_value(axis, k, text, sizeof text);
    snprintf(row.text, sizeof row.text, "%.*s", NAME - 1, text);
    if (number_read(text, &row.number) != 0)
        row.number = NAN;
    return row;
}

/** The values of all axes; as numbers if that is what all of an axis are. */
static void write_sweep(struct hdf5_sink *file, const struct sweep *sweep)
{
    struct hdf5_sink group = hdf5_group(file, "sweep");
    for (int k = 0; k < sweep->count; ++k) {
        const struct sweep_axis *axis = &sweep->axis[k];
        int64_t numbers = 0;
        for (int64_t v = 0; v < axis->count; ++v)
            numbers += !isnan(value_of(axis, v).number);
        const struct hdf5_column number = {"value", offsetof(struct value_row, number), 0, 0},
                                 text = {"value", offsetof(struct value_row, text), 0, NAME};
        struct hdf5_table table = hdf5_table_begin(&group, axis->key, numbers == axis->count ? &number : &text, 1,
                                                   sizeof(struct value_row), axis->count);
        for (int64_t v = 0; v < axis->count; ++v) {
            const struct value_row row = value_of(axis, v);
            hdf5_table_add(&table, &row);
        }
        hdf5_table_end(&group, &table);
    }
    hdf5_close(file, &group);
}

/* ---- the file ---------------------------------------------------------------------------------------------------- */

int survey_hdf5_write(const struct survey *survey, const char *path, int64_t failed, struct message *message)
{
    hdf5_start();
    struct hdf5_sink file = hdf5_file(path, message);
    if (file.failed)
        return -1;
    hdf5_text(&file, "vti_version", vti_version());
    hdf5_text(&file, "ensemble", survey->plan->sweep->count > 0 ? survey->plan->sweep->axis[0].key : "");
    hdf5_names(&file, "scenes", survey->plan->scenes_count, scene_at, survey->plan);
    hdf5_names(&file, "steppers", survey->plan->each[0].steppers_count, stepper_at, survey->plan);
    hdf5_names(&file, "measures", MEASURES, measure_at, survey->plan);
    write_sweep(&file, survey->plan->sweep);
    const int unread = write_tables(survey, &file, failed, message);
    if (hdf5_close_file(&file) != 0 && unread == 0)
        return message_set(message, "%s: cannot be written; the disk may be full", path);
    return unread;
}
