/* SPDX-License-Identifier: BSD-3-Clause
 * Texts of statuses and quantities, and the version. */
#include "vti_internal.h"
#include "vti_steppers.h"

/** All names of the table of steppers, as one text. */
#define NAME(name, ...) name ", "
#define NAMES VTI_STEPPERS(NAME)

static const struct {
    int status;
    const char *text;
} texts[] = {
    {VTI_OK, "no error"},
    {VTI_E_NULL, "a required argument is NULL; pass bodies, lists and effects that exist"},
    {VTI_E_ABI, "the bodies were made with another version of vti.h than this library; recompile against its header"},
    {VTI_E_COUNT,
     "a number of bodies, effects or values is negative, neither 1 nor n, or more than a view shows; correct it"},
    {VTI_E_VIEW,
     "a view is given in part, or the attitude both as alpha and as a quaternion; give all components or none"},
    {VTI_E_STRIDE,
     "a view of more than one body has stride 0, or one by which its components meet; give the distance of "
     "consecutive bodies in doubles"},
    {VTI_E_ALIAS, "two views, or two components of one, share memory; give each quantity its own"},
    {VTI_E_TIME, "the time step is not finite, or not positive where it must be; pass a finite h > 0"},
    {VTI_E_MASS, "mass is missing, not finite or not positive; give one value or one for each body, > 0"},
    {VTI_E_INERTIA, "inertia is missing, not finite or not positive; give one value or one for each body, > 0"},
    {VTI_E_TOO_LARGE,
     "a body turns too far for the closed form: h|Omega| < 1 is needed; reduce h, or use vti2, which has no limit"},
    {VTI_E_STAGE, "the stepper has no such stage; use 0 <= k < stages"},
    {VTI_E_STEPPER,
     "there is no such stepper or drift law, or it has more stages than the packed calls can play; known steppers "
     "are " NAMES "as vti_stepper_at lists them"},
    {VTI_E_FRAME, "there is no such frame; use VTI_FRAME_SPACE or VTI_FRAME_BODY"},
    {VTI_E_BOND, "a bond is not between two different bodies that exist at different places, or a stiffness of it is "
                 "negative or not finite, or there is no such form of shear; mend that bond"},
    {VTI_E_DISSIPATES, "the stepper steps back in time, which turns dissipation into gain; use one without negative "
                       "coefficients: vti2, exact or chin4"},
    {VTI_E_CONTACT,
     "a contact is not between two different bodies that exist, or a diameter is not positive and finite, "
     "or the stiffness negative or not finite; mend that pair"},
    {VTI_E_STATE,
     "a position, velocity, attitude or spin is not finite, or a quaternion is zero; set all of them before "
     "the first step, an unturned quaternion to real part 1"},
    {VTI_E_SPRINGS, "an effect does not report its springs, so that the stable step has no bound; give it springs, "
                    "vti_springs_none if its force does not change with position, or leave it out to bound the others"},
};

const char *vti_status_text(int status)
{
    for (unsigned i = 0; i < sizeof texts / sizeof texts[0]; ++i)
        if (texts[i].status == status)
            return texts[i].text;
    return "unknown status; it does not come from this library";
}

const char *vti_quantity_text(int64_t quantity)
{
    static const char *const members[] = {[VTI_QUANTITY_NONE] = "value",
                                          [VTI_QUANTITY_X] = "x",
                                          [VTI_QUANTITY_V] = "v",
                                          [VTI_QUANTITY_FORCE] = "force",
                                          [VTI_QUANTITY_ALPHA] = "alpha",
                                          [VTI_QUANTITY_QUAT] = "quat",
                                          [VTI_QUANTITY_OMEGA] = "omega",
                                          [VTI_QUANTITY_MOMENT] = "moment",
                                          [VTI_QUANTITY_MASS] = "mass",
                                          [VTI_QUANTITY_INERTIA] = "inertia",
                                          [VTI_QUANTITY_X_LOW] = "x_low",
                                          [VTI_QUANTITY_V_LOW] = "v_low",
                                          [VTI_QUANTITY_ALPHA_LOW] = "alpha_low",
                                          [VTI_QUANTITY_OMEGA_LOW] = "omega_low"};
    const int known = quantity >= 0 && quantity < (int64_t)(sizeof members / sizeof members[0]);
    return members[known ? quantity : VTI_QUANTITY_NONE];
}

const char *vti_vector_units(void)
{
    return vti_serves_avx512() ? "AVX-512 and AVX2" : vti_serves_avx2() ? "AVX2" : "those of the build";
}

const char *vti_version(void)
{
    return VTI_VERSION_STRING;
}
