//! Statements of one macro language in another: macro B (Haas, Fanuc, Mitsubishi) and the macro lines of a
//! Fadal. Statements that only one of the two has are not kept, and what they steer is written out.

mod meaning;
mod names;
mod tree;
mod write;

use chordal::control::Control;
use chordal::diagnostics::TextRange;
use chordal::syntax::WordValue;

pub(crate) use self::names::MacroNames;
use self::tree::ExpressionTree;
use super::comments;
use super::draft::{BlockDraft, NeedsExpansion};
use crate::source::SourceBlocks;

/// Letters whose values may be computed on both.
const COMPUTED: &[u8] = b"XYZABCIJKFS";

/// Registers that words may name (Fadal R1 to R9; R0 is the radius of arcs).
const REGISTERS: std::ops::RangeInclusive<usize> = 1..=9;

/// Macro statements of a program for another control.
pub(crate) struct MacroConverter<'a> {
    source: &'a SourceBlocks<'a>,
    controls: [&'a Control; 2],
    /// Nothing where the two languages have nothing in common.
    names: Option<MacroNames>,
}

impl<'a> MacroConverter<'a> {
    pub fn of(source: &'a SourceBlocks<'a>, controls: [&'a Control; 2]) -> MacroConverter<'a> {
        MacroConverter { source, controls, names: MacroNames::of(source, controls) }
    }

    /// A block with a statement.
    pub fn statement(
        &self,
        draft: &mut BlockDraft,
        at: usize,
        range: TextRange,
    ) -> Result<(), NeedsExpansion> {
        let title = self.controls[1].table.title;
        let unknown = || NeedsExpansion(format!("{title} does not have this statement"));
        let names = self.names.as_ref().ok_or_else(unknown)?;
        let block = &self.source.blocks[at];
        let is_alone = block.words.iter().all(|word| word.letter == b'N') && block.delete.is_none();
        let meaning = meaning::of(self.source.text, range, self.controls[0]);
        let (meaning, remark) = meaning.filter(|_| is_alone).ok_or_else(unknown)?;
        let lines = write::statement(&meaning, names, at, self.controls[1]).ok_or_else(unknown)?;
        let number = block.words.first().map(|_| draft.written(0));
        let mut lines = write::numbered(lines, number, self.controls[1], self.source.style);
        if let Some(remark) = remark.and_then(|remark| self.remark(&remark)) {
            write::remark(&mut lines, &remark, self.controls[1]);
        }
        let before = self.source.words(at);
        draft.note(before, lines.join("\n"), format!("{title} writes this statement like this"));
        draft.instead = Some(lines);
        Ok(())
    }

    fn remark(&self, written: &str) -> Option<String> {
        let lexicons = self.controls.map(|control| control.table.lexicon);
        Some(comments::comment(written, &lexicons[0], &lexicons[1])).filter(|text| !text.is_empty())
    }

    /// Words whose values are computed.
    pub fn values(&self, draft: &mut BlockDraft, at: usize) -> Result<(), NeedsExpansion> {
        let title = self.controls[1].table.title;
        let mut registers = REGISTERS;
        for word in 0..self.source.blocks[at].words.len() {
            let own = self.source.blocks[at].words[word];
            if !matches!(own.value, WordValue::Expression(_) | WordValue::Register { .. }) {
                continue;
            }
            let unknown =
                || NeedsExpansion(format!("{title} does not have `{}`", draft.written(word)));
            let is_usual = COMPUTED.contains(&own.letter) && own.register.is_none() && !own.comma;
            let names = self.names.as_ref().filter(|_| is_usual).ok_or_else(unknown)?;
            let tree = match own.value {
                WordValue::Expression(range) => {
                    meaning::value(self.source.text, range, self.controls[0]).ok_or_else(unknown)?
                }
                WordValue::Register { index, negative } => {
                    ExpressionTree::register(index, negative)
                }
                _ => continue,
            };
            let letter = char::from(own.letter);
            if self.controls[1].table.lexicon.registers {
                let register = registers.next().ok_or_else(unknown)?;
                let value =
                    write::expression(&tree, names, self.controls[1]).ok_or_else(unknown)?;
                let line = format!("# R{register}={value}");
                let reason = format!("{title} computes values in registers");
                draft.replace(word, format!("{letter}+R{register}"), reason.clone());
                draft.note(String::new(), line.clone(), reason);
                draft.before.push(line);
            } else {
                let value = write::value(&tree, names, self.controls[1]).ok_or_else(unknown)?;
                let reason = format!("{title} takes values from its own variables");
                draft.replace(word, format!("{letter}{value}"), reason);
            }
        }
        Ok(())
    }
}
