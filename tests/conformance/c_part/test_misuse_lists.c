/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Wrong use beside bodies (test_misuse.c): times that are none, the packed door, lists that are not there or no longer, every
 * pointer NULL. */
#include "misuse.h"

static void times(void **state)
{
    (void)state;
    const vti_bodies other = elsewhere();
    for (size_t k = 0; k < sizeof bad_times / sizeof *bad_times; ++k) {
        const double h = bad_times[k];
        int64_t body;
        double value;
        for (int64_t s = 0; s < vti_stepper_count(); ++s) {
            const vti_stepper *method = vti_stepper_at(s);
            assert_int_equal(vti_step_begin(method, h, &good, NULL), VTI_E_TIME);
            assert_int_equal(vti_step_stage(method, 0, h, &good, NULL), VTI_E_TIME);
            assert_int_equal(vti_step_finish(method, h, &good), VTI_E_TIME);
            assert_int_equal(vti_step_start(method, h, &good), VTI_E_TIME);
            assert_int_equal(vti_step_sync(method, h, &good), VTI_E_TIME);
            assert_int_equal(vti_step_probe(method, 0, h, &good, &other), VTI_E_TIME);
        }
        assert_int_equal(vti_packed_begin(1, h, N, now.x, now.v, now.f, now.alpha, now.w, now.m, N, now.mass, N,
                                          now.inertia, &body, &value),
                         VTI_E_TIME);
        assert_int_equal(vti_packed_finish(1, h, N, now.v, now.f, now.w, now.m, N, now.mass, N, now.inertia),
                         VTI_E_TIME);
        if (isfinite(h))
            continue;
        assert_int_equal(vti_kick(h, &good), VTI_E_TIME);
        assert_int_equal(vti_drift(VTI_LAW_CAYLEY, VTI_FRAME_SPACE, h, &good, NULL), VTI_E_TIME);
    }
    assert_memory_equal(&now, &before, sizeof now);
}

static int packed_begin(int64_t n, double *x, double *v, int64_t masses_, const double *mass)
{
    const int status = vti_packed_finish(1, 0.125, n, v, now.f, now.w, now.m, masses_, mass, N, now.inertia);
    const int first =
        vti_packed_begin(1, 0.125, n, x, v, now.f, now.alpha, now.w, now.m, masses_, mass, N, now.inertia, NULL, NULL);
    return status == first || v == x ? first : VTI_OK;
}

static void packed(void **state)
{
    (void)state;
    assert_int_equal(packed_begin(N, now.x, now.v, N, NULL), VTI_E_MASS);
    assert_int_equal(packed_begin(N, now.x, now.v, 1, &no_mass), VTI_E_MASS);
    assert_int_equal(packed_begin(N, now.x, now.v, 1, &not_a_number), VTI_E_MASS);
    assert_int_equal(packed_begin(N, now.x, now.v, 2, now.mass), VTI_E_COUNT);
    assert_int_equal(packed_begin(N, now.x, now.v, -1, now.mass), VTI_E_COUNT);
    assert_int_equal(packed_begin(-1, now.x, now.v, 1, now.mass), VTI_E_COUNT);
    assert_int_equal(vti_packed_begin(1, 0.125, N, now.x, now.x, NULL, NULL, NULL, NULL, 1, NULL, 1, NULL, NULL, NULL),
                     VTI_E_ALIAS);
    const int64_t none[] = {-1, vti_stepper_count(), INT64_MIN, INT64_MAX};
    for (int k = 0; k < 4; ++k) {
        assert_int_equal(
            vti_packed_begin(none[k], 0.125, N, now.x, now.v, NULL, NULL, NULL, NULL, 1, NULL, 1, NULL, NULL, NULL),
            VTI_E_STEPPER);
        assert_int_equal(vti_packed_finish(none[k], 0.125, N, now.v, NULL, NULL, NULL, 1, NULL, 1, NULL),
                         VTI_E_STEPPER);
    }
    /* absent arrays are absent physics, and no more */
    assert_int_equal(vti_packed_begin(1, 0.125, N, NULL, NULL, NULL, NULL, NULL, NULL, 1, NULL, 1, NULL, NULL, NULL),
                     VTI_OK);
    assert_int_equal(vti_packed_finish(1, 0.125, N, NULL, NULL, NULL, NULL, 1, NULL, 1, NULL), VTI_OK);
    assert_memory_equal(&now, &before, sizeof now);
}

static void no_effect(vti_effect effect, const vti_bodies *b, const char *what)
{
    const vti_effect two[2] = {vti_gravity_effect(&gravity), effect};
    if (vti_apply(&effect, 1, b) != VTI_E_NULL || vti_apply(two, 2, b) != VTI_E_NULL)
        fail_msg("%s is not refused", what);
    assert_memory_equal(&now, &before, sizeof now); /* gravity's force neither */
}

/** Lists that are not there, or no longer: a list of contacts may change between steps. */
static void lists(void **state)
{
    (void)state;
    contacts.pair = NULL;
    no_effect(vti_contacts_effect(&contacts), &good, "contacts without pairs");
    contacts.pair = pair;
    contacts.count = -1;
    no_effect(vti_contacts_effect(&contacts), &good, "fewer contacts than none");
    contacts.count = 0;
    contacts.pair = NULL; /* no list yet: that is sound */
    const vti_effect effect = vti_contacts_effect(&contacts);
    assert_int_equal(vti_apply(&effect, 1, &good), VTI_OK);
    setup(NULL);
    contacts.pair = NULL;
    no_effect(effect, &good, "contacts that lose their pairs");
    assert_true(isnan(vti_energy(&effect, 1, &good)));
    contacts.pair = pair;
    contacts.diameter.p = NULL;
    no_effect(effect, &good, "contacts that lose their sizes");
    contacts.diameter = vti_scalars_one(&diameter);
    contacts.count = -3;
    assert_int_equal(vti_apply(&effect, 1, &good), VTI_E_COUNT);
    contacts.count = 1;
    assert_int_equal(vti_apply(&effect, 1, &good), VTI_OK);
    assert_true(vti_energy(&effect, 1, &good) > 0);
}

/** Bonds read positions and attitudes: bodies that have none are refused by those terms that do. */
static void bonds_of_what_is_not_there(void **state)
{
    (void)state;
    enum { MOMENT = 1, AXIAL = 2, SHEAR = 4 };
    for (int terms = 0; terms < 8; ++terms)
        for (int form = VTI_SHEAR_OBJECTIVE; form <= VTI_SHEAR_PRINTED; ++form) {
            const vti_scalars k = vti_scalars_one(&stiffness), none = {NULL, 0, 0};
            bonds.moment = terms & MOMENT ? k : none;
            bonds.axial = terms & AXIAL ? k : none;
            bonds.shear = terms & SHEAR ? k : none;
            bonds.shear_form = form;
            const vti_effect effect = vti_bonds_effect(&bonds);
            vti_bodies b = good;
            b.x = b.x_low = vti_view_none();
            if (terms & (AXIAL | SHEAR))
                no_effect(effect, &b, "bonds without positions");
            else
                assert_int_equal(vti_apply(&effect, 1, &b), VTI_OK);
            setup(NULL);
            bonds.moment = terms & MOMENT ? k : none;
            bonds.axial = terms & AXIAL ? k : none;
            bonds.shear = terms & SHEAR ? k : none;
            bonds.shear_form = form;
            b = good;
            b.alpha = vti_view_none();
            if (terms & (MOMENT | SHEAR))
                no_effect(effect, &b, "bonds without attitudes");
            else
                assert_int_equal(vti_apply(&effect, 1, &b), VTI_OK);
            setup(NULL);
        }
    bonds.count = 0;
    const vti_effect none = vti_bonds_effect(&bonds);
    const vti_bodies nothing = vti_bodies_none(N);
    assert_int_equal(vti_apply(&none, 1, &nothing), VTI_OK);
}

static void null_arguments(void **state)
{
    (void)state;
    double r[4];
    vti_stable h;
    vti_fault fault;
    vti_bonds half = bonds;
    vti_contacts pairless = contacts;
    const vti_effect effects[] = {vti_bonds_effect(&bonds), vti_contacts_effect(&pairless)};
    pairless.pair = NULL;
    half.pair = NULL;
    assert_int_equal(vti_bonds_check(NULL, N, &fault), VTI_E_NULL);
    assert_int_equal(vti_bonds_check(&half, N, NULL), VTI_E_NULL);
    no_effect(vti_bonds_effect(&half), &good, "bonds without pairs");
    half = bonds;
    half.rest = NULL;
    assert_int_equal(vti_bonds_check(&half, N, NULL), VTI_E_NULL);
    no_effect(vti_bonds_effect(&half), &good, "bonds without rest vectors");
    assert_int_equal(vti_bonds_check(&bonds, -1, NULL), VTI_E_COUNT);
    assert_int_equal(vti_bonds_check(&bonds, 1, &fault), VTI_E_BOND);
    assert_int_equal(vti_bonds_rest(1, NULL, 0, &good.x, r, &fault), VTI_E_NULL);
    assert_int_equal(vti_bonds_rest(1, pair, 0, NULL, r, &fault), VTI_E_NULL);
    assert_int_equal(vti_bonds_rest(1, pair, 0, &good.x, NULL, &fault), VTI_E_NULL);
    assert_int_equal(vti_bonds_rest(-1, pair, 0, &good.x, r, NULL), VTI_E_COUNT);
    assert_int_equal(vti_stable_step(NULL, 1, &good, NULL, scratch, &h), VTI_E_NULL);
    assert_int_equal(vti_stable_step(NULL, -1, &good, NULL, scratch, &h), VTI_E_COUNT);
    assert_int_equal(vti_stable_step(effects, 1, &good, NULL, NULL, &h), VTI_E_NULL);
    assert_int_equal(vti_stable_step(effects, 1, &good, NULL, scratch, NULL), VTI_E_NULL);
    assert_int_equal(vti_stable_step(effects, 2, &good, NULL, scratch, &h), VTI_E_NULL);
    assert_int_equal(vti_apply(NULL, 1, &good), VTI_E_NULL);
    assert_int_equal(vti_apply(NULL, -1, &good), VTI_E_COUNT);
    assert_true(isnan(vti_energy(NULL, 1, &good)) && isnan(vti_energy(NULL, -1, &good)));
    assert_int_equal(vti_step_check(NULL, NULL, 0), VTI_E_STEPPER);
    assert_int_equal(vti_step_check(vti2(), NULL, 1), VTI_E_NULL);
    assert_int_equal(vti_step_check(vti2(), NULL, -1), VTI_E_COUNT);
    assert_int_equal(vti_step_begin(NULL, 0.125, &good, &fault), VTI_E_STEPPER);
    assert_int_equal(vti_step_finish(NULL, 0.125, &good), VTI_E_STEPPER);
    assert_int_equal(vti_step_start(NULL, 0.125, &good), VTI_E_STEPPER);
    assert_int_equal(vti_step_sync(NULL, 0.125, &good), VTI_E_STEPPER);
    assert_int_equal(vti_step_probe(NULL, 0, 0.125, &good, &good), VTI_E_STEPPER);
    assert_int_equal(vti_drift(99, VTI_FRAME_SPACE, 0.125, &good, NULL), VTI_E_STEPPER);
    assert_int_equal(vti_drift(VTI_LAW_EXACT, 99, 0.125, &good, NULL), VTI_E_FRAME);
    vti_momentum(&good, NULL);
    vti_spin(&good, NULL);
    vti_angular_momentum(&good, r, NULL);
    vti_angular_momentum(&good, NULL, r);
    assert_true(isnan(r[0]));
    vti_pendulum_arm(NULL, &good, 0, r);
    assert_true(isnan(r[0]));
    vti_pendulum_arm(&pendulum, &good, 0, NULL);
    no_effect(vti_bonds_effect(NULL), &good, "no bonds");
    no_effect(vti_contacts_effect(NULL), &good, "no contacts");
    no_effect(vti_walls_effect(NULL), &good, "no walls");
    no_effect(vti_gravity_effect(NULL), &good, "no gravity");
    no_effect(vti_pendulum_effect(NULL), &good, "no pendulum");
    assert_null(vti_stepper_find(NULL));
    assert_null(vti_stepper_at(-1));
    assert_null(vti_stepper_at(INT64_MAX));
    assert_memory_equal(&now, &before, sizeof now);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(times, setup),          cmocka_unit_test_setup(packed, setup),
        cmocka_unit_test_setup(lists, setup),          cmocka_unit_test_setup(bonds_of_what_is_not_there, setup),
        cmocka_unit_test_setup(null_arguments, setup),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
