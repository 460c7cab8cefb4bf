//! Coordinates of the part before a block: tool centre point control and tilted planes, in the words of the program.

use chordal::Control;
use chordal::control::{Action, LengthCode, ModeCode, OnceCode, TiltedPlaneCode};
use chordal::path::ProgramFrame;
use chordal::syntax::{Block, Letters, Word};

use crate::convert::codes::name;
use crate::source::SourceBlocks;

/// What the program has said of its frame of the part so far, as far as it still counts.
#[derive(Debug, Default)]
pub(super) struct PartFrameWords {
    /// The blocks that defined a tilted plane, and the codes that turned to it, in order.
    pub(super) plane: Vec<String>,
    /// The rotary axes have turned to the plane.
    has_turned: bool,
    /// The code that tool lengths are in force by.
    length: Option<LengthCode>,
    /// I, J and K of the last block that gave the direction of the tool (G43.5).
    pub(super) vector: Vec<String>,
}

/// How a head brings a frame of the part back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FrameRestart {
    /// There is none.
    None,
    /// It repeats the blocks of a tilted plane, and works in it as it would without one.
    Plane,
    /// It turns the rotary axes, and goes to the place along the tool.
    AlongTool,
}

impl PartFrameWords {
    pub(super) fn follow(&mut self, source: &SourceBlocks, control: &Control, block: &Block) {
        for word in &block.words {
            let Some(row) = control.row_of(word) else { continue };
            match row.action {
                Action::Length(LengthCode::Cancel) => (self.length, self.vector) = (None, vec![]),
                Action::Length(code) => self.length = Some(code),
                Action::Mode(ModeCode::RotationOff) => self.end_plane(),
                Action::Once(OnceCode::TiltedPlane(code)) => {
                    self.follow_plane(source, control, block, (word, code));
                }
                Action::Reading(_)
                | Action::Before(_)
                | Action::Mode(_)
                | Action::Motion(_)
                | Action::Cycle(_)
                | Action::Once(_)
                | Action::Call(_)
                | Action::After(_)
                | Action::NoEffect
                | Action::NotSimulated
                | Action::NotFollowed => {}
            }
        }
        let vector = Letters::of("IJK");
        if self.length == Some(LengthCode::ToolCenterByVector) && block.letters().meets(vector) {
            let words = block.words.iter().filter(|word| vector.has(word.letter));
            self.vector = words.map(|word| source.text_of(word)).collect();
        }
    }

    fn follow_plane(
        &mut self,
        source: &SourceBlocks,
        control: &Control,
        block: &Block,
        (word, code): (&Word, TiltedPlaneCode),
    ) {
        match code {
            TiltedPlaneCode::Turn { holds_tip } => {
                let is_own =
                    |letter: u8| control.row_of(word).is_some_and(|row| row.words.has(letter));
                let mut words = source.code_with(block, word, is_own);
                // A head turns far from the part, where no tip can be held.
                let alone = TiltedPlaneCode::Turn { holds_tip: false };
                let alone = Action::Once(OnceCode::TiltedPlane(alone));
                let alone = holds_tip.then(|| name(alone, control, source.style)).flatten();
                if let (Some(alone), Some(code)) = (alone, words.first_mut()) {
                    *code = alone;
                }
                self.plane.push(words.join(source.style.gap()));
                self.has_turned = true;
            }
            TiltedPlaneCode::Define { in_active } => self.define(source.words_of(block), in_active),
            TiltedPlaneCode::DefineByAxes
            | TiltedPlaneCode::DefineByTool
            | TiltedPlaneCode::OriginOnTable { on: true } => {
                self.define(source.words_of(block), false);
            }
            TiltedPlaneCode::Off | TiltedPlaneCode::OriginOnTable { on: false } => self.end_plane(),
        }
    }

    /// A definition may have several blocks, and replaces a plane to which the axes have turned.
    fn define(&mut self, words: String, in_active: bool) {
        if self.has_turned && !in_active {
            self.end_plane();
        }
        self.plane.push(words);
    }

    fn end_plane(&mut self) {
        self.plane.clear();
        self.has_turned = false;
    }

    /// How a head brings back the frame that is in force; what stands in the way otherwise.
    pub(super) fn restart(&self, frame: &ProgramFrame) -> Result<FrameRestart, &'static str> {
        let Some(part_frame) = &frame.part_frame else { return Ok(FrameRestart::None) };
        let is_by_code =
            matches!(self.length, Some(LengthCode::ToolCenter | LengthCode::ToolCenterByVector));
        match (part_frame.follows_tip, part_frame.is_level()) {
            (true, true) if is_by_code => Ok(FrameRestart::AlongTool),
            (true, true) => Err("the control holds the tip without a code of the program"),
            (true, false) => Err("tool centre point control is active in a tilted plane"),
            (false, _) if self.plane.is_empty() => Err("a tilted plane is active"),
            (false, _) => Ok(FrameRestart::Plane),
        }
    }
}
