//! Compensated contours by a second method: distances found by nearest points alone, and the
//! offsets of a polygon library. Random closed contours of lines and arcs, with islands of
//! short segments, run through the whole of Chordal as programs.

mod random_contour;

use cavalier_contours::polyline::PlineSource;
use chordal::control::Origin;
use chordal::geometry::Vec2;
use chordal::path::gouge::{self, GougeCurve, ToolSide};
use chordal::path::{ContourLevel, ContourPiece, PathCommand, PathSink};
use chordal::{BlockRole, Diagnostic, Severity};
use random_contour::support::{self, Dice, closed_contour, curves_of, point_distance, polyline};
use random_contour::{run, text_of};

/// The control's alarms and the pieces of the contour.
#[derive(Default)]
struct Seen {
    pieces: Vec<ContourPiece>,
    alarms: Vec<Diagnostic>,
}

impl PathSink for Seen {
    fn command(&mut self, _: PathCommand<'_>) {}

    fn diagnostic(&mut self, diagnostic: Diagnostic, _: &Origin) {
        if diagnostic.severity == Severity::Error {
            self.alarms.push(diagnostic);
        }
    }

    fn contour(&mut self, piece: &ContourPiece) {
        self.pieces.push(piece.clone());
    }
}

/// The same contour, begun in the middle of its longest line.
fn begun_on_a_line(curves: &[GougeCurve]) -> Option<Vec<GougeCurve>> {
    let line = |c: &GougeCurve| matches!(c, GougeCurve::Line { .. });
    let longest = (0..curves.len())
        .filter(|k| line(&curves[*k]))
        .max_by(|a, b| curves[*a].length().total_cmp(&curves[*b].length()))?;
    let (from, middle, to) =
        (curves[longest].from(), curves[longest].at(0.5), curves[longest].to());
    let mut chain = vec![GougeCurve::line(middle, to)];
    chain.extend(curves[longest + 1..].iter().chain(&curves[..longest]).copied());
    chain.push(GougeCurve::line(from, middle));
    Some(chain)
}

fn program(chain: &[GougeCurve], side: ToolSide) -> String {
    let first = chain[0];
    let along = (first.to() - first.from()).normalized().unwrap();
    let away = first.from() + along.turned_left() * (side.sign() * 20.0);
    text_of(side, away, chain, away)
}

/// The moves of the tool centre along the contour, leads left out.
fn along(pieces: &[ContourPiece]) -> Vec<GougeCurve> {
    let mut level: Option<ContourLevel> = None;
    for piece in pieces.iter().filter(|piece| piece.role == BlockRole::Contour) {
        level.get_or_insert_with(|| ContourLevel::of(piece)).take(piece);
    }
    level.map_or(Vec::new(), |level| level.moves.iter().map(|step| step.curve).collect())
}

fn nearest(curves: &[GougeCurve], p: Vec2) -> f64 {
    curves.iter().map(|curve| point_distance(curve, p)).fold(f64::INFINITY, f64::min)
}

#[test]
fn a_second_method_agrees() {
    let (mut clean, mut gouging, mut silent, mut false_alarms, mut unlike) = (0, 0, 0, 0, 0);
    for seed in 0..3000 {
        let mut dice = Dice::new(seed + 700_000);
        let Some(chain) = begun_on_a_line(&closed_contour(&mut dice)) else { continue };
        let side = if dice.unit() < 0.5 { ToolSide::Left } else { ToolSide::Right };
        let radius = dice.between(0.2, 4.0);
        let seen: Seen = run(&program(&chain, side), radius);
        let path = along(&seen.pieces);
        let alarmed = !seen.alarms.is_empty();
        assert!(alarmed || path.len() >= chain.len(), "seed {seed}");
        let options = gouge::GougeOptions { epsilon: 1e-6, ..gouge::GougeOptions::default() };
        let contour = support::contour(&chain, side, radius);
        let moves: Vec<gouge::CenterMove> = path
            .iter()
            .enumerate()
            .map(|(tag, &curve)| gouge::CenterMove { curve, tag: tag as u32 })
            .collect();
        let told = gouge::check(&contour, &moves, &options);
        assert!(told.complete);
        let samples: Vec<Vec2> = path
            .iter()
            .flat_map(|curve| (0..=8).map(|step| curve.at(f64::from(step) / 8.0)))
            .collect();
        let distances = samples.iter().map(|p| nearest(&chain, *p));
        let (mut least, mut most) = (f64::INFINITY, 0.0f64);
        for distance in distances {
            (least, most) = (least.min(distance), most.max(distance));
        }
        // After an alarm the control would not move; what is shown there need not touch.
        let touches = most <= radius + 1e-6;
        assert!(alarmed || touches, "seed {seed}: the path leaves the contour by {most}");
        let theirs = polyline(&chain).parallel_offset(side.sign() * radius);
        let theirs: Vec<GougeCurve> = theirs.iter().flat_map(curves_of).collect();
        match told.gouges.first() {
            None => {
                assert!(least >= radius - 2e-6, "seed {seed}: {least} of {radius}, not told");
                if alarmed {
                    false_alarms += 1;
                    continue;
                }
                clean += 1;
                let apart = samples.iter().map(|p| nearest(&theirs, *p)).fold(0.0, f64::max);
                unlike += usize::from(apart > 2e-4);
            }
            Some(deepest) => {
                gouging += 1;
                silent += usize::from(!alarmed);
                let truly = nearest(&chain, deepest.center);
                assert!((radius - truly - deepest.depth).abs() < 1e-6, "seed {seed}: {deepest:?}");
                assert!(least >= truly - 1e-6, "seed {seed}: deeper somewhere else");
            }
        }
    }
    let counts = format!(
        "{clean} clean, {gouging} gouging, {silent} of them without an alarm, {false_alarms} false alarms"
    );
    assert!(clean > 1000 && gouging > 1000 && silent > 50, "{counts}");
    assert!(unlike <= 2, "{unlike} paths are not the library's offset; {counts}");
    println!("{counts}");
}
