# SPDX-License-Identifier: BSD-3-Clause
"""Drawings of the page, as SVG."""
from __future__ import annotations

from html import escape
from typing import Dict, List, Sequence, Tuple

from safety_control_cloud.judge.report.facts import BIN, FARTHEST
from safety_control_cloud.zone_colours import DRAWN as COLOURS

INK, QUIET = "#22303c", "#8795a1"
WIDTH, BAR, NAME = 900, 22, 260  # [px]


def timelines(stretches: Dict[str, List[Tuple[int, str]]], ends: Dict[str, Tuple[int, int]]) -> str:
    """A bar for each bag, from its first cloud [ns] to its end, in the colours of its zones; all in one scale."""
    longest = max([(end - start) for start, end in ends.values()] or [1]) or 1
    rows = []
    for number, (path, (start, end)) in enumerate(ends.items()):
        y = number * BAR
        rows.append(f'<text x="{NAME - 8}" y="{y + 15}" text-anchor="end">{escape(_short(path))}</text>')
        changes = [*stretches.get(path, ()), (end, "")]
        for (at, zone), (until, _) in zip(changes, changes[1:]):
            x, wide = NAME + (at - start) / longest * WIDTH, max((until - at) / longest * WIDTH, 0.5)
            rows.append(f'<rect x="{x:.1f}" y="{y + 3}" width="{wide:.1f}" height="{BAR - 6}" fill="{COLOURS[zone]}">'
                        f"<title>{zone} from {(at - start) / 1e9:.2f} s to {(until - start) / 1e9:.2f} s</title></rect>")
    height = len(ends) * BAR
    axis = "".join(f'<text x="{NAME + part * WIDTH}" y="{height + 14}" text-anchor="middle" fill="{QUIET}">'
                   f"{part * longest / 1e9:.1f} s</text>" for part in (0, 0.25, 0.5, 0.75, 1))
    return _svg(NAME + WIDTH + 40, height + 20, "".join(rows) + axis, "timelines")


def histogram(counts: Dict[str, Sequence[int]]) -> str:
    """Clouds by the distance of the nearest obstacle, stacked by zone."""
    bins = len(next(iter(counts.values())))
    totals = [sum(its[place] for its in counts.values()) for place in range(bins)]
    most, wide, height = max([*totals, 1]), WIDTH / bins, 180
    bars = []
    for place in range(bins):
        y = float(height)
        for zone in ("Danger", "Warning", "Safe"):
            tall = counts[zone][place] / most * (height - 10)
            y -= tall
            if tall:
                what = f"{place * BIN:.1f} m: {zone} {counts[zone][place]}"
                bars.append(f'<rect x="{60 + place * wide:.1f}" y="{y:.1f}" width="{wide - 1:.1f}" height="{tall:.1f}" '
                            f'fill="{COLOURS[zone]}"><title>{what}</title></rect>')
    ticks = "".join(f'<text x="{60 + metre / BIN * wide:.1f}" y="{height + 15}" text-anchor="middle" fill="{QUIET}">{metre} m'
                    f'{" and more" if metre == FARTHEST else ""}</text>' for metre in range(int(FARTHEST) + 1))
    scale = f'<text x="52" y="14" text-anchor="end" fill="{QUIET}">{most:,}</text>'
    return _svg(WIDTH + 140, height + 22, "".join(bars) + ticks + scale, "histogram")


def _short(path: str) -> str:
    return path if len(path) < 36 else "..." + path[-33:]


def _svg(width: float, height: float, content: str, kind: str) -> str:
    return (f'<svg class="{kind}" viewBox="0 0 {width:.0f} {height:.0f}" width="{width:.0f}" height="{height:.0f}" '
            f'font-family="sans-serif" font-size="12" fill="{INK}">{content}</svg>')
