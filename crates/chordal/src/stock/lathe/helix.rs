//! What a thread removes at most.
//!
//! While the part turns by θ of a revolution, every place at which the tool comes by moves on by θ of its advance. So
//! the volume of a thread is what one groove has in common with the section that the passes touch all round, while it
//! moves along the thread, and its mean over each revolution.

use chordal_geometry::Vec2;
use chordal_stock::lathe::{LatheStock, OutlineSegment, Region, ToolOutline as Outline};

use super::gather::TurnMove;
use super::threads::{SpindleRevolutions, ThreadAdvance};

/// Advances that differ by less are the same, mm.
const EQUAL_ADVANCE_MM: f64 = 1e-9;
/// Starts that are a whole number of revolutions apart, but for this part of one, cut the same groove.
const EQUAL_TURN_SHARE: f64 = 1e-6;
/// Steps in which a groove moves along a thread, about: what it has in common is taken as largest within each.
const STEPS: i64 = 64;
/// Steps of one revolution at most.
const MAX_STEPS: i64 = 16;

/// Moves of one thread that advance alike.
#[derive(Clone, Debug)]
struct ThreadCourse {
    /// In one revolution: along z and r, mm.
    advance: Vec2,
    /// Where the tool of the first move is at first.
    start: Vec2,
    /// What all of them take there of a solid body.
    groove: Region,
    /// Revolutions from there: the first and the last one, not counted.
    turns: (i64, i64),
}

/// The grooves of a thread as the part sees them.
#[derive(Clone, Debug, Default)]
pub(super) struct ThreadGrooves {
    courses: Vec<ThreadCourse>,
    /// The revolutions of a move are not known: only what it touches all round is a bound.
    is_unknown: bool,
}

impl ThreadGrooves {
    /// With a further move; `stock` is the box around it.
    pub fn add(
        &mut self,
        revolutions: &SpindleRevolutions,
        stock: (Vec2, Vec2),
        tool: &Outline,
        move_: &TurnMove,
    ) {
        let course = revolutions.turn_of(move_).and_then(|turning| {
            let groove = groove_of(tool, &turning, stock)?;
            let ThreadAdvance { advance, start, turns } = turning;
            Some(ThreadCourse { advance, start, groove, turns: (0, turns) })
        });
        let added = course.and_then(|course| self.with(course));
        self.is_unknown |= added.is_none();
    }

    fn with(&mut self, course: ThreadCourse) -> Option<()> {
        let alike =
            |known: &&mut ThreadCourse| known.advance.distance(course.advance) < EQUAL_ADVANCE_MM;
        match self.courses.iter_mut().find(alike) {
            Some(known) => known.join(&course)?,
            None => self.courses.push(course),
        }
        Some(())
    }

    /// With the moves of another one.
    pub fn join(&mut self, other: ThreadGrooves) {
        self.is_unknown |= other.is_unknown;
        for course in other.courses {
            self.is_unknown |= self.with(course).is_none();
        }
    }

    /// What is removed at most of a section that the moves touch all round, mm³.
    pub fn volume(&self, section: &Region) -> f64 {
        let all_round = section.volume();
        if self.is_unknown {
            return all_round;
        }
        let courses: Option<f64> = self.courses.iter().map(|course| course.volume(section)).sum();
        courses.map_or(all_round, |volume| volume.min(all_round))
    }
}

/// What a tool takes of a solid body at the start of a move, so far from the axis as the stock is anywhere along it.
fn groove_of(tool: &Outline, turning: &ThreadAdvance, (low, high): (Vec2, Vec2)) -> Option<Region> {
    let ThreadAdvance { advance, start, turns } = *turning;
    let rise = (turns as f64 * advance.b).abs();
    let radius = high.b + rise + advance.b.abs() + 1.0;
    let length = high.a - low.a + 2.0 * radius;
    let solid = Region::bar(radius, start.a - length, start.a + length).ok()?;
    let (_, taken) =
        LatheStock::new(&solid).touch(tool, &OutlineSegment::line(start, start)).ok()?;
    Some(taken)
}

impl ThreadCourse {
    /// With the moves of another one, whose grooves lie whole revolutions and less than one away.
    fn join(&mut self, other: &ThreadCourse) -> Option<()> {
        let square = self.advance.dot(self.advance);
        // Rounding must not put a groove that is cut again next to itself.
        let away =
            ((other.start - self.start).dot(self.advance) / square + EQUAL_TURN_SHARE).floor();
        let moved = other.groove.moved(self.advance * -away);
        self.groove = self.groove.union(&moved).ok()?.region;
        let away = away as i64;
        let (first, last) = (away + other.turns.0, away + other.turns.1);
        self.turns = (self.turns.0.min(first), self.turns.1.max(last));
        Some(())
    }

    /// `None` where the regions cannot be told apart.
    fn volume(&self, section: &Region) -> Option<f64> {
        let (first, last) = self.turns;
        let steps = (STEPS / (last - first).max(1)).clamp(1, MAX_STEPS);
        let step = self.advance * (1.0 / steps as f64);
        // What the groove meets while it moves on by a step. The section is longer along the thread than that.
        let reach = section.union(&section.moved(step * -1.0)).ok()?.region;
        let mut sum = 0.0;
        for number in first * steps..last * steps {
            let taken = self.groove.moved(step * number as f64).intersection(&reach).ok()?.region;
            let Some((low, _)) = taken.bounds() else { continue };
            // A thread that rises is farther from the axis at the end of the step.
            let grows = if step.b > 0.0 { 1.0 + step.b / low.b } else { 1.0 };
            sum += taken.volume() * grows;
        }
        Some(sum / steps as f64)
    }
}
