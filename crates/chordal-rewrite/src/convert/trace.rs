//! The run of the old text, block by block.

use chordal::RunSink;
use chordal::control::Action;
use std::collections::BTreeSet;
use std::ops::Range;

use chordal::control::{
    CallPath, CompensationSide, Control, FeedMode, FrameKinds, LiveTool, Modal, Origin, Position,
    ReadingCode, RotarySurface, SpindleState, Units, WorkName,
};
use chordal::geometry::Plane;
use chordal::{Code, Command, CommandKind, Diagnostic, Job, Sink, Span};

use crate::source::SourceBlocks;

/// Said where what a run does depends on a value that nobody gave.
fn is_of_unknown_value(code: Code) -> bool {
    matches!(code, Code::UnknownPath | Code::UnknownTime | Code::AssumedBranch | Code::SkipAssumed)
}

/// What is active after a block.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct ActiveModes {
    pub motion: Option<Action>,
    pub incremental: bool,
    pub plane: Plane,
    pub feed_mode: FeedMode,
    /// As the mode counts it: mm/s, 1/s, mm per revolution.
    pub feed: Option<f64>,
    pub units: Units,
    pub side: CompensationSide,
    pub work: WorkName,
    /// Of the tool tip in the work coordinate system.
    pub position: Position,
    pub frames: FrameKinds,
    pub spindle: SpindleState,
    /// The cutting speed that the spindle keeps (G96), mm/s.
    pub surface_speed: Option<f64>,
    /// What limits the spindle, rev/min.
    pub speed_limit: Option<f64>,
    pub tool: u32,
    pub length_offset: Option<u32>,
    /// A live tool that turns in place of the spindle.
    pub live: Option<LiveTool>,
    /// The surface on which two coordinates lie.
    pub surface: Option<RotarySurface>,
    /// Millimetres of the radius in one millimetre of a word X: a half where it is a diameter.
    pub per_x: f64,
}

impl ActiveModes {
    fn of(modal: Modal, surface: Option<RotarySurface>, per_x: f64) -> ActiveModes {
        ActiveModes {
            motion: modal.motion.map(Action::from),
            incremental: modal.incremental,
            plane: modal.plane,
            feed_mode: modal.feed_mode,
            feed: modal.feed,
            units: modal.units,
            side: modal.side,
            work: modal.work,
            position: modal.work_position,
            frames: modal.frames,
            spindle: modal.spindle,
            surface_speed: modal.surface_speed,
            speed_limit: modal.speed_limit,
            tool: modal.tool,
            length_offset: modal.length_offset,
            live: modal.live,
            surface,
            per_x,
        }
    }
}

/// A block carried out once.
#[derive(Clone, Debug)]
pub(crate) struct BlockExecution {
    /// The block; nothing where it stands in another file.
    pub block: Option<usize>,
    /// The calls that it was reached through, innermost first, by number.
    pub path: u32,
    pub commands: Range<usize>,
    pub before: ActiveModes,
    pub after: ActiveModes,
}

/// What the runs of a block have in common.
#[derive(Clone, Debug, Default)]
pub(crate) struct BlockFacts {
    /// How often it was carried out.
    pub runs: u32,
    /// Its first run.
    pub first: usize,
    /// Some run comes after an arc.
    pub after_arc: bool,
    /// Its cuts are not made at the same feed in all runs.
    pub feed_varies: bool,
}

/// A run.
pub(crate) struct ProgramTrace {
    pub execs: Vec<BlockExecution>,
    pub commands: Vec<Command>,
    pub facts: Vec<BlockFacts>,
    /// The calling blocks, innermost first, by the numbers that runs have.
    pub paths: Vec<Vec<Span>>,
    /// The first thing that the run assumed because nobody knows a value.
    pub assumed: Option<Diagnostic>,
}

struct TraceRecorder<'s, 'a> {
    source: &'s SourceBlocks<'a>,
    trace: ProgramTrace,
    last: Option<ActiveModes>,
    /// The first command of the running block.
    open: usize,
    last_is_arc: bool,
    raw: Vec<CallPath>,
    control: &'s Control,
    per_x: f64,
    surface: Option<RotarySurface>,
}

impl Sink for TraceRecorder<'_, '_> {
    fn command(&mut self, command: &Command) {
        self.trace.commands.push(command.clone());
    }

    fn diagnostic(&mut self, diagnostic: Diagnostic) {
        if self.trace.assumed.is_none() && is_of_unknown_value(diagnostic.code) {
            self.trace.assumed = Some(diagnostic);
        }
    }
}

impl RunSink for TraceRecorder<'_, '_> {
    fn wants_blocks(&self) -> bool {
        true
    }

    fn block_done(&mut self, origin: &Origin, modal: &dyn Fn() -> Modal) {
        let block = self.source.block_at(origin.span);
        self.follow_x_words(block);
        let commands = self.open..self.trace.commands.len();
        for command in &self.trace.commands[commands.clone()] {
            match command.kind {
                CommandKind::Surface { surface, .. } => self.surface = surface,
                CommandKind::End => self.surface = None,
                _ => {}
            }
        }
        let after = ActiveModes::of(modal(), self.surface, self.per_x);
        self.open = commands.end;
        let index = self.trace.execs.len();
        let after_arc = self.last_is_arc;
        for command in &self.trace.commands[commands.clone()] {
            if command.kind.motion().is_some() {
                self.last_is_arc = command.kind.shape().is_some();
            }
        }
        if let Some(facts) = block.map(|block| &mut self.trace.facts[block]) {
            if facts.runs == 0 {
                facts.first = index;
            } else {
                let first = self.trace.execs[facts.first].commands.clone();
                let feed = |commands: Range<usize>| {
                    let mut commands = self.trace.commands[commands].iter();
                    commands
                        .find_map(|command| command.kind.feed())
                        .map(|feed| feed.value.to_bits())
                };
                facts.feed_varies |= feed(first) != feed(commands.clone());
            }
            facts.runs += 1;
            facts.after_arc |= after_arc;
        }
        let before = self.last.unwrap_or(after);
        self.raw.push(origin.call);
        self.trace.execs.push(BlockExecution { block, path: 0, commands, before, after });
        self.last = Some(after);
    }
}

impl TraceRecorder<'_, '_> {
    /// Whether words of X are diameters from a block on.
    fn follow_x_words(&mut self, block: Option<usize>) {
        let Some(block) = block else { return };
        let has = |code: ReadingCode| {
            self.source.has_action(block, self.control, |own| own == Action::Reading(code))
        };
        if has(ReadingCode::Diameters) {
            self.per_x = 0.5;
        } else if has(ReadingCode::Radii) {
            self.per_x = 1.0;
        }
    }
}

impl ProgramTrace {
    pub fn of(job: &Job, source: &SourceBlocks) -> ProgramTrace {
        let trace = ProgramTrace {
            execs: Vec::new(),
            commands: Vec::new(),
            facts: vec![BlockFacts::default(); source.blocks.len()],
            paths: vec![Vec::new()],
            assumed: None,
        };
        let control = job.control();
        let per_x = match control.parameters.starts_with_radii {
            true => 1.0,
            false => job.machine().written_factor(0).recip(),
        };
        let mut gather = TraceRecorder {
            source,
            trace,
            last: None,
            open: 0,
            last_is_arc: false,
            raw: Vec::new(),
            control,
            per_x,
            surface: None,
        };
        let outcomes = job.run(&mut gather);
        let TraceRecorder { mut trace, raw, .. } = gather;
        trace.resolve(source, &raw, &outcomes);
        trace
    }

    /// Gives each run the number of its calls. Every main program counts its calls anew.
    fn resolve(&mut self, source: &SourceBlocks, raw: &[CallPath], outcomes: &[chordal::Outcome]) {
        let mut main = 0;
        let mut known: Vec<Option<u32>> = Vec::new();
        let mut running: Option<usize> = None;
        for (exec, call) in self.execs.iter_mut().zip(raw) {
            if *call == CallPath::default() {
                let program =
                    exec.block.and_then(|at| source.mains.iter().position(|m| m.contains(&at)));
                if running.is_some() && program.is_some() && program != running {
                    main += 1;
                    known.clear();
                }
                running = program.or(running);
                continue;
            }
            let at = call.0 as usize;
            if known.len() <= at {
                known.resize(at + 1, None);
            }
            exec.path = *known[at].get_or_insert_with(|| {
                let calls = outcomes.get(main).map(|outcome| outcome.calls.resolve(*call));
                self.paths.push(calls.unwrap_or_default());
                self.paths.len() as u32 - 1
            });
        }
    }

    /// The commands of a run.
    pub fn commands_of(&self, exec: &BlockExecution) -> &[Command] {
        &self.commands[exec.commands.clone()]
    }

    /// The first run of a block.
    pub fn first_run(&self, block: usize) -> Option<&BlockExecution> {
        let facts = &self.facts[block];
        (facts.runs > 0).then(|| &self.execs[facts.first])
    }

    /// The runs that a run sets off by its calls, itself included.
    pub fn subtree(&self, index: usize) -> Range<usize> {
        let depth = self.paths[self.execs[index].path as usize].len();
        let deeper = |exec: &BlockExecution| self.paths[exec.path as usize].len() > depth;
        let more = self.execs[index + 1..].iter().take_while(|exec| deeper(exec)).count();
        index..index + 1 + more
    }
}

/// The lines of a lathe's program on which the spindle keeps a cutting speed, before them or after.
pub(crate) fn surface_lines(job: &Job) -> BTreeSet<u32> {
    if !job.control().table.turns() {
        return BTreeSet::new();
    }
    let source = SourceBlocks::of(job);
    let trace = ProgramTrace::of(job, &source);
    let keeps = |exec: &&BlockExecution| {
        exec.before.surface_speed.is_some() || exec.after.surface_speed.is_some()
    };
    let blocks = trace.execs.iter().filter(keeps).filter_map(|exec| exec.block);
    blocks.map(|at| source.blocks[at].line).collect()
}

/// The commands of a block that move.
pub(crate) fn moves(commands: &[Command]) -> impl Iterator<Item = &Command> {
    commands.iter().filter(|command| {
        command.kind.motion().is_some_and(|motion| motion.from != motion.to)
            || matches!(
                command.kind,
                CommandKind::Arc { .. } | CommandKind::Spiral { .. } | CommandKind::Spline { .. }
            )
    })
}
