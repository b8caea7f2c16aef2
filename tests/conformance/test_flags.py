#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What docs/linking.md says of a host's own flags: they act on vti_rrv.h, whose bits -march and -O do not change where
-ffp-contract=off is given, and do change where it is not.                                      test_flags.py PROJECT"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

from tally import check, conclude

PROGRAM = """
#include <stdio.h>
#include "vti_rrv.h"
int main(void)
{
    double a[3] = {0.1, -0.7, 0.3}, b[3] = {0.01, 0.02, -0.015}, p[3] = {1.0, 2.0, -0.5}, r[3];
    for (int k = 0; k < 1000; ++k) {
        vti_rrv_compose(a, b, r);
        vti_rrv_rotate(r, p, a);
        vti_cross(a, r, b);
        for (int c = 0; c < 3; ++c) {
            p[c] = a[c];
            a[c] = r[c];
            b[c] *= 0.01;
        }
    }
    return printf("%a %a %a %a %a %a\\n", a[0], a[1], a[2], p[0], p[1], p[2]) < 0;
}
"""
project = pathlib.Path(sys.argv[1])


def bits(folder, compiler, flags):
    program = f"{folder}/host"
    subprocess.run([compiler, *flags.split(), f"-I{project}/include", f"{folder}/host.c", "-lm", "-o", program], check=True, timeout=120)
    return subprocess.run([program], check=True, capture_output=True, text=True, timeout=60).stdout


def fuses():
    """This processor multiplies and adds with one rounding, if the compiler wants it to."""
    try:
        return " fma " in pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8")
    except OSError:
        return False


with tempfile.TemporaryDirectory() as work:
    pathlib.Path(work, "host.c").write_text(PROGRAM, encoding="utf-8")
    compilers = [name for name in ("gcc", "clang") if shutil.which(name)]
    plain = {name: bits(work, name, "-O0 -ffp-contract=off") for name in compilers}
    check(len(set(plain.values())) == 1, f"the same bits by {' and '.join(compilers)}")
    for name in compilers:
        for given in ("-O3", "-O3 -march=native"):
            check(bits(work, name, given + " -ffp-contract=off") == plain[name], f"{name} {given} -ffp-contract=off: the same bits")
        if fuses():
            check(bits(work, name, "-O2 -mfma") != plain[name], f"{name} -O2 -mfma alone: other bits, as the page warns")
    if fuses() and "gcc" in compilers:
        check(bits(work, "gcc", "-std=c99 -O2 -mfma") == plain["gcc"], "gcc -std=c99 does not fuse")
conclude()
