# SPDX-License-Identifier: BSD-3-Clause
"""Scenes in LAMMPS and by vti-run: parts of the page peers."""

import os

import numpy as np

from .. import style
from ..curves import time_axis
from ..words import short_number
from .peers_rows import column, curves, in_order, of, read


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
        [[who, *(short_number(of(rows, who=who, h=h)[0]["error"]) for h in steps)] for who in ("vti", "LAMMPS")],
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
                    short_number(kinetic.max()),
                    *(short_number(mine[int(len(mine) * share)]["kinetic"]) for share in (0.25, 0.5, 0.75)),
                    short_number(kinetic[-1]),
                    f"{mine[-1]['height']:.3f}",
                ]
            )
    page.table(
        ["h", "by", "largest kinetic energy", "at t = 3", "6", "9", "12", "height of the centre of mass at 12"], table
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
                    short_number(h),
                    who,
                    *(f"{mine[int((len(mine) - 1) * share)]['bonds']:.0f}" for share in (0.2, 0.4, 1)),
                    *(f"{mine[int((len(mine) - 1) * share)]['kinetic'] / start:.3f}" for share in (0.2, 0.4, 1)),
                ]
            )
    page.table(["h", "by", "bonds at 0.3 ms", "0.6", "1.5", "kinetic energy, share of the start, at 0.3 ms", "0.6", "1.5"], table)


def places(folder, name):
    return np.loadtxt(os.path.join(folder, name + ".csv"), delimiter=",", skiprows=1, ndmin=2)


def side_view(axes, folder, scene, title):
    for who, look in zip(("vti", "LAMMPS"), style.LOOKS):
        x = places(folder, f"{scene}-{who}")
        axes.plot(x[:, 0], x[:, 2], look.marker, color=look.colour, markersize=4, fillstyle="none", label=who)
    axes.set(title=title, xlabel="x (units of the scene)", ylabel="z (units\nof the scene)", aspect="equal",
             ylim=(0, axes.get_ylim()[1] + 0.4))
    axes.legend(loc="upper left")


def finest(rows):
    return of(rows, h=min(in_order(rows, "h")))


def say_step(figure, step):
    figure.supxlabel(f"{step} for both codes.", fontsize=8.5, color=style.GREY)


def heap_picture(folder, path):
    figure = style.new_figure(6.6)
    above, below = figure.subplots(2, 1, height_ratios=[3, 1])
    rows = finest(read(folder, "heap"))
    curves(above, rows, "t", "kinetic", "vti", "semilogy", floor=1e-300)
    above.set(title="Kinetic energy", xlabel="t (units of the scene)", ylabel="energy (units of the scene)", xlim=(0, 12))
    say_step(figure, f"h = 1/{round(1 / rows[0]['h'])}")
    side_view(below, folder, "heap", "At rest, from the side")
    style.save(figure, path)


def agglomerate_picture(folder, path):
    figure = style.new_figure(4.4)
    left, right = figure.subplots(1, 2)
    rows = finest(read(folder, "agglomerate"))
    curves(left, rows, "t", "bonds", "vti")
    left.set(title="Bonds that hold", ylabel="bonds", ylim=(0, None))
    curves(right, rows, "t", "kinetic", "vti")
    right.set(title="Kinetic energy", ylabel="energy (J)", ylim=(0, None))
    for axes in (left, right):
        time_axis(axes)
        axes.set_xlabel("t (s)")
    say_step(figure, f"h = {rows[0]['h']:g} s")
    style.save(figure, path)


def bonded_part(page, folder):
    rows = read(folder, "bonded")
    page.heading("One bond that turns far")
    page.text(
        "Two spheres with an elastic bond, at rest at first but for their spins. The largest kinetic energy "
        "until t = 2 over that at the start, which is all energy that there is: what is above 1 comes out of "
        "nothing. A smaller step does not help LAMMPS: its bond forces and moments are those of an energy for "
        "small angles only."
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
        "`scenes/torus.yaml`, with the inertia of solid spheres, which is what LAMMPS knows: a ring of 80 "
        "bonded spheres strikes a plane; bonds are elastic and do not break. Kinetic energy; that at the "
        "start is all energy that there is. In LAMMPS the ring bursts after t = 3.5 (what leaves its box is "
        "forgotten), whatever the step, the order of the spheres, the margin of the neighbour list, and "
        "whether bonded spheres touch. So it does in releases up to March 2026. Since that of 4 July 2026 "
        "`bpm/rotational` has bonds that are made for large turns (`frame average`, now its default; pull "
        "request 4945 of its repository); `VTI_LAMMPS=FOLDER ./dev lammps` says what becomes of the ring with them (see Time, below)."
    )
    columns = [(who, h) for who in ("vti", "LAMMPS") for h in in_order(rows, "h")]
    kinetic = {(row["who"], row["h"], round(row["t"], 6)): row["kinetic"] for row in rows}
    page.table(
        ["t", *(f"{who}, h = {h:g}" for who, h in columns)],
        [[f"{t:g}", *(f"{kinetic[who, h, t]:.3g}" for who, h in columns)] for t in RING_TIMES],
    )
