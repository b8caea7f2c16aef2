/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Views: every layout of the caller's memory and every division into slices gives the same bits, what is between the
 * elements of a view is never written, and what is absent is neither moved nor missed. */
#include "support.h"

enum { N = 700, STEPS = 3, QUANTITIES = 10, ROOM = 9 * N + 8 };
enum { X, V, FORCE, ALPHA, OMEGA, MOMENT, X_LOW, V_LOW, ALPHA_LOW, OMEGA_LOW };
enum layout { PACKED, SEPARATE, MEMBER, GAPS, MIXED, LAYOUTS };

#define GUARD 1.2345678901234567e-89

/** Bodies of n in one of the layouts, with guards wherever no view points. */
typedef struct store {
    double memory[QUANTITIES][ROOM], quat[ROOM], mass[N], inertia[N];
    vti_view view[QUANTITIES];
    vti_bodies b;
} store;

static store one_store, other_store;

static vti_view view_in(enum layout layout, int q, double *p)
{
    const vti_view gaps = {{p + 4, p + 2, p}, 7, 0};
    switch (layout == MIXED ? (q * 5 + q / 3) % 4 : (int)layout) {
    case PACKED:
        return vti_view_packed(p);
    case SEPARATE:
        return vti_view_separate(p, p + N, p + 2 * N);
    case MEMBER:
        return vti_view_member(p + 1, 5 * (int64_t)sizeof(double));
    default:
        return gaps;
    }
}

/** The same random state whatever the layout. */
static void fill(store *s, enum layout layout, int one_mass, int quat, int residuals)
{
    rng g = rng_seed(11);
    for (int q = 0; q < QUANTITIES; ++q) {
        for (int i = 0; i < ROOM; ++i)
            s->memory[q][i] = GUARD;
        s->view[q] = view_in(layout, q, s->memory[q]);
    }
    for (int i = 0; i < ROOM; ++i)
        s->quat[i] = GUARD;
    s->b = vti_bodies_none(N);
    s->b.quat.stride = layout == SEPARATE ? 1 : layout == PACKED ? 4 : 9;
    for (int k = 0; quat && k < 4; ++k)
        s->b.quat.xyzw[k] = s->quat + (layout == SEPARATE ? k * N : layout == PACKED ? k : 2 * (3 - k));
    for (int i = 0; i < N; ++i) {
        double v[3], q[4];
        for (int k = 0; k < QUANTITIES; ++k) {
            random_vector(&g, k >= X_LOW ? 0.0 : 1.0, v);
            for (int c = 0; c < 3; ++c)
                s->view[k].c[c][i * s->view[k].stride] = v[c];
        }
        random_unit(&g, 4, q);
        for (int c = 0; quat && c < 4; ++c)
            s->b.quat.xyzw[c][i * s->b.quat.stride] = q[c];
        s->mass[i] = one_mass ? 1.7 : uniform(&g, 0.5, 2);
        s->inertia[i] = one_mass ? 0.3 : uniform(&g, 0.5, 2);
    }
    s->b.x = s->view[X];
    s->b.v = s->view[V];
    s->b.force = s->view[FORCE];
    s->b.omega = s->view[OMEGA];
    s->b.moment = s->view[MOMENT];
    if (!quat)
        s->b.alpha = s->view[ALPHA];
    if (residuals) {
        s->b.x_low = s->view[X_LOW];
        s->b.v_low = s->view[V_LOW];
        s->b.omega_low = s->view[OMEGA_LOW];
        if (!quat)
            s->b.alpha_low = s->view[ALPHA_LOW];
    }
    /* one value for all must give the bits of an array of equal values: so PACKED always has the array */
    s->b.mass = one_mass && layout != PACKED ? vti_scalars_one(s->mass) : vti_scalars_array(s->mass);
    s->b.inertia = one_mass && layout != PACKED ? vti_scalars_one(s->inertia) : vti_scalars_array(s->inertia);
}

static void run(const vti_stepper *method, const vti_bodies *b)
{
    const double h = 0.125;
    for (int i = 0; i < STEPS; ++i) {
        assert_int_equal(vti_step_begin(method, h, b, NULL), VTI_OK);
        assert_int_equal(vti_step_finish(method, h, b), VTI_OK);
    }
}

static void same_state(const store *s, const store *t)
{
    for (int i = 0; i < N; ++i) {
        double p[4], r[4];
        for (int q = 0; q < QUANTITIES; ++q) {
            for (int c = 0; c < 3; ++c) {
                p[c] = s->view[q].c[c][i * s->view[q].stride];
                r[c] = t->view[q].c[c][i * t->view[q].stride];
            }
            assert_same_bits(p, r, 3);
        }
        for (int c = 0; s->b.quat.xyzw[0] != NULL && c < 4; ++c) {
            p[c] = s->b.quat.xyzw[c][i * s->b.quat.stride];
            r[c] = t->b.quat.xyzw[c][i * t->b.quat.stride];
        }
        assert_true(s->b.quat.xyzw[0] == NULL || memcmp(p, r, sizeof p) == 0);
    }
}

/** All but the 3 N (or 4 N) numbers of each view are guards still. */
static void guards_stand(const store *s)
{
    for (int q = 0; q <= QUANTITIES; ++q) {
        const double *p = q < QUANTITIES ? s->memory[q] : s->quat;
        int touched = 0;
        for (int i = 0; i < ROOM; ++i)
            touched += p[i] != GUARD;
        assert_int_equal(touched, q < QUANTITIES ? 3 * N : s->b.quat.xyzw[0] != NULL ? 4 * N : 0);
    }
}

TEST(layouts_give_the_same_bits)
{
    for (int64_t k = 0; k < vti_stepper_count(); ++k)
        for (int variant = 0; variant < 8; ++variant) {
            const int one = variant & 1, quat = variant >> 1 & 1, residuals = variant >> 2;
            fill(&one_store, PACKED, one, quat, residuals);
            run(vti_stepper_at(k), &one_store.b);
            guards_stand(&one_store);
            for (int layout = SEPARATE; layout < LAYOUTS; ++layout) {
                fill(&other_store, (enum layout)layout, one, quat, residuals);
                run(vti_stepper_at(k), &other_store.b);
                same_state(&one_store, &other_store);
                guards_stand(&other_store);
            }
        }
}

TEST(slices_give_the_same_bits)
{
    const int64_t cuts[] = {0, 0, 1, 2, 255, 256, 257, 600, N};
    for (int64_t k = 0; k < vti_stepper_count(); ++k)
        for (int variant = 0; variant < 8; ++variant) {
            const enum layout layout = variant & 1 ? MIXED : PACKED;
            fill(&one_store, layout, 0, variant >> 1 & 1, variant >> 2);
            fill(&other_store, layout, 0, variant >> 1 & 1, variant >> 2);
            run(vti_stepper_at(k), &one_store.b);
            for (int piece = 0; piece < 8; ++piece) {
                const vti_bodies part = vti_bodies_slice(other_store.b, cuts[piece], cuts[piece + 1] - cuts[piece]);
                run(vti_stepper_at(k), &part);
            }
            same_state(&one_store, &other_store);
        }
}

TEST(a_slice_leaves_the_rest_alone)
{
    fill(&one_store, PACKED, 0, 0, 0);
    fill(&other_store, PACKED, 0, 0, 0);
    const vti_bodies part = vti_bodies_slice(other_store.b, 100, 300), empty = vti_bodies_slice(other_store.b, 7, 0);
    run(vti_stepper_at(0), &empty);
    same_state(&one_store, &other_store);
    run(vti_stepper_at(0), &part);
    for (int q = 0; q < 6; ++q) {
        const double *before = one_store.memory[q], *after = other_store.memory[q];
        assert_same_bits(before, after, 300);
        assert_same_bits(before + 1200, after + 1200, 3 * N - 1200);
        assert_int_equal(memcmp(before + 300, after + 300, 900 * sizeof(double)) == 0, q == FORCE || q == MOMENT);
    }
}

/** All 64 choices of present views: a quantity moves if and only if the quantity that moves it is there, and then as it
 *  does in full company. The residuals stand aside: none is given. */
TEST(absent_views_do_nothing)
{
    static store start;
    const int mover[6] = {V, FORCE, -1, OMEGA, MOMENT, -1};
    fill(&start, MIXED, 0, 0, 0);
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        fill(&one_store, MIXED, 0, 0, 0);
        run(vti_stepper_at(k), &one_store.b);
        for (int present = 0; present < 64; ++present) {
            fill(&other_store, MIXED, 0, 0, 0);
            vti_view *const views[6] = {&other_store.b.x,     &other_store.b.v,     &other_store.b.force,
                                        &other_store.b.alpha, &other_store.b.omega, &other_store.b.moment};
            for (int q = 0; q < 6; ++q)
                if (!(present >> q & 1))
                    *views[q] = vti_view_none();
            run(vti_stepper_at(k), &other_store.b);
            for (int q = 0; q < 6; ++q) {
                const int moves = mover[q] >= 0 && present >> q & 1 && present >> mover[q] & 1;
                /* x and alpha move by velocities that are those of full company only if they were kicked as there */
                const int whole = moves && (mover[mover[q]] < 0 || present >> mover[mover[q]] & 1);
                const double *now = other_store.memory[q];
                assert_int_equal(memcmp(now, start.memory[q], sizeof start.memory[q]) != 0, moves);
                assert_true(!whole || memcmp(now, one_store.memory[q], sizeof start.memory[q]) == 0);
            }
        }
    }
}

/** A double[3] in an array of structs, named by its member; and one body, for which the stride does not matter. */
TEST(struct_members_and_one_body)
{
    struct particle {
        double radius, v[3], f[3];
        int64_t id;
    } p[3] = {{1, {1, 2, 3}, {1, 1, 1}, 1}, {1, {4, 5, 6}, {2, 2, 2}, 2}, {1, {7, 8, 9}, {3, 3, 3}, 3}};
    const double mass = 0.5;
    vti_bodies b = vti_bodies_none(3);
    b.v = vti_view_member(p[0].v, sizeof p[0]);
    b.force = vti_view_member(p[0].f, sizeof p[0]);
    b.mass = vti_scalars_one(&mass);
    assert_int_equal(vti_kick(0.25, &b), VTI_OK);
    for (int i = 0; i < 3; ++i) {
        const double v[3] = {3 * i + 1 + 0.5 * (i + 1), 3 * i + 2 + 0.5 * (i + 1), 3 * i + 3 + 0.5 * (i + 1)};
        assert_same_bits(p[i].v, v, 3);
        assert_true(p[i].radius == 1 && p[i].id == i + 1 && p[i].f[1] == i + 1);
    }
    /* a struct whose size is no multiple of a double's cannot be walked */
    b.v = vti_view_member(p[0].v, sizeof p[0] + 4);
    assert_int_equal(vti_kick(0.25, &b), VTI_E_STRIDE);

    double v[3] = {1, 2, 3}, f[3] = {1, 1, 1};
    const double kicked[3] = {1.5, 2.5, 3.5};
    b = vti_bodies_none(1);
    b.v = vti_view_packed(v);
    b.force = vti_view_packed(f);
    b.v.stride = b.force.stride = 0;
    b.mass = vti_scalars_one(&mass);
    assert_int_equal(vti_kick(0.25, &b), VTI_OK);
    assert_same_bits(v, kicked, 3);
    b.count = 0;
    assert_int_equal(vti_kick(0.25, &b), VTI_OK);
    assert_same_bits(v, kicked, 3);
}

RUN_TESTS(cmocka_unit_test(layouts_give_the_same_bits), cmocka_unit_test(slices_give_the_same_bits),
          cmocka_unit_test(a_slice_leaves_the_rest_alone), cmocka_unit_test(absent_views_do_nothing),
          cmocka_unit_test(struct_members_and_one_body))
