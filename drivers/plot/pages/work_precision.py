# SPDX-License-Identifier: BSD-3-Clause
"""Price lists drawn: what an error costs, in force evaluations and in time, over the error. The methods of order 2 are
one band; those that are the cheapest of their family somewhere have a name beside the panel, the others are thin and
grey. No family has grey."""
from dataclasses import dataclass

import numpy as np

from .. import methods, style, words
from . import price_list

HEIGHT = 5.6
NAMED = 1               # of a family, at any error
APART = 0.042           # of names from each other, as a share of the height
AXES = {"attitude": "attitude error at the end (rad)", "position": "position error at the end",
        "velocity": "relative velocity error at the end", "energy": r"largest energy error, $|E_h-E_0|\,/\,|E_0|$"}
COLOURS = {"ours": ("#0050B0", "#009E73", "#2E9BD6", "#4C9A2A", "#1F2F86", "#00838F"), "paper": ("#D55E00", "#E69F00"),
           "rival": ("#000000", "#882255", "#CC79C4", "#C2185B", "#7B3FA7", "#4A1942")}
# of families, without colours, too; and their sizes
MARKERS = {"ours": ("o", 4), "paper": ("v", 5), "rival": ("s", 4)}
OTHER = "#c4c4c4"       # of methods without a name
BAND, RIM, BAND_NAME = "#F3ECC0", "#B9A955", "#857520"
COSTS = {"force_evals": "force evaluations", "seconds": "time (s)"}
CAPTION = ("Circles (blue to green): this library. Triangles (orange): the paper. Squares (black, red, purple): rivals. A colour used twice "
           "is dashed.\nThick: the cheapest in time at most errors, of this library and of the rivals. Thin grey: never the cheapest of its "
           "group.\nYellow band: all methods of order 2 with one evaluation per step. Errors decrease to the right.")


@dataclass
class Line:
    """A method's prices: errors, by fall, and what they cost."""
    errors: np.ndarray
    costs: np.ndarray


def precision(cost, scene):
    measure = cost.measure(scene).removesuffix("_error")
    return _draw(cost, scene, measure, ("force_evals", "seconds"), "what accuracy costs")


def energy(cost, scene):
    return _draw(cost, scene, "energy", ("force_evals", "seconds"), "what a small energy error costs")


def _draw(cost, scene, measure, columns, what):
    figure = style.new_figure(HEIGHT)
    figure.suptitle(f"{words.plain(scene)}: {what} (to t = {cost.ends(scene)[0]:g})")
    row([figure.add_subplot(1, len(columns), place + 1) for place in range(len(columns))], cost.by_measure[scene][measure],
        measure, columns, methods.SECOND_ORDER)
    figure.supxlabel(CAPTION, fontsize=8.5, color=style.GREY)
    return figure


def row(panels, ladders, measure, columns, band):
    """A panel for each column, of the same methods in the same colours; band: those of order 2."""
    looks = _looks(ladders, _named(ladders, columns, band))
    best = {_best(ladders, kind) for kind in ("ours", "rival")} - {None}
    for axes, column in zip(panels, columns):
        _panel(axes, {method: _line(ladder, column) for method, ladder in ladders.items()}, looks, best, band)
        axes.set_xlabel(AXES[measure])
        axes.set_ylabel(COSTS[column])


def _line(ladder, column):
    good = np.isfinite(ladder[column]) & (ladder[column] > 0)
    return Line(ladder["error"][good], ladder[column][good])


def _named(ladders, columns, band):
    """Methods that are the cheapest of their family at some error, but those of the band."""
    chosen = set()
    for column in columns:
        for error in {float(error) for ladder in ladders.values() for error in ladder["error"]}:
            for kind in methods.FAMILIES:
                found = {method: price_list.price(ladder, error, column) for method, ladder in ladders.items()
                         if ladder.kind == kind and method not in band}
                found = {method: value for method, value in found.items() if np.isfinite(value)}
                chosen.update(sorted(found, key=found.get)[:NAMED])
    return chosen


def _best(ladders, kind):
    """The method of the kind that is the cheapest in time at most errors."""
    wins = {}
    for error in {float(error) for ladder in ladders.values() for error in ladder["error"]}:
        found = {method: price_list.price(ladder, error) for method, ladder in ladders.items() if ladder.kind == kind}
        found = {method: value for method, value in found.items() if np.isfinite(value)}
        if found:
            winner = min(found, key=found.get)
            wins[winner] = wins.get(winner, 0) + 1
    return max(sorted(wins), key=wins.get, default=None)


def _looks(ladders, named):
    """method -> colour, dashes, marker and its size, of those that are named."""
    looks, taken = {}, {}
    for method in sorted(named):
        kind = ladders[method].kind
        turn = taken[kind] = taken.get(kind, -1) + 1
        looks[method] = COLOURS[kind][turn % len(COLOURS[kind])], "-" if turn < len(COLOURS[kind]) else "--", *MARKERS[kind]
    return looks


def _panel(axes, lines, looks, best, band):
    axes.set_xscale("log")
    axes.set_yscale("log")
    banded = [line for method, line in lines.items() if method in band and len(line.errors)]
    ends = _band(axes, banded) if banded else []
    for method, line in sorted(lines.items(), key=lambda item: (item[0] in best, item[0] in looks)):
        if method in band or not len(line.errors):
            continue
        colour, dashes, marker, size = looks.get(method, (OTHER, "-", None, 0))
        width = 2.6 if method in best else 1.2 if method in looks else 0.7
        axes.plot(line.errors, line.costs, dashes, color=colour, linewidth=width, marker=marker,
                  markersize=size, zorder=3 if method in looks else 2)
        if method in looks:
            ends.append((line.errors[-1], line.costs[-1], methods.name(method), colour, method in best))
    shown = [line for line in lines.values() if len(line.errors)]
    errors = np.concatenate([line.errors for line in shown]) if shown else np.array([1e-2, 1e-10])
    costs = np.concatenate([line.costs for line in shown]) if shown else np.array([1.0, 10.0])
    style.log_axis(axes.yaxis, np.min(costs) / 1.3, np.max(costs) * 1.3)
    style.log_axis(axes.xaxis, np.min(errors) / 1.5, np.max(errors) * 1.5)
    axes.invert_xaxis()
    name_ends(axes, ends)


def _band(axes, lines):
    """All methods of order 2: from the cheapest to the dearest at each error that one of them reaches."""
    errors = sorted({float(error) for line in lines for error in line.errors}, reverse=True)
    costs = [[float(cost) for line in lines for cost in line.costs[np.isclose(line.errors, error, rtol=1e-6, atol=0)][:1]]
             for error in errors]
    axes.fill_between(errors, [min(each) for each in costs], [max(each) for each in costs], color=BAND, linewidth=1.5, edgecolor=RIM,
                      zorder=1)
    return [(errors[-1], float(np.sqrt(min(costs[-1]) * max(costs[-1]))), "all of order 2", BAND_NAME, False)]


def name_ends(axes, ends):
    """In one column right of the panel, by the height of the lines' ends."""
    low, high = axes.get_ylim()
    ends = sorted(ends, key=lambda end: end[1])
    heights = apart([np.log(end[1] / low) / np.log(high / low) for end in ends])
    for (error, value, name, colour, is_best), height in zip(ends, heights):
        axes.annotate(name, (error, value), (1.02, height), textcoords="axes fraction", color=colour, fontsize=8.5,
                      va="center", fontweight="bold" if is_best else "normal", annotation_clip=False,
                      arrowprops={"arrowstyle": "-", "color": colour, "linewidth": 0.5, "alpha": 0.6,
                                  "relpos": (0, 0.5), "shrinkA": 0, "shrinkB": 0})


def apart(heights):
    """Rising heights of names, moved as little as can be (the sum of squares) so that none covers another and all are
    between 0 and 1, if there is room: those that are too close are a group around their own middle."""
    groups = []     # of heights less those that the names below take up: mean, and of how many
    for k, height in enumerate(heights):
        groups.append((height - k * APART, 1))
        while len(groups) > 1 and groups[-2][0] > groups[-1][0]:
            (one, few), (other, more) = groups.pop(-2), groups.pop()
            groups.append(((few * one + more * other) / (few + more), few + more))
    free = np.repeat(*zip(*groups)) if groups else np.zeros(0)
    most = 1 - APART * (len(heights) - 1)
    return np.clip(free, min(0.0, most), most) + APART * np.arange(len(heights))
