# SPDX-License-Identifier: BSD-3-Clause
"""What measuring adds to a step:  study_step.py VTI-STUDY [ROUNDS [H]].  Prints CSV: nanoseconds of a step of the
paper's pendulum alone and of one that a study compares with the reference and takes energies and momenta of, and their
ratio. In each round both have their turn, one after the other; medians of the rounds, the ratio's least and largest
too."""
import csv
import os
import statistics
import subprocess
import sys
import tempfile

SCENE = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "scenes", "pendulum.yaml")
STEPPERS = ("vti1", "vti2", "exact")


def row_of(folder, name, *command):
    """The row that a study of one run leaves in its file of that name."""
    done = subprocess.run([*command, "--force", "-o", folder], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"study_step: {' '.join(command)} ended with {done.returncode}: {done.stderr.strip()}")
    with open(os.path.join(folder, name), encoding="utf-8", newline="") as file:
        return next(csv.DictReader(file))


def round_of(study, stepper, h, folder):
    """Nanoseconds of the bare step and of the study's."""
    what = [study, SCENE, "--steppers", stepper, "--h", h]
    alone = row_of(os.path.join(folder, "cost"), "cost.csv", *what, "--cost", "--repeats", "1")
    measured = row_of(os.path.join(folder, "study"), "timing.csv", *what, "--no-plot")
    return 1e9 * float(alone["seconds"]) / float(alone["steps"]), float(measured["ns_per_step"])


def main():
    study = sys.argv[1]
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 9
    h = sys.argv[3] if len(sys.argv) > 3 else "2^-18"
    with tempfile.TemporaryDirectory() as folder:
        took = [[round_of(study, stepper, h, folder) for stepper in STEPPERS] for _ in range(rounds)]
    print("stepper,step_ns,study_ns,ratio,least,most")
    for stepper, pairs in zip(STEPPERS, zip(*took)):
        ratios = [study_ns / step_ns for step_ns, study_ns in pairs]
        values = [*(statistics.median(column) for column in zip(*pairs)), statistics.median(ratios), min(ratios), max(ratios)]
        print(",".join([stepper, *(f"{value:.4g}" for value in values)]))


if __name__ == "__main__":
    main()
