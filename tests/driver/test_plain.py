#!/usr/bin/env python3
"""The elementary functions of drivers/text/plain.h against mpmath: results are the nearest doubles, mirror images are
exact.

    test_plain.py PLAIN_VALUES
"""

import random
import subprocess
import sys

import mpmath

mpmath.mp.prec = 4000  # powers with whole exponents come out exactly


def asked(lines):
    """What the program gives for each line."""
    out = subprocess.run([sys.argv[1]], input="\n".join(lines) + "\n", capture_output=True, text=True, check=True).stdout
    return [float.fromhex(word) for word in out.split()]


def compare(lines, exact):
    """Every result is float(exact), which mpmath rounds to nearest; values below the normal numbers within one ulp."""
    for line, value, wanted in zip(lines, asked(lines), exact, strict=True):
        nearest = float(wanted)
        tiny = abs(nearest) < 2.0**-1022
        assert value == nearest or (tiny and abs(value - nearest) <= 2.0**-1074), f"{line}: {value!r}, not {nearest!r}"


def turns():
    """Angles of rings: all of the small ones, the paper's 80 bodies, some of large ones."""
    numbers = random.Random(11)
    cases = [(k, n) for n in (*range(1, 34), 80, 97, 1000) for k in range(n)]
    cases += [(numbers.randrange(n), n) for n in (10**5 + 3, 10**6, 2**27 - 1) for _ in range(100)]
    cases += [(-3, 7), (10, 7), (0, 1)]
    return [(numbers.choice((1.0, 2.5, 0.1, 3e300, 7e-300)), k, n) for k, n in cases]


def check_turns():
    with mpmath.workprec(400):
        for name, function in (("cos", mpmath.cospi), ("sin", mpmath.sinpi)):
            compare([f"{name} {r!r} {k} {n}" for r, k, n in turns()],
                    [r * function(2 * mpmath.mpf(k) / n) for r, k, n in turns()])
    for n in (5, 12, 80, 1001):
        cos = asked([f"cos 2.5 {k} {n}" for k in range(n)])
        sin = asked([f"sin 2.5 {k} {n}" for k in range(n)])
        assert all(cos[k] == cos[n - k] and sin[k] == -sin[n - k] for k in range(1, n))
    assert asked(["cos 2.5 20 80", "sin 2.5 20 80", "cos 2.5 40 80", "sin 2.5 40 80"]) == [0.0, 2.5, -2.5, 0.0]


def check_powers():
    numbers = random.Random(12)
    cases = [(2, -1074), (2, 1023), (10, 300), (10, -5), (3, 34), (3, 33), (0.1, 3), (1.5, -64), (7, 65), (2, 0.5), (10, -0.3),
             (1 + 2**-52, 2.0**57), (5e-324, 0.25), (1e308, 1.0)]
    cases += [(numbers.uniform(0, 20), numbers.randint(-64, 64)) for _ in range(300)]
    cases += [(10 ** numbers.uniform(-8, 8), numbers.uniform(-30, 30)) for _ in range(300)]
    compare([f"power {a!r} {b!r}" for a, b in cases], [mpmath.mpf(a) ** mpmath.mpf(b) for a, b in cases])
    special = ["power 0 0", "power 0 2", "power 1 1e300", "power 2 1e300", "power 2 -1e300", "power 0.5 1e305", "power 10 400"]
    inf = float("inf")
    assert asked(special) == [1.0, 0.0, 1.0, inf, 0.0, 0.0, inf]
    values = [numbers.uniform(0, 4) for _ in range(100)] + [10 ** numbers.uniform(-300, 300) for _ in range(100)] + [1.0, 8.0]
    with mpmath.workprec(400):
        compare([f"log2 {a!r}" for a in values], [mpmath.log(a, 2) for a in values])
        values = [numbers.uniform(-1030, 1023) for _ in range(200)] + [-3.0, 0.0, 0.5]
        compare([f"exp2 {a!r}" for a in values], [mpmath.power(2, a) for a in values])


check_turns()
check_powers()
print("plain: nearest doubles")
