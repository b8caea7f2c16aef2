#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What vti-run says beside its results: what of a scene and its tables nothing goes by (as vti-study and vti-advise
do), how much
disk it takes, how far it is.      test_run_says.py VTI_RUN VTI_STUDY VTI_ADVISE SCENES"""
import glob
import json
import os
import re
import subprocess
import sys
import tempfile
import time

from programs import run
from tally import check, conclude

RUN, STUDY, ADVISE, SCENES = map(os.path.abspath, sys.argv[1:5])

MOVING = "x,y,z,vx,vy,vz"
TURNING = "omega_x,omega_y,omega_z"
TURNED = "nothing turns bodies"
MOVED = "bodies do not translate, and their inertia is given"
MADE = "no stiffness of this scene follows from the bodies' materials"
WALL = "wall: {stiffness: 1, planes: [[0, 0, 1, -9]]}\n"
# columns, values, keys of bodies, the rest of the scene, notes
UNUSED = [
    (MOVING, "0,0,0,1,0,0", "mass: 1, inertia: 0.37", "", [f"bodies.inertia is not used: {TURNED}; leave it out"]),
    (MOVING, "0,0,0,1,0,0", "mass: 1, moments: [1, 1, 1]", "", [f"bodies.moments is not used: {TURNED}; leave it out"]),
    (MOVING + ",inertia", "0,0,0,1,0,0,2", "mass: 1", "", [f"TABLE: column inertia is not used: {TURNED}"]),
    (MOVING + ",moment_a,moment_b,moment_c", "0,0,0,1,0,0,1,1,1", "mass: 1", "",
     [f"TABLE: columns moment_a, moment_b, moment_c are not used: {TURNED}"]),
    (TURNING, "0,0,1", "mass: 1, inertia: 1", "", [f"bodies.mass is not used: {MOVED}; leave it out"]),
    (TURNING + ",inertia", "0,0,1,1", "density: 1, diameter: 1", "", [f"bodies.density is not used: {MOVED}; leave it out"]),
    (TURNING + ",mass", "0,0,1,1", "moments: [1, 1, 1]", "", [f"TABLE: column mass is not used: {MOVED}"]),
    (TURNING, "0,0,1", "mass: 1, diameter: 1", "", []),
    (TURNING + ",mass,diameter", "0,0,1,1,1", "", "", []),
    (MOVING + "," + TURNING, "0,0,0,1,0,0,0,0,1", "mass: 1, inertia: 1", "", []),
    (MOVING + ",young,poisson", "0,0,0,1,0,0,1,0.3", "mass: 1", "", [f"TABLE: columns young and poisson are not used: {MADE}"]),
    (MOVING + ",young,poisson", "0,0,0,1,0,0,1,0.3", "mass: 1, diameter: 1", "contact: {stiffness: 1}\n" + WALL,
     [f"TABLE: columns young and poisson are not used: {MADE}"]),
    (MOVING + ",young,poisson", "0,0,0,1,0,0,1,0.3", "mass: 1, diameter: 1", "contact: {}\n", []),
    (MOVING + ",young,poisson", "0,0,0,1,0,0,1,0.3", "mass: 1, diameter: 1",
     WALL.replace("stiffness: 1", "young: 1, poisson: 0.3"), []),
]


def unused(base):
    """A note for each key and column that nothing goes by, and none where something does."""
    for columns, row, keys, more, notes in UNUSED:
        with open(f"{base}/b.csv", "w", encoding="ascii") as file:
            file.write(f"{columns}\n{row}\n")
        with open(f"{base}/b.yaml", "w", encoding="ascii") as file:
            file.write(f"bodies: {{table: b.csv, {keys}}}\n{more}h: 1/64\nt_end: 1/8\n")
        done = run(RUN, f"{base}/b.yaml", "-o", f"{base}/b-out.h5")
        said = [line[len("note: "):] for line in done.stdout.splitlines() if line.startswith("note: ")]
        wanted = [note.replace("TABLE", f"{base}/b.csv") for note in notes]
        check(done.returncode == 0 and said == wanted, f"{columns}; {keys}: {said} {done.stderr.strip()}")


def unused_elsewhere(base):
    """The same notes by vti-study and vti-advise; beside JSON on the standard error."""
    with open(f"{base}/e.yaml", "w", encoding="ascii") as file:
        file.write("bodies: {x: [0, 0, 0], v: [1, 0, 0], mass: 1, inertia: 0.37}\ndrag: {linear: 1}\nh: 1/64\nt_end: 1\n")
    note = f"note: bodies.inertia is not used: {TURNED}; leave it out"
    done = run(STUDY, f"{base}/e.yaml", "--h", "1/16:1/64", "--no-plot", "-o", f"{base}/e-study")
    check(done.returncode == 0 and done.stdout.splitlines().count(note) == 1, f"vti-study: {note} {done.stderr.strip()}")
    for options, which in ([], "stdout"), (["--json"], "stderr"):
        done = run(ADVISE, f"{base}/e.yaml", "--steppers", "vti2", *options)
        check(done.returncode == 0 and getattr(done, which).splitlines().count(note) == 1,
              f"vti-advise {' '.join(options)}: the same {done.stderr.strip()}")
        check(not options or json.loads(done.stdout)["stepper"] == "vti2", "... and JSON alone is on the standard output")


def shipped(base):
    """Scenes that are shipped say nothing in vain."""
    for scene in sorted(glob.glob(f"{SCENES}/*.yaml")):
        done = run(RUN, scene, "--t-end", "1e-6", "--h", "1e-6", "-o", f"{base}/shipped.h5", "--force")
        check(done.returncode in (0, 3) and "not used" not in done.stdout,
              f"{os.path.basename(scene)}: nothing is given that is not used {done.stderr.strip()}")


def start(base, *options, scene=f"{SCENES}/heap.yaml", folder=None, after=0):
    """What is said before the first step; the run is ended then, or so many seconds later."""
    folder = folder or tempfile.mkdtemp(dir=base)
    with subprocess.Popen([RUN, scene, "-o", f"{folder}/long.h5", *options], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL) as going:
        said = []
        for line in going.stdout:
            said.append(line)
            if line.startswith("a row every"):
                break
        time.sleep(after)
        going.terminate()
        return "".join(said) + going.stdout.read()


def disk(base):
    """Runs that write much say how much; those that write more than there is room for are warned."""
    short = start(base, "--t-end", "1", "--frames", "1000")
    check("files of some" not in short, f"a short run says nothing of its files: {short.splitlines()[-1]}")
    large = start(base, "--t-end", "1", "--frames", "1")
    found = re.search(r"; files of some ([\d.]+) MB, ([\d.]+) MB while they are written\n", large)
    check(found and 100 < float(found[1]) < float(found[2]) < 1.5 * float(found[1]), f"... a long one: {found and found[0].strip()}")
    check("room" not in large and "--no-dump" in start(base, "--t-end", "1e7", "--frames", "1"), "... and whether there is room")
    less = re.search(r"files of some ([\d.]+) MB", start(base, "--t-end", "2", "--frames", "1", "--no-dump"))
    check(less and float(less[1]) < 1.2 * float(found[1]), f"... which is less without the dump, of twice the time: {less and less[0]}")


def unasked(base):
    """Frames that nobody asks for take 500 MB at most, all files together, or are two; --resume keeps how many they are."""
    scene, folder = f"{base}/many.yaml", f"{base}/many"
    with open(scene, "w", encoding="ascii") as file:
        file.write("bodies: {lattice: {counts: [30, 30, 30], spacing: 1}, mass: 1, v: [1, 0, 0], omega: [0, 0, 1]}\nh: 1e-3\nt_end: 1e4\n")

    def found(*options, after=0):
        if "--resume" not in options and os.path.exists(f"{folder}/long.run"):
            os.remove(f"{folder}/long.run")
        said = start(base, *options, scene=scene, folder=folder, after=after)
        frames = re.search(r"^a row every .* a frame every (\d+ )?steps? .*; files of some ([\d.]+) MB,.*$", said, re.MULTILINE)
        fewer = re.search(r"^note: (\d+) frames, .* 500 MB of files; --frames EVERY ", said, re.MULTILINE)
        check(frames, f"{options}: {said}")
        return int(frames[1]), float(frames[2]), fewer and int(fewer[1])
    every, size, fewer = found()
    check(fewer == 10**7 // every + 1 and 250 < size < 500 and 20 <= fewer < 50, f"27000 bodies: {fewer} frames, {size} MB")
    for after in (0.5, 2, 8, 30):   # until it is past the first step
        if not os.path.exists(f"{folder}/long.run"):
            found(after=after)
    again, less, note = found("--no-dump", "--resume")
    check(again == every and less < size and note is None, f"--resume keeps the frames that it began with: one every {again}, {less} MB")
    without = found("--no-dump")
    check(without[0] < every and without[1] < 500, f"without the dump there are more frames: {without}")
    check(found("--set", "bodies.lattice.counts=[120, 120, 120]", "--t-end", "1e4", "--no-dump")[::2] == (10**7, 2), "of more bodies than fit, two")
    done = run(RUN, scene, "-o", f"{base}/size.h5", "--no-dump", "--set", "bodies.lattice.counts=[63, 63, 63]", "--t-end", "1e-3")
    told, is_so = re.search(r"files of some ([\d.]+) MB", done.stdout), 1e-6 * os.path.getsize(f"{base}/size.h5")
    check(told and abs(float(told[1]) / is_so - 1) < 0.1, f"what is said is so, with what --resume goes on from: {is_so:.0f} MB, {told and told[0]}")
    os.remove(f"{base}/size.h5")
    asked = start(base, "--frames", "100000", scene=scene)
    check("a frame every 100000 steps" in asked and "; files of some 1.2" in asked and "note" not in asked, f"as many as are asked for: {asked}")
    few = start(base, "--set", "bodies.lattice.counts=[10, 10, 10]", scene=scene)
    check("a frame every 100000 steps (100 of time)\n" in few and "note" not in few, f"of few bodies about 100: {few}")


def logged(base):
    """Where there is no terminal, a line at each checkpoint, as far apart as asked for."""
    def lines(name, **more):
        done = run(RUN, f"{SCENES}/heap.yaml", "--t-end", "4", "--checkpoint", "0.05", "--frames", "8192", "-o", f"{base}/{name}.h5",
                   env={**os.environ, **more})
        check(done.returncode == 0, f"logged {more}: code {done.returncode}")
        return done.stderr.splitlines()
    said = lines("lines", VTI_LOG="0.05")
    found = [re.fullmatch(r"vti-run: step (\d+) of 8192 \(t = ([\d.]+)\), about \d+ s left", line) for line in said]
    check(found and all(found), f"{len(said)} lines: {said[:1]}")
    steps = [int(line[1]) for line in found if line]
    check(steps == sorted(set(steps)) and all(abs(float(line[2]) - int(line[1]) / 2048) < 1e-6 for line in found), "... each farther on")
    check(not lines("never", VTI_LOG="0"), "... none if none are wanted")
    check(not lines("minute"), "... nor in a run shorter than a minute")
    check(not lines("empty", VTI_LOG=""), "... nor of an empty word")
    for word in ("abc", "1x"):
        said = lines("word", VTI_LOG=word)
        check(said == [f"vti-run: VTI_LOG: '{word}' is no number of seconds; lines are 60 s apart, give 0 for none"], f"'{word}': {said}")


def never_bonded(base):
    """Bonds whose time the run does not reach."""
    with open(f"{base}/n.yaml", "w", encoding="ascii") as file:
        file.write("bodies: {lattice: {counts: [2, 1, 1], spacing: 1}, mass: 1, diameter: 1.001}\ncontact: {stiffness: 100, bonded: yes}\n"
                   "binder: {when: touching, from: 2, axial: 10}\nh: 1/64\nt_end: 1\n")
    for end, notes in (("1", ["note: binder.from: 2 is later than t_end, 1, so that no bond is made; give an earlier time, or a later t_end"]),
                       ("2", [])):
        done = run(RUN, f"{base}/n.yaml", "--t-end", end, "-o", f"{base}/n-out{end}.h5")
        said = [line for line in done.stdout.splitlines() if line.startswith("note: ")]
        check(done.returncode == 0 and said == notes, f"binder.from: 2, t_end: {end}: {said} {done.stderr}")


with tempfile.TemporaryDirectory() as root:
    unused(root)
    unused_elsewhere(root)
    never_bonded(root)
    shipped(root)
    disk(root)
    unasked(root)
    logged(root)
conclude()
