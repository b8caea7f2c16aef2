/* SPDX-License-Identifier: BSD-3-Clause */
#include "outcome.h"

#include <math.h>
#include <string.h>

#include "norms.h"

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
    double energy0, invariants0[MODEL_INVARIANTS];
    struct invariant invariant[MODEL_INVARIANTS];
    int64_t invariants, sample_every;
    int64_t next_sample;         /* step: no division at those between */
    vti_integral energy_squared; /* (E_h - E_0)^2 */
};

/** The energy that only steps change: with what effects have booked. */
static double energy_of(struct measures *m, const vti_bodies *bodies)
{
    return model_energy(m->model, bodies) + vti_booked(m->model->effects, m->model->effects_count);
}

static int measures_begin(struct measures *m, struct model *model, struct reference *reference,
                          const struct trial *trial, int64_t compare_every, struct outcome *outcome)
{
    memset(m, 0, sizeof *m);
    m->model = model;
    m->reference = reference;
    m->outcome = outcome;
    m->h = trial->h;
    m->t_end = trial->t_end;
    m->energy0 = energy_of(m, &model->bodies);
    m->invariants = model_invariants(model, m->invariant);
    model_invariant_values(model, &model->bodies, m->invariants0);
    m->sample_every = (trial->steps + OUTCOME_SAMPLES - 2) / (OUTCOME_SAMPLES - 1);
    m->sample_every = m->sample_every > 0 ? m->sample_every : 1;
    columns_of(model, trial->stepper, &m->columns);
    if (norms_create(&m->norms, model, trial, compare_every, reference, &m->watch, &outcome->message) != 0)
        return -1;
    return verdict_create(&m->verdict, model, trial->stepper, trial->h, &m->columns, &outcome->message);
}

static void sample(struct measures *m, double t, double energy_error, const double *deviations)
{
    double *row = m->outcome->series[m->outcome->samples++];
    row[0] = t;
    row[1] = energy_error;
    memcpy(row + 2, deviations, sizeof m->invariants0);
}

static int measure(void *self, int64_t step, double t, const vti_bodies *bodies)
{
    struct measures *m = self;
    const double energy_error = energy_of(m, bodies) - m->energy0;
    vti_integral_add(&m->energy_squared, m->h, energy_error * energy_error);
    if (norms_take(&m->norms, step, bodies, &m->outcome->message) != 0)
        return 1;

    const int sampled = step == m->next_sample;
    double deviation[MODEL_INVARIANTS] = {0.0};
    model_invariant_values(m->model, bodies, deviation);
    for (int64_t k = 0; k < m->invariants; ++k) {
        deviation[k] -= m->invariants0[k];
        double *worst = &m->outcome->momentum_error; /* once NaN, it stays */
        if (m->invariant[k].is_momentum && !isnan(*worst) && !(fabs(deviation[k]) <= *worst))
            *worst = fabs(deviation[k]);
    }
    if (sampled) {
        m->next_sample += m->sample_every;
        sample(m, t, energy_error, deviation);
    }
    if (sampled || step == m->outcome->steps) {
        double row[COLUMNS];
        struct travel_tally tally;
        if (travel_tally(m->travel, &tally))
            m->verdict.h = tally.longest;
        verdict_row(&m->verdict, t, bodies, row);
    }
    verdict_step(&m->verdict, bodies);
    return 0;
}

static void measures_end(struct measures *m)
{
    struct outcome *o = m->outcome;
    const double norm_squared = reference_norm_squared(m->reference, m->t_end);
    const double energy_norm = (m->energy0 != 0.0 ? fabs(m->energy0) : 1.0) * sqrt(m->t_end);
    o->e_error = sqrt(vti_integral_value(&m->energy_squared)) / energy_norm;
    o->q_error = sqrt(fabs(vti_integral_value(&m->norms.norm_squared) - norm_squared) / norm_squared);
    o->h1_error = sqrt(vti_integral_value(&m->norms.error_squared) / norm_squared);
    o->attitude_error = m->norms.attitude_error;
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

void outcome_of(const struct scene *scene, const struct trial *trial, int64_t compare_every,
                struct reference *reference, int (*poll)(void *self, int64_t step), void *poll_self,
                struct outcome *outcome)
{
    enum { POLL_EVERY = 2048 };
    struct trial_run run;
    struct measures measures;
    struct poller poller = {poll, poll_self, 0};
    const struct observer observers[] = {{measure, &measures, 1, 0}, {poll_see, &poller, POLL_EVERY, 0}};

    memset(outcome, 0, sizeof *outcome);
    outcome->steps = trial->steps;
    outcome->failed = trial_begin(&run, scene, trial, &outcome->message) != 0;
    if (outcome->failed)
        return;
    struct trial taken = *trial; /* where the scene has a tolerance, the stepper that keeps it */
    taken.stepper = run.travel.stepper;
    outcome->failed = measures_begin(&measures, &run.model, reference, &taken, compare_every, outcome) != 0;
    measures.travel = &run.travel;
    measures.watch = (struct watch){poll_on_the_way, &poller};
    if (!outcome->failed)
        outcome->failed = trial_go(&run, trial->steps, observers, poll != NULL ? 2 : 1, &outcome->message) != 0;
    if (!outcome->failed)
        measures_end(&measures);
    outcome->seconds = run.seconds;
    outcome->force_evals =
        taken.stepper->evals > 0 ? trial->steps * taken.stepper->evals : travel_force_evals(&run.travel);
    verdict_destroy(&measures.verdict);
    norms_destroy(&measures.norms);
    trial_end(&run);
}
