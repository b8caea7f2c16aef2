#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""vti-study as a user runs it: the paper's numbers, the orders, the same bytes for any number of ranks, and every kind
of
bad input.      test_study.py VTI_STUDY MPIRUN"""
import csv
import os
import re
import shutil
import subprocess
import sys
import tempfile

import h5py
import numpy

from programs import ENVIRONMENT, contents, one_line, run
from tally import check, conclude

STUDY, MPIRUN = sys.argv[1:3]
CHAIN, TORUS = (os.path.join(os.path.dirname(STUDY), "..", "scenes", name + ".yaml") for name in ("chain", "torus"))


def study(ranks, *arguments, folder=None):
    into = [] if folder is None else ["-o", folder]
    return run(MPIRUN, "-n", str(ranks), STUDY, "--no-plot", *arguments, *into)


def rows(folder):
    with open(os.path.join(folder, "study.csv"), newline="") as file:
        return list(csv.DictReader(file))


def paper_numbers(folder):
    """EQUATIONS 4, h = 1/64, t_N = 10; each printed digit must come out."""
    printed = {"vti1": ("1.079e-04", "1.396e-03", "1.367e-04"),
               "vti2": ("1.232e-05", "4.777e-03", "6.248e-05"),
               "vti3": ("8.679e-03", "3.134e-02", "3.389e-03")}
    for row in rows(folder):
        if float(row["h"]) == 1 / 64 and row["stepper"] in printed:
            found = tuple("%.3e" % float(row[m]) for m in ("e_error", "q_error", "h1_error"))
            check(found == printed[row["stepper"]], f"{row['stepper']} at h = 1/64: {found}")


def orders(folder, what):
    """EQUATIONS 4: E 2, 2, 1; q 1, 1, 1/2; true 2, 2, 1; with half kicks VTI-3 is 2, 1, 2. Each inside its interval,
    and the interval narrow enough to tell one order from another."""
    expected = {"vti1": (2, 1, 2, 2), "vti2": (2, 1, 2, 2), "vti3": (1, 0.5, 1, 1), "vti3-leapfrog": (2, 1, 2, 2)}
    measures = ["e_error", "q_error", "h1_error", "attitude_error"]
    with h5py.File(os.path.join(folder, "study.h5")) as file:
        table = {name: file["orders"][name][...] for name in file["orders"]}
    for stepper, measure, order, interval in zip(table["stepper"], table["measure"], table["order"], table["interval"]):
        stepper, measure = stepper.decode(), measure.decode()
        want = expected[stepper][measures.index(measure)]
        check(abs(order - want) <= interval < 0.2, f"{what} {stepper} {measure}: {order:.6f} +- {interval:.6f}, not {want}")


def as_in_pictures(said, folder):
    """Orders on the terminal are rounded as in pictures: the interval up to one digit."""
    sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "drivers"))
    from plot import words  # pylint: disable=import-outside-toplevel
    with h5py.File(os.path.join(folder, "study.h5")) as file:
        table = {name: file["orders"][name][...] for name in file["orders"]}
    expected = {}
    for stepper, order, interval in zip(table["stepper"], table["order"], table["interval"]):
        expected.setdefault(stepper.decode(), []).append(words.with_interval(order, interval).replace("±", "+-"))
    printed = {line.split()[0]: re.findall(r"[\d.]+ \+- [\d.]+", line) for line in said.split("fitted order")[1].splitlines()[1:5]}
    check(printed == expected, f"orders on the terminal: {printed}, {expected}")


def same_bytes(base):
    """More ranks than runs included."""
    for ranks in (1, 2, 3, 5):
        study(ranks, "--h", "2^-4:2^-9", "--steppers", "vti1,vti3", folder=f"{base}/ranks{ranks}")
        study(ranks, "--h", "1/32", "--steppers", "vti2", folder=f"{base}/few{ranks}")
    for kind in ("ranks", "few"):
        for name in ("study.h5", "study.csv"):
            contents = {open(f"{base}/{kind}{ranks}/{name}", "rb").read() for ranks in (1, 2, 3, 5)}
            check(len(contents) == 1, f"{kind}: {name} is the same on 1, 2, 3 and 5 ranks")


def same_bytes_with_walls(base):
    """Of a scene with contacts the reference is known at intervals, and every rank works out its runs against it."""
    for ranks in (1, 2, 3, 5):
        result = study(ranks, TORUS, "--h", "1/500:1/2000", "--t-end", "0.5", "--steppers", "vti1,vti2", folder=f"{base}/walls{ranks}")
        check(result.returncode == 0, f"a study with walls on {ranks} ranks {result.stderr}")
        check(contents(f"{base}/walls{ranks}", ["timing.csv"]) == contents(f"{base}/walls1", ["timing.csv"]),
              f"with walls: the same on {ranks} ranks as on 1")


def not_whole(base):
    result = study(1, "--h", "0.3", "--t-end", "1", folder=f"{base}/whole")
    check(rows(f"{base}/whole")[0]["steps"] == "3" and "not a multiple" in result.stdout, "h = 0.3 does not divide t_end = 1, it says")
    study(1, "--h", "2^-10,2^-11", "--t-end", "1.6", "--steppers", "vti2,srkn11", folder=f"{base}/last")  # 1638 and 3276 steps
    with h5py.File(f"{base}/last/study.h5") as file:
        ends = [(len(run["t"]), run["t"][-1] / run.attrs["h"]) for run in file["series"].values()]
    check(ends == 2 * [(411, 1638), (469, 3276)], f"series end where runs do: {ends}")


def refused(base):
    scene = f"{base}/scene.yaml"
    shutil.copy(os.path.join(os.path.dirname(STUDY), "..", "scenes", "pendulum.yaml"), scene)
    with open(scene) as file:
        text = file.read()

    def variant(old, new):
        path = f"{base}/variant.yaml"
        with open(path, "w") as file:
            file.write(text.replace(old, new))
        return path

    blocked = f"{base}/file"
    open(blocked, "w").close()
    cases = [
        ("unknown key", lambda: [variant("inertia:", "inertai:")], ["variant.yaml:", "inertai", "inertia"]),
        ("negative h", lambda: [scene, "--h", "-0.1"], ["--h", "'-0.1'"]),
        ("half a ladder", lambda: [scene, "--h", "0.1:x"], ["--h", "'0.1:x' is not a ladder"]),
        ("an end that is no number", lambda: [scene, "--t-end", "-1"], ["--t-end", "'-1' is not a positive number"]),
        ("not a ladder", lambda: [scene, "--h", "0.1:0.03"], ["--h", "factors of two"]),
        ("one step twice", lambda: [scene, "--h", "1/64,2^-6"], ["--h", "twice"]),
        ("step beyond the end", lambda: [scene, "--h", "100"], ["--h", "100", "t_end"]),
        ("scene's step beyond the end", lambda: [variant("h: 1/64", "h: 10"), "--t-end", "1"],
         ["the scene's h = 10: 40 is longer than t_end = 1", "--h"]),
        ("more steps than can be counted", lambda: [scene, "--h", "1/16", "--t-end", "1e300"],
         ["--h", "t_end = 1e+300 is more than 2^53 steps of h = 0.0625"]),
        ("steps without number", lambda: [scene, "--h", "1e-300", "--t-end", "1e300"], ["more than 2^53 steps of h = 1e-300"]),
        ("more steps than can be counted, of pairs", lambda: [TORUS, "--h", "1/16", "--t-end", "1e300"], ["more than 2^53 steps"]),
        ("more steps than can be counted, priced", lambda: [scene, "--cost", "--h", "1/16", "--t-end", "1e300"],
         ["t_end = 1e+300 of pendulum is more than 2^53 steps of h = 0.0625"]),
        ("steps that do not meet", lambda: [TORUS, "--h=0.001,0.0007"],
         ["--h: 0.0007 does not divide the longest step 0.001", "use a ladder such as 1/1000:1/8000"]),
        ("unknown stepper", lambda: [scene, "--steppers", "vti1,rk5"], ["--steppers", "'rk5'", "vti1, vti2, vti3"]),
        ("a stepper of the scene", lambda: [scene, "--set", "stepper=vti2"], ["--set stepper=vti2", "use --steppers"]),
        ("a step beside steps", lambda: [scene, "--set", "h=1/8", "--h", "1/64"], ["--set h=1/8", "--h has the steps"]),
        ("an end beside the end", lambda: [scene, "--set", "t_end=3", "--t-end", "1"], ["--set t_end=3", "--t-end has the end"]),
        ("a stepper of the scene, priced", lambda: [scene, "--cost", "--set", "stepper=vti2"], ["--set stepper=vti2", "use --steppers"]),
        ("unknown option", lambda: [scene, "--frob"], ["--frob", "--help"]),
        ("rival of spheres", lambda: [variant("inertia: 1 ", "moments: [1, 1, 1] "), "--steppers", "vti2,mercury"],
         ["bodies.moments", "mercury"]),
        ("no estimate, before the reference, which would fail",
         lambda: [CHAIN, "--set", "binder.axial=1e300", "--tolerance", "1e-6", "--steppers", "srkn11,vti2", "--t-end", "1"],
         ["the stepper vti2 has no estimate"]),
        ("drag of a rival, before the reference, which would fail",
         lambda: [CHAIN, "--set", "binder.axial=1e300", "--set", "drag.linear=1", "--steppers", "vti2,rk4", "--t-end", "1"],
         ["drag dissipates", "the stepper rk4"]),
        ("one scene twice", lambda: [scene, scene], ["two scenes have the name pendulum"]),
        ("forces that overflow", lambda: [CHAIN, "--set", "binder.axial=1e300", "--t-end", "1"],
         ["chain: the reference solution stopped at t = ", "its error stays too large"]),
        ("forces that overflow, of pairs", lambda: [TORUS, "--set", "binder.axial=1e300", "--t-end", "1"],
         ["torus: the reference solution stopped at t = 0: contacts: body ", " is at (nan, nan, nan)"]),
        ("contacts that no step can see", lambda: [TORUS, "--set", "contact.stiffness=1e300", "--t-end", "1"],
         ["torus: the reference solution would need steps of at most ", "soften the scene"]),
    ]
    for what, arguments, expected in cases:
        for ranks in (1, 3):
            folder = f"{base}/refused"
            shutil.rmtree(folder, ignore_errors=True)
            one_refusal(f"{what}, {ranks} ranks", study(ranks, *arguments(), folder=folder), expected, folder)
    for ranks in (1, 3):
        one_refusal(f"a name of 6000 letters, {ranks} ranks", study(ranks, scene, folder=f"{base}/{6000 * 'a'}"), ["-o", "is too long"], None)
        one_refusal(f"option without value, {ranks} ranks", study(ranks, scene, "-o"), ["-o", "needs a value"], None)
        one_refusal(f"unwritable folder, {ranks} ranks", study(ranks, scene, "--h", "1/64", folder=f"{blocked}/out"),
                    [f"{blocked}/out", "-o"], None)


TABLES = """name: tables
bodies: {table: table.ENDING}
binder: {table: BONDS}
h: 1/64
t_end: 1
"""


def without_orders(base):
    """What an order lacks is said: steps, errors above rounding, or that steps go by the tolerance."""
    for arguments, said in ((("--h", "1/64,1/128"), "three steps at the least"),
                            (("--h", "2^-9:2^-11", "--steppers", "srkn14"), "fewer than three errors above rounding"),
                            (("--tolerance", "1e-6", "--steppers", "srkn11"), "there is no order of h")):
        done = study(1, *arguments, "--t-end", "1", folder=f"{base}/without")
        check(done.returncode == 0 and [said in line for line in done.stdout.splitlines() if line.startswith("- ")] == [True],
              f"{' '.join(arguments)}: {said}")
    check(done.stdout.splitlines()[-5].split() == ["srkn11", "-", "-", "-", "-"], "steps by a tolerance have no orders of h")


def stiff_energies(base):
    """Energies of a stiff scene are not known to rounding of 1, and of what is left of their errors no order is
    told."""
    with open(f"{base}/stiff.yaml", "w", encoding="ascii") as file:
        file.write("bodies: {chain: {count: 3, spacing: 1}, mass: 1, random: {seed: 3, v: 0.3, omega: 1}}\n"
                   "binder: {axial: 1e6, moment: 1, shear: {stiffness: 10}}\nh: 1e-3\nt_end: 0.5\n")
    study(1, f"{base}/stiff.yaml", "--h", "2^-11:2^-15", "--steppers", "vti2,srkn14", folder=f"{base}/stiff")
    with h5py.File(f"{base}/stiff/study.h5") as file:
        table = {name: file["orders"][name][...] for name in file["orders"]}
    found = {stepper.decode(): order for stepper, measure, order in zip(table["stepper"], table["measure"], table["order"])
             if measure == b"e_error"}
    check(abs(found["vti2"] - 2) < 0.1 and numpy.isnan(found["srkn14"]), f"orders of the energy error of stiff bonds: {found}")


def from_tables(base):
    """Bodies and bonds from CSV and from HDF5: the same numbers, the same bytes."""
    bodies = {"x": [0, 1, 2], "y": [0, 0, 1 / 3], "z": [0, 0, 0], "vx": [0, 0.1, 0], "vy": [0, 0, 0], "vz": [0, 0, 0.7],
              "mass": [1, 2, 1 / 7], "inertia": [1, 0.1, 0.2]}
    bonds = {"i": [0, 1], "j": [1, 2], "axial": [10, 20], "moment": [1, 1 / 9]}
    os.mkdir(f"{base}/tables")
    with h5py.File(f"{base}/tables/table.h5", "w") as file:
        for group, columns in (("bodies", bodies), ("bonds", bonds)):
            for name, values in columns.items():
                file[f"{group}/{name}"] = numpy.array(values, float)
    for name, columns in (("table.csv", bodies), ("bonds.csv", bonds)):
        with open(f"{base}/tables/{name}", "w", newline="") as file:
            csv.writer(file).writerows([columns, *zip(*[map(repr, values) for values in columns.values()])])
    scenes = {}
    for ending, second in (("csv", "bonds.csv"), ("h5", "table.h5")):
        scenes[ending] = f"{base}/tables/{ending}.yaml"
        with open(scenes[ending], "w") as file:
            file.write(TABLES.replace("ENDING", ending).replace("BONDS", second))
        result = study(2, scenes[ending], "--h", "1/64,1/128", folder=f"{base}/tables/{ending}")
        check(result.returncode == 0, f"a study of {ending} tables {result.stderr}")
    found = [{name: open(f"{base}/tables/{ending}/{name}", "rb").read() for name in ("study.csv", "study.h5")}
             for ending in scenes if os.path.isdir(f"{base}/tables/{ending}")]
    check(len(found) == 2 and found[0] == found[1], "CSV and HDF5 tables give the same bytes")
    check(len(rows(f"{base}/tables/csv")) == 6, "... of all runs")
    os.truncate(f"{base}/tables/table.h5", 1000)
    for ranks in (1, 3):
        one_refusal(f"a damaged table, {ranks} ranks", study(ranks, scenes["h5"], folder=f"{base}/tables/none"),
                    ["table.h5", "HDF5"], f"{base}/tables/none")


def one_refusal(what, result, expected, folder):
    check(one_line(result, *expected), f"{what}: exit code {result.returncode}, {result.stderr.strip()[:200]}")
    left = sorted(os.listdir(folder)) if folder is not None and os.path.isdir(folder) else []
    check(left == [], f"{what}: leaves nothing behind {left}")


def unheard(base):
    """Who reads standard output has gone: it is said, and the files are there."""
    with subprocess.Popen([STUDY, "--no-plot", "--steppers", "vti2", "--h", "1/64", "--t-end", "1", "-o", f"{base}/unheard"], env=ENVIRONMENT,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        process.stdout.close()
        words = process.stderr.read()
    check(process.returncode == 1 and words.count("\n") == 1 and "standard output: cannot be written" in words and
          sorted(os.listdir(f"{base}/unheard")) == ["study.csv", "study.h5", "timing.csv"], f"nobody listens: {words.strip()}")


def at_rest(base):
    """Bodies that rest in the origin: all norms and scales are 0, nothing changes, and no error is 0/0; of many, whose
    reference is known at intervals, too."""
    for count in (2, 60):
        with open(f"{base}/rest.csv", "w", encoding="ascii") as file:
            file.write("x,y,z,mass\n" + count * "0,0,0,1\n")
        with open(f"{base}/rest.yaml", "w", encoding="ascii") as file:
            file.write("name: rest\nbodies: {table: rest.csv}\nh: 1/16\nt_end: 1\n")
        done = study(1, f"{base}/rest.yaml", "--h", "1/16:1/64", folder=f"{base}/rest{count}")
        found = {row[name] for row in rows(f"{base}/rest{count}") for name in row if "error" in name}
        check(done.returncode == 0 and found == {"0"} and "nan" not in done.stdout, f"{count} bodies at rest: errors of 0 {found}")


def far_from_the_origin(base):
    """Small, light and stiff bodies, whose forces change with the last bit of a position by more than any tolerance:
    the reference comes to an end, and is known as well as it says: methods of high order, whose own errors are
    rounding, come that near."""
    with open(f"{base}/far.yaml", "w", encoding="ascii") as file:
        file.write("bodies: {chain: {count: 10, spacing: 1e-3}, mass: 1e-6, random: {seed: 7, v: 0.01, omega: 5}}\n"
                   "binder: {axial: 1, moment: 0.1}\nh: 1e-7\nt_end: 1e-4\n")
    known = []
    for x in (0, 1):
        done = study(1, f"{base}/far.yaml", "--h", "1e-7", "--steppers", "rk8pd,vern9", "--set", f"bodies.chain.start=[{x}, 0, 0]",
                     folder=f"{base}/far{x}")
        with h5py.File(f"{base}/far{x}/study.h5") as file:
            known.append((file.attrs["reference_uncertainty"], max(float(row["h1_error"]) for row in rows(f"{base}/far{x}"))))
        check(done.returncode == 0 and "it is rounding" in done.stdout, f"a stiff chain at x = {x} {done.stderr}")
    check(all(0.3 * error < told < 30 * error for told, error in known) and known[1][0] > 10 * known[0][0],
          f"... known as well as it says: {known}")
    check("it is rounding" not in study(1, CHAIN, "--h", "1/64", "--t-end", "1", folder=f"{base}/near").stdout, "... and nearer not")


def rivals(base):
    """They stand beside ours in every table, with the orders of the literature; the same bytes on any number of
    ranks."""
    steppers = ("exact", 2), ("lammps-richardson", 2), ("yade-leapfrog", 2), ("rk4", 4)
    for ranks in (1, 3):
        study(ranks, "--h", "2^-4:2^-9", "--steppers", ",".join(name for name, order in steppers), folder=f"{base}/rivals{ranks}")
    check(contents(f"{base}/rivals1", ["timing.csv"]) == contents(f"{base}/rivals3", ["timing.csv"]), "rivals: the same on 1 and 3 ranks")
    with h5py.File(f"{base}/rivals1/study.h5") as file:
        names, found = [name.decode() for name in file["orders/stepper"][3::4]], file["orders/order"][3::4]
    for (name, order), stepper, attitude in zip(steppers, names, found):
        check(name == stepper and abs(attitude - order) < 0.1, f"{name}: attitudes of order {attitude:.3f}")
    evals = {(row["stepper"], row["steps"]): int(row["force_evals"]) for row in rows(f"{base}/rivals1")}
    check(evals["rk4", "160"] == 640 and evals["lammps-richardson", "160"] == 161 and evals["exact", "160"] == 161,
          f"their force evaluations are counted, with those at t = 0: {evals}")


def general_inertia(base):
    """Bodies of three moments: true errors of the steppers' orders, and of the rotor's where nothing gives a moment."""
    scenes = os.path.join(os.path.dirname(STUDY), "..", "scenes")
    for scene, steppers in (("dzhanibekov", {"vti2": 2, "exact": 4, "suzuki4": 4}), ("heavy-top", {"vti2": 2, "exact": 2, "suzuki4": 4})):
        folder = f"{base}/{scene}"
        result = study(2, os.path.join(scenes, f"{scene}.yaml"), "--h", "2^-4:2^-8", "--t-end", "10", "--steppers", ",".join(steppers),
                       folder=folder)
        check(result.returncode == 0, f"{scene}: a study {result.stderr}")
        with h5py.File(os.path.join(folder, "study.h5")) as file:
            found = dict(zip(file["orders/stepper"][3::4], zip(file["orders/order"][2::4], file["orders/interval"][2::4])))
        for name, order in steppers.items():
            fitted, interval = found[name.encode()]
            check(abs(fitted - order) <= max(interval, 0.02) < 0.2, f"{scene}: {name} has order {fitted:.4f} +- {interval:.4f}")
    swept = study(2, os.path.join(scenes, "dzhanibekov.yaml"), "--h", "2^-1:2^-4", "--t-end", "10", "--steppers", "exact,fincham",
                  "--sweep", "rotor=2,4,6", folder=f"{base}/rotors")
    check(swept.returncode == 0, f"a sweep over rotors {swept.stderr}")
    with h5py.File(f"{base}/rotors/study.h5") as file:
        which, found = file["orders/stepper"][2::4], file["orders/order"][2::4]
    check(all(abs(order - rotor) < 0.15 for order, rotor in zip(found[which == 0], (2, 4, 6), strict=True)),
          f"exact's order is that of the rotor: {found[which == 0]}")
    check(len(set(found[which == 1])) == 1, f"a rival has its own: {found[which == 1]}")


def failed_runs(base):
    """VTI-1 cannot turn that far. The run is a row, and the others go on: with the bytes that they have without it."""
    steppers = ("--steppers", "vti2,vti1")
    for ranks in (1, 3):
        done = study(ranks, "--h", "1,1/64,1/128,2^-14", *steppers, folder=f"{base}/failed{ranks}")
        row = next((line.split("failed: ") for line in done.stdout.splitlines() if "failed: " in line), [""])
        check(done.returncode in (1, 3) and row[0].split() == ["vti1", "1", "10"] and row[1].startswith("vti1 at h = 1: step 2 (t = 1): body 0 has h|Omega|") and
              "\nverdict: of 8 runs 6 are good, 1 doubtful, 0 bad, and 1 failed\n" in done.stdout,
              f"a run fails on {ranks} ranks: {done.returncode} {row} {done.stderr}")
    check(contents(f"{base}/failed1", ["timing.csv"]) == contents(f"{base}/failed3", ["timing.csv"]), "... the same on 1 and 3 ranks")
    study(1, "--h", "1/64,1/128,2^-14", *steppers, folder=f"{base}/without_it")
    table, without_it = ({(row["stepper"], row["h"]): row for row in rows(f"{base}/{name}")} for name in ("failed1", "without_it"))
    lost = table["vti1", "1"]
    check(all(lost[name] == "nan" for name in lost if name.endswith("_error")) and lost["verdict"] == "bad" and "reduce h" in lost["failure"],
          "... its row has errors of nan, a bad verdict and the reason")
    check(len(table) == 8 and len(without_it) == 6 and all(table[run] == row and row["failure"] == "" for run, row in without_it.items()),
          "... and the others have theirs")
    with h5py.File(f"{base}/failed1/study.h5") as file:
        check([why != b"" for why in file["runs/failure"]] == 4 * [False] + [True] + 3 * [False] and
              sorted(file["series"]) == [f"{run:06d}" for run in (0, 1, 2, 3, 5, 6, 7)], "... in study.h5 too, without a series")
    for steps, note in (("1,1/64,1/128,1/256", "1 run failed (VTI-1)"), ("1,2", "2 runs failed (VTI-1)")):
        drawn = run(STUDY, "--h", steps, "--steppers", "vti1", "-o", f"{base}/drawn")
        check(drawn.returncode == 3 and note in drawn.stdout and "not a finite number" not in drawn.stdout, f"it is drawn {drawn.stdout[-300:]}")


def keeps_what_was_there(base):
    """A study that fails does not touch the files of the one before it."""
    folder = f"{base}/kept"
    study(2, "--h", "1/64", folder=folder)
    before = contents(folder)
    study(2, CHAIN, "--set", "binder.axial=1e300", "--h", "1/64", "--t-end", "1", folder=folder)
    check(len(before) == 3 and before == contents(folder), "a failed study leaves the files of the one before")


def known_as_well(base):
    """The middle axis of a body turns errors of a step into many times as much: the reference says so, and what is
    below has no order."""
    scene = os.path.join(os.path.dirname(CHAIN), "dzhanibekov.yaml")
    done = study(2, scene, "--h", "1/64,1/128,1/256", "--steppers", "srkn11", folder=f"{base}/known")
    with h5py.File(f"{base}/known/study.h5") as file:
        known = file.attrs["reference_uncertainty"]
        table = dict(zip(file["orders"]["measure"][...], file["orders"]["order"][...]))
    least = min(float(row["h1_error"]) for row in rows(f"{base}/known"))
    check(done.returncode == 0 and least < known < 100 * least, f"known to {known:.1e}, below which no error falls: {least:.1e}")
    check(numpy.isnan(table[b"h1_error"]) and numpy.isnan(table[b"attitude_error"]), "... and such errors have no order")


FALL = """bodies: {x: [0, 0, 0.85], v: [1.7153, 0, 0], mass: 0.7, diameter: 0.1}
gravity: [0, 0, -9.81]
wall: {stiffness: 1000, planes: [[0, 0, 1, 0.5]]}
h: 1/64
t_end: 1
"""


def when_compared(base):
    """Scenes with walls are compared at common times, of which memory may hold few: both are said."""
    with open(f"{base}/fall.yaml", "w", encoding="ascii") as file:
        file.write(FALL)
    steps = ("--h", "0.02,0.01,0.005", "--steppers", "vti2")
    for options, said in ((("--t-end", "0.99"), "multiples of 0.02, the longest step, and all end at t = 0.98"),
                          (("--memory", "2e-3"), "multiples of 0.04, as --memory holds no more of its states, and all end at t = 1")):
        done = study(1, f"{base}/fall.yaml", *steps, *options, folder=f"{base}/fall")
        check([said in line for line in done.stdout.splitlines() if line.startswith("note:")] == [True], said)
    one_refusal("memory", study(1, f"{base}/fall.yaml", *steps, "--memory", "1e-5", folder=f"{base}/few"), "--memory: 10 bytes hold",
                f"{base}/few")


def in_other_units(base):
    """Grains of a micrometre in SI units, and the same in micrometres: solutions known as well, errors the same shares,
    of contacts (GSL's states at intervals) and of bonds (panels)."""
    touch = "contact: {young: %g, poisson: 0.3}\nwall: {young: %g, poisson: 0.3, planes: [[0, 0, 1, %g]]}\nh: 1/64\nt_end: 10\n"
    bond = "binder: {axial: %g}\nh: 1/64\nt_end: 2\n"
    for name, si, scaled in (("touch", touch % (1e-3, 1e-3, -0.52e-6), touch % (1e9, 1e9, -0.52)),
                             ("bond", bond % 6.5e-26, bond % 6.5e4)):
        found = []
        for unit, effects in ((1e-6, si), (1, scaled)):
            with open(f"{base}/grains.yaml", "w", encoding="ascii") as file:
                file.write(f"bodies: {{chain: {{count: 3, spacing: {1.02 * unit}}}, diameter: {unit}, density: 2500, "
                           f"random: {{seed: 7, v: {1e-2 * unit}}}}}\n" + effects)
            study(2, f"{base}/grains.yaml", "--h", "1/64,1/256", "--steppers", "vti2", folder=f"{base}/grains{name}{unit}")
            with h5py.File(f"{base}/grains{name}{unit}/study.h5") as file:
                found.append((file.attrs["reference_uncertainty"], float(rows(f"{base}/grains{name}{unit}")[0]["h1_error"])))
        (known, error), (of_scaled, error_of_scaled) = found
        check(known < 1e-8 and of_scaled < 1e-8, f"{name}: solutions known to {known:.1e} and {of_scaled:.1e}")
        check(abs(error / error_of_scaled - 1) < 1e-3, f"{name}: the same error, {error:.4e} and {error_of_scaled:.4e}")


def energies_that_cancel(base):
    """An energy at the start of which rounding is all that is left is none that errors are shares of."""
    with open(f"{base}/cancel.yaml", "w", encoding="ascii") as file:
        file.write(FALL.replace("0.85", "-0.15").replace("0.5]]", "-0.5]]"))
    for v in ("1.7155174146594953", "1.7155174146594951"):
        study(1, f"{base}/cancel.yaml", "--h", "1/1024", "--steppers", "vti2", "--set", f"bodies.v=[{v}, 0, 0]",
              folder=f"{base}/cancel{v}")
        error = float(rows(f"{base}/cancel{v}")[0]["e_error"])
        check(error < 0.1, f"v = {v}: an energy error of {error:.1e}")


with tempfile.TemporaryDirectory() as base:
    full = study(2, "--steppers", "vti1,vti2,vti3,vti3-leapfrog", folder=f"{base}/full")
    check(full.returncode == 0 and "vti-study:" not in full.stderr, f"the default study runs {full.stderr}")
    paper_numbers(f"{base}/full")
    orders(f"{base}/full", "t = 10")
    as_in_pictures(full.stdout, f"{base}/full")
    study(2, "--steppers", "vti1,vti2,vti3,vti3-leapfrog", "--t-end", "100", folder=f"{base}/hundred")
    orders(f"{base}/hundred", "t = 100")
    same_bytes(base)
    same_bytes_with_walls(base)
    not_whole(base)
    refused(base)
    without_orders(base)
    stiff_energies(base)
    from_tables(base)
    unheard(base)
    at_rest(base)
    far_from_the_origin(base)
    rivals(base)
    general_inertia(base)
    failed_runs(base)
    keeps_what_was_there(base)
    known_as_well(base)
    when_compared(base)
    in_other_units(base)
    energies_that_cancel(base)
conclude()
