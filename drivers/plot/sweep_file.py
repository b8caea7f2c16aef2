# SPDX-License-Identifier: BSD-3-Clause
"""Reading the study.h5 of a sweep: means and spreads, group by group. docs/files.md has all that is in it."""
from dataclasses import dataclass

import numpy as np

from .hdf5_file import SWEEP, Reader, opened, text

MEASURES = ("e_error", "q_error", "h1_error", "attitude_error", "momentum_error")


@dataclass
class Group:
    """Over the values of the first key, at one value of each of the others and in one scene."""
    scene: str
    others: dict            # key -> value, number or text
    steppers: np.ndarray    # names, a row for each stepper and h
    columns: dict           # h, runs, failed, infinite, mean_e_error, spread_e_error, ...: values, in the same rows
    orders: dict            # (stepper, measure) -> (mean, spread)


@dataclass
class Sweep:
    path: str
    version: str
    key: str                # of the ensemble, "" if only scenes were named
    values: list            # of it
    groups: list


def _values(reader, key):
    """Numbers, or texts where not all are numbers."""
    name = f"/sweep/{key}/value"
    return reader.numbers(name) if reader.dataset(name).dtype.kind in "fiu" else reader.texts(name)


def _columns(reader, where, names):
    table = {name: reader.numbers(f"{where}/{name}") for name in names}
    reader.same_lengths(table, where)
    return table


def read_sweep(path):
    """All groups, checked."""
    with opened(path) as file:
        reader = Reader(path, file, SWEEP)
        key = text(reader.attribute("ensemble"))
        keys = list(reader.group("/sweep"))
        values = {each: _values(reader, each) for each in keys}
        scenes, steppers, measures = (reader.texts(f"/{name}/name") for name in ("scenes", "steppers", "measures"))
        points = _columns(reader, "/points", ("scene", *keys))
        means = _columns(reader, "/ensemble", ("point", "stepper", "h", "runs", "failed", "infinite",
                                               *(f"{what}_{measure}" for measure in MEASURES for what in ("mean", "spread"))))
        orders = _columns(reader, "/ensemble_orders", ("point", "stepper", "measure", "mean_order", "spread_order"))
        groups = []
        for first in dict.fromkeys(means["point"].astype(int)):
            rows, fits = means["point"] == first, orders["point"] == first
            groups.append(Group(
                scenes[int(points["scene"][first])],
                {each: values[each][int(points[each][first])] for each in keys if each != key},
                steppers[means["stepper"][rows].astype(int)], {name: column[rows] for name, column in means.items()},
                {(steppers[int(s)], measures[int(m)]): (order, spread) for s, m, order, spread in
                 zip(*(orders[name][fits] for name in ("stepper", "measure", "mean_order", "spread_order")))}))
        return Sweep(path, text(reader.attribute("vti_version")), key, list(values.get(key, ())), groups)
