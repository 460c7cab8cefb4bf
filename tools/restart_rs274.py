#!/usr/bin/env python3
"""Restarts of random LinuxCNC programs, held against LinuxCNC's own interpreter, rs274.

Needs `rs274` (Debian package linuxcnc-uspace) and a built `chordal`; it is not part of the test
command. Every line of each program is begun at with `chordal restart`. Where that is proved, rs274
runs the old program and the new one. At the line both print what the interpreter keeps (its
parameters: modes, spindle, coolant, offsets and their tables, positions), which must be the same word
for word, and so must all calls that come after it. What `restart` names as not repeated (M50 to M53)
may differ.

    tools/restart_rs274.py [--chordal target/release/chordal] [--seed 1] [--count 20]
"""

import argparse
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile

# What is named where it is not repeated: the parameters that these codes set.
NAMED = {
    "_speed_override": ("M50", "M51", "M48", "M49"),
    "_feed_override": ("M50", "M51", "M48", "M49"),
    "_adaptive_feed": ("M52",),
    "_feed_hold": ("M53",),
}
STATE = (
    "_spindle_on _spindle_cw _rpm _mist _flood _feed _metric _plane _ccomp _incremental _inverse_time "
    "_units_per_minute _units_per_rev _coord_system _tool_offset _retract_r_plane _ijk_absolute_mode "
    "_speed_override _feed_override _adaptive_feed _feed_hold _current_tool _x _y _z"
).split()
NUMBERED = [5401, 5402, 5403, 5210, 5211, 5212, 5213, 5220]
NUMBERED += [number + 20 * system for system in range(9) for number in (5221, 5222, 5223)]
# Another one before the program goes to its first place, or takes its tool.
OF_APPROACH = ("_x", "_y", "_z", "_current_tool", "_tool_offset", "5401", "5402", "5403", "_spindle_on", "_spindle_cw")
MARK = "STATE"
CALL = re.compile(r"^\s*\d+\s+N\S+\s+(.*)$")


def dump():
    """Lines that print the state; a comment holds a few parameters at a time."""
    names = [f"#<{name}>" for name in STATE] + [f"#{number}" for number in NUMBERED]
    return [f"(debug, {MARK} {' '.join(names[at:at + 6])})" for at in range(0, len(names), 6)]


class Program:
    """Random blocks that change what the control keeps, each with a move after it."""

    def __init__(self, seed):
        self.random = random.Random(seed)

    def number(self, low=1, high=40):
        return f"{self.random.uniform(low, high):.2f}"

    def block(self):
        number, pick = self.number, self.random.choice
        return pick([
            "M8", "M7", "M9", "M5", "S1200 M3", "S800 M4", f"S{self.random.randint(500, 3000)}",
            "G55", "G54", "G56", "G59.1", "G61", "G64", f"G64 P{number(0.01, 0.2)}", "M48", "M49", "M50 P0", "M51 P0",
            "M52 P1", "M53 P0", "M62 P1", "M64 P2", "M68 E0 Q3", "G91", "G90", "G94", "G90.1", "G91.1",
            f"G10 L2 P{self.random.randint(1, 6)} X{number()} Z{number()}", f"G10 L1 P3 Z{number()}", "G98", "G99",
            f"G43.1 Z{number()}", f"G43 H{self.random.randint(1, 3)}", f"G43.2 H{self.random.randint(1, 3)}", "G49",
            f"T{self.random.randint(1, 3)}", f"T{self.random.randint(1, 3)} M6", f"F{number(50, 500)}", "M0", "M1",
            f"G4 P{number(0.1, 2)}", "G18", "G17", "G19", "G20", "G21", f"G92 X{number()}", "G92.1", f"G52 X{number()}",
        ])

    def move(self):
        return self.random.choice([
            f"G1 X{self.number()} Y{self.number()} Z{self.number()}", f"G0 X{self.number()} Y{self.number()} Z{self.number()}",
            f"X{self.number()}", f"G1 Y{self.number()} F{self.number(50, 500)}",
        ])

    def lines(self):
        lines = ["G21 G17 G90 G40 G49 G80 G94", "G54", "T1 M6", "S1000 M3", "G0 X0 Y0 Z30", "F200"]
        for _ in range(self.random.randint(8, 14)):
            lines += [self.block(), self.move()]
        return lines + ["G90", "G0 Z50", "M2"]


def run(lines):
    """The calls of rs274 before the state and after it, and the state; nothing where it refuses the program."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "tool.tbl").write_text("T1 P1 Z1 D0.1\nT2 P2 Z2 D0.2\nT3 P3 Z3 D0.3\n")
        program = folder / "program.ngc"
        program.write_text("\n".join(lines) + "\n")
        command = ["rs274", "-g", "-t", str(folder / "tool.tbl"), "-v", str(folder / "rs274.var"), str(program)]
        done = subprocess.run(command, capture_output=True, text=True)
    calls = [match.group(1) for match in map(CALL.match, done.stdout.splitlines()) if match]
    marks = [at for at, call in enumerate(calls) if MARK in call]
    if not marks or not any(call.startswith("PROGRAM_END") for call in calls):
        return None
    state = " ".join(calls[at].split(MARK, 1)[1].rstrip(')"') for at in marks).split()
    return state, calls[marks[-1] + 1:]


def named(answer):
    return [code["words"] for code in answer.get("not_repeated", [])]


def differences(old, new, left_out, approaches):
    names = STATE + [str(number) for number in NUMBERED]
    for name, a, b in zip(names, old[0], new[0]):
        if approaches and name in OF_APPROACH:
            continue
        codes = NAMED.get(name, ())
        if a != b and not any(words.startswith(codes) for words in left_out if codes):
            yield f"{name}: {a} in the whole program, {b} in the one that begins there"
    if old[1] != new[1]:
        at = next((at for at, (a, b) in enumerate(zip(old[1], new[1])) if a != b), 0)
        yield f"after it: {old[1][at:at + 1]} and {new[1][at:at + 1]}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--chordal", default="target/release/chordal")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=20)
    args = parser.parse_args()
    proved = refused = not_run = wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        path, out = pathlib.Path(folder, "part.ngc"), pathlib.Path(folder, "new.ngc")
        tools = [f"tools.{number}.length={number} in" for number in (1, 2, 3)]
        tools = [f"--set={tool.split('=')[0]}=\"{tool.split('=')[1]}\"" for tool in tools]
        for seed in range(args.seed, args.seed + args.count):
            lines = Program(seed).lines()
            path.write_text("\n".join(lines) + "\n")
            for line in range(2, len(lines) + 1):
                command = [args.chordal, "restart", str(path), "--line", str(line), "-m", "linuxcnc-mill", *tools]
                done = subprocess.run([*command, "-o", str(out), "--format", "json"], capture_output=True, text=True)
                if done.returncode != 0:
                    refused += 1
                    continue
                begun, tail = out.read_text().splitlines(), lines[line - 1:]
                head = begun[:len(begun) - len(tail)]
                old = run(lines[:line - 1] + dump() + tail)
                new = run(head + dump() + tail)
                if old is None or new is None:
                    not_run += 1
                    wrong += old is not None
                    if old is not None:
                        print(f"seed {seed}, line {line}: rs274 refuses the new program\n  " + "\n  ".join(head))
                    continue
                proved += 1
                answer = json.loads(done.stdout)
                found = list(differences(old, new, named(answer), answer["goes_to_first_place_itself"]))
                wrong += bool(found)
                for text in found[:4]:
                    print(f"seed {seed}, line {line} `{lines[line - 1]}`: {text}")
                if found:
                    print("  " + " | ".join(lines[:line - 1]) + "\n  head: " + " | ".join(head))
    print(f"{args.count} programs: {proved} lines compared, {refused} refused, {not_run} that rs274 does not run; {wrong} differ")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
