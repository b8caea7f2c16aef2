/* SPDX-License-Identifier: BSD-3-Clause */
#include "message.h"

#include "quote.h"

#include <stdio.h>
#include <string.h>

/** What a terminal could take for commands, or is no UTF-8, becomes '?', be it from files or command lines. */
static void make_readable(char *text)
{
    const char *const end = text + strlen(text);
    for (size_t size; text < end; text += size) {
        size = quote_character(text, (size_t)(end - text));
        if (size == 0 || (unsigned char)*text < ' ' || *text == 0x7f) {
            *text = '?';
            size = 1;
        }
    }
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
