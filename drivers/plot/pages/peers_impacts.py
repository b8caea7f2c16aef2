# SPDX-License-Identifier: BSD-3-Clause
"""Two spheres, or one and a plane, in LAMMPS, LIGGGHTS and YADE and by vti-run: parts of the page peers."""

import math

from .. import style
from ..words import short_number
from .peers_rows import NAMES, OTHERS, curves, in_order, of, read, slope


STEPS = (128, 1024, 8192)


def order_and_errors(rows):
    errors = {row["steps"]: row["error"] for row in rows}
    return [f"{slope([row for row in rows if STEPS[0] <= row['steps'] <= STEPS[-1]]):.2f}", *(short_number(errors[steps]) for steps in STEPS)]


def steps_to(rows, error):
    """The fewest steps from which on errors are at most that, between two runs by the power of the steps that joins
    them; infinity if the finest run's is larger."""
    above = [k for k, row in enumerate(rows) if row["error"] > error]
    if not above:
        return rows[0]["steps"]
    if above[-1] + 1 == len(rows):
        return math.inf
    low, high = rows[above[-1]], rows[above[-1] + 1]
    share = math.log(low["error"] / error) / math.log(low["error"] / high["error"])
    return low["steps"] * (high["steps"] / low["steps"]) ** share


def code_of(who):
    return who if who in (*OTHERS, "vti2") else "LAMMPS"


ERRORS = (1e-2, 1e-3, 1e-4)
USUAL = 1e-3


def steps_of(rows, code, plane, angle, error):
    """Of the best law of the code; None where it has none."""
    here = of(rows, plane=plane, angle=angle)
    laws = [of(here, who=who) for who in in_order(here, "who") if code_of(who) == code]
    return min((steps_to(law, error) for law in laws), default=None)


def times_as_many(rows, error=USUAL):
    """How many times as many steps as vti2 the best law of a code takes for an error: by code, plane and angle."""
    found = {}
    for code in codes_of(rows)[:-1]:
        for plane in (0.0, 1.0):
            for angle in in_order(rows, "angle"):
                theirs = steps_of(rows, code, plane, angle, error)
                if theirs is not None:
                    found[code, plane, angle] = theirs / steps_of(rows, "vti2", plane, angle, error)
    return found


def span_words(times):
    """Of a code that does not reach the error everywhere with the steps that were tried, the least."""
    if math.isfinite(max(times)):
        return f"{short_number(min(times))} to {short_number(max(times))}"
    return f"at least {short_number(min(times))}"


def codes_of(rows):
    """vti2 the last."""
    return sorted(dict.fromkeys(map(code_of, in_order(rows, "who"))), key=lambda code: code == "vti2")


def steps_words(steps, least, most):
    if steps is None or steps == least:
        return "-" if steps is None else f"{least:.0f} or fewer"
    return f"{steps:.0f}" if math.isfinite(steps) else f"more than {most:.0f}"


def power(error):
    return f"{error:.0e}".replace("e-0", "e-")


def same_errors(page, rows):
    codes, runs = codes_of(rows), [row["steps"] for row in rows]
    page.text("Steps from which on an error is at most that, of the best law of each code:")
    page.table(
        ["with", "degrees", "error", *codes],
        [
            [
                name,
                f"{angle:g}",
                power(error),
                *(steps_words(steps_of(rows, code, plane, angle, error), min(runs), max(runs)) for code in codes),
            ]
            for plane, name in ((0.0, "pair"), (1.0, "plane"))
            for angle in in_order(rows, "angle")
            for error in ERRORS
            if of(rows, plane=plane, angle=angle)
        ],
    )
    found = times_as_many(rows)
    spans = {code: [times for key, times in found.items() if key[0] == code] for code in codes[:-1]}
    said = [f"{code} takes {span_words(times)} times" for code, times in spans.items() if math.isfinite(min(times, default=math.inf))]
    if said:
        page.text(f"For an error of {power(USUAL)} {', '.join(said)} as many steps as `vti2`.")


def impacts_part(page, folder, image):
    rows = read(folder, "orders")
    page.heading("One oblique impact")
    page.text(
        "Two glass beads of unequal size, or one and a plane, meet at 1 m/s, spinning, at some angle to the "
        "normal, with dashpots (zeta = 0.1; the others' damping is chosen to give the same coefficient, across it as the root "
        "of the stiffnesses, which is what LIGGGHTS has) and friction (mu = 0.5). Errors are of velocities and spins after the impact, as shares of the speed, "
        "each code against its own result with 2^18 steps; about half of the steps fall into the contact. "
        "The order is a fit over 128 to 8192 steps."
    )
    page.picture(image)
    table = []
    for plane in (0.0, 1.0):
        for angle in in_order(rows, "angle"):
            here = of(rows, plane=plane, angle=angle)
            for who in in_order(here, "who"):
                mine = of(here, who=who)
                table.append(
                    [
                        "plane" if plane else "pair",
                        f"{angle:g}",
                        NAMES[who],
                        *order_and_errors(mine),
                        short_number(mine[0]["apart"]) if who != "vti2" else "-",
                    ]
                )
    page.table(["with", "degrees", "law", "order", "128 steps", "1024", "8192", "its limit is off ours by"], table)
    same_errors(page, rows)
    page.text(
        "LAMMPS takes loads that depend on velocities at half steps and returns a spring that slides along "
        "its new direction: its result is of first order, however smooth the impact. The "
        "`synchronized_verlet` of its newer versions, which carries springs by the normal of the half step, "
        "and which walls do not take, leaves that as it is. At 45 degrees the pair slips and sticks by turns, and moments of that "
        "scatter the errors of all."
        + "".join(f" {code}'s result is of that kind, too." for code in OTHERS if of(rows, who=code))
    )
    page.text(
        "The limits differ because the laws do: LAMMPS lets friction hold mu times the whole normal force, "
        "its dashpot's included, ours mu times the elastic one; it takes slip at the full radii, forces at "
        "the middle of the overlap (at walls at the full radius), ours both at the point that divides the "
        "line of centres as the diameters do. Its planes are of the spheres' material: half as stiff as the "
        "rigid plane that one may have in mind."
        + (" LIGGGHTS' limit of friction and planes are as LAMMPS'." if of(rows, who="LIGGGHTS") else "")
    )


def laws_part(page, folder):
    page.heading("Where the laws differ")
    rows = read(folder, "rebounds")
    page.text(
        "**Restitution.** What one asks for, and what comes out of a fine run of a central impact. `tsuji` "
        "of this release evaluates a fit whose coefficient is too small by the root of two for the reduced "
        "mass; `coeff_restitution` has the closed form."
    )
    whats = in_order(rows, "what")
    page.table(
        ["asked for", *whats],
        [
            [f"{e:g}", *(f"{of(rows, what=what, asked=e)[0]['found']:.4f}" for what in whats)]
            for e in in_order(rows, "asked")
        ],
    )
    rows = read(folder, "cycles")
    styles = in_order(rows, "style")
    page.text(
        "**Springs under a load that changes.** Sphere 2 is led around a cycle, without slip or dashpots. "
        "Work that the cycle takes, as a share of the work of shearing; less than 0 is energy out of "
        "nothing. Ours is the law of `mindlin_rescale/force`, the only one that never gives any."
    )
    page.table(
        ["cycle", *(f"`{name}`" for name in styles)],
        [
            [cycle, *(f"{of(rows, cycle=cycle, style=name)[0]['work']:+.2f}" for name in styles)]
            for cycle in in_order(rows, "cycle")
        ],
    )
    turns_part(page, read(folder, "turned"))


AXES = {"0 0 1": "the normal", "0 1 0": "across, in the plane of the load", "1 0 0": "across, along the load"}
TURNED = {
    "LAMMPS": "LAMMPS leaves the load in space when the pair turns about its normal, as its documentation says. Across it the spring "
    "grows by the angle times the overlap, since slip is taken at the full radii, which together are longer than the distance: a "
    "pair that rolls over as one comes to the limit of friction by itself.",
    "LIGGGHTS": "LIGGGHTS leaves it in space likewise, but follows across the normal, to first order in the steps.",
    "YADE": "YADE turns it about the normal by the mean of both spins and follows across it too, where bodies move along chords, "
    "whose slip falls with the square of the steps.",
}


def turns_part(page, rows):
    steps = in_order(rows, "steps")
    page.text(
        "**History and turns.** Two spheres stick, overlap by 1 % and carry a load of a spring as long as 1 % of the overlap; then both "
        "turn by one radian as one rigid body. Relative error of the load after the turn; columns: number of steps of the turn. Ours "
        "goes with the body to 1e-12, by any angle in one step (`./dev build`, then `meson test -C build friction -v`)."
    )
    page.table(
        ["code", "turn about", *(f"{int(n)}" for n in steps)],
        [
            [who, AXES[axis], *(short_number(of(rows, who=who, axis=axis, steps=n)[0]["off"]) for n in steps)]
            for who in in_order(rows, "who")
            for axis in in_order(rows, "axis")
        ],
    )
    page.text(" ".join(TURNED[who] for who in in_order(rows, "who")))


def ledger_part(page, folder):
    rows = read(folder, "ledgers")
    page.heading("The ledger")
    page.text(
        "Kinetic and elastic energy and what was recorded as lost, which should stay; its largest error in the pair's "
        "impacts as a share of the energy. LAMMPS gives no energy of contacts and records no loss (an open "
        "request, issue 4666 of its repository). What its users do is done here: the power of all loads but "
        "the elastic ones is added up over the dumps of every step. The rate times h is of first order; the "
        "mean of two steps, which is what p.(u + u')/2 comes to without intermediate velocities, of second. "
        "Neither says how much springs hold and how much is lost, nor to what."
    )
    table = []
    for angle in in_order(rows, "angle"):
        for who in in_order(rows, "who"):
            mine = of(rows, angle=angle, who=who)
            table.append([f"{angle:g}", NAMES[who], *order_and_errors(mine)])
    page.table(["degrees", "by", "order", "128 steps", "1024", "8192"], table)


def impact_picture(folder, path):
    orders, ledgers = read(folder, "orders"), read(folder, "ledgers")
    figure = style.new_figure(4.4)
    axes = figure.subplots(1, 2)
    laws = of(orders, plane=0.0, angle=45.0)
    for side, rows, title, others in (
        (axes[0], laws, "Pair at 45 degrees: velocities after the impact", 1),
        (axes[1], of(ledgers, angle=45.0), "The same: sum of energies and recorded losses", len(in_order(laws, "who"))),
    ):
        curves(side, rows, "steps", "error", "vti2", "loglog", marked=True, others=others)
        side.set(title=title, xlabel="number of steps")
    axes[0].set_ylabel("error, share of the speed")
    axes[1].set_ylabel("largest error, share of the energy")
    figure.supxlabel(
        "The step h is the time from start to end over the number of steps; errors are shares, without a unit.",
        fontsize=8.5,
        color=style.GREY,
    )
    style.save(figure, path)
