//! Records what a program does, for comparison with another program.

use chordal::control::{Command, CommandKind, Feed};
use chordal::{PathCommand, RunWatch, Segment, SegmentKind};
use chordal_compare::Category;

use super::distance::{DistanceBounds, PathCurve, distance};

/// The recorded run of a program.
#[derive(Debug, Default)]
pub struct RunMotion {
    moves: Vec<ToolMove>,
    /// Spindle commands, each with the number of moves before it.
    speeds: Vec<(usize, String)>,
    /// Other functions, each with the number of moves before it.
    pub functions: Vec<(usize, String)>,
    /// The time without acceleration: lengths divided by feeds, plus waits, s.
    pub time_s: f64,
}

/// A move of the tool centre.
#[derive(Clone, Copy, Debug)]
struct ToolMove {
    piece: PathCurve,
    rotary: ([f64; 3], [f64; 3]),
    feed: Option<Feed>,
    known: bool,
    line: u32,
}

impl ToolMove {
    fn is(&self, other: &ToolMove) -> bool {
        self.piece == other.piece && self.rotary == other.rotary && self.known == other.known
    }

    fn has_feed_of(&self, other: &ToolMove) -> bool {
        let bits = |feed: &Option<Feed>| {
            feed.as_ref().map(|feed| {
                let numbers = (feed.value.to_bits(), feed.spindle_rev_per_s.to_bits());
                (numbers, feed.mode, feed.along)
            })
        };
        bits(&self.feed) == bits(&other.feed)
    }

    fn turns(&self) -> bool {
        self.rotary.0 != self.rotary.1
    }
}

impl RunWatch for RunMotion {
    fn path(&mut self, path: PathCommand<'_>, segments: &[Segment]) {
        self.note(path.command);
        for segment in segments {
            self.moves.push(ToolMove {
                piece: PathCurve {
                    is_rapid: segment.kind == SegmentKind::Rapid,
                    curve: segment.curve,
                },
                rotary: (segment.rotary_from, segment.rotary_to),
                feed: path.command.kind.feed().copied(),
                known: segment.known,
                line: segment.origin.line,
            });
        }
    }
}

impl RunMotion {
    fn note(&mut self, command: &Command) {
        let at = self.moves.len();
        match Category::of(&command.kind) {
            // Moves are compared directly, and messages to the operator do not count as functions.
            None | Some(Category::Path | Category::Message) => {}
            Some(Category::Spindle) => self.speeds.push((at, format!("{:?}", command.kind))),
            Some(_) => self.functions.push((at, function(&command.kind))),
        }
    }

    /// The lines of the first moves that differ; `None` when all moves are equal.
    pub fn first_other(&self, other: &RunMotion) -> Option<(u32, u32)> {
        self.first_where(other, |a, b| !a.is(b))
    }

    /// The lines of the first moves whose feeds differ; `None` when all feeds are equal.
    pub fn first_other_feed(&self, other: &RunMotion) -> Option<(u32, u32)> {
        self.first_where(other, |a, b| !a.has_feed_of(b))
    }

    /// Whether all moves, as far as both runs have them, have equal feeds, and the spindle commands are equal.
    pub fn has_feeds_of(&self, other: &RunMotion) -> bool {
        let mut both = self.moves.iter().zip(&other.moves);
        both.all(|(a, b)| a.has_feed_of(b)) && self.speeds == other.speeds
    }

    fn first_where(
        &self,
        other: &RunMotion,
        differ: impl Fn(&ToolMove, &ToolMove) -> bool,
    ) -> Option<(u32, u32)> {
        let common = self.moves.len().min(other.moves.len());
        let at = (0..common)
            .find(|at| differ(&self.moves[*at], &other.moves[*at]))
            .or_else(|| (self.moves.len() != other.moves.len()).then_some(common))?;
        let line =
            |moves: &[ToolMove]| moves.get(at).or(moves.last()).map_or(0, |moved| moved.line);
        Some((line(&self.moves), line(&other.moves)))
    }

    /// The distance between the paths; `None` when a rotary axis moves, the position of a cut is unknown, or only one
    /// of the two has cuts or rapids.
    pub fn distance_to(&self, other: &RunMotion, tolerance_mm: f64) -> Option<DistanceBounds> {
        let has_place = |motion: &RunMotion| {
            motion.moves.iter().all(|moved| !moved.turns() && (moved.known || moved.piece.is_rapid))
        };
        if !(has_place(self) && has_place(other)) {
            return None;
        }
        let of = |motion: &RunMotion, rapid: bool| -> Vec<PathCurve> {
            let moves = motion.moves.iter().filter(|moved| moved.known);
            moves.map(|moved| moved.piece).filter(|piece| piece.is_rapid == rapid).collect()
        };
        let cuts = distance(&of(self, false), &of(other, false), tolerance_mm)?;
        let rapids = distance(&of(self, true), &of(other, true), tolerance_mm)?;
        Some(cuts.or(rapids))
    }
}

fn function(kind: &CommandKind) -> String {
    match kind {
        // The values of offsets are in the tables of the control; the program only selects them.
        CommandKind::WorkOffset { name, .. } => format!("{name:?}"),
        CommandKind::Compensation { side, number, .. } => format!("{side:?} {number:?}"),
        kind => format!("{kind:?}"),
    }
}
