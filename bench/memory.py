# SPDX-License-Identifier: BSD-3-Clause
"""What a body and a bond take:  memory.py VTI-RUN [SMALL LARGE].  Prints CSV: bytes of memory that vti-run holds at most, by one thread and
by two, per body and per bond: the differences between lattices of SMALL^3 and of LARGE^3 spheres (default 40 and 64), and
between those with bonds and those without. Start and libraries are left out so."""
import os
import subprocess
import sys
import tempfile

FREE = """name: free
bodies:
  lattice: {counts: [%d, %d, %d], spacing: 1}
  mass: 1
  inertia: 0.1
  omega: [0.1, 0.2, 0.3]
stepper: vti2
h: 0.01
t_end: 0.02
"""
BONDS = "binder: {moment: 10, axial: 200, shear: {stiffness: 200}}\n"


def peak(vti_run, scene, threads, folder):
    """Bytes, the most that the process ever had in memory."""
    path = os.path.join(folder, "scene.yaml")
    with open(path, "w", encoding="utf-8") as file:
        file.write(scene)
    command = [vti_run, path, "--no-dump", "--record", "1000000", "--frames", "1000000", "--threads", str(threads), "--force",
               "-o", os.path.join(folder, "out.h5")]
    with open(os.path.join(folder, "said"), "w+", encoding="utf-8") as said, \
            subprocess.Popen(command, stdout=said, stderr=said) as process:
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            said.seek(0)
            sys.exit(f"memory: {' '.join(command)} ended with {process.returncode}: {said.read().strip()}")
    return 1024 * used.ru_maxrss


def slopes(vti_run, threads, small, large, folder):
    """Bytes per body and per bond."""
    free, bound = ([peak(vti_run, FREE % ((side,) * 3) + bonds, threads, folder) for side in (small, large)] for bonds in ("", BONDS))
    bodies = large**3 - small**3
    bonds = 3 * large**2 * (large - 1) - 3 * small**2 * (small - 1)
    more = free[1] - free[0]
    return more / bodies, (bound[1] - bound[0] - more) / bonds


def main():
    vti_run, (small, large) = sys.argv[1], map(int, sys.argv[2:4] or (40, 64))
    with tempfile.TemporaryDirectory() as folder:
        print("threads,body_bytes,bond_bytes")
        for threads in (1, 2):
            print("%d,%.0f,%.0f" % (threads, *slopes(vti_run, threads, small, large, folder)))


if __name__ == "__main__":
    main()
