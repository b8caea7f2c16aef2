# SPDX-License-Identifier: BSD-3-Clause
"""The one exception by which the package refuses to go on."""


class Trouble(Exception):
    """Something the user can mend. Reads `FILE: problem; remedy`, always on one line."""

    def __init__(self, path, problem, remedy):
        super().__init__(" ".join(f"{path}: {problem}; {remedy}".split()))
