# SPDX-License-Identifier: BSD-3-Clause
"""impact.in and turned.in for YADE:  TOLD=JSON yade -n -x -j1 yade_impact.py. TOLD has the material, damping and
friction, and the spheres with h and steps of an impact, or the axis and the steps of a turn by one radian. Prints what
others.py reads. YADE gives the names that are not defined here."""
# ruff: noqa: F821
# pylint: disable=undefined-variable
import json
import math
import os

told = json.loads(os.environ["TOLD"])


def begin(spheres, h):
    """spheres: x, v, omega, diameter of each."""
    material = FrictMat(young=told["young"], poisson=told["poisson"], density=told["density"], frictionAngle=math.atan(told["friction"]))
    O.materials.append(material)
    for x, v, omega, diameter in spheres:
        body = sphere(x, diameter / 2, material=material)
        body.state.vel, body.state.angVel = v, omega
        O.bodies.append(body)
    damping = {"betan": told["damping"], "betas": told["damping"]} if told["damping"] else {}
    O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=1e-3),
                 InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_MindlinPhys(**damping)],
                                 [Law2_ScGeom_MindlinPhys_Mindlin()]),
                 NewtonIntegrator(damping=0)]
    O.dt = h


def impact():
    """v and omega of each after it."""
    begin(told["spheres"], told["h"])
    O.run(told["steps"], True)
    return [[*body.state.vel, *body.state.angVel] for body in O.bodies]


def standing():
    """x and the force of the second sphere, of a step in which nothing moves: forces are of the places before a
    step."""
    for body in O.bodies:
        body.state.vel = body.state.angVel = (0, 0, 0)
    O.run(1, True)
    return [[*O.bodies[1].state.pos], [*O.forces.f(1)]]


def turned():
    """The same before the turn and after it."""
    begin([((0, 0, z), (0, 0, 0), (0, 0, 0), 0.01) for z in (0, 0.0099)], 1e-6)
    lower, upper = O.bodies
    for body in O.bodies:
        body.state.blockedDOFs = "xyzXYZ"
    upper.state.vel = (0.01, 0, 0)
    O.run(100, True)
    before = standing()
    axis, steps, start = Vector3(told["axis"]), told["steps"], Vector3(before[0])
    for k in range(steps):
        upper.state.vel = (Quaternion(axis, (k + 1) / steps) * start - upper.state.pos) / O.dt
        lower.state.angVel = upper.state.angVel = axis / (steps * O.dt)
        O.run(1, True)
    return [before, standing()]


print("found", json.dumps(turned() if "axis" in told else impact()), flush=True)
os._exit(0)     # YADE would wait for its prompt
