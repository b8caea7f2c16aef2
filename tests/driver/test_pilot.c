/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Where pilots of vti-advise may take so many seconds, none begins that has no time left to start the scene. */
#include "support.h"

#include "advise.h"
#include "clock.h"

/* longer than any test takes */
static const double age = 1e6;

static struct scene pile;

/** A pilot of 32 steps. */
static int fly(struct purse *purse, struct pilot *pilot)
{
    const struct trial trial = trial_of(vti_stepper_find("exact"), 1e-3, 32);
    const struct pilot_way way = {.beside = NULL};
    struct message message = {""};
    return pilot_run(&pile, &trial, purse, way, pilot, &message);
}

TEST(time_to_start)
{
    struct pilot pilot;
    struct purse purse = {.until = clock_now() + age, .start = 2 * age, .most = INFINITY};
    assert_false(purse_may_start(&purse));
    assert_int_equal(fly(&purse, &pilot), ADVISE_SPENT);
    assert_true(pilot.memory == NULL && pilot.force_evals == 0 && purse.work == 0 && purse.start == 2 * age);

    purse.start = 0; /* of which the pilot takes note */
    assert_true(purse_may_start(&purse));
    assert_int_equal(fly(&purse, &pilot), 0);
    assert_true(pilot.force_evals >= 32 && purse.work > 0 && purse.start > 0 && purse.start < age);
    pilot_destroy(&pilot);

    purse.until = INFINITY; /* no time is asked for: work alone counts */
    purse.start = 2 * age;
    assert_true(purse_may_start(&purse));
    assert_int_equal(fly(&purse, &pilot), 0);
    pilot_destroy(&pilot);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(time_to_start)};
    char path[4096];
    struct message message = {""};
    snprintf(path, sizeof path, "%s/pile.yaml", argc > 1 ? argv[1] : ".");
    method_admit();
    assert_int_equal(scene_read(path, NULL, 0, &pile, &message), 0);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
