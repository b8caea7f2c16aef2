# SPDX-License-Identifier: BSD-3-Clause
"""Reading study.h5, and refusing it in one sentence where it is not what vti-study writes.

    attributes of the file   scene, t_end, energy0, norm_squared, vti_version, and reference_uncertainty where it is known
    /runs/<column>           one row per run; failure, where it is there, is "" of those that did not fail
    /orders/<column>         one row per stepper and measure: log2(error) = log2_constant + order log2(h)
    /series/<row of the run, six digits>
                             none of runs that failed; attributes stepper and h; datasets t, energy_error and one per invariant of the scene,
                             each of these with an attribute `label` for the axis
"""
from dataclasses import dataclass, field

import numpy as np

from .hdf5_file import STUDY, Reader, opened, text
from .trouble import Trouble

RUN_TEXTS = ("scene", "stepper")
RUN_NUMBERS = ("h", "t_end", "steps", "force_evals", "e_error", "q_error", "h1_error", "attitude_error",
               "momentum_error")
ORDER_TEXTS = ("stepper", "measure")
ORDER_NUMBERS = ("order", "interval", "points", "h_min", "h_max", "log2_constant")


@dataclass
class Series:
    """One run over time. An invariant is (label, deviation); its name is the dataset's."""
    t: np.ndarray
    energy_error: np.ndarray
    invariants: dict = field(default_factory=dict)


@dataclass
class Study:
    path: str
    scene: str
    t_end: float
    energy0: float
    norm_squared: float
    version: str
    runs: dict              # column -> array, all of one length
    orders: dict            # column -> array, all of one length
    series: list            # (name of the group, stepper, h), in the order of the runs
    uncertainty: float      # of the reference, relative to the solution

    def steppers(self):
        """In the order of the runs, which is the order the user asked for."""
        return list(dict.fromkeys(self.runs["stepper"]))

    def fit(self, stepper, measure):
        """The row of /orders as a dict, or None where nothing was or could be fitted."""
        for row, key in enumerate(zip(self.orders["stepper"], self.orders["measure"])):
            if key == (stepper, measure):
                fit = {column: float(self.orders[column][row]) for column in ORDER_NUMBERS}
                return fit if np.isfinite(fit["order"]) else None
        return None

    def errors(self, stepper, measure):
        """h and error of the stepper's runs."""
        mine = self.runs["stepper"] == stepper
        return self.runs["h"][mine], self.runs[measure][mine]

    def read_series(self, name):
        """Read on demand: a study holds many long runs and a picture shows one per stepper."""
        with opened(self.path) as file:
            reader, where = Reader(self.path, file, STUDY), f"/series/{name}"
            group = reader.group(where)
            columns = {key: reader.numbers(f"{where}/{key}")
                       for key in ["t", "energy_error", *sorted(set(group) - {"t", "energy_error"})]}
            labels = {key: text(group[key].attrs.get("label", key)) for key in columns}
            for key, values in columns.items():
                if len(values) != len(columns["t"]):
                    raise reader.trouble(f"{where}/{key} has {len(values)} values, but t has {len(columns['t'])}")
        t, energy_error = columns.pop("t"), columns.pop("energy_error")
        return Series(t, energy_error, {key: (labels[key], values) for key, values in columns.items()})


def read_study(path):
    """The whole file but for the series, checked."""
    with opened(path) as file:
        reader = Reader(path, file, STUDY)
        runs = _table(reader, "/runs", RUN_TEXTS, RUN_NUMBERS)
        runs["failure"] = reader.texts("/runs/failure") if "failure" in file["runs"] else np.full(len(runs["h"]), "")
        reader.same_lengths(runs, "/runs")
        if len(runs["h"]) == 0:
            raise Trouble(path, "holds no runs", "give the study at least one stepper and one h")
        if not np.all(np.isfinite(runs["h"]) & (runs["h"] > 0)):
            raise reader.trouble("dataset /runs/h holds a time step that is not positive")
        scenes = sorted(set(runs["scene"]))
        if len(scenes) > 1:
            raise Trouble(path, f"mixes the scenes {', '.join(scenes)}, which share no error scale",
                          "study each scene into a file of its own")
        orders = _table(reader, "/orders", ORDER_TEXTS, ORDER_NUMBERS)
        series = [(name, text(reader.attribute("stepper", group)), reader.number("h", group))
                  for name, group in sorted(reader.group("/series").items())]
        known = "reference_uncertainty" in file.attrs
        uncertainty = reader.number("reference_uncertainty") if known else 0.0
        return Study(path, text(reader.attribute("scene")), reader.number("t_end"), reader.number("energy0"),
                     reader.number("norm_squared"), text(reader.attribute("vti_version")), runs, orders, series, uncertainty)


def _table(reader, name, texts, numbers):
    reader.group(name)
    table = {column: reader.texts(f"{name}/{column}") for column in texts}
    table.update((column, reader.numbers(f"{name}/{column}")) for column in numbers)
    reader.same_lengths(table, name)
    return table
