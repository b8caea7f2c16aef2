/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Mass, centre and moments of clumps against closed forms: disjoint spheres to rounding, overlapping ones to the error
 * of the lines. */
#include "support.h"

static vti_solid solid;

static void make(int64_t n, const double *centre, const double *diameter, double density, int64_t lines)
{
    vti_fault fault;
    assert_int_equal(vti_clump_solid(n, centre, diameter, density, lines, &solid, &fault), VTI_OK);
}

/** Moments ascend; principal is a unit quaternion, w >= 0, largest components of the first two axes positive. */
static void check_frame(void)
{
    double q[4], norm = 0;
    memcpy(q, solid.principal, sizeof q);
    for (int k = 0; k < 4; ++k)
        norm += q[k] * q[k];
    assert_close(norm, 1, 4 * EPS);
    assert_true(q[3] >= 0 && solid.moments[0] <= solid.moments[1] && solid.moments[1] <= solid.moments[2]);
    for (int axis = 0; axis < 2; ++axis) {
        const double e[3] = {axis == 0, axis == 1, 0};
        double r[3];
        vti_pair_rotate(q, 1, e, r);
        const double most = fmax(fmax(r[0], r[1]), r[2]), least = fmin(fmin(r[0], r[1]), r[2]);
        assert_true(most >= -least - 8 * EPS);
    }
}

/** R diag(moments) R^T against the tensor xx, yy, zz, xy, xz, yz. */
static void check_tensor(const double J[6], double tolerance)
{
    static const int row[6] = {0, 1, 2, 0, 0, 1}, column[6] = {0, 1, 2, 1, 2, 2};
    double axis[3][3];
    for (int k = 0; k < 3; ++k) {
        const double e[3] = {k == 0, k == 1, k == 2};
        vti_pair_rotate(solid.principal, 1, e, axis[k]);
    }
    for (int k = 0; k < 6; ++k) {
        double sum = 0;
        for (int l = 0; l < 3; ++l)
            sum += solid.moments[l] * axis[l][row[k]] * axis[l][column[k]];
        assert_close(sum, J[k], tolerance);
    }
    check_frame();
}

static double sphere_mass(double density, double diameter)
{
    return density * PI / 6 * diameter * diameter * diameter;
}

TEST(one_sphere)
{
    const double centre[3] = {1e3, -2, 3}, diameter = 0.5, m = sphere_mass(4, 0.5), J = 0.1 * m * 0.25;
    make(1, centre, &diameter, 4, 1);
    assert_close(solid.mass, m, 4 * EPS * m);
    assert_close3(solid.centre, centre, EPS * 1e3);
    for (int k = 0; k < 3; ++k)
        assert_close(solid.moments[k], J, 8 * EPS * J);
    check_frame();
}

/** Disjoint spheres anywhere: sum 2/5 m R^2 + m (|r|^2 - r r^T) about sum m c/m. */
TEST(disjoint_spheres)
{
    rng g = rng_seed(4201);
    for (int trial = 0; trial < 200; ++trial) {
        double centre[5][3], diameter[5], mass = 0, c[3] = {0, 0, 0}, J[6] = {0};
        for (int s = 0; s < 5; ++s) {
            diameter[s] = uniform(&g, 0.2, 0.8);
            random_vector(&g, 0.05, centre[s]);
            centre[s][trial % 3] += s - 2; /* apart from each other along an axis */
            centre[s][(trial + 1) % 3] += s % 2;
            mass += sphere_mass(2, diameter[s]);
            for (int k = 0; k < 3; ++k)
                c[k] += sphere_mass(2, diameter[s]) * centre[s][k];
        }
        for (int s = 0; s < 5; ++s) {
            const double m = sphere_mass(2, diameter[s]), own = 0.1 * m * diameter[s] * diameter[s];
            double r[3];
            for (int k = 0; k < 3; ++k)
                r[k] = centre[s][k] - c[k] / mass;
            for (int k = 0; k < 3; ++k)
                J[k] += own + m * (vti_dot(r, r) - r[k] * r[k]);
            J[3] -= m * r[0] * r[1];
            J[4] -= m * r[0] * r[2];
            J[5] -= m * r[1] * r[2];
        }
        make(5, centre[0], diameter, 2, 1);
        assert_close(solid.mass, mass, 8 * EPS * mass);
        for (int k = 0; k < 3; ++k)
            assert_close(solid.centre[k], c[k] / mass, 16 * EPS);
        check_tensor(J, 200 * EPS * mass); /* five terms of mass times up to 5, and a dozen rotations */
    }
}

/** A tetrapod of four touching spheres of diameter 1 is as round as a sphere: (8/5 R^2 + 8/3 |r|^2) m. */
TEST(tetrapod)
{
    const double r = sqrt(0.125), m = sphere_mass(1, 1), J = 4 * (0.1 + 2.0 / 3 * 0.375) * m;
    const double centre[4][3] = {{r, r, r}, {r, -r, -r}, {-r, r, -r}, {-r, -r, r}}, d = 1 + 8 * EPS,
                 diameter[4] = {d, d, d, d};
    make(4, centre[0], diameter, 1, 256);
    for (int k = 0; k < 3; ++k)
        assert_close(solid.moments[k], J, 128 * EPS * J); /* rounding has them overlap */
    check_frame();
}

/** int over the caps of a sphere of radius R from z to R: of r^2, r^2 z, r^2 z^2 and r^4, r^2 = R^2 - z^2. */
static void cap(long double R, long double z, long double of[4])
{
    const long double end[2] = {z, R}, sign[2] = {-1, 1};
    of[0] = of[1] = of[2] = of[3] = 0;
    for (int k = 0; k < 2; ++k) {
        const long double a = end[k], a2 = a * a, a3 = a2 * a, a5 = a3 * a2, R2 = R * R;
        of[0] += sign[k] * (R2 * a - a3 / 3);
        of[1] += sign[k] * (R2 * a2 / 2 - a2 * a2 / 4);
        of[2] += sign[k] * (R2 * a3 / 3 - a5 / 5);
        of[3] += sign[k] * (R2 * R2 * a - 2 * R2 * a3 / 3 + a5 / 5);
    }
}

/** Two overlapping spheres of radius R whose centres are 2 d apart, a solid of revolution: along the axis pi/2 int r^4,
 *  across it pi/4 int r^4 + pi int r^2 z^2. */
static void closed_form(double R, double d, double *volume, double *along, double *across)
{
    long double of[4];
    cap(R, -d, of); /* of one sphere what is beyond the plane between them, about its centre, which is at d */
    *volume = (double)(2 * PI_L * of[0]);
    *along = (double)(PI_L * of[3]);
    *across = (double)(PI_L / 2 * of[3] + 2 * PI_L * (of[2] + 2 * d * of[1] + d * d * of[0]));
}

/** EQUATIONS 7.5. */
TEST(overlapping_pair)
{
    static const struct {
        int64_t lines;
        double error;
    } rule[] = {{64, 1e-3}, {128, 4e-4}, {256, 1e-4}};
    const double R = 0.5;
    double volume, along, across;
    for (int k = 0; k < 3; ++k)
        for (int trial = 0; trial < 6; ++trial) {
            rng g = rng_seed(4202 + (uint64_t)trial);
            const double d = 0.1 + 0.05 * trial, diameter[2] = {1, 1};
            double axis[3], centre[2][3];
            closed_form(R, d, &volume, &along, &across);
            random_unit(&g, 3, axis);
            for (int c = 0; c < 3; ++c) {
                centre[0][c] = 7 + d * axis[c];
                centre[1][c] = 7 - d * axis[c];
            }
            make(2, centre[0], diameter, 3, rule[k].lines);
            assert_close(solid.mass, 3 * volume, rule[k].error * 3 * volume);
            assert_close(solid.moments[0], 3 * along, rule[k].error * 3 * along);
            assert_close(solid.moments[1], 3 * across, rule[k].error * 3 * across);
            assert_close(solid.moments[2], 3 * across, rule[k].error * 3 * across);
            for (int c = 0; c < 3; ++c)
                assert_close(solid.centre[c], 7, 1e-12);
            check_frame();
            double long_axis[3];
            const double e[3] = {1, 0, 0};
            vti_pair_rotate(solid.principal, 1, e, long_axis);
            assert_close(fabs(vti_dot(long_axis, axis)), 1, 1e-5);
        }
}

/** Two pairs above each other, and a sphere inside of another, which adds nothing. */
TEST(pieces)
{
    const double centre[5][3] = {{0, 0, 0.2}, {0, 0, -0.2}, {0, 0, 5.2}, {0, 0, 4.8}, {0, 0, 5.2}};
    const double diameter[5] = {1, 1, 1, 1, 0.5};
    double volume, along, across;
    closed_form(0.5, 0.2, &volume, &along, &across);
    make(5, centre[0], diameter, 1, 128);
    assert_close(solid.mass, 2 * volume, 1e-3 * volume);
    assert_close(solid.moments[0], 2 * along, 1e-3 * along);
    assert_close(solid.moments[2], 2 * across + 2 * volume * 6.25, 1e-2 * volume);
    assert_close(solid.centre[2], 2.5, 1e-4);
}

/** A line through a sphere passes several inside of it and inside of each other, before and behind it in the list, in
 *  no order of height: they add nothing. */
TEST(spheres_inside)
{
    const double diameter[8] = {0.2, 0.25, 0.3, 0.7, 2, 0.3, 0.2, 0.25}, m = sphere_mass(1, 2);
    double centre[8][3] = {{0, 0, 0.4}, {0, 0, -0.6}, {0, 0.02, 0},   {0, 0, 0.4},
                           {0, 0, 0},   {0, 0, 0.7},  {0.01, 0, 0.1}, {0, 0, -0.4}};
    make(8, centre[0], diameter, 1, 256);
    assert_close(solid.mass, m, 1e-4 * m);
    for (int k = 0; k < 3; ++k) {
        assert_close(solid.centre[k], 0, 1e-4);
        assert_close(solid.moments[k], 0.4 * m, 1e-3 * m);
    }
}

/** Whatever the spheres, axes point as they should. */
TEST(frames)
{
    rng g = rng_seed(4203);
    for (int trial = 0; trial < 2000; ++trial) {
        double centre[4][3], diameter[4];
        for (int s = 0; s < 4; ++s) {
            diameter[s] = uniform(&g, 0.2, 0.8);
            random_vector(&g, 1, centre[s]);
        }
        make(4, centre[0], diameter, 1, 4);
        check_frame();
    }
}

/** However far they are spread: two overlapping pairs anywhere weigh twice as much as one. */
TEST(pairs_far_apart)
{
    static const double apart[] = {2, 50, 1e3, 1e6};
    double volume, along, across;
    closed_form(0.5, 0.25, &volume, &along, &across);
    for (int k = 0; k < 4; ++k) {
        const double a = apart[k], diameter[4] = {1, 1, 1, 1};
        const double centre[4][3] = {{0, 0, 0}, {0.5, 0, 0}, {a, a, 0}, {a + 0.3, a, 0.4}};
        make(4, centre[0], diameter, 1, 256);
        assert_close(solid.mass, 2 * volume, 1e-4 * volume);
        for (int c = 0; c < 3; ++c)
            assert_close(solid.centre[c], (centre[0][c] + centre[1][c] + centre[2][c] + centre[3][c]) / 4, 1e-4 * a);
    }
}

/** A dumb-bell of two spheres far apart, along any axis, turns about that axis as the two do by themselves, m D^2/10
 *  each; and a long one of overlapping pairs as one pair turns about the line through both. */
TEST(thin)
{
    rng g = rng_seed(4209);
    for (int trial = 0; trial < 60; ++trial) {
        const double a = pow(10, 2 + trial % 11), d = uniform(&g, 0.5, 2), diameter[2] = {d, d};
        double axis[3], centre[2][3], found[3];
        random_unit(&g, 3, axis);
        random_vector(&g, 1, centre[0]);
        for (int k = 0; k < 3; ++k)
            centre[1][k] = centre[0][k] + (trial < 11 ? k == trial % 3 : axis[k]) * a;
        make(2, centre[0], diameter, 3, 8);
        const double m = sphere_mass(3, d), own = 0.2 * m * d * d, far = own + 0.5 * m * a * a;
        assert_close(solid.moments[0], own, 1e-12 * own + m * pow(8 * EPS * a, 2)); /* what rounding puts beside it */
        for (int k = 1; k < 3; ++k)
            assert_close(solid.moments[k], far, 1e-10 * far);
        const double e[3] = {1, 0, 0};
        vti_pair_rotate(solid.principal, 1, e, found);
        double across[3],
            along[3] = {centre[1][0] - centre[0][0], centre[1][1] - centre[0][1], centre[1][2] - centre[0][2]};
        vti_cross(found, along, across);
        assert_true(vti_norm(across) <= 16 * EPS * a);
        check_frame();
    }
    double volume, along, across;
    closed_form(0.5, 0.25, &volume, &along, &across);
    for (double a = 1e2; a < 1e9; a *= 10) { /* two of them beside each other, along an axis that is none of x, y, z */
        const double diameter[4] = {1, 1, 1, 1}, u = a * 0.6, w = a * 0.8;
        const double centre[4][3] = {{0, 0, 0}, {0, 0.5, 0}, {u, 0, w}, {u, 0.5, w}};
        make(4, centre[0], diameter, 1, 256);
        assert_close(solid.moments[0], 2 * across, 1e-3 * across);
    }
}

/** A sphere that n equal ones in a row overlap: n balls without the lenses between two that follow each other,
 *  whichever stands where in the list, and more of them than the code keeps in mind. */
TEST(rows)
{
    enum { MOST = 140 };
    static const int counts[] = {3, 9, MOST};
    for (int k = 0; k < 3; ++k) {
        const int n = counts[k];
        const double step = k == 2 ? 0.005 : 0.3, axis[3] = {0.36, 0.48, 0.8};
        double centre[MOST][3], diameter[MOST], volume, along, across;
        for (int s = 0; s < n; ++s) {
            diameter[s] = 1;
            for (int c = 0; c < 3; ++c)
                centre[s][c] = (s * 2 % n) * step * axis[c];
        }
        if (n % 2 == 0) /* the odd places */
            for (int s = n / 2; s < n; ++s)
                for (int c = 0; c < 3; ++c)
                    centre[s][c] += step * axis[c];
        closed_form(0.5, 0.5 * step, &volume, &along, &across);
        const double ball = PI / 6;
        make(n, centre[0], diameter, 1, k == 2 ? 40 : 256);
        assert_close(solid.mass, ball + (n - 1) * (volume - ball), (k == 2 ? 2e-2 : 1e-4) * solid.mass);
        for (int c = 0; c < 3; ++c)
            assert_close(solid.centre[c], 0.5 * (n - 1) * step * axis[c], 1e-3);
    }
}

TEST(refused)
{
    const vti_solid before = solid;
    double centre[6] = {0, 0, 0, 2, 0, 0}, diameter[2] = {1, 1};
    vti_fault fault;
    assert_int_equal(vti_clump_solid(0, centre, diameter, 1, 8, &solid, &fault), VTI_E_COUNT);
    assert_int_equal(vti_clump_solid(2, centre, diameter, 1, 0, &solid, &fault), VTI_E_COUNT);
    assert_int_equal(vti_clump_solid(2, NULL, diameter, 1, 8, &solid, &fault), VTI_E_NULL);
    assert_int_equal(vti_clump_solid(2, centre, NULL, 1, 8, &solid, &fault), VTI_E_NULL);
    assert_int_equal(vti_clump_solid(2, centre, diameter, 1, 8, NULL, NULL), VTI_E_NULL);
    assert_int_equal(vti_clump_solid(2, centre, diameter, NAN, 8, &solid, &fault), VTI_E_MASS);
    assert_int_equal(vti_clump_solid(2, centre, diameter, 0, 8, &solid, &fault), VTI_E_MASS);
    assert_int_equal(fault.quantity, VTI_QUANTITY_MASS);
    diameter[1] = 0;
    assert_int_equal(vti_clump_solid(2, centre, diameter, 1, 8, &solid, &fault), VTI_E_CLUMP);
    assert_true(fault.body == 1 && fault.value == 0);
    diameter[1] = INFINITY;
    assert_int_equal(vti_clump_solid(2, centre, diameter, 1, 8, &solid, &fault), VTI_E_CLUMP);
    diameter[1] = 1;
    centre[5] = NAN;
    assert_int_equal(vti_clump_solid(2, centre, diameter, 1, 8, &solid, &fault), VTI_E_CLUMP);
    assert_int_equal(fault.body, 1);
    centre[5] = 0;
    centre[3] = 1e200; /* squares of which overflow */
    assert_int_equal(vti_clump_solid(2, centre, diameter, 1, 8, &solid, &fault), VTI_E_CLUMP);
    assert_int_equal(fault.body, -1);
    diameter[0] = 1e-120; /* and underflow */
    assert_int_equal(vti_clump_solid(1, centre, diameter, 1, 8, &solid, &fault), VTI_E_MASS);
    diameter[0] = 1e-70; /* moments alone do */
    assert_int_equal(vti_clump_solid(1, centre, diameter, 1, 8, &solid, &fault), VTI_E_CLUMP);
    assert_int_equal(fault.body, -1);
    assert_memory_equal(&solid, &before, sizeof solid); /* what is refused writes nothing */
}

RUN_TESTS(cmocka_unit_test(one_sphere), cmocka_unit_test(disjoint_spheres), cmocka_unit_test(tetrapod),
          cmocka_unit_test(overlapping_pair), cmocka_unit_test(pieces), cmocka_unit_test(spheres_inside),
          cmocka_unit_test(frames), cmocka_unit_test(pairs_far_apart), cmocka_unit_test(thin), cmocka_unit_test(rows),
          cmocka_unit_test(refused))
