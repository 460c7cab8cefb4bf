//! Studs and finished walls: cycles 256 and 257, and 212 to 215 of older controls.
//!
//! Shape, levels and ends are those of the control: TNC 640 cycle programming 34059x, 5.6 and 5.7; TNC 426/430
//! 280 476, 8.4. The stud begins 2 mm to the right of its blank, and the wall is reached and left on half circles; how
//! the tool goes from one revolution to the next is assumed.

use std::f64::consts::PI;

use super::levels::{MAX_CUTS, equal_parts, infeed_levels};
use super::outline::{KlartextPocketOutline, go_round, grown, turned};
use super::pockets::{circle, rectangle};
use super::step::{CycleContext, CycleFeed, KlartextCycleFault, KlartextCycleStep};
use super::values::{CycleLevels, CycleValues};

/// How far from the blank of a stud the edge of the tool begins, mm.
const BEFORE_BLANK_MM: f64 = 2.0;

/// How far from its finished side the tool of cycle 213 begins, in radii of the tool.
const BEFORE_STUD_RADII: f64 = 3.5;

/// The same for cycle 215.
const BEFORE_ROUND_STUD_RADII: f64 = 2.0;

/// Revolutions along a wall, which the tool reaches and leaves on half circles.
#[derive(Clone, Debug)]
struct WallPass {
    /// Where the tool goes down: from the centre towards the side where a revolution begins, mm.
    begin: f64,
    /// The revolutions in their order.
    rings: Vec<KlartextPocketOutline>,
    is_clockwise: bool,
    feed: CycleFeed,
}

impl WallPass {
    /// The angle by which the shape is turned, degrees.
    fn degrees(&self) -> f64 {
        self.rings.first().map_or(0.0, KlartextPocketOutline::degrees)
    }

    /// The point where the tool goes down.
    fn begin_point(&self, place: [f64; 2]) -> [f64; 2] {
        on_side(self.begin, self.degrees(), place)
    }

    /// From the point where the tool goes down, along the wall, and back to it.
    fn cut(&self, place: [f64; 2], steps: &mut Vec<KlartextCycleStep>) {
        let (Some(first), Some(last)) = (self.rings.first(), self.rings.last()) else { return };
        self.half_circle(self.begin, first.side(), place, steps);
        for (index, ring) in self.rings.iter().enumerate() {
            if index > 0 {
                let offset = on_side(ring.side(), self.degrees(), place);
                steps.push(KlartextCycleStep::Across { offset, feed: self.feed });
            }
            go_round(ring, place, self.is_clockwise, self.feed, steps);
        }
        self.half_circle(last.side(), self.begin, place, steps);
    }

    fn half_circle(&self, from: f64, to: f64, place: [f64; 2], steps: &mut Vec<KlartextCycleStep>) {
        let end = on_side(to, self.degrees(), place);
        if (from - to).abs() < 1e-9 {
            return;
        }
        // Outside, the half circle turns the other direction than the revolution, inside the same: both are tangent.
        let is_outside = self.rings.first().is_some_and(|ring| self.begin > ring.side());
        let sweep_rad = if is_outside == self.is_clockwise { PI } else { -PI };
        let center = on_side((from + to) / 2.0, self.degrees(), place);
        steps.push(KlartextCycleStep::Arc { center, end, sweep_rad, feed: self.feed });
    }
}

/// A point on the axis of a shape on which its revolutions begin.
fn on_side(from_center: f64, degrees: f64, place: [f64; 2]) -> [f64; 2] {
    let [x, y] = turned([from_center, 0.0], degrees);
    [place[0] + x, place[1] + y]
}

/// The finished outline of a stud for the centre of the tool, and the half sides of its blank.
fn stud_outline(
    number: u32,
    values: &CycleValues,
    tool: f64,
) -> (KlartextPocketOutline, [f64; 2], [f64; 2]) {
    let half = |number: u32| values.length(number).abs() / 2.0;
    match number {
        256 | 213 => {
            let sides = [half(218), half(219)];
            let corner = values.length(220).clamp(0.0, sides[0].min(sides[1]));
            let degrees = values.number(224);
            let path = sides.map(|side| side + tool);
            let outline = KlartextPocketOutline::Rectangle(path, corner + tool, degrees);
            (outline, sides, [half(424), half(425)])
        }
        _ => {
            let radius = half(223);
            // Without a starting angle, or with -1, the control begins on the first axis.
            let degrees = values.number(376).max(0.0);
            let outline = KlartextPocketOutline::Circle(radius + tool, degrees);
            (outline, [radius; 2], [half(222); 2])
        }
    }
}

/// The centre of a stud from where cycle 256 is called: there is its centre or a corner.
fn stud_center(number: u32, values: &CycleValues) -> [f64; 2] {
    let [long, wide] = [218, 219].map(|number| values.length(number) / 2.0);
    let local = match (number, values.number(367).round() as i64) {
        (256, 1) => [long, wide],
        (256, 2) => [-long, wide],
        (256, 3) => [-long, -wide],
        (256, 4) => [long, -wide],
        _ => [0.0; 2],
    };
    turned(local, values.number(224))
}

/// The steps of cycle 256 or 257.
///
/// # Errors
/// Why it does not run.
pub fn stud_steps(
    number: u32,
    values: &CycleValues,
    context: &CycleContext,
) -> Result<Vec<KlartextCycleStep>, KlartextCycleFault> {
    let Some(depth) = values.downward_depth()? else { return Ok(Vec::new()) };
    let tool = context.needed_tool_radius(number)?;
    let (wall, sides, blank) = stud_outline(number, values, tool);
    for axis in 0..2 {
        if blank[axis] < sides[axis] - 1e-9 {
            let message = format!(
                "the stud of {} mm is larger than its blank of {} mm",
                2.0 * sides[axis],
                2.0 * blank[axis]
            );
            return Err(KlartextCycleFault::BadValue(message));
        }
    }
    // Older controls have no Q215 and leave the allowance.
    let kind = if values.has(215) { values.number(215).round() as i64 } else { 1 };
    let allowance = values.length(368).max(0.0);
    let overlap = if values.number(370) > 0.0 { values.number(370) } else { 1.0 };
    let CycleLevels { clearance, surface, bottom, end } = values.levels(depth);
    let excess = (0..2).map(|axis| blank[axis] - sides[axis] - allowance).fold(0.0, f64::max);
    let count = equal_parts(excess, overlap * tool)?;
    let ring = |index: u32| {
        let left = f64::from(count - 1 - index) / f64::from(count) * excess;
        grown(wall, allowance + left)
    };
    let mill = values.feed(207);
    let is_clockwise = values.number(351) >= 0.0;
    let begin = blank[0].max(sides[0] + allowance) + BEFORE_BLANK_MM + tool;
    let rough = WallPass { begin, rings: (0..count).map(ring).collect(), is_clockwise, feed: mill };
    let finish = values.feed_or(385, mill);
    let last = WallPass { begin, rings: vec![wall], is_clockwise, feed: finish };
    let floor = if kind == 1 { values.length(369).max(0.0) } else { 0.0 };
    let rough_levels = match kind {
        2 => Vec::new(),
        _ => infeed_levels(surface, bottom + floor, values.length(202))?,
    };
    let last_levels = match kind != 1 && (allowance > 0.0 || kind == 2) {
        true => infeed_levels(surface, bottom, values.length(338))?,
        false => Vec::new(),
    };
    check_count(rough_levels.len(), &rough)?;
    let place = stud_center(number, values);
    let mut steps = vec![KlartextCycleStep::Rapid(clearance)];
    steps.push(KlartextCycleStep::Across {
        offset: rough.begin_point(place),
        feed: CycleFeed::Rapid,
    });
    let plunge = values.feed(206);
    for (levels, pass) in [(rough_levels, rough), (last_levels, last)] {
        for to in levels {
            steps.push(KlartextCycleStep::Feed { to, feed: plunge });
            pass.cut(place, &mut steps);
        }
    }
    steps.push(KlartextCycleStep::Rapid(clearance));
    steps.push(KlartextCycleStep::Rapid(end));
    Ok(steps)
}

fn check_count(levels: usize, pass: &WallPass) -> Result<(), KlartextCycleFault> {
    let count = (levels * pass.rings.len()) as f64;
    if count > MAX_CUTS {
        let message = format!("{levels} levels of {} revolutions are too many", pass.rings.len());
        return Err(KlartextCycleFault::BadValue(message));
    }
    Ok(())
}

/// The steps of cycle 212, 213, 214 or 215: a wall is finished in infeeds, and the tool returns to the centre.
///
/// # Errors
/// Why it does not run.
pub fn wall_finishing_steps(
    number: u32,
    values: &CycleValues,
    context: &CycleContext,
) -> Result<Vec<KlartextCycleStep>, KlartextCycleFault> {
    let Some(depth) = values.downward_depth()? else { return Ok(Vec::new()) };
    let tool = context.needed_tool_radius(number)?;
    let CycleLevels { clearance, surface, bottom, end } = values.levels(depth);
    let is_stud = matches!(number, 213 | 215);
    let (wall, begin) = match number {
        212 => {
            let sides = [values.length(218), values.length(219)];
            let wall = rectangle(sides, values.length(220), 0.0, tool)?;
            (wall, inside_begin(wall, values.length(221)))
        }
        214 => {
            let wall = circle(values.length(223), tool)?;
            let allowance = (values.length(223) - values.length(222)) / 2.0;
            (wall, inside_begin(wall, allowance))
        }
        _ => {
            let (wall, sides, _) = stud_outline(number, values, tool);
            let radii = if number == 213 { BEFORE_STUD_RADII } else { BEFORE_ROUND_STUD_RADII };
            // Never nearer than the wall itself.
            (wall, (sides[0] + radii * tool).max(wall.side()))
        }
    };
    // Climb milling: counter-clockwise inside, clockwise round a stud.
    let feed = values.feed(207);
    let pass = WallPass { begin, rings: vec![wall], is_clockwise: is_stud, feed };
    let place = context.offset_to([216, 217].map(|number| values.length(number)));
    let mut steps = vec![KlartextCycleStep::Rapid(end)];
    let across = |offset| KlartextCycleStep::Across { offset, feed: CycleFeed::Rapid };
    steps.push(across(place));
    steps.push(across(pass.begin_point(place)));
    steps.push(KlartextCycleStep::Rapid(clearance));
    for to in infeed_levels(surface, bottom, values.length(202))? {
        steps.push(KlartextCycleStep::Feed { to, feed: values.feed(206) });
        pass.cut(place, &mut steps);
    }
    steps.push(KlartextCycleStep::Rapid(end));
    steps.push(across(place));
    Ok(steps)
}

/// Where the tool goes down in a pocket that was roughed but for an allowance. The half circle from there to the wall stays
/// in the pocket.
fn inside_begin(wall: KlartextPocketOutline, allowance: f64) -> f64 {
    let room = match wall {
        KlartextPocketOutline::Rectangle(halves, ..) => halves[0].min(halves[1]),
        KlartextPocketOutline::Circle(radius, _) => radius,
        KlartextPocketOutline::ArcSlot(_, half, ..) => half,
    };
    let inset = if allowance > 0.0 { allowance.min(room) } else { room };
    wall.side() - inset
}
