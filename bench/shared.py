# SPDX-License-Identifier: BSD-3-Clause
"""What threads share of a step:  shared.py VTI-RUN.  Prints CSV: instructions of a step of bench/lattice.yaml per body,
and of these the ones in parts that any thread may take, by callgrind: differences of two runs, so that start and files
are left out."""
import os
import re
import shutil
import subprocess
import sys
import tempfile

SCENE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "lattice.yaml")
BODIES, H, FEW, MANY = 46**3, 0.01, 16, 32
# what drivers/ gives to threads_sum
PARTS = {"one_slice", "follow_part", "one_group", "search_part", "part_has_moved"}


def counted(vti_run, steps):
    """Instructions of the whole program, and of the parts."""
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "out")
        command = ["valgrind", "--tool=callgrind", "--compress-strings=no", f"--callgrind-out-file={out}", vti_run, SCENE, "--no-dump",
                   "--record", "1000000", "--frames", "1000000", "--threads", "2", "--t-end", str(H * steps), "--force",
                   "-o", os.path.join(folder, "lattice.h5")]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            sys.exit(f"shared: {' '.join(command)} ended with {done.returncode}: {done.stderr.strip()[-500:]}")
        return int(re.search(r"Collected : (\d+)", done.stderr)[1]), in_parts(out)


def in_parts(path):
    with open(path, encoding="utf-8") as file:
        lines = file.read().splitlines()
    taken, callee = 0, None
    for line, after in zip(lines, lines[1:]):
        if line.startswith("cfn="):
            callee = re.sub(r"'\d+$", "", line[4:])
        elif line.startswith("calls=") and callee in PARTS:
            taken += int(after.split()[-1])
    return taken


def main():
    if shutil.which("valgrind") is None:
        sys.exit("shared: valgrind is not installed; no instructions are counted")
    few, many = (counted(sys.argv[1], steps) for steps in (FEW, MANY))
    every, parts = ((late - early) / ((MANY - FEW) * BODIES) for early, late in zip(few, many))
    if not 0 < parts:
        sys.exit(f"shared: no instructions in {', '.join(sorted(PARTS))}, which are the parts that threads take")
    print("instructions,shared")
    print(f"{every:.5g},{parts:.5g}")


if __name__ == "__main__":
    main()
