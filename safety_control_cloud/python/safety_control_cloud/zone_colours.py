# SPDX-License-Identifier: BSD-3-Clause
"""A zone's colour, the same wherever it is shown; needs Python alone."""
DRAWN = {"Safe": "#2e9e5b", "Warning": "#e8a317", "Danger": "#d64545"}
PRINTED = {"Safe": "green", "Warning": "yellow", "Danger": "red"}  # in a terminal, as rich calls them
WRITTEN = {"Safe": "#2e7d4f", "Warning": "#c77700", "Danger": "#c0322b"}  # dark enough for words on white
PALE = {"Safe": "#e3f1e8", "Warning": "#fdf0d9", "Danger": "#f9dfdd"}  # behind lines and words
