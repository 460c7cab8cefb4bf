//! Checks of the spindle speed, and of axes that follow the spindle.

use chordal_command::{
    ArcShape, Feed, FeedMode, Move, Position, SpindleState, Units, telling_number,
};
use chordal_diagnostics::{Code, Diagnostic, Severity, Span};
use chordal_machine::Axis;

use crate::cycles::HoleWords;
use crate::kernel::Kernel;
use crate::motion::is_over;
use crate::rules::TapFeed;
use crate::statement::Statement;

/// A smaller X counts as the centre of rotation, mm.
const CENTER_MM: f64 = 1e-6;

/// A limit of the feed: of the machine, or of an axis.
#[derive(Clone)]
struct FeedBound {
    /// Along the path, mm/s.
    along_path: f64,
    /// The machine or axis, and its limit, mm/s.
    name: String,
    limit: f64,
}

impl Kernel<'_> {
    /// The limit of the machine for every feed.
    fn feed_bound_of_machine(&self) -> Option<FeedBound> {
        let limit = self.machine.feed.max_mm_per_s?;
        Some(FeedBound { along_path: limit, name: self.machine.name.clone(), limit })
    }

    /// The limit of an axis.
    fn feed_bound_of_axis(&self, axis: usize) -> Option<FeedBound> {
        let limit = self.machine.axes[axis].as_ref()?.max_velocity?;
        let name = format!("the {} axis of {}", Axis::ALL[axis].letter(), self.machine.name);
        Some(FeedBound { along_path: limit, name, limit })
    }

    /// The lowest limit along a straight cut: of the machine, and of each axis divided by its share of the path.
    fn feed_bound(&self, motion: &Move) -> Option<FeedBound> {
        let shares = shares_of_axes(motion);
        let of_axes = (0..3).filter(|axis| shares[*axis] > 0.0).filter_map(|axis| {
            let bound = self.feed_bound_of_axis(axis)?;
            Some(FeedBound { along_path: bound.limit / shares[axis], ..bound })
        });
        let bounds = self.feed_bound_of_machine().into_iter().chain(of_axes);
        bounds.min_by(|a, b| a.along_path.total_cmp(&b.along_path))
    }

    /// Reports a synchronized cut whose lead and speed exceed what an axis can follow; each axis is compared by itself.
    pub(crate) fn check_feed_in_step(&mut self, motion: &Move, feed: &Feed) {
        let Some(rev_per_s) = Some(feed.spindle_rev_per_s).filter(|rev| *rev > 0.0) else { return };
        let along_path = match feed.mode {
            FeedMode::PerRevolution => largest_lead(motion, feed),
            FeedMode::PerTime => feed.value / rev_per_s,
            FeedMode::InverseTime => return,
        };
        let shares = shares_of_axes(motion);
        let of_machine = self.feed_bound_of_machine();
        let over = (0..3).find_map(|axis| {
            let lead = along_path * shares[axis];
            let slowest = |a: FeedBound, b: FeedBound| if b.limit < a.limit { b } else { a };
            let bound = match (of_machine.clone(), self.feed_bound_of_axis(axis)) {
                (Some(a), Some(b)) => Some(slowest(a, b)),
                (a, b) => a.or(b),
            };
            let bound = bound.filter(|bound| is_over(lead * rev_per_s, Some(bound.limit)));
            bound.map(|bound| (lead, bound))
        });
        let Some((lead, bound)) = over else { return };
        let here = (self.state.tool, lead);
        if self.reported.feed_in_step == Some(here) {
            return;
        }
        self.reported.feed_in_step = Some(here);
        let speed = telling_number(rev_per_s * 60.0, 0);
        let most = telling_number(libm::floor(60.0 * bound.limit / lead), 0);
        let needed = self.feed_text(lead * rev_per_s);
        let (lead, limit) = (self.length_text(lead), self.feed_text(bound.limit));
        let message = format!(
            "a lead of {lead} at {speed} rpm is a feed of {needed}, above the {limit} that {} allows",
            bound.name
        );
        self.report(
            Diagnostic::new(Code::FeedOverLimit, self.origin.span, message)
                .label("the axis does not follow the spindle")
                .help(format!("program S{most} or less")),
        );
    }

    /// Reports a feed per revolution that exceeds a limit at the smallest diameter of the cut.
    #[cold]
    pub(crate) fn check_feed_per_turn(
        &mut self,
        word: Span,
        motion: &Move,
        shape: Option<&ArcShape>,
        feed: &Feed,
    ) {
        let radius = motion.least_radius();
        let Some(value) = feed.mm_per_s_at(radius).filter(|value| value.is_finite()) else {
            return;
        };
        // The direction of an arc changes, so its axes are not compared one by one.
        let bound = match shape {
            Some(_) => self.feed_bound_of_machine(),
            None => self.feed_bound(motion),
        };
        let Some(bound) = bound.filter(|bound| is_over(value, Some(bound.along_path))) else {
            return;
        };
        self.state.feed_over = None;
        let speed = telling_number(60.0 * value / feed.value, 0);
        let per_turn = self.length_text(feed.value);
        let share = bound.limit / bound.along_path;
        let (is, limit) = (self.feed_text(value * share), self.feed_text(bound.limit));
        let message = format!("a feed of {is} is above the {limit} that {} allows", bound.name);
        self.report(
            Diagnostic::new(Code::FeedOverLimit, word, message)
                .label(format!("{per_turn} per revolution at {speed} rpm"))
                .help("program a smaller F, or a lower spindle speed"),
        );
    }

    /// A feed with its unit, in the units of the program, for messages.
    pub(crate) fn feed_text(&self, mm_per_s: f64) -> String {
        match self.state.units {
            Units::Inch => format!("{} in/min", telling_number(mm_per_s * 60.0 / 25.4, 1)),
            Units::Millimetre => format!("{} mm/min", telling_number(mm_per_s * 60.0, 0)),
        }
    }

    /// Reports, once for each tool, a tapping cycle without a spindle speed.
    pub(crate) fn check_tap_speed(&mut self, at: &dyn Statement) {
        if self.state.rpm > 0.0 || !self.turns_without_speed() {
            return;
        }
        let tool = self.state.tool;
        // Not reported again for the cut that follows.
        self.reported.spindle_for_tool = Some(tool);
        if self.reported.tap_speed_for_tool.replace(tool) == Some(tool) {
            return;
        }
        let is_part = tool == 0 && self.state.spindle == SpindleState::Off;
        let severity = if is_part { Severity::Warning } else { Severity::Error };
        let with = if tool == 0 { String::new() } else { format!(" with tool {tool}") };
        let message = format!("a tapping cycle{with}, and the spindle has no speed");
        let diagnostic = Diagnostic::new(Code::TapWithoutSpeed, at.span(), message)
            .severity(severity)
            .label("no S before it, or S0")
            .help("write S before the cycle: F is the pitch times S, or the pitch where it is per revolution");
        self.report(diagnostic);
    }

    /// Reports, once for each tool, a thread whose passes have different spindle speeds.
    pub(crate) fn check_thread_speed(&mut self) {
        let Some(surface) = self.surface() else { return };
        let tool = self.state.tool;
        if self.reported.thread_at_surface_speed.replace(tool) == Some(tool) {
            return;
        }
        let rpm = surface.rev_per_s(self.state.position[0]) * 60.0;
        let speed = match rpm.is_finite() {
            true => format!(": {} rpm here", telling_number(rpm, 0)),
            false => String::new(),
        };
        let message = format!(
            "a thread while G96 keeps the cutting speed: the spindle speed changes with the diameter{speed}"
        );
        self.report(
            Diagnostic::new(Code::ThreadAtSurfaceSpeed, self.origin.span, message)
                .label("the passes do not meet in one groove")
                .help("write G97 and the spindle speed before the thread"),
        );
    }

    /// Reports, once for each tool, a hole along Z in the centre under constant surface speed.
    pub(crate) fn check_center_speed(&mut self, at: &dyn Statement, x: f64, is_tap: bool) {
        let Some(surface) = self.surface() else { return };
        if !is_tap && x.abs() > CENTER_MM {
            return;
        }
        let tool = self.state.tool;
        if self.reported.hole_at_surface_speed.replace(tool) == Some(tool) {
            return;
        }
        let what = if is_tap { "a tap" } else { "a hole in the centre" };
        let rpm = Some(surface.rev_per_s(x) * 60.0).filter(|rpm| rpm.is_finite());
        self.report(hole_at_surface_speed(at.span(), what, rpm));
    }

    /// Reports, once for each tool, a speed word of a cycle above the limit of the machine.
    pub fn check_cycle_speed(&mut self, at: &dyn Statement, rpm: f64, from: &str) {
        let most = match self.state.live {
            Some(_) => self.machine.live_tool_max_rpm,
            None => self.machine.spindle_max_rpm,
        };
        let tool = self.state.tool;
        let Some(max) = most.filter(|max| rpm > *max) else { return };
        if self.reported.cycle_speed_for_tool.replace(tool) == Some(tool) {
            return;
        }
        let (rpm, max) = (telling_number(rpm, 0), telling_number(max, 0));
        let message =
            format!("{from} turns the spindle at {rpm} rpm, above the {max} rpm of this machine");
        self.report(
            Diagnostic::new(Code::SpindleOverLimit, at.span(), message)
                .help(format!("program {max} rpm or less")),
        );
    }

    /// Checks the speeds of a tap: by its own word, and of the retraction.
    fn check_tap_speeds(&mut self, at: &dyn Statement, hole: &HoleWords) {
        let by_word = self.rules.cycles.tap.feed == TapFeed::SpeedWithLeadQ;
        let rpm = hole.words.tap_rpm.filter(|_| by_word);
        if let Some(rpm) = rpm {
            self.check_cycle_speed(at, rpm, "F of this tap");
        }
        let factor = self.out_factor(hole);
        if factor > 1.0 {
            let inward = self.state.live.map_or(self.state.rpm, |live| live.rpm);
            let rpm = rpm.unwrap_or(inward) * factor;
            self.check_cycle_speed(at, rpm, "the way out of this tap");
        }
    }

    /// Checks the spindle speeds of a hole.
    pub(crate) fn check_hole_speeds(
        &mut self,
        at: &dyn Statement,
        hole: &HoleWords,
        place: &Position,
    ) {
        let is_tap = hole.words.kind.is_tap();
        if is_tap {
            self.check_tap_speeds(at, hole);
        }
        if let Some(rpm) = hole.words.after_rpm {
            self.check_cycle_speed(at, rpm, "E of this cycle");
        }
        if hole.axis == Axis::Z as usize {
            self.check_center_speed(at, place[Axis::X as usize], is_tap);
        }
    }
}

/// The problem of a hole (`what`) under constant surface speed; `rpm` is the speed there, `None` when nothing limits it.
pub fn hole_at_surface_speed(span: Span, what: &str, rpm: Option<f64>) -> Diagnostic {
    let speed = match rpm {
        Some(rpm) => format!("at {} rpm", telling_number(rpm, 0)),
        None => "as fast as it can".to_string(),
    };
    let message = format!("{what} while G96 keeps the cutting speed: the spindle turns {speed}");
    Diagnostic::new(Code::DrillingAtSurfaceSpeed, span, message)
        .label("X0 asks for any speed")
        .help("write G97 and the spindle speed before the hole")
}

/// The fraction of a straight path along each of X, Y and Z.
fn shares_of_axes(motion: &Move) -> [f64; 3] {
    let course: [f64; 3] = std::array::from_fn(|axis| (motion.to[axis] - motion.from[axis]).abs());
    let length = libm::sqrt(course.iter().map(|part| part * part).sum());
    course.map(|part| if length > 0.0 { part / length } else { 0.0 })
}

/// The largest lead of a synchronized cut, mm: a changing lead is largest at one of its ends.
fn largest_lead(motion: &Move, feed: &Feed) -> f64 {
    if feed.lead_change == 0.0 || feed.value <= 0.0 {
        return feed.value;
    }
    let length: f64 = (0..3).map(|axis| (motion.to[axis] - motion.from[axis]).powi(2)).sum();
    // The leads of the ends differ by the change times the turns, and `value` is their mean.
    let turns = libm::sqrt(length) / feed.value;
    feed.value + feed.lead_change.abs() * turns / 2.0
}
