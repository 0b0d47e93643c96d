# SPDX-License-Identifier: BSD-3-Clause
"""A test that was skipped has shown nothing: only the skips listed in allowed_skips.yaml leave a run green."""
from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import yaml
from pytest import ExitCode

LIST = Path(__file__).resolve().parents[1] / "allowed_skips.yaml"
EVERYWHERE = "everywhere"
KEYS = {"test", "says", "where", "because"}


@dataclass(frozen=True)
class Allowed:
    test: str  # a node id, or the beginning of one that ends before "::" or "["
    says: str  # is part of the skip's reason
    where: tuple[str, ...]  # platforms, or EVERYWHERE
    because: str

    def fits(self, test: str, reason: str, platform: str) -> bool:
        here = platform in self.where or EVERYWHERE in self.where
        return here and self.says in reason and (test == self.test or test.startswith((self.test + "::", self.test + "[")))


def allowed_in(path: Path) -> tuple[Allowed, ...]:
    """Raises ValueError for an entry that lacks a key, has an empty or has another."""
    entries = yaml.safe_load(path.read_text()) or []
    for entry in entries:
        if set(entry) != KEYS or not all(entry.values()):
            raise ValueError(f"{path}: {entry} does not have exactly {', '.join(sorted(KEYS))}")
    return tuple(Allowed(entry["test"], entry["says"], tuple(entry["where"]), entry["because"]) for entry in entries)


def platform(os_release: Path = Path("/etc/os-release")) -> str:
    """Such as debian12 or ubuntu20.04."""
    lines = os_release.read_text().splitlines() if os_release.exists() else []
    named = dict(line.split("=", 1) for line in lines if "=" in line)
    return "".join(named.get(key, "").strip("\"'") for key in ("ID", "VERSION_ID")) or "unknown"


class Watch:
    """A pytest plugin: collects the skips that are not listed, and fails the run for them at its end."""

    def __init__(self, allowed: tuple[Allowed, ...], platform: str) -> None:
        self._allowed = allowed
        self._platform = platform
        self._unlisted: list[str] = []

    def pytest_runtest_logreport(self, report) -> None:
        if not hasattr(report, "wasxfail"):
            self._look_at(report)

    def pytest_collectreport(self, report) -> None:
        self._look_at(report)

    def pytest_sessionfinish(self, session) -> None:
        if self._unlisted and session.exitstatus in (ExitCode.OK, ExitCode.NO_TESTS_COLLECTED):
            session.exitstatus = ExitCode.TESTS_FAILED

    def pytest_terminal_summary(self, terminalreporter) -> None:
        if self._unlisted:
            terminalreporter.section(f"skipped, and not listed for {self._platform} in {LIST.name}", red=True)
            for line in self._unlisted:
                terminalreporter.write_line(line)

    def _look_at(self, report) -> None:
        if report.skipped:
            reason = reason_of(report)
            if not any(one.fits(report.nodeid, reason, self._platform) for one in self._allowed):
                self._unlisted.append(f"{report.nodeid}: {reason}")


def reason_of(report) -> str:
    """Of a skip: (file, line, reason)."""
    _, _, reason = report.longrepr
    return reason.replace("Skipped: ", "", 1).strip()
