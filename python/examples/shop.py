"""How long do the programs of a folder take, and which blocks cost the most?

Run it with a folder, and the name of a machine where no ``chordal.toml`` says it:

    python python/examples/shop.py examples/haas haas-vf2
"""

from __future__ import annotations

import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import chordal


def line_of(file: Path, machine: str | None) -> str:
    """What is to be told of one program."""
    program = chordal.load(file, machine)
    if program.errors:
        return f"{file.name:28} {program.errors[0].message}"
    time = program.time()
    costly = time.costliest_blocks[0] if time.costliest_blocks else None
    why = f"line {costly.line} loses {costly.lost_s:.2f} s" if costly else "no block loses time"
    return f"{file.name:28} {time.total_s:9.1f} s   {why}"


def main(folder: str, machine: str | None = None) -> None:
    """Tell of every program of a folder; threads run at the same time."""
    files = sorted(Path(folder).glob("*.nc"))
    with ThreadPoolExecutor() as pool:
        for line in pool.map(lambda file: line_of(file, machine), files):
            print(line)


if __name__ == "__main__":
    main(*sys.argv[1:])
