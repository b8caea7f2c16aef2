#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""docs/robustness.md from what the hard cases print.

    table.py --write PAGE SCENES PROGRAM...
    table.py --check PAGE [SCENES PROGRAM]

Runs each program, takes its lines "robust | case | who | outcome" and puts together those who behave alike. --write
puts them into the sections of these programs, and leaves the others as they are. --check compares what a program prints
with its section of the page, or, without one, the rest of the page, and shows the difference."""
import difflib
import os
import re
import subprocess
import sys

SECTIONS = {
    "half_turns": "Attitudes at and beyond half a turn",
    "turn_limit": "Large rotations per step",
    "steady": "Very many, and very small rotations",
    "kink": "Bonded bodies turned by half a turn",
    "torsion": "Beside the stable step",
    "conserve": "Energy over a long time",
    "rounding": "Rounding, and time reversed",
    "paper_step": "The paper's torus with h = 1e-2",
    "touch": "Contacts, bonds and walls at their extremes",
    "corner": "Crowds",
    "verdict": "Whether a run can be believed",
    "nonfinite": "NaN and infinities",
    "held": "Held bodies, no bodies, subnormals",
    "extent": "Very many bodies",
    "every_status": "Status codes",
    "rivals": "The same cases for other integrators",
}

NOTES = {
    "turn_limit": "The closed form (vti1) refuses h|Omega| >= 1 and writes nothing. The others go on: Cayley steps turn by less "
                  "than asked, exact ones by what was asked until their series ends, somewhere beyond h|Omega| = 1 to 2.",
    "steady": "A silent loss is what sums in double precision do to terms below their spacing. It is the one loss that no status "
              "reports; the views alpha_low, omega_low, x_low and v_low carry what is left out and undo it. The test prints what "
              "they cost in time.",
    "torsion": "h is the given share of reach/2 times `vti_stable_step`, so each stepper is beside its own limit. The limit is "
               "that of small oscillations, 1e-6 rad; the other rows say what was seen of large ones in 20000 steps. Bounded "
               "means an energy below 1e4 times its start.",
    "nonfinite": "`vti_bodies_check_values` looks at states, masses and inertias, `vti_bonds_check` at bonds, `vti_contacts_check` at "
                 "contacts, `vti_walls_check` at walls and the bodies at them: each once, before a run. During a step walls alone are "
                 "looked at; other numbers spread to what they act on, and show in energies.",
    "held": "Mass is finite: an infinite one is refused. To hold a body, put it outside the slice that is stepped: effects act "
            "across slices. Where dashpots act on it, it has a mass and an inertia of 1e300 as well, as they change both bodies of a pair.",
    "verdict": "`vti-run` and `vti-study` end with a verdict (drivers/verdict/verdict.h): good, doubtful, bad. A run is bad if its energy "
               "grows by more than S/4, S being its largest T + U without fields, or all that was recorded as lost or as work where that is more, and that in H and in "
               "H - (h^2/8) sum(F^2/m + RM^2/J), or by 0.7 S in H alone; if a body comes by more than a diameter per step towards what it meets; or if the run "
               "breaks off. The random scenes have contacts, walls, gravity, pendulums and bonds, sizes and stiffnesses over orders "
               "of magnitude, eight steppers, 256 steps; a run with a step 16 times smaller says what the energy should be at each. The "
               "verdict errs if it is good or doubtful on a run that is off by more than ten times S/4, or bad on one that is within S/4; "
               "what lies between may be called either.",
    "rivals": "The schemes of `drivers/rivals` beside this library's steppers, in the cases that all of them can be put to. "
              "h = 0.9 and 1.1 of 2/omega is beside the limit of velocity Verlet, the same for all. Methods that choose their steps "
              "themselves are left out. Multistep methods (an4, an7, an9, an10-mid, an10-fine) start with steps back in time, which are "
              "undone (docs/steppers.md), and are stable for shorter steps only.",
}

HEAD = """# What happens in hard cases

This page is made from the output of the tests in `tests/hard` (`tests/hard/table.py`), and a test compares it with them. Each
line is a case in which an assertion stands behind the words; see `meson test -C build --suite hard` after `./dev build`. "exact" means
to rounding, by a bound that the test derives; "reported" gives the message of the status code; "finite" promises nothing but that no
NaN appears. eps is 2^-52.
"""


TAIL = """
## Programs in trouble

Not by stepper, but by program; each row is a test of the suite, and its message one line on the standard error.

| trouble | program | what happens | test |
|---|---|---|---|
| a call that changes a file fails, or the disk is full, at any moment | vti-run, vti-study, vti-study --cost | reported: the file and why; files are the old or the new ones; --resume ends with the same bytes | hard trouble |
| killed at any such call, or within a write | the same | the same bytes after --resume | hard trouble |
| SIGTERM at any such call | vti-run | ends with a checkpoint, 75, or with all files, 0; before the first step by the signal, and leaves nothing | hard trouble |
| SIGTERM, SIGINT, SIGHUP, SIGXCPU, SIGUSR1 | vti-run | a checkpoint, 75; before the first step the program ends; under nohup SIGHUP is ignored | run_resume |
| the same twice, 5 s or more apart | vti-run | ends by the signal, where steps of variable length are too short for h to end soon; an earlier checkpoint stays | run_resume |
| a complete run, a later --t-end and --resume | vti-run | the bytes of one run to that end with the same --record and --frames | run_resume |
| outputs that are inputs, links and hard links too | vti-run, vti-study | refused, --force or not | overwrite |
| outputs that are there and no results of vti | the same | refused, but with --force | overwrite |
| standard output cannot be written | vti-run, vti-study, vti-advise | reported, 1 | hard trouble |
| standard output is a pipe that nobody reads any more | vti-run, vti-study | reported, 1; the files are there | run_resume, study |
| kill -9 of any rank | vti-study | mpirun ends with a message (that of Debian 12 stays after one kill in a hundred, though all ranks are gone: PMIx 4.2.2 locks itself out at its end; end it by hand); the same bytes after --resume | hard study_resume |
| Ctrl-C, SIGTERM or SIGUSR1, to `./dev study` or to any rank | vti-study | ends with 75, by `mpirun` itself with 1 but after SIGUSR1 (that of Open MPI 5 holds our message back then where its standard error is no terminal); what is done is kept; the same bytes after --resume | study_terminal, hard study_resume |
| a reference that does not fit into memory | vti-study | is held in windows of up to --memory, which each run integrates again | study_windows |
| a scene or a table is edited while a sweep runs | vti-study | of scenes what they were at the start counts; a table that has changed or is gone ends it with a line, and what is done is kept: with the table as it was --resume goes on to the same bytes | sweep |
| one rank cannot read the scene, or has no memory | vti-study | reported, all ranks end | hard study_resume |
| two studies in one folder, two runs into one file | vti-study, vti-run | the second is refused: another vti-study is writing there | hard keep, run_resume |
| OUT.run or a journal cut at any length or changed in any bit | vti-run; vti-study | reported: damaged; or, where SQLite does not use the bit, the right bytes | hard damaged |
| --resume with another scene, option or table | the same | reported: the first line that differs, `h: 0.01 there, 0.02 here` | run_resume, hard study_resume |
| scenes, tables and --set of random bytes | all | reported: the line, the value and the remedy; no fault of memory (`./dev fuzz`) | hard fuzz scene, table, set |

What survives a kill is one SQLite file: `OUT.run` beside the output of a run, `study.journal` or `cost.journal` in the folder of a
study (and, while one works there or after it was killed, `OUT.run-journal`, which belongs to it: keep both). A run commits its rows,
frames and checkpoint every minute (`--checkpoint`), a study its results every half second, or less often where that takes long: what was
done since is done again. After a kill, and after a machine has stopped, the last commit is there. On a network file system that
holds as far as that keeps its word: two programs at once are refused if locks of fcntl work there (NFS with its lock service,
Lustre with -o flock); where there are none at all they are not noticed. Other programs can read such a file once nobody writes
(`sqlite3 OUT.run 'select bytes from identity'`).

## Compilers and machines

The bits do not depend on the compiler, the optimisation level or the width of vectors: `tests/hard/digest.txt` holds hashes of
runs by all steppers and multistep methods, with dissipation and of bodies of three moments too, and of all effects, and a test builds the core with gcc and clang at -O0, -O2 and -O3, for x86-64-v3 and -v4 and
with the kernels that are picked at run time, and compares. On aarch64 (under qemu-user) and on i386 with SSE2 they are the same; with
the x87 unit, which rounds otherwise, within 1e-11 (`./dev arch` checks all three). The elementary functions that
a C library picks by the processor's units (sin, cos, exp, log, pow) are called by nothing that moves a body and no number that is
read or written: angles, rings, powers in scenes, fits and the reference's choice of steps have their own, in plain arithmetic.
A test runs whole programs with glibc masking FMA, AVX2, AVX-512 and more (`meson test -C build 'hard masks'`) and compares every byte that
is no time. Exceptions: `vti_rrv_from_rotvec` of angles beyond 2^21, `vti-check`, which compares with tolerances, and GSL, whose
rk8pd is plain arithmetic, but compiled by the distribution. Slices stepped by threads give the bits of one thread, without a race
(`./dev sanitize`).
"""


def topic(program):
    return os.path.basename(program).replace("test_", "", 1)


def cases(program, scenes):
    """{case: {outcome: [who]}} in the order in which they were printed."""
    arguments = [scenes] if topic(program) in ("rivals", "verdict") else []
    result = subprocess.run([program, *arguments], capture_output=True, text=True, check=False)
    print(result.stdout)
    if result.returncode != 0:
        sys.exit(f"{program} failed:\n{result.stderr}")
    found = {}
    for line in result.stdout.splitlines():
        if line.startswith("robust | "):
            case, who, outcome = line[len("robust | "):].split(" | ", 2)
            found.setdefault(case, {}).setdefault(outcome, []).append(who)
    return found


def cell(text):
    return text.replace("|", "\\|")


def steppers():
    """Those of the library, as its digests name them."""
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "digest.txt"), encoding="ascii") as file:
        return [line.split()[1] for line in file if line.startswith("stepper ")]


def names(who):
    ours = steppers()
    if not set(ours) <= set(who):
        return "; ".join(who)
    return "; ".join(["all steppers"] + [w for w in who if w not in ours])


def section(program, scenes):
    name = topic(program)
    text = f"\n## {SECTIONS[name]}\n\n" + (NOTES[name] + "\n\n" if name in NOTES else "")
    text += "| case | who | what happens |\n|---|---|---|\n"
    for case, outcomes in cases(program, scenes).items():
        for k, (outcome, who) in enumerate(outcomes.items()):
            text += f"| {cell(case) if k == 0 else ''} | {cell(names(who))} | {cell(outcome)} |\n"
    return text


def kept_section(page, title):
    """As the page has it, up to the next heading."""
    found = re.search(rf"\n## {re.escape(title)}\n.*?(?=\n## |\Z)", page, re.DOTALL)
    return found[0] if found else ""


def differs(kept, made):
    sys.stdout.writelines(difflib.unified_diff(kept.splitlines(True), made.splitlines(True), "the page", "what the tests print"))
    return kept != made


def main():
    mode, path, *rest = sys.argv[1:]
    with open(path, encoding="utf-8") as file:
        page = file.read()
    if mode == "--write":
        scenes, *programs = rest
        made = {topic(program): section(program, scenes) for program in programs}
        with open(path, "w", encoding="utf-8") as file:
            file.write(HEAD + "".join(made.get(name) or kept_section(page, title) for name, title in SECTIONS.items()) + TAIL)
        return 0
    if rest:
        bad = differs(kept_section(page, SECTIONS[topic(rest[1])]), section(rest[1], rest[0]))
    else:
        bad = differs(page, HEAD + "".join(kept_section(page, title) for title in SECTIONS.values()) + TAIL)
    if bad:
        root = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
        print("\nmake it anew: tests/hard/table.py --write docs/robustness.md scenes", os.path.relpath(rest[1], root) if rest else "")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
