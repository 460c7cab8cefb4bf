"""Run an NC program the way its control would run it: exact path, exact time, every alarm.

>>> import chordal
>>> program = chordal.loads("G21 G90 S900 M3\\nG1 X0 Y0 F100.\\nG3 X10. Y10. R10.\\nM30\\n",
...                         machine="haas-vf2")
>>> program.summary.arcs
1
>>> program.diagnostics
()

Results with many rows are a :class:`Table` of Arrow columns, which pyarrow, Polars and DuckDB read without a copy,
and which gives NumPy arrays. Lengths are millimetres, angles degrees, times seconds and feeds mm/min, independent of
the program's units; every column states its unit.

Long calls release the interpreter lock, so that other threads can run.
"""

from __future__ import annotations

from . import archive, geometry, motion
from ._chordal import __version__
from ._comparison import Comparison, Conversion, Refusal
from ._machine import Machine, builtin_machines
from ._program import Program, load, loads
from ._shop import ShopAnswer, ShopCall, ShopCodes, ShopRefusal, ShopWait
from ._stock import Stock, StockDifference, StockMesh
from ._summary import AxisTravel, Summary, ToolUse
from ._table import Chords, Moves, Table, Trajectory
from ._time import BlockTime, Time, ToolTime
from ._transform import Change, Part, Restarted, Split, Transformed
from ._turned import TurnedStock
from .diagnostics import Diagnostic, Fix, Label, Place, codes
from .errors import ChordalError, MachineError, MachineProblem, ProgramError, UsageError

__all__ = [
    "AxisTravel",
    "BlockTime",
    "Change",
    "ChordalError",
    "Chords",
    "Comparison",
    "Conversion",
    "Diagnostic",
    "Fix",
    "Label",
    "Machine",
    "MachineError",
    "MachineProblem",
    "Moves",
    "Place",
    "Part",
    "Program",
    "ProgramError",
    "Refusal",
    "Restarted",
    "ShopAnswer",
    "ShopCall",
    "ShopCodes",
    "ShopRefusal",
    "ShopWait",
    "Split",
    "Stock",
    "StockDifference",
    "StockMesh",
    "Summary",
    "Table",
    "Time",
    "ToolTime",
    "ToolUse",
    "Trajectory",
    "Transformed",
    "TurnedStock",
    "UsageError",
    "__version__",
    "archive",
    "builtin_machines",
    "codes",
    "geometry",
    "load",
    "loads",
    "motion",
]
