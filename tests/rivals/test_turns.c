/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What a rival does in one step, known in closed form: the angle by which a free body turns, and which of our
 * steppers, or of the other rivals, it is on quaternions. */
#include "journey.h"

/* ---- free spin --------------------------------------------------------------------------------------------------- */

/** The angle of one step with s = h|Omega|. */
static double asin_law(double s)
{
    return asin(s);
}

static double cayley_law(double s)
{
    return 2.0 * atan(0.5 * s);
}

static double exact_law(double s)
{
    return s;
}

static double midpoint_law(double s)
{
    return 4.0 * atan(0.25 * s);
}

/** 2 b - a of unit quaternions turned by half angles atan(s/2) and 2 atan(s/4). */
static double richardson_law(double s)
{
    const double a = atan(0.5 * s), b = 2.0 * atan(0.25 * s);
    return 2.0 * atan2(2.0 * sin(b) - sin(a), 2.0 * cos(b) - cos(a));
}

/** The exponential series of i s/2 up to its fourth term, normalised. */
static double rk4_law(double s)
{
    const double x = 0.5 * s;
    return 2.0 * atan2(x - x * x * x / 6.0, 1.0 - x * x / 2.0 + x * x * x * x / 24.0);
}

/** A free body's attitude after steps steps, against as many turns by that angle about its Omega. */
static void assert_angle(const char *name, double h, double angle, double tolerance)
{
    enum { STEPS = 50 };
    const double axis[3] = {0.6, 0.0, 0.8};
    struct scene scene;
    struct journey j;
    read_scene("spin", &scene);
    begin(&j, &scene, method_of(name), h);
    go(&j, STEPS);
    const vti_bodies b = travel_bodies(&j.travel);
    const double off = quat_distance(quat_unit(attitude_of(&b, 0)), quat_turn(axis, (long double)STEPS * angle));
    if (!(off <= STEPS * tolerance))
        fail_msg("%s at h = %g: off by %.3g after %d steps", name, h, off, (int)STEPS);
    end(&j);
}

TEST(free_spin)
{
    static const struct {
        const char *name;
        double (*angle)(double s);
    } laws[] = {
        {"mercury", cayley_law},
        {"quat-euler", cayley_law},
        {"campello", cayley_law},
        {"yade-exp-verlet", exact_law},
        {"yade-leapfrog", exact_law},
        {"spiral", exact_law},
        {"omelyan", midpoint_law},
        {"lgvi", asin_law},
        {"lammps-richardson", richardson_law},
        {"rk4", rk4_law},
        {"pefrl", exact_law},
        {"takahashi-imada", exact_law},
    };
    static const double h[] = {1e-6, 1.0 / 64, 0.3, 0.9}; /* |Omega| = 1 */
    for (size_t i = 0; i < sizeof laws / sizeof laws[0]; ++i)
        for (size_t k = 0; k < sizeof h / sizeof h[0]; ++k)
            assert_angle(laws[i].name, h[k], laws[i].angle(h[k]), 4.0 * EPS);
    /* their own error: the first term that a series of order 8 lacks, and the tolerance 1e-7 h^8 of every step */
    assert_angle("rk8pd", 0.3, 0.3, pow(0.15, 9) / 362880.0 + 4.0 * EPS);
    assert_angle("rk8pd-adaptive", 0.3, 0.3, 1e-7 * pow(0.3, 8));
    assert_angle("dop853-adaptive", 0.3, 0.3, 1e-7 * pow(0.3, 8));
    /* what is extrapolated is exact, and its rounding is multiplied by the weights: their sizes add up to 24 */
    assert_angle("verlet-x8", 0.3, 0.3, 24.0 * EPS);
    assert_angle("verlet-x12", 0.3, 0.3, 24.0 * EPS);
}

/** The law of lgvi ends at h|Omega| = 1, that of the others does not. */
TEST(large_turns)
{
    assert_angle("mercury", 5.0, cayley_law(5.0), 4.0 * EPS);
    assert_angle("omelyan", 5.0, midpoint_law(5.0), 4.0 * EPS);
    assert_angle("yade-leapfrog", 5.0, 5.0, 4.0 * EPS);
    assert_angle("lgvi", 0.9999, asin(0.9999), 1e-12); /* asin is steep there */
}

/** From within 1e-9 of a half turn, where w of the quaternion all but vanishes, and across it. */
TEST(half_turns)
{
    const double axis[3] = {0.6, 0.0, 0.8}, h = 1e-10;
    for (int64_t i = 0; i < method_count(); ++i) {
        struct scene scene;
        struct journey j;
        read_scene("spin", &scene);
        for (int k = 0; k < 3; ++k)
            scene.alpha[k] = 4e9 * axis[k];
        const rotor start = quat_of_alpha(scene.alpha);
        begin(&j, &scene, method_at(i), h);
        go(&j, 20);
        const vti_bodies b = travel_bodies(&j.travel);
        const rotor expected = quat_times(quat_turn(axis, 20.0L * h), start);
        assert_below(quat_distance(quat_unit(attitude_of(&b, 0)), expected), 20.0 * 4.0 * EPS);
        end(&j);
    }
}

/* ---- pairs that are the same ------------------------------------------------------------------------------------- */

/** Every body has another mass and inertia than its neighbour. */
static void make_unequal(struct model *model, double *mass, double *inertia)
{
    for (int64_t i = 0; i < model->bodies.count; ++i) {
        mass[i] = 1.0 + 0.25 * (double)(i % 3);
        inertia[i] = 0.1 + 0.05 * (double)(i % 2);
    }
    model->bodies.mass = vti_scalars_array(mass);
    model->bodies.inertia = vti_scalars_array(inertia);
    assert_int_equal(vti_bodies_seal(&model->bodies), VTI_OK);
}

/** Two methods after 1000 steps: the attitudes and the velocities differ by no more than tolerance. */
static void assert_same(const char *name, const char *other, const char *where, double h, int unequal, double tolerance)
{
    enum { STEPS = 1000, BODIES = 16 };
    const char *const names[2] = {name, other};
    double mass[2][BODIES], inertia[2][BODIES];
    struct journey j[2];
    vti_bodies b[2];
    for (int k = 0; k < 2; ++k) {
        read_scene(where, &j[k].scene);
        make_model(&j[k].scene, &j[k].model);
        assert_true(j[k].model.bodies.count <= BODIES);
        if (unequal)
            make_unequal(&j[k].model, mass[k], inertia[k]);
        set_out(&j[k], method_of(names[k]), h);
        go(&j[k], STEPS);
        b[k] = travel_bodies(&j[k].travel);
    }
    const double attitude = attitude_distance(&b[0], &b[1]), velocity = velocity_distance(&b[0], &b[1]);
    const double position = view_distance(&b[0].x, &b[1].x, b[0].count);
    print_message("%s and %s on %s: attitudes differ by %.2e, velocities by %.2e, positions by %.2e\n", name, other,
                  where, attitude, velocity, position);
    assert_below(attitude, tolerance);
    assert_below(velocity, tolerance);
    assert_below(position, tolerance);
    end(&j[0]);
    end(&j[1]);
}

/** Rounding of 1000 steps, grown by the motion itself. */
TEST(equivalents)
{
    static const char *const pairs[][2] = {{"mercury", "vti2"},
                                           {"quat-euler", "vti3"},
                                           {"lgvi", "vti1"},
                                           {"yade-leapfrog", "yade-exp-verlet"},
                                           {"spiral", "yade-leapfrog"}};
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; ++i) {
        assert_same(pairs[i][0], pairs[i][1], "pendulum", 1.0 / 64, 0, 5e-13);
        assert_same(pairs[i][0], pairs[i][1], "chain", 1.0 / 512, 0, 5e-12);
        assert_same(pairs[i][0], pairs[i][1], "chain", 1.0 / 512, 1, 5e-12);
    }
}

/** Unequal masses with the methods that divide by them in another way: they meet at a small h. */
TEST(unequal_masses)
{
    enum { STEPS = 256, BODIES = 16 };
    static const char *const names[] = {"rk4", "rk8pd", "rk8pd-adaptive"};
    double mass[2][BODIES], inertia[2][BODIES];
    for (size_t i = 0; i < sizeof names / sizeof names[0]; ++i) {
        struct journey j[2];
        vti_bodies b[2];
        for (int k = 0; k < 2; ++k) {
            read_scene("chain", &j[k].scene);
            make_model(&j[k].scene, &j[k].model);
            make_unequal(&j[k].model, mass[k], inertia[k]);
            set_out(&j[k], method_of(k == 0 ? "kl8" : names[i]), 1.0 / 512);
            go(&j[k], STEPS);
            b[k] = travel_bodies(&j[k].travel);
        }
        assert_below(attitude_distance(&b[0], &b[1]), 1e-7);
        assert_below(velocity_distance(&b[0], &b[1]), 1e-5);
        end(&j[0]);
        end(&j[1]);
    }
}

RUN_TESTS_OF_SCENES(cmocka_unit_test(free_spin), cmocka_unit_test(large_turns), cmocka_unit_test(equivalents),
                    cmocka_unit_test(unequal_masses), cmocka_unit_test(half_turns))
