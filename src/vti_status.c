/* SPDX-License-Identifier: BSD-3-Clause
 * Texts of statuses and quantities, and the version. */
#include "vti.h"
#include "vti_processor.h"
#include "vti_steppers.h"

/* all names of the table of steppers, as one text */
#define NAME(name, ...) name ", "
#define VTI_STEPPER_NAMES VTI_STEPPERS(NAME)

const char *vti_status_text(int status)
{
#define TEXT(constant, value, text)                                                                                    \
    case constant:                                                                                                     \
        return text;
    switch (status) {
    case VTI_OK:
        return "no error";
        VTI_STATUSES(TEXT)
    default:
        return "unknown status; it does not come from this library";
    }
}

const char *vti_quantity_text(int64_t quantity)
{
#define MEMBER(constant, number, member, type, role)                                                                   \
    case constant:                                                                                                     \
        return #member;
    switch (quantity) {
        VTI_QUANTITIES(MEMBER)
    default:
        return "value";
    }
}

const char *vti_vector_units(void)
{
    return vti_serves_avx512() ? "AVX-512 and AVX2" : vti_serves_avx2() ? "AVX2" : "those of the build";
}

const char *vti_version(void)
{
    return VTI_VERSION_STRING;
}
