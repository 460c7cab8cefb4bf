#!/usr/bin/env python3
"""Random programs for LinuxCNC, run by its own interpreter, rs274, and by Chordal.

Needs `rs274` (Debian package linuxcnc-uspace) and a built `chordal`; it is not part of the test command. The programs
have comments in every place, motion codes that stay in force, probe moves, signs in any count, expressions, canned
cycles and offsets under rotation; some blocks are wrong on purpose. The motions must be the same, and where rs274
refuses a block Chordal reports an error and has made the same motions before it. Programs that Chordal says it does not
follow (helices of G18 and G19 under rotation) are counted apart.

    tools/mixed_rs274.py [--chordal target/release/chordal] [--seed 1] [--count 100] [--keep FOLDER]
"""

import argparse
import json
import pathlib
import random
import subprocess
import sys
import tempfile

import compare_rs274
from compare_rs274 import Failed, differences, ours, reference


class Program:
    """Random blocks, and what is in force so that most of them are right."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.wrong_share = 0.05 if self.random.random() < 0.5 else 0.0
        self.motion = "G0"

    def number(self, low=-20.0, high=20.0):
        """A number in one of the forms that the language has."""
        value, pick = round(self.random.uniform(low, high), self.random.choice([0, 1, 3])), self.random.random()
        # No move of nothing, which printed digits make one of.
        value = value or 1.0
        text = f"{value:g}"
        if pick < 0.6:
            return text
        if pick < 0.68:
            return f"[{text}]"
        if pick < 0.76:
            return f"--{text}" if not text.startswith("-") else f"-+{text[1:]}"
        if pick < 0.84:
            return f"[{value + 2:g}-2]"
        if pick < 0.9:
            return f"-[{-value:g}]"
        if pick < 0.95:
            return f"--[{text}]"
        return f"+{text}" if not text.startswith("-") else text

    def comment(self):
        text = self.random.choice(["note", "G0 X99", "1/2-13 tap", "50 %", "a: b", "x=1", "", "#5", "; no"])
        return f"({text})"

    def dress(self, block):
        """The block with a number, blanks and comments in places."""
        if block[0] in "o#":
            # Comments stand behind statements only.
            return block + (" " + self.comment() if self.random.random() < 0.2 else "")
        words = block.split(" ")
        if self.random.random() < 0.3:
            words.insert(self.random.randrange(len(words) + 1), self.comment())
        if self.random.random() < 0.1:
            words.insert(0, self.comment())
        if self.random.random() < 0.1:
            words.append("; " + self.random.choice(["rest G0 X5", "(open", "", "x)"]))
        if self.random.random() < 0.2 and not words[0].startswith("("):
            words.insert(0, f"N{self.random.randrange(1, 999)}")
        glue = self.random.choice([" ", "", "  "])
        text = glue.join(words)
        return text.lower() if self.random.random() < 0.1 else text

    def axes(self, letters="XYZ", least=1):
        letters = self.random.sample(letters, self.random.randint(least, len(letters)))
        return " ".join(f"{letter}{self.number()}" for letter in sorted(letters))

    def code(self, motion):
        """The code, or nothing where it is in force."""
        if self.motion == motion and self.random.random() < 0.6:
            return ""
        self.motion = motion
        return motion + " "

    def line(self):
        return [self.code(self.random.choice(["G0", "G1"])) + self.axes("XYZ" if self.random.random() < 0.8 else "XYZA")]

    def circle(self):
        code = self.code(self.random.choice(["G2", "G3"]))
        centers = {17: "IJ", 18: "IK", 19: "JK"}[self.plane]
        center = " ".join(f"{letter}{self.number(1, 9)}" for letter in centers)
        turns = f" P{self.random.randint(1, 3)}" if self.random.random() < 0.2 else ""
        rise = f" {self.normal}{self.number()}" if self.random.random() < 0.3 and not self.incremental else ""
        return [f"{code}{center}{rise}{turns}"]

    def radius(self):
        code = self.code(self.random.choice(["G2", "G3"]))
        first, second = {17: "XY", 18: "ZX", 19: "YZ"}[self.plane]
        sign = self.random.choice(["", "-"])
        rows = [f"G1 {first}0 {second}0"] if not self.incremental else []
        if rows:
            self.motion, code = "G1", self.random.choice(["G2", "G3"]) + " "
            self.motion = code.strip()
        return rows + [f"{code}{first}{self.random.randint(-9, 9) or 4} {second}{self.random.randint(-9, 9)} R{sign}20"]

    def cycle(self):
        cycle = self.random.choice(["G81 ", "G82 P.1 ", "G83 Q1.5 ", "G73 Q1.5 ", "G85 ", "G89 P.1 "])
        if self.plane != 17 or self.incremental:
            return self.line()
        rows = [f"G0 Z{self.random.randint(8, 12)}", f"{self.random.choice(['G98', 'G99'])} {cycle}X1 Y2 Z-3 R2"]
        for _ in range(self.random.randint(0, 3)):
            rows.append(self.axes("XY") + (f" L{self.random.randint(1, 3)}" if self.random.random() < 0.2 else ""))
        self.motion = None
        rows.append(self.random.choice(["G80", "G80", "G0 Z20", "G1 Z20"]))
        self.motion = {"G80": None}.get(rows[-1], rows[-1][:2])
        return rows

    def mode(self):
        pick = self.random.random()
        if pick < 0.05:
            # The stand-alone rs274 does not convert the tool offset in force.
            return ["G49", self.random.choice(["G20 F10", "G21 F200"])]
        if pick < 0.2:
            self.plane = self.random.choice([17, 18, 19])
            self.normal = {17: "Z", 18: "Y", 19: "X"}[self.plane]
            return [f"G{self.plane}"]
        if pick < 0.4:
            self.incremental = not self.incremental
            return [f"G{91 if self.incremental else 90}"]
        if pick < 0.5:
            return [self.random.choice(["G94 F120", "G61", "G64 P.1", "F150", "S800", "M3 S500", "M8", "M9"])]
        return [self.random.choice([
            f"G10 L2 P{self.random.randint(1, 3)} X{self.number()} Y{self.number()}",
            f"G10 L2 P1 R{self.random.choice([0, 30, 45, 90, -17.5])}",
            f"G10 L2 P2 R{self.random.choice([0, 60, 180])} X{self.number()}",
            "G54", "G55", "G56", f"G92 {self.axes('XYZ')}", f"G52 {self.axes('XY')}", "G92.1", "G92.2", "G92.3", "G18", "G17",
            f"G43.1 Z{self.number()}", f"G43.1 X{self.number(0, 3)}", "G49", "G43 H3",
            "G55" if self.incremental else f"G53 G0 {self.axes('XYZ')}", "G28.1", f"G28 Z{self.number()}", "G4 P.2",
        ])]

    def flow(self):
        number = self.random.randrange(100, 999)
        inner = self.line()
        return self.random.choice([
            [f"#{number % 30 + 1}={self.number()}", f"G1 X#{number % 30 + 1}"],
            [f"o{number} if [{self.number()} gt 0]", *inner, f"o{number} endif"],
            [f"o{number} repeat [2]", f"G1 X{self.number()}", f"o{number} endrepeat"],
            [f"#<_mine>={self.number()}", "G1 Y#<_mine> Z[#<_mine>/2]", "X--#<_mine>"],
        ])

    def wrong(self):
        """A block that rs274 refuses, or not: it says which."""
        return [self.random.choice([
            "X1 X2", "G3 X5", "G80 X1", "(a (b) c) X2", "(open", "G1 X", "G5.9 X1", "G33 Z1", "G0 G1 X1", "#1.5=2",
            "X#1.5", "G2 X1 R.01", "G81 X1 Z-1", "Y[1", "G1 X1 Q", "M3 M4", "T-1", "G10 L2 P77", "N-1 X1", "G4", "^5",
            "X--", "Y[2/0]", "G17 G18", "G43.2", "G38.2 X50 F0", "G92", "G28.5", "X1e3", "G1X5G", "/ X3", "G0 (c) X3",
            "X (c) 4", "%", "G1 F0 X7", "G76 X1", "Z1.2.3", "G#<_motion>", "S-5", "F-1", "G94", "G95", "(note) o77 if [1]", "o78 (note) if [1]", "G90 G91", "G2 I1 K1 X2",
        ])]

    def text(self):
        self.plane, self.normal, self.incremental, self.motion = 17, "Z", False, "G1"
        rows = ["G21 G17 G90 G94 G40 G49 G80", "F200 S1000 M3", "G1 X1 Y1 Z1"]
        for _ in range(self.random.randint(10, 40)):
            pick = self.random.random()
            if pick < self.wrong_share:
                block = self.wrong()
            elif pick < 0.45:
                block = self.line() if self.motion else ["G0 X0"]
                self.motion = self.motion or "G0"
            elif pick < 0.6:
                block = self.circle()
            elif pick < 0.68:
                block = self.radius()
            elif pick < 0.76:
                block = self.cycle()
            elif pick < 0.92:
                block = self.mode()
            else:
                block = self.flow()
                self.motion = "G1"
            rows += block
        if self.random.random() < 0.15:
            rows += [f"G38.{self.random.randint(2, 5)} X60 F50", "Y70", "M2"]
        return "\n".join([*(self.dress(row) for row in rows), "M2"]) + "\n"


def probes(chordal, program):
    """How many probe moves each of the two makes, and whether both end."""
    with tempfile.TemporaryDirectory() as folder:
        table = pathlib.Path(folder, "tool.tbl")
        table.write_text("T1 P1 Z0 D0\nT2 P2 Z0 D0\nT3 P3 Z2 D4\n")
        command = ["rs274", "-g", "-t", str(table), "-v", str(pathlib.Path(folder, "rs274.var")), str(program)]
        theirs = subprocess.run(command, capture_output=True, text=True).stdout.count("STRAIGHT_PROBE")
    command = [chordal, "commands", str(program), "--machine", "linuxcnc-mill", "--format", "jsonl"]
    rows = subprocess.run(command, capture_output=True, text=True).stdout.splitlines()
    return theirs, sum(json.loads(row).get("kind") == "probed" for row in rows)


# rs274 knows no travel and no largest speed.
LIMITS = [f'axes.{axis}.travel=["-90 m", "90 m"]' for axis in "XYZ"]
LIMITS += [f'axes.{axis}.max_velocity="9000 m/min"' for axis in "XYZ"]


def is_not_followed(chordal, program):
    """Chordal says that it does not follow something (CH312)."""
    command = [chordal, "check", str(program), "--machine", "linuxcnc-mill"]
    return "CH312" in subprocess.run(command, capture_output=True, text=True).stdout


def judge(chordal, program):
    """What differs, and whether rs274 refuses the program."""
    try:
        theirs, _ = reference(program)
        message = None
    except Failed as failure:
        theirs, message = failure.motions, str(failure) or "refused"
    mine, _, has_errors = ours(chordal, program, given=LIMITS)
    problems = []
    if message and not has_errors:
        problems.append(f"rs274 refuses it ({message.splitlines()[-1]}), Chordal does not")
    if message:
        mine = mine[: len(theirs)]
    problems += list(differences(program, theirs, mine))
    if not message and has_errors:
        problems.append("Chordal reports an error, rs274 does not")
    if "G38." in program.read_text().upper() and not message:
        counts = probes(chordal, program)
        if counts[0] != counts[1]:
            problems.append(f"{counts[0]} probe moves in rs274, {counts[1]} in Chordal")
    return problems, bool(message), len(theirs)


def main():
    here = pathlib.Path(__file__).resolve().parent.parent
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--chordal", default=str(here / "target/release/chordal"))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--keep", type=pathlib.Path, help="a folder for the programs that differ")
    arguments = parser.parse_args()
    # Sums of rounded places under rotation differ in the last digit that rs274 prints.
    compare_rs274.TOLERANCE = 2.1e-4
    wrong = refused = steps = left_out = 0
    with tempfile.TemporaryDirectory() as folder:
        for number in range(arguments.count):
            seed = arguments.seed * 100_000 + number
            program = pathlib.Path(folder, f"{seed}.ngc")
            program.write_text(Program(seed).text())
            problems, is_refused, made = judge(arguments.chordal, program)
            if problems and is_not_followed(arguments.chordal, program):
                left_out += 1
                continue
            refused += is_refused
            steps += made
            wrong += bool(problems)
            if problems:
                print(f"{program.name}: {problems[0]}")
                if arguments.keep:
                    arguments.keep.mkdir(parents=True, exist_ok=True)
                    (arguments.keep / program.name).write_text(program.read_text())
    print(f"{arguments.count} programs, {refused} refused by rs274, {left_out} said not to be followed, {wrong} differ, {steps} steps")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
