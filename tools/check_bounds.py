#!/usr/bin/env python3
"""Random moves of every tool: is the truth always between Chordal's two bounds?

    python3 -m venv target/oracle && target/oracle/bin/pip install numpy opencamlib
    cargo build --release -p chordal-stock --example enclose
    target/oracle/bin/python tools/check_bounds.py target/release/examples/enclose [MOVES [SEED [TOOL]]]

The truth at a place of a cell is found without Chordal: on lines of flat, ball, bull and pointed cutters by OpenCAMLib, on
every other move by dense samples and golden sections about the lowest of them. Where that seems to be outside of the bounds it
is found again with a hundred times as many samples, which is what counts.
"""
import math
import subprocess
import sys

import numpy as np

try:
    import opencamlib as ocl
except ImportError:
    ocl = None

SHAPES = ["flat", "ball", "bull", "pointed", "T-slot", "lollipop", "thread disc"]
UNDERCUTS = range(4, 7)
KINDS = ["line", "arc YZ", "arc ZX", "arc XY"]
# Moves that are held at once, and samples of each.
AT_ONCE, SAMPLES, DENSE = 10_000, 256, 25_601
# What the truth itself may be off, mm: golden sections end at 1e-12 of a move, steep ones make 1e-10 of it;
# OpenCAMLib finds contacts of bull noses to 1e-8.
SAME = {"samples": 1e-9, "opencamlib": 1e-7}
# A place so near to the rim of the cutter is for rounding to say, mm.
GRAZES = 1e-7
GOLDEN = (math.sqrt(5.0) - 1.0) / 2.0
SECTIONS = 50


def tools(rng, shape, count):
    """Diameter and three more dimensions."""
    diameter = rng.uniform(1.0, 12.0, count)
    a, b = np.zeros(count), np.zeros(count)
    if shape == 2:
        # Also corners that are hardly round.
        a = np.where(rng.random(count) < 0.3, 10 ** rng.uniform(-2.0, -0.5, count), rng.uniform(0.02, 0.5, count)) * diameter
    elif shape == 3:
        a = np.where(rng.random(count) < 0.5, 0.0, rng.uniform(0.0, 0.9, count) * diameter)
        b = np.where(rng.random(count) < 0.3, math.radians(118.0), rng.uniform(0.3, 3.0, count))
    elif shape == 4:
        a, b = rng.uniform(0.2, 6.0, count), rng.uniform(0.2, 0.9, count) * diameter
    elif shape == 5:
        a = rng.uniform(0.2, 0.9, count) * diameter
    elif shape == 6:
        a, b = rng.uniform(0.05, 3.0, count), rng.uniform(0.1, 1.0, count)
    return np.stack([diameter, a, b, np.zeros(count)], axis=1)


def moves(rng, kind, count):
    """Seven numbers: start and end of a line; centre, radius, first angle, sweep and rise of an arc."""
    at = rng.uniform(-20.0, 20.0, (count, 3))
    if kind == 0:
        length = rng.uniform(0.01, 20.0, count)
        angle = rng.uniform(-math.pi, math.pi, count)
        angle = np.where(rng.random(count) < 0.2, np.round(angle / (math.pi / 2)) * (math.pi / 2), angle)
        which = rng.random(count)
        sign = rng.choice([-1.0, 1.0], count)
        steep = np.select(
            [which < 0.25, which < 0.4, which < 0.6],
            [0.0, rng.uniform(0, 20, count), 10 ** rng.uniform(-4, -0.5, count)],
            rng.uniform(0, 2, count),
        ) * sign
        # Some plunge.
        flat = np.where(rng.random(count) < 0.1, 0.0, 1.0)
        along = np.stack([flat * length * np.cos(angle), flat * length * np.sin(angle), length * steep], axis=1)
        return np.concatenate([at, at + along, np.zeros((count, 1))], axis=1)
    radius = rng.uniform(0.2, 15.0, count)
    sweep = rng.uniform(0.05, 2 * math.pi, count) * rng.choice([-1.0, 1.0], count)
    helix = rng.random(count) < 0.5
    sweep = np.where(helix & (rng.random(count) < 0.5), 4.0 * sweep, sweep)
    rise = np.where(helix, rng.uniform(-3.0, 3.0, count) * np.abs(sweep), 0.0)
    return np.concatenate([at, np.stack([radius, rng.uniform(-math.pi, math.pi, count), sweep, rise], axis=1)], axis=1)


def path(kind, move, share):
    """The tip at shares of the way, an array of each coordinate."""
    m = [move[:, n, None] for n in range(7)]
    if kind == 0:
        return [m[n] + (m[n + 3] - m[n]) * share for n in range(3)]
    angle = m[4] + m[5] * share
    first, second, third = m[3] * np.cos(angle), m[3] * np.sin(angle), m[6] * share
    around = {1: [third, first, second], 2: [second, third, first], 3: [first, second, third]}[kind]
    return [m[n] + around[n] for n in range(3)]


def round_rise(distance, radius):
    return radius - np.sqrt(np.maximum(radius * radius - distance * distance, 0.0))


def lower(shape, tool, rho):
    """The lower side above the tip at a distance from the axis."""
    diameter, a, b = (tool[:, n, None] for n in range(3))
    radius = diameter / 2
    if shape in (0, 4):
        return np.zeros_like(rho)
    if shape in (1, 5):
        return round_rise(rho, radius)
    if shape == 2:
        return round_rise(np.maximum(rho - (radius - a), 0.0), a)
    if shape == 3:
        return np.maximum(rho - a / 2, 0.0) / np.tan(b / 2)
    return np.maximum(rho - diameter / 4, 0.0) * np.tan(b)


def height(shape, tool):
    """From the tip to the highest place of the edges of an undercut."""
    diameter, a, b = (tool[:, n, None] for n in range(3))
    return {4: a, 5: diameter, 6: a + 2 * (diameter / 4) * np.tan(b)}[shape]


class Moves:
    """Moves of one shape on one kind of path, each with a place to ask about."""

    def __init__(self, shape, kind, tool, move, place, level=None):
        self.shape, self.kind, self.tool, self.move = shape, kind, tool, move
        self.place, self.level = place, level

    def some(self, which):
        level = None if self.level is None else self.level[which]
        return Moves(self.shape, self.kind, self.tool[which], self.move[which], self.place[which], level)

    def distance(self, share):
        x, y, z = path(self.kind, self.move, share)
        return np.hypot(x - self.place[:, 0, None], y - self.place[:, 1, None]), z

    def value(self, share):
        """The lowest place of the cutter over the column; with a level, how far that is from what is removed."""
        rho, z = self.distance(share)
        low = z + lower(self.shape, self.tool, rho)
        if self.level is not None:
            high = z + height(self.shape, self.tool) - lower(self.shape, self.tool, rho)
            level = self.level[:, None]
            low = np.maximum(low - level, level - high)
        return np.where(rho <= self.tool[:, 0, None] / 2, low, np.inf)

    def least(self, samples):
        """The least value along the move, and the nearest the axis comes to the column."""
        share = np.linspace(0.0, 1.0, samples)[None, :]
        value, rho = self.value(share), self.distance(share)[0]
        step, rows = 1.0 / (samples - 1), np.arange(len(self.place))
        first = np.argmin(value, axis=1)
        best = value[rows, first]
        # The lowest place elsewhere may be lower between the samples.
        around = np.abs(np.arange(samples)[None, :] - first[:, None]) <= 2
        second = np.argmin(np.where(around, np.inf, value), axis=1)
        nearest, apart = golden(lambda t: self.distance(t)[0], np.argmin(rho, axis=1) * step, step, 1.0)
        best = np.minimum(best, self.value(nearest)[:, 0])
        for middle in (first[:, None] * step, second[:, None] * step, nearest):
            for side in (-1.0, 0.0, 1.0):
                best = np.minimum(best, golden(self.value, middle[:, 0], step, side)[1])
        return best, apart


def golden(value, middle, step, side):
    """The least value about places, on one side of them (-1, 1) or both (0; 1 also for a nearest place)."""
    middle = middle[:, None]
    low = np.clip(middle - (step if side <= 0 else 0.0), 0.0, 1.0)
    high = np.clip(middle + (step if side >= 0 else 0.0), 0.0, 1.0)
    if side > 0 and value.__name__ == "<lambda>":
        low = np.clip(middle - step, 0.0, 1.0)
    best, at = np.full(len(middle), np.inf), middle.copy()
    for _ in range(SECTIONS):
        a, b = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
        both = value(np.concatenate([a, b], axis=1))
        for n, t in enumerate((a, b)):
            lower_one = both[:, n] < best
            best, at = np.where(lower_one, both[:, n], best), np.where(lower_one[:, None], t, at)
        left = (both[:, 0] <= both[:, 1])[:, None]
        low, high = np.where(left, low, a), np.where(left, b, high)
    return at, best


def dropped(moves_):
    """The floor by OpenCAMLib: the cutter dropped on the path turned over; nan where it does not do."""
    floors = np.full(len(moves_.place), np.nan)
    if ocl is None or moves_.kind != 0 or moves_.shape > 3:
        return floors
    for n, (tool, move, place) in enumerate(zip(moves_.tool, moves_.move, moves_.place)):
        diameter, a, b, _ = tool
        if moves_.shape == 3 and a > 0.0 or math.hypot(move[3] - move[0], move[4] - move[1]) < 1e-6:
            continue
        cutter = [
            lambda: ocl.CylCutter(diameter, 100.0),
            lambda: ocl.BallCutter(diameter, 100.0),
            lambda: ocl.BullCutter(diameter, a, 100.0),
            # A length would be added to the height of the cone.
            lambda: ocl.ConeCutter(diameter, b / 2, 0.0),
        ][moves_.shape]()
        start, end = ocl.Point(move[0], move[1], -move[2]), ocl.Point(move[3], move[4], -move[5])
        triangle = ocl.Triangle(start, end, ocl.Point(move[0], move[1], -1000.0))
        nothing = -1e6
        point = ocl.CLPoint(place[0], place[1], nothing)
        cutter.vertexDrop(point, triangle)
        cutter.edgeDrop(point, triangle)
        floors[n] = np.inf if point.z <= nothing else -point.z
    return floors


def cases(rng, shape, kind, count):
    tool, move = tools(rng, shape, count), moves(rng, kind, count)
    x, y, z = (axis[:, 0] for axis in path(kind, move, rng.random((count, 1))))
    angle = rng.uniform(-math.pi, math.pi, count)
    rho = tool[:, 0] / 2 * np.sqrt(rng.uniform(0.0, 1.05, count))
    place = np.stack([x + rho * np.cos(angle), y + rho * np.sin(angle)], axis=1)
    side = 10 ** rng.uniform(-2.0, 0.0, count)
    # Anywhere in the cell, often on its edges and corners.
    off = np.clip(rng.uniform(-0.7, 0.7, (count, 2)), -0.5, 0.5)
    middle = place + off * side[:, None]
    # A place on an edge is not moved off it by rounding.
    place = middle + np.clip(place - middle, -side[:, None] / 2, side[:, None] / 2) * (1.0 - 1e-9)
    level = None
    if shape in UNDERCUTS:
        rise = lower(shape, tool, np.minimum(rho, tool[:, 0] / 2)[:, None])[:, 0]
        upside = rng.random(count) < 0.5
        near = np.where(upside, height(shape, tool)[:, 0] - rise, rise)
        level = z + near + rng.normal(0.0, 1.0, count) * side * 10 ** rng.uniform(-3.0, 0.5, count)
    deep = np.where(rng.random(count) < 0.8, 300.0, 20.0)
    text = np.concatenate([
        np.full((count, 1), shape), tool, np.full((count, 1), kind), move, middle, side[:, None],
        -deep[:, None], deep[:, None],
    ], axis=1)
    return Moves(shape, kind, tool, move, place, level), text, deep, side


def ask(program, text):
    lines = "\n".join(" ".join(repr(float(number)) for number in row) for row in text) + "\n"
    done = subprocess.run([program], input=lines, capture_output=True, text=True, check=True)
    return done.stdout.splitlines()


class Held:
    """What was held against the truth."""

    def __init__(self):
        self.moves = self.reached = self.by_ocl = self.grazes = 0
        self.outside, self.widths = [], []


def hold_floors(held, asked, text, deep, side, answers):
    outer, inner, upper, least = np.array([line.split() for line in answers], dtype=float).T
    by_samples, apart = asked.least(SAMPLES)
    by_ocl = dropped(asked)
    use = np.isfinite(by_ocl)
    held.by_ocl += int(use.sum())
    grazes = np.abs(apart - asked.tool[:, 0] / 2) < GRAZES
    held.grazes += int(grazes.sum())

    def outside(floor, which, same):
        left = np.clip(floor, -deep[which], deep[which])
        wrong = (inner[which] > left + same) | (outer[which] < left - same)
        reached = np.isfinite(floor)
        wrong |= reached & ((least[which] > floor + same) | (upper[which] < floor - same))
        # The lower bound of what is not reached says nothing; an upper bound there would be wrong.
        return wrong | (~reached & np.isfinite(upper[which]))

    everything = np.arange(len(answers))
    wrong = outside(by_samples, everything, SAME["samples"]) & ~grazes
    wrong_by_ocl = use & outside(np.where(use, by_ocl, by_samples), everything, SAME["opencamlib"]) & ~grazes
    for n in np.flatnonzero(wrong | wrong_by_ocl):
        dense, _ = asked.some([n]).least(DENSE)
        is_wrong = outside(dense, np.array([n]), SAME["samples"])[0]
        if is_wrong or wrong_by_ocl[n]:
            held.outside.append((text[n].tolist(), asked.place[n].tolist(), dense[0], by_ocl[n], answers[n]))
    reached = np.isfinite(by_samples)
    held.reached += int(reached.sum())
    is_known = reached & np.isfinite(upper) & (by_samples > -deep) & (by_samples < deep)
    held.widths.append(((outer - inner) / side)[is_known])


def hold_spans(held, asked, text, side, answers):
    gap, apart = asked.least(SAMPLES)
    grazes = np.abs(apart - asked.tool[:, 0] / 2) < GRAZES
    held.grazes += int(grazes.sum())
    held.reached += int(np.isfinite(gap).sum())

    def spans(part):
        numbers = [float(word) for word in part.split()]
        return list(zip(numbers[::2], numbers[1::2]))

    def is_outside(n, gap):
        surely, maybe = (spans(part) for part in answers[n].split("|"))
        level = asked.level[n]
        within = lambda some, less: any(floor + less < level < top - less for floor, top in some)
        same = SAME["samples"]
        # Removed, and said to be left; or left, and said to be removed.
        return gap <= -same and not within(maybe, -same) or gap > same and within(surely, same)

    for n in np.flatnonzero(~grazes):
        if is_outside(n, gap[n]):
            dense, _ = asked.some([n]).least(DENSE)
            if is_outside(n, dense[0]):
                held.outside.append((text[n].tolist(), asked.place[n].tolist(), asked.level[n], dense[0], answers[n]))
    known = [(spans(part[0]), spans(part[1])) for part in (line.split("|") for line in answers)]
    widths = [
        sum(top - floor for floor, top in maybe) - sum(top - floor for floor, top in surely)
        for surely, maybe in known if len(surely) == len(maybe) == 1
    ]
    sides = [side[n] for n, (surely, maybe) in enumerate(known) if len(surely) == len(maybe) == 1]
    held.widths.append(np.array(widths) / np.array(sides) / 2)


def main():
    program = sys.argv[1]
    total = int(sys.argv[2]) if len(sys.argv) > 2 else 1_000_000
    rng = np.random.default_rng(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
    only = sys.argv[4] if len(sys.argv) > 4 else None
    shapes = [(n, name) for n, name in enumerate(SHAPES) if only in (None, name)]
    each = math.ceil(total / (len(shapes) * len(KINDS)))
    outside = 0
    print("tool        move      moves  reached  by ocl  at the rim  outside  width / side: median, 90 %")
    for shape, name in shapes:
        for kind, of in enumerate(KINDS):
            held = Held()
            while held.moves < each:
                count = min(AT_ONCE, each - held.moves)
                asked, text, deep, side = cases(rng, shape, kind, count)
                answers = ask(program, text)
                assert len(answers) == count
                if shape in UNDERCUTS:
                    hold_spans(held, asked, text, side, answers)
                else:
                    hold_floors(held, asked, text, deep, side, answers)
                held.moves += count
            middle, most = np.quantile(np.concatenate(held.widths), [0.5, 0.9])
            print(f"{name:11} {of:7} {held.moves:7} {held.reached:8} {held.by_ocl:7} {held.grazes:11} "
                  f"{len(held.outside):8}  {middle:.2f}, {most:.2f}", flush=True)
            for case in held.outside[:3]:
                print("    outside:", *case)
            outside += len(held.outside)
    print(f"{each * len(shapes) * len(KINDS)} moves, {outside} outside of their bounds")
    sys.exit(1 if outside else 0)


main()
