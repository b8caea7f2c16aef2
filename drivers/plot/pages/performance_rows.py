# SPDX-License-Identifier: BSD-3-Clause
"""The files that `./dev bench` wrote, as rows, and numbers as text."""
import csv
import os
from dataclasses import dataclass

from ..trouble import Trouble

UNITS = {"widest": "AVX-512", "avx2": "AVX2", "baseline": "SSE2", "scalar": "scalar"}    # where the widest are those
COLUMNS = ["what", "layout", "n", "items", "bytes", "median_ns", "least_ns"]


@dataclass(frozen=True)
class Bench:
    """What one build of vti-bench printed."""
    name: str
    units: str
    version: str
    rows: dict      # (what, layout, n) -> (ns per item, bytes per item)

    def ns(self, what, layout, n):
        return self.rows.get((what, layout, n), (float("nan"), 0))[0]

    def sizes(self):
        return sorted({n for _, _, n in self.rows})


def read_bench(folder, name):
    path = os.path.join(folder, name + ".csv")
    with open(path, encoding="utf-8", newline="") as file:
        rows = csv.DictReader(file)
        if rows.fieldnames != COLUMNS:
            raise Trouble(path, "has other columns than vti-bench prints", "make it anew with ./dev bench")
        found = {(row["what"], row["layout"], int(row["n"])): (float(row["median_ns"]), float(row["bytes"])) for row in rows}
    if not found:
        raise Trouble(path, "has no row", "make it anew with ./dev bench")
    with open(os.path.join(folder, name + ".txt"), encoding="utf-8") as file:
        version = file.read()
    widest = version.split("vector units: ")[-1].split(";")[0]
    known = any(what == "peak" for what, _, _ in found)     # as on x86 only
    units = UNITS[name] if name != "widest" else {"AVX-512 and AVX2": "AVX-512", "AVX2": "AVX2"}.get(
        widest, UNITS["baseline"] if known else "the build's")
    return Bench(name, units, version, found)


def read_all(folder):
    """The widest first; a narrower build that serves the same units is left out."""
    found = [read_bench(folder, name) for name in UNITS if os.path.isfile(os.path.join(folder, name + ".csv"))]
    if not found:
        raise Trouble(folder, "holds no widest.csv", "make it with ./dev bench")
    return [one for k, one in enumerate(found) if one.units not in [other.units for other in found[:k]]]



def read_rows(folder, program, columns):
    """What a program of bench/ has printed."""
    path = os.path.join(folder, program + ".csv")
    anew = "make it anew with ./dev bench"
    if not os.path.isfile(path):
        raise Trouble(path, "is missing", anew)
    with open(path, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    if not rows or list(rows[0]) != columns:
        raise Trouble(path, f"has other columns than bench/{program}.py prints", anew)
    return rows


# ---- as text --------------------------------------------------------------------------------------------------------

def short(value):
    return "-" if value != value else f"{value:.3g}" if value < 100 else f"{value:.0f}"


def size_text(n):
    return f"{n:.0e}".replace("e+0", "e") if n >= 1e4 else str(n)
