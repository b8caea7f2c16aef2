/* SPDX-License-Identifier: BSD-3-Clause
 * What the tests of walls share: a few spheres, planes and cylinders, with friction and dashpots. */
#ifndef VTI_TESTS_WALLS_H
#define VTI_TESTS_WALLS_H

#include "impact.h"

enum { SLOTS = 64 };

static impact m;
static vti_wall_motion motion[6];
static vti_sum work;
static vti_held entries[SLOTS];
static int64_t slots[SLOTS];
static vti_history history;
static vti_friction friction;
static vti_dashpots dashpots;
static double cylinder[2][7];

static inline const vti_stepper *vti2(void)
{
    return vti_stepper_find("vti2");
}

/** n bodies and so many planes that may move, without an effect yet. */
static inline void begin(int n, int planes, double stiffness)
{
    impact_clear(&m, n, planes, stiffness);
    m.contacts.count = 0;
    memset(motion, 0, sizeof motion);
    memset(cylinder, 0, sizeof cylinder);
    work = (vti_sum){0, 0};
}

/** Friction and dashpots of the walls alone. */
static inline void rub(void)
{
    static vti_sum lost[3];
    memset(slots, 0, sizeof slots);
    memset(lost, 0, sizeof lost);
    history = (vti_history){SLOTS, 0, 0, entries, slots};
    friction = (vti_friction){.walls = &m.walls,
                              .sliding = 0.3,
                              .stiffness = 1500,
                              .rolling = 0.05,
                              .rolling_stiffness = 40,
                              .twisting = 0.02,
                              .twisting_stiffness = 40,
                              .reach = INFINITY,
                              .history = &history,
                              .lost = lost};
    dashpots = (vti_dashpots){.walls = &m.walls,
                              .friction = &friction,
                              .zeta = 0.1,
                              .ratio = 0.5,
                              .rolling = 0.01,
                              .twisting = 0.01,
                              .reach = INFINITY,
                              .lost = m.lost};
}

static inline void move(void)
{
    m.walls.motion = motion;
    m.walls.work = &work;
}

/** A cylinder about an axis through (1/4, -1/2, 1/8), with those before it. */
static inline void inside(int which, double ax, double ay, double az, double radius)
{
    const double all[7] = {ax, ay, az, 0.25, -0.5, 0.125, radius};
    memcpy(cylinder[which], all, sizeof all);
    m.walls.cylinders = which + 1;
    m.walls.cylinder = cylinder[0];
}

#endif
