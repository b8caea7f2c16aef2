/* SPDX-License-Identifier: BSD-3-Clause
 * One line for the user: what is wrong, where, and what to do. Layers below the programs fill it and never print. */
#ifndef VTI_MESSAGE_H
#define VTI_MESSAGE_H

#include <stdarg.h>

struct message {
    char text[1024];
};

/** Writes the line (cut off at the size of text) and returns -1, so that "return message_set(...)" reports a
 *  failure. */
int message_set(struct message *message, const char *format, ...) __attribute__((format(printf, 2, 3)));

/** The same for functions that have such arguments themselves. */
int message_set_list(struct message *message, const char *format, va_list arguments)
    __attribute__((format(printf, 2, 0)));

#endif
