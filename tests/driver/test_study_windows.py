#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""vti-study's reference in windows of bounded memory, against closed forms of a free spin, at which every quantity is
known: with |Omega| = 1 from alpha = 0 the angle is t, folded into [0, pi]; VTI-2 turns by 2 atan(h/2) a step.
                            test_study_windows.py VTI_STUDY MPIRUN SCENES"""
import csv
import math
import os
import pty
import resource
import select
import signal
import subprocess
import sys
import tempfile

import h5py

from programs import ENVIRONMENT, PATIENCE, contents, one_line, run
from tally import MEMORY_TELLS, check, conclude

STUDY, MPIRUN, SCENES = map(os.path.abspath, sys.argv[1:4])
SPIN, PENDULUM, TORUS = (os.path.join(SCENES, name + ".yaml") for name in ("spin", "pendulum", "torus"))
PANEL = 16 * 7 * 8e-6  # MB: nodes, a quaternion and a spin at each, bytes; a panel spans 0.5 or less


def study(ranks, scene, *arguments):
    return run(MPIRUN, "-n", str(ranks), STUDY, scene, "--no-plot", *arguments)


def rows(folder):
    with open(os.path.join(folder, "study.csv"), newline="", encoding="ascii") as file:
        return list(csv.DictReader(file))


def folded_squares(t):
    """int_0^t theta^2, theta the angle t folded into [0, pi]."""
    turns, rest = divmod(t, 2 * math.pi)
    half = math.pi ** 3 / 3
    return 2 * half * turns + (rest ** 3 / 3 if rest <= math.pi else 2 * half - (2 * math.pi - rest) ** 3 / 3)


def closed_forms(base):
    """One panel at a time, a few, and all: with ends of runs within windows and at their ends."""
    t_end = 30
    for memory in (PANEL, 4.5 * PANEL, 1000):
        folder = f"{base}/{memory}"
        done = study(2, SPIN, "--t-end", str(t_end), "--h", "1/2,1/3,1/7,1/64", "--memory", repr(memory), "-o", folder)
        check(done.returncode == 0, f"{memory:g} MB: {done.stderr.strip()}")
        if done.returncode != 0:
            continue
        with h5py.File(f"{folder}/study.h5") as file:
            norm = file.attrs["norm_squared"]
        check(abs(norm / (t_end + folded_squares(t_end)) - 1) < 1e-13, f"{memory:g} MB: ||q||^2 = {norm:.16g}")
        for row in rows(folder):
            h, steps = float(row["h"]), int(row["steps"])
            if row["stepper"] == "vti2":
                off = abs(steps * (h - 2 * math.atan(h / 2)))  # of the angle at the end
                off = min(off % (2 * math.pi), -off % (2 * math.pi))
                check(abs(float(row["attitude_error"]) - off) < 1e-12, f"... h = {h:.4g}: attitude off by {row['attitude_error']}")


def same_bytes(base):
    """Of a pendulum, for any number of ranks, and resumed; near those of a reference in one piece."""
    arguments = ("--h", "2^-3:2^-6", "--t-end", "20")
    study(1, PENDULUM, *arguments, "-o", f"{base}/whole")
    found = []
    for ranks in (1, 2, 3):
        study(ranks, PENDULUM, *arguments, "--memory", repr(7.5 * PANEL), "-o", f"{base}/{ranks}")
        found.append(contents(f"{base}/{ranks}", ("timing.csv",)))
    check(len(found[0]) == 2 and found[0] == found[1] == found[2], "the same bytes on 1, 2 and 3 ranks")
    worst = max(abs(float(one[measure]) ** power - float(other[measure]) ** power)
                for one, other in zip(rows(f"{base}/whole"), rows(f"{base}/1"))
                for measure, power in (("e_error", 1), ("q_error", 2), ("h1_error", 1), ("attitude_error", 1)))
    check(worst < 1e-13, f"... which are those of one piece to {worst:.1e}")


def two_solutions(base):
    """Of the torus, whose reference two ranks make together where there are two: 100 states in more than one
    message."""
    for ranks in (1, 2, 3):
        study(ranks, TORUS, "--h", "1/1000", "--t-end", "0.1", "-o", f"{base}/torus{ranks}")
    found = [contents(f"{base}/torus{ranks}", ("timing.csv",)) for ranks in (1, 2, 3)]
    check(len(found[0]) == 2 and found[0] == found[1] == found[2], "a reference by two ranks: the same bytes on 1, 2 and 3 ranks")


FREE = """name: free
bodies: {chain: {count: 18, spacing: 1}, mass: 1, random: {seed: 7, omega: 0.5}}
h: 1
t_end: 4
"""


def peak_memory(*arguments):
    """kB that a study takes at most, alone. Where that is less than what this program takes, the system tells the
    latter."""
    with subprocess.Popen([STUDY, "--no-plot", "--steppers", "vti2", "--h", "4", *arguments], env=ENVIRONMENT,
                          stdout=subprocess.DEVNULL) as process:
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    check(process.returncode == 0, f"{' '.join(arguments)}: {usage.ru_maxrss} kB")
    return usage.ru_maxrss


def bounded(base):
    """Panels of 18 bodies, 60 kB for a unit of time: 60 MB in 1 MB and in one piece."""
    with open(f"{base}/free.yaml", "w", encoding="ascii") as file:
        file.write(FREE)
    least, most, whole = (peak_memory(f"{base}/free.yaml", "--t-end", t_end, "--memory", memory, "-o", f"{base}/{t_end}-{memory}")
                          for t_end, memory in (("4", "1"), ("1000", "1"), ("1000", "1000")))
    check(not MEMORY_TELLS or most - least < 5000, f"{most - least} kB more in windows of 1 MB")
    check(not MEMORY_TELLS or whole - least > 20000, f"... and {whole - least} kB more in one piece")


def first_pass(base):
    """7.2 GB of panels where a program may have 4: it begins, and goes on until it is told to end."""
    ours, theirs = pty.openpty()
    limits = 4_000_000_000, resource.getrlimit(resource.RLIMIT_AS)[1]
    with subprocess.Popen([STUDY, PENDULUM, "--no-plot", "--t-end", "4e6", "--h", "1", "-o", f"{base}/long"], env=ENVIRONMENT,
                          stdout=theirs, stderr=theirs, preexec_fn=lambda: MEMORY_TELLS and resource.setrlimit(resource.RLIMIT_AS, limits)) as process:
        os.close(theirs)
        said = ""
        while "left" not in said and select.select([ours], [], [], PATIENCE)[0]:
            try:
                said += os.read(ours, 4096).decode()
            except OSError:
                break
        process.send_signal(signal.SIGTERM)
        code = process.wait(timeout=PATIENCE)
    os.close(ours)
    check(code == 75 and "reference [" in said, f"a study to 4e6 begins: code {code}, {said.strip()[-200:]!r}")


def refusals(base):
    for value in ("none", "-1", "0"):
        check(one_line(study(1, SPIN, "--memory", value, "-o", f"{base}/no"), "--memory", f"'{value}'", "megabytes"), f"--memory {value}")


for topic in (closed_forms, same_bytes, two_solutions, bounded, first_pass, refusals):
    with tempfile.TemporaryDirectory() as root:
        topic(root)
conclude()
