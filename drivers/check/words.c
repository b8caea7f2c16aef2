/* SPDX-License-Identifier: BSD-3-Clause */
#include "check.h"

#include <stdarg.h>
#include <string.h>

vti_check_line *vti_kit_line(struct kit *kit, const char *name, double measured, int relation, double bound,
                             int otherwise)
{
    vti_check_report *r = kit->report;
    vti_check_line *line = &r->line[r->lines < VTI_CHECK_LINES ? r->lines++ : VTI_CHECK_LINES - 1];
    line->name = name;
    line->measured = measured;
    line->relation = relation;
    line->bound = bound;
    line->said[0] = '\0';
    const int good = relation < 0 ? measured <= bound : measured >= bound; /* NaN is not good */
    line->verdict = good ? VTI_CHECK_PASS : isfinite(measured) ? otherwise : VTI_CHECK_FAIL;
    return line;
}

void vti_kit_line_say(vti_check_line *line, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    vsnprintf(line->said, sizeof line->said, format, list);
    va_end(list);
}

static void add(struct kit *kit, int is_fault, const char *format, va_list list)
{
    vti_check_report *r = kit->report;
    char text[VTI_CHECK_TEXT];
    vsnprintf(text, sizeof text, format, list);
    for (int k = 0; k < r->words; ++k)
        if (strcmp(r->word[k].text, text) == 0)
            return;
    if (r->words == VTI_CHECK_WORDS)
        return;
    vti_check_word *word = &r->word[r->words++];
    memcpy(word->text, text, sizeof text);
    word->is_fault = is_fault;
    r->faults += is_fault;
}

void vti_kit_fault(struct kit *kit, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    add(kit, 1, format, list);
    va_end(list);
}

void vti_kit_remark(struct kit *kit, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    add(kit, 0, format, list);
    va_end(list);
}
