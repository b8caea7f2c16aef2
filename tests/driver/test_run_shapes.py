#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What files and pictures show of bodies that are no spheres: ellipsoids as tensors, shapes and outlines, clumps as
spheres, and the force network. test_run_shapes.py VTI_RUN VTI_PLOT"""
import os
import sys
import tempfile

import h5py
import numpy

from plot_support import plot
from programs import run
from run_support import read_vtkhdf, read_xdmf, same
from tally import check, conclude

RUN, PLOT = map(os.path.abspath, sys.argv[1:3])
sys.path.insert(0, os.path.dirname(PLOT))
from plot import outlines  # noqa: E402
from plot import network_file  # noqa: E402
from plot.run_file import read_run  # noqa: E402

MASS, HALF = 3.0, numpy.array([1.0, 2.0, 3.0])      # of solid ellipsoids
MOMENTS = [MASS / 5 * (sum(HALF ** 2) - half ** 2) for half in HALF]
ELLIPSOIDS = f"""bodies: {{chain: {{count: 2, spacing: 2}}, mass: {MASS!r}, moments: {MOMENTS!r}, principal: [0.5, 1, -2],
         omega: [1, 2, 3], random: {{seed: 1, alpha: 2}}}}
binder: {{axial: 10, moment: 3}}
h: 1/64
t_end: 1
"""
CLUMPS = """bodies: {chain: {count: 3, spacing: 3}, random: {seed: 2, v: 1, omega: 2, alpha: 2},
         clumps: {spheres: [[1, 0, 0, 1], [0, 1, 0, 2], [0, 0, 0, 3]], counts: [2, 1], density: 1}}
contact: {stiffness: 10}
h: 1/64
t_end: 1
"""

PRESSED = """bodies: {lattice: {counts: [4, 3, 2], spacing: 0.99, corner: [0, 0, 0.495]}, diameter: 1, mass: 1, random: {seed: 4, v: 0.3}}
contact: {stiffness: 1000}
wall: {stiffness: 1000, planes: [[0, 0, 1, 0]]}
friction: {sliding: 0.5, poisson: 0.3}
h: 1/1024
t_end: 1/32
"""


def turn(q):
    """Rotation matrices of unit quaternions x, y, z, w."""
    x, y, z, w = numpy.moveaxis(q, -1, 0)
    rows = [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]
    return numpy.moveaxis(numpy.array(rows), (0, 1), (-2, -1))


def written(folder, name, scene):
    """Datasets of the HDF5 file, and columns of the dump, frame after frame."""
    path = os.path.join(folder, name)
    with open(path + ".yaml", "w", encoding="ascii") as file:
        file.write(scene)
    done = run(RUN, path + ".yaml", "-o", path + ".h5", "--frames", "16")
    check(done.returncode == 0, f"{name}: runs {done.stderr}")
    with h5py.File(path + ".h5") as file:
        data = {key: file[key][...] for key in ("VTKHDF/Points", "VTKHDF/PointData/attitude_xyzw", "VTKHDF/PointData/ellipsoid",
                                                "VTKHDF/PointData/velocity", "VTKHDF/PointData/omega")}
        data.update({f"clumps/{key}": item[...] for key, item in file.get("clumps", {}).items()})
    with open(path + ".dump", encoding="ascii") as file:
        blocks = file.read().split("ITEM: ATOMS ")[1:]
    rows = numpy.array([line.split() for block in blocks for line in block.split("ITEM:")[0].splitlines()[1:]], float)
    return {key.rsplit("/", 1)[-1] if "clumps" not in key else key: item for key, item in data.items()}, dict(
        zip(blocks[0].splitlines()[0].split(), rows.T))


def stacked(dump, *names):
    return numpy.stack([dump[name] for name in names], axis=-1)


def near(one, other):
    return one.shape == other.shape and numpy.allclose(one, other, rtol=0, atol=1e-12 * abs(other).max())


def ellipsoids(folder):
    data, dump = written(folder, "ellipsoids", ELLIPSOIDS)
    tensors = data["ellipsoid"].reshape(-1, 3, 3)
    check(near(numpy.linalg.eigvalsh(tensors), numpy.tile(2 * HALF, (len(tensors), 1))), "eigenvalues are the whole axes")
    angle = 2 * numpy.arctan(numpy.linalg.norm([0.5, 1, -2]) / 2)       # of principal, 2 tan(angle/2) long
    axis = numpy.array([0.5, 1, -2]) / numpy.linalg.norm([0.5, 1, -2])
    principal = turn(numpy.append(axis * numpy.sin(angle / 2), numpy.cos(angle / 2)))
    axes = turn(data["attitude_xyzw"]) @ principal
    check(near(tensors, axes @ numpy.diag(2 * HALF) @ numpy.swapaxes(axes, -1, -2)), "they lie along the principal axes")
    shape = stacked(dump, "shapex", "shapey", "shapez")
    check("radius" not in dump and near(shape, numpy.tile(2 * HALF, (len(tensors), 1))), "the dump has them, too")
    shown = turn(stacked(dump, "quati", "quatj", "quatk", "quatw"))
    check(near(shown @ numpy.diag(2 * HALF) @ numpy.swapaxes(shown, -1, -2), tensors), "... and the same ellipsoids")
    # half of |E e_j|
    reach, bounds = numpy.sqrt(numpy.einsum("ijj->ij", tensors @ tensors)) / 2, box(folder, "ellipsoids")
    check((data["Points"] - reach >= bounds[:, 0]).all() and (data["Points"] + reach <= bounds[:, 1]).all(), "... in a box that holds them")


def box(folder, name):
    """Of the first frame of the dump; all have the same."""
    with open(os.path.join(folder, name + ".dump"), encoding="ascii") as file:
        return numpy.array([line.split() for line in file.read().split("ff ff ff\n")[1].splitlines()[:3]], float)


def clumps(folder):
    data, dump = written(folder, "clumps", CLUMPS)
    body, frames = data["clumps/body"], len(data["Points"]) // 3
    check(body.tolist() == [0, 0, 1, 2, 2], f"bodies of spheres: {body}")
    all_bodies = (numpy.arange(frames)[:, None] * 3 + body).ravel()
    lever = numpy.einsum("ijk,ik->ij", turn(data["attitude_xyzw"])[all_bodies], numpy.tile(data["clumps/offset"], (frames, 1)))
    check(near(stacked(dump, "x", "y", "z"), data["Points"][all_bodies] + lever), "spheres are where R rho says")
    check(near(stacked(dump, "vx", "vy", "vz"), data["velocity"][all_bodies] + numpy.cross(data["omega"][all_bodies], lever)),
          "... with the velocities of their bodies there")
    check(numpy.array_equal(dump["mol"], numpy.tile(body + 1.0, frames)), "mol is their body")
    check(near(dump["radius"], numpy.tile(data["clumps/diameter"] / 2, frames)), "radius is theirs")
    shown = read_vtkhdf(os.path.join(folder, "clumps-spheres.h5"))
    check(len(shown) == frames and all(len(frame["Vertices"]) == 5 and frame["body"].tolist() == body.tolist() for frame in shown),
          "ParaView's spheres are five points in each frame")
    check(near(numpy.concatenate([frame["Points"] for frame in shown]), stacked(dump, "x", "y", "z"))
          and near(numpy.concatenate([frame["velocity"] for frame in shown]), stacked(dump, "vx", "vy", "vz"))
          and near(numpy.concatenate([frame["diameter"] for frame in shown]), 2 * dump["radius"]), "... where the dump has them")
    grids = read_xdmf(os.path.join(folder, "clumps.xdmf"))
    check(list(grids) == ["bodies over time", "spheres over time"] and len(grids["bodies over time"][0]["Points"]) == 3
          and same(shown, grids["spheres over time"], ["Points", "velocity", "diameter", "body"]),
          "XDMF: the same spheres, in a grid beside the bodies")
    sphere = data["ellipsoid"].reshape(frames, 3, 3, 3)[:, 1]
    check(near(sphere, numpy.tile(3.0 * numpy.eye(3), (frames, 1, 1))), "the ellipsoid of a single sphere is that sphere")
    low, high = numpy.min(stacked(dump, "x", "y", "z") - dump["radius"][:, None], 0), numpy.max(
        stacked(dump, "x", "y", "z") + dump["radius"][:, None], 0)
    bounds = box(folder, "clumps")
    check(near(bounds[:, 0], low) and near(bounds[:, 1], high), "the box holds all spheres of all frames")


def spheres_alone(folder):
    """Their file is none that pictures are made of, and it says which is."""
    done = plot(PLOT, os.path.join(folder, "clumps-spheres.h5"))
    check(done.returncode == 1 and done.stderr.count("\n") == 1 and "holds the spheres of a run; give OUT.h5" in done.stderr,
          f"pictures of OUT-spheres.h5: {done.stderr.strip()}")


def bonded_spheres(folder):
    """Four dumbbells, of which two are bonded by the spheres that face each other. One of these turns against the
    other, about their line, by more than half a turn: lines join the bodies, energies are those of the rows, and the
    bond that has turned is counted."""
    path = os.path.join(folder, "bonded")
    for name, text in (("bonds.csv", "i,j\n2,1\n"),
                       ("dumbbells.csv", "x,y,z,omega_x,omega_y,omega_z\n0,0,0,4,0,0\n5,0,0,0,0,0\n10,0,0,0,0,0\n15,0,0,0,0,0\n"), ("bonded.yaml", """bodies: {table: dumbbells.csv, mass: 2, random: {seed: 4, v: 0.1},
         clumps: {spheres: [[-1, 0, 0, 1], [1, 0, 0, 1]]}}
binder: {table: bonds.csv, axial: 9, moment: 0.1, on: spheres}
bond_dashpot: {axial: 0.1}
h: 1/64
t_end: 2
""")):
        with open(os.path.join(folder, name), "w", encoding="ascii") as file:
            file.write(text)
    done = run(RUN, path + ".yaml", "-o", path + ".h5", "--record", "16", "--frames", "16")
    check(done.returncode == 0 and "; 1 bond of spheres" in done.stdout, f"bonded spheres run {done.stderr}")
    frames = read_vtkhdf(path + ".h5")
    with h5py.File(path + ".h5") as file:
        held = file["energies/binder_axial"][...] + file["energies/binder_moment"][...]
        turned = file.attrs["bonds_turned"]
    check(all(numpy.array_equal(frame["Lines"], [[0, 1]]) or numpy.array_equal(frame["Lines"], [[1, 0]]) for frame in frames),
          f"the bond is a line between the bodies: {frames[0]['Lines']}")
    check(len(frames) == len(held) == 9 and max(held) > 0.01
          and near(numpy.array([frame["bond_energy"][4] for frame in frames]), held), "its energy is that of the rows")
    check(turned == 1, f"bonds that have turned past half a turn: {turned}")


def outline(folder):
    """Widths, heights and angles of ellipses against the support of points on the surface."""
    run = read_run(os.path.join(folder, "ellipsoids.h5"))
    frame = run.frame(3)
    seen = outlines.of(run, frame, outlines.radius(run, frame))
    around = numpy.linspace(0, 2 * numpy.pi, 7)[:-1]
    for plane in ([0, 1], [0, 2], [1, 2]):
        wide, high, angle = seen.ellipses(plane)
        turned = numpy.radians(angle)[:, None] - around
        drawn = numpy.hypot(wide[:, None] / 2 * numpy.cos(turned), high[:, None] / 2 * numpy.sin(turned))
        normal = numpy.zeros((len(around), 3))
        normal[:, plane] = numpy.stack([numpy.cos(around), numpy.sin(around)], axis=1)
        reach = numpy.linalg.norm(normal @ (frame.ellipsoid / 2), axis=-1)
        check(near(drawn, reach), f"in the plane {plane} ellipses reach as far as ellipsoids")
    check(near(seen.reach, numpy.linalg.norm(frame.ellipsoid / 2, axis=-1)), "... and so along the axes")


def spheres_seen(folder):
    run = read_run(os.path.join(folder, "clumps.h5"))
    frame = run.frame(run.times.argmax())
    seen = outlines.of(run, frame, outlines.radius(run, frame))
    with open(os.path.join(folder, "clumps.dump"), encoding="ascii") as file:
        x = numpy.array([line.split()[3:6] for line in file.read().splitlines()[-5:]], float)
    check(near(seen.x, x) and seen.body.tolist() == [0, 0, 1, 2, 2], "spheres of clumps are drawn where the dump has them")


def network(folder):
    """The lines of the last frame with contacts: a floor is seen from the side, and what is thickest is the largest
    force."""
    scene, path = os.path.join(folder, "pressed.yaml"), os.path.join(folder, "pressed.h5")
    picture, contacts = os.path.join(folder, "network.png"), os.path.join(folder, "pressed-contacts.h5")
    with open(scene, "w", encoding="ascii") as file:
        file.write(PRESSED)
    done = run(RUN, scene, "-o", path, "--contacts", "--frames", "32")
    check(done.returncode == 0 and plot(PLOT, contacts, "-o", folder).returncode == 0 and os.path.exists(picture), f"network.png {done.stderr}")
    found = network_file.read_network(contacts)
    figure, _ = network_file.draw(found)
    axes = figure.axes[0]
    lines = axes.collections[0]
    widths, segments = lines.get_linewidths(), lines.get_segments()
    strongest = numpy.argmax(found.normal)
    check(axes.get_ylabel().startswith("$z$") and len(segments) == len(found.normal) > 20, "all contacts, the floor from the side")
    check(widths[-1] == max(widths) and numpy.array_equal(segments[-1], found.ends[strongest][:, [0, 2]]), "... the largest force is the thickest line")
    check(numpy.allclose(sorted(widths)[-3:], network_file.THICKEST * numpy.sort(found.normal)[-3:] / found.normal.max()), "... the others in proportion")
    said = plot(PLOT, contacts, "--film")
    check(said.returncode == 1 and "is a network, of which there is no film" in said.stderr, f"... no film: {said.stderr}")
    with h5py.File(contacts, "r+") as file:
        file["VTKHDF/Lines/NumberOfCells"][-1] += 1
    said = plot(PLOT, contacts, "-o", folder)
    check(said.returncode == 1 and "fewer contacts than /VTKHDF/Lines/NumberOfCells says" in said.stderr, f"... lines that are not there: {said.stderr}")
    with h5py.File(contacts, "r+") as file:
        file["VTKHDF/Lines/NumberOfCells"][...] = 0
    said = plot(PLOT, contacts, "-o", folder)
    check(said.returncode == 0 and "network.png: not drawn, nothing touches in any frame" in said.stdout, f"... none at all: {said.stdout}")


with tempfile.TemporaryDirectory() as root:
    ellipsoids(root)
    clumps(root)
    outline(root)
    spheres_seen(root)
    spheres_alone(root)
    bonded_spheres(root)
    network(root)
    for scene in ("ellipsoids", "clumps"):
        done = plot(PLOT, os.path.join(root, scene + ".h5"), "-o", os.path.join(root, scene), only=("shapes.png",))
        check(done.returncode == 0 and os.path.getsize(os.path.join(root, scene, "shapes.png")) > 3000, f"{scene} are drawn {done.stderr}")
conclude()
