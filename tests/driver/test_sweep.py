#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""vti-study --sweep: each point has the bytes of a study of its own, any number of ranks gives the same, means and
spreads are those of the rows, what fails is a row, what is wrong is said before the start, an interrupted sweep goes
on, what
is edited meanwhile changes no point, and memory does not grow with the points.      test_sweep.py VTI_STUDY MPIRUN SCENES"""
import csv
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import h5py
import numpy

from programs import ENVIRONMENT, PATIENCE, contents, holds, one_line, run, size_of
from tally import MEMORY_TELLS, check, conclude

STUDY, MPIRUN, SCENES = sys.argv[1:4]
PENDULUM, SPIN, CHAIN, PILE = (os.path.join(SCENES, f"{name}.yaml") for name in ("pendulum", "spin", "chain", "pile"))
ERRORS = ("e_error", "q_error", "h1_error", "attitude_error", "momentum_error")


def study(ranks, *arguments, folder=None, **options):
    into = [] if folder is None else ["-o", folder]
    return run(MPIRUN, "-n", str(ranks), STUDY, "--no-plot", *arguments, *into, **options)


def rows(folder):
    with open(os.path.join(folder, "study.csv"), newline="", encoding="ascii") as file:
        return list(csv.DictReader(file))


def lines(folder):
    with open(os.path.join(folder, "study.csv"), encoding="ascii") as file:
        return file.read().splitlines()


def points(base):
    """Two keys, the first fastest, rivals among the steppers: rows, and those of each point by itself."""
    common = ["--h", "2^-4:2^-8", "--t-end", "2", "--steppers", "vti1,vti2,lammps-richardson"]
    swept = ["--sweep", "pendulum.weight=0.5:1.5:1/4", "--sweep", "bodies.inertia=1,2"]
    for ranks in (1, 2, 3):
        result = study(ranks, PENDULUM, *common, *swept, folder=f"{base}/sweep{ranks}")
        check(result.returncode == 0, f"a sweep on {ranks} ranks {result.stderr}")
    of = [contents(f"{base}/sweep{ranks}", ["timing.csv"]) for ranks in (1, 2, 3)]
    check(of[0] == of[1] == of[2] and len(of[0]) == 2, "the same bytes on 1, 2 and 3 ranks")
    head, *body = lines(f"{base}/sweep1")
    check(head.endswith("bonds_turned,pendulum.weight,bodies.inertia,failure") and len(body) == 5 * 2 * 15, "a row for each run")
    for k, (inertia, weight) in enumerate((i, w) for i in ("1", "2") for w in ("0.5", "0.75", "1", "1.25", "1.5")):
        run(STUDY, "--no-plot", PENDULUM, *common, "--set", f"bodies.inertia={inertia}", "--set", f"pendulum.weight={weight}",
            "-o", f"{base}/one")
        mine, alone = body[15 * k:15 * (k + 1)], lines(f"{base}/one")[1:]
        check(mine == [f"{line}{weight},{inertia}," for line in alone], f"weight {weight}, inertia {inertia}: the rows of its own study")
    with h5py.File(f"{base}/sweep1/study.h5") as file, h5py.File(f"{base}/one/study.h5") as one:
        last = slice(-3 * 4, None)
        check(numpy.array_equal(file["orders/order"][last], one["orders/order"], equal_nan=True), "... and their orders")
        check(file["points/norm_squared"][-1] == one.attrs["norm_squared"], "... and its reference")
        means(file, rows(f"{base}/sweep1"))


def means(file, table):
    """As written, over the five weights at each inertia."""
    check(file.attrs["ensemble"] == b"pendulum.weight" and list(file["sweep/pendulum.weight/value"]) == [0.5, 0.75, 1, 1.25, 1.5]
          and list(file["sweep/bodies.inertia/value"]) == [1, 2], "what was swept")
    check(list(file["points/pendulum.weight"]) == [0, 1, 2, 3, 4] * 2 and list(file["points/bodies.inertia"]) == [0] * 5 + [1] * 5,
          "which value each point has")
    check([name.decode() for name in file["steppers/name"]] == ["vti1", "vti2", "lammps-richardson"], "the steppers by number")
    ensemble = {name: file["ensemble"][name][...] for name in file["ensemble"]}
    check(len(ensemble["h"]) == 2 * 15 and set(ensemble["runs"]) == {5} and set(ensemble["failed"]) == {0}, "ten groups' rows")
    off = 0.0
    for k in range(30):
        mine = [row for row in table[75 * (k // 15):75 * (k // 15 + 1)]][k % 15::15]
        for error in ERRORS:
            values = numpy.array([float(row[error]) for row in mine])
            off = max(off, abs(ensemble[f"mean_{error}"][k] / values.mean() - 1),
                      abs(ensemble[f"spread_{error}"][k] / values.std(ddof=1) - 1))
    check(off < 1e-12, f"means and spreads are those of the rows, to {off:.0e}")
    orders = file["orders/order"][...].reshape(2, 5, 12)
    check(numpy.allclose(file["ensemble_orders/mean_order"][...].reshape(2, 12), orders.mean(axis=1), rtol=1e-13) and
          numpy.allclose(file["ensemble_orders/spread_order"][...].reshape(2, 12), orders.std(axis=1, ddof=1), rtol=1e-9),
          "... and of orders")


def scenes(base):
    """Several scenes, each with a ladder of its own; contacts; texts as values; the end time."""
    result = study(2, PENDULUM, PILE, "--h", "1/1000,1/2000", "--t-end", "1/10", "--steppers", "vti2", folder=f"{base}/scenes")
    check([row["scene"] for row in rows(f"{base}/scenes")] == ["pendulum"] * 2 + ["pile"] * 2, f"two scenes {result.stderr}")
    study(1, PILE, "--h", "1/1000,1/2000", "--t-end", "1/10", "--steppers", "vti2", folder=f"{base}/pile")
    check(lines(f"{base}/scenes")[3:] == lines(f"{base}/pile")[1:], "... with the rows of their own studies")
    study(1, SPIN, "--sweep", "bodies.omega=[0, 0, 1],[0, 1, 0]", "--sweep", "t_end=1,2", "--h", "1/8", "--steppers", "vti2",
          folder=f"{base}/texts")
    found = [(row["bodies.omega"], row["t_end"]) for row in rows(f"{base}/texts")]
    with open(f"{base}/texts/study.csv", newline="", encoding="ascii") as file:
        head, *body = csv.reader(file)
    ends = [(line[head.index("t_end")], line[head.index("bodies.omega")], line[-2]) for line in body]
    check(ends == [("1", "[0, 0, 1]", "1"), ("1", "[0, 1, 0]", "1"), ("2", "[0, 0, 1]", "2"), ("2", "[0, 1, 0]", "2")],
          f"vectors and end times {ends} {found}")


def failures(base):
    """VTI-1 cannot turn that far; and no scene has a mass below 0."""
    for ranks in (1, 3):
        result = study(ranks, SPIN, "--sweep", "bodies.omega=[0, 0, 1],[0, 0, 5]", "--steppers", "vti1,vti2", "--h", "1/4,1/8",
                       "--t-end", "1", folder=f"{base}/failed{ranks}")
        check(result.returncode in (1, 3) and "1 failed" in result.stdout, f"a failed run is told: {result.returncode}")
    table = rows(f"{base}/failed1")
    check(contents(f"{base}/failed1", ["timing.csv"]) == contents(f"{base}/failed3", ["timing.csv"]), "... the same on 3 ranks")
    failed = [row for row in table if row["failure"]]
    study(1, SPIN, "--sweep", 'bodies.inertia="1",2', "--steppers", "vti2", "--h", "1/4", "--t-end", "1", folder=f"{base}/quotes")
    found = [row["bodies.inertia"] for row in rows(f"{base}/quotes")]
    check(found == ['"1"', "2"] and '0,"""1""",' in lines(f"{base}/quotes")[1], f"quotes in a value are doubled: {found}")
    check(len(table) == 8 and len(failed) == 1 and "vti1 at h = 0.25" in failed[0]["failure"] and failed[0]["verdict"] == "bad"
          and failed[0]["h1_error"] == "nan", "... it is a row with its reason")
    check(run(STUDY, "--no-plot", SPIN, "--sweep", "bodies.omega=[0, 0, 1],[0, 0, 5]", "--steppers", "vti1", "--h", "1/4",
              "--t-end", "1", "-o", f"{base}/code").returncode == 3, "... and the code is 3")
    with h5py.File(f"{base}/failed1/study.h5") as file:
        check(list(file["failures/run"]) == [4] and b"vti1 at h = 0.25" in file["failures/reason"][0] and
              list(file["ensemble/failed"]) == [1, 0, 0, 0] and list(file["ensemble/runs"]) == [1, 2, 2, 2], "... and counted")
    result = study(1, CHAIN, "--sweep", "bodies.mass=-1:1", "--h", "1/64", "--t-end", "1", folder=f"{base}/none")
    check(one_line(result, "--sweep bodies.mass=-1"), f"an end of a range is looked at first: {result.stderr.strip()}")
    result = study(1, CHAIN, "--sweep", "bodies.mass=1,2", "--set", "bodies.massive=1", "--h", "1/64", folder=f"{base}/other")
    check(one_line(result, "--set bodies.massive=1"), f"another key that begins alike is not the sweep's: {result.stderr.strip()}")
    study(1, CHAIN, "--sweep", "bodies.chain.spacing=1:2:1/2", "--h", "1/64", "--t-end", "1/4",
          "--steppers", "vti2", folder=f"{base}/good")
    check(all(not row["failure"] for row in rows(f"{base}/good")) and len(rows(f"{base}/good")) == 3, "values that suit")
    study(1, CHAIN, "--set", "bodies.inertia=0.1", "--sweep", "bodies.chain.spacing=1,1e-320,2", "--h", "1/64", "--t-end", "1/4", "--steppers", "vti2",
          folder=f"{base}/far")
    far = [(row["t_end"], row["steps"], row["failure"] != "") for row in rows(f"{base}/far")]
    check(far == [("0.25", "16", False), ("0.25", "16", True), ("0.25", "16", False)], f"... {far}")
    study(1, CHAIN, "--sweep", "binder.axial=100,1e300", "--h", "1/64", "--t-end", "1/4", "--steppers", "vti2", folder=f"{base}/stiff")
    lost = rows(f"{base}/stiff")[1]
    check(lost["t_end"] == "0.25" and lost["steps"] == "16" and "the reference solution stopped" in lost["failure"],
          f"a point without reference has the steps that it would take: {lost}")
    with open(f"{base}/far/timing.csv", newline="", encoding="ascii") as file:
        times = [row["ns_per_step"] for row in csv.DictReader(file)]
    check(len(times) == 3 and float(times[0]) > 0 and times[1] == "nan", f"a point that cannot be made takes {times[1]} a step")


def blown_up(base):
    """A stepper that a stiff bond blows up has infinite errors there, and no mean that leaves them out."""
    result = study(1, os.path.join(SCENES, "pair.yaml"), "--t-end", "20", "--h", "1/4,1/32", "--steppers", "vti2", "--sweep",
                   "binder.axial=200,2e6", folder=f"{base}/blown")
    table = rows(f"{base}/blown")
    finite = [[numpy.isfinite(float(row[error])) for error in ERRORS] for row in table]
    lost = [not all(finite[k]) or not all(finite[k + 2]) for k in range(2)]
    with h5py.File(f"{base}/blown/study.h5") as file:
        ensemble = {name: file["ensemble"][name][...] for name in file["ensemble"]}
    check(all(not row["failure"] for row in table) and list(ensemble["runs"]) == [2, 2] and list(ensemble["failed"]) == [0, 0],
          "runs and failed ones are as many as values")
    check(any(lost) and list(ensemble["infinite"]) == [sum(not all(finite[k + 2 * v]) for v in range(2)) for k in range(2)],
          f"what blew up is counted: {ensemble['infinite']}")
    for m, error in enumerate(ERRORS):
        means = [numpy.inf if not (finite[k][m] and finite[k + 2][m]) else
                 numpy.mean([float(table[k][error]), float(table[k + 2][error])]) for k in range(2)]
        check(numpy.allclose(ensemble[f"mean_{error}"], means, rtol=1e-12), f"... {error}: means {ensemble[f'mean_{error}']}, not {means}")
    told = [line for line in result.stdout.splitlines() if line.endswith("with infinite errors")]
    check(len(told) == sum(lost) and all("  2  " in line and " inf " in line for line in told), f"... and it is told {told}")


def pictures(base):
    """Mean and spread of the groups, a note of what failed, and the same bytes again."""
    command = [STUDY, SPIN, "--sweep", "bodies.omega=[0, 0, 1],[0, 0, 5],[1, 2, 0]", "--sweep", "bodies.inertia=1:6", "--h", "1/4:1/16",
               "--t-end", "1", "--steppers", "vti1,rk4", "-o", f"{base}/drawn"]
    drawn = []
    for launch in ([], [MPIRUN, "-n", "2"]):  # mpirun ends all ranks with the first that does not end well
        result = run(*launch, *command)
        check(result.returncode == 3 and "ensemble.png" in result.stdout and "1 run failed" in result.stdout and
              "2 more groups not drawn" in result.stdout, f"a sweep is drawn {result.stdout[-200:]} {result.stderr}")
        drawn.append(contents(f"{base}/drawn").get("ensemble.png"))
    check(drawn[0] == drawn[1] and drawn[0][:4] == b"\x89PNG", "... twice the same")


def tolerances(base):
    """Steps by a tolerance: errors fall with it, evaluations grow, momenta stay, and the step of a row is between looks
    only."""
    result = run(STUDY, "--no-plot", CHAIN, "--t-end", "1", "--sweep", "tolerance=1e-3,1e-5,1e-7", "--steppers",
                 "srkn11", "--h", "1/4", "-o", f"{base}/tolerances")
    check(result.returncode == 0, f"a sweep over tolerances {result.stderr}")
    of = rows(f"{base}/tolerances")
    errors, evals = ([float(row[key]) for row in of] for key in ("attitude_error", "force_evals"))
    check(len(of) == 3 and errors[0] > 20 * errors[1] > 400 * errors[2] > 0,
          f"errors fall with the tolerance: {errors}")
    check(4 * 11 < evals[0] < evals[1] < evals[2], f"... and take evaluations: {evals}")
    check(all(float(row["momentum_error"]) < 1e-13 and row["verdict"] == "good" for row in of),
          "... momenta stay, and verdicts are good")
    run(STUDY, "--no-plot", PENDULUM, "--tolerance", "1e-6", "--t-end", "1", "--sweep", "bodies.inertia=1,2", "--steppers",
        "srkn11", "--h", "1/4:1/32", "-o", f"{base}/no_order")
    with h5py.File(f"{base}/no_order/study.h5") as file:
        check(len(file["orders/order"]) == 8 and all(numpy.isnan(file["orders/order"])), "... and no order of h is fitted to them")
    for arguments, words in ((["--steppers", "vti2"], ["vti2 has no estimate", "srkn11"]),
                             (["--cost"], ["tolerance", "srkn11-tol"])):
        result = run(STUDY, "--no-plot", CHAIN, "--tolerance", "1e-6", "--t-end", "1", *arguments, "-o", f"{base}/no")
        check(result.returncode != 0 and all(word in result.stderr for word in words),
              f"{arguments}: {result.stderr.strip()[-160:]}")


def refused(base):
    cases = [("pendulum.wait=1:3", ["--sweep pendulum.wait=1", "unknown key 'wait'"]),
             ("pendulum.weight=1:x", ["--sweep pendulum.weight=1:x", "'x' is not a number"]),
             ("pendulum.weight=1,two", ["--sweep pendulum.weight=two", "'two'"]),
             ("pendulum.weight=3:1", ["the range is empty"]), ("pendulum.weight=1:3:0", ["the range is empty", "steps of 0"]),
             ("pendulum.weight=1,,2", ["a value is empty"]), ("pendulum.weight", ["is not KEY=VALUES"]),
             ("pendulum.weight=1:400000", ["more than 1000000 runs"]), ("pendulum.weight=1:1e300", ["more than 1000000 runs"]),
             ("pendulum.weight=1:-2:-1", ["--sweep pendulum.weight=-2"]), ("h=1,2", ["use --h"]), ("stepper=vti1", ["use --steppers"]),
             ("name=a,b", ["name is not swept"]), ("bodies.inertia=1,1,2", ["'1' appears twice", "once"]),
             ("bodies.inertia=1/2,3,1,0.5", ["--sweep bodies.inertia=1/2,3,1,0.5", "appears twice"]),
             ("bodies.omega=[0, 0, 1],[0,1,0],[0,0,1]", ["'[0,0,1]' appears twice"])]
    for text, words in cases:
        result = run(STUDY, PENDULUM, "--h", "1/4", "--sweep", text, "-o", f"{base}/refused")
        check(one_line(result, *words) and not os.path.exists(f"{base}/refused"), f"{text}: {result.stderr.strip()[:160]}")
    result = study(3, PENDULUM, "--sweep", "pendulum.wait=1:3", folder=f"{base}/refused")
    check(one_line(result, *cases[0][1]) and not os.path.exists(f"{base}/refused"), "one of three ranks says it")
    for what, arguments, words in (("twice", ["--sweep", "t_end=1,2", "--sweep", "t_end=3"], ["swept twice"]),
                                   ("end time twice", ["--sweep", "t_end=1,2", "--t-end", "1"], ["--t-end"]),
                                   ("set besides", ["--sweep", "bodies.inertia=1,2", "--set", "bodies.inertia=3"],
                                    ["--set bodies.inertia=3", "bodies.inertia is swept", "leave one of them out"]),
                                   ("tolerated besides", ["--sweep", "tolerance=1e-3,1e-4", "--tolerance", "1e-5"],
                                    ["vti-study: --tolerance=1e-5", "tolerance is swept", "leave one of them out"]),
                                   ("with --cost", ["--cost", "--sweep", "t_end=1,2"], ["--sweep", "--cost"]),
                                   ("one name", [PENDULUM], ["two scenes have the name pendulum"]),
                                   ("h", ["--sweep", "pendulum.weight=1,2", "--h", "100"], ["--h", "longer than t_end"]),
                                   ("no estimate", ["--sweep", "pendulum.weight=1,2", "--h", "1/4", "--tolerance", "1e-6", "--steppers",
                                                    "srkn11,vti2"], ["the stepper vti2 has no estimate"])):
        result = run(STUDY, PENDULUM, *arguments, "-o", f"{base}/refused")
        check(one_line(result, *words) and not os.path.exists(f"{base}/refused"), f"{what}: {result.stderr.strip()[:160]}")


def interrupted(base):
    """Killed on the way, on other ranks again, and once more by a signal: the bytes of one that nobody disturbed. What
    is done is kept every half second: it takes longer than that."""
    arguments = [PENDULUM, "--sweep", "pendulum.weight=1:2:1/64", "--h", "2^-9:2^-11", "--t-end", "60", "--steppers", "vti2"]
    study(2, *arguments, folder=f"{base}/whole")
    for ending in (signal.SIGKILL, signal.SIGTERM):
        child = subprocess.Popen([STUDY, "--no-plot", *arguments, "--resume", "-o", f"{base}/legs"], env=ENVIRONMENT,
                                 stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        before = size_of(f"{base}/legs/study.journal")
        while child.poll() is None and not (holds(f"{base}/legs/study.journal") and size_of(f"{base}/legs/study.journal") > before):
            time.sleep(0.001)
        child.send_signal(ending)
        words = child.communicate(timeout=PATIENCE)[1].decode()
        check(ending == signal.SIGKILL or re.search(r"stopped; \d+ of 65 points are kept", words), f"it tells of points {words.strip()}")
        check(child.returncode in (75, -signal.SIGKILL), f"it ends by {ending.name} with {child.returncode}")
    other = study(1, *arguments[:2], "pendulum.weight=1:2:1/32", *arguments[3:], "--resume", folder=f"{base}/legs")
    check(one_line(other, "study.journal", "another study"), f"another sweep is refused: {other.stderr.strip()[:200]}")
    result = study(3, *arguments, "--resume", folder=f"{base}/legs")
    check(result.returncode == 0 and re.match(r"goes on: \d+ of 65 points", result.stdout), f"it goes on {result.stdout[:100]} {result.stderr}")
    check(contents(f"{base}/legs", ["timing.csv"]) == contents(f"{base}/whole", ["timing.csv"]), "... to the same bytes")


def start(folder, done, *arguments):
    """A sweep that has kept something and goes on."""
    child = subprocess.Popen([STUDY, "--no-plot", *arguments, "-o", folder], env=ENVIRONMENT, stdout=subprocess.PIPE,
                             stderr=subprocess.PIPE, text=True)
    while child.poll() is None and not holds(f"{folder}/study.journal"):
        time.sleep(0.001)
    check(child.poll() is None, f"{done} while it runs")
    return child


def edited(base):
    """What scenes and tables say when it begins counts at all points. A scene may be edited while it runs; a table that
    is, or that cannot be read for a while, ends it, and with what it was the sweep goes on to the bytes of one that
    nobody disturbed."""
    with open(CHAIN, encoding="ascii") as file:
        scene = file.read()
    arguments = ["--h", "1/64,1/128", "--t-end", "5", "--steppers", "vti2", "--sweep", "bodies.random.seed=1:60"]
    for name, text in (("scene", scene), ("same", scene)):
        os.mkdir(f"{base}/{name}")
        with open(f"{base}/{name}/chain.yaml", "w", encoding="ascii") as file:
            file.write(text)
    child = start(f"{base}/edited", "a scene is edited", f"{base}/scene/chain.yaml", *arguments)
    with open(f"{base}/scene/chain.yaml", "w", encoding="ascii") as file:
        file.write("bodies: {x: [0, 0, 0]}\n")
    child.communicate(timeout=PATIENCE)
    study(2, f"{base}/same/chain.yaml", *arguments, folder=f"{base}/whole")
    check(child.returncode == 0 and contents(f"{base}/edited", ["timing.csv"]) == contents(f"{base}/whole", ["timing.csv"]),
          "... and all points are of the scene as it was")

    def table(name, axial):
        with open(f"{base}/{name}.csv", "w", encoding="ascii") as file:
            file.write("i,j,axial\n" + "".join(f"{k},{k + 1},{axial}\n" for k in range(9)))
    for name, axial in (("a", 100), ("b", 200)):
        table(name, axial)
    with open(f"{base}/table.yaml", "w", encoding="ascii") as file:
        file.write("bodies: {chain: {count: 10, spacing: 1}, mass: 1, random: {seed: 1, v: 0.1}}\nbinder: {table: a.csv}\n"
                   "h: 1/64\nt_end: 5\n")
    arguments = [f"{base}/table.yaml", "--h", "1/64,1/128", "--steppers", "vti2", "--sweep", "bodies.random.seed=1:60",
                 "--sweep", "binder.table=a.csv,b.csv"]
    study(2, *arguments, folder=f"{base}/tables")
    for what, change in (("changes", lambda: table("b", 300)), ("is gone", lambda: os.remove(f"{base}/b.csv"))):
        child = start(f"{base}/{what}", f"a table {what}", *arguments)
        change()
        words = child.communicate(timeout=PATIENCE)[1]
        check(child.returncode == 1 and words.count("\n") == 1 and "b.csv" in words and os.listdir(f"{base}/{what}") == ["study.journal"],
              f"... and ends it: {words.strip()}")
        if what == "changes":
            other = study(1, *arguments, "--resume", folder=f"{base}/{what}")
            check(one_line(other, "another study", "table 2 of the points, of bonds"),
                  f"... it goes on with none but the tables that it began with: {other.stderr.strip()}")
        table("b", 200)
        result = study(3, *arguments, "--resume", folder=f"{base}/{what}")
        check(result.returncode == 0 and "goes on: " in result.stdout and
              contents(f"{base}/{what}", ["timing.csv"]) == contents(f"{base}/tables", ["timing.csv"]),
              f"... and with these goes on to the same bytes {result.stderr.strip()}")


def memory(base):
    """What 10000 more runs take: a struct of a run is 360 bytes, so that all would take 3600 kB."""
    def most(points):
        shutil.rmtree(f"{base}/memory", ignore_errors=True)
        code = ("import resource, subprocess, sys; subprocess.run(sys.argv[1:], check=True, stdout=subprocess.DEVNULL); "
                "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)")
        return int(run(sys.executable, "-c", code, STUDY, "--no-plot", SPIN, "--sweep", f"bodies.inertia=1:{points}", "--h", "1/4",
                       "--t-end", "1/4", "--steppers", "vti1,vti2", "-o", f"{base}/memory").stdout)
    few, many = most(2500), most(7500)
    check(not MEMORY_TELLS or many - few < 1500, f"{few} kB for 5000 runs, {many} kB for 15000")


def strays(base):
    """Where motion is chaotic a sweep says so, and tells orders of the energy alone."""
    with open(f"{base}/stray.yaml", "w", encoding="ascii") as file:
        file.write("bodies: {lattice: {counts: [2, 2, 2], spacing: 1.1, corner: [0, 0, 1]}, diameter: 1, mass: 1,\n"
                   "  random: {seed: 1, v: 1}}\ncontact: {stiffness: 500}\nwall: {stiffness: 500, planes: [[0, 0, 1, 0], "
                   "[1, 0, 0, -1], [-1, 0, 0, -2.5], [0, 1, 0, -1], [0, -1, 0, -2.5], [0, 0, -1, -4]]}\nh: 1/128\nt_end: 20\n")
    done = study(2, f"{base}/stray.yaml", "--steppers", "vti2", "--h", "1/64:1/256", "--sweep", "bodies.random.seed=1:2",
                 folder=f"{base}/stray")
    check("at 2 of 2 points the solution is known to no better than 0.001: the motion is chaotic" in done.stdout,
          f"the sweep says that the motion is chaotic {done.stderr}")
    fitted = [line.split() for line in done.stdout.splitlines() if line.startswith("vti2")][-1]
    check(fitted[1] != "-" and fitted[-3:] == ["-", "-", "-"], f"orders: {fitted}")
    for added, words in (("", "the motion is chaotic: no method can follow it"),
                         ("dashpot: {restitution: 0.98, ratio: 0.5}\n", "runs by steps of that kind still part: ")):
        with open(f"{base}/stray.yaml", "a", encoding="ascii") as file:
            file.write(added)
        said = study(1, f"{base}/stray.yaml", "--steppers", "vti2", "--h", "1/64:1/256", folder=f"{base}/alone{len(added)}").stdout
        check(f"\n{words}" in said, f"... and a study: {said.splitlines()[-2:]}")


def by_name(base):
    """Without -o results are where one is, named after what is run."""
    for options, folder in (((), "study-spin"), (("--sweep", "bodies.inertia=1,2"), "sweep-spin")):
        done = run(os.path.abspath(STUDY), "--no-plot", "--h", "0.3,2^-2", "--t-end", "1.5", *options, os.path.abspath(SPIN), cwd=base)
        check(done.returncode == 0 and os.path.exists(f"{base}/{folder}/study.h5"), f"{folder} is made {done.stderr}")
        runs = 12 if options else 6
        check(f"\nverdict: of {runs} runs {runs} are good, 0 doubtful, 0 bad\n" in done.stdout, f"... {runs} runs, all of them good")
        check(options or re.findall(r"^vti1 +(\S+) ", done.stdout, re.MULTILINE)[:2] == ["0.3", "1/4"], "... with h as one would write it")


for topic in (points, scenes, failures, blown_up, pictures, tolerances, refused, interrupted, edited, memory, strays, by_name):
    with tempfile.TemporaryDirectory() as root:
        topic(root)
conclude()
