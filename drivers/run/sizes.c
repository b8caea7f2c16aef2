/* SPDX-License-Identifier: BSD-3-Clause */
#include "sizes.h"

#include <stdio.h>

#include "folder.h"

/** Records of a run, the start and the end among them. */
static int64_t records(int64_t steps, int64_t every)
{
    return steps / every + 1 + (steps % every != 0);
}

struct run_sizes sizes_of(const struct run *run)
{
    const struct journal *journal = &run->journal;
    const int64_t rows = records(run->steps, run->checkpoint.record_every),
                  frames = records(run->steps, run->checkpoint.frames_every);
    struct run_sizes sizes = {run_files_bytes(&run->files, &run->record, rows, frames),
                              journal_bytes(journal, rows, frames), 0.0, folder_space(run->files.folder)};
    sizes.needed =
        sizes.files + sizes.journal - journal_bytes(journal, journal->rows.mark.count, journal->frames.mark.count);
    return sizes;
}

const char *sizes_text(double bytes, char text[32])
{
    if (bytes < 1e9)
        snprintf(text, 32, "%.0f MB", 1e-6 * bytes);
    else if (bytes >= 1e12)
        snprintf(text, 32, "%.3g TB", 1e-12 * bytes);
    else
        snprintf(text, 32, "%.3g GB", 1e-9 * bytes);
    return text;
}
