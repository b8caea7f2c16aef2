/* SPDX-License-Identifier: BSD-3-Clause */
#include "rival.h"

#include <math.h>
#include <stdlib.h>

#include "cut.h"
#include "number.h"
#include "rivals.h"

static const struct rival *const rivals[] = {
    &rival_quat_euler,
    &rival_campello,
    &rival_lammps,
    &rival_mercury,
    &rival_yade_exp_verlet,
    &rival_yade_leapfrog,
    &rival_spiral,
    &rival_omelyan,
    &rival_lgvi,
    &rival_gear,
    &rival_pefrl,
    &rival_takahashi_imada,
    &rival_rk4,
    &rival_rk8pd,
    &rival_rk8pd_adaptive,
    &rival_pd8,
    &rival_dop853,
    &rival_dop853_adaptive,
    &rival_vern9,
    &rival_abm6,
    &rival_abm8,
    &rival_abm10,
    &rival_abm12,
    &rival_gbs8,
    &rival_gbs12,
    &rival_verlet_x8,
    &rival_verlet_x12,
};

enum { RIVALS = sizeof rivals / sizeof rivals[0] };

static const struct rival *const unlisted[] = {&rival_campello_0, &rival_campello_1, &rival_abm4};

enum { UNLISTED = sizeof unlisted / sizeof unlisted[0] };

static const struct rival *const general[] = {
    &rival_no_squish,
    &rival_asphere,
    &rival_fincham,
    &rival_yade_aspherical,
    &rival_buss,
    &rival_moser_veselov,
    &rival_moser_veselov_newton,
    &rival_midpoint,
    &rival_spiral_body,
};

enum { GENERAL = sizeof general / sizeof general[0] };

int64_t rival_count(void)
{
    return RIVALS;
}

const struct rival *rival_at(int64_t i)
{
    return i >= 0 && i < RIVALS ? rivals[i] : NULL;
}

const struct rival *rival_unlisted(int64_t i)
{
    return i >= 0 && i < UNLISTED ? unlisted[i] : NULL;
}

const struct rival *rival_general(int64_t i)
{
    return i >= 0 && i < GENERAL ? general[i] : NULL;
}

/* ---- a course ---------------------------------------------------------------------------------------------------- */

/** 1/m of one value or of n into *next, which moves on. */
static vti_scalars inverse(const vti_scalars *of, int64_t n, double **next)
{
    const vti_scalars none = {NULL, 0, 0}, result = {*next, of->stride == 0 ? 0 : 1, 0};
    if (of->p == NULL)
        return none;
    const int64_t count = of->stride == 0 ? 1 : n;
    for (int64_t i = 0; i < count; ++i)
        (*next)[i] = 1.0 / of->p[i * of->stride];
    *next += count;
    return result;
}

/** The model's attitudes as quaternions, and a view on those in place of alpha. */
static void take_attitudes(struct course *c)
{
    const vti_view alpha = c->bodies.alpha;
    for (int64_t i = 0; i < c->n; ++i) {
        const double a[3] = {alpha.c[0][i * alpha.stride], alpha.c[1][i * alpha.stride], alpha.c[2][i * alpha.stride]};
        vti_rrv_to_quat_xyzw(a, c->q + 4 * i);
    }
    c->bodies.alpha = vti_view_none();
    for (int k = 0; k < 4; ++k)
        c->bodies.quat.xyzw[k] = c->q + k;
    c->bodies.quat.stride = 4;
}

static int take_model(struct course *c, struct model *model)
{
    enum { QUATERNION = 4, INVERSES = 2 };
    c->model = model;
    c->bodies = model->bodies;
    c->n = model->bodies.count;
    c->memory_doubles = COURSE_NUMBERS + (QUATERNION + INVERSES + c->rival->own_width) * c->n;
    c->memory = calloc((size_t)c->memory_doubles, sizeof *c->memory);
    if (c->memory == NULL)
        return -1;
    double *const q = c->memory + COURSE_NUMBERS, *next = q + QUATERNION * c->n;
    c->number = c->memory;
    c->own = next + INVERSES * c->n;
    c->per_mass = inverse(&model->bodies.mass, c->n, &next);
    c->per_inertia = inverse(&model->bodies.inertia, c->n, &next);
    c->x = model->bodies.x.c[0];
    c->v = model->bodies.v.c[0];
    c->f = model->bodies.force.c[0];
    c->w = model->bodies.omega.c[0];
    c->m = model->bodies.moment.c[0];
    c->L = model->bodies.spin.c[0];
    if (model->turns) {
        c->q = q;
        take_attitudes(c);
    }
    return vti_bodies_seal(&c->bodies) == VTI_OK ? 0 : -1;
}

struct course *course_create(const struct rival *rival, struct model *model, double h, struct message *message)
{
    struct course *c = calloc(1, sizeof *c);
    scene_no_memory(model->scene, message);
    if (c == NULL)
        return NULL;
    c->rival = rival;
    c->h = h;
    if (take_model(c, model) == 0 && (rival->prepare == NULL || rival->prepare(c, message) == 0)) {
        message->text[0] = '\0';
        return c;
    }
    course_destroy(c);
    return NULL;
}

void course_destroy(struct course *c)
{
    if (c == NULL)
        return;
    if (c->rival->dismiss != NULL)
        c->rival->dismiss(c);
    free(c->memory);
    free(c);
}

/** Forces at the bodies' positions; at t = 0 velocities also move to where the rival keeps them. */
static int start(struct course *c)
{
    const int status = c->rival->takes_forces ? course_forces(c) : VTI_OK;
    c->begun = 1;
    return status != VTI_OK || c->rival->stepper.lag == 0.0 || c->steps > 0
               ? status
               : vti_kick(-c->rival->stepper.lag * c->h, &c->bodies);
}

static int refused(const struct course *c, int status, struct message *message)
{
    if (status == VTI_E_TOO_LARGE)
        return message_set(message, "%s at h = %s: t = %.6g: body %lld has h|Omega| = %.6g; %s", c->rival->stepper.name,
                           NUMBER(c->h), (double)c->steps * c->h, (long long)c->fault.body, c->fault.value,
                           vti_status_text(status));
    if (status == RIVAL_E_DIVERGES)
        return message_set(message, "%s at h = %s: t = %.6g: its iteration does not converge; take a smaller h",
                           c->rival->stepper.name, NUMBER(c->h), (double)c->steps * c->h);
    if (status == RIVAL_E_SPARSE)
        return message_set(message,
                           "%s at h = %s: t = %.6g: within a step bodies come to turn so much more slowly that no "
                           "next one can be chosen; take a smaller h",
                           c->rival->stepper.name, NUMBER(c->h), (double)c->steps * c->h);
    if (status == RIVAL_E_FINE)
        return message_set(message,
                           "%s at h = %s: t = %.6g: steps become shorter than 2^-26 h, and a run ends and is kept at "
                           "multiples of h alone; give a larger turning or tolerance, or a smaller h",
                           c->rival->stepper.name, NUMBER(c->h), (double)c->steps * c->h);
    if (status == RIVAL_E_SHORT)
        return message_set(
            message,
            "%s at h = %s: t = %.9g: the shortest step, 2^-26 h = %.3g, errs by more than the tolerance; "
            "give a smaller h or a larger tolerance",
            c->rival->stepper.name, NUMBER(c->h), c->fault.value, CUT_SHORTEST * c->h);
    if (status == RIVAL_E_LATE)
        return message_set(message,
                           "%s at h = %s: t = %.6g: the next step is so short that t would stay what it is; end the "
                           "run sooner, or ask for less accuracy or longer steps",
                           c->rival->stepper.name, NUMBER(c->h), (double)c->steps * c->h);
    return message_set(message, "%s at h = %s: t = %.6g: %s", c->rival->stepper.name, NUMBER(c->h),
                       (double)c->steps * c->h, model_text(c->model, status));
}

int course_fastest(struct course *c, double *most, struct message *message)
{
    vti_stable stable;
    vti_deformation at = model_deformation(c->model, &c->model->bodies);
    at.strain = 0.0;
    at.meet = 0; /* what is fast here, not what may become so */
    if (model_stable_step(c->model, &c->model->bodies, &at, &stable, message) != 0)
        return -1;
    const double fastest = fmax(2.0 * c->h / stable.h, vti_max_turn(c->h, &c->bodies));
    *most = fastest > 0.0 ? fastest : 1.0;
    return 0;
}

int course_longest(struct course *c, double gap, struct message *message)
{
    const int result = model_longest_gap(c->model, &c->longest, message);
    c->longest /= gap;
    c->gap = gap;
    return result;
}

int course_begin(struct course *c, struct message *message)
{
    if (!c->begun && c->rival->resume != NULL)
        c->rival->resume(c);
    const int status = c->begun ? VTI_OK : start(c);
    return status == VTI_OK ? 0 : refused(c, status, message);
}

int course_go(struct course *c, int64_t steps, struct message *message)
{
    int status = VTI_OK;
    if (steps <= 0)
        return 0;
    if (!c->begun)
        status = start(c);
    if (status == VTI_OK)
        status = c->rival->go(c, steps);
    return status == VTI_OK ? 0 : refused(c, status, message);
}

const vti_bodies *course_bodies(struct course *c)
{
    if (c->rival->show != NULL)
        c->rival->show(c);
    return &c->bodies;
}
