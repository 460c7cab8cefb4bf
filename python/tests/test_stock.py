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

SLOT = "G21 G90 G54\nT1 M6\nS3000 M3\nG0 X20. Y30.\nG43 H1 Z5.\nG1 Z-5. F200.\nX60. F600.\nG0 Z5.\nM30\n"


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
    for ending in ("stl", "glb"):
        left.save(tmp_path / f"smooth.{ending}", smooth=0.02)
        steps, smooth = (tmp_path / f"{name}.{ending}" for name in ("left", "smooth"))
        assert smooth.stat().st_size > 500 and smooth.read_bytes() != steps.read_bytes()
    with pytest.raises(chordal.UsageError, match="length"):
        left.save(tmp_path / "smooth.stl", smooth=-1)
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


LATHE = {
    "machine": "fanuc-lathe",
    "stock": {"shape": "cylinder", "diameter": "50 mm", "from": "-60 mm", "to": "0 mm", "material": "steel"},
    "tools": {
        5: {
            "shape": "groove",
            "width": "4 mm",
            "flute_length": "30 mm",
            "tip": 3,
            "offset": {"X": "0 mm", "Z": "0 mm"},
        }
    },
}

#: A groove of 6 mm to diameter 40 in two plunges, then the part comes off.
GROOVE = (
    "G21 G18 G40 G97 G99 S800 M3\nG28 U0 W0\nT0505\nG0 X54. Z-20.\nG1 X40. F0.1\nG0 X54.\nZ-18.\nG1 X40.\n"
    "G0 X54.\nZ-40.\nG1 X0 F0.05\nG0 X60.\nM30\n"
)


def test_the_stock_of_a_lathe_is_exact(tmp_path: Path) -> None:
    left = chordal.loads(GROOVE, LATHE).stock()
    assert isinstance(left, chordal.TurnedStock)
    assert left and left.verdict == "clean" and left.problems == []
    removed = math.pi * (6 * (25**2 - 20**2) + 4 * 25**2)
    assert left.removed_mm3 == pytest.approx((removed, removed), rel=1e-12)
    assert left.volume_mm3 == pytest.approx(math.pi * 60 * 25**2 - removed, rel=1e-12)
    np.testing.assert_allclose(left.radii(-17.0), [[0, 20]], atol=1e-12)
    assert left.radii(-38.0).shape == (0, 2)
    assert left.report["parts"][0]["line"] == 11
    assert "TurnedStock clean" in repr(left)
    left.save(tmp_path / "part.dxf")
    left.save(tmp_path / "part.stl")
    # The ground that two plunges made is one line of the drawing.
    assert (tmp_path / "part.dxf").read_bytes().count(b"\nLINE\n") == len(left.outline) - 1
    assert left.png().startswith(b"\x89PNG")


def test_the_outline_of_a_lathe_is_columns() -> None:
    left = chordal.loads(GROOVE, LATHE).stock()
    assert isinstance(left, chordal.TurnedStock)
    outline = left.outline
    assert outline.metadata["chordal.schema"] == "chordal.section-columns/1"
    assert outline.units["r_from_mm"] == "mm" and outline.units["sweep_deg"] == "deg"
    assert set(outline["kind"]) == {"line"} and set(outline["part"]) == {0, 1}
    # The area within straight lines, with the material to their left.
    z0, r0, z1, r1 = outline.array("z_from_mm", "r_from_mm", "z_to_mm", "r_to_mm").T
    for part, area in [(0, 20 * 25), (1, 36 * 25 - 6 * 5)]:
        own = outline["part"] == part
        assert ((z0 * r1 - z1 * r0) / 2)[own].sum() == pytest.approx(area, rel=1e-12)
    ground = (r0 == 20) & (r1 == 20)
    assert ground.sum() == 2 and set(outline["tool"][ground]) == {5}
    assert set(outline["line"][ground]) == {5, 8}
    assert set(outline["tool"][outline["is_axis"].astype(bool)]) == {0}


def test_the_passes_of_a_lathe_are_columns() -> None:
    left = chordal.loads(GROOVE, LATHE).stock()
    assert isinstance(left, chordal.TurnedStock)
    passes = left.passes
    assert list(passes["line"]) == [5, 8, 11]
    np.testing.assert_allclose(passes["area_mm2"], [20, 10, 100], rtol=1e-12)
    np.testing.assert_allclose(passes["engaged_mm"], [5, 5, 25], rtol=1e-12)
    assert (passes["power_kw"] > 0).all()
    assert passes.units["power_kw"] == "kW"


def test_a_lathe_has_no_columns_of_heights() -> None:
    left = chordal.loads(GROOVE, LATHE).stock()
    for ask in ("least", "most", "origin"):
        with pytest.raises(chordal.UsageError, match="outline"):
            getattr(left, ask)
    with pytest.raises(chordal.UsageError, match="outline"):
        left.compare(left)
    with pytest.raises(chordal.UsageError, match="dxf"):
        left.save("part.step")


def test_a_rapid_of_a_lathe_in_the_stock_is_told() -> None:
    hit = chordal.loads(GROOVE.replace("G1 X40. F0.1", "G0 X40."), LATHE).stock()
    assert not hit and hit.verdict == "problems"
    problem = hit.problems[0]
    assert (problem["code"], problem["line"]) == ("CH620", 5)
    assert problem["depth_mm"]["most"] == pytest.approx(4.0)


def test_two_stocks_are_compared() -> None:
    program = chordal.loads(SLOT, SETUP)
    left = program.stock(resolution_mm=0.5)
    same = left.compare(program.stock(resolution_mm=0.5))
    assert not same and same.more_mm3[0] == same.less_mm3[0] == 0.0
    # A millimetre less deep: that is left of the slot.
    shallow = chordal.loads(SLOT.replace("Z-5.", "Z-4."), SETUP).stock(resolution_mm=0.5)
    difference = shallow.compare(left)
    slot = 400 + 25 * math.pi
    least, most = difference.more_mm3
    assert difference and least <= slot <= most
    # A wall is known to a column.
    assert least > slot - (80 + 10 * math.pi) * 0.5 - 1
    assert difference.less_mm3[0] == 0.0
    assert difference.least.shape == left.least.shape
    assert left.compare(shallow).less_mm3 == pytest.approx(difference.more_mm3)
    with pytest.raises(chordal.UsageError, match="other columns"):
        left.compare(program.stock(resolution_mm=1.0))
