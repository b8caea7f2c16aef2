#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""No -march makes a step, an effect or a lone body dearer than the default build by more than 5 %, whatever the
compiler, and no compiler's default build dearer than gcc's: the library is built here by each, and callgrind, which
knows vectors up to AVX2, counts. test_march.py ROOT VALGRIND"""
import concurrent.futures
import glob
import os
import re
import shutil
import subprocess
import sys
import tempfile

from tally import check, conclude

ROOT, VALGRIND = sys.argv[1:3]
FLAGS = ["-std=c99", "-O3", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math", "-DVTI_HAS_AVX2",
         f"-I{ROOT}/include", f"-I{ROOT}/src", f"-I{ROOT}/tests"]
CACHE = ["ccache"] if shutil.which("ccache") else []
COMPILERS = [name for name in ("gcc", "gcc-14", "clang") if shutil.which(name)]
MACHINES = ("", "-march=x86-64-v3")
STEPS = 20
# letters of cost.c: what translates, turns and is loaded, with bonds, contacts, walls, gravity, as a pendulum, and one
# of those
SCENES = {"a step of spheres": "trl", "bonds": "trlmas", "contacts": "trlc", "walls": "trlw", "gravity": "trlg",
          "pendulums": "rlp", "one pendulum": "rlp1"}


def compile_one(task):
    """A source by a compiler and flags of its own."""
    compiler, flags, folder, path = task
    wide = ["-mavx2"] if path.endswith("_avx2.c") else []
    if compiler != "clang" and flags and flags[0]:
        wide.append("-fno-tree-slp-vectorize")      # as meson.build has it
    subprocess.run([*CACHE, compiler, *FLAGS, *flags, *wide, "-c", path, "-o", f"{folder}/{os.path.basename(path)}.o"], check=True)


def count(program, scene, steps):
    result = subprocess.run([VALGRIND, "--tool=callgrind", "--callgrind-out-file=/dev/null", program, scene, str(steps)],
                            capture_output=True, text=True, check=True)
    return int(re.search(r"Collected : (\d+)", result.stderr)[1])


def per_step(program):
    return {name: (count(program, scene, STEPS) - count(program, scene, 0)) / STEPS for name, scene in SCENES.items()}


with tempfile.TemporaryDirectory() as root:
    builds = {(compiler, flag): os.path.join(root, compiler + flag) for compiler in COMPILERS for flag in MACHINES}
    sources = [path for path in glob.glob(f"{ROOT}/src/**/*.c", recursive=True) if not path.endswith("_avx512.c")] + [f"{ROOT}/bench/cost.c"]
    tasks = [(compiler, [flag] * (flag != ""), folder, path) for (compiler, flag), folder in builds.items() for path in sources]
    for folder in builds.values():
        os.mkdir(folder)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(compile_one, tasks))
        for (compiler, _), folder in builds.items():
            subprocess.run([compiler, *glob.glob(f"{folder}/*.o"), "-lm", "-o", f"{folder}/cost"], check=True)
        counts = dict(zip(builds, pool.map(per_step, (f"{folder}/cost" for folder in builds.values()))))
for (compiler, flag), found in counts.items():
    for name, value in found.items():
        default, first = counts[compiler, ""][name], counts[COMPILERS[0], ""][name]
        check(value <= 1.05 * default and (flag != "" or value <= 1.05 * first), f"{compiler} {flag}: {name}: {value:.0f} instructions a step, "
              f"{value / default:.3f} of the default's, {value / first:.3f} of {COMPILERS[0]}'s")
conclude()
