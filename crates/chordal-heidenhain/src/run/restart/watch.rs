//! The run of a program up to the block that it is to begin at, and what holds there.

use chordal_command::CompensationSide;
use chordal_kernel::{EndReason, Modal};
use chordal_machine::AXES;

use super::definitions::{Definitions, follow_definition};
use super::functions::{LeftFunctions, functions_of};
use crate::run::interpreter::KlartextInterpreter;
use crate::run::run_state::{KlartextFlow, KlartextModes};
use crate::syntax::{KlartextBlock, KlartextStatement, ToolCallWords, ToolName};
use crate::values::ParameterStore;

/// The tool that the last TOOL CALL has called.
#[derive(Clone, Debug)]
pub(super) struct CalledTool {
    /// Its number, or its name in quotes.
    pub name: String,
    /// DL, DR and DR2, in program units.
    pub allowances: [f64; 3],
}

/// What holds before a block.
#[derive(Clone, Debug)]
pub(super) struct StateAtBlock {
    pub modes: KlartextModes,
    pub parameters: ParameterStore,
    pub modal: Modal,
    pub noted: Notes,
}

/// What a run leaves on its path to a block.
#[derive(Clone, Debug)]
pub(super) struct Notes {
    pub definitions: Definitions,
    pub functions: LeftFunctions,
    pub tool: Option<CalledTool>,
    /// The highest place of the tool axis with this tool and preset, in the coordinates of the preset, mm.
    pub highest: f64,
    /// The axes that the program has moved.
    pub moved: [bool; AXES],
    /// The axes that stand where M91 or M92 has brought them: the number of the function.
    pub to_machine: [Option<u32>; AXES],
    /// The line in which compensation became active.
    pub compensation: Option<u32>,
    /// The line in which a tilted plane or the guidance of the tip became active.
    pub frame: Option<u32>,
}

/// A run of which the blocks before one of the main program are noted.
pub(super) struct WatchedRun {
    /// What holds where the main program first comes to the block.
    pub state: Option<StateAtBlock>,
    /// How many times it comes to it.
    pub times: u32,
    /// The line of the call through which the block is first carried out.
    pub caller: Option<u32>,
    /// How the run ends.
    pub end: EndReason,
    /// Blocks of the main program were carried out before, and not only its own first lines.
    pub has_begun: bool,
}

impl KlartextInterpreter<'_> {
    /// Runs to the end and notes what holds where the main program comes to the block at a byte; blocks before `first` are its
    /// own first lines.
    pub(super) fn watch(mut self, at: u32, first: u32) -> WatchedRun {
        let mut run = WatchedRun {
            state: None,
            times: 0,
            caller: None,
            end: EndReason::EndOfText,
            has_begun: false,
        };
        let mut noted = Notes {
            definitions: Definitions::new(),
            functions: LeftFunctions::default(),
            tool: None,
            highest: f64::NEG_INFINITY,
            moved: [false; AXES],
            to_machine: [None; AXES],
            compensation: None,
            frame: None,
        };
        let mut main_line = 1;
        loop {
            let place = (self.running().reader.offset(), self.running().reader.line());
            let next = self.running().reader.clone().next();
            let next = next.filter(|next| {
                next.statement != KlartextStatement::Nothing && !self.is_skipped(next)
            });
            let is_own = self.stack.len() == 1;
            let is_main = is_own && self.running().returns.is_empty();
            if let Some(next) = &next {
                if is_own && next.range.start == at {
                    run.times += 1;
                    match is_main {
                        true if run.state.is_none() => {
                            // A cycle that is defined line by line ends before another block.
                            self.close_cycle(&next.statement);
                            run.state = Some(self.state_with(&noted));
                        }
                        true => {}
                        false => drop(run.caller.get_or_insert(main_line)),
                    }
                }
                if is_main {
                    main_line = next.line;
                }
            }
            let is_before = run.state.is_none();
            if is_before && let Some(next) = &next {
                if is_own && next.range.start < first {
                    // It stays in the text.
                } else {
                    run.has_begun = true;
                    follow_definition(&self, place, next, &mut noted.definitions);
                }
            }
            let before = is_before.then(|| self.modal());
            let flow = self.next_block(false);
            if let (Some(before), Some(next)) = (before, &next) {
                self.note(next, &before, &mut noted);
            }
            if let KlartextFlow::End(end) = flow {
                run.end = end;
                return run;
            }
        }
    }

    fn modal(&self) -> Modal {
        Modal::of(&self.kernel.state, Vec::new())
    }

    fn state_with(&self, noted: &Notes) -> StateAtBlock {
        StateAtBlock {
            modes: self.modes.clone(),
            parameters: self.parameters.clone(),
            modal: self.modal(),
            noted: noted.clone(),
        }
    }

    /// Takes what a block has left.
    fn note(&mut self, block: &KlartextBlock, before: &Modal, noted: &mut Notes) {
        let line = block.line;
        noted.functions.follow(self.text(), &block.statement, line);
        let after = self.modal();
        if after.side == CompensationSide::Off {
            noted.compensation = None;
        } else {
            noted.compensation.get_or_insert(line);
        }
        if self.modes.outside_plane.is_some() || self.follows_tip() {
            noted.frame.get_or_insert(line);
        } else {
            noted.frame = None;
        }
        if let KlartextStatement::ToolCall(words) = &block.statement
            && words.tool.is_some()
        {
            noted.tool = self.called_tool(words);
            noted.highest = f64::NEG_INFINITY;
        }
        if before.work != after.work {
            noted.highest = f64::NEG_INFINITY;
        }
        let has_moved = |axis: usize| before.machine_position[axis] != after.machine_position[axis];
        let functions = functions_of(&block.statement);
        let machine = functions.iter().map(|own| own.number).find(|own| matches!(own, 91 | 92));
        for axis in 0..AXES {
            let is_named = matches!(&block.statement, KlartextStatement::Path(_, words) if words.axes[axis].is_some());
            if has_moved(axis) || is_named {
                noted.moved[axis] = true;
                noted.to_machine[axis] = machine;
            }
        }
        // Coordinates of a tilted plane say nothing about those outside of it.
        let axis = self.tool_axis();
        let counts = machine.is_none() && noted.frame.is_none() && after.known.has(axis);
        if counts && (0..3).any(has_moved) {
            noted.highest = noted.highest.max(after.position[axis]);
        }
    }

    fn called_tool(&self, words: &ToolCallWords) -> Option<CalledTool> {
        let name = match &words.tool.as_ref()?.0 {
            ToolName::Number(number) => super::values::exact_number(self.value_of(*number)?, 1)?
                .trim_start_matches('+')
                .to_string(),
            ToolName::Text(text) => format!("\"{text}\""),
            ToolName::Parameter(number) => format!("\"{}\"", self.parameters.text(*number)?),
        };
        let allowances = words
            .allowances
            .map(|value| value.and_then(|value| self.value_of(value)).unwrap_or(0.0));
        Some(CalledTool { name, allowances })
    }
}
