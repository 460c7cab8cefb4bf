"""Programs changed in place."""

import pytest

import chordal

TEXT = "G21 G90 G54 S900 M3\nG0 X0 Y0\nZ2.\nG1 Z-1. F100.\nX10.\nG3 X20. Y10. R10.\nG0 Z50.\nM30\n"


def test_moved_and_proved() -> None:
    program = chordal.loads(TEXT, "haas-vf2")
    done = program.transform(shift=(5, 0, 0))
    assert done.proved
    assert done.max_distance_mm is not None and done.max_distance_mm < 1e-9
    assert b"G3 X25. Y10. R10." in done.text
    assert [change.line for change in done.changes] == [2, 5, 6]
    assert done.changes[1] == chordal.Change(5, "X10.", "X15.", "the path is moved")


def test_there_and_back_is_the_same_text() -> None:
    program = chordal.loads(TEXT, "haas-vf2")
    there = program.transform(mirror="x").text
    assert b"G2 X-20." in there
    back = chordal.loads(there, "haas-vf2").transform(mirror="x")
    assert back.text == TEXT.encode()


def test_chords_become_arcs_again() -> None:
    program = chordal.loads(TEXT, "haas-vf2")
    chords = program.transform(chords=0.002)
    assert chords.proved and len(chords.text) > 1.5 * len(TEXT)
    arcs = chordal.loads(chords.text, "haas-vf2").transform(fit=0.01)
    assert arcs.proved
    assert arcs.text.count(b"G3") == 1


def test_what_no_change_is_right_for_names_the_line() -> None:
    program = chordal.loads("G21 G90 S900 M3\nG1 X0 Y0 F100.\nG13 I5. F100. D1\nM30\n", "haas-vf2")
    with pytest.raises(chordal.UsageError, match="line 3"):
        program.transform(rotate=30)
    with pytest.raises(chordal.UsageError, match="nothing"):
        program.transform()


TWO_TOOLS = (
    "O5\nT1 M6\nG20 G90 G54 G0 X0 Y0 S900 M3\nG43 H1 Z1.\nG1 Z-.1 F5.\nG0 Z1.\n"
    "T2 M6\nG90 G54 G0 X1. Y0 S900 M3\nG43 H2 Z1.\nG1 Z-.1 F5.\nG0 Z1.\nM30\n"
)


def test_a_program_for_each_tool() -> None:
    done = chordal.loads(TWO_TOOLS, "haas-vf2").split("tool")
    assert done.proved and done.notes == ()
    assert [part.number for part in done.parts] == [5, 6]
    assert done.parts[1].lines == (7, 12)
    assert done.parts[1].begins == "before a tool change"
    assert done.parts[1].put_in[0] == "G20 G90"
    assert done.parts[0].text.endswith(b"G0 Z1.\nM5\nM30\n")


def test_what_cannot_be_parted_names_the_lines() -> None:
    program = chordal.loads(TWO_TOOLS, "haas-vf2")
    with pytest.raises(chordal.UsageError, match="from line 1 to line 6"):
        program.split(50)
    with pytest.raises(chordal.UsageError, match="is not a size"):
        program.split(0)


def test_a_program_begins_at_a_line() -> None:
    text = "G21 G90 S900 M3\nG0 X0 Y0 Z5.\nG1 Z-1. F50.\nX9.\nX20.\nM30\n"
    program = chordal.loads(text, "haas-vf2")
    done = program.restart(5)
    assert done.line == 5 and done.moves == 1
    assert done.text.endswith(b"\nX20.\nM30\n")
    assert "G1 Z-1. F50." in done.put_in
    with pytest.raises(chordal.UsageError, match="no line 50"):
        program.restart(50)


def test_feeds_within_a_tolerance_are_fitted_together() -> None:
    import math

    rows = "".join(f"X{i / 4:.3f} Y{8 * math.sin(i / 20):.3f} F{900 + i % 7}.\n" for i in range(200))
    text = f"G21 G90 G17 S900 M3\nG0 X0 Y0 Z5.\nG1 Z0. F300.\n{rows}G0 Z5.\nM30\n"
    program = chordal.loads(text, "haas-vf2")
    near = program.transform(fit=0.01)
    exact = program.transform(fit=0.01, feed_tolerance=0.0)
    assert near.proved and exact.proved
    assert len(near.text) < len(exact.text) / 4
