/* SPDX-License-Identifier: BSD-3-Clause */
#include "panels.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "plain.h"
#include "wide.h"

/** cos(j theta) and sin(j theta) of the nodes' theta = (2 k + 1) pi/(2 N). */
static double cosine(int64_t j, int64_t k)
{
    return plain_cos_turn(1.0, j * (2 * k + 1), 4 * PANELS_NODES);
}

static double sine(int64_t k)
{
    return plain_sin_turn(1.0, 2 * k + 1, 4 * PANELS_NODES);
}

int panels_create(struct panels *panels, int64_t width, int64_t count, int64_t held, double t_end)
{
    panels_destroy(panels);
    panels->width = width;
    panels->count = count;
    panels->first = 0;
    panels->held = held;
    panels->t_end = t_end;
    for (int k = 0; k < PANELS_NODES; ++k) {
        panels->node[k] = -cosine(1, k);
        panels->weight[k] = (k % 2 == 0 ? 1.0 : -1.0) * sine(k);
        panels->last[0][k] = cosine(PANELS_NODES - 2, k);
        panels->last[1][k] = cosine(PANELS_NODES - 1, k);
    }
    panels->values = calloc((size_t)(held * PANELS_NODES * width), sizeof *panels->values);
    return panels->values != NULL ? 0 : -1;
}

void panels_destroy(struct panels *panels)
{
    free(panels->values);
    panels->values = NULL;
}

double panels_time(const struct panels *panels, int64_t p, double tau)
{
    return panels->t_end * (((double)p + 0.5 * (1.0 + tau)) / (double)panels->count);
}

double *panels_row(const struct panels *panels, int64_t p, int k)
{
    return panels->values + ((p - panels->first) * PANELS_NODES + k) * panels->width;
}

double panels_tail(const struct panels *panels, int64_t p, const double *unit)
{
    double largest = 0.0;
    for (int64_t c = 0; c < panels->width; ++c)
        for (int j = 0; j < 2; ++j) {
            double sum = 0.0;
            for (int k = 0; k < PANELS_NODES; ++k)
                sum += panels_row(panels, p, k)[c] * panels->last[j][k];
            largest = fmax(largest, fabs(2.0 * sum / PANELS_NODES) / (unit != NULL ? unit[c] : 1.0));
        }
    return largest;
}

double panels_most(const struct panels *panels, int64_t p, const double *unit)
{
    const double *value = panels_row(panels, p, 0);
    double most = 0.0;
    for (int64_t k = 0; k < PANELS_NODES * panels->width; ++k)
        most = fmax(most, fabs(value[k]) / unit[k % panels->width]);
    return most;
}

/** t in panels. */
VTI_INLINE double place_of(const struct panels *panels, double t)
{
    return t / panels->t_end * (double)panels->count;
}

int64_t panels_find(const struct panels *panels, double t, double *tau)
{
    const double place = place_of(panels, t);
    int64_t p = (int64_t)place;
    p = p < panels->count ? p : panels->count - 1;
    *tau = 2.0 * (place - (double)p) - 1.0;
    return p;
}

VTI_INLINE void find_all_loops(const struct panels *panels, double h, double step, double p, double *restrict tau,
                               double *restrict place)
{
    for (int k = 0; k < PANELS_BLOCK; ++k) {
        place[k] = place_of(panels, (step + k) * h);
        tau[k] = 2.0 * (place[k] - p) - 1.0;
    }
}

static void find_all(const struct panels *panels, double h, double step, double p, double *tau, double *place);
WIDE(find_all, (const struct panels *panels, double h, double step, double p, double *tau, double *place),
     (panels, h, step, p, tau, place))

int64_t panels_find_block(const struct panels *panels, double h, int64_t step, double tau[PANELS_BLOCK], int64_t *count)
{
    double place[PANELS_BLOCK];
    const int64_t p = panels_find(panels, (double)step * h, &tau[0]);
    const double end = p + 1 < panels->count ? (double)(p + 1) : INFINITY;
    find_all(panels, h, (double)step, (double)p, tau, place);
    int64_t n = PANELS_BLOCK;
    while (n > 1 && !(place[n - 1] < end)) /* steps go on in time */
        --n;
    *count = n;
    return p;
}

/** Barycentric shares of the nodes at n places of a panel, share[PANELS_NODES][n], which add up to 1 at each:
 *
 *     share_k ~ weight_k/(tau - node_k),    1/a and 1/b as b/(a b) and a/(a b)
 *
 *  by one division for two nodes. Many places are done at once. */
VTI_INLINE void shares(const struct panels *restrict panels, const double *restrict tau, int64_t n,
                       double *restrict share)
{
    double sum[PANELS_BLOCK];
    int at_node = 0;
    for (int64_t i = 0; i < n; ++i)
        sum[i] = 0.0;
    for (int k = 0; k < PANELS_NODES; k += 2) {
        const double *const weight = panels->weight + k, *const node = panels->node + k;
        for (int64_t i = 0; i < n; ++i) {
            const double a = tau[i] - node[0], b = tau[i] - node[1], each = 1.0 / (a * b);
            const double one = weight[0] * (b * each), other = weight[1] * (a * each);
            share[k * n + i] = one;
            share[(k + 1) * n + i] = other;
            sum[i] += one + other;
        }
    }
    for (int64_t i = 0; i < n; ++i) {
        at_node |= isnan(sum[i]); /* infinity and 0 times it */
        sum[i] = 1.0 / sum[i];
    }
    for (int k = 0; k < PANELS_NODES; ++k)
        for (int64_t i = 0; i < n; ++i)
            share[k * n + i] *= sum[i];
    for (int64_t i = 0; i < n && at_node; ++i)
        for (int k = 0; k < PANELS_NODES && isnan(sum[i]); ++k)
            share[k * n + i] = tau[i] == panels->node[k] ? 1.0 : 0.0;
}

VTI_INLINE void panels_read_block_loops(const struct panels *panels, int64_t p, const double *tau, int64_t n,
                                        double *restrict out)
{
    enum { EIGHT = 8 }; /* numbers stay in registers; some more than n fill them up */
    const int64_t width = panels->width, all = (n + EIGHT - 1) / EIGHT * EIGHT;
    double share[PANELS_NODES * PANELS_BLOCK];
    shares(panels, tau, all, share);
    for (int64_t c = 0; c < width; ++c) {
        const double *value = panels_row(panels, p, 0) + c;
        for (int64_t first = 0; first < all; first += EIGHT) {
            double sum[EIGHT] = {0.0};
            for (int k = 0; k < PANELS_NODES; ++k)
                for (int i = 0; i < EIGHT; ++i)
                    sum[i] += share[k * all + first + i] * value[k * width];
            memcpy(out + c * PANELS_BLOCK + first, sum, sizeof sum);
        }
    }
}

WIDE(panels_read_block,
     (const struct panels *panels, int64_t p, const double tau[PANELS_BLOCK], int64_t n, double *out),
     (panels, p, tau, n, out))

void panels_read(const struct panels *panels, int64_t p, double tau, double *out)
{
    double share[PANELS_NODES];
    shares(panels, &tau, 1, share);
    memset(out, 0, (size_t)panels->width * sizeof *out);
    for (int k = 0; k < PANELS_NODES; ++k) {
        const double *row = panels_row(panels, p, k);
        for (int64_t c = 0; c < panels->width; ++c)
            out[c] += share[k] * row[c];
    }
}

double panels_read_one(const struct panels *panels, int64_t p, double tau, int64_t component)
{
    double share[PANELS_NODES], sum = 0.0;
    shares(panels, &tau, 1, share);
    for (int k = 0; k < PANELS_NODES; ++k)
        sum += share[k] * panels_row(panels, p, k)[component];
    return sum;
}
