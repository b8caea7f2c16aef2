/* SPDX-License-Identifier: BSD-3-Clause */
#include "message.h"

#include "quote.h"

#include <stdio.h>
#include <string.h>

/** What a terminal could take for commands, or is no UTF-8, becomes '?', be it from files or command lines. */
static void make_readable(char *text)
{
    const char *const end = text + strlen(text);
    for (char *p = text; p < end;) {
        const size_t size = quote_character(p, (size_t)(end - p));
        if (size == 0)
            *p = '?';
        p += size == 0 ? 1 : size;
    }
    quote_controls(text);
}

int message_set_list(struct message *message, const char *format, va_list arguments)
{
    vsnprintf(message->text, sizeof message->text, format, arguments);
    make_readable(message->text);
    return -1;
}

int message_set(struct message *message, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    message_set_list(message, format, arguments);
    va_end(arguments);
    return -1;
}
