# SPDX-License-Identifier: BSD-3-Clause
"""vti-advise: what it promises holds in the run that follows, measured by vti-study --cost against GSL's solution, on
six scenes of which two have contacts; that it always answers, for no more than it may take, and errors lie in the
intervals that it tells; its JSON; what it refuses.

usage: test_advise.py VTI_ADVISE VTI_STUDY VTI_RUN MPIRUN SCENES"""
import csv
import json
import math
import os
import re
import sys
import tempfile
import time

import h5py

from programs import ENVIRONMENT, run
from tally import check, conclude

KEYS = ["stepper", "h", "predicted_error", "predicted_seconds", "predicted_force_evals", "source", "interval", "errors",
        "stable_h", "h_max_omega", "measure", "trajectories_until", "pilots", "alternatives"]
MEASURES = ["attitude", "position", "velocity", "energy"]
# with so long, all pilots go over the whole time
LONG = ["--budget", "600"]

advise, study, runner, mpirun, scenes = sys.argv[1:6]
# ours, as vti-run lists them: all to the first rival
STEPPERS = [line.split("\t")[0] for line in run(runner, "--list", "steppers").stdout.split("\nquat-euler\t")[0].splitlines()]

# scene, end, error; the walls of the last two are met on the way
CASES = [("pendulum", 10, 1e-4), ("pendulum", 100, 1e-6), ("spin", 10, 1e-5), ("chain", 10, 1e-5), ("block", 4, 1e-3),
         ("pile", 0.25, 1e-3)]


def scene(name):
    return os.path.join(scenes, name + ".yaml")


def follow(name, t_end, stepper, h):
    """The row of cost.csv of the run that was advised."""
    with tempfile.TemporaryDirectory() as folder:
        done = run(mpirun, "-n", "1", study, "--cost", "--no-plot", "--steppers", stepper, "--h", repr(h), "--t-end",
                   str(t_end), "-o", folder, scene(name))
        assert done.returncode == 0, done.stderr
        with open(os.path.join(folder, "cost.csv"), encoding="ascii", newline="") as file:
            rows = list(csv.DictReader(file))
    assert len(rows) == 1
    return rows[0]


def energy_error(name, t_end, stepper, h):
    """The largest |E - E_0|/|E_0| of all steps."""
    with tempfile.TemporaryDirectory() as folder:
        done = run(runner, scene(name), "--stepper", stepper, "--h", repr(h), "--t-end", str(t_end), "--record", "1",
                   "-o", os.path.join(folder, "run.h5"))
        assert done.returncode in (0, 3), done.stderr
        with open(os.path.join(folder, "run.csv"), encoding="ascii", newline="") as file:
            total = [float(row["total"]) for row in csv.DictReader(file)]
    return max(abs(e - total[0]) for e in total) / (abs(total[0]) or 1.0)


def longer_steps_miss(name, t_end, error, advice):
    """Whether an error far below what was asked for has a reason: as many steps less as pilots go by miss it, or are
    more than nine tenths of what is stable, or fewer than four."""
    steps = round(t_end / advice["h"])
    fewer = steps - (32 if steps > 128 else 2)
    if fewer < 4:
        return True
    coarser = json.loads(run(advise, "--json", *LONG, "--error", "0.1", "--steppers", advice["stepper"], "--t-end",
                             str(t_end), scene(name)).stdout)
    return (coarser["h"] < t_end / fewer and coarser["predicted_error"] < 0.03
            or float(follow(name, t_end, advice["stepper"], t_end / fewer)["attitude_error"]) > error)


def promise(name, t_end, error, stepper=None):
    """Advice on a scene, by one stepper or all, and whether it holds."""
    of = ["--steppers", stepper] if stepper else []
    done = run(advise, "--json", *LONG, *of, "--error", repr(error), "--t-end", str(t_end), scene(name))
    what = f"{name} to {t_end}, {error:g}{' by ' + stepper if stepper else ''}"
    check(done.returncode == 0, what + ": advice is given " + done.stderr.strip())
    if done.returncode != 0:
        return
    advice = json.loads(done.stdout)
    check(list(advice) == KEYS, what + ": the keys of the JSON")
    others = advice["alternatives"]
    check(sorted([advice["stepper"]] + [o["stepper"] for o in others]) == sorted([stepper] if stepper else STEPPERS),
          what + ": all steppers are there")
    check(all(advice["predicted_seconds"] <= 1.1 * o["predicted_seconds"] for o in others if o["predicted_seconds"] is not None),
          what + ": none of the others is faster by more than a tie")
    row = follow(name, t_end, advice["stepper"], advice["h"])
    turns = name != "pile"
    found = float(row["attitude_error" if turns else "velocity_error"])
    seconds = float(row["seconds"])
    print(f"        {advice['stepper']} h = {advice['h']:.4g}: error {found:.2e}, predicted {advice['predicted_error']:.2e}; "
          f"time {seconds:.2e} s, predicted {advice['predicted_seconds']:.2e} s")
    check(found <= 1.5 * error, what + ": the error is not above 1.5 times the one asked for")
    check(found >= error / 3 or longer_steps_miss(name, t_end, error, advice),
          what + ": nor below a third of it, unless longer steps miss it or are not stable")
    check(advice["source"] == "measured" and advice["interval"][0] <= found <= advice["interval"][1],
          what + ": it is as predicted")
    true_energy = energy_error(name, t_end, advice["stepper"], advice["h"])
    for measure, told in advice["errors"].items():
        true = true_energy if measure == "energy" else float(row[measure + "_error"])
        check(told is None or told / 1.5 <= true <= 1.5 * told + 1e-12,
              f"{what}: its {measure} errs by {told} and {true}")
    check(list(advice["errors"]) == MEASURES, what + ": all measures are told")


def what_others_need(name, t_end, error, stepper):
    """An alternative that was followed from coarser runs is not far off either."""
    done = run(advise, "--json", *LONG, "--error", repr(error), "--t-end", str(t_end), scene(name))
    offer = [o for o in json.loads(done.stdout)["alternatives"] if o["stepper"] == stepper][0]
    found = float(follow(name, t_end, stepper, offer["h"])["attitude_error"])
    check(error / 3 <= found <= 1.5 * error, f"{name}: {stepper} at the h it is said to need errs by {found:.1e}")


def refuses(what, *arguments, says):
    done = run(advise, *arguments)
    line = done.stderr.strip()
    check(done.returncode == 1 and done.stdout == "" and line.count("\n") == 0 and line.startswith("vti-advise: ")
          and says in line, f"{what}: {line}")


def words():
    done = run(advise, *LONG, "--error", "1e-3", "--t-end", "4", scene("block"))
    check(done.returncode == 0 and "not smooth enough for high order" in done.stdout, "block: warned of kinks")
    done = run(advise, "--error", "1e-3", scene("chain"))
    check(done.returncode == 0 and "warning: the forces" not in done.stdout, "chain: not warned of kinks")
    check(" at rest: " in done.stdout and "set by bond 1 of bodies 1 and 2" in done.stdout, "chain: the stable step is told")
    for stepper in ("an7", "exact"):
        done = run(advise, "--error", "1e-3", "--steppers", stepper, "--t-end", "1", scene("chain"))
        check(done.returncode == 0 and ("energy drifts" in done.stdout) == (stepper == "an7"), f"{stepper}: what it does not keep")
    done = run(advise, "--error", "1e-3", "--steppers", "vti2,exact", scene("spin"))
    check("no limit (nothing is in contact or bonded)" in done.stdout
          and "srkn11" not in done.stdout.split("stepper")[1], "spin: only these steppers")


def sentence():
    """The sentence says what the first row of its table says: stepper, h, error, whence that is, and within which
    factor. A quicker machine is told by longer pilots."""
    row = re.compile(r"  (\S+) +(\S+) +\d+ +\d+ +\S+ (?:s |ms|us)? +(\S+) .*?(?: ([\d.e+-]+)x)? +(\(from .*\))?$")
    for arguments in (("--t-end", "1e4", "--budget", "0.5", scene("pendulum")), ("--t-end", "1e5", "--budget", "0.2", scene("pendulum")),
                      ("--t-end", "10", scene("pendulum")), ("--t-end", "8", "--budget", "0.001", "--error", "1e-8", scene("block"))):
        text = run(advise, *arguments).stdout
        said, table = text.split("\n\n")[:2]
        stepper, h, error, within, whence = row.match(table.splitlines()[1]).groups()
        between = re.search(r"it lies between (\S+) and (\S+), told from ", said)
        told = re.search(r": (\S+) at h = (\S+) (?:reaches an error of the attitude of (\S+) (or so )?\(asked for: |is stable; nothing is known)", said)
        good = told is not None and told[1] == stepper and math.isclose(float(told[2]), float(h), rel_tol=1e-3)
        if whence == "(from the stable step alone)":
            good = good and told[3] is None and error == "-" and "the budget is spent" in said
            good = good and 0.4 < float(re.findall("; h is ([0-9.]+) of it", text)[-1]) <= 0.46
        else:
            good = good and told[3] == error and (whence is not None) == (told[4] is not None) == ("told from the first part" in said)
            good = good and (whence is not None and within is None) == ("nothing is known of how far off" in said)
            good = good and (within is None) == (between is None)
        if between is not None:
            good = good and float(between[1]) < float(error) and math.isclose(float(between[2]), float(error) * float(within), rel_tol=0.1)
        check(good, f"{' '.join(arguments[:-1])}: {said} -- {table.splitlines()[1].strip()}")


def h_max_omega():
    """Of a free spin it is known: |Omega| = 1."""
    advice = json.loads(run(advise, "--json", "--error", "1e-5", scene("spin")).stdout)
    check(math.isclose(advice["h_max_omega"], advice["h"], rel_tol=1e-12), "spin: h max|Omega| = h")
    check(advice["stable_h"] is None, "spin: no stable step is null")


def h_max_omega_of_the_solution():
    """Two bodies on a spring that hardly turn, |Omega| = 1e-3 at first: what blew up among the pilots has no say."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in (("bodies.csv", "x,y,z,vx,vy,vz,omega_x,omega_y,omega_z,mass,inertia\n0,0,0,0.25,0,0,0,1e-3,0,1,0.1\n"
                            "1,0,0,-0.25,0,0,0,1e-3,0,1,0.1\n"), ("bonds.csv", "i,j\n0,1\n"),
                           ("two.yaml", "name: two\nbodies: {table: bodies.csv}\nbinder: {table: bonds.csv, axial: 1, "
                            "shear: {stiffness: 100}}\nstepper: vti2\nh: 1/64\nt_end: 20\n")):
            with open(os.path.join(folder, name), "w", encoding="ascii") as file:
                file.write(text)
        done = run(advise, "--json", "--error", "1e-3", os.path.join(folder, "two.yaml"))
        advice = json.loads(done.stdout)
        turn = advice["h_max_omega"] / advice["h"]
        check(0.99e-3 < turn < 2e-3, f"two bodies: max|Omega| is {turn:.3g}")
        check("radians per step" not in done.stderr, "... of which nobody is warned: " + done.stderr.strip())


def known_to_its_share():
    """The solution is known to 3 % of the error asked for: at these errors a laxer bound is met by a coarser run. The
    page prints one digit."""
    for name, t_end, error in (("pile", 0.25, 1e-4), ("chain", 10, 3e-8), ("pendulum", 10, 1e-8)):
        said = run(advise, *LONG, "--error", repr(error), "--steppers", "srkn11", "--t-end", str(t_end),
                   scene(name)).stdout
        known = float((said.split("the solution is known to ") + ["nan"])[1].split()[0])
        check(0 <= known <= 1.2 * 0.03 * error, f"{name}: asked for {error:g}, the solution is known to {known:g}")


def far_below():
    """Where forces have kinks an error far below the one asked for may be the solution's own, known to less than its
    last halving tells: the true one lies in the interval all the same."""
    done = run(advise, "--json", *LONG, "--error", "0.01", "--steppers", "an9", "--t-end", "0.75", scene("block"))
    advice = json.loads(done.stdout)
    found, (least, most) = float(follow("block", 0.75, "an9", advice["h"])["attitude_error"]), advice["interval"]
    check(advice["predicted_error"] < 1e-3 * 0.01 and least <= found <= most,
          f"block, far below 0.01: {found:.3g} lies between {least:.3g} and {most:.3g}")
    # and what halvings say of a smooth one is an estimate: three bodies, of whose solution it was 1.26e-9, and 1.40e-9
    # true
    with tempfile.TemporaryDirectory() as folder:
        with open(f"{folder}/three.yaml", "w", encoding="ascii") as file:
            file.write("name: three\nbodies: {chain: {count: 3, spacing: 1}, mass: 1, diameter: 1, random: {seed: 6, v: 0.5, omega: 0.5}}\n"
                       "binder: {moment: 5, axial: 60, shear: {stiffness: 30}}\nh: 1/1024\nt_end: 2\n")
        for stepper in ("an10-mid", "an10-fine"):
            asked = ("--error", "1e-3", "--steppers", stepper, f"{folder}/three.yaml")
            advice = json.loads(run(advise, "--json", *asked).stdout)
            found, (least, most) = float(follow(f"{folder}/three", 2, stepper, advice["h"])["attitude_error"]), advice["interval"]
            check(least <= found <= most < 1e-8, f"{stepper}, far below 1e-3: {found:.3g} lies between {least:.3g} and {most:.3g}")
            words = run(advise, *asked).stdout
            check(f"of the attitude of at most {most:.1e}" in words and f"the error is at most {most:.1e}" in words,
                  f"... and words say so: {words}")


def unkicked():
    """Two bodies that fly into each other: where nothing pushes at the start vti3 has the places of vti2, and is
    offered by the same step. By its own order 1 it was offered by a ninetieth of that; and while the search went by
    seconds, which differ from run to run, one of the two was measured and the other, as too dear, followed to half that
    step."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in (("bodies.csv", "mass,inertia,diameter,x,y,z,vx,vy,vz,alpha_x,alpha_y,alpha_z,omega_x,omega_y,omega_z\n"
                            "1,.1,1,0,0,0,.5,0,0,0,0,0,0,0,0\n1,.1,1,1.2,.1,0,-.5,0,0,0,0,0,0,0,0\n"),
                           ("two.yaml", "name: two\nbodies: {table: bodies.csv}\ncontact: {stiffness: 500}\nh: 0.01\nt_end: 0.75\n")):
            with open(os.path.join(folder, name), "w", encoding="ascii") as file:
                file.write(text)
        advice = json.loads(run(advise, "--json", "--measure", "position", "--error", "1e-5", "--steppers", "srkn6,vti2,vti3",
                                os.path.join(folder, "two.yaml")).stdout)
        told = {offer["stepper"]: offer for offer in [advice] + advice["alternatives"]}
        h, (least, most) = told["vti3"]["h"], told["vti3"]["interval"]
        check(0.9 < h / told["vti2"]["h"] < 1.1, f"unkicked: vti3 at h = {h:.3g}, vti2 at {told['vti2']['h']:.3g}")
        found = float(follow(f"{folder}/two", 0.75, "vti3", h)["position_error"])
        check(least <= found <= most, f"... errs by {found:.2g}, in {least:.2g} to {most:.2g}")


def told_again(name, t_end, error):
    advice = json.loads(run(advise, "--json", "--error", repr(error), "--t-end", str(t_end), scene(name)).stdout)
    told = {o["stepper"]: [o["h"], o["predicted_error"], o["source"]] for o in [advice] + advice["alternatives"]}
    return told | {"pilots": advice["pilots"]["force_evals"]}


def reproducible():
    """Whatever else the machine does, the same pilots are made, and every stepper is offered by the same step."""
    for case in (("chain", 10, 1e-5), ("pair", 100, 1e-4), ("pile", 0.25, 1e-3), ("pendulum", 1000, 1e-4)):
        first = told_again(*case)
        others = [told_again(*case) for _ in range(3)]
        differ = sorted(key for key in first if any(other[key] != first[key] for other in others))
        check(not differ, f"{case[0]} to {case[1]}, {case[2]:g}: told again alike {differ or ''}")


def rivals():
    """They are measured if they are named, and never advised."""
    done = run(advise, "--json", "--error", "1e-3", "--steppers", "rk4,vti2,lammps-richardson", scene("pendulum"))
    advice = json.loads(done.stdout)
    others = {other["stepper"]: other for other in advice["alternatives"]}
    check(advice["stepper"] == "vti2" and set(others) == {"rk4", "lammps-richardson"} and
          all(other.get("kind") == "rival" and 1e-4 < other["predicted_error"] < 1e-3 for other in others.values()),
          f"rivals beside ours: {done.stdout.strip()}")


def always():
    """An answer, whatever the budget, by no more than the evaluations that it stands for: 4e6 of a body, or as many as
    the predicted run takes where forces have kinks, 0.3 of it elsewhere, and a part of the run that shows what that
    is."""
    for name, t_end, error, bodies in (("torus", 35, 1e-3, 80), ("pile", 10, 1e-3, 128), ("block", 4, 1e-4, 96),
                                       ("chain", 10, 1e-5, 10)):
        done = run(advise, "--json", "--error", repr(error), "--t-end", str(t_end), scene(name))
        check(done.returncode == 0, f"{name}: always an answer {done.stderr.strip()}")
        advice = json.loads(done.stdout or "{}")
        share = 0.3 if name == "chain" else 1.0
        check("kinks" in done.stderr or share < 1.0, f"{name}: what pilots take is said before")
        may = max(4e6, share * bodies * t_end / advice["h"] * 3)      # of up to three evaluations a step
        least = 4 * bodies * t_end / (0.9 * 0.5 * 2 * (advice["stable_h"] or 1e-3))
        took = bodies * advice["pilots"]["force_evals"]
        check(took <= 1.1 * max(may, least), f"{name}: by {took:.3g} evaluations of a body of {may:.3g}")
        check(advice["predicted_error"] <= error
              and advice["interval"][0] < advice["predicted_error"] < advice["interval"][1],
              f"{name}: {advice['predicted_error']:.2g} in {advice['interval']}")
        parted = name in ("torus", "pile")
        check((advice["measure"] == "energy") == parted and (advice["trajectories_until"] is not None) == parted,
              f"{name}: trajectories that part, and only these, are advised on by energy")
        row = follow(name, t_end, advice["stepper"], advice["h"]) if not parted else None
        found = float(row["attitude_error"]) if row else None
        check(not row or advice["interval"][0] <= found <= advice["interval"][1],
              f"{name}: {found} is in {advice['interval']}")
    done = run(advise, "--json", "--error", "1e-6", "--budget", "1e-9", scene("block"))
    advice = json.loads(done.stdout)
    check(done.returncode == 0 and advice["source"] == "stability" and advice["predicted_error"] is None
          and advice["stepper"] == "exact" and advice["pilots"]["force_evals"] == 0, f"an answer for nothing: {done.stdout[:100]}")
    check("no pilot had time for a step" in done.stderr, f"... which is said: {done.stderr.strip()}")
    text = run(advise, "--budget", "1e-9", "--steppers", "an4,abm8", scene("pendulum")).stdout
    rows = {row.split()[0]: row.split() for row in text.splitlines() if row.startswith("  a")}
    check(rows["an4"][2] == rows["an4"][3] and rows["abm8"][3] == "-", f"... of one evaluation a step, or who knows how many: {rows}")


def near_rounding():
    """Of a short part of the time the error that leads to one of 1e-12 is lost in rounding."""
    for name, t_end, error, only in (("chain", 100, 1e-12, []), ("pair", 1000, 1e-11, ["--steppers", "an7,an4"])):
        advice = json.loads(run(advise, "--json", "--error", repr(error), "--t-end", str(t_end), *only, scene(name)).stdout)
        check(advice["source"] == "shorter" and 0.5 * error < advice["predicted_error"] < error,
              f"{name} to {error:g}: {advice['predicted_error']} ({advice['source']})")
        if name == "chain":
            found, (low, high) = float(follow(name, t_end, advice["stepper"], advice["h"])["attitude_error"]), advice["interval"]
            check(low < found < high, f"... {found:.2g} is in {low:.2g} ... {high:.2g}")


def budget_is_hard():
    """Where one stepper needs a hundredth of the evaluations of another, what the latter needs is no measure of what
    pilots may take: 4e6 of a body, or as many as the run that is advised on at last."""
    for name, t_end, error, bodies in (("pile", 0.5, 1e-6, 128), ("block", 8, 1e-8, 96), ("torus", 2, 1e-6, 80)):
        advice = json.loads(run(advise, "--json", "--error", repr(error), "--t-end", str(t_end), scene(name)).stdout)
        took, may = bodies * advice["pilots"]["force_evals"], max(4e6, bodies * advice["predicted_force_evals"])
        check(took <= 1.1 * may, f"{name} to {t_end}, {error:g}: pilots took {took:.3g} evaluations of {may:.3g}")
        exact = [o for o in advice["alternatives"] if o["stepper"] == "exact"][0]
        check(advice["stepper"].startswith("an") and advice["predicted_force_evals"] < 0.3 * (exact["predicted_force_evals"] or math.inf),
              f"... and have found {advice['stepper']}, which needs {advice['predicted_force_evals']} evaluations, not "
              f"{exact['predicted_force_evals']}")
        low, high = advice["interval"]
        check(low < advice["predicted_error"] < high < 100 * error, "... with an interval")
        # errors of torus were followed to 3.6 times the steps: order 8 between touches all the way would be 1e6
        check(high < 3e5 * low, f"... that tells something: {low:.1e} ... {high:.1e}")


def cut_short():
    """Where the purse is too small for a run that errs by so little, the runs that were made are followed, within that purse, and the
    interval is the wider the further: steppers of order 1 and 2 at errors that need a million steps and more."""
    for name, steppers, error, bodies, source, runs in (("pendulum", "vti3", 3e-6, 1, "followed", True), ("pendulum", "vti3", 1e-8, 1, "followed", False),
                                                        ("chain", "vti2,exact", 1e-8, 10, "shorter", True),
                                                        ("pair", "vti2,exact", 1e-8, 2, "shorter", False), ("pair", "vti2", 1e-8, 2, "shorter", False)):
        done = run(advise, "--json", "--error", repr(error), "--steppers", steppers, scene(name))
        told = json.loads(done.stdout)
        what, (low, high) = f"{name} by {steppers} to {error:g}, cut short", told["interval"]
        check(told["source"] == source and 0.5 * error < told["predicted_error"] < error, f"{what}: {done.stdout[:200]}")
        check(low is not None and high is not None and 10 * low < high, f"{what}: {told['interval']} is as wide as followed errors are")
        check(all(o["predicted_error"] is not None for o in told["alternatives"]), f"{what}: the others are told too")
        # a step of a pilot counts for two evaluations; of few bodies a look takes as long as eight
        took = told["pilots"]["force_evals"]
        check(2 * took * bodies <= 1.1 * 4e6, f"{what}: pilots took {took:g} evaluations")
        if runs:
            found = float(follow(name, 10, told["stepper"], told["h"])["attitude_error"])
            check(low <= found <= high, f"... and errs by {found:.2g}, in {low:.2g} to {high:.2g}")
        if name == "pendulum":
            check(math.isclose(told["h"] * 0.238, told["predicted_error"], rel_tol=0.02), f"{what}: the error is 0.238 h, h = {told['h']:.3g}")
        if name == "pair":  # vti2 and exact err by 1.2e3 h^2 or so; a first run alone would say a step 6 times as long
            check(2e-6 < told["h"] < 3e-6, f"{what}: {told['stepper']} at h = {told['h']:.3g}")


def speaks():
    """What is being tried, as a line now and then where there is no terminal."""
    for log, says in (("1e-9", True), ("0", False)):
        done = run(advise, "--error", "1e-3", scene("chain"), env=dict(ENVIRONMENT, VTI_LOG=log))
        check(("vti-advise: trying srkn11 in " in done.stderr) == says, f"VTI_LOG={log}: {done.stderr[:100]!r}")
    check("VTI_LOG: 'soon' is no number" in run(advise, scene("pendulum"), env=dict(ENVIRONMENT, VTI_LOG="soon")).stderr, "VTI_LOG=soon is refused")


def parted_early():
    """Where two runs part early the finer one is not flown to its end. What the coarser one tells of the energy is
    true."""
    advice = json.loads(run(advise, "--json", "--error", "1e-2", "--t-end", "35", scene("torus")).stdout)
    took = 80 * advice["pilots"]["force_evals"]
    check(took <= max(4e6, 80 * advice["predicted_force_evals"]), f"torus to 35: pilots took {took:.3g} evaluations")
    check(advice["measure"] == "energy" and 0 < advice["trajectories_until"] < 35,
          f"... and saw trajectories part at {advice['trajectories_until']}")
    found, (low, high) = energy_error("torus", 35, advice["stepper"], advice["h"]), advice["interval"]
    check(low <= found <= high < 1e3 * low, f"... {found:.2g} is in {low:.2g} ... {high:.2g}")


def rolls():
    """A bead that rolls down a slope from rest turns by 840 rad/s at the end, a regular motion: runs in which it turns
    by some radians a step are too coarse to tell, and no proof that trajectories part. Its true attitude: four times as
    many steps."""
    of = scene("incline")
    for more in ([], ["--measure", "position"], ["--budget", "10"], ["--t-end", "3"]):
        done = run(advise, "--json", *more, of)
        told = json.loads(done.stdout)
        wanted = "position" if "position" in more else "attitude"
        check(told["measure"] == wanted and told["trajectories_until"] is None and "part at" not in done.stderr
              and told["predicted_error"] <= 1e-4, f"incline {more}: {told['predicted_error']} of the {told['measure']}, "
              f"until {told['trajectories_until']}")
        if more == []:
            with tempfile.TemporaryDirectory() as folder:
                run(mpirun, "-n", "1", study, of, "--steppers", told["stepper"], "--h", repr(told["h"]), "--no-plot", "-o", folder)
                with open(os.path.join(folder, "study.csv"), encoding="ascii", newline="") as file:
                    found = float(next(csv.DictReader(file))["attitude_error"])
            check(told["interval"][0] <= found <= told["interval"][1], f"... and errs by {found:.2g}, in {told['interval']}")
    # 20 times as long: 16800 rad/s, for which the purse is too small, and a run that has left the slope is no solution
    done = run(advise, "--json", "--t-end", "20", of)
    told = json.loads(done.stdout)
    check(told["measure"] == "energy" and told["trajectories_until"] < 20 and told["h"] < 1e-3,
          f"incline to 20: h = {told['h']} by the {told['measure']}")
    check("whether those of finer ones part too a larger --budget tells" in done.stderr, "... and that it may be the step's fault")


def part_again():
    """Where two runs part, finer ones tell whether all do, as far as what they may take allows: ten beads roll side by
    side, by vti2, whose turn of h |Omega| misses (h |Omega|)^2/12 of it, and of which the first two runs differ by 0.6.
    The bodies of a pile do part."""
    with tempfile.TemporaryDirectory() as folder, open(scene("incline"), encoding="utf-8") as one:
        path = os.path.join(folder, "beads.yaml")
        rest = one.read().split("inertia:")[1].split("\n", 1)[1]
        with open(path, "w", encoding="utf-8") as file:
            file.write("name: beads\nbodies: {lattice: {counts: [1, 10, 1], spacing: 0.02, corner: [0.003, 0, 0.004]}, "
                       "diameter: 0.01, mass: 1.309e-3, inertia: 1.309e-8}\n" + rest)
        done = run(advise, "--json", "--steppers", "vti2", "--t-end", "1.3", path)
    told = json.loads(done.stdout or "{}")
    check(done.returncode == 0 and told["measure"] == "attitude" and told["trajectories_until"] is None,
          f"ten beads: {told.get('measure')}, {done.stderr.strip()}")
    for t_end, sure in ((10, True), (3, False)):
        done = run(advise, "--json", "--error", "1e-3", "--t-end", str(t_end), scene("pile"))
        check("part at" in done.stderr and ("a larger --budget tells" in done.stderr) != sure,
              f"pile to {t_end}: {done.stderr.strip()}")


TWIST = """name: twist
bodies: {x: [0, 0, 9.5], diameter: 1, mass: 1, inertia: 0.1, v: [0.3, 0, -1], alpha: [0, 0, 0], omega: [0, 0, 11]}
wall: {stiffness: 1.0e+5, planes: [[0, 0, 1, 0]]}
drag: {angular: 1.0e-9}
h: 1/1024
t_end: 900
"""


def part_and_agree():
    """A body that spins by w: vti2 misses T w (h w)^2/12 of the angle. The first two runs part, early by 11 and in the end by 8.2, and
    twice as many steps agree: they are flown over the whole time, and what they tell is true."""
    with tempfile.TemporaryDirectory() as folder:
        for omega in 11, 8.2:
            with open(f"{folder}/twist.yaml", "w", encoding="ascii") as file:
                file.write(TWIST.replace("11]", f"{omega}]"))
            done = run(advise, "--json", "--error", "1e-3", "--steppers", "vti2", f"{folder}/twist.yaml")
            told = json.loads(done.stdout)
            found = 900 * omega * (told["h"] * omega) ** 2 / 12
            check(told["measure"] == "attitude" and told["trajectories_until"] is None and "part at" not in done.stderr and
                  abs(found / (told["predicted_error"] or math.nan) - 1) < 0.01,
                  f"a spin of {omega}: by the {told['measure']} {told['predicted_error']}, {found:.4g}")


def too_coarse_beside():
    """Of a ball that bounces the runs of exact agree, and those of an7, which are as coarse as they may be, part: no reason to go by the
    energy, only none to offer an7."""
    with tempfile.TemporaryDirectory() as folder:
        with open(f"{folder}/bounce.yaml", "w", encoding="ascii") as file:
            file.write("name: bounce\nbodies: {x: [0, 0, 2], diameter: 1, mass: 1, v: [0.3, 0, 0]}\ngravity: [0, 0, -1]\n"
                       "wall: {stiffness: 8.1e+8, planes: [[0, 0, 1, 0]]}\nh: 1/1024\nt_end: 10\n")
        told = json.loads(run(advise, "--json", "--error", "1e-4", "--steppers", "exact,an7", f"{folder}/bounce.yaml").stdout)
        found, (low, high) = float(follow(f"{folder}/bounce", 10, "exact", told["h"])["velocity_error"]), told["interval"]
    check(told["stepper"] == "exact" and told["measure"] == "velocity" and told["trajectories_until"] is None and low <= found <= high,
          f"bounce: {told['stepper']} by the {told['measure']}, {found:.2g} in {low:.2g} ... {high:.2g}")
    check([(o["stepper"], o["h"]) for o in told["alternatives"]] == [("an7", None)], f"... alone: {told['alternatives']}")


def between_touches():
    """Two runs of a multistep method do not tell by what order its errors fall between touches; and an error far below
    what was asked for may be the solution's: the interval says so. None of them is so wide that nothing is told."""
    meet = """name: meet
bodies: {lattice: {counts: [2, 2, 2], spacing: 1.0625, corner: [0, 0, 0]}, diameter: 1, mass: 1, random: {seed: 4, v: 0.5}}
contact: {stiffness: 1000}
gravity: [0, 0, -1]
wall: {stiffness: 1000, planes: [[0, 0, 1, -0.75]]}
h: 1/512
t_end: 2
"""
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "meet.yaml"), "w", encoding="ascii") as file:
            file.write(meet)
        for name, t_end, error, stepper, far in (("block", 4, 1e-8, "an7", 1e5), ("torus", 1, 1e-6, "an7", 50),
                                                 (f"{folder}/meet", 2, 1e-6, "an10-mid", 200)):
            advice = json.loads(run(advise, "--json", "--error", repr(error), "--steppers", stepper, "--t-end", str(t_end),
                                    scene(name)).stdout)
            found = float(follow(name, t_end, stepper, advice["h"])[advice["measure"] + "_error"])
            low, high = advice["interval"]
            check(advice["source"] == "followed" and low <= found <= high < 1e-4,
                  f"{stepper} on {name}: {found:.1e} is in {low:.1e} ... {high:.1e}")
            check(advice["predicted_error"] <= error and error / far < found, "... and the step is not far finer than it has to be")


def lucky_halving():
    """Of spheres that meet one halving showed order 4.8: what is left is told by the order that kinks leave."""
    with tempfile.TemporaryDirectory() as folder:
        with open(f"{folder}/gas.yaml", "w", encoding="ascii") as file:
            file.write("name: gas\nbodies: {lattice: {counts: [2,2,2], spacing: 1.3}, diameter: 1, mass: 1, random: {seed: 4, v: 2}}\n"
                       "contact: {stiffness: 4206.784023988164}\nh: 1e-3\nt_end: 1\n")
        advice = json.loads(run(advise, "--json", "--error", "1e-5", "--measure", "velocity", "--budget", "30", "--steppers", "an7",
                                f"{folder}/gas.yaml").stdout)
        found, (low, high) = float(follow(f"{folder}/gas", 1, "an7", advice["h"])["velocity_error"]), advice["interval"]
        check(advice["source"] == "measured" and low <= found <= high, f"gas: {found:.2e} is in {low:.2e} ... {high:.2e}")


def measures():
    """The error of any of them can be asked for."""
    for measure in MEASURES:
        advice = json.loads(run(advise, "--json", *LONG, "--error", "1e-4", "--measure", measure, "--t-end", "2",
                                scene("chain")).stdout)
        found = float(follow("chain", 2, advice["stepper"], advice["h"])[measure + "_error"])
        check(advice["measure"] == measure and advice["predicted_error"] == advice["errors"][measure]
              and found <= 1.5e-4 and advice["predicted_error"] / 1.3 <= found <= 1.3 * advice["predicted_error"],
              f"by {measure}: {found:.2e}")


def only_slowed():
    """Velocities that a medium alone slows are exact by any step, and ways are not: 0.00337 for 0.05 at h = 0.5, and
    advice was 1.25 by an error of 1e-14 of the velocity."""
    with tempfile.TemporaryDirectory() as folder:
        for drag, measure, true in (("linear: 20", "position", 0.05), ("quadratic: 20, angular: 0.1", "position", math.log(101) / 20),
                                    ("angular: 20", "attitude", 0.05)):
            with open(f"{folder}/slowed.yaml", "w", encoding="ascii") as file:
                file.write("bodies: {x: [0, 0, 0], v: [1, 0, 0], alpha: [0, 0, 0], omega: [1, 0, 0], mass: 1, inertia: 1}\n"
                           f"drag: {{{drag}}}\nh: 0.5\nt_end: 5\n")
            advice = json.loads(run(advise, "--json", "--error", "1e-4", f"{folder}/slowed.yaml").stdout)
            run(runner, f"{folder}/slowed.yaml", "--stepper", advice["stepper"], "--h", repr(advice["h"]), "--force", "-o",
                f"{folder}/out.h5")
            with h5py.File(f"{folder}/out.h5") as file:
                w, x = file["VTKHDF/PointData/attitude_wxyz"][-1][:2]
                found = abs((2 * math.atan2(x, w) if measure == "attitude" else file["VTKHDF/Points"][-1][0]) - true)
            check(advice["measure"] == measure and advice["h"] < 0.05 and found <= 1.5e-4,
                  f"{drag}: by {advice['measure']} h = {advice['h']:.3g}, which errs by {found:.2g}")


def others_by_energy():
    """Where the energy is asked for the solution is hardly refined: what other measures err by is told only where it is
    known. Of two bodies in a box it was told as 7e-6, and is 1e-10."""
    with tempfile.TemporaryDirectory() as folder:
        with open(f"{folder}/box.yaml", "w", encoding="ascii") as file:
            file.write("name: box\nbodies: {lattice: {counts: [2,1,1], spacing: 1.5}, diameter: 1, mass: 1, random: {seed: 2, v: 1}}\n"
                       "contact: {stiffness: 800}\nwall: {stiffness: 900, planes: [[1,0,0,-0.8],[-1,0,0,-2.4],[0,1,0,-0.7],"
                       "[0,-1,0,-0.7],[0,0,1,-0.7],[0,0,-1,-0.7]]}\nh: 0.005\nt_end: 2\n")
        for error, tells in ((1e-7, False), (1e-2, True)):
            advice = json.loads(run(advise, "--json", "--error", repr(error), "--measure", "energy", f"{folder}/box.yaml").stdout)
            row = follow(f"{folder}/box", 2, advice["stepper"], advice["h"])
            for measure in ("position", "velocity"):
                told, true = advice["errors"][measure], float(row[measure + "_error"])
                check(told is None or told / 1.5 <= true <= 1.5 * told,
                      f"box, energy to {error:g}: its {measure} errs by {told} and {true:.2g}")
                check(told is not None or not tells, "... and is told where it can be")


def damped():
    """What oscillates and is damped errs most within its first swing: the energy's error is that of the worst
    step, or nearly."""
    with tempfile.TemporaryDirectory() as folder:
        for path, text in (("swing.csv", "x,y,z,vx,vy,vz\n0,0,0,0,0,0\n1,0,0,1,0,0\n"), ("bond.csv", "i,j\n0,1\n"),
                           ("swing.yaml", "name: swing\nbodies: {table: swing.csv, mass: 1}\nbinder: {table: bond.csv, axial: 2}\n"
                                          "bond_dashpot: {zeta: 0.8}\nh: 1/64\nt_end: 40\n")):
            with open(os.path.join(folder, path), "w", encoding="ascii") as file:
                file.write(text)
        advice = json.loads(run(advise, "--json", *LONG, "--error", "1e-2", "--measure", "energy", "--steppers", "vti2",
                                f"{folder}/swing.yaml").stdout)
        found = energy_error(f"{folder}/swing", 40, "vti2", advice["h"])
        check(abs(found / advice["predicted_error"] - 1) < 0.02,
              f"damped: the energy errs by {found:.3e}, told {advice['predicted_error']:.3e}")


def general_inertia():
    """Bodies of three moments are advised on by the steppers that can take them, and all of these."""
    for name, t_end, error in (("heavy-top", 10, 1e-5), ("dzhanibekov", 20, 1e-6)):
        advice = json.loads(run(advise, "--json", *LONG, "--error", repr(error), "--t-end", str(t_end), scene(name)).stdout)
        given = [advice["stepper"]] + [o["stepper"] for o in advice["alternatives"]]
        check(sorted(given) == sorted(s for s in STEPPERS if not s.startswith("an")), f"{name}: {given}")
        found = float(follow(name, t_end, advice["stepper"], advice["h"])["attitude_error"])
        check(found <= 1.5 * error and advice["interval"][0] <= found <= advice["interval"][1],
              f"{name}: {advice['stepper']} errs by {found:.2g}, in {advice['interval']}")


def says_why():
    """Why the error is far below what was asked for, and where h stands beside the stable step: the words fit the
    numbers. The pendulum's step to t = 1/8 is a sixteenth of the stable one, 2; the chain's is as long as can be. Of a
    ball that has met nothing in the part of the time that pilots went over the error is not known, and not said to be
    0."""
    for name, t_end, words in (("pendulum", "1/8", "fewer steps are not tried"), ("chain", "4", "stability, not the error, sets the step")):
        said = run(advise, "--error", "0.1", "--steppers", "vti2", "--t-end", t_end, scene(name)).stdout
        check(f"note: {words}" in said, f"{name} to {t_end}: {words}")
    said = run(advise, "--error", "0.1", "--steppers", "exact", "--set", "bodies.random.v=1", "--t-end", "2", scene("chain")).stdout
    found = re.search("warning: h = (\\S+) is (near|above) the stable step (\\S+):", said)
    check(found and (float(found[1]) > 1.05 * float(found[3])) == (found[2] == "above"), f"near or above: {found and found[0]}")
    with tempfile.TemporaryDirectory() as folder:
        ball = os.path.join(folder, "ball.yaml")
        with open(ball, "w", encoding="ascii") as file:
            file.write(BALL.replace("9.5", "1e7"))
        said = run(advise, "--t-end", "5000", ball).stdout
        check("nothing is known of how far off that is" in said and "the error is" not in said, f"a ball on its way: {said}")
        for place, warned in (0, True), (1, False):
            with open(ball, "w", encoding="ascii") as file:
                file.write(f"bodies: {{x: [0, 0, {place}], v: [0, 0, 0], mass: 1}}\ngravity: [0, 0, -1]\nh: 0.01\nt_end: 1\n")
            said = run(advise, "--error", "0.01", "--measure", "energy", "--steppers", "vti2", ball).stdout
            check(("the energy is 0 at the start" in said) == warned, f"from z = {place}: of an energy of 0 there are no shares")


def as_long_as_can_be():
    """To as many steps as can be counted, 2^53, and nearly as many: what is advised is stable and can be counted (the
    longest stable step of the pendulum is 3.5, of srkn14; that of exact 2), and the budget is kept."""
    for t_end in ("1e13", "4e15", "1e16"):
        begin = time.monotonic()
        done = run(advise, "--json", "--t-end", t_end, "--budget", "1", "--set", "h=1e12", scene("pendulum"))
        took = time.monotonic() - begin
        told = json.loads(done.stdout or '{"h": NaN, "alternatives": []}')
        offers = [o["h"] for o in [told] + told["alternatives"] if o["h"] is not None]
        check(done.returncode == 0 and all(h <= 3.5 / 2 and float(t_end) / h < 1.001 * 2 ** 53 for h in offers),
              f"to {t_end}: h = {offers}")
        check(took < 10, f"... by a budget of a second in {took:.2g} s")
    told = json.loads(run(advise, "--json", "--t-end", "5e15", "--budget", "1", "--set", "h=1", "--measure", "energy", "--steppers",
                          "vti2,srkn11", scene("pendulum")).stdout)
    check(told["stepper"] == "srkn11" and told["h"] > 5e15 / 2 ** 53 and [o["h"] for o in told["alternatives"]] == [None],
          f"to 5e15 vti2 reaches no error of 1e-4 in so many steps: {told['stepper']}, {told['alternatives']}")


BALL = """name: ball
bodies: {x: [0, 0, 9.5], diameter: 1, mass: 1, v: [0.3, 0, -1], alpha: [0, 0, 0], omega: [0, 0, 1]}
wall: {stiffness: 1.0e+5, planes: [[0, 0, 1, 0]]}
h: 1/1024
t_end: 20
"""


def one_touch():
    """A ball meets a wall once, which takes a thousandth of the time: the largest error of the energy is within that,
    and of two steps one may err by a hundred times less than the other. What vti-run shows at every step is in the
    interval. By default the velocity is advised on, as nothing turns the ball."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "ball.yaml")
        for measure, error, height in (("energy", 1e-2, 9.5), ("energy", 1e-4, 5.3), (None, 1e-3, 6.1), (None, 1e-4, 9.5)):
            with open(path, "w", encoding="ascii") as file:
                file.write(BALL.replace("9.5", str(height)))
            asked = ("--measure", measure) if measure else ()
            told = json.loads(run(advise, "--json", "--error", repr(error), *asked, path).stdout)
            name, h, (low, high) = told["stepper"], told["h"], told["interval"]
            check(told["measure"] == (measure or "velocity"), f"ball from {height}: by the {told['measure']}")
            ball = path.removesuffix(".yaml")
            found = energy_error(ball, 20, name, h) if measure else float(follow(ball, 20, name, h)["velocity_error"])
            check(low <= found <= high < 1e3 * error, f"{name} at h = {h:.3g}: {found:.2g} is in {low:.2g} ... {high:.2g}")


STRAYS = """name: strays
bodies: {chain: {count: 2, spacing: 1}, mass: 1, inertia: 0.1, diameter: 1, alpha: [0, 0, 0], random: {seed: 3, v: 1, omega: 8}}
binder: {moment: 5, axial: 100, shear: {stiffness: 50, form: objective}}
h: 1/256
t_end: 60
"""


def strays():
    """Two bonded bodies that spin fast: what is off by 1e-12 grows to all there is. From the first part of the time,
    which is all that the budget has room for, one would say that errors grow in proportion to time, and be off by
    1e4."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "strays.yaml")
        with open(path, "w", encoding="ascii") as file:
            file.write(STRAYS)
        done = run(advise, "--json", "--error", "1e-6", "--budget", "0.2", path)
    told = json.loads(done.stdout or "{}")
    high = told["interval"][1]
    check(told["measure"] == "energy" or high is None or high > 1e-3, f"strays: by the {told['measure']}, up to {high}")
    check(all(float(more) > 0.2 for more in re.findall(r"--budget (\S+) would do", done.stderr)),
          f"... a budget that would do is more than that: {done.stderr.strip()}")


def refusals():
    pendulum = scene("pendulum")
    refuses("rivals alone", "--steppers", "rk4,spiral", pendulum, says="name one of ours too")
    refuses("a rival of spheres", "--steppers", "vti2,gear", scene("heavy-top"), says="bodies.moments: gear knows")
    refuses("no scene", says="no scene is named")
    refuses("two scenes", pendulum, pendulum, says="only one scene")
    refuses("bad error", "--error", "tiny", pendulum, says="--error: 'tiny' is not a number from 1e-12 to 0.1")
    refuses("negative error", "--error", "-1", pendulum, says="--error: '-1'")
    refuses("error out of reach", "--error", "1e-15", pendulum, says="from 1e-12 to 0.1")
    refuses("unknown stepper", "--steppers", "rk5", pendulum, says="'rk5' is not a stepper")
    refuses("unknown option", "--frobnicate", pendulum, says="is not an option")
    refuses("missing file", "nowhere.yaml", says="nowhere.yaml")
    refuses("bad measure", "--measure", "spin", pendulum, says="--measure: 'spin' is none; take attitude")
    refuses("more steps than are counted", "--t-end", "1e17", "--budget", "1", pendulum,
            says="t_end: '1e17' is more than 2^53 steps of h = 1/64; take a larger h")
    refuses("... of the stable step", "--t-end", "1e19", "--budget", "1", "--set", "h=1e12", pendulum,
            says="pendulum: t_end: '1e+19' is more than 2^53 steps of h = 1.56")
    for name in ("srkn11-tol", "srkn6-tol"):
        refuses("steps that it chooses itself", "--steppers", f"vti2,{name}", pendulum, says=f"--steppers: {name} chooses its steps itself")
    refuses("a stepper, which is chosen", "--set", "stepper=vti2", pendulum, says="--set stepper=vti2: does nothing here; steppers are chosen; --steppers names")
    refuses("varied steps", "--set", "control=integrating", pendulum, says="pendulum: control: advice is on steps of one length")
    refuses("a tolerance", "--set", "tolerance=1e-9", pendulum, says="pendulum: tolerance: advice is on steps of one length")
    refuses("missing measure", "--measure", "position", pendulum, says="pendulum has no position; take attitude")


for case in CASES:
    promise(*case)
for near in ("srkn11", "srkn14"):   # either may be the faster by a tenth, and srkn14's error jumps there
    promise("pendulum", 100, 1e-6, near)
what_others_need("pendulum", 10, 1e-5, "vti2")
what_others_need("chain", 10, 1e-4, "exact")
words()
sentence()
h_max_omega()
def stable_step_of_the_stepper():
    """stable_h is that of the stepper that is advised, which the text has too, and no step is longer."""
    with tempfile.TemporaryDirectory() as root:
        with open(f"{root}/fall.yaml", "w", encoding="ascii") as file:
            file.write("bodies: {x: [0, 0, 0.85], v: [1.7, 0, 0], mass: 0.7, diameter: 0.1}\ngravity: [0, 0, -9.81]\n"
                       "wall: {stiffness: 1000, planes: [[0, 0, 1, 0.5]]}\nh: 1/64\nt_end: 1\n")
        for stepper, reach in (("vti2", 2), ("an9", 0.593), ("suzuki4", None)):
            done = run(advise, "--json", "--error", "1e-3", "--steppers", stepper, f"{root}/fall.yaml")
            advice = json.loads(done.stdout)
            bound = advice["stable_h"] / (reach or 1)
            first = bound if stepper == "vti2" else first
            check(advice["h"] <= 0.9001 * advice["stable_h"], f"{stepper}: h = {advice['h']:.4g} of {advice['stable_h']:.4g}")
            check(reach is None or abs(bound / first - 1) < 1e-9, f"... which goes by the reach of {stepper}")


h_max_omega_of_the_solution()
stable_step_of_the_stepper()
known_to_its_share()
far_below()
unkicked()
reproducible()
rivals()
always()
near_rounding()
budget_is_hard()
cut_short()
speaks()
parted_early()
rolls()
part_again()
part_and_agree()
too_coarse_beside()
between_touches()
lucky_halving()
measures()
only_slowed()
others_by_energy()
damped()
one_touch()
strays()
general_inertia()
as_long_as_can_be()
says_why()
refusals()
conclude()
