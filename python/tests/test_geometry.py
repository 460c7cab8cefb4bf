"""Curves: what is known of them, and round trips on random ones."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

import chordal
from chordal import geometry
from chordal.geometry import Curve

coordinate = st.floats(-1e4, 1e4, allow_nan=False)
point = st.tuples(coordinate, coordinate, coordinate)
radius = st.floats(1e-3, 1e3)
sweep = st.one_of(st.floats(-30.0, -0.01), st.floats(0.01, 30.0))


@st.composite
def curves(draw: st.DrawFn) -> Curve:
    """A curve of any kind, longer than a micrometre."""
    kind = draw(st.sampled_from(["line", "helix", "spiral"]))
    if kind == "line":
        a, b = draw(point), draw(point)
        assume(math.dist(a, b) > 1e-3)
        return geometry.line(a, b)
    rise = draw(st.floats(-100, 100))
    if kind == "helix":
        return geometry.helix(draw(point), draw(radius), draw(sweep), rise)
    towards = draw(st.sampled_from([(1, 0, 0), (0, 1, 0), (1, 1, 0)]))
    return geometry.spiral(
        draw(point), draw(radius), draw(radius), draw(sweep), rise=rise, towards=towards
    )


@given(curves())
def test_ends_are_exact(curve: Curve) -> None:
    ends = curve.points([0.0, curve.length])
    assert tuple(ends[0]) == curve.start and tuple(ends[1]) == curve.end
    back = curve.reversed()
    assert (back.start, back.end) == (curve.end, curve.start)
    assert back.length == pytest.approx(curve.length, rel=1e-9)
    size = 1e4 + 1e3 + abs(curve.length)
    s = np.linspace(0, curve.length, 7)
    assert back.points(curve.length - s) == pytest.approx(curve.points(s), abs=1e-9 * size)


@given(curves(), st.floats(0.01, 0.99))
def test_split_parts_join(curve: Curve, part: float) -> None:
    before, after = curve.split(part * curve.length)
    assert before.end == after.start
    assert (before.start, after.end) == (curve.start, curve.end)
    assert before.length + after.length == pytest.approx(curve.length, rel=1e-9)


@given(curves(), st.floats(0.0, 1.0))
def test_the_nearest_point_to_a_point_of_the_curve_is_itself(curve: Curve, part: float) -> None:
    on = curve.points([part * curve.length])[0]
    _, _, distance = curve.nearest(on)
    assert distance <= 1e-6
    low, high = (np.array(corner) for corner in curve.bounds)
    assert (on >= low - 1e-6).all() and (on <= high + 1e-6).all()


@given(curves(), st.sampled_from([1.0, 0.1, 0.01]))
def test_chords_stay_within_their_tolerance(curve: Curve, tolerance: float) -> None:
    corners = curve.chords(tolerance)
    assert tuple(corners[0]) == curve.start and tuple(corners[-1]) == curve.end
    middles = (corners[1:] + corners[:-1]) / 2
    for middle in middles[:: max(1, len(middles) // 10)]:
        assert curve.nearest(middle)[2] <= tolerance * (1 + 1e-6) + 1e-9


@given(point, st.tuples(coordinate, coordinate), st.booleans(), st.floats(0.1, 6.0))
def test_an_arc_about_a_centre_comes_back_from_its_ends(
    start: tuple[float, float, float], center: tuple[float, float], clockwise: bool, turn: float
) -> None:
    r = math.dist(start[:2], center)
    assume(r > 1e-2)
    angle = math.atan2(start[1] - center[1], start[0] - center[0]) + (-turn if clockwise else turn)
    end = (center[0] + r * math.cos(angle), center[1] + r * math.sin(angle), start[2])
    arc = geometry.arc(start, end, center=center, clockwise=clockwise, tolerance=1e-6)
    assert arc.kind == "arc"
    assert abs(arc.sweep) == pytest.approx(turn, abs=1e-6 * (1 + 1e4 / r))
    s = np.linspace(0.0, arc.length, 5)[1:-1]
    away = np.hypot(*(arc.points(s)[:, :2] - center).T)
    assert away == pytest.approx(r, abs=1e-7)


def test_curves_by_hand() -> None:
    quarter = geometry.arc((10, 0, 0), (0, 10, 0), radius=10)
    assert quarter.length == pytest.approx(5 * math.pi)
    assert quarter.center == pytest.approx((0, 0, 0), abs=1e-12) and quarter.radii == (10.0, 10.0)
    large = geometry.arc((10, 0, 0), (0, 10, 0), radius=-10)
    assert large.length == pytest.approx(15 * math.pi)
    through = geometry.arc_through((10, 0, 0), (0, 10, 0), (-10, 0, 0))
    assert through.sweep == pytest.approx(math.pi) and through.max_curvature == pytest.approx(0.1)
    turns = geometry.arc((1, 0, 0), (1, 0, 3), center=(0, 0), extra_turns=2)
    assert turns.sweep == pytest.approx(6 * math.pi)
    assert turns.tangents([0.0])[0] == pytest.approx(np.array([0, 1, 1 / (2 * math.pi)]) /
                                                     math.hypot(1, 1 / (2 * math.pi)))
    assert quarter.curvatures([0.0])[0] == pytest.approx([-0.1, 0, 0])
    cone = geometry.spiral((0, 0, 0), 5, 10, 2 * math.pi, rise=4)
    assert cone.kind == "spiral" and cone.end == pytest.approx((10, 0, 4))
    assert geometry.line((0, 0, 0), (3, 4, 0)).center is None


def test_curves_that_cannot_be() -> None:
    with pytest.raises(chordal.UsageError, match="three coordinates"):
        geometry.line((0, 0), (1, 1, 1))
    with pytest.raises(ValueError, match="finite"):
        geometry.line((0, 0, float("nan")), (1, 1, 1))
    with pytest.raises(chordal.UsageError, match="centre or a radius"):
        geometry.arc((0, 0, 0), (1, 1, 1))
    with pytest.raises(ValueError, match="short by"):
        geometry.arc((0, 0, 0), (10, 0, 0), radius=1)
    with pytest.raises(ValueError, match="on a line"):
        geometry.arc_through((0, 0, 0), (1, 0, 0), (2, 0, 0))
    with pytest.raises(ValueError, match="parallel"):
        geometry.spiral((0, 0, 0), 1, 2, 1, towards=(0, 0, 1))
    with pytest.raises(ValueError, match="below zero"):
        geometry.spiral((0, 0, 0), -1, 2, 1)
    with pytest.raises(ValueError, match="tolerance"):
        geometry.helix((0, 0, 0), 1, 1, 0).chords(0.0)
