//! Random walls with random leads, judged by a second method: the path of the tool centre is sampled, and
//! a tool that comes nearer to the wall than its radius cuts into it. What the program calls wall and
//! lead is known here, and Chordal has to find it out.
//!
//! A longer run: `CHORDAL_ROUNDS=100000 cargo test --release -p chordal --test leads`.

#[path = "../random_contour/mod.rs"]
mod random_contour;

mod forms;
mod walls;

use std::collections::BTreeMap;

use chordal::control::Origin;
use chordal::geometry::Vec2;
use chordal::path::gouge::GougeCurve;
use chordal::path::{ContourCheck, ContourLevel, ContourPiece, PathCommand, PathSink};
use chordal::{Code, Diagnostic};
use forms::Program;
use random_contour::support::{self, Dice, point_distance};
use random_contour::{run, text_of};

/// What is deeper by less than this on a few samples may be missed by either method, mm.
const SURE_MM: f64 = 0.004;

/// Chordal reports what is deeper than this, mm.
const LEAST_DEPTH_MM: f64 = 0.002;

/// The path of the tool centre and what is reported about it.
#[derive(Default)]
struct Seen {
    path: Vec<GougeCurve>,
    check: ContourCheck,
    gouges: Vec<String>,
    at_leads: Vec<String>,
}

impl Seen {
    fn note(gouges: &mut Vec<String>, at_leads: &mut Vec<String>, found: &Diagnostic) {
        match found.code {
            Code::CutterGouges => gouges.push(found.message.to_string()),
            Code::CutterGougesAtLead => at_leads.push(found.message.to_string()),
            _ => {}
        }
    }

    fn finish(&mut self) {
        let Seen { check, gouges, at_leads, .. } = self;
        check.finish(&mut |found, _| Seen::note(gouges, at_leads, &found));
    }
}

impl PathSink for Seen {
    fn command(&mut self, _: PathCommand<'_>) {}

    fn diagnostic(&mut self, _: Diagnostic, _: &Origin) {}

    fn contour(&mut self, piece: &ContourPiece) {
        let mut level = ContourLevel::of(piece);
        level.take(piece);
        self.path.extend(level.moves.iter().map(|step| step.curve));
        let Seen { check, gouges, at_leads, .. } = self;
        check.piece(piece, &mut |found, _| Seen::note(gouges, at_leads, &found));
    }
}

fn seen_of(program: &Program) -> Seen {
    let mut seen: Seen = run(&text(program), program.radius);
    seen.finish();
    seen
}

fn text(program: &Program) -> String {
    text_of(program.side, program.start, &program.chain, program.end)
}

/// Walls that are looked at from one point after the other.
struct Walls<'a> {
    curves: &'a [GougeCurve],
    /// The middle of each curve and how far it reaches from there.
    reach: Vec<(Vec2, f64)>,
}

impl<'a> Walls<'a> {
    fn of(curves: &'a [GougeCurve]) -> Walls<'a> {
        let reach = curves.iter().map(|curve| (curve.at(0.5), 0.5 * curve.length())).collect();
        Walls { curves, reach }
    }

    /// The nearest point of the walls is so far away.
    fn distance(&self, p: Vec2) -> f64 {
        let mut least = f64::INFINITY;
        for (curve, (middle, reach)) in self.curves.iter().zip(&self.reach) {
            if p.distance(*middle) - reach < least {
                least = least.min(point_distance(curve, p));
            }
        }
        least
    }
}

/// How near the path comes to the walls, by samples a fraction of the radius apart and nearer ones
/// around the best of each move; where points in `spared` are nearest, they do not count.
fn sampled(walls: &Walls<'_>, path: &[GougeCurve], radius: f64, spared: &[Vec2]) -> f64 {
    let counts = |p: Vec2| spared.iter().all(|end| end.distance(p) > 2.0 * radius);
    let mut least = f64::INFINITY;
    for curve in path.iter().filter(|curve| curve.length() > 0.0) {
        let steps = (curve.length() / (0.08 * radius)).ceil().max(2.0);
        let distance = |t: f64| {
            let p = curve.at(t);
            if counts(p) { walls.distance(p) } else { f64::INFINITY }
        };
        let best = (0..=steps as u32)
            .map(|k| f64::from(k) / steps)
            .map(|t| (t, distance(t)))
            .fold((0.0, f64::INFINITY), |a, b| if b.1 < a.1 { b } else { a });
        least = least.min(best.1);
        let (mut low, mut high) =
            ((best.0 - 1.0 / steps).max(0.0), (best.0 + 1.0 / steps).min(1.0));
        for _ in 0..24 {
            let third = (high - low) / 3.0;
            let (a, b) = (distance(low + third), distance(high - third));
            least = least.min(a).min(b);
            if a < b { high -= third } else { low += third }
        }
    }
    least
}

/// Whether the path surely comes nowhere nearer than `limit`: every piece of it is looked at until its
/// middle is farther away than the piece is long.
fn surely_beyond(walls: &Walls<'_>, path: &[GougeCurve], limit: f64) -> bool {
    path.iter().all(|curve| {
        let mut pieces = vec![(0.0, 1.0)];
        while let Some((low, high)) = pieces.pop() {
            let middle = 0.5 * (low + high);
            let distance = walls.distance(curve.at(middle));
            if distance < limit {
                return false;
            }
            if distance - 0.5 * (high - low) * curve.length() < limit {
                pieces.extend([(low, middle), (middle, high)]);
            }
        }
        true
    })
}

/// What a round comes to.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
enum Answer {
    Quiet,
    Found,
    /// At the open end of a wall, where either answer will do.
    AtEnd,
    Unclear,
    /// A cut that shows only if the end of an open wall is wall, which the text does not say.
    Undecided,
    False,
    Missed,
}

/// An open wall is cut near its ends only, and that a lead cuts there is told.
fn told_at_ends(wall: &[GougeCurve], program: &Program, seen: &Seen) -> bool {
    let (Some(first), Some(last)) = (wall.first(), wall.last()) else { return false };
    let away = || {
        let ends = [first.from(), last.to()];
        sampled(&Walls::of(wall), &seen.path, program.radius, &ends)
    };
    program.is_open && !seen.at_leads.is_empty() && away() >= program.radius - SURE_MM
}

fn answer(program: &Program, seen: &Seen) -> Answer {
    let walls = Walls::of(&program.wall);
    let radius = program.radius;
    let least = sampled(&walls, &seen.path, radius, &[]);
    let told = !seen.gouges.is_empty();
    let cut = least < radius - SURE_MM;
    if told && cut {
        return Answer::Found;
    }
    if !told && !cut {
        return match seen.at_leads.is_empty() {
            true => Answer::Quiet,
            false if surely_beyond(&walls, &seen.path, radius - LEAST_DEPTH_MM + 1e-5) => {
                Answer::False
            }
            false => Answer::Unclear,
        };
    }
    if cut {
        if told_at_ends(&program.wall, program, seen) {
            return Answer::AtEnd;
        }
        // The other reading has to answer for all that is cut: nothing is, or it is told at the ends.
        let is_clean = sampled(&Walls::of(&program.sure), &seen.path, radius, &[]);
        let is_clean = is_clean >= radius - SURE_MM;
        let reads_both_ways = program.sure.len() < program.wall.len();
        return match reads_both_ways && (is_clean || told_at_ends(&program.sure, program, seen)) {
            true => Answer::Undecided,
            false => Answer::Missed,
        };
    }
    match surely_beyond(&walls, &seen.path, radius - LEAST_DEPTH_MM + 1e-5) {
        true => Answer::False,
        false => Answer::Unclear,
    }
}

#[test]
fn leads_are_no_walls_and_walls_are_no_leads() {
    let rounds: u64 =
        option_env!("CHORDAL_ROUNDS").and_then(|rounds| rounds.parse().ok()).unwrap_or(600);
    let mut counts: BTreeMap<Answer, usize> = BTreeMap::new();
    let mut wrong: BTreeMap<String, (usize, u64)> = BTreeMap::new();
    for seed in 0..rounds {
        let mut dice = Dice::new(seed + 900_000);
        let Some(program) = forms::program(&mut dice) else { continue };
        let seen = seen_of(&program);
        let answer = answer(&program, &seen);
        *counts.entry(answer).or_default() += 1;
        if matches!(answer, Answer::False | Answer::Missed) {
            let of = format!("{answer:?} {}", program.name);
            println!("{seed}: {of}");
            wrong.entry(of).or_insert((0, seed)).0 += 1;
        }
    }
    let count = |answer: Answer| counts.get(&answer).copied().unwrap_or(0);
    println!("{counts:?}");
    assert!(wrong.is_empty(), "{counts:?}\n{wrong:#?}");
    let ran = counts.values().sum::<usize>();
    assert!(4 * count(Answer::Quiet) > ran && 8 * count(Answer::Found) > ran, "{counts:?}");
    assert!(100 * count(Answer::Unclear) < ran, "{counts:?}");
    assert!(500 * count(Answer::Undecided) < ran.max(2_500), "{counts:?}");
}

/// One round, printed: `CHORDAL_SEED=17 cargo test -p chordal --test leads -- --nocapture one`.
#[test]
fn one_round() {
    let Some(seed) = option_env!("CHORDAL_SEED").and_then(|seed| seed.parse::<u64>().ok()) else {
        return;
    };
    let mut dice = Dice::new(seed + 900_000);
    let Some(program) = forms::program(&mut dice) else { return };
    let seen = seen_of(&program);
    println!("({}, radius {})\n{}", program.name, program.radius, text(&program));
    println!("{:?} {:?} {:?}", answer(&program, &seen), seen.gouges, seen.at_leads);
    let least = sampled(&Walls::of(&program.wall), &seen.path, program.radius, &[]);
    println!("{least} of {}", program.radius);
}
