/* SPDX-License-Identifier: BSD-3-Clause */
#include "message.h"

#include <stdio.h>

int message_set_list(struct message *message, const char *format, va_list arguments)
{
    vsnprintf(message->text, sizeof message->text, format, arguments);
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
