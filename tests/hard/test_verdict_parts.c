/* SPDX-License-Identifier: BSD-3-Clause
 * What the verdict is made of: angles of the laws against libm's in long double, the modified energy's order, slopes of
 * series with known ones, bonds that turn past half a turn, ways towards what bodies touch, what slows bodies. */
#define _POSIX_C_SOURCE 200809L
#include "hard.h"

#include "../driver/model_support.h"
#include "verdict_parts.h"

/* ---- angles ------------------------------------------------------------------------------------------------------ */

/** law_angle folds nothing either, but for the whole turn that atan2l takes off beyond 2 pi. */
TEST(angles)
{
    for (int64_t law = VTI_LAW_CLOSED; law <= VTI_LAW_EXACT9; ++law)
        for (double s = 1e-9; s < (law == VTI_LAW_CLOSED ? 1.0 : 1e6); s *= 1.07) {
            const double ours = turning_angle(law, s), theirs = (double)law_angle(law, s);
            const double off = remainder(ours - theirs, 4.0 * PI);
            assert_close(off, 0.0, 8.0 * EPS * ours);
            assert_true(ours >= 0.0 && (law == VTI_LAW_CLOSED || ours <= 1.01 * s || s > 3.0));
        }
}

/** The shares by which steps of the exact laws miss h|Omega|: of s^7 and s^9, and none but that of the law is left at
 *  10. */
TEST(errors)
{
    const vti_stepper *exact = vti_stepper_find("exact"), *kl8 = vti_stepper_find("kl8"),
                      *vti2 = vti_stepper_find("vti2");
    assert_close(log2(turning_error(exact, 0.5) / turning_error(exact, 0.25)), 6.0, 0.1);
    assert_close(log2(turning_error(kl8, 2.0) / turning_error(kl8, 1.0)), 8.0, 0.3);
    assert_close(turning_error(exact, 10.0), fabs(0.7094 + 2.0 * PI - 10.0) / 10.0, 1e-4);
    assert_close(turning_error(vti2, 1.0), 1.0 - 2.0 * atan(0.5), 4 * EPS);
    assert_true(turning_error(exact, 10.0) > turning_tolerance(exact));
    assert_true(turning_error(vti_stepper_find("srkn11"), 10.0) > turning_tolerance(exact));
    assert_true(turning_error(exact, 1.0) < turning_tolerance(exact) &&
                turning_error(vti2, 1.0) < turning_tolerance(vti2));
}

/* ---- the modified energy ----------------------------------------------------------------------------------------- */

static const char chain[] =
    "bodies:\n  chain: {count: 6, spacing: 1}\n  mass: 1\n  random: {seed: 5, v: 0.3, omega: 0.9}\n"
    "binder: {moment: 3, axial: 40, shear: {stiffness: 30}}\nh: 1\nt_end: 1\n";
static const char pendulum[] = "bodies: {inertia: 2, alpha: [1, 2, -0.5], omega: [0.4, 1.5, -0.7]}\n"
                               "pendulum: {weight: 3, rho0: [0.3, 0.1, 1]}\nh: 1\nt_end: 1\n";
static const char sphere[] = "bodies: {x: [0, 0, 3], v: [0.2, 0, 0], mass: 2, diameter: 1}\ngravity: [0, 0, -1]\n"
                             "h: 1\nt_end: 1\n";

struct swing {
    struct verdict verdict;
    struct columns columns;
    double least[2], most[2]; /* of the total and of the modified energy */
};

static int see(void *self, int64_t step, double t, const vti_bodies *bodies)
{
    struct swing *s = self;
    double row[COLUMNS];
    verdict_row(&s->verdict, t, bodies, row);
    for (int k = 0; k < 2; ++k) {
        const double e = row[k == 0 ? s->columns.total : s->columns.modified];
        s->least[k] = step == 0 ? e : fmin(s->least[k], e);
        s->most[k] = step == 0 ? e : fmax(s->most[k], e);
    }
    return 0;
}

static void swings(const char *text, const char *stepper, double h, double swing[2])
{
    static struct scene scene;
    static struct model model;
    static struct swing s;
    struct message message;
    const vti_stepper *method = vti_stepper_find(stepper);
    make_model(text, &scene, &model);
    columns_of(&model, method, &s.columns);
    assert_true(s.columns.modified == s.columns.total + 1);
    assert_int_equal(verdict_create(&s.verdict, &model, method, h, &s.columns, &message), 0);
    const struct observer observer = {see, &s, 1, 0, NULL, NULL};
    assert_int_equal(loop_run(&model, method, h, 0, loop_steps(4.0, h), &observer, 1, &message), 0);
    for (int k = 0; k < 2; ++k)
        swing[k] = s.most[k] - s.least[k];
    verdict_destroy(&s.verdict);
    model_destroy(&model);
}

TEST(orders)
{
    static const char *const names[] = {"vti1", "vti2", "vti3", "vti3-leapfrog", "exact"};
    static const char *const texts[] = {chain, pendulum};
    for (size_t n = 0; n < 5; ++n)
        for (int k = 0; k < 2; ++k) {
            double coarse[2], fine[2];
            swings(texts[k], names[n], 1.0 / 64, coarse);
            swings(texts[k], names[n], 1.0 / 128, fine);
            const double total = log2(coarse[0] / fine[0]), modified = log2(coarse[1] / fine[1]);
            print_message("%s: orders %.3f, modified %.3f\n", names[n], total, modified);
            assert_close(total, strcmp(names[n], "vti3") == 0 ? 1.0 : 2.0, 0.1);
            assert_close(modified, 4.0, 0.2);
        }
}

/** In a uniform field H is conserved by Verlet but for rounding, and the modified energy is another constant. Other
 *  lists have no such column. */
TEST(elsewhere)
{
    static struct scene scene;
    static struct model model;
    struct columns columns;
    double swing[2];
    swings(sphere, "vti2", 1.0 / 32, swing);
    assert_below(swing[0], 1e-13);
    assert_below(swing[1], 1e-13);
    make_model(sphere, &scene, &model);
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        const vti_stepper *s = vti_stepper_at(k);
        columns_of(&model, s, &columns);
        assert_int_equal(columns.modified >= 0, s->evals == 1);
    }
    model_destroy(&model);
}

/* ---- slopes ------------------------------------------------------------------------------------------------------ */

TEST(slopes)
{
    rng g = rng_seed(3);
    double slope, error;
    int within = 0;
    for (int trial = 0; trial < 100; ++trial) {
        struct trend line = {0}, noise = {0};
        const int n = 10 + rng_below(&g, 5000);
        for (int k = 0; k < n; ++k) {
            trend_add(&line, 0.25 * k, 3.0 - 0.5 * k);
            trend_add(&noise, 0.25 * k, 0.125 * k + uniform(&g, -1.0, 1.0));
        }
        trend_slope(&line, &slope, &error);
        assert_close(slope, -2.0, 1e-11);
        assert_below(error, 1e-11);
        trend_slope(&noise, &slope, &error);
        /* of independent values with the variance 1/3 a line over n of them knows its slope to sqrt(4/n^3) per value */
        if (n > 100)
            assert_close(error / (4.0 * sqrt(4.0 / n) / n), 1.0, 0.6);
        within += fabs(slope - 0.5) < 2.0 * error;
    }
    /* 95 % of normal ones; 80 of 100 would be wrong by 7 standard deviations */
    assert_in_range(within, 80, 100);
    struct trend few = {0};
    for (int k = 0; k < 3; ++k)
        trend_add(&few, k, k);
    trend_slope(&few, &slope, &error);
    assert_true(isnan(slope) && isnan(error));
    struct trend four = {0}; /* (0, 0), (1, 1), (2, 1), (3, 2): off by 0.1 twice, and by 0.3 */
    for (int k = 0; k < 4; ++k)
        trend_add(&four, k, (k + 1) / 2);
    trend_slope(&four, &slope, &error);
    assert_close(slope, 0.6, 4 * EPS);
    assert_close(error, sqrt(0.2 / 2 / 5), 4 * EPS);
}

/* ---- bonds ------------------------------------------------------------------------------------------------------- */

static int follow(void *self, int64_t step, double t, const vti_bodies *bodies)
{
    struct verdict *v = self;
    double row[COLUMNS];
    verdict_step(v, t, bodies);
    if (step % 50 == 0)
        verdict_row(v, t, bodies, row);
    return 0;
}

/** Two bodies held by a moment alone, turning against each other: theta_max = Omega sqrt(J/(2 K)), J/2 being the
 *  reduced inertia and Omega the relative speed. */
static int64_t turned(double share, double h)
{
    static struct scene scene;
    static struct model model;
    static struct verdict v;
    struct columns columns;
    struct message message;
    char text[TEXT_SIZE];
    const double j = 0.1, k = 2.0, omega = share * PI / sqrt(j / (2.0 * k));
    FILE *file = fopen("two.csv", "wb");
    assert_non_null(file);
    fprintf(file, "x,y,z,omega_x,omega_y,omega_z\n0,0,0,0,%.9g,0\n1,0,0,0,0,0\n", omega);
    fclose(file);
    write_text("bond.csv", "i,j\n0,1\n");
    snprintf(text, sizeof text,
             "bodies: {table: two.csv, mass: 1, inertia: %g, diameter: 1}\n"
             "binder: {table: bond.csv, moment: %g}\nh: %g\nt_end: 3\n",
             j, k, h);
    make_model(text, &scene, &model);
    columns_of(&model, scene.stepper, &columns);
    assert_int_equal(verdict_create(&v, &model, scene.stepper, scene.h, &columns, &message), 0);
    const struct observer observer = {follow, &v, 1, 0, NULL, NULL};
    assert_int_equal(loop_run(&model, scene.stepper, scene.h, 0, (int64_t)(3.0 / h), &observer, 1, &message), 0);
    const struct judgement judgement = verdict_judge(&v, 0, &message);
    assert_int_equal(judgement.verdict, judgement.bonds_turned > 0 ? VERDICT_DOUBTFUL : VERDICT_GOOD);
    verdict_destroy(&v);
    model_destroy(&model);
    return judgement.bonds_turned;
}

TEST(bonds)
{
    assert_int_equal(turned(0.3, 1e-3), 0);
    assert_int_equal(turned(0.95, 1e-3), 0);
    assert_int_equal(turned(1.05, 1e-3), 1);
    assert_int_equal(turned(3.0, 1e-3), 1);
    assert_int_equal(turned(0.95, 0.02), 0);
    assert_int_equal(turned(1.05, 0.02), 1);
}

/* ---- ways -------------------------------------------------------------------------------------------------------- */

static struct model model_at_start;
static struct verdict verdict_at_start;

/** The verdict at t = 0 of the bodies, and of the effects that they meet by; verdict_over is due. */
static struct verdict *verdict_of(const char *bodies, const char *effects, const char *h)
{
    static struct scene scene;
    struct columns columns;
    struct message message;
    char text[TEXT_SIZE];
    snprintf(text, sizeof text, "bodies: {%s}\n%s\nh: %s\nt_end: 1\n", bodies, effects, h);
    make_model(text, &scene, &model_at_start);
    columns_of(&model_at_start, scene.stepper, &columns);
    assert_int_equal(verdict_create(&verdict_at_start, &model_at_start, scene.stepper, scene.h, &columns, &message), 0);
    return &verdict_at_start;
}

static void verdict_over(void)
{
    verdict_destroy(&verdict_at_start);
    model_destroy(&model_at_start);
}

static double travel_of(const char *bodies, const char *effects)
{
    const double travel = places_travel(verdict_of(bodies, effects, "0.01"), &model_at_start.bodies);
    verdict_over();
    return travel;
}

/** h|v.N|/D by hand: along a wall nothing comes nearer, and what walls or all bodies do together does not count. */
TEST(ways)
{
#define SPHERE "mass: 2, diameter: 0.5, "
    static const char slope[] = "wall: {stiffness: 10, planes: [[0.6, 0, 0.8, -9]]}",
                      piston[] = "wall: {stiffness: 10, planes: [[0, 0, 1, -9]], velocities: [[7, 0, 2]], spins: [5]}",
                      drum[] = "wall: {stiffness: 10, cylinders: [[0, 0, 1, 0, 0, 0, 4]]}",
                      corner[] = "wall: {stiffness: 10, planes: [[1, 0, 0, -9], [0, 1, 0, -9]]}";
    const double unit = 0.01 / 0.5;
    assert_close(travel_of(SPHERE "x: [0, 0, 0], v: [8e3, 5e3, -6e3]", slope), 0.0, 1e-9);
    assert_close(travel_of(SPHERE "x: [0, 0, 0], v: [3, 7, -1]", slope), unit, 1e-15);
    assert_close(travel_of(SPHERE "x: [0, 0, 0], v: [5, 0, -1]", piston), 3.0 * unit, 1e-15);
    assert_close(travel_of(SPHERE "x: [2, 0, 0], v: [1, 50, 90]", drum), unit, 1e-15);
    assert_close(travel_of(SPHERE "x: [0, 0, 0], v: [3, 4, 70]", drum), 5.0 * unit, 1e-15);
    assert_close(travel_of(SPHERE "x: [0, 0, 0], v: [-3, 4, 50]", corner), 4.0 * unit, 1e-15);
    /* a clump of two spheres of diameter 1, each 0.3 from the centre, about which they turn by 2 */
    assert_close(
        travel_of("clumps: {spheres: [[0, 0, 0, 1], [0.6, 0, 0, 1]], density: 1}, x: [0, 0, 0], v: [9, 0, -1], "
                  "alpha: [0, 0, 0], omega: [0, 0, 2]",
                  piston),
        0.01 * (3.0 + 0.6), 1e-15);
    /* their centre of mass moves with (1, 0, -100) */
    write_text("two.csv", "x,y,z,vx,vy,vz,mass\n0,0,0,4,0,-100,1\n9,0,0,0,0,-100,3\n");
    assert_close(travel_of("table: two.csv, diameter: 0.5", "contact: {stiffness: 10}"), 3.0 * unit, 1e-12);
    assert_close(travel_of("table: two.csv, diameter: 0.5", "wall: {stiffness: 10, planes: [[0, 1, 0, -9]]}"), 0.0,
                 0.0);
    assert_close(travel_of("table: two.csv, diameter: 0.5", drum), 4.0 * unit, 1e-12);
    assert_close(travel_of("table: two.csv, diameter: 0.5", piston), 102.0 * unit, 1e-12);
#undef SPHERE
}

/* ---- what slows -------------------------------------------------------------------------------------------------- */

/** The largest c/m of the dashpots. */
static double slowing_of(const char *bodies, const char *effects)
{
    const double rate = verdict_of(bodies, effects, "0.5")->found.slowing / 0.5;
    verdict_over();
    return rate;
}

/** That of what moves, be it pushed or not. */
static double slowing_free_of(const char *bodies, const char *effects)
{
    const double rate = verdict_of(bodies, effects, "0.5")->found.slowing_free / 0.5;
    verdict_over();
    return rate;
}

/** c/m by hand; the impulse that meets a clump's sphere turns the clump too. */
TEST(slowed)
{
#define WALL "wall: {stiffness: 10, planes: [[0, 0, 1, -9]]}\n"
    static const char one[] =
        "mass: 2, diameter: 0.5, inertia: 0.01, x: [0, 0, 0], v: [0, 0, 0], alpha: [0, 0, 0], omega: [0, 0, 0]",
                      long_one[] = "mass: 2, diameter: 0.5, moments: [0.01, 0.02, 0.02], x: [0, 0, 0], v: [0, 0, 0], "
                                   "alpha: [0, 0, 0], omega: [0, 0, 0]",
                      still[] = "mass: 2, diameter: 0.5, x: [0, 0, 0], v: [0, 0, 0]",
                      three[] = "table: three.csv, diameter: 1",
                      rod[] =
                          "clumps: {spheres: [[0, 0, 0, 1], [3, 0, 0, 1]], density: 1}, x: [0, 0, 0], v: [0, 0, 0], "
                          "alpha: [0, 0, 0], omega: [0, 0, 0]";
    write_text("three.csv", "x,y,z,vx,vy,vz,mass\n0,0,0,0,0,0,5\n3,0,0,0,0,0,2\n6,0,0,0,0,0,4\n");
    write_text("bond.csv", "i,j\n0,1\n");
    assert_close(slowing_of(still, WALL "dashpot: {normal: 3}"), 3.0 / 2.0, 1e-15);
    assert_close(slowing_of(one, WALL "dashpot: {tangential: 3}"), 3.0 * (1.0 / 2.0 + 0.0625 / 0.01), 1e-13);
    assert_close(slowing_of(one, WALL "dashpot: {normal: 3, ratio: 2}"), 6.0 * (1.0 / 2.0 + 0.0625 / 0.01), 1e-13);
    assert_close(slowing_of(long_one, WALL "dashpot: {rolling: 3}"), 3.0 / 0.01, 1e-12);
    assert_close(slowing_of(one, WALL "dashpot: {twisting: 3}"), 3.0 / 0.01, 1e-12);
    assert_close(slowing_of(still, WALL "dashpot: {restitution: 0.5}"), 0.0, 0.0);
    assert_close(slowing_of(three, "contact: {stiffness: 10}\ndashpot: {normal: 3}"), 3.0 * (1.0 / 2.0 + 1.0 / 4.0),
                 1e-15);
    assert_close(slowing_of(three, WALL "dashpot: {normal: 3}"), 3.0 / 2.0, 1e-15);
    /* two spheres at 1.5 on both sides of the centre: m = pi/3, J = 2 (m/2) (R^2 2/5 + 1.5^2) across; a double root
     * knows half of the digits */
    const double mass = PI / 3.0, across = mass * (0.1 + 2.25);
    assert_close(slowing_of(rod, WALL "dashpot: {normal: 3}"), 3.0 * (1.0 / mass + 2.25 / across), 6.0 * sqrt(EPS));
    /* spheres of one body do not touch */
    assert_close(slowing_of(rod, "contact: {stiffness: 10}\ndashpot: {normal: 3}"), 3.0 * (1.0 / mass + 2.25 / across),
                 6.0 * sqrt(EPS));
    static const char slanted[] = "clumps: {spheres: [[0, 0, 0, 1], [0, 2.4, 1.8, 1]], density: 1}, x: [0, 0, 0], "
                                  "v: [0, 0, 0], alpha: [0, 0, 0], omega: [0, 0, 0]";
    assert_close(slowing_of(slanted, WALL "dashpot: {normal: 3}"), 3.0 * (1.0 / mass + 2.25 / across), 6.0 * sqrt(EPS));
    static const char pair[] = "table: three.csv, inertia: 0.1, diameter: 1";
#define BOND "binder: {table: bond.csv, axial: 8, shear: {stiffness: 18}, moment: 5}\nbond_dashpot: "
    const double m = 1.0 / 5.0 + 1.0 / 2.0, t = m + 2.0 * 2.25 / 0.1, r = 2.0 / 0.1; /* L0 = 3 */
    assert_close(slowing_of(pair, BOND "{axial: 3}"), 3.0 * m, 1e-15);
    assert_close(slowing_of(pair, BOND "{shear: 3}"), 3.0 * t, 1e-12);
    assert_close(slowing_of(pair, BOND "{bending: 3}"), 3.0 * r, 1e-12);
    assert_close(slowing_of(pair, BOND "{twisting: 3}"), 3.0 * r, 1e-12);
    assert_close(slowing_of(pair, BOND "{zeta: 0.9}"), 0.0, 0.0);
    assert_close(slowing_of(pair, BOND "{zeta: 2}"), 4.0 * fmax(sqrt(18.0 / 9.0 * t), sqrt(5.0 * r)), 1e-12);
#undef BOND
    /* drag of (c + 2 k|u|)/m, u against the medium, and of turns where something turns bodies */
    static const char fast[] = "mass: 2, diameter: 0.5, x: [0, 0, 0], v: [3, 0, 4]";
    assert_close(slowing_of(fast, WALL "drag: {quadratic: 3}"), 2.0 * 3.0 * 5.0 / 2.0, 1e-14);
    assert_close(slowing_of(fast, WALL "drag: {linear: 7, quadratic: 3, medium: [3, 0, 0]}"),
                 (7.0 + 2.0 * 3.0 * 4.0) / 2.0, 1e-14);
    assert_close(slowing_of(one, WALL "drag: {angular: 3}"), 0.0, 0.0);
    assert_close(slowing_free_of("mass: 2, diameter: 0.5, inertia: 0.01, x: [0, 0, 0], v: [3, 0, 4], alpha: [0, 0, 0], "
                                 "omega: [0, 2, 0]",
                                 "drag: {linear: 7, quadratic: 3, angular: 0.05, medium: [3, 0, 0]}"),
                 (7.0 + 2.0 * 3.0 * 4.0) / 2.0, 1e-14);
    assert_close(slowing_free_of("mass: 2, diameter: 0.5, inertia: 0.01, x: [0, 0, 0], v: [0, 0, 0], alpha: [0, 0, 0], "
                                 "omega: [0, 2, 0]",
                                 WALL "drag: {linear: 7, angular: 3}"),
                 3.0 / 0.01, 1e-12);
    assert_close(slowing_free_of("mass: 2, diameter: 0.5, inertia: 0.01, x: [0, 0, 0], v: [1, 0, 0], alpha: [0, 0, 0], "
                                 "omega: [0, 0, 0]",
                                 WALL "drag: {linear: 7, angular: 3}"),
                 7.0 / 2.0, 1e-15);
    assert_close(slowing_free_of(one, WALL "drag: {linear: 7, angular: 3}"), 0.0, 0.0);
    static const char turning[] = "clumps: {spheres: [[0, 0, 0, 1], [3, 0, 0, 1]], density: 1}, x: [0, 0, 0], "
                                  "v: [0, 0, 0], alpha: [0, 0, 0], omega: [0, 0, 1]",
                      going[] = "clumps: {spheres: [[0, 0, 0, 1], [3, 0, 0, 1]], density: 1}, x: [0, 0, 0], "
                                "v: [0, 0, 5], alpha: [0, 0, 0], omega: [0, 0, 0]";
    assert_close(slowing_free_of(turning, "drag: {linear: 3, on: spheres}"), 2.0 * 3.0 * 2.25 / across,
                 6.0 * sqrt(EPS));
    assert_close(slowing_free_of(going, "drag: {quadratic: 3, on: spheres}"), 2.0 * 2.0 * 3.0 * 5.0 / mass, 1e-12);
    assert_close(slowing_of("inertia: 0.01, alpha: [1, 0, 0], omega: [0, 0, 0]",
                            "pendulum: {weight: 1, rho0: [0, 0, -1]}\ndrag: {angular: 3}"),
                 3.0 / 0.01, 1e-12);
    assert_close(slowing_of("moments: [0.01, 0.02, 0.02], alpha: [1, 0, 0], omega: [0, 0, 0]",
                            "pendulum: {weight: 1, rho0: [0, 0, -1]}\ndrag: {angular: 3}"),
                 3.0 / 0.01, 1e-12);
#undef WALL
}

/* ---- what gains and losses are shares of ------------------------------------------------------------------------- */

/** The judgement of rows of a sphere of m = 2 that flies at v and has fallen by so much energy, lost being booked. */
static struct judgement judged(int rows, const double *v, const double *fallen, const double *lost)
{
    static struct scene scene;
    static struct model model;
    struct columns columns;
    struct message message;
    struct verdict verdict;
    double row[COLUMNS];
    int64_t drag = 0;
    make_model("bodies: {x: [0, 0, 1000], v: [0, 0, 0], mass: 2, diameter: 1}\ngravity: [0, 0, -1]\n"
               "drag: {linear: 1}\nh: 0.01\nt_end: 1\n",
               &scene, &model);
    columns_of(&model, scene.stepper, &columns);
    assert_int_equal(verdict_create(&verdict, &model, scene.stepper, 0.01, &columns, &message), 0);
    while (model.effects[drag].booked == NULL)
        ++drag;
    for (int k = 0; k < rows; ++k) {
        model.bodies.v.c[0][0] = v[k];
        model.bodies.x.c[2][0] = 1000 - fallen[k] / 2;
        ((vti_sum *)model.effects[drag].booked)->high = lost[k];
        verdict_row(&verdict, k, &model.bodies, row);
    }
    const struct judgement found = verdict_judge(&verdict, 0, &message);
    verdict_destroy(&verdict);
    model_destroy(&model);
    return found;
}

/** Energy that is off where something begins to move is a share of what there is in the end, and errors of the ledger
 *  of a driven scene one of what it has turned over; what comes out of nothing is bad, booked or not. */
TEST(shares)
{
    static const double none[4], from_rest[] = {0, 0, 10, 10}, late[] = {0, 1e-3, -100, -100}, steady[] = {1, 1, 1, 1},
                                 fallen[] = {0, 10, 20, 39.6}, turned[] = {0, 10, 20, 40}, wild[] = {1, 3, 9, 27};
    assert_close(judged(4, from_rest, none, late).energy_gain, 1e-5, 1e-9);
    assert_close(judged(2, from_rest, none, late).energy_gain, 1.0, 1e-5);
    const struct judgement driven = judged(4, steady, fallen, turned);
    assert_close(driven.energy_gain, 0.4 / 40, 1e-9);
    assert_int_equal(driven.verdict, VERDICT_GOOD);
    assert_int_equal(judged(4, steady, none, turned).verdict, VERDICT_BAD);
    assert_int_equal(judged(4, wild, none, none).verdict, VERDICT_BAD);
}

/* ---- the stable step --------------------------------------------------------------------------------------------- */

/** A sphere above a wall at rows, and in row 65, at which the stable step is taken for this alone, inside of it. */
static struct verdict touched(struct model *model, const struct columns *columns, double longest)
{
    struct verdict v;
    struct message message;
    double row[COLUMNS];
    assert_int_equal(verdict_create(&v, model, model->scene->stepper, model->scene->h, columns, &message), 0);
    for (int k = 0; k < 70; ++k) {
        model->bodies.x.c[2][0] = k == 65 ? 0.4 : 3.0;
        if (longest > 0.0)
            verdict_longest(&v, longest);
        verdict_row(&v, k, &model->bodies, row);
    }
    model->bodies.x.c[2][0] = 0.4;
    return v;
}

/** k = (3/2) K o^(1/2)/R^2, o = 0.2, R = 1/2, K = 10, m = 2: the stable step is 2 sqrt(m/k) and h above it. Of steps
 *  that vary it is what they were while the sphere touched. */
TEST(pressed)
{
    static struct scene scene;
    static struct model model;
    struct columns columns;
    struct message message;
    double row[COLUMNS];
    const double stable = 2.0 * sqrt(2.0 / (1.5 * 10.0 * sqrt(0.2) / 0.25));
    char text[TEXT_SIZE];
    snprintf(text, sizeof text,
             "bodies: {x: [0, 0, 3], v: [0, 0, 0], mass: 2, diameter: 1}\n"
             "wall: {stiffness: 10, planes: [[0, 0, 1, 0]]}\nh: %.17g\nt_end: 1\n",
             1.5 * stable);
    make_model(text, &scene, &model);
    columns_of(&model, scene.stepper, &columns);
    struct verdict v = touched(&model, &columns, 0.0);
    v.found.gain = 0.0; /* the test has put it there */
    struct judgement found = verdict_judge(&v, 0, &message);
    assert_close(found.stable_step, stable, 4 * EPS * stable);
    assert_int_equal(found.verdict, VERDICT_DOUBTFUL);
    assert_non_null(strstr(message.text, "h is 1.5 of the least stable step"));
    verdict_destroy(&v);
    v = touched(&model, &columns, 1.5 * stable);
    v.found.gain = 0.0;
    assert_int_equal(verdict_judge(&v, 0, &message).verdict, VERDICT_GOOD); /* a long step to it and from it */
    for (int k = 70; k < 90; ++k) { /* short steps in contact, and then a long one */
        verdict_longest(&v, k == 85 ? 1.5 * stable : 0.1 * stable);
        verdict_row(&v, k, &model.bodies, row);
        v.found.gain = 0.0;
        if (k == 80)
            assert_int_equal(verdict_judge(&v, 0, &message).verdict, VERDICT_GOOD);
    }
    assert_int_equal(verdict_judge(&v, 0, &message).verdict, VERDICT_DOUBTFUL);
    assert_non_null(strstr(message.text, "steps are up to 1.5 of the stable step, the least "));
    verdict_destroy(&v);
    model_destroy(&model);
}

/* ---- what to do -------------------------------------------------------------------------------------------------- */

/** Warnings at a step of 1; NULL: none, as where a tolerance chooses the steps. */
static void warned(const char *text, const char *remedy)
{
    static struct scene scene;
    static struct model model;
    static struct verdict v;
    struct columns columns;
    struct message message, lines[VERDICT_WARNINGS];
    make_model(text, &scene, &model);
    columns_of(&model, scene.stepper, &columns);
    assert_int_equal(verdict_create(&v, &model, scene.stepper, scene.h, &columns, &message), 0);
    const int n = verdict_warnings(&v, &model.bodies, lines);
    assert_true((n > 0) == (remedy != NULL));
    for (int k = 0; k < n; ++k)
        assert_non_null(strstr(lines[k].text, remedy));
    verdict_destroy(&v);
    model_destroy(&model);
}

TEST(remedies)
{
    static const char fast[] = "bodies: {x: [0, 0, 3], v: [0, 0, 40], mass: 2, diameter: 1}\n"
                               "wall: {stiffness: 10, planes: [[0, 0, 1, 0]]}\nstepper: %s\n%sh: 1\nt_end: 1\n";
    char text[TEXT_SIZE];
    snprintf(text, sizeof text, fast, "srkn11", "");
    warned(text, "; reduce h to 0.0025"); /* 0.1 diameters a step */
    snprintf(text, sizeof text, fast, "srkn11", "tolerance: 1e-6\n");
    warned(text, NULL);
    /* doubles at 1e9 are 1.2e-7 apart; a body that stands still has no way, wherever it is */
    warned("bodies: {x: [0, -1e9, 0], v: [1e-2, 0, 0], mass: 2}\nh: 1e-3\nt_end: 1\n",
           "rounding takes up to 0.011 of their displacement in a step; move the origin nearer");
    warned("bodies: {x: [0, -1e6, 0], v: [1e-2, 0, 0], mass: 2}\nh: 1e-3\nt_end: 1\n", NULL);
    warned("bodies: {x: [0, -1e9, 0], v: [0, 0, 0], mass: 2}\nh: 1e-3\nt_end: 1\n", NULL);
    /* what rounding may give to a bond at rest, 0.5e-18 K = 1e-16, is none either */
    static const char bonded[] =
        "bodies: {chain: {count: 2, spacing: 1, start: [0, -1e9, 0]}, mass: 2, v: [%s, 0, 0]}\n"
        "binder: {axial: 200}\nh: 1e-3\nt_end: 1\n";
    snprintf(text, sizeof text, bonded, "1.1e-8");
    warned(text, "rounding takes");
    snprintf(text, sizeof text, bonded, "0.9e-8");
    warned(text, NULL);
    snprintf(text, sizeof text, fast, "vti2", "dashpot: {restitution: 0.5}\n");
    warned(text, "; reduce h to 0.00025"); /* 0.01 */
    snprintf(text, sizeof text, "%sstepper: vti2\n", pendulum);
    warned(text, "; reduce h");
    snprintf(text, sizeof text, "%sstepper: vti2\ntolerance: 1e-6\n", pendulum);
    warned(text, NULL);
}

RUN_TESTS_IN_FOLDER(cmocka_unit_test(remedies), cmocka_unit_test(angles), cmocka_unit_test(errors),
                    cmocka_unit_test(orders), cmocka_unit_test(elsewhere), cmocka_unit_test(slopes),
                    cmocka_unit_test(bonds), cmocka_unit_test(ways), cmocka_unit_test(slowed), cmocka_unit_test(shares),
                    cmocka_unit_test(pressed))
