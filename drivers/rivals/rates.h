/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The continuous equations of a course as one state vector, for methods that are made for any ordinary differential
 * equation:
 *
 *     x' = v,  v' = F/m,  q' = (1/2) Omega q,  Omega' = RM/J
 *
 * or, of bodies of three moments, Euler's equations for Omega'.
 * A state is blocks of all bodies, of what the model has: x [n][3], v [n][3], q [n][4], Omega [n][3]. Forces are
 * written to where v' and Omega' stand, so nothing is copied. */
#ifndef VTI_RATES_H
#define VTI_RATES_H

#include "rivals.h"

/** Doubles per body of a state, at most; and of one in the room of rates_room. */
enum { RATES_WIDTH = 13, RATES_ROOM = 16 };

/** Doubles of a state. */
int64_t rates_width(const struct course *course);
/** The same rounded up to whole blocks of eight, for sums over states. */
int64_t rates_room(const struct course *course);
/** Where the velocities begin; 0 if nothing translates. */
int64_t rates_velocities(const struct course *course);
/** The course's bodies as a state. */
void rates_start(const struct course *course, double *state);
/** Makes the course's bodies views of the state. */
void rates_look_at(struct course *course, const double *state);
/** Angular momenta as they follow from Omega, of bodies of three moments. */
void rates_momenta(struct course *course);
/** Shows the course where its memory is a state (struct rival, show). */
void rates_show(struct course *course);
/** The same, and what the course moves is the state. */
void rates_live_in(struct course *course, double *state);
/** The derivative of a state. One force evaluation; returns its status. */
int rates(struct course *course, const double *state, double *rate);
/** Normalises the quaternions of a state. */
void rates_normalise(const struct course *course, double *state);
/** x += t v, and attitudes turn by exp(t Omega). */
void rates_drift(const struct course *course, double t);

/** So many steps, each of which returns a status; the first that is not VTI_OK ends them. */
VTI_INLINE int rates_steps(struct course *course, int64_t steps, int (*step)(struct course *course))
{
    int status = VTI_OK;
    for (int64_t k = 0; k < steps && status == VTI_OK; ++k) {
        status = step(course);
        course->steps += status == VTI_OK;
    }
    return status;
}

#endif
