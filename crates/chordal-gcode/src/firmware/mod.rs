//! The firmware of a small control (GRBL): it judges a block as a whole, before anything of it acts.
//!
//! | file | |
//! |---|---|
//! | `line.rs` | the characters that count, words, numbers |
//! | `codes.rs` | what a code takes and changes |
//! | `judge.rs` | the words of a block, and its first mistake |
//! | `once.rs` | codes that take the axis words, and what they write |
//! | `motion.rs` | straight lines, arcs, splines, cycles |
//! | `memory.rs` | what the next verdict depends on |
//!
//! A block that passes goes on to the interpreter, with its words as the firmware has read them; one that does not
//! changes nothing.

mod block_check;
mod codes;
mod line;
mod memory;
mod motion;
mod one_shot;

use chordal_diagnostics::TextRange;
use chordal_dialect::Control;
use chordal_dialect::firmware::{Firmware, FirmwareError};
use chordal_syntax::{Block, BlockKind, Decimal, Word, WordValue};

use block_check::AcceptedBlock;
pub(crate) use line::LineFault;
use line::{FirmwareLine, ReadWord};
use memory::FirmwareMemory;

/// System commands without a value.
const COMMANDS: [&str; 9] = ["$", "#", "G", "I", "N", "H", "X", "C", "SLP"];

/// What a line is to the firmware.
#[derive(Debug)]
pub(crate) enum FirmwareAnswer {
    /// Nothing on it, or a command that moves nothing.
    Nothing,
    /// Words that act: the block has them now. Of those that it has no more nothing comes (axis words next to G49, a centre outside the plane).
    Words(Vec<Word>),
    /// `$H`: the machine goes to its switches.
    Homing,
    /// `$J=`: a jog, with its words.
    Jog(Vec<Word>),
    /// `$120=400`: a setting.
    Setting,
    /// It is refused.
    Refused(LineFault),
}

/// A firmware at work.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct FirmwareChecker {
    memory: FirmwareMemory,
}

impl FirmwareChecker {
    /// At power-on, mm: where the machine is, and its work offsets.
    pub fn new(position: [f64; 3], systems: &[[f64; 3]]) -> FirmwareChecker {
        let single = |place: &[f64; 3]| place.map(|value| value as f32);
        let systems = systems.iter().map(single).collect();
        FirmwareChecker { memory: FirmwareMemory::new(single(&position), systems) }
    }

    /// Machine coordinates as the firmware counts them, mm.
    #[cfg(test)]
    pub fn position(&self) -> [f32; 3] {
        self.memory.position
    }

    /// The machine has gone there by itself, mm.
    pub fn set_position(&mut self, position: [f64; 3]) {
        self.memory.position = position.map(|value| value as f32);
    }

    /// The tool length that the table of the control gives, mm.
    pub fn set_length(&mut self, length: [f64; 3]) {
        self.memory.length = length.map(|value| value as f32);
    }

    /// There is a feed, and nobody knows it.
    pub fn assume_feed(&mut self) {
        self.memory.feed = 1.0;
    }

    /// Reads and judges the line of a block; one that acts has the firmware's words then. `deletes`: block delete is on.
    /// `resolved`: the values of its expressions are in its words.
    pub fn take(
        &mut self,
        block: &mut Block,
        text: &[u8],
        control: &Control,
        firmware: &Firmware,
        deletes: bool,
        resolved: bool,
    ) -> FirmwareAnswer {
        let whole = block.range;
        let verdict = match resolved {
            true => self.resolved(block, control, firmware),
            false => self.line(whole.slice(text), whole, control, firmware, deletes),
        };
        block.problems.clear();
        block.delete = None;
        block.expressions = false;
        block.kind = BlockKind::Words;
        block.truncate(0);
        match verdict {
            Ok(Some(accepted)) => {
                self.memory = accepted.after;
                accepted.words.iter().for_each(|word| block.push(word_of(word)));
                FirmwareAnswer::Words(accepted.dropped.iter().map(word_of).collect())
            }
            Ok(None) => FirmwareAnswer::Nothing,
            Err(verdict) => verdict,
        }
    }

    fn line(
        &mut self,
        text: &[u8],
        whole: TextRange,
        control: &Control,
        firmware: &Firmware,
        deletes: bool,
    ) -> Result<Option<AcceptedBlock>, FirmwareAnswer> {
        let mut line = FirmwareLine::of(text, whole.start, &firmware.line, deletes)
            .map_err(FirmwareAnswer::Refused)?;
        if line.is_empty() || line.is_mark() {
            return Ok(None);
        }
        if let Some(command) = line.command() {
            return Err(self.command(&command, &mut line, whole, control, firmware));
        }
        let words = std::iter::from_fn(|| line.word());
        let accepted = block_check::judge(words, whole, control, firmware, &self.memory, false);
        accepted.map(Some).map_err(FirmwareAnswer::Refused)
    }

    /// Judges words whose expressions have their values.
    fn resolved(
        &self,
        block: &Block,
        control: &Control,
        firmware: &Firmware,
    ) -> Result<Option<AcceptedBlock>, FirmwareAnswer> {
        let read = block.words.iter().filter_map(|word| {
            let number = word.number()?;
            Some(Ok(ReadWord {
                letter: word.letter,
                value: number.to_f64() as f32,
                number,
                range: word.range,
            }))
        });
        let accepted =
            block_check::judge(read, block.range, control, firmware, &self.memory, false);
        accepted.map(Some).map_err(FirmwareAnswer::Refused)
    }

    fn command(
        &mut self,
        command: &str,
        line: &mut FirmwareLine,
        whole: TextRange,
        control: &Control,
        firmware: &Firmware,
    ) -> FirmwareAnswer {
        if command.starts_with("J=") {
            line.skip("$J=".len());
            let words = std::iter::from_fn(|| line.word());
            return match block_check::judge(words, whole, control, firmware, &self.memory, true) {
                Ok(accepted) => {
                    self.memory.position = accepted.after.position;
                    FirmwareAnswer::Jog(accepted.words.iter().map(word_of).collect())
                }
                Err(fault) => FirmwareAnswer::Refused(fault),
            };
        }
        if command == "H" {
            return FirmwareAnswer::Homing;
        }
        let (name, value) = command.split_once('=').unwrap_or((command, ""));
        let is_number = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
        let is_text = matches!(name, "N0" | "N1" | "RST") && !value.is_empty();
        match command {
            _ if COMMANDS.contains(&command) || command.is_empty() => FirmwareAnswer::Nothing,
            _ if is_text || is_number(name) && value.parse::<f32>().is_ok() => {
                FirmwareAnswer::Setting
            }
            _ if firmware.line.named_commands && !is_number(name) => FirmwareAnswer::Setting,
            _ if is_number(name) => {
                FirmwareAnswer::Refused(LineFault::new(FirmwareError::NoNumber, whole))
            }
            _ => FirmwareAnswer::Refused(LineFault::new(FirmwareError::UnknownCommand, whole)),
        }
    }
}

/// A word as the interpreter reads it.
fn word_of(read: &ReadWord) -> Word {
    let number = match read.letter {
        b'N' | b'T' => Decimal::integer(read.value.trunc() as i64),
        _ => read.number,
    };
    let value = WordValue::Number(number);
    Word { letter: read.letter, register: None, comma: false, value, range: read.range }
}
