# SPDX-License-Identifier: BSD-3-Clause
"""What the differential tests compare."""
from __future__ import annotations

from typing import Tuple

from safety_control_cloud import core


def facts_of(sight: core.Sight) -> Tuple[object, ...]:
    """All but the crop."""
    return (sight.nearest.point if sight.nearest else None, sight.inside, sight.too_close, sight.returns, sight.total)
