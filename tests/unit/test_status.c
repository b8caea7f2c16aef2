/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Status codes: each has a text of its own, and a call that fails changes nothing. */
#include "bodies.h"
#include "every_call.h"
#include "support.h"

#define COUNT(constant, value, text) +1
enum { N = 4, DOUBLES = 3 * N, LOWEST = -(0 VTI_STATUSES(COUNT)) };

static const vti_stepper *vti1, *vti2;
static double x[DOUBLES], v[DOUBLES], f[DOUBLES], a[DOUBLES], w[DOUBLES], m[DOUBLES], mass[N], inertia[N], quat_[4 * N];
static double zero[DOUBLES];
static vti_bodies b, sound_bodies;

/** Sound bodies at rest; every test spoils a copy. */
static int sound(void **state)
{
    (void)state;
    vti1 = vti_stepper_find("vti1");
    vti2 = vti_stepper_find("vti2");
    b = sound_bodies = bodies_packed(N, x, v, f, a, NULL, w, m, mass, inertia);
    for (int i = 0; i < N; ++i)
        mass[i] = inertia[i] = 1.0;
    for (int i = 0; i < DOUBLES; ++i) {
        x[i] = v[i] = f[i] = a[i] = m[i] = 0.125 * (i + 1);
        w[i] = 0.05 * i;
    }
    return 0;
}

/** The members of bodies that are a vti_quantity. */
static const struct {
    int64_t quantity;
    const char *name;
    size_t offset;
} members[] = {
#define MEMBER(quantity, member)                                                                                       \
    {                                                                                                                  \
        VTI_QUANTITY_##quantity, #member, offsetof(vti_bodies, member)                                                 \
    }
    MEMBER(X, x),
    MEMBER(V, v),
    MEMBER(FORCE, force),
    MEMBER(ALPHA, alpha),
    MEMBER(QUAT, quat),
    MEMBER(OMEGA, omega),
    MEMBER(MOMENT, moment),
    MEMBER(MASS, mass),
    MEMBER(INERTIA, inertia),
    MEMBER(X_LOW, x_low),
    MEMBER(V_LOW, v_low),
    MEMBER(ALPHA_LOW, alpha_low),
    MEMBER(OMEGA_LOW, omega_low),
    MEMBER(MOMENTS, moments),
    MEMBER(SPIN, spin),
    MEMBER(PRINCIPAL, principal),
    MEMBER(SPIN_LOW, spin_low),
#undef MEMBER
};
enum { MEMBERS = sizeof members / sizeof members[0] };

static void at_fault(const vti_fault *fault, int status, int64_t body, int64_t quantity)
{
    if (fault->body != body || fault->quantity != quantity)
        fail_msg("status %d: blames \"%s\" of body %d, not \"%s\" of body %d", status,
                 vti_quantity_text(fault->quantity), (int)fault->body, vti_quantity_text(quantity), (int)body);
}

/** Every call that takes bodies refuses them with the status and, where it says more, names the quantity, and writes
 *  nothing. */
static void refused(vti_bodies bad, int status, int64_t quantity)
{
    double before[6][DOUBLES], after[6][DOUBLES];
    double *const all[6] = {x, v, f, a, w, m};
    for (int k = 0; k < 6; ++k)
        memcpy(before[k], all[k], sizeof x);
    const vti_fault stale = {7, 7, 7};
    vti_fault fault = stale;
    assert_int_equal(vti_bodies_check(&bad), status);
    assert_int_equal(vti_bodies_check_values(&bad, NULL), status);
    assert_int_equal(vti_bodies_check_values(&bad, &fault), status);
    at_fault(&fault, status, -1, quantity);
    assert_int_equal(vti_kick(0.5, &bad), status);
    assert_int_equal(vti_drift(VTI_LAW_CAYLEY, VTI_FRAME_SPACE, 0.5, &bad, NULL), status);
    fault = stale;
    assert_int_equal(vti_drift(VTI_LAW_CAYLEY, VTI_FRAME_SPACE, 0.5, &bad, &fault), status);
    at_fault(&fault, status, -1, quantity);
    fault = stale;
    assert_int_equal(vti_step_begin(vti1, 0.5, &bad, &fault), status);
    at_fault(&fault, status, -1, quantity);
    assert_int_equal(vti_step_stage(vti2, 0, 0.5, &bad, NULL), status);
    assert_int_equal(vti_step_finish(vti1, 0.5, &bad), status);
    assert_int_equal(vti_step_start(vti1, 0.5, &bad), status);
    assert_int_equal(vti_step_sync(vti1, 0.5, &bad), status);
    assert_int_equal(vti_apply(NULL, 0, &bad), status);
    every_call_refuses(&bad, &sound_bodies, status);
    for (int k = 0; k < 6; ++k)
        memcpy(after[k], all[k], sizeof x);
    assert_same_bits(before, after, 6 * DOUBLES);
}

/** What hosts are told to have room for: docs/linking.md, VTITXT. */
enum { LONGEST = 400 };

TEST(texts)
{
    for (int i = LOWEST; i <= VTI_OK; ++i) {
        assert_true(strlen(vti_status_text(i)) > 4 && strlen(vti_status_text(i)) <= LONGEST);
        assert_string_not_equal(vti_status_text(i), vti_status_text(LOWEST - 1));
        for (int j = LOWEST; j < i; ++j)
            assert_string_not_equal(vti_status_text(i), vti_status_text(j));
    }
    const int unknown[] = {1, LOWEST - 1, INT32_MAX, INT32_MIN};
    for (int i = 0; i < 4; ++i)
        assert_string_equal(vti_status_text(unknown[i]), vti_status_text(LOWEST - 1));
    assert_string_equal(vti_version(), VTI_VERSION_STRING);
    assert_non_null(strstr("AVX-512 and AVX2, those of the build", vti_vector_units()));
}

/** A quantity goes by the name of its member, and they are numbered in the order of the struct. */
TEST(quantities)
{
    for (int k = 0; k < MEMBERS; ++k) {
        assert_int_equal(members[k].quantity, k + 1);
        assert_string_equal(vti_quantity_text(k + 1), members[k].name);
        assert_true(k == 0 || members[k].offset > members[k - 1].offset);
    }
    const int64_t none[] = {VTI_QUANTITY_NONE, MEMBERS + 1, -1, INT64_MAX, INT64_MIN, (INT64_C(1) << 32) + 1};
    for (int k = 0; k < 6; ++k)
        assert_string_equal(vti_quantity_text(none[k]), "value");
}

TEST(sound_bodies_pass)
{
    vti_fault fault = {5, 5, 5};
    assert_int_equal(vti_bodies_check(&b), VTI_OK);
    assert_int_equal(vti_bodies_check_values(&b, &fault), VTI_OK);
    at_fault(&fault, VTI_OK, -1, VTI_QUANTITY_NONE);
    const vti_bodies none = vti_bodies_none(N);
    assert_int_equal(vti_bodies_check(&none), VTI_OK);
}

TEST(null)
{
    vti_fault fault;
    assert_int_equal(vti_bodies_check(NULL), VTI_E_NULL);
    assert_int_equal(vti_bodies_check_values(NULL, NULL), VTI_E_NULL);
    assert_int_equal(vti_kick(1, NULL), VTI_E_NULL);
    assert_int_equal(vti_drift(VTI_LAW_CLOSED, VTI_FRAME_SPACE, 1, NULL, &fault), VTI_E_NULL);
    assert_int_equal(vti_step_begin(vti1, 1, NULL, &fault), VTI_E_NULL);
    assert_int_equal(vti_step_probe(vti1, 0, 1, NULL, &b), VTI_E_NULL);
    assert_int_equal(vti_step_probe(vti1, 0, 1, &b, NULL), VTI_E_NULL);
    assert_int_equal(vti_step_check(vti1, NULL, 1), VTI_E_NULL);
    assert_int_equal(vti_apply(NULL, 1, &b), VTI_E_NULL);
    assert_int_equal(vti_apply(NULL, 0, NULL), VTI_E_NULL);
}

/** What vti_stepper_find gives for a name that is none is no stepper to any call, and the text says which there are. */
TEST(no_stepper)
{
    const vti_stepper *none = vti_stepper_find("vti22");
    const vti_fault stale = {7, 7, 7};
    vti_fault fault = stale;
    assert_null(none);
    assert_int_equal(vti_step_begin(none, 1, &b, &fault), VTI_E_STEPPER);
    at_fault(&fault, VTI_E_STEPPER, -1, VTI_QUANTITY_NONE);
    assert_int_equal(vti_step_stage(none, 0, 1, &b, NULL), VTI_E_STEPPER);
    assert_int_equal(vti_step_finish(none, 1, &b), VTI_E_STEPPER);
    assert_int_equal(vti_step_start(none, 1, &b), VTI_E_STEPPER);
    assert_int_equal(vti_step_sync(none, 1, &b), VTI_E_STEPPER);
    assert_int_equal(vti_step_probe(none, 0, 1, &b, &b), VTI_E_STEPPER);
    assert_int_equal(vti_step_check(none, NULL, 0), VTI_E_STEPPER);
    const char *text = vti_status_text(VTI_E_STEPPER);
    for (int64_t i = 0; i < vti_stepper_count(); ++i) {
        char entry[40];
        snprintf(entry, sizeof entry, " %s,", vti_stepper_at(i)->name);
        if (strstr(text, entry) == NULL)
            fail_msg("\"%s\" does not name %s", text, vti_stepper_at(i)->name);
    }
}

TEST(abi_and_count)
{
    vti_bodies bad = b;
    bad.abi = VTI_ABI + 1;
    refused(bad, VTI_E_ABI, VTI_QUANTITY_NONE);
    bad.abi = 0;
    refused(bad, VTI_E_ABI, VTI_QUANTITY_NONE);
    memset(&bad, 0xa5, sizeof bad);
    refused(bad, VTI_E_ABI, VTI_QUANTITY_NONE);
    refused(vti_bodies_slice(b, -1, 1), VTI_E_COUNT, VTI_QUANTITY_NONE);
    refused(vti_bodies_slice(b, 0, -1), VTI_E_COUNT, VTI_QUANTITY_NONE);
    refused(vti_bodies_slice(b, INT64_MAX, 1), VTI_E_COUNT, VTI_QUANTITY_NONE);
    assert_int_equal(vti_apply(NULL, -1, &b), VTI_E_COUNT);
    assert_int_equal(vti_step_check(vti1, NULL, -1), VTI_E_COUNT);
}

/** Those of spheres: moments and what goes with them are in test_moments.c. */
static int is_view(int k)
{
    const int64_t quantity = members[k].quantity;
    return quantity != VTI_QUANTITY_QUAT && quantity != VTI_QUANTITY_MASS && quantity != VTI_QUANTITY_INERTIA &&
           quantity < VTI_QUANTITY_MOMENTS;
}

static vti_view *view_at(vti_bodies *bodies, int k)
{
    return (vti_view *)((char *)bodies + members[k].offset);
}

/** Each of the vector views in turn, in each of the ways to spoil it. */
TEST(views)
{
    static double low[4][DOUBLES];
    b.x_low = vti_view_packed(low[0]);
    b.v_low = vti_view_packed(low[1]);
    b.alpha_low = vti_view_packed(low[2]);
    b.omega_low = vti_view_packed(low[3]);
    for (int i = 0; i < MEMBERS; ++i) {
        const int64_t quantity = members[i].quantity;
        if (!is_view(i))
            continue;
        vti_bodies bad = b;
        vti_view *view = view_at(&bad, i);
        const vti_view good = *view;
        for (int k = 0; k < 3; ++k) {
            view->c[k] = NULL;
            refused(bad, VTI_E_VIEW, quantity);
            view->c[k] = good.c[(k + 1) % 3];
            refused(bad, VTI_E_ALIAS, quantity);
            *view = good;
            view->c[k] = view->c[(k + 1) % 3] = NULL;
            refused(bad, VTI_E_VIEW, quantity);
            *view = good;
        }
        view->stride = 0;
        refused(bad, VTI_E_STRIDE, quantity);
        assert_int_equal(vti_bodies_check(&(vti_bodies){.abi = VTI_ABI, .count = 1, .x = *view}), VTI_OK);
        for (int j = 0; j < i; ++j) /* of the two, the later one */
            if (is_view(j)) {
                *view = *view_at(&b, j);
                refused(bad, VTI_E_ALIAS, quantity);
                *view = good;
                *view_at(&bad, j) = good;
                refused(bad, VTI_E_ALIAS, quantity);
                bad = b;
            }
    }
}

TEST(quaternion_views)
{
    b.quat = quats_packed(quat_);
    refused(b, VTI_E_VIEW, VTI_QUANTITY_QUAT); /* alpha and quaternion */
    b.alpha = vti_view_none();
    assert_int_equal(vti_bodies_check(&b), VTI_OK);
    vti_bodies bad = b;
    bad.alpha_low = vti_view_packed(zero);
    refused(bad, VTI_E_VIEW, VTI_QUANTITY_ALPHA_LOW);
    bad = b;
    bad.quat.stride = 0;
    refused(bad, VTI_E_STRIDE, VTI_QUANTITY_QUAT);
    bad.count = 1; /* one body has no next */
    assert_int_equal(vti_bodies_check(&bad), VTI_OK);
    for (int k = 0; k < 4; ++k) {
        bad = b;
        bad.quat.xyzw[k] = NULL;
        refused(bad, VTI_E_VIEW, VTI_QUANTITY_QUAT);
        for (int j = 0; j < k; ++j) {
            bad = b;
            bad.quat.xyzw[k] = b.quat.xyzw[j];
            refused(bad, VTI_E_ALIAS, VTI_QUANTITY_QUAT);
        }
    }
    bad = b;
    for (int k = 0; k < 4; ++k)
        bad.quat.xyzw[k] = x + k;
    refused(bad, VTI_E_ALIAS, VTI_QUANTITY_QUAT); /* two quantities on one memory */
    bad = b;
    bad.omega = vti_view_packed(quat_);
    refused(bad, VTI_E_ALIAS, VTI_QUANTITY_OMEGA);
}

TEST(masses)
{
    const double wrong[] = {0.0, -0.0, -1.0, NAN, INFINITY, -INFINITY, 1e-310}; /* the last of no finite inverse */
    for (int k = 0; k < 7; ++k) {
        vti_bodies bad = b;
        bad.mass = vti_scalars_one(&wrong[k]);
        refused(bad, VTI_E_MASS, VTI_QUANTITY_MASS);
        bad = b;
        bad.inertia = vti_scalars_one(&wrong[k]);
        refused(bad, VTI_E_INERTIA, VTI_QUANTITY_INERTIA);

        vti_fault fault;
        mass[2] = wrong[k];
        assert_int_equal(vti_bodies_check_values(&b, &fault), VTI_E_MASS);
        assert_int_equal(vti_bodies_check_values(&b, NULL), VTI_E_MASS);
        at_fault(&fault, VTI_E_MASS, 2, VTI_QUANTITY_MASS);
        assert_same_bits(&fault.value, &wrong[k], 1);
        const vti_bodies rest = vti_bodies_slice(b, 3, 1);
        assert_int_equal(vti_bodies_check_values(&rest, &fault), VTI_OK);
        bad = b;
        bad.mass = vti_scalars_one(&wrong[k]);
        assert_int_equal(vti_bodies_check_values(&bad, &fault), VTI_E_MASS);
        at_fault(&fault, VTI_E_MASS, -1, VTI_QUANTITY_MASS);
        assert_same_bits(&fault.value, &wrong[k], 1);
        fault.value = 7;
        assert_int_equal(vti_step_begin(vti2, 0.5, &bad, &fault), VTI_E_MASS);
        assert_same_bits(&fault.value, &wrong[k], 1);
        mass[2] = 1;
        inertia[3] = wrong[k];
        assert_int_equal(vti_bodies_check_values(&b, &fault), VTI_E_INERTIA);
        at_fault(&fault, VTI_E_INERTIA, 3, VTI_QUANTITY_INERTIA);
        inertia[3] = 1;
    }
    vti_bodies bad = b;
    bad.mass.p = NULL;
    refused(bad, VTI_E_MASS, VTI_QUANTITY_MASS);
    bad.force = vti_view_none(); /* nothing divides by the mass now */
    assert_int_equal(vti_bodies_check(&bad), VTI_OK);
    bad = b;
    bad.inertia.p = NULL;
    refused(bad, VTI_E_INERTIA, VTI_QUANTITY_INERTIA);
    bad.omega = vti_view_none();
    assert_int_equal(vti_bodies_check(&bad), VTI_OK);
}

/** The state before the first step: finite, and no quaternion that memory has been cleared to. Forces need not be there
 *  yet. */
TEST(states)
{
    const double wrong[] = {NAN, INFINITY, -INFINITY};
    double *const all[] = {x, v, a, w};
    const int64_t quantity[] = {VTI_QUANTITY_X, VTI_QUANTITY_V, VTI_QUANTITY_ALPHA, VTI_QUANTITY_OMEGA};
    vti_fault fault;
    for (int k = 0; k < 4; ++k)
        for (int n = 0; n < 3; ++n) {
            const double right = all[k][3 * 2 + n];
            all[k][3 * 2 + n] = wrong[n];
            assert_int_equal(vti_bodies_check_values(&b, &fault), VTI_E_STATE);
            assert_int_equal(vti_bodies_check_values(&b, NULL), VTI_E_STATE);
            at_fault(&fault, VTI_E_STATE, 2, quantity[k]);
            assert_same_bits(&fault.value, &wrong[n], 1);
            const vti_bodies others = vti_bodies_slice(b, 3, 1);
            assert_int_equal(vti_bodies_check_values(&others, &fault), VTI_OK);
            all[k][3 * 2 + n] = right;
        }
    f[0] = m[4] = NAN;
    assert_int_equal(vti_bodies_check_values(&b, &fault), VTI_OK);
    b.alpha = vti_view_none();
    b.quat = quats_packed(quat_);
    memset(quat_, 0, sizeof quat_);
    for (int i = 0; i < N; ++i) {
        assert_int_equal(vti_bodies_check_values(&b, &fault), VTI_E_STATE);
        at_fault(&fault, VTI_E_STATE, i, VTI_QUANTITY_QUAT);
        assert_true(fault.value == 0);
        quat_[4 * i + (i + 3) % 4] = i == 2 ? 0 : -1e-3;
        if (i == 2)
            quat_[4 * 2 + 1] = 1;
    }
    assert_int_equal(vti_bodies_check_values(&b, &fault), VTI_OK);
    const double lengths[] = {1e-180, -1e180, 1e-153, 1e153}; /* whose squares are no normal numbers, and are */
    for (int k = 0; k < 4; ++k) {
        quat_[4 * 2 + 1] = lengths[k];
        assert_int_equal(vti_bodies_check_values(&b, &fault), k < 2 ? VTI_E_STATE : VTI_OK);
        if (k < 2)
            at_fault(&fault, VTI_E_STATE, 2, VTI_QUANTITY_QUAT);
        assert_true(fault.value == (k < 2 ? lengths[k] : 0.0));
    }
    quat_[4 * 2 + 1] = NAN;
    assert_int_equal(vti_bodies_check_values(&b, &fault), VTI_E_STATE);
    at_fault(&fault, VTI_E_STATE, 2, VTI_QUANTITY_QUAT);
    assert_true(isnan(fault.value));
    b.quat.xyzw[0] = NULL;
    b.quat.xyzw[1] = b.quat.xyzw[2] = b.quat.xyzw[3] = NULL;
    b.x = b.v = b.omega = vti_view_none();
    assert_int_equal(vti_bodies_check_values(&b, &fault), VTI_OK);
}

/** A seal is for bodies that pass: others lose one that they had, and are looked at again. It is of one object: a copy
 *  that is given other views is looked at, whoever made it, and so is a slice. */
TEST(seal)
{
    assert_int_equal(vti_bodies_seal(NULL), VTI_E_NULL);
    assert_int_equal(vti_bodies_seal(&b), VTI_OK);
    const vti_bodies sealed = b;
    b.x.c[1] = NULL;
    assert_int_equal(vti_bodies_seal(&b), VTI_E_VIEW);
    assert_true(sealed.sealed != 0 && b.sealed == 0);
    refused(b, VTI_E_VIEW, VTI_QUANTITY_X);

    b.x.c[1] = x + 1;
    assert_int_equal(vti_bodies_seal(&b), VTI_OK);
    assert_true(vti_bodies_slice(b, 0, 1).sealed == 0); /* even if it takes the place of b */
    vti_bodies copy = b;
    copy.x.c[1] = NULL;
    refused(copy, VTI_E_VIEW, VTI_QUANTITY_X);
    copy = vti_bodies_slice(b, 0, 2);
    copy.x.count = 1;
    refused(copy, VTI_E_COUNT, VTI_QUANTITY_X);
    b.x.count = 1; /* nobody looks at the views of the object that is sealed; a kick does not use x */
    assert_int_equal(vti_kick(0, &b), VTI_OK);
    copy = b;
    assert_int_equal(vti_kick(0, &copy), VTI_E_COUNT);
}

TEST(time)
{
    const double wrong[] = {NAN, INFINITY, -INFINITY, 0.0, -1.0};
    for (int k = 0; k < 5; ++k) {
        vti_fault fault = {7, 7, 7};
        assert_int_equal(vti_step_begin(vti1, wrong[k], &b, &fault), VTI_E_TIME);
        at_fault(&fault, VTI_E_TIME, -1, VTI_QUANTITY_NONE);
        assert_same_bits(&fault.value, &wrong[k], 1);
        assert_int_equal(vti_step_stage(vti2, 0, wrong[k], &b, NULL), VTI_E_TIME);
        assert_int_equal(vti_step_finish(vti1, wrong[k], &b), VTI_E_TIME);
        assert_int_equal(vti_step_start(vti1, wrong[k], &b), VTI_E_TIME);
        assert_int_equal(vti_step_sync(vti1, wrong[k], &b), VTI_E_TIME);
        const int either_sign = k < 3 ? VTI_E_TIME : VTI_OK;
        assert_int_equal(vti_kick(wrong[k], &b), either_sign);
        assert_int_equal(vti_drift(VTI_LAW_CAYLEY, VTI_FRAME_SPACE, wrong[k], &b, NULL), either_sign);
        assert_int_equal(vti_drift(VTI_LAW_CAYLEY, VTI_FRAME_SPACE, wrong[k], &b, &fault), either_sign);
        const double said = k < 3 ? wrong[k] : 0.0; /* an h of another sign is no fault */
        assert_same_bits(&fault.value, &said, 1);
    }
}

TEST(law_frame_stage_stepper_bond)
{
    assert_int_equal(vti_drift(0, VTI_FRAME_SPACE, 0.1, &b, NULL), VTI_E_STEPPER);
    assert_int_equal(vti_drift(VTI_LAW_EXACT9 + 1, VTI_FRAME_BODY, 0.1, &b, NULL), VTI_E_STEPPER);
    assert_int_equal(vti_drift(VTI_LAW_CLOSED, 0, 0.1, &b, NULL), VTI_E_FRAME);
    assert_int_equal(vti_drift(VTI_LAW_CAYLEY, 2, 0.1, &b, NULL), VTI_E_FRAME);
    assert_int_equal(vti_step_stage(vti1, -1, 0.1, &b, NULL), VTI_E_STAGE);
    assert_int_equal(vti_step_stage(vti1, 1, 0.1, &b, NULL), VTI_E_STAGE);
    assert_int_equal(vti_step_stage(vti1, INT64_MAX, 0.1, &b, NULL), VTI_E_STAGE);
    vti_stepper own = *vti1;
    own.law = 99;
    assert_int_equal(vti_step_begin(&own, 0.1, &b, NULL), VTI_E_STEPPER);
    own = *vti1;
    own.law += INT64_C(1) << 32;
    assert_int_equal(vti_step_finish(&own, 0.1, &b), VTI_E_STEPPER);
    own = *vti1;
    own.frame = 0;
    assert_int_equal(vti_step_begin(&own, 0.1, &b, NULL), VTI_E_FRAME);
    const vti_gravity gravity = {{0, 0, 1}};
    vti_effect effect = vti_gravity_effect(&gravity);
    effect.dissipates = 1;
    assert_int_equal(vti_step_check(vti_stepper_find("kl6"), &effect, 1), VTI_E_DISSIPATES);
    vti_fault fault;
    w[4] = 20;
    assert_int_equal(vti_step_begin(vti1, 0.1, &b, &fault), VTI_E_TOO_LARGE);
    at_fault(&fault, VTI_E_TOO_LARGE, 1, VTI_QUANTITY_OMEGA);
    const int64_t pair[2] = {1, 1};
    double rest[4] = {7, 7, 7, 7};
    assert_int_equal(vti_bonds_rest(1, pair, 0, &b.x, rest, &fault), VTI_E_BOND);
    at_fault(&fault, VTI_E_BOND, 0, VTI_QUANTITY_NONE);
    assert_int_equal(vti_packed_begin(99, 0.1, N, x, v, f, a, w, m, N, mass, N, inertia, NULL, NULL), VTI_E_STEPPER);
}

RUN_TESTS(cmocka_unit_test(texts), cmocka_unit_test(quantities), cmocka_unit_test_setup(sound_bodies_pass, sound),
          cmocka_unit_test_setup(null, sound), cmocka_unit_test_setup(no_stepper, sound),
          cmocka_unit_test_setup(abi_and_count, sound), cmocka_unit_test_setup(views, sound),
          cmocka_unit_test_setup(quaternion_views, sound), cmocka_unit_test_setup(masses, sound),
          cmocka_unit_test_setup(states, sound), cmocka_unit_test_setup(seal, sound),
          cmocka_unit_test_setup(time, sound), cmocka_unit_test_setup(law_frame_stage_stepper_bond, sound))
