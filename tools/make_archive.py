#!/usr/bin/env python3
"""Makes an archive of NC programs of all five controls, broken ones among them.

    tools/make_archive.py FOLDER COUNT [SEED]

The same count and seed give the same files. About one file in twenty is broken: empty, binary, cut
off, endless, of no known control. About one in fifty is a dump of several programs.
"""

import math
import random
import sys
from pathlib import Path

HEADS = {
    # What each control's program begins and ends with; {n} is its number.
    "haas": ("%\nO{n:05d} (PART {n})\nG20 G17 G40 G49 G80 G90\nT1 M6\nG187 P2\nG0 G90 G54 X0 Y0 S6000 M3\nG43 H01 Z1. M8\n", "G0 Z1. M9\nM5\nG28 G91 Z0\nG90\nM30\n%\n"),
    "fanuc": ("%\nO{n:04d}(PART {n})\nG21G17G40G49G80G90\nT1M6\nG5.1Q1\nG0G90G54X0Y0S6000M3\nG43H1Z25.M8\n", "G0Z25.M9\nG5.1Q0\nM5\nG91G28Z0\nG90\nM30\n%\n"),
    "fadal": ("M6 T1 (PART {n}, END MILL\nG20 G90 G0 S6000 M3 E1 X0 Y0\nH1 Z1. M8\n", "G0 Z1. M9\nM5\nG90 G0 H0 Z0\nM2\n"),
    "mitsubishi": ("%\nO{n}(PART {n})\nG21 G17 G40 G49 G80 G90\nT1 M6\nG0 G90 G54 X0 Y0 S6000 M3\nG43 H1 Z25. M8\n", "G0 Z25. M9\nM5\nG91 G28 Z0\nG90\nM30\n%\n"),
    "linuxcnc": ("(part {n})\nG21 G17 G40 G49 G80 G90 G64 P0.01\nT1 M6\nG0 G54 X0 Y0 S6000 M3\nG43 H1 Z25. M8\n", "G0 Z25. M9\nM5\nM2\n"),
}
CONTROLS = list(HEADS)
INCH = {"haas", "fadal"}


def body(rng: random.Random, control: str, moves: int) -> list[str]:
    """Rings of short chords, squares with round corners, and holes."""
    scale = 1.0 if control in INCH else 25.0
    feed = 20.0 if control in INCH else 500.0
    space = "" if control == "fanuc" else " "
    lines = [f"G1{space}Z-{0.1 * scale:.4f}{space}F{feed:.1f}"]
    while len(lines) < moves:
        kind = rng.random()
        radius = rng.uniform(0.3, 2.0) * scale
        if kind < 0.6:
            count = rng.randint(20, 120)
            for i in range(count + 1):
                angle = 2 * math.pi * i / count
                r = radius * (1 + 0.05 * math.sin(5 * angle))
                lines.append(f"X{r * math.cos(angle):.4f}{space}Y{r * math.sin(angle):.4f}")
        elif kind < 0.9:
            a, r = radius, radius / 4
            for x, y, i, j in ((a, a - r, 0, 0), (a - r, a, -r, 0), (-a + r, a, 0, 0), (-a, a - r, 0, -r)):
                g = 3 if i or j else 1
                centre = f"{space}I{i:.4f}{space}J{j:.4f}" if g == 3 else ""
                lines.append(f"G{g}{space}X{x:.4f}{space}Y{y:.4f}{centre}")
            lines.append(f"G1{space}X{a:.4f}{space}Y{-a:.4f}")
        else:
            lines.append(f"G0{space}Z{0.2 * scale:.4f}")
            for _ in range(rng.randint(2, 9)):
                x, y = rng.uniform(-2, 2) * scale, rng.uniform(-2, 2) * scale
                lines.append(f"G0{space}X{x:.3f}{space}Y{y:.3f}")
                lines.append(f"G1{space}Z-{0.3 * scale:.3f}")
                lines.append(f"G0{space}Z{0.2 * scale:.3f}")
            lines.append(f"G1{space}Z-{0.1 * scale:.4f}")
    return lines


def program(rng: random.Random, control: str, number: int, moves: int) -> str:
    head, tail = HEADS[control]
    return head.format(n=number) + "\n".join(body(rng, control, moves)) + "\n" + tail


def size(rng: random.Random) -> int:
    """Most are small, few are long: the middle is some hundred moves."""
    return min(60_000, int(10 * math.exp(abs(rng.gauss(0, 1)) * 2.2) * 4))


def broken(rng: random.Random, control: str, number: int) -> bytes:
    kind = rng.randrange(6)
    text = program(rng, control, number, 60)
    if kind == 0:
        return b""
    if kind == 1:
        return bytes(rng.randrange(256) for _ in range(2000))
    if kind == 2:
        return text[: len(text) // 2 + rng.randrange(20)].encode()
    if kind == 3:
        return f"%\nO{number}(ENDLESS)\nG21 G90 G0 X0 Y0\nN10 G0 X1.\nX0\nGOTO10\nM30\n%\n".encode()
    if kind == 4:
        return f"O{number}\nGG1 X1..5 Y-\n$$ @@ X\nG999 M888 Q\nG2 X1. Y1. R.1 F\n".encode()
    return text.encode("utf-16")


def main() -> None:
    folder, count = Path(sys.argv[1]), int(sys.argv[2])
    rng = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
    for control in CONTROLS:
        (folder / control).mkdir(parents=True, exist_ok=True)
    (folder / "mitsubishi" / "chordal.toml").write_text('machine = "mitsubishi-m700"\n')
    (folder / "fanuc" / "chordal.toml").write_text('machine = "fanuc-30i"\n')
    (folder / "README.txt").write_text("Programs of the shop, by control.\n")
    endings = ["nc", "tap", "cnc", "eia", "min", "txt", ""]
    done = 0
    while done < count:
        control = CONTROLS[done % 5]
        number = 1 + done % 9000
        sub = folder / control / f"{done // 2000:03d}"
        sub.mkdir(exist_ok=True)
        ending = rng.choice(endings)
        path = sub / (f"P{done:06d}.{ending}" if ending else f"P{done:06d}")
        fate = rng.random()
        if fate < 0.05:
            path.write_bytes(broken(rng, control, number))
        elif fate < 0.07 and control in ("haas", "fanuc", "mitsubishi"):
            parts = [program(rng, control, number + i, 30).strip("%\n") for i in range(rng.randint(2, 8))]
            path.write_text("%\n" + "\n".join(parts) + "\n%\n")
            done += len(parts) - 1
        else:
            path.write_text(program(rng, control, number, size(rng)))
        done += 1


main()
