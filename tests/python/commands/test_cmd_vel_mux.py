# SPDX-License-Identifier: BSD-3-Clause
import pytest

from safety_control_cloud.commands import cmd_vel_mux


@pytest.mark.parametrize("text, reason", [
    (None, "cannot read {file}: [Errno 2] No such file or directory"),
    ("subscribers: [", "cannot read {file}: while parsing"),
    ("a: b: c", "cannot read {file}: mapping values are not allowed here"),
    ("subscribers: 3", "{file}: subscribers must be a list of inputs"),
    ("subscribers: navi", "{file}: subscribers must be a list of inputs"),
    ("subscribers: {name: navi}", "{file}: subscribers must be a list of inputs"),
    ("", "{file}: must be a mapping"),
    ("[navi, teleop]", "{file}: must be a mapping"),
    ("publisher: output", "{file}: no subscribers"),
    ("subscribers: [3, {name: navi}]", "{file}: subscriber 0: "),
])
def test_a_table_that_cannot_be_taken_is_told_in_a_line(text, reason, tmp_path, capsys):
    file = tmp_path / "table.yaml"
    if text is not None:
        file.write_text(text)
    assert cmd_vel_mux.main(["cmd_vel_mux", "--table", str(file)]) == 2
    said = capsys.readouterr().err
    assert said.startswith("cmd_vel_mux: " + reason.format(file=file)) and said.count("\n") == 1
