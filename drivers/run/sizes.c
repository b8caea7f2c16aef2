/* SPDX-License-Identifier: BSD-3-Clause */
#include "sizes.h"

#include <math.h>
#include <stdio.h>

#include "checkpoint.h"
#include "folder.h"
#include "interval.h"

/** Frames of a run that nobody asks for: so many, unless so many bytes of files hold fewer. */
enum { USUAL_FRAMES = 100, UNASKED_BYTES = 500000000 };

/** Of one checkpoint, which OUT.run has, and at the end OUT.h5. */
static double one_checkpoint(struct run *run)
{
    int64_t count;
    (void)travel_state(&run->travel, &count);
    return checkpoint_bytes(&run->model.bodies, &run->verdict, count);
}

int64_t sizes_frames(struct run *run, int64_t *fit)
{
    const int64_t rows = interval_records(run->steps, run->checkpoint.record_every);
    const double none = run_files_bytes(&run->files, &run->record, rows, 0),
                 frame = run_files_bytes(&run->files, &run->record, rows, 1) - none,
                 most = fmin(floor((UNASKED_BYTES - none - one_checkpoint(run)) / frame), 0x1p53);
    const int64_t usual = interval_choose(run->scene.h, run->steps, USUAL_FRAMES);
    *fit = 0;
    if ((double)interval_records(run->steps, usual) <= most)
        return usual;
    const int64_t every = interval_within(run->scene.h, run->steps, USUAL_FRAMES, (int64_t)most);
    *fit = interval_records(run->steps, every);
    return every;
}

struct run_sizes sizes_of(struct run *run)
{
    const struct journal *journal = &run->journal;
    const int64_t rows = interval_records(run->steps, run->checkpoint.record_every),
                  frames = interval_records(run->steps, run->checkpoint.frames_every);
    const double checkpoint = one_checkpoint(run), touches = run_files_touches(&run->files, &run->record, frames);
    const struct journal_marks there = journal_marks(journal);
    struct run_sizes sizes = {run_files_bytes(&run->files, &run->record, rows, frames) + checkpoint,
                              journal_bytes(journal, (double)rows, (double)frames, touches) + checkpoint, 0.0,
                              folder_space(run->files.folder)};
    sizes.needed =
        sizes.files + sizes.journal -
        journal_bytes(journal, (double)there.rows.count, (double)there.frames.count, (double)there.touches.count);
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
