/* SPDX-License-Identifier: BSD-3-Clause */
#include "outcome.h"

#include <math.h>
#include <string.h>

#include "norms.h"

const char *const outcome_errors[OUTCOME_ERRORS] = {[E_ERROR] = "e_error",
                                                    [Q_ERROR] = "q_error",
                                                    [H1_ERROR] = "h1_error",
                                                    [ATTITUDE_ERROR] = "attitude_error",
                                                    [MOMENTUM_ERROR] = "momentum_error"};

const struct judgement outcome_unjudged = {VERDICT_BAD, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN, 0};

/* ---- measuring --------------------------------------------------------------------------------------------------- */

/** Everything that is summed up along a run. */
struct measures {
    struct model *model;
    const struct travel *travel;
    struct reference *reference;
    struct outcome *outcome;
    struct columns columns;
    struct verdict verdict;
    struct watch watch; /* of norms */
    struct norms norms;
    double h, t_end;
    int64_t sample_every, next_sample; /* steps: no division at those between */
};

static int measures_begin(struct measures *m, struct model *model, struct reference *reference,
                          const struct trial *trial, int64_t compare_every, struct outcome *outcome)
{
    memset(m, 0, sizeof *m);
    m->model = model;
    m->reference = reference;
    m->outcome = outcome;
    m->h = trial->h;
    m->t_end = trial->t_end;
    m->sample_every = (trial->steps + OUTCOME_SAMPLES - 2) / (OUTCOME_SAMPLES - 1);
    m->sample_every = m->sample_every > 0 ? m->sample_every : 1;
    columns_of(model, trial->stepper, &m->columns);
    if (norms_create(&m->norms, model, trial, compare_every, reference, &m->watch, &outcome->message) != 0)
        return -1;
    return verdict_create(&m->verdict, model, trial->stepper, trial->h, &m->columns, &outcome->message);
}

/** Where they are now: a row of the series, and what is beside it in files. */
static void sample(struct measures *m, double t, const vti_bodies *bodies)
{
    const struct norms *n = &m->norms;
    double *row = m->outcome->series[m->outcome->samples++];
    row[0] = t;
    row[1] = norms_energy(m->model, bodies) - n->energy0;
    model_invariant_values(m->model, bodies, row + 2);
    for (int64_t k = 0; k < n->invariants; ++k)
        row[2 + k] -= n->invariants0[k];
}

static int measure_looks(void *self, int64_t step)
{
    const struct measures *m = self;
    return step == m->next_sample || norms_looks(&m->norms);
}

static int measure(void *self, int64_t step, double t, const vti_bodies *bodies)
{
    struct measures *m = self;
    struct travel_tally tally;
    if (norms_take(&m->norms, step, bodies, &m->outcome->message) != 0)
        return 1;

    const int sampled = step == m->next_sample || step == m->outcome->steps;
    if (sampled) {
        m->next_sample += m->sample_every;
        sample(m, t, bodies);
    }
    if (travel_tally(m->travel, &tally))
        verdict_longest(&m->verdict, tally.longest);
    if (sampled) {
        double row[COLUMNS];
        verdict_row(&m->verdict, t, bodies, row);
    }
    verdict_step(&m->verdict, t, bodies);
    return 0;
}

static void measures_end(struct measures *m)
{
    struct outcome *o = m->outcome;
    const double norm_squared = reference_norm_squared(m->reference, m->t_end);
    const double energy_norm = m->norms.energy_unit * sqrt(m->t_end);
    o->error[E_ERROR] = sqrt(vti_integral_value(&m->norms.energy_squared)) / energy_norm;
    o->error[Q_ERROR] = sampled_relative(fabs(vti_integral_value(&m->norms.norm_squared) - norm_squared), norm_squared);
    o->error[H1_ERROR] = sampled_relative(vti_integral_value(&m->norms.error_squared), norm_squared);
    o->error[ATTITUDE_ERROR] = m->norms.attitude_error;
    o->error[MOMENTUM_ERROR] = m->norms.momentum_error;
    o->judgement = verdict_judge(&m->verdict, 0, &o->verdict);
}

/* ---- running ----------------------------------------------------------------------------------------------------- */

struct poller {
    int (*poll)(void *self, int64_t step);
    void *self;
    int64_t step;
};

static int poll_see(void *self, int64_t step, double t, const vti_bodies *bodies)
{
    struct poller *p = self;
    (void)t;
    (void)bodies;
    p->step = step;
    return p->poll(p->self, step);
}

static int poll_on_the_way(void *self, double share)
{
    const struct poller *p = self;
    (void)share;
    return p->poll != NULL && p->poll(p->self, p->step);
}

static void fail(struct outcome *outcome)
{
    outcome->failed = 1;
    outcome->samples = 0;
    outcome->judgement = outcome_unjudged;
    for (int m = 0; m < OUTCOME_ERRORS; ++m)
        outcome->error[m] = NAN;
}

void outcome_of(const struct scene *scene, const struct trial *trial, int64_t compare_every,
                struct reference *reference, int (*poll)(void *self, int64_t step), void *poll_self,
                struct outcome *outcome)
{
    enum { POLL_BODIES = 4096 };
    struct trial_run run;
    struct measures measures;
    struct poller poller = {poll, poll_self, 0};

    memset(outcome, 0, sizeof *outcome);
    outcome->steps = trial->steps;
    if (trial_begin(&run, scene, trial, &outcome->message) != 0) {
        fail(outcome);
        return;
    }
    struct trial taken = *trial; /* where the scene has a tolerance, the stepper that keeps it */
    taken.stepper = run.travel.stepper;
    int failed = measures_begin(&measures, &run.model, reference, &taken, compare_every, outcome) != 0;
    measures.travel = &run.travel;
    measures.watch = (struct watch){poll_on_the_way, &poller};
    const struct observer observers[] = {
        {measure, &measures, 1, 0, measure_looks, NULL},
        {poll_see, &poller, travel_pause(&run.travel, POLL_BODIES), 0, loop_never_looks, NULL}};
    if (!failed)
        failed = trial_go(&run, trial->steps, observers, poll != NULL ? 2 : 1, &outcome->message) != 0;
    if (failed)
        fail(outcome);
    else
        measures_end(&measures);
    outcome->seconds = run.seconds;
    outcome->force_evals = failed ? 0 : travel_force_evals(&run.travel);
    verdict_destroy(&measures.verdict);
    norms_destroy(&measures.norms);
    trial_end(&run);
}
