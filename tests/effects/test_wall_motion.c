/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Walls that move: the ledger with their work, the same motion seen by somebody who moves along, and what goes with
 * them. */
#include "walls.h"

/** A sphere on a wall of all effects; returns the change of the ledger over a time of 0.4, as a share of all energy. */
static double ride(int round, double speed, double spin, double start, int steps, double after[6], double *put_in)
{
    rng g = rng_seed(1422);
    double n[3], side[3];
    begin(1, !round, 2e4);
    random_unit(&g, 3, n);
    const double flat[3] = {n[1], -n[0], 0}, length = vti_norm(flat);
    vti_cross(n, flat, side);
    m.c.mass[0] = 2;
    m.c.inertia[0] = 0.3;
    m.diameter[0] = 1.25;
    if (round)
        inside(0, flat[0] / length, flat[1] / length, 0, 4);
    for (int k = 0; k < 3; ++k) {
        m.plane[0][k] = n[k];
        motion[0].velocity[k] = speed * (n[k] + 0.5 * side[k]);
        motion[0].centre[k] = 0.3 * k;
        m.c.x[0][k] = round ? cylinder[0][3 + k] - (4 - 0.64 - start) * n[k] : (0.64 + start) * n[k];
        m.c.v[0][k] = -n[k] + 0.7 * side[k];
        m.c.omega[0][k] = k - 1;
    }
    motion[0].spin = spin;
    move();
    rub();
    impact_add(&m, vti_walls_effect(&m.walls));
    impact_add(&m, vti_friction_effect(&friction));
    impact_add(&m, vti_dashpots_effect(&dashpots));
    const double before = impact_ledger(&m);
    impact_go(&m, vti2(), 0.4 / steps, steps);
    *put_in = -vti_sum_value(&work);
    memcpy(after, m.c.v[0], 3 * sizeof *after);
    memcpy(after + 3, m.c.omega[0], 3 * sizeof *after);
    assert_int_equal(history.used, 0);
    return fabs(impact_ledger(&m) - before) / before;
}

/** T + U + what is booked stays to second order, walls' work included, and the motion converges (as scattered as at a
 *  wall at rest: touches stick and slip many times): planes and cylinders that move, turn, and both. */
TEST(ledger_of_moving_walls)
{
    for (int which = 0; which < 6; ++which) {
        const double speed = which % 3 == 0 ? 0 : 0.4, spin = which % 3 == 1 ? 0 : 1.5;
        double fine[6], v[6], put_in, change[4] = {0}, error[4] = {0};
        for (int place = 0; place < 4; ++place) {
            const double start = 7e-4 * place;
            ride(which / 3, speed, spin, start, 512 << 5, fine, &put_in);
            assert_below(0.01, fabs(put_in)); /* of 1.5 */
            for (int level = 0; level < 4; ++level) {
                change[level] += ride(which / 3, speed, spin, start, 256 << level, v, &put_in) / 4;
                for (int k = 0; k < 6; ++k)
                    error[level] += pow(v[k] - fine[k], 2) / 4;
            }
        }
        const double order = log2(change[0] / change[3]) / 3;
        print_message("%s, V = %.1f, W = %.1f: work %.3f, ledger %.1e, order %.2f; motion %.1e to %.1e\n",
                      which / 3 ? "cylinder" : "plane", speed, spin, put_in, change[3], order, sqrt(error[0]),
                      sqrt(error[3]));
        assert_below(sqrt(error[3]), 2e-4);
        assert_below(error[3], error[0] / 8);
        assert_below(change[3], 4e-5);
        assert_below(1.8, order);
    }
}

/** Seen by somebody who moves along with the wall all is as at a wall at rest: positions, turns and losses agree, and
 *  the wall's work is what its velocity makes of the momentum that it gives. */
TEST(moving_along)
{
    const double along[3] = {0.25, -0.5, 0.125};
    for (int round = 0; round < 2; ++round) {
        double x[2][3], omega[2][3], lost[2], momentum[3];
        for (int moving = 0; moving < 2; ++moving) {
            begin(1, !round, 2e4);
            m.plane[0][2] = 1;
            if (round)
                inside(0, 0, 1, 0, 3);
            m.c.x[0][0] = 0.25;
            m.c.x[0][2] = round ? 0.125 - 3 + 0.52 : 0.52;
            m.c.v[0][0] = 0.5;
            m.c.v[0][2] = -1;
            for (int k = 0; k < 3; ++k)
                m.c.v[0][k] += motion[0].velocity[k] = moving * along[k];
            memcpy(momentum, m.c.v[0], sizeof momentum);
            if (moving)
                move();
            rub();
            impact_add(&m, vti_walls_effect(&m.walls));
            impact_add(&m, vti_friction_effect(&friction));
            impact_add(&m, vti_dashpots_effect(&dashpots));
            impact_go(&m, vti2(), 1.0 / 4096, 2048);
            for (int k = 0; k < 3; ++k) {
                x[moving][k] = m.c.x[0][k] - 0.5 * motion[0].velocity[k];
                momentum[k] = m.c.mass[0] * (m.c.v[0][k] - momentum[k]);
                omega[moving][k] = m.c.omega[0][k];
                assert_close(motion[0].moved[k], 0.5 * motion[0].velocity[k], 1e-15);
            }
            lost[moving] = vti_booked(&m.effects[1], 2);
        }
        assert_close3(x[0], x[1], 1e-9);
        assert_close3(omega[0], omega[1], 1e-9);
        assert_close(lost[0], lost[1], 1e-9);
        /* loads turn with a round wall after the drift: of second order */
        assert_close(-vti_sum_value(&work), vti_dot(momentum, along), round ? 1e-8 : 1e-12);
        assert_true(vti_norm(momentum) > 1 && history.used == 0);
    }
}

/** A sphere that is stuck to a drum, to a turntable or to what moves goes with it by any angle in one drift: nothing
 *  slides, rolls or twists, and loads turn with it. */
TEST(goes_with_the_wall)
{
    rng g = rng_seed(1423);
    for (int trial = 0; trial < 200; ++trial) {
        const int round = trial % 2;
        const double angle = uniform(&g, -1, 1), t = 0.125;
        double before[3], foot[3], n[3], load[3], turned[3], axis[3] = {0, 0, 1};
        begin(1, 1 - round, 1e4);
        m.plane[0][2] = 1;
        inside(0, 0, 0, 1, 2);
        m.walls.cylinders = round;
        motion[0].spin = 2 * tan(angle / 2) / t; /* turns by that angle as bodies do in such a drift, h W for alpha */
        motion[0].centre[0] = 0.5;
        for (int k = 0; k < 3; ++k)
            motion[0].velocity[k] = uniform(&g, -1, 1);
        move();
        const double *centre = round ? cylinder[0] + 3 : motion[0].centre, around = uniform(&g, 0, 6);
        foot[0] = round ? 2 * cos(around) : 0.7;
        foot[1] = round ? 2 * sin(around) : 0.2;
        foot[2] = round ? 0.3 : 0;
        for (int k = 0; k < 3; ++k) {
            n[k] = round ? (k < 2 ? -foot[k] / 2 : 0) : m.plane[0][k];
            before[k] = foot[k] + 0.48 * n[k];
        }
        random_vector(&g, 1, load);
        const double along = vti_dot(load, n);
        const rotor q = quat_turn(axis, angle);
        rub();
        friction.sliding = friction.rolling = friction.twisting = 10;
        vti_held held = {.i = 1, .j = -1, .twisting = 0.5};
        quat_rotate(q, before, turned);
        for (int k = 0; k < 3; ++k) {
            held.sliding[k] = held.rolling[k] = load[k] -= along * n[k];
            m.c.x[0][k] = centre[k] + turned[k] + t * motion[0].velocity[k];
            m.c.v[0][k] = (turned[k] - before[k]) / t + motion[0].velocity[k];
            m.c.omega[0][k] = motion[0].spin * axis[k];
        }
        assert_int_equal(vti_history_add(&history, &held), VTI_OK);
        quat_rotate(q, load, turned);
        const vti_effect both[2] = {vti_walls_effect(&m.walls), vti_friction_effect(&friction)};
        const vti_drifted drifted = {.t = t, .law = VTI_LAW_CAYLEY, .frame = VTI_FRAME_SPACE};
        assert_int_equal(vti_effects_carry(both, 2, &drifted, &m.b), VTI_OK);
        const vti_held *const kept = entries;
        assert_int_equal(history.used, 1);
        assert_close3(kept->sliding, turned, 1e-11);
        assert_close3(kept->rolling, turned, 1e-11);
        assert_close(kept->twisting, 0.5, 1e-11);
        assert_close(vti_booked(&both[1], 1), 0, 1e-11);
    }
}

/** Dashpots of a wall see nothing in a body that goes with its surface, at any spin, and push one that does not. */
TEST(dashpots_of_moving_walls)
{
    rng g = rng_seed(1424);
    for (int trial = 0; trial < 200; ++trial) {
        const int round = trial % 2, slips = trial / 2 % 2;
        double d[3], along[3], before[3];
        begin(1, 1 - round, 1e4);
        m.plane[0][2] = 1;
        inside(0, 0, 0, 1, 2);
        m.walls.cylinders = round;
        motion[0].spin = uniform(&g, -3, 3);
        random_vector(&g, 1, motion[0].velocity);
        random_vector(&g, 1, motion[0].centre);
        move();
        const double *centre = round ? cylinder[0] + 3 : motion[0].centre;
        const double axis[3] = {0, 0, motion[0].spin}, out[3] = {round ? 2 - 0.48 : 0.7, 0, round ? 0.3 : 0.48};
        for (int k = 0; k < 3; ++k) {
            m.c.x[0][k] = out[k] + (round || k < 2 ? centre[k] : 0);
            d[k] = m.c.x[0][k] - centre[k];
        }
        vti_cross(axis, d, along);
        for (int k = 0; k < 3; ++k) {
            m.c.v[0][k] = before[k] = along[k] + motion[0].velocity[k] + (slips && k == 1);
            m.c.omega[0][k] = axis[k];
        }
        rub();
        dashpots.friction = NULL;
        const vti_effect effect = vti_dashpots_effect(&dashpots);
        assert_int_equal(vti_effects_flow(&effect, 1, 0.1, 0.1, &m.b), VTI_OK);
        assert_true((fabs(m.c.v[0][1] - before[1]) > 1e-3) == slips);
        assert_true(slips || fabs(vti_sum_value(&work)) < 1e-12);
    }
}

/** A piston that compresses a column of spheres slowly does the work that they take up. */
TEST(piston)
{
    begin(3, 2, 1e3);
    m.contacts.count = 2;
    m.pair[1][0] = 1;
    m.pair[1][1] = 2;
    m.plane[0][2] = 1;
    m.plane[1][2] = -1;
    m.plane[1][3] = -3;
    for (int i = 0; i < 3; ++i)
        m.c.x[i][2] = 0.5 + i;
    motion[1].velocity[2] = -1.0 / 64;
    move();
    impact_add(&m, vti_contacts_effect(&m.contacts));
    impact_add(&m, vti_walls_effect(&m.walls));
    impact_go(&m, vti2(), 1.0 / 256, 16 * 256);
    const double u = vti_energy(m.effects, 2, &m.b);
    assert_close(motion[1].moved[2], -0.25, 1e-13);
    assert_true(u > 1);
    assert_close(vti_booked(m.effects, 2), -u, 1e-5 * u);
}

RUN_TESTS(cmocka_unit_test(ledger_of_moving_walls), cmocka_unit_test(moving_along),
          cmocka_unit_test(goes_with_the_wall), cmocka_unit_test(dashpots_of_moving_walls), cmocka_unit_test(piston))
