"""The summary of a run."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, slots=True)
class AxisTravel:
    """The travel of an axis in the frame of the run, mm or degrees."""

    letter: str
    #: Lowest and highest position.
    range: tuple[float, float]
    #: Lowest and highest position while cutting; ``None`` if it has none.
    cut_range: tuple[float, float] | None
    #: The sum of all distances.
    way: float


@dataclass(frozen=True, slots=True)
class ToolUse:
    """What one tool does; 0 is the tool in the spindle before the first tool change."""

    number: int
    feed_length_mm: float
    feed_time_s: float
    rapid_time_s: float


@dataclass(frozen=True, slots=True)
class Summary:
    """Counts, lengths and times. These times are distances divided by feeds, without acceleration;
    :meth:`chordal.Program.time` plans the motion."""

    #: Whether the units are inches at the end of the program.
    inch: bool
    lines: int
    arcs: int
    helices: int
    spirals: int
    splines: int
    rapids: int
    dwells: int
    #: Cuts without a feed; their time is unknown.
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
        """Total time, s."""
        return self.feed_time_s + self.rapid_time_s + self.dwell_time_s


def of_dict(answer: dict[str, Any]) -> Summary:
    """A summary from the data of the compiled module."""
    axes = tuple(AxisTravel(*each) for each in answer.pop("axes"))
    tools = tuple(ToolUse(*each) for each in answer.pop("tools"))
    return Summary(axes=axes, tools=tools, **answer)
