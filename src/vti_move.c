/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Kick and drift, the two primitives of every stepper, for one body after the other; where there are many, by kernels
 * that give the same bits (vti_move_kernels.h). */
#include "vti_move_body.h"
#include "vti_ready.h"

/* ---- kick and translation ---------------------------------------------------------------------------------------- */

/** a of body i after its kicks, a += t/m by, which are also stored. */
VTI_INLINE void kicked(const struct vti_move *move, const vti_view *view, const vti_view *by, const vti_scalars *over,
                       const vti_view *low, int64_t i, double a[3])
{
    vti_load(view, i, a);
    if (!vti_has(by) || (move->before == 0.0 && move->kick == 0.0))
        return;
    double f[3];
    vti_load(by, i, f);
    if (move->before != 0.0)
        add_by(move->before / vti_scalar(over, i), f, low, i, a);
    if (move->kick != 0.0)
        add_by(move->kick / vti_scalar(over, i), f, low, i, a);
    vti_store(view, i, a);
}

static void translate(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end)
{
    const int drifts = move->drifts && vti_has(&b->x);
    for (int64_t i = begin; i < end; ++i) {
        double v[3], x[3];
        kicked(move, &b->v, &b->force, &b->mass, &b->v_low, i, v);
        if (!drifts)
            continue;
        vti_load(&b->x, i, x);
        add_by(move->drift, v, &b->x_low, i, x);
        vti_store(&b->x, i, x);
    }
}

/* ---- turn -------------------------------------------------------------------------------------------------------- */

/* How the attitude is kept. */
enum { NOT, BY_ALPHA, COMPENSATED, BY_QUAT };

VTI_INLINE void rotate(int kept, int law, double side, const struct vti_move *move, const vti_bodies *b, int64_t begin,
                       int64_t end)
{
    for (int64_t i = begin; i < end; ++i) {
        double w[3];
        kicked(move, &b->omega, &b->moment, &b->inertia, &b->omega_low, i, w);
        const double t = move->drift, u[3] = {t * w[0], t * w[1], t * w[2]};
        if (kept == BY_ALPHA)
            turn_alpha(increment(law, u), side, u, &b->alpha, i);
        else if (kept == COMPENSATED)
            turn_compensated(increment(law, u), side, u, &b->alpha, &b->alpha_low, i);
        else if (kept == BY_QUAT)
            turn_quat(increment(law, u), side, u, &b->quat, i);
    }
}

/* Literal arguments, so that each way to keep the attitude, each law and each frame is a loop of its own. */
typedef void turn(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end);
#define TURN(KEPT, LAW, FRAME, SIDE)                                                                                   \
    static void KEPT##_##LAW##_##FRAME(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end)   \
    {                                                                                                                  \
        rotate(KEPT, VTI_LAW_##LAW, SIDE, move, b, begin, end);                                                        \
    }
#define LAWS(KEPT, FRAME, SIDE)                                                                                        \
    TURN(KEPT, CLOSED, FRAME, SIDE)                                                                                    \
    TURN(KEPT, CAYLEY, FRAME, SIDE)                                                                                    \
    TURN(KEPT, EXACT, FRAME, SIDE)                                                                                     \
    TURN(KEPT, EXACT9, FRAME, SIDE)
#define FRAMES(KEPT)                                                                                                   \
    LAWS(KEPT, space, 1.0)                                                                                             \
    LAWS(KEPT, body, -1.0)
FRAMES(BY_ALPHA)
FRAMES(COMPENSATED)
FRAMES(BY_QUAT)

static void not_turned(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end)
{
    rotate(NOT, VTI_LAW_CAYLEY, 1.0, move, b, begin, end);
}

#define BY_LAW(KEPT, FRAME)                                                                                            \
    {                                                                                                                  \
        NULL, KEPT##_CLOSED_##FRAME, KEPT##_CAYLEY_##FRAME, KEPT##_EXACT_##FRAME, KEPT##_EXACT9_##FRAME                \
    }
/** [how the attitude is kept][frame is the body's][law] */
static turn *const turns[4][2][VTI_LAW_EXACT9 + 1] = {
    [BY_ALPHA] = {BY_LAW(BY_ALPHA, space), BY_LAW(BY_ALPHA, body)},
    [COMPENSATED] = {BY_LAW(COMPENSATED, space), BY_LAW(COMPENSATED, body)},
    [BY_QUAT] = {BY_LAW(BY_QUAT, space), BY_LAW(BY_QUAT, body)},
};

static turn *turn_of(const struct vti_move *move, const vti_bodies *b)
{
    if (!move->drifts || !vti_has_attitude(b))
        return not_turned;
    const int kept = !vti_has(&b->alpha) ? BY_QUAT : vti_has(&b->alpha_low) ? COMPENSATED : BY_ALPHA;
    return turns[kept][move->frame == VTI_FRAME_BODY][move->law];
}

void vti_move_turn(const struct vti_move *move, const vti_bodies *b, int64_t i)
{
    const struct vti_move drift = {0.0, 0.0, move->drift, 1, move->law, move->frame, 0};
    turn_of(&drift, b)(&drift, b, i, i + 1);
}

void vti_move_turn_by(int law, const double u[3], const vti_bodies *b, int64_t i)
{
    const struct increment d = increment(law, u);
    if (vti_has(&b->alpha))
        turn_alpha(d, 1.0, u, &b->alpha, i);
    else
        turn_quat(d, 1.0, u, &b->quat, i);
}

/* ---- many -------------------------------------------------------------------------------------------------------- */

/** The kernels for this many bodies: none for few, or where residuals are carried along. */
static inline const struct vti_move_kernels *const *kernels(int64_t bodies, int carry)
{
    static const struct vti_move_kernels *const none[] = {NULL};
    const struct vti_move_kernels *const *first = none;
    if (!carry && bodies > VTI_FEW)
        for (first = vti_move_served(); first[1] != NULL && bodies < (*first)->least;)
            ++first;
    return first;
}

static void translate_all(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end)
{
    const int carry = vti_has(&b->x_low) || vti_has(&b->v_low);
    for (const struct vti_move_kernels *const *k = kernels(end - begin, carry); *k != NULL; ++k)
        begin = (*k)->translate(move, b, begin, end);
    translate(move, b, begin, end);
}

static void rotate_all(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end)
{
    const int carry = vti_has(&b->alpha_low) || vti_has(&b->omega_low);
    for (const struct vti_move_kernels *const *k = kernels(end - begin, carry); *k != NULL; ++k)
        begin = (*k)->rotate(move, b, begin, end);
    turn_of(move, b)(move, b, begin, end);
}

/** The first body that is left to translate and to rotate. */
static int64_t move_both(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end)
{
    const int carry = vti_has(&b->x_low) || vti_has(&b->v_low) || vti_has(&b->alpha_low) || vti_has(&b->omega_low);
    for (const struct vti_move_kernels *const *k = kernels(end - begin, carry); *k != NULL; ++k)
        begin = (*k)->both(move, b, begin, end);
    return begin;
}

static void rotate_generally(const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end)
{
    const int carry = vti_has(&b->alpha_low) || vti_has(&b->spin_low),
              rotates = vti_has(&b->spin) || vti_has(&b->omega);
    for (const struct vti_move_kernels *const *k = kernels(end - begin, carry || !rotates); *k != NULL; ++k)
        begin = (*k)->general(move, b, begin, end);
    vti_rotor_move(move, b, begin, end);
}

/** Bodies of one block stay in the second-level cache from their translation to their turn; of fewer, starting anew
 *  costs more than the first level saves. */
enum { BLOCK = 1024 };

/** Of so many, arrays do not fit into the second-level cache. */
enum { MANY = 4096 };

/** What of a body a move changes. */
struct parts {
    int translates, rotates, general; /* general: of three moments */
};

static void move_block(struct parts parts, const struct vti_move *move, const vti_bodies *b, int64_t begin, int64_t end)
{
    if (parts.translates && move->drifts)
        translate_all(move, b, begin, end);
    if (parts.rotates)
        rotate_all(move, b, begin, end);
    else if (parts.general)
        rotate_generally(move, b, begin, end);
    if (parts.translates && !move->drifts)
        translate_all(move, b, begin, end);
}

/** Kicks alone from the last block to the first, as kick_and_move has it. */
static void move_blocks(struct parts parts, const struct vti_move *move, const vti_bodies *b, int64_t first,
                        int64_t last)
{
    const int64_t blocks = (last - first + BLOCK - 1) / BLOCK;
    for (int64_t k = 0; k < blocks; ++k) {
        const int64_t begin = first + BLOCK * (move->drifts ? k : blocks - 1 - k);
        move_block(parts, move, b, begin, last - begin < BLOCK ? last : begin + BLOCK);
    }
}

/** The first body from i on whose vector begins with a line of the cache: kernels that begin there load and store
 *  across no two lines. i if there is none. */
static int64_t aligned(const vti_view *v, int64_t i)
{
    for (int64_t k = i; k < i + 8; ++k)
        if ((uintptr_t)(v->c[0] + k * v->stride) % 64 == 0)
            return k;
    return i;
}

void vti_move_all(const struct vti_move *move, const vti_bodies *b)
{
    const int kicks = move->before != 0.0 || move->kick != 0.0, general = vti_has(&b->moments);
    const struct parts parts = {vti_has(&b->v) && ((move->drifts && vti_has(&b->x)) || (kicks && vti_has(&b->force))),
                                !general && vti_has(&b->omega) &&
                                    ((move->drifts && vti_has_attitude(b)) || (kicks && vti_has(&b->moment))),
                                general};
    const int64_t last = b->first + b->count;
    int64_t begin = b->first;
    if (b->count > BLOCK) { /* of fewer the bodies before cost as much */
        begin = aligned(vti_has(&b->v) ? &b->v : &b->omega, begin);
        move_blocks(parts, move, b, b->first, begin);
    }
    if (b->count >= MANY && parts.translates && parts.rotates)
        begin = move_both(move, b, begin, last);
    move_blocks(parts, move, b, begin, last);
}

/* ---- the bound of the closed form -------------------------------------------------------------------------------- */

/** u = t Omega of body i after the kicks, by their operations: what is tested is what the square root will see. */
static void turn_ahead(const struct vti_move *move, const vti_bodies *b, int64_t i, double u[3])
{
    double low[3], m[3];
    const vti_view residual = {{low, low + 1, low + 2}, 0, 0}, none = vti_view_none();
    const vti_view *const carried = vti_has(&b->omega_low) ? &residual : &none;
    vti_load(&b->omega, i, u);
    if (vti_has(carried))
        vti_load(&b->omega_low, i, low);
    const double times[2] = {move->before, move->kick};
    for (int k = 0; k < 2; ++k)
        if (times[k] != 0.0 && vti_has(&b->moment)) {
            vti_load(&b->moment, i, m);
            add_by(times[k] / vti_scalar(&b->inertia, i), m, carried, 0, u);
        }
    for (int c = 0; c < 3; ++c)
        u[c] *= move->drift;
}

/** The body with the largest s = |u|, or the first whose s is NaN. */
static void name_worst(const struct vti_move *move, const vti_bodies *b, vti_fault *fault)
{
    double worst = -1.0;
    for (int64_t i = b->first; i < b->first + b->count && !isnan(worst); ++i) {
        double u[3];
        turn_ahead(move, b, i, u);
        const double s = vti_norm(u);
        if (!(s <= worst)) {
            worst = s;
            vti_refuse(VTI_E_TOO_LARGE, i, s, VTI_QUANTITY_OMEGA, fault);
        }
    }
}

int vti_move_check(const struct vti_move *move, const vti_bodies *b, vti_fault *fault)
{
    if (move->law != VTI_LAW_CLOSED || !vti_has_attitude(b) || !vti_has(&b->omega))
        return VTI_OK;
    int64_t i = b->first;
    const int64_t end = i + b->count;
    int refused = 0;
    for (const struct vti_move_kernels *const *k = kernels(b->count, vti_has(&b->omega_low)); *k != NULL; ++k)
        refused |= (*k)->reaches(move, b, i, end, &i);
    for (; i < end; ++i) {
        double u[3];
        turn_ahead(move, b, i, u);
        refused |= !(vti_dot(u, u) < 1.0);
    }
    if (refused && fault != NULL)
        name_worst(move, b, fault);
    return refused ? VTI_E_TOO_LARGE : VTI_OK;
}

int64_t vti_move_below(const struct vti_move *move, const vti_bodies *b)
{
    int64_t i = b->first;
    int refused = 0;
    for (const struct vti_move_kernels *const *k = kernels(b->count, vti_has(&b->spin_low)); *k != NULL; ++k)
        refused |= (*k)->general_reaches(move, b, i, b->first + b->count, &i);
    return refused ? b->first : i;
}

/* ---- the public primitives --------------------------------------------------------------------------------------- */

int vti_kick(double t, const vti_bodies *b)
{
    const int status = vti_bodies_ready(b);
    if (status != VTI_OK)
        return status;
    if (!isfinite(t))
        return VTI_E_TIME;
    const struct vti_move move = {0.0, t, 0.0, 0, VTI_LAW_CAYLEY, VTI_FRAME_SPACE, 0};
    vti_move_all(&move, b);
    return VTI_OK;
}

void vti_drift_increment(int law, double t, const double omega[3], double dalpha[3])
{
    double u[3] = {NAN, NAN, NAN};
    struct increment d = {{NAN, NAN}, 0};
    if (dalpha == NULL)
        return;
    for (int k = 0; k < 3 && omega != NULL; ++k)
        u[k] = t * omega[k];
    if (vti_law_check(law, VTI_FRAME_SPACE) == VTI_OK)
        d = increment(law, u);
    if (law == VTI_LAW_CLOSED && vti_dot(u, u) > 1.0)
        d.cf[0] = d.cf[1] = 1.0;
    const double pair[4] = {d.cf[1] * u[0], d.cf[1] * u[1], d.cf[1] * u[2], d.cf[0]};
    for (int k = 0; k < 3; ++k)
        dalpha[k] = 2.0 * d.cf[1] * u[k] / d.cf[0];
    if (d.cf[0] == 0.0) /* half a turn */
        vti_rrv_from_pair(pair, dalpha);
}

int vti_drift_by(int law, int frame, int rotor, double t, const vti_bodies *b, vti_fault *fault)
{
    vti_refuse_none(VTI_OK, fault);
    int status = vti_bodies_ready_or(b, fault);
    if (status == VTI_OK)
        status = vti_law_check(law, frame);
    if (status == VTI_OK && !isfinite(t))
        status = vti_refuse(VTI_E_TIME, -1, t, VTI_QUANTITY_NONE, fault);
    const struct vti_move move = {0.0, 0.0, t, 1, law, frame, rotor};
    if (status == VTI_OK)
        status = vti_has(&b->moments) ? vti_rotor_check(&move, b, fault) : vti_move_check(&move, b, fault);
    if (status == VTI_OK)
        vti_move_all(&move, b);
    return status;
}

int vti_drift(int law, int frame, double t, const vti_bodies *b, vti_fault *fault)
{
    return vti_drift_by(law, frame, 0, t, b, fault);
}
