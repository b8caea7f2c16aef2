#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Whole programs write the same bytes on processors with and without FMA, AVX2 and AVX-512: glibc is told to take no
notice of them, so that its sin, cos, exp and pow have other last bits. Nothing that moves a body or is compared may
come from those.

    test_masks.py LIBM VTI_RUN VTI_STUDY ROOT
"""
import hashlib
import os
import re
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from programs import ENVIRONMENT, contents, run  # pylint: disable=wrong-import-position
from tally import check, conclude, failures  # pylint: disable=wrong-import-position

libm, vti_run, vti_study, root = map(os.path.abspath, sys.argv[1:])

# glibc before 2.33 knows a unit by what of it is usable; names that are not known are passed over.
UNITS = (("AVX512F",), ("FMA", "FMA4", "AVX2", "AVX512F"),
         ("SSE4_1", "SSE4_2", "AVX", "FMA", "FMA4", "AVX2", "AVX512F", "AVX512VL", "BMI2", "ERMS"))
MASKS = {"without " + ", ".join(units): "glibc.cpu.hwcaps=" + ",".join(f"-{u},-{u}_Usable" for u in units) for units in UNITS}

RUNS = {
    "spin": ("spin", "--t-end", "10"),
    "pendulum": ("pendulum", "--t-end", "10"),
    "chain": ("chain", "--t-end", "1", "--stepper", "srkn11"),
    "block": ("block", "--t-end", "1"),
    "pile": ("pile", "--t-end", "0.5"),
    "torus": ("torus", "--t-end", "1", "--set", "binder.axial=10^2.3", "--h", "2^-10.1"),
}
STUDIES = {
    "pendulum study": ("pendulum", "--h", "2^-5:2^-8", "--t-end", "2"),
    "torus study": ("torus", "--h", "1/500:1/2000", "--t-end", "1/8"),
    "costs": ("pendulum", "--cost", "--repeats", "1", "--t-end", "1", "--evals", "4096"),
}
TIMES = ("timing.csv", "machine.txt", "cost.csv", "prices.csv")  # files with times, which nobody compares


def digest(files):
    return hashlib.sha256(repr(sorted(files.items())).encode()).hexdigest()[:16]


def digests(environment):
    found = {}
    for name, (scene, *options) in {**RUNS, **STUDIES}.items():
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(root, "scenes", scene + ".yaml")
            command = [vti_run, path, *options, "-o", "out.h5"] if name in RUNS else [vti_study, path, *options, "--no-plot",
                                                                                     "-o", "out"]
            result = run(*command, cwd=folder, env=environment)
            made = contents(folder if name in RUNS else os.path.join(folder, "out"), TIMES) if result.returncode == 0 else {}
            check(len(made) > 0 and all(made.values()), f"{name} ends and writes files {result.stderr[-200:] if not made else ''}")
            found[name] = digest(made)
    return found


def who_calls_libm():
    """The sources' calls of functions that are not rounded alike everywhere, by file."""
    inexact = re.compile(r"(?<![\w.>])(a?(?:sin|cos|tan)h?|atan2|sincos|exp[2m]?1?|log(?:2|10|1p)?|pow|cbrt|hypot|fma)f?\(")
    comment = re.compile(r"/\*.*?\*/|//[^\n]*|\"(?:[^\"\\]|\\.)*\"", re.DOTALL)
    found = {}
    for part in ("include", "src", "drivers"):
        for folder, _, names in os.walk(os.path.join(root, part)):
            for name in names:
                if name.endswith((".c", ".h")):
                    path = os.path.join(folder, name)
                    with open(path, encoding="utf-8") as file:
                        calls = inexact.findall(comment.sub("", file.read()))
                    if calls:
                        found[os.path.relpath(path, root)] = sorted(set(calls))
    return found


# vti-check judges a host's stepper to tolerances; the header's two are for angles beyond 2^20
callers = {path: calls for path, calls in who_calls_libm().items() if not path.startswith("drivers/check/")}
callers.pop("drivers/programs/run_text.c", None)  # degrees on the terminal
check(callers == {"include/vti_rrv.h": ["cos", "sin"]}, f"nobody else calls libm's inexact functions: {callers}")

usual = run(libm).stdout
tellings = {name: run(libm, env=dict(ENVIRONMENT, GLIBC_TUNABLES=mask)).stdout for name, mask in MASKS.items()}
if all(told == usual for told in tellings.values()):
    print("skipped: no mask changes what libm gives; this machine has no such units, or its libm takes no notice of masks")
    sys.exit(1 if failures else 77)
expected = digests(ENVIRONMENT)
for mask_name, mask in MASKS.items():
    there = digests(dict(ENVIRONMENT, GLIBC_TUNABLES=mask))
    note = "" if tellings[mask_name] != usual else " (libm's are the same)"
    for name, value in expected.items():
        check(there[name] == value, f"{name}: the same bytes {mask_name}{note}")
for name, value in expected.items():
    print(f"{name} {value}")
conclude()
