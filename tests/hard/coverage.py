#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Which lines and branches of the core a build's tests have reached, by clang's counts of the source.

    coverage.py BUILD [LEAST]      exits with 1 if less than LEAST percent (98) of the lines or branches have been reached

A branch is one outcome of one condition as it is written, or of one part of it between && and ||. It counts once, and
as reached if any copy of it was: inline functions have one in each file that includes them, and macros one in each
place."""
import collections
import json
import os
import subprocess
import sys

ROOT = os.path.realpath(os.path.join(os.path.dirname(__file__), "..", ".."))
FOLDERS = tuple(os.path.join(ROOT, name) + os.sep for name in ("src", "include"))


def programs(build):
    for folder, _, names in os.walk(build):
        for path in (os.path.join(folder, name) for name in sorted(names)):
            if os.access(path, os.X_OK) and os.path.isfile(path) and not path.endswith(".so"):
                with open(path, "rb") as file:
                    if file.read(4) == b"\x7fELF":
                        yield path


def profile_of(build):
    raw = os.path.join(build, "raw")
    merged = os.path.join(build, "merged.profdata")
    subprocess.run(["llvm-profdata", "merge", "-sparse", "-o", merged]
                   + [os.path.join(raw, name) for name in os.listdir(raw)], check=True)
    return merged


def export(build, form):
    found = list(programs(build))
    objects = [word for path in found[1:] for word in ("-object", path)]
    command = ["llvm-cov", "export", "-format=" + form, "-instr-profile", os.path.join(build, "merged.profdata"), found[0]]
    made = subprocess.run(command + objects, check=False, capture_output=True, text=True)
    if made.returncode != 0:  # otherwise it only warns of programs that have not been run
        sys.exit(made.stderr)
    return made.stdout


def lines_of(build):
    """{file: {line: count}}"""
    lines = collections.defaultdict(lambda: collections.defaultdict(int))
    path = None
    for record in export(build, "lcov").splitlines():
        if record.startswith("SF:"):
            path = os.path.realpath(record[3:])
        elif record.startswith("DA:") and path.startswith(FOLDERS):
            number, count = record[3:].split(",")[:2]
            lines[path][int(number)] += int(count)
    return lines


def branches_of(build):
    """{file: {(line, column, outcome): count}}"""
    branches = collections.defaultdict(lambda: collections.defaultdict(int))
    for function in json.loads(export(build, "text"))["data"][0]["functions"]:
        for line, column, _, _, true, false, file, *_ in function["branches"]:
            path = os.path.realpath(function["filenames"][file])
            if path.startswith(FOLDERS):
                branches[path][line, column, "true"] += true
                branches[path][line, column, "false"] += false
    return branches


def share(counts):
    return 100.0 * sum(count > 0 for count in counts) / len(counts) if counts else 100.0


def main():
    build = sys.argv[1]
    least = float(sys.argv[2]) if len(sys.argv) > 2 else 98.0
    profile_of(build)
    lines, branches = lines_of(build), branches_of(build)
    print(f"{'':28}{'lines':>14}{'branches':>20}")
    for path in sorted(lines):
        line_counts, branch_counts = list(lines[path].values()), list(branches[path].values())
        print(f"{os.path.relpath(path, ROOT):28}{share(line_counts):7.1f} of {len(line_counts):<5}"
              f"{share(branch_counts):10.1f} of {len(branch_counts)}")
    for path in sorted(lines):
        with open(path, encoding="utf-8") as file:
            text = file.read().splitlines()
        for number, count in sorted(lines[path].items()):
            if count == 0:
                print(f"{os.path.relpath(path, ROOT)}:{number}: no test comes here: {text[number - 1].strip()}")
        for (number, column, outcome), count in sorted(branches[path].items()):
            if count == 0 and lines[path][number] > 0:
                print(f"{os.path.relpath(path, ROOT)}:{number}:{column}: never {outcome}: {text[number - 1][column - 1:]}")
    totals = [share([count for counts in kind.values() for count in counts.values()]) for kind in (lines, branches)]
    print(f"core: {totals[0]:.2f} % of lines, {totals[1]:.2f} % of branches")
    if min(totals) < least:
        sys.exit(f"coverage: less than {least:g} %")


if __name__ == "__main__":
    main()
