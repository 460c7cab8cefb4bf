//! The holes of drilling cycles among the commands of a run.

use chordal::control::{DrilledHole, HoleMotion, PostedKind, PostedStep};
use chordal::geometry::Plane;
use chordal::{Command, CommandKind};

use super::places::PlacedCommand;

/// The steps of a program, each with the index of its first command: the commands, with those that drill a hole as one
/// step.
pub(super) fn steps_with_holes(
    placed: &[PlacedCommand],
    commands: &[Command],
) -> Vec<(PostedStep, usize)> {
    let mut steps = Vec::new();
    let mut plane = Plane::Xy;
    let mut at = 0;
    while let Some(one) = placed.get(at) {
        let origin = &commands[one.index].origin;
        if let PostedKind::Command(CommandKind::Plane(now)) = one.kind {
            plane = now;
        }
        let length = hole_length(&placed[at..], commands, plane);
        let hole = drilled_hole(&placed[at..at + length], plane);
        let kind = match hole {
            Some(hole) => {
                at += length;
                PostedKind::Hole(hole)
            }
            None => {
                at += 1;
                one.kind.clone()
            }
        };
        steps.push((PostedStep { kind, line: origin.line }, one.index));
    }
    steps
}

/// How many commands from here on drill along the normal of the plane in one block; 0 where none does.
fn hole_length(placed: &[PlacedCommand], commands: &[Command], plane: Plane) -> usize {
    let Some(first) = placed.first() else { return 0 };
    let span = commands[first.index].origin.span;
    let is_of_hole = |one: &&PlacedCommand| {
        let origin = &commands[one.index].origin;
        origin.cycle && origin.span == span && is_along_normal(&one.kind, plane)
    };
    let length = placed.iter().take_while(is_of_hole).count();
    // Holes of one block at the same place: each ends with a rapid before the next begins with a feed from the start.
    length
}

fn is_along_normal(kind: &PostedKind, plane: Plane) -> bool {
    let PostedKind::Command(command) = kind else { return false };
    match command {
        CommandKind::Rapid { motion, .. } | CommandKind::Line { motion, .. } => {
            let (_, _, normal) = plane.axes();
            (0..motion.to.len()).all(|axis| axis == normal || motion.from[axis] == motion.to[axis])
        }
        CommandKind::Dwell { .. } => true,
        _ => false,
    }
}

/// The hole of some commands; `None` where they are none that a cycle could make.
fn drilled_hole(placed: &[PlacedCommand], plane: Plane) -> Option<DrilledHole> {
    let (_, _, normal) = plane.axes();
    let command = |one: &PlacedCommand| match &one.kind {
        PostedKind::Command(command) => Some(command.clone()),
        PostedKind::MachineMove { .. } | PostedKind::Hole(_) => None,
    };
    let written_out: Vec<CommandKind> = placed.iter().map(command).collect::<Option<_>>()?;
    let motion = |command: &CommandKind| match command {
        CommandKind::Rapid { motion, .. } => Some(HoleMotion::Rapid(motion.to[normal])),
        CommandKind::Line { motion, feed } => {
            Some(HoleMotion::Cut { to_mm: motion.to[normal], feed: feed.value })
        }
        CommandKind::Dwell { seconds, .. } => Some(HoleMotion::Dwell(*seconds)),
        _ => None,
    };
    let motions: Vec<HoleMotion> = written_out.iter().map(motion).collect::<Option<_>>()?;
    let first_cut = written_out.iter().find_map(|command| match command {
        CommandKind::Line { motion, feed } => Some((motion, *feed)),
        _ => None,
    });
    let (first, feed) = first_cut?;
    let moves = || written_out.iter().filter_map(CommandKind::motion);
    let start_mm = first.from[normal];
    let is_down = first.to[normal] < start_mm;
    let levels = moves().map(|motion| motion.to[normal]);
    let bottom_mm = match is_down {
        true => levels.fold(f64::INFINITY, f64::min),
        false => levels.fold(f64::NEG_INFINITY, f64::max),
    };
    Some(DrilledHole {
        plane,
        initial_mm: moves().next()?.from[normal],
        start_mm,
        bottom_mm,
        retract_mm: moves().last()?.to[normal],
        feed,
        motions,
        written_out,
    })
}
