# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the installed package share: a library that is built and installed for them, and running
commands."""
import atexit
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from tally import check

# the system's own, as ./dev has it
environment = dict(os.environ, PATH="/usr/bin:/bin:" + os.environ.get("PATH", ""))
for name in ("DESTDIR", "PKG_CONFIG_PATH", "CMAKE_PREFIX_PATH", "LD_LIBRARY_PATH", "MESON_BUILD_ROOT", "MESON_SOURCE_ROOT"):
    environment.pop(name, None)


def run(*command, folder=None, **more):
    """Runs a command with more environment variables; its output on success, None (and the output shown) on failure."""
    words = [str(word) for word in command]
    if not shutil.which(words[0], path=environment["PATH"]):
        print(f"{words[0]}: not there", flush=True)
        return None
    result = subprocess.run(words, cwd=folder, env=dict(environment, **more), text=True, check=False, timeout=900,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if result.returncode != 0:
        print(" ".join(words) + "\n" + result.stdout, flush=True)
        return None
    return result.stdout


def block(project, language):
    """The block of docs/linking.md in that language."""
    page = (project / "docs" / "linking.md").read_text(encoding="utf-8")
    return re.search(rf"^```{language}\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)[1]


def have(*programs):
    return all(shutil.which(program, path=environment["PATH"]) for program in programs)


def scratch(prefix):
    """A folder that does not outlive the test."""
    folder = pathlib.Path(tempfile.mkdtemp(prefix=prefix))
    atexit.register(shutil.rmtree, folder)
    return folder


class Installed:
    """The library of a project, installed below a prefix that nobody would guess."""

    def __init__(self, project):
        self.folder = scratch("vti-installed-")
        self.prefix = self.folder / "far" / "away"
        self.build = self.folder / "build"
        self.fortran = have("gfortran")
        options = ["-Ddrivers=disabled", "-Dtests=disabled", "-Dfortran=" + ("enabled" if self.fortran else "disabled"),
                   "-Doptimization=0"]
        done = run("meson", "setup", self.build, project, "--prefix", self.prefix, *options) is not None and \
            run("ninja", "-C", self.build) is not None
        if not check(done, "the library is built"):
            sys.exit(1)
        options = json.loads(run("meson", "introspect", "--buildoptions", self.build))
        self.lib = next(option["value"] for option in options if option["name"] == "libdir")

    def install(self, **more):
        return run("meson", "install", "-C", self.build, "--no-rebuild", **more) is not None

    def library_path(self):
        return {"LD_LIBRARY_PATH": str(self.prefix / self.lib)}

    def pkg_config(self, *arguments):
        text = run("pkg-config", *arguments, PKG_CONFIG_LIBDIR=str(self.prefix / self.lib / "pkgconfig"))
        return [] if text is None else text.split()

    def files(self, below):
        """Paths of all files below a folder, relative to it."""
        return sorted(str(path.relative_to(below)) for path in below.rglob("*") if not path.is_dir())
