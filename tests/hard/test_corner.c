/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Very many bodies on top of each other in a corner, with the list of neighbours that a program has: it holds every
 * pair, the forces are finite and balanced, and a step within the stable one keeps the energy. */
#include "hard.h"
#include "neighbours.h"

enum { MANY = 100000, HEAP = 3000, STEPS = 20 };

static double x[MANY][3], v[MANY][3], force[MANY][3], scratch[MANY];
static const double one = 1, planes[3][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};

static vti_bodies bodies(int64_t n)
{
    vti_bodies b = vti_bodies_none(n);
    b.x = vti_view_packed(x[0]);
    b.v = vti_view_packed(v[0]);
    b.force = vti_view_packed(force[0]);
    b.mass = vti_scalars_one(&one);
    return b;
}

/** The pairs of the list into *contacts. */
static void find(struct neighbours *list, const vti_bodies *b, vti_contacts *contacts)
{
    struct message message;
    if (neighbours_update(list, &b->x, &message) < 0)
        fail_msg("%s", message.text);
    contacts->count = list->count;
    contacts->pair = list->pair;
}

/** Of a few bodies, every pair that touches is in the list: by brute force. */
static void assert_pairs(const struct neighbours *list, int64_t n)
{
    for (int64_t i = 0; i < n; i += n / 20) {
        int64_t there = 0, touching = 0;
        for (int64_t k = 0; k < list->count; ++k) {
            const int64_t p = list->pair[2 * k], q = list->pair[2 * k + 1];
            const double d[3] = {x[p][0] - x[q][0], x[p][1] - x[q][1], x[p][2] - x[q][2]};
            there += (p == i || q == i) && vti_dot(d, d) < 1;
        }
        for (int64_t j = 0; j < n; ++j) {
            const double d[3] = {x[i][0] - x[j][0], x[i][1] - x[j][1], x[i][2] - x[j][2]};
            touching += j != i && vti_dot(d, d) < 1;
        }
        assert_int_equal(there, touching);
    }
}

/** Twice as many as there is room for: 1e5 spheres of the diameter 1 in a cube of the side 36. */
TEST(many_in_a_corner)
{
    rng g = rng_seed(91);
    for (int i = 0; i < MANY; ++i)
        for (int k = 0; k < 3; ++k)
            x[i][k] = uniform(&g, 0, 36);
    const vti_bodies b = bodies(MANY);
    const vti_scalars diameter = vti_scalars_one(&one);
    struct neighbours list;
    struct message message;
    vti_contacts contacts = {.count = 0, .pair = NULL, .diameter = diameter, .stiffness = 1000};
    const vti_walls walls = {.count = 3, .plane = planes[0], .diameter = diameter, .stiffness = 1000};
    const vti_effect effects[2] = {vti_contacts_effect(&contacts), vti_walls_effect(&walls)};
    if (neighbours_create(&list, MANY, &diameter, 0, 0, NULL, &message) != 0)
        fail_msg("%s", message.text);
    find(&list, &b, &contacts);
    assert_pairs(&list, MANY);
    double sum[3] = {0, 0, 0};
    const vti_deformation at = {1, 0, 0};
    vti_stable stable;
    assert_int_equal(vti_stable_step(effects, 2, &b, &at, scratch, &stable), VTI_OK);
    vti_apply(effects, 1, &b);
    for (int i = 0; i < MANY; ++i)
        for (int k = 0; k < 3; ++k)
            sum[k] += force[i][k];
    for (int k = 0; k < 3; ++k) /* 1e6 forces of up to 1000 that cancel */
        assert_close(sum[k], 0, 1000 * EPS * 1e6);
    const double start = vti_energy(effects, 2, &b);
    vti_apply(effects, 2, &b);
    for (int i = 0; i < STEPS; ++i) {
        assert_int_equal(vti_step_begin(vti_stepper_find("vti2"), 0.2 * stable.h, &b, NULL), VTI_OK);
        find(&list, &b, &contacts);
        vti_apply(effects, 2, &b);
        vti_step_finish(vti_stepper_find("vti2"), 0.2 * stable.h, &b);
    }
    print_message("%d bodies, %.1f pairs each, E %.6g to %.6g\n", MANY, (double)list.count / MANY, start,
                  vti_energy(effects, 2, &b));
    assert_true(all_finite(x[0], 3 * MANY) && all_finite(v[0], 3 * MANY));
    assert_close(vti_energy(effects, 2, &b), start, 0.01 * start); /* (h omega)^2/4 with h omega <= 0.2 */
    neighbours_destroy(&list);
    robust("1e5 bodies in a corner, twice what there is room for", "contact, wall and pair search",
           "every pair found; energy kept to 1 %% at 0.2 of the stable step");
}

/** All of them at one place: n (n - 1)/2 pairs, and none with a direction; the wall pushes them all. */
TEST(heap)
{
    const vti_bodies b = bodies(HEAP);
    const vti_scalars diameter = vti_scalars_one(&one);
    struct neighbours list;
    struct message message;
    vti_contacts contacts = {.count = 0, .pair = NULL, .diameter = diameter, .stiffness = 1000};
    const vti_effect effect = vti_contacts_effect(&contacts);
    memset(x, 0, sizeof x);
    memset(v, 0, sizeof v);
    if (neighbours_create(&list, HEAP, &diameter, 0, 0, NULL, &message) != 0)
        fail_msg("%s", message.text);
    find(&list, &b, &contacts);
    assert_int_equal(list.count, HEAP * (HEAP - 1) / 2);
    vti_apply(&effect, 1, &b);
    for (int i = 0; i < HEAP; ++i)
        assert_true(force[i][0] == 0 && force[i][1] == 0 && force[i][2] == 0);
    x[7][2] = NAN;
    assert_int_equal(neighbours_update(&list, &b.x, &message), -1);
    assert_non_null(strstr(message.text, "body 7"));
    neighbours_destroy(&list);
    robust("3000 bodies at one place", "contact and pair search", "defined: all pairs found, no direction, no force");
    robust("NaN in a position", "pair search", "reported, the body named");
}

RUN_TESTS(cmocka_unit_test(many_in_a_corner), cmocka_unit_test(heap))
