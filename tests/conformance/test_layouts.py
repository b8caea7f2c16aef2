#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""1000 steps of the chain and of the block that hits a wall: every layout of arrays in C, in slices and by threads, ends where
vti-run ends, to the last bit. Fortran is compared with C: test_fortran.f90 and test_fortran_lattice.f90, test_f77.f90.
test_layouts.py PROJECT VTI_RUN PROGRAM"""
import os
import pathlib
import subprocess
import sys
import tempfile

import h5py
import numpy

from tally import check, conclude

project, vti_run, program = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]
STEPS, INERTIA = 1000, 0.1 # of the solid spheres of both scenes
STIFFNESS = 10.0, 200.0, 200.0, 2100.0 # moment, axial, shear; wall, where there is one


def row(numbers):
    return " ".join(repr(float(number)) for number in numbers) + "\n"


def by_vti_run(folder, scene, h):
    """Writes the scene as a table for the programs; returns where vti-run ends, as [body][x, v, alpha, omega]."""
    out = folder / (scene + ".h5")
    subprocess.run([vti_run, project / "scenes" / (scene + ".yaml"), "--stepper", "vti2", "--h", repr(h), "--t-end",
                    repr(STEPS * h), "--no-dump", "-o", out], check=True, capture_output=True, timeout=120)
    with h5py.File(out) as file:
        data = file["VTKHDF/PointData"]
        diameter = data["diameter"][:]
        n = len(diameter)
        state = numpy.hstack([file["VTKHDF/Points"], data["velocity"], data["alpha"], data["omega"]])
        pairs = file["VTKHDF/Lines/Connectivity"][:].reshape(-1, 2)
        planes = file["walls"][:] if "walls" in file else numpy.zeros((0, 4))
    with open(folder / (scene + ".txt"), "w", encoding="ascii") as table:
        table.write(f"{n} {len(pairs)} {len(planes)} {STEPS} {h!r}\n" + row(STIFFNESS))
        table.writelines(row(plane) for plane in planes)
        table.writelines(row([*body, 1.0, INERTIA, d]) for body, d in zip(state[:n], diameter))
        table.writelines(f"{i} {j}\n" for i, j in pairs)
    return state[:n], state[-n:]


def by_program(program, table, **more):
    """Where each layout of a program ends, by name."""
    result = subprocess.run([program, table], check=True, capture_output=True, text=True, timeout=300,
                            env=dict(os.environ, **more))
    ends = {}
    for part in result.stdout.split("= ")[1:]:
        name, *rows = part.splitlines()
        ends[name] = numpy.array([[float(word) for word in line.split()] for line in rows])
    return ends


with tempfile.TemporaryDirectory() as place:
    folder = pathlib.Path(place)
    for scene, h in (("chain", 1 / 512), ("block", 1 / 256)):
        first, last = by_vti_run(folder, scene, h)
        moved = numpy.abs(last - first).reshape(-1, 4, 3).max(axis=(0, 2))
        check(moved.min() > 1e-2, f"{scene}: {len(first)} spheres move and turn: {moved}")
        if scene == "block":
            check(last[:, 3].mean() > 0 > first[:, 3].mean(), "the block has bounced off its wall")
        ends = {}
        for threads in ("1", "3"):
            said = by_program(program, folder / (scene + ".txt"), OMP_NUM_THREADS=threads, OMP_WAIT_POLICY="passive")
            ends.update({f"{name}, {threads} threads": end for name, end in said.items()})
        off = [name for name, end in ends.items() if end.tobytes() != last.tobytes()]
        check(len(ends) > 50 and not off, f"{scene}: {len(ends)} ways end where vti-run ends {off or ''}")
conclude()
