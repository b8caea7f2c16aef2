/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The seam: what methods there are, what a travel counts, refuses and leaves out, and that looking changes nothing. */
#include "journey.h"

#include "scene_stepper.h"

/* ---- the list ---------------------------------------------------------------------------------------------------- */

TEST(list)
{
    int64_t spatial = 0;
    method_admit();
    for (int64_t i = 0; i < vti_stepper_count(); ++i)
        spatial += vti_stepper_at(i)->frame == VTI_FRAME_SPACE;
    assert_int_equal(method_count(), spatial + vti_multistep_count() + rival_count());
    assert_null(method_at(-1));
    assert_null(method_at(method_count()));
    assert_null(rival_at(-1));
    assert_null(rival_at(rival_count()));
    assert_null(multistep_at(-1));
    assert_null(multistep_at(vti_multistep_count()));
    assert_null(method_find("nobody"));
    assert_null(method_find(NULL));
    assert_null(method_find("vti1-body"));
    for (int64_t i = 0; i < method_count(); ++i) {
        const vti_stepper *m = method_at(i);
        assert_ptr_equal(method_find(m->name), m); /* no two of one name */
        const vti_multistep *multistep = vti_multistep_find(m->name);
        assert_int_equal((vti_stepper_find(m->name) != NULL) + (multistep != NULL) + (method_rival(m) != NULL), 1);
        if (multistep != NULL)
            assert_int_equal(m->order, multistep->depth + (multistep->u == 0.0));
        assert_ptr_equal(scene_stepper_find(m->name), m); /* and scenes may name it */
        assert_true(strlen(m->about) > 0 && strchr(m->about, '\n') == NULL);
        assert_true(m->order > 0);
        assert_string_equal(method_kind(m), method_rival(m) != NULL           ? "rival"
                                            : strncmp(m->name, "vti", 3) == 0 ? "paper"
                                                                              : "ours");
    }
    for (int64_t i = 0; rival_unlisted(i) != NULL; ++i) { /* these are found by name alone */
        const vti_stepper *m = method_of(rival_unlisted(i)->stepper.name);
        assert_ptr_equal(method_rival(m), rival_unlisted(i));
        for (int64_t k = 0; k < method_count(); ++k)
            assert_true(method_at(k) != m);
    }
    assert_null(rival_unlisted(-1));
    assert_string_equal(method_kind(method_of("exact")), "ours");
    assert_string_equal(method_kind(method_of("an7")), "ours");
    assert_string_equal(method_kind(method_of("vti3-leapfrog")), "paper");
    assert_string_equal(method_kind(method_of("mercury")), "rival");
}

/* ---- force evaluations ------------------------------------------------------------------------------------------- */

static int64_t evals_of(const char *name, const char *where, double h, int64_t steps)
{
    struct scene scene;
    struct journey j;
    read_scene(where, &scene);
    begin(&j, &scene, method_of(name), h);
    assert_int_equal(travel_force_evals(&j.travel), 0);
    go(&j, steps);
    const int64_t evals = travel_force_evals(&j.travel);
    end(&j);
    return evals;
}

TEST(force_evals)
{
    static const char *const once[] = {
        "vti2",   "exact",   "quat-euler", "lammps-richardson", "mercury", "yade-exp-verlet", "yade-leapfrog",
        "spiral", "omelyan", "lgvi"};
    for (size_t i = 0; i < sizeof once / sizeof once[0]; ++i)
        assert_int_equal(evals_of(once[i], "chain", 1.0 / 512, 20), 21);
    assert_int_equal(evals_of("srkn11", "chain", 1.0 / 64, 20), 1 + 11 * 20);
    assert_int_equal(evals_of("chin4", "chain", 1.0 / 64, 20), 1 + 3 * 20);
    /* K - 1 steps back: up to four of two, or of an10-mid six of six, and then of one */
    assert_int_equal(evals_of("an4", "chain", 1.0 / 64, 20), 1 + 3 * 2 + 20);
    assert_int_equal(evals_of("an7", "chain", 1.0 / 64, 20), 1 + 4 * 2 + 2 + 20);
    assert_int_equal(evals_of("an9", "chain", 1.0 / 64, 20), 1 + 4 * 2 + 4 + 20);
    assert_int_equal(evals_of("an10-mid", "chain", 1.0 / 64, 20), 1 + 6 * 6 + 3 + 20);
    assert_int_equal(evals_of("an7", "chain", 1.0 / 64, 3), 1 + 4 * 2 + 2 + 3);
    assert_int_equal(evals_of("rk4", "chain", 1.0 / 512, 20), 80);
    assert_int_equal(evals_of("rk8pd", "chain", 1.0 / 64, 20), 260);
    static const struct {
        const char *name;
        int64_t evals;
    } others[] = {{"pd8", 13 * 20},
                  {"dop853", 12 * 20},
                  {"vern9", 15 * 20},
                  {"gbs8", 17 * 20},
                  {"gbs12", 37 * 20},
                  {"verlet-x8", 10 * 20},
                  {"verlet-x12", 21 * 20},
                  {"pefrl", 4 * 20},
                  {"takahashi-imada", 3 + 2 * 20 + 3},
                  /* K - 1 steps of DOP853, the slope after them, and two or one in each further step */
                  {"abm4", 2 * 12 + 1 + 2 * 18},
                  {"abm6", 4 * 12 + 1 + 2 * 16},
                  {"abm8", 6 * 12 + 1 + 2 * 14},
                  {"abm10", 8 * 12 + 1 + 2 * 12},
                  {"abm12", 10 * 12 + 1 + 2 * 10},
                  {"gear", 3 * 12 + 1 + 17}};
    for (size_t i = 0; i < sizeof others / sizeof others[0]; ++i)
        assert_int_equal(evals_of(others[i].name, "chain", 1.0 / 512, 20), others[i].evals);
    for (int64_t k = 0; k < rival_count(); ++k) { /* whoever adds a rival says how often it evaluates forces */
        static const char *const alone[] = {"rk4", "rk8pd", "campello", "rk8pd-adaptive", "dop853-adaptive"};
        const char *const name = rival_at(k)->stepper.name;
        int found = 0;
        for (size_t i = 0; i < sizeof once / sizeof once[0]; ++i)
            found |= strcmp(once[i], name) == 0;
        for (size_t i = 0; i < sizeof others / sizeof others[0]; ++i)
            found |= strcmp(others[i].name, name) == 0;
        for (size_t i = 0; i < sizeof alone / sizeof alone[0]; ++i)
            found |= strcmp(alone[i], name) == 0;
        if (!found)
            fail_msg("nothing says how often %s evaluates forces", name);
    }
    /* no loads: the first iteration settles it; the pendulum's contract by (h omega)^2/2 = 2^-13 or so each */
    assert_int_equal(evals_of("campello", "spin", 1.0 / 64, 20), 21);
    const int64_t iterated = evals_of("campello", "pendulum", 1.0 / 64, 20);
    assert_true(iterated >= 1 + 3 * 20 && iterated <= 1 + 4 * 20);
    /* steps of about h, of thirteen evaluations, some of them refused */
    const int64_t adaptive = evals_of("rk8pd-adaptive", "chain", 1.0 / 64, 64);
    assert_true(adaptive > 13 * 64 / 2 && adaptive < 13 * 64 * 2);
    assert_true(evals_of("rk8pd-adaptive", "chain", 1.0 / 128, 128) > 3 * adaptive / 2);
    const int64_t dop853 = evals_of("dop853-adaptive", "chain", 1.0 / 64, 64);
    assert_true(dop853 > 12 * 64 / 2 && dop853 < 12 * 64 * 2);
    assert_true(evals_of("dop853-adaptive", "chain", 1.0 / 128, 128) > 3 * dop853 / 2);
}

/* ---- looking ----------------------------------------------------------------------------------------------------- */

static void assert_same_view(const vti_view *a, const vti_view *b, int64_t n)
{
    assert_true((a->c[0] == NULL) == (b->c[0] == NULL));
    for (int64_t i = 0; i < n && a->c[0] != NULL; ++i)
        for (int k = 0; k < 3; ++k)
            assert_same_bits(&a->c[k][i * a->stride], &b->c[k][i * b->stride], 1);
}

static void assert_same_bodies(struct journey *one, struct journey *other)
{
    const vti_bodies a = travel_bodies(&one->travel), b = travel_bodies(&other->travel);
    assert_same_view(&a.x, &b.x, a.count);
    assert_same_view(&a.v, &b.v, a.count);
    assert_same_view(&a.omega, &b.omega, a.count);
    assert_same_view(&a.alpha, &b.alpha, a.count);
    for (int k = 0; k < 4 && a.quat.xyzw[k] != NULL; ++k)
        for (int64_t i = 0; i < a.count; ++i)
            assert_same_bits(&a.quat.xyzw[k][i * a.quat.stride], &b.quat.xyzw[k][i * b.quat.stride], 1);
}

/** A travel in three legs, looked at after each, ends with the bits and the count of one that nobody stopped. */
static void assert_undisturbed(const vti_stepper *method, const char *where, double h)
{
    struct scene scene;
    struct journey whole, legs;
    read_scene(where, &scene);
    begin(&whole, &scene, method, h);
    begin(&legs, &scene, method, h);
    go(&whole, 60);
    go(&legs, 0);
    travel_bodies(&legs.travel);
    go(&legs, 7);
    travel_bodies(&legs.travel);
    travel_bodies(&legs.travel);
    go(&legs, 23);
    go(&legs, 30);
    assert_same_bodies(&whole, &legs);
    assert_int_equal(travel_force_evals(&whole.travel), travel_force_evals(&legs.travel));
    end(&whole);
    end(&legs);
}

/* ---- observers --------------------------------------------------------------------------------------------------- */

/** What one of them saw last, and when. */
struct eye {
    int64_t calls, step;
    double t, x, v, alpha, omega, sum; /* x and v of body 1; sum over all calls of the steps */
};

static int see(void *self, int64_t step, double t, const vti_bodies *b)
{
    struct eye *eye = self;
    const struct eye now = {eye->calls + 1,
                            step,
                            t,
                            b->x.c[0][b->x.stride],
                            b->v.c[0][b->v.stride],
                            b->alpha.c[0][b->alpha.stride],
                            b->omega.c[0][b->omega.stride],
                            eye->sum + (double)step};
    *eye = now;
    return step == 42;
}

/** Steps 0, 5, 10, ..., and the last; the same state as travel_bodies tells, with the attitude as alpha. */
TEST(observed)
{
    for (int64_t i = 0; i < method_count(); ++i) {
        struct scene scene;
        struct journey j;
        struct eye eye = {0, 0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, seventh = eye;
        const struct observer observers[] = {{see, &eye, 5, 0, NULL, NULL}, {see, &seventh, 7, 1, NULL, NULL}};
        read_scene("chain", &scene);
        begin(&j, &scene, method_at(i), 1.0 / 512);
        assert_int_equal(travel_show(&j.travel, 23, observers, 2, &j.message), 0);
        assert_int_equal(eye.calls, 6);
        assert_close(eye.sum, 5 + 10 + 15 + 20 + 23, 0.0);
        assert_close(seventh.sum, 7 + 14 + 21 + 23, 0.0);
        assert_close(eye.t, 23.0 / 512, 0.0);
        const vti_bodies b = travel_bodies(&j.travel);
        assert_same_bits(&eye.x, &b.x.c[0][b.x.stride], 1);
        assert_same_bits(&eye.v, &b.v.c[0][b.v.stride], 1);
        assert_same_bits(&eye.omega, &b.omega.c[0][b.omega.stride], 1);
        const rotor q = quat_unit(attitude_of(&b, 1));
        assert_close(eye.alpha, 2.0 * q.x / q.w, 1e-12);
        assert_int_equal(travel_show(&j.travel, 77, observers, 2, &j.message), 1); /* stopped at step 42 */
        assert_int_equal(eye.step, 40);
        end(&j);
    }
}

enum { GLANCES = 24 };

/** Body 1 at every step, and who looks at its velocities only every few. */
struct glance {
    int64_t every, asked, calls;
    double place[GLANCES][2], speed[GLANCES][2];
    double whole[GLANCES][2]; /* speeds with what the model owes them */
    const struct model *model;
};

static int glance_looks(void *self, int64_t step)
{
    struct glance *g = self;
    ++g->asked;
    return step % g->every == 0;
}

/** Kicks copies of body 1's velocities over what is owed. */
static void make_whole(const struct glance *g, const vti_bodies *b, double whole[2])
{
    double v[3][2], omega[3][2];
    vti_bodies copy = *b;
    copy.sealed = 0;
    copy.first = copy.count = 1;
    copy.v = (vti_view){{v[0], v[1], v[2]}, 1, 0};
    copy.omega = (vti_view){{omega[0], omega[1], omega[2]}, 1, 0};
    copy.v_low = copy.omega_low = vti_view_none();
    for (int c = 0; c < 3; ++c) {
        v[c][1] = b->v.c[c][b->v.stride];
        omega[c][1] = b->omega.c[c][b->omega.stride];
    }
    if (g->model->owed != 0.0)
        assert_int_equal(vti_kick(g->model->owed, &copy), VTI_OK);
    whole[0] = v[0][1];
    whole[1] = omega[0][1];
}

static int glance_see(void *self, int64_t step, double t, const vti_bodies *b)
{
    struct glance *g = self;
    (void)t;
    ++g->calls;
    make_whole(g, b, g->whole[step]);
    g->place[step][0] = b->x.c[0][b->x.stride];
    g->place[step][1] = b->alpha.c[0][b->alpha.stride];
    g->speed[step][0] = b->v.c[0][b->v.stride];
    g->speed[step][1] = b->omega.c[0][b->omega.stride];
    return 0;
}

static void glance_at(const vti_stepper *method, const char *where, double h, int (*looks)(void *self, int64_t step),
                      struct glance *g)
{
    struct scene scene;
    struct journey j;
    const struct observer observer = {glance_see, g, 1, 0, looks, NULL};
    read_scene(where, &scene);
    begin(&j, &scene, method, h);
    g->model = &j.model;
    assert_int_equal(travel_show(&j.travel, GLANCES - 1, &observer, 1, &j.message), 0);
    assert_int_equal(g->calls, GLANCES);
    end(&j);
}

/** Steps that are joined have the same places, and the same velocities where somebody looks and at the end; others are
 *  of neither step. Steppers that may not be joined, and scenes that dissipate, have whole steps all along. */
static void assert_joined(const vti_stepper *method, const char *where, double h, int joins)
{
    struct glance whole = {.every = 1}, few = {.every = 5};
    int64_t others = 0;
    glance_at(method, where, h, NULL, &whole);
    glance_at(method, where, h, glance_looks, &few);
    assert_same_bits(few.place[0], whole.place[0], 2 * GLANCES);
    assert_same_bits(few.whole[0], whole.speed[0], 2 * GLANCES);
    assert_same_bits(whole.whole[0], whole.speed[0], 2 * GLANCES); /* whole steps owe nothing */
    for (int k = 0; k < GLANCES; ++k)
        if (k % 5 == 0 || k == GLANCES - 1 || !joins)
            assert_same_bits(few.speed[k], whole.speed[k], 2);
        else
            others += few.speed[k][0] != whole.speed[k][0] || few.speed[k][1] != whole.speed[k][1];
    assert_int_equal(others, joins ? GLANCES - 6 : 0);
}

TEST(joined)
{
    for (int64_t i = 0; i < method_count(); ++i) {
        const vti_stepper *m = vti_stepper_find(method_at(i)->name);
        const int joins = m != NULL && m->law != VTI_LAW_CLOSED && m->drift[m->stages] == 0.0 && m->lag == 0.0 &&
                          m->probe == NULL && m->kick[m->stages] != 0.0;
        assert_joined(method_at(i), "chain", 1.0 / 512, joins);
    }
    assert_joined(vti_stepper_find("vti2"), "chain", 1.0 / 512, 1);
    assert_joined(vti_stepper_find("srkn6"), "chain", 1.0 / 512, 1);
}

TEST(looking)
{
    for (int64_t i = 0; i < method_count(); ++i) {
        assert_undisturbed(method_at(i), "pendulum", 1.0 / 16);
        assert_undisturbed(method_at(i), "chain", 1.0 / 512);
    }
    for (int64_t i = 0; tolerance_at(i) != NULL; ++i) {
        assert_undisturbed(&tolerance_at(i)->stepper, "pendulum", 1.0 / 16);
        assert_undisturbed(&tolerance_at(i)->stepper, "chain", 1.0 / 64);
    }
}

/** When to keep the bodies, and where. */
struct keeper {
    int64_t step;
    double *bodies;
};

/** x, v, alpha and omega as kept, as a checkpoint has them. */
static int keep(void *self, int64_t step, double t, const vti_bodies *b)
{
    const vti_view *const views[] = {&b->x, &b->v, &b->alpha, &b->omega};
    const struct keeper *keeper = self;
    double *p = keeper->bodies;
    (void)t;
    for (int v = 0; v < 4 && step == keeper->step; ++v)
        for (int64_t i = 0; views[v]->c[0] != NULL && i < b->count; ++i)
            for (int k = 0; k < 3; ++k)
                *p++ = views[v]->c[k][i * views[v]->stride];
    return 0;
}

static void put(const double *p, const vti_bodies *b)
{
    const vti_view *const views[] = {&b->x, &b->v, &b->alpha, &b->omega};
    for (int v = 0; v < 4; ++v)
        for (int64_t i = 0; views[v]->c[0] != NULL && i < b->count; ++i)
            for (int k = 0; k < 3; ++k)
                views[v]->c[k][i * views[v]->stride] = *p++;
}

/** From a checkpoint at that step a fresh travel ends with the bits of one that was not interrupted. */
static void assert_resumes(const vti_stepper *method, const char *where, double h, int64_t at)
{
    struct scene scene;
    struct journey whole, first, second;
    int64_t count, again;
    read_scene(where, &scene);
    begin(&whole, &scene, method, h);
    begin(&first, &scene, method, h);
    begin(&second, &scene, method, h);
    go(&whole, 60);
    const size_t n = (size_t)(12 * first.model.bodies.count);
    double *bodies = calloc(n, sizeof *bodies);
    struct keeper keeper = {at, bodies};
    const struct observer observer = {keep, &keeper, 1, 1, NULL, NULL};
    assert_int_equal(travel_show(&first.travel, 30, &observer, 1, &first.message), 0);
    end(&first);
    begin(&first, &scene, method, h);
    go(&first, at);
    const double *state = travel_state(&first.travel, &count);
    double *mine = travel_state(&second.travel, &again);
    assert_int_equal(count, again);
    assert_true((count == 0) == (vti_stepper_find(method->name) != NULL));
    if (count > 0)
        memcpy(mine, state, (size_t)count * sizeof *mine);
    put(bodies, &second.model.bodies);
    travel_resume(&second.travel, at);
    go(&second, 60 - at);
    assert_same_bodies(&whole, &second);
    free(bodies);
    end(&whole);
    end(&first);
    end(&second);
}

TEST(resumed)
{
    for (int64_t i = 0; i < method_count(); ++i) {
        assert_resumes(method_at(i), "pendulum", 1.0 / 16, 25);
        assert_resumes(method_at(i), "chain", 1.0 / 512, 25);
        assert_resumes(method_at(i), "pile", 1.0 / 2048, 25);
        assert_resumes(method_at(i), "chain", 1.0 / 512, 2); /* where multistep methods have not yet begun */
    }
}

/** Before the first step, and after it in time: a lagging method is read at t, not half a step before. */
TEST(reading)
{
    for (int64_t i = 0; i < method_count(); ++i) {
        struct scene scene;
        struct journey start, j;
        read_scene("pendulum", &scene);
        begin(&j, &scene, method_at(i), 1e-7);
        begin(&start, &scene, method_of("vti2"), 1e-7);
        vti_bodies a = travel_bodies(&start.travel), b = travel_bodies(&j.travel);
        assert_true(b.x.c[0] == NULL && b.v.c[0] == NULL && b.omega.c[0] != NULL);
        assert_below(attitude_distance(&a, &b), 2.0 * EPS);
        assert_below(velocity_distance(&a, &b), 0.0);
        go(&start, 3);
        go(&j, 3);
        a = travel_bodies(&start.travel);
        b = travel_bodies(&j.travel);
        assert_below(velocity_distance(&a, &b), method_at(i)->order == 1 ? 2e-7 : 1e-13);
        end(&start);
        end(&j);
    }
}

/* ---- absent physics ---------------------------------------------------------------------------------------------- */

/** Chain without what turns it, or spheres without any effect: nothing has an attitude, and flight is straight. */
TEST(no_rotation)
{
    for (int64_t i = 0; i < method_count(); ++i) {
        struct scene scene;
        struct journey j, other;
        read_scene("chain", &scene);
        *number_setting(&scene, "binder.moment") = *number_setting(&scene, "binder.shear.stiffness") = 0.0;
        scene.random.omega = 0.0;
        scene.turns = 0;
        begin(&j, &scene, method_at(i), 1.0 / 512);
        begin(&other, &scene, method_of("kl8"), 1.0 / 512);
        go(&j, 100);
        go(&other, 100);
        const vti_bodies b = travel_bodies(&j.travel), exact = travel_bodies(&other.travel);
        assert_null(b.alpha.c[0]);
        assert_null(b.quat.xyzw[0]);
        assert_null(b.omega.c[0]);
        assert_below(view_distance(&b.v, &exact.v, b.count), method_at(i)->order == 1 ? 3e-2 : 2e-3);
        assert_below(view_distance(&b.x, &exact.x, b.count), 1e-3);
        end(&other);
        end(&j);
    }
}

TEST(free_flight)
{
    for (int64_t i = 0; i < method_count(); ++i) {
        struct scene scene;
        struct journey j;
        read_scene("pile", &scene);
        memset(scene.has, 0, sizeof scene.has);
        begin(&j, &scene, method_at(i), 0.125);
        const vti_bodies *start = &j.model.bodies;
        const double x = start->x.c[0][0], v = start->v.c[0][0];
        go(&j, 80);
        const vti_bodies b = travel_bodies(&j.travel);
        assert_null(b.omega.c[0]);
        /* the weights of old slopes and of extrapolated results are large, and so is what is rounded */
        assert_close(b.x.c[0][0], x + 10.0 * v, method_at(i)->order < 5 ? 1e-13 : 1e-12);
        assert_close(b.v.c[0][0], v, 0.0);
        end(&j);
    }
}

/** A pile of 128: contacts that come and go, and the seams of blocks would show. */
TEST(contacts)
{
    for (int64_t i = 0; i < method_count(); ++i) {
        struct scene scene;
        struct journey j;
        read_scene("pile", &scene);
        begin(&j, &scene, method_at(i), strcmp(method_at(i)->name, "abm12") == 0 ? 1.0 / 4096 : 1.0 / 2048);
        const double before = model_energy(&j.model, &j.model.bodies);
        go(&j, 1000);
        const vti_bodies b = travel_bodies(&j.travel);
        assert_true(((const vti_contacts *)acting(&j.model, "contact"))->count > 0);
        assert_close(model_energy(&j.model, &b) / before, 1.0, method_at(i)->order == 1 ? 0.1 : 1e-4);
        end(&j);
    }
}

/* ---- refusals ---------------------------------------------------------------------------------------------------- */

/** The first step is refused with that line. */
static void assert_refused(const char *name, const char *where, double h, const char *line)
{
    struct scene scene;
    struct journey j;
    read_scene(where, &scene);
    begin(&j, &scene, method_of(name), h);
    assert_int_equal(travel_go(&j.travel, 10, &j.message), -1);
    assert_string_equal(j.message.text, line);
    end(&j);
}

TEST(refusals)
{
    static const double wrong[] = {0.0, -1.0, NAN, INFINITY};
    char line[512];
    struct scene scene;
    struct model model;
    struct travel travel;
    struct message message;
    snprintf(line, sizeof line, "lgvi at h = 1: t = 0: body 0 has h|Omega| = 1; %s", vti_status_text(VTI_E_TOO_LARGE));
    assert_refused("lgvi", "spin", 1.0, line);
    assert_refused("campello", "chain", 0.5,
                   "campello at h = 0.5: t = 0: its iteration does not converge; take a smaller h");
    read_scene("spin", &scene);
    make_model(&scene, &model);
    for (size_t k = 0; k < sizeof wrong / sizeof wrong[0]; ++k) {
        assert_int_equal(travel_create(&travel, method_of("mercury"), &model, wrong[k], &message), -1);
        assert_non_null(strstr(message.text, "mercury: h = "));
        assert_int_equal(travel_create(&travel, method_of("vti2"), &model, wrong[k], &message), -1);
    }
    model_destroy(&model);
}

RUN_TESTS_OF_SCENES(cmocka_unit_test(list), cmocka_unit_test(force_evals), cmocka_unit_test(looking),
                    cmocka_unit_test(reading), cmocka_unit_test(no_rotation), cmocka_unit_test(free_flight),
                    cmocka_unit_test(contacts), cmocka_unit_test(refusals), cmocka_unit_test(observed),
                    cmocka_unit_test(joined), cmocka_unit_test(resumed))
