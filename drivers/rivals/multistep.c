/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The library's multistep methods as programs run them (EQUATIONS 8.1): K - 1 steps by a stepper that is accurate enough,
 * the accelerations remembered before each, then one force evaluation a step. What they remember is all that they keep
 * beside the bodies, so that a checkpoint goes on with it. */
#include "rival.h"

enum { MOST = 16 };

static struct rival ways[MOST]; /* in the order of the library's table, filled in as they are asked for */

/* ---- a step ------------------------------------------------------------------------------------------------------ */

/** Steps of h that begin a run. For the order K + 1 their own has to be K: srkn11 has it up to 8 at the steps that are
 *  stable, from 9 on kl8 at a quarter of the step. */
static int start_step(struct course *c, int64_t depth)
{
    const vti_stepper *const by = vti_stepper_find(depth < 9 ? "srkn11" : "kl8");
    const int parts = depth < 9 ? 1 : 4;
    const double h = c->h / parts;
    int status = VTI_OK;
    for (int part = 0; part < parts && status == VTI_OK; ++part) {
        for (int64_t k = 0; k < by->stages && status == VTI_OK; ++k) {
            status = vti_step_stage(by, k, h, &c->bodies, &c->fault);
            if (status == VTI_OK)
                status = course_forces(c);
        }
        if (status == VTI_OK)
            status = vti_step_finish(by, h, &c->bodies);
    }
    return status;
}

static int multistep(struct course *c, const vti_multistep *m, vti_past *past)
{
    int status = vti_multistep_predict(m, c->h, past, &c->bodies, &c->fault);
    if (status == VTI_OK)
        status = course_forces(c);
    return status == VTI_OK ? vti_multistep_correct(m, c->h, past, &c->bodies) : status;
}

/** The numbers of the course: how many accelerations are known. */
static int go(struct course *c, int64_t steps)
{
    const vti_multistep *const m = vti_multistep_at(c->rival - ways);
    vti_past past = {c->own, m->depth, (int64_t)c->number[0]};
    int status = VTI_OK;
    for (int64_t k = 0; k < steps && status == VTI_OK; ++k) {
        if (past.known < m->depth)
            status = vti_multistep_record(&past, &c->bodies);
        if (status == VTI_OK)
            status = past.known < m->depth ? start_step(c, m->depth) : multistep(c, m, &past);
        c->number[0] = (double)past.known;
        c->steps += status == VTI_OK;
    }
    return status;
}

/* ---- what programs know of it ------------------------------------------------------------------------------------ */

const struct rival *multistep_at(int64_t i)
{
    const vti_multistep *m = i < MOST ? vti_multistep_at(i) : NULL;
    if (m == NULL)
        return NULL;
    if (ways[i].go == NULL) {
        /* evaluations of a step vary, for the first ones take more */
        const struct rival way = {
            .stepper = RIVAL_STEPPER(m->name, m->depth + 1, 0.0, 0, m->reach, m->about),
            .own_width = 6 * m->depth,
            .go = go,
            .takes_forces = 1,
        };
        ways[i] = way;
    }
    return &ways[i];
}
