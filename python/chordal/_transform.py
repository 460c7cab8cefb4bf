"""Transformed programs, and the proof that the motion is as intended."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

from .errors import UsageError

if TYPE_CHECKING:
    from . import _chordal

__all__ = ["Change", "Part", "Restarted", "Split", "Transformed"]


@dataclass(frozen=True, slots=True)
class Change:
    """What was changed on a line, and why."""

    #: Line of the old text, from 1.
    line: int
    #: The line as it was.
    before: str
    #: The line as it is now; several lines are separated by ``\\n``.
    after: str
    #: The reason.
    reason: str


@dataclass(frozen=True, slots=True)
class Transformed:
    """A program after its changes."""

    #: The new text.
    text: bytes
    #: Whether the new program was run and makes the intended motion, within the tolerance of the certificate.
    proved: bool
    #: The changes, in the order of the steps.
    changes: tuple[Change, ...]
    #: Notes about the changes.
    notes: tuple[str, ...]
    #: The comparison of the intended path with the new one, as ``chordal compare --format json`` writes it.
    certificate: Mapping[str, Any]

    @property
    def max_distance_mm(self) -> float | None:
        """The largest distance of the new path from the intended one; ``None`` without moves."""
        distance: float | None = self.certificate["max_distance_mm"]
        return distance


@dataclass(frozen=True, slots=True)
class Part:
    """One of the programs into which a program was split."""

    #: Its text.
    text: bytes
    #: Its O number, if the whole program has one.
    number: int | None
    #: The first and last line of the whole program that it executes.
    lines: tuple[int, int]
    #: The lines inserted so that it starts in the state of the whole program at that point.
    put_in: tuple[str, ...]
    #: ``"as the whole"``, ``"before a tool change"`` or, if the tool is clear of all cuts, ``"clear"``.
    begins: Literal["as the whole", "before a tool change", "clear"]


@dataclass(frozen=True, slots=True)
class Split:
    """A program in parts."""

    #: The parts in order.
    parts: tuple[Part, ...]
    #: Whether the parts, run one after the other, make the motion of the whole program.
    proved: bool
    #: Notes about the split.
    notes: tuple[str, ...]
    #: The comparison of the whole program with the parts, as ``chordal compare --format json`` writes it.
    certificate: Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class Restarted:
    """A program that begins at a line of another; from there on both do the same."""

    #: Its text.
    text: bytes
    #: The line of the whole program at which it begins.
    line: int
    #: The lines that were inserted before it.
    put_in: tuple[str, ...]
    #: The number of moves that follow, equal in both programs.
    moves: int
    #: Whether the text that follows moves to its first position by itself: retract the spindle before the start.
    goes_to_first_place_itself: bool
    #: Whether the lines repeat G92: the machine must be at the start position of the whole program.
    from_the_start_of_the_whole: bool
    #: M codes before the line that are not repeated, each with its words and its line: clamps, outputs, pallets,
    #: overrides. The proof does not cover what they set.
    not_repeated: tuple[tuple[str, int], ...]


_Steps = list[tuple[str, list[float]]]


def steps(
    shift: Sequence[float] | None,
    rotate: float | None,
    about: Sequence[float],
    mirror: Literal["x", "y"] | None,
    scale: float | None,
    units: Literal["mm", "inch"] | None,
    feed: float,
    speed: float,
    arcs: Literal["radius", "center"] | None,
    chords: float | None,
    simplify: float | None,
    fit: float | None,
    feed_tolerance: float,
    renumber: tuple[int, int] | None,
    no_numbers: bool,
    strip_comments: bool,
    shrink: int | None,
) -> _Steps:
    """The steps in the order of the command."""
    asked: list[tuple[str, Sequence[float] | None]] = [
        (str(units), [] if units else None),
        (f"mirror-{mirror}", [] if mirror else None),
        ("rotate", None if rotate is None else [rotate, *about]),
        ("scale", None if scale is None else [scale]),
        ("shift", shift),
        ("rates", [feed, speed] if (feed, speed) != (1.0, 1.0) else None),
        ("chords", None if chords is None else [chords]),
        ("simplify", None if simplify is None else [simplify]),
        ("fit", None if fit is None else [fit, feed_tolerance]),
        (f"arcs-{arcs}", [] if arcs else None),
        ("strip-comments", [] if strip_comments else None),
        ("no-numbers", [] if no_numbers else None),
        ("renumber", renumber),
        ("shrink", None if shrink is None else [shrink]),
    ]
    wanted = [(name, [float(n) for n in numbers]) for name, numbers in asked if numbers is not None]
    if not wanted:
        raise UsageError("there is nothing to do", "give a change, such as shift=(5, 0, 0)")
    return wanted


def transformed(program: _chordal.Program, wanted: _Steps) -> Transformed:
    """Executes the steps; a refusal is a ``UsageError`` that names the line."""
    return proved_text(*program.transform(wanted))


def proved_text(text: bytes | None, told: str) -> Transformed:
    """The changed text and its proof; a refusal is a ``UsageError`` that names the line."""
    document = json.loads(told)
    if text is None:
        raise UsageError(f"line {document['line']}: {document['message']}", document["help"])
    changes = tuple(Change(**change) for change in document["changes"])
    proved = document["verdict"] == "proved"
    return Transformed(bytes(text), proved, changes, tuple(document["notes"]), document["certificate"])


def restarted(text: bytes | None, told: str) -> Restarted:
    """The program that begins at a line; a refusal is a ``UsageError`` that says why."""
    document = json.loads(told)
    if text is None:
        raise UsageError(f"line {document['line']}: {document['message']}", document["help"])
    return Restarted(
        bytes(text),
        document["line"],
        tuple(document["put_in"]),
        document["moves"],
        document["goes_to_first_place_itself"],
        document["from_the_start_of_the_whole"],
        tuple((code["words"], code["line"]) for code in document["not_repeated"]),
    )


def parts(texts: list[bytes], told: str) -> Split:
    """The result of a split; a refusal is a ``UsageError`` that names the line."""
    document = json.loads(told)
    if document["verdict"] == "refused":
        raise UsageError(f"line {document['line']}: {document['message']}", document["help"])
    found = tuple(
        Part(
            bytes(text),
            one["number"],
            (one["lines"][0], one["lines"][1]),
            tuple(one["put_in"]),
            one["begins"],
        )
        for text, one in zip(texts, document["parts"], strict=True)
    )
    proved = document["verdict"] == "proved"
    return Split(found, proved, tuple(document["notes"]), document["certificate"])
