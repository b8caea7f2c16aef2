# SPDX-License-Identifier: BSD-3-Clause
"""How pictures look and how they are written: the same colours and markers everywhere, the same bytes every time."""
import io
import os
from dataclasses import dataclass

import matplotlib
import numpy as np
from PIL import Image  # with it matplotlib itself writes PNG
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, FuncFormatter, LogFormatterMathtext, NullLocator

from .trouble import Trouble

WIDTH = 10.67       # inches; 1600 pixels at DPI
DPI = 150
LARGEST = 300_000   # bytes of a PNG
LETTERS = 165       # of a line below a picture

matplotlib.rcdefaults()
matplotlib.rcParams.update({
    "font.family": "DejaVu Sans",
    "font.size": 9.5,
    "axes.titlesize": 10.5,
    "axes.labelsize": 10,
    "figure.titlesize": 13,
    "legend.fontsize": 9.5,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "grid.color": "#e4e4e4",
    "grid.linewidth": 0.6,
    "axes.axisbelow": True,
    "axes.linewidth": 0.8,
    "legend.frameon": False,
})

GREY = "#555555"


@dataclass(frozen=True)
class Look:
    colour: str
    marker: str
    size: float     # markers of equal size differ in area; these look equal
    line: str = "--"    # dashes let a line show through that lies below, as VTI-2 below VTI-3 leapfrog


# The paper's markers (circle, triangle down, square) with the palette of Okabe and Ito, then three darker colours of
# Tol's "muted" scheme. Yellow is left out: it does not show on white.
LOOKS = (Look("#0072B2", "o", 7, "-"), Look("#D55E00", "v", 7.5, "-"), Look("#009E73", "s", 6.5, "-"),
         Look("#AA4499", "D", 6.5), Look("#E69F00", "^", 7.5), Look("#56B4E9", "P", 7.5), Look("#000000", "X", 7.5),
         Look("#882255", "<", 7.5), Look("#999933", ">", 7.5), Look("#332288", "p", 8))
OWN_LOOK = {"vti1": 0, "vti2": 1, "vti3": 2, "vti3-leapfrog": 3, "leapfrog": 3}


def looks(steppers):
    """The same look for the same stepper in every picture of a study, and in every study for the paper's own."""
    taken = {OWN_LOOK[key] for key in steppers if key in OWN_LOOK}
    free = [i for i in range(len(LOOKS)) if i not in taken and i > 3] + [i for i in range(4) if i not in taken]
    chosen, others = {}, 0
    for key in steppers:
        if key in OWN_LOOK:
            chosen[key] = LOOKS[OWN_LOOK[key]]
            continue
        if others < len(free):
            chosen[key] = LOOKS[free[others]]
        else:   # beyond ten: colours and markers recombine, each pair once in a hundred
            turn = others - len(free)
            marker = LOOKS[(turn + 1 + turn // len(LOOKS)) % len(LOOKS)]
            chosen[key] = Look(LOOKS[turn % len(LOOKS)].colour, marker.marker, marker.size)
        others += 1
    return chosen


def new_figure(height, width=WIDTH):
    figure = Figure(figsize=(width, height), dpi=DPI, layout="constrained")
    FigureCanvasAgg(figure)
    figure.set_constrained_layout_pads(w_pad=0.09, h_pad=0.06)
    return figure


def bare(axes):
    """A place for a legend or a note alone."""
    axes.set_axis_off()
    return axes


def log_axis(axis, low, high, base=10):
    """Limits and ticks: two labels at least if the ends are a factor of five or more apart, eight or so at most."""
    axis.axes.set(**{f"{axis.axis_name}scale": "log", f"{axis.axis_name}lim": (low, high)})
    axis.set_minor_locator(NullLocator())
    span = (np.log(high) - np.log(low)) / np.log(base)
    if base == 2 or span > 2:
        every = max(1, int(np.ceil(span / 8)))
        powers = np.arange(np.ceil(np.log(low) / np.log(base) - 1e-9), np.floor(np.log(high) / np.log(base) + 1e-9) + 1)
        axis.set_major_locator(FixedLocator(float(base) ** powers[powers % every == 0]))
        axis.set_major_formatter(LogFormatterMathtext(base=base, labelOnlyBase=True))
    else:
        factors = (1, 2, 5) if span < 1.3 else (1, 3)
        values = np.outer(10.0 ** np.arange(np.floor(np.log10(low)), np.log10(high)), factors)
        axis.set_major_locator(FixedLocator(values[(values >= low) & (values <= high)]))
        axis.set_major_formatter(FuncFormatter(_mantissa_and_power))


def _mantissa_and_power(value, _position):
    power = int(np.floor(np.log10(value) + 1e-9))
    mantissa = round(value / 10.0**power)
    factor = "" if mantissa == 1 else rf"{mantissa}\times "
    return rf"${factor}10^{{{power}}}$"


def below(sentences):
    """For below a picture: in lines as wide as it is, sentence by sentence."""
    lines = []
    for sentence in sentences:
        if lines and len(lines[-1]) + 2 + len(sentence) <= LETTERS:
            lines[-1] += "  " + sentence
        else:
            lines.append(sentence)
    return "\n".join(lines)


def save(figure, path, option=""):
    write(_png(figure), path, option)


def write(content, path, option=""):
    """All of it or nothing: it is made in memory, written beside its place under a name that nothing has, and then
    moved there. Links stay, and what they lead to is replaced, as vti-run does. option: " with -o" where the program
    has it for another folder."""
    place = os.path.realpath(path)
    partial = f"{place}.{os.getpid()}.part"
    try:
        os.makedirs(os.path.dirname(path) or os.curdir, exist_ok=True)
        with open(partial, "xb") as file:
            file.write(content)
        os.replace(partial, place)
    except (FileExistsError, NotADirectoryError):
        raise Trouble(os.path.dirname(path), "is not a folder", f"name another one{option}") from None
    except OSError as error:
        if os.path.isfile(partial):
            os.remove(partial)
        raise Trouble(path, f"cannot be written ({error.strerror})", f"name a folder you may write to{option}") from None


def _png(figure):
    """Without the software's name, version and date, which would make the bytes differ, and with a palette of 256
    colours: the eye sees no difference in lines and letters, and it is a third of the weight. A picture still too
    heavy is drawn smaller."""
    dpi = DPI
    while True:
        figure.set_dpi(dpi)
        figure.canvas.draw()
        picture = Image.fromarray(np.asarray(figure.canvas.buffer_rgba())[..., :3])
        memory = io.BytesIO()
        picture.quantize(256, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE).save(
            memory, "PNG", optimize=True, dpi=(dpi, dpi))
        if memory.tell() < LARGEST or dpi < 40:
            return memory.getvalue()
        heavy = memory.tell() / LARGEST
        dpi *= 0.9
        while dpi >= 40 and heavy * (dpi / figure.dpi) ** 2 > 1.2:     # it weighs no less than its area; that saves drawing it
            dpi *= 0.9
