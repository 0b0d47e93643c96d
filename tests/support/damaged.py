# SPDX-License-Identifier: BSD-3-Clause
"""Messages whose serialised bytes are damaged on their way."""
from io import BytesIO
from typing import Callable

import genpy


def damaged(message: genpy.Message, damage: Callable[[bytes], bytes]) -> genpy.Message:
    """The same message, but `damage` is done to its bytes whenever it is serialised."""

    class Damaged(type(message)):
        def serialize(self, buff):
            whole = BytesIO()
            super().serialize(whole)
            buff.write(damage(whole.getvalue()))

    return Damaged(*(getattr(message, name) for name in message.__slots__))


def cut_short(whole: bytes) -> bytes:
    return whole[:-100]
