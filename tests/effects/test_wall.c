/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Walls of their own stiffness and friction, and cylinders: against planes one by one, and closed forms. */
#include "walls.h"

static double each[6];

/* ---- walls of a material ----------------------------------------------------------------------------------------- */

/** K = (4/3) E* R^3, 1/E* = 1/M_i + 1/M_w, of bodies and walls of their own materials: forces are (4/3) E* sqrt(R)
 *  delta^{3/2}, and loads, energies and springs those of a wall of that stiffness, to rounding. */
TEST(materials)
{
    rng g = rng_seed(1421);
    double bodies[4], walls[3];
    for (int trial = 0; trial < 200; ++trial) {
        double d[3];
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
    assert_true(vti_walls_stiffness(&m.walls, 0, 3) > 0);
    m.walls.modulus.count = 3; /* fewer than there are bodies, which nothing may read behind */
    assert_true(isnan(vti_walls_stiffness(&m.walls, 0, 3)));
    m.walls.diameter.count = 3;
    m.walls.modulus.count = 4;
    assert_true(isnan(vti_walls_stiffness(&m.walls, 0, 3)) && vti_walls_stiffness(&m.walls, 0, 2) > 0);
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
        dashpots.zeta *= w; /* with and without one for all */
        impact_add(&m, vti_walls_effect(&m.walls));
        impact_add(&m, vti_dashpots_effect(&dashpots));
        impact_go(&m, vti2(), 1.0 / 4096, 3 * 4096);
        assert_close(vti_dashpots_zeta(fabs(m.c.v[0][2]), 0), zetas[w], 2e-3);
    }
}

/** A touch that begins within a drift stretches its spring by the part of the way on which it touches. */
TEST(begins_within_a_drift)
{
    const double t = 0.125, v[3] = {0.8, 0, -0.3}, delta = 0.01, part = delta / (-v[2] * t);
    begin(1, 1, 1e4);
    m.plane[0][2] = 1;
    m.c.x[0][2] = 0.5 - delta;
    memcpy(m.c.v[0], v, sizeof v);
    rub();
    friction.sliding = 1e6; /* holds */
    friction.rolling = friction.twisting = 0;
    const vti_effect both[2] = {vti_walls_effect(&m.walls), vti_friction_effect(&friction)};
    const vti_drifted drifted = {.t = t, .law = VTI_LAW_CAYLEY, .frame = VTI_FRAME_SPACE};
    assert_int_equal(vti_effects_carry(both, 2, &drifted, &m.b), VTI_OK);
    assert_int_equal(history.used, 1);
    assert_close(entries[0].sliding[0], friction.stiffness * v[0] * t * part, 1e-11);
}

/* ---- cylinders --------------------------------------------------------------------------------------------------- */

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
    vti_sum lost[VTI_DASHPOT_BOOKS] = {{0.0, 0.0}};
    const vti_dashpots damps = {.walls = &m.walls, .zeta = 0.5, .tangential = 3, .reach = INFINITY, .lost = lost};
    const vti_effect flow = vti_dashpots_effect(&damps);
    const double speed[3] = {1, 2, 3};
    memcpy(m.c.v[0], speed, sizeof speed);
    assert_int_equal(vti_effects_flow(&flow, 1, 0.1, 0.1, &m.b), VTI_OK);
    assert_same_bits(m.c.v[0], speed, 3);
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
    /* turns back, where errors of time do not show */
    assert_close(m.c.x[0][0] - cylinder[0][3], -r * sin(angle), 1e-4 * r);
    impact_go(&m, vti2(), h, (int64_t)(half / 2 / h));
    /* a touch that gives way: m g/k_t/r of the swing */
    assert_close(m.c.x[0][0] - cylinder[0][3], 0, 6e-3 * r * angle);
}

/* ---- walls in their order ---------------------------------------------------------------------------------------- */

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
    assert_true(isnan(vti_walls_gap(&m.walls, 0, NULL, n)) && isnan(vti_walls_gap(&m.walls, 0, x, NULL)));
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
    assert_int_equal(vti_effects_check(&none, 1, &m.b, NULL), VTI_E_COUNT);
}

/** A plane without friction lets slide what damps along it: neither spring nor dashpot has a hold there. */
TEST(no_friction_at_a_plane)
{
    for (int k = 0; k < 2; ++k) {
        each[0] = 0.1 * k;
        begin(1, 1, 1e4);
        m.plane[0][2] = 1;
        m.c.x[0][2] = 0.49;
        m.c.v[0][0] = 1;
        rub();
        friction.wall_sliding = each;
        friction.rolling = friction.twisting = 0;
        dashpots.ratio = 1;
        dashpots.tangential = 1e3;
        impact_add(&m, vti_walls_effect(&m.walls));
        impact_add(&m, vti_friction_effect(&friction));
        impact_add(&m, vti_dashpots_effect(&dashpots));
        impact_go(&m, vti2(), 1e-3, 10);
        assert_true((m.c.v[0][0] == 1 && m.c.omega[0][1] == 0) == (k == 0));
    }
}

/** Numbers of walls and of the bodies at them; walls themselves are looked at before every call. */
TEST(checked)
{
    static double modulus[2] = {1, 1};
    vti_fault fault;
    begin(2, 2, 10);
    m.plane[0][2] = m.plane[1][2] = 1;
    const vti_walls good = m.walls;
    assert_int_equal(vti_walls_check(&m.walls, 2, &fault), VTI_OK);
    assert_int_equal(vti_walls_check(NULL, 2, NULL), VTI_E_NULL);
    assert_int_equal(vti_walls_check(&m.walls, -1, NULL), VTI_E_COUNT);
    m.walls.diameter.count = 1;
    assert_int_equal(vti_walls_check(&m.walls, 2, &fault), VTI_E_CONTACT);
    assert_true(fault.body == -1 && fault.value == 1);
    m.walls = good;
    m.diameter[1] = -1;
    assert_int_equal(vti_walls_check(&m.walls, 2, &fault), VTI_E_CONTACT);
    assert_true(fault.body == -1 && fault.value == 1);
    assert_int_equal(vti_walls_check(&m.walls, 1, &fault), VTI_OK);
    m.diameter[1] = 1;
    m.walls.modulus = vti_scalars_array(modulus);
    assert_int_equal(vti_walls_check(&m.walls, 2, &fault), VTI_E_CONTACT);
    assert_true(fault.body == -1 && fault.value == 10);
    m.walls.stiffness = 0;
    assert_int_equal(vti_walls_check(&m.walls, 2, &fault), VTI_OK);
    each[0] = each[1] = 10;
    m.walls.each = each; /* a second source of K, as stiffness is */
    assert_int_equal(vti_walls_check(&m.walls, 2, &fault), VTI_E_CONTACT);
    assert_true(fault.body == -1);
    m.walls.each = NULL;
    modulus[0] = 0;
    assert_int_equal(vti_walls_check(&m.walls, 2, &fault), VTI_E_CONTACT);
    assert_true(fault.body == -1 && fault.value == 0);
    m.walls = good;
    const vti_effect effect = vti_walls_effect(&m.walls);
    m.plane[1][2] = 2;
    assert_int_equal(vti_walls_check(&m.walls, 2, &fault), VTI_E_CONTACT);
    assert_true(fault.body == 1 && fault.value == 2);
    assert_int_equal(vti_apply(&effect, 1, &m.b), VTI_E_CONTACT);
    m.plane[1][2] = 1;
    m.walls.stiffness = -10;
    assert_int_equal(vti_apply(&effect, 1, &m.b), VTI_E_CONTACT);
    m.walls.stiffness = 10;
    assert_int_equal(vti_apply(&effect, 1, &m.b), VTI_OK);
}

/** Each number of a wall that may be wrong is the one that is named. */
TEST(what_is_wrong)
{
    vti_fault fault;
    double moduli[3] = {1, 1, 1};
    begin(1, 2, 10);
    inside(0, 0, 0, 1, 2);
    m.plane[0][2] = m.plane[1][2] = 1;
    for (int w = 0; w < 3; ++w)
        each[w] = 10;
    m.walls.each = each;
    m.walls.moduli = moduli;
    m.walls.motion = motion;
    m.walls.work = &work;
    const struct {
        double *number, put, value;
        int64_t wall;
    } bad[] = {{&each[1], -1, -1, 1},
               {&each[2], NAN, NAN, 2},
               {&moduli[1], 0, 0, 1},
               {&m.plane[1][0], NAN, NAN, 1},
               {&m.plane[1][3], INFINITY, INFINITY, 1},
               {&m.plane[0][2], -2, 2, 0},
               {&cylinder[0][5], -INFINITY, -INFINITY, 2},
               {&cylinder[0][6], -2, -2, 2},
               {&motion[0].velocity[2], NAN, NAN, 0},
               {&motion[1].centre[0], INFINITY, INFINITY, 1},
               {&motion[2].moved[1], NAN, NAN, 2},
               {&motion[2].spin, INFINITY, INFINITY, 2}};
    assert_int_equal(vti_walls_check(&m.walls, 1, &fault), VTI_OK);
    for (size_t k = 0; k < sizeof bad / sizeof *bad; ++k) {
        const double good = *bad[k].number;
        *bad[k].number = bad[k].put;
        assert_int_equal(vti_walls_check(&m.walls, 1, &fault), VTI_E_CONTACT);
        assert_true(fault.body == bad[k].wall &&
                    (isnan(bad[k].value) ? isnan(fault.value) : fault.value == bad[k].value));
        *bad[k].number = good;
    }
    m.walls.each = NULL;
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
    motion[0].moved[1] = 0.3; /* as after a restart */
    assert_int_equal(vti_walls_effect(&m.walls).breaks, 073);
    motion[0].moved[1] = 0;
    motion[0].velocity[0] = 1;
    assert_int_equal(vti_walls_effect(&m.walls).breaks, 073);
    inside(0, 0.6, 0, 0.8, 2);
    assert_int_equal(vti_walls_effect(&m.walls).breaks, 077);
}

RUN_TESTS(cmocka_unit_test(materials), cmocka_unit_test(each_its_own),
          cmocka_unit_test(friction_and_restitution_of_each), cmocka_unit_test(begins_within_a_drift),
          cmocka_unit_test(cylinders), cmocka_unit_test(swings_in_a_cylinder), cmocka_unit_test(backward_is_reversed),
          cmocka_unit_test(refused), cmocka_unit_test(no_friction_at_a_plane), cmocka_unit_test(checked),
          cmocka_unit_test(what_is_wrong), cmocka_unit_test(coefficients_of_walls),
          cmocka_unit_test(what_cylinders_break))
