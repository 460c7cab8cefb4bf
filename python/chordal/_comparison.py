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

    #: ``same``: the path and everything else are the same. ``within``: the paths are within the tolerance.
    #: ``different``: something is different. ``not-verified``: no difference was found, but at least one program is
    #: not :attr:`~chordal.Program.verified`.
    verdict: Literal["same", "within", "different", "not-verified"]
    #: The largest distance between the two paths, mm; ``None`` if one of them has no moves.
    max_distance_mm: float | None
    #: The differences, each with its ``category`` and the ``lines``, ``text`` and ``value`` of both programs (``a``,
    #: ``b``), as ``chordal compare --format json`` writes it.
    differences: tuple[Mapping[str, Any], ...]

    def __bool__(self) -> bool:
        """Whether the motion is known to be the same or within the tolerance."""
        return self.verdict in ("same", "within")


@dataclass(frozen=True, slots=True)
class Refusal:
    """A block that cannot be converted."""

    #: Its line in the old text, from 1; 0 for the program as a whole.
    line: int
    #: Its words.
    text: str
    #: The reason.
    reason: str


@dataclass(frozen=True, slots=True)
class Conversion:
    """A program for another machine."""

    #: The new text; empty if the program has errors on its own control.
    text: str
    #: Whether nothing was refused and the motion is proved to be the same.
    holds: bool
    #: The changes, in the order of the old text.
    changes: tuple[Change, ...]
    #: The blocks that could not be converted.
    refusals: tuple[Refusal, ...]
    #: The comparison of the old program on its machine with the new one on its machine; ``None`` without a new text.
    proof: Comparison | None
    #: Cycles that are kept although the new control makes different pecks, as in the JSON of ``chordal convert``;
    #: empty with ``exact_cycles``.
    pecks: tuple[Mapping[str, Any], ...] = ()


def comparison(document: Mapping[str, Any]) -> Comparison:
    """A comparison from its JSON."""
    differences = tuple(document["differences"])
    return Comparison(document["verdict"], document["max_distance_mm"], differences)


def conversion(document: Mapping[str, Any]) -> Conversion:
    """A conversion from its JSON."""
    proof = document["proof"]
    return Conversion(
        document["text"],
        document["holds"],
        tuple(Change(**change) for change in document["changes"]),
        tuple(Refusal(**refusal) for refusal in document["refusals"]),
        None if proof is None else comparison(proof),
        tuple(document["pecks"]),
    )
