# SPDX-License-Identifier: BSD-3-Clause
"""Numbers and names as a reader wants to see them. Mathtext is matplotlib's own TeX; no TeX is needed."""
import math
import re

from matplotlib.mathtext import MathTextParser


def stepper_name(key):
    """vti1 -> VTI-1, vti3-leapfrog -> VTI-3 leapfrog, srkn6 -> SRKN6."""
    name = re.sub(r"^vti(\d+)", r"VTI-\1", key)
    name = re.sub(r"^srkn(\d+)", r"SRKN\1", name)
    return plain(re.sub(r"(?<=\w)-(?=[a-z])", " ", name))


def plain(text):
    """Text from a file, which may hold a dollar sign without meaning mathematics."""
    return text.replace("$", r"\$")


def math_label(text, fallback):
    """A label from a file, or its plain name where matplotlib cannot set it. Its \\| is a single bar, against TeX."""
    text = text.replace(r"\|", r"\Vert ")
    try:
        MathTextParser("path").parse(text)
    except (ValueError, RuntimeError):
        return plain(fallback)
    return text


def step_text(h):
    """1/64 or 1/12000 where h is that and its decimals say less, for it is how people write these steps."""
    whole = round(1 / h) if h < 1 else 0
    if not 1 < whole <= 2**20 or abs(whole * h - 1) > 1e-12:
        return given(h)
    power_of_two = whole & (whole - 1) == 0
    return f"1/{whole}" if power_of_two or (whole >= 1000 and len(f"{h:.15g}".strip("0.").split("e")[0]) > 1) else given(h)


def steps_of(run):
    """The stepper of a run and its step, if that is always the same."""
    name = stepper_name(run.stepper)
    return f"{name}, steps that vary" if re.search("-(tol|integrating|naive)$", run.stepper) else rf"{name}, $h$ = {step_text(run.h)}"


def number(value, digits=2):
    """Plain near 1, otherwise with a power of ten: 0.25, 12, 3.1 x 10^-5."""
    if value == 0 or not math.isfinite(value):
        return f"{value:g}"
    mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
    if -3 < int(exponent) < 5:
        return f"{value:.{max(0, digits - 1 - int(exponent))}f}"
    return power_of_ten(mantissa, exponent)


def short_number(value, digits=2):
    """3.1e-05, 0.00031, 0.31, 310: without a power of ten from 1e-4 to 1e4."""
    text = f"{value:.{digits}g}"
    return f"{value:.0f}" if "e+" in text and abs(value) < 1e4 else text


def plain_number(value, digits=2):
    """Without mathtext: 3.1e-05."""
    if value == 0 or 0.01 <= abs(value) < 1e4:
        return short_number(value, digits)
    return f"{value:.{digits - 1}e}"


def given(value):
    """A number somebody chose, without the zeros that would claim a measurement: 10, 0.05, 5 x 10^-4."""
    mantissa, _, exponent = f"{value:.6g}".partition("e")
    if not exponent and 0 < abs(value) < 0.001:
        mantissa, exponent = f"{value:.5e}".split("e")
        mantissa = mantissa.rstrip("0").rstrip(".")
    return power_of_ten(mantissa, exponent) if exponent else mantissa


def power_of_ten(mantissa, exponent):
    factor = "" if mantissa == "1" else rf"{mantissa}\times "
    return rf"${factor}10^{{{int(exponent)}}}$"


RESOLVED = 0.5      # an interval wider than this, or than the order, cannot tell it from the next


def resolved(fit):
    """Whether the points of a fit say which order it is: those of trajectories that are lost say none."""
    return fit is not None and not fit.get("lost") and not fit["interval"] > min(RESOLVED, fit["order"])


PLACES = 5          # decimals of an order, at most


def with_interval(value, interval):
    """2.003 ± 0.001, as vti-study prints it: the interval is rounded up to one digit, so that no figure claims more
    than the fit, and the value has as many decimals; five at most, of which the interval is one at the least."""
    if not math.isfinite(interval):
        return f"{value:.2f}"
    def units(places):
        return math.ceil((1 - 1e-9) * interval * 10**places)    # what was rounded to a digit already stays
    places = 0
    while places < PLACES and units(places + 1) <= 9:
        places += 1
    return f"{round(value, places) + 0.0:.{places}f} ± {max(1, units(places)) / 10**places:.{places}f}"


def order_text(fit):
    if fit is None:
        return "no fit"
    text = with_interval(fit["order"], fit["interval"])
    return text if resolved(fit) or not math.isfinite(fit["interval"]) else f"not resolved ({text})"


def nearest_order(fit):
    """The order a method of such a slope is said to have: a multiple of a half if one is near or within the interval,
    else one decimal."""
    half = round(2 * fit["order"]) / 2
    near = max(0.1, fit["interval"] if math.isfinite(fit["interval"]) else 0.0)
    return half if abs(fit["order"] - half) <= near else round(fit["order"], 1)


def orders_phrase(fits):
    """What a panel of fits shows, for its title: `order 2`, `orders 1 and 2`, `orders 2 to 8`."""
    fits = [fit for fit in fits if fit]
    orders = [f"{order:g}" for order in sorted({nearest_order(fit) for fit in fits if resolved(fit)})]
    if not orders:
        return "no order resolved" if fits else "no order fitted"
    if len(orders) == 1:
        return f"order {orders[0]}"
    if len(orders) > 3:
        return f"orders {orders[0]} to {orders[-1]}"
    return f"orders {', '.join(orders[:-1])} and {orders[-1]}"


def listing(items):
    """a, b and c; long lists are cut, because they stand in one line below a picture."""
    items = list(items)
    if len(items) > 4:
        items = items[:3] + [f"{len(items) - 3} more"]
    return " and ".join([", ".join(items[:-1]), items[-1]] if len(items) > 1 else items)


def counted(count, noun):
    return f"{count} {noun}" if count == 1 else f"{count} {noun}s"
