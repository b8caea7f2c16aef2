# SPDX-License-Identifier: BSD-3-Clause
"""Long records as curves: what can be drawn of them, and so little of it that a picture stays light."""
import numpy as np

from . import words

EPS = 2.0**-52
SLICES = 500            # of time; more than that a panel cannot show


def finite(t, values):
    """What can be drawn; of a long run the smallest and the largest value of every slice, so that no peak is lost."""
    good = np.isfinite(t) & np.isfinite(values)
    t, values = t[good], values[good]
    if len(t) <= 4 * SLICES:
        return t, values
    keep = {0, len(t) - 1}
    for part in np.array_split(np.arange(len(t)), SLICES):
        keep |= {part[np.argmin(values[part])], part[np.argmax(values[part])]}
    keep = np.array(sorted(keep))
    return t[keep], values[keep]


def sliced(t, values, reduce, slices=SLICES):
    """Mean time and reduce(values) of every slice; all of it where there are no more values than slices."""
    if len(t) <= slices:
        return t, values
    parts = np.array_split(np.arange(len(t)), slices)
    return np.array([t[part].mean() for part in parts]), np.array([reduce(values[part]) for part in parts])


def first_lost(t, *columns):
    """When a run blew up, as text; None for one that did not."""
    if len(t) == 0:
        return "0"
    lost = ~np.isfinite(t)
    for values in columns:
        lost |= ~np.isfinite(values)
    return words.number(t[np.argmax(lost)], 3) if np.any(lost) else None


def largest(values):
    return float(np.max(np.abs(values))) if len(values) else 0.0


def time_axis(axes, t=None):
    """t: all times, where what is drawn does not reach the ends (means of slices)."""
    axes.set_xlabel("time $t$")
    # or labels of short times overlap
    axes.ticklabel_format(axis="x", style="sci", scilimits=(-2, 4), useMathText=True)
    axes.margins(x=0)
    if t is not None and t[0] < t[-1]:
        axes.set_xlim(t[0], t[-1])
