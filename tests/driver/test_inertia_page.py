#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The page of ./dev inertia, made of studies that are shorter than its own.
test_inertia_page.py VTI_STUDY PROJECT"""
import os
import re
import sys
import tempfile

try:
    import matplotlib  # noqa: F401
    import h5py
    import numpy as np
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

from programs import run
from tally import check, conclude

study, project = map(os.path.abspath, sys.argv[1:3])
sys.path.insert(0, os.path.join(project, "drivers"))
from plot import methods, words  # noqa: E402
from plot.pages import inertia, price_list  # noqa: E402
from plot.pages.cost_file import read_cost  # noqa: E402
from plot.trouble import Trouble  # noqa: E402

STEPPERS = "exact,suzuki4,no-squish,spiral-aspherical"


def measured(base, folder, *arguments):
    done = run(study, "--no-plot", "--steppers", STEPPERS, "-o", os.path.join(base, folder), *arguments,
               os.path.join(project, "scenes", "dzhanibekov.yaml"))
    check(done.returncode == 0, f"{folder} {done.stderr}")


def refuses(base, what):
    try:
        inertia.build(base, base, None)
        check(False, f"without {what} there is no page")
    except Trouble as trouble:
        check(what in str(trouble), f"without {what}: {trouble}")


with tempfile.TemporaryDirectory() as base:
    refuses(base, "table-free-body")
    for scene in inertia.SCENES:
        measured(base, f"table-{scene}", "--h", "0.1", "--t-end", "10")
    refuses(base, "orders-free-body")
    for scene in inertia.SCENES:
        measured(base, f"orders-{scene}", "--h", "1/4:1/32", "--t-end", "10")
    measured(base, "cost", "--cost", "--repeats", "1", "--evals", "3000", "--t-end", "2")
    into = os.path.join(base, "docs")
    os.mkdir(into)
    inertia.build(base, into, "inertia")
    with open(os.path.join(into, "inertia.md"), encoding="utf-8") as file:
        page = file.read()
    errors = inertia.attitude_errors(base)[0]["free-body"]
    check(f"| NO_SQUISH (`no-squish`) | {errors['no-squish']:.2g} |" in page, "errors are those of the study")
    orders = inertia.fitted(base, "free-body")
    check(abs(orders["suzuki4"][0] - 4) < 0.1 and f" {words.with_interval(*orders['suzuki4'])} |" in page, f"orders too: {orders}")
    check("1e-4: " in page and "against " in page and "inertia/prices.png" in page, "prices, ours against rivals")
    with h5py.File(os.path.join(base, "orders-free-body", "study.h5")) as file:
        runs, fits = ({name: column[...] for name, column in file[table].items()} for table in ("runs", "orders"))
    for stepper in ("no-squish", "spiral-aspherical"):
        fit = np.flatnonzero((fits["stepper"] == stepper.encode()) & (fits["measure"] == b"h1_error"))[0]
        used = (runs["stepper"] == stepper.encode()) & (runs["h"] >= fits["h_min"][fit]) & (runs["h"] <= fits["h_max"][fit])
        slope = np.polyfit(np.log(runs["h"][used]), np.log(runs["h1_error"][used]), 1)[0]
        check(abs(orders[stepper][0] - slope) < 1e-9, f"... those of the true error, {stepper}: {orders[stepper][0]:.6f} beside {slope:.6f}")
    size = os.path.getsize(os.path.join(into, "inertia", "prices.png"))
    check(10_000 < size < 300_000, f"the picture has {size} bytes")
    cost = read_cost(os.path.join(base, "cost"))
    for scene in cost.scenes():
        costs = {rival: [(price_list.price(ladder, 1e-4, "force_evals"), price_list.price(ladder, 1e-4))
                         for ladder in cost.prices[scene].values() if (ladder.kind == "rival") == rival] for rival in (False, True)}
        (own, time), (theirs, others) = (min(each for each in some if each[0] == each[0]) for some in costs.values())
        told = f"({price_list.three(theirs / own)} times; in time {price_list.three(others / time)})"
        below = page.split(f"## Prices: {scene}\n")[1].split("the cheapest rival: ")[1].split("\n")[0]
        check(any(part.startswith("1e-4: ") and told in part for part in re.split("; (?=1e-)", below)), f"{scene}: rivals over ours to 1e-4: {told}")
    figure = inertia.prices_figure(cost)
    for scene, axes in ((scene, axes) for scene in cost.scenes() for axes in figure.axes if axes.get_title().startswith(scene)):
        named = {text.get_text() for text in axes.texts}
        best = {min(("exact", "suzuki4"), key=lambda stepper: price_list.price(cost.prices[scene][stepper], error, "force_evals"))
                for error in price_list.errors(cost, scene)}
        check({methods.name(stepper) for stepper in best} | {"all of order 2"} <= named, f"{scene}: who is the cheapest of ours is named: {named}")
conclude()
