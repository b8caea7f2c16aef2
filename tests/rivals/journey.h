/* SPDX-License-Identifier: BSD-3-Clause
 * What the tests of rivals share: a scene's model with a method on its way through it. */
#ifndef VTI_TESTS_JOURNEY_H
#define VTI_TESTS_JOURNEY_H

#include "support.h"

#include "equations.h"
#include "travel.h"
#include "rival.h"
#include "settings.h"

/** The folder of the scenes, from the command line. */
static const char *scenes;

struct journey {
    struct scene scene;
    struct model model;
    struct travel travel;
    struct message message;
};

static inline void read_scene(const char *name, struct scene *scene)
{
    struct message message;
    char path[SCENE_PATH_SIZE];
    snprintf(path, sizeof path, "%s/%s.yaml", scenes, name);
    if (scene_read(path, NULL, 0, scene, &message) != 0)
        fail_msg("%s", message.text);
}

static inline void make_model(const struct scene *scene, struct model *model)
{
    struct message message;
    if (model_create(scene, model, &message) != 0)
        fail_msg("%s", message.text);
}

static inline const vti_stepper *method_of(const char *name)
{
    const vti_stepper *method = method_find(name);
    if (method == NULL)
        fail_msg("no method is called %s", name);
    return method;
}

/** The method is refused for the scene, in words that say this. */
static inline void assert_no_journey(const struct scene *scene, const char *name, const char *words)
{
    struct journey j = {.scene = *scene};
    make_model(&j.scene, &j.model);
    assert_int_equal(travel_create(&j.travel, method_of(name), &j.model, scene->h, &j.message), -1);
    if (strstr(j.message.text, words) == NULL)
        fail_msg("'%s' does not say '%s'", j.message.text, words);
    model_destroy(&j.model);
}

/** A journey through a model of the scene that has been made already. */
static inline void set_out(struct journey *j, const vti_stepper *method, double h)
{
    if (travel_create(&j->travel, method, &j->model, h, &j->message) != 0)
        fail_msg("%s", j->message.text);
}

static inline void begin(struct journey *j, const struct scene *scene, const vti_stepper *method, double h)
{
    j->scene = *scene;
    make_model(&j->scene, &j->model);
    set_out(j, method, h);
}

static inline void go(struct journey *j, int64_t steps)
{
    if (travel_go(&j->travel, steps, &j->message) != 0)
        fail_msg("%s", j->message.text);
}

static inline void end(struct journey *j)
{
    travel_destroy(&j->travel);
    model_destroy(&j->model);
}

/** The study's reference at t_end, as views on *state, which is to be freed. */
static inline vti_bodies reference_of(const struct scene *scene, double t_end, double **state)
{
    struct model model;
    struct equations equations;
    struct message message;
    double t = 0.0;
    make_model(scene, &model);
    *state = calloc((size_t)equations_width(&model), sizeof **state);
    assert_non_null(*state);
    equations_start(&model, *state);
    assert_int_equal(equations_create(&equations, &model, 1e-14, NULL, &message), 0);
    if (equations_advance(&equations, 0.0, &t, t_end, *state, &message) != 0)
        fail_msg("%s", message.text);
    const vti_bodies bodies = equations_bodies(&model, *state);
    equations_destroy(&equations);
    model_destroy(&model);
    return bodies;
}

/** The attitude of body i, whichever way it is held; not normalised. */
static inline rotor attitude_of(const vti_bodies *b, int64_t i)
{
    if (b->quat.xyzw[0] == NULL) {
        const double a[3] = {b->alpha.c[0][i * b->alpha.stride], b->alpha.c[1][i * b->alpha.stride],
                             b->alpha.c[2][i * b->alpha.stride]};
        return quat_of_alpha(a);
    }
    double *const *q = b->quat.xyzw;
    const int64_t k = i * b->quat.stride;
    const rotor r = {q[0][k], q[1][k], q[2][k], q[3][k]};
    return r;
}

/** Root of the sum of |a - b|^2, of views that are both there or both not. */
static inline double view_distance(const vti_view *a, const vti_view *b, int64_t n)
{
    double sum = 0.0;
    assert_true((a->c[0] == NULL) == (b->c[0] == NULL));
    for (int64_t i = 0; i < n && a->c[0] != NULL; ++i)
        for (int k = 0; k < 3; ++k) {
            const double d = a->c[k][i * a->stride] - b->c[k][i * b->stride];
            sum += d * d;
        }
    return sqrt(sum);
}

/** Attitude: the largest angle between the two; velocity: v and Omega of all bodies. */
static inline double attitude_distance(const vti_bodies *a, const vti_bodies *b)
{
    double most = 0.0;
    for (int64_t i = 0; i < a->count && a->omega.c[0] != NULL; ++i)
        most = fmax(most, quat_distance(quat_unit(attitude_of(a, i)), quat_unit(attitude_of(b, i))));
    return most;
}

static inline double velocity_distance(const vti_bodies *a, const vti_bodies *b)
{
    return hypot(view_distance(&a->v, &b->v, a->count), view_distance(&a->omega, &b->omega, a->count));
}

/** Errors at the end, of attitude and of velocity. */
static inline void journey_errors(const struct scene *scene, const vti_stepper *method, double h, int64_t steps,
                                  const vti_bodies *exact, double *attitude, double *velocity)
{
    struct journey j;
    begin(&j, scene, method, h);
    go(&j, steps);
    const vti_bodies b = travel_bodies(&j.travel);
    *attitude = attitude_distance(&b, exact);
    *velocity = velocity_distance(&b, exact);
    end(&j);
}

/* ---- steps of variable length that end sooner than at the next look ---------------------------------------------- */

/** Somebody who is due every 32 steps and wants to be called sooner at each third question. */
struct impatient {
    int64_t asked, calls, sooner, last;
};

static inline int impatient_see(void *self, int64_t step, double t, const vti_bodies *b)
{
    struct impatient *w = self;
    (void)t, (void)b;
    w->sooner += step % 32 != 0;
    assert_true(w->calls++ == 0 || step > w->last);
    w->last = step;
    return 0;
}

static inline int impatient_wants(void *self)
{
    return ++((struct impatient *)self)->asked % 3 == 0;
}

static inline int patient_see(void *self, int64_t step, double t, const vti_bodies *b)
{
    (void)self, (void)t, (void)b;
    assert_int_equal(step % 32, 0);
    return 0;
}

/** 64 steps with somebody who is impatient beside one who is not. */
static inline struct impatient go_with_impatient(struct journey *j)
{
    struct impatient w = {0, 0, 0, 0};
    const struct observer observers[] = {{impatient_see, &w, 32, 1, NULL, impatient_wants},
                                         {patient_see, NULL, 32, 0, NULL, NULL}};
    if (travel_show(&j->travel, 64, observers, 2, &j->message) != 0)
        fail_msg("%s", j->message.text);
    assert_true(w.sooner > 3 && w.calls == w.sooner + 3 && w.last == 64);
    return w;
}

/** ... and with nobody but one who looks as often: bodies, steps and evaluations are the same. */
static inline void assert_impatience_changes_nothing(const struct scene *scene, const vti_stepper *method)
{
    struct journey with, without;
    const struct observer observer = {patient_see, NULL, 32, 0, NULL, NULL};
    struct travel_tally a, b;
    begin(&with, scene, method, 1.0 / 16);
    begin(&without, scene, method, 1.0 / 16);
    go_with_impatient(&with);
    if (travel_show(&without.travel, 64, &observer, 1, &without.message) != 0)
        fail_msg("%s", without.message.text);
    assert_int_equal(travel_tally(&with.travel, &a) + travel_tally(&without.travel, &b), 2);
    const vti_bodies p = travel_bodies(&with.travel), q = travel_bodies(&without.travel);
    assert_same_bits(p.x.c[0], q.x.c[0], (size_t)(3 * p.count));
    assert_same_bits(p.omega.c[0], q.omega.c[0], (size_t)(3 * p.count));
    assert_true(a.accepted == b.accepted && a.rejected == b.rejected && a.cut == b.cut && a.evals == b.evals);
    assert_same_bits(&a.longest, &b.longest, 1);
    assert_int_equal(travel_force_evals(&with.travel), travel_force_evals(&without.travel));
    end(&with);
    end(&without);
}

/** A program of tests whose argument is the folder of the scenes. */
#define RUN_TESTS_OF_SCENES(...)                                                                                       \
    int main(int argc, char **argv)                                                                                    \
    {                                                                                                                  \
        const struct CMUnitTest tests[] = {__VA_ARGS__};                                                               \
        scenes = argc > 1 ? argv[1] : ".";                                                                             \
        return cmocka_run_group_tests(tests, NULL, NULL);                                                              \
    }

#endif
