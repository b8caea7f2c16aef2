# SPDX-License-Identifier: BSD-3-Clause
"""The page of what accuracy costs: test_plot_cost.py VTI-PLOT. Makes cost studies by formula and holds the page against
them; then hands it what is none and expects one line each. Of VTI-PLOT only its place is used: the package stands
beside it."""
import csv
import importlib
import itertools
import math
import os
import re
import subprocess
import sys

import plot_support
from plot_support import COARSE, FINE, picture

import h5py
import numpy as np

import cost_support

ENERGY = "pendulum-1000-energy.png"     # the one picture of energy that is on the page


def accuracy(_program, *given, dpi=None):
    """dpi: None for the page with empty pictures."""
    style = importlib.import_module("plot.style")
    save = style.save
    if dpi is None:
        style.save = lambda figure, path: style.write(b"", path)
    done = plot_support.called(importlib.import_module("plot.pages.accuracy"), "accuracy", *given, dpi=dpi or COARSE)
    style.save = save
    return done


def apart(program, *given, **_options):
    """In a process of its own."""
    beside = {**os.environ, "PYTHONPATH": os.path.dirname(program), "PYTHONDONTWRITEBYTECODE": "1"}
    return subprocess.run([sys.executable, "-m", "plot.pages.accuracy", *given], capture_output=True, text=True, check=False,
                          env=beside)


def page(program, study, into, call=accuracy, dpi=None):
    done = call(program, study, "--into", into, dpi=dpi)
    assert done.returncode == 0 and done.stderr == "", done.stderr
    with open(os.path.join(into, "accuracy.md"), encoding="utf-8") as file:
        return file.read()


def table_below(text, heading):
    """head and rows of the first table below a heading."""
    lines = text.split(f"\n## {heading}\n")[1].split("\n## ")[0].splitlines()
    begin = next(number for number, line in enumerate(lines) if line.startswith("|"))
    table = itertools.takewhile(lambda line: line.startswith("|"), lines[begin:])
    cells = [[cell.strip() for cell in line.strip("|").split(" | ")] for line in table]
    return cells[0], cells[2:]


def value(cell):
    """A number with its unit, without marks."""
    found = re.fullmatch(r"([\d.e+-]+) ?(s|ms|µs|k|M|)", cell.replace("*", "").strip())
    assert found, f"'{cell}' is no number"
    return float(found[1]) * {"ms": 1e-3, "µs": 1e-6, "k": 1e3, "M": 1e6}.get(found[2], 1.0)


def test_page_and_pictures(program, folder):
    study, into = os.path.join(folder, "study"), os.path.join(folder, "docs")
    scenes = ("chain", "pendulum-1000")
    cost_support.write_cost(study, scenes=scenes)
    text = page(program, study, into, dpi=FINE)
    names = sorted([f"{scene}.png" for scene in scenes] + [ENERGY])
    assert sorted(os.listdir(os.path.join(into, "accuracy"))) == names, os.listdir(os.path.join(into, "accuracy"))
    once = [picture(os.path.join(into, "accuracy", name), 1590) for name in names]
    for name in names:
        assert f"](accuracy/{name})" in text, f"{name} is not on the page"
    assert "was not drawn" not in text and "nan" not in text and "not quiet" not in text, text
    assert "Abacus 3000; cores: 2" in text, "no machine"

    again = os.path.join(folder, "again")
    assert page(program, study, again, apart) == text, "the same study gave another page"
    assert [picture(os.path.join(again, "accuracy", name), 1590) for name in names] == once, "other bytes"

    done = accuracy(program, study, dpi=COARSE)
    assert done.returncode == 0, done.stderr
    for scene in scenes:
        for what in ("", "-energy"):
            picture(os.path.join(study, f"{scene}{what}.png"), 1590, COARSE)
    with open(os.path.join(study, "accuracy.md"), encoding="utf-8") as file:
        assert file.read().replace("](", "](accuracy/").replace("![", "![accuracy/") == text, "beside the study: another page"


def test_prices(program, folder):
    told = cost_support.write_cost(folder)
    text = page(program, folder, os.path.join(folder, "docs"))
    for scene in cost_support.SCENES:
        head, rows = table_below(text, scene)
        assert len(rows) == len(cost_support.METHODS), f"{scene}: {len(rows)} rows"
        for column in range(2, len(head) - 1):
            error = f"{float(head[column]):.0e}"
            expected = {key[1]: cost for key, cost in told.items() if key[0] == scene and key[2] == error}
            check_column(scene, error, [row[column] for row in rows], expected)
    rows = {row[0]: row for row in table_below(text, "chain")[1]}
    assert rows["exact"][1] == "ours" and rows["VTI-2 (`vti2`)"][1] == "paper" and rows["RK4 (`rk4`)"][1] == "rival", rows
    # order p: a factor of ten costs 10^(1/p)
    for method, order in (("exact", 2), ("RK4 (`rk4`)", 4), ("SRKN11 (`srkn11`)", 6), ("Kahan-Li 8 (`kl8`)", 8)):
        assert rows[method][-1] == f"{10 ** (1 / order):.2f} times", f"{method}: {rows[method][-1]}"
    assert re.search(r"\*\*3\.2\*\* times with [^;]*\bexact\b", text), "not in words"


def least(told, scene, error, index):
    """Of ours, of the rivals and of VTI-2; index: 0 evaluations, 1 seconds."""
    costs = {key[1]: cost[index] for key, cost in told.items() if (key[0], key[2]) == (scene, error)}
    kinds = {method: values[0] for method, values in cost_support.METHODS.items()}
    return (*(min((cost for method, cost in costs.items() if kinds[method] == kind), default=math.nan) for kind in ("ours", "rival")),
            costs.get("vti2", math.nan))


def test_order_of_rows(program, folder):
    """By the time to 1e-6, or to the smallest error that half of the methods reach; behind them, those that do not
    reach it."""
    told = cost_support.write_cost(folder)
    text = page(program, folder, os.path.join(folder, "docs"))
    for scene in cost_support.SCENES:
        head, rows = table_below(text, scene)
        reached = [error for error in cost_support.TARGETS
                   if 2 * sum(key[0] == scene and key[2] == f"{error:.0e}" for key in told) >= len(cost_support.METHODS)]
        pivot = next(cell for cell in head[2:-1] if math.isclose(float(cell), max(1e-6, min(reached))))
        assert f"Rows by the time to {pivot};" in text.split(f"\n## {scene}\n")[1], (scene, pivot)
        times = [row[head.index(pivot)].split(" / ")[0] for row in rows]
        times = [math.inf if time == "-" else value(time) for time in times]
        assert times == sorted(times) and times[0] < times[-1], (scene, times)


def test_ratios(program, folder):
    """Everything that is a share of the best rival's: time first, then evaluations; and who has lost, and what is
    gained."""
    told = cost_support.write_cost(folder, methods={**cost_support.METHODS, "pefrl": ("rival", 4, 0.02, 4, 10)})
    text = page(program, folder, os.path.join(folder, "docs"))
    head, rows = table_below(text, "What it costs")
    beaten = re.search(r"A rival takes less time .*? on (.*)\.\n", text)[1]
    gains = text.split("The time of VTI-2 over that of the best of ours, ")[1].split("\n")[0]
    for row in rows:
        scene, shown = row[0], 0
        below = text.split(f"\n## {scene}\n")[1].split("The best of ours over the best rival, in time / in evaluations")[1].split("\n")[0]
        for error in cost_support.TARGETS:
            (fewest, rivals, _), (mine, other, paper) = (least(told, scene, f"{error:.0e}", index) for index in (0, 1))
            power = f"{error:.0e}".replace("e-0", "e-")
            there = re.search(rf" ([\d.e+-]+) / ([\d.e+-]+) to {power} \(", below)
            assert (there is not None) == math.isfinite(mine / other), (scene, power, below)
            if there:
                assert np.allclose([float(number) for number in there.groups()], [mine / other, fewest / rivals], rtol=0.03), (scene, power, there)
                shown += 1
            lost = mine > 1.05 * other or math.isfinite(other) and not math.isfinite(mine)
            said = re.search(rf"(?:^|; ){scene} at ([^(]*)", beaten)
            assert lost == bool(said and re.search(rf"\b{power}\b", said[1])), (scene, power, beaten)
            if f"{error:g}" in ("0.01", "0.0001", "1e-06", "1e-08") and math.isfinite(paper / mine):
                gained = f"{scene} to {power}: ", paper / mine      # the smallest of these stays
            if power in head and math.isfinite(mine / other):
                cell = row[head.index(power)].split(", ")[1].split(" / ")
                assert np.allclose([float(number) for number in cell], [mine / other, fewest / rivals], rtol=0.03), (scene, power, cell)
        assert shown > 1 and gained[0] in gains, (scene, gains)
        assert math.isclose(float(gains.split(gained[0])[1].split(" (")[0]), gained[1], rel_tol=0.03), (gains, gained)
    assert "](accuracy/pendulum-1000-energy.png)" in text and "pendulum-10-energy" not in text, "the energy of the longest pendulum"
    _, rows = table_below(text, "What contact leaves of the order")
    shown = {row[0]: row[2:] for row in rows}
    assert shown["exact"] == 5 * ["2.0"] and shown["RK4"] == ["4.0", "4.0", "4.0", "2.5", "2.2"], shown
    spin = [row.strip("| ").split(" | ") for row in text.split("\n## Steady spin\n")[1].split("\n## ")[0].splitlines()]
    share = {row[0]: row[1:] for row in spin}
    # asin(1/2) and 2 atan(1/4), 2 atan(1/2), 2 atan(1) beside 1/2, 1 and 2
    assert share["VTI-1"][2:] == ["0.047", "refused", "refused"] and share["VTI-2"][2:] == ["0.02", "0.073", "0.21"], share


def test_equal_time_verdicts(_program, _folder):
    """By every run, on average in each scene, or not."""
    claims = importlib.import_module("plot.pages.claims")
    for ratios, verdict in (((0.5, 0.9), "met"), ((0.5, 1.5), "met on average, not by every run"), ((0.9, 1.5), "**not met**")):
        row = claims._equal_time_row("mercury", {"a": np.array([0.5, 0.9]), "b": np.array(ratios)})
        assert row[2] == verdict and f"the worst run {max(ratios):.2g}" in row[1], row


def test_one_step_for_all(program, folder):
    """A method whose largest step has all errors shows no trade: no factor of ten is told."""
    cost_support.write_cost(folder, scenes=("chain",), methods={k: cost_support.METHODS[k] for k in ("exact", "vti2", "rk4", "srkn11")})
    path = os.path.join(folder, "prices.csv")
    with open(path, encoding="utf-8") as file:
        lines = file.read().splitlines()
    with open(path, "w", encoding="utf-8") as file:
        for line in lines:
            cells = line.split(",")
            file.write((",".join([*cells[:-2], "1000", "1e-3"]) if cells[3] == "srkn11" else line) + "\n")
    text = page(program, folder, os.path.join(folder, "docs"))
    rows = {row[0]: row for row in table_below(text, "chain")[1]}
    assert rows["SRKN11 (`srkn11`)"][-1] == "-", rows["SRKN11 (`srkn11`)"]
    assert "SRKN11: the largest step that goes reaches all of these errors." in text, "not in words"


def check_column(scene, error, cells, expected):
    """Every price that was told is there to three figures, others are not; the least are bold, and only they."""
    shown = [tuple(cell.split(" / ")) for cell in cells if cell != "-"]
    assert len(shown) == len(expected), f"{scene} {error}: {len(shown)} prices instead of {len(expected)}"
    for part, index in ((1, 0), (0, 1)):
        true = sorted(cost[index] for cost in expected.values())
        drawn = sorted(value(cell[part]) for cell in shown)
        assert np.allclose(true, drawn, rtol=6e-3, atol=0.5 if part else 0), f"{scene} {error}: {true} {drawn}"
        bold = [value(cell[part]) for cell in shown if "**" in cell[part]]
        ties = [number for number in true if number <= 1.05 * true[0]]
        assert np.allclose(sorted(bold), ties, rtol=6e-3, atol=0.5 if part else 0), f"{scene} {error}: bold are {bold}, ties {ties}"


def test_claims(program, folder):
    told = cost_support.write_cost(folder)
    text = page(program, folder, os.path.join(folder, "docs"))
    _, rows = table_below(text, "What is claimed, and what is measured")
    kinds = {method: values[0] for method, values in cost_support.METHODS.items()}
    for (scene, error, most), row in zip((("chain", "1e-04", 0.5), ("chain", "1e-06", 0.7), ("pendulum-1000", "1e-04", 1 / 3),
                                          ("pendulum-1000", "1e-06", 1 / 3)), rows):
        least = {kind: min(cost[1] for key, cost in told.items() if key[0] == scene and key[2] == error
                           and kinds[key[1]] == kind) for kind in ("ours", "rival")}
        ratio = least["ours"] / least["rival"]
        assert row[0].startswith(scene) and math.isclose(value(row[1].split(" ")[0]), ratio, rel_tol=0.03), (row, ratio)
        assert row[2] == ("met" if ratio <= most else "**not met**"), (row, ratio)
    # At equal time two methods of order 2 are apart by their constants and the square of their speeds.
    mercury = next(row for row in rows if "MercuryDPM" in row[0])
    ratio = 0.1 / 0.2 * (31 / 40) ** 2
    shown = [value(number) for number in re.findall(r"\*\*(.+?)\*\*", mercury[1])]
    assert len(shown) == 2 and all(math.isclose(number, ratio, rel_tol=0.03) for number in shown), (mercury, ratio)
    assert mercury[2] == "met", mercury

    slow = {**cost_support.METHODS, "exact": ("ours", 2, 0.5, 1, 31), "rk8pd": ("rival", 8, 0.01, 13, 1)}
    cost_support.write_cost(folder, methods=slow)
    rows = table_below(page(program, folder, os.path.join(folder, "docs")), "What is claimed, and what is measured")[1]
    assert rows[0][2] == "**not met**" and next(row for row in rows if "MercuryDPM" in row[0])[2] == "**not met**", rows


def test_goals(program, folder):
    """Evaluations against what was wanted: met or missed, and by how much; and by everything that an error can be
    of."""
    told = cost_support.write_cost(folder)
    text = page(program, folder, os.path.join(folder, "docs"))
    kinds = {method: values[0] for method, values in cost_support.METHODS.items()}
    rows = {row[0]: row for row in table_below(text.replace("What the project has set itself", "## What the project has set itself\n"),
                                               "What the project has set itself")[1]}
    early = ("dop853", "rk8pd", "pd8", "abm", "gbs", "verlet-x")
    among = {row[0]: row for row in table_below(text.replace("The same over the best", "## The same over the best\n"),
                                                "The same over the best")[1]}
    for scene, column, error, most in (("chain", 2, "1e-04", 0.50), ("pendulum-1000", 3, "1e-06", 0.55), ("pile", 1, "1e-02", 0.55)):
        for found, rivals in ((rows, ""), (among, early)):
            least = {kind: min(cost[0] for key, cost in told.items() if key[0] == scene and key[2] == error and kinds[key[1]] == kind
                               and (kind == "ours" or key[1].startswith(rivals))) for kind in ("ours", "rival")}
            ratio = least["ours"] / least["rival"]
            cell = found[scene][column]
            assert cell.startswith(f"{ratio:.2f} ("), (cell, ratio)
            assert cell.endswith(": met" if ratio <= most else f": **missed** by {100 * (ratio / most - 1):.0f} %"), (cell, ratio)
    assert rows["pile"][4] == "-" and "block" not in rows, rows
    shown = {row[0]: row[1:] for row in table_below(text.replace("Where 1e-2 is missed", "## Where 1e-2 is missed\n"),
                                                    "Where 1e-2 is missed")[1]}
    assert list(shown) == [scene for scene, row in rows.items() if "missed" in row[1]] != [], (shown, rows)
    with open(os.path.join(folder, "cost.csv"), encoding="utf-8") as file:
        runs = list(csv.DictReader(file))
    for scene, (wanted, fewest) in shown.items():
        ours, rival = (min(cost[0] for key, cost in told.items() if key[0] == scene and key[2] == "1e-02" and kinds[key[1]] == kind)
                       for kind in ("ours", "rival"))
        most = float(re.search(r"at most ([\d.]+)", rows[scene][1])[1])
        assert ours > most * rival and math.isclose(value(wanted), most * rival, rel_tol=6e-3, abs_tol=0.5), (scene, wanted)
        measure = "attitude_error" if cost_support.SCENES[scene][3] else "velocity_error"
        least = min(float(run["force_evals"]) for run in runs if run["scene"] == scene and 0 < float(run[measure]) < 0.1)
        assert math.isclose(value(fewest.split(" (")[0]), least, rel_tol=6e-3, abs_tol=0.5), (scene, fewest, least)
    assert text.count("| position (length") == len(cost_support.SCENES) and "the scene itself goes on to t = 20" in text, text


def measured(text):
    return text.split("\n## How it is measured\n\n")[1].split("\n\n")[:3]


def test_first_part(program, folder):
    """For users: five minutes, each stepper of the library once in what it keeps, and a name that is one wherever one
    is told to take it; then the tables."""
    cost_support.write_cost(folder)
    first, behind = page(program, folder, os.path.join(folder, "docs")).split("\n# The tables behind it\n")
    assert re.findall(r"^## (.*)", first, re.M) == ["Which stepper when", "What it costs", "What it keeps, and what it does not"], first
    assert len(first.split()) < 1250, f"{len(first.split())} words are no five minutes"     # at 250 a minute
    assert behind.startswith("\n## How it is measured\n") and all(f"\n## {scene}\n" in behind for scene in cost_support.SCENES)
    root, names = os.path.join(os.path.dirname(program), "..", "src"), []
    for path, row in (("vti_steppers.h", r'ROW\("([\w-]+)"'), ("multistep/vti_multistep.c", r'\{"([\w-]+)", \d')):
        with open(os.path.join(root, path), encoding="utf-8") as file:
            names += re.findall(row, file.read())
    kept = re.findall(r"`([\w-]+)`", " ".join(row[0] for row in table_below(first, "What it keeps, and what it does not")[1]))
    # srkn11 by a tolerance keeps other things
    assert sorted(kept) == sorted([*names, "srkn11", "--tolerance"]), (kept, names)
    take = re.findall(r"`([\w-]+)`", " ".join(row[1] for row in table_below(first, "Which stepper when")[1]))
    assert set(take) <= {*names, "--tolerance"}, take
    factors = {row[0]: row[1:] for row in table_below(first.replace("A factor of ten in accuracy costs so", "## Ten\n"), "Ten")[1]}
    scene = list(cost_support.SCENES).index("chain")
    # 10^(1/2), 10^(1/6)
    assert factors["exact"][scene] == "3.16" and factors["SRKN11 (`srkn11`)"][scene] == "1.47", factors


def test_stored_page(program, folder):
    """docs/accuracy.md says what the generator says of how rivals were compiled, and each of its verdicts is that of
    its number."""
    with open(os.path.join(os.path.dirname(program), "..", "docs", "accuracy.md"), encoding="utf-8") as file:
        stored = file.read()
    cost_support.write_cost(folder)
    text = page(program, folder, os.path.join(folder, "docs"))
    opening = measured(text)
    assert "compiled with the same flags" in opening[0] and "exception" in opening[1] and "GSL" in opening[1], opening
    assert measured(stored) == opening, "another opening"
    for heading in ("Which stepper when", "What it keeps, and what it does not"):
        assert table_below(stored, heading) == table_below(text, heading), f"stored, {heading}: another table"
    for row in table_below(stored, "What is claimed, and what is measured")[1][:4]:
        written = re.search(r"at most (.+) of the best", row[0])[1]
        found, most = float(re.match(r"\*\*([\d.]+)\*\*", row[1])[1]), {"a third": 1 / 3}.get(written) or float(written)
        assert row[2] == ("met" if found <= most else "**not met**"), row


def test_colours(_program, _folder):
    """What the caption says: no family has grey or another's colours. The band takes at each error the prices at that
    error."""
    pictures = importlib.import_module("plot.pages.work_precision")
    families = {kind: [tuple(int(colour[k:k + 2], 16) for k in (1, 3, 5)) for colour in colours]
                for kind, colours in pictures.COLOURS.items()}
    for kind, colours in families.items():
        for red, green, blue in colours:
            assert (red, green, blue) == (0, 0, 0) or max(red, green, blue) - min(red, green, blue) > 40, f"{kind}: a grey"
            orange = red > green > 1.5 * blue
            assert orange == (kind == "paper"), f"{kind}: {red} {green} {blue}"
            assert (max(green, blue) > red and not red > green) == (kind == "ours") or (kind == "rival" and red > green), f"{kind}: {red} {green} {blue}"
    assert len({marker for marker, _ in pictures.MARKERS.values()}) == len(families) == len(pictures.MARKERS), "families differ in grey, too"
    many = {f"{kind}-{k:02}": kind for kind in families for k in range(2 * len(families[kind]))}
    ladder = importlib.import_module("plot.pages.cost_file").Ladder
    looks = pictures._looks({name: ladder(kind, {}) for name, kind in many.items()}, set(many))
    assert len({look[:2] for look in looks.values()}) == len(many), "two methods that are named look alike"
    assert all(looks[name][0] in pictures.COLOURS[kind] and looks[name][2:] == pictures.MARKERS[kind] for name, kind in many.items()), looks
    errors = np.array([1e-2, 1e-4, 1e-6])
    prices = {name: ladder(kind, {"error": errors, "seconds": np.array(seconds)}) for name, kind, seconds in (
        ("often", "ours", (2.0, 3.0, 4.0)), ("once", "ours", (1.0, 5.0, 6.0)), ("ends", "ours", (3.0, np.nan, np.nan)), ("other", "rival", (0.5, 1.0, 1.0)))}
    assert [pictures._best(prices, kind) for kind in ("ours", "rival", "paper")] == ["often", "other", None], "thick is the cheapest at most errors"
    axes, errors = plot_support.matplotlib.figure.Figure().add_subplot(), np.array([1e-7, 1e-8, 1e-9, 1e-10])
    [(error, height, *_)] = pictures._band(axes, [pictures.Line(errors, np.array([1.0, 2.0, 3.0, 4.0])),
                                                      pictures.Line(errors, np.array([1.0, 2.0, 3.0, 9.0]))])
    assert error == 1e-10 and math.isclose(height, 6.0), (error, height)


def test_names(_program, _folder):
    """Names beside a panel: alone each is where its line ends; close ones are a group around their middle, which the
    panel's ends keep inside; and many are in their order, none over another."""
    pictures = importlib.import_module("plot.pages.work_precision")
    step = pictures.APART
    for heights, expected in (([], []), ([0.2, 0.7], [0.2, 0.7]), ([0.5, 0.5, 0.5], [0.5 - step, 0.5, 0.5 + step]),
                              ([0.0, 0.0], [0.0, step]), ([0.99, 0.99], [1 - step, 1.0]),
                              ([0.3, 0.5, 0.5], [0.3, 0.5 - step / 2, 0.5 + step / 2])):
        assert np.allclose(pictures.apart(heights), expected, rtol=0, atol=1e-12), (heights, pictures.apart(heights))
    for many in (15, 40):
        placed = pictures.apart(np.sort(np.sin(np.arange(many)) ** 2))
        assert np.all(np.diff(placed) >= step - 1e-12) and placed[-1] <= 1 + 1e-12 and (many == 40 or placed[0] >= 0), placed


def test_edges(program, folder):
    docs = os.path.join(folder, "docs")
    cost_support.write_cost(folder, scenes=("torus",), methods=cost_support.FEW)
    text = page(program, folder, docs)
    assert "no scene chain" in text and "](accuracy/torus-energy.png)" in text, text
    with open(os.path.join(folder, "prices.csv"), encoding="utf-8") as file:
        lines = file.read().splitlines()
    unreached = [",".join(line.split(",")[:7]) + ",," for line in lines[1:]]
    cost_support.write(folder, "prices.csv", "\n".join([lines[0], *unreached]))
    assert "No method reaches" in page(program, folder, docs), "nothing said where nothing is reached"
    cost_support.write(folder, "instructions.csv", "scene,stepper,instructions_per_step\ntorus,vti2,123400\n")
    os.remove(os.path.join(folder, "machine.txt"))
    text = page(program, folder, docs)
    assert table_below(text, "Instructions")[1] == [["VTI-2", "123k"]] and "The machine:" not in text, text


def write_spin(path, stepper, steps, h, too_little):
    """What vti-run writes of a body that turned too little, as far as it is read."""
    omega, t = np.array([0.6, 0.0, 0.8]), steps * h
    half = 0.5 * (t - too_little)
    with h5py.File(path, "w") as file:
        file.attrs.update({"scene": "spin", "stepper": stepper, "h": h, "vti_version": "0.1.0"})
        for column, values in (("t", (0, t)), ("kinetic_rotation", (0.5, 0.5)), ("total", (0.5, 0.5))):
            file[f"energies/{column}"] = np.array(values, float)
        file["VTKHDF/Steps/Values"], file["VTKHDF/Points"] = np.array([0.0, t]), np.zeros((2, 3))
        file["VTKHDF/Lines/Connectivity"] = np.zeros(0, int)
        file["VTKHDF/PointData/attitude_xyzw"] = np.array([[0, 0, 0, 1.0], [*(omega * np.sin(half)), np.cos(half)]])
        file["VTKHDF/PointData/omega"] = np.array([omega, omega])


def test_steady_spin(program, folder):
    cost_support.write_cost(folder, scenes=("chain",), methods=cost_support.FEW)
    os.mkdir(os.path.join(folder, "spin"))
    for stepper, too_little in (("vti2", 0.42), ("exact", 3e-5)):
        write_spin(os.path.join(folder, "spin", f"{stepper}.h5"), stepper, 40000, 0.01, too_little)
    text = page(program, folder, os.path.join(folder, "docs"))
    rows = table_below(text, "Steady spin")[1]
    assert rows[:2] == [["exact", "3.0e-05"], ["VTI-2", "0.42"]], rows
    assert "40k steps at h|Omega| = 0.01" in text, "not said of what"


def refuses(program, folder, *words):
    done = accuracy(program, folder, "--into", os.path.join(folder, "docs"))
    assert done.returncode == 1 and done.stdout == "", f"status {done.returncode}: {done.stdout}{done.stderr}"
    assert done.stderr.startswith("accuracy: ") and done.stderr.count("\n") == 1 and ";" in done.stderr, done.stderr
    for word in words:
        assert word in done.stderr, f"no '{word}' in: {done.stderr}"
    assert not os.path.exists(os.path.join(folder, "docs")), "refused, and yet something was written"


def test_refusals(program, folder):
    refuses(program, os.path.join(folder, "nowhere"), "is not a folder")
    refuses(program, folder, "cost.csv", "no such file")
    for name in ("cost.csv", "prices.csv"):
        cost_support.write_cost(folder, scenes=("chain",), methods=cost_support.FEW)
        path = os.path.join(folder, name)
        with open(path, encoding="utf-8") as file:
            whole = file.read()
        for content, words in (("", "holds no rows"), (whole.split("\n")[0] + "\n", "holds no rows"),
                               (whole.replace("force_evals", "evals", 1), "lacks the column force_evals"),
                               (whole.replace("rival", "rivals", 1), "kind is 'rivals'"),
                               (re.sub("(paper,(attitude,)?)", r"\1x", whole, count=1), ":2: "),
                               (re.sub("(paper,(attitude,)?)", r"\1-", whole, count=1), "is negative"),
                               (whole.rsplit(",", 3)[0], "cells instead of")):
            cost_support.write(folder, name, content)
            refuses(program, folder, name, words)
        os.remove(path)
        refuses(program, folder, name, "no such file")
    cost_support.write_cost(folder, scenes=("chain",))
    with open(os.path.join(folder, "prices.csv"), encoding="utf-8") as file:
        whole = file.read()
    cost_support.write(folder, "prices.csv", whole.replace("\nchain,", "\ntorus,"))
    refuses(program, folder, "has the scenes torus, but cost.csv has chain")


if __name__ == "__main__":
    plot_support.main(test_page_and_pictures, test_prices, test_order_of_rows, test_ratios, test_equal_time_verdicts,
                      test_one_step_for_all, test_claims, test_goals, test_first_part, test_stored_page,
                      test_colours, test_names, test_edges, test_steady_spin, test_refusals)
