/* SPDX-License-Identifier: BSD-3-Clause */
#include "trial.h"

#include <string.h>

#include "clock.h"

int trial_begin(struct trial_run *run, const struct scene *scene, const struct trial *trial, struct message *message)
{
    memset(run, 0, sizeof *run);
    run->trial = trial;
    if (model_create(scene, &run->model, message) != 0)
        return -1;
    if (travel_create(&run->travel, trial->stepper, &run->model, trial->h, message) == 0)
        return 0;
    model_destroy(&run->model);
    return -1;
}

int trial_go(struct trial_run *run, int64_t until, const struct observer *observers, int observers_count,
             struct message *message)
{
    const double from = clock_of_thread();
    const int result = travel_show(&run->travel, until - run->travel.steps, observers, observers_count, message);
    run->seconds += clock_of_thread() - from;
    return result;
}

int64_t trial_look_every(const struct trial *trial)
{
    enum { LOOKS = 64 };
    return method_varies(trial->stepper) ? (trial->steps + LOOKS - 1) / LOOKS : 1;
}

void trial_end(struct trial_run *run)
{
    travel_destroy(&run->travel);
    model_destroy(&run->model);
}
