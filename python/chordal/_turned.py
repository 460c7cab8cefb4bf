"""The exact remaining stock of a lathe."""

from __future__ import annotations

import os
from functools import cached_property
from pathlib import Path
from typing import NoReturn

import numpy as np
import numpy.typing as npt

from . import _chordal
from ._stock import Stock, StockDifference, StockMesh
from ._table import Table
from .errors import UsageError

__all__ = ["TurnedStock"]


class TurnedStock(Stock):
    """What a lathe program leaves of its stock: see :meth:`Program.stock`. The half section consists of lines and
    arcs and is exact, so both bounds of a volume are equal, except for threads. Coordinates are those of the first
    cut's work offset, mm: z along the axis, r the distance from it (radius). It is true if there are no collisions
    and every move was simulated."""

    def __init__(self, stock: _chordal.TurnedStock) -> None:
        self._turned = stock

    @property
    def _json(self) -> str:
        return self._turned.json

    @cached_property
    def outline(self) -> Table:
        """The outline of everything that remains, one row for each line or arc: part (0 is in the chuck), loop, ends,
        centre, radius and angle, and the tool and the program line that made it. ``docs/columns.md`` lists the
        columns."""
        return Table(self._turned.outline)

    @cached_property
    def passes(self) -> Table:
        """The cutting data of every move at feed: depth of cut, area, volume, chip, power. ``docs/columns.md`` lists
        the columns."""
        return Table(self._turned.passes)

    @property
    def volume_mm3(self) -> float:
        """The remaining volume, in the chuck and cut off, mm³; threads count as not cut."""
        return self.left_mm3[1]

    def radii(self, z: float) -> npt.NDArray[np.float64]:
        """The radii of the material at a z, mm: one row (from, to) for each ring, from the axis outwards. At a face,
        the side towards +Z counts."""
        return np.asarray(self._turned.radii(float(z)), dtype=np.float64).reshape(-1, 2)

    def save(
        self, path: str | os.PathLike[str], tolerance: float | None = None, *, smooth: float | None = None
    ) -> None:
        """Write the half section (``.dxf``: lines and arcs, X along the axis, Y the radius; ``.svg``, ``.png``) or
        the solid (``.stl``, ``.3mf``, ``.glb``), by the file extension. ``tolerance`` and ``smooth`` have no effect:
        solids have chords within 0.005 mm."""
        path = Path(path)
        ending = path.suffix.removeprefix(".").lower()
        path.write_bytes(self._turned.file(ending, path.stem))

    def png(self) -> bytes:
        """The half section as a drawing."""
        return bytes(self._turned.file("png", ""))

    @property
    def resolution_mm(self) -> float:
        """0, because there are no columns."""
        return 0.0

    @property
    def origin(self) -> tuple[float, float, float]:
        """Raises :class:`~chordal.UsageError`, because a lathe's stock has no columns."""
        return _no_columns("origin")

    @property
    def least(self) -> npt.NDArray[np.float64]:
        """Raises :class:`~chordal.UsageError`, because a lathe's stock has no columns."""
        return _no_columns("least")

    @property
    def most(self) -> npt.NDArray[np.float64]:
        """Raises :class:`~chordal.UsageError`, because a lathe's stock has no columns."""
        return _no_columns("most")

    def compare(self, other: Stock) -> StockDifference:
        """Raises :class:`~chordal.UsageError`, because a lathe's stock has no columns. Its outlines can be
        compared."""
        return _no_columns("compare")

    def mesh(self, tolerance: float | None = None) -> StockMesh:
        """Raises :class:`~chordal.UsageError`, because a lathe's stock has no columns. ``save`` writes the solid."""
        return _no_columns("mesh")

    def __repr__(self) -> str:
        return f"<TurnedStock {self.verdict}, {len(self.outline)} lines and arcs, left {self.volume_mm3:.6g} mm³>"


def _no_columns(what: str) -> NoReturn:
    message = f"the stock of a lathe has no `{what}`: it is no field of heights"
    raise UsageError(message, "use outline, radii() or save()")
