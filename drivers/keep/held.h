/* SPDX-License-Identifier: BSD-3-Clause
 * Files of HDF5 as they are found: whether HDF5 opens them, and whether they are of ours. */
#ifndef VTI_HELD_H
#define VTI_HELD_H

/** What is said of a file that is held, up to what else may be done about it. */
#define HELD_TEXT "HDF5 does not open it: another program writes to it, or it is damaged; close it there"

/** Whether the file begins as files of HDF5 do. */
int held_begins(const char *path);

/** Whether it does, and HDF5 does not open it: another program has it open for writing, or it is damaged. */
int held_is(const char *path);

/** Whether HDF5 opens it and it has the attribute, as files of ours do. */
int held_has(const char *path, const char *attribute);

#endif
