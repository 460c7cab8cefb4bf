//! Reads blocks and carries them out in the order of the program.

use std::collections::{BTreeMap, HashMap, HashSet};

use chordal_command::{CallPath, CommandKind, CompensationSide, Origin, Units};
use chordal_diagnostics::{Code, Diagnostic, FileId, Severity, Span, TextRange};
use chordal_kernel::{
    CompletedRun, EndReason, Kernel, Modal, Outcome, ProgramName, RunSink, State,
};
use chordal_machine::Tool;

use super::program_texts::KlartextTexts;
use super::run_state::{KlartextFlow, KlartextModes, RunningKlartext};
use crate::alarms::{DOUBLE_PROGRAMMED, LABEL_TWICE};
use crate::syntax::{KlartextBlock, KlartextFault, KlartextFaultKind, KlartextStatement};
use crate::values::ParameterStore;

/// Blocks between two questions whether the run is to end.
const INTERRUPT_BLOCKS: u64 = 1024;

/// Runs one program.
pub struct KlartextInterpreter<'a> {
    pub(super) programs: &'a KlartextTexts<'a>,
    pub(super) kernel: Kernel<'a>,
    pub(super) stack: Vec<RunningKlartext<'a>>,
    pub(super) parameters: ParameterStore,
    pub(super) modes: KlartextModes,
    /// The tools as TOOL DEF or the machine file gives them, without the allowances of TOOL CALL.
    pub(super) tools: HashMap<u32, Tool>,
    pub(super) missing: Vec<ProgramName>,
    /// The subjects of problems that are reported once.
    pub(super) reported: HashSet<String>,
    /// The text of the block that is carried out.
    pub(super) here: TextRange,
    blocks: u64,
}

impl<'a> KlartextInterpreter<'a> {
    /// At the start of a program.
    pub fn new(
        programs: &'a KlartextTexts<'a>,
        program: usize,
        sink: &'a mut (dyn RunSink + 'a),
    ) -> KlartextInterpreter<'a> {
        let (control, machine) = (programs.control, programs.machine);
        let offsets = control.initial_offsets(machine);
        let home = machine.home.map(|place| place.unwrap_or(0.0));
        let state = State::new(control.rules(), offsets, home);
        let alarms = control.profile().alarms();
        let mut kernel = Kernel::new(control.rules(), machine, alarms, state, sink);
        kernel.max_repeated = programs.options.max_repeated_blocks;
        let tools = machine.tools.iter().map(|(number, tool)| (*number, tool.clone())).collect();
        let mut parameters = ParameterStore::default();
        parameters.unset_is_zero = !programs.settings.unset_is_error;
        let mut interpreter = KlartextInterpreter {
            programs,
            kernel,
            stack: Vec::new(),
            parameters,
            modes: KlartextModes::default(),
            tools,
            missing: Vec::new(),
            reported: HashSet::new(),
            here: TextRange::default(),
            blocks: 0,
        };
        interpreter.begin_program(program, CallPath::default());
        interpreter
    }

    /// Puts a program on the stack.
    pub(super) fn begin_program(&mut self, program: usize, call: CallPath) {
        let running = RunningKlartext {
            program,
            reader: self.programs.reader(program),
            call,
            returns: Vec::new(),
            repeats: BTreeMap::new(),
            labels: BTreeMap::new(),
            callers_locals: self.parameters.take_locals(),
            caller_is_inch: self.modes.is_inch,
            last_number: None,
        };
        self.stack.push(running);
        self.kernel.call = call;
        self.find_labels();
        let is_inch = self.programs.texts[program].head.as_ref().is_some_and(|head| head.is_inch);
        self.set_unit(is_inch);
    }

    /// The unit of the program that runs now.
    pub(super) fn set_unit(&mut self, is_inch: bool) {
        self.modes.is_inch = is_inch;
        self.kernel.set_units(if is_inch { Units::Inch } else { Units::Millimetre });
        self.parameters.set_shared(113, if is_inch { 1.0 } else { 0.0 });
    }

    /// One unit of length of the program, mm.
    pub(super) fn unit_mm(&self) -> f64 {
        if self.modes.is_inch { 25.4 } else { 1.0 }
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
    pub(super) fn running(&mut self) -> &mut RunningKlartext<'a> {
        let last = self.stack.len() - 1;
        &mut self.stack[last]
    }

    /// A part of the running program's text as a span.
    pub(super) fn span(&self, range: TextRange) -> Span {
        range.in_file(self.file())
    }

    /// Runs to the end.
    pub fn run(mut self) -> CompletedRun {
        self.check_frame_of_program();
        let wants_blocks = self.kernel.sink.wants_blocks();
        let end = loop {
            if let KlartextFlow::End(reason) = self.next_block(wants_blocks) {
                break reason;
            }
        };
        self.kernel.end_corners();
        self.check_end(end);
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

    /// Compensation that is still active at the end.
    fn check_end(&mut self, end: EndReason) {
        let is_end = matches!(end, EndReason::ProgramEnd | EndReason::EndOfText);
        if is_end && self.kernel.state.side != CompensationSide::Off {
            let message = "the program ends and tool radius compensation is active";
            let span = self.kernel.origin.span;
            let diagnostic = Diagnostic::new(Code::CompensationAtEnd, span, message);
            self.kernel.report(diagnostic.help("leave the contour with DEP or with R0"));
        }
    }

    /// Reads and carries out a block.
    pub(super) fn next_block(&mut self, wants_blocks: bool) -> KlartextFlow {
        let Some(block) = self.running().reader.next() else {
            return self.program_ends();
        };
        let is_skipped = self.is_skipped(&block);
        let is_empty = block.statement == KlartextStatement::Nothing && block.faults.is_empty();
        if is_skipped || is_empty {
            let counts = self.repeats_counted() && !self.kernel.count_repeated();
            return if counts { KlartextFlow::End(EndReason::Budget) } else { KlartextFlow::Next };
        }
        if self.repeats_counted() && !self.kernel.count_repeated() {
            return KlartextFlow::End(EndReason::Budget);
        }
        self.blocks += 1;
        if self.blocks.is_multiple_of(INTERRUPT_BLOCKS)
            && self.programs.options.interrupt.as_ref().is_some_and(|interrupt| interrupt())
        {
            return KlartextFlow::End(EndReason::Interrupted);
        }
        let flow = self.block(&block);
        if wants_blocks {
            let codes = self.active_functions();
            self.kernel.block_done(&|state| Modal::of(state, codes.clone()));
        }
        flow
    }

    /// Whether the switch for that leaves a block out.
    pub(super) fn is_skipped(&self, block: &KlartextBlock) -> bool {
        let switches = &self.programs.machine.switches.block_delete;
        block.is_skippable && switches.first().copied().unwrap_or(false)
    }

    /// Blocks count against the budget where calls, repeats or jumps may run without end.
    fn repeats_counted(&mut self) -> bool {
        self.stack.len() > 1
            || self.modes.has_jumped_back
            || !self.running().returns.is_empty()
            || !self.running().repeats.is_empty()
    }

    /// Carries out a block.
    fn block(&mut self, block: &KlartextBlock) -> KlartextFlow {
        let (file, call) = (self.file(), self.running().call);
        self.here = block.range;
        self.kernel.call = call;
        self.kernel.origin =
            Origin { span: block.range.in_file(file), line: block.line, call, cycle: false };
        self.modes.block_number = block.number;
        if let Some(number) = block.number {
            self.kernel.block_number = Some(f64::from(number));
            self.check_number(number, block.range);
        }
        block.faults.iter().for_each(|fault| self.report_fault(fault));
        self.close_cycle(&block.statement);
        self.statement(block)
    }

    /// Numbers that go back: blocks were mixed up, or parts of two programs.
    fn check_number(&mut self, number: u32, range: TextRange) {
        let last = self.running().last_number.replace(number);
        let Some(last) = last.filter(|last| *last > number) else { return };
        if self.is_first_report("block numbers") {
            let message = format!("block number {number} comes after {last}");
            let diagnostic = Diagnostic::new(Code::HeaderOutOfPlace, self.span(range), message);
            self.kernel.report(
                diagnostic
                    .severity(Severity::Warning)
                    .label("the order of the text is carried out")
                    .help("the control numbers blocks anew; check that no part is missing or in a wrong place"),
            );
        }
    }

    /// True the first time that a run asks for a subject; for problems that are reported once.
    pub(super) fn is_first_report(&mut self, subject: &str) -> bool {
        self.reported.insert(subject.to_string())
    }

    fn report_fault(&mut self, fault: &KlartextFault) {
        let (code, alarm) = match fault.kind {
            KlartextFaultKind::Unreadable => (Code::BadStatement, None),
            KlartextFaultKind::UnknownFunction => (Code::UnknownCode, None),
            KlartextFaultKind::DoubleWord => (Code::RepeatedWord, Some(DOUBLE_PROGRAMMED)),
            KlartextFaultKind::MissingValue => (Code::MissingValue, None),
            KlartextFaultKind::MissingAddress => (Code::MissingAddress, None),
            KlartextFaultKind::LetterForDigit => (Code::LetterForDigit, None),
            KlartextFaultKind::Bracket => (Code::UnbalancedBrackets, None),
            KlartextFaultKind::Spelling => (Code::BadStatement, None),
        };
        let diagnostic = Diagnostic::new(code, self.span(fault.range), fault.message.clone());
        match (fault.kind, alarm) {
            (KlartextFaultKind::Spelling, _) => {
                self.kernel.report(diagnostic.severity(Severity::Warning));
            }
            (_, Some(alarm)) => self.report_alarm(alarm, diagnostic),
            (_, None) => self.kernel.report(diagnostic),
        }
    }

    /// Reports a label that stands twice.
    pub(super) fn report_double_label(&mut self, range: TextRange, name: &str, first_line: u32) {
        let message = format!("label {name} stands on line {first_line} already");
        let diagnostic = Diagnostic::new(Code::DuplicateProgram, self.span(range), message);
        self.report_alarm(LABEL_TWICE, diagnostic.help("give one of the two another number"));
    }
}
