"""The names of the controls. Generated: see CONTRIBUTING.md, Change a page."""

from typing import Literal

#: The controls that can run a program.
ControlName = Literal[
    "fadal",
    "haas",
    "fanuc",
    "mitsubishi",
    "linuxcnc",
    "fanuc-lathe",
    "linuxcnc-lathe",
    "haas-lathe",
    "mitsubishi-lathe",
    "grbl",
    "grblhal",
    "fluidnc",
    "mach3",
    "marlin",
]
