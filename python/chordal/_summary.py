"""What a run comes to."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, slots=True)
class AxisTravel:
    """Where an axis goes, in the frame of the run: mm, or degrees."""

    letter: str
    #: Lowest and highest place.
    range: tuple[float, float]
    #: Lowest and highest place while cutting.
    cut_range: tuple[float, float] | None
    #: All ways added up.
    way: float


@dataclass(frozen=True, slots=True)
class ToolUse:
    """What one tool does; 0 is whatever is in the spindle before any tool was changed."""

    number: int
    feed_length_mm: float
    feed_time_s: float
    rapid_time_s: float


@dataclass(frozen=True, slots=True)
class Summary:
    """Counts, lengths and times. Times here are distance over feed, without acceleration;
    :meth:`chordal.Program.time` plans."""

    #: The program ends in inches.
    inch: bool
    lines: int
    arcs: int
    helices: int
    spirals: int
    rapids: int
    dwells: int
    #: Cuts without a feed, of which the time is not known.
    cuts_without_time: int
    feed_length_mm: float
    rapid_length_mm: float
    feed_time_s: float
    rapid_time_s: float
    dwell_time_s: float
    axes: tuple[AxisTravel, ...]
    tools: tuple[ToolUse, ...]

    @property
    def total_time_s(self) -> float:
        """Time of everything that has one, s."""
        return self.feed_time_s + self.rapid_time_s + self.dwell_time_s


def of_dict(told: dict[str, Any]) -> Summary:
    """A summary from what the compiled module tells."""
    axes = tuple(AxisTravel(*each) for each in told.pop("axes"))
    tools = tuple(ToolUse(*each) for each in told.pop("tools"))
    return Summary(axes=axes, tools=tools, **told)
