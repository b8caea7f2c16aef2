/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Energies, momenta and norms against values worked out by hand: small integers, whose products and sums are exact. */
#include "bodies.h"
#include "support.h"

/* body          0          1          2 */
static double x[] = {1, 2, 3, 0, -1, 4, 2, 0, -2};
static double v[] = {1, 0, 2, 3, -1, 0, 0, 2, 1};
static double w[] = {2, 0, 0, 0, 3, 4, 1, 2, 2};
static double a[] = {2, 0, 0, 0, 2, 0, 0, 0, 2}; /* quarter turns about the axes */
static const double mass[] = {2, 1, 4}, inertia[] = {1, 0.5, 2};

static vti_bodies bodies(void)
{
    vti_bodies b = vti_bodies_none(3);
    b.x = vti_view_packed(x);
    b.v = vti_view_packed(v);
    b.omega = vti_view_packed(w);
    b.alpha = vti_view_packed(a);
    b.mass = vti_scalars_array(mass);
    b.inertia = vti_scalars_array(inertia);
    return b;
}

TEST(kinetic_energies)
{
    vti_bodies b = bodies();
    /* (2 * 5 + 1 * 10 + 4 * 5)/2 and (1 * 4 + 0.5 * 25 + 2 * 9)/2 */
    assert_close(vti_kinetic_translation(&b), 20, 0);
    assert_close(vti_kinetic_rotation(&b), 17.25, 0);
    assert_close(vti_energy(NULL, 0, &b), 37.25, 0);
    const vti_bodies last = vti_bodies_slice(b, 1, 2), none = vti_bodies_slice(b, 1, 0);
    assert_close(vti_kinetic_translation(&last), 15, 0);
    assert_close(vti_kinetic_rotation(&last), 15.25, 0);
    assert_close(vti_energy(NULL, 0, &none), 0, 0);
    b.mass = b.inertia = vti_scalars_one(&mass[2]);
    assert_close(vti_kinetic_translation(&b), 40, 0);
    assert_close(vti_kinetic_rotation(&b), 76, 0);
    b.v = b.omega = vti_view_none();
    assert_close(vti_energy(NULL, 0, &b), 0, 0);
}

TEST(momenta)
{
    const vti_bodies b = bodies();
    double r[3];
    const double p[3] = {5, 7, 8}, s[3] = {4, 5.5, 6};
    vti_momentum(&b, r);
    assert_close3(r, p, 0);
    vti_spin(&b, r);
    assert_close3(r, s, 0);
    /* x x v: (4, 1, -2), (4, 12, 3), (4, -2, 4); times m, and the spin */
    const double zero[3] = {0, 0, 0}, about_zero[3] = {28 + 4, 6 + 5.5, 15 + 6};
    vti_angular_momentum(&b, zero, r);
    assert_close3(r, about_zero, 0);
    /* about c: minus c x p with c = (1, 0, 0): (0, -8, 7) */
    const double c[3] = {1, 0, 0}, about_c[3] = {32, 11.5 + 8, 21 - 7};
    vti_angular_momentum(&b, c, r);
    assert_close3(r, about_c, 0);
}

TEST(momenta_of_what_is_absent)
{
    vti_bodies b = bodies();
    const double zero[3] = {0, 0, 0}, s[3] = {4, 5.5, 6}, orbit[3] = {28, 6, 15};
    double r[3];
    b.v = vti_view_none();
    vti_momentum(&b, r);
    assert_close3(r, zero, 0);
    vti_angular_momentum(&b, zero, r);
    assert_close3(r, s, 0);
    b = bodies();
    b.omega = vti_view_none();
    vti_spin(&b, r);
    assert_close3(r, zero, 0);
    vti_angular_momentum(&b, zero, r);
    assert_close3(r, orbit, 0);
    b.x = vti_view_none();
    vti_angular_momentum(&b, zero, r);
    assert_close3(r, zero, 0);
}

/** What has no mass has no energy and no momentum, whatever its velocity. */
TEST(massless)
{
    const double zero[3] = {0, 0, 0}, s[3] = {4, 5.5, 6}, orbit[3] = {28, 6, 15};
    double r[3];
    vti_bodies b = bodies();
    b.mass.p = NULL;
    assert_close(vti_kinetic_translation(&b), 0, 0);
    assert_close(vti_energy(NULL, 0, &b), 17.25, 0);
    vti_momentum(&b, r);
    assert_close3(r, zero, 0);
    vti_angular_momentum(&b, zero, r);
    assert_close3(r, s, 0);
    b = bodies();
    b.inertia.p = NULL;
    assert_close(vti_kinetic_rotation(&b), 0, 0);
    assert_close(vti_energy(NULL, 0, &b), 20, 0);
    vti_spin(&b, r);
    assert_close3(r, zero, 0);
    vti_angular_momentum(&b, zero, r);
    assert_close3(r, orbit, 0);
}

TEST(sums_are_compensated)
{
    double big[] = {1, 0, 0, 1e100, 0, 0, 1, 0, 0, -1e100, 0, 0}, r[3];
    const double one = 1, two[3] = {2, 0, 0};
    vti_bodies b = vti_bodies_none(4);
    b.v = vti_view_packed(big);
    b.mass = vti_scalars_one(&one);
    vti_momentum(&b, r);
    assert_close3(r, two, 0);
    b.omega = b.v;
    b.v = vti_view_none();
    b.inertia = b.mass;
    vti_spin(&b, r);
    assert_close3(r, two, 0);
    vti_angular_momentum(&b, two, r);
    assert_close3(r, two, 0);
}

TEST(turn_per_step)
{
    vti_bodies b = bodies();
    assert_close(vti_max_turn(0.5, &b), 2.5, 0);
    assert_close(vti_max_turn(-0.5, &b), 2.5, 0);
    for (int i = 0; i < 3; ++i) {
        double bad[9];
        memcpy(bad, w, sizeof bad);
        bad[3 * i + 1] = NAN;
        b.omega = vti_view_packed(bad);
        assert_true(isnan(vti_max_turn(0.5, &b)));
    }
    b.omega = vti_view_none();
    assert_close(vti_max_turn(0.5, &b), 0, 0);
}

TEST(norms)
{
    vti_bodies b = bodies();
    /* |x|^2: 14 + 17 + 8; |v|^2: 20; |Omega|^2: 38; theta^2: 3 (pi/2)^2. Rounding: a few eps of each sum. */
    const double turns = 3 * PI * PI / 4, tolerance = 8 * EPS * 105;
    assert_close(vti_h1_density(&b), 39 + 20 + 38 + turns, tolerance);
    b.x = b.v = vti_view_none();
    assert_close(vti_h1_density(&b), 38 + turns, tolerance);
    b.omega = vti_view_none();
    assert_close(vti_h1_density(&b), turns, tolerance);
    b.alpha = vti_view_none();
    assert_close(vti_h1_density(&b), 0, 0);
}

/** Of a slice each sum and norm is that of its bodies alone. */
TEST(slices)
{
    const vti_bodies b = bodies(), last = vti_bodies_slice(b, 1, 2);
    const double zero[3] = {0, 0, 0}, p[3] = {3, 7, 4}, s[3] = {2, 5.5, 6}, l[3] = {20 + 2, 4 + 5.5, 19 + 6};
    double r[3];
    vti_momentum(&last, r);
    assert_close3(r, p, 0);
    vti_spin(&last, r);
    assert_close3(r, s, 0);
    vti_angular_momentum(&last, zero, r);
    assert_close3(r, l, 0);
    const vti_bodies first = vti_bodies_slice(b, 0, 1), second = vti_bodies_slice(b, 1, 1);
    assert_close(vti_max_turn(1, &first), 2, 0);
    assert_close(vti_max_turn(1, &second), 5, 0);
    assert_close(vti_h1_density(&last), 25 + 15 + 34 + 2 * PI * PI / 4, 8 * EPS * 79);
}

static void distances(void **state)
{
    (void)state;
    /* another state, shifted in its arrays by a body: x off by (1, 0, 0), v by (0, 2, 0), Omega by (0, 0, 3) */
    double x2[12], v2[12], w2[12], q2[16] = {0}, a2[12];
    /* identity, the same quarter turn, and the opposite quarter turn: off by pi/2, 0 and pi */
    const double attitudes[9] = {0, 0, 0, 0, 2, 0, 0, 0, -2}, root = sqrt(0.5);
    for (int i = 0; i < 9; ++i) {
        x2[i + 3] = x[i] + (i % 3 == 0 ? 1 : 0);
        v2[i + 3] = v[i] + (i % 3 == 1 ? 2 : 0);
        w2[i + 3] = w[i] + (i % 3 == 2 ? 3 : 0);
        a2[i + 3] = attitudes[i];
    }
    const double expected = 3 * (1 + 4 + 9) + 1.25 * PI * PI;
    vti_bodies b = bodies(), r = bodies();
    r.x = vti_view_packed(x2);
    r.v = vti_view_packed(v2);
    r.omega = vti_view_packed(w2);
    r.alpha = vti_view_packed(a2);
    r = vti_bodies_slice(r, 1, 3);
    for (int stored = 0; stored < 2; ++stored) {
        assert_close(vti_h1_distance(&b, &r), expected, 16 * EPS * expected);
        assert_close(vti_h1_distance(&r, &b), expected, 16 * EPS * expected);
        assert_close(vti_attitude_distance(&b, &r), PI, 4 * EPS);
        const vti_bodies b0 = vti_bodies_slice(b, 0, 2), r0 = vti_bodies_slice(r, 1, 2);
        assert_close(vti_attitude_distance(&b0, &r0), PI / 2, 4 * EPS);
        /* then with the reference held in quaternions, which need not be normalised to the last bit, nor have w > 0 */
        q2[4 + 3] = -1;
        q2[8 + 1] = q2[8 + 3] = q2[12 + 3] = root;
        q2[12 + 2] = -root;
        r.alpha = vti_view_none();
        r.quat = quats_packed(q2);
    }
    assert_close(vti_h1_distance(&b, &b), 0, 0);
    for (int i = 1; i < 4; ++i) {
        const double keep = q2[4 * i];
        q2[4 * i] = NAN;
        assert_true(isnan(vti_attitude_distance(&b, &r)));
        q2[4 * i] = keep;
    }
    b.alpha = vti_view_none();
    r.quat.xyzw[0] = r.quat.xyzw[1] = r.quat.xyzw[2] = r.quat.xyzw[3] = NULL;
    assert_close(vti_attitude_distance(&b, &r), 0, 0);
    assert_close(vti_h1_distance(&b, &r), 42, 0);
}

/** The reference has to have what the bodies have; what it has besides is not looked at. No bodies are no distance
 *  apart. */
TEST(what_can_be_compared)
{
    const size_t offsets[] = {offsetof(vti_bodies, x), offsetof(vti_bodies, v), offsetof(vti_bodies, omega),
                              offsetof(vti_bodies, alpha)};
    const vti_bodies b = bodies(), none = vti_bodies_none(0);
    for (int k = 0; k < 4; ++k) {
        vti_bodies less = b;
        *(vti_view *)((char *)&less + offsets[k]) = vti_view_none();
        assert_true(isnan(vti_h1_distance(&b, &less)));
        assert_true(isnan(vti_h1_distance(&less, &b)) && vti_h1_distance(&less, &less) == 0.0);
        assert_true(k == 3 ? isnan(vti_attitude_distance(&b, &less)) : vti_attitude_distance(&b, &less) == 0.0);
        assert_true(k == 3 ? isnan(vti_attitude_distance(&less, &b)) : vti_attitude_distance(&less, &b) == 0.0);
        assert_true(vti_attitude_distance(&less, &less) == 0.0);
    }
    const vti_bodies empty = vti_bodies_slice(b, 2, 0);
    assert_true(vti_h1_distance(&empty, &none) == 0.0 && vti_attitude_distance(&empty, &none) == 0.0);
}

enum { TERMS = VTI_TERMS };

static void many_energies(const void *self, const vti_bodies *b, double *energies)
{
    (void)self;
    (void)b;
    for (int k = 0; k < TERMS; ++k)
        energies[k] = k;
}

static void no_loads(const void *self, const vti_bodies *b)
{
    (void)self;
    (void)b;
}

/** An effect may have VTI_TERMS terms and books, and no more; of a force without an energy there is no telling it. */
TEST(effects_of_many_terms)
{
    const vti_sum none[TERMS] = {{0.0, 0.0}};
    vti_effect effect = {.name = "many", .apply = no_loads, .energy = many_energies, .terms = TERMS};
    const vti_bodies b = bodies();
    assert_close(vti_energy(&effect, 1, &b), 37.25 + TERMS * (TERMS - 1) / 2, 0);
    effect.books = TERMS;
    effect.booked = none;
    assert_int_equal(vti_effects_check(&effect, 1, &b, NULL), VTI_OK);
    for (int k = 0; k < 4; ++k) {
        const int64_t wrong = k % 2 == 0 ? TERMS + 1 : -1;
        vti_effect other = effect;
        *(k < 2 ? &other.terms : &other.books) = wrong;
        assert_int_equal(vti_effects_check(&other, 1, &b, NULL), VTI_E_COUNT);
        assert_true(isnan(vti_energy(&other, 1, &b)));
    }
    effect.terms = 0;
    effect.energy = NULL;
    assert_true(isnan(vti_energy(&effect, 1, &b)));
}

RUN_TESTS(cmocka_unit_test(kinetic_energies), cmocka_unit_test(momenta), cmocka_unit_test(momenta_of_what_is_absent),
          cmocka_unit_test(massless), cmocka_unit_test(sums_are_compensated), cmocka_unit_test(turn_per_step),
          cmocka_unit_test(norms), cmocka_unit_test(slices), cmocka_unit_test(distances),
          cmocka_unit_test(what_can_be_compared), cmocka_unit_test(effects_of_many_terms))
