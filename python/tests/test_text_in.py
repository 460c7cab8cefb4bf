"""Whatever the text, there is an answer and no crash."""

from __future__ import annotations

import pyarrow
from hypothesis import given, settings
from hypothesis import strategies as st

import chordal

CONTROLS = st.sampled_from(["fadal", "haas", "fanuc", "mitsubishi", "linuxcnc"])

word = st.builds(
    lambda letter, number: f"{letter}{number}",
    st.sampled_from("GMXYZABCIJKRFSTHDPQLON#/"),
    st.one_of(
        st.integers(0, 200),
        st.floats(-999, 999).map(lambda value: f"{value:.3f}"),
        st.sampled_from(["", ".", "-", "1.", "[1+2]", "#100", "1e5", "--1"]),
    ),
)
block = st.one_of(
    st.lists(word, max_size=7).map(" ".join),
    st.sampled_from(
        ["%", "O1000", "(COMMENT", "IF[#1EQ1]GOTO1", "WHILE[1EQ1]DO1", "END1", "M98 P1000 L3"]
    ),
)
programs = st.lists(block, max_size=25).map("\n".join)


def ask_everything(program: chordal.Program) -> None:
    problems = program.diagnostics
    assert all(problem.text and problem.code.startswith("CH") for problem in problems)
    commands = pyarrow.table(program.commands())
    commands.validate(full=True)
    pyarrow.table(program.tool_path()).validate(full=True)
    pyarrow.table(program.path()).validate(full=True)
    assert program.summary.total_time_s >= 0
    assert program.svg(400, 300).startswith("<")


@settings(max_examples=60, deadline=None)
@given(programs, CONTROLS)
def test_blocks(text: str, control: str) -> None:
    ask_everything(chordal.loads(text, control=control, max_blocks=2000))  # type: ignore[arg-type]


@settings(max_examples=60, deadline=None)
@given(st.binary(max_size=300), CONTROLS)
def test_bytes(text: bytes, control: str) -> None:
    ask_everything(chordal.loads(text, control=control, max_blocks=2000))  # type: ignore[arg-type]


@settings(max_examples=60, deadline=None)
@given(st.text(max_size=200))
def test_text(text: str) -> None:
    ask_everything(chordal.loads(text, max_blocks=2000))


@settings(max_examples=60, deadline=None)
@given(st.dictionaries(st.text(max_size=6), st.recursive(
    st.one_of(st.text(max_size=6), st.integers(), st.floats(), st.booleans()),
    lambda inner: st.one_of(
        st.lists(inner, max_size=3), st.dictionaries(st.text(max_size=4), inner, max_size=3)
    ),
    max_leaves=6,
), max_size=4))
def test_dictionaries_are_machines_or_told(told: dict[str, object]) -> None:
    try:
        chordal.Machine.from_dict({"control": "haas", **told})
    except chordal.MachineError as error:
        assert all(problem.message for problem in error.problems)
