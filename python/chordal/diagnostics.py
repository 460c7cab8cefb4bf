"""Problems of a program: where, what, what the control would show, and what to do."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from typing import Any, Literal

from . import _chordal

__all__ = ["CodeInfo", "Diagnostic", "Fix", "Label", "Place", "codes"]

#: The style that a notebook needs for problems in the form of the setup sheet.
_STYLE = (
    "<style>.chordal-problems .problem{border-left:3px solid #2f5d8a;margin:0 0 .6em;padding:.1em .8em}"
    ".chordal-problems .error{border-color:#b3261e}.chordal-problems .warning{border-color:#8a6100}"
    ".chordal-problems h3{margin:0;font-size:1em}.chordal-problems p{margin:.1em 0}"
    ".chordal-problems pre{white-space:pre;overflow-x:auto;line-height:1.35}</style>"
)


@dataclass(frozen=True, slots=True)
class Place:
    """A range of words in a text. Lines and columns count from 1, columns in characters; ends are after the last one.
    ``start`` and ``end`` are byte offsets."""

    file: str
    line: int
    column: int
    end_line: int
    end_column: int
    start: int
    end: int


@dataclass(frozen=True, slots=True)
class Label:
    """Words of a text with a label."""

    #: The words; ``None`` for the program as a whole.
    place: Place | None
    #: The label; may be empty.
    text: str


@dataclass(frozen=True, slots=True)
class Fix:
    """A replacement of some words."""

    #: What it does, in the imperative.
    title: str
    #: The new words.
    replacement: str
    #: ``safe`` certainly keeps the meaning; ``unsafe`` must be checked by a person.
    applicability: Literal["safe", "unsafe"]
    #: The file whose bytes from ``start`` to ``end`` are replaced.
    file: str
    start: int
    end: int


@dataclass(frozen=True, slots=True)
class Call:
    """A block with a call."""

    file: str | None
    line: int | None
    text: str


@dataclass(frozen=True, slots=True)
class Diagnostic:
    """One problem of a program."""

    #: Stable number, such as ``CH401``; ``chordal explain CH401`` explains it.
    code: str
    #: Stable name, such as ``radius-mismatch``.
    name: str
    #: Its severity in this case.
    severity: Literal["error", "warning", "note"]
    #: One sentence with the measured numbers in the program's units.
    message: str
    #: The words that cause it.
    primary: Label
    #: Other words that belong to it.
    secondary: tuple[Label, ...]
    #: What the control itself would show; ``None`` if unknown.
    alarm: str | None
    #: Further information.
    notes: tuple[str, ...]
    #: What to do; ``None`` without advice.
    help: str | None
    #: The most likely fix; ``None`` without one.
    fix: Fix | None
    #: Alternative fixes, the most likely one first.
    other_fixes: tuple[Fix, ...]
    #: The calls through which the block was reached, the innermost first.
    calls: tuple[Call, ...]
    #: The whole problem as text, with the words underlined.
    text: str
    #: The problem in HTML, as on a setup sheet.
    html: str = field(repr=False, compare=False)

    @property
    def line(self) -> int | None:
        """The line of the words that cause it, from 1."""
        return None if self.primary.place is None else self.primary.place.line

    def __str__(self) -> str:
        return self.text

    def _repr_html_(self) -> str:
        return problems_html((self,))


@dataclass(frozen=True, slots=True)
class CodeInfo:
    """What the registry holds about a code."""

    code: str
    name: str
    severity: str
    summary: str
    explanation: str


def codes() -> tuple[CodeInfo, ...]:
    """All codes of diagnostics, in order."""
    return tuple(CodeInfo(*row) for row in _chordal.codes())


def problems_html(diagnostics: tuple[Diagnostic, ...]) -> str:
    """Problems for a notebook, as the setup sheet shows them."""
    shown = "".join(each.html for each in diagnostics)
    return f'{_STYLE}<div class="chordal-problems">{shown}</div>'


def of_json(document: str, drawn: list[tuple[str, str]]) -> tuple[Diagnostic, ...]:
    """Problems from the data of the compiled module."""
    objects = json.loads(document)["diagnostics"]
    return tuple(_of_object(each, *shown) for each, shown in zip(objects, drawn, strict=True))


def _of_object(answer: dict[str, Any], text: str, html: str) -> Diagnostic:
    fix = answer["fix"]
    return Diagnostic(
        code=answer["code"],
        name=answer["name"],
        severity=answer["severity"],
        message=answer["message"],
        primary=_label(answer),
        secondary=tuple(_label(each) for each in answer["secondary"]),
        alarm=answer["alarm"],
        notes=tuple(answer["notes"]),
        help=answer["help"],
        fix=None if fix is None else Fix(**fix),
        other_fixes=tuple(Fix(**each) for each in answer["other_fixes"]),
        calls=tuple(Call(**each) for each in answer["calls"]),
        text=text,
        html=html,
    )


def _label(answer: dict[str, Any]) -> Label:
    names = ("file", "line", "column", "end_line", "end_column", "start", "end")
    place = None if answer["line"] is None else Place(**{name: answer[name] for name in names})
    return Label(place, answer["label"])
