//! What is active in the program that is written, and the blocks so far.

use chordal_command::{CompensationSide, Coolant, FeedMode, SpindleState};
use chordal_kernel::{
    PostedProgram, WriterNote, WriterOptions, WrittenLengths, WrittenLine, WrittenProgram,
};

use super::words::unit_name;
use crate::settings::HeidenhainSettings;

/// Old controls take two M functions in a block.
const MAX_FUNCTIONS: usize = 2;

/// The longest name of a program.
const MAX_NAME: usize = 16;

/// What the program wants, and what is written.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct DesiredMode<T> {
    /// What the next move needs.
    pub desired: T,
    /// What is active.
    pub written: T,
}

impl<T: Copy + PartialEq> DesiredMode<T> {
    fn new(value: T) -> DesiredMode<T> {
        DesiredMode { desired: value, written: value }
    }

    /// What is to be written now; `None` where it is active.
    pub fn take(&mut self) -> Option<T> {
        let is_new = self.desired != self.written;
        self.written = self.desired;
        is_new.then_some(self.desired)
    }
}

/// Puts words into blocks.
pub(super) struct KlartextBlocks<'a> {
    pub settings: HeidenhainSettings,
    pub options: &'a WriterOptions,
    pub program: &'a PostedProgram,
    /// The step that is written.
    pub step: usize,
    pub written: WrittenProgram,
    pub lengths: WrittenLengths,
    pub feed: Option<String>,
    pub feed_mode: DesiredMode<FeedMode>,
    /// The preset by its line, which is the number of the work offset.
    pub preset: DesiredMode<u32>,
    /// How far from the path the control may go (cycle 32), mm.
    pub tolerance: DesiredMode<Option<f64>>,
    pub tool: u32,
    /// A TOOL CALL has given the tool axis.
    pub has_tool_axis: bool,
    /// The tool whose length the program wants.
    pub length: Option<u32>,
    /// The tool has changed since the last move along it: how long the next one is depends on its length.
    pub is_length_new: bool,
    pub side: DesiredMode<CompensationSide>,
    pub spindle: DesiredMode<SpindleState>,
    /// S, rev/min.
    pub speed: DesiredMode<f64>,
    pub coolant: Coolant,
    /// Outside corners are passed without an arc (M97).
    pub meets_corner: bool,
    /// The last CC.
    pub center: Option<String>,
    /// The last cycle that was defined.
    pub cycle: Option<String>,
    /// The next straight move calls the cycle (M99).
    pub calls_cycle: bool,
    /// The last move has called it.
    pub has_called: bool,
    /// M functions of the next block that moves.
    functions: Vec<String>,
}

impl<'a> KlartextBlocks<'a> {
    pub fn new(
        settings: HeidenhainSettings,
        program: &'a PostedProgram,
        options: &'a WriterOptions,
    ) -> KlartextBlocks<'a> {
        let start = program.start;
        KlartextBlocks {
            settings,
            options,
            program,
            step: 0,
            written: WrittenProgram::default(),
            lengths: WrittenLengths { units: start.units, digits: options.digits },
            feed: None,
            feed_mode: DesiredMode { desired: start.feed_mode, written: FeedMode::PerTime },
            preset: DesiredMode::new(start.work),
            tolerance: DesiredMode::new(None),
            tool: 0,
            has_tool_axis: false,
            length: None,
            is_length_new: true,
            side: DesiredMode::new(CompensationSide::Off),
            spindle: DesiredMode::new(SpindleState::Off),
            speed: DesiredMode::new(0.0),
            coolant: Coolant::default(),
            meets_corner: false,
            center: None,
            cycle: None,
            calls_cycle: false,
            has_called: false,
            functions: Vec::new(),
        }
    }

    /// The first blocks: the name, the unit, and the preset that the program begins with.
    pub fn begin(&mut self) {
        self.frame_line(format!("BEGIN PGM {} {}", self.name(), unit_name(self.lengths.units)));
        if self.program.start.work > 0 {
            self.frame_line(preset_block(self.program.start.work));
        }
    }

    /// What is still to be written at the end.
    pub fn finish(&mut self) {
        self.flush();
        self.frame_line(format!("END PGM {} {}", self.name(), unit_name(self.lengths.units)));
    }

    fn frame_line(&mut self, text: String) {
        self.written.lines.push(WrittenLine { text, step: None });
    }

    /// The name of the program, or its number, in letters that a file may have.
    fn name(&self) -> String {
        let number = self.program.number.map(|number| number.to_string());
        let own = self.program.name.clone().filter(|_| number.is_none());
        let name: String = number.or(own).unwrap_or_default();
        let is_kept = |letter: &char| letter.is_ascii_alphanumeric() || "_-".contains(*letter);
        let name: String = name.chars().filter(is_kept).take(MAX_NAME).collect();
        if name.is_empty() { "PROGRAM".into() } else { name.to_ascii_uppercase() }
    }

    /// A block of its own; what waits for a move keeps waiting.
    pub fn line(&mut self, text: impl Into<String>) {
        self.written.lines.push(WrittenLine { text: text.into(), step: Some(self.step) });
    }

    /// A block of its own, after the M functions that wait for a move.
    pub fn alone(&mut self, text: impl Into<String>) {
        self.flush();
        self.line(text);
    }

    /// Writes the M functions that wait for a move as a block.
    pub fn flush(&mut self) {
        if !self.functions.is_empty() {
            let functions = std::mem::take(&mut self.functions);
            self.line(functions.join(" "));
        }
    }

    /// An M function of the next block that moves.
    pub fn wait(&mut self, function: impl Into<String>) {
        if self.functions.len() == MAX_FUNCTIONS {
            self.flush();
        }
        self.functions.push(function.into());
    }

    /// The M functions that wait for a move.
    pub fn take_functions(&mut self) -> Vec<String> {
        std::mem::take(&mut self.functions)
    }

    /// Says what became of the step.
    pub fn note(&mut self, words: impl Into<String>, reason: impl Into<String>) {
        let note = WriterNote { step: self.step, words: words.into(), reason: reason.into() };
        self.written.notes.push(note);
    }
}

/// Cycle 247 with a line of the preset table.
pub(super) fn preset_block(preset: u32) -> String {
    format!("CYCL DEF 247 DATUM SETTING ~\n  Q339=+{preset} ;DATUM NUMBER")
}
