# SPDX-License-Identifier: GPL-2.0-only
"""Runs of LAMMPS with our plugin, and what was found in them:  PROGRAM PLUGIN WORK_FOLDER COMMAND...
("%d" in the command is the number of ranks)"""
import pathlib
import re
import statistics
import subprocess
import sys

import numpy

here = pathlib.Path(__file__).resolve().parent
plugin, work = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
command = sys.argv[3:]
OURS = "nve/vti"
failures = 0
work.mkdir(exist_ok=True)


def check(condition, what):
    global failures
    print(("ok      " if condition else "FAILED  ") + what, flush=True)
    failures += not condition


def start(ranks, script, **variables):
    words = [word.replace("%d", str(ranks)) for word in command] + ["-log", "none", "-in", script, "-var", "plugin", str(plugin)]
    for name, value in variables.items():
        words += ["-var", name, str(value)]
    return subprocess.run(words, cwd=here, check=False, capture_output=True, text=True, timeout=600)


def lammps(ranks, script, **variables):
    """What it prints."""
    result = start(ranks, script, **variables)
    if result.returncode != 0:
        sys.exit(f"FAILED  {script} does not come to the end: {result.stdout[-2000:]}{result.stderr[-2000:]}")
    return result.stdout


def frames(ranks, script, move, h, steps, every, **variables):
    """[frame][atom][x, v, quaternion (w first), Omega or L and energy], as march.in has them."""
    out = work / "atoms.dump"
    lammps(ranks, script, move=move, h=repr(h), steps=steps, every=every, out=out, **variables)
    parts = re.split(r"ITEM: ATOMS.*\n", out.read_text(encoding="utf-8"))[1:]
    rows = [[line.split()[1:] for line in part.split("ITEM:")[0].splitlines()] for part in parts]
    return numpy.array(rows, dtype=float)


def times(steps, rounds, line, **variables):
    """Median seconds of a step by LAMMPS' fix and by ours, from turns in one run, and the median of their ratios."""
    text = lammps(1, "time.in", steps=steps, rounds=rounds, **variables)
    taken = [float(word) / steps for word in re.findall(line, text, re.MULTILINE)]
    theirs, ours = taken[0::2], taken[1::2]
    assert len(theirs) == len(ours) == rounds
    return statistics.median(theirs), statistics.median(ours), statistics.median(t / o for t, o in zip(theirs, ours))


def end():
    sys.exit(1 if failures else 0)
