#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The constants of module vti are those of the headers, all of them; and every procedure of the modules is called by some test or
example.      test_constants.py PROJECT"""
import pathlib
import re
import sys

from tally import check, conclude

project = pathlib.Path(sys.argv[1])


def constants(paths, pattern):
    return {name: int(value) for path in paths for name, value in re.findall(pattern, path.read_text())}


c = constants((project / "include").glob("*.h"), r"\b(VTI_[A-Z0-9_]+)(?: = |, | (?=\d+\n))(-?\d+)\b")
fortran = constants([project / "fortran/vti_types.f90"], r"\b(VTI_[A-Z0-9_]+) = (-?\d+)\b")
check(len(c) > 40 and "VTI_ABI" in c and "VTI_E_NULL" in c, f"{len(c)} constants in the headers")
for name in sorted(c.keys() | fortran.keys()):
    check(c.get(name) == fortran.get(name), f"{name}: {c.get(name)} in C, {fortran.get(name)} in Fortran")


def code(paths):
    """Without comments."""
    return "\n".join(re.sub("!.*", "", path.read_text().lower()) for path in paths)


modules = re.sub(r"abstract interface.*?end interface", "", code((project / "fortran").glob("*.f90")), flags=re.DOTALL)
procedures = set(re.findall(r"^(?!\s*end\b).*\b(?:function|subroutine) +(vti\w+)\(", modules, re.MULTILINE))
called = set(re.findall(r"\w+", code(path for folder in ("tests", "examples") for path in (project / folder).rglob("*.f*"))))
check(len(procedures) > 120 and "vti_history_add" in procedures and "vtibeg" in procedures, f"{len(procedures)} procedures of Fortran")
check(procedures <= called, f"each is called by a test or an example: {sorted(procedures - called)}")
conclude()
