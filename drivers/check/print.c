/* SPDX-License-Identifier: BSD-3-Clause */
#include "vti_check.h"

#include <math.h>

static const char *verdict_text(int verdict)
{
    return verdict == VTI_CHECK_FAIL ? "FAIL" : verdict == VTI_CHECK_PASS ? "pass" : "note";
}

static const char *relation_text(int relation)
{
    return relation < 0 ? "at most" : "at least";
}

void vti_check_print(const vti_check_report *report, FILE *file)
{
    fprintf(file, "%s: %s\n", report->name,
            report->faults > 0  ? "faults found"
            : report->words > 0 ? "no fault found, but:"
                                : "no fault found");
    for (int k = 0; k < report->words; ++k)
        fprintf(file, "  %s %s\n", report->word[k].is_fault ? "FAULT " : "remark", report->word[k].text);
    for (int k = 0; k < report->lines; ++k) {
        const vti_check_line *l = &report->line[k];
        fprintf(file, "  %s   %-66s %10.3g  (%s %g)%s%s\n", verdict_text(l->verdict), l->name, l->measured,
                relation_text(l->relation), l->bound, l->said[0] != '\0' ? "  " : "", l->said);
    }
}

/* ---- JSON -------------------------------------------------------------------------------------------------------- */

static void json_text(FILE *file, const char *text)
{
    fputc('"', file);
    for (const char *c = text; *c != '\0'; ++c) {
        if (*c == '"' || *c == '\\')
            fprintf(file, "\\%c", *c);
        else if ((unsigned char)*c < 0x20)
            fprintf(file, "\\u%04x", (unsigned)(unsigned char)*c);
        else
            fputc(*c, file);
    }
    fputc('"', file);
}

/** JSON has no words for what is not finite. */
static void json_number(FILE *file, double x)
{
    if (isfinite(x))
        fprintf(file, "%.9g", x);
    else
        fputs("null", file);
}

static void json_words(FILE *file, const vti_check_report *report, int faults)
{
    const char *comma = "";
    for (int k = 0; k < report->words; ++k)
        if (report->word[k].is_fault == faults) {
            fputs(comma, file);
            json_text(file, report->word[k].text);
            comma = ", ";
        }
}

static void json_line(FILE *file, const vti_check_line *l)
{
    fputs("\n    {\"name\": ", file);
    json_text(file, l->name);
    fprintf(file,
            ", \"verdict\": \"%s\", \"measured\": ", l->verdict == VTI_CHECK_FAIL ? "fail" : verdict_text(l->verdict));
    json_number(file, l->measured);
    fprintf(file, ", \"relation\": \"%s\", \"bound\": %.9g, \"said\": ", relation_text(l->relation), l->bound);
    json_text(file, l->said);
    fputc('}', file);
}

void vti_check_print_json(const vti_check_report *report, FILE *file)
{
    fputs("{\n  \"stepper\": ", file);
    json_text(file, report->name);
    fputs(",\n  \"faults\": [", file);
    json_words(file, report, 1);
    fputs("],\n  \"remarks\": [", file);
    json_words(file, report, 0);
    fputs("],\n  \"checks\": [", file);
    for (int k = 0; k < report->lines; ++k) {
        fputs(k > 0 ? "," : "", file);
        json_line(file, &report->line[k]);
    }
    fputs("\n  ]\n}\n", file);
}
