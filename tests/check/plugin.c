/* SPDX-License-Identifier: BSD-3-Clause
 * A shared library as a user would give it to vti-check: functions without a self. */
#include "faulty.h"

vti_check_advance right, old_spin, still, still_and_late;

int right(void *self, double h, int64_t steps, int64_t n, double *x, double *v, double *quat, double *omega,
          const double *mass, const double *inertia, vti_check_forces *forces, void *kit)
{
    struct faulty fault = {.bits = 0};
    (void)self;
    return faulty_advance(&fault, h, steps, n, x, v, quat, omega, mass, inertia, forces, kit);
}

int old_spin(void *self, double h, int64_t steps, int64_t n, double *x, double *v, double *quat, double *omega,
             const double *mass, const double *inertia, vti_check_forces *forces, void *kit)
{
    struct faulty fault = {.bits = OLD_SPIN};
    (void)self;
    return faulty_advance(&fault, h, steps, n, x, v, quat, omega, mass, inertia, forces, kit);
}

int still(void *self, double h, int64_t steps, int64_t n, double *x, double *v, double *quat, double *omega,
          const double *mass, const double *inertia, vti_check_forces *forces, void *kit)
{
    struct faulty fault = {.bits = NO_ROTATION};
    (void)self;
    return faulty_advance(&fault, h, steps, n, x, v, quat, omega, mass, inertia, forces, kit);
}

int still_and_late(void *self, double h, int64_t steps, int64_t n, double *x, double *v, double *quat, double *omega,
                   const double *mass, const double *inertia, vti_check_forces *forces, void *kit)
{
    struct faulty fault = {.bits = NO_ROTATION | LATE};
    (void)self;
    return faulty_advance(&fault, h, steps, n, x, v, quat, omega, mass, inertia, forces, kit);
}
