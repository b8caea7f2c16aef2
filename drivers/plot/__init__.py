# SPDX-License-Identifier: BSD-3-Clause
"""What vti-plot draws: one module per picture, plus reading (study_file), looks (style) and wording (words)."""
import logging
import os

# Before matplotlib is imported by whatever module. A user's settings, which may even be broken, must not change the
# bytes of a picture.
os.environ.update(MPLBACKEND="Agg", MATPLOTLIBRC=os.devnull)
logging.getLogger("matplotlib").setLevel(logging.ERROR)     # it warns where there is no home to keep its fonts' list in
