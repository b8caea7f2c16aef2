/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The table of the kernels that move many bodies at once. The files vti_move_*.c include this and nothing else: each is
 * compiled for vector units of its own, and defines MOVE_KERNELS, the name of its table. */
#include "../multistep/vti_adams_kernels.h"
#include "../vti_move.h"

#if VTI_WIDTH > 1

#include "../inertia/vti_rotor_kernels.h"
#include "../multistep/vti_adams_turns.h"

static int64_t settle(double *p, int64_t count)
{
    int64_t k = 0;
    for (; k + WIDTH <= count; k += WIDTH)
        lanes_store(p + k, lanes_settled(lanes_load(p + k)));
    return k;
}

const struct vti_move_kernels MOVE_KERNELS = {WIDTH < 8 ? 2 * WIDTH : 4 * WIDTH,
                                              translate,
                                              rotate,
                                              move_both,
                                              reaches,
                                              rotate_general,
                                              reaches_general,
                                              adams_predict,
                                              adams_correct,
                                              adams_turn,
                                              settle};

#else

static int64_t none(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end)
{
    (void)move;
    (void)b;
    (void)end;
    return begin;
}

static int reaches_none(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end, int64_t *stopped)
{
    *stopped = none(move, b, begin, end);
    return 0;
}

static int64_t turn_none(const double *by, int64_t each, const vti_bodies *b, int64_t begin, int64_t end)
{
    (void)by;
    (void)each;
    return none(NULL, b, begin, end);
}

static int64_t settle_none(double *p, int64_t count)
{
    (void)p;
    (void)count;
    return 0;
}

const struct vti_move_kernels MOVE_KERNELS = {
    0, none, none, none, reaches_none, none, reaches_none, adams_predict, adams_correct, turn_none, settle_none};

#endif
