//! Runs a program: reads blocks, carries them out, follows calls.
//!
//! One file per concern: `block` gathers the codes of a block and takes them in the order a
//! control does; `judge` holds its words against each other; `modes` sets what they change; `motion`, `arc`, `spiral`, `reference` and `cycle` move; `offsets` writes
//! tables; `calls` follows subprograms; `repeats` counts them; `shop` asks about codes of a shop's own; `values` turns words into millimetres; `report`
//! builds the diagnostics.

mod arc;
mod block;
mod calls;
mod cycle;
mod judge;
mod macros;
mod modes;
mod motion;
mod offsets;
mod overrides;
mod path_modes;
mod pocket;
mod reference;
mod repeats;
mod report;
mod rest;
mod shop;
mod spiral;
mod values;

pub use self::calls::subroutine_head;

use std::cell::Cell;
use std::collections::{BTreeMap, HashMap};
use std::fmt;
use std::sync::Arc;

use chordal_diagnostics::{Code, Diagnostic, FileId, Severity, Span, TextRange};
use chordal_machine::Machine;
use chordal_syntax::{Block, BlockKind, BlockReader, Position as TextPosition};

use crate::command::{
    AxisMask, CallPath, CallPaths, Command, CommandKind, Origin, Side, Sink, WorkName,
};
use crate::control::Control;
use crate::library::{Library, Program};
use crate::macros::rules::MacroForm;
use crate::modal::Modal;
use crate::offsets::Offsets;
use crate::shop::ShopCodes;
use crate::state::State;
use crate::table::CodeRow;

pub use rest::Rest;

/// True when a run should end early. It is asked every [`BLOCKS_PER_ASKING`] blocks.
pub type Interrupt = Arc<dyn Fn() -> bool + Send + Sync>;

/// So often is asked whether to go on: below a millisecond of reading, and nothing beside it.
const BLOCKS_PER_ASKING: u64 = 1024;

/// How a run is done.
#[derive(Clone)]
pub struct RunOptions {
    /// Most blocks carried out in calls, repeats and jumps. Blocks that are simply read one
    /// after the other are not counted: their number is that of the text.
    pub max_repeated_blocks: u64,
    /// Who knows the codes and programs of the shop that nothing else knows.
    pub shop_codes: Option<Arc<dyn ShopCodes>>,
    /// Ends the run early.
    pub interrupt: Option<Interrupt>,
}

impl Default for RunOptions {
    fn default() -> RunOptions {
        RunOptions { max_repeated_blocks: 1_000_000, shop_codes: None, interrupt: None }
    }
}

impl fmt::Debug for RunOptions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("RunOptions")
            .field("max_repeated_blocks", &self.max_repeated_blocks)
            .field("shop_codes", &self.shop_codes.is_some())
            .field("interrupt", &self.interrupt.is_some())
            .finish()
    }
}

/// Words of a block; one with more counts as several against the budget.
const USUAL_WORDS: usize = 12;

/// How a run ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum EndReason {
    /// M2 or M30.
    ProgramEnd,
    /// The text ended first.
    EndOfText,
    /// M99 in the main program: it would begin again.
    Repeats,
    /// A jump to a block that is not there.
    LostJump,
    /// The program stopped itself with an alarm (`#3000=1 (TEXT)`).
    Alarm,
    /// The budget was used up.
    Budget,
    /// Who ran it wanted it to end.
    Interrupted,
}

/// What a run leaves beside its commands.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// How it ended.
    pub end: EndReason,
    /// Blocks carried out, repeats counted.
    pub blocks: u64,
    /// The chains of calls.
    pub calls: CallPaths,
    /// Numbers of called programs that were not there.
    pub missing_programs: Vec<u32>,
}

/// What follows a block.
enum Flow {
    Next,
    End(EndReason),
}

/// A call that has not returned.
struct Frame<'a> {
    /// Where to go on.
    reader: BlockReader<'a>,
    program: usize,
    path: CallPath,
    /// Where the called text begins, for its repeats.
    start: TextPosition,
    /// Calls still to make.
    remaining: u32,
    /// The called thing is an L subroutine.
    subroutine: bool,
    /// Loops of the caller.
    loops: Vec<macros::Loop>,
    /// Modal macro calls in force in the caller.
    modal_calls: usize,
    /// The called program has local variables of its own.
    own_locals: bool,
    /// It was called by a code that a setting makes a call.
    by_alias: bool,
    /// The called text is the shop's answer: its end is a return.
    of_shop: bool,
    /// Where the tool stood at the call, X and Y.
    entry: [f64; 2],
    /// G41 or G42 of a contour in G91 that leads in from there, where it is called once.
    contour: Option<Span>,
}

struct Interpreter<'a> {
    library: &'a Library<'a>,
    control: &'a Control,
    machine: &'a Machine,
    options: &'a RunOptions,
    sink: &'a mut (dyn Sink + 'a),
    state: State,
    reader: BlockReader<'a>,
    program: usize,
    file: FileId,
    frames: Vec<Frame<'a>>,
    paths: CallPaths,
    path: CallPath,
    /// L subroutines of the main program: number → first block.
    subroutines: BTreeMap<u32, TextPosition>,
    /// N numbers of each program that was jumped in.
    labels: HashMap<usize, HashMap<i64, Vec<TextPosition>>>,
    jumps: HashMap<u32, u32>,
    missing: Vec<u32>,
    blocks: u64,
    repeated_blocks: u64,
    origin: Origin,
    /// The last N number, for alarms.
    sequence: Option<chordal_syntax::Decimal>,
    codes: Vec<(&'static CodeRow, usize)>,
    told: Told,
    preset_kept: [f64; 6],
    lost_jump: bool,
    carried_out: bool,
    /// The block before was a remark without its marks, or a comment left open.
    in_remark: bool,
    macros: macros::MacroState<'a>,
    /// Blocks of the main program before this place are repeats after a jump back; 0 when
    /// there are none.
    repeat_until: u32,
    /// The text that hugs the value of an assignment (`#3000=1(TEXT)`), while it is made.
    message: Option<TextRange>,
    /// Set where a statement ends the run.
    stopped: Option<EndReason>,
    shop: shop::ShopState,
    /// What of the first text was read since the last rest beside the blocks one after the other.
    looked: Cell<Option<TextRange>>,
}

/// Things that are told once, not for every block.
#[derive(Clone, Default, Debug)]
struct Told {
    missing_feed: bool,
    spindle_for_tool: Option<u32>,
    offsets: Vec<String>,
    axes: AxisMask,
    points_seen: bool,
    excess_decimals: bool,
    /// Routines whose path is a choice.
    assumed_paths: Vec<String>,
}

/// Runs one program of a library and pushes its commands into a sink.
pub fn run<'a>(
    library: &'a Library<'a>,
    program: usize,
    machine: &'a Machine,
    control: &'a Control,
    options: &'a RunOptions,
    sink: &'a mut (dyn Sink + 'a),
) -> Outcome {
    let outcome = Interpreter::new(library, program, machine, control, options, sink).outcome();
    outcome.map(|(outcome, _)| outcome).unwrap_or_else(|| Outcome {
        end: EndReason::Interrupted,
        blocks: 0,
        calls: CallPaths::default(),
        missing_programs: Vec::new(),
    })
}

/// The same from a rest on, and what of the first text was read behind the last rest beside the
/// blocks one after the other. Nothing when the sink has ended it at a rest.
pub fn run_from<'a>(
    library: &'a Library<'a>,
    program: usize,
    machine: &'a Machine,
    control: &'a Control,
    options: &'a RunOptions,
    sink: &'a mut (dyn Sink + 'a),
    rest: Option<&Rest>,
) -> Option<(Outcome, Option<TextRange>)> {
    let mut interpreter = Interpreter::new(library, program, machine, control, options, sink);
    if let Some(rest) = rest {
        interpreter.take_up(rest);
    }
    interpreter.outcome()
}

/// What lies between program and machine coordinates before the first block: the offset
/// (mm, rad) and the axes for which the machine file gives it.
pub fn initial_offset(machine: &Machine, control: &Control) -> ([f64; 6], AxisMask) {
    let offsets = initial_offsets(machine, control);
    (offsets.total(), offsets.known())
}

/// The work coordinate system before the first block.
pub fn initial_work_offset(control: &Control) -> WorkName {
    if control.table.work_offset_by_e { WorkName::E(1) } else { WorkName::G(54) }
}

fn initial_offsets(machine: &Machine, control: &Control) -> Offsets {
    Offsets::new(machine, initial_work_offset(control), control.table.extended_offset_code)
}

impl<'a> Interpreter<'a> {
    fn new(
        library: &'a Library<'a>,
        program: usize,
        machine: &'a Machine,
        control: &'a Control,
        options: &'a RunOptions,
        sink: &'a mut (dyn Sink + 'a),
    ) -> Interpreter<'a> {
        let offsets = initial_offsets(machine, control);
        let home = machine.home.map(|place| place.unwrap_or(0.0));
        Interpreter {
            library,
            control,
            machine,
            options,
            sink,
            state: State::new(&control.parameters, offsets, home),
            reader: library.reader(library.programs()[program], control.table.lexicon),
            program,
            file: library.programs()[program].file,
            frames: Vec::new(),
            paths: CallPaths::default(),
            path: CallPath::default(),
            subroutines: BTreeMap::new(),
            labels: HashMap::new(),
            jumps: HashMap::new(),
            missing: Vec::new(),
            blocks: 0,
            repeated_blocks: 0,
            origin: Origin::default(),
            sequence: None,
            codes: Vec::new(),
            told: Told::default(),
            preset_kept: [0.0; 6],
            lost_jump: false,
            carried_out: false,
            in_remark: false,
            macros: macros::MacroState::new(control.table, machine),
            repeat_until: 0,
            message: None,
            stopped: None,
            shop: shop::ShopState::new(program),
            looked: Cell::new(None),
        }
    }

    fn outcome(mut self) -> Option<(Outcome, Option<TextRange>)> {
        let end = self.run()?;
        self.finish(end);
        let outcome =
            Outcome { end, blocks: self.blocks, calls: self.paths, missing_programs: self.missing };
        Some((outcome, self.looked.take()))
    }

    /// Why it ended; nothing when the sink has ended it at a rest.
    fn run(&mut self) -> Option<EndReason> {
        if self.blocks == 0 {
            self.read_subroutine_section();
        }
        let wants_blocks = self.sink.wants_blocks();
        let mut next_rest = self.sink.next_rest();
        let mut block = Block::new();
        loop {
            if self.reader.position().offset >= next_rest && self.is_settled() {
                let rest = self.rest();
                self.told.excess_decimals = false;
                if self.sink.rest(rest, self.looked.take()).is_break() {
                    return None;
                }
                next_rest = self.sink.next_rest();
            }
            while !self.reader.read(&mut block) {
                if self.frames.is_empty() {
                    return Some(EndReason::EndOfText);
                }
                self.text_ended_in_call();
            }
            if !self.frames.is_empty() || self.is_repeat(&block) {
                // A line of hundreds of words is more work than the blocks that people write.
                self.repeated_blocks += (block.words.len() / USUAL_WORDS) as u64;
                if !self.count_repeated() {
                    return Some(EndReason::Budget);
                }
            }
            if self.blocks.is_multiple_of(BLOCKS_PER_ASKING) && self.is_interrupted() {
                return Some(EndReason::Interrupted);
            }
            let flow = self.execute(&mut block);
            if wants_blocks {
                let (state, control) = (&self.state, self.control);
                self.sink.block_done(&self.origin, &|| Modal::of(state, control));
            }
            match flow {
                Flow::Next => {}
                Flow::End(reason) => return Some(reason),
            }
        }
    }

    fn is_interrupted(&self) -> bool {
        self.options.interrupt.as_ref().is_some_and(|interrupt| interrupt())
    }

    fn finish(&mut self, end: EndReason) {
        self.print_held();
        if end == EndReason::EndOfText {
            self.report_missing_end();
        }
        self.report_compensation_at_end();
        if end == EndReason::EndOfText {
            self.emit(CommandKind::End);
        }
    }

    fn execute(&mut self, block: &mut Block) -> Flow {
        self.blocks += 1;
        self.origin = Origin {
            span: Span { file: self.file, range: block.range },
            line: block.line,
            call: self.path,
            cycle: false,
        };
        let goes_on = std::mem::take(&mut self.in_remark);
        if !block.problems.is_empty() {
            self.report_problems_of_text(block, goes_on);
        }
        if !block.comments.is_empty()
            && self.rules().comments_act
            && let Some(flow) = self.acting_comment(&block.comments)
        {
            return flow;
        }
        match block.kind {
            BlockKind::Words => {}
            BlockKind::Percent => return self.percent(),
            BlockKind::Folder => return Flow::Next,
            BlockKind::Macro(range) => {
                let form = self.rules().form;
                if form != MacroForm::None && self.is_deleted(block) {
                    return Flow::Next;
                }
                match form {
                    MacroForm::Blocks => return self.macro_block(block),
                    MacroForm::OWords => return self.parameter_line(block, range),
                    MacroForm::Lines => return self.macro_line(block, range),
                    MacroForm::None => {}
                }
                self.report_macro(range);
                if block.words.is_empty() {
                    return Flow::Next;
                }
            }
        }
        if let Some(delete) = block.delete
            && self.machine.switches.block_delete[delete.switch.min(9) as usize]
        {
            block.truncate(delete.from_word);
        }
        if block.words.is_empty() {
            return Flow::Next;
        }
        if let Some(number) = block.word(b'N').and_then(|word| word.number()) {
            self.sequence = Some(number);
        }
        self.carried_out = true;
        if block.expressions {
            self.resolve_words(block);
        }
        if self.is_next_subroutine_head(block) {
            self.leave(None);
            return Flow::Next;
        }
        if self.state.side != Side::Off {
            return self.carry_out_compensated(block);
        }
        self.carry_out(block)
    }

    /// What the reader found. A remark of several lines is one problem, at its first line.
    #[cold]
    fn report_problems_of_text(&mut self, block: &mut Block, goes_on: bool) {
        for problem in std::mem::take(&mut block.problems) {
            let remark = problem.code == Code::LooksLikeRemark;
            self.in_remark |= remark || problem.code == Code::UnclosedComment;
            if !(remark && goes_on && block.words.is_empty()) {
                self.report(problem);
            }
        }
    }

    /// True when block delete takes the macro statement, which is the last of its block.
    fn is_deleted(&self, block: &Block) -> bool {
        block
            .delete
            .is_some_and(|delete| self.machine.switches.block_delete[delete.switch.min(9) as usize])
    }

    /// True for a block of the main program that a jump back leads through again.
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

    /// Controls count the blocks that move nothing while compensation is on.
    fn carry_out_compensated(&mut self, block: &Block) -> Flow {
        let before = self.state.position;
        let flow = self.carry_out(block);
        if self.state.side != Side::Off && self.state.position == before {
            self.emit(CommandKind::Idle);
        }
        flow
    }

    /// A percent sign ends the tape, once something stood before it.
    fn percent(&mut self) -> Flow {
        if self.carried_out && self.frames.is_empty() {
            return Flow::End(EndReason::EndOfText);
        }
        Flow::Next
    }

    /// Counts a block against the budget; false when it is used up.
    fn count_repeated(&mut self) -> bool {
        self.repeated_blocks += 1;
        if self.repeated_blocks <= self.options.max_repeated_blocks {
            return true;
        }
        let limit = self.options.max_repeated_blocks;
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

    fn emit(&mut self, kind: CommandKind) {
        self.sink.command(&Command { kind, origin: self.origin });
    }

    fn report(&mut self, mut diagnostic: Diagnostic) {
        if self.path != CallPath::default() {
            diagnostic.calls = self.paths.resolve(self.path);
        }
        if diagnostic.alarm.is_none() && diagnostic.severity == Severity::Error {
            diagnostic.alarm = self.alarm_text(diagnostic.code, None);
        }
        self.sink.diagnostic(diagnostic);
    }

    /// A program of the library, or one that the shop's answers have brought.
    fn program_at(&self, index: usize) -> Program {
        let own = self.library.programs();
        own.get(index).copied().unwrap_or_else(|| self.shop.program(index - own.len()))
    }

    fn reader_of(&self, program: usize) -> BlockReader<'a> {
        self.look_at(program);
        self.library.reader(self.program_at(program), self.control.table.lexicon)
    }

    fn span(&self, range: TextRange) -> Span {
        range.in_file(self.file)
    }
}
