/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Steppers as data: how they are found, that their coefficients are consistent, and that a step is what its list of
 * kicks and drifts says, for a list of the caller's own as well. */
#include "support.h"

TEST(found_by_name_and_index)
{
    const char *const names[] = {"vti1", "vti2", "vti3",  "vti3-leapfrog", "vti1-body", "exact", "suzuki4",
                                 "kl6",  "kl8",  "srkn6", "srkn11",        "srkn14",    "chin4"};
    if (vti_stepper_count() != 13)
        fail_msg("there are %d steppers, and 13 names here", (int)vti_stepper_count());
    for (int k = 0; k < 13; ++k) {
        const vti_stepper *s = vti_stepper_find(names[k]);
        assert_non_null(s);
        assert_string_equal(s->name, names[k]);
    }
    /* packed arrays promise these three indices */
    for (int64_t k = 0; k < 3; ++k)
        assert_ptr_equal(vti_stepper_at(k), vti_stepper_find(names[k]));
    for (int64_t k = 0; k < vti_stepper_count(); ++k)
        assert_ptr_equal(vti_stepper_find(vti_stepper_at(k)->name), vti_stepper_at(k));
}

TEST(unknown)
{
    const char *const names[] = {"", "vti", "vti4", "VTI1", "vti1 ", "vti3-leap"};
    for (int k = 0; k < 6; ++k)
        assert_null(vti_stepper_find(names[k]));
    assert_null(vti_stepper_find(NULL));
    assert_null(vti_stepper_at(-1));
    assert_null(vti_stepper_at(vti_stepper_count()));
    assert_null(vti_stepper_at(INT64_MAX));
    assert_null(vti_stepper_at(INT64_MIN));
}

/** What each stepper says of itself. */
TEST(fields)
{
    static const struct {
        const char *name;
        int law, order, reversible, symplectic, stages, evals;
    } table[] = {
        {"vti1", VTI_LAW_CLOSED, 2, 1, 1, 1, 1},      {"vti2", VTI_LAW_CAYLEY, 2, 1, 1, 1, 1},
        {"vti3", VTI_LAW_CAYLEY, 1, 0, 1, 1, 1},      {"vti3-leapfrog", VTI_LAW_CAYLEY, 2, 1, 1, 1, 1},
        {"vti1-body", VTI_LAW_CLOSED, 2, 1, 1, 1, 1}, {"exact", VTI_LAW_EXACT, 2, 1, 1, 1, 1},
        {"suzuki4", VTI_LAW_EXACT, 4, 1, 1, 5, 5},    {"kl6", VTI_LAW_EXACT, 6, 1, 1, 9, 9},
        {"kl8", VTI_LAW_EXACT9, 8, 1, 1, 17, 17},     {"srkn6", VTI_LAW_EXACT, 4, 1, 1, 6, 6},
        {"srkn11", VTI_LAW_EXACT, 6, 1, 1, 11, 11},   {"srkn14", VTI_LAW_EXACT, 6, 1, 1, 14, 14},
        {"chin4", VTI_LAW_EXACT, 4, 1, 0, 2, 3},
    };
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        const vti_stepper *s = vti_stepper_at(k);
        if (k >= (int64_t)(sizeof table / sizeof table[0]))
            fail_msg("%s has no row", s->name);
        assert_string_equal(s->name, table[k].name);
        assert_int_equal(s->law, table[k].law);
        assert_int_equal(s->frame, strcmp(s->name, "vti1-body") == 0 ? VTI_FRAME_BODY : VTI_FRAME_SPACE);
        assert_int_equal(s->order, table[k].order);
        assert_int_equal(s->reversible, table[k].reversible);
        assert_int_equal(s->symplectic, table[k].symplectic);
        assert_int_equal(s->stages, table[k].stages);
        assert_int_equal(s->evals, table[k].evals);
        assert_close(s->lag, strcmp(s->name, "vti3-leapfrog") == 0 ? 0.5 : 0, 0);
        assert_true(s->reach >= 2);
        assert_true(strlen(s->about) > 10);
        for (int64_t j = 0; j < k; ++j) {
            assert_string_not_equal(s->name, vti_stepper_at(j)->name);
            assert_string_not_equal(s->about, vti_stepper_at(j)->about);
        }
        /* a probe is one more evaluation; a list that ends with a drift begins with one */
        int64_t evals = s->stages;
        for (int64_t i = 0; s->probe != NULL && i <= s->stages; ++i)
            evals += s->probe[i] != 0;
        assert_int_equal(s->evals, evals);
        assert_int_equal(s->drift[s->stages] != 0, s->kick[0] == 0);
    }
}

typedef struct body {
    double v[3], w[3], x[3], a[3], force[3], moment[3];
} body;

static vti_bodies bodies_of(body *p, const double *mass, const double *inertia)
{
    vti_bodies b = vti_bodies_none(1);
    b.v = vti_view_packed(p->v);
    b.omega = vti_view_packed(p->w);
    b.x = vti_view_packed(p->x);
    b.alpha = vti_view_packed(p->a);
    b.force = vti_view_packed(p->force);
    b.moment = vti_view_packed(p->moment);
    b.mass = vti_scalars_one(mass);
    b.inertia = vti_scalars_one(inertia);
    return b;
}

/** The stages of a list, written out: the velocities after kicks of constant force, the positions after the drifts. */
TEST(step_plays_its_list)
{
    const double kick[] = {0.2, -0.7, 1.1, 0.4}, drift[] = {0.5, -0.25, 0.75, 0}, mass = 2, inertia = 0.5, h = 0.25;
    const vti_stepper own = {.name = "own",
                             .law = VTI_LAW_CAYLEY,
                             .frame = VTI_FRAME_SPACE,
                             .stages = 3,
                             .lag = 0.25,
                             .kick = kick,
                             .drift = drift};
    const body start = {{1, 2, 3}, {0, 0, 0.5}, {4, 5, 6}, {0, 0, 0}, {8, -8, 4}, {0, 0, 2}};
    body p = start;
    const vti_bodies b = bodies_of(&p, &mass, &inertia);
    double v[3], x[3], w = 0.5, turned = 0;
    memcpy(v, start.v, sizeof v);
    memcpy(x, start.x, sizeof x);
    for (int64_t s = 0; s < 3; ++s) {
        vti_fault fault = {0, 0, 0};
        assert_int_equal(s == 0 ? vti_step_begin(&own, h, &b, &fault) : vti_step_stage(&own, s, h, &b, &fault), VTI_OK);
        for (int k = 0; k < 3; ++k) {
            v[k] += kick[s] * h * start.force[k] / mass;
            x[k] += drift[s] * h * v[k];
        }
        w += kick[s] * h * 2 / inertia;
        turned += 2 * atan(0.5 * drift[s] * h * w); /* about e3 all the while */
        assert_close3(p.v, v, 16 * EPS * 8);
        assert_close3(p.x, x, 16 * EPS * 8);
        assert_close(p.w[2], w, 16 * EPS);
        assert_close(p.a[2], 2 * tan(0.5 * turned), 16 * EPS);
    }
    assert_int_equal(vti_step_finish(&own, h, &b), VTI_OK);
    for (int k = 0; k < 3; ++k)
        v[k] += kick[3] * h * start.force[k] / mass;
    assert_close3(p.v, v, 16 * EPS * 8);

    p = start;
    assert_int_equal(vti_step_start(&own, h, &b), VTI_OK);
    for (int k = 0; k < 3; ++k)
        assert_close(p.v[k], start.v[k] - 0.25 * h * start.force[k] / mass, 8 * EPS);
    assert_close(p.w[2], 0.5 - 0.25 * h * 2 / inertia, EPS);
    assert_int_equal(vti_step_sync(&own, h, &b), VTI_OK);
    assert_close3(p.v, start.v, 8 * EPS);
    assert_same_bits(p.x, start.x, 6);
}

static const double ends_kick[] = {0.25, 0.75}, ends_drift[] = {0.5, 0.5};

/** A list that ends with a drift: finish moves positions too, and under the closed form either all bodies or none. */
TEST(last_drift)
{
    const double mass = 2, inertia = 0.5, h = 0.5;
    vti_stepper own = {.name = "own",
                       .law = VTI_LAW_CLOSED,
                       .frame = VTI_FRAME_SPACE,
                       .stages = 1,
                       .kick = ends_kick,
                       .drift = ends_drift};
    const body start = {{1, 2, 3}, {0, 0, 0.5}, {4, 5, 6}, {0, 0, 0}, {8, -8, 4}, {0, 0, 2}};
    body p = start;
    const vti_bodies b = bodies_of(&p, &mass, &inertia);
    assert_int_equal(vti_step_finish(&own, h, &b), VTI_OK);
    for (int k = 0; k < 3; ++k) {
        const double v = start.v[k] + 0.75 * h * start.force[k] / mass;
        assert_close(p.v[k], v, 8 * EPS);
        assert_close(p.x[k], start.x[k] + 0.5 * h * v, 16 * EPS);
    }
    const double w = 0.5 + 0.75 * h * 2 / inertia; /* 2, of which the drift makes s = 1/2 */
    assert_close(p.w[2], w, 4 * EPS);
    assert_close(p.a[2], 2 * tan(asin(0.5 * h * w) / 2), 8 * EPS);

    /* two bodies in a row of structs, the second of which would turn too far after the kick, and only then */
    body row[2] = {start, start}, before[2];
    row[1].moment[2] = 4;
    memcpy(before, row, sizeof row);
    vti_bodies both = bodies_of(row, &mass, &inertia);
    both.count = 2;
    vti_view *const views[] = {&both.x, &both.v, &both.force, &both.alpha, &both.omega, &both.moment};
    for (int k = 0; k < 6; ++k)
        views[k]->stride = sizeof(body) / sizeof(double);
    assert_int_equal(vti_step_finish(&own, h, &both), VTI_OK);
    memcpy(row, before, sizeof row);
    row[1].moment[2] = 5; /* (1/2 + 3/4 h 10) h/2 = 1.06 */
    memcpy(before, row, sizeof row);
    assert_int_equal(vti_step_finish(&own, h, &both), VTI_E_TOO_LARGE);
    assert_memory_equal(row, before, sizeof row);
    own.law = VTI_LAW_EXACT;
    assert_int_equal(vti_step_finish(&own, h, &both), VTI_OK);
    own.law = 0;
    memcpy(row, before, sizeof row);
    assert_int_equal(vti_step_finish(&own, h, &both), VTI_E_STEPPER);
    own.law = VTI_LAW_EXACT;
    own.frame = 0;
    assert_int_equal(vti_step_finish(&own, h, &both), VTI_E_FRAME);
    assert_memory_equal(row, before, sizeof row);
}

/** A step that begins with a drift does not look at the forces before they are made, whatever its law. */
TEST(no_kick_no_forces)
{
    const double one = 1;
    for (int law = VTI_LAW_CLOSED; law <= VTI_LAW_EXACT9; ++law) {
        vti_stepper own = *vti_stepper_find("srkn14");
        own.law = law;
        body p = {{1, 2, 3}, {0, 0, 0.5}, {4, 5, 6}, {0, 0, 0}, {NAN, NAN, INFINITY}, {NAN, NAN, INFINITY}};
        const vti_bodies b = bodies_of(&p, &one, &one);
        assert_int_equal(vti_step_begin(&own, 0.5, &b, NULL), VTI_OK);
        assert_true(all_finite(p.v, 3) && all_finite(p.w, 3) && all_finite(p.x, 3) && all_finite(p.a, 3));
        assert_close(p.x[0], 4 + own.drift[0] * 0.5, 8 * EPS);
    }
}

/** What is absent is not touched, by any stage of any stepper: forces without velocities, velocities without
 *  positions. */
TEST(absent_physics)
{
    const double one = 1;
    for (int64_t k = 0; k < vti_stepper_count(); ++k)
        for (int turns = 0; turns < 2; ++turns) {
            const vti_stepper *method = vti_stepper_at(k);
            const body start = {{1, 2, 3}, {0.5, 0.25, 0.5}, {4, 5, 6}, {0.1, 0.2, 0}, {8, -8, 4}, {1, 0, 2}};
            body p = start, elsewhere = start;
            vti_bodies b = bodies_of(&p, &one, &one), probed;
            if (turns) {
                b.v = vti_view_none();
                b.mass.p = NULL;
            } else {
                b.omega = vti_view_none();
                b.inertia.p = NULL;
            }
            probed = b;
            probed.x = vti_view_packed(elsewhere.x);
            probed.alpha = vti_view_packed(elsewhere.a);
            for (int64_t s = 0; s < method->stages; ++s) {
                assert_int_equal(vti_step_probe(method, s, 0.1, &b, &probed), VTI_OK);
                assert_int_equal(vti_step_stage(method, s, 0.1, &b, NULL), VTI_OK);
            }
            assert_int_equal(vti_step_finish(method, 0.1, &b), VTI_OK);
            assert_same_bits(turns ? p.x : p.a, turns ? start.x : start.a, 3);
            assert_same_bits(turns ? elsewhere.x : elsewhere.a, turns ? start.x : start.a, 3);
            assert_same_bits(turns ? p.v : p.w, turns ? start.v : start.w, 3);
            assert_true(memcmp(turns ? p.a : p.x, turns ? start.a : start.x, sizeof p.a) != 0);
            assert_true(memcmp(turns ? p.w : p.v, turns ? start.w : start.v, sizeof p.a) != 0);
        }
}

/** A probe is where forces would take the bodies: without them, where they are. */
TEST(probe_without_loads)
{
    const double one = 1;
    const vti_stepper *const chin4 = vti_stepper_find("chin4");
    const body start = {{1, 2, 3}, {0.5, 0.25, 0.5}, {4, 5, 6}, {0.1, 0.2, 0}, {8, -8, 4}, {1, 0, 2}};
    for (int which = 0; which < 4; ++which) {
        body p = start, elsewhere = {{0}, {0}, {0}, {0}, {0}, {0}};
        vti_bodies b = bodies_of(&p, &one, &one), probed = b;
        if (which & 1) {
            b.force = vti_view_none();
            b.mass.p = NULL;
        }
        if (which & 2) {
            b.moment = vti_view_none();
            b.inertia.p = NULL;
        }
        probed.x = vti_view_packed(elsewhere.x);
        probed.alpha = vti_view_packed(elsewhere.a);
        assert_true(chin4->probe[1] != 0);
        assert_int_equal(vti_step_probe(chin4, 1, 0.1, &b, &probed), VTI_OK);
        assert_int_equal(memcmp(elsewhere.x, start.x, sizeof start.x) == 0, which & 1);
        assert_int_equal(memcmp(elsewhere.a, start.a, sizeof start.a) == 0, which >> 1);
        assert_memory_equal(&p, &start, sizeof p);
    }
}

/** Steppers without lag are neither started nor read out: not a bit changes, whatever the force. */
TEST(no_lag_no_change)
{
    const double one = 1;
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        if (vti_stepper_at(k)->lag != 0)
            continue;
        const body start = {{-0.0, 2, 3}, {-0.0, 1, 0.5}, {4, 5, 6}, {0, 0, 0}, {8, -8, NAN}, {0, INFINITY, 2}};
        body p = start;
        const vti_bodies b = bodies_of(&p, &one, &one);
        assert_int_equal(vti_step_start(vti_stepper_at(k), 0.1, &b), VTI_OK);
        assert_int_equal(vti_step_sync(vti_stepper_at(k), 0.1, &b), VTI_OK);
        assert_memory_equal(&p, &start, sizeof p);
    }
}

RUN_TESTS(cmocka_unit_test(found_by_name_and_index), cmocka_unit_test(unknown), cmocka_unit_test(fields),
          cmocka_unit_test(step_plays_its_list), cmocka_unit_test(no_lag_no_change), cmocka_unit_test(last_drift),
          cmocka_unit_test(no_kick_no_forces), cmocka_unit_test(absent_physics), cmocka_unit_test(probe_without_loads))
