# SPDX-License-Identifier: BSD-3-Clause
"""What a step computes:  flops.py COST.  Prints CSV: instructions and floating-point operations per body, bond or
touching pair and step of vti2. COST is build/bench/cost; callgrind counts how often each of its instructions is
executed, objdump tells which of them compute, and on how many numbers: a sum, difference, product, quotient or root is
one operation of each. Start-up is left out, as the difference of two runs. By the kernels for AVX2, the widest that
callgrind knows; others compute the same."""
import collections
import os
import re
import shutil
import subprocess
import sys
import tempfile

BODIES, STEPS = 512, 40
# what the scenes have (see cost.c), and what those have that are taken off
WHAT = {"step": ("trl", None), "bond": ("trlmas", "trl"), "touching pair": ("trlc", "trl"), "friction and dashpots": ("trlcfd", "trlc")}
COMPUTES = re.compile(r"v?(?:add|sub|mul|div|sqrt)(s|p)d$")
LANES = {"x": 2, "y": 4, "z": 8}


def run(*command):
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"flops: {' '.join(command)} ended with {done.returncode}: {done.stderr.strip()[-500:]}")
    return done.stdout


def operations(program):
    """address -> floating-point operations of the instruction there"""
    found = {}
    for line in run("objdump", "-d", "--no-show-raw-insn", program).splitlines():
        parts = re.match(r"\s*([0-9a-f]+):\s+(\S+)\s+(.*)", line)
        computes = parts and COMPUTES.match(parts[2])
        if computes:
            found[int(parts[1], 16)] = 1 if computes[1] == "s" else LANES[re.search(r"%([xyz])mm", parts[3])[1]]
    return found


def executed(program, config, steps):
    """address -> how often the program's instruction there was executed"""
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "out")
        run("valgrind", "--tool=callgrind", "--dump-instr=yes", "--compress-strings=no", "--compress-pos=no",
            f"--callgrind-out-file={out}", program, config, str(steps))
        with open(out, encoding="utf-8") as file:
            lines = file.read().splitlines()
    counts, mine, called = collections.Counter(), False, False
    for line in lines:
        if line.startswith("ob="):
            mine = os.path.realpath(line[3:]) == os.path.realpath(program)
        elif line.startswith("calls="):
            called = True  # the next line is what the callee took
        elif line.startswith("0x"):
            if mine and not called:
                address, _, count = line.split()
                counts[int(address, 16)] += int(count)
            called = False
    return counts


def per_body(program, computes, config):
    """Instructions and operations."""
    counts = executed(program, config, STEPS)
    counts.subtract(executed(program, config, 0))
    return [sum(count * of(address) for address, count in counts.items()) / (STEPS * BODIES)
            for of in (lambda address: 1, lambda address: computes.get(address, 0))]


def main():
    program = sys.argv[1]
    for tool in ("valgrind", "objdump"):
        if shutil.which(tool) is None:
            sys.exit(f"flops: {tool} is not installed; no operations are counted")
    computes = operations(program)
    found = {config: per_body(program, computes, config) for config in {config for pair in WHAT.values() for config in pair if config}}
    print("what,instructions,flops")
    for what, (config, base) in WHAT.items():
        off = found[base] if base else (0, 0)
        print(",".join([what, *(f"{all_of - less:.4g}" for all_of, less in zip(found[config], off))]))


if __name__ == "__main__":
    main()
