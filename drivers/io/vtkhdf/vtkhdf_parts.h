/* SPDX-License-Identifier: BSD-3-Clause
 * What every /VTKHDF of PolyData over time has, whose points, cells and point data are written by others. */
#ifndef VTI_VTKHDF_PARTS_H
#define VTI_VTKHDF_PARTS_H

#include "hdf5_sink.h"
#include "record.h"

/** name[count], or name[count][columns] with columns > 1: k step + start in row k. */
void vtkhdf_sequence(struct hdf5_sink *s, const char *name, int64_t count, int64_t columns, int64_t start,
                     int64_t step);
void vtkhdf_integers(struct hdf5_sink *s, const char *name, int64_t count, const int64_t *values);

/** Type, version, number of points, and the cells, which all frames share: each point is a vertex, and pairs[lines][2]
 *  of them are lines. */
void vtkhdf_poly(struct hdf5_sink *root, int64_t points, int64_t lines, const int64_t *pairs);
/** The group Steps with where each frame begins; the offsets of point and cell data are still to come, and its end. */
struct hdf5_sink vtkhdf_steps(struct hdf5_sink *root, int64_t frames, int64_t points, const double *times);

/** A file beside OUT.h5 with the attributes `of`, the scene, and vti_version, and what write adds, which sets
 *  file->failed and, where it knows more, *message. Returns 0, or -1 with one line in *message. */
int vtkhdf_beside(const struct record *record, const char *of, const char *path,
                  void (*write)(const struct record *record, struct hdf5_sink *file, struct message *message),
                  struct message *message);

#endif
