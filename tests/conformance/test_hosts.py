#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Each host of examples/ ends where vti-run ends with the same scene, to the last bit; the old code does not before the
change that examples/legacy shows.                                              test_hosts.py PROJECT VTI_RUN HOST..."""
import pathlib
import shutil
import subprocess
import sys
import tempfile

import h5py
import numpy

from programs import ENVIRONMENT
from tally import check, conclude

project, vti_run = pathlib.Path(sys.argv[1]), sys.argv[2]
hosts = {pathlib.Path(path).name: path for path in sys.argv[3:]}
chain = project / "examples" / "chain"


def by_vti_run():
    """Position, velocity, alpha and angular velocity of each sphere at the end, and the total energy there."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([vti_run, chain / "chain.yaml", "-o", folder + "/out.h5"], check=True, capture_output=True, timeout=120)
        with h5py.File(folder + "/out.h5") as file:
            frames, data = len(file["VTKHDF/Steps/Values"]), file["VTKHDF/PointData"]
            n = len(file["VTKHDF/Points"]) // frames
            end = [file["VTKHDF/Points"], data["velocity"], data["alpha"], data["omega"]]
            return numpy.hstack([part[-n:] for part in end]), file["energies/total"][-1]


def by_host(path, table="bodies.csv", **more):
    """The same, and what else a host says: energies."""
    result = subprocess.run([*(path if isinstance(path, list) else [path]), chain / table], check=False, capture_output=True, text=True, timeout=120,
                            env=dict(ENVIRONMENT, **more))
    lines = result.stdout.splitlines() if result.returncode == 0 else []
    energies = [float(line.split()[1]) for line in lines if line.startswith("energy")]
    rows = [[float(word) for word in line.split()] for line in lines if not line.startswith("energy")]
    return numpy.array(rows), energies, result.returncode


expected, energy = by_vti_run()
check(expected.shape == (10, 12) and numpy.abs(expected).min() > 0, "vti-run moves all of ten spheres")
for name, path in hosts.items():
    rows, energies, code = by_host(path)
    same = rows.tobytes() == expected.tobytes()
    if name == "legacy_before":
        check(code == 0 and not same, "legacy_before runs, and ends somewhere else")
        before, after = energies[1], energy
        as_said = round(energies[0], 1) == 3.4 and before > 1e5 and abs(after - energies[0]) < 1e-3 * energies[0]
        check(as_said, "energies are as docs/linking.md says")
        print(f"        energy {energies[0]:.10g} at first, {energies[1]:.10g} at the end; by vti {energy:.10g}")
    else:
        check(same, f"{name} ends where vti-run ends")
    if name == "legacy_after":
        check(abs(energies[1] - energy) < 1e-9 * energy, "legacy_after has the same energy")
    check(by_host(path, "bonds.csv")[2] != 0 and by_host(path, "nothing")[2] != 0, f"{name} refuses what are no spheres")
    said = subprocess.run([path, "nothing.csv"], check=False, capture_output=True, text=True, timeout=120, env=ENVIRONMENT).stderr
    check("nothing.csv: cannot be opened; call this in the folder examples" in said, f"{name} says why: {said}")
for threads in ("1", "2", "3", "7", "16"):
    for name in {"host_threads", "host_threads_fortran"} & set(hosts):
        rows = by_host(hosts[name], OMP_NUM_THREADS=threads)[0]
        check(rows.tobytes() == expected.tobytes(), f"{name}, {threads} threads")
for ranks in (2, 3, 7) if "host_ranks" in hosts and shutil.which("mpirun") else ():
    rows = by_host(["mpirun", "-n", str(ranks), hosts["host_ranks"]])[0]
    check(rows.tobytes() == expected.tobytes(), f"host_ranks, {ranks} ranks")
conclude()
