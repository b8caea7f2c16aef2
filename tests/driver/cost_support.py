# SPDX-License-Identifier: BSD-3-Clause
"""A cost study by formula, as vti-study --cost writes one: every method has an order, an error at h = 1, force
evaluations per step and nanoseconds per evaluation."""
import os

import numpy as np

COST = ("scene,stepper,kind,h,steps,force_evals,seconds,seconds_spread,attitude_error,position_error,velocity_error,energy_error,"
        "momentum_error")
PRICES = "scene,t_end,scene_t_end,stepper,kind,measure,error,force_evals,seconds"
MEASURES = {"attitude": 1, "position": 3, "velocity": 2, "energy": 1 / 9}     # errors over that of attitudes
TARGETS = 10.0 ** -np.arange(2.0, 11.0)
FLOOR = 3e-12       # rounding

# stepper -> kind, order, error at h = 1, evaluations per step, nanoseconds per evaluation
METHODS = {
    "vti1": ("paper", 2, 0.4, 1, 30), "vti2": ("paper", 2, 0.2, 1, 30), "vti3": ("paper", 1, 0.15, 1, 30),
    "vti3-leapfrog": ("paper", 2, 0.2, 1, 30), "exact": ("ours", 2, 0.1, 1, 31), "suzuki4": ("ours", 4, 0.2, 5, 29),
    "kl6": ("ours", 6, 0.05, 9, 29), "kl8": ("ours", 8, 0.02, 17, 29), "srkn6": ("ours", 4, 0.02, 6, 29),
    "srkn11": ("ours", 6, 0.01, 11, 29), "srkn14": ("ours", 6, 0.006, 14, 29), "chin4": ("ours", 4, 0.01, 3, 33),
    "an4": ("ours", 4, 0.1, 1, 80), "an7": ("ours", 8, 2.0, 1, 95), "an9": ("ours", 9, 8.0, 1, 105), "an10-mid": ("ours", 11, 90.0, 1, 110),
    "an10-fine": ("ours", 11, 40.0, 1, 110),
    "lammps-richardson": ("rival", 2, 0.16, 1, 60), "mercury": ("rival", 2, 0.2, 1, 40),
    "yade-exp-verlet": ("rival", 2, 0.1001, 1, 70), "yade-leapfrog": ("rival", 2, 0.11, 1, 70),
    "omelyan": ("rival", 2, 0.25, 1, 55), "campello": ("rival", 1, 0.3, 4, 35), "lgvi": ("rival", 2, 0.4, 1, 150),
    "quat-euler": ("rival", 1, 0.3, 1, 35), "rk4": ("rival", 4, 0.05, 4, 40), "rk8pd": ("rival", 8, 0.01, 13, 60),
    "rk8pd-adaptive": ("rival", 8, 0.008, 13, 65), "spiral": ("rival", 2, 0.11, 1, 72),
    "gear": ("rival", 5, 0.5, 1, 60), "pefrl": ("rival", 4, 0.02, 4, 45), "takahashi-imada": ("rival", 4, 0.05, 2, 50),
    "pd8": ("rival", 8, 0.01, 13, 62), "dop853": ("rival", 8, 0.012, 12, 62), "dop853-adaptive": ("rival", 8, 0.009, 12, 66),
    "vern9": ("rival", 9, 0.01, 15, 64),
    "abm6": ("rival", 6, 2.0, 2, 60), "abm8": ("rival", 8, 8.0, 2, 64), "abm10": ("rival", 10, 40.0, 2, 68),
    "abm12": ("rival", 12, 200.0, 2, 72), "gbs8": ("rival", 8, 0.02, 17, 60), "gbs12": ("rival", 12, 0.05, 37, 60),
    "verlet-x8": ("rival", 8, 0.02, 10, 62), "verlet-x12": ("rival", 12, 0.05, 21, 62),
}
FEW = {method: METHODS[method] for method in ("vti2", "rk4")}
# scene -> end, factor on the errors, highest order that its forces allow, whether anything turns
SCENES = {
    "pendulum-10": (10, 1, 8, True), "pendulum-1000": (1000, 300, 8, True), "chain": (10, 30, 8, True),
    "torus": (5, 1e4, 2.5, True), "pile": (1, 1e4, 2.2, False),
}
MACHINE = "cpu: Abacus 3000\ncores: 2\n"


def law(scene, values):
    """h -> errors, and what a run costs: evaluations and seconds per unit of 1/h. values: as in METHODS."""
    t_end, scale, highest, turns = SCENES[scene]
    kind, order, constant, evals, nanoseconds = values
    order = min(order, highest)
    return kind, turns, lambda h: scale * constant * h**order, evals * t_end, evals * t_end * nanoseconds * 1e-9


def price(scene, values, error):
    """Evaluations and seconds, exactly."""
    _, _, error_of, evals, seconds = law(scene, values)
    order = np.log10(error_of(1.0) / error_of(0.1))
    steps = (error_of(1.0) / error) ** (1 / order)
    return evals * steps, seconds * steps


def write_cost(folder, scenes=SCENES, methods=METHODS):
    """Returns what prices.csv says: (scene, method, error) -> evaluations, seconds."""
    os.makedirs(folder, exist_ok=True)
    runs, prices, told = [COST], [PRICES], {}
    for scene in scenes:
        for method, values in methods.items():
            kind, turns, error_of, evals, seconds = law(scene, values)
            for h in 2.0 ** -np.arange(1, 17, 0.5):
                error = error_of(h)
                if FLOOR < error < 1:
                    runs.append(f"{scene},{method},{kind},{h:.17g},{round(evals / h)},{round(evals / h)},{seconds / h:.17g},"
                                f"0.02,{error if turns else 0:.17g},{3 * error:.17g},{2 * error:.17g},{error / 9:.17g},1e-15")
            first = "attitude" if turns else "velocity"
            for measure in MEASURES if turns else list(MEASURES)[1:]:
                for target in TARGETS:
                    cost = price(scene, values, target * MEASURES[first] / MEASURES[measure])
                    reached = cost[0] < 2.0**20
                    prices.append(f"{scene},{SCENES[scene][0]},20,{method},{kind},{measure},{target:.0e},"
                                  + (f"{cost[0]:.17g},{cost[1]:.17g}" if reached else ","))
                    if reached and measure == first:
                        told[scene, method, f"{target:.0e}"] = cost
    for name, lines in (("cost.csv", runs), ("prices.csv", prices)):
        write(folder, name, "\n".join(lines) + "\n")
    write(folder, "machine.txt", MACHINE)
    return told


def write(folder, name, text):
    with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
        file.write(text)
