# SPDX-License-Identifier: BSD-3-Clause
"""Two spheres, or one and a plane, that meet once, in LAMMPS, LIGGGHTS, YADE and by vti-run: restitution, orders of the
velocities after oblique impacts, energy that an impact without losses brings, and ledgers."""

import math
import os

import numpy

import others
from lammps import HERE, frames, tsuji_of, vti, vti_columns, vti_frames, write_data

YOUNG, POISSON, DENSITY = 5e8, 0.25, 2500.0
DIAMETER = (0.01, 0.006)
MU = 0.5
# of LIGGGHTS and YADE, whose dashpots are as the stiffnesses' roots
RATIO = math.sqrt(2 * (1 - POISSON) / (2 - POISSON))
SPEED, GAP = 1.0, 3e-6
ZETA = 0.1
SPIN = (20.0, -30.0, 40.0)
ANGLES = (10, 45, 76)
# of LAMMPS, as the pages call them: tangential style and what stands at the end of the law
STYLES = {
    "mindlin": ("mindlin", ""),
    "mindlin_rescale/force": ("mindlin_rescale/force", ""),
    "synchronized": ("mindlin_rescale/force", "synchronized_verlet"),
}
OURS = "vti2"


def mass_of(diameter):
    return DENSITY * math.pi / 6 * diameter**3


def start(angle, plane, spin):
    """x, v, omega, diameter. The sphere that comes from above meets the other, at rest, or the plane z = 0."""
    a = math.radians(angle)
    v = [SPEED * math.sin(a), 0.0, -SPEED * math.cos(a)]
    if plane:
        return (
            numpy.array([[0, 0, DIAMETER[0] / 2 + GAP]]),
            numpy.array([v]),
            numpy.array([spin]),
            numpy.array(DIAMETER[:1]),
        )
    return (
        numpy.array([[0, 0, 0], [0, 0, sum(DIAMETER) / 2 + GAP]]),
        numpy.array([[0.0, 0, 0], v]),
        numpy.array([[0.0, 0, 0], spin]),
        numpy.array(DIAMETER),
    )


def duration(angle, plane, zeta):
    return lasting(SPEED * math.cos(math.radians(angle)), plane, zeta)


def lasting(speed, plane, zeta):
    """Until well after an impact at that normal speed: the contact of two spheres takes 2.87 (m^2/(R E^2 v))^(1/5),
    Hertz."""
    m, r = mass_of(numpy.array(DIAMETER)), numpy.array(DIAMETER) / 2
    modulus = YOUNG / (1 - POISSON**2) / 2
    mass, radius = (m[0], r[0]) if plane else (m[0] * m[1] / m.sum(), r[0] * r[1] / r.sum())
    return GAP / speed + 1.5 * (1 + 2 * zeta) * 2.87 * (mass**2 / (radius * modulus**2 * speed)) ** 0.2


def kinetic(v, omega, diameter):
    """Of all spheres of the last axis but one, together."""
    return each(v, omega, diameter).sum(axis=-1)


def each(v, omega, diameter):
    m = mass_of(diameter)
    return 0.5 * m * ((v**2).sum(axis=-1) + 0.1 * diameter**2 * (omega**2).sum(axis=-1))


class Impact:
    def __init__(self, lammps, vti_run, folder):
        self.lammps, self.vti_run, self.folder = lammps, vti_run, folder
        os.makedirs(folder, exist_ok=True)
        self.others = {kind.name: kind(folder, YOUNG, POISSON, DENSITY) for kind in others.installed()}

    def by_lammps(self, angle, plane, steps, law, every=None, spin=SPIN, zeta=ZETA):
        """Rows of the dump, one for each sphere, at every so many steps and at the end."""
        return self.lammps_from(start(angle, plane, spin), plane, duration(angle, plane, zeta), steps, law, every)

    def lammps_from(self, spheres, plane, t_end, steps, law, every=None):
        atoms, out = os.path.join(self.folder, "spheres.data"), os.path.join(self.folder, "spheres.dump")
        write_data(atoms, *spheres, numpy.full(len(spheres[0]), DENSITY))
        self.lammps.run(
            "impact.in",
            atoms=atoms,
            out=out,
            h=t_end / steps,
            steps=steps,
            every=every or steps,
            plane=int(plane),
            law=law,
        )
        return frames(out)

    def by_vti(self, angle, plane, steps, settings, every=None, spin=SPIN, zeta=ZETA, scene="impact.yaml"):
        """x, v, omega of each frame, and the columns of out.csv."""
        return self.vti_from(
            start(angle, plane, spin), plane, duration(angle, plane, zeta), steps, settings, every, scene
        )

    def vti_from(self, spheres, plane, t_end, steps, settings, every=None, scene="impact.yaml"):
        table, out = os.path.join(self.folder, "bodies.csv"), os.path.join(self.folder, "out.h5")
        with open(table, "w", encoding="ascii") as file:
            print("x,y,z,vx,vy,vz,omega_x,omega_y,omega_z,diameter,mass", file=file)
            for x, v, omega, diameter in zip(*spheres):
                print(*(repr(float(c)) for c in (*x, *v, *omega, diameter, mass_of(diameter))), sep=",", file=file)
        settings = dict(
            {"contact.young": YOUNG, "contact.poisson": POISSON, "bodies.table": os.path.abspath(table)}, **settings
        )
        if plane:  # K = k_H R^(5/2), k_H = 4/3 E/(2 (1 - nu^2)) sqrt(R): LAMMPS' planes are of the spheres' material
            settings.update(
                {
                    "wall.stiffness": 2 / 3 * YOUNG / (1 - POISSON**2) * (DIAMETER[0] / 2) ** 3,
                    "wall.planes": "[[0, 0, 1, 0]]",
                }
            )
        # half a step more, so that rounding of t_end/h takes no step away
        vti(
            self.vti_run,
            os.path.join(HERE, scene),
            out,
            dict(settings, h=t_end / steps, t_end=t_end * (1 + 0.5 / steps)),
            "--record",
            str(every or steps),
            "--frames",
            str(every or steps),
            "--threads",
            "1",
        )
        return vti_frames(out), vti_columns(out[:-3] + ".csv")


def law(style, e, mu=MU, ratio=RATIO, damping="tsuji"):
    tangential, last = STYLES.get(style, (style, ""))
    return (
        f"hertz/material {YOUNG!r} {e!r} {POISSON!r} tangential {tangential} NULL {ratio!r} {mu!r} "
        f"damping {damping} {last}"
    ).strip()


def ours(zeta=ZETA, mu=MU, ratio=RATIO, pull="yes"):
    return {
        "dashpot.zeta": zeta,
        "dashpot.ratio": ratio,
        "dashpot.pull": pull,
        "friction.sliding": mu,
        "friction.poisson": POISSON,
    }


def rebounds(impact, asked=(0.3, 0.5, 0.7, 0.9), steps=40000):
    """[what, e asked for, e that came out] of central impacts on a plane."""
    rows = []
    for e in asked:
        for damping in ("tsuji", "coeff_restitution"):
            end = impact.by_lammps(
                0, True, steps, law("mindlin", e, mu=0.0, damping=damping), spin=(0.0, 0, 0), zeta=1
            )[-1]
            rows.append((f"LAMMPS {damping}", e, end[0, 5] / SPEED))
        for pull in ("no", "yes"):
            settings = {"dashpot.restitution": e, "dashpot.pull": pull}
            v = impact.by_vti(0, True, steps, settings, spin=(0.0, 0, 0), zeta=1, scene="rebound.yaml")[0][2]
            rows.append((f"vti, pull: {pull}", e, v[-1, 0, 2] / SPEED))
    return rows


def final(impact, who, angle, plane, steps):
    """Velocities and spins after the impact, spins times the radius of the first sphere."""
    if who == OURS:
        _, _, v, omega, _ = impact.by_vti(angle, plane, steps, ours())[0]
        v, omega = v[-1], omega[-1]
    elif who in impact.others:
        h = duration(angle, plane, ZETA) / steps
        v, omega = impact.others[who].impact(start(angle, plane, SPIN), plane, ZETA, MU, h, steps)
    else:
        end = impact.by_lammps(angle, plane, steps, law(who, tsuji_of(ZETA)))[-1]
        v, omega = end[:, 3:6], end[:, 6:9]
    return numpy.concatenate([v, omega * DIAMETER[0] / 2])


STEPS = tuple(2**k for k in range(7, 14))
COARSER = tuple(2**k for k in range(3, 7))
FINER = (2**14, 2**15)  # of the others, which take more for the same error
FINEST = 2**18


def known(impact, plane):
    """fix wall/gran of LAMMPS does not take synchronized_verlet, and YADE has no plane of the spheres' material."""
    without = {"synchronized", *(name for name, code in impact.others.items() if not code.planes)} if plane else ()
    return [who for who in (*STYLES, *impact.others, OURS) if who not in without]


def orders(impact):
    """[who, plane, angle, steps, error against its own limit, distance of its limit from ours, as shares of the
    speed]"""
    rows = []
    for plane in (False, True):
        for angle in ANGLES:
            limits = {who: final(impact, who, angle, plane, FINEST) for who in known(impact, plane)}
            for who in known(impact, plane):
                apart = numpy.abs(limits[who] - limits[OURS]).max() / SPEED
                for steps in COARSER + STEPS + (FINER if who != OURS else ()):
                    error = numpy.abs(final(impact, who, angle, plane, steps) - limits[who]).max() / SPEED
                    rows.append((who, int(plane), angle, steps, error, apart))
    return rows


ELASTIC = ("mindlin", "mindlin/force", "mindlin_rescale", "mindlin_rescale/force")
CYCLES = {
    "press, shear, release, return": (("0 0 -0.03", "0.005 0 0"), ("0 0 0.03", "-0.005 0 0")),
    "shear, press, return, release": (("0.005 0 0", "0 0 -0.03"), ("-0.005 0 0", "0 0 0.03")),
}


def cycles(impact):
    """[style, cycle, work that a cycle of contact without slip and dashpots takes, as a share of what shearing
    takes]; less than 0 is energy out of nothing."""
    rows = []
    for cycle, ((first, second), (third, fourth)) in CYCLES.items():
        for style in ELASTIC:
            out = os.path.join(impact.folder, "cycle.dump")
            impact.lammps.run(
                "cycle.in",
                out=out,
                first=first,
                second=second,
                third=third,
                fourth=fourth,
                law=law(style, 0.0, mu=1e4, ratio=0.0, damping="velocity"),
            )
            x, f = (frames(out)[:, 1, k : k + 3] for k in (0, 3))
            work = -(0.5 * (f[1:] + f[:-1]) * numpy.diff(x, axis=0))
            rows.append((style, cycle, work.sum() / work[:2000, 0].sum()))
    return rows


def stored(x, diameter):
    """Elastic energy 2/5 k_H overlap^(5/2) of the pair's normal contact, in each frame."""
    radius = diameter[0] * diameter[1] / (2 * diameter.sum())
    stiffness = 4 / 3 * YOUNG / (2 * (1 - POISSON**2)) * math.sqrt(radius)
    overlap = numpy.maximum(0, diameter.sum() / 2 - numpy.linalg.norm(x[:, 1] - x[:, 0], axis=1))
    return 0.4 * stiffness * overlap**2.5, 1.5 * 0.4 / 0.6 * stiffness * overlap**1.5


def ledgers(impact):
    """[who, angle, steps, largest error of the sum of energies and what was booked, as a share of the energy]. LAMMPS
    books nothing: as its users do, the power of all loads but the elastic ones, F.v + M.omega of each dump, is summed
    up over the dumps, once as it is (times h) and once as the mean of two dumps."""
    rows = []
    for angle in ANGLES:
        for steps in STEPS:
            _, columns = impact.by_vti(angle, False, steps, ours(), every=1)
            before = columns["kinetic_translation"][0] + columns["kinetic_rotation"][0]
            rows.append((OURS, angle, steps, numpy.abs(columns["total"] - columns["total"][0]).max() / before))
            dump = impact.by_lammps(angle, False, steps, law("mindlin_rescale/force", tsuji_of(ZETA)), every=1)
            x, v, omega, f, m = (dump[:, :, k : k + 3] for k in range(0, 15, 3))
            diameter, h = numpy.array(DIAMETER), duration(angle, False, ZETA) / steps
            energy, push = stored(x, diameter)
            n = x[:, 1] - x[:, 0]
            n /= numpy.linalg.norm(n, axis=1)[:, None]
            f = f - push[:, None, None] * numpy.stack([-n, n], axis=1)
            power = ((f * v).sum(axis=2) + (m * omega).sum(axis=2)).sum(axis=1)
            held = kinetic(v, omega, diameter) + energy
            for name, work in (
                ("F.v h", numpy.concatenate([[0], numpy.cumsum(power[1:])]) * h),
                ("mean of two", numpy.concatenate([[0], numpy.cumsum(0.5 * (power[1:] + power[:-1]))]) * h),
            ):
                rows.append((name, angle, steps, numpy.abs(held - work - held[0]).max() / before))
    return rows


TURNS = (1, 4, 16, 64, 256)


def turned_by_lammps(impact, axis, steps):
    """The second sphere's way from the first, and the force on it, before the turn and after it."""
    out = os.path.join(impact.folder, "turned.dump")
    impact.lammps.run(
        "turned.in", out=out, turn=steps, axis=axis, law=law("mindlin", 0.0, mu=1e4, ratio=0.0, damping="velocity")
    )
    dump = frames(out)
    return dump[:, 1, :3] - dump[:, 0, :3], dump[:, 1, 3:6]


def turned(impact):
    """[who, axis, steps, share of its size by which the load of a stuck pair is off when both have turned by one radian
    as one body]"""
    rows = []
    for who in ("LAMMPS", *impact.others):
        for axis in ("0 0 1", "0 1 0", "1 0 0"):
            for steps in TURNS:
                if who == "LAMMPS":
                    d, force = turned_by_lammps(impact, axis, steps)
                else:
                    d, force = impact.others[who].turned(axis, steps)
                rows.append((who, axis, steps, off_by(force[0], force[1], d, axis)))
    return rows


def off_by(before, after, d, axis):
    """Of the tangential loads: the one before, turned by one radian about the axis, less the one after."""
    axis = numpy.array(axis.split(), dtype=float)
    n = d / numpy.linalg.norm(d, axis=1)[:, None]
    was, now = before - (before @ n[0]) * n[0], after - (after @ n[1]) * n[1]
    was = was * math.cos(1) + numpy.cross(axis, was) * math.sin(1) + axis * (axis @ was) * (1 - math.cos(1))
    return numpy.linalg.norm(now - was) / numpy.linalg.norm(was)
