# SPDX-License-Identifier: BSD-3-Clause
"""Mode guard on many bags: `reading` hands each to replay/guard, `rows` is what is written."""
