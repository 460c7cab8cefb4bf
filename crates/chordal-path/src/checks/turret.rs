//! The turret of a lathe: whether it indexes too close to what the program cuts.

use chordal_command::{Command, CommandKind, Move, Position};
use chordal_diagnostics::{Code, Diagnostic, TextShift};
use chordal_machine::Axis;

use super::RunChecks;
use crate::turret_log::{NearTurn, TurnedCut, TurretSystem, TurretTurn};

const X: usize = Axis::X as usize;
const Z: usize = Axis::Z as usize;

/// What is remembered about the turret.
#[derive(Clone, Debug, Default)]
pub(super) struct TurretMemory {
    tool: u32,
    /// The position of the tool tip (X as a radius, Z), mm; `None` if it is not known.
    tip: Option<[f64; 2]>,
    /// What the active offset adds to X and Z, mm; `None` if its values are not known.
    offset: Option<[f64; 2]>,
    /// The offset of the previous tool.
    offset_before: Option<[f64; 2]>,
    /// A tool offset has been active: from then on, coordinates without one are not those of the tip.
    has_offsets: bool,
    is_without_offset: bool,
    /// The turret has indexed, and the offset of the new tool is not active yet.
    waiting: Option<TurretTurn>,
}

impl TurretMemory {
    /// Moves the positions in the text after an edit of other text; `None` if one of them was in the edited text.
    pub fn shift(&mut self, shift: &TextShift) -> Option<()> {
        if let Some(turn) = &mut self.waiting {
            turn.origin = turn.origin.shifted(shift)?;
        }
        Some(())
    }
}

impl RunChecks<'_> {
    /// Follows a command on a lathe.
    pub(super) fn turret(&mut self, command: &Command) {
        if let Some(motion) = command.kind.motion() {
            self.end_turn();
            let is_tip = self.now.frame.surface.is_none() && !self.now.turret.is_without_offset;
            let known = motion.to_known.has(X) && motion.to_known.has(Z) && is_tip;
            self.now.turret.tip = known.then(|| place_of(&motion.to));
            if known && command.kind.feed().is_some() {
                self.cut_of_turret(motion);
            }
            return;
        }
        match &command.kind {
            CommandKind::Tool { number } => {
                self.end_turn();
                let system = self.turret_system();
                let memory = &mut self.now.turret;
                let from = std::mem::replace(&mut memory.tool, *number);
                memory.offset_before = memory.offset.take();
                if let Some(tip) = memory.tip.take().filter(|_| from != 0) {
                    memory.waiting = Some(TurretTurn {
                        system,
                        from: (from, tip),
                        to: (*number, None),
                        units: self.now.units,
                        origin: command.origin,
                    });
                }
            }
            CommandKind::ToolNumber { number } => self.now.turret.tool = *number,
            CommandKind::ToolLength { number, length_mm, offset, .. } => {
                let memory = &mut self.now.turret;
                let has_values = number.is_some() && length_mm.is_some();
                let next = has_values.then(|| place_of(offset));
                if let (Some(turn), Some(before), Some(next)) =
                    (&mut memory.waiting, memory.offset_before, next)
                {
                    // The slide does not move, so the tips differ by the difference of the offsets.
                    let old = turn.from.1;
                    let tip = [old[0] + before[0] - next[0], old[1] + before[1] - next[1]];
                    (turn.to.1, memory.tip) = (Some(tip), Some(tip));
                }
                // If the offset is cancelled, the tool is still the one it belonged to.
                if number.is_some() {
                    (memory.offset, memory.has_offsets) = (next, true);
                }
                memory.is_without_offset = memory.has_offsets && number.is_none();
                self.end_turn();
            }
            CommandKind::WorkOffset { known, position, .. } => {
                self.end_turn();
                let is_known = known.has(X) && known.has(Z) && self.now.turret.tip.is_some();
                self.now.turret.tip = is_known.then(|| place_of(position));
            }
            _ => {}
        }
    }

    fn turret_system(&self) -> TurretSystem {
        TurretSystem::new(self.now.frame.name, &self.now.frame.work)
    }

    fn end_turn(&mut self) {
        if let Some(turn) = self.now.turret.waiting.take() {
            self.seen.turret.turn(turn);
        }
    }

    fn cut_of_turret(&mut self, motion: &Move) {
        let known = motion.from_known.and(motion.to_known);
        if known.has(X) && known.has(Z) {
            // For an arc, its chord: the cut outside the chord is ignored.
            let cut = TurnedCut::new(place_of(&motion.from), place_of(&motion.to));
            self.seen.turret.cut(self.turret_system(), cut);
        }
    }

    /// Reports, at the end of a program, where the turret indexed inside the part or close to it.
    pub(super) fn judge_turret(&mut self, report: &mut impl FnMut(Diagnostic)) {
        self.end_turn();
        let log = std::mem::take(&mut self.seen.turret);
        let clearance = self.machine.turret_clearance_mm.unwrap_or(0.0);
        log.judge(clearance, |near| report(self.turret_near_part(near)));
    }

    fn turret_near_part(&self, near: &NearTurn) -> Diagnostic {
        let NearTurn { turn, tool, place: [x, z], distance } = *near;
        let units = turn.units;
        let length = |mm: f64| units.length_text(mm);
        let across = |mm: f64| length(mm * self.machine.written_factor(X));
        let (going, coming) = (turn.from.0, turn.to.0);
        let stands = if tool == going { "is at" } else { "comes to" };
        let place = format!("X {}, Z {}", across(x), length(z));
        let near = match distance < 0.0 {
            true => format!("{} inside of what this program cuts", length(-distance)),
            false => format!("{} from what this program cuts", length(distance)),
        };
        Diagnostic::new(
            Code::TurretNearPart,
            turn.origin.span,
            format!("the turret turns from tool {going} to tool {coming}, and tool {tool} {stands} {place}: {near}"),
        )
        .label("the turret turns in this block")
        .help("move the turret away from the part before this block")
    }
}

fn place_of(position: &Position) -> [f64; 2] {
    [position[X], position[Z]]
}
