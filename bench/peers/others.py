# SPDX-License-Identifier: BSD-3-Clause
"""LIGGGHTS and YADE, the distribution's packages, as programs that let two spheres meet, or turn as one. Both know one
ratio of the dashpots across and along the normal, that of the roots of the stiffnesses."""

import json
import math
import os
import shutil
import sys

import numpy

from lammps import HERE, finished, frames, write_data


class Liggghts:
    """`pair_style gran model hertz tangential history`"""

    name, planes = "LIGGGHTS", True

    def __init__(self, folder, young, poisson, density):
        self.folder, self.density = folder, density
        self.material = {"young": young, "poisson": poisson}

    def dumped(self, script, **variables):
        out = os.path.join(self.folder, "liggghts.dump")
        words = ["liggghts", "-log", "none", "-in", os.path.join(HERE, script), "-var", "out", out]
        for name, value in {**self.material, **variables}.items():
            words += ["-var", name, repr(value) if isinstance(value, float) else str(value)]
        finished(words)
        return frames(out)

    def impact(self, spheres, plane, zeta, friction, h, steps):
        """v and omega of each after it."""
        atoms = os.path.join(self.folder, "liggghts.data")
        write_data(atoms, *spheres, numpy.full(len(spheres[0]), self.density))
        # its coefficient is sqrt(20/3) beta sqrt(m E* sqrt(R)) overlap^(1/4), beta = -ln e/sqrt(ln^2 e + pi^2): our
        # zeta
        restitution = math.exp(-math.pi * zeta / math.sqrt(1 - zeta**2))
        end = self.dumped("liggghts_impact.in", atoms=atoms, plane=int(plane), restitution=restitution, friction=friction, h=h,
                          steps=steps)[-1]
        return end[:, 3:6], end[:, 6:9]

    def turned(self, axis, steps):
        """The second sphere's way from the first, and the force on it, before the turn and after it."""
        dump = self.dumped("liggghts_turned.in", axis=axis, turn=steps)
        return dump[:, 1, :3] - dump[:, 0, :3], dump[:, 1, 3:6]


class Yade:
    """`Law2_ScGeom_MindlinPhys_Mindlin`"""

    name, planes = "YADE", False

    def __init__(self, _, young, poisson, density):
        self.material = {"young": young, "poisson": poisson, "density": density}

    def found(self, **told):
        said = finished(["yade", "-n", "-x", "-j1", os.path.join(HERE, "yade_impact.py")],
                        env={**os.environ, "TOLD": json.dumps({**self.material, **told})})
        lines = [line for line in said.splitlines() if line.startswith("found ")]
        if len(lines) != 1:
            sys.exit(f"peers: YADE does not say what it found: {said.strip()[-1500:]}")
        return numpy.array(json.loads(lines[0].removeprefix("found ")))

    def impact(self, spheres, _, zeta, friction, h, steps):
        """v and omega of each after it."""
        told = [[list(map(float, part)) for part in (x, v, omega)] + [float(d)] for x, v, omega, d in zip(*spheres)]
        # its coefficient is 2 beta sqrt(m k), k the slope of the force
        end = self.found(spheres=told, damping=math.sqrt(5 / 6) * zeta, friction=friction, h=h, steps=steps)
        return end[:, :3], end[:, 3:]

    def turned(self, axis, steps):
        """The second sphere's way from the first, which stays where it is, and the force on it, before the turn and
        after it."""
        found = self.found(damping=0, friction=1e4, axis=list(map(float, axis.split())), steps=steps)
        return found[:, 0], found[:, 1]


def installed():
    return [kind for kind in (Liggghts, Yade) if shutil.which(kind.name.lower())]
