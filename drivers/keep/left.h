/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What a killed program leaves: whether a file is one of ours (keep.h), or one that SQLite has put beside it, so that
 * nobody else's is taken for one, written to or removed. Looked at before SQLite is asked. */
#ifndef VTI_LEFT_H
#define VTI_LEFT_H

struct message;

/** The application id of our files: "vti1". */
enum { LEFT_ID = 0x76746931 };

/** Whether the open file may be one that a program of ours has made. */
int left_is_ours(int fd);

/** Whether a program that was killed may have left the file at path: one of ours, or an empty one. Not to be asked
 *  while this program has it open: closing it here would give SQLite's lock away. */
int left_is_there(const char *path);

/** What SQLite may put beside such a file, by the endings of their names. It takes files of these names for its own,
 *  and removes them: -journal, which a killed program of ours leaves, and two of a kind that none of ours writes. */
enum { LEFT_ENDINGS = 3 };
extern const char *const left_endings[LEFT_ENDINGS];

/** Refuses files beside the one at path that no killed program of ours has left. Another program may begin or end in
 *  the meantime. Returns 0, or -1 with one line in *message: what is "run" or "study". */
int left_beside(const char *path, const char *what, struct message *message);

#endif
