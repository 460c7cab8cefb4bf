"""Programs: load one, then compute its path, time, stock and more."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Literal

from . import _chordal, _comparison, _notebook, _shop, _summary, _time, _toml, _transform, diagnostics
from ._comparison import Comparison, Conversion
from ._machine import Machine, MachineLike, machine_of
from ._shop import ShopCodes
from ._stock import Stock
from ._summary import Summary
from ._table import Chords, Moves, Trajectory
from ._time import Time
from ._transform import Restarted, Split, Transformed
from ._turned import TurnedStock
from .diagnostics import Diagnostic
from .errors import ProgramError, UsageError

if TYPE_CHECKING:
    from ._chordal import _Options
    from ._control import _ControlName

__all__ = ["Program", "load", "loads"]

#: Tools: the path of a LinuxCNC tool table, or a dictionary from tool number to the keys of a machine file.
Tools = str | os.PathLike[str] | Mapping[int, Mapping[str, object]]

#: Settings: a dictionary from name to value, or the path of a file with what a GRBL machine printed for ``$$``.
Settings = str | os.PathLike[str] | Mapping[str, object]

#: The default limit on the number of setpoints.
DEFAULT_MAX_SAMPLES = 100_000_000

#: The default limit on the memory for a stock's columns, bytes.
DEFAULT_STOCK_BYTES = 1 << 30


def load(
    path: str | os.PathLike[str],
    machine: MachineLike | None = None,
    *,
    control: _ControlName | None = None,
    tools: Tools | None = None,
    settings: Settings | None = None,
    program: int | None = None,
    block_delete: bool = False,
    max_blocks: int | None = None,
    shop_codes: ShopCodes | None = None,
    strict: bool = False,
) -> Program:
    """Load a program from a file, with the subprograms in its folder.

    ``machine`` is a :class:`~chordal.Machine`, a built-in name, a machine file or a dictionary. Without it,
    ``control`` selects the default machine of a control. Without both, ``chordal.toml`` in the program's folder
    decides, or else the control is recognized from the text (:attr:`Program.recognized`). ``tools`` and ``settings``
    are added to the machine's own: ``tools={1: {"diameter": "0.75 in"}}``, ``settings={"Setting 58": "yasnac"}``, or
    ``settings="dump.txt"`` with what a GRBL machine printed for ``$$``.

    ``program`` runs only the program of this number, ``block_delete`` skips the blocks that start with ``/``, and
    ``max_blocks`` limits the blocks executed in calls, repeats and jumps before a program counts as endless.

    ``shop_codes`` defines M codes and called programs that neither the control nor the files have: a function that
    takes a :class:`~chordal.ShopCall`, or a dictionary from a code to seconds, to NC blocks, or to such a function.
    The function is called once for each call in the program, while the program is loaded; its exceptions are raised
    here, with the block as a note.

    The problems of the program are in :attr:`~Program.diagnostics`. With ``strict``, a program with errors raises
    :class:`~chordal.ProgramError`. A file that cannot be read raises :class:`OSError`, a wrong machine
    :class:`~chordal.MachineError`, and invalid arguments :class:`~chordal.UsageError`.
    """
    with open(path, "rb"):
        pass  # raises the system's own error for a missing file
    options = _options(
        machine, control, tools, settings, program, block_delete, max_blocks, shop_codes
    )
    return _wrapped(_chordal.load_file(os.fspath(path), options), strict)


def loads(
    text: str | bytes,
    machine: MachineLike | None = None,
    *,
    name: str = "<program>",
    control: _ControlName | None = None,
    tools: Tools | None = None,
    settings: Settings | None = None,
    program: int | None = None,
    block_delete: bool = False,
    max_blocks: int | None = None,
    shop_codes: ShopCodes | None = None,
    strict: bool = False,
) -> Program:
    """Load a program from a text. Messages show ``name``; the other arguments are as in :func:`load`."""
    # A text that was decoded with `surrogateescape` gets its undecodable bytes back.
    data = text.encode("utf-8", "surrogateescape") if isinstance(text, str) else bytes(text)
    options = _options(
        machine, control, tools, settings, program, block_delete, max_blocks, shop_codes
    )
    return _wrapped(_chordal.load_text(data, name, options), strict)


def _options(
    machine: MachineLike | None,
    control: _ControlName | None,
    tools: Tools | None,
    settings: Settings | None,
    program: int | None,
    block_delete: bool,
    max_blocks: int | None,
    shop_codes: ShopCodes | None,
) -> _Options:
    if machine is not None and control is not None:
        raise UsageError(
            "both a machine and a control are given",
            "a machine has its control; give one of the two",
        )
    changes: list[str] = []
    table: str | None = None
    dump: str | None = None
    if isinstance(settings, Mapping):
        changes += _toml.assignments(settings, "settings")
    elif settings is not None:
        dump = os.fspath(settings)
    if isinstance(tools, Mapping):
        changes += _toml.assignments({str(number): tool for number, tool in tools.items()}, "tools")
    elif tools is not None:
        table = os.fspath(tools)
    return {
        "machine": None if machine is None else machine_of(machine)._machine,
        "control": control,
        "set": changes,
        "settings": dump,
        "tools": table,
        "program": program,
        "block_delete": block_delete,
        "max_blocks": max_blocks,
        "shop_codes": None if shop_codes is None else _shop.hook(shop_codes),
    }


def _wrapped(program: _chordal.Program, strict: bool) -> Program:
    loaded = Program(program)
    if strict:
        loaded.raise_errors()
    return loaded


class Program:
    """A program with its machine. It never changes; load it with :func:`load` or :func:`loads`.

    Each method runs the program, without the interpreter lock; problems and the summary are cached. A notebook shows
    the picture, the summary and the problems.
    """

    def __init__(self, program: _chordal.Program) -> None:
        self._program = program

    @property
    def name(self) -> str:
        """The name that messages show."""
        return self._program.name

    @property
    def text(self) -> bytes:
        """The text as the control reads it: without a byte order mark, and in UTF-8 if the file is UTF-16."""
        return self._program.text

    @cached_property
    def sha256(self) -> str:
        """The SHA-256 of the text in hexadecimal."""
        return self._program.sha256

    @cached_property
    def machine(self) -> Machine:
        """The machine on which it runs."""
        return Machine(self._program.machine)

    @property
    def control(self) -> str:
        """The control for which it runs."""
        return self.machine.control

    @property
    def recognized(self) -> str | None:
        """Why this machine was chosen; ``None`` if the caller or a ``chordal.toml`` names it."""
        return self._program.recognized

    @cached_property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """Its problems, sorted by location. Of each code, the first 200 are kept."""
        return diagnostics.of_json(*self._program.problems())

    @property
    def errors(self) -> tuple[Diagnostic, ...]:
        """The problems at which the control would stop or do something other than the text says."""
        return tuple(each for each in self.diagnostics if each.severity == "error")

    def raise_errors(self) -> None:
        """Raise :class:`~chordal.ProgramError` if the program has errors."""
        if self.errors:
            raise ProgramError(self.name, self.diagnostics)

    @cached_property
    def not_verified_from(self) -> tuple[str, int] | None:
        """The file and the line from which on the path is unknown, because the control does something there that
        Chordal does not simulate; ``None`` if the whole run is verified.

        >>> import chordal
        >>> text = "G21 G90 S900 M3\\nG1 X9. F50.\\nG12.1\\nX5.\\nM30\\n"
        >>> chordal.loads(text, control="fanuc", name="part.nc").not_verified_from
        ('part.nc', 3)
        """
        return self._program.not_verified_from()

    @property
    def verified(self) -> bool:
        """Whether the whole run was simulated as the control would execute it. If not, results about the path from
        :attr:`not_verified_from` on are not valid: time, travel and comparisons."""
        return self.not_verified_from is None

    @cached_property
    def summary(self) -> Summary:
        """Travel, tools, counts and the time of the run."""
        return _summary.of_dict(self._program.summary())

    @cached_property
    def output(self) -> tuple[str, ...]:
        """The lines that the program prints (DPRNT), in order."""
        return tuple(self._program.output())

    def commands(self) -> Moves:
        """The commands of the run as programmed: a row for each command."""
        return Moves(self._program.commands(False))

    def tool_path(self) -> Moves:
        """The commands of the run for the tool centre, after cutter compensation."""
        return Moves(self._program.commands(True))

    def path(self) -> Moves:
        """The exact path of the tool, a row for each curve, in the work coordinates of its first cut."""
        return Moves(self._program.path())

    def chords(
        self, tolerance: float, placement: Literal["inscribed", "balanced"] = "inscribed"
    ) -> Chords:
        """The path as straight chords within a tolerance, mm.

        ``inscribed`` chords have their ends on the curve; ``balanced`` ones deviate to both sides of it, so that
        fewer are needed by a factor of √2.
        """
        if placement not in ("inscribed", "balanced"):
            raise UsageError(
                f"there is no placement {placement!r}", "chords are `inscribed` or `balanced`"
            )
        return Chords(self._program.chords(tolerance, placement == "balanced"))

    def time(
        self,
        level: Literal["fast", "best"] = "fast",
        *,
        feed_override: float | None = None,
        rapid_override: float | None = None,
        what_if: bool = False,
        bound: bool = False,
    ) -> Time:
        """The time on its machine, within the limits of velocity, acceleration and jerk of every axis.

        ``level``: ``best`` plans more slowly for a shorter time than ``fast``. Overrides are factors: 0.5 is half.
        ``what_if`` also computes the time with other overrides and path modes, ``bound`` the least possible time,
        which may take a minute.
        """
        answer = self._program.time(level, feed_override, rapid_override, what_if, bound)
        return _time.of_json(answer)

    def trajectory(
        self,
        period: float,
        level: Literal["fast", "best"] = "fast",
        *,
        max_samples: int = DEFAULT_MAX_SAMPLES,
    ) -> Trajectory:
        """The setpoints of the axes every ``period`` seconds. More than ``max_samples`` of them raise
        :class:`~chordal.UsageError`."""
        table, planned = self._program.trajectory(period, level, max_samples)
        return Trajectory(table, period, planned)

    def transform(
        self,
        *,
        shift: Sequence[float] | None = None,
        rotate: float | None = None,
        about: Sequence[float] = (0.0, 0.0),
        mirror: Literal["x", "y"] | None = None,
        scale: float | None = None,
        units: Literal["mm", "inch"] | None = None,
        feed: float = 1.0,
        speed: float = 1.0,
        arcs: Literal["radius", "center"] | None = None,
        chords: float | None = None,
        simplify: float | None = None,
        fit: float | None = None,
        feed_tolerance: float = 0.01,
        renumber: tuple[int, int] | None = None,
        no_numbers: bool = False,
        strip_comments: bool = False,
        shrink: int | None = None,
    ) -> Transformed:
        """The transformed program, and whether its motion is proved to be the intended one: see ``proved``.

        It does the same as ``chordal transform``, in this order: units, mirror, rotate, scale, shift, feed and speed,
        chords, simplify, fit, arcs, comments, numbers, shrink. Each word is changed according to its meaning in its
        block; then the new program is run and its path is compared with the intended path. Lengths are millimetres,
        independent of the program's units. Omitted keywords change nothing.

        ``shift``: distance along X, Y and Z, mm.
        ``rotate``: angle about Z, degrees, counter-clockwise.
        ``about``: centre of ``rotate``, X and Y, mm.
        ``mirror``: ``"x"`` or ``"y"``, the axis whose sign changes.
        ``scale``: factor of every length.
        ``units``: ``"mm"`` or ``"inch"`` for every length, including feeds.
        ``feed``: factor of the feeds of cuts.
        ``speed``: factor of spindle speeds, and therefore of the feeds of taps.
        ``arcs``: ``"radius"`` or ``"center"``, the form in which arcs are written.
        ``chords``: replaces arcs and spirals by chords within this distance, mm.
        ``simplify``: reduces the number of chords, with the path within this distance, mm.
        ``fit``: replaces chords by lines and tangent arcs within this distance, mm.
        ``feed_tolerance``: allowed relative difference in the feeds of chords that ``fit`` joins.
        ``renumber``: first N number and step.
        ``no_numbers``: ``True`` removes the N numbers to which nothing refers.
        ``strip_comments``: ``True`` removes comments.
        ``shrink``: largest size of the text, bytes; spaces, digits, N numbers and comments are removed as far as
        necessary.

        If a change is not possible for the program, :class:`~chordal.UsageError` is raised and names the line.

        >>> import chordal
        >>> text = "G21 G90 S900 M3\\nG0 X0 Y0 Z0\\nG1 X9. F50.\\nM30\\n"
        >>> moved = chordal.loads(text, "haas-vf2").transform(shift=(5, 0, 0))
        >>> moved.proved, moved.text.splitlines()[2]
        (True, b'G1 X14. F50.')
        """
        steps = _transform.steps(
            shift,
            rotate,
            about,
            mirror,
            scale,
            units,
            feed,
            speed,
            arcs,
            chords,
            simplify,
            fit,
            feed_tolerance,
            renumber,
            no_numbers,
            strip_comments,
            shrink,
        )
        return _transform.transformed(self._program, steps)

    def split(self, most: int | Literal["tool"]) -> Split:
        """The program in parts of at most ``most`` bytes, or one part for each ``"tool"``. Each part is a complete
        program; all of them, run one after the other, are compared with the whole: see ``proved``.

        Lines between which no split is possible raise :class:`~chordal.UsageError`, which names them."""
        if most != "tool" and (isinstance(most, str) or most <= 0):
            raise UsageError(f"{most!r} is not a size", 'give a number of bytes, or "tool"')
        return _transform.parts(*self._program.split(None if most == "tool" else int(most)))

    def bend(
        self,
        heights: bytes | str,
        *,
        units: Literal["mm", "inch"] = "mm",
        zero: tuple[float, float] | None = None,
        tolerance: float = 0.01,
        clamp: bool = False,
    ) -> Transformed:
        """The program adapted to a measured surface (height map), and whether each cut is proved to follow it.

        ``heights``: the map as CSV text, X, Y and Z of a full grid of points.
        ``units``: units of the map.
        ``zero``: X and Y of the point at which Z was set to zero, mm; without it, heights are used as measured.
        ``tolerance``: largest distance of the new path from the surface, mm.
        ``clamp``: continues the edge of the map beyond it; otherwise a cut there raises :class:`~chordal.UsageError`.

        >>> import chordal
        >>> text = "G21 G90 S900 M3\\nG0 X0 Y0\\nZ5.\\nG1 Z-1. F50.\\nX9.\\nM30\\n"
        >>> slope = "x,y,z\\n0,0,0\\n10,0,0.1\\n0,10,0\\n10,10,0.1\\n"
        >>> bent = chordal.loads(text, "haas-vf2").bend(slope)
        >>> bent.proved, bent.text.splitlines()[4]
        (True, b'X9. Z-0.91')
        """
        text = heights.encode() if isinstance(heights, str) else bytes(heights)
        mm_per_unit = 25.4 if units == "inch" else 1.0
        return _transform.proved_text(*self._program.bend(text, mm_per_unit, zero, float(tolerance), clamp))

    def restart(self, line: int) -> Restarted:
        """A program that begins at a line (from 1): a preamble with the modes, tool, offsets, spindle and
        approach of that line, then the unchanged text. Both programs are run, and from the line on they do the same.

        If the program cannot begin there, :class:`~chordal.UsageError` says why, and where it can.

        >>> import chordal
        >>> text = "G21 G90 S900 M3\\nG0 X0 Y0 Z5.\\nG1 Z-1. F50.\\nX9.\\nX20.\\nM30\\n"
        >>> chordal.loads(text, "haas-vf2").restart(5).put_in[-1]
        'G1 Z-1. F50.'
        """
        return _transform.restarted(*self._program.restart(line))

    def compare(
        self,
        other: Program,
        *,
        tolerance: float = 0.0,
        feed_tolerance: float = 1e-6,
        ignore: Sequence[str] = (),
    ) -> Comparison:
        """Compare this program with another by what they do, not by their text. Not counted as differences are paths
        up to ``tolerance`` mm apart, feeds and speeds whose relative difference is within ``feed_tolerance`` (by
        default only what rounding makes of them), and the categories in ``ignore``, such as ``"coolant"``.

        >>> import chordal
        >>> text = "G21 G90 S100 M3\\nG0 X0 Y0 Z0\\nG1 X9. F50.\\nM30\\n"
        >>> one = chordal.loads(text, "haas-vf2")
        >>> one.compare(chordal.loads(text.replace("9.", "9.5"), "haas-vf2")).max_distance_mm
        0.5
        """
        answer = self._program.compare(
            other._program, float(tolerance), float(feed_tolerance), list(ignore)
        )
        return _comparison.comparison(json.loads(answer))

    def convert(
        self,
        to: MachineLike,
        *,
        tolerance: float = 0.005,
        digits: int | None = None,
        despite_errors: bool = False,
        exact_cycles: bool = False,
        axis_positions: bool = False,
    ) -> Conversion:
        """Convert the program for another machine. Each change has its reason, and the new program is compared with
        this one: see ``holds``. Where a shape must be written out as moves, the path is within ``tolerance`` mm;
        ``digits`` is the number of decimals of computed words. A cycle is kept when only its pecks differ, which are
        listed in ``pecks``; ``exact_cycles`` writes it out as moves. ``axis_positions`` writes the positions of the axes
        in place of the tip of the tool on the same control, too; another control always gets them.
        ``despite_errors`` converts a program with errors, too.

        >>> import chordal
        >>> fadal = chordal.loads("G0 G90 E1 X1. Y1.\\nM2\\n", "fadal-4020")
        >>> print(fadal.convert("haas-vf2").changes[0].after)
        G54
        """
        answer = self._program.convert(
            machine_of(to)._machine,
            float(tolerance),
            digits,
            despite_errors,
            exact_cycles,
            axis_positions,
        )
        return _comparison.conversion(json.loads(answer))

    def stock(
        self,
        setup: MachineLike | None = None,
        *,
        resolution_mm: float | None = None,
        finest_mm: float | None = None,
        tolerance_mm: float = 0.01,
        memory: int = DEFAULT_STOCK_BYTES,
    ) -> Stock:
        """What the program leaves of the stock, between two bounds, and collisions of rapids, shank and holder.

        ``setup``: a setup file, or a machine as for :func:`load`, with ``stock`` and ``tools``; without it, the
        program's own machine.
        ``resolution_mm``: side of a column; without it, from the size of the stock.
        ``finest_mm``: columns that cannot decide are halved, down to this side; without it, an eighth of the
        resolution.
        ``tolerance_mm``: contacts up to this depth are not reported.
        ``memory``: the most memory for the columns, bytes.

        For a lathe, the half section is exact: the result is a :class:`~chordal.TurnedStock`, with ``outline`` and
        ``passes`` and without columns; ``resolution_mm``, ``finest_mm`` and ``memory`` have no effect.

        Without stock, with a wrong setup, or with too little memory, :class:`~chordal.UsageError` is raised.

        >>> import chordal
        >>> setup = {
        ...     "machine": "haas-vf2",
        ...     "stock": {
        ...         "shape": "box",
        ...         "from": {"X": "0 mm", "Y": "0 mm", "Z": "-20 mm"},
        ...         "to": {"X": "80 mm", "Y": "60 mm", "Z": "0 mm"},
        ...     },
        ...     "tools": {1: {"shape": "flat", "diameter": "10 mm", "flute_length": "25 mm"}},
        ... }
        >>> text = "G21 G90 G54\\nT1 M6\\nS3000 M3\\nG0 X-20. Y30.\\nG43 H1 Z-5.\\nG1 X100. F600.\\nM30\\n"
        >>> left = chordal.loads(text, setup).stock()
        >>> left.verdict, left.most.shape, round(float(left.most[150, 200]), 3)
        ('clean', (300, 400), -5.0)
        """
        machine = None if setup is None else machine_of(setup)._machine
        found = self._program.stock(machine, resolution_mm, finest_mm, float(tolerance_mm), memory)
        return TurnedStock(found) if isinstance(found, _chordal.TurnedStock) else Stock(found)

    def report(self, *, date: str | None = None) -> str:
        """The setup sheet: path, offsets, tools, times, travel, stops and problems on one self-contained HTML page.
        The same program gives the same text; it has a date only if one is given."""
        return self._program.report_html(date)

    def svg(self, width: int = 1600, height: int = 1131, *, dark: bool = False) -> str:
        """The views of the path as SVG; width and height in px, by default in the ratio of a landscape A4 sheet."""
        return self._program.svg(width, height, dark)

    def png(self, width: int = 1600, height: int = 1131, *, dark: bool = False) -> bytes:
        """The views of the path as PNG; width and height in px, from 200 to 16384."""
        return bytes(self._program.png(width, height, dark))

    def __repr__(self) -> str:
        return f"<Program {self.name} on {self.machine.name}>"

    def _repr_svg_(self) -> str:
        return self.svg()

    def _repr_html_(self) -> str:
        return _notebook.program_html(self)
