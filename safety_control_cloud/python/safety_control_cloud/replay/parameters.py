# SPDX-License-Identifier: BSD-3-Clause
"""The node's private parameters, as a user writes them: in a YAML file or as NAME=VALUE."""
from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, Mapping, Optional

from ruamel.yaml import YAML, YAMLError

from safety_control_cloud import core


class BadSettings(ValueError):
    """str() is one line for each problem."""


def parameters_in(file: Path) -> Dict[str, Any]:
    """As config/default.yaml has them. Raises BadSettings."""
    try:
        content = YAML(typ="safe").load(file.read_text())
    except (OSError, UnicodeDecodeError, YAMLError) as error:
        raise BadSettings(f"cannot read {file}: {' '.join(str(error).split())}") from error
    if content is None:
        return {}
    if not isinstance(content, dict):
        raise BadSettings(f"{file}: not a list of parameters, NAME: VALUE")
    return {str(name): value for name, value in content.items()}


def refuse_two_modes(mode: Optional[str], parameters: Mapping[str, Any]) -> None:
    """--mode goes before a file's, not before what the same command line says. Raises BadSettings."""
    if mode and parameters.get("mode", mode) != mode:
        raise BadSettings(f"--mode {mode} and --param mode={parameters['mode']} are two")


def settings_of(parameters: Mapping[str, Any]) -> core.Settings:
    """Values may be texts. Raises BadSettings if they are unfit to drive with."""
    defaults, problems, fit = core.Settings().as_dict(), [], {}
    for name, value in parameters.items():
        if name not in defaults:
            problems.append(f"there is no parameter {name}")
            continue
        try:
            core.Settings(**{name: _as(type(defaults[name]), value)})
            fit[name] = _as(type(defaults[name]), value)
        except (TypeError, ValueError, RuntimeError):
            problems.append(f"{name} cannot be {value!r}")
    settings = core.Settings(**fit)
    problems += settings.problems()
    if problems:
        raise BadSettings("\n".join(problems))
    return settings


def _as(kind: type, value: Any) -> Any:
    if kind is bool:
        return _truth(value)
    unlike = kind is list and not isinstance(value, list) or kind is int and isinstance(value, float) and value != int(value)
    if isinstance(value, bool) or unlike:
        raise ValueError(value)
    return kind(value)


def _truth(value: Any) -> bool:
    """As roscpp takes an argument of the command line."""
    words = {"true": True, "false": False}
    if not isinstance(value, bool) and str(value).lower() not in words:
        raise ValueError(value)
    return value if isinstance(value, bool) else words[str(value).lower()]
