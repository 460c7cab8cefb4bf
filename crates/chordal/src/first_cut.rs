//! A first pass over the program that finds the frame of the run, which is the work coordinate system of its first
//! cut (without a cut, of its first move), and the axes that the program never names.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use chordal_command::{AxisMask, Command, Move, Sink};
use chordal_diagnostics::Diagnostic;
use chordal_kernel::{RunOptions, RunSink};
use chordal_machine::{AXES, RotaryAxis, RotaryTarget};
use chordal_path::{NotNamed, ProgramFrame, RunFrame};

use crate::job::Job;
use crate::premises::RunPremises;

/// Follows the run until the first cut is known and X, Y and Z have all been named, in a cut, too.
struct AheadSink {
    frame: ProgramFrame,
    first_cut: Option<ProgramFrame>,
    /// The frame of the first cut whose place is known: a cut before it, as a jog to the part, is not drawn.
    first_known_cut: Option<ProgramFrame>,
    /// The frame of the first move whose place is known, for a program without a cut.
    first_move: Option<ProgramFrame>,
    never: AxisMask,
    in_no_cut: AxisMask,
    has_all: Arc<AtomicBool>,
}

impl AheadSink {
    /// The axes that were not named; none where no axis was, since there is nothing to draw then.
    fn not_named(&self) -> NotNamed {
        let in_no_cut = match self.first_cut {
            Some(_) => self.in_no_cut.without(self.never),
            None => AxisMask::NONE,
        };
        let found = NotNamed { never: self.never, in_no_cut };
        if found.all() == AxisMask::LINEAR { NotNamed::NONE } else { found }
    }

    fn has_all(&self) -> bool {
        self.first_known_cut.is_some() && self.never.or(self.in_no_cut) == AxisMask::NONE
    }
}

impl Sink for AheadSink {
    fn command(&mut self, command: &Command) {
        if self.first_known_cut.is_none() && !self.frame.follow(command) {
            let is_known = command.kind.motion().is_some_and(is_known);
            if command.kind.feed().is_some() {
                self.first_cut.get_or_insert_with(|| self.frame.clone());
                self.first_known_cut = is_known.then(|| self.frame.clone());
            } else if is_known {
                self.first_move.get_or_insert_with(|| self.frame.clone());
            }
        }
        if let Some(motion) = command.kind.motion() {
            let named = named_by(motion);
            self.never = self.never.without(named);
            if command.kind.feed().is_some() {
                self.in_no_cut = self.in_no_cut.without(named);
            }
        }
        if self.has_all() {
            self.has_all.store(true, Ordering::Relaxed);
        }
    }

    fn diagnostic(&mut self, _: Diagnostic) {}
}

impl RunSink for AheadSink {}

/// Whether its position relative to the part is known along some axis, at its start and at its end.
fn is_known(motion: &Move) -> bool {
    motion.from_known.and(motion.to_known).and(AxisMask::LINEAR) != AxisMask::NONE
}

/// The axes of X, Y and Z that the program must have named before the end of this move: their positions are known, or
/// they move, as to a reference point.
fn named_by(motion: &Move) -> AxisMask {
    let mut axes = motion.from_known.or(motion.to_known);
    (0..3).filter(|axis| motion.from[*axis] != motion.to[*axis]).for_each(|axis| axes.insert(axis));
    axes
}

impl Job<'_> {
    /// The frame of the run; `None` where nothing moves, or where the caller answers the program while it runs.
    pub(crate) fn run_frame(&self) -> Option<RunFrame> {
        self.ahead().run_frame
    }

    /// The axes of X, Y and Z that the program does not name, which are drawn at zero. Empty where the caller answers
    /// the program while it runs.
    pub fn not_named_axes(&self) -> NotNamed {
        self.ahead().not_named.unwrap_or_default()
    }

    pub(crate) fn ahead(&self) -> RunPremises {
        *self.ahead.get_or_init(|| self.look_ahead())
    }

    fn look_ahead(&self) -> RunPremises {
        let options = self.run_options();
        if options.not_read.is_some()
            || options.shop_codes.is_some()
            || self.machine().answers_with_blocks()
        {
            return RunPremises::default();
        }
        let has_all = Arc::new(AtomicBool::new(false));
        let mut sink = AheadSink {
            frame: self.initial_frame(),
            first_cut: None,
            first_known_cut: None,
            first_move: None,
            never: AxisMask::LINEAR,
            in_no_cut: AxisMask::LINEAR,
            has_all: has_all.clone(),
        };
        let interrupt = options.interrupt.clone();
        let ends = move || {
            has_all.load(Ordering::Relaxed) || interrupt.as_ref().is_some_and(|ends| ends())
        };
        let options = RunOptions { interrupt: Some(Arc::new(ends)), ..options.clone() };
        let programs = self.program_set_with(&options);
        for program in self.mains(&*programs) {
            programs.run(program, None, &mut sink);
            if sink.has_all() {
                break;
            }
        }
        let first = [&sink.first_known_cut, &sink.first_cut, &sink.first_move];
        let first = first.into_iter().find_map(Option::as_ref);
        let run_frame = first.map(|frame| self.run_frame_of(frame));
        RunPremises { run_frame, not_named: Some(sink.not_named()) }
    }

    /// The rotary axes with their centres in the frame of the run: where the machine file gives none, from the point on the
    /// machine and the work offset, as far as both are known.
    pub fn rotary_axes(&self) -> [RotaryAxis; 3] {
        let mut rotary = self.machine().rotary;
        let Some(run_frame) = self.ahead().run_frame else { return rotary };
        let tables = rotary.iter_mut().filter(|own| own.turns == Some(RotaryTarget::Table));
        for own in tables {
            for axis in 0..3 {
                let offset = run_frame.offset(axis);
                let derived = own.point_mm[axis].zip(offset).map(|(point, offset)| point - offset);
                own.center_mm[axis] = own.center_mm[axis].or(derived);
            }
        }
        rotary
    }

    fn run_frame_of(&self, frame: &ProgramFrame) -> RunFrame {
        let key = frame.name.table_key(self.profile().work_names);
        let table = |key: &str, axis: usize| self.machine().work_offsets.get(key)?.values[axis];
        let set_up = |axis| Some(table(&key, axis)? + table("EXT", axis).unwrap_or(0.0));
        RunFrame::of_cut(frame, std::array::from_fn::<_, AXES, _>(set_up))
    }
}
