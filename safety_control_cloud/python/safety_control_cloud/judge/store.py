# SPDX-License-Identifier: BSD-3-Clause
"""The folder of what has been judged. Each bag is there, whole, as soon as its judge is done: what ends, goes on."""
from __future__ import annotations

import json
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Dict, Iterator, List, Sequence, Tuple

from safety_control_cloud.judge.bag import Judged
from safety_control_cloud.judge.identity import Stat, version
from safety_control_cloud.judge.rows import DRIVE
from safety_control_cloud.judge.table import AnyBag, Key, Mode, bag_row_in, write_bags

BAGS, HASHES, SETTINGS = "bags.parquet", "hashes.jsonl", "settings"


class Store:
    def __init__(self, folder: Path, settings: Dict[str, dict], mode: Mode = DRIVE) -> None:
        """`settings` by their hashes. Raises OSError if the folder cannot be written."""
        self.rows = folder / mode.place / mode.folder
        self.bags = folder / mode.place / BAGS
        self._mode = mode
        self._hashes = folder / HASHES
        self._settings = tuple(settings)
        self.rows.mkdir(parents=True, exist_ok=True)
        for name, content in settings.items():
            (folder / SETTINGS).mkdir(exist_ok=True)
            (folder / SETTINGS / f"{name}.json").write_text(json.dumps(content, indent=1, sort_keys=True) + "\n")
        self._known = self._read_hashes()
        self._hashes.touch()

    def known(self, path: str) -> Tuple[Stat, str] | None:
        return self._known.get(path)

    def have(self, bag: str) -> Tuple[str, ...]:
        """The settings' hashes by which this content has been judged."""
        return tuple(name for name in self._settings if self.file_of(bag, name).exists())

    def file_of(self, bag: str, settings: str) -> Path:
        return self.rows / f"{Key(bag, settings, version())}.parquet"

    def keep(self, judged: Judged) -> None:
        """First what the bag is: of one that is known by its rows alone, nobody knows that after an interrupt."""
        if judged.bag and judged.stat and self._known.get(judged.path) != (judged.stat, judged.bag):
            self._known[judged.path] = (judged.stat, judged.bag)
            with self._hashes.open("a") as stream:
                stream.write(json.dumps([judged.path, judged.stat, judged.bag]) + "\n")
        for row, content in zip(judged.rows, judged.files):
            assert row.bag
            whole = self.file_of(row.bag, row.settings)
            with _whole_or_not_at_all(whole, self.bags.parent) as part:
                part.write_bytes(content)

    def rows_of(self, judged: Judged) -> List[AnyBag]:
        """One for each setting, judged now or before."""
        if not judged.bag:
            return [self._mode.bag(judged.path, None, name, version(), "error", judged.error) for name in self._settings]
        return [replace(bag_row_in(self.file_of(judged.bag, name), self._mode.bag), path=judged.path) for name in self._settings]

    def write_bags(self, rows: Sequence[AnyBag]) -> None:
        with _whole_or_not_at_all(self.bags, self.bags.parent) as part:
            write_bags(sorted(rows, key=lambda row: (row.path, row.settings)), part, self._mode.bags)

    def _read_hashes(self) -> Dict[str, Tuple[Stat, str]]:
        known: Dict[str, Tuple[Stat, str]] = {}
        if not self._hashes.exists():
            return known
        for line in self._hashes.read_text().splitlines():
            try:
                path, stat, bag = json.loads(line)
            except ValueError:
                continue  # the end of a line that was cut off: that bag is hashed again
            known[path] = (tuple((name, size, changed) for name, size, changed in stat), bag)
        return known


@contextmanager
def _whole_or_not_at_all(file: Path, folder: Path) -> Iterator[Path]:
    """What to write in its place. It lies in `folder`: whoever reads all rows never meets a part, even of a killed run."""
    part = folder / f"{file.stem}.part"
    try:
        yield part
        part.replace(file)
    finally:
        part.unlink(missing_ok=True)  # of what Ctrl-C has ended
