//! What a lathe needs to begin at a block: station and offset, limit and cutting speed, the first of two blocks of a cycle,
//! and the way to where the tool is.

use std::collections::BTreeMap;

use chordal::Control;
use chordal::control::{MotionCode, OnceCode, ToolWord, code_number};
use chordal::syntax::Block;

use crate::source::{SourceBlocks, code_action, is_setup};
use crate::state::limits_spindle;

/// What the blocks of a lathe's program have said so far.
#[derive(Clone, Debug, Default)]
pub(super) struct LatheState {
    /// The last word of a station and its offset.
    pub(super) station: Option<String>,
    /// The block that limits the spindle.
    pub(super) limit: Option<String>,
    /// The first of two blocks of each cycle, by its code.
    pub(super) setups: BTreeMap<u16, String>,
    /// Where the tool came to first with its offset, X (a radius) and Z, mm.
    pub(super) approach: Option<[f64; 2]>,
    /// The block of the pass that is repeated by blocks without a code.
    pub(super) pass: Option<u32>,
}

impl LatheState {
    pub(super) fn follow(&mut self, source: &SourceBlocks, control: &Control, block: &Block) {
        if !control.table.turns() {
            return;
        }
        let mut takes_t = false;
        for word in &block.words {
            let Some(action) = code_action(word, control) else { continue };
            let once = action.once();
            takes_t |=
                once.is_some_and(|code| matches!(code, OnceCode::Turning(_) | OnceCode::SetData));
            if once == Some(OnceCode::PresetPosition) && limits_spindle(block, control) {
                self.limit = Some(source.words_of(block));
            }
            if let (Some(OnceCode::Turning(cycle)), Some(code)) =
                (once, word.number().and_then(code_number))
                && is_setup(cycle, block, control)
            {
                self.setups.insert(code, source.words_of(block));
            }
            if let Some(motion) = action.motion() {
                let is_pass = matches!(motion, MotionCode::Turn(_));
                self.pass = is_pass.then_some(block.line);
            }
        }
        if let Some(word) = block.word(b'T').filter(|_| !takes_t && has_stations(control)) {
            self.station =
                Some(String::from_utf8_lossy(word.range.slice(source.text)).into_owned());
        }
    }
}

/// T names a station and its offset.
pub(super) fn has_stations(control: &Control) -> bool {
    matches!(control.parameters.tool_word, ToolWord::StationAndOffset { .. })
}

/// A block that is the first of two of a cycle.
pub(super) fn says_setup(block: &Block, control: &Control) -> bool {
    block.words.iter().any(|word| {
        let once = code_action(word, control).and_then(|action| action.once());
        matches!(once, Some(OnceCode::Turning(cycle)) if is_setup(cycle, block, control))
    })
}
