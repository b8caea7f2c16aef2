# SPDX-License-Identifier: BSD-3-Clause
"""Reading study.h5, and refusing it in one sentence where it is not what vti-study writes.

    attributes of the file   scene, t_end, energy0, norm_squared, vti_version
    /runs/<column>           one row per run
    /orders/<column>         one row per stepper and measure: log2(error) = log2_constant + order log2(h)
    /series/<row of the run, six digits>
                             attributes stepper and h; datasets t, energy_error and one per invariant of the scene,
                             each of these with an attribute `label` for the axis
"""
import os
from contextlib import contextmanager
from dataclasses import dataclass, field

import h5py
import numpy as np

from .trouble import Trouble

RUN_TEXTS = ("scene", "stepper")
RUN_NUMBERS = ("h", "t_end", "steps", "force_evals", "e_error", "q_error", "h1_error", "attitude_error",
               "momentum_error")
ORDER_TEXTS = ("stepper", "measure")
ORDER_NUMBERS = ("order", "interval", "points", "h_min", "h_max", "log2_constant")

WRITE_ANEW = "write it anew with the vti-study of this version"


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

    def read_series(self, name):
        """Read on demand: a study holds many long runs and a picture shows one per stepper."""
        with _opened(self.path) as file:
            group = file["series"][name]
            where = f"/series/{name}"
            invariants = {}
            for key in sorted(set(group) - {"t", "energy_error"}):
                label = group[key].attrs.get("label")
                invariants[key] = (key if label is None else _text(label), _numbers(self.path, group, key, where))
            series = Series(_numbers(self.path, group, "t", where), _numbers(self.path, group, "energy_error", where),
                            invariants)
        for key, column in {"energy_error": series.energy_error,
                            **{key: values for key, (_, values) in invariants.items()}}.items():
            if len(column) != len(series.t):
                raise Trouble(self.path, f"{where}/{key} has {len(column)} values, but t has {len(series.t)}",
                              WRITE_ANEW)
        return series


def read_study(path):
    """The whole file but for the series, checked."""
    with _opened(path) as file:
        runs = _table(path, file, "runs", RUN_TEXTS, RUN_NUMBERS)
        if len(runs["h"]) == 0:
            raise Trouble(path, "holds no runs", "give the study at least one stepper and one h")
        if not np.all(np.isfinite(runs["h"]) & (runs["h"] > 0)):
            raise Trouble(path, "dataset /runs/h holds a time step that is not positive", WRITE_ANEW)
        scenes = sorted(set(runs["scene"]))
        if len(scenes) > 1:
            raise Trouble(path, f"mixes the scenes {', '.join(scenes)}, which share no error scale",
                          "study each scene into a file of its own")
        orders = _table(path, file, "orders", ORDER_TEXTS, ORDER_NUMBERS)
        series = [(name, _text(_attribute(path, group, "stepper")), _number(path, group, "h"))
                  for name, group in sorted(_group(path, file, "series").items())]
        return Study(path, _text(_attribute(path, file, "scene")), _number(path, file, "t_end"),
                     _number(path, file, "energy0"), _number(path, file, "norm_squared"),
                     _text(_attribute(path, file, "vti_version")), runs, orders, series)


@contextmanager
def _opened(path):
    """The file, with every way in which HDF5 can fail put into words. A damaged file fails in reading, too, and h5py
    then raises almost any exception: what is not ours to explain is therefore taken for damage."""
    if os.path.isdir(path):
        raise Trouble(path, "is a folder", "give the study.h5 inside it")
    try:
        with open(path, "rb"):
            pass
    except FileNotFoundError:
        raise Trouble(path, "no such file", "run vti-study first, or correct the path") from None
    except OSError as error:
        raise Trouble(path, f"cannot be read ({error.strerror})", "make it readable, or correct the path") from None
    if not h5py.is_hdf5(path):
        raise Trouble(path, "is not an HDF5 file", "give the study.h5 that vti-study wrote")
    try:
        with h5py.File(path, "r") as file:
            yield file
    except Trouble:
        raise
    except Exception as error:  # see above
        if any(sign in str(error) for sign in ("unable to lock", "already open")):
            raise Trouble(path, "is still being written", "wait until vti-study has finished") from None
        problem = "is truncated" if "truncated" in str(error) else "is damaged"
        raise Trouble(path, problem, "run vti-study again, or restore the file from a copy") from None


def _group(path, file, name):
    if not isinstance(file.get(name), h5py.Group):
        raise Trouble(path, f"lacks group /{name}", WRITE_ANEW)
    return file[name]


def _table(path, file, name, texts, numbers):
    group = _group(path, file, name)
    table = {column: np.array([_text(value) for value in _dataset(path, group, column, f"/{name}")], dtype=object)
             for column in texts}
    table.update((column, _numbers(path, group, column, f"/{name}")) for column in numbers)
    lengths = {column: len(values) for column, values in table.items()}
    if len(set(lengths.values())) > 1:
        short, long = min(lengths, key=lengths.get), max(lengths, key=lengths.get)
        raise Trouble(path, f"/{name}/{short} has {lengths[short]} rows, but {long} has {lengths[long]}", WRITE_ANEW)
    return table


def _dataset(path, group, name, where):
    dataset = group.get(name)
    if not isinstance(dataset, h5py.Dataset):
        raise Trouble(path, f"lacks dataset {where}/{name}", WRITE_ANEW)
    if dataset.ndim != 1:
        raise Trouble(path, f"dataset {where}/{name} is not one-dimensional", WRITE_ANEW)
    return dataset[()]


def _numbers(path, group, name, where):
    values = _dataset(path, group, name, where)
    if values.dtype.kind not in "fiu":
        raise Trouble(path, f"dataset {where}/{name} does not hold numbers", WRITE_ANEW)
    return values.astype(float)


def _attribute(path, holder, name):
    if name not in getattr(holder, "attrs", ()):
        raise Trouble(path, f"lacks attribute {name} of {holder.name}", WRITE_ANEW)
    return np.ravel(holder.attrs[name])[0]  # a C program may as well write a vector of one


def _number(path, holder, name):
    value = _attribute(path, holder, name)
    if np.asarray(value).dtype.kind not in "fiu":
        raise Trouble(path, f"attribute {name} of {holder.name} is not a number", WRITE_ANEW)
    return float(value)


def _text(value):
    """Fixed or variable length, ASCII or UTF-8: h5py hands out bytes for some of these and str for others."""
    value = np.ravel(value)[0] if isinstance(value, np.ndarray) else value
    text = value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)
    return text.rstrip("\0 ")
