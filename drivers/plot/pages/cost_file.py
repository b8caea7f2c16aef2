# SPDX-License-Identifier: BSD-3-Clause
"""Reading what `vti-study --cost` leaves in a folder, and refusing it in one sentence where it is not that.

    cost.csv            one row per run: scene, stepper, kind, h, steps, force_evals, seconds, errors
    prices.csv          what an error costs: scene, t_end, scene_t_end, stepper, kind, measure, error, force_evals, seconds; empty
                        where not reached
    machine.txt         on what it was timed, `key: value` lines
    instructions.csv    scene, stepper, instructions_per_step; not always there
"""
import csv
import math
import os
from dataclasses import dataclass

import numpy as np

from .. import methods
from ..trouble import Trouble
from .page import machine_of

TEXTS = ("scene", "stepper", "kind")
COST = ("h", "steps", "force_evals", "seconds", "seconds_spread", "attitude_error", "position_error", "velocity_error",
        "energy_error", "momentum_error")
PRICES = ("error", "force_evals", "seconds", "t_end", "scene_t_end")
MEASURES = ("attitude", "position", "velocity", "energy")
INSTRUCTIONS = ("instructions_per_step",)
AGAIN = "write it anew with vti-study --cost"


@dataclass
class Ladder:
    """The rows of one method on one scene: column -> values. Runs by rising cost, prices by falling error."""
    kind: str
    columns: dict

    def __getitem__(self, column):
        return self.columns[column]


@dataclass
class Cost:
    runs: dict              # scene -> method -> Ladder, in the order of the file
    by_measure: dict        # scene -> measure -> method -> Ladder of prices
    machine: str            # one line, or empty
    instructions: dict      # (scene, method) -> instructions per step

    def scenes(self):
        return list(self.runs)

    @property
    def prices(self):
        """scene -> method -> Ladder, by the measure that the scene is priced by first."""
        return {scene: found[self.measure(scene).removesuffix("_error")] for scene, found in self.by_measure.items()}

    def ends(self, scene):
        """Where the runs end, and where the scene does."""
        ladder = next(iter(next(iter(self.by_measure[scene].values())).values()))
        return float(ladder["t_end"][0]), float(ladder["scene_t_end"][0])

    def kinds(self):
        return {method: ladder.kind for found in self.runs.values() for method, ladder in found.items()}

    def measure(self, scene):
        """The column that a scene's prices are of: where no effect changes how bodies turn no attitude is wrong."""
        return "attitude_error" if "attitude" in self.by_measure[scene] else "velocity_error"


def read_cost(folder):
    if not os.path.isdir(folder):
        raise Trouble(folder, "is not a folder", "give the one that vti-study --cost wrote")
    path = os.path.join(folder, "cost.csv")
    runs = _ladders(path, COST, "force_evals")
    prices_path = os.path.join(folder, "prices.csv")
    prices = _prices(prices_path)
    if list(prices) != list(runs):
        raise Trouble(prices_path, f"has the scenes {', '.join(prices)}, but cost.csv has {', '.join(runs)}", AGAIN)
    return Cost(runs, prices, machine_of(folder),
                _instructions(os.path.join(folder, "instructions.csv")))


def _ladders(path, columns, order, measure=None):
    """measure: rows of that one alone, in a file that has several."""
    found = {}
    for line, row in _rows(path, TEXTS + columns + (("measure",) if measure else ())):
        if row["kind"] not in methods.FAMILIES:
            raise Trouble(f"{path}:{line}", f"kind is '{row['kind']}'", f"it must be {', '.join(methods.FAMILIES)}")
        if measure and row["measure"] not in MEASURES:
            raise Trouble(f"{path}:{line}", f"measure is '{row['measure']}'", f"it must be {', '.join(MEASURES)}")
        values = [_number(path, line, column, row[column]) for column in columns]
        if not measure or row["measure"] == measure:
            found.setdefault(row["scene"], {}).setdefault(row["stepper"], (row["kind"], []))[1].append(values)
    return {scene: {stepper: _ladder(kind, rows, columns, order) for stepper, (kind, rows) in steppers.items()}
            for scene, steppers in found.items()}


def _prices(path):
    """scene -> measure -> method -> Ladder, by falling error."""
    found = {}
    for measure in MEASURES:
        for scene, ladders in _ladders(path, PRICES, "error", measure).items():
            found.setdefault(scene, {})[measure] = ladders
            for ladder in ladders.values():
                ladder.columns = {column: values[::-1] for column, values in ladder.columns.items()}
    order = [row["scene"] for _, row in _rows(path, TEXTS)]
    return {scene: found[scene] for scene in dict.fromkeys(order)}


def _ladder(kind, rows, columns, order):
    table = np.array(rows)
    table = table[np.argsort(table[:, columns.index(order)], kind="stable")]
    return Ladder(kind, dict(zip(columns, table.T)))


def _rows(path, columns):
    """Line number and row, checked: every column named is there."""
    try:
        with open(path, encoding="utf-8", newline="") as file:
            table = list(csv.reader(file))
    except FileNotFoundError:
        raise Trouble(path, "no such file", "run vti-study --cost first, or correct the path") from None
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise Trouble(path, f"cannot be read ({error})", AGAIN) from None
    if len(table) < 2:
        raise Trouble(path, "holds no rows", AGAIN)
    head = table[0]
    for column in columns:
        if column not in head:
            raise Trouble(path, f"lacks the column {column}", AGAIN)
    for line, cells in enumerate(table[1:], start=2):
        if len(cells) != len(head):
            raise Trouble(f"{path}:{line}", f"has {len(cells)} cells instead of {len(head)}", AGAIN)
        yield line, dict(zip(head, cells))


def _number(path, line, column, cell):
    """Empty is what was not reached."""
    try:
        value = float(cell) if cell else math.nan
    except ValueError:
        raise Trouble(f"{path}:{line}", f"{column} is '{cell}', not a number", AGAIN) from None
    if value < 0:
        raise Trouble(f"{path}:{line}", f"{column} is negative", AGAIN)
    return value


def _instructions(path):
    if not os.path.isfile(path):
        return {}
    return {(row["scene"], row["stepper"]): _number(path, line, INSTRUCTIONS[0], row[INSTRUCTIONS[0]])
            for line, row in _rows(path, TEXTS[:2] + INSTRUCTIONS)}
