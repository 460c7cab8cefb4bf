"""The remaining stock, between two bounds."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from . import _chordal
from .errors import UsageError

__all__ = ["Stock", "StockDifference", "StockMesh"]

#: Columns whose heights differ by at most this fraction of the resolution become one face of a mesh.
_MERGE_FRACTION = 0.1


@dataclass(frozen=True, slots=True)
class StockMesh:
    """A closed triangle mesh."""

    #: Its vertices (n, 3), mm.
    vertices: npt.NDArray[np.float64]
    #: The vertex indices of each triangle (m, 3), counter-clockwise as seen from outside.
    faces: npt.NDArray[np.uint32]


@dataclass(frozen=True, slots=True)
class StockDifference:
    """The differences between two stocks: see :meth:`Stock.compare`. Its truth value is whether they certainly differ.

    Heights are those of columns, (rows along Y, columns along X), mm; the true values are between the bounds."""

    #: By how much the first stock is certainly higher; negative where it is lower, 0 where the bounds overlap.
    least: npt.NDArray[np.float64]
    #: By how much the first stock may be higher, at most.
    more: npt.NDArray[np.float64]
    #: By how much the first stock may be lower, at most.
    less: npt.NDArray[np.float64]
    #: The side of a square column, mm.
    resolution_mm: float

    def __bool__(self) -> bool:
        return bool(np.any(self.least != 0.0))

    @property
    def more_mm3(self) -> tuple[float, float]:
        """The bounds of the volume that only the first stock has, mm³."""
        return self._volume(np.maximum(self.least, 0.0)), self._volume(self.more)

    @property
    def less_mm3(self) -> tuple[float, float]:
        """The bounds of the volume that only the second stock has, mm³."""
        return self._volume(np.maximum(-self.least, 0.0)), self._volume(self.less)

    def _volume(self, heights: npt.NDArray[np.float64]) -> float:
        return float(heights.sum()) * self.resolution_mm**2

    def __repr__(self) -> str:
        more, less = self.more_mm3, self.less_mm3
        return f"<StockDifference more {more[0]:.6g} to {more[1]:.6g} mm³, less {less[0]:.6g} to {less[1]:.6g} mm³>"


class Stock:
    """What a program leaves of its stock: see :meth:`Program.stock`. Coordinates are those of the first cut's work
    offset, mm. Its truth value is whether it is proved that there are no collisions."""

    def __init__(self, stock: _chordal.Stock) -> None:
        self._stock = stock

    @property
    def _json(self) -> str:
        return self._stock.json

    @cached_property
    def report(self) -> dict[str, Any]:
        """The whole report: the object of ``chordal stock --format json``."""
        answer: dict[str, Any] = json.loads(self._json)
        return answer

    @property
    def verdict(self) -> Literal["clean", "problems", "not-proved"]:
        """``"clean"``: proved to have no collision; ``"problems"``: it has a collision, or the program has errors;
        ``"not-proved"``: no collision was found, but some cannot be excluded."""
        verdict: Literal["clean", "problems", "not-proved"] = self.report["verdict"]
        return verdict

    def __bool__(self) -> bool:
        return self.verdict == "clean"

    @property
    def problems(self) -> list[dict[str, Any]]:
        """The collisions, certain or possible: code, line, tool, bounds of the depth, and position."""
        problems: list[dict[str, Any]] = self.report["problems"]
        return problems

    @property
    def removed_mm3(self) -> tuple[float, float]:
        """The bounds of the removed volume, mm³."""
        return _bounds(self.report["removed_mm3"])

    @property
    def left_mm3(self) -> tuple[float, float]:
        """The bounds of the remaining volume, mm³."""
        return _bounds(self.report["left_mm3"])

    @property
    def target(self) -> dict[str, Any] | None:
        """The excess over the target: bounds of its volume and height, and the position of the highest; ``None`` if
        the setup has no target."""
        target: dict[str, Any] | None = self.report["target"]
        return target

    @property
    def resolution_mm(self) -> float:
        """The side of a square column, mm."""
        resolution: float = self.report["resolution_mm"]
        return resolution

    @property
    def origin(self) -> tuple[float, float, float]:
        """The lowest corner of the stock, mm, where the first column begins."""
        return self._stock.bounds[0]

    @cached_property
    def _heights(self) -> npt.NDArray[np.float64]:
        columns, rows = self._stock.shape
        return np.asarray(self._stock.heights()).reshape(rows, columns, 2)

    @property
    def least(self) -> npt.NDArray[np.float64]:
        """Lower bound of the top of each column, mm: (rows along Y, columns along X). Undercuts are not represented."""
        return self._heights[..., 0]

    @property
    def most(self) -> npt.NDArray[np.float64]:
        """Upper bound of the top of each column, mm."""
        return self._heights[..., 1]

    def compare(self, other: Stock) -> StockDifference:
        """Compare this stock with another one that has the same columns, such as two programs on one setup. A
        difference is certain where the bounds of the heights do not overlap; gaps by undercuts are not compared."""
        if (self._stock.shape, self._stock.bounds[0], self.resolution_mm) != (
            other._stock.shape,
            other._stock.bounds[0],
            other.resolution_mm,
        ):
            message = (
                f"the two stocks have other columns: {self._stock.shape} of {self.resolution_mm:g} mm and "
                f"{other._stock.shape} of {other.resolution_mm:g} mm"
            )
            raise UsageError(message, help="run both on the same stock with the same resolution_mm")
        more, less = self.least - other.most, other.least - self.most
        return StockDifference(
            np.maximum(more, 0.0) - np.maximum(less, 0.0),
            np.maximum(self.most - other.least, 0.0),
            np.maximum(other.most - self.least, 0.0),
            self.resolution_mm,
        )

    def mesh(self, tolerance: float | None = None) -> StockMesh:
        """The remaining stock as a closed surface, with the height at the centre of each column. Columns whose
        heights differ by at most ``tolerance`` mm become one face; without it, a tenth of the resolution."""
        vertices, faces = self._stock.mesh(self._tolerance(tolerance))
        return StockMesh(np.asarray(vertices), np.asarray(faces))

    def save(
        self, path: str | os.PathLike[str], tolerance: float | None = None, *, smooth: float | None = None
    ) -> None:
        """Write the remaining stock in the format of the file extension: ``.stl``, ``.3mf``, ``.glb`` or a picture
        ``.png``. With ``smooth``, a mesh has no steps; at the centre of each column it is within this distance of its
        height, mm, and a part with undersides (material above a gap) is then refused."""
        smooth = None if smooth is None else float(smooth)
        path = Path(path)
        extension = path.suffix.removeprefix(".").lower()
        path.write_bytes(self._stock.file(extension, self._tolerance(tolerance), smooth, path.stem))

    def png(self) -> bytes:
        """A picture of the remaining stock, seen from above."""
        return bytes(self._stock.file("png", 0.0, None, ""))

    def _tolerance(self, tolerance: float | None) -> float:
        return _MERGE_FRACTION * self.resolution_mm if tolerance is None else float(tolerance)

    def _repr_png_(self) -> bytes:
        return self.png()

    def __repr__(self) -> str:
        least, most = self.removed_mm3
        return f"<Stock {self.verdict}, removed {least:.6g} to {most:.6g} mm³>"


def _bounds(amount: dict[str, float]) -> tuple[float, float]:
    return amount["least"], amount["most"]
