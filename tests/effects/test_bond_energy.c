/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The energy of every term of a bond against its formula (EQUATIONS 3), evaluated with rotation matrices and libm in
 * long double, and the angle of the relative rotation, which the library finds without libm. */
#include "pair.h"

/* ---- the formulas ------------------------------------------------------------------------------------------------ */

typedef struct expected {
    long double energy, tolerance;
} expected;

/** K/2 |log(R_i R_j^T)|^2. The parts of the relative quaternion round by 4 eps each, its angle is twice an arc and has
 *  another 4 eps of itself; the derivative of the energy by the angle is K theta. */
static expected moment_energy(const pair *p)
{
    const long double theta = mat_angle(mat_times_transpose(mat_of(&p->c, 0), mat_of(&p->c, 1))), k = p->w.moment[0];
    const expected e = {k / 2 * theta * theta, k * theta * (8 + 4 * theta) * EPS};
    return e;
}

/** K/2 (r/L0 - 1)^2; r rounds by 4 eps, and so does the stretch. */
static expected axial_energy(const pair *p)
{
    const long double r = vec_norm(vec_add(vec_of(p->c.x[0]), -1, vec_of(p->c.x[1]))), length = p->w.rest[0][3];
    const long double stretch = (r - length) / length, k = p->w.axial[0];
    const expected e = {k / 2 * stretch * stretch, k * fabsl(stretch) * (4 * r / length + 4 * fabsl(stretch)) * EPS};
    return e;
}

/** 1 - c = 2 sin^2(gamma/2) of the angle gamma between the bond and its direction at rest, which is a chord of the
 *  length 2 sin(gamma/2). The ends of the chord round by 8 eps for each rotation, over |m|/2 where a middle is made
 *  of two. */
static expected shear_energy(const pair *p, int form)
{
    const vec n = vec_add(vec_of(p->c.x[0]), -1, vec_of(p->c.x[1])), n0 = vec_of(p->w.rest[0]);
    const vec bi = mat_apply(mat_of(&p->c, 0), n0), bj = mat_apply(mat_of(&p->c, 1), n0), m = vec_add(bi, 1, bj);
    const int printed = form == VTI_SHEAR_PRINTED;
    const long double gamma = printed ? vec_angle(bi, mat_apply(mat_of(&p->c, 1), n)) : vec_angle(m, n);
    const long double chord = 2 * sinl(gamma / 2), one_minus_c = chord * chord / 2, k = p->w.shear[0];
    const long double rounding = chord * (printed ? 24 : 8 + 32 / vec_norm(m)) * EPS;
    const expected linear = {k * one_minus_c, k * rounding};
    const expected quartic = {k / 2 * one_minus_c * one_minus_c, k * one_minus_c * rounding + k * rounding * rounding};
    return form == VTI_SHEAR_OBJECTIVE ? linear : quartic;
}

static void compare(pair *p, int terms, int form)
{
    double energies[3] = {NAN, NAN, NAN};
    web_terms(&p->w, 1, terms, form);
    const vti_effect effect = vti_bonds_effect(&p->w.bonds);
    const vti_bodies b = crowd_bodies(&p->c);
    const expected all[3] = {moment_energy(p), axial_energy(p), shear_energy(p, form)};
    static const char *const names[3] = {"binder_moment", "binder_axial", "binder_shear"};
    int n = 0;
    effect.energy(effect.self, &b, energies);
    for (int k = 0; k < 3; ++k)
        if (terms >> k & 1) {
            assert_string_equal(effect.term[n], names[k]);
            assert_close(energies[n], all[k].energy, all[k].tolerance);
            ++n;
        }
    assert_int_equal(effect.terms, n);
}

/* ---- states ------------------------------------------------------------------------------------------------------ */

/** Any two attitudes, any bond. */
static void anywhere(pair *p, rng *g, enum crowd_storage storage)
{
    crowd_clear(&p->c, 2, storage);
    crowd_scatter(&p->c, g, 1, 0.3);
    crowd_tumble(&p->c, g);
    random_unit(g, 3, p->w.rest[0]);
    p->w.rest[0][3] = uniform(g, 0.3, 2);
    pair_stiffen(p, g);
}

/** A strained pair, turned as a whole: strains of the size 1e-1 to 1e-12. */
static void strained(pair *p, rng *g, enum crowd_storage storage)
{
    double spare[3], turned[3];
    const double strain = pow(10, uniform(g, -12, -1));
    anywhere(p, g, storage);
    p->w.rest[0][3] = uniform(g, 0.3, 2);
    quat_rotate(crowd_attitude(&p->c, 0), p->w.rest[0], turned);
    crowd_set_attitude(&p->c, 1, crowd_attitude(&p->c, 0));
    for (int i = 0; i < 2; ++i) {
        random_vector(g, 1, spare);
        crowd_turn(&p->c, i, spare, strain * vti_norm(spare));
    }
    random_vector(g, strain, spare);
    for (int k = 0; k < 3; ++k)
        p->c.x[0][k] = p->c.x[1][k] + p->w.rest[0][3] * (turned[k] + spare[k]);
}

TEST(every_term_has_its_closed_form)
{
    rng g = rng_seed(3011);
    for (int trial = 0; trial < 20000; ++trial) {
        pair p;
        int terms, form;
        (trial & 1 ? anywhere : strained)(&p, &g, trial & 2 ? CROWD_QUAT : CROWD_ALPHA);
        web_combination(trial % 15, &terms, &form);
        compare(&p, terms, form);
    }
}

/** Numbers that need no formula: a quarter turn, a bond at twice its length, a bond across its direction at rest. */
TEST(exact_values)
{
    pair p;
    const double e3[3] = {0, 0, 1}, rest[4] = {1, 0, 0, 0.5},
                 value[3][3] = {
                     {PI * PI / 8, 0.5, 1},
                     {PI * PI / 8, 0.5, 0.5},
                     {PI * PI / 8, 0.5, 0.5},
                 };
    for (int form = VTI_SHEAR_OBJECTIVE; form <= VTI_SHEAR_PRINTED; ++form) {
        double energies[3];
        crowd_clear(&p.c, 2, CROWD_ALPHA);
        memcpy(p.w.rest[0], rest, sizeof rest);
        p.w.pair[0][0] = 0;
        p.w.pair[0][1] = 1;
        p.w.moment[0] = p.w.axial[0] = p.w.shear[0] = 1;
        p.c.x[0][2] = 1; /* r = 2 L0, across n0 */
        crowd_turn(&p.c, 0, e3, PI_L / 4);
        crowd_turn(&p.c, 1, e3, -PI_L / 4);
        web_terms(&p.w, 1, MOMENT | AXIAL | SHEAR, form);
        const vti_effect effect = vti_bonds_effect(&p.w.bonds);
        const vti_bodies b = crowd_bodies(&p.c);
        effect.energy(effect.self, &b, energies);
        assert_close3(energies, value[form - 1], 16 * EPS); /* the roundings of the attitudes */
    }
}

/* ---- the angle --------------------------------------------------------------------------------------------------- */

/** -T_i of a moment bond with K = 1 is the rotation vector. Body j has not turned, so that the relative quaternion
 *  is that of body i, exactly. */
static void rotation_vector(const double quat[4], double theta[3])
{
    pair p;
    crowd_clear(&p.c, 2, CROWD_QUAT);
    memset(&p.w, 0, sizeof p.w);
    memcpy(p.c.quat[0], quat, sizeof p.c.quat[0]);
    p.w.pair[0][1] = 1;
    p.w.moment[0] = p.w.rest[0][0] = p.w.rest[0][3] = 1;
    web_terms(&p.w, 1, MOMENT, 0);
    const vti_effect effect = vti_bonds_effect(&p.w.bonds);
    const vti_bodies b = crowd_bodies(&p.c);
    vti_apply(&effect, 1, &b);
    for (int k = 0; k < 3; ++k)
        theta[k] = -p.c.moment[0][k];
}

/* The sum of the roundings in units of eps of theta: k 1 (half of a root's, which is of a sum of squares), its
 * inverse 1/2, the polynomial 3/4, two products 1, less what they share of opposite sign. 1.99 is the most on 2e6
 * points; libm's own angle is within 0.53 ulp, and the difference of both is then at most 3 ulp. */
#define ANGLE (2.5 * EPS)

/** Against libm along one axis, where |theta| is a component. */
TEST(the_angle_is_that_of_libm)
{
    double worst = 0, worst_ulp = 0;
    for (int n = 0; n <= 400000; ++n) {
        const double half = n <= 200000 ? PI / 2 * n / 200000 : pow(10, -300 + 300.0 * (n - 200000) / 200000);
        for (int side = -1; side <= 1; side += 2) {
            double theta[3];
            const double quat[4] = {0, side * sin(half), 0, cos(half)};
            rotation_vector(quat, theta);
            const long double angle = 2 * atan2l(fabsl((long double)quat[1]), quat[3]);
            const double rounded = 2 * atan2(fabs(quat[1]), quat[3]);
            assert_true(theta[0] == 0 && theta[2] == 0);
            assert_true(n > 0 || theta[1] == 0);
            if (n == 0)
                continue;
            worst = fmax(worst, (double)(fabsl(theta[1] - side * angle) / angle));
            worst_ulp = fmax(worst_ulp, fabs(theta[1] - side * rounded) / (nextafter(rounded, 4) - rounded));
        }
    }
    print_message("the angle is within %.3g eps of exact, %.3g ulp of libm's\n", worst / EPS, worst_ulp);
    assert_below(worst, ANGLE);
    assert_below(worst_ulp, 3);
}

TEST(the_angle_at_its_ends)
{
    const double tiny[] = {0, 1e-320, DBL_MIN, 1e-300, 1e-160, 1e-154, 1e-20};
    double theta[3];
    for (size_t k = 0; k < sizeof tiny / sizeof *tiny; ++k) {
        /* theta = 2 v; of a subnormal one unit in the last place may be lost */
        const double quat[4] = {tiny[k], 0, 0, 1};
        rotation_vector(quat, theta);
        assert_close(theta[0], 2 * tiny[k], 2 * ANGLE * tiny[k] + 4.9406564584124654e-324);
    }
    /* a half turn exactly: w = 0 or -0, about an axis of any direction */
    rng g = rng_seed(3012);
    for (int trial = 0; trial < 1000; ++trial) {
        double quat[4] = {0, 0, 0, trial & 1 ? 0.0 : -0.0};
        random_unit(&g, 3, quat);
        rotation_vector(quat, theta);
        assert_true(all_finite(theta, 3));
        assert_close(vti_norm(theta), PI, PI * (ANGLE + 2 * EPS)); /* and the rounding of the norm */
        /* past it the rotation is the shorter one, the other way round */
        quat[3] = -uniform(&g, 1e-9, 0.5);
        rotation_vector(quat, theta);
        const double turn = 2 * atan2(vti_norm(quat), -quat[3]), norm = vti_norm(quat);
        for (int k = 0; k < 3; ++k) /* the norm and the quotient round by 2 eps */
            assert_close(theta[k], -turn * quat[k] / norm, turn * (ANGLE + 2 * EPS));
    }
}

RUN_TESTS(cmocka_unit_test(every_term_has_its_closed_form), cmocka_unit_test(exact_values),
          cmocka_unit_test(the_angle_is_that_of_libm), cmocka_unit_test(the_angle_at_its_ends))
