#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Code in the README is quoted from programs that the tests run, and its commands exist.      test_readme.py PROJECT"""
import pathlib
import re
import sys

project = pathlib.Path(sys.argv[1])
readme = (project / "README.md").read_text(encoding="utf-8")
examples = {suffix: "\n".join(p.read_text(encoding="utf-8") for p in sorted((project / "examples").glob("*" + suffix)))
            for suffix in (".c", ".f90")}
commands = (project / "dev").read_text(encoding="utf-8")
failures = 0


def check(condition, what):
    global failures
    print(("ok      " if condition else "FAILED  ") + what)
    failures += not condition


blocks = re.findall(r"^```(\w*)\n(.*?)^```$", readme, re.MULTILINE | re.DOTALL)
for language, text in blocks:
    first = text.strip().splitlines()[0]
    if language in ("c", "fortran"):
        check(text in examples[".c" if language == "c" else ".f90"], f"{language} block '{first}' is quoted from examples/")
    if language == "sh":
        for line in text.strip().splitlines():
            name = re.match(r"\./dev (\w+)", line)
            check(name is not None and re.search(rf"^{name[1]}\)$", commands, re.MULTILINE) is not None, f"'{line}' exists")
check(sum(language == "c" for language, _ in blocks) >= 2, "there is C in the README")
check(sum(language == "fortran" for language, _ in blocks) >= 1, "there is Fortran in the README")
for path in re.findall(r"`((?:scenes|examples|include|docs|drivers|src)/[\w./-]+)`", readme):
    check((project / path).exists(), f"{path} exists")
sys.exit(1 if failures else 0)
