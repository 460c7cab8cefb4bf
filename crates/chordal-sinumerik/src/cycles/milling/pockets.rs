//! POCKET1 to POCKET4: rectangular and circular pockets (PGZ, 3.6 to 3.9).

use super::MillingContext;
use super::call_values::{
    BASE_ALLOWANCE, KIND_OF_MACHINING, MilledSide, NO_SIZE, TOOL_TOO_LARGE, check_display_digits,
    direction, feed, planes, reference_point, stepover, tool_radius,
};
use super::clearing::{ClearingJob, InsertionKind, OpenPart};
use super::mill_path::{MillPath, ShapeFrame};
use super::outlines::PocketOutline;
use crate::cycles::arguments::{CycleCall, CycleFault};
use crate::cycles::levels::{HoleLevels, unmodelled};

/// The radius of the corners is too large.
const CORNER_TOO_LARGE: u32 = 61_113;

/// POCKET3. Returns the radius of the corners when the tool is too large for the one that is programmed.
pub(super) fn rectangle(
    call: &CycleCall<'_>,
    context: &MillingContext,
    path: &mut MillPath,
) -> Result<Option<f64>, CycleFault> {
    let outline = rectangle_outline(call, ["_LENG", "_WID", "_CRAD"])?;
    path.set_frame(ShapeFrame::new(
        reference_point(call, context, ["_PA", "_PO"]),
        call.number("_STA"),
    ));
    pocket(call, context, outline, path)?;
    enlarged_corner(call, context, outline)
}

/// POCKET4.
pub(super) fn circle(
    call: &CycleCall<'_>,
    context: &MillingContext,
    path: &mut MillPath,
) -> Result<(), CycleFault> {
    let outline = circle_outline(call, "_PRAD")?;
    path.set_frame(ShapeFrame::new(reference_point(call, context, ["_PA", "_PO"]), 0.0));
    pocket(call, context, outline, path)
}

/// POCKET1. Returns the radius of the corners when the tool is too large for the one that is programmed.
pub(super) fn old_rectangle(
    call: &CycleCall<'_>,
    context: &MillingContext,
    path: &mut MillPath,
) -> Result<Option<f64>, CycleFault> {
    let outline = rectangle_outline(call, ["LENG", "WID", "CRAD"])?;
    path.set_frame(ShapeFrame::new(
        reference_point(call, context, ["CPA", "CPO"]),
        call.number("STA1"),
    ));
    old_pocket(call, context, outline, path)?;
    enlarged_corner(call, context, outline)
}

/// POCKET2.
pub(super) fn old_circle(
    call: &CycleCall<'_>,
    context: &MillingContext,
    path: &mut MillPath,
) -> Result<(), CycleFault> {
    let outline = circle_outline(call, "PRAD")?;
    path.set_frame(ShapeFrame::new(reference_point(call, context, ["CPA", "CPO"]), 0.0));
    old_pocket(call, context, outline, path)
}

fn rectangle_outline(
    call: &CycleCall<'_>,
    [length, width, corner]: [&str; 3],
) -> Result<PocketOutline, CycleFault> {
    let half = [length, width].map(|name| call.magnitude(name) / 2.0);
    if half.contains(&0.0) {
        let text = format!("{length} and {width} must not be 0");
        return Err(call.fault(NO_SIZE, Some(length), &text));
    }
    let radius = call.magnitude(corner);
    if radius > half[0].min(half[1]) * (1.0 + 1e-12) {
        let text = format!("{corner} is larger than half the width");
        return Err(call.fault(CORNER_TOO_LARGE, Some(corner), &text));
    }
    Ok(PocketOutline::Rectangle { half, corner: radius })
}

fn circle_outline(call: &CycleCall<'_>, radius: &str) -> Result<PocketOutline, CycleFault> {
    match call.magnitude(radius) {
        0.0 => Err(call.fault(NO_SIZE, Some(radius), &format!("{radius} must not be 0"))),
        radius => Ok(PocketOutline::Circle { radius }),
    }
}

/// The radius of the corners when the tool is too large for the one that is programmed: that of the tool (PGZ, POCKET3). An
/// alarm (61105) stops the cycle only when the tool does not fit between the sides; a corner radius of 0 is allowed.
fn enlarged_corner(
    call: &CycleCall<'_>,
    context: &MillingContext,
    outline: PocketOutline,
) -> Result<Option<f64>, CycleFault> {
    let tool = tool_radius(call, context)?;
    Ok(match outline {
        PocketOutline::Rectangle { corner, .. } if corner > 0.0 && corner < tool => Some(tool),
        _ => None,
    })
}

/// POCKET3 and POCKET4 with an outline.
fn pocket(
    call: &CycleCall<'_>,
    context: &MillingContext,
    outline: PocketOutline,
    path: &mut MillPath,
) -> Result<(), CycleFault> {
    check_display_digits(call, context)?;
    let Some(levels) = planes(call, ["_RTP", "_RFP", "_SDIS", "_DP"])? else { return Ok(()) };
    let tool = tool_radius(call, context)?;
    let (infeed, base) = (call.magnitude("_MID"), call.magnitude("_FALD"));
    if infeed > 0.0 && base > infeed {
        let text = "the allowance _FALD is larger than the infeed _MID";
        return Err(call.fault(BASE_ALLOWANCE, Some("_FALD"), text));
    }
    let kind = call.integer("_VARI");
    let (open_part, open_depth) = open_parts(call, &levels)?;
    let job = ClearingJob {
        call,
        context,
        outline,
        levels,
        tool_radius: tool,
        edge_allowance: call.magnitude("_FAL"),
        base_allowance: base,
        largest_infeed: infeed,
        stepover: stepover(call, tool, call.integer("_AMODE") / 10 % 10 == 1)?,
        direction: direction(call, context, "_CDIR", MilledSide::Inside)?,
        plane_feed: feed(call, context, "_FFP1")?,
        depth_feed: feed(call, context, "_FFD")?,
        insertion: insertion(call, kind / 10 % 10)?,
        starts_at_end: false,
        open_part,
        open_depth,
    };
    job.approach(path);
    match kind % 10 {
        1 => job.rough(path)?,
        2 => finish(&job, path)?,
        // The edge alone is finished down to the depth (NC Programming 12/2019).
        4 => job.finish_edge(path, job.levels.total(), job.largest_infeed, job.plane_feed)?,
        5 => return Err(unmodelled(call, "_VARI")),
        _ => {
            let text = "the ones of _VARI must be 1 (rough) or 2 (finish)";
            return Err(call.fault(KIND_OF_MACHINING, Some("_VARI"), text));
        }
    }
    job.retract(path);
    Ok(())
}

/// The edge down to the allowance at the base, then the base; what has no allowance is left out (PGZ, POCKET3).
fn finish(job: &ClearingJob<'_>, path: &mut MillPath) -> Result<(), CycleFault> {
    if job.edge_allowance > 0.0 {
        let bottom = job.levels.total() - job.base_allowance;
        job.finish_edge(path, bottom, job.largest_infeed, job.plane_feed)?;
    }
    if job.base_allowance > 0.0 {
        job.finish_base(path)?;
    }
    Ok(())
}

/// The kind of insertion by the tens of `_VARI`: 0 and 1 straight at rapid and at feed, 2 helix, 3 to and fro.
fn insertion(call: &CycleCall<'_>, tens: i64) -> Result<InsertionKind, CycleFault> {
    match (tens, call.name()) {
        (0, _) => Ok(InsertionKind::Rapid),
        (1, _) => Ok(InsertionKind::Straight),
        (2, _) => Ok(InsertionKind::Helix {
            radius: call.magnitude("_RAD1"),
            depth: call.magnitude("_DP1"),
        }),
        (3, "POCKET3") => Ok(InsertionKind::Ramp { degrees: call.magnitude("_RAD1") }),
        _ => {
            let text = "the tens of _VARI name no kind of insertion";
            Err(call.fault(KIND_OF_MACHINING, Some("_VARI"), text))
        }
    }
}

/// What is open before the cycle: a part in the middle (`_AP1`, `_AP2`) down to a depth (`_AD`), or all of it down to that
/// depth. The newer digits say whether these arguments count: ten thousands of `_GMODE`, 1 for no and 2 for yes.
///
/// That a part without a depth is open all the way down is no rule of the manual.
fn open_parts(
    call: &CycleCall<'_>,
    levels: &HoleLevels,
) -> Result<(Option<OpenPart>, f64), CycleFault> {
    match call.integer("_GMODE") / 10_000 % 10 {
        0 | 2 => {}
        1 => return Ok((None, 0.0)),
        _ => return Err(unmodelled(call, "_GMODE")),
    }
    let depth = call.magnitude("_AD").min(levels.total());
    // POCKET4 has the radius of the open part.
    let half = match call.name() {
        "POCKET4" => {
            [call.magnitude("_AP1"); 2].map(|radius| radius * std::f64::consts::FRAC_1_SQRT_2)
        }
        _ => ["_AP1", "_AP2"].map(|name| call.magnitude(name) / 2.0),
    };
    if half.contains(&0.0) {
        return Ok((None, depth));
    }
    let depth = if depth == 0.0 { levels.total() } else { depth };
    Ok((Some(OpenPart { half, depth }), 0.0))
}

/// POCKET1 and POCKET2 with an outline: roughing with the default stepover, finishing of the edge at values of its own.
fn old_pocket(
    call: &CycleCall<'_>,
    context: &MillingContext,
    outline: PocketOutline,
    path: &mut MillPath,
) -> Result<(), CycleFault> {
    let Some(levels) = HoleLevels::of_call(call)? else { return Ok(()) };
    let tool = tool_radius(call, context)?;
    let job = ClearingJob {
        call,
        context,
        outline,
        levels,
        tool_radius: tool,
        edge_allowance: call.magnitude("FAL"),
        base_allowance: 0.0,
        largest_infeed: call.magnitude("MID"),
        stepover: stepover(call, tool, false)?,
        direction: direction(call, context, "CDIR", MilledSide::Inside)?,
        plane_feed: feed(call, context, "FFP1")?,
        depth_feed: feed(call, context, "FFD")?,
        insertion: InsertionKind::Straight,
        starts_at_end: false,
        open_part: None,
        open_depth: 0.0,
    };
    job.approach(path);
    rough_and_finish(&job, call.integer("VARI"), path)?;
    job.retract(path);
    Ok(())
}

/// The older kinds of machining: 0 complete, 1 rough, 2 finish. Finishing has an infeed (MIDF), a feed (FFP2) and a speed
/// (SSF) of its own; 0 is one infeed, the feed in the plane, the speed of the program.
pub(super) fn rough_and_finish(
    job: &ClearingJob<'_>,
    kind: i64,
    path: &mut MillPath,
) -> Result<(), CycleFault> {
    if !(0..=2).contains(&kind) {
        let text = "the ones of VARI must be 0 (complete), 1 (rough) or 2 (finish)";
        return Err(job.call.fault(KIND_OF_MACHINING, Some("VARI"), text));
    }
    if kind != 2 {
        job.rough(path)?;
    }
    let has_allowance = job.edge_allowance > 0.0;
    if kind == 2 || (kind == 0 && has_allowance) {
        let speed = job.call.magnitude("SSF");
        let finishing = job.call.number("FFP2");
        let feed = if finishing > 0.0 { Some(finishing) } else { job.plane_feed };
        path.set_speed(speed);
        path.rapid_to_level(job.levels.start);
        job.finish_edge(path, job.levels.total(), job.call.magnitude("MIDF"), feed)?;
        path.end_speed(speed);
    }
    Ok(())
}

/// Refuses a tool that is too large for a width.
///
/// # Errors
/// 61105.
pub(super) fn check_width(
    call: &CycleCall<'_>,
    tool_radius: f64,
    width: f64,
) -> Result<(), CycleFault> {
    if 2.0 * tool_radius > width * (1.0 + 1e-12) {
        return Err(call.fault(TOOL_TOO_LARGE, None, "the tool is wider than the slot"));
    }
    Ok(())
}
