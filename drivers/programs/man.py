#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A manual page from what a program says of itself, on stdout.      man.py VERSION "WHAT IT IS" PROGRAM [ARGUMENT...]"""
import pathlib
import re
import subprocess
import sys


def roff(line):
    """A line of text that roff leaves as it is."""
    line = line.replace("\\", "\\e").replace("-", "\\-")
    return "\\&" + line if line.startswith((".", "'")) else line


def options(block):
    """Lines "  --option ARGUMENT   what it does", and what goes on below."""
    for line in block:
        head = re.match(r" {2,6}(-\S.*?)(?:  +|$)(.*)", line)
        if head:
            yield from (".TP", ".B " + roff(head[1]))
        text = head[2] if head else line.strip()
        if text:
            yield roff(text)


def page(version, what, name, text):
    usage, _, body = text.partition("\n\n")
    usage = re.sub(r"^usage:\s*", "", usage, flags=re.IGNORECASE)
    yield from (f'.TH {name.upper()} 1 "" "vti {version}" "vti"', ".SH NAME", f"{name} \\- {roff(what)}", ".SH SYNOPSIS", ".nf")
    yield from (roff(line.strip()) for line in usage.splitlines())
    yield from (".fi", ".SH DESCRIPTION")
    for block in (block.splitlines() for block in re.split(r"\n\s*\n", body)):
        yield ".PP"
        if any(re.match(" {2,6}-", line) for line in block):
            yield from options(block)
        elif any(line.startswith(" ") for line in block): # a table of names and what they are
            yield from (".nf", *(roff(line) for line in block), ".fi")
        else:
            yield from (roff(line) for line in block)


program = sys.argv[3:]
said = subprocess.run([*program, "--help"], check=True, stdout=subprocess.PIPE, encoding="utf-8").stdout
print("\n".join(page(sys.argv[1], sys.argv[2], pathlib.Path(program[-1]).name, said.strip())))
