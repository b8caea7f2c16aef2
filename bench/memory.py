# SPDX-License-Identifier: BSD-3-Clause
"""What bodies and bonds take:  memory.py VTI-RUN [SMALL LARGE].  Prints CSV: bytes of memory that vti-run holds at
most, by one thread and by two, per body and per bond: the differences between lattices of SMALL^3 and of LARGE^3
spheres (default 40 and 64), and between those with bonds and those without; and per body of lattices whose spheres
touch, by contact alone and with friction and dashpots. Start and libraries are left out so."""
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
TOUCHING = FREE.replace("name: free", "name: touching").replace("spacing: 1}", "spacing: 0.98}\n  diameter: 1") + "contact: {stiffness: 1000}\n"
RUBBING = "friction: {sliding: 0.5, stiffness: 10}\ndashpot: {zeta: 0.1, ratio: 0.5}\n"
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
    """Bytes per body, per bond, per body that touches its neighbours, and per body that rubs on them."""
    def more(scene, effects=""):
        least, most = (peak(vti_run, scene % ((side,) * 3) + effects, threads, folder) for side in (small, large))
        return most - least
    bodies = large**3 - small**3
    bonds = 3 * large**2 * (large - 1) - 3 * small**2 * (small - 1)
    free = more(FREE)
    return (free / bodies, (more(FREE, BONDS) - free) / bonds, more(TOUCHING) / bodies, more(TOUCHING, RUBBING) / bodies)


def main():
    vti_run, (small, large) = sys.argv[1], map(int, sys.argv[2:4] or (40, 64))
    with tempfile.TemporaryDirectory() as folder:
        print("of,one_thread_bytes,two_threads_bytes")
        found = [slopes(vti_run, threads, small, large, folder) for threads in (1, 2)]
        for of, one, two in zip(("body", "bond", "touching", "rubbing"), *found):
            print(f"{of},{one:.0f},{two:.0f}")


if __name__ == "__main__":
    main()
