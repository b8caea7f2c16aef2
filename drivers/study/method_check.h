/* SPDX-License-Identifier: BSD-3-Clause
 * A stepper of the core, or a rival, as a host of the conformance kit. */
#ifndef VTI_METHOD_CHECK_H
#define VTI_METHOD_CHECK_H

#include "travel.h"
#include "vti_check.h"

/** A vti_check_advance whose self is a vti_stepper, of the core or a rival's. Returns 0, or -1 if the method
 *  refuses. */
int method_check_advance(void *self, double h, int64_t steps, int64_t n, double *x, double *v, double *quat,
                         double *omega, const double *mass, const double *inertia, vti_check_forces *forces, void *kit);
/** The same of bodies of three moments (vti_check_run_inertia): spin is L. */
int method_check_advance_inertia(void *self, double h, int64_t steps, int64_t n, double *x, double *v, double *quat,
                                 double *spin, const double *mass, const double *moments, vti_check_forces *forces,
                                 void *kit);

#endif
