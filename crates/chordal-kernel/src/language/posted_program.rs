//! A program as what its run does: the form in which a program goes from one language to another.

use chordal_command::{AxisMask, CommandKind, Feed, FeedMode, Position, SpindleState, Units};
use chordal_geometry::Plane;

/// What a program does, in order, in no language. Positions are those of the work coordinate system: shifts and frames of
/// the program are in them.
#[derive(Clone, Debug)]
pub struct PostedProgram {
    /// Its number; `None` when it has a name or nothing.
    pub number: Option<u32>,
    /// Its name as the old language writes it; `None` without one.
    pub name: Option<String>,
    /// What is active at its first step.
    pub start: StartingModes,
    /// Its steps.
    pub steps: Vec<PostedStep>,
}

impl PostedProgram {
    /// Whether the change to a tool comes after a step before anything moves.
    pub fn changes_tool_next(&self, step: usize, tool: u32) -> bool {
        let rest = self.steps.get(step + 1..).unwrap_or_default();
        let first = rest.iter().find(|step| match &step.kind {
            PostedKind::Command(CommandKind::Tool { .. }) => true,
            PostedKind::Command(command) => command.motion().is_some(),
            PostedKind::MachineMove { .. } | PostedKind::Hole(_) | PostedKind::Tap(_) => true,
        });
        first.is_some_and(|step| {
            matches!(step.kind, PostedKind::Command(CommandKind::Tool { number }) if number == tool)
        })
    }
}

/// What is active at the first step of a program.
#[derive(Clone, Copy, Debug)]
pub struct StartingModes {
    /// The units of its words.
    pub units: Units,
    /// The plane of arcs.
    pub plane: Plane,
    /// What F counts.
    pub feed_mode: FeedMode,
    /// The work coordinate system by its number, which all controls share
    /// ([`WorkName::ordinal`](chordal_command::WorkName::ordinal)).
    pub work: u32,
}

/// One thing that a program does.
#[derive(Clone, Debug)]
pub struct PostedStep {
    /// What it does.
    pub kind: PostedKind,
    /// The line of its block in the text, from 1.
    pub line: u32,
}

/// What a step does.
#[derive(Clone, Debug)]
pub enum PostedKind {
    /// A command. Moves go to positions of the work coordinate system.
    Command(CommandKind),
    /// A rapid of these axes to positions of the machine, mm and rad.
    MachineMove {
        /// The positions.
        place: Position,
        /// The axes that move.
        axes: AxisMask,
    },
    /// A hole below the tool.
    Hole(DrilledHole),
    /// A thread below the tool.
    Tap(TappedHole),
}

/// A thread that a tapping cycle cuts along the normal of the plane, in and out at one lead.
#[derive(Clone, PartialEq, Debug)]
pub struct TappedHole {
    /// The plane.
    pub plane: Plane,
    /// Where the tap begins and ends.
    pub start: Position,
    /// The bottom, mm along the normal.
    pub bottom_mm: f64,
    /// The feed.
    pub feed: Feed,
    /// The speed of the spindle on the way in, rev/min.
    pub rpm: f64,
    /// How much faster than in it goes out; the spindle with it.
    pub out_factor: f64,
    /// The thread is left-handed.
    pub is_left: bool,
    /// The dwell at the bottom, s.
    pub dwell_s: f64,
    /// The spindle before it and after it.
    pub spindle: [SpindleState; 2],
}

impl TappedHole {
    /// The lead of the thread, mm; `None` where nothing gives it.
    pub fn lead_mm(&self) -> Option<f64> {
        let lead = match self.feed.mode {
            FeedMode::PerRevolution => self.feed.value,
            FeedMode::PerTime => self.feed.value * 60.0 / self.rpm,
            FeedMode::InverseTime => return None,
        };
        (lead.is_finite() && lead > 0.0).then_some(lead)
    }
}

/// A hole drilled by a cycle, along the normal of the plane.
#[derive(Clone, PartialEq, Debug)]
pub struct DrilledHole {
    /// The plane.
    pub plane: Plane,
    /// Where the tool is before it: mm along the normal.
    pub initial_mm: f64,
    /// Where the first feed begins.
    pub start_mm: f64,
    /// The bottom.
    pub bottom_mm: f64,
    /// Where the tool is at its end.
    pub retract_mm: f64,
    /// The feed of its first cut.
    pub feed: Feed,
    /// The steps from `initial_mm` on, with their levels.
    pub motions: Vec<HoleMotion>,
    /// The same as commands.
    pub written_out: Vec<CommandKind>,
}

/// A step of a hole; levels are mm along the normal.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum HoleMotion {
    /// A rapid to a level.
    Rapid(f64),
    /// A cut to a level.
    Cut {
        /// The level.
        to_mm: f64,
        /// F, in the unit of the feed mode.
        feed: f64,
    },
    /// A dwell, s.
    Dwell(f64),
}

/// What a hole is, beyond its levels.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum HoleForm {
    /// Down at the feed, a dwell (0 for none), up at rapid.
    Drilled {
        /// s.
        dwell_s: f64,
    },
    /// Down at the feed, a dwell (0 for none), up at a feed.
    FedOut {
        /// s.
        dwell_s: f64,
        /// F on the way up, in the unit of the feed mode.
        feed_out: f64,
    },
    /// Down in steps.
    Pecked {
        /// Out to the start after each step; otherwise only as far as `back_mm`.
        is_full: bool,
        /// The depth of the first step, mm.
        first_mm: f64,
        /// After a full return: how far above the last depth the feed begins. Otherwise the lift, mm.
        back_mm: f64,
        /// The dwell at the bottom of each step, s.
        dwell_s: f64,
    },
}

/// Levels and times that differ by less are the same, mm or s.
const EQUAL: f64 = 1e-6;

/// Whether two levels, mm, or two times, s, are the same within rounding.
pub fn is_same_level(one: f64, other: f64) -> bool {
    (one - other).abs() < EQUAL
}

impl DrilledHole {
    /// What the hole is; `None` where it is none of the forms that languages share.
    pub fn form(&self) -> Option<HoleForm> {
        let mut motions = self.motions_from_start();
        if let [rest @ .., HoleMotion::Rapid(level)] = motions
            && is_same_level(*level, self.retract_mm)
        {
            motions = rest;
        }
        let (cuts, dwell_s) = match motions {
            [rest @ .., HoleMotion::Dwell(seconds)] => (rest, *seconds),
            rest => (rest, 0.0),
        };
        match (cuts, motions) {
            ([HoleMotion::Cut { .. }], _) => Some(HoleForm::Drilled { dwell_s }),
            (_, [HoleMotion::Cut { .. }, HoleMotion::Cut { to_mm, feed }]) => {
                self.fed_out(*to_mm, *feed, 0.0)
            }
            (
                _,
                [HoleMotion::Cut { .. }, HoleMotion::Dwell(dwell), HoleMotion::Cut { to_mm, feed }],
            ) => self.fed_out(*to_mm, *feed, *dwell),
            _ => self.pecked(motions),
        }
    }

    fn fed_out(&self, to_mm: f64, feed_out: f64, dwell_s: f64) -> Option<HoleForm> {
        is_same_level(to_mm, self.start_mm).then_some(HoleForm::FedOut { dwell_s, feed_out })
    }

    /// Steps with the same return and the same dwell after each.
    fn pecked(&self, motions: &[HoleMotion]) -> Option<HoleForm> {
        let dwell_s = match motions.get(1)? {
            HoleMotion::Dwell(seconds) => *seconds,
            _ => 0.0,
        };
        let after = usize::from(dwell_s > 0.0);
        let (HoleMotion::Cut { to_mm: first, .. }, HoleMotion::Rapid(up)) =
            (motions.first()?, motions.get(1 + after)?)
        else {
            return None;
        };
        let is_full = matches!(motions.get(2 + after)?, HoleMotion::Rapid(_));
        let reentry = match motions.get(2 + after)? {
            HoleMotion::Rapid(level) => level,
            _ => up,
        };
        if is_full && !is_same_level(*up, self.start_mm) {
            return None;
        }
        Some(HoleForm::Pecked {
            is_full,
            first_mm: (self.start_mm - first).abs(),
            back_mm: (reentry - first).abs(),
            dwell_s,
        })
    }

    /// The steps without the rapid to where the first feed begins.
    fn motions_from_start(&self) -> &[HoleMotion] {
        match self.motions.as_slice() {
            [HoleMotion::Rapid(_), rest @ ..] => rest,
            all => all,
        }
    }

    /// Whether another hole is drilled by the same words, wherever its tool came from.
    pub fn is_like(&self, other: &DrilledHole) -> bool {
        let levels = |hole: &DrilledHole| [hole.start_mm, hole.bottom_mm, hole.retract_mm];
        let is_same_level =
            levels(self).iter().zip(levels(other)).all(|(a, b)| is_same_level(*a, b));
        is_same_level
            && self.plane == other.plane
            && self.feed == other.feed
            && are_same_motions(self.motions_from_start(), other.motions_from_start())
    }
}

/// Whether two holes have the same steps, within rounding.
pub fn are_same_motions(one: &[HoleMotion], other: &[HoleMotion]) -> bool {
    let is_same = |pair: (&HoleMotion, &HoleMotion)| match pair {
        (HoleMotion::Rapid(a), HoleMotion::Rapid(b)) => is_same_level(*a, *b),
        (HoleMotion::Cut { to_mm: a, feed: f }, HoleMotion::Cut { to_mm: b, feed: g }) => {
            is_same_level(*a, *b) && (f - g).abs() <= EQUAL * f.abs().max(g.abs())
        }
        (HoleMotion::Dwell(a), HoleMotion::Dwell(b)) => is_same_level(*a, *b),
        (HoleMotion::Rapid(_) | HoleMotion::Cut { .. } | HoleMotion::Dwell(_), _) => false,
    };
    one.len() == other.len() && one.iter().zip(other).all(is_same)
}
