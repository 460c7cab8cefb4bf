//! Milling of threads: cycles 262 to 265 inside, 267 outside.
//!
//! Diameter, pitch, hand, depth and end are those of the control; how the tool comes to the wall and leaves it is assumed:
//! by half circles from the centre, or from a pitch outside of a stud. The countersink at the front of the tool (Q358)
//! is a full circle at its depth, Q359 from the centre (TNC 426/430 280 476, 8.3).

use std::f64::consts::{PI, TAU};

use super::step::{CycleContext, CycleFeed, KlartextCycleFault, KlartextCycleStep};
use super::values::{CycleLevels, CycleValues};

/// More turns than this are a mistake in the data.
const MAX_TURNS: f64 = 10_000.0;

/// A helix of a thread.
#[derive(Clone, Copy, Debug)]
struct ThreadHelix {
    /// Where the tool goes down: from the centre along the first axis, mm.
    begin: f64,
    /// The radius of the path of the tool's centre, mm.
    radius: f64,
    /// Where it begins.
    from: f64,
    /// Its turns.
    turns: f64,
    /// The height of a turn, negative downwards, mm.
    height: f64,
    /// 1 counter-clockwise, -1 clockwise.
    sign: f64,
    feed: CycleFeed,
}

/// The steps of cycle 262, 263, 264, 265 or 267.
///
/// # Errors
/// Why it does not run.
pub fn thread_steps(
    number: u32,
    values: &CycleValues,
    context: &CycleContext,
) -> Result<Vec<KlartextCycleStep>, KlartextCycleFault> {
    let Some(depth) = values.downward_depth()? else { return Ok(Vec::new()) };
    let tool = context.needed_tool_radius(number)?;
    let (nominal, pitch) = (values.length(335) / 2.0, values.length(239));
    let is_outside = number == 267;
    let radius = if is_outside { nominal + tool } else { nominal - tool };
    if radius <= 0.0 {
        let message = format!(
            "the tool of {} mm does not fit into the thread of {} mm",
            2.0 * tool,
            2.0 * nominal
        );
        return Err(KlartextCycleFault::ToolTooLarge(message));
    }
    let whole_turns = (depth.abs() / pitch.abs() - 1e-9).ceil().max(1.0);
    if pitch == 0.0 || whole_turns > MAX_TURNS {
        let message = format!("a pitch of {pitch} mm does not make a thread of {depth} mm");
        return Err(KlartextCycleFault::BadValue(message));
    }
    let CycleLevels { clearance, surface, bottom, end } = values.levels(depth);
    let begin = if is_outside { radius + pitch.abs() } else { 0.0 };
    let mut steps = vec![KlartextCycleStep::Rapid(clearance)];
    if is_outside {
        let offset = [begin, 0.0];
        steps.push(KlartextCycleStep::Across { offset, feed: CycleFeed::Rapid });
    }
    match number {
        263 => countersink(values, surface, clearance, &mut steps),
        264 => drill(values, surface, clearance, &mut steps)?,
        _ => {}
    }
    // Cycle 265 may make it after the thread.
    let is_front_last = number == 265 && values.number(360) != 0.0;
    if !is_front_last {
        countersink_front(number, values, surface, begin, &mut steps);
    }
    // F counts at the edge of the tool.
    let feed = match values.feed(207) {
        CycleFeed::Speed(speed) => CycleFeed::Speed(speed * radius / nominal),
        feed => feed,
    };
    // Climb milling goes counter-clockwise inside and clockwise outside; a right-hand thread then goes up, or down.
    // Cycle 265 goes down.
    let is_up_cut = values.number(351) < 0.0;
    let sign = match number {
        265 => -pitch.signum(),
        _ if is_up_cut != is_outside => -1.0,
        _ => 1.0,
    };
    let height = pitch * sign;
    let per_step = if matches!(number, 262 | 267) { values.number(355).round() } else { 1.0 };
    let helix = |turns: f64, end: f64| ThreadHelix {
        begin,
        radius,
        from: if height > 0.0 { end } else { end - turns * height },
        turns,
        height,
        sign,
        feed,
    };
    let position = values.feed(253);
    match per_step {
        0.0 => mill(&helix(1.0, bottom), position, &mut steps),
        1.0 => mill(&helix(whole_turns, bottom), position, &mut steps),
        count => {
            let reach = count.abs() * pitch.abs();
            let parts = (depth.abs() / reach - 1e-9).ceil().max(1.0) as u32;
            for part in 0..parts {
                let end = bottom + f64::from(part) * reach;
                mill(&helix(1.0, end), position, &mut steps);
            }
        }
    }
    if is_front_last {
        countersink_front(number, values, surface, begin, &mut steps);
    }
    steps.push(KlartextCycleStep::Rapid(end));
    Ok(steps)
}

/// From where the tool goes down by a half circle to the wall, along the helix, and back.
fn mill(helix: &ThreadHelix, position: CycleFeed, steps: &mut Vec<KlartextCycleStep>) {
    let ThreadHelix { begin, radius, from, turns, height, sign, feed } = *helix;
    steps.push(KlartextCycleStep::Feed { to: from, feed: position });
    steps.push(half_circle(begin, radius, sign, feed));
    let to = from + turns * height;
    steps.push(KlartextCycleStep::Helix { sweep_rad: sign * turns * TAU, to, feed });
    steps.push(half_circle(radius, begin, sign, feed));
}

/// A half circle between two points of the first axis that is tangent to a circle about the centre through the one that
/// is not where the tool goes down.
fn half_circle(from: f64, to: f64, sign: f64, feed: CycleFeed) -> KlartextCycleStep {
    // From outside it turns the other direction than the circle, from the centre the same.
    let is_outside = from.min(to) > 0.0;
    let sweep_rad = if is_outside { -sign * PI } else { sign * PI };
    KlartextCycleStep::Arc { center: [(from + to) / 2.0, 0.0], end: [to, 0.0], sweep_rad, feed }
}

/// The countersink at the front of the tool: down to Q358, a full circle at Q359 from the centre, and back.
fn countersink_front(
    number: u32,
    values: &CycleValues,
    surface: f64,
    begin: f64,
    steps: &mut Vec<KlartextCycleStep>,
) {
    let depth = values.length(358);
    if depth == 0.0 {
        return;
    }
    // Inside, the tool is moved away from the centre of the hole, outside from that of the stud.
    let offset = values.length(359).abs();
    let to = surface + depth;
    let feed = values.feed(254);
    steps.push(KlartextCycleStep::Feed { to, feed: values.feed(253) });
    if offset == 0.0 {
        return;
    }
    let sign = if number == 267 { -1.0 } else { 1.0 };
    if begin != offset {
        steps.push(half_circle(begin, offset, sign, feed));
    }
    steps.push(KlartextCycleStep::Helix { sweep_rad: sign * TAU, to, feed });
    if begin != offset {
        steps.push(half_circle(offset, begin, sign, feed));
    }
}

/// Cycle 263: the countersink of the tool goes to its depth.
fn countersink(
    values: &CycleValues,
    surface: f64,
    clearance: f64,
    steps: &mut Vec<KlartextCycleStep>,
) {
    let depth = values.length(356);
    if depth == 0.0 {
        return;
    }
    let near = surface + depth + (clearance - surface);
    steps.push(KlartextCycleStep::Feed { to: near.min(clearance), feed: values.feed(253) });
    steps.push(KlartextCycleStep::Feed { to: surface + depth, feed: values.feed(254) });
}

/// Cycle 264: the hole is drilled to Q356 in strokes of Q202.
fn drill(
    values: &CycleValues,
    surface: f64,
    clearance: f64,
    steps: &mut Vec<KlartextCycleStep>,
) -> Result<(), KlartextCycleFault> {
    let depth = values.length(356).abs();
    let stroke = values.length(202).abs();
    let count = if stroke > 0.0 { (depth / stroke - 1e-9).ceil().max(1.0) } else { 1.0 };
    if count > MAX_TURNS {
        let message = format!("strokes of {stroke} mm do not reach the depth of {depth} mm");
        return Err(KlartextCycleFault::BadValue(message));
    }
    for index in 1..=count as u32 {
        let reached = if f64::from(index) < count { f64::from(index) * stroke } else { depth };
        steps.push(KlartextCycleStep::Feed { to: surface - reached, feed: values.feed(206) });
        steps.push(KlartextCycleStep::Rapid(clearance));
        if f64::from(index) < count {
            let near = surface - reached + values.length(258).abs();
            steps.push(KlartextCycleStep::Rapid(near.min(clearance)));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;

    const CONTEXT: CycleContext = CycleContext {
        level: 10.0,
        position: [0.0; 2],
        tool_radius: Some(3.0),
        point_angle: None,
        rpm: 3000.0,
        turns_left: false,
        peck_stop: Some(0.2),
        refuses_positive_depth: true,
    };

    /// The helix of a cycle: its angle, where it begins and ends, and its feed.
    fn helix(numbers: &[(u32, f64)]) -> (f64, f64, f64, CycleFeed) {
        let numbers: BTreeMap<u32, f64> = numbers.iter().copied().collect();
        let values = CycleValues::new(numbers, BTreeMap::new(), 1.0, 1.0 / 60.0);
        let steps = thread_steps(262, &values, &CONTEXT).expect("steps");
        let mut level = 0.0;
        for step in steps {
            match step {
                KlartextCycleStep::Feed { to, .. } | KlartextCycleStep::Rapid(to) => level = to,
                KlartextCycleStep::Helix { sweep_rad, to, feed } => {
                    return (sweep_rad / TAU, level, to, feed);
                }
                _ => {}
            }
        }
        panic!("no helix")
    }

    #[test]
    fn threads_have_their_hand_and_their_length() {
        let data = |climb: f64, pitch: f64| {
            [
                (335, 16.0),
                (239, pitch),
                (201, -20.0),
                (355, 1.0),
                (351, climb),
                (200, 2.0),
                (207, 500.0),
            ]
        };
        // Counter-clockwise and up, or clockwise and down: a right-hand thread; F is that of the edge.
        let check = |found: (f64, f64, f64, CycleFeed), expected: (f64, f64, f64)| {
            assert_eq!((found.0, found.1, found.2), expected);
            let CycleFeed::Speed(speed) = found.3 else { panic!("a feed") };
            assert!((speed - 312.5 / 60.0).abs() < 1e-9);
        };
        check(helix(&data(1.0, 1.5)), (14.0, -20.0, 1.0));
        check(helix(&data(-1.0, 1.5)), (-14.0, 1.0, -20.0));
        check(helix(&data(1.0, -1.5)), (14.0, 1.0, -20.0));
    }
}
