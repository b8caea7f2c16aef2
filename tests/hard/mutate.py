#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The mutation check: do the tests notice each of the deliberate faults of faults.txt?

    mutate.py [--list] [NUMBER...]      all faults, or those of the numbers

Copies the tree to a scratch folder, sets the core and its tests up there once (the drivers too where a fault names its
tests), and then, for each fault: puts it in, builds what the tests need, runs suite by suite until a test fails, or the
tests that the fault names (a name of several words in quotes), and takes it out. The stored digest, which any change
would break, is left out. Says which fault was caught by which test. Exits with 1 if one was not, or if a fault's text
does not occur exactly once."""
import argparse
import glob
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
SUITES = ["unit", "hard", "property", "convergence"]


def read_faults():
    faults = []
    with open(os.path.join(ROOT, "tests/hard/faults.txt"), encoding="utf-8") as file:
        for line in file:
            if line.strip() and not line.startswith("#"):
                path, old, new, *tests = (part.strip().replace("\\|", "|") for part in line.rstrip("\n").split(" | ", 3))
                faults.append((path, old, new, shlex.split(tests[0]) if tests else None))
    return faults


def run(*command, **options):
    return subprocess.run(command, capture_output=True, text=True, check=False, **options)


def copy_tree(folder):
    listed = run("git", "-C", ROOT, "ls-files", "-co", "--exclude-standard").stdout.splitlines()
    for name in listed:
        source, target = os.path.join(ROOT, name), os.path.join(folder, name)
        if os.path.isfile(source):
            os.makedirs(os.path.dirname(target), exist_ok=True)
            shutil.copy2(source, target)


def caught_by(build, tests):
    """The first test that fails, or what stopped the build, or None. tests: those to run, or None for the core's
    suites."""
    suites = [["--no-suite", "slow", "--no-suite", "bits", "--suite", suite] for suite in SUITES]
    for chosen in suites if tests is None else [[test] for test in tests]:
        tested = run("meson", "test", "-C", build, "--maxfail", "1", "--timeout-multiplier", "4", *chosen)
        if tested.returncode == 125:
            return "the compiler"
        if "No suitable tests" in tested.stdout:
            sys.exit(f"there is no test {chosen[-1]}")
        if tested.returncode != 0:
            found = re.search(r"\d+/\d+ (?:\S+:)?(\S+(?: \S+)*)\s+(?:FAIL|TIMEOUT|ERROR)", tested.stdout)
            return found[1].strip() if found else chosen[-1]
    return None


def build_for(tests):
    return "build-mutate" if tests is None else "build-mutate-drivers"


def applies(folder, fault):
    """Whether its text occurs just once."""
    with open(os.path.join(folder, fault[0]), encoding="utf-8") as file:
        return file.read().count(fault[1]) == 1


def put(text, place, build):
    """Programs in Fortran are compiled anew when a module has changed, which Meson does within a library only."""
    with open(place, "w", encoding="utf-8") as file:
        file.write(text)
    for compiled in glob.glob(f"{build}/tests/*/*.p/*.f*.o") if place.endswith(".f90") else []:
        os.remove(compiled)


def check(folder, number, fault):
    path, old, new, tests = fault
    place, build = os.path.join(folder, path), os.path.join(folder, build_for(tests))
    if not applies(folder, fault):
        print(f"{number:3} STALE   {path}: {old!r} does not occur just once", flush=True)
        return False
    with open(place, encoding="utf-8") as file:
        sound = file.read()
    put(sound.replace(old, new, 1), place, build)
    by = caught_by(build, tests)
    put(sound, place, build)
    print(f"{number:3} {'caught ' if by else 'MISSED '} {path}: {old}  ->  {new}" + (f"   by {by}" if by else ""), flush=True)
    return by is not None


def main():
    faults = read_faults()
    parser = argparse.ArgumentParser(description="Do the tests notice each of the deliberate faults of faults.txt?")
    parser.add_argument("number", nargs="*", type=int, help=f"of faults, 1 to {len(faults)} (default all)")
    parser.add_argument("--list", action="store_true", help="only say which they are, and which do not fit the sources any more")
    asked = parser.parse_args()
    for k in asked.number:
        if not 1 <= k <= len(faults):
            parser.error(f"fault {k}: there are 1 to {len(faults)}; --list shows them")
    chosen = asked.number or range(1, len(faults) + 1)
    if asked.list:
        stale = [k for k in chosen if not applies(ROOT, faults[k - 1])]
        for k in chosen:
            note = "STALE   " if k in stale else ""
            print(f"{k:3} {note}{faults[k - 1][0]}: {faults[k - 1][1]}  ->  {faults[k - 1][2]}")
        return 1 if stale else 0
    with tempfile.TemporaryDirectory(prefix="mutate-") as folder:
        copy_tree(folder)
        wanted = [faults[k - 1][3] for k in chosen]
        for drivers in {tests is not None for tests in wanted}:
            tests = sorted({test for some in wanted for test in some or []}) if drivers else None
            build = os.path.join(folder, build_for(tests))
            fortran = any(test.startswith("fortran") for test in tests or [])
            made = run("meson", "setup", build, folder, "-Ddrivers=" + ("enabled" if drivers else "disabled"),
                       "-Dfortran=" + ("enabled" if fortran else "disabled"), "-Dtests=enabled")
            if made.returncode != 0:
                sys.exit(made.stdout + made.stderr)
            by = caught_by(build, tests)
            if by is not None:
                sys.exit(f"without any fault, {by} fails")
        good = sum([check(folder, k, faults[k - 1]) for k in chosen])
    print(f"{good} of {len(chosen)} faults caught")
    return 0 if good == len(chosen) else 1


if __name__ == "__main__":
    sys.exit(main())
