# SPDX-License-Identifier: BSD-3-Clause
"""ensemble.png: mean and spread of the errors against the time step, a row of panels for each group of a sweep."""
import textwrap

import numpy as np
from matplotlib.lines import Line2D

from . import style, words
from .convergence import PANELS

GROUPS = 4              # rows of panels
ROW, LEGEND_LINE = 3.6, 0.21    # inches
TITLE = 40              # letters beside each other above a panel


def draw(sweep):
    shown = sweep.groups[:GROUPS]
    steppers = list(dict.fromkeys(stepper for group in shown for stepper in group.steppers))
    looks = style.looks(steppers)
    legend = LEGEND_LINE * (len(steppers) + 1.3)
    notes = [note for group in shown for note in _left_out(sweep, group)]
    if len(sweep.groups) > GROUPS:
        notes.append(f"{words.counted(len(sweep.groups) - GROUPS, 'more group')} not drawn")
    figure = style.new_figure(len(shown) * (ROW + legend) + 0.18 * (len(notes) + 2))
    figure.suptitle(f"Mean and spread over {_ensemble(sweep)}")
    grid = figure.add_gridspec(2 * len(shown), len(PANELS), height_ratios=(ROW, legend) * len(shown))
    for row, group in enumerate(shown):
        for column, panel in enumerate(PANELS):
            axes = figure.add_subplot(grid[2 * row, column])
            axes.set_title(textwrap.fill(f"{_name(group)}: {panel.name.lower()}", TITLE) if column == 0 else panel.name)
            axes.set_xlabel("time step $h$ (units of the scene)")
            axes.set_ylabel(panel.label)
            _draw_panel(axes, group, panel.measure, looks)
            _draw_legend(style.bare(figure.add_subplot(grid[2 * row + 1, column])), group, panel.measure, looks)
    figure.supxlabel("\n".join([f"Points: means; bars: standard deviation, cut a decade below the least mean.   vti {words.plain(sweep.version)}", *notes]),
                     fontsize=8.5, color=style.GREY)
    return figure, notes


def _ensemble(sweep):
    if not sweep.values:
        return "one run each"
    ends = [words.given(value) if isinstance(value, (float, np.floating)) else words.plain(str(value))
            for value in (sweep.values[0], sweep.values[-1])]
    return f"{words.plain(sweep.key)} from {ends[0]} to {ends[1]} ({words.counted(len(sweep.values), 'value')})"


def _name(group):
    others = [f"{key} = {words.given(value) if isinstance(value, (float, np.floating)) else value}"
              for key, value in group.others.items()]
    return words.plain(", ".join([group.scene, *others]))


def _left_out(sweep, group):
    """What a logarithmic axis cannot show, and what has failed."""
    failed = int(group.columns["failed"].sum())
    if failed:
        yield f"{_name(group)}: {words.counted(failed, 'run')} failed and not in the means"
    infinite = int(group.columns["infinite"].sum())
    if infinite:
        yield f"{_name(group)}: {words.counted(infinite, 'run')} with infinite errors: these have no mean"
    for panel in PANELS:
        mean = group.columns[f"mean_{panel.measure}"]
        lost = int(np.sum(~(np.isfinite(mean) & (mean > 0))))
        if lost:
            yield f"{_name(group)}: {panel.name}: {words.counted(lost, 'mean')} not drawn, being 0, infinite or of no run"


def _draw_panel(axes, group, measure, looks):
    h, mean, spread = group.columns["h"], group.columns[f"mean_{measure}"], group.columns[f"spread_{measure}"]
    usable = np.isfinite(mean) & (mean > 0)
    if not np.any(usable):
        axes.text(0.5, 0.5, "no error above 0", transform=axes.transAxes, ha="center", color=style.GREY)
        axes.set(xticks=[], yticks=[])
        return
    spread = np.where(np.isfinite(spread), spread, 0.0)
    floor = 10.0 ** (np.log10(mean[usable].min()) - 1.0)    # where bars end that would reach 0
    low, high = np.maximum(mean - spread, floor), mean + spread
    for stepper, look in looks.items():
        mine = usable & (group.steppers == stepper)
        axes.plot(h[mine], mean[mine], look.line, marker=look.marker, color=look.colour, linewidth=1.2, markersize=look.size,
                  markerfacecolor="none", markeredgewidth=1.3, zorder=3)
        axes.vlines(h[mine], low[mine], high[mine], color=look.colour, linewidth=2.2, alpha=0.5, zorder=2)
    exponents = np.log2(h)
    base = 2 if np.all(np.abs(exponents - np.round(exponents)) < 1e-9) else 10
    style.log_axis(axes.xaxis, h.min() / 1.5, h.max() * 1.5, base)
    style.log_axis(axes.yaxis, max(low[usable].min() / 1.5, 1e-300), min(high[usable].max() * 1.5, 1e300))


def _draw_legend(axes, group, measure, looks):
    handles = [Line2D([], [], color=looks[stepper].colour, marker=looks[stepper].marker, markerfacecolor="none",
                      markersize=looks[stepper].size, markeredgewidth=1.3, linewidth=1.2, linestyle=looks[stepper].line,
                      label=f"{words.stepper_name(stepper)}: {_order_text(*group.orders[stepper, measure])}")
               for stepper in dict.fromkeys(group.steppers)]
    axes.legend(handles=handles, loc="upper center", borderaxespad=0, title="mean of fitted orders ± spread",
                title_fontsize=9.5, handlelength=2.2, labelspacing=0.35)


def _order_text(mean, spread):
    return words.with_interval(mean, spread) if np.isfinite(mean) else "no fit"
