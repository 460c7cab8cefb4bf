//! Runs a program: reads blocks, carries them out, follows calls.
//!
//! One file per concern: `block` collects the codes of a block and carries them out in the order of the control;
//! `conflicts` checks which words may be combined; `modes` sets modes; `motion`, `arc`, `spiral`, `reference` and
//! `cycle` move; `offsets` writes tables; `calls` follows subprograms; `repeats` counts them; `custom_codes` calls the
//! hook for custom codes; `literals` converts words to millimetres; `report` builds the diagnostics.

mod active_codes;
mod angle;
mod arc;
mod block;
mod calls;
mod channels;
mod checkpoint;
mod command_line;
mod conflicts;
mod context;
mod corner;
mod custom_codes;
mod cycle;
mod effects;
mod engraving;
mod firmware;
mod frames;
mod literals;
mod live_tool;
mod macros;
mod modes;
mod motion;
mod offsets;
mod path_modes;
mod pocket;
mod polar;
mod reference;
mod repairs;
mod repeats;
mod report;
mod spatial;
mod spiral;
mod spline;
mod statement;
mod surface;
mod thread;
mod thread_height;
mod tilted_plane;
mod tool_length;
mod tool_vector;
mod turning;
mod turning_contour;
mod turning_subroutine;
mod turning_tool;
mod work_offsets;

pub use self::calls::subroutine_head;

use active_codes::active_codes;
use chordal_command::{
    AxisMask, CallPath, CallPaths, CommandKind, CompensationSide, Origin, Units,
};
use chordal_dialect::macros::MacroForm;
use chordal_dialect::{CodeRow, Control};
use chordal_kernel::{Modal, ProgramName, RunOptions, State};
use statement::BlockStatement;
use std::cell::Cell;
use std::collections::{BTreeMap, BTreeSet, HashMap};

use chordal_diagnostics::{Code, FileId, Span, TextRange};
use chordal_dialect::LiteralScale;
use chordal_kernel::{Checkpoint, CompletedRun, EndReason, Kernel, Outcome, RunSink};
use chordal_machine::{Machine, PerAxis, StartingKinematics};
use chordal_syntax::{Block, BlockKind, BlockPosition as TextPosition, BlockReader, Decimal};

use crate::firmware::FirmwareChecker;
use crate::initial_offsets::{NATIVE, initial_offsets};
use crate::library::{Library, Program};
use crate::macro_alone::missing_call;

/// The interrupt hook is called once per this many blocks: less than a millisecond apart, at negligible cost.
const BLOCKS_PER_INTERRUPT_CHECK: u64 = 1024;

/// Number of words of a usual block; a longer one counts as several against the budget.
const USUAL_WORDS: usize = 12;

/// How to continue after a block.
enum BlockFlow {
    Next,
    End(EndReason),
}

/// A call that has not returned.
struct CallFrame<'a> {
    /// The reader of the caller, at the block to return to.
    reader: BlockReader<'a>,
    program: usize,
    path: CallPath,
    /// The start of the called text, for its repeats.
    start: TextPosition,
    /// Repeats still to make.
    remaining: u32,
    /// The callee is an L subroutine.
    subroutine: bool,
    /// Loops of the caller.
    loops: Vec<macros::ActiveLoop>,
    /// Number of modal macro calls that are active in the caller.
    modal_calls: usize,
    /// The called program has local variables of its own.
    own_locals: bool,
    /// It was called by a code that a setting makes a call.
    by_alias: bool,
    /// The called text is the answer to a custom code: its end is a return.
    of_shop: bool,
    /// X and Y at the call, mm.
    entry: [f64; 2],
    /// G41 or G42 of a contour in G91 that leads in from `entry`; `None` without one, and if called several times.
    contour: Option<Span>,
}

struct Interpreter<'a> {
    library: &'a Library<'a>,
    control: &'a Control,
    machine: &'a Machine,
    options: &'a RunOptions,
    /// The running control.
    kernel: Kernel<'a>,
    /// How literals become millimetres in the active units.
    scale: LiteralScale,
    /// Factor of axis words: 1, or 0.5 for diameters.
    per_word: PerAxis<f64>,
    /// Registers R0 to R9 (Fadal); `None` for the unknown value from before the program.
    registers: [Option<Decimal>; 10],
    reader: BlockReader<'a>,
    program: usize,
    file: FileId,
    frames: Vec<CallFrame<'a>>,
    /// L subroutines of the main program: number → first block.
    subroutines: BTreeMap<u32, TextPosition>,
    /// The N numbers of each program with a jump.
    labels: HashMap<usize, HashMap<i64, Vec<TextPosition>>>,
    jumps: HashMap<u32, u32>,
    missing: Vec<u32>,
    blocks: u64,
    /// The lines are data until G11.
    data_lines: bool,
    /// The last N number, for alarms.
    sequence: Option<Decimal>,
    codes: Vec<(&'static CodeRow, usize)>,
    reported: ReportedOnce,
    lost_jump: bool,
    /// The program has set its units: they are not those of power-on.
    units_programmed: bool,
    /// The units of F in this block, if the block changes units after F is read; `None` otherwise.
    units_of_feed: Option<Units>,
    /// The feed that the last F set, in the unit of the state, and the number of that F.
    feed_number: Option<(f64, f64)>,
    carried_out: bool,
    /// The previous block was a comment without its parentheses, or with an open one.
    in_remark: bool,
    macros: macros::MacroState<'a>,
    /// Tilted work planes.
    spatial: spatial::SpatialState,
    /// A tilted plane of which not all blocks have come; `None` without one.
    open_plane: Option<tilted_plane::OpenPlane>,
    /// The state of spline blocks (G5, G5.2).
    spline: spline::SplineMemory,
    /// Blocks of the main program before this offset are repeats after a backward jump; 0 without one.
    repeat_until: u32,
    /// The comment next to an assigned value (`#3000=1(TEXT)`), during the assignment.
    message: Option<TextRange>,
    /// The block has `,R` or `,C` that no move has used.
    open_corner: bool,
    /// A line with only an angle, which waits for the next block.
    open_line: Option<angle::OpenLine>,
    /// A percent sign precedes the blocks of the program.
    begun_by_percent: bool,
    /// A percent sign has ended the program.
    ended_by_percent: bool,
    /// Set when a statement ends the run.
    stopped: Option<EndReason>,
    shop: custom_codes::ShopState,
    /// The modes that M70 and M73 keep, outermost call first.
    kept_modes: Vec<context::KeptModes>,
    /// Reference points that the program has stored: machine position, mm and rad.
    references: [PerAxis<Option<f64>>; 2],
    /// The checker of whole blocks, for controls with such a firmware.
    judge: Option<FirmwareChecker>,
    /// The part of the first text read since the last checkpoint in addition to the blocks in their order.
    text_read_outside: Cell<Option<TextRange>>,
    /// The values of the control as last emitted.
    recorded: effects::WrittenState,
}

/// Problems that are reported once, not for every block.
#[derive(Clone, Default, Debug, PartialEq)]
struct ReportedOnce {
    axes: AxisMask,
    /// M codes without any definition.
    open_codes: BTreeSet<i64>,
    /// G codes of another code system than that of the machine.
    other_system: BTreeSet<u16>,
    points_seen: bool,
    excess_decimals: bool,
    sender_changes_tools: bool,
    /// Increments while the length acts along the tool.
    incremental_along_tool: bool,
    /// A deletable block that affects others.
    deletable: bool,
    /// Another channel, and the second spindle of a lathe.
    channels: bool,
    second_spindle: bool,
    /// A move of the second spindle that does not affect the tools.
    second_spindle_noted: bool,
}

/// Runs one program of a library and emits its commands into a sink.
pub fn run<'a>(
    library: &'a Library<'a>,
    program: usize,
    machine: &'a Machine,
    control: &'a Control,
    options: &'a RunOptions,
    sink: &'a mut (dyn RunSink + 'a),
) -> Outcome {
    let outcome = Interpreter::new(library, program, machine, control, options, sink).outcome();
    outcome.map(|ran| ran.outcome).unwrap_or_else(|| Outcome {
        end: EndReason::Interrupted,
        blocks: 0,
        calls: CallPaths::default(),
        missing_programs: Vec::new(),
    })
}

/// The same, from a checkpoint if there is one. `None` when the sink stopped the run at a checkpoint.
pub fn run_from<'a>(
    library: &'a Library<'a>,
    program: usize,
    machine: &'a Machine,
    control: &'a Control,
    options: &'a RunOptions,
    sink: &'a mut (dyn RunSink + 'a),
    from: Option<&Checkpoint>,
) -> Option<CompletedRun> {
    let mut interpreter = Interpreter::new(library, program, machine, control, options, sink);
    if let Some(checkpoint) = from {
        interpreter.take_up(checkpoint);
    }
    interpreter.outcome()
}

impl<'a> Interpreter<'a> {
    fn new(
        library: &'a Library<'a>,
        program: usize,
        machine: &'a Machine,
        control: &'a Control,
        options: &'a RunOptions,
        sink: &'a mut (dyn RunSink + 'a),
    ) -> Interpreter<'a> {
        let offsets = initial_offsets(control, machine);
        let home = machine.home.map(|place| place.unwrap_or(0.0));
        let rules = &control.parameters.rules;
        let mut kernel =
            Kernel::new(rules, machine, control.alarms(), State::new(rules, offsets, home), sink);
        kernel.max_repeated = options.max_repeated_blocks;
        let mut per_word = machine.written_factors().map(f64::recip);
        if control.parameters.starts_with_radii {
            per_word[0] = 1.0;
        }
        Interpreter {
            library,
            control,
            machine,
            options,
            kernel,
            scale: LiteralScale::new(control.parameters.rules.units, &control.parameters),
            per_word,
            registers: [None; 10],
            reader: library.reader(library.programs()[program], control.table.lexicon),
            program,
            file: library.programs()[program].file,
            frames: Vec::new(),
            subroutines: BTreeMap::new(),
            labels: HashMap::new(),
            jumps: HashMap::new(),
            spatial: spatial::SpatialState::default(),
            open_plane: None,
            spline: spline::SplineMemory::default(),
            missing: Vec::new(),
            blocks: 0,
            data_lines: false,
            sequence: None,
            codes: Vec::new(),
            reported: ReportedOnce::default(),
            lost_jump: false,
            units_programmed: false,
            units_of_feed: None,
            feed_number: None,
            carried_out: false,
            in_remark: false,
            macros: macros::MacroState::new(control.table, machine),
            repeat_until: 0,
            message: None,
            open_corner: false,
            open_line: None,
            begun_by_percent: false,
            ended_by_percent: false,
            stopped: None,
            shop: custom_codes::ShopState::new(program),
            kept_modes: Vec::new(),
            references: macros::initial_references(machine, control),
            judge: None,
            text_read_outside: Cell::new(None),
            recorded: effects::WrittenState::default(),
        }
        .with_judge()
        .with_values_recorded()
    }

    fn outcome(mut self) -> Option<CompletedRun> {
        let end = self.run()?;
        self.finish(end);
        let outcome = Outcome {
            end,
            blocks: self.blocks,
            calls: self.kernel.calls,
            missing_programs: self.missing.into_iter().map(ProgramName::Number).collect(),
        };
        Some(CompletedRun { outcome, text_read: self.text_read_outside.take() })
    }

    /// The reason of the end; `None` when the sink stopped the run at a checkpoint.
    fn run(&mut self) -> Option<EndReason> {
        if self.blocks == 0 {
            if self.needs_caller() {
                return Some(EndReason::NotRun);
            }
            self.read_subroutine_section();
            if self.machine.starting_kinematics == Some(StartingKinematics::Tip) {
                self.kernel.switch_kinematics(true);
            }
        }
        let wants_blocks = self.kernel.sink.wants_blocks();
        let mut next_checkpoint = self.kernel.sink.next_checkpoint();
        let mut block = Block::new();
        loop {
            if self.reader.position().offset >= next_checkpoint && self.is_settled() {
                let checkpoint = self.checkpoint();
                self.reported.excess_decimals = false;
                if self.kernel.sink.checkpoint(checkpoint, self.text_read_outside.take()).is_break()
                {
                    return None;
                }
                next_checkpoint = self.kernel.sink.next_checkpoint();
            }
            while !self.reader.read(&mut block) {
                if self.frames.is_empty() {
                    return Some(EndReason::EndOfText);
                }
                self.text_ended_in_call();
            }
            if !self.frames.is_empty() || self.is_repeat(&block) {
                // A line of hundreds of words takes as long as many usual blocks.
                self.kernel.repeated += (block.words.len() / USUAL_WORDS) as u64;
                if !self.kernel.count_repeated() {
                    return Some(EndReason::Budget);
                }
            }
            if self.blocks.is_multiple_of(BLOCKS_PER_INTERRUPT_CHECK) && self.is_interrupted() {
                return Some(EndReason::Interrupted);
            }
            let flow = self.execute(&mut block);
            self.emit_written();
            if block.commas || self.kernel.waits_at_corner() {
                self.end_corner_block(&block);
            }
            if wants_blocks {
                let control = self.control;
                self.kernel.block_done(&|state| Modal::of(state, active_codes(state, control)));
            }
            match flow {
                BlockFlow::Next => {}
                BlockFlow::End(reason) => return Some(reason),
            }
        }
    }

    /// True for a macro that needs arguments of a caller, which is reported and not run.
    fn needs_caller(&mut self) -> bool {
        let program = self.program_at(self.program);
        let Some(missing) = missing_call(self.library, program, self.control) else { return false };
        // So that the text does not count as empty.
        self.blocks = 1;
        self.report_macro_alone(&missing);
        true
    }

    fn is_interrupted(&self) -> bool {
        self.options.interrupt.as_ref().is_some_and(|interrupt| interrupt())
    }

    fn finish(&mut self, end: EndReason) {
        self.lose_open_line("the program ends before it");
        self.end_open_plane();
        self.kernel.end_corners();
        self.print_pending();
        if end == EndReason::EndOfText {
            self.report_missing_end();
        }
        self.report_compensation_at_end();
        self.report_unknown_variables();
        if end == EndReason::EndOfText {
            self.kernel.emit(CommandKind::End);
        }
        self.emit_retained_variables();
    }

    #[inline]
    fn execute(&mut self, block: &mut Block) -> BlockFlow {
        self.blocks += 1;
        self.kernel.origin = Origin {
            span: Span { file: self.file, range: block.range },
            line: block.line,
            call: self.kernel.call,
            cycle: false,
        };
        if self.judge.is_some()
            && let Some(flow) = self.judged_by_firmware(block)
        {
            return flow;
        }
        if self.control.table.command_line.is_some()
            && let Some(flow) = self.take_command_line(block)
        {
            return flow;
        }
        let longest = self.control.parameters.longest_line;
        if longest > 0 && block.range.len() > longest {
            self.report_long_line(block, longest);
        }
        if block.delete.is_some() {
            self.emit_block_delete(block);
        }
        let continues_remark = std::mem::take(&mut self.in_remark);
        if !block.problems.is_empty() {
            self.report_problems_of_text(block, continues_remark);
        }
        if !block.comments.is_empty()
            && self.rules().comments_act
            && let Some(flow) = self.acting_comment(&block.comments)
        {
            return flow;
        }
        match block.kind {
            BlockKind::Words => {}
            BlockKind::Percent => return self.percent(block),
            BlockKind::Folder => return BlockFlow::Next,
            BlockKind::Macro(range) => {
                let form = self.rules().form;
                if block.delete.is_some() {
                    self.note_deletable(block);
                }
                if form != MacroForm::None && self.is_deleted(block) {
                    return BlockFlow::Next;
                }
                match form {
                    MacroForm::Blocks => return self.macro_block(block),
                    MacroForm::OWords => return self.parameter_line(block, range),
                    MacroForm::Lines => return self.macro_line(block, range),
                    MacroForm::None => {}
                }
                self.report_macro(range);
                if block.words.is_empty() {
                    return BlockFlow::Next;
                }
            }
        }
        if let Some(delete) = block.delete {
            self.note_deletable(block);
            if self.machine.switches.block_delete[delete.switch.min(9) as usize] {
                block.truncate(delete.from_word);
            } else if self.control.parameters.plain_block_delete {
                self.check_block_delete(block);
            }
        }
        if block.is_idle() {
            return BlockFlow::Next;
        }
        if self.data_lines && self.is_data_line(block) {
            return BlockFlow::Next;
        }
        if let Some(number) = block.word(b'N').and_then(|word| word.number()) {
            self.sequence = Some(number);
            self.kernel.block_number = Some(number.to_f64());
        }
        self.carried_out = true;
        if block.expressions || self.has_unset_register(block) {
            self.resolve_words(block);
        }
        if self.is_next_subroutine_head(block) {
            self.leave(None);
            return BlockFlow::Next;
        }
        if self.kernel.state.side != CompensationSide::Off {
            return self.carry_out_compensated(block);
        }
        self.carry_out(block)
    }

    /// Reports the problems that the reader found; a comment of several lines is one problem, at its first line.
    #[cold]
    fn report_problems_of_text(&mut self, block: &mut Block, continues_remark: bool) {
        for problem in std::mem::take(&mut block.problems) {
            let remark = problem.code == Code::LooksLikeRemark;
            self.in_remark |= remark || problem.code == Code::UnclosedComment;
            if !(remark && continues_remark && block.words.is_empty()) {
                self.kernel.report(problem);
            }
        }
    }

    /// True when block delete skips the macro statement, which is the last part of its block.
    fn is_deleted(&self, block: &Block) -> bool {
        block
            .delete
            .is_some_and(|delete| self.machine.switches.block_delete[delete.switch.min(9) as usize])
    }

    /// True for a block of the main program that is run again after a backward jump.
    #[inline]
    fn is_repeat(&mut self, block: &Block) -> bool {
        if self.repeat_until == 0 {
            return false;
        }
        if block.range.start >= self.repeat_until {
            self.repeat_until = 0;
        }
        self.repeat_until != 0
    }

    /// Carries out a block while compensation is on, and emits that it did not move: controls count such blocks.
    fn carry_out_compensated(&mut self, block: &Block) -> BlockFlow {
        let before = self.kernel.state.position;
        let flow = self.carry_out(block);
        if self.kernel.state.side != CompensationSide::Off && self.kernel.state.position == before {
            self.kernel.emit(CommandKind::Idle);
        }
        flow
    }

    /// A percent sign: the end of the program after the first block, its start before.
    fn percent(&mut self, block: &Block) -> BlockFlow {
        if !self.carried_out {
            self.begun_by_percent = true;
        } else if self.frames.is_empty() {
            if self.control.parameters.strict_words && !self.begun_by_percent {
                self.report_lone_percent(block);
            }
            self.ended_by_percent = true;
            return BlockFlow::End(EndReason::EndOfText);
        }
        BlockFlow::Next
    }

    /// A program of the library, or the answer to a custom code.
    fn program_at(&self, index: usize) -> Program {
        let own = self.library.programs();
        own.get(index).copied().unwrap_or_else(|| self.shop.program(index - own.len()))
    }

    fn reader_of(&self, program: usize) -> BlockReader<'a> {
        self.look_at(program);
        self.library.reader(self.program_at(program), self.control.table.lexicon)
    }

    /// The block as the kernel sees it.
    #[inline]
    fn at<'b>(&self, block: &'b Block) -> BlockStatement<'b> {
        BlockStatement { block, file: self.file }
    }

    fn span(&self, range: TextRange) -> Span {
        range.in_file(self.file)
    }
}
