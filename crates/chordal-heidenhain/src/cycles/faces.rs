//! Faces and ruled surfaces: cycles 230 to 232 (TNC 426/430 280 476, 8.7; TNC 640 cycle programming 34059x, 10.2 to
//! 10.4). Levels and ends are those of the control; where its lines lie in the plane is assumed.

use super::levels::{MAX_CUTS, equal_parts, infeed_levels};
use super::step::{CycleContext, CycleFeed, KlartextCycleFault, KlartextCycleStep};
use super::values::CycleValues;

/// The lines of Q240.
fn line_count(values: &CycleValues) -> Result<u32, KlartextCycleFault> {
    let count = values.number(240).round();
    if !(1.0..=MAX_CUTS).contains(&count) {
        let message = format!("Q240 is {count}: it is the number of cuts");
        return Err(KlartextCycleFault::BadValue(message));
    }
    Ok(count as u32)
}

/// The steps of cycle 230: a face in lines to and fro.
///
/// # Errors
/// Why it does not run.
pub fn multipass_steps(
    _: u32,
    values: &CycleValues,
    context: &CycleContext,
) -> Result<Vec<KlartextCycleStep>, KlartextCycleFault> {
    let count = line_count(values)?;
    let tool = context.needed_tool_radius(230)?;
    let [x, y, surface] = [225, 226, 227].map(|number| values.length(number));
    let [long, wide] = [218, 219].map(|number| values.length(number));
    let clearance = surface + values.length(200);
    let ends = [x - tool * long.signum(), x + long];
    let spacing = wide / f64::from(count);
    let at = |end: usize, line: u32| context.offset_to([ends[end], y + f64::from(line) * spacing]);
    let mill = values.feed(207);
    let mut steps = vec![
        KlartextCycleStep::Rapid(context.level.max(clearance)),
        KlartextCycleStep::Across { offset: at(0, 0), feed: CycleFeed::Rapid },
        KlartextCycleStep::Rapid(clearance),
        KlartextCycleStep::Feed { to: surface, feed: values.feed(206) },
    ];
    for line in 0..=count {
        let end = if line % 2 == 0 { 1 } else { 0 };
        if line > 0 {
            let feed = values.feed(209);
            steps.push(KlartextCycleStep::Across { offset: at(1 - end, line), feed });
        }
        steps.push(KlartextCycleStep::Across { offset: at(end, line), feed: mill });
    }
    steps.push(KlartextCycleStep::Rapid(clearance));
    Ok(steps)
}

/// The steps of cycle 231: lines between two edges of a surface of four points, each cut in the same direction.
///
/// # Errors
/// Why it does not run.
pub fn ruled_surface_steps(
    _: u32,
    values: &CycleValues,
    context: &CycleContext,
) -> Result<Vec<KlartextCycleStep>, KlartextCycleFault> {
    let count = line_count(values)?;
    let tool = context.needed_tool_radius(231)?;
    let corner = |first: u32| [first, first + 1, first + 2].map(|number| values.length(number));
    let corners = [225, 228, 231, 234].map(corner);
    let between = |from: [f64; 3], to: [f64; 3], part: f64| {
        [0, 1, 2].map(|axis| from[axis] + (to[axis] - from[axis]) * part)
    };
    let flat = |[x, y, _]: [f64; 3]| context.offset_to([x, y]);
    let ramp =
        |point: [f64; 3], feed| KlartextCycleStep::Ramp { offset: flat(point), to: point[2], feed };
    let highest = corners.iter().map(|point| point[2]).fold(f64::NEG_INFINITY, f64::max);
    let top = highest + 2.0 * tool;
    let mill = values.feed(207);
    // The first step is made at half the feed.
    let mut feed = match mill {
        CycleFeed::Speed(speed) => CycleFeed::Speed(speed / 2.0),
        feed => feed,
    };
    let mut steps = vec![
        KlartextCycleStep::Rapid(context.level.max(top)),
        KlartextCycleStep::Across { offset: flat(corners[0]), feed: CycleFeed::Rapid },
        KlartextCycleStep::Rapid(corners[0][2] + 2.0 * tool),
        KlartextCycleStep::Feed { to: corners[0][2], feed: mill },
    ];
    for line in 0..=count {
        let part = f64::from(line) / f64::from(count);
        let begin = between(corners[0], corners[3], part);
        let end = between(corners[1], corners[2], part);
        if line > 0 {
            steps.push(ramp(begin, mill));
        }
        steps.push(ramp(end, feed));
        feed = mill;
        steps.push(KlartextCycleStep::Rapid(end[2] + 2.0 * tool));
        if line < count {
            let offset = flat(begin);
            steps.push(KlartextCycleStep::Across { offset, feed: CycleFeed::Rapid });
            steps.push(KlartextCycleStep::Rapid(begin[2]));
        }
    }
    steps.push(KlartextCycleStep::Rapid(top));
    Ok(steps)
}

/// The steps of cycle 232: a face in equal infeeds.
///
/// # Errors
/// Why it does not run.
pub fn face_steps(
    _: u32,
    values: &CycleValues,
    context: &CycleContext,
) -> Result<Vec<KlartextCycleStep>, KlartextCycleFault> {
    let tool = context.needed_tool_radius(232)?;
    let [x, y, surface] = [225, 226, 227].map(|number| values.length(number));
    let [long, wide] = [218, 219].map(|number| values.length(number));
    let (bottom, floor) = (values.length(386), values.length(369).max(0.0));
    let height = surface - bottom - floor;
    if surface < bottom {
        let message =
            format!("the end point Q386 is {bottom}: it lies above the face at {surface}");
        return Err(KlartextCycleFault::BadValue(message));
    }
    let infeed = values.length(202).abs();
    let mut cuts: Vec<(f64, bool)> = match height > 0.0 {
        true => {
            let parts = equal_parts(height, infeed)?;
            infeed_levels(surface, bottom + floor, height / f64::from(parts))?
                .into_iter()
                .map(|level| (level, false))
                .collect()
        }
        false => Vec::new(),
    };
    if floor > 0.0 || cuts.is_empty() {
        cuts.push((bottom, true));
    }
    let overlap = if values.number(370) > 0.0 { values.number(370) } else { 1.0 };
    let lines = equal_parts(wide.abs(), overlap * tool)?;
    if f64::from(lines) * cuts.len() as f64 > MAX_CUTS {
        let message = format!("{} levels of {lines} lines are too many", cuts.len());
        return Err(KlartextCycleFault::BadValue(message));
    }
    let side = values.length(357).abs();
    let strategy = values.number(389).round() as i64;
    let before = (tool + side) * long.signum();
    let ends = match strategy {
        // The lines of strategy 1 change inside of the face; the first begins outside.
        1 => [x + tool * long.signum(), x + long - tool * long.signum()],
        _ => [x - before, x + long + before],
    };
    let place = |end: usize, line: u32| {
        let along = f64::from(line) / f64::from(lines) * wide;
        context.offset_to([ends[end], y + along])
    };
    let first = context.offset_to([x - before, y]);
    let clearance = surface + values.length(200);
    let top = clearance.max(surface + values.length(204));
    let rapid = |offset| KlartextCycleStep::Across { offset, feed: CycleFeed::Rapid };
    let mut steps = vec![KlartextCycleStep::Rapid(context.level.max(top)), rapid(first)];
    steps.push(KlartextCycleStep::Rapid(top));
    let finish = values.feed_or(385, values.feed(207));
    let position = values.feed(253);
    let mut order: Vec<u32> = (0..=lines).collect();
    let mut end = 1;
    for (level, is_last) in cuts {
        let feed = if is_last { finish } else { values.feed(207) };
        steps.push(KlartextCycleStep::moved(level, position));
        for (index, line) in order.iter().enumerate() {
            if index > 0 {
                let begin = if strategy == 2 { 0 } else { 1 - end };
                if strategy == 2 {
                    // Back above the face, in the air.
                    steps.push(KlartextCycleStep::moved(level + values.length(200), position));
                }
                steps.push(KlartextCycleStep::Across {
                    offset: place(begin, *line),
                    feed: position,
                });
                if strategy == 2 {
                    steps.push(KlartextCycleStep::moved(level, position));
                }
            }
            steps.push(KlartextCycleStep::Across { offset: place(end, *line), feed });
            if strategy != 2 {
                end = 1 - end;
            }
        }
        // The next level is cut the other direction, from where this one ends.
        match strategy {
            2 => {
                steps.push(KlartextCycleStep::moved(level + values.length(200), position));
                steps.push(KlartextCycleStep::Across { offset: first, feed: position });
            }
            _ => order.reverse(),
        }
    }
    steps.push(KlartextCycleStep::Rapid(top));
    Ok(steps)
}
