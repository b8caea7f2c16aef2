#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""In another project's tree vti is a library and nothing more, unless that project asks.       test_subproject.py PROJECT"""
import json
import pathlib
import re
import shutil
import sys

from install_support import block, have, run, scratch
from tally import check, conclude

MESON_BUILD_FORTRAN = """project('host', 'c', 'fortran')
subproject('vti', default_options: ['fortran=enabled'])
executable('host', 'pendulum.f90', dependencies: dependency('vti-fortran'))
"""

project = pathlib.Path(sys.argv[1])
version = re.search(r'VTI_VERSION_STRING "(.*)"', (project / "include" / "vti.h").read_text(encoding="utf-8"))[1]
folder = scratch("vti-subproject-")
host = folder / "host"
built = ("build*", ".git", "__pycache__", "study-*", "figures")
shutil.copytree(project, host / "subprojects" / "vti", ignore=shutil.ignore_patterns(*built))
for source in ("host_structs.c", "pendulum.f90"):
    shutil.copy(project / "examples" / source, host)


def names(build):
    """Of the targets; the kernels of the core for wider vector units are there or not."""
    targets = {target["name"] for target in json.loads(run("meson", "introspect", "--targets", build))}
    return targets - {"vti_avx2", "vti_avx512"}


def use(text, build, expected, ending):
    (host / "meson.build").write_text(text, encoding="utf-8")
    good = run("meson", "setup", build, host) is not None and run("ninja", "-C", build) is not None
    check(good, f"{build.name}: built")
    if not good:
        return
    check(names(build) == expected, f"{build.name}: targets are {', '.join(sorted(names(build)))}")
    said = run(build / "host", project / "examples" / "chain" / "bodies.csv") or ""
    check(ending(said), f"{build.name}: it runs and ends with {said.split()[-3:]}")
    info = json.loads(run("meson", "introspect", "--projectinfo", build))
    check([part["version"] for part in info["subprojects"]] == [version], f"{build.name}: version {version}")


# the page's own words; a copy that is installed on this machine must not be taken for this one
use(block(project, "meson").replace("'c_std=c99'", "'c_std=c99', 'force_fallback_for=vti'"), folder / "core", {"host", "vti"},
    lambda said: len(said.split()) == 120)
if have("gfortran"):
    use(MESON_BUILD_FORTRAN, folder / "with-fortran", {"host", "vti", "vti_fortran"},
        lambda said: "energy = 0.74711" in said)
conclude()
