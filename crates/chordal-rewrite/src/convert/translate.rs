//! A block of one control as a block of another.

use chordal::CommandKind;
use chordal::control::table::{CodeGroup, LineRepeat, MotionModality, SubroutineForm};
use chordal::control::{Action, BlockStep, CallCode, Control, MotionCode, OnceCode, ReadingCode};
use chordal::control::{Units, subroutine_head};
use chordal::syntax::{BlockKind, Letters};

use super::codes;
use super::comments;
use super::context::ConvertContext;
use super::corners;
use super::cycles;
use super::draft::{BlockDraft, NeedsExpansion};
use super::numbers::{self, DigitRule};
use super::structure::StructureView;
use super::surface;
use super::trace::moves;
use super::turning;
use crate::source::{code_action, whole};

/// Letters of lengths on the axes of the plane and the third one.
pub(super) const LENGTHS: Letters = Letters::of("XYZIJKR");

impl<'a> ConvertContext<'a> {
    /// The block in the words of the new control.
    pub fn block(&self, at: usize) -> Result<BlockDraft<'a>, NeedsExpansion> {
        let block = &self.source.blocks[at];
        let mut draft = BlockDraft::new(self.source.text, block, self.style().spaced);
        match block.kind {
            BlockKind::Words => {}
            BlockKind::Percent => {
                let firmware = self.to.table.firmware;
                if firmware.is_some_and(|firmware| !firmware.line.percent_marks) {
                    let reason = format!("{} has no percent sign", self.to.table.title);
                    draft.note("%".into(), String::new(), reason);
                    draft.instead = Some(Vec::new());
                }
                return Ok(draft);
            }
            BlockKind::Folder => return Ok(draft),
            BlockKind::Macro(_) if self.keeps_macros() => {}
            // The contour of a cycle that the new control does not have.
            BlockKind::Macro(_) if self.is_contour(at) => {
                draft.instead = Some(Vec::new());
                return Ok(draft);
            }
            BlockKind::Macro(range) => {
                self.macros.statement(&mut draft, at, range)?;
                return Ok(draft);
            }
        }
        if !block.words.is_empty() {
            self.words(&mut draft, at)?;
        }
        comments::translate(&mut draft, self.from, self.to);
        Ok(draft)
    }

    fn words(&self, draft: &mut BlockDraft, at: usize) -> Result<(), NeedsExpansion> {
        let places = StructureView {
            source: self.source,
            structure: self.structure,
            from: self.from,
            to: self.to,
            style: self.style(),
        };
        places.translate(draft, at)?;
        if self.source.heads.contains(&at) || subroutine_head(draft.block).is_some() {
            return Ok(());
        }
        if !self.keeps_macros() {
            self.macros.values(draft, at)?;
        }
        self.frames(at)?;
        self.corners(draft.block, at)?;
        if !draft.block.polar.is_empty() && !self.to.table.lexicon.polar_words {
            let title = self.to.table.title;
            return Err(NeedsExpansion(format!(
                "{title} has no radius and angle in place of X and Y"
            )));
        }
        turning::translate(self, draft, at)?;
        surface::translate(self, draft, at)?;
        codes::translate(draft, self.from, self.to, self.style())?;
        self.offsets(draft, at)?;
        cycles::translate(self, draft, at)?;
        self.arc(draft, at)?;
        self.feed_along(draft, at)?;
        self.registers(draft, at)?;
        self.numbers(draft, at);
        self.dwell(draft, at);
        self.motion(draft, at);
        self.distance(draft);
        self.switches(draft, at);
        self.repeats(draft, at);
        self.alone(draft);
        Ok(())
    }

    /// `R0+1.` on one control, `R1.` on the others; other registers have no counterpart.
    fn registers(&self, draft: &mut BlockDraft, at: usize) -> Result<(), NeedsExpansion> {
        let [has, will] = [self.from, self.to].map(|control| control.table.lexicon.registers);
        if has == will {
            return Ok(());
        }
        let title = self.to.table.title;
        for word in 0..draft.block.words.len() {
            let own = draft.block.words[word];
            if own.letter != b'R' || own.comma || draft.is_gone(word) {
                continue;
            }
            let written = draft.now(word);
            match own.register {
                Some(0) if self.uses_r(at) => {
                    let written = draft.written(word);
                    let value = written.get(2..).unwrap_or_default();
                    let value = value.strip_prefix('+').unwrap_or(value);
                    draft.replace(word, format!("R{value}"), format!("{title} writes R like this"));
                }
                Some(_) => return Err(NeedsExpansion(format!("{title} has no registers"))),
                None if will => {
                    let value = &written[1..];
                    let sign = if value.starts_with('-') { "" } else { "+" };
                    let value = value.strip_prefix('+').unwrap_or(value);
                    draft.replace(
                        word,
                        format!("R0{sign}{value}"),
                        format!("{title} writes R like this"),
                    );
                }
                None => {}
            }
        }
        Ok(())
    }

    /// True when R is the radius or the level of the block's own move.
    fn uses_r(&self, at: usize) -> bool {
        let data = self.source.has_action(at, self.from, |action| {
            matches!(action, Action::Once(OnceCode::SetData) | Action::Cycle(_))
        });
        let arc = self.run(at).is_some_and(|run| {
            self.trace.commands_of(run).iter().any(|command| command.kind.shape().is_some())
        });
        data || arc || self.run(at).is_some_and(|run| self.in_cycle(run))
    }

    /// Numbers without a point.
    fn numbers(&self, draft: &mut BlockDraft, at: usize) {
        let units = self.run(at).map_or(Units::Inch, |run| run.after.units);
        let data = self.source.has_action(at, self.from, |action| {
            matches!(
                action,
                Action::Call(CallCode::MacroCall)
                    | Action::Call(CallCode::ModalMacroCall { .. })
                    | Action::Once(OnceCode::Dwell)
            )
        });
        for word in 0..draft.block.words.len() {
            let own = draft.block.words[word];
            let Some(number) = own.number() else { continue };
            let kind = match own.letter {
                b'X' | b'Y' | b'Z' | b'I' | b'J' | b'K' | b'R' => DigitRule::Length,
                b'Q' if self.run(at).is_some_and(|run| self.in_cycle(run)) => DigitRule::Length,
                b'C' if own.comma => DigitRule::Length,
                b'A' | b'B' | b'C' => DigitRule::Angle,
                b'F' => DigitRule::Feed,
                _ => continue,
            };
            // A word that was changed has its point, but for R.
            if (own.comma && !corners::is_corner_word(&own, self.from))
                || data
                || draft.is_gone(word)
                || (draft.is_changed(word) && own.letter != b'R')
            {
                continue;
            }
            if let Some(new) = numbers::carried_over(number, kind, units, self.controls()) {
                let now = draft.now(word);
                let head: String =
                    now.chars().take_while(|c| c.is_ascii_alphabetic() || *c == ',').collect();
                let reason = format!(
                    "a number without a point has another value on {}",
                    self.to.table.title
                );
                draft.replace(word, format!("{head}{new}"), reason);
            }
        }
    }

    /// The time of G4.
    fn dwell(&self, draft: &mut BlockDraft, at: usize) {
        if !self.source.has_action(at, self.from, |action| action == Action::Once(OnceCode::Dwell))
        {
            return;
        }
        let Some(run) = self.run(at) else { return };
        let seconds = self.trace.commands_of(run).iter().find_map(|command| match command.kind {
            CommandKind::Dwell { seconds, .. } => Some(seconds),
            _ => None,
        });
        let Some(seconds) = seconds else { return };
        for word in 0..draft.block.words.len() {
            let own = draft.block.words[word];
            let of = |control: &Control| control.dwell_words().find(|row| row.letter == own.letter);
            let Some(row) = of(self.from) else { continue };
            let Some(number) = own.number() else { continue };
            let unit = row.unit_s(number.has_point);
            if of(self.to).is_some_and(|there| there.unit_s(number.has_point) == unit) {
                continue;
            }
            if let Some(new) = numbers::dwell_word(seconds, self.to) {
                draft.replace(
                    word,
                    new,
                    format!("{} reads a dwell like this", self.to.table.title),
                );
            }
        }
    }

    /// Motion codes that the old control did not need.
    fn motion(&self, draft: &mut BlockDraft, at: usize) {
        let [armed, arms] = [self.from, self.to].map(|control| control.table.motion);
        if armed != MotionModality::Armed || arms == MotionModality::Armed {
            return;
        }
        let Some(run) = self.run(at) else { return };
        let own = draft.block.words.iter().any(|word| {
            self.from.row_of(word).is_some_and(|row| {
                // A move of G53 goes by G0 or G1 like any other.
                row.action.is_plain_motion()
                    || row.takes_axes() && row.action != Action::Once(OnceCode::MachineCoordinates)
            })
        });
        let commands = self.trace.commands_of(run);
        let Some(first) = moves(commands).find(|command| !command.origin.cycle) else { return };
        if own || self.in_cycle(run) {
            return;
        }
        let title = self.to.table.title;
        let (action, reason) = match &first.kind {
            CommandKind::Arc { shape, .. } if shape.sweep < 0.0 => {
                (Action::Motion(MotionCode::ArcCw), "armed")
            }
            CommandKind::Arc { .. } => (Action::Motion(MotionCode::ArcCcw), "armed"),
            CommandKind::Line { .. } if self.trace.facts[at].after_arc => {
                (Action::Motion(MotionCode::Linear), "")
            }
            CommandKind::Rapid { .. } if self.trace.facts[at].after_arc => {
                (Action::Motion(MotionCode::Rapid), "")
            }
            _ => return,
        };
        let reason = match reason {
            "" => format!("an arc cancels G0 and G1 on {title}"),
            _ => format!("{title} does not keep the direction of an arc"),
        };
        if let Some(code) = codes::name(action, self.to, self.style()) {
            draft.lead(code, reason);
        }
    }

    /// G90 and G91 act from left to right on one control, before the words on the others.
    fn distance(&self, draft: &mut BlockDraft) {
        let [from, to] = [self.from, self.to].map(|control| control.table.distance_left_to_right);
        if from == to {
            return;
        }
        let block = draft.block;
        let first_axis = block.words.iter().position(|word| LENGTHS.has(word.letter));
        let is_distance = |at: &usize| {
            code_action(&block.words[*at], self.from).is_some_and(|action| {
                matches!(
                    action,
                    Action::Reading(ReadingCode::Absolute)
                        | Action::Reading(ReadingCode::Incremental)
                )
            })
        };
        let codes: Vec<usize> = (0..block.words.len()).filter(is_distance).collect();
        for at in codes {
            let Some(first) = first_axis.filter(|first| *first < at) else { continue };
            let _ = first;
            let word = draft.now(at);
            if from {
                draft.replace(
                    at,
                    "",
                    format!(
                        "{word} applies from the next block on, because it comes after the words"
                    ),
                );
                draft.after.push(word);
            } else {
                draft.set(at, "");
                draft.lead(word, "it must come before the words that it applies to");
            }
        }
    }

    /// What one control switches after the motion of its block and the other before it goes into a block of its own.
    fn switches(&self, draft: &mut BlockDraft, at: usize) {
        let Some(run) = self.run(at) else { return };
        if moves(self.trace.commands_of(run)).next().is_none() {
            return;
        }
        let is_before = |control: &Control, step: BlockStep| {
            control.table.order.is_before(step, BlockStep::Motion)
        };
        let title = self.to.table.title;
        for word in 0..draft.block.words.len() {
            let action = code_action(&draft.block.words[word], self.from);
            let Some(step) = action.and_then(BlockStep::of_switch) else { continue };
            let (was, will_be) = (is_before(self.from, step), is_before(self.to, step));
            if was == will_be || draft.is_gone(word) {
                continue;
            }
            let code = draft.now(word);
            let place = if will_be { "before" } else { "after" };
            let reason = format!("{title} would do it {place} the motion of its block");
            draft.note(code.clone(), format!("{code} in a block of its own"), reason);
            draft.set(word, "");
            if was {
                draft.before.push(code);
            } else {
                draft.after.push(code);
            }
        }
    }

    /// The count of a line repeat of the block.
    pub(super) fn line_repeat(&self, draft: &BlockDraft, at: usize) -> Option<(usize, u32)> {
        if self.from.table.line_repeat == LineRepeat::None {
            return None;
        }
        let claimed = self.source.blocks[at].words.iter().any(|word| {
            let row = self.from.row_of(word);
            row.is_some_and(|row| row.words.has(b'L') || row.group == CodeGroup::Cycle)
        });
        let in_cycle = self.run(at).is_some_and(|run| self.in_cycle(run));
        if claimed || in_cycle {
            return None;
        }
        let word = draft.place(b'L')?;
        let count = whole(Some(&draft.block.words[word]))?;
        let calls = self.from.table.subroutines == SubroutineForm::LetterL && count >= 100;
        (!calls).then_some((word, count))
    }

    /// A repeated line is written as often.
    fn repeats(&self, draft: &mut BlockDraft, at: usize) {
        let in_sub = self.source.sub_of(at).is_some();
        let kept = match self.to.table.line_repeat {
            LineRepeat::Anywhere => true,
            LineRepeat::MainProgram => !in_sub,
            LineRepeat::None => false,
        };
        let Some((word, count)) = self.line_repeat(draft, at).filter(|_| !kept) else { return };
        draft.remove(
            word,
            format!("{} does not repeat lines: written {count} times", self.to.table.title),
        );
        // Letter and number of a head or a label stay with the first.
        draft.times = count.min(MAX_COPIES);
    }

    /// Codes that must be the only G code of their block.
    fn alone(&self, draft: &mut BlockDraft) {
        let block = draft.block;
        let must = |at: usize| {
            code_action(&block.words[at], self.from)
                .and_then(|action| codes::row(action, self.to))
                .is_some_and(|(row, letter)| {
                    letter == b'G' && self.to.table.alone.contains(&row.code)
                })
        };
        let Some(lone) =
            (0..block.words.len()).find(|at| block.words[*at].letter == b'G' && must(*at))
        else {
            return;
        };
        let others: Vec<usize> = (0..block.words.len())
            .filter(|at| *at != lone && block.words[*at].letter == b'G' && !draft.is_gone(*at))
            .collect();
        if others.is_empty() {
            return;
        }
        let code = draft.now(lone);
        let words: Vec<String> = others.iter().map(|at| draft.now(*at)).collect();
        let line = words.join(self.style().gap());
        for at in others {
            draft.set(at, "");
        }
        draft.note(
            line.clone(),
            format!("{line}\n{code}"),
            format!("{code} must be the only G code of its block on {}", self.to.table.title),
        );
        draft.before.push(line);
    }
}

/// Most lines that a repeat becomes.
const MAX_COPIES: u32 = 10_000;
