/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Velocity Verlet on quaternions, by bits of fault: what hosts get wrong. Without a bit it is right. */
#ifndef VTI_TESTS_FAULTY_H
#define VTI_TESTS_FAULTY_H

#include "vti_check.h"

enum fault {
    OLD_VELOCITY = 1 << 0,     /* x += h v before the kick that should precede it */
    OLD_SPIN = 1 << 1,         /* the same of rotation */
    NO_FIRST_HALF = 1 << 2,    /* the first half kick is left out */
    NOT_PRIMED = 1 << 3,       /* the first half kick is by forces that are still 0 */
    WRONG_SIDE = 1 << 4,       /* q dq for dq q */
    BODY_SPIN = 1 << 5,        /* the spin is kept in the body's frame, and kicked by the spatial moment */
    BODY_MOMENT = 1 << 6,      /* the moment is turned into the body's frame, the spin is not */
    ADDED_TURNS = 1 << 7,      /* rotation vectors are added up */
    NOT_NORMALISED = 1 << 8,   /* q += h/2 (0, omega) q, and no more */
    WRONG_SIGN = 1 << 9,       /* of the moment */
    PREVIOUS_MOMENT = 1 << 10, /* the second half kick of spins is by the moment of the step before */
    TWICE = 1 << 11,           /* every kick of velocities and spins */
    LATE = 1 << 12,            /* kick h, drift h */
    EARLY = 1 << 13,           /* drift h, kick h */
    EULER = 1 << 14,           /* drift by old velocities, kick by old forces */
    NO_INERTIA = 1 << 15,      /* the moment is not divided by J */
    MASS_FOR_INERTIA = 1 << 16,
    INVERSE_ATTITUDE = 1 << 17,  /* the quaternion is taken as space to body */
    GRAVITY = 1 << 18,           /* of 9.81 along -z on every body */
    REFUSES_HALF_TURN = 1 << 19, /* a Rodrigues vector that overflows: NaN at pi */
    NO_FORCE = 1 << 20,
    PREVIOUS_FORCE = 1 << 22,
    NO_ROTATION = 1 << 23,       /* attitudes and spins stay as they are */
    STALE = 1 << 24,             /* both half kicks are by the loads of the step before */
    FROZEN = 1 << 25,            /* loads are those of the start for ever */
    W_FIRST = 1 << 26,           /* quaternions are taken as w, x, y, z */
    SWAPPED_FORCE = 1 << 27,     /* its x and y */
    BODY_FORCE = 1 << 28,        /* the force is turned into the body's frame */
    FORCE_BY_MASS = 1 << 29,     /* divided by the square of the mass */
    NAN_NEAR_HALF_TURN = 1 << 30 /* what is given back after 12 or 13 steps is NaN there */
};

/** What a host does. Factors by which it is wrong; 0 stands for 1. */
struct faulty {
    int bits;                            /* of enum fault */
    double force, moment, mass, inertia; /* loads, and what they are divided by */
    double turn, flight, step;           /* of attitudes, of positions, of everything */
    double own_step;                     /* for h */
    double lost_v, lost_w;               /* what velocities and spins lose of themselves in every step */
    double drag[2];                      /* spins lose |omega|^2 (drag[0] h + drag[1] h^2) of themselves, too */
    int more_steps;                      /* than are asked for */
};

/** A vti_check_advance; self points to a struct faulty. */
int faulty_advance(void *self, double h, int64_t steps, int64_t n, double *x, double *v, double *quat, double *omega,
                   const double *mass, const double *inertia, vti_check_forces *forces, void *kit);

#endif
