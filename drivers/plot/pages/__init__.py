# SPDX-License-Identifier: BSD-3-Clause
"""Pages of ./dev figures (figures) and ./dev cost (accuracy), with their pictures and sentences."""
