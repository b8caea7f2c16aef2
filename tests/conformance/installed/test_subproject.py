#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""In another project's tree vti is a library and nothing more, unless that project asks.  test_subproject.py PROJECT"""
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

# as the page says: dependency() alone; what is installed here is not taken
MESON_BUILD_WRAP = """project('host', 'c', default_options: ['c_std=c99', 'force_fallback_for=vti'])
executable('host', 'host_structs.c', dependencies: dependency('vti'))
"""
MESON_BUILD_WRAP_FORTRAN = """project('host', 'c', 'fortran', default_options: ['force_fallback_for=vti'])
executable('pendulum', 'pendulum.f90', dependencies: dependency('vti-fortran', default_options: ['fortran=enabled']))
executable('host', 'host_structs.c', dependencies: dependency('vti'))
"""

project = pathlib.Path(sys.argv[1])
NARROW = "-Dvti:vectors=baseline"  # the wider kernels are built by test_installed.py
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
    return targets - {f"vti_{kind}_{unit}" for kind in ("binder", "move", "touch") for unit in ("baseline", "avx2", "avx512")}


def chain_ends(build):
    """The host of structs runs, and says where ten spheres end."""
    return len((run(build / "host", project / "examples" / "chain" / "bodies.csv") or "").split()) == 120


def use(text, build, expected):
    """It is set up, and of that project vti is a part with these targets."""
    (host / "meson.build").write_text(text, encoding="utf-8")
    if not check(run("meson", "setup", build, host, NARROW) is not None, f"{build.name}: set up"):
        return
    check(names(build) == expected, f"{build.name}: targets are {', '.join(sorted(names(build)))}")
    info = json.loads(run("meson", "introspect", "--projectinfo", build))
    check([part["version"] for part in info["subprojects"]] == [version], f"{build.name}: version {version}")


def wrapped(what):
    """Meson fetches vti itself, by the page's file with another address: that of a repository here."""
    origin, other, revision = host / "subprojects" / "vti", folder / "other", f"v{version}"
    git = ("git", "-C", origin, "-c", "user.name=test", "-c", "user.email=test@example.org")
    made = [run(*git, *words) for words in (("init", "-q"), ("add", "-A"), ("commit", "-q", "-m", "vti"), ("tag", revision))]
    if not check(None not in made, f"{what}: a repository"):
        return
    text = block(project, "ini")
    check(f"revision = {revision}\n" in text, f"{what}: revision {revision}")
    (other / "subprojects").mkdir(parents=True)
    (other / "subprojects" / "vti.wrap").write_text(re.sub(r"(?m)^url = .*", f"url = {origin.as_uri()}", text), encoding="utf-8")
    for source in ("host_structs.c", "pendulum.f90"):
        shutil.copy(project / "examples" / source, other)
    fortran, build = have("gfortran"), folder / "wrapped"
    (other / "meson.build").write_text(MESON_BUILD_WRAP_FORTRAN if fortran else MESON_BUILD_WRAP, encoding="utf-8")
    check(run("meson", "setup", build, other, NARROW) is not None, f"{what}: fetched")
    good = run("ninja", "-C", build) is not None and chain_ends(build)
    good = good and (not fortran or "energy = 0.74711" in (run(build / "pendulum") or ""))
    check(good, f"{what}: {'Fortran and C' if fortran else 'C'}, built and run")


# the page's own words; a copy that is installed on this machine must not be taken for this one
use(block(project, "meson").replace("'c_std=c99'", "'c_std=c99', 'force_fallback_for=vti'"), folder / "core", {"host", "vti"})
check(run("ninja", "-C", folder / "core") is not None and chain_ends(folder / "core"), "core: built and run")
if have("gfortran"):
    use(MESON_BUILD_FORTRAN, folder / "with-fortran", {"host", "vti", "vti_fortran"})
if have("git"):
    wrapped("the page's vti.wrap")
conclude()
