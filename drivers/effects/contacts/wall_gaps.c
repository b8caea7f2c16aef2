/* SPDX-License-Identifier: BSD-3-Clause
 * How bodies and walls stand to each other: how deep, how fast. */
#include "hertz.h"
#include "wall.h"

static const double *axis_of(const vti_walls *walls, int64_t w)
{
    return w < walls->count ? walls->plane + 4 * w : walls->cylinder + 7 * (w - walls->count);
}

double wall_gap(const vti_walls *walls, int64_t w, const vti_view *x, int64_t i)
{
    const double at[3] = {x->c[0][i * x->stride], x->c[1][i * x->stride], x->c[2][i * x->stride]};
    double n[3];
    return vti_walls_gap(walls, w, at, n);
}

/** On the axis a of a cylinder any direction across it may be N: |a x (v - V)|. */
double wall_approach(const vti_walls *walls, const double x[3], const double v[3])
{
    double most = 0.0;
    for (int64_t w = 0; w < wall_count(walls); ++w) {
        double n[3], to[3], across[3];
        vti_walls_gap(walls, w, x, n);
        for (int k = 0; k < 3; ++k)
            to[k] = v[k] - (walls->motion != NULL ? walls->motion[w].velocity[k] : 0.0);
        vti_cross(axis_of(walls, w), to, across);
        const double speed = vti_dot(n, n) > 0.0 ? fabs(vti_dot(to, n)) : vti_norm(across);
        most = speed <= most ? most : speed; /* NaN stays */
    }
    return most;
}

double wall_fastest(const vti_walls *walls, const vti_bodies *b)
{
    double most = 0.0;
    for (int64_t w = 0; walls->motion != NULL && w < wall_count(walls); ++w) {
        const vti_wall_motion *m = &walls->motion[w];
        const double *axis = axis_of(walls, w);
        for (int64_t i = 0; i < b->count; ++i) {
            double d[3], way[3], n[3], x[3];
            for (int k = 0; k < 3; ++k)
                x[k] = b->x.c[k][i * b->x.stride];
            const double gap = vti_walls_gap(walls, w, x, n);
            for (int k = 0; k < 3; ++k)
                d[k] = x[k] - gap * n[k] - (w < walls->count ? m->centre[k] : axis[3 + k]) - m->moved[k];
            vti_cross(axis, d, way);
            most = fmax(most, vti_norm(m->velocity) + fabs(m->spin) * vti_norm(way));
        }
    }
    return most * most;
}

/** How deep sphere s is in wall w, as a share of its radius. */
static double share_of(const vti_walls *walls, int64_t w, const vti_bodies *spheres, int64_t s)
{
    return 1.0 - 2.0 * wall_gap(walls, w, &spheres->x, s) / walls->diameter.p[s * walls->diameter.stride];
}

double wall_held(const vti_walls *walls, const vti_bodies *spheres)
{
    double most = 0.0;
    for (int64_t w = 0; w < wall_count(walls); ++w)
        for (int64_t i = 0; i < spheres->count; ++i)
            most = fmax(most, hertz_held(vti_walls_stiffness(walls, w, i), share_of(walls, w, spheres, i)));
    return most;
}

int64_t wall_deepest(const vti_walls *walls, const vti_bodies *spheres, double least, double *share, int64_t *wall)
{
    int64_t at = -1;
    *share = least;
    for (int64_t w = 0; w < wall_count(walls); ++w)
        for (int64_t s = 0; s < spheres->count; ++s) {
            const double own = share_of(walls, w, spheres, s);
            if (own > *share) {
                *share = own;
                *wall = w;
                at = s;
            }
        }
    return at;
}

int64_t wall_first_filled(const vti_walls *walls, const vti_bodies *spheres, int64_t *wall)
{
    for (int64_t c = 0; c < walls->cylinders; ++c)
        for (int64_t s = 0; s < spheres->count; ++s)
            if (0.5 * walls->diameter.p[s * walls->diameter.stride] >= walls->cylinder[7 * c + 6]) {
                *wall = walls->count + c;
                return s;
            }
    return -1;
}

int64_t wall_first_sliding(const vti_walls *walls)
{
    for (int64_t w = 0; walls->motion != NULL && w < wall_count(walls); ++w) {
        const vti_wall_motion *m = &walls->motion[w];
        const double speed = vti_norm(m->velocity), along = fabs(vti_dot(m->velocity, axis_of(walls, w)));
        const double pressing = w < walls->count ? along : sqrt(fmax(speed * speed - along * along, 0.0));
        if ((speed > 0.0 || m->spin != 0.0) && !(pressing > 1e-7 * speed))
            return w;
    }
    return -1;
}
