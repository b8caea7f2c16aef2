# SPDX-License-Identifier: BSD-3-Clause
"""shapes.png: the bodies at equally spaced times, until they rest, one scale and one window for all, as in the paper's
figure of the deformed torus."""
import numpy as np
from matplotlib.ticker import FuncFormatter, MaxNLocator

from . import scenery, style, walls, words

PANELS = (8, 9, 6)      # the first that divides the trajectory into equal parts, else the first of all
WIDE = 2.5              # times as wide as it is high, a window is a strip: then fewer are drawn, and larger
STRIPS = (6, 5, 7)      # the same of strips
TALLEST = 11.0          # inches of all panels together
TITLE, AROUND = 0.3, 0.45   # inches above and beside each
FILLED = 0.75           # of a page's width, so much at least where that can be
STILL = 0.005           # of the window, and radians: who has moved by less, rests
CALM = 1e-4             # ... where kinetic energies are less of their largest sum, too
NARROW = 1.7            # inches: a panel without room for the unit beside its axis
LETTER, POWER = 0.064, 6    # inches of a letter of a label, and how many letters are as long as a power of ten
TICK = 0.3              # inches of a number below an axis
FAR = 20                # windows from the origin


class _Axis:
    """How a coordinate is written: less a round base, where the bodies are far from the origin, in a power of ten."""

    def __init__(self, name, base, power):
        self.name, self.base, self.power = name, base, power

    def label(self, unit):
        sign = " + " if self.base < 0 else " \N{MINUS SIGN} "
        return self.name + (f"{sign}{abs(self.base):.12g}" if self.base else "") + unit

    def show(self, axis, most):
        axis.set_major_locator(MaxNLocator(most, steps=[1, 2, 5, 10], min_n_ticks=1))
        axis.set_major_formatter(FuncFormatter(
            lambda value, _: f"{round((value - self.base) / 10.0**self.power, 6):g}".replace("-", "\N{MINUS SIGN}")))


def _base(scene):
    """Of both coordinates: 0 near the origin."""
    unit = 10.0 ** np.ceil(np.log10(np.max(scene.half)))
    far = (np.abs(scene.middle) > FAR * np.max(scene.half)) & (not scene.follows)
    return np.where(far, np.round((scene.middle - scene.half) / unit) * unit, 0.0)


def draw(run):
    if not run.translates:
        return None, ["not drawn, the bodies of this scene have no positions"]
    count = len(run.times)
    frames = [run.frame(k) for k in _choose(count, PANELS)]
    scene = scenery.Scenery(run, frames)
    until = until_rest(run, scene)
    if until < count or scene.half[0] > WIDE * scene.half[1]:
        frames = [run.frame(k) for k in _choose(until, STRIPS if scene.half[0] > WIDE * scene.half[1] else PANELS)]
        scene = scenery.Scenery(run, frames)
    rows, columns = _grid(len(frames), *(2 * scene.half))
    panel = TITLE + (style.WIDTH / columns - AROUND) * scene.half[1] / scene.half[0]
    figure = style.new_figure(0.95 + rows * min(panel, TALLEST / rows))
    figure.suptitle(f"{words.plain(run.scene)}: shapes over time, {words.steps_of(run)}")
    grid = figure.subplots(rows, columns, sharex=not scene.follows, sharey=not scene.follows, squeeze=False)
    touched, base = False, _base(scene)
    power = _power([scene.window(frame) - base for frame in frames])
    unit = (rf"$10^{{{power}}}$ " if power else "") + "units of the scene"
    wide = style.WIDTH / columns - AROUND
    wide = min(wide, (min(panel, TALLEST / rows) - TITLE) * scene.half[0] / scene.half[1])
    tall = wide * scene.half[1] / scene.half[0]
    long = LETTER * (len(scene.axis_names()[1].strip("$")) + len(" (units of the scene)") + POWER * (power != 0))
    across, up = (_Axis(name, *at, power) for name, at in zip(scene.axis_names(), base.reshape(2, 1)))
    for place, (axes, frame) in enumerate(zip(grid.flat, frames)):
        touched |= scene.draw(axes, frame)
        across.show(axes.xaxis, max(1, int(wide / TICK)))
        up.show(axes.yaxis, max(2, int(tall / TICK)))
        axes.set_title(f"$t$ = {frame.t:.4g}", pad=3)
        if place + columns >= len(frames):
            axes.set_xlabel(across.label("" if wide < NARROW else f" ({unit})"), labelpad=1)
        if place % columns == 0:
            axes.set_ylabel(up.label("" if wide >= NARROW and tall < long else f" ({unit})"), labelpad=1)
    notes = [*run.notes(), *walls.notes(scene.walls, scene.plane)]
    figure.supxlabel("\n".join([_facts(run, scene, touched, until), *notes]), fontsize=8.5, color=style.GREY)
    return figure, notes


def _power(windows):
    """That of ten in which both coordinates, whose scales are one, are written: millimetres in metres, say; 0 near
    1."""
    power = int(np.floor(np.log10(np.max(np.abs(windows)) / 2)))
    return 0 if -2 < power < 4 else power


def until_rest(run, scene):
    """How many frames there are until bodies are where they are at the end, and slow; all of them where walls move or
    the window does."""
    count = len(run.times)
    if scene.follows or run.walls.move():
        return count
    last, turns = run.frame(count - 1), scene.marked or run.ellipsoids
    while count > 1 and _apart(run.frame(count - 2), last, np.max(scene.half), turns) <= STILL:
        count -= 1
    return count if _is_calm(run, run.times[count - 1]) else len(run.times)


def _is_calm(run, start):
    """Whether nothing moves from then on: bodies may come back to where they were, frame after frame."""
    kinetic = [values for name, values in run.columns.items() if name.startswith("kinetic_")]
    later = run.columns["t"] >= start
    total = np.sum(kinetic, axis=0) if kinetic else np.zeros(len(later))
    return np.max(total[later], initial=0.0) <= CALM * np.max(total, initial=0.0)


def _apart(frame, other, size, turns):
    """How far bodies are from where they are in another frame, in sizes, or in radians; infinite where bonds have
    broken."""
    if len(frame.lines) != len(other.lines):
        return np.inf
    far = np.max(np.abs(frame.x - other.x if frame.spheres is None else frame.spheres - other.spheres)) / size
    cosine = np.abs(np.sum(frame.attitude * other.attitude, axis=1)) if turns else np.ones(1)
    return max(far, 2 * np.arccos(min(1.0, np.min(cosine))))


def _choose(count, numbers):
    """Frames at equally spaced times from the first to the last, as many as fit of these numbers; all of them if they
    are few."""
    if count <= max(numbers):
        return list(range(count))
    panels = next((panels for panels in numbers if (count - 1) % (panels - 1) == 0), numbers[0])
    return [round(k * (count - 1) / (panels - 1)) for k in range(panels)]


def _grid(count, width, height):
    """Full rows and columns that fill the page's width and show the bodies largest."""
    def merit(columns):
        wide = (style.WIDTH / columns - AROUND) / width     # inches per length
        scale = min(wide, (TALLEST / (count // columns) - TITLE) / height)
        return min(scale / wide, FILLED), scale
    columns = max((columns for columns in range(1, count + 1) if count % columns == 0), key=merit)
    return count // columns, columns


def _facts(run, scene, touched, until):
    parts = []
    if until < len(run.times):
        parts.append(f"Bodies rest from $t$ = {run.times[until - 1]:.4g} on.")
    if run.clumps is not None:
        parts.append("Circles: spheres of clumps, which share a colour.")
    if run.ellipsoids:
        parts.append("Ellipses: outlines of solids that have the bodies' mass and moments.")
    if scene.marked:
        parts.append("Black marks are fixed to the bodies and point outwards at $t$ = 0.")
    if run.breaks:
        parts.append("Colours: fragments, single bodies pale.")
    if touched:
        other = "another body" if run.touching == 2 or not len(run.lines) else "a body of no common bond"
        parts.append("Orange: in contact with " + " or with ".join([f"a {name}" for name in run.walls.names] +
                                                                   [other] * (run.touching > 0)) + ".")
    if scene.follows:
        parts.append("The window moves with the bodies, the scale stays.")
    if run.diameter is None and run.clumps is None and not run.ellipsoids:
        parts.append("The bodies have no diameter; dots are not to scale.")
    return style.below([*parts, f"vti {words.plain(run.version)}"])
