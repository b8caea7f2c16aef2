# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of the project in LAMMPS: a pile that keeps its energy, a heap that comes to rest, an agglomerate that
breaks. The numbers of both stand here."""

import math

import numpy

from case import Case, hertz
from lammps import tsuji_of, zeta_of

G = 9.81


def spring_slider(kind, radius, limit, stiffness, damping):
    """sds: rolling is written as forces at the effective radius, twisting as moments."""
    scale = (radius, radius**2, radius**2) if kind == "rolling" else (1, 1, 1)
    return f"{kind} sds {stiffness / scale[1]!r} {damping / scale[2]!r} {limit / scale[0]!r}"


class Pile(Case):
    """Nothing turns and nothing is lost: the same law to the last digit, and the same method."""

    scene, script = "pile", "heap.in"
    h, t_end, record = 1 / 2048, 10.0, 64
    diameter, mass, stiffness = 1.0, 1.0, 1e5
    settings = {"contact.stiffness": stiffness, "wall.stiffness": stiffness}

    def laws(self):
        words = "hertz/material {!r} 0.0 0.25 tangential linear_nohistory 0.0 0.0 damping velocity"
        pairs = hertz(self.stiffness, 1.0, 0.25, True) / (1.5 * (1 - 0.25**2))
        return {
            "pair": f"gran/hertz/history {pairs!r} 0 0 0 0 0",
            "law": "",
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
        return {"pair": "granular", "law": self.law(True), "floor": self.law(False), "side": 0, "skin": 0.1}


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
        """k_r, k_s, k_t, k_b, four limits, and four gammas. The last two are 2 c_r/L and 2 c_w, in the other order
        since July 2026."""
        length, mass, inertia = self.diameter, self.mass, 0.1 * self.mass * self.diameter**2
        radial, across = self.axial / length**2, self.shear / length**2
        reduced = {"n": mass / 2, "t": 1 / (2 / mass + length**2 / (2 * inertia)), "r": inertia / 2}
        damping = [
            2 * self.zeta * math.sqrt(m * k)
            for m, k in ((reduced["n"], radial), (reduced["t"], across), (reduced["r"], self.moment))
        ]
        turning = [2 * damping[2] / length, 2 * damping[2]]
        if self.lammps.bonds_of_before():
            turning.reverse()
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
        ]
        return " ".join(repr(number) for number in numbers + turning)

    def laws(self):
        return {
            "law": self.law(True),
            "floor": self.law(False),
            "bond": self.bond(),
            "smooth": self.smooth,
            # the frame average of July 2026 counts pressure as tension where it asks what breaks, and takes twice the
            # time
            "frame_style": self.lammps.bonds_of_before(),
            "cutoff": 4e-3,
            "skin": 2e-4,
            "point": " ".join(repr(-8e-4 * c) for c in (0.36, 0.48, 0.8)),
            "normal": "0.36 0.48 0.8",
        }
