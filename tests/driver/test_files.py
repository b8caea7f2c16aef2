#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""docs/files.md names what the programs write, no more and no less, with its shape and its unit. Units are proved: a
scene is computed in two systems of units, and each number is as many times larger as its unit says. test_files.py DOCS
VTI_RUN VTI_STUDY MPIRUN SCENES"""
import csv
import fnmatch
import os
import re
import sys
import tempfile

import h5py
import numpy

from programs import run
from tally import check, conclude

DOCS, RUN, STUDY, MPIRUN, SCENES = map(os.path.abspath, sys.argv[1:6])
SHIPPED = ("chain", "torus-printed")
INPUTS = "Tables that a scene reads"


def system(kg, m, s):
    return {"1": 1.0, "kg": kg, "m": m, "s": s, "N": kg * m / s ** 2, "J": kg * m ** 2 / s ** 2, "kg m^2": kg * m ** 2,
            "Pa": kg / m / s ** 2}


USUAL, OTHER = system(1.0, 1.0, 1.0), system(2.0 ** 2, 2.0 ** 6, 2.0 ** -4)


def factor(unit, units):
    """Of "kg m^2/s"; None of "-"."""
    if unit == "-":
        return None
    value = 1.0
    for k, part in enumerate(unit.split("/")):
        for name, power in re.findall(r"([A-Za-z]+|1)(?:\^(\d))?", part):
            value *= units[name] ** (int(power or 1) * (-1 if k else 1))
    return value


def documented():
    """{section: {kind of table: {name: (shape, unit)}}}"""
    page, section, kind = {}, None, None
    with open(DOCS, encoding="utf-8") as file:
        for line in file:
            cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
            if line.startswith("## "):
                section, kind = page.setdefault(line[3:].strip(), {}), None
            elif cells and not cells[0].startswith("`") and "---" not in cells[0]:
                kind, has_shape = cells[0], "shape" in cells
            elif cells and "---" not in cells[0]:
                for name in re.findall(r"`([^`]+)`", cells[0]):
                    section.setdefault(kind, {})[name] = (cells[1] if has_shape else None, cells[2 if has_shape else 1])
    return page


PAGE = documented()


def rule(section, kind, name):
    """The row that a name falls under: its own, else a pattern."""
    rows = PAGE[section][kind]
    if name in rows:
        return name
    return next((row for row in rows if fnmatch.fnmatchcase(name, row.replace("NNNNNN", "[0-9]" * 6).replace("KEY", "*.*"))), None)


# ---- what the programs write
# ----------------------------------------------------------------------------------------------


def scene(base, u):
    """Four spheres with everything that a scene may have, in the units u."""
    columns = {"x": [0, 1, 1.875, 2], "y": [0, 0, 0.125, 1], "z": [0.46875, 0.625, 0.5, 0.75], "vx": [0.25, 0, -0.5, 0],
               "vy": [0, 0.125, 0, 0], "vz": [0, 0, 0, -0.25], "alpha_x": [0, 0.5, 0, 0], "alpha_y": [0, 0, 0.25, 0],
               "alpha_z": [0.5, 0, 0, 0], "omega_x": [0, 1, 0, 0], "omega_y": [0.5, 0, 0, 0.25], "omega_z": [0, 0, -1, 0],
               "mass": [1, 2, 1.5, 1], "inertia": [0.125, 0.25, 0.1875, 0.125], "diameter": [1, 1.25, 1, 1]}
    bonds = {"i": [0, 1, 2], "j": [1, 2, 3], "moment": [8, 4, 2], "axial": [64, 32, 48], "shear": [16, 32, 24]}
    breaking = {**bonds, "break_stretch": [1, 0.0625, 0.5], "break_normal": [1024] * 3, "break_shear": [512] * 3,
                "break_bending": [256] * 3, "break_torsion": [256] * 3, "break_energy": [128] * 3}
    for name, table in (("bodies", columns), ("bonds", bonds), ("breaking", breaking)):
        scaled = {}
        for column, values in table.items():
            times = factor(PAGE[INPUTS]["column"][column][1], u)
            scaled[column] = [value if times is None else value * times for value in values]
        with open(os.path.join(base, name + ".csv"), "w", encoding="ascii", newline="") as file:
            csv.writer(file).writerows([scaled, *zip(*(map(repr, values) for values in scaled.values()))])
    path = os.path.join(base, "all.yaml")
    with open(path, "w", encoding="ascii") as file:
        file.write(f"""name: all
bodies: {{table: bodies.csv}}
binder: {{table: bonds.csv}}
contact: {{stiffness: {128 * u['J']!r}, bonded: yes}}
wall: {{stiffness: {64 * u['J']!r}, planes: [[0, 0, 1, 0]]}}
gravity: [0, 0, {-u['m'] / u['s'] ** 2!r}]
h: {u['s'] / 64!r}
t_end: {u['s'] * 2!r}
""")
    return path


def pendulum(base, u):
    path = os.path.join(base, "pendulum.yaml")
    with open(path, "w", encoding="ascii") as file:
        file.write(f"""name: pendulum
bodies: {{inertia: {u['kg m^2']!r}, alpha: [0, 4, 0], omega: [{0.25 / u['s']!r}, 0, {0.25 / u['s']!r}]}}
pendulum: {{weight: {u['N']!r}, rho0: [0, 0, {u['m']!r}]}}
h: {u['s'] / 64!r}
t_end: {u['s'] * 2!r}
""")
    return path


def dissipating(base, u):
    """What the two others cannot have, as their reference solutions know forces alone."""
    path = os.path.join(base, "dissipating.yaml")
    with open(path, "w", encoding="ascii") as file:
        file.write(f"""name: dissipating
bodies: {{table: bodies.csv}}
drag: {{linear: {u['kg'] / u['s'] / 2!r}, quadratic: {u['kg'] / u['m'] / 4!r}, angular: {u['J'] * u['s'] / 8!r},
  medium: [{u['m'] / u['s'] / 2!r}, 0, 0]}}
binder: {{table: breaking.csv}}
bond_dashpot: {{zeta: 0.125, axial: {u['kg'] / u['s']!r}, shear: {u['kg'] / u['s']!r}, bending: {u['J'] * u['s'] / 32!r},
  twisting: {u['J'] * u['s'] / 16!r}}}
contact: {{stiffness: {128 * u['J']!r}, bonded: yes}}
wall: {{stiffness: {64 * u['J']!r}, planes: [[0, 0, 1, 0]], cylinders: [[1, 0, 0, 0, {u['m'] / 2!r}, {u['m'] / 2!r}, {u['m'] * 1.25!r}]],
  velocities: [[0, 0, {u['m'] / u['s'] / 8!r}], [0, {u['m'] / u['s'] / 8!r}, 0]], spins: [{0.25 / u['s']!r}, {1 / u['s']!r}]}}
friction: {{sliding: 0.5, poisson: 0.25, rolling: {u['m'] / 8!r}, rolling_stiffness: {u['J']!r}, twisting: {u['m'] / 16!r},
  twisting_stiffness: {u['J'] / 2!r}}}
dashpot: {{zeta: 0.25, normal: {u['kg'] / u['s'] / 4!r}, tangential: {u['kg'] / u['s'] / 2!r}, ratio: 0.5,
  rolling: {u['J'] * u['s'] / 16!r}, twisting: {u['J'] * u['s'] / 32!r}}}
h: {u['s'] / 64!r}
t_end: {u['s'] * 2!r}
""")
    return path


def shaped(base, u):
    """Bodies that are no spheres: clumps, and ellipsoids with bonds. Their solids are known, their references are
    not."""
    path = os.path.join(base, "clumps.yaml")
    with open(path, "w", encoding="ascii") as file:
        file.write(f"""name: clumps
bodies: {{chain: {{count: 2, spacing: {2 * u['m']!r}}}, v: [{u['m'] / u['s']!r}, 0, 0], omega: [0, {1 / u['s']!r}, 0],
  clumps: {{density: {u['kg'] / u['m'] ** 3!r}, spheres: [[0, 0, 0, {u['m']!r}], [{u['m']!r}, {u['m']!r}, 0, {u['m']!r}]]}}}}
contact: {{stiffness: {64 * u['J']!r}}}
h: {u['s'] / 64!r}
t_end: {u['s']!r}
""")
    return path


def ellipsoids(base, u):
    path = os.path.join(base, "ellipsoids.yaml")
    with open(path, "w", encoding="ascii") as file:
        file.write(f"""name: ellipsoids
bodies: {{chain: {{count: 2, spacing: {2 * u['m']!r}}}, v: [{u['m'] / u['s']!r}, 0, 0], omega: [0, {1 / u['s']!r}, 0],
  mass: {u['kg']!r}, moments: [{2 * u['kg m^2']!r}, {3 * u['kg m^2']!r}, {4 * u['kg m^2']!r}], principal: [1, 0, 0]}}
binder: {{moment: {8 * u['J']!r}, axial: {64 * u['J']!r}}}
h: {u['s'] / 64!r}
t_end: {u['s']!r}
""")
    return path


def outputs(base, u):
    """All that is written of the scenes in these units, and once of two that are shipped, where other momenta are
    conserved."""
    steps = ",".join(repr(u["s"] / n) for n in (64, 128, 256))
    made = [run(RUN, scene(base, u), "--fields", "force,moment", "--contacts", "-o", f"{base}/all.h5"),
            run(RUN, pendulum(base, u), "-o", f"{base}/pendulum.h5"),
            run(RUN, dissipating(base, u), "--fields", "lost", "--contacts", "-o", f"{base}/dissipating.h5"),
            run(RUN, shaped(base, u), "--contacts", "-o", f"{base}/clumps.h5"), run(RUN, ellipsoids(base, u), "--stepper", "srkn6", "--errors", "-o", f"{base}/ellipsoids.h5"),
            run(RUN, pendulum(base, u), "--stepper", "srkn11", "--tolerance", "1e-6", "-o", f"{base}/tolerant.h5"),
            run(RUN, pendulum(base, u), "--stepper", "exact", "--set", "control=integrating", "-o", f"{base}/controlled.h5")]
    for name in SHIPPED if u is USUAL else ():
        made.append(run(MPIRUN, "-n", "1", STUDY, f"{SCENES}/{name}.yaml", "--steppers", "vti2", "--h", "1/2048", "--t-end", "1/64",
                        "--no-plot", "-o", f"{base}/study-{name}"))
    for name in ("all", "pendulum"):
        made.append(run(MPIRUN, "-n", "1", STUDY, f"{base}/{name}.yaml", "--steppers", "vti2,exact", "--h", steps, "--no-plot",
                        "-o", f"{base}/study-{name}"))
    made.append(run(MPIRUN, "-n", "1", STUDY, "--cost", f"{base}/all.yaml", "--steppers", "vti2,rk4", "--h", steps,
                    "--repeats", "1", "-o", f"{base}/cost"))
    made.append(run(MPIRUN, "-n", "1", STUDY, f"{base}/pendulum.yaml", "--steppers", "vti2,exact", "--h", steps, "--no-plot",
                    "--sweep", f"pendulum.weight={u['N']!r},{2 * u['N']!r}",
                    "--sweep", f"bodies.inertia={u['kg m^2']!r},{2 * u['kg m^2']!r}", "-o", f"{base}/sweep"))
    failed = [result.stderr for result in made if result.returncode != 0]
    if not check(not failed, f"all is computed where kg, m, s are {u['kg']}, {u['m']}, {u['s']} {failed}"):
        conclude()


def numbers(texts):
    try:
        return numpy.array([numpy.nan if text == "" else float(text) for text in texts])
    except ValueError:
        return None


def columns_of(path):
    with open(path, encoding="ascii") as file:
        head, *rows = csv.reader(file)
    return {name: numbers([row[k] for row in rows]) for k, name in enumerate(head)}


def dump_of(path):
    with open(path, encoding="ascii") as file:
        frames = file.read().split("ITEM: ATOMS ")[1:]
    names = frames[0].splitlines()[0].split()
    rows = [line.split() for frame in frames for line in frame.split("ITEM:")[0].splitlines()[1:]]
    return {name: numbers([row[k] for row in rows]) for k, name in enumerate(names)}


def hdf5_of(path):
    """(attributes, datasets) of a file: numbers, or None for what is none."""
    found = {}

    def take(name, item):
        if isinstance(item, h5py.Dataset):
            found["/" + name] = item[...] if item.dtype.kind in "iuf" else numpy.full(item.shape, numpy.nan)

    with h5py.File(path) as file:
        file.visititems(take)
        attributes = {name: numbers([value]) if not isinstance(value, bytes) else None for name, value in file.attrs.items()}
    return attributes, found


def written(base, u):
    """[(section, kind, {name: numbers or None})] of all files in the folder; shipped scenes last."""
    found = []
    for name in ("all", "pendulum"):
        attributes, datasets = hdf5_of(f"{base}/{name}.h5")
        found += [("`OUT.csv`", "column", columns_of(f"{base}/{name}.csv")), ("`OUT.dump`", "column", dump_of(f"{base}/{name}.dump")),
                  ("`OUT.h5`", "attribute", attributes), ("`OUT.h5`", "dataset", datasets)]
        attributes, datasets = hdf5_of(f"{base}/study-{name}/study.h5")
        found += [("`study.h5`", "attribute", attributes), ("`study.h5`", "dataset", datasets)]
        found += [(f"`{file}`", "column", columns_of(f"{base}/study-{name}/{file}")) for file in ("study.csv", "timing.csv")]
    attributes, datasets = hdf5_of(f"{base}/dissipating.h5")
    found += [("`OUT.csv`", "column", columns_of(f"{base}/dissipating.csv")), ("`OUT.h5`", "dataset", datasets)]
    found += [("`OUT.csv`", "column", columns_of(f"{base}/ellipsoids.csv"))]
    for name in ("clumps", "ellipsoids"):
        found += [("`OUT.dump`", "column", dump_of(f"{base}/{name}.dump")), ("`OUT.h5`", "dataset", hdf5_of(f"{base}/{name}.h5")[1])]
    found += [("`OUT.h5`", "attribute", {key: hdf5_of(f"{base}/{name}.h5")[0][key]})
              for name, key in (("tolerant", "tolerance"), ("controlled", "control"))]
    attributes, datasets = hdf5_of(f"{base}/clumps-spheres.h5")
    found += [("`OUT-spheres.h5`", "attribute", attributes), ("`OUT-spheres.h5`", "dataset", datasets)]
    for name in ("all", "dissipating", "clumps"):
        attributes, datasets = hdf5_of(f"{base}/{name}-contacts.h5")
        found += [("`OUT-contacts.h5`", "attribute", attributes), ("`OUT-contacts.h5`", "dataset", datasets)]
    check(not os.path.exists(f"{base}/pendulum-contacts.h5"), "no file of contacts where nobody asks")
    check(not os.path.exists(f"{base}/all-spheres.h5"), "no file of spheres where there are no clumps")
    for file in ("cost.csv", "errors.csv"):
        found += [("`cost.csv` and `errors.csv`", "column", columns_of(f"{base}/cost/{file}"))]
    more = {name: values for file in ("study.csv", "timing.csv") for name, values in columns_of(f"{base}/sweep/{file}").items()
            if name not in PAGE[f"`{file}`"]["column"]}
    attributes, datasets = hdf5_of(f"{base}/sweep/study.h5")
    found += [("Sweeps", "column", more), ("Sweeps", "attribute", attributes), ("Sweeps", "dataset", datasets)]
    found += [("`prices.csv`", "column", columns_of(f"{base}/cost/prices.csv"))]
    with open(f"{base}/cost/machine.txt", encoding="utf-8") as file:
        found += [("`machine.txt`", "line", {line.split(":")[0]: None for line in file})]
    found += [("`study.h5`", "dataset", hdf5_of(f"{base}/study-{name}/study.h5")[1]) for name in SHIPPED if u is USUAL]
    return found


# ---- the page
# ---------------------------------------------------------------------------------------------------------------


def names(found):
    met = set()
    for section, kind, content in found:
        unknown = [name for name in content if rule(section, kind, name) is None]
        check(not unknown, f"{section}, {kind}s: all {len(content)} are on the page {unknown[:5]}")
        met |= {(section, kind, rule(section, kind, name)) for name in content}
    for section, tables in PAGE.items():
        for kind, rows in tables.items():
            missing = [name for name in rows if (section, kind, name) not in met]
            if section != INPUTS:
                check(not missing, f"{section}, {kind}s: all {len(rows)} on the page are written {missing}")


def shapes(found):
    for section, kind, content in found:
        if kind != "dataset":
            continue
        length = {name: len(next((v for n, v in content.items() if re.fullmatch(pattern, n)), ())) for name, pattern in (
            ("rows", "/energies/t"), ("frames", "/VTKHDF/Steps/Values"), ("bodies", "/VTKHDF/PointData/body"), ("planes", "/walls"),
            ("cylinders", "/wall_cylinders"), ("contacts", "/VTKHDF/CellData/overlap"), ("spheres", "/clumps/body" if "/clumps/body" in content else "/VTKHDF/PointData/body"),
            ("runs", "/runs/h"), ("fits", "/orders/order"), ("scenes", "/scenes/name"), ("steppers", "/steppers/name"),
            ("points", "/points/scene"), ("groups", "/ensemble/point"), ("group_fits", "/ensemble_orders/point"))}
        length["bonds"] = len(content.get("/VTKHDF/Lines/Offsets", (0,))) - 1
        wrong = []
        for name, values in content.items():
            shape, _ = PAGE[section][kind][rule(section, kind, name)]
            if shape == "*":
                continue
            times = len(content.get(os.path.dirname(name) + "/t", ()))
            expected = tuple(eval(part, {"__builtins__": {}}, {**length, "times": times}) for part in shape.split(","))
            if values.shape != expected:
                wrong.append(f"{name}: {values.shape}, not {expected}")
        check(not wrong, f"{section}: shapes of {len(content)} datasets {wrong[:3]}")


def units(one, other):
    """Each number of the other is factor(unit) times that of the one. Errors near rounding are not compared: the
    reference solution has tolerances."""
    proved = set()
    for (section, kind, content), (_, _, scaled) in zip(one, other):
        for name, values in content.items():
            row = rule(section, kind, name)
            wanted = factor(PAGE[section][kind][row][1], OTHER) if row else None
            if wanted is None or values is None:
                continue
            values, rescaled = numpy.ravel(values), numpy.ravel(scaled[name])
            usual = numpy.isfinite(values) & (abs(values) > 1e-9)
            check(values.shape == rescaled.shape and numpy.allclose(rescaled[usual], wanted * values[usual], rtol=1e-3, atol=0),
                  f"{section}: {name} is in {PAGE[section][kind][row][1]}")
            if usual.any():
                proved.add((section, kind, row))
    for section, tables in PAGE.items():
        for kind, rows in tables.items():
            idle = [name for name, (_, unit) in rows.items() if factor(unit, OTHER) not in (None, 1.0)
                    and (section, kind, name) not in proved and section != INPUTS]
            print(f"        {section}, {kind}s whose unit is not looked at: {', '.join(idle) or 'none'}")


with tempfile.TemporaryDirectory() as folder:
    parts = []
    for number, u in enumerate((USUAL, OTHER)):
        os.mkdir(f"{folder}/{number}")
        outputs(f"{folder}/{number}", u)
        parts.append(written(f"{folder}/{number}", u))
    names(parts[0])
    shapes(parts[0])
    units(*parts)
conclude()
