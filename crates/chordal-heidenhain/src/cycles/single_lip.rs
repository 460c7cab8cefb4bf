//! Single-lip deep-hole drilling: cycle 241 (iTNC 530 cycle programming 60642x, 3.10; TNC 640 34059x, 4.10).

use chordal_command::SpindleState;

use super::drilling::{DrilledHoleLevels, stroke_levels};
use super::step::{CycleContext, CycleFeed, KlartextCycleFault, KlartextCycleStep};
use super::values::CycleValues;

/// The steps of cycle 241.
///
/// # Errors
/// Why it does not run.
pub fn single_lip_steps(
    _: u32,
    values: &CycleValues,
    context: &CycleContext,
) -> Result<Vec<KlartextCycleStep>, KlartextCycleFault> {
    let depth = values.length(201);
    if depth == 0.0 {
        return Ok(Vec::new());
    }
    if depth > 0.0 && context.refuses_positive_depth {
        let message = format!("the depth Q201 is {depth}: it is negative downwards");
        return Err(KlartextCycleFault::BadValue(message));
    }
    let (surface, sign) = (values.length(203), depth.signum());
    let clearance = surface + values.length(200);
    let begin = surface + sign * values.length(379).abs();
    let levels = DrilledHoleLevels {
        clearance,
        surface: begin,
        bottom: surface + depth,
        end: clearance.max(surface + values.length(204)),
    };
    let mut steps = vec![KlartextCycleStep::Rapid(clearance)];
    turn(values, 427, &mut steps);
    if begin != surface {
        let to = begin + (clearance - surface);
        steps.push(KlartextCycleStep::Feed { to, feed: values.feed(253) });
    }
    turn(values, 428, &mut steps);
    coolant(values, 429, &mut steps);
    drill(values, surface, sign, &levels, &mut steps)?;
    coolant(values, 430, &mut steps);
    turn(values, 427, &mut steps);
    steps.push(KlartextCycleStep::moved(clearance, values.retraction()));
    steps.push(KlartextCycleStep::Rapid(levels.end));
    Ok(steps)
}

/// Down to the bottom in infeeds, each after a dwell, without leaving the hole; from the dwell depth on slower.
fn drill(
    values: &CycleValues,
    surface: f64,
    sign: f64,
    levels: &DrilledHoleLevels,
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

/// The spindle turns at a speed in the direction of Q426: 3, 4, or 5 for a standstill. Without Q426 it stays.
fn turn(values: &CycleValues, speed: u32, steps: &mut Vec<KlartextCycleStep>) {
    let state = match values.number(426).round() as i64 {
        3 => SpindleState::Cw,
        4 => SpindleState::Ccw,
        5 if speed == 427 => SpindleState::Off,
        // The hole itself is drilled with a turning spindle.
        5 => SpindleState::Cw,
        _ => return,
    };
    let rpm = values.has(speed).then(|| values.number(speed)).filter(|rpm| *rpm > 0.0);
    steps.push(KlartextCycleStep::Turn { state, rpm });
}

/// The coolant by the number of its M function.
fn coolant(values: &CycleValues, number: u32, steps: &mut Vec<KlartextCycleStep>) {
    let function = values.number(number);
    if values.has(number) && function.fract() == 0.0 && (0.0..1000.0).contains(&function) {
        steps.push(KlartextCycleStep::Coolant(function as u32));
    }
}
