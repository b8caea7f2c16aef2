#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""./dev: paths are those of its caller, and what is missing is named for those who have no apt or no rights. The
programs are
stand-ins that write down where they are called and with what.      test_dev.py PROJECT"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from tally import check, conclude

project = pathlib.Path(sys.argv[1])
STAND_IN = '#!/bin/sh\nfor word in "$@"; do echo "$PWD|$word" >>"$CALLS"; done\n'
NINJA = "".join(f"build {target}: phony\n" for target in ("programs", "tests/conformance/test_fortran"))


def tree(folder):
    """A checkout that is built already, by stand-ins."""
    root = folder / "checkout"
    shutil.copytree(project / ".ci", root / ".ci")
    shutil.copy(project / "dev", root)
    for path in ("build/drivers/vti-run", "build/drivers/vti-study", "build/drivers/vti-advise", "build/drivers/vti-plot"):
        (root / path).parent.mkdir(parents=True, exist_ok=True)
        (root / path).write_text(STAND_IN, encoding="utf-8")
        (root / path).chmod(0o755)
    (root / "build" / "build.ninja").write_text(NINJA, encoding="utf-8")
    for module in ("plot/__init__", "plot/pages/__init__", "plot/pages/figures", "plot/pages/accuracy",
                   "instructions"):
        path = (root / ("tests/cost" if module == "instructions" else "drivers") / module).with_suffix(".py")
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("import os, sys\nwith open(os.environ['CALLS'], 'a') as calls:\n"
                        "    calls.writelines(f'{os.getcwd()}|{word}\\n' for word in sys.argv[1:])\n", encoding="utf-8")
    return root


def paths():
    """Each path that is given reaches the program as a name of the same file; nothing is written beside ./dev."""
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch).resolve()
        root = tree(folder)
        before = sorted(root.iterdir())
        elsewhere = folder / "else where"
        elsewhere.mkdir()
        for words, wanted in ((["run", "my.yaml", "-o", "out.h5"], ["my.yaml", "out.h5"]),
                              (["advise", "my.yaml"], ["my.yaml"]),
                              (["study", "my.yaml", "-o", "into"], ["my.yaml", "into"]),
                              (["figures", "mine"], ["mine", "mine/torus/out.h5", "mine/pendulum"]),
                              (["figures"], ["figures"]),
                              (["cost", "prices", "pages"], ["prices", "pages", "prices/spin/vti1.h5"])):
            for start, dev in ((elsewhere, "../checkout/dev"), (root, "./dev")):
                calls = folder / "calls"
                calls.write_text("", encoding="utf-8")
                result = subprocess.run([dev, *words], cwd=start, env=dict(os.environ, CALLS=str(calls)), text=True, check=False,
                                        timeout=60, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
                named = {os.path.join(*line.split("|", 1)) for line in calls.read_text(encoding="utf-8").splitlines()}
                lost = [path for path in wanted if str(start / path) not in named]
                where = "from another folder" if start == elsewhere else "from its own"
                good = check(result.returncode == 0 and not lost, f"./dev {' '.join(words)} {where}: {lost or 'all paths'}")
                if not good:
                    print(result.stdout)
                if start == elsewhere:
                    check(sorted(root.iterdir()) == before, "and nothing is written beside ./dev")
            for made in set(root.iterdir()) - set(before):
                shutil.rmtree(made)


def modules():
    """Programs that use a module are compiled anew when it has changed, and only then."""
    with tempfile.TemporaryDirectory() as scratch:
        root = tree(pathlib.Path(scratch).resolve())
        times = {"build/examples/a.p/a.f90.o": 1, "fortran/vti.f90": 2, "build/tests/conformance/b.p/b.f90.o": 3,
                 "examples/a.f90": 1, "tests/conformance/b.f90": 1, "build/examples/c.p/c.c.o": 1}
        for name, time in times.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).touch()
            os.utime(root / name, (time, time))
        result = subprocess.run(["./dev", "build"], cwd=root, text=True, check=False, timeout=60,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        gone = [name for name in times if not (root / name).exists()]
        if not check(result.returncode == 0 and gone == ["build/examples/a.p/a.f90.o"], f"older than a module: {gone}"):
            print(result.stdout)


def shell(script, path=None):
    """What .ci/need.sh does in a shell of its own, with commands of that path only."""
    return subprocess.run(["/bin/sh", "-euc", f". .ci/need.sh\n{script}"], cwd=project, text=True, check=False, timeout=60,
                          env=dict(os.environ, **({"PATH": str(path)} if path else {})),
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def needs():
    """An environment that has everything is taken as it is; otherwise names that somebody can use."""
    result = shell("needs='study | command:sh | x | x | x | x'\nbefore=$PATH\nneed study\n[ \"$PATH\" = \"$before\" ]")
    check(result.returncode == 0, f"where all is there PATH stays as it is {result.stdout}")

    for header, code in (("stdio.h", 0), ("no-such-header.h", 1)):
        result = shell(f"there header:cc/{header}")
        check(result.returncode == code, f"whether a compiler finds {header}: {result.stdout}")

    absent = "needs='study | command:no-such-command | no-such-package | x | x | x'\n"
    if shutil.which("dpkg-query"):
        result = shell(absent + "id() { echo 1000; }\nsudo() { return 1; }\nneed study")
        line = "as root: apt-get install -y --no-install-recommends no-such-package\n"
        check(result.returncode != 0 and line in result.stdout, f"without rights the line to run is printed: {result.stdout}")

    with tempfile.TemporaryDirectory() as scratch:
        for name in ("grep", "cut", "tr", "awk", "paste"):
            os.symlink(shutil.which(name), pathlib.Path(scratch) / name)
        result = shell("need study tests more", scratch)
        check(result.returncode != 0, "without apt and without anything else ./dev ends")
        lines = result.stdout.splitlines()
        for start, names in (("dev: missing", ["pkg-config:gsl", "pkg-config:libfyaml", "command:gfortran", "python3:h5py"]),
                             ("    dnf install ", ["gsl-devel", "openmpi-devel", "hdf5-devel", "gcc-gfortran"]),
                             ("    brew install ", ["gsl", "open-mpi", "hdf5", "libfyaml"]),
                             ("    conda install -c conda-forge ", ["gsl", "openmpi", "hdf5", "gfortran", "h5py"])):
            said = " ".join(line for line in lines if line.startswith(start)).split()
            check(all(name in said for name in names), f"without apt: {' '.join(said)}")


def conda():
    """The environment for conda is the table's column."""
    wanted = shell('for group in study tests more; do echo "$needs" | grep "^$group " | cut -d"|" -f6; done').stdout.split()
    text = (project / ".ci" / "environment.yml").read_text(encoding="utf-8")
    listed = [line.split()[1] for line in text.splitlines() if line.startswith("  - ")]
    check(listed == wanted, f"environment.yml names what .ci/need.sh names: {sorted(set(listed) ^ set(wanted)) or listed}")


paths()
modules()
needs()
conda()
conclude()
