"""The planner alone: limits hold, places are right, odd input is an answer."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import chordal
from chordal import geometry
from chordal.motion import AxisLimit, Dwell, Move, Path, plan

LIMIT = AxisLimit(velocity=400.0, acceleration=3000.0, jerk=100_000.0)
LIMITS = {"X": LIMIT, "Y": LIMIT, "Z": LIMIT}


def test_a_line_by_hand() -> None:
    # Jerk up, jerk down: half the way each, 2 s = 4 (s/2j)^(1/3) of the four jerk phases.
    way = 0.2
    motion = plan(Path((0, 0, 0)).rapid_to((way, 0, 0)), LIMITS)
    assert motion.duration == pytest.approx(4 * (way / (2 * LIMIT.jerk)) ** (1 / 3), rel=1e-6)
    far = plan(Path((0, 0, 0)).line_to((1000, 0, 0), speed=100), LIMITS)
    ramp = 100 / LIMIT.acceleration + LIMIT.acceleration / LIMIT.jerk
    assert far.duration == pytest.approx(1000 / 100 + ramp, rel=1e-9)


def test_a_path_with_everything() -> None:
    path = (
        Path((0, 0, 0))
        .rapid_to((10, 0, 5))
        .line_to((50, 0, 0), speed=100, tolerance=0.02)
        .arc_to((60, 10, 0), center=(50, 10), speed=100, tolerance=0)
        .dwell(0.25)
        .then(geometry.helix((60, 10, 0), 5, 4 * math.pi, 8, towards=(-1, 0, 0)).reversed())
    )
    with pytest.raises(chordal.UsageError, match="move 4 cannot be planned: .*away from the end"):
        plan(path, LIMITS)
    path = Path(path.start, path.moves[:-1])
    assert len(path) == 4 and path.end == (60.0, 10.0, 0.0)
    motion = plan(path, LIMITS)
    run = motion.sample(0.001)
    assert run.position[0].tolist() == [0.0] * 6
    assert run.position[-1, :3].tolist() == [60.0, 10.0, 0.0]
    assert run.time[-1] == pytest.approx(motion.duration, abs=0.001)
    assert set(run["move"]) == {0, 1, 2, 3}
    assert abs((run["move"] == 3).sum() - 250) <= 1
    assert motion.duration == plan(list(path), LIMITS).duration


turn = st.floats(-20.0, 20.0)


@settings(max_examples=40, deadline=None)
@given(
    st.lists(st.tuples(turn, turn, turn), min_size=1, max_size=12),
    st.floats(1.0, 500.0),
    st.sampled_from([None, 0.0, 0.01, 0.5]),
)
def test_random_paths_hold_every_limit(
    steps: list[tuple[float, float, float]], speed: float, tolerance: float | None
) -> None:
    path, at = Path((0, 0, 0)), np.zeros(3)
    for step in steps:
        if np.abs(step).max() < 1e-3:
            continue
        at = at + np.array(step)
        path = path.line_to(at, speed=speed, tolerance=tolerance)
    run = plan(path, LIMITS).sample(0.002)
    held = 1 + 1e-6
    assert (np.abs(run.velocity) <= LIMIT.velocity * held).all()
    assert (np.linalg.norm(run.velocity, axis=1) <= speed * held).all()
    assert (np.abs(run.acceleration) <= LIMIT.acceleration * held).all()
    assert (np.abs(run.jerk) <= LIMIT.jerk * held).all()
    assert run.position[-1, :3] == pytest.approx(np.asarray(path.end), abs=1e-9)


def test_rotary_axes_turn_along() -> None:
    move = Move(geometry.line((0, 0, 0), (0, 0, 0)), speed=1.0, rotary_to=(math.pi, 0.0, 0.0))
    limits = {**LIMITS, "A": AxisLimit(2.0, 10.0, 200.0)}
    run = plan([move, Dwell(0.1)], limits).sample(0.01)
    assert run.position[-1, 3] == pytest.approx(math.pi)
    assert np.abs(run.velocity[:, 3]).max() <= 1.0 + 1e-9


def test_what_cannot_be_planned() -> None:
    path = Path((0, 0, 0)).line_to((1, 0, 0), speed=10)
    with pytest.raises(chordal.UsageError, match="no axis 'U'"):
        plan(path, {"U": LIMIT})
    with pytest.raises(chordal.UsageError, match="axis X moves"):
        plan(path, {"Y": LIMIT})
    with pytest.raises(chordal.UsageError, match="jerk limit of axis X is 0"):
        plan(path, {"X": AxisLimit(1, 1, 0)})
    for speed in (0.0, -1.0, float("nan")):
        with pytest.raises(chordal.UsageError, match="speed of the move"):
            plan(Path((0, 0, 0)).line_to((1, 0, 0), speed=speed), LIMITS)
    with pytest.raises(chordal.UsageError, match="move 0"):
        plan([Dwell(-1.0)], LIMITS)
    with pytest.raises(chordal.UsageError, match="setpoints"):
        plan(path, LIMITS).sample(1e-6, max_samples=100)
    assert plan([], LIMITS).duration == 0.0
