/* SPDX-License-Identifier: BSD-3-Clause
 * The coefficients of the steppers, in the order in which a step uses them. Symmetric lists are written to their middle
 * and mirrored; what the print leaves to the sum is taken from the sum. Only vti_step.c includes this. */
#ifndef VTI_COEFFICIENTS_H
#define VTI_COEFFICIENTS_H

/* ---- the paper's maps, and Verlet -------------------------------------------------------------------------------- */

static const double half_half[] = {0.5, 0.5}, one_none[] = {1.0, 0.0};

/* ---- compositions of a symmetric step S(h) = kick(h/2) drift(h) kick(h/2) ---------------------------------------- */

/* S(p h) S(p h) S((1 - 4p) h) S(p h) S(p h), p = 1/(4 - 4^(1/3)); M. Suzuki, Phys. Lett. A 146 (1990) 319 */
#define P 0.41449077179437573714
#define Q (1.0 - 4.0 * P)
static const double suzuki4_kick[] = {P / 2, P, (P + Q) / 2, (P + Q) / 2, P, P / 2};
static const double suzuki4_drift[] = {P, P, Q, P, P, 0.0};
#undef P
#undef Q

/* s9odr6a and s17odr8a of W. Kahan and R.-C. Li, Math. Comp. 66 (1997) 1089 */
#define C1 0.39216144400731413928
#define C2 0.33259913678935943860
#define C3 (-0.70624617255763935981)
#define C4 0.082213596293550800230
#define C5 (1.0 - 2.0 * (C1 + C2 + C3 + C4))
static const double kl6_kick[] = {C1 / 2,        (C1 + C2) / 2, (C2 + C3) / 2, (C3 + C4) / 2, (C4 + C5) / 2,
                                  (C4 + C5) / 2, (C3 + C4) / 2, (C2 + C3) / 2, (C1 + C2) / 2, C1 / 2};
static const double kl6_drift[] = {C1, C2, C3, C4, C5, C4, C3, C2, C1, 0.0};
#undef C1
#undef C2
#undef C3
#undef C4
#undef C5

#define C1 0.13020248308889008088
#define C2 0.56116298177510838456
#define C3 (-0.38947496264484728641)
#define C4 0.15884190655515560090
#define C5 (-0.39590389413323757734)
#define C6 0.18453964097831570709
#define C7 0.25837438768632204729
#define C8 0.29501172360931029887
#define C9 (1.0 - 2.0 * (C1 + C2 + C3 + C4 + C5 + C6 + C7 + C8))
static const double kl8_kick[] = {C1 / 2,        (C1 + C2) / 2, (C2 + C3) / 2, (C3 + C4) / 2, (C4 + C5) / 2,
                                  (C5 + C6) / 2, (C6 + C7) / 2, (C7 + C8) / 2, (C8 + C9) / 2, (C8 + C9) / 2,
                                  (C7 + C8) / 2, (C6 + C7) / 2, (C5 + C6) / 2, (C4 + C5) / 2, (C3 + C4) / 2,
                                  (C2 + C3) / 2, (C1 + C2) / 2, C1 / 2};
static const double kl8_drift[] = {C1, C2, C3, C4, C5, C6, C7, C8, C9, C8, C7, C6, C5, C4, C3, C2, C1, 0.0};
#undef C1
#undef C2
#undef C3
#undef C4
#undef C5
#undef C6
#undef C7
#undef C8
#undef C9

/* ---- Runge-Kutta-Nystroem splittings, S. Blanes and P. C. Moan, J. Comput. Appl. Math. 142 (2002) 313 ------------ */

/* SRKN6b, order 4 */
#define B1 0.0829844064174052
#define B2 0.396309801498368
#define B3 (-0.0390563049223486)
#define B4 (1.0 - 2.0 * (B1 + B2 + B3))
#define A1 0.245298957184271
#define A2 0.604872665711080
#define A3 (0.5 - (A1 + A2))
static const double srkn6_kick[] = {B1, B2, B3, B4, B3, B2, B1};
static const double srkn6_drift[] = {A1, A2, A3, A3, A2, A1, 0.0};
#undef B1
#undef B2
#undef B3
#undef B4
#undef A1
#undef A2
#undef A3

/* SRKN11b, order 6 */
#define B1 0.0414649985182624
#define B2 0.198128671918067
#define B3 (-0.0400061921041533)
#define B4 0.0752539843015807
#define B5 (-0.0115113874206879)
#define B6 (0.5 - (B1 + B2 + B3 + B4 + B5))
#define A1 0.123229775946271
#define A2 0.290553797799558
#define A3 (-0.127049212625417)
#define A4 (-0.246331761062075)
#define A5 0.357208872795928
#define A6 (1.0 - 2.0 * (A1 + A2 + A3 + A4 + A5))
static const double srkn11_kick[] = {B1, B2, B3, B4, B5, B6, B6, B5, B4, B3, B2, B1};
static const double srkn11_drift[] = {A1, A2, A3, A4, A5, A6, A5, A4, A3, A2, A1, 0.0};
#undef B1
#undef B2
#undef B3
#undef B4
#undef B5
#undef B6
#undef A1
#undef A2
#undef A3
#undef A4
#undef A5
#undef A6

/* SRKN14a, order 6; begins and ends with a drift */
#define A1 0.0378593198406116
#define A2 0.102635633102435
#define A3 (-0.0258678882665587)
#define A4 0.314241403071447
#define A5 (-0.130144459517415)
#define A6 0.106417700369543
#define A7 (-0.00879424312851058)
#define A8 (1.0 - 2.0 * (A1 + A2 + A3 + A4 + A5 + A6 + A7))
#define B1 0.09171915262446165
#define B2 0.183983170005006
#define B3 (-0.05653436583288827)
#define B4 0.004914688774712854
#define B5 0.143761127168358
#define B6 0.328567693746804
#define B7 (0.5 - (B1 + B2 + B3 + B4 + B5 + B6))
static const double srkn14_kick[] = {0.0, B1, B2, B3, B4, B5, B6, B7, B7, B6, B5, B4, B3, B2, B1};
static const double srkn14_drift[] = {A1, A2, A3, A4, A5, A6, A7, A8, A7, A6, A5, A4, A3, A2, A1};
#undef A1
#undef A2
#undef A3
#undef A4
#undef A5
#undef A6
#undef A7
#undef A8
#undef B1
#undef B2
#undef B3
#undef B4
#undef B5
#undef B6
#undef B7

/* ---- estimates of a step's error (EQUATIONS 8.2) ----------------------------------------------------------------- */

/* Weights on the forces of the kicks, of which first halves are written: ODD ones are mirrored with the other sign,
 * EVEN ones with the same. They vanish on every tree of order up to 3 for srkn6 and up to 5 for the others; all that do
 * are here, for one alone is blind to some touches. */
#define ODD3(A, B, C) A, B, C, 0.0, -(C), -(B), -(A)
#define EVEN4(A, B, C, D) A, B, C, D, C, B, A
#define ODD6(A, B, C, D, E, F) A, B, C, D, E, F, -(F), -(E), -(D), -(C), -(B), -(A)
#define ODD7(A, B, C, D, E, F, G) A, B, C, D, E, F, G, -(G), -(F), -(E), -(D), -(C), -(B), -(A)

static const double srkn6_estimate[] = {
    EVEN4(-0.0062450155665471664, 0.3195361420103231, -0.15631925741693706, -0.31394373805367781),
    ODD3(-0.21121506023791234, 0.36010187038698366, -0.03966400274429905),
    ODD3(0.17536939207213612, 0.14180364515147031, 0.35354730148484215)};
static const double srkn11_estimate[] = {ODD6(0.056991348499688746, -0.1053976613936041, 0.097141815447791185,
                                              -0.040075609046524206, -0.013869709957446999, 0.17346708246242382),
                                         ODD6(0.0058627357464052839, 0.087975924481833098, 0.17182064186367049,
                                              -0.10493506532466985, -0.04586439647425463, -0.072602247929220071)};
/* no kick before the first drift */
static const double srkn14_estimate[] = {
    0.0,
    ODD7(-0.031826516906632886, 0.021228293341404664, 0.053330687417524045, -0.0056478493083841124,
         -0.12054012928977742, 0.19661838732137277, -0.071998857010386899),
    0.0,
    ODD7(0.0063713008897319408, 0.0055271469886345277, -0.0011102611273473564, -0.0073910979171176745,
         -0.12965257863318644, -0.00061644491040879399, 0.21395093237486393),
    0.0,
    ODD7(-0.095980375200073034, 0.16870291222789907, 0.043212368649355321, 0.0043452737870544288, -0.083752478504982367,
         -0.11581209258529232, -0.052212668775723413)};
#undef ODD3
#undef EVEN4
#undef ODD6
#undef ODD7

/* ---- force gradient, S. A. Chin, Phys. Lett. A 226 (1997) 344 ---------------------------------------------------- */

/* Algorithm A: kick(h/6) drift(h/2), kick(2h/3) by F + h^2/48 grad |F|^2/m, drift(h/2) kick(h/6). F at x + c h^2 F/m is
 * F + c h^2/2 grad |F|^2/m up to h^4: c = 1/24. That remainder is no gradient, so the step is symplectic only up to
 * h^5. */
static const double chin4_kick[] = {1.0 / 6, 2.0 / 3, 1.0 / 6};
static const double chin4_drift[] = {0.5, 0.5, 0.0};
static const double chin4_probe[] = {0.0, 1.0 / 24, 0.0};

#endif
