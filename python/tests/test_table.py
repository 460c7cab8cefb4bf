"""Tables: the same rows for every library, and where the numbers lie."""

from __future__ import annotations

import duckdb
import numpy as np
import numpy.typing as npt
import pandas
import polars
import pyarrow
import pytest

import chordal
from conftest import PART


@pytest.fixture
def program() -> chordal.Program:
    return chordal.loads(PART, "haas-vf2", name="part.nc")


def address(array: npt.NDArray[np.float64]) -> int:
    return int(array.__array_interface__["data"][0])


def test_commands_by_hand(program: chordal.Program) -> None:
    commands = program.commands()
    kinds = list(commands["kind"])
    assert kinds.count("arc") == 2 and kinds[-1] == "end"
    arc = kinds.index("arc")
    assert commands["line"][arc] == 8
    assert commands.start[arc, :3].tolist() == [40.0, 0.0, -1.0]
    assert commands.end[arc, :3].tolist() == [50.0, 10.0, -1.0]
    assert commands["plane"][arc] == "xy" and commands["direction"][arc] == "ccw"
    assert commands["sweep_deg"][arc] == pytest.approx(90.0)
    assert commands["feed_mm_per_min"][arc] == pytest.approx(600.0)
    assert np.isnan(commands.end[kinds.index("tool")]).all()
    assert commands.axes == "XYZA"
    assert commands.units["sweep_deg"] == "deg"
    assert commands.metadata["chordal.schema"] == "chordal.command-columns/1"
    assert commands.metadata["chordal.program_sha256"] == program.sha256


def test_path_and_chords_by_hand(program: chordal.Program) -> None:
    path = program.path()
    arcs = path["kind"] == "arc"
    assert arcs.sum() == 2
    assert path["radius_from_mm"][arcs].tolist() == [10.0, 10.0]
    assert path.array("x_axis", "y_axis", "z_axis")[arcs].tolist() == [[0, 0, 1], [0, 0, 1]]
    assert path["length_mm"][arcs] == pytest.approx([5 * np.pi] * 2)
    chords = program.chords(0.01)
    # Where the first move comes from is not known, and NaN.
    np.testing.assert_array_equal(chords.start[1:], chords.end[:-1])
    assert np.isnan(chords.start[0]).all()
    on_arc = chords["line"] == 8
    radius = np.hypot(chords.end[on_arc, 0] - 40.0, chords.end[on_arc, 1] - 10.0)
    assert radius == pytest.approx(10.0, abs=1e-12)
    assert len(program.chords(0.01, "balanced")) < len(chords)
    for tolerance in (0.0, -1.0, float("nan"), float("inf")):
        with pytest.raises(chordal.UsageError, match="tolerance"):
            program.chords(tolerance)
    with pytest.raises(chordal.UsageError, match="placement"):
        program.chords(0.1, "outside")  # type: ignore[arg-type]


def test_setpoints_agree_with_the_time(program: chordal.Program) -> None:
    period = 0.001
    run = program.trajectory(period)
    # The machine has an A axis, which this program does not move.
    assert run.position.shape == (len(run), 3) == run.velocity.shape == run.acceleration.shape
    assert run.time == pytest.approx(np.arange(len(run)) * period)
    assert abs(run.time[-1] - program.time().total_s) <= period
    assert run.position[-1].tolist() == [0.0, 0.0, 50.0]
    assert (run.velocity[-1] == 0).all()
    # Where the first move comes from is not known; it begins at rest.
    assert np.isnan(run.position[0]).all() and run.speed[0] == 0.0
    assert (np.nanmax(np.abs(run.velocity[:, :2]), axis=0) <= 25.4e3 / 60 + 1e-9).all()
    assert np.nanmax(np.abs(run.acceleration[:, :3])) <= 3000.0 * (1 + 1e-9)
    norm = np.linalg.norm(run.velocity[:, :3], axis=1)
    assert run.speed == pytest.approx(norm, nan_ok=True)
    assert run.moves == (program.path()["length_mm"] > 0).sum() and not run.refused
    for wrong in (0.0, -1.0, float("nan"), float("inf")):
        with pytest.raises(chordal.UsageError, match="period"):
            program.trajectory(wrong)
    with pytest.raises(chordal.UsageError, match="more than 10 setpoints"):
        program.trajectory(period, max_samples=10)


def test_every_library_reads_the_same_rows(program: chordal.Program) -> None:
    commands = program.commands()
    arrow = pyarrow.table(commands)
    rows = arrow.to_pylist()
    assert len(rows) == len(commands)
    assert polars.DataFrame(commands).to_dicts() == rows
    frame = pandas.DataFrame.from_arrow(commands)
    assert list(frame["line"]) == arrow["line"].to_pylist()
    arcs = duckdb.sql("select count(*) from arrow where kind = 'arc'")
    assert arcs is not None and arcs.fetchall() == [(2,)]
    for name in commands.column_names:
        ours = [None if isinstance(v, float) and np.isnan(v) else v for v in commands[name]]
        assert ours == arrow[name].to_pylist(), name


def test_numbers_lie_in_one_place(program: chordal.Program) -> None:
    run = program.trajectory(0.001)
    arrow = pyarrow.table(run)
    x = run["x_mm"]
    assert arrow["x_mm"].chunk(0).buffers()[1].address == address(x)
    assert address(run.position) == address(x) and np.shares_memory(run.position, x)
    assert address(polars.DataFrame(run)["x_mm"].to_numpy()) == address(x)
    assert not x.flags.writeable and not run.position.flags.owndata
    with pytest.raises(ValueError, match="read-only"):
        x[0] = 1.0


def test_arrays_outlive_their_table(program: chordal.Program) -> None:
    position = program.trajectory(0.001).position
    copy = position.copy()
    # Memory that was let go would be used again here.
    for _ in range(3):
        program.trajectory(0.001)
    np.testing.assert_array_equal(position, copy)


def test_tables_of_no_rows() -> None:
    program = chordal.loads("(NOTHING)\n", "haas-vf2")
    for table in (program.commands(), program.path(), program.chords(0.1)):
        assert len(pyarrow.table(table)) == len(table)
        assert table.array("length_mm").shape == (len(table), 1)
    assert program.path().end.shape == (0, 4)


def test_columns_that_are_not_there(program: chordal.Program) -> None:
    with pytest.raises(KeyError, match="x_mmm"):
        program.path()["x_mmm"]
    assert program.path().array().shape == (len(program.path()), 0)
    backwards = program.path().array("z_to_mm", "x_to_mm")
    assert backwards[:, 1].tolist() == program.path()["x_to_mm"].tolist()
