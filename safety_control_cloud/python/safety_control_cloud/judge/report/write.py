# SPDX-License-Identifier: BSD-3-Clause
"""The page itself."""
from __future__ import annotations

import argparse
from html import escape
from pathlib import Path
from typing import Any, Dict, List, Optional, Sequence, Tuple

from safety_control_cloud import core
from safety_control_cloud.judge.compare import Difference
from safety_control_cloud.judge.report.charts import COLOURS, histogram
from safety_control_cloud.judge.report.facts import Call, Facts, facts_of
from safety_control_cloud.judge.report.page import BAGS, CHANGES, bars, names_of, table, write_page
from safety_control_cloud.judge.report.pictures import picture_of
from safety_control_cloud.judge.replay_line import replay_line
from safety_control_cloud.judge.rows import BagRow
from safety_control_cloud.judge.say import summary_of
from safety_control_cloud.judge.store import Store


def write_report(
    given: argparse.Namespace, store: Store, rows: Sequence[BagRow], judged_by: Sequence[Tuple[str, core.Settings]],
    changes: Optional[Sequence[Difference]] = None,
) -> Path:
    """`judged_by`: hash and settings, one or two. Gives the path of the page. Raises OSError."""
    names, parts = names_of(given), []
    for place, (name, (number, settings)) in enumerate(dict(zip(names, judged_by)).items()):
        its = [row for row in rows if row.settings == number]
        facts = facts_of(store, its, number)
        parts.append(f"<h2>{escape(name)}</h2><p>{escape(summary_of(its))}</p>")
        parts += [_bags(its), "<h2>Zones over time</h2>", _timelines(facts, its), "<h2>Distance of the nearest obstacle</h2>",
                  histogram(facts.histogram), "<h2>The nearest calls</h2>", _calls(facts.calls, settings, given, place)]
    if changes is not None:
        parts.append(_changes(changes, given, names))
    return write_page(given, parts)


def _bags(rows: Sequence[BagRow]) -> str:
    causes = sorted({name for row in rows for name in row.causes})
    names = ("bag", "clouds", "silences", *COLOURS, "nearest [m]", *causes)
    return table("bags", names, [_bag(row, causes) for row in rows], BAGS)


def _bag(row: BagRow, causes: Sequence[str]) -> str:
    if row.status == "error":
        return f'<tr><td>{escape(row.path)}</td><td class="error" colspan="{6 + len(causes)}">{escape(row.error or "")}</td></tr>'
    figures = [row.clouds, row.silences, *(row.zones.get(zone, 0) for zone in COLOURS)]
    nearest = "-" if row.nearest is None else f"{row.nearest:.2f}"
    cells = [*map(str, figures), nearest, *(str(row.causes.get(cause, "")) for cause in causes)]
    return f"<tr><td>{escape(row.path)}</td>{''.join(f'<td>{cell}</td>' for cell in cells)}</tr>"


def _timelines(facts: Facts, rows: Sequence[BagRow]) -> str:
    """Of the bags with most Danger."""
    return bars(facts.stretches, sorted(rows, key=lambda row: (-row.zones.get("Danger", 0), row.path)))


def _calls(calls: Sequence[Call], settings: core.Settings, given: argparse.Namespace, place: int) -> str:
    return f'<div class="calls">{"".join(_call(call, settings, given, place) for call in calls)}</div>'


def _call(call: Call, settings: core.Settings, given: argparse.Namespace, place: int) -> str:
    row, picture = call.row, picture_of(call, settings)
    shown = f'<img alt="what the camera saw" src="{picture}">' if picture else "<p>(the bag is not to be had from here)</p>"
    command = replay_line(call.path, given, place, "--topic", row["topic"], "--around", str(row["number"]))
    return (f'<div class="call">{shown}<p><span class="zone" style="color:{COLOURS[row["zone"]]}">{row["nearest"]:.3f} m, '
            f'{row["zone"]}, {row["cause"]}</span>, {row["speed"]:g} m/s: {escape(row["reason"])}</p>'
            f"<p>{escape(call.path)} cloud {row['number']}</p><p><code>{escape(command)}</code></p></div>")


def _changes(changes: Sequence[Difference], given: argparse.Namespace, names: Sequence[str]) -> str:
    clouds = sum(one.length for one in changes)
    lines: List[str] = []
    for one in changes[:CHANGES]:
        said = "".join(f'<td class="text">{_said(verdict)}</td>' for verdict in (one.before, one.after))
        last = one.number + one.length - 1
        numbers = str(one.number) if one.length == 1 else f"{one.number} to {last}"
        lines.append(f'<tr><td>{escape(one.path)}</td><td>{numbers}</td>{said}'
                     f'<td class="text"><code>{escape(one.command(given))}</code></td></tr>')
    return (f"<h2>What changes</h2><p>{clouds:,} clouds and silences are decided differently.</p>"
            + table("changes", ("bag", "clouds", *names, "to look at it"), lines, CHANGES))


def _said(verdict: Optional[Dict[str, Any]]) -> str:
    return "nothing" if verdict is None else escape(f"{verdict['zone']}, {verdict['cause']}, {verdict['speed']:g} m/s")
