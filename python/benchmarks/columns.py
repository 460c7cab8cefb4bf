"""What columns cost: a long program into Arrow, beside the same run without columns.

    python python/benchmarks/columns.py [lines]
"""

from __future__ import annotations

import resource
import sys
import time
from collections.abc import Callable

import numpy as np
from threads import surface

import chordal


def best_of(count: int, work: Callable[[], object]) -> float:
    """The shortest wall time, s."""
    times = []
    for _ in range(count):
        began = time.perf_counter()
        work()
        times.append(time.perf_counter() - began)
    return min(times)


def main(lines: int) -> None:
    """Print times and peak memory."""
    text = surface(lines)

    def load() -> chordal.Program:
        return chordal.loads(text, "haas-vf2")

    # The summary runs with all checks and keeps no row: what the columns come on top of.
    plain = best_of(3, lambda: load().summary)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    columns = best_of(3, lambda: load().commands())
    after = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    table = load().commands()
    block = np.ones(table.nbytes // 8)
    copy = best_of(3, block.copy)
    print(f"{lines} lines, {len(table)} rows, {table.nbytes / 1e6:.0f} MB of columns")
    print(f"without columns {plain:.3f} s, a copy of as many bytes {copy:.3f} s")
    print(f"with columns {columns:.3f} s: {columns / (plain + copy):.2f} x the two together")
    print(f"peak memory {after / 1024:.0f} MB, before {before / 1024:.0f} MB")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 1_000_000)
