#!/usr/bin/env python3
"""Compares Chordal's motions with those of LinuxCNC's own interpreter, rs274.

Needs `rs274` (Debian package linuxcnc-uspace) and a built `chordal`; it is not part of the test
command. Each program of tests/rs274 is run by both, and the motions must agree in kind, end point,
centre, direction and turns to 1e-4 of the program's unit (rs274 prints four decimals), and so must
the lines that the programs print. Between the motions the dwells and the changes of the spindle
must agree, up to the last motion. The motions are the programmed ones; with `(tool path)` in the
program those of the tool centre, after cutter compensation. They are compared up to the first probe.

rs274 prints places before the turn of a work coordinate system (G10 L2 R), and Chordal after it:
rs274's are turned first. Of a spline rs274 prints the count of its control points only; where it
ends is seen from what follows.

    tools/compare_rs274.py [--chordal target/release/chordal] [PROGRAM...]
"""

import argparse
import copy
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

TOLERANCE = 1.01e-4
AXES = "XYZABC"
PLANES = {"XY": (0, 1, 2), "XZ": (2, 0, 1), "YZ": (1, 2, 0)}
NAMES = {"xy": (0, 1, 2), "zx": (2, 0, 1), "yz": (1, 2, 0)}
SPINDLE = {
    "STOP_SPINDLE_TURNING": "off",
    "START_SPINDLE_CLOCKWISE": "cw",
    "START_SPINDLE_COUNTERCLOCKWISE": "ccw",
    "ORIENT_SPINDLE": "oriented",
}
# In a program whose tool path is compared, not its programmed one.
TOOL_PATH = "(tool path)"
# A program for the lathe; its tools 1 to 9 have a nose of 0.4 mm and the tip of their number.
LATHE = "(lathe)"
LATHE_TOOLS = [(number, 0.4 + 0.1 * number) for number in range(1, 10)]
CHANGES = {"SET_G5X_OFFSET": "work", "SET_G92_OFFSET": "preset", "USE_TOOL_LENGTH_OFFSET": "tool"}
CALL = re.compile(r"^\s*\d+\s+N\S+\s+(\w+)\((.*)\)")


class Frame:
    """What lies between a program and the machine, mm: presets, the turn about the zero of the work
    coordinate system, its place, the tool's offsets."""

    def __init__(self):
        self.preset, self.work, self.tool, self.degrees = [0.0] * 6, [0.0] * 6, [0.0] * 6, 0.0

    def sum(self):
        return [sum(axis) for axis in zip(self.preset, self.work, self.tool)]

    def place(self, place):
        """A place of the program in the work coordinate system."""
        return self.about(place, math.radians(self.degrees))

    def back(self, place):
        """A place of the work coordinate system in the program."""
        return self.about(place, -math.radians(self.degrees))

    def about(self, place, angle):
        if angle == 0:
            return list(place)
        (g, h), cos, sin = self.preset[:2], math.cos(angle), math.sin(angle)
        x, y = place[0] + g, place[1] + h
        return [cos * x - sin * y - g, sin * x + cos * y - h, *place[2:]]

    def changed(self, name, text, unit):
        """The frame after a change that rs274 prints, and whether it is one."""
        if name == "SET_XY_ROTATION":
            self.degrees = float(text)
        elif name in CHANGES:
            numbers = [float(part) for part in re.findall(r"-?\d+\.\d+", text)][:6]
            values = [value * unit if axis < 3 else value for axis, value in enumerate(numbers)]
            setattr(self, CHANGES[name], values)
        return name in CHANGES or name == "SET_XY_ROTATION"


class Failed(Exception):
    """A program that one of the two refuses, and the motions before that."""

    def __init__(self, message, motions=()):
        super().__init__(message)
        self.motions = list(motions)


def reference(program):
    """Motions of rs274 in mm and degrees: (kind, end, arc or None, scale of tolerance, start); printed lines."""
    with tempfile.TemporaryDirectory() as folder:
        tools = pathlib.Path(folder, "tool.tbl")
        rows = "T1 P1 Z0 D0\nT2 P2 Z0 D0\nT3 P3 Z2 D4\n"
        if LATHE in program.read_text():
            # In inches, as rs274 starts.
            numbers = [(number, diameter / 25.4) for number, diameter in LATHE_TOOLS]
            rows = "".join(f"T{n} P{n} X0 Z0 D{d:.9f} Q{n}\n" for n, d in numbers)
        tools.write_text(rows)
        command = ["rs274", "-g", "-t", str(tools), "-v", str(pathlib.Path(folder, "rs274.var"))]
        done = subprocess.run([*command, str(program)], capture_output=True, text=True)
    unit, plane, place, motions, printed = 1.0, "XY", [0.0] * 6, [], []
    spindle, turn = "off", Frame()
    machine, about = place, False
    for row in done.stdout.splitlines():
        if place and not about:
            machine = [w + s for w, s in zip(turn.place(place), turn.sum())]
        call = CALL.match(row)
        if not call:
            printed.append(row)
            continue
        name, text = call.groups()
        # A turned place is a sum of printed ones.
        scale = unit * (2 if turn.degrees else 1)
        if name == "USE_LENGTH_UNITS":
            unit = 25.4 if "INCH" in text else 1.0
        elif name == "SELECT_PLANE":
            plane = text.strip().rsplit("_", 1)[1]
        elif turn.changed(name, text, unit):
            if place:
                # Where the machine stands is now another place of the program, but for the digits printed.
                place = turn.back([m - s for m, s in zip(machine, turn.sum())])
                about = True
        elif name == "NURBS_FEED":
            points = text.split(",")[0]
            motions.append((f"spline of {points}", None, None, unit, None))
            place = None
        elif name in ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED"):
            numbers = [float(part) for part in text.split(",")]
            end = [value * unit if axis < 3 else value for axis, value in enumerate(numbers)]
            kind = "rapid" if name == "STRAIGHT_TRAVERSE" else "line"
            if place and about and not far(end, place, 4 * TOLERANCE * unit):
                place = end
            motions.append((kind, turn.place(end), None, scale, place and turn.place(place)))
            place, about = end, False
        elif name == "RIGID_TAP":
            end = [float(part) * unit for part in text.split(",")[:3]] + place[3:]
            place = turn.place(place)
            motions.append(("line", turn.place(end), None, scale, place))
            turning = {"cw": "ccw", "ccw": "cw"}.get(spindle, spindle)
            motions.append((f"spindle {turning}", [0.0] * 6, None, 1.0, None))
            motions.append(("line", place, None, scale, end))
            motions.append((f"spindle {spindle}", [0.0] * 6, None, 1.0, None))
        elif name == "STRAIGHT_PROBE":
            break
        elif name == "DWELL" and float(text) > 0:
            motions.append((f"dwell {float(text):g}", [0.0] * 6, None, 1.0, None))
        elif name in SPINDLE:
            spindle = SPINDLE[name]
            motions.append((f"spindle {spindle}", [0.0] * 6, None, 1.0, None))
        elif name == "ARC_FEED":
            first, second, center_a, center_b, turns, normal_end, *rotary = (
                float(part) for part in text.split(",")
            )
            a, b, normal = PLANES[plane]
            end = [0.0, 0.0, 0.0, *rotary]
            end[a], end[b], end[normal] = first * unit, second * unit, normal_end * unit
            arc = (plane, center_a * unit, center_b * unit, turns)
            kind = "arc"
            if turn.degrees and plane == "XY":
                arc = (plane, *turn.place(arc[1:3]), turns)
            elif turn.degrees % 180:
                kind, arc = "turned arc", (*arc, copy.copy(turn))
            elif turn.degrees % 360:
                # Upright again, and the other way round.
                a, b, normal = PLANES[plane]
                center = list(end)
                center[a], center[b] = arc[1:3]
                center = turn.place(center)
                arc = (plane, center[a], center[b], -turns)
            motions.append((kind, turn.place(end), arc, scale, place))
            place, about = end, False
    if done.returncode != 0 or not motions:
        raise Failed(done.stderr.strip(), changes(moving(motions)))
    printed = [row for row in printed if row != "executing" and "N....." not in row]
    return changes(moving(motions)), printed


def moving(motions):
    """Without the straight moves to where the tool stands."""
    return [m for m in motions if m[2] or m[4] is None or far(m[1], m[4], 1e-9)]


def ours(chordal, program, what="commands", machine=None, given=()):
    """Motions of Chordal in mm and degrees; printed lines; whether it reports errors. `given` are assignments."""
    lathe = LATHE in program.read_text()
    machine = machine or ("linuxcnc-lathe" if lathe else "linuxcnc-mill")
    command = [chordal, what, str(program), "--machine", machine, "--format", "jsonl"]
    for tool, diameter in LATHE_TOOLS if lathe else ():
        command += ["--set", f"tools.{tool}.offset.X=0 mm", "--set", f"tools.{tool}.offset.Z=0 mm"]
        command += ["--set", f"tools.{tool}.diameter={diameter} mm", "--set", f"tools.{tool}.tip={tool}"]
    for tool, length, diameter in () if lathe else ((1, 0, 0), (2, 0, 0), (3, 2, 4)):
        command += ["--set", f"tools.{tool}.length={length} in"]
        command += ["--set", f"tools.{tool}.diameter={diameter} in"]
    for assignment in given:
        command += ["--set", assignment]
    done = subprocess.run(command, capture_output=True, text=True)
    motions, printed, moved = [], [], False
    for row in done.stdout.splitlines():
        command = json.loads(row)
        kind = command.get("kind")
        if kind == "print":
            printed.append(command["text"])
        if kind == "dwell" and command["seconds"] > 0:
            motions.append((f"dwell {command['seconds']:g}", [0.0] * 6, None, command["line"]))
        if kind == "spindle":
            motions.append((f"spindle {command['state']}", [0.0] * 6, None, command["line"]))
        if kind == "probed":
            # The move of the probe; one that stands at its end is not a step.
            if moved:
                motions.pop()
            break
        if kind not in ("rapid", "line", "arc", "spiral", "spline"):
            continue
        end = [command["to"].get(axis, 0.0) for axis in AXES]
        start = [command["from"].get(axis, 0.0) for axis in AXES]
        # Positions of a lathe are written as diameters.
        half = 0.5 if lathe else 1.0
        end[0], start[0] = end[0] * half, start[0] * half
        arc = None
        if kind in ("arc", "spiral"):
            a, b, _ = NAMES[command["plane"]]
            center = dict(command["center"])
            if "X" in center:
                center["X"] *= half
            sign = 1 if command["direction"] == "ccw" else -1
            turns = sign * max(1, math.ceil(command["sweep_deg"] / 360 - 1e-6))
            plane = {"xy": "XY", "zx": "XZ", "yz": "YZ"}[command["plane"]]
            arc = (plane, center[AXES[a]], center[AXES[b]], turns)
            kind = "arc"
        if kind == "spline":
            kind, arc = f"spline of {len(command['weights'])}", command
        moved = arc or far(end, start, 1e-9)
        if moved:
            motions.append((kind, end, arc, command["line"]))
    if done.returncode not in (0, 1):
        raise Failed(done.stderr.strip())
    return changes(motions), printed, done.returncode == 1


def changes(steps):
    """The steps up to the last motion, without spindle words that change nothing."""
    while steps and steps[-1][0].startswith(("dwell", "spindle")):
        steps = steps[:-1]
    state, kept = "spindle off", []
    for step in steps:
        if step[0].startswith("spindle"):
            if step[0] == state:
                continue
            state = step[0]
        kept.append(step)
    return kept


def far(one, other, tolerance):
    return any(abs(a - b) > tolerance for a, b in zip(one, other))


def differences(program, theirs, mine):
    if len(theirs) != len(mine):
        yield f"{len(theirs)} steps in rs274, {len(mine)} in Chordal"
    for number, (their, my) in enumerate(zip(theirs, mine), 1):
        tolerance = TOLERANCE * their[3]
        where = f"step {number} (line {my[3]})"
        if their[0] == "turned arc":
            for problem in on_turned_arc(their, my, tolerance):
                yield f"{where}: {problem}"
        elif their[0] != my[0]:
            yield f"{where}: rs274 {their[0]}, Chordal {my[0]}"
        elif their[1] and far(their[1], my[1], tolerance):
            yield f"{where}: rs274 ends at {their[1]}, Chordal at {my[1]}"
        elif their[2]:
            (plane, a, b, turns), (my_plane, my_a, my_b, my_turns) = their[2], my[2]
            near = abs(a - my_a) <= tolerance and abs(b - my_b) <= tolerance
            if plane != my_plane or turns != my_turns or not near:
                yield f"{where}: rs274 arc {their[2]}, Chordal {my[2]}"


def on_turned_arc(their, my, tolerance):
    """How a spline of Chordal differs from the turned arc of another plane that rs274 has."""
    if not my[0].startswith("spline"):
        yield f"rs274 {their[0]}, Chordal {my[0]}"
        return
    plane, center_a, center_b, turns, turn = their[2]
    a, b, normal = PLANES[plane]
    places = [turn.back(place) for place in spline_places(my[2], 8 * (len(my[2]["weights"]) - 1))]
    radius = math.hypot(places[0][a] - center_a, places[0][b] - center_b)
    angles = [math.atan2(place[b] - center_b, place[a] - center_a) for place in places]
    swept = sum(math.remainder(b - a, math.tau) for a, b in zip(angles, angles[1:]))
    for place in places:
        off = abs(math.hypot(place[a] - center_a, place[b] - center_b) - radius)
        if off > 2 * tolerance or abs(place[normal] - places[0][normal]) > 2 * tolerance:
            yield f"Chordal's spline leaves the arc {their[2][:4]} at {place}"
            return
    if far(their[1], my[1], 2 * tolerance):
        yield f"rs274 ends at {their[1]}, Chordal at {my[1]}"
    if (swept > 0) != (turns > 0) or math.ceil(abs(swept) / math.tau - 1e-6) != abs(turns):
        yield f"rs274 turns {turns} times, Chordal {math.degrees(swept)} degrees"


def spline_places(spline, count):
    """Places of a rational B-spline, from its start to its end."""
    order, knots = spline["order"], spline["knots"]
    rows = list(zip(spline["x"], spline["y"], spline["z"], spline["weights"]))
    points = [[x * w, y * w, z * w, w] for x, y, z, w in rows]
    for step in range(count + 1):
        u = knots[0] + (knots[-1] - knots[0]) * step / count
        last = max(i for i in range(order - 1, len(points)) if i == order - 1 or knots[i] <= u)
        row = points[last - order + 1 : last + 1]
        for level in range(1, order):
            for i in range(order - 1, level - 1, -1):
                low = knots[last - order + 1 + i]
                share = (u - low) / (knots[last + i + 1 - level] - low)
                row[i] = [(1 - share) * p + share * q for p, q in zip(row[i - 1], row[i])]
        x, y, z, w = row[-1]
        yield [x / w, y / w, z / w]


def main():
    here = pathlib.Path(__file__).resolve().parent.parent
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--chordal", default=str(here / "target/release/chordal"))
    parser.add_argument("programs", nargs="*", type=pathlib.Path)
    arguments = parser.parse_args()
    programs = arguments.programs or sorted((here / "tests/rs274").glob("*.ngc"))
    wrong = motions = 0
    for program in programs:
        try:
            theirs, their_lines = reference(program)
            what = "path" if TOOL_PATH in program.read_text() else "commands"
            mine, my_lines, _ = ours(arguments.chordal, program, what)
        except Failed as failure:
            sys.exit(f"{program}: {failure}")
        problems = list(differences(program, theirs, mine))
        if their_lines != my_lines:
            problems.append(f"rs274 prints {their_lines}, Chordal {my_lines}")
        motions += len(theirs)
        wrong += bool(problems)
        print(f"{'DIFFERS' if problems else 'same':8}{len(theirs):4} steps  {program.name}")
        for problem in problems[:5]:
            print("        ", problem)
    print(f"{len(programs) - wrong} passed, {wrong} failed, {motions} steps")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
