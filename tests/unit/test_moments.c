/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What bodies with moments are refused for, with the quantity and the body, and what writes nothing then; the bound of
 * the closed form for all of their turns; numbers of any size: finite, or refused. */
#include "top.h"

enum { N = 5 };

static double moments[N][3], spin[N][3], omega[N][3], alpha[N][3], moment[N][3], principal[N][4], low[N][3];
static vti_bodies b;

static int sound(void **state)
{
    (void)state;
    rng g = rng_seed(301);
    b = vti_bodies_none(N);
    b.moments = vti_view_packed(moments[0]);
    b.spin = vti_view_packed(spin[0]);
    b.alpha = vti_view_packed(alpha[0]);
    b.moment = vti_view_packed(moment[0]);
    for (int i = 0; i < N; ++i) {
        top_moments(&g, 0.1, moments[i]);
        random_vector(&g, 0.05, spin[i]);
        random_vector(&g, 1, omega[i]);
        random_vector(&g, 1, alpha[i]);
        random_vector(&g, 0.1, moment[i]);
        random_unit(&g, 4, principal[i]);
    }
    return 0;
}

static void refused(int status, int64_t quantity)
{
    double before[2][N][3];
    memcpy(before[0], spin, sizeof spin);
    memcpy(before[1], alpha, sizeof alpha);
    vti_fault fault = {7, 7, 7};
    assert_int_equal(vti_bodies_check(&b), status);
    assert_int_equal(vti_drift(VTI_LAW_EXACT, VTI_FRAME_SPACE, 0.1, &b, &fault), status);
    assert_int_equal(fault.quantity, quantity);
    assert_int_equal(fault.body, -1);
    assert_int_equal(vti_kick(0.1, &b), status);
    assert_int_equal(vti_step_begin(vti_stepper_find("exact"), 0.1, &b, NULL), status);
    assert_same_bits(before[0], spin, 3 * N);
    assert_same_bits(before[1], alpha, 3 * N);
}

static void value_refused(int status, int64_t body, double value, int64_t quantity)
{
    vti_fault fault = {7, 7, 7};
    assert_int_equal(vti_bodies_check(&b), VTI_OK);
    assert_int_equal(vti_bodies_check_values(&b, &fault), status);
    assert_int_equal(fault.body, body);
    assert_int_equal(fault.quantity, quantity);
    assert_true(fault.value == value || (isnan(value) && isnan(fault.value)));
}

TEST(views_that_do_not_go_together)
{
    static const double one = 1;
    vti_view *const views[] = {&b.moments, &b.spin};
    for (int k = 0; k < 2; ++k) {
        double *const c = views[k]->c[1];
        views[k]->c[1] = NULL;
        refused(VTI_E_VIEW, k == 0 ? VTI_QUANTITY_MOMENTS : VTI_QUANTITY_SPIN);
        views[k]->c[1] = c;
        views[k]->count = N - 1;
        refused(VTI_E_COUNT, k == 0 ? VTI_QUANTITY_MOMENTS : VTI_QUANTITY_SPIN);
        views[k]->count = 0;
    }
    b.spin.stride = 0;
    refused(VTI_E_STRIDE, VTI_QUANTITY_SPIN);
    b.spin.stride = 3;
    b.inertia = vti_scalars_one(&one);
    refused(VTI_E_MOMENTS, VTI_QUANTITY_INERTIA);
    b.inertia.p = NULL;
    b.omega = vti_view_packed(omega[0]);
    b.omega_low = vti_view_packed(low[0]);
    refused(VTI_E_MOMENTS, VTI_QUANTITY_OMEGA_LOW);
    b.omega_low = vti_view_none();
    b.spin = vti_view_none();
    assert_int_equal(vti_bodies_check(&b), VTI_OK);
    b.alpha = vti_view_none();
    refused(VTI_E_MOMENTS, VTI_QUANTITY_OMEGA);
    b.omega = vti_view_none();
    assert_int_equal(vti_bodies_check(&b), VTI_OK);
    b.spin = vti_view_packed(spin[0]);
    b.moments = vti_view_none();
    refused(VTI_E_MOMENTS, VTI_QUANTITY_MOMENTS);
}

TEST(principal_axes)
{
    b.principal = quats_packed(principal[0]);
    assert_int_equal(vti_bodies_check_values(&b, NULL), VTI_OK);
    b.principal.stride = 0; /* one for all */
    assert_int_equal(vti_bodies_check_values(&b, NULL), VTI_OK);
    b.principal.count = 1;
    assert_int_equal(vti_bodies_check(&b), VTI_OK);
    b.principal = quats_packed(principal[0]);
    b.principal.xyzw[2] = NULL;
    refused(VTI_E_VIEW, VTI_QUANTITY_PRINCIPAL);
    b.principal = quats_packed(principal[0]);
    b.principal.xyzw[2] = b.principal.xyzw[3];
    refused(VTI_E_ALIAS, VTI_QUANTITY_PRINCIPAL);
    b.principal = quats_packed(principal[0]);
    b.principal.count = N - 1;
    refused(VTI_E_COUNT, VTI_QUANTITY_PRINCIPAL);
    b.principal.count = N;
    b.principal.xyzw[0] = spin[0];
    refused(VTI_E_ALIAS, VTI_QUANTITY_PRINCIPAL);
    b.principal = quats_packed(principal[0]);
    memset(principal[3], 0, sizeof principal[3]);
    value_refused(VTI_E_STATE, 3, 0, VTI_QUANTITY_PRINCIPAL);
    principal[3][1] = NAN;
    value_refused(VTI_E_STATE, 3, NAN, VTI_QUANTITY_PRINCIPAL);
}

/** One set of moments for all bodies has the bits of an array of equal ones, and is looked at by every call. */
TEST(one_for_all)
{
    double apart[2][N][3], start[2][N][3];
    for (int i = 0; i < N; ++i)
        memcpy(moments[i], moments[0], sizeof moments[0]);
    memcpy(start[0], spin, sizeof spin);
    memcpy(start[1], alpha, sizeof alpha);
    assert_int_equal(vti_step_begin(vti_stepper_find("srkn11"), 0.5, &b, NULL), VTI_OK);
    memcpy(apart[0], spin, sizeof spin);
    memcpy(apart[1], alpha, sizeof alpha);
    memcpy(spin, start[0], sizeof spin);
    memcpy(alpha, start[1], sizeof alpha);
    b.moments.stride = 0;
    assert_int_equal(vti_bodies_check_values(&b, NULL), VTI_OK);
    assert_int_equal(vti_step_begin(vti_stepper_find("srkn11"), 0.5, &b, NULL), VTI_OK);
    assert_same_bits(apart[0], spin, 3 * N);
    assert_same_bits(apart[1], alpha, 3 * N);
    moments[0][1] = -1;
    refused(VTI_E_MOMENTS, VTI_QUANTITY_MOMENTS);
}

/** Each of them positive and finite, none more than the sum of the others; a spin that is not finite. */
TEST(values)
{
    const double bad[] = {0, -1, NAN, INFINITY, 1e-310};
    for (int k = 0; k < 5; ++k)
        for (int c = 0; c < 3; ++c) {
            const double good = moments[2][c];
            moments[2][c] = bad[k];
            value_refused(VTI_E_MOMENTS, 2, bad[k], VTI_QUANTITY_MOMENTS);
            moments[2][c] = good;
        }
    for (int c = 0; c < 3; ++c) {
        const double good = moments[4][c], sum = moments[4][(c + 1) % 3] + moments[4][(c + 2) % 3];
        moments[4][c] = sum * (1 + 0x1p-23); /* a plate, in single precision */
        assert_int_equal(vti_bodies_check_values(&b, NULL), VTI_OK);
        moments[4][c] = sum * (1 + 0x1p-19);
        value_refused(VTI_E_MOMENTS, 4, moments[4][c], VTI_QUANTITY_MOMENTS);
        moments[4][c] = good;
    }
    b.omega = vti_view_packed(omega[0]); /* beside spin it is only written */
    omega[0][1] = NAN;
    assert_int_equal(vti_bodies_check_values(&b, NULL), VTI_OK);
    spin[1][2] = INFINITY;
    value_refused(VTI_E_STATE, 1, INFINITY, VTI_QUANTITY_SPIN);
}

static int flowed;

static void note_flow(const void *self, const vti_bodies *bodies, double t, double drift)
{
    (void)self, (void)bodies, (void)t, (void)drift;
    ++flowed;
}

TEST(frames_rotors_and_methods)
{
    vti_fault fault;
    static double x[N][3], memory[6 * 4 * N];
    assert_int_equal(vti_drift(VTI_LAW_EXACT, VTI_FRAME_BODY, 0.1, &b, &fault), VTI_E_FRAME);
    assert_int_equal(fault.quantity, VTI_QUANTITY_MOMENTS);
    const vti_stepper *const body = vti_stepper_find("vti1-body");
    const vti_effect flows = {.name = "flows", .flow = note_flow};
    assert_int_equal(vti_step_begin(body, 0.1, &b, NULL), VTI_E_FRAME);
    assert_int_equal(vti_step_finish(body, 0.1, &b), VTI_E_FRAME);
    assert_int_equal(vti_effects_begin(body, 0.1, &flows, 1, &b, &fault), VTI_E_FRAME);
    assert_int_equal(fault.quantity, VTI_QUANTITY_MOMENTS);
    vti_stepper own = *vti_stepper_find("chin4");
    vti_bodies probed = b;
    probed.alpha = vti_view_packed(x[0]);
    assert_int_equal(vti_step_probe(&own, 1, 0.1, &b, &probed), VTI_OK);
    own.frame = VTI_FRAME_BODY;
    assert_int_equal(vti_step_probe(&own, 1, 0.1, &b, &probed), VTI_E_FRAME);
    own = *vti_stepper_find("exact");
    for (int64_t order = -1; order < 9; ++order) {
        own.rotor = order;
        const int good = order == 0 || order == 2 || order == 4 || order == 6;
        assert_int_equal(vti_step_begin(&own, 0.1, &b, NULL), good ? VTI_OK : VTI_E_STEPPER);
        assert_int_equal(vti_effects_begin(&own, 0.1, &flows, !good, &b, NULL), good ? VTI_OK : VTI_E_STEPPER);
        assert_int_equal(flowed, 0);
    }
    vti_past past = {memory, 4, 0};
    assert_int_equal(vti_multistep_record(&past, &b), VTI_E_MOMENTS);
}

/** chin4's probe turns by c h^2 R_p diag(k) R_p^T RM, which is what the estimates of a step are made of too. */
TEST(accelerations)
{
    rng g = rng_seed(302);
    for (int trial = 0; trial < 30; ++trial) {
        top p = top_random(&g, trial % 2 ? TOP_QUAT : TOP_ALPHA, (enum top_spin)(trial / 2 % 3)), q = p, r = p;
        const vti_stepper *const chin4 = vti_stepper_find("chin4"), *const srkn6 = vti_stepper_find("srkn6");
        const double h = 0.1;
        double w[3], memory[18], velocity, of_spin, squares = 0;
        memcpy(r.spin, p.moment, sizeof r.spin);
        top_omega(&r, w);
        const vti_bodies here = top_bodies(&p), there = top_bodies(&q);
        assert_int_equal(vti_step_probe(chin4, 1, h, &here, &there), VTI_OK);
        const double turn = chin4->probe[1] * h * h * vti_norm(w);
        assert_close(quat_distance(top_attitude(&q), quat_times(quat_turn(w, turn), top_attitude(&p))), 0, 16 * EPS);
        const vti_errors errors = {memory, srkn6->estimates};
        assert_int_equal(vti_step_watch(srkn6, 0, h, &here, &errors), VTI_OK);
        assert_int_equal(vti_step_error(srkn6, &here, &errors, &velocity, &of_spin), VTI_OK);
        for (int64_t row = 0; row < srkn6->estimates; ++row)
            squares += pow(h * srkn6->estimate[row * (srkn6->stages + 1)] * vti_norm(w), 2);
        assert_close(of_spin, sqrt(squares), 32 * EPS * of_spin);
    }
}

/** Every turn of the list counts, and k_r t|L|: about each axis as much as fits, and a little more. */
TEST(closed_needs_every_turn_below_1)
{
    const vti_stepper *const vti1 = vti_stepper_find("vti1");
    const double m[3] = {1, 2, 2.5}, most[3] = {2 / (1 - 0.5), 2, 1 / (0.5 - 0.4)};
    vti_fault fault;
    memset(alpha, 0, sizeof alpha);
    b.moment = vti_view_none();
    for (int which = 0; which < 2 * 3 * 3; ++which) {
        const int axis = which / 2 % 3, beside = which / 6;
        for (int i = 0; i < N; ++i) {
            memcpy(moments[i], m, sizeof m);
            memset(spin[i], 0, sizeof spin[i]);
        }
        /* x turns by half: |phi| = h d_x p_x/2, and k_r = 1/2; the smallest bound counts */
        const double bound = fmin(most[axis], 2), size = bound * (which % 2 ? 1 + 2 * EPS : 1 - 2 * EPS);
        spin[2][axis] = size;
        b.omega = beside == 1 ? vti_view_packed(omega[0]) : vti_view_none();
        double kept[N][3];
        memcpy(kept, alpha, sizeof alpha);
        const int status = vti_step_begin(vti1, 1.0, &b, &fault);
        assert_int_equal(status, which % 2 ? VTI_E_TOO_LARGE : VTI_OK);
        if (which % 2) {
            assert_int_equal(fault.body, 2);
            assert_int_equal(fault.quantity, VTI_QUANTITY_SPIN);
            assert_close(fault.value, 1, 8 * EPS);
            assert_same_bits(kept, alpha, 3 * N);
        }
        memset(alpha, 0, sizeof alpha);
    }
    /* the largest is told, and not the first that is too large */
    spin[2][0] = 2.5;
    spin[2][1] = 0;
    spin[2][2] = 40;
    assert_int_equal(vti_step_begin(vti1, 1.0, &b, &fault), VTI_E_TOO_LARGE);
    assert_close(fault.value, 0.5 * sqrt(2.5 * 2.5 + 40 * 40), 8 * EPS * 20);
    /* a thin body: the turn about y makes p_x larger, or smaller, so that the last turn is too large, or is not */
    const double thin[3] = {0.01, 1, 1.005}, fast[3] = {0.0198, -0.6, 0.5};
    for (int i = 0; i < N; ++i)
        memcpy(moments[i], thin, sizeof thin);
    memset(spin, 0, sizeof spin);
    memcpy(spin[4], fast, sizeof fast);
    const int status = vti_step_begin(vti1, 1.0, &b, &fault);
    assert_int_equal(status, VTI_OK);
    memset(alpha, 0, sizeof alpha);
    spin[4][1] = 0.6;
    assert_int_equal(vti_step_begin(vti1, 1.0, &b, &fault), VTI_E_TOO_LARGE);
    assert_int_equal(fault.body, 4);
    assert_true(fault.value > 1 && fault.value < 1.1);
    spin[3][1] = NAN;
    assert_int_equal(vti_step_begin(vti1, 1.0, &b, &fault), VTI_E_TOO_LARGE);
    assert_true(fault.body == 3 && isnan(fault.value));
    b.spin = vti_view_none();
    b.omega = vti_view_packed(omega[0]);
    omega[1][1] = 1e3;
    omega[3][1] = 5e2; /* too large as well, but not the worst */
    assert_int_equal(vti_step_begin(vti1, 1.0, &b, &fault), VTI_E_TOO_LARGE);
    assert_true(fault.body == 1 && fault.quantity == VTI_QUANTITY_OMEGA);
    assert_int_equal(vti_step_begin(vti1, 1.0, &b, NULL), VTI_E_TOO_LARGE);
}

/** Kicks count: what is tested is the spin that they leave, residuals included. */
TEST(closed_looks_past_the_kicks)
{
    const vti_stepper *const vti1 = vti_stepper_find("vti1");
    static double carried[N][3];
    b.spin_low = vti_view_packed(carried[0]);
    for (int i = 0; i < N; ++i)
        for (int k = 0; k < 3; ++k) {
            moments[i][k] = 1;
            spin[i][k] = moment[i][k] = 0;
        }
    moment[3][1] = 1.999;
    assert_int_equal(vti_step_begin(vti1, 1.0, &b, NULL), VTI_OK);
    assert_true(spin[3][1] == 0.9995);
    spin[3][1] = 0;
    moment[3][1] = 2;
    assert_int_equal(vti_step_begin(vti1, 1.0, &b, NULL), VTI_E_TOO_LARGE);
    assert_true(spin[3][1] == 0);
    moment[3][1] = 0.5;
    spin[3][1] = 0.5;
    assert_int_equal(vti_step_next(vti1, 1.0, &b, NULL), VTI_E_TOO_LARGE);
    moment[3][1] = 0.4;
    assert_int_equal(vti_step_next(vti1, 1.0, &b, NULL), VTI_OK);
    assert_close(spin[3][1], 0.9, 4 * EPS);
}

static double turn_about(const double k[3], int r, int axis, const double p[3])
{
    return fabs((k[axis] - k[r]) * p[axis]);
}

/** Energy, momenta and the largest turn by their formulas, with L, with Omega, and with neither. */
TEST(measures)
{
    rng g = rng_seed(304);
    for (int trial = 0; trial < 90; ++trial) {
        top p = top_random(&g, (enum top_storage)(trial % TOP_STORAGES), (enum top_spin)(trial / 3 % 3));
        double x[3] = {1, 2, 3}, v[3] = {0.5, -1, 2}, about[3] = {-1, 0, 1}, l[3], s[3], arm[3] = {2, 2, 2}, orbit[3];
        double body[3], k[3], energy = 0, w[3];
        const double mass = 1.5;
        vti_bodies all = top_bodies(&p);
        all.x = vti_view_packed(x);
        all.v = vti_view_packed(v);
        all.mass = vti_scalars_one(&mass);
        quat_rotate(quat_conj(top_axes(&p)), p.spin, body);
        for (int c = 0; c < 3; ++c) {
            k[c] = 1 / p.moments[c];
            energy += 0.5 * k[c] * body[c] * body[c];
        }
        int r = 0;
        for (int c = 1; c < 3; ++c) /* the middle k */
            if ((k[c] > k[(c + 1) % 3]) != (k[c] > k[(c + 2) % 3]))
                r = c;
        top_omega(&p, w);
        const double most = fmax(fmax(vti_norm(w), k[r] * vti_norm(p.spin)),
                                 fmax(turn_about(k, r, (r + 1) % 3, body), turn_about(k, r, (r + 2) % 3, body)));
        vti_cross(arm, v, orbit);
        assert_close(vti_kinetic_rotation(&all), energy, 64 * EPS * energy);
        assert_close(vti_energy(NULL, 0, &all), energy + 0.5 * mass * vti_dot(v, v), 64 * EPS * (energy + 4));
        assert_close(vti_max_turn(-0.5, &all), 0.5 * most, 64 * EPS * most);
        vti_spin(&all, s);
        assert_close3(s, p.spin, 64 * EPS * vti_norm(p.spin));
        vti_angular_momentum(&all, about, l);
        for (int c = 0; c < 3; ++c)
            assert_close(l[c], mass * orbit[c] + p.spin[c], 64 * EPS * (10 + vti_norm(p.spin)));
        if (p.shows != TOP_OMEGA) { /* without an attitude L is known, and no angular velocity */
            vti_bodies lost = all;
            lost.alpha = lost.alpha_low = vti_view_none();
            lost.quat = lost.principal = vti_bodies_none(1).quat;
            assert_true(vti_kinetic_rotation(&lost) == 0 && vti_max_turn(1, &lost) == 0);
            vti_spin(&lost, s);
            assert_close3(s, p.spin, 0);
        }
        all.spin = all.omega = all.spin_low = vti_view_none();
        assert_true(vti_kinetic_rotation(&all) == 0 && vti_max_turn(1, &all) == 0);
        vti_spin(&all, s);
        assert_true(s[0] == 0 && s[1] == 0 && s[2] == 0);
    }
}

/** A bond between two bodies, one or both of general inertia: P and L are kept, energy is the symplectic one's, and the
 *  bound of the step is that of spheres of the smallest moments. */
TEST(bonded_pairs)
{
    static const double stiff[3] = {2, 50, 30}, mass[2] = {1, 1.5};
    rng g = rng_seed(305);
    for (int64_t m = 0; m < vti_stepper_count(); ++m) {
        const vti_stepper *const method = vti_stepper_at(m);
        double x[2][3] = {{0, 0, 0}, {1, 0, 0}}, v[2][3], f[2][3], q[2][4] = {{0, 0, 0, 1}, {0, 0, 0, 1}}, t[2][3];
        double I[2][3], L[2][3], at[2][3], turned[2][4], rest[4], least[2];
        const int64_t pair[2] = {0, 1};
        vti_bodies pairs = vti_bodies_none(2);
        if (method->frame != VTI_FRAME_SPACE)
            continue;
        for (int i = 0; i < 2; ++i) {
            top_moments(&g, 0.1, I[i]);
            random_vector(&g, 0.1, v[i]);
            random_vector(&g, 0.1, L[i]);
            random_vector(&g, 0.02, at[i]);
            least[i] = fmin(I[i][0], fmin(I[i][1], I[i][2]));
        }
        pairs.x = vti_view_packed(x[0]);
        pairs.v = vti_view_packed(v[0]);
        pairs.force = vti_view_packed(f[0]);
        pairs.quat = quats_packed(q[0]);
        pairs.moment = vti_view_packed(t[0]);
        pairs.moments = vti_view_packed(I[0]);
        pairs.spin = vti_view_packed(L[0]);
        pairs.mass = vti_scalars_array(mass);
        assert_int_equal(vti_bonds_rest(1, pair, 0, &pairs.x, rest, NULL), VTI_OK);
        const vti_bonds bonds = {.count = 1,
                                 .pair = pair,
                                 .rest = rest,
                                 .moment = vti_scalars_one(&stiff[0]),
                                 .axial = vti_scalars_one(&stiff[1]),
                                 .shear = vti_scalars_one(&stiff[2]),
                                 .shear_form = VTI_SHEAR_OBJECTIVE};
        const vti_effect bond = vti_bonds_effect(&bonds);
        vti_bodies probed = pairs, balls = pairs;
        probed.x = vti_view_packed(at[0]);
        probed.quat = quats_packed(turned[0]);
        double scratch[2], p0[3], p1[3], l0[3], l1[3];
        const double about[3] = {0, 0, 0};
        vti_stable stable, of_balls;
        balls.moments = balls.spin = vti_view_none();
        balls.inertia = vti_scalars_array(least);
        assert_int_equal(vti_stable_step(&bond, 1, &pairs, NULL, scratch, &stable), VTI_OK);
        assert_int_equal(vti_stable_step(&bond, 1, &balls, NULL, scratch, &of_balls), VTI_OK);
        assert_true(stable.h == of_balls.h && isfinite(stable.h));
        vti_momentum(&pairs, p0);
        vti_angular_momentum(&pairs, about, l0);
        const double e0 = vti_energy(&bond, 1, &pairs), h = 0.2 * stable.h;
        assert_int_equal(vti_apply(&bond, 1, &pairs), VTI_OK);
        for (int n = 0; n < 200; ++n) {
            for (int64_t k = 0; k <= method->stages; ++k) {
                if (method->probe != NULL && method->probe[k] != 0) {
                    assert_int_equal(vti_step_probe(method, k, h, &pairs, &probed), VTI_OK);
                    assert_int_equal(vti_apply(&bond, 1, &probed), VTI_OK);
                }
                if (k < method->stages) {
                    assert_int_equal(vti_step_stage(method, k, h, &pairs, NULL), VTI_OK);
                    assert_int_equal(vti_apply(&bond, 1, &pairs), VTI_OK);
                }
            }
            assert_int_equal(vti_step_finish(method, h, &pairs), VTI_OK);
        }
        vti_momentum(&pairs, p1);
        vti_angular_momentum(&pairs, about, l1);
        const double noise = 200 * (double)method->stages * 64 * EPS;
        assert_close3(p1, p0, noise);
        if (method->probe == NULL) /* whose loads are those of another place */
            assert_close3(l1, l0, noise);
        assert_close(vti_energy(&bond, 1, &pairs), e0, method->order == 1 ? 0.3 * e0 : 0.05 * e0);
    }
}

/** Moments from 1e-300 to 1e300, plates, needles, near-ties in every order, spins and steps of any size. */
TEST(any_size_is_finite)
{
    rng g = rng_seed(303);
    for (int trial = 0; trial < 60000; ++trial) {
        top p = top_random(&g, (enum top_storage)(trial % TOP_STORAGES), (enum top_spin)(trial / 3 % 3));
        vti_stepper own = *vti_stepper_find("exact");
        const double unit = pow(10, trial % 4 == 0 ? uniform(&g, -290, 290) : uniform(&g, -3, 3));
        const double size = pow(10, trial % 3 == 0 ? uniform(&g, -300, 300) : uniform(&g, -2, 2));
        top_moments(&g, trial % 5 == 0 ? 1e-6 : trial % 5 == 1 ? 0.999999 : 0.01, p.moments);
        if (trial % 7 == 0)
            p.moments[trial % 3] = p.moments[(trial + 1) % 3] * (1 + EPS * rng_below(&g, 3));
        if (trial % 11 == 0)
            p.moments[trial % 3] = p.moments[(trial + 1) % 3] + p.moments[(trial + 2) % 3];
        own.law = 2 + rng_below(&g, 3);
        own.rotor = 2 * (1 + rng_below(&g, 3));
        random_unit(&g, 3, p.spin);
        for (int k = 0; k < 3; ++k) {
            p.moments[k] *= unit;
            p.spin[k] *= size;
            p.omega[k] = p.spin[k] < 1e10 && p.spin[k] > -1e10 ? p.spin[k] : 1;
            p.moment[k] = 0;
        }
        const vti_bodies body = top_bodies(&p);
        const double h = pow(10, uniform(&g, -10, 2));
        if (vti_bodies_check_values(&body, NULL) != VTI_OK)
            continue;
        assert_int_equal(vti_step_begin(&own, h, &body, NULL), VTI_OK);
        if (p.shows != TOP_OMEGA || size < 1e3) /* L of Omega may leave the range */
            assert_true(p.storage == TOP_QUAT ? all_finite(p.quat, 4) : all_finite(p.alpha, 3));
    }
}

RUN_TESTS(cmocka_unit_test_setup(views_that_do_not_go_together, sound), cmocka_unit_test_setup(principal_axes, sound),
          cmocka_unit_test_setup(one_for_all, sound), cmocka_unit_test_setup(values, sound),
          cmocka_unit_test_setup(frames_rotors_and_methods, sound), cmocka_unit_test_setup(accelerations, sound),
          cmocka_unit_test_setup(closed_needs_every_turn_below_1, sound), cmocka_unit_test(measures),
          cmocka_unit_test(bonded_pairs), cmocka_unit_test_setup(closed_looks_past_the_kicks, sound),
          cmocka_unit_test_setup(any_size_is_finite, sound))
