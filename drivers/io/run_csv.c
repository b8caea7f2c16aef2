/* SPDX-License-Identifier: BSD-3-Clause */
#include "run_formats.h"

#include "number.h"

struct writer {
    FILE *file;
    int columns;
};

static int take_rows(void *self, int64_t first, int64_t count, const double *rows)
{
    const struct writer *w = self;
    (void)first;
    for (int64_t k = 0; k < count * w->columns; ++k) {
        fputs(NUMBER(rows[k]), w->file);
        putc((k + 1) % w->columns == 0 ? '\n' : ',', w->file);
    }
    return 0;
}

int run_csv_write(const struct record *record, FILE *file, struct message *message)
{
    struct writer w = {file, record->columns.count};
    for (int c = 0; c < w.columns; ++c)
        fprintf(file, "%s%c", record->columns.name[c], c + 1 == w.columns ? '\n' : ',');
    return record_rows(record, take_rows, &w, message);
}

double run_csv_bytes(const struct record *record, int64_t rows)
{
    enum { NUMBER_BYTES = 19 }; /* of 17 digits with a comma; there are zeros among them */
    return NUMBER_BYTES * (double)record->columns.count * (double)rows;
}
