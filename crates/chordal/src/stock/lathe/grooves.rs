//! Grooving and parting off: ridges between plunges, pips, and parts that are cut off.

use std::f64::consts::PI;

use chordal_diagnostics::Code;
use chordal_geometry::Vec2;
use chordal_stock::lathe::{BladeFacing, LatheStock, PlaceSide, Region};

use super::gather::{TurnMove, TurnedMoveKind};
use super::problems::{MessageDetail, ProblemLocation, TurnedProblems};
use super::report::CutOffPart;
use super::tools::{LatheTool, TurningToolKind};

/// Largest thickness of a link that still counts as the rest of a part-off, mm.
const PIP: f64 = 1.5;
/// A plunge below this share of the bar's radius may be a part-off.
const DEEP: f64 = 0.5;
/// Areas below this are rounding, mm².
const NO_AREA: f64 = 1e-6;
/// Smaller gaps between plunges are rounding, mm.
const NO_GAP: f64 = 1e-6;

/// One plunge of a blade.
#[derive(Clone, Copy, Debug)]
struct BladePlunge {
    /// The number of its move.
    number: usize,
    /// The range that it covers along the axis, mm.
    from: f64,
    to: f64,
    /// The radius at which its edge ends, mm.
    end: f64,
    inside: bool,
    width: f64,
}

/// The plunges of a program.
#[derive(Debug, Default)]
pub(super) struct GrooveRecord {
    /// The plunges of each uninterrupted use of one tool.
    runs: Vec<Vec<BladePlunge>>,
    tool: u32,
    /// The radius of the bar, mm.
    outer: f64,
}

impl GrooveRecord {
    pub fn new(stock: &Region) -> GrooveRecord {
        let outer = stock.bounds().map_or(0.0, |(_, high)| high.b);
        GrooveRecord { runs: Vec::new(), tool: 0, outer }
    }

    /// Records a cut. Returns whether it may be a part-off.
    pub fn cut(&mut self, number: usize, move_: &TurnMove, tool: &LatheTool) -> bool {
        let TurningToolKind::Blade { facing, from, to } = tool.kind else { return false };
        let is_across = matches!(facing, BladeFacing::Outside | BladeFacing::Inside);
        let path = &move_.path;
        if !is_across || path.bend.is_some() || move_.kind == TurnedMoveKind::Thread {
            return false;
        }
        if (path.start.a - path.end.a).abs() > NO_GAP {
            return false;
        }
        if self.runs.is_empty() || self.tool != move_.tool {
            self.runs.push(Vec::new());
            self.tool = move_.tool;
        }
        let inside = facing == BladeFacing::Inside;
        let (z, end) = (path.end.a, path.end.b);
        let plunge =
            BladePlunge { number, from: z + from, to: z + to, end, inside, width: to - from };
        if let Some(run) = self.runs.last_mut() {
            run.push(plunge);
        }
        facing == BladeFacing::Outside && end < DEEP * self.outer
    }

    /// Checks whether a part has been cut off. Returns what is still in the chuck, or `None` where nothing was cut
    /// off.
    pub fn part_off(
        &self,
        stock: &LatheStock,
        moves: &[TurnMove],
        tolerance: f64,
        loose: &mut Vec<CutOffPart>,
        found: &mut TurnedProblems<'_>,
    ) -> Option<LatheStock> {
        let plunge = self.runs.last()?.last()?;
        let move_ = moves.get(plunge.number)?;
        let mut bodies = stock.region().bodies();
        bodies.retain(|body| body.area() > NO_AREA);
        if bodies.len() < 2 {
            return None;
        }
        let lowest = |body: &Region| body.bounds().map_or(f64::INFINITY, |(low, _)| low.a);
        // The chuck holds the body that reaches farthest towards −Z.
        let in_chuck =
            (0..bodies.len()).min_by(|a, b| lowest(&bodies[*a]).total_cmp(&lowest(&bodies[*b])))?;
        let in_chuck = bodies.swap_remove(in_chuck);
        for section in bodies {
            if let Some(radius) = pip(&section, plunge).filter(|radius| *radius > tolerance) {
                let place = Vec2::new(0.5 * (plunge.from + plunge.to), radius);
                let at = ProblemLocation { origin: move_.origin, tool: move_.tool, place };
                found.push(Code::PartOffPip, radius, &at, MessageDetail::Off);
            }
            loose.push(CutOffPart { section, line: move_.origin.line, tool: move_.tool });
        }
        Some(LatheStock::new(&in_chuck))
    }

    /// Checks for ridges between plunges, and for links below the deepest ones.
    pub fn look(
        &self,
        sections: &[&Region],
        moves: &[TurnMove],
        tolerance: f64,
        found: &mut TurnedProblems<'_>,
    ) {
        for run in &self.runs {
            ridges(run, sections, moves, tolerance, found);
            if let Some(deepest) =
                run.iter().filter(|plunge| !plunge.inside).min_by(|a, b| a.end.total_cmp(&b.end))
            {
                self.remaining_link(deepest, sections, moves, found);
            }
        }
    }

    /// Reports the link that still holds a part that was nearly cut off.
    fn remaining_link(
        &self,
        plunge: &BladePlunge,
        sections: &[&Region],
        moves: &[TurnMove],
        found: &mut TurnedProblems<'_>,
    ) {
        if plunge.end >= DEEP * self.outer {
            return;
        }
        let middle = 0.5 * (plunge.from + plunge.to);
        for section in sections {
            let Some(&(inner, top)) = section.radii_at(middle, PlaceSide::Higher).last() else {
                continue;
            };
            // There is material on both sides: it is the bottom of a groove, not a face.
            let is_wall = |z: f64, towards| {
                section.radii_at(z, towards).last().is_some_and(|(_, high)| *high > top + PIP)
            };
            let between = is_wall(plunge.from - NO_GAP, PlaceSide::Lower)
                && is_wall(plunge.to + NO_GAP, PlaceSide::Higher);
            if top - inner > PIP || !between {
                continue;
            }
            let Some(move_) = moves.get(plunge.number) else { continue };
            let at = ProblemLocation {
                origin: move_.origin,
                tool: move_.tool,
                place: Vec2::new(middle, top),
            };
            let more = if inner > 0.0 { MessageDetail::Ring } else { MessageDetail::Nothing };
            found.push(Code::PartOffPip, top - inner, &at, more);
        }
    }
}

/// Reports ridges between neighbouring plunges whose gap is less than the width of the blade.
fn ridges(
    run: &[BladePlunge],
    sections: &[&Region],
    moves: &[TurnMove],
    tolerance: f64,
    found: &mut TurnedProblems<'_>,
) {
    // The deepest plunge at each position.
    let mut places: Vec<BladePlunge> = Vec::new();
    let mut sorted = run.to_vec();
    let deeper = |plunge: &BladePlunge| if plunge.inside { -plunge.end } else { plunge.end };
    sorted.sort_by(|a, b| a.from.total_cmp(&b.from).then(deeper(a).total_cmp(&deeper(b))));
    for plunge in sorted {
        if places.last().is_none_or(|known| (known.from - plunge.from).abs() > NO_GAP) {
            places.push(plunge);
        }
    }
    for pair in places.windows(2) {
        let gap = pair[1].from - pair[0].to;
        if gap <= NO_GAP || gap >= pair[0].width {
            continue;
        }
        let z = pair[0].to + 0.5 * gap;
        for section in sections {
            let radii = section.radii_at(z, PlaceSide::Higher);
            let height = if pair[0].inside {
                let ground = pair[0].end.min(pair[1].end);
                radii.iter().find(|(_, high)| *high >= ground).map(|(low, _)| ground - low)
            } else {
                let ground = pair[0].end.max(pair[1].end);
                radii.last().map(|(_, high)| high - ground)
            };
            let Some(height) = height.filter(|height| *height > tolerance) else { continue };
            let later = pair[0].number.max(pair[1].number);
            let Some(move_) = moves.get(later) else { continue };
            let ground = if pair[0].inside { pair[0].end - height } else { pair[0].end + height };
            let at = ProblemLocation {
                origin: move_.origin,
                tool: move_.tool,
                place: Vec2::new(z, ground),
            };
            found.push(Code::GrooveRidge, height, &at, MessageDetail::Ridge(gap));
        }
    }
}

/// The radius of the pip on a part within the width of the cut that parted it off; `None` without one.
fn pip(section: &Region, plunge: &BladePlunge) -> Option<f64> {
    let inset = 1e-3 * (plunge.to - plunge.from);
    let (low, high) = (plunge.from + inset, plunge.to - inset);
    let cut = Region::bar(1e3 * PI, low, high).ok()?;
    let common = section.intersection(&cut).ok()?.region;
    let (_, top) = common.bounds()?;
    (common.area() > NO_AREA).then_some(top.b)
}
