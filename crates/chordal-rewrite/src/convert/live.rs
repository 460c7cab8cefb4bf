//! Which blocks start and stop live tools, and where the spindle becomes the C axis.

use std::collections::BTreeSet;

use chordal::CommandKind;
use chordal::control::{Action, BeforeCode, Control, CycleKind, OnceCode, SpindleState};
use chordal::machine::Axis;

use super::codes;
use super::trace::{BlockExecution, ProgramTrace};
use crate::source::SourceBlocks;

const C: usize = Axis::C as usize;

/// Blocks of a program whose control starts live tools with M3, and what they are where live tools have codes of their own.
#[derive(Debug, Default)]
pub(crate) struct LiveTools {
    /// Blocks that start a live tool or change its speed.
    pub(crate) starts: BTreeSet<usize>,
    /// Blocks that stop it.
    pub(crate) stops: BTreeSet<usize>,
    /// Blocks that tap with it.
    pub(crate) taps: BTreeSet<usize>,
    /// Blocks before which the spindle becomes the C axis.
    pub(crate) axis_on: BTreeSet<usize>,
    /// Blocks of which it is not clear what they start: C moves, but only after a cut.
    pub(crate) unclear: BTreeSet<usize>,
}

/// The control has codes of its own for live tools.
pub(crate) fn has_codes(control: &Control) -> bool {
    codes::row(Action::Before(BeforeCode::LiveToolCw), control).is_some()
}

/// A spindle that turns from a block on.
struct LiveSpindle {
    block: Option<usize>,
    /// Blocks that changed its speed.
    changes: Vec<usize>,
    /// It is a live tool: M3 has its P, or C is named before the first cut, which the spindle itself cannot be while it turns.
    is_live: bool,
    /// C is named only after a cut.
    is_unclear: bool,
    has_cut: bool,
}

impl LiveTools {
    pub(crate) fn of(
        source: &SourceBlocks,
        trace: &ProgramTrace,
        [from, to]: [&Control; 2],
    ) -> LiveTools {
        let mut live = LiveTools::default();
        let is_between =
            from.table.turns() && to.table.turns() && !has_codes(from) && has_codes(to);
        if !is_between {
            return live;
        }
        let mut turning: Option<LiveSpindle> = None;
        let mut is_axis = false;
        for exec in &trace.execs {
            let moves_c = moves_c(source, trace, exec, from);
            if moves_c && !is_axis {
                live.axis_on.extend(exec.block);
                is_axis = true;
            }
            if let (true, Some(turning)) = (moves_c, &mut turning) {
                turning.is_live |= !turning.has_cut;
                turning.is_unclear |= !turning.is_live;
            }
            let is_tap =
                |action| matches!(action, Action::Cycle(CycleKind::Tap | CycleKind::LeftTap));
            if let Some(at) = exec.block
                && is_axis
                && source.has_action(at, from, is_tap)
            {
                live.taps.insert(at);
            }
            for command in trace.commands_of(exec) {
                match (&command.kind, &mut turning) {
                    (CommandKind::Spindle { state, .. }, _) if !command.origin.cycle => {
                        live.follow(*state, exec, &mut turning, &mut is_axis);
                    }
                    (kind, Some(turning)) => turning.has_cut |= kind.feed().is_some(),
                    _ => {}
                }
            }
        }
        live.end(turning, None);
        live
    }

    fn follow(
        &mut self,
        state: SpindleState,
        exec: &BlockExecution,
        turning: &mut Option<LiveSpindle>,
        is_axis: &mut bool,
    ) {
        if !matches!(state, SpindleState::Cw | SpindleState::Ccw) {
            return self.end(turning.take(), exec.block);
        }
        match turning {
            Some(turning) => turning.changes.extend(exec.block),
            None => {
                let is_live = exec.after.live.is_some();
                // The spindle itself is no axis where it turns; whether it does is seen when C moves next.
                *is_axis &= is_live;
                *turning = Some(LiveSpindle {
                    block: exec.block,
                    changes: Vec::new(),
                    is_live,
                    is_unclear: false,
                    has_cut: false,
                });
            }
        }
    }

    fn end(&mut self, turning: Option<LiveSpindle>, block: Option<usize>) {
        let Some(turning) = turning else { return };
        if !turning.is_live {
            self.unclear.extend(turning.block.filter(|_| turning.is_unclear));
            return;
        }
        self.starts.extend(turning.block);
        self.starts.extend(turning.changes);
        self.stops.extend(block);
    }

    /// A block that starts or stops a live tool.
    pub(crate) fn is_about(&self, at: usize) -> bool {
        self.starts.contains(&at) || self.stops.contains(&at) || self.unclear.contains(&at)
    }
}

/// C moves in a block, or is named by it.
fn moves_c(
    source: &SourceBlocks,
    trace: &ProgramTrace,
    exec: &BlockExecution,
    from: &Control,
) -> bool {
    let turns = |kind: &CommandKind| match kind {
        CommandKind::Surface { surface, .. } => surface.is_some(),
        kind => kind.motion().is_some_and(|motion| motion.from[C] != motion.to[C]),
    };
    let is_data = |action| {
        matches!(
            action,
            Action::Once(OnceCode::SetData | OnceCode::Dwell | OnceCode::Turning(_))
                | Action::Call(_)
        )
    };
    let increment = from.parameters.increments.iter().find(|(_, of)| *of == b'C');
    let names = exec.block.is_some_and(|at| {
        let letters = source.blocks[at].letters();
        let is_named = letters.has(b'C') || increment.is_some_and(|(own, _)| letters.has(*own));
        is_named && !source.has_action(at, from, is_data)
    });
    names || trace.commands_of(exec).iter().any(|command| turns(&command.kind))
}
