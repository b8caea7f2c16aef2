/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Bonds with a rotation Q0 at rest (EQUATIONS 6.6): at rest where they were made, minus the derivatives of their
 * energy, unchanged by turning the whole, and the same bits however bodies lie; energies against matrices in long
 * double. */
#include "matrix.h"

static crowd c, other;
static web w;
static double turn[WEB_MAX][4];

/** The terms and form of number 0-10 of web_combination: those that know turns. */
enum { OBJECTIVE = 11 };

/** A crowd everywhere, bonded as it is now; terms and form of the combination. */
static int64_t make_now(rng *g, int n, int extra, int combination, enum crowd_storage storage)
{
    int terms, form;
    crowd_clear(&c, n, storage);
    crowd_scatter(&c, g, 2, 0.2);
    crowd_tumble(&c, g);
    const int64_t count = web_grow(&w, g, &c, extra, 1, 20);
    const vti_bodies b = crowd_bodies(&c);
    web_combination(combination, &terms, &form);
    web_terms(&w, count, terms, form);
    assert_int_equal(vti_bonds_rest_now(count, w.pair[0], 0, &b, w.rest[0], turn[0], NULL), VTI_OK);
    w.bonds.turn = turn[0];
    assert_int_equal(vti_bonds_check(&w.bonds, n, NULL), VTI_OK);
    return count;
}

static void strain(rng *g)
{
    crowd_scatter(&c, g, 2, 0.2);
    crowd_tumble(&c, g);
}

static void loads(crowd *of)
{
    const vti_effect effect = vti_bonds_effect(&w.bonds);
    const vti_bodies b = crowd_bodies(of);
    assert_int_equal(vti_apply(&effect, 1, &b), VTI_OK);
}

static double energy_of(crowd *of)
{
    const vti_effect effect = vti_bonds_effect(&w.bonds);
    const vti_bodies b = crowd_bodies(of);
    return vti_energy(&effect, 1, &b);
}

/** Made now, a bond holds nothing: loads of its rounding, 16 eps of K/r and K, energies of its square. */
TEST(at_rest_where_it_was_made)
{
    rng g = rng_seed(6601);
    for (int trial = 0; trial < OBJECTIVE * 6; ++trial) {
        static double measures[WEB_MAX][VTI_BOND_MEASURES];
        const int64_t count = make_now(&g, 2 + trial / OBJECTIVE * 9, trial % 7, trial % OBJECTIVE, trial & 1);
        const vti_bodies b = crowd_bodies(&c);
        loads(&c);
        assert_int_equal(vti_bonds_measure(&w.bonds, &b, 0, count, measures[0]), VTI_OK);
        for (int64_t k = 0; k < count; ++k)
            assert_below(measures[k][VTI_BOND_ENERGY], 20 * pow(16 * EPS, 2) * 3);
        for (int i = 0; i < c.n; ++i)
            for (int q = 0; q < 3; ++q) { /* at most WEB_MAX bonds of K <= 20 and r >= 0.2 meet at a body */
                assert_below(fabs(c.force[i][q]), (double)count * 16 * EPS * 20 / 0.2);
                assert_below(fabs(c.moment[i][q]), (double)count * 16 * EPS * 20);
            }
        assert_below(energy_of(&c), (double)count * 20 * pow(16 * EPS, 2) * 3);
    }
}

static mat mat_of_turn(const double q[4])
{
    const vec v = vec_of(q);
    return mat_rodrigues(v, q[3], 2 / (q[3] * (long double)q[3] + vec_dot(v, v)));
}

/** K/2 theta^2 of R_i Q0 R_j^T, K/2 (r/L0 - 1)^2 and K (1 - c), c = n.(R_i n0 + R_j Q0^T n0)/|...|. */
static long double by_matrices(int64_t k, long double *angle)
{
    const int64_t i = w.pair[k][0], j = w.pair[k][1];
    const mat turned = mat_times_transpose(mat_of(&c, (int)j), mat_of_turn(turn[k]));
    const vec d = vec_add(vec_of(c.x[i]), -1, vec_of(c.x[j])), n0 = vec_of(w.rest[k]);
    const vec m = vec_add(mat_apply(mat_of(&c, (int)i), n0), 1, mat_apply(turned, n0));
    *angle = mat_angle(mat_times_transpose(mat_of(&c, (int)i), turned));
    const long double stretch = vec_norm(d) / w.rest[k][3] - 1, bent = 1 - cosl(vec_angle(d, m));
    return w.moment[k] / 2 * *angle * *angle + w.axial[k] / 2 * stretch * stretch + w.shear[k] * bent;
}

TEST(energies_by_matrices)
{
    rng g = rng_seed(6602);
    for (int trial = 0; trial < 300; ++trial) {
        double measures[VTI_BOND_MEASURES];
        long double angle;
        make_now(&g, 2, 0, 6, trial & 1);
        strain(&g);
        const vti_bodies b = crowd_bodies(&c);
        const long double expected = by_matrices(0, &angle);
        assert_int_equal(vti_bonds_measure(&w.bonds, &b, 0, 1, measures), VTI_OK);
        const double size = w.moment[0] * 5 + w.axial[0] * pow(measures[VTI_BOND_STRETCH] + 2, 2) + 2 * w.shear[0];
        assert_close(energy_of(&c), expected, 64 * EPS * size);
        assert_close(measures[VTI_BOND_ENERGY], expected, 64 * EPS * size);
        const double bending = measures[VTI_BOND_BENDING], torsion = measures[VTI_BOND_TORSION];
        assert_close(bending * bending + torsion * torsion, powl(w.moment[0] * angle, 2),
                     256 * EPS * pow(w.moment[0] * PI, 2));
    }
}

/** Q0 on the rest attitude of j is j turned by Q0^T: the loads of the one are those of the other. */
TEST(a_turn_is_another_attitude)
{
    rng g = rng_seed(6603);
    for (int trial = 0; trial < OBJECTIVE * 20; ++trial) {
        make_now(&g, 2, 0, trial % OBJECTIVE, trial & 1);
        strain(&g);
        other = c;
        const int j = (int)w.pair[0][1];
        const rotor q0 = {-turn[0][0], -turn[0][1], -turn[0][2], turn[0][3]};
        crowd_set_attitude(&other, j, quat_times(crowd_attitude(&other, j), q0));
        loads(&c);
        w.bonds.turn = NULL;
        loads(&other);
        w.bonds.turn = turn[0];
        /* attitudes are rounded: 16 eps of loads as large as K/(r |m|); |m| above 1e-3 */
        for (int i = 0; i < 2; ++i)
            for (int q = 0; q < 3; ++q) {
                assert_close(c.force[i][q], other.force[i][q], 1e5 * EPS * (1 + fabs(other.force[i][q])));
                assert_close(c.moment[i][q], other.moment[i][q], 1e5 * EPS * (1 + fabs(other.moment[i][q])));
            }
    }
}

/** Central differences of third order in the energy of a pair, by the positions and by spatial turns. */
TEST(loads_are_minus_the_gradient)
{
    rng g = rng_seed(6604);
    for (int trial = 0; trial < OBJECTIVE * 40; ++trial) {
        const double t = 1e-4;
        do { /* away from the kink at half a turn and from b_i = -b_j, where differences say nothing */
            make_now(&g, 2, 0, trial % OBJECTIVE, trial & 1);
            other = c;
            for (int i = 0; i < 2; ++i) {
                double axis[3], shift[3];
                random_unit(&g, 3, axis);
                random_vector(&g, 0.2, shift);
                crowd_turn(&c, i, axis, uniform(&g, 0, 0.7));
                for (int q = 0; q < 3; ++q)
                    c.x[i][q] += shift[q];
            }
        } while (w.rest[0][3] < 0.8);
        loads(&c);
        const crowd at = c;
        for (int k = 0; k < 12; ++k) {
            const int i = k / 6, q = k % 6;
            const double axis[3] = {q == 3, q == 4, q == 5};
            double e[4];
            for (int s = 0; s < 4; ++s) {
                const double by = (s & 1 ? -1 : 1) * (s & 2 ? 2 : 1) * t;
                other = at;
                if (q < 3)
                    other.x[i][q] += by;
                else
                    crowd_turn(&other, i, axis, by);
                e[s] = energy_of(&other);
            }
            const double slope = (8 * (e[0] - e[1]) - (e[2] - e[3])) / (12 * t);
            /* t^4 of a fifth derivative below 1e4 K, and energies of up to 100 to 16 eps over t */
            assert_close(q < 3 ? at.force[i][q] : at.moment[i][q - 3], -slope, 20 * (1e-12 + 1e3 * EPS / t));
        }
    }
}

/** x -> Q x + s, R -> Q R: loads turn with the whole, energies stay. */
TEST(rigid_motion)
{
    rng g = rng_seed(6605);
    for (int trial = 0; trial < OBJECTIVE * 20; ++trial) {
        double axis[3], shift[3];
        make_now(&g, 2, 0, trial % OBJECTIVE, trial & 1);
        strain(&g);
        other = c;
        random_unit(&g, 3, axis);
        random_vector(&g, 3, shift);
        const rotor q = quat_turn(axis, uniform(&g, 0.5, PI));
        for (int i = 0; i < 2; ++i) {
            quat_rotate(q, other.x[i], other.x[i]);
            for (int k = 0; k < 3; ++k)
                other.x[i][k] += shift[k];
            crowd_set_attitude(&other, i, quat_times(q, crowd_attitude(&other, i)));
        }
        loads(&c);
        loads(&other);
        assert_close(energy_of(&other), energy_of(&c), 1e4 * EPS * (1 + energy_of(&c)));
        for (int i = 0; i < 2; ++i) {
            double f[3], m[3];
            quat_rotate(q, c.force[i], f);
            quat_rotate(q, c.moment[i], m);
            const double size = 1 + vti_norm(f) + vti_norm(m);
            for (int k = 0; k < 3; ++k) {
                assert_close(other.force[i][k], f[k], 1e6 * EPS * size);
                assert_close(other.moment[i][k], m[k], 1e6 * EPS * size);
            }
        }
    }
}

/** Many are the sum of one at a time, in every layout, in parts, and where an alpha is so large that it is scaled. */
TEST(same_bits)
{
    rng g = rng_seed(6606);
    const int bodies[] = {2, 5, 20, 64, 80};
    for (int trial = 0; trial < OBJECTIVE * 5; ++trial) {
        static double rows[WEB_MAX * VTI_BOND_LOADS], spread[CROWD_MAX][7];
        const int64_t count = make_now(&g, bodies[trial / OBJECTIVE], trial % 60, trial % OBJECTIVE, trial & 1);
        strain(&g);
        if (trial % 3 == 0)
            crowd_set_attitude(&c, 0, (rotor){1, 0, 0, 1e-19L});
        loads(&c);
        other = c;
        memset(other.force, 0, sizeof other.force);
        memset(other.moment, 0, sizeof other.moment);
        vti_bodies b = crowd_bodies(&other);
        for (int64_t k = 0; k < count; ++k) {
            vti_bonds one = w.bonds;
            one.count = 1;
            one.pair = w.pair[k];
            one.rest = w.rest[k];
            one.turn = turn[k];
            one.moment.p = one.moment.p != NULL ? w.moment + k : NULL;
            one.axial.p = one.axial.p != NULL ? w.axial + k : NULL;
            one.shear.p = one.shear.p != NULL ? w.shear + k : NULL;
            const vti_effect e = vti_bonds_effect(&one);
            e.apply(e.self, &b);
        }
        assert_same_bits(other.force[0], c.force[0], 3 * c.n);
        assert_same_bits(other.moment[0], c.moment[0], 3 * c.n);
        /* positions at a stride of seven, and loads in two passes */
        memset(other.force, 0, sizeof other.force);
        memset(other.moment, 0, sizeof other.moment);
        for (int i = 0; i < c.n; ++i)
            memcpy(spread[i], c.x[i], sizeof c.x[i]);
        b.x = (vti_view){{spread[0], spread[0] + 1, spread[0] + 2}, 7, 0};
        const int64_t half = count / 2;
        assert_int_equal(vti_bonds_loads(&w.bonds, &b, 0, half, rows), VTI_OK);
        assert_int_equal(vti_bonds_loads(&w.bonds, &b, half, count, rows + half * VTI_BOND_LOADS), VTI_OK);
        assert_int_equal(vti_bonds_sum(&w.bonds, rows, 0, count, &b), VTI_OK);
        assert_same_bits(other.force[0], c.force[0], 3 * c.n);
        assert_same_bits(other.moment[0], c.moment[0], 3 * c.n);
    }
}

TEST(refused)
{
    rng g = rng_seed(6607);
    vti_fault fault = {-1, -1, 0};
    const int64_t count = make_now(&g, 8, 4, 6, CROWD_ALPHA), k = 5;
    const double kept[4] = {turn[k][0], turn[k][1], turn[k][2], turn[k][3]};
    vti_bodies b = crowd_bodies(&c);
    for (int q = 0; q < 4; ++q)
        turn[k][q] *= 2;
    assert_int_equal(vti_bonds_check(&w.bonds, 8, &fault), VTI_E_BOND);
    assert_true(fault.body == k && fabs(fault.value - 2) < 8 * EPS);
    turn[k][1] = NAN;
    assert_int_equal(vti_bonds_check(&w.bonds, 8, &fault), VTI_E_BOND);
    assert_true(fault.body == k && isnan(fault.value));
    memcpy(turn[k], kept, sizeof kept);
    w.bonds.shear_form = VTI_SHEAR_PRINTED; /* that knows one frame only */
    const vti_effect printed = vti_bonds_effect(&w.bonds);
    assert_int_equal(vti_bonds_check(&w.bonds, 8, &fault), VTI_E_BOND);
    assert_true(fault.body == -1 && fault.value == VTI_SHEAR_PRINTED);
    assert_int_equal(vti_apply(&printed, 1, &b), VTI_E_BOND);
    w.bonds.shear.p = NULL; /* without shear its form says nothing */
    assert_int_equal(vti_bonds_check(&w.bonds, 8, NULL), VTI_OK);

    double rest[4] = {7, 7, 7, 7}, q0[4] = {7, 7, 7, 7};
    int64_t pair[2] = {0, 8};
    assert_int_equal(vti_bonds_rest_now(1, pair, 0, &b, rest, q0, &fault), VTI_E_BOND);
    assert_true(fault.body == 0 && fault.value == 8);
    pair[1] = -1;
    assert_int_equal(vti_bonds_rest_now(1, pair, 0, &b, rest, q0, &fault), VTI_E_BOND);
    assert_true(fault.body == 0 && fault.value == -1);
    pair[1] = 5;
    b.x.count = 8;
    b.alpha.count = 5; /* of which there is a place, but no attitude */
    b.count = 4;
    assert_int_equal(vti_bonds_rest_now(1, pair, 0, &b, rest, q0, &fault), VTI_E_BOND);
    assert_true(fault.body == 0 && fault.value == 5);
    b = crowd_bodies(&c);
    b.alpha = vti_view_none();
    b.quat = quats_packed(c.quat[0]); /* likewise */
    b.quat.count = 5;
    b.x.count = 8;
    b.count = 4;
    assert_int_equal(vti_bonds_rest_now(1, pair, 0, &b, rest, q0, &fault), VTI_E_BOND);
    assert_true(fault.body == 0 && fault.value == 5);
    b = crowd_bodies(&c);
    pair[1] = INT64_MAX;
    assert_int_equal(vti_bonds_rest_now(1, pair, -1, &b, rest, q0, NULL), VTI_E_BOND);
    pair[1] = 1;
    c.alpha[1][2] = NAN;
    assert_int_equal(vti_bonds_rest_now(1, pair, 0, &b, rest, q0, &fault), VTI_E_BOND);
    assert_true(fault.body == 0 && isnan(fault.value));
    c.alpha[1][2] = 0;
    memcpy(c.x[1], c.x[0], sizeof c.x[1]);
    assert_int_equal(vti_bonds_rest_now(1, pair, 0, &b, rest, q0, &fault), VTI_E_BOND);
    assert_true(fault.body == 0 && fault.value == 0);
    assert_int_equal(vti_bonds_rest_now(-1, pair, 0, &b, rest, q0, NULL), VTI_E_COUNT);
    assert_int_equal(vti_bonds_rest_now(1, pair, 0, NULL, rest, q0, NULL), VTI_E_NULL);
    assert_int_equal(vti_bonds_rest_now(1, NULL, 0, &b, rest, q0, NULL), VTI_E_NULL);
    assert_int_equal(vti_bonds_rest_now(1, pair, 0, &b, NULL, q0, NULL), VTI_E_NULL);
    assert_int_equal(vti_bonds_rest_now(1, pair, 0, &b, rest, NULL, NULL), VTI_E_NULL);
    assert_int_equal(vti_bonds_rest_now(0, NULL, 0, &b, NULL, NULL, NULL), VTI_OK);
    for (int view = 0; view < 3; ++view) { /* of an empty slice nothing else looks at views */
        vti_bodies part = vti_bodies_slice(crowd_bodies(&c), 0, 0);
        if (view == 2) {
            part.alpha = vti_view_none();
            part.quat.xyzw[0] = c.alpha[0];
        } else {
            (view == 0 ? &part.x : &part.alpha)->c[2] = NULL;
        }
        const int64_t of[] = {VTI_QUANTITY_X, VTI_QUANTITY_ALPHA, VTI_QUANTITY_QUAT};
        assert_int_equal(vti_bonds_rest_now(1, pair, 0, &part, rest, q0, &fault), VTI_E_VIEW);
        assert_true(fault.body == -1 && fault.quantity == of[view]);
    }
    assert_true(rest[0] == 7 && q0[3] == 7 && count > k);
    b.alpha = vti_view_none(); /* what has no attitude has not turned */
    pair[1] = 2;
    assert_int_equal(vti_bonds_rest_now(1, pair, 0, &b, rest, q0, NULL), VTI_OK);
    assert_true(q0[0] == 0 && q0[1] == 0 && q0[2] == 0 && q0[3] == 1);
    b.x = vti_view_none();
    assert_int_equal(vti_bonds_rest_now(1, pair, 0, &b, rest, q0, &fault), VTI_E_NEEDS);
    assert_int_equal(fault.quantity, VTI_QUANTITY_X);
    b.first = -1;
    assert_int_equal(vti_bonds_rest_now(1, pair, 0, &b, rest, q0, NULL), VTI_E_COUNT);
}

/** What breaks takes its rotation along: the list is as it would be had the bond never been there. */
TEST(rupture_moves_turns)
{
    rng g = rng_seed(6608);
    static int64_t id[WEB_MAX];
    static vti_sum lost;
    const int64_t count = make_now(&g, 40, 20, 6, CROWD_QUAT);
    strain(&g);
    static web part;
    static double turns[WEB_MAX][4];
    int64_t out[WEB_MAX], gone = 0, left = 0;
    part = w;
    for (int64_t k = 0; k < count; ++k) {
        id[k] = k;
        if (k % 3 == 1)
            out[gone++] = k;
        else {
            memcpy(part.pair[left], w.pair[k], sizeof w.pair[k]);
            memcpy(part.rest[left], w.rest[k], sizeof w.rest[k]);
            memcpy(turns[left], turn[k], sizeof turn[k]);
            part.moment[left] = w.moment[k];
            part.axial[left] = w.axial[k];
            part.shear[left++] = w.shear[k];
        }
    }
    const vti_rupture rupture = {.bonds = &w.bonds, .id = id, .lost = &lost};
    assert_int_equal(vti_rupture_take_out(&rupture, gone, out), VTI_OK);
    assert_same_bits(turn[0], turns[0], 4 * left);
    loads(&c);
    other = c;
    web_terms(&part, left, MOMENT | AXIAL | SHEAR, VTI_SHEAR_OBJECTIVE);
    part.bonds.turn = turns[0];
    const vti_effect effect = vti_bonds_effect(&part.bonds);
    const vti_bodies b = crowd_bodies(&other);
    assert_int_equal(vti_apply(&effect, 1, &b), VTI_OK);
    assert_same_bits(other.force[0], c.force[0], 3 * c.n);
    assert_same_bits(other.moment[0], c.moment[0], 3 * c.n);
}

RUN_TESTS(cmocka_unit_test(at_rest_where_it_was_made), cmocka_unit_test(energies_by_matrices),
          cmocka_unit_test(a_turn_is_another_attitude), cmocka_unit_test(loads_are_minus_the_gradient),
          cmocka_unit_test(rigid_motion), cmocka_unit_test(same_bits), cmocka_unit_test(refused),
          cmocka_unit_test(rupture_moves_turns))
