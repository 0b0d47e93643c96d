# SPDX-License-Identifier: BSD-3-Clause
"""Judges what was asked for, and shows it."""
from __future__ import annotations

import argparse
from typing import Any, Dict, List, Optional, Sequence

from safety_control_cloud.judge import say
from safety_control_cloud.judge.compare import Difference, differences
from safety_control_cloud.judge.find import bags_in
from safety_control_cloud.judge.identity import hash_of_settings
from safety_control_cloud.judge.rows import BagRow
from safety_control_cloud.judge.run import Request, judge
from safety_control_cloud.judge.store import Store
from safety_control_cloud.processes import end_on_sigterm
from safety_control_cloud.replay.parameters import BadSettings, parameters_in, settings_of

SOME_UNREADABLE = 1  # exit code


class Unusable(RuntimeError):
    """Nothing to judge, or nothing to judge it by, or to write it to. str() says why."""


def run(given: argparse.Namespace) -> int:
    """The exit code. Raises Unusable."""
    end_on_sigterm()
    try:
        settings = _settings(given)
        if given.report:
            given.report.mkdir(parents=True, exist_ok=True)
        bags = bags_in(given.bags)
    except (BadSettings, OSError) as error:
        raise Unusable(str(error)) from error
    request = Request(bags, given.out, settings, given.topic, given.jobs, given.scheduler)
    try:
        with say.progress(len(bags)) as (done, line):
            rows = judge(request, done, line)
    except (OSError, RuntimeError) as error:
        raise Unusable(str(error)) from error
    _show(given, settings, rows)
    return SOME_UNREADABLE if any(row.status == "error" for row in rows) else 0


def _settings(given: argparse.Namespace) -> List[Dict[str, Any]]:
    """What differs from the defaults, one or two. Raises BadSettings."""
    files = given.compare or ([given.settings] if given.settings else [None])
    settings = []
    for file in files:
        parameters = {**(parameters_in(file) if file else {}), **dict(given.param)}
        try:
            fit = settings_of(parameters).as_dict()
        except BadSettings as error:
            raise BadSettings(f"{file or '--param'}: {error}") from error
        if fit["mode"] == "guard":
            raise BadSettings(f"{file or '--param'}: a guard is asked about one bag, by scripts/replay --mode guard")
        settings.append({name: fit[name] for name in parameters})
    return settings


def _show(given: argparse.Namespace, settings: Sequence[Dict[str, Any]], rows: Sequence[BagRow]) -> None:
    console = say.console()
    whole = [settings_of(one) for one in settings]
    hashes = [hash_of_settings(one, given.topic) for one in whole]
    for number, name in enumerate(dict.fromkeys(hashes)):
        its = [row for row in rows if row.settings == name]
        if given.compare:
            console.print(str(given.compare[number]), style="bold")
        console.print(say.table_of(its))
        console.print(say.summary_of(its))
    store = Store(given.out, {})
    changed: Optional[List[Difference]] = None
    if given.compare:
        changed = differences(store, rows, *hashes)
        for text in say.told(changed, tuple(map(str, given.compare))):
            console.print(text, markup=False, soft_wrap=True)
    if given.report:
        from safety_control_cloud.judge.report import write_report

        console.print(f"report: {write_report(given, store, rows, list(zip(hashes, whole)), changed)}")
