/* SPDX-License-Identifier: BSD-3-Clause */
#include "quote.h"

#include <string.h>

static const char dots[] = "...";
enum { DOTS = sizeof dots - 1 };

size_t quote_character(const char *text, size_t left)
{
    const unsigned char *const p = (const unsigned char *)text;
    const unsigned char c = p[0];
    const size_t n = c < 0x80 ? 1 : c < 0xc2 ? 0 : c < 0xe0 ? 2 : c < 0xf0 ? 3 : c < 0xf5 ? 4 : 0;
    if (n > left)
        return 0;
    for (size_t k = 1; k < n; ++k)
        if ((p[k] & 0xc0) != 0x80)
            return 0;
    if ((c == 0xe0 && p[1] < 0xa0) || (c == 0xed && p[1] > 0x9f) || (c == 0xf0 && p[1] < 0x90) ||
        (c == 0xf4 && p[1] > 0x8f))
        return 0;
    return n;
}

/** Inside a UTF-8 character, not at its start. */
static int continues(char c)
{
    return ((unsigned char)c & 0xc0) == 0x80;
}

void quote_controls(char *text)
{
    for (char *p = text; *p != '\0'; ++p) {
        const unsigned char c = (unsigned char)p[0], next = (unsigned char)p[1];
        if (c < 0x20 || c == 0x7f)
            *p = '?';
        else if (c == 0xc2 && next >= 0x80 && next <= 0x9f) /* the second set of control characters, two bytes each */
            p[0] = p[1] = '?';
    }
}

char *quote(char *out, size_t size, const char *text)
{
    size_t n = strlen(text);
    const int cut = n >= size;
    if (cut) {
        n = size - 1 - DOTS;
        for (int k = 0; k < 3 && continues(text[n]); ++k)
            --n;
    }
    memcpy(out, text, n);
    out[n] = '\0';
    if (cut)
        quote_append(out, size, dots);
    quote_controls(out);
    return out;
}

char *quote_append(char *out, size_t size, const char *text)
{
    const size_t used = strlen(out), n = strlen(text), room = size - 1 - used;
    memcpy(out + used, text, n < room ? n : room);
    out[used + (n < room ? n : room)] = '\0';
    return out;
}

char *quote_tail(char *out, size_t size, const char *text)
{
    const size_t n = strlen(text);
    if (n < size)
        return quote(out, size, text);
    text += n - (size - 1 - DOTS);
    for (int k = 0; k < 3 && continues(*text); ++k)
        ++text;
    memcpy(out, dots, DOTS);
    quote(out + DOTS, size - DOTS, text);
    return out;
}
