/* SPDX-License-Identifier: BSD-3-Clause */
#include "run_formats.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "checkpoint.h"
#include "hdf5_sink.h"
#include "quote.h"

struct writer {
    const struct columns *columns;
    struct hdf5_sink *place;
    double *values;
};

static int take_rows(void *self, int64_t first, int64_t count, const double *rows)
{
    struct writer *w = self;
    double *values = realloc(w->values, sizeof *values * (size_t)count);
    if (values == NULL)
        return -1;
    w->values = values;
    for (int c = 0; c < w->columns->count; ++c) {
        for (int64_t k = 0; k < count; ++k)
            values[k] = rows[k * w->columns->count + c];
        hdf5_rows(w->place, w->columns->name[c], (hsize_t)first, (hsize_t)count, values);
    }
    return w->place->failed ? -1 : 0;
}

/** "t,kinetic_rotation,...", as in the first line of the CSV file. */
static void names(struct hdf5_sink *s, const struct columns *columns)
{
    enum { NAME = 32 };
    char text[COLUMNS * NAME] = "";
    for (int c = 0; c < columns->count; ++c) {
        const size_t used = strlen(text);
        snprintf(text + used, sizeof text - used, "%s%s", c > 0 ? "," : "", columns->name[c]);
    }
    hdf5_text(s, "columns", text);
}

/** How pictures show an energy: attributes symbol, meaning and colour of its dataset. */
static void look_write(struct hdf5_sink *s, const char *name, const struct effect_term *term)
{
    if (term == NULL || s->failed)
        return;
    struct hdf5_sink set = {H5Dopen2(s->place, name, H5P_DEFAULT), 0, NULL};
    hdf5_text(&set, "symbol", term->symbol);
    hdf5_text(&set, "meaning", term->meaning);
    hdf5_text(&set, "colour", term->colour);
    s->failed |= set.failed | (H5Dclose(set.place) < 0);
}

static int energies_write(const struct record *record, struct hdf5_sink *file, struct message *message)
{
    const hsize_t count = (hsize_t)record->journal->rows.mark.count;
    struct hdf5_sink s = hdf5_group(file, "energies");
    struct writer w = {&record->columns, &s, NULL};
    names(&s, &record->columns);
    for (int c = 0; c < record->columns.count; ++c) {
        hdf5_dataset(&s, record->columns.name[c], H5T_NATIVE_DOUBLE, 1, &count, NULL);
        look_write(&s, record->columns.name[c], record->columns.term[c]);
    }
    if (s.failed || record_rows(record, take_rows, &w, message) != 0)
        s.failed = 1;
    free(w.values);
    hdf5_close(file, &s);
    return file->failed ? -1 : 0;
}

/** Velocities and spins of planes and cylinders, "wall_velocities" and "wall_spins", which they keep. */
static void motion_write(const char *name, const vti_wall_motion *motion, hsize_t walls, struct hdf5_sink *file)
{
    const hsize_t dims[2] = {walls, 3};
    double *values = malloc(sizeof *values * (size_t)(4 * walls)), *spins = values != NULL ? values + 3 * walls : NULL;
    char path[64];
    file->failed |= values == NULL;
    for (hsize_t w = 0; values != NULL && w < walls; ++w) {
        memcpy(values + 3 * w, motion[w].velocity, sizeof motion[w].velocity);
        spins[w] = motion[w].spin;
    }
    snprintf(path, sizeof path, "%s_velocities", name);
    if (values != NULL)
        hdf5_dataset(file, path, H5T_NATIVE_DOUBLE, 2, dims, values);
    snprintf(path, sizeof path, "%s_spins", name);
    if (values != NULL)
        hdf5_dataset(file, path, H5T_NATIVE_DOUBLE, 1, dims, spins);
    free(values);
}

/** Planes and cylinders of an effect as they are at t = 0, and how they move. Returns how many. */
static hsize_t walls_write(const struct effect *e, struct hdf5_sink *file)
{
    const struct effect_planes *kind = e->kind->planes;
    const double *plane = NULL, *cylinder = NULL;
    const vti_wall_motion *motion = kind->motion != NULL ? kind->motion(e) : NULL;
    const hsize_t planes[2] = {(hsize_t)kind->get(e, &plane), 4};
    const hsize_t cylinders[2] = {kind->cylinders != NULL ? (hsize_t)kind->cylinders(e, &cylinder) : 0, 7};
    char path[64];
    if (planes[0] + cylinders[0] == 0)
        return 0;
    snprintf(path, sizeof path, "%ss", kind->name);
    hdf5_dataset(file, path, H5T_NATIVE_DOUBLE, 2, planes, plane);
    snprintf(path, sizeof path, "%s_cylinders", kind->name);
    if (cylinders[0] > 0)
        hdf5_dataset(file, path, H5T_NATIVE_DOUBLE, 2, cylinders, cylinder);
    if (motion != NULL)
        motion_write(kind->name, motion, planes[0] + cylinders[0], file);
    return planes[0] + cylinders[0];
}

/** Walls of effects, and the names of these, "wall", in planes; and in touching which pairs are in contact
 *  (effect_touch). */
static void scenery_write(const struct model *model, struct hdf5_sink *file)
{
    int64_t touching = 0;
    char all[256] = "";
    for (int64_t k = 0; k < model->instances_count; ++k) {
        const struct effect *e = &model->instances[k];
        const struct effect_planes *planes = e->kind->planes;
        touching |= e->kind->touching != NULL ? e->kind->touching(e) : 0;
        if (planes == NULL || walls_write(e, file) == 0)
            continue;
        quote_append(quote_append(all, sizeof all, all[0] != '\0' ? "," : ""), sizeof all, planes->name);
    }
    hdf5_text(file, "planes", all);
    hdf5_attribute(file, "touching", H5T_NATIVE_INT64, 1, &touching);
}

/** /clumps: the body of each sphere, where it sits in the body, its diameter. */
static void clumps_write(const struct clumps *clumps, struct hdf5_sink *file)
{
    const hsize_t dims[2] = {(hsize_t)clumps->list.count, 3};
    if (clumps->list.count == 0)
        return;
    struct hdf5_sink group = hdf5_group(file, "clumps");
    hdf5_dataset(&group, "body", H5T_NATIVE_INT64, 1, dims, clumps->list.body);
    hdf5_dataset(&group, "offset", H5T_NATIVE_DOUBLE, 2, dims, clumps->list.offset);
    hdf5_dataset(&group, "diameter", H5T_NATIVE_DOUBLE, 1, dims, clumps->diameter.p);
    hdf5_close(file, &group);
}

/** What the scene says yes or no to, of the effects that it has, 1 or 0 by the key's path: "contact.bonded". */
static void choices_write(const struct scene *scene, struct hdf5_sink *file)
{
    for (int e = 0; e < EFFECT_COUNT; ++e) {
        const struct effect_kind *kind = kinds_at(e);
        const char *settings = kinds_settings_of(kind, &scene->settings);
        for (int f = 0; f < kind->fields_count && scene->has[e]; ++f)
            if (kind->fields[f].kind == SCENE_YES_NO)
                hdf5_attribute(file, kind->fields[f].path, H5T_NATIVE_INT64, 1, settings + kind->fields[f].offset);
    }
}

/** By what steps vary, where they do. */
static void control_write(const struct scene *scene, struct hdf5_sink *file)
{
    const char *word = scene_control_word(scene);
    if (scene->tolerance > 0.0)
        hdf5_attribute(file, "tolerance", H5T_NATIVE_DOUBLE, 1, &scene->tolerance);
    if (word != NULL)
        hdf5_text(file, "control", word);
}

/** What the verdict is, and the numbers behind it. */
static void verdict_write(const struct judgement *judgement, struct hdf5_sink *file)
{
    hdf5_text(file, "verdict", verdict_word(judgement->verdict));
    for (int k = 1; k < VERDICT_NUMBERS; ++k)
        hdf5_attribute(file, verdict_numbers[k].name,
                       verdict_numbers[k].is_integer ? H5T_NATIVE_INT64 : H5T_NATIVE_DOUBLE, 1,
                       (const char *)judgement + verdict_numbers[k].offset);
}

/** A piece of /restart/checkpoint. */
static int put_piece(void *self, size_t at, size_t all, const void *piece, size_t size)
{
    struct hdf5_sink *group = self;
    const hsize_t count = (hsize_t)all;
    if (at == 0)
        hdf5_dataset(group, "checkpoint", H5T_NATIVE_UINT8, 1, &count, NULL);
    if (!group->failed)
        hdf5_rows(group, "checkpoint", (hsize_t)at, (hsize_t)size, piece);
    return 0;
}

/** /restart: what a complete run is and the checkpoint at its end, from which it goes on (run/run.h). */
static int restart_write(const struct record *record, struct hdf5_sink *file, struct message *message)
{
    const hsize_t length = (hsize_t)strlen(record->identity);
    if (!record->complete || !record->journal->keep.holds)
        return 0;
    struct hdf5_sink group = hdf5_group(file, "restart");
    hdf5_dataset(&group, "identity", H5T_NATIVE_UINT8, 1, &length, record->identity);
    const int failed = checkpoint_pieces(record->journal, put_piece, &group, message);
    hdf5_close(file, &group);
    return failed != 0 || file->failed ? -1 : 0;
}

double run_hdf5_bytes(const struct record *record, int64_t rows, int64_t frames)
{
    return vtkhdf_bytes(record, frames) + 8.0 * (double)record->columns.count * (double)rows;
}

int run_hdf5_write(const struct record *record, const char *path, struct message *message)
{
    struct hdf5_sink file = hdf5_file(path, message);
    if (file.failed)
        return -1;
    message->text[0] = '\0';
    hdf5_text(&file, "scene", record->model->scene->name);
    hdf5_text(&file, "stepper", record->stepper->name);
    hdf5_text(&file, "vti_version", vti_version());
    hdf5_attribute(&file, "h", H5T_NATIVE_DOUBLE, 1, &record->h);
    control_write(record->model->scene, &file);
    hdf5_attribute(&file, "complete", H5T_NATIVE_INT64, 1, &record->complete);
    verdict_write(&record->judgement, &file);
    scenery_write(record->model, &file);
    clumps_write(&record->model->clumps, &file);
    choices_write(record->model->scene, &file);
    const int failed = file.failed || vtkhdf_write(record, &file, message) != 0 ||
                       energies_write(record, &file, message) != 0 || restart_write(record, &file, message) != 0;
    if (hdf5_close_file(&file) == 0 && !failed)
        return 0;
    return message->text[0] != '\0' ? -1 : message_set(message, "%s: cannot be written; the disk may be full", path);
}
