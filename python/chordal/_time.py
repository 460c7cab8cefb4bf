"""The time of a program and its parts."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, slots=True)
class ToolTime:
    """The time of one tool, s."""

    tool: int
    changes: int
    total_s: float
    cutting_s: float
    rapid_s: float
    other_s: float
    lost_s: float


@dataclass(frozen=True, slots=True)
class BlockTime:
    """The total time of all executions of one block, s."""

    line: int
    #: The file; ``None`` for the program's own.
    file: str | None
    text: str
    runs: int
    time_s: float
    #: The time of its moves in excess of that at feed or rapid speed.
    lost_s: float
    #: What determines its time.
    reason: str
    #: Why it loses time; ``None`` if it does not.
    loses_by: str | None


@dataclass(frozen=True, slots=True)
class Time:
    """The time of a program on its machine, within the limits of velocity, acceleration and jerk, s."""

    total_s: float
    cutting_s: float
    rapid_s: float
    #: Tool changes, the spindle, dwells.
    other_s: float
    #: The time of the moves in excess of that at feed or rapid speed.
    lost_s: float
    #: Lengths divided by the feed, or by the rapid speed for rapids.
    at_feed_s: float
    moves: int
    tool_changes: int
    #: The waiting times by reason.
    waits: dict[str, float]
    tools: tuple[ToolTime, ...]
    #: The blocks that take the most time, the longest first.
    longest_blocks: tuple[BlockTime, ...]
    #: The blocks that lose the most time, the costliest first.
    costliest_blocks: tuple[BlockTime, ...]
    #: The least time within the limits of velocity and acceleration; ``None`` unless ``bound`` was set.
    bound_s: float | None
    #: Everything, as ``chordal time --format json`` writes it.
    document: dict[str, Any]

    def __str__(self) -> str:
        return (
            f"{self.total_s:.3f} s: {self.cutting_s:.3f} s of cuts, {self.rapid_s:.3f} s of "
            f"rapids, {self.other_s:.3f} s of the rest"
        )


def of_json(text: str) -> Time:
    """A time from the data of the compiled module."""
    answer: dict[str, Any] = json.loads(text)
    tools = tuple(ToolTime(**each) for each in answer["tools"])
    longest, costliest = (
        tuple(_block(each) for each in answer[name]) for name in ("longest_blocks", "costliest_blocks")
    )
    names = ("total_s", "cutting_s", "rapid_s", "other_s", "lost_s", "at_feed_s", "moves")
    return Time(
        **{name: answer[name] for name in names},
        tool_changes=answer["tool_changes"],
        waits=answer["waits"],
        tools=tools,
        longest_blocks=longest,
        costliest_blocks=costliest,
        bound_s=answer.get("bound_s"),
        document=answer,
    )


def _block(answer: dict[str, Any]) -> BlockTime:
    return BlockTime(
        line=answer["line"],
        file=answer.get("file"),
        text=answer["text"],
        runs=answer["runs"],
        time_s=answer["time_s"],
        lost_s=answer["lost_s"],
        reason=answer["reason"],
        loses_by=answer.get("loses_by"),
    )
