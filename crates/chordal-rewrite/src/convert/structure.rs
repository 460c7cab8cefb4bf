//! Subprograms of one control in the forms of another.

use chordal::control::{Action, AfterCode, CallCode, ModeCode, OnceCode};
use std::collections::BTreeSet;

use chordal::control::table::SubroutineForm;
use chordal::control::{Control, subroutine_head};

use super::codes;
use super::draft::{BlockDraft, NeedsExpansion};
use crate::source::{SourceBlocks, SubprogramForm, WordStyle, code_action, whole};

/// Where each subprogram goes.
pub(crate) struct ProgramStructure {
    /// Form and number of each on the new control, as [`SourceBlocks::subs`] counts them.
    pub targets: Vec<(SubprogramForm, u32)>,
    /// The number of each main program, where it gets another one.
    pub mains: Vec<Option<u32>>,
}

impl ProgramStructure {
    pub fn of(source: &SourceBlocks, from: &Control, to: &Control) -> ProgramStructure {
        let mut taken: BTreeSet<u32> = BTreeSet::new();
        for head in &source.heads {
            taken.extend(whole(source.blocks[*head].word(b'O')));
        }
        let mut labels: BTreeSet<u32> =
            source.blocks.iter().filter_map(|block| whole(block.word(b'N'))).collect();
        let largest = to.table.program_numbers.largest;
        let has_labels = codes::row(Action::Call(CallCode::CallLabel), to).is_some();
        let has_sections = to.table.subroutines == SubroutineForm::LetterL;
        let calls_inside = source.subs.iter().any(|sub| {
            sub.form == SubprogramForm::Program
                && sub.blocks.clone().any(|at| {
                    source
                        .has_action(at, from, |action| action == Action::Call(CallCode::CallLabel))
                })
        });
        let mut sections: BTreeSet<u32> = source
            .subs
            .iter()
            .filter(|sub| sub.form == SubprogramForm::Letter)
            .map(|sub| sub.number)
            .collect();
        let targets = source
            .subs
            .iter()
            .map(|sub| match sub.form {
                SubprogramForm::Letter if has_sections => (SubprogramForm::Letter, sub.number),
                SubprogramForm::Label if has_labels => (SubprogramForm::Label, sub.number),
                SubprogramForm::Label if has_sections && !calls_inside => {
                    (SubprogramForm::Letter, free(&mut sections, 1, 89))
                }
                SubprogramForm::Letter if has_labels => {
                    (SubprogramForm::Label, free(&mut labels, sub.number * 100, 99_999))
                }
                SubprogramForm::Letter => {
                    (SubprogramForm::Program, free(&mut taken, sub.number * 100, largest))
                }
                SubprogramForm::Label => {
                    (SubprogramForm::Program, free(&mut taken, sub.number, largest))
                }
                SubprogramForm::Program if sub.number <= largest => {
                    (SubprogramForm::Program, sub.number)
                }
                SubprogramForm::Program => {
                    (SubprogramForm::Program, free(&mut taken, sub.number % 10_000, largest))
                }
            })
            .collect();
        let mains = source
            .mains
            .iter()
            .map(|main| {
                let head = source.heads.iter().find(|head| **head == main.start);
                let number = head.and_then(|head| whole(source.blocks[*head].word(b'O')));
                match number {
                    // It has no program numbers.
                    Some(_) if largest == 0 => None,
                    Some(number) if number > largest => {
                        Some(free(&mut taken, number % 10_000, largest))
                    }
                    Some(_) => None,
                    None if to.table.program_numbers.required => Some(free(&mut taken, 1, largest)),
                    None => None,
                }
            })
            .collect();
        ProgramStructure { targets, mains }
    }

    /// True where nothing changes its place.
    pub fn stays(&self, source: &SourceBlocks) -> bool {
        source.subs.iter().zip(&self.targets).all(|(sub, target)| sub.form == target.0)
            && source
                .section_end
                .is_none_or(|_| source.subs.iter().any(|sub| sub.form == SubprogramForm::Letter))
    }
}

/// The first free number from one on.
fn free(taken: &mut BTreeSet<u32>, from: u32, largest: u32) -> u32 {
    let number = (from.max(1)..=largest).chain(1..from).find(|number| !taken.contains(number));
    let number = number.unwrap_or(from);
    taken.insert(number);
    number
}

/// What a block needs to know of the whole.
pub(crate) struct StructureView<'a> {
    pub source: &'a SourceBlocks<'a>,
    pub structure: &'a ProgramStructure,
    pub from: &'a Control,
    pub to: &'a Control,
    pub style: WordStyle,
}

impl StructureView<'_> {
    /// Heads, calls and returns of a block.
    pub fn translate(&self, draft: &mut BlockDraft, at: usize) -> Result<(), NeedsExpansion> {
        if self.source.heads.contains(&at) {
            self.program_head(draft, at);
            return Ok(());
        }
        if let Some(sub) = self.source.subs.iter().position(|sub| sub.blocks.start == at)
            && self.source.subs[sub].form != SubprogramForm::Program
        {
            self.sub_head(draft, sub);
        }
        self.letter_call(draft, at)?;
        for word in 0..draft.block.words.len() {
            match code_action(&draft.block.words[word], self.from) {
                Some(Action::Call(CallCode::CallProgram)) => self.program_call(draft, word)?,
                Some(Action::Call(CallCode::CallLabel)) => self.label_call(draft, at, word)?,
                Some(Action::Call(CallCode::Return)) => {
                    self.back(draft, at, word, SubprogramForm::Letter)?
                }
                Some(Action::Call(CallCode::SubroutineEnd)) => {
                    self.back(draft, at, word, SubprogramForm::Program)?
                }
                Some(Action::After(AfterCode::ProgramEnd { rewind: true })) => {
                    self.end(draft, at, word)
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn program_head(&self, draft: &mut BlockDraft, at: usize) {
        let Some(word) = draft.place(b'O') else {
            return;
        };
        let Some(number) = whole(Some(&draft.block.words[word])) else { return };
        let main = self.source.mains.iter().position(|main| main.start == at);
        let sub = self.source.subs.iter().position(|sub| sub.blocks.start == at);
        let new = match (main, sub) {
            (Some(main), _) => self.structure.mains[main].unwrap_or(number),
            (None, Some(sub)) => self.structure.targets[sub].1,
            (None, None) => number,
        };
        let numbers = self.to.table.program_numbers;
        if numbers.largest == 0 {
            draft.remove(word, format!("{} has no program numbers", self.to.table.title));
        } else if new != number {
            let reason = format!(
                "{} allows program numbers up to O{}",
                self.to.table.title, numbers.largest
            );
            draft.replace(word, program_name(new, self.to), reason);
        } else if numbers.required && draft.written(word).len() - 1 != numbers.digits {
            let name = program_name(number, self.to);
            let reason = format!("{} writes program numbers like this", self.to.table.title);
            draft.replace(word, name, reason);
        }
    }

    /// The head of a section, or the block that M97 calls.
    fn sub_head(&self, draft: &mut BlockDraft, sub: usize) {
        let own = &self.source.subs[sub];
        let (form, number) = self.structure.targets[sub];
        if own.form == form {
            return;
        }
        let head = match form {
            SubprogramForm::Letter => format!("L{}", number * 100),
            SubprogramForm::Label => format!("N{number}"),
            SubprogramForm::Program => program_name(number, self.to),
        };
        let title = self.to.table.title;
        if subroutine_head(draft.block).is_some() {
            let word = draft.place(b'L');
            let reason = format!("subroutines begin like this on {title}");
            for at in 0..draft.block.words.len() {
                if Some(at) == word {
                    draft.replace(at, head.clone(), reason.clone());
                } else {
                    draft.set(at, "");
                }
            }
        } else {
            draft.note(
                String::new(),
                head.clone(),
                format!("subprograms begin like this on {title}"),
            );
            draft.before.push(head);
        }
    }

    /// `L201`.
    fn letter_call(&self, draft: &mut BlockDraft, at: usize) -> Result<(), NeedsExpansion> {
        let Some(word) = draft.place(b'L') else {
            return Ok(());
        };
        let is_call = self.from.table.subroutines == SubroutineForm::LetterL
            && subroutine_head(draft.block).is_none()
            && !self
                .source
                .has_action(at, self.from, |action| action == Action::Once(OnceCode::SetData));
        let Some(value) = whole(Some(&draft.block.words[word])).filter(|value| *value >= 100)
        else {
            return Ok(());
        };
        if !is_call {
            return Ok(());
        }
        if self
            .source
            .has_action(at, self.from, |action| action == Action::Mode(ModeCode::ModalSubroutine))
        {
            return self.only_there("a subroutine after each move (G66)");
        }
        let sub = self
            .source
            .subs
            .iter()
            .position(|sub| sub.form == SubprogramForm::Letter && sub.number == value / 100);
        let Some(sub) = sub else { return self.only_there("a fixed routine") };
        let (form, number) = self.structure.targets[sub];
        if form == SubprogramForm::Letter {
            return Ok(());
        }
        let call = self.call(form, number, value % 100)?;
        let before = draft.written(word);
        let after = call.join("\n");
        draft.note(
            before,
            after,
            format!("subroutines are called like this on {}", self.to.table.title),
        );
        self.put_call(draft, &[word], call);
        Ok(())
    }

    fn only_there(&self, what: &str) -> Result<(), NeedsExpansion> {
        if std::ptr::eq(self.from.table, self.to.table) {
            return Ok(());
        }
        Err(NeedsExpansion(format!("{} does not have {what}", self.to.table.title)))
    }

    /// Puts a call in the place of words; where the block moves as well, after it.
    fn put_call(&self, draft: &mut BlockDraft, words: &[usize], call: Vec<String>) {
        let others = draft.block.words.iter().enumerate().any(|(at, word)| {
            !words.contains(&at) && !matches!(word.letter, b'N') && !draft.is_gone(at)
        });
        for word in words {
            draft.set(*word, "");
        }
        if others || call.len() > 1 {
            draft.after.splice(0..0, call);
        } else if let Some(call) = call.into_iter().next() {
            draft.set(words[0], call);
        }
    }

    fn call(
        &self,
        form: SubprogramForm,
        number: u32,
        times: u32,
    ) -> Result<Vec<String>, NeedsExpansion> {
        let gap = self.style.gap();
        let most = self.to.parameters.max_repeats.max(1);
        let action = match form {
            SubprogramForm::Letter => {
                let parts = in_parts(times, 99);
                return Ok(parts.map(|times| format!("L{}", number * 100 + times)).collect());
            }
            SubprogramForm::Label => Action::Call(CallCode::CallLabel),
            SubprogramForm::Program => Action::Call(CallCode::CallProgram),
        };
        let code = codes::name(action, self.to, self.style).ok_or_else(|| {
            NeedsExpansion(format!("{} has no code for calls", self.to.table.title))
        })?;
        let one = |times| match times {
            1 => format!("{code}{gap}P{number}"),
            _ => format!("{code}{gap}P{number}{gap}L{times}"),
        };
        Ok(in_parts(times, most).map(one).collect())
    }

    /// `M98 P1000 L3`, `M98 P31000`.
    fn program_call(&self, draft: &mut BlockDraft, code: usize) -> Result<(), NeedsExpansion> {
        let block = draft.block;
        if self.from.table.call_start_label != self.to.table.call_start_label {
            let start = self.from.table.call_start_label;
            if start.is_some_and(|letter| block.letters().has(letter)) {
                return Err(NeedsExpansion(format!(
                    "{} cannot start a called program at an N number like this",
                    self.to.table.title
                )));
            }
        }
        let p = draft.place(b'P');
        let Some(number) = whole(p.map(|p| &block.words[p])) else { return Ok(()) };
        let has = |number: u32| {
            self.source
                .subs
                .iter()
                .position(|sub| sub.form == SubprogramForm::Program && sub.number == number)
        };
        let packed = self.from.parameters.packed_calls && number > 9999 && has(number).is_none();
        let (number, packed_times) =
            if packed { (number % 10_000, Some(number / 10_000)) } else { (number, None) };
        let Some(sub) = has(number) else {
            return Err(NeedsExpansion(format!("O{number} is in another file")));
        };
        let (_, new) = self.structure.targets[sub];
        if new == number && (packed_times.is_none() || self.to.parameters.packed_calls) {
            return Ok(());
        }
        let l = draft.place(b'L');
        let times = packed_times.or(whole(l.map(|l| &block.words[l]))).unwrap_or(1);
        let call = self.call(SubprogramForm::Program, new, times)?;
        let words: Vec<usize> = [Some(code), p, l].into_iter().flatten().collect();
        let before = words.iter().map(|at| draft.written(*at)).collect::<Vec<_>>().join(" ");
        let reason = format!("programs are called like this on {}", self.to.table.title);
        draft.note(before, call.join("\n"), reason);
        self.put_call(draft, &words, call);
        Ok(())
    }

    /// `M97 P100 L3`.
    fn label_call(
        &self,
        draft: &mut BlockDraft,
        at: usize,
        code: usize,
    ) -> Result<(), NeedsExpansion> {
        let block = draft.block;
        let p = draft.place(b'P');
        let label = whole(p.map(|p| &block.words[p]));
        let in_main = self.source.mains.iter().any(|main| main.contains(&at));
        let sub = self.source.subs.iter().position(|sub| {
            sub.form == SubprogramForm::Label && Some(sub.number) == label && in_main
        });
        let Some(sub) = sub else {
            return self.only_there("calls of blocks within the program (M97)");
        };
        let (form, number) = self.structure.targets[sub];
        if form == SubprogramForm::Label {
            return Ok(());
        }
        let l = draft.place(b'L');
        let times = whole(l.map(|l| &block.words[l])).unwrap_or(1);
        let call = self.call(form, number, times)?;
        let words: Vec<usize> = [Some(code), p, l].into_iter().flatten().collect();
        let before = words.iter().map(|at| draft.written(*at)).collect::<Vec<_>>().join(" ");
        let reason = format!("{} has no calls of blocks within the program", self.to.table.title);
        draft.note(before, call.join("\n"), reason);
        self.put_call(draft, &words, call);
        Ok(())
    }

    /// The end of a subprogram, where `other` would end it by another code.
    fn back(
        &self,
        draft: &mut BlockDraft,
        at: usize,
        word: usize,
        other: SubprogramForm,
    ) -> Result<(), NeedsExpansion> {
        let Some(sub) = self.source.sub_of(at) else { return Ok(()) };
        let [here, there] =
            [self.from, self.to].map(|control| control.parameters.return_label_in_callee);
        if draft.block.letters().has(b'P') && here != there {
            return Err(NeedsExpansion(format!(
                "M99 P goes to another block on {}",
                self.to.table.title
            )));
        }
        let is_letter = self.structure.targets[sub].0 == SubprogramForm::Letter;
        if is_letter != (other == SubprogramForm::Letter) {
            return Ok(());
        }
        if draft.block.letters().has(b'P') {
            return Err(NeedsExpansion("a return to an N number (M99 P)".into()));
        }
        let action = if is_letter {
            Action::Call(CallCode::SubroutineEnd)
        } else {
            Action::Call(CallCode::Return)
        };
        let name = codes::name(action, self.to, self.style);
        let name = name.ok_or_else(|| NeedsExpansion("there is no code for the return".into()))?;
        draft.replace(word, name, format!("subprograms end like this on {}", self.to.table.title));
        Ok(())
    }

    /// M30 closes the section of subroutines on one control; there the program ends with M2.
    fn end(&self, draft: &mut BlockDraft, at: usize, word: usize) {
        let title = self.to.table.title;
        if self.source.section_end == Some(at) {
            if !self.structure.targets.iter().any(|target| target.0 == SubprogramForm::Letter) {
                draft.remove(word, format!("{title} has no section of subroutines to close"));
            }
        } else if self.to.table.subroutines == SubroutineForm::LetterL
            && self.from.table.subroutines != SubroutineForm::LetterL
            && let Some(name) = codes::name(
                Action::After(AfterCode::ProgramEnd { rewind: false }),
                self.to,
                self.style,
            )
        {
            draft.replace(word, name, format!("M30 closes the subroutines on {title}"));
        }
    }
}

fn in_parts(times: u32, most: u32) -> impl Iterator<Item = u32> {
    let rest = times % most;
    std::iter::repeat_n(most, (times / most) as usize).chain((rest > 0).then_some(rest))
}

/// `O0012`, as the control lists it.
pub(crate) fn program_name(number: u32, control: &Control) -> String {
    format!("O{number:0width$}", width = control.table.program_numbers.digits)
}
