//! The parts as texts.

use chordal::control::{Action, AfterCode, MotionCode, ReadingCode};
use chordal::control::{Modal, ProgramPlace, SpindleState};
use chordal::diagnostics::TextRange;
use chordal::syntax::{Block, Word};
use chordal::{Control, Job};

use super::points::{SafePointKind, SplitPoint, SplitSurvey};
use super::{ProgramPart, WrittenParts};
use crate::convert::codes;
use crate::source::{SourceBlocks, SubprogramForm};
use crate::state::{StateSlot, StateWords, StateWriter};
use crate::walk::walk;
use crate::word_address::BlockControl;

/// What holds before a block.
#[derive(Clone, Debug)]
pub(super) struct StateAt {
    modal: Modal,
    words: StateWords,
}

/// What holds at places, in the order of the run.
pub(super) fn states_at(job: &Job, source: &SourceBlocks, points: &[SplitPoint]) -> Vec<StateAt> {
    let (mut words, mut states) = (StateWords::default(), Vec::new());
    walk(job, |visit| {
        if let Some(at) = source.block_at(visit.origin.span) {
            words.follow(source, job.control(), &source.blocks[at]);
        }
        let next: Option<&SplitPoint> = points.get(states.len());
        if next.is_some_and(|point| u64::from(point.ran) == visit.ran + 1) {
            states.push(StateAt { modal: visit.modal(), words: words.clone() });
        }
    });
    states
}

/// What a part has from the whole.
#[derive(Clone, Debug)]
pub(super) struct PartText {
    pub(super) body: chordal_compare::RetainedText,
    pub(super) other_texts: Vec<chordal_compare::RetainedText>,
}

/// Writes parts.
pub(super) struct PartWriter<'w, 'a> {
    source: &'w SourceBlocks<'a>,
    control: &'w Control,
    survey: &'w SplitSurvey,
    line_end: &'static str,
    /// The blocks before the first of the main program: head, remarks, `L` sections.
    first: usize,
    /// Numbers that programs of the job have.
    taken: Vec<u32>,
}

/// A part that is being written.
#[derive(Default)]
struct PartDraft {
    text: Vec<u8>,
    lines: u32,
    other_texts: Vec<chordal_compare::RetainedText>,
}

impl PartDraft {
    /// A line that is put in.
    fn line(&mut self, words: &str, line_end: &str) {
        self.text.extend_from_slice(words.as_bytes());
        self.text.extend_from_slice(line_end.as_bytes());
        self.lines += 1;
    }

    /// Blocks of the whole.
    fn keep(
        &mut self,
        source: &SourceBlocks,
        blocks: std::ops::Range<usize>,
    ) -> chordal_compare::RetainedText {
        let (from, to) = (source.start_of(blocks.start), source.start_of(blocks.end));
        let start = self.text.len() as u32;
        let text = TextRange::new(from, to).slice(source.text);
        self.text.extend_from_slice(text);
        let first = source.blocks.get(blocks.start).map_or(1, |block| block.line);
        let kept = chordal_compare::RetainedText {
            part: TextRange::new(start, start + (to - from)),
            whole: from,
            lines: [self.lines + 1, first],
        };
        self.lines += text.iter().filter(|byte| **byte == b'\n').count() as u32;
        if !text.is_empty() && !text.ends_with(b"\n") {
            self.line("", "\n");
        }
        kept
    }
}

impl<'w, 'a> PartWriter<'w, 'a> {
    pub(super) fn new(
        job: &'w Job,
        source: &'w SourceBlocks<'a>,
        survey: &'w SplitSurvey,
    ) -> PartWriter<'w, 'a> {
        let main = &source.mains[0];
        let after_sections = source.section_end.map_or(main.start, |end| end + 1);
        let words = |at: &usize| {
            let block = &source.blocks[*at];
            !block.words.is_empty() && !source.heads.contains(at)
        };
        let first = (after_sections..main.end).find(words).unwrap_or(main.end);
        let crlf = source.text.windows(2).any(|pair| pair == b"\r\n");
        let taken = job.programs().iter().filter_map(ProgramPlace::key).collect();
        let line_end = if crlf { "\r\n" } else { "\n" };
        PartWriter { source, control: job.control(), survey, line_end, first, taken }
    }

    /// The parts between places, and by how much places that are said again were rounded, mm.
    pub(super) fn parts(&self, points: &[SplitPoint], stationary: &[StateAt]) -> WrittenParts {
        let count = points.len() + 1;
        let end = self.survey.end + 1;
        let (mut parts, mut rounded_mm) = (Vec::new(), 0.0f64);
        for index in 0..count {
            let from = index.checked_sub(1).map(|before| points[before]);
            let to = points.get(index).map_or(end, |point| point.at);
            let blocks = from.map_or(0, |point| point.at)..to;
            let begin =
                from.map(|point| self.begin(&stationary[index - 1], point, &mut rounded_mm));
            let number = self.number(index);
            let begin = begin.unwrap_or_default();
            let mut draft = PartDraft::default();
            if index > 0 {
                self.head(&mut draft, number, [index + 1, count], blocks.clone());
                for line in &begin {
                    draft.line(line, self.line_end);
                }
            }
            let body = draft.keep(self.source, blocks.clone());
            if let Some(stationary) = stationary.get(index) {
                for line in self.end(stationary) {
                    draft.line(&line, self.line_end);
                }
            }
            self.tail(&mut draft, end, &blocks);
            let line = |at: usize| self.source.blocks.get(at).map_or(1, |block| block.line);
            let part = ProgramPart {
                text: draft.text,
                lines: [line(blocks.start), line(blocks.end.saturating_sub(1))],
                number,
                begin,
                at_tool_change: from.is_some_and(|point| point.kind == SafePointKind::ToolChange),
            };
            parts.push((part, PartText { body, other_texts: draft.other_texts }));
        }
        (parts, rounded_mm)
    }

    /// The number of a part: those after that of the whole which nothing has.
    fn number(&self, index: usize) -> Option<u32> {
        let head = *self.source.heads.iter().find(|at| self.source.mains[0].contains(at))?;
        let own = crate::source::whole(self.source.blocks[head].word(b'O'))?;
        let free = (own + 1..).filter(|number| !self.taken.contains(number));
        std::iter::once(own).chain(free).nth(index)
    }

    /// Head, remarks and `L` sections, as in the whole, with another number.
    fn head(
        &self,
        draft: &mut PartDraft,
        number: Option<u32>,
        [index, count]: [usize; 2],
        blocks: std::ops::Range<usize>,
    ) {
        let line = self.source.blocks[blocks.start].line;
        let reported = format!("(PART {index} OF {count}, FROM LINE {line})");
        let mut is_reported = false;
        for at in 0..self.first {
            if self.source.sub_of(at).is_some() {
                if self.is_used(self.source.sub_of(at), &blocks) {
                    let kept = draft.keep(self.source, at..at + 1);
                    draft.other_texts.push(kept);
                }
                continue;
            }
            if self.source.section_end == Some(at) && !self.uses_sections(&blocks) {
                continue;
            }
            let block = &self.source.blocks[at];
            if !self.source.heads.contains(&at) {
                draft.keep(self.source, at..at + 1);
                continue;
            }
            let words = self.renumbered(block, number);
            draft.line(&words, self.line_end);
            draft.line(&reported, self.line_end);
            is_reported = true;
        }
        if !is_reported {
            draft.line(&reported, self.line_end);
        }
    }

    /// A program head with another number, as wide as it was.
    fn renumbered(&self, block: &Block, number: Option<u32>) -> String {
        let words = String::from_utf8_lossy(block.range.slice(self.source.text)).into_owned();
        let (Some(number), Some(word)) = (number, block.word(b'O')) else { return words };
        let at = (word.range.start - block.range.start) as usize;
        let old = String::from_utf8_lossy(word.range.slice(self.source.text)).into_owned();
        let wide = old.bytes().filter(u8::is_ascii_digit).count();
        let letter = &old[..old.find(|c: char| c.is_ascii_digit()).unwrap_or(1)];
        let new = format!("{letter}{number:0wide$}");
        words[..at].to_string() + &new + &words[at + old.len()..]
    }

    fn is_used(&self, sub: Option<usize>, blocks: &std::ops::Range<usize>) -> bool {
        let Some(users) = sub.map(|sub| &self.survey.users[sub]) else { return true };
        // What never ran may run another time.
        users.is_empty() || users.iter().any(|user| blocks.contains(user))
    }

    fn uses_sections(&self, blocks: &std::ops::Range<usize>) -> bool {
        let subs = self.source.subs.iter().enumerate();
        let mut sections = subs.filter(|(_, sub)| sub.form == SubprogramForm::Letter);
        sections.any(|(at, _)| self.is_used(Some(at), blocks))
    }

    /// What stands after the end of the main program: subprograms that the blocks use, and the last `%`.
    fn tail(&self, draft: &mut PartDraft, end: usize, blocks: &std::ops::Range<usize>) {
        let mut at = end;
        while at < self.source.blocks.len() {
            let sub = self.source.sub_of(at);
            let to = sub.map_or(at + 1, |sub| self.source.subs[sub].blocks.end.max(at + 1));
            if self.is_used(sub, blocks) {
                let kept = draft.keep(self.source, at..to);
                draft.other_texts.push(kept);
            }
            at = to;
        }
    }

    /// The lines that end a part that is not the last.
    fn end(&self, stationary: &StateAt) -> Vec<String> {
        let name = |action| codes::name(action, self.control, self.source.style);
        let mut lines = Vec::new();
        if stationary.modal.coolant != Default::default() {
            lines.extend(name(Action::After(AfterCode::CoolantOff)));
        }
        if stationary.modal.spindle != SpindleState::Off {
            lines.extend(name(Action::After(AfterCode::SpindleStop)));
        }
        lines.extend(
            self.program_end()
                .or_else(|| name(Action::After(AfterCode::ProgramEnd { rewind: true }))),
        );
        lines
    }

    /// The code that ends the whole.
    fn program_end(&self) -> Option<String> {
        let ends = |word: &&Word| {
            let row = self.control.row_of(word);
            row.is_some_and(|row| matches!(row.action, Action::After(AfterCode::ProgramEnd { .. })))
        };
        let word = self.source.blocks.get(self.survey.end)?.words.iter().find(ends)?;
        Some(String::from_utf8_lossy(word.range.slice(self.source.text)).into_owned())
    }

    /// The lines that a part begins with, so that all is as it was.
    fn begin(&self, stationary: &StateAt, point: SplitPoint, rounded_mm: &mut f64) -> Vec<String> {
        let StateAt { modal, words } = stationary;
        let (source, control) = (self.source, self.control);
        // Where words of X are diameters, the proof gives the place up.
        let state = StateWriter { source, control, modal, words, x_factor: 1.0 };
        let mut lines = Vec::new();
        let is_clear = point.kind == SafePointKind::Clear;
        let mut codes = words.codes.clone();
        let is_incremental = is_clear && modal.incremental;
        if is_incremental {
            let absolute = state.name(Action::Reading(ReadingCode::Absolute));
            codes.extend(absolute.map(|code| (StateSlot::Distance, code)));
        }
        lines.push(state.line(codes.into_values()));
        lines.extend(words.lines.values().cloned());
        lines.extend(words.data.iter().cloned());
        let motion = modal
            .motion
            .map(Action::from)
            .filter(|action| *action == Action::Motion(MotionCode::Linear));
        if is_clear {
            lines.extend(state.tool());
            lines.extend(approach(&state, rounded_mm));
            lines.extend(words.coolant.iter().cloned());
            lines.extend(motion.and_then(|action| state.name(action)));
        } else {
            lines.extend(state.work());
            lines.extend(state.name(motion.unwrap_or(Action::Motion(MotionCode::Rapid))));
        }
        lines.extend(state.ready_tool());
        lines.extend(state.feed());
        if is_incremental {
            lines.extend(state.name(Action::Reading(ReadingCode::Incremental)));
        }
        lines.retain(|line| !line.is_empty());
        lines
    }
}

/// To where the tool stood: over the place, then down to it.
fn approach(state: &StateWriter, rounded_mm: &mut f64) -> [String; 2] {
    let modal = state.modal;
    let mut place = |axis: usize| {
        let (word, off) = state.place(axis, modal.position[axis]);
        *rounded_mm = rounded_mm.max(off * 2.0);
        word
    };
    let rapid = state.name(Action::Motion(MotionCode::Rapid));
    let mut over: Vec<String> = rapid.into_iter().chain(state.work()).collect();
    // Rotary axes begin at zero.
    let is_stated =
        |axis: &usize| modal.known.has(*axis) && (*axis < 3 || modal.position[*axis] != 0.0);
    over.extend([0, 1, 3, 4, 5].into_iter().filter(is_stated).map(&mut place));
    over.extend(state.spindle());
    let down = state.length_offset().into_iter().chain([place(2)]);
    [state.line(over), state.line(down)]
}
