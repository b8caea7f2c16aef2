#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The installed library is used from a folder of its own: by pkg-config from C and Fortran, shared and static, by CMake
from
C, C++ and Fortran, and after it has been moved; DESTDIR; what is installed and what is not.    test_installed.py PROJECT"""
import pathlib
import re
import shutil
import sys

from install_support import Installed, block, have, run
from tally import check, conclude

ANGLE = """#include "vti.h"
int main(int argc, char **argv)
{
    const double a[3] = {argc, 0, 0};
    return argv == 0 || vti_rrv_angle(a) > 4;
}
"""
project = pathlib.Path(sys.argv[1])
here = pathlib.Path(__file__).parent
version = re.search(r'VTI_VERSION_STRING "(.*)"', (project / "include" / "vti.h").read_text(encoding="utf-8"))[1]
major, minor = version.split(".")[:2]
interface = f"0.{minor}" if major == "0" else major     # of 0.y.z each y has its own
package = Installed(project)
use = package.folder / "use"
use.mkdir()
for source in ("pendulum.c", "pendulum.f90"):
    shutil.copy(project / "examples" / source, use)
shutil.copytree(project / "examples", use / "examples")
for source in ("rotation.cpp", "check.cpp", "turn.f", "cmake"):
    (shutil.copytree if (here / source).is_dir() else shutil.copy)(here / source, use / source)


def expected():
    """What an installation holds, relative to its prefix."""
    lib = package.lib + "/"
    files = ["include/" + header.name for header in (project / "include").glob("*.h")]
    files += [lib + name for name in ("libvti.a", "libvti.so", "libvti.so." + interface, "pkgconfig/vti.pc",
                                      "libvti_check.a", "pkgconfig/vti-check.pc")] + ["include/vti_check.h"]
    files += ["lib/cmake/vti/vti-config.cmake", "lib/cmake/vti/vti-config-version.cmake"]
    files += ["share/doc/vti/" + str(path.relative_to(project)) for path in (project / "examples").rglob("*")
              if path.is_file() and path.name != "meson.build" and "lammps" not in str(path.relative_to(project))]
    files += ["share/doc/vti/" + name for name in ("LICENSE", "README.md", "CHANGELOG.md", "CONTRIBUTING.md")]
    files += ["share/doc/vti/" + str(path.relative_to(project)) for path in (project / "docs").rglob("*")
              if path.is_file() and path.name != "Doxyfile"]
    if package.fortran:
        sources = [path.name for path in (project / "fortran").glob("*.f90")]
        gfortran = "gfortran-" + run("gfortran", "-dumpversion").strip().split(".", maxsplit=1)[0]
        files += ["share/vti/fortran/" + name for name in sources + ["vti_rrv.c"]]
        files += [f"include/vti/{gfortran}/{name[:-4]}.mod" for name in sources if "f77" not in name]
        files += [lib + "libvti_fortran.a", lib + "pkgconfig/vti-fortran.pc"]
    return sorted(files)


def ran(program, what, path=None):
    """The program runs; the pendulum keeps its energy of 0.04 + sqrt(1/2), the other body is turned by 0.5."""
    text = run(program, **(package.library_path() if path is None else path)) or ""
    check("energy = 0.747111736440" in text or "turned by 0.5" in text, f"{what}: {text.strip()}")


def destdir():
    stage = package.folder / "stage"
    check(package.install(DESTDIR=str(stage)), "installed with DESTDIR")
    below = stage / package.prefix.relative_to("/")
    found = package.files(below)
    check(found == expected(), f"what is installed: {sorted(set(found) ^ set(expected())) or 'as it should be'}")
    check(len(package.files(stage)) == len(found), "nothing is installed beside the prefix")
    check(not package.prefix.exists(), "with DESTDIR the prefix itself stays as it is")
    for path in below.rglob("*"):
        if path.suffix in (".pc", ".cmake"):
            check(str(stage) not in path.read_text(encoding="utf-8"), f"{path.name} does not know of DESTDIR")
        if path.suffix == ".md":
            links = re.findall(r"\]\(([^)#:]+)[)#]", path.read_text(encoding="utf-8"))
            dead = [link for link in links if not (path.parent / link).exists()]
            check(not dead, f"{path.name} as installed: {dead} are not there" if dead else f"{path.name} as installed: its links")


def by_pkg_config():
    check(package.pkg_config("--modversion", "vti") == [version], "pkg-config knows the version")
    flags = package.pkg_config("--cflags", "--libs", "vti")
    if not check(run("cc", "-std=c99", "-Wall", "-Wextra", "-Werror", "pendulum.c", "-o", "c_shared", *flags, folder=use)
                 is not None, "C, shared: compiled"):
        return
    needed = run("readelf", "-d", use / "c_shared") or ""
    check(f"[libvti.so.{interface}]" in needed, "the program asks for the library by the version of its interface")
    ran(use / "c_shared", "C, shared")
    (use / "angle.c").write_text(ANGLE, encoding="utf-8")
    check(run("cc", "angle.c", "-o", "angle", *flags, folder=use) is not None, "what inline functions call is linked too")
    archive = package.prefix / package.lib / "libvti.a"
    run("cc", "pendulum.c", "-o", "c_static", *package.pkg_config("--cflags", "vti"), archive, "-lm", folder=use)
    ran(use / "c_static", "C, static", path={})
    if not package.fortran:
        return
    flags = package.pkg_config("--cflags", "--libs", "vti-fortran")
    run("gfortran", "-std=f2008", "-Wall", "-Wextra", "-Werror", "pendulum.f90", "-o", "fortran", *flags, folder=use)
    ran(use / "fortran", "Fortran, module")
    run("gfortran", "-std=legacy", "-Wall", "-Wextra", "-Werror", "turn.f", "-o", "f77", *flags, folder=use)
    ran(use / "f77", "Fortran 77, no module")


def from_sources():
    """For a compiler that cannot read the module files that are there."""
    sources = package.prefix / "share" / "vti" / "fortran"
    order = ["types", "rrv", "c", "c_effects", "c_bonds", "sums", "views", "steps", "controls", "multisteps", "effects",
             "effects_bonds", "effects_contacts", "packed"]
    files = [sources / f"vti_{name}.f90" for name in order] + [sources / "vti.f90"]
    own = use / "own"
    own.mkdir()
    run("cc", "-c", sources / "vti_rrv.c", "-o", own / "calls.o", *package.pkg_config("--cflags", "vti"), folder=use)
    run("gfortran", f"-J{own}", *files, own / "calls.o", "pendulum.f90", "-o", "from_sources", *package.pkg_config("--libs", "vti"), folder=use)
    ran(use / "from_sources", "Fortran, module from its sources")


def ends(program, path=None):
    """Where a host of the chain ends, as numbers."""
    text = run(program, "chain/bodies.csv", folder=use / "examples", **(package.library_path() if path is None else path)) or ""
    return [float(word) for line in text.splitlines() if not line.startswith("energy") for word in line.split()]


def by_the_page():
    """The commands of docs/linking.md and README.md, as they stand there."""
    examples = use / "examples"
    for line in block(project, "sh").splitlines():
        if ("gfortran" in line and not package.fortran) or not have(line.split()[0]):
            continue
        run("sh", "-c", line, folder=examples, PKG_CONFIG_LIBDIR=str(package.prefix / package.lib / "pkgconfig"))
        name = line.split()[-1]
        end = ends(examples / name, {})
        loaded = run("ldd", examples / name) or ""
        check(str(package.prefix) in loaded, f"linking.md: {name} finds this copy by itself")
        check(len(end) == 120 and end == ends(examples / "host_structs"), f"linking.md: {line}")
    commands = re.findall(r"^```sh\n(.*?)^```$", (project / "README.md").read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    for line in next(block for block in commands if "pkg-config" in block).splitlines():
        if line.startswith("cc ") or (line.startswith("gfortran ") and package.fortran):
            name = line.split()[-1]
            run("sh", "-c", line, folder=use, PKG_CONFIG_LIBDIR=str(package.prefix / package.lib / "pkgconfig"),
                LD_RUN_PATH=str(package.prefix / package.lib))
            check(str(package.prefix) in (run("ldd", use / name) or ""), f"README.md: {name} finds this copy by itself")
            ran(use / name, f"README.md: {line}", {})
    if have("cmake", "ninja"):
        (examples / "CMakeLists.txt").write_text(block(project, "cmake"), encoding="utf-8")
        run("cmake", "-G", "Ninja", "-S", examples, "-B", use / "page", f"-DCMAKE_PREFIX_PATH={package.prefix}")
        run("cmake", "--build", use / "page")
        check(ends(use / "page" / "host") == ends(examples / "host_structs"), "linking.md: CMake")


def by_check_kit():
    """A host's own step behind the conformance kit."""
    hosts = [("cc", "examples/check_host.c", ["vti-check"])]
    if have("c++"):
        hosts.append(("c++", "check.cpp", ["vti-check"]))
    if package.fortran:
        hosts.append(("gfortran", "examples/check_host.f90", ["vti-fortran", "vti-check"]))
    for compiler, source, packages in hosts:
        program = use / (pathlib.Path(source).name + ".out")
        flags = package.pkg_config("--cflags", "--libs", *packages)
        run(compiler, "-Wall", "-Wextra", "-Werror", source, "-o", program, *flags, folder=use)
        checked(program, source)


def checked(program, what, path=None):
    """The kit looks at a step and finds nothing wrong; the program of C++ has a second step, which is."""
    said = run(program, **(package.library_path() if path is None else path)) or ""
    good = "no fault found" in said and ("cpp" not in program.name or "does nothing" in said)
    check(good, f"{what} is checked by the installed kit")


def by_cmake(prefix, what, path):
    build = use / ("cmake-" + what)
    options = [f"-DCMAKE_PREFIX_PATH={prefix}", f"-DWITH_FORTRAN={'ON' if package.fortran else 'OFF'}"]
    said = run("cmake", "-G", "Ninja", "-S", use / "cmake", "-B", build, "-DWANTED=" + version, *options) or ""
    check(f"found in: {prefix}/" in said, f"CMake, {what}: finds this one")
    good = run("cmake", "--build", build) is not None
    check(good, f"CMake, {what}: built")
    for name in ["c_shared", "c_static", "cpp"] + (["fortran", "f77"] if package.fortran else []):
        if good:
            ran(build / name, f"CMake, {what}, {name}", path)
    for name in ["check", "check_cpp"] + (["check_fortran"] if package.fortran else []):
        if good:
            checked(build / name, f"CMake, {what}, {name}", path)
    versions = [(f"{major}.{minor}", True), (f"{major}.{int(minor) + 1}", False), (str(int(major) + 1), False)]
    if int(minor) > 0:
        versions.append((f"{major}.{int(minor) - 1}", int(major) > 0)) # of 0.y.z each y has its own interface
    next_one = f"{major}.{int(minor) + 1}"
    for wanted, part, fits in [(wanted, "", fits) for wanted, fits in versions] + [
            (f"0.0...{next_one}", "", True), (f"0.0...<{version}", "", False), (f"{next_one}...{next_one}.9", "", False),
            (version, "check", True), (version, "fortran", package.fortran), (version, "nonsense", False)]:
        out = run("cmake", "-G", "Ninja", "-S", use / "cmake", "-B", build, "-DWANTED=" + wanted, "-DONLY_FIND=ON", f"-DPARTS={part}", *options) or ""
        check(f"found: {1 if fits else 0}" in out, f"CMake, {what}: version {wanted} {part} {'fits' if fits else 'does not fit'}")


def elsewhere():
    """Libraries and headers in folders of their own, outside the prefix."""
    package.prefix, package.lib, headers = package.folder / "third", str(package.folder / "elsewhere" / "lib"), package.folder / "elsewhere" / "headers"
    run("meson", "configure", package.build, f"-Dprefix={package.prefix}", f"-Dlibdir={package.lib}", f"-Dincludedir={headers}")
    check(run("ninja", "-C", package.build) is not None and package.install(), "installed, libraries and headers elsewhere")
    by_cmake(package.prefix, "elsewhere", package.library_path())
    if package.fortran:
        run("gfortran", "pendulum.f90", "-o", "elsewhere", *package.pkg_config("--cflags", "--libs", "vti-fortran"), folder=use)
        ran(use / "elsewhere", "Fortran, elsewhere")


destdir()
check(package.install(), "installed")
by_pkg_config()
by_the_page()
by_check_kit()
if package.fortran:
    from_sources()
if have("cmake", "ninja", "c++"):
    by_cmake(package.prefix, "installed", {})
    moved = package.folder / "moved"
    package.prefix.rename(moved)
    by_cmake(moved, "moved", {"LD_LIBRARY_PATH": str(moved / package.lib)})
    elsewhere()
else:
    print("skipped: CMake, because cmake, ninja or c++ is not here")
conclude()
