"""The command ``chordal``."""

from __future__ import annotations

import signal
import sys

from ._chordal import main as _main


def main() -> int:
    """Run the command with the arguments of the process, and return its exit code."""
    # Python would handle an interrupt only after the command has ended.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    return _main(["chordal", *sys.argv[1:]])
