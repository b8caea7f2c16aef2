# SPDX-License-Identifier: BSD-3-Clause
"""Whole processes, vti-run and a LAMMPS of 4 July 2026 or later that has been built for this machine, processor
seconds, printed as CSV:
    built.py BUILD ROUNDS VTI-RUN...
    built.py BUILD                    says no more than whether that LAMMPS will do
BUILD is the folder with that LAMMPS' lmp: cmake -D PKG_ASPHERE=on -D PKG_BPM=on -D PKG_GRANULAR=on -D PKG_MOLECULE=on
-D BUILD_MPI=off -D BUILD_OMP=off -D CMAKE_CXX_FLAGS="-O3 -march=native". The torus flies its whole impact: earlier
releases burst it, which the kinetic energy at the end (40 at the start) tells; gain is what a bond that turns far makes
of its energy at most. Builds of vti-run with -Dvectors=avx2 and baseline show narrower vector units. All record
energies; no trajectory is written."""

import os
import sys
import tempfile

import scenes
from lammps import FRAMES, Lammps
from ring import Bonded, Torus


class Impact(Torus):
    """In LAMMPS the box grows with the ring."""

    t_end, record, edge = 35.0, 100, "m"


NEEDED = {"ASPHERE", "BPM", "GRANULAR", "MOLECULE"}


def will_do(build):
    """That LAMMPS, or an end that says what is wrong with it."""
    lammps, program = Lammps(build, build), os.path.join(build, "lmp")
    remedy = f"set VTI_LAMMPS to the folder of an lmp built as bench/peers/built.py says"
    if not os.access(program, os.X_OK) or os.path.isdir(program):
        sys.exit(f"peers: there is no program {program}; {remedy}")
    release, packages = lammps.release(), lammps.packages()
    if release < FRAMES:
        sys.exit(f"peers: {program} is LAMMPS of {release}, older than that of {FRAMES}; {remedy}")
    if not NEEDED <= packages:
        sys.exit(f"peers: {program} lacks {', '.join(sorted(NEEDED - packages))}; {remedy}")
    return lammps


def largest_gain(lammps, vti_run):
    """Kinetic energy over that at the start, of bonds that turn far in that LAMMPS."""
    with tempfile.TemporaryDirectory() as folder:
        one = Bonded(lammps, vti_run, folder)
        return max(one.largest(spins, 1e-4)[0] for spins in one.spins.values())


def main():
    lammps = will_do(sys.argv[1])
    if len(sys.argv) == 2:
        return
    rounds = int(sys.argv[2])
    print("program,scene,vti_s,lammps_s,ratio,least,most,kinetic,gain")
    gain = largest_gain(lammps, sys.argv[3])
    for vti_run in sys.argv[3:]:
        for kind in (scenes.Pile, scenes.Heap, scenes.Agglomerate, Impact):
            with tempfile.TemporaryDirectory() as folder:
                case = kind(lammps, vti_run, folder)
                kinetic = case.by_lammps_rows(case.h)[-1][1:3].sum()
                print(vti_run, case.scene, *(f"{value:.4g}" for value in (*case.times(rounds), kinetic, gain)), sep=",")


if __name__ == "__main__":
    main()
