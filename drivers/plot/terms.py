# SPDX-License-Identifier: BSD-3-Clause
"""The columns of a run's energies in the paper's terms: symbol, wording and colour, the same in every picture."""
from dataclasses import dataclass

from . import words


@dataclass(frozen=True)
class Term:
    symbol: str
    meaning: str
    colour: str


TERMS = {
    "kinetic_translation": Term(r"$m‖v‖^2\!/2$", "translation", "#0072B2"),
    "kinetic_rotation": Term(r"$J‖\Omega‖^2\!/2$", "rotation", "#56B4E9"),
    "binder_moment": Term(r"$U^{\mathrm{m}}$", "bending and torsion", "#E69F00"),
    "binder_axial": Term(r"$U^{\mathrm{a}}$", "axial", "#D55E00"),
    "binder_shear": Term(r"$U^{\mathrm{s}}$", "shear", "#AA4499"),
    "contact": Term(r"$U^{\mathrm{pp}}$", "particle-particle", "#332288"),
    "wall": Term(r"$U^{\mathrm{pw}}$", "particle-wall", "#009E73"),
    "gravity": Term(r"$U^{\mathrm{g}}$", "gravity", "#999933"),
    "pendulum": Term(r"$U$", "pendulum", "#999933"),
}
OTHERS = ("#882255", "#777777", "#88CCEE")


def of(names):
    """name -> Term, in that order; a column this version does not know is shown by its own name."""
    unknown = [name for name in names if name not in TERMS]
    return {name: TERMS.get(name) or Term(words.plain(name.replace("_", " ")), "",
                                          OTHERS[unknown.index(name) % len(OTHERS)]) for name in names}
