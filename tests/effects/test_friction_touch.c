/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Friction of single touches: one motion alone against its closed form, touches that begin, end, have no direction or
 * turn over, bodies that keep part of their loads, and the springs of the stable step (EQUATIONS 6.5, 6.10). */
#include "impact.h"

enum { SLOTS = 64 };

static impact m;
static vti_held entries[SLOTS];
static int64_t slots[SLOTS];
static vti_history history;
static vti_sum lost[VTI_FRICTION_BOOKS];
static vti_friction friction;
static vti_effect effect;

/** A sphere in the plane z = 0, or two on the z axis, that overlap by 1/10 of the length of their contact, and friction
 *  of the coefficients given. */
static void touch(int plane, double mu, double mu_r, double mu_w)
{
    impact_clear(&m, plane ? 1 : 2, plane, 1e4);
    m.plane[0][2] = 1;
    m.c.x[0][2] = plane ? 0.45 : 0.9;
    memset(slots, 0, sizeof slots);
    memset(lost, 0, sizeof lost);
    history = (vti_history){SLOTS, 0, 0, entries, slots};
    friction = (vti_friction){.contacts = plane ? NULL : &m.contacts,
                              .walls = plane ? &m.walls : NULL,
                              .sliding = mu,
                              .rolling = mu_r,
                              .twisting = mu_w,
                              .stiffness = mu > 0 ? 100 : 0,
                              .rolling_stiffness = 100,
                              .twisting_stiffness = 100,
                              .reach = INFINITY,
                              .history = &history,
                              .lost = lost};
    effect = vti_friction_effect(&friction);
}

/** F_n = K/length o^{3/2}, o = 1/10. */
static double normal_force(int plane)
{
    return 1e4 / (plane ? 0.5 : 1) * pow(0.1, 1.5);
}

static void carried(double t)
{
    const vti_drifted drifted = {.t = t, .law = VTI_LAW_CAYLEY, .frame = VTI_FRAME_SPACE};
    assert_int_equal(vti_effects_carry(&effect, 1, &drifted, &m.b), VTI_OK);
}

/** All that is held. */
static const vti_held *held(void)
{
    assert_int_equal(history.used, 1);
    return entries;
}

static double spring_energy(void)
{
    double energies[VTI_TERMS], sum = 0;
    effect.energy(effect.self, &m.b, energies);
    for (int k = 0; k < effect.terms; ++k)
        sum += energies[k];
    return sum;
}

/* ---- one motion alone -------------------------------------------------------------------------------------------- */

/** Bodies that turn by an angle against each other hold the stiffness times that, and at the limit the limit; the work
 *  f.X/2 (f X beyond) is in the spring, and what is lost. */
TEST(rolling_or_twisting_alone)
{
    for (int which = 0; which < 8; ++which) {
        const int plane = which % 2, twists = which / 2 % 2, slips = which / 4;
        const double angle = slips ? 0.02 : 1e-4, mu = 2e-3, t = 0.25, limit = mu * normal_force(plane);
        touch(plane, 0, twists ? 0 : mu, twists ? mu : 0);
        m.c.omega[0][twists ? 2 : 1] = (plane ? 1 : 0.5) * angle / t;
        m.c.omega[1][twists ? 2 : 1] = -0.5 * angle / t;
        carried(t);
        const double f = fmin(100 * angle, limit);
        assert_true(slips == (100 * angle > limit));
        assert_close(twists ? held()->twisting : held()->rolling[1], f, 1e-4 * f);
        assert_true(vti_norm(held()->sliding) == 0 && (twists ? vti_norm(held()->rolling) : held()->twisting) == 0);
        assert_int_equal(effect.terms, twists ? 3 : 2);
        assert_close(spring_energy(), f * f / 200, 1e-4 * f * f);
        assert_close(spring_energy() + vti_booked(&effect, 1), f * angle / 2, 1e-4 * f * angle);
        assert_true(vti_booked(&effect, 1) >= -1e-18 && (vti_booked(&effect, 1) > 1e-6) == slips);

        assert_int_equal(vti_apply(&effect, 1, &m.b), VTI_OK);
        assert_close(m.c.moment[0][twists ? 2 : 1], -f, 1e-4 * f); /* against what turns */
        for (int k = 0; k < 3; ++k) {
            assert_close(m.c.force[0][k], 0, 0);
            assert_close(m.c.moment[1][k], plane ? 0 : -m.c.moment[0][k], 0); /* as much on the other */
        }
    }
}

/** A body that slides over a plane, or over another, by a length holds the stiffness times that; the limit holds. */
TEST(sliding_alone)
{
    for (int which = 0; which < 8; ++which) {
        const int plane = which % 2, mindlin = which / 2 % 2, slips = which / 4;
        touch(plane, 0.3, 0, 0);
        const double limit = 0.3 * normal_force(plane), length = plane ? 0.5 : 1,
                     k = mindlin ? 0.8 * 1.5 * 1e4 / (length * length) * sqrt(0.1) : 100,
                     way = (slips ? 20 : 1e-3) * limit / k;
        friction.stiffness = mindlin ? 0 : 100;
        friction.mindlin = mindlin ? 0.8 : 0;
        m.c.v[0][0] = way;
        m.c.x[0][0] = plane ? way : 0;
        const double start = plane ? 0 : way; /* of a pair the end is on the axis, and the way turns the normal */
        carried(1);
        const double f = vti_norm(held()->sliding);
        assert_below(f, limit * (1 + 8 * EPS));
        if (plane || !slips)
            assert_close(held()->sliding[0], slips ? limit : k * way, (start + 1e-12) * k * way);
        assert_close(spring_energy(), f * f / (2 * k), 1e-12 * f * f / k);
        assert_true(vti_booked(&effect, 1) >= -1e-12 * f * f / k);
    }
}

/* ---- rest -------------------------------------------------------------------------------------------------------- */

/** A sphere on a plane, or two that turn against each other, with dashpots and springs of all motions come to rest to
 *  the last bit: neither velocities nor loads go on as subnormal numbers. */
TEST(rest)
{
    double other[8];
    for (int which = 0; which < 4; ++which) {
        const int plane = which % 3 != 0;
        const vti_view packed = vti_view_packed(m.c.omega[0]),
                       separate = vti_view_separate(other, other + 2, other + 4),
                       strided = {{other, other + 1, other + 2}, 4, 0},
                       omega = which < 2    ? packed
                               : which == 2 ? separate
                                            : strided;
        vti_sum dissipated[VTI_DASHPOT_BOOKS] = {{0, 0}};
        touch(plane, plane ? 0.3 : 0, 0.1, 0.1);
        const vti_dashpots dashpots = {.contacts = plane ? NULL : &m.contacts,
                                       .walls = plane ? &m.walls : NULL,
                                       .tangential = plane ? 5 : 0,
                                       .rolling = 2,
                                       .twisting = 2,
                                       .reach = INFINITY,
                                       .friction = &friction,
                                       .lost = dissipated};
        for (int k = 0; k < 3; ++k) {
            omega.c[k][0] = 1e-4 * (k + 1);
            omega.c[k][omega.stride] = plane ? 0 : -omega.c[k][0];
            m.c.v[0][k] = plane && k < 2 ? 1e-4 : 0;
        }
        m.b.omega = omega;
        impact_add(&m, effect);
        impact_add(&m, vti_dashpots_effect(&dashpots));
        impact_go(&m, vti_stepper_find("vti2"), 0.02, 30000);
        for (int k = 0; k < 3; ++k) {
            assert_true(m.c.v[0][k] == 0 && m.c.v[1][k] == 0);
            assert_true(omega.c[k][0] == 0 && omega.c[k][omega.stride] == 0);
            assert_true(held()->sliding[k] == 0 && held()->rolling[k] == 0);
        }
        assert_true(held()->twisting == 0);
    }
}

/* ---- touches ----------------------------------------------------------------------------------------------------- */

/** A pair that comes from a wider gap than reach holds nothing yet, so that results do not depend on what else lists
 *  hold; planes are looked at whatever the gap. What parts leaves the table. */
TEST(reach)
{
    for (int which = 0; which < 8; ++which) { /* a plane, and pairs along x, y and z */
        const int plane = which % 4 == 3, far = which / 4, axis = plane ? 2 : which % 4;
        touch(plane, 0.3, 0, 0);
        friction.reach = far ? 0.1 : 0.5;
        m.c.x[0][2] = 0;
        m.c.x[0][axis] = plane ? 0.45 : 0.9;
        m.c.v[0][axis] = -1; /* from a gap of 0.4 or 0.45 */
        m.c.v[0][(axis + 1) % 3] = 0.2;
        carried(0.5);
        assert_int_equal(history.used, plane || !far);
        friction.reach = 1;
        m.c.x[0][axis] = 2;
        m.c.v[0][axis] = 2.2;
        carried(0.5);
        assert_int_equal(history.used, 0);
        assert_close(spring_energy(), 0, 0);
    }
}

/** In a table that is full one that parts makes room for one that begins in the same drift, behind it in the list. */
TEST(room_of_what_parts)
{
    static const int64_t pairs[4] = {0, 1, 2, 0};
    const vti_held load = {1, 2, {1, 0, 0}, {0, 0, 0}, 0};
    touch(0, 0.3, 0, 0);
    m.c.n = 3;
    m.b = crowd_bodies(&m.c);
    m.diameter[2] = m.c.mass[2] = m.c.inertia[2] = 1;
    memcpy(m.pair, pairs, sizeof pairs);
    m.contacts.count = 2;
    history.slots = 2; /* of which one stays empty */
    assert_int_equal(vti_history_add(&history, &load), VTI_OK);
    m.c.x[1][2] = m.c.v[1][2] = -0.5; /* 1 has left 0, which is at z = 0.9, and 2 has come to it */
    m.c.x[2][2] = 1.8;
    m.c.v[2][2] = -0.3;
    carried(1);
    assert_true(history.missed == 0 && held()->i == 3 && held()->j == 1);
}

/** A body that the slice leaves out may turn by more than the closed form knows in a step: loads stay finite. */
TEST(left_out_and_fast)
{
    touch(0, 0.3, 0, 0);
    m.c.x[1][2] = 0.0;
    m.c.omega[1][1] = 60.0;
    m.b.count = 1;
    assert_int_equal(vti_effects_begin(vti_stepper_find("vti1"), 0.02, &effect, 1, &m.b, NULL), VTI_OK);
    assert_int_equal(vti_apply(&effect, 1, &m.b), VTI_OK);
    for (int k = 0; k < 3; ++k)
        assert_true(isfinite(m.c.force[0][k]) && isfinite(held()->sliding[k]));
    assert_true(isfinite(lost[0].high));
}

/** A touch that has not been carried yet pushes nothing and holds no energy. */
TEST(touches_without_a_spring)
{
    for (int plane = 0; plane < 2; ++plane) {
        touch(plane, 0.3, 0.1, 0.1);
        assert_int_equal(vti_apply(&effect, 1, &m.b), VTI_OK);
        assert_true(vti_norm(m.c.force[0]) == 0 && vti_norm(m.c.moment[0]) == 0 && spring_energy() == 0);
    }
}

/** Centres that coincide have no direction, and NaN touches nothing: nothing comes of them, but that no step is stable
 *  with NaN. */
TEST(no_direction)
{
    double scratch[2];
    vti_stable stable;
    touch(0, 0.3, 0.1, 0.1);
    m.c.x[0][2] = 0;
    carried(1);
    assert_int_equal(vti_apply(&effect, 1, &m.b), VTI_OK);
    assert_int_equal(vti_stable_step(&effect, 1, &m.b, NULL, scratch, &stable), VTI_OK);
    assert_true(history.used == 0 && vti_norm(m.c.force[0]) == 0 && isinf(stable.h));

    m.c.x[0][0] = m.c.v[0][0] = 0.9; /* apart again: the drift began where there was none, and its end serves */
    m.c.v[0][1] = 0;
    carried(1);
    assert_true(vti_norm(held()->sliding) == 0);

    touch(1, 0.3, 0.1, 0.1);
    m.c.x[0][2] = NAN;
    carried(1);
    assert_int_equal(history.used, 0);
    assert_int_equal(vti_stable_step(&effect, 1, &m.b, NULL, scratch, &stable), VTI_OK);
    assert_true(stable.h == 0);
}

/** Bodies that go through each other, so that the normal turns over, let go: the energy of the spring is booked. */
TEST(turned_over)
{
    touch(0, 0.3, 0.1, 0);
    const vti_held load = {1, 2, {3, 4, 0}, {0.5, 0, 0}, 0};
    assert_int_equal(vti_history_add(&history, &load), VTI_OK);
    const double before = spring_energy();
    assert_close(before, 25.0 / 200 + 0.25 / 200, 4 * EPS);
    m.c.v[0][2] = 1.8;
    carried(1);
    assert_true(vti_norm(held()->sliding) == 0 && vti_norm(held()->rolling) == 0);
    assert_close(vti_booked(&effect, 1), before, 4 * EPS);
}

/** A host's table may hold a load of bodies that are apart: it goes, and as nothing moves nothing is booked. */
TEST(held_but_apart)
{
    for (int mindlin = 0; mindlin < 2; ++mindlin) {
        touch(0, 0.3, 0, 0);
        friction.stiffness = mindlin ? 0 : 100;
        friction.mindlin = mindlin ? 0.8 : 0;
        m.c.x[0][2] = 1.2;
        const vti_held load = {1, 2, {1, 0, 0}, {0, 0, 0}, 0};
        assert_int_equal(vti_history_add(&history, &load), VTI_OK);
        carried(1);
        assert_true(history.used == 0 && vti_booked(&effect, 1) == 0);
    }
}

/** Bodies that keep forces only, or moments only, and those of a slice only, get the same ones. */
TEST(part_of_the_loads)
{
    double force[2][3], moment[2][3];
    const vti_held load = {1, 2, {3, 4, 0}, {0.5, 0, 0}, 0.25};
    touch(0, 0.3, 0.1, 0.1);
    assert_int_equal(vti_history_add(&history, &load), VTI_OK);
    assert_int_equal(vti_apply(&effect, 1, &m.b), VTI_OK);
    memcpy(force, m.c.force, sizeof force);
    memcpy(moment, m.c.moment, sizeof moment);
    assert_true(force[0][0] == -3 && force[1][1] == 4 && moment[1][2] == 0.25);
    for (int which = 0; which < 2; ++which) {
        memset(m.c.force, 0, sizeof m.c.force);
        memset(m.c.moment, 0, sizeof m.c.moment);
        m.b = crowd_bodies(&m.c);
        *(which ? &m.b.force : &m.b.moment) = vti_view_none();
        assert_int_equal(vti_apply(&effect, 1, &m.b), VTI_OK);
        for (int i = 0; i < 2; ++i)
            for (int k = 0; k < 3; ++k) {
                assert_close(m.c.force[i][k], which ? 0 : force[i][k], 0);
                assert_close(m.c.moment[i][k], which ? moment[i][k] : 0, 0);
            }
    }
    for (int own = 0; own < 2; ++own) {
        memset(m.c.force, 0, sizeof m.c.force);
        memset(m.c.moment, 0, sizeof m.c.moment);
        const vti_bodies slice = vti_bodies_slice(crowd_bodies(&m.c), own, 1);
        assert_int_equal(vti_apply(&effect, 1, &slice), VTI_OK);
        for (int i = 0; i < 2; ++i)
            for (int k = 0; k < 3; ++k) {
                assert_close(m.c.force[i][k], i == own ? force[i][k] : 0, 0);
                assert_close(m.c.moment[i][k], i == own ? moment[i][k] : 0, 0);
            }
    }
}

/* ---- the stable step --------------------------------------------------------------------------------------------- */

static double limit_at(const vti_deformation *at)
{
    double scratch[CROWD_MAX];
    vti_stable stable;
    assert_int_equal(vti_stable_step(&effect, 1, &m.b, at, scratch, &stable), VTI_OK);
    return stable.h;
}

/** 2/omega of one touch: omega^2 = k/m_t of sliding, m_t that of EQUATIONS 6.2 with r = length, and k/J_r of rolling
 *  and twisting; at an overlap that is given, and as the bodies are, which is 1/10 too. */
TEST(stable_steps)
{
    rng g = rng_seed(1432);
    for (int trial = 0; trial < 400; ++trial) {
        const int plane = trial % 2, which = trial / 2 % 4, meet = trial / 8 % 2 && plane;
        const vti_deformation at = {0.1, 0, meet};
        touch(plane, which < 2 ? 0.3 : 0, which == 2 ? 0.1 : 0, which == 3 ? 0.1 : 0);
        friction.stiffness = which == 0 ? 100 : 0;
        friction.mindlin = which == 1 ? 0.8 : 0;
        for (int i = 0; i < 2; ++i) {
            m.diameter[i] = uniform(&g, 0.5, 2);
            m.c.mass[i] = uniform(&g, 0.1, 5);
            m.c.inertia[i] = uniform(&g, 0.1, 5);
        }
        const double ri = m.diameter[0] / 2, rj = plane ? 0 : m.diameter[1] / 2, length = ri + rj,
                     other = plane ? 0 : 1;
        m.c.x[0][2] = 0.9 * length;
        const double k = which == 1 ? 0.8 * 1.5 * 1e4 / (length * length) * sqrt(0.1) : 100;
        const double per_m = 1 / m.c.mass[0] + other / m.c.mass[1],
                     per_t = per_m + ri * ri / m.c.inertia[0] + other * rj * rj / m.c.inertia[1],
                     per_j = 1 / m.c.inertia[0] + other / m.c.inertia[1];
        const double expected = 2 / sqrt(k * (which < 2 ? per_t : per_j));
        assert_close(limit_at(&at), expected, 64 * EPS * expected);
        assert_close(limit_at(NULL), expected, 64 * EPS * expected);
        m.c.x[0][2] = 1.1 * length;
        assert_true(isinf(limit_at(NULL)));
        assert_close(limit_at(&at), expected, 64 * EPS * expected);
    }
}

/** Where any may touch the bound holds for up to four bodies that all do, is the limit for two equal ones that do not
 *  slide and roll at once, and one body has nothing to touch. */
TEST(any_may_touch)
{
    const vti_deformation listed = {0.1, 0, 0}, any = {0.1, 0, 1};
    rng g = rng_seed(1433);
    for (int trial = 0; trial < 400; ++trial) {
        const int n = 1 + trial % 4, which = trial / 4 % 4;
        touch(0, which < 2 ? 0.3 : 0, which % 3 == 0 ? 0.1 : 0, which != 1 ? 0.1 : 0);
        friction.stiffness = which == 0 ? 100 : 0;
        friction.mindlin = which == 1 ? 0.8 : 0;
        impact_clear(&m, n, 0, 1e4);
        for (int i = 0; i < n; ++i) { /* equal ones of some size, at places that have a direction */
            m.diameter[i] = 0.6 + 0.15 * (trial % 17);
            m.c.x[i][0] = i;
        }
        for (int i = 0; i < n && trial > 16; ++i) {
            m.diameter[i] = uniform(&g, 0.5, 2);
            m.c.mass[i] = uniform(&g, 0.1, 5);
            m.c.inertia[i] = uniform(&g, 0.1, 5);
        }
        const double bound = limit_at(&any), limit = limit_at(&listed);
        assert_below(bound, limit * (1 + 64 * EPS));
        assert_true(n == 1 ? isinf(bound) && isinf(limit) : bound > 0 && isfinite(limit));
        if (n == 2 && trial <= 16 && which != 0)
            assert_close(bound, limit, 64 * EPS * limit);
    }
}

/** Pairs that have lengths of their own are looked at where any two may meet; one of a body that is none is refused. */
TEST(a_length_of_no_pair)
{
    const int64_t far[2] = {0, 2};
    const double length = 0.95;
    const vti_deformation any = {0.1, 0, 1};
    double scratch[2];
    vti_stable found;
    touch(0, 0.5, 0, 0);
    m.contacts.length = vti_scalars_one(&length);
    assert_int_equal(vti_stable_step(&effect, 1, &m.b, &any, scratch, &found), VTI_OK);
    assert_true(found.h > 0 && isfinite(found.h));
    m.contacts.pair = far;
    assert_int_equal(vti_stable_step(&effect, 1, &m.b, &any, scratch, &found), VTI_E_BOND);
}

RUN_TESTS(cmocka_unit_test(a_length_of_no_pair), cmocka_unit_test(held_but_apart),
          cmocka_unit_test(rolling_or_twisting_alone), cmocka_unit_test(sliding_alone), cmocka_unit_test(rest),
          cmocka_unit_test(reach), cmocka_unit_test(room_of_what_parts), cmocka_unit_test(left_out_and_fast),
          cmocka_unit_test(touches_without_a_spring), cmocka_unit_test(no_direction), cmocka_unit_test(turned_over),
          cmocka_unit_test(part_of_the_loads), cmocka_unit_test(stable_steps), cmocka_unit_test(any_may_touch))
