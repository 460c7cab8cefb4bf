//! By how much a program exceeds the limits of an assumed machine. Those limits are a guess, so there is one note for
//! the program and not an error for each move.

use chordal_command::{AxisMask, CommandKind, Feed, FeedMode, Move, Units, number_text};
use chordal_diagnostics::{Code, Diagnostic, Span};
use chordal_geometry::tolerance::ROUNDING_SHARE;
use chordal_machine::{AXES, Machine, PerAxis};

/// The largest excess of each kind.
#[derive(Clone, Copy, Debug, Default)]
pub struct LimitExcess {
    /// The largest distance beyond the travel of each axis, mm or rad.
    travel: PerAxis<f64>,
    /// The largest feed above the limit, mm/s.
    feed: f64,
    /// The largest spindle speed above the limit, rpm.
    speed: f64,
}

/// The largest share that one axis has in a straight cut with a feed per revolution, 0 to 1: the feed limit applies to
/// the axis. 1 for other feeds.
fn share_in_step(feed: &Feed, motion: &Move) -> f64 {
    if feed.mode != FeedMode::PerRevolution {
        return 1.0;
    }
    let path: [f64; 3] = std::array::from_fn(|axis| (motion.to[axis] - motion.from[axis]).abs());
    let length = libm::sqrt(path.iter().map(|part| part * part).sum());
    let longest = path.into_iter().fold(0.0, f64::max);
    if length > 0.0 { longest / length } else { 1.0 }
}

impl LimitExcess {
    /// Adds the excess of another part of the run.
    pub fn and(&mut self, other: &LimitExcess) {
        for axis in 0..AXES {
            self.travel(axis, other.travel[axis]);
        }
        self.feed = self.feed.max(other.feed);
        self.speed = self.speed.max(other.speed);
    }

    /// Records a move that goes `over` beyond the travel of an axis, mm or rad.
    pub fn travel(&mut self, axis: usize, over: f64) {
        self.travel[axis] = self.travel[axis].max(over);
    }

    /// Records the feed or the spindle speed of a command, if it is above the limit.
    #[inline]
    pub fn command(&mut self, kind: &CommandKind, machine: &Machine) {
        if let CommandKind::Spindle { rpm, .. } = kind {
            if machine.spindle_max_rpm.is_some_and(|most| *rpm > most) {
                self.speed = self.speed.max(*rpm);
            }
        } else if let (Some(feed), Some(motion)) = (kind.feed(), kind.motion())
            && let Some(value) = feed.mm_per_s_at(motion.least_radius())
            && let value = value * share_in_step(feed, motion)
            && value > self.feed
            && value.is_finite()
            && machine.feed.max_mm_per_s.is_some_and(|most| value > most * (1.0 + ROUNDING_SHARE))
            && !kind.only_turns()
        {
            self.feed = value;
        }
    }

    /// One note about everything that was exceeded; `None` if nothing was.
    pub fn note(&self, machine: &Machine, units: Units, head: Span) -> Option<Diagnostic> {
        let parts: Vec<String> = self
            .travel_text(machine, units)
            .into_iter()
            .chain(self.feed_text(machine, units))
            .chain(self.speed_text(machine))
            .collect();
        if parts.is_empty() {
            return None;
        }
        Some(
            Diagnostic::new(
                Code::AssumedLimits,
                head,
                format!(
                    "limits of the assumed machine ({}) are exceeded: {}",
                    machine.title,
                    parts.join("; ")
                ),
            )
            .help("name yours with --machine; then its limits are checked move by move"),
        )
    }

    fn travel_text(&self, machine: &Machine, units: Units) -> Option<String> {
        let over = AxisMask::ALL.iter().filter(|axis| self.travel[*axis as usize] > 0.0);
        let texts: Vec<String> = over
            .map(|axis| {
                let value = self.travel[axis as usize];
                let text = match axis.is_rotary() {
                    true => format!("{} deg", number_text(value.to_degrees(), 3)),
                    false => units.length_text(value * machine.written_factor(axis as usize)),
                };
                format!("{} by {text}", axis.letter())
            })
            .collect();
        (!texts.is_empty()).then(|| format!("the travel in {}", texts.join(", ")))
    }

    fn feed_text(&self, machine: &Machine, units: Units) -> Option<String> {
        let most = machine.feed.max_mm_per_s.filter(|_| self.feed > 0.0)?;
        let (per_mm, unit) = match units {
            Units::Inch => (60.0 / 25.4, "in/min"),
            Units::Millimetre => (60.0, "mm/min"),
        };
        let text = |value: f64| number_text(value * per_mm, 1);
        Some(format!("a feed of {} {unit}, at most {}", text(self.feed), text(most)))
    }

    fn speed_text(&self, machine: &Machine) -> Option<String> {
        let most = machine.spindle_max_rpm.filter(|_| self.speed > 0.0)?;
        let (speed, most) = (number_text(self.speed, 0), number_text(most, 0));
        Some(format!("a spindle speed of {speed} rpm, at most {most}"))
    }
}
