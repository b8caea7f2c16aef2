/* SPDX-License-Identifier: BSD-3-Clause
 * Every mistake is named, and nothing else is; where one makes another meaningless, the first is. */
#include "support.h"

#include "faulty.h"

/** What a host does, and the sentences that are due: these and no others. */
struct expected {
    const char *name;
    struct faulty host;
    const char *sentence[4];
};

static const char late_v[] = "order 1: velocities are half a kick late";
static const char late_w[] = "order 1: spins are half a kick late";
static const char early_v[] = "order 1: velocities are half a kick early";
static const char early_w[] = "order 1: spins are half a kick early";
static const char old_v[] = "positions are pushed with the old velocity: energy grows";
static const char old_w[] = "rotation is pushed with the old spin: energy grows";
static const char no_half_f[] = "the half kick by the force at the start is missing";
static const char no_half_m[] = "the half kick by the moment at the start is missing";
static const char unprimed[] = "forces are not primed before the first step";
static const char wrong_side[] =
    "attitude increments act in the body's frame while spins and moments are spatial: they "
    "are composed in the wrong order";
static const char norm[] = "quaternion is not renormalised: its norm drifts";

static const char previous_m[] = "spins are kicked by the moment of the previous step: energy grows";
static const char previous_f[] = "velocities are kicked by the force of the previous step: energy grows";
static const char twice_f[] = "the kick by the force is applied twice";
static const char twice_m[] = "the kick by the moment is applied twice";
static const char mass_for_inertia[] = "the moment is divided by the mass where the inertia is meant";
static const char half_turn[] = "attitudes are lost at half a turn";
static const char body_moment[] = "moments are turned into the body's frame while spins are spatial";
static const char wrong_sign[] = "the moment enters with the wrong sign";
static const char frozen[] = "forces are evaluated once, at the start, and never again";
static const char disc[] = "the inertia is 1.25 times what it should be: 1/2 for 2/5?";
static const char sphere[] = "the inertia is 0.8 times what it should be: 2/5 for 1/2?";
static const char diameter[] = "the inertia is 4 times what it should be: a diameter for a radius?";
static const char one_percent[] = "the inertia is 1.01 times what it should be, or moments 0.9901 times";
static const char unit[] =
    "forces and moments are 1.1 times what they should be, or masses and inertias 0.90909 times: a unit?";
static const char force_only[] = "forces are 1.01 times what they should be, or masses 0.9901 times: a unit?";
static const char mass_8[] = "masses are 8 times what they should be: a diameter for a radius?";
static const char degrees[] = "a free spin turns by 0.017453 times what it should: degrees for radians?";
static const char double_turn[] = "a free spin turns by 2 times what it should: h omega for h omega/2 in a quaternion?";
static const char step[] = "the time step is 1.01 times what it should be";
static const char one_more[] = "the host takes one step too many";
static const char gravity[] = "a free body at rest gains a velocity of 9.81 per unit of time: is gravity on?";
static const char damped_w[] = "a free spin loses 0.0001 of itself in every step: damping?";

static const struct expected expected[] = {
    {"right", {.bits = 0}, {NULL}},
    {"old velocity", {.bits = OLD_VELOCITY}, {old_v}},
    {"old spin", {.bits = OLD_SPIN}, {old_w}},
    {"both", {.bits = OLD_VELOCITY | OLD_SPIN}, {old_v, old_w}},
    {"no first half kick", {.bits = NO_FIRST_HALF}, {no_half_f, no_half_m}},
    {"no first half kick, old spin", {.bits = NO_FIRST_HALF | OLD_SPIN}, {no_half_f, no_half_m, old_w}},
    {"not primed", {.bits = NOT_PRIMED}, {unprimed}},
    {"not primed, old velocity", {.bits = NOT_PRIMED | OLD_VELOCITY}, {unprimed, old_v}},
    {"wrong side", {.bits = WRONG_SIDE}, {wrong_side}},
    {"spin of the body, spatial moment",
     {.bits = BODY_SPIN},
     {"attitude increments act in the body's frame while moments are spatial: they kick a spin of the body's frame"}},
    {"moment of the body, spatial spin", {.bits = BODY_MOMENT}, {body_moment}},
    {"turns added up",
     {.bits = ADDED_TURNS},
     {"a free spin does not turn a body about omega: increments are added up, or a quaternion's order is another one"}},
    {"not normalised", {.bits = NOT_NORMALISED}, {norm}},
    {"wrong sign", {.bits = WRONG_SIGN}, {wrong_sign}},
    {"moment of the previous step", {.bits = PREVIOUS_MOMENT}, {previous_m}},
    {"force of the previous step", {.bits = PREVIOUS_FORCE}, {previous_f}},
    {"twice", {.bits = TWICE}, {twice_f, twice_m}},
    {"late", {.bits = LATE}, {late_v, late_w}},
    {"early", {.bits = EARLY}, {early_v, early_w}},
    {"explicit Euler",
     {.bits = EULER},
     {"explicit Euler: positions are pushed with the old velocity, and kicks are by the old force: energy grows",
      "explicit Euler: rotation is pushed with the old spin, and kicks are by the old moment: energy grows"}},
    {"late, not normalised", {.bits = LATE | NOT_NORMALISED}, {late_v, late_w, norm}},
    {"no inertia", {.bits = NO_INERTIA}, {"the moment is not divided by the inertia"}},
    {"mass for inertia", {.bits = MASS_FOR_INERTIA}, {mass_for_inertia}},
    {"inverse attitude", {.bits = INVERSE_ATTITUDE}, {"the attitude is taken for its inverse, space to body"}},
    {"double turn", {.turn = 2}, {double_turn}},
    {"half turn", {.bits = REFUSES_HALF_TURN}, {half_turn}},
    {"near half a turn", {.bits = NAN_NEAR_HALF_TURN}, {half_turn}},
    {"no force", {.bits = NO_FORCE}, {"the force does nothing"}},
    {"no rotation",
     {.bits = NO_ROTATION},
     {"the moment does nothing",
      "a free spin does not turn bodies (what moves positions only is checked by vti-check --translation)"}},
    {"previous loads", {.bits = PREVIOUS_FORCE | PREVIOUS_MOMENT}, {previous_f, previous_m}},
    {"stale loads",
     {.bits = STALE},
     {"velocities are kicked by a force that is 1.0 steps old: energy grows",
      "spins are kicked by a moment that is 1.0 steps old: energy grows"}},
    {"frozen loads", {.bits = FROZEN}, {frozen}},
    {"w first",
     {.bits = W_FIRST},
     {"a free spin does not turn a body about omega: increments are added up, or a quaternion's order is another one"}},
    {"swapped axes", {.bits = SWAPPED_FORCE}, {"the kick by a force has another direction than the force"}},
    {"force of the body",
     {.bits = BODY_FORCE},
     {"forces are turned into the body's frame while velocities are spatial"}},
    {"square of the mass", {.bits = FORCE_BY_MASS}, {"the kick by the force is not one number times force/mass"}},
    {"gravity", {.bits = GRAVITY}, {gravity}},
    {"damped spins", {.lost_w = 1e-4}, {damped_w}},
    {"damped velocities", {.lost_v = 1e-4}, {"a free velocity loses 0.0001 of itself in every step: damping?"}},
    /* constants */
    {"disc", {.inertia = 1.25}, {disc}},
    {"sphere for a disc", {.inertia = 0.8}, {sphere}},
    {"shell", {.inertia = 5.0 / 3}, {"the inertia is 1.6667 times what it should be: 2/3 for 2/5?"}},
    {"diameter", {.inertia = 4}, {diameter}},
    {"no 2/5", {.inertia = 2.5}, {"the inertia is 2.5 times what it should be: without the 2/5?"}},
    {"1 %", {.inertia = 1.01}, {one_percent}},
    {"1 % less", {.inertia = 0.99}, {"the inertia is 0.99 times what it should be, or moments 1.0101 times"}},
    {"unit", {.force = 1.1, .moment = 1.1}, {unit}},
    {"smaller unit",
     {.force = 0.9, .moment = 0.9},
     {"forces and moments are 0.9 times what they should be, or masses and inertias 1.1111 times: a unit?"}},
    {"unit of 0.8",
     {.force = 0.8, .moment = 0.8},
     {"forces and moments are 0.8 times what they should be, or masses and inertias 1.25 times: a unit?"}},
    {"density of a diameter",
     {.mass = 8, .inertia = 32},
     {mass_8, "the inertia is 32 times what it should be: a diameter for a radius, in the mass too?"}},
    {"force", {.force = 1.01}, {force_only}},
    {"mass", {.mass = 8}, {mass_8}},
    {"degrees", {.turn = PI / 180}, {degrees}},
    {"turns back", {.turn = -1}, {"bodies turn against their spin"}},
    {"velocity unit", {.flight = 1e-3}, {"free flight moves by 0.001 times what it should"}},
    {"step", {.step = 1.01}, {step}},
    {"step of its own", {.own_step = 0.01}, {"the host takes steps of h = 0.01, whatever it is asked for"}},
    {"one step more", {.more_steps = 1}, {one_more}},
    {"one step less", {.more_steps = -1}, {"the host takes one step too few"}},
    /* pairs: both, or the one that makes the other meaningless */
    {"disc, late", {.bits = LATE, .inertia = 1.25}, {disc, late_v, late_w}},
    {"disc, not primed", {.bits = NOT_PRIMED, .inertia = 1.25}, {disc, unprimed}},
    {"disc, not normalised", {.bits = NOT_NORMALISED, .inertia = 1.25}, {disc, norm}},
    {"disc, moment of the body", {.bits = BODY_MOMENT, .inertia = 1.25}, {disc, body_moment}},
    {"disc, unit", {.force = 1.1, .moment = 1.1, .inertia = 1.25}, {unit, disc}},
    {"sphere, old spin", {.bits = OLD_SPIN, .inertia = 0.8}, {sphere, old_w}},
    {"sphere, wrong sign", {.bits = WRONG_SIGN, .inertia = 0.8}, {sphere, wrong_sign}},
    {"1 %, no first half kick", {.bits = NO_FIRST_HALF, .inertia = 1.01}, {one_percent, no_half_f, no_half_m}},
    {"diameter, half turn", {.bits = REFUSES_HALF_TURN, .inertia = 4}, {diameter, half_turn}},
    {"diameter, frozen loads", {.bits = FROZEN, .inertia = 4}, {diameter, frozen}},
    {"unit, wrong side", {.bits = WRONG_SIDE, .force = 1.1, .moment = 1.1}, {unit, wrong_side}},
    {"force, old velocity", {.bits = OLD_VELOCITY, .force = 1.01}, {force_only, old_v}},
    {"mass for inertia, late", {.bits = MASS_FOR_INERTIA | LATE}, {mass_for_inertia, late_v, late_w}},
    {"degrees, early", {.bits = EARLY, .turn = PI / 180}, {degrees, early_v, early_w}},
    {"double turn, wrong side", {.bits = WRONG_SIDE, .turn = 2}, {double_turn, wrong_side}},
    {"step, previous force", {.bits = PREVIOUS_FORCE, .step = 1.01}, {step, previous_f}},
    {"one step more, disc", {.more_steps = 1, .inertia = 1.25}, {one_more, disc}},
    {"twice, not normalised", {.bits = TWICE | NOT_NORMALISED}, {twice_f, twice_m, norm}},
    {"gravity before disc", {.bits = GRAVITY, .inertia = 1.25}, {gravity}},
    {"damped spins before late", {.bits = LATE, .lost_w = 1e-4}, {damped_w}},
};

static const char only[] = "translation only: rotation is not looked at";

/** What codes get wrong that do not turn their spheres, and are asked for no more. */
static const struct expected expected_of_translation[] = {
    {"right", {.bits = 0}, {only}},
    {"old velocity", {.bits = OLD_VELOCITY}, {old_v, only}},
    {"no first half kick", {.bits = NO_FIRST_HALF}, {no_half_f, only}},
    {"not primed", {.bits = NOT_PRIMED}, {unprimed, only}},
    {"not primed, old velocity", {.bits = NOT_PRIMED | OLD_VELOCITY}, {unprimed, old_v, only}},
    {"force of the previous step", {.bits = PREVIOUS_FORCE}, {previous_f, only}},
    {"twice", {.bits = TWICE}, {twice_f, only}},
    {"late", {.bits = LATE}, {late_v, only}},
    {"early", {.bits = EARLY}, {early_v, only}},
    {"explicit Euler",
     {.bits = EULER},
     {"explicit Euler: positions are pushed with the old velocity, and kicks are by the old force: energy grows",
      only}},
    {"no force", {.bits = NO_FORCE}, {"the force does nothing", only}},
    {"force", {.force = 1.01}, {force_only, only}},
    {"mass, late", {.bits = LATE, .mass = 8}, {mass_8, late_v, only}},
    {"step, old velocity", {.bits = OLD_VELOCITY, .step = 1.01}, {step, old_v, only}},
    {"one step more, not primed", {.bits = NOT_PRIMED, .more_steps = 1}, {one_more, unprimed, only}},
};

static int is_expected(const struct expected *e, const char *text)
{
    for (int k = 0; k < 4; ++k)
        if (e->sentence[k] != NULL && strcmp(e->sentence[k], text) == 0)
            return 1;
    return 0;
}

static int count_of(const struct expected *e)
{
    int n = 0;
    while (n < 4 && e->sentence[n] != NULL)
        ++n;
    return n;
}

/** remarks is how many of the sentences are not faults. */
static int differs(const struct expected *e, int also, int remarks,
                   int (*check)(const char *, vti_check_advance *, void *, vti_check_report *))
{
    vti_check_report report;
    struct faulty host = e->host;
    host.bits |= also;
    const int faults = check(e->name, faulty_advance, &host, &report);
    int good = report.words == count_of(e) && faults == report.words - remarks && faults == report.faults;
    for (int k = 0; k < report.words; ++k)
        good = good && report.word[k].is_fault == (strcmp(report.word[k].text, only) != 0) &&
               is_expected(e, report.word[k].text);
    for (int k = 0; k < report.lines && faults == 0; ++k)
        good = good && report.line[k].verdict != VTI_CHECK_FAIL;
    if (!good) {
        print_error("%s:\n", e->name);
        vti_check_print(&report, stderr);
    }
    return !good;
}

TEST(every_mistake_is_named)
{
    int wrong = 0;
    for (size_t k = 0; k < sizeof expected / sizeof expected[0]; ++k)
        wrong += differs(&expected[k], 0, 0, vti_check_run);
    assert_int_equal(wrong, 0);
}

/** Whether the host turns its bodies rightly, wrongly or not at all makes no difference where only translation is asked
 *  for. */
TEST(every_mistake_of_translation_is_named)
{
    const int rotations[] = {NO_ROTATION, 0, WRONG_SIGN | WRONG_SIDE, OLD_SPIN | NO_INERTIA, BODY_MOMENT};
    int wrong = 0;
    for (size_t k = 0; k < sizeof expected_of_translation / sizeof expected_of_translation[0]; ++k)
        for (size_t r = 0; r < sizeof rotations / sizeof rotations[0]; ++r)
            wrong += differs(&expected_of_translation[k], rotations[r], 1, vti_check_run_translation);
    assert_int_equal(wrong, 0);
}

/** A wrong constant fails the line of that constant and no other: everything else is judged by the constants
 *  measured. */
TEST(constants_alone_fail_no_other_line)
{
    static const struct {
        struct faulty host;
        int lines;
    } cases[] = {{{.inertia = 1.25}, 1},
                 {{.inertia = 0.99}, 1},
                 {{.turn = 2}, 1},
                 {{.turn = PI / 180}, 1},
                 {{.force = 0.9, .moment = 0.9}, 2},
                 {{.mass = 8, .inertia = 32}, 2},
                 {{.bits = MASS_FOR_INERTIA | WRONG_SIGN}, 1},
                 {{.step = 1.01}, 4}};
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; ++k) {
        struct faulty host = cases[k].host;
        vti_check_report report;
        int failed = 0;
        vti_check_run("constant", faulty_advance, &host, &report);
        for (int l = 0; l < report.lines; ++l)
            failed += report.line[l].verdict == VTI_CHECK_FAIL;
        if (failed != cases[k].lines)
            vti_check_print(&report, stderr);
        assert_int_equal(failed, cases[k].lines);
    }
}

/** Any inertia from a fifth to five times what it should be, and any force, is measured to all digits that are said. */
TEST(constants_are_measured)
{
    rng g = rng_seed(811);
    for (int trial = 0; trial < 8; ++trial) {
        const double ratio = exp(uniform(&g, -log(5), log(5)));
        struct faulty hosts[] = {{.inertia = ratio}, {.force = ratio, .moment = ratio}};
        static const char *const what[] = {"the inertia is", "forces and moments are"};
        for (int k = 0; k < 2; ++k) {
            vti_check_report report;
            char text[VTI_CHECK_TEXT];
            snprintf(text, sizeof text, "%s %.5g times what", what[k], ratio);
            assert_int_equal(vti_check_run("constant", faulty_advance, &hosts[k], &report), 1);
            if (strncmp(report.word[0].text, text, strlen(text)) != 0)
                fail_msg("%s: %s", text, report.word[0].text);
        }
    }
}

/** A mistake that no sentence knows is still not passed; the order is said. */
TEST(what_is_not_known_is_not_passed)
{
    static const struct expected unknown[] = {
        {"converges to another motion",
         {.drag = {0.004, 0}},
         {"does not converge, for a reason that is not recognised"}},
        {"first order", {.drag = {0, 0.25}}, {"order 1.0, for a reason that is not recognised"}}};
    for (size_t k = 0; k < sizeof unknown / sizeof unknown[0]; ++k)
        assert_int_equal(differs(&unknown[k], 0, 0, vti_check_run), 0);
}

/* ---- the host that refuses --------------------------------------------------------------------------------------- */

static int refuse(void *self, double h, int64_t steps, int64_t n, double *x, double *v, double *quat, double *omega,
                  const double *mass, const double *inertia, vti_check_forces *forces, void *kit)
{
    (void)self, (void)h, (void)steps, (void)n, (void)x, (void)v, (void)quat, (void)omega, (void)mass, (void)inertia;
    (void)forces, (void)kit;
    return 1;
}

TEST(nothing_passes_where_the_host_refuses)
{
    vti_check_report report;
    assert_true(vti_check_run(NULL, refuse, NULL, &report) > 0);
    assert_string_equal(report.name, "");
    for (int k = 0; k < report.lines; ++k)
        if (strncmp(report.line[k].name, "torsion pair: amplitude", 23) != 0)
            assert_int_equal(isnan(report.line[k].measured) ? VTI_CHECK_FAIL : VTI_CHECK_PASS,
                             report.line[k].verdict == VTI_CHECK_FAIL ? VTI_CHECK_FAIL : 99);
}

RUN_TESTS(cmocka_unit_test(every_mistake_is_named), cmocka_unit_test(every_mistake_of_translation_is_named),
          cmocka_unit_test(constants_alone_fail_no_other_line), cmocka_unit_test(constants_are_measured),
          cmocka_unit_test(what_is_not_known_is_not_passed), cmocka_unit_test(nothing_passes_where_the_host_refuses))
