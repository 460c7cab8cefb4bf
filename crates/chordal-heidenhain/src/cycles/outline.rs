//! Outlines of pockets and studs that the centre of the tool follows.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use chordal_kernel::frames::sin_cos_degrees;

use super::step::{CycleFeed, KlartextCycleStep};

/// The outline that the centre of the tool follows on the wall, about a point; mm.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum KlartextPocketOutline {
    /// Half of both sides, the radius of the corners, the angle, degrees.
    Rectangle([f64; 2], f64, f64),
    /// The radius, and the angle at which it begins, degrees.
    Circle(f64, f64),
    /// An arc slot: the radius of its centre line, half its width, its first angle and its length, degrees.
    ArcSlot(f64, f64, f64, f64),
}

impl KlartextPocketOutline {
    /// Where [`follow`] begins and ends, from its centre and before it is turned, mm.
    pub fn side(&self) -> f64 {
        match self {
            KlartextPocketOutline::Rectangle(halves, ..) => halves[0],
            KlartextPocketOutline::Circle(radius, _) => *radius,
            KlartextPocketOutline::ArcSlot(radius, half, ..) => radius + half,
        }
    }

    /// The angle by which it is turned, degrees.
    pub fn degrees(&self) -> f64 {
        match self {
            KlartextPocketOutline::Rectangle(_, _, degrees)
            | KlartextPocketOutline::Circle(_, degrees) => *degrees,
            KlartextPocketOutline::ArcSlot(_, _, from, _) => *from,
        }
    }
}

/// The outline with an allowance on its wall.
pub fn shrunk(wall: KlartextPocketOutline, by: f64) -> KlartextPocketOutline {
    match wall {
        KlartextPocketOutline::Rectangle(halves, corner, degrees) => {
            let halves = halves.map(|half| (half - by).max(0.0));
            KlartextPocketOutline::Rectangle(halves, (corner - by).max(0.0), degrees)
        }
        KlartextPocketOutline::Circle(radius, degrees) => {
            KlartextPocketOutline::Circle((radius - by).max(0.0), degrees)
        }
        KlartextPocketOutline::ArcSlot(radius, half, from, length) => {
            KlartextPocketOutline::ArcSlot(radius, (half - by).max(0.0), from, length)
        }
    }
}

/// The outline further outside by a distance, mm: round a stud.
pub fn grown(wall: KlartextPocketOutline, by: f64) -> KlartextPocketOutline {
    match wall {
        KlartextPocketOutline::Rectangle(halves, corner, degrees) => {
            KlartextPocketOutline::Rectangle(halves.map(|half| half + by), corner + by, degrees)
        }
        KlartextPocketOutline::Circle(radius, degrees) => {
            KlartextPocketOutline::Circle(radius + by, degrees)
        }
        KlartextPocketOutline::ArcSlot(radius, half, from, length) => {
            KlartextPocketOutline::ArcSlot(radius, half + by, from, length)
        }
    }
}

/// A point turned about the origin.
pub fn turned([x, y]: [f64; 2], degrees: f64) -> [f64; 2] {
    let (sin, cos) = sin_cos_degrees(degrees);
    [x * cos - y * sin, x * sin + y * cos]
}

/// Once round an outline, counter-clockwise, about a point.
pub fn follow(
    outline: &KlartextPocketOutline,
    place: [f64; 2],
    feed: CycleFeed,
    steps: &mut Vec<KlartextCycleStep>,
) {
    let at = |[x, y]: [f64; 2]| [place[0] + x, place[1] + y];
    match outline {
        KlartextPocketOutline::Circle(radius, degrees) => {
            if *radius <= 0.0 {
                return;
            }
            let end = at(turned([*radius, 0.0], *degrees));
            steps.push(KlartextCycleStep::Across { offset: end, feed });
            steps.push(KlartextCycleStep::Arc { center: place, end, sweep_rad: TAU, feed });
        }
        KlartextPocketOutline::Rectangle([x, y], corner, degrees) => {
            let put = |local: [f64; 2]| at(turned(local, *degrees));
            let r = *corner;
            let line = |local: [f64; 2]| KlartextCycleStep::Across { offset: put(local), feed };
            let arc = |center: [f64; 2], end: [f64; 2]| KlartextCycleStep::Arc {
                center: put(center),
                end: put(end),
                sweep_rad: FRAC_PI_2,
                feed,
            };
            steps.push(line([*x, 0.0]));
            // Signs of the corners, and whether the corner is left along the first axis.
            for [sx, sy] in [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]] {
                let center = [sx * (x - r), sy * (y - r)];
                let upright = [sx * x, sy * (y - r)];
                let level = [sx * (x - r), sy * y];
                let (first, last) = if sx == sy { (upright, level) } else { (level, upright) };
                steps.push(line(first));
                if r > 0.0 {
                    steps.push(arc(center, last));
                }
            }
            steps.push(line([*x, 0.0]));
        }
        KlartextPocketOutline::ArcSlot(radius, half, from, length) => {
            let polar = |radius: f64, degrees: f64| {
                let (sin, cos) = sin_cos_degrees(degrees);
                at([radius * cos, radius * sin])
            };
            let to = from + length;
            let sweep_rad = length.to_radians();
            let turn = sweep_rad.signum() * PI;
            steps.push(KlartextCycleStep::Across { offset: polar(radius + half, *from), feed });
            let mut arc = |center, end, sweep_rad| {
                steps.push(KlartextCycleStep::Arc { center, end, sweep_rad, feed });
            };
            arc(place, polar(radius + half, to), sweep_rad);
            if *half > 0.0 {
                arc(polar(*radius, to), polar(radius - half, to), turn);
            }
            if radius - half > 0.0 {
                arc(place, polar(radius - half, *from), -sweep_rad);
            }
            if *half > 0.0 {
                arc(polar(*radius, *from), polar(radius + half, *from), turn);
            }
        }
    }
}

/// To the start of an outline, and once round it in a direction.
pub fn go_to_and_round(
    outline: &KlartextPocketOutline,
    place: [f64; 2],
    is_clockwise: bool,
    feed: CycleFeed,
    steps: &mut Vec<KlartextCycleStep>,
) {
    steps.extend(round_of(outline, place, is_clockwise, feed));
}

/// Once round an outline in a direction. The tool is at its start already.
pub fn go_round(
    outline: &KlartextPocketOutline,
    place: [f64; 2],
    is_clockwise: bool,
    feed: CycleFeed,
    steps: &mut Vec<KlartextCycleStep>,
) {
    steps.extend(round_of(outline, place, is_clockwise, feed).into_iter().skip(1));
}

/// The line to the start of an outline, and the moves once round it; none for an outline without a length.
fn round_of(
    outline: &KlartextPocketOutline,
    place: [f64; 2],
    is_clockwise: bool,
    feed: CycleFeed,
) -> Vec<KlartextCycleStep> {
    let mut round = Vec::new();
    follow(outline, place, feed, &mut round);
    if let Some(KlartextCycleStep::Across { offset: start, .. }) = round.first().copied()
        && is_clockwise
    {
        let moves = reversed(start, &round[1..]);
        round.truncate(1);
        round.extend(moves);
    }
    round
}

/// Moves of the plane from their end back to their start.
fn reversed(start: [f64; 2], moves: &[KlartextCycleStep]) -> Vec<KlartextCycleStep> {
    let mut begin = start;
    let mut found = Vec::new();
    for step in moves {
        match *step {
            KlartextCycleStep::Across { offset, feed } => {
                found.push(KlartextCycleStep::Across { offset: begin, feed });
                begin = offset;
            }
            KlartextCycleStep::Arc { center, end, sweep_rad, feed } => {
                let sweep_rad = -sweep_rad;
                found.push(KlartextCycleStep::Arc { center, end: begin, sweep_rad, feed });
                begin = end;
            }
            _ => {}
        }
    }
    found.reverse();
    found
}
