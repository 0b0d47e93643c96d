# SPDX-License-Identifier: BSD-3-Clause
"""Recorded clouds through the real node, one at a time: `bags` reads, `lockstep` asks, `report` and `plot` show."""
