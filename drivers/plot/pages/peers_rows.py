# SPDX-License-Identifier: BSD-3-Clause
"""The files that bench/peers/peers.py and built.py wrote, as rows, and curves of them."""

import csv
import os

import numpy as np

from .. import style
from ..trouble import Trouble

COLUMNS = {
    "rebounds": ("what", "asked", "found"),
    "orders": ("who", "plane", "angle", "steps", "error", "apart"),
    "ledgers": ("who", "angle", "steps", "error"),
    "cycles": ("style", "cycle", "work"),
    "turned": ("who", "axis", "steps", "off"),
    "pile": ("who", "h", "error"),
    "heap": ("who", "h", "t", "kinetic", "height"),
    "agglomerate": ("who", "h", "t", "kinetic", "bonds"),
    "bonded": ("who", "h", "spins", "gain"),
    "torus": ("who", "h", "t", "kinetic"),
    "times": ("scene", "vti_s", "lammps_s", "ratio", "least", "most"),
    "built": ("program", "scene", "vti_s", "lammps_s", "ratio", "least", "most", "kinetic", "gain"),
}
WORDS = {"program", "who", "what", "style", "cycle", "axis", "scene", "spins"}
NAMES = {
    "vti2": "vti2",
    "mindlin": "LAMMPS `mindlin`",
    "mindlin_rescale/force": "LAMMPS `mindlin_rescale/force`",
    "synchronized": "the same, `synchronized_verlet`",
    "LIGGGHTS": "LIGGGHTS `hertz tangential history`",
    "YADE": "YADE `Mindlin`",
    "F.v h": "LAMMPS, F.v h",
    "mean of two": "LAMMPS, mean of two steps' F.v times h",
}


OTHERS = ("LIGGGHTS", "YADE")  # codes that take part where they are installed


def read(folder, name, needed=True):
    """Rows of a file as dictionaries, words as they are."""
    path = os.path.join(folder, name + ".csv")
    if not needed and not os.path.isfile(path):
        return []
    with open(path, encoding="ascii", newline="") as file:
        rows = list(csv.DictReader(file))
    if not rows or tuple(rows[0]) != COLUMNS[name]:
        raise Trouble(path, "has other columns than bench/peers/peers.py writes", "make it anew with ./dev lammps")
    rows = [{key: text if key in WORDS else float(text) for key, text in row.items()} for row in rows]
    if any(np.isnan(row.get("error", 0.0)) for row in rows):
        raise Trouble(path, "has an error that is NaN", "make it anew with ./dev lammps")
    return rows


def of(rows, **wanted):
    return [row for row in rows if all(row[key] == value for key, value in wanted.items())]


def column(rows, key):
    return np.array([row[key] for row in rows])


def in_order(rows, key):
    return list(dict.fromkeys(row[key] for row in rows))


def slope(rows):
    """The order in h, by least squares."""
    errors = column(rows, "error")
    good = errors > 0
    return -np.polyfit(np.log(column(rows, "steps")[good]), np.log(errors[good]), 1)[0]


DASHES = ("-", "--", ":")   # of curves without markers, which are told apart without their colours, too


def curves(axes, rows, x, y, first, draw="plot", floor=0.0, marked=False, others=1):
    """y over x of each who, that of first above the others in the legend; others: the first look of these."""
    looks = (style.LOOKS[0], *style.LOOKS[others:])
    for turn, (who, look) in enumerate(zip(sorted(in_order(rows, "who"), key=lambda name: name != first), looks)):
        mine = of(rows, who=who)
        getattr(axes, draw)(
            column(mine, x),
            np.maximum(column(mine, y), floor),
            look.marker + look.line if marked else DASHES[turn % len(DASHES)],
            color=look.colour,
            markersize=5,
            label=NAMES.get(who, who).replace("`", ""),
        )
    axes.legend()
