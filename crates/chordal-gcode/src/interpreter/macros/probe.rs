//! Probe and skip moves: G31, G38.2 to G38.5. The machine file gives where they touch.

use chordal_command::{
    AxisMask, CommandKind, CompensationSide, Feed, FeedAlong, FeedMode, Position, Units,
};
use chordal_diagnostics::{Code, Diagnostic, Severity};
use chordal_machine::{AXES, AXIS_LETTERS, ProbeHit};
use chordal_syntax::Block;

use super::super::Interpreter;
use super::super::literals::trim;

/// The results of probe moves.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub(in super::super) struct ProbeResults {
    /// There was a probe move.
    pub skipped: bool,
    /// The last one touched something.
    pub found: bool,
    /// Points that the program can read, mm and rad; the first is the last touch.
    pub points: [Position; 3],
    /// The assumption about the touch has been reported.
    is_reported: bool,
}

/// A shorter probe move is refused, mm and rad.
const MIN_PROBE_MM: f64 = 1e-6;

impl Interpreter<'_> {
    /// Makes a move that ends where the probe touches; with `must_hit` the control stops without a touch.
    pub(in super::super) fn probe_move(&mut self, block: &Block, at: usize, must_hit: bool) {
        let span = self.span(block.words[at].range);
        let (target, named) = self.target(block);
        if named == AxisMask::NONE {
            // G31 alone only waits; a probe move needs an end point.
            if must_hit || !self.rules().macro_b {
                self.report_probe(span, "a probe move without an end point");
            }
            return;
        }
        if self.kernel.state.side != CompensationSide::Off {
            self.report_probe(span, "a probe move while cutter compensation is on");
        }
        if self.control.parameters.strict_words
            && self.kernel.state.feed_mode == FeedMode::PerRevolution
        {
            self.report_refused(
                Diagnostic::new(
                    Code::BadProbeMove,
                    span,
                    "a probe move with a feed per revolution (G95)",
                )
                .help("write G94 and a feed per minute before it"),
                "Cannot probe with feed per rev mode",
            );
        }
        let course = (0..AXES).map(|axis| (target[axis] - self.kernel.state.position[axis]).abs());
        if self.control.parameters.strict_words && course.fold(0.0, f64::max) < MIN_PROBE_MM {
            self.report_refused(
                Diagnostic::new(Code::BadProbeMove, span, "this probe move ends where it begins")
                    .help("program an end point on the other side of what is probed"),
                "Start point too close to probe point",
            );
        }
        let (end, found) = self.probe_end(target);
        if !self.macros.probe.is_reported {
            self.macros.probe.is_reported = true;
            self.report_skip(span);
        }
        if !found && must_hit {
            self.kernel.report(
                Diagnostic::new(
                    Code::ProbeWithoutHit,
                    span,
                    "this probe move touches nothing, and the control stops with an alarm",
                )
                .help("the machine file says what a probe touches: `[probe] hit`"),
            );
        }
        let motion = self.kernel.moved_to(end, named);
        let feed = self.probe_feed(&motion);
        if feed.value.is_nan() || feed.value <= 0.0 {
            self.report_probe(span, "a probe move before the first feed");
        }
        self.kernel.emit(CommandKind::Line { motion, feed });
        self.kernel.emit(CommandKind::Probed { hit: found });
        self.macros.used = true;
        (self.macros.probe.skipped, self.macros.probe.found) = (true, found);
        self.forget_probe_result();
        self.macros.skip = end;
        self.macros.probe.points[0] = end;
        if self.rules().skip_with_length {
            let offsets = &self.kernel.state.offsets;
            self.macros.skip[2] += offsets.total()[2] - offsets.work()[2];
        }
    }

    /// The end of the move, and whether it touches.
    fn probe_end(&self, target: Position) -> (Position, bool) {
        let probe = &self.machine.probe;
        match probe.hit {
            Some(ProbeHit::End) => return (target, true),
            Some(ProbeHit::Nothing) => return (target, false),
            None if probe.planes.iter().all(Option::is_none) => return (target, true),
            None => {}
        }
        let from = self.kernel.state.position;
        let mut nearest = f64::INFINITY;
        for axis in 0..AXES {
            let Some(plane) = probe.planes[axis] else { continue };
            let course = target[axis] - from[axis];
            let part = (plane - from[axis]) / course;
            // A move parallel to the plane does not touch it.
            if course != 0.0 && (0.0..=1.0).contains(&part) {
                nearest = nearest.min(part);
            }
        }
        if nearest > 1.0 {
            return (target, false);
        }
        let mut end = target;
        for axis in 0..AXES {
            end[axis] = match probe.planes[axis] {
                // Exactly the coordinate of the touched plane, without rounding.
                Some(plane) if plane == from[axis] + nearest * (target[axis] - from[axis]) => plane,
                _ => from[axis] + nearest * (target[axis] - from[axis]),
            };
        }
        (end, true)
    }

    /// The active feed; the spindle may be stopped.
    fn probe_feed(&self, motion: &chordal_command::Move) -> Feed {
        let state = &self.kernel.state;
        let angular = motion.only_turns(None) && state.feed_mode == FeedMode::PerTime;
        Feed {
            value: if angular { state.feed_angular } else { state.feed }.unwrap_or(f64::NAN),
            mode: state.feed_mode,
            along: FeedAlong::Path,
            spindle_rev_per_s: state.rpm / 60.0,
            lead_change: 0.0,
            surface: None,
        }
    }

    /// Reports where probe and skip moves touch: by the machine file, or assumed.
    fn report_skip(&mut self, span: chordal_diagnostics::Span) {
        let probe = &self.machine.probe;
        let planes: Vec<String> = (0..AXES)
            .filter_map(|axis| probe.planes[axis].map(|plane| (axis, plane)))
            .map(|(axis, plane)| {
                let letter = AXIS_LETTERS.as_bytes()[axis] as char;
                let unit =
                    if self.kernel.state.units == Units::Inch && axis < 3 { 25.4 } else { 1.0 };
                let written = plane / self.per_word[axis];
                let shown = if axis < 3 { written / unit } else { written.to_degrees() };
                format!("{letter}{}", trim(shown, 4))
            })
            .collect();
        let what = match probe.hit {
            Some(ProbeHit::Nothing) => "touch nothing".to_string(),
            None if !planes.is_empty() => format!("touch at {}", planes.join(" or ")),
            _ => "touch where they end".to_string(),
        };
        if probe.hit.is_some() || !planes.is_empty() {
            let message = format!("probe and skip moves {what}, as the machine file says");
            return self.kernel.report(Diagnostic::new(Code::SkipByMachineFile, span, message));
        }
        let message = format!("it is assumed that probe and skip moves {what}");
        self.kernel.report(
            Diagnostic::new(Code::SkipAssumed, span, message)
                .severity(Severity::Note)
                .label("from here on the path is assumed")
                .help("give it in the machine file: `[probe] hit = { Z = \"-10 mm\" }`"),
        );
    }

    fn report_probe(&mut self, span: chordal_diagnostics::Span, message: &str) {
        self.report_once(
            Diagnostic::new(Code::BadProbeMove, span, message)
                .help("program the axes and their end points, with a feed, after G40"),
        );
    }
}
