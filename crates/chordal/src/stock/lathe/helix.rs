//! The upper bound of what a thread removes.
//!
//! While the part turns by a fraction θ of a revolution, the groove in the half section moves on by θ of the lead. So
//! the volume of a thread is that of the intersection of one moving groove with the section that the passes touch all
//! round, averaged over each revolution.

use chordal_geometry::Vec2;
use chordal_stock::lathe::{LatheStock, OutlineSegment, Region, ToolOutline as Outline};

use super::gather::TurnMove;
use super::threads::{SpindleRevolutions, ThreadAdvance};

/// Leads that differ by less than this are equal, mm.
const EQUAL_ADVANCE_MM: f64 = 1e-9;
/// Starts that are a whole number of revolutions apart, within this share of one, cut the same groove.
const EQUAL_TURN_SHARE: f64 = 1e-6;
/// Number of steps along a thread, about. Within each step the largest intersection is taken, so that the result is
/// an upper bound.
const STEPS: i64 = 64;
/// Most steps of one revolution.
const MAX_STEPS: i64 = 16;

/// Moves of one thread with the same lead.
#[derive(Clone, Debug)]
struct ThreadCourse {
    /// The lead: the advance in one revolution along z and r, mm.
    advance: Vec2,
    /// Where the first move begins.
    start: Vec2,
    /// What all of them would remove from a solid body there.
    groove: Region,
    /// The range of revolutions from there; the end is exclusive.
    turns: (i64, i64),
}

/// The grooves of a thread.
#[derive(Clone, Debug, Default)]
pub(super) struct ThreadGrooves {
    courses: Vec<ThreadCourse>,
    /// The revolutions of some move are not known: then the only bound is what it touches all round.
    is_unknown: bool,
}

impl ThreadGrooves {
    /// Adds a move; `stock` is the bounding box of the stock.
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

    /// Adds the grooves of another pass.
    pub fn join(&mut self, other: ThreadGrooves) {
        self.is_unknown |= other.is_unknown;
        for course in other.courses {
            self.is_unknown |= self.with(course).is_none();
        }
    }

    /// Upper bound of what is removed from a section that the moves touch all round, mm³.
    pub fn volume(&self, section: &Region) -> f64 {
        let all_round = section.volume();
        if self.is_unknown {
            return all_round;
        }
        let courses: Option<f64> = self.courses.iter().map(|course| course.volume(section)).sum();
        courses.map_or(all_round, |volume| volume.min(all_round))
    }
}

/// What a tool would remove at the start of a move from a solid body that is as thick as the stock anywhere along the
/// move.
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
    /// Adds the moves of another course, whose grooves are moved by whole revolutions to lie within one of these.
    fn join(&mut self, other: &ThreadCourse) -> Option<()> {
        let square = self.advance.dot(self.advance);
        // Rounding must not shift a groove that is cut again by a whole revolution.
        let away =
            ((other.start - self.start).dot(self.advance) / square + EQUAL_TURN_SHARE).floor();
        let moved = other.groove.moved(self.advance * -away);
        self.groove = self.groove.union(&moved).ok()?.region;
        let away = away as i64;
        let (first, last) = (away + other.turns.0, away + other.turns.1);
        self.turns = (self.turns.0.min(first), self.turns.1.max(last));
        Some(())
    }

    /// The volume, mm³; `None` where an operation on the regions fails.
    fn volume(&self, section: &Region) -> Option<f64> {
        let (first, last) = self.turns;
        let steps = (STEPS / (last - first).max(1)).clamp(1, MAX_STEPS);
        let step = self.advance * (1.0 / steps as f64);
        // What the groove meets while it moves on by a step: the section is longer than a step along the thread.
        let reach = section.union(&section.moved(step * -1.0)).ok()?.region;
        let mut sum = 0.0;
        for number in first * steps..last * steps {
            let taken = self.groove.moved(step * number as f64).intersection(&reach).ok()?.region;
            let Some((low, _)) = taken.bounds() else { continue };
            // On a taper thread the radius is larger at the end of the step.
            let grows = if step.b > 0.0 { 1.0 + step.b / low.b } else { 1.0 };
            sum += taken.volume() * grows;
        }
        Some(sum / steps as f64)
    }
}
