# SPDX-License-Identifier: BSD-3-Clause
"""Work-precision pictures of a cost study: error against force evaluations and against time, all methods of a scene; and
the energy error against time. The best of ours and the best rival stand out, the rest is there to be compared with."""
from dataclasses import dataclass, replace

import numpy as np
from matplotlib.lines import Line2D

from .. import methods, style, words
from . import price_list

HEIGHT = 5.6
MARKS = 7               # of a curve; a ladder by sqrt(2) has up to 64 runs
LARGEST = 1.0           # an error above it says no more than that the run is lost
SMALLEST = {"attitude_error": 1e-12, "velocity_error": 1e-12, "energy_error": 1e-16}
LABELS = {"attitude_error": "attitude error at the end (rad)", "velocity_error": "relative velocity error at the end",
          "energy_error": r"largest energy error, $|E_h-E_0|\,/\,|E_0|$"}
THICK = ("Thick: of ours and of the rivals the one that is the cheapest, in time, at most of the errors of the price list. "
         "Thin bars: from the least to the median time.")
STANDS_OUT = {"ours": "#0050B0", "rival": "#000000"}
COSTS = {"force_evals": "force evaluations", "seconds": "time (s)"}


@dataclass
class Curves:
    """What every panel of a scene shares."""
    ladders: dict       # method -> Ladder, those drawn last on top
    looks: dict
    best: dict          # method -> what its label says


def precision(cost, scene):
    measure = cost.measure(scene)
    return _draw(cost, scene, measure, ("force_evals", "seconds"), "what accuracy costs")


def energy(cost, scene):
    return _draw(cost, scene, "energy_error", ("seconds",), "what a small energy error costs")


def _draw(cost, scene, measure, costs, what):
    curves = _curves(cost, scene)
    figure = style.new_figure(HEIGHT)
    figure.suptitle(f"{words.plain(scene)}: {what}")
    grid = figure.add_gridspec(1, len(costs) + 1, width_ratios=[1.0] * len(costs) + [0.34 * len(costs)])
    first = None
    for column, against in enumerate(costs):
        axes = figure.add_subplot(grid[0, column], sharey=first)
        first = first or axes
        axes.set_xlabel(COSTS[against])
        if axes is first:
            axes.set_ylabel(LABELS[measure])
        else:
            axes.tick_params(labelleft=False)
        _panel(axes, curves, against, measure)
    _limits(figure.axes, curves, costs, measure)
    _legend(style.bare(figure.add_subplot(grid[0, -1])), curves)
    figure.supxlabel(THICK, fontsize=8.5, color=style.GREY)
    return figure


def _curves(cost, scene):
    best = {price_list.best(cost, scene, kind): text
            for kind, text in (("ours", "best of ours"), ("rival", "best rival"))}
    best.pop(None, None)
    ladders = cost.runs[scene]
    depth = {"rival": 0, "paper": 1, "ours": 2}
    order = sorted(ladders, key=lambda method: (method in best, depth[ladders[method].kind]))
    looks = methods.looks(cost.kinds())
    looks.update({method: replace(looks[method], colour=STANDS_OUT[ladders[method].kind]) for method in best})
    return Curves({method: ladders[method] for method in order}, looks, best)


def _points(ladder, against, measure):
    """What logarithmic axes can show."""
    x, y = ladder[against], ladder[measure]
    good = np.isfinite(x) & np.isfinite(y) & (x > 0) & (y > 0)
    return x[good], y[good]


def _panel(axes, curves, against, measure):
    for turn, (method, ladder) in enumerate(curves.ladders.items()):
        x, y = _points(ladder, against, measure)
        look, stands_out = curves.looks[method], method in curves.best
        every = max(1, -(-len(x) // MARKS))
        if against == "seconds":
            _spread(axes, ladder, measure, look.colour)
        # each begins its marks at another point, or those of equal curves would hide each other
        axes.plot(x, y, color=look.colour, marker=look.marker, markevery=(turn % every, every),
                  linewidth=2.4 if stands_out else 0.9, markersize=6.5 if stands_out else 4.2,
                  markeredgewidth=1.4 if stands_out else 0.9, markerfacecolor=look.colour if stands_out else "white",
                  alpha=1.0 if stands_out else 0.85, zorder=3 + turn / 100)


def _spread(axes, ladder, measure, colour):
    """From the least time that was measured to the median."""
    low, high = ladder["seconds"], ladder["seconds"] * (1 + ladder["seconds_spread"])
    good = np.isfinite(high) & (low > 0) & (ladder[measure] > 0)
    axes.hlines(ladder[measure][good], low[good], high[good], colors=colour, linewidth=0.5, alpha=0.5, zorder=2)


def _limits(panels, curves, costs, measure):
    """The errors from rounding to what is still an error, and the costs at which any curve is between."""
    every = np.concatenate([_points(ladder, costs[0], measure)[1] for ladder in curves.ladders.values()])
    seen = every[(every >= SMALLEST[measure]) & (every <= LARGEST)]
    if not len(seen):
        seen = np.array([SMALLEST[measure], LARGEST])
    low, high = np.min(seen) / 2, min(np.max(seen) * 2, 1.3 * LARGEST)
    for axes, against in zip(panels, costs):
        points = [_points(ladder, against, measure) for ladder in curves.ladders.values()]
        x = np.concatenate([x[(y >= low) & (y <= high)] for x, y in points])
        x = x if len(x) else np.array([1.0, 10.0])
        style.log_axis(axes.xaxis, np.min(x) / 1.3, np.max(x) * 1.3)
    style.log_axis(panels[0].yaxis, low, high)


def _legend(axes, curves):
    """One column, a heading per family, in the order of the names."""
    handles = []
    for kind, family in methods.FAMILIES.items():
        members = sorted((m for m in curves.ladders if curves.ladders[m].kind == kind), key=lambda m: methods.name(m).lower())
        if members:
            handles.append(Line2D([], [], linestyle="none", label=family))
        for method in members:
            look, stands_out = curves.looks[method], method in curves.best
            handles.append(Line2D([], [], color=look.colour, marker=look.marker, linewidth=2.4 if stands_out else 0.9,
                                  markersize=6.5 if stands_out else 4.5, label=_label(curves, method),
                                  markerfacecolor=look.colour if stands_out else "white"))
    legend = axes.legend(handles=handles, loc="center left", bbox_to_anchor=(-0.1, 0.5), borderaxespad=0,
                         handlelength=2.2, labelspacing=0.32, fontsize=8.5)
    for text in legend.get_texts():
        if text.get_text() in (*methods.FAMILIES.values(), *(_label(curves, method) for method in curves.best)):
            text.set_fontweight("bold")


def _label(curves, method):
    return f"{methods.name(method)}: {curves.best[method]}" if method in curves.best else methods.name(method)
