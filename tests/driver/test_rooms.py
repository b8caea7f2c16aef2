#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""An effect is one room: outside drivers/effects nobody in drivers/ names one, by an identifier, a key or a column.
Left out are drivers/check, which is a host with scenes of its own, and the pages about the shipped scenes among the
pictures. No room holds more files than can be overseen. Sections of docs/equations.md that the sources cite are there,
as are the files that it names. test_rooms.py ROOT VTI_RUN"""
import glob
import io
import os
import re
import sys
import tokenize

from programs import run
from tally import check, conclude

root, vti_run = map(os.path.abspath, sys.argv[1:])
listed = [line.split("\t")[0] for line in run(vti_run, "--list", "effects").stdout.splitlines()]
names = "|".join(listed)
LIBRARY = "vti_(?:bonds|bond_dashpots|rupture|contacts|walls|friction|dashpots|drag|gravity|pendulum)"
IDENTIFIER = re.compile(rf"\b(?:has_(?:{names})|EFFECT_(?:{names})|effect_(?:{names})|{names}|{LIBRARY}\w*)\b")
WORD = re.compile(rf"(?:{names})(?:[._](?!yaml)\w+)*")     # "binder", "binder.shear.form", "binder_shear"; not "pendulum.yaml"
SCENES = ("figures.py", "advice.py", "claims.py", "accuracy.py")


def named_in_c(text):
    text = re.sub(r"/\*.*?\*/", lambda match: "\n" * match.group().count("\n"), text, flags=re.S)
    for number, line in enumerate(text.splitlines(), 1):
        strings = re.findall(r'"((?:[^"\\]|\\.)*)"', line)
        rest = "" if line.lstrip().startswith("#") else re.sub(r'"(?:[^"\\]|\\.)*"', '""', line)
        yield from ((number, word) for word in strings if WORD.fullmatch(word))
        yield from ((number, word) for word in IDENTIFIER.findall(rest))


def named_in_python(text):
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.STRING and WORD.fullmatch(token.string.strip("rf\"'")):
            yield token.start[0], token.string
        if token.type == tokenize.NAME and token.string in listed:
            yield token.start[0], token.string


faulty = """struct a {int has_wall; /* has_wall */}; f("contact", "in contact", "wall.planes", "pendulum.yaml"); vti_bonds_effect(b);"""
check([word for _, word in named_in_c(faulty)] == ["contact", "wall.planes", "has_wall", "vti_bonds_effect"],
      "this test sees names of effects")
check([word for _, word in named_in_python('a["wall"]\ncontact = "contact of walls"  # wall\n')] == ['"wall"', "contact"],
      "... in Python too")

files = [path for path in glob.glob(os.path.join(root, "drivers", "**", "*.*"), recursive=True)
         if path.endswith((".c", ".h", ".py"))]
check(len(files) > 100, f"{len(files)} sources in drivers/")
for path in sorted(files):
    place = os.path.relpath(path, root)
    if place.split(os.sep)[1] in ("effects", "check") or os.path.basename(path) in SCENES:
        continue
    with open(path, encoding="utf-8") as file:
        text = file.read()
    found = list((named_in_python if path.endswith(".py") else named_in_c)(text))
    check(not found, f"{place} names no effect: {found}")

MOST = 25
for room, _, inside in (each for top in ("src", "drivers") for each in os.walk(os.path.join(root, top))):
    sources = [name for name in inside if name.endswith((".c", ".h", ".py", ".build"))]
    check(len(sources) <= MOST + 1, f"{os.path.relpath(room, root)} is one room: {len(sources)} files with its meson.build, at most {MOST + 1}")

rooms = []
for path in glob.glob(os.path.join(root, "drivers", "effects", "**", "*.c"), recursive=True):
    with open(path, encoding="utf-8") as file:
        rooms += re.findall(r"^const struct effect_kind effect_(\w+) =", file.read(), flags=re.M)
with open(os.path.join(root, "drivers", "effects", "kinds.h"), encoding="utf-8") as file:
    kinds = re.findall(r"KIND\((\w+)\)", re.search(r"#define EFFECT_KINDS\(KIND\)((?:.*\\\n)*.*)", file.read()).group(1))
check(sorted(rooms) == sorted(kinds), f"kinds.h lists the effects that have a room: {sorted(rooms)}, {sorted(kinds)}")
check(len(kinds) == len(listed), f"... and vti-run knows them: {listed}")

# Comments cite sections of docs/equations.md as "EQUATIONS 3 and 6.10", which names files in turn.
with open(os.path.join(root, "docs", "equations.md"), encoding="utf-8") as file:
    equations = file.read()
sections = set(re.findall(r"^##+ (\d+(?:\.\d+)?)", equations, flags=re.M))
cited = {}
for top in ("include", "src", "fortran", "drivers", "tests", "bench", "examples"):
    for path in glob.glob(os.path.join(root, top, "**", "*.*"), recursive=True):
        if path.endswith((".c", ".h", ".py", ".f90", ".inc")):
            with open(path, encoding="utf-8") as file:
                text = re.sub(r"\s*\n\s*[*!#]+>?\s*", " ", file.read())     # comments that go on in the next line
            for numbers in re.findall(r"EQUATIONS(?:,? (?:section )?(?:and )?\d+(?:\.\d+)?(?=[^\d.]|\.\D))+", text):
                cited.update({number: path for number in re.findall(r"\d+(?:\.\d+)?", numbers)})
check(len(cited) > 20, f"{len(cited)} sections of docs/equations.md are cited")
for number, path in sorted(cited.items()):
    check(number in sections, f"docs/equations.md has the section {number} that {os.path.relpath(path, root)} cites")
for line in re.findall(r"^In the code: (.*?)\n\n", equations + "\n\n", flags=re.M | re.S):
    folder = ""
    for name in re.findall(r"`([^`]+)`", line):
        folder = os.path.dirname(name) + "/" if "/" in name and os.path.isdir(os.path.join(root, os.path.dirname(name))) else folder
        where = name if os.path.exists(os.path.join(root, name)) else folder + os.path.basename(name)
        check(os.path.exists(os.path.join(root, where)), f"{name}, in which docs/equations.md sees a formula, is there")
conclude()
