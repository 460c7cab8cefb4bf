//! The programs, tools and operations of a text.

use chordal::control::{Action, BeforeCode};
use chordal::diagnostics::TextRange;
use chordal::syntax::{Block, BlockKind};

use super::WordAddressText;
use crate::outline::{EntryKind, OutlineEntry};

/// Labels of a text with more are a numbering of blocks and no places to go to.
const MAX_LABELS: usize = 200;

impl WordAddressText<'_> {
    /// The outline: programs, in them tools, in those operations, and blocks with numbers where
    /// only some have one.
    pub(crate) fn outline(&self) -> Vec<OutlineEntry> {
        let mut flat: Vec<(u8, OutlineEntry)> = Vec::new();
        let mut labels = 0;
        let (mut blocks, mut tool) = (0_usize, None);
        self.blocks(1, u32::MAX, |block| {
            blocks += usize::from(!block.is_idle());
            let first = flat.is_empty();
            let entry = self.entry(block, first, &mut tool);
            labels += usize::from(matches!(&entry, Some((LABEL, _))));
            // A million numbered blocks are not kept to be dropped below.
            if !matches!(&entry, Some((LABEL, _))) || labels <= MAX_LABELS {
                flat.extend(entry);
            }
        });
        if labels > MAX_LABELS || labels * 3 > blocks {
            flat.retain(|(depth, _)| *depth != LABEL);
        }
        nested(flat, self.text().len() as u32)
    }

    /// What a block begins, and how deep that lies.
    fn entry(
        &self,
        block: &Block,
        first: bool,
        tool: &mut Option<u32>,
    ) -> Option<(u8, OutlineEntry)> {
        if let BlockKind::Macro(range) = block.kind {
            return self.sub_entry(block, range);
        }
        if let Some(word) = block.word(b'T').and_then(|word| word.number()?.to_integer()) {
            *tool = u32::try_from(word).ok();
        }
        if let Some(word) = block.word(b'O')
            && let Some(number) = word.number().and_then(|number| number.to_integer())
        {
            let written = word.range.slice(self.text());
            let name = match written.first() {
                Some(b'<') => String::from_utf8_lossy(written).into_owned(),
                _ => format!("O{number}"),
            };
            return Some((PROGRAM, self.make(block, EntryKind::Program, name)));
        }
        let changes = block.words.iter().any(|word| {
            self.control()
                .row_of(word)
                .is_some_and(|row| row.action == Action::Before(BeforeCode::ToolChange))
        });
        if changes {
            let name = tool.map_or("tool change".into(), |number| format!("T{number}"));
            let mut entry = self.make(block, EntryKind::Tool, name);
            let known = tool.and_then(|number| self.machine().tools.get(&number));
            let stated = known.and_then(|tool| tool.label());
            if let (Some(stated), true) = (stated, entry.detail.is_empty()) {
                entry.detail = stated.to_string();
            }
            return Some((TOOL, entry));
        }
        if block.words.is_empty() && block.kind == BlockKind::Words {
            let name = self.comment_of(block);
            // A row of stars or lines is drawing.
            let speaks = name.bytes().any(|byte| byte.is_ascii_alphanumeric());
            return (speaks && !first)
                .then(|| (OPERATION, self.make(block, EntryKind::Operation, name)));
        }
        let label = block.word(b'N')?.number()?.to_integer()?;
        Some((LABEL, self.make(block, EntryKind::Label, format!("N{label}"))))
    }

    fn sub_entry(&self, block: &Block, range: TextRange) -> Option<(u8, OutlineEntry)> {
        let lexicon = self.lexicon();
        let text = range.slice(self.text());
        if !lexicon.o_words || !text.first().is_some_and(|byte| matches!(byte, b'o' | b'O')) {
            return None;
        }
        let upper = text.to_ascii_uppercase();
        let upper = String::from_utf8_lossy(&upper).into_owned();
        let (label, word) = upper.trim().rsplit_once([' ', '>', '\t'])?;
        let label = label.trim().to_ascii_lowercase();
        // `o<part>sub` is split at its bracket, `o<part> sub` is not.
        let is_open = label.contains('<') && !label.ends_with('>');
        let name = if is_open { format!("{label}>") } else { label };
        (word == "SUB").then(|| (PROGRAM, self.make(block, EntryKind::Subroutine, name)))
    }

    fn make(&self, block: &Block, kind: EntryKind, name: String) -> OutlineEntry {
        let detail = if block.words.is_empty() { String::new() } else { self.comment_of(block) };
        OutlineEntry {
            name,
            detail,
            kind,
            range: block.range,
            head: block.range,
            line: block.line,
            children: Vec::new(),
        }
    }

    /// The first comment of a block without its marks.
    pub(crate) fn comment_of(&self, block: &Block) -> String {
        let Some(range) = block.comments.first() else { return String::new() };
        let text = String::from_utf8_lossy(range.slice(self.text()));
        text.trim_matches(['(', ')', ';', '*', '\'', ' ', '\t']).to_string()
    }
}

/// How deep entries lie.
const PROGRAM: u8 = 0;
const TOOL: u8 = 1;
const OPERATION: u8 = 2;
const LABEL: u8 = 3;

/// Puts each entry into the last one that is less deep, and lets it reach to the next that is not
/// deeper.
fn nested(flat: Vec<(u8, OutlineEntry)>, end: u32) -> Vec<OutlineEntry> {
    let mut roots: Vec<OutlineEntry> = Vec::new();
    let mut open: Vec<(u8, OutlineEntry)> = Vec::new();
    let close =
        |open: &mut Vec<(u8, OutlineEntry)>, roots: &mut Vec<OutlineEntry>, depth: u8, at: u32| {
            while open.last().is_some_and(|(other, _)| *other >= depth) {
                let Some((_, mut entry)) = open.pop() else { return };
                entry.range.end = at.max(entry.head.end);
                match open.last_mut() {
                    Some((_, parent)) => parent.children.push(entry),
                    None => roots.push(entry),
                }
            }
        };
    for (depth, entry) in flat {
        close(&mut open, &mut roots, depth, entry.range.start);
        open.push((depth, entry));
    }
    close(&mut open, &mut roots, 0, end);
    roots
}
