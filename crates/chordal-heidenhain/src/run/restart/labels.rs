//! Subprograms that stand before the line and are called after it.

use std::collections::BTreeSet;
use std::ops::Range;

use chordal_kernel::{RestartFault, RestartObstacle};

use super::source::{SourceText, fault};
use crate::run::contour_programs::label_numbers;
use crate::syntax::{KlartextLabel, KlartextStatement};

/// How a block names a label.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum LabelUse {
    /// It calls the subprogram and goes on after it.
    Call,
    /// It goes on there.
    Jump,
}

impl SourceText<'_> {
    /// The labels that a block names.
    fn labels_of(&self, at: usize) -> Vec<(KlartextLabel, LabelUse)> {
        match self.statement(at) {
            KlartextStatement::CallLabel { label, repeats: None } => {
                vec![(label.clone(), LabelUse::Call)]
            }
            KlartextStatement::CallLabel { label, .. } | KlartextStatement::Jump { label, .. } => {
                vec![(label.clone(), LabelUse::Jump)]
            }
            KlartextStatement::CycleLine { number: 14, line: 1.., rest, .. } => {
                let numbers = label_numbers(rest.slice(self.text));
                numbers
                    .into_iter()
                    .map(|own| (KlartextLabel::Number(own), LabelUse::Call))
                    .collect()
            }
            _ => Vec::new(),
        }
    }

    /// The subprograms before a block that the blocks from it on need, and those that `contours` names: ranges of blocks in
    /// their order.
    pub fn needed_before(
        &self,
        at: usize,
        contours: &[KlartextLabel],
    ) -> Result<Vec<Range<usize>>, RestartFault> {
        let mut found: Vec<Range<usize>> = Vec::new();
        for label in contours {
            self.add_section(at, at, label, LabelUse::Call, &mut found)?;
        }
        let mut open: Vec<usize> = (at..self.blocks.len()).collect();
        let mut done = BTreeSet::new();
        loop {
            for block in std::mem::take(&mut open) {
                if !done.insert(block) {
                    continue;
                }
                for (label, by) in self.labels_of(block) {
                    if matches!(label, KlartextLabel::Parameter(_)) {
                        // It may be any of them.
                        self.add_all(at, &mut found);
                    } else {
                        self.add_section(at, block, &label, by, &mut found)?;
                    }
                }
            }
            open.extend(found.iter().flat_map(Clone::clone).filter(|block| !done.contains(block)));
            if open.is_empty() {
                return Ok(joined(found));
            }
        }
    }

    /// Adds the subprogram of a label that a block names, if it stands before the line.
    fn add_section(
        &self,
        at: usize,
        from: usize,
        label: &KlartextLabel,
        by: LabelUse,
        found: &mut Vec<Range<usize>>,
    ) -> Result<(), RestartFault> {
        let Some(first) = self.label(label).filter(|first| *first < at) else { return Ok(()) };
        if found.iter().any(|range| range.contains(&first)) {
            return Ok(());
        }
        let line = self.line(first);
        if by == LabelUse::Jump {
            let what = format!(
                "line {} goes back to the label in line {line}, before the line",
                self.line(from)
            );
            let help = format!("begin before line {line}, or after line {}", self.line(from));
            return Err(fault(RestartObstacle::Repeated, what, help));
        }
        match self.end_of_section(first).filter(|end| *end <= at) {
            Some(end) => found.push(first..end),
            None => {
                let what = format!(
                    "the line is in the subprogram of the label in line {line}, which line {} calls",
                    self.line(from)
                );
                let help = format!("begin at line {line}, or after its LBL 0");
                return Err(fault(RestartObstacle::Called, what, help));
            }
        }
        Ok(())
    }

    /// Adds all subprograms that end before a block.
    fn add_all(&self, at: usize, found: &mut Vec<Range<usize>>) {
        let is_label = |own: &usize| matches!(self.statement(*own), KlartextStatement::Label(label) if *label != KlartextLabel::Number(0));
        for first in (0..at).filter(is_label) {
            let end = self.end_of_section(first).filter(|end| *end <= at);
            found.extend(end.map(|end| first..end));
        }
    }

    /// The block after the LBL 0 that ends a subprogram.
    fn end_of_section(&self, first: usize) -> Option<usize> {
        let ends = |own: &usize| {
            *self.statement(*own) == KlartextStatement::Label(KlartextLabel::Number(0))
        };
        (first..self.blocks.len()).find(ends).map(|end| end + 1)
    }

    /// The number of a label that the text does not have, for a jump over the subprograms.
    pub fn free_label(&self) -> u32 {
        let is_free = |number: &u32| self.label(&KlartextLabel::Number(*number)).is_none();
        // Old controls have labels up to 254.
        (1..=254).rev().find(is_free).or_else(|| (255..65_535).find(is_free)).unwrap_or(65_535)
    }
}

/// Ranges in their order, those that overlap as one.
fn joined(mut ranges: Vec<Range<usize>>) -> Vec<Range<usize>> {
    ranges.sort_by_key(|range| (range.start, range.end));
    let mut joined: Vec<Range<usize>> = Vec::new();
    for range in ranges {
        match joined.last_mut() {
            Some(last) if range.start < last.end => last.end = last.end.max(range.end),
            _ => joined.push(range),
        }
    }
    joined
}
