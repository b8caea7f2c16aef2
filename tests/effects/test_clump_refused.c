/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Lists of clumps, and effects on their spheres, that are refused: with which status, and for which sphere. */
#include "troop.h"

static troop t;

static vti_bodies bodies(void)
{
    return crowd_bodies(&t.c);
}

/** Spheres have memory of their own, whatever of them is made. */
TEST(memory_of_the_bodies)
{
    rng g = rng_seed(4112);
    static const enum crowd_storage storage[] = {CROWD_ALPHA, CROWD_QUAT};
    for (int with = 0; with < 2; ++with)
        for (int k = 0; k < 7; ++k) {
            do
                troop_draw(&t, &g, 3, 3, 0.7, storage[with], storage[with]);
            while (t.clumps.count == 0);
            const vti_bodies b = bodies();
            vti_bodies *const s = &t.clumps.spheres;
            assert_int_equal(vti_clumps_spread(&t.clumps, &b), VTI_OK);
            s->x = k == 0 ? b.x : s->x;
            s->v = k == 1 ? b.v : s->v;
            s->force = k == 2 ? b.force : s->force;
            s->alpha = k == 3 ? b.alpha : s->alpha;
            s->quat = k == 4 ? b.quat : s->quat;
            s->omega = k == 5 ? b.omega : s->omega;
            s->moment = k == 6 ? b.moment : s->moment;
            const int same = k != 4 - with; /* that is absent */
            assert_int_equal(vti_clumps_spread(&t.clumps, &b), same ? VTI_E_ALIAS : VTI_OK);
            assert_int_equal(vti_clumps_gather(&t.clumps, &b), same ? VTI_E_ALIAS : VTI_OK);
            t.clumps.count = s->count = 0; /* arrays of no spheres may have any address */
            assert_int_equal(vti_clumps_spread(&t.clumps, &b), VTI_OK);
            assert_int_equal(vti_clumps_gather(&t.clumps, &b), VTI_OK);
        }
}

TEST(lists_are_refused)
{
    rng g = rng_seed(4111);
    vti_fault fault;
    troop_draw(&t, &g, 3, 0, 0.7, CROWD_ALPHA, CROWD_ALPHA);
    crowd_clear(&t.s, 4, CROWD_ALPHA);
    troop_link(&t);
    const int64_t body[4] = {1, 2, 2, 3};
    memcpy(t.body, body, sizeof body);
    t.clumps.base = 1;
    memset(t.offset, 0, sizeof t.offset);
    assert_int_equal(vti_clumps_check(&t.clumps, 3, &fault), VTI_OK);
    assert_int_equal(vti_clumps_check(&t.clumps, 2, &fault), VTI_E_CLUMP);
    assert_true(fault.body == 3 && fault.value == 3);
    assert_int_equal(vti_clumps_check(&t.clumps, -1, &fault), VTI_E_COUNT);
    t.body[0] = 0;
    assert_int_equal(vti_clumps_check(&t.clumps, 3, &fault), VTI_E_CLUMP);
    assert_true(fault.body == 0 && fault.value == 0);
    t.body[0] = 1;
    t.body[2] = 1;
    assert_int_equal(vti_clumps_check(&t.clumps, 3, &fault), VTI_E_CLUMP);
    assert_true(fault.body == 2 && fault.value == 1);
    t.body[2] = 2;
    t.offset[1][2] = INFINITY;
    assert_int_equal(vti_clumps_check(&t.clumps, 3, &fault), VTI_E_CLUMP);
    assert_true(fault.body == 1 && isinf(fault.value));
    t.offset[1][2] = 0;

    const vti_bodies b = bodies();
    assert_int_equal(vti_clumps_spheres(&t.clumps, &b).count, 4);
    const vti_bodies second = vti_bodies_slice(b, 1, 1);
    assert_int_equal(vti_clumps_spheres(&t.clumps, &second).first, 1);
    assert_int_equal(vti_clumps_spheres(&t.clumps, &second).count, 2);
    assert_int_equal(vti_clumps_spheres(&t.clumps, NULL).count, 0);
    assert_int_equal(vti_clumps_check(NULL, 3, NULL), VTI_E_NULL);
    vti_clumps bad = t.clumps;
    bad.body = NULL;
    assert_int_equal(vti_clumps_spread(&bad, &b), VTI_E_NULL);
    bad = t.clumps;
    bad.offset = NULL;
    assert_int_equal(vti_clumps_gather(&bad, &b), VTI_E_NULL);
    bad = t.clumps;
    bad.count = -1;
    assert_int_equal(vti_clumps_spread(&bad, &b), VTI_E_COUNT);
    assert_int_equal(vti_clumps_spheres(&bad, &b).count, 0);
    bad.count = 3;
    assert_int_equal(vti_clumps_gather(&bad, &b), VTI_E_COUNT);
    bad = t.clumps;
    bad.spheres.first = 1;
    assert_int_equal(vti_clumps_gather(&bad, &b), VTI_E_COUNT);
    bad.spheres.first = 0;
    bad.spheres.x.c[1] = NULL;
    assert_int_equal(vti_clumps_spread(&bad, &b), VTI_E_VIEW);
}

static void pull(const void *self, const vti_bodies *b, double time, double drift)
{
    (void)self, (void)b, (void)time, (void)drift;
}

TEST(effects_are_refused)
{
    rng g = rng_seed(4112);
    troop_draw(&t, &g, 3, 3, 0.7, CROWD_ALPHA, CROWD_ALPHA);
    vti_bodies b = bodies();
    vti_fault fault;
    vti_sum lost = {0, 0};
    vti_effect contact = vti_contacts_effect(&t.contacts);
    const vti_clumped clumped = {&t.clumps, &contact}, no_clumps = {NULL, &contact}, no_effect = {&t.clumps, NULL};
    vti_effect effect = vti_clumped_effect(&clumped);
    assert_int_equal(vti_effects_check(&effect, 1, &b, &fault), VTI_OK);
    b.alpha = vti_view_none();
    assert_int_equal(vti_clumps_spread(&t.clumps, &b), VTI_E_NEEDS);
    assert_int_equal(vti_effects_check(&effect, 1, &b, &fault), VTI_E_NEEDS);
    assert_int_equal(fault.quantity, VTI_QUANTITY_ALPHA);
    b.count = -1;
    assert_int_equal(vti_clumps_gather(&t.clumps, &b), VTI_E_COUNT);
    b = bodies();
    t.clumps.spheres.x = vti_view_none(); /* what the effect needs, the spheres must have */
    assert_int_equal(vti_effects_check(&effect, 1, &b, &fault), VTI_E_NEEDS);
    t.clumps.count = 0;
    assert_int_equal(vti_effects_check(&effect, 1, &b, &fault), VTI_E_COUNT);
    troop_link(&t);
    contact.flow = pull;
    effect = vti_clumped_effect(&clumped);
    assert_int_equal(vti_effects_check(&effect, 1, &b, &fault), VTI_E_CLUMP);
    contact.apply = NULL;
    effect = vti_clumped_effect(&clumped);
    assert_int_equal(vti_effects_check(&effect, 1, &b, &fault), VTI_E_CLUMP);
    const vti_dashpots dashpots = {.contacts = &t.contacts, .normal = 1, .reach = INFINITY, .lost = &lost};
    contact = vti_dashpots_effect(&dashpots);
    effect = vti_clumped_effect(&clumped);
    assert_int_equal(vti_effects_check(&effect, 1, &b, &fault), VTI_OK);
    b.force = b.moment = vti_view_none(); /* so that bodies by themselves need no mass */
    b.mass.p = NULL;
    assert_int_equal(vti_effects_check(&effect, 1, &b, &fault), VTI_E_MASS);
    b = bodies();
    b.moment = vti_view_none();
    b.inertia.p = NULL;
    assert_int_equal(vti_effects_check(&effect, 1, &b, &fault), VTI_E_INERTIA);
    b = bodies();
    const vti_drifted nobodys = {.t = 1, .law = VTI_LAW_EXACT, .frame = VTI_FRAME_SPACE, .clumps = &t.clumps};
    assert_int_equal(vti_effects_carry(&contact, 1, &nobodys, &t.clumps.spheres), VTI_E_NULL);
    effect = vti_clumped_effect(&no_clumps);
    assert_int_equal(vti_effects_check(&effect, 1, &b, &fault), VTI_E_NULL);
    effect = vti_clumped_effect(&no_effect);
    assert_int_equal(vti_effects_check(&effect, 1, &b, &fault), VTI_E_NULL);
    effect = vti_clumped_effect(NULL);
    assert_int_equal(vti_effects_check(&effect, 1, &b, &fault), VTI_E_NULL);
}

RUN_TESTS(cmocka_unit_test(memory_of_the_bodies), cmocka_unit_test(lists_are_refused),
          cmocka_unit_test(effects_are_refused))
