/* SPDX-License-Identifier: BSD-3-Clause
 * What the kit says of the library's steppers and of the rivals: nothing, but of those that are known to be of first
 * order. */
#include "support.h"

#include "method_check.h"
#include "rival.h"

struct known {
    const char *name, *sentence[2];
};

static const char late_v[] = "order 1: velocities are half a kick late";
static const char late_w[] = "order 1: spins are half a kick late";

/* VTI-3 and its like; Campello's map, which dissipates (E17) */
static const struct known of_order_1[] = {
    {"vti3", {late_v, late_w}},
    {"quat-euler", {late_v, late_w}},
    {"campello",
     {"positions are pushed with the velocity of the end of the step: energy decays",
      "rotation is pushed with the spin of the end of the step: energy decays"}},
};

static const struct known *known_of(const char *name)
{
    for (size_t k = 0; k < sizeof of_order_1 / sizeof of_order_1[0]; ++k)
        if (strcmp(of_order_1[k].name, name) == 0)
            return &of_order_1[k];
    return NULL;
}

/** The kit judges steps that depend on where the bodies are. One that depends on past steps too, as Gear's and the
 *  Adams methods' do, has a bound of its own on h omega, of which the kit warns. pd8 is rk8pd, and orders above 8 come
 *  from engines that others show. */
static int is_judged(const vti_stepper *m)
{
    return strncmp(m->name, "abm", 3) != 0 && strcmp(m->name, "gear") != 0 && strcmp(m->name, "pd8") != 0 &&
           (m->order <= 8 || vti_multistep_find(m->name) != NULL);
}

/** The kit wants h omega = 1/2 to be stable and looks at frequencies at 0.2: one whose steps are stable for less fails
 *  there, by the first of the two that it meets, and nowhere else. */
static int fails_by_reach(const vti_check_report *report, int faults)
{
    int elsewhere = 0, told = 0;
    for (int k = 0; k < report->lines; ++k)
        elsewhere += report->line[k].verdict == VTI_CHECK_FAIL && strstr(report->line[k].name, "h omega =") == NULL;
    for (int k = 0; k < report->words; ++k)
        told += report->word[k].is_fault && strstr(report->word[k].text, "h omega =") != NULL;
    return faults == 1 && elsewhere == 0 && told == 1;
}

/** sentences: of those of order 1, the second is about rotation. */
static int wrongly_judged(const vti_stepper *m, int sentences)
{
    vti_check_report report;
    const struct known *known = known_of(m->name);
    const int faults =
        (sentences == 1 ? vti_check_run_translation : vti_check_run)(m->name, method_check_advance, (void *)m, &report);
    int good = faults == (known != NULL ? sentences : 0);
    for (int k = 0; good && known != NULL && k < sentences; ++k)
        good = strcmp(report.word[k].text, known->sentence[k]) == 0;
    for (int k = 0; k < report.lines && known == NULL; ++k)
        good = good && report.line[k].verdict != VTI_CHECK_FAIL;
    if (m->reach < 0.5)
        good = fails_by_reach(&report, faults);
    if (!good) {
        print_error("%s is judged wrongly\n", m->name);
        vti_check_print(&report, stderr);
    }
    return !good;
}

TEST(each_is_judged_rightly)
{
    int wrong = 0;
    assert_true(method_count() > rival_count() && rival_count() > 0);
    for (int64_t i = 0; i < method_count(); ++i)
        if (is_judged(method_at(i)))
            wrong += wrongly_judged(method_at(i), 2) + wrongly_judged(method_at(i), 1);
    assert_int_equal(wrong, 0);
}

static const vti_check_line *line_of(const vti_check_report *report, const char *begin)
{
    for (int k = 0; k < report->lines; ++k)
        if (strncmp(report->line[k].name, begin, strlen(begin)) == 0)
            return &report->line[k];
    fail_msg("there is no line '%s'", begin);
    return NULL;
}

static void run(const char *name, vti_check_report *report)
{
    assert_non_null(method_find(name));
    vti_check_run(name, method_check_advance, (void *)method_find(name), report);
}

TEST(laws_and_orders_are_recognised)
{
    static const char *const laws[][2] = {
        {"vti1", "turns by asin s"}, {"vti2", "turns by 2 atan(s/2)"},    {"exact", "turns by s"},
        {"lgvi", "turns by asin s"}, {"mercury", "turns by 2 atan(s/2)"}, {"spiral", "turns by s"}};
    vti_check_report report;
    for (size_t k = 0; k < sizeof laws / sizeof laws[0]; ++k) {
        run(laws[k][0], &report);
        assert_string_equal(line_of(&report, "free spin: turn at")->said, laws[k][1]);
    }
    run("rk4", &report);
    assert_close(line_of(&report, "order of attitudes")->measured, 4.0, 0.1);
    assert_int_equal(line_of(&report, "symplecticity")->verdict, VTI_CHECK_NOTE);
    assert_int_equal(report.word[0].is_fault, 0);
    run("vti2", &report);
    /* Verlet is stable to 2; the ladder's steps are 2^(1/16) = 1.044 apart */
    assert_close(line_of(&report, "torsion pair: amplitude")->measured, 2.0, 0.09);
    assert_close(line_of(&report, "torsion pair: frequency")->measured, 0.04 / 24, 1e-4);
}

TEST(what_translation_alone_keeps)
{
    static const char *const good[] = {"vti2", "exact", "suzuki4", "srkn14"};
    vti_check_report report;
    for (size_t k = 0; k < sizeof good / sizeof good[0]; ++k) {
        vti_check_run_translation(good[k], method_check_advance, (void *)method_find(good[k]), &report);
        assert_true(report.lines > 10);
        for (int l = 0; l < report.lines; ++l)
            if (report.line[l].verdict != VTI_CHECK_PASS)
                fail_msg("%s: %s", good[k], report.line[l].name);
    }
    vti_check_run_translation("vti2", method_check_advance, (void *)method_find("vti2"), &report);
    assert_close(line_of(&report, "stretched pair: amplitude")->measured, 2.0, 0.09);
    assert_close(line_of(&report, "stretched pair: frequency")->measured, 0.04 / 24, 1e-4);
    assert_close(line_of(&report, "order of positions")->measured, 2.0, 0.05);
    vti_check_run_translation("rk4", method_check_advance, (void *)method_find("rk4"), &report);
    assert_close(line_of(&report, "order of velocities")->measured, 4.0, 0.1);
    assert_int_equal(line_of(&report, "symplecticity")->verdict, VTI_CHECK_NOTE);
    assert_int_equal(line_of(&report, "reversibility")->verdict, VTI_CHECK_NOTE);
}

RUN_TESTS(cmocka_unit_test(each_is_judged_rightly), cmocka_unit_test(what_translation_alone_keeps),
          cmocka_unit_test(laws_and_orders_are_recognised))
