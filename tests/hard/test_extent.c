/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Index arithmetic beyond 2^31 bodies: the address range of 2^31 + 2 bodies is reserved, and only the last are
 * touched. */
#define _DEFAULT_SOURCE
#include <sys/mman.h>

#include "hard.h"

static const int64_t far = INT64_C(2147483648); /* 2^31 */

enum { VIEWS = 6, LAST = 2 };

/** The memory of n vectors of `width`, of which the last pages may be used; NULL if there is no such range. */
static double *reserve(int64_t n, int64_t width)
{
    const size_t bytes = ((size_t)(n * width) * sizeof(double) + 65535) / 65536 * 65536, tail = 2 * 65536;
    char *p = mmap(NULL, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (p == MAP_FAILED)
        return NULL;
    return mprotect(p + bytes - tail, tail, PROT_READ | PROT_WRITE) == 0 ? (double *)(void *)p : NULL;
}

static double *memory[VIEWS];
static crowd near;

static int all_reserved(void **state)
{
    (void)state;
    for (int k = 0; k < VIEWS; ++k)
        if (memory[k] == NULL)
            memory[k] = reserve(far + LAST, 3);
    return 0;
}

/** The same two bodies, near and far. */
static vti_bodies pose(void)
{
    rng g = rng_seed(81);
    vti_bodies b = vti_bodies_none(LAST);
    double(*const of[VIEWS])[3] = {near.x, near.v, near.force, near.alpha, near.omega, near.moment};
    vti_view *const views[VIEWS] = {&b.x, &b.v, &b.force, &b.alpha, &b.omega, &b.moment};
    crowd_clear(&near, LAST, CROWD_ALPHA);
    for (int k = 0; k < VIEWS; ++k) {
        for (int i = 0; i < LAST; ++i)
            random_vector(&g, 0.5, of[k][i]);
        *views[k] = vti_view_packed(memory[k]);
        memcpy(memory[k] + 3 * far, of[k], LAST * sizeof of[k][0]);
    }
    b.mass = vti_scalars_one(&near.mass[0]);
    b.inertia = vti_scalars_one(&near.inertia[0]);
    return vti_bodies_slice(b, far, LAST);
}

static void same_as_near(void)
{
    double(*const of[VIEWS])[3] = {near.x, near.v, near.force, near.alpha, near.omega, near.moment};
    for (int k = 0; k < VIEWS; ++k)
        assert_same_bits(of[k][0], memory[k] + 3 * far, 3 * LAST);
}

static void need_memory(void)
{
    for (int k = 0; k < VIEWS; ++k)
        if (memory[k] == NULL)
            skip();
}

TEST(steppers)
{
    need_memory();
    for (int64_t k = 0; k < vti_stepper_count(); ++k) {
        const vti_stepper *method = vti_stepper_at(k);
        const vti_bodies b = pose(), n = crowd_bodies(&near);
        for (int64_t s = 0; s <= method->stages; ++s)
            for (int where = 0; where < 2; ++where) {
                const vti_bodies *at = where ? &b : &n;
                assert_int_equal(s < method->stages ? vti_step_stage(method, s, 0.1, at, NULL)
                                                    : vti_step_finish(method, 0.1, at),
                                 VTI_OK);
            }
        same_as_near();
        robust("bodies from 2^31 on", method->name, "exact: to the bit as the first");
    }
}

TEST(effects)
{
    need_memory();
    const double one = 1, plane[4] = {0.6, 0, 0.8, 0}, rest[4] = {1, 0, 0, 1};
    const int64_t pairs[2][2] = {{0, 1}, {far, far + 1}};
    const vti_pendulum pendulum = {1, {0, 0.5, 1}};
    const vti_gravity gravity = {{1, 2, 3}};
    for (int base = 0; base < 2; ++base) {
        const vti_bodies b = pose(), n = crowd_bodies(&near);
        double energy[2];
        for (int where = 0; where < 2; ++where) {
            const int64_t pair[2] = {pairs[where][0] + base, pairs[where][1] + base};
            const vti_bonds bonds = {1,
                                     pair,
                                     base,
                                     rest,
                                     vti_scalars_one(&one),
                                     vti_scalars_one(&one),
                                     vti_scalars_one(&one),
                                     VTI_SHEAR_OBJECTIVE,
                                     NULL};
            const vti_contacts contacts = {
                .count = 1, .pair = pair, .base = base, .diameter = vti_scalars_one(&one), .stiffness = 10};
            const vti_walls walls = {.count = 1, .plane = plane, .diameter = vti_scalars_one(&one), .stiffness = 10};
            const vti_effect all[] = {vti_bonds_effect(&bonds), vti_contacts_effect(&contacts),
                                      vti_walls_effect(&walls), vti_gravity_effect(&gravity),
                                      vti_pendulum_effect(&pendulum)};
            vti_fault fault;
            assert_int_equal(vti_bonds_check(&bonds, pair[1] - base + 1, &fault), VTI_OK);
            assert_int_equal(vti_bonds_check(&bonds, pair[1] - base, &fault), VTI_E_BOND);
            assert_int_equal(vti_apply(all, 5, where ? &b : &n), VTI_OK);
            energy[where] = vti_energy(all, 5, where ? &b : &n);
        }
        assert_same_bits(&energy[0], &energy[1], 1);
        same_as_near();
    }
    static const char *const who[] = {"binder", "contact", "wall", "gravity", "pendulum"};
    for (int k = 0; k < 5; ++k)
        robust("bodies from 2^31 on", who[k], "exact: to the bit as the first");
}

/** And what has no memory at all is seen to be too much. */
TEST(counts)
{
    vti_bodies b = vti_bodies_none(far + 1);
    assert_int_equal(vti_bodies_check(&b), VTI_OK); /* no views, nothing to touch */
    b = vti_bodies_slice(b, INT64_MAX - 1, 2);
    assert_int_equal(vti_bodies_check(&b), VTI_E_COUNT);
    robust("first + count beyond 2^63", "all calls", "reported: %s", vti_status_text(VTI_E_COUNT));
}

RUN_TESTS(cmocka_unit_test_setup(steppers, all_reserved), cmocka_unit_test_setup(effects, all_reserved),
          cmocka_unit_test(counts))
