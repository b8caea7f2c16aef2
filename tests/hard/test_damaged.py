#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checkpoints of vti-run cut at every byte, with flipped bits, and foreign, and records that are cut or have flipped bits: one
line, and the file stays as it is.      test_damaged.py VTI_RUN SCENES"""
import os
import random
import shutil
import subprocess
import sys
import tempfile

from programs import run
from tally import check, conclude

RUN, SCENES = map(os.path.abspath, sys.argv[1:3])
STEPS, MORE = 64, 60


def flips(whole, size):
    """One bit each, in the first size bytes."""
    for _ in range(MORE):
        at, bit = random.randrange(size), random.randrange(8)
        yield f"bit {bit} of byte {at}", whole[:at] + bytes([whole[at] ^ 1 << bit]) + whole[at + 1:]


def damages(whole):
    """Each a name and bytes."""
    for length in range(len(whole)):
        yield f"cut to {length}", whole[:length]
    yield from flips(whole, len(whole))
    yield "longer", whole + b"\0"
    yield "a text", b"x,y,z\n" * 1000
    yield "random", random.randbytes(len(whole))


def interrupted(folder):
    """A run that got to its end and found no place for its files; its journal stays."""
    os.makedirs(f"{folder}")
    os.mkdir(f"{folder}/out.csv.part")
    arguments = [f"{SCENES}/pendulum.yaml", "--t-end", "1", "-o", f"{folder}/out.h5"]
    result = run(RUN, *arguments)
    check(result.returncode == 1 and len(result.stderr.splitlines()) == 1 and "--resume" in result.stderr,
          f"no place for a file: {result.stderr.strip()}")
    return arguments


def refused(arguments, path, whole, spoilt, word):
    """Each of the spoilt contents of the file is refused, with this word, and stays; then the file is whole again."""
    good, count = 0, 0
    for name, data in spoilt:
        os.unlink(path)
        with open(path, "wb") as file:
            file.write(data)
        result = run(RUN, *arguments, "--resume")
        lines = result.stderr.splitlines()
        with open(path, "rb") as file:
            kept = file.read() == data
        fine = (result.returncode == 1 and len(lines) == 1 and lines[0].startswith(f"vti-run: {path}: ") and word in lines[0] and
                "delete" in lines[0] and kept and not os.path.exists(arguments[-1]))
        good, count = good + fine, count + 1
        if not fine:
            check(False, f"{path}, {name}: code {result.returncode} {result.stderr.strip()}")
    with open(path, "wb") as file:
        file.write(whole)
    check(good == count >= MORE, f"{os.path.basename(path)}: {good} of {count} damaged ones are refused and stay as they are")


def checkpoints(base):
    arguments = interrupted(f"{base}/run")
    for name in ("checkpoint", "rows", "frames"):
        path = f"{base}/run/out.run/{name}"
        with open(path, "rb") as file:
            whole = file.read()
        if name == "checkpoint":
            refused(arguments, path, whole, damages(whole), "damaged")
            continue
        counted = len(whole) * STEPS // (STEPS + 1)  # the record of the last state follows its checkpoint
        cuts = ((f"cut to {n}", whole[:n]) for n in [*range(MORE), counted - 1, *random.sample(range(counted), MORE)])
        refused(arguments, path, whole, cuts, "checkpoint counts")
        refused(arguments, path, whole, flips(whole, counted), "damaged")
    os.rmdir(f"{base}/run/out.csv.part")
    result = run(RUN, *arguments, "--resume")
    check(result.returncode == 0 and os.path.exists(f"{base}/run/out.h5"), "the whole one goes on")
    shutil.rmtree(f"{base}/run")


def busy(base):
    """Two runs into one file: the second is told that there is another, not that it may delete what is there."""
    arguments = [f"{SCENES}/torus.yaml", "--t-end", "1000", "--checkpoint", "0.02", "-o", f"{base}/two.h5"]
    with subprocess.Popen([RUN, *arguments], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
        while not os.path.exists(f"{base}/two.run/checkpoint"):
            pass
        for more in ([], ["--resume"]):
            result = run(RUN, *arguments, *more)
            check(result.returncode == 1 and len(result.stderr.splitlines()) == 1 and "another vti-run" in result.stderr and
                  "delete" not in result.stderr, f"two at once {more}: {result.stderr.strip()}")
        process.kill()
        process.wait()
    result = run(RUN, *arguments)
    check(result.returncode == 1 and "--resume" in result.stderr, f"... and of one that is dead: {result.stderr.strip()}")


random.seed(20240607)
for topic in (checkpoints, busy):
    with tempfile.TemporaryDirectory() as root:
        topic(root)
conclude()
