//! The parametric program of the examples makes what its sizes say: places, levels and strokes
//! are worked out here from the drawing, not from the program.

#![allow(clippy::disallowed_methods, reason = "a test reads an example")]

use chordal::control::CommandKind;
use chordal::machine::PerAxis;
use chordal::{Job, Machine, Severity, Source, SourceMap};

const PROGRAM: &str = include_str!("../../../examples/haas/parametric.nc");

/// The control rounds computed places to .0001 in on each axis, so they are off by this at most.
const ROUNDING: f64 = 0.000_071;

/// X of the middle of the plate.
const PLATE: f64 = 9.0;

/// A move in inches: what kind, from where, to where.
#[derive(Clone, Copy)]
struct ProgramMove {
    kind: char,
    from: [f64; 3],
    to: [f64; 3],
}

impl ProgramMove {
    fn length(&self) -> f64 {
        (0..3).map(|axis| (self.to[axis] - self.from[axis]).powi(2)).sum::<f64>().sqrt()
    }

    fn is_level_cut(&self) -> bool {
        self.kind == 'l' && self.from[2] == self.to[2] && self.from[..2] != self.to[..2]
    }
}

/// The moves of each tool in its turn, and the printed lines.
fn made() -> (Vec<(u32, Vec<ProgramMove>)>, Vec<String>) {
    let mut machine = Machine::from_builtin("haas-vf2").expect("a built-in machine");
    for line in PROGRAM.lines().filter_map(|line| line.strip_prefix("(set: ")) {
        machine.set(line.trim_end_matches(')')).expect("a setting");
    }
    let mut sources = SourceMap::new();
    sources.add(Source::new("parametric.nc", PROGRAM.as_bytes()));
    let job = Job::new(sources, machine).expect("good settings");
    let (mut turns, mut printed) = (Vec::<(u32, Vec<ProgramMove>)>::new(), Vec::new());
    let report = job.report_of_commands(|command| {
        let kind = match &command.kind {
            CommandKind::Tool { number } => return turns.push((*number, Vec::new())),
            CommandKind::Output { text } => return printed.push(text.clone()),
            CommandKind::Rapid { .. } => 'r',
            CommandKind::Line { .. } => 'l',
            CommandKind::Arc { .. } => 'a',
            _ => return,
        };
        let motion = command.kind.motion().expect("it moves");
        let inch = |at: &PerAxis<f64>| [at[0] / 25.4, at[1] / 25.4, at[2] / 25.4];
        let (_, ways) = turns.last_mut().expect("a tool before the first move");
        ways.push(ProgramMove { kind, from: inch(&motion.from), to: inch(&motion.to) });
    });
    let told: Vec<_> =
        report.diagnostics.iter().filter(|told| told.severity > Severity::Note).collect();
    assert!(told.is_empty(), "{told:?}");
    (turns, printed)
}

/// Places where a drill ends at a depth.
fn holes(ways: &[ProgramMove], depth: f64) -> Vec<[f64; 2]> {
    let bottoms = ways.iter().filter(|way| way.kind == 'l' && (way.to[2] - depth).abs() < 1e-9);
    bottoms.map(|way| [way.to[0], way.to[1]]).collect()
}

fn assert_places(found: &[[f64; 2]], expected: &[[f64; 2]]) {
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (found, expected) in found.iter().zip(expected) {
        let off = (found[0] - expected[0]).hypot(found[1] - expected[1]);
        assert!(off < ROUNDING, "{found:?} is not {expected:?}");
    }
}

#[test]
fn eight_turns_of_five_tools() {
    let (turns, _) = made();
    let tools: Vec<u32> = turns.iter().map(|(tool, _)| *tool).collect();
    assert_eq!(tools, [1, 2, 3, 4, 2, 3, 5, 4]);
}

#[test]
fn the_bolt_circles() {
    let mut places = Vec::new();
    for (radius, count) in [(2.4, 8), (1.8, 6)] {
        for hole in 0..count {
            let angle = (22.5 + 360.0 * f64::from(hole) / f64::from(count)).to_radians();
            places.push([radius * angle.cos(), radius * angle.sin()]);
        }
    }
    assert_places(&holes(&made().0[1].1, -0.75), &places);
}

#[test]
fn the_grid_leaves_the_pocket_out() {
    // Rows from below, to and fro; of the middle rows the ends alone.
    let row = |y: f64, columns: &[f64]| -> Vec<[f64; 2]> {
        columns.iter().map(|x| [PLATE + x, y]).collect()
    };
    let places = [
        row(-1.35, &[-2.0, -1.0, 0.0, 1.0, 2.0]),
        row(-0.45, &[2.0, -2.0]),
        row(0.45, &[-2.0, 2.0]),
        row(1.35, &[2.0, 1.0, 0.0, -1.0, -2.0]),
    ];
    assert_places(&holes(&made().0[4].1, -0.75), &places.concat());
}

#[test]
fn each_hole_is_pecked_as_its_macro_says() {
    // .25, then eight tenths each time: .25 .45 .61 .738, and .75.
    let (turns, _) = made();
    let first = holes(&turns[1].1, -0.75)[0];
    let cuts = turns[1].1.iter().filter(|way| {
        way.kind == 'l'
            && way.to[2] < way.from[2]
            && (way.to[0] - first[0]).abs() < 1e-9
            && (way.to[1] - first[1]).abs() < 1e-9
    });
    let depths: Vec<f64> = cuts
        .map(|way| way.to[2])
        .filter(|z| [0.25, 0.45, 0.61, 0.738, 0.75].iter().any(|d| (z + d).abs() < 1e-6))
        .collect();
    assert_eq!(depths.len(), 5, "{depths:?}");
    assert!(depths.is_sorted_by(|a, b| a > b), "{depths:?}");
}

#[test]
fn the_pocket_is_an_ellipse() {
    const AXES: [f64; 2] = [1.3, 0.75];
    const TOOL: f64 = 0.25;
    let wall: Vec<[f64; 2]> = (0..36_000)
        .map(|step| (f64::from(step) / 100.0).to_radians())
        .map(|t| [PLATE + AXES[0] * t.cos(), AXES[1] * t.sin()])
        .collect();
    let to_wall = |at: [f64; 3]| {
        let way = |w: &[f64; 2]| (at[0] - w[0]).hypot(at[1] - w[1]);
        wall.iter().map(way).fold(f64::INFINITY, f64::min)
    };
    let (turns, _) = made();
    let cuts: Vec<&ProgramMove> = turns[5].1.iter().filter(|way| way.is_level_cut()).collect();
    for (level, depth) in [-0.1, -0.2, -0.3].into_iter().enumerate() {
        let here: Vec<&&ProgramMove> =
            cuts.iter().filter(|way| (way.to[2] - depth).abs() < 1e-9).collect();
        // Three rings of 72 chords, the ways between them, and the way back.
        assert_eq!(here.len(), 3 * 72 + 3 + 1, "level {level}");
        let distances: Vec<f64> = here.iter().map(|way| to_wall(way.to)).collect();
        let at_wall =
            distances.iter().filter(|distance| (*distance - TOOL).abs() < ROUNDING).count();
        assert_eq!(at_wall, 73, "level {level}: the ends of the last ring");
        assert!(distances.iter().all(|distance| *distance > TOOL - ROUNDING), "level {level}");
    }
    assert_eq!(cuts.len(), 3 * 220);
}

#[test]
fn the_chamfer_goes_once_round() {
    let (turns, _) = made();
    let ways = &turns[6].1;
    // The cone of 90 degrees meets the edge .03 below the face where its tip is .06 outside.
    let (half_x, half_y, corner) = (2.56, 1.86, 0.46);
    let round: Vec<&ProgramMove> =
        ways.iter().filter(|way| way.kind != 'r' && way.to[2] == way.from[2]).collect();
    assert!(round.iter().all(|way| (way.to[2] + 0.09).abs() < 1e-9));
    // On, five lines (the left side in two parts) and four corners, off.
    assert_eq!(round.iter().map(|way| way.kind).collect::<String>(), "alalalalala");
    let straight: f64 = round.iter().filter(|way| way.kind == 'l').map(|way| way.length()).sum();
    let expected = 4.0 * (half_x - corner) + 4.0 * (half_y - corner);
    assert!((straight - expected).abs() < 1e-6, "{straight} is not {expected}");
    for way in &round[..10] {
        let [x, y] = [(way.to[0] - PLATE).abs(), way.to[1].abs()];
        let on_side = (x - half_x).abs() < 1e-6 && y < half_y - corner + 1e-6;
        let on_end = (y - half_y).abs() < 1e-6 && x < half_x - corner + 1e-6;
        assert!(on_side || on_end, "{x} {y}");
    }
    // Clockwise: the area under the chords is negative.
    let area: f64 = round.iter().map(|w| w.from[0] * w.to[1] - w.to[0] * w.from[1]).sum();
    assert!(area < 0.0);
}

/// Strokes of the figures 0 to 9, counted on the drawing of the letters.
const STROKES: [usize; 10] = [4, 2, 5, 5, 3, 5, 5, 2, 7, 5];

fn assert_engraved(ways: &[ProgramMove], figures: [usize; 5], corner: [f64; 2], height: f64) {
    let cuts: Vec<&ProgramMove> = ways.iter().filter(|way| way.is_level_cut()).collect();
    assert!(cuts.iter().all(|way| (way.to[2] + 0.005).abs() < 1e-9));
    let wanted: usize = figures.iter().map(|figure| STROKES[*figure]).sum();
    assert_eq!(cuts.len(), wanted);
    for (place, figure) in figures.into_iter().enumerate() {
        let left = corner[0] + place as f64 * 0.9 * height;
        let inside = |at: [f64; 3]| {
            let (x, y) = (at[0] - left, at[1] - corner[1]);
            x > -1e-6 && x < height * 4.0 / 6.0 + 1e-6 && y > -1e-6 && y < height + 1e-6
        };
        let strokes: Vec<_> = cuts.iter().filter(|w| inside(w.from) && inside(w.to)).collect();
        assert_eq!(strokes.len(), STROKES[figure], "figure {figure} at place {place}");
        let top = strokes.iter().flat_map(|way| [way.from[1], way.to[1]]).fold(-9.0, f64::max);
        assert!((top - corner[1] - height).abs() < 1e-6, "figure {figure} is {top} high");
    }
}

#[test]
fn both_numbers_are_engraved() {
    let (turns, _) = made();
    assert_engraved(&turns[3].1, [2, 0, 4, 1, 7], [-0.675, -1.45], 0.3);
    assert_engraved(&turns[7].1, [5, 3, 8, 6, 9], [PLATE - 0.45, 1.0], 0.2);
}

#[test]
fn what_is_printed() {
    // The area is pi times the half axes.
    let area = format!("POCKET 1.30 BY 0.75 AREA {:.3}", std::f64::consts::PI * 1.3 * 0.75);
    let expected = [
        "COVER 20417 OF 20240517",
        "RADIUS 3.0000",
        "CIRCLE 1 R 2.4000 HOLES 8",
        "CIRCLE 2 R 1.8000 HOLES 6",
        "HOLES 14",
        "PLATE HOLES 14 LEFT OUT 6",
        &area,
        "ALL HOLES 28",
        "DONE",
    ];
    assert_eq!(made().1, expected);
}
