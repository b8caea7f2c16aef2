# SPDX-License-Identifier: BSD-3-Clause
"""wide^3 spheres in YADE, bonded to their neighbours or free, for its own clock:
WIDE=10 STEPS=400 yade -n -x -j1 yade_step.py.  Prints for each round the share of a core that it had, and the
nanoseconds of a body's step and of a bond. So slow that all stay where they are; the collider, which looks for pairs,
has nothing to do. YADE gives the names that are not defined here."""
# ruff: noqa: F821
# pylint: disable=undefined-variable
import os
import time

wide, steps, rounds = int(os.environ["WIDE"]), int(os.environ["STEPS"]), 5
material = CohFrictMat(young=1e3, poisson=0.3, density=1, frictionAngle=0.5, normalCohesion=1e20, shearCohesion=1e20,
                       momentRotationLaw=True, etaRoll=-1, etaTwist=-1, isCohesive=True, alphaKr=1, alphaKtw=1)
O.materials.append(material)
for i in range(wide):
    for j in range(wide):
        for k in range(wide):
            O.bodies.append(sphere((i, j, k), 0.5, material=material))
for body in O.bodies:
    body.state.vel, body.state.angVel = (1e-3, 2e-3, 1e-3), (0.03, 0.02, -0.01)
O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb(aabbEnlargeFactor=1.1)], verletDist=0.05),
             InteractionLoop([Ig2_Sphere_Sphere_ScGeom6D(interactionDetectionFactor=1.1)],
                             [Ip2_CohFrictMat_CohFrictMat_CohFrictPhys(setCohesionNow=True, setCohesionOnNewContacts=True)],
                             [Law2_ScGeom6D_CohFrictPhys_CohesionMoment(always_use_moment_law=True)]),
             NewtonIntegrator(damping=0)]
O.dt = 1e-6
O.timingEnabled = True
O.run(steps, True)      # warms up
resetter, _, loop, newton = O.engines
bonds = sum(1 for pair in O.interactions if pair.isReal)
for _ in range(rounds):
    before = [engine.execTime for engine in (resetter, loop, newton)]
    cpu, wall = time.process_time(), time.monotonic()
    O.run(steps, True)
    share = (time.process_time() - cpu) / (time.monotonic() - wall)
    zero, pull, move = (engine.execTime - start for engine, start in zip((resetter, loop, newton), before))
    print(f"round {100 * share:.1f} {bonds} {(zero + move) / (steps * wide**3):.5g} {pull / (steps * bonds):.5g}", flush=True)
os._exit(0)     # YADE would wait for its prompt
