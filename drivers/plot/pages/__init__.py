# SPDX-License-Identifier: BSD-3-Clause
"""Pages of ./dev figures, cost (accuracy), bench (performance), granular, inertia and lammps (peers), with their
pictures and sentences. They are not installed."""
