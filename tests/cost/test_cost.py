#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What each effect costs, in instructions counted by callgrind, that what is not named costs nothing, and that what is
refused does not count as cheap. Counts do not depend on what else the machine does. Prints the table of docs/steppers.md.
                                                             test_cost.py COST VALGRIND [PAGE]
PAGE: that page, of builds with kernels for AVX2, whose counts it has."""
import functools
import os
import re
import signal
import subprocess
import sys
import tempfile

from tally import check, conclude

COST, VALGRIND = sys.argv[1:3]
PAGE = sys.argv[3] if len(sys.argv) > 3 else None
BODIES, STEPS = 512, 40


def callgrind(config, steps):
    """Instructions of the whole program, the names of all functions that ran, and how often bodies were looked at."""
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "out")
        result = subprocess.run([VALGRIND, "--tool=callgrind", f"--callgrind-out-file={out}", COST, config, str(steps)],
                                capture_output=True, text=True, check=True)
        with open(out) as file:
            text = file.read()
    names = dict(re.findall(r"^c?fn=\((\d+)\) (\S+)", text, re.MULTILINE))
    calls = re.findall(r"^cfn=\((\d+)\).*\ncalls=(\d+)", text, re.MULTILINE)
    checks = sum(int(times) for number, times in calls if names[number] == "vti_bodies_fault")
    return int(re.search(r"Collected : (\d+)", result.stderr)[1]), set(names.values()), checks


@functools.cache
def per_body(config):
    """Instructions per body and step, start-up taken off, and the functions."""
    start, _, _ = callgrind(config, 0)
    total, names, _ = callgrind(config, STEPS)
    return (total - start) / (STEPS * BODIES), names


if subprocess.run([VALGRIND, "--tool=none", COST, "trl", "1"], capture_output=True).returncode == -signal.SIGILL:
    print("not counted: valgrind knows no instructions beyond AVX2, for which this build is")
    sys.exit(77)
base, _ = per_body("trl")
drift_x, names_x = per_body("t")
drift, _ = per_body("tr")
cost = {"position (drift)": drift_x, "attitude (drift)": drift - drift_x, "kicks and clearing of loads": base - drift}
for name, letters in {"binder: moment": "m", "binder: axial": "a", "binder: shear": "s", "binder: moment, axial": "ma",
                      "binder: moment, axial, shear": "mas", "contact (touching pair)": "c", "wall (touching)": "w",
                      "gravity": "g"}.items():
    cost[name] = per_body("trl" + letters)[0] - base
# What loses energy, beside what it acts on.
for name, base_letters, letters in (("dashpot of a touching pair: normal, tangential", "c", "cd"),
                                    ("friction of a touching pair: sliding", "c", "cf"),
                                    ("friction and dashpot together", "c", "cfd"),
                                    ("limits of a bond (rupture)", "mas", "mask"),
                                    ("dashpots of a bond: four terms", "mas", "masb"), ("drag: linear", "", "x")):
    cost[name] = per_body("trl" + letters)[0] - per_body("trl" + base_letters)[0]
pendulum, _ = per_body("rlp")
hand, _ = per_body("h")

print("\n| what | instructions per body (bond, pair) and step |\n|---|---|")
for name, value in cost.items():
    print(f"| {name} | {value:.0f} |")
print(f"| pendulum, whole step | {pendulum:.0f} |\n| the same by hand in one loop | {hand:.0f} |\n")

if PAGE is not None and "avx2" in open("/proc/cpuinfo", encoding="ascii").read():
    with open(PAGE, encoding="utf-8") as page:
        text = page.read()
    told = dict(re.findall(r"^\| ([^|]+) \| (\d+) \|$", text, re.MULTILINE))
    sentence = re.search(r"takes (\d+) instructions per pendulum;.*? takes (\d+)\.", " ".join(text.split()))
    off = {word: (number, round(value)) for word, number, value in zip(("pendulum", "by hand"), sentence.groups(), (pendulum, hand))
           if abs(int(number) - value) > 0.05 * value + 2}
    check(not off, f"what a pendulum's step takes is as told within 5 %: {off}")
    off = {name: (told.get(name), round(value)) for name, value in cost.items()
           if name not in told or abs(int(told[name]) - value) > 0.05 * value + 2}
    check(not off, f"the page's table is this one within 5 %, which compilers may differ by: {off}")

# One body: a step is three calls, each of which looks at the bodies unless they are sealed.
(sealed_start, _, _), (sealed, _, sealed_checks) = callgrind("rlp1", 0), callgrind("rlp1", STEPS)
(open_start, _, _), (open_, _, open_checks) = callgrind("rlp1u", 0), callgrind("rlp1u", STEPS)
print(f"one pendulum, whole step: {(sealed - sealed_start) / STEPS:.0f} instructions sealed, {(open_ - open_start) / STEPS:.0f} not sealed\n")
check(sealed_checks == 1, f"sealed bodies are looked at once, by the seal: {sealed_checks} times in {STEPS} steps")
check(open_checks == 3 * STEPS, f"... and others in each call: {open_checks} times")

whole, names_whole = per_body("trlmascwg")
parts = base + sum(cost[k] for k in ("binder: moment, axial, shear", "contact (touching pair)", "wall (touching)", "gravity"))
check(abs(parts / whole - 1) < 0.05, f"the sum of the parts, {parts:.0f}, explains the whole, {whole:.0f}, within 5 %")
check(pendulum < 1.10 * hand, f"a pendulum scene costs {pendulum / hand:.3f} times a hand-written loop of the same arithmetic")

packed, separate = (per_body(config)[0] for config in ("trly", "trlyz"))
check(separate < packed, f"a step of bodies in three arrays takes {separate:.1f} instructions, less than one of packed ones, {packed:.1f}, whose lanes are sorted")

_, names = per_body("trlma")
elastic = cost["contact (touching pair)"]
print("a touching pair with dashpot and friction costs "
      f"{(elastic + cost['friction and dashpot together']) / elastic:.2f} elastic ones\n")
losing = re.compile("^flow|carry|history|dashpot|friction|drag|rupture|decay|booked")
check(not any(map(losing.search, names_whole)), "a scene without dissipation calls no function of it")
shear = re.compile("objective|quartic|printed|shear")
check(not any(map(shear.search, names)), "a scene without shear calls no function of shear")
check(any(map(shear.search, names_whole)), "... and one with shear does")
rotation = re.compile("turn|rotate|moment")
_, names = per_body("tla")
check(not any(map(rotation.search, names)), "a scene in which nothing can turn calls no function of rotation")
kernels = {n.removesuffix(".cold") for n in names_whole if re.match("loads_|energy_", n)}
for refused, words in ("tlp", "an effect needs"), ("rlg", "an effect needs"), ("tlf", "an effect needs"):
    done = subprocess.run([COST, refused, "1"], capture_output=True, text=True, check=False)
    check(done.returncode == 1 and done.stdout == "" and done.stderr.startswith(f"cost: {refused}: {words}") and done.stderr.count("\n") == 1,
          f"a scene that is refused costs nothing, and says so: {done.returncode}, {done.stderr.strip()[:80]}")
check(kernels == {"loads_ALPHA_moment_axial_objective"}, f"one kernel of bonds, and no energy unless asked: {kernels}")
conclude()
