# SPDX-License-Identifier: BSD-3-Clause
"""Mode guard on a recorded drive: `inputs` finds what it is given, `drive` is one guard in the bag's time, `reading` hands it a bag."""
