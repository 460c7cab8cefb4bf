#!/usr/bin/env python3
"""A lathe program of about so many lines, with its setup, for measuring: roughing and contours of short lines, as CAM
systems write them, grooves and faces.

    tools/turning.py 10000 FOLDER
"""
import math
import pathlib
import sys

SETUP = """machine = "fanuc-lathe"
[stock]
shape = "cylinder"
diameter = "100 mm"
from = "-160 mm"
to = "1 mm"
[fixtures.jaws]
shape = "tube"
diameter = "200 mm"
bore = "100 mm"
from = "-200 mm"
to = "-140 mm"
[tools.1]
shape = "insert"
insert = "C"
approach_angle = "95 deg"
flute_length = "12 mm"
nose_radius = "0.8 mm"
tip = 3
holder_outline = [["8 mm", "10 mm"], ["120 mm", "10 mm"], ["120 mm", "35 mm"], ["8 mm", "35 mm"]]
[tools.3]
shape = "insert"
insert = "V"
approach_angle = "93 deg"
flute_length = "16 mm"
nose_radius = "0.4 mm"
tip = 3
[tools.5]
shape = "groove"
width = "3 mm"
corner_radius = "0.2 mm"
flute_length = "20 mm"
tip = 3
"""


def radius(z):
    return 36.0 + 6.0 * math.sin(0.05 * z) - 0.06 * z


def main():
    count, folder = int(sys.argv[1]), pathlib.Path(sys.argv[2])
    lines = ["O1", "G21 G18 G40 G97 G99", "G50 S2500", "T0101", "G96 S200 M3"]
    # A quarter roughs in levels, the rest follows the contour in short lines, three times.
    levels = count // 16
    for level in range(levels):
        x = 100.0 - 20.0 * (level + 1) / levels
        lines += [f"G0 X{x:.3f} Z3.", f"G1 Z-{120 - 40 * level / levels:.3f} F.3", f"X{x + 2:.3f} W1.", "G0 Z3."]
    steps = (count - len(lines) - 40) // 3
    lines += ["G0 X120. Z50.", "T0303", "G96 S280 M3"]
    for rest in (1.0, 0.4, 0.0):
        lines.append(f"G0 X{2 * (radius(0) + rest):.3f} Z8.")
        lines.append(f"G42 G1 Z4. F.15")
        for step in range(steps):
            z = -110.0 * step / steps
            lines.append(f"G1 X{2 * (radius(z) + rest):.3f} Z{z:.3f}")
        lines += ["G40 G1 X104. Z-105.", "G0 Z8."]
    lines += ["G0 X120. Z50.", "T0505", "G97 S600 M3"]
    for groove in range(5):
        z = -20.0 - 15.0 * groove
        lines += [f"G0 X104. Z{z:.1f}", f"G1 X{2 * radius(z) - 4:.3f} F.08", "G0 X104."]
    lines += ["G0 X120. Z50.", "M5", "M30"]
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "turning.nc").write_text("\n".join(lines) + "\n")
    (folder / "turning.toml").write_text(SETUP)


main()
