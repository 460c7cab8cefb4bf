//! CYCLE61 and CYCLE71: face milling in rows (PGZ, 3.10; NC Programming 12/2019).

use super::MillingContext;
use super::call_values::{
    KIND_OF_MACHINING, NO_SIZE, check_display_digits, equal_parts, feed, infeed_depths, planes,
    stepover, tool_radius,
};
use super::mill_path::{MillPath, ShapeFrame};
use crate::alarms::NO_ALARM;
use crate::cycles::arguments::{CycleCall, CycleFault};
use crate::cycles::levels::{HoleLevels, unmodelled};

/// The safety distance in the plane is 0 or negative.
const PLANE_CLEARANCE: u32 = 61_122;

/// A rectangle to be faced: from a corner along two axes.
struct FaceArea {
    frame: ShapeFrame,
    /// Length and width; their signs are directions from the corner.
    size: [f64; 2],
    /// How far the edge of the tool stays off the area before and after a row.
    clearance: f64,
    /// How far the edge of the tool goes beyond the area in the last row.
    overrun: f64,
}

/// CYCLE71: from a corner, with a length, a width and an angle.
pub(super) fn rectangle(
    call: &CycleCall<'_>,
    context: &MillingContext,
    path: &mut MillPath,
) -> Result<(), CycleFault> {
    let Some(levels) = planes(call, ["_RTP", "_RFP", "_SDIS", "_DP"])? else { return Ok(()) };
    let clearance = call.number("_FDP");
    if clearance <= 0.0 {
        let text = "_FDP must be more than 0";
        return Err(call.fault(PLANE_CLEARANCE, Some("_FDP"), text));
    }
    let corner = ["_PA", "_PO"].map(|name| call.number(name));
    let area = FaceArea {
        frame: ShapeFrame::new(corner, call.number("_STA")),
        size: ["_LENG", "_WID"].map(|name| call.number(name)),
        clearance,
        overrun: call.magnitude("_FDP1"),
    };
    area.mill(call, context, &levels, path)
}

/// CYCLE61: between two corners. The tool stays off the area by the safety distance.
///
/// # Errors
/// [`NO_ALARM`] when the first corner is not the zero of the program: two digits of `_AMODE` say whether the second corner is
/// absolute, and no source at hand says by which value. Known calls begin at 0, where both agree.
pub(super) fn between_corners(
    call: &CycleCall<'_>,
    context: &MillingContext,
    path: &mut MillPath,
) -> Result<(), CycleFault> {
    check_display_digits(call, context)?;
    let Some(levels) = planes(call, ["_RTP", "_Z0", "_SDIS", "_Z1"])? else { return Ok(()) };
    if call.integer("_LIM") != 0 {
        return Err(unmodelled(call, "_LIM"));
    }
    let corner = ["_X0", "_Y0"].map(|name| call.number(name));
    if corner != [0.0; 2] {
        let text = "CYCLE61 with a corner that is not X0 Y0 is not modelled: whether the other corner is absolute is not known";
        return Err(call.fault(NO_ALARM, Some("_X0"), text));
    }
    let area = FaceArea {
        frame: ShapeFrame::new(corner, 0.0),
        size: ["_X1", "_Y1"].map(|name| call.number(name)),
        clearance: call.magnitude("_SDIS"),
        overrun: 0.0,
    };
    area.mill(call, context, &levels, path)
}

/// The rows of a face: which axis they follow, and whether they go to and fro.
#[derive(Clone, Copy)]
struct RowOrder {
    /// 0 along the length, 1 along the width.
    axis: usize,
    zigzag: bool,
}

impl RowOrder {
    /// By the tens of `_VARI`: 1 and 2 in one direction along the first and the second axis, 3 and 4 to and fro.
    fn of_call(call: &CycleCall<'_>) -> Result<RowOrder, CycleFault> {
        let (axis, zigzag) = match call.integer("_VARI") / 10 {
            1 => (0, false),
            2 => (1, false),
            3 => (0, true),
            4 => (1, true),
            _ => {
                let text = "the tens of _VARI must be 1 to 4";
                return Err(call.fault(KIND_OF_MACHINING, Some("_VARI"), text));
            }
        };
        Ok(RowOrder { axis, zigzag })
    }
}

impl FaceArea {
    /// Faces the area: in equal infeeds down to the allowance, or once at the depth (finishing).
    fn mill(
        &self,
        call: &CycleCall<'_>,
        context: &MillingContext,
        levels: &HoleLevels,
        path: &mut MillPath,
    ) -> Result<(), CycleFault> {
        if self.size.contains(&0.0) {
            let text = "the length and the width of the area must not be 0";
            return Err(call.fault(NO_SIZE, None, text));
        }
        let tool = tool_radius(call, context)?;
        let order = RowOrder::of_call(call)?;
        let largest = stepover(call, tool, call.integer("_AMODE") / 10 % 10 == 1)?;
        let feed = feed(call, context, "_FFP1")?;
        let width = self.size[1 - order.axis].abs() + self.overrun;
        let rows = equal_parts(call, context, width, largest)?;
        let depths = match call.integer("_VARI") % 10 {
            1 => {
                let bottom = levels.total() - call.magnitude("_FALD");
                infeed_depths(call, context, 0.0, bottom, call.magnitude("_MID"))?
            }
            2 => vec![levels.total()],
            _ => {
                let text = "the ones of _VARI must be 1 (rough) or 2 (finish)";
                return Err(call.fault(KIND_OF_MACHINING, Some("_VARI"), text));
            }
        };
        if depths.len().saturating_mul(rows as usize) > context.max_repetitions as usize {
            let text = format!("{} would take too many rows: check the steps", call.name());
            return Err(call.fault(NO_ALARM, None, &text));
        }
        path.set_frame(self.frame);
        // The edge of the tool enters the area by a stepover in each row, so that its far edge is reached in the last one.
        let row = |index: u32| width * f64::from(index) / f64::from(rows) - tool;
        let reach = tool + self.clearance;
        let far = self.size[order.axis].abs() + reach;
        let point = |along: f64, across: f64| self.point(order.axis, along, across);
        path.rapid_over(point(-reach, row(1)), levels.retract, levels.direction);
        for depth in depths {
            let level = levels.at_depth(depth);
            path.rapid_to_level(levels.start);
            path.rapid_to(point(-reach, row(1)));
            path.rapid_to_level(level);
            let mut is_back = false;
            for index in 1..=rows {
                let ends = if is_back { [far, -reach] } else { [-reach, far] };
                path.cut_to(point(ends[0], row(index)), feed);
                path.cut_to(point(ends[1], row(index)), feed);
                if order.zigzag {
                    is_back = !is_back;
                } else if index < rows {
                    path.rapid_to_level(levels.start);
                    path.rapid_to(point(-reach, row(index + 1)));
                    path.rapid_to_level(level);
                }
            }
        }
        path.rapid_to_level(levels.retract);
        Ok(())
    }

    /// A point of the area: along the rows and across them from the corner.
    fn point(&self, axis: usize, along: f64, across: f64) -> [f64; 2] {
        let place = if axis == 0 { [along, across] } else { [across, along] };
        [0, 1].map(|index| place[index] * self.size[index].signum())
    }
}
