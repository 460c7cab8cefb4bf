//! The run of a program up to the block that it is to begin at.

use std::ops::Range;

use chordal::control::{Action, AfterCode, Modal, OnceCode, UnrepeatedCode, number_text};
use chordal::path::ProgramFrame;
use chordal::syntax::{Block, Word};
use chordal::{Command, CommandKind, Control, Effect, Job};

use super::cycle::OpenCycle;
use super::lathe::LatheState;
use super::part_frame::{FrameRestart, PartFrameWords};
use crate::source::SourceBlocks;
use crate::state::{OpenConstructs, StateWords, StateWriter};
use crate::walk::{WalkedBlock, first_x_factor, walk, x_factor_after};
use crate::word_address::BlockControl;

/// What a program needs to begin at a block.
#[derive(Debug)]
pub(super) struct StateBefore {
    pub(super) modal: Modal,
    pub(super) words: StateWords,
    /// The highest Z in the work offset and with the length offset in force, mm.
    pub(super) highest: f64,
    pub(super) open: OpenConstructs,
    pub(super) cycle: OpenCycle,
    pub(super) turned: LatheState,
    /// What lies between program and machine coordinates.
    pub(super) frame: ProgramFrame,
    pub(super) part_frame: PartFrameWords,
    pub(super) unrepeated: Vec<UnrepeatedCode>,
    /// What a place of X is multiplied by in a word.
    pub(super) x_factor: f64,
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
        let mut path = RunToBlock { ran: None, times: 0, caller: None, first: None };
        // A block that does something; not a head.
        let begins = |at: &usize| {
            let has_words = !source.blocks[*at].words.is_empty();
            has_words && main.contains(at) && !source.heads.contains(at)
        };
        let mut main_line = 1;
        walk(job, |visit| {
            let block = source.block_at(visit.origin.span);
            if !visit.is_main() {
                if block == Some(at) {
                    path.caller.get_or_insert(main_line);
                }
                return;
            }
            main_line = visit.origin.line;
            if path.first.is_none() {
                path.first = block.filter(begins).map(|at| source.start_of(at));
            }
            if block == Some(at) {
                path.ran.get_or_insert(visit.ran);
                path.times += 1;
            }
        });
        path
    }
}

impl StateBefore {
    /// What holds after so many blocks; nothing where the run is shorter.
    pub(super) fn after_blocks(
        job: &Job,
        source: &SourceBlocks,
        count: u64,
    ) -> Option<StateBefore> {
        let mut scan = RestartScan {
            source,
            control: job.control(),
            words: StateWords::default(),
            open: OpenConstructs::default(),
            cycle: OpenCycle::default(),
            turned: LatheState::default(),
            frame: job.path_builder().frame().clone(),
            part_frame: PartFrameWords::default(),
            unrepeated: Vec::new(),
            x_factor: first_x_factor(job),
            highest: f64::NEG_INFINITY,
            moved: false,
        };
        let mut last = None;
        walk(job, |visit| {
            if visit.ran < count {
                scan.visit(visit);
            }
            if visit.ran + 1 == count {
                last = Some(visit.modal());
            }
        });
        let modal = last?;
        let highest = scan.highest.max(modal.position[2]);
        let RestartScan {
            words, open, cycle, turned, frame, part_frame, unrepeated, x_factor, ..
        } = scan;
        Some(StateBefore {
            modal,
            words,
            highest,
            open,
            cycle,
            turned,
            frame,
            part_frame,
            unrepeated,
            x_factor,
        })
    }

    /// How a head brings back the frame of the part; what stands in the way otherwise.
    pub(super) fn frame_restart(&self) -> Result<FrameRestart, &'static str> {
        match self.modal.frames.part {
            true => self.part_frame.restart(&self.frame),
            false => Ok(FrameRestart::None),
        }
    }

    /// Writes it as words of the program.
    pub(super) fn writer<'w, 'a>(
        &'w self,
        source: &'w SourceBlocks<'a>,
        control: &'w Control,
    ) -> StateWriter<'w, 'a> {
        let StateBefore { modal, words, x_factor, .. } = self;
        StateWriter { source, control, modal, words, x_factor: *x_factor }
    }
}

struct RestartScan<'s, 'a> {
    source: &'s SourceBlocks<'a>,
    control: &'s Control,
    words: StateWords,
    open: OpenConstructs,
    cycle: OpenCycle,
    turned: LatheState,
    frame: ProgramFrame,
    part_frame: PartFrameWords,
    unrepeated: Vec<UnrepeatedCode>,
    x_factor: f64,
    highest: f64,
    /// A move was made.
    moved: bool,
}

impl RestartScan<'_, '_> {
    fn visit(&mut self, visit: &WalkedBlock) {
        for command in &visit.output.commands {
            self.frame.follow(command);
            self.follow_command(command);
        }
        let (source, control) = (self.source, self.control);
        let Some(at) = source.block_at(visit.origin.span) else { return };
        let block = &source.blocks[at];
        self.words.follow(source, control, block);
        self.open.follow(source, control, block, self.moved);
        self.cycle.follow(source, control, block);
        self.turned.follow(source, control, block);
        self.part_frame.follow(source, control, block);
        self.x_factor = x_factor_after(source, control, at, self.x_factor);
        for word in &block.words {
            self.follow_unrepeated(block, word);
        }
    }

    fn follow_command(&mut self, command: &Command) {
        match &command.kind {
            CommandKind::Tool { .. }
            | CommandKind::ToolLength { .. }
            | CommandKind::PartFrame { .. }
            | CommandKind::WorkOffset { .. } => {
                self.highest = f64::NEG_INFINITY;
                self.turned.approach = None;
            }
            // The tables of offsets are compared; what else is written is not said again.
            CommandKind::Effect(effect) => self.follow_effect(effect, command.origin.line),
            kind => {
                let Some(motion) = kind.motion() else { return };
                self.moved = true;
                if !motion.to_known.has(2) || self.is_to_machine(command) {
                    return;
                }
                if motion.to_known.has(0) {
                    self.turned.approach.get_or_insert([motion.to[0], motion.to[2]]);
                }
                self.highest = self.highest.max(motion.to[2]);
            }
        }
    }

    /// Moves to places of the machine say nothing about where the part is clear.
    fn is_to_machine(&self, command: &Command) -> bool {
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
        let block = self.source.block_at(command.origin.span);
        block.is_some_and(|at| self.source.has_action(at, self.control, is))
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
}
