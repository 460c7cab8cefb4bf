//! Which variable, label and loop of one language is which of the other.

use std::collections::{BTreeMap, BTreeSet};

use chordal::control::Control;
use chordal::control::macros::MacroForm;
use chordal::syntax::{BlockKind, WordValue};

use super::meaning::{self, JumpLabel, MacroMeaning};
use super::tree::{ExpressionTree, VariableRef};
use crate::source::{SourceBlocks, whole};

/// Common variables of macro B that a program may use freely.
const COMMON: std::ops::RangeInclusive<u32> = 100..=199;

/// Variables V of a Fadal.
const LETTERED: std::ops::RangeInclusive<u32> = 1..=99;

/// The first N number that labels get.
const FIRST_LABEL: u32 = 9000;

/// What everything is called on the other control.
#[derive(Debug, Default)]
pub(crate) struct MacroNames {
    variables: BTreeMap<VariableRef, String>,
    labels: BTreeMap<JumpLabel, u32>,
    /// Loops by the blocks of their beginning and end.
    loops: BTreeMap<usize, String>,
}

impl MacroNames {
    /// Nothing where no statements of the two languages belong together, where one of the program has no
    /// counterpart, since others may depend on what it sets, or where there are too many names.
    pub fn of(source: &SourceBlocks, [from, to]: [&Control; 2]) -> Option<MacroNames> {
        match (from.macros.form, to.macros.form) {
            (MacroForm::Blocks, MacroForm::Lines) | (MacroForm::Lines, MacroForm::Blocks) => {}
            _ => return None,
        }
        let mut found = NamesInUse::default();
        for (at, block) in source.blocks.iter().enumerate() {
            if let BlockKind::Macro(range) = block.kind {
                let (meaning, _) = meaning::of(source.text, range, from)?;
                found.meaning(&meaning, at);
            }
            for word in &block.words {
                match word.value {
                    WordValue::Expression(range) => {
                        if let Some(tree) = meaning::value(source.text, range, from) {
                            found.tree(&tree);
                        }
                    }
                    WordValue::Register { index, negative } => {
                        found.tree(&ExpressionTree::register(index, negative));
                    }
                    _ => {}
                }
                found.numbers.extend(whole(Some(word)).filter(|_| word.letter == b'N'));
            }
        }
        let mut names = MacroNames { loops: found.loops, ..MacroNames::default() };
        names.variables = match to.macros.form {
            MacroForm::Lines => lettered(&found.variables)?,
            _ => numbered(&found.variables)?,
        };
        let mut free = (FIRST_LABEL..).filter(|number| !found.numbers.contains(number));
        for label in found.labels {
            let number = match label {
                JumpLabel::Number(number) => number,
                JumpLabel::Name(_) => free.next()?,
            };
            names.labels.insert(label, number);
        }
        Some(names)
    }

    pub(super) fn variable(&self, variable: VariableRef) -> Option<&str> {
        self.variables.get(&variable).map(String::as_str)
    }

    pub(super) fn label(&self, label: &JumpLabel) -> Option<u32> {
        self.labels.get(label).copied()
    }

    pub(super) fn loop_at(&self, block: usize) -> Option<&str> {
        self.loops.get(&block).map(String::as_str)
    }
}

/// `#101` as V1, others as the first that are free.
fn lettered(variables: &BTreeSet<VariableRef>) -> Option<BTreeMap<VariableRef, String>> {
    let mut names: BTreeMap<VariableRef, u32> = BTreeMap::new();
    let is_own = |number: u32| LETTERED.contains(&number);
    for variable in variables {
        let VariableRef::Number(number) = variable else { return None };
        if number.checked_sub(100).is_some_and(is_own) {
            names.insert(*variable, number - 100);
        }
    }
    let taken: BTreeSet<u32> = names.values().copied().collect();
    let mut free = LETTERED.filter(|number| !taken.contains(number));
    for variable in variables {
        // #0 holds nothing, and from 1000 on the variables are the control's own.
        let is_plain = matches!(variable, VariableRef::Number(1..=999));
        if is_plain && !names.contains_key(variable) {
            names.insert(*variable, free.next()?);
        }
    }
    Some(names.into_iter().map(|(variable, number)| (variable, format!("V{number}"))).collect())
}

/// V1 as `#101`, registers as the first that are free.
fn numbered(variables: &BTreeSet<VariableRef>) -> Option<BTreeMap<VariableRef, String>> {
    let own = |variable: &VariableRef| match variable {
        VariableRef::Letter("V", number) if LETTERED.contains(number) => Some(number + 100),
        _ => None,
    };
    let taken: BTreeSet<u32> = variables.iter().filter_map(own).collect();
    let mut free = COMMON.rev().filter(|number| !taken.contains(number));
    let mut names = BTreeMap::new();
    for variable in variables {
        let number = match variable {
            VariableRef::Letter("R", _) => free.next()?,
            _ => match own(variable) {
                Some(number) => number,
                None => continue,
            },
        };
        names.insert(*variable, format!("#{number}"));
    }
    Some(names)
}

/// What a program names.
#[derive(Default)]
struct NamesInUse {
    variables: BTreeSet<VariableRef>,
    labels: BTreeSet<JumpLabel>,
    numbers: BTreeSet<u32>,
    loops: BTreeMap<usize, String>,
    open: Vec<(u32, String)>,
}

impl NamesInUse {
    fn tree(&mut self, tree: &ExpressionTree) {
        tree.variables(&mut |variable| {
            self.variables.insert(variable);
        });
    }

    fn meaning(&mut self, meaning: &MacroMeaning, at: usize) {
        match meaning {
            MacroMeaning::Nothing | MacroMeaning::Print => {}
            MacroMeaning::Assign(variable, tree) => {
                self.variables.insert(*variable);
                self.tree(tree);
            }
            MacroMeaning::If(condition, then) => {
                self.tree(condition);
                self.meaning(then, at);
            }
            MacroMeaning::Goto(label) | MacroMeaning::Label(label) => {
                self.labels.insert(label.clone());
            }
            MacroMeaning::While(condition, number) => {
                self.tree(condition);
                let name = (self.loops.len() + 1).to_string();
                self.loops.insert(at, name.clone());
                self.open.push((*number, name));
            }
            MacroMeaning::End(number) => {
                let begun = self.open.iter().rposition(|(open, _)| open == number);
                if let Some(begun) = begun {
                    let (_, name) = self.open.remove(begun);
                    self.loops.insert(at, name);
                }
            }
        }
    }
}
