"""Machines: built-in ones, and machines from files and dictionaries."""

from __future__ import annotations

import os
from collections.abc import Mapping

from . import _chordal, _toml

__all__ = ["Machine", "MachineLike", "builtin_machines", "machine_of"]


class Machine:
    """A machine: its control, axes, limits, tools, offsets and settings. It never changes.

    Quantities are text with their unit, such as ``"0.5 in"``; ``chordal machines --schema`` lists the keys.
    """

    __slots__ = ("_machine",)

    def __init__(self, machine: _chordal.Machine) -> None:
        self._machine = machine

    @classmethod
    def named(cls, name: str) -> Machine:
        """A built-in machine, such as ``haas-vf2``, or a machine from a file.

        Raises :class:`~chordal.UsageError` for an unknown name and :class:`~chordal.MachineError` for a wrong file.
        """
        return cls(_chordal.Machine.named(name))

    @classmethod
    def from_file(cls, path: str | os.PathLike[str]) -> Machine:
        """A machine from a TOML file."""
        with open(path, "rb"):
            pass  # raises the system's own error for a missing file
        return cls(_chordal.Machine.from_file(os.fspath(path)))

    @classmethod
    def from_toml(cls, text: str, name: str = "<machine>") -> Machine:
        """A machine from a TOML text; messages show ``name``."""
        return cls(_chordal.Machine.from_toml(text, name))

    @classmethod
    def from_dict(cls, machine: Mapping[str, object], name: str = "<machine>") -> Machine:
        """A machine from a dictionary with the structure of a machine file.

        >>> own = Machine.from_dict({
        ...     "inherits": "haas-vf2",
        ...     "tools": {1: {"diameter": "0.75 in", "length": "4.1 in"}},
        ...     "settings": {"Setting 162": "on"},
        ... })
        >>> own.control
        'haas'
        """
        return cls.from_toml(_toml.document(machine), name)

    @property
    def name(self) -> str:
        """The short name."""
        return self._machine.name

    @property
    def title(self) -> str:
        """The full name, for display."""
        return self._machine.title

    @property
    def control(self) -> str:
        """The control that runs its programs, such as ``haas`` or ``haas-lathe``."""
        return self._machine.control

    @property
    def axes(self) -> str:
        """Its axes, such as ``XYZA``."""
        return self._machine.axes

    def to_toml(self) -> str:
        """The complete machine as the text of a machine file."""
        return self._machine.to_toml()

    def replace(self, changes: Mapping[str, object]) -> Machine:
        """A copy of the machine with other values, such as ``{"tools": {5: {"diameter": "0.5 in"}}}``."""
        return Machine(self._machine.with_set(_toml.assignments(changes)))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Machine) and self._machine == other._machine

    def __hash__(self) -> int:
        return hash((self.name, self.control))

    def __reduce__(self) -> tuple[object, tuple[str, str]]:
        return Machine.from_toml, (self.to_toml(), self.name)

    def __repr__(self) -> str:
        return f"<Machine {self.name}: {self.title}, control {self.control}, axes {self.axes}>"


#: Anything that specifies a machine: a :class:`Machine`, a built-in name, a file, or a dictionary.
MachineLike = Machine | str | os.PathLike[str] | Mapping[str, object]


def machine_of(given: MachineLike) -> Machine:
    """The specified machine."""
    match given:
        case Machine():
            return given
        case str():
            return Machine.named(given)
        case Mapping():
            return Machine.from_dict(given)
        case _:
            return Machine.from_file(given)


def builtin_machines() -> tuple[str, ...]:
    """The names of the built-in machines."""
    return tuple(_chordal.builtin_machines())
