#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What vti-run and vti-study keep, cut anywhere, with flipped bits, and foreign: it is refused in one line and stays as
it is, or
the bytes at the end are the right ones (SQLite uses not every bit of its file).      test_damaged.py VTI_RUN VTI_STUDY SCENES"""
import contextlib
import os
import random
import sqlite3
import sys
import tempfile

from programs import contents, one_line, run, run_without_place
from tally import check, conclude

RUN, STUDY, SCENES = map(os.path.abspath, sys.argv[1:4])
FLIPS, CUTS = 60, 15


def database():
    """Another's."""
    with tempfile.TemporaryDirectory() as folder:
        with contextlib.closing(sqlite3.connect(f"{folder}/other")) as other:
            other.execute("CREATE TABLE other (number)")
        with open(f"{folder}/other", "rb") as file:
            return file.read()


def damages(whole):
    """Each a name and bytes."""
    for length in [1, 15, 99, 100, *random.sample(range(len(whole)), CUTS), len(whole) - 1]:
        yield f"cut to {length}", whole[:length]
    for k in range(FLIPS):
        at, bit = random.randrange(100 if k < FLIPS // 5 else len(whole)), random.randrange(8)
        yield f"bit {bit} of byte {at}", whole[:at] + bytes([whole[at] ^ 1 << bit]) + whole[at + 1:]
    yield "a text", b"x,y,z\n" * 1000
    yield "a database", database()
    yield "random", random.randbytes(len(whole))


def damaged(base, name, blocks, command):
    """A study or run that gets to its end and finds no place for one of its files; what it has kept stays."""
    ready = run(*command, "-o", f"{base}/whole/out.h5" if "run" in name else f"{base}/whole")
    whole = contents(f"{base}/whole", ("timing.csv",))
    folder = f"{base}/kept"
    command = [*command, "-o", f"{folder}/out.h5" if "run" in name else folder]
    result = run_without_place(f"{folder}/{name}", f"{folder}/{blocks}.part", *command)
    check(ready.returncode == 0 and one_line(result, name, "--resume"), f"no place for a file: {result.stderr.strip()}")
    with open(f"{folder}/{name}", "rb") as file:
        kept = file.read()
    refused = ended = 0
    for what, spoilt in [("whole", kept), *damages(kept)]:
        for other in os.listdir(folder):
            os.unlink(f"{folder}/{other}")
        with open(f"{folder}/{name}", "wb") as file:
            file.write(spoilt)
        result = run(*command, "--resume")
        lines = result.stderr.splitlines()
        after = contents(folder, ("timing.csv",))
        if result.returncode == 0 and after == whole:
            ended += 1
        elif (result.returncode == 1 and len(lines) == 1 and f"{folder}/{name}: " in lines[0] and "delete" in lines[0] and
              (what != "a database" or "is none of vti's" in lines[0]) and
              after == {name: spoilt} and what != "whole"):
            refused += 1
        else:
            check(False, f"{name}, {what}: code {result.returncode} {result.stderr.strip()} {list(after)}")
    check(refused > CUTS + 5 and ended > 0 and refused + ended > FLIPS + CUTS,
          f"{name}: {refused} damaged ones are refused and stay as they are, {ended} end with the right bytes")


random.seed(20240607)
TOPICS = {"out.run": ("out.csv", [RUN, f"{SCENES}/pendulum.yaml", "--t-end", "1"]),
          "study.journal": ("study.csv", [STUDY, "--no-plot", f"{SCENES}/pendulum.yaml", "--t-end", "1", "--h", "1/16,1/32"])}
for topic, how in TOPICS.items():
    with tempfile.TemporaryDirectory() as root:
        damaged(root, topic, *how)
conclude()
