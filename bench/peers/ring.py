# SPDX-License-Identifier: BSD-3-Clause
"""The ring of the paper's impact in LAMMPS, by itself in flight, and two of its spheres."""

import math
import os

import numpy

from case import Case, hertz
from lammps import HERE, thermo, vti, vti_columns, write_data


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
