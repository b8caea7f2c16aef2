#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Reference table for the Rodrigues algebra, at 50 digits, as a C header on standard output.

Nothing here is taken from the library: rotations are exponentials of rotation vectors and products of unit quaternions.
The inputs are doubles; each output is the exact value for those doubles, rounded once.
"""
from mpmath import mp, mpf, sqrt, sin, cos, atan2, matrix

mp.dps = 50
mp.prec += 2200  # squares of 1e300 and of 1e-320 in one sum

AXES = [(1, 0, 0), (0, 1, 0), (0, 0, -1), (1, 1, 0), (1, -2, 3), (-0.3, 0.2, 1e-3), (1e-9, 1, -1e-5)]
ANGLES = [1e-300, 1e-160, 1e-20, 1e-8, 1e-3, 0.1, mp.pi / 2, 2, 3, mp.pi - 1e-3, mp.pi - 1e-9, mp.pi, mp.pi + 1e-6, 4,
          5, 2 * mp.pi - 1e-3, 7, 100]
SIZES = [1e-320, 1e-310, 1e-300, 1e-160, 1e-20, 1e-8, 0.1, 1, 2, 28, 2e3, 2e9, 1e12, 1e16, 2.0**60, 1e20, 1e100, 1e154,
         1e160, 1e300]
PAIR_SIZES = [1e-300, 1e-9, 0.5, 2, 40, 1e9, 1e15, 1e17, 1e200]
VECTOR = (0.25, -3, 0.7)


def double(x):
    """The nearest double, through decimal digits so that it is rounded once and correctly."""
    return float(mp.nstr(x, 40, min_fixed=1, max_fixed=0))


def norm(v):
    return sqrt(sum(x * x for x in v))


def scaled(axis, size):
    """Doubles near size times the unit axis."""
    n = norm([mpf(x) for x in axis])
    return [double(mpf(x) * size / n) for x in axis]


def unit(q):
    n = norm(q)
    q = [x / n for x in q]
    return [-x for x in q] if q[3] < 0 else q


def from_rotvec(theta):
    theta = [mpf(x) for x in theta]
    t = norm(theta)
    return unit([x * sin(t / 2) / t for x in theta] + [cos(t / 2)])


def from_alpha(alpha):
    return unit([mpf(x) for x in alpha] + [mpf(2)])


def times(p, q):
    (a, b, c, d), (x, y, z, w) = p, q
    return [d * x + w * a + b * z - c * y, d * y + w * b + c * x - a * z, d * z + w * c + a * y - b * x,
            d * w - a * x - b * y - c * z]


def rows(q):
    x, y, z, w = q
    return matrix([[w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
                   [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
                   [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z]])


def angle(q):
    return 2 * atan2(norm(q[:3]), abs(q[3]))


def rotvec(q):
    n = norm(q[:3])
    return [x * angle(q) / n for x in q[:3]]


def conj(q):
    return [-q[0], -q[1], -q[2], q[3]]


def row(*groups):
    parts = []
    for g in groups:
        values = [double(x) for x in (g if isinstance(g, (list, tuple)) else [g])]
        text = ', '.join(v.hex() if v != 0 else '0.0' for v in values)
        parts.append('{' + text + '}' if isinstance(g, (list, tuple)) else text)
    return '    {' + ', '.join(parts) + '},'


def numbers(q):
    """quat, matrix, theta, angle, R p, R^T p"""
    R = rows(q)
    p = matrix(VECTOR)
    return [q, list(R), rotvec(q), angle(q), list(R * p), list(R.T * p)]


def main():
    fields = 'quat[4], matrix[9], theta[3], angle, rotated[3], rotated_back[3]'
    print('/* Made by rrv_reference.py; do not edit. */')
    print('static const double reference_vector[3] = {' + ', '.join(repr(float(x)) for x in VECTOR) + '};')
    print(f'static const struct rotvec_case {{\n    double input[3], {fields};\n}} rotvec_cases[] = {{')
    for a in ANGLES:
        for axis in AXES:
            theta = scaled(axis, a)
            if norm([mpf(x) for x in theta]) > 0:
                print(row(theta, *numbers(from_rotvec(theta))))
    print(f'}};\nstatic const struct alpha_case {{\n    double input[3], {fields};\n}} alpha_cases[] = {{')
    for size in SIZES:
        for axis in AXES:
            alpha = scaled(axis, size)
            print(row(alpha, *numbers(from_alpha(alpha))))
    print('};\nstatic const struct pair_case {\n    double a[3], b[3];\n'
          '    double composed[4];         /* R(b) R(a) */\n'
          '    double relative[4];         /* R(a) R(b)^T */\n'
          '    double relative_printed[4]; /* R(b) R(a)^T */\n'
          '    double distance;\n} pair_cases[] = {')
    count = 0
    for i, m in enumerate(PAIR_SIZES):
        for j, n in enumerate(PAIR_SIZES):
            for k in range(3):
                a = scaled(AXES[(i + k) % len(AXES)], m)
                b = scaled(AXES[(j + 2 * k) % len(AXES)], -n if k == 1 else n)
                p, q = from_alpha(a), from_alpha(b)
                r = times(p, conj(q))
                print(row(a, b, unit(times(q, p)), unit(r), unit(conj(r)), angle(r)))
                count += 1
    print('};')


main()
