/* SPDX-License-Identifier: BSD-3-Clause
 *
 * How a host plays any stepper: its stages, the forces of its probes, and what is left after the last. */
#ifndef VTI_TESTS_PLAY_H
#define VTI_TESTS_PLAY_H

#include "support.h"

/** Writes force and moment of the bodies where they are. */
typedef void load(void *self, const vti_bodies *b);

static inline void play_probe(const vti_stepper *method, int64_t k, double h, const vti_bodies *b,
                              const vti_bodies *probed, load *forces, void *self)
{
    if (method->probe == NULL || method->probe[k] == 0.0)
        return;
    assert_int_equal(vti_step_probe(method, k, h, b, probed), VTI_OK);
    forces(self, probed);
}

/** One step. The forces of its first kick are there already: none are needed by a stepper that ends with a drift,
 *  because it begins with one. probed has x and attitude of its own, and the force and moment of b. */
static inline void play_step(const vti_stepper *method, double h, const vti_bodies *b, const vti_bodies *probed,
                             load *forces, void *self)
{
    for (int64_t k = 0; k < method->stages; ++k) {
        play_probe(method, k, h, b, probed, forces, self);
        const int status = vti_step_stage(method, k, h, b, NULL);
        if (status != VTI_OK)
            fail_msg("%s refuses stage %d at h = %g: %s", method->name, (int)k, h, vti_status_text(status));
        forces(self, b);
    }
    play_probe(method, method->stages, h, b, probed, forces, self);
    assert_int_equal(vti_step_finish(method, h, b), VTI_OK);
}

#endif
