# SPDX-License-Identifier: BSD-3-Clause
"""The summary as a page: table, histograms, and a picture of every collision of ours."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape
from math import isfinite
from pathlib import Path

from matplotlib.figure import Figure

from .families import scenario_of
from .outcome import Outcome
from .telling import draw_to
from .summary import is_collision, rows
from .table import HEADINGS, cells, verdict_of

STYLE = """body{font:15px/1.45 system-ui,sans-serif;color:#22303c;max-width:70rem;margin:2rem auto;padding:0 1rem}
table{border-collapse:collapse}td,th{padding:.2rem .6rem;text-align:right;border-bottom:1px solid #dfe4e8}
td:first-child,th:first-child,td:nth-child(2),th:nth-child(2){text-align:left}.bad{color:#d64545;font-weight:600}
img{max-width:100%}code{background:#f1f4f6;padding:.1rem .3rem}"""


def write_report(outcomes: Sequence[Outcome], folder: Path, made_by: str) -> Path:
    """index.html and its pictures; drives our collisions once more to draw them. `made_by`: command, seed and date."""
    folder.mkdir(parents=True, exist_ok=True)
    _draw_histograms(outcomes, folder / "histograms.png")
    collisions = [one for one in outcomes if one.collision and one.method == "ours"]
    avoidable = [one for one in collisions if is_collision(one)]
    parts = [
        "<h1>Drives in simulation</h1>", f"<p><code>{escape(made_by)}</code></p>",
        *(f"<p>{escape(line)}</p>" for line in verdict_of(outcomes)), _table(outcomes),
        '<h2>How they went</h2><img src="histograms.png" alt="histograms of clearance and of speed">',
        f"<h2>Our collisions: {len(avoidable)}, and {len(collisions) - len(avoidable)} at limits</h2>",
        *(_collision(one, folder) for one in collisions),
    ]
    return write_page(folder, parts)


def write_page(folder: Path, parts: Sequence[str]) -> Path:
    """index.html of these pieces of HTML."""
    page = folder / "index.html"
    page.write_text(f'<!doctype html><meta charset="utf-8"><title>Trials</title><style>{STYLE}</style>' + "\n".join(parts))
    return page


def table_in_html(headings: Sequence[str], lines: Iterable[tuple[Sequence[str], bool]]) -> str:
    """Each line has its cells, and whether it is bad."""
    head = "".join(f"<th>{heading}</th>" for heading in headings)
    body = ""
    for told, is_bad in lines:
        bad = ' class="bad"' if is_bad else ""
        body += f"<tr{bad}>" + "".join(f"<td>{escape(cell)}</td>" for cell in told) + "</tr>"
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def _table(outcomes: Sequence[Outcome]) -> str:
    return table_in_html(HEADINGS, ((cells(one), bool(one.collisions) and one.method == "ours") for one in rows(outcomes)))


def _collision(outcome: Outcome, folder: Path) -> str:
    picture = folder / f"{outcome.family}_{outcome.seed}.png"
    draw_to(picture, scenario_of(outcome.family, outcome.seed), outcome.method)
    why = f" <em>Limit: {escape(outcome.limit)}.</em>" if outcome.limit else ""
    hit = outcome.collision
    return (f"<h3>{escape(outcome.name)}</h3><p>Ran into {escape(hit.thing)} after {hit.time:.2f} s.{why} <code>"
            f'scripts/trials --replay {escape(outcome.name)} --video out.gif</code></p><img src="{picture.name}" alt="">')


def _draw_histograms(outcomes: Sequence[Outcome], path: Path) -> None:
    figure = Figure(figsize=(10, 3.4), constrained_layout=True)
    clearance, speed = figure.subplots(1, 2)
    for method in dict.fromkeys(one.method for one in outcomes):
        ours = [one for one in outcomes if one.method == method]
        clearances = [one.clearance for one in ours if isfinite(one.clearance)]
        speeds = [one.free_metres / one.free_seconds for one in ours if one.free_seconds]
        clearance.hist(clearances, bins=40, range=(0, 1), alpha=0.6, label=method)
        speed.hist(speeds, bins=40, range=(0, 0.2), alpha=0.6, label=method)
    clearance.set(xlabel="smallest clearance while driving [m]", ylabel="drives")
    speed.set(xlabel="mean speed over free ground [m/s]")
    clearance.legend(frameon=False)
    figure.savefig(path, dpi=110)
