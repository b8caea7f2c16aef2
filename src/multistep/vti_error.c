/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Estimates of a step's error (EQUATIONS 8.2), from the forces F_j of its kicks and weights w_kj (vti_coefficients.h):
 *
 *     e_k = h sum_j w_kj F_j/m,  h sum_j w_kj RM_j/J,  and of a body (sum_k |e_k|^2)^(1/2) */
#include "../vti_moments.h"
#include "../vti_ready.h"

static int check(const vti_stepper *method, const vti_bodies *b, const vti_errors *errors)
{
    if (method == NULL || method->estimate == NULL)
        return VTI_E_STEPPER;
    if (errors == NULL || errors->memory == NULL)
        return VTI_E_NULL;
    return errors->rows < method->estimates ? VTI_E_COUNT : vti_bodies_ready(b);
}

int vti_step_watch(const vti_stepper *method, int64_t k, double h, const vti_bodies *b, const vti_errors *errors)
{
    const int status = check(method, b, errors);
    if (status != VTI_OK)
        return status;
    if (k < 0 || k > method->stages)
        return VTI_E_STAGE;
    if (!vti_is_positive(h))
        return VTI_E_TIME;
    for (int64_t i = b->first; i < b->first + b->count; ++i) {
        double f[6], *sum = errors->memory + 6 * errors->rows * i;
        vti_accelerations(b, i, f);
        for (int64_t row = 0; row < method->estimates; ++row, sum += 6) {
            const double w = h * method->estimate[row * (method->stages + 1) + k];
            for (int c = 0; c < 6; ++c)
                sum[c] = (k > 0 ? sum[c] : 0.0) + w * f[c];
        }
    }
    return VTI_OK;
}

int vti_step_error(const vti_stepper *method, const vti_bodies *b, const vti_errors *errors, double *velocity,
                   double *omega)
{
    const int status = check(method, b, errors);
    if (status != VTI_OK)
        return status;
    if (velocity == NULL || omega == NULL)
        return VTI_E_NULL;
    *velocity = *omega = 0.0;
    for (int64_t i = b->first; i < b->first + b->count; ++i) {
        const double *e = errors->memory + 6 * errors->rows * i;
        double squares[2] = {0.0, 0.0};
        for (int64_t row = 0; row < method->estimates; ++row, e += 6) {
            squares[0] += vti_dot(e, e);
            squares[1] += vti_dot(e + 3, e + 3);
        }
        *velocity = vti_larger(*velocity, sqrt(squares[0]));
        *omega = vti_larger(*omega, sqrt(squares[1]));
    }
    return VTI_OK;
}
