# SPDX-License-Identifier: BSD-3-Clause
"""Reading the out.h5 of a run, and refusing it in one sentence where it is not what vti-run writes.

    attributes of the file   scene, stepper, h, vti_version; touching (which pairs that overlap are in contact: 1 those without
                             a line, 2 all, 0 none); planes (what planes and cylinders are, "wall")
    /energies/<column>       a column of out.csv: t, energies, total, momenta; one row per recorded time; symbol, meaning and
                             colour of energies as attributes
    /<what>s                 planes n.x = d at t = 0 as rows nx, ny, nz, d, if the scene has walls
    /<what>_cylinders        cylinders at t = 0 as rows ax, ay, az, x, y, z, R (axis, a point on it, radius), if it has any
    /<what>_velocities       of planes, then of cylinders, and /<what>_spins about their axes, if walls move
    /clumps                  body, offset and diameter of each sphere of bodies that are several
    /VTKHDF                  the trajectory, frame after frame: Points, PointData, Lines (pairs of bodies), Steps/Values (times)
"""
from dataclasses import dataclass

import numpy as np

from . import outlines
from .hdf5_file import RUN, Reader, opened, text

NOT_ENERGIES = ("t", "total", "energy_modified", "bonds", "fragments", "error_velocity", "error_omega")
VECTORS = ("momentum", "spin", "angular")
BLOWN = 10      # times all energies at t = 0: an error of this size is no error any more


@dataclass
class Frame:
    """All bodies at one time; what the scene lacks is None."""
    t: float
    x: np.ndarray           # n, 3
    attitude: np.ndarray    # n, 4: unit quaternions x, y, z, w
    lines: np.ndarray       # k, 2: pairs of bodies that something holds at that time
    fragment: np.ndarray = None     # n: the first body of the fragment, where lines may break
    spheres: np.ndarray = None      # m, 3: centres of the spheres of clumps
    ellipsoid: np.ndarray = None    # n, 3, 3: R diag(axes) R^T of bodies that are drawn so


@dataclass
class Clumps:
    """The spheres of bodies that are several each."""
    body: np.ndarray        # m
    offset: np.ndarray      # m, 3: from the body's centre, in the body
    diameter: np.ndarray    # m


@dataclass
class Walls:
    """Planes and cylinders of all effects, as they are at t = 0, with their velocities."""
    names: list                     # of the effects: "wall"
    planes: np.ndarray              # k, 4
    cylinders: np.ndarray           # k, 7
    plane_velocity: np.ndarray      # k, 3
    cylinder_velocity: np.ndarray   # k, 3
    cylinder_spin: np.ndarray       # k

    def move(self):
        return bool(np.any(self.plane_velocity) or np.any(self.cylinder_velocity) or np.any(self.cylinder_spin))

    def planes_at(self, t):
        moved = np.sum(self.planes[:, :3] * self.plane_velocity, axis=1) * t
        return np.column_stack([self.planes[:, :3], self.planes[:, 3] + moved])

    def cylinders_at(self, t):
        """Rows as those of cylinders, and behind them the angles by which they have turned."""
        points = self.cylinders[:, 3:6] + self.cylinder_velocity * t
        return np.column_stack([self.cylinders[:, :3], points, self.cylinders[:, 6], self.cylinder_spin * t])


@dataclass
class Run:
    path: str
    scene: str
    stepper: str
    h: float
    version: str
    columns: dict           # name -> values over time, all of one length
    times: np.ndarray       # of the frames
    bodies: int
    translates: bool
    turns: bool
    diameter: np.ndarray    # of the bodies, or None
    lines: np.ndarray       # k, 2: pairs of bodies that something holds
    walls: Walls
    touching: int           # pairs that overlap are in contact: 0 none, 1 those without a line, 2 all
    looks: dict             # name of an energy -> symbol, meaning, colour
    breaks: bool = False    # lines may break
    clumps: Clumps = None
    ellipsoids: bool = False    # bodies have three moments, by which they are drawn
    lost: float = None      # when the run blew up; what follows is left out of all but total_to_the_end
    total_to_the_end: tuple = None  # t, total

    def notes(self):
        return [] if self.lost is None else [f"the run blew up: from t = {self.lost:.4g} on its energy is off by more than "
                                             f"{BLOWN} times what it began with"]

    def energies(self):
        """Kinetic and potential energies by name, in the order of the paper."""
        return {name: values for name, values in self.columns.items()
                if name not in NOT_ENERGIES and name[:-2] not in VECTORS}

    def vector(self, name):
        """Columns of momentum, spin or angular momentum as an array [time][3], or None."""
        parts = [self.columns.get(f"{name}_{axis}") for axis in "xyz"]
        return None if any(part is None for part in parts) else np.stack(parts, axis=1)

    def longest(self, name):
        """The largest of the vectors of that name in VTKHDF, in some frames; 0 if there are none."""
        with opened(self.path) as file:
            data = file["VTKHDF"].get(name)
            some = np.unique(np.linspace(0, len(self.times) - 1, 16).astype(int)) if data is not None else []
            largest = [np.max(np.linalg.norm(data[k * self.bodies:(k + 1) * self.bodies], axis=1), initial=0.0) for k in some]
        return max(largest, default=0.0)

    def frame(self, k):
        """Read on demand: a trajectory may be larger than the memory."""
        rows = slice(k * self.bodies, (k + 1) * self.bodies)
        with opened(self.path) as file:
            reader = Reader(self.path, file, RUN)
            x = reader.finite("/VTKHDF/Points", 2, rows)
            attitude = reader.finite("/VTKHDF/PointData/attitude_xyzw", 2, rows) if self.turns else None
            shapes = self._shapes(reader, rows, x, attitude)
            if not self.breaks:
                return Frame(float(self.times[k]), x, attitude, self.lines, **shapes)
            cells = self.bodies + len(self.lines)
            holds = np.zeros(0)
            if len(self.lines):  # a run in which no bond was made has no such data
                holds = reader.numbers("/VTKHDF/CellData/bond_holds", 1, slice(k * cells + self.bodies, (k + 1) * cells))
            fragment = reader.numbers("/VTKHDF/PointData/fragment", 1, rows)
        return Frame(float(self.times[k]), x, attitude, self.lines[holds == 1], fragment, **shapes)

    def _shapes(self, reader, rows, x, attitude):
        if self.clumps is not None:
            body = self.clumps.body
            return {"spheres": x[body] + outlines.turned(attitude[body], self.clumps.offset)}
        if self.ellipsoids:
            return {"ellipsoid": reader.finite("/VTKHDF/PointData/ellipsoid", 2, rows).reshape(-1, 3, 3)}
        return {}


def read_run(path):
    """The whole file but for the frames, checked."""
    with opened(path) as file:
        reader = Reader(path, file, RUN)
        columns = {name: reader.numbers(f"/energies/{name}") for name in _column_names(reader)}
        reader.same_lengths(columns, "/energies")
        if len(columns["t"]) == 0:
            raise reader.trouble("holds no recorded times")
        if not np.all(np.diff(columns["t"][np.isfinite(columns["t"])]) > 0):
            raise reader.trouble("dataset /energies/t has times that do not rise")
        times, data = reader.finite("/VTKHDF/Steps/Values"), reader.group("/VTKHDF/PointData")
        points = reader.dataset("/VTKHDF/Points", 2)
        bodies = len(points) // max(1, len(times))
        _must_have_shape(reader, "/VTKHDF/Points", (bodies * len(times), 3))
        if "attitude_xyzw" in data:
            _must_have_shape(reader, "/VTKHDF/PointData/attitude_xyzw", (bodies * len(times), 4))
        diameter = None
        if "diameter" in data:
            _must_have_shape(reader, "/VTKHDF/PointData/diameter", (bodies,))
            diameter = reader.finite("/VTKHDF/PointData/diameter")
        lines = reader.numbers("/VTKHDF/Lines/Connectivity").astype(int)
        if len(lines) % 2 or len(lines) and not 0 <= lines.min() <= lines.max() < bodies:
            raise reader.trouble("/VTKHDF/Lines/Connectivity names a body that does not exist, or none")
        walls = _walls(reader, [name for name in text(file.attrs.get("planes", "")).split(",") if name])
        looks = {name: tuple(text(dataset.attrs[key]) for key in ("symbol", "meaning", "colour"))
                 for name, dataset in file["energies"].items() if "symbol" in dataset.attrs}
        run = Run(path, text(reader.attribute("scene")), text(reader.attribute("stepper")), reader.number("h"),
                  text(reader.attribute("vti_version")), columns, times, bodies, "velocity" in data,
                  "attitude_xyzw" in data, diameter, lines.reshape(-1, 2), walls,
                  int(reader.number("touching")) if "touching" in file.attrs else 0, looks, "fragment" in data,
                  _clumps(reader, bodies), "ellipsoid" in data and "clumps" not in file)
        if run.ellipsoids:
            _must_have_shape(reader, "/VTKHDF/PointData/ellipsoid", (bodies * len(times), 9))
        if not run.energies():
            raise reader.trouble("group /energies has no term of the total")
        _cut(run)
        if len(run.columns["t"]) == 0 or len(run.times) == 0:
            raise reader.trouble("holds no number that is finite")
        return run


def _cut(run):
    """Leaves out what follows the blow-up of a run that was too coarse: it would hide all that came before."""
    values = np.array(list(run.columns.values()))
    sound = np.all(np.isfinite(values), axis=0)
    size = sum(abs(energy[0]) for energy in run.energies().values())
    if size > 0:
        error = np.where(sound, run.columns["total"] - run.columns["total"][0], np.inf)
        sound &= np.abs(error) <= BLOWN * size
    if not np.all(sound):
        first = int(np.argmin(sound))
        run.lost = float(run.columns["t"][first])
        run.total_to_the_end = run.columns["t"], run.columns["total"]
        run.columns = {name: column[:first] for name, column in run.columns.items()}
        run.times = run.times[run.times < run.lost]


def _clumps(reader, bodies):
    if "clumps" not in reader.file:
        return None
    body = reader.numbers("/clumps/body").astype(int)
    _must_have_shape(reader, "/clumps/offset", (len(body), 3))
    _must_have_shape(reader, "/clumps/diameter", (len(body),))
    if len(body) == 0 or not 0 <= body.min() <= body.max() < bodies:
        raise reader.trouble("/clumps/body names a body that does not exist, or none")
    return Clumps(body, reader.finite("/clumps/offset", 2), reader.finite("/clumps/diameter"))


def _walls(reader, names):
    parts = [[np.zeros((0, columns)) for columns in (4, 7, 3, 3, 1)]]
    for name in names:
        planes = _rows(reader, f"/{name}s", 4)
        cylinders = _rows(reader, f"/{name}_cylinders", 7) if f"{name}_cylinders" in reader.file else np.zeros((0, 7))
        count = len(planes) + len(cylinders)
        velocity, spin = np.zeros((count, 3)), np.zeros(count)
        if f"{name}_velocities" in reader.file:
            _must_have_shape(reader, f"/{name}_velocities", (count, 3))
            _must_have_shape(reader, f"/{name}_spins", (count,))
            velocity, spin = reader.numbers(f"/{name}_velocities", 2), reader.numbers(f"/{name}_spins")
        parts.append([planes, cylinders, velocity[:len(planes)], velocity[len(planes):], spin[len(planes):, None]])
    *rows, spins = [np.concatenate(part) for part in zip(*parts)]
    return Walls(names, *rows, spins[:, 0])


def _rows(reader, name, columns):
    found = reader.finite(name, 2)
    if found.shape[1] != columns:
        raise reader.trouble(f"{name} has {found.shape[1]} columns instead of {columns}")
    return found


def _must_have_shape(reader, name, shape):
    dataset = reader.dataset(name, len(shape))
    if dataset.shape != shape:
        raise reader.trouble(f"{name} has the shape {dataset.shape} instead of {shape}")


def _column_names(reader):
    """In the order of out.csv where the file knows it: HDF5 itself lists by name."""
    found = list(reader.group("/energies"))
    order = text(reader.file["energies"].attrs.get("columns", "t")).split(",")
    for name in ("t", "total"):
        if name not in found:
            raise reader.trouble(f"lacks dataset /energies/{name}")
    return [name for name in order if name in found] + [name for name in found if name not in order]
