#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""vti-run with threads: the same bytes of all files for any number of them, and for runs that go on with another one.
                            test_run_threads.py VTI_RUN SCENES"""
import os
import sys
import tempfile

import h5py
import numpy

from programs import contents, one_line, run
from tally import check, conclude

RUN, SCENES = map(os.path.abspath, sys.argv[1:3])
TOGETHER = """name: together
bodies: {lattice: {counts: [5, 4, 6], spacing: 1, corner: [1, 0, 0]}, mass: 1, diameter: 1.02, v: [-2, 0, 0],
         random: {seed: 3, v: 0.5, omega: 1.5}}
binder: {moment: 2, axial: 200, shear: {stiffness: 100}}
contact: {stiffness: 2000, bonded: yes}
wall: {stiffness: 2000, planes: [[1, 0.2, 0, 1]]}
gravity: [0, 0, -1]
h: 2^-8
t_end: 1
"""

# A block of bonded spheres that overlap breaks on a wall: lists change, and what has broken touches at the distance
# that it has then.
BREAKING = """name: breaking
bodies: {lattice: {counts: [4, 4, 6], spacing: 0.9, corner: [1, 0, 0]}, mass: 1, diameter: 1, v: [-4, 0, 0],
         random: {seed: 3, v: 0.5, omega: 1.5}}
binder: {moment: 2, axial: 200, shear: {stiffness: 100}, break: {stretch: 0.1, normal: 40, shear: 30, bending: 4}}
contact: {stiffness: 2000}
wall: {stiffness: 2000, planes: [[1, 0.2, 0, 0.2]]}
friction: {sliding: 0.3, poisson: 0.3}
h: 2^-8
t_end: 1
"""

# A lattice of spheres falls and is bonded where they touch; some bonds break.
JOINING = """name: joining
bodies: {lattice: {counts: [4, 4, 4], spacing: 1.1, corner: [0, 0, 0.6]}, mass: 1, diameter: 1,
         random: {seed: 3, v: 1.5, omega: 1.5}}
binder: {when: touching, most: 4, moment: 20, axial: 600, shear: {stiffness: 300},
         break: {stretch: 0.2, shear: 40, bending: 8}}
contact: {stiffness: 2000, bonded: yes}
wall: {stiffness: 2000, planes: [[0, 0, 1, 0]]}
gravity: [0, 0, -3]
bond_dashpot: {zeta: 0.1}
friction: {sliding: 0.3, poisson: 0.3}
h: 2^-8
t_end: 1
"""

# A drum that turns while one of its ends comes nearer, each wall with its own stiffness, friction and dashpot.
DRUM = """name: drum
bodies: {lattice: {counts: [5, 2, 5], spacing: 1.05, corner: [-2.1, 0.5, -2.1]}, diameter: 1, mass: 1, random: {seed: 2, v: 0.5}}
contact: {stiffness: 2000}
wall:
  stiffnesses: [2000, 4000, 3000]
  planes: [[0, 1, 0, 0], [0, -1, 0, -2.1]]
  cylinders: [[0, 1, 0, 0, 0, 0, 3.75]]
  velocities: [[0, 0, 0], [0, -0.125, 0], [0, 0, 0.25]]
  spins: [0, 0.5, 2]
gravity: [0, 0, -9.81]
friction: {sliding: 0.5, wall_sliding: [0, 0.25, 0.75], poisson: 0.3}
dashpot: {restitution: 0.5, wall_restitution: [0.5, 0.5, 0.25], ratio: 0.5}
h: 2^-9
t_end: 1
"""

# Tetrapods of all attitudes and single spheres, some bonded sphere to sphere, collide in a viscous medium and on a
# wall: a slice has the spheres of its own bodies.
BONDS = "i,j\n0,4\n2,6\n9,13\n14,16\n"
CLUMPS = """name: clumps
bodies: {lattice: {counts: [3, 2, 3], spacing: 2.2, corner: [0, 0, 1.6]}, random: {seed: 3, v: 2, omega: 2, alpha: 3},
         clumps: {spheres: [[1, 1, 1, 1.9], [1, -1, -1, 2], [-1, 1, -1, 2], [-1, -1, 1, 2], [0, 0, 0, 1]], counts: [4, 1],
                  density: 0.2}}
drag: {viscosity: 0.02, on: spheres}
binder: {table: bonds.csv, axial: 40, moment: 2, shear: {stiffness: 10}, on: spheres}
bond_dashpot: {zeta: 0.1}
contact: {stiffness: 2000}
wall: {stiffness: 2000, planes: [[0, 0.1, 1, 0]]}
friction: {sliding: 0.3, poisson: 0.3}
dashpot: {restitution: 0.5, ratio: 0.5}
gravity: [0, 0, -1]
h: 2^-8
t_end: 1
"""

# So many bodies that dashpots and friction go by chunks: a block that slides, settles and is pushed about by a plane
# that turns. It breaks where it overlaps, as above.
CHUNKS = """name: chunks
bodies: {lattice: {counts: [13, 8, 10], spacing: 0.99, corner: [0, 0, 0.49]}, diameter: 1, mass: 1, v: [0.5, 0, 0],
         random: {seed: 3, v: 1, omega: 1}}
binder: {moment: 1, axial: 100, shear: {stiffness: 50}, break: {shear: 0.5}}
contact: {stiffness: 2000}
wall: {stiffness: 2000, planes: [[0, 0, 1, 0]], spins: [1]}
gravity: [0, 0, -9.81]
friction: {sliding: 0.3, poisson: 0.3, rolling: 0.1, rolling_stiffness: 50}
dashpot: {restitution: 0.5, ratio: 0.5, rolling: 0.5}
h: 2^-6
t_end: 1
"""


def files(scene, folder, threads, *options):
    """What a run leaves, or what it says."""
    done = run(RUN, scene, "-o", os.path.join(folder, "out.h5"), "--threads", str(threads), "--record", "8",
               "--frames", "32", *options)
    return contents(folder) if done.returncode in (0, 3) else done.stderr


LOST = ("--fields", "force,moment,lost", "--contacts")


def same_bytes(scene, base, *options):
    """1 piece, 2, 3, 7; stopped halfway and prolonged by another number of threads."""
    folder = lambda name: os.path.join(base, os.path.basename(scene) + "-" + name)
    one = files(scene, folder("1"), 1, "--t-end", "1", *options)
    check(isinstance(one, dict) and len(one) >= 4, f"{os.path.basename(scene)} {' '.join(options)}: runs")
    for threads in (2, 3, 7) if options in ((), LOST) else (3,):
        other = files(scene, folder(str(threads)), threads, "--t-end", "1", *options)
        check(other == one, f"... the same bytes on {threads} threads")
    files(scene, folder("on"), 2, "--t-end", "0.5", *options)
    check(files(scene, folder("on"), 3, "--t-end", "1", "--resume", *options) == one, "... and by 2 threads, then 3")


def books(scene, base):
    """What bodies have lost adds up to the columns of out.csv, which are what they are without; out.h5 is that of
    same_bytes."""
    name = os.path.basename(scene)
    plain = files(scene, os.path.join(base, name + "-plain"), 2, "--t-end", "1")
    with h5py.File(os.path.join(base, name + "-1", "out.h5")) as file:
        frames, rows = file["VTKHDF/Steps/Values"][:], file["energies/t"][:]
        points = {key: file[f"VTKHDF/PointData/{key}"][:].reshape(len(frames), -1) for key in file["VTKHDF/PointData"]
                  if key.startswith(("lost", "work_"))}
        lost = {key: file[f"energies/{key}"][:] for key in file["energies"] if key.startswith(("lost_", "work_"))}
    check(set(points) == {"lost", *lost} and len(lost) > 1, f"{name}: books of each body: {' '.join(sorted(points))}")
    lost["lost"] = sum(values for key, values in lost.items() if key != "work_wall")
    for key, values in points.items():
        column, size = lost[key][numpy.searchsorted(rows, frames)], numpy.abs(values).sum(axis=1)
        check(numpy.all(numpy.abs(values.sum(axis=1) - column) <= values.shape[1] * 2.0 ** -52 * size) and size[-1] > 0,
              f"... {key} adds up to its column, up to a rounding of each body")
    with open(os.path.join(base, name + "-1", "out.csv"), "rb") as file:
        check(plain["out.csv"] == file.read(), "... which is the same without them")
    again = files(scene, os.path.join(base, name + "-1"), 2, "--t-end", "1.25", "--resume")
    check(isinstance(again, str) and "--fields force,moment,lost" in again, f"... --resume without --fields: {str(again).strip()[:200]}")


def refusals(scene):
    for value in ("0", "-2", "two", "1e9"):
        check(one_line(run(RUN, scene, "--threads", value), "--threads", f"'{value}'"), f"--threads {value}")


with tempfile.TemporaryDirectory() as root:
    together = os.path.join(root, "together.yaml")
    with open(together, "w", encoding="ascii") as file:
        file.write(TOGETHER)
    with open(os.path.join(root, "bonds.csv"), "w", encoding="ascii") as file:
        file.write(BONDS)
    same_bytes(together, root)
    for name, text in (("breaking", BREAKING), ("joining", JOINING), ("drum", DRUM), ("clumps", CLUMPS),
                       ("chunks", CHUNKS)):
        path = os.path.join(root, name + ".yaml")
        with open(path, "w", encoding="ascii") as file:
            file.write(text)
        same_bytes(path, root, *LOST)
        if name in ("drum", "clumps", "chunks"):
            books(path, root)
    same_bytes(os.path.join(SCENES, "pile.yaml"), root, "--h", "2^-8")
    same_bytes(os.path.join(SCENES, "torus.yaml"), root, "--stepper", "vti1", "--h", "1/256")
    refusals(together)
conclude()
