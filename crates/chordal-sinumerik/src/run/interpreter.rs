//! Reads blocks and carries them out in the order of the program.

use std::collections::{HashMap, HashSet};

use chordal_command::{AxisMask, CallPath, CommandKind, Origin};
use chordal_diagnostics::{Code, Diagnostic, FileId, Severity, Span, TextRange};
use chordal_kernel::{
    CompletedRun, EndReason, Kernel, Modal, Outcome, ProgramName, RunSink, State,
};

use super::active_codes::active_codes;
use super::program_texts::{ProgramTexts, procedure_of};
use super::run_state::{BlockFlow, LanguageModes, ModalCycle, RunningProgram, TransverseReading};
use super::scope::ValueScope;
use super::system_variables::SystemState;
use super::variables::{ProgramVariable, VariableStore};
use super::words::BlockWords;
use crate::syntax::{Expression, ExpressionKind, ProgramBlock, ProgramUnitKind};
use crate::values::{SinumerikValue, evaluate};

/// Blocks between two questions whether the run is to end.
const INTERRUPT_BLOCKS: u64 = 1024;

/// Runs one program.
pub struct Interpreter<'a> {
    pub(super) programs: &'a ProgramTexts<'a>,
    pub(super) kernel: Kernel<'a>,
    pub(super) stack: Vec<RunningProgram<'a>>,
    pub(super) variables: VariableStore,
    pub(super) modes: LanguageModes,
    pub(super) modal_call: Option<ModalCycle>,
    pub(super) missing: Vec<ProgramName>,
    /// The subjects of problems that are reported once.
    pub(super) reported: HashSet<String>,
    /// How often a condition of unknown value was assumed, by file and offset.
    pub(super) assumed: HashMap<(FileId, u32), u32>,
    /// Tables of the control next to the program list its tools.
    pub(super) has_tool_tables: bool,
    /// The edges of tools that a table of the control or the program gives: tool and edge.
    pub(super) listed_edges: HashSet<(u32, u32)>,
    /// Numbers of tools by the names that the program gives them (`$TC_TP2`).
    pub(super) tool_names: HashMap<String, u32>,
    /// The texts of macros by their names.
    pub(super) macros: HashMap<String, Span>,
    /// Where the block uses a macro of another file; `None` if it does not.
    pub(super) macro_use: Option<TextRange>,
    blocks: u64,
}

impl<'a> Interpreter<'a> {
    /// At the start of a program.
    pub fn new(
        programs: &'a ProgramTexts<'a>,
        program: usize,
        sink: &'a mut (dyn RunSink + 'a),
    ) -> Interpreter<'a> {
        let (control, machine) = (programs.control, programs.machine);
        let offsets = control.initial_offsets(machine);
        let home = machine.home.map(|place| place.unwrap_or(0.0));
        let state = State::new(control.rules(), offsets, home);
        let alarms = control.profile().alarms();
        let mut kernel = Kernel::new(control.rules(), machine, alarms, state, sink);
        kernel.max_repeated = programs.options.max_repeated_blocks;
        let first = RunningProgram::new(program, programs.reader(program), CallPath::default());
        let mut variables = VariableStore::default();
        variables.r_count = programs.settings.r_parameters;
        variables.locals.push(HashMap::<String, ProgramVariable>::new());
        let mut interpreter = Interpreter {
            programs,
            kernel,
            stack: vec![first],
            variables,
            modes: LanguageModes::default(),
            modal_call: None,
            missing: Vec::new(),
            reported: HashSet::new(),
            assumed: HashMap::new(),
            has_tool_tables: false,
            listed_edges: HashSet::new(),
            tool_names: HashMap::new(),
            macros: HashMap::new(),
            macro_use: None,
            blocks: 0,
        };
        interpreter.read_tables();
        interpreter
    }

    /// The file of the running program.
    pub(super) fn file(&self) -> FileId {
        self.stack.last().map_or(FileId(0), |running| self.programs.texts[running.program].file)
    }

    /// The text of the running program's file.
    pub(super) fn text(&self) -> &'a [u8] {
        self.programs.text(self.file())
    }

    /// The running program.
    pub(super) fn running(&mut self) -> &mut RunningProgram<'a> {
        let last = self.stack.len() - 1;
        &mut self.stack[last]
    }

    /// Runs to the end.
    pub fn run(mut self) -> CompletedRun {
        let program = self.running().program;
        let head = procedure_of(&mut self.programs.reader(program));
        if let Some((range, head)) = head.filter(|(_, head)| !head.parameters.is_empty()) {
            return self.without_caller(range, &head.name);
        }
        self.begin_subprogram();
        let wants_blocks = self.kernel.sink.wants_blocks();
        let end = self.run_blocks(wants_blocks);
        self.kernel.end_corners();
        if end == EndReason::ProgramEnd || end == EndReason::EndOfText {
            self.kernel.emit(CommandKind::End);
        }
        let outcome = Outcome {
            end,
            blocks: self.blocks,
            calls: self.kernel.calls,
            missing_programs: self.missing,
        };
        CompletedRun { outcome, text_read: None }
    }

    /// A program with parameters is not run without the program that calls it.
    fn without_caller(mut self, range: TextRange, name: &str) -> CompletedRun {
        let message =
            format!("{name} has parameters and is not run without the program that calls it");
        let diagnostic = Diagnostic::new(Code::MacroAlone, self.span(range), message);
        self.kernel.report(diagnostic.help("give the program that calls it, or both in one file"));
        // One block, so that the text does not count as empty.
        let outcome = Outcome {
            end: EndReason::NotRun,
            blocks: 1,
            calls: self.kernel.calls,
            missing_programs: Vec::new(),
        };
        CompletedRun { outcome, text_read: None }
    }

    /// A subprogram that is run by itself: nobody knows what its caller has set.
    fn begin_subprogram(&mut self) {
        let text = &self.programs.texts[self.running().program];
        if text.unit.kind != ProgramUnitKind::Sub {
            return;
        }
        self.lose_state();
        let message =
            format!("{} is a subprogram: what its caller has set is not known", text.name);
        let span = Span { file: text.file, range: text.unit.head };
        let diagnostic = Diagnostic::new(Code::MacroAlone, span, message);
        self.kernel.report(diagnostic.help("run the program that calls it to verify both"));
    }

    fn run_blocks(&mut self, wants_blocks: bool) -> EndReason {
        loop {
            let flow = match self.next_plain_line() {
                Some(line) => match self.count_block() {
                    Some(reason) => return reason,
                    None => {
                        self.plain_line(&line);
                        self.block_ends(line.range.start, BlockFlow::Next, wants_blocks)
                    }
                },
                None => self.next_block(wants_blocks),
            };
            if let BlockFlow::End(reason) = flow {
                return reason;
            }
        }
    }

    /// Reads and carries out a block.
    fn next_block(&mut self, wants_blocks: bool) -> BlockFlow {
        let Some(block) = self.running().reader.next() else { return self.program_ends() };
        if self.is_skipped(&block) {
            return match self.repeats_counted() && !self.kernel.count_repeated() {
                true => BlockFlow::End(EndReason::Budget),
                false => BlockFlow::Next,
            };
        }
        if let Some(reason) = self.count_block() {
            return BlockFlow::End(reason);
        }
        let block = if self.macros.is_empty() { block } else { self.expanded(block) };
        let flow = self.block(&block);
        self.block_ends(block.range.start, flow, wants_blocks)
    }

    /// Counts a block; the reason if the run ends before it.
    fn count_block(&mut self) -> Option<EndReason> {
        if self.repeats_counted() && !self.kernel.count_repeated() {
            return Some(EndReason::Budget);
        }
        self.blocks += 1;
        let checks_interrupt = self.blocks.is_multiple_of(INTERRUPT_BLOCKS);
        (checks_interrupt && self.is_interrupted()).then_some(EndReason::Interrupted)
    }

    /// After a block, which began at an offset of its text: goes on as the block says, or as the part that ends with it.
    fn block_ends(&mut self, start: u32, flow: BlockFlow, wants_blocks: bool) -> BlockFlow {
        if wants_blocks {
            let modes = &self.modes;
            self.kernel.block_done(&|state| Modal::of(state, active_codes(modes, state)));
        }
        match flow {
            BlockFlow::Next => self.part_ends(start),
            end @ BlockFlow::End(_) => end,
        }
    }

    /// Blocks count against the budget where calls, loops, repeats or jumps may run without end.
    fn repeats_counted(&mut self) -> bool {
        self.stack.len() > 1 || self.modes.has_jumped_back || !self.running().repeats.is_empty()
    }

    fn is_interrupted(&self) -> bool {
        self.programs.options.interrupt.as_ref().is_some_and(|interrupt| interrupt())
    }

    /// Whether the block delete switch leaves a block out.
    pub(super) fn is_skipped(&self, block: &ProgramBlock) -> bool {
        let switches = &self.programs.machine.switches.block_delete;
        block
            .skip_level
            .is_some_and(|level| switches.get(usize::from(level)).copied().unwrap_or(false))
    }

    /// Carries out a block.
    pub(super) fn block(&mut self, block: &ProgramBlock) -> BlockFlow {
        let (file, call) = (self.file(), self.running().call);
        self.kernel.call = call;
        self.kernel.origin =
            Origin { span: block.range.in_file(file), line: block.line, call, cycle: false };
        if let Some(number) = block.number {
            self.kernel.block_number = Some(f64::from(number.number));
        }
        for fault in &block.faults {
            self.alarm(12080, Code::BadStatement, fault.range, fault.message.clone());
        }
        for range in &block.doubtful_comparisons {
            let message = "comparisons bind less than AND, OR and XOR: this is compared with the result of the operator";
            let diagnostic = Diagnostic::new(Code::BadExpression, self.span(*range), message);
            let help = "write the comparisons in parentheses if they were meant to come first";
            self.kernel.report(diagnostic.severity(Severity::Warning).help(help));
        }
        if let Some(flow) = self.flow_statement(block) {
            return flow;
        }
        let words = self.collect(block);
        self.carry_out(block, &words)
    }

    /// Carries out the words of a block in the order of the control: modes, tool, speed and feed, motion, and what comes
    /// at the end of the block.
    fn carry_out(&mut self, block: &ProgramBlock, words: &BlockWords) -> BlockFlow {
        let range = block.range;
        self.set_modes(words);
        self.set_frames(range, words);
        self.set_tool(words);
        self.set_feed_and_speed(words);
        self.functions_before(words);
        self.set_compensation(range, words);
        let has_moved = self.moves(range, words);
        if words.positioned != AxisMask::NONE {
            // They move at their own pace, and not to the end before the next block begins (POSA).
            self.kernel.go_astray(words.positioned);
            self.lose_path(range, "where the axis is", "the motion of POS");
        }
        self.end_block_modes(words);
        if has_moved && let flow @ BlockFlow::End(_) = self.fire_modal_call(range) {
            return flow;
        }
        self.functions_after(words)
    }

    /// The value of an expression; a problem is reported, and `None` returned.
    pub(super) fn value(&mut self, expression: &Expression) -> Option<SinumerikValue> {
        // Nearly all values are numbers, which need nothing of the program.
        match expression.kind {
            ExpressionKind::Real(number) if number.is_finite() => {
                return Some(SinumerikValue::Real(number));
            }
            ExpressionKind::Integer(number) if i32::try_from(number).is_ok() => {
                return Some(SinumerikValue::Integer(number as i32));
            }
            _ => {}
        }
        let value = evaluate(expression, &mut self.scope());
        self.report_unset_reads();
        self.report_undefined_names();
        match value {
            Ok(value) => Some(value),
            Err(error) => {
                self.report_evaluation(error);
                None
            }
        }
    }

    /// What expressions read in this block.
    pub(super) fn scope(&mut self) -> ValueScope<'_> {
        let unit = self.unit_mm();
        let place = self.programmed_position();
        let state = &self.kernel.state;
        let known = self.modes.frame.reached(state.known);
        let turns = self.kernel.machine.turns();
        let is_diameter = turns && self.modes.transverse != TransverseReading::Radius;
        let position = std::array::from_fn(|axis| {
            let scale = if axis == 0 && is_diameter { 2.0 } else { 1.0 };
            known.has(axis).then_some(scale * place[axis] / unit)
        });
        let passed_parameters =
            self.stack.last().map_or(&[][..], |running| &running.passed_parameters);
        ValueScope {
            variables: &mut self.variables,
            system: SystemState {
                state,
                modes: &self.modes,
                position,
                turns,
                has_modal_call: self.modal_call.is_some(),
                level: self.stack.len() - 1,
                passed_parameters,
            },
        }
    }

    /// The number of an expression; a problem is reported, and `None` returned. A value that is not known loses the
    /// path.
    pub(super) fn number(&mut self, expression: &Expression) -> Option<f64> {
        let value = self.value(expression)?;
        if let Some(cause) = value.unknown_cause() {
            self.lose_path(expression.range, "this", &cause.clone());
            return None;
        }
        self.number_of(&value, expression.range)
    }

    /// The number of a known value; a problem is reported, and `None` returned.
    pub(super) fn number_of(&mut self, value: &SinumerikValue, range: TextRange) -> Option<f64> {
        let number = value.to_real().ok();
        if number.is_none() {
            self.alarm(12150, Code::BadExpression, range, "this is no number");
        }
        number.filter(|number| number.is_finite())
    }

    /// A whole number that is not negative.
    pub(super) fn count(&mut self, expression: &Expression) -> Option<u32> {
        let number = self.number(expression)?.round();
        (0.0..=f64::from(u32::MAX)).contains(&number).then_some(number as u32)
    }

    /// The range of the text that follows from here on, for messages of a whole program.
    pub(super) fn here(&self) -> TextRange {
        self.kernel.origin.span.range
    }
}
