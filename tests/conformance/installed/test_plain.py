#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The plain way of README.md, as it stands there: setup of everything, and the library alone built, installed and used,
by a
folder of commands that has a C compiler and no other.      test_plain.py PROJECT"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from tally import check, conclude

project = pathlib.Path(sys.argv[1])
blocks = re.findall(r"^```sh\n(meson .*?)^```$", (project / "README.md").read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
check(len(blocks) == 2, "README.md has two plain ways")

COMPILERS = ("CC", "CXX", "FC", "LDFLAGS")


def run(line, home, path):
    # a CC of the caller's may name what the bare folder does not have
    environment = {**{name: value for name, value in os.environ.items() if not name.startswith("MESON") and name not in COMPILERS},
                   "HOME": str(home), "PATH": str(path), "PKG_CONFIG_LIBDIR": str(home)}
    result = subprocess.run(line, shell=True, cwd=home / "vti-source", env=environment, text=True, check=False, timeout=900,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if not check(result.returncode == 0, line):
        print(result.stdout)
    return result.stdout


with tempfile.TemporaryDirectory() as scratch:
    home = pathlib.Path(scratch)
    shutil.copytree(project, home / "vti-source", ignore=shutil.ignore_patterns("build*", ".git", "study-*", "figures", "cost"))
    bare = home / "bare"
    bare.mkdir()
    for name in ("meson", "ninja", "cc", "as", "ld", "ar", "rm", "sh", "sed"):
        os.symlink(shutil.which(name), bare / name)
    for line in blocks[1].splitlines():
        run(line, home, bare)
    prefix = home / "vti"
    check((prefix / "include" / "vti.h").exists() and (prefix / "share" / "doc" / "vti" / "LICENSE").exists(),
          "the library and its licence are there")
    archive = next(prefix.rglob("libvti.a"))
    run(f"cc -std=c99 -I{prefix}/include examples/pendulum.c {archive} -lm -o {home}/pendulum", home, bare)
    check("energy = 0.74711" in run(str(home / "pendulum"), home, bare), "and a host uses it")
    shutil.rmtree(prefix)
    said = run(blocks[0].splitlines()[0], home, bare)
    check("gsl found: NO" in said and not re.search("Fortran compiler for the host", said), "what is not found is left out")
conclude()
