//! What is active at a place of a run in the words of the program.

use chordal::control::{Action, AfterCode, BeforeCode, LengthCode, ModeCode, OnceCode, PathCode};
use std::collections::BTreeMap;

use chordal::Control;
use chordal::control::table::CodeGroup;
use chordal::syntax::{Block, Word};

use crate::source::SourceBlocks;

/// What the program has said so far and what still counts, in its own words.
#[derive(Clone, Debug, Default)]
pub(crate) struct StateWords {
    /// By what they decide about: codes that need no other words.
    pub(crate) codes: BTreeMap<StateSlot, String>,
    /// Codes with words of their own, which stand on lines of their own.
    pub(crate) lines: BTreeMap<StateSlot, String>,
    /// A work offset was chosen.
    pub(crate) work: bool,
    /// The code with H (G43).
    pub(crate) length: Option<String>,
    /// The last H word.
    pub(crate) h: Option<String>,
    /// The words of the last tool change.
    pub(crate) tool: Option<String>,
    /// The code that started the spindle.
    pub(crate) spindle: Option<String>,
    /// The words that started a live tool.
    pub(crate) live: Option<String>,
    /// A speed was given.
    pub(crate) speed: bool,
    /// The codes of coolant that is on.
    pub(crate) coolant: Vec<String>,
    /// Blocks that wrote offsets.
    pub(crate) data: Vec<String>,
}

/// What a code decides about, in the order in which programs say it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum StateSlot {
    Units,
    Plane,
    Distance,
    ArcDistance,
    Compensation,
    Cycle,
    FeedMode,
    ReturnLevel,
    PathMode,
    FeedRamp,
    Smoothness,
    LookAhead(u8),
    Overrides,
    /// One of the overrides by itself, after the code for all of them.
    OverridesByP,
}

fn slot(group: CodeGroup, action: Action) -> Option<StateSlot> {
    Some(match (action, group) {
        (Action::Mode(ModeCode::Path(PathCode::Smoothness)), _) => StateSlot::Smoothness,
        (Action::Mode(ModeCode::Path(PathCode::LookAhead { letter, .. })), _) => {
            StateSlot::LookAhead(letter)
        }
        (Action::Mode(ModeCode::Overrides { .. }), _) => StateSlot::Overrides,
        (Action::Mode(ModeCode::OverridesByP), _) => StateSlot::OverridesByP,
        (Action::Mode(ModeCode::CompensationOff), _) => StateSlot::Compensation,
        (Action::Mode(ModeCode::CancelCycle), _) => StateSlot::Cycle,
        (_, CodeGroup::Units) => StateSlot::Units,
        (_, CodeGroup::Plane) => StateSlot::Plane,
        (_, CodeGroup::Distance) => StateSlot::Distance,
        (_, CodeGroup::ArcDistance) => StateSlot::ArcDistance,
        (_, CodeGroup::FeedMode) => StateSlot::FeedMode,
        (_, CodeGroup::ReturnLevel) => StateSlot::ReturnLevel,
        (_, CodeGroup::PathMode) => StateSlot::PathMode,
        (_, CodeGroup::FeedRamp) => StateSlot::FeedRamp,
        _ => return None,
    })
}

impl StateWords {
    pub(crate) fn follow(&mut self, source: &SourceBlocks, control: &Control, block: &Block) {
        let text = |word: &Word| source.text_of(word);
        let gap = source.style.gap();
        let adjacent =
            |own: &Word, letters: &dyn Fn(u8) -> bool| source.code_with(block, own, letters);
        self.work |= control.table.work_names.by_e && block.word(b'E').is_some();
        self.speed |= block.word(b'S').is_some();
        self.h = block.word(b'H').map(text).or(self.h.take());
        for word in &block.words {
            let Some(row) = control.row_of(word) else { continue };
            if let Some(slot) = slot(row.group, row.action) {
                let words = adjacent(word, &|letter| row.words.has(letter));
                if slot == StateSlot::Overrides {
                    self.lines.remove(&StateSlot::OverridesByP);
                }
                self.codes.remove(&slot);
                self.lines.remove(&slot);
                let has_own_line = words.len() > 1 || word.letter == b'M';
                let slots = if has_own_line { &mut self.lines } else { &mut self.codes };
                slots.insert(slot, words.join(gap));
                continue;
            }
            match row.action {
                Action::Mode(code) => self.work |= code.is_work_offset(),
                Action::Length(code) => {
                    if code != LengthCode::Cancel {
                        self.length = Some(text(word));
                    }
                }
                Action::Before(BeforeCode::ToolChange) => {
                    let words = adjacent(word, &|letter| letter == b'T');
                    self.tool = Some(words.join(gap));
                    self.coolant.clear();
                }
                Action::Before(code) => {
                    let words = adjacent(word, &|letter| letter == b'P' && row.words.has(letter));
                    let names_live = control.parameters.live_tool_p > 0 && words.len() > 1;
                    self.follow_before(code, text(word), names_live.then(|| words.join(gap)));
                    if matches!(code, BeforeCode::LiveToolCw | BeforeCode::LiveToolCcw) {
                        self.live = Some(words.join(gap));
                    }
                }
                Action::After(code) => self.follow_after(code, control),
                Action::Once(code) => {
                    if code == OnceCode::SetData {
                        self.data.push(source.words_of(block));
                    }
                }
                Action::Reading(_)
                | Action::Motion(_)
                | Action::Cycle(_)
                | Action::Call(_)
                | Action::NoEffect
                | Action::NotSimulated
                | Action::NotFollowed => {}
            }
        }
    }

    /// `with_p`: M3 or M4 with the P that says what turns.
    fn follow_before(&mut self, code: BeforeCode, text: String, with_p: Option<String>) {
        match code {
            BeforeCode::SpindleCw | BeforeCode::SpindleCcw => {
                self.live = with_p.clone();
                self.spindle = Some(with_p.unwrap_or(text));
            }
            BeforeCode::CoolantMist | BeforeCode::CoolantFlood | BeforeCode::CoolantThroughTool => {
                self.coolant.retain(|stated| *stated != text);
                self.coolant.push(text);
            }
            BeforeCode::ToolChange
            | BeforeCode::SetToolNumber
            | BeforeCode::SpindleOrient
            | BeforeCode::LiveToolCw
            | BeforeCode::LiveToolCcw
            | BeforeCode::CAxisOn
            | BeforeCode::AnalogueOutput
            | BeforeCode::SaveModes { .. }
            | BeforeCode::ForgetModes
            | BeforeCode::RestoreModes => {}
        }
    }

    fn follow_after(&mut self, code: AfterCode, control: &Control) {
        match code {
            AfterCode::CoolantOff => self.coolant.clear(),
            AfterCode::CoolantThroughToolOff => self.coolant.retain(|stated| {
                !control.table.m_codes.iter().any(|row| {
                    row.action == Action::Before(BeforeCode::CoolantThroughTool)
                        && row.name(b'M') == *stated
                })
            }),
            AfterCode::SpindleStop
            | AfterCode::LiveToolStop
            | AfterCode::ProgramStop
            | AfterCode::OptionalStop
            | AfterCode::ProgramEnd { .. }
            | AfterCode::ProgramAgain
            | AfterCode::ShopCode
            | AfterCode::RunCycleHere => {}
        }
    }
}
