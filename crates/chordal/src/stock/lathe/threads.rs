//! Where a thread cuts the half section: the tool passes it once in each revolution of the spindle.

use chordal_geometry::Vec2;
use chordal_stock::lathe::{LatheStock, OutlineSegment, Region, ToolOutline as Outline};

use super::gather::TurnMove;
use super::report::TurnedThread;

/// Most grooves of one move that are drawn; of a finer thread only the extent is shown.
const MAX_TURNS: f64 = 5000.0;

/// The helix of a threading move.
#[derive(Clone, Copy, Debug)]
pub(super) struct ThreadAdvance {
    /// The lead: the advance in one revolution along z and r, mm.
    pub advance: Vec2,
    /// Where the tool is, or would be, at the last index of the spindle before the move.
    pub start: Vec2,
    /// Whole revolutions from there to the end of the move, rounded up.
    pub turns: i64,
}

/// The angle of the spindle since its index, over the moves of one pass.
#[derive(Debug, Default)]
pub(super) struct SpindleRevolutions {
    /// Share of a revolution at the end of the last move.
    since: f64,
}

impl SpindleRevolutions {
    /// Begins a pass, which waits for the spindle's index.
    pub fn begin(&mut self) {
        self.since = 0.0;
    }

    /// The positions of a move at which the spindle's index passes the section, and the lead along the path, mm
    /// (`None` where it changes). `None` where the revolutions of the move are not known.
    fn places(&mut self, move_: &TurnMove) -> Option<(Vec<Vec2>, Option<f64>)> {
        let path = &move_.path;
        let length = path.start.distance(path.end);
        let advance = move_.feed / move_.rev_per_s;
        let turns = length / advance;
        if path.bend.is_some() || !turns.is_finite() || turns > MAX_TURNS || advance <= 0.0 {
            self.since = 0.0;
            return None;
        }
        let last = self.since + turns;
        let mut places = Vec::new();
        let mut index = self.since.ceil();
        // The margin keeps rounding from losing the groove at the end of a pass.
        while index <= last + 1e-9 {
            // After n revolutions the tool has advanced by first · n + lead_change · n² / 2.
            let n = index - self.since;
            let first = advance - move_.lead_change * turns / 2.0;
            let course = first * n + move_.lead_change * n * n / 2.0;
            let share = if turns > 0.0 { (course / length).min(1.0) } else { 0.0 };
            places.push(path.start + (path.end - path.start) * share);
            index += 1.0;
        }
        self.since = last - last.floor();
        Some((places, (move_.lead_change == 0.0).then_some(advance)))
    }

    /// The helix of a move; `None` where its lead is not known or changes.
    pub fn turn_of(&self, move_: &TurnMove) -> Option<ThreadAdvance> {
        let path = &move_.path;
        let length = path.start.distance(path.end);
        let advance = move_.feed / move_.rev_per_s;
        let turns = length / advance;
        let is_even = path.bend.is_none() && move_.lead_change == 0.0 && advance > 0.0;
        if !is_even || !turns.is_finite() || turns <= 0.0 || turns > MAX_TURNS {
            return None;
        }
        let along = (path.end - path.start) * (advance / length);
        let first = self.since.floor();
        Some(ThreadAdvance {
            advance: along,
            start: path.start + along * (first - self.since),
            turns: (self.since + turns - first).ceil() as i64,
        })
    }

    /// What a move would remove from the section, with its lead (mm); the stock stays as it is.
    pub fn grooves(
        &mut self,
        stock: &LatheStock,
        tool: &Outline,
        move_: &TurnMove,
    ) -> Option<(Region, Option<f64>)> {
        let (places, advance) = self.places(move_)?;
        let mut grooves = Region::default();
        for place in places {
            let (_, taken) = stock.touch(tool, &OutlineSegment::line(place, place)).ok()?;
            if !taken.is_empty() {
                grooves = grooves.union(&taken).ok()?.region;
            }
        }
        Some((grooves, advance))
    }
}

impl TurnedThread {
    /// Adds a pass.
    pub(super) fn add(
        &mut self,
        taken: &Region,
        grooves: Option<(Region, Option<f64>)>,
        line: u32,
    ) {
        if let Ok(both) = self.section.union(taken) {
            self.section = both.region;
        }
        self.line = line;
        self.grooves = match (self.grooves.take(), grooves) {
            (Some(before), Some((more, _))) => before.union(&more).map(|both| both.region).ok(),
            _ => None,
        };
    }
}
