"""The names of the controls. Generated: see CONTRIBUTING.md, Change a page."""

from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:
    #: The controls that can run a program.
    _ControlName = Literal[
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
        "sinumerik",
        "sinumerik-lathe",
        "heidenhain",
    ]
