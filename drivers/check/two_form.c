/* SPDX-License-Identifier: BSD-3-Clause
 *
 * The symplectic two-form of the pendulum and, of translation only, of the pair on its spring. The map's derivative is
 * by central differences of e, which cost e^2 and eps/e. */
#include "check.h"

enum { MOST = 12 };

static const double e = 1e-5;

/* ---- rotation: a tangent vector at (R, mu), mu = J Omega, is (eta, dmu) with dR = S(eta) R ----------------------- */

static struct bodies turned(const struct bodies *b, int direction, double by)
{
    struct bodies m = *b;
    double a[3], turn[3] = {0, 0, 0};
    if (direction >= 3) {
        m.w[direction - 3] += by;
        return m;
    }
    turn[direction] = 2.0 * tan(0.5 * by);
    vti_kit_bodies_alpha(b, 0, a);
    vti_rrv_compose(a, turn, a);
    vti_kit_bodies_set_alpha(&m, 0, a);
    return m;
}

static void turn_quotient(const struct bodies *plus, const struct bodies *minus, double tangent[MOST])
{
    double a[3], b[3], r[3], theta[3];
    vti_kit_bodies_alpha(plus, 0, a);
    vti_kit_bodies_alpha(minus, 0, b);
    vti_rrv_relative(a, b, r);
    vti_rrv_to_rotvec(r, theta);
    for (int k = 0; k < 3; ++k) {
        tangent[k] = theta[k] / (2.0 * e);
        tangent[3 + k] = (plus->w[k] - minus->w[k]) / (2.0 * e);
    }
}

/** d theta(s, t) = dmu_s.eta_t - dmu_t.eta_s + mu.(eta_s x eta_t), J = 1. */
static double turn_form(const struct bodies *at, const double s[MOST], const double t[MOST])
{
    double bracket[3];
    vti_cross(s, t, bracket);
    return vti_dot(s + 3, t) - vti_dot(t + 3, s) + vti_dot(at->w, bracket);
}

/* ---- translation: (dx, dv) of two bodies ------------------------------------------------------------------------- */

static struct bodies shifted(const struct bodies *b, int direction, double by)
{
    struct bodies m = *b;
    *(direction < 6 ? &m.x[direction] : &m.v[direction - 6]) += by;
    return m;
}

static void shift_quotient(const struct bodies *plus, const struct bodies *minus, double tangent[MOST])
{
    for (int k = 0; k < 6; ++k) {
        tangent[k] = (plus->x[k] - minus->x[k]) / (2.0 * e);
        tangent[6 + k] = (plus->v[k] - minus->v[k]) / (2.0 * e);
    }
}

/** sum of m (dv_s.dx_t - dv_t.dx_s) */
static double shift_form(const struct bodies *at, const double s[MOST], const double t[MOST])
{
    double sum = 0.0;
    for (int k = 0; k < 6; ++k)
        sum += at->mass[k / 3] * (s[6 + k] * t[k] - t[6 + k] * s[k]);
    return sum;
}

/* ---- both -------------------------------------------------------------------------------------------------------- */

struct space {
    const char *name;
    int size;
    double h; /* large, so that methods of high order show what they are */
    struct bodies (*scene)(struct field *field);
    struct bodies (*moved)(const struct bodies *b, int direction, double by);
    void (*quotient)(const struct bodies *plus, const struct bodies *minus, double tangent[MOST]);
    double (*form)(const struct bodies *at, const double s[MOST], const double t[MOST]);
};

static const struct space rotation = {"symplecticity: two-form of the pendulum, off by",
                                      6,
                                      0.5,
                                      vti_kit_scene_pendulum,
                                      turned,
                                      turn_quotient,
                                      turn_form};
static const struct space translation = {"symplecticity: two-form of a pair on a spring, off by",
                                         12,
                                         0.125,
                                         vti_kit_scene_spring,
                                         shifted,
                                         shift_quotient,
                                         shift_form};

/** Two steps. */
void vti_kit_two_form(struct kit *kit)
{
    enum { STEPS = 2 };
    const struct space *s = kit->rotates ? &rotation : &translation;
    struct field field;
    const struct bodies start = s->scene(&field);
    struct bodies end = start;
    double image[MOST][MOST], most = 0.0;
    vti_kit_host_advance(&kit->host, &end, &field, s->h, STEPS);
    int finite = vti_kit_bodies_are_finite(&end);
    for (int k = 0; k < s->size; ++k) {
        struct bodies plus = s->moved(&start, k, e), minus = s->moved(&start, k, -e);
        vti_kit_host_advance(&kit->host, &plus, &field, s->h, STEPS);
        vti_kit_host_advance(&kit->host, &minus, &field, s->h, STEPS);
        finite = finite && vti_kit_bodies_are_finite(&plus) && vti_kit_bodies_are_finite(&minus);
        if (finite)
            s->quotient(&plus, &minus, image[k]);
    }
    for (int i = 0; i < s->size && finite; ++i)
        for (int j = 0; j < i; ++j) {
            double ei[MOST] = {0}, ej[MOST] = {0};
            ei[i] = ej[j] = 1.0;
            most = fmax(most, fabs(s->form(&end, image[i], image[j]) - s->form(&start, ei, ej)));
        }
    vti_kit_line(kit, s->name, finite ? most : NAN, -1, 1e-7, VTI_CHECK_NOTE);
}
