#!/usr/bin/env python3
"""Writes a square."""
def square(a, z=-1.0, f=300):
    yield "G21 G90"
    yield "G0 X0 Y0"
    yield f"G1 Z{z} F{f}"
    for x, y in ((a, 0), (a, a), (0, a), (0, 0)):
        yield f"G1 X{x} Y{y}"
    yield "M30"

if __name__ == "__main__":
    print("\n".join(square(40)))
