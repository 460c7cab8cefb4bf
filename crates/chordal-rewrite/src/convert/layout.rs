//! The new text: the blocks in the places where the new control wants them.

use chordal::control::{Action, AfterCode, CallCode};
use std::ops::Range;

use chordal::control::{Control, referenced_programs};
use chordal::syntax::{BlockKind, Semicolon};

use super::codes;
use super::structure::{ProgramStructure, program_name};
use crate::source::{SourceBlocks, SubprogramBlocks, SubprogramForm, whole};

/// The new lines of each block; nothing for blocks that are left out.
pub(crate) type BlockLines = Vec<Option<Vec<String>>>;

/// A text and the block that each of its lines comes from.
#[derive(Debug, Default)]
pub(crate) struct TextLayout {
    pub text: String,
    /// By line, from 0.
    pub from: Vec<Option<usize>>,
}

impl TextLayout {
    fn push(&mut self, line: &str, end: &str, block: Option<usize>) {
        self.text.push_str(line);
        self.text.push_str(end);
        self.from.push(block);
    }
}

/// Puts the blocks together. Subprograms that nothing calls any more would be programs of their own:
/// they are left out.
pub(crate) fn lay_out(
    source: &SourceBlocks,
    structure: &ProgramStructure,
    mut lines: BlockLines,
    controls: [&Control; 2],
) -> TextLayout {
    // After the last section the control ends; without sections, so would the program.
    let letters = || source.subs.iter().filter(|sub| sub.form == SubprogramForm::Letter);
    let mut kept = letters().flat_map(|sub| &lines[sub.blocks.clone()]);
    if let Some(end) = source.section_end
        && !kept.any(Option::is_some)
    {
        lines[end] = None;
    }
    loop {
        let layout = lay_out_all(source, structure, &lines, controls);
        let called = referenced_programs(layout.text.as_bytes(), &controls[1].table.lexicon);
        let mut dropped = false;
        for (sub, target) in source.subs.iter().zip(&structure.targets) {
            let is_there = lines[sub.blocks.clone()].iter().any(Option::is_some);
            if target.0 == SubprogramForm::Program && is_there && !called.contains(&target.1) {
                lines[sub.blocks.clone()].fill(None);
                dropped = true;
            }
        }
        if !dropped {
            return layout;
        }
    }
}

fn lay_out_all(
    source: &SourceBlocks,
    structure: &ProgramStructure,
    lines: &BlockLines,
    [from, to]: [&Control; 2],
) -> TextLayout {
    let mut layout = TextLayout::default();
    let writer = LayoutWriter { source, lines, to };
    let is_there = |sub: &SubprogramBlocks| lines[sub.blocks.clone()].iter().any(Option::is_some);
    let all = 0..source.blocks.len();
    let needs_head = structure
        .mains
        .iter()
        .zip(&source.mains)
        .any(|(number, main)| number.is_some() && !source.heads.contains(&main.start));
    let has_programs = structure.targets.iter().any(|target| target.0 == SubprogramForm::Program);
    let looks_ahead = to.table.lexicon.o_words && !from.table.lexicon.o_words && has_programs;
    if structure.stays(source) && !needs_head && !looks_ahead {
        writer.blocks(all, &mut layout);
        return layout;
    }
    let tape_end = source.blocks.iter().rposition(|block| block.kind != BlockKind::Percent);
    let tape_end = tape_end.map_or(0, |at| at + 1);
    let sections: Vec<Range<usize>> = source
        .subs
        .iter()
        .filter(|sub| sub.form != SubprogramForm::Program)
        .map(|s| s.blocks.clone())
        .collect();
    let in_section = |at: usize| {
        sections.iter().any(|range| range.contains(&at)) || source.section_end == Some(at)
    };
    // What stands before all programs.
    let subs =
        source.subs.iter().filter(|sub| sub.form == SubprogramForm::Program).map(|sub| &sub.blocks);
    let first = source.mains.iter().chain(subs).map(|program| program.start).min().unwrap_or(0);
    writer.blocks(0..first, &mut layout);
    for (index, main) in source.mains.iter().enumerate() {
        let main = main.start..main.end.min(tape_end);
        let body = source.first_words(&main);
        writer.blocks(main.start..body, &mut layout);
        if let Some(number) = structure.mains[index].filter(|_| !source.heads.contains(&main.start))
        {
            if index == 0 && source.blocks.first().is_none_or(|b| b.kind != BlockKind::Percent) {
                layout.text.insert_str(0, "%\n");
                layout.from.insert(0, None);
            }
            layout.push(&program_name(number, to), "\n", None);
        }
        let place = |form: SubprogramForm, layout: &mut TextLayout| {
            let mut subs: Vec<_> = source.subs.iter().zip(&structure.targets).collect();
            if looks_ahead {
                // What is called stands before its callers in sections.
                subs.reverse();
            }
            for (sub, target) in subs {
                let moved = sub.form != SubprogramForm::Program && target.0 == form;
                if moved && main.contains(&sub.blocks.start) && is_there(sub) {
                    writer.blocks(sub.blocks.clone(), layout);
                    writer.close(sub.blocks.clone(), form, from, layout);
                }
            }
        };
        place(SubprogramForm::Letter, &mut layout);
        let has_sections = source.subs.iter().zip(&structure.targets).any(|(sub, target)| {
            target.0 == SubprogramForm::Letter && main.contains(&sub.blocks.start) && is_there(sub)
        });
        if has_sections {
            let end = codes::name(
                Action::After(AfterCode::ProgramEnd { rewind: true }),
                to,
                source.style,
            );
            layout.push(&end.unwrap_or_default(), "\n", source.section_end);
        }
        let mut at = body;
        while at < main.end {
            let to = (at..main.end).find(|at| in_section(*at)).unwrap_or(main.end);
            writer.blocks(at..to, &mut layout);
            at = (to..main.end).find(|at| !in_section(*at)).unwrap_or(main.end);
        }
        place(SubprogramForm::Label, &mut layout);
        place(SubprogramForm::Program, &mut layout);
    }
    let mut subs: Vec<&SubprogramBlocks> =
        source.subs.iter().filter(|sub| sub.form == SubprogramForm::Program).collect();
    if looks_ahead {
        callers_first(&mut subs, source, from);
    }
    for sub in subs {
        writer.blocks(sub.blocks.start..sub.blocks.end.min(tape_end), &mut layout);
    }
    writer.blocks(tape_end..source.blocks.len(), &mut layout);
    if layout.text.starts_with("%\n") && tape_end == source.blocks.len() {
        layout.push("%", "\n", None);
    }
    layout
}

/// Where a call finds only what comes after it, a subprogram stands before those that it calls.
fn callers_first(subs: &mut Vec<&SubprogramBlocks>, source: &SourceBlocks, from: &Control) {
    let is_call = |action: Action| action == Action::Call(CallCode::CallProgram);
    let calls = |sub: &SubprogramBlocks, number: u32| {
        sub.blocks.clone().any(|at| {
            source.has_action(at, from, is_call)
                && whole(source.blocks[at].last(b'P')) == Some(number)
        })
    };
    let mut ordered: Vec<&SubprogramBlocks> = Vec::with_capacity(subs.len());
    while !subs.is_empty() {
        let next = subs.iter().position(|sub| {
            !subs.iter().any(|other| !std::ptr::eq(*other, *sub) && calls(other, sub.number))
        });
        // Subprograms that call each other have no order.
        ordered.push(subs.remove(next.unwrap_or(0)));
    }
    *subs = ordered;
}

struct LayoutWriter<'a> {
    source: &'a SourceBlocks<'a>,
    lines: &'a BlockLines,
    to: &'a Control,
}

impl LayoutWriter<'_> {
    /// Writes blocks, each with what stood after it up to the next.
    fn blocks(&self, blocks: Range<usize>, layout: &mut TextLayout) {
        let mut blocks = blocks.peekable();
        while let Some(at) = blocks.next() {
            let Some(lines) = &self.lines[at] else { continue };
            let (mut end, mut empty) = self.rest_of_line(at);
            // A remark on the same line stays there.
            while empty.is_none()
                && let Some(remark) = blocks.peek().and_then(|next| self.remark(*next))
                && let Some(next) = blocks.next()
            {
                let (mark, lines) = self.rest_of_line(next);
                end += &format!(" {}{mark}", remark.trim());
                empty = lines;
            }
            for (index, line) in lines.iter().enumerate() {
                let is_last = index + 1 == lines.len();
                let mark = if is_last { end.clone() } else { self.rest_of_line(at).0 };
                layout.push(line, &format!("{mark}\n"), Some(at));
            }
            for _ in 0..empty.unwrap_or(0) {
                layout.push("", "\n", None);
            }
        }
    }

    /// What stands after a block on its line, and how many empty lines follow; nothing where the next block
    /// is on the same line.
    fn rest_of_line(&self, at: usize) -> (String, Option<usize>) {
        let block = &self.source.blocks[at];
        let end = self.source.start_of(at + 1);
        let gap = &self.source.text[block.range.end as usize..end as usize];
        let gap = String::from_utf8_lossy(gap);
        let (mark, empty) = match gap.split_once('\n') {
            Some((mark, rest)) => (mark, Some(rest.matches('\n').count())),
            None => (gap.as_ref(), (end as usize == self.source.text.len()).then_some(0)),
        };
        let is_comment = self.to.table.lexicon.semicolon == Semicolon::Comment;
        let mark = mark.trim_end();
        let mark = if is_comment { mark.replace(';', "") } else { mark.to_string() };
        let blank = block.range.slice(self.source.text).last().is_some_and(|byte| *byte == b' ');
        let is_spaced = blank && !mark.trim().is_empty();
        (format!("{}{}", if is_spaced { " " } else { "" }, mark.trim_end()), empty)
    }

    /// The line of a block that is a remark and nothing else.
    fn remark(&self, at: usize) -> Option<&str> {
        let block = &self.source.blocks[at];
        let is_remark = block.kind == BlockKind::Words && block.words.is_empty();
        let [line] = self.lines[at].as_deref().filter(|_| is_remark)? else { return None };
        Some(line)
    }

    /// The end of a subprogram that ended where the next began.
    fn close(
        &self,
        blocks: Range<usize>,
        form: SubprogramForm,
        from: &Control,
        layout: &mut TextLayout,
    ) {
        let is_end = |action| {
            matches!(action, Action::Call(CallCode::SubroutineEnd) | Action::Call(CallCode::Return))
        };
        if blocks.clone().any(|at| self.source.has_action(at, from, is_end)) {
            return;
        }
        let action = if form == SubprogramForm::Letter {
            Action::Call(CallCode::SubroutineEnd)
        } else {
            Action::Call(CallCode::Return)
        };
        let name = codes::name(action, self.to, self.source.style);
        layout.push(&name.unwrap_or_default(), "\n", Some(blocks.end.saturating_sub(1)));
    }
}
