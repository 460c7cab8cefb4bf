//! Approaches along the path of the tool centre, written again with compensation.
//!
//! APPR leads the centre of the tool to the contour, and compensation begins there with a line as long as the radius. Other
//! controls refuse a lead-in that is no longer than the radius: for them compensation begins with the line before, and the
//! last element of the approach is that of a contour.

use chordal::CommandKind;
use chordal::control::{ArcShape, CompensationSide, Move, Position, PostedKind, PostedProgram};
use chordal::geometry::{Plane, Vec2};

/// Lengths that differ by less are the same, mm.
const EQUAL_MM: f64 = 1e-4;

/// Directions whose angle is nearer to a right angle, or to a straight one, are rounding.
const EQUAL_DIRECTION: f64 = 1e-4;

/// A lead-in is longer than the radius by this share of it at least.
const LEAD_MARGIN: f64 = 0.01;

/// How an approach is written with compensation.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum LeadForm {
    /// The last element is one of the contour, where it goes along it.
    AlongContour,
    /// The last element is the lead-in, if it is a line.
    LastElement,
}

impl LeadForm {
    /// The forms, the better one first.
    pub const ALL: [LeadForm; 2] = [LeadForm::AlongContour, LeadForm::LastElement];
}

/// A program whose approaches are parts of compensated contours.
pub(super) struct LongerLeads {
    /// The program, step by step as before.
    pub program: PostedProgram,
    /// The steps at which compensation began.
    pub steps: Vec<usize>,
}

impl LongerLeads {
    /// `None` where no approach can be written so.
    pub fn of(program: &PostedProgram, form: LeadForm) -> Option<LongerLeads> {
        let mut found = LongerLeads { program: program.clone(), steps: Vec::new() };
        for at in 0..program.steps.len() {
            let Some(approach) = CenterApproach::at(program, at) else { continue };
            if approach.replace(&mut found.program, form) {
                found.steps.push(at);
            }
        }
        (!found.steps.is_empty()).then_some(found)
    }
}

/// The steps at which compensation begins where the centre is as far from the contour as the radius.
pub(super) fn center_approaches(program: &PostedProgram) -> Vec<usize> {
    let steps = 0..program.steps.len();
    steps.filter(|step| CenterApproach::at(program, *step).is_some()).collect()
}

/// An approach, by the steps of its moves.
struct CenterApproach<'p> {
    program: &'p PostedProgram,
    /// The step that switches compensation on.
    switch: usize,
    /// The line from the centre to the contour.
    lead: usize,
    /// The last element on the path of the centre.
    element: usize,
    /// From the centre to the contour, mm: as long as the radius.
    across: Vec2,
}

impl<'p> CenterApproach<'p> {
    fn at(program: &'p PostedProgram, switch: usize) -> Option<CenterApproach<'p>> {
        let PostedKind::Command(CommandKind::Compensation {
            side: CompensationSide::Left | CompensationSide::Right,
            radius_mm: Some(radius),
            ..
        }) = &program.steps[switch].kind
        else {
            return None;
        };
        let lead = next_move(program, switch + 1)?;
        let element = move_before(program, switch)?;
        let PostedKind::Command(CommandKind::Line { motion, .. }) = &program.steps[lead].kind
        else {
            return None;
        };
        let across = between(motion.from, motion.to);
        let is_lead = is_flat(motion) && (across.length() - radius.abs()).abs() < EQUAL_MM;
        (is_lead && *radius > EQUAL_MM).then_some(CenterApproach {
            program,
            switch,
            lead,
            element,
            across,
        })
    }

    fn command(&self, step: usize) -> Option<&'p CommandKind> {
        match &self.program.steps[step].kind {
            PostedKind::Command(command) => Some(command),
            PostedKind::MachineMove { .. } | PostedKind::Hole(_) | PostedKind::Tap(_) => None,
        }
    }

    /// Puts the approach with compensation in its place; false where it cannot be written so.
    fn replace(&self, program: &mut PostedProgram, form: LeadForm) -> bool {
        let moves = match form {
            LeadForm::AlongContour => self.along_contour().or_else(|| self.last_element()),
            LeadForm::LastElement => self.last_element().or_else(|| self.along_contour()),
        };
        let Some(moves) = moves else { return false };
        let switch = program.steps[self.switch].kind.clone();
        let kinds = std::iter::once(switch)
            .chain(moves.commands.into_iter().map(PostedKind::Command))
            .chain(std::iter::once(PostedKind::Command(CommandKind::Idle)));
        let places = moves.places.into_iter().chain([self.switch, self.lead]);
        for (place, kind) in places.zip(kinds) {
            program.steps[place].kind = kind;
        }
        true
    }

    /// The last element, a line, and the lead-in are one line: the centre ends at the same place.
    fn last_element(&self) -> Option<ReplacedMoves> {
        let element = self.command(self.element)?;
        let CommandKind::Line { motion, .. } = element else { return None };
        let to = self.command(self.lead)?.motion()?.to;
        let whole = Move { to, ..*motion };
        (self.is_long(&whole) && is_flat(motion)).then(|| ReplacedMoves {
            places: vec![self.element],
            commands: vec![moved_to(element, whole)],
        })
    }

    /// Longer than the radius.
    fn is_long(&self, lead: &Move) -> bool {
        between(lead.from, lead.to).length() > self.across.length() * (1.0 + LEAD_MARGIN)
    }

    /// The last element goes along the contour: compensation begins with the line before it.
    fn along_contour(&self) -> Option<ReplacedMoves> {
        let element = self.command(self.element)?;
        let first = move_before(self.program, self.element)?;
        let start = self.command(first)?;
        let is_straight = matches!(start, CommandKind::Line { .. } | CommandKind::Rapid { .. });
        let along = element.motion().filter(|motion| is_flat(motion))?;
        let contour = if let CommandKind::Arc { shape, feed, .. } = element {
            let (motion, shape) = self.widened_arc(along, shape)?;
            CommandKind::Arc { motion, shape, feed: *feed }
        } else if matches!(element, CommandKind::Line { .. }) {
            moved_to(element, self.shifted_line(along)?)
        } else {
            return None;
        };
        let mut lead = *start.motion()?;
        lead.to[..2].copy_from_slice(&contour.motion()?.from[..2]);
        (is_straight && self.is_long(&lead)).then(|| ReplacedMoves {
            places: vec![first, self.element],
            commands: vec![moved_to(start, lead), contour],
        })
    }

    /// A line of the centre along the contour, moved to the contour.
    fn shifted_line(&self, motion: &Move) -> Option<Move> {
        let direction = unit(between(motion.from, motion.to))?;
        let is_across = direction.dot(unit(self.across)?).abs() < EQUAL_DIRECTION;
        let mut moved = *motion;
        for (axis, by) in self.across.to_array().into_iter().enumerate() {
            moved.from[axis] += by;
            moved.to[axis] += by;
        }
        is_across.then_some(moved)
    }

    /// An arc of the centre that ends along the contour, with the radius of the contour.
    fn widened_arc(&self, motion: &Move, shape: &ArcShape) -> Option<(Move, ArcShape)> {
        if shape.plane != Plane::Xy {
            return None;
        }
        let spoke = Vec2::new(motion.to[0], motion.to[1]) - Vec2::from_array(shape.center);
        let outward = unit(spoke)?.dot(unit(self.across)?);
        let radius = shape.radius_to + outward.signum() * self.across.length();
        if (outward.abs() - 1.0).abs() > EQUAL_DIRECTION || radius < EQUAL_MM {
            return None;
        }
        let widened = |place: f64, axis: usize| {
            shape.center[axis] + (place - shape.center[axis]) * radius / shape.radius_to
        };
        let mut moved = *motion;
        for (axis, by) in self.across.to_array().into_iter().enumerate() {
            moved.from[axis] = widened(motion.from[axis], axis);
            moved.to[axis] = motion.to[axis] + by;
        }
        Some((moved, ArcShape { radius_from: radius, radius_to: radius, ..*shape }))
    }
}

/// The moves of an approach with compensation: each command goes to the place after its own, the first place gets the switch.
struct ReplacedMoves {
    places: Vec<usize>,
    commands: Vec<CommandKind>,
}

/// A straight command with another move.
fn moved_to(command: &CommandKind, to: Move) -> CommandKind {
    let mut moved = command.clone();
    if let CommandKind::Line { motion, .. } | CommandKind::Rapid { motion, .. } = &mut moved {
        *motion = to;
    }
    moved
}

/// The next step that moves, if nothing but commands that do not move compensation is between.
fn next_move(program: &PostedProgram, from: usize) -> Option<usize> {
    let steps = program.steps.get(from..)?;
    steps.iter().position(|step| !is_passed(&step.kind)).map(|place| from + place)
}

/// The last step before another one that moves.
fn move_before(program: &PostedProgram, step: usize) -> Option<usize> {
    program.steps.get(..step)?.iter().rposition(|step| !is_passed(&step.kind))
}

/// A command that does not matter to where the tool goes.
fn is_passed(kind: &PostedKind) -> bool {
    matches!(
        kind,
        PostedKind::Command(
            CommandKind::Idle
                | CommandKind::FeedRate { .. }
                | CommandKind::Message(_)
                | CommandKind::Plane(_)
                | CommandKind::Coolant(_)
                | CommandKind::Spindle { .. }
        )
    )
}

fn is_flat(motion: &Move) -> bool {
    (2..motion.to.len()).all(|axis| motion.from[axis] == motion.to[axis])
}

/// From one place to another in the plane XY.
fn between(from: Position, to: Position) -> Vec2 {
    Vec2::new(to[0] - from[0], to[1] - from[1])
}

fn unit(vector: Vec2) -> Option<Vec2> {
    let length = vector.length();
    (length > EQUAL_MM).then(|| vector * (1.0 / length))
}
