#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""vti-study --cost as a user runs it: the files, the same errors for any number of ranks, orders, counts of force
evaluations,
prices found again from the runs, failed runs and bad input. No time is asserted.      test_cost.py VTI_STUDY MPIRUN SCENES"""
import csv
import math
import os
import sys
import tempfile

from programs import one_line, run
from tally import check, conclude

STUDY, MPIRUN, SCENES = sys.argv[1:4]
PENDULUM, CHAIN, PILE = (os.path.join(SCENES, name + ".yaml") for name in ("pendulum", "chain", "pile"))
TARGETS = [10.0**-k for k in range(2, 11)]


def cost(ranks, *arguments, folder):
    return run(MPIRUN, "-n", str(ranks), STUDY, "--cost", "--repeats", "1", "-o", folder, *arguments)


def rows(folder, name):
    with open(os.path.join(folder, name), newline="") as file:
        return list(csv.DictReader(file))


def ladders(folder):
    """(scene, stepper) -> its rows of cost.csv, in the order of the file."""
    found = {}
    for row in rows(folder, "cost.csv"):
        found.setdefault((row["scene"], row["stepper"]), []).append(row)
    return found


def columns(folder):
    runs = "scene,stepper,kind,h,steps,force_evals,{}attitude_error,position_error,velocity_error,energy_error,momentum_error"
    expected = {"cost.csv": runs.format("seconds,seconds_spread,"), "errors.csv": runs.format(""),
                "prices.csv": "scene,t_end,scene_t_end,stepper,kind,measure,error,force_evals,seconds"}
    for name, head in expected.items():
        with open(os.path.join(folder, name)) as file:
            check(file.readline() == head + "\n", f"the columns of {name}")
    times = ("seconds", "seconds_spread")
    same = [{k: v for k, v in row.items() if k not in times} for row in rows(folder, "cost.csv")] == rows(folder, "errors.csv")
    check(same, "errors.csv is cost.csv without the times")
    check(all(float(row["seconds"]) > 0 <= float(row["seconds_spread"]) for row in rows(folder, "cost.csv")),
          "all runs have times")
    with open(os.path.join(folder, "machine.txt")) as file:
        keys = [line.split(":")[0] for line in file]
    check(keys == ["cpu", "cores", "system", "compiler", "flags", "ranks", "times"], "the lines of machine.txt")


def same_bytes(base):
    arguments = [PENDULUM + "@2,4", CHAIN + "@10", "--evals", "3000", "--steppers", "exact,srkn6,srkn11,rk4,lgvi,rk8pd-adaptive"]
    for ranks in (1, 2, 3):
        result = cost(ranks, *arguments, folder=f"{base}/ranks{ranks}")
        check(result.returncode == 0, f"{ranks} ranks run {result.stderr}")
    contents = {open(f"{base}/ranks{ranks}/errors.csv", "rb").read() for ranks in (1, 2, 3)}
    check(len(contents) == 1, "errors.csv is the same on 1, 2 and 3 ranks")
    with open(f"{base}/two.csv", "w", encoding="ascii") as file:
        file.write("x,y,z,vx,vy,vz\n0,0,0,0.1,0.01,0.02\n1.03,0.1,0.05,-0.1,0,0\n")
    with open(f"{base}/two.yaml", "w", encoding="ascii") as file:
        file.write("bodies: {table: two.csv, diameter: 1, mass: 1}\ncontact: {stiffness: 1000}\nh: 1/256\nt_end: 2\n")
    for ranks in (1, 3):
        cost(ranks, f"{base}/two.yaml", "--evals", "1000", "--steppers", "vti2,srkn6,an9", folder=f"{base}/two{ranks}")
    contents = {open(f"{base}/two{ranks}/errors.csv", "rb").read() for ranks in (1, 3)}
    check(len(contents) == 1, "... and where pairs are searched for")
    scenes = sorted({scene for scene, _ in ladders(f"{base}/ranks2")})
    check(scenes == ["chain", "pendulum-2", "pendulum-4"], f"a scene with several ends is named with each: {scenes}")


def evaluations(base):
    folder = f"{base}/evals"
    evals = {"vti2": (1, 1), "exact": (1, 1), "mercury": (1, 1), "srkn6": (6, 1), "srkn11": (11, 1), "kl8": (17, 1), "rk4": (4, 0),
             "rk8pd": (13, 0)}
    result = cost(2, PENDULUM, "--t-end", "8", "--h", "8/64,8/128", "--steppers", ",".join(evals), folder=folder)
    check(result.returncode == 0, f"given steps run {result.stderr}")
    found = ladders(folder)
    for stepper, (each, start) in evals.items():
        right = all(int(row["force_evals"]) == each * int(row["steps"]) + start for row in found["pendulum", stepper])
        check(right, f"{stepper}: {each} force evaluations a step and {start} before")
    conserved = max(float(row["momentum_error"]) for row in found["pendulum", "exact"])
    check(conserved < 1e-12, f"exact conserves the momentum of the pendulum: {conserved:.1e}")


def price(ladder, error, target):
    """The rule of cost.h, once more. One of srkn6's first runs on the chain is good by chance and must not count."""
    good = [float(row[error]) <= target for row in ladder]
    reaching = [k for k in range(len(ladder)) if all(good[k:k + 3])]
    if not reaching:
        return None
    best = min(reaching, key=lambda k: int(ladder[k]["force_evals"]))
    fine, before = ladder[best], ladder[max(best - 1, 0)]
    share = 1.0
    if float(before[error]) > target:
        share = math.log(float(before[error]) / target) / math.log(float(before[error]) / float(fine[error]))
    return [float(before[c]) * (float(fine[c]) / float(before[c]))**share for c in ("force_evals", "seconds")]


def prices(folder, scene, measures):
    """Prices of these measures, and of no others, follow from the runs."""
    told = [row for row in rows(folder, "prices.csv") if row["scene"] == scene]
    check({row["measure"] for row in told} == set(measures), f"{scene} is priced by {', '.join(measures)}")
    for measure in measures:
        prices_of(folder, scene, measure + "_error", [row for row in told if row["measure"] == measure])


def prices_of(folder, scene, error, listed):
    found = ladders(folder)
    reached = 0
    for row in listed:
        want = price(found.get((scene, row["stepper"]), []), error, float(row["error"]))
        got = [float(row[c]) if row[c] else None for c in ("force_evals", "seconds")]
        right = got == [None, None] if want is None else all(abs(g / w - 1) < 1e-9 for g, w in zip(got, want))
        reached += want is not None
        if not right:
            check(False, f"{scene} {row['stepper']} {row['error']}: {got}, not {want}")
    steppers = {row["stepper"] for row in listed}
    check(len(listed) == len(TARGETS) * len(steppers) and reached > 2, f"{scene}: {reached} prices by {error} follow from cost.csv")


def translating(base):
    """Nothing turns in the pile: it is priced by velocities."""
    result = cost(2, PILE + "@1/8", "--evals", "2000", "--steppers", "vti2,srkn6,rk4", folder=f"{base}/pile")
    check(result.returncode == 0 and "velocities" in result.stdout, f"the pile is priced by velocities {result.stderr}")
    prices(f"{base}/pile", "pile", ("position", "velocity", "energy"))


def general(base):
    """Without --steppers bodies of three moments are measured by all that can take them, and by no others."""
    folder = f"{base}/general"
    scene = PENDULUM.replace("pendulum", "dzhanibekov")
    result = cost(1, scene, "--h", "1/64", "--t-end", "1/8", folder=folder)
    found = {stepper for _, stepper in ladders(folder)}
    check(result.returncode == 0 and {"vti2", "kl8", "rk4", "no-squish", "spiral-aspherical"} <= found and not {"gear", "an4", "mercury"} & found
          and "failed" not in result.stdout, f"{len(found)} methods for a body of three moments {result.stderr}")
    result = cost(1, scene, PENDULUM, "--h", "1/64", "--t-end", "1/8", folder=f"{base}/mixed")
    found = {(scene, stepper) for scene, stepper in ladders(f"{base}/mixed")}
    check(result.returncode == 0 and {("pendulum", "rk4"), ("pendulum", "vti2"), ("dzhanibekov", "buss")} <= found
          and not {("dzhanibekov", "gear"), ("pendulum", "buss")} & found, f"with spheres beside it, each by its own {result.stderr}")


LATE = """name: late
bodies: {table: late.csv, diameter: 1, mass: 1, alpha: [0, 0, 0], omega: [0, 0, 0]}
contact: {stiffness: 1000}
h: 1/64
t_end: 60
"""


def late_touch(base):
    """Two equal spheres, nothing before they meet at t = 32 and nothing after it: their velocities are exchanged. No
    method that chooses its steps passes by that, the solution's own least of all; attitudes, which nothing changes,
    tell nothing of it."""
    with open(f"{base}/late.csv", "w", encoding="ascii") as file:
        file.write("x,y,z,vx,vy,vz\n0,0,0,1,0,0\n33,0,0,0,0,0\n")
    with open(f"{base}/late.yaml", "w", encoding="ascii") as file:
        file.write(LATE)
    result = cost(1, f"{base}/late.yaml", "--steppers", "vti2,an7,srkn11,rk8pd-adaptive,dop853-adaptive", "--h", "1/1024,1/256",
                  folder=f"{base}/late")
    for (_, stepper), ladder in ladders(f"{base}/late").items():
        errors = [float(row["velocity_error"]) for row in ladder]
        check(max(errors) < 1e-3, f"{stepper}: velocities are exchanged {errors}")
        check([float(row["h"]) for row in ladder] == [1 / 256, 1 / 1024], f"{stepper}: rows by falling h")
    listed = {row["measure"] for row in rows(f"{base}/late", "prices.csv")}
    check(result.returncode == 0 and listed == {"position", "velocity", "energy"}, f"prices of {listed} {result.stderr}")
    result = run(MPIRUN, "-n", "1", STUDY, f"{base}/late.yaml", "--tolerance", "1e-8", "--steppers", "srkn11", "--h", "1", "--no-plot",
                 "-o", f"{base}/late-tolerance")
    error = float(rows(f"{base}/late-tolerance", "study.csv")[0]["h1_error"])
    check(result.returncode == 0 and error < 1e-4, f"nor does srkn11 by its tolerance: {error:.2g} {result.stderr}")


def every_step(base):
    """The error of the energy has its maximum within the touch of a ball and a wall, and most of it goes with the
    touch: as velocity Verlet by hand finds it, with the wall's energy 2/5 K (1 - x/(1/2))^(5/2)."""
    steps, h, x, v = 4096, 20 / 4096, 9.5, -1.0
    with open(f"{base}/ball.yaml", "w", encoding="ascii") as file:
        file.write("name: ball\nbodies: {x: [0, 0, 9.5], diameter: 1, mass: 1, v: [0, 0, -1]}\n"
                   "wall: {stiffness: 1.0e+4, planes: [[0, 0, 1, 0]]}\nh: 5/1024\nt_end: 20\n")
    most, k = 0.0, 1e4
    for _ in range(steps):
        v += h / 2 * 2 * k * max(1 - 2 * x, 0.0) ** 1.5
        x += h * v
        v += h / 2 * 2 * k * max(1 - 2 * x, 0.0) ** 1.5
        most = max(most, abs(0.5 * v * v + 0.4 * k * max(1 - 2 * x, 0.0) ** 2.5 - 0.5) / 0.5)
    left = abs(0.5 * v * v - 0.5) / 0.5
    result = cost(1, f"{base}/ball.yaml", "--steppers", "vti2", "--h", "5/1024", folder=f"{base}/ball")
    found = float(rows(f"{base}/ball", "cost.csv")[0]["energy_error"])
    check(result.returncode == 0 and abs(found - most) < 1e-6 * most and left < 0.5 * most,
          f"energy: {found:.6g}, {most:.6g} within the touch, {left:.2g} after it {result.stderr}")


def failing(base):
    """VTI-1 needs h|Omega| < 1."""
    folder = f"{base}/failing"
    result = cost(2, PENDULUM, "--h", "1,1/64", "--steppers", "vti1,vti2", folder=folder)
    check(result.returncode == 0, f"a failed run does not end the study {result.stderr}")
    steps = {stepper: [int(row["steps"]) for row in ladder] for (_, stepper), ladder in ladders(folder).items()}
    check(steps == {"vti1": [640], "vti2": [10, 640]}, f"it has no row: {steps}")
    check("1 run of vti1 that failed" in result.stdout and "h|Omega|" in result.stdout, "the screen names it and the reason")
    result = cost(1, PENDULUM, "--h", "2", "--t-end", "512", "--steppers", "exact,gear", folder=f"{base}/diverging")
    check(result.returncode == 0 and [stepper for _, stepper in ladders(f"{base}/diverging")] == ["exact"] and
          "1 run of gear that failed, the last one: gear at h = 2: at t = " in result.stdout and "the state is no longer finite" in result.stdout,
          f"a run that diverges has none: {result.stdout.strip()[-200:]}")


def all_by_one_step(base):
    """Runs whose largest step has every error on the list tell no trade of error against cost, and none is told; where
    it has some of them, the trade is that of the others."""
    result = cost(1, PENDULUM, "--t-end", "8", "--h", "8/4096", "--steppers", "exact,srkn14", folder=f"{base}/one")
    check(result.returncode == 0 and "factor of ten" not in result.stdout, f"one step for all errors tells no factor {result.stderr}")
    steps = ",".join(f"8/{1024 << k}" for k in range(7))
    result = cost(1, PENDULUM, "--t-end", "8", "--h", steps, "--steppers", "exact", folder=f"{base}/some")
    told = [float(line.split()[13]) for line in result.stdout.splitlines() if line.startswith("exact: a factor of ten")]
    evals = [float(row["force_evals"]) for row in rows(f"{base}/some", "prices.csv")
             if row["measure"] == "attitude" and row["force_evals"]]
    check(evals[0] == evals[1] and len(told) == 1 and 3.1 < told[0] < 3.25,
          f"about 3.16 times the evaluations, order 2, from finer ones: {told} {evals}")


def refused(base):
    cases = [
        ("unknown method", [PENDULUM, "--steppers", "vti1,frob"], ["--steppers", "'frob'", "exact", "lammps-richardson"]),
        ("one method twice", [PENDULUM, "--steppers", "rk4,rk4"], ["'rk4'", "twice"]),
        ("one scene twice", [PENDULUM, PENDULUM], ["pendulum", "twice", "@10,100"]),
        ("bad end of a scene", [PENDULUM + "@10,x"], ["pendulum.yaml@10,x", "'x'"]),
        ("h that does not divide", [PENDULUM, "--h", "0.3"], ["--h", "0.3", "does not divide"]),
        ("varied steps", [PENDULUM, "--set", "control=integrating"], ["pendulum: control: ", "leave it out"]),
        ("33 ends", [f"{PENDULUM}@{','.join(map(str, range(1, 34)))}"], ["pendulum: more than 32 scenes and ends"]),
        ("33 scenes", [PENDULUM, *(f"{base}/{k}.yaml" for k in range(1, 33))], ["32.yaml: more than 32 scenes; use fewer"]),
        ("bad --repeats", [PENDULUM, "--repeats", "1.5"], ["--repeats", "'1.5'"]),
        ("bad --evals", [PENDULUM, "--evals", "0"], ["--evals", "'0'"]),
    ]
    for k in range(1, 33):
        with open(PENDULUM, encoding="utf-8") as one, open(f"{base}/{k}.yaml", "w", encoding="utf-8") as other:
            other.write(one.read().replace("name: pendulum", f"name: p{k}"))
    for what, arguments, expected in cases:
        folder = f"{base}/refused"
        result = cost(2, *arguments, folder=folder)
        check(one_line(result, *expected) and not os.path.exists(folder), f"{what}: {result.stderr.strip()[:200]}")
    result = run(STUDY, "--evals", "10")
    check(result.returncode != 0 and "--cost only" in result.stderr, "--evals without --cost")


with tempfile.TemporaryDirectory() as work:
    same_bytes(work)
    columns(f"{work}/ranks2")
    for name in ("pendulum-2", "pendulum-4", "chain"):
        translates = ("position",) if name == "chain" else ()
        prices(f"{work}/ranks2", name, ("attitude", *translates, "velocity", "energy"))
    evaluations(work)
    translating(work)
    general(work)
    late_touch(work)
    every_step(work)
    failing(work)
    all_by_one_step(work)
    refused(work)
conclude()
