/* SPDX-License-Identifier: BSD-3-Clause
 * Every mistake is called by its name, and by no other; what has none is not blamed. */
#include "support.h"

#include "faulty.h"

/** Bits of fault, and the sentences that are due: these and no others. */
struct expected {
    const char *name;
    int fault;
    const char *sentence[3];
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

static const struct expected expected[] = {
    {"right", 0, {NULL}},
    {"old velocity", OLD_VELOCITY, {old_v}},
    {"old spin", OLD_SPIN, {old_w}},
    {"both", OLD_VELOCITY | OLD_SPIN, {old_v, old_w}},
    {"no first half kick", NO_FIRST_HALF, {no_half_f, no_half_m}},
    {"no first half kick, old spin", NO_FIRST_HALF | OLD_SPIN, {no_half_f, no_half_m, old_w}},
    {"not primed", NOT_PRIMED, {unprimed}},
    {"not primed, old velocity", NOT_PRIMED | OLD_VELOCITY, {unprimed, old_v}},
    {"wrong side", WRONG_SIDE, {wrong_side}},
    {"spin of the body, spatial moment",
     BODY_SPIN,
     {"attitude increments act in the body's frame while moments are spatial: they kick a spin of the body's frame"}},
    {"moment of the body, spatial spin",
     BODY_MOMENT,
     {"moments are turned into the body's frame while spins are spatial"}},
    {"turns added up",
     ADDED_TURNS,
     {"a free spin does not turn a body about omega: increments are added up, or a quaternion's order is another one"}},
    {"not normalised", NOT_NORMALISED, {norm}},
    {"wrong sign", WRONG_SIGN, {"the moment enters with the wrong sign"}},
    {"moment of the previous step",
     PREVIOUS_MOMENT,
     {"spins are kicked by the moment of the previous step: energy grows"}},
    {"force of the previous step",
     PREVIOUS_FORCE,
     {"velocities are kicked by the force of the previous step: energy grows"}},
    {"twice", TWICE, {"the kick by the force is applied twice", "the kick by the moment is applied twice"}},
    {"late", LATE, {late_v, late_w}},
    {"early", EARLY, {early_v, early_w}},
    {"explicit Euler",
     EULER,
     {"explicit Euler: positions are pushed with the old velocity, and kicks are by the old force: energy grows",
      "explicit Euler: rotation is pushed with the old spin, and kicks are by the old moment: energy grows"}},
    {"late, not normalised", LATE | NOT_NORMALISED, {late_v, late_w, norm}},
    {"no inertia", NO_INERTIA, {"the moment is not divided by the inertia"}},
    {"mass for inertia", MASS_FOR_INERTIA, {"the moment is divided by the mass where the inertia is meant"}},
    {"inverse attitude", INVERSE_ATTITUDE, {"the attitude is taken for its inverse, space to body"}},
    {"double turn", DOUBLE_TURN, {"a free spin turns by 2 times what it should"}},
    {"half turn", REFUSES_HALF_TURN, {"attitudes are lost at half a turn"}},
    {"no force", NO_FORCE, {"the force does nothing"}},
};

static const char only[] = "translation only: rotation is not looked at";

/** What codes get wrong that do not turn their spheres, and are asked for no more. */
static const struct expected expected_of_translation[] = {
    {"right", 0, {only}},
    {"old velocity", OLD_VELOCITY, {old_v, only}},
    {"no first half kick", NO_FIRST_HALF, {no_half_f, only}},
    {"not primed", NOT_PRIMED, {unprimed, only}},
    {"not primed, old velocity", NOT_PRIMED | OLD_VELOCITY, {unprimed, old_v, only}},
    {"force of the previous step",
     PREVIOUS_FORCE,
     {"velocities are kicked by the force of the previous step: energy grows", only}},
    {"twice", TWICE, {"the kick by the force is applied twice", only}},
    {"late", LATE, {late_v, only}},
    {"early", EARLY, {early_v, only}},
    {"explicit Euler",
     EULER,
     {"explicit Euler: positions are pushed with the old velocity, and kicks are by the old force: energy grows",
      only}},
    {"no force", NO_FORCE, {"the force does nothing", only}},
};

static int is_expected(const struct expected *e, const char *text)
{
    for (int k = 0; k < 3; ++k)
        if (e->sentence[k] != NULL && strcmp(e->sentence[k], text) == 0)
            return 1;
    return 0;
}

static int count_of(const struct expected *e)
{
    int n = 0;
    while (n < 3 && e->sentence[n] != NULL)
        ++n;
    return n;
}

/** remarks is how many of the sentences are not faults. */
static int differs(const struct expected *e, int also, int remarks,
                   int (*check)(const char *, vti_check_advance *, void *, vti_check_report *))
{
    vti_check_report report;
    int fault = e->fault | also, good = 1;
    const int faults = check(e->name, faulty_advance, &fault, &report);
    good = report.words == count_of(e) && faults == report.words - remarks && faults == report.faults;
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

static void every_mistake_is_named(void **state)
{
    (void)state;
    int wrong = 0;
    for (size_t k = 0; k < sizeof expected / sizeof expected[0]; ++k)
        wrong += differs(&expected[k], 0, 0, vti_check_run);
    assert_int_equal(wrong, 0);
}

/** Whether the host turns its bodies rightly, wrongly or not at all makes no difference where only translation is asked for. */
static void every_mistake_of_translation_is_named(void **state)
{
    (void)state;
    const int rotations[] = {NO_ROTATION, 0, WRONG_SIGN | WRONG_SIDE, OLD_SPIN | NO_INERTIA, DOUBLE_TURN};
    int wrong = 0;
    for (size_t k = 0; k < sizeof expected_of_translation / sizeof expected_of_translation[0]; ++k)
        for (size_t r = 0; r < sizeof rotations / sizeof rotations[0]; ++r)
            wrong += differs(&expected_of_translation[k], rotations[r], 1, vti_check_run_translation);
    assert_int_equal(wrong, 0);
}

/** Asked for everything, a host that does not turn its bodies is told so. */
static void missing_rotation_is_named(void **state)
{
    (void)state;
    const struct expected none = {
        "no rotation",
        NO_ROTATION,
        {"the moment does nothing",
         "a free spin does not turn bodies (what moves positions only is checked by vti-check --translation)"}};
    assert_int_equal(differs(&none, 0, 0, vti_check_run), 0);
}

/** A mistake that no sentence knows is still not passed. */
static void what_is_not_known_is_not_passed(void **state)
{
    (void)state;
    int fault = WEAK_DAMPING;
    vti_check_report report;
    assert_true(vti_check_run("damped", faulty_advance, &fault, &report) > 0);
}

/* ---- the host that refuses -------------------------------------------------------------------------------------------- */

static int refuse(void *self, double h, int64_t steps, int64_t n, double *x, double *v, double *quat, double *omega,
                  const double *mass, const double *inertia, vti_check_forces *forces, void *kit)
{
    (void)self, (void)h, (void)steps, (void)n, (void)x, (void)v, (void)quat, (void)omega, (void)mass, (void)inertia;
    (void)forces, (void)kit;
    return 1;
}

static void nothing_passes_where_the_host_refuses(void **state)
{
    (void)state;
    vti_check_report report;
    assert_true(vti_check_run(NULL, refuse, NULL, &report) > 0);
    assert_string_equal(report.name, "");
    for (int k = 0; k < report.lines; ++k)
        if (strncmp(report.line[k].name, "torsion pair: amplitude", 23) != 0)
            assert_int_equal(isnan(report.line[k].measured) ? VTI_CHECK_FAIL : VTI_CHECK_PASS,
                             report.line[k].verdict == VTI_CHECK_FAIL ? VTI_CHECK_FAIL : 99);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_mistake_is_named), cmocka_unit_test(every_mistake_of_translation_is_named),
        cmocka_unit_test(missing_rotation_is_named), cmocka_unit_test(what_is_not_known_is_not_passed),
        cmocka_unit_test(nothing_passes_where_the_host_refuses)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
