# SPDX-License-Identifier: BSD-3-Clause
"""The summary as a page: table, histograms, and a picture of each drive with a contact of ours that was seen before."""
from __future__ import annotations

from collections.abc import Sequence
from html import escape
from pathlib import Path

from matplotlib.figure import Figure

from ..families import scenario_of
from ..report import table_in_html, write_page
from .outcome import IN_VIEW, NEVER, Outcome
from .replay import draw_to
from .summary import is_failure, rows
from .table import HEADINGS, cells, verdict_of

MOST_PICTURES = 20


def write_report(outcomes: Sequence[Outcome], folder: Path, driver: str, made_by: str) -> Path:
    """index.html and its pictures; drives again what it draws. `made_by`: command, seed and date."""
    folder.mkdir(parents=True, exist_ok=True)
    _draw_histograms(outcomes, folder / "histograms.png")
    ours = [one for one in outcomes if one.method == "ours"]
    telling = [one for one in ours if is_failure(one) or any(touch.kind != NEVER for touch in one.touches)]
    telling.sort(key=lambda one: not is_failure(one))
    parts = [
        f"<h1>A {driver} driver</h1>", f"<p><code>{escape(made_by)}</code></p>",
        *(f"<p>{escape(line)}</p>" for line in verdict_of(outcomes)), _table(outcomes),
        '<h2>What was let through</h2><img src="histograms.png" alt="histograms">',
        f"<h2>Drives of ours with a contact that had been seen, or that did not arrive: {len(telling)}</h2>",
        *(_drive(one, folder, driver) for one in telling[:MOST_PICTURES]),
    ]
    return write_page(folder, parts)


def _table(outcomes: Sequence[Outcome]) -> str:
    return table_in_html(HEADINGS, ((cells(one), bool(one.touches[IN_VIEW]) and one.method == "ours") for one in rows(outcomes)))


def _drive(outcome: Outcome, folder: Path, driver: str) -> str:
    picture = folder / f"{outcome.family}_{outcome.seed}.png"
    draw_to(picture, scenario_of(outcome.family, outcome.seed), outcome.method)
    told = "; ".join(f"{touch.hit.thing} after {touch.hit.time:.2f} s: {touch.kind}" for touch in outcome.touches)
    return (f"<h3>{escape(outcome.name)}</h3><p>{escape(told or 'did not arrive')} <code>scripts/trials --driver {driver} "
            f'--replay {escape(outcome.name)}</code></p><img src="{picture.name}" alt="">')


def _draw_histograms(outcomes: Sequence[Outcome], path: Path) -> None:
    figure = Figure(figsize=(10, 3.4), constrained_layout=True)
    shares, lost = figure.subplots(1, 2)
    for method in dict.fromkeys(one.method for one in outcomes):
        ours = [one for one in outcomes if one.method == method]
        shares.hist([share for one in ours for share in one.shares], bins=40, range=(0, 1), alpha=0.6, label=method)
        lost.hist([100 * one.time_lost for one in ours if one.time_lost is not None], bins=40, alpha=0.6, label=method)
    shares.set(xlabel="given over greatest safe factor, going forward", ylabel="moments")
    lost.set(xlabel="time lost to the guard [%]", ylabel="drives")
    shares.legend(frameon=False)
    figure.savefig(path, dpi=110)
