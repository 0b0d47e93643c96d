# SPDX-License-Identifier: BSD-3-Clause
"""The page of mode guard: what became of the commands of each bag, and when."""
from __future__ import annotations

import argparse
from html import escape
from itertools import groupby
from operator import itemgetter
from pathlib import Path
from typing import Dict, List, Optional, Sequence, Tuple

from safety_control_cloud.judge.guard.compare import Difference
from safety_control_cloud.judge.guard.rows import GuardedBag
from safety_control_cloud.judge.guard.say import FIGURES, by_time, cells_of, command, moment_of, short, summary_of
from safety_control_cloud.judge.report.page import BAGS, CHANGES, TIMELINES, bars, names_of, table, write_page
from safety_control_cloud.judge.store import Store
from safety_control_cloud.judge.table import rows_in


def write_guarded(
    given: argparse.Namespace, store: Store, rows: Sequence[GuardedBag], hashes: Sequence[str],
    changes: Optional[Sequence[Difference]] = None,
) -> Path:
    """`hashes` of the settings, one or two. Gives the path of the page. Raises OSError."""
    parts: List[str] = []
    names = names_of(given)
    for place, (name, number) in enumerate(dict(zip(names, hashes)).items()):
        its = by_time([row for row in rows if row.settings == number])
        parts.append(f"<h2>{escape(name)}</h2><p>{escape(summary_of(its))}</p>")
        parts.append(table("bags", ("bag", *FIGURES, "causes"), [_bag(row) for row in its], BAGS))
        parts += ["<h2>What passes (green), is scaled or stopped, over time</h2>", bars(_stretches(store, its[:TIMELINES]), its),
                  "<h2>Where less is given than wanted</h2>", _stops(its, given, place)]
    if changes is not None:
        parts.append(_changes(changes, given, names))
    return write_page(given, parts)


def _bag(row: GuardedBag) -> str:
    path, *figures, causes = map(escape, cells_of(row))
    if row.status == "error":
        return f'<tr><td>{path}</td><td class="error" colspan="{len(FIGURES) + 1}">{escape(row.error or "")}</td></tr>'
    return f'<tr><td>{path}</td>{"".join(f"<td>{cell}</td>" for cell in figures)}<td class="text">{causes}</td></tr>'


def _stretches(store: Store, rows: Sequence[GuardedBag]) -> Dict[str, List[Tuple[int, str]]]:
    """By path: from when on [ns] which zone."""
    found = {}
    for row in rows:
        if row.bag:
            answers = rows_in(store.file_of(row.bag, row.settings), ("time", "zone"))
            found[row.path] = [(next(its)["time"], zone) for zone, its in groupby(answers, key=itemgetter("zone"))]
    return found


def _stops(rows: Sequence[GuardedBag], given: argparse.Namespace, place: int) -> str:
    lines = [f'<tr><td>{escape(row.path)}</td><td>{moment_of(row)}</td><td class="text">{escape(_why(row))}</td>'
             f'<td class="text"><code>{escape(command(row.path, given, place))}</code></td></tr>'
             for row in rows[:CHANGES] if row.differs_at is not None]
    return table("stops", ("bag", "first [s]", "cause", "to look at it"), lines, CHANGES)


def _why(row: GuardedBag) -> str:
    return f"{row.differs_cause}{f' by {row.differs_sensor}' if row.differs_sensor else ''}"


def _changes(changes: Sequence[Difference], given: argparse.Namespace, names: Sequence[str]) -> str:
    lines = []
    for one in changes[:CHANGES]:
        said = "".join(f'<td class="text">{escape(short(its))}</td>' for its in (one.before, one.after))
        lines.append(f"<tr><td>{escape(one.path)}</td><td>{(one.time - one.start) / 1e9:.3f}</td>{said}<td>{one.lasting / 1e9:.1f}</td>"
                     f'<td class="text"><code>{escape(command(one.path, given))}</code></td></tr>')
    return (f"<h2>What changes</h2><p>{len(changes):,} bags are guarded differently.</p>"
            + table("changes", ("bag", "first [s]", *names, "for [s]", "to look at it"), lines, CHANGES))
