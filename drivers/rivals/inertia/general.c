/* SPDX-License-Identifier: BSD-3-Clause */
#include "general.h"

int general_prepare(struct course *c, struct message *message)
{
    static const double none[4] = {0.0, 0.0, 0.0, 1.0};
    const vti_bodies *b = &c->bodies;
    (void)message;
    for (int64_t i = 0; i < c->n; ++i) {
        double *own = c->own + GENERAL_WIDTH * i;
        for (int k = 0; k < 3; ++k) {
            own[GENERAL_I + k] = b->moments.c[k][i * b->moments.stride];
            own[GENERAL_K + k] = 1.0 / own[GENERAL_I + k];
        }
        for (int k = 0; k < 4; ++k) {
            own[GENERAL_P + k] = b->principal.xyzw[0] != NULL ? b->principal.xyzw[k][i * b->principal.stride] : none[k];
            if (own[GENERAL_P + k] != none[k])
                c->number[GENERAL_TURNED] = 1.0;
        }
    }
    return 0;
}

void general_axes(const struct course *c, int64_t i, double q[4])
{
    euler_axes(c->q + 4 * i, c->own + GENERAL_WIDTH * i + GENERAL_P, q);
}

void general_set_axes(struct course *c, int64_t i, const double q[4])
{
    const double *p = c->own + GENERAL_WIDTH * i + GENERAL_P, back[4] = {-p[0], -p[1], -p[2], p[3]};
    euler_axes(q, back, c->q + 4 * i);
}

void general_show(struct course *c)
{
    for (int64_t i = 0; i < c->n; ++i) {
        double q[4], w[3];
        general_axes(c, i, q);
        general_body_omega(c->own + GENERAL_WIDTH * i + GENERAL_K, c->L + 3 * i, q, w);
        vti_pair_rotate(q, 1.0, w, c->w + 3 * i);
    }
}
