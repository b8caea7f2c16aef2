# SPDX-License-Identifier: BSD-3-Clause
"""A scene of the project that LAMMPS is told as well: both run it, and here are their rows, their frames, and what they
take. vti-run is told the numbers by --set. LAMMPS begins with the state in which vti-run begins."""

import math
import os
import resource
import statistics

import numpy

from lammps import SCENES, finished, frames, thermo, vti, vti_columns, vti_command, vti_frames, write_data


def hertz(stiffness, diameter, poisson, pairs):
    """Young's modulus of hertz/material for our K: F = K/D^(5/2) overlap^(3/2) of a pair, K/(D/2)^(5/2) of a sphere
    at a plane. LAMMPS has 4/3 E/(2 (1 - nu^2)) sqrt(R) of both: its planes are of the spheres' material."""
    reach, radius = (diameter, diameter / 4) if pairs else (diameter / 2, diameter / 2)
    return 1.5 * (1 - poisson**2) * stiffness / reach**2.5 / math.sqrt(radius)


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

    def commands(self):
        """What times runs, by whom: the whole run, and one of one step, which does what is done once: it starts, reads,
        and opens and closes files."""
        whole, words = self.variables(self.h, self.prepare()), self.vti_words(self.h)
        one = (*words[:3], dict(words[3], t_end=self.h), *words[4:])
        ours = [(vti_command(*part), None) for part in (words, one)]
        theirs = [(self.lammps.command(self.script, **part), self.lammps.environment) for part in (whole, dict(whole, steps=1))]
        return {"vti": ours, "LAMMPS": theirs}

    def times(self, rounds):
        """Median processor seconds of both, which record energies and write no dump, in turns, and of their ratios with
        least and largest. Of each turn that of one step is taken off: how long a program takes to start depends on how
        it is linked, not on how it steps."""
        commands = self.commands()
        took = {who: [] for who in commands}
        for _ in range(rounds):
            for who, (whole, one) in commands.items():
                took[who].append(processor_seconds(*whole) - processor_seconds(*one))
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
    finished(command, (0, 3), env=environment)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
