# SPDX-License-Identifier: BSD-3-Clause
"""What limits a step, by its operations and bytes, and what cores share: measured to the cores that there are, modelled
beyond."""
import os

import numpy as np
from matplotlib.ticker import LogFormatter

from .. import style
from .performance_rows import read_rows, short, size_text

FLOPS = ["what", "instructions", "flops"]
SCALING = ["what", "workers", "median_s", "least_s"]
SHARED = ["instructions", "shared"]
RANKS = ["what", "tasks", "ranks", "seconds"]
ABREAST = "lattices at once"
CORES = {"lattice": "`vti-run --threads`", ABREAST: "`vti-run`s of one thread at once", "study of the pendulum": "`vti-study`, pendulum", "study of the torus": "`vti-study`, torus"}

# Bytes that come from memory or go there where each is needed once. A step in two phases moves 52 numbers of a body. A
# bond has two indices, n0 and L0 of its own; for its effect a body's x and alpha are read, force and moment written. So
# a third of a body's for each bond or pair of the lattice. A listed pair has two indices, and of the bodies x and
# force.
NUMBER, BONDS = 8, 3
STEP = 52 * NUMBER
BOND = 6 * NUMBER + 12 * NUMBER / BONDS
PAIR = 2 * NUMBER + 6 * NUMBER / BONDS
BYTES = {"step": STEP, "bond": BOND, "touching pair": PAIR}
NAMES = {"step": "body's step, `vti2`", "bond": "bond: moment, axial, shear", "touching pair": "contact of a touching pair",
         "friction and dashpots": "the same with friction and dashpots: what they add"}

LATTICE, STEPS = 46**3, 500     # of bench/scaling.py
THREADS = [1 << k for k in range(7)]
SOCKETS = (4, 8, 16)            # bandwidth of all cores together over that of one


def time_of(bench, what, n):
    """ns per item."""
    if what == "step":
        return bench.ns("vti2", "packed", n)
    if what == "friction and dashpots":
        pairs = BONDS * (1 - n ** (-1 / 3))     # of a body
        return (bench.ns("body that rubs", "packed", n) - bench.ns("body that touches", "packed", n)) / pairs
    return bench.ns(what, "packed", n)


# ---- the roofline ---------------------------------------------------------------------------------------------------

def bandwidth(bench, n):
    """GB/s of the loop of the same bytes."""
    return STEP / bench.ns("bytes", "packed", n)


def roofline_part(page, folder, bench, sizes, image):
    page.heading("What arithmetic and memory allow")
    if not os.path.isfile(os.path.join(folder, "flops.csv")):
        page.text("Operations are not counted: that takes valgrind and objdump.")
        return
    rows = {row["what"]: row for row in read_rows(folder, "flops", FLOPS)}
    peak = 1 / bench.ns("peak", "packed", sizes[0])
    most = ("vti-bench does not know what one core of this processor makes at most. In brackets: over what memory allows, the"
            if np.isnan(peak) else
            f"One core makes at most {short(peak)} GFlop/s: sums and products in registers, half of each, none of which waits for another. In "
            "brackets: over what is possible, the less of that and of the")
    page.text(f"Operations and instructions of a body, bond or touching pair and step, as callgrind counts them in the kernels for AVX2: a sum, "
              f"difference, product, quotient or root is one operation. {bench.units} makes the same operations with fewer instructions. "
              f"{most} operations per byte times the bandwidth of the loop of the same "
              "bytes at this n, which goes in one direction; a step, whose last kick comes back, may be above it where caches hold a part "
              "of the bodies. Quotients and roots, which each of these has, take a processor four to twenty times as long "
              "as a sum.")
    page.table(["", "instructions", "operations", "operations per byte", *(f"GFlop/s, n = {size_text(n)}" for n in sizes)],
               [[NAMES[what], short(float(row["instructions"])), short(float(row["flops"])),
                 short(float(row["flops"]) / BYTES[what]) if what in BYTES else "-",
                 *(of_possible(bench, what, float(row["flops"]), n, peak) for n in sizes)] for what, row in rows.items()])
    roofline(bench, rows, sizes, peak, os.path.join(page.folder, image))
    page.picture(image)


def of_possible(bench, what, flops, n, peak):
    rate = flops / time_of(bench, what, n)
    most = np.fmin(peak, bandwidth(bench, n) * flops / BYTES[what]) if what in BYTES else peak
    return "-" if np.isnan(rate) else short(rate) if np.isnan(most) else f"{short(rate)} ({rate / most:.2f})"


def marks_text(sizes):
    """Which marks are of which number of bodies."""
    filled, *others = map(size_text, sizes)
    if len(others) == 2:
        others = [f"{others[0]} (small)", f"{others[1]} (large)"]
    return f"filled: n = {filled}" + (f", open: {', '.join(others)}" if others else "")


def roofline(bench, rows, sizes, peak, path):
    figure = style.new_figure(4.6)
    axes = figure.subplots()
    for n, line in zip(sizes, ("-", "--", ":")):
        x = np.array([1 / 16, np.fmin(peak / bandwidth(bench, n), 16), 16])
        axes.plot(x, np.fmin(bandwidth(bench, n) * x, peak), line, color="black",
                  label=f"possible, n = {size_text(n)}: {short(bandwidth(bench, n))} GB/s")
    for what, look in zip(BYTES, style.LOOKS):
        flops = float(rows[what]["flops"])
        for k, n in enumerate(sizes):
            axes.plot(flops / BYTES[what], flops / time_of(bench, what, n), look.marker, color=look.colour, markersize=5 + 2.5 * k,
                      fillstyle="none" if k else "full", label=NAMES[what].replace("`", "") if k == 0 else None)
    axes.set(title=f"One core, {bench.units}; {marks_text(sizes)}", xlabel="operations per byte", ylabel="GFlop/s", xscale="log", yscale="log")
    # of two decades or less, so that others than powers of ten have numbers too
    axes.yaxis.set_major_formatter("{x:g}")
    axes.yaxis.set_minor_formatter(LogFormatter(minor_thresholds=(2, 0.5)))
    axes.legend(loc="lower right", fontsize="small")
    style.save(figure, path)


# ---- threads and ranks ----------------------------------------------------------------------------------------------

def cores_part(page, folder, bench):
    page.heading("Threads and ranks")
    rows = read_rows(folder, "scaling", SCALING)
    seconds = {(row["what"], int(row["workers"])): float(row["median_s"]) for row in rows}
    page.text("Medians of rounds in which all have their turn. `vti-run --threads`: 500 steps of 97336 bonded spheres (bench/lattice.yaml), "
              "start and files left out. `vti-study` under mpirun: whole studies, from start to end, without pictures.")
    page.table(["", "threads, runs or ranks", "seconds", "of the time of one"],
               [[CORES[what], str(workers), short(took), f"{took / seconds[what, 1]:.2f}"] for (what, workers), took in seconds.items()])
    most = max(workers for what, workers in seconds if what == ABREAST)
    longer = seconds[ABREAST, most] / seconds[ABREAST, 1]
    page.text(f"{most} runs at once share nothing but the machine, and take {longer:.2f} times as long as one: that is {most / longer:.2f} times "
              f"the work of one core. `--threads {most}` is {seconds['lattice', 1] / seconds['lattice', most]:.2f} times as fast as one thread. "
              "Files are the same bytes for any number of threads or ranks.")
    if os.path.isfile(os.path.join(folder, "shared.csv")):
        threads_part(page, folder, bench, seconds)
    ranks_part(page, folder)


def threads_part(page, folder, bench, seconds):
    """The model."""
    [row] = read_rows(folder, "shared", SHARED)
    alone = max(1 - float(row["shared"]) / float(row["instructions"]), 0.0)
    one, n = seconds["lattice", 1] / STEPS, max(bench.sizes())
    moved = LATTICE * (STEP + BONDS * BOND)
    rate = 1e9 * bandwidth(bench, n)

    def times(threads, socket):
        """How many times as fast as one thread."""
        shared = one * (alone + (1 - alone) / threads)
        return one / max(shared, moved / (rate * min(threads, socket)) if socket else 0)

    page.text(f"**More threads are a model, not a measurement.** Of {short(float(row['instructions']))} instructions of a bonded body's step (callgrind) one thread alone takes "
              f"{f'{100 * alone:.2g}' if alone > 1e-3 else 'less than 0.1'} %, which any number of threads waits for; the others they share. A step moves {moved / 1e6:.0f} MB where "
              f"nothing stays in a cache. One core moves {rate / 1e9:.0f} GB/s (the loop of the same bytes, n = {size_text(n)}), all cores of a "
              "processor so many times that as the column says; the time is the larger one of both. What it costs to wake threads and "
              "to wait for the last one is not in it.")
    page.table(["threads", "measured", "without a limit of memory", *(f"memory of {socket} cores" for socket in SOCKETS)],
               [[str(threads), short(seconds["lattice", 1] / seconds["lattice", threads]) if ("lattice", threads) in seconds else "-",
                 *(short(times(threads, socket)) for socket in (None, *SOCKETS))] for threads in THREADS])


def ranks_part(page, folder):
    """The simulation."""
    rows = read_rows(folder, "ranks", RANKS)
    tasks = {row["what"]: row["tasks"] for row in rows}
    seconds = {(row["what"], int(row["ranks"])): float(row["seconds"]) for row in rows}
    page.text(f"**More ranks are a simulation**, by the seconds that runs were measured to take by one rank (bench/ranks.py). A study of the pendulum "
              f"has {tasks['study']} runs, whose steps go down by halves: the finest run of a stepper takes half of all that stepper's time, so that "
              f"few ranks are enough. A sweep has {tasks['sweep']} points, each with a reference and all its runs.")
    page.table(["ranks", "study: times as fast as one", "sweep: times as fast as one"],
               [[str(ranks), *(short(seconds[what, 1] / seconds[what, ranks]) for what in ("study", "sweep"))]
                for ranks in sorted({ranks for _, ranks in seconds})])
