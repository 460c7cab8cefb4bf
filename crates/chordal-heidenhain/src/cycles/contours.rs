//! Contour (SL) cycles: 21 to 25 with the data of cycle 20 (TNC 640 cycle programming 34059x, chapter 7).
//!
//! Side finishing and the contour train follow the true parallel of the contour; levels and ends are those of the control.
//! The rough-out clears each level in rings from the inside outwards; how the tool comes to the wall, and from ring to
//! ring, is assumed.

use std::f64::consts::PI;

use chordal_geometry::Vec2;
use chordal_kernel::shapes::{IslandPocket, Outline, OutlineElement, offset_train};

use super::levels::{MAX_CUTS, infeed_levels};
use super::step::{CycleContext, CycleFeed, KlartextCycleFault, KlartextCycleStep};
use super::values::CycleValues;

/// The most rings of a pocket.
const MAX_POCKET_RINGS: usize = 1000;

/// The most moves of a cycle.
const MAX_CONTOUR_MOVES: usize = 200_000;

/// A wall that stays further from the tool than this, mm, is not reached.
const UNREACHED_MM: f64 = 1e-3;

/// The heights and feeds that all of these cycles have.
#[derive(Clone, Copy, Debug)]
struct ContourLevels {
    /// Q5 + Q6.
    clearance: f64,
    /// Q5.
    surface: f64,
    /// Q5 + Q1.
    bottom: f64,
    /// Q7.
    top: f64,
    plunge: CycleFeed,
    mill: CycleFeed,
}

impl ContourLevels {
    /// From the data of cycle 20 with those of the cycle; `None` for a depth of 0.
    fn of(values: &CycleValues) -> Result<Option<ContourLevels>, KlartextCycleFault> {
        let depth = values.length(1);
        if depth > 0.0 {
            let message = format!("the depth Q1 is {depth}: it is negative downwards");
            return Err(KlartextCycleFault::BadValue(message));
        }
        let surface = values.length(5);
        let levels = ContourLevels {
            // Cycle 25 has no set-up clearance: the tool goes down from the clearance height.
            clearance: if values.has(6) { surface + values.length(6) } else { values.length(7) },
            surface,
            bottom: surface + depth,
            top: values.length(7),
            plunge: values.feed(11),
            mill: values.feed(12),
        };
        Ok((depth != 0.0).then_some(levels))
    }
}

/// Collects steps from where a cycle was called.
struct ContourSteps {
    origin: [f64; 2],
    steps: Vec<KlartextCycleStep>,
}

impl ContourSteps {
    fn new(context: &CycleContext) -> ContourSteps {
        ContourSteps { origin: context.position, steps: Vec::new() }
    }

    fn offset(&self, p: Vec2) -> [f64; 2] {
        [p.a - self.origin[0], p.b - self.origin[1]]
    }

    fn push(&mut self, step: KlartextCycleStep) {
        self.steps.push(step);
    }

    fn across(&mut self, p: Vec2, feed: CycleFeed) {
        let offset = self.offset(p);
        self.push(KlartextCycleStep::Across { offset, feed });
    }

    fn follow(&mut self, elements: &[OutlineElement], feed: CycleFeed) {
        for element in elements {
            match *element {
                OutlineElement::Line { to, .. } => self.across(to, feed),
                OutlineElement::Arc { to, center, sweep, .. } => {
                    let (center, end) = (self.offset(center), self.offset(to));
                    self.push(KlartextCycleStep::Arc { center, end, sweep_rad: sweep, feed });
                }
            }
        }
    }

    /// Down at a point: by rapids above the part, and at the plunging feed to a level.
    fn go_down(&mut self, p: Vec2, level: f64, levels: &ContourLevels) {
        self.across(p, CycleFeed::Rapid);
        self.push(KlartextCycleStep::Rapid(levels.clearance));
        self.push(KlartextCycleStep::Feed { to: level, feed: levels.plunge });
    }

    fn finish(self) -> Result<Vec<KlartextCycleStep>, KlartextCycleFault> {
        if self.steps.len() > MAX_CONTOUR_MOVES {
            let message = format!("the cycle makes {} moves", self.steps.len());
            return Err(KlartextCycleFault::BadValue(message));
        }
        Ok(self.steps)
    }
}

fn no_room(keep: f64, place: Vec2) -> KlartextCycleFault {
    let message = format!(
        "the tool needs {keep} mm to the walls, and there is no room at {:.3}, {:.3}",
        place.a, place.b
    );
    KlartextCycleFault::ToolTooLarge(message)
}

/// The rings of a pocket from the inside outwards, each from its point nearest to where the one before ends, and whether
/// the tool may go there on the level.
fn ordered_rings(
    pocket: &IslandPocket,
    keep: f64,
    step: f64,
) -> Result<Vec<(Vec<OutlineElement>, bool)>, KlartextCycleFault> {
    let Some(rings) = pocket.rings(keep, step, MAX_POCKET_RINGS) else {
        let message = format!("a stepover of {step} mm makes more than {MAX_POCKET_RINGS} rings");
        return Err(KlartextCycleFault::BadValue(message));
    };
    let mut found: Vec<(Vec<OutlineElement>, bool)> = Vec::new();
    let mut at: Option<Vec2> = None;
    for ring in rings.iter().rev() {
        let mut left: Vec<&Outline> = ring.iter().collect();
        while !left.is_empty() {
            let near = |own: &&Outline| at.map_or(0.0, |at| own.distance(at));
            let nearest =
                (0..left.len()).min_by(|a, b| near(&left[*a]).total_cmp(&near(&left[*b])));
            let Some(nearest) = nearest else { break };
            let outline = left.swap_remove(nearest);
            let begin = outline.elements().first().map(OutlineElement::from);
            let elements = outline.begun_near(at.or(begin).unwrap_or(Vec2::ZERO));
            let Some(first) = elements.first() else { continue };
            let is_clear = at.is_some_and(|at| pocket.is_clear(keep, at, first.from()));
            at = Some(first.from());
            found.push((elements, is_clear));
        }
    }
    Ok(found)
}

/// Clears a pocket down to a bottom in infeeds.
fn clear(
    pocket: &IslandPocket,
    keep: f64,
    step: f64,
    cut_levels: &[f64],
    levels: &ContourLevels,
    into: &mut ContourSteps,
) -> Result<(), KlartextCycleFault> {
    let rings = ordered_rings(pocket, keep, step)?;
    if rings.is_empty() {
        let place = pocket.outline().elements().first().map_or(Vec2::ZERO, OutlineElement::from);
        return Err(no_room(keep, place));
    }
    if (rings.len() * cut_levels.len()) as f64 > MAX_CUTS {
        let message = format!("{} levels of {} rings are too many", cut_levels.len(), rings.len());
        return Err(KlartextCycleFault::BadValue(message));
    }
    for level in cut_levels {
        for (index, (elements, is_clear)) in rings.iter().enumerate() {
            let Some(first) = elements.first() else { continue };
            match *is_clear {
                true => into.across(first.from(), levels.mill),
                false => {
                    if index > 0 {
                        into.push(KlartextCycleStep::Rapid(levels.clearance));
                    }
                    into.go_down(first.from(), *level, levels);
                }
            }
            into.follow(elements, levels.mill);
        }
        into.push(KlartextCycleStep::Rapid(levels.clearance));
    }
    Ok(())
}

/// Cycles 22 (rough-out in infeeds that leave the allowances) and 23 (the floor at its depth).
///
/// # Errors
/// Why it does not run.
pub fn rough_out_steps(
    number: u32,
    values: &CycleValues,
    context: &CycleContext,
    pockets: &[IslandPocket],
) -> Result<Vec<KlartextCycleStep>, KlartextCycleFault> {
    let Some(levels) = ContourLevels::of(values)? else { return Ok(Vec::new()) };
    let tool = context.needed_tool_radius(number)?;
    let overlap = if values.number(2) > 0.0 { values.number(2) } else { 1.0 };
    // Rings further apart than the radius would leave corners that the control's own lines do not leave.
    let step = tool * overlap.min(1.0);
    if step <= 0.0 {
        let message = format!("cycle {number} needs a tool with a radius");
        return Err(KlartextCycleFault::BadValue(message));
    }
    let cut_levels = match number {
        22 => {
            let bottom = (levels.bottom + values.length(4).max(0.0)).min(levels.surface);
            infeed_levels(levels.surface, bottom, values.length(10))?
        }
        _ => vec![levels.bottom],
    };
    let keep = tool + values.length(3);
    let mut into = ContourSteps::new(context);
    into.push(KlartextCycleStep::Rapid(levels.top));
    for pocket in pockets {
        clear(pocket, keep, step, &cut_levels, &levels, &mut into)?;
    }
    into.push(KlartextCycleStep::Rapid(levels.top));
    into.finish()
}

/// Cycle 24: each wall in infeeds, reached and left on half circles where there is room.
///
/// # Errors
/// Why it does not run.
pub fn side_finishing_steps(
    values: &CycleValues,
    context: &CycleContext,
    pockets: &[IslandPocket],
) -> Result<Vec<KlartextCycleStep>, KlartextCycleFault> {
    let Some(levels) = ContourLevels::of(values)? else { return Ok(Vec::new()) };
    let tool = context.needed_tool_radius(24)?;
    let keep = tool + values.length(14);
    let cut_levels = infeed_levels(levels.surface, levels.bottom, values.length(10))?;
    let mut into = ContourSteps::new(context);
    into.push(KlartextCycleStep::Rapid(levels.top));
    for pocket in pockets {
        let borders = pocket.borders(keep);
        if borders.is_empty() {
            let first = pocket.outline().elements().first();
            return Err(no_room(keep, first.map_or(Vec2::ZERO, OutlineElement::from)));
        }
        for border in borders {
            let mut elements = border.begun_in_middle();
            if values.number(9) < 0.0 {
                // Up-cut milling.
                elements = elements.iter().rev().map(OutlineElement::reversed).collect();
            }
            let Some(first) = elements.first().copied() else { continue };
            let arc = wall_arc(pocket, keep, &first, tool, values.number(9) < 0.0);
            for level in &cut_levels {
                match arc {
                    Some((center, begin, sweep_rad)) => {
                        into.go_down(begin, *level, &levels);
                        let to = first.from();
                        let half =
                            OutlineElement::Arc { from: begin, to, center, sweep: sweep_rad };
                        into.follow(&[half], levels.mill);
                        into.follow(&elements, levels.mill);
                        let back =
                            OutlineElement::Arc { from: to, to: begin, center, sweep: sweep_rad };
                        into.follow(&[back], levels.mill);
                    }
                    None => {
                        into.go_down(first.from(), *level, &levels);
                        into.follow(&elements, levels.mill);
                    }
                }
                into.push(KlartextCycleStep::Rapid(levels.clearance));
            }
        }
    }
    into.push(KlartextCycleStep::Rapid(levels.top));
    into.finish()
}

/// A half circle that is tangent to the start of a wall, in the room of the tool: its centre, where it begins, and its
/// angle, rad; `None` where there is no room for one.
fn wall_arc(
    pocket: &IslandPocket,
    keep: f64,
    first: &OutlineElement,
    tool: f64,
    is_reversed: bool,
) -> Option<(Vec2, Vec2, f64)> {
    let inward = first.direction(0.0)?.turned_left() * if is_reversed { -1.0 } else { 1.0 };
    let at = first.from();
    [1.0, 0.5, 0.25, 0.1].into_iter().find_map(|part| {
        let radius = tool * part;
        let (center, begin) = (at + inward * radius, at + inward * (2.0 * radius));
        // The whole circle stays as far from the walls as the wall itself.
        pocket.has_room(center, keep + radius).then(|| {
            let sweep = if is_reversed { -PI } else { PI };
            (center, begin, sweep)
        })
    })
}

/// What the tool of a cycle leaves of the walls: how far it stays from one, mm, and where.
pub fn unreached_wall(pocket: &IslandPocket, tool: f64) -> Option<(f64, Vec2)> {
    pocket.unreached(&pocket.borders(tool), tool, UNREACHED_MM)
}

/// The side of a contour train on which the tool is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum TrainSide {
    /// R0: on it.
    On,
    /// RL.
    Left,
    /// RR.
    Right,
}

/// Cycle 25: along an open or closed contour in infeeds. Q15 chooses the direction: climb, up-cut, or both in turn.
///
/// # Errors
/// Why it does not run.
pub fn contour_train_steps(
    values: &CycleValues,
    context: &CycleContext,
    chain: &[OutlineElement],
    side: TrainSide,
) -> Result<Vec<KlartextCycleStep>, KlartextCycleFault> {
    let Some(levels) = ContourLevels::of(values)? else { return Ok(Vec::new()) };
    let tool = context.needed_tool_radius(25)?;
    let keep = tool + values.length(3);
    let distance = match side {
        TrainSide::On => 0.0,
        TrainSide::Left => keep,
        TrainSide::Right => -keep,
    };
    let path = offset_train(chain, distance).map_err(|error| no_room(keep, error.0))?;
    let backward: Vec<OutlineElement> = path.iter().rev().map(OutlineElement::reversed).collect();
    // On the left of the contour, its own direction is climb milling.
    let climbs_along = side != TrainSide::Right;
    let cut_levels = infeed_levels(levels.surface, levels.bottom, values.length(10))?;
    let mut into = ContourSteps::new(context);
    into.push(KlartextCycleStep::Rapid(levels.top));
    for (index, level) in cut_levels.iter().enumerate() {
        let climbs = match values.number(15) {
            kind if kind > 0.0 => true,
            kind if kind < 0.0 => false,
            _ => index % 2 == 0,
        };
        let elements = if climbs == climbs_along { &path } else { &backward };
        let Some(first) = elements.first() else { continue };
        let goes_on = values.number(15) == 0.0 && index > 0;
        match goes_on {
            true => into.push(KlartextCycleStep::Feed { to: *level, feed: levels.plunge }),
            false => into.go_down(first.from(), *level, &levels),
        }
        into.follow(elements, levels.mill);
        if values.number(15) != 0.0 {
            into.push(KlartextCycleStep::Rapid(levels.top));
        }
    }
    into.push(KlartextCycleStep::Rapid(levels.top));
    into.finish()
}
