//! What is active in the program that is written, and the blocks so far.

use chordal_command::{CompensationSide, Coolant, FeedMode, PathMode, SpindleState, Units};
use chordal_geometry::Plane;
use chordal_kernel::{
    PostedProgram, WriterNote, WriterOptions, WrittenLengths, WrittenLine, WrittenProgram,
};

use crate::settings::SinumerikSettings;

/// The motion that is active.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum WrittenMotion {
    Rapid,
    Linear,
}

/// The tool length that a program wants, and the edge that is active.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct WrittenEdge {
    /// The number of the length that is desired; `None` for none.
    pub desired: Option<u32>,
    /// D1 is active; `false` for D0.
    pub is_on: bool,
    /// The desired length has not been written since it was programmed.
    pub is_due: bool,
}

/// Puts words into blocks.
pub(super) struct BlockWriter<'a> {
    pub settings: SinumerikSettings,
    pub options: &'a WriterOptions,
    pub program: &'a PostedProgram,
    /// The step that is written.
    pub step: usize,
    pub written: WrittenProgram,
    pub lengths: WrittenLengths,
    pub motion: Option<WrittenMotion>,
    pub feed: Option<String>,
    pub feed_mode: FeedMode,
    pub plane: Plane,
    pub work: u32,
    pub tool: u32,
    pub edge: WrittenEdge,
    pub side: CompensationSide,
    pub spindle: (SpindleState, f64),
    pub coolant: Coolant,
    pub path_mode: Option<PathMode>,
    /// The cycle of the active MCALL.
    pub modal_call: Option<String>,
    /// Words of the next block that moves, one of each group.
    pending: Vec<(WordGroup, String)>,
}

/// What a word that waits for a move is about: a later one takes its place.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum WordGroup {
    Plane,
    FeedMode,
    PathMode,
    Work,
    Side,
    Corner,
    Feed,
    Edge,
}

impl<'a> BlockWriter<'a> {
    pub fn new(
        settings: SinumerikSettings,
        program: &'a PostedProgram,
        options: &'a WriterOptions,
    ) -> BlockWriter<'a> {
        let start = program.start;
        BlockWriter {
            settings,
            options,
            program,
            step: 0,
            written: WrittenProgram::default(),
            lengths: WrittenLengths { units: start.units, digits: options.digits },
            motion: None,
            feed: None,
            feed_mode: start.feed_mode,
            plane: start.plane,
            work: start.work,
            tool: 0,
            edge: WrittenEdge::default(),
            side: CompensationSide::Off,
            spindle: (SpindleState::Off, 0.0),
            coolant: Coolant::default(),
            path_mode: None,
            modal_call: None,
            pending: Vec::new(),
        }
    }

    /// The first block: everything that the control may have active otherwise.
    pub fn begin(&mut self) {
        if let Some(name) = &self.program.name {
            let text = format!("; {name}");
            self.written.lines.push(WrittenLine { text, step: None });
        }
        let start = self.program.start;
        let words = [
            plane_code(start.plane),
            units_code(start.units),
            "G90",
            "G40",
            feed_mode_code(start.feed_mode),
        ];
        let text = format!("{} {}", words.join(" "), work_code(start.work));
        self.written.lines.push(WrittenLine { text, step: None });
    }

    /// What is still to be written at the end.
    pub fn finish(&mut self) {
        self.end_modal_call();
        self.flush();
    }

    /// A block of its own.
    pub fn line(&mut self, text: impl Into<String>) {
        self.written.lines.push(WrittenLine { text: text.into(), step: Some(self.step) });
    }

    /// Writes the words that wait for a move as a block.
    pub fn flush(&mut self) {
        if !self.pending.is_empty() {
            let words = self.take_pending();
            self.line(words.concat().join(" "));
        }
    }

    /// The words that wait for a move: those before its own words, and those after them.
    pub fn take_pending(&mut self) -> [Vec<String>; 2] {
        let is_last = |group| matches!(group, WordGroup::Feed | WordGroup::Edge);
        let pending = std::mem::take(&mut self.pending);
        let (last, first): (Vec<_>, Vec<_>) =
            pending.into_iter().partition(|(group, _)| is_last(*group));
        [first, last].map(|words| words.into_iter().map(|(_, word)| word).collect())
    }

    /// A block without a move: what waits for a move comes before it.
    pub fn alone(&mut self, text: impl Into<String>) {
        self.flush();
        self.line(text);
    }

    /// A word of the next block that moves.
    pub fn wait(&mut self, group: WordGroup, word: impl Into<String>) {
        let word = word.into();
        match self.pending.iter_mut().find(|(own, _)| *own == group) {
            Some((_, waiting)) => *waiting = word,
            None => self.pending.push((group, word)),
        }
    }

    /// Says what became of the step.
    pub fn note(&mut self, words: impl Into<String>, reason: impl Into<String>) {
        let note = WriterNote { step: self.step, words: words.into(), reason: reason.into() };
        self.written.notes.push(note);
    }

    /// Ends the active MCALL.
    pub fn end_modal_call(&mut self) {
        if self.modal_call.take().is_some() {
            self.alone("MCALL");
        }
    }
}

pub(super) fn plane_code(plane: Plane) -> &'static str {
    match plane {
        Plane::Xy => "G17",
        Plane::Zx => "G18",
        Plane::Yz => "G19",
    }
}

/// G700 and G710: the unit acts on feeds, too.
pub(super) fn units_code(units: Units) -> &'static str {
    match units {
        Units::Inch => "G700",
        Units::Millimetre => "G710",
    }
}

pub(super) fn feed_mode_code(mode: FeedMode) -> &'static str {
    match mode {
        FeedMode::InverseTime => "G93",
        FeedMode::PerTime => "G94",
        FeedMode::PerRevolution => "G95",
    }
}

/// The code of a work offset: G54 to G57, G505 to G599, G500 for none.
pub(super) fn work_code(ordinal: u32) -> String {
    match ordinal {
        1..=4 => format!("G{}", 53 + ordinal),
        _ => format!("G{}", 500 + ordinal),
    }
}
