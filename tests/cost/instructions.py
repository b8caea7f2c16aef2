#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Instructions per step of every method on scenes without contacts, counted by callgrind: the difference of two runs of
different length, so that start-up is not in it. Each at one h, which matters to methods that iterate or choose their
own
steps only. Writes scene,stepper,instructions_per_step.      instructions.py STEPS FILE SCENE.yaml=H..."""
import concurrent.futures
import os
import re
import shutil
import subprocess
import sys
import tempfile

FEW, MANY = 20, 120


def count(program, scene, method, h, steps):
    """Instructions of the whole program, or None where it or valgrind fails."""
    with tempfile.TemporaryDirectory() as folder:
        result = subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/out", program, scene, method,
                                 h, str(steps)], capture_output=True, text=True, check=False)
    found = re.search(r"Collected : (\d+)", result.stderr)
    return int(found[1]) if result.returncode == 0 and found else None


def per_step(program, scene, method, h):
    few, many = (count(program, scene, method, h, steps) for steps in (FEW, MANY))
    return None if few is None or many is None else (many - few) / (MANY - FEW)


def main(program, path, *scenes):
    if shutil.which("valgrind") is None:
        sys.exit("instructions: valgrind is not installed; no instructions are counted")
    methods = subprocess.run([program], capture_output=True, text=True, check=True).stdout.split()
    tasks = [(*scene.rsplit("=", 1), method) for scene in scenes for method in methods]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        found = list(pool.map(lambda task: per_step(program, task[0], task[2], task[1]), tasks))
    if all(value is None for value in found):
        sys.exit("instructions: valgrind cannot run on this machine; no instructions are counted")
    with open(path, "w", encoding="utf-8") as file:
        file.write("scene,stepper,instructions_per_step\n")
        for (scene, _, method), value in zip(tasks, found):
            if value is not None:
                name = os.path.splitext(os.path.basename(scene))[0]
                file.write(f"{name},{method},{value:.17g}\n")


main(*sys.argv[1:])
