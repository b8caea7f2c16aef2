# SPDX-License-Identifier: BSD-3-Clause
"""What is claimed of our steppers, held against a cost study: the best of ours against the best rival, and `exact`
against every quaternion Verlet at equal time."""
import numpy as np

from .. import methods
from . import price_list
from .price_list import three

# scene, error, most that the best of ours may take of the time of the best rival, and how that is written
TARGETS = (("chain", 1e-4, 0.5, "0.5"), ("chain", 1e-6, 0.7, "0.7"),
           ("pendulum-1000", 1e-4, 1 / 3, "a third"), ("pendulum-1000", 1e-6, 1 / 3, "a third"))
# What the project has set itself, in evaluations of the best of ours over those of the best rival of any kind.
GOAL_ERRORS = (1e-2, 1e-4, 1e-6, 1e-8, 1e-10)
GOALS = {"chain": (0.75, 0.50, 0.50, 0.50, 0.45), "pair": (0.50, 0.50, 0.45, 0.40, 0.42),
         "pendulum-1000": (0.40, 0.50, 0.55, 0.45, 0.40), "block": (0.60, 0.50, 0.65, 0.95),
         "torus-2": (0.65, 0.55, 0.85, 0.75), "pile": (0.55, 0.52)}
# The goals were set before PEFRL and Takahashi-Imada were measured, against these.
SET_AGAINST = ("dop853", "dop853-adaptive", "rk8pd", "rk8pd-adaptive", "pd8", "abm6", "abm8", "abm10", "abm12", "gbs8", "gbs12",
               "verlet-x8", "verlet-x12")
FOLLOWS = 0.1           # an error below which a run has followed the motion at all
# of the rival, in rad: above, the pendulum is lost; below, rounding is compared
COMPARED = (1e-9, 1e-1)
MET = {True: "met", False: "**not met**", None: "not measured",
       "mean": "met on average, not by every run"}
HEAD = ["claim", "measured", "verdict"]


def rows(cost):
    return [_against_best(cost, *target) for target in TARGETS] + _at_equal_time(cost)


def _against_best(cost, scene, error, most, written):
    claim = f"{scene} to {price_list.power(error)}: the best of ours takes at most {written} of the best rival's time"
    if scene not in cost.prices:
        return [claim, f"no scene {scene} in this study", MET[None]]
    mine, other, found = price_list.ratio(cost, scene, error)
    if not np.isfinite(found):
        return [claim, "not reached by " + ("either" if not (mine or other) else "ours" if not mine else "a rival"), MET[None]]
    evaluations = price_list.ratio(cost, scene, error, "force_evals")[2]
    measured = (f"**{found:.3f}** ({methods.name(mine)} against {methods.name(other)}); {three(evaluations)} of the "
                "evaluations")
    return [claim, measured, MET[found <= most]]


def goals(cost, rivals=None):
    """head and rows for page.Page.table: what was wanted, what was found, by how much it was missed. rivals: the ones
    that are compared with; None: all."""
    rows = [[scene, *(_goal(cost, scene, error, wanted, rivals) for error, wanted in zip(GOAL_ERRORS, GOALS[scene])),
             *["-"] * (len(GOAL_ERRORS) - len(GOALS[scene]))] for scene in GOALS if scene in cost.prices]
    return ["evaluations to", *map(price_list.power, GOAL_ERRORS)], rows


def room(cost):
    """head and rows: where a goal of the largest error is missed, the evaluations that it asks for, and the fewest with
    which any run of any method follows the motion. Runs of too few are unstable, or see nothing of what happens."""
    rows = []
    for scene in (scene for scene in GOALS if scene in cost.prices):
        _, other, found = price_list.ratio(cost, scene, GOAL_ERRORS[0], "force_evals")
        if not found > GOALS[scene][0]:
            continue
        least, by = _fewest(cost, scene)
        wanted = GOALS[scene][0] * price_list.price(cost.prices[scene][other], GOAL_ERRORS[0], "force_evals")
        rows.append([scene, price_list.count_text(wanted), f"{price_list.count_text(least)} ({methods.name(by)})" if by else "none"])
    return ["scene", f"evaluations that {price_list.power(GOAL_ERRORS[0])} is to take", f"fewest of any run with an error below {FOLLOWS:g}"], rows


def _fewest(cost, scene):
    """Evaluations, and the method."""
    runs = [(float(evaluations), method) for method, ladder in cost.runs[scene].items()
            for evaluations, error in zip(ladder["force_evals"], ladder[cost.measure(scene)]) if 0 < error < FOLLOWS]
    return min(runs, default=(np.nan, None))


def _goal(cost, scene, error, wanted, rivals):
    mine, other, found = price_list.ratio(cost, scene, error, "force_evals", rivals=rivals)
    if not np.isfinite(found):
        return f"at most {wanted:.2f}: not reached by " + ("either" if not (mine or other) else "ours" if not mine else "a rival")
    over = 100 * (found / wanted - 1)
    verdict = "met" if over <= 0 else f"**missed** by {over:.{0 if over >= 1 else 2}f} %"
    return f"{found:.2f} ({methods.name(mine)}, {methods.name(other)}), at most {wanted:.2f}: {verdict}"


def _at_equal_time(cost):
    """One row per rival, of all pendulums together."""
    pendulums = [scene for scene in cost.runs if scene.startswith("pendulum") and "exact" in cost.runs[scene]]
    rivals = [rival for rival in methods.QUATERNION_VERLET if any(rival in cost.runs[scene] for scene in pendulums)]
    if not rivals:
        return [["pendulum: `exact` has a smaller error than each quaternion Verlet at equal time",
                 "no pendulum with these in this study", MET[None]]]
    return [_equal_time_row(rival, {scene: equal_time(cost.runs[scene]["exact"], cost.runs[scene][rival])
                                    for scene in pendulums if rival in cost.runs[scene]}) for rival in rivals]


def _equal_time_row(rival, found):
    """found: scene -> ratios of errors."""
    claim = f"pendulum: `exact` has a smaller error than {methods.name(rival)} at equal time"
    found = {scene: ratios for scene, ratios in found.items() if len(ratios)}
    if not found:
        return [claim, "their times do not overlap", MET[None]]
    means = {scene: float(np.exp(np.mean(np.log(ratios)))) for scene, ratios in found.items()}
    worst = max(float(np.max(ratios)) for ratios in found.values())
    verdict = MET[True] if worst < 1 else MET["mean"] if max(means.values()) < 1 else MET[False]
    return [claim, ", ".join(f"{scene} **{three(mean)}**" for scene, mean in means.items())
            + f" of its error (geometric means; the worst run {three(worst)})", verdict]


def equal_time(mine, other):
    """Error of mine over error of other at the times of other's runs: logarithms interpolated between the runs of
    mine."""
    order = np.argsort(mine["seconds"], kind="stable")
    times, errors = mine["seconds"][order], mine["attitude_error"][order]
    good = np.isfinite(times) & (times > 0) & (errors > 0)
    times, errors = times[good], errors[good]
    there = (other["attitude_error"] >= COMPARED[0]) & (other["attitude_error"] <= COMPARED[1])
    if not len(times):
        return np.array([])
    there &= (other["seconds"] >= times[0]) & (other["seconds"] <= times[-1])
    at = np.exp(np.interp(np.log(other["seconds"][there]), np.log(times), np.log(errors)))
    return at / other["attitude_error"][there]
