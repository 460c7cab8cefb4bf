//! The frame of a run: the work coordinate system of its first cut, which is found before the run.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use chordal_command::{Command, Sink};
use chordal_diagnostics::Diagnostic;
use chordal_gcode::{RunOptions, WordAddress};
use chordal_kernel::{Language, RunSink};
use chordal_machine::AXES;
use chordal_path::{Frame, RunFrame};

use crate::job::Job;

/// Waits for the first cut.
struct FirstCutSink {
    frame: Frame,
    found: Option<Frame>,
    is_found: Arc<AtomicBool>,
}

impl Sink for FirstCutSink {
    fn command(&mut self, command: &Command) {
        if self.found.is_none() && !self.frame.follow(command) && command.kind.feed().is_some() {
            self.found = Some(self.frame);
            self.is_found.store(true, Ordering::Relaxed);
        }
    }

    fn diagnostic(&mut self, _: Diagnostic) {}
}

impl RunSink for FirstCutSink {}

impl Job<'_> {
    /// The frame of the run; `None` where nothing is cut, or somebody is asked on the way.
    pub(crate) fn run_frame(&self) -> Option<RunFrame> {
        *self.run_frame.get_or_init(|| self.find_run_frame())
    }

    fn find_run_frame(&self) -> Option<RunFrame> {
        let options = self.run_options();
        if options.not_read.is_some()
            || options.shop_codes.is_some()
            || self.machine().answers_with_blocks()
        {
            return None;
        }
        let is_found = Arc::new(AtomicBool::new(false));
        let mut sink =
            FirstCutSink { frame: self.initial_frame(), found: None, is_found: is_found.clone() };
        let wanted = options.interrupt.clone();
        let ends = move || {
            is_found.load(Ordering::Relaxed) || wanted.as_ref().is_some_and(|interrupt| interrupt())
        };
        let options = RunOptions { interrupt: Some(Arc::new(ends)), ..options.clone() };
        let language = WordAddress::new(self.sources(), self.machine(), self.control(), &options);
        for program in self.mains(&language) {
            language.run(program, None, &mut sink);
            if sink.found.is_some() {
                break;
            }
        }
        let frame = sink.found?;
        let key = frame.name.table_key(self.control().table.work_names);
        let table = |key: &str, axis: usize| self.machine().work_offsets.get(key)?.values[axis];
        let set_up = |axis| Some(table(&key, axis)? + table("EXT", axis).unwrap_or(0.0));
        Some(RunFrame::of_cut(&frame, std::array::from_fn::<_, AXES, _>(set_up)))
    }
}
