# SPDX-License-Identifier: BSD-3-Clause
"""The first part of the page, for users: which stepper when, what it costs and what it keeps, with what a cost study
has to say filled in. What the scenes are is told here too."""
import numpy as np

from .. import methods
from . import price_list
from .price_list import listing, power, three

# The name that a scene's begins with -> whether bodies or walls touch in it, and what it is
SCENES = {
    "pendulum": (False, "The paper's pendulum: one body on a pivot, under gravity; pure rotation. The number is its end time."),
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


# In the order in which one asks: scene and wish, what to take, why
WHEN = (
    ("Something is lost: drag, dashpots, friction", "`exact`, `vti2`; for smaller errors `chin4`",
     "Their coefficients are positive. The other lists step backwards in time, which turns damping into pumping, and multistep methods "
     "take forces of positions alone: the programs refuse them."),
    ("Contacts or walls: long times, or errors of 1e-2", "`exact` or `vti2`",
     "One force evaluation a step, the largest stable step for its cost, and an energy that does not drift."),
    ("Contacts or walls: trajectories", "`an4`, `an7`, or with bonds `an9`; where quiet times and touches take turns `srkn11` with "
     "`--tolerance`", "Where a contact begins or ends within a step AN(K) takes off what the step misses by that: of order 4 or 4.5 "
     "there, where all others of equal steps are of 2.5."),
    ("Smooth forces (bonds, pivots, gravity): trajectories, forces that are dear", "`an4` to 1e-2, `an7` to 1e-3, `an9` to 1e-6, `an10-mid` "
     "below; where nothing is stiff (a pendulum) `an10-fine`", "The fewest evaluations. Apart from the forces their steps take longer than those of "
     "splitting methods, so they pay off where forces are expensive."),
    ("Smooth forces: long times, forces that are cheap", "`srkn6` to 1e-4, `srkn11` to 1e-6, `srkn14` below; below 1e-8 `kl8` as well",
     "Symplectic: energy swings and does not drift, both momenta stay to rounding, over any number of periods."),
    ("Fast spin, large h\\|Omega\\|", "`exact`, and what is made of it (`srkn6`, `srkn11`, `srkn14`, `chin4`)",
     "`vti1` refuses h\\|Omega\\| >= 1, `vti2` lags by (h\\|Omega\\|)^2/12 of the angle: see Steady spin."),
    ("To reproduce an older code", "`vti2`; where velocities live at half steps `vti3-leapfrog`",
     "`vti2` is q <- normalise(q + (h/2) Omega q) of MercuryDPM and others, step by step."),
    ("The paper's figures", "`vti1`, `vti2`, `vti3`", "They are the paper's."),
)

# Steppers, order, order that contacts leave of it, energy, angular momentum, what may be lost
KEEPS = (
    ("`vti1`, `vti2`, `exact`", "2", "2", "swings, no drift", "to rounding", "all of it"),
    ("`vti1-body`", "2", "2", "swings, no drift", "to rounding", "drag, normal dashpots; hosts only"),
    ("`vti3-leapfrog`", "2", "2", "swings, no drift", "to rounding", "all of it, at order 1"),
    ("`vti3`", "1", "1", "swings, no drift", "to rounding", "all of it"),
    ("`chin4`", "4", "2.5", "swings; symplectic to order 4 alone", "to order 4", "all of it, at order 2"),
    ("`suzuki4`, `srkn6`", "4", "2.5", "swings, no drift", "to rounding", "refused"),
    ("`srkn11`, `srkn14`, `kl6`", "6", "2.5", "swings, no drift", "to rounding", "refused"),
    ("`kl8`", "8", "2.5", "swings, no drift", "to rounding", "refused"),
    ("`srkn11` with `--tolerance`", "6", "-", "drifts", "to rounding", "refused"),
    ("`an4`", "4", "4", "**drifts in proportion to time**", "to its order", "refused"),
    ("`an7`, `an9`", "8, 9", "4.5", "**drifts in proportion to time**", "to its order", "refused"),
    ("`an10-mid`, `an10-fine`", "11", "4.5", "**drifts in proportion to time**", "to its order", "refused"),
)


def write(page, cost):
    """What a user has to know, in the order of use."""
    page.heading("Which stepper when")
    page.table(["what you have, and want", "take", "why"], [list(row) for row in WHEN])
    page.text("`vti-advise SCENE --error 1e-5` tries them on your scene and says which h, and how sure that is.")
    page.heading("What it costs")
    page.text("The scenes; a number behind a name is the time at which they end: " + " ".join(_short(cost)))
    page.text("The cheapest of ours in time; then the least time of ours and the least evaluations of ours, each as a share of the "
              "best rival's (below 1 is a gain):")
    page.table(["error", *map(power, ERRORS)],
               [[scene, *(_cell(cost, scene, error) for error in ERRORS)] for scene in cost.scenes()])
    page.text(_beaten(cost))
    gains = [_gain(cost, contact) for contact in (False, True)]
    if any(gains):
        page.text(f"The time of VTI-2 over that of the best of ours, {'; '.join(gain for gain in gains if gain)}.")
    _dearer(page, cost)
    page.heading("What it keeps, and what it does not")
    page.table(["stepper", "order", "at contacts", "energy over long times", "angular momentum", "drag, dashpots, friction"],
               [list(row) for row in KEEPS])
    page.text("All methods keep linear momentum to rounding. All but `vti3`, AN(K) and steps by a tolerance are reversible, all but "
              "`chin4`, AN(K) and steps by a tolerance symplectic. AN(K) remembers K accelerations of each body, at equal steps. "
              "In `an4` and `an9` a second free number, u, gives one order for a larger stable step. docs/linking.md has the formula, "
              "c and u of each, its largest step, and how fast its energy drifts.")


def _short(cost):
    """A sentence on each scene, those of one name in one."""
    known = {name: text.split(". ")[0].rstrip(".") for name, (_, text) in SCENES.items()
             if any(scene == name or scene.startswith(name + "-") for scene in cost.scenes())}
    return [f"**{name}**, {text[0].lower()}{text[1:]}." for name, text in known.items()]


def _dearer(page, cost):
    """What a factor of ten in accuracy costs, by some that are typical, from the dearest to the cheapest."""
    typical = ("vti2", "exact", "chin4", "srkn6", "srkn11", "srkn14", "an7", "an9")
    scenes = [scene for scene in cost.scenes() if touches(scene) is not None]
    rows = [[methods.typed(method), *(_factor(cost, scene, method) for scene in scenes)] for method in typical]
    rows = [row for row in rows if any(cell != "-" for cell in row[1:])]
    if rows:
        page.text("A factor of ten in accuracy costs so many times the time:")
        page.table(["stepper", *scenes], rows)


def _factor(cost, scene, method):
    ladder = cost.prices[scene].get(method)
    factor = price_list.factor(ladder) if ladder else np.nan
    return f"{factor:.2f}" if np.isfinite(factor) else "-"


def _cell(cost, scene, error):
    mine, _, ratio = price_list.ratio(cost, scene, error)
    if not mine:
        return "-"
    evaluations = price_list.ratio(cost, scene, error, "force_evals")[2]
    return methods.name(mine) + (f", {three(ratio)} / {three(evaluations)}" if np.isfinite(ratio) else ", no rival")


def _gain(cost, contact):
    """How much less the best of ours takes than vti2, scene by scene, at the smallest of ERRORS that vti2 reaches,
    too."""
    parts = []
    for scene in (scene for scene in cost.scenes() if touches(scene) is contact and "vti2" in cost.prices[scene]):
        for error in reversed(ERRORS):
            mine, least = price_list.cheapest(cost, scene, error, ("ours",))
            ratio = price_list.price(cost.prices[scene]["vti2"], error) / least
            if np.isfinite(ratio):
                parts.append(f"{scene} to {power(error)}: {three(ratio)} ({methods.name(mine)})")
                break
    return "; ".join(parts)


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
