# SPDX-License-Identifier: BSD-3-Clause
"""invariants.png: the energy error over time, one panel per stepper and each on its own scale, and below it one panel
per invariant of the scene with all steppers together, for these differ by rounding only if the method keeps them."""
import math

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.ticker import FixedLocator, NullLocator

from . import curves, style, words
from .curves import EPS

FEW_EPS = 0.01          # below this nothing but rounding shows
MANY_EPS = 1e4          # beyond this a deviation is no longer rounding and is shown as a plain number


def draw(study):
    chosen = _choose_runs(study)
    if not chosen:
        return None, ["not drawn, the study has kept no run over time (/series is empty)"]
    looks = style.looks(study.steppers())
    series = {stepper: study.read_series(name) for stepper, (name, _) in chosen.items()}
    steps = {stepper: h for stepper, (_, h) in chosen.items()}
    missing = [stepper for stepper in study.steppers() if stepper not in chosen]
    notes = [f"no run over time was kept for {words.listing(map(words.stepper_name, missing))}"] if missing else []
    labels = {key: words.math_label(label, key)
              for one in series.values() for key, (label, _) in one.invariants.items()}

    count = len(series)
    energy_shape = _shape(count, 4 if count <= 4 else 5)
    invariant_shape = _shape(len(labels), 4 if len(labels) == 4 or len(labels) > 6 else 3)
    legend_shape = _shape(count, 5)
    heights = [0.3 + 2.35 * energy_shape[0], 0.1 + 0.24 * legend_shape[0]]
    if labels:
        heights.insert(1, 0.3 + 2.35 * invariant_shape[0])
    figure = style.new_figure(sum(heights) + 0.8)
    common = len(set(steps.values())) == 1
    figure.suptitle(f"{words.plain(study.scene)}: energy error {'and invariants ' if labels else ''}over time, "
                    rf"$t_{{\mathrm{{end}}}}$ = {words.given(study.t_end)}, "
                    + (f"$h$ = {words.step_text(next(iter(steps.values())))}" if common else "$h$ as in the legend"))
    energies, *invariants, legend = figure.subfigures(len(heights), 1, height_ratios=heights)

    for place, stepper in enumerate(series):
        axes = energies.add_subplot(*energy_shape, place + 1)
        _draw_energy(axes, study, stepper, series[stepper], looks[stepper])
    for place, (key, label) in enumerate(labels.items()):
        axes = invariants[0].add_subplot(*invariant_shape, place + 1)
        _draw_invariant(axes, label, {stepper: (one.t, one.invariants[key][1]) for stepper, one in series.items()
                                      if key in one.invariants}, looks)
        curves.time_axis(axes, (0.0, study.t_end))
    handles = [Line2D([], [], color=looks[stepper].colour, linewidth=2,
                      label=words.stepper_name(stepper) + ("" if common else f", $h$ = {words.step_text(h)}"))
               for stepper, h in steps.items()]
    legend.legend(handles=handles, loc="center", ncol=legend_shape[1], borderaxespad=0)
    figure.supxlabel("\n".join([_facts(study), *notes]), fontsize=8.5, color=style.GREY)
    return figure, notes


def _facts(study):
    return (r"Every energy panel has its own scale; $\varepsilon$ = $2^{-52}$ = $2.2\times 10^{-16}$, the machine "
            rf"precision; units are those of the scene.   vti {words.plain(study.version)}")


def _shape(count, columns):
    """Rows and columns of a grid, filled evenly: 6 in at most 5 columns are 2 x 3."""
    rows = math.ceil(count / columns)
    return max(1, rows), max(1, math.ceil(count / max(1, rows)))


def _choose_runs(study):
    """One run per stepper: the h most of them share, the middle one where several do, else the nearest to it."""
    kept = {}
    for name, stepper, h in study.series:
        kept.setdefault(stepper, {}).setdefault(h, name)
    if not kept:
        return {}
    all_h = sorted({h for runs in kept.values() for h in runs})
    shared = {h: sum(h in runs for runs in kept.values()) for h in all_h}
    candidates = [h for h in all_h if shared[h] == max(shared.values())]
    common = candidates[(len(candidates) - 1) // 2]
    chosen = {}
    for stepper in (stepper for stepper in study.steppers() if stepper in kept):
        h = min(kept[stepper], key=lambda h: (abs(math.log(h / common)), h))
        chosen[stepper] = (kept[stepper][h], h)
    return chosen


def _draw_energy(axes, study, stepper, series, look):
    scale = abs(study.energy0)
    symbol = r"$(E_h-E_0)\,/\,|E_0|$" if scale > 0 else r"$E_h-E_0$"
    t, error = curves.finite(series.t, series.energy_error / (scale or 1.0))
    largest = curves.largest(error)
    power = math.floor(math.log10(largest)) if largest > 0 else 0
    axes.plot(t, error / 10.0**power, color=look.colour, linewidth=1.0)
    axes.axhline(0, color=style.GREY, linewidth=0.6, zorder=1)
    lost = curves.first_lost(series.t, series.energy_error)
    axes.set_title(f"{words.stepper_name(stepper)}\n"
                   + (f"at most {words.number(largest)}" if lost is None else f"not finite from $t$ = {lost} on"))
    axes.set_ylabel(symbol + (rf"  in $10^{{{power}}}$" if power else ""))
    curves.time_axis(axes, (0.0, study.t_end))      # the last sample may lie before the end


def _draw_invariant(axes, label, lines, looks):
    lost = [stepper for stepper, line in lines.items() if curves.first_lost(*line) is not None]
    lines = {stepper: curves.finite(*line) for stepper, line in lines.items()}
    maxima = {stepper: curves.largest(values) for stepper, (_, values) in lines.items()}
    worst = max(maxima, key=maxima.get)
    largest, smallest = maxima[worst], min(maxima.values())
    unit = EPS if smallest <= MANY_EPS * EPS else 10.0 ** math.floor(math.log10(largest))
    for stepper, (t, values) in lines.items():
        axes.plot(t, values / unit, color=looks[stepper].colour, linewidth=0.8)
    if lost:
        axes.set_title(f"{label}: not finite\n({words.listing(map(words.stepper_name, lost))})")
    elif largest == 0:
        axes.set_title(f"{label}: kept exactly")
        axes.set_ylim(-1, 1)
    elif largest < FEW_EPS * EPS:
        axes.set_title(f"{label}: kept to rounding")
        axes.set_ylim(-1, 1)
    elif largest <= MANY_EPS * EPS:
        axes.set_title(rf"{label}: kept within {words.number(largest / EPS)} $\varepsilon$")
    else:
        axes.set_title(f"{label}\noff by up to {words.number(largest)} ({words.stepper_name(worst)})")
        if largest > 100 * smallest:    # one method keeps it and another does not: show both
            _linear_then_log(axes, 10 * max(1.0, smallest / unit), largest / unit)
    axes.set_ylabel(r"deviation / $\varepsilon$" if unit == EPS
                    else rf"deviation in $10^{{{round(math.log10(unit))}}}$")


def _linear_then_log(axes, threshold, largest):
    """Linear up to the threshold and logarithmic beyond, with few enough labels to be read."""
    axes.set_yscale("symlog", linthresh=threshold)
    first, last = math.ceil(math.log10(threshold)), math.floor(math.log10(largest))
    decades = 10.0 ** np.arange(first, last + 1, max(1, math.ceil((last - first + 1) / 4)))
    axes.yaxis.set_major_locator(FixedLocator(np.concatenate([-decades[::-1], [0.0], decades])))
    axes.yaxis.set_minor_locator(NullLocator())
