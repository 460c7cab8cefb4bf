//! Random programs of what all controls have, through every pair of them: the motion is the same.
//!
//! `CHORDAL_ROUNDS` sets how many.

use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

use super::{MACHINES, converted, job, machine, verdict};

/// A block, before it is written for a control.
#[derive(Clone, Debug)]
pub(super) enum RandomBlock {
    Rapid([i32; 3], u8),
    Line([i32; 3], u8, Option<u16>),
    /// Quarter turns from 1 to 4 of an arc of a radius, and a rise.
    Arc {
        quarters: u8,
        radius: i32,
        ccw: bool,
        rise: i32,
        by_r: bool,
        first: u8,
    },
    Plane(u8),
    Incremental(bool),
    Feed(u16),
    Offset(u8),
    Tool(u8),
    Dwell(u16),
    Coolant(u8),
    Drill {
        depth: i32,
        holes: Vec<[i32; 2]>,
        pick: u8,
    },
    Call(u8, u8),
    Repeat([i32; 3], u8),
    Comment,
    Exact(bool),
    /// A square of a size with the tool beside it.
    Contour {
        size: i32,
        left: bool,
        round: bool,
    },
    /// Up to the reference point.
    Home,
    /// Whole inches without a point.
    Bare(i8),
    /// Where the control has one: turns, from a radius to another.
    Spiral {
        turns: u8,
        from: i32,
        to: i32,
        ccw: bool,
    },
    /// A line on which A turns to so many tenths of a degree.
    Turn([i32; 3], i16),
    /// A line in so many seconds.
    Inverse([i32; 3], u8),
    /// Places from variables: a value, and twice a value plus a half.
    Variables(i32, i32),
    /// Lines in a loop by a variable.
    Loop([i32; 3], u8),
    /// A jump over a line, if a variable is above a value.
    Jump(i32, i32),
    Peck {
        depth: i32,
        step: i32,
        broken: bool,
        hole: [i32; 2],
    },
    Tap {
        depth: i32,
        back: bool,
        holes: Vec<[i32; 2]>,
    },
}

fn place() -> impl Strategy<Value = [i32; 3]> {
    prop::array::uniform3(-20_000..20_000i32)
}

pub(super) fn piece() -> impl Strategy<Value = RandomBlock> {
    let arc = (1..=4u8, 500..30_000i32, any::<bool>(), -5_000..5_000i32, any::<bool>(), 0..4u8);
    let holes = prop::collection::vec(prop::array::uniform2(-20_000..20_000i32), 1..4);
    let taps = prop::collection::vec(prop::array::uniform2(-20_000..20_000i32), 1..3);
    prop_oneof![
        3 => (place(), 1..8u8).prop_map(|(to, axes)| RandomBlock::Rapid(to, axes)),
        6 => (place(), 1..8u8, prop::option::of(1..400u16))
            .prop_map(|(to, axes, feed)| RandomBlock::Line(to, axes, feed)),
        6 => arc.prop_map(|(quarters, radius, ccw, rise, by_r, first)| RandomBlock::Arc {
            quarters, radius, ccw, rise, by_r, first
        }),
        1 => (0..3u8).prop_map(RandomBlock::Plane),
        2 => any::<bool>().prop_map(RandomBlock::Incremental),
        1 => (1..400u16).prop_map(RandomBlock::Feed),
        1 => (1..9u8).prop_map(RandomBlock::Offset),
        1 => (1..9u8).prop_map(RandomBlock::Tool),
        1 => (1..3000u16).prop_map(RandomBlock::Dwell),
        1 => (0..3u8).prop_map(RandomBlock::Coolant),
        1 => (1_000..20_000i32, holes, 0..2u8)
            .prop_map(|(depth, holes, pick)| RandomBlock::Drill { depth, holes, pick }),
        2 => (0..3u8, 1..4u8).prop_map(|(sub, times)| RandomBlock::Call(sub, times)),
        1 => (place(), 2..4u8).prop_map(|(way, times)| RandomBlock::Repeat(way, times)),
        1 => Just(RandomBlock::Comment),
        1 => any::<bool>().prop_map(RandomBlock::Exact),
        2 => (10_000..40_000i32, any::<bool>(), any::<bool>())
            .prop_map(|(size, left, round)| RandomBlock::Contour { size, left, round }),
        1 => Just(RandomBlock::Home),
        1 => (-5..5i8).prop_map(RandomBlock::Bare),
        1 => (1..4u8, 2_000..9_000i32, 12_000..20_000i32, any::<bool>())
            .prop_map(|(turns, from, to, ccw)| RandomBlock::Spiral { turns, from, to, ccw }),
        1 => (place(), -1800..1800i16).prop_map(|(to, angle)| RandomBlock::Turn(to, angle)),
        1 => (place(), 1..60u8).prop_map(|(to, seconds)| RandomBlock::Inverse(to, seconds)),
        1 => (-9000..9000i32, -9000..9000i32).prop_map(|(a, b)| RandomBlock::Variables(a, b)),
        1 => (place(), 1..4u8).prop_map(|(way, times)| RandomBlock::Loop(way, times)),
        1 => (-9000..9000i32, -9000..9000i32).prop_map(|(a, b)| RandomBlock::Jump(a, b)),
        1 => (3_000..20_000i32, 500..9_000i32, any::<bool>(), prop::array::uniform2(-20_000..20_000i32))
            .prop_map(|(depth, step, broken, hole)| RandomBlock::Peck { depth, step, broken, hole }),
        1 => (1_000..9_000i32, any::<bool>(), taps)
            .prop_map(|(depth, back, holes)| RandomBlock::Tap { depth, back, holes }),
    ]
}

/// A writer of programs in the words of one control.
struct Writer {
    control: &'static str,
    at: [i32; 3],
    plane: u8,
    incremental: bool,
    /// Labels of loops and jumps, each used once.
    labels: u32,
    lines: Vec<String>,
}

/// Ten-thousandths of an inch with a point.
fn number(value: i32) -> String {
    let text = format!("{:.4}", f64::from(value) / 10_000.0);
    text.trim_end_matches('0').to_string()
}

impl Writer {
    fn axes(&self) -> (usize, usize, usize) {
        [(0, 1, 2), (2, 0, 1), (1, 2, 0)][self.plane as usize]
    }

    fn words(&mut self, to: [i32; 3], mask: u8) -> String {
        let mut text = String::new();
        for axis in 0..3 {
            if mask & (1 << axis) == 0 {
                continue;
            }
            let value = if self.incremental { to[axis] - self.at[axis] } else { to[axis] };
            text += &format!(" {}{}", ['X', 'Y', 'Z'][axis], number(value));
            self.at[axis] = to[axis];
        }
        text
    }

    fn piece(&mut self, piece: &RandomBlock, in_sub: bool) {
        let line = match piece {
            RandomBlock::Rapid(to, mask) => format!("G0{}", self.words(*to, *mask)),
            RandomBlock::Line(to, mask, feed) => {
                let feed = feed.map_or_else(String::new, |feed| format!(" F{feed}."));
                format!("G1{}{feed}", self.words(*to, *mask))
            }
            RandomBlock::Arc { quarters, radius, ccw, rise, by_r, first } => {
                self.arc(*quarters, *radius, *ccw, *rise, *by_r, *first)
            }
            RandomBlock::Plane(plane) => {
                self.plane = *plane;
                format!("G{}", 17 + plane)
            }
            RandomBlock::Incremental(on) => {
                self.incremental = *on;
                format!("G{}", 90 + u8::from(*on))
            }
            RandomBlock::Feed(feed) => format!("F{feed}."),
            RandomBlock::Offset(number) => match (self.control, *number) {
                ("fadal-4020", number) => format!("G0 E{number}"),
                (_, number @ 1..=6) => format!("G{}", 53 + number),
                ("haas-vf2", number) => format!("G154 P{}", number - 6),
                ("linuxcnc-mill", number) => format!("G59.{}", number - 6),
                (_, number) => format!("G54.1 P{}", number - 6),
            },
            RandomBlock::Tool(number) if !in_sub => {
                self.lines.push(format!("T{number} M6"));
                let length = if self.control == "fadal-4020" { "" } else { "G43 " };
                self.lines.push(format!("S{}00 M3", number + 4));
                format!("{length}H{number}")
            }
            RandomBlock::Tool(_) => return,
            RandomBlock::Dwell(ms) => match self.control {
                "linuxcnc-mill" => format!("G4 P{}", f64::from(*ms) / 1000.0),
                _ => format!("G4 P{ms}"),
            },
            RandomBlock::Coolant(kind) => ["M7", "M8", "M9"][*kind as usize].into(),
            RandomBlock::Drill { .. } if self.incremental || self.plane != 0 => return,
            RandomBlock::Drill { depth, holes, pick } => return self.drill(*depth, holes, *pick),
            RandomBlock::Call(..) if in_sub => return,
            RandomBlock::Call(sub, times) => match self.control {
                "fadal-4020" => format!("L{}{:02}", sub + 1, times),
                "haas-vf2" => format!("M97 P{} L{times}", 1000 + u32::from(*sub)),
                _ => format!("M98 P{} L{times}", 2000 + u32::from(*sub)),
            },
            RandomBlock::Repeat(..) if !self.incremental || in_sub => return,
            RandomBlock::Repeat(way, times) => {
                for (at, way) in self.at.iter_mut().zip(way) {
                    *at += way / 10 * i32::from(*times);
                }
                let words = [0, 1, 2].map(|axis: usize| {
                    format!(" {}{}", ['X', 'Y', 'Z'][axis], number(way[axis] / 10))
                });
                let count =
                    if has_repeats(self.control) { format!(" L{times}") } else { String::new() };
                let line = format!("G1{}{count}", words.concat());
                if !has_repeats(self.control) {
                    for _ in 1..*times {
                        self.lines.push(line.clone());
                    }
                }
                line
            }
            RandomBlock::Comment => "(A REMARK)".into(),
            RandomBlock::Contour { .. } | RandomBlock::Home | RandomBlock::Spiral { .. }
                if in_sub =>
            {
                return;
            }
            RandomBlock::Contour { .. } | RandomBlock::Spiral { .. }
                if self.incremental || self.plane != 0 =>
            {
                return;
            }
            RandomBlock::Contour { size, left, round } => {
                return self.contour(*size, *left, *round);
            }
            RandomBlock::Home => {
                self.lines.push("G91 G28 Z0".into());
                self.incremental = false;
                self.lines.push("G90 G0 Z2.".into());
                self.at[2] = 20_000;
                return;
            }
            RandomBlock::Bare(inches) => {
                let whole = matches!(self.control, "fadal-4020" | "linuxcnc-mill");
                let written = i32::from(*inches) * if whole { 1 } else { 10_000 };
                let inches = i32::from(*inches) * 10_000;
                self.at[0] = if self.incremental { self.at[0] + inches } else { inches };
                format!("G1 X{written}")
            }
            RandomBlock::Spiral { turns, from, to, ccw } => {
                let code = if *ccw { 3 } else { 2 };
                let end = self.at[0] - from + to;
                let (x, i) = (number(end), number(-from));
                self.at[0] = end;
                match self.control {
                    "mitsubishi-m700" => format!("G{code}.1 X{x} I{i} J0 P{turns}"),
                    "fanuc-30i" => format!("G{code} X{x} I{i} J0 L{turns}"),
                    _ => format!("G1 X{x}"),
                }
            }
            RandomBlock::Turn(to, angle) => {
                let words = self.words(*to, 7);
                format!("G1{words} A{:.1}", f64::from(*angle) / 10.0)
            }
            RandomBlock::Inverse(to, seconds) => {
                let words = self.words(*to, 7);
                self.lines.push("G93".into());
                self.lines.push(format!("G1{words} F{:.4}", 60.0 / f64::from(*seconds)));
                "G94 F20.".into()
            }
            RandomBlock::Variables(..) | RandomBlock::Loop(..) | RandomBlock::Jump(..)
                if in_sub =>
            {
                return;
            }
            RandomBlock::Variables(..) | RandomBlock::Jump(..) if self.incremental => return,
            RandomBlock::Variables(one, two) => return self.variables(*one, *two),
            RandomBlock::Loop(..) if !self.incremental => return,
            RandomBlock::Loop(way, times) => return self.repeated(*way, *times),
            RandomBlock::Jump(one, two) => return self.jump(*one, *two),
            RandomBlock::Peck { .. } | RandomBlock::Tap { .. }
                if self.incremental || self.plane != 0 =>
            {
                return;
            }
            RandomBlock::Peck { depth, step, broken, hole } => {
                return self.peck(*depth, *step, *broken, *hole);
            }
            RandomBlock::Tap { .. } if in_sub => return,
            RandomBlock::Tap { depth, back, holes } => return self.tap(*depth, *back, holes),
            RandomBlock::Exact(on) => match (self.control, on) {
                ("fadal-4020", true) => "G9".into(),
                ("fadal-4020", false) => "G8".into(),
                ("linuxcnc-mill", true) => "G61.1".into(),
                (_, true) => "G61".into(),
                (_, false) => "G64".into(),
            },
        };
        // What was read as an arc without an end, or a move without words, is none.
        if line != "G0" && line != "G1" {
            self.lines.push(line);
        }
    }

    fn arc(
        &mut self,
        quarters: u8,
        radius: i32,
        ccw: bool,
        rise: i32,
        by_r: bool,
        first: u8,
    ) -> String {
        let (a, b, c) = self.axes();
        const TURN: [[i32; 2]; 4] = [[1, 0], [0, 1], [-1, 0], [0, -1]];
        // From the centre to the start, and to the end.
        let from = TURN[first as usize];
        let step = if ccw { usize::from(quarters) } else { 16 - usize::from(quarters) };
        let to = TURN[(first as usize + step) % 4];
        let center = [self.at[a] - from[0] * radius, self.at[b] - from[1] * radius];
        let mut end = self.at;
        end[a] = center[0] + to[0] * radius;
        end[b] = center[1] + to[1] * radius;
        end[c] += rise;
        let code = if ccw { "G3" } else { "G2" };
        let (i, j) = (['I', 'J', 'K'][a], ['I', 'J', 'K'][b]);
        let way = [center[0] - self.at[a], center[1] - self.at[b]];
        let full = quarters == 4;
        let mask = if full { 1 << c } else { 7 };
        let mask = if rise == 0 { mask & !(1 << c) } else { mask };
        let words = self.words(end, mask);
        self.at = end;
        if by_r && !full && quarters != 2 {
            let sign = if quarters == 3 { "-" } else { "" };
            let registers = self.control == "fadal-4020";
            let plus = if registers && sign.is_empty() { "+" } else { sign };
            let r = if registers { format!("R0{plus}") } else { format!("R{sign}") };
            return format!("{code}{words} {r}{}", number(radius));
        }
        let mut centers = String::new();
        for (letter, value) in [(i, way[0]), (j, way[1])] {
            if value != 0 {
                centers += &format!(" {letter}{}", number(value));
            }
        }
        format!("{code}{words}{centers}")
    }

    /// Beside a square, or a circle, and back.
    fn contour(&mut self, size: i32, left: bool, round: bool) {
        let [x, y, _] = self.at;
        let way = |dx: i32, dy: i32| format!(" X{} Y{}", number(x + dx), number(y + dy));
        let side = if left { 41 } else { 42 };
        let sign = if left { 1 } else { -1 };
        self.lines.push(format!("G1 G{side} D1{}", way(size, 0)));
        self.lines.push(format!("G1{}", way(size, -sign * size / 2)));
        if round {
            // A turn about a centre that is away from the tool.
            let code = if left { "G2" } else { "G3" };
            self.lines.push(format!("{code} I{}", number(-size / 4)));
        }
        self.lines.push(format!("G1{}", way(size, -sign * size)));
        self.lines.push(format!("G1{}", way(-size, -sign * size)));
        self.lines.push(format!("G1 G40{}", way(-2 * size, -sign * size)));
        self.at = [x - 2 * size, y - sign * size, self.at[2]];
    }

    fn label(&mut self) -> u32 {
        self.labels += 1;
        self.labels
    }

    fn variables(&mut self, one: i32, two: i32) {
        let (a, b) = (number(one), number(two));
        self.lines.extend(match self.control {
            "fadal-4020" => {
                vec![
                    format!("# V1={a}"),
                    format!("# R1=V1"),
                    format!("# R2={b}*2+.5"),
                    "G1 X+R1 Y+R2".into(),
                ]
            }
            _ => vec![format!("#101={a}"), format!("G1 X#101 Y[{b}*2+.5]")],
        });
        (self.at[0], self.at[1]) = (one, 2 * two + 5000);
    }

    /// Lines in a loop.
    fn repeated(&mut self, way: [i32; 3], times: u8) {
        let words = [0, 1, 2]
            .map(|axis: usize| format!(" {}{}", ['X', 'Y', 'Z'][axis], number(way[axis] / 10)));
        let line = format!("G1{}", words.concat());
        let label = self.label();
        let [head, foot] = match self.control {
            "fadal-4020" => [
                vec![format!("#:LOOP{label}")],
                vec!["# V2=V2+1".into(), format!("# IF V2<{times} THEN GOTO :LOOP{label}")],
            ],
            "linuxcnc-mill" => [
                vec![format!("o{label} while [#102 LT {times}]")],
                vec!["#102=[#102+1]".into(), format!("o{label} endwhile")],
            ],
            _ => [
                vec![format!("WHILE [#102 LT {times}] DO1")],
                vec!["#102=#102+1".into(), "END1".into()],
            ],
        };
        self.lines.push(if self.control == "fadal-4020" { "# V2=0" } else { "#102=0" }.into());
        self.lines.extend(head);
        self.lines.push(line);
        self.lines.extend(foot);
        for (at, way) in self.at.iter_mut().zip(way) {
            *at += way / 10 * i32::from(times);
        }
    }

    fn jump(&mut self, one: i32, two: i32) {
        let (a, b) = (number(one), number(two));
        let label = 500 + self.label();
        let line = format!("G1 X{a} Y{b}");
        self.lines.extend(match self.control {
            "fadal-4020" => vec![
                format!("# V3={a}"),
                format!("# IF V3>{b} THEN GOTO :SKIP{label}"),
                line,
                format!("#:SKIP{label}"),
            ],
            "linuxcnc-mill" => vec![
                format!("#103={a}"),
                format!("o{label} if [#103 LE {b}]"),
                line,
                format!("o{label} endif"),
            ],
            _ => vec![
                format!("#103={a}"),
                format!("IF [#103 GT {b}] GOTO{label}"),
                line,
                format!("N{label}"),
            ],
        });
        if one <= two {
            (self.at[0], self.at[1]) = (one, two);
        }
    }

    fn peck(&mut self, depth: i32, step: i32, broken: bool, hole: [i32; 2]) {
        let level = 20_000;
        let r = if self.control == "fadal-4020" { "R0+" } else { "R" };
        let code = if broken { "G73" } else { "G83" };
        self.lines.push(format!("G0 Z{}", number(level + 5_000)));
        self.lines.push(format!(
            "{code} G98 X{} Y{} Z{} {r}{} Q{} F9.",
            number(hole[0]),
            number(hole[1]),
            number(level - depth),
            number(level),
            number(step)
        ));
        self.lines.push("G80".into());
        self.lines.push(format!("G0 Z{}", number(level + 5_000)));
        self.at = [hole[0], hole[1], level + 5_000];
    }

    /// Holes of a lead of a twentieth of an inch.
    fn tap(&mut self, depth: i32, back: bool, holes: &[[i32; 2]]) {
        let level = 20_000;
        let (r, lead) = match self.control {
            "fadal-4020" => ("R0+", "F200. Q.05"),
            _ => ("R", "F10."),
        };
        self.lines.push(format!("G0 Z{}", number(level + 5_000)));
        self.lines.push("S200 M3".into());
        // LinuxCNC feeds out as far as it returns: to R is what all can do.
        let code = if back && self.control != "linuxcnc-mill" { "G98" } else { "G99" };
        for (index, hole) in holes.iter().enumerate() {
            let place = format!("X{} Y{}", number(hole[0]), number(hole[1]));
            self.lines.push(match index {
                0 => format!(
                    "G84 {code} {place} Z{} {r}{} {lead}",
                    number(level - depth),
                    number(level)
                ),
                _ => place,
            });
        }
        self.lines.push("G80".into());
        self.lines.push(format!("G0 Z{} F20.", number(level + 5_000)));
        let last = holes[holes.len() - 1];
        self.at = [last[0], last[1], level + 5_000];
    }

    fn drill(&mut self, depth: i32, holes: &[[i32; 2]], pick: u8) {
        let level = 20_000;
        self.lines.push(format!("G0 Z{}", number(level + 5_000)));
        let r = if self.control == "fadal-4020" { "R0+" } else { "R" };
        let code = ["G81 G99", "G82 G98"][pick as usize];
        let dwell = match (pick, self.control) {
            (0, _) => "",
            (_, "linuxcnc-mill") => " P0.2",
            _ => " P200",
        };
        for (index, hole) in holes.iter().enumerate() {
            let place = format!("X{} Y{}", number(hole[0]), number(hole[1]));
            self.lines.push(match index {
                0 => format!(
                    "{code} {place} Z{} {r}{}{dwell} F9.",
                    number(level - depth),
                    number(level)
                ),
                _ => place,
            });
        }
        self.lines.push("G80".into());
        self.lines.push(format!("G0 Z{}", number(level + 5_000)));
        let last = holes[holes.len() - 1];
        self.at = [last[0], last[1], level + 5_000];
    }
}

fn has_repeats(control: &str) -> bool {
    matches!(control, "fadal-4020" | "haas-vf2")
}

/// A program and its three subprograms in the words of a control.
pub(super) fn program(
    control: &'static str,
    main: &[RandomBlock],
    subs: &[Vec<RandomBlock>],
) -> String {
    let body = |pieces: &[RandomBlock], in_sub: bool| {
        let mut writer = Writer {
            control,
            at: [0; 3],
            plane: 0,
            incremental: in_sub,
            labels: 0,
            lines: Vec::new(),
        };
        for piece in pieces {
            writer.piece(piece, in_sub);
        }
        writer.lines
    };
    // Subprograms begin and end in increments of XY, whatever calls them: their motion adds up.
    let sub = |pieces: &[RandomBlock]| {
        let keeps = |piece: &&RandomBlock| {
            !matches!(
                piece,
                RandomBlock::Incremental(_) | RandomBlock::Plane(_) | RandomBlock::Offset(_)
            )
        };
        let pieces: Vec<RandomBlock> = pieces.iter().filter(keeps).cloned().collect();
        let mut lines = vec!["G17 G91".to_string()];
        lines.extend(body(&pieces, true));
        lines.push("G90".into());
        lines
    };
    let mut lines = Vec::new();
    let begin = ["G20 G17 G90 G40 G80", "T1 M6", "S1000 M3", "G0 X0 Y0 Z0", "G1 F20."];
    let mut main_lines: Vec<String> = begin.map(String::from).to_vec();
    // Labels of the chain after begin from one.
    let mut labels = 100;
    for piece in main {
        let mut writer =
            Writer { control, at: [0; 3], plane: 0, incremental: false, labels, lines: Vec::new() };
        // Each piece begins where everything is known, so that calls may stand between them.
        writer.lines.push("G17 G90".into());
        writer.lines.push("G1 X0 Y0 Z0".into());
        if matches!(piece, RandomBlock::Repeat(..) | RandomBlock::Loop(..)) {
            writer.piece(&RandomBlock::Incremental(true), false);
        }
        writer.piece(piece, false);
        labels = writer.labels;
        main_lines.extend(writer.lines);
    }
    let chain = body(main, false);
    main_lines.push("G17 G90".into());
    main_lines.push("G0 X0 Y0 Z0".into());
    // Calls leave the tool elsewhere; what is written for known places goes without them.
    let calls = ["L", "M97", "M98"];
    main_lines.extend(chain.into_iter().filter(|line| !calls.iter().any(|c| line.starts_with(c))));
    match control {
        "fadal-4020" => {
            for (index, pieces) in subs.iter().enumerate() {
                lines.push(format!("L{}00", index + 1));
                lines.extend(sub(pieces));
                lines.push("M17".into());
            }
            lines.push("M30".into());
            lines.extend(main_lines);
            lines.push("M2".into());
        }
        "haas-vf2" => {
            lines.push("O00100".into());
            lines.extend(main_lines);
            lines.push("M30".into());
            for (index, pieces) in subs.iter().enumerate() {
                let mut sub = sub(pieces);
                sub[0] = format!("N{} {}", 1000 + index, sub[0]);
                lines.extend(sub);
                lines.push("M99".into());
            }
        }
        _ => {
            lines.push("O100".into());
            lines.extend(main_lines);
            lines.push("M30".into());
            for (index, pieces) in subs.iter().enumerate() {
                lines.push(format!("O{}", 2000 + index));
                lines.extend(sub(pieces));
                lines.push("M99".into());
            }
        }
    }
    lines.join("\n") + "\n"
}

#[test]
fn random_programs_through_every_pair() {
    #[allow(clippy::disallowed_methods, reason = "the number of rounds")]
    let rounds = std::env::var("CHORDAL_ROUNDS").ok().and_then(|text| text.parse().ok());
    let config =
        Config { cases: rounds.unwrap_or(12), failure_persistence: None, ..Config::default() };
    let mut runner = TestRunner::new(config);
    let pieces = || prop::collection::vec(piece(), 1..9);
    let strategy = (pieces(), prop::collection::vec(pieces(), 3..4));
    let result = runner.run(&strategy, |(main, subs)| {
        // Programs that nothing calls would be programs of their own.
        let mut main = main;
        main.extend((0..3).map(|sub| RandomBlock::Call(sub, 1)));
        for from in MACHINES {
            let text = program(from, &main, &subs);
            let mut own = machine(from);
            // Wide limits: the programs go where they like.
            own.axes.iter_mut().flatten().for_each(|axis| axis.travel = None);
            own.feed = Default::default();
            own.set("tools.1.diameter=\"0.1 in\"").expect("a good assignment");
            let old = job(&text, own);
            if old.check().counts.errors > 0 {
                let told = old.check().diagnostics.into_iter().map(|one| one.message);
                prop_assert!(false, "{from}: {:?}\n{text}", told.collect::<Vec<_>>());
            }
            for to in MACHINES {
                let found = converted(&old, to);
                prop_assert!(
                    found.holds(),
                    "{from} to {to}: {}\n{text}\n====\n{}",
                    verdict(&found),
                    found.text
                );
            }
        }
        Ok(())
    });
    result.expect("every program proved on every control");
}
