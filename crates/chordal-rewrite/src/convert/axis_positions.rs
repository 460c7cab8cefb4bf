//! Programs that give the tip of the tool, written for a machine whose axes are programmed: tool centre point control and
//! tilted planes become the moves that the control makes of them.

use std::collections::BTreeSet;

use chordal::control::{ArcShape, Feed, FeedAlong, FeedMode, Move, Position, RapidPath};
use chordal::geometry::{Arc, Curve, ParamCurve, Plane, Vec3};
use chordal::machine::{KinematicChain, StartingKinematics};
use chordal::path::{AxisMoves, AxisMovesError, TimedAxisPiece};
use chordal::{Command, CommandKind, Job, Machine};
use chordal_compare::ComparedAxes;

use super::trace::ProgramTrace;
use super::{ConversionOptions, ConvertRefusal};

/// The share of the tolerance by which chords of the axes may leave the path; the rest is for the rounding of words.
const CHORD_SHARE: f64 = 0.5;

/// An arc lies in a main plane if its axis is parallel to a machine axis within this, rad.
const PARALLEL_RAD: f64 = 1e-9;

/// Angles at which two machines are asked for the direction of the tool, rad.
const TRIAL_ANGLES: [[f64; 3]; 4] =
    [[0.0, 0.0, 0.0], [0.7, 0.0, 0.0], [0.7, 1.1, 0.0], [0.7, 1.1, -0.4]];

/// The axes that the new program gives where the old one gives the tip; `None` where it does not, or where the new program
/// keeps doing so.
pub(super) fn compared_axes(
    trace: &ProgramTrace,
    [old, new]: [&Machine; 2],
    options: &ConversionOptions,
) -> Option<ComparedAxes> {
    let has_tip =
        trace.commands.iter().any(|command| matches!(command.kind, CommandKind::PartFrame { .. }));
    let chains = [old, new].map(chain_of);
    let keeps = old.control == new.control && chains[0] == chains[1] && !options.axis_positions;
    let tolerance_mm = options.tolerance_mm * CHORD_SHARE;
    (has_tip && !keeps).then_some(ComparedAxes { chain: chains[1], tolerance_mm })
}

/// The lines that switch the kinematics of a LinuxCNC to the axes, and wait until they are switched (switchkins).
pub(super) const SWITCH_TO_AXES: [&str; 2] = ["M68 E3 Q1", "M66 E0 L0"];

/// Whether the new program must switch the kinematics of its machine to the axes before it gives them.
pub(super) fn switches_to_axes([old, new]: [&Machine; 2], writes_axes: bool) -> bool {
    begins_with_tip(new) && (writes_axes || !begins_with_tip(old))
}

/// Whether the kinematics of a machine follow the tip where a program begins.
pub(super) fn begins_with_tip(machine: &Machine) -> bool {
    machine.starting_kinematics == Some(StartingKinematics::Tip)
}

/// The rotary axes of a machine; `None` where it has none, or they are not known.
fn chain_of(machine: &Machine) -> Option<KinematicChain> {
    machine.kinematic_chain().ok().filter(|chain| !chain.joints().is_empty())
}

/// Writes the moves of the axes into a trace in place of those of the tip; what cannot be written.
pub(super) fn write_axes(
    trace: &mut ProgramTrace,
    old: &Job,
    target: &Machine,
    axes: &ComparedAxes,
) -> Vec<ConvertRefusal> {
    if let Some(refusal) = other_angles(chain_of(old.machine()), axes.chain) {
        return vec![ConvertRefusal::of_program(refusal)];
    }
    let frame = old.path_builder().frame().clone();
    let mut writer = AxisWriter {
        moves: AxisMoves::new(frame, axes.chain, axes.tolerance_mm),
        tolerance_mm: axes.tolerance_mm,
        mode: None,
        commands: Vec::with_capacity(trace.commands.len()),
        unknown_kinematics: target.kinematic_chain().err().map(|error| error.to_string()),
        refused: BTreeSet::new(),
        refusals: Vec::new(),
    };
    let turns = first_moves(trace, &writer.moves);
    for (index, exec) in trace.execs.iter_mut().enumerate() {
        let begin = writer.commands.len();
        for command in &trace.commands[exec.commands.clone()] {
            writer.command(command, old);
        }
        // A block that keeps its words does not say in which mode its feed is.
        if turns[index + 1..].iter().flatten().next() != Some(&true) {
            writer.restore_mode();
        }
        exec.commands = begin..writer.commands.len();
    }
    trace.commands = writer.commands;
    writer.refusals
}

/// Whether the first move of each execution of a block turns rotary axes in a frame of the part; `None` without a move.
fn first_moves(trace: &ProgramTrace, moves: &AxisMoves) -> Vec<Option<bool>> {
    let mut moves = moves.clone();
    let first = |exec: &super::trace::BlockExecution| {
        let mut found = None;
        for command in trace.commands_of(exec) {
            if moves.follow(command) || found.is_some() {
                continue;
            }
            let motion = command.kind.motion();
            found = motion.map(|motion| {
                moves.is_on_part() && turned(motion) && command.kind.feed().is_some()
            });
        }
        found
    };
    trace.execs.iter().map(first).collect()
}

fn turned(motion: &Move) -> bool {
    motion.from[3..] != motion.to[3..]
}

/// Why the angles of one machine are not those of the other one.
fn other_angles(old: Option<KinematicChain>, new: Option<KinematicChain>) -> Option<String> {
    let (old, new) = (old?, new?);
    let same = TRIAL_ANGLES
        .iter()
        .all(|angles| old.direction(angles).distance(new.direction(angles)) < PARALLEL_RAD);
    (!same).then(|| "the rotary axes of the new machine turn the tool in another way".into())
}

/// Makes the commands of the axes.
struct AxisWriter {
    moves: AxisMoves,
    tolerance_mm: f64,
    /// The mode of the feed that the program has before a cut of the axes in inverse time; `None` without one.
    mode: Option<FeedMode>,
    commands: Vec<Command>,
    /// What the machine file of the new machine does not say of its rotary axes.
    unknown_kinematics: Option<String>,
    /// Lines that are refused already.
    refused: BTreeSet<u32>,
    refusals: Vec<ConvertRefusal>,
}

impl AxisWriter {
    fn command(&mut self, command: &Command, old: &Job) {
        if self.moves.follow(command) {
            if !matches!(command.kind, CommandKind::PartFrame { .. }) {
                self.commands.push(command.clone());
            }
            return;
        }
        let Some(motion) = command.kind.motion() else {
            return self.commands.push(command.clone());
        };
        match self.moves.pieces(&command.kind, motion) {
            Ok(None) => self.commands.push(command.clone()),
            Ok(Some(pieces)) => {
                for timed in pieces {
                    self.piece(command, motion, &timed);
                }
            }
            Err(error) => self.refuse(command, error, old),
        }
    }

    fn refuse(&mut self, command: &Command, error: AxisMovesError, old: &Job) {
        let line = command.origin.line;
        if !self.refused.insert(line) {
            return;
        }
        let source = old.sources().get(command.origin.span.file);
        let words = source.map(|source| String::from_utf8_lossy(source.line_text(line)));
        self.refusals.push(ConvertRefusal {
            line,
            words: words.unwrap_or_default().trim().to_string(),
            reason: match (&self.unknown_kinematics, error) {
                (Some(missing), AxisMovesError::UnknownKinematics) => {
                    format!("where the axes of the new machine are is not known: {missing}")
                }
                _ => error.to_string(),
            },
        });
    }

    /// A piece of the path of the axes as commands.
    fn piece(&mut self, command: &Command, motion: &Move, timed: &TimedAxisPiece) {
        let piece = &timed.piece;
        let [from, to] =
            [(piece.curve.start(), piece.rotary_from), (piece.curve.end(), piece.rotary_to)]
                .map(|(place, rotary)| position(place, rotary));
        let moved = Move { from, to, ..*motion };
        let Some(feed) = command.kind.feed() else {
            let kind = CommandKind::Rapid { motion: moved, path: RapidPath::Straight };
            return self.push(command, kind);
        };
        let turns = turned(&moved);
        let feed = match turns && timed.duration_s > 0.0 && feed.mode != FeedMode::InverseTime {
            true => {
                self.inverse_time(command, feed.mode);
                let value = timed.duration_s.recip();
                Feed { value, mode: FeedMode::InverseTime, along: FeedAlong::Path, ..*feed }
            }
            false if feed.mode == FeedMode::InverseTime && timed.duration_s > 0.0 => {
                Feed { value: timed.duration_s.recip(), ..*feed }
            }
            false => {
                self.restore_mode();
                *feed
            }
        };
        match arc_shape(&piece.curve) {
            Some(shape) => {
                self.push(command, CommandKind::Plane(shape.plane));
                self.push(command, CommandKind::Arc { motion: moved, shape, feed });
            }
            None => {
                let lines = chords(&piece.curve, self.tolerance_mm);
                let mut from = moved.from;
                for place in lines {
                    let to = position(place, piece.rotary_to);
                    let motion = Move { from, to, ..moved };
                    self.push(command, CommandKind::Line { motion, feed });
                    from = to;
                }
            }
        }
    }

    fn push(&mut self, command: &Command, kind: CommandKind) {
        self.commands.push(Command { kind, ..command.clone() });
    }

    fn inverse_time(&mut self, command: &Command, programmed: FeedMode) {
        if self.mode.is_none() {
            self.push(command, CommandKind::FeedMode(FeedMode::InverseTime));
            self.mode = Some(programmed);
        }
    }

    /// The mode of the feed that the program has.
    fn restore_mode(&mut self) {
        let Some(last) = self.commands.last().cloned() else { return };
        if let Some(mode) = self.mode.take() {
            self.push(&last, CommandKind::FeedMode(mode));
        }
    }
}

fn position(place: Vec3, [a, b, c]: [f64; 3]) -> Position {
    [place.x, place.y, place.z, a, b, c]
}

/// The shape of an arc in a main plane; `None` for other curves, and for arcs in other planes.
fn arc_shape(curve: &Curve) -> Option<ArcShape> {
    let Curve::Arc(arc) = curve else { return None };
    [Plane::Xy, Plane::Zx, Plane::Yz].into_iter().find_map(|plane| shape_in(plane, arc))
}

fn shape_in(plane: Plane, arc: &Arc) -> Option<ArcShape> {
    let (a, b, _) = plane.axes();
    let units = [Vec3::X, Vec3::Y, Vec3::Z];
    let along = arc.w.dot(units[a].cross(units[b]));
    let is_parallel = (along.abs() - 1.0).abs() < PARALLEL_RAD;
    is_parallel.then(|| ArcShape {
        plane,
        center: [arc.center.component(a), arc.center.component(b)],
        sweep: arc.sweep * along.signum(),
        radius_from: arc.radius,
        radius_to: arc.radius,
    })
}

/// The ends of the chords of a curve that stay within a tolerance of it.
fn chords(curve: &Curve, tolerance_mm: f64) -> Vec<Vec3> {
    let length = curve.length();
    let count = match curve {
        Curve::Line(_) => 1,
        // A chord of length s leaves a curve of curvature k by no more than k s² / 8.
        curve => {
            let longest = (8.0 * tolerance_mm.max(1e-6) / curve.max_curvature().max(1e-12)).sqrt();
            (length / longest).ceil().clamp(1.0, MAX_CHORDS) as u32
        }
    };
    let inner = (1..count).map(|at| curve.point_at(length * f64::from(at) / f64::from(count)));
    inner.chain([curve.end()]).collect()
}

/// Chords of one curve at most.
const MAX_CHORDS: f64 = 100_000.0;
