//! The words that a canned cycle in force was given, to be said again without making a hole.

use chordal::Control;
use chordal::control::{Action, Modal, ModeCode, ReadingCode};
use chordal::control::{CycleKind, DefinitionFires, ZeroRepeats};
use chordal::geometry::Plane;
use chordal::syntax::Block;

use crate::source::SourceBlocks;

/// A cycle as the program has said it.
#[derive(Clone, Debug, Default)]
pub(super) struct OpenCycle {
    kind: Option<CycleKind>,
    /// Its code.
    code: String,
    /// Its words by their letters, the last of each.
    words: Vec<(u8, String)>,
    /// A word that is no plain number, which a head cannot say again.
    unclear: Option<String>,
    /// The block that readies a tap, before the cycle.
    ready: Option<String>,
    /// What the block just before was, if it may ready one.
    before: Option<String>,
    /// The last code of a rapid or a straight cut, which holds again after the cycle.
    motion: Option<String>,
    /// G91 holds.
    incremental: bool,
    /// It held where the cycle was given its words: they are distances.
    pub(super) by_distance: bool,
}

impl OpenCycle {
    /// Takes the words of the next block of the run.
    pub(super) fn follow(&mut self, source: &SourceBlocks, control: &Control, block: &Block) {
        let text = |word: &chordal::syntax::Word| {
            String::from_utf8_lossy(word.range.slice(source.text)).into_owned()
        };
        let rows = || block.words.iter().filter_map(|word| Some((word, control.row_of(word)?)));
        let motion = rows().rfind(|(_, row)| matches!(row.action, Action::Motion(_)));
        self.motion = motion.map(|(word, _)| text(word)).or(self.motion.take());
        for (_, row) in rows() {
            if row.action == Action::Reading(ReadingCode::Absolute) {
                self.incremental = false;
            } else if row.action == Action::Reading(ReadingCode::Incremental) {
                self.incremental = true;
            }
        }
        let ends = rows().any(|(_, row)| row.action == Action::Mode(ModeCode::CancelCycle));
        let begun = rows().find_map(|(word, row)| {
            let Action::Cycle(kind) = row.action else { return None };
            Some((text(word), kind))
        });
        if let Some((code, kind)) = begun {
            if self.kind != Some(kind) && !control.parameters.rules.cycles.keeps_words {
                (self.words, self.unclear) = (Vec::new(), None);
            }
            (self.kind, self.code) = (Some(kind), code);
            self.by_distance = self.incremental;
            self.ready = self.before.take().filter(|_| kind.is_tap());
        } else if ends || self.kind.is_none() {
            self.before = readies(source, control, block);
            (self.kind, self.words, self.unclear) = (None, Vec::new(), None);
            return;
        }
        for word in &block.words {
            let is_data = control.row_of(word).is_none() && !b"NOGMTSHD/".contains(&word.letter);
            if !is_data || word.letter == control.parameters.rules.cycles.repeat_letter {
                continue;
            }
            if word.number().is_none() || word.comma {
                self.unclear.get_or_insert(text(word));
            }
            self.words.retain(|(letter, _)| *letter != word.letter);
            self.words.push((word.letter, text(word)));
        }
    }

    /// The lines that put it in force where the tool stands, without a hole; or what stands in the way.
    pub(super) fn lines(
        &self,
        modal: &Modal,
        control: &Control,
        gap: &str,
    ) -> Result<Vec<String>, String> {
        let rules = &control.parameters.rules.cycles;
        if let Some(word) = &self.unclear {
            return Err(format!("the cycle in force has the word {word}, which is no number"));
        }
        let mut words = vec![self.code.clone()];
        let depth = b"ZYX"[match modal.plane {
            Plane::Xy => 0,
            Plane::Zx => 1,
            Plane::Yz => 2,
        }];
        let is_place = |letter: u8| b"XYZABC".contains(&letter) && letter != depth;
        words.extend(
            self.words
                .iter()
                .filter(|(letter, _)| !is_place(*letter))
                .map(|(_, text)| text.clone()),
        );
        if rules.definition == DefinitionFires::Always {
            if rules.zero_repeats == ZeroRepeats::Refused {
                let what =
                    "a canned cycle is in force, and this control cannot begin one without a hole";
                return Err(what.into());
            }
            words.push(format!("{}0", char::from(rules.repeat_letter)));
        }
        let line = words.join(gap);
        Ok(self.motion.iter().chain(&self.ready).cloned().chain([line]).collect())
    }
}

/// The words of a block that may ready a tap: a code without effect on the path, such as M29, and nothing that
/// moves.
fn readies(source: &SourceBlocks, control: &Control, block: &Block) -> Option<String> {
    let is_one = |word: &chordal::syntax::Word| {
        control.row_of(word).is_some_and(|row| row.action == Action::NoEffect)
    };
    let moves = block.words.iter().any(|word| b"XYZABC".contains(&word.letter));
    if moves || !block.words.iter().any(is_one) {
        return None;
    }
    Some(source.words_of(block))
}
