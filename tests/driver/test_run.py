#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The files of vti-run: columns as the scene has effects, the same numbers in CSV and HDF5, and a trajectory that
independent readers of VTKHDF, XDMF and the LAMMPS dump find to be the same.      test_run.py VTI_RUN SCENES"""
import os
import re
import shutil
import sys
import tempfile
from xml.etree import ElementTree

import h5py
import numpy

from programs import one_line, run
from run_support import contents, read_csv, read_dump, read_vtkhdf, read_xdmf, same
from tally import check, conclude

RUN, SCENES = map(os.path.abspath, sys.argv[1:3])
XYZ = ("x", "y", "z")

GRAVITY = """bodies:
  x: [0, 0, 1]
  v: [1, 0, 0]
  mass: 2
gravity: [0, 0, -10]
h: 1/64
t_end: 1
"""


def columns(translates, turns, *terms):
    return ["t", *["kinetic_translation"] * translates, *["kinetic_rotation"] * turns, *terms, "total", "energy_modified",
            *[f"momentum_{k}" for k in XYZ if translates], *[f"spin_{k}" for k in XYZ if turns],
            *[f"angular_{k}" for k in XYZ]]


BONDS = ("bond", "bond_energy", "bond_stretch")
BINDER = ("binder_moment", "binder_axial", "binder_shear")
# scene, options, columns, bonds, has diameters, mass, inertia
CASES = [
    ("pendulum", [], columns(False, True, "pendulum"), 0, False, None, 1),
    ("pendulum", ["--stepper", "vti3-leapfrog", "--record", "7", "--frames", "100"], columns(False, True, "pendulum"), 0,
     False, None, 1),
    ("spin", ["--h", "0.3"], columns(False, True), 0, False, None, 1),
    ("gravity", ["--stepper", "vti1"], columns(True, False, "gravity"), 0, False, 2, None),
    ("torus", ["--t-end", "0.5"], columns(True, True, *BINDER, "contact", "wall"), 80, True, 1, 1),
    ("chain", ["--t-end", "1", "--stepper", "vti3"], columns(True, True, *BINDER), 9, True, 1, 0.1),
    ("pile", ["--t-end", "1/16", "--frames", "30"], columns(True, False, "contact", "wall", "gravity"), 0, True, 1, None),
]


def energies(stem, names, rows):
    """HDF5 holds the rows of the CSV, to the bit; and they add up."""
    with h5py.File(stem + ".h5") as file:
        group = file["energies"]
        check(group.attrs["columns"].decode().split(",") == names == sorted(group, key=names.index),
              "/energies: the columns of the CSV")
        check(all(numpy.array_equal(group[name][...], rows[:, k]) for k, name in enumerate(names)),
              f"/energies: the numbers of the CSV, {len(rows)} rows")
    parts = [k for k, name in enumerate(names) if 0 < k < names.index("total")]
    parts_size = numpy.abs(rows[:, parts]).sum(axis=1)
    rest = numpy.abs(rows[:, parts].sum(axis=1) - rows[:, names.index("total")])
    # a sum of a few terms in any order
    check((rest <= len(parts) * 2.3e-16 * parts_size).all(), f"total is the sum of its parts to {rest.max():.1e}")


def measures(frames, steps, names, rows, record, mass, inertia):
    """Kinetic energies and momenta recomputed from the trajectory."""
    worst = 0.0
    for frame, step in zip(frames, steps):
        if step % record != 0:
            continue
        row = dict(zip(names, rows[step // record]))
        for energy, momentum, quantity, weight in (("kinetic_translation", "momentum_", "velocity", mass),
                                                   ("kinetic_rotation", "spin_", "omega", inertia)):
            if weight is not None:
                scale = 1 + row[energy] + weight * abs(frame[quantity]).sum()
                errors = [0.5 * weight * (frame[quantity] ** 2).sum() - row[energy],
                          *(weight * frame[quantity].sum(axis=0) - [row[momentum + k] for k in XYZ])]
                worst = max(worst, abs(numpy.array(errors)).max() / scale / len(frame[quantity]))
    check(worst < 1e-15, f"energies and momenta are those of the trajectory, to {worst:.1e} per body")


def x_axis(x, y, z, w):
    """The first column of the matrix of unit quaternions."""
    return numpy.stack([1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)], axis=1)


def turned(q, x):
    """x turned by the unit quaternions q, x y z w."""
    v, w = q[:, :3], q[:, 3:]
    return x + 2 * numpy.cross(v, numpy.cross(v, x) + w * x)


def bond_data(frames, bodies, xdmf, names, rows, stiffness):
    """Energy and stretch of each bond, in VTKHDF behind zeros for the bodies, in XDMF alone, are those of the equations
    for the trajectory's positions and attitudes, and energies add up to the binder's."""
    n, (moment, axial, shear) = bodies, stiffness
    i, j = numpy.array(frames[0]["Lines"]).T
    start = frames[0]["Points"][i] - frames[0]["Points"][j]
    length = numpy.linalg.norm(start, axis=1)
    errors = [0.0, 0.0, 0.0]
    for frame in frames:
        d, q = frame["Points"][i] - frame["Points"][j], frame["attitude_xyzw"]
        r = numpy.linalg.norm(d, axis=1)
        # R_i R_j^T turns by 2 atan(|v|/w) of q_i q_j^-1
        v = q[j, 3:] * q[i, :3] - q[i, 3:] * q[j, :3] - numpy.cross(q[i, :3], q[j, :3])
        theta = 2 * numpy.arctan2(numpy.linalg.norm(v, axis=1), abs((q[i] * q[j]).sum(axis=1)))
        b = turned(q[i], start / length[:, None]) + turned(q[j], start / length[:, None])
        apart = d / r[:, None] - b / numpy.linalg.norm(b, axis=1)[:, None]
        energy = moment / 2 * theta ** 2 + axial / 2 * (r / length - 1) ** 2 + shear * (apart ** 2).sum(axis=1) / 2
        row = dict(zip(names, rows[numpy.argmin(abs(rows[:, 0] - frame["t"]))]))
        errors[0] = max(errors[0], abs(frame["bond_energy"][n:] - energy).max() / (1e-3 + energy.max()))
        errors[1] = max(errors[1], abs(frame["bond_stretch"][n:] - (r / length - 1)).max())
        if row["t"] == frame["t"]:
            errors[2] = max(errors[2], abs(frame["bond_energy"].sum() - sum(row[term] for term in BINDER)))
    # some hundred roundings, of energies beside the largest
    check(errors[0] < 1e-13 and errors[1] < 1e-14, f"each bond's energy and stretch, to {errors[0]:.1e} and {errors[1]:.1e}")
    check(errors[2] < 1e-12, f"energies of the bonds add up to the binder's, to {errors[2]:.1e}")
    check(max(abs(frame["bond_stretch"]).max() for frame in frames) > 1e-4, "... of bonds that are stretched")
    check(all(not frame["bond_energy"][:n].any() and not frame["bond_stretch"][:n].any()
              and frame["bond"].tolist() == [-1] * n + list(range(len(i))) for frame in frames), "vertices have none")
    check(len(xdmf) == len(frames) and all(numpy.array_equal(frame[name][n:], line[name])
          for frame, line in zip(frames, xdmf) for name in ("bond_energy", "bond_stretch")), "XDMF: the same of the bonds")


def walls(frames, planes, grid, diameters):
    """A square for each plane: in it, seen counterclockwise from where the spheres are, and behind all of them at all
    times."""
    x = numpy.concatenate([frame["Points"] for frame in frames])
    radius = numpy.concatenate([frame["diameter"] if diameters else numpy.zeros(len(frame["Points"])) for frame in frames]) / 2
    corners = grid["Points"][grid["cells"].astype(int)]
    size = abs(corners).max()
    good = len(corners) == len(planes) and grid["type"] == "Quadrilateral" and grid["wall"].tolist() == list(range(len(planes)))
    for plane, corner in zip(planes, corners):
        sides = numpy.roll(corner, -1, axis=0) - corner
        lengths = numpy.linalg.norm(sides, axis=1)
        along = sides / lengths[:, None]
        good &= bool(abs(corner @ plane[:3] - plane[3]).max() < 1e-14 * size and abs(lengths - lengths[0]).max() < 1e-14 * size)
        good &= bool(abs(numpy.cross(along, numpy.roll(along, -1, axis=0)) - plane[:3]).max() < 1e-13)
        # how far spheres are inside of each side
        good &= all((((x - start) @ numpy.cross(plane[:3], side)) >= radius - 1e-14 * size).all()
                    for start, side in zip(corner, along))
    check(good, f"XDMF: a square for each of {len(planes)} walls")


def trajectory(stem, names, bonds, diameters):
    frames, dump, xdmf = read_vtkhdf(stem + ".h5"), read_dump(stem + ".dump"), read_xdmf(stem + ".xdmf")
    moving = [name for name, given in (("velocity", "kinetic_translation"), ("omega", "kinetic_rotation"),
                                       ("attitude_xyzw", "kinetic_rotation")) if given in names]
    fixed = ["diameter"] if diameters else []
    data = moving + fixed + ["body"] + (["alpha", "attitude_wxyz", "director"] if "omega" in moving else [])
    expected = {"t", "Points", "Vertices", "Lines", "Polygons", "Strips", *data, *BONDS[:3 * (bonds > 0)]}
    check(all(set(frame) == expected for frame in frames), f"VTKHDF: {len(frames)} frames of {' '.join(data)}")
    n = len(frames[0]["Points"])
    check(all(frame["Vertices"] == [[i] for i in range(n)] and len(frame["Lines"]) == bonds for frame in frames),
          f"VTKHDF: {n} vertices and {bonds} lines")
    check(frames[0]["Lines"] == [[i, (i + 1) % n] for i in range(bonds)], "... which are the bonds, in their order")
    check(all(numpy.array_equal(frame["body"], numpy.arange(n)) for frame in frames), "VTKHDF: bodies by index")
    if "omega" in moving:
        check(all(abs((frame["attitude_xyzw"] ** 2).sum(axis=1) - 1).max() < 1e-15 for frame in frames)
              and all(abs(2 * frame["attitude_xyzw"][:, :3] - frame["alpha"] * frame["attitude_xyzw"][:, 3:]).max() < 1e-15
                      for frame in frames), "VTKHDF: attitudes are unit quaternions, x y z first, of alpha")
        check(all(numpy.array_equal(frame["attitude_wxyz"], numpy.roll(frame["attitude_xyzw"], 1, axis=1)) for frame in frames),
              "VTKHDF: attitude_wxyz is the same with w first")
        check(all(abs(frame["director"] - x_axis(*frame["attitude_xyzw"].T)).max() < 2e-15 for frame in frames),
              "VTKHDF: director is the x axis of each body")
    check(same(frames, dump, ["Points", *moving, *fixed]), "the dump holds the same trajectory")
    check(all((frame["box"][:, 0] < frame["box"][:, 1]).all() and (frame["Points"] >= frame["box"][:, 0]).all()
              and (frame["Points"] <= frame["box"][:, 1]).all() for frame in dump), "... inside its box")
    if diameters:
        radii = numpy.array([frame["diameter"] for frame in frames])[..., None] / 2
        points = numpy.array([frame["Points"] for frame in frames])
        box = numpy.array([(points - radii).min(axis=(0, 1)), (points + radii).max(axis=(0, 1))]).T
        check(all(numpy.array_equal(frame["box"], box) for frame in dump), "... which just holds the spheres of all frames")
    bodies = xdmf.pop("bodies over time")
    check(same(frames, bodies, ["Points", *data]) and all(
        frame["type"] == "Polyvertex" and frame["cells"].tolist() == [[i] for i in range(n)] for frame in bodies),
        "the XDMF index leads to the same trajectory")
    with h5py.File(stem + ".h5") as file:
        planes = file["walls"][...] if "walls" in file else []
    check(("walls" in xdmf) == (len(planes) > 0) == ("wall" in names), "XDMF: walls if the scene has any")
    if "walls" in xdmf:
        walls(frames, planes, xdmf.pop("walls")[0], diameters)
    for lines in xdmf.values():
        check(same(frames, lines, ["Points", *data]) and all(
            frame["type"] == "Polyline" and frame["cells"].tolist() == frames[0]["Lines"] for frame in lines),
            "... and to the bonds")
    check(len(xdmf) == (bonds > 0), "... which exist if the scene has any")
    if bonds > 0:
        bond_data(frames, n, xdmf["bonds over time"], *read_csv(stem + ".csv"), (10, 200, 200))
    return frames, [frame["step"] for frame in dump]


def one_case(base, scene, options, expected, bonds, diameters, mass, inertia):
    print(f"--- {scene} {' '.join(options)}")
    path = f"{base}/gravity.yaml" if scene == "gravity" else os.path.join(SCENES, scene + ".yaml")
    os.mkdir(f"{base}/first")
    stem = f"{base}/first/{scene}"
    result = run(RUN, path, *options, "-o", stem + ".h5")
    check(result.returncode == 0 and result.stderr == "", f"runs and is quiet on stderr {result.stderr}")
    names, rows = read_csv(stem + ".csv")
    record = int(options[options.index("--record") + 1]) if "--record" in options else 1
    check(names == expected, f"columns: {','.join(names)}")
    check(rows[0, 0] == 0 and (rows[1:, 0] > rows[:-1, 0]).all(), "times ascend from 0")
    energies(stem, names, rows)
    frames, steps = trajectory(stem, names, bonds, diameters)
    measures(frames, steps, names, rows, record, mass, inertia)
    check(frames[-1]["t"] == rows[-1, 0], f"rows and frames end at the end of the run, t = {rows[-1, 0]}")
    check(sorted(os.listdir(f"{base}/first")) == sorted(scene + ending for ending in contents(stem)),
          "four files and nothing else are there")
    run(RUN, path, *options, "-o", f"{base}/second/{scene}.h5")
    check(contents(f"{base}/second/{scene}") == contents(stem), "a second run gives the same bytes")
    shutil.rmtree(f"{base}/first")
    shutil.rmtree(f"{base}/second")


def says(base):
    """What is printed at the start is what will be computed."""
    result = run(RUN, f"{SCENES}/pendulum.yaml", "-o", f"{base}/said.h5", "--no-dump")
    check("1 body that turns and does not translate" in result.stdout and "effects: pendulum; no pairs" in result.stdout
          and "stable step of vti2 at rest: 2, set by pendulum at body 0; h is 0.00781 of it" in result.stdout and "energy: " in result.stdout, "it says what it computes")
    check(re.search(r"\nenergy: \S+ at t = 0, \S+ at t = \S+; relative to that at t = 0: change \S+, largest \S+\n", result.stdout),
          "... and how the energy changes")
    free = run(RUN, f"{SCENES}/spin.yaml", "-o", f"{base}/free.h5").stdout
    check("stable step of vti2 at rest: no limit (nothing is in contact or bonded)\n" in free, "... where nothing oscillates, too")
    strong = run(RUN, f"{SCENES}/chain.yaml", "--set", "binder.axial=1", "--set", "bodies.random.v=100", "--t-end", "0.01", "-o",
                 f"{base}/strong.h5").stdout
    check(re.search(r"\nwith bonds strained by up to 1 \(estimated from the energy of single bodies\): no step is sure, for bond \d "
                    r"of bodies \d and \d\n", strong),
          "... and where no step is sure")
    check(not os.path.exists(f"{base}/said.dump") and os.path.exists(f"{base}/said.xdmf"), "--no-dump writes no dump")


def by_a_rival(base):
    """The files of a rival are those of a stepper, but for the modified energy, which is Verlet's, and what runs go on
    from. A step of LAMMPS' turns and moves by the same forces: at this h both are off by less than 1e-5."""
    for stepper in ("exact", "lammps-richardson"):
        result = run(RUN, f"{SCENES}/chain.yaml", "--stepper", stepper, "--h", "2^-12", "--t-end", "1", "--record", "64",
                     "--frames", "512", "-o", f"{base}/{stepper}.h5")
        check(result.returncode == 0, f"{stepper} runs {result.stderr}")
    with h5py.File(f"{base}/exact.h5") as ours, h5py.File(f"{base}/lammps-richardson.h5") as theirs:
        check(theirs.attrs["stepper"] == b"lammps-richardson" and "restart" in ours and "restart" in theirs, "both can go on")
        check(set(ours["energies"]) - set(theirs["energies"]) == {"energy_modified"}, "it has no modified energy")
        for name in ("Points", "PointData/velocity", "PointData/alpha", "PointData/omega"):
            off = numpy.abs(ours[f"VTKHDF/{name}"][...] - theirs[f"VTKHDF/{name}"][...]).max()
            check(0 < off < 1e-5, f"... {name} differ by {off:.1e}")
        total = theirs["energies/total"][...]
        check(len(total) == 65 and abs(total / total[0] - 1).max() < 1e-5, "... and it keeps the energy")


def even_times(base):
    """Frames and rows of their own accord at times with few digits, evenly to the end, 5000 steps for one."""
    result = run(RUN, f"{SCENES}/pendulum.yaml", "--h", "1e-3", "--t-end", "5", "-o", f"{base}/even.h5")
    check("a row every 5 steps (0.005 of time) and a frame every 50 steps (0.05 of time)" in result.stdout, "it says how often it records")
    frames, rows = read_vtkhdf(f"{base}/even.h5"), read_csv(f"{base}/even.csv")[1]
    check([frame["t"] for frame in frames] == [50 * k * 1e-3 for k in range(101)] and
          rows[:, 0].tolist() == [5 * k * 1e-3 for k in range(1001)], "every 0.05 and 0.005 to t = 5")
    with open(f"{base}/even.csv", encoding="ascii") as file:
        check([line.split(",")[0] for line in file.read().split("\n")[1:4]] == ["0", "0.005", "0.01"],
              "numbers are written as the shortest decimal")


def many_frames(base):
    """The index takes more room than what it leads to: of many frames only if asked for, and that of an earlier run
    goes."""
    arguments = [f"{SCENES}/pendulum.yaml", "--h", "1e-3", "--frames", "1", "--record", "100", "--no-dump", "-o", f"{base}/many.h5"]
    for end, options, there in (("2", [], False), ("1.999", [], True), ("2", [], False), ("2", ["--xdmf"], True)):
        result = run(RUN, *arguments, "--t-end", end, *options)
        check(result.returncode == 0 and os.path.exists(f"{base}/many.xdmf") == there and
              ("no .xdmf" in result.stdout) == (not there), f"{1000 * float(end) + 1:.0f} frames {options}: .xdmf {there}")


def loads_kick(base, path, end, *fields):
    """Step for step what --fields writes is what the run was kicked with: VTI-2 kicks by h/2 at both ends of its
    step."""
    result = run(RUN, path, "--stepper", "vti2", "--t-end", end, "--frames", "1", "--fields", ",".join(fields),
                 "-o", f"{base}/loads.h5")
    check(result.returncode == 0, f"{os.path.basename(path)} --fields {','.join(fields)} runs {result.stderr}")
    frames, bodies = read_vtkhdf(f"{base}/loads.h5"), read_xdmf(f"{base}/loads.xdmf")["bodies over time"]
    with h5py.File(f"{base}/loads.h5") as file:
        h = file.attrs["h"]
    weight = {"force": ("velocity", 1), "moment": ("omega", 0.1)}
    for field in fields:
        moved, inertia = weight[field]
        worst = largest = 0.0
        for before, after in zip(frames, frames[1:]):
            kick = h / 2 * (before[field] + after[field]) / inertia
            worst = max(worst, abs(after[moved] - before[moved] - kick).max() / (1 + abs(after[moved]).max()))
            largest = max(largest, abs(kick).max())
        check(worst < 4 * 2.3e-16 and largest > 1e-6,
              f"{field}: the run's own kicks of up to {largest:.1e}, to {worst:.1e}, {len(frames)} frames")
    check(same(frames, bodies, fields), "XDMF: the same")
    return frames


def loads_of_pile(frames):
    """Weight, walls and contacts of all pairs by the equation, K/D (1 - r/D)^{3/2} each, that of a wall with half the
    diameter."""
    worst, touching = 0.0, 0
    for frame in frames[::16]:
        x = frame["Points"]
        force = numpy.zeros_like(x) + [0, 0, -9.81]
        for *normal, offset in ([0, 0, 1, 0], [1, 0, 0, 0], [-1, 0, 0, -4.5], [0, 1, 0, 0], [0, -1, 0, -4.5]):
            overlap = numpy.maximum(0, 1 - (x @ normal - offset) / 0.5)
            force += (1e5 / 0.5 * overlap ** 1.5)[:, None] * normal
        d = x[:, None] - x[None]
        r = numpy.sqrt((d ** 2).sum(axis=2)) + 9 * numpy.eye(len(x))
        pull = 1e5 * numpy.maximum(0, 1 - r) ** 1.5 / r
        touching = max(touching, (pull > 0).sum() // 2)
        force += (pull[..., None] * d).sum(axis=1)
        worst = max(worst, abs(force - frame["force"]).max() / abs(force).max())
    check(worst < 1e-12 and touching > 20, f"pile: forces by the equations to {worst:.1e}, up to {touching} pairs touching")


RUBBING = """name: rubbing
bodies: {lattice: {counts: [2, 2, 2], spacing: 0.99}, diameter: 1, mass: 1, v: [1, 0, -1], random: {seed: 5, v: 0.5, omega: 2}}
contact: {stiffness: 2000}
wall: {stiffness: 2000, planes: [[0, 0, 1, -0.49]], velocities: [[0.5, 0, 0.1]]}
friction: {sliding: 0.5, poisson: 0.3, rolling: 0.1, rolling_stiffness: 50}
gravity: [0, 0, -9.81]
h: 1/1024
t_end: 1/4
"""


def loads(base):
    loads_kick(base, f"{SCENES}/chain.yaml", "1/4", "force", "moment")
    with open(f"{base}/rubbing.yaml", "w", encoding="utf-8") as file:
        file.write(RUBBING)
    loads_kick(base, f"{base}/rubbing.yaml", "1/4", "force", "moment")
    loads_of_pile(loads_kick(base, f"{SCENES}/pile.yaml", "1/4", "force"))
    forces = []
    for stepper in ("srkn11", "srkn14"):
        run(RUN, f"{SCENES}/chain.yaml", "--stepper", stepper, "--t-end", "1/4", "--h", "1/64", "--fields", "force", "-o", f"{base}/end.h5")
        forces.append(read_vtkhdf(f"{base}/end.h5")[-1]["force"])
    far = abs(forces[1] - forces[0]).max() / abs(forces[0]).max()
    check(far < 1e-6, f"a stepper that ends with a drift has the forces where the bodies are: {far:.1e} off one that ends with a kick")


# Bodies of two spheres slide into each other, along a floor that comes up and in a cylinder.
ROLLING = """name: rolling
bodies:
  lattice: {counts: [3, 2, 2], spacing: 1.5, corner: [-1.5, -0.75, 0.5]}
  mass: 1
  clumps: {spheres: [[0, 0, 0, 1], [0.5, 0.25, 0, 0.75]]}
  random: {seed: 5, v: 2, omega: 2}
contact: {stiffness: 2000}
wall: {stiffnesses: [2000, 3000], planes: [[0, 0, 1, -0.125]], cylinders: [[0, 0, 1, 0, 0, 0, 2.5]], velocities: [[0.5, 0, 0.25], [0, 0, 0]]}
friction: {sliding: 0.5, poisson: 0.3}
dashpot: {restitution: 0.5}
gravity: [0, 0, -9.81]
h: 1/1024
t_end: 1/2
"""


def network(path):
    """Frames of bodies, of spheres and of what touches."""
    stem = path.replace(".yaml", "")
    done = run(RUN, path, "--frames", "8", "--fields", "force", "--contacts", "-o", stem + ".h5")
    check(done.returncode == 0 and "-contacts.h5" in done.stdout, f"{os.path.basename(path)} --contacts runs {done.stderr}")
    frames = read_vtkhdf(stem + ".h5")
    spheres = read_vtkhdf(stem + "-spheres.h5") if os.path.exists(stem + "-spheres.h5") else frames
    return frames, spheres, read_vtkhdf(stem + "-contacts.h5")


def sums_of_contacts(name, frames, contacts):
    """Forces of the contacts and the weight are all that --fields force has."""
    worst = 0.0
    for frame, touching in zip(frames, contacts):
        total, inside = numpy.zeros_like(frame["force"]) + [0, 0, -9.81], touching["j"] >= 0
        numpy.add.at(total, touching["i"], touching["force"])
        numpy.add.at(total, touching["j"][inside], -touching["force"][inside])
        worst = max(worst, abs(total - frame["force"]).max() / abs(touching["force"]).max(initial=9.81))
    check(len(contacts) == len(frames) > 10 and worst < 1e-14, f"{name}: forces add up to those of the bodies, to {worst:.1e}")


def places_of_contacts(name, spheres, contacts, gaps):
    """Those spheres touch that overlap, of different bodies, or overlap a wall, and lines lead from one to the other."""
    wrong, far, most = 0, 0.0, 0
    owner = spheres[0]["body"]
    for frame, touching in zip(spheres, contacts):
        x, radius = frame["Points"], frame["diameter"] / 2
        first = touching.get("sphere_i", touching["i"])
        second = touching.get("sphere_j", touching["j"])
        apart = numpy.sqrt(((x[:, None] - x[None]) ** 2).sum(axis=2)) - radius[:, None] - radius
        apart[owner[:, None] == owner] = 1
        wanted = [(i, j) for i, j in zip(*numpy.nonzero(apart < 0)) if i < j]
        gap = gaps(frame["t"], x) - radius
        wanted = sorted(wanted + [(i, -1 - w) for w, i in zip(*numpy.nonzero(gap < 0))])
        wrong += wanted != list(zip(first.tolist(), second.tolist())) or touching["Lines"] != [[2 * k, 2 * k + 1] for k in range(len(first))]
        inside = second >= 0
        ends = touching["Points"].reshape(-1, 2, 3)
        length = numpy.sqrt(((ends[:, 1] - ends[:, 0]) ** 2).sum(axis=1))
        overlap = radius[first] + numpy.where(inside, radius[second], 0) - length
        miss = [abs(ends[:, 0] - x[first]), abs(ends[inside, 1] - x[second[inside]]), abs(overlap - touching["overlap"])]
        if not inside.all():
            foot = gaps(frame["t"], ends[~inside, 1])
            miss += [abs(foot[-1 - second[~inside], numpy.arange(len(foot[0]))])]
        far, most = max([far, *(part.max(initial=0) for part in miss)]), max(most, len(first))
    check(wrong == 0 and far < 1e-14 and most > 8, f"{name}: up to {most} lines between what overlaps, to {far:.1e}")


def laws_of_contacts(name, contacts, lengths, stiffness, sliding):
    """K/L (overlap/L)^{3/2} along the line; friction across it, of at most mu times that."""
    worst, rubbing, most = 0.0, 0.0, 0.0
    for touching in contacts:
        ends = touching["Points"].reshape(-1, 2, 3)
        n = ends[:, 0] - ends[:, 1]
        n /= numpy.sqrt((n ** 2).sum(axis=1))[:, None]
        length, k = lengths(touching), stiffness(touching)
        normal = k / length * (touching["overlap"] / length) ** 1.5
        across = touching["force"] - touching["normal_force"][:, None] * n
        size = numpy.sqrt((across ** 2).sum(axis=1))
        rubbing = max(rubbing, size.max(initial=0))
        scale = 1 + normal
        worst = max([worst, *(abs(part / scale).max(initial=0) for part in (
            normal - touching["normal_force"], size - touching["tangential_force"], (across * n).sum(axis=1)))])
        most = max(most, (size / normal).max(initial=0))
    check(worst < 1e-12 and rubbing > 1, f"{name}: forces by the equations, to {worst:.1e}; friction of up to {rubbing:.3g}")
    check(0.9 * sliding < most < sliding * (1 + 1e-9), f"... which is at most {most / sliding:.12f} of its limit")


def contacts(base):
    """The force network."""
    for name, text in (("rubbing", RUBBING), ("rolling", ROLLING)):
        with open(f"{base}/{name}.yaml", "w", encoding="utf-8") as file:
            file.write(text)
    frames, spheres, touching = network(f"{base}/rubbing.yaml")
    sums_of_contacts("rubbing", frames, touching)
    places_of_contacts("rubbing", spheres, touching, lambda t, x: numpy.array([x[:, 2] + 0.49 - 0.1 * t]))
    laws_of_contacts("rubbing", touching, lambda frame: numpy.where(frame["j"] < 0, 0.5, 1.0), lambda frame: 2000, 0.5)
    frames, spheres, touching = network(f"{base}/rolling.yaml")
    sums_of_contacts("rolling", frames, touching)
    places_of_contacts("rolling", spheres, touching, lambda t, x: numpy.array(
        [x[:, 2] + 0.125 - 0.25 * t, 2.5 - numpy.hypot(x[:, 0], x[:, 1])]))
    radius, owner = spheres[0]["diameter"] / 2, spheres[0]["body"]
    check(all((frame[side] == numpy.where(frame["sphere_" + side] < 0, frame["sphere_" + side], owner[frame["sphere_" + side]])).all()
              for frame in touching for side in "ij"), "bodies are those that have the spheres")
    laws_of_contacts("rolling", touching, lambda frame: radius[frame["sphere_i"]] + numpy.where(
        frame["j"] < 0, 0, radius[frame["sphere_j"]]), lambda frame: numpy.where(frame["j"] == -2, 3000, 2000), 0.5)


MOVING = """name: moving
bodies: {lattice: {counts: [3, 1, 2], spacing: 1}, mass: 1, diameter: 1}
contact: {stiffness: 100}
wall: {stiffness: 100, planes: [[0, 0, 2, -2], [0.6, 0, -0.8, -3]], cylinders: [[0, 2, 0, 1, 2, 0.5, 3]],
  velocities: [[1, 0, 0.25], [0.5, 0, 0], [0.125, 0, 0]], spins: [0, 0, 1]}
h: 1/128
t_end: 2
"""


def moving_walls(base):
    """Shapes and motion of walls in the file, and squares of planes where they are at the time of each frame."""
    path, stem = os.path.join(base, "moving.yaml"), os.path.join(base, "moving")
    with open(path, "w", encoding="ascii") as file:
        file.write(MOVING)
    done = run(RUN, path, "-o", stem + ".h5", "--frames", "64")
    check(done.returncode in (0, 3), f"walls that move: {done.stderr}")
    with h5py.File(stem + ".h5") as file:
        planes, cylinders, velocities, spins = (file["wall" + name][...] for name in ("s", "_cylinders", "_velocities", "_spins"))
    check(abs(planes - [[0, 0, 1, -1], [0.6, 0, -0.8, -3]]).max() < 1e-15 and cylinders.tolist() == [[0, 1, 0, 1, 2, 0.5, 3]],
          "HDF5: planes and cylinders as they are at t = 0")
    check(velocities.tolist() == [[1, 0, 0.25], [0.5, 0, 0], [0.125, 0, 0]] and spins.tolist() == [0, 0, 1],
          "... and how they move")
    grid = read_xdmf(stem + ".xdmf")["walls over time"]
    far = [abs(frame["Points"][4 * k:4 * k + 4] @ planes[k, :3] - planes[k, 3] - planes[k, :3] @ velocities[k] * frame["t"]).max()
           for frame in grid for k in range(2)]
    times = [frame["t"] for frame in read_vtkhdf(stem + ".h5")]
    check([frame["t"] for frame in grid] == times and len(times) == 5 and max(far) < 1e-14, "XDMF: planes where they are")


def odd_name(base):
    """Whatever stands in the name of OUT.h5, OUT.xdmf is XML that says it, and what its readers would take for another
    file is refused."""
    name = "a]]> & <b>\u00e9.h5"
    result = run(RUN, f"{SCENES}/spin.yaml", "--t-end", "1", "-o", f"{base}/{name}")
    with open(f"{base}/{name[:-3]}.xdmf", "rb") as file:
        items = [item.text for item in ElementTree.fromstring(file.read()).iter("DataItem") if item.get("Format") == "HDF"]
    check(result.returncode == 0 and items and all(item.startswith(f"{name}:/VTKHDF/") for item in items), f"XDMF names {name}")
    for name, what in (("b:a.h5", "a colon"), (" a.h5", "a blank in front")):
        result = run(RUN, f"{SCENES}/spin.yaml", "--t-end", "1", "-o", f"{base}/{name}")
        check(one_line(result, f"-o: '{name}' has {what}, and what reads OUT.xdmf would look for another file; choose"), f"... {what}")


def contact_flag(base):
    """Whether bonded bodies touch stands in the file, if the scene has contact at all."""
    def flag(scene, *options):
        result = run(RUN, f"{SCENES}/{scene}.yaml", "--t-end", "1/64", "-o", f"{base}/flag.h5", *options)
        assert result.returncode == 0, result.stderr
        with h5py.File(f"{base}/flag.h5") as file:
            return file.attrs.get("contact.bonded")
    check((flag("torus"), flag("torus", "--set", "contact.bonded=yes"), flag("chain")) == (0, 1, None),
          "contact.bonded is in the file as in the scene")


def notes(base):
    """What a table may have got wrong is said at the start: the deepest overlap, and materials that friction does not
    ask for."""
    def lines(name, table, scene):
        with open(f"{base}/{name}.csv", "w", encoding="ascii") as file:
            file.write(table)
        with open(f"{base}/{name}.yaml", "w", encoding="ascii") as file:
            file.write(f"bodies: {{table: {name}.csv, mass: 1}}\n{scene}h: 1/1024\nt_end: 1/256\n")
        told = []
        for options in ([], ["--renumber"]):
            result = run(RUN, f"{base}/{name}.yaml", "-o", f"{base}/{name}-out.h5", *options)
            told.append([line for line in result.stdout.splitlines() if line.startswith("note: ")])
        check(result.returncode == 0 and told[0] == told[1], f"{name}: {told[0]} {result.stderr.strip()}")
        return told[0]

    start = "x,y,z,diameter\n9,0,0,1\n"
    deep = lines("deep", start + "0,0,0,1\n5,0,0,1\n1.25,0,0,2\n5.75,0,0,1\n", "contact: {stiffness: 1}\n")
    check(len(deep) == 1 and "bodies 2 and 4 overlap by 0.25 of the length" in deep[0], "... the deepest overlap")
    check(not lines("flat", start + "0,0,0,1\n0.95,0,0,1\n", "contact: {stiffness: 1}\n"), "... none below a tenth")
    check(len(lines("wide", start + "0,0,0,3\n1.5,0,0,1\n", "contact: {stiffness: 1}\n")) == 1, "... of spheres that differ, too")
    walls = "wall: {stiffness: 1, planes: [[0, 0, 1, -1], [1, 0, 0, 0]]}\n"
    behind = lines("behind", start + "3,0,0,1\n-1,0,0,2\n0.5,0,5,1\n", walls)
    check(len(behind) == 1 and "body 2 is 2 radii deep in wall 1" in behind[0], "... behind a wall, the deepest")
    check(not lines("beside", start + "0.45,0,0,1\n", walls), "... not below a fifth of its radius")
    pipes = walls.replace("]]", "]], cylinders: [[0, 0, 1, 0, 0, 0, 20], [0, 0, 1, 0, 0, 0, %s]]")
    for radius, word in (("9.6", False), ("0.5", True)):
        narrow = [line for line in lines("narrow", start.replace("9", "0.1"), pipes % radius) if "as wide as wall 3, a cylinder" in line]
        check((len(narrow) == 1 and "body 0" in narrow[0]) == word, f"... in a cylinder of {radius}: {narrow}")
    for moving, damped, word in (("spins: [0, 2]", "", 1), ("velocities: [[0, 0, 0], [0, 1, 3]]", "", 1),
                                 ("velocities: [[0, 0, 0], [1e-3, 1, 3]]", "", None), ("spins: [2, 0]", "dashpot: {normal: 1}\n", None)):
        said = lines("sliding", start, walls.replace("]]}", f"]], {moving}}}") + damped)
        check([f"wall {word} moves along its own face" in line for line in said] == ([] if word is None else [True]),
              f"... a wall that moves to no effect, {moving}: {said}")
    said = lines("unbonded", start, "contact: {stiffness: 1, bonded: yes}\n")
    check(len(said) == 1 and "nothing bonds bodies" in said[0], f"... contacts of bonded bodies, without bonds: {said}")
    for name, table, scene in (("through", "x,y,z,vx,vy,vz\n0,0,0,1,0,0\n2,0,0,-1,0,0\n", "contact: {stiffness: 0.5}\n"),
                               ("into", "x,y,z,vx,vy,vz\n1,0,0,-1,0,0\n", "wall: {stiffness: 0.5, planes: [[1, 0, 0, 0]]}\n")):
        for soft, word in ((scene, True), (scene.replace("0.5", "500"), False)):
            with open(f"{base}/{name}.csv", "w", encoding="ascii") as file:
                file.write(table)
            with open(f"{base}/{name}.yaml", "w", encoding="ascii") as file:
                file.write(f"bodies: {{table: {name}.csv, mass: 1, diameter: 1}}\n{soft}h: 1/1024\nt_end: 2\n")
            result = run(RUN, f"{base}/{name}.yaml", "-o", f"{base}/{name}-out.h5", "--force")
            said = result.stdout.splitlines()[-1]
            check(("enough to pass through" in result.stdout) == word, f"{name}: a warning at the start, if it is {'soft' if word else 'stiff'}")
            check(("of their length deep" in said) == word and said.startswith("verdict: " + ("doubtful" if word else "good")),
                  f"{name}: {said}")
            if not word:  # two of speed 1 have the energy 1, one at a wall, which begins at the radius, 1/2
                energy, length = (1, 1) if name == "through" else (0.5, 0.5)
                with h5py.File(f"{base}/{name}-out.h5") as file:
                    found, deepest = file.attrs["overlap"], (energy / (0.4 * 500)) ** 0.4
                check(abs(found / deepest - 1) < 1e-3, f"... as deep as {found:.4g}, a closed form {deepest:.4g}")
    rub = "friction: {sliding: 0.5, poisson: 0.3}\n"
    one = "contact: {young: 1, poisson: %s}\n" + rub
    check(not lines("same", start, one % "0.3"), "one ratio of Poisson's needs no word")
    other = lines("other", start, one % "0.2")
    check(len(other) == 1 and "friction.poisson = 0.3" in other[0] and "contact.poisson = 0.2 " in other[0], "... another one does")
    wall = lines("wall", start, one % "0.3" + "wall: {young: 1, poisson: 0.25, planes: [[0, 0, 1, -9]]}\n")
    check(len(wall) == 1 and "wall.poisson = 0.25 " in wall[0], "... of a wall")
    each = "x,y,z,diameter,young,poisson\n0,0,0,1,1,0.3\n9,0,0,1,1,0.4\n"
    check(len(lines("each", each, "contact: {}\n" + rub)) == 1 and "poisson = 0.4 of body 1 in the table" in
          lines("each", each, "contact: {}\n" + rub)[0], "... and of a body")
    check(not lines("spring", each, "contact: {}\nfriction: {sliding: 0.5, stiffness: 1}\n"), "... of friction that asks for none")


PARTED = """x,y,z,vx,vy,vz
0,0,5,-0.1,0,0
1,0,5,0.1,0,0
5,0,5,-0.1,0,0
6.0001,0,5,0.1,0,0
10,0,0.5,0,0,0.1
19.5,0,5,-0.1,0,0
"""


def parted(base):
    """Pairs and bodies at walls that have just parted fly freely by multistep methods, too, whose first steps go back
    in time, where they would meet."""
    with open(f"{base}/parted.csv", "w", encoding="ascii") as file:
        file.write(PARTED)
    with open(f"{base}/parted.yaml", "w", encoding="ascii") as file:
        file.write("bodies: {table: parted.csv, mass: 1, diameter: 1}\ncontact: {stiffness: 1000}\nh: 1/64\nt_end: 1\n"
                   "wall: {stiffness: 1000, planes: [[0, 0, 1, 0]], cylinders: [[0, 0, 1, 0, 0, 0, 20]]}\n")
    for stepper in ("an4", "an7", "an9", "an10-mid", "an10-fine"):
        stem = f"{base}/parted-{stepper}"
        done = run(RUN, f"{base}/parted.yaml", "--stepper", stepper, "-o", f"{stem}.h5", "--no-dump")
        names, rows = read_csv(f"{stem}.csv")
        change = numpy.ptp(rows[:, names.index("total")])
        check(done.returncode == 0 and change < 1e-15, f"{stepper}: bodies that have parted fly freely, {change:.1e}")


with tempfile.TemporaryDirectory() as root:
    with open(f"{root}/gravity.yaml", "w", encoding="ascii") as out:
        out.write(GRAVITY)
    for case in CASES:
        one_case(root, *case)
    says(root)
    by_a_rival(root)
    even_times(root)
    many_frames(root)
    moving_walls(root)
    contact_flag(root)
    odd_name(root)
    notes(root)
    loads(root)
    contacts(root)
    parted(root)
conclude()
