//! CYCLE76 and CYCLE77: rectangular and circular spigots (PGZ, 3.12 and 3.13). At each level the tool goes once round, on and
//! off along semicircles that begin and end beside the blank on the positive side of the length; what the blank has beyond
//! the diameter of the tool stays.

use chordal_geometry::TurnDirection;

use super::MillingContext;
use super::call_values::{
    KIND_OF_MACHINING, MilledSide, NO_SIZE, check_display_digits, direction, feed, infeed_depths,
    reference_point, tool_radius,
};
use super::mill_path::{COINCIDENT, MillPath, OutlinePiece, ShapeFrame};
use super::outlines::rectangle_loop;
use crate::cycles::arguments::{CycleCall, CycleFault};
use crate::cycles::levels::{HoleLevels, LevelNames, unmodelled};

/// The names of the planes of both cycles.
const PLANES: LevelNames = LevelNames {
    retract: "_RTP",
    reference: "_RFP",
    safety: "_SDIS",
    depth: "_DP",
    relative_depth: "_DPR",
};

/// The shape that stays.
#[derive(Clone, Copy)]
enum SpigotOutline {
    Rectangle { half: [f64; 2], corner: f64 },
    Circle { radius: f64 },
}

impl SpigotOutline {
    /// The loop at a distance around it, counterclockwise from its positive side on the first axis, and its begin.
    fn outer_loop(self, distance: f64) -> ([f64; 2], Vec<OutlinePiece>) {
        match self {
            SpigotOutline::Rectangle { half, corner } => {
                let half = half.map(|half| half + distance);
                ([half[0], 0.0], rectangle_loop(half, corner + distance))
            }
            SpigotOutline::Circle { radius } => {
                let to = [radius + distance, 0.0];
                let circle =
                    OutlinePiece::Arc { center: [0.0; 2], direction: TurnDirection::Ccw, to };
                (to, vec![circle])
            }
        }
    }
}

/// CYCLE76.
pub(super) fn rectangle(
    call: &CycleCall<'_>,
    context: &MillingContext,
    path: &mut MillPath,
) -> Result<(), CycleFault> {
    let half = ["_LENG", "_WID"].map(|name| call.magnitude(name) / 2.0);
    if half.contains(&0.0) {
        return Err(call.fault(NO_SIZE, Some("_LENG"), "_LENG and _WID must not be 0"));
    }
    let corner = call.magnitude("_CRAD").min(half[0]).min(half[1]);
    path.set_frame(ShapeFrame::new(
        reference_point(call, context, ["_PA", "_PO"]),
        call.number("_STA"),
    ));
    mill(call, context, SpigotOutline::Rectangle { half, corner }, path)
}

/// CYCLE77: `_PRAD` and `_AP1` are diameters.
pub(super) fn circle(
    call: &CycleCall<'_>,
    context: &MillingContext,
    path: &mut MillPath,
) -> Result<(), CycleFault> {
    let radius = call.magnitude("_PRAD") / 2.0;
    if radius == 0.0 {
        return Err(call.fault(NO_SIZE, Some("_PRAD"), "_PRAD must not be 0"));
    }
    path.set_frame(ShapeFrame::new(reference_point(call, context, ["_PA", "_PO"]), 0.0));
    mill(call, context, SpigotOutline::Circle { radius }, path)
}

fn mill(
    call: &CycleCall<'_>,
    context: &MillingContext,
    outline: SpigotOutline,
    path: &mut MillPath,
) -> Result<(), CycleFault> {
    check_display_digits(call, context)?;
    let Some(levels) = HoleLevels::of_names(call, &PLANES)? else { return Ok(()) };
    let tool = tool_radius(call, context)?;
    let turn = direction(call, context, "_CDIR", MilledSide::Outside)?;
    let [plane, down] = [feed(call, context, "_FFP1")?, feed(call, context, "_FFD")?];
    let is_finishing = match call.integer("_VARI") {
        1 => false,
        2 => true,
        4 | 5 => return Err(unmodelled(call, "_VARI")),
        _ => {
            let text = "_VARI must be 1 (rough) or 2 (finish)";
            return Err(call.fault(KIND_OF_MACHINING, Some("_VARI"), text));
        }
    };
    let allowance = call.magnitude("_FAL");
    let (left, bottom) = match is_finishing {
        true => (0.0, levels.total()),
        false => (allowance, levels.total() - call.magnitude("_FALD")),
    };
    let depths = infeed_depths(call, context, 0.0, bottom, call.magnitude("_MID"))?;
    let (start, mut pieces) = outline.outer_loop(tool + left);
    if turn == TurnDirection::Cw {
        pieces = pieces.into_iter().map(OutlinePiece::mirrored).collect();
    }
    let safety = (levels.start - levels.reference).abs();
    let blank = (call.magnitude("_AP1") / 2.0).max(start[0] - tool);
    let infeed_point = [blank + tool + safety, 0.0];
    let semicircle = |to| OutlinePiece::Arc {
        center: [(start[0] + infeed_point[0]) / 2.0, 0.0],
        // Tangent to the loop from outside: it turns the other direction.
        direction: turn.reversed(),
        to,
    };
    let has_room = infeed_point[0] - start[0] > COINCIDENT;
    path.rapid_over(infeed_point, levels.retract, levels.direction);
    path.rapid_to_level(levels.start);
    for depth in depths {
        path.cut_to_level(levels.at_depth(depth), down);
        if has_room {
            path.cut_pieces(&[semicircle(start)], plane);
        }
        path.cut_pieces(&pieces, plane);
        if has_room {
            path.cut_pieces(&[semicircle(infeed_point)], plane);
        }
    }
    path.rapid_to_level(levels.retract);
    Ok(())
}
