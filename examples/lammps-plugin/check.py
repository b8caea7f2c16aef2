#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-only
"""fix nve/vti in LAMMPS: what it conserves, that ranks do not matter, that spheres without an attitude go as those with
one, and what it costs beside fix nve/bpm/sphere.
                                       check.py PLUGIN WORK_FOLDER COMMAND... ("%d" in it is the number of ranks)"""

import numpy

from runs import OURS, check, end, frames, lammps, times, work

THEIRS = "nve/bpm/sphere"
J = 0.4 * 0.5**2


def momenta(s):
    """Linear momentum, and angular about the origin, which a moment of the bonds that does not balance their forces
    would break."""
    x, v, omega = s[:, 0:3], s[:, 3:6], s[:, 10:13]
    return v.sum(axis=0), (numpy.cross(x, v) + J * omega).sum(axis=0)


def block():
    size = {"long": 6, "wide": 4}
    drift = {}
    for move, ranks in ((OURS, 1), (OURS, 2), (THEIRS, 1)):
        first, last = frames(ranks, "block.in", move, 0.001, 400, 400, bonds=1, **size)
        (p0, l0), (p1, l1) = momenta(first), momenta(last)
        drift[move, ranks] = abs(p1 - p0).max() / abs(p0).max(), abs(l1 - l0).max() / abs(l0).max(), last
        print(f"        {move} on {ranks}: linear momentum changes by {drift[move, ranks][0]:.1e}, angular by {drift[move, ranks][1]:.1e}"
              " of itself in 400 steps")
    n, eps = 96, numpy.finfo(float).eps
    for ranks in (1, 2):
        p, l, _ = drift[OURS, ranks]
        check(p < 400 * n * eps, f"{ranks} ranks: linear momentum to rounding ({p:.1e})")
        # Kicks and drifts keep it to rounding; what is lost are bond forces and moments that do not quite balance.
        check(l < 2 * drift[THEIRS, 1][1] + 400 * n * eps, f"{ranks} ranks: angular momentum as the bond style has it ({l:.1e})")
    far = abs(drift[OURS, 1][2] - drift[OURS, 2][2]).max()
    # The bond style takes angles by acos near 1, where a rounding is an angle of 1e-8.
    check(far < 1e-8, f"1 and 2 ranks end at the same place, but for {far:.1e}")
    shared = frames(1, "block.in", "two", 0.001, 400, 400, bonds=1, **size)[-1]
    check(shared.tobytes() == drift[OURS, 1][2].tobytes(), "two fixes with every other sphere each end where one fix does, to the last bit")


def pair_energy(s):
    """Of two spheres on a line with the bond of scene.in, which stretch (Kr = 1000) and twist (Kt = 50) it."""
    x, v, q, omega = s[:, :, 0:3], s[:, :, 3:6], s[:, :, 6:10], s[:, :, 10:13]
    kinetic = 0.5 * (v**2).sum(axis=(1, 2)) + 0.5 * J * (omega**2).sum(axis=(1, 2))
    stretch = numpy.linalg.norm(x[:, 1] - x[:, 0], axis=1) - 1.0
    twist = 2 * (numpy.arctan2(q[:, 1, 1], q[:, 1, 0]) - numpy.arctan2(q[:, 0, 1], q[:, 0, 0]))
    twist = (twist + numpy.pi) % (2 * numpy.pi) - numpy.pi
    return kinetic + 500.0 * stretch**2 + 25.0 * twist**2


def energy():
    swing, halves, ends = {}, {}, {}
    for move in (OURS, THEIRS):
        for h in (0.002, 0.001):
            steps = round(20 / h)
            s = frames(1, "pair.in", move, h, steps, 1, bonds=1, long=2, wide=1)
            e = pair_energy(s)
            swing[move, h] = abs(e / e[0] - 1).max()
            first, second = numpy.array_split(e, 2)
            halves[move, h] = abs(second.mean() / first.mean() - 1)
            ends[move, h] = s[-1]
    for h in (0.002, 0.001):
        print(f"        h = {h}: energy within {swing[OURS, h]:.2e} ({THEIRS}: {swing[THEIRS, h]:.2e}), from the first half of the run to"
              f" the second {halves[OURS, h]:.1e} ({halves[THEIRS, h]:.1e})")
    order = numpy.log2(swing[OURS, 0.002] / swing[OURS, 0.001])
    check(abs(order - 2) < 0.2, f"the pair's energy swings by order h^2: {order:.2f}")
    check(halves[OURS, 0.001] < 0.05 * swing[OURS, 0.001], f"and does not drift: {halves[OURS, 0.001]:.1e} between halves")
    apart = [abs(ends[OURS, h] - ends[THEIRS, h]).max() for h in (0.002, 0.001)]
    order = numpy.log2(apart[0] / apart[1])
    check(abs(order - 2) < 0.3, f"both fixes go the same way, but for {apart[0]:.1e} and {apart[1]:.1e}: order {order:.2f}")


def grains():
    """Spheres with friction fall onto a plane and each other: LAMMPS' usual ones, which have a spin and no attitude."""
    size, steps, out = 4, 400, work / "grains.dump"
    ends = {}
    for style, move in (("sphere", OURS), ("bpm/sphere", OURS), ("sphere", "nve/sphere")):
        lammps(1, "grains.in", style=style, move=move, wide=size, steps=steps, out=out)
        rows = [line.split()[1:] for line in out.read_text(encoding="utf-8").split("omegaz\n")[-1].splitlines()]
        ends[style, move] = numpy.array(rows, dtype=float)
    plain, turned, theirs = ends.values()
    check(plain.shape == (size**3, 9) and abs(plain[:, 6:9]).max() > 0.1, "spheres that fall and rub begin to spin")
    check(plain.tobytes() == turned.tobytes(), "positions, velocities and spins without an attitude are those with one, to the last bit")
    far = abs(plain - theirs).max()
    # The same map, kick, drift, kick; only a product or two are taken in another order. That is a rounding of each
    # number and step, which contacts of stiffness 1e4 enlarge, but in 400 steps do not make chaotic.
    check(far < 400 * 1e4 * numpy.finfo(float).eps, f"and those of fix nve/sphere, but for roundings: {far:.1e}")


def cost():
    wide = 12
    n, scene = wide**3, {"scene": "scene.in", "theirs": THEIRS, "long": wide, "wide": wide}
    theirs, ours, ratio = times(20, 41, r"^Modify +\| ([\d.e+-]+)", bonds=0, **scene)
    print(f"        the fix alone, {n} spheres: {1e9 * ours / n:.1f} ns for each and step, {THEIRS} {1e9 * theirs / n:.1f}:"
          f" {ratio:.1f} times")
    theirs, ours, ratio = times(5, 41, r"^Loop time of ([\d.e+-]+)", bonds=1, **scene)
    print(f"        whole steps with LAMMPS' bonds: {1e9 * ours / n:.0f} ns, {THEIRS} {1e9 * theirs / n:.0f}: {ratio:.2f} times")


said = lammps(1, "block.in", move=OURS, h=0.001, steps=1, every=1, out=work / "one.dump", bonds=1, long=2, wide=2)
check("loaded into" not in said and "Loading plugin" in said, "LAMMPS loads the plugin, and is the version that it was built for")
block()
energy()
grains()
cost()
end()
