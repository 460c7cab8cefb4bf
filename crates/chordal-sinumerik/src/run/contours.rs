//! The contour of a cycle: a subprogram, or the part of the program between two labels.

use std::collections::HashMap;

use chordal_command::{Command, CompensationSide};
use chordal_diagnostics::{Code, Diagnostic, TextRange};

use super::interpreter::Interpreter;
use super::program_texts::bare_name;
use super::run_state::{BlockFlow, RunningProgram};
use super::variables::ProgramVariable;
use crate::syntax::JumpDirection;

impl Interpreter<'_> {
    /// The moves of a contour, which are not carried out: `NAME` of a subprogram, or `LABEL:LABEL` in the running program
    /// (Cycles 11/2006, CYCLE95). `None` where there is none, which is reported.
    pub(super) fn record_contour(&mut self, name: &str, range: TextRange) -> Option<Vec<Command>> {
        let name = name.to_ascii_uppercase();
        let (program, start, last) = match name.split_once(':') {
            Some((from, to)) => {
                let places = (
                    self.find_target(from.trim(), JumpDirection::Both),
                    self.find_target(to.trim(), JumpDirection::Both),
                );
                let (Some(from), Some(to)) = places else {
                    let message = format!("no blocks have the labels {name}");
                    self.alarm(14080, Code::MissingLabel, range, message);
                    return None;
                };
                (self.running().program, Some(from), to.0)
            }
            None => match self.programs.find_name(bare_name(&name)) {
                Some(program) => (program, None, u32::MAX),
                None => {
                    let message = format!("there is no contour {name}");
                    let diagnostic =
                        Diagnostic::new(Code::MissingSubprogram, self.span(range), message);
                    self.report_missing_name(14011, diagnostic, false);
                    return None;
                }
            },
        };
        let mut reader = self.programs.reader(program);
        if let Some((offset, line)) = start {
            reader.seek(offset, line);
        }
        let (state, modes) = (self.kernel.state.clone(), self.modes.clone());
        let (origin, modal) = (self.kernel.origin, self.modal_call.take());
        let block = self.span(self.here());
        let caller = self.running().call;
        let call = self.kernel.calls.enter(caller, block);
        self.kernel.end_corners();
        self.kernel.state.side = CompensationSide::Off;
        // The contour is cut at the feeds of its cycle.
        self.kernel.state.feed.get_or_insert(1.0);
        self.kernel.collected = Some(Vec::new());
        self.variables.locals.push(HashMap::<String, ProgramVariable>::new());
        self.stack.push(RunningProgram::new(program, reader, call));
        self.run_contour(last);
        self.kernel.end_corners();
        let commands = self.kernel.collected.take().unwrap_or_default();
        (self.kernel.state, self.modes) = (state, modes);
        (self.kernel.origin, self.modal_call) = (origin, modal);
        self.kernel.call = caller;
        Some(commands)
    }

    /// Runs the program on top of the stack up to its end, or up to the block that begins at `last`.
    fn run_contour(&mut self, last: u32) {
        let depth = self.stack.len();
        while self.stack.len() >= depth {
            let next = self.running().reader.next();
            let block = next.filter(|block| self.stack.len() > depth || block.range.start <= last);
            let Some(block) = block else {
                match self.program_ends() {
                    BlockFlow::Next => continue,
                    BlockFlow::End(_) => break,
                }
            };
            if !self.kernel.count_repeated() {
                break;
            }
            if self.is_skipped(&block) {
                continue;
            }
            let flow = self.block(&block);
            if flow != BlockFlow::Next || self.stack.len() < depth {
                break;
            }
            self.part_ends(block.range.start);
        }
        while self.stack.len() >= depth {
            self.stack.pop();
            self.variables.locals.pop();
        }
    }
}
