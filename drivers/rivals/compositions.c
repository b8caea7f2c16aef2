/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Symplectic methods of order 4 from kicks and drifts, attitudes by the exponential map.
 *
 * "pefrl" is the position-extended Forest-Ruth-like scheme, the usual choice of order 4 in molecular dynamics: I. P.
 * Omelyan, I. M. Mryglod, R. Folk, Optimized Forest-Ruth- and Suzuki-like algorithms for integration of motion in
 * many-body systems, Comput. Phys. Commun. 146, 188 (2002):
 *
 *     drift(xi h) kick((1 - 2 lambda) h/2) drift(chi h) kick(lambda h) drift((1 - 2 (chi + xi)) h) and mirrored
 *
 * "takahashi-imada" is M. Takahashi, M. Imada, Monte Carlo calculation of quantum systems II. Higher order correction,
 * J. Phys. Soc. Jpn. 53, 3765 (1984), with the gradient of the force's square by a force at displaced bodies as G.
 * Rowlands, A numerical algorithm for Hamiltonian systems, J. Comput. Phys. 97, 235 (1991), has it:
 *
 *     drift(h/2) kick(h; forces at x + (h^2/12) F/m and attitudes turned by (h^2/12) RM/J) drift(h/2)
 *
 * Alone it is of order 2. Its error is that of order 4 in other variables, to which a processor leads before the first
 * step and from which it leads back where somebody looks: J. Wisdom, M. Holman, J. Touma, Symplectic correctors, Fields
 * Inst. Commun. 10, 217 (1996). With A = drift, B = kick, the step is e^{-P} e^{h(A+B) + O(h^5)} e^P, P =
 * (h^2/24)[A,B], and e^{4ab [A,B]} = A(a) B(b) A(-2a) B(-2b) A(2a) B(b) A(-a) + O(h^4). The way back is taken by a copy
 * that is left behind, so that neither the path nor the number of evaluations depends on how often somebody looks. */
#include <string.h>

#include "rates.h"
#include "verlet.h"

/** Forces, and a kick by them. */
static int kick(struct course *c, double t)
{
    const int status = course_forces(c);
    if (status == VTI_OK)
        rival_kick_all(c, t, 0, c->n);
    return status;
}

/* ---- PEFRL ------------------------------------------------------------------------------------------------------- */

static const double xi = 0.1786178958448091, lambda = -0.2123418310626054, chi = -0.06626458266981849;

static int pefrl_step(struct course *c)
{
    enum { KICKS = 4 };
    const double drifts[KICKS] = {chi, 1.0 - 2.0 * (chi + xi), chi, xi};
    const double kicks[KICKS] = {0.5 - lambda, lambda, lambda, 0.5 - lambda};
    rates_drift(c, xi * c->h);
    for (int k = 0; k < KICKS; ++k) {
        const int status = kick(c, kicks[k] * c->h);
        if (status != VTI_OK)
            return status;
        rates_drift(c, drifts[k] * c->h);
    }
    return VTI_OK;
}

static int pefrl(struct course *c, int64_t steps)
{
    return rates_steps(c, steps, pefrl_step);
}

const struct rival rival_pefrl = {
    .stepper = RIVAL_STEPPER("pefrl", 4, 0.0, 4, NAN,
                             "position-extended Forest-Ruth-like, exponential map (Omelyan, Mryglod, Folk 2002)"),
    .go = pefrl,
};

/* ---- Takahashi and Imada ----------------------------------------------------------------------------------------- */

/** Own: the bodies, what is shown of them, and room for positions and attitudes. */
enum { STATES = 3 };

/** Of a course: evaluations on the way to what is shown. */
enum { SHOW_EVALS };

static double *state_at(const struct course *c, int k)
{
    return c->own + k * rates_width(c);
}

/** A(a) B(b) A(-2a) B(-2b) A(2a) B(b) A(-a) */
static int process(struct course *c, double a, double b)
{
    int status;
    rates_drift(c, a);
    status = kick(c, b);
    rates_drift(c, -2.0 * a);
    if (status == VTI_OK)
        status = kick(c, -2.0 * b);
    rates_drift(c, 2.0 * a);
    if (status == VTI_OK)
        status = kick(c, b);
    rates_drift(c, -a);
    return status;
}

/** Forces of bodies that are displaced by t^2 times their accelerations, which are that of no velocity: a drift in
 *  which these stand for velocities. The bodies come back. */
static int displaced_forces(struct course *c, double t2)
{
    double *const kept = state_at(c, 2), *const now = state_at(c, 0);
    const size_t size = (size_t)rates_width(c) * sizeof *kept;
    int status = course_forces(c);
    if (status != VTI_OK)
        return status;
    memcpy(kept, now, size);
    if (c->x != NULL)
        memset(c->v, 0, (size_t)(3 * c->n) * sizeof *c->v);
    if (c->q != NULL)
        memset(c->w, 0, (size_t)(3 * c->n) * sizeof *c->w);
    rival_kick_all(c, t2, 0, c->n);
    rates_drift(c, 1.0);
    status = course_forces(c);
    memcpy(now, kept, size);
    return status;
}

static int step(struct course *c)
{
    const double h = c->h;
    rates_drift(c, 0.5 * h);
    const int status = displaced_forces(c, h * h / 12.0);
    rival_kick_all(c, h, 0, c->n);
    rates_drift(c, 0.5 * h);
    return status;
}

/** The same bodies in the variables that they are shown in. */
static int lead_back(struct course *c)
{
    const int64_t evals = c->evals;
    memcpy(state_at(c, 1), state_at(c, 0), (size_t)rates_width(c) * sizeof *c->own);
    rates_live_in(c, state_at(c, 1));
    const int status = process(c, 0.25 * c->h, c->h / 24.0);
    rates_live_in(c, state_at(c, 0));
    c->number[SHOW_EVALS] = (double)(c->evals - evals);
    return status;
}

static int takahashi_imada(struct course *c, int64_t steps)
{
    int status = VTI_OK;
    rates_live_in(c, state_at(c, 0));
    c->evals -= (int64_t)c->number[SHOW_EVALS];
    if (c->steps == 0)
        status = process(c, 0.25 * c->h, -c->h / 24.0);
    if (status == VTI_OK)
        status = rates_steps(c, steps, step);
    return status == VTI_OK ? lead_back(c) : status;
}

static int prepare(struct course *c, struct message *message)
{
    (void)message;
    rates_start(c, state_at(c, 0));
    memcpy(state_at(c, 1), state_at(c, 0), (size_t)rates_width(c) * sizeof *c->own);
    return 0;
}

static void show(struct course *c)
{
    rates_look_at(c, state_at(c, 1));
}

const struct rival rival_takahashi_imada = {
    .stepper =
        RIVAL_STEPPER("takahashi-imada", 4, 0.0, 2, 3.4641016151377544,
                      "processed step with a displaced force, exponential map (Takahashi and Imada 1984; Rowlands "
                      "1991)"),
    .own_width = STATES * RATES_WIDTH,
    .prepare = prepare,
    .go = takahashi_imada,
    .show = show,
};
