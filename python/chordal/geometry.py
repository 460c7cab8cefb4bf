"""The exact curves of machining on their own: lines, arcs, helices, spirals and curves on cones.

Lengths are mm, angles radians, points are three numbers X Y Z. Positions on a curve are arc lengths ``s`` from the
start; ``s`` outside the curve means the nearer end.

>>> from chordal.geometry import arc
>>> quarter = arc((10, 0, 0), (0, 10, 0), center=(0, 0))
>>> round(quarter.length, 9)
15.707963268
>>> quarter.points([0.0, quarter.length]).tolist()
[[10.0, 0.0, 0.0], [0.0, 10.0, 0.0]]
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Literal, final

import numpy as np
import numpy.typing as npt

from . import _chordal
from .errors import UsageError

if TYPE_CHECKING:
    #: A plane, named by its axes in the order that defines counter-clockwise.
    _PlaneName = Literal["xy", "zx", "yz"]

__all__ = ["Curve", "Point", "PointLike", "arc", "arc_through", "helix", "line", "spiral"]

#: X, Y and Z, mm.
Point = tuple[float, float, float]

#: Three numbers, as a tuple, a list or an array.
PointLike = Sequence[float] | npt.NDArray[np.floating]


@final
class Curve:
    """A line, an arc, a helix, a spiral or a curve on a cone. It never changes."""

    __slots__ = ("_curve",)

    def __init__(self, curve: _chordal.Curve) -> None:
        self._curve = curve

    @property
    def kind(self) -> Literal["line", "arc", "spiral"]:
        """What it is; a helix is an arc that rises."""
        return self._curve.kind

    @property
    def start(self) -> Point:
        """The start point, exactly as given."""
        return self._curve.start

    @property
    def end(self) -> Point:
        """The end point, exactly as given."""
        return self._curve.end

    @property
    def length(self) -> float:
        """Its length, mm."""
        return self._curve.length

    @property
    def sweep(self) -> float:
        """The angle that it turns, rad; positive counter-clockwise, 0 for a line."""
        return self._curve.sweep

    @property
    def center(self) -> Point | None:
        """Its centre at the height of the start; ``None`` for a line."""
        return self._curve.center

    @property
    def radii(self) -> tuple[float, float] | None:
        """Its radii at start and end, mm; ``None`` for a line."""
        return self._curve.radii

    @property
    def max_curvature(self) -> float:
        """Its largest curvature, 1/mm."""
        return self._curve.max_curvature

    @property
    def bounds(self) -> tuple[Point, Point]:
        """The lowest and the highest corner of its exact bounding box."""
        return self._curve.bounds

    def points(self, s: Iterable[float]) -> npt.NDArray[np.float64]:
        """The points at these arc lengths (n, 3), mm."""
        return np.asarray(self._curve.points(_lengths(s)))

    def tangents(self, s: Iterable[float]) -> npt.NDArray[np.float64]:
        """The unit vectors of travel at these arc lengths (n, 3)."""
        return np.asarray(self._curve.tangents(_lengths(s)))

    def curvatures(self, s: Iterable[float]) -> npt.NDArray[np.float64]:
        """The curvature vectors at these arc lengths (n, 3), 1/mm."""
        return np.asarray(self._curve.curvatures(_lengths(s)))

    def chords(
        self, tolerance: float, placement: Literal["inscribed", "balanced"] = "inscribed"
    ) -> npt.NDArray[np.float64]:
        """The end points (n + 1, 3) of n chords within a tolerance, mm."""
        if placement not in ("inscribed", "balanced"):
            raise UsageError(
                f"there is no placement {placement!r}", "chords are `inscribed` or `balanced`"
            )
        return np.asarray(self._curve.chords(tolerance, placement == "balanced"))

    def nearest(self, point: PointLike) -> tuple[float, Point, float]:
        """The nearest point of the curve to a point: its arc length, the point, and the distance, mm."""
        return self._curve.nearest(_point(point))

    def split(self, s: float) -> tuple[Curve, Curve]:
        """The part before an arc length and the part after it; they share the end point between them."""
        before, after = self._curve.split(s)
        return Curve(before), Curve(after)

    def reversed(self) -> Curve:
        """The same curve in the opposite direction."""
        return Curve(self._curve.reversed())

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Curve) and self._curve == other._curve

    def __hash__(self) -> int:
        return hash((self.start, self.end, self.length))

    def __repr__(self) -> str:
        return repr(self._curve)


def line(start: PointLike, end: PointLike) -> Curve:
    """A straight line."""
    return Curve(_chordal.line(_point(start), _point(end)))


def arc(
    start: PointLike,
    end: PointLike,
    *,
    center: tuple[float, float] | None = None,
    radius: float | None = None,
    clockwise: bool = False,
    plane: _PlaneName = "xy",
    extra_turns: int = 0,
    tolerance: float = 1e-9,
) -> Curve:
    """The arc, or the helix if the height changes, from ``start`` to ``end``.

    The centre is given by ``center``, in the two coordinates of the plane, or by ``radius``, which is negative for an
    arc of more than half a turn. Ends on the same ray from the centre make a full turn, and ``extra_turns`` are
    added. Radii at the ends that differ by more than ``tolerance`` mm make a spiral. If the chord exceeds the
    diameter by up to ``tolerance`` mm, the arc is a half circle.
    """
    a, b = _point(start), _point(end)
    if center is not None and radius is None:
        return Curve(
            _chordal.arc_from_center(
                a,
                b,
                (float(center[0]), float(center[1])),
                plane=plane,
                clockwise=clockwise,
                extra_turns=extra_turns,
                radius_tolerance=tolerance,
            )
        )
    if radius is not None and center is None and extra_turns == 0:
        return Curve(
            _chordal.arc_from_radius(
                a, b, radius, plane=plane, clockwise=clockwise, midpoint_tolerance=tolerance
            )
        )
    raise UsageError(
        "an arc takes either a centre or a radius, and turns more than once about a centre only",
        "give `center=(a, b)` or `radius=r`",
    )


def arc_through(start: PointLike, via: PointLike, end: PointLike) -> Curve:
    """The arc of less than one turn through three points in space."""
    return Curve(_chordal.arc_through(_point(start), _point(via), _point(end)))


def helix(
    center: PointLike,
    radius: float,
    sweep: float,
    rise: float,
    *,
    normal: PointLike = (0.0, 0.0, 1.0),
    towards: PointLike = (1.0, 0.0, 0.0),
) -> Curve:
    """The helix that begins at ``radius`` mm along ``towards`` from the centre, turns about
    ``normal`` by ``sweep`` rad and rises along it by ``rise`` mm."""
    return spiral(center, radius, radius, sweep, rise=rise, normal=normal, towards=towards)


def spiral(
    center: PointLike,
    radius_from: float,
    radius_to: float,
    sweep: float,
    *,
    rise: float = 0.0,
    normal: PointLike = (0.0, 0.0, 1.0),
    towards: PointLike = (1.0, 0.0, 0.0),
) -> Curve:
    """The Archimedean spiral, or the curve on a cone where it rises, that begins at ``radius_from`` mm
    along ``towards`` from the centre and turns about ``normal`` by ``sweep`` rad."""
    return Curve(
        _chordal.spiral(
            _point(center),
            radius_from,
            radius_to,
            sweep,
            rise=rise,
            normal=_point(normal),
            towards=_point(towards),
        )
    )


def _point(given: PointLike) -> Point:
    if len(given) != 3:
        raise UsageError(f"a point has three coordinates, not {len(given)}", "give X, Y and Z")
    return float(given[0]), float(given[1]), float(given[2])


def _lengths(s: Iterable[float]) -> list[float]:
    return s.ravel().tolist() if isinstance(s, np.ndarray) else [float(each) for each in s]
