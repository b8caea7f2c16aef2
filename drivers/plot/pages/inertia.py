# SPDX-License-Identifier: BSD-3-Clause
"""The page of `./dev inertia`:  python3 -m plot.pages.inertia FOLDER [--into DIR].  Bodies of three moments: errors,
orders and prices of our steppers and of what others use. FOLDER holds table-SCENE and orders-SCENE, which vti-study
wrote, and cost, of vti-study --cost; the page inertia.md and its picture go beside them, or with --into as
DIR/inertia.md and DIR/inertia/prices.png."""
import csv
import os
import textwrap

import h5py
import numpy as np

from .. import methods, style, words
from ..trouble import Trouble
from .cost_file import read_cost
from .page import ALONE, Page, write_page
from .price_list import count_text, errors, in_words, power, price, table, three
from .work_precision import CAPTION, COSTS, row

SCENES = {"free-body": "free (1, 1.7, 2.3)", "slender-body": "free (1.7231, 0.0658, 1.7243)",
          "heavy-top": "heavy top (0.6, 1, 1.5)", "bonded-pair": "bonded pair (0.06, 0.1, 0.15)"}
HEIGHT, LETTERS = 9.0, 150      # LETTERS: of a line below the picture
BANDS = {"heavy-top": (*methods.SECOND_ORDER_TOPS, "exact")}    # of other scenes SECOND_ORDER_TOPS


def rows_of(folder, name):
    path = os.path.join(folder, name, "study.csv")
    try:
        with open(path, encoding="ascii", newline="") as file:
            return list(csv.DictReader(file))
    except OSError as error:
        raise Trouble(path, "is not there", "make it with ./dev inertia") from error


def attitude_errors(folder):
    """scene -> stepper -> error of the attitude at the end; and the largest change of a conserved momentum."""
    found = {scene: rows_of(folder, f"table-{scene}") for scene in SCENES}
    return tuple({scene: {row["stepper"]: float(row[column]) for row in rows} for scene, rows in found.items()}
                 for column in ("attitude_error", "momentum_error"))


def fitted(folder, scene):
    """stepper -> order of the trajectories' true error and its interval; NaN where rounding leaves none."""
    path = os.path.join(folder, f"orders-{scene}", "study.h5")
    if not os.path.isfile(path):
        raise Trouble(path, "is not there", "make it with ./dev inertia")
    with h5py.File(path) as file:
        read = {column: file["orders"][column][...] for column in ("stepper", "measure", "order", "interval")}
    return {stepper.decode(): (float(order), float(interval)) for stepper, measure, order, interval in
            zip(*read.values()) if measure == b"h1_error"}


# ---- the picture ----------------------------------------------------------------------------------------------------

def prices_figure(cost):
    figure = style.new_figure(HEIGHT)
    figure.suptitle("bodies of three moments: what accuracy costs")
    for place, scene in enumerate(cost.scenes()):
        panels = [figure.add_subplot(len(cost.scenes()), len(COSTS), len(COSTS) * place + column + 1) for column in range(len(COSTS))]
        row(panels, cost.prices[scene], "attitude", COSTS, BANDS.get(scene, methods.SECOND_ORDER_TOPS))
        for axes in panels:
            axes.set_title(" ".join([words.plain(scene), moments(scene)]).strip() + f", to t = {cost.ends(scene)[0]:g}")
    figure.supxlabel(textwrap.fill(CAPTION + " Behind the names of scenes: principal moments of inertia.", LETTERS), fontsize=8.5,
                     color=style.GREY)
    return figure


def moments(scene):
    """(1, 1.7, 2.3), as SCENES says them."""
    said = SCENES.get(scene, "")
    return said[said.find("("):] if "(" in said else ""


# ---- the page -------------------------------------------------------------------------------------------------------

def opening(page):
    page.text("Made by `./dev inertia`: every number is from its files. A body of three principal moments A, B, C "
              "is moved by its angular "
              "momentum L in space (`spin`), which a kick changes by the moment and a drift leaves as it is, to the "
              "bit; `docs/linking.md` "
              "has the views.")
    page.text("**Ours** is the drift: a turn about L in space, as a sphere's, and a list of turns about two of the body's "
              "axes. A list of three is of order 2 (`vti1`, `vti2`, `suzuki4`, `kl6`, `kl8`); one of five, each with a "
              "second turn about the same axis that corrects it, of order 4 (`exact`, `srkn6`, `chin4`); one of 21, by "
              "Blanes and Moan, of order 6 (`srkn11`, `srkn14`). A scene's key `rotor` (2, 4 or 6) gives any stepper "
              "the drift of that order. These drifts are explicit, exactly symplectic and keep L; they take no sine or "
              "cosine, and no further evaluation of forces. **Moser and "
              "Veselov's** is the discrete body that the paper's VTI-1 is for a sphere: its implicit equation is "
              "solved in closed form by "
              "the largest root of a quartic (`moser-veselov`), which agrees with Newton's method to rounding; flat "
              "bodies (C = A + B), "
              "where the closed form divides by zero, take Newton's. The paper's VTI-2 is the implicit midpoint "
              "rule there, which keeps "
              "the energy of a free body and is not symplectic. Rivals are written from the literature, turn the "
              "attitude with L kept "
              "between two half kicks, and are compiled with the same flags; SPIRAL moves Omega by Euler's "
              "equations instead, and so do Runge-Kutta's "
              "methods for any differential equation, up to Verner's of order 9 and GSL's RK8(7) with step control. "
              "Adams, Gear's and "
              "extrapolation methods know spheres only: docs/accuracy.md has those.")


def errors_part(page, found, spins):
    page.heading("Errors at one step")
    page.text("Attitude at the end, in radians. Free bodies begin with Omega = (0.3, 1.1, -0.4) along their axes, h "
              "= 0.1, t = 20; the "
              "top h = 0.05, t = 8; the pair h = 1/160, t = 4. Where forces are stiff, as in bonds, they hide the "
              "error of the "
              "rotation: a drift of high order pays in free flight and in steppers of high order.")
    steppers = list(found["free-body"])
    page.table(["method", *SCENES.values()],
               [[methods.typed(stepper), *(three(found[scene].get(stepper, np.nan)) for scene in SCENES)]
                for stepper in steppers])
    spin = spins["free-body"]
    loses = {stepper: spin[stepper] for stepper in steppers if spin[stepper] > 1e-14}
    page.text("Relative change of L of the free body, where it is above rounding: " +
              ", ".join(f"{methods.typed(stepper)} {change:.1e}" for stepper, change in loses.items()) + ".")


def orders_part(page, orders):
    page.heading("Orders")
    page.text("Of the true error (H1) at four steps, each half of the one before, with the interval of the fit. "
              "`-`: the errors are rounding.")
    steppers = list(next(iter(orders.values())))
    page.table(["method", *(SCENES[scene] for scene in orders)],
               [[methods.typed(stepper), *(_order(*orders[scene][stepper]) for scene in orders)]
                for stepper in steppers])


def _order(order, interval):
    return words.with_interval(order, interval) if np.isfinite(order) else "-"


def prices_part(page, cost, picture):
    page.heading("Prices")
    page.text("An error is that of the attitude at the end; a price is found among runs at falling steps, as on "
              "docs/accuracy.md, and "
              "times are of one run on one core, the least of several. Steppers of ours run through the library's "
              "calls, which check the "
              "bodies and choose kernels by the processor; rivals are one loop each."
              + (f" The machine: {cost.machine}." if cost.machine else "") + f" {ALONE}")
    page.picture(picture)
    page.text(against_text())
    for scene in cost.scenes():
        page.heading(f"Prices: {words.plain(scene)}")
        page.text((f"Principal moments of inertia: {moments(scene)}. " if moments(scene) else "") + "Time / force evaluations.")
        page.table(*table(cost, scene))
        page.text(in_words(cost, scene))
        page.text(against(cost, scene))


def against(cost, scene):
    """Ours and the rival that are the cheapest, at each error that both reach."""
    said = []
    for error in errors(cost, scene):
        cheapest = {}
        for kinds in (("ours", "paper"), ("rival",)):
            found = {method: price(ladder, error, "force_evals") for method, ladder in cost.prices[scene].items()
                     if ladder.kind in kinds}
            found = {method: value for method, value in found.items() if np.isfinite(value)}
            if found:
                best = min(found, key=found.get)
                cheapest[kinds[0]] = best, found[best], price(cost.prices[scene][best], error)
        if len(cheapest) == 2:
            (mine, own, time), (other, theirs, others_time) = cheapest["ours"], cheapest["rival"]
            said.append(f"{power(error)}: {methods.name(mine)} {count_text(own)} against {methods.name(other)} "
                        f"{count_text(theirs)} ({three(theirs / own)} times; in time {three(others_time / time)})")
    return "Evaluations of the cheapest of ours and the paper's against the cheapest rival: " + "; ".join(said) + "."


def build(folder, root, into):
    found, spins = attitude_errors(folder)
    orders = {scene: fitted(folder, scene) for scene in SCENES if scene != "slender-body"}
    cost = read_cost(os.path.join(folder, "cost"))
    picture = os.path.join(into or "", "prices.png")
    style.save(prices_figure(cost), os.path.join(root, picture))
    page = Page(root, "Bodies that are no spheres")
    opening(page)
    errors_part(page, found, spins)
    orders_part(page, orders)
    prices_part(page, cost, picture)
    path = os.path.join(root, "inertia.md")
    style.write(page.markdown().encode("utf-8"), path)
    print(path)


def against_text():
    """What one has to know of the prices."""
    return ("At the same order the turn alone decides: where L changes little within a step, a drift of order 4 "
            "pays at once; under a moment, at "
            "order 2, schemes that are simpler can be cheaper, and orders of 4 and more are what pays. "
            "The force of one body costs next to nothing here, so that time is that of the step itself, of which "
            "Runge-Kutta's do less for each "
            "evaluation; where forces cost more, evaluations count. Runge-Kutta keeps neither L nor the energy.")


def main():
    write_page("inertia", "what ./dev inertia measured", build)


if __name__ == "__main__":
    main()
