/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Every status that the interface names is what some call returns, and says what to do in a sentence of its own. */
#include "hard.h"

#define COUNT(constant, value, text) +1
enum { LOWEST = -(0 VTI_STATUSES(COUNT)) };

static crowd c;
static vti_fault fault;

/** One sound step, spoiled in one way for each status. */
static int reached(int status)
{
    static const double zero = 0, negative = -1;
    vti_sum lost[VTI_DRAG_BOOKS];
    vti_drag drag = {.lost = lost};
    vti_held held = {.i = 1, .j = 2};
    int64_t slot[3] = {0};
    vti_history history = {.slots = 3, .held = &held, .slot = slot};
    vti_past past = {NULL, 1, 0};
    vti_control control;
    const vti_stepper *const vti1 = vti_stepper_find("vti1");
    crowd_clear(&c, 2, CROWD_ALPHA);
    vti_bodies b = crowd_bodies(&c);
    vti_stepper own = *vti1;
    vti_effect effect;
    memset(&effect, 0, sizeof effect);
    const int64_t pair[2] = {0, 1};
    const vti_contacts contacts = {.count = 1, .pair = pair, .diameter = vti_scalars_one(&c.mass[0]), .stiffness = 1};
    const vti_clumps clumps = {.count = 2, .body = pair, .base = 1, .offset = c.x[0], .spheres = crowd_bodies(&c)};
    double rest[4];
    vti_stable stable;
    switch (status) {
    case VTI_E_NULL:
        return vti_step_begin(vti1, 0.1, NULL, &fault);
    case VTI_E_ABI:
        b.abi = VTI_ABI + 1;
        break;
    case VTI_E_COUNT:
        b.count = -1;
        break;
    case VTI_E_VIEW:
        b.x.c[2] = NULL;
        break;
    case VTI_E_STRIDE:
        b.x.stride = 0;
        break;
    case VTI_E_ALIAS:
        b.v = b.x;
        break;
    case VTI_E_TIME:
        return vti_step_begin(vti1, 0, &b, &fault);
    case VTI_E_MASS:
        b.mass = vti_scalars_one(&zero);
        break;
    case VTI_E_INERTIA:
        b.inertia = vti_scalars_one(&zero);
        break;
    case VTI_E_TOO_LARGE:
        c.omega[1][0] = 10;
        break;
    case VTI_E_STAGE:
        return vti_step_stage(vti1, 1, 0.1, &b, &fault);
    case VTI_E_STEPPER:
        own.law = 0;
        return vti_step_begin(&own, 0.1, &b, &fault);
    case VTI_E_FRAME:
        own.frame = 0;
        return vti_step_begin(&own, 0.1, &b, &fault);
    case VTI_E_BOND:
        return vti_bonds_rest(1, pair, 0, &b.x, rest, &fault);
    case VTI_E_STATE:
        c.omega[1][2] = INFINITY;
        return vti_bodies_check_values(&b, &fault);
    case VTI_E_CONTACT:
        return vti_contacts_check(&contacts, 1, &fault);
    case VTI_E_SPRINGS:
        effect = vti_contacts_effect(&contacts);
        effect.springs = NULL;
        return vti_stable_step(&effect, 1, &b, NULL, rest, &stable);
    case VTI_E_NEEDS:
        effect = vti_contacts_effect(&contacts);
        b.x = vti_view_none();
        return vti_effects_check(&effect, 1, &b, &fault);
    case VTI_E_DISSIPATES:
        effect = vti_contacts_effect(&contacts);
        effect.dissipates = 1;
        return vti_step_check(vti_stepper_find("srkn11"), &effect, 1);
    case VTI_E_DAMPING:
        drag.linear = vti_scalars_one(&negative);
        effect = vti_drag_effect(&drag);
        return vti_effects_check(&effect, 1, &b, &fault);
    case VTI_E_PAST:
        return vti_multistep_record(&past, &b);
    case VTI_E_CONTROL:
        return vti_control_start(vti_stepper_find("srkn11"), 0, 0.1, &control);
    case VTI_E_HISTORY:
        return vti_history_add(&history, &held);
    case VTI_E_MOMENTS:
        b.spin = b.omega;
        b.omega = vti_view_none();
        return vti_step_begin(vti1, 0.1, &b, &fault);
    case VTI_E_CLUMP:
        return vti_clumps_check(&clumps, 1, &fault);
    default:
        break;
    }
    return vti_step_begin(vti1, 0.1, &b, &fault);
}

/** The quantity that the spoiled step names. */
static int64_t named(int status)
{
    switch (status) {
    case VTI_E_VIEW:
    case VTI_E_STRIDE:
    case VTI_E_NEEDS:
        return VTI_QUANTITY_X;
    case VTI_E_ALIAS:
        return VTI_QUANTITY_V;
    case VTI_E_MASS:
        return VTI_QUANTITY_MASS;
    case VTI_E_INERTIA:
        return VTI_QUANTITY_INERTIA;
    case VTI_E_TOO_LARGE:
    case VTI_E_STATE:
        return VTI_QUANTITY_OMEGA;
    case VTI_E_MOMENTS:
        return VTI_QUANTITY_MOMENTS;
    default:
        return VTI_QUANTITY_NONE;
    }
}

TEST(every_status)
{
    int count = 0;
    for (int status = LOWEST; status <= VTI_OK; ++status, ++count) {
        fault.quantity = status == VTI_E_DISSIPATES || status == VTI_E_SPRINGS || status == VTI_E_HISTORY ||
                                 status == VTI_E_PAST || status == VTI_E_CONTROL
                             ? VTI_QUANTITY_NONE
                             : -7; /* those calls have no fault to fill */
        assert_int_equal(reached(status), status);
        assert_int_equal(fault.quantity, named(status));
        if (status == VTI_E_TOO_LARGE)
            assert_int_equal(fault.body, 1);
        for (int other = LOWEST; other < status; ++other)
            assert_string_not_equal(vti_status_text(status), vti_status_text(other));
        if (status != VTI_OK) /* what is wrong; what to do about it */
            assert_non_null(strstr(vti_status_text(status), "; "));
    }
    /* the list ends here: whatever follows has no text yet, and no test either */
    assert_string_equal(vti_status_text(LOWEST - 1), vti_status_text(1));
    robust("every status code", "C interface", "%d of %d reached by a call, each with a sentence of its own", count,
           count);
}

RUN_TESTS(cmocka_unit_test(every_status))
