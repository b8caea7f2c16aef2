/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The bound on the step of effects on the spheres of clumps: equal to the limit in closed form, and never above that of
 * the eigenvalues of the whole, at rest and under load. */
#include "hessian.h"
#include "troop.h"

static troop t;
static web w;

static double bound(const vti_effect *effect, const vti_deformation *at)
{
    double scratch[CROWD_MAX];
    const vti_bodies b = crowd_bodies(&t.c);
    vti_stable stable = {NAN, 0, 0, 0, 0};
    assert_int_equal(vti_stable_step(effect, 1, &b, at, scratch, &stable), VTI_OK);
    return stable.h;
}

static const vti_deformation rest;

/** Two clumps of one sphere each, held by a spring across their levers: omega^2 = K/L^2 sum (1/m + |rho|^2/J). */
TEST(lever_in_closed_form)
{
    rng g = rng_seed(4121);
    for (int trial = 0; trial < 100; ++trial) {
        troop_draw(&t, &g, 2, 0, 1, CROWD_ALPHA, CROWD_ALPHA);
        crowd_clear(&t.s, 2, CROWD_ALPHA);
        double sum = 0;
        for (int i = 0; i < 2; ++i) {
            const double x[3] = {2 * i, 0, 0}, across[3] = {0, uniform(&g, -1, 1), uniform(&g, -1, 1)};
            memset(t.c.alpha[i], 0, sizeof t.c.alpha[i]);
            memcpy(t.c.x[i], x, sizeof x);
            memcpy(t.offset[i], across, sizeof across);
            t.body[i] = i;
            sum += 1 / t.c.mass[i] + vti_dot(across, across) / t.c.inertia[i];
        }
        for (int k = 1; k < 3; ++k) { /* so that the spring lies along x */
            t.c.x[0][k] = -t.offset[0][k];
            t.c.x[1][k] = -t.offset[1][k];
        }
        troop_link(&t);
        const vti_bodies b = crowd_bodies(&t.c);
        vti_clumps_spread(&t.clumps, &b);
        web_grow(&w, &g, &t.s, 0, 0.1, 100);
        web_terms(&w, 1, AXIAL, 0);
        const vti_effect bonds = vti_bonds_effect(&w.bonds);
        const vti_clumped clumped = {&t.clumps, &bonds};
        const vti_effect effect = vti_clumped_effect(&clumped);
        const double limit = 2 / sqrt(w.axial[0] / 4 * sum);
        assert_close(bound(&effect, &rest), limit, 16 * EPS * limit);
    }
}

/** Bonds of all terms between spheres anywhere in their bodies, at rest: never above the limit; and it is not far
 *  below, or a bound that is 0 would pass. */
TEST(bonds_at_rest)
{
    double nearest = 0;
    rng g = rng_seed(4122);
    for (int trial = 0; trial < 7 * 15; ++trial) {
        troop_draw(&t, &g, 4, 0, 1, CROWD_ALPHA, trial & 1 ? CROWD_QUAT : CROWD_ALPHA);
        memset(t.c.alpha, 0, sizeof t.c.alpha); /* at rest bonds are neither bent nor twisted */
        crowd_clear(&t.s, 8, t.s.storage);
        for (int s = 0; s < 8; ++s) {
            t.body[s] = s / 2;
            random_vector(&g, 0.4, t.offset[s]);
        }
        troop_link(&t);
        const vti_bodies b = crowd_bodies(&t.c);
        vti_clumps_spread(&t.clumps, &b);
        const int64_t count = web_grow(&w, &g, &t.s, 0, 1, 20); /* bonds inside a body among them, which hold nothing */
        web_terms(&w, count, 1 + trial % 7, trial % 7 >= 3 ? VTI_SHEAR_OBJECTIVE : 0);
        const vti_effect bonds = vti_bonds_effect(&w.bonds);
        const vti_clumped clumped = {&t.clumps, &bonds};
        const vti_effect effect = vti_clumped_effect(&clumped);
        const double h = bound(&effect, &rest), limit = crowd_limit(&t.c, &effect, 1);
        assert_below(h, limit * (1 + HESSIAN_ERROR));
        assert_below(bound(&effect, NULL), limit * (1 + HESSIAN_ERROR));
        nearest = fmax(nearest, h / limit);
    }
    assert_true(nearest > 0.7);
}

/** One bond of shear and moment between spheres far from the centres of bodies of any inertia: there bodies turn as
 *  they shear, which the bound takes by halves. */
TEST(levers_that_shear)
{
    rng g = rng_seed(4125);
    double nearest = 0;
    for (int trial = 0; trial < 300; ++trial) {
        troop_draw(&t, &g, 2, 0, 1, CROWD_ALPHA, CROWD_ALPHA);
        memset(t.c.alpha, 0, sizeof t.c.alpha);
        crowd_clear(&t.s, 2, CROWD_ALPHA);
        for (int i = 0; i < 2; ++i) {
            t.body[i] = i;
            random_vector(&g, 1, t.offset[i]);
            t.c.mass[i] = pow(10, uniform(&g, 0, 3));
            t.c.inertia[i] = pow(10, uniform(&g, -1, 1));
        }
        troop_link(&t);
        const vti_bodies b = crowd_bodies(&t.c);
        vti_clumps_spread(&t.clumps, &b);
        web_grow(&w, &g, &t.s, 0, 1, 20);
        web_terms(&w, 1, trial & 1 ? SHEAR : SHEAR | MOMENT, VTI_SHEAR_OBJECTIVE);
        const vti_effect bonds = vti_bonds_effect(&w.bonds);
        const vti_clumped clumped = {&t.clumps, &bonds};
        const vti_effect effect = vti_clumped_effect(&clumped);
        const double h = bound(&effect, &rest), limit = crowd_limit(&t.c, &effect, 1);
        assert_below(h, limit * (1 + HESSIAN_ERROR));
        nearest = fmax(nearest, h / limit);
        t.body[1] = 0; /* inside of one body nothing moves */
        const vti_clumped rigid = {&t.clumps, &bonds};
        const vti_effect still = vti_clumped_effect(&rigid);
        t.clumps.spheres.force = vti_view_none();
        assert_true(isinf(bound(&still, &rest)));
    }
    assert_true(nearest > 0.9);
}

/** Contacts that push where they are: the pull on a lever holds or upsets its body, too. */
TEST(contacts_under_load)
{
    double nearest = 0;
    rng g = rng_seed(4123);
    for (int trial = 0; trial < 100; ++trial) {
        troop_draw(&t, &g, 4, 4, 0.5, CROWD_ALPHA, CROWD_ALPHA);
        const vti_effect contact = vti_contacts_effect(&t.contacts);
        const vti_clumped clumped = {&t.clumps, &contact};
        const vti_effect effect = vti_clumped_effect(&clumped);
        const double limit = crowd_limit(&t.c, &effect, 1), h = bound(&effect, NULL);
        const vti_deformation deep = {1, 0, 0}; /* no overlap is deeper than all of L */
        assert_below(h, limit * (1 + 1e-5));    /* Hertz has no third derivative where spheres just touch */
        assert_below(bound(&effect, &deep), limit * (1 + 1e-5));
        nearest = isfinite(limit) ? fmax(nearest, h / limit) : nearest;
    }
    assert_true(nearest > 0.4);
}

static int cannot(const void *self, const vti_bodies *b, const vti_deformation *at, vti_spring_visit *visit,
                  void *context)
{
    (void)self, (void)b, (void)at, (void)visit, (void)context;
    return VTI_E_CONTACT;
}

static int64_t hold(const void *self, const vti_bodies *b)
{
    (void)self, (void)b;
    return 0;
}

static int missing(const void *self, const vti_bodies *b, const vti_deformation *at, vti_spring_visit *visit,
                   void *context)
{
    const vti_spring *s = self;
    (void)b, (void)at;
    visit(context, s);
    return VTI_OK;
}

static void nothing(const void *self, const vti_bodies *b)
{
    (void)self, (void)b;
}

/** An effect whose springs are to spheres that are not there is refused, as one whose springs are to bodies that are
 *  not; one that does not report them, or whose report fails, has no bound; without forces of spheres, the springs are
 *  all. */
TEST(springs_that_are_not_there)
{
    double scratch[CROWD_MAX];
    rng g = rng_seed(4124);
    vti_stable stable;
    troop_draw(&t, &g, 3, 0, 0.5, CROWD_ALPHA, CROWD_ALPHA);
    crowd_clear(&t.s, 3, CROWD_ALPHA);
    for (int s = 0; s < 3; ++s) {
        t.body[s] = s;
        random_vector(&g, 0.3, t.offset[s]);
    }
    troop_link(&t);
    const vti_bodies b = crowd_bodies(&t.c);
    vti_spring spring = {.i = 3, .j = -1, .length = 1, .axial = 1};
    vti_effect inner = {.name = "missing", .apply = nothing, .springs = missing, .self = &spring};
    const vti_clumped clumped = {&t.clumps, &inner};
    vti_effect effect = vti_clumped_effect(&clumped);
    assert_int_equal(vti_stable_step(&effect, 1, &b, &rest, scratch, &stable), VTI_E_BOND);
    spring.i = -1;
    assert_int_equal(vti_stable_step(&effect, 1, &b, &rest, scratch, &stable), VTI_E_BOND);
    spring.i = 0;
    spring.j = 3;
    assert_int_equal(vti_stable_step(&effect, 1, &b, &rest, scratch, &stable), VTI_E_BOND);
    spring.j = -1; /* to a place that does not move, with and without a pull */
    const double rho = vti_norm(t.offset[0]), a = 1 / t.c.mass[0] + rho * rho / t.c.inertia[0];
    assert_close(bound(&effect, &rest), 2 / sqrt(a), 16 * EPS * 2 / sqrt(a));
    static double moments[CROWD_MAX][3]; /* of three moments it is the smallest that turns most easily */
    for (int i = 0; i < 3; ++i) {
        moments[i][i] = t.c.inertia[0];
        moments[i][(i + 1) % 3] = moments[i][(i + 2) % 3] = 1.5 * t.c.inertia[0];
    }
    vti_bodies turned = crowd_bodies(&t.c);
    const vti_scalars none = {NULL, 0, 0};
    turned.inertia = none;
    turned.moments = vti_view_packed(moments[0]);
    turned.spin = turned.omega;
    turned.omega = vti_view_none();
    for (spring.i = 0; spring.i < 3; ++spring.i) {
        const double far = vti_norm(t.offset[spring.i]), most = 1 / t.c.mass[spring.i] + far * far / t.c.inertia[0];
        assert_int_equal(vti_stable_step(&effect, 1, &turned, &rest, scratch, &stable), VTI_OK);
        assert_close(stable.h, 2 / sqrt(most), 16 * EPS * 2 / sqrt(most));
    }
    spring.i = 0;
    const vti_deformation strained = {0, 0.5, 0};
    assert_true(bound(&effect, &strained) < 2 / sqrt(a));
    spring.j = 1;
    for (int side = 0; side < 2; ++side) { /* it pulls at the lever of either body */
        const double kept[3] = {t.offset[side][0], t.offset[side][1], t.offset[side][2]};
        memset(t.offset[side], 0, sizeof t.offset[side]);
        assert_true(bound(&effect, &strained) < 0.999 * bound(&effect, &rest));
        memcpy(t.offset[side], kept, sizeof kept);
    }
    spring.j = -1;
    t.clumps.spheres.force = vti_view_none();
    assert_close(bound(&effect, &rest), 2 / sqrt(a), 16 * EPS * 2 / sqrt(a));
    inner.apply = NULL; /* nor are there forces of what only breaks */
    inner.rupture = hold;
    t.clumps.spheres = crowd_bodies(&t.s);
    effect = vti_clumped_effect(&clumped);
    assert_close(bound(&effect, &rest), 2 / sqrt(a), 16 * EPS * 2 / sqrt(a));
    inner.springs = cannot;
    effect = vti_clumped_effect(&clumped);
    assert_int_equal(vti_stable_step(&effect, 1, &b, &rest, scratch, &stable), VTI_E_CONTACT);
    inner.springs = NULL;
    effect = vti_clumped_effect(&clumped);
    assert_int_equal(vti_stable_step(&effect, 1, &b, &rest, scratch, &stable), VTI_OK);
    inner.apply = nothing;
    effect = vti_clumped_effect(&clumped);
    assert_int_equal(vti_stable_step(&effect, 1, &b, &rest, scratch, &stable), VTI_E_SPRINGS);
}

RUN_TESTS(cmocka_unit_test(lever_in_closed_form), cmocka_unit_test(bonds_at_rest), cmocka_unit_test(levers_that_shear),
          cmocka_unit_test(contacts_under_load), cmocka_unit_test(springs_that_are_not_there))
