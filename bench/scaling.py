# SPDX-License-Identifier: BSD-3-Clause
"""What cores share:  scaling.py VTI-RUN VTI-STUDY CORES [ROUNDS].  Prints CSV: seconds of one scene's steps by 1, 2, 4
... CORES threads; of as many runs of one thread at once, which share nothing but the machine; and of whole studies by
as many ranks. Each the median and the least of rounds in which all have their turn."""
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
SCENES = os.path.join(os.path.dirname(HERE), "scenes")
FEW, MANY = 2, 502  # steps; their difference leaves out start and files
STUDIES = {"study of the pendulum": ["pendulum.yaml", "--steppers", "vti1,vti2,vti3,exact", "--h", "2^-4:2^-15", "--t-end", "200"],
           "study of the torus": ["torus.yaml", "--steppers", "vti1,vti2,exact", "--h", "1/1000:1/32000", "--t-end", "10"]}


def seconds(commands, beside):
    """Until all of them, begun at once, have come to their end."""
    start = time.monotonic()
    begun = [subprocess.Popen(command, env=beside, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) for command in commands]
    said = [process.communicate()[1] for process in begun]
    for command, process, words in zip(commands, begun, said):
        if process.returncode != 0:
            sys.exit(f"scaling: {' '.join(command)} ended with {process.returncode}: {words.strip()}")
    return time.monotonic() - start


def steps(vti_run, threads, runs, folder, beside):
    """Seconds of MANY - FEW steps of the lattice, in each of so many runs at once."""
    took = [seconds([[vti_run, os.path.join(HERE, "lattice.yaml"), "--no-dump", "--record", "1000000", "--frames", "1000000", "--threads",
                      str(threads), "--t-end", str(0.01 * count), "-o", os.path.join(folder, f"lattice{run}.h5"), "--force"]
                     for run in range(runs)], beside) for count in (FEW, MANY)]
    return took[1] - took[0]


def study(vti_study, what, ranks, folder, beside):
    out = os.path.join(folder, "study")
    shutil.rmtree(out, ignore_errors=True)
    scene, *options = STUDIES[what]
    return seconds([["mpirun", "-n", str(ranks), vti_study, os.path.join(SCENES, scene), *options, "--no-plot", "-o", out]], beside)


def main():
    vti_run, vti_study, cores = sys.argv[1], sys.argv[2], int(sys.argv[3])
    rounds = int(sys.argv[4]) if len(sys.argv) > 4 else 3
    workers = [1 << k for k in range(cores.bit_length()) if 1 << k <= cores]
    beside = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_pml": "ob1"}
    took = {}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(rounds):
            for n in workers:
                took.setdefault(("lattice", n), []).append(steps(vti_run, n, 1, folder, beside))
                took.setdefault(("lattices at once", n), []).append(steps(vti_run, 1, n, folder, beside))
                for what in STUDIES:
                    took.setdefault((what, n), []).append(study(vti_study, what, n, folder, beside))
    print("what,workers,median_s,least_s")
    for (what, n), times in sorted(took.items()):
        print(f"{what},{n},{statistics.median(times):.4g},{min(times):.4g}")


if __name__ == "__main__":
    main()
