//! SLOT1, SLOT2 and LONGHOLE: slots on a circle (PGZ, 3.3 to 3.5).
//!
//! The figures of the manual measure the length of a slot (LENG) with its round ends and the radius (RAD) to its inner end,
//! and the angle of a slot along the circle (AFSL) between the centres of its ends; its text does not say so.

use super::MillingContext;
use super::call_values::{
    INSERTION_ANGLE, MilledSide, NO_SIZE, check_display_digits, direction, feed, infeed_depths,
    reference_point, tool_radius,
};
use super::clearing::{ClearingJob, InsertionKind};
use super::mill_path::{MillPath, ShapeFrame};
use super::outlines::PocketOutline;
use super::pockets::{check_width, rough_and_finish};
use crate::cycles::arguments::{CycleCall, CycleFault};
use crate::cycles::levels::{HoleLevels, unmodelled};
use crate::cycles::patterns::{CIRCLE_ELEMENTS, NO_HOLES};

/// Slots cut into each other.
const SLOTS_OVERLAP: u32 = 61_104;

/// The places of slots on a circle.
struct SlotCircle {
    center: [f64; 2],
    radius: f64,
    first_degrees: f64,
    pitch_degrees: f64,
    count: u32,
}

impl SlotCircle {
    /// The circle of a call: CPA, CPO, RAD, STA1, INDA and NUM.
    ///
    /// # Errors
    /// 61103 without slots; 61106 when they do not fit on the circle, or there are more than a run carries out.
    fn of_call(call: &CycleCall<'_>, context: &MillingContext) -> Result<SlotCircle, CycleFault> {
        let number = call.integer("NUM");
        if number <= 0 {
            return Err(call.fault(NO_HOLES, Some("NUM"), "the number of slots is 0"));
        }
        let pitch = call.number("INDA");
        let span = pitch.abs() * (number - 1) as f64;
        if number > i64::from(context.max_repetitions) || span >= 360.0 {
            let text = format!("{number} slots do not fit on the circle");
            return Err(call.fault(CIRCLE_ELEMENTS, Some("NUM"), &text));
        }
        let pitch_degrees = if pitch == 0.0 { 360.0 / number as f64 } else { pitch };
        Ok(SlotCircle {
            center: reference_point(call, context, ["CPA", "CPO"]),
            radius: call.magnitude("RAD"),
            first_degrees: call.number("STA1"),
            pitch_degrees,
            count: number as u32,
        })
    }

    /// The angles of the slots in order, degrees.
    fn angles(&self) -> impl Iterator<Item = f64> + '_ {
        (0..self.count).map(|slot| self.first_degrees + self.pitch_degrees * f64::from(slot))
    }

    /// The smallest angle between two slots that are next to each other, degrees; 360 for a single one.
    fn smallest_pitch(&self) -> f64 {
        match self.count {
            1 => 360.0,
            count => {
                let around = 360.0 - self.pitch_degrees.abs() * f64::from(count - 1);
                self.pitch_degrees.abs().min(around)
            }
        }
    }

    /// Refuses slots of a width whose ends at a radius would meet, where a gap of an angle is between these ends.
    ///
    /// # Errors
    /// 61104.
    fn check_gap(
        &self,
        call: &CycleCall<'_>,
        radius: f64,
        gap_degrees: f64,
        width: f64,
    ) -> Result<(), CycleFault> {
        let gap = 2.0 * radius * libm::sin((gap_degrees.clamp(0.0, 180.0) / 2.0).to_radians());
        if self.count > 1 && gap < width * (1.0 - 1e-12) {
            let text = "the slots cut into each other: check RAD, INDA and the size of a slot";
            return Err(call.fault(SLOTS_OVERLAP, Some("RAD"), text));
        }
        Ok(())
    }
}

/// SLOT1: slots that point to the centre of a circle.
pub(super) fn radial(
    call: &CycleCall<'_>,
    context: &MillingContext,
    path: &mut MillPath,
) -> Result<(), CycleFault> {
    let [length, width] = ["LENG", "WID"].map(|name| call.magnitude(name));
    if width == 0.0 || length < width {
        let text = "LENG must not be less than WID, and WID not 0";
        return Err(call.fault(NO_SIZE, Some("LENG"), text));
    }
    let circle = SlotCircle::of_call(call, context)?;
    circle.check_gap(call, circle.radius + width / 2.0, circle.smallest_pitch(), width)?;
    let outline =
        PocketOutline::Rectangle { half: [length / 2.0, width / 2.0], corner: width / 2.0 };
    let frames = circle.angles().map(|degrees| {
        let middle = ShapeFrame::new(circle.center, degrees);
        ShapeFrame::new(middle.point([circle.radius + length / 2.0, 0.0]), degrees)
    });
    slots(call, context, width, outline, frames, path)
}

/// SLOT2: slots along a circle.
pub(super) fn circumferential(
    call: &CycleCall<'_>,
    context: &MillingContext,
    path: &mut MillPath,
) -> Result<(), CycleFault> {
    let [angle, width] = ["AFSL", "WID"].map(|name| call.magnitude(name));
    let circle = SlotCircle::of_call(call, context)?;
    if width == 0.0 || angle == 0.0 || angle >= 360.0 || circle.radius <= width / 2.0 {
        let text = "AFSL must be between 0 and 360, and WID between 0 and twice RAD";
        return Err(call.fault(NO_SIZE, Some("AFSL"), text));
    }
    circle.check_gap(call, circle.radius, circle.smallest_pitch() - angle, width)?;
    let outline = PocketOutline::ArcSlot {
        radius: circle.radius,
        half_angle: angle.to_radians() / 2.0,
        half_width: width / 2.0,
    };
    // STA1 is the angle of the first end.
    let frames =
        circle.angles().map(|degrees| ShapeFrame::new(circle.center, degrees + angle / 2.0));
    slots(call, context, width, outline, frames, path)
}

/// The slots of a call, one after the other.
fn slots(
    call: &CycleCall<'_>,
    context: &MillingContext,
    width: f64,
    outline: PocketOutline,
    frames: impl Iterator<Item = ShapeFrame>,
    path: &mut MillPath,
) -> Result<(), CycleFault> {
    check_display_digits(call, context)?;
    let Some(levels) = HoleLevels::of_call(call)? else { return Ok(()) };
    let tool = tool_radius(call, context)?;
    check_width(call, tool, width)?;
    let kind = call.integer("VARI");
    let job = ClearingJob {
        call,
        context,
        outline,
        levels,
        tool_radius: tool,
        edge_allowance: call.magnitude("FAL"),
        base_allowance: 0.0,
        largest_infeed: call.magnitude("MID"),
        stepover: 1.6 * tool,
        direction: direction(call, context, "CDIR", MilledSide::Inside)?,
        plane_feed: feed(call, context, "FFP1")?,
        depth_feed: feed(call, context, "FFD")?,
        insertion: insertion(call, kind / 10)?,
        starts_at_end: true,
        open_part: None,
        open_depth: 0.0,
    };
    if call.number("_FALD") != 0.0 {
        return Err(unmodelled(call, "_FALD"));
    }
    for frame in frames {
        path.set_frame(frame);
        path.check_length(call)?;
        job.approach(path);
        rough_and_finish(&job, kind % 10, path)?;
        job.retract(path);
    }
    Ok(())
}

/// The kind of insertion by the tens of VARI: 0 and 1 straight, 3 to and fro. The manual of 09/2001 has no tens and goes down
/// at feed; newer ones name 0 a rapid, which would break the tool in a slot that is not open: it is taken as a feed.
fn insertion(call: &CycleCall<'_>, tens: i64) -> Result<InsertionKind, CycleFault> {
    match tens {
        0 | 1 => Ok(InsertionKind::Straight),
        3 if call.name() == "SLOT1" => match call.magnitude("_STA2") {
            0.0 => {
                let text = "the angle of insertion _STA2 must not be 0";
                Err(call.fault(INSERTION_ANGLE, Some("_STA2"), text))
            }
            degrees => Ok(InsertionKind::Ramp { degrees }),
        },
        _ => Err(unmodelled(call, "VARI")),
    }
}

/// LONGHOLE: slots as wide as the tool. The tool goes to and fro, down at each end, and begins at the nearer end.
pub(super) fn long_holes(
    call: &CycleCall<'_>,
    context: &MillingContext,
    path: &mut MillPath,
) -> Result<(), CycleFault> {
    check_display_digits(call, context)?;
    let Some(levels) = HoleLevels::of_call(call)? else { return Ok(()) };
    let tool = tool_radius(call, context)?;
    let length = call.magnitude("LENG");
    check_width(call, tool, length)?;
    if call.integer("_VARI") != 0 {
        return Err(unmodelled(call, "_VARI"));
    }
    let circle = SlotCircle::of_call(call, context)?;
    let ends = [circle.radius + tool, circle.radius + length - tool];
    circle.check_gap(call, ends[0], circle.smallest_pitch(), 2.0 * tool)?;
    let [plane, down] = [feed(call, context, "FFP1")?, feed(call, context, "FFD")?];
    let depths = infeed_depths(call, context, 0.0, levels.total(), call.magnitude("MID"))?;
    for degrees in circle.angles() {
        let frame = ShapeFrame::new(circle.center, degrees);
        path.set_frame(frame);
        let [a, b] = path.place();
        let distance = |end: f64| {
            let [x, y] = frame.point([end, 0.0]);
            (x - a).hypot(y - b)
        };
        let mut order = ends;
        if distance(ends[1]) < distance(ends[0]) {
            order.reverse();
        }
        path.rapid_over([order[0], 0.0], levels.retract, levels.direction);
        path.rapid_to_level(levels.start);
        for depth in &depths {
            path.cut_to_level(levels.at_depth(*depth), down);
            path.cut_to([order[1], 0.0], plane);
            order.reverse();
        }
        path.check_length(call)?;
        path.rapid_to_level(levels.retract);
    }
    Ok(())
}
