# SPDX-License-Identifier: BSD-3-Clause
"""The bar with the time left that a terminal shows, as those of vti-run and vti-study; nothing where there is none."""
import os
import sys
import time

WIDTH, LINE = 40, 79    # characters of the bar, and of all that is cleared
EVERY = 0.1             # seconds


class Bar:
    def __init__(self):
        self.shown = None
        self.terminal = os.environ.get("VTI_TERMINAL") != "0" and sys.stderr is not None and sys.stderr.isatty()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.shown is not None:
            print("\r" + " " * LINE + "\r", end="", file=sys.stderr, flush=True)

    def over(self, things, count):
        """The things one by one, of which there are so many."""
        start = time.monotonic()
        for done, thing in enumerate(things, 1):
            yield thing
            self._show(done / count, time.monotonic() - start)

    def _show(self, share, seconds):
        now = time.monotonic()
        if not self.terminal or self.shown is not None and now - self.shown < EVERY:
            return
        self.shown = now
        bar = "#" * int(share * WIDTH)
        print(f"\r[{bar:.<{WIDTH}}] {100 * share:3.0f} %  {_left(seconds * (1 - share) / share)} left   ",
              end="", file=sys.stderr, flush=True)


def _left(seconds):
    if seconds < 100:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 6000 else f"{seconds / 3600:.3g} h"
