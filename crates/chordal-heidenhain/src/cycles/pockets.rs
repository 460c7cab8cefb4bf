//! Pockets and slots: cycles 251 to 254, and 4 and 5 of old controls.
//!
//! Shape, levels and ends are those of the control. The order of the cuts is not given by any manual: each level is
//! cleared in rings from the centre outwards, in the direction that Q351 or DR gives.

use chordal_kernel::frames::sin_cos_degrees;

use super::levels::{MAX_CUTS, infeed_levels};
use super::old_cycles::OldCycle;
use super::outline::{KlartextPocketOutline, go_to_and_round, shrunk, turned};
use super::step::{CycleContext, CycleFeed, KlartextCycleFault, KlartextCycleStep};
use super::values::CycleValues;

/// The stepover as a part of the radius of the tool, where the cycle gives none.
const USUAL_OVERLAP: f64 = 1.0;

/// What is cut at each level.
#[derive(Clone, Copy, Debug)]
struct PocketLevels {
    clearance: f64,
    surface: f64,
    bottom: f64,
    end: f64,
    /// The depth of a cut.
    infeed: f64,
}

/// How it is cut.
#[derive(Clone, Copy, Debug)]
struct PocketFeeds {
    plunge: CycleFeed,
    mill: CycleFeed,
    finish: CycleFeed,
    /// The distance of two rings, mm.
    stepover: f64,
}

fn too_large(tool: f64, width: f64) -> KlartextCycleFault {
    let message = format!("the tool of {} mm does not fit into {width} mm", 2.0 * tool);
    KlartextCycleFault::ToolTooLarge(message)
}

/// The steps of cycle 251, 252, 253 or 254.
///
/// # Errors
/// Why it does not run.
pub fn pocket_steps(
    number: u32,
    values: &CycleValues,
    context: &CycleContext,
) -> Result<Vec<KlartextCycleStep>, KlartextCycleFault> {
    let Some(depth) = values.downward_depth()? else { return Ok(Vec::new()) };
    let tool = context.needed_tool_radius(number)?;
    let own = values.levels(depth);
    let allowance = values.length(368).max(0.0);
    let kind = values.number(215).round() as i64;
    let floor = if kind == 1 { values.length(369).max(0.0) } else { 0.0 };
    let levels = PocketLevels {
        clearance: own.clearance,
        surface: own.surface,
        bottom: own.bottom + floor,
        end: own.end,
        infeed: values.length(202),
    };
    let overlap = match values.number(370) {
        factor if factor > 0.0 => factor,
        _ => USUAL_OVERLAP,
    };
    let mill = values.feed(207);
    let finish = values.feed_or(385, mill);
    let feeds = PocketFeeds { plunge: values.feed(206), mill, finish, stepover: overlap * tool };
    let wall = outline(number, values, tool)?;
    let rough = shrunk(wall, allowance);
    let parts = PocketParts {
        wall,
        rough,
        roughs: kind != 2,
        finishes: kind != 1 && allowance > 0.0,
        is_clockwise: context.turns_clockwise_inside(values.number(351)),
    };
    let mut steps = vec![KlartextCycleStep::Rapid(levels.clearance)];
    for place in places(number, values, context) {
        cut_pocket(&parts, place, &levels, &feeds, &mut steps)?;
    }
    steps.push(KlartextCycleStep::Rapid(levels.end));
    Ok(steps)
}

/// The steps of cycle 4 or 5, which begin at the level where the tool is.
///
/// # Errors
/// Why it does not run.
pub fn old_pocket_steps(
    cycle: &OldCycle,
    context: &CycleContext,
) -> Result<Vec<KlartextCycleStep>, KlartextCycleFault> {
    cycle.check_complete()?;
    let value = |line: u32, index: usize| cycle.nth_value(line, index);
    let tool = context.needed_tool_radius(cycle.number)?;
    let surface = context.level - value(1, 0).abs();
    let levels = PocketLevels {
        clearance: context.level,
        surface,
        bottom: surface - value(2, 0).abs(),
        end: context.level,
        infeed: value(3, 0).abs(),
    };
    let mut mill = CycleFeed::Active;
    let wall = match cycle.number {
        4 => {
            let mut sides = [value(4, 0), value(5, 0)].map(f64::abs);
            if cycle.data.second_axis_first {
                sides.swap(0, 1);
            }
            mill = speed(value(6, 0)).unwrap_or(mill);
            rectangle(sides, value(6, 1), 0.0, tool)?
        }
        _ => {
            mill = speed(value(5, 0)).unwrap_or(mill);
            circle(2.0 * value(4, 0).abs(), tool)?
        }
    };
    let plunge = speed(value(3, 1)).unwrap_or(mill);
    let feeds = PocketFeeds { plunge, mill, finish: mill, stepover: USUAL_OVERLAP * tool };
    let parts = PocketParts {
        wall,
        rough: wall,
        roughs: true,
        finishes: false,
        is_clockwise: cycle.data.is_clockwise,
    };
    let mut steps = Vec::new();
    cut_pocket(&parts, [0.0; 2], &levels, &feeds, &mut steps)?;
    steps.push(KlartextCycleStep::Rapid(levels.end));
    Ok(steps)
}

fn speed(value: f64) -> Option<CycleFeed> {
    (value > 0.0).then_some(CycleFeed::Speed(value))
}

/// The path of the centre of a tool in a rectangle, which may be turned.
///
/// # Errors
/// For a tool that does not fit.
pub fn rectangle(
    sides: [f64; 2],
    corner: f64,
    degrees: f64,
    tool: f64,
) -> Result<KlartextPocketOutline, KlartextCycleFault> {
    let halves = sides.map(|side| side / 2.0 - tool);
    if halves.iter().any(|half| *half < -1e-9) {
        return Err(too_large(tool, sides[0].min(sides[1])));
    }
    let halves = halves.map(|half| half.max(0.0));
    let corner = (corner - tool).clamp(0.0, halves[0].min(halves[1]));
    Ok(KlartextPocketOutline::Rectangle(halves, corner, degrees))
}

/// The path of the centre of a tool in a circle.
///
/// # Errors
/// For a tool that does not fit.
pub fn circle(diameter: f64, tool: f64) -> Result<KlartextPocketOutline, KlartextCycleFault> {
    let radius = diameter / 2.0 - tool;
    if radius < -1e-9 {
        return Err(too_large(tool, diameter));
    }
    Ok(KlartextPocketOutline::Circle(radius.max(0.0), 0.0))
}

fn outline(
    number: u32,
    values: &CycleValues,
    tool: f64,
) -> Result<KlartextPocketOutline, KlartextCycleFault> {
    match number {
        251 => {
            let sides = [values.length(218), values.length(219)];
            rectangle(sides, values.length(220), values.number(224), tool)
        }
        252 => circle(values.length(223), tool),
        253 => {
            let sides = [values.length(218), values.length(219)];
            rectangle(sides, sides[1] / 2.0, values.number(374), tool)
        }
        _ => {
            let half = values.length(219) / 2.0 - tool;
            if half < -1e-9 {
                return Err(too_large(tool, values.length(219)));
            }
            let radius = values.length(375) / 2.0;
            Ok(KlartextPocketOutline::ArcSlot(
                radius,
                half.max(0.0).min(radius),
                values.number(376),
                values.number(248),
            ))
        }
    }
}

/// The centres of the pockets from where the cycle is called: a rectangle may be named by a corner, an arc slot by its
/// centre, and it may be repeated.
fn places(number: u32, values: &CycleValues, context: &CycleContext) -> Vec<[f64; 2]> {
    if number == 254 {
        let [x, y] = [216, 217].map(|number| values.length(number));
        return vec![context.offset_to([x, y])];
    }
    let [long, wide] = [218, 219].map(|number| values.length(number) / 2.0);
    let place = values.number(367).round() as i64;
    let (local, degrees) = match (number, place) {
        // The corners, counter-clockwise from the one with the smallest coordinates.
        (251, 1) => ([long, wide], values.number(224)),
        (251, 2) => ([-long, wide], values.number(224)),
        (251, 3) => ([-long, -wide], values.number(224)),
        (251, 4) => ([long, -wide], values.number(224)),
        (253, 1) => ([long, 0.0], values.number(374)),
        (253, 2) => ([long - wide, 0.0], values.number(374)),
        (253, 3) => ([wide - long, 0.0], values.number(374)),
        (253, 4) => ([-long, 0.0], values.number(374)),
        _ => ([0.0; 2], 0.0),
    };
    vec![turned(local, degrees)]
}

/// What is done of a pocket.
#[derive(Clone, Copy, Debug)]
struct PocketParts {
    wall: KlartextPocketOutline,
    rough: KlartextPocketOutline,
    roughs: bool,
    finishes: bool,
    is_clockwise: bool,
}

fn cut_pocket(
    parts: &PocketParts,
    place: [f64; 2],
    levels: &PocketLevels,
    feeds: &PocketFeeds,
    steps: &mut Vec<KlartextCycleStep>,
) -> Result<(), KlartextCycleFault> {
    let cut_levels = infeed_levels(levels.surface, levels.bottom, levels.infeed)?;
    let count = cut_levels.len() as f64;
    let all_rings = rings(&parts.rough, feeds.stepover)?;
    if count * all_rings.len() as f64 > MAX_CUTS {
        let message = format!(
            "an infeed of {} mm and a stepover of {} mm make {} rings",
            levels.infeed,
            feeds.stepover,
            count * all_rings.len() as f64
        );
        return Err(KlartextCycleFault::BadValue(message));
    }
    let start = start_point(&parts.rough, place);
    steps.push(KlartextCycleStep::Across { offset: start, feed: CycleFeed::Rapid });
    if parts.roughs {
        for level in cut_levels {
            steps.push(KlartextCycleStep::Feed { to: level, feed: feeds.plunge });
            for ring in &all_rings {
                go_to_and_round(ring, place, parts.is_clockwise, feeds.mill, steps);
            }
            steps.push(KlartextCycleStep::Across { offset: start, feed: feeds.mill });
        }
    }
    if parts.finishes {
        steps.push(KlartextCycleStep::Feed { to: levels.bottom, feed: feeds.plunge });
        go_to_and_round(&parts.wall, place, parts.is_clockwise, feeds.finish, steps);
        steps.push(KlartextCycleStep::Across { offset: start, feed: feeds.finish });
    }
    steps.push(KlartextCycleStep::Rapid(levels.clearance));
    Ok(())
}

/// Where the tool goes down.
fn start_point(outline: &KlartextPocketOutline, place: [f64; 2]) -> [f64; 2] {
    let local = match outline {
        KlartextPocketOutline::ArcSlot(radius, _, from, _) => {
            let (sin, cos) = sin_cos_degrees(*from);
            [radius * cos, radius * sin]
        }
        KlartextPocketOutline::Rectangle(..) | KlartextPocketOutline::Circle(..) => [0.0; 2],
    };
    [place[0] + local[0], place[1] + local[1]]
}

/// The rings of a level from the inside outwards, the last on the wall.
fn rings(
    outline: &KlartextPocketOutline,
    stepover: f64,
) -> Result<Vec<KlartextPocketOutline>, KlartextCycleFault> {
    let reach = match outline {
        KlartextPocketOutline::Rectangle(halves, ..) => halves[0].min(halves[1]),
        KlartextPocketOutline::Circle(radius, _) => *radius,
        KlartextPocketOutline::ArcSlot(_, half, ..) => *half,
    };
    let count = if stepover > 0.0 { (reach / stepover - 1e-9).ceil().max(1.0) } else { 1.0 };
    if count > MAX_CUTS {
        let message = format!("a stepover of {stepover} mm makes {count} rings");
        return Err(KlartextCycleFault::BadValue(message));
    }
    let ring = |index: u32| {
        let inset = reach * (1.0 - f64::from(index) / count);
        shrunk(*outline, inset)
    };
    Ok((0..=count as u32).map(ring).collect())
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;

    const CONTEXT: CycleContext = CycleContext {
        level: 2.0,
        position: [0.0; 2],
        tool_radius: Some(5.0),
        point_angle: None,
        rpm: 1000.0,
        turns_left: false,
        peck_stop: Some(0.2),
        refuses_positive_depth: true,
    };

    fn steps(number: u32, numbers: &[(u32, f64)]) -> Vec<KlartextCycleStep> {
        let numbers: BTreeMap<u32, f64> = numbers.iter().copied().collect();
        let values = CycleValues::new(numbers, BTreeMap::new(), 1.0, 1.0 / 60.0);
        pocket_steps(number, &values, &CONTEXT).expect("steps")
    }

    /// The largest coordinates that the ends of the steps reach.
    fn reach(steps: &[KlartextCycleStep]) -> [f64; 2] {
        steps.iter().fold([0.0_f64; 2], |most, step| match step {
            KlartextCycleStep::Across { offset: [x, y], .. }
            | KlartextCycleStep::Arc { end: [x, y], .. } => {
                [most[0].max(x.abs()), most[1].max(y.abs())]
            }
            _ => most,
        })
    }

    fn plunges(steps: &[KlartextCycleStep]) -> usize {
        steps.iter().filter(|step| matches!(step, KlartextCycleStep::Feed { .. })).count()
    }

    #[test]
    fn the_centre_of_the_tool_stays_its_radius_from_the_walls() {
        let data = [(200, 2.0), (201, -12.0), (202, 4.0), (218, 60.0), (219, 40.0), (220, 8.0)];
        let found = steps(251, &data);
        assert_eq!(reach(&found), [25.0, 15.0]);
        assert_eq!(plunges(&found), 3);
        let round = [(200, 2.0), (201, -10.0), (202, 2.5), (223, 50.0)];
        let found = steps(252, &round);
        assert_eq!(reach(&found), [20.0, 0.0]);
        assert_eq!(plunges(&found), 4);
    }

    #[test]
    fn arcs_of_a_slot_end_where_the_next_begins() {
        let data = [(200, 2.0), (201, -6.0), (219, 12.0), (375, 70.0), (376, 45.0), (248, 90.0)];
        let mut at = [0.0; 2];
        for step in steps(254, &data) {
            match step {
                KlartextCycleStep::Across { offset, .. } => at = offset,
                KlartextCycleStep::Arc { center, end, sweep_rad, .. } => {
                    let [x, y] = [at[0] - center[0], at[1] - center[1]];
                    let (sin, cos) = libm::sincos(sweep_rad);
                    let reached = [center[0] + x * cos - y * sin, center[1] + x * sin + y * cos];
                    assert!((reached[0] - end[0]).hypot(reached[1] - end[1]) < 1e-9);
                    at = end;
                }
                _ => {}
            }
        }
    }

    #[test]
    fn a_tool_that_does_not_fit_is_refused() {
        let numbers: BTreeMap<u32, f64> = [(201, -5.0), (223, 9.0)].into_iter().collect();
        let values = CycleValues::new(numbers, BTreeMap::new(), 1.0, 1.0 / 60.0);
        let fault = pocket_steps(252, &values, &CONTEXT);
        assert!(matches!(fault, Err(KlartextCycleFault::ToolTooLarge(_))));
    }
}
