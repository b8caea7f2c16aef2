# SPDX-License-Identifier: BSD-3-Clause
"""momenta.png: how far the linear momentum, the sum of the spins and the total angular momentum are from where they
began, component by component on a logarithmic scale, for some are kept to rounding and others change by their own
size."""
from dataclasses import dataclass

import numpy as np
from matplotlib.lines import Line2D

from . import curves, style, words
from .curves import EPS

FEW = 10        # times: of a run that blew up, where a line alone might have no second end
KEPT = 20       # times rounding at random: more than that is no rounding, even where it is small


@dataclass(frozen=True)
class Panel:
    vector: str
    name: str
    symbol: str


PANELS = (
    Panel("momentum", "Linear momentum", r"P"),
    Panel("spin", "Sum of spins", r"S"),
    Panel("angular", "Total angular momentum", r"L"),
)
MEANING = r"$P=\sum m v$,  $S=\sum J\Omega$,  $L=\sum (x\times m v+J\Omega)$"
LOOKS = (("x", "#0072B2"), ("y", "#D55E00"), ("z", "#009E73"))


@dataclass(frozen=True)
class Component:
    axis: str
    change: float       # the largest deviation from the initial value
    kept: bool


def components(run, vector):
    """What became of each component, or None where the scene lacks the vector."""
    values = run.vector(vector)
    if values is None:
        return None
    largest = [curves.largest(values[:, k] - values[0, k]) for k in range(3)]
    limit = KEPT * float(rounding(run, run.columns["t"][-1], scale(run, vector)))
    return [Component("xyz"[k], change, change <= limit) for k, change in enumerate(largest)]


def rounding(run, t, largest):
    """What one rounding error of the largest momentum per step adds up to, if their signs are random."""
    return EPS * largest * np.sqrt(np.maximum((t - run.columns["t"][0]) / run.h, 1.0))


def scale(run, vector):
    """Rounding is relative to what is exchanged, not to sums that may be 0: sums of m|v| and J|Omega|, which are at
    least twice the energy over the fastest, and of |x| m|v|. Lengths, and so what is to be compared, have any unit."""
    linear = max(_largest(run, "momentum"), _exchanged(run, "kinetic_translation", "velocity"))
    spin = max(_largest(run, "spin"), _exchanged(run, "kinetic_rotation", "omega"))
    if vector == "angular":
        return max(_largest(run, vector), spin, linear * run.longest("Points")) or 1.0
    return (linear if vector == "momentum" else spin) or 1.0


def _largest(run, vector):
    values = run.vector(vector)
    return 0.0 if values is None else float(np.max(np.abs(values)))


def _exchanged(run, energy, rate):
    fastest = run.longest(f"PointData/{rate}") if energy in run.columns else 0.0
    return 2 * float(np.max(run.columns[energy])) / fastest if fastest > 0 else 0.0


def draw(run):
    panels = [panel for panel in PANELS if run.vector(panel.vector) is not None]
    if not panels:
        return None, ["not drawn, the run has recorded no momenta"]
    notes = run.notes()
    fates = {panel: components(run, panel.vector) for panel in panels}
    largest = {panel: scale(run, panel.vector) for panel in panels}

    figure = style.new_figure(5.3)
    figure.suptitle(f"{words.plain(run.scene)}: deviation of the momenta from their initial values, "
                    f"{words.steps_of(run)}")
    grid = figure.add_gridspec(2, len(panels), height_ratios=(4.0, 0.3))
    for column, panel in enumerate(panels):
        axes = figure.add_subplot(grid[0, column])
        unit, top = EPS * largest[panel], max(component.change for component in fates[panel])
        style.log_axis(axes.yaxis, 0.03 * unit, max(6 * top, 1e4 * unit))
        _draw_panel(axes, run, run.vector(panel.vector), largest[panel])
        axes.set_title(f"{panel.name} ${panel.symbol}$\n{_verdict(fates[panel])}")
        if column == 0:
            axes.set_ylabel("absolute deviation (units of the scene)")
    _draw_legend(style.bare(figure.add_subplot(grid[1, :])), largest)
    figure.supxlabel("\n".join([f"{MEANING};  " r"$\varepsilon=2^{-52}$.  " f"vti {words.plain(run.version)}", *notes]),
                     fontsize=8.5, color=style.GREY)
    return figure, notes


def _draw_panel(axes, run, values, largest):
    t, few = run.columns["t"], len(run.columns["t"]) < FEW
    for k, (_, colour) in enumerate(LOOKS):
        times, peaks = curves.sliced(t, np.abs(values[:, k] - values[0, k]), np.max)
        axes.plot(times, np.where(peaks > 0, peaks, np.nan), "o-" if few else "-", color=colour,
                  linewidth=1.0, markersize=4)
    axes.plot(t, rounding(run, t, largest), ":", color=style.GREY, linewidth=1.2, zorder=1)
    curves.time_axis(axes, None if few else t)
    if few:
        axes.margins(x=0.05)    # or half of the last mark is cut off


def _verdict(fate):
    """A line per component: x changes by up to 96, y is kept to 7e-14, z exactly."""
    return "\n".join(f"${one.axis}$ " + (f"changes by up to {words.number(one.change)}" if not one.kept
                                         else f"kept to {words.number(one.change)}" if one.change > 0
                                         else "kept exactly") for one in fate)


def _draw_legend(axes, largest):
    handles = [Line2D([], [], color=colour, linewidth=2, label=f"${axis}$") for axis, colour in LOOKS]
    handles.append(Line2D([], [], color=style.GREY, linestyle=":", linewidth=1.2,
                          label=r"expected rounding: $\varepsilon\sqrt{t/h}$ times the momentum exchanged ("
                          + ", ".join(f"${panel.symbol}$ {words.number(value)}" for panel, value in largest.items()) + ")"))
    axes.legend(handles=handles, loc="center", ncol=4, borderaxespad=0)
