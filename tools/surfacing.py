#!/usr/bin/env python3
"""A surfacing program of so many lines, for measuring: a raster of 0.1 mm lines over a wavy surface.

    tools/surfacing.py 1000000 > surfacing.ngc
"""
import math
import sys

ROW = 1000


def main():
    count = int(sys.argv[1])
    out = sys.stdout
    out.write("G21 G90 G17 G64 P0.01\nT1 M6\nS12000 M3\nG0 X0 Y0 Z5\nG1 Z0.3 F3000\n")
    for i in range(count):
        row, step = divmod(i, ROW)
        x = 0.1 * (step if row % 2 == 0 else ROW - 1 - step)
        z = 0.6 * math.sin(0.3 * x) + 0.3 * math.cos(0.11 * x + 0.05 * row)
        word = f"Y{0.1 * row:.3f}" if step == 0 else ""
        out.write(f"X{x:.3f}{word}Z{z:.4f}\n")
    out.write("G0 Z5\nM30\n")


main()
