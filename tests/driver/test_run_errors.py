#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""vti-run --errors: the columns error_velocity and error_omega against what steps err by and against the formula of
EQUATIONS 8.1 on the recorded motion, where estimates jump, and the same bytes for any number of threads and after
--resume.
                            test_run_errors.py VTI_RUN SCENES"""
import os
import re
import sys
import tempfile

import numpy as np

from programs import one_line, run
from run_support import contents, read_csv, read_vtkhdf
from tally import check, conclude

RUN, SCENES = map(os.path.abspath, sys.argv[1:3])
FALL = """name: fall
bodies: {x: [0, 0, 1], v: [0.25, 0, -1], mass: 1, diameter: 1}
wall: {stiffness: 100, planes: [[0, 0, 1, 0]]}
h: 1/128
t_end: 2
"""


def go(scene, name, *options):
    path = scene if os.path.exists(scene) else os.path.join(SCENES, scene + ".yaml")
    result = run(RUN, path, "-o", f"{name}.h5", *options)
    check(result.returncode == 0, f"{scene} {' '.join(options)} {result.stderr.strip()}")
    return result.stdout


def column(name, which):
    names, rows = read_csv(name + ".csv")
    return rows[:, names.index(which)]


# ---- the pendulum of scenes/pendulum.yaml, on its own: R' = Omega x R, Omega' = R e3 x e3
# ------------------------------------


def arm(q):
    """R e3 of a quaternion x, y, z, w."""
    x, y, z, w = q
    return np.array([2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)])


def acceleration(rho):
    return np.array([rho[1], -rho[0], 0.0])


def one_step(rho, omega, h, parts=16):
    """Omega after h, by the classical Runge-Kutta method; the arm alone is what turns the body."""
    def rate(y):
        return np.concatenate([np.cross(y[3:], y[:3]), acceleration(y[:3])])
    y, k = np.concatenate([rho, omega]), h / parts
    for _ in range(parts):
        a = rate(y)
        b = rate(y + k / 2 * a)
        c = rate(y + k / 2 * b)
        y = y + k / 6 * (a + 2 * b + 2 * c + rate(y + k * c))
    return y[3:]


def true_errors(frames, h):
    found = [np.linalg.norm(one_step(arm(a["attitude_xyzw"][0]), a["omega"][0], h) - b["omega"][0]) for a, b in zip(frames, frames[1:])]
    return np.array(found)


def local_errors():
    """The estimate is on the safe side of the error of the step from what was recorded, and of the order that it
    claims."""
    for stepper, order, most in (("srkn6", 4, 1e5), ("srkn11", 6, 1e5), ("an4", 5, 300)):
        largest = []
        for n in (8, 16):
            go("pendulum", "each", "--stepper", stepper, "--h", f"1/{n}", "--errors", "--record", "1", "--frames", "1", "--t-end", "6")
            told, true = column("each", "error_omega")[1:], true_errors(read_vtkhdf("each.h5"), 1 / n)
            largest.append(told[8:].max())
            share = told[8:].max() / true[8:].max()
            check(1 < share < most, f"{stepper}, h = 1/{n}: told {told[8:].max():.3g}, {share:.3g} of the true {true[8:].max():.3g}")
        ratio = np.log2(largest[0] / largest[1])
        check(abs(ratio - order) < 0.5, f"{stepper}: of order {ratio:.2f}, {order} is claimed")


def formula():
    """h (g_K + u) D of AN(4), with D the fourth difference of the accelerations on its way (EQUATIONS 8.1)."""
    said = go("pendulum", "an", "--stepper", "an4", "--h", "1/32", "--errors", "--record", "1", "--frames", "1", "--t-end", "6")
    turns = np.array([acceleration(arm(frame["attitude_xyzw"][0])) for frame in read_vtkhdf("an.h5")])
    expected = (251 / 720 - 3 / 80) / 32 * np.linalg.norm(np.diff(turns, 4, axis=0), axis=1)
    told = column("an", "error_omega")
    check(told[0] == 0, "no step before the first row")
    check(np.allclose(told[8:], expected[4:], rtol=0.05, atol=0.02 * expected.max()), "an4: h (g_4 + u) D of the accelerations recorded")
    line = re.search(r"largest estimated error of a step: (\S+) in angular velocity \(t = (\S+)\)", said)
    k = np.argmax(told)
    check(line is not None and np.isclose(float(line[1]), told[k], rtol=0.01) and float(line[2]) == k / 32, f"... the largest: {line[0]}")
    check("tenfold" not in said, "... which never jumps")
    go("pendulum", "rare", "--stepper", "an4", "--h", "1/32", "--errors", "--record", "24", "--frames", "1", "--t-end", "6")
    check(np.array_equal(column("rare", "error_omega")[1:], told[1:].reshape(-1, 24).max(axis=1)), "... since the row before")


def jumps():
    """A sphere flies freely until it meets a plane at t = 1/2."""
    with open("fall.yaml", "w", encoding="ascii") as file:
        file.write(FALL)
    for stepper in ("srkn6", "srkn11", "an4"):
        said = go("fall.yaml", "fall", "--stepper", stepper, "--errors", "--record", "1")
        line = re.search(r"warning: the estimate grew tenfold in (\d+) steps?, first in the one to t = (\S+):", said)
        check(line is not None and 0.5 < float(line[2]) <= 0.5 + 2 / 128, f"{stepper}: the touch is told: {line and line[0]}")
        t, error = column("fall", "t"), column("fall", "error_velocity")
        check((error[t < 0.49] == 0).all() and error.max() > 0, "... and nothing before it")


def same_bytes():
    """Any threads; resumed between two rows; and without --errors all but its columns."""
    for name, options in (("torus", ("--stepper", "an4", "--h", "1/1024")), ("chain", ("--stepper", "srkn6", "--h", "1/64")),
                          ("chain", ("--stepper", "srkn11", "--tolerance", "1e-8", "--h", "1/64"))):
        options = (*options, "--record", "16", "--frames", "64")
        end, middle = ("1/4", "101/1024") if name == "torus" else ("2", "37/64")
        said = go(name, "whole", *options, "--errors", "--t-end", end)
        threads = go(name, "threads", *options, "--errors", "--t-end", end, "--threads", "3")
        go(name, "part", *options, "--errors", "--t-end", middle)
        part = go(name, "part", *options, "--errors", "--t-end", end, "--resume")
        whole = contents("whole")
        check(whole[".csv"] == contents("threads")[".csv"] and whole[".h5"] == contents("threads")[".h5"], f"{name}: three threads")
        # steps by a tolerance also keep in the checkpoint how many were cut to end where somebody looked
        files = (".csv",) if "--tolerance" in options else (".csv", ".h5")
        check(all(whole[file] == contents("part")[file] for file in files), f"{name}: resumed")
        words = [[line for line in text.splitlines() if re.match("largest estimated error|warning: the estimate", line)]
                 for text in (said, threads, part)]
        check(words[0] == words[1] == words[2] and words[0], f"... and the same is said of it: {words[0]}")
        go(name, "off", *options, "--t-end", end)
        (names, rows), (without, others) = read_csv("whole.csv"), read_csv("off.csv")
        check(names == [*without, "error_velocity", "error_omega"] and np.array_equal(rows[:, :-2], others), "... off is off")
        check((rows[1:, -2:] > 0).all(), "... every row has errors")
    result = run(RUN, os.path.join(SCENES, "chain.yaml"), "-o", "part.h5", "--stepper", "srkn11", "--tolerance", "1e-8", "--h", "1/64",
                 "--resume", "--t-end", "3")
    check(one_line(result, "part.h5", "error_velocity"), f"goes on with --errors only: {result.stderr.strip()}")


def refused():
    for stepper in ("vti2", "exact", "rk4", "rk8pd-adaptive"):
        result = run(RUN, os.path.join(SCENES, "chain.yaml"), "-o", "none.h5", "--stepper", stepper, "--errors")
        check(one_line(result, "--errors", stepper, "srkn11", "leave --errors out"), f"refused: {result.stderr.strip()}")
    check(not os.path.exists("none.h5"), "... before anything is done")


with tempfile.TemporaryDirectory() as root:
    os.chdir(root)
    for topic in (local_errors, formula, jumps, same_bytes, refused):
        topic()
    os.chdir(SCENES)
conclude()
