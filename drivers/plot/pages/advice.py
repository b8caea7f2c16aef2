# SPDX-License-Identifier: BSD-3-Clause
"""Which stepper when: the words, with what a cost study has to say filled in. What the scenes are is told here too."""
import numpy as np

from .. import methods
from . import price_list
from .price_list import listing, power, three

# The name that a scene's begins with -> whether bodies or walls touch in it, and what it is
SCENES = {
    "pendulum": (False, "The paper's pendulum: one body on a joint, gravity, all of it rotation. The number is its end time."),
    "pair": (False, "Two bonded spheres, free in space. The forces are smooth."),
    "chain": (False, "Ten spheres bonded to a chain, free in space; all of its modes move. The forces are smooth."),
    "torus": (True, "The paper's ring of 80 bonded particles, which touches its wall at the start. A number is its end time."),
    "block": (True, "A bonded block that flies against a slanted wall."),
    "pile": (True, "Loose spheres that fall into a box: contacts and nothing else. Nothing turns, so the error is that of the "
                   "velocities."),
    "spin": (False, "One free body that spins."),
}
ERRORS = (1e-2, 1e-4, 1e-6, 1e-8)


def about(scene):
    return _known(scene)[1]


def touches(scene):
    """None of a scene that is not known here."""
    return _known(scene)[0]


def _known(scene):
    return next((known for name, known in SCENES.items() if scene == name or scene.startswith(name + "-")), (None, ""))


def write(page, cost):
    page.heading("Which stepper when")
    page.text("The cheapest of ours for each scene and error, in time; then the least time of ours and the least evaluations of "
              "ours, each as a share of the best rival's:")
    page.table(["error", *map(power, ERRORS)],
               [[scene, *(_cell(cost, scene, error) for error in ERRORS)] for scene in cost.scenes()])
    page.text(_beaten(cost))
    page.text(f"- **Smooth forces, accuracy wanted** (bonds, joints, gravity; no contacts): `srkn11` or `srkn14`, below 1e-8 "
              f"`kl8` as well. {_gain(cost, False)}")
    page.text("- **Trajectories, and forces that are dear**: `an10`, below 1e-8 `an10-mid`, and where nothing is stiff (the "
              "pendulum) `an10-fine`. They need the fewest "
              "evaluations on smooth scenes and spend more time beside the forces than the others do: the dearer a "
              "force, the more they gain (the table above has forces that are cheap). They are not symplectic: energy "
              "drifts linearly and angular momentum is kept to their order alone; over long times take the symplectic "
              "lists.")
    page.text("- **Contacts or walls, accuracy wanted**: `an4`, `an7` or `an10`. Where a contact begins or ends within a step they "
              "take off what the step misses by that, which no other method of equal steps does; so they are of order 4.5 "
              "there, and the others of 2.5. Where quiet times and touches take turns, `srkn11` with a tolerance "
              "(`srkn11-tol` in the tables).")
    page.text("- **Contacts or walls, long times or large errors**: begin with `exact` (or `vti2`): a step costs one force "
              f"evaluation, and its energy does not drift. What the best of ours gains depends on the scene. {_gain(cost, True)}")
    page.text("- **Dissipation** (damping, friction): `exact`, `vti2` or `chin4`. Their coefficients are positive; the others "
              "step backwards in time, which turns damping into pumping, and the library refuses them there.")
    page.text("- **The answer of an older code**: `vti2`. It is the quaternion update q <- normalise(q + (h/2) Omega q) of "
              "MercuryDPM and others, step by step; where velocities live at half steps, `vti3-leapfrog`.")
    page.text("- **Fast spin, large h|Omega|**: `exact`, and what is made of it (`srkn6`, `srkn11`, `srkn14`, `chin4`). "
              "`vti1` refuses h|Omega| >= 1, `vti2` lags by (h|Omega|)^2/12 of the angle; see the table of steady spin.")
    page.text("- **The paper's figures**: `vti1`, `vti2`, `vti3`.")


def _cell(cost, scene, error):
    mine, _, ratio = price_list.ratio(cost, scene, error)
    if not mine:
        return "-"
    evaluations = price_list.ratio(cost, scene, error, "force_evals")[2]
    return methods.name(mine) + (f", {three(ratio)} / {three(evaluations)}" if np.isfinite(ratio) else ", no rival")


def _gain(cost, contact):
    """How much less the best of ours takes than vti2, scene by scene, at the smallest of ERRORS that vti2 reaches, too."""
    parts = []
    for scene in (scene for scene in cost.scenes() if touches(scene) is contact and "vti2" in cost.prices[scene]):
        for error in reversed(ERRORS):
            mine, least = price_list.cheapest(cost, scene, error, ("ours",))
            ratio = price_list.price(cost.prices[scene]["vti2"], error) / least
            if np.isfinite(ratio):
                parts.append(f"{scene} to {power(error)}: {three(ratio)} ({methods.name(mine)})")
                break
    return f"The time of VTI-2 over that of the best of ours, {'; '.join(parts)}." if parts else ""


def _beaten(cost):
    """Said wherever it is so."""
    parts = []
    for scene in cost.scenes():
        lost = [(error, *price_list.ratio(cost, scene, error)) for error in price_list.errors(cost, scene)]
        lost = [(error, other) for error, mine, other, ratio in lost if ratio > price_list.TIE or (other and not mine)]
        if lost:
            parts.append(f"{scene} at " + listing(power(error) for error, _ in lost)
                         + f" ({listing(dict.fromkeys(methods.name(other) for _, other in lost))})")
    if not parts:
        return ("No rival takes less time than the best of ours at any error of the list, on any of these scenes, by more than the "
                "5 % that are a tie.")
    return f"A rival takes less time than all of ours, by more than the 5 % that are a tie, on {'; '.join(parts)}."
