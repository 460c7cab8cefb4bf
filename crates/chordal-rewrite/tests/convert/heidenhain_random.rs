//! Random programs to and from HEIDENHAIN conversational language, there and back.

use chordal::Job;
use chordal_rewrite::convert::{Conversion, ConversionOptions, convert};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

use super::heidenhain::TARGETS;
use super::posted::{RoundTrip, wide, with_lengths};
use super::random::{RandomBlock, piece, program};
use super::{converted, job, verdict};

/// How many programs of each kind.
fn rounds(usual: usize) -> usize {
    #[allow(clippy::disallowed_methods, reason = "the number of rounds")]
    let rounds = std::env::var("CHORDAL_ROUNDS").ok().and_then(|text| text.parse().ok());
    rounds.unwrap_or(usual)
}

/// What became of random programs.
#[derive(Default)]
struct TripCount {
    all: usize,
    there: usize,
    back: usize,
    on: usize,
    refused: Vec<String>,
}

impl TripCount {
    /// To the HEIDENHAIN and back, and on to another machine.
    fn take(&mut self, name: &str, old: &Job, text: &str, next: &str) {
        let trip = RoundTrip::through(old, &wide("heidenhain-mill"));
        let [there, back] = trip.holds();
        self.all += 1;
        self.there += usize::from(there);
        self.back += usize::from(back);
        if !(there && back) {
            self.refused.push(trip.verdict());
        }
        assert!(
            trip.is_proved_or_refused(),
            "{name}: {}\n{text}\n====\n{}\n====\n{}",
            trip.verdict(),
            trip.there.text,
            trip.back.as_ref().map(|back| back.text.as_str()).unwrap_or_default()
        );
        if there {
            let middle = job(&trip.there.text, trip.there.machine.clone());
            self.go_on(name, &converted(&middle, next), &trip.there.text);
        }
    }

    fn go_on(&mut self, name: &str, found: &Conversion, text: &str) {
        self.on += usize::from(found.holds());
        if !found.holds() {
            self.refused.push(format!("on: {}", verdict(found)));
        }
        assert!(
            found.holds() || !found.refusals.is_empty(),
            "{name}: {}\n{text}\n====\n{}",
            verdict(found),
            found.text
        );
    }

    fn finish(mut self, name: &str) {
        self.refused.sort();
        let TripCount { all, there, back, on, refused } = self;
        println!("{name}: {there} of {all} proved, {back} back again, {on} on; {refused:#?}");
        assert!(back * 10 > all * 9, "{name}: {refused:#?}");
    }
}

/// Random programs in the words of a control with three axes, each as a machine and a text.
fn random_text(runner: &mut TestRunner, control: &'static str) -> String {
    let pieces = || prop::collection::vec(piece(), 1..9);
    let strategy = (pieces(), prop::collection::vec(pieces(), 3..4));
    let (mut main, subs) = strategy.new_tree(runner).expect("a program").current();
    main.extend((0..3).map(|sub| RandomBlock::Call(sub, 1)));
    let has_axis = |piece: &RandomBlock| !matches!(piece, RandomBlock::Turn(..));
    main.retain(has_axis);
    let subs: Vec<Vec<RandomBlock>> =
        subs.into_iter().map(|sub| sub.into_iter().filter(has_axis).collect()).collect();
    with_lengths(&program(control, &main, &subs))
}

/// Random word-address programs to conversational ones, back again, and on to the other targets.
#[test]
fn random_programs() {
    let mut runner = TestRunner::default();
    for control in ["fanuc-30i", "haas-vf2", "linuxcnc-mill"] {
        let mut count = TripCount::default();
        for round in 0..rounds(60) {
            let text = random_text(&mut runner, control);
            let old = job(&text, wide(control));
            count.take(control, &old, &text, TARGETS[round % TARGETS.len()]);
        }
        count.finish(control);
    }
}

/// Random part programs: those of a Fanuc, on a Sinumerik.
#[test]
fn random_part_programs() {
    let mut runner = TestRunner::default();
    let mut count = TripCount::default();
    for round in 0..rounds(60) {
        let text = random_text(&mut runner, "fanuc-30i");
        let first = convert(
            &job(&text, wide("fanuc-30i")),
            &wide("sinumerik-mill"),
            &ConversionOptions::default(),
        );
        if first.holds() {
            let old = job(&first.text, first.machine.clone());
            count.take("sinumerik-mill", &old, &first.text, TARGETS[round % TARGETS.len()]);
        }
    }
    count.finish("sinumerik-mill");
}

/// A piece of a conversational program that begins and ends above the part.
#[derive(Clone, Debug)]
enum KlartextPiece {
    /// A contour of four corners, with approach, corners and departure by number.
    Contour { size: [i32; 2], right: bool, approach: u8, corner: u8, departure: u8, depth: i32 },
    /// Holes by a cycle.
    Holes { cycle: u8, count: u8, depth: i32, dwell: bool },
    /// A helix of some turns.
    Helix { turns: u8, radius: i32, up: bool },
    /// A line repeated by a label.
    Repeat { times: u8, step: i32 },
    /// A shift, and a part of it turned.
    Frame { shift: [i32; 2], angle: i32 },
    /// Arcs in other planes.
    OtherPlane { radius: i32, is_zx: bool },
}

fn klartext_piece() -> impl Strategy<Value = KlartextPiece> {
    prop_oneof![
        4 => (prop::array::uniform2(40..90i32), any::<bool>(), 0..7u8, 0..4u8, 0..5u8, 1..9i32)
            .prop_map(|(size, right, approach, corner, departure, depth)| {
                KlartextPiece::Contour { size, right, approach, corner, departure, depth }
            }),
        4 => (0..9u8, 1..5u8, 3..25i32, any::<bool>())
            .prop_map(|(cycle, count, depth, dwell)| KlartextPiece::Holes { cycle, count, depth, dwell }),
        2 => (1..5u8, 8..20i32, any::<bool>())
            .prop_map(|(turns, radius, up)| KlartextPiece::Helix { turns, radius, up }),
        1 => (1..4u8, 1..9i32).prop_map(|(times, step)| KlartextPiece::Repeat { times, step }),
        1 => (prop::array::uniform2(-30..30i32), 0..80i32)
            .prop_map(|(shift, angle)| KlartextPiece::Frame { shift, angle }),
        1 => (3..12i32, any::<bool>())
            .prop_map(|(radius, is_zx)| KlartextPiece::OtherPlane { radius, is_zx }),
    ]
}

impl KlartextPiece {
    /// Its blocks; `label` is used by no other one.
    fn blocks(&self, label: usize) -> Vec<String> {
        match self {
            KlartextPiece::Contour { size, right, approach, corner, departure, depth } => {
                contour(*size, *right, [*approach, *corner, *departure], *depth)
            }
            KlartextPiece::Holes { cycle, count, depth, dwell } => {
                let mut blocks = vec!["L X+10 Y+10 R0 FMAX".to_string(), "L Z+5 FMAX".into()];
                blocks.push(hole_cycle(*cycle, *depth, *dwell));
                blocks.extend((0..*count).map(|at| format!("L X+{} FMAX M99", 10 + 7 * at)));
                blocks.push("L Z+50 R0 FMAX".into());
                blocks
            }
            KlartextPiece::Helix { turns, radius, up } => {
                let (from, rise) = if *up { ("-8", "+2") } else { ("+0", "-2") };
                vec![
                    format!("L X+{radius} Y+0 R0 FMAX"),
                    format!("L Z{from} F200"),
                    "CC X+0 Y+0".into(),
                    format!("CP IPA+{} IZ{rise} DR+ F350", 360 * u32::from(*turns) - 90),
                    "L Z+50 R0 FMAX".into(),
                ]
            }
            KlartextPiece::Repeat { times, step } => vec![
                "L X+0 Y+0 R0 FMAX".into(),
                "L Z-1 F200".into(),
                format!("LBL {label}"),
                format!("L IX+{step} F400"),
                "L IY+2".into(),
                format!("CALL LBL {label} REP {times}"),
                "L Z+50 R0 FMAX".into(),
            ],
            KlartextPiece::Frame { shift: [x, y], angle } => vec![
                format!("CYCL DEF 7.0 DATUM SHIFT"),
                format!("CYCL DEF 7.1 X{x:+}"),
                format!("CYCL DEF 7.2 Y{y:+}"),
                "CYCL DEF 10.0 ROTATION".into(),
                format!("CYCL DEF 10.1 ROT{angle:+}"),
            ],
            KlartextPiece::OtherPlane { radius, is_zx } => {
                let (axis, other) = if *is_zx { ("X", "Y") } else { ("Y", "X") };
                vec![
                    "L X+0 Y+0 R0 FMAX".into(),
                    format!("L {other}+3 Z+0 F200"),
                    format!("CC {axis}+{radius} Z+0"),
                    format!("C {axis}+{} Z+0 DR-", 2 * radius),
                    "L Z+50 R0 FMAX".into(),
                ]
            }
        }
    }
}

/// A contour around a rectangle, or the same way round inside of it.
fn contour(
    [width, height]: [i32; 2],
    right: bool,
    [approach, corner, departure]: [u8; 3],
    depth: i32,
) -> Vec<String> {
    let side = if right { "RR" } else { "RL" };
    let corner = ["", "RND R4", "CHF 3", "RND R2 F200"][usize::from(corner)];
    let first = match approach {
        0 => format!("APPR LT X+0 Y+20 LEN15 {side} F300"),
        1 => format!("APPR LN X+0 Y+20 LEN12 {side} F300"),
        2 => format!("APPR CT X+0 Y+20 CCA90 R+6 {side} F300"),
        3 => format!("APPR LCT X+0 Y+20 R5 {side} F300"),
        4 => format!("APPR CT X+0 Y+20 CCA60 R+15 {side} F300"),
        _ => format!("L X+0 Y+20 {side} F300"),
    };
    let outside = if right { 30 } else { -30 };
    let last = match departure {
        0 => "DEP LT LEN10 F500".to_string(),
        1 => "DEP LN LEN+10 F500".into(),
        2 => "DEP CT CCA90 R+6 F500".into(),
        3 => format!("DEP LCT X{outside:+} Y+30 R5 F500"),
        _ => format!("L X{outside:+} Y+30 R0"),
    };
    let start = if right { 15 } else { -10 };
    let mut blocks = vec![
        format!("L X{outside:+} Y{start:+} R0 FMAX"),
        "L Z+2 FMAX".into(),
        format!("L Z-{depth} F200"),
        first,
        format!("L Y+{height}"),
        corner.into(),
        format!("L X+{width}"),
        corner.into(),
        "L Y+0".into(),
        corner.into(),
        "L X+0".into(),
        "L Y+20".into(),
        last,
        "L Z+50 R0 FMAX".into(),
    ];
    blocks.retain(|block| !block.is_empty());
    blocks
}

/// The definition of a hole cycle.
fn hole_cycle(cycle: u8, depth: i32, dwell: bool) -> String {
    let dwell = if dwell { "0.3" } else { "0" };
    let levels = "Q203=+0 Q204=+20";
    match cycle {
        0 => format!(
            "CYCL DEF 200 DRILLING Q200=2 Q201=-{depth} Q206=150 Q202=40 Q210=0 {levels} Q211={dwell}"
        ),
        1 => format!(
            "CYCL DEF 200 DRILLING Q200=2 Q201=-{depth} Q206=150 Q202=4 Q210=0 {levels} Q211={dwell}"
        ),
        2 => format!(
            "CYCL DEF 201 REAMING Q200=2 Q201=-{depth} Q206=150 Q211={dwell} Q208=300 {levels}"
        ),
        3 => format!(
            "CYCL DEF 203 UNIVERSAL DRILLING Q200=2 Q201=-{depth} Q206=150 Q202=5 Q210=0 {levels} Q212=0.5 Q213=2 Q205=2 Q211={dwell} Q208=500 Q256=0.2"
        ),
        4 => format!(
            "CYCL DEF 205 UNIVERSAL PECKING Q200=2 Q201=-{depth} Q206=150 Q202=5 {levels} Q212=0 Q205=5 Q258=0.5 Q259=0.5 Q257=0 Q256=0 Q211={dwell} Q379=0 Q253=750"
        ),
        5 => format!("CYCL DEF 206 TAPPING Q200=5 Q201=-{depth} Q206=500 Q211={dwell} {levels}"),
        6 => format!("CYCL DEF 207 RIGID TAPPING Q200=5 Q201=-{depth} Q239=+1 {levels}"),
        7 => format!(
            "CYCL DEF 209 TAPPING W/ CHIP BRKG Q200=5 Q201=-{depth} Q239=+1 {levels} Q257=3 Q256=1 Q336=0"
        ),
        _ => format!(
            "CYCL DEF 240 CENTERING Q200=2 Q343=0 Q201=-{depth} Q344=-4 Q206=150 Q211={dwell} {levels}"
        ),
    }
}

/// Random conversational programs to each of the other languages, and back again.
#[test]
fn random_conversational_programs() {
    let mut runner = TestRunner::default();
    let strategy = (prop::collection::vec(klartext_piece(), 1..6), any::<bool>());
    let mut counts = TARGETS.map(|_| [0; 3]);
    let mut refused = Vec::new();
    for _ in 0..rounds(40) {
        let (pieces, inch) = strategy.new_tree(&mut runner).expect("a program").current();
        let unit = if inch { "INCH" } else { "MM" };
        let mut blocks = vec![format!("BEGIN PGM A {unit}"), "TOOL CALL 1 Z S500".into()];
        blocks.push("L X+0 Y+0 R0 FMAX M3".into());
        blocks.push("L Z+50 FMAX".into());
        let pieces = pieces.iter().enumerate();
        blocks.extend(pieces.flat_map(|(at, piece)| piece.blocks(at + 1)));
        blocks.extend(["M30".to_string(), format!("END PGM A {unit}")]);
        let numbered = blocks.iter().enumerate().map(|(at, block)| format!("{at} {block}\n"));
        let text: String = numbered.collect();
        let mut machine = wide("heidenhain-mill");
        machine.set("tools.1.diameter=\"3 mm\"").expect("a tool");
        let old = job(&text, machine);
        for (target, count) in TARGETS.iter().zip(&mut counts) {
            let trip = RoundTrip::through(&old, &wide(target));
            let [there, back] = trip.holds();
            *count = [count[0] + 1, count[1] + usize::from(there), count[2] + usize::from(back)];
            if !(there && back) {
                refused.push(format!("{target}: {}", trip.verdict()));
            }
            assert!(
                trip.is_proved_or_refused(),
                "{target}: {}\n{text}\n====\n{}\n====\n{}",
                trip.verdict(),
                trip.there.text,
                trip.back.as_ref().map(|back| back.text.as_str()).unwrap_or_default()
            );
        }
    }
    refused.sort();
    println!("{TARGETS:?}, each all, proved, back again: {counts:?}; {refused:#?}");
    assert!(counts.iter().all(|[all, _, back]| back * 10 > all * 6), "{refused:#?}");
}
