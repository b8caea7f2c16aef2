#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-only
"""fix nve/vti in LAMMPS with ellipsoids and bodies: against vti-run and fix nve/asphere, nve/body; what it conserves;
ranks and groups; what it refuses; what it costs.
                               check_moments.py PLUGIN WORK_FOLDER COMMAND... ("%d" in it is the number of ranks)
VTI_RUN in the environment is our program."""
import os
import pathlib
import subprocess

import h5py
import numpy

from runs import OURS, check, end, frames, here, start, times, work

BODY = "body nparticle 1 6"
THEIRS = {"ellipsoid": "nve/asphere", BODY: "nve/body"}
EPS = numpy.finfo(float).eps
LAWS = {
    "ellipsoid": {"law": "gayberne 1.0 1.0 1.0 6.0", "strength": "1.0 1.0 1.0 0.7 0.5 1.0 0.7 0.5"},
    BODY: {"law": "body/nparticle 6.0", "strength": "1.0 0.5"},
}
NOTHING = {"law": "zero 1.0", "strength": ""}
AXES = numpy.array([0.5, 0.4, 0.7])  # of the ellipsoids that attract each other
PARTS = numpy.array([[0.3, 0.2, 0.1], [-0.3, 0.2, -0.1], [0.1, -0.4, 0.2], [-0.1, 0.0, -0.2]])  # of such a body


# ---- files of atoms, and what is in their dumps
# -----------------------------------------------------------------------------------


def product(p, q):
    """Of quaternions, real part first."""
    return numpy.concatenate([[p[0] * q[0] - p[1:] @ q[1:]], p[0] * q[1:] + q[0] * p[1:] + numpy.cross(p[1:], q[1:])])


def matrix(q):
    w, x, y, z = q / numpy.linalg.norm(q)
    return numpy.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def solid(axes):
    """The inertia of an ellipsoid of mass 1."""
    squares = axes**2
    return numpy.diag(squares.sum() - squares) / 5


def shared(parts):
    """The inertia of a body of mass 1, which its parts share."""
    return ((parts**2).sum() * numpy.eye(3) - parts.T @ parts) / len(parts)


def write_atoms(style, x, v, spin, axes=AXES, parts=PARTS, inertia=None, points=()):
    """All have mass 1 and the axes of space, and inertia, or that of their parts. points are numbers of those without a
    shape."""
    n, ellipsoids = len(x), style == "ellipsoid"
    lines = ["atoms", "", f"{n} atoms", "1 atom types", f"{n - len(points)} {'ellipsoids' if ellipsoids else 'bodies'}"]
    lines += ["-20 20 xlo xhi", "-20 20 ylo yhi", "-20 20 zlo zhi", "", "Atoms", ""]
    shaped = [i for i in range(1, n + 1) if i not in points]
    lines += [f"{i + 1} 1 {int(i + 1 in shaped)} 1.0 {' '.join(map(repr, map(float, x[i])))}" for i in range(n)]
    lines += ["", "Velocities", ""]
    lines += [f"{i + 1} {' '.join(map(repr, map(float, [*v[i], *spin[i]])))}" for i in range(n)]
    lines += ["", "Ellipsoids" if ellipsoids else "Bodies", ""]
    if ellipsoids:
        lines += [f"{i} {' '.join(repr(float(2 * a)) for a in axes)} 1 0 0 0" for i in shaped]
    else:
        t = shared(parts) if inertia is None else inertia
        six = " ".join(repr(float(t[k])) for k in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)))
        places = " ".join(map(repr, map(float, parts.flatten())))
        lines += [f"{i} 1 {6 + 3 * len(parts)}\n{len(parts)}\n{six}\n{places}" for i in shaped]
    path = work / "atoms.data"
    path.write_text("\n".join(lines) + "\n", encoding="ascii")
    return path


def run(style, move, h, steps, every, ranks=1, law=None, method="", **atoms):
    path = write_atoms(style, **atoms)
    return frames(ranks, "tops.in", move, h, steps, every, style=style, method=method, atoms=path, **(law or LAWS[style]))


def turned(first, last):
    """By what quaternion one has turned; what axes LAMMPS gave it does not matter then."""
    return product(last[6:10], first[6:10] * [1, -1, -1, -1])


def apart(one, other):
    """The largest difference of two frames, where q and -q are the same attitude."""
    sign = numpy.sign((one[:, 6:10] * other[:, 6:10]).sum(axis=1, keepdims=True))
    far = abs(one - other)
    far[:, 6:10] = abs(one[:, 6:10] - sign * other[:, 6:10])
    return far.max()


def energy(s, inertia):
    """Of all, in each frame, from their inertia in the first."""
    total = 0.5 * (s[:, :, 3:6] ** 2).sum(axis=(1, 2)) + s[:, :, 13].sum(axis=1)
    for k, frame in enumerate(s):
        for first, now in zip(s[0], frame):
            r = matrix(turned(first, now))
            total[k] += 0.5 * now[10:13] @ r @ numpy.linalg.solve(inertia, r.T @ now[10:13])
    return total


def momenta(frame):
    x, v, spin = frame[:, 0:3], frame[:, 3:6], frame[:, 10:13]
    return v.sum(axis=0), (numpy.cross(x, v) + spin).sum(axis=0)


# ---- what is checked
# --------------------------------------------------------------------------------------------------------------


def free():
    """scenes/dzhanibekov.yaml with the moments of an ellipsoid of semi-axes 3, 2, 1, in LAMMPS and by vti-run."""
    moments, omega, h, t = [1.0, 2.0, 2.6], [0.01, 1.0, 0.0], 1 / 64, 50.0
    steps, out = round(t * 64), work / "free.h5"
    atoms = {"x": [[0, 0, 0]], "v": [[0, 0, 0]], "spin": [numpy.multiply(moments, omega)]}
    for method in ("vti2", "exact"):
        words = [os.environ["VTI_RUN"], str(here / "../../scenes/dzhanibekov.yaml"), "--force", "--no-dump", "-o", str(out)]
        words += ["--stepper", method, "--h", "1/64", "--t-end", repr(t), "--set", f"bodies.moments={moments}"]
        subprocess.run(words, check=True, capture_output=True, timeout=600)
        with h5py.File(out) as file:
            wanted = file["VTKHDF/PointData/attitude_wxyz"][-1]
        for style, shape in (("ellipsoid", {"axes": numpy.array([3.0, 2.0, 1.0])}), (BODY, {"inertia": numpy.diag(moments)})):
            s = run(style, OURS, h, steps, steps, law=NOTHING, method=method, **atoms, **shape)
            first, last = s[0, 0], s[-1, 0]
            check(last[10:13].tobytes() == first[10:13].tobytes(), f"{method}, {style}: a free one's L keeps its bits")
            turn = turned(first, last)
            far = abs(turn - numpy.sign(turn @ wanted) * wanted).max()
            # A rounding a step in the attitude, which each turning over enlarges by the hundredth that it began with,
            # squared.
            check(far < steps * EPS * 1e4, f"and turns over as by vti-run, but for {far:.1e}")


def pair():
    """Two that attract each other: energies, momenta, and both fixes against each other."""
    atoms = {
        "x": [[-0.6, 0.0, 0.0], [0.6, 0.1, 0.0]],
        "v": [[0.02, 0.03, -0.05], [0.0, -0.02, 0.05]],
        "spin": [[0.05, 0.1, -0.06], [-0.08, 0.02, 0.1]],
    }
    n = 2
    for style, theirs in THEIRS.items():
        t = 10.0 if style == "ellipsoid" else 1.0  # then parts have hooked into each other, and all becomes chaotic
        inertia = solid(AXES) if style == "ellipsoid" else shared(PARTS)
        swing, ends, halves = {}, {}, {}
        for move in (OURS, theirs):
            for h in (0.002, 0.001):
                s = run(style, move, h, round(t / h), 5, **atoms)
                e = energy(s, inertia)
                scale = abs(s[:, :, 13].sum(axis=1)).max()
                swing[move, h], ends[move, h] = abs(e - e[0]).max() / scale, s[-1]
                first, second = numpy.array_split(e, 2)
                halves[move, h] = abs(second.mean() - first.mean()) / scale
                p0, l0 = momenta(s[0])
                p1, l1 = momenta(s[-1])
                if move == OURS:
                    worst = max(abs(p1 - p0).max(), abs(l1 - l0).max())
                    # Forces of order 1 are rounded each step, and so are kicks.
                    check(worst < t / h * n * EPS, f"{style}, h = {h}: linear and angular momentum to rounding ({worst:.1e})")
        print(f"        {style}: energy within {swing[OURS, 0.001]:.2e} ({theirs} {swing[theirs, 0.001]:.2e}), means of the run's"
              f" halves apart by {halves[OURS, 0.001]:.1e} ({halves[theirs, 0.001]:.1e})")
        order = numpy.log2(swing[OURS, 0.002] / swing[OURS, 0.001])
        check(abs(order - 2) < 0.2, f"{style}: the pair's energy swings by order h^2: {order:.2f}")
        coarse, fine = (apart(ends[OURS, h], ends[theirs, h]) for h in (0.002, 0.001))
        order = numpy.log2(coarse / fine)
        check(abs(order - 2) < 0.3, f"and {theirs} goes the same way, but for {coarse:.1e} and {fine:.1e}: order {order:.2f}")


def crowd():
    """27 that attract each other: ranks and groups."""
    grid = numpy.stack(numpy.meshgrid(*[numpy.arange(3) - 1.0] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    push = numpy.random.default_rng(4711)
    atoms = {"x": 1.6 * grid, "v": 0.3 * push.standard_normal(grid.shape), "spin": 0.1 * push.standard_normal(grid.shape)}
    for style in THEIRS:
        one, two, shared_out = (
            run(style, move, 0.002, 300, 300, ranks=ranks, **atoms)[-1] for move, ranks in ((OURS, 1), (OURS, 2), ("two", 1))
        )
        far = apart(one, two)
        check(far < 1e-10, f"{style}: 1 and 2 ranks end at the same place, but for {far:.1e}")
        check(shared_out.tobytes() == one.tobytes(), "two fixes with every other one each end where one fix does, to the last bit")


def refusals():
    none = numpy.zeros((2, 3))
    path = write_atoms("ellipsoid", numpy.array([[0, 0, 0], [5, 0, 0]]), none, none, points=(2,))
    values = {"move": OURS, "h": 0.001, "steps": 1, "every": 1, "out": work / "atoms.dump", "style": "ellipsoid", "atoms": path}
    said = start(1, "tops.in", **values, **NOTHING)
    check(said.returncode != 0 and "atom 2 is a point" in said.stdout, "an atom without a shape is refused by its number")


def cost():
    wide = 12
    n = wide**3
    grid = numpy.stack(numpy.meshgrid(*[numpy.arange(wide)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    path = write_atoms("ellipsoid", 2.0 * (grid - wide / 2), 0.0 * grid, 0.0 * grid + [0.03, 0.02, -0.01])
    theirs, ours, ratio = times(5, 81, r"^Modify +\| ([\d.e+-]+)", scene="aspheres.in", theirs="nve/asphere", style="ellipsoid",
                                atoms=path, **NOTHING)
    print(f"        the fix alone, {n} ellipsoids: {1e9 * ours / n:.1f} ns for each and step, nve/asphere {1e9 * theirs / n:.1f}:"
          f" {ratio:.1f} times")


free()
pair()
crowd()
refusals()
cost()
end()
