"""Columns that other libraries read without copying."""

from __future__ import annotations

import html
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _chordal

_SHOWN = 8


class Table:
    """Rows and columns. It never changes.

    ``pyarrow.table(t)`` and ``polars.DataFrame(t)`` read it through ``__arrow_c_stream__`` without copying
    numbers, and DuckDB queries what pyarrow has read; ``pandas.DataFrame.from_arrow(t)`` copies.
    ``t["x_to_mm"]`` is a NumPy array on the same memory. Arrays are read-only and keep the memory alive.
    """

    __slots__ = ("_table",)

    def __init__(self, table: _chordal.Table) -> None:
        self._table = table

    def __len__(self) -> int:
        return len(self._table)

    @property
    def column_names(self) -> tuple[str, ...]:
        """The names of the columns, in order."""
        return tuple(self._table.column_names)

    @property
    def units(self) -> dict[str, str]:
        """The unit of each column that has one."""
        return {name: unit for name, _, unit in self._table.fields if unit is not None}

    @property
    def metadata(self) -> dict[str, str]:
        """The metadata of the table: schema and its version, program, SHA-256, machine."""
        return dict(self._table.metadata)

    @property
    def nbytes(self) -> int:
        """Size of the columns in bytes."""
        return self._table.nbytes

    @property
    def axes(self) -> str:
        """The axes of the rows, such as ``XYZA``."""
        return "".join(axis for axis in "XYZABC" if self._place_of(axis) is not None)

    def __getitem__(self, name: str) -> npt.NDArray[Any]:
        """A column. Numbers share the memory of the table, with NaN for gaps; words, texts, flags and integers with
        gaps are an array of objects, with ``None`` for gaps."""
        block = self._table.column(name)
        if block is not None:
            return np.asarray(block)
        values = self._table.objects(name)
        array = np.empty(len(values), dtype=object)
        array[:] = values
        return array

    def array(self, *names: str) -> npt.NDArray[np.float64]:
        """Columns of numbers as one array (rows, columns). Columns at equal distances in memory, such as the axes,
        are not copied."""
        block = self._table.block(list(names))
        if block is not None:
            return np.asarray(block)
        columns = [np.asarray(self[name], dtype=np.float64) for name in names]
        return np.column_stack(columns) if columns else np.empty((len(self), 0))

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        """The columns as a stream of the Arrow C data interface."""
        return self._table.__arrow_c_stream__(requested_schema)

    def __arrow_c_schema__(self) -> object:
        """The schema by the Arrow C data interface."""
        return self._table.__arrow_c_schema__()

    def __repr__(self) -> str:
        name = type(self).__name__
        return f"<{name} of {len(self)} rows: {', '.join(self.column_names)}>"

    def _repr_html_(self) -> str:
        rows = min(len(self), _SHOWN)
        columns = {name: self[name][:rows] for name in self.column_names}
        head = "".join(f"<th>{html.escape(name)}</th>" for name in columns)
        body = "".join(
            "<tr>" + "".join(f"<td>{_cell(column[row])}</td>" for column in columns.values())
            + "</tr>"
            for row in range(rows)
        )
        more = f"<p>{len(self)} rows, {len(columns)} columns</p>"
        return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>{more}"

    def _place_of(self, axis: str, end: str = "") -> str | None:
        unit = "deg" if axis in "ABC" else "mm"
        names = (f"{axis.lower()}_{end or 'to'}_{unit}", f"{axis.lower()}_{unit}")
        return next((name for name in names if name in self.column_names), None)

    def _places(self, end: str) -> npt.NDArray[np.float64]:
        names = [self._place_of(axis, end) for axis in "XYZABC"]
        return self.array(*(name for name in names if name is not None))


class Moves(Table):
    """Commands or path segments, with their start and end positions."""

    __slots__ = ()

    @property
    def start(self) -> npt.NDArray[np.float64]:
        """The start of each move (rows, axes), mm and degrees; NaN if a row is not a move."""
        return self._places("from")

    @property
    def end(self) -> npt.NDArray[np.float64]:
        """The end of each move (rows, axes), mm and degrees; NaN if a row is not a move."""
        return self._places("to")


class Chords(Moves):
    """The path as chords within a tolerance; ``start`` and ``end`` are (rows, 3), mm."""

    __slots__ = ()


class Trajectory(Table):
    """Setpoints of the axes at a fixed period. Positions are continuous even where offsets change."""

    __slots__ = ("period", "moves", "cuts_without_feed", "refused", "assumed")

    #: Time from one setpoint to the next, s.
    period: float
    #: Moves that were planned.
    moves: int
    #: Cuts that were left out, because they have no feed.
    cuts_without_feed: int
    #: The first moves that could not be planned: line and reason.
    refused: tuple[tuple[int, str], ...]
    #: Limits that the machine file does not give, for which typical ones were used.
    assumed: tuple[str, ...]

    def __init__(
        self,
        table: _chordal.Table,
        period: float,
        planned: tuple[int, int, list[tuple[int, str]], list[str]],
    ) -> None:
        super().__init__(table)
        self.period = period
        self.moves, self.cuts_without_feed = planned[0], planned[1]
        self.refused, self.assumed = tuple(planned[2]), tuple(planned[3])

    @property
    def time(self) -> npt.NDArray[np.float64]:
        """Time of each setpoint from the start (rows,), s."""
        return self["time_s"]

    @property
    def position(self) -> npt.NDArray[np.float64]:
        """Positions (rows, axes), mm and degrees."""
        return self._order("")

    @property
    def velocity(self) -> npt.NDArray[np.float64]:
        """Velocities (rows, axes), mm/s and deg/s."""
        return self._order("_vel", "_per_s")

    @property
    def acceleration(self) -> npt.NDArray[np.float64]:
        """Accelerations (rows, axes), mm/s² and deg/s²."""
        return self._order("_acc", "_per_s2")

    @property
    def speed(self) -> npt.NDArray[np.float64]:
        """Speed of the tool along X, Y and Z (rows,), mm/s."""
        return self["speed_mm_per_s"]

    @property
    def line(self) -> npt.NDArray[np.uint32]:
        """Line of the block that runs (rows,)."""
        return self["line"]

    def _order(self, order: str, per: str = "") -> npt.NDArray[np.float64]:
        units = {axis: "deg" if axis in "ABC" else "mm" for axis in self.axes}
        return self.array(*(f"{a.lower()}{order}_{unit}{per}" for a, unit in units.items()))


def _cell(value: object) -> str:
    if value is None or (isinstance(value, float) and value != value):
        return ""
    text = f"{value:.6g}" if isinstance(value, float) else str(value)
    return html.escape(text)
