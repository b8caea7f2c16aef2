# SPDX-License-Identifier: BSD-3-Clause
"""What a body's step and a bond cost in LAMMPS, by its own clock, beside ours:
    speed.py VENV PACKAGE ROUNDS VTI-BENCH...
Prints CSV. In each round LAMMPS and every build of vti-bench have their turn; ratios are of rounds, their median, least
and largest. vti-bench goes by the processor's time, LAMMPS by the wall's clock: its turns count where it had the core
to itself, as it says."""

import csv
import os
import re
import statistics
import subprocess
import sys

from lammps import Lammps

INNER = 5  # turns of LAMMPS in one round, of which the first warms up
ALONE = 97.0  # percent of a core that LAMMPS has in a turn that counts
# name, variables of step.in, section of LAMMPS' clock, bodies in a row, steps of a turn, cases of vti-bench
CASES = (
    ("nve/sphere", {"style": "sphere", "move": "nve/sphere", "bonds": 0}, "Modify", (10, 46), ("vti2", "vti2 next")),
    (
        "nve/bpm/sphere",
        {"style": "bpm/sphere", "move": "nve/bpm/sphere", "bonds": 0},
        "Modify",
        (10, 46),
        ("vti2", "vti2 next"),
    ),
    (
        "nve/asphere",
        {"style": "ellipsoid", "move": "nve/asphere", "bonds": 0},
        "Modify",
        (10, 46),
        ("three moments: vti2", "three moments: vti2 next"),
    ),
    ("bpm/rotational", {"style": "bpm/sphere", "move": "nve/bpm/sphere", "bonds": 1}, "Bond", (20,), ("bond",)),
)
# of LAMMPS whose bonds have frames: the one that takes the least time; nothing damps, so that all give the same
PARTICLE = ("bpm/rotational particle", {**CASES[-1][1], "frame_style": "frame particle"}, *CASES[-1][2:])
STEPS = {10: 400, 20: 10, 46: 8}


def theirs(lammps, variables, section, wide):
    """Nanoseconds per body, or per bond, and step; None where something else took the core in each turn."""
    said = lammps.run("step.in", **{"frame_style": "", **variables}, wide=wide, steps=STEPS[wide], rounds=INNER)
    taken = [float(word) for word in re.findall(rf"^{section} +\| ([\d.e+-]+)", said, re.MULTILINE)]
    shares = [float(word) for word in re.findall(r"^([\d.]+)% CPU use", said, re.MULTILINE)]
    if not len(taken) == len(shares) == INNER:
        sys.exit(f"speed: LAMMPS gives {len(taken)} times of {section} and {len(shares)} shares of a core, not {INNER}")
    quiet = [time for time, share in zip(taken[1:], shares[1:]) if share >= ALONE]
    if not quiet:
        return None
    items = 3 * wide**2 * (wide - 1) if section == "Bond" else wide**3
    return 1e9 * statistics.median(quiet) / (STEPS[wide] * items)


def ours(program, n):
    """Nanoseconds per item of the packed cases."""
    done = subprocess.run([program, "--only", str(n), "--rounds", "3"], capture_output=True, text=True, check=True)
    rows = csv.DictReader(done.stdout.splitlines())
    return {row["what"]: float(row["median_ns"]) for row in rows if row["layout"] == "packed"}


def write(found):
    """Rows of (name, n, case of vti-bench, program) -> [(ours, theirs) in each round]."""
    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow(["lammps", "n", "what", "build", "ours_ns", "theirs_ns", "ratio", "least", "most"])
    for (name, n, what, program), times in found.items():
        build = os.path.basename(program).removeprefix("vti-bench").removeprefix("-") or "widest"
        mine, their = (statistics.median(side) for side in zip(*times))
        ratios = sorted(t / o for o, t in times)
        writer.writerow(
            [
                name,
                n,
                what,
                build,
                *(f"{x:.4g}" for x in (mine, their, statistics.median(ratios), ratios[0], ratios[-1])),
            ]
        )


def main():
    lammps, rounds, programs = Lammps(*sys.argv[1:3]), int(sys.argv[3]), sys.argv[4:]
    cases = (*CASES, PARTICLE) if lammps.bonds_of_before() else CASES
    found = {}
    for _ in range(rounds):
        for wide in sorted(STEPS):
            mine = {program: ours(program, wide**3) for program in programs}
            for name, variables, section, sizes, whats in cases:
                if wide not in sizes:
                    continue
                their = theirs(lammps, variables, section, wide)
                if their is None:
                    continue
                for program in programs:
                    for what in whats:
                        found.setdefault((name, wide**3, what, program), []).append((mine[program][what], their))
    lost = sorted({name for name, _, _, sizes, _ in cases for wide in sizes if all(key[:2] != (name, wide**3) for key in found)})
    if lost:
        sys.exit(f"speed: LAMMPS never had a core to itself in {', '.join(lost)}; run it where nothing else runs")
    write(found)


if __name__ == "__main__":
    main()
