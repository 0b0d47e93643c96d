# SPDX-License-Identifier: BSD-3-Clause
"""Wanted, given and driven over time, with the spans in which the guard takes something, and the factor below."""
from __future__ import annotations

from pathlib import Path
from typing import Callable, List, Optional, Sequence

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.axes import Axes

from safety_control_cloud.replay.guard.counts import PASSES, ZONES
from safety_control_cloud.replay.guard.drive import Answer
from safety_control_cloud.replay.guard.report import Span, spans
from safety_control_cloud.replay.guard.run import Guarded
from safety_control_cloud.replay.plot import INK, QUIET, STYLE
from safety_control_cloud.zone_colours import DRAWN as COLOURS

DRIVEN = "#3b6fb6"


def write_plot(guarded: Guarded, end: int, path: Path, title: str) -> None:
    """A picture in the format of the path's ending. The turns have axes of their own if there are any."""
    turns = any(answer.wanted[5] for answer in guarded.answers)
    heights = (3, 2, 1) if turns else (3, 1)
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(
            len(heights), 1, sharex=True, figsize=(10, 5.6 + 1.8 * turns), gridspec_kw={"height_ratios": heights},
            constrained_layout=True)
        axes[0].set_title(title, loc="left", fontsize=12, fontweight="bold", pad=24)
        _draw(axes[0], guarded, end, "speed [m/s]", 0, 0)
        if turns:
            _draw(axes[1], guarded, end, "turning [rad/s]", 5, 2)
        _draw_factor(axes[-1], guarded, end)
        _shade(axes, spans(guarded.answers, end), guarded.start)
        axes[0].legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncol=6, frameon=False, borderaxespad=0.2)
        axes[-1].set_xlabel(f"time [s] since {guarded.start / 1e9:.3f}")
        figure.savefig(path, dpi=150)
        plt.close(figure)


def _draw(axes: Axes, guarded: Guarded, end: int, label: str, number: int, of_driven: int) -> None:
    """One component of the commands, and of what odometry says."""
    driven = [None if answer.driven is None else answer.driven[of_driven] for answer in guarded.answers]
    if any(value is not None for value in driven):
        _step(axes, guarded, end, lambda answer: None if answer.driven is None else answer.driven[of_driven],
              color=DRIVEN, lw=1.0, ls=":", label="driven")
    _step(axes, guarded, end, lambda answer: answer.wanted[number], color=QUIET, lw=2.4, label="wanted")
    _step(axes, guarded, end, lambda answer: answer.given[number], color=INK, lw=1.2, label="given")
    axes.set_ylabel(label)


def _draw_factor(axes: Axes, guarded: Guarded, end: int) -> None:
    _step(axes, guarded, end, lambda answer: answer.factor, color=INK, lw=1.2)
    axes.set_ylim(-0.05, 1.1)
    axes.set_ylabel("factor")


def _step(axes: Axes, guarded: Guarded, end: int, value: Callable[[Answer], Optional[float]], **style: object) -> None:
    times = [(answer.time - guarded.start) / 1e9 for answer in guarded.answers]
    values: List[float] = [float("nan") if (found := value(answer)) is None else found for answer in guarded.answers]
    axes.step([*times, (end - guarded.start) / 1e9], [*values, values[-1]], where="post", **style)


def _shade(axes: Sequence[Axes], all_spans: Sequence[Span], start: int) -> None:
    """Where something else is given than is wanted; the causes in the legend."""
    named = set()
    for span in all_spans:
        if span.does == PASSES:
            continue
        label = f"{'scaled' if span.least > 0.0 else 'stopped'}, {span.first.cause}"
        for number, one in enumerate(axes):
            new = number == 0 and label not in named
            one.axvspan((span.first.time - start) / 1e9, (span.end - start) / 1e9, color=COLOURS[ZONES[span.does]],
                        alpha=0.16, lw=0, label=label if new else "")
        named.add(label)
