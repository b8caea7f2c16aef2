/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The ledger of dissipating motions by the library, of second order in h, and beside it as most codes step and
 * book them (usual.h), of first. */
#include "usual.h"

enum { SLOTS = 1024, LEVELS = 4 };

static const double mu = 0.3, stiffness = 1500, zeta = 0.1, ratio = 0.5;

static impact m;
static usual u;
static vti_held entries[SLOTS];
static int64_t slots[SLOTS];
static vti_history history;
static vti_sum rubbed[VTI_FRICTION_BOOKS];
static vti_friction friction;
static vti_dashpots dashpots;
static vti_gravity gravity;

static web w;
static int64_t id[WEB_MAX];
static vti_sum broken;
static vti_rupture rupture;

/** Both on the bodies of m: what touches, friction, dashpots and gravity. */
static void act(int walls, double g)
{
    memset(slots, 0, sizeof slots);
    memset(rubbed, 0, sizeof rubbed);
    history = (vti_history){SLOTS, 0, 0, entries, slots};
    gravity = (vti_gravity){{0, 0, -g}};
    friction = (vti_friction){.contacts = &m.contacts,
                              .walls = walls ? &m.walls : NULL,
                              .sliding = mu,
                              .stiffness = stiffness,
                              .reach = INFINITY,
                              .history = &history,
                              .lost = rubbed};
    dashpots = (vti_dashpots){.contacts = &m.contacts,
                              .walls = friction.walls,
                              .friction = &friction,
                              .zeta = zeta,
                              .ratio = ratio,
                              .reach = INFINITY,
                              .lost = m.lost};
    impact_add(&m, vti_contacts_effect(&m.contacts));
    impact_add(&m, vti_gravity_effect(&gravity));
    if (walls)
        impact_add(&m, vti_walls_effect(&m.walls));
    impact_add(&m, vti_friction_effect(&friction));
    impact_add(&m, vti_dashpots_effect(&dashpots));
    memset(&u, 0, sizeof u);
    u.m = &m;
    u.mu = mu;
    u.stiffness = stiffness;
    u.zeta = zeta;
    u.ratio = ratio;
    u.g[2] = -g;
}

/** By how much the sum has changed after so many steps, as a share of what there was. */
static double change(int usually, double time, int steps)
{
    const double before = impact_ledger(&m);
    if (!usually) {
        impact_go(&m, vti_stepper_find("vti2"), time / steps, steps);
        return fabs(impact_ledger(&m) - before) / before;
    }
    usual_go(&u, time / steps, steps);
    return fabs(impact_ledger(&m) + u.lost - before) / before; /* the library's springs have not moved */
}

static double order(const double *error)
{
    return log2(error[0] / error[LEVELS - 1]) / (LEVELS - 1);
}

static void judge(const char *what, double error[2][LEVELS])
{
    const double ours = order(error[0]), theirs = order(error[1]);
    print_message("%s: ledger %.1e to %.1e, order %.2f; as usual %.1e to %.1e, order %.2f\n", what, error[0][0],
                  error[0][LEVELS - 1], ours, error[1][0], error[1][LEVELS - 1], theirs);
    assert_below(1.7, ours);
    assert_below(theirs, 1.3);
    assert_below(20 * error[0][LEVELS - 1], error[1][LEVELS - 1]);
}

/** An impact of two unequal spheres, or of one on a plane, at 10, 45 and 76 degrees. */
TEST(impacts)
{
    static const double angles[] = {10, 45, 76};
    for (int which = 0; which < 6; ++which) {
        const int plane = which % 2;
        const double a = angles[which / 2] * PI / 180;
        double error[2][LEVELS] = {{0}};
        char what[40];
        for (int start = 0; start < 4; ++start)
            for (int usually = 0; usually < 2; ++usually)
                for (int level = 0; level < LEVELS; ++level) {
                    impact_clear(&m, 2, plane, 2e4);
                    m.plane[0][2] = 1;
                    m.c.mass[0] = 2;
                    m.c.inertia[0] = 0.3;
                    m.diameter[0] = 1.25;
                    m.c.x[1][2] = plane ? 50 : 0;
                    m.c.x[0][2] = (plane ? 0.625 : 1.125) + 0.01 + 1.1e-4 * start;
                    m.c.v[0][0] = sin(a);
                    m.c.v[0][2] = -cos(a);
                    m.c.omega[0][1] = 0.4;
                    act(plane, 0);
                    error[usually][level] += change(usually, 0.2, 512 << level) / 4;
                }
        snprintf(what, sizeof what, "%.0f degrees, %s", angles[which / 2], plane ? "plane" : "pair");
        judge(what, error);
    }
}

/** Twelve spheres piled up beside each other slump on a plane. */
TEST(column)
{
    enum { WIDE = 3, HIGH = 4 };
    double error[2][LEVELS];
    for (int usually = 0; usually < 2; ++usually)
        for (int level = 0; level < LEVELS; ++level) {
            rng g = rng_seed(1471);
            impact_clear(&m, WIDE * HIGH, 1, 2e4);
            m.plane[0][2] = 1;
            for (int i = 0; i < WIDE * HIGH; ++i) {
                m.diameter[i] = uniform(&g, 0.9, 1);
                m.c.x[i][0] = i % WIDE + 0.3 * (i / WIDE % 2);
                m.c.x[i][2] = 0.5 + 0.95 * (i / WIDE);
                m.c.v[i][0] = uniform(&g, -1, 1);
            }
            act(1, 9.81);
            error[usually][level] = change(usually, 0.5, 512 << level);
        }
    judge("column", error);
}

/** Bonds of all pairs nearer than `reach`, at rest, that break by what normal, shear and moments bear together. */
static void bind(double reach)
{
    static const double force = 40, moment = 5;
    int64_t count = 0;
    memset(&w, 0, sizeof w);
    memset(&broken, 0, sizeof broken);
    for (int64_t p = 0; p < m.contacts.count; ++p) {
        double d[3];
        for (int k = 0; k < 3; ++k)
            d[k] = m.c.x[m.pair[p][0]][k] - m.c.x[m.pair[p][1]][k];
        if (vti_norm(d) > reach)
            continue;
        memcpy(w.pair[count], m.pair[p], sizeof w.pair[count]);
        w.axial[count] = 2000;
        w.shear[count] = 800;
        w.moment[count] = 100;
        id[count] = count;
        ++count;
    }
    assert_int_equal(vti_bonds_rest(count, w.pair[0], 0, &m.b.x, w.rest[0], NULL), VTI_OK);
    web_terms(&w, count, MOMENT | AXIAL | SHEAR, VTI_SHEAR_OBJECTIVE);
    rupture = (vti_rupture){.bonds = &w.bonds,
                            .id = id,
                            .normal = vti_scalars_one(&force),
                            .shear = vti_scalars_one(&force),
                            .bending = vti_scalars_one(&moment),
                            .torsion = vti_scalars_one(&moment),
                            .lost = &broken};
    impact_add(&m, vti_bonds_effect(&w.bonds));
    impact_add(&m, vti_rupture_effect(&rupture));
    u.bonds[0] = vti_bonds_effect(&w.bonds);
    u.bonds[1] = vti_rupture_effect(&rupture);
    u.bonds_count = 2;
}

/** Eighteen bonded spheres strike a plane on a corner, and some of their bonds break. */
TEST(agglomerate)
{
    enum { WIDE = 3, HIGH = 2, ALL = WIDE * WIDE * HIGH };
    double error[2][LEVELS];
    for (int usually = 0; usually < 2; ++usually)
        for (int level = 0; level < LEVELS; ++level) {
            const double n[3] = {0.36, 0.48, 0.8};
            impact_clear(&m, ALL, 1, 2e4);
            memcpy(m.plane[0], n, sizeof n);
            m.plane[0][3] = -0.52;
            for (int i = 0; i < ALL; ++i) {
                const int at[3] = {i % WIDE, i / WIDE % WIDE, i / (WIDE * WIDE)};
                for (int k = 0; k < 3; ++k) {
                    m.c.x[i][k] = at[k];
                    m.c.v[i][k] = -n[k];
                }
            }
            act(1, 0);
            bind(1.1);
            const int64_t bonds = w.bonds.count;
            error[usually][level] = change(usually, 1.0, 512 << level);
            assert_in_range(w.bonds.count, bonds / 3, 5 * bonds / 6); /* 20 or 21 of 33 */
        }
    judge("agglomerate", error);
}

RUN_TESTS(cmocka_unit_test(impacts), cmocka_unit_test(column), cmocka_unit_test(agglomerate))
