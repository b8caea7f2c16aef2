/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Steps with effects that flow, carry and rupture: by a host's own effects of which closed forms are known, and by one
 * that writes down when it is called. */
#include "support.h"

enum { N = 3, MOST = 64 };

static double x[N][3], v[N][3], force[N][3], alpha[N][3], omega[N][3], moment[N][3];
static const double mass[N] = {1.0, 2.0, 0.5}, inertia[N] = {0.4, 1.0, 0.1};
static vti_bodies b;

static int bodies(void **state)
{
    (void)state;
    for (int i = 0; i < N; ++i)
        for (int k = 0; k < 3; ++k) {
            x[i][k] = 0.3 * (i + 1) - 0.2 * k;
            v[i][k] = 0.5 - 0.25 * i + 0.125 * k;
            omega[i][k] = 0.1 * (i - k);
            alpha[i][k] = force[i][k] = moment[i][k] = 0.0;
        }
    b = vti_bodies_none(N);
    b.x = vti_view_packed(x[0]);
    b.v = vti_view_packed(v[0]);
    b.force = vti_view_packed(force[0]);
    b.mass = vti_scalars_array(mass);
    b.alpha = vti_view_packed(alpha[0]);
    b.omega = vti_view_packed(omega[0]);
    b.moment = vti_view_packed(moment[0]);
    b.inertia = vti_scalars_array(inertia);
    return 0;
}

/* ---- drag, F = -c v, as a flow: v <- v exp(-c t/m) --------------------------------------------------------------- */

struct drag {
    double c;
    vti_sum *lost;
};

static void drag_flow(const void *self, const vti_bodies *some, double t, double drift)
{
    const struct drag *d = self;
    (void)drift;
    for (int64_t i = some->first; i < some->first + some->count; ++i)
        for (int k = 0; k < 3; ++k) {
            double *const p = some->v.c[k] + i * some->v.stride;
            const double m = mass[i], before = *p;
            *p *= exp(-d->c * t / m);
            vti_sum_add(d->lost, 0.5 * m * (before - *p) * (before + *p));
        }
}

static vti_effect drag_effect(const struct drag *d)
{
    static const char *const book[] = {"drag"};
    const vti_effect effect = {.name = "drag",
                               .flow = drag_flow,
                               .springs = vti_springs_none,
                               .self = d,
                               .needs = 1 << VTI_QUANTITY_V | 1 << VTI_QUANTITY_MASS,
                               .smooth = 1,
                               .dissipates = 1,
                               .books = 1,
                               .book = book,
                               .booked = d->lost};
    return effect;
}

/* ---- a trap that holds every body to the origin, F = -k x, and lets go of all of them when it is told to --------- */

struct trap {
    double k;
    int *holds;
    vti_sum *lost;
};

static double trapped(const struct trap *p, const vti_bodies *some)
{
    double sum = 0.0;
    for (int64_t i = some->first; *p->holds && i < some->first + some->count; ++i)
        sum += 0.5 * p->k * vti_dot(x[i], x[i]);
    return sum;
}

static void trap_apply(const void *self, const vti_bodies *some)
{
    const struct trap *p = self;
    for (int64_t i = some->first; *p->holds && i < some->first + some->count; ++i)
        for (int k = 0; k < 3; ++k)
            force[i][k] -= p->k * x[i][k];
}

static void trap_energy(const void *self, const vti_bodies *some, double *energies)
{
    energies[0] = trapped(self, some);
}

static int64_t trap_rupture(const void *self, const vti_bodies *some)
{
    const struct trap *p = self;
    if (!*p->holds || vti_dot(x[0], x[0]) < 4.0)
        return 0;
    vti_sum_add(p->lost, trapped(p, some));
    *p->holds = 0;
    return N;
}

static vti_effect trap_effect(const struct trap *p)
{
    static const char *const name[] = {"trap"};
    const vti_effect effect = {.name = "trap",
                               .apply = trap_apply,
                               .energy = trap_energy,
                               .self = p,
                               .needs = 1 << VTI_QUANTITY_X,
                               .gives = 1 << VTI_QUANTITY_FORCE,
                               .smooth = 1,
                               .terms = 1,
                               .term = name,
                               .books = p->lost != NULL,
                               .book = name,
                               .booked = p->lost};
    return effect;
}

/** t = 2 by steps of h. Returns the last energy with what is booked. */
static double travel(const vti_stepper *method, double h, const vti_effect *effects, int64_t n)
{
    assert_int_equal(vti_apply(effects, n, &b), VTI_OK);
    for (int64_t step = 0; step < llrint(2.0 / h); ++step) {
        assert_int_equal(vti_effects_begin(method, h, effects, n, &b, NULL), VTI_OK);
        assert_int_equal(vti_apply(effects, n, &b), VTI_OK);
        for (int64_t k = 1; k < method->stages; ++k) {
            vti_bodies probed = b;
            double where[N][3], turned[N][3];
            if (method->probe != NULL && method->probe[k] != 0.0) { /* forces of a probe: those of the trap, at where */
                double kept[N][3];
                probed.x = vti_view_packed(where[0]);
                probed.alpha = vti_view_packed(turned[0]);
                assert_int_equal(vti_step_probe(method, k, h, &b, &probed), VTI_OK);
                memcpy(kept, x, sizeof x);
                memcpy(x, where, sizeof x);
                assert_int_equal(vti_apply(effects, n, &b), VTI_OK);
                memcpy(x, kept, sizeof x);
            }
            assert_int_equal(vti_effects_stage(method, k, h, effects, n, &b, NULL), VTI_OK);
            assert_int_equal(vti_apply(effects, n, &b), VTI_OK);
        }
        assert_int_equal(vti_effects_finish(method, h, effects, n, &b), VTI_OK);
    }
    return vti_energy(effects, n, &b) + vti_booked(effects, n);
}

static void free_flight(void **state)
{
    vti_sum lost = {0.0, 0.0};
    const struct drag drag = {0.7, &lost};
    const vti_effect effect = drag_effect(&drag);
    const char *const names[] = {"vti1", "vti2", "vti3", "exact", "chin4"};
    double start[N][3];
    for (int m = 0; m < 5; ++m) {
        bodies(state);
        memcpy(start, v, sizeof v);
        lost.high = lost.low = 0.0;
        const double energy = vti_energy(&effect, 1, &b), end = travel(vti_stepper_find(names[m]), 0.125, &effect, 1);
        for (int i = 0; i < N; ++i)
            for (int k = 0; k < 3; ++k) /* 2 flows and more of each of 16 steps */
                assert_close(v[i][k], start[i][k] * exp(-0.7 * 2.0 / mass[i]), 256 * EPS);
        assert_true(vti_sum_value(&lost) > 0.1 * energy);
        assert_close(end, energy, 64 * EPS * energy);
    }
}

/** Damped oscillators: x = exp(-g t) (x0 cos w t + (v0 + g x0)/w sin w t), g = c/2m, w^2 = k/m - g^2. */
static double error_at(const vti_stepper *method, double h, double *ledger)
{
    vti_sum lost = {0.0, 0.0};
    int holds = 1;
    const struct drag drag = {0.4, &lost};
    const struct trap trap = {3.0, &holds, NULL};
    const vti_effect effects[] = {drag_effect(&drag), trap_effect(&trap)};
    double x0[N][3], v0[N][3], most = 0.0;
    bodies(NULL);
    memcpy(x0, x, sizeof x);
    memcpy(v0, v, sizeof v);
    const double energy = vti_energy(effects, 2, &b);
    *ledger = fabs(travel(method, h, effects, 2) - energy);
    for (int i = 0; i < N; ++i) {
        const double g = 0.2 / mass[i], w = sqrt(3.0 / mass[i] - g * g), t = 2.0;
        for (int k = 0; k < 3; ++k) {
            const double c = (v0[i][k] + g * x0[i][k]) / w;
            most = fmax(most, fabs(x[i][k] - exp(-g * t) * (x0[i][k] * cos(w * t) + c * sin(w * t))));
        }
    }
    return most;
}

TEST(orders)
{
    const struct {
        const char *name;
        double order;
    } all[] = {{"vti1", 2}, {"vti2", 2}, {"exact", 2}, {"vti3", 1}, {"chin4", 2}};
    for (int m = 0; m < 5; ++m) {
        double ledger[2];
        const vti_stepper *method = vti_stepper_find(all[m].name);
        const double coarse = error_at(method, 1.0 / 64, &ledger[0]), fine = error_at(method, 1.0 / 128, &ledger[1]);
        assert_true(fabs(log2(coarse / fine) - all[m].order) < 0.1);
        assert_true(fabs(log2(ledger[0] / ledger[1]) - all[m].order) < 0.2);
        assert_true(fine < 2e-2);
    }
}

/* ---- when it is called ------------------------------------------------------------------------------------------- */

struct call {
    char what, who;
    double t, drift;
};

static struct call calls[MOST];
static int made;

static void note(char what, const void *self, double t, double drift)
{
    const struct call call = {what, *(const char *)self, t, drift};
    assert_true(made < MOST);
    calls[made++] = call;
}

static void note_flow(const void *self, const vti_bodies *some, double t, double drift)
{
    assert_ptr_equal(some, &b);
    note('f', self, t, drift);
}

static void note_carry(const void *self, const vti_bodies *some, const vti_drifted *drifted)
{
    assert_ptr_equal(some, &b);
    assert_true(drifted->law >= VTI_LAW_CLOSED && drifted->frame == VTI_FRAME_SPACE);
    note('c', self, drifted->t, (double)drifted->law);
}

static const vti_effect first = {.name = "first", .flow = note_flow, .carry = note_carry, .self = "1"},
                        second = {.name = "second", .flow = note_flow, .carry = note_carry, .self = "2"};

static void expect(const struct call *wanted, int n)
{
    assert_int_equal(made, 2 * n);
    for (int k = 0; k < n; ++k) {
        const int backwards = wanted[k].what == 'f' && wanted[k].drift < 0.0;
        for (int e = 0; e < 2; ++e) {
            const struct call *found = &calls[2 * k + e];
            assert_int_equal(found->what, wanted[k].what);
            assert_int_equal(found->who, backwards == e ? '1' : '2');
            assert_close(found->t, wanted[k].t, EPS);
            assert_close(found->drift, wanted[k].drift, 4 * EPS);
        }
    }
}

static void play(const vti_stepper *method, double h)
{
    const vti_effect both[] = {first, second};
    made = 0;
    assert_int_equal(vti_effects_begin(method, h, both, 2, &b, NULL), VTI_OK);
    for (int64_t k = 1; k < method->stages; ++k)
        assert_int_equal(vti_effects_stage(method, k, h, both, 2, &b, NULL), VTI_OK);
    assert_int_equal(vti_effects_finish(method, h, both, 2, &b), VTI_OK);
}

TEST(places)
{
    const double h = 0.25, half = 0.125;
    const struct call verlet[] = {{'f', 0, half, h}, {'c', 0, h, VTI_LAW_CAYLEY}, {'f', 0, half, -h}};
    play(vti_stepper_find("vti2"), h);
    expect(verlet, 3);

    const struct call euler[] = {{'f', 0, half, -h}, {'f', 0, half, h}, {'c', 0, h, VTI_LAW_CAYLEY}};
    play(vti_stepper_find("vti3"), h);
    expect(euler, 3);

    const struct call chin[] = {{'f', 0, h / 6, half}, {'c', 0, half, VTI_LAW_EXACT}, {'f', 0, h / 3, -half},
                                {'f', 0, h / 3, half}, {'c', 0, half, VTI_LAW_EXACT}, {'f', 0, h / 6, -half}};
    play(vti_stepper_find("chin4"), h);
    expect(chin, 6);

    const double kick[] = {0, 1}, drift[] = {0.5, 0.5};
    const vti_stepper position = {
        .name = "own", .law = VTI_LAW_CAYLEY, .frame = VTI_FRAME_SPACE, .stages = 1, .kick = kick, .drift = drift};
    const struct call middle[] = {
        {'c', 0, half, VTI_LAW_CAYLEY}, {'f', 0, half, -half}, {'f', 0, half, half}, {'c', 0, half, VTI_LAW_CAYLEY}};
    play(&position, h);
    expect(middle, 4);

    /* by the host itself */
    const vti_effect both[] = {first, second};
    const vti_drifted drifted = {.t = h, .law = VTI_LAW_CAYLEY, .frame = VTI_FRAME_SPACE};
    made = 0;
    assert_int_equal(vti_effects_flow(both, 2, half, h, &b), VTI_OK);
    assert_int_equal(vti_effects_carry(both, 2, &drifted, &b), VTI_OK);
    assert_int_equal(vti_effects_flow(both, 2, half, -h, &b), VTI_OK);
    assert_int_equal(vti_effects_flow(both, 2, 0.0, h, &b), VTI_OK); /* no time, no call */
    expect(verlet, 3);
}

/** Without any of it the steps are those of vti_step.h, to the bit. */
static void same_bits(void **state)
{
    const vti_pendulum hung = {0.8, {0.1, 0.5, -0.3}};
    const vti_gravity gravity = {{0.2, -0.4, 0.1}};
    const vti_effect effects[] = {vti_pendulum_effect(&hung), vti_gravity_effect(&gravity)};
    for (int64_t m = 0; m < vti_stepper_count(); ++m) {
        const vti_stepper *method = vti_stepper_at(m);
        double end[2][4][3 * N];
        for (int by = 0; by < 2; ++by) {
            bodies(state);
            assert_int_equal(vti_apply(effects, 2, &b), VTI_OK);
            for (int64_t k = 0; k < method->stages; ++k) {
                const int status = by ? vti_effects_stage(method, k, 0.1, effects, 2, &b, NULL)
                                      : vti_step_stage(method, k, 0.1, &b, NULL);
                assert_int_equal(status, VTI_OK);
                assert_int_equal(vti_apply(effects, 2, &b), VTI_OK);
            }
            assert_int_equal(by ? vti_effects_finish(method, 0.1, effects, 2, &b) : vti_step_finish(method, 0.1, &b),
                             VTI_OK);
            memcpy(end[by][0], x, sizeof x);
            memcpy(end[by][1], v, sizeof v);
            memcpy(end[by][2], alpha, sizeof alpha);
            memcpy(end[by][3], omega, sizeof omega);
        }
        for (int k = 0; k < 4; ++k)
            assert_same_bits(end[0][k], end[1][k], 3 * N);
    }
}

/* ---- what breaks, and what is refused ---------------------------------------------------------------------------- */

TEST(rupture)
{
    vti_sum lost = {0.0, 0.0};
    int holds = 1;
    int64_t broken = 7;
    const struct trap trap = {3.0, &holds, &lost};
    const vti_gravity gravity = {{0, 0, 0}};
    const vti_effect effects[] = {vti_gravity_effect(&gravity), trap_effect(&trap)};
    vti_effect breaking[] = {effects[0], effects[1]};
    breaking[1].rupture = trap_rupture;
    assert_int_equal(vti_effects_rupture(effects, 2, &b, &broken), VTI_OK);
    assert_true(broken == 0 && holds);
    assert_int_equal(vti_effects_rupture(breaking, 2, &b, &broken), VTI_OK);
    assert_true(broken == 0 && holds);
    x[0][0] = 2.5;
    const double before = vti_energy(breaking, 2, &b) + vti_booked(breaking, 2);
    assert_int_equal(vti_effects_rupture(breaking, 2, &b, &broken), VTI_OK);
    assert_true(broken == N && !holds && vti_booked(breaking, 2) > 9.0);
    assert_close(vti_energy(breaking, 2, &b) + vti_booked(breaking, 2), before, 8 * EPS * before);
    assert_int_equal(vti_effects_rupture(breaking, 2, &b, &broken), VTI_OK);
    assert_int_equal(broken, 0);
    int hold[2] = {1, 1};
    const struct trap two[] = {{3.0, &hold[0], &lost}, {3.0, &hold[1], &lost}};
    vti_effect both[] = {trap_effect(&two[0]), trap_effect(&two[1])};
    both[0].rupture = both[1].rupture = trap_rupture;
    assert_int_equal(vti_effects_rupture(both, 2, &b, &broken), VTI_OK);
    assert_int_equal(broken, 2 * N); /* of both effects */
    assert_int_equal(vti_effects_rupture(breaking, 2, &b, NULL), VTI_E_NULL);
    assert_int_equal(vti_effects_rupture(NULL, 2, &b, &broken), VTI_E_NULL);
    assert_int_equal(vti_step_check(vti_stepper_find("kl6"), breaking, 2), VTI_E_DISSIPATES);
    assert_int_equal(vti_step_check(vti_stepper_find("kl6"), effects, 2), VTI_OK);
}

TEST(refusals)
{
    const vti_stepper *const vti1 = vti_stepper_find("vti1"), *const body = vti_stepper_find("vti1-body");
    const vti_effect flows = {.name = "flows", .flow = note_flow, .self = "1"};
    vti_effect needy = first, carries = first, turns = flows;
    vti_drifted drifted = {.t = 0.1, .law = VTI_LAW_EXACT, .frame = VTI_FRAME_SPACE};
    vti_fault fault = {7, 7, 7};
    carries.dissipates = 0;
    made = 0;
    assert_int_equal(vti_effects_begin(vti_stepper_find("srkn6"), 0.1, &carries, 1, &b, &fault), VTI_E_DISSIPATES);
    assert_true(fault.body == -1 && fault.quantity == VTI_QUANTITY_NONE);
    assert_int_equal(vti_effects_begin(vti_stepper_find("srkn6"), 0.1, &flows, 1, &b, NULL), VTI_E_DISSIPATES);
    assert_int_equal(vti_effects_finish(vti_stepper_find("kl8"), 0.1, &flows, 1, &b), VTI_E_DISSIPATES);
    assert_int_equal(vti_effects_begin(NULL, 0.1, &flows, 1, &b, NULL), VTI_E_STEPPER);
    assert_int_equal(vti_effects_begin(vti1, 0.1, NULL, 1, &b, NULL), VTI_E_NULL);
    assert_int_equal(vti_effects_begin(vti1, 0.1, NULL, -1, &b, NULL), VTI_E_COUNT);
    assert_int_equal(vti_effects_begin(vti1, 0.1, &flows, 1, NULL, NULL), VTI_E_NULL);
    assert_int_equal(vti_effects_stage(vti1, 1, 0.1, &flows, 1, &b, NULL), VTI_E_STAGE);
    assert_int_equal(vti_effects_stage(vti1, -1, 0.1, &flows, 1, &b, NULL), VTI_E_STAGE);
    assert_int_equal(vti_effects_begin(body, 0.1, &first, 1, &b, NULL), VTI_E_FRAME);
    assert_int_equal(vti_effects_finish(body, 0.1, &first, 1, &b), VTI_E_FRAME);
    turns.needs = 1 << VTI_QUANTITY_X; /* as dashpots that turn bodies: by Omega in space */
    turns.breaks = VTI_BREAKS_SPINS;
    assert_int_equal(vti_effects_begin(body, 0.1, &turns, 1, &b, NULL), VTI_E_FRAME);
    const double wrong[] = {NAN, INFINITY, 0.0, -0.1};
    for (int k = 0; k < 4; ++k) {
        assert_int_equal(vti_effects_begin(vti1, wrong[k], &flows, 1, &b, &fault), VTI_E_TIME);
        assert_same_bits(&fault.value, &wrong[k], 1);
        assert_int_equal(vti_effects_finish(vti1, wrong[k], &flows, 1, &b), VTI_E_TIME);
        if (k != 2)
            assert_int_equal(vti_effects_flow(&flows, 1, wrong[k], 0.1, &b), VTI_E_TIME);
    }
    assert_int_equal(vti_effects_flow(&flows, 1, 0.1, NAN, &b), VTI_E_TIME);
    assert_int_equal(vti_effects_carry(&first, 1, NULL, &b), VTI_E_NULL);
    drifted.frame = VTI_FRAME_BODY;
    assert_int_equal(vti_effects_carry(&first, 1, &drifted, &b), VTI_E_FRAME);
    assert_int_equal(vti_effects_carry(&flows, 1, &drifted, &b), VTI_OK); /* what carries nothing has no frame */
    drifted.frame = VTI_FRAME_SPACE;
    for (int k = 0; k < 3; ++k) {
        drifted.rotor = (const int64_t[]){3, -2, 8}[k];
        assert_int_equal(vti_effects_carry(&first, 1, &drifted, &b), VTI_E_STEPPER);
    }
    drifted.rotor = 0;
    drifted.frame = VTI_FRAME_BODY;
    drifted.law = 0;
    assert_int_equal(vti_effects_carry(&first, 1, &drifted, &b), VTI_E_STEPPER);
    drifted.law = VTI_LAW_EXACT;
    drifted.frame = VTI_FRAME_SPACE;
    drifted.t = INFINITY;
    assert_int_equal(vti_effects_carry(&first, 1, &drifted, &b), VTI_E_TIME);
    needy.needs = 1 << VTI_QUANTITY_X_LOW | 1 << VTI_QUANTITY_OMEGA;
    b.omega = vti_view_none();
    b.moment = vti_view_none();
    assert_int_equal(vti_effects_begin(vti1, 0.1, &needy, 1, &b, &fault), VTI_E_NEEDS);
    assert_true(fault.body == 0 && fault.quantity == VTI_QUANTITY_OMEGA);
    assert_int_equal(vti_effects_flow(&needy, 1, 0.1, 0.1, &b), VTI_E_NEEDS);
    assert_int_equal(vti_effects_carry(&needy, 1, &drifted, &b), VTI_E_NEEDS);
    assert_int_equal(made, 0); /* none of them has called anything */
    bodies(NULL);
    /* velocities of the centres have no such frame */
    assert_int_equal(vti_effects_begin(body, 0.1, &flows, 1, &b, NULL), VTI_OK);

    /* the bound of the closed form is known once the flow is done: one call, and no drift to carry along */
    omega[1][0] = 11.0;
    made = 0;
    assert_int_equal(vti_effects_begin(vti1, 0.1, &first, 1, &b, &fault), VTI_E_TOO_LARGE);
    assert_true(fault.body == 1 && made == 1 && calls[0].what == 'f');
    assert_true(isnan(vti_booked(NULL, 1)) && isnan(vti_booked(&first, -1)) && vti_booked(NULL, 0) == 0.0);
}

/** The increment is the attitude that a drift makes of none. */
static void increments(void **state)
{
    for (int law = VTI_LAW_CLOSED; law <= VTI_LAW_EXACT9; ++law) {
        bodies(state);
        assert_int_equal(vti_drift(law, VTI_FRAME_SPACE, 0.75, &b, NULL), VTI_OK);
        for (int i = 0; i < N; ++i) {
            double turn[3];
            vti_drift_increment(law, 0.75, omega[i], turn);
            for (int k = 0; k < 3; ++k)
                assert_close(turn[k], alpha[i][k], 2 * EPS);
        }
    }
    const double fast[3] = {0, 2, 0};
    double turn[3];
    vti_drift_increment(VTI_LAW_CLOSED, 1.0, fast, turn);
    assert_true(turn[0] == 0.0 && turn[1] == 4.0 && turn[2] == 0.0);
    vti_drift_increment(VTI_LAW_EXACT9 + 1, 1.0, fast, turn);
    assert_true(isnan(turn[0]));
    /* s^2 = 10 is half a turn of the exact law */
    const double halves[3][3] = {{3, 1, 0}, {3e9, 0, 0}, {0, -1e300, 1e300}};
    for (int k = 0; k < 3; ++k) {
        bodies(state);
        memset(alpha, 0, sizeof alpha);
        memcpy(omega[0], halves[k], sizeof omega[0]);
        assert_int_equal(vti_drift(VTI_LAW_EXACT, VTI_FRAME_SPACE, 1.0, &b, NULL), VTI_OK);
        vti_drift_increment(VTI_LAW_EXACT, 1.0, omega[0], turn);
        assert_true(vti_max3(turn) == VTI_RRV_LARGE);
        for (int c = 0; c < 3; ++c)
            assert_close(turn[c], alpha[0][c], 4 * EPS * VTI_RRV_LARGE);
    }
    turn[1] = 0;
    vti_drift_increment(VTI_LAW_EXACT, 1.0, NULL, turn);
    vti_drift_increment(VTI_LAW_EXACT, 1.0, fast, NULL);
    assert_true(isnan(turn[1]));
}

RUN_TESTS(cmocka_unit_test_setup(free_flight, bodies), cmocka_unit_test_setup(orders, bodies),
          cmocka_unit_test_setup(places, bodies), cmocka_unit_test_setup(same_bits, bodies),
          cmocka_unit_test_setup(rupture, bodies), cmocka_unit_test_setup(refusals, bodies),
          cmocka_unit_test_setup(increments, bodies))
