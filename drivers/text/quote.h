/* SPDX-License-Identifier: BSD-3-Clause
 * Text of files and command lines inside messages: whatever it holds, a message stays one readable line. */
#ifndef VTI_QUOTE_H
#define VTI_QUOTE_H

#include <stddef.h>

enum { QUOTE_SIZE = 64 };

/** text as it can be shown: control characters become '?', and what does not fit into out (size bytes, at least 8, the
 *  terminating 0 included) is cut off at a whole UTF-8 character and ends with "...". Returns out. */
char *quote(char *out, size_t size, const char *text);

/** The same, but the end is kept and the beginning cut off, as suits the names of files. */
char *quote_tail(char *out, size_t size, const char *text);

/** How many bytes the UTF-8 character takes that the text, of so many bytes, begins with (RFC 3629: no surrogates,
 *  nothing overlong); 0 if it begins with none. */
size_t quote_character(const char *text, size_t left);

/** Makes '?' of all that a terminal could take for commands. */
void quote_controls(char *text);

/** Appends text to what stands in out (size bytes, the terminating 0 included); what does not fit is dropped. Returns
 *  out. */
char *quote_append(char *out, size_t size, const char *text);

#endif
