#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""vti-run --renumber: bodies of a table in random order; files have the table's numbers, and the motion is that of a
run without.
                            test_run_renumber.py VTI_RUN"""
import os
import random
import sys
import tempfile

import h5py
import numpy as np

from programs import contents, one_line, run
from tally import check, conclude

RUN = os.path.abspath(sys.argv[1])
SCENE = """name: shuffled
bodies: {table: bodies.csv, inertia: 0.1, random: {seed: 4, v: 0.3, omega: 0.4, alpha: 0.2}}
binder: {table: bonds.csv, moment: 2, shear: {stiffness: 100}}
contact: {stiffness: 2000}
wall: {stiffness: 2000, planes: [[0, 0, 1, 0]]}
friction: {sliding: 0.3, poisson: 0.3}
gravity: [0, 0, -1]
h: 2^-8
t_end: 0.5
"""
COUNTS = (6, 5, 7)


def write_tables():
    """A lattice in random order, each body with a mass of its own and each bond with a stiffness of its own."""
    rng = random.Random(1)
    sites = [(x, y, z) for z in range(COUNTS[2]) for y in range(COUNTS[1]) for x in range(COUNTS[0])]
    rng.shuffle(sites)
    number = {site: i for i, site in enumerate(sites)}
    bonds = [(number[x, y, z], number[x + 1, y, z]) for x, y, z in sites if x + 1 < COUNTS[0]]
    bonds += [(number[x, y, z], number[x, y + 1, z]) for x, y, z in sites if y + 1 < COUNTS[1]]
    rng.shuffle(bonds)
    with open("bodies.csv", "w", encoding="ascii") as file:
        print("x,y,z,mass,diameter", file=file)
        for i, (x, y, z) in enumerate(sites):
            print(f"{1.01 * x},{1.01 * y},{1.01 * z + 0.52},{1 + i / len(sites)},{1 - 0.0001 * (i % 7)}", file=file)
    with open("bonds.csv", "w", encoding="ascii") as file:
        print("i,j,axial", file=file)
        for k, (i, j) in enumerate(bonds):
            print(f"{(i, j)[k % 2]},{(j, i)[k % 2]},{200 + k}", file=file)


def write_scene(text, name="scene.yaml"):
    with open(name, "w", encoding="ascii") as file:
        file.write(text)
    return name


def go(folder, *options):
    return run(RUN, "scene.yaml", "-o", os.path.join(folder, "out.h5"), "--frames", "16", *options)


def arrays(path):
    found = {}
    with h5py.File(path, "r") as file:
        file.visititems(lambda name, item: found.__setitem__(name, item[()]) if isinstance(item, h5py.Dataset) and
                        item.dtype.kind in "fi" and not name.startswith("restart") else None)
    return found


def both(folder):
    """What is in out.h5 and out-contacts.h5."""
    contacts = arrays(f"{folder}/out-contacts.h5")
    return {**arrays(f"{folder}/out.h5"), **{"contacts of " + name: values for name, values in contacts.items()}}


def same_motion():
    """To rounding, and to the bit where nothing is summed."""
    lost = ("--fields", "lost", "--contacts")
    check(go("plain", *lost).returncode == 0 and go("moved", "--renumber", *lost).returncode == 0, "runs with and without")
    plain, moved = both("plain"), both("moved")
    check(len(plain["contacts of VTKHDF/CellData/i"]) > 100, "spheres touch")
    check(plain.keys() == moved.keys() and any("Points" in name for name in plain), "the same numbers are in the files")
    for name, one in plain.items():
        other = moved[name]
        if one.dtype.kind == "i":
            check(np.array_equal(one, other), f"{name}: the same")
        else:
            scale = max(1.0, float(np.max(np.abs(one), initial=0.0)))
            check(one.shape == other.shape and np.allclose(one, other, rtol=0, atol=1e-9 * scale), f"{name}: to rounding")
    points = "VTKHDF/Points"
    bodies = COUNTS[0] * COUNTS[1] * COUNTS[2]
    check(np.array_equal(plain[points][:bodies], moved[points][:bodies]), "places at t = 0 to the bit, in the table's order")
    check(any(not np.array_equal(one, moved[name]) for name, one in plain.items()), "... and later in other bits")


def last_places(folder):
    found = arrays(f"{folder}/out.h5")
    last = {name.split("/")[-1]: int(values.ravel()[-1]) for name, values in found.items() if name.endswith("/PointOffsets")}
    begin, bodies = last["PointOffsets"], COUNTS[0] * COUNTS[1] * COUNTS[2]
    return next(values for name, values in found.items() if name.endswith("/Points"))[begin:begin + bodies]


def order_of_dashpots():
    """Dashpots act pair after pair, whose order is another one: what differs is of the order of the step, 2."""
    for dashpots in ("bond_dashpot: {zeta: 0.2}", "dashpot: {zeta: 0.2, ratio: 0.5}"):
        differ = []
        for h in (8, 9):
            write_scene(SCENE.replace("h: 2^-8", f"h: 2^-{h}\n{dashpots}"))
            check(go("listed").returncode == 0 and go("sorted", "--renumber").returncode == 0, f"{dashpots}, h = 2^-{h}")
            differ.append(np.max(np.abs(last_places("listed") - last_places("sorted"))))
        check(abs(np.log2(differ[0] / differ[1]) - 2) < 0.2, f"... another order of pairs: {differ[0]:.3g} and {differ[1]:.3g}, of order 2")
    write_scene(SCENE)


def same_bytes():
    one = contents("moved")
    go("three", "--renumber", "--threads", "3", "--fields", "lost", "--contacts")
    check(contents("three") == one, "the same bytes on 3 threads")
    go("on", "--renumber", "--t-end", "0.25", "--contacts")
    check(one_line(go("on", "--contacts", "--resume"), "on/out.h5", "renumbered"), "goes on with --renumber only")
    go("on", "--renumber", "--contacts", "--resume")
    check(contents("on")["out.csv"] == go_rows("half", "0.5"), "... with the same bytes")
    check(contents("on")["out-contacts.h5"] == one["out-contacts.h5"], "... of contacts too")


def go_rows(folder, end):
    """Rows of a run in one go with the intervals of one to t = 0.25."""
    go(folder, "--renumber", "--t-end", end, "--record", "1")
    return contents(folder)["out.csv"]


def same_numbers():
    """Messages have the table's."""
    plain, moved = go("plain").stdout, go("moved", "--renumber").stdout
    limits = [[line for line in text.splitlines() if "bodies" in line and "bond" in line] for text in (plain, moved)]
    check(limits[0] == limits[1] and limits[0], f"what limits the step: {limits[0]}")
    with open("bodies.csv", encoding="ascii") as file:
        rows = file.read().splitlines()
    rows[101] += ",1e200"
    write_scene(SCENE.replace("bodies.csv", "fast.csv"))
    with open("fast.csv", "w", encoding="ascii") as file:
        print("\n".join([rows[0] + ",vx,vy,vz"] + [row + (",0,0" if k == 100 else ",0,0,0") for k, row in enumerate(rows[1:])]),
              file=file)
    for options in ((), ("--renumber",)):
        check("body 100 has velocity" in go("fast", *options).stderr, f"the body that is too fast: {options}")
    write_scene(SCENE)


def refusals():
    with open("few.csv", "w", encoding="ascii") as file:
        file.write("x,y,z\n0,0,0\n")
    for text, word in ((SCENE.replace("table: bodies.csv", "lattice: {counts: [3, 3, 3], spacing: 1}, mass: 1, diameter: 1").
                        replace("table: bonds.csv, ", "axial: 3, "), "table"),
                       ("bodies: {table: few.csv, clumps: {spheres: [[0, 0, 0, 1]]}, mass: 1}\nh: 1\nt_end: 1\n", "clumps"),
                       (SCENE.replace("moment: 2,", "moment: 2, break: {stretch: 0.1},"), "break")):
        write_scene(text)
        check(one_line(go("refused", "--renumber"), word, "leave --renumber out"), f"refused: {word}")
    write_scene(SCENE)


with tempfile.TemporaryDirectory() as root:
    os.chdir(root)
    write_tables()
    write_scene(SCENE)
    same_motion()
    order_of_dashpots()
    same_bytes()
    same_numbers()
    refusals()
conclude()
