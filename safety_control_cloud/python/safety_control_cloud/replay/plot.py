# SPDX-License-Identifier: BSD-3-Clause
"""Distance over time, with the zones as bands, and the speed below; each topic beside the others."""
from __future__ import annotations

import math
from pathlib import Path
from typing import Dict, Iterable, List, Optional, Sequence, Tuple

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.axes import Axes

from safety_control_cloud import core
from safety_control_cloud.replay.lockstep import Answer
from safety_control_cloud.replay.silence import Silence, by_topic
from safety_control_cloud.zone_colours import DRAWN as COLOURS

Silent = Dict[int, Tuple[float, float]]  # [s] from and to, by the number of the cloud before
INK, QUIET = "#22303c", "#8795a1"
STYLE = {
    "font.family": "DejaVu Sans", "font.size": 10, "text.color": INK, "axes.edgecolor": QUIET, "axes.labelcolor": INK,
    "xtick.color": INK, "ytick.color": INK, "axes.spines.top": False, "axes.spines.right": False,
    "figure.constrained_layout.w_pad": 0.12, "figure.constrained_layout.h_pad": 0.1,  # [inch]
}


def write_plot(
    answers: Sequence[Answer], path: Path, title: str, limits: core.Settings, silences: Sequence[Silence] = ()
) -> None:
    """A picture in the format of the path's ending; limits are those the node decided by."""
    topics = by_topic(answers)
    several = len(topics) > 1
    since = _first_stamp(topics.values())
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(
            2, len(topics), sharex="col", figsize=(7 * len(topics) if several else 10, 5.6), squeeze=False,
            gridspec_kw={"height_ratios": (3, 1)}, constrained_layout=True)
        for (topic, its), above, below in zip(topics.items(), *axes):
            _draw(above, below, its, limits, [one for one in silences if one.topic == topic], since)
            above.set_title(topic if several else title, loc="left", fontsize=12, fontweight="bold", pad=12)
        figure.savefig(path, dpi=150)
        plt.close(figure)


def _draw(above: Axes, below: Axes, answers: Sequence[Answer], limits: core.Settings, silences: Sequence[Silence],
          since: Optional[int]) -> None:
    """Of one topic."""
    times, label = _times(answers, since)
    silent = _silent(answers, silences, since) if since is not None else {}
    _draw_distance(above, times, answers, limits, silent)
    _draw_speed(below, times, answers, limits, silent)
    below.set_xlabel(label)
    below.set_xlim(*_padded(times))


def _first_stamp(topics: Iterable[Sequence[Answer]]) -> Optional[int]:
    """[ns] of all topics; None where the stamps of one do not advance."""
    stamps = [[answer.stamp for answer in answers] for answers in topics]
    advance = all(earlier < later for its in stamps for earlier, later in zip(its, its[1:]))
    return min(its[0] for its in stamps) if advance else None


def _silent(answers: Sequence[Answer], silences: Sequence[Silence], first: int) -> Dict[int, Tuple[float, float]]:
    """Start and end on the axis of the stamps, by the cloud before."""
    spans = {}
    for silence in silences:
        before = answers[silence.after]
        spans[silence.after] = tuple((before.stamp - first + time - before.time) / 1e9 for time in (silence.start, silence.end))
    return spans


def _broken(times: Sequence[float], values: Sequence[float], silent: Silent, within: float) -> Tuple[list, list]:
    """The line, which falls to `within` where the robot hears of no cloud."""
    xs: List[float] = []
    ys: List[float] = []
    for number, (time, value) in enumerate(zip(times, values)):
        xs.append(time)
        ys.append(value)
        if number in silent:
            xs.append(silent[number][0])
            ys.append(within)
    return xs, ys


def _draw_distance(
    axes: Axes, times: List[float], answers: Sequence[Answer], limits: core.Settings, silent: Silent
) -> None:
    known = [answer.nearest for answer in answers if answer.nearest is not None]
    top = 1.08 * max([1.5 * limits.warning_distance, *known])
    bands = {"Danger": (0.0, limits.danger_distance), "Warning": (limits.danger_distance, limits.warning_distance),
             "Safe": (limits.warning_distance, top)}
    for zone, (low, high) in bands.items():
        axes.axhspan(low, high, color=COLOURS[zone], alpha=0.14, lw=0)
        axes.text(1.008, (low + high) / 2, zone, transform=axes.get_yaxis_transform(), va="center",
                  color=COLOURS[zone], fontweight="bold")
    distances = [math.nan if answer.nearest is None else answer.nearest for answer in answers]
    axes.plot(*_broken(times, distances, silent, math.nan), color=INK, lw=1.4, zorder=3)
    for number, (start, end) in enumerate(silent.values()):
        axes.axvspan(start, end, color=COLOURS["Danger"], alpha=0.25, lw=0, label="" if number else "SILENT")
    axes.scatter(times, distances, s=_size(answers), c=[COLOURS.get(answer.zone, QUIET) for answer in answers],
                 edgecolors="white", linewidths=0.6, zorder=4)
    _mark(axes, times, answers, top)
    axes.set_ylim(0.0, top)
    axes.set_ylabel("nearest obstacle [m]")


def _mark(axes: Axes, times: List[float], answers: Sequence[Answer], top: float) -> None:
    """Clouds without a distance: free at the upper edge, those that could not be looked at on the ground."""
    free = [time for time, answer in zip(times, answers) if answer.nearest is None and answer.cause == "SEEN"]
    lost = [time for time, answer in zip(times, answers) if answer.cause != "SEEN"]
    if free:
        axes.scatter(free, [0.97 * top] * len(free), marker="^", s=28, color=COLOURS["Safe"], zorder=4,
                     label="corridor is free")
    if lost:
        causes = ", ".join(sorted({answer.cause for answer in answers if answer.cause != "SEEN"}))
        axes.scatter(lost, [0.03 * top] * len(lost), marker="X", s=36, color=COLOURS["Danger"], zorder=4,
                     label=f"cannot see: {causes}")
    if axes.get_legend_handles_labels()[0]:
        axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncol=2, frameon=False, borderaxespad=0.2)


def _draw_speed(
    axes: Axes, times: List[float], answers: Sequence[Answer], limits: core.Settings, silent: Silent
) -> None:
    end = _padded(times)[1]  # the last speed holds on
    times, speeds = _broken(times, [answer.speed for answer in answers], silent, 0.0)
    axes.step([*times, end], [*speeds, speeds[-1]], where="post", color=INK, lw=1.4)
    axes.fill_between([*times, end], [*speeds, speeds[-1]], step="post", color=INK, alpha=0.12, lw=0)
    top = max([limits.safe_speed, *speeds, 0.01])
    axes.set_ylim(-0.05 * top, 1.15 * top)  # so that a standing robot shows as a line
    axes.set_yticks(sorted({0.0, limits.warning_speed, limits.safe_speed}))
    axes.grid(axis="y", color=QUIET, alpha=0.3, lw=0.6)
    axes.set_ylabel("speed [m/s]")


def _times(answers: Sequence[Answer], since: Optional[int]) -> Tuple[List[float], str]:
    """Seconds since that stamp, or the number of the cloud where stamps do not advance."""
    if since is None:
        return [float(number) for number in range(len(answers))], "cloud (the stamps do not advance)"
    return [(answer.stamp - since) / 1e9 for answer in answers], f"time [s] since {since / 1e9:.3f}"


def _padded(times: List[float]) -> Tuple[float, float]:
    pad = 0.03 * (times[-1] - times[0]) or 0.5
    return times[0] - pad, times[-1] + pad


def _size(answers: Sequence[Answer]) -> float:
    return 46.0 if len(answers) < 100 else 14.0
