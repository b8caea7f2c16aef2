/* SPDX-License-Identifier: BSD-3-Clause
 *
 * NaN and infinity in every field of the interface: a status, or they stay with the body whose they are and whom it
 * acts on, and show there. Nothing is swallowed. */
#include "hard.h"

enum { N = 5, BAD = 2, FIELDS = 8 };

static const double values[3] = {NAN, INFINITY, -INFINITY};
static crowd good, bad;

static void spread(crowd *c)
{
    rng g = rng_seed(71);
    crowd_clear(c, N, CROWD_ALPHA);
    for (int i = 0; i < N; ++i) {
        random_vector(&g, 1, c->x[i]);
        random_vector(&g, 1, c->v[i]);
        random_vector(&g, 1, c->force[i]);
        random_vector(&g, 1, c->alpha[i]);
        random_vector(&g, 0.5, c->omega[i]);
        random_vector(&g, 0.5, c->moment[i]);
    }
}

static const char *const names[FIELDS] = {"x", "v", "force", "alpha", "omega", "moment", "mass", "inertia"};

static double *field_of(crowd *c, int field)
{
    double *const all[FIELDS] = {c->x[BAD],     c->v[BAD],      c->force[BAD], c->alpha[BAD],
                                 c->omega[BAD], c->moment[BAD], &c->mass[BAD], &c->inertia[BAD]};
    return all[field];
}

/** All stages with loads that stay as they are. */
static int play(crowd *c, const vti_stepper *method, double h, vti_fault *fault)
{
    static crowd elsewhere;
    elsewhere = *c;
    const vti_bodies b = crowd_bodies(c);
    vti_bodies probed = crowd_bodies(&elsewhere);
    int status = vti_step_start(method, h, &b);
    for (int64_t k = 0; status == VTI_OK && k < method->stages; ++k) {
        status = vti_step_probe(method, k, h, &b, &probed);
        if (status == VTI_OK)
            status = vti_step_stage(method, k, h, &b, fault);
    }
    return status != VTI_OK ? status : vti_step_finish(method, h, &b);
}

static void others_are_the_same(void)
{
    for (int i = 0; i < N; ++i)
        if (i != BAD) {
            assert_same_bits(good.x[i], bad.x[i], 3);
            assert_same_bits(good.v[i], bad.v[i], 3);
            assert_same_bits(good.alpha[i], bad.alpha[i], 3);
            assert_same_bits(good.omega[i], bad.omega[i], 3);
        }
}

/** One number of one body is none. */
static int in_a_field(const vti_stepper *method, int field, int component, double value)
{
    vti_fault fault = {-1, 0, 0};
    spread(&bad);
    field_of(&bad, field)[component] = value;
    const vti_bodies b = crowd_bodies(&bad);
    if (field >= 6) {
        assert_int_equal(vti_bodies_check_values(&b, &fault), field == 6 ? VTI_E_MASS : VTI_E_INERTIA);
        assert_int_equal(fault.body, BAD);
    }
    const crowd before = bad;
    const int status = play(&bad, method, 0.1, &fault);
    if (status != VTI_OK) {
        assert_int_equal(status, VTI_E_TOO_LARGE);
        assert_int_equal(fault.body, BAD);
        assert_true(!(fault.value < 1));
        assert_memory_equal(&before, &bad, sizeof bad);
        return 1;
    }
    others_are_the_same();
    if (field < 6) /* it does not vanish either: the number itself, or what it drives */
        assert_false(all_finite(bad.x[BAD], 3) && all_finite(bad.v[BAD], 3) && all_finite(bad.alpha[BAD], 3) &&
                     all_finite(bad.omega[BAD], 3));
    return 0;
}

TEST(in_the_bodies)
{
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        const vti_stepper *method = vti_stepper_at(k);
        spread(&good);
        assert_int_equal(play(&good, method, 0.1, NULL), VTI_OK);
        for (int field = 0; field < FIELDS; ++field) {
            int refused = 0, cases = 0;
            for (int v = 0; v < 3; ++v)
                for (int component = 0; component < (field < 6 ? 3 : 1); ++component, ++cases)
                    refused += in_a_field(method, field, component, values[v]);
            char what[64];
            snprintf(what, sizeof what, "NaN, inf or -inf in %s of one body", names[field]);
            if (field >= 6)
                robust(what, method->name, "reported by vti_bodies_check_values: %s",
                       vti_status_text(field == 6 ? VTI_E_MASS : VTI_E_INERTIA));
            else if (refused == cases)
                robust(what, method->name, "reported, bodies unchanged: %s", vti_status_text(VTI_E_TOO_LARGE));
            else
                robust(what, method->name, "shows in that body; others to the bit as without");
        }
    }
}

TEST(in_the_step)
{
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        const vti_stepper *method = vti_stepper_at(k);
        spread(&bad);
        const crowd before = bad;
        const vti_bodies b = crowd_bodies(&bad);
        for (int v = 0; v < 3; ++v) {
            assert_int_equal(play(&bad, method, values[v], NULL), VTI_E_TIME);
            assert_int_equal(vti_kick(values[v], &b), VTI_E_TIME);
            assert_int_equal(vti_drift((int)method->law, (int)method->frame, values[v], &b, NULL), VTI_E_TIME);
        }
        assert_memory_equal(&before, &bad, sizeof bad);
        robust("NaN, inf or -inf as h", method->name, "reported, bodies unchanged: %s", vti_status_text(VTI_E_TIME));
    }
}

/* ---- effects ----------------------------------------------------------------------------------------------------- */

static web w;

/** Bodies 0 and 1 touch each other and the wall at x = 0. */
static vti_bodies touching(void)
{
    crowd_clear(&good, 2, CROWD_ALPHA);
    good.x[0][0] = good.x[1][0] = 0.25;
    good.x[1][1] = 0.5;
    return crowd_bodies(&good);
}

/** One between both, of all three terms. */
static void bond(void)
{
    memset(&w, 0, sizeof w);
    w.pair[0][1] = 1;
    w.rest[0][1] = w.rest[0][3] = w.moment[0] = w.axial[0] = w.shear[0] = 1;
    web_terms(&w, 1, MOMENT | AXIAL | SHEAR, VTI_SHEAR_OBJECTIVE);
}

TEST(bond_parameters)
{
    const double wrong[4] = {NAN, INFINITY, -INFINITY, -1};
    double *const numbers[] = {&w.moment[0],  &w.axial[0],   &w.shear[0],  &w.rest[0][3],
                               &w.rest[0][0], &w.rest[0][1], &w.rest[0][2]};
    for (int k = 0; k < 7; ++k)
        for (int v = 0; v < 4; ++v) {
            vti_fault fault = {-1, 0, 0};
            bond();
            assert_int_equal(vti_bonds_check(&w.bonds, 2, &fault), VTI_OK);
            *numbers[k] = wrong[v];
            if (k == 5 && v == 3)
                continue; /* -1 is as good a direction as 1 */
            assert_int_equal(vti_bonds_check(&w.bonds, 2, &fault), VTI_E_BOND);
            assert_int_equal(fault.body, 0);
        }
    robust("NaN, inf or a negative number in an effect's parameters", "binder", "reported by vti_bonds_check: %s",
           vti_status_text(VTI_E_BOND));
}

/** Walls are looked at before every call; of other effects, and of diameters, NaN comes out where it matters, in force
 *  and energy of those it acts on. */
TEST(other_parameters)
{
    const int64_t pair[2] = {0, 1};
    double diameter[2] = {1, 1}, plane[4] = {1, 0, 0, 0};
    vti_pendulum pendulum = {1, {1, 0, 0.5}};
    vti_gravity gravity = {{0, 0, -1}};
    vti_contacts contacts = {.count = 1, .pair = pair, .diameter = vti_scalars_array(diameter), .stiffness = 10};
    vti_walls walls = {.count = 1, .plane = plane, .diameter = vti_scalars_array(diameter), .stiffness = 10};
    const vti_effect effects[] = {
        vti_contacts_effect(&contacts), vti_contacts_effect(&contacts), vti_walls_effect(&walls),
        vti_walls_effect(&walls),       vti_walls_effect(&walls),       vti_walls_effect(&walls),
        vti_gravity_effect(&gravity),   vti_pendulum_effect(&pendulum), vti_pendulum_effect(&pendulum)};
    double *const numbers[] = {&contacts.stiffness, &diameter[0],  &walls.stiffness, &diameter[0],     &plane[0],
                               &plane[3],           &gravity.g[0], &pendulum.weight, &pendulum.rho0[0]};
    for (int k = 0; k < 9; ++k) {
        const double kept = *numbers[k];
        *numbers[k] = NAN;
        const vti_bodies b = touching();
        const int is_of_wall = k == 2 || k == 4 || k == 5;
        assert_int_equal(vti_apply(effects + k, 1, &b), is_of_wall ? VTI_E_CONTACT : VTI_OK);
        assert_true(is_of_wall || !(all_finite(good.force[0], 3) && all_finite(good.moment[0], 3)));
        assert_true(isnan(vti_energy(effects + k, 1, &b)));
        *numbers[k] = kept;
    }
    static const char *const who[] = {"contact", "gravity", "pendulum"};
    for (int k = 0; k < 3; ++k)
        robust("NaN in an effect's parameters", who[k], "NaN shows in force, moment and energy of those it acts on");
    robust("NaN in an effect's parameters", "wall", "refused; NaN of a body's diameter shows as above");
}

/** What is no number makes no stable step. */
TEST(stable_step)
{
    const int64_t pair[2] = {0, 1};
    double diameter = 1, scratch[2];
    const vti_deformation at = {0.1, 0, 0};
    const double plane[4] = {1, 0, 0, 0};
    vti_contacts contacts = {.count = 1, .pair = pair, .diameter = vti_scalars_one(&diameter), .stiffness = NAN};
    vti_walls walls = {.count = 1, .plane = plane, .diameter = vti_scalars_one(&diameter), .stiffness = NAN};
    vti_pendulum pendulum = {NAN, {1, 0, 0}};
    bond();
    const vti_effect bonds = vti_bonds_effect(&w.bonds);
    const vti_effect effects[] = {
        vti_contacts_effect(&contacts), vti_walls_effect(&walls), vti_pendulum_effect(&pendulum), bonds, bonds, bonds};
    double *const numbers[] = {NULL, NULL, NULL, &w.moment[0], &w.axial[0], &w.shear[0]};
    for (int k = 0; k < 6; ++k) {
        const vti_bodies b = touching();
        if (k >= 3)
            *numbers[k] = NAN;
        vti_stable stable = {7, 0, 0, 0, 0};
        assert_int_equal(vti_stable_step(&effects[k], 1, &b, &at, scratch, &stable), k == 1 ? VTI_E_CONTACT : VTI_OK);
        assert_true(k == 1 || stable.h == 0);
        if (k >= 3)
            *numbers[k] = 1;
    }
    robust("NaN in an effect's parameters", "vti_stable_step", "no step is stable: 0; of a wall refused");
}

/** A position that is none shows in all that the body may touch or is bonded to. */
TEST(positions)
{
    const int64_t pair[2] = {0, 1};
    const double one = 1, plane[4] = {1, 0, 0, 0};
    const vti_contacts contacts = {.count = 1, .pair = pair, .diameter = vti_scalars_one(&one), .stiffness = 10};
    const vti_walls walls = {.count = 1, .plane = plane, .diameter = vti_scalars_one(&one), .stiffness = 10};
    bond();
    const vti_effect effects[] = {vti_contacts_effect(&contacts), vti_walls_effect(&walls), vti_bonds_effect(&w.bonds)};
    static const char *const who[] = {"contact", "wall", "binder"};
    for (int k = 0; k < 3; ++k) {
        const vti_bodies b = touching();
        good.x[0][0] = NAN;
        assert_int_equal(vti_apply(effects + k, 1, &b), VTI_OK);
        assert_false(all_finite(good.force[0], 3));
        assert_true(k == 1 || !all_finite(good.force[1], 3));
        assert_true(isnan(vti_energy(effects + k, 1, &b)));
        robust("NaN in a position", who[k], "shows in the forces of the pair (the body) and in the energy");
    }
}

/** Infinite energies stay infinite: they do not turn into NaN on their way through a compensated sum. */
TEST(infinite_energy)
{
    vti_bodies b = touching();
    good.v[0][0] = 1e200;
    assert_true(vti_kinetic_translation(&b) == INFINITY && vti_energy(NULL, 0, &b) == INFINITY);
    good.v[0][0] = NAN;
    assert_true(isnan(vti_energy(NULL, 0, &b)));
    robust("energy beyond 1e308", "vti_energy", "inf, not NaN");
}

RUN_TESTS(cmocka_unit_test(in_the_bodies), cmocka_unit_test(in_the_step), cmocka_unit_test(bond_parameters),
          cmocka_unit_test(other_parameters), cmocka_unit_test(stable_step), cmocka_unit_test(positions),
          cmocka_unit_test(infinite_energy))
