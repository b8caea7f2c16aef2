/* SPDX-License-Identifier: BSD-3-Clause */
/** @file
 *  vti.h -- explicit variational time integration of rigid spheres with rotation (Baker and Gonzalez).
 *
 *  The caller owns all memory. The library allocates nothing, prints nothing, starts no threads and keeps no state:
 *  every function may be called from any thread on bodies that no other thread touches.
 *
 *  Frame: everything is in the inertial (space) frame unless a name says "body". Omega (omega) is the spatial angular
 *  velocity, the moment the spatial torque about the body's centre, alpha the rescaled Rodrigues vector of the attitude
 *  (vti_rrv.h). Units: any consistent set; angles in radians.
 *
 *  Every function that can fail returns VTI_OK or a negative vti_status, and then has changed nothing. */
#ifndef VTI_H
#define VTI_H

#include "vti_binder.h"
#include "vti_bodies.h"
#include "vti_bond_dashpot.h"
#include "vti_clump.h"
#include "vti_contact.h"
#include "vti_control.h"
#include "vti_dashpot.h"
#include "vti_drag.h"
#include "vti_effect.h"
#include "vti_friction.h"
#include "vti_gravity.h"
#include "vti_measure.h"
#include "vti_multistep.h"
#include "vti_pendulum.h"
#include "vti_rrv.h"
#include "vti_rupture.h"
#include "vti_stable.h"
#include "vti_status.h"
#include "vti_step.h"
#include "vti_sum.h"
#include "vti_wall.h"

/** Version of this header. */
#define VTI_VERSION_STRING "0.1.0"

#ifdef __cplusplus
extern "C" {
#endif

/** VTI_VERSION_STRING of the library that is running. */
VTI_API const char *vti_version(void);
/** The vector units that its kernels use on this machine, of kick and drift and of bonds: "AVX-512 and AVX2", "AVX2",
 *  or "those of the build". The bits do not depend on them. */
VTI_API const char *vti_vector_units(void);

#ifdef __cplusplus
}
#endif

#endif
