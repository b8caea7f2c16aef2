/* SPDX-License-Identifier: BSD-3-Clause
 * The table of steppers: vti_step.c makes the objects from it, vti_status.c the text that names them. */
#ifndef VTI_STEPPERS_H
#define VTI_STEPPERS_H

/* ROW(name, law, frame, order, reversible, symplectic, stages, evals, lag, reach, kick, drift, probe, about,
 * estimate_order, estimates, estimate, rotor) for each */
/* clang-format off */
#define VTI_STEPPERS(ROW)                                                                                              \
    ROW("vti1", VTI_LAW_CLOSED, VTI_FRAME_SPACE, 2, 1, 1, 1, 1, 0.0, 2.0, half_half, one_none, NULL,                   \
        "VTI-1: variational, closed form, h|Omega| < 1", 0, 0, NULL, 2)                                                \
    ROW("vti2", VTI_LAW_CAYLEY, VTI_FRAME_SPACE, 2, 1, 1, 1, 1, 0.0, 2.0, half_half, one_none, NULL,                   \
        "VTI-2: variational, a la velocity Verlet", 0, 0, NULL, 2)                                                     \
    ROW("vti3", VTI_LAW_CAYLEY, VTI_FRAME_SPACE, 1, 0, 1, 1, 1, 0.0, 2.0, one_none, one_none, NULL,                    \
        "VTI-3: variational, a la symplectic Euler", 0, 0, NULL, 2)                                                    \
    ROW("vti3-leapfrog", VTI_LAW_CAYLEY, VTI_FRAME_SPACE, 2, 1, 1, 1, 1, 0.5, 2.0, one_none, one_none, NULL,           \
        "VTI-3 started and read with half kicks: VTI-2 in leapfrog form", 0, 0, NULL, 2)                               \
    ROW("vti1-body", VTI_LAW_CLOSED, VTI_FRAME_BODY, 2, 1, 1, 1, 1, 0.0, 2.0, half_half, one_none, NULL,               \
        "VTI-1 with omega = R^T Omega and M in the body's frame, for hosts that keep those", 0, 0, NULL, 2)        \
    ROW("exact", VTI_LAW_EXACT, VTI_FRAME_SPACE, 2, 1, 1, 1, 1, 0.0, 2.0, half_half, one_none, NULL,                   \
        "velocity Verlet with the exact drift", 0, 0, NULL, 4)                                                         \
    ROW("suzuki4", VTI_LAW_EXACT, VTI_FRAME_SPACE, 4, 1, 1, 5, 5, 0.0, 2.72097, suzuki4_kick, suzuki4_drift, NULL,     \
        "composition of five steps of exact (Suzuki 1990)", 0, 0, NULL, 2)                                             \
    ROW("kl6", VTI_LAW_EXACT, VTI_FRAME_SPACE, 6, 1, 1, 9, 9, 0.0, 2.53262, kl6_kick, kl6_drift, NULL,                 \
        "composition of nine steps of exact (Kahan and Li 1997)", 0, 0, NULL, 2)                                       \
    ROW("kl8", VTI_LAW_EXACT9, VTI_FRAME_SPACE, 8, 1, 1, 17, 17, 0.0, 3.09643, kl8_kick, kl8_drift, NULL,              \
        "composition of seventeen steps of exact (Kahan and Li 1997)", 0, 0, NULL, 2)                                  \
    ROW("srkn6", VTI_LAW_EXACT, VTI_FRAME_SPACE, 4, 1, 1, 6, 6, 0.0, 3.16346, srkn6_kick, srkn6_drift, NULL,           \
        "Runge-Kutta-Nystroem splitting, six stages (Blanes and Moan 2002)", 3, 3, srkn6_estimate, 4)                  \
    ROW("srkn11", VTI_LAW_EXACT, VTI_FRAME_SPACE, 6, 1, 1, 11, 11, 0.0, 3.14143, srkn11_kick, srkn11_drift, NULL,      \
        "Runge-Kutta-Nystroem splitting, eleven stages (Blanes and Moan 2002)", 5, 2, srkn11_estimate, 6)              \
    ROW("srkn14", VTI_LAW_EXACT, VTI_FRAME_SPACE, 6, 1, 1, 14, 14, 0.0, 3.14092, srkn14_kick, srkn14_drift, NULL,      \
        "Runge-Kutta-Nystroem splitting, fourteen stages, begins with a drift (Blanes and Moan 2002)",                 \
        5, 3, srkn14_estimate, 6)                                                                                      \
    ROW("chin4", VTI_LAW_EXACT, VTI_FRAME_SPACE, 4, 1, 0, 2, 3, 0.0, 3.46410, chin4_kick, chin4_drift, chin4_probe,    \
        "positive coefficients and a force gradient, by one more evaluation (Chin 1997)", 0, 0, NULL, 4)
/* clang-format on */

#endif
