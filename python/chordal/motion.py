"""The planner and the sampler on their own: from curves to timed setpoints within all limits.

>>> from chordal.motion import AxisLimit, Path, plan
>>> limit = AxisLimit(velocity=400.0, acceleration=3000.0, jerk=100_000.0)
>>> path = Path((0, 0, 0)).line_to((50, 0, 0), speed=100, tolerance=0.02)
>>> path = path.arc_to((60, 10, 0), center=(50, 10), speed=100).dwell(0.5)
>>> motion = plan(path, {"X": limit, "Y": limit, "Z": limit})
>>> setpoints = motion.sample(0.001)
>>> setpoints.position.shape[1]
6

Lengths are mm, rotary axes radians, times s. Arrays over axes are X Y Z A B C.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
import numpy.typing as npt

from . import _chordal, geometry
from ._table import Table
from .errors import UsageError
from .geometry import Curve, PointLike

__all__ = ["AxisLimit", "Dwell", "Motion", "Move", "Path", "Setpoints", "plan"]

#: Rotary axes A, B and C, rad.
Rotary = tuple[float, float, float]

_AXES = "XYZABC"


@dataclass(frozen=True, slots=True)
class AxisLimit:
    """The limits of an axis: mm/s, mm/s², mm/s³, or rad/s, rad/s², rad/s³."""

    velocity: float
    acceleration: float
    jerk: float


@dataclass(frozen=True, slots=True)
class Move:
    """A curve of the path and its speed. Rotary axes turn uniformly along it."""

    curve: Curve
    #: The largest speed along it, mm/s (rad/s if only rotary axes move); ``None`` for as fast as the axes can move.
    speed: float | None = None
    #: How far from its end the corner may be rounded, mm; 0 for an exact corner, ``None`` for a stop.
    tolerance: float | None = None
    #: The same tolerance for rotary axes, rad.
    rotary_tolerance: float = 0.0
    #: Whether it is a rapid and not a cut.
    rapid: bool = False
    #: The rotary axes at the start and at the end, rad.
    rotary_from: Rotary = (0.0, 0.0, 0.0)
    rotary_to: Rotary = (0.0, 0.0, 0.0)


@dataclass(frozen=True, slots=True)
class Dwell:
    """The axes stand still."""

    #: The time, s.
    seconds: float


@dataclass(frozen=True, slots=True)
class Path:
    """A path: each method returns a new path with one more move."""

    #: The start point, mm.
    start: PointLike
    moves: tuple[Move | Dwell, ...] = field(default=())

    @property
    def end(self) -> PointLike:
        """The end point, mm."""
        moves = (move for move in reversed(self.moves) if isinstance(move, Move))
        return next((move.curve.end for move in moves), self.start)

    def then(
        self,
        curve: Curve,
        *,
        speed: float | None = None,
        tolerance: float | None = None,
        rapid: bool = False,
    ) -> Path:
        """Adds a curve, which must begin at the end of the path."""
        move = Move(curve, speed=speed, tolerance=tolerance, rapid=rapid)
        return Path(self.start, (*self.moves, move))

    def line_to(
        self, end: PointLike, *, speed: float | None = None, tolerance: float | None = None
    ) -> Path:
        """Adds a straight cut."""
        return self.then(geometry.line(self.end, end), speed=speed, tolerance=tolerance)

    def rapid_to(self, end: PointLike, *, tolerance: float | None = None) -> Path:
        """Adds a straight rapid, as fast as the axes can move."""
        return self.then(geometry.line(self.end, end), tolerance=tolerance, rapid=True)

    def arc_to(
        self,
        end: PointLike,
        *,
        center: tuple[float, float] | None = None,
        radius: float | None = None,
        clockwise: bool = False,
        plane: geometry._PlaneName = "xy",
        speed: float | None = None,
        tolerance: float | None = None,
    ) -> Path:
        """Adds an arc or a helix, with the arguments of :func:`chordal.geometry.arc`."""
        curve = geometry.arc(
            self.end, end, center=center, radius=radius, clockwise=clockwise, plane=plane
        )
        return self.then(curve, speed=speed, tolerance=tolerance)

    def dwell(self, seconds: float) -> Path:
        """Adds a time in which the axes stand still, s."""
        return Path(self.start, (*self.moves, Dwell(seconds)))

    def __iter__(self) -> Iterator[Move | Dwell]:
        return iter(self.moves)

    def __len__(self) -> int:
        return len(self.moves)


class Setpoints(Table):
    """Setpoints of the six axes at a fixed period, mm and rad; ``move`` is the number of the move."""

    __slots__ = ()

    @property
    def time(self) -> npt.NDArray[np.float64]:
        """Time of each setpoint from the start (rows,), s."""
        return self["time_s"]

    @property
    def position(self) -> npt.NDArray[np.float64]:
        """Positions (rows, 6), mm and rad."""
        return self._six("position")

    @property
    def velocity(self) -> npt.NDArray[np.float64]:
        """Velocities (rows, 6), mm/s and rad/s."""
        return self._six("velocity")

    @property
    def acceleration(self) -> npt.NDArray[np.float64]:
        """Accelerations (rows, 6), mm/s² and rad/s²."""
        return self._six("acceleration")

    @property
    def jerk(self) -> npt.NDArray[np.float64]:
        """Jerks (rows, 6), mm/s³ and rad/s³."""
        return self._six("jerk")

    def _six(self, order: str) -> npt.NDArray[np.float64]:
        return self.array(*(f"{axis.lower()}_{order}" for axis in _AXES))


class Motion:
    """A planned motion. It never changes."""

    __slots__ = ("_motion",)

    def __init__(self, motion: _chordal.Motion) -> None:
        self._motion = motion

    @property
    def duration(self) -> float:
        """The duration, s."""
        return self._motion.duration

    def sample(self, period: float, *, max_samples: int = 100_000_000) -> Setpoints:
        """Setpoints every ``period`` seconds: the first is the start, the last the end."""
        return Setpoints(self._motion.sample(period, max_samples))

    def __repr__(self) -> str:
        return f"<Motion of {self.duration} s>"


def plan(
    path: Path | list[Move | Dwell] | tuple[Move | Dwell, ...],
    limits: Mapping[str, AxisLimit],
    level: Literal["fast", "best"] = "fast",
) -> Motion:
    """Plan connected moves, from standstill to standstill, within the limits of all axes.

    ``limits`` is a dictionary by axis letter; an axis without limits must not move. Moves that cannot be planned
    raise :class:`~chordal.UsageError` with the number of the move.
    """
    unknown = [axis for axis in limits if axis not in tuple(_AXES)]
    if unknown:
        raise UsageError(f"there is no axis {unknown[0]!r}", f"the axes are {', '.join(_AXES)}")
    given = [_of_limit(limits.get(axis)) for axis in _AXES]
    return Motion(_chordal.plan([_of_move(move) for move in path], given, level))


def _of_limit(limit: AxisLimit | None) -> tuple[float, float, float] | None:
    return None if limit is None else (limit.velocity, limit.acceleration, limit.jerk)


def _of_move(move: Move | Dwell) -> _chordal._GivenMove:
    if isinstance(move, Dwell):
        none: Rotary = (0.0, 0.0, 0.0)
        return (None, none, none, move.seconds, None, 0.0, False)
    return (
        move.curve._curve,
        move.rotary_from,
        move.rotary_to,
        move.speed,
        move.tolerance,
        move.rotary_tolerance,
        move.rapid,
    )
