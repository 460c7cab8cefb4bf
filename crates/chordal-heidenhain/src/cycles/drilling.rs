//! Drilling, boring and tapping: cycles 200 to 209 and 240.

use std::f64::consts::TAU;

use super::step::{CycleContext, CycleFeed, KlartextCycleFault, KlartextCycleStep};
use super::values::{CycleLevels, CycleValues, checked_depth};

/// How far above the last depth the rapid back into a hole ends, mm (cycles 203 and 205).
const REENTRY_MM: f64 = 0.2;

/// How far the edge of a boring tool leaves the wall before it is drawn out, mm.
const DISENGAGE_MM: f64 = 0.2;

/// More strokes than this are a mistake in the data.
const MAX_STROKES: usize = 10_000;

/// The steps of a cycle with parameters.
///
/// # Errors
/// Why it does not run.
pub fn parameter_cycle_steps(
    number: u32,
    values: &CycleValues,
    context: &CycleContext,
) -> Result<Vec<KlartextCycleStep>, KlartextCycleFault> {
    let depth = match number {
        204 => -values.length(249).abs(),
        240 => centring_depth(values, context)?,
        _ => values.length(201),
    };
    let Some(depth) = checked_depth(depth, context.refuses_positive_depth)? else {
        return Ok(Vec::new());
    };
    let levels = values.levels(depth);
    let mut steps = vec![KlartextCycleStep::Rapid(levels.clearance)];
    match number {
        200 => drill(values, context, &levels, &mut steps)?,
        203 | 205 => peck(number == 205, values, &levels, &mut steps)?,
        201 | 202 => bore(number == 202, values, &levels, &mut steps),
        204 => back_bore(values, &levels, &mut steps),
        206 => tap(values.feed(206), values, &levels, &mut steps),
        207 => {
            let speed = values.length(239).abs() * context.rpm / 60.0;
            tap(CycleFeed::Speed(speed), values, &levels, &mut steps);
        }
        208 => mill_bore(values, context, &levels, &mut steps)?,
        209 => tap_in_steps(values, context, &levels, &mut steps)?,
        240 => {
            steps.push(KlartextCycleStep::Feed { to: levels.bottom, feed: values.feed(206) });
            dwell(values.number(211), &mut steps);
        }
        _ => {
            let message = format!("cycle {number} is not followed");
            return Err(KlartextCycleFault::NotFollowed(message));
        }
    }
    if levels.end != levels.clearance || !matches!(steps.last(), Some(KlartextCycleStep::Rapid(_)))
    {
        steps.push(KlartextCycleStep::Rapid(levels.end));
    }
    Ok(steps)
}

fn dwell(seconds: f64, steps: &mut Vec<KlartextCycleStep>) {
    if seconds > 0.0 {
        steps.push(KlartextCycleStep::Dwell(seconds));
    }
}

/// Cycle 240 gives its depth, or the diameter that it is to reach at the surface.
fn centring_depth(values: &CycleValues, context: &CycleContext) -> Result<f64, KlartextCycleFault> {
    if values.number(343) == 0.0 {
        return Ok(values.length(201));
    }
    let Some(angle) = context.point_angle else {
        let message = "cycle 240 gives a diameter, and the point angle of the tool is not given";
        return Err(KlartextCycleFault::NotFollowed(message.into()));
    };
    Ok(-values.length(344).abs() / 2.0 / libm::tan(angle / 2.0))
}

/// Cycle 200: strokes of Q202, with a full retraction after each.
fn drill(
    values: &CycleValues,
    context: &CycleContext,
    levels: &CycleLevels,
    steps: &mut Vec<KlartextCycleStep>,
) -> Result<(), KlartextCycleFault> {
    let feed = values.feed(206);
    let stop = context.peck_stop.unwrap_or(levels.clearance - levels.surface);
    let strokes = stroke_levels(levels, values.length(202), 0.0, 0.0)?;
    for (index, level) in strokes.iter().enumerate() {
        steps.push(KlartextCycleStep::Feed { to: *level, feed });
        if index + 1 == strokes.len() {
            break;
        }
        steps.push(KlartextCycleStep::Rapid(levels.clearance));
        dwell(values.number(210), steps);
        steps.push(KlartextCycleStep::Rapid((level + stop).min(levels.clearance)));
    }
    dwell(values.number(211), steps);
    Ok(())
}

/// The levels of the strokes: each is shorter than the one before by a decrement, but not under a least one.
///
/// # Errors
/// For strokes that do not reach the bottom.
pub fn stroke_levels(
    levels: &CycleLevels,
    stroke: f64,
    decrement: f64,
    least: f64,
) -> Result<Vec<f64>, KlartextCycleFault> {
    let sign = (levels.bottom - levels.surface).signum();
    let depth = (levels.bottom - levels.surface).abs();
    let mut stroke = stroke.abs();
    if stroke == 0.0 || stroke >= depth {
        return Ok(vec![levels.bottom]);
    }
    let mut found = Vec::new();
    let mut reached = 0.0;
    while reached < depth - 1e-9 {
        reached = (reached + stroke).min(depth);
        found.push(levels.surface + sign * reached);
        stroke = (stroke - decrement.abs()).max(least.abs().min(stroke));
        if stroke <= 0.0 || found.len() >= MAX_STROKES {
            let message =
                format!("the strokes become {stroke} mm: the depth of {depth} mm is not reached");
            return Err(KlartextCycleFault::BadValue(message));
        }
    }
    Ok(found)
}

/// Cycles 203 and 205: strokes that become shorter, with chip breaking and full retractions.
fn peck(
    is_deep: bool,
    values: &CycleValues,
    levels: &CycleLevels,
    steps: &mut Vec<KlartextCycleStep>,
) -> Result<(), KlartextCycleFault> {
    let feed = values.feed(206);
    // Without a least stroke the first one stays.
    let first = values.length(202);
    let least = if values.has(205) { values.length(205) } else { first };
    let mut begin = *levels;
    if is_deep && values.length(379) != 0.0 {
        begin.surface = levels.surface - values.length(379).abs();
        steps.push(KlartextCycleStep::Feed {
            to: begin.surface + levels.clearance - levels.surface,
            feed: values.feed(253),
        });
    }
    let strokes = stroke_levels(&begin, first, values.length(212), least)?;
    let breaks = values.number(213).max(0.0) as u32;
    let back = values.length(256).abs();
    let mut done = 0;
    let mut last = begin.surface;
    for (index, level) in strokes.iter().enumerate() {
        match is_deep {
            true => break_chips(values, last, *level, back, steps),
            false => steps.push(KlartextCycleStep::Feed { to: *level, feed }),
        }
        last = *level;
        if index + 1 == strokes.len() {
            break;
        }
        if done < breaks && !is_deep {
            done += 1;
            let to = level + back;
            steps.push(KlartextCycleStep::Feed { to, feed: values.retraction() });
            continue;
        }
        done = 0;
        let feed = if is_deep { CycleFeed::Rapid } else { values.retraction() };
        steps.push(KlartextCycleStep::moved(levels.clearance, feed));
        dwell(values.number(210), steps);
        let part = (begin.surface - level) / (begin.surface - levels.bottom);
        let distance = match is_deep {
            // From the upper to the lower distance as the hole becomes deeper.
            true => {
                let [upper, lower] = [258, 259].map(|number| values.length(number));
                upper + (lower - upper) * part
            }
            false => REENTRY_MM,
        };
        steps.push(KlartextCycleStep::Rapid((level + distance).min(levels.clearance)));
    }
    dwell(values.number(211), steps);
    if !is_deep {
        steps.push(KlartextCycleStep::moved(levels.clearance, values.retraction()));
    }
    Ok(())
}

/// The chips of a stroke of cycle 205 are broken every Q257.
fn break_chips(
    values: &CycleValues,
    from: f64,
    to: f64,
    back: f64,
    steps: &mut Vec<KlartextCycleStep>,
) {
    let feed = values.feed(206);
    let step = values.length(257).abs();
    let mut level = from;
    let mut count = 0;
    while step > 0.0 && level - step > to + 1e-9 && count < MAX_STROKES {
        level -= step;
        count += 1;
        steps.push(KlartextCycleStep::Feed { to: level, feed });
        steps.push(KlartextCycleStep::Rapid(level + back));
    }
    steps.push(KlartextCycleStep::Feed { to, feed });
}

/// The direction of Q214: along the first axis or the second, against it or with it.
fn disengaging(values: &CycleValues, distance: f64) -> Option<[f64; 2]> {
    match values.number(214).round() as i64 {
        1 => Some([-distance, 0.0]),
        2 => Some([0.0, -distance]),
        3 => Some([distance, 0.0]),
        4 => Some([0.0, distance]),
        _ => None,
    }
}

/// Cycles 201 and 202: to the bottom and out again at a feed; a boring tool first leaves the wall.
fn bore(
    leaves_wall: bool,
    values: &CycleValues,
    levels: &CycleLevels,
    steps: &mut Vec<KlartextCycleStep>,
) {
    steps.push(KlartextCycleStep::Feed { to: levels.bottom, feed: values.feed(206) });
    dwell(values.number(211), steps);
    let away = disengaging(values, DISENGAGE_MM).filter(|_| leaves_wall);
    if leaves_wall {
        steps.push(KlartextCycleStep::Orient);
    }
    if let Some(offset) = away {
        steps.push(KlartextCycleStep::Across { offset, feed: CycleFeed::Rapid });
    }
    steps.push(KlartextCycleStep::moved(levels.clearance, values.retraction()));
    if away.is_some() {
        steps.push(KlartextCycleStep::Across { offset: [0.0; 2], feed: CycleFeed::Rapid });
    }
    if leaves_wall {
        steps.push(KlartextCycleStep::SpindleOn);
    }
}

/// Cycle 204: off centre through the hole, and upwards into the part from below.
fn back_bore(values: &CycleValues, levels: &CycleLevels, steps: &mut Vec<KlartextCycleStep>) {
    let clearance = levels.clearance - levels.surface;
    let below = levels.surface - values.length(250) - values.length(252);
    let under = below - clearance;
    let position = values.feed(253);
    let offset = disengaging(values, values.length(251)).unwrap_or([0.0; 2]);
    steps.push(KlartextCycleStep::Orient);
    steps.push(KlartextCycleStep::Across { offset, feed: CycleFeed::Rapid });
    steps.push(KlartextCycleStep::Feed { to: under, feed: position });
    steps.push(KlartextCycleStep::Across { offset: [0.0; 2], feed: CycleFeed::Rapid });
    steps.push(KlartextCycleStep::SpindleOn);
    let to = below + values.length(249).abs();
    steps.push(KlartextCycleStep::Feed { to, feed: values.feed(254) });
    dwell(values.number(255), steps);
    steps.push(KlartextCycleStep::Feed { to: under, feed: position });
    steps.push(KlartextCycleStep::Orient);
    steps.push(KlartextCycleStep::Across { offset, feed: CycleFeed::Rapid });
    steps.push(KlartextCycleStep::Feed { to: levels.clearance, feed: position });
    steps.push(KlartextCycleStep::Across { offset: [0.0; 2], feed: CycleFeed::Rapid });
    steps.push(KlartextCycleStep::SpindleOn);
}

/// Cycles 206 and 207: in, reverse, out, reverse.
fn tap(
    feed: CycleFeed,
    values: &CycleValues,
    levels: &CycleLevels,
    steps: &mut Vec<KlartextCycleStep>,
) {
    steps.push(KlartextCycleStep::Feed { to: levels.bottom, feed });
    dwell(values.number(211), steps);
    steps.push(KlartextCycleStep::Reverse);
    steps.push(KlartextCycleStep::Feed { to: levels.clearance, feed });
    steps.push(KlartextCycleStep::SpindleOn);
}

/// Cycle 209: the thread in steps of Q257; after each the tool goes back by Q256 pitches, or out.
fn tap_in_steps(
    values: &CycleValues,
    context: &CycleContext,
    levels: &CycleLevels,
    steps: &mut Vec<KlartextCycleStep>,
) -> Result<(), KlartextCycleFault> {
    let pitch = values.length(239).abs();
    let factor = if values.number(403) > 0.0 { values.number(403) } else { 1.0 };
    let feed = CycleFeed::Speed(pitch * context.rpm / 60.0);
    let back = CycleFeed::Speed(pitch * context.rpm * factor / 60.0);
    let stops = stroke_levels(levels, values.length(257), 0.0, values.length(257))?;
    for (index, level) in stops.iter().enumerate() {
        steps.push(KlartextCycleStep::Feed { to: *level, feed });
        if index + 1 == stops.len() {
            break;
        }
        let to = match values.number(256) {
            0.0 => levels.clearance,
            pitches => (level + pitches.abs() * pitch).min(levels.clearance),
        };
        steps.push(KlartextCycleStep::Reverse);
        steps.push(KlartextCycleStep::Feed { to, feed: back });
        steps.push(KlartextCycleStep::SpindleOn);
    }
    steps.push(KlartextCycleStep::Reverse);
    steps.push(KlartextCycleStep::Feed { to: levels.clearance, feed: back });
    steps.push(KlartextCycleStep::SpindleOn);
    Ok(())
}

/// Cycle 208: a helix to the bottom, a full circle there, and back to the centre.
fn mill_bore(
    values: &CycleValues,
    context: &CycleContext,
    levels: &CycleLevels,
    steps: &mut Vec<KlartextCycleStep>,
) -> Result<(), KlartextCycleFault> {
    let tool = context.needed_tool_radius(208)?;
    let radius = values.length(335) / 2.0 - tool;
    if radius < 0.0 {
        let message = format!(
            "the tool of {} mm does not fit into the bore of {} mm",
            2.0 * tool,
            values.length(335)
        );
        return Err(KlartextCycleFault::ToolTooLarge(message));
    }
    let feed = values.feed(206);
    if radius == 0.0 {
        steps.push(KlartextCycleStep::Feed { to: levels.bottom, feed });
        return Ok(());
    }
    let pitch = values.length(334).abs();
    let height = levels.clearance - levels.bottom;
    let turns = if pitch > 0.0 { height / pitch } else { 1.0 };
    if turns > MAX_STROKES as f64 {
        let message = format!("a pitch of {pitch} mm makes {turns} turns");
        return Err(KlartextCycleFault::BadValue(message));
    }
    steps.push(KlartextCycleStep::Across { offset: [radius, 0.0], feed });
    let turn = if context.turns_clockwise_inside(values.number(351)) { -TAU } else { TAU };
    steps.push(KlartextCycleStep::Helix { sweep_rad: turns * turn, to: levels.bottom, feed });
    steps.push(KlartextCycleStep::Helix { sweep_rad: turn, to: levels.bottom, feed });
    steps.push(KlartextCycleStep::Across { offset: [0.0; 2], feed });
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
        rpm: 500.0,
        turns_left: false,
        peck_stop: Some(0.2),
        refuses_positive_depth: true,
    };

    fn values(numbers: &[(u32, f64)]) -> CycleValues {
        let numbers: BTreeMap<u32, f64> = numbers.iter().copied().collect();
        CycleValues::new(numbers, BTreeMap::new(), 1.0, 1.0 / 60.0)
    }

    /// The steps in the words of the manual: r for rapid, f for feed, with the level.
    fn shown(number: u32, numbers: &[(u32, f64)], context: &CycleContext) -> String {
        let steps = parameter_cycle_steps(number, &values(numbers), context).expect("steps");
        let level = |value: f64| format!("{}", (value * 1e6).round() / 1e6);
        let words: Vec<String> = steps
            .iter()
            .filter_map(|step| match step {
                KlartextCycleStep::Rapid(to) => Some(format!("r{}", level(*to))),
                KlartextCycleStep::Feed { to, .. } => Some(format!("f{}", level(*to))),
                _ => None,
            })
            .collect();
        words.join(" ")
    }

    #[test]
    fn drilling_retracts_after_each_stroke() {
        let data = [(200, 2.0), (201, -15.0), (202, 6.0), (204, 50.0), (206, 100.0)];
        assert_eq!(shown(200, &data, &CONTEXT), "r2 f-6 r2 r-5.8 f-12 r2 r-11.8 f-15 r50");
        let old = CycleContext { peck_stop: None, ..CONTEXT };
        assert_eq!(shown(200, &data, &old), "r2 f-6 r2 r-4 f-12 r2 r-10 f-15 r50");
        let data = [(200, 2.0), (201, -54.887), (202, 54.887), (203, 50.0), (204, 2.0)];
        assert_eq!(shown(200, &data, &CONTEXT), "r52 f-4.887 r52");
    }

    #[test]
    fn universal_drilling_breaks_chips_and_retracts() {
        let data =
            |breaks| [(200, 2.0), (201, -20.0), (202, 5.0), (213, breaks), (256, 0.2), (204, 50.0)];
        let all = "r2 f-5 f-4.8 f-10 f-9.8 f-15 f-14.8 f-20 f2 r50";
        assert_eq!(shown(203, &data(3.0), &CONTEXT), all);
        let one = "r2 f-5 f-4.8 f-10 f2 r-9.8 f-15 f-14.8 f-20 f2 r50";
        assert_eq!(shown(203, &data(1.0), &CONTEXT), one);
    }

    #[test]
    fn strokes_become_shorter_down_to_the_least_one() {
        let levels = CycleLevels { clearance: 2.0, surface: 0.0, bottom: -30.0, end: 2.0 };
        let found = stroke_levels(&levels, 10.0, 2.0, 4.0).expect("levels");
        assert_eq!(found, [-10.0, -18.0, -24.0, -28.0, -30.0]);
        assert!(stroke_levels(&levels, 10.0, 5.0, 0.0).is_err());
    }

    #[test]
    fn rigid_taps_follow_pitch_and_speed() {
        let data = [(200, 3.0), (201, -20.0), (239, -1.5), (204, 3.0)];
        let steps = parameter_cycle_steps(207, &values(&data), &CONTEXT).expect("steps");
        let feed = CycleFeed::Speed(750.0 / 60.0);
        assert!(steps.contains(&KlartextCycleStep::Feed { to: -20.0, feed }));
    }

    #[test]
    fn bore_mills_go_down_in_a_helix() {
        let data = [(200, 2.0), (201, -10.0), (334, 2.0), (335, 20.0)];
        let steps = parameter_cycle_steps(208, &values(&data), &CONTEXT).expect("steps");
        let helix = steps.iter().find_map(|step| match step {
            KlartextCycleStep::Helix { sweep_rad, to, .. } => Some((*sweep_rad, *to)),
            _ => None,
        });
        assert_eq!(helix, Some((6.0 * TAU, -10.0)));
        let small = [(200, 2.0), (201, -10.0), (334, 2.0), (335, 5.0)];
        let fault = parameter_cycle_steps(208, &values(&small), &CONTEXT);
        assert!(matches!(fault, Err(KlartextCycleFault::ToolTooLarge(_))));
    }

    #[test]
    fn depths_have_a_sign() {
        let up = [(200, 2.0), (201, 10.0), (202, 5.0)];
        let fault = parameter_cycle_steps(200, &values(&up), &CONTEXT);
        assert!(matches!(fault, Err(KlartextCycleFault::BadValue(_))));
        let none = [(200, 2.0), (201, 0.0), (202, 5.0)];
        assert_eq!(parameter_cycle_steps(200, &values(&none), &CONTEXT), Ok(Vec::new()));
    }
}
