# SPDX-License-Identifier: BSD-3-Clause
"""What the page of either mode is made of."""
from __future__ import annotations

import argparse
import shlex
from datetime import datetime, timezone
from html import escape
from pathlib import Path
from typing import List, Sequence

from safety_control_cloud.judge.report.charts import timelines
from safety_control_cloud.judge.table import AnyBag

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


def names_of(given: argparse.Namespace) -> List[str]:
    """Of the settings, one or two."""
    return [str(file) for file in given.compare] if given.compare else [str(given.settings or "default settings")]


def write_page(given: argparse.Namespace, parts: Sequence[str]) -> Path:
    """Raises OSError."""
    when = datetime.now(timezone.utc).strftime("%Y-%m-%d %H:%M UTC")
    head = f"<h1>Judged: {escape(', '.join(given.bags))}</h1><p>{when}, by <code>{escape(_command(given))}</code></p>"
    page = given.report / "index.html"
    page.write_text('<!doctype html><html lang="en"><head><meta charset="utf-8"><title>Judged drives</title>'
                    f"<style>{STYLE}</style></head><body>{head}{''.join(parts)}</body></html>\n")
    return page


def bars(stretches: dict, rows: Sequence[AnyBag]) -> str:
    """Of the first bags that were judged to their end."""
    shown = [row for row in rows if row.start is not None and row.end is not None][:TIMELINES]
    return timelines(stretches, {row.path: (row.start or 0, row.end or 0) for row in shown})


def table(kind: str, names: Sequence[str], lines: Sequence[str], most: int) -> str:
    head = "".join(f"<th>{escape(name)}</th>" for name in names)
    more = f"<p>... and {len(lines) - most} more</p>" if len(lines) > most else ""
    return f'<table class="{kind}"><tr>{head}</tr>{"".join(lines[:most])}</table>{more}'


def _command(given: argparse.Namespace) -> str:
    words = ["scripts/judge", *given.bags]
    for option in ("mode", "settings", "cmd_vel", "odom"):
        value = getattr(given, option)
        words += [f"--{option.replace('_', '-')}", str(value)] if value else []
    for topic in given.topic:
        words += ["--topic", topic]
    for name, value in given.param:
        words += ["--param", f"{name}={value}"]
    if given.compare:
        words += ["--compare", *map(str, given.compare)]
    return " ".join(map(shlex.quote, words))
