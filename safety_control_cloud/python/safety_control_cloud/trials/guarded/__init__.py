# SPDX-License-Identifier: BSD-3-Clause
"""Drives by somebody else, with a guard between him and the base. Read `drive.py` first; `truth.py` is what it is judged by."""
