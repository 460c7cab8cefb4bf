//! Slots of older controls: cycles 3, 210 and 211 (TNC 426/430 280 476, 8.4). Shape, levels and ends are those of the
//! control; how the tool comes to the wall for finishing is assumed.

use super::levels::infeed_levels;
use super::old_cycles::OldCycle;
use super::outline::{KlartextPocketOutline, follow, turned};
use super::step::{CycleContext, CycleFeed, KlartextCycleFault, KlartextCycleStep};
use super::values::{CycleLevels, CycleValues};

/// The half width that is left for the centre of the tool.
///
/// # Errors
/// For a tool that is wider than the slot, or not a third of it.
fn half_width(width: f64, tool: f64) -> Result<f64, KlartextCycleFault> {
    let half = width / 2.0 - tool;
    if half < -1e-9 {
        let message = format!("the tool of {} mm does not fit into {width} mm", 2.0 * tool);
        return Err(KlartextCycleFault::ToolTooLarge(message));
    }
    if width > 6.0 * tool * (1.0 + 1e-9) {
        let message =
            format!("the tool of {} mm is less than a third of the slot of {width} mm", 2.0 * tool);
        return Err(KlartextCycleFault::BadValue(message));
    }
    Ok(half.max(0.0))
}

/// The steps of cycle 210 or 211: down on oblique lines from one end of the slot to the other, then along its wall.
///
/// # Errors
/// Why it does not run.
pub fn reciprocating_slot_steps(
    number: u32,
    values: &CycleValues,
    context: &CycleContext,
) -> Result<Vec<KlartextCycleStep>, KlartextCycleFault> {
    let Some(depth) = values.downward_depth()? else { return Ok(Vec::new()) };
    let tool = context.needed_tool_radius(number)?;
    let width = values.length(219);
    let half = half_width(width, tool)?;
    let CycleLevels { clearance, surface, bottom, end: top } = values.levels(depth);
    let center = context.offset_to([216, 217].map(|number| values.length(number)));
    let slot = SlotLine::new(number, values, center, half)?;
    let mill = values.feed(207);
    let kind = values.number(215).round() as i64;
    let rapid = |offset| KlartextCycleStep::Across { offset, feed: CycleFeed::Rapid };
    let mut steps = vec![
        KlartextCycleStep::Rapid(top),
        rapid(slot.end(0)),
        KlartextCycleStep::Rapid(clearance),
    ];
    let mut at = 0;
    if kind != 2 {
        steps.push(KlartextCycleStep::Feed { to: surface, feed: mill });
        for level in infeed_levels(surface, bottom, values.length(202))? {
            at = 1 - at;
            steps.push(slot.along(at, level, mill));
        }
        // Once more from end to end, so that the floor is level.
        at = 1 - at;
        steps.push(slot.along(at, bottom, mill));
    }
    if kind != 1 && half > 0.0 {
        let finish = values.feed_or(206, mill);
        // The wall begins at the first end, which is reached in the slot.
        if at == 1 {
            steps.push(slot.along(0, bottom, mill));
        }
        let mut reached = if kind == 2 { clearance } else { bottom };
        for level in infeed_levels(surface, bottom, values.length(338))? {
            if level != reached {
                steps.push(KlartextCycleStep::Feed { to: level, feed: finish });
            }
            reached = level;
            follow(&slot.wall, center, mill, &mut steps);
        }
    }
    steps.push(KlartextCycleStep::Rapid(clearance));
    steps.push(KlartextCycleStep::Rapid(top));
    Ok(steps)
}

/// The middle line of a slot and its wall.
#[derive(Clone, Copy, Debug)]
struct SlotLine {
    ends: [[f64; 2]; 2],
    /// The centre and the angle of an arc slot, rad.
    arc: Option<([f64; 2], f64)>,
    wall: KlartextPocketOutline,
}

impl SlotLine {
    fn new(
        number: u32,
        values: &CycleValues,
        center: [f64; 2],
        half: f64,
    ) -> Result<SlotLine, KlartextCycleFault> {
        let at = |local: [f64; 2], degrees: f64| {
            let [x, y] = turned(local, degrees);
            [center[0] + x, center[1] + y]
        };
        if number == 211 {
            let radius = values.length(244) / 2.0;
            let (from, length) = (values.number(245), values.number(248));
            if half > radius || length.abs() > 360.0 {
                let message = format!(
                    "a slot of {length} degrees on a circle of {} mm is not possible",
                    2.0 * radius
                );
                return Err(KlartextCycleFault::BadValue(message));
            }
            return Ok(SlotLine {
                ends: [at([radius, 0.0], from), at([radius, 0.0], from + length)],
                arc: Some((center, length.to_radians())),
                wall: KlartextPocketOutline::ArcSlot(radius, half, from, length),
            });
        }
        let (long, width) = (values.length(218).abs(), values.length(219));
        if long < width {
            let message = format!("the slot is {long} mm long and {width} mm wide");
            return Err(KlartextCycleFault::BadValue(message));
        }
        let (reach, degrees) = ((long - width) / 2.0, values.number(224));
        Ok(SlotLine {
            ends: [at([-reach, 0.0], degrees), at([reach, 0.0], degrees)],
            arc: None,
            wall: KlartextPocketOutline::Rectangle([reach + half, half], half, degrees),
        })
    }

    fn end(&self, index: usize) -> [f64; 2] {
        self.ends[index]
    }

    /// From one end to the other, down to a level.
    fn along(&self, to_end: usize, to: f64, feed: CycleFeed) -> KlartextCycleStep {
        let offset = self.end(to_end);
        match self.arc {
            Some((center, sweep_rad)) => {
                let sweep_rad = if to_end == 1 { sweep_rad } else { -sweep_rad };
                KlartextCycleStep::ArcRamp { center, end: offset, sweep_rad, to, feed }
            }
            None => KlartextCycleStep::Ramp { offset, to, feed },
        }
    }
}

/// The steps of cycle 3, which begins in the slot, a radius of the tool from its end, at the level where the tool is.
///
/// # Errors
/// Why it does not run.
pub fn old_slot_steps(
    cycle: &OldCycle,
    context: &CycleContext,
) -> Result<Vec<KlartextCycleStep>, KlartextCycleFault> {
    cycle.check_complete()?;
    let value = |line: u32, index: usize| cycle.nth_value(line, index);
    let tool = context.needed_tool_radius(cycle.number)?;
    let surface = context.level - value(1, 0).abs();
    let bottom = surface - value(2, 0).abs();
    let half = half_width(value(5, 0).abs(), tool)?;
    let reach = value(4, 0).abs() - 2.0 * tool;
    if reach < 0.0 {
        let message = format!("the slot of {} mm is shorter than the tool", value(4, 0).abs());
        return Err(KlartextCycleFault::ToolTooLarge(message));
    }
    // The sign of the length is the direction from the start; the axis may be either of the plane.
    let degrees = match (cycle.data.second_axis_first, value(4, 0) < 0.0) {
        (false, false) => 0.0,
        (false, true) => 180.0,
        (true, false) => 90.0,
        (true, true) => 270.0,
    };
    let speed = |value: f64| (value > 0.0).then_some(CycleFeed::Speed(value));
    let mill = speed(value(6, 0)).unwrap_or(CycleFeed::Active);
    let plunge = speed(value(3, 1)).unwrap_or(mill);
    let ends = [[0.0; 2], turned([reach, 0.0], degrees)];
    let mut steps = Vec::new();
    let mut at = 0;
    for to in infeed_levels(surface, bottom, value(3, 0))? {
        at = 1 - at;
        steps.push(KlartextCycleStep::Feed { to, feed: plunge });
        steps.push(KlartextCycleStep::Across { offset: ends[at], feed: mill });
    }
    if half > 0.0 {
        let middle = turned([reach / 2.0, 0.0], degrees);
        let wall =
            KlartextPocketOutline::Rectangle([reach / 2.0, half], half.min(reach / 2.0), degrees);
        follow(&wall, middle, mill, &mut steps);
    }
    steps.push(KlartextCycleStep::Rapid(context.level));
    steps.push(KlartextCycleStep::Across { offset: ends[0], feed: CycleFeed::Rapid });
    Ok(steps)
}
