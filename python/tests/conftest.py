"""What the tests share."""

from __future__ import annotations

from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def examples() -> Path:
    """The folder of the examples of the repository."""
    return ROOT / "examples"


#: A part with lines, arcs, a tool change and comments, in millimetres.
PART = """\
O0001 (PART)
G21 G90 G17 G40 G49 G80
T1 M06
G54 G00 X0. Y0. S3000 M03
G43 H01 Z5.
G01 Z-1. F200.
G01 X40. F600.
G03 X50. Y10. I0. J10.
G01 Y30.
G03 X40. Y40. I-10. J0.
G01 X0.
G01 Y0.
G00 Z50.
M30
"""

#: The end of the arc does not lie on its circle.
BROKEN = "G21 G90 S900 M3\nG1 X0 Y0 F100.\nG3 X10. Y12. I0. J10.\nM30\n"
