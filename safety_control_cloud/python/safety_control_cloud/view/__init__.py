# SPDX-License-Identifier: BSD-3-Clause
"""A drive to look at, in the Rerun viewer: `moment` is what is shown, `entities` what is logged of it, `sink` where to.

No ROS: replay, demo, trials and the node of view.launch hand over moments.
"""
