//! Grooves and part-offs: ridges between plunges, pips, and parts that come off.

use std::f64::consts::PI;

use chordal_diagnostics::Code;
use chordal_geometry::Vec2;
use chordal_stock::lathe::{BladeFacing, LatheStock, PlaceSide, Region};

use super::gather::{TurnMove, TurnedMoveKind};
use super::problems::{MessageDetail, ProblemLocation, TurnedProblems};
use super::report::CutOffPart;
use super::tools::{LatheTool, TurningToolKind};

/// What holds a part after a part-off is thinner than this, mm.
const PIP: f64 = 1.5;
/// A groove deeper than this share of the bar may be a part-off.
const DEEP: f64 = 0.5;
/// Areas below it are rounding, mm².
const NO_AREA: f64 = 1e-6;
/// Plunges whose gap is less have none, mm.
const NO_GAP: f64 = 1e-6;

/// A blade that went down.
#[derive(Clone, Copy, Debug)]
struct BladePlunge {
    /// The number of its move.
    number: usize,
    /// What it covers along the axis, mm.
    from: f64,
    to: f64,
    /// Where its edge ends, as a radius, mm.
    end: f64,
    inside: bool,
    width: f64,
}

/// The plunges of a program.
#[derive(Debug, Default)]
pub(super) struct GrooveRecord {
    /// Those of each run of one tool.
    runs: Vec<Vec<BladePlunge>>,
    tool: u32,
    /// The radius of the bar.
    outer: f64,
}

impl GrooveRecord {
    pub fn new(stock: &Region) -> GrooveRecord {
        let outer = stock.bounds().map_or(0.0, |(_, high)| high.b);
        GrooveRecord { runs: Vec::new(), tool: 0, outer }
    }

    /// Takes a cut; gives what comes off, if this may be a part-off.
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

    /// Looks whether a part is off. Gives what is still held.
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
        // The chuck holds what reaches farthest towards −Z.
        let retained =
            (0..bodies.len()).min_by(|a, b| lowest(&bodies[*a]).total_cmp(&lowest(&bodies[*b])))?;
        let retained = bodies.swap_remove(retained);
        for section in bodies {
            if let Some(radius) = pip(&section, plunge).filter(|radius| *radius > tolerance) {
                let place = Vec2::new(0.5 * (plunge.from + plunge.to), radius);
                let at = ProblemLocation { origin: move_.origin, tool: move_.tool, place };
                found.push(Code::PartOffPip, radius, &at, MessageDetail::Off);
            }
            loose.push(CutOffPart { section, line: move_.origin.line, tool: move_.tool });
        }
        Some(LatheStock::new(&retained))
    }

    /// Looks at what is left between plunges, and below the deepest ones.
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

    /// What still holds a part that was nearly cut off.
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
            // Something stands on both sides: it is the ground of a groove, not a face.
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

/// Ridges between neighbours that are nearer to each other than the blade is wide.
fn ridges(
    run: &[BladePlunge],
    sections: &[&Region],
    moves: &[TurnMove],
    tolerance: f64,
    found: &mut TurnedProblems<'_>,
) {
    // The deepest plunge of each place.
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

/// The radius of what stands on a part within the cut that parted it.
fn pip(section: &Region, plunge: &BladePlunge) -> Option<f64> {
    let inset = 1e-3 * (plunge.to - plunge.from);
    let (low, high) = (plunge.from + inset, plunge.to - inset);
    let cut = Region::bar(1e3 * PI, low, high).ok()?;
    let common = section.intersection(&cut).ok()?.region;
    let (_, top) = common.bounds()?;
    (common.area() > NO_AREA).then_some(top.b)
}
