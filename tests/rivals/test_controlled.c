/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Steps by a tolerance through the seam of the programs: where they lead does not depend on who looks, errors go with
 * the tolerance, touches make steps short, momenta stay, and what cannot be served is refused. */
#define _POSIX_C_SOURCE 200809L

#include "journey.h"

#include "scratch.h"

/** A journey of the scene with that tolerance to step steps of h. */
static struct travel_tally arrive(struct journey *j, const char *where, const char *name, double tolerance, double h,
                                  int64_t steps)
{
    struct scene scene;
    struct travel_tally tally;
    read_scene(where, &scene);
    scene.tolerance = tolerance;
    begin(j, &scene, method_of(name), h);
    go(j, steps);
    assert_int_equal(travel_tally(&j->travel, &tally), 1);
    return tally;
}

TEST(names)
{
    static const char *const base[] = {"srkn11", "srkn14", "srkn6"};
    for (int64_t i = 0; i < 3; ++i) {
        const vti_stepper *way = &tolerance_at(i)->stepper;
        assert_ptr_equal(method_controlled(method_of(base[i])), way);
        assert_ptr_equal(method_controlled(way), way);
        assert_ptr_equal(method_of(way->name), way);
        assert_string_equal(method_kind(way), "ours");
        assert_int_equal(way->order, method_of(base[i])->order);
    }
    assert_null(tolerance_at(-1));
    assert_null(tolerance_at(3));
    assert_null(method_controlled(method_of("vti2")));
    assert_null(method_controlled(method_of("an9")));
}

/** The chain at t = 4 against the reference of studies: a factor of 1000 in the tolerance is more than 30 in errors,
 *  and the estimate is above the true error of a step. */
TEST(errors_go_with_the_tolerance)
{
    for (int64_t i = 0; i < 3; ++i) {
        double error[2][2], *truth = NULL;
        vti_bodies reference;
        for (int level = 0; level < 2; ++level) {
            struct journey j;
            const double tolerance = level == 0 ? 1e-5 : 1e-8;
            const struct travel_tally tally =
                arrive(&j, "chain", tolerance_at(i)->stepper.name, tolerance, 1.0 / 4, 16);
            if (truth == NULL)
                reference = reference_of(&j.scene, 4.0, &truth);
            const vti_bodies b = travel_bodies(&j.travel);
            error[level][0] = attitude_distance(&b, &reference);
            error[level][1] = velocity_distance(&b, &reference);
            print_message("%s, tolerance %g: %d steps, %d undone: attitudes to %.2e, velocities to %.2e\n",
                          tolerance_at(i)->stepper.name, tolerance, (int)tally.accepted, (int)tally.rejected,
                          error[level][0], error[level][1]);
            assert_true(error[level][0] < 4.0 * tolerance && error[level][1] < 40.0 * tolerance);
            end(&j);
        }
        free(truth);
        assert_true(error[1][0] < error[0][0] / 30 && error[1][1] < error[0][1] / 30);
    }
}

/** Evaluations are those of all steps that were tried, and of the last look. */
TEST(tally)
{
    struct journey one, many;
    const struct travel_tally a = arrive(&one, "chain", "srkn11", 1e-6, 1.0 / 16, 64);
    assert_close(a.tolerance, 1e-6, 0);
    assert_true(a.accepted > 10 && a.cut >= 1 && a.longest > 0.0);
    assert_int_equal(a.evals, 1 + 11 * (a.accepted + a.rejected + a.cut));
    assert_int_equal(travel_force_evals(&one.travel), a.evals);
    struct travel_tally b = arrive(&many, "chain", "srkn11-tol", 1e-6, 1.0 / 16, 1);
    for (int k = 1; k < 64; ++k)
        go(&many, 1);
    travel_tally(&many.travel, &b);
    assert_int_equal(b.accepted, a.accepted);
    assert_int_equal(b.rejected, a.rejected);
    assert_true(b.cut >= 64);
    assert_int_equal(travel_force_evals(&many.travel), a.evals); /* what looking costs is not counted there */
    end(&one);
    struct travel_tally none;
    begin(&one, &one.scene, method_of("srkn11-tol"), 1.0 / 16);
    assert_int_equal(travel_tally(&one.travel, &none), 1);
    end(&one);
    one.scene.tolerance = 0.0;
    begin(&one, &one.scene, method_of("exact"), 1.0 / 16);
    assert_int_equal(travel_tally(&one.travel, &none), 0);
    end(&one);
    end(&many);
}

/** Errors are taken in units of the scene's speed and turning: of both, that is another tolerance. */
TEST(units)
{
    struct scene scene;
    struct journey one, other, less;
    read_scene("chain", &scene);
    scene.tolerance = 1e-6;
    begin(&one, &scene, method_of("srkn11"), 1.0 / 4);
    scene.tolerance = 1e-6 / 8;
    scene.speed = scene.turning = 8.0;
    begin(&other, &scene, method_of("srkn11"), 1.0 / 4);
    scene.turning = 0.0; /* of the angular velocity, 1 */
    begin(&less, &scene, method_of("srkn11"), 1.0 / 4);
    go(&one, 16);
    go(&other, 16);
    go(&less, 16);
    const vti_bodies a = travel_bodies(&one.travel), b = travel_bodies(&other.travel), c = travel_bodies(&less.travel);
    assert_same_bits(a.omega.c[0], b.omega.c[0], (size_t)(3 * a.count)); /* 8 is a power of two */
    assert_true(memcmp(a.omega.c[0], c.omega.c[0], (size_t)(3 * a.count) * sizeof(double)) != 0);
    assert_true(less.travel.course->evals > one.travel.course->evals);
    end(&one);
    end(&other);
    end(&less);
}

/** What an observer of each look finds. */
struct watched {
    double p[3], l[3], off;
    int64_t looks;
};

static int see(void *self, int64_t step, double t, const vti_bodies *b)
{
    struct watched *w = self;
    static const double origin[3] = {0, 0, 0};
    double p[3], l[3];
    (void)t;
    vti_momentum(b, p);
    vti_angular_momentum(b, origin, l);
    for (int k = 0; k < 3; ++k) {
        w->p[k] = step == 0 ? p[k] : w->p[k];
        w->l[k] = step == 0 ? l[k] : w->l[k];
        w->off = fmax(w->off, fmax(fabs(p[k] - w->p[k]), fabs(l[k] - w->l[k])));
    }
    ++w->looks;
    return 0;
}

TEST(momenta)
{
    struct scene scene;
    struct journey j;
    struct watched w = {.looks = 0};
    const struct observer observer = {see, &w, 1, 0, NULL, NULL};
    read_scene("chain", &scene);
    scene.tolerance = 1e-8;
    begin(&j, &scene, method_of("srkn11"), 1.0 / 8);
    assert_int_equal(travel_show(&j.travel, 80, &observer, 1, &j.message), 0);
    assert_int_equal(w.looks, 81);
    assert_close(w.off, 0, 1e-12); /* rounding of some thousand stages */
    end(&j);
}

/** On the torus bodies meet: steps are undone there, and are made shorter. */
TEST(touches)
{
    struct journey j;
    const struct travel_tally tally = arrive(&j, "torus", "srkn11", 1e-6, 1.0 / 8, 4);
    print_message("torus: %d steps, %d undone, the longest %.3g\n", (int)tally.accepted, (int)tally.rejected,
                  tally.longest);
    assert_true(tally.rejected > 10 && tally.accepted > tally.rejected);
    end(&j);
}

/** Two spheres that graze each other by a chord which fits between two evaluations, soft ones in steps that are far
 *  longer than they. */
static const struct chord {
    double stiffness, speed, offset, t_end;
    double h[2];      /* of equal steps that are known to be short enough, and between looks */
    double after;     /* the velocity across is less than that */
    double tolerance; /* by which velocities are then known */
} chords[] = {{5e6, 40.0, 0.999, 0.5, {0x1p-16, 0.25}, -0.01, 1e-5},
              {10.0, 5.0, 0.95, 5.0, {0x1p-12, 1.0}, -0.004, 2e-5}};

/** From so far away. */
static void graze(struct journey *j, const char *folder, const struct chord *c, const vti_stepper *method,
                  double tolerance, double h, double away)
{
    char path[SCENE_PATH_SIZE], table[SCENE_PATH_SIZE];
    snprintf(path, sizeof path, "%s/graze.yaml", folder);
    snprintf(table, sizeof table, "%s/graze.csv", folder);
    FILE *file = fopen(table, "w");
    assert_non_null(file);
    fprintf(file, "x,y,z,vx,vy,vz\n%.17g,0,0,%.17g,0,0\n%.17g,%.17g,0,%.17g,0,0\n", -away, c->speed, away, c->offset,
            -c->speed);
    fclose(file);
    file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file, "bodies: {table: graze.csv, mass: 1, diameter: 1}\ncontact: {stiffness: %.17g}\nh: 1\nt_end: 1\n",
            c->stiffness);
    fclose(file);
    if (scene_read(path, NULL, 0, &j->scene, &j->message) != 0)
        fail_msg("%s", j->message.text);
    j->scene.tolerance = tolerance;
    begin(j, &j->scene, method, h);
    go(j, loop_steps(c->t_end, h));
    remove(path);
    remove(table);
}

/** Velocities after it are those of short steps, wherever evaluations fall. */
TEST(grazing)
{
    struct journey j;
    char folder[SCENE_PATH_SIZE];
    double after[3];
    assert_true(scratch_make(folder, sizeof folder));
    for (const struct chord *c = chords; c < chords + sizeof chords / sizeof chords[0]; ++c) {
        graze(&j, folder, c, method_of("srkn6"), 0.0, c->h[0], 10.3);
        for (int k = 0; k < 3; ++k)
            after[k] = j.model.bodies.v.c[k][0];
        end(&j);
        assert_true(after[1] < c->after);
        for (int n = 0; n < 48; ++n) {
            graze(&j, folder, c, &tolerance_at(n % 2 * 2)->stepper, 1e-6, c->h[1], 10.3 + 0.03 * n);
            const vti_bodies b = travel_bodies(&j.travel);
            for (int k = 0; k < 3; ++k)
                assert_close(b.v.c[k][0], after[k], c->tolerance);
            end(&j);
        }
    }
    rmdir(folder);
}

static void assert_refused(const char *where, const char *name, double tolerance, const char *words)
{
    struct scene scene;
    read_scene(where, &scene);
    scene.tolerance = tolerance;
    assert_no_journey(&scene, name, words);
}

/** Thrown at a ceiling that gravity turns it back inside of. */
static void throw_up(struct journey *j, const char *folder, const vti_stepper *method, double tolerance, double h,
                     double speed)
{
    const double gravity = 2.0, deep = 0.01; /* the ceiling is at 0, the radius 1/2 */
    char path[SCENE_PATH_SIZE];
    snprintf(path, sizeof path, "%s/ceiling.yaml", folder);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file,
            "bodies: {x: [0, 0, %.17g], v: [0, 0, %.17g], mass: 1, diameter: 1}\n"
            "wall: {stiffness: 50, planes: [[0, 0, -1, 0]]}\ngravity: [0, 0, %g]\nh: 1\nt_end: 1\n",
            deep - 0.5 - 0.5 * speed * speed / gravity, speed, -gravity);
    fclose(file);
    if (scene_read(path, NULL, 0, &j->scene, &j->message) != 0)
        fail_msg("%s", j->message.text);
    j->scene.tolerance = tolerance;
    begin(j, &j->scene, method, h);
    go(j, loop_steps(2.0, h));
    remove(path);
}

/** It touches for less than the time between two evaluations, and comes back as by short steps, whenever it was
 *  thrown. */
TEST(ceiling)
{
    struct journey j;
    char folder[SCENE_PATH_SIZE];
    assert_true(scratch_make(folder, sizeof folder));
    for (int n = 0; n < 20; ++n) {
        const double speed = 1.75 + 0.03 * n;
        throw_up(&j, folder, method_of("srkn6"), 0.0, 0x1p-12, speed);
        const double after = j.model.bodies.v.c[2][0];
        end(&j);
        assert_true(after < speed - 4.0 - 0.01); /* as free flight has it, and the touch */
        for (int k = 0; k < 3; k += 2) {         /* srkn11 and srkn6 */
            throw_up(&j, folder, &tolerance_at(k)->stepper, 1e-7, 0.125, speed);
            assert_close(j.model.bodies.v.c[2][0], after, 1e-5);
            end(&j);
        }
    }
    rmdir(folder);
}

/** A tolerance below rounding is not met by any step. */
TEST(refused)
{
    assert_refused("chain", "vti2", 1e-6, "vti2 has no estimate of its error");
    assert_refused("chain", "an9", 1e-6, "take srkn11");
    assert_refused("chain", "rk8pd-adaptive", 1e-6, "no estimate");
    assert_refused("drum", "srkn11", 1e-6, "a step that is undone would have dissipated already");
    assert_refused("chain", "srkn11", 1e-20, "less than rounding leaves of velocities");
    assert_refused("torus", "srkn14", 1e-6, "begin and end with a drift");
    assert_refused("drum", "srkn11-tol", 0.0, "take vti2, vti1, exact or chin4");
}

TEST(wanted_sooner)
{
    for (int64_t i = 0; i < 3; ++i) {
        struct scene scene;
        read_scene("chain", &scene);
        scene.tolerance = 1e-8;
        assert_impatience_changes_nothing(&scene, &tolerance_at(i)->stepper);
    }
}

/** Where numbers are h apart, t does not move by the steps that the tolerance allows. */
TEST(too_late)
{
    enum { TIME = 1 }; /* of what a checkpoint has */
    const int64_t late = (int64_t)1 << 52;
    struct scene scene;
    struct journey j;
    int64_t doubles;
    read_scene("chain", &scene);
    scene.tolerance = 1e-8;
    begin(&j, &scene, method_of("srkn11"), 1.0 / 4);
    travel_state(&j.travel, &doubles)[TIME] = (double)late / 4.0;
    travel_resume(&j.travel, late);
    assert_int_equal(travel_go(&j.travel, 2, &j.message), -1);
    assert_non_null(strstr(j.message.text, "end the run sooner"));
    end(&j);
}

/** Where the shortest step is too long for the tolerance, its time and length are said, and that h sets it. */
TEST(too_short)
{
    struct scene scene;
    struct journey j;
    read_scene("chain", &scene);
    scene.tolerance = 1e-8;
    begin(&j, &scene, method_of("srkn11"), 0x1p30);
    assert_int_equal(travel_go(&j.travel, 2, &j.message), -1);
    assert_non_null(strstr(j.message.text,
                           "t = 0: the shortest step, 2^-26 h = 16, errs by more than the tolerance; give "
                           "a smaller h or a larger tolerance"));
    end(&j);
}

RUN_TESTS_OF_SCENES(cmocka_unit_test(names), cmocka_unit_test(errors_go_with_the_tolerance), cmocka_unit_test(tally),
                    cmocka_unit_test(units), cmocka_unit_test(momenta), cmocka_unit_test(touches),
                    cmocka_unit_test(grazing), cmocka_unit_test(ceiling), cmocka_unit_test(refused),
                    cmocka_unit_test(wanted_sooner), cmocka_unit_test(too_late), cmocka_unit_test(too_short))
