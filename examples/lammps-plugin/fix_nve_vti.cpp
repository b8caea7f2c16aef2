/* SPDX-License-Identifier: GPL-2.0-only */
#include "fix_nve_vti.h"

#include <lammps/atom.h>
#include <lammps/compute.h>
#include <lammps/error.h>
#include <lammps/force.h>
#include <lammps/modify.h>
#include <lammps/update.h>

using namespace LAMMPS_NS;

static const char STRANGE[] =
    "LAMMPS keeps its attitude and shape in another way than the version that this plugin was "
    "built for; build it anew";

FixNVEVTI::FixNVEVTI(LAMMPS *host, int narg, char **arg)
    : Fix(host, narg, arg), method(vti_stepper_find(narg > 3 ? arg[3] : "vti2")), attitudes(atom)
{
    time_integrate = 1;
    if (narg > 4)
        error->all(FLERR, "Fix nve/vti takes the name of a stepper and nothing else");
    // LAMMPS evaluates forces once a step, and its moments and spins are in space.
    if (!method || method->stages != 1 || method->lag != 0.0 || method->frame != VTI_FRAME_SPACE)
        error->all(FLERR, "Fix nve/vti has the steppers vti1, vti2, vti3 and exact, not {}", arg[narg - 1]);
    if (!attitudes && (!atom->omega || !atom->torque || !atom->radius || !atom->rmass))
        error->all(FLERR, "Fix nve/vti needs atoms that turn: atom_style sphere, bpm/sphere, ellipsoid or body");
}

int FixNVEVTI::setmask()
{
    return FixConst::INITIAL_INTEGRATE | FixConst::POST_NEIGHBOR | FixConst::FINAL_INTEGRATE;
}

void FixNVEVTI::init()
{
    if (utils::strmatch(update->integrate_style, "^respa"))
        error->all(FLERR, "Fix nve/vti has one time step for all forces: run_style verlet");
    if (force->ftm2v != 1.0)
        error->all(FLERR, "Fix nve/vti needs units in which force is mass times acceleration, such as lj and si");
}

/* Atoms change places only where neighbour lists are built, so that this is the only place to look at them one by
 * one. */
void FixNVEVTI::post_neighbor()
{
    const int n = atom->nlocal;
    if (attitudes)
        attitudes.renew();
    else
        inertia.resize(n);
    runs.clear();
    for (int i = 0; i < n; ++i) {
        if (!(atom->mask[i] & groupbit))
            continue;
        look_at(i);
        if (runs.empty() || runs.back().first + runs.back().count < i)
            runs.push_back({i, 0});
        ++runs.back().count;
    }
    const vti_bodies all = views();
    for (const Run &run : runs) {
        vti_fault fault = {-1, 0.0, VTI_QUANTITY_NONE};
        const vti_bodies bodies = vti_bodies_slice(all, run.first, run.count);
        stop(vti_bodies_check_values(&bodies, &fault), fault);
    }
}

void FixNVEVTI::look_at(int i)
{
    if (!attitudes)
        inertia[i] = 0.4 * atom->rmass[i] * atom->radius[i] * atom->radius[i];
    else if (!attitudes.has(i))
        error->one(FLERR, "Fix nve/vti, atom {} is a point: give it a shape, or leave it out of the fix's group",
                   atom->tag[i]);
    else if (!attitudes.look_at(i))
        error->one(FLERR, "Fix nve/vti, atom {}: {}", atom->tag[i], STRANGE);
}

void FixNVEVTI::setup_post_neighbor()
{
    post_neighbor();
}

/* Whether attitudes and shapes are what LAMMPS itself says they are. */
void FixNVEVTI::setup(int)
{
    if (!attitudes)
        return;
    const std::string name = std::string(id) + "_vti";
    Compute *said = modify->add_compute(fmt::format("{} all property/atom quatw quati quatj quatk{}", name,
                                                    attitudes.of_ellipsoids() ? " shapex shapey shapez" : ""));
    said->init();
    said->compute_peratom();
    for (const Run &run : runs)
        for (int i = run.first; i < run.first + run.count; ++i)
            if (!attitudes.agrees(i, said->array_atom[i]))
                error->one(FLERR, "Fix nve/vti, atom {}: {}", atom->tag[i], STRANGE);
    modify->delete_compute(name);
}

/* LAMMPS' arrays as they are; they may move whenever they grow, so that nothing is kept. Its quaternions are (w, x, y,
 * z); where atoms have none, as those of atom_style sphere, nothing is turned, and spins are kicked all the same. Ellipsoids
 * and bodies have spatial angular momenta, which is what the library's bodies of three moments have (EQUATIONS 7.1). */
vti_bodies FixNVEVTI::views()
{
    vti_bodies bodies = vti_bodies_none(atom->nlocal);
    bodies.x = vti_view_packed(atom->x[0]);
    bodies.v = vti_view_packed(atom->v[0]);
    bodies.force = vti_view_packed(atom->f[0]);
    bodies.moment = vti_view_packed(atom->torque[0]);
    bodies.mass = vti_scalars_array(atom->rmass);
    if (double *q = attitudes ? attitudes.quat.data() : atom->quat ? atom->quat[0] : nullptr)
        bodies.quat = {{q + 1, q + 2, q + 3, q}, 4, 0};
    if (attitudes) {
        bodies.spin = vti_view_packed(atom->angmom[0]);
        bodies.moments = vti_view_packed(attitudes.moments.data());
    } else {
        bodies.omega = vti_view_packed(atom->omega[0]);
        bodies.inertia = vti_scalars_array(inertia.data());
    }
    return bodies;
}

void FixNVEVTI::initial_integrate(int)
{
    const vti_bodies all = views();
    for (const Run &run : runs) {
        vti_fault fault = {-1, 0.0, VTI_QUANTITY_NONE};
        const vti_bodies bodies = vti_bodies_slice(all, run.first, run.count);
        if (attitudes)
            attitudes.read(run.first, run.count);
        stop(vti_step_begin(method, update->dt, &bodies, &fault), fault);
        if (attitudes)
            attitudes.write(run.first, run.count);
    }
}

void FixNVEVTI::final_integrate()
{
    const vti_bodies all = views();
    for (const Run &run : runs) {
        const vti_bodies bodies = vti_bodies_slice(all, run.first, run.count);
        stop(vti_step_finish(method, update->dt, &bodies), {-1, 0.0, VTI_QUANTITY_NONE});
    }
}

void FixNVEVTI::stop(int status, const vti_fault &fault) const
{
    if (status == VTI_OK)
        return;
    const long long tag = fault.body >= 0 ? atom->tag[fault.body] : 0;
    error->one(FLERR, "Fix nve/vti, atom {}, {} {}: {}", tag, vti_quantity_text(fault.quantity), fault.value,
               vti_status_text(status));
}
