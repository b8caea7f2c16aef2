# SPDX-License-Identifier: BSD-3-Clause
"""Steady spin: by how much each drift turns a free body too little, measured over many steps and in closed form."""
import glob
import math
import os
from dataclasses import dataclass
from decimal import Decimal, localcontext

import numpy as np

from ..hdf5_file import RUN, Reader, opened
from ..run_file import read_run
from ..trouble import Trouble

PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494459230781640628620899")


@dataclass
class Spin:
    stepper: str
    steps: int
    turn: float         # h |Omega|
    error: float        # of the attitude at the end, rad


def read_spins(folder):
    """Of every run of a spinning body in folder/spin: its attitude at the end against the one that is true."""
    return sorted((_spin(path) for path in glob.glob(os.path.join(folder, "spin", "*.h5"))), key=lambda spin: spin.error)


def _spin(path):
    run = read_run(path)
    if run.bodies != 1 or not run.turns or len(run.times) < 2:
        raise Trouble(path, "is not one body that turns, with its attitude at both ends", "make it from scenes/spin.yaml")
    with opened(path) as file:
        omega = Reader(path, file, RUN).numbers("/VTKHDF/PointData/omega", 2, slice(0, 1))[0]
    steps = round(run.times[-1] / run.h)
    first, last = run.frame(0).attitude[0], run.frame(len(run.times) - 1).attitude[0]
    size = float(np.linalg.norm(omega))
    half = half_angle(run.h, omega, steps)
    true = _times(np.append(omega / size * math.sin(half), math.cos(half)), first)
    apart = min(np.linalg.norm(last - true), np.linalg.norm(last + true))
    return Spin(run.stepper, steps, run.h * size, float(4 * math.asin(min(1.0, apart / 2))))


def half_angle(h, omega, steps):
    """steps h |omega| / 2 mod 2 pi. With as many digits as that takes: at 5e4 rad a double is off by 1e-11 already."""
    with localcontext() as context:
        context.prec = 70
        size = sum(Decimal(float(part)) ** 2 for part in omega).sqrt()
        return float((steps * Decimal(h) * size / 2) % (2 * PI))


def _times(a, b):
    """The quaternion of b first, then a; x, y, z, w."""
    return np.append(a[3] * b[:3] + b[3] * a[:3] + np.cross(a[:3], b[:3]), a[3] * b[3] - a[:3] @ b[:3])


# What one step turns by at s = h |Omega|
ANGLES = {
    "vti1": lambda s: math.asin(s) if s < 1 else math.nan,
    "vti2": lambda s: 2 * math.atan(s / 2),
    "exact": lambda s: 2 * math.atan2(s / 2 - s**3 / 120, 1 - s**2 / 10),
}


def error_per_turn(stepper, s):
    """Over one full turn, relative to it; NaN where the stepper refuses the step."""
    return abs(ANGLES[stepper](s) / s - 1)
