//! The holes of drilling cycles among the commands of a run.

use chordal::control::{DrilledHole, HoleMotion, PostedKind, PostedStep, SpindleState};
use chordal::geometry::Plane;
use chordal::{Command, CommandKind};

use super::places::{PlacedCommand, UnplacedCommand};
use super::taps;

/// The steps of a program, each with the index of its first command: the commands, with those that drill or tap a hole as
/// one step.
pub(super) fn steps_with_holes(
    placed: &[PlacedCommand],
    commands: &[Command],
) -> Result<Vec<(PostedStep, usize)>, UnplacedCommand> {
    let mut steps = Vec::new();
    let (mut plane, mut spindle) = (Plane::Xy, (SpindleState::Off, 0.0));
    let mut at = 0;
    while let Some(one) = placed.get(at) {
        let group = block_length(&placed[at..], commands);
        if let Some(tap) = taps::tap_of(&placed[at..at + group], plane, spindle) {
            let tap = tap.map_err(|reason| UnplacedCommand { index: one.index, reason })?;
            spindle = tap.spindle;
            let line = commands[one.index].origin.line;
            steps.push((PostedStep { kind: PostedKind::Tap(tap.hole), line }, one.index));
            at += tap.length;
            continue;
        }
        if let PostedKind::Command(CommandKind::Plane(now)) = one.kind {
            plane = now;
        }
        if let PostedKind::Command(CommandKind::Spindle { state, rpm }) = one.kind {
            spindle = (state, rpm);
        }
        let length = hole_length(&placed[at..at + group], plane);
        // What the spindle does in a hole is no part of a form that languages share.
        let goes_on =
            placed[at + length..at + group].first().is_some_and(|next| !moves(&next.kind));
        let length = if goes_on { 0 } else { length };
        let hole = drilled_hole(&placed[at..at + length], plane);
        let (kind, length) = match hole {
            Some(hole) => (PostedKind::Hole(hole), length),
            None => (one.kind.clone(), 1),
        };
        at += length;
        steps.push((PostedStep { kind, line: commands[one.index].origin.line }, one.index));
    }
    Ok(steps)
}

/// How many commands from here on a cycle of one block makes; 0 where none does.
fn block_length(placed: &[PlacedCommand], commands: &[Command]) -> usize {
    let Some(first) = placed.first() else { return 0 };
    let span = commands[first.index].origin.span;
    let is_of_block = |one: &&PlacedCommand| {
        let origin = &commands[one.index].origin;
        origin.cycle && origin.span == span
    };
    placed.iter().take_while(is_of_block).count()
}

/// How many of the commands of a cycle go along the normal of the plane.
fn hole_length(placed: &[PlacedCommand], plane: Plane) -> usize {
    placed.iter().take_while(|one| is_along_normal(&one.kind, plane)).count()
}

fn moves(kind: &PostedKind) -> bool {
    match kind {
        PostedKind::Command(command) => command.motion().is_some(),
        PostedKind::MachineMove { .. } | PostedKind::Hole(_) | PostedKind::Tap(_) => true,
    }
}

fn is_along_normal(kind: &PostedKind, plane: Plane) -> bool {
    let PostedKind::Command(command) = kind else { return false };
    if matches!(command, CommandKind::Dwell { .. }) {
        return true;
    }
    let (_, _, normal) = plane.axes();
    let is_straight = matches!(command, CommandKind::Rapid { .. } | CommandKind::Line { .. });
    let motion = command.motion().filter(|_| is_straight);
    motion.is_some_and(|motion| {
        (0..motion.to.len()).all(|axis| axis == normal || motion.from[axis] == motion.to[axis])
    })
}

/// The hole of some commands; `None` where they are none that a cycle could make.
fn drilled_hole(placed: &[PlacedCommand], plane: Plane) -> Option<DrilledHole> {
    let (_, _, normal) = plane.axes();
    let command = |one: &PlacedCommand| match &one.kind {
        PostedKind::Command(command) => Some(command.clone()),
        PostedKind::MachineMove { .. } | PostedKind::Hole(_) | PostedKind::Tap(_) => None,
    };
    let written_out: Vec<CommandKind> = placed.iter().map(command).collect::<Option<_>>()?;
    let motion = |command: &CommandKind| {
        if let CommandKind::Dwell { seconds, .. } = command {
            return Some(HoleMotion::Dwell(*seconds));
        }
        let to_mm = command.motion()?.to[normal];
        Some(match command.feed() {
            Some(feed) => HoleMotion::Cut { to_mm, feed: feed.value },
            None => HoleMotion::Rapid(to_mm),
        })
    };
    let motions: Vec<HoleMotion> = written_out.iter().map(motion).collect::<Option<_>>()?;
    let first_cut =
        written_out.iter().find_map(|command| Some((command.motion()?, *command.feed()?)));
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
        retract_mm: moves().next_back()?.to[normal],
        feed,
        motions,
        written_out,
    })
}
