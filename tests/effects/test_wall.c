/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Walls of their own stiffness and friction, cylinders, and walls that move: against planes one by one, closed forms,
 * the same motion seen by somebody who moves along, and the ledger with the walls' work. */
#include "impact.h"

enum { SLOTS = 64 };

static impact m;
static vti_wall_motion motion[6];
static vti_sum work;
static double each[6];
static vti_held slots[SLOTS];
static vti_history history;
static vti_friction friction;
static vti_dashpots dashpots;
static double cylinder[2][7];

static const vti_stepper *vti2(void)
{
    return vti_stepper_find("vti2");
}

/** n bodies and so many planes that may move, without an effect yet. */
static void begin(int n, int planes, double stiffness)
{
    impact_clear(&m, n, planes, stiffness);
    m.contacts.count = 0;
    memset(motion, 0, sizeof motion);
    memset(cylinder, 0, sizeof cylinder);
    work = (vti_sum){0, 0};
}

/** Friction and dashpots of the walls alone. */
static void rub(void)
{
    static vti_sum lost[3];
    memset(slots, 0, sizeof slots);
    memset(lost, 0, sizeof lost);
    history = (vti_history){SLOTS, 0, 0, slots};
    friction = (vti_friction){.walls = &m.walls,
                              .sliding = 0.3,
                              .stiffness = 1500,
                              .rolling = 0.05,
                              .rolling_stiffness = 40,
                              .twisting = 0.02,
                              .twisting_stiffness = 40,
                              .reach = INFINITY,
                              .history = &history,
                              .lost = lost};
    dashpots = (vti_dashpots){.walls = &m.walls,
                              .friction = &friction,
                              .zeta = 0.1,
                              .ratio = 0.5,
                              .rolling = 0.01,
                              .twisting = 0.01,
                              .reach = INFINITY,
                              .lost = m.lost};
}

static void move(void)
{
    m.walls.motion = motion;
    m.walls.work = &work;
}

/* ---- walls of a material ----------------------------------------------------------------------------------------- */

/** K = (4/3) E* R^3, 1/E* = 1/M_i + 1/M_w, of bodies and walls of their own materials: forces are (4/3) E* sqrt(R)
 *  delta^{3/2}, and loads, energies and springs those of a wall of that stiffness, to rounding. */
TEST(materials)
{
    rng g = rng_seed(1421);
    for (int trial = 0; trial < 200; ++trial) {
        double bodies[4], walls[3], d[3];
        begin(4, 3, 0);
        for (int i = 0; i < 4; ++i) {
            m.diameter[i] = uniform(&g, 0.5, 2);
            bodies[i] = uniform(&g, 1e3, 1e5);
            for (int w = 0; w < 3; ++w)
                m.c.x[i][w] = m.diameter[i] * uniform(&g, 0.4, 0.6);
        }
        for (int w = 0; w < 3; ++w) {
            for (int k = 0; k < 4; ++k)
                m.plane[w][k] = k == w;
            walls[w] = uniform(&g, 1e3, 1e5);
        }
        m.walls.modulus = vti_scalars_array(bodies);
        m.walls.moduli = trial & 1 ? walls : NULL;
        const vti_effect effect = vti_walls_effect(&m.walls);
        const vti_bodies b = m.b;
        long double energy = 0;
        assert_int_equal(vti_apply(&effect, 1, &b), VTI_OK);
        for (int i = 0; i < 4; ++i)
            for (int w = 0; w < 3; ++w) {
                const long double radius = 0.5L * m.diameter[i], delta = fmaxl(radius - m.c.x[i][w], 0);
                const long double stiff = 1 / (1.0L / bodies[i] + (trial & 1 ? 1.0L / walls[w] : 0));
                const long double k_h = 4 * stiff * sqrtl(radius) / 3, force = k_h * delta * sqrtl(delta);
                d[w] = m.c.force[i][w];
                /* delta is the difference of what rounds by an eps of the radius */
                assert_close(d[w], force, 16 * EPS * (force + k_h * sqrtl(delta) * radius));
                assert_close(vti_walls_stiffness(&m.walls, w, i), k_h * powl(radius, 2.5L),
                             16 * EPS * k_h * powl(radius, 2.5L));
                energy += 0.4L * k_h * delta * delta * sqrtl(delta);
            }
        assert_close(vti_energy(&effect, 1, &b), energy, 1e3 * EPS * (energy + 1e5));
    }
    assert_true(isnan(vti_walls_stiffness(NULL, 0, 0)) && isnan(vti_walls_stiffness(&m.walls, 3, 0)));
    assert_true(isnan(vti_walls_stiffness(&m.walls, -1, 0)) && isnan(vti_walls_stiffness(&m.walls, 0, -1)));
    m.walls.modulus.p = NULL;
    m.walls.stiffness = 7;
    assert_true(vti_walls_stiffness(&m.walls, 2, 1) == 7);
}

/* ---- walls of their own ------------------------------------------------------------------------------------------ */

/** Planes of their own stiffness are as many walls of one plane, to the bit; their springs and energies too. */
TEST(each_its_own)
{
    rng g = rng_seed(1420);
    for (int trial = 0; trial < 200; ++trial) {
        enum { BODIES = 6 };
        double together[BODIES][3], u, sum = 0, size = 0;
        begin(BODIES, 6, 0);
        for (int w = 0; w < 6; ++w) {
            random_unit(&g, 3, m.plane[w]);
            each[w] = uniform(&g, 1, 100);
            m.plane[w][3] = uniform(&g, -0.2, 0.2);
        }
        for (int i = 0; i < BODIES; ++i)
            random_vector(&g, 1, m.c.x[i]);
        m.walls.each = each;
        const vti_effect all = vti_walls_effect(&m.walls);
        assert_int_equal(vti_apply(&all, 1, &m.b), VTI_OK);
        memcpy(together, m.c.force, sizeof together);
        all.energy(all.self, &m.b, &u);
        vti_walls one[6];
        vti_effect apart[6];
        for (int w = 0; w < 6; ++w) {
            double part;
            one[w] = (vti_walls){
                .count = 1, .plane = m.plane[w], .diameter = vti_scalars_array(m.diameter), .stiffness = each[w]};
            apart[w] = vti_walls_effect(&one[w]);
            apart[w].energy(apart[w].self, &m.b, &part);
            sum += part;
            size += fabs(part);
        }
        assert_int_equal(vti_apply(apart, 6, &m.b), VTI_OK);
        assert_same_bits(together[0], m.c.force[0], 3 * BODIES);
        assert_close(u, sum, 16 * EPS * size);
        double scratch[BODIES];
        const vti_deformation at = {0.05, 0, 0};
        vti_stable whole, parts;
        assert_int_equal(vti_stable_step(&all, 1, &m.b, &at, scratch, &whole), VTI_OK);
        assert_int_equal(vti_stable_step(apart, 6, &m.b, &at, scratch, &parts), VTI_OK);
        assert_close(whole.h, parts.h, 8 * EPS * whole.h);
    }
}

/** Two spheres rest on a plane each, of its own friction, and slide down both with g (sin - mu cos); a third falls on a
 *  plane of its own restitution. */
TEST(friction_and_restitution_of_each)
{
    static const double mu[2] = {0.2, 0.35}, zetas[2] = {0.1, 0.4};
    static vti_gravity gravity;
    const double h = 1.0 / 1024, overlap = pow(10 * 0.5 / 1e4, 2.0 / 3);
    begin(2, 2, 1e4);
    for (int w = 0; w < 2; ++w) { /* back to back */
        m.plane[w][2] = 1 - 2 * w;
        m.plane[w][3] = -10;
        m.c.x[w][2] = (1 - 2 * w) * (-10 + 0.5 * (1 - overlap));
        m.c.mass[w] = 1;
    }
    rub();
    friction.rolling = 0.5; /* held, so that it slides */
    friction.rolling_stiffness = 200;
    friction.twisting = 0;
    friction.wall_sliding = mu;
    impact_add(&m, vti_walls_effect(&m.walls));
    impact_add(&m, vti_friction_effect(&friction));
    for (int w = 0; w < 2; ++w) {
        gravity = (vti_gravity){{5, 0, w ? 10 : -10}};
        m.effects[2] = vti_gravity_effect(&gravity);
        m.count = 3;
        const double *v = m.c.v[w];
        m.c.x[1 - w][2] = 0; /* the other one is in the middle, far from both */
        impact_go(&m, vti2(), h, 256);
        const double before = v[0];
        impact_go(&m, vti2(), h, 512);
        assert_close((v[0] - before) * 2, 5 - 10 * mu[w], 1e-9);
        m.c.x[1][2] = (-1) * (-10 + 0.5 * (1 - overlap));
        memset(m.c.v, 0, sizeof m.c.v);
    }
    for (int w = 0; w < 2; ++w) {
        begin(1, 2, 1e4);
        m.plane[0][2] = 1;
        m.plane[1][2] = -1;
        m.plane[1][3] = -4;
        m.c.x[0][2] = 2;
        m.c.v[0][2] = w ? 1 : -1;
        rub();
        dashpots.friction = NULL;
        dashpots.ratio = dashpots.rolling = dashpots.twisting = 0;
        dashpots.wall_zeta = zetas;
        impact_add(&m, vti_walls_effect(&m.walls));
        impact_add(&m, vti_dashpots_effect(&dashpots));
        impact_go(&m, vti2(), 1.0 / 4096, 3 * 4096);
        assert_close(vti_dashpots_zeta(fabs(m.c.v[0][2]), 0), zetas[w], 2e-3);
    }
}

/* ---- cylinders --------------------------------------------------------------------------------------------------- */

static void inside(int which, double ax, double ay, double az, double radius)
{
    const double all[7] = {ax, ay, az, 0.25, -0.5, 0.125, radius};
    memcpy(cylinder[which], all, sizeof all);
    m.walls.cylinders = which + 1;
    m.walls.cylinder = cylinder[0];
}

/** Force and energy at a cylinder are those of the plane that touches it there, and forces are -grad U. */
TEST(cylinders)
{
    rng g = rng_seed(1421);
    for (int trial = 0; trial < 500; ++trial) {
        double axis[3], side[3], across[3], n[3], u[3];
        begin(1, 0, 1e3);
        random_unit(&g, 3, axis);
        random_unit(&g, 3, side);
        vti_cross(axis, side, across);
        const double length = vti_norm(across), radius = uniform(&g, 2, 5), along = uniform(&g, -3, 3);
        inside(0, axis[0], axis[1], axis[2], radius);
        for (int k = 0; k < 3; ++k) {
            across[k] /= length;
            m.plane[0][k] = -across[k];
            m.c.x[0][k] = cylinder[0][3 + k] + along * axis[k] + (radius - uniform(&g, 0.4, 0.4)) * across[k];
        }
        m.plane[0][3] = vti_dot(m.plane[0], cylinder[0] + 3) - radius;
        assert_close(vti_walls_gap(&m.walls, 0, m.c.x[0], n), 0.4, 1e-14);
        assert_close3(n, m.plane[0], 1e-14);
        const vti_effect round = vti_walls_effect(&m.walls);
        assert_int_equal(vti_apply(&round, 1, &m.b), VTI_OK);
        round.energy(round.self, &m.b, &u[0]);
        double force[3];
        memcpy(force, m.c.force[0], sizeof force);
        vti_walls flat = m.walls;
        flat.count = 1;
        flat.cylinders = 0;
        const vti_effect plane = vti_walls_effect(&flat);
        assert_int_equal(vti_apply(&plane, 1, &m.b), VTI_OK);
        plane.energy(plane.self, &m.b, &u[1]);
        assert_close3(force, m.c.force[0], 1e-9);
        assert_close(u[0], u[1], 1e-10);
        assert_true(vti_norm(force) > 1);
    }
    begin(1, 0, 1e3);
    inside(0, 0, 0, 1, 0.25); /* on the axis of a narrow one there is no direction */
    memcpy(m.c.x[0], cylinder[0] + 3, sizeof m.c.x[0]);
    const vti_effect narrow = vti_walls_effect(&m.walls);
    assert_int_equal(vti_apply(&narrow, 1, &m.b), VTI_OK);
    assert_close(vti_norm(m.c.force[0]), 0, 0);
}

/** A sphere that does not slip rolls through the bottom of a cylinder like a pendulum: omega^2 = (g/(R - l))/(1 + J/(m
 *  l^2)), for small swings, l being the arm of friction. */
TEST(swings_in_a_cylinder)
{
    static vti_gravity gravity = {{0, 0, -10}};
    const double radius = 3, h = 1.0 / 1024, overlap = pow(2 * 10 * 0.5 / 1e5, 2.0 / 3), arm = 0.5 * (1 - overlap);
    begin(1, 0, 1e5);
    inside(0, 0, 1, 0, radius);
    m.c.mass[0] = 2;
    m.c.inertia[0] = 0.2;
    const double angle = 0.02, r = radius - arm;
    m.c.x[0][0] = cylinder[0][3] + r * sin(angle);
    m.c.x[0][1] = 0;
    m.c.x[0][2] = cylinder[0][5] - r * cos(angle);
    rub();
    friction.rolling = friction.twisting = 0;
    friction.sliding = 5;
    friction.stiffness = 1e4;
    dashpots.rolling = dashpots.twisting = 0;
    impact_add(&m, vti_gravity_effect(&gravity));
    impact_add(&m, vti_walls_effect(&m.walls));
    impact_add(&m, vti_friction_effect(&friction));
    impact_add(&m, vti_dashpots_effect(&dashpots));
    const double rate = sqrt(10 / r / (1 + 0.2 / (2 * arm * arm))), half = PI / rate;
    impact_go(&m, vti2(), h, (int64_t)(half / h));
    assert_close(m.c.x[0][0] - cylinder[0][3], -r * sin(angle),
                 1e-4 * r); /* turns back, where errors of time do not show */
    impact_go(&m, vti2(), h, (int64_t)(half / 2 / h));
    assert_close(m.c.x[0][0] - cylinder[0][3], 0,
                 6e-3 * r * angle); /* of a touch that gives way: m g/k_t/r of the swing */
}

/* ---- walls that move --------------------------------------------------------------------------------------------- */

/** A sphere on a wall of all effects; returns the change of the ledger over 0.4 units of time as a share of all energy.
 */
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
        const vti_held *kept = slots;
        while (kept->i == 0)
            ++kept;
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

/** Backward a body meets its walls in the reverse order: that of the reversed list forward. */
TEST(backward_is_reversed)
{
    double v[3][3];
    for (int which = 0; which < 3; ++which) { /* forward; backward with the list reversed; forward with it */
        begin(1, 2, 1e4);
        m.plane[which > 0][2] = 1;
        m.plane[which == 0][0] = 0.6;
        m.plane[which == 0][2] = 0.8;
        m.c.x[0][2] = 0.45;
        m.c.v[0][0] = 1;
        m.c.v[0][2] = -0.5;
        rub();
        dashpots = (vti_dashpots){.walls = &m.walls, .normal = 20, .pull = 1, .reach = INFINITY, .lost = m.lost};
        const vti_effect effect = vti_dashpots_effect(&dashpots);
        assert_int_equal(vti_effects_flow(&effect, 1, 0.1, which == 1 ? -1e-6 : 1e-6, &m.b), VTI_OK);
        memcpy(v[which], m.c.v[0], sizeof v[which]);
    }
    assert_same_bits(v[0], v[1], 3);
    assert_true(fabs(v[0][0] - v[2][0]) > 1e-3);
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

/* ---- what is refused --------------------------------------------------------------------------------------------- */

TEST(refused)
{
    double n[3] = {7, 7, 7};
    const double x[3] = {1, 2, 3};
    begin(1, 1, 10);
    m.plane[0][2] = 1;
    assert_close(vti_walls_gap(&m.walls, 0, x, n), 3, 0);
    assert_true(isnan(vti_walls_gap(NULL, 0, x, n)) && isnan(vti_walls_gap(&m.walls, 1, x, n)) &&
                isnan(vti_walls_gap(&m.walls, -1, x, n)));
    m.walls.motion = motion; /* without work */
    assert_null(vti_walls_effect(&m.walls).apply);
    assert_true(isnan(vti_walls_gap(&m.walls, 0, x, n)));
    move();
    const vti_effect moving = vti_walls_effect(&m.walls);
    assert_int_equal(moving.books, 1);
    vti_bodies b = m.b;
    b.v = (vti_view){0};
    assert_int_equal(vti_apply(&moving, 1, &b), VTI_E_NEEDS);
    assert_int_equal(vti_step_check(vti_stepper_find("srkn6"), &moving, 1), VTI_E_DISSIPATES);
    m.walls.cylinders = 1;
    assert_null(vti_walls_effect(&m.walls).apply);
    m.walls.cylinders = -1;
    vti_stable stable;
    double scratch[1];
    const vti_effect none = vti_walls_effect(&m.walls);
    assert_int_equal(vti_stable_step(&none, 1, &m.b, NULL, scratch, &stable), VTI_E_COUNT);
}

/** Coefficients of walls are finite and not negative. */
TEST(coefficients_of_walls)
{
    static const double wrong[] = {-1, NAN, INFINITY};
    begin(1, 2, 10);
    m.plane[0][2] = m.plane[1][2] = 1;
    rub();
    friction.wall_sliding = dashpots.wall_zeta = each;
    const vti_effect both[2] = {vti_friction_effect(&friction), vti_dashpots_effect(&dashpots)};
    for (int bad = 0; bad < 4; ++bad) {
        each[0] = 0;
        each[1] = bad < 3 ? wrong[bad] : 0;
        for (int k = 0; k < 2; ++k)
            assert_int_equal(vti_effects_check(&both[k], 1, &m.b, NULL), bad < 3 ? VTI_E_DAMPING : VTI_OK);
    }
}

/** What a cylinder breaks: all but momentum along its axis, if that is an axis of space, and angular momentum about it
 *  if it passes through the origin and stays there. */
TEST(what_cylinders_break)
{
    begin(1, 0, 10);
    inside(0, 0, 0, 1, 2);
    assert_int_equal(vti_walls_effect(&m.walls).breaks, 073);
    memset(cylinder[0] + 3, 0, 3 * sizeof(double));
    assert_int_equal(vti_walls_effect(&m.walls).breaks, 033);
    cylinder[0][5] = 4;
    move();
    motion[0].velocity[2] = 1;
    assert_int_equal(vti_walls_effect(&m.walls).breaks, 033);
    motion[0].velocity[0] = 1;
    assert_int_equal(vti_walls_effect(&m.walls).breaks, 073);
    inside(0, 0.6, 0, 0.8, 2);
    assert_int_equal(vti_walls_effect(&m.walls).breaks, 077);
}

RUN_TESTS(cmocka_unit_test(materials), cmocka_unit_test(each_its_own),
          cmocka_unit_test(friction_and_restitution_of_each), cmocka_unit_test(cylinders),
          cmocka_unit_test(swings_in_a_cylinder), cmocka_unit_test(ledger_of_moving_walls),
          cmocka_unit_test(moving_along), cmocka_unit_test(goes_with_the_wall),
          cmocka_unit_test(dashpots_of_moving_walls), cmocka_unit_test(backward_is_reversed), cmocka_unit_test(piston),
          cmocka_unit_test(refused), cmocka_unit_test(coefficients_of_walls), cmocka_unit_test(what_cylinders_break))
