# SPDX-License-Identifier: BSD-3-Clause
"""What vti-plot draws: one module per picture, plus reading (study_file), looks (style) and wording (words)."""
