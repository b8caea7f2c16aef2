# SPDX-License-Identifier: BSD-3-Clause
"""vti-plot on runs: test_plot_run.py VTI-PLOT. Makes runs by formula, draws and films them and looks at what came out;
then hands over files that are no runs and expects one line each. Exit status 77 (skipped) where Python lacks a
module."""
import importlib
import os
import re
import time
import types

import plot_support
from plot_support import EPS, FINE, apart, left_alone, plot, refuses, refuses_damage

import h5py
import matplotlib.colors
import numpy as np
from PIL import Image

import test_plot

ALL = ("energy.png", "energy_error.png", "momenta.png", "shapes.png")
LOOKS = {"kinetic_translation": ("$T$", "translation", "#0072B2"), "kinetic_rotation": ("$R$", "rotation", "#56B4E9"),
         "binder_moment": ("$U^m$", "bending and torsion", "#E69F00"), "contact": ("$U^c$", "contact", "#332288")}


def ring(count, t):
    """A ring that turns by t and breathes while it flies off: centres, attitudes x, y, z, w."""
    angle = 2 * np.pi * np.arange(count) / count + t
    centre = np.stack([2 + 0.3 * t + (1 + 0.2 * np.sin(t)) * np.cos(angle), (1 - 0.2 * np.sin(t)) * np.sin(angle), 0 * angle], 1)
    return centre, np.tile([0, 0, np.sin(t / 2), np.cos(t / 2)], (count, 1))


def energies(t):
    """Columns whose sum is 10 but for an error of 1e-4."""
    columns = {"kinetic_translation": 4 + np.cos(2 * t), "kinetic_rotation": 2 + 0.5 * np.sin(3 * t),
               "binder_moment": 3 - np.cos(2 * t) - 0.5 * np.sin(3 * t), "binder_axial": 0.5 + 0 * t,
               "binder_shear": 0.5 + 1e-3 * np.sin(50 * t) * (t > 0), "contact": np.maximum(0, 1e-2 * np.sin(t))}
    columns["total"] = sum(columns.values())
    return columns


def write_run(path, count=24, frames=71, rows=3000, t_end=7.0, turns=True, translates=True, blown=False, walls=True,
              scene="ring", touching=1, squeeze=1.0):
    with h5py.File(path, "w") as file:
        file.attrs.update({"scene": np.bytes_(scene), "stepper": np.bytes_("vti2"), "vti_version": np.bytes_("0.1.0"),
                           "h": 1e-3})
        if touching is not None:    # as in files that do not say
            file.attrs["touching"] = np.int64(touching)
        t = np.linspace(0, t_end, rows)
        columns = {"t": t, **energies(t)}
        if blown:
            columns["total"] = columns["total"] * 10.0 ** np.clip(100 * (t - 3), 0, 250)
        for name in ("momentum",) * translates + ("spin",) * turns + ("angular",):
            walk = np.cumsum(np.random.default_rng(1).standard_normal((rows, 3)), axis=0) * EPS
            for k, axis in enumerate("xyz"):
                columns[f"{name}_{axis}"] = walk[:, k] * (k > 0) + (np.minimum(t, 2) if (name, k) == ("momentum", 0) else 0)
        for name, values in columns.items():
            file[f"energies/{name}"] = values
            if name in LOOKS:
                file[f"energies/{name}"].attrs.update(zip(("symbol", "meaning", "colour"), LOOKS[name]))
        file["energies"].attrs["columns"] = ",".join(columns)

        times = np.linspace(0, t_end, frames)
        centres, attitudes = (np.concatenate(parts) for parts in zip(*(ring(count, time) for time in times)))
        data, bodies = file.create_group("VTKHDF/PointData"), np.arange(count)
        file["VTKHDF/Points"], file["VTKHDF/Steps/Values"] = centres, times
        file["VTKHDF/Lines/Connectivity"] = np.stack([bodies, (bodies + 1) % count], axis=1).ravel()
        if turns:
            data["attitude_xyzw"] = attitudes
        if translates:
            data["velocity"], data["diameter"] = np.zeros_like(centres), np.full(count, 2 * np.sin(np.pi / count) / squeeze)
        if walls:
            file.attrs["planes"] = "wall"
            file["walls"] = np.array([[1.0, 0.0, 0.0, 0.9], [0.0, 0.0, 1.0, -1.0]])


def modules(*names):
    return [importlib.import_module(f"plot.{name}") for name in names]


def draws(program, run, folder, pictures=ALL, **options):
    return plot_support.draws(program, run, folder, pictures, narrowest=1000, **options)


def test_pictures(program, folder):
    run = os.path.join(folder, "called-anything.h5")
    write_run(run)
    once, said = draws(program, run, os.path.join(folder, "once"), dpi=FINE)
    assert apart(program, run, "-o", os.path.join(folder, "again")).returncode == 0
    again = [plot_support.picture(os.path.join(folder, "again", name), 1000) for name in ALL]
    assert once == again, "the same file gave different bytes"
    linked = os.path.join(folder, "linked")
    os.mkdir(linked)
    os.symlink("kept.png", os.path.join(linked, "energy.png"))
    for name in ("energy.png.part", "kept.png.part"):
        with open(os.path.join(linked, name), "w", encoding="ascii") as file:
            file.write("mine")
    done = apart(program, run, "-o", linked, HOME="/dev/null", XDG_CONFIG_HOME="/dev/null", XDG_CACHE_HOME="/dev/null")
    assert done.returncode == 0 and done.stderr == "", done.stderr
    assert os.path.islink(os.path.join(linked, "energy.png")), "a link is replaced, and not what it leads to"
    assert sorted(set(os.listdir(linked)) - set(ALL)) == ["energy.png.part", "kept.png", "kept.png.part"], os.listdir(linked)
    assert "note:" not in said, said
    some = ("energy.png", "shapes.png")
    once, _ = draws(program, run, os.path.join(folder, "coarse"), pictures=some, only=some)
    write_run(run, walls=False)
    bare, _ = draws(program, run, os.path.join(folder, "no-walls"), pictures=some, only=some)
    assert bare[1] != once[1] and bare[0] == once[0], "walls belong to shapes.png and to nothing else"


def test_contacts(program, folder):
    """Neighbours of this ring overlap, and all are bonded: whether they touch, the file says."""
    run, said = os.path.join(folder, "out.h5"), {}
    for touching in (None, 1, 2):
        write_run(run, walls=False, squeeze=0.7, touching=touching)
        shapes = ("shapes.png",)
        said[touching] = draws(program, run, os.path.join(folder, str(touching)), pictures=shapes, only=shapes)[0]
    assert said[None] == said[1] != said[2], "contacts inside bonds are not drawn as the file has them"


def test_looks(program, folder):
    """Energies are shown as the file says, those of which it does not by their names."""
    run, drawn = os.path.join(folder, "out.h5"), []
    for colour in ("#00FF00", None):
        write_run(run, count=6, frames=2, rows=50)
        with h5py.File(run, "a") as file:
            attributes = file["energies/binder_moment"].attrs
            if colour:
                attributes["colour"] = colour
            else:
                del attributes["symbol"]
        energy = ("energy.png",)
        drawn.append(draws(program, run, os.path.join(folder, str(colour)), pictures=energy, only=energy)[0])
    assert drawn[0] != drawn[1], "energy.png does not show what the file says"
    run_file, energy = modules("run_file", "energy")
    with h5py.File(run, "a") as file:
        file["energies/contact"].attrs["colour"] = "#F0E442"
    figure, _ = energy.draw(run_file.read_run(run))
    rims = {line.get_color(): bool(line.get_path_effects()) for line in figure.axes[1].lines}
    assert rims["#F0E442"] and not rims["#0072B2"], "a yellow line on white has a rim, and only such ones"
    left_alone(program, run)


def test_scenes(program, folder):
    run = os.path.join(folder, "out.h5")
    write_run(run, translates=False, count=1)
    _, said = draws(program, run, os.path.join(folder, "turns-only"), pictures=ALL[:3])
    assert "shapes.png: not drawn" in said and "no positions" in said, said
    write_run(run, turns=False, count=2500, frames=9)
    draws(program, run, os.path.join(folder, "many"), pictures=ALL[3:], only=ALL[3:], dpi=FINE)
    write_run(run, count=1, frames=1, rows=2)
    draws(program, run, os.path.join(folder, "one-body"))
    write_run(run, t_end=100.0)
    draws(program, run, os.path.join(folder, "far"))
    write_run(run, rows=1, frames=1)
    _, said = draws(program, run, os.path.join(folder, "one-row"), pictures=("energy.png", "momenta.png", "shapes.png"))
    assert "energy_error.png: not drawn" in said, said
    write_run(run, blown=True, scene="$x")
    _, said = draws(program, run, os.path.join(folder, "blown-up"))
    assert said.count("the run blew up: from t = 3.0") == 4, said


def test_walls(program, folder):
    """Walls that have moved are drawn where they are: as walls that have always been there."""
    run, drawn = os.path.join(folder, "out.h5"), []
    shapes = ("shapes.png",)
    for name, start, spin in (("moved", 0, 0), ("there", 4, 0), ("turned", 0, 1)):
        write_run(run, frames=1)
        with h5py.File(run, "a") as file:
            velocity = np.array([[0.125, 0, 0], [0, 0, 0], [0.0625, -0.125, 0], [0, 0.0625, 0]])
            way = start * velocity
            del file["walls"], file["VTKHDF/Steps/Values"]
            file["VTKHDF/Steps/Values"] = [4.0]
            file["walls"] = [[1.0, 0.0, 0.0, 0.75 + way[0, 0]], [0.0, 0.0, 1.0, -1.0]]
            cylinders = [[0, 0, 1, 2, 0, 0, 1.25], [1, 0, 0, 0, 0.25, 0, 0.875]]
            file["wall_cylinders"] = np.array(cylinders) + np.pad(way[2:], ((0, 0), (3, 1)))
            file["wall_velocities"], file["wall_spins"] = velocity * (start == 0), np.array([0.0, 0.0, spin, 0.0])
        drawn.append(draws(program, run, os.path.join(folder, name), pictures=shapes, only=shapes)[0])
    assert drawn[0] == drawn[1], "walls are not where they have come to"
    assert drawn[0] != drawn[2], "one does not see that a cylinder turns"


def test_rest(program, folder):
    """What rests is drawn once: panels are of the time before, and of all of it where a body, a mark or a wall
    moves."""
    shapes, run_file, scenery = modules("shapes", "run_file", "scenery")
    path, count = os.path.join(folder, "out.h5"), 24

    def frames(calm=True, **change):
        write_run(path, count)
        with h5py.File(path, "a") as file:
            for name in [name for name in file["energies"] if calm and name.startswith("kinetic_")]:
                file[f"energies/{name}"][file["energies/t"][:] >= 3] = 0.0
            for name in ("VTKHDF/Points", "VTKHDF/PointData/attitude_xyzw"):
                file[name][31 * count:] = np.tile(file[name][30 * count:31 * count], (40, 1))
            for name, (row, value) in change.items():
                changed = file[f"VTKHDF/{name}"][row * count] + value
                file[f"VTKHDF/{name}"][row * count] = changed / (np.linalg.norm(changed) if len(changed) == 4 else 1)
        run = run_file.read_run(path)
        return shapes.until_rest(run, scenery.Scenery(run, [run.frame(0), run.frame(30)]))
    assert frames() == 31
    assert frames(calm=False) == 71, "bodies that are where they were and move do not rest"
    assert frames(Points=(50, [0.1, 0, 0])) == 52 and frames(Points=(50, [0.001, 0, 0])) == 31
    assert frames(**{"PointData/attitude_xyzw": (40, [0.1, 0, 0, 0])}) == 42
    write_run(path, frames=2)
    with h5py.File(path, "a") as file:
        file["VTKHDF/Points"][count:] = file["VTKHDF/Points"][:count]
        file["VTKHDF/PointData/attitude_xyzw"][count:] = file["VTKHDF/PointData/attitude_xyzw"][:count]
        file["wall_velocities"], file["wall_spins"] = np.full((2, 3), 0.01), np.zeros(2)
    run = run_file.read_run(path)
    assert shapes.until_rest(run, scenery.Scenery(run, [run.frame(0)])) == 2, "a wall moves"


def test_level(program, folder):
    """A plane that no coordinates show from the side is level in pictures: gaps, distances and attitudes are those in
    space."""
    level, outlines, run_file, scenery, walls = modules("level", "outlines", "run_file", "scenery", "walls")
    path = os.path.join(folder, "out.h5")
    for plane, seen in (((1, 0, 0, -1), False), ((0.6, 0, 0.8, -1), False), ((0.36, -0.48, 0.8, -1), True),
                        ((-0.8, 0.48, -0.36, -2), True)):
        write_run(path, count=5, frames=2, rows=2)
        with h5py.File(path, "a") as file:
            del file["walls"], file["VTKHDF/PointData/attitude_xyzw"]
            file["walls"] = [plane]
            file["wall_velocities"], file["wall_spins"] = np.array([[1.0, 2.0, 3.0]]), np.zeros(1)
            attitude = np.random.default_rng(5).standard_normal((10, 4))
            file["VTKHDF/PointData/attitude_xyzw"] = attitude / np.linalg.norm(attitude, axis=1, keepdims=True)
        run = run_file.read_run(path)
        axes, frame = level.axes_of(run.walls), run.frame(1)
        assert (axes is not None) == seen, f"{plane} is turned, or is not"
        scene = scenery.Scenery(run, [run.frame(0), frame])
        assert scene.axis_names()[1] == ("normal to the plane" if seen else "$y$")
        if not seen:
            continue
        there = level.of_frame(axes, frame)
        assert np.allclose(axes @ axes.T, np.eye(3), 0, 4 * EPS) and np.linalg.det(axes) > 0
        assert np.allclose(scene.walls.planes_at(7.0)[0], [0, 0, 1, run.walls.planes_at(7.0)[0, 3]], 0, 30 * EPS)
        assert np.allclose(list(walls.gaps(scene.walls, there)), list(walls.gaps(run.walls, frame)), 0, 50 * EPS)
        vectors = np.random.default_rng(6).standard_normal((5, 3))
        assert np.allclose(outlines.turned(there.attitude, vectors), outlines.turned(frame.attitude, vectors) @ axes.T, 0, 50 * EPS)


def test_plane(_program, folder):
    """A floor is seen from the side, whichever way bodies move most; planes opposite each other are glass before
    them."""
    run_file, scenery = modules("run_file", "scenery")
    path = os.path.join(folder, "out.h5")
    x, y, z = np.eye(3)
    for normals, seen in (((), [0, 1]), ((z,), [0, 2]), ((y, -y), [0, 1]), ((z, -z), [0, 1]), ((z, y, -y), [0, 2]), ((x, y, z), [0, 1]),
                          ((z, x), [0, 2]), ((0.6 * x + 0.8 * z,), [0, 1])):
        write_run(path, count=5, frames=2, rows=2, walls=False)
        if normals:
            with h5py.File(path, "a") as file:
                file.attrs["planes"] = "wall"
                file["walls"] = np.column_stack([normals, np.full(len(normals), -9.0)])
        run = run_file.read_run(path)
        found = scenery.Scenery(run, [run.frame(0), run.frame(1)]).plane
        assert found == seen, (normals, found)


def test_fragments(_program, _folder):
    """A fragment keeps its colour through all frames, its largest part after a break; no two have one while others are
    free."""
    scenery = importlib.import_module("plot.scenery")

    def frames(*fragments):
        return [types.SimpleNamespace(x=np.zeros((len(one), 3)), fragment=np.array(one)) for one in fragments]
    first, broken, apart = scenery.fragment_colours(frames([0] * 9, [0, 0, 0, 3, 3, 3, 3, 3, 3], [0, 1, 1, 3, 3, 5, 5, 5, 5]))
    whole = first[0]
    assert list(first) == [whole] * 9 and whole != scenery.SINGLE
    assert set(broken[3:]) == {whole} and set(broken[:3]) != {whole}, broken
    assert set(apart[5:]) == {whole} and set(apart[1:3]) == {broken[0]} and apart[0] == scenery.SINGLE, apart
    assert apart[3] == apart[4] not in (whole, broken[0], scenery.SINGLE), apart
    many = len(scenery.FRAGMENTS)
    pairs = scenery.fragment_colours(frames(np.repeat(2 * np.arange(many), 2), np.repeat(2 * np.arange(many + 1), 2)[:2 * many]))
    assert len(set(pairs[0])) == many and list(pairs[1]) == list(pairs[0]), pairs
    assert set(scenery.fragment_colours(frames([-1, -1, 2, 2]))[0][:2]) == {scenery.SINGLE}, "bodies without bonds"

    def seconds(pieces):
        """The least of three times of a whole that breaks into so many pieces."""
        one, taken = frames([0] * 2 * pieces, np.repeat(2 * np.arange(pieces), 2)), []
        for _ in range(3):
            began = time.process_time()
            scenery.fragment_colours(one)
            taken.append(time.process_time() - began)
        return min(taken)
    assert seconds(8000) < 30 * seconds(1000), "eight times as many pieces take eight times as long, and not 64 times"


def test_no_bond_made(program, folder):
    """A run whose bonds are made on touch, and none was."""
    run = os.path.join(folder, "out.h5")
    write_run(run, frames=9)
    with h5py.File(run, "a") as file:
        del file["VTKHDF/Lines/Connectivity"]
        file["VTKHDF/Lines/Connectivity"] = np.zeros(0, int)
        file["VTKHDF/PointData/fragment"] = np.full(24 * 9, -1)
    draws(program, run, os.path.join(folder, "no-bond"), pictures=ALL[3:], only=ALL[3:])


def test_varying_steps(program, folder):
    """Titles of runs whose steps vary name none."""
    del program
    words = importlib.import_module("plot.words")
    run = types.SimpleNamespace(stepper="srkn11-tol", h=1 / 64)
    assert words.steps_of(run) == "SRKN11 tol, steps that vary", folder
    run.stepper = "vti2"
    assert words.steps_of(run) == "VTI-2, $h$ = 1/64"


def test_scale(_program, folder):
    """Both coordinates are written in one power of ten, near 1 in none; less a round base far from the origin, where
    ticks are apart and name where they are. What of the walls is seen at a slant is said not to be drawn."""
    (shapes, run_file), path = modules("shapes", "run_file"), os.path.join(folder, "out.h5")
    write_run(path, count=5, frames=2, rows=2, walls=False)
    with h5py.File(path, "a") as file:
        file["VTKHDF/Points"][...] += np.array([123456.0, 0.0, 0.0])
        file.attrs["planes"] = "wall"
        file["walls"] = [[0.6, 0.64, 0.48, -2e5], [0.0, 1.0, 0.0, -9.0]]
    figure, notes = shapes.draw(run_file.read_run(path))
    figure.canvas.draw()
    low = next(axes for axes in figure.axes if axes.get_xlabel())
    ticks = [text.get_text() for text in low.get_xticklabels() if text.get_text()]
    base = float(low.get_xlabel().split("\N{MINUS SIGN} ")[1].split(" ")[0])
    values = [base + float(text.replace("\N{MINUS SIGN}", "-")) for text in ticks]
    assert len(set(ticks)) == len(ticks) > 1 and np.allclose(values, low.get_xticks()[:len(values)], 0, 1e-6), (base, ticks)
    assert notes == ["1 wall not drawn, being seen at a slant"], notes
    power = importlib.import_module("plot.shapes")._power
    for low, high, expected in (((-3, 0), (3, 1), 0), ((0, 0), (0.03, 0.3), 0), ((0, 0), (0.03, 0.01), -2), ((-0.0103, 0), (0, 0.009), -3),
                                ((0, 0), (3e4, 1), 4)):
        assert power([(low, high)]) == expected, (low, high, power([(low, high)]))


def test_momenta(_program, folder):
    """What is kept does not depend on the unit of length: each momentum is compared with what is exchanged of it."""
    (momenta, run_file), path, kept = modules("momenta", "run_file"), os.path.join(folder, "out.h5"), []
    for unit in (1.0, 1e-6, 1e6):
        write_run(path, walls=False)
        with h5py.File(path, "a") as file:
            file["energies/spin_x"][...] = 1 + 1e-9 * (file["energies/t"][...] > 3)
            for name, dataset in file["energies"].items():
                dataset[...] *= 1.0 if name == "t" else unit if name.startswith("momentum") else unit**2
            file["VTKHDF/Points"][...] *= unit
            file["VTKHDF/PointData/velocity"][...] = unit
            file["VTKHDF/PointData/omega"] = np.ones_like(file["VTKHDF/Points"])
        run = run_file.read_run(path)
        kept.append([[one.kept for one in momenta.components(run, vector)] for vector in ("momentum", "spin", "angular")])
    assert kept[0] == [[False, True, True], [False, True, True], [True, True, True]] and kept == 3 * kept[:1], kept


def test_short_times(_program, folder):
    """Labels of times stand apart, however short these are."""
    (momenta, run_file), path = modules("momenta", "run_file"), os.path.join(folder, "out.h5")
    for t_end in (1.5e-4, 0.015, 7.0, 3e6):
        write_run(path, t_end=t_end)
        figure, _ = momenta.draw(run_file.read_run(path))
        figure.canvas.draw()
        for axes in figure.axes[:3]:
            low, high = axes.get_xlim()
            boxes = [text.get_window_extent() for tick, text in zip(axes.get_xticks(), axes.get_xticklabels()) if low <= tick <= high]
            assert len(boxes) > 2 and all(one.x1 < other.x0 for one, other in zip(boxes, boxes[1:])), t_end


def test_names(program, folder):
    """A terminal that has not the characters of a name is told them otherwise."""
    inside = os.path.join(folder, "gr\u00f6\u00dfe")
    os.mkdir(inside)
    write_run(os.path.join(inside, "out.h5"), count=3, frames=2, rows=20)
    done = apart(program, os.path.join(inside, "out.h5"), PYTHONIOENCODING="ascii:strict")
    assert done.returncode == 0 and r"gr\xf6\xdfe" in done.stdout and set(ALL) <= set(os.listdir(inside)) and done.stderr == "", done.stderr


def test_room(_program, folder):
    """Nothing is cut off or over something else: marks end within the window, axes of low panels have no unit that is
    longer than they are, and what is said below a picture is no wider than it."""
    run_file, scenery, shapes, style = modules("run_file", "scenery", "shapes", "style")
    path = os.path.join(folder, "out.h5")
    write_run(path, count=1, frames=2, rows=50)
    with h5py.File(path, "a") as file:
        file["VTKHDF/PointData/diameter"][...] = 1
    run = run_file.read_run(path)
    scene = scenery.Scenery(run, [run.frame(0), run.frame(1)])
    assert scene.marked and np.all(scene.half >= 1.0), f"a mark of length 1 in a window of {scene.half}"
    for flat, unit in ((0.2, False), (0.3, False), (0.35, True), (1.0, True)):
        write_run(path, frames=6, walls=False)
        with h5py.File(path, "a") as file:
            file["VTKHDF/Points"][...] = file["VTKHDF/Points"][...] * (1, flat, 1)
        figure, _ = shapes.draw(run_file.read_run(path))
        labels = [axes.get_ylabel() for axes in figure.axes if axes.get_ylabel()]
        figure.canvas.draw()
        assert labels and all(("units" in label) == unit for label in labels), (flat, labels)
        boxes = [axes.yaxis.label.get_window_extent() for axes in figure.axes if axes.get_ylabel()]
        assert all(not one.overlaps(other) for k, one in enumerate(boxes) for other in boxes[:k]), f"{flat}: labels overlap"
    said = ["a" * 100, "b" * 60, "c" * 60]
    assert style.below(said) == "\n".join([said[0] + "  " + said[1], said[2]]) and style.below([]) == ""


def test_kept_exactly(_program, folder):
    run_file, energy_error = modules("run_file", "energy_error")
    path = os.path.join(folder, "out.h5")
    write_run(path)
    with h5py.File(path, "a") as file:
        file["energies/total"][...] = 10
    figure, _ = energy_error.draw(run_file.read_run(path))
    assert figure.axes[0].get_title() == "kept exactly", figure.axes[0].get_title()


def test_film(program, folder):
    run = os.path.join(folder, "out.h5")
    write_run(run, frames=15)
    films = []
    for name in ("once", "again"):
        done = plot(program, "--film", run, "-o", os.path.join(folder, name))
        path = done.stdout.strip()
        missing = "no ffmpeg" in done.stderr and "package ffmpeg" in done.stderr and done.stderr.count("\n") == 1
        assert done.returncode == 0 and (missing if path.endswith(".gif") else done.stderr == ""), done.stderr
        assert os.listdir(os.path.join(folder, name)) == [os.path.basename(path)] and "film." in path, done.stdout
        with open(path, "rb") as file:
            films.append(file.read())
    assert films[0] == films[1] and len(films[0]) <= 1_500_000, "the film differs, or is too large"
    if path.endswith(".gif"):
        with Image.open(path) as film:
            assert film.n_frames == 15, film.n_frames
            # bodies touch the wall in some frames only: colours are there exactly, whichever frame they are in
            shown = set()
            for k in range(film.n_frames):
                film.seek(k)
                shown |= {colour for _, colour in film.convert("RGB").getcolors(1 << 24)}
            wanted = [(0xCF, 0xE6, 0xF5), (0xE6, 0x9F, 0x00), (0, 0, 0), (255, 255, 255)]
            assert all(colour in shown for colour in wanted), "the GIF lacks colours of the scene"
    write_run(run, translates=False)
    refuses(program, run, "no positions", options=("--film",))
    write_run(run, frames=1)
    refuses(program, run, "fewer than two frames; run it again with fewer steps between", options=("--film",))


def test_curves(_program, folder):
    """Peaks of a single time are drawn, of energies, of momenta and of the error, whose drift is that over the whole
    time; each layer's name has its colour; and nothing is left of a run from where it blew up."""
    (energy, energy_error, momenta, run_file), path = modules("energy", "energy_error", "momenta", "run_file"), os.path.join(folder, "out.h5")
    write_run(path)
    with h5py.File(path, "a") as file:
        file["energies/contact"][1501], file["energies/momentum_y"][1501] = 5.0, 0.5
        file["energies/total"][...] = 10 + 1e-3 * (-1.0) ** np.arange(3000) + 3e-3 * file["energies/t"][...] / 7
    run = run_file.read_run(path)
    stack, single = energy.draw(run)[0].axes
    names = [text.get_text().split("  ")[-1] for text in stack.get_legend().get_texts()]
    colours = dict(zip(names[1:], (matplotlib.colors.to_hex(patch.get_facecolor()).upper() for patch in stack.get_legend().get_patches())))
    assert names[0] == "total" and all(colours[meaning] == colour for _, meaning, colour in LOOKS.values()), colours
    peaks = {line.get_color(): np.max(line.get_ydata()) for line in single.lines}
    assert peaks[LOOKS["contact"][2]] == 5.0, peaks
    axes = momenta.draw(run)[0].axes[0]
    peaks = {line.get_color(): np.nanmax(line.get_ydata()) for line in axes.lines}
    assert peaks[momenta.LOOKS[0][1]] == 2.0 and 0.4 < peaks[momenta.LOOKS[1][1]] < 0.6 and peaks[momenta.LOOKS[2][1]] < 1e-12, peaks
    axes = energy_error.draw(run)[0].axes[0]
    # from the first value, which is 1e-3 above 10, in 1e-4
    band = axes.collections[0].get_paths()[0].vertices[:, 1]
    assert "moves by $3.0\\times 10^{-4}$ ±" in axes.get_title() and "10^{-4}" in axes.get_ylabel(), (axes.get_title(), axes.get_ylabel())
    assert np.isclose(np.min(band), -2.0, 0, 0.01) and np.isclose(np.max(band), 3.0, 0, 0.01), (np.min(band), np.max(band))
    # residuals +, -, -, + have no slope: the interval is 2.1 of its standard error, sqrt(20/18/665), times the length
    change, interval = energy_error.drift(np.arange(20.0), 3 * np.arange(20.0) + np.tile([1.0, -1.0, -1.0, 1.0], 5))
    assert np.isclose(change, 57.0) and np.isclose(interval, 2.1 * 19 * np.sqrt(20 / 18 / 665)), (change, interval)
    write_run(path, blown=True)
    run = run_file.read_run(path)
    assert np.max(run.columns["t"]) < run.lost and np.max(run.times) < run.lost and np.max(np.abs(run.columns["total"])) < 120, run.lost
    assert len(run.total_to_the_end[0]) == 3000 and all(len(values) == len(run.columns["t"]) for values in run.columns.values())


def bent(t):
    """Flat at first, and twice as steep in the second half of 500."""
    return np.maximum(t, 20.0) + np.maximum(t - 250.0, 0.0) - 20.0


def figures_folder(folder):
    """What ./dev figures finds: studies of PAPER's orders, runs whose energies and momenta are off by what is known."""
    far = {stepper: (*laws[:2], (0, 0.5), laws[3]) for stepper, laws in test_plot.PAPER.items()}
    for name, steppers in (("pendulum", None), ("torus-study", None), ("torus-printed-study-short", None), ("torus-printed-study", far)):
        os.makedirs(os.path.join(folder, name))
        test_plot.write_study(os.path.join(folder, name, "study.h5"), steppers)
    with h5py.File(os.path.join(folder, "pendulum", "study.h5"), "a") as file:
        file["series/000004/arm_length"][3] = -2.5e-11
    figures = importlib.import_module("plot.pages.figures")
    # stepper, end, the sum's swing and its slope as shares of it, how far S_z, L_x and L_z go
    runs = {name: ("vti2", 7.0, 4e-4, 0.0, (0.25, 0.5, 0.75)) for name in ("torus", "torus-vti2", *figures.DISSIPATING, *figures.NO_SPHERES)}
    runs |= {"torus-vti1": ("vti1", 7.0, 4e-4, 0.0, (0.5, 0.125, 1.0)), "torus-printed": ("vti2", 7.0, 4e-4, 0.0, (0.0, 3.0, 2.0)),
             "torus-long-vti2": ("vti2", 500.0, 0.0, 1e-6, (0, 0, 0)), "torus-long-vti3": ("vti3", 500.0, 0.0, -3e-6, (0, 0, 0)),
             "torus-coarse": ("vti2", 7.0, 0.0, 0.0, (0, 0, 0))}
    for name, (stepper, t_end, swing, rate, far) in runs.items():
        os.makedirs(os.path.join(folder, name))
        with open(os.path.join(folder, name, "run.txt"), "w", encoding="utf-8") as file:
            file.write("warning: h is too large\nt = 1\n")
        path = os.path.join(folder, name, "out.h5")
        write_run(path, count=3, frames=2, t_end=t_end, blown=name == "torus-coarse")
        with h5py.File(path, "a") as file:
            file.attrs["stepper"], t = np.bytes_(stepper), file["energies/t"][...]
            file["energies/wall"] = 0.03 * (np.abs(t - 0.5 * t_end) < 0.1 * t_end) - file["energies/contact"][...]
            if name != "torus-coarse":
                file["energies/total"][...] = 10 * (1 + swing * np.sin(np.pi * t / t_end) ** 2 + rate * bent(t))
            if name == "torus-vti1":
                file["energies/momentum_x"][...] *= 1.5
            for column, size in zip(("spin_z", "angular_x", "angular_z"), far):
                file[f"energies/{column}"][...] = size * t / t_end
    return figures


def test_figures(_program, folder):
    """The page of ./dev figures: its numbers are those that the files were made with, and its verdicts follow from
    them."""
    done = plot_support.called(figures_folder(folder), "figures", folder)
    assert done.returncode == 0 and done.stderr == "", done.stderr
    with open(os.path.join(folder, "index.md"), encoding="utf-8") as file:
        text = file.read()
    met, missed, parts = "**Agrees.** ", "**Does not agree.** ", {part.split("\n")[0].split(":")[0]: part for part in text.split("\n## ")}
    for heading, said in {
            "Figure 1": (f"{met}Quadratic convergence of the energy", f"{met}Linear convergence of the q-error",
                         f'{missed}"Linear convergence of trajectories"', f'{missed}"Indistinguishable', "VTI-1 is 8.8 times that of VTI-2", f"{met}Invariants",
                         "|R rho0| by at most 2.5e-11", " | 3.4e-08 |"),      # 0.56/2^24 of VTI-1
            "Figure 4": (f"{met}Near-conservation of the total: at most 4.0e-04 of 10.", "at most 5 in kinetic translation, 2.5 in kinetic rotation",
                         f"{missed}The contact energy", "off by up to 1.6 %"),      # 21/4 of 0.03 of 10
            "Figure 5": (f"{met}VTI-2 at h = 0.001, to t = 500: the energy is off by at most 7.3e-04 of itself",
                         f"{missed}VTI-3 at h = 0.001, to t = 500: the energy is off by at most 2.2e-03 of itself", f"{missed}The paper prints h = 1e-2",
                         "by t = 3.0", "`warning: h is too large`\n"),
            "Figure 6": ("| 0.25 | 0.5 | 0.75 |\n| VTI-2, printed shear | 2 |", "| VTI-1 | 3 |", "| 0.5 | 0.12 | 1 |\n| VTI-2 | 2 |", "| 0 | 3 | 2 |\n",
                         f"{met}P along the wall", f'{missed}"Exact conservation', "P_x changes by 2 as"),
            "Figure 7": (f"{met}Quadratic", f"{met}Linear convergence of the energy for VTI-3", f"{missed}Linear convergence of the q-error for all three",
                         "to t = 10. The smallest true error is 0.49, and the reference itself is known to 0: the motion is chaotic",
                         "to t = 2. The smallest true error is 1.5e-08, and the reference itself is known to 0: so far the finest"),
            "Beyond the paper": ("The sum stays to 8.0e-04 of the largest energy.",)}.items():     # 4e-4 of 10 beside 5
        for words in said:
            assert words in parts[heading], f"no '{words}' in: {parts[heading]}"
    t = np.linspace(0, 500, 3000)
    shown = [float(number) for number in re.findall(r"(?:moves by|whole time,|a slope of) (\S+) ±", parts["Figure 5"])]
    found = [np.polyfit(some, bent(some), 1)[0] for some in (t, t[1500:], t[t > 20])]
    wanted = [500e-6 * found[0], 250e-6 * found[1], 1e-5 * found[2], -1.5e-3 * found[0], -7.5e-4 * found[1]]
    assert np.allclose(shown, wanted, rtol=0.03), (shown, wanted)
    has_order, fits = importlib.import_module("plot.pages.figures").has_order, {"a": (2.05, 0.01), "b": (2.3, 0.4), "c": (2.3, 0.2), "d": (2.0, 0.7)}
    study = types.SimpleNamespace(fit=lambda stepper, _: dict(zip(("order", "interval"), fits[stepper])))
    for steppers, expected in (("ab", True), ("ac", False), ("ad", None)):
        assert has_order(study, steppers, "e_error", 2) is expected, steppers


def test_refusals(program, folder):
    path = os.path.join(folder, "out.h5")
    with h5py.File(path, "w") as file:
        file["something"] = np.zeros(3)
    refuses(program, path, path, "neither a study nor a run")
    os.remove(path)
    refuses(program, path, "no such file; run vti-study or vti-run first")
    checkpoint = os.path.join(folder, "out.run")    # what vti-run leaves of a run that is not complete
    with open(checkpoint, "wb") as file:
        file.write(bytes(100))
    for given, problem in ((path, "no such file"), (checkpoint, "is not an HDF5 file")):
        refuses(program, given, given, f"{problem}; the run is not complete", "--resume")
    os.remove(checkpoint)
    refuses_damage(program, path, write_run,
                   ("energies", "energies/t", "energies/total", "VTKHDF/Points", "VTKHDF/Steps/Values", "VTKHDF/PointData",
                    "VTKHDF/Lines/Connectivity"), ("scene", "stepper", "h", "vti_version"),
                   [("energies/contact", np.zeros(7), "/energies/contact has 7 rows"),
                    ("energies/total", np.full(3000, np.nan), "no number that is finite"),
                    ("energies/t", np.zeros(3000), "/energies/t has times that do not rise"),
                    ("energies/contact", np.full(3000, 1e308), "has values that cannot be drawn (ValueError"),
                    ("VTKHDF/Steps/Values", np.full(71, np.inf), "/VTKHDF/Steps/Values has a number that is not finite"),
                    ("VTKHDF/Points", np.zeros((100, 3)), "/VTKHDF/Points has the shape (100, 3)"),
                    ("VTKHDF/Lines/Connectivity", np.array([0, 24]), "a body that does not exist"),
                    ("VTKHDF/Lines/Connectivity", np.array([0, 1, 2]), "/VTKHDF/Lines/Connectivity"),
                    ("VTKHDF/PointData/diameter", np.ones(3), "/VTKHDF/PointData/diameter"),
                    ("VTKHDF/PointData/attitude_xyzw", np.ones((100, 4)), "/VTKHDF/PointData/attitude_xyzw"),
                    ("walls", np.ones((1, 3)), "/walls has 3 columns")])
    for name in ("VTKHDF/Points", "VTKHDF/PointData/attitude_xyzw", "VTKHDF/PointData/diameter", "walls"):
        write_run(path)
        with h5py.File(path, "a") as file:
            file[name][...] = np.nan
        refuses(program, path, path, f"dataset /{name} has a number that is not finite")
    write_run(path)
    with h5py.File(path, "a") as file:
        for name in set(energies(0)) - {"total"}:
            del file["energies"][name]
    refuses(program, path, path, "group /energies has no term of the total")
    for name, shape, words in (("wall_cylinders", (1, 6), "/wall_cylinders has 6 columns"),
                               ("wall_velocities", (1, 3), "/wall_velocities has the shape (1, 3)")):
        write_run(path)
        with h5py.File(path, "a") as file:
            file[name] = np.ones(shape)
        refuses(program, path, path, words)


def _canvas(artists, size):
    """Pixels of a square of the units 0 to size, lowest row last."""
    style, = modules("style")
    figure = style.new_figure(4, 4)
    figure.set_dpi(FINE)
    figure.set_layout_engine("none")
    axes = figure.add_axes((0, 0, 1, 1))
    for artist in artists(axes):
        axes.add_artist(artist)
    axes.set(xlim=(0, size), ylim=(0, size), aspect="equal")
    axes.set_axis_off()
    figure.canvas.draw()
    return np.asarray(figure.canvas.buffer_rgba())[..., :3].astype(float)


def test_painted(_program, _folder):
    """Of many bodies an image is painted that looks as what matplotlib draws of them one by one: the same within a fifth of
    the colours' range at each spot of 6 x 6 pixels, whose edges the two smooth in other ways, and within a fiftieth on the
    mean."""
    painted, scenery = modules("painted", "scenery")
    random = np.random.default_rng(1)
    colours = np.array(scenery.FRAGMENTS[:5])
    layers = np.argwhere(np.ones((20, 20, 20)))[:, [1, 2]] + 2.0     # 20 spheres in a row
    cases = {"few": (60, 0.5, 3.0), "ellipses": (3000, 0.1, 2.0), "dust": (4000, 0.01, 0.2), "many": (20000, 0.5, 1.0), "rows": (8000, 1, 1)}
    for name, (count, low, high) in cases.items():
        centres = layers if name == "rows" else random.uniform(-1, 25, (count, 2)) * (1, 0.7)   # nothing is at the top
        widths = random.uniform(low, high, count)
        heights = widths * random.uniform(0.3, 1.0, count) if name == "ellipses" else widths
        angles = random.uniform(0, 180, count) if name == "ellipses" else np.zeros(count)
        each = centres, widths, heights, angles, colours[random.integers(0, 5, count)]
        rim = 0.5 if name in ("few", "ellipses") else 0.15
        drawn = _canvas(lambda axes: [scenery.EllipseCollection(*each[1:4], units="xy", offsets=each[0], transOffset=axes.transData,
                                                                facecolors=each[4], edgecolors=scenery.RIM, linewidths=rim)], 24)
        made = _canvas(lambda _: [painted.Painted(*each, scenery.RIM, rim)], 24)
        differ = np.abs((made - drawn).reshape(100, 6, 100, 6, 3).mean(axis=(1, 3))) / 255
        assert np.mean(differ) < 0.02 and np.max(differ) < 0.2, f"{name}: {np.mean(differ):.3f} on the mean, {np.max(differ):.3f} at most"
    # so many that they lie everywhere on others: nothing shines through, though those that no pixel shows are left out
    centres, half = random.uniform(0, 200, (100000, 2)).astype(np.float32), np.full((100000, 2), 4, np.float32)
    assert 81 * 9 * len(centres) > painted.CHEAP
    made = painted.image((200, 200), centres, half, None, 0.3, painted.rgba(["#000000", "#0000FF", *["#FF0000"] * len(centres)]))
    assert np.all(made[10:-10, 10:-10, 3] == 255), f"{np.sum(made[10:-10, 10:-10, 3] < 255)} pixels are not covered"


def test_many(program, folder):
    """Bodies too many to be drawn one by one are painted, at the size and place that they have; fewer are drawn."""
    run_file, painted, scenery, shapes = modules("run_file", "painted", "scenery", "shapes")
    for count, is_painted in ((scenery.MOST_DRAWN, False), (scenery.MOST_DRAWN + 1, True)):
        path = os.path.join(folder, f"{count}.h5")
        write_run(path, count=count, frames=2, rows=20, walls=False)
        with h5py.File(path, "a") as file:     # one that fills the lower right quarter, in front
            x = file["VTKHDF/Points"][...]
            x[[0, count]] = 3, -1, 5
            file["VTKHDF/Points"][...] = x
            file["VTKHDF/PointData/diameter"][0] = 1
        figure, _ = shapes.draw(run_file.read_run(path))
        axes = figure.axes[0]
        kinds = {type(artist) for artist in axes.get_children()}
        assert (painted.Painted in kinds, scenery.EllipseCollection in kinds) == (is_painted, not is_painted), f"{count}: {kinds}"
        figure.set_dpi(FINE)
        figure.canvas.draw()
        pixels = np.asarray(figure.canvas.buffer_rgba())[..., :3]
        for place, inside in (((3, -1), True), ((3, -0.55), True), ((3, -0.4), False), ((3.45, -1), True), ((2.4, -1), False)):
            column, row = np.round(axes.transData.transform(place)).astype(int)
            filled = tuple(pixels[len(pixels) - 1 - row, column]) == tuple(np.round(255 * np.array(matplotlib.colors.to_rgb(scenery.BODY))))
            assert filled == inside, f"{count} bodies: at {place} there is {pixels[len(pixels) - 1 - row, column]}"
        draws(program, path, os.path.join(folder, str(count)), pictures=("shapes.png",), only=("shapes.png",))


if __name__ == "__main__":
    plot_support.main(test_pictures, test_contacts, test_looks, test_scenes, test_walls, test_rest, test_level, test_plane, test_fragments, test_no_bond_made, test_varying_steps,
                      test_scale, test_painted, test_many, test_momenta, test_short_times, test_names, test_room, test_kept_exactly, test_curves, test_film, test_figures, test_refusals)
