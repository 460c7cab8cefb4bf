//! CYCLE90: milling of internal and external threads (PGZ, 3.1).

use chordal_geometry::TurnDirection;

use super::MillingContext;
use super::call_values::{
    MilledSide, TOOL_TOO_LARGE, check_turns, direction, feed, reference_point, tool_radius,
};
use super::mill_path::{COINCIDENT, MillPath, ShapeFrame};
use crate::cycles::arguments::{CycleCall, CycleFault};
use crate::cycles::levels::HoleLevels;
use crate::cycles::taps::THREAD_LEAD;

/// The nominal or the core diameter is wrong.
const THREAD_DIAMETERS: u32 = 61_119;

/// Neither internal nor external.
const KIND_OF_THREAD: u32 = 61_120;

/// A thread and the path of the tool's centre.
struct ThreadMilling {
    /// The radius of the helix.
    radius: f64,
    /// The radius of the quarter circles on and off.
    approach: f64,
    /// How far these go along the thread.
    overrun: f64,
    lead: f64,
    /// 1 where the part is outside the helix (internal), -1 where it is inside.
    inward: f64,
    turn: TurnDirection,
    feed: Option<f64>,
}

/// Down to the start plane, on along a quarter circle, along the helix to the depth, off along a quarter circle, up.
pub(super) fn mill(
    call: &CycleCall<'_>,
    context: &MillingContext,
    path: &mut MillPath,
) -> Result<(), CycleFault> {
    let Some(levels) = HoleLevels::of_call(call)? else { return Ok(()) };
    let thread = ThreadMilling::of_call(call, context)?;
    path.set_frame(ShapeFrame::new(reference_point(call, context, ["CPA", "CPO"]), 0.0));
    path.rapid_over(thread.quarter_end(0.0, -1.0), levels.retract, levels.direction);
    path.rapid_to_level(levels.start);
    check_turns(call, (levels.start - levels.bottom).abs() / thread.lead)?;
    thread.cut(&levels, path);
    path.rapid_to_level(levels.retract);
    Ok(())
}

impl ThreadMilling {
    fn of_call(
        call: &CycleCall<'_>,
        context: &MillingContext,
    ) -> Result<ThreadMilling, CycleFault> {
        let tool = tool_radius(call, context)?;
        let [nominal, core] = ["DIATH", "KDIAM"].map(|name| call.magnitude(name));
        let is_internal = match call.integer("TYPTH") {
            0 => true,
            1 => false,
            _ => {
                let text = "TYPTH must be 0 (internal) or 1 (external)";
                return Err(call.fault(KIND_OF_THREAD, Some("TYPTH"), text));
            }
        };
        if nominal == 0.0 || core >= nominal || (!is_internal && core == 0.0) {
            let text = "DIATH must be larger than KDIAM";
            return Err(call.fault(THREAD_DIAMETERS, Some("DIATH"), text));
        }
        let lead = call.magnitude("PIT");
        if lead == 0.0 {
            return Err(call.fault(THREAD_LEAD, Some("PIT"), "PIT must not be 0"));
        }
        let opening = if core > 0.0 { core } else { nominal };
        if is_internal && 2.0 * tool >= opening {
            return Err(call.fault(
                TOOL_TOO_LARGE,
                None,
                "the tool does not fit into the core hole",
            ));
        }
        // The overrun of the manual: lead / 4 · (2 · tool radius + radius of the exit) / nominal diameter.
        let off = if is_internal { nominal / 2.0 - tool } else { nominal / 2.0 + tool };
        let overrun = lead / 4.0 * (2.0 * tool + off) / nominal;
        let (radius, approach, inward, side) = match is_internal {
            true => (nominal / 2.0 - tool, (nominal / 2.0 - tool) / 2.0, 1.0, MilledSide::Inside),
            // So far that the tool is beside the thread where it goes down.
            false => (core / 2.0 + tool, (nominal - core) / 2.0 + tool, -1.0, MilledSide::Outside),
        };
        let turn = direction(call, context, "CDIR", side)?;
        let feed = feed(call, context, "FFR")?;
        Ok(ThreadMilling { radius, approach, overrun, lead, inward, turn, feed })
    }

    /// The center of the quarter circles at an angle of the helix, rad.
    fn quarter_center(&self, angle: f64) -> [f64; 2] {
        let (sin, cos) = libm::sincos(angle);
        let radius = self.radius - self.inward * self.approach;
        [radius * cos, radius * sin]
    }

    /// Where a quarter circle on (-1) or off (1) at an angle of the helix has its other end.
    fn quarter_end(&self, angle: f64, end: f64) -> [f64; 2] {
        let (sin, cos) = libm::sincos(angle);
        let [a, b] = self.quarter_center(angle);
        let along = end * self.turn.sign() * self.approach;
        [a - sin * along, b + cos * along]
    }

    fn cut(&self, levels: &HoleLevels, path: &mut MillPath) {
        let down = levels.direction;
        // A helix outside turns the other direction than the quarter circles that touch it.
        let quarter = self.turn.mirrored_if(self.inward < 0.0);
        let length = ((levels.start - levels.bottom).abs() - self.overrun).max(0.0);
        let top = levels.bottom + down * length;
        let begin = [self.radius, 0.0];
        path.arc(self.quarter_center(0.0), quarter, (begin, top), 0, self.feed);
        let turns = length / self.lead;
        // A last turn that is whole but for rounding.
        let whole = (turns + COINCIDENT).floor();
        let rest = (turns - whole).max(0.0);
        let rest = if rest <= COINCIDENT { 0.0 } else { rest };
        let level = if rest == 0.0 { levels.bottom } else { top - down * self.lead * whole };
        if whole > 0.0 {
            let more = (whole - 1.0).min(f64::from(u32::MAX)) as u32;
            path.arc([0.0; 2], self.turn, (begin, level), more, self.feed);
        }
        let angle = self.turn.sign() * std::f64::consts::TAU * rest;
        if rest > 0.0 {
            let (sin, cos) = libm::sincos(angle);
            let end = [self.radius * cos, self.radius * sin];
            path.arc([0.0; 2], self.turn, (end, levels.bottom), 0, self.feed);
        }
        let off = (self.quarter_end(angle, 1.0), levels.bottom - down * self.overrun);
        path.arc(self.quarter_center(angle), quarter, off, 0, self.feed);
    }
}
