//! Forms of entering and leaving: good ones, and ones that may cut.

use std::f64::consts::{FRAC_PI_2, PI};

use chordal::geometry::Vec2;
use chordal::path::gouge::{GougeCurve, ToolSide};

use crate::support::Dice;
use crate::walls::{self, begun_anywhere, circle, piece, reversed};

/// A program with compensation, and which part of it is wall.
pub struct Program {
    pub name: String,
    pub side: ToolSide,
    pub radius: f64,
    /// Where the lead-in begins.
    pub start: Vec2,
    /// The blocks with the offset.
    pub chain: Vec<GougeCurve>,
    /// Where the lead-out ends.
    pub end: Vec2,
    pub wall: Vec<GougeCurve>,
    /// The wall does not come back to its start.
    pub is_open: bool,
    /// The wall without the ends that are also read as leads: the text does not say which of the two
    /// they are.
    pub sure: Vec<GougeCurve>,
}

/// Directions at the start of a curve: along it, and to the tool.
fn frame(curve: &GougeCurve, side: f64) -> (Vec2, Vec2) {
    let along = match *curve {
        GougeCurve::Line { from, to } => (to - from).normalized().unwrap(),
        GougeCurve::Arc { start, sweep, .. } => {
            Vec2::new(start.cos(), start.sin()).turned_left() * sweep.signum()
        }
    };
    (along, along.turned_left() * side)
}

fn turned(p: Vec2, angle: f64) -> Vec2 {
    let (sin, cos) = angle.sin_cos();
    Vec2::new(p.a * cos - p.b * sin, p.a * sin + p.b * cos)
}

/// A lead to the start of a curve: where it begins, and its blocks with the offset.
struct Lead {
    name: &'static str,
    start: Vec2,
    blocks: Vec<GougeCurve>,
}

struct Maker<'a> {
    dice: &'a mut Dice,
    side: f64,
    radius: f64,
}

impl Maker<'_> {
    fn near(&mut self, at: Vec2, along: Vec2, to_tool: Vec2) -> Vec2 {
        let away = self.dice.between(1.02, 4.0) * self.radius;
        at + to_tool * away + along * (self.dice.between(-2.0, 0.7) * self.radius)
    }

    fn anywhere(&mut self) -> Vec2 {
        Vec2::new(self.dice.between(-60.0, 60.0), self.dice.between(-60.0, 60.0))
    }

    /// The arc of `radius` that runs into the curve with the tool inside.
    fn arc(&mut self, curve: &GougeCurve, radius: f64, sweep: f64) -> GougeCurve {
        let (_, to_tool) = frame(curve, self.side);
        let center = curve.from() + to_tool * radius;
        let out = curve.from() - center;
        let end = out.b.atan2(out.a);
        GougeCurve::Arc { center, radius, start: end - self.side * sweep, sweep: self.side * sweep }
    }

    fn line(&mut self, curve: &GougeCurve) -> Lead {
        let (along, to_tool) = frame(curve, self.side);
        let start = self.near(curve.from(), along, to_tool);
        Lead { name: "line", start, blocks: Vec::new() }
    }

    fn rolled(&mut self, curve: &GougeCurve) -> Lead {
        let (radius, sweep) =
            (self.dice.between(1.05, 4.0) * self.radius, self.dice.between(0.6, PI));
        let arc = self.arc(curve, radius, sweep);
        let (along, to_tool) = frame(&arc, self.side);
        let start = self.near(arc.from(), along, to_tool);
        Lead { name: "arc", start, blocks: vec![arc] }
    }

    fn line_and_arc(&mut self, curve: &GougeCurve) -> Lead {
        let mut lead = self.rolled(curve);
        let arc = lead.blocks[0];
        let (along, _) = frame(&arc, self.side);
        let way = turned(along, self.dice.between(-0.8, 0.8));
        let from = arc.from() - way * (self.dice.between(1.0, 4.0) * self.radius);
        let line = GougeCurve::line(from, arc.from());
        let (along, to_tool) = frame(&line, self.side);
        lead.start = self.near(from, along, to_tool);
        lead.blocks.insert(0, line);
        lead.name = "line and arc";
        lead
    }

    /// A half circle from the centre of a round wall.
    fn rolled_from_centre(&mut self, curve: &GougeCurve) -> Option<Lead> {
        let GougeCurve::Arc { radius, center, sweep, .. } = *curve else { return None };
        if sweep * self.side < 0.0 || radius < 2.2 * self.radius {
            return None;
        }
        let arc = self.arc(curve, 0.5 * radius, PI);
        let (along, to_tool) = frame(&arc, self.side);
        let back = self.dice.between(0.0, 0.5) * self.radius;
        let start = center + to_tool * (1.05 * self.radius) - along * back;
        Some(Lead { name: "from the centre", start, blocks: vec![arc] })
    }

    /// Two lines with the offset, the second to the wall at an angle.
    fn two_lines(&mut self, curve: &GougeCurve) -> Lead {
        let (along, to_tool) = frame(curve, self.side);
        let way = turned(to_tool, self.dice.between(-1.2, 1.2));
        let from = curve.from() + way * (self.dice.between(1.5, 5.0) * self.radius);
        let line = GougeCurve::line(from, curve.from());
        let (_, beside) = frame(&line, self.side);
        let start = from + beside * (1.5 * self.radius) - along * self.radius;
        Lead { name: "two lines", start, blocks: vec![line] }
    }

    fn any(&mut self, curve: &GougeCurve) -> Lead {
        let kind = self.dice.unit();
        if kind < 0.2 {
            return self.line(curve);
        }
        if kind < 0.5 {
            return self.rolled(curve);
        }
        if kind < 0.65 {
            return self.line_and_arc(curve);
        }
        if kind < 0.75 {
            return self.two_lines(curve);
        }
        if kind < 0.88 {
            let line = self.rolled(curve);
            return self.rolled_from_centre(curve).unwrap_or(line);
        }
        let start = self.anywhere();
        if kind < 0.94 {
            return Lead { name: "from anywhere", start, blocks: Vec::new() };
        }
        Lead { name: "arc from anywhere", start, ..self.rolled(curve) }
    }

    /// The same for the end of a chain: the lead of the reversed curve, reversed.
    fn off(&mut self, curve: &GougeCurve) -> Lead {
        self.side = -self.side;
        let lead = self.any(&curve.reversed());
        self.side = -self.side;
        Lead { blocks: reversed(&lead.blocks), ..lead }
    }
}

/// Runs a closed chain a little past its start, as further blocks or as a longer last one.
fn overlapped(dice: &mut Dice, chain: &mut Vec<GougeCurve>) -> &'static str {
    let kind = dice.unit();
    if kind < 0.6 {
        return "";
    }
    let first = chain[0];
    let share = dice.between(0.05, 0.9);
    let last = chain.len() - 1;
    if kind < 0.8 && last > 0 && goes_on(&chain[last], &first) {
        chain[last] = joined(&chain[last], &piece(&first, 0.0, share));
        return ", run past in one block";
    }
    let whole = if dice.unit() < 0.5 { ((dice.unit() * 4.0) as usize).min(chain.len()) } else { 0 };
    let again: Vec<GougeCurve> = chain[..whole].to_vec();
    let next = chain[whole % chain.len()];
    chain.extend(again);
    chain.push(piece(&next, 0.0, share));
    ", run past"
}

/// Whether the second curve goes on along the first.
fn goes_on(first: &GougeCurve, second: &GougeCurve) -> bool {
    match (first, second) {
        (GougeCurve::Line { .. }, GougeCurve::Line { .. }) => {
            let (a, b) = (frame(first, 1.0).0, frame(second, 1.0).0);
            a.cross(b).abs() < 1e-9 && a.dot(b) > 0.0
        }
        (
            GougeCurve::Arc { center, radius, sweep, .. },
            GougeCurve::Arc { center: about, radius: other, sweep: turn, .. },
        ) => {
            center.distance(*about) < 1e-9
                && (radius - other).abs() < 1e-9
                && sweep * turn > 0.0
                && (sweep + turn).abs() < 6.0
        }
        _ => false,
    }
}

fn joined(first: &GougeCurve, second: &GougeCurve) -> GougeCurve {
    match (*first, *second) {
        (GougeCurve::Arc { center, radius, start, sweep }, GougeCurve::Arc { sweep: more, .. }) => {
            GougeCurve::Arc { center, radius, start, sweep: sweep + more }
        }
        _ => GougeCurve::line(first.from(), second.to()),
    }
}

/// A random program; none where the dice make nothing that can be run.
pub fn program(dice: &mut Dice) -> Option<Program> {
    let kind = dice.unit();
    if kind < 0.15 {
        return open_wall(dice);
    }
    if kind < 0.2 {
        return Some(pocket_with_island(dice));
    }
    let wall = walls::any(dice);
    let side = if dice.unit() < 0.5 { ToolSide::Left } else { ToolSide::Right };
    let radius = dice.between(0.4, 4.0);
    let mut chain = begun_anywhere(dice, &wall.curves);
    let mut passes = "";
    if dice.unit() < 0.15 {
        chain.extend(chain.clone());
        passes = " twice";
    }
    let past = overlapped(dice, &mut chain);
    let mut maker = Maker { dice, side: side.sign(), radius };
    let lead_in = maker.any(&chain[0]);
    let lead_out = maker.off(&chain[chain.len() - 1]);
    let name = format!("{}{passes}{past}: {}, {}", wall.name, lead_in.name, lead_out.name);
    chain.splice(0..0, lead_in.blocks);
    chain.extend(lead_out.blocks);
    let (start, end) = (lead_in.start, lead_out.start);
    Some(Program {
        name,
        side,
        radius,
        start,
        chain,
        end,
        sure: wall.curves.clone(),
        wall: wall.curves,
        is_open: false,
    })
}

/// Whether the end block of an open wall is an arc of up to half a turn about the tool, tangent to the next
/// and of another circle: the same words roll a tool onto the next block and off it.
fn is_as_a_lead(end: &GougeCurve, next: &GougeCurve, side: f64, radius: f64) -> bool {
    let GougeCurve::Arc { center, radius: of_end, sweep, .. } = *end else { return false };
    let same_circle = matches!(*next, GougeCurve::Arc { center: about, radius: other, .. }
        if about.distance(center) < 0.01 && (other - of_end).abs() < 0.01);
    let leaves = frame(&end.reversed(), 1.0).0 * -1.0;
    let bend = leaves.cross(frame(next, 1.0).0).abs();
    let is_tangent = bend < 0.03 && leaves.dot(frame(next, 1.0).0) > 0.0;
    sweep * side > 0.0
        && sweep.abs() <= PI + 1e-6
        && of_end >= radius - 0.01
        && is_tangent
        && !same_circle
}

/// The blocks of an open wall that can be nothing but wall. An end beyond which there is a lead with the
/// offset on is one of them: then that lead is the end of the chain.
fn sure_of(wall: &[GougeCurve], side: f64, radius: f64, led: [bool; 2]) -> Vec<GougeCurve> {
    let count = wall.len();
    let [last, before] = [wall[count - 1].reversed(), wall[count - 2].reversed()];
    let first_may_lead = !led[0] && is_as_a_lead(&wall[0], &wall[1], side, radius);
    let last_may_lead = !led[1] && is_as_a_lead(&last, &before, -side, radius);
    wall[usize::from(first_may_lead)..count - usize::from(last_may_lead)].to_vec()
}

/// A few blocks of a closed wall, entered and left by a line or an arc.
fn open_wall(dice: &mut Dice) -> Option<Program> {
    let whole = walls::any(dice);
    if whole.curves.len() < 4 {
        return None;
    }
    let count = 2 + (dice.unit() * (whole.curves.len() - 3) as f64) as usize;
    let wall = whole.curves[..count].to_vec();
    let side = if dice.unit() < 0.5 { ToolSide::Left } else { ToolSide::Right };
    let radius = dice.between(0.4, 4.0);
    let mut maker = Maker { dice, side: side.sign(), radius };
    let first = wall[0];
    let lead_in = if maker.dice.unit() < 0.5 { maker.line(&first) } else { maker.rolled(&first) };
    maker.side = -maker.side;
    let last = wall[count - 1].reversed();
    let lead_out = if maker.dice.unit() < 0.5 { maker.line(&last) } else { maker.rolled(&last) };
    let led = [!lead_in.blocks.is_empty(), !lead_out.blocks.is_empty()];
    let mut chain = lead_in.blocks;
    chain.extend(&wall);
    chain.extend(reversed(&lead_out.blocks));
    Some(Program {
        name: format!("open {}: {}, {}", whole.name, lead_in.name, lead_out.name),
        side,
        radius,
        start: lead_in.start,
        chain,
        end: lead_out.start,
        is_open: true,
        sure: sure_of(&wall, side.sign(), radius, led),
        wall,
    })
}

/// The walls of a round pocket, a line across to an island, round it, and off.
fn pocket_with_island(dice: &mut Dice) -> Program {
    let radius = dice.between(0.4, 4.0);
    let outer = dice.between(20.0, 40.0);
    let inner = dice.between(2.0, outer - 10.0);
    let center = Vec2::new(dice.between(-4.0, 4.0), dice.between(-4.0, 4.0));
    let mut chain = circle(Vec2::ZERO, outer, 0.0, 2);
    let begin = dice.between(-0.5, 0.5);
    let island = reversed(&circle(center, inner, begin, 1));
    let mut maker = Maker { dice, side: 1.0, radius };
    let (sweep, roll) = (maker.dice.between(1.0, FRAC_PI_2), 1.3 * radius);
    let first = chain[0];
    let arc = maker.arc(&first, roll, sweep);
    let (along, to_tool) = frame(&arc, 1.0);
    let start = arc.from() + to_tool * (1.1 * radius) - along * (0.2 * radius);
    let wall: Vec<GougeCurve> = chain.iter().chain(&island).copied().collect();
    chain.insert(0, arc);
    chain.push(GougeCurve::line(Vec2::new(outer, 0.0), island[0].from()));
    chain.extend(&island);
    let out = (island[0].from() - center).normalized().unwrap();
    let end = island[0].from() + out * (2.0 * radius);
    let name = "pocket with island".into();
    let sure = wall.clone();
    Program { name, side: ToolSide::Left, radius, start, chain, end, wall, is_open: false, sure }
}
