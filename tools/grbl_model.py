"""The rules of GRBL 1.1h, a second time: what it answers to a block, and where the machine is then.

Written from the rules without reading Chordal's code for them, so that check_grbl.py compares two independent readings. The order
of the checks in a block is that of the firmware. Numbers have 24 bits, and each operation rounds as the firmware's does.
"""
import copy
import math
import struct

AXES = "XYZ"
CENTRE = {"X": "I", "Y": "J", "Z": "K"}
# First and second axis of a plane.
PLANES = {17: "XY", 18: "ZX", 19: "YZ"}
LINE_LENGTH, DIGITS, SYSTEMS = 79, 8, 6
LARGEST_N, LARGEST_T = 10_000_000, 255

# Codes in hundredths and their group: two of a group are error:21.
GROUPS = {
    ("G", "motion"): [0, 100, 200, 300, 3820, 3830, 3840, 3850, 8000],
    ("G", "once"): [400, 1000, 2800, 2810, 3000, 3010, 5300, 9200, 9210],
    ("G", "plane"): [1700, 1800, 1900],
    ("G", "distance"): [9000, 9100],
    ("G", "centres"): [9110],
    ("G", "feed"): [9300, 9400],
    ("G", "units"): [2000, 2100],
    ("G", "compensation"): [4000],
    ("G", "length"): [4310, 4900],
    ("G", "system"): [5400, 5500, 5600, 5700, 5800, 5900],
    ("G", "path"): [6100],
    ("M", "stop"): [0, 100, 200, 3000],
    ("M", "spindle"): [300, 400, 500],
    ("M", "coolant"): [800, 900],
}
GROUP_OF = {(letter, code): group for (letter, group), codes in GROUPS.items() for code in codes}
WHOLE = {(letter, code // 100) for letter, code in GROUP_OF}
# A fraction that is not known is error:20 with these, and error:23 with the others.
WITH_VARIANTS = {28, 30, 38, 43, 61, 90, 91, 92}
# Codes that use the axis words; only one of them in a block. Of the codes for one block, those without fraction.
USERS = {
    0: "motion", 1: "motion", 2: "motion", 3: "motion", 38: "motion", 10: "once", 28: "once", 30: "once", 92: "once",
    43: "length", 49: "length",
}


class Refused(Exception):
    """The number of the error that answers a block."""

    def __init__(self, number):
        super().__init__(f"error:{number}")
        self.number = number


def single(value):
    """Nearest number of 24 bits. One operation of two such numbers in double precision, then this, rounds but once."""
    return struct.unpack("f", struct.pack("f", value))[0]


INCH = single(25.4)


def refuse_if(condition, number):
    if condition:
        raise Refused(number)


def filtered(line):
    """The characters of a line that the parser gets."""
    kept, comment = "", ""
    for character in line:
        if comment:
            if comment == "(" and character == ")":
                comment = ""
        elif character in "(;":
            comment = character
        elif character > " " and character != "/":
            refuse_if(len(kept) == LINE_LENGTH, 11)
            kept += character.upper()
    return kept


def number_at(text, at):
    """A number, and where it ends. Only so many digits count; later ones before the point scale by ten."""
    sign, digits, exponent, counted, point = 1.0, 0, 0, 0, False
    if at < len(text) and text[at] in "+-":
        sign = -1.0 if text[at] == "-" else 1.0
        at += 1
    while at < len(text):
        if text[at] in "0123456789":
            counted += 1
            if counted <= DIGITS:
                digits = 10 * digits + int(text[at])
                exponent -= point
            else:
                exponent += not point
        elif text[at] == "." and not point:
            point = True
        else:
            break
        at += 1
    refuse_if(counted == 0, 2)
    return sign * scaled(digits, exponent), at


def scaled(digits, exponent):
    """As the firmware scales: by hundredths, then by a tenth or by tens, each product of 24 bits."""
    value = single(digits)
    while exponent <= -2:
        value, exponent = single(value * single(0.01)), exponent + 2
    if exponent == -1:
        value, exponent = single(value * single(0.1)), 0
    for _ in range(exponent):
        value = single(value * 10.0)
    return value


def words(text):
    at = 0
    while at < len(text):
        letter = text[at]
        refuse_if(not "A" <= letter <= "Z", 1)
        value, at = number_at(text, at + 1)
        yield letter, value


class Block:
    """What is written in one block: codes by group, values by letter, and who uses the axis words."""

    def __init__(self, text):
        self.codes, self.values, self.user, self.segments = {}, {}, None, None
        for letter, value in words(text):
            if letter in "GM":
                self.take_code(letter, value)
            else:
                self.take_value(letter, value)
        self.unused = set(self.values)
        self.axes = [axis for axis in AXES if axis in self.values]
        self.once = self.codes.get("once")
        if self.axes and not self.user:
            self.user = "motion"

    def take_code(self, letter, value):
        whole = math.trunc(value)
        # Half away from zero.
        hundredths = math.floor(abs(single(100.0 * single(value - whole))) + 0.5)
        refuse_if(letter == "M" and hundredths, 23)
        refuse_if((letter, whole) not in WHOLE, 20)
        if letter == "G":
            self.take_axes(whole, hundredths)
        # Any fraction of G49 passes.
        code = 100 * whole + (0 if whole == 49 else hundredths)
        if (letter, code) not in GROUP_OF or hundredths >= 100:
            raise Refused(20 if whole in WITH_VARIANTS else 23)
        group = GROUP_OF[letter, code]
        refuse_if(group in self.codes, 21)
        self.codes[group] = code

    def take_axes(self, whole, hundredths):
        user = USERS.get(whole)
        if user and not (user == "once" and hundredths):
            refuse_if(self.user, 24)
            self.user = user

    def take_value(self, letter, value):
        refuse_if(letter not in "FIJKLNPRSTXYZ", 20)
        refuse_if(letter == "T" and value > LARGEST_T, 38)
        refuse_if(letter in self.values, 25)
        refuse_if(letter in "FNPST" and value < 0, 4)
        self.values[letter] = value

    def has(self, letter):
        return letter in self.values

    def use(self, letters):
        self.unused -= set(letters)

    def in_mm(self, letters, inch):
        for letter in letters:
            if inch and letter in self.values:
                self.values[letter] = single(self.values[letter] * INCH)


class Control:
    """A GRBL after power-on. Nothing of it changes with a block that is refused."""

    # Without contact G38.2 and G38.4 end in an alarm.
    probe_touches = True

    def __init__(self):
        self.motion, self.plane, self.distance, self.feed_mode, self.inch = 0, 17, 90, 94, False
        self.feed, self.system, self.locked = 0.0, 0, False
        self.position = dict.fromkeys(AXES, 0.0)
        self.systems = [dict.fromkeys(AXES, 0.0) for _ in range(SYSTEMS)]
        self.shift = dict.fromkeys(AXES, 0.0)
        self.length = 0.0
        self.stored = {28: dict.fromkeys(AXES, 0.0), 30: dict.fromkeys(AXES, 0.0)}
        self.segments = None
        # Of the cut of the last block, mm/min; none where F is not of that unit.
        self.cut_feed = None

    def answer(self, line):
        """The number of the error, or 0."""
        after = copy.deepcopy(self)
        after.segments = after.cut_feed = None
        try:
            text = filtered(line)
            if text.startswith("$"):
                refuse_if(not text.startswith("$J="), 3)
                after.jog(Block(text[3:]))
            elif text:
                refuse_if(self.locked, 9)
                after.run(Block(text))
        except Refused as refused:
            return refused.number
        self.__dict__ = after.__dict__
        return 0

    def run(self, block):
        refuse_if(block.values.get("N", 0) > LARGEST_N, 27)
        self.set_units_of_feed(block)
        block.use("NST")
        if block.once == 400:
            refuse_if(not block.has("P"), 28)
            block.use("P")
        self.plane = block.codes.get("plane", 100 * self.plane) // 100
        block.in_mm(AXES, self.inch)
        self.set_length(block)
        if "system" in block.codes:
            self.system = (block.codes["system"] - 5400) // 100
        self.distance = block.codes.get("distance", 100 * self.distance) // 100
        self.act_once(block)
        self.move(block)
        if block.once == 9210:
            # The target of a move in this block still counts from the offset.
            self.shift = dict.fromkeys(AXES, 0.0)
        block.use(AXES if block.axes else "")
        refuse_if(block.unused, 36)
        if block.codes.get("stop") in (200, 3000):
            self.end()

    def set_units_of_feed(self, block):
        """G93, G94, G20, G21 and F: which F counts in this block, and from here on."""
        before, now = self.feed_mode, block.codes.get("feed", 100 * self.feed_mode) // 100
        self.inch = block.codes.get("units", 2000 if self.inch else 2100) == 2000
        motion = self.motion_of(block)
        block.use("F")
        if now == 93:
            cuts = block.user == "motion" and motion not in (0, 8000)
            refuse_if(cuts and not block.has("F"), 22)
            self.feed = block.values.get("F", 0.0)
        elif block.has("F"):
            # F is not known to be of inches in the block that leaves G93.
            self.feed = single(block.values["F"] * INCH) if self.inch and before == 94 else block.values["F"]
        elif before == 93:
            self.feed = 0.0
        self.feed_mode = now

    def motion_of(self, block):
        return block.codes.get("motion", self.motion)

    def set_length(self, block):
        if block.user != "length":
            return
        dynamic = block.codes["length"] == 4310
        refuse_if(dynamic and block.axes != ["Z"], 37)
        self.length = block.values["Z"] if dynamic else 0.0

    def act_once(self, block):
        if block.once == 1000:
            self.write_offsets(block)
        elif block.once == 9200:
            self.set_shift(block)
        elif block.once in (2800, 3000):
            self.target_then_stored(block)
        elif block.once in (2810, 3010):
            self.stored[block.once // 100] = dict(self.position)
        elif block.once == 5300:
            refuse_if(self.motion_of(block) not in (0, 100), 30)

    def write_offsets(self, block):
        refuse_if(not block.axes, 26)
        refuse_if(not block.has("P") and not block.has("L"), 28)
        number = math.trunc(block.values.get("P", 0.0))
        refuse_if(number > SYSTEMS, 29)
        kind = math.trunc(block.values.get("L", 0.0)) % 256
        refuse_if(kind not in (2, 20) or kind == 2 and block.has("R"), 20)
        block.use("LP")
        offsets = self.systems[number - 1 if number else self.system]
        for axis in block.axes:
            value = block.values[axis]
            offsets[axis] = value if kind == 2 else self.without_length(axis, single(single(self.position[axis] - self.shift[axis]) - value))

    def set_shift(self, block):
        refuse_if(not block.axes, 26)
        for axis in block.axes:
            left = single(single(self.position[axis] - self.systems[self.system][axis]) - block.values[axis])
            self.shift[axis] = self.without_length(axis, left)

    def without_length(self, axis, value):
        return single(value - self.length) if axis == "Z" else value

    def target_then_stored(self, block):
        for axis in block.axes or AXES:
            self.position[axis] = self.stored[block.once // 100][axis]

    def target(self, block):
        target = dict(self.position)
        for axis in block.axes:
            value = block.values[axis]
            if block.once == 5300:
                target[axis] = value
            elif self.distance == 91:
                target[axis] = single(value + self.position[axis])
            else:
                target[axis] = single(value + single(self.systems[self.system][axis] + self.shift[axis]))
                if axis == "Z":
                    target[axis] = single(target[axis] + self.length)
        return target

    def move(self, block):
        self.motion = self.motion_of(block)
        if self.motion == 8000:
            refuse_if(block.axes, 31)
            return
        if block.user != "motion":
            return
        refuse_if(self.motion != 0 and self.feed == 0.0, 22)
        refuse_if(self.motion > 100 and not block.axes, 26)
        target = self.target(block)
        if self.motion in (200, 300):
            self.check_arc(block, target)
            self.set_cut_feed()
        elif self.motion == 100:
            self.set_cut_feed()
        elif self.motion >= 3800:
            refuse_if(target == self.position, 33)
            self.locked = not self.probe_touches and self.motion in (3820, 3840)
        self.position = target

    def set_cut_feed(self):
        self.cut_feed = self.feed if self.feed_mode == 94 else None

    def check_arc(self, block, target):
        first, second = PLANES[self.plane]
        refuse_if(first not in block.axes and second not in block.axes, 32)
        x = single(target[first] - self.position[first])
        y = single(target[second] - self.position[second])
        if block.has("R"):
            block.use("R")
            refuse_if(target == self.position, 33)
            block.in_mm("R", self.inch)
            radius = block.values["R"]
            refuse_if(radius_misses(radius, x, y), 34)
            i, j = centre_of_radius(radius, x, y, self.motion == 200)
        else:
            letters = [CENTRE[first], CENTRE[second]]
            refuse_if(not any(block.has(letter) for letter in letters), 35)
            block.use("IJK")
            block.in_mm(letters, self.inch)
            i, j = (block.values.get(letter, 0.0) for letter in letters)
            refuse_if(not on_circle(x, y, i, j), 33)
        self.segments = segments(x, y, i, j, self.motion == 200)

    def jog(self, block):
        modes = self.motion, self.feed, self.feed_mode, self.inch, self.distance
        only = set(block.codes) - {"units", "distance", "once"}
        refuse_if(only or block.once not in (None, 5300) or not block.axes, 16)
        refuse_if(not block.has("F"), 22)
        self.motion, self.feed_mode = 100, 94
        self.run(block)
        self.motion, self.feed, self.feed_mode, self.inch, self.distance = modes

    def end(self):
        self.motion, self.plane, self.distance, self.feed_mode, self.system = 100, 17, 90, 94, 0


def length_of(x, y):
    return single(math.sqrt(single(single(x * x) + single(y * y))))


def radius_misses(radius, x, y):
    left = single(single(4.0 * radius) * radius)
    return single(single(left - single(x * x)) - single(y * y)) < 0.0


def on_circle(x, y, i, j):
    at_start = length_of(i, j)
    at_end = length_of(single(x - i), single(y - j))
    apart = abs(single(at_end - at_start))
    return apart <= single(0.005) or apart <= single(0.5) and apart <= single(single(0.001) * at_start)


def centre_of_radius(radius, x, y, clockwise):
    chord = math.hypot(x, y)
    if chord == 0.0:
        return 0.0, 0.0
    above = math.sqrt(max(0.0, 4.0 * radius * radius - chord * chord)) / chord
    above = above if clockwise == (radius < 0.0) else -above
    return 0.5 * (x - y * above), 0.5 * (y + x * above)


def segments(x, y, i, j, clockwise, tolerance=0.002):
    radius = math.hypot(i, j)
    if 2.0 * radius <= tolerance:
        return 0
    angle = math.atan2(-i * (y - j) + j * (x - i), -i * (x - i) - j * (y - j))
    if clockwise and angle >= -5e-7:
        angle -= 2.0 * math.pi
    elif not clockwise and angle <= 5e-7:
        angle += 2.0 * math.pi
    return math.floor(0.5 * abs(angle) * radius / math.sqrt(tolerance * (2.0 * radius - tolerance)))
