//! Clears a pocket or a slot: level by level, from the inside out, and finishes its edge and its base.

use chordal_geometry::TurnDirection;

use super::MillingContext;
use super::call_values::{
    INSERTION_VALUES, TOOL_TOO_LARGE, check_turns, equal_parts, infeed_depths,
};
use super::mill_path::{COINCIDENT, MillPath, OutlinePiece};
use super::outlines::PocketOutline;
use crate::alarms::NO_ALARM;
use crate::cycles::arguments::{CycleCall, CycleFault};
use crate::cycles::levels::HoleLevels;

/// The largest stepover in radii of the tool at which loops with sharp corners leave nothing between two corners: 1 + √½.
const LARGEST_STEPOVER: f64 = 1.0 + std::f64::consts::FRAC_1_SQRT_2;

/// The radius of the quarter circle to the edge in millimetres, when the allowance is not larger (PGZ, POCKET3).
const APPROACH_RADIUS_MM: f64 = 2.0;

/// How the tool goes down into the material.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum InsertionKind {
    /// Straight at rapid: the middle is drilled.
    Rapid,
    /// Straight at feed.
    Straight,
    /// Along a helix about the middle.
    Helix {
        /// The radius of the path of the tool's centre.
        radius: f64,
        /// The largest depth of a turn.
        depth: f64,
    },
    /// To and fro along the length.
    Ramp {
        /// The largest angle to the plane, degrees.
        degrees: f64,
    },
}

/// A part of a pocket that is open before the cycle: a rectangle about the middle.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct OpenPart {
    /// Half its length and half its width.
    pub(super) half: [f64; 2],
    /// Its depth below the reference plane.
    pub(super) depth: f64,
}

/// A pocket or a slot to be cleared.
pub(super) struct ClearingJob<'a> {
    pub(super) call: &'a CycleCall<'a>,
    pub(super) context: &'a MillingContext,
    pub(super) outline: PocketOutline,
    pub(super) levels: HoleLevels,
    pub(super) tool_radius: f64,
    pub(super) edge_allowance: f64,
    pub(super) base_allowance: f64,
    pub(super) largest_infeed: f64,
    pub(super) stepover: f64,
    pub(super) direction: TurnDirection,
    pub(super) plane_feed: Option<f64>,
    pub(super) depth_feed: Option<f64>,
    pub(super) insertion: InsertionKind,
    /// The tool goes down at the end of the innermost line, not at its middle.
    pub(super) starts_at_end: bool,
    pub(super) open_part: Option<OpenPart>,
    /// The depth to which all of it is open before the cycle.
    pub(super) open_depth: f64,
}

impl ClearingJob<'_> {
    /// Refuses a tool that does not fit.
    ///
    /// # Errors
    /// 61105.
    fn check_tool(&self, allowance: f64) -> Result<(), CycleFault> {
        if self.tool_radius + allowance > self.outline.half_width() + COINCIDENT {
            let text = "the tool does not fit into the shape";
            return Err(self.call.fault(TOOL_TOO_LARGE, None, text));
        }
        Ok(())
    }

    fn entry(&self) -> [f64; 2] {
        self.outline.insertion_point(self.starts_at_end)
    }

    /// To the retract plane over the place of insertion.
    pub(super) fn approach(&self, path: &mut MillPath) {
        path.rapid_over(self.entry(), self.levels.retract, self.levels.direction);
    }

    /// Up to the retract plane, and there over the place of insertion.
    pub(super) fn retract(&self, path: &mut MillPath) {
        path.rapid_to_level(self.levels.retract);
        path.rapid_to(self.entry());
    }

    /// The level a safety distance above another one, but not above the start plane.
    fn above(&self, level: f64) -> f64 {
        let safety = (self.levels.start - self.levels.reference).abs();
        let lifted = level + self.levels.direction * safety;
        if (lifted - self.levels.start) * self.levels.direction > 0.0 {
            self.levels.start
        } else {
            lifted
        }
    }

    /// From where a level was cleared, up and over the place of insertion.
    fn return_to_entry(&self, path: &mut MillPath, cleared: f64) {
        let lifted = self.above(cleared);
        if self.outline.is_convex() {
            path.rapid_to_level(lifted);
            path.rapid_to(self.entry());
        } else {
            path.rapid_to_level(self.levels.start);
            path.rapid_to(self.entry());
            path.rapid_to_level(lifted);
        }
    }

    /// Roughs down to the allowance at the base. The tool is over the place of insertion.
    pub(super) fn rough(&self, path: &mut MillPath) -> Result<(), CycleFault> {
        self.check_tool(self.edge_allowance)?;
        let bottom = self.levels.total() - self.base_allowance;
        let depths =
            infeed_depths(self.call, self.context, self.open_depth, bottom, self.largest_infeed)?;
        self.check_count(depths.len(), self.tool_radius + self.edge_allowance)?;
        path.rapid_to_level(self.levels.start);
        for (index, depth) in depths.iter().enumerate() {
            let level = self.levels.at_depth(*depth);
            let open = self.open_part.filter(|part| *depth <= part.depth + COINCIDENT);
            self.insert(path, level, open)?;
            self.clear_level(path, self.edge_allowance, open)?;
            path.check_length(self.call)?;
            if index + 1 < depths.len() {
                self.return_to_entry(path, level);
            }
        }
        Ok(())
    }

    /// Refuses more loops in all levels together than a run carries out.
    fn check_count(&self, levels: usize, distance: f64) -> Result<(), CycleFault> {
        let loops = self.loop_count(distance)? as usize;
        if levels.saturating_mul(loops) > self.context.max_repetitions as usize {
            let text = format!(
                "{} would take {levels} levels of {loops} loops: check the steps",
                self.call.name()
            );
            return Err(self.call.fault(NO_ALARM, None, &text));
        }
        Ok(())
    }

    /// The number of loops between the innermost line and one at a distance from the outline.
    fn loop_count(&self, distance: f64) -> Result<u32, CycleFault> {
        let width = self.outline.half_width() - distance;
        if width <= COINCIDENT {
            return Ok(0);
        }
        let stepover = self.stepover.min(LARGEST_STEPOVER * self.tool_radius);
        equal_parts(self.call, self.context, width, stepover)
    }

    /// Cuts a level from the place of insertion out to an allowance at the edge.
    fn clear_level(
        &self,
        path: &mut MillPath,
        allowance: f64,
        open: Option<OpenPart>,
    ) -> Result<(), CycleFault> {
        let distance = self.tool_radius + allowance;
        let is_open = |at: f64| {
            open.is_some_and(|part| self.outline.loop_is_inside(at, self.tool_radius, part.half))
        };
        let width = self.outline.half_width();
        if !is_open(width) {
            let starts_at_end = self.starts_at_end || !self.outline.is_convex();
            path.cut_pieces(&self.outline.inner_cut(starts_at_end), self.plane_feed);
        }
        let count = self.loop_count(distance)?;
        for index in (0..count).rev() {
            let at = distance + (width - distance) * f64::from(index) / f64::from(count);
            if is_open(at) {
                continue;
            }
            path.cut_to(self.outline.loop_start(at), self.plane_feed);
            path.cut_pieces(&self.outline.inner_loop(at, self.direction), self.plane_feed);
        }
        Ok(())
    }

    /// Down to a level at the place of insertion.
    fn insert(
        &self,
        path: &mut MillPath,
        level: f64,
        open: Option<OpenPart>,
    ) -> Result<(), CycleFault> {
        let fits = |part: OpenPart| part.half.iter().all(|half| *half >= self.tool_radius);
        if open.is_some_and(fits) {
            path.cut_to_level(level, self.depth_feed);
            return Ok(());
        }
        match self.insertion {
            InsertionKind::Rapid => path.rapid_to_level(level),
            InsertionKind::Straight => path.cut_to_level(level, self.depth_feed),
            InsertionKind::Helix { radius, depth } => self.helix(path, level, radius, depth)?,
            InsertionKind::Ramp { degrees } => self.ramp(path, level, degrees)?,
        }
        Ok(())
    }

    /// Whole turns about the middle, and a full circle at the end (PGZ, POCKET3).
    fn helix(
        &self,
        path: &mut MillPath,
        level: f64,
        radius: f64,
        depth: f64,
    ) -> Result<(), CycleFault> {
        let room = self.outline.half_width() - self.tool_radius - self.edge_allowance;
        if radius <= COINCIDENT || depth <= 0.0 || radius > room + COINCIDENT {
            let text = "the helix of _RAD1 and _DP1 does not fit into the pocket";
            return Err(self.call.fault(INSERTION_VALUES, Some("_RAD1"), text));
        }
        let height = (path.level() - level).abs();
        let turns = equal_parts(self.call, self.context, height, depth)?;
        let begin = [radius, 0.0];
        check_turns(self.call, f64::from(turns))?;
        path.cut_to(begin, self.depth_feed);
        if turns > 0 {
            path.arc([0.0; 2], self.direction, (begin, level), turns - 1, self.depth_feed);
        }
        path.arc([0.0; 2], self.direction, (begin, level), 0, self.depth_feed);
        Ok(())
    }

    /// To and fro along the length with equal depths, once more at the level, and back to the middle (PGZ, POCKET3).
    fn ramp(&self, path: &mut MillPath, level: f64, degrees: f64) -> Result<(), CycleFault> {
        let (half, along) = self.outline.ramp(self.tool_radius + self.edge_allowance);
        if half <= COINCIDENT || degrees <= 0.0 || degrees >= 90.0 {
            let text = "the ramp of _RAD1 does not fit into the pocket";
            return Err(self.call.fault(INSERTION_VALUES, Some("_RAD1"), text));
        }
        let from = path.level();
        let steepest = 2.0 * half * libm::tan(degrees.to_radians());
        let strokes = equal_parts(self.call, self.context, (from - level).abs(), steepest)?;
        let mut side = half;
        let end = |side: f64| along.map(|part| part * side);
        path.cut_to(end(side), self.depth_feed);
        for stroke in 1..=strokes {
            side = -side;
            let down = from + (level - from) * f64::from(stroke) / f64::from(strokes);
            let down = if stroke == strokes { level } else { down };
            path.cut_down_to(end(side), down, self.depth_feed);
        }
        path.cut_to(end(-side), self.depth_feed);
        path.cut_to([0.0; 2], self.depth_feed);
        Ok(())
    }

    /// Finishes the edge level by level down to a depth: once round, on and off along quarter circles. The tool is above the
    /// start plane.
    pub(super) fn finish_edge(
        &self,
        path: &mut MillPath,
        bottom: f64,
        largest_infeed: f64,
        feed: Option<f64>,
    ) -> Result<(), CycleFault> {
        self.check_tool(0.0)?;
        let distance = self.tool_radius;
        let depths = infeed_depths(self.call, self.context, 0.0, bottom, largest_infeed)?;
        self.check_count(depths.len(), distance)?;
        let start = self.outline.loop_start(distance);
        let allowance = self.edge_allowance;
        let room = (self.outline.half_width() - distance).max(0.0);
        let radius = (APPROACH_RADIUS_MM / self.context.unit_mm).max(allowance).min(room);
        let quarter = QuarterCircles::new(start, radius, self.direction);
        // Where roughing has been, the tool goes down at rapid. The end of a slot is the narrowest shape.
        let reach = (room - radius).hypot(radius);
        let is_free = allowance > 0.0 && reach <= room - allowance + COINCIDENT;
        for depth in depths {
            let level = self.levels.at_depth(depth);
            path.rapid_to_level(self.levels.start);
            path.rapid_to(quarter.begin);
            match is_free {
                true => path.rapid_to_level(level),
                false => path.cut_to_level(level, self.depth_feed),
            }
            path.cut_pieces(&quarter.on(), feed);
            path.cut_pieces(&self.outline.inner_loop(distance, self.direction), feed);
            path.cut_pieces(&quarter.off(), feed);
            path.check_length(self.call)?;
            path.rapid_to_level(self.levels.start);
        }
        Ok(())
    }

    /// Finishes the base: rapid to a safety distance above the allowance, down at feed, and once over all of it.
    pub(super) fn finish_base(&self, path: &mut MillPath) -> Result<(), CycleFault> {
        self.check_tool(0.0)?;
        self.check_count(1, self.tool_radius)?;
        path.rapid_to_level(self.levels.start);
        path.rapid_to(self.entry());
        let left = self.levels.at_depth(self.levels.total() - self.base_allowance);
        path.rapid_to_level(self.above(left));
        path.cut_to_level(self.levels.bottom, self.depth_feed);
        self.clear_level(path, 0.0, None)
    }
}

/// Quarter circles that touch a loop inside an outline where it begins.
struct QuarterCircles {
    begin: [f64; 2],
    start: [f64; 2],
    radius: f64,
    direction: TurnDirection,
}

impl QuarterCircles {
    fn new(start: [f64; 2], radius: f64, direction: TurnDirection) -> QuarterCircles {
        let begin = match radius > COINCIDENT {
            true => [start[0] - radius, -radius * direction.sign()],
            false => start,
        };
        QuarterCircles { begin, start, radius, direction }
    }

    fn arc(&self, to: [f64; 2]) -> Vec<OutlinePiece> {
        if self.radius <= COINCIDENT {
            return Vec::new();
        }
        let center = [self.start[0] - self.radius, 0.0];
        vec![OutlinePiece::Arc { center, direction: self.direction, to }]
    }

    fn on(&self) -> Vec<OutlinePiece> {
        self.arc(self.start)
    }

    fn off(&self) -> Vec<OutlinePiece> {
        self.arc([self.begin[0], -self.begin[1]])
    }
}
