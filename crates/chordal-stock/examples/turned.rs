//! Passes on turned stock: microseconds each, edges, and how they grow with what is already cut.
//!
//! `cargo run --release -p chordal-stock --example turned`. Figures of one run are compared with each other.

#![allow(clippy::disallowed_methods, reason = "an example that measures")]

use std::time::Instant;

use chordal_geometry::Vec2;
use chordal_stock::lathe::{Insert, LatheStock, OutlineSegment, Region, Tip, ToolOutline};

/// Passes of each program.
const PASSES: u32 = 10_000;

fn at(z: f64, r: f64) -> Vec2 {
    Vec2::new(z, r)
}

/// Roughing in many small steps: infeed, pass, retract, back.
fn roughing() -> Vec<OutlineSegment> {
    let mut moves = Vec::new();
    let mut from = at(2.0, 52.0);
    let steps = PASSES / 4;
    for step in 0..steps {
        let r = 50.0 - 30.0 * f64::from(step + 1) / f64::from(steps);
        let end = -100.0 + (50.0 - r);
        for to in [at(2.0, r), at(end, r), at(end + 1.0, r + 1.0), at(2.0, r + 1.0)] {
            moves.push(OutlineSegment::line(from, to));
            from = to;
        }
    }
    moves
}

/// A contour of short lines, as CAM programs have them.
fn contour(depth: f64, count: u32) -> Vec<OutlineSegment> {
    let place = |step: u32| {
        let z = -110.0 * f64::from(step) / f64::from(count);
        at(z, 44.0 + 3.0 * libm::sin(0.2 * z) - depth)
    };
    (0..count).map(|step| OutlineSegment::line(place(step), place(step + 1))).collect()
}

/// Lines and arcs in turn.
fn arcs() -> Vec<OutlineSegment> {
    let mut moves = Vec::new();
    let mut from = at(0.0, 45.0);
    for step in 0..PASSES / 2 {
        let z = from.a - 0.011;
        let flat = at(z, 45.0);
        moves.push(OutlineSegment::line(from, flat));
        let to = at(z - 0.011, 45.0);
        moves.push(OutlineSegment::arc(flat, to, at(z - 0.0055, 45.0 + 0.02), step % 2 == 0));
        from = to;
    }
    moves
}

/// Many grooves, wall after wall.
fn grooves() -> Vec<OutlineSegment> {
    let mut moves = Vec::new();
    for groove in 0..PASSES / 4 {
        let z = -110.0 * f64::from(groove) / f64::from(PASSES / 4);
        let corners = [at(z, 52.0), at(z, 49.0), at(z, 49.5), at(z, 48.0), at(z, 52.0)];
        moves.extend(corners.windows(2).map(|two| OutlineSegment::line(two[0], two[1])));
    }
    moves
}

fn run(name: &str, tool: &ToolOutline, moves: &[OutlineSegment]) {
    // With a word, only the programs whose names hold it.
    if std::env::args().nth(1).is_some_and(|word| !name.contains(&word)) {
        return;
    }
    let mut best = f64::INFINITY;
    let mut left = None;
    let mut halves = [0.0; 2];
    for _ in 0..3 {
        let mut stock = LatheStock::new(&Region::bar(50.0, -120.0, 0.0).expect("a bar"));
        let begin = Instant::now();
        for move_ in &moves[..moves.len() / 2] {
            stock.cut(tool, move_).expect("a pass");
        }
        let first = begin.elapsed().as_secs_f64();
        for move_ in &moves[moves.len() / 2..] {
            stock.cut(tool, move_).expect("a pass");
        }
        let all = begin.elapsed().as_secs_f64();
        if all < best {
            best = all;
            halves = [first, all - first];
        }
        left = Some(stock);
    }
    let stock = left.expect("a run");
    println!(
        "{name:<28} {:>6} moves {:>7.2} us each, {:>6} edges; second half / first {:>5.2}",
        moves.len(),
        best / moves.len() as f64 * 1e6,
        stock.edges(),
        halves[1] / halves[0]
    );
}

fn main() {
    let tip = Tip::new(3).expect("a tip");
    let insert = Insert::mounted(tip, 0.8, 1.66, 0.96, 40.0).expect("an insert");
    let nose = insert.outline().expect("an outline");
    let point = Insert::ideal_point(tip, 100.0).expect("a point").outline().expect("an outline");
    run("roughing, nose 0.8", &nose, &roughing());
    run("roughing, ideal point", &point, &roughing());
    run("contour of short lines", &nose, &contour(0.0, PASSES));
    let twice: Vec<OutlineSegment> =
        contour(0.0, PASSES / 2).into_iter().chain(contour(0.5, PASSES / 2)).collect();
    run("contour, then a finish", &nose, &twice);
    run("lines and small arcs", &nose, &arcs());
    let blade = chordal_stock::lathe::Blade {
        width: 0.03,
        corners: [0.005; 2],
        length: 40.0,
        lead: 0.0,
        facing: chordal_stock::lathe::BladeFacing::Outside,
        point: chordal_stock::lathe::BladePoint::Lower,
    };
    run("grooves", &blade.outline().expect("an outline"), &grooves());
}
