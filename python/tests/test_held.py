"""Programs compared with each other, and converted for other machines."""

import pytest

import chordal

TEXT = "M6 T1\nG0 G90 S100 M3 E1 X0 Y0\nH1 Z.1 M8\nG1 Z0 F10.\nG91 I-.5 Z-.1 G3 G90 L3\nX1.\nM2\n"


def test_the_same_and_not() -> None:
    one = chordal.loads(TEXT, "fadal-4020")
    assert one.compare(chordal.loads(TEXT.replace(" ", ""), "fadal-4020"))
    other = chordal.loads(TEXT.replace("X1.", "X1.1"), "fadal-4020")
    found = one.compare(other)
    assert not found and found.verdict == "different"
    assert found.max_distance_mm == pytest.approx(2.54)
    assert found.differences[0]["a"]["lines"] == [6, 6]
    assert one.compare(other, tolerance=2.6).verdict == "within"
    with pytest.raises(ValueError, match="no category colour"):
        one.compare(other, ignore=["colour"])


def test_to_another_machine() -> None:
    program = chordal.loads(TEXT, "fadal-4020")
    done = program.convert("haas-vf2")
    assert done.holds and not done.refusals
    assert done.proof is not None and done.proof.verdict == "same"
    assert "G54" in done.text and "G43 H1" in done.text
    assert ("E1", "G54") in [(change.before, change.after) for change in done.changes]
    back = chordal.loads(done.text, "haas-vf2").convert("fadal-4020")
    assert back.holds


def test_errors_are_not_carried_over() -> None:
    wrong = chordal.loads("G20 G90 S9 M3\nG0 X0 Y0 Z0\nG2 X1. Y0 I.6 J0 F9.\nM30\n", "haas-vf2")
    done = wrong.convert("fadal-4020")
    assert not done.holds and done.text == ""
    assert done.refusals[0].line == 3


def test_what_is_not_verified_is_not_the_same() -> None:
    text = "G21 G90 S900 M3\nG1 X9. F50.\nG33 Z-5. F2.\nX5.\nM30\n"
    one = chordal.loads(text, control="fanuc", name="part.nc")
    found = one.compare(chordal.loads(text, control="fanuc"))
    assert found.verdict == "not-verified" and not found
