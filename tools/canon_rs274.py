#!/usr/bin/env python3
"""Canonical text of random programs, held against that of LinuxCNC's own interpreter, rs274.

Needs `rs274` (Debian package linuxcnc-uspace) and a built `chordal`; it is not part of the test command. The programs turn
work coordinate systems (G10 L2 R), shift them (G92, G52), and move in all planes. `chordal commands -o x.canon` must have the
same calls as rs274 in the same order, with the same numbers to 1e-4: moves, arcs, planes, offsets, presets and turns.

    tools/canon_rs274.py [--chordal target/release/chordal] [--seed 1] [--count 200]
"""

import argparse
import pathlib
import random
import re
import subprocess
import sys
import tempfile

MOVES = ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED", "ARC_FEED")
FRAMES = ("SET_G5X_OFFSET", "SET_G92_OFFSET", "SET_XY_ROTATION")
CALL = re.compile(r"^\s*(?:\d+\s+)?N\S+\s+(\w+)\(([^)]*)\)")
TOLERANCE = 2.5e-4


def program(seed):
    """Random blocks; every position is named after a change of the coordinates."""
    chance = random.Random(seed)

    def number(low=-30, high=30):
        return f"{chance.uniform(low, high):.2f}"

    def axes(letters="XYZ"):
        return " ".join(f"{letter}{number()}" for letter in letters)

    def arc():
        plane, a, b, i, j, normal = chance.choice(
            [("G17", "X", "Y", "I", "J", "Z"), ("G18", "X", "Z", "I", "K", "Y"), ("G19", "Y", "Z", "J", "K", "X")]
        )
        u, v = chance.randint(1, 9), chance.randint(-9, 9)
        rise = f" {normal}{number()}" if plane == "G17" and chance.random() < 0.4 else ""
        end = f"{a}{2 * u} {b}{2 * v} " if chance.random() < 0.8 else ""
        return [f"{plane} G91 {chance.choice(['G2', 'G3'])} {end}{i}{u} {j}{v}{rise}", "G90"]

    def frame():
        system = chance.choice([1, 2, 3])
        return chance.choice(
            [
                [f"G10 L2 P{system} R{chance.choice([30, -45, 90, 180, 270, 12.5, 0])}"],
                [f"G10 L2 P{system} X{number()} Y{number()} Z{number()} R{number()}"],
                [f"G92 X{number()} Y{number()}"],
                [f"G52 X{number()} Z{number()}"],
                ["G92.1"],
                [f"G{53 + system}"],
            ]
        ) + [f"G0 {axes()}"]

    lines = ["G21 G90 G17 G40 F300", f"G0 {axes()}"]
    for _ in range(chance.randint(5, 14)):
        lines += chance.choice([lambda: [f"{chance.choice(['G0', 'G1'])} {axes()}"], arc, arc, frame, frame])()
    return "\n".join([*lines, "M2", ""])


def calls(text, start):
    """Moves, and each part of the frame where it changes; the plane of an arc is part of it."""
    plane, frame, found = "XY", dict(start), []
    for row in text.splitlines():
        call = CALL.match(row)
        if not call:
            continue
        name, rest = call.groups()
        if name == "SELECT_PLANE":
            plane = rest.rsplit("_", 1)[1]
            continue
        if name == "PROGRAM_END":
            break
        if name not in MOVES + FRAMES:
            continue
        values = [float(part) for part in rest.split(",")]
        if name in FRAMES:
            frame[name] = values
            continue
        found.append((name, plane if name == "ARC_FEED" else "", values, {key: tuple(value) for key, value in frame.items()}))
    return found


def near(one, other):
    return len(one) == len(other) and all(abs(a - b) <= TOLERANCE for a, b in zip(one, other))


def main():
    here = pathlib.Path(__file__).resolve().parent.parent
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--chordal", default=str(here / "target/release/chordal"))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=200)
    arguments = parser.parse_args()
    start = {"SET_G5X_OFFSET": [1, *[0.0] * 6], "SET_G92_OFFSET": [0.0] * 6, "SET_XY_ROTATION": [0.0]}
    wrong = moves = 0
    for seed in range(arguments.seed, arguments.seed + arguments.count):
        with tempfile.TemporaryDirectory() as folder:
            path, canon = pathlib.Path(folder, "p.ngc"), pathlib.Path(folder, "p.canon")
            path.write_text(program(seed))
            tools = pathlib.Path(folder, "tool.tbl")
            tools.write_text("T1 P1 Z0 D0\n")
            rs274 = ["rs274", "-g", "-t", str(tools), "-v", str(pathlib.Path(folder, "rs274.var")), str(path)]
            theirs = calls(subprocess.run(rs274, capture_output=True, text=True).stdout, start)
            command = [arguments.chordal, "commands", str(path), "--machine", "linuxcnc-mill", "-o", str(canon)]
            subprocess.run(command, capture_output=True, text=True)
            mine = calls(canon.read_text(), start)
        moves += len(theirs)
        for their, my in zip(theirs, mine):
            frames = all(near(their[3][key], my[3][key]) for key in FRAMES)
            if their[:2] != my[:2] or not near(their[2], my[2]) or not frames:
                wrong += 1
                print(f"seed {seed}:\n  rs274   {their}\n  chordal {my}")
                break
        else:
            if len(theirs) != len(mine):
                wrong += 1
                print(f"seed {seed}: {len(theirs)} moves in rs274, {len(mine)} in Chordal")
    print(f"{arguments.count} programs, {moves} moves, {wrong} programs differ")
    return 1 if wrong or not moves else 0


if __name__ == "__main__":
    sys.exit(main())
