"""Programs compared with each other, and converted for other machines."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

from ._transform import Change

__all__ = ["Comparison", "Conversion", "Refusal"]


@dataclass(frozen=True, slots=True)
class Comparison:
    """Two programs compared with each other."""

    #: The path and everything else are the same; the paths are within the tolerance; something is different;
    #: no difference was found, and at least one program is not :attr:`~chordal.Program.verified`.
    verdict: Literal["same", "within", "different", "not-verified"]
    #: The largest distance of the two paths; ``None`` if one of them has no moves.
    max_distance_mm: float | None
    #: Each with its ``category``, and the ``lines``, ``text`` and ``value`` of both (``a``, ``b``), as
    #: ``chordal compare --format json`` writes it.
    differences: tuple[Mapping[str, Any], ...]

    def __bool__(self) -> bool:
        """Whether the motion is known to be the same, or within the tolerance."""
        return self.verdict in ("same", "within")


@dataclass(frozen=True, slots=True)
class Refusal:
    """A block that cannot be converted."""

    #: Its line in the old text, from 1; 0 for the program as a whole.
    line: int
    #: Its words.
    text: str
    #: Why.
    reason: str


@dataclass(frozen=True, slots=True)
class Conversion:
    """A program for another machine."""

    #: The new text; empty where the program has errors on its own control.
    text: str
    #: Nothing was refused, and the motion is proved the same.
    holds: bool
    #: What was changed, in the order of the old text.
    changes: tuple[Change, ...]
    #: What could not be converted.
    refusals: tuple[Refusal, ...]
    #: The old program on its machine against the new one on the other.
    proof: Comparison | None
    #: Cycles that stay although the new control makes their pecks in other steps, as in the JSON of
    #: ``chordal convert``; none with ``exact_cycles``.
    pecks: tuple[Mapping[str, Any], ...] = ()


def comparison(document: Mapping[str, Any]) -> Comparison:
    """A comparison of its JSON."""
    differences = tuple(document["differences"])
    return Comparison(document["verdict"], document["max_distance_mm"], differences)


def conversion(document: Mapping[str, Any]) -> Conversion:
    """A conversion of its JSON."""
    proof = document["proof"]
    return Conversion(
        document["text"],
        document["holds"],
        tuple(Change(**change) for change in document["changes"]),
        tuple(Refusal(**refusal) for refusal in document["refusals"]),
        None if proof is None else comparison(proof),
        tuple(document["pecks"]),
    )
