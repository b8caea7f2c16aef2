// SPDX-License-Identifier: BSD-3-Clause
// A user in C++: a body turns by 0.5.
#include <cstdio>
#include <vector>

#include "vti.h"

int main()
{
    std::vector<double> alpha(3, 0.0), omega(3, 0.0);
    omega[2] = 1.0;
    vti_bodies bodies = vti_bodies_none(1);
    bodies.alpha = vti_view_packed(alpha.data());
    bodies.omega = vti_view_packed(omega.data());
    const vti_stepper *method = vti_stepper_find("exact");
    for (int k = 0; k < 50; ++k)
        if (vti_step_begin(method, 0.01, &bodies, nullptr) != VTI_OK ||
            vti_step_finish(method, 0.01, &bodies) != VTI_OK)
            return 1;
    std::printf("turned by %.10g\n", vti_rrv_angle(alpha.data()));
    return 0;
}
