#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What advice is worth: on 21 pairs of a scene and an end, of which twelve have contacts and four dissipate (two do
both), and errors from 1e-2 to 1e-8, how often the error of the advised run lies in the interval that vti-advise prints,
and what its pilots took of that run.

usage: advice.py BUILD SCENES [NAME...]      all cases, or those whose names begin so; held-out: eight scenes by which no
                                             factor of the intervals was set

The error is that of vti-study against GSL's solution, where something dissipates against chin4 by a fourth of the step;
where trajectories part it is the largest change of the energy in vti-run, booked energies counted in. Prints a Markdown
table."""
import csv
import json
import math
import os
import statistics
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "tests"))
from programs import run  # noqa: E402

BUILD, SCENES = map(os.path.abspath, sys.argv[1:3])
TARGETS = [1e-2, 1e-4, 1e-6, 1e-8]
LEAST = 4e6                       # force evaluations of a body that pilots may always take

FALL = """name: fall
bodies: {mass: 2, inertia: 0.5, diameter: 1, x: [0, 0, 1], v: [3, 0, 0], alpha: [0, 0, 0], omega: [0, 1, 2]}
drag: {linear: 0.5, quadratic: 0.25, angular: 0.125, medium: [0, 0.5, 0]}
gravity: [0, 0, -1]
h: 1/64
t_end: 4
"""
SWING = """name: swing
bodies: {chain: {count: 6, spacing: 1}, mass: 1, inertia: 0.1, diameter: 1, random: {seed: 3, v: 0.2, omega: 0.2}}
binder: {moment: 5, axial: 100, shear: {stiffness: 50, form: objective}}
bond_dashpot: {zeta: 0.125}
h: 1/256
t_end: 4
"""
SNAP = """name: snap
bodies: {chain: {count: 8, spacing: 0.98}, mass: 1, inertia: 0.1, diameter: 1, random: {seed: 5, v: 1.5, omega: 1}}
binder: {moment: 5, axial: 100, shear: {stiffness: 50},
         break: {stretch: 0.12, normal: 25, shear: 12, bending: 8, torsion: 8, energy: 4}}
bond_dashpot: {zeta: 0.02}
contact: {stiffness: 500}
h: 1/512
t_end: 1
"""
MEET = """name: meet
bodies: {lattice: {counts: [2, 2, 2], spacing: 1.0625, corner: [0, 0, 0]},
         diameter: 1, mass: 1, random: {seed: 4, v: 0.5}}
contact: {stiffness: 1000}
gravity: [0, 0, -1]
wall: {stiffness: 1000, planes: [[0, 0, 1, -0.75]]}
h: 1/512
t_end: 2
"""

# name, scene file or text, end, other settings, number of bodies
CASES = [
    ("pendulum", "pendulum.yaml", 10, [], 1), ("pendulum", "pendulum.yaml", 1000, [], 1),
    ("spin", "spin.yaml", 100, [], 1), ("pair", "pair.yaml", 100, [], 2), ("chain", "chain.yaml", 10, [], 10),
    ("chain-of-40", "chain.yaml", 5, ["bodies.chain.count=40"], 40),
    ("long-pendulum", "pendulum.yaml", 20000, [], 1), ("block", "block.yaml", 4, [], 96),
    ("block", "block.yaml", 8, [], 96), ("block-of-12", "block.yaml", 4, ["bodies.lattice.counts=[3,2,2]"], 12),
    ("pile", "pile.yaml", 0.25, [], 128), ("pile", "pile.yaml", 0.5, [], 128), ("pile", "pile.yaml", 2, [], 128),
    ("torus", "torus.yaml", 1, [], 80), ("torus", "torus.yaml", 2, [], 80), ("torus", "torus.yaml", 35, [], 80),
    ("meet", MEET, 2, [], 8),
    ("fall", FALL, 4, [], 1), ("swing", SWING, 4, [], 6), ("snap", SNAP, 1, [], 8),
    ("incline", "incline.yaml", 0.1, [], 1),
]
HELD_OUT = [
    ("held-out-block", "block.yaml", 6, ["bodies.v=[-0.7,0.3,0]"], 96),
    ("held-out-pile", "pile.yaml", 1, ["bodies.random.seed=9"], 128),
    ("held-out-pile-of-8", "pile.yaml", 1, ["bodies.lattice.counts=[2,2,2]", "bodies.random.seed=3"], 8),
    ("held-out-torus", "torus.yaml", 3, ["bodies.v=[-1.5,0,0]"], 80),
    ("held-out-slow-torus", "torus.yaml", 1.5, ["bodies.v=[-0.5,0.25,0]"], 80),
    ("held-out-meet", MEET, 3, ["bodies.random.seed=11"], 8),
    ("held-out-chain", "chain.yaml", 20, ["bodies.random.seed=7"], 10),
    ("held-out-pair", "pair.yaml", 40, ["binder.axial=50"], 2),
]
KINKED = {"block", "block-of-12", "pile", "torus", "meet", "snap", "incline", "held-out-block", "held-out-pile",
          "held-out-pile-of-8", "held-out-torus", "held-out-slow-torus", "held-out-meet"}
DISSIPATE = {"fall", "swing", "snap", "incline"}


def program(name):
    return os.path.join(BUILD, "drivers", name)


def settings(sets):
    return [word for one in sets for word in ("--set", one)]


def error_of(folder, case, told):
    """The advised run's, by the measure of the advice; None where it takes too long to tell."""
    name, _, t_end, sets, _ = case
    path = os.path.join(folder, "scene.yaml")
    try:
        if told["measure"] == "energy":
            run(program("vti-run"), path, *settings(sets), "--stepper", told["stepper"], "--h", repr(told["h"]),
                "--t-end", str(t_end), "--record", "1", "-o", f"{folder}/run.h5")
            with open(f"{folder}/run.csv", encoding="ascii", newline="") as file:
                total = [float(row["total"]) for row in csv.DictReader(file)]
            return max(abs(e - total[0]) for e in total) / (abs(total[0]) or 1.0)
        kind = [] if name in DISSIPATE else ["--cost"]
        done = run("mpirun", "-n", "1", program("vti-study"), *kind, path, *settings(sets),
                   "--steppers", told["stepper"], "--h", repr(told["h"]),
                   "--t-end", str(t_end), "--no-plot", "--force", "-o", f"{folder}/study", timeout=300)
        with open(f"{folder}/study/{'study' if not kind else 'cost'}.csv", encoding="ascii", newline="") as file:
            return float(next(csv.DictReader(file))[told["measure"] + "_error"])
    except Exception as problem:  # noqa: BLE001  a row without an error is a row of the table
        print(f"{name}: {type(problem).__name__}", file=sys.stderr)
        return None


def one(folder, case, target):
    name, text, t_end, sets, bodies = case
    path = os.path.join(folder, "scene.yaml")
    if not text.endswith(".yaml"):
        with open(path, "w", encoding="ascii") as file:
            file.write(text)
    elif not os.path.exists(path):
        os.symlink(os.path.join(SCENES, text), path)
    done = run(program("vti-advise"), "--json", path, *settings(sets), "--error", repr(target), "--t-end", str(t_end))
    if done.returncode != 0:
        print(f"{name} {t_end} {target:g}: {done.stderr.strip()}", file=sys.stderr)
        return None
    told = json.loads(done.stdout)
    true = error_of(folder, case, told)
    low, high = (other if limit is None else limit for limit, other in zip(told["interval"], (0.0, math.inf)))
    took, runs = told["pilots"]["force_evals"] * bodies, told["predicted_force_evals"] * bodies
    held = None if true is None else low <= true <= high or (true < 1e-12 and low < 1e-12)
    print(f"| {name} {t_end:g} | {target:.0e} | {told['stepper']} | {told['source']} | {told['measure']} | "
          f"{told['predicted_error'] or math.nan:.1e} | {low:.1e} | {high:.1e} | "
          f"{math.nan if true is None else true:.1e} | {'-' if held is None else 'yes' if held else 'NO'} | "
          f"{took / runs:.2g} | {took:.1e} |", flush=True)
    return held, took, runs, told["source"], name in KINKED, high / low if low > 0 else math.inf


def main():
    wanted = sys.argv[3:]
    rows = []
    print("| scene, end | asked for | advice | told from | of | error | from | to | true | within | pilots/run "
          "| work |\n|" + "---|" * 12)
    for case in CASES + HELD_OUT:
        if not any(case[0].startswith(name) for name in wanted) and (wanted or case in HELD_OUT):
            continue
        for target in TARGETS:
            with tempfile.TemporaryDirectory() as folder:
                rows.append(one(folder, case, target))
    answers = [row for row in rows if row is not None]
    known = [row for row in answers if row[0] is not None]
    print(f"\nanswers: {len(answers)} of {len(rows)}; within the interval: {sum(row[0] for row in known)} of "
          f"{len(known)}")
    for kinked in (False, True):
        widths = [row[5] for row in answers if row[4] == kinked]
        if widths:
            print(f"{'with' if kinked else 'without'} kinks: from end to end of the interval a factor of "
                  f"{statistics.median(widths):.2g} in the median")
    for kinked, share in ((False, 0.3), (True, 1.0)):
        part = [row for row in answers if row[4] == kinked]
        dear = [row for row in part if row[1] > 1.05 * max(LEAST, share * row[2])]
        print(f"{'with' if kinked else 'without'} kinks: {len(part)}; pilots 5 % and more above {share} of the run and "
              f"above {LEAST:g}: {len(dear)}")


main()
