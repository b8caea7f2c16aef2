/* SPDX-License-Identifier: BSD-3-Clause
 *
 * /scenes, /steppers, /measures: texts, which stepper, scene and measure below are numbers of, from 0. /sweep/KEY
 * [values]: what a key goes through, numbers if all are, else texts; the first is the ensemble (attribute of the
 * root). /points [points]: scene; the number of the value of each KEY; energy0, norm_squared and the reference's
 * errors. /runs [runs]: point, stepper, h, and what study.csv has; failed = 1: errors are NaN. /failures [failed
 * runs]: run and the reason. /orders [points x steppers x measures]: point, stepper, measure, and the fit. /ensemble
 * [groups x steppers x steps]: over the values of the first key at each value of the others and in each scene; point
 * is the first of the group, runs how many went well; mean and spread (standard deviation) of each error.
 * /ensemble_orders [groups x steppers x measures]: the same of fitted orders. */
#include "survey_files.h"

#include <math.h>
#include <string.h>

#include "hdf5_table.h"
#include "number.h"

enum { NAME = 64, MEASURES = STUDY_MEASURES };

#define NUMBER_OF(STRUCT, MEMBER)                                                                                      \
    {                                                                                                                  \
#MEMBER, offsetof(struct STRUCT, MEMBER), 0, 0                                                                 \
    }
#define WHOLE_OF(STRUCT, MEMBER)                                                                                       \
    {                                                                                                                  \
#MEMBER, offsetof(struct STRUCT, MEMBER), 1, 0                                                                 \
    }
#define COUNT(ARRAY) (int)(sizeof(ARRAY) / sizeof(ARRAY)[0])

/* ---- rows -------------------------------------------------------------------------------------------------------- */

struct run_row {
    int64_t point, stepper;
    double h, t_end;
    int64_t steps, force_evals;
    double e_error, q_error, h1_error, attitude_error, momentum_error;
    int64_t failed;
    struct judgement judgement;
};

static const struct hdf5_column run_columns[] = {
    WHOLE_OF(run_row, point),           WHOLE_OF(run_row, stepper),         NUMBER_OF(run_row, h),
    NUMBER_OF(run_row, t_end),          WHOLE_OF(run_row, steps),           WHOLE_OF(run_row, force_evals),
    NUMBER_OF(run_row, e_error),        NUMBER_OF(run_row, q_error),        NUMBER_OF(run_row, h1_error),
    NUMBER_OF(run_row, attitude_error), NUMBER_OF(run_row, momentum_error), WHOLE_OF(run_row, failed)};

struct failure_row {
    int64_t run;
    char reason[SURVEY_REASON];
};

static const struct hdf5_column failure_columns[] = {
    WHOLE_OF(failure_row, run), {"reason", offsetof(struct failure_row, reason), 0, SURVEY_REASON}};

struct point_row {
    int64_t scene, value[SWEEP_AXES];
    double energy0, norm_squared, reference_energy_error, reference_uncertainty;
};

static const struct hdf5_column point_columns[] = {
    WHOLE_OF(point_row, scene), NUMBER_OF(point_row, energy0), NUMBER_OF(point_row, norm_squared),
    NUMBER_OF(point_row, reference_energy_error), NUMBER_OF(point_row, reference_uncertainty)};

struct order_row {
    int64_t point, stepper, measure, points;
    double order, interval, h_min, h_max, log2_constant;
};

static const struct hdf5_column order_columns[] = {
    WHOLE_OF(order_row, point),  WHOLE_OF(order_row, stepper),   WHOLE_OF(order_row, measure),
    NUMBER_OF(order_row, order), NUMBER_OF(order_row, interval), NUMBER_OF(order_row, h_min),
    NUMBER_OF(order_row, h_max), WHOLE_OF(order_row, points),    NUMBER_OF(order_row, log2_constant)};

struct mean_row {
    int64_t point, stepper;
    double h;
    int64_t runs, failed;
    double mean_e_error, spread_e_error, mean_q_error, spread_q_error, mean_h1_error, spread_h1_error,
        mean_attitude_error, spread_attitude_error, mean_momentum_error, spread_momentum_error;
};

static const struct hdf5_column mean_columns[] = {WHOLE_OF(mean_row, point),
                                                  WHOLE_OF(mean_row, stepper),
                                                  NUMBER_OF(mean_row, h),
                                                  WHOLE_OF(mean_row, runs),
                                                  WHOLE_OF(mean_row, failed),
                                                  NUMBER_OF(mean_row, mean_e_error),
                                                  NUMBER_OF(mean_row, spread_e_error),
                                                  NUMBER_OF(mean_row, mean_q_error),
                                                  NUMBER_OF(mean_row, spread_q_error),
                                                  NUMBER_OF(mean_row, mean_h1_error),
                                                  NUMBER_OF(mean_row, spread_h1_error),
                                                  NUMBER_OF(mean_row, mean_attitude_error),
                                                  NUMBER_OF(mean_row, spread_attitude_error),
                                                  NUMBER_OF(mean_row, mean_momentum_error),
                                                  NUMBER_OF(mean_row, spread_momentum_error)};

struct mean_order_row {
    int64_t point, stepper, measure, fits;
    double mean_order, spread_order;
};

static const struct hdf5_column mean_order_columns[] = {
    WHOLE_OF(mean_order_row, point), WHOLE_OF(mean_order_row, stepper),     WHOLE_OF(mean_order_row, measure),
    WHOLE_OF(mean_order_row, fits),  NUMBER_OF(mean_order_row, mean_order), NUMBER_OF(mean_order_row, spread_order)};

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
        const struct survey_run *run = &point->run[r];
        const double *e = run->error;
        const struct run_row row = {p,
                                    r / plan->h_count,
                                    plan->h[r % plan->h_count],
                                    run->t_end,
                                    run->steps,
                                    run->force_evals,
                                    e[0],
                                    e[1],
                                    e[2],
                                    e[3],
                                    e[4],
                                    run->failed,
                                    run->judgement};
        hdf5_table_add(&w->runs, &row);
        if (run->failed) {
            struct failure_row failure = {w->run, ""};
            memcpy(failure.reason, run->reason, sizeof failure.reason);
            hdf5_table_add(&w->failures, &failure);
        }
    }
}

static void write_orders(struct writer *w, int64_t p, const struct plan *plan, const struct survey_point *point)
{
    for (int64_t s = 0; s < plan->steppers_count; ++s)
        for (int m = 0; m < MEASURES; ++m) {
            const struct order o = survey_order(plan, point, s, m);
            const struct order_row row = {p, s, m, o.points, o.order, o.interval, o.h_min, o.h_max, o.log2_constant};
            hdf5_table_add(&w->orders, &row);
        }
}

static void write_group(struct writer *w, const struct plan *plan)
{
    const struct survey_group *g = &w->group;
    for (int64_t r = 0; r < plan->steppers_count * plan->h_count; ++r) {
        const struct ensemble *e = g->error[r];
        double v[2 * SURVEY_ERRORS];
        for (int m = 0; m < SURVEY_ERRORS; ++m) {
            v[2 * m] = ensemble_mean(&e[m]);
            v[2 * m + 1] = ensemble_spread(&e[m]);
        }
        const struct mean_row row = {g->first,
                                     r / plan->h_count,
                                     plan->h[r % plan->h_count],
                                     e[0].count,
                                     g->failed[r],
                                     v[0],
                                     v[1],
                                     v[2],
                                     v[3],
                                     v[4],
                                     v[5],
                                     v[6],
                                     v[7],
                                     v[8],
                                     v[9]};
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
    struct point_row row = {
        survey_scene(w->plan, p),    {0}, point->energy0, point->norm_squared, point->reference_energy_error,
        point->reference_uncertainty};
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

/** Of all points of a scene, by what each of its points or groups has of it. */
static int64_t over_scenes(const struct survey_plan *plan, int64_t each, int with_steps, int64_t times)
{
    int64_t n = 0;
    for (int k = 0; k < plan->scenes_count; ++k)
        n += each * plan->each[k].steppers_count * (with_steps ? plan->each[k].h_count : times);
    return n;
}

/* ---- lists ------------------------------------------------------------------------------------------------------- */

struct name_row {
    char name[NAME];
};

static const struct hdf5_column name_columns[] = {{"name", offsetof(struct name_row, name), 0, NAME}};

/** /NAME/name: a list of texts. */
static struct hdf5_table begin_names(struct hdf5_sink *file, const char *name, int64_t n)
{
    return hdf5_table_begin(file, name, name_columns, COUNT(name_columns), sizeof(struct name_row), n);
}

static void add_name(struct hdf5_table *table, const char *name)
{
    struct name_row row = {""};
    snprintf(row.name, sizeof row.name, "%s", name);
    hdf5_table_add(table, &row);
}

static void write_names(struct hdf5_sink *file, const struct survey_plan *plan)
{
    struct hdf5_table scenes = begin_names(file, "scenes", plan->scenes_count);
    for (int k = 0; k < plan->scenes_count; ++k)
        add_name(&scenes, plan->first[k].name);
    hdf5_table_end(file, &scenes);
    struct hdf5_table steppers = begin_names(file, "steppers", plan->each[0].steppers_count);
    for (int64_t s = 0; s < plan->each[0].steppers_count; ++s)
        add_name(&steppers, plan->each[0].steppers[s]->name);
    hdf5_table_end(file, &steppers);
    struct hdf5_table measures = begin_names(file, "measures", MEASURES);
    for (int m = 0; m < MEASURES; ++m)
        add_name(&measures, study_measures[m]);
    hdf5_table_end(file, &measures);
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

/** Columns, and behind them the numbers of the verdict or of the swept values. */
static int more_columns(struct hdf5_column *all, const struct hdf5_column *first, int n, const struct sweep *sweep)
{
    memcpy(all, first, (size_t)n * sizeof *all);
    for (int k = 0; sweep == NULL && k < VERDICT_NUMBERS; ++k)
        all[n++] = (struct hdf5_column){verdict_numbers[k].name,
                                        offsetof(struct run_row, judgement) + verdict_numbers[k].offset,
                                        verdict_numbers[k].is_integer, 0};
    for (int k = 0; sweep != NULL && k < sweep->count; ++k)
        all[n++] = (struct hdf5_column){sweep->axis[k].key, offsetof(struct point_row, value) + (size_t)k * 8, 1, 0};
    return n;
}

static int write_tables(const struct survey *survey, struct hdf5_sink *file, int64_t failed, struct message *message)
{
    static struct writer w;
    struct hdf5_column runs[COUNT(run_columns) + VERDICT_NUMBERS], points[COUNT(point_columns) + SWEEP_AXES];
    const struct survey_plan *plan = survey->plan;
    const int64_t groups = survey_groups(plan) / plan->scenes_count, places = sweep_points(plan->sweep);
    memset(&w, 0, sizeof w);
    w.plan = plan;
    w.points =
        hdf5_table_begin(file, "points", points, more_columns(points, point_columns, COUNT(point_columns), plan->sweep),
                         sizeof(struct point_row), survey->points);
    w.runs = hdf5_table_begin(file, "runs", runs, more_columns(runs, run_columns, COUNT(run_columns), NULL),
                              sizeof(struct run_row), survey->runs);
    w.failures =
        hdf5_table_begin(file, "failures", failure_columns, COUNT(failure_columns), sizeof(struct failure_row), failed);
    w.orders = hdf5_table_begin(file, "orders", order_columns, COUNT(order_columns), sizeof(struct order_row),
                                over_scenes(plan, places, 0, MEASURES));
    w.means = hdf5_table_begin(file, "ensemble", mean_columns, COUNT(mean_columns), sizeof(struct mean_row),
                               over_scenes(plan, groups, 1, 1));
    w.mean_orders = hdf5_table_begin(file, "ensemble_orders", mean_order_columns, COUNT(mean_order_columns),
                                     sizeof(struct mean_order_row), over_scenes(plan, groups, 0, MEASURES));
    const int unread = survey_each(survey, write_point, &w, message);
    struct hdf5_table *const tables[] = {&w.points, &w.runs, &w.failures, &w.orders, &w.means, &w.mean_orders};
    for (int k = 0; k < COUNT(tables); ++k)
        hdf5_table_end(file, tables[k]);
    return unread;
}

int survey_hdf5_write(const struct survey *survey, const char *path, int64_t failed, struct message *message)
{
    hdf5_start();
    struct hdf5_sink file = hdf5_file(path);
    if (file.failed)
        return message_set(message, "%s: cannot be made; the disk may be full", path);
    hdf5_text(&file, "vti_version", vti_version());
    hdf5_text(&file, "ensemble", survey->plan->sweep->count > 0 ? survey->plan->sweep->axis[0].key : "");
    write_names(&file, survey->plan);
    write_sweep(&file, survey->plan->sweep);
    const int unread = write_tables(survey, &file, failed, message);
    if (hdf5_close_file(&file) != 0 && unread == 0)
        return message_set(message, "%s: cannot be written; the disk may be full", path);
    return unread;
}
