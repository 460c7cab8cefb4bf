//! The run of the old text, block by block.

use chordal::control::Action;
use std::collections::BTreeSet;
use std::ops::Range;
use std::rc::Rc;

use chordal::control::{
    CallPath, CompensationSide, FeedMode, FrameKinds, LiveTool, Modal, Position, RotarySurface,
    SpindleState, Units, WorkName,
};
use chordal::geometry::Plane;
use chordal::{Code, Command, CommandKind, Diagnostic, Job, Span};

use crate::source::SourceBlocks;
use crate::walk::{first_x_factor, walk, x_factor_after};
use crate::word_address::BlockControl;

/// Reported where what a run does depends on a value that nobody gave.
const OF_UNKNOWN_VALUES: &[Code] = &[
    Code::UnknownPath,
    Code::UnknownTime,
    Code::AssumedBranch,
    Code::SkipAssumed,
    Code::CyclePathAssumed,
];

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
    /// What is active before it, which is what was after the run before it.
    pub before: Rc<ActiveModes>,
    pub after: Rc<ActiveModes>,
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

impl ProgramTrace {
    pub fn of(job: &Job, source: &SourceBlocks) -> ProgramTrace {
        let mut trace = ProgramTrace {
            execs: Vec::new(),
            commands: Vec::new(),
            facts: vec![BlockFacts::default(); source.blocks.len()],
            paths: vec![Vec::new()],
            assumed: None,
        };
        let control = job.control();
        let (mut raw, mut surface, mut x_factor) = (Vec::new(), None, first_x_factor(job));
        let mut last: Option<Rc<ActiveModes>> = None;
        let mut last_is_arc = false;
        let (outcomes, _) = walk(job, |visit| {
            let block = source.block_at(visit.origin.span);
            x_factor = block.map_or(x_factor, |at| x_factor_after(source, control, at, x_factor));
            let after_arc = last_is_arc;
            for command in &visit.output.commands {
                match command.kind {
                    CommandKind::Surface { surface: now, .. } => surface = now,
                    CommandKind::End => surface = None,
                    _ => {}
                }
                if command.kind.motion().is_some() {
                    last_is_arc = command.kind.shape().is_some();
                }
            }
            let after = Rc::new(ActiveModes::of(visit.modal(), surface, x_factor.recip()));
            let before = last.replace(after.clone()).unwrap_or_else(|| after.clone());
            if trace.assumed.is_none() {
                let mut reported = visit.output.diagnostics.iter();
                trace.assumed = reported.find(|one| OF_UNKNOWN_VALUES.contains(&one.code)).cloned();
            }
            let begin = trace.commands.len();
            trace.commands.extend_from_slice(&visit.output.commands);
            let commands = begin..trace.commands.len();
            raw.push(visit.origin.call);
            trace.execs.push(BlockExecution { block, path: 0, commands, before, after });
            trace.note_facts(after_arc);
        });
        trace.resolve(source, &raw, &outcomes);
        trace
    }

    /// Notes what the last run has in common with those of its block before.
    fn note_facts(&mut self, after_arc: bool) {
        let index = self.execs.len() - 1;
        let exec = &self.execs[index];
        let Some(block) = exec.block else { return };
        let feed = |exec: &BlockExecution| {
            let feed = self.commands_of(exec).iter().find_map(|command| command.kind.feed());
            feed.map(|feed| feed.value.to_bits())
        };
        let before = self.first_run(block);
        let varies = before.is_some_and(|first| feed(first) != feed(exec));
        let facts = &mut self.facts[block];
        if facts.runs == 0 {
            facts.first = index;
        }
        facts.feed_varies |= varies;
        facts.runs += 1;
        facts.after_arc |= after_arc;
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
    if !job.profile().turns {
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
