#!/usr/bin/env python3
"""Conversions of random programs to LinuxCNC, held against LinuxCNC's own interpreter, rs274.

Needs `rs274` (Debian package linuxcnc-uspace) and a built `chordal`; it is not part of the test command. Programs for
the mills of the other controls are written, and converted with `chordal convert`. Where the conversion is proved, rs274
runs the new program, and its motions must be those that Chordal makes of the old one, as tools/compare_rs274.py
compares them. The same seed writes the same programs.

    tools/convert_rs274.py [--chordal target/release/chordal] [--seed 1] [--count 100] [MACHINE...]
"""

import argparse
import pathlib
import random
import subprocess
import sys
import tempfile

import compare_rs274
from compare_rs274 import Failed, differences, ours, reference

# Conversions write three decimals where a number is not exact.
compare_rs274.TOLERANCE = 1.1e-3
MACHINES = ("fanuc-30i", "haas-vf2", "mitsubishi-m700")
TOOLS = [f"tools.{tool}.{key}" for tool, length in ((1, 0), (2, 0)) for key in (f"length={length} in", "diameter=0 in")]


class Program:
    """Random blocks in the language that Fanuc, Haas and Mitsubishi share."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.labels = 10

    def number(self, low=-30, high=30, digits=2):
        return f"{self.random.uniform(low, high):.{digits}f}"

    def axes(self, letters="XYZ"):
        chosen = sorted(self.random.sample(letters, self.random.randint(1, len(letters))))
        return " ".join(f"{letter}{self.number()}" for letter in chosen)

    def straight(self):
        return [f"{self.random.choice(['G0', 'G1'])} {self.axes()}"]

    def incremental(self):
        return [f"G91 {self.random.choice(['G0', 'G1'])} {self.axes()}", "G90"]

    def half_circle(self):
        plane, a, b, i, j, normal = self.random.choice(
            [("G17", "X", "Y", "I", "J", "Z"), ("G18", "X", "Z", "I", "K", "Y"), ("G19", "Y", "Z", "J", "K", "X")]
        )
        u, v = self.random.randint(1, 9), self.random.randint(-9, 9)
        rise = f" {normal}{self.random.randint(1, 5)}." if self.random.random() < 0.4 else ""
        code = self.random.choice(["G2", "G3"])
        return [f"{plane} G91 {code} {a}{2 * u}. {b}{2 * v}.{rise} {i}{u}. {j}{v}.", "G17 G90 G1"]

    def by_radius(self):
        code = self.random.choice(["G2", "G3"])
        sign = self.random.choice(["", "-"])
        return [f"G91 {code} X{self.number(2, 9)} Y{self.number(2, 9)} R{sign}{self.number(15, 30)}", "G90 G1"]

    def full_circle(self):
        return [f"{self.random.choice(['G2', 'G3'])} I{self.number(1, 9)} J{self.number(-9, 9)}", "G1"]

    def holes(self):
        cycle = self.random.choice(["G81", "G82 P500", "G83 Q1.5", "G73 Q1.5", "G85", "G89 P300"])
        back = self.random.choice(["G98", "G99"])
        lines = ["G0 Z30.", f"{back} {cycle} X{self.number()} Y{self.number()} Z{self.number(-9, -2)} R{self.number(1, 5)}"]
        lines += [f"X{self.number()}" for _ in range(self.random.randint(0, 3))]
        if self.random.random() < 0.3:
            lines.append("G91 X5. Y2.")
            lines.append("G90")
        return lines + ["G80", "G0 Z30."]

    def other_offset(self):
        return [f"G{self.random.choice([54, 55, 56])}", f"G0 X{self.number()} Y{self.number()} Z{self.number(5, 30)}"]

    def shifted(self):
        return [f"G52 X{self.number()} Y{self.number()}", *self.straight(), *self.half_circle(), "G52 X0 Y0", *self.places()]

    def places(self):
        return [f"G0 X{self.number()} Y{self.number()} Z{self.number(5, 30)}"]

    def called(self):
        times = self.random.randint(1, 3)
        return [f"M98 P{self.random.choice([2000, 2001])} L{times}"]

    def looped(self):
        return [
            "#100=0", f"WHILE[#100LT{self.random.randint(1, 4)}]DO1", f"G1 X[#100*2.5+{self.number(0, 9)}] Y[#100*#100]",
            "#100=#100+1", "END1",
        ]

    def branched(self):
        self.labels += 10
        value = self.random.randint(0, 2)
        return [f"#101={value}", f"IF[#101EQ1]GOTO{self.labels}", *self.straight(), f"N{self.labels} {self.straight()[0]}"]

    def deletable(self):
        return [f"/{self.random.choice(['G1 X5.', 'M8', 'G0 Z20.'])}", *self.places()]

    def waits(self):
        return [self.random.choice(["G4 P500", "M8", "M9", "S1500", "G4 X0.5", "M5", "S900 M3"])]

    def text(self):
        parts = [
            self.straight, self.incremental, self.half_circle, self.by_radius, self.full_circle, self.holes,
            self.other_offset, self.shifted, self.called, self.looped, self.branched, self.deletable, self.waits,
        ]
        lines = ["%", "O1", "G21 G17 G40 G49 G80 G90 G94", "G54", "T1 M6", "S1000 M3", "G0 X0 Y0", "G43 H1 Z30.", "G1 F200."]
        for _ in range(self.random.randint(4, 9)):
            lines += self.random.choice(parts)()
        lines += ["G0 Z30.", "M30"]
        # What nothing calls would be a program of its own.
        if any("P2000" in line for line in lines):
            lines += ["O2000", "G91 G1 X2. Y1.", "G2 X4. I2.", "G90", "M99"]
        if any("P2001" in line for line in lines):
            lines += ["O2001", f"G0 {self.axes()}", "M99"]
        return "\n".join([*lines, "%"]) + "\n"


# Both machines have the offsets that rs274 begins with.
OFFSETS = [f"work_offsets.G{54 + n}.{axis}=0 mm" for n in range(3) for axis in "XYZ"]


def main():
    here = pathlib.Path(__file__).resolve().parent.parent
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--chordal", default=str(here / "target/release/chordal"))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("machines", nargs="*", default=MACHINES)
    arguments = parser.parse_args()
    proved = wrong = steps = 0
    with tempfile.TemporaryDirectory() as folder:
        old, new = pathlib.Path(folder, "old.nc"), pathlib.Path(folder, "new.ngc")
        for machine in arguments.machines:
            for seed in range(arguments.seed, arguments.seed + arguments.count):
                old.write_text(Program(seed).text())
                new.unlink(missing_ok=True)
                words = [word for assignment in OFFSETS + TOOLS for word in ("--set", assignment)]
                command = [arguments.chordal, "convert", str(old), "--machine", machine, "--to", "linuxcnc-mill", "--exact-cycles", *words]
                done = subprocess.run([*command, "-o", str(new)], capture_output=True, text=True)
                if done.returncode != 0 or not new.exists():
                    continue
                proved += 1
                try:
                    theirs, _ = reference(new)
                    mine, _, _ = ours(arguments.chordal, old, machine=machine, given=OFFSETS)
                except Failed as failure:
                    problems = [str(failure)]
                else:
                    steps += len(theirs)
                    problems = list(differences(new, theirs, mine))
                if problems:
                    wrong += 1
                    print(f"DIFFERS {machine} seed {seed}")
                    for problem in problems[:4]:
                        print("        ", problem)
    print(f"{proved} proved of {arguments.count * len(arguments.machines)}: {proved - wrong} passed, {wrong} failed, {steps} steps")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
