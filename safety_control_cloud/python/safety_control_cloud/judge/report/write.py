# SPDX-License-Identifier: BSD-3-Clause
"""The page itself."""
from __future__ import annotations

import argparse
import shlex
from datetime import datetime, timezone
from html import escape
from pathlib import Path
from typing import Any, Dict, List, Optional, Sequence, Tuple

from safety_control_cloud import core
from safety_control_cloud.judge.compare import Difference
from safety_control_cloud.judge.report.charts import COLOURS, histogram, timelines
from safety_control_cloud.judge.report.facts import Call, Facts, facts_of
from safety_control_cloud.judge.report.pictures import picture_of
from safety_control_cloud.judge.rows import BagRow
from safety_control_cloud.judge.say import summary_of
from safety_control_cloud.judge.store import Store

TIMELINES, BAGS, CHANGES = 60, 500, 100  # shown at most; the Parquet files have all
STYLE = """
body { font: 15px/1.45 sans-serif; color: #22303c; margin: 2em auto; max-width: 1240px; padding: 0 1em; }
h1 { font-size: 1.5em; } h2 { font-size: 1.15em; margin-top: 2em; }
table { border-collapse: collapse; } th, td { padding: 2px 10px; text-align: right; border-bottom: 1px solid #e4e9ed; }
th:first-child, td:first-child, td.text { text-align: left; } td.error { color: #b3261e; text-align: left; }
code { background: #f1f4f6; padding: 1px 4px; font-size: 12px; word-break: break-all; }
.calls { display: grid; grid-template-columns: repeat(auto-fill, minmax(330px, 1fr)); gap: 16px; }
.call img { width: 100%; image-rendering: pixelated; border-radius: 4px; } .call p { margin: 4px 0; }
.zone { font-weight: bold; } svg { max-width: 100%; height: auto; }
"""


def write_report(
    given: argparse.Namespace, store: Store, rows: Sequence[BagRow], judged_by: Sequence[Tuple[str, core.Settings]],
    changes: Optional[Sequence[Difference]] = None,
) -> Path:
    """`judged_by`: hash and settings, one or two. Gives the path of the page. Raises OSError."""
    names = [str(file) for file in given.compare] if given.compare else [str(given.settings or "default settings")]
    when = datetime.now(timezone.utc).strftime("%Y-%m-%d %H:%M UTC")
    parts = [f"<h1>Judged: {escape(', '.join(given.bags))}</h1>", f"<p>{when}, by <code>{escape(_command(given))}</code></p>"]
    for name, (number, settings) in dict(zip(names, judged_by)).items():
        its = [row for row in rows if row.settings == number]
        facts = facts_of(store, its, number)
        parts.append(f"<h2>{escape(name)}</h2><p>{escape(summary_of(its))}</p>")
        parts += [_bags(its), "<h2>Zones over time</h2>", _timelines(facts, its), "<h2>Distance of the nearest obstacle</h2>",
                  histogram(facts.histogram), "<h2>The nearest calls</h2>", _calls(facts.calls, settings, name if given.compare or given.settings else None)]
    if changes is not None:
        parts.append(_changes(changes, names))
    page = given.report / "index.html"
    title = "Judged drives"
    page.write_text(f'<!doctype html><html lang="en"><head><meta charset="utf-8"><title>{title}</title>'
                    f"<style>{STYLE}</style></head><body>{''.join(parts)}</body></html>\n")
    return page


def _command(given: argparse.Namespace) -> str:
    words = ["scripts/judge", *given.bags]
    if given.settings:
        words += ["--settings", str(given.settings)]
    for name, value in given.param:
        words += ["--param", f"{name}={value}"]
    if given.compare:
        words += ["--compare", *map(str, given.compare)]
    return " ".join(map(shlex.quote, words))


def _bags(rows: Sequence[BagRow]) -> str:
    causes = sorted({name for row in rows for name in row.causes})
    head = "".join(f"<th>{escape(name)}</th>" for name in ("bag", "clouds", "silences", *COLOURS, "nearest [m]", *causes))
    lines = [_bag(row, causes) for row in rows[:BAGS]]
    more = f"<p>... and {len(rows) - BAGS} more</p>" if len(rows) > BAGS else ""
    return f'<table class="bags"><tr>{head}</tr>{"".join(lines)}</table>{more}'


def _bag(row: BagRow, causes: Sequence[str]) -> str:
    if row.status == "error":
        return f'<tr><td>{escape(row.path)}</td><td class="error" colspan="{6 + len(causes)}">{escape(row.error or "")}</td></tr>'
    figures = [row.clouds, row.silences, *(row.zones.get(zone, 0) for zone in COLOURS)]
    nearest = "-" if row.nearest is None else f"{row.nearest:.2f}"
    cells = [*map(str, figures), nearest, *(str(row.causes.get(cause, "")) for cause in causes)]
    return f"<tr><td>{escape(row.path)}</td>{''.join(f'<td>{cell}</td>' for cell in cells)}</tr>"


def _timelines(facts: Facts, rows: Sequence[BagRow]) -> str:
    """Of the bags with most Danger."""
    judged = [row for row in rows if row.start is not None and row.end is not None]
    most = sorted(judged, key=lambda row: (-row.zones.get("Danger", 0), row.path))[:TIMELINES]
    return timelines(facts.stretches, {row.path: (row.start or 0, row.end or 0) for row in most})


def _calls(calls: Sequence[Call], settings: core.Settings, file: Optional[str]) -> str:
    return f'<div class="calls">{"".join(_call(call, settings, file) for call in calls)}</div>'


def _call(call: Call, settings: core.Settings, file: Optional[str]) -> str:
    row, picture = call.row, picture_of(call, settings)
    shown = f'<img alt="what the camera saw" src="{picture}">' if picture else "<p>(the bag is not to be had from here)</p>"
    words = ["scripts/replay", call.path, "--topic", row["topic"], "--around", str(row["number"])]
    words += ["--settings", file] if file else []
    command = " ".join(map(shlex.quote, words))
    return (f'<div class="call">{shown}<p><span class="zone" style="color:{COLOURS[row["zone"]]}">{row["nearest"]:.3f} m, '
            f'{row["zone"]}, {row["cause"]}</span>, {row["speed"]:g} m/s: {escape(row["reason"])}</p>'
            f"<p>{escape(call.path)} cloud {row['number']}</p><p><code>{escape(command)}</code></p></div>")


def _changes(changes: Sequence[Difference], names: Sequence[str]) -> str:
    clouds = sum(one.length for one in changes)
    head = "".join(f"<th>{escape(name)}</th>" for name in ("bag", "clouds", *names, "to look at it"))
    lines: List[str] = []
    for one in changes[:CHANGES]:
        said = "".join(f'<td class="text">{_said(verdict)}</td>' for verdict in (one.before, one.after))
        last = one.number + one.length - 1
        numbers = str(one.number) if one.length == 1 else f"{one.number} to {last}"
        lines.append(f'<tr><td>{escape(one.path)}</td><td>{numbers}</td>{said}'
                     f'<td class="text"><code>{escape(one.command(names[1]))}</code></td></tr>')
    return (f"<h2>What changes</h2><p>{clouds:,} clouds and silences are decided differently.</p>"
            f'<table class="changes"><tr>{head}</tr>{"".join(lines)}</table>')


def _said(verdict: Optional[Dict[str, Any]]) -> str:
    return "nothing" if verdict is None else escape(f"{verdict['zone']}, {verdict['cause']}, {verdict['speed']:g} m/s")
