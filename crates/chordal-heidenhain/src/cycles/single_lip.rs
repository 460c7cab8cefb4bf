//! Single-lip deep-hole drilling: cycle 241 (iTNC 530 cycle programming 60642x, 3.10; TNC 640 34059x, 4.10).

use chordal_command::SpindleState;

use super::drilling::stroke_levels;
use super::step::{CycleContext, CycleFeed, KlartextCycleFault, KlartextCycleStep};
use super::values::{CycleLevels, CycleValues, checked_depth};

/// The steps of cycle 241.
///
/// # Errors
/// Why it does not run.
pub fn single_lip_steps(
    _: u32,
    values: &CycleValues,
    context: &CycleContext,
) -> Result<Vec<KlartextCycleStep>, KlartextCycleFault> {
    let depth = checked_depth(values.length(201), context.refuses_positive_depth)?;
    let Some(depth) = depth else { return Ok(Vec::new()) };
    let whole = values.levels(depth);
    let CycleLevels { surface, clearance, .. } = whole;
    let sign = depth.signum();
    let begin = surface + sign * values.length(379).abs();
    let levels = CycleLevels { surface: begin, ..whole };
    let mut steps = vec![KlartextCycleStep::Rapid(clearance)];
    turn_for_entry(values, &mut steps);
    if begin != surface {
        let to = begin + (clearance - surface);
        steps.push(KlartextCycleStep::Feed { to, feed: values.feed(253) });
    }
    turn_for_drilling(values, &mut steps);
    coolant(values, 429, &mut steps);
    drill(values, surface, sign, &levels, &mut steps)?;
    coolant(values, 430, &mut steps);
    turn_for_entry(values, &mut steps);
    steps.push(KlartextCycleStep::moved(clearance, values.retraction()));
    steps.push(KlartextCycleStep::Rapid(levels.end));
    Ok(steps)
}

/// Down to the bottom in infeeds, each after a dwell, without leaving the hole; from the dwell depth on slower.
fn drill(
    values: &CycleValues,
    surface: f64,
    sign: f64,
    levels: &CycleLevels,
    steps: &mut Vec<KlartextCycleStep>,
) -> Result<(), KlartextCycleFault> {
    let first = values.length(202);
    let least = if values.has(205) { values.length(205) } else { first };
    let mut stops = stroke_levels(levels, first, values.length(212), least)?;
    let slow = surface + sign * values.length(435).abs();
    let is_between = |level: f64| (level - levels.surface) * (level - levels.bottom) < 0.0;
    let slows = values.length(435) != 0.0 && is_between(slow);
    if slows && !stops.contains(&slow) {
        stops.push(slow);
        stops.sort_by(|first, second| (sign * first).total_cmp(&(sign * second)));
    }
    let part = if values.number(401) > 0.0 { values.number(401) / 100.0 } else { 1.0 };
    for to in stops {
        let feed = match values.feed(206) {
            CycleFeed::Speed(speed) if slows && sign * to > sign * slow => {
                CycleFeed::Speed(speed * part)
            }
            feed => feed,
        };
        steps.push(KlartextCycleStep::Feed { to, feed });
        if values.number(211) > 0.0 {
            steps.push(KlartextCycleStep::Dwell(values.number(211)));
        }
    }
    Ok(())
}

/// The spindle for entry and exit turns in the direction of Q426: 3, 4, or 5 for a standstill. Without Q426 it stays.
fn turn_for_entry(values: &CycleValues, steps: &mut Vec<KlartextCycleStep>) {
    let state = match values.number(426).round() as i64 {
        3 => SpindleState::Cw,
        4 => SpindleState::Ccw,
        5 => SpindleState::Off,
        _ => return,
    };
    steps.push(KlartextCycleStep::Turn { state, rpm: speed(values, 427) });
}

/// The hole itself is drilled clockwise, whatever the direction of the entry was.
fn turn_for_drilling(values: &CycleValues, steps: &mut Vec<KlartextCycleStep>) {
    if values.has(426) || values.has(428) {
        steps.push(KlartextCycleStep::Turn { state: SpindleState::Cw, rpm: speed(values, 428) });
    }
}

fn speed(values: &CycleValues, number: u32) -> Option<f64> {
    Some(values.number(number)).filter(|rpm| *rpm > 0.0)
}

/// The coolant by the number of its M function.
fn coolant(values: &CycleValues, number: u32, steps: &mut Vec<KlartextCycleStep>) {
    let function = values.number(number);
    if values.has(number) && function.fract() == 0.0 && (0.0..1000.0).contains(&function) {
        steps.push(KlartextCycleStep::Coolant(function as u32));
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;

    #[test]
    fn the_spindle_turns_slowly_into_the_hole_and_clockwise_in_it() {
        let context = CycleContext {
            level: 50.0,
            position: [0.0; 2],
            tool_radius: None,
            point_angle: None,
            rpm: 100.0,
            turns_left: false,
            peck_stop: Some(0.2),
            refuses_positive_depth: true,
        };
        let data = [
            (200, 3.0),
            (201, -80.0),
            (206, 25.0),
            (379, 16.0),
            (253, 50.0),
            (208, 300.0),
            (426, 4.0),
            (427, 50.0),
            (428, 1790.0),
            (429, 8.0),
            (430, 9.0),
        ];
        let numbers: BTreeMap<u32, f64> = data.into_iter().collect();
        let values = CycleValues::new(numbers, BTreeMap::new(), 1.0, 1.0 / 60.0);
        let steps = single_lip_steps(241, &values, &context).expect("steps");
        let turn = |state, rpm| KlartextCycleStep::Turn { state, rpm: Some(rpm) };
        let feed = |to, per_min: f64| KlartextCycleStep::Feed {
            to,
            feed: CycleFeed::Speed(per_min / 60.0),
        };
        let expected = [
            KlartextCycleStep::Rapid(3.0),
            turn(SpindleState::Ccw, 50.0),
            feed(-13.0, 50.0),
            turn(SpindleState::Cw, 1790.0),
            KlartextCycleStep::Coolant(8),
            feed(-80.0, 25.0),
            KlartextCycleStep::Coolant(9),
            turn(SpindleState::Ccw, 50.0),
            feed(3.0, 300.0),
            KlartextCycleStep::Rapid(3.0),
        ];
        assert_eq!(steps, expected);
    }
}
