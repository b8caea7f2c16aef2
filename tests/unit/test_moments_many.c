/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Many bodies with moments at once are bodies one by one, in every layout, and each is looked at. */
#include "top.h"

enum { MANY = 43, ROOM = 16 * MANY };
enum { LIES_PACKED, LIES_SEPARATE, LIES_SPREAD, LIES_APART, LAYOUTS };

struct many {
    double all[7][ROOM];
};
static struct many at_once, alone;

static vti_view view_in(int layout, double *p)
{
    const vti_view views[LAYOUTS] = {vti_view_packed(p),
                                     vti_view_separate(p, p + MANY, p + 2 * MANY),
                                     {{p + 1, p + 2, p + 3}, 7, 0},
                                     {{p + 4, p + 1, p}, 6, 0}};
    return views[layout];
}

static vti_quat_view quat_in(int layout, double *p)
{
    const vti_quat_view views[LAYOUTS] = {quats_packed(p),
                                          {{p, p + MANY, p + 2 * MANY, p + 3 * MANY}, 1, 0},
                                          {{p + 1, p + 2, p + 3, p + 4}, 7, 0},
                                          {{p + 4, p + 1, p, p + 5}, 6, 0}};
    return views[layout];
}

/** Layouts of the views, what of the spin is shown, and one set of moments and axes for all or many. A trial that is a
 *  multiple of 96 shows L and alpha, all packed. */
static vti_bodies many_bodies(int trial, int pushed, struct many *m)
{
    const int layout = trial % LAYOUTS, other = trial / LAYOUTS % LAYOUTS, shows = trial / 16 % 3;
    vti_bodies all = vti_bodies_none(MANY);
    all.moments = view_in(other, m->all[0]);
    if (trial % 5 == 0)
        all.moments.stride = 0;
    if (shows != TOP_OMEGA)
        all.spin = view_in(layout, m->all[1]);
    if (shows != TOP_L)
        all.omega = view_in(other, m->all[2]);
    if (trial / 48 % 2)
        all.quat = quat_in(layout, m->all[3]);
    else
        all.alpha = view_in(layout, m->all[3]);
    if (trial % 7 < 4)
        all.principal = quat_in(other, m->all[4]);
    if (trial % 7 == 0)
        all.principal.stride = 0;
    if (pushed)
        all.moment = view_in((layout + pushed - 1) % LAYOUTS, m->all[5]);
    return all;
}

/** Some are near or past half a turn, some turn beyond measure; closed: none turns by 1, or if 2 some may. There are
 *  spheres among them, and sometimes a row of them at the start, and bodies that are spheres but for the last digits,
 *  whose turns are one about L, that may be long, and hardly any about their axes. */
static void fill(rng *g, int closed, const vti_bodies *all)
{
    const int64_t row = 8 * rng_below(g, 4);
    for (int64_t i = 0; i < MANY; ++i) {
        const double size = closed > 1 && i % 13 == 7 ? 4
                            : closed                  ? 0.3
                            : i % 13 == 7             ? 9
                            : i == 31                 ? 1e150
                            : i == 14                 ? 1e-12 /* past half a turn, and hardly on */
                            : i == 17                 ? 1e-150
                                                      : 1;
        top p = top_random(g, TOP_ALPHA, TOP_BOTH);
        const double unit = i % 19 == 12 ? 0x1p-350 : 1; /* whose cube is no number */
        const double turns = i % 33 == 5 && !closed ? ldexp(1, rng_below(g, 40)) : 0;
        for (int k = 0; k < 3; ++k)
            p.moments[k] *= unit;
        if (i % 9 == 4 || i < row)
            p.moments[2] = p.moments[1] = p.moments[0];
        for (int k = 1; k < 3 && turns > 0; ++k)
            p.moments[k] = p.moments[0] * (1 + k * 0x1p-51);
        for (int k = 0; k < 3; ++k) {
            all->moments.c[k][i * all->moments.stride] = p.moments[k];
            if (all->spin.c[0] != NULL)
                all->spin.c[k][i * all->spin.stride] = fmax(size, turns) * p.moments[k] * uniform(g, -1, 1);
            if (all->omega.c[0] != NULL)
                all->omega.c[k][i * all->omega.stride] = size * 0.5 * uniform(g, -1, 1);
            if (all->alpha.c[0] != NULL)
                all->alpha.c[k][i * all->alpha.stride] = i % 11 == 3 ? 1e12 * p.alpha[k] : p.alpha[k];
            if (all->moment.c[0] != NULL)
                all->moment.c[k][i * all->moment.stride] = 0.01 * unit * p.moment[k];
        }
        for (int k = 0; k < 4; ++k) {
            if (all->quat.xyzw[0] != NULL)
                all->quat.xyzw[k][i * all->quat.stride] = p.quat[k];
            if (all->principal.xyzw[0] != NULL)
                all->principal.xyzw[k][i * all->principal.stride] = p.principal[k];
        }
    }
}

/** A kick, the begin of a step, or the end of one with the begin of the next. */
static int push(int how, const vti_stepper *method, double h, const vti_bodies *bodies, vti_fault *fault)
{
    if (how == 0)
        return vti_kick(h, bodies);
    return how % 2 ? vti_step_begin(method, h, bodies, fault) : vti_step_next(method, h, bodies, fault);
}

/** Bodies side by side have the bits of bodies one by one: in every layout, by every law and rotor, kicked or not. */
TEST(many_are_as_one_by_one)
{
    rng g = rng_seed(306);
    int moved = 0;
    for (int trial = 0; trial < 96 * 35; ++trial) {
        vti_stepper own = *vti_stepper_find("exact");
        const int layout = trial % 4 == 3 ? 96 * (trial / 4) : trial, pushed = rng_below(&g, 3);
        own.law = 1 + rng_below(&g, 4);
        own.rotor = 2 * (1 + rng_below(&g, 3));
        static const double kicks[3][2] = {{0.5, 0.5}, {0.25, 0.75}, {0.0, 1.0}};
        own.kick = kicks[trial / 5 % 3];
        static const int64_t counts[] = {MANY, MANY, 15, 7, 3}; /* for the kernels of each width */
        vti_bodies many = many_bodies(layout, pushed, &at_once);
        const vti_bodies single = many_bodies(layout, pushed, &alone);
        fill(&g, own.law == VTI_LAW_CLOSED ? 2 : 0, &many);
        many.count = counts[trial / 2 % 5];
        alone = at_once;
        const int how = trial % 17;
        const double h = 0.05;
        vti_fault fault;
        const int status = push(how, &own, h, &many, &fault);
        if (status != VTI_OK) { /* the closed form's: nothing is written, and the body is the one */
            const vti_bodies slice = vti_bodies_slice(single, fault.body, 1);
            assert_int_equal(push(how, &own, h, &slice, NULL), VTI_E_TOO_LARGE);
            assert_memory_equal(&at_once, &alone, sizeof alone);
            continue;
        }
        ++moved;
        for (int64_t i = 0; i < many.count; ++i) {
            const vti_bodies slice = vti_bodies_slice(single, i, 1);
            assert_int_equal(push(how, &own, h, &slice, NULL), VTI_OK);
        }
        assert_same_bits(at_once.all[0], alone.all[0], sizeof alone / sizeof(double));
    }
    assert_true(moved > 96 * 30);
}

/** The bound of the closed form sees a body wherever it stands. */
TEST(the_bound_sees_every_body)
{
    rng g = rng_seed(307);
    for (int trial = 0; trial < 16 * MANY; ++trial) {
        const vti_bodies many = many_bodies(trial % 16, trial % 3, &at_once);
        const int64_t bad = trial / 16;
        vti_fault fault;
        fill(&g, 1, &many);
        assert_int_equal(vti_step_begin(vti_stepper_find("vti1"), 0.05, &many, &fault), VTI_OK);
        for (int k = 0; k < 3 && many.moments.stride != 0; ++k) { /* two are the least; |L| is past them by a little */
            many.moments.c[k][bad * many.moments.stride] = k == bad % 3 ? 2 : 1;
            many.spin.c[k][bad * many.spin.stride] = 0;
        }
        many.spin.c[1][bad * many.spin.stride] = trial % 3 == 0 && many.moments.stride != 0 ? 1.01 / 0.05
                                                 : trial % 2                                ? 1e3
                                                                                            : NAN;
        alone = at_once;
        assert_int_equal(vti_step_begin(vti_stepper_find("vti1"), 0.05, &many, &fault), VTI_E_TOO_LARGE);
        assert_int_equal(fault.body, bad);
        assert_memory_equal(&at_once, &alone, sizeof alone);
    }
}

RUN_TESTS(cmocka_unit_test(many_are_as_one_by_one), cmocka_unit_test(the_bound_sees_every_body))
