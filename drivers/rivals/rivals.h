/* SPDX-License-Identifier: BSD-3-Clause
 * All rivals, one or a few to a file. */
#ifndef VTI_RIVALS_H
#define VTI_RIVALS_H

#include "rival.h"

/** Among the statuses of the core and of models: an implicit equation was not solved; bodies come to turn so much more
 *  slowly that no next step can be chosen; t is so large that the next step would not change it; a step is so much
 *  shorter than h that nobody would see the end of one of h; the shortest step, at the time fault.value, does not keep
 *  the tolerance. */
enum {
    RIVAL_E_DIVERGES = -2000,
    RIVAL_E_SPARSE = -2001,
    RIVAL_E_LATE = -2002,
    RIVAL_E_FINE = -2003,
    RIVAL_E_SHORT = -2004
};

extern const struct rival rival_quat_euler, rival_mercury, rival_lammps;                /* normalised.c */
extern const struct rival rival_yade_exp_verlet, rival_yade_leapfrog, rival_spiral;     /* exponential.c */
extern const struct rival rival_omelyan;                                                /* normalised.c */
extern const struct rival rival_campello, rival_campello_0, rival_campello_1;           /* campello.c */
extern const struct rival rival_lgvi;                                                   /* lgvi.c */
extern const struct rival rival_rk4, rival_pd8, rival_dop853, rival_vern9;              /* runge_kutta.c */
extern const struct rival rival_dop853_adaptive;                                        /* dop853.c */
extern const struct rival rival_abm4, rival_abm6, rival_abm8, rival_abm10, rival_abm12; /* adams.c */
extern const struct rival rival_gear;                                                   /* adams.c */
extern const struct rival rival_gbs8, rival_gbs12, rival_verlet_x8, rival_verlet_x12;   /* extrapolation.c */
extern const struct rival rival_pefrl, rival_takahashi_imada;                           /* compositions.c */
extern const struct rival rival_rk8pd, rival_rk8pd_adaptive;                            /* rk8pd.c */

/* Of bodies of three moments, in inertia/. */
extern const struct rival rival_asphere, rival_fincham, rival_yade_aspherical;             /* quaternions.c */
extern const struct rival rival_no_squish, rival_buss;                                     /* rotations.c */
extern const struct rival rival_moser_veselov, rival_moser_veselov_newton, rival_midpoint; /* moser_veselov.c */
extern const struct rival rival_spiral_body;                                               /* spiral.c */

#endif
