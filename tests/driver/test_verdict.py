#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The verdict as the programs give it: one last line, attributes, columns, the code 3 apart from `complete`; the same
bytes after
--resume.                                                             test_verdict.py VTI_RUN VTI_STUDY MPIRUN SCENES"""
import csv
import os
import sys
import tempfile

import h5py
import numpy

from programs import run
from run_support import contents, read_csv
from tally import check, conclude

RUN, STUDY, MPIRUN, SCENES = (os.path.abspath(path) for path in sys.argv[1:5])
NUMBERS = ("energy_gain", "energy_swing", "energy_slope", "energy_slope_error", "energy_scale", "travel", "rotation",
           "angle_error", "stable_step", "overlap", "slowing", "bonds_turned")

BLOCK = """bodies:
  lattice: {counts: [6, 4, 4], spacing: 1, corner: [1.6, 0, 0]}
  mass: 1
  v: [-4, 0, 0]
binder: {moment: 10, axial: 20, shear: {stiffness: 200}}
wall: {stiffness: 2100, planes: [[1, 0.2, 0, 1]]}
h: 0.01
t_end: 4
"""
AWAY = "bodies: {x: [0, 0, 0], v: [1, 0, 0], mass: 1}\nh: 1.0e-4\nt_end: 0.01\n"
FAST = """bodies: {table: fast.csv, mass: 1, diameter: 1}
contact: {stiffness: 1}
h: 0.01
t_end: 1
"""
SLOW = """bodies: {table: fast.csv, mass: 1, diameter: 1}
contact: {stiffness: 1000}
h: 3e-5
t_end: 0.01
"""
SPIN = "bodies: {inertia: 1, alpha: [0, 0, 0], omega: [10, 0, 0]}\nh: 1\nt_end: 20\n"


SETTLE = "bodies: {x: [0, 0, 0], v: [0, 0, 0], mass: 1}\ndrag: {linear: 100}\ngravity: [0, 0, -1]\nh: 0.001\nt_end: 1\n"
WAYS = "bodies: {x: [0, 0, 0], v: [1, 0, 0], mass: 1}\ndrag: {linear: 20}\nh: 0.5\nt_end: 5\n"
TURNS = "bodies: {inertia: 1, alpha: [0, 0, 0], omega: [1, 0, 0]}\ndrag: {angular: 20}\nh: 0.5\nt_end: 5\n"
PRESS = """bodies: {x: [0, 0, 0], v: [0, 0, 0], alpha: [0, 0, 0], omega: [0, 0, 0], mass: 1, diameter: 1}
wall: {stiffness: 1e4, planes: [[0, 0, 1, -0.5], [0, 0, -1, -0.5]], velocities: [[0, 0, 0], [0, 0, -0.002]]}
h: 6e-3
t_end: 60
"""


# c/m is 20: a sphere that is too heavy to turn slides down a plane with the speed g_x m/c, and a bond creeps to its
# length.
SLIDE = """bodies: {x: [0, 0, 0.40582], v: [0, 0, 0], mass: 1, diameter: 1, inertia: 1e12}
wall: {stiffness: 60, planes: [[0, 0, 1, 0]]}
dashpot: {tangential: 20}
gravity: [1, 0, -9.81]
h: 0.03
t_end: 30
"""
CREEP = """bodies: {table: creep.csv, mass: 1}
binder: {axial: 1, table: bonds.csv}
bond_dashpot: {axial: 10}
h: 0.025
t_end: 10
"""


def attributes(path):
    with h5py.File(path) as file:
        return dict(file.attrs)


def verdict(base, scene, *options):
    """Runs it: the result, the last line, the attributes."""
    result = run(RUN, scene, "--no-dump", "-o", f"{base}/out.h5", "--force", *options)
    lines = result.stdout.splitlines()
    check(sum(line.startswith("verdict: ") for line in lines) == 1, f"one line of verdict: {lines[-1][:100]}")
    found = attributes(f"{base}/out.h5")
    check(found["verdict"].decode() == lines[-1].split()[1].rstrip(":"), "the attribute says the same")
    check(all(name in found for name in NUMBERS), "and the numbers are there")
    return result, lines, found


def pushed(base):
    """What drag slows within a step settles too fast; what walls press together holds the energy that they have put
    in."""
    scene = f"{base}/settle.yaml"
    for h, word in (("0.001", "good"), ("0.01", "doubtful"), ("0.1", "doubtful")):
        _, lines, found = verdict(base, scene, "--h", h)
        check(found["verdict"].decode() == word, f"drag and gravity at h = {h}: {lines[-1]}")
        check(("settles" in lines[-1]) == (word != "good"), "... and why")
    _, lines, found = verdict(base, f"{base}/press.yaml")
    check(found["verdict"].decode() == "good", f"pressed slowly between two planes: {lines[-1]}")
    check(found["energy_scale"] > 1.0, "the walls' energy counts")


def slowed(base):
    """What nothing pushes is slowed as it should be by any h, and its displacements and angles, sums of velocities in
    the middle of steps, are not: (z/2)/sinh(z/2) of themselves, or z/(exp(z) - 1) where the kick is whole, and chin4's
    velocities are those of a sixth and of five sixths of the step."""
    halves, whole = (lambda z: z / 2 / numpy.sinh(z / 2)), (lambda z: z / numpy.expm1(z))
    sixths = (lambda z: z / 2 * numpy.cosh(z / 3) / numpy.sinh(z / 2))
    for stepper, h, law, word in (("vti2", 0.5, halves, "doubtful"), ("vti2", 0.06, halves, "doubtful"), ("exact", 0.05, halves, "good"),
                                  ("vti3", 0.0055, whole, "doubtful"), ("vti3-leapfrog", 0.0045, whole, "good"),
                                  ("chin4", 0.5, sixths, "doubtful"), ("chin4", 0.05, sixths, "good")):
        for scene in ("ways", "turns"):
            _, lines, found = verdict(base, f"{base}/{scene}.yaml", "--stepper", stepper, "--h", str(h), "--t-end", str(100 * h))
            with h5py.File(f"{base}/out.h5") as file:
                data = file["VTKHDF"]
                w, x = data["PointData/attitude_wxyz"][-1][:2] if scene == "turns" else (1, 0)
                way = 2 * numpy.arctan2(x, w) if scene == "turns" else data["Points"][-1][0]
            wrong, z = abs(1 - law(20 * h)), 20 * h * (0.5 if stepper == "chin4" else 1)
            check(abs(way / (0.05 * law(20 * h)) - 1) < 1e-2, f"{scene} by {stepper} at h = {h}: {way:.4g} is {law(20 * h):.3f} of 0.05")
            check(abs(found["slowing"] / z - 1) < 1e-9, f"z is {found['slowing']:.3g}")
            check(found["verdict"].decode() == word and (f"are off by up to {wrong:.2g} of themselves" in lines[-1]) == (word != "good"),
                  f"... which is said: {lines[-1]}")
    _, lines, found = verdict(base, f"{base}/ways.yaml", "--h", "0.5", "--set", "bodies.v=[0,0,0]")
    check(found["verdict"] == b"good" and found["slowing"] == 0, f"nothing moves: {lines[-1]}")


def damped(base):
    """Dashpots slow as drag does: what they let through moves (z/2) coth(z/2) times too fast, z = h c/m. Of a bond,
    whose c is 10 and m_n 1/2, m_n s'' = -s - c s', and a step leaves 1 - h/c times that of s."""
    creep = 10 - 98 ** 0.5
    zeta = ("--set", "bond_dashpot.axial=0", "--set", f"bond_dashpot.zeta={50 ** 0.5}")
    for scene, h, word, *options in (("slide", 0.03, "good"), ("slide", 0.12, "doubtful"), ("creep", 0.025, "good"),
                                     ("creep", 0.5, "doubtful"), ("creep", 0.5, "doubtful", *zeta)):
        _, lines, found = verdict(base, f"{base}/{scene}.yaml", "--h", str(h), *options)
        check(found["verdict"].decode() == word and ("settles" in lines[-1]) == (word != "good"),
              f"{scene} at h = {h}: {lines[-1]}")
        check(abs(found["slowing"] / (20 * h) - 1) < 1e-9, f"z is {found['slowing']:.3g}")
        names, rows = read_csv(f"{base}/out.csv")
        column = dict(zip(names, numpy.array(rows).T))
        late, t = column["t"] > 2, column["t"]
        fast = (-20 * numpy.polyfit(t[late], column["gravity"][late], 1)[0] if scene == "slide" else
                -numpy.polyfit(t[late], numpy.log(column["binder_axial"][late]), 1)[0] / (2 * creep))
        z = 20 * h
        expected = z / 2 / numpy.tanh(z / 2)
        if scene == "creep":
            expected = -numpy.log(1 - h * creep * expected) / (h * creep)
        check(abs(fast / expected - 1) < 0.01, f"{fast:.4f} times as fast as it should at z = {z:.1f}")


def runs(base):
    for scene in ("pendulum", "chain", "spin"):
        result, _, found = verdict(base, f"{SCENES}/{scene}.yaml")
        check(result.returncode == 0 and found["verdict"] == b"good" and found["complete"] == 1, f"{scene}: good, 0")
    result, _, found = verdict(base, f"{base}/block.yaml")
    check(result.returncode == 3 and found["verdict"] == b"bad" and found["complete"] == 1 and found["energy_gain"] > 0.25,
          "an energy that explodes to finite numbers: bad, 3, complete")
    result, lines, found = verdict(base, f"{base}/fast.yaml")
    check(result.returncode == 3 and abs(found["travel"] - 5) < 1e-9 and any(
        "moves by 5 diameters" in line for line in lines if line.startswith("warning: ")),
        "spheres that pass through each other: a warning at the start, bad at the end")
    for how, word in (("--h", "0.05"), b"doubtful"), (("--tolerance", "1e-6"), b"good"):
        _, lines, found = verdict(base, f"{SCENES}/block.yaml", "--stepper", "srkn11", "--t-end", "4", *how)
        check(found["verdict"] == word and found["travel"] > 0.1 and ("contacts are met late" in lines[-1]) == (word != b"good"),
              f"{found['travel']:.2g} diameters a step by {how}: {word.decode()}")
    for effect, word in ((None, b"good"), ("dashpot.normal=1", b"doubtful")):
        _, lines, found = verdict(base, f"{base}/slow.yaml", *(("--set", effect) if effect else ()))
        check(found["verdict"] == word and abs(found["travel"] - 0.015) < 1e-9,
              f"0.015 diameters a step with {effect or 'no dashpots, which look 0.02 ahead'}: {word.decode()}")
    for stepper in ("exact", "srkn11"):
        result, lines, found = verdict(base, f"{base}/spin.yaml", "--stepper", stepper)
        check(result.returncode == 0 and found["verdict"] == b"doubtful" and found["angle_error"] > 1e-3 and any(
            "turns by another angle" in line for line in lines if line.startswith("warning: ")),
            f"{stepper} at h|Omega| = 10: a warning at the start, doubtful at the end")
    _, lines, found = verdict(base, f"{base}/spin.yaml", "--h", "0.1", "--stepper", "exact")
    check(found["verdict"] == b"good" and not any("warning" in line for line in lines), "and none at 1")
    for x, said in ("1e12", True), ("1e8", False):
        _, lines, found = verdict(base, f"{base}/away.yaml", "--set", f"bodies.x=[{x}, 0, 0]")
        words = ("rounding takes up to 1.1 of their displacement in a step; move the origin nearer",
                 "rounding takes up to 1.1 of their displacement in a step: move it nearer")
        warnings = [line for line in lines if line.startswith("warning: ")]
        check((found["verdict"] == b"doubtful") == said == (words[1] in lines[-1]) and [words[0] in line for line in warnings] == [True] * said,
              f"2^-53 x/(h v) from x = {x}: {lines[-1]}")
    with open(f"{base}/rod.yaml", "w", encoding="ascii") as file: # whose forces across it are rounding
        file.write("bodies: {chain: {count: 4, spacing: 1, start: [5, 5, 5], direction: [1, 2, 3]}, mass: 1, omega: [0.1, 0.2, 0.3]}\n"
                   "binder: {moment: 10, axial: 200, shear: {stiffness: 200}}\nh: 1e-2\nt_end: 20\n")
    for how, options in ("turns about its own axis", ()), ("rests", ("--set", "bodies.omega=[0,0,0]")):
        _, lines, found = verdict(base, f"{base}/rod.yaml", *options)
        check(found["verdict"] == b"good" and found["energy_gain"] == 0, f"a rod that {how} goes nowhere: {lines[-1]}")
    with open(f"{base}/rest.yaml", "w", encoding="ascii") as file:
        file.write("bodies: {chain: {count: 3, spacing: 1}, mass: 1}\nbinder: {axial: 1}\nh: 1/16\nt_end: 1\n")
    result, lines, found = verdict(base, f"{base}/rest.yaml", "--record", "1")
    check(found["verdict"] == b"good" and found["energy_scale"] == 0 and "drift 0 +- 0 per unit of time (shares of the scale 0)" in lines[-1]
          and "nan" not in result.stdout, f"at rest: no drift {lines[-1]}")


def resumed(base):
    """Bonds are being followed past half a turn while the run is prolonged; the verdict is that of one run."""
    whole = run(RUN, f"{base}/block.yaml", "--record", "7", "--frames", "50", "--no-dump", "-o", f"{base}/whole.h5")
    run(RUN, f"{base}/block.yaml", "--record", "7", "--frames", "50", "--no-dump", "-o", f"{base}/parts.h5", "--t-end", "1.03")
    parts = run(RUN, f"{base}/block.yaml", "--no-dump", "-o", f"{base}/parts.h5", "--resume")
    same = {ending: a == b for (ending, a), b in zip(contents(f"{base}/whole").items(), contents(f"{base}/parts").values())
            if ending in (".h5", ".csv")}
    check(whole.returncode == parts.returncode == 3 and all(same.values()), f"prolonged: the same bytes, bad {same}")
    check(whole.stdout.splitlines()[-1] == parts.stdout.splitlines()[-1], "and the same line")
    check(attributes(f"{base}/whole.h5")["bonds_turned"] > 0, "of bonds that turned, too")
    for name, options, word, code in (("whole", [f"{base}/block.yaml", "--no-dump"], "bad", 3),
                                      ("turns", [f"{base}/spin.yaml", "--stepper", "exact"], "doubtful", 0),
                                      ("spin", [f"{SCENES}/spin.yaml"], "good", 0)):
        first = run(RUN, *options, "-o", f"{base}/{name}.h5") if name != "whole" else whole
        again = run(RUN, *options, "-o", f"{base}/{name}.h5", "--resume")
        check(again.returncode == first.returncode == code and "nothing to do" in again.stdout and
              again.stdout.splitlines()[-1] == f"verdict: {word}", f"complete, and again with --resume: {word}, {code} {again.stdout}")


def study(base):
    result = run(MPIRUN, "-n", "1", STUDY, f"{SCENES}/chain.yaml", "--steppers", "vti2", "--h", "1/8,1/64,1/128", "--t-end",
                 "1", "--no-plot", "-o", f"{base}/study")
    check(result.returncode == 3 and "verdict: of 3 runs 2 are good, 0 doubtful, 1 bad" in result.stdout,
          f"a study with a run that explodes ends with 3 {result.stderr}")
    said = [line.split(": ")[:3] for line in result.stdout.splitlines() if ": verdict: " in line]
    check([[line[0].replace(" ", ""), line[2]] for line in said] == [["vti2ath=1/8", "bad"]], f"... and says why of that alone {said}")
    with open(f"{base}/study/study.csv", encoding="ascii", newline="") as file:
        rows = list(csv.DictReader(file))
    check([row["verdict"] for row in rows] == ["bad", "good", "good"], "study.csv says which")
    with h5py.File(f"{base}/study/study.h5") as file:
        check(list(file["runs/verdict"]) == [2, 0, 0] and all(
            numpy.array_equal(file[f"runs/{name}"], [float(row[name]) for row in rows], equal_nan=True) for name in NUMBERS),
            "study.h5 holds the same numbers")


def varied(base):
    """Of steps of variable length the longest counts, however often frames are written between rows."""
    said = [run(RUN, os.path.join(SCENES, "pendulum.yaml"), "--stepper", "srkn6", "--control", "naive", "--h", "1/64", "--t-end", "2",
                "--record", "128", "--frames", every, "-o", f"{base}/varied-{every}.h5").stdout.splitlines()[-1] for every in ("128", "1")]
    check(said[0] == said[1] and "steps are up to" in said[0], f"steps that vary: {said}")


with tempfile.TemporaryDirectory() as root:
    for name, text in (("block.yaml", BLOCK), ("fast.yaml", FAST), ("slow.yaml", SLOW), ("spin.yaml", SPIN),
                       ("settle.yaml", SETTLE), ("ways.yaml", WAYS), ("turns.yaml", TURNS), ("press.yaml", PRESS), ("slide.yaml", SLIDE), ("creep.yaml", CREEP),
                       ("creep.csv", "x,y,z,vx,vy,vz\n0,0,0,0,0,0\n1.1,0,0,0,0,0\n"),
                       ("away.yaml", AWAY), ("bonds.csv", "i,j,length,nx,ny,nz,turn_x,turn_y,turn_z,turn_w\n1,0,1,1,0,0,0,0,0,1\n"),
                       ("fast.csv", "x,y,z,vx,vy,vz\n0,0,0,500,0,0\n20.1,0,0,-500,0,0\n")):
        with open(f"{root}/{name}", "w", encoding="ascii") as out:
            out.write(text)
    runs(root)
    pushed(root)
    slowed(root)
    damped(root)
    resumed(root)
    study(root)
    varied(root)
conclude()
