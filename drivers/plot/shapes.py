# SPDX-License-Identifier: BSD-3-Clause
"""shapes.png: the bodies at equally spaced times, one scale and one window for all, as in the paper's figure of the
deformed torus."""
from . import scenery, style, words

PANELS = (8, 9, 6)      # the first that divides the trajectory into equal parts, else the first of all
TALLEST = 11.0          # inches of all panels together
TITLE = 0.3             # inches above each


def draw(run):
    if not run.translates:
        return None, ["not drawn, the bodies of this scene have no positions"]
    frames = [run.frame(k) for k in _choose(len(run.times))]
    scene = scenery.Scenery(run, frames)
    rows, columns = _grid(len(frames), *scene.half)
    panel = TITLE + (style.WIDTH / columns - 0.45) * scene.half[1] / scene.half[0]
    figure = style.new_figure(0.95 + rows * min(panel, TALLEST / rows))
    figure.suptitle(f"{words.plain(run.scene)}: shapes over time, {words.stepper_name(run.stepper)}, "
                    rf"$h$ = {words.step_text(run.h)}")
    grid = figure.subplots(rows, columns, sharex=not scene.follows, sharey=not scene.follows, squeeze=False)
    touched = False
    for place, (axes, frame) in enumerate(zip(grid.flat, frames)):
        touched |= scene.draw(axes, frame)
        axes.ticklabel_format(style="sci", scilimits=(-2, 4), useMathText=True)  # millimetres in metres, say
        axes.set_title(f"$t$ = {frame.t:.4g}", pad=3)
        if place + columns >= len(frames):
            axes.set_xlabel(f"${scene.axis_names()[0]}$ (lengths)", labelpad=1)
        if place % columns == 0:
            axes.set_ylabel(f"${scene.axis_names()[1]}$ (lengths)", labelpad=1)
    figure.supxlabel("\n".join([_facts(run, scene, touched), *run.notes()]), fontsize=8.5, color=style.GREY)
    return figure, run.notes()


def _choose(count):
    """Frames at equally spaced times from the first to the last, all of them if they are few."""
    if count <= max(PANELS):
        return list(range(count))
    panels = next((panels for panels in PANELS if (count - 1) % (panels - 1) == 0), PANELS[0])
    return [round(k * (count - 1) / (panels - 1)) for k in range(panels)]


def _grid(count, width, height):
    """Full rows and columns that show the bodies largest."""
    def scale(columns):
        return min((style.WIDTH / columns - 0.45) / width, (TALLEST / (count // columns) - TITLE) / height)
    columns = max((columns for columns in range(1, count + 1) if count % columns == 0), key=scale)
    return count // columns, columns


def _facts(run, scene, touched):
    parts = []
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
    return "  ".join([*parts, f"vti {words.plain(run.version)}"])
