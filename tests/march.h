/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A multistep method, played on bodies whose forces are there at the start: its first steps are taken by kl8 in parts
 * so small that what they err by is rounding. */
#ifndef VTI_TESTS_MARCH_H
#define VTI_TESTS_MARCH_H

#include "play.h"

enum { MARCH_DEPTH = 10 };

static inline void march_start(const vti_multistep *m, double h, vti_past *past, const vti_bodies *b, load *forces,
                               void *self)
{
    enum { PARTS = 8 };
    while (past->known < m->depth - 1) {
        assert_int_equal(vti_multistep_record(past, b), VTI_OK);
        for (int k = 0; k < PARTS; ++k)
            play_step(vti_stepper_find("kl8"), h / PARTS, b, NULL, forces, self);
    }
    assert_int_equal(vti_multistep_record(past, b), VTI_OK);
}

static inline void march_on(const vti_multistep *m, double h, int64_t steps, vti_past *past, const vti_bodies *b,
                            load *forces, void *self)
{
    for (int64_t k = 0; k < steps; ++k) {
        assert_int_equal(vti_multistep_predict(m, h, past, b, NULL), VTI_OK);
        forces(self, b);
        assert_int_equal(vti_multistep_correct(m, h, past, b), VTI_OK);
    }
}

#endif
