//! The kernel: what a numerical control remembers and emits.

use chordal_command::{
    ArcShape, AxisMask, CallPath, CallPaths, Command, CommandKind, Feed, Move, Origin, RapidPath,
    Units, telling_number,
};
use chordal_diagnostics::{Code, Diagnostic, Severity, Span};
use chordal_machine::Machine;

use crate::corner_queue::CornerQueue;
use crate::offsets::CoordinatePresets;
use crate::rules::{ArcCenter, Rules};
use crate::sink::RunSink;
use crate::state::State;

/// The alarm texts of a control.
#[derive(Clone, Copy, Debug)]
pub struct Alarms {
    /// The name of the control in messages.
    pub title: &'static str,
    /// The text of each problem that the control knows; `{n}` is the number of the block,
    /// `{delta}` the measured difference.
    pub texts: &'static [(Code, &'static str)],
}

impl Alarms {
    /// The control's own text; `None` when it has none for this problem.
    pub fn text(&self, code: Code) -> Option<&'static str> {
        self.texts.iter().find(|(of, _)| *of == code).map(|(_, text)| *text)
    }
}

/// Problems that are reported once a run (or once a tool), and whether they were.
#[derive(Clone, Default, Debug, PartialEq)]
pub struct KernelReports {
    /// No feed before a cut.
    pub missing_feed: bool,
    /// An arc that may be a full circle.
    pub vanishing_circle: bool,
    /// A rotary axis whose feed needs a diameter that the machine file does not give.
    pub rotary_diameter: bool,
    /// The tool that cut without a spindle.
    pub spindle_for_tool: Option<u32>,
    /// The tap whose pitch does not match the feed.
    pub pitch_for_tool: Option<u32>,
    /// The tool that tapped without a speed.
    pub tap_speed_for_tool: Option<u32>,
    /// The tool whose synchronized cut exceeded the largest feed, and the lead, mm.
    pub feed_in_step: Option<(u32, f64)>,
    /// The tool that cut a thread at constant surface speed.
    pub thread_at_surface_speed: Option<u32>,
    /// The tool that made a hole in the centre at constant surface speed.
    pub hole_at_surface_speed: Option<u32>,
    /// The tool whose speed in a cycle exceeded its limit.
    pub cycle_speed_for_tool: Option<u32>,
    /// An arc in inverse time, where F has a meaning of its own on this control.
    pub inverse_time_arc: bool,
    /// Offsets that the machine file does not give.
    pub offsets: Vec<String>,
    /// A cycle without R, which feeds from the initial level.
    pub cycle_without_r: bool,
    /// Built-in routines whose path no manual gives, so that it is assumed.
    pub assumed_paths: Vec<String>,
    /// The other rule for arc centres under which an arc was right.
    pub other_center: Option<ArcCenter>,
}

/// All that a kernel remembers, to resume a run from a checkpoint.
#[derive(Clone, Debug, PartialEq)]
pub struct KernelMemory {
    /// The state of the control.
    pub state: State,
    /// The last block.
    pub origin: Origin,
    /// The chains of calls.
    pub calls: CallPaths,
    /// Blocks counted against the budget.
    pub repeated: u64,
    /// The number of the last block that has one.
    pub block_number: Option<f64>,
    /// Presets that G92.3 restores.
    pub kept_presets: CoordinatePresets,
    /// Presets are active.
    pub preset_acts: bool,
    /// The axes whose preset is known from the program.
    pub presets_known: AxisMask,
    /// Problems reported so far.
    pub reported: KernelReports,
}

/// A running numerical control: it takes values with their statement, moves the machine and
/// emits commands and problems into its sink. It sees no text.
pub struct Kernel<'a> {
    /// The rules of this control.
    pub rules: &'a Rules,
    /// The machine.
    pub machine: &'a Machine,
    /// The alarm texts of the control.
    pub alarms: Alarms,
    /// Modal and other state.
    pub state: State,
    /// The current block.
    pub origin: Origin,
    /// The chains of calls so far.
    pub calls: CallPaths,
    /// The calls that the block was reached through.
    pub call: CallPath,
    /// The number of the last block that has one, for alarms.
    pub block_number: Option<f64>,
    /// Blocks in calls and repeats so far.
    pub repeated: u64,
    /// The budget: the largest permitted `repeated`.
    pub max_repeated: u64,
    /// Presets that G92.2 keeps for G92.3.
    pub kept_presets: CoordinatePresets,
    /// G92 or G52 acts: it was programmed and not cancelled since.
    pub preset_acts: bool,
    /// The axes whose preset is known from the program.
    pub presets_known: AxisMask,
    /// Problems that are not reported again.
    pub reported: KernelReports,
    /// Moves that wait for the corner at their end.
    pub(crate) corners: CornerQueue,
    /// The commands of a contour while a cycle reads it; they are not carried out. `None` otherwise.
    pub collected: Option<Vec<Command>>,
    /// The contour that is cut may have been read by a cycle before, with its problems reported.
    pub contour_again: bool,
    /// Problems reported while cycles read contours.
    reported_contours: Vec<(Code, Span)>,
    /// Takes what the run produces.
    pub sink: &'a mut (dyn RunSink + 'a),
}

impl<'a> Kernel<'a> {
    /// A kernel in the state `state`, with nothing emitted or reported.
    pub fn new(
        rules: &'a Rules,
        machine: &'a Machine,
        alarms: Alarms,
        state: State,
        sink: &'a mut (dyn RunSink + 'a),
    ) -> Kernel<'a> {
        Kernel {
            rules,
            machine,
            alarms,
            state,
            origin: Origin::default(),
            calls: CallPaths::default(),
            call: CallPath::default(),
            block_number: None,
            repeated: 0,
            max_repeated: u64::MAX,
            kept_presets: CoordinatePresets::default(),
            preset_acts: false,
            presets_known: AxisMask::NONE,
            reported: KernelReports::default(),
            corners: CornerQueue::default(),
            collected: None,
            contour_again: false,
            reported_contours: Vec::new(),
            sink,
        }
    }

    /// Emits a command of the current block, mapped into the work coordinate system.
    #[inline(always)]
    pub fn emit(&mut self, kind: CommandKind) {
        // Most commands are moves. They own nothing, and without the check of what there is to drop they are faster.
        const {
            assert!(!std::mem::needs_drop::<(Move, RapidPath, Feed, ArcShape)>());
        }
        let owns_nothing = matches!(
            kind,
            CommandKind::Line { .. } | CommandKind::Rapid { .. } | CommandKind::Arc { .. }
        );
        let command = Command { kind, origin: self.origin };
        if self.corners.wait()
            || !self.state.frames.is_plain()
            || self.collected.is_some()
            || self.state.surface.is_some()
        {
            return self.emit_rare(command);
        }
        self.sink.command(&command);
        if owns_nothing {
            std::mem::forget(command);
        }
    }

    /// The rare cases of [`Kernel::emit`]: an active frame or surface, a waiting corner, a contour that is read.
    #[cold]
    fn emit_rare(&mut self, command: Command) {
        if self.corners.wait() {
            return self.emit_at_corner(command.kind);
        }
        let command = self.in_work(command.kind, command.origin);
        self.check_scaled_size(&command);
        self.hand_over(&command);
    }

    /// Passes a command to the sink, or to the cycle that reads a contour.
    pub(crate) fn hand_over(&mut self, command: &Command) {
        if let (Some(surface), Some(motion)) = (&mut self.state.surface, command.kind.motion()) {
            surface.run.follow(motion, command.kind.shape());
        }
        match &mut self.collected {
            Some(commands) => commands.push(command.clone()),
            None => self.sink.command(command),
        }
    }

    /// A command mapped into the work coordinate system.
    #[inline]
    pub(crate) fn in_work(&self, kind: CommandKind, origin: Origin) -> Command {
        let kind = match self.state.frames.is_plain() {
            true => kind,
            false => self.state.frames.map().command(kind, self.state.plane),
        };
        Command { kind, origin }
    }

    /// Reports a problem, with the calls that led to it and the control's alarm text.
    pub fn report(&mut self, mut diagnostic: Diagnostic) {
        if self.call != CallPath::default() {
            diagnostic.calls = self.calls.resolve(self.call);
        }
        if diagnostic.alarm.is_none() && diagnostic.severity == Severity::Error {
            diagnostic.alarm = self.alarm_text(diagnostic.code, None);
        }
        if self.collected.is_some() || self.contour_again {
            let problem = (diagnostic.code, diagnostic.primary.span);
            if self.reported_contours.contains(&problem) {
                return;
            }
            if self.collected.is_some() {
                self.reported_contours.push(problem);
            }
        }
        self.sink.diagnostic(diagnostic);
    }

    /// The alarm text with the number of the block and the measured difference filled in; `None` when the
    /// control has none.
    pub fn alarm_text(&self, code: Code, delta: Option<String>) -> Option<String> {
        let text = self.alarms.text(code)?;
        let text = text
            .replace("{n}", &self.number_of_block())
            .replace("{delta}", &delta.unwrap_or_default());
        Some(format!("{}: {text}", self.alarms.title))
    }

    /// The number of the last block that has one, for alarms; `?` before the first.
    pub fn number_of_block(&self) -> String {
        self.block_number.map_or("?".to_string(), |number| number.to_string())
    }

    /// Reports a missing word.
    pub fn missing_word(&mut self, at: Span, message: String, help: &str) {
        self.report(Diagnostic::new(Code::MissingWord, at, message).help(help));
    }

    /// Counts a block against the budget; false when it is used up.
    pub fn count_repeated(&mut self) -> bool {
        self.repeated += 1;
        if self.repeated <= self.max_repeated {
            return true;
        }
        let limit = self.max_repeated;
        self.report(
            Diagnostic::new(
                Code::BudgetReached,
                self.origin.span,
                format!("stopped after {limit} blocks in calls and repeats"),
            )
            .help("if the program really runs that long, raise the budget with --max-blocks"),
        );
        false
    }

    /// A length with its unit, in the units of the program, for messages.
    pub fn length_text(&self, mm: f64) -> String {
        match self.state.units {
            Units::Inch => format!("{} in", telling_number(mm / 25.4, 4)),
            Units::Millimetre => format!("{} mm", telling_number(mm, 3)),
        }
    }

    /// A copy of all that it remembers.
    pub fn memory(&self) -> KernelMemory {
        KernelMemory {
            state: self.state.clone(),
            origin: self.origin,
            calls: self.calls.clone(),
            repeated: self.repeated,
            block_number: self.block_number,
            kept_presets: self.kept_presets,
            preset_acts: self.preset_acts,
            presets_known: self.presets_known,
            reported: self.reported.clone(),
        }
    }

    /// Restores what [`Kernel::memory`] returned.
    pub fn recall(&mut self, memory: KernelMemory) {
        self.state = memory.state;
        self.origin = memory.origin;
        self.calls = memory.calls;
        self.repeated = memory.repeated;
        self.block_number = memory.block_number;
        self.kept_presets = memory.kept_presets;
        self.preset_acts = memory.preset_acts;
        self.presets_known = memory.presets_known;
        self.reported = memory.reported;
    }
}

impl KernelMemory {
    /// Moves its spans to a text that was changed at another position; `None` when a word that it
    /// remembers was deleted.
    pub fn shift(&mut self, shift: &chordal_diagnostics::TextShift) -> Option<()> {
        self.origin = self.origin.shifted(shift)?;
        self.calls.shift(shift)?;
        if let Some(word) = &mut self.state.feed_over {
            *word = shift.span(*word)?;
        }
        Some(())
    }

    /// Equal bit for bit: 0 and −0 are different positions.
    pub fn is_like(&self, other: &KernelMemory) -> bool {
        self.is_at(other) && self == other
    }

    /// True at the same position, bit for bit.
    pub fn is_at(&self, other: &KernelMemory) -> bool {
        let bits = |memory: &KernelMemory| memory.state.position.map(f64::to_bits);
        bits(self) == bits(other)
    }
}
