//! The cycles whose data stand on numbered lines: pecking, tapping, rigid tapping.

use std::collections::BTreeMap;

use super::step::{CycleContext, CycleFeed, KlartextCycleFault, KlartextCycleStep};

/// The values of an old cycle by the line of its data, in their order; lengths in mm, feeds in mm/s. The words before
/// them are in the language of the shop.
#[derive(Clone, Default, PartialEq, Debug)]
pub struct OldCycleData {
    /// The values.
    pub lines: BTreeMap<u32, Vec<f64>>,
    /// The first side (line 4) lies along the second axis of the plane.
    pub second_axis_first: bool,
    /// DR-: the rings of a pocket are cut clockwise.
    pub is_clockwise: bool,
}

/// An old cycle.
#[derive(Clone, PartialEq, Debug)]
pub struct OldCycle {
    /// Its number.
    pub number: u32,
    /// Its data.
    pub data: OldCycleData,
}

/// More strokes than this are a mistake in the data.
const MAX_OLD_STROKES: usize = 10_000;

/// How many lines of data an old cycle has; `None` for one that is not carried out.
pub fn old_cycle_lines(number: u32) -> Option<u32> {
    match number {
        1 => Some(5),
        2 => Some(4),
        17 | 18 => Some(3),
        3 | 4 => Some(6),
        5 => Some(5),
        _ => None,
    }
}

impl OldCycle {
    fn value(&self, line: u32) -> f64 {
        self.nth_value(line, 0)
    }

    /// A value of a line by its index; 0 without it.
    pub fn nth_value(&self, line: u32, index: usize) -> f64 {
        let values = self.data.lines.get(&line);
        values.and_then(|values| values.get(index)).copied().unwrap_or(0.0)
    }

    /// The lines that have no value.
    pub fn missing_lines(&self) -> Vec<u32> {
        let count = old_cycle_lines(self.number).unwrap_or(0);
        let has_value = |line: &u32| self.data.lines.get(line).is_some_and(|own| !own.is_empty());
        (1..=count).filter(|line| !has_value(line)).collect()
    }

    /// Every line must have a value.
    ///
    /// # Errors
    /// The first line without one.
    pub fn check_complete(&self) -> Result<(), KlartextCycleFault> {
        let Some(line) = self.missing_lines().first().copied() else { return Ok(()) };
        let message = format!("line {}.{line} of the cycle is missing", self.number);
        Err(KlartextCycleFault::Incomplete(message))
    }
}

/// The steps of an old cycle, which begins at the level where the tool is.
///
/// # Errors
/// Why it does not run.
pub fn old_cycle_steps(
    cycle: &OldCycle,
    context: &CycleContext,
) -> Result<Vec<KlartextCycleStep>, KlartextCycleFault> {
    cycle.check_complete()?;
    let (clearance, depth) = (cycle.value(1), cycle.value(2));
    if depth == 0.0 {
        return Ok(Vec::new());
    }
    if depth > 0.0 && context.refuses_positive_depth {
        let message = format!("the depth is {depth}: it is negative downwards");
        return Err(KlartextCycleFault::BadValue(message));
    }
    let start = context.level;
    let surface = start - clearance.abs();
    let bottom = surface + depth;
    match cycle.number {
        1 => peck(cycle, start, surface, bottom),
        2 => Ok(tap(CycleFeed::Speed(cycle.value(4)), cycle.value(3), start, bottom)),
        17 | 18 => {
            let speed = cycle.value(3).abs() * context.rpm / 60.0;
            Ok(tap(CycleFeed::Speed(speed), 0.0, start, bottom))
        }
        number => {
            let message = format!("cycle {number} is not followed");
            Err(KlartextCycleFault::NotFollowed(message))
        }
    }
}

/// How far above the last depth the rapid back into the hole ends: 0.6 mm down to a depth of 30 mm, then a fiftieth of
/// the depth, 7 mm at most.
fn stop_distance(depth: f64) -> f64 {
    if depth.abs() <= 30.0 { 0.6 } else { (depth.abs() / 50.0).min(7.0) }
}

/// Cycle 1.
fn peck(
    cycle: &OldCycle,
    start: f64,
    surface: f64,
    bottom: f64,
) -> Result<Vec<KlartextCycleStep>, KlartextCycleFault> {
    let feed = CycleFeed::Speed(cycle.value(5));
    let stroke = cycle.value(3).abs();
    let stop = stop_distance(bottom - surface);
    let mut steps = Vec::new();
    let mut level = surface;
    while level > bottom {
        let is_whole = stroke == 0.0;
        level = if is_whole { bottom } else { (level - stroke).max(bottom) };
        steps.push(KlartextCycleStep::Feed { to: level, feed });
        if steps.len() > MAX_OLD_STROKES {
            let message = format!("strokes of {stroke} mm do not reach the depth");
            return Err(KlartextCycleFault::BadValue(message));
        }
        if level <= bottom {
            break;
        }
        steps.push(KlartextCycleStep::Rapid(start));
        steps.push(KlartextCycleStep::Rapid((level + stop).min(start)));
    }
    if cycle.value(4) > 0.0 {
        steps.push(KlartextCycleStep::Dwell(cycle.value(4)));
    }
    steps.push(KlartextCycleStep::Rapid(start));
    Ok(steps)
}

/// Cycles 2 and 17.
fn tap(feed: CycleFeed, dwell: f64, start: f64, bottom: f64) -> Vec<KlartextCycleStep> {
    let mut steps = vec![KlartextCycleStep::Feed { to: bottom, feed }];
    if dwell > 0.0 {
        steps.push(KlartextCycleStep::Dwell(dwell));
    }
    steps.push(KlartextCycleStep::Reverse);
    steps.push(KlartextCycleStep::Feed { to: start, feed });
    steps.push(KlartextCycleStep::SpindleOn);
    steps
}

#[cfg(test)]
mod tests {
    use super::*;

    const CONTEXT: CycleContext = CycleContext {
        level: 2.0,
        position: [0.0; 2],
        tool_radius: None,
        point_angle: None,
        rpm: 1000.0,
        turns_left: false,
        peck_stop: Some(0.2),
        refuses_positive_depth: true,
    };

    fn cycle(number: u32, values: &[f64]) -> OldCycle {
        let lines = values.iter().enumerate().map(|(line, value)| (line as u32 + 1, vec![*value]));
        OldCycle {
            number,
            data: OldCycleData { lines: lines.collect(), ..OldCycleData::default() },
        }
    }

    #[test]
    fn pecking_begins_where_the_tool_is() {
        let steps = old_cycle_steps(&cycle(1, &[-2.0, -14.0, -6.0, 0.0, 2.0]), &CONTEXT);
        let steps = steps.expect("steps");
        let feed = CycleFeed::Speed(2.0);
        let down = |to| KlartextCycleStep::Feed { to, feed };
        let up = KlartextCycleStep::Rapid;
        assert_eq!(
            steps,
            [down(-6.0), up(2.0), up(-5.4), down(-12.0), up(2.0), up(-11.4), down(-14.0), up(2.0)]
        );
    }

    #[test]
    fn data_that_are_missing_are_named() {
        let short = cycle(1, &[-2.0]);
        assert_eq!(short.missing_lines(), [2, 3, 4, 5]);
        assert!(matches!(
            old_cycle_steps(&short, &CONTEXT),
            Err(KlartextCycleFault::Incomplete(_))
        ));
    }
}
