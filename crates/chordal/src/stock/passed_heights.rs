//! Remembers where a tool has cut: a rapid to the same place touches nothing that the cut did not touch.
//!
//! Material only becomes less. What the edges have passed at feed is gone, and what shank and holder touched there is
//! reported for the cut. So a rapid along positions that are all among those of cuts of the same tool need not be
//! checked; this needs no columns and no resolution.

use std::collections::{HashMap, VecDeque};

use chordal_geometry::{Curve, Line, ParamCurve, Vec3};
use chordal_stock::TipMove;

use super::tools::ToolBody;

/// Positions that differ by less than this are equal, mm: far less than the tolerance of a touch.
const COINCIDENT_MM: f64 = 1e-6;

/// Straight cuts that are kept for comparison with rapids.
const MAX_LINES: usize = 256;

/// The side of the hash cells in which positions are looked up, mm.
const CELL_MM: f64 = 1e-3;

/// The part of a rapid that may touch something new.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum RapidRest {
    /// Nothing: all of it is where the tool has cut, or goes straight up from there.
    Nothing,
    /// This part of it.
    Part(Line),
}

/// A tool number, and the index of an orientation of the part.
type ToolAndTurn = (u32, usize);

/// Ranges of heights of the tip that cuts have passed at one position in X and Y, mm.
type PassedHeights = Vec<[f64; 2]>;

/// A position in X and Y, mm.
#[derive(Debug)]
struct VisitedSpot {
    at: [f64; 2],
    heights: PassedHeights,
}

/// The positions of cuts to which rapids may come back.
#[derive(Debug, Default)]
pub(super) struct VisitedPlaces {
    /// By tool and cell: positions in X and Y where the tool went straight down or up at feed, or where a rapid left
    /// the cut.
    spots: HashMap<(ToolAndTurn, [i64; 2]), Vec<VisitedSpot>>,
    /// The last straight cuts.
    lines: VecDeque<(ToolAndTurn, Line)>,
    /// The end of the last cut, while no rapid has followed it.
    last: Option<(ToolAndTurn, Vec3)>,
}

impl VisitedPlaces {
    /// Records a cut.
    pub fn cut(&mut self, tool: u32, turn: usize, curve: &Curve) {
        let key = (tool, turn);
        if let Curve::Line(line) = curve {
            if is_upright(line.start, line.end) {
                self.keep(key, [line.start.x, line.start.y], [line.start.z, line.end.z]);
            } else {
                if self.lines.len() == MAX_LINES {
                    self.lines.pop_front();
                }
                self.lines.push_back((key, *line));
            }
        }
        self.last = Some((key, curve.end()));
    }

    /// The part of a rapid that must be checked.
    pub fn rapid(&mut self, tool: u32, turn: usize, body: &ToolBody, line: &Line) -> RapidRest {
        if let Some((key, end)) = self.last.take() {
            self.keep(key, [end.x, end.y], [end.z, end.z]);
        }
        if body.core.is_some() {
            // A tap leaves the ridges of its thread, so a straight move through the hole is not free.
            return RapidRest::Part(*line);
        }
        let key = (tool, turn);
        // A body that is nowhere narrower than further down has swept everything above itself.
        let widens = body.widens();
        let rest = match is_upright(line.start, line.end) {
            true => self.upright(key, widens, line),
            false => self.along(key, widens, line),
        };
        rest.unwrap_or(RapidRest::Part(*line))
    }

    /// Whether the tool has cut at a position.
    pub fn has(&self, tool: u32, turn: usize, at: Vec3) -> bool {
        let heights = self.heights((tool, turn), [at.x, at.y]);
        heights.is_some_and(|heights| {
            let has = |[low, high]: &[f64; 2]| {
                (low - COINCIDENT_MM..=high + COINCIDENT_MM).contains(&at.z)
            };
            heights.iter().any(has)
        })
    }

    fn upright(&self, key: ToolAndTurn, widens: bool, line: &Line) -> Option<RapidRest> {
        if widens && line.end.z >= line.start.z {
            // A move straight up touches nothing that was not touched where it begins.
            return Some(RapidRest::Nothing);
        }
        let heights = self.heights(key, [line.start.x, line.start.y])?;
        let (low, high) = (line.start.z.min(line.end.z), line.start.z.max(line.end.z));
        let mut below = heights.iter().filter(|[from, _]| *from <= low + COINCIDENT_MM);
        if widens {
            return below.next().map(|_| RapidRest::Nothing);
        }
        let passed = below.map(|[_, to]| *to).fold(f64::NEG_INFINITY, f64::max);
        if passed < low - COINCIDENT_MM {
            return None;
        }
        if passed >= high - COINCIDENT_MM {
            return Some(RapidRest::Nothing);
        }
        let at = |z: f64| Vec3::new(line.start.x, line.start.y, z);
        let (start, end) = match line.start.z > line.end.z {
            true => (at(high), at(passed)),
            false => (at(passed), at(high)),
        };
        Some(RapidRest::Part(Line { start, end }))
    }

    /// The rest of a rapid along straight cuts, joined end to end.
    fn along(&self, key: ToolAndTurn, widens: bool, line: &Line) -> Option<RapidRest> {
        let mut at = 0.0;
        for _ in 0..self.lines.len() {
            let cuts = self.lines.iter().filter(|(of, _)| *of == key);
            let reached = cuts.filter_map(|(_, cut)| reaches(cut, line, at, widens));
            let next = reached.fold(at, f64::max);
            if next >= 1.0 {
                return Some(RapidRest::Nothing);
            }
            if next <= at {
                return None;
            }
            at = next;
        }
        None
    }

    fn keep(&mut self, key: ToolAndTurn, at: [f64; 2], [a, b]: [f64; 2]) {
        let mut new = [a.min(b), a.max(b)];
        let spots = self.spots.entry((key, cell(at))).or_default();
        let found = spots.iter().position(|spot| are_same(spot.at, at));
        let index = found.unwrap_or_else(|| {
            spots.push(VisitedSpot { at, heights: Vec::new() });
            spots.len() - 1
        });
        let heights = &mut spots[index].heights;
        // Ranges that meet become one.
        heights.retain(|range| {
            let meets = range[0] <= new[1] + COINCIDENT_MM && new[0] <= range[1] + COINCIDENT_MM;
            if meets {
                new = [new[0].min(range[0]), new[1].max(range[1])];
            }
            !meets
        });
        heights.push(new);
    }

    fn heights(&self, key: ToolAndTurn, at: [f64; 2]) -> Option<&PassedHeights> {
        let [x, y] = cell(at);
        let near = (-1..=1).flat_map(|i| (-1..=1).map(move |j| [x + i, y + j]));
        let spots = near.filter_map(|cell| self.spots.get(&(key, cell)));
        let found = spots.flatten().find(|spot| are_same(spot.at, at));
        found.map(|spot| &spot.heights)
    }
}

/// The share of a rapid up to which a straight cut covers it from the share `from` on, or passes below it where
/// `widens`. `None` where it does not cover the rapid at `from`.
fn reaches(cut: &Line, line: &Line, from: f64, widens: bool) -> Option<f64> {
    let flat = |v: Vec3| Vec3::new(v.x, v.y, 0.0);
    let course = flat(line.end - line.start);
    let length = course.length();
    let direction = course / length;
    let along = |point: Vec3| flat(point - line.start).dot(direction);
    let adjacent = |point: Vec3| {
        let by = flat(point - line.start);
        (by - direction * by.dot(direction)).length()
    };
    if adjacent(cut.start) > COINCIDENT_MM || adjacent(cut.end) > COINCIDENT_MM {
        return None;
    }
    let (mut first, mut last) = (cut.start, cut.end);
    if along(first) > along(last) {
        (first, last) = (last, first);
    }
    let start = from * length;
    if along(first) > start + COINCIDENT_MM || along(last) <= start + COINCIDENT_MM {
        return None;
    }
    let stop = along(last).min(length);
    let height = |a: Vec3, b: Vec3, at: f64| {
        let share = (at - along(a)) / (along(b) - along(a));
        a.z + (b.z - a.z) * share
    };
    let fits = |at: f64| {
        let above = height(line.start, line.end, at) - height(first, last, at);
        above.abs() <= COINCIDENT_MM || widens && above >= 0.0
    };
    let is_done = stop >= length - COINCIDENT_MM;
    (fits(start) && fits(stop)).then_some(if is_done { 1.0 } else { stop / length })
}

/// Whether a move goes along Z alone.
pub(super) fn is_upright(start: Vec3, end: Vec3) -> bool {
    (start.x, start.y) == (end.x, end.y)
}

fn cell(at: [f64; 2]) -> [i64; 2] {
    at.map(|value| (value / CELL_MM).round() as i64)
}

fn are_same(a: [f64; 2], b: [f64; 2]) -> bool {
    (a[0] - b[0]).abs() <= COINCIDENT_MM && (a[1] - b[1]).abs() <= COINCIDENT_MM
}

impl RapidRest {
    /// The part of a move that must be checked; `None` where there is none.
    pub fn of(self, path: &TipMove) -> Option<TipMove> {
        match self {
            RapidRest::Nothing => None,
            RapidRest::Part(line) => Some(TipMove { curve: Curve::Line(line), ..*path }),
        }
    }
}

#[cfg(test)]
mod tests {
    use chordal_stock::CutterProfile;

    use super::super::tools::body_for_tests;
    use super::*;

    /// Places from a seed.
    struct RandomPlaces(u64);

    impl RandomPlaces {
        fn below(&mut self, count: u64) -> u64 {
            self.0 = self
                .0
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 33) % count
        }

        fn place(&mut self) -> Vec3 {
            let [x, y, z] = [4, 2, 4].map(|count| self.below(count) as f64);
            Vec3::new(x, y, -z)
        }
    }

    /// Whether a position lies on a line, or above it.
    fn is_on(line: &Line, at: Vec3, widens: bool) -> bool {
        const STEPS: usize = 360;
        let near = |a: f64, b: f64| (a - b).abs() < 1e-9;
        (0..=STEPS).any(|step| {
            let on = line.start + (line.end - line.start) * (step as f64 / STEPS as f64);
            let above = at.z - on.z;
            near(on.x, at.x) && near(on.y, at.y) && (near(above, 0.0) || widens && above > 0.0)
        })
    }

    #[test]
    fn what_is_not_asked_was_cut_before() {
        let cutter = |flutes| CutterProfile::flat(2.0).expect("a cutter").with_flutes(flutes);
        let bodies = [
            body_for_tests(cutter(None), None),
            body_for_tests(cutter(Some(1.0)), Some([40.0, 4.0, 2.0])),
        ];
        assert_eq!(bodies.each_ref().map(ToolBody::widens), [true, false]);
        let (mut numbers, mut clear) = (RandomPlaces(7), [0, 0]);
        for round in 0..4000 {
            let body = &bodies[round % 2];
            let (mut visited, mut cuts) = (VisitedPlaces::default(), Vec::new());
            let mut at = numbers.place();
            for _ in 0..12 {
                let line = Line { start: at, end: numbers.place() };
                at = line.end;
                if numbers.below(3) > 0 {
                    visited.cut(1, 0, &Curve::Line(line));
                    cuts.push(line);
                    continue;
                }
                if visited.rapid(1, 0, body, &line) != RapidRest::Nothing {
                    continue;
                }
                // Straight up needs no cut.
                let lifts = is_upright(line.start, line.end) && line.end.z >= line.start.z;
                if body.widens() && lifts {
                    continue;
                }
                clear[round % 2] += 1;
                for step in 0..=6 {
                    let place = line.start + (line.end - line.start) * (f64::from(step) / 6.0);
                    assert!(
                        cuts.iter().any(|cut| is_on(cut, place, body.widens())),
                        "{line:?} at {place:?}: {cuts:?}"
                    );
                }
            }
        }
        assert!(clear.iter().all(|count| *count > 100), "{clear:?}");
    }
}
