# SPDX-License-Identifier: BSD-3-Clause
"""How the energies of a run are shown: symbol, wording and colour, as its file says, the same in every picture."""
from dataclasses import dataclass

from . import words


@dataclass(frozen=True)
class Term:
    symbol: str
    meaning: str
    colour: str


OTHERS = ("#882255", "#777777", "#88CCEE")


def of(run, names):
    """name -> Term, in that order; a column of which the file does not say how it is shown has its own name."""
    unknown = [name for name in names if name not in run.looks]
    return {name: Term(*run.looks[name]) if name in run.looks
            else Term(words.plain(name.replace("_", " ")), "", OTHERS[unknown.index(name) % len(OTHERS)]) for name in names}
