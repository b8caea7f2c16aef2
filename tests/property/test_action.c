/* SPDX-License-Identifier: BSD-3-Clause
 *
 * VTI-1, VTI-2 and VTI-3 are variational, each with a discrete Lagrangian of its own (E14, E15): on the trajectories
 * that they compute the discrete action, the sum of L_d over the steps, is stationary under every variation of interior
 * positions and attitudes, and its derivatives by the ends are minus the momenta at the start and the momenta at the
 * end. With dR R^T = S(eta) on the left, U the potential and K(a) the kinetic part of a turn by a = dalpha,
 *
 *     L_d = sum m |dx|^2/(2h) + sum K(dalpha) - h U-part:
 *     VTI-1   K = 2 J |a|^2/((4 + |a|^2) h)      U-part (U_k + U_{k+1})/2
 *     VTI-2   K = (2J/h) ln(1 + |a|^2/4)         U-part (U_k + U_{k+1})/2
 *     VTI-3   K = (2J/h) ln(1 + |a|^2/4)         U-part U_k
 *
 * Energies are written down here once more, in long double, from EQUATIONS 3 and not from the library. */
#include "chain.h"
#include "rig.h"

enum { BODIES = 2, STEPS = 128, COORDINATES = 6 }; /* of each body: x, then the left variation of the attitude */

struct node {
    long double x[BODIES][3];
    rotor q[BODIES];
};

/** A computed trajectory, and what its bodies are. momenta: at the start and at the end, in the order of the
 *  coordinates. */
struct path {
    int bodies;
    double h, mass[BODIES], inertia[BODIES], momenta[2][BODIES][COORDINATES];
    struct node node[STEPS + 1];
    long double (*potential)(const struct path *p, const struct node *at);
    rig pendulum;
    chain pair;
};

/* ---- energies ---------------------------------------------------------------------------------------------------- */

static void turned(rotor q, const double p[3], long double r[3])
{
    const rotor v = {p[0], p[1], p[2], 0}, t = quat_times(quat_times(q, v), quat_conj(q));
    r[0] = t.x, r[1] = t.y, r[2] = t.z;
}

static long double dot(const long double a[3], const long double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** -m g e3 . R rho0 */
static long double pendulum_energy(const struct path *p, const struct node *at)
{
    long double arm[3];
    turned(at->q[0], p->pendulum.pendulum.rho0, arm);
    return -p->pendulum.pendulum.weight * arm[2];
}

/** K^m/2 |theta|^2 + K^a/2 (r/L0 - 1)^2 + K^s (1 - n . (b_0 + b_1)/|b_0 + b_1|) */
static long double pair_energy(const struct path *p, const struct node *at)
{
    const double *k = p->pair.stiffness, *n0 = p->pair.rest[0];
    const rotor q = quat_times(at->q[0], quat_conj(at->q[1]));
    const long double theta = 2 * atan2l(sqrtl(q.x * q.x + q.y * q.y + q.z * q.z), fabsl(q.w));
    long double d[3], b[2][3], m[3];
    turned(at->q[0], n0, b[0]);
    turned(at->q[1], n0, b[1]);
    for (int c = 0; c < 3; ++c) {
        d[c] = at->x[0][c] - at->x[1][c];
        m[c] = b[0][c] + b[1][c];
    }
    const long double r = sqrtl(dot(d, d)), stretch = r / n0[3] - 1, cosine = dot(m, d) / (r * sqrtl(dot(m, m)));
    return k[0] * theta * theta / 2 + k[1] * stretch * stretch / 2 + k[2] * (1 - cosine);
}

/* ---- discrete Lagrangians ---------------------------------------------------------------------------------------- */

/** The kinetic part of a turn with |dalpha|^2 = a2, times h/J, and how much of the potential belongs to the step's
 *  start. */
struct lagrangian {
    const char *stepper;
    long double (*turn)(long double a2);
    long double start;
};

static long double closed_form(long double a2)
{
    return 2 * a2 / (4 + a2);
}

static long double cayley(long double a2)
{
    return 2 * log1pl(a2 / 4);
}

static const struct lagrangian lagrangians[] = {
    {"vti1", closed_form, 0.5L}, {"vti2", cayley, 0.5L}, {"vti3", cayley, 1.0L}};
enum { LAGRANGIANS = sizeof lagrangians / sizeof lagrangians[0] };

static long double step_action(const struct path *p, const struct lagrangian *l, const struct node *a,
                               const struct node *b)
{
    const long double h = p->h;
    long double sum = -h * (l->start * p->potential(p, a) + (1 - l->start) * p->potential(p, b));
    for (int i = 0; i < p->bodies; ++i) {
        const rotor dq = quat_times(b->q[i], quat_conj(a->q[i]));
        const long double a2 = 4 * (dq.x * dq.x + dq.y * dq.y + dq.z * dq.z) / (dq.w * dq.w);
        const long double dx[3] = {b->x[i][0] - a->x[i][0], b->x[i][1] - a->x[i][1], b->x[i][2] - a->x[i][2]};
        sum += (p->mass[i] * dot(dx, dx) / 2 + p->inertia[i] * l->turn(a2)) / h;
    }
    return sum;
}

/** The terms of the action that node k is part of, with its coordinate c of body i moved by e. */
static long double action(const struct path *p, const struct lagrangian *l, int k, int i, int c, long double e)
{
    struct node moved = p->node[k];
    const double axis[3] = {c == 3, c == 4, c == 5};
    if (c < 3)
        moved.x[i][c] += e;
    else
        moved.q[i] = quat_times(quat_turn(axis, e), moved.q[i]);
    return (k > 0 ? step_action(p, l, &p->node[k - 1], &moved) : 0) +
           (k < STEPS ? step_action(p, l, &moved, &p->node[k + 1]) : 0);
}

/** d action/d coordinate, to e^4. */
static long double slope(const struct path *p, const struct lagrangian *l, int k, int i, int c)
{
    const long double e = 1e-4L;
    return (8 * (action(p, l, k, i, c, e) - action(p, l, k, i, c, -e)) -
            (action(p, l, k, i, c, 2 * e) - action(p, l, k, i, c, -2 * e))) /
           (12 * e);
}

/** The largest derivative of the action that should be 0, and of the ends' that should be a momentum. */
static void defects(const struct path *p, const struct lagrangian *l, double *inside, double *ends)
{
    *inside = *ends = 0;
    for (int k = 0; k <= STEPS; ++k)
        for (int i = 0; i < p->bodies; ++i)
            for (int c = p->potential == pendulum_energy ? 3 : 0; c < COORDINATES; ++c) {
                const double s = (double)slope(p, l, k, i, c);
                if (k == 0)
                    *ends = fmax(*ends, fabs(s + p->momenta[0][i][c]));
                else if (k == STEPS)
                    *ends = fmax(*ends, fabs(s - p->momenta[1][i][c]));
                else
                    *inside = fmax(*inside, fabs(s));
            }
}

/* ---- trajectories ------------------------------------------------------------------------------------------------ */

static void pendulum_node(struct path *p, int k)
{
    p->node[k].q[0] = rig_attitude(&p->pendulum);
    for (int c = 0; c < 3; ++c)
        p->momenta[k > 0][0][3 + c] = p->pendulum.inertia * p->pendulum.omega[c];
}

static void pendulum_path(struct path *p, rng *g, const vti_stepper *method)
{
    p->bodies = 1;
    p->potential = pendulum_energy;
    p->pendulum = rig_random(g, RIG_ALPHA);
    p->inertia[0] = p->pendulum.inertia;
    pendulum_node(p, 0);
    for (int k = 1; k <= STEPS; ++k) {
        rig_run(&p->pendulum, method, p->h, 1);
        pendulum_node(p, k);
    }
}

static void pair_node(struct path *p, int k)
{
    const chain *c = &p->pair;
    for (int i = 0; i < BODIES; ++i) {
        p->node[k].q[i] = chain_attitude(c, i);
        for (int m = 0; m < 3; ++m) {
            p->node[k].x[i][m] = c->x[i][m];
            p->momenta[k > 0][i][m] = c->mass[i] * c->v[i][m];
            p->momenta[k > 0][i][3 + m] = c->inertia[i] * c->omega[i][m];
        }
    }
}

static void pair_path(struct path *p, rng *g, const vti_stepper *method)
{
    p->bodies = BODIES;
    p->potential = pair_energy;
    chain_make(&p->pair, BODIES, rng_bits(g), CHAIN_QUAT);
    memcpy(p->mass, p->pair.mass, sizeof p->mass);
    memcpy(p->inertia, p->pair.inertia, sizeof p->inertia);
    pair_node(p, 0);
    for (int k = 1; k <= STEPS; ++k) {
        chain_run(&p->pair, method, p->h, 1);
        pair_node(p, k);
    }
}

/* ---- the test ---------------------------------------------------------------------------------------------------- */

/** Every stepper against every Lagrangian: its own is stationary and has its momenta; that of another turn is not
 *  stationary, and that of another share of the potential has other momenta. A slope is a difference of momenta of two
 *  steps, each (J/h or m/h, at most 2/h) times what two attitudes or positions differ by, which are rounded by some
 *  eps. */
static void own_action_is_stationary(void (*make)(struct path *, rng *, const vti_stepper *), uint64_t seed)
{
    static struct path p;
    const double steps[] = {1.0 / 16, 1.0 / 64};
    rng g = rng_seed(seed);
    for (int trial = 0; trial < 12; ++trial)
        for (int s = 0; s < LAGRANGIANS; ++s) {
            p.h = steps[trial % 2];
            const double rounding = 12 * EPS * 2 / p.h;
            make(&p, &g, vti_stepper_find(lagrangians[s].stepper));
            for (int l = 0; l < LAGRANGIANS; ++l) {
                double inside, ends;
                defects(&p, &lagrangians[l], &inside, &ends);
                if (lagrangians[l].turn == lagrangians[s].turn)
                    assert_below(inside, rounding);
                else
                    assert_true(inside > 1e4 * rounding);
                if (l == s)
                    assert_below(ends, rounding);
                else
                    assert_true(ends > 1e4 * rounding);
            }
        }
}

TEST(pendulum)
{
    own_action_is_stationary(pendulum_path, 251);
}

TEST(bonded_pair)
{
    own_action_is_stationary(pair_path, 252);
}

RUN_TESTS(cmocka_unit_test(pendulum), cmocka_unit_test(bonded_pair))
