# SPDX-License-Identifier: BSD-3-Clause
"""The page of `./dev cost`:  python3 -m plot.pages.accuracy FOLDER [--into DIR].  What accuracy costs with every
method: pictures, the price list, what is claimed and whether it holds, and which stepper to take when. FOLDER is what
vti-study --cost wrote, and may hold spin/STEPPER.h5 of `vti-run scenes/spin.yaml`, first and last frame. The page
accuracy.md and its pictures go beside it, or with --into as DIR/accuracy.md and DIR/accuracy/*.png. All measured
numbers come from files."""
import os

import numpy as np

from .. import methods, style
from . import advice, claims, price_list, steady_spin, work_precision
from .cost_file import read_cost
from .page import ALONE, Page, write_page
from .price_list import power, three

NOISY = 0.1             # of a time: a spread that no quiet machine shows
PICTURES = 10           # at most on a page made for a folder of documents
MEASURES = {"attitude_error": "attitude error (rad, largest over the bodies, at the end)",
            "velocity_error": "relative velocity error at the end; no effect here changes how bodies turn"}
OF = {"attitude": "attitude (rad, largest over the bodies)", "position": "position (length, largest over the bodies)",
      "velocity": "velocity (v and Omega, relative)", "energy": "energy (relative, largest on the way)"}


def opening(page):
    page.text("Which stepper reaches an error for the least, and what one gives up for it. The first part is for whoever chooses one and "
              "takes five minutes; behind it are the tables that it is from, of every scene, stepper and rival. Made by `./dev cost`: "
              "every number is from its files, and whether a claim holds is decided from them.")


def measured_part(page, cost):
    page.heading("How it is measured")
    page.text("**ours** are the steppers of this library that are not in the paper, **paper** those that are, **rival** what "
              "people use instead, written from the literature for this comparison alone and compiled with the same flags.")
    page.text("**RK8(7) of GSL is the exception**: it is GSL's rk8pd as the distribution compiled it, with other flags. Beside it "
              "stand the same tableau and DOP853, Verner's of order 9, Adams and extrapolation methods, all compiled here on the same "
              "forces. They move (x, v, q, Omega), the quaternion by its differential equation and normalised after each step (RK8(7) "
              "adaptive: where it is read); "
              "their stage quaternions are not normalised, as in the codes, but the forces here take an attitude from what a "
              "quaternion points to. Verlet extrapolated, PEFRL and Takahashi-Imada turn by the exponential map. DOP853 makes "
              "the first steps of Adams methods; their evaluations count. Forces use the machine's vector units for all alike; the "
              "steps of ours choose among kernels for them as well, the loops of rivals beside the forces are compiled for every "
              "processor of the kind.")
    page.text("These are spheres; bodies of three moments have a page of their own, docs/inertia.md.")
    page.text("An error is the distance from a reference at the end of the run. Its price is found among runs at falling "
              "steps: the cheapest one that has it, and the next two finer ones too, interpolated to the error itself; nothing is "
              "extrapolated. Prices within 5 % of each other are a tie. Times are of the run alone, without observers, one run per "
              "core, the least of several.")
    page.text((f"The machine: {cost.machine}. " if cost.machine else "") + ALONE)
    spread = np.concatenate([ladder["seconds_spread"] for found in cost.runs.values() for ladder in found.values()])
    spread = np.median(spread[np.isfinite(spread)]) if np.any(np.isfinite(spread)) else 0.0
    page.text(f"The median of the repeated times lies {three(100 * spread)} % above the least, typically."
              + (" **The machine was not quiet: compare evaluations rather than times.**" if spread > NOISY else ""))


def scene_part(page, cost, scene, picture):
    measure = cost.measure(scene)
    page.heading(scene)
    t_end, whole = cost.ends(scene)
    page.text(f"{advice.about(scene)} The runs end at t = {t_end:g}"
              + (f"; the scene itself goes on to t = {whole:g}." if t_end < whole else "."))
    if picture:
        page.picture(picture)
    pivot = price_list.ordered(cost, scene)[1]
    if not price_list.errors(cost, scene):
        least = min(np.min(ladder[measure]) for ladder in cost.runs[scene].values())
        page.text(f"No method reaches the largest error of the list; the smallest error of all runs is {three(least)}. A "
                  "motion that is chaotic over this time cannot be followed at any price.")
        return
    page.text(f"The price of an error: time / force evaluations. Columns: {MEASURES[measure]}. Rows by the time to "
              f"{power(pivot)}; the least of each column and what ties with it are bold.")
    page.table(*price_list.table(cost, scene))
    page.text(price_list.in_words(cost, scene))
    page.text(_against_rivals(cost, scene))
    measures_part(page, cost, scene)


def _against_rivals(cost, scene):
    parts = []
    for error in price_list.errors(cost, scene):
        mine, other, ratio = price_list.ratio(cost, scene, error)
        if np.isfinite(ratio):
            evaluations = price_list.ratio(cost, scene, error, "force_evals")[2]
            parts.append(f"{three(ratio)} / {three(evaluations)} to {power(error)} ({methods.name(mine)}, {methods.name(other)})")
        elif mine or other:
            who = "a rival" if other else "ours"
            parts.append(f"only {who} reaches {power(error)} ({methods.name(mine or other)})")
    return ("The best of ours over the best rival, in time / in evaluations (the names are of the best in time): "
            + "; ".join(parts) + "." if parts else "")


def measures_part(page, cost, scene):
    """Best of ours over best rival by everything that an error can be of."""
    rows = []
    for measure in cost.by_measure[scene]:
        cells = [_ratio_cell(cost, scene, error, measure) for error in claims.GOAL_ERRORS]
        if any(cell != "-" for cell in cells):
            rows.append([OF[measure], *cells])
    if rows:
        page.text("By what the error is of: evaluations of the best of ours over those of the best rival, and their names.")
        page.table(["error of", *map(power, claims.GOAL_ERRORS)], rows)


def _ratio_cell(cost, scene, error, measure):
    mine, other, ratio = price_list.ratio(cost, scene, error, "force_evals", measure)
    if np.isfinite(ratio):
        return f"{three(ratio)} ({methods.name(mine)}, {methods.name(other)})"
    return f"only {methods.name(mine or other)}" if mine or other else "-"


def spin_part(page, folder):
    page.heading("Steady spin")
    spins = steady_spin.read_spins(folder)
    if spins:
        page.text("A free body that spins steadily, the one motion whose solution everybody knows. Over "
                  f"{price_list.count_text(spins[0].steps)} steps at h|Omega| = {spins[0].turn:.3g}, measured:")
        page.table(["stepper", "attitude off by (rad)"], [[methods.name(spin.stepper), three(spin.error)] for spin in spins])
    page.text("What one step turns by is known in closed form: asin s (VTI-1), 2 atan(s/2) (VTI-2, VTI-3), s + O(s^7) "
              "(exact), with s = h|Omega|. So a spin is off, as a share of the angle, by")
    steps = (0.01, 0.1, 0.5, 1.0, 2.0)
    page.table(["h\\|Omega\\|", *(f"{s:g}" for s in steps)],
               [[methods.name(stepper), *(_share(stepper, s) for s in steps)] for stepper in steady_spin.ANGLES])


def _share(stepper, s):
    value = steady_spin.error_per_turn(stepper, s)
    return "refused" if np.isnan(value) else "< 1e-15" if value < 1e-15 else three(value)


def orders_part(page, cost):
    page.heading("What contact leaves of the order")
    page.text("A Hertzian contact has a force that grows as the power 3/2 of the overlap: its stiffness begins with a square "
              "root, and has no derivative where two bodies touch. A method of high order needs derivatives that are not "
              "there, so every touch costs it an error of order 2.5, and so do walls; which order a scene shows depends on "
              "how much of its motion is touching. A method that controls its step goes through the touch with small ones. The "
              "AN(K) know from where and how fast a touch begins or ends what their sums miss by it, and take that off: 4.5 is "
              "left of their order, by a touch. "
              "From the prices in evaluations, over all errors reached. Evaluations of the start count, and so multistep methods "
              "show more than their order where the whole run takes few steps:")
    scenes = cost.scenes()
    kinds = cost.kinds()
    rows = [[methods.name(method), kinds[method], *(_order(cost, scene, method) for scene in scenes)]
            for method in sorted(kinds, key=lambda key: (list(methods.FAMILIES).index(kinds[key]), methods.name(key).lower()))]
    page.table(["order shown", "kind", *scenes], rows)


def _order(cost, scene, method):
    ladder = cost.prices[scene].get(method)
    order = price_list.order_shown(ladder) if ladder else np.nan
    return f"{order:.1f}" if np.isfinite(order) else "-"


def instructions_part(page, cost):
    if not cost.instructions:
        return
    page.heading("Instructions")
    page.text("Of one step with its force evaluations, counted by callgrind: they do not depend on what else the machine "
              "does.")
    scenes = sorted({scene for scene, _ in cost.instructions})
    rows = [[methods.name(method), *(price_list.count_text(cost.instructions[scene, method])
                                     if (scene, method) in cost.instructions else "-" for scene in scenes)]
            for method in sorted({method for _, method in cost.instructions}, key=methods.name)]
    page.table(["instructions per step", *scenes], rows)


def build(folder, root, into):
    """root: where the page goes; into: its pictures, relative to it; None for all pictures beside the page."""
    cost = read_cost(folder)
    page = Page(root, "What accuracy costs")
    longest = _longest_pendulum(cost)
    pictures = {}
    for count, scene in enumerate(cost.scenes()):
        if into is None or count < PICTURES - 1:
            pictures[scene] = _save(work_precision.precision(cost, scene), root, into, f"{scene}.png")
        if into is None or scene == longest:
            pictures[scene, "energy"] = _save(work_precision.energy(cost, scene), root, into, f"{scene}-energy.png")
    opening(page)
    advice.write(page, cost)
    page.part("The tables behind it")
    measured_part(page, cost)
    page.heading("What is claimed, and what is measured")
    page.table(claims.HEAD, claims.rows(cost))
    head, rows = claims.goals(cost)
    if rows:
        page.text("What the project has set itself, in force evaluations: the best of ours over the best rival of any kind.")
        page.table(head, rows)
        page.text("The same over the best of the rivals that these goals were set with: DOP853, RK8(7), Adams PECE and extrapolation. PEFRL "
                  "and Takahashi-Imada, of order 4, joined them later and need far fewer evaluations for large errors.")
        page.table(*claims.goals(cost, claims.SET_AGAINST))
        _room_part(page, cost)
    for scene in cost.scenes():
        scene_part(page, cost, scene, pictures.get(scene))
    page.heading("Energy")
    page.text("A small energy error over a long time is what symplectic methods are known for; it says little about where the "
              "bodies are.")
    page.picture(pictures[longest, "energy"])
    orders_part(page, cost)
    spin_part(page, folder)
    instructions_part(page, cost)
    path = os.path.join(root, "accuracy.md")
    style.write(page.markdown().encode("utf-8"), path)
    print(path)


def _room_part(page, cost):
    head, rows = claims.room(cost)
    if rows:
        page.text("Where 1e-2 is missed, how much room there is: a list of s evaluations is stable up to h f = 2 s at most, f the largest "
                  "frequency (the trace of its step is a polynomial of degree s in (h f)^2, and Chebyshev's is the longest that stays "
                  "within its bounds), and at large errors the best rivals are near that already.")
        page.table(head, rows)


def _longest_pendulum(cost):
    """The scene whose energy the page shows: the last pendulum, or the first scene of all."""
    return ([scene for scene in cost.scenes() if scene.startswith("pendulum")] or cost.scenes()[:1])[-1]


def _save(figure, root, into, name):
    path = os.path.join(into, name) if into else name
    style.save(figure, os.path.join(root, path))
    print(os.path.join(root, path))
    return path


def main():
    write_page("accuracy", "what vti-study --cost wrote", build)


if __name__ == "__main__":
    main()
