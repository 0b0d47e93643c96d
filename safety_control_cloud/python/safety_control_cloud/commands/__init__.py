# SPDX-License-Identifier: BSD-3-Clause
"""The command lines of the simulation's nodes: each parses its arguments and makes one call."""
