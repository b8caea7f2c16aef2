/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Wrong use that a library without memory can see: every way to spoil bodies through every function that takes them. A status
 * with a text where there is one, no number where there is none, nothing written, never a crash. Arguments that are no bodies
 * are in test_misuse_lists.c; test_fortran_misuse.f90 is the same from Fortran. */
#include "misuse.h"

enum { REFUSED = 1 /* by what has no status: its result is not a number */ };

/* ---- every function that takes bodies ------------------------------------------------------------------------------ */

static int no_number(double result)
{
    return isnan(result) ? REFUSED : VTI_OK;
}

static int check(const vti_bodies *b)
{
    return vti_bodies_check(b);
}

/** What check_values, drift and steps, which say more than a status, have to blame. */
static int64_t to_blame;

static int check_values(const vti_bodies *b)
{
    vti_fault fault = {7, 7, 7};
    const int status = vti_bodies_check_values(b, &fault);
    assert_int_equal(fault.body, -1);
    assert_int_equal(fault.quantity, to_blame);
    return vti_bodies_check_values(b, NULL) == status ? status : VTI_OK;
}

static int seal(const vti_bodies *b)
{
    vti_bodies copy;
    if (b == NULL)
        return vti_bodies_seal(NULL);
    copy = *b;
    const int status = vti_bodies_seal(&copy);
    return copy.sealed == 0 ? status : VTI_OK;
}

static int kick(const vti_bodies *b)
{
    return vti_kick(0.125, b);
}

static int drift(const vti_bodies *b)
{
    vti_fault fault;
    const int status = vti_drift(VTI_LAW_CLOSED, VTI_FRAME_SPACE, 0.125, b, &fault);
    assert_int_equal(fault.quantity, to_blame);
    return vti_drift(VTI_LAW_EXACT, VTI_FRAME_BODY, 0.125, b, NULL) == status ? status : VTI_OK;
}

static int all_steps(const vti_bodies *b)
{
    int status = vti_step_begin(vti2(), 0.125, b, NULL), same = 1;
    for (int64_t s = 0; s < vti_stepper_count(); ++s) {
        const vti_stepper *method = vti_stepper_at(s);
        vti_fault fault;
        same &= vti_step_begin(method, 0.125, b, &fault) == status && fault.body == -1 && fault.quantity == to_blame;
        same &= vti_step_stage(method, method->stages - 1, 0.125, b, NULL) == status;
        same &= vti_step_finish(method, 0.125, b) == status;
        same &= vti_step_start(method, 0.125, b) == status && vti_step_sync(method, 0.125, b) == status;
    }
    return same ? status : VTI_OK;
}

static int probe(const vti_bodies *b)
{
    const vti_bodies other = elsewhere();
    return vti_step_probe(vti_stepper_find("chin4"), 0, 0.125, b, &other);
}

static int probed(const vti_bodies *b)
{
    return vti_step_probe(vti_stepper_find("chin4"), 0, 0.125, &good, b);
}

static int apply(const vti_bodies *b)
{
    const vti_effect effects[] = {vti_bonds_effect(&bonds), vti_contacts_effect(&contacts), vti_walls_effect(&walls),
                                  vti_gravity_effect(&gravity), vti_pendulum_effect(&pendulum)};
    const int status = vti_apply(NULL, 0, b);
    for (int64_t k = 0; k < 5; ++k)
        if (vti_apply(&effects[k], 1, b) != status || !isnan(vti_energy(&effects[k], 1, b)))
            return VTI_OK;
    return vti_apply(effects, 5, b) == status ? status : VTI_OK;
}

static int stable(const vti_bodies *b)
{
    const vti_effect effects[] = {vti_bonds_effect(&bonds), vti_contacts_effect(&contacts), vti_walls_effect(&walls),
                                  vti_gravity_effect(&gravity), vti_pendulum_effect(&pendulum)};
    const vti_deformation at = {0.1, 0.1, 1};
    vti_stable found = {7, 7, 7, 7, 7};
    const int status = vti_stable_step(effects, 5, b, &at, scratch, &found);
    const int there = vti_stable_step(effects, 5, b, NULL, scratch, &found);
    return found.h == 7 && found.i == 7 && there == status ? status : VTI_OK;
}

static int measures(const vti_bodies *b)
{
    const double about[3] = {0, 0, 0};
    double sum = vti_kinetic_translation(b), r[3], least = 0;
    const double all[] = {vti_kinetic_rotation(b),
                          vti_energy(NULL, 0, b),
                          vti_max_turn(1, b),
                          vti_h1_density(b),
                          vti_h1_distance(b, &good),
                          vti_h1_distance(&good, b),
                          vti_attitude_distance(b, &good),
                          vti_attitude_distance(&good, b)};
    for (size_t k = 0; k < sizeof all / sizeof *all; ++k)
        least += isnan(all[k]) ? 0 : 1;
    vti_momentum(b, r);
    least += isnan(r[0]) ? 0 : 1;
    vti_spin(b, r);
    least += isnan(r[1]) ? 0 : 1;
    vti_angular_momentum(b, about, r);
    least += isnan(r[2]) ? 0 : 1;
    vti_pendulum_arm(&pendulum, b, 0, r);
    least += isnan(r[0]) ? 0 : 1;
    return least == 0 ? no_number(sum) : VTI_OK;
}

static const struct {
    const char *name;
    int (*call)(const vti_bodies *b);
    int has_status;
} entries[] = {{"check", check, 1}, {"check_values", check_values, 1}, {"seal", seal, 1},        {"kick", kick, 1},
               {"drift", drift, 1}, {"steps", all_steps, 1},           {"probe", probe, 1},      {"probed", probed, 1},
               {"apply", apply, 1}, {"stable_step", stable, 1},        {"measures", measures, 0}};

static void refused(const vti_bodies *b, int status, int64_t quantity, const char *what)
{
    to_blame = quantity;
    for (size_t k = 0; k < sizeof entries / sizeof *entries; ++k) {
        const int found = entries[k].call(b);
        if (found != (entries[k].has_status ? status : REFUSED))
            fail_msg("%s, %s: %d", what, entries[k].name, found);
    }
    assert_memory_equal(&now, &before, sizeof now);
    assert_string_not_equal(vti_status_text(status), vti_status_text(1)); /* a text of its own */
}

/* ---- every way to spoil bodies -------------------------------------------------------------------------------------- */

static void no_bodies_and_wrong_counts(void **state)
{
    (void)state;
    vti_bodies b = good;
    refused(NULL, VTI_E_NULL, VTI_QUANTITY_NONE, "no bodies");
    b.abi = VTI_ABI + 1;
    refused(&b, VTI_E_ABI, VTI_QUANTITY_NONE, "a header of another version");
    memset(&b, 0, sizeof b);
    refused(&b, VTI_E_ABI, VTI_QUANTITY_NONE, "bodies that are all 0");
    memset(&b, 0xa5, sizeof b);
    refused(&b, VTI_E_ABI, VTI_QUANTITY_NONE, "bodies that are garbage");
    b = vti_bodies_slice(good, 0, -1);
    refused(&b, VTI_E_COUNT, VTI_QUANTITY_NONE, "fewer bodies than none");
    b = vti_bodies_slice(good, -1, 2);
    refused(&b, VTI_E_COUNT, VTI_QUANTITY_NONE, "a slice before the first body");
    b = vti_bodies_slice(good, INT64_MAX, INT64_MAX);
    refused(&b, VTI_E_COUNT, VTI_QUANTITY_NONE, "a slice that ends nowhere");
}

static vti_view *view_at(vti_bodies *b, int k)
{
    vti_view *const all[] = {&b->x, &b->v, &b->force, &b->alpha, &b->omega, &b->moment, &b->x_low};
    return all[k];
}

static const int64_t quantity_at[] = {VTI_QUANTITY_X,     VTI_QUANTITY_V,      VTI_QUANTITY_FORCE, VTI_QUANTITY_ALPHA,
                                      VTI_QUANTITY_OMEGA, VTI_QUANTITY_MOMENT, VTI_QUANTITY_X_LOW};

static void views(void **state)
{
    enum { VIEWS = 7 };
    (void)state;
    for (int k = 0; k < VIEWS; ++k) {
        for (int part = 1; part < 7; ++part) {
            vti_bodies b = good;
            for (int c = 0; c < 3; ++c)
                if (part >> c & 1)
                    view_at(&b, k)->c[c] = NULL;
            refused(&b, VTI_E_VIEW, quantity_at[k], "half a view");
        }
        vti_bodies b = good;
        view_at(&b, k)->stride = 0;
        refused(&b, VTI_E_STRIDE, quantity_at[k], "stride 0");
        b = good;
        view_at(&b, k)->c[2] = view_at(&b, k)->c[0];
        refused(&b, VTI_E_ALIAS, quantity_at[k], "two components in one place");
        for (int j = 0; j < k; ++j) {
            b = good;
            *view_at(&b, k) = *view_at(&b, j);
            refused(&b, VTI_E_ALIAS, quantity_at[k], "two quantities in one place");
        }
    }
}

static void quaternions(void **state)
{
    (void)state;
    vti_bodies b = good;
    for (int k = 0; k < 4; ++k)
        b.quat.xyzw[k] = now.quat + k;
    b.quat.stride = 4;
    refused(&b, VTI_E_VIEW, VTI_QUANTITY_QUAT, "the attitude twice");
    b.alpha = vti_view_none();
    const vti_bodies whole = b;
    b.quat.xyzw[3] = NULL;
    refused(&b, VTI_E_VIEW, VTI_QUANTITY_QUAT, "three quarters of a quaternion");
    b = whole;
    b.quat.stride = 0;
    refused(&b, VTI_E_STRIDE, VTI_QUANTITY_QUAT, "quaternions of stride 0");
    b = whole;
    b.quat.xyzw[1] = b.quat.xyzw[2];
    refused(&b, VTI_E_ALIAS, VTI_QUANTITY_QUAT, "two parts of a quaternion in one place");
    b = whole;
    b.omega.c[0] = b.quat.xyzw[0];
    refused(&b, VTI_E_ALIAS, VTI_QUANTITY_OMEGA, "quaternions and spins in one place");
}

static void masses(void **state)
{
    (void)state;
    const double *const bad[] = {&no_mass, &negative, &not_a_number, &bad_times[3], NULL};
    for (int k = 0; k < 5; ++k) {
        vti_bodies b = good;
        b.mass = vti_scalars_one(bad[k]);
        refused(&b, VTI_E_MASS, VTI_QUANTITY_MASS, "one mass for all");
        b = good;
        b.inertia = vti_scalars_one(bad[k]);
        refused(&b, VTI_E_INERTIA, VTI_QUANTITY_INERTIA, "one inertia for all");
        if (bad[k] == NULL)
            continue;
        vti_fault fault;
        now.mass[2] = *bad[k];
        assert_int_equal(vti_bodies_check_values(&good, &fault), VTI_E_MASS);
        assert_true(fault.body == 2 && fault.quantity == VTI_QUANTITY_MASS);
        now.mass[2] = before.mass[2];
        now.inertia[3] = *bad[k];
        assert_int_equal(vti_bodies_check_values(&good, &fault), VTI_E_INERTIA);
        assert_true(fault.body == 3 && fault.quantity == VTI_QUANTITY_INERTIA);
        now.inertia[3] = before.inertia[3];
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(no_bodies_and_wrong_counts, setup),
        cmocka_unit_test_setup(views, setup),
        cmocka_unit_test_setup(quaternions, setup),
        cmocka_unit_test_setup(masses, setup),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
