#!/usr/bin/env python3
"""Lathe programs of every feature that LinuxCNC has, run by Chordal and by LinuxCNC's own interpreter, rs274.

The programs are made from a list: every cycle on both sides of the axis, outside and in bores, in inch and
millimetres, with diameters and radii. They are compared as tools/compare_rs274.py does.

    tools/turning_rs274.py [--chordal target/release/chordal] [--keep FOLDER]
"""

import argparse
import itertools
import math
import pathlib
import random
import sys
import tempfile

from compare_rs274 import TOOL_PATH, Failed, differences, ours, reference

# Contours outside: (X on the radius, Z) of a blank of radius 30, with arcs as (code, X, Z, I, K); the first is the
# move to the contour. The pockets need G71.
STEPS = [("G0", 10, 2), ("G1", 10, -10), ("G1", 20, -17.5), ("G1", 20, -30), ("G1", 30, -30)]
ARCS = [
    ("G0", 8, 2),
    ("G1", 8, -5),
    ("G3", 12, -9, 0, -4),
    ("G1", 12, -16),
    ("G2", 18, -22, 6, 0),
    ("G1", 24, -26),
    ("G1", 30, -26),
]
POCKET = [
    ("G0", 22, 2),
    ("G1", 22, -8),
    ("G1", 15, -13),
    ("G1", 15, -20),
    ("G1", 21, -25),
    ("G1", 21, -33),
    ("G1", 30, -33),
]
TWO_POCKETS = POCKET[:5] + [("G1", 25, -25), ("G1", 19, -30), ("G1", 26, -34), ("G1", 30, -34)]
ROUND_POCKET = [
    ("G0", 22, 2),
    ("G1", 22, -8),
    ("G2", 22, -24, 6, -8),
    ("G1", 22, -30),
    ("G1", 30, -30),
]
BALL = [("G0", 0, 2), ("G1", 0, 0), ("G3", 12, -12, 0, -12), ("G1", 12, -20), ("G1", 30, -24)]
CONTOURS = {
    "steps": STEPS,
    "arcs": ARCS,
    "pocket": POCKET,
    "two pockets": TWO_POCKETS,
    "round pocket": ROUND_POCKET,
    "ball": BALL,
}
# For passes along X: from the chuck to the face.
FACES = {
    "face steps": [("G0", 32, -20), ("G1", 20, -20), ("G1", 12, -8), ("G1", 12, -3), ("G1", 4, -3), ("G1", 4, 2)],
    "face arcs": [("G0", 32, -20), ("G1", 24, -20), ("G3", 20, -16, 0, 4), ("G1", 14, -10), ("G1", 14, 2)],
}


class Frame:
    """How a program writes a point: unit, diameter or radius, side of the axis."""

    def __init__(self, inch, diameter, side):
        self.inch, self.diameter, self.side = inch, diameter, side

    def length(self, mm):
        return f"{mm / 25.4:.9f}" if self.inch else f"{mm:.5f}"

    def x(self, radius):
        return self.length(radius * self.side * (2 if self.diameter else 1))

    def head(self, *lines):
        units = "G20" if self.inch else "G21"
        mode = "G7" if self.diameter else "G8"
        return ["(lathe)", f"{units} {mode} G18 G40 G90 G94", f"F{self.length(200)}", "S500 M3", *lines]

    def at(self, code, radius, z, i=None, k=None):
        text = f"{self.turned(code)} X{self.x(radius)} Z{self.length(z)}"
        if i is not None:
            text += f" I{self.length(i * self.side)} K{self.length(k)}"
        return text

    def turned(self, code):
        """An arc on the other side of the axis turns the other way."""
        return {"G2": "G3", "G3": "G2"}.get(code, code) if self.side < 0 else code

    def sub(self, contour):
        return ["o100 sub", *[self.at(*move) for move in contour], "o100 endsub"]


def bored(contour):
    """The same inside: a blank with a hole of radius 2, the contour mirrored at radius 16."""
    swap = {"G2": "G3", "G3": "G2"}
    moves = []
    for code, x, z, *center in contour:
        center = [-center[0], center[1]] if center else []
        moves.append((swap.get(code, code), 32 - x, z, *center))
    return moves


FRAMES = [Frame(inch, diameter, side) for inch in (False, True) for diameter in (False, True) for side in (1, -1)]


def programs():
    """Names and lines."""
    turns = itertools.cycle(FRAMES)
    for name, contour in CONTOURS.items():
        for inside in (False, True):
            shape, start = (bored(contour), 2) if inside else (contour, 30)
            where = "bore" if inside else "outside"
            for words in ("I2.9 R.5", "I4.2 R1 D.4", "I2.3 R.3 D1"):
                frame = next(turns)
                cycle = scaled(frame, f"G71 Q100 {words}")
                yield f"G71 {name} {where} {words}", frame.head(
                    *frame.sub(shape), frame.at("G0", start, 2), cycle, frame.at("G0", start, 2), scaled(frame, "G70 Q100")
                )
            frame = next(turns)
            yield f"G70 {name} {where} from its end", frame.head(
                *frame.sub(shape), frame.at("G0", *shape[-1][1:3]), "G70 Q100"
            )
            frame = next(turns)
            yield f"G70 {name} {where}", frame.head(
                *frame.sub(shape), frame.at("G0", start, 3), scaled(frame, "G70 Q100 D1.2 E.3") + " P3"
            )
            for cycle in ("G71.1", "G71.2"):
                frame = next(turns)
                yield f"{cycle} {name} {where}", frame.head(
                    *frame.sub(shape), frame.at("G0", start, 2), scaled(frame, f"{cycle} Q100 I2.9 R.4")
                )
    for (name, contour), cycle, words in itertools.product(
        FACES.items(), ("G72", "G72.1", "G72.2"), ("I2.9 R.5", "I2.1 R1 D.4")
    ):
        frame = next(turns)
        yield f"{cycle} {name} {words}", frame.head(
            *frame.sub(contour), frame.at("G0", 32, 2), scaled(frame, f"{cycle} Q100 {words}")
        )
    for contour in CONTOURS, FACES:
        frame = next(turns)
        name, shape = next(iter(contour.items()))
        yield f"start of its own, {name}", frame.head(
            *frame.sub(shape),
            frame.at("G0", 40, 20),
            scaled(frame, "G71 Q100 I2.9 R.5") + f" X{frame.x(33)} Z{frame.length(3)}",
        )
    yield from threads(turns)
    yield from compensated(turns)
    yield from other(turns)
    yield from contour_words(turns, 120)


def contour_words(turns, count):
    """Random contours with increments (U, W), roundings (A) and chamfers (C); the same at every run."""
    chance = random.Random(43)
    for number in range(count):
        frame = next(turns)
        x, z = chance.randint(4, 10), 2.0
        lines = [f"G0 X{frame.x(x)}"]
        moves = chance.randint(2, 6)
        kinds = ["along"] + [chance.choice(["along", "out", "slant", "G2", "G3"]) for _ in range(moves)]
        steps = []
        for kind in kinds:
            way = {"along": (0, -6), "out": (4, 0), "slant": (3, -4)}.get(kind, (3, -3))
            dx, dz = (part * chance.uniform(0.8, 1.3) for part in way)
            dx, dz = (dx, -dx) if kind.startswith("G") else (dx, dz)
            # The directions at both ends: an arc by G3 begins outwards, one by G2 along the axis.
            ends = {"G3": [(1, 0), (0, -1)], "G2": [(0, -1), (1, 0)]}.get(kind, [(dx, dz)] * 2)
            steps.append((kind, dx, dz, ends))
        steps.append(("out", 3, 0, [(1, 0)] * 2))
        for (kind, dx, dz, ends), after in zip(steps, steps[1:]):
            x, z = x + dx, z + dz
            factor = frame.side * (2 if frame.diameter else 1)
            by_x, by_z = (chance.random() < 0.5 for _ in range(2))
            words = []
            if dx:
                words.append(f"U{frame.length(dx * factor)}" if by_x else f"X{frame.x(x)}")
            if dz:
                words.append(f"W{frame.length(dz)}" if by_z else f"Z{frame.length(z)}")
            code = frame.turned(kind) if kind.startswith("G") else "G1"
            if kind.startswith("G"):
                words.append(f"R{frame.length(dx)}")
            (u, v), (p, q) = ends[1], after[3][0]
            # rs274 stops with "Cannot intersect parallel lines" where the moves go on into one another.
            turns_off = abs(u * q - v * p) > 0.1 * math.hypot(u, v) * math.hypot(p, q)
            corner = chance.random()
            if corner < 0.6 and turns_off:
                words.append(f"{'A' if corner < 0.35 else 'C'}{frame.length(chance.uniform(0.2, 0.9))}")
            lines.append(f"{code} {' '.join(words)}")
        lines.append(f"G1 X{frame.x(x + 3)}")
        cycle = chance.choice(["G70 Q100", scaled(frame, "G71 Q100 I2.9 R.5"), scaled(frame, "G71 Q100 I1.7 R.4 D.3")])
        yield f"contour words {number} {cycle}", frame.head(
            "o100 sub", *lines, "o100 endsub", frame.at("G0", x + 3, 2), cycle
        )


def scaled(frame, text):
    """The lengths of a cycle in the unit of the program: D, E, I and R; Q and P are numbers."""
    parts = text.split()
    return " ".join(p[0] + frame.length(float(p[1:])) if p[0] in "DEIR" else p for p in parts)


def threads(turns):
    for inside, degression, angle, ends in itertools.product((False, True), (1, 1.7, 2), (0, 29.5), (0, 1, 2, 3)):
        frame = next(turns)
        factor = 2 if frame.diameter else 1
        crest, z = (1.5, -18) if inside else (-1, -22)
        lead, first, height, taper = (frame.length(v) for v in (1.5, 0.3 * factor, 0.92 * factor, 2))
        # The crest lies towards greater X inside and less X outside, whatever the side of the axis.
        line = (
            f"G76 P{lead} Z{frame.length(z)} I{frame.length(crest * factor)} J{first} K{height}"
            f" R{degression} Q{angle} H{ends % 3} E{taper} L{ends}"
        )
        yield f"G76 {'bore' if inside else 'outside'} R{degression} Q{angle} L{ends}", frame.head(
            frame.at("G0", 12, 4), line, frame.at("G0", 14, 5)
        )
    for towards in (1, -1):
        frame = next(turns)
        factor = 2 if frame.diameter else 1
        numbers = [frame.length(v) for v in (2, towards * 15, -factor, 0.5 * factor, 1.2 * factor)]
        yield f"G76 towards {towards}", frame.head(
            frame.at("G0", 12, 0), "G76 P{} Z{} I{} J{} K{}".format(*numbers)
        )
    for _ in range(4):
        frame = next(turns)
        yield "G33", frame.head(
            frame.at("G0", 10, 3),
            f"G33 Z{frame.length(-20)} K{frame.length(2)}",
            f"G33 X{frame.x(12)} Z{frame.length(-24)} K{frame.length(2)}",
            f"X{frame.x(14)} K{frame.length(1)}",
            frame.at("G0", 15, 3),
            f"G33.1 Z{frame.length(-10)} K{frame.length(1)}",
        )


def compensated(turns):
    """A contour with each tip, outside and inside."""
    for tip in range(10):
        for inside in (False, True):
            frame = next(turns)
            shape = [("G1", 10, 0), ("G1", 10, -10), ("G1", 14, -16), ("G2", 18, -20, 4, 0), ("G1", 25, -20)]
            shape = bored(shape) if inside else shape
            left = inside != (frame.side < 0)
            code = "G41" if left else "G42"
            start = (16, 6)
            if tip % 2 or tip == 0:
                begin = f"{code}.1 D{frame.length(0.8)} L{tip}"
            else:
                begin = f"M5\nT{tip} M6\nG43\nS500 M3\n{code}"
            yield f"{code} tip {tip}", frame.head(
                TOOL_PATH, frame.at("G0", *start), begin, *[frame.at(*move) for move in shape],
                "G40", frame.at("G0", 2 if inside else 40, 10),
            )


def other(turns):
    for _ in range(4):
        frame = next(turns)
        yield "arcs and modes", frame.head(
            frame.at("G0", 10, 0),
            frame.turned("G3") + f" X{frame.x(14)} Z{frame.length(-4)} R{frame.length(4)}",
            "G91",
            f"G1 X{frame.x(2)} Z{frame.length(-3)}",
            f"G2 X{frame.x(4)} Z{frame.length(-4)} R{frame.length(5)}",
            "G90 G8" if frame.diameter else "G90 G7",
            f"G1 X{frame.length(20)}",
            "G90.1",
            f"G2 X{frame.length(22)} Z{frame.length(-12)} R{frame.length(30)}",
            "G91.1",
        )
        frame = next(turns)
        yield "speeds", frame.head(
            f"G96 D2000 S{frame.length(150)}",
            "G95",
            f"F{frame.length(0.2)}",
            frame.at("G0", 20, 1),
            frame.at("G1", 20, -10),
            "G97 S800",
            frame.at("G1", 25, -15),
            "G94",
            f"F{frame.length(100)}",
            frame.at("G1", 30, -15),
        )
        frame = next(turns)
        yield "offsets", frame.head(
            frame.at("G0", 20, 5),
            f"G10 L2 P1 X{frame.x(3)} Z{frame.length(-40)}",
            frame.at("G1", 22, 4),
            f"G92 X{frame.x(50)} Z{frame.length(10)}",
            frame.at("G1", 48, 8),
            "G92.1",
            frame.at("G1", 21, 3),
            f"G10 L20 P1 X{frame.x(19)} Z{frame.length(1)}",
            frame.at("G1", 18, 0),
            f"G53 G0 X{frame.x(30)} Z{frame.length(30)}",
            f"G52 X{frame.x(1)}",
            frame.at("G1", 21, 5),
        )
        frame = next(turns)
        yield "holes", frame.head(
            "G17",
            frame.at("G0", 0, 5),
            f"G81 Z{frame.length(-10)} R{frame.length(2)}",
            f"G83 Z{frame.length(-20)} R{frame.length(2)} Q{frame.length(4)}",
            f"G73 Z{frame.length(-24)} R{frame.length(2)} Q{frame.length(5)}",
            f"G82 Z{frame.length(-12)} R{frame.length(2)} P.5",
            "G80",
            "G18",
            frame.at("G0", 10, 5),
        )


def main():
    here = pathlib.Path(__file__).resolve().parent.parent
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--chordal", default=str(here / "target/release/chordal"))
    parser.add_argument("--keep", type=pathlib.Path)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        folder = arguments.keep or pathlib.Path(folder)
        folder.mkdir(exist_ok=True)
        same = wrong = refused = strict = steps = 0
        for number, (name, lines) in enumerate(programs(), 1):
            path = folder / f"{number:03}.ngc"
            path.write_text("\n".join([*lines, "M2", ""]))
            text = "\n".join(lines)
            what = "path" if TOOL_PATH in text else "commands"
            try:
                theirs, _ = reference(path)
            except Failed as failure:
                lines_said = [row for row in failure.args[0].splitlines() if row != "executing"]
                said = next((row for row in lines_said if "rror" in row), "?")
                if name.startswith("contour words") and "G7X error" in said:
                    # Random contours that this interpreter does not take: nothing to compare.
                    strict += 1
                    print(f"{'strict':8}{'':10}  {number:03} {name}: {said}")
                    continue
                _, _, errors = ours(arguments.chordal, path, what)
                refused += errors
                wrong += not errors
                print(f"{'refused' if errors else 'DIFFERS':8}{'':10}  {number:03} {name}: {said}")
                continue
            mine, _, errors = ours(arguments.chordal, path, what)
            problems = list(differences(path, theirs, mine))
            if errors:
                problems.append("Chordal reports an error")
            steps += len(theirs)
            same += not problems
            wrong += bool(problems)
            print(f"{'DIFFERS' if problems else 'same':8}{len(theirs):4} steps  {number:03} {name}")
            for problem in problems[:4]:
                print("        ", problem)
        print(f"{same} the same, {refused} refused by both, {strict} random ones refused by rs274, {wrong} differ; {steps} steps")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
