//! What the end of each move depends on: the work coordinate system or the machine.
//!
//! The program runs twice, with two sets of tables. A position that is the same in the work coordinate system is programmed
//! there; one that is the same on the machine is a position of the machine; any other depends on where the run began or on
//! the length of a tool, and cannot be written.

use chordal::control::{AxisMask, Move, Position, PostedKind};
use chordal::machine::AXES;
use chordal::{Command, CommandKind, Job};

use super::super::spiral;
use super::recorded::RecordedRun;

/// Positions that differ by less are the same, mm or rad.
const EQUAL: f64 = 1e-7;

/// A command whose positions are those of the work coordinate system or of the machine.
pub(super) struct PlacedCommand {
    pub kind: PostedKind,
    /// The command that it comes from.
    pub index: usize,
}

/// Why a command has no position that could be written.
pub(super) struct UnplacedCommand {
    pub index: usize,
    pub reason: String,
}

/// What lies between program, work and machine coordinates.
struct OffsetTracker {
    work: Position,
    system: Position,
    length: Position,
    /// Reference point 1, where runs begin.
    home: Position,
}

impl OffsetTracker {
    fn new(job: &Job) -> OffsetTracker {
        let (offset, _) = job.initial_offset();
        let home = job.machine().home.map(|place| place.unwrap_or(0.0));
        OffsetTracker { work: offset, system: offset, length: [0.0; AXES], home }
    }

    fn follow(&mut self, command: &CommandKind) {
        if let CommandKind::WorkOffset { offset, zero, .. } = command {
            (self.work, self.system) = (*offset, zero.system);
        }
        if let CommandKind::ToolLength { offset, .. } = command {
            self.length = *offset;
        }
    }

    fn shift(&self, axis: usize) -> f64 {
        self.work[axis] - self.system[axis]
    }

    fn in_system(&self, place: &Position) -> Position {
        std::array::from_fn(|axis| place[axis] + self.shift(axis))
    }

    fn on_machine(&self, place: &Position) -> Position {
        std::array::from_fn(|axis| place[axis] + self.work[axis] + self.length[axis])
    }
}

/// The machine positions of the tool's axis at which it turns round, in order.
pub(super) fn turns_of_tool_axis(job: &Job, run: &RecordedRun) -> Vec<f64> {
    const TOOL_AXIS: usize = 2;
    let mut offsets = OffsetTracker::new(job);
    let mut places: Vec<f64> = Vec::new();
    for command in &run.commands {
        offsets.follow(&command.kind);
        let Some(motion) = command.kind.motion() else { continue };
        if motion.from[TOOL_AXIS] == motion.to[TOOL_AXIS] {
            continue;
        }
        let place = offsets.on_machine(&motion.to)[TOOL_AXIS];
        if let [.., before, last] = places[..]
            && (last - before) * (place - last) >= 0.0
        {
            // It goes on in the same direction.
            places.pop();
        }
        places.push(place);
    }
    places
}

/// The commands of a run with their positions; `jobs` and `runs` are those of two sets of tables.
pub(super) fn placed_commands(
    jobs: [&Job; 2],
    runs: [&RecordedRun; 2],
    tolerance_mm: f64,
) -> Result<Vec<PlacedCommand>, UnplacedCommand> {
    let mut offsets = jobs.map(OffsetTracker::new);
    let mut placed = Vec::new();
    let mut has_cut = false;
    let [one, other] = runs.map(|run| run.commands.as_slice());
    for (index, command) in one.iter().enumerate() {
        let refuse = |reason: &str| UnplacedCommand { index, reason: reason.into() };
        let twin = other.get(index).filter(|twin| is_alike(command, twin));
        let twin = twin.ok_or_else(|| {
            refuse(
                "what the program does from here on depends on values of the tables of the machine",
            )
        })?;
        let pair = [command, twin];
        for (offsets, command) in offsets.iter_mut().zip(pair) {
            offsets.follow(&command.kind);
        }
        match place(&offsets, pair.map(|command| &command.kind)) {
            Ok(Some(PostedKind::Command(kind))) => {
                let pieces = in_pieces(kind, tolerance_mm);
                let kinds = pieces.into_iter().map(PostedKind::Command);
                placed.extend(kinds.map(|kind| PlacedCommand { kind, index }));
            }
            Ok(Some(kind)) => placed.push(PlacedCommand { kind, index }),
            Ok(None) if !has_cut && command.kind.feed().is_some() => {
                let kind = shown_in_full(command.kind.clone());
                placed.push(PlacedCommand { kind: PostedKind::Command(kind), index });
            }
            Ok(None) => {}
            Err(reason) => return Err(refuse(reason)),
        }
        has_cut |= command.kind.feed().is_some();
    }
    match other.len() > one.len() {
        true => Err(UnplacedCommand {
            index: one.len().saturating_sub(1),
            reason: "how long the program runs depends on values of the tables of the machine"
                .into(),
        }),
        false => Ok(placed),
    }
}

/// The first cut of a program, which moves nothing, as one that is written with all its words: the work offset of the first
/// cut is the frame of the run.
fn shown_in_full(mut kind: CommandKind) -> CommandKind {
    if let CommandKind::Line { motion, .. } = &mut kind {
        for axis in 0..3 {
            motion.from[axis] = motion.to[axis] + 1.0;
        }
    }
    kind
}

/// Whether two commands are of one kind and one block.
fn is_alike(one: &Command, other: &Command) -> bool {
    std::mem::discriminant(&one.kind) == std::mem::discriminant(&other.kind)
        && one.origin.span == other.origin.span
}

fn place(
    offsets: &[OffsetTracker; 2],
    kinds: [&CommandKind; 2],
) -> Result<Option<PostedKind>, &'static str> {
    let [Some(one), Some(other)] = kinds.map(CommandKind::motion) else {
        return Ok(Some(PostedKind::Command(kinds[0].clone())));
    };
    let moves = [one, other];
    let is_curve = kinds[0].shape().is_some();
    let [ends, machine] = [
        [0, 1].map(|run: usize| offsets[run].in_system(&moves[run].to)),
        [0, 1].map(|run: usize| offsets[run].on_machine(&moves[run].to)),
    ];
    let (mut of_work, mut of_machine) = (AxisMask::NONE, AxisMask::NONE);
    for axis in 0..AXES {
        if moves.iter().all(|motion| motion.from[axis] == motion.to[axis]) {
            continue;
        }
        let is_same = |places: [Position; 2]| (places[0][axis] - places[1][axis]).abs() < EQUAL;
        if is_same(ends) {
            of_work.insert(axis);
        } else if is_same(machine) || is_reference_point(offsets, &machine, axis) {
            of_machine.insert(axis);
        } else {
            return Err(
                "this move ends where nobody knows: it depends on where the program begins, or on the length of a tool, so give its axes an absolute position before",
            );
        }
    }
    if of_machine == AxisMask::NONE {
        if of_work == AxisMask::NONE && !is_curve {
            return Ok(None);
        }
        return in_system(offsets, kinds).map(|kind| Some(PostedKind::Command(kind)));
    }
    if of_work != AxisMask::NONE {
        return Err(
            "some axes of this move go to positions of the machine, and others of the part",
        );
    }
    match kinds[0].feed() {
        None => Ok(Some(PostedKind::MachineMove { place: machine[0], axes: of_machine })),
        Some(_) => Err("a cut to a position of the machine"),
    }
}

/// Whether both runs end at reference point 1, which is not the same in both.
fn is_reference_point(offsets: &[OffsetTracker; 2], places: &[Position; 2], axis: usize) -> bool {
    offsets
        .iter()
        .zip(places)
        .all(|(offsets, place)| (place[axis] - offsets.home[axis]).abs() < EQUAL)
}

/// A move in the work coordinate system.
fn in_system(
    offsets: &[OffsetTracker; 2],
    kinds: [&CommandKind; 2],
) -> Result<CommandKind, &'static str> {
    let moved = |motion: &Move| Move {
        from: offsets[0].in_system(&motion.from),
        to: offsets[0].in_system(&motion.to),
        from_known: AxisMask::ALL,
        to_known: AxisMask::ALL,
    };
    let mut kind = kinds[0].clone();
    if let CommandKind::Rapid { motion, .. }
    | CommandKind::Line { motion, .. }
    | CommandKind::Spline { motion, .. }
    | CommandKind::Arc { motion, .. }
    | CommandKind::Spiral { motion, .. } = &mut kind
    {
        *motion = moved(motion);
    }
    if let CommandKind::Arc { shape, .. } | CommandKind::Spiral { shape, .. } = &mut kind {
        let (a, b, _) = shape.plane.axes();
        let centers = [0, 1].map(|run: usize| {
            let center = kinds[run].shape().map_or([0.0; 2], |shape| shape.center);
            [center[0] + offsets[run].shift(a), center[1] + offsets[run].shift(b)]
        });
        let is_same = (0..2).all(|at| (centers[0][at] - centers[1][at]).abs() < EQUAL);
        if !is_same {
            return Err("the centre of this arc depends on where the program begins");
        }
        shape.center = centers[0];
    }
    Ok(kind)
}

/// Radii of an arc that differ by less are those of a circle, mm: every control allows that much.
const ROUND_MM: f64 = 1e-3;

/// Spirals and cones as arcs; other commands as they are.
fn in_pieces(kind: CommandKind, tolerance_mm: f64) -> Vec<CommandKind> {
    let (CommandKind::Arc { motion, shape, feed } | CommandKind::Spiral { motion, shape, feed }) =
        &kind
    else {
        return vec![kind];
    };
    if (shape.radius_to - shape.radius_from).abs() <= ROUND_MM.min(tolerance_mm) {
        return vec![CommandKind::Arc { motion: *motion, shape: *shape, feed: *feed }];
    }
    let pieces = spiral::as_arcs(motion, shape, ROUND_MM.min(tolerance_mm), tolerance_mm);
    let arc = |piece: spiral::SpiralPiece| CommandKind::Arc {
        motion: piece.motion,
        shape: piece.shape,
        feed: *feed,
    };
    pieces.into_iter().map(arc).collect()
}
