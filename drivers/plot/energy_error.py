# SPDX-License-Identifier: BSD-3-Clause
"""energy_error.png: the relative error of the total energy over time. A long run shows as the band between the smallest
and the largest value of every slice of time, with the mean in it; how far a line fitted to it moves tells a slow change
from an oscillation."""
import math

import numpy as np

from . import curves, style, words


def draw(run):
    t, total = run.columns["t"], run.columns["total"]
    if run.lost is None and len(t) < 2:
        return None, ["not drawn, fewer than two times are recorded"]
    scale, symbol = (abs(total[0]), r"(E_h-E_0)\,/\,|E_0|") if total[0] != 0 else (1.0, "E_h-E_0")
    figure = style.new_figure(4.4)
    figure.suptitle(f"{words.plain(run.scene)}: error of the total energy over time, {words.steps_of(run)}")
    axes = figure.subplots()
    if run.lost is None:
        _draw_sound(axes, t, (total - total[0]) / scale, symbol)
        curves.time_axis(axes, t)
    else:
        _draw_blown_up(axes, run.total_to_the_end[0], (run.total_to_the_end[1] - total[0]) / scale, symbol)
        axes.set_title(f"blown up at $t$ = {words.given(run.lost)}")
        curves.time_axis(axes)
        axes.margins(x=0.01)        # or half of the last mark is cut off
    figure.supxlabel("\n".join([_facts(run, t, total[0]), *run.notes()]), fontsize=8.5, color=style.GREY)
    return figure, run.notes()


def _draw_sound(axes, t, error, symbol):
    largest = curves.largest(error)
    power = math.floor(math.log10(largest)) if largest > 0 else 0
    _draw_band(axes, t, error, power)
    axes.axhline(0, color=style.GREY, linewidth=0.6, zorder=1)
    axes.set_title(f"at most {words.number(largest)}; {_drift_text(t, error)}" if largest > 0 else "kept exactly")
    axes.set_ylabel(f"${symbol}$" + (rf"  in $10^{{{power}}}$" if power else ""))


def _draw_blown_up(axes, t, error, symbol):
    """All there is of it, with every value marked, for there are few."""
    drawn = (np.abs(error) > 0) & (np.abs(error) < 1e200)      # beyond, ticks overflow
    axes.plot(t[drawn], np.abs(error[drawn]), "o-", markersize=4, color="#D55E00", linewidth=1.0)
    if np.any(drawn):
        low, high = np.log10(np.min(np.abs(error[drawn]))), np.log10(np.max(np.abs(error[drawn])))
        margin = 0.5 + 0.03 * (high - low)
        style.log_axis(axes.yaxis, 10.0 ** max(low - margin, -300), 10.0 ** min(high + margin, 307))
    axes.axvline(0, alpha=0)
    axes.set_ylabel(f"$|{symbol.replace('|', '')}|$")


def _draw_band(axes, t, error, power):
    unit = 10.0**power
    times, low = curves.sliced(t, error, np.min)
    high, mean = (curves.sliced(t, error, what)[1] for what in (np.max, np.mean))
    if len(t) > curves.SLICES:
        axes.fill_between(times, low / unit, high / unit, color="#56B4E9", alpha=0.55, linewidth=0)
    axes.plot(times, mean / unit, color="#0072B2", linewidth=1.1)


def drift(t, error):
    """Slope of the error over the whole time, times its length, and the interval of that. Neighbouring values are not
    independent: the interval is from the scatter of the means of 20 pieces of the time."""
    times, means = curves.sliced(t, error, np.mean, 20)
    if len(times) < 20:
        return math.nan, math.nan
    (slope, _), covariance = np.polyfit(times, means, 1, cov=True)
    span = t[-1] - t[0]
    return float(slope * span), float(2.1 * math.sqrt(covariance[0, 0]) * span)    # Student's t of 18 degrees, 95 %


def _drift_text(t, error):
    change, interval = drift(t, error)
    if not math.isfinite(change):
        return "too short to fit a line"
    if abs(change) <= interval:
        return f"no drift: a line fitted to it moves by less than {words.number(abs(change) + interval, 1)} from end to end"
    return f"a line fitted to it moves by {words.number(change)} ± {words.number(interval, 1)} from end to end"


def _facts(run, t, energy0):
    parts = []
    if len(t) > curves.SLICES:
        parts.append(f"Band: smallest to largest value in each 1/{curves.SLICES} of the time ({len(t):,} values in all); line: mean.")
    return "  ".join([*parts, f"$E_0$ = {words.given(energy0)}.  vti {words.plain(run.version)}"])
