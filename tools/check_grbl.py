#!/usr/bin/env python3
"""Random blocks and arcs for GRBL 1.1: does Chordal answer each as a second model of the firmware does?

    cargo build --release -p chordal-cli
    python3 tools/check_grbl.py vectors
    python3 tools/check_grbl.py blocks target/release/chordal [BLOCKS [SEED]]
    python3 tools/check_grbl.py arcs target/release/chordal [SEED]

The model (grbl_model.py) was written from the rules of GRBL 1.1h without reading Chordal's code for them. `vectors` runs it on the
blocks of tests/grbl/vectors.txt, which the firmware's own parser answered. `blocks` makes random programs of ten blocks and
compares for each block whether it is refused, the number of the error, the machine position after it, and the feed of a cut.
`arcs` does the same with arcs on both sides of every limit of error:33, in mm and inch, from zero and from elsewhere. It prints
what differs, and how much was compared; the exit code is 1 if anything differs.

Not compared: lines of `$` and blocks after M2 and M30, which Chordal says that it does not follow, and bytes that the firmware
takes out of the line at once (`!`, `?`, `~` and all above 127).
"""
import collections
import json
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile

from grbl_model import AXES, CENTRE, GROUPS, INCH, PLANES, Control

# --- The vectors -------------------------------------------------------------------------------------------------------------


def check_vectors(path):
    """Each row: blocks, answers, position at the end, and the segments of an arc."""
    rows = [line for line in path.read_text().splitlines() if line and not line.startswith("#")]
    wrong = [row for row in rows if not vector_agrees(row)]
    for row in wrong:
        print(f"differs: {row}")
    print(f"{len(rows)} vectors, {len(wrong)} differ")
    return bool(wrong)


def vector_agrees(row):
    program, answers, *end = row.split("\t")
    place, _, count = end[0].partition("n") if end else ("", "", "")
    control = Control()
    control.probe_touches = "A" not in answers
    got, arc = [], None
    for block, answer in zip(program.split("|"), answers.split()):
        number = control.answer(block)
        arc = control.segments or arc
        got.append("A5" if control.locked and answer.startswith("A") else str(number))
    expected = [float(part or 0) for part in (place.strip() or "0").split(",")]
    expected += [0.0] * (3 - len(expected))
    near = all(abs(a - b) <= 1e-6 * max(1.0, abs(b)) for a, b in zip(control.position.values(), expected))
    return got == answers.split() and near and (not count or int(count) == arc)


# --- Random blocks -----------------------------------------------------------------------------------------------------------

BLOCKS_OF_PROGRAM, PROGRAMS_AT_ONCE = 10, 500
CODES = {letter: [code for (group, _), codes in GROUPS.items() if group == letter for code in codes] for letter in "GM"}
STRANGE = """
    G5 G41D1 G43H1 G64 G81 G1.5 G61.1 G90.1 G38.9 G1.004 G49.5 G3.997 G59.1 G-1 G-0.3 M6 M7 M56 M3.1 M98 M-1 A1 E2 H1
    O10 Q1 T256 T255.5 T12.7 N10000001 N10000000.9 N-1 F-1 P-1 S-0 #1 X#2 [1] % *5 = X X. Y- Z--1 X1.2.3 G M 1 ) L2
    L20 L258 P7 P1.9 R1 R-2 I0 J0 K1 F0 F1E3 X123456.789 Y-0000000012 Z1234.56789012
""".split()
COMMENTS = ["(x)", "(a (b) ", "( ; )", "; M30", "(G0 X9)", "(open", "()", ";"]
# Differences of the radii of an arc at which a verdict turns, mm, and the part of the radius.
TURNS, PART = [0.005, 0.5], 0.001


def written(rng, value):
    """A number as people and programs write it."""
    places = rng.choice([0, 1, 2, 3, 3, 4, 4, 5, 6, 7, 9, 12])
    text = f"{value:.{places}f}"
    which = rng.random()
    if which < 0.1 and "." in text:
        text = text.rstrip("0")
    elif which < 0.15:
        text = text.replace("0.", ".", 1) if text.lstrip("-").startswith("0.") else text
    elif which < 0.2 and not text.startswith("-"):
        text = "+" + text
    elif which < 0.23:
        sign = "-" if text.startswith("-") else ""
        text = sign + "0" * rng.randrange(1, 9) + text.lstrip("-")
    return text


def word(rng, letter, size=20.0):
    return letter + written(rng, rng.choice([rng.uniform(-size, size), float(rng.randrange(-3, 4))]))


def positive(rng, letter, size):
    return letter + written(rng, rng.uniform(0.0, size))


def some_axes(rng, least=1):
    return [word(rng, axis) for axis in rng.sample(AXES, rng.randint(least, 3))]


def code_word(letter, code):
    return f"{letter}{code / 100:g}"


def any_code(rng, letter):
    return code_word(letter, rng.choice([code for code in CODES[letter] if letter == "G" or code not in (200, 3000)]))


def a_move(rng, control):
    return [rng.choice(["", "G0", "G1", "G1", "G01"])] + some_axes(rng, 0) + ([positive(rng, "F", 900.0)] if rng.random() < 0.5 else [])


def an_arc(rng, control):
    """From where the control stands, its end about on the circle, in its plane, units and distance mode."""
    plane = rng.choice([17, 17, 18, 19])
    radius = 10.0 ** rng.uniform(-2.0, 3.5)
    off = rng.choice([0.0, 0.0, 1.0]) * rng.choice(TURNS + [PART * radius]) * rng.choice([-1.0, 1.0, rng.uniform(-2.0, 2.0)])
    start, end = (rng.uniform(-math.pi, math.pi) for _ in range(2))
    centre = [-radius * math.cos(start), -radius * math.sin(start)]
    to = [centre[0] + (radius + off) * math.cos(end), centre[1] + (radius + off) * math.sin(end)]
    if rng.random() < 0.1:
        to = [0.0, 0.0]
    made = [rng.choice(["G2", "G3"]), f"F{rng.randrange(1, 900)}"] + ([] if control.plane == plane and rng.random() < 0.8 else [f"G{plane}"])
    made += [arc_end(rng, control, axis, along) for axis, along in zip(PLANES[plane], to)]
    if rng.random() < 0.3:
        chord = math.hypot(*to)
        made.append("R" + exact(rng.choice([-1.0, 1.0]) * rng.choice([radius, 0.5 * chord, 0.5 * chord * rng.uniform(0.9999, 1.0001)]), control))
    else:
        made += [CENTRE[axis] + exact(along, control) for axis, along in zip(PLANES[plane], centre)]
    if rng.random() < 0.2:
        made.append(word(rng, rng.choice(AXES)))
    return made


def exact(value, control):
    return f"{value / INCH if control.inch else value:.7f}"[:9]


def arc_end(rng, control, axis, along):
    value = along if control.distance == 91 else along + control.position[axis] - control.systems[control.system][axis] - control.shift[axis]
    if axis == "Z" and control.distance == 90:
        value -= control.length
    return axis + exact(value, control)


def a_mode(rng, control):
    modes = "G20 G21 G90 G91 G17 G18 G19 G93 G94 G80 G91.1 G40 G61 G54 G55 G59".split()
    return rng.choices(modes, k=rng.randint(1, 2))


def a_feed_mode(rng, control):
    feed = [positive(rng, "F", 90.0)] if rng.random() < 0.6 else []
    return [rng.choice(["G93", "G93", "G94"]), rng.choice(["", "G1", "G0"])] + some_axes(rng, 0) + feed


def an_offset(rng, control):
    which = rng.random()
    if which < 0.5:
        made = ["G10", rng.choice(["L2", "L2", "L20", "L20", "L2.7", "L3", "L0", ""]), rng.choice(["P0", "P1", "P2", "P6", "P7", "P1.5", ""])]
        return made + some_axes(rng, rng.choice([0, 1, 1, 1])) + (["R1"] if rng.random() < 0.05 else [])
    if which < 0.75:
        return ["G92"] + some_axes(rng, rng.choice([0, 1, 1, 1]))
    return ["G92.1"] + (some_axes(rng) if rng.random() < 0.3 else [])


def a_stored_point(rng, control):
    return [rng.choice(["G28", "G28.1", "G30", "G30.1"])] + (some_axes(rng) if rng.random() < 0.5 else []) + (["G0"] if rng.random() < 0.1 else [])


def a_length(rng, control):
    return rng.choice([["G43.1", word(rng, "Z")], ["G43.1", word(rng, "Z")], ["G49"], ["G43.1"] + some_axes(rng, 0), ["G49"] + some_axes(rng)])


def a_machine_move(rng, control):
    return ["G53", rng.choice(["", "G0", "G1", "G2"])] + some_axes(rng, 0)


def a_probe(rng, control):
    return [rng.choice(["G38.2", "G38.3", "G38.4", "G38.5"])] + some_axes(rng, rng.choice([0, 1, 1, 1])) + ["F50"]


def a_dwell(rng, control):
    return ["G4"] + ([positive(rng, "P", 1.0)] if rng.random() < 0.8 else []) + (some_axes(rng) if rng.random() < 0.2 else [])


def an_auxiliary(rng, control):
    words = [any_code(rng, "M"), positive(rng, "S", 9000.0), positive(rng, "T", 300.0), positive(rng, "F", 900.0), "F0"]
    return rng.sample(words + [positive(rng, "N", 2e7)], rng.randint(1, 2))


def a_salad(rng, control):
    letters = "GGGMFIJKLNPRSTXYZ"
    return [any_code(rng, letter) if letter in "GM" else word(rng, letter) for letter in rng.choices(letters, k=rng.randint(1, 5))]


RECIPES = [
    a_move, a_move, a_move, an_arc, an_arc, an_arc, a_mode, a_mode, a_feed_mode, an_offset, an_offset, a_stored_point,
    a_length, a_machine_move, a_probe, a_dwell, an_auxiliary, a_salad,
]


def random_block(rng, control):
    made = [part for part in rng.choice(RECIPES)(rng, control) if part]
    change = rng.random()
    if change < 0.06:
        made.append(rng.choice(STRANGE))
    elif change < 0.09 and made:
        made.append(rng.choice(made))
    elif change < 0.12 and made:
        made.pop(rng.randrange(len(made)))
    elif change < 0.17:
        made.append(any_code(rng, "G"))
    elif change < 0.20:
        made += some_axes(rng)
    if rng.random() < 0.5:
        rng.shuffle(made)
    return dressed(rng, made)


def dressed(rng, made):
    """With blanks, comments, slashes, lower case, and now and then too long."""
    if rng.random() < 0.03:
        made = made + [f"N{'0' * rng.randrange(40, 80)}"]
    if rng.random() < 0.06:
        made = made + [rng.choice(COMMENTS)]
    text = rng.choice(["", " ", " "]).join(made)
    if rng.random() < 0.05:
        at = rng.randrange(len(text) + 1)
        text = text[:at] + rng.choice(["/", "(q)", "\t", " "]) + text[at:]
    return text.lower() if rng.random() < 0.1 else text


def random_program(rng):
    """Blocks and what the model answers to each."""
    control, lines, answers = Control(), [], []
    for _ in range(BLOCKS_OF_PROGRAM):
        lines.append(random_block(rng, control))
        answers.append(answered(control, lines[-1], answers))
    if rng.random() < 0.1:
        lines.append(rng.choice(["M2", "M30", "G0X1M30"]))
        answers.append(answered(control, lines[-1], answers))
    return lines, answers


Answer = collections.namedtuple("Answer", "number position tolerance feed")


def answered(control, line, before):
    """The number of the error, the position, what rounding to 24 bits may have changed of it by now, and the feed."""
    number = control.answer(line)
    lengths = [control.position, control.shift, *control.systems, {"Z": control.length}]
    reach = max(abs(value) for each in lengths for value in each.values())
    rounding = 1e-6 + 2.0**-21 * reach
    tolerance = max([rounding] + [answer.tolerance for answer in before[-1:]])
    return Answer(number, dict(control.position), tolerance, control.cut_feed if number == 0 else None)


# --- Chordal -----------------------------------------------------------------------------------------------------------------

SETTINGS = ["settings.on error=continue", "settings.M6=nobody"] + [f'axes.{axis}.travel=["-100000 m", "100000 m"]' for axis in AXES]


def chordal_answers(command, programs, folder):
    """For each program and each of its lines: the number of the error, the machine position after it, the feed of its cut."""
    names = []
    for at, lines in enumerate(programs):
        names.append(folder / f"{at}.nc")
        names[-1].write_text("\n".join(lines) + "\n")
    for old in folder.glob("*.jsonl"):
        old.unlink()
    settings = [part for setting in SETTINGS for part in ("--set", setting)]
    run = [command, "run", *map(str, names), "--machine", "grbl", *settings, "--format", "json", "-o", f"{folder}/*.jsonl"]
    got = json.loads(subprocess.run(run, capture_output=True, text=True, check=False).stdout)
    for lines, name, file in zip(programs, names, got["files"], strict=True):
        commands = [json.loads(line) for line in name.with_suffix(".jsonl").read_text().splitlines()[1:]]
        yield list(zip(refusals(file, len(lines)), positions(commands, len(lines)), feeds(commands, len(lines)), strict=True))


def refusals(file, count):
    """The number of the error of each line. An error that is none of the firmware's is its code."""
    numbers = [0] * count
    for problem in file["diagnostics"]:
        if problem["severity"] == "error":
            number = re.search(r"error:(\d+)", problem["alarm"] or "")
            numbers[problem["line"] - 1] = int(number[1]) if number else problem["code"]
    return numbers


def positions(commands, count):
    """Programmed position, offset and length as the commands give them, added."""
    at, offset, length, after = dict.fromkeys(AXES, 0.0), dict.fromkeys(AXES, 0.0), 0.0, {}
    for command in commands:
        if command["kind"] == "work_offset":
            offset = command["offset"]
        elif command["kind"] == "tool_length":
            length = command["length"]
        elif "to" in command:
            at = {axis: command["to"][axis] + offset[axis] + (length if axis == "Z" else 0.0) for axis in AXES}
        after[command["line"]] = at
    placed, last = [], dict.fromkeys(AXES, 0.0)
    for number in range(1, count + 1):
        last = after.get(number, last)
        placed.append(last)
    return placed


def feeds(commands, count):
    cuts = {command["line"]: command["feed"] for command in commands if command["kind"] in ("line", "arc")}
    return [cuts.get(number) for number in range(1, count + 1)]


def first_difference(expected, got):
    for at, (model, (number, position, feed)) in enumerate(zip(expected, got, strict=True), 1):
        moved = any(abs(position[axis] - model.position[axis]) > model.tolerance for axis in AXES)
        if number != model.number or moved or not same_feed(model.feed, feed):
            return at
    return None


def same_feed(model, chordal):
    """Where both have one: a cut of no length is no command."""
    return model is None or chordal is None or abs(chordal - model) <= 1e-6 * model


class Comparison:
    """What was compared, and what differed by kind."""

    def __init__(self):
        self.programs, self.blocks, self.answers, self.kinds = 0, 0, collections.Counter(), collections.Counter()

    def add(self, lines, expected, got):
        at = first_difference(expected, got)
        self.programs += 1
        self.blocks += len(lines) if at is None else at
        self.answers.update(answer.number for answer in expected)
        if at is not None:
            self.show(lines, at, expected[at - 1], got[at - 1])

    def show(self, lines, at, model, chordal):
        kind = f"model {model.number}, Chordal {chordal[0]}" if model.number != chordal[0] else f"another place or feed after {model.number}"
        self.kinds[kind] += 1
        if self.kinds[kind] <= 5:
            print(f"differs at block {at}: {kind}; {list(model.position.values())} F{model.feed}, {list(chordal[1].values())} F{chordal[2]}")
            for line in lines[:at]:
                print(f"    {line}")

    def summary(self):
        print(f"{self.programs} programs, {self.blocks} blocks compared, {sum(self.kinds.values())} differ")
        print("answers: " + ", ".join(f"{number}: {count}" for number, count in sorted(self.answers.items())))
        for kind, count in self.kinds.most_common():
            print(f"  {count} {kind}")
        return bool(self.kinds)


def compare(command, programs):
    """Programs with their answers, many in one process."""
    comparison = Comparison()
    with tempfile.TemporaryDirectory() as folder:
        while batch := [program for _, program in zip(range(PROGRAMS_AT_ONCE), programs)]:
            texts = [lines for lines, _ in batch]
            for (lines, expected), got in zip(batch, chordal_answers(command, texts, pathlib.Path(folder)), strict=True):
                comparison.add(lines, expected, got)
    return comparison.summary()


def check_blocks(command, blocks=100_000, seed=1):
    rng = random.Random(int(seed))
    return compare(command, (random_program(rng) for _ in range(int(blocks) // BLOCKS_OF_PROGRAM)))


# Arcs of the grid: radii and starts, mm or inch, and how far from the limit, mm.
RADII = [0.01, 0.3, 1.0, 4.9, 4.999, 5.0, 5.001, 7.7, 25.0, 123.456, 499.9, 500.0, 500.1, 1000.0, 2500.0]
STARTS = [0.0, 12.7, -187.654]
STEPS = [0.0, 1e-7, 3e-7, 1e-6, 2e-6, 5e-6, 1e-5, 3e-5, 1e-4, 1e-3]
ARCS_OF_PROGRAM, ROUNDS = 20, 4


def grid_arcs(rng):
    """Units, start, and the words of an arc whose radii differ by about a limit."""
    for inch in (False, True):
        unit = INCH if inch else 1.0
        for radius in RADII * ROUNDS:
            for turn in [*TURNS, PART * radius * unit]:
                for step in STEPS:
                    for side in (-1.0, 1.0):
                        yield inch, rng.choice(STARTS), radius, rng.choice([-1.0, 1.0]) * (turn + side * step) / unit


def grid_blocks(rng, inch, start, radius, off):
    """Half of the arcs begin and end on an axis, so that nothing but the limit is rounded."""
    begin, end = rng.choice([(0.0, 0.0), tuple(rng.uniform(-math.pi, math.pi) for _ in range(2))])
    centre = [-radius * math.cos(begin), -radius * math.sin(begin)]
    to = [start + middle + (radius + off) * along for middle, along in zip(centre, (math.cos(end), math.sin(end)))]
    words = [letter + digits(value) for letter, value in zip("XYIJ", to + centre)]
    return ["G20" if inch else "G21", f"G0X{start}Y{start}", rng.choice(["G2", "G3"]) + "F100" + "".join(words)]


def digits(value):
    """The eight digits that the firmware reads."""
    return f"{value:.{max(0, 8 - len(str(abs(int(value)))))}f}"


def grid_programs(rng):
    lines, control, answers = [], Control(), []
    for arc in grid_arcs(rng):
        for line in grid_blocks(rng, *arc):
            lines.append(line)
            answers.append(answered(control, line, answers))
        if len(lines) >= 3 * ARCS_OF_PROGRAM:
            yield lines, answers
            lines, control, answers = [], Control(), []
    if lines:
        yield lines, answers


def check_arcs(command, seed=1):
    return compare(command, grid_programs(random.Random(int(seed))))


if __name__ == "__main__":
    kind, *arguments = sys.argv[1:] or ["help"]
    if kind == "vectors":
        sys.exit(check_vectors(pathlib.Path(__file__).parent.parent / "tests/grbl/vectors.txt"))
    elif kind == "blocks":
        sys.exit(check_blocks(*arguments))
    elif kind == "arcs":
        sys.exit(check_arcs(*arguments))
    sys.exit(__doc__)
