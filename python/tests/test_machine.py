"""Machines of names, files, texts and dictionaries."""

from __future__ import annotations

import pickle
from pathlib import Path

import pytest

import chordal
from chordal import Machine


def test_built_in_machines() -> None:
    names = chordal.builtin_machines()
    assert "haas-vf2" in names
    for name in names:
        machine = Machine.named(name)
        # A lathe may have no Y.
        assert machine.name == name and {"X", "Z"} <= set(machine.axes)
        assert Machine.from_toml(machine.to_toml(), name) == machine
        assert pickle.loads(pickle.dumps(machine)) == machine


def test_a_dictionary_is_a_machine_file(tmp_path: Path) -> None:
    told: dict[str, object] = {
        "inherits": "haas-vf2",
        "title": 'Our "VF"',
        "axes": {"X": {"travel": ["-500 mm", "0 mm"]}},
        "tools": {1: {"diameter": "0.75 in", "length": "4.1 in"}},
        "settings": {"Setting 162": "on"},
        "work_offsets": {"G54": {"X": "-15.2 in"}},
    }
    machine = Machine.from_dict(told, "shop")
    assert machine.title == 'Our "VF"' and machine.control == "haas"
    file = tmp_path / "shop.toml"
    file.write_text(machine.to_toml())
    for given in (file, str(file), machine, told):
        assert chordal.loads("G1", given).control == "haas"
    assert Machine.from_file(file) == Machine.from_toml(machine.to_toml(), "shop")


def test_a_wrong_machine_says_all_that_is_wrong() -> None:
    with pytest.raises(chordal.MachineError) as raised:
        Machine.from_dict({"control": "hass", "axes": {"X": {"travel": [1, 2]}}, "tols": {}})
    problems = raised.value.problems
    assert len(problems) >= 2
    assert any(problem.underlined == '"hass"' for problem in problems)
    assert "^^^" in str(raised.value)
    assert isinstance(raised.value, ValueError) and isinstance(raised.value, chordal.ChordalError)
    again = pickle.loads(pickle.dumps(raised.value))
    assert again.problems == problems


def test_changes_make_another_machine() -> None:
    machine = Machine.named("haas-vf2")
    other = machine.replace({"feed": {"max": "100 in/min"}})
    assert other != machine and Machine.named("haas-vf2") == machine
    with pytest.raises(chordal.MachineError, match="no unit"):
        machine.replace({"feed": {"max": 300}})


def test_names_that_nothing_has() -> None:
    with pytest.raises(chordal.UsageError) as raised:
        Machine.named("haas-vf9")
    assert raised.value.help
    with pytest.raises(chordal.UsageError, match="cannot be a value"):
        Machine.from_dict({"control": object()})
