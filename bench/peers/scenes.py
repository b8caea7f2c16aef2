# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of the project in LAMMPS: a pile that keeps its energy, a heap that comes to rest, an agglomerate that
breaks. The numbers of both stand here; vti-run is told them by --set. LAMMPS begins with the state in
which vti-run begins."""

import math
import os
import resource
import statistics
import subprocess
import sys

import numpy

from lammps import (
    HERE,
    SCENES,
    frames,
    thermo,
    tsuji_of,
    vti,
    vti_columns,
    vti_command,
    vti_frames,
    write_data,
    zeta_of,
)

G = 9.81


def hertz(stiffness, diameter, poisson, pairs):
    """Young's modulus of hertz/material for our K: F = K/D^(5/2) overlap^(3/2) of a pair, K/(D/2)^(5/2) of a sphere
    at a plane. LAMMPS has 4/3 E/(2 (1 - nu^2)) sqrt(R) of both: its planes are of the spheres' material."""
    reach, radius = (diameter, diameter / 4) if pairs else (diameter / 2, diameter / 2)
    return 1.5 * (1 - poisson**2) * stiffness / reach**2.5 / math.sqrt(radius)


def spring_slider(kind, radius, limit, stiffness, damping):
    """sds: rolling is written as forces at the effective radius, twisting as moments."""
    scale = (radius, radius**2, radius**2) if kind == "rolling" else (1, 1, 1)
    return f"{kind} sds {stiffness / scale[1]!r} {damping / scale[2]!r} {limit / scale[0]!r}"


class Case:
    """A scene, and how LAMMPS is told the same."""

    script = scene = ""
    settings = {}
    h, t_end, record = 1.0, 1.0, 1
    room = 2  # around the spheres, in diameters

    def __init__(self, lammps, vti_run, folder):
        self.lammps, self.vti_run, self.folder = lammps, vti_run, os.path.join(folder, self.scene)
        os.makedirs(self.folder, exist_ok=True)

    def steps(self, h):
        return round(self.t_end / h)

    def vti_words(self, h, pictures=1):
        """Frames at so many times besides the start."""
        steps = self.steps(h)
        scene = os.path.join(SCENES, self.scene + ".yaml")
        return (
            self.vti_run,
            scene,
            os.path.join(self.folder, "out.h5"),
            dict(self.settings, h=h, t_end=steps * h * (1 + 1e-9)),
            "--record",
            str(self.record),
            "--frames",
            str(steps // pictures),
            "--threads",
            "1",
        )

    def by_vti(self, h, pictures=1):
        vti(*self.vti_words(h, pictures))
        out = os.path.join(self.folder, "out")
        return vti_columns(out + ".csv"), vti_frames(out + ".h5")

    def prepare(self):
        """The file of spheres, from the first frame of a run of one step."""
        words = self.vti_words(self.h)
        vti(words[0], words[1], words[2], dict(words[3], t_end=self.h))
        _, x, v, omega, bonds = vti_frames(words[2])
        diameter = numpy.full(len(x[0]), self.diameter)
        density = numpy.full(len(x[0]), self.mass / (math.pi / 6 * self.diameter**3))
        atoms = os.path.join(self.folder, "spheres.data")
        write_data(atoms, x[0], v[0], omega[0], diameter, density, bonds, self.room)
        return atoms

    def variables(self, h, atoms, pictures=0):
        steps = self.steps(h)
        given = {"atoms": atoms, "h": h, "steps": steps, "every": self.record, **self.laws()}
        if self.script != "torus.in":
            given.update(out=os.path.join(self.folder, "spheres.dump"), frame=steps // pictures if pictures else 0)
        return given

    def by_lammps(self, h, pictures=1):
        """Rows of energies, and of the dump."""
        given = self.variables(h, self.prepare(), pictures)
        return thermo(self.lammps.run(self.script, **given)), frames(given["out"])

    def by_lammps_rows(self, h):
        return thermo(self.lammps.run(self.script, **self.variables(h, self.prepare())))

    def times(self, rounds):
        """Median processor seconds of both as whole processes that record energies and write no dump, in turns, and
        of their ratios with least and largest."""
        theirs = self.lammps.command(self.script, **self.variables(self.h, self.prepare()))
        commands = {"vti": (vti_command(*self.vti_words(self.h)), None), "LAMMPS": (theirs, self.lammps.environment)}
        took = {who: [] for who in commands}
        for _ in range(rounds):
            for who, command in commands.items():
                took[who].append(processor_seconds(*command))
        ratios = [theirs / ours for theirs, ours in zip(took["LAMMPS"], took["vti"])]
        return (
            statistics.median(took["vti"]),
            statistics.median(took["LAMMPS"]),
            statistics.median(ratios),
            min(ratios),
            max(ratios),
        )


def processor_seconds(command, environment):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 3):
        sys.exit(f"peers: {' '.join(command)}: {done.stdout[-1000:]}{done.stderr[-1000:]}")
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


class Pile(Case):
    """Nothing turns and nothing is lost: the same law to the last digit, and the same method."""

    scene, script = "pile", "heap.in"
    h, t_end, record = 1 / 2048, 10.0, 64
    diameter, mass, stiffness = 1.0, 1.0, 1e5
    settings = {"contact.stiffness": stiffness, "wall.stiffness": stiffness}

    def laws(self):
        words = "hertz/material {!r} 0.0 0.25 tangential linear_nohistory 0.0 0.0 damping velocity"
        return {
            "law": words.format(hertz(self.stiffness, 1.0, 0.25, True)),
            "floor": words.format(hertz(self.stiffness, 1.0, 0.25, False)),
            "side": 4.5,
            "skin": 0.1,
        }


def overlaps(case, x):
    """Elastic energy of the pile, in each frame: 2/5 K (1 - r/D)^(5/2) of each pair, 2/5 K (1 - 2 g/D)^(5/2) at each
    plane."""
    d, side, found = case.diameter, 4.5, []
    for frame in x:
        apart = numpy.linalg.norm(frame[:, None] - frame[None, :], axis=2)[numpy.triu_indices(len(frame), 1)]
        gaps = numpy.concatenate([frame[:, 2], frame[:, 0], frame[:, 1], side - frame[:, 0], side - frame[:, 1]])
        found.append(sum((numpy.maximum(0, 1 - r) ** 2.5).sum() for r in (apart / d, 2 * gaps / d)))
    return 0.4 * case.stiffness * numpy.array(found)


class Heap(Case):
    """Friction and dashpots as near as LAMMPS has them: mindlin_rescale/force, tsuji with the same coefficient, no
    pull."""

    scene, script = "heap", "heap.in"
    h, t_end, record = 1 / 2048, 12.0, 64
    diameter, mass, stiffness = 1.0, 1.0, 1e5
    mu, poisson, restitution, ratio = 0.5, 0.3, 0.5, 0.5
    limit, spring, damping = 0.1, 1000.0, 5.0
    settings = {
        "contact.stiffness": stiffness,
        "wall.stiffness": stiffness,
        "friction.sliding": mu,
        "friction.poisson": poisson,
        "friction.rolling": limit,
        "friction.rolling_stiffness": spring,
        "friction.twisting": limit,
        "friction.twisting_stiffness": spring,
        "dashpot.restitution": restitution,
        "dashpot.ratio": ratio,
        "dashpot.rolling": damping,
        "dashpot.twisting": damping,
    }

    def law(self, pairs):
        e, radius = tsuji_of(zeta_of(self.restitution)), self.diameter / (4 if pairs else 2)
        more = " ".join(
            spring_slider(kind, radius, self.limit, self.spring, self.damping) for kind in ("rolling", "twisting")
        )
        return (
            f"hertz/material {hertz(self.stiffness, self.diameter, self.poisson, pairs)!r} {e!r} {self.poisson!r} "
            f"tangential mindlin_rescale/force NULL {self.ratio!r} {self.mu!r} damping tsuji {more} limit_damping"
        )

    def laws(self):
        return {"law": self.law(True), "floor": self.law(False), "side": 0, "skin": 0.1}


class Agglomerate(Case):
    """Bonds that break: bpm/rotational with the stiffnesses, coefficients and limits of ours."""

    scene, script = "agglomerate", "agglomerate.in"
    h, t_end, record = 2e-7, 1.5e-3, 25
    diameter, mass = 1e-3, 1.414e-6
    axial, shear, moment = 0.196, 0.079, 3.07e-3
    limits = {"normal": 0.98, "shear": 0.98, "bending": 6.1e-5, "torsion": 1.22e-4}
    zeta, pair, plane, mu, poisson, restitution, ratio = 0.05, 0.355, 0.0888, 0.4, 0.25, 0.6, 0.3
    smooth = "no"
    settings = {
        "binder.axial": axial,
        "binder.shear.stiffness": shear,
        "binder.moment": moment,
        "bond_dashpot.zeta": zeta,
        **{f"binder.break.{key}": value for key, value in limits.items()},
        "contact.stiffness": pair,
        "wall.stiffness": plane,
        "wall.planes": "[[0.36, 0.48, 0.8, -8e-4]]",
        "friction.sliding": mu,
        "friction.poisson": poisson,
        "dashpot.restitution": restitution,
        "dashpot.ratio": ratio,
    }

    def law(self, pairs):
        e = tsuji_of(zeta_of(self.restitution))
        young = hertz(self.pair if pairs else self.plane, self.diameter, self.poisson, pairs)
        return (
            f"hertz/material {young!r} {e!r} {self.poisson!r} tangential mindlin_rescale/force NULL {self.ratio!r} "
            f"{self.mu!r} damping tsuji limit_damping"
        )

    def bond(self):
        """k_r, k_s, k_t, k_b, four limits, and gamma_n, gamma_s, gamma_r, gamma_t, of which the last two are 2 c_r/L
        and 2 c_w."""
        length, mass, inertia = self.diameter, self.mass, 0.1 * self.mass * self.diameter**2
        radial, across = self.axial / length**2, self.shear / length**2
        reduced = {"n": mass / 2, "t": 1 / (2 / mass + length**2 / (2 * inertia)), "r": inertia / 2}
        damping = [
            2 * self.zeta * math.sqrt(m * k)
            for m, k in ((reduced["n"], radial), (reduced["t"], across), (reduced["r"], self.moment))
        ]
        numbers = [
            radial,
            across,
            self.moment,
            self.moment,
            self.limits["normal"],
            self.limits["shear"],
            self.limits["torsion"],
            self.limits["bending"],
            damping[0],
            damping[1],
            2 * damping[2] / length,
            2 * damping[2],
        ]
        return " ".join(repr(number) for number in numbers)

    def laws(self):
        return {
            "law": self.law(True),
            "floor": self.law(False),
            "bond": self.bond(),
            "smooth": self.smooth,
            "cutoff": 4e-3,
            "skin": 2e-4,
            "point": " ".join(repr(-8e-4 * c) for c in (0.36, 0.48, 0.8)),
            "normal": "0.36 0.48 0.8",
        }


class Torus(Case):
    """The ring of the paper's impact: bonds that do not break, contacts and a plane. LAMMPS' spheres have the inertia
    of solid ones, and so have ours here."""

    scene, script = "torus", "torus.in"
    h, t_end, record, room = 1e-3, 4.5, 250, 25
    diameter, mass, edge = 0.1177794472772058271, 1.0, "f"
    bond, shear, moment, stiffness = 200.0, 200.0, 10.0, 2100.0
    settings = {
        "bodies.inertia": 0.1 * mass * diameter**2,
        "binder.axial": bond,
        "binder.shear.stiffness": shear,
        "binder.moment": moment,
        "contact.stiffness": stiffness,
        "wall.stiffness": stiffness,
    }

    def laws(self):
        numbers = [self.bond / self.diameter**2, self.shear / self.diameter**2, self.moment, self.moment]
        words = "hertz/material {!r} 0.0 0.25 tangential linear_nohistory 0.0 0.0 damping velocity"
        return {
            "law": words.format(hertz(self.stiffness, self.diameter, 0.25, True)),
            "floor": words.format(hertz(self.stiffness, self.diameter, 0.25, False)),
            "bond": " ".join(repr(number) for number in numbers + 4 * [1e9] + 4 * [0.0]),
            "edge": self.edge,
            "skin": 0.1,
        }


class Flight(Torus):
    """The same ring flies away from the plane, shaken: nothing meets, so that LAMMPS comes to the end."""

    t_end, record, room, edge = 35.0, 100, 2, "m"
    settings = dict(
        Torus.settings,
        **{"bodies.v": "[1, 0, 0]", "bodies.random.seed": 1, "bodies.random.v": 0.1, "bodies.random.omega": 0.1},
    )


class Bonded(Torus):
    """Two spheres with a bond of the ring that spin against each other, far from the plane."""

    t_end = 2.0
    spins = {
        "about the same line, (0, 30, 0) and (0, -30, 0)": ((0.0, 30, 0), (0.0, -30, 0)),
        "about two, (5, 30, 0) and (-5, 10, 20)": ((5.0, 30, 0), (-5.0, 10, 20)),
        "about two, (0, 60, 0) and (10, -60, 30)": ((0.0, 60, 0), (10.0, -60, 30)),
    }

    def largest(self, spins, h):
        """Largest kinetic energy over that at the start, which is all energy that there is: LAMMPS', ours."""
        x, v, omega = numpy.array([[2.0, 0, 0], [2.0 + self.diameter, 0, 0]]), numpy.zeros((2, 3)), numpy.array(spins)
        density = numpy.full(2, self.mass / (math.pi / 6 * self.diameter**3))
        atoms = os.path.join(self.folder, "pair.data")
        write_data(atoms, x, v, omega, numpy.full(2, self.diameter), density, [(0, 1)], self.room)
        rows = thermo(self.lammps.run(self.script, **dict(self.variables(h, atoms), every=1)))
        tables = {name: os.path.join(self.folder, name + ".csv") for name in ("bodies", "bonds")}
        with open(tables["bodies"], "w", encoding="ascii") as file:
            print("x,y,z,omega_x,omega_y,omega_z,mass,inertia,diameter", file=file)
            for place, spin in zip(x, omega):
                numbers = (*place, *spin, self.mass, self.settings["bodies.inertia"], self.diameter)
                print(*(repr(float(number)) for number in numbers), sep=",", file=file)
        with open(tables["bonds"], "w", encoding="ascii") as file:
            print("i,j\n0,1", file=file)
        given = {"bodies.table": os.path.abspath(tables["bodies"]), "binder.table": os.path.abspath(tables["bonds"])}
        out = os.path.join(self.folder, "pair.h5")
        steps = self.steps(h)
        vti(
            self.vti_run,
            os.path.join(HERE, "bonded.yaml"),
            out,
            dict(given, h=h, t_end=steps * h * (1 + 1e-9)),
            "--record",
            "1",
            "--frames",
            str(steps),
            "--threads",
            "1",
        )
        columns = vti_columns(out[:-3] + ".csv")
        ours = columns["kinetic_translation"] + columns["kinetic_rotation"]
        return (rows[:, 1] + rows[:, 2]).max() / (rows[0, 1] + rows[0, 2]), ours.max() / ours[0]
