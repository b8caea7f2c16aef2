# SPDX-License-Identifier: BSD-3-Clause
"""What a body's step, a bond and a touching pair cost in LIGGGHTS and YADE, by their own clocks, beside ours:
    codes.py ROUNDS VTI-BENCH...
Of those of the two that are installed. Prints CSV as speed.py does, which says how turns go; each of them counts its
turns where it had a core to itself."""

import functools
import os
import re
import shutil
import statistics
import sys
import tempfile

from lammps import finished
from speed import ALONE, ours, write

HERE = os.path.dirname(os.path.abspath(__file__))
STEPS = {"liggghts": {10: 4000, 46: 20}, "yade": {10: 1000, 46: 8}}  # by bodies in a row
PAIR = "touching pair, friction, dashpots"


def of_turns(turns):
    """The median of what was taken in turns (share of a core in percent, ns) that count, or None."""
    quiet = [ns for share, ns in turns if share >= ALONE]
    return statistics.median(quiet) if quiet else None


def clocked(command, **more):
    """What it says, and its seconds of a processor and of the wall's clock."""
    start = os.times()
    said = finished(command, **more)
    end = os.times()
    used = end.children_user + end.children_system - start.children_user - start.children_system
    return said, used, end.elapsed - start.elapsed


@functools.cache
def waits():
    """Seconds that LIGGGHTS sleeps at its start, in MPI."""
    _, used, took = clocked(["liggghts", "-log", "none", "-in", os.devnull])
    return max(took - used, 0.0)


def liggghts(wide, spacing):
    """Percent of a core in all of the run but its start, and ns of body and of pair in each round; the first warms
    up."""
    with tempfile.TemporaryDirectory() as folder:
        command = ["liggghts", "-log", "none", "-in", os.path.join(HERE, "liggghts.in"), "-var", "wide", str(wide), "-var", "spacing",
                   str(spacing), "-var", "steps", str(STEPS["liggghts"][wide])]
        said, used, took = clocked(command, cwd=folder)
    share = 100 * used / (took - waits())
    pair, other = ([float(word) for word in re.findall(rf"^{section} +time \(%\) = ([\d.e+-]+)", said, re.MULTILINE)][1:]
                   for section in ("Pair", "Other"))
    pairs = int(re.findall(r"^Total # of neighbors = (\d+)", said, re.MULTILINE)[-1])
    wanted = 3 * wide**2 * (wide - 1)
    if pairs not in ((wanted,) if spacing < 1 else (0, wanted)) or len(pair) != 4:
        sys.exit(f"codes: LIGGGHTS has {pairs} pairs and {len(pair)} rounds, not {wanted} and 4")
    return (share, [1e9 * seconds / (STEPS["liggghts"][wide] * wide**3) for seconds in other],
            [1e9 * seconds / (STEPS["liggghts"][wide] * max(pairs, 1)) for seconds in pair])


def theirs_liggghts(wide):
    share, bodies, _ = liggghts(wide, 1)
    share_pairs, _, pairs = liggghts(wide, 0.98)
    return {("LIGGGHTS nve/sphere", "vti2"): of_turns([(share, ns) for ns in bodies]),
            ("LIGGGHTS gran", PAIR): of_turns([(share_pairs, ns) for ns in pairs])}


def theirs_yade(wide):
    said = finished(["yade", "-n", "-x", "-j1", os.path.join(HERE, "yade_step.py")],
                    env={**os.environ, "WIDE": str(wide), "STEPS": str(STEPS["yade"][wide])})
    rounds = [tuple(map(float, line.split()[1:])) for line in re.findall(r"^round .*$", said, re.MULTILINE)]
    wanted = 3 * wide**2 * (wide - 1)
    if len(rounds) != 5 or any(bonds != wanted for _, bonds, _, _ in rounds):
        sys.exit(f"codes: YADE gives {len(rounds)} rounds of {sorted({bonds for _, bonds, _, _ in rounds})} bonds, not 5 of {wanted}")
    return {("YADE NewtonIntegrator", "vti2"): of_turns([(share, ns) for share, _, ns, _ in rounds]),
            ("YADE CohesionMoment", "bond"): of_turns([(share, ns) for share, _, _, ns in rounds])}


def main():
    rounds, programs = int(sys.argv[1]), sys.argv[2:]
    codes = [code for name, code in (("liggghts", theirs_liggghts), ("yade", theirs_yade)) if shutil.which(name)]
    if not codes:
        sys.exit("codes: neither liggghts nor yade is installed")
    found = {}
    for _ in range(rounds):
        for wide in sorted(STEPS["yade"]):
            mine = {program: ours(program, wide**3) for program in programs}
            for cases in mine.values():
                cases[PAIR] = (cases["body that rubs"] - cases["vti2"]) / (3 * (1 - 1 / wide))
            for (name, what), their in ((key, ns) for code in codes for key, ns in code(wide).items()):
                for program in programs if their is not None else ():
                    found.setdefault((name, wide**3, what, program), []).append((mine[program][what], their))
    if not found:
        sys.exit("codes: they never had a core to themselves; run it where nothing else runs")
    write(found)


if __name__ == "__main__":
    main()
