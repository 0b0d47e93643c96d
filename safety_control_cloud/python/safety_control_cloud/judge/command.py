# SPDX-License-Identifier: BSD-3-Clause
"""Judges what was asked for, and shows it."""
from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any, Dict, List, Optional, Sequence

from safety_control_cloud.judge import compare, say
from safety_control_cloud.judge.bag import mode_of
from safety_control_cloud.judge.choice import Choice
from safety_control_cloud.judge.find import NoBags, bags_in, refuse_nothing
from safety_control_cloud.judge.guard import compare as guard_compare, say as guard_say
from safety_control_cloud.judge.guard.rows import GUARD
from safety_control_cloud.judge.identity import hash_of_settings
from safety_control_cloud.judge.run import Request, judge
from safety_control_cloud.judge.store import Store
from safety_control_cloud.judge.table import AnyBag
from safety_control_cloud.processes import end_on_sigterm
from safety_control_cloud.replay.guard.inputs import OF_TRANSPORT, refuse_both
from safety_control_cloud.replay.parameters import BadSettings, parameters_in, refuse_two_modes, settings_of

SOME_UNREADABLE = 1  # exit code


class Unusable(RuntimeError):
    """Nothing to judge, or nothing to judge it by, or to write it to. str() says why."""


def run(given: argparse.Namespace) -> int:
    """The exit code. Raises Unusable."""
    end_on_sigterm()
    try:
        settings = _settings(given)
        bags = bags_in(given.bags)
        refuse_nothing(given.bags)
        _make("--out", given.out)
        _make("--report", given.report)
    except (BadSettings, NoBags, OSError) as error:
        raise Unusable(str(error)) from error
    choice = Choice(tuple(given.topic), given.cmd_vel, given.odom)
    request = Request(bags, given.out, settings, choice, given.jobs, given.scheduler)
    try:
        with say.progress(len(bags), mode_of(settings).rows) as (done, line):
            rows = judge(request, done, line)
    except (OSError, RuntimeError) as error:
        raise interrupt_behind(error) or Unusable(str(error)) from error
    _show(given, settings, choice, rows)
    return SOME_UNREADABLE if any(row.status == "error" for row in rows) else 0


def _make(option: str, folder: Optional[Path]) -> None:
    """The folder, if one is given. Raises Unusable."""
    try:
        if folder:
            folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise Unusable(f"{option} {folder}: {error.strerror}") from error


def _settings(given: argparse.Namespace) -> List[Dict[str, Any]]:
    """What differs from the defaults, one or two of one mode. Raises BadSettings."""
    settings = [_of(given, file) for file in given.compare or [given.settings]]
    if len({mode_of([one]) for one in settings}) > 1:
        raise BadSettings(f"{given.compare[0]} and {given.compare[1]} are of two modes: --mode says which")
    if mode_of(settings) == GUARD:
        for one in settings:
            refuse_both(one, given.topic, given.odom)
    elif given.cmd_vel or given.odom:
        raise BadSettings("--cmd-vel and --odom are of --mode guard")
    return settings


def interrupt_behind(error: BaseException) -> Optional[BaseException]:
    """Ctrl-C, or SIGTERM, that came just as somebody took a lock: to release that fails, and is all that is told."""
    behind: Optional[BaseException] = error
    while isinstance(behind, Exception):
        behind = behind.__context__
    return behind


def _of(given: argparse.Namespace, file: Optional[Path]) -> Dict[str, Any]:
    refuse_two_modes(given.mode, dict(given.param))
    parameters = {**(parameters_in(file) if file else {}), **dict(given.param), **({"mode": given.mode} if given.mode else {})}
    parameters = {name: value for name, value in parameters.items() if name not in OF_TRANSPORT}
    try:
        fit = settings_of(parameters).as_dict()
    except BadSettings as error:
        raise BadSettings(f"{file or '--param'}: {error}") from error
    return {name: fit[name] for name in parameters}


def _show(given: argparse.Namespace, settings: Sequence[Dict[str, Any]], choice: Choice, rows: Sequence[AnyBag]) -> None:
    console, mode = say.console(), mode_of(settings)
    shown, compared = (guard_say, guard_compare) if mode == GUARD else (say, compare)
    hashes = [hash_of_settings(one, choice) for one in settings]
    for number, name in enumerate(dict.fromkeys(hashes)):
        its = [row for row in rows if row.settings == name]
        if given.compare:
            console.print(str(given.compare[number]), style="bold")
        console.print(shown.table_of(its))
        console.print(shown.summary_of(its))
    store = Store(given.out, {}, mode)
    changed: Optional[list] = None
    if given.compare:
        changed = compared.differences(store, rows, *hashes)
        for text in shown.told(changed, given):
            console.print(text, markup=False, soft_wrap=True)
    if given.report:
        console.print(f"report: {_report(given, store, rows, settings, hashes, changed)}")


def _report(given: argparse.Namespace, store: Store, rows: Any, settings: Sequence[Dict[str, Any]], hashes: List[str], changed: Any) -> Path:
    from safety_control_cloud.judge.report import write_guarded, write_report  # Pillow takes its time to load

    if mode_of(settings) == GUARD:
        return write_guarded(given, store, rows, hashes, changed)
    return write_report(given, store, rows, list(zip(hashes, map(settings_of, settings))), changed)
