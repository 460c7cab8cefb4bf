"""Programs: loading, problems, summary, time."""

from __future__ import annotations

import hashlib
import math
from pathlib import Path

import pytest

import chordal
from conftest import BROKEN, PART


def test_a_file_brings_its_folder_and_its_subprograms(examples: Path) -> None:
    program = chordal.load(examples / "haas" / "thread-mill.nc")
    assert program.control == "haas"
    assert program.recognized is None, "chordal.toml of the folder says the machine"
    assert program.summary.helices == 3
    called = chordal.load(examples / "fanuc" / "subprograms.nc")
    assert not called.errors
    assert program.sha256 == hashlib.sha256(program.text).hexdigest()


def test_a_text_is_recognized_or_told() -> None:
    recognized = chordal.loads(PART).recognized
    assert recognized is not None and "assumed" in recognized or "recognized" in str(recognized)
    assert chordal.loads(PART, control="fanuc").machine.name == "fanuc-30i"
    assert chordal.loads(PART.encode(), "haas-vf2").name == "<program>"
    with pytest.raises(chordal.UsageError, match="both a machine and a control"):
        chordal.loads(PART, "haas-vf2", control="haas")
    with pytest.raises(chordal.UsageError, match="hass"):
        chordal.loads(PART, control="hass")  # type: ignore[arg-type]


def test_summary_by_hand() -> None:
    summary = chordal.loads(PART, "haas-vf2").summary
    assert (summary.lines, summary.arcs, summary.inch) == (5, 2, False)
    straight = 6.0 + 40.0 + 20.0 + 40.0 + 40.0
    assert summary.feed_length_mm == pytest.approx(straight + 10.0 * math.pi, abs=1e-9)
    x = next(axis for axis in summary.axes if axis.letter == "X")
    assert x.range == (0.0, 50.0) and x.cut_range == (0.0, 50.0)
    assert summary.tools[-1].number == 1


def test_a_problem_has_its_place_and_its_help() -> None:
    program = chordal.loads(BROKEN, "haas-vf2", name="broken.nc")
    problem = next(each for each in program.diagnostics if each.code == "CH401")
    assert (problem.severity, problem.line, problem.name) == ("error", 3, "radius-mismatch")
    place = problem.primary.place
    assert place is not None and place.file == "broken.nc"
    assert program.text[place.start : place.end] == b"X10. Y12. I0. J10."
    assert problem.help and "^^^" in problem.text and str(problem) == problem.text
    with pytest.raises(AttributeError):
        problem.message = "x"  # type: ignore[misc]


def test_errors_are_raised_where_they_are_asked_for() -> None:
    program = chordal.loads(BROKEN, "haas-vf2")
    assert len(program.commands()) > 0, "a program with problems still has commands"
    with pytest.raises(chordal.ProgramError) as raised:
        chordal.loads(BROKEN, "haas-vf2", name="broken.nc", strict=True)
    assert raised.value.name == "broken.nc"
    assert any(each.code == "CH401" for each in raised.value.diagnostics)
    assert "broken.nc:3" in str(raised.value)
    chordal.loads(PART, "haas-vf2").raise_errors()


def test_files_that_are_not_there_are_os_errors(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        chordal.load(tmp_path / "none.nc")
    with pytest.raises(IsADirectoryError):
        chordal.load(tmp_path)
    with pytest.raises(FileNotFoundError):
        chordal.Machine.from_file(tmp_path / "none.toml")


def test_time_holds_the_limits() -> None:
    program = chordal.loads(PART, "haas-vf2")
    time = program.time()
    assert time.total_s == pytest.approx(time.cutting_s + time.rapid_s + time.other_s)
    assert time.cutting_s > program.summary.feed_time_s
    assert time.waits["tool change"] == 4.5
    assert [tool.tool for tool in time.tools] == [1]
    assert time.longest_blocks[0].time_s >= time.longest_blocks[-1].time_s
    half = program.time(feed_override=0.5)
    assert half.cutting_s > 1.9 * time.at_feed_s * time.cutting_s / time.total_s
    with pytest.raises(chordal.UsageError, match="fast"):
        program.time("slow")  # type: ignore[arg-type]


def test_tools_and_settings_come_on_top() -> None:
    text = "G21 G90 G17 S900 M3\nG1 X0 Y-10. F100.\nG41 D1 Y0\nX20.\nG40 Y-10.\nM30\n"
    tools = {1: {"diameter": "8 mm"}}
    program = chordal.loads(text, "haas-vf2", tools=tools)
    radii = program.tool_path()["cutter_radius_mm"]
    assert 4.0 in radii
    assert not program.diagnostics or all(d.code != "CH603" for d in program.diagnostics)
    with pytest.raises(chordal.MachineError, match="Setting 99999"):
        chordal.loads(text, "haas-vf2", settings={"Setting 99999": 1})


def test_printed_lines_and_block_delete() -> None:
    text = "#1=12.5\nDPRNT[X#1[32]]\n/DPRNT[SKIPPED]\nM30\n"
    assert chordal.loads(text, "haas-vf2").output == ("X12.50", "SKIPPED")
    assert chordal.loads(text, "haas-vf2", block_delete=True).output == ("X12.50",)


def test_one_program_of_a_memory() -> None:
    text = "%\nO0001\nG21 G1 X1. F100.\nM30\nO0002\nG21 G1 X2. F100.\nM30\n%\n"
    ends = chordal.loads(text, "haas-vf2", program=2).path().end
    assert ends[-1, 0] == 2.0
    with pytest.raises(chordal.UsageError, match="O7"):
        chordal.loads(text, "haas-vf2", program=7)


def test_codes_are_explained() -> None:
    known = {each.code: each for each in chordal.codes()}
    assert known["CH401"].name == "radius-mismatch" and known["CH401"].explanation


def test_from_where_on_the_path_is_not_known() -> None:
    text = "G21 G90 S900 M3\nG1 X9. F50.\nG33 Z-5. F2.\nX5.\nM30\n"
    program = chordal.loads(text, control="fanuc", name="part.nc")
    assert not program.verified and program.not_verified_from == ("part.nc", 3)
    assert [error.code for error in program.errors] == ["CH312"]
    whole = chordal.loads(text.replace("G33 Z-5. F2.\n", ""), control="fanuc")
    assert whole.verified and whole.not_verified_from is None
