"""Exceptions, with details as attributes.

Problems of a *program* are not exceptions: a program with problems still has a path and a time, and its
:attr:`~chordal.Program.diagnostics` list them. They raise :class:`ProgramError` on request, with ``load(...,
strict=True)`` or :meth:`chordal.Program.raise_errors`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .diagnostics import Diagnostic

__all__ = ["ChordalError", "MachineError", "MachineProblem", "ProgramError", "UsageError"]


class ChordalError(Exception):
    """The base class of all exceptions of this package."""


class UsageError(ChordalError, ValueError):
    """A request that is not possible, and what to do instead."""

    #: What is not possible.
    message: str
    #: What to do instead; ``None`` without advice.
    help: str | None

    def __init__(self, message: str, help: str | None = None) -> None:
        super().__init__(message, help)
        self.message = message
        self.help = help

    def __str__(self) -> str:
        return self.message if self.help is None else f"{self.message}\nhelp: {self.help}"


@dataclass(frozen=True, slots=True)
class MachineProblem:
    """One error in a machine file, a dictionary or a tool table."""

    #: The file, or the name used for it.
    file: str
    #: The line, from 1; ``None`` if something is missing completely.
    line: int | None
    #: What is wrong.
    message: str
    #: What to write instead; ``None`` without advice.
    help: str | None
    #: The words that are wrong.
    underlined: str
    #: The whole error as text, with the words underlined.
    text: str

    def __str__(self) -> str:
        return self.text


class MachineError(ChordalError, ValueError):
    """A machine that cannot be used."""

    #: All errors found.
    problems: tuple[MachineProblem, ...]

    def __init__(self, problems: tuple[MachineProblem, ...]) -> None:
        super().__init__(problems)
        self.problems = problems

    def __str__(self) -> str:
        return "the machine cannot be used\n" + "".join(each.text for each in self.problems)


class ProgramError(ChordalError):
    """A program with errors, raised only on request of the caller."""

    #: The name of the program.
    name: str
    #: All its problems, including warnings and notes, sorted by location.
    diagnostics: tuple[Diagnostic, ...]

    def __init__(self, name: str, diagnostics: tuple[Diagnostic, ...]) -> None:
        super().__init__(name, diagnostics)
        self.name = name
        self.diagnostics = diagnostics

    def __str__(self) -> str:
        errors = [each for each in self.diagnostics if each.severity == "error"]
        count = "1 error" if len(errors) == 1 else f"{len(errors)} errors"
        return f"{self.name}: {count}\n" + "\n".join(each.text for each in errors)


def machine_error(
    problems: list[tuple[str, int | None, str, str | None, str, str]],
) -> MachineError:
    """The exception for problems from the compiled module."""
    return MachineError(tuple(MachineProblem(*each) for each in problems))


def usage_error(message: str, help: str | None) -> UsageError:
    """The exception for a request that is not possible."""
    return UsageError(message, help)
