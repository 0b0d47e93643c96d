# SPDX-License-Identifier: BSD-3-Clause
"""The command lines of scripts/: each parses its arguments and makes one call."""
