# SPDX-License-Identifier: BSD-3-Clause
"""The methods of a cost study: what a reader calls them, and which belong together."""
from . import words

FAMILIES = {"ours": "ours", "paper": "the paper's", "rival": "rivals"}

NAMES = {
    "exact": "exact", "suzuki4": "Suzuki 4", "kl6": "Kahan-Li 6", "kl8": "Kahan-Li 8", "chin4": "Chin 4",
    "srkn11-tol": "SRKN11 by tolerance", "an4": "AN(4)", "an7": "AN(7)", "an9": "AN(9)", "an10-mid": "AN(10) mid",
    "an10-fine": "AN(10) fine",
    "lammps-richardson": "LAMMPS (Richardson)", "mercury": "MercuryDPM", "yade-exp-verlet": "YADE exp. Verlet",
    "yade-leapfrog": "YADE leapfrog", "omelyan": "Omelyan", "campello": "Campello", "lgvi": "LGVI",
    "quat-euler": "quaternion Euler", "rk4": "RK4", "rk8pd": "RK8(7) fixed (GSL)", "rk8pd-adaptive": "RK8(7) adaptive (GSL)",
    "spiral": "SPIRAL", "gear": "Gear", "pefrl": "PEFRL", "takahashi-imada": "Takahashi-Imada", "pd8": "RK8(7) fused",
    "dop853": "DOP853", "dop853-adaptive": "DOP853 adaptive", "vern9": "Verner 9", "abm6": "Adams PECE 6", "abm8": "Adams PECE 8", "abm10": "Adams PECE 10",
    "abm12": "Adams PECE 12", "gbs8": "GBS 8", "gbs12": "GBS 12", "verlet-x8": "Verlet extrapolated 8",
    "verlet-x12": "Verlet extrapolated 12",
    "no-squish": "NO_SQUISH", "lammps-asphere": "LAMMPS asphere", "fincham": "Fincham", "yade-aspherical": "YADE aspherical",
    "buss": "Buss", "moser-veselov": "Moser-Veselov", "moser-veselov-newton": "Moser-Veselov by Newton",
    "implicit-midpoint": "implicit midpoint", "spiral-aspherical": "SPIRAL aspherical",
}

# Verlet's scheme with a quaternion, each as its users have it
QUATERNION_VERLET = ("lammps-richardson", "mercury", "yade-exp-verlet", "yade-leapfrog", "omelyan", "spiral")

# Of order 2, one evaluation a step: their prices lie so close that they are drawn as one band
SECOND_ORDER = ("vti1", "vti2", "vti3-leapfrog", "exact", "lgvi", *QUATERNION_VERLET)

# The same of bodies of three moments, but `exact`, which is of order 4 where no moment acts
SECOND_ORDER_TOPS = ("vti1", "vti2", "vti3-leapfrog", "no-squish", "lammps-asphere", "fincham", "buss", "moser-veselov",
                     "moser-veselov-newton", "implicit-midpoint", "spiral-aspherical")


def name(key):
    return NAMES.get(key) or words.stepper_name(key)


def typed(key):
    """With what one types to get it, where that is another word."""
    return name(key) if name(key) == key else f"{name(key)} (`{key}`)"
