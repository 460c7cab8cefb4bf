"""How a notebook shows a program."""

from __future__ import annotations

import base64
import html
from typing import TYPE_CHECKING

from .diagnostics import problems_html

if TYPE_CHECKING:
    from ._program import Program

#: Longer SVG pictures, in characters, are replaced by PNG, because a notebook stores them in its file.
_MOST_SVG = 2_000_000

#: The most problems that are shown.
_MOST_PROBLEMS = 20


def program_html(program: Program) -> str:
    """The picture, the summary and the problems of a program as HTML."""
    return "".join((_picture(program), _summary(program), _problems(program)))


def _picture(program: Program) -> str:
    svg = program.svg()
    if len(svg) > _MOST_SVG:
        kind, data = "png", program.png()
    else:
        kind, data = "svg+xml", svg.encode()
    source = f"data:image/{kind};base64,{base64.b64encode(data).decode()}"
    alt = html.escape(f"Path of {program.name}")
    return f'<img style="max-width:100%" alt="{alt}" src="{source}">'


def _summary(program: Program) -> str:
    told = program.summary
    scale, unit = (25.4, "in") if told.inch else (1.0, "mm")
    cuts = {
        "line": told.lines,
        "arc": told.arcs,
        "helix": told.helices,
        "spiral": told.spirals,
        "spline": told.splines,
        "rapid": told.rapids,
    }
    rows = [
        ("program", program.name),
        ("machine", f"{program.machine.title} ({program.control})"),
        ("moves", ", ".join(f"{count} × {kind}" for kind, count in cuts.items() if count) or "none"),
        ("cuts", f"{told.feed_length_mm / scale:.2f} {unit}, {told.feed_time_s:.1f} s at feed"),
        ("rapids", f"{told.rapid_length_mm / scale:.2f} {unit}, {told.rapid_time_s:.1f} s"),
    ]
    for axis in told.axes:
        rotary = axis.letter in "ABC"
        low, high = (place / (1.0 if rotary else scale) for place in axis.range)
        rows.append((axis.letter, f"{low:.4f} to {high:.4f} {'deg' if rotary else unit}"))
    if program.recognized is not None:
        rows.append(("control", program.recognized))
    cells = "".join(
        f'<tr><th style="text-align:left">{html.escape(name)}</th>'
        f'<td style="text-align:left">{html.escape(text)}</td></tr>'
        for name, text in rows
    )
    return f"<table>{cells}</table>"


def _problems(program: Program) -> str:
    problems = program.diagnostics
    if not problems:
        return "<p>no problems</p>"
    more = len(problems) - _MOST_PROBLEMS
    rest = f"<p>and {more} more</p>" if more > 0 else ""
    return problems_html(problems[:_MOST_PROBLEMS]) + rest
