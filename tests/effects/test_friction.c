/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Friction against the closed forms of a sphere on a plane (EQUATIONS 6.5), the ledger and the order of oblique
 * impacts, stuck pairs that turn as one, and the table of what touches hold. */
#include "impact.h"

enum { SLOTS = 1024 };

static impact m;
static vti_held entries[SLOTS];
static int64_t slots[SLOTS];
static vti_history history;
static vti_friction friction;
static vti_dashpots dashpots;

static const vti_stepper *vti2(void)
{
    return vti_stepper_find("vti2");
}

/** Friction of the impact's contacts or planes, without a coefficient yet. */
static void rub(int plane)
{
    static vti_sum lost[3];
    memset(slots, 0, sizeof slots);
    memset(lost, 0, sizeof lost);
    history = (vti_history){SLOTS, 0, 0, entries, slots};
    friction = (vti_friction){.contacts = plane ? NULL : &m.contacts,
                              .walls = plane ? &m.walls : NULL,
                              .reach = INFINITY,
                              .history = &history,
                              .lost = lost};
    dashpots = (vti_dashpots){.contacts = friction.contacts,
                              .walls = friction.walls,
                              .friction = &friction,
                              .reach = INFINITY,
                              .lost = m.lost};
    impact_add(&m, plane ? vti_walls_effect(&m.walls) : vti_contacts_effect(&m.contacts));
}

/* ---- a sphere on a plane ----------------------------------------------------------------------------------------- */

static vti_gravity gravity;
static const double mass = 2, inertia = 0.21, radius = 0.5, stiffness = 1e4, weight = 2 * 10.0;
static double arm; /* height of the centre at rest: the arm of friction */

/** At rest under its weight on the plane z = 0; gravity tilted by tan = slope along +x, of which weight is the part
 *  along -z. Load and heights are those of rest, so that nothing bounces. */
static void lay(double slope, double mu, double mu_r, double mu_w)
{
    impact_clear(&m, 1, 1, stiffness);
    m.c.mass[0] = mass;
    m.c.inertia[0] = inertia;
    m.plane[0][2] = 1;
    gravity = (vti_gravity){{slope * weight / mass, 0, -weight / mass}};
    arm = radius * (1 - pow(weight * radius / stiffness, 2.0 / 3));
    m.c.x[0][2] = arm;
    rub(1);
    friction.sliding = mu;
    friction.stiffness = mu > 0 ? 2e3 : 0;
    friction.rolling = mu_r;
    friction.rolling_stiffness = 2e2;
    friction.twisting = mu_w;
    friction.twisting_stiffness = 2e2;
    impact_add(&m, vti_gravity_effect(&gravity));
    impact_add(&m, vti_friction_effect(&friction));
}

static const double h = 1.0 / 1024;

/** The mean of a velocity's change per time over so many steps, once the springs have stretched. */
static double rate_of(const double *velocity, int64_t steps)
{
    impact_go(&m, vti2(), h, 128);
    const double before = *velocity;
    impact_go(&m, vti2(), h, steps);
    return (*velocity - before) / ((double)steps * h);
}

/** Slides with mu F_n/m, then rolls at v0 m l^2/(J + m l^2). */
TEST(slide_to_roll)
{
    lay(0, 0.3, 0, 0);
    dashpots.tangential = 20; /* the spring would swing */
    impact_add(&m, vti_dashpots_effect(&dashpots));
    m.c.v[0][0] = 2;
    assert_close(rate_of(&m.c.v[0][0], 64), -0.3 * weight / mass, 1e-9);
    impact_go(&m, vti2(), h, 8192);
    const double rolls = 2 * mass * arm * arm / (inertia + mass * arm * arm);
    assert_close(m.c.v[0][0], rolls, 1e-9);
    assert_close(m.c.omega[0][1], rolls / arm, 1e-9);
}

/** Rolling resistance slows by mu_r F_n/(m l (1 + J/(m l^2))) and ends in rest. */
TEST(rolling_stops)
{
    const double mu_r = 0.02;
    lay(0, 0.5, mu_r, 0);
    dashpots.tangential = 20;
    dashpots.rolling = 5;
    impact_add(&m, vti_dashpots_effect(&dashpots));
    m.c.v[0][0] = 1;
    m.c.omega[0][1] = 1 / arm;
    const double before = impact_ledger(&m);
    impact_go(&m, vti2(), h, 1024);
    assert_close(rate_of(&m.c.v[0][0], 1024), -mu_r * weight / (mass * arm * (1 + inertia / (mass * arm * arm))), 1e-4);
    impact_go(&m, vti2(), h, 16 * 1024);
    assert_below(fabs(m.c.v[0][0]), 1e-9);
    assert_close(impact_ledger(&m), before, 1e-5 * fabs(before));
}

/** On an incline: g sin/(1 + J/(m l^2)) while it rolls freely, tan < mu (1 + m l^2/J); g (sin - mu cos) where rolling
 *  is held and tan > mu; rest where tan < mu. */
TEST(incline)
{
    const double g = weight / mass;
    lay(0.5, 0.3, 0, 0);
    dashpots.tangential = 20;
    impact_add(&m, vti_dashpots_effect(&dashpots));
    impact_go(&m, vti2(), h, 1024);
    assert_close(rate_of(&m.c.v[0][0], 1024), 0.5 * g / (1 + inertia / (mass * arm * arm)), 1e-4);
    lay(0.5, 0.3, 0.4, 0);
    assert_close(rate_of(&m.c.v[0][0], 512), (0.5 - 0.3) * g, 1e-9);
    assert_below(fabs(m.c.omega[0][1]), 1);
    lay(0.25, 0.3, 0.4, 0);
    dashpots.tangential = 20;
    dashpots.rolling = 5;
    impact_add(&m, vti_dashpots_effect(&dashpots));
    impact_go(&m, vti2(), h, 16 * 1024);
    assert_below(fabs(m.c.v[0][0]), 1e-9);
    assert_below(fabs(m.c.force[0][0]), 1e-6); /* the spring holds the weight */
}

/** A spin about the normal slows by mu_w F_n/J and stops. */
TEST(spin_stops)
{
    const double mu_w = 0.01;
    lay(0, 0.3, 0, mu_w);
    dashpots.twisting = 10;
    impact_add(&m, vti_dashpots_effect(&dashpots));
    m.c.omega[0][2] = 3;
    assert_close(rate_of(&m.c.omega[0][2], 1024), -mu_w * weight / inertia, 1e-9);
    impact_go(&m, vti2(), h, 8192);
    assert_below(fabs(m.c.omega[0][2]), 1e-9);
}

/* ---- impacts ----------------------------------------------------------------------------------------------------- */

/** Of errors at h, h/2, h/4 ...: the order by least squares. */
static double slope(const double *error, int levels)
{
    double sum = 0, squares = 0;
    for (int k = 0; k < levels; ++k) {
        const double from_middle = k - 0.5 * (levels - 1);
        sum -= from_middle * log2(error[k]);
        squares += from_middle * from_middle;
    }
    return sum / squares;
}

/** An oblique impact by h = 0.2/steps of two unequal spheres or one and a plane: velocities after it, and in *ledger by
 *  how much T + U + lost has changed. */
static void collide(double degrees, int plane, int mindlin, double start, int steps, double after[12], double *ledger)
{
    rng g = rng_seed(1410);
    double n[3], side[3];
    impact_clear(&m, 2, plane, 2e4);
    random_unit(&g, 3, n);
    const double a = degrees * PI / 180, flat[3] = {n[1], -n[0], 0};
    vti_cross(n, flat, side);
    m.c.mass[0] = 2;
    m.c.inertia[0] = 0.3;
    m.diameter[0] = 1.25;
    const double gap = plane ? 0.625 : 1.125;
    for (int k = 0; k < 3; ++k) {
        m.plane[0][k] = n[k];
        m.c.x[0][k] = (gap + start) * n[k];
        m.c.x[1][k] = plane ? 50 * n[k] : 0;
        m.c.v[0][k] = -cos(a) * n[k] + sin(a) * side[k];
        m.c.omega[0][k] = plane ? 0 : 0.4 * (k - 1);
    }
    rub(plane);
    friction.sliding = 0.3;
    friction.stiffness = mindlin ? 0 : 1500;
    friction.mindlin = mindlin ? 0.8 : 0;
    friction.rolling = 0.05;
    friction.rolling_stiffness = 40;
    friction.twisting = 0.02;
    friction.twisting_stiffness = 40;
    dashpots.zeta = 0.1;
    dashpots.ratio = 2;
    impact_add(&m, vti_friction_effect(&friction));
    impact_add(&m, vti_dashpots_effect(&dashpots));
    const double before = impact_ledger(&m);
    impact_go(&m, vti2(), 0.2 / steps, steps);
    *ledger = fabs(impact_ledger(&m) - before) / before;
    assert_int_equal(history.missed, 0);
    for (int k = 0; k < 3; ++k) {
        after[k] = m.c.v[0][k];
        after[3 + k] = m.c.omega[0][k];
        after[6 + k] = plane ? 0 : m.c.v[1][k];
        after[9 + k] = plane ? 0 : m.c.omega[1][k];
    }
}

/** Touch, slip that turns, stick and opening, beside normal and tangential dashpots: velocities and the ledger converge
 *  with second order in each case, over places of the start, as where in a step they fall changes the factor. */
TEST(oblique_impacts)
{
    enum { STARTS = 8, LEVELS = 4, STEPS = 512 };
    static const double angles[] = {20, 45, 60, 76};
    for (int which = 0; which < 16; ++which) {
        double error[LEVELS] = {0}, ledger[LEVELS] = {0};
        const int plane = which / 4 % 2, mindlin = which / 8;
        for (int start = 0; start < STARTS; ++start) {
            double fine[12], v[12], change;
            const double gap = 0.01 + 1.1e-4 * start, a = angles[which % 4];
            collide(a, plane, mindlin, gap, STEPS << 5, fine, &change);
            assert_true(friction.lost[0].high > 0 && history.used == 0);
            for (int level = 0; level < LEVELS; ++level) {
                collide(a, plane, mindlin, gap, STEPS << level, v, &change);
                ledger[level] += change;
                for (int k = 0; k < 12; ++k)
                    error[level] += pow(v[k] - fine[k], 2);
            }
        }
        const double order = slope(error, LEVELS) / 2, ledger_order = slope(ledger, LEVELS);
        print_message("%.0f degrees, %s, %s: velocities %.1e, order %.2f; ledger %.1e, order %.2f\n", angles[which % 4],
                      plane ? "plane" : "pair", mindlin ? "Mindlin" : "linear", sqrt(error[0] / STARTS), order,
                      ledger[0] / STARTS, ledger_order);
        assert_below(1.7, order);
        assert_below(1.7, ledger_order);
    }
}

/* ---- one drift --------------------------------------------------------------------------------------------------- */

/** A pair that turns as one by a radian and more, in one drift, keeps its loads in its own frame, and loses nothing. */
TEST(stuck_pairs_turn)
{
    rng g = rng_seed(1412);
    for (int trial = 0; trial < 2000; ++trial) {
        double axis[3], n[3], f[3], l[3], f1[3], l1[3];
        const double angle = uniform(&g, -2.5, 2.5);
        const rotor q = quat_turn((random_unit(&g, 3, axis), axis), angle);
        impact_clear(&m, 2, 0, 1e4);
        random_unit(&g, 3, n);
        random_vector(&g, 1, f);
        random_vector(&g, 1, l);
        m.diameter[0] = uniform(&g, 0.5, 2);
        const double fn = vti_dot(f, n), ln = vti_dot(l, n), r = 0.98 * (m.diameter[0] + 1) / 2;
        rub(0);
        friction.sliding = friction.rolling = friction.twisting = 1;
        friction.stiffness = trial % 2 ? 100 : 0;
        friction.mindlin = trial % 2 ? 0 : 0.8;
        friction.rolling_stiffness = friction.twisting_stiffness = 50;
        vti_held held = {.i = 1, .j = 2, .twisting = 0.5};
        double turned[3];
        quat_rotate(q, n, turned);
        for (int k = 0; k < 3; ++k) {
            held.sliding[k] = f[k] -= fn * n[k];
            held.rolling[k] = l[k] -= ln * n[k];
            m.c.x[0][k] = r * turned[k];
            m.c.v[0][k] = 8 * r * (turned[k] - n[k]);
            m.c.omega[0][k] = m.c.omega[1][k] = 8 * 2 * tan(angle / 2) * axis[k];
        }
        assert_int_equal(vti_history_add(&history, &held), VTI_OK);
        quat_rotate(q, f, f1);
        quat_rotate(q, l, l1);
        const vti_effect effect = vti_friction_effect(&friction);
        const vti_drifted drifted = {.t = 0.125, .law = VTI_LAW_CAYLEY, .frame = VTI_FRAME_SPACE};
        assert_int_equal(vti_effects_carry(&effect, 1, &drifted, &m.b), VTI_OK);
        const vti_held *const kept = entries;
        assert_int_equal(history.used, 1);
        const double tolerance = 1e-12 * (1 + 1 / (1 + vti_dot(n, turned))); /* n and -n have no middle */
        assert_close3(kept->sliding, f1, 100 * tolerance);
        assert_close3(kept->rolling, l1, 100 * tolerance);
        assert_close(kept->twisting, 0.5, 100 * tolerance);
        assert_close(vti_booked(&effect, 1), 0, 100 * tolerance);
    }
}

/** Spring and dashpot together hold no more than mu F_n, and forces keep momenta. */
TEST(limits_and_momenta)
{
    rng g = rng_seed(1413);
    int limited = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        const double origin[3] = {0, 0, 0}, t = uniform(&g, 0.01, 0.2), mu = uniform(&g, 0.1, 1);
        double f[3], v[3], size = 0, sum[3] = {0}, turn[3] = {0};
        impact_clear(&m, 2, 0, 1e4);
        for (int i = 0; i < 2; ++i) {
            random_vector(&g, 1, m.c.v[i]);
            random_vector(&g, 2, m.c.omega[i]);
        }
        m.c.x[0][2] = 0.99;
        random_vector(&g, 6, f);
        f[2] = 0;
        rub(0);
        friction.sliding = mu;
        friction.stiffness = 1e3;
        dashpots.tangential = uniform(&g, 0, 20);
        const double limit = mu * 1e4 * pow(0.01, 1.5);
        const double least = fmin(1, limit / vti_norm(f) * (1 - 1e-9));
        f[0] *= least;
        f[1] *= least;
        const vti_held held = {1, 2, {f[0], f[1], 0}, {0, 0, 0}, 0};
        assert_int_equal(vti_history_add(&history, &held), VTI_OK);
        memcpy(v, m.c.v[0], sizeof v);
        const vti_effect effects[] = {vti_friction_effect(&friction), vti_dashpots_effect(&dashpots)};
        const double before = vti_kinetic_translation(&m.b) + vti_kinetic_rotation(&m.b);
        assert_int_equal(vti_effects_flow(effects, 2, t, 0, &m.b), VTI_OK);
        for (int k = 0; k < 3; ++k) {
            const double p = m.c.v[0][k] - v[k] - t * f[k];
            size += p * p;
        }
        assert_below(sqrt(size), t * limit * (1 + 1e-9));
        limited += sqrt(size) > t * limit * (1 - 1e-9);
        const double after = vti_kinetic_translation(&m.b) + vti_kinetic_rotation(&m.b);
        assert_close(before, after + vti_booked(effects, 2), 1e-13);
        assert_true(after <= before);
        assert_int_equal(vti_apply(effects, 2, &m.b), VTI_OK);
        for (int k = 0; k < 3; ++k)
            assert_close(m.c.force[0][k], -f[k], 0);
        for (int i = 0; i < 2; ++i) {
            double l[3];
            vti_cross(m.c.x[i], m.c.force[i], l);
            for (int k = 0; k < 3; ++k) {
                sum[k] += m.c.force[i][k];
                turn[k] += l[k] + m.c.moment[i][k];
            }
        }
        assert_close3(sum, origin, 0);
        assert_close3(turn, origin, 32 * EPS * limit);
    }
    assert_true(limited > 400 && limited < 3600);
}

/* ---- the table --------------------------------------------------------------------------------------------------- */

/** Touches that begin and end in any order, in a table that is nearly full, are those that there are. */
TEST(table)
{
    enum { BODIES = 24, ROOM = 64 };
    static double there[BODIES][BODIES];
    rng g = rng_seed(1414);
    const vti_drifted drifted = {.t = 1, .law = VTI_LAW_CAYLEY, .frame = VTI_FRAME_SPACE};
    int64_t used = 0, most = 0;
    impact_clear(&m, 2, 0, 1);
    rub(0);
    history.slots = ROOM;
    friction.sliding = 1;
    friction.stiffness = 1;
    for (int trial = 0; trial < 20000; ++trial) {
        const int i = rng_below(&g, BODIES), j = (i + 1 + rng_below(&g, BODIES - 1)) % BODIES;
        if (there[i][j] == 0) {
            there[i][j] = trial + 1;
            const vti_held held = {i + 1, j + 1, {there[i][j], 0, 0}, {0, 0, 0}, 0};
            const int status = vti_history_add(&history, &held);
            assert_int_equal(status, used + 1 < ROOM ? VTI_OK : VTI_E_HISTORY);
            there[i][j] = status == VTI_OK ? there[i][j] : 0;
            used += status == VTI_OK;
        } else { /* they part: the pair with its bodies' numbers, far from each other */
            static double x[BODIES][3], still[BODIES][3], omega[BODIES][3], one = 1, diameter = 1;
            const int64_t pair[2] = {i, j};
            vti_bodies b = vti_bodies_none(BODIES);
            x[i][0] = 3;
            b.x = vti_view_packed(x[0]);
            b.v = vti_view_packed(still[0]);
            b.omega = vti_view_packed(omega[0]);
            b.alpha = vti_view_packed(m.c.alpha[0]);
            b.mass = b.inertia = vti_scalars_one(&one);
            m.contacts =
                (vti_contacts){.count = 1, .pair = pair, .diameter = vti_scalars_one(&diameter), .stiffness = 1};
            friction.contacts = &m.contacts;
            const vti_effect effect = vti_friction_effect(&friction);
            assert_int_equal(vti_effects_carry(&effect, 1, &drifted, &b), VTI_OK);
            x[i][0] = 0;
            there[i][j] = 0;
            --used;
        }
        most = used > most ? used : most;
        assert_int_equal(history.used, used);
        for (int64_t k = 0; k < used; ++k)
            assert_true(entries[k].sliding[0] == there[entries[k].i - 1][entries[k].j - 1]);
    }
    assert_int_equal(most, ROOM - 1);
}

/** What is refused, and a table without room, which the next call says. */
TEST(refusals)
{
    impact_clear(&m, 2, 0, 1e4);
    rub(0);
    friction.sliding = 0.5;
    vti_effect effect = vti_friction_effect(&friction);
    assert_int_equal(vti_effects_check(&effect, 1, &m.b, NULL), VTI_E_DAMPING); /* no stiffness */
    friction.stiffness = 100;
    assert_int_equal(vti_effects_check(&effect, 1, &m.b, NULL), VTI_OK);
    friction.mindlin = 0.5;
    assert_int_equal(vti_effects_check(&effect, 1, &m.b, NULL), VTI_E_DAMPING); /* two of them */
    friction.mindlin = 0;
    friction.rolling = 1;
    assert_int_equal(vti_effects_check(&effect, 1, &m.b, NULL), VTI_E_DAMPING);
    friction.rolling = 0;
    assert_int_equal(vti_step_check(vti_stepper_find("kl6"), &effect, 1), VTI_E_DISSIPATES);
    history.slots = 3;
    assert_int_equal(vti_effects_check(&effect, 1, &m.b, NULL), VTI_E_HISTORY);
    history.slots = 1;
    assert_int_equal(vti_effects_check(&effect, 1, &m.b, NULL), VTI_OK);
    m.c.x[0][0] = 0.9;
    const vti_drifted drifted = {.t = 1, .law = VTI_LAW_CAYLEY, .frame = VTI_FRAME_SPACE};
    assert_int_equal(vti_effects_carry(&effect, 1, &drifted, &m.b), VTI_OK);
    assert_int_equal(vti_apply(&effect, 1, &m.b), VTI_E_HISTORY);
    friction.lost = NULL;
    effect = vti_friction_effect(&friction);
    assert_int_equal(vti_effects_check(&effect, 1, &m.b, NULL), VTI_E_NULL);
}

RUN_TESTS(cmocka_unit_test(slide_to_roll), cmocka_unit_test(rolling_stops), cmocka_unit_test(incline),
          cmocka_unit_test(spin_stops), cmocka_unit_test(oblique_impacts), cmocka_unit_test(stuck_pairs_turn),
          cmocka_unit_test(limits_and_momenta), cmocka_unit_test(table), cmocka_unit_test(refusals))
