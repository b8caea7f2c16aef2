# SPDX-License-Identifier: BSD-3-Clause
"""The page of `./dev granular`:  python3 -m plot.pages.granular FOLDER [--into DIR].  Beads that flow and come to rest:
run-out of columns, angles of repose, the drum's surface, rebounds. FOLDER holds column-BEADS-SEED/out.h5,
repose-MU-LENGTH-SEED/out.h5, drum/out.h5 and billiards/out.h5; page and picture go beside them, or with --into as
DIR/granular.md and DIR/granular/granular.png."""
import glob
import os
from dataclasses import dataclass

import numpy as np

from .. import style
from ..hdf5_file import RUN, Reader, opened
from ..run_file import read_run
from ..trouble import Trouble
from .page import Page, write_page

MU, RESTITUTION = 0.092, 0.97   # of scenes/billiards.yaml
NEAR = 1.03                     # beads of one heap: of the distance at which they touch
LOW, HIGH = 0.15, 0.85          # of the height of a heap, between which its slope is fitted
SPAN = 3                        # seconds of a row of the drum's table
SHARE = 0.95                    # of the beads, which lie behind the front
SQUAT, TALL = 2.2, 2.8          # aspect ratios up to which, and from which, a law is fitted
LAWS = ("Lajeunesse, Monnier and Homsy (Phys. Fluids 17, 2005) and Lube, Huppert, Sparks and Freundt "
        "(Phys. Rev. E 72, 2005)")


# ---- what a run shows -----------------------------------------------------------------------------------------------

def heap(x, radius):
    """Which beads are one heap, the largest, by touching; those that roll away alone are not."""
    distance = np.linalg.norm(x[:, None] - x[None], axis=2)
    near = distance < NEAR * (radius[:, None] + radius[None])
    left, largest = np.ones(len(x), bool), np.zeros(len(x), bool)
    while np.any(left):
        found = np.arange(len(x)) == np.argmax(left)
        while not np.array_equal(grown := np.any(near[found], axis=0), found):
            found = grown
        largest = max(largest, found, key=np.sum)
        left &= ~found
    return largest


def front(x, radius):
    inside = heap(x, radius)
    return float(np.max(x[inside, 0] + radius[inside]))


def surface(x, radius):
    """Middles of strips two beads wide, and the highest bead's top in each."""
    inside = heap(x, radius)
    x, radius = x[inside], radius[inside]
    width = 4 * np.mean(radius)
    strip = (x[:, 0] / width).astype(int)
    top = np.array([np.max(np.where(strip == k, x[:, 2] + radius, 0.0)) for k in range(strip.max() + 1)])
    return width * (np.arange(len(top)) + 0.5), top


def slope(x, radius):
    """Degrees of the surface between a low and a high share of its height: how fast the width of the heap falls with
    height."""
    where, top = surface(x, radius)
    levels = np.linspace(LOW, HIGH, 50) * top.max()
    width = (where[1] - where[0]) * np.sum(top > levels[:, None], axis=1)
    return float(np.degrees(np.arctan2(1, -np.polyfit(levels, width, 1)[0])))


def wedge(x, radius):
    """Degrees of the wedge against the wall at x = 0 that has the heap's centre of mass: its height over its distance.
    All beads count, and the beads of the foot as much as those of the slope."""
    inside = heap(x, radius)
    middle = np.average(x[inside], axis=0, weights=radius[inside] ** 3)
    return float(np.degrees(np.arctan2(middle[2], middle[0])))


@dataclass(frozen=True)
class Column:
    beads: int
    aspect: float
    runout: float   # (end - start)/start of the front behind which a share of the beads lies,
    furthest: float     # and of the furthest bead of the heap


def column(path):
    run = read_run(path)
    radius, first, last = run.diameter / 2, run.frame(0).x, run.frame(len(run.times) - 1).x
    start = float(np.max(first[:, 0] + radius))
    _, top = surface(first, radius)
    behind = [np.quantile(x[:, 0], SHARE) for x in (first, last)]
    return Column(run.bodies, float(np.mean(top)) / start, float(behind[1] / behind[0]) - 1,
                  front(last, radius) / start - 1)


def columns(folder):
    paths = glob.glob(os.path.join(glob.escape(folder), "column-*", "out.h5"))
    if not paths:
        raise Trouble(folder, "holds no column-*/out.h5", "make it with ./dev granular")
    return sorted((column(path) for path in paths), key=lambda one: one.aspect)


def power(some, measure="runout"):
    """Exponent and factor of run-out = factor aspect^exponent, and the standard error of the exponent."""
    x, y = (np.log([getattr(one, name) for one in some]) for name in ("aspect", measure))
    exponent, offset = np.polyfit(x, y, 1)
    off = y - exponent * x - offset
    error = np.sqrt(np.sum(off**2) / max(len(x) - 2, 1) / np.sum((x - np.mean(x)) ** 2))
    return float(exponent), float(np.exp(offset)), float(error)


def spread(values, digits=1):
    """Their mean, and in brackets the standard deviation of one."""
    return f"{np.mean(values):.{digits}f} ({np.std(values, ddof=len(values) > 1):.{digits}f})"


def slopes(folder):
    """(mu, length) -> angles of repose, the slope and that of the wedge, one pair of each seed."""
    found = {}
    for path in sorted(glob.glob(os.path.join(glob.escape(folder), "repose-*", "out.h5"))):
        mu, length, _ = os.path.basename(os.path.dirname(path)).split("-", 1)[1].rsplit("-", 2)
        run = read_run(path)
        x = run.frame(len(run.times) - 1).x
        found.setdefault((float(mu), length), []).append([angle(x, run.diameter / 2) for angle in (slope, wedge)])
    return found


def lengths(found):
    return sorted({length for _, length in found}, key=float)


def spans(times):
    """Start, end and which times are in it, of each row of the drum's table."""
    for start in range(0, int(times[-1]), SPAN):
        inside = (times > start) & (times <= start + SPAN)
        if np.any(inside):
            yield start, start + SPAN, inside


def drum(folder):
    """Times, and how far the centre of mass is off the vertical through the axis, in degrees."""
    run = read_run(os.path.join(folder, "drum", "out.h5"))
    middle = np.array([np.mean(run.frame(k).x, axis=0) for k in range(len(run.times))])
    return run.times, np.degrees(np.arctan2(np.abs(middle[:, 0]), -middle[:, 2]))


# ---- rebounds -------------------------------------------------------------------------------------------------------

@dataclass(frozen=True)
class Rebound:
    degrees: float
    plane: tuple    # normal and tangential velocity after it, computed
    closed: tuple   # the same as gross sliding has it, or None where it does not slide all the way
    pair: float     # how far the struck bead's velocity is off that, or None


def struck(normal, speed):
    """Velocity of the bead at rest which one of its mass meets at (0, 0, -speed), normal pointing to that one."""
    along = -speed * normal[2]
    across = np.array([0, 0, -speed]) - along * normal
    size = np.linalg.norm(across)
    return 0.5 * (1 + RESTITUTION) * along * (normal + MU * (-across / size if size > 0 else 0 * across))


def rebounds(folder):
    path = os.path.join(folder, "billiards", "out.h5")
    with opened(path) as file:
        velocity = Reader(path, file, RUN).numbers("/VTKHDF/PointData/velocity", 2)
    run = read_run(path)
    count = run.bodies // 3
    before, after = velocity[:run.bodies], velocity[-run.bodies:]
    found = []
    for k in range(count):
        across, down = before[k, 0], -before[k, 2]
        # the surface of a solid sphere loses 7/2 of what its centre loses
        slides = across > 3.5 * MU * (1 + RESTITUTION) * down
        closed = (RESTITUTION * down, across - MU * (1 + RESTITUTION) * down) if slides else None
        normal = np.array([across, 0, down])
        expected = struck(normal, 1.0)
        pair = float(np.linalg.norm(after[2 * count + k] - expected)) if slides else None
        found.append(Rebound(float(np.degrees(np.arctan2(across, down))), (after[k, 2], after[k, 0]), closed, pair))
    return found


# ---- page and picture -----------------------------------------------------------------------------------------------

def picture(some, found, times, angles):
    figure = style.new_figure(4.9)
    runs, repose, turning = figure.subplots(1, 3)
    aspect = np.array([one.aspect for one in some])
    runs.plot(aspect, [one.runout for one in some], "o", color=style.LOOKS[0].colour, label=f"{SHARE:.0%} of the beads")
    runs.plot(aspect, [one.furthest for one in some], ".", color=style.GREY, label="furthest of the heap")
    for chosen, look in ((aspect <= SQUAT, 1), (aspect >= TALL, 2)):
        if np.sum(chosen) > 1:
            exponent, factor, _ = power([one for one, taken in zip(some, chosen) if taken])
            ends = np.array([aspect[chosen].min() / 1.2, aspect[chosen].max() * 1.2])
            runs.plot(ends, factor * ends**exponent, "-" if look == 1 else "--", color=style.LOOKS[look].colour,
                      label=f"{factor:.2g} $a^{{{exponent:.2f}}}$")
    runs.set(xscale="log", yscale="log", title="run-out of columns", xlabel="height/width $a$",
             ylabel="(end - start)/start")
    runs.legend()
    for length, look in zip(lengths(found), style.LOOKS):
        mus = sorted(mu for mu, other in found if other == length)
        for measure, (line, name) in enumerate((("-", "slope"), (":", "wedge"))):
            each = [np.array(found[mu, length])[:, measure] for mu in mus]
            repose.errorbar(mus, [np.mean(some) for some in each], [np.std(some, ddof=len(some) > 1) for some in each],
                            fmt=look.marker + line, capsize=3, color=look.colour,
                            label=rf"{name}, $\mu_r$ = {float(length) * 1e3:g} mm")
    repose.set(title="angle of repose", xlabel=r"$\mu$", ylabel="degrees")
    repose.legend(loc="upper center", bbox_to_anchor=(0.5, -0.18), fontsize=8, ncols=2,
                  columnspacing=1)  # clear of error bars
    turning.plot(times, angles, color=style.LOOKS[0].colour, linewidth=0.8)
    for k, (start, end, inside) in enumerate(spans(times)):
        turning.hlines(np.mean(angles[inside]), start, end, color=style.LOOKS[1].colour, linewidth=2, zorder=3,
                       label=f"mean of {SPAN:g} s" if k == 0 else None)
    turning.set(title="drum: centre of mass", xlabel="$t$ (s)", ylabel="degrees off the vertical")
    turning.legend(loc="lower right")
    figure.supxlabel(style.below([f"Left: a point for each packing; lines are fits to the front behind which {SHARE:.0%} of the beads lie.",
                                  "Middle: error bars are the standard deviation of a single packing."]),
                     fontsize=8.5, color=style.GREY)
    return figure


def columns_part(page, some):
    page.heading("Run-out of a column against its aspect ratio")
    page.text("`scenes/column.yaml` with other tables: beads poured into a box of ten diameters' width beside the "
              "smooth wall, settled, and let go. a is height over width. Run-out is (end - start)/start of the front "
              f"behind which {SHARE:.0%} of the beads lie. Beside it is that of the furthest bead of the heap, which is the "
              "place of one bead; beads that have rolled away alone do not count there. The two have different starts, so the "
              "furthest bead may have the smaller number. Means over the packings, and in brackets the standard deviation of a "
              "single one.")
    alike = [[one for one in some if one.beads == beads] for beads in sorted({one.beads for one in some})]
    page.table(["beads", "packings", "a", "run-out", "of the furthest bead"],
               [[str(same[0].beads), str(len(same)),
                 *(spread([getattr(one, name) for one in same], 2) for name in ("aspect", "runout", "furthest"))]
                for same in alike])
    squat, tall = [one for one in some if one.aspect <= SQUAT], [one for one in some if one.aspect >= TALL]
    if len(squat) > 1 and len(tall) > 1:
        (low, first, below), (high, second, above) = power(squat), power(tall)
        furthest = [power(part, "furthest") for part in (squat, tall)]
        page.text(f"Two regimes: {first:.2f} a^{low:.2f} up to a = {SQUAT:g}, {second:.2f} a^{high:.2f} from a = "
                  f"{TALL:g} on, the exponents with standard errors of {below:.2f} and {above:.2f}; of the furthest "
                  f"bead a^{furthest[0][0]:.2f} and a^{furthest[1][0]:.2f}, {furthest[0][2]:.2f} and "
                  f"{furthest[1][2]:.2f}. In channels {LAWS} found a^1 below 2 to 3 and a^(2/3) above; the factors "
                  "depend on friction. Columns are ten beads wide, and packings differ: points scatter.")


def repose_part(page, found):
    page.heading("Angle of repose against friction")
    page.text("250 beads in a box of 25 diameters' width, whose side opens at once: the angle of the heap that is left, "
              f"in degrees, mean over {max(len(some) for some in found.values())} packings and in brackets the standard "
              f"deviation of a single one. The slope is fitted between {LOW:.0%} and {HIGH:.0%} of the height, a dozen "
              "strips of beads, and scatters. `wedge` is the slope of the triangular heap with the same centre of mass; all "
              "beads count, also those in the long toe. mu is the friction between beads, the plane keeps its 0.8; mu_r is "
              "the length of the rolling resistance, the mean radius being 1.5 mm.")
    rows = []
    for mu in sorted({mu for mu, _ in found}):
        angles = [np.array(found.get((mu, length), [[float("nan")] * 2])) for length in lengths(found)]
        rows.append([f"{mu:g}", *(spread(some[:, measure]) for some in angles for measure in (0, 1))])
    page.table(["mu", *(f"{name}, mu_r = {float(length) * 1e3:g} mm" for length in lengths(found)
                        for name in ("slope", "wedge"))], rows)


def drum_part(page, times, angles):
    page.heading("The drum's surface")
    page.text("`scenes/drum.yaml`, for longer: the angle between the vertical and the bed's centre of mass, as seen from "
              f"the axis; mean and standard deviation over every {SPAN:g} seconds, at frames so close that they show how it swings. Beads slip back one by one "
              "and in avalanches, which the deviation tells; the mean stays.")
    rows = [[f"{start} to {end}", f"{np.mean(angles[inside]):.1f}", f"{np.std(angles[inside]):.1f}"]
            for start, end, inside in spans(times)]
    page.table(["s", "degrees", "deviation"], rows)


def rebounds_part(page, some):
    page.heading("Rebounds")
    page.text(f"`scenes/billiards.yaml` at its h, about 100 steps in a contact. Beads leave the plane with e = "
              f"{RESTITUTION} of their normal velocity, and where they slide all the way, v_t > (7/2) mu (1 + e) v_n, "
              f"they lose mu (1 + e) v_n of the tangential one, mu = {MU}. The last column is the distance of the "
              "struck bead's velocity from the same closed form, which holds the normal fixed; here it turns by 1e-3.")
    page.table(["degrees", "normal", "e v_n", "tangential", "closed form", "struck bead off by"],
               [[f"{one.degrees:.0f}", f"{one.plane[0]:.6f}", f"{RESTITUTION * np.cos(np.radians(one.degrees)):.6f}",
                 f"{one.plane[1]:.6f}", f"{one.closed[1]:.6f}" if one.closed else "sticks",
                 f"{one.pair:.1e}" if one.pair is not None else "-"] for one in some])


def build(folder, into, below):
    some, found, (times, angles), balls = columns(folder), slopes(folder), drum(folder), rebounds(folder)
    page = Page(into, "Beads that flow and come to rest")
    page.text("Made by `./dev granular`; every number is from its files. Glass beads of 3 mm, in SI units; scenes and "
              "laws are those of `docs/dissipation.md`.")
    place = os.path.join(below or "", "granular.png")
    style.save(picture(some, found, times, angles), os.path.join(into, place))
    page.picture(*place.split(os.sep))
    columns_part(page, some)
    repose_part(page, found)
    drum_part(page, times, angles)
    rebounds_part(page, balls)
    style.write(page.markdown().encode("utf-8"), os.path.join(into, "granular.md"))
    if below is None:
        style.write(page.html().encode("utf-8"), os.path.join(into, "granular.html"))
    print(os.path.join(into, "granular.md"))


if __name__ == "__main__":
    write_page("granular", "what ./dev granular wrote", build)
