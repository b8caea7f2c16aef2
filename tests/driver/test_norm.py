#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The study's reference solution against one of 20 digits that shares nothing with it: the pendulum by Taylor series in
mpmath, and ||q||^2 = int_0^10 theta^2 + |Omega|^2 dt, theta in [0, pi], split where the body passes a half turn (t =
9.55386...), at
which the integrand has a kink.      test_norm.py VTI_STUDY MPIRUN"""
import os
import sys
import tempfile

import h5py
import mpmath
from mpmath import mpf

from programs import run

mpmath.mp.dps = 20
TERMS, STEPS, T_END = 24, 80, mpf(10)


def product(a, b, n):
    """Coefficient n of the product of two series."""
    return mpmath.fsum(a[k] * b[n - k] for k in range(n + 1))


def taylor(state):
    """Series of q' = (1/2) Omega q, Omega' = (R e3) x e3 from state = (qx, qy, qz, qw, wx, wy, wz); all products are of
    two."""
    series = [[value] for value in state]
    for n in range(TERMS):
        x, y, z, w, a, b, c = series

        def p(u, v):
            return product(u, v, n)
        rates = [(p(w, a) + p(b, z) - p(c, y)) / 2, (p(w, b) + p(c, x) - p(a, z)) / 2, (p(w, c) + p(a, y) - p(b, x)) / 2,
                 -(p(a, x) + p(b, y) + p(c, z)) / 2, 2 * (p(y, z) - p(w, x)), -2 * (p(x, z) + p(w, y)), mpf(0)]
        for one, rate in zip(series, rates):
            one.append(rate / (n + 1))
    return series


def at(series, t):
    return [mpmath.polyval(one[::-1], t) for one in series]


def density(state):
    x, y, z, w, a, b, c = state
    theta = 2 * mpmath.atan2(mpmath.sqrt(x * x + y * y + z * z), abs(w))
    return theta ** 2 + a * a + b * b + c * c


def norm_squared():
    angle = 3 * mpmath.pi / 4
    state = [mpf(0), mpmath.sin(angle / 2), mpf(0), mpmath.cos(angle / 2), mpf(1) / 5, mpf(0), mpf(1) / 5]
    step = T_END / STEPS
    total = mpf(0)
    for _ in range(STEPS):
        series = taylor(state)
        state = at(series, step)
        ends = [mpf(0), step]
        if mpmath.sign(series[3][0]) != mpmath.sign(state[3]):
            ends.insert(1, mpmath.findroot(lambda t: mpmath.polyval(series[3][::-1], t), (mpf(0), step), solver="anderson"))
        total += mpmath.quad(lambda t: density(at(series, t)), ends, maxdegree=4, method="gauss-legendre")
    return total


STUDY, MPIRUN = sys.argv[1:3]
with tempfile.TemporaryDirectory() as folder:
    done = run(MPIRUN, "-n", "1", STUDY, "--no-plot", "--h", "1/16", "--t-end", "10", "-o", folder)
    assert done.returncode == 0, done.stderr
    with h5py.File(os.path.join(folder, "study.h5")) as file:
        found = mpf(float(file.attrs["norm_squared"]))
exact = norm_squared()
# rk8pd at 1e-14 a step adds up to some 1e-13 of the state; the integrand is of size 7 over 10 units of time
tolerance = mpf(10) ** -11
print(f"||q||^2 = {mpmath.nstr(found, 16)} by the study, {mpmath.nstr(exact, 20)} by Taylor series")
sys.exit(0 if abs(found - exact) < tolerance else 1)
