/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Views that share memory, told from addresses, strides and count: the mistakes that hosts make, the layouts that they
 * have, and random views against a look at every number of every body. */
#include "bodies.h"
#include "support.h"

enum { WORDS = 4096, MIDDLE = WORDS / 2 };

static double memory[WORDS];
static const double one = 1.0;

static vti_view view_of(int64_t x, int64_t y, int64_t z, int64_t stride)
{
    const vti_view view = {{memory + x, memory + y, memory + z}, stride, 0};
    return view;
}

static vti_bodies of(int64_t n, vti_view x, vti_view v)
{
    vti_bodies b = vti_bodies_none(n);
    b.x = x;
    b.v = v;
    return b;
}

static void expect(vti_bodies b, int status, int64_t quantity, const char *what)
{
    vti_fault fault;
    const int found = vti_bodies_check_values(&b, &fault);
    if (found != status || fault.quantity != quantity)
        fail_msg("%s: status %d of \"%s\", not %d of \"%s\"", what, found, vti_quantity_text(fault.quantity), status,
                 vti_quantity_text(quantity));
    assert_int_equal(vti_bodies_seal(&b), status);
}

TEST(mistakes)
{
    const vti_view none = vti_view_none(), x = vti_view_packed(memory), v = vti_view_packed(memory + 300);
    const vti_view far = vti_view_packed(memory + 900);
    const int64_t bytes = (int64_t)sizeof(double);
    expect(of(100, x, v), VTI_OK, 0, "two arrays, end to end");
    expect(of(101, x, v), VTI_E_ALIAS, VTI_QUANTITY_V, "two arrays that are too short by a body");
    expect(of(10, view_of(0, 1, 2, 1), none), VTI_E_STRIDE, VTI_QUANTITY_X, "stride 1 on x[n][3]");
    expect(of(10, view_of(0, 1, 2, -1), none), VTI_E_STRIDE, VTI_QUANTITY_X, "the same backwards");
    expect(of(1, view_of(0, 1, 2, 1), none), VTI_OK, 0, "of one body any stride will do");
    expect(of(10, far, vti_view_member(memory, 2 * bytes)), VTI_E_STRIDE, VTI_QUANTITY_V, "a member of 3 in 2 doubles");
    for (int64_t size = 3; size <= 8; ++size) /* struct {double x[3], v[3];} */
        expect(of(10, vti_view_member(memory, size * bytes), vti_view_member(memory + 3, size * bytes)),
               size < 6 ? VTI_E_ALIAS : VTI_OK, size < 6 ? VTI_QUANTITY_V : 0, "a member of a struct that is larger");
    expect(of(10, x, vti_view_packed(memory + 3)), VTI_E_ALIAS, VTI_QUANTITY_V, "v is x from the next body on");
    expect(of(10, vti_view_packed(memory + 3), x), VTI_E_ALIAS, VTI_QUANTITY_V, "x is v from the next body on");
    expect(of(1, x, vti_view_packed(memory + 3)), VTI_OK, 0, "of one body there is no next");
    /* nor is a stride looked at then, which may be 0 */
    expect(of(1, view_of(0, 1, 2, 0), view_of(2, 3, 4, 0)), VTI_E_ALIAS, VTI_QUANTITY_V, "they share z and x");
    expect(of(1, view_of(0, 2, 4, 0), view_of(1, 3, 5, 0)), VTI_OK, 0, "one between the other");
    expect(of(1, x, view_of(2, 3, 4, 0)), VTI_E_ALIAS, VTI_QUANTITY_V, "one with a stride, and one without");
    expect(of(1, view_of(2, 3, 4, 0), x), VTI_E_ALIAS, VTI_QUANTITY_V, "the other way round");
    expect(vti_bodies_slice(of(10, x, vti_view_packed(memory + 15)), 0, 5), VTI_OK, 0, "a slice before they meet");
    expect(vti_bodies_slice(of(10, x, vti_view_packed(memory + 15)), 4, 6), VTI_E_ALIAS, VTI_QUANTITY_V, "one behind");
    expect(of(10, view_of(0, 9, 18, 1), none), VTI_E_STRIDE, VTI_QUANTITY_X, "x(n,3) of one body less");
    expect(of(10, view_of(0, 10, 20, 1), view_of(29, 39, 49, 1)), VTI_E_ALIAS, VTI_QUANTITY_V,
           "columns shifted by one");
    vti_bodies b = of(10, x, v);
    b.quat = quats_packed(memory + 600);
    b.omega = vti_view_packed(memory + 637);
    b.inertia = b.mass = vti_scalars_one(&one);
    expect(b, VTI_E_ALIAS, VTI_QUANTITY_OMEGA, "strides of 4 and 3 that meet at the last quaternion");
    b.quat.stride = 3;
    expect(b, VTI_E_STRIDE, VTI_QUANTITY_QUAT, "quaternions in three doubles");
}

TEST(layouts)
{
    expect(of(10, view_of(0, 10, 20, 1), view_of(30, 40, 50, 1)), VTI_OK, 0, "x(n,3), v(n,3)");
    expect(of(10, view_of(0, 20, 40, 1), view_of(10, 30, 50, 1)), VTI_OK, 0, "x, vx, y, vy, z, vz");
    expect(of(10, view_of(0, 1, 2, 6), view_of(3, 4, 5, 6)), VTI_OK, 0, "a struct");
    expect(of(10, view_of(0, 2, 4, 6), view_of(1, 3, 5, 6)), VTI_OK, 0, "x, vx, y, vy, z, vz in a struct");
    expect(of(10, view_of(62, 61, 60, -6), view_of(65, 64, 63, -6)), VTI_OK, 0, "a struct, backwards");
    expect(of(10, view_of(0, 2, 4, 3), view_of(33, 34, 35, 3)), VTI_OK, 0,
           "components of neighbours between each other");
    expect(of(10, view_of(0, 2, 4, 6), view_of(1, 3, 5, 8)), VTI_OK, 0, "even and odd numbers in different strides");
    expect(of(10, view_of(100, 101, 102, 6), view_of(103, 104, 105, -6)), VTI_OK, 0, "one forwards, one backwards");
    expect(of(10, view_of(0, 1, 2, 6), view_of(56, 57, 58, -6)), VTI_E_ALIAS, VTI_QUANTITY_V, "... that meet");
}

/** Of two random views, which status a look at every number finds. */
static int brute_force(const vti_view *views, int64_t first, int64_t last, int64_t *quantity)
{
    static unsigned char owner[WORDS];
    memset(owner, 0, sizeof owner);
    int status = VTI_OK;
    for (unsigned char i = 0; i < 2 && status == VTI_OK; ++i) {
        int alias = 0;
        for (int k = 0; k < 3; ++k)
            for (int64_t n = first; n <= last; ++n) {
                unsigned char *o = &owner[views[i].c[k] - memory + n * views[i].stride];
                status = *o == i + 1 ? VTI_E_STRIDE : status;
                alias |= *o != 0;
                *o = (unsigned char)(i + 1);
            }
        status = status == VTI_OK && alias ? VTI_E_ALIAS : status;
        *quantity = status == VTI_OK ? VTI_QUANTITY_NONE : i == 0 ? VTI_QUANTITY_X : VTI_QUANTITY_V;
    }
    return status;
}

static int64_t between(rng *g, int64_t low, int64_t high)
{
    return low + (int64_t)(uniform(g, 0, 1) * (double)(high - low + 1));
}

TEST(random_views)
{
    rng g = rng_seed(711);
    int met[3] = {0, 0, 0};
    for (int trial = 0; trial < 200000; ++trial) {
        vti_view views[2];
        const int64_t range = between(&g, 6, 60), largest = between(&g, 1, 40);
        const int same = trial % 2;
        for (int i = 0; i < 2; ++i) {
            int64_t at[3], stride = between(&g, -largest, largest);
            stride = stride == 0 ? 3 : stride;
            for (int k = 0; k < 3; ++k)
                at[k] = MIDDLE + between(&g, 0, range);
            if (at[0] == at[1] || at[1] == at[2] || at[2] == at[0])
                at[1] = at[0] + range + 1, at[2] = at[0] + 2 * range + 2;
            views[i] = view_of(at[0], at[1], at[2], i > 0 && same ? views[0].stride : stride);
        }
        const int64_t first = between(&g, 0, 4), count = between(&g, 1, 30);
        int64_t quantity;
        const int status = brute_force(views, first, first + count - 1, &quantity);
        expect(vti_bodies_slice(of(40, views[0], views[1]), first, count), status, quantity, "random");
        ++met[status == VTI_OK ? 0 : status == VTI_E_STRIDE ? 1 : 2];
    }
    for (int k = 0; k < 3; ++k) /* each of the three was tried often */
        assert_true(met[k] > 5000);
}

/** Bodies and strides of any size neither overflow nor meet. */
TEST(extremes)
{
    const int64_t sizes[] = {1,         2,  3,  INT32_MAX,     INT64_C(1) << 40, INT64_MAX - 1,
                             INT64_MAX, -1, -3, INT64_MIN + 1, INT64_MIN};
    const int64_t counts[] = {1, 2, INT32_MAX, INT64_C(1) << 53, INT64_MAX};
    for (int i = 0; i < 11; ++i)
        for (int j = 0; j < 11; ++j)
            for (int n = 0; n < 5; ++n)
                for (int shift = 0; shift < 2; ++shift) {
                    const int64_t first = shift ? INT64_MAX - counts[n] : 0;
                    vti_bodies b = of(0, view_of(0, 1, 2, sizes[i]), view_of(9, 10, 11, sizes[j]));
                    b = vti_bodies_slice(b, first, counts[n]);
                    const int status = vti_bodies_check(&b);
                    assert_true(status == VTI_OK || status == VTI_E_STRIDE || status == VTI_E_ALIAS);
                    if (counts[n] == 1 && first == 0)
                        assert_int_equal(status, VTI_OK);
                }
}

/** A view of which the end is known shows that many bodies and no more. */
TEST(extents)
{
    vti_fault fault;
    vti_bodies b = of(10, vti_view_packed(memory), vti_view_packed(memory + 100));
    b.quat = quats_packed(memory + 200);
    b.omega = vti_view_packed(memory + 300);
    b.inertia = b.mass = vti_scalars_one(&one);
    memory[203] = 1;
    for (int i = 1; i < 10; ++i)
        memory[203 + 4 * i] = 1;
    int64_t *const counts[] = {&b.x.count, &b.v.count, &b.quat.count, &b.omega.count, &b.mass.count, &b.inertia.count};
    const int64_t quantity[] = {VTI_QUANTITY_X,     VTI_QUANTITY_V,    VTI_QUANTITY_QUAT,
                                VTI_QUANTITY_OMEGA, VTI_QUANTITY_MASS, VTI_QUANTITY_INERTIA};
    for (int k = 0; k < 6; ++k) {
        *counts[k] = 10;
        expect(b, VTI_OK, 0, "as many as there are");
        *counts[k] = 9;
        expect(b, VTI_E_COUNT, quantity[k], "one body too many");
        assert_int_equal(vti_bodies_check_values(&b, &fault), VTI_E_COUNT);
        assert_true(fault.body == -1 && fault.value == 9);
        expect(vti_bodies_slice(b, 5, 4), VTI_OK, 0, "a slice of what there is");
        expect(vti_bodies_slice(b, 6, 4), VTI_E_COUNT, quantity[k], "a slice that ends behind it");
        *counts[k] = -1;
        expect(b, VTI_E_COUNT, quantity[k], "a negative extent");
        *counts[k] = 0;
    }
}

RUN_TESTS(cmocka_unit_test(mistakes), cmocka_unit_test(layouts), cmocka_unit_test(random_views),
          cmocka_unit_test(extremes), cmocka_unit_test(extents))
