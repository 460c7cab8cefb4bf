"""Dictionaries as the TOML of a machine file."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence

from .errors import UsageError

_BARE = re.compile(r"[A-Za-z0-9_-]+")


def key(name: object) -> str:
    """A key, quoted if necessary."""
    if not isinstance(name, (str, int)) or isinstance(name, bool):
        raise UsageError(f"{name!r} cannot be a key", "keys are text, or whole numbers of tools")
    text = str(name)
    return text if _BARE.fullmatch(text) else string(text)


def string(text: str) -> str:
    """A string."""
    # JSON escapes the same characters as TOML, except for the delete character.
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def value(what: object) -> str:
    """A value on one line."""
    match what:
        case bool():
            return "true" if what else "false"
        case str():
            return string(what)
        case int():
            return str(what)
        case float():
            return repr(what)
        case Mapping():
            return "{ " + ", ".join(f"{key(k)} = {value(v)}" for k, v in what.items()) + " }"
        case Sequence():
            return "[" + ", ".join(value(each) for each in what) + "]"
    raise UsageError(
        f"a {type(what).__name__} cannot be a value of a machine file: {what!r}",
        "text with a unit (`\"0.5 in\"`), numbers, true or false, lists and dictionaries can",
    )


def document(machine: Mapping[str, object]) -> str:
    """A whole machine, a table for each dictionary."""
    lines: list[str] = []
    _table(machine, (), lines)
    return "\n".join(lines) + "\n"


def _table(table: Mapping[str, object], path: tuple[str, ...], lines: list[str]) -> None:
    inner: list[tuple[object, Mapping[str, object]]] = []
    for name, what in table.items():
        if isinstance(what, Mapping):
            inner.append((name, what))
        else:
            lines.append(f"{key(name)} = {value(what)}")
    for below_name, below in inner:
        here = (*path, key(below_name))
        lines.append(f"[{'.'.join(here)}]")
        _table(below, here, lines)


def assignments(table: Mapping[str, object], *path: str) -> list[str]:
    """A table as assignments for ``chordal run --set``."""
    found: list[str] = []
    for name, what in table.items():
        here = (*path, key(name))
        if isinstance(what, Mapping):
            found.extend(assignments(what, *here))
        else:
            found.append(f"{'.'.join(here)} = {value(what)}")
    return found
