//! Where a tool has cut: a rapid that takes it there again touches nothing that the cut did not touch.
//!
//! Material only becomes less. What the edges have passed at feed is gone, and what shank and holder touched there
//! is said of the cut. So nothing is asked of a rapid whose places are all among those of cuts of the same tool; this
//! needs no columns, and no resolution.

use std::collections::{HashMap, VecDeque};

use chordal_geometry::{Curve, Line, ParamCurve, Vec3};
use chordal_stock::TipMove;

use super::tools::ToolBody;

/// Places that differ by less are the same, mm: far below what a touch must be deep.
const COINCIDENT_MM: f64 = 1e-6;

/// Straight cuts that are kept to be found along a rapid.
const MAX_LINES: usize = 256;

/// The side of the cells in which places are looked up, mm.
const CELL_MM: f64 = 1e-3;

/// What of a rapid may touch something new.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum RapidRest {
    /// Nothing: all of it is where the tool has cut, or goes straight up from there.
    Nothing,
    /// This part of it.
    Part(Line),
}

/// A tool, and how the part lies.
type ToolAndTurn = (u32, usize);

/// Heights of the tip over one place of X and Y that cuts have passed, mm.
type PassedHeights = Vec<[f64; 2]>;

/// A place of X and Y, mm.
#[derive(Debug)]
struct VisitedSpot {
    at: [f64; 2],
    heights: PassedHeights,
}

/// The places of cuts, as far as rapids come back to them.
#[derive(Debug, Default)]
pub(super) struct VisitedPlaces {
    /// By tool and cell: places of X and Y where the tool went straight down or up at feed, or where it left the path.
    spots: HashMap<(ToolAndTurn, [i64; 2]), Vec<VisitedSpot>>,
    /// The last straight cuts.
    lines: VecDeque<(ToolAndTurn, Line)>,
    /// The last cut, where no rapid has followed it yet.
    last: Option<(ToolAndTurn, Vec3)>,
}

impl VisitedPlaces {
    /// Follows a cut.
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

    /// What is asked of a rapid.
    pub fn rapid(&mut self, tool: u32, turn: usize, body: &ToolBody, line: &Line) -> RapidRest {
        if let Some((key, end)) = self.last.take() {
            self.keep(key, [end.x, end.y], [end.z, end.z]);
        }
        if body.core.is_some() {
            // A tap cuts a thread: straight through it nothing is clear.
            return RapidRest::Part(*line);
        }
        let key = (tool, turn);
        // Of a body that is nowhere narrower than below, all that lies higher was in the way before.
        let widens = body.widens();
        let requested = match is_upright(line.start, line.end) {
            true => self.upright(key, widens, line),
            false => self.along(key, widens, line),
        };
        requested.unwrap_or(RapidRest::Part(*line))
    }

    /// The tool has cut at a place.
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
            // Straight up nothing is touched that was not touched where the move begins.
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

    /// A rapid along straight cuts, one after the other.
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

/// How far along a rapid, from a share of it on, a straight cut has been where the rapid goes; or below it, where
/// `widens`.
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

/// A move along Z alone.
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
    /// The part of a move that is asked.
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

    /// Whether a place lies on a line, or above a place of it.
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
