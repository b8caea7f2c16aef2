# SPDX-License-Identifier: BSD-3-Clause
"""The price list: what an error costs with each method, which is the cheapest, and what a factor of ten more costs."""
import numpy as np

from .. import methods

REACHED_BY_MOST = 0.5       # of the methods
SORTED_BY = 1e-6            # unless so few reach it
TIE = 1.05              # prices nearer to each other than this are a tie: times are not known better
NEIGHBOURS = 1.2            # factors nearer to each other than this are named together


def errors(cost, scene):
    """1e-2 ... 1e-10, those that somebody reaches."""
    return sorted({error for ladder in cost.prices[scene].values()
                   for error in ladder["error"][np.isfinite(ladder["seconds"])]}, reverse=True)


def price(ladder, error, column="seconds"):
    """NaN where it is not reached."""
    found = ladder[column][np.isclose(ladder["error"], error, rtol=1e-6, atol=0)]
    return float(found[0]) if len(found) else np.nan


def cheapest(cost, scene, error, kinds=tuple(methods.FAMILIES), column="seconds", measure=None, among=None):
    """The method of these kinds that reaches it for the least, and that price; None, NaN if none does. measure: as in
    prices.csv; None: the scene's first. among: the methods that are looked at; None: all."""
    ladders = cost.by_measure[scene][measure] if measure else cost.prices[scene]
    found = {method: price(ladder, error, column) for method, ladder in ladders.items()
             if ladder.kind in kinds and (among is None or method in among)}
    found = {method: value for method, value in found.items() if np.isfinite(value)}
    method = min(found, key=found.get, default=None)
    return method, found.get(method, np.nan)


def ratio(cost, scene, error, column="seconds", measure=None, rivals=None):
    """Best of ours over best rival, or over the best of these: the two methods and the ratio of their prices."""
    mine, own = cheapest(cost, scene, error, ("ours",), column, measure)
    other, theirs = cheapest(cost, scene, error, ("rival",), column, measure, rivals)
    return mine, other, own / theirs


def factor(ladder, column="seconds"):
    """What a factor of ten in accuracy costs: the geometric mean of the ratios of prices of neighbouring decades, over
    the range that is reached; NaN with fewer than two. The coarsest price may be that of the largest step that goes at
    all, which is no trade of error against cost: first ratios of less than 1.05 are left out, and if these are all, it
    is NaN."""
    good = np.isfinite(ladder[column])
    values, decades = ladder[column][good], -np.log10(ladder["error"][good])
    while len(values) > 1 and values[1] < 1.05 * values[0]:
        values, decades = values[1:], decades[1:]
    if len(values) < 2 or not values[0] > 0:
        return np.nan
    return float((values[-1] / values[0]) ** (1 / (decades[-1] - decades[0])))


def order_shown(ladder):
    """The order that the evaluations tell: with order p a factor of ten costs 10^(1/p)."""
    grows = factor(ladder, "force_evals")
    return 1 / np.log10(grows) if grows > 1 else np.nan


def ordered(cost, scene):
    """Methods by their time to SORTED_BY, or to the smallest error that most reach; then those that do not reach it, by
    how far they come."""
    ladders = cost.prices[scene]
    reached = [error for error in errors(cost, scene)
               if np.mean([np.isfinite(price(ladder, error)) for ladder in ladders.values()]) >= REACHED_BY_MOST]
    pivot = max(min(reached, default=1e-2), SORTED_BY)

    def key(method):
        good = np.isfinite(ladders[method]["seconds"])
        seconds = price(ladders[method], pivot)
        last = np.min(ladders[method]["error"][good], initial=np.inf)
        return (not np.isfinite(seconds), seconds if np.isfinite(seconds) else last, methods.name(method))

    return sorted(ladders, key=key), pivot


def table(cost, scene):
    """head and rows for page.Page.table."""
    columns = errors(cost, scene)
    least = {(error, what): TIE * cheapest(cost, scene, error, column=what)[1] for error in columns
             for what in ("seconds", "force_evals")}
    rows = []
    for method in ordered(cost, scene)[0]:
        ladder = cost.prices[scene][method]
        cells = [_cell(ladder, error, *(price(ladder, error, what) <= least[error, what] for what in ("seconds", "force_evals")))
                 for error in columns]
        rows.append([methods.typed(method), ladder.kind, *cells, times(factor(ladder))])
    return ["method", "kind", *map(power, columns), "a factor of ten costs, in time"], rows


def _cell(ladder, error, fastest, fewest):
    time, evaluations = price(ladder, error), price(ladder, error, "force_evals")
    if not np.isfinite(time):
        return "-"
    return " / ".join(f"**{text}**" if first else text
                      for text, first in ((seconds_text(time), fastest), (count_text(evaluations), fewest)))


def in_words(cost, scene):
    """What a factor of ten in accuracy costs with each, methods of about the same factor in one breath."""
    factors = {methods.name(method): factor(ladder) for method, ladder in cost.prices[scene].items()}
    alike = sorted(methods.name(method) for method, ladder in cost.prices[scene].items()
                   if np.count_nonzero(np.isfinite(ladder["seconds"])) > 1 and not np.isfinite(factor(ladder)))
    none = sorted(name for name, value in factors.items() if not np.isfinite(value) and name not in alike)
    groups = []
    for name in sorted((name for name, value in factors.items() if np.isfinite(value)), key=factors.get):
        if groups and factors[name] < NEIGHBOURS * factors[groups[-1][0]]:
            groups[-1].append(name)
        else:
            groups.append([name])
    parts = [f"{_between(factors[group[0]], factors[group[-1]])} with {listing(group)}" for group in groups]
    said = "A factor of ten in accuracy costs " + "; ".join(parts) + ", in time." if parts else ""
    said += f" {listing(alike)}: the largest step that goes reaches all of these errors." if alike else ""
    return said + (f" {listing(none)}: too few of the errors were reached to tell." if none else "")


def _between(low, high):
    low, high = (f"{value:.1f}" if value < 10 else f"{value:.0f}" for value in (low, high))
    return f"**{low}** times" if low == high else f"**{low} to {high}** times"


def listing(names):
    names = list(names)
    return " and ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)


def power(error):
    """1e-4."""
    return f"{error:.0e}".replace("e-0", "e-")


def times(value):
    return f"{value:.2f} times" if np.isfinite(value) else "-"


def three(value):
    """Two or three figures, as a table of measured times can bear: 0.034, 1.23, 45, 312."""
    if not np.isfinite(value):
        return "-"
    if value == 0 or 1e-3 <= abs(value) < 1e4:
        return f"{value:.{2 if abs(value) < 1 else 3}g}" if abs(value) < 100 else f"{value:.0f}"
    return f"{value:.1e}"


def seconds_text(value):
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if value >= 0.9995 * size:
            break
    return f"{three(value / size)} {unit}"


def count_text(value):
    for unit, size in (("M", 1e6), ("k", 1e3)):
        if value >= 0.9995 * size:
            return f"{three(value / size)}{unit}"
    return f"{value:.0f}"
