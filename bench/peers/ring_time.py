# SPDX-License-Identifier: BSD-3-Clause
"""The whole impact of the ring, to t = 35, in a LAMMPS of 4 July 2026 or later and by vti-run, processor seconds of
processes, printed as CSV:
    ring_time.py BUILD ROUNDS VTI-RUN...
BUILD is the folder with that LAMMPS' lmp, built by cmake with PKG_ASPHERE, PKG_BPM, PKG_GRANULAR and PKG_MOLECULE;
earlier releases burst the ring, which the kinetic energy at the end (40 at the start) tells. Builds of vti-run with
-Dvectors=avx2 and baseline show narrower vector units. All record energies every 100 steps; no trajectory is
written."""

import sys
import tempfile

from lammps import Lammps
from ring import Torus


class Whole(Torus):
    """In LAMMPS the box grows with the ring."""

    t_end, record, edge = 35.0, 100, "m"


def main():
    lammps, rounds = Lammps(sys.argv[1], sys.argv[1]), int(sys.argv[2])
    print("program,vti_s,lammps_s,ratio,least,most,kinetic")
    for vti_run in sys.argv[3:]:
        with tempfile.TemporaryDirectory() as folder:
            case = Whole(lammps, vti_run, folder)
            _, still, turning = case.by_lammps_rows(case.h)[-1]
            print(vti_run, *(f"{value:.4g}" for value in (*case.times(rounds), still + turning)), sep=",")


if __name__ == "__main__":
    main()
