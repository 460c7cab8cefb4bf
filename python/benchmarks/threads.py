"""The interpreter lock is let go: two threads against one, and Python while Rust works.

    python python/benchmarks/threads.py
"""

from __future__ import annotations

import math
import threading
import time

import chordal


def surface(lines: int) -> str:
    """A program of many short moves."""
    blocks = ["G21 G90 G17 S9000 M3", "G0 X0 Y0 Z5.", "G1 Z0 F3000."]
    blocks += [
        f"X{0.2 * (i % 1000):.3f} Y{i // 1000:.3f} Z{math.sin(i / 40):.4f}" for i in range(lines)
    ]
    return "\n".join([*blocks, "M30", ""])


def timed(threads: int, program: chordal.Program) -> float:
    """Wall time of one run in each thread, s."""
    work = [threading.Thread(target=program.trajectory, args=(0.004,)) for _ in range(threads)]
    began = time.perf_counter()
    for each in work:
        each.start()
    for each in work:
        each.join()
    return time.perf_counter() - began


def counted_beside(program: chordal.Program) -> tuple[int, float]:
    """How far Python counts while a trajectory is made, and for how long."""
    done = threading.Event()

    def work() -> None:
        program.trajectory(0.004)
        done.set()

    thread = threading.Thread(target=work)
    began = time.perf_counter()
    thread.start()
    count = 0
    while not done.is_set():
        count += 1
    thread.join()
    return count, time.perf_counter() - began


def main() -> None:
    """Print the times."""
    program = chordal.loads(surface(100_000), "haas-vf2")
    one, two = (min(timed(threads, program) for _ in range(3)) for threads in (1, 2))
    print(f"one thread {one:.2f} s, two threads with twice the work {two:.2f} s: {2 * one / two:.2f} x")
    count, seconds = counted_beside(program)
    print(f"Python counted to {count} in the {seconds:.2f} s of one run")


if __name__ == "__main__":
    main()
