# SPDX-License-Identifier: BSD-3-Clause
"""Memory of this process."""
from __future__ import annotations

import ctypes
from functools import lru_cache

TRIM_THRESHOLD, MMAP_THRESHOLD = -1, -3  # mallopt's numbers for them, in malloc.h
KEPT, LARGEST = 1 << 28, 1 << 25  # [byte]; glibc takes no more for the second


@lru_cache(maxsize=None)
def keep_freed_memory() -> None:
    """A cloud takes the memory of the one before: fresh pages for each cost more than reading it does."""
    try:
        mallopt = ctypes.CDLL(None).mallopt
    except (OSError, AttributeError):
        return  # another C library than glibc
    mallopt(TRIM_THRESHOLD, KEPT)
    mallopt(MMAP_THRESHOLD, LARGEST)
