# SPDX-License-Identifier: BSD-3-Clause
"""What ranks would share:  ranks.py VTI-STUDY.  Runs two studies by one rank and prints CSV: the seconds that each
takes, and that it would take by 2, 4, 8 ... 1024 ranks: a simulation. Ranks take runs (of a sweep: points, with all
their runs) as vti-study hands them out, the longest first (points in order), each as long as it was measured to take.
Each point of a sweep has a reference of its own, which is a part of it; that of a study is taken to be shared by none,
as start and files are. What messages take is left out. Points are taken AGAIN times, so that there are enough of them
for the most ranks."""
import csv
import heapq
import os
import subprocess
import sys
import tempfile
import time

SCENE = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "scenes", "pendulum.yaml")
RANKS = [1 << k for k in range(11)]
STUDY = ["--steppers", "vti1,vti2,vti3,exact", "--h", "2^-4:2^-15", "--t-end", "200"]
SWEEP = ["--steppers", "vti1,vti2,vti3,exact", "--h", "2^-4:2^-11", "--t-end", "20", "--sweep", "pendulum.weight=1:2:1/255"]
AGAIN = 16


def wall(command):
    beside = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_pml": "ob1"}
    start = time.monotonic()
    done = subprocess.run(["mpirun", "-n", "1", *command], env=beside, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"ranks: {' '.join(command)} ended with {done.returncode}: {done.stderr.strip()}")
    return time.monotonic() - start


def measured(vti_study, options):
    """Seconds of the whole, and the rows of its runs."""
    with tempfile.TemporaryDirectory() as folder:
        whole = wall([vti_study, SCENE, *options, "--no-plot", "-o", os.path.join(folder, "study")])
        with open(os.path.join(folder, "study", "timing.csv"), encoding="utf-8", newline="") as file:
            return whole, list(csv.DictReader(file))


def of_study(_, whole, rows):
    """What is left for each rank to do, and a task for each run, those of the most steps first."""
    tasks = [float(row["seconds"]) for row in sorted(rows, key=lambda row: float(row["h"]))]
    return max(whole - sum(tasks), 0.0), tasks


def of_sweep(start, whole, rows):
    """The same; a task for each point."""
    points = {}
    for row in rows:
        points[row["pendulum.weight"]] = points.get(row["pendulum.weight"], 0.0) + float(row["seconds"])
    reference = max(whole - start - sum(points.values()), 0.0) / len(points)
    return start, AGAIN * [seconds + reference for seconds in points.values()]


def makespan(tasks, ranks):
    """Until the last task is done, if each rank takes the next one as soon as it is free."""
    free = [0.0] * ranks
    for seconds in tasks:
        heapq.heappush(free, heapq.heappop(free) + seconds)
    return max(free)


def main():
    print("what,tasks,ranks,seconds")
    vti_study = sys.argv[1]
    start = wall([vti_study, "--version"])
    for what, options, of in (("study", STUDY, of_study), ("sweep", SWEEP, of_sweep)):
        rest, tasks = of(start, *measured(vti_study, options))
        for ranks in RANKS:
            print(f"{what},{len(tasks)},{ranks},{rest + makespan(tasks, ranks):.4g}")


if __name__ == "__main__":
    main()
