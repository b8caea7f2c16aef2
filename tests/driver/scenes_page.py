#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""docs/scenes.md from what vti-run says of its keys: vti-run --list keys | tests/driver/scenes_page.py >
docs/scenes.md"""
import re
import sys

HEAD = """# Scenes

A scene is a YAML file: bodies, the effects that act on them, the stepper and its step. An effect without a section is not computed.
Numbers are written 0.01, 1e-3, 1/64 or 2^-6, in any consistent units: an energy is a mass times a velocity squared. A key that is marked
as needed is needed where its section is there.

This page is made of `vti-run --list keys` by `tests/driver/scenes_page.py`; a test compares them.
"""


OTHERS = {"name": "Name", "stepper": "Stepper and time", "rotor": "Stepper and time", "h": "Stepper and time",
          "tolerance": "Stepper and time", "control": "Stepper and time", "speed": "Stepper and time",
          "turning": "Stepper and time", "t_end": "Stepper and time"}


def rows(listed):
    """(key, what it is, its value, the sentence) of each line of the list."""
    for line in listed.splitlines():
        key, rest = line.split("\t")
        yield (key, *re.fullmatch(r"(.*?) \(([^()]*)\)\. (.*)", rest).groups())


def page(listed):
    parts, section = [HEAD], None
    for key, about, value, says in rows(listed):
        top = OTHERS.get(key, f"`{key.split('.')[0]}`")
        if top != section:
            section = top
            parts.append(f"\n## {top}\n\n| key | what | value | |\n|-----|------|-------|---|\n")
        # or a bar would end the cell
        cells = (cell.replace("|", "\\|") for cell in (f"`{key}`", about, value, says))
        parts.append("| " + " | ".join(cells) + " |\n")
    return "".join(parts)


if __name__ == "__main__":
    sys.stdout.write(page(sys.stdin.read()))
