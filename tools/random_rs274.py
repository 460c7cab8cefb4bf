#!/usr/bin/env python3
"""Random programs of LinuxCNC, run by Chordal and by LinuxCNC's own interpreter, rs274.

Writes programs of each group into a folder and compares them as tools/compare_rs274.py does. The
same seed writes the same programs. Where rs274 refuses a program, the motions before that must
agree, and Chordal must report an error.

    tools/random_rs274.py [--chordal target/release/chordal] [--seed 1] [--count 20] [GROUP...]
"""

import argparse
import pathlib
import random
import sys
import tempfile

from compare_rs274 import Failed, differences, ours, reference


class Writer:
    """Random words."""

    def __init__(self, seed):
        self.random = random.Random(seed)

    def number(self, low, high, digits=2):
        return f"{self.random.uniform(low, high):.{digits}f}"

    def pick(self, *choices):
        return self.random.choice(choices)

    def maybe(self, text, chance=0.5):
        return text if self.random.random() < chance else ""

    def axes(self, letters="XYZ", low=-4, high=4):
        count = self.random.randint(1, len(letters))
        chosen = sorted(self.random.sample(letters, count))
        return " ".join(f"{letter}{self.number(low, high)}" for letter in chosen)

    def many(self, least, most):
        return range(self.random.randint(least, most))


HEAD = ["G17 G40 G49 G54 G80 G90 G94", "F500"]
PRINT = "(PRINT, {})"
PLACE = "#5420 #5421 #5422"


def polar(w):
    """Radius and angle in place of X and Y, G90 and G91, with cycles."""
    yield w.pick("G20", "G21")
    yield w.maybe("G10 L2 P1 X3 Y-2")
    yield f"G0 X{w.number(1, 9)} Y{w.number(1, 9)} Z9"
    for _ in w.many(4, 9):
        radius, angle = w.maybe(f"@{w.number(-9, 9)}", 0.7), w.maybe(f"^{w.number(-200, 200)}", 0.7)
        if w.random.random() < 0.2:
            yield w.pick("G90", "G91")
        elif w.random.random() < 0.2:
            yield f"G0 {w.axes('XY', 1, 9)}"
        elif w.random.random() < 0.15:
            yield f"G90 G{w.pick(98, 99)} G81 {radius} ^{w.number(0, 90)} Z-1 R{w.number(1, 3)} {w.maybe('L2')}"
            yield "G80"
            yield "G0 Z9"
        elif radius or angle:
            yield f"{w.pick('G0', 'G1', 'G0', 'G1')} {radius} {angle} {w.maybe('Z' + w.number(1, 9), 0.2)}"


def levels(w):
    """Cycles from power-on, without G98 until it comes."""
    yield w.pick("G20", "G21")
    yield "S900 M3"
    yield f"G0 X1 Y1 Z{w.number(5, 20)}"
    for _ in w.many(2, 5):
        cycle = w.pick("G81", "G82 P.5", "G83 Q1.5", "G73 Q2", "G85", "G89 P.1", "G86 P.2")
        yield f"{w.maybe(w.pick('G98', 'G99'), 0.3)} {cycle} X{w.number(-9, 9)} Z{w.number(-5, -1)} R{w.number(0, 4)}"
        yield f"X{w.number(-9, 9)} {w.maybe('Y' + w.number(-9, 9))}"
        yield w.maybe(f"G80 {w.pick('G0', 'G1')} {w.axes()}")
        yield w.maybe("G80")
        yield f"G0 Z{w.number(5, 20)}"


def taps(w):
    """G84 and G74 in every plane, where 2.9 exchanges their coordinates outside of G17."""
    # Whole numbers: rs274 adds moves of nothing where its sums are rounded.
    yield "G20"
    plane, letter, others = w.pick(("G17", "Z", "XY"), ("G18", "Y", "ZX"), ("G19", "X", "YZ"))
    cycle, turn = w.pick(("G84", "M3"), ("G74", "M4"))
    yield f"{plane} S200 {turn} {w.pick('G98', 'G99')}"
    yield f"G0 {letter}{w.number(3, 9, 0)} {w.axes(others)}"
    yield w.maybe("G91", 0.2)
    yield f"{cycle} {letter}{w.number(-6, -1, 0)} R{w.number(0, 4, 0)} {w.axes(others)} {w.maybe('P.2')}"
    for _ in w.many(1, 3):
        yield w.axes(others)
    yield w.maybe("G80")
    yield f"G0 {w.axes()}"


def offsets(w):
    """Work offsets, stored points, tool offsets, presets; the position in variables."""
    yield w.pick("G20", "G21")
    yield "T1 M6"
    yield f"G0 {w.axes()}"
    for _ in w.many(5, 10):
        yield w.pick(
            f"G10 L2 P{w.pick(0, 1, 2, 9)} {w.axes()}",
            f"G10 L20 P{w.pick(0, 1, 2)} {w.axes()}",
            w.pick("G54", "G55", "G59.3"),
            w.pick("G90", "G91", "G90"),
            f"G28.{1}",
            "G30.1",
            f"G28 {w.maybe(w.axes())}",
            f"G30 {w.maybe(w.axes())}",
            f"G43.1 {w.axes()}",
            "G43.2 H3",
            f"T{w.pick(1, 3)} M6",
            "G43",
            f"G43 H{w.pick(1, 3)}",
            "G49",
            f"G92 {w.axes()}",
            w.pick("G92.1", "G92.2", "G92.3"),
            f"G52 {w.axes()}",
            f"G53 G0 {w.axes()}",
            f"G10 L1 P{w.pick(1, 3)} Z{w.number(1, 9)}",
            f"G10 L1{w.pick(0, 1)} P{w.pick(1, 3)} Z{w.number(1, 9)}",
            f"#{w.pick(5221, 5222, 5241, 5161, 5182, 5211)}={w.number(-5, 5)}",
        )
        yield f"{w.pick('G0', 'G1')} {w.axes()}"
        yield PRINT.format(w.pick(PLACE, "#5161 #5182", "#5210 #5211 #5213", "#5221 #5241 #5220", "#5403 #5400"))


def thread(w):
    """G33 and G33.1, modal and not."""
    yield w.pick("G20", "G21")
    yield w.maybe("S600 M3", 0.9)
    yield f"G0 {w.axes()}"
    for _ in w.many(2, 6):
        yield f"{w.pick('G33', 'G33', 'G33.1')} {w.axes()} {w.maybe('K' + w.number(0.1, 3), 0.95)}"
        yield w.maybe(f"{w.axes()} K{w.number(0.1, 3)}")
        yield w.maybe(f"G0 {w.axes()}")


def modes(w):
    """M70 to M73 with what they keep."""
    change = lambda: w.pick("G91", "G90", "G20", "G21", "G18", "G17", "G55", "G54", "G99", "G98", "G90.1", "G91.1", "F200")
    yield w.pick("G20", "G21")
    yield "O1 sub"
    yield w.pick("M73", "M70", "", "M73 G91")
    yield change()
    yield f"G0 {w.axes()}"
    yield w.maybe("M72", 0.3)
    yield "O1 endsub"
    for _ in w.many(3, 8):
        yield w.pick("M70", "M72", "M70", "O1 call", "O1 call", change(), change(), w.maybe("M71", 0.2))
        yield f"G0 {w.axes()}"
        yield PRINT.format("#<_metric> #<_absolute> #<_plane> #<_coord_system> #<_retract_r_plane>")


def flow(w):
    """O words: subs, arguments, loops, conditions."""
    yield "G21"
    yield w.pick("O100 sub", "o 1 0 0 s u b", "O100sub")
    yield "G0 X[#1+#31] Y#2"
    yield "O102 if [#1 GT 5]"
    yield w.maybe("O100 return [#1*2]")
    yield "O102 else"
    yield "#31=[#31+1]"
    yield w.pick("O102 endif", "o102 end if")
    yield "O100 endsub [#2]"
    yield "#31=1 #2=7"
    count = w.pick(2, 3, 5)
    kind = w.pick("repeat", "while", "do")
    yield "#3=0"
    yield {"repeat": f"O200 repeat [{count}]", "while": f"O200 while [#3 LT {count}]", "do": "O200 do"}[kind]
    yield "#3=[#3+1]"
    yield f"O100 call [#3*{w.number(1, 3, 1)}] {w.maybe('[' + w.number(0, 9) + ']')}"
    yield PRINT.format("#<_value> #2 #31")
    yield w.maybe(f"O201 if [#3 EQ 2]\nO200 {w.pick('break', 'continue')}\nO201 endif", 0.3)
    yield {"do": f"O200 while [#3 LT {count}]"}.get(kind, f"O200 end{kind}")


def numbers(w):
    """Numbers as people write them: blanks, signs, digits, expressions."""
    yield w.pick("G20", "G21")
    for _ in w.many(4, 8):
        value = w.number(0, 20, w.pick(0, 1, 3, 6, 20))
        yield "G0 " + w.pick(
            f"X{value}", f"x - {value}", f"X+{value}", f"X--{value}", f"X+-{value}",
            f"x {value[0]} {value[1:]}", f"Y.5 X 1 . 5", f"X[{value}*2] Y-[1+2]", f"X-#5420", f"X0{value}",
            f"Y[ABS[-{value}] MOD 7]", f"X[2**3] Y[ATAN[{value}]/[2] / 9]", f"X[ROUND[{value}]] y [fix[{value}]]",
        )
        yield w.maybe(f"#1={value} G1 X#1")
        yield w.maybe(PRINT.format("#5420 EXISTS[#1]"), 0)
        yield w.maybe(f"#2=exists[#{w.pick(1, 5601, 5602)}] #3=EXISTS[#<n>]\n(PRINT, #2 #3)", 0.3)


def compensation(w):
    """G41 and G42 by a diameter, around random corners; the path of the tool centre."""
    yield "G21"
    yield "F100 G0 X0 Y0 Z1"
    yield w.maybe(f"G10 L2 P1 X{w.number(-9, 9)} Y{w.number(-9, 9)} R{w.number(-180, 180)}\nG0 X0 Y0", 0.3)
    side = w.pick("G41.1", "G42.1")
    yield f"{side} D{w.number(0.5, 4)} {w.pick('G1', 'G0')} X{w.number(8, 15)} Y{w.number(-5, 5)}"
    x, y = 20.0, 0.0
    for index in w.many(2, 6):
        x, y = x + w.random.uniform(-3, 14), y + w.random.uniform(-14, 14)
        if w.random.random() < 0.3:
            yield f"{w.pick('G2', 'G3')} X{x:.2f} Y{y:.2f} R{w.number(12, 30)}"
        else:
            yield f"{w.pick('G0', 'G1', 'G1', 'G1')} X{x:.2f} Y{y:.2f} {w.maybe('Z' + w.number(1, 3), 0.1)}"
    yield "G1 X80 Y40"
    yield w.pick("G40", "G40 G1 X90", "G40 G0 Z5", "G40 G1 X90 Y50 Z3")
    yield f"{w.pick('G0', 'G1')} {w.pick('Z7', 'X95', 'Y60', 'X95 Y20')}"


def dwell(w):
    """G4 with motion in its block."""
    yield w.pick("G20", "G21")
    for _ in w.many(2, 5):
        yield f"{w.pick('G0', 'G1')} {w.axes()}"
        yield f"G4 P{w.number(0.1, 2)} {w.maybe(w.pick('G0', 'G1', ''))} {w.maybe(w.axes())}"


def rotation(w):
    """A work coordinate system turned by G10 L2 R, with what lies inside and outside of the turn."""
    yield w.pick("G20", "G21")
    yield f"G0 {w.axes()}"
    turned = lambda: f"G10 L2 P{w.pick(1, 1, 2, 0)} {w.maybe(w.axes())} R{w.pick(30, 90, -45, 180, w.number(-200, 200))}"
    yield turned()
    for _ in w.many(4, 9):
        yield w.pick(
            f"G92.1\n{turned()}",
            f"G92.1\n{w.pick('G54', 'G55')}",
            f"G10 L20 P{w.pick(1, 2)} {w.axes()}",
            f"G53 {w.pick('G0', 'G1')} {w.axes()}",
            f"G28.1\nG0 {w.axes()}\nG90 G28 {w.maybe(w.axes())}",
            f"G30.1\nG0 {w.axes()}\nG91 G30 {w.maybe(w.axes())}\nG90",
            f"G92 {w.axes()}",
            f"G52 {w.axes()}",
            w.pick("G92.1", "G92.2", "G92.3"),
            f"G43.1 {w.axes()}",
            f"G91 G1 {w.axes()}\nX1\nG90",
            f"{w.pick('G2', 'G3')} X#5420 Y#5421 I{w.number(-4, 4)} J{w.number(1, 4)} {w.maybe('Z3')}",
            f"G91 {w.pick('G2', 'G3')} X{w.number(-3, 3)} Y{w.number(-3, 3)} R{w.pick('', '-')}5\nG90",
            f"G18 G91 {w.pick('G2', 'G3')} X{w.number(-3, 3)} Z{w.number(-3, 3)} R{w.pick('', '-')}5\nG90 G17",
            f"G19 G91 {w.pick('G2', 'G3')} Y{w.number(-3, 3)} Z{w.number(-3, 3)} R{w.pick('', '-')}5\nG90 G17",
            f"G0 Z9\n{w.pick('G81', 'G82 P.1', 'G83 Q2', 'G85')} {w.axes('XY')} Z-2 R{w.number(1, 3)}\n{w.axes('XY')}\nG80",
            f"G0 Z9\nG91 G81 {w.axes('XY')} Z-2 R-1 L2\nG80 G90",
        )
        yield f"{w.pick('G0', 'G1')} {w.axes()}"
        yield PRINT.format(w.pick(PLACE, "#5161 #5162 #5182", "#5210 #5211 #5212", "#5221 #5222 #5230 #5250", "#5401 #5402"))


def splines(w):
    """G5, G5.1 and G5.2, one after the other and between straight moves."""
    yield w.pick("G20", "G21")
    yield w.maybe(f"G10 L2 P1 {w.axes()} R{w.number(-90, 90)}", 0.3)
    yield f"G0 {w.axes()}"
    yield f"G1 {w.axes()}"
    end = lambda: f"X{w.number(-9, 9)} Y{w.number(-9, 9)}"
    pair = lambda a, b: f"{a}{w.number(-5, 5)} {b}{w.number(-5, 5)}"
    for _ in w.many(3, 7):
        kind = w.pick("cubic", "cubic", "quadratic", "weights", "straight", "wrong")
        if kind == "cubic":
            yield f"G5 {end()} {pair('I', 'J')} {pair('P', 'Q')}"
            for _ in w.many(0, 2):
                yield f"{w.maybe('G5', 0.97)} {end()} {w.maybe(pair('I', 'J'), 0.3)} {pair('P', 'Q')}"
        elif kind == "quadratic":
            yield f"G5.1 {end()} {pair('I', 'J')}"
            yield w.maybe(end())
        elif kind == "weights":
            yield w.pick(f"G5.2 P{w.number(0.5, 3)}", f"G5.2 {end()} P{w.number(0.5, 3)} {w.maybe('L' + w.pick('3', '4'))}")
            for _ in w.many(2, 5):
                yield f"{end()} P{w.number(0.5, 3)}"
            yield "G5.3"
        elif kind == "wrong":
            yield w.maybe(w.pick(f"G5 {end()}", f"G5.1 {end()}", f"G5 X1 P1 Q1", f"G5.1 {end()} I1", "G5.3", "G5.2 X1 P1", f"G5.2 {end()} P1\n{end()} P-1"), 0.1)
        yield w.maybe(w.pick("G91", "G90"), 0.3)
        yield f"G1 {w.axes()}"
        yield PRINT.format(PLACE)


GROUPS = [polar, levels, taps, offsets, thread, modes, flow, numbers, compensation, dwell, rotation, splines]


def compare(chordal, program, what):
    """What differs; whether rs274 refused the program."""
    refused, refusal = False, ""
    try:
        theirs, their_lines = reference(program)
    except Failed as failure:
        refused, refusal, theirs, their_lines = True, str(failure), failure.motions, None
    try:
        mine, my_lines, errors = ours(chordal, program, what)
    except Failed as failure:
        return [f"chordal failed: {failure}"], refused, 0
    if refused:
        problems = list(differences(program, theirs, mine[: len(theirs)]))
        if not errors:
            problems.append(f"rs274 refuses it, Chordal reports no error: {refusal}")
        return problems, refused, len(theirs)
    problems = list(differences(program, theirs, mine))
    if their_lines != my_lines:
        first = next((pair for pair in zip(their_lines, my_lines) if pair[0] != pair[1]), None)
        problems.append(f"they print different lines: {first or (their_lines, my_lines)}")
    # Checks of the contour are Chordal's own.
    if errors and what != "path":
        problems.append("Chordal reports an error, and rs274 does not")
    return problems, refused, len(theirs)


def main():
    here = pathlib.Path(__file__).resolve().parent.parent
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--chordal", default=str(here / "target/release/chordal"))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--keep", type=pathlib.Path, help="folder for the programs that differ")
    parser.add_argument("groups", nargs="*")
    arguments = parser.parse_args()
    total = failed = 0
    for group in GROUPS:
        if arguments.groups and group.__name__ not in arguments.groups:
            continue
        wrong = refusals = steps = 0
        for number in range(arguments.seed, arguments.seed + arguments.count):
            lines = [*HEAD, *group(Writer(f"{group.__name__} {number}")), "M2"]
            text = "\n".join(line.strip() for line in lines if line.strip()) + "\n"
            with tempfile.TemporaryDirectory() as folder:
                program = pathlib.Path(folder, f"{group.__name__}-{number}.ngc")
                program.write_text(text)
                what = "path" if group is compensation else "commands"
                problems, refused, moved = compare(arguments.chordal, program, what)
                if problems and arguments.keep:
                    arguments.keep.mkdir(parents=True, exist_ok=True)
                    (arguments.keep / program.name).write_text(text)
            refusals, steps, wrong = refusals + refused, steps + moved, wrong + bool(problems)
            for problem in problems[:3]:
                print(f"  {program.name}: {problem}")
        total, failed = total + arguments.count, failed + wrong
        same = arguments.count - wrong
        print(f"{group.__name__:14}{same} the same, {wrong} differ; {steps} steps, {refusals} refused by both")
    print(f"{total - failed} of {total} programs are the same")
    sys.exit(bool(failed))


if __name__ == "__main__":
    main()
