/* SPDX-License-Identifier: GPL-2.0-only
 * Part of a plugin for LAMMPS, and under the licence of LAMMPS; the library that it calls is not. See LICENSE.
 *
 * fix ID group-ID nve/vti [vti1 | vti2 | vti3 | exact]
 *     moves atoms in the place of fix nve/sphere (atom_style sphere), nve/bpm/sphere (bpm/sphere), nve/asphere
 *     (ellipsoid) or nve/body (body); vti2 unless said. */
#ifndef FIX_NVE_VTI_H
#define FIX_NVE_VTI_H

#include <vector>

#include <lammps/fix.h>

#include "attitudes.h"
#include "vti.h"

namespace LAMMPS_NS
{

class FixNVEVTI : public Fix
{
  public:
    FixNVEVTI(LAMMPS *host, int narg, char **arg);
    int setmask() override;
    void init() override;
    void setup_post_neighbor() override;
    void setup(int) override;
    void post_neighbor() override;
    void initial_integrate(int) override;
    void final_integrate() override;

  private:
    /// Atoms next to each other that are all of this fix's group.
    struct Run {
        int first, count;
    };

    vti_bodies views();
    void look_at(int i);
    void stop(int status, const vti_fault &fault) const;

    const vti_stepper *method;
    Attitudes attitudes;         // of ellipsoids and bodies
    std::vector<double> inertia; // of spheres
    std::vector<Run> runs;
};

} // namespace LAMMPS_NS

#endif
