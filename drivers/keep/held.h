/* SPDX-License-Identifier: BSD-3-Clause
 * HDF5 files that HDF5 does not open. */
#ifndef VTI_HELD_H
#define VTI_HELD_H

/** What is said of a file that is held, up to what else may be done about it. */
#define HELD_TEXT "HDF5 does not open it: another program writes to it, or it is damaged; close it there"

/** Whether the file begins as files of HDF5 do. */
int held_begins(const char *path);

/** Whether it does, and HDF5 does not open it: another program has it open for writing, or it is damaged. */
int held_is(const char *path);

#endif
