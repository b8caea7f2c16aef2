#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""LAMMPS with our binder against vti-run on the same scene.               check.py CHAIN_FOLDER VTI_RUN LAMMPS_CHAIN"""
import pathlib
import subprocess
import sys
import tempfile

import h5py
import numpy

chain, vti_run, lammps_chain = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]
EPS = numpy.finfo(float).eps
T_END = 10
failures = 0


def check(condition, what):
    global failures
    print(("ok      " if condition else "FAILED  ") + what)
    failures += not condition


def by_vti_run(steps):
    """Position, velocity, alpha and angular velocity of each sphere at the end, and the energies of start and end."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([vti_run, chain / "chain.yaml", "--no-dump", "--h", f"{T_END}/{steps}", "-o", folder + "/out.h5"],
                       check=True, capture_output=True, timeout=300)
        with h5py.File(folder + "/out.h5") as file:
            frames, data = len(file["VTKHDF/Steps/Values"]), file["VTKHDF/PointData"]
            n = len(file["VTKHDF/Points"]) // frames
            end = [file["VTKHDF/Points"], data["velocity"], data["alpha"], data["omega"]]
            return numpy.hstack([part[-n:] for part in end]), file["energies/total"][[0, -1]]


def by_lammps(ranks, steps):
    """The same, and everything else that it says by its first word."""
    result = subprocess.run(["mpirun", "--oversubscribe", "-n", str(ranks), lammps_chain, chain / "bodies.csv", chain / "bonds.csv",
                             repr(T_END / steps), str(steps)], check=False, capture_output=True, text=True, timeout=300)
    if result.returncode != 0:
        sys.exit(f"FAILED  {ranks} ranks do not come to the end: {result.stdout[-1000:]}{result.stderr[-1000:]}")
    said, rows = {}, []
    for words in map(str.split, result.stdout.splitlines()):
        if words[0].isalpha():
            said.setdefault(words[0], []).append([float(word) for word in words[1:]])
        else:
            rows.append([float(word) for word in words])
    return numpy.array(rows), said


def forces(said, ranks):
    # A sphere of the chain has two bonds. LAMMPS adds them to zeros, and so do we: a rounding each is all that may
    # differ.
    for what in ("force", "moment"):
        error, size = said[what][0]
        check(size > 1 and error <= 2 * EPS * size, f"{ranks} ranks: {what}s in LAMMPS differ from ours by {error:.1e} of {size:.3g}")


differences = []
for steps in (2560, 5120, 10240):
    ours, energies = by_vti_run(steps)
    theirs, said = by_lammps(1, steps)
    start, end = said["energy"][0]
    differences.append(numpy.abs(theirs - ours).max())
    print(f"        h = {T_END / steps:.6f}: states at t = {T_END} differ by {differences[-1]:.3e}; "
          f"energy {start:.6f} becomes {end:.6f}, by vti-run {energies[1]:.6f}")
    # A few dozen terms, each good to a few roundings.
    check(abs(start - energies[0]) < 100 * EPS * start, "LAMMPS starts with the energy of vti-run")
    check(abs(end - energies[1]) < differences[-1] * start, "and ends with it, as nearly as the states agree")
    if steps == 5120:
        forces(said, 1)
        for ranks in (2, 3):
            rows, said = by_lammps(ranks, steps)
            forces(said, ranks)
            apart = numpy.abs(numpy.subtract(said["energy"][0], [start, end])).max()
            check(apart < 100 * EPS * start, f"{ranks} ranks: the energies in LAMMPS are those of 1 rank, but for {apart:.1e}")
            shares = ", ".join(f"{atoms:.0f} spheres and {bonds:.0f} bonds" for _, atoms, bonds in said["rank"])
            check(len(said["rank"]) == ranks and min(atoms for _, atoms, _ in said["rank"]) > 0, f"each rank has work: {shares}")
            check(rows.tobytes() == theirs.tobytes(), f"{ranks} ranks end where 1 does, to the last bit")
# Both are of second order, and their errors are different ones.
orders = numpy.log2(numpy.divide(differences[:-1], differences[1:]))
check(numpy.all(abs(orders - 2) < 0.1), "the difference is of order h^2: " + ", ".join(f"{order:.3f}" for order in orders))
sys.exit(1 if failures else 0)
