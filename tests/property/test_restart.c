/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What docs/linking.md says of a restart: positions, velocities, attitudes, spins and what these leave out, as they are
 * between two steps, are the whole state of a run. Nothing else is kept: forces are computed anew, velocities that lag
 * stay so. */
#include "support.h"

enum { N = 5, BONDS = N - 1, STEPS = 24 };

struct state {
    double x[N][3], v[N][3], alpha[N][3], omega[N][3], x_low[N][3], v_low[N][3], alpha_low[N][3], omega_low[N][3];
};
struct run {
    struct state state;
    double force[N][3], moment[N][3], mass[N], inertia[N];
};

static int64_t pair[BONDS][2];
static double rest[BONDS][4];
static const double stiffness[3] = {10.0, 200.0, 200.0};
static vti_effect binder;

static vti_bodies view(struct run *r, int low)
{
    vti_bodies b = vti_bodies_none(N);
    struct state *s = &r->state;
    b.x = vti_view_packed(s->x[0]);
    b.v = vti_view_packed(s->v[0]);
    b.alpha = vti_view_packed(s->alpha[0]);
    b.omega = vti_view_packed(s->omega[0]);
    b.force = vti_view_packed(r->force[0]);
    b.moment = vti_view_packed(r->moment[0]);
    b.mass = vti_scalars_array(r->mass);
    b.inertia = vti_scalars_array(r->inertia);
    if (low) {
        b.x_low = vti_view_packed(s->x_low[0]);
        b.v_low = vti_view_packed(s->v_low[0]);
        b.alpha_low = vti_view_packed(s->alpha_low[0]);
        b.omega_low = vti_view_packed(s->omega_low[0]);
    }
    return b;
}

/** All but the state: as a program has it that has just been started. */
static void fresh(struct run *r)
{
    memset(r, 0, sizeof *r);
    for (int i = 0; i < N; ++i) {
        r->mass[i] = 1.0 + 0.1 * i;
        r->inertia[i] = 0.1 + 0.02 * i;
        for (int c = 0; c < 3; ++c)
            r->force[i][c] = r->moment[i][c] = 1e3; /* of no time */
    }
}

static void at_zero(struct run *r)
{
    fresh(r);
    for (int i = 0; i < N; ++i) {
        r->state.x[i][0] = i;
        for (int c = 0; c < 3; ++c) {
            r->state.v[i][c] = 0.1 * sin(3 * i + c);
            r->state.alpha[i][c] = 0.1 * cos(7 * i + c);
            r->state.omega[i][c] = 0.4 * cos(5 * i + c);
        }
    }
}

/** Where forces of kick k are taken: at a probe's place or where the bodies are. */
static void forces(const vti_stepper *method, int64_t k, double h, const vti_bodies *b)
{
    struct run other;
    assert_int_equal(vti_apply(&binder, 1, b), VTI_OK);
    if (method->probe == NULL || method->probe[k] == 0.0)
        return;
    fresh(&other);
    vti_bodies probed = view(&other, 0);
    probed.force = b->force;
    probed.moment = b->moment;
    assert_int_equal(vti_step_probe(method, k, h, b, &probed), VTI_OK);
    assert_int_equal(vti_apply(&binder, 1, &probed), VTI_OK);
}

static void march(const vti_stepper *method, double h, int steps, const vti_bodies *b)
{
    for (int n = 0; n < steps; ++n) {
        assert_int_equal(vti_step_begin(method, h, b, NULL), VTI_OK);
        for (int64_t k = 1; k < method->stages; ++k) {
            forces(method, k, h, b);
            assert_int_equal(vti_step_stage(method, k, h, b, NULL), VTI_OK);
        }
        forces(method, method->stages, h, b);
        assert_int_equal(vti_step_finish(method, h, b), VTI_OK);
    }
}

/** The state at the end of STEPS steps, of which the last are taken by a program started anew. */
static struct state at_end(const vti_stepper *method, int low, int later)
{
    const double h = 1.0 / 256.0;
    struct run first, second;
    at_zero(&first);
    vti_bodies b = view(&first, low);
    forces(method, 0, h, &b);
    assert_int_equal(vti_step_start(method, h, &b), VTI_OK);
    march(method, h, STEPS - later, &b);
    if (later == 0)
        return first.state;
    fresh(&second);
    second.state = first.state; /* the file */
    b = view(&second, low);
    forces(method, 0, h, &b);
    march(method, h, later, &b);
    return second.state;
}

static void goes_on_with_the_same_bits(void **state)
{
    (void)state;
    struct run rest_at;
    fresh(&rest_at);
    for (int i = 0; i < N; ++i)
        rest_at.state.x[i][0] = i;
    for (int k = 0; k < BONDS; ++k)
        pair[k][0] = k, pair[k][1] = k + 1;
    const vti_view x = vti_view_packed(rest_at.state.x[0]);
    assert_int_equal(vti_bonds_rest(BONDS, pair[0], 0, &x, rest[0], NULL), VTI_OK);
    const vti_bonds bonds = {.count = BONDS,
                             .pair = pair[0],
                             .rest = rest[0],
                             .moment = vti_scalars_one(&stiffness[0]),
                             .axial = vti_scalars_one(&stiffness[1]),
                             .shear = vti_scalars_one(&stiffness[2]),
                             .shear_form = VTI_SHEAR_OBJECTIVE};
    binder = vti_bonds_effect(&bonds);

    for (int64_t k = 0; k < vti_stepper_count(); ++k)
        for (int low = 0; low < 2; ++low) {
            const vti_stepper *method = vti_stepper_at(k);
            const struct state whole = at_end(method, low, 0);
            for (int later = 1; later < STEPS; later += 11) {
                const struct state parts = at_end(method, low, later);
                if (memcmp(&whole, &parts, sizeof whole) != 0)
                    fail_msg("%s, %s low views: other bits with %d steps after a restart", method->name,
                             low ? "with" : "without", later);
            }
        }
}

RUN_TESTS(cmocka_unit_test(goes_on_with_the_same_bits))
