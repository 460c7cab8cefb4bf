//! The run of a program up to the block that it is to begin at.

use std::ops::Range;

use chordal::control::{
    Action, AfterCode, CallCode, CallPath, Modal, ModeCode, OnceCode, Origin, ReadingCode,
    number_text,
};
use chordal::syntax::{Block, Word};
use chordal::{Command, CommandKind, Control, Diagnostic, Effect, Job, RunSink, Sink};

use super::cycle::OpenCycle;
use super::lathe::{LatheState, limits};
use super::shift::ActiveShift;
use crate::source::SourceBlocks;
use crate::split::state_at::StateWords;

/// What a program needs to begin at a block.
#[derive(Debug)]
pub(super) struct StateBefore {
    pub(super) modal: Modal,
    pub(super) words: StateWords,
    /// The highest Z in the work offset and with the length offset in force, mm.
    pub(super) highest: f64,
    /// The lines of the blocks that began what may still be open.
    pub(super) open: OpenConstructs,
    pub(super) cycle: OpenCycle,
    pub(super) shift: ActiveShift,
    pub(super) turned: LatheState,
    pub(super) unrepeated: Vec<UnrepeatedCode>,
    /// What a place of X is multiplied by in a word.
    pub(super) x_factor: f64,
}

/// Lines of blocks that opened something which a head cannot say again; nothing where it is closed.
#[derive(Clone, Debug, Default)]
pub(super) struct OpenConstructs {
    pub(super) compensation: Option<u32>,
    pub(super) cycle: Option<u32>,
    pub(super) frame: Option<u32>,
    pub(super) shift: Option<u32>,
    pub(super) call: Option<u32>,
    pub(super) corner: Option<u32>,
    /// A G code that Chordal does not carry out.
    pub(super) unknown: Option<(String, u32)>,
}

/// An M code before the block that acts on something which Chordal does not know: clamps, outputs, pallets, overrides.
/// A head does not repeat it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnrepeatedCode {
    /// The code with its words, as the program writes them.
    pub words: String,
    /// The line of the last block that says so.
    pub line: u32,
}

/// A run, as far as it goes to a block.
#[derive(Debug)]
pub(super) struct RunToBlock {
    /// How many blocks are carried out before it; nothing where it is never carried out.
    pub(super) ran: Option<u64>,
    /// How many times it is carried out.
    pub(super) times: u32,
    /// It is in a called program: the line of the block that calls it first.
    pub(super) caller: Option<u32>,
    /// The first block of the main program that is carried out and has words, by its byte.
    pub(super) first: Option<u32>,
}

impl RunToBlock {
    /// Runs a job and looks for the block at a byte of its first text.
    pub(super) fn to(
        job: &Job,
        source: &SourceBlocks,
        main: &Range<usize>,
        at: usize,
    ) -> RunToBlock {
        let path = RunToBlock { ran: None, times: 0, caller: None, first: None };
        let mut finder =
            OccurrenceFinder { source, main, at, ran: 0, main_line: 1, occurrence: path };
        job.run(&mut finder);
        finder.occurrence
    }
}

struct OccurrenceFinder<'s, 'a> {
    source: &'s SourceBlocks<'a>,
    main: &'s Range<usize>,
    at: usize,
    ran: u64,
    main_line: u32,
    occurrence: RunToBlock,
}

impl Sink for OccurrenceFinder<'_, '_> {
    fn command(&mut self, _: &Command) {}

    fn diagnostic(&mut self, _: Diagnostic) {}
}

impl RunSink for OccurrenceFinder<'_, '_> {
    fn wants_blocks(&self) -> bool {
        true
    }

    fn block_done(&mut self, origin: &Origin, _: &dyn Fn() -> Modal) {
        let block = self.source.block_at(origin.span);
        let is_main = origin.call == CallPath::default();
        if is_main {
            self.main_line = origin.line;
        }
        if let Some(at) = block {
            if is_main && self.occurrence.first.is_none() && self.begins(at) {
                self.occurrence.first = Some(self.source.start_of(at));
            }
            if at == self.at && is_main {
                self.occurrence.ran.get_or_insert(self.ran);
                self.occurrence.times += 1;
            } else if at == self.at {
                self.occurrence.caller.get_or_insert(self.main_line);
            }
        }
        self.ran += 1;
    }
}

impl OccurrenceFinder<'_, '_> {
    /// A block that does something; not a head.
    fn begins(&self, at: usize) -> bool {
        let has_words = !self.source.blocks[at].words.is_empty();
        has_words && self.main.contains(&at) && !self.source.heads.contains(&at)
    }
}

/// What holds after so many blocks; nothing where the run is shorter.
pub(super) fn before(job: &Job, source: &SourceBlocks, ran: u64) -> Option<StateBefore> {
    let mut walk = RestartScan {
        source,
        control: job.control(),
        until: ran,
        ran: 0,
        words: StateWords::default(),
        open: OpenConstructs::default(),
        cycle: OpenCycle::default(),
        shift: ActiveShift::default(),
        turned: LatheState::default(),
        unrepeated: Vec::new(),
        x_factor: match job.control().parameters.starts_with_radii {
            true => 1.0,
            false => job.machine().written_factor(0),
        },
        highest: None,
        is_machine: false,
        moved: false,
        before: None,
    };
    job.run(&mut walk);
    walk.before
}

struct RestartScan<'s, 'a> {
    source: &'s SourceBlocks<'a>,
    control: &'s Control,
    until: u64,
    ran: u64,
    words: StateWords,
    open: OpenConstructs,
    cycle: OpenCycle,
    shift: ActiveShift,
    turned: LatheState,
    unrepeated: Vec<UnrepeatedCode>,
    x_factor: f64,
    highest: Option<f64>,
    is_machine: bool,
    /// A move was made.
    moved: bool,
    before: Option<StateBefore>,
}

impl RestartScan<'_, '_> {
    /// Notes what a block opens and closes.
    fn follow(&mut self, block: &Block) {
        let line = Some(block.line);
        self.open.corner = line.filter(|_| block.commas);
        for word in &block.words {
            self.follow_unrepeated(block, word);
            let Some(row) = self.control.row_of(word) else { continue };
            match row.action {
                Action::Once(code) => self.follow_once(code, block),
                Action::Cycle(_) => self.open.cycle = line,
                Action::Call(CallCode::ModalMacroCall { .. })
                | Action::Mode(ModeCode::ModalSubroutine) => self.open.call = line,
                Action::Mode(ModeCode::ModalCallOff) => self.open.call = None,
                Action::Mode(code) => self.follow_mode(code, block.line),
                Action::NotSimulated | Action::NotFollowed if word.letter == b'G' => {
                    self.open.unknown = Some((row.name(word.letter), block.line));
                }
                Action::Reading(ReadingCode::Diameters) => self.x_factor = 2.0,
                Action::Reading(ReadingCode::Radii) => self.x_factor = 1.0,
                Action::Reading(_)
                | Action::Before(_)
                | Action::Length(_)
                | Action::Motion(_)
                | Action::Call(_)
                | Action::After(_)
                | Action::NoEffect
                | Action::NotSimulated
                | Action::NotFollowed => {}
            }
        }
    }

    /// Notes an M code that a head does not repeat; the last of the same words counts.
    fn follow_unrepeated(&mut self, block: &Block, word: &Word) {
        if word.letter != b'M' || word.number().is_none() {
            return;
        }
        let row = self.control.row_of(word);
        let acts_outside = row.is_none_or(|row| {
            matches!(
                row.action,
                Action::NoEffect
                    | Action::NotSimulated
                    | Action::NotFollowed
                    | Action::After(AfterCode::ShopCode)
            )
        });
        if !acts_outside {
            return;
        }
        let is_own = |letter: u8| match row {
            Some(row) => row.words.has(letter),
            None => matches!(letter, b'P' | b'Q'),
        };
        let words = self.source.code_with(block, word, is_own).join(" ");
        self.leave_out(words, block.line);
    }

    /// The last of the same words counts.
    fn leave_out(&mut self, words: String, line: u32) {
        self.unrepeated.retain(|other| other.words != words);
        self.unrepeated.push(UnrepeatedCode { words, line });
    }

    /// Notes a variable or a reference point that was written: a head says neither again.
    fn follow_effect(&mut self, effect: &Effect, line: u32) {
        if self.ran >= self.until {
            return;
        }
        match effect {
            Effect::Variable { number, value: Some(value) } => {
                let value = number_text(*value, 6);
                self.unrepeated.retain(|other| !other.words.starts_with(&format!("#{number}=")));
                self.leave_out(format!("#{number}={value}"), line);
            }
            Effect::Variable { number, value: None } => {
                self.leave_out(format!("#{number}"), line);
            }
            Effect::Written { name, .. } if name.starts_with("reference point") => {
                self.leave_out(name.clone(), line);
            }
            Effect::Written { .. }
            | Effect::Code(_)
            | Effect::Alarm { .. }
            | Effect::Deletable { .. } => {}
        }
    }

    fn follow_mode(&mut self, code: ModeCode, line: u32) {
        let starts = matches!(
            code,
            ModeCode::CompensationLeft
                | ModeCode::CompensationRight
                | ModeCode::CompensationLeftBy
                | ModeCode::CompensationRightBy
        );
        if starts {
            self.open.compensation = Some(line);
        } else if code == (ModeCode::Polar { on: true }) {
            self.open.frame = Some(line);
        }
    }

    fn follow_once(&mut self, code: OnceCode, block: &Block) {
        let line = block.line;
        match code {
            OnceCode::LocalShift => {
                if !self.shift.take(self.source, block) {
                    self.open.shift = Some(line);
                }
            }
            OnceCode::PresetPosition if limits(block, self.control) => {}
            OnceCode::PresetPosition => {
                if self.moved || !self.shift.take_preset(self.source, block) {
                    self.open.shift = Some(line);
                }
            }
            OnceCode::RestorePreset => {
                self.open.shift = Some(line);
            }
            OnceCode::ClearPreset { .. } => {
                self.open.shift = None;
                self.shift.presets.clear();
            }
            OnceCode::Rotation | OnceCode::Scaling | OnceCode::Mirror { .. } => {
                self.open.frame = Some(line);
            }
            // Where it ends the modal state says so.
            OnceCode::Surface(_) => self.open.frame = Some(line),
            OnceCode::MirrorOff
            | OnceCode::Dwell
            | OnceCode::SetData
            | OnceCode::ReturnToReference { .. }
            | OnceCode::ReturnFromReference
            | OnceCode::Home
            | OnceCode::MachineCoordinates
            | OnceCode::CircularPocketCw
            | OnceCode::CircularPocketCcw
            | OnceCode::GeneralPocket
            | OnceCode::Engraving
            | OnceCode::Pattern(_)
            | OnceCode::Probe { .. }
            | OnceCode::Turning(_)
            | OnceCode::CornerArcAlone => {}
        }
    }

    /// Moves to places of the machine say nothing about where the part is clear.
    fn is_to_machine(&self, origin: &Origin) -> bool {
        let is = |action: Action| {
            matches!(
                action,
                Action::Once(
                    OnceCode::MachineCoordinates
                        | OnceCode::ReturnToReference { .. }
                        | OnceCode::Home
                )
            )
        };
        let block = self.source.block_at(origin.span);
        block.is_some_and(|at| self.source.has_action(at, self.control, is))
    }
}

impl Sink for RestartScan<'_, '_> {
    fn command(&mut self, command: &Command) {
        match &command.kind {
            CommandKind::Tool { .. }
            | CommandKind::ToolLength { .. }
            | CommandKind::WorkOffset { .. } => {
                self.highest = None;
                self.turned.approach = None;
            }
            // The tables of offsets are compared; what else is written is not said again.
            CommandKind::Effect(effect) => self.follow_effect(effect, command.origin.line),
            kind => {
                let Some(motion) = kind.motion() else { return };
                self.moved = true;
                self.is_machine = self.is_to_machine(&command.origin);
                if motion.to_known.has(0) && motion.to_known.has(2) && !self.is_machine {
                    self.turned.approach.get_or_insert([motion.to[0], motion.to[2]]);
                }
                if motion.to_known.has(2) && !self.is_machine {
                    let height = self.highest.unwrap_or(f64::NEG_INFINITY);
                    self.highest = Some(height.max(motion.to[2]));
                }
            }
        }
    }

    fn diagnostic(&mut self, _: Diagnostic) {}
}

impl RunSink for RestartScan<'_, '_> {
    fn wants_blocks(&self) -> bool {
        true
    }

    fn block_done(&mut self, origin: &Origin, modal: &dyn Fn() -> Modal) {
        if self.ran >= self.until {
            return;
        }
        if let Some(at) = self.source.block_at(origin.span) {
            let block = &self.source.blocks[at];
            self.words.follow(self.source, self.control, block);
            self.follow(block);
            self.cycle.follow(self.source, self.control, block);
            self.turned.follow(self.source, self.control, block);
        }
        self.ran += 1;
        if self.ran == self.until {
            let modal = modal();
            let highest = self.highest.unwrap_or(f64::NEG_INFINITY).max(modal.position[2]);
            let (stated, open) = (self.words.clone(), self.open.clone());
            let (cycle, shift) = (std::mem::take(&mut self.cycle), std::mem::take(&mut self.shift));
            let turned = std::mem::take(&mut self.turned);
            let unrepeated = std::mem::take(&mut self.unrepeated);
            let x_factor = self.x_factor;
            self.before = Some(StateBefore {
                modal,
                words: stated,
                highest,
                open,
                cycle,
                shift,
                turned,
                unrepeated,
                x_factor,
            });
        }
    }
}
