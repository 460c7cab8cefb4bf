//! The cycles of lathes that both controls have, in one block or in two.
//!
//! A control with two blocks gives depths, retracts and the like in a block before that of the cycle; the other one has
//! all of it in one block, or in settings. What has no word stays a setting: the proof says whether that makes a difference.

use chordal::control::{Action, ModeCode, OnceCode, TurnCycle, TurnFamily, TurningRules};
use chordal::syntax::{Block, Decimal, Letters};

use crate::convert::codes;
use crate::convert::context::ConvertContext;
use crate::convert::draft::{BlockDraft, NeedsExpansion};
use crate::convert::numbers;
use crate::source::{code_action, lacks_ends};

/// Angles of the tool that a packed word may name, degrees.
const ANGLES: [f64; 6] = [0.0, 29.0, 30.0, 55.0, 60.0, 80.0];

pub(super) fn translate(
    context: &ConvertContext,
    draft: &mut BlockDraft,
    at: usize,
) -> Result<(), NeedsExpansion> {
    let found = draft
        .block
        .words
        .iter()
        .enumerate()
        .find_map(|(word, own)| Some((word, code_action(own, context.from)?.turning_cycle()?)));
    let Some((code, cycle)) = found else { return Ok(()) };
    let title = context.to.table.title;
    let action = Action::Once(OnceCode::Turning(cycle));
    if codes::row(action, context.to).is_none() {
        return Err(NeedsExpansion(format!("{title} has no such cycle ({})", codes::what(action))));
    }
    let one = LatheCycleBlock { context, cycle, code, at };
    one.pockets(draft)?;
    match one.rules().map(|rules| rules.two_blocks) {
        [true, false] => one.in_one_block(draft),
        [false, true] => one.in_two_blocks(draft),
        _ => Ok(()),
    }
}

struct LatheCycleBlock<'c> {
    context: &'c ConvertContext<'c>,
    cycle: TurnCycle,
    /// The place of its code among the words.
    code: usize,
    at: usize,
}

impl LatheCycleBlock<'_> {
    fn rules(&self) -> [TurningRules; 2] {
        self.context.controls().map(|control| control.parameters.rules.turning)
    }

    /// A letter that says whether pockets are cut means nothing on the other control.
    fn pockets(&self, draft: &BlockDraft) -> Result<(), NeedsExpansion> {
        let [one, other] = self.rules();
        let cuts = self.cycle.family() == TurnFamily::Rough;
        let letters = [one.pockets_by, other.pockets_by].into_iter().flatten();
        let says = |letter: u8| {
            cuts && !lacks_ends(self.cycle, draft.block) && draft.place(letter).is_some()
        };
        if one.pockets_by != other.pockets_by && letters.into_iter().any(says) {
            let title = self.context.to.table.title;
            return Err(NeedsExpansion(format!(
                "{title} says in another way whether pockets are cut"
            )));
        }
        Ok(())
    }

    /// The number of a word; nothing where it is computed.
    fn number(&self, block: &Block, letter: u8) -> Result<Option<Decimal>, NeedsExpansion> {
        let Some(word) = block.last(letter) else { return Ok(None) };
        let computed = || NeedsExpansion("a word of the cycle is computed".into());
        word.number().map(Some).ok_or_else(computed)
    }

    /// A length, mm on the radius as the cycle counts it.
    fn length(&self, block: &Block, letter: u8) -> Result<Option<f64>, NeedsExpansion> {
        let units = self.units();
        let number = self.number(block, letter)?;
        Ok(number.map(|number| {
            number.to_f64() * self.context.from.length_unit_mm(units, number.has_point)
        }))
    }

    /// The same where a number without a point counts least increments, whatever the settings.
    fn increments(&self, block: &Block, letter: u8) -> Result<Option<f64>, NeedsExpansion> {
        let number = self.number(block, letter)?.filter(|number| !number.has_point);
        match number {
            Some(number) => Ok(Some(number.to_f64() * self.least())),
            None => self.length(block, letter),
        }
    }

    fn units(&self) -> chordal::control::Units {
        let run = self.context.run(self.at);
        run.map_or(self.context.from.parameters.rules.units, |run| run.after.units)
    }

    /// The least increment, mm.
    fn least(&self) -> f64 {
        self.context.from.parameters.rules.least_increment(self.units())
    }

    /// The last block before this one that only sets the cycle up.
    fn setup(&self) -> Option<&Block> {
        let target = Action::Once(OnceCode::Turning(self.cycle));
        let source = self.context.source;
        let found = (0..self.at).rev().find(|at| {
            source.has_action(*at, self.context.from, |action| action == target)
                && lacks_ends(self.cycle, &source.blocks[*at])
        });
        found.map(|at| &source.blocks[at])
    }

    fn setup_length(&self, letter: u8) -> Result<Option<f64>, NeedsExpansion> {
        self.setup().map_or(Ok(None), |block| self.length(block, letter))
    }

    /// A length as a word of the new control, with its point.
    fn word(&self, letter: u8, mm: f64) -> String {
        let digits = numbers::digits(self.context.to, self.units());
        let text = numbers::length(mm, self.units(), digits, self.context.style());
        format!("{}{text}", char::from(letter))
    }

    /// A length in least increments.
    fn counted(&self, letter: u8, mm: f64) -> String {
        let least = self.context.to.parameters.rules.least_increment(self.units());
        format!("{}{:.0}", char::from(letter), (mm / least).round())
    }

    fn reason(&self) -> String {
        format!("{} has all of this cycle in one block", self.context.to.table.title)
    }

    /// Puts a word in the place of one, or after the others.
    fn put(&self, draft: &mut BlockDraft, letter: Option<u8>, new: String, reason: &str) {
        match letter.and_then(|letter| draft.place(letter)) {
            Some(word) => draft.replace(word, new, reason),
            None => draft.append(new, reason),
        }
    }

    /// Two blocks as one.
    fn in_one_block(&self, draft: &mut BlockDraft) -> Result<(), NeedsExpansion> {
        let [one, other] = self.rules();
        let reason = self.reason();
        if lacks_ends(self.cycle, draft.block) {
            for word in 0..draft.block.words.len() {
                if draft.block.words[word].letter != b'N' {
                    draft.remove(word, reason.clone());
                }
            }
            return Ok(());
        }
        let block = draft.block;
        match self.cycle.family() {
            TurnFamily::Rough => {
                if block.letters().has(b'D') {
                    return Ok(());
                }
                let depth = self.setup_length(self.depth_letter())?.unwrap_or(one.rough_depth_mm);
                self.put(draft, None, self.word(b'D', depth.abs()), &reason);
            }
            TurnFamily::Pattern => {
                if block.letters().has(b'D') {
                    return Ok(());
                }
                let passes = self.setup().map_or(Ok(None), |block| self.number(block, b'R'))?;
                let passes = passes.map_or(1.0, |passes| passes.to_f64());
                for (letter, from) in [(b'I', b'U'), (b'K', b'W')] {
                    let mm = self.setup_length(from)?.unwrap_or(0.0);
                    self.put(draft, None, self.word(letter, mm), &reason);
                }
                self.put(draft, None, format!("D{passes:.0}"), &reason);
            }
            TurnFamily::Peck => {
                for (from, letter) in [(b'P', b'I'), (b'Q', b'K')] {
                    if let Some(mm) = self.increments(block, from)? {
                        self.put(draft, Some(from), self.word(letter, mm.abs()), &reason);
                    }
                }
                if let Some(mm) = self.length(block, b'R')? {
                    self.put(draft, Some(b'R'), self.word(b'D', mm), &reason);
                }
            }
            TurnFamily::Thread => self.thread_in_one_block(draft, [one, other])?,
            TurnFamily::Finish | TurnFamily::Subroutine | TurnFamily::LineThread => {}
        }
        Ok(())
    }

    fn depth_letter(&self) -> u8 {
        if self.cycle == TurnCycle::RoughFace { b'W' } else { b'U' }
    }

    fn thread_in_one_block(
        &self,
        draft: &mut BlockDraft,
        [one, other]: [TurningRules; 2],
    ) -> Result<(), NeedsExpansion> {
        let block = draft.block;
        if block.letters().meets(Letters::of("KD")) {
            return Ok(());
        }
        let reason = self.reason();
        let packed = self.setup().map_or(Ok(None), |block| self.number(block, b'P'))?;
        let packed = packed.map(|packed| packed.to_f64() as u32);
        let exit = packed.map_or(one.thread_exit_leads, |p| f64::from(p / 100 % 100) / 10.0);
        let angle = packed.map_or(one.thread_angle_deg, |p| f64::from(p % 100));
        if exit != 0.0 && exit != other.thread_exit_leads {
            let title = self.context.to.table.title;
            return Err(NeedsExpansion(format!(
                "the exit of this thread is {exit} leads long, and {} on {title}, by a setting",
                other.thread_exit_leads
            )));
        }
        for (from, letter) in [(b'P', b'K'), (b'Q', b'D')] {
            if let Some(mm) = self.increments(block, from)? {
                self.put(draft, Some(from), self.word(letter, mm), &reason);
            }
        }
        if let Some(mm) = self.length(block, b'R')? {
            match mm == 0.0 {
                true => draft.place(b'R').into_iter().for_each(|word| draft.set(word, "")),
                false => self.put(draft, Some(b'R'), self.word(b'I', mm), &reason),
            }
        }
        if angle > 0.0 {
            self.put(draft, None, format!("A{angle:.0}"), &reason);
        }
        if exit == 0.0 {
            self.without_exit(draft)?;
        }
        Ok(())
    }

    /// Codes about a thread that ends without an exit.
    fn without_exit(&self, draft: &mut BlockDraft) -> Result<(), NeedsExpansion> {
        let code = |on: bool| {
            let action = Action::Mode(ModeCode::ThreadExit { on });
            codes::name(action, self.context.to, self.context.style())
        };
        let title = self.context.to.table.title;
        let (Some(off), Some(on)) = (code(false), code(true)) else {
            return Err(NeedsExpansion(format!("{title} has no thread without an exit")));
        };
        let reason = format!("{title} ends threads without an exit by a code");
        draft.note(String::new(), format!("{off}\n{on}"), reason);
        draft.before.push(off);
        draft.after.push(on);
        Ok(())
    }

    /// One block as two.
    fn in_two_blocks(&self, draft: &mut BlockDraft) -> Result<(), NeedsExpansion> {
        let [one, _] = self.rules();
        if lacks_ends(self.cycle, draft.block) {
            return Ok(());
        }
        let block = draft.block;
        let code = draft.now(self.code);
        let code = codes::name(
            Action::Once(OnceCode::Turning(self.cycle)),
            self.context.to,
            self.context.style(),
        )
        .unwrap_or(code);
        match self.cycle.family() {
            TurnFamily::Rough => {
                if block.letters().meets(Letters::of("IK")) {
                    let title = self.context.to.table.title;
                    return Err(NeedsExpansion(format!(
                        "{title} has no second contour pass (I, K)"
                    )));
                }
                let depth = self.length(block, b'D')?.unwrap_or(one.rough_depth_mm).abs();
                let words = vec![
                    self.word(self.depth_letter(), depth),
                    self.word(b'R', one.rough_retract_mm),
                ];
                self.lead_in(draft, &code, words, b"D");
            }
            TurnFamily::Pattern => {
                let along = |letter| Ok(self.length(block, letter)?.unwrap_or(0.0));
                let passes = self.number(block, b'D')?.map_or(1.0, |passes| passes.to_f64());
                let words = vec![
                    self.word(b'U', along(b'I')?),
                    self.word(b'W', along(b'K')?),
                    format!("R{passes:.0}"),
                ];
                self.lead_in(draft, &code, words, b"IKD");
            }
            TurnFamily::Peck => {
                self.lead_in(draft, &code, vec![self.word(b'R', one.peck_retract_mm)], &[]);
                let reason = self.two_blocks();
                for (from, letter) in [(b'I', b'P'), (b'K', b'Q')] {
                    if let Some(mm) = self.increments(block, from)? {
                        self.put(draft, Some(from), self.counted(letter, mm.abs()), &reason);
                    }
                }
                if let Some(mm) = self.length(block, b'D')? {
                    self.put(draft, Some(b'D'), self.word(b'R', mm), &reason);
                }
            }
            TurnFamily::Thread => self.thread_in_two_blocks(draft, &code, one)?,
            TurnFamily::Finish | TurnFamily::Subroutine | TurnFamily::LineThread => {}
        }
        Ok(())
    }

    fn two_blocks(&self) -> String {
        format!("{} has this cycle in two blocks", self.context.to.table.title)
    }

    /// Puts the first of two blocks before the cycle, with words that leave its own.
    fn lead_in(&self, draft: &mut BlockDraft, code: &str, words: Vec<String>, gone: &[u8]) {
        let gap = if self.context.style().spaced { " " } else { "" };
        let mut line = vec![code.to_string()];
        line.extend(words);
        let line = line.join(gap);
        for letter in gone {
            if let Some(word) = draft.place(*letter) {
                draft.set(word, "");
            }
        }
        draft.note(String::new(), line.clone(), self.two_blocks());
        draft.before.push(line);
    }

    fn thread_in_two_blocks(
        &self,
        draft: &mut BlockDraft,
        code: &str,
        one: TurningRules,
    ) -> Result<(), NeedsExpansion> {
        let block = draft.block;
        let title = self.context.to.table.title;
        if block.letters().meets(Letters::of("PQ")) {
            return Err(NeedsExpansion(format!(
                "{title} feeds the tool of a thread in another way"
            )));
        }
        let angle = self.number(block, b'A')?.map_or(0.0, |angle| angle.to_f64());
        let exit = if self.is_without_exit() { 0.0 } else { one.thread_exit_leads };
        let tenths = (exit * 10.0).round();
        if !ANGLES.contains(&angle) || !(0.0..=99.0).contains(&tenths) {
            return Err(NeedsExpansion(format!("{title} has no tool angle of {angle} degrees")));
        }
        let passes = one.thread_finish_passes.min(99);
        let words = vec![
            format!("P{passes:02}{tenths:02.0}{angle:02.0}"),
            self.counted(b'Q', one.thread_least_mm),
            self.word(b'R', one.thread_finish_mm),
        ];
        self.lead_in(draft, code, words, b"A");
        let reason = self.two_blocks();
        for (from, letter) in [(b'K', b'P'), (b'D', b'Q')] {
            if let Some(mm) = self.increments(block, from)? {
                self.put(draft, Some(from), self.counted(letter, mm), &reason);
            }
        }
        if let Some(mm) = self.length(block, b'I')? {
            self.put(draft, Some(b'I'), self.word(b'R', mm), &reason);
        }
        Ok(())
    }

    /// The code in force before this block that threads end without an exit.
    fn is_without_exit(&self) -> bool {
        let source = self.context.source;
        let exit = |word: &chordal::syntax::Word| match code_action(word, self.context.from) {
            Some(Action::Mode(ModeCode::ThreadExit { on })) => Some(!on),
            _ => None,
        };
        let found =
            (0..self.at).rev().find_map(|at| source.blocks[at].words.iter().rev().find_map(exit));
        found.unwrap_or(false)
    }
}
