# SPDX-License-Identifier: BSD-3-Clause
"""The demo: the robot drives up to what stands before it and stops, twice; what happened is shown, judged and kept."""
