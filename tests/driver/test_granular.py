# SPDX-License-Identifier: BSD-3-Clause
"""What the page of ./dev granular measures, on heaps whose slope, front and law are known; and the tables of beads that
it pours.      test_granular.py PROJECT"""
import csv
import math
import os
import subprocess
import sys
import tempfile

try:
    import numpy as np
    import matplotlib  # noqa: F401
    import h5py
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

from tally import check, conclude

project = os.path.abspath(sys.argv[1])
sys.path.insert(0, os.path.join(project, "drivers"))
from plot.pages import granular  # noqa: E402

RADIUS = 0.0015


def beads(degrees, columns):
    """Rows of beads that touch, below a line of that slope."""
    places = [((2 * k + 1) * RADIUS, 0.0, (2 * row + 1) * RADIUS) for k in range(columns)
              for row in range(max(1, int((columns - k) * math.tan(math.radians(degrees)))))]
    return np.array(places)


for angle in (12, 20, 31):
    x = beads(angle, 80)
    radius = np.full(len(x), RADIUS)
    found = granular.slope(x, radius)
    check(abs(found - angle) < 1.0, f"a heap of {angle} degrees has {found:.1f}")
    found = granular.wedge(x, radius)
    check(abs(found - angle) < 1.0, f"... and its centre of mass is that of a wedge of {found:.1f}")
    away = np.vstack([x, [[1.0, 0.0, RADIUS]]])
    front = granular.front(away, np.full(len(away), RADIUS))
    check(abs(front - 160 * RADIUS) < 1e-12, f"... its front is at {front:.4g}, without the bead that is far away")

times = np.linspace(0, 7, 71)
found = [(start, end, round(times[inside][0], 9), times[inside][-1]) for start, end, inside in granular.spans(times)]
check(found == [(0, 3, 0.1, 3.0), (3, 6, 3.1, 6.0), (6, 9, 6.1, 7.0)], f"7 seconds of the drum are three rows: {found}")
figure = granular.picture([granular.Column(1, a, a, a) for a in (0.5, 1.0, 3.0, 4.0)], {(0.5, "0.0003"): [(30.0, 20.0), (32.0, 21.0)]}, times,
                          20 + np.sin(times))
means = [path.vertices[0][1] for lines in figure.axes[2].collections for path in lines.get_paths()]
check(len(means) == 3 and np.allclose(means, [np.mean(20 + np.sin(times[inside])) for _, _, inside in granular.spans(times)]),
      f"the picture has their means: {means}")

some = [granular.Column(1, a, 2.5 * a**0.7, 3.0 * a) for a in (0.5, 1.0, 3.0)]
exponent, factor, error = granular.power(some)
check(abs(exponent - 0.7) < 1e-12 and abs(factor - 2.5) < 1e-12 and error < 1e-12,
      f"2.5 a^0.7 is {factor:.3g} a^{exponent:.3g}, give or take {error:.1g}")
off = [granular.Column(1, math.exp(k), math.exp(k + shift), 1.0) for k, shift in ((0, 0.1), (1, -0.2), (2, 0.1))]
# residuals 0.1, -0.2, 0.1 have no slope: sqrt(0.06/1/2)
check(abs(granular.power(off)[2] - math.sqrt(0.03)) < 1e-12, "an exponent has the standard error of its slope")
check(granular.spread([1.0, 3.0]) == "2.0 (1.4)", "two values have their mean and their standard deviation")

# head on the struck bead takes (1 + e)/2; across, friction is mu times that
normal = np.array([0.6, 0.0, 0.8])
velocity = granular.struck(normal, 1.0)
tangent = np.array([0.8, 0.0, -0.6])
along, across = velocity @ normal, velocity @ tangent
check(abs(along + 0.5 * (1 + granular.RESTITUTION) * 0.8) < 1e-15,
      f"a bead struck at 37 degrees has {along:.4g} along the normal")
check(abs(across - granular.MU * -along) < 1e-15, f"... and {across:.4g} across, towards where it is pushed")



def write_run(path, frames, velocities=None):
    """What vti-run writes, as far as the page reads it. frames: time -> places of beads of RADIUS."""
    os.makedirs(os.path.dirname(path))
    points = np.concatenate(list(frames.values()))
    with h5py.File(path, "w") as file:
        file.attrs.update({"scene": "beads", "stepper": "vti2", "h": 1e-5, "vti_version": "0.1.0"})
        for name in ("t", "kinetic_translation", "total"):
            file[f"energies/{name}"] = np.array([0.0, 1.0]) if name == "t" else np.ones(2)
        file["VTKHDF/Steps/Values"], file["VTKHDF/Points"] = np.array(list(frames), float), points
        file["VTKHDF/PointData/velocity"] = np.zeros_like(points) if velocities is None else np.concatenate(velocities)
        file["VTKHDF/PointData/diameter"] = np.full(len(points) // len(frames), 2 * RADIUS)
        file["VTKHDF/Lines/Connectivity"] = np.zeros(0, int)


def turned(degrees):
    """A bead that meets the plane, one that strikes and one that is struck, each at that angle; all at 1 m/s."""
    return [math.sin(math.radians(degrees)), 0.0, -math.cos(math.radians(degrees))]


# The whole page: a column of 4 x 8 beads that ends as a row of 32; a heap of 20 degrees; beads 37 degrees beside the
# axis of the drum; and beads that meet the plane at 60 and at 30 degrees, of which the first slides all the way, tan 30
# being less
# than 7/2 mu (1 + e).
with tempfile.TemporaryDirectory() as folder:
    square = np.array([((2 * k + 1) * RADIUS, 0.0, (2 * row + 1) * RADIUS) for k in range(4) for row in range(8)])
    line = np.array([((2 * k + 1) * RADIUS, 0.0, RADIUS) for k in range(32)])
    write_run(os.path.join(folder, "column-32-1", "out.h5"), {0: square, 1: line})
    heap = beads(20, 80)
    write_run(os.path.join(folder, "repose-0.5-0.0003-1", "out.h5"), {0: heap, 1: heap})
    write_run(os.path.join(folder, "drum", "out.h5"), {0: square, 2: square - np.mean(square, axis=0) + [-0.03, 0, -0.04]})
    before = [turned(60), turned(30)] * 3
    after = [[0.75, 0.0, 0.5], [0.25, 0.0, 0.875], *before[2:4], granular.struck(np.array(turned(60)) * [1, 1, -1], 1.0) + [0, 0.002, 0], [0, 0, 0]]
    write_run(os.path.join(folder, "billiards", "out.h5"), {0: line[:6], 1: line[:6]}, [before, after])
    granular.build(folder, folder, None)
    with open(os.path.join(folder, "granular.md"), encoding="utf-8") as file:
        page = file.read()
# 0.95 of 32 beads: the place of bead 29.45 is 59.9 radii, and was 7
for row in ("| 32 | 1 | 2.00 (0.00) | 7.56 (0.00) | 7.00 (0.00) |",
            f"| 0.5 | {granular.slope(heap, np.full(len(heap), RADIUS)):.1f} (0.0) | {granular.wedge(heap, np.full(len(heap), RADIUS)):.1f} (0.0) |",
            "| 0 to 3 | 36.9 | 0.0 |", f"| 60 | 0.500000 | 0.485000 | 0.750000 | {math.sin(math.pi / 3) - 0.092 * 1.97 * 0.5:.6f} | 2.0e-03 |",
            f"| 30 | 0.875000 | {0.97 * math.cos(math.pi / 6):.6f} | 0.250000 | sticks | - |"):
    check(row in page, f"the page has {row}")

with tempfile.TemporaryDirectory() as folder:
    table = os.path.join(folder, "beads.csv")
    subprocess.run([sys.executable, os.path.join(project, "bench", "granular", "packing.py"), "loose", "10", "60", "1",
                    table], check=True)
    with open(table, encoding="utf-8", newline="") as file:
        rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
gaps = [math.hypot(a["x"] - b["x"], a["z"] - b["z"]) - (a["diameter"] + b["diameter"]) / 2 for k, a in enumerate(rows)
        for b in rows[:k]]
check(len(rows) == 60 and min(gaps) > 0, f"60 loose beads do not touch: {min(gaps):.2g}")
check(all(abs(row["mass"] / (2500 * math.pi / 6 * row["diameter"]**3) - 1) < 1e-6 for row in rows),
      "... and have the mass of glass")
check(all(0 < row["x"] - row["diameter"] / 2 and row["x"] + row["diameter"] / 2 < 0.0303 and row["y"] == 0
          for row in rows), "... in their box")
conclude()
