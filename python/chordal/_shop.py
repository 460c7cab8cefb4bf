"""Custom M codes and custom programs: the data of each call, and the possible answers."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from .errors import UsageError

__all__ = ["ShopAnswer", "ShopCall", "ShopCodes", "ShopRefusal", "ShopWait"]


@dataclass(frozen=True, slots=True)
class ShopCall:
    """A custom code in its block, and the state of the control before the moves of the block."""

    #: The code, such as ``"M120"``; ``"O9010"`` is a called program that does not exist.
    code: str
    #: The name of the file.
    file: str
    #: The line of the block, from 1.
    line: int
    #: The block.
    text: str
    #: The block's words by letter, numbers as written; empty if they are arguments.
    words: Mapping[str, float]
    #: The local variables that a macro call sets, by number.
    arguments: Mapping[int, float]
    #: The tool in the spindle.
    tool: int
    #: The position of the tool tip on X, Y, Z, A, B and C in program coordinates, mm and degrees; ``None`` if
    #: unknown.
    position: tuple[float | None, ...]
    #: Whether the program is in inches.
    inch: bool
    #: Whether G91 is active.
    incremental: bool
    #: The spindle speed, rev/min; 0 if the spindle does not turn.
    spindle_rpm: float
    #: The number of earlier calls in this run.
    nth: int


@dataclass(frozen=True, slots=True)
class ShopWait:
    """The machine waits."""

    #: The duration, s.
    seconds: float
    #: The reason for the wait; by default the code itself.
    label: str | None = None


@dataclass(frozen=True, slots=True)
class ShopRefusal:
    """The machine refuses the code: an error of the program at this word."""

    #: The reason.
    message: str


#: What the machine does: unknown (``None``), a wait in seconds, NC blocks, or a refusal.
ShopAnswer = float | str | ShopWait | ShopRefusal | None

#: A function that answers, or a dictionary of answers by code: ``{"M120": 2.5, "O9010": "G91 G28 Z0.\\nG90"}``.
ShopCodes = (
    Callable[[ShopCall], ShopAnswer] | Mapping[str, ShopAnswer | Callable[[ShopCall], ShopAnswer]]
)

_Told = tuple[str, float, str | None] | None


def hook(codes: ShopCodes) -> Callable[..., _Told]:
    """The function that the compiled module calls."""
    rule = codes if callable(codes) else _by_code(codes)

    def asked(
        code: str,
        file: str,
        line: int,
        text: str,
        words: Sequence[tuple[str, float]],
        arguments: Sequence[tuple[int, float]],
        tool: int,
        position: Sequence[float | None],
        inch: bool,
        incremental: bool,
        spindle_rpm: float,
        nth: int,
    ) -> _Told:
        call = ShopCall(
            code=code,
            file=file,
            line=line,
            text=text,
            words=dict(words),
            arguments=dict(arguments),
            tool=tool,
            position=tuple(position),
            inch=inch,
            incremental=incremental,
            spindle_rpm=spindle_rpm,
            nth=nth,
        )
        return _told(code, rule(call))

    return asked


def _by_code(
    codes: Mapping[str, ShopAnswer | Callable[[ShopCall], ShopAnswer]],
) -> Callable[[ShopCall], ShopAnswer]:
    rules = {_normal(code): rule for code, rule in codes.items()}
    for code, rule in rules.items():
        if not callable(rule):
            _told(code, rule)  # wrong answers are reported before the program is read

    def rule_of(call: ShopCall) -> ShopAnswer:
        rule = rules.get(call.code)
        return rule(call) if callable(rule) else rule

    return rule_of


def _normal(code: str) -> str:
    """``m0120`` is ``M120``."""
    match = re.fullmatch(r"([MO])0*(\d+(?:\.\d)?)", code.strip().upper())
    if match is None:
        raise UsageError(
            f"{code!r} cannot be a custom M code or program",
            'an M code is written as "M120", a program as "O9010"',
        )
    return match[1] + match[2].removesuffix(".0")


def _told(code: str, answer: object) -> _Told:
    match answer:
        case None:
            return None
        case ShopWait(seconds, label):
            return ("wait", float(seconds), label)
        case ShopRefusal(message):
            return ("refusal", 0.0, message)
        case str():
            return ("blocks", 0.0, answer)
        case int() | float() if not isinstance(answer, bool):
            return ("wait", float(answer), None)
    raise UsageError(
        f"the answer for {code} is {answer!r}",
        "answer seconds, a text of NC blocks, a ShopWait, a ShopRefusal, or None for no answer",
    )
