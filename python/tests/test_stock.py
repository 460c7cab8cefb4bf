"""Stock: bounds, heights, meshes, a target."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import chordal

SETUP = {
    "machine": "haas-vf2",
    "stock": {
        "shape": "box",
        "from": {"X": "0 mm", "Y": "0 mm", "Z": "-20 mm"},
        "to": {"X": "80 mm", "Y": "60 mm", "Z": "0 mm"},
    },
    "tools": {1: {"shape": "flat", "diameter": "10 mm", "flute_length": "25 mm"}},
}

SLOT = "G21 G90 G54\nT1 M6\nS3000 M3\nG0 X20. Y30.\nG0 Z5.\nG1 Z-5. F200.\nX60. F600.\nG0 Z5.\nM30\n"


def test_a_slot_is_between_its_bounds() -> None:
    left = chordal.loads(SLOT, "haas-vf2").stock(SETUP)
    assert left and left.verdict == "clean" and left.problems == []
    least, most = left.removed_mm3
    truth = (400 + 25 * math.pi) * 5
    assert least <= truth <= most and most - least < 0.2 * truth
    assert sum(left.left_mm3) / 2 == pytest.approx(80 * 60 * 20 - truth, rel=0.01)
    assert left.report["tools"][0]["time_s"] > 4
    assert left.target is None
    assert "clean" in repr(left)


def test_heights_are_arrays() -> None:
    left = chordal.loads(SLOT, SETUP).stock(resolution_mm=0.5)
    assert left.resolution_mm == 0.5 and left.origin == (0.0, 0.0, -20.0)
    assert left.least.shape == left.most.shape == (120, 160)
    assert (left.least <= left.most).all()
    assert left.most[60, 80] == pytest.approx(-5, abs=1e-4)
    assert left.least[5, 5] == 0.0
    removed = (0.0 - left.most).sum() * 0.25, (0.0 - left.least).sum() * 0.25
    assert removed == pytest.approx(left.removed_mm3, rel=1e-6)


def test_a_rapid_in_the_stock_is_told() -> None:
    plunge = SLOT.replace("G1 Z-5. F200.\nX60.", "G0 Z-5.\nG1 X60.")
    hit = chordal.loads(plunge, SETUP).stock()
    assert not hit and hit.verdict == "problems"
    (problem,) = [each for each in hit.problems if each["code"] == "CH620"]
    assert problem["line"] == 6 and problem["depth_mm"]["least"] == pytest.approx(5, abs=1e-3)


def test_meshes_are_closed(tmp_path: Path) -> None:
    left = chordal.loads(SLOT, SETUP).stock(resolution_mm=1.0)
    mesh = left.mesh()
    assert mesh.vertices.shape[1] == 3 and mesh.faces.shape[1] == 3
    a, b, c = (mesh.vertices[mesh.faces[:, corner]] for corner in range(3))
    volume = np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6
    least, most = left.left_mm3
    assert least - 1 <= volume <= most + 1
    edges = np.concatenate([mesh.faces[:, pair] for pair in ([0, 1], [1, 2], [2, 0])])
    there = {tuple(edge) for edge in edges.tolist()}
    assert len(there) == len(edges) and all((to, at) in there for at, to in there)
    for ending in ("stl", "3mf", "glb", "png"):
        left.save(tmp_path / f"left.{ending}")
        assert (tmp_path / f"left.{ending}").stat().st_size > 500
    with pytest.raises(chordal.UsageError, match="no format `obj`"):
        left.save(tmp_path / "left.obj")


def test_a_target_is_compared(tmp_path: Path) -> None:
    chordal.loads(SLOT, SETUP).stock(resolution_mm=1.0).save(tmp_path / "part.stl")
    target = {"shape": "stl", "file": str(tmp_path / "part.stl"), "unit": "mm", "tolerance": "1.2 mm"}
    half = SLOT.replace("X60.", "X40.")
    left = chordal.loads(half, SETUP | {"target": target}).stock(resolution_mm=1.0)
    assert left.target is not None
    over = left.target["left_over_mm3"]
    assert over["least"] <= 20 * 10 * 5 <= over["most"]
    assert left.target["highest_mm"]["most"] == pytest.approx(5, abs=0.01)


def test_what_cannot_be_is_said() -> None:
    program = chordal.loads(SLOT, "haas-vf2")
    with pytest.raises(chordal.UsageError, match="there is no stock"):
        program.stock()
    with pytest.raises(chordal.UsageError, match="bytes"):
        program.stock(SETUP, resolution_mm=0.01, memory=1 << 20)
