#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What vti-run --renumber saves where tables have bodies and bonds in random order: renumber.py VTI_RUN [SIDE [ROUNDS]]

Bonded spheres on a cubic lattice of SIDE^3 (46), in random order; processor time of a step on one thread, without and
with --renumber, each in every round (5). A step is the difference of two runs of 2 and 42 steps."""
import os
import random
import resource
import statistics
import subprocess
import sys
import tempfile

SCENE = """name: shuffled
bodies: {table: bodies.csv, mass: 1, inertia: 0.1}
binder: {table: bonds.csv, moment: 10, axial: 200, shear: {stiffness: 200}}
h: 0.01
t_end: 1
"""


def write_tables(side):
    rng = random.Random(1)
    sites = [(x, y, z) for z in range(side) for y in range(side) for x in range(side)]
    rng.shuffle(sites)
    number = {site: i for i, site in enumerate(sites)}
    bonds = [(i, number[next_to]) for (x, y, z), i in number.items()
             for next_to in ((x + 1, y, z), (x, y + 1, z), (x, y, z + 1)) if next_to in number]
    rng.shuffle(bonds)
    for name, head, rows in (("bodies.csv", "x,y,z", sites), ("bonds.csv", "i,j", bonds)):
        with open(name, "w", encoding="ascii") as file:
            file.write("\n".join([head] + [",".join(map(str, row)) for row in rows]) + "\n")
    with open("shuffled.yaml", "w", encoding="ascii") as file:
        file.write(SCENE)


def seconds(vti_run, steps, *options):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run([vti_run, "shuffled.yaml", "--threads", "1", "--t-end", str(0.01 * steps), "--record", "1000", "--frames",
                    "1000", "--no-dump", *options], check=True, stdout=subprocess.DEVNULL)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def main():
    vti_run = os.path.abspath(sys.argv[1])
    side, rounds = (int(word) for word in (sys.argv[2:] + ["46", "5"][len(sys.argv) - 2:]))
    steps = {(): [], ("--renumber",): []}
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        write_tables(side)
        for _ in range(rounds):
            for options, found in steps.items():
                found.append((seconds(vti_run, 42, *options) - seconds(vti_run, 2, *options)) / 40)
        os.chdir("/")
    for options, found in steps.items():
        print(f"{' '.join(options) or 'as they are':12} {1e3 * statistics.median(found):6.2f} ms a step")
    ratios = [b / a for a, b in zip(*steps.values())]
    print(f"of the time: {statistics.median(ratios):.2f} ({min(ratios):.2f} to {max(ratios):.2f})")


main()
