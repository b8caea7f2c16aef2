/* SPDX-License-Identifier: BSD-3-Clause
 * The verdict on runs: of those that blow up to finite numbers it is bad, of sane ones it is not, and of 300 scenes of
 * random physics at 0.05 to 3 times the stable step it is bad where a reference run says so. test_verdict SCENES
 * [SANE] */
#define _POSIX_C_SOURCE 200809L
#include "hard.h"
#include "random_scene.h"
#include "verdict.h"

static const char *folder;
static int sane_scenes = 200;

/* ---- runs -------------------------------------------------------------------------------------------------------- */

enum { ROWS = 256 };

struct judged {
    struct verdict verdict;
    struct columns columns;
    struct judgement judgement;
    struct message line;
    int broken;
    int64_t rows, steps;
    double total[ROWS + 2];
};

static int see_row(void *self, int64_t step, double t, const vti_bodies *bodies)
{
    struct judged *j = self;
    double row[COLUMNS];
    verdict_row(&j->verdict, t, bodies, row);
    j->total[j->rows++] = row[j->columns.total];
    (void)step;
    return !isfinite(row[j->columns.total]);
}

static int see_step(void *self, int64_t step, double t, const vti_bodies *bodies)
{
    struct judged *j = self;
    (void)step;
    verdict_step(&j->verdict, t, bodies);
    return 0;
}

/** Runs the model of the scene to its end in steps of h, with a row every so many of them. */
static void judge(const struct scene *scene, double h, int64_t steps, int64_t every, struct judged *j)
{
    static struct model model;
    struct message message;
    memset(j, 0, sizeof *j);
    if (model_create(scene, &model, &message) != 0)
        fail_msg("%s", message.text);
    columns_of(&model, scene->stepper, &j->columns);
    if (verdict_create(&j->verdict, &model, scene->stepper, h, &j->columns, &message) != 0)
        fail_msg("%s", message.text);
    const struct observer observers[] = {{see_step, j, 1, 1, NULL, NULL}, {see_row, j, every, 0, NULL, NULL}};
    j->broken = loop_run(&model, scene->stepper, h, 0, steps, observers, 2, &message) != 0;
    j->judgement = verdict_judge(&j->verdict, j->broken, &j->line);
    verdict_destroy(&j->verdict);
    model_destroy(&model);
}

static struct scene scene;
static struct judged judged;

/** The scene as its text says. */
static const struct judgement *judge_text(const char *text)
{
    struct message message;
    write_text("t.yaml", text);
    if (scene_read("t.yaml", NULL, 0, &scene, &message) != 0)
        fail_msg("%s", message.text);
    const int64_t steps = loop_steps(scene.t_end, scene.h);
    judge(&scene, scene.h, steps, steps / ROWS + 1, &judged);
    return &judged.judgement;
}

/** A shipped scene with overrides. */
static const struct judgement *judge_shipped(const char *name, const char *const *sets, int n)
{
    char path[1024];
    struct message message;
    snprintf(path, sizeof path, "%s/%s.yaml", folder, name);
    if (scene_read(path, sets, n, &scene, &message) != 0)
        fail_msg("%s", message.text);
    const int64_t steps = loop_steps(scene.t_end, scene.h);
    judge(&scene, scene.h, steps, steps / ROWS + 1, &judged);
    return &judged.judgement;
}

/* ---- scenes as they are shipped ---------------------------------------------------------------------------------- */

TEST(shipped)
{
    static const char *const names[] = {"pendulum", "spin", "chain", "block", "pile", "torus", "torus-printed"};
    for (size_t k = 0; k < sizeof names / sizeof names[0]; ++k) {
        if (judge_shipped(names[k], NULL, 0)->verdict != VERDICT_GOOD)
            fail_msg("%s: %s", names[k], judged.line.text);
    }
    robust("scenes as shipped", "verdict", "good");
}

/* ---- what was seen to blow up ------------------------------------------------------------------------------------ */

static void assert_bad(const char *what, const struct judgement *j, double factor)
{
    if (j->verdict != VERDICT_BAD || strchr(judged.line.text, '\n') != NULL)
        fail_msg("%s: %s", what, judged.line.text);
    /* and it is the energy that tells, where that has grown */
    if (!judged.broken && factor > 0.0 && !(judged.verdict.found.highest > factor * judged.verdict.found.first))
        fail_msg("%s: energy from %g to %g only", what, judged.verdict.found.first, judged.verdict.found.highest);
}

TEST(blow_ups)
{
    static const char chain[] = "bodies:\n  chain: {count: 10, spacing: 1}\n  mass: 1\n  random: {seed: 7, v: 0.01}\n"
                                "binder: {axial: 200}\nh: 0.2\nt_end: 20\n";
    static const char block[] = "bodies:\n  lattice: {counts: [6, 4, 4], spacing: 1, corner: [1.6, 0, 0]}\n  mass: 1\n"
                                "  v: [-4, 0, 0]\nbinder: {moment: 10, axial: 20, shear: {stiffness: 200}}\n"
                                "wall: {stiffness: 2100, planes: [[1, 0.2, 0, 1]]}\nh: 0.01\nt_end: 20\n";
    static const char lattice[] =
        "bodies:\n  lattice: {counts: [3, 3, 3], spacing: 2, corner: [0, 0, 0]}\n  diameter: 1\n"
        "  mass: 1\n  random: {seed: 1, v: 1}\ncontact: {stiffness: 1e6}\nh: 0.02\nt_end: 20\n";
    static const char *const torus[] = {"h=0.00749"}, *const far_chain[] = {"bodies.chain.start=[1e15,0,0]"};
    assert_bad("chain at 2.8 of its stable step", judge_text(chain), 1e100);
    assert_bad("torus at 2.03 of its stable step", judge_shipped("torus", torus, 1), 1e4);
    assert_bad("block at v = -4", judge_text(block), 1e3);
    assert_bad("chain at 1e15", judge_shipped("chain", far_chain, 1), 10);
    assert_bad("27 spheres that do not touch yet", judge_text(lattice), 50);
    robust("energy that grows to finite numbers: bonds, contacts and walls above the stable step, bodies at 1e15",
           "verdict", "bad");
}

/** So far out that the spheres of the ring round to the same places. */
TEST(too_far)
{
    static const char *const far[] = {"bodies.ring.center=[1e17,0,0]"};
    static struct model model;
    char path[1024];
    struct message message;
    snprintf(path, sizeof path, "%s/torus.yaml", folder);
    assert_int_equal(scene_read(path, far, 1, &scene, &message), 0);
    assert_int_equal(model_create(&scene, &model, &message), -1);
    assert_string_equal(message.text,
                        "torus: the centres of bodies 0 and 40 give no direction to their contact; move one of them");
    robust("spheres at 1e17, where centres round to the same place", "start of a run",
           "reported: the centres of bodies 0 and 40 give no direction to their contact; move one of them");
}

/** A linear oscillator above its limit keeps H~ to the last bit, so that H has to tell. */
TEST(linear)
{
    static const char *const format = "bodies: {inertia: 1, alpha: [1e-6, 0, 0], omega: [0, 0, 0]}\n"
                                      "pendulum: {weight: 1, rho0: [0, 0, 1]}\nh: %s\nt_end: 100\n";
    char text[TEXT_SIZE];
    snprintf(text, sizeof text, format, "2.05");
    assert_bad("pendulum at 1.025", judge_text(text), 0.0);
    snprintf(text, sizeof text, format, "1.9");
    if (judge_text(text)->verdict != VERDICT_GOOD)
        fail_msg("pendulum at 0.95: %s", judged.line.text);
    robust("a linear oscillator at 1.025 and 0.95 of its limit", "verdict", "bad, good");
}

/* ---- too fast ---------------------------------------------------------------------------------------------------- */

TEST(travel)
{
    static const char pair[] = "bodies:\n  chain: {count: 2, spacing: 20}\n  diameter: 1\n  mass: 1\n%s"
                               "contact: {stiffness: 1e6}\nh: 0.01\nt_end: 1\n";
    static const char wall[] = "bodies: {x: [%d, 0, 0], v: [-1e6, 0, 0], mass: 1, diameter: 1}\n"
                               "wall: {stiffness: 1e6, planes: [[1, 0, 0, 0]]}\nh: 1e-4\nt_end: 0.01\n";
    char text[TEXT_SIZE];
    struct message lines[VERDICT_WARNINGS];
    static struct model model;
    write_text("pair.csv", "x,y,z,vx,vy,vz\n0,0,0,500,0,0\n20.1,0,0,-500,0,0\n");
    static const char passing[] = "bodies: {table: pair.csv, mass: 1, diameter: 1}\ncontact: {stiffness: 1}\n"
                                  "h: 0.01\nt_end: 1\n";
    assert_bad("two spheres at 500", judge_text(passing), 0.0);
    assert_close(judged.judgement.travel, 5.0, 1e-9);
    make_model(passing, &scene, &model);
    columns_of(&model, scene.stepper, &judged.columns);
    assert_int_equal(verdict_create(&judged.verdict, &model, scene.stepper, scene.h, &judged.columns, &lines[0]), 0);
    assert_int_equal(verdict_warnings(&judged.verdict, &model.bodies, lines), 1);
    assert_non_null(strstr(lines[0].text, "moves by 5 diameters"));
    verdict_destroy(&judged.verdict);
    model_destroy(&model);
    for (int x = 3; x < 12; ++x) {
        snprintf(text, sizeof text, wall, x);
        assert_bad("wall at 1e6", judge_text(text), 0.0);
    }
    /* what slides along a slope, by 0.026 diameters a step at the end, comes no nearer to it */
    static const char *const slides[] = {"friction.sliding=0.1"};
    if (judge_shipped("incline", slides, 1)->verdict != VERDICT_GOOD)
        fail_msg("sliding: %s", judged.line.text);
    /* what flies together does not meet */
    snprintf(text, sizeof text, pair, "  v: [1e6, 0, 0]\n");
    if (judge_text(text)->verdict != VERDICT_GOOD)
        fail_msg("together: %s", judged.line.text);
    robust("two spheres, or a sphere and a wall, meet at 5 and 100 diameters per step", "verdict",
           "bad, and a warning at the start");
}

/** Two spheres that meet between two rows, at 5 each: 25 of energy, where the contact holds 2/5 K. */
TEST(between_rows)
{
    static const char pair[] = "bodies: {table: far.csv, mass: 1, diameter: 1}\ncontact: {stiffness: %s}\n"
                               "h: %s\nt_end: 200\n";
    char text[TEXT_SIZE];
    write_text("far.csv", "x,y,z,vx,vy,vz\n-3.3,0,0,5,0,0\n3.3,0,0,-5,0,0\n");
    snprintf(text, sizeof text, pair, "10", "0.002");
    assert_int_equal(judge_text(text)->verdict, VERDICT_DOUBTFUL);
    assert_true(judged.judgement.overlap > 0.7 && strstr(judged.line.text, "what meets may pass through") != NULL);
    snprintf(text, sizeof text, pair, "1e6", "0.002");
    (void)judge_text(text);
    const double deepest = pow(25.0 / 4e5, 0.4), two_by_omega = 2.0 / sqrt(2.0 * 1.5e6 * sqrt(deepest));
    assert_true(judged.judgement.overlap > 0.7 * deepest && judged.judgement.overlap < 1.05 * deepest);
    assert_true(judged.judgement.stable_step > 0.95 * two_by_omega &&
                judged.judgement.stable_step < 1.1 * two_by_omega);
    assert_close(judged.verdict.found.share, 0.002 / judged.judgement.stable_step, 1e-9);
    robust("two spheres that meet between two rows, deeper than half of their contact", "verdict", "doubtful");
}

/* ---- random scenes ----------------------------------------------------------------------------------------------- */

static const char *const steppers[] = {"vti1",  "vti2",    "vti2",  "vti3",   "exact",
                                       "exact", "suzuki4", "srkn6", "srkn11", "chin4"};
enum { STEPPERS = sizeof steppers / sizeof steppers[0] };

/** The scene of the generator, and the stable step of it. */
static double random_one(rng *g)
{
    static char text[TEXT_SIZE];
    static struct model model;
    random_scene(g, steppers, STEPPERS, text);
    make_model(text, &scene, &model);
    const double bound = random_bound(&model);
    model_destroy(&model);
    return bound;
}

TEST(sane)
{
    rng g = rng_seed(11);
    int alarms = 0;
    for (int k = 0; k < sane_scenes; ++k) {
        const double bound = random_one(&g);
        judge(&scene, bound * uniform(&g, 0.1, 0.5), 2000, 8, &judged);
        /* VTI-1 refuses h|Omega| >= 1, which a program says with an error */
        const int refused =
            judged.broken && judged.judgement.energy_gain < 0.25 && scene.stepper->law == VTI_LAW_CLOSED;
        alarms += judged.judgement.verdict == VERDICT_BAD && scene.stepper->order == 1;
        if (judged.judgement.verdict == VERDICT_BAD && !refused && scene.stepper->order > 1) {
            char text[TEXT_SIZE];
            read_bytes("t.yaml", text);
            fail_msg("scene %d: %s\n%s", k, judged.line.text, text);
        }
    }
    /* vti3 swings in first order (verdict.h) */
    print_message("%d false alarms, all of vti3\n", alarms);
    assert_in_range(alarms, 0, sane_scenes / 500);
    robust("200 sane random scenes at 0.1 to 0.5 of the stable step (2000 in the long test)", "verdict", "never bad");
}

/** What becomes of a run, by its reference. */
enum { KEPT, BETWEEN, WRONG, TRUTHS };

static int truth(const struct judged *run, const struct judged *reference)
{
    const double allowed = 0.25 * reference->judgement.energy_scale;
    double most = run->broken || run->rows != reference->rows ? INFINITY : 0.0;
    for (int64_t k = 0; k < run->rows && k < reference->rows; ++k) {
        const double off = fabs(run->total[k] - reference->total[k]);
        most = off <= most ? most : off;
    }
    return most <= allowed ? KEPT : most <= 10.0 * allowed ? BETWEEN : WRONG;
}

TEST(error_rates)
{
    enum { SCENES = 300, FINER = 16 };
    static const char *const words[TRUTHS] = {"kept within what the verdict allows", "off by 1 to 10 times that",
                                              "off by more than 10 times that, or the run broke off"};
    static struct judged reference;
    int called[TRUTHS][VERDICT_BAD + 1] = {{0}};
    rng g = rng_seed(300);
    for (int k = 0; k < SCENES; ++k) {
        const double bound = random_one(&g);
        const double h = bound * (rng_below(&g, 3) == 0 ? uniform(&g, 0.05, 1.0) : uniform(&g, 1.0, 3.0));
        judge(&scene, h, ROWS, 1, &judged);
        judge(&scene, h / FINER, ROWS * FINER, FINER, &reference);
        if (reference.broken || reference.judgement.verdict == VERDICT_BAD)
            fail_msg("scene %d has no reference: %s", k, reference.line.text);
        const int what = truth(&judged, &reference);
        ++called[what][judged.judgement.verdict];
        if ((what == WRONG) != (judged.judgement.verdict == VERDICT_BAD) && what != BETWEEN) {
            char text[TEXT_SIZE];
            read_bytes("t.yaml", text);
            print_error("scene %d at %.3g of its stable step, %s: %s\n%s", k, h / bound, words[what], judged.line.text,
                        text);
        }
    }
    for (int what = 0; what < TRUTHS; ++what) {
        char name[128];
        snprintf(name, sizeof name, "300 random scenes at 0.05 to 3 of the stable step; energy %s", words[what]);
        robust(name, "verdict", "of %d: %d good, %d doubtful, %d bad",
               called[what][0] + called[what][1] + called[what][2], called[what][0], called[what][1], called[what][2]);
    }
    assert_int_equal(called[KEPT][VERDICT_BAD], 0);
    assert_int_equal(called[WRONG][VERDICT_GOOD] + called[WRONG][VERDICT_DOUBTFUL], 0);
    /* both kinds are there in numbers */
    assert_true(called[KEPT][VERDICT_GOOD] > 50 && called[WRONG][VERDICT_BAD] > 50);
}

int main(int argc, char **argv)
{
    folder = argc > 1 ? argv[1] : "scenes";
    if (argc > 2)
        sane_scenes = (int)strtol(argv[2], NULL, 10);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shipped), cmocka_unit_test(blow_ups),    cmocka_unit_test(too_far),
        cmocka_unit_test(linear),  cmocka_unit_test(travel),      cmocka_unit_test(between_rows),
        cmocka_unit_test(sane),    cmocka_unit_test(error_rates),
    };
    return cmocka_run_group_tests(tests, enter_directory, leave_directory);
}
