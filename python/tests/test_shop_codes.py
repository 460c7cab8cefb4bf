"""M codes and macro calls of a shop's own."""

from __future__ import annotations

import os
import signal
import threading
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor

import pytest

import chordal
from chordal import ShopCall, ShopRefusal, ShopWait

FLIP = """\
O0001 (PART)
G21 G90 G0 X10. Y0. Z5.
M120 P2
G65 P9010 A1.5
X30.
M30
"""


def kinds(program: chordal.Program) -> list[tuple[int, str, float | None, str | None]]:
    """Dwells and moves with their line, seconds or X, and text."""
    table = program.commands()
    columns = ("line", "kind", "seconds", "x_to_mm", "text")
    rows = zip(*(table[name].tolist() for name in columns), strict=True)
    return [
        (line, kind, seconds if kind == "dwell" else x, text)
        for line, kind, seconds, x, text in rows
        if kind in ("dwell", "rapid", "line")
    ]


def test_answers_by_code() -> None:
    program = chordal.loads(
        FLIP, "haas-vf2", shop_codes={"m0120": 2.5, "O9010": "G91 G0 X#1\nG90\n"}
    )
    assert program.diagnostics == ()
    assert kinds(program) == [
        (2, "rapid", 10.0, None),
        (3, "dwell", 2.5, "M120"),
        (1, "rapid", 11.5, None),
        (5, "rapid", 30.0, None),
    ]
    assert "custom code O9010" in program.commands()["file"].tolist()
    assert program.summary.dwell_time_s == 2.5
    without = chordal.loads(FLIP, "haas-vf2")
    assert [each.code for each in without.errors] == ["CH301", "CH201"]


def test_a_function_sees_the_block_and_the_state() -> None:
    seen: list[ShopCall] = []

    def shop(call: ShopCall) -> ShopWait | None:
        seen.append(call)
        return ShopWait(1.0, "part flip") if call.code == "M120" else None

    program = chordal.loads(FLIP, "haas-vf2", name="part.nc", shop_codes=shop)
    assert [each.code for each in program.diagnostics] == ["CH201"], "None is no answer"
    flip, macro = seen
    assert (flip.code, flip.file, flip.line, flip.text) == ("M120", "part.nc", 3, "M120 P2")
    assert (flip.words, flip.arguments, flip.nth) == ({"M": 120.0, "P": 2.0}, {}, 0)
    assert flip.position[:3] == (10.0, 0.0, 5.0) and len(flip.position) == 6
    assert (flip.tool, flip.inch, flip.incremental, flip.spindle_rpm) == (0, False, False, 0.0)
    assert (macro.code, macro.words, macro.arguments, macro.nth) == ("O9010", {}, {1: 1.5}, 1)
    assert (3, "dwell", 1.0, "part flip") in kinds(program)


def test_each_call_is_asked_once_whatever_is_asked_of_the_program() -> None:
    times: Iterator[int] = iter(range(1, 100))
    program = chordal.loads(
        "G21 G90\nM120\nM120\nM30\n", "haas-vf2", shop_codes=lambda call: float(next(times))
    )
    assert next(times) == 3
    assert program.summary.dwell_time_s == 3.0
    assert program.time(what_if=True).total_s == pytest.approx(3.0)
    assert [row[2] for row in kinds(program)] == [1.0, 2.0]
    assert len(program.trajectory(0.01)) > 0 and next(times) == 4


def test_a_refusal_is_a_problem_at_the_word() -> None:
    program = chordal.loads(
        FLIP, "haas-vf2", shop_codes=lambda call: ShopRefusal(f"no {call.code} today")
    )
    first = program.errors[0]
    assert (first.code, first.line) == ("CH212", 3)
    assert "no M120 today" in first.message and "^^^^" in first.text


def test_problems_within_blocks_of_the_shop_name_them() -> None:
    program = chordal.loads("G21 G90\nM120\nM30\n", "haas-vf2", shop_codes={"M120": "G0 X1.\nG777\n"})
    problem = program.errors[0]
    place = problem.primary.place
    assert place is not None and (place.file, place.line) == ("custom code M120", 2)
    assert "called from line 2: M120" in problem.text


def test_an_exception_is_the_exception_of_load_with_the_block() -> None:
    def shop(call: ShopCall) -> float:
        return {"M121": 1.0}[call.code]

    with pytest.raises(KeyError, match="M120") as caught:
        chordal.loads(FLIP, "haas-vf2", name="part.nc", shop_codes=shop)
    assert caught.value.__notes__ == ["asked about M120 in part.nc, line 3: M120 P2"]
    with pytest.raises(chordal.UsageError, match="the answer for M120 is True"):
        chordal.loads(FLIP, "haas-vf2", shop_codes=lambda call: True)


@pytest.mark.parametrize("codes", [{"120": 1.0}, {"G120": 1.0}, {"M120": [1]}, {"M": 1}])
def test_what_is_no_code_or_no_answer_is_told_at_once(codes: dict[str, float]) -> None:
    with pytest.raises(chordal.UsageError):
        chordal.loads("M30\n", "haas-vf2", shop_codes=codes)


def test_the_machine_may_name_codes() -> None:
    machine = {"inherits": "haas-vf2", "shop_codes": {"M120": {"time": "2.5 s", "label": "flip"}}}
    assert (2, "dwell", 2.5, "flip") in kinds(chordal.loads("G21\nM120\nM30\n", machine))


def test_threads_share_a_program_with_codes_of_the_shop() -> None:
    program = chordal.loads(FLIP, "haas-vf2", shop_codes={"M120": 2.5, "O9010": "G4 P1."})
    with ThreadPoolExecutor(4) as pool:
        totals = list(pool.map(lambda _: program.time().total_s, range(8)))
    assert len(set(totals)) == 1


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
def test_ctrl_c_ends_work_that_has_begun() -> None:
    text = "G21 G90 F500. S900 M3\n" + "G1 X1.\nX0\n" * 2_000_000 + "M30\n"
    program = chordal.loads(text, "haas-vf2")
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        threading.Timer(0.3, signal.raise_signal, [signal.SIGINT]).start()
        begun = time.monotonic()
        with pytest.raises(KeyboardInterrupt):
            program.trajectory(0.001)
        assert time.monotonic() - begun >= 0.25
        # Nothing that was cut short is kept.
        threading.Timer(0.3, signal.raise_signal, [signal.SIGINT]).start()
        with pytest.raises(KeyboardInterrupt):
            _ = program.summary
    finally:
        signal.signal(signal.SIGINT, before)
