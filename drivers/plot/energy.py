# SPDX-License-Identifier: BSD-3-Clause
"""energy.png: where the energy is over time, as a stack that adds up to the total, and below it each term by itself on
a logarithmic scale, because the small ones do not show in the stack."""
import numpy as np
from matplotlib.colors import to_rgb
from matplotlib.patheffects import withStroke
from matplotlib.ticker import FixedLocator, LogFormatterMathtext

from . import curves, style, terms, words

STACK_SLICES = 800      # means over these: a stack of extremes would not add up
DECADES = 5             # of the lower panel, below the largest term
PALE = 0.8              # of white's brightness: yellow has a rim as a line


def draw(run):
    t, energies = run.columns["t"], run.energies()
    looks, notes = terms.of(run, energies), run.notes()
    # Counted from its lowest value is what is negative somewhere: a choice of zero and no more.
    lowered = [name for name, values in energies.items() if np.min(values) < -1e-9 * np.max(np.abs(values))]
    energies.update((name, energies[name] - np.min(energies[name])) for name in lowered)

    figure = style.new_figure(max(7.6, 1.3 + 0.42 * (1 + len(energies))))  # as high as its legend asks for
    figure.suptitle(f"{words.plain(run.scene)}: energies over time, {words.steps_of(run)}")
    stack, single = figure.subplots(2, 1, sharex=True, height_ratios=(1.5, 1))
    _draw_stack(stack, t, energies, looks)
    _draw_single(single, t, energies, looks)
    figure.supxlabel("\n".join([_facts(run, t, lowered), *notes]), fontsize=8.5, color=style.GREY)
    return figure, notes


def _draw_stack(axes, t, energies, looks):
    """Layers from the bottom up."""
    layers = {}
    for name, values in energies.items():
        means_t, means = curves.sliced(t, values, np.mean, STACK_SLICES)
        layers[name] = np.maximum(means, 0.0)
    drawn = axes.stackplot(means_t, *layers.values(), colors=[look.colour for look in looks.values()], linewidth=0)
    total = np.sum(list(layers.values()), axis=0)
    line, = axes.plot(means_t, total, color="#000000", linewidth=1.3)
    axes.set_ylim(0, 1.06 * np.max(total) if np.max(total) > 0 else 1)
    axes.set_ylabel("energy")
    axes.legend([line, *reversed(drawn)], ["total", *reversed([_name(look) for look in looks.values()])],
                loc="center left", bbox_to_anchor=(1.0, 0.5), handlelength=1.2, labelspacing=0.5)


def _name(look):
    return f"{look.symbol}  {look.meaning}".strip()


def _is_pale(colour):
    """Whether a line of that colour hardly shows on white: by the weights of the eye."""
    return float(np.dot(to_rgb(colour), (0.2126, 0.7152, 0.0722))) > PALE


def _draw_single(axes, t, energies, looks):
    """The largest value in every slice; what is far below the largest term is below the panel."""
    top = max(np.max(values) for values in energies.values())
    if not top > 0:
        style.bare(axes)
        return
    bottom = top * 10.0**-DECADES
    for name, values in energies.items():
        times, peaks = curves.sliced(t, values, np.max, STACK_SLICES)
        line, = axes.plot(times, np.maximum(peaks, 0.01 * bottom), color=looks[name].colour, linewidth=1.0)
        if _is_pale(looks[name].colour):
            line.set_path_effects([withStroke(linewidth=1.6, foreground="#777777")])
    axes.set(yscale="log", ylim=(bottom, 2.5 * top), ylabel="energy, each by itself")
    axes.yaxis.set_major_locator(FixedLocator(10.0 ** np.arange(np.ceil(np.log10(bottom)), np.log10(2.5 * top))))
    axes.yaxis.set_major_formatter(LogFormatterMathtext())
    axes.yaxis.set_minor_locator(FixedLocator([]))
    curves.time_axis(axes, t)


def _facts(run, t, lowered):
    parts = []
    if len(t) > STACK_SLICES:
        parts.append(f"Above, means over 1/{STACK_SLICES} of the time; below, the largest value in each.")
    if lowered:
        parts.append(f"Counted from its lowest value: {words.listing(name.replace('_', ' ') for name in lowered)}.")
    return style.below([*parts, f"Units are those of the scene.  vti {words.plain(run.version)}"])
