/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Dashpots of contacts and planes: restitution against its closed forms, the ledger of oblique impacts, random impacts
 * that never gain, what a crowd keeps, and one flow against the exponential of its matrix. */
#include "impact.h"

static impact m;

static const vti_stepper *vti2(void)
{
    return vti_stepper_find("vti2");
}

/* ---- restitution ------------------------------------------------------------------------------------------------- */

/** e of zeta in libm's functions (EQUATIONS 6.3). */
static double closed_form(double zeta, int pull)
{
    if (pull)
        return exp(-PI * zeta / sqrt(1 - zeta * zeta));
    return zeta < 1   ? exp(-2 * zeta * acos(zeta) / sqrt(1 - zeta * zeta))
           : zeta > 1 ? exp(-2 * zeta * acosh(zeta) / sqrt(zeta * zeta - 1))
                      : exp(-2.0);
}

TEST(zeta_of_restitution)
{
    for (int pull = 0; pull < 2; ++pull)
        for (int k = 1; k < 400; ++k) {
            const double e = pow(10, -4.0 * k / 400), zeta = vti_dashpots_zeta(e, pull);
            assert_close(closed_form(zeta, pull), e, e * 1e-13 * (1 + 1 / fabs(1 - zeta)));
        }
    assert_true(vti_dashpots_zeta(1e-40, 0) >= 1e12 && isfinite(vti_dashpots_zeta(1e-40, 0))); /* no rebound */
    assert_true(vti_dashpots_zeta(1, 0) == 0 && vti_dashpots_zeta(1, 1) == 0);
    assert_true(isnan(vti_dashpots_zeta(0, 0)) && isnan(vti_dashpots_zeta(-0.5, 1)) &&
                isnan(vti_dashpots_zeta(1.5, 0)) && isnan(vti_dashpots_zeta(NAN, 1)));
}

/** The share of the speed that is left after head-on impacts of two unequal spheres (or one and a plane) by so many
 *  steps in a contact without damping: the largest error over places of the first touch within a step. */
static double restitution_error(double zeta, int pull, int plane, double speed, int steps)
{
    double worst = 0;
    for (int start = 0; start < 5; ++start) {
        impact_clear(&m, 2, plane, 1e4);
        m.c.mass[0] = 2;
        m.diameter[0] = 1.5;
        m.plane[0][2] = 1;
        const double reduced = plane ? 2 : 2.0 / 3, length = plane ? 0.75 : 1.25, k_h = 1e4 / pow(length, 2.5);
        const double duration = impact_duration(reduced, k_h, speed), h = duration / steps;
        const vti_dashpots dashpots = {.contacts = plane ? NULL : &m.contacts,
                                       .walls = plane ? &m.walls : NULL,
                                       .zeta = zeta,
                                       .pull = pull,
                                       .reach = INFINITY,
                                       .lost = m.lost};
        impact_add(&m, plane ? vti_walls_effect(&m.walls) : vti_contacts_effect(&m.contacts));
        impact_add(&m, vti_dashpots_effect(&dashpots));
        m.c.x[0][2] = length + speed * h * (0.5 + 0.2 * start);
        m.c.v[0][2] = plane ? -speed : -speed / 3;
        m.c.v[1][2] = plane ? 0 : speed * 2 / 3;
        m.c.x[1][2] = plane ? 40 : 0;
        impact_go(&m, vti2(), h, 4 * steps);
        worst = fmax(worst, fabs((m.c.v[0][2] - m.c.v[1][2]) / speed - closed_form(zeta, pull)));
        assert_true(m.c.v[0][2] > (pull ? -1 : 0) && m.lost[0].high > 0);
    }
    return worst;
}

/** Of order 2, within 4e-4 at 50 steps in a contact, at any speed (EQUATIONS 6.3). */
TEST(restitution)
{
    static const double zetas[] = {0.05, 0.3, 0.8, 1.2};
    for (int k = 0; k < 4; ++k)
        for (int plane = 0; plane < 2; ++plane)
            for (int pull = 0; pull < (zetas[k] < 0.5 ? 2 : 1); ++pull) {
                const double coarse = restitution_error(zetas[k], pull, plane, plane ? 0.01 : 10, 50),
                             fine = restitution_error(zetas[k], pull, plane, plane ? 0.01 : 10, 400);
                print_message("zeta %.2f, %s, %s: error %.1e, order %.2f\n", zetas[k], pull ? "pull" : "no pull",
                              plane ? "plane" : "pair", coarse, log2(coarse / fine) / 3);
                assert_below(coarse, 4e-4);
                assert_below(1.7, log2(coarse / fine) / 3);
            }
}

/* ---- one touch --------------------------------------------------------------------------------------------------- */

/** A random state of two spheres, or one and a plane, that overlap by a share o of their mean diameter. */
static void random_touch(rng *g, int plane, double o)
{
    double n[3];
    impact_clear(&m, 2, plane, 1e4);
    random_unit(g, 3, n);
    for (int i = 0; i < 2; ++i) {
        m.diameter[i] = uniform(g, 0.4, 2);
        m.c.mass[i] = pow(10, uniform(g, -1.5, 1.5)) * pow(m.diameter[i], 3);
        m.c.inertia[i] = uniform(g, 0.05, 0.17) * m.c.mass[i] * m.diameter[i] * m.diameter[i];
        random_vector(g, 2, m.c.v[i]);
        random_vector(g, 4, m.c.omega[i]);
        random_vector(g, 1, m.c.x[i]);
    }
    const double length = plane ? 0.5 * m.diameter[0] : 0.5 * (m.diameter[0] + m.diameter[1]);
    for (int k = 0; k < 3; ++k) {
        m.plane[0][k] = n[k];
        m.c.x[1][k] += plane ? 40 * n[k] : 0; /* out of the way */
        m.c.x[0][k] = (plane ? 0 : m.c.x[1][k]) + length * (1 - o) * n[k];
    }
}

/** u of the contact point and w, of body 0 against body 1 or the plane, as EQUATIONS 6.2 has them, and their masses. */
static void relative(int plane, double u[3], double w[3], double masses[3])
{
    const double si = plane ? 1 : m.diameter[0] / (m.diameter[0] + m.diameter[1]), sj = 1 - si;
    double d[3], spin[3], cross[3], r = 0;
    for (int k = 0; k < 3; ++k) {
        d[k] = m.c.x[0][k] - (plane ? 0 : m.c.x[1][k]);
        spin[k] = si * m.c.omega[0][k] + (plane ? 0 : sj * m.c.omega[1][k]);
        w[k] = m.c.omega[0][k] - (plane ? 0 : m.c.omega[1][k]);
        r += d[k] * d[k];
    }
    vti_cross(spin, d, cross);
    for (int k = 0; k < 3; ++k)
        u[k] = m.c.v[0][k] - (plane ? 0 : m.c.v[1][k]) - cross[k];
    const double other = plane ? 0 : 1;
    masses[0] = 1 / (1 / m.c.mass[0] + other / m.c.mass[1]);
    masses[1] = 1 / (1 / masses[0] + r * (si * si / m.c.inertia[0] + other * sj * sj / m.c.inertia[1]));
    masses[2] = 1 / (1 / m.c.inertia[0] + other / m.c.inertia[1]);
}

/** Each of the four alone decays its own velocity by its own mass, leaves the parts that it must not touch, keeps
 *  momenta and books what went. */
TEST(each_flow)
{
    rng g = rng_seed(1403);
    for (int trial = 0; trial < 4000; ++trial) {
        const int plane = trial % 2, which = trial / 2 % 4;
        const double c = pow(10, uniform(&g, -4, 4)), t = uniform(&g, 0.01, 1), origin[3] = {0, 0, 0};
        double u[3], w[3], u1[3], w1[3], masses[3], p[3], p1[3], l[3], l1[3];
        random_touch(&g, plane, 0.01);
        vti_dashpots dashpots = {.contacts = plane ? NULL : &m.contacts,
                                 .walls = plane ? &m.walls : NULL,
                                 .pull = 1,
                                 .reach = 0,
                                 .lost = m.lost};
        double *const coefficient[] = {&dashpots.normal, &dashpots.tangential, &dashpots.rolling, &dashpots.twisting};
        *coefficient[which] = c;
        const vti_effect effect = vti_dashpots_effect(&dashpots);
        const double before = vti_energy(&effect, 1, &m.b);
        vti_momentum(&m.b, p);
        vti_angular_momentum(&m.b, origin, l);
        relative(plane, u, w, masses);
        assert_int_equal(vti_effects_flow(&effect, 1, t, 0, &m.b), VTI_OK);
        relative(plane, u1, w1, masses);
        double *const n = m.plane[0];
        const double kept = exp(-c * t / masses[which > 2 ? 2 : which]), un = vti_dot(u, n), wn = vti_dot(w, n);
        for (int k = 0; k < 3; ++k) {
            const double normal = un * n[k] * (which == 0 ? kept : 1), twist = wn * n[k] * (which == 3 ? kept : 1),
                         slide = (u[k] - un * n[k]) * (which == 1 ? kept : 1),
                         roll = (w[k] - wn * n[k]) * (which == 2 ? kept : 1);
            if (which < 2)
                assert_close(u1[k], normal + slide, 1e-12 * (1 + masses[0] / fmin(m.c.mass[0], m.c.mass[1])));
            else
                assert_close(w1[k], twist + roll, 1e-12);
        }
        const double after = vti_energy(&effect, 1, &m.b);
        assert_close(after + vti_booked(&effect, 1), before, 1e-13 * before);
        assert_true(after <= before * (1 + 4 * EPS) && effect.booked[which].high > 0);
        vti_momentum(&m.b, p1);
        vti_angular_momentum(&m.b, origin, l1);
        if (!plane) {
            assert_close3(p1, p, 1e-13 * (m.c.mass[0] + m.c.mass[1]) * 10);
            assert_close3(l1, l, 1e-13 * (m.c.mass[0] + m.c.mass[1]) * 30);
        }
    }
}

/** Constant coefficients act on the share of the drift on which bodies overlap: of one that ends or begins a quarter of
 *  the way in or out of contact, a quarter. */
TEST(share_of_the_drift)
{
    for (int which = 0; which < 8; ++which) {
        const int plane = which % 2, after = which / 2 % 2, out = which / 4;
        const double c = 3, t = 0.25, deep = out ? -0.03 : 0.01,
                     way = 0.04; /* from the overlap at one end to 1/4 or 3/4 */
        impact_clear(&m, plane ? 1 : 2, plane, 1e4);
        m.plane[0][2] = 1;
        m.c.x[0][2] = (plane ? 0.5 : 1) - deep;
        const vti_dashpots dashpots = {.contacts = plane ? NULL : &m.contacts,
                                       .walls = plane ? &m.walls : NULL,
                                       .normal = c,
                                       .pull = 1,
                                       .reach = 1,
                                       .lost = m.lost};
        const vti_effect effect = vti_dashpots_effect(&dashpots);
        const double drift = 0.5, share = 0.25;
        const double u = (deep > 0 ? 1 : -1) * (after ? -1 : 1) * way / drift; /* to the other side of the touch */
        m.c.v[0][2] = u;
        assert_int_equal(vti_effects_flow(&effect, 1, t, after ? -drift : drift, &m.b), VTI_OK);
        const double mass = plane ? 1 : 0.5, left = m.c.v[0][2] - (plane ? 0 : m.c.v[1][2]);
        assert_close(left, u * exp(-c * share * t / mass), 1e-12);
    }
}

/** Bodies that do not turn: the normal and the tangential dashpot decay the velocities of the centres, on their reduced
 *  mass. */
TEST(bodies_that_do_not_turn)
{
    rng g = rng_seed(1407);
    for (int trial = 0; trial < 400; ++trial) {
        const int plane = trial % 2;
        const double c = uniform(&g, 0, 20), t = uniform(&g, 0.01, 1);
        double u[3], along[3], p[3], p1[3];
        random_touch(&g, plane, 0.01);
        memset(m.c.omega, 0, sizeof m.c.omega);
        m.b.omega = m.b.moment = m.b.alpha = vti_view_none();
        m.b.inertia.p = NULL;
        const vti_dashpots dashpots = {.contacts = plane ? NULL : &m.contacts,
                                       .walls = plane ? &m.walls : NULL,
                                       .normal = c,
                                       .tangential = 2 * c,
                                       .pull = 1,
                                       .lost = m.lost};
        const vti_effect effect = vti_dashpots_effect(&dashpots);
        const double mass = 1 / (1 / m.c.mass[0] + (plane ? 0 : 1 / m.c.mass[1])),
                     before = vti_energy(&effect, 1, &m.b);
        for (int k = 0; k < 3; ++k)
            u[k] = m.c.v[0][k] - (plane ? 0 : m.c.v[1][k]);
        const double un = vti_dot(u, m.plane[0]);
        for (int k = 0; k < 3; ++k) {
            along[k] = un * m.plane[0][k];
            u[k] = (u[k] - along[k]) * exp(-2 * c * t / mass) + along[k] * exp(-c * t / mass);
        }
        vti_momentum(&m.b, p);
        assert_int_equal(vti_effects_flow(&effect, 1, t, 0, &m.b), VTI_OK);
        vti_momentum(&m.b, p1);
        const double small = 1e-12 * (1 + mass / fmin(m.c.mass[0], m.c.mass[1]));
        for (int k = 0; k < 3; ++k) {
            assert_close(m.c.v[0][k] - (plane ? 0 : m.c.v[1][k]), u[k], small);
            assert_close(plane ? p[k] : p1[k], p[k], 1e-12 * (m.c.mass[0] + m.c.mass[1]));
        }
        assert_close(vti_energy(&effect, 1, &m.b) + vti_booked(&effect, 1), before, 1e-13 * before);
    }
}

/** Without springs of friction a tangential dashpot is held to mu F_n, which stops what is slow; where nothing presses
 *  yet, nothing is lost across the normal; a ratio of no normal coefficient is none; centres that coincide have no
 *  direction; and a velocity that is no number shows. */
TEST(limits_of_dashpots)
{
    const double t = 0.01, mu = 0.3, limit = t * mu * 1e4 * pow(0.01, 1.5);
    vti_history nothing = {0};
    for (int which = 0; which < 4; ++which) {
        const vti_friction friction = {.sliding = mu, .history = which % 2 ? &nothing : NULL};
        const double gap = which / 2 ? 0.01 : -0.01;
        impact_clear(&m, 2, 0, 1e4);
        m.c.x[0][2] = 1 + gap;
        m.c.v[0][2] = -1;
        m.c.v[0][0] = 0.5;
        const vti_dashpots dashpots = {
            .contacts = &m.contacts, .friction = &friction, .tangential = 1e6, .reach = 1, .lost = m.lost};
        const vti_effect effect = vti_dashpots_effect(&dashpots);
        assert_int_equal(vti_effects_flow(&effect, 1, t, 0.05, &m.b), VTI_OK);
        assert_close(m.c.v[1][0], which / 2 ? 0 : limit, 1e-12);
        assert_close(m.c.v[0][0] + m.c.v[1][0], 0.5, 4 * EPS);
        assert_true((m.lost[1].high > 0) == (gap < 0));
    }
    impact_clear(&m, 2, 0, 1e4);
    m.c.v[0][0] = 1;
    m.c.x[0][2] = 0.99;
    vti_dashpots p = {.contacts = &m.contacts, .ratio = 1, .reach = 1, .lost = m.lost};
    const vti_effect effect = vti_dashpots_effect(&p);
    assert_int_equal(vti_effects_flow(&effect, 1, t, 0, &m.b), VTI_OK);
    p.normal = p.zeta = 1;
    m.c.x[0][2] = 0;
    assert_int_equal(vti_effects_flow(&effect, 1, t, 0, &m.b), VTI_OK);
    assert_true(m.c.v[0][0] == 1 && m.lost[0].high == 0 && m.lost[1].high == 0);
    m.c.x[0][2] = 1.01;
    m.c.v[0][2] = NAN;
    assert_int_equal(vti_effects_flow(&effect, 1, t, 1, &m.b), VTI_OK);
    assert_true(isnan(m.c.v[0][2]) && isnan(m.lost[0].high));
}

/** The impulse of one flow on body 0: of sliding, or the moment impulse of rolling. */
static void impulse_of(const impact *start, const vti_dashpots *dashpots, int rolls, double t, double p[3])
{
    const vti_effect effect = vti_dashpots_effect(dashpots);
    memcpy(&m.c, &start->c, sizeof m.c);
    memset(m.lost, 0, sizeof m.lost);
    const double energy = vti_energy(NULL, 0, &m.b);
    assert_int_equal(vti_effects_flow(&effect, 1, t, 0, &m.b), VTI_OK);
    for (int k = 0; k < 3; ++k)
        p[k] = rolls ? m.c.inertia[0] * (m.c.omega[0][k] - start->c.omega[0][k])
                     : m.c.mass[0] * (m.c.v[0][k] - start->c.v[0][k]);
    const double left = vti_energy(NULL, 0, &m.b);
    assert_true(left <= energy * (1 + 4 * EPS));
    assert_close(left + vti_booked(&effect, 1), energy, 100 * EPS * energy);
}

/** Beside a spring that holds f, at the limit or below, the flow's impulse is the whole one, p, moved so that p - t f
 *  is the nearest place within t mu F_n; it never gains, whichever way f points. */
TEST(limits_beside_springs)
{
    static impact start;
    rng g = rng_seed(1406);
    int limited = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const int plane = trial % 2, rolls = trial / 2 % 2, full = trial / 4 % 2;
        const double t = pow(10, uniform(&g, -3, 0)), mu = 0.3, o = 0.01;
        double p[3], whole[3], load[3];
        random_touch(&g, plane, o);
        const double length = plane ? 0.5 * m.diameter[0] : 0.5 * (m.diameter[0] + m.diameter[1]),
                     limit = mu * 1e4 / length * pow(o, 1.5);
        random_vector(&g, 1, load);
        const double along = vti_dot(load, m.plane[0]);
        for (int k = 0; k < 3; ++k)
            load[k] -= along * m.plane[0][k];
        const double factor = limit * (full ? 1 : uniform(&g, 0, 1)) / vti_norm(load);
        vti_held slots[4] = {{0}}, held = {1, plane ? -1 : 2, {0}, {0}, 0};
        vti_history history = {4, 0, 0, slots};
        for (int k = 0; k < 3; ++k)
            (rolls ? held.rolling : held.sliding)[k] = load[k] *= factor;
        assert_int_equal(vti_history_add(&history, &held), VTI_OK);
        const vti_friction friction = {.sliding = mu, .rolling = mu, .history = &history};
        vti_dashpots dashpots = {
            .contacts = plane ? NULL : &m.contacts, .walls = plane ? &m.walls : NULL, .reach = 0, .lost = m.lost};
        *(rolls ? &dashpots.rolling : &dashpots.tangential) = pow(10, uniform(&g, -1, 3));
        memcpy(&start.c, &m.c, sizeof m.c);
        impulse_of(&start, &dashpots, rolls, t, whole);
        dashpots.friction = &friction;
        impulse_of(&start, &dashpots, rolls, t, p);
        long double size = 0;
        for (int k = 0; k < 3; ++k)
            size += powl((long double)whole[k] - (long double)t * load[k], 2);
        size = sqrtl(size);
        const double per = rolls ? m.c.inertia[0] : m.c.mass[0], speed = rolls ? 8 : 4;
        for (int k = 0; k < 3; ++k) { /* an overlap of 0.01 is known to some 100 eps, p by a difference of velocities */
            const long double nearest =
                size > t * limit ? t * load[k] + (whole[k] - t * load[k]) * (t * limit / size) : whole[k];
            assert_close(p[k], (double)nearest, EPS * (1000 * t * limit + 100 * per * speed));
        }
        limited += size > t * limit;
    }
    print_message("%d of 2000 are limited\n", limited);
    assert_in_range(limited, 500, 1900);
}

/* ---- impacts ----------------------------------------------------------------------------------------------------- */

/** T + U + what is lost after an oblique impact at so many degrees, against before. */
static double ledger_error(double degrees, int plane, int steps)
{
    rng g = rng_seed(1404);
    random_touch(&g, plane, -0.01);
    memset(m.c.v, 0, sizeof m.c.v);
    const double a = degrees * PI / 180, side[3] = {m.plane[0][1], -m.plane[0][0], 0}, s = vti_norm(side);
    for (int k = 0; k < 3; ++k)
        m.c.v[0][k] = -cos(a) * m.plane[0][k] + sin(a) * side[k] / s;
    const vti_dashpots dashpots = {.contacts = plane ? NULL : &m.contacts,
                                   .walls = plane ? &m.walls : NULL,
                                   .zeta = 0.2,
                                   .ratio = 0.5,
                                   .rolling = 0.2,
                                   .twisting = 0.1,
                                   .reach = INFINITY,
                                   .lost = m.lost};
    impact_add(&m, plane ? vti_walls_effect(&m.walls) : vti_contacts_effect(&m.contacts));
    impact_add(&m, vti_dashpots_effect(&dashpots));
    const double before = impact_ledger(&m);
    impact_go(&m, vti2(), 0.4 / steps, steps);
    double energy;
    m.effects[0].energy(m.effects[0].self, &m.b, &energy);
    assert_true(energy == 0 && m.lost[0].high > 0 && m.lost[1].high > 0 && m.lost[2].high > 0 && m.lost[3].high > 0);
    return fabs(impact_ledger(&m) - before) / before;
}

TEST(ledger)
{
    static const double angles[] = {10, 45, 76};
    for (int k = 0; k < 3; ++k)
        for (int plane = 0; plane < 2; ++plane) {
            double error[5];
            for (int level = 0; level < 5; ++level)
                error[level] = ledger_error(angles[k], plane, 2000 << level);
            print_message("%.0f degrees, %s: %.1e to %.1e, order %.2f\n", angles[k], plane ? "plane" : "pair", error[0],
                          error[4], log2(error[0] / error[4]) / 4);
            assert_below(error[0], 1e-3);
            assert_below(1.7, log2(error[0] / error[4]) / 4);
        }
}

/** Random impacts in a corner of three planes at up to half of the stable step: the energy is never above what the same
 *  impact gains without dashpots. */
TEST(random_impacts_never_gain)
{
    rng g = rng_seed(1405);
    const int impacts = 2000;
    int parted = 0;
    double most = 0;
    for (int trial = 0; trial < impacts; ++trial) {
        const int plane = trial % 2;
        double energy[2];
        const double zeta = uniform(&g, 0, 1.5), ratio = uniform(&g, 0, 2), share = trial / 2 % 2 ? 0.25 : 0.5;
        const rng start = g;
        for (int damped = 0; damped < 2; ++damped) {
            double u[3], w[3], masses[3];
            g = start;
            random_touch(&g, plane, -0.02);
            relative(plane, u, w, masses);
            const double length = plane ? 0.5 * m.diameter[0] : 0.5 * (m.diameter[0] + m.diameter[1]);
            const double speed = fabs(vti_dot(u, m.plane[0])) + 0.1, k_h = 1e4 / pow(length, 2.5);
            const double h = share * impact_stable(masses[0], k_h, speed),
                         lasts = 6 * impact_duration(masses[0], k_h, speed) + 0.04 * length / speed;
            for (int k = 0; k < 3; ++k) /* towards each other */
                m.c.v[0][k] -= (vti_dot(u, m.plane[0]) + speed) * m.plane[0][k];
            const vti_dashpots dashpots = {.contacts = plane ? NULL : &m.contacts,
                                           .walls = plane ? &m.walls : NULL,
                                           .zeta = damped ? zeta : 0,
                                           .ratio = damped ? ratio : 0,
                                           .rolling = damped ? zeta : 0,
                                           .twisting = damped ? zeta : 0,
                                           .reach = INFINITY,
                                           .lost = m.lost};
            impact_add(&m, plane ? vti_walls_effect(&m.walls) : vti_contacts_effect(&m.contacts));
            impact_add(&m, vti_dashpots_effect(&dashpots));
            const double before = vti_energy(m.effects, 2, &m.b);
            impact_go(&m, vti2(), h, llrint(lasts / h));
            energy[damped] = vti_energy(m.effects, 2, &m.b) / before - 1;
        }
        most = fmax(most, energy[1]);
        parted += energy[1] < -1e-6;
        assert_below(energy[1], fmax(energy[0], 0) + 1e-12);
    }
    print_message("largest gain %.1e; %d of %d impacts lose energy\n", most, parted, impacts);
    assert_true(parted > impacts * 9 / 10);
}

/* ---- many -------------------------------------------------------------------------------------------------------- */

/** A dense crowd: velocities after the flow of t = 1, forwards and backwards by so many halves. */
static void crowd_flow(int halves, double v[40][3])
{
    rng g = rng_seed(1406);
    const double origin[3] = {0, 0, 0};
    double p[3], p1[3], l[3], l1[3];
    const int n = 20;
    impact_clear(&m, n, 1, 1e4);
    crowd_scatter(&m.c, &g, 1, 0.6);
    m.plane[0][2] = 1;
    m.plane[0][3] = -100;
    for (int i = 0; i < n; ++i) {
        random_vector(&g, 1, m.c.v[i]);
        random_vector(&g, 1, m.c.omega[i]);
    }
    const vti_dashpots dashpots = {.contacts = &m.contacts,
                                   .walls = &m.walls,
                                   .normal = 1,
                                   .tangential = 0.5,
                                   .rolling = 0.05,
                                   .twisting = 0.02,
                                   .pull = 1,
                                   .lost = m.lost};
    impact_add(&m, vti_dashpots_effect(&dashpots));
    vti_momentum(&m.b, p);
    vti_angular_momentum(&m.b, origin, l);
    double last = vti_energy(m.effects, 1, &m.b);
    for (int k = 0; k < 2 * halves; ++k) {
        assert_int_equal(vti_effects_flow(m.effects, 1, 0.5 / halves, k % 2 ? -1e-30 : 1e-30, &m.b), VTI_OK);
        const double now = vti_energy(m.effects, 1, &m.b);
        assert_true(now < last);
        last = now;
    }
    vti_momentum(&m.b, p1);
    vti_angular_momentum(&m.b, origin, l1);
    assert_close3(p1, p, 256 * EPS);
    assert_close3(l1, l, 1024 * EPS);
    for (int i = 0; i < n; ++i) {
        memcpy(v[i], m.c.v[i], sizeof v[i]);
        memcpy(v[n + i], m.c.omega[i], sizeof v[i]);
    }
}

/** Forward and backward together are of second order in t, and every flow contracts. */
TEST(crowds)
{
    double fine[40][3], v[40][3], error[3] = {0};
    crowd_flow(256, fine);
    for (int level = 0; level < 3; ++level) {
        crowd_flow(4 << level, v);
        for (int i = 0; i < 40; ++i)
            for (int k = 0; k < 3; ++k)
                error[level] = fmax(error[level], fabs(v[i][k] - fine[i][k]));
    }
    print_message("4, 8, 16 flows: %.1e %.1e %.1e\n", error[0], error[1], error[2]);
    assert_close(log2(error[1] / error[2]), 2, 0.2);
}

RUN_TESTS(cmocka_unit_test(zeta_of_restitution), cmocka_unit_test(restitution), cmocka_unit_test(each_flow),
          cmocka_unit_test(share_of_the_drift), cmocka_unit_test(bodies_that_do_not_turn),
          cmocka_unit_test(limits_of_dashpots), cmocka_unit_test(limits_beside_springs), cmocka_unit_test(ledger),
          cmocka_unit_test(random_impacts_never_gain), cmocka_unit_test(crowds))
