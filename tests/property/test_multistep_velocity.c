/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Forces that depend on velocities: AN(K, c) takes them at the velocities that it foresees, and keeps its order K + 1.
 * A charged, damped sphere in a field B along z has a closed form. With z' = (v_x + i v_y)' = (-c + i b) z and
 * v_z' = -c v_z,
 *
 *     F/m = -c v + b e_z x v,        v(t) = exp(-c t) R(b t e_z) v_0,  x(t) = x_0 + integral of v
 *     RM/J = b e_z x Omega,          Omega(t) = R(b t e_z) Omega_0,  R(t) = R(b t e_z) R(t (Omega_0 - b e_z)) */
#include <complex.h>

#include "support.h"

static const double damping = 0.4, gyration = 0.9, v0[3] = {0.7, -0.3, 0.5}, omega0[3] = {0.5, 0.8, -0.4};

typedef struct sphere {
    double x[3], v[3], force[3], alpha[3], omega[3], moment[3], memory[10][6];
    vti_past past;
} sphere;

static const double mass = 1.3, inertia = 0.6;

static vti_bodies bodies_of_sphere(sphere *s)
{
    vti_bodies b = vti_bodies_none(1);
    b.x = vti_view_packed(s->x);
    b.v = vti_view_packed(s->v);
    b.force = vti_view_packed(s->force);
    b.alpha = vti_view_packed(s->alpha);
    b.omega = vti_view_packed(s->omega);
    b.moment = vti_view_packed(s->moment);
    b.mass = vti_scalars_one(&mass);
    b.inertia = vti_scalars_one(&inertia);
    return b;
}

static void load(sphere *s)
{
    const double field[3] = {0.0, 0.0, gyration};
    vti_cross(field, s->v, s->force);
    vti_cross(field, s->omega, s->moment);
    for (int k = 0; k < 3; ++k) {
        s->force[k] = mass * (s->force[k] - damping * s->v[k]);
        s->moment[k] *= inertia;
    }
}

static void put_exact(sphere *s, double t)
{
    const double complex rate = -damping + I * gyration, start = v0[0] + I * v0[1], now = start * cexp(rate * t),
                         way = start * (cexp(rate * t) - 1.0) / rate,
                         spin = (omega0[0] + I * omega0[1]) * cexp(I * gyration * t);
    const double about[3] = {0.0, 0.0, gyration * t},
                 beside[3] = {t * omega0[0], t * omega0[1], t * (omega0[2] - gyration)};
    double outer[3], inner[3];
    s->v[0] = creal(now);
    s->v[1] = cimag(now);
    s->v[2] = v0[2] * exp(-damping * t);
    s->x[0] = creal(way);
    s->x[1] = cimag(way);
    s->x[2] = v0[2] * (1.0 - exp(-damping * t)) / damping;
    s->omega[0] = creal(spin);
    s->omega[1] = cimag(spin);
    s->omega[2] = omega0[2];
    vti_rrv_from_rotvec(about, outer);
    vti_rrv_from_rotvec(beside, inner);
    vti_rrv_compose(inner, outer, s->alpha);
}

/** At t = 4 in steps of h, the first K - 1 of which are exact: how far from the closed form, of motion and turning. */
static void fly(const vti_multistep *m, double h, double error[2])
{
    sphere s = {.past = {NULL, m->depth, 0}}, exact;
    const vti_bodies b = bodies_of_sphere(&s);
    const int steps = (int)lround(4.0 / h);
    s.past.memory = s.memory[0];
    for (int k = 0; k < steps; ++k) {
        if (k < m->depth) {
            put_exact(&s, k * h);
            load(&s);
            assert_int_equal(vti_multistep_record(&s.past, &b), VTI_OK);
        }
        if (k < m->depth - 1)
            continue;
        assert_int_equal(vti_multistep_predict(m, h, &s.past, &b, NULL), VTI_OK);
        load(&s);
        assert_int_equal(vti_multistep_correct(m, h, &s.past, &b), VTI_OK);
    }
    put_exact(&exact, 4.0);
    error[0] = 0.0;
    error[1] = vti_rrv_distance(s.alpha, exact.alpha);
    for (int k = 0; k < 3; ++k) {
        error[0] = fmax(error[0], fmax(fabs(s.x[k] - exact.x[k]), fabs(s.v[k] - exact.v[k])));
        error[1] = fmax(error[1], fabs(s.omega[k] - exact.omega[k]));
    }
}

/** Of an7 and above the steps that are stable, below, leave rounding alone. */
static void orders(void **state)
{
    (void)state;
    static const double coarse[] = {0.1, 0.02, 0.004, 0.0025, 0.0025};
    for (int64_t k = 0; k < vti_multistep_count(); ++k) {
        const vti_multistep *m = vti_multistep_at(k);
        const double expected = (double)m->depth + (m->u == 0.0);
        double error[2][2];
        for (int level = 0; level < 2; ++level)
            fly(m, coarse[k] / (level + 1), error[level]);
        for (int part = 0; part < 2; ++part) {
            const double order = log2(error[0][part] / error[1][part]);
            print_message("%s: errors %.2e, %.2e, order %.2f\n", m->name, error[0][part], error[1][part], order);
            if (m->depth < 7)
                assert_true(order > expected - 0.6 && order < expected + 1.0);
            else /* so many steps, at most, one rounding each */
                assert_true(fmax(error[0][part], error[1][part]) < 1600 * EPS);
        }
    }
}

/** |v| of v' = -v, after many steps from a past that excites all roots, or as soon as it is huge. */
static double size_after(const vti_multistep *m, double h)
{
    double x[3] = {0.0}, v[3] = {1.0, 0.0, 0.0}, f[3] = {0.0}, memory[10][6];
    const double one = 1.0;
    vti_bodies b = vti_bodies_none(1);
    vti_past past = {memory[0], m->depth, 0};
    b.x = vti_view_packed(x);
    b.v = vti_view_packed(v);
    b.force = vti_view_packed(f);
    b.mass = vti_scalars_one(&one);
    for (int k = 0; k < m->depth; ++k) {
        f[0] = k % 2 == 0 ? 1.0 : -0.5;
        assert_int_equal(vti_multistep_record(&past, &b), VTI_OK);
    }
    for (int k = 0; k < 40000 && fabs(v[0]) < 1e6; ++k) {
        assert_int_equal(vti_multistep_predict(m, h, &past, &b, NULL), VTI_OK);
        f[0] = -v[0];
        assert_int_equal(vti_multistep_correct(m, h, &past, &b), VTI_OK);
    }
    return fabs(v[0]);
}

/** As vti_multistep.h has it: h times a rate of damping is far less than h times a frequency may be. */
static void reaches(void **state)
{
    (void)state;
    static const double reach[] = {0.17, 0.024, 0.0075, 0.0033, 0.0033};
    for (int64_t k = 0; k < vti_multistep_count(); ++k) {
        const vti_multistep *m = vti_multistep_at(k);
        const double below = size_after(m, 0.93 * reach[k]), above = size_after(m, 1.1 * reach[k]);
        print_message("%s: |v| = %.2g below its reach, %.2g above\n", m->name, below, above);
        assert_true(below < 1e-6);
        assert_true(above >= 1e6);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(orders), cmocka_unit_test(reaches)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
