#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""--version of every program, and vti-run --list: the keys that it lists are those that scenes may have, with a
sentence each. The scene that README.md shows does what it says. Scenes that are shipped are installed, tested and on
their page. test_lists.py ROOT VTI_RUN PROGRAM..."""
import csv
import os
import re
import shutil
import sys
import tempfile

from programs import run
from scenes_page import page
from tally import check, conclude

root, vti_run, *others = map(os.path.abspath, sys.argv[1:])

commit = "unknown"
if os.path.exists(os.path.join(root, ".git")) and shutil.which("git"):
    commit = run("git", "-C", root, "rev-parse", "--short=7", "HEAD").stdout.strip()
with open(os.path.join(root, "include", "vti.h"), encoding="utf-8") as file:
    version = re.search(r'VTI_VERSION_STRING "(.*)"', file.read()).group(1)
for program in (vti_run, *others):
    said = run(program, "--version")
    lines = said.stdout.splitlines()
    check(said.returncode == 0 and said.stderr == "" and lines[0] == f"{os.path.basename(program)} {version}",
          f"{lines[:1]} is the version")
    check([line.split(":")[0] for line in lines[1:]] == ["commit", "compiler", "flags", "vector units"], "... with its build")
    check("-ffp-contract=off" in lines[3] and (commit in lines[1] or "unknown" in lines[1]), f"... {lines[1]}")


plot = [sys.executable, os.path.join(root, "drivers", "vti-plot")]
for program in ([vti_run], *([other] for other in others), plot):
    for option in ("--help", "--version"):
        with open("/dev/full", "w", encoding="ascii") as full:
            said = run(*program, option, stdout=full)
        check(said.returncode in (1, 2) and said.stderr.count("\n") == 1 and "standard output: cannot be written" in said.stderr,
              f"what cannot be said of {option} is missed: {said.stderr.strip()}")


def listed(what):
    said = run(vti_run, "--list", what)
    check(said.returncode == 0 and said.stderr == "", f"--list {what}")
    rows = [line.split("\t") for line in said.stdout.splitlines()]
    check(all(len(row) == 2 and len(row[1]) > 3 for row in rows), f"... {len(rows)} rows of a name and what it is")
    return [row[0] for row in rows]


with open(os.path.join(root, "src", "vti_steppers.h"), encoding="utf-8") as file:
    steppers = re.findall(r'ROW\("([^"]+)"', file.read())
check(set(steppers) - set(listed("steppers")) == {"vti1-body"}, "the library's steppers are there, but the one for hosts only")
for page_of_all, quotes in ((os.path.join("include", "vti_step.h"), '""'), (os.path.join("docs", "steppers.md"), "``")):
    with open(os.path.join(root, page_of_all), encoding="utf-8") as file:
        text = file.read()
    unnamed = [name for name in steppers if quotes[0] + name + quotes[1] not in text]
    check(not unnamed, f"{page_of_all} names them all {unnamed}")
check(listed("effects") == ["drag", "binder", "bond_dashpot", "contact", "wall", "friction", "dashpot", "gravity", "pendulum"], "effects")
keys = listed("keys")
with open(os.path.join(root, "docs", "scenes.md"), encoding="utf-8") as file:
    check(file.read() == page(run(vti_run, "--list", "keys").stdout),
          "docs/scenes.md is what --list keys says (tests/driver/scenes_page.py makes it)")
    file.seek(0)
    cells = [len(re.findall(r"(?<!\\)\|", line)) - 1 for line in file if line.startswith("|")]
    check(set(cells) == {4}, f"... tables of four columns: no cell has a bar {set(cells)}")
sections = {key.rsplit(".", 1)[0] for key in keys if "." in key}
scene = os.path.join(root, "scenes", "torus.yaml")
for key in keys:
    refused = run(vti_run, scene, "--set", f"{key}=[!]", "-o", os.devnull + "/none.h5").stderr
    check("unknown key" not in refused and refused != "", f"{key} is known to scenes")
for section in ("", *sorted(sections)):
    refused = run(vti_run, scene, "--set", (section + "." if section else "") + "zzz=1").stderr
    known = refused.rsplit(": ", 1)[1].strip().split(", ")
    mine = [key[len(section):].lstrip(".") for key in keys if key.startswith(section + "." if section else "")]
    check(known == [key for key in mine if "." not in key], f"'{section}' holds what messages say it holds")
with open(os.path.join(root, "README.md"), encoding="utf-8") as file:
    shown = re.findall(r"^```yaml\n(.*?)^```$", file.read(), re.MULTILINE | re.DOTALL)
check(len(shown) == 1, "README.md shows a scene")
with tempfile.TemporaryDirectory() as scratch:
    with open(os.path.join(scratch, "chain.yaml"), "w", encoding="utf-8") as file:
        file.write(shown[0])
    said = run(vti_run, os.path.join(scratch, "chain.yaml"), "-o", os.path.join(scratch, "out.h5"))
    if not check(said.returncode == 0 and said.stdout.splitlines()[-1].startswith("verdict: good"), f"... that runs well: {said.stderr}"):
        conclude()
    with open(os.path.join(scratch, "out.csv"), encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    most = {name: max(float(row[name]) for row in rows) for name in ("wall", "lost_friction_sliding", "lost_dashpot_normal")}
    check(all(value > 0 for value in most.values()), f"... and in which it meets the wall, slides and loses energy: {most}")
shipped = os.listdir(os.path.join(root, "scenes"))
for page_of_all, pattern, suffixes in ((("scenes", "meson.build"), "'{}'", (".yaml", ".csv")),
                                       (("docs", "programs.md"), "`{}`", (".yaml",)),
                                       (("tests", "driver", "test_scenes.c"), '{{"{}", ', (".yaml",))):
    with open(os.path.join(root, *page_of_all), encoding="utf-8") as file:
        text = file.read()
    unnamed = [name for name in shipped if name.endswith(suffixes)
               and pattern.format(name.removesuffix(".yaml") if len(suffixes) == 1 else name) not in text]
    check(not unnamed, f"{'/'.join(page_of_all)} names the scenes that are shipped {unnamed}")
wrong = run(vti_run, "--list", "colours")
check(wrong.returncode != 0 and "steppers, effects or keys" in wrong.stderr, "anything else is refused")
conclude()
