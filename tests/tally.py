# SPDX-License-Identifier: BSD-3-Clause
"""What the tests that are Python programs say: a line for each check, and at the end once more those that failed,
because the last lines are what a runner shows."""
import os
import sys

failures = []
MEMORY_TELLS = "ASAN_OPTIONS" not in os.environ # the sanitizer of addresses takes memory of its own


def check(condition, what):
    print(("ok      " if condition else "FAILED  ") + what, flush=True)
    if not condition:
        failures.append(what)
    return condition


def conclude():
    for what in failures:
        print("FAILED  " + what)
    print(f"{len(failures)} failures")
    sys.exit(1 if failures else 0)
