# SPDX-License-Identifier: BSD-3-Clause
"""Tables of beads for scenes/column.yaml, one bead deep in the plane y = 0.

    packing.py loose WIDTH BEADS SEED FILE  rows of beads that do not touch, in a box of so many diameters from x = 0
    packing.py settled RUN.h5 FILE          the beads of the last frame of a run, at rest

Diameters are uniform within 15 % of 3 mm, so that beads do not crystallise; masses are those of glass."""
import csv
import random
import sys

import h5py
import numpy as np

DIAMETER, SPREAD, DENSITY = 0.003, 0.15, 2500.0
APART, ROW = 1.2, 1.06      # of neighbours in a row and of rows, in mean diameters: the largest do not touch


def write(path, x, z, diameter):
    """Every bead has its own mass; y and all velocities are 0."""
    with open(path, "w", encoding="utf-8", newline="") as file:
        rows = csv.writer(file, lineterminator="\n")
        rows.writerow(["x", "y", "z", "diameter", "mass"])
        rows.writerows([f"{x[k]:.7g}", 0, f"{z[k]:.7g}", f"{diameter[k]:.7g}",
                        f"{DENSITY * np.pi / 6 * diameter[k] ** 3:.7g}"]
                       for k in range(len(x)))


def loose(width, beads, seed, path):
    """Every other row is shifted by half a place, and has one bead less."""
    draw = random.Random(int(seed))
    places, row = [], 0
    count = int(float(width) / APART)
    while len(places) < int(beads):
        shifted = row % 2
        places += [(APART * (k + 0.5 + 0.5 * shifted), 0.6 + ROW * row) for k in range(count - shifted)]
        row += 1
    x, z = DIAMETER * np.array(places[:int(beads)]).T
    write(path, x, z, np.array([DIAMETER * draw.uniform(1 - SPREAD, 1 + SPREAD) for _ in x]))


def settled(run, path):
    with h5py.File(run) as file:
        diameter = file["VTKHDF/PointData/diameter"][...]
        x = file["VTKHDF/Points"][-len(diameter):]
    write(path, x[:, 0], x[:, 2], diameter)


if __name__ == "__main__":
    {"loose": loose, "settled": settled}[sys.argv[1]](*sys.argv[2:])
