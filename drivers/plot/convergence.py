# SPDX-License-Identifier: BSD-3-Clause
"""convergence.png: the three errors against the time step, as in the paper's figures of the pendulum and the torus,
with the true error beside the paper's, because the paper's q-error is the root of a difference of squares (a method of
order p shows p/2 there, and at most 1)."""
from dataclasses import dataclass

import numpy as np
from matplotlib.lines import Line2D

from . import style, words


@dataclass(frozen=True)
class Panel:
    measure: str
    name: str
    label: str


PANELS = (
    Panel("e_error", "Energy error", r"$‖E_h-E_0‖_{H^0}\;/\;‖E_0‖_{H^0}$"),
    Panel("q_error", "The paper's q-error", r"$\left|\,‖q_h‖^2-‖q‖^2\,\right|^{1/2}\;/\;‖q‖$"),
    Panel("h1_error", r"True $H^1$ error", r"$‖q_h-q‖_{H^1}\;/\;‖q‖_{H^1}$"),
)

LEGEND_LINE = 0.21      # inches
LOST = 0.1              # of the solution: a true error above it
TRAJECTORY = ("q_error", "h1_error")
CHAOTIC = 1e-3          # of the solution: a reference of this uncertainty, as vti-study has it


def draw(study):
    steppers = study.steppers()
    looks = style.looks(steppers)
    legend_height = LEGEND_LINE * (len(steppers) + 1.3)
    notes = [*_failed(study), *(note for panel in PANELS for note in _left_out(study, panel)), *_lost(study, steppers)]

    figure = style.new_figure(4.6 + legend_height + 0.18 * (len(notes) + 1))
    figure.suptitle(f"{words.plain(study.scene)}: error against the time step, "
                    rf"$t_{{\mathrm{{end}}}}$ = {words.given(study.t_end)}")
    grid = figure.add_gridspec(2, len(PANELS), height_ratios=(4.0, legend_height))
    for column, panel in enumerate(PANELS):
        axes = figure.add_subplot(grid[0, column])
        fits = {stepper: _fit(study, stepper, panel.measure) for stepper in steppers}
        axes.set_title(f"{panel.name}: {words.orders_phrase(fits.values())}")
        axes.set_xlabel("time step $h$ (units of the scene)")
        axes.set_ylabel(panel.label)
        _draw_panel(axes, study, panel, fits, looks)
        _draw_legend(style.bare(figure.add_subplot(grid[1, column])), fits, looks)
    figure.supxlabel("\n".join([_facts(study), *notes]), fontsize=8.5, color=style.GREY)
    return figure, notes


def _facts(study):
    fitted = np.any(study.orders["interval"] <= words.RESOLVED)
    return ((r"Lines: fits over the range of $h$ they used; pale points: left out of the fit.   " if fitted else "")
            + rf"$E_0$ = {words.given(study.energy0)},  $‖q‖^2_{{H^1}}$ = {words.given(study.norm_squared)},  "
            f"vti {words.plain(study.version)}")


def _is_lost(study, stepper):
    return bool(np.all(study.errors(stepper, "h1_error")[1] > LOST))


def _fit(study, stepper, measure):
    """As in the file; that of a lost trajectory is of no order, however well its points lie on a line."""
    fit = study.fit(stepper, measure)
    if fit and measure in TRAJECTORY:
        fit["lost"] = _is_lost(study, stepper)
    return fit


def _lost(study, steppers):
    """A trajectory that is nowhere near the reference at any h is not one that converges slowly."""
    if study.uncertainty > CHAOTIC:
        yield (f"the motion is chaotic: the reference itself is known to {words.plain_number(study.uncertainty)} of the solution "
               "only, and errors of trajectories of that size have no order")
    lost = [stepper for stepper in steppers if _is_lost(study, stepper)]
    if lost:
        yield (f"{words.listing(map(words.stepper_name, lost))}: the true error is above {LOST:g} at every h, so the "
               "trajectory is lost: the motion is chaotic, or h too large")


def _points(study, stepper, measure):
    """h and error of the stepper's runs, and which of them a logarithmic axis can show."""
    h, error = study.errors(stepper, measure)
    return h, error, np.isfinite(error) & (error > 0)


def _failed(study):
    mine = study.runs["stepper"][study.runs["failure"] != ""]
    if len(mine):
        yield f"{words.counted(len(mine), 'run')} failed ({words.listing(map(words.stepper_name, dict.fromkeys(mine)))})"


def _left_out(study, panel):
    zero, unusable = {}, {}
    for stepper in study.steppers():
        _, error, _ = _points(study, stepper, panel.measure)
        error = error[study.runs["failure"][study.runs["stepper"] == stepper] == ""]
        for found, where in ((np.sum(error == 0), zero), (np.sum(~np.isfinite(error) | (error < 0)), unusable)):
            if found:
                where[stepper] = int(found)
    for where, what in ((zero, "exactly 0"), (unusable, "not a finite number")):
        if where:
            yield (f"{panel.name}: {words.counted(sum(where.values()), 'point')} not drawn, the error being {what} "
                   f"({words.listing(map(words.stepper_name, where))})")


def _draw_panel(axes, study, panel, fits, looks):
    shown_h, shown_error = [], []
    for stepper, fit in fits.items():
        look = looks[stepper]
        h, error, usable = _points(study, stepper, panel.measure)
        h, error = h[usable], error[usable]
        fitted = np.ones(len(h), bool)
        if words.resolved(fit):
            slack = 1 + 1e-9    # the ends of the range are values of h, give or take a rounding
            fitted = (h >= fit["h_min"] / slack) & (h <= fit["h_max"] * slack)
            ends = np.array([fit["h_min"], fit["h_max"]])
            with np.errstate(all="ignore"):
                line = 2.0 ** (fit["log2_constant"] + fit["order"] * np.log2(ends))
            if np.all(np.isfinite(ends) & (ends > 0) & np.isfinite(line) & (line > 0)):
                axes.plot(ends, line, look.line, color=look.colour, linewidth=1.2, zorder=2)
        for part, alpha in ((fitted, 1.0), (~fitted, 0.4)):
            axes.plot(h[part], error[part], look.marker, markersize=look.size, markerfacecolor="none",
                      markeredgecolor=look.colour, markeredgewidth=1.3, alpha=alpha, zorder=3)
        shown_h.extend(h)
        shown_error.extend(error)
    if not shown_h:
        axes.text(0.5, 0.5, "no error above 0", transform=axes.transAxes, ha="center", color=style.GREY)
        axes.set(xticks=[], yticks=[])
        return
    slopes = sorted({words.nearest_order(fit) for fit in fits.values() if words.resolved(fit)})
    _set_limits(axes, study, np.array(shown_h), np.array(shown_error), slopes)


def _set_limits(axes, study, h, error, slopes):
    """The same h in every panel, so that they can be compared; the errors as they are, with room for the slope key."""
    all_h = study.runs["h"]
    exponents = np.log2(all_h)
    base = 2 if np.all(np.abs(exponents - np.round(exponents)) < 1e-9) else 10
    ratio = all_h.max() / all_h.min()
    edge = max(1.25, ratio**0.05, (6 / ratio) ** 0.5)
    style.log_axis(axes.xaxis, all_h.min() / edge, all_h.max() * edge, base)

    x, y = np.log10(h), np.log10(error)
    left, right = np.log10(axes.get_xlim())
    margin = max(0.35 if y.max() - y.min() < 0.5 else 0.15, 0.05 * (y.max() - y.min()))
    bottom, top = y.min() - margin, y.max() + margin
    slopes = [slope for slope in slopes if slope > 0]
    key = None
    if slopes:
        # The key starts 5 % above the axis; its steepest ray, and 9 % more for a marker, must pass below all points.
        width = min(0.24 * (right - left), 0.3 * (top - bottom) / slopes[-1])
        corner = right - width - 0.14 * (right - left)
        near = x > corner - 0.03 * (right - left)
        rise = slopes[-1] * np.clip(x[near] - corner, 0, width)
        bottom = np.min((y[near] - rise - 0.14 * top) / 0.86, initial=bottom)
        key = (corner, bottom + 0.05 * (top - bottom), width)
    style.log_axis(axes.yaxis, 10.0 ** max(bottom, -300), 10.0 ** min(top, 300))  # what a double can say
    if key:
        _draw_slope_key(axes, key, slopes, 0.043 * (top - bottom))


def _draw_slope_key(axes, key, slopes, line_height):
    """A fan of the slopes that the title names, in the corner below the data. Steepest first; a label that would touch
    the one above it goes, and so does its ray."""
    x, y, width = key
    ends = 10.0 ** np.array([x, x + width])
    axes.plot(ends, [10.0**y] * 2, color=style.GREY, linewidth=0.8)
    above = np.inf
    for slope in reversed(slopes):
        height = y + slope * width
        if height > above - line_height:
            continue
        above = height
        axes.plot(ends, 10.0 ** np.array([y, height]), color=style.GREY, linewidth=0.8)
        power = {0.5: "^{1/2}", 1: "", 1.5: "^{3/2}"}.get(slope, f"^{{{slope:g}}}")
        axes.annotate(f"$h{power}$", (ends[1], 10.0**height), xytext=(3, 0), textcoords="offset points", va="center",
                      fontsize=9.5, color=style.GREY)


def _draw_legend(axes, fits, looks):
    handles = [Line2D([], [], color=looks[stepper].colour, marker=looks[stepper].marker, markerfacecolor="none",
                      markersize=looks[stepper].size, markeredgewidth=1.3, linewidth=1.2,
                      linestyle=looks[stepper].line if words.resolved(fit) else "none",
                      label=f"{words.stepper_name(stepper)}: {words.order_text(fit)}")
               for stepper, fit in fits.items()]
    axes.legend(handles=handles, loc="upper center", borderaxespad=0, title="fitted order ± 95 % interval",
                title_fontsize=9.5, handlelength=2.2, labelspacing=0.35)
