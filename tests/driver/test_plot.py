# SPDX-License-Identifier: BSD-3-Clause
"""vti-plot: test_plot.py VTI-PLOT. Makes studies by formula, draws them and looks at what came out; then hands it files
that are not studies and expects one line each."""
import importlib
import os

import plot_support
from plot_support import EPS, FINE, apart, left_alone, picture, plot, refuses, refuses_damage

import h5py
import numpy as np

MEASURES = ("e_error", "q_error", "h1_error", "attitude_error")
LADDER = 2.0 ** -np.arange(3, 13)

# stepper -> per measure (order, error at h = 1); as on the paper's pendulum, EQUATIONS section 4
PAPER = {
    "vti1": ((2, 0.44), (1, 0.089), (2, 0.56), (2, 0.4)),
    "vti2": ((2, 0.05), (1, 0.31), (2, 0.26), (2, 0.2)),
    "vti3": ((1, 0.56), (0.5, 0.25), (1, 0.22), (1, 0.15)),
    "vti3-leapfrog": ((2, 0.05), (1, 0.31), (2, 0.26), (2, 0.2)),
}
HIGHER = {
    "vti1-body": ((2, 0.44), (1, 0.089), (2, 0.56), (2, 0.4)),
    "exact": ((2, 0.1), (1, 0.15), (2, 0.1), (2, 0.1)),
    "srkn6": ((4, 0.02), (2, 0.03), (4, 0.02), (4, 0.01)),
    "srkn11": ((6, 0.004), (3, 0.01), (6, 0.004), (6, 0.003)),
    "srkn14": ((6, 0.0006), (3, 0.004), (6, 0.0007), (6, 0.0005)),
    "campello$half": ((1, 0.9), (0.5, 0.6), (1, 0.8), (1, 0.8)),
}


def texts(values, fixed):
    if fixed:
        return np.array([value.encode() for value in values], dtype=f"S{max(map(len, values), default=1)}")
    return np.array(values, dtype=h5py.string_dtype())


def line_fit(h, error):
    """order, its interval, log2_constant; NaN where two points or fewer leave no interval."""
    if len(h) < 3:
        return np.nan, np.nan, np.nan
    (order, constant), covariance = np.polyfit(np.log2(h), np.log2(error), 1, cov=True)
    return order, 2.0 * np.sqrt(covariance[0, 0]), constant


def write_study(path, steppers=None, ladder=LADDER, fixed=False, zeros=False, kept=None, t_end=10.0):
    """A study as vti-study writes it; errors follow their orders down to rounding, the q-error with noise."""
    steppers = PAPER if steppers is None else steppers
    random = np.random.default_rng(20240229)
    runs, orders, series = [], [], []
    for stepper, laws in steppers.items():
        errors = []
        for measure, (order, constant) in zip(MEASURES, laws):
            noise = 0.08 if measure == "q_error" else 0.01
            floor = EPS ** 0.5 * 3e-2 if measure == "q_error" else 40 * EPS * (ladder[0] / ladder) ** 0.5
            error = constant * ladder**order * np.exp(noise * random.standard_normal(len(ladder)))
            if zeros and measure == "e_error":
                error[-2:] = 0.0
            else:
                error = np.hypot(error, floor)
            errors.append(error)
            good = (error > 30 * floor) & (ladder < 0.1)
            orders.append((stepper, measure, *line_fit(ladder[good], error[good])[:2], good.sum(),
                           ladder[good].min(initial=np.inf), ladder[good].max(initial=0.0),
                           line_fit(ladder[good], error[good])[2]))
        for i, h in enumerate(ladder):
            runs.append((h, t_end, round(t_end / h), round(t_end / h) + 1, *(error[i] for error in errors), 3 * EPS))
            series.append((stepper, h, errors[0][i]))

    with h5py.File(path, "w") as file:
        file.attrs["scene"] = np.bytes_("pendulum") if fixed else "pendulum"
        file.attrs["vti_version"] = "0.1.0"
        file.attrs.update({"t_end": t_end, "energy0": 0.747106781186548, "norm_squared": 66.86301608208})
        names = [stepper for stepper in steppers for _ in ladder]
        file["runs/stepper"] = texts(names, fixed)
        file["runs/scene"] = texts(["pendulum"] * len(names), fixed)
        columns = ("h", "t_end", "steps", "force_evals", *MEASURES, "momentum_error")
        for column, values in zip(columns, np.array(runs).T):
            file[f"runs/{column}"] = values.astype("i8") if column in ("steps", "force_evals") else values
        for column, values in zip(("stepper", "measure", "order", "interval", "points", "h_min", "h_max",
                                   "log2_constant"), zip(*orders)):
            file[f"orders/{column}"] = texts(values, fixed) if column in ("stepper", "measure") else np.array(values)
        file.create_group("series")
        for row, (stepper, h, size) in enumerate(series):
            if kept is None or row in kept:
                write_series(file.create_group(f"series/{row:06d}"), stepper, h, size, t_end, random)


def write_series(group, stepper, h, size, t_end, random):
    group.attrs["stepper"], group.attrs["h"] = stepper, h
    t = np.arange(round(t_end / h) + 1) * h
    group["t"] = t
    group["energy_error"] = size * np.sin(2.3 * t) * (1 + 0.4 * np.sin(5.1 * t + h))
    for name, label in (("arm_dot_omega", r"$R\rho_0\cdot\Omega$"), ("arm_length", r"$\|R\rho_0\|$"),
                        ("angular_z", r"$e_3\cdot J\,\Omega$")):
        walk = 0.3 * np.cumsum(random.standard_normal(len(t))) * EPS
        group[name] = np.round(np.clip(walk, -1, 1) / EPS) * EPS if name == "arm_length" else walk
        group[name].attrs["label"] = label


WIDTH = 1590        # pixels, at least: no picture of a study is so heavy that it is drawn smaller


def draws(program, study, folder, pictures=("convergence.png", "invariants.png"), **options):
    return plot_support.draws(program, study, folder, pictures, WIDTH, **options)


def test_pictures(program, folder):
    study = os.path.join(folder, "study.h5")
    write_study(study)
    once, said = draws(program, study, os.path.join(folder, "once"), dpi=FINE)
    assert "note:" not in said, said
    assert b"Matplotlib" not in b"".join(once), "a picture names the software that drew it"

    left_alone(program, study)
    beside = [picture(os.path.join(folder, name), WIDTH) for name in ("convergence.png", "invariants.png")]
    assert beside == once, "the same file gave different bytes, or -o changed the picture"

    coarse, _ = draws(program, study, os.path.join(folder, "coarse"))
    write_study(study, fixed=True)
    assert draws(program, study, os.path.join(folder, "fixed"))[0] == coarse, "fixed-length strings gave other pictures"

    write_study(study, steppers={**PAPER, "vti1": ((3, 0.44),) + PAPER["vti1"][1:]})
    changed, _ = draws(program, study, os.path.join(folder, "changed"))
    assert changed[0] != coarse[0], "the energy error changed and the picture did not"


def test_fitted_lines(_program, folder):
    """The lines that are drawn run through the points that they were fitted to: they are read off the axes, and pass no
    point by more than the noise that was put on it."""
    path = os.path.join(folder, "study.h5")
    write_study(path)
    study = importlib.import_module("plot.study_file").read_study(path)
    figure, _ = importlib.import_module("plot.convergence").draw(study)
    lines = []
    for axes in figure.axes:
        for line in axes.get_lines() if axes.get_xlabel() else []:
            x, y = line.get_xdata(), line.get_ydata()
            # the key of slopes is elsewhere
            if len(x) == 2 and line.get_marker() == "None" and set(x) <= set(study.runs["h"]):
                lines.append((axes.get_title().split(":")[0], *x, *y))
    measures = {"Energy error": 0, "The paper's q-error": 1, "True $H^1$ error": 2}
    assert len(lines) == len(PAPER) * len(measures), lines
    for (name, *ends), law in zip(lines, [laws[m] for m in measures.values() for laws in PAPER.values()]):
        x, y = np.array(ends[:2], float), np.array(ends[2:], float)
        away = np.log2(y / (law[1] * x**law[0]))
        assert np.all(np.abs(away) < 0.4), f"{name}: a line of order {law[0]} is off by factors of {2**away}"


def test_points(_program, folder):
    """As many points are strong as the fit has used; one at the end of its range is."""
    path = os.path.join(folder, "study.h5")
    write_study(path)
    study = importlib.import_module("plot.study_file").read_study(path)
    figure, _ = importlib.import_module("plot.convergence").draw(study)
    for panel, measure in enumerate(MEASURES[:3]):
        marks = [line for line in figure.axes[2 * panel].get_lines() if line.get_marker() != "None"]
        strong, pale = ([len(line.get_xdata()) for line in marks if line.get_alpha() == alpha] for alpha in (1.0, 0.4))
        used = [int(study.fit(stepper, measure)["points"]) for stepper in PAPER]
        assert strong == used and pale == [len(LADDER) - count for count in used], (measure, strong, pale, used)


def test_chosen(_program, folder):
    """Of runs over time the one in the middle of those that all steppers have is shown; and who is off the most is
    named."""
    invariants, study_file = (importlib.import_module(f"plot.{name}") for name in ("invariants", "study_file"))
    path = os.path.join(folder, "study.h5")
    write_study(path, kept=(1, 2, 3, 4, 11, 12, 13, 14, 29))     # of VTI-1 and VTI-2 1/16 to 1/128, of VTI-3 its finest
    chosen = invariants._choose_runs(study_file.read_study(path))
    assert {stepper: round(1 / h) for stepper, (_, h) in chosen.items()} == {"vti1": 64, "vti2": 64, "vti3": 4096}, chosen
    assert [name for name, _ in chosen.values()] == ["000003", "000013", "000029"], chosen
    with h5py.File(path, "a") as file:
        file["series/000013/angular_z"][5] = -0.25
    figure, _ = invariants.draw(study_file.read_study(path))
    titles = [axes.get_title() for part in figure.subfigs for axes in part.axes]
    assert [title for title in titles if "off by" in title] == ["$e_3\\cdot J\\,\\Omega$\noff by up to 0.25 (VTI-2)"], titles


def test_peaks(_program, _folder):
    """Of a long record no peak is lost, up or down."""
    values = np.zeros(5000)
    values[[1234, 3210]] = 1.0, -1.0
    t, shown = importlib.import_module("plot.curves").finite(np.arange(5000.0), values)
    assert {(1234.0, 1.0), (3210.0, -1.0)} <= set(zip(t, shown)) and len(t) <= 1002, len(t)


def write_sweep(path):
    """Two groups of two steppers at three steps, over three values: means, spreads and orders that differ in all of
    them. Returns (group, stepper, h, measure) -> mean, spread."""
    measures, told = (*MEASURES, "momentum_error"), {}
    rows, orders = [], []
    for group, point in enumerate((0, 3)):
        for s, order in enumerate((2, 1)):
            for h in (0.25, 0.125, 0.0625):
                for m, measure in enumerate(measures):
                    mean = 0.1 * (1 + group + 3 * m) * h**order
                    told[group, s, h, measure] = mean, 0.25 * mean
                rows.append((point, s, h, 3, 0, 0, *(value for measure in measures for value in told[group, s, h, measure])))
            orders += [(point, s, m, order + 0.5 * group + 0.25 * m, 0.1) for m in range(len(measures))]
    with h5py.File(path, "w") as file:
        file.attrs.update({"ensemble": "pendulum.weight", "vti_version": "0.1.0"})
        file["sweep/pendulum.weight/value"], file["sweep/stiffness/value"] = np.array([1.0, 2.0, 3.0]), np.array([10.0, 20.0])
        for name, names in (("scenes", ["pendulum"]), ("steppers", ["vti1", "vti2"]), ("measures", measures)):
            file[f"{name}/name"] = texts(names, False)
        for name, values in (("scene", 6 * [0]), ("pendulum.weight", 2 * [0, 1, 2]), ("stiffness", 3 * [0] + 3 * [1])):
            file[f"points/{name}"] = np.array(values)
        columns = ("point", "stepper", "h", "runs", "failed", "infinite", *(f"{what}_{measure}" for measure in measures for what in ("mean", "spread")))
        for name, table, names in (("ensemble", rows, columns), ("ensemble_orders", orders, ("point", "stepper", "measure", "mean_order", "spread_order"))):
            for column, values in zip(names, zip(*table)):
                file[f"{name}/{column}"] = np.array(values)
    return told


def test_ensemble(program, folder):
    """Points are means, bars reach a standard deviation up and down, and each panel has the orders of its own group and
    measure."""
    path = os.path.join(folder, "study.h5")
    told = write_sweep(path)
    draws(program, path, os.path.join(folder, "drawn"), pictures=("ensemble.png",))
    figure, notes = importlib.import_module("plot.ensemble").draw(importlib.import_module("plot.sweep_file").read_sweep(path))
    panels, legends = ([axes for axes in figure.axes if bool(axes.get_xlabel()) == drawn] for drawn in (True, False))
    assert len(panels) == len(legends) == 6 and not notes, notes
    for k, (axes, legend) in enumerate(zip(panels, legends)):
        group, measure = k // 3, MEASURES[k % 3]
        assert k % 3 or axes.get_title().startswith(f"pendulum, stiffness = {10 * (group + 1)}: energy"), axes.get_title()
        for s, (line, bars) in enumerate(zip(axes.get_lines(), axes.collections)):
            expected = [(h, *told[group, s, h, measure]) for h in (0.25, 0.125, 0.0625)]
            assert np.allclose(line.get_xydata(), [(h, mean) for h, mean, _ in expected]), (k, s, line.get_xydata())
            assert np.allclose([bar[:, 1] for bar in bars.get_segments()], [(mean - spread, mean + spread) for _, mean, spread in expected]), (k, s)
        shown = [text.get_text() for text in legend.get_legend().get_texts()]
        assert shown == [f"VTI-{s + 1}: {order + 0.5 * group + 0.25 * (k % 3):.1f} ± 0.1" for s, order in enumerate((2, 1))], (k, shown)
    with h5py.File(path, "a") as file:
        file["ensemble/infinite"][1], file["ensemble/mean_e_error"][1] = 2, np.inf
    _, notes = importlib.import_module("plot.ensemble").draw(importlib.import_module("plot.sweep_file").read_sweep(path))
    assert [note.split(": ", 1)[1] for note in notes] == ["2 runs with infinite errors: these have no mean",
                                                          "Energy error: 1 mean not drawn, being 0, infinite or of no run"], notes


def test_lost(_program, folder):
    """A trajectory that is off by more than a tenth at every h has no order, though its errors are on a line; the
    energy's stays."""
    path = os.path.join(folder, "study.h5")
    write_study(path)
    with h5py.File(path, "a") as file:
        mine = np.array([name in (b"vti1", "vti1") for name in file["runs/stepper"][()]])
        file["runs/h1_error"][...] = np.where(mine, file["runs/h1_error"][...] * 1e12, file["runs/h1_error"][...])
    figure, notes = importlib.import_module("plot.convergence").draw(importlib.import_module("plot.study_file").read_study(path))
    legends = [axes.get_legend().get_texts()[0].get_text() for axes in figure.axes if axes.get_legend()]
    assert ["not resolved" in legend for legend in legends] == [False, True, True] and all("VTI-1" in legend for legend in legends), legends
    assert any("trajectory is lost" in note for note in notes), notes
    assert importlib.import_module("plot.words").with_interval(-0.2, 3) == "0 ± 3"


def test_edges(program, folder):
    study = os.path.join(folder, "study.h5")
    write_study(study, ladder=np.array([0.01]))
    draws(program, study, os.path.join(folder, "one-h"))
    write_study(study, steppers={"vti2": PAPER["vti2"]}, ladder=0.002 * 2.0 ** -np.arange(4.0))
    draws(program, study, os.path.join(folder, "one-stepper"))
    write_study(study, steppers={**PAPER, **HIGHER})
    draws(program, study, os.path.join(folder, "ten-steppers"), dpi=FINE)
    write_study(study, zeros=True)
    _, said = draws(program, study, os.path.join(folder, "zeros"))
    assert "8 points not drawn" in said and "exactly 0" in said, said
    write_study(study, ladder=np.array([0.01]), steppers={"vti2": ((1, 0.0),) * 4}, zeros=True)
    draws(program, study, os.path.join(folder, "nothing-but-zero"))
    write_study(study, kept=())
    _, said = draws(program, study, os.path.join(folder, "no-series"), pictures=("convergence.png",))
    assert "/series is empty" in said, said
    write_study(study, kept=(4, 15))
    _, said = draws(program, study, os.path.join(folder, "two-series"))
    assert "VTI-3" in said, said

    write_study(study)
    with h5py.File(study, "a") as file:
        file["runs/e_error"][3], file["runs/h1_error"][4] = np.nan, np.inf
        file["series/000005/energy_error"][100:] = np.inf
        file["series/000005/arm_length"].attrs["label"] = r"$\frac{"
    _, said = draws(program, study, os.path.join(folder, "not-finite"))
    assert said.count("not a finite number") == 2, said


def test_refusals(program, folder):
    path = os.path.join(folder, "study.h5")
    refuses(program, folder, "is a folder")
    with open(path, "w", encoding="ascii") as file:
        file.write("h,e_error\n")
    refuses(program, path, path, "not an HDF5 file")
    write_study(path)
    with open(path, "rb+") as file:
        size = file.seek(0, os.SEEK_END) - 512
        file.seek(512)
        file.write(b"\xa5" * size)
    refuses(program, path, path, "damaged")
    write_study(path)
    refuses(program, path, "is not a folder; name another one with -o", options=("-o", os.path.join(path, "inside-a-file")))
    style, trouble = importlib.import_module("plot.style"), importlib.import_module("plot.trouble")
    try:
        style.write(b"", os.path.join(path, "inside-a-file", "page.md"))    # as pages do, which have no -o
        assert False, "written into a file"
    except trouble.Trouble as said:
        assert str(said).endswith("is not a folder; name another one"), said
    os.remove(path)
    n = 4 * len(LADDER)
    refuses_damage(program, path, write_study,
                   ("runs", "orders", "series", "runs/h", "runs/stepper", "runs/h1_error", "orders/log2_constant",
                    "series/000005/t", "series/000005/energy_error"),
                   ("scene", "t_end", "energy0", "norm_squared", "vti_version"),
                   [("runs/h", LADDER, "/runs/h has 10 rows"), ("runs/h", np.zeros(n), "not positive"),
                    ("runs/e_error", texts(["x"] * n, False), "/runs/e_error does not hold numbers"),
                    ("runs/e_error", np.zeros((n, 2)), "not one-dimensional"),
                    ("runs/scene", texts(["pendulum", "torus"] * (n // 2), False), "mixes the scenes pendulum, torus"),
                    ("series/000005/angular_z", np.zeros(3), "/series/000005/angular_z has 3 values")])


def test_intervals(_program, _folder):
    """An interval is rounded up to one digit, and the value to the same place: no figure claims more than the fit."""
    words = importlib.import_module("plot.words")
    for value, interval, text in ((1.9912, 0.0312, "1.99 ± 0.04"), (1.9912, 0.0951, "2.0 ± 0.1"), (2.00000123, 3e-8, "2.00000 ± 0.00001"),
                                  (2.0, 0.0, "2.00000 ± 0.00001"), (0.9985, 0.00011, "0.9985 ± 0.0002"), (2.1, 0.3, "2.1 ± 0.3"),
                                  (0.07, 0.07, "0.07 ± 0.07"), (4.319, 0.92, "4 ± 1"), (1.5, 3.2, "2 ± 4"), (1.5, np.inf, "1.50")):
        assert words.with_interval(value, interval) == text, (value, interval, words.with_interval(value, interval))
    assert [words.plain_number(value) for value in (0.0099, 9.96, 99.4, 99.6, 123.4, 999.7, 2e4)] == [
        "9.9e-03", "10", "99", "100", "123", "1000", "2.0e+04"]
    assert words.order_text({"order": 2.04, "interval": 0.61}) == "not resolved (2.0 ± 0.7)" and words.order_text(None) == "no fit"


def test_looks(_program, _folder):
    """The paper's steppers look the same in every study; no two of fifty look alike."""
    style = importlib.import_module("plot.style")
    own = style.looks(["vti3", "vti1"])
    many = style.looks(["vti1", "vti2", "vti3", "vti3-leapfrog", *(f"other{k}" for k in range(46))])
    assert own["vti3"] == many["vti3"] == style.LOOKS[2] and own["vti1"] == many["vti1"] == style.LOOKS[0] and many["vti2"] == style.LOOKS[1]
    assert len({(look.colour, look.marker) for look in many.values()}) == 50, many


def test_help(program, _folder):
    done = apart(program, "-h")
    assert done.returncode == 0 and "study.h5" in done.stdout and "convergence.png" in done.stdout, done.stdout
    assert apart(program).returncode == 2, "no argument, no complaint"
    left_alone(program, "-h")


if __name__ == "__main__":
    plot_support.main(test_help, test_intervals, test_looks, test_pictures, test_fitted_lines, test_points, test_chosen, test_peaks, test_ensemble,
                      test_lost, test_edges, test_refusals)
