/* SPDX-License-Identifier: BSD-3-Clause
 *
 * A move is what a step does to a block of bodies between two evaluations of forces (EQUATIONS 2):
 *
 *     kick(before):  v += t F/m,  Omega += t RM/J         what is left of the last step
 *     kick(kick):    the same                             the first of this one
 *     drift(drift):  x += t v,  alpha <- alpha (+) dalpha(t Omega)
 *
 * vti_move.c moves bodies one by one, and picks kernels that do many at once, to the same bits (vti_move_kernels.h). */
#ifndef VTI_MOVE_H
#define VTI_MOVE_H

#include <stddef.h>

#include "vti.h"
#include "vti_processor.h"

struct vti_move {
    double before, kick; /* times of the kicks; a kick of 0 does not look at the forces */
    double drift;        /* time of the drift */
    int drifts;          /* whether there is one */
    int law, frame;
    int rotor; /* of bodies with moments: 2, 4, 6; 0 is 2 */
};

/** Moves all bodies of the slice, which have been checked. */
void vti_move_all(const struct vti_move *move, const vti_bodies *b);

/** VTI_E_TOO_LARGE if the drift after the kicks would break the law's bound for some body, which fault then names. */
int vti_move_check(const struct vti_move *move, const vti_bodies *b, vti_fault *fault);

/** vti_drift with the rotor of bodies with moments. */
int vti_drift_by(int law, int frame, int rotor, double t, const vti_bodies *b, vti_fault *fault);

/** Turns one body by the drift: what the kernels leave out. */
void vti_move_turn(const struct vti_move *move, const vti_bodies *b, int64_t i);

/** Turns one body by the vector u in space. */
void vti_move_turn_by(int law, const double u[3], const vti_bodies *b, int64_t i);

/* ---- bodies with moments (vti_rotor.c) --------------------------------------------------------------------------- */

/** Kicks, and turns by the drift, the bodies begin <= i < end, which have been checked. */
void vti_rotor_move(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end);

/** Whether they can be moved so: the frame, the rotor, and the bound of the closed form for every turn of each, of
 *  which the worst is what fault then names. */
int vti_rotor_check(const struct vti_move *move, const vti_bodies *b, vti_fault *fault);

/** The first of the bodies of which the kernels do not know that all turns of the closed form are below 1. */
int64_t vti_move_below(const struct vti_move *move, const vti_bodies *b);

/* ---- many at once ------------------------------------------------------------------------------------------------ */

/** Half a step of a multistep method. */
typedef int64_t vti_half_step(const vti_multistep *m, double h, const vti_past *past, const vti_bodies *b,
                              int64_t begin, int64_t end, double *turn);

/** Kernels move as many of the bodies begin <= i < end as fill their lanes, and say where they stopped: at begin if the
 *  layout is not for them. Nothing that carries residuals is for them. */
struct vti_move_kernels {
    int64_t least; /* bodies; for fewer it does not pay to start */
    int64_t (*translate)(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end);
    int64_t (*rotate)(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end);
    /** Both at once, where everything lies the same way: memory gives more to a loop that reads all arrays than to one
     *  loop after another. */
    int64_t (*both)(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end);
    /** Whether a body's turn of the drift is 1 or more, or NaN; for the bodies up to *stopped. */
    int (*reaches)(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end, int64_t *stopped);
    /** The same two of bodies with moments. */
    int64_t (*general)(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end);
    int (*general_reaches)(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end,
                           int64_t *stopped);
    /** The two halves of a step of a multistep method but for the attitudes, which are still to turn by what is left in
     *  turn: of as many bodies as fill the lanes, all if one does, whatever the layout (vti_adams_kernels.h). They say
     *  where they stopped. */
    vti_half_step *predict, *correct;
    /** Turns bodies by that, by[][each], as vti_move_turn_by does (vti_adams_magnus.h, vti_adams_turns.h). */
    int64_t (*turn)(const double *by, int64_t each, const vti_bodies *b, int64_t begin, int64_t end);
    /** Makes 0 of numbers below VTI_STILL, of which the squares begin to vanish. Returns how many it has looked at. */
    int64_t (*settle)(double *p, int64_t count);
};
extern const struct vti_move_kernels vti_move_baseline, vti_move_avx2, vti_move_avx512;

/** Those of this machine's vector units, widest first, then NULL: what one leaves over, the next may take. */
static inline const struct vti_move_kernels *const *vti_move_served(void)
{
    static const struct vti_move_kernels *const all[] = {
#ifdef VTI_HAS_AVX512
        &vti_move_avx512,
#endif
#ifdef VTI_HAS_AVX2
        &vti_move_avx2,
#endif
        &vti_move_baseline, NULL};
    const struct vti_move_kernels *const *first = all;
#ifdef VTI_HAS_AVX512
    first += !vti_serves_avx512();
#endif
#ifdef VTI_HAS_AVX2
    first += *first == &vti_move_avx2 && !vti_serves_avx2();
#endif
    return first;
}

/** q <- normalise((u, c) q), in space, or, side = -1, q (u, c) in the body's frame. V is double, or a vector of
 *  them. */
#define VTI_MOVE_QUAT(NAME, V, DOT, CROSS, SQRT)                                                                       \
    VTI_INLINE void NAME(V c, const V u[3], double side, V q[4])                                                       \
    {                                                                                                                  \
        V r[4], x[3];                                                                                                  \
        CROSS(u, q, x);                                                                                                \
        for (int k = 0; k < 3; ++k)                                                                                    \
            r[k] = c * q[k] + q[3] * u[k] + side * x[k];                                                               \
        r[3] = c * q[3] - DOT(u, q);                                                                                   \
        const V scale = 1.0 / SQRT(DOT(r, r) + r[3] * r[3]);                                                           \
        for (int k = 0; k < 4; ++k)                                                                                    \
            q[k] = r[k] * scale;                                                                                       \
    }

/** The increment dalpha = 2 f u/c of a body that turns by u = t Omega, of s^2 = u.u:
 *      closed, VTI-1     dalpha = 2 u/(1 + sqrt(1 - s^2))
 *      Cayley, VTI-2, 3  dalpha = u
 *      exact             dalpha = 2 tan(s/2)/s u by its continued fraction, without a pole as
 *                        c = 2 - s^2/5, f = 1 - s^2/60;  c = 2 - 3s^2/14 + s^4/840, f = 1 - s^2/42
 *  as cf = {c, f}; for numbers and for lanes of numbers, V with the square root SQRT. */
#define VTI_MOVE_LAW(NAME, V, OF, SQRT)                                                                                \
    VTI_INLINE void NAME(int law, V s2, V cf[2])                                                                       \
    {                                                                                                                  \
        cf[1] = OF(1.0);                                                                                               \
        if (law == VTI_LAW_CAYLEY)                                                                                     \
            cf[0] = OF(2.0);                                                                                           \
        else if (law == VTI_LAW_CLOSED)                                                                                \
            cf[0] = 1.0 + SQRT(1.0 - s2);                                                                              \
        else {                                                                                                         \
            cf[1] = 1.0 - s2 * (law == VTI_LAW_EXACT ? 1.0 / 60.0 : 1.0 / 42.0);                                       \
            cf[0] = 2.0 - s2 * (law == VTI_LAW_EXACT ? OF(1.0 / 5.0) : (180.0 - s2) * (1.0 / 840.0));                  \
        }                                                                                                              \
    }

#endif
