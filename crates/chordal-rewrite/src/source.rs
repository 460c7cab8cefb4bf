//! The old text as blocks, and which part of it each belongs to.

use chordal::control::{Action, AfterCode, BeforeCode, CallCode, TurnCycle, turn_facts};
use std::collections::BTreeMap;
use std::ops::Range;

use crate::word_address::BlockControl;
use chordal::Job;
use chordal::control::table::SubroutineForm;
use chordal::control::{Control, Units, subroutine_head};
use chordal::diagnostics::{FileId, Span};
use chordal::syntax::{Block, BlockKind, BlockReader, Letters, Word};
use chordal_editor::{EditorProgram, EditorSetup};

/// How a subprogram is written and called.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum SubprogramForm {
    /// A section `L100` before the main program, called by `L101`.
    Letter,
    /// From an N number after the main program, called by M97.
    Label,
    /// A program with an O number, called by M98.
    Program,
}

/// A subprogram of the text.
#[derive(Clone, Debug)]
pub(crate) struct SubprogramBlocks {
    pub form: SubprogramForm,
    /// The number of its section, its N number, or its O number.
    pub number: u32,
    pub blocks: Range<usize>,
}

/// The blocks of the old text.
pub(crate) struct SourceBlocks<'a> {
    pub text: &'a [u8],
    pub blocks: Vec<Block>,
    pub subs: Vec<SubprogramBlocks>,
    /// The block that closes the section of `L` subroutines.
    pub section_end: Option<usize>,
    /// The blocks of the main programs.
    pub mains: Vec<Range<usize>>,
    /// The program heads, main or not.
    pub heads: Vec<usize>,
    pub style: WordStyle,
}

/// How the programmer writes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WordStyle {
    /// Blanks stand between words.
    pub spaced: bool,
    /// `0.5`, not `.5`.
    pub leading_zero: bool,
    /// `G01`, not `G1`.
    pub two_digits: bool,
}

impl<'a> SourceBlocks<'a> {
    /// The words of a block as they are written, without its number.
    pub fn words_of(&self, block: &Block) -> String {
        let from = block.word(b'N').map_or(block.range.start, |word| word.range.end);
        let words = &self.text[from as usize..block.range.end as usize];
        String::from_utf8_lossy(words).trim().to_string()
    }

    /// A code of a block with those of its other words that are numbers and belong to it.
    pub fn code_with(
        &self,
        block: &Block,
        code: &Word,
        belongs: impl Fn(u8) -> bool,
    ) -> Vec<String> {
        let words = block.words.iter().filter(|word| {
            word.range == code.range || (belongs(word.letter) && word.number().is_some())
        });
        words.map(|word| self.text_of(word)).collect()
    }

    /// A word as it is written.
    pub fn text_of(&self, word: &Word) -> String {
        String::from_utf8_lossy(word.range.slice(self.text)).into_owned()
    }

    pub fn of(job: &'a Job) -> SourceBlocks<'a> {
        let text = first_text(job);
        let control = job.control();
        let mut reader = BlockReader::new(text, FileId(0), control.table.lexicon);
        let mut blocks = Vec::new();
        let mut block = Block::new();
        while reader.read(&mut block) {
            blocks.push(block.clone());
        }
        let mut source = SourceBlocks {
            text,
            style: style(text, &blocks),
            blocks,
            subs: Vec::new(),
            section_end: None,
            mains: Vec::new(),
            heads: Vec::new(),
        };
        source.find_programs(job);
        source.find_o_labels(control);
        source.find_sections(control);
        source.find_labels(control);
        source
    }

    fn find_programs(&mut self, job: &Job) {
        for program in job.programs() {
            let from = self.first_at(program.range.start);
            let to = self.first_at(program.range.end);
            if program.key().is_some() {
                self.heads.push(from);
            }
            match program.key() {
                Some(number) if !program.is_main => {
                    self.subs.push(SubprogramBlocks {
                        form: SubprogramForm::Program,
                        number,
                        blocks: from..to,
                    });
                }
                _ if program.is_main => self.mains.push(from..to),
                _ => {}
            }
        }
    }

    /// Where `O5` is a label within the one program of a file: what stands after the end from one label to
    /// the next is a subprogram.
    fn find_o_labels(&mut self, control: &Control) {
        let Some(main) = self.mains.first().cloned().filter(|_| control.table.lexicon.o_words)
        else {
            return;
        };
        let label = |at: usize| whole(self.blocks[at].word(b'O'));
        let tape_end = self.blocks.iter().rposition(|block| block.kind != BlockKind::Percent);
        let tape_end = tape_end.map_or(0, |at| at + 1).min(main.end);
        let ends = |action| matches!(action, Action::After(AfterCode::ProgramEnd { .. }));
        let end = main.clone().find(|at| self.has_action(*at, control, ends));
        let end = end.unwrap_or(main.end);
        let heads: Vec<(usize, u32)> =
            (end..tape_end).filter_map(|at| Some((at, label(at)?))).collect();
        let first = main.clone().find(|at| !self.blocks[*at].words.is_empty());
        self.heads.extend(first.filter(|at| label(*at).is_some()));
        for (index, (at, number)) in heads.iter().enumerate() {
            let to = heads.get(index + 1).map_or(tape_end, |next| next.0);
            self.heads.push(*at);
            self.subs.push(SubprogramBlocks {
                form: SubprogramForm::Program,
                number: *number,
                blocks: *at..to,
            });
        }
        if let Some((at, _)) = heads.first() {
            self.mains[0] = main.start..*at;
        }
    }

    /// The `L` sections in front of the first main program.
    fn find_sections(&mut self, control: &Control) {
        if control.table.subroutines != SubroutineForm::LetterL {
            return;
        }
        for main in self.mains.clone() {
            let mut open: Option<(u32, usize)> = None;
            let mut found = Vec::new();
            for at in main.clone() {
                let block = &self.blocks[at];
                if block.words.is_empty() || block.letters().has(b'O') {
                    continue;
                }
                let ends = self.has_action(at, control, |action| {
                    matches!(action, Action::After(AfterCode::ProgramEnd { rewind: true }))
                });
                let head = subroutine_head(block);
                if open.is_none() && head.is_none() {
                    break;
                }
                if let (Some((number, from)), true) = (open, head.is_some() || ends) {
                    found.push(SubprogramBlocks {
                        form: SubprogramForm::Letter,
                        number,
                        blocks: from..at,
                    });
                }
                open = head.map(|number| (number, at)).or(open);
                if ends {
                    self.section_end = Some(at);
                    self.subs.append(&mut found);
                    break;
                }
            }
        }
    }

    /// What M97 calls after the end of a main program.
    fn find_labels(&mut self, control: &Control) {
        let mut labels = BTreeMap::new();
        for at in 0..self.blocks.len() {
            if !self.has_action(at, control, |action| action == Action::Call(CallCode::CallLabel)) {
                continue;
            }
            let Some(label) = whole(self.blocks[at].word(b'P')) else { continue };
            let Some(main) = self.mains.iter().find(|main| main.contains(&at)).cloned() else {
                continue;
            };
            labels.insert(label, main);
        }
        for (label, main) in labels {
            let end = main.clone().find(|at| {
                self.has_action(*at, control, |action| {
                    matches!(action, Action::After(AfterCode::ProgramEnd { .. }))
                })
            });
            let start = main.clone().find(|at| whole(self.blocks[*at].word(b'N')) == Some(label));
            let (Some(end), Some(start)) = (end, start) else { continue };
            let back = (start..main.end).find(|at| {
                self.has_action(*at, control, |action| action == Action::Call(CallCode::Return))
            });
            if let Some(back) = back
                && start > end
            {
                self.subs.push(SubprogramBlocks {
                    form: SubprogramForm::Label,
                    number: label,
                    blocks: start..back + 1,
                });
            }
        }
    }

    /// The first block of a program after its head and the remarks there.
    pub fn first_words(&self, main: &Range<usize>) -> usize {
        let is_head = |at: usize| {
            let block = &self.blocks[at];
            block.kind == BlockKind::Percent
                || (block.kind == BlockKind::Words && block.words.is_empty())
                || self.heads.contains(&at)
        };
        main.clone().find(|at| !is_head(*at)).unwrap_or(main.end)
    }

    /// The first block that begins at a byte or after it.
    pub fn first_at(&self, offset: u32) -> usize {
        self.blocks.partition_point(|block| block.range.start < offset)
    }

    /// The byte that a block begins at; after the last one the end of the text.
    pub fn start_of(&self, at: usize) -> u32 {
        self.blocks.get(at).map_or(self.text.len() as u32, |block| block.range.start)
    }

    /// The byte after a block and its line end.
    pub fn end_of(&self, at: usize) -> u32 {
        self.start_of(at + 1)
    }

    /// The block at a place of the text.
    pub fn block_at(&self, span: Span) -> Option<usize> {
        if span.file != FileId(0) {
            return None;
        }
        self.blocks.binary_search_by_key(&span.range.start, |block| block.range.start).ok()
    }

    /// The blocks on lines from one to another, from 1.
    pub fn blocks_on(&self, from: u32, to: u32) -> Range<usize> {
        self.blocks.partition_point(|block| block.line < from)
            ..self.blocks.partition_point(|block| block.line <= to)
    }

    /// The words of a block as they stand.
    pub fn words(&self, at: usize) -> String {
        String::from_utf8_lossy(self.blocks[at].range.slice(self.text)).trim().to_string()
    }

    /// The subprogram that a block belongs to.
    pub fn sub_of(&self, at: usize) -> Option<usize> {
        self.subs.iter().position(|sub| sub.blocks.contains(&at))
    }

    /// True when a block has a code that does this.
    pub fn has_action(&self, at: usize, control: &Control, is: impl Fn(Action) -> bool) -> bool {
        self.blocks[at].words.iter().any(|word| code_action(word, control).is_some_and(&is))
    }

    /// True when a block changes the tool.
    pub fn changes_tool(&self, at: usize, control: &Control) -> bool {
        self.has_action(at, control, |action| action == Action::Before(BeforeCode::ToolChange))
    }
}

/// What a G or M word does on a control.
pub(crate) fn code_action(word: &Word, control: &Control) -> Option<Action> {
    control.row_of(word).map(|row| row.action)
}

/// The block has none of the words that end a cycle of two blocks: P and Q, or X and Z.
pub(crate) fn lacks_ends(cycle: TurnCycle, block: &Block) -> bool {
    let ends = turn_facts(cycle).ends;
    !ends.is_empty() && !block.letters().meets(Letters::of(ends))
}

/// It is the first of two blocks of a cycle, where the control has them in two.
pub(crate) fn is_setup(cycle: TurnCycle, block: &Block, control: &Control) -> bool {
    control.parameters.rules.turning.two_blocks && lacks_ends(cycle, block)
}

/// Decimals with which the arcs of a control end on their circles, where a firmware judges each one as it is written: end,
/// centre and start are each rounded along two axes.
pub(crate) fn digits_of_arcs(control: &Control, units: Units, usual: u8) -> u8 {
    const ROUNDED: f64 = 2.2;
    let arc = &control.parameters.rules.arc;
    let unit = units.mm();
    let is_enough = |digits: &u8| {
        ROUNDED * unit * 0.1f64.powi(i32::from(*digits)) <= arc.radius_error_tolerance_mm
    };
    let more = (usual..=usual + 2).find(is_enough).unwrap_or(usual);
    if arc.judged_before { more } else { usual }
}

/// A whole number not below zero.
pub(crate) fn whole(word: Option<&Word>) -> Option<u32> {
    u32::try_from(word?.number()?.to_integer()?).ok()
}

fn style(text: &[u8], blocks: &[Block]) -> WordStyle {
    let (mut together, mut separate) = (0, 0);
    let (mut zeros, mut points) = (0, 0);
    let (mut two, mut one) = (0, 0);
    for block in blocks.iter().take(2000) {
        for pair in block.words.windows(2) {
            if pair[1].range.start > pair[0].range.end { separate += 1 } else { together += 1 }
        }
        for word in &block.words {
            let written = &word.range.slice(text)[1..];
            let digits = written.strip_prefix(b"-").unwrap_or(written);
            zeros += usize::from(digits.starts_with(b"0."));
            points += usize::from(digits.starts_with(b"."));
            if word.letter == b'G' && digits.len() <= 2 {
                two += usize::from(digits.len() == 2 && digits[0] == b'0');
                one += usize::from(digits.len() == 1);
            }
        }
    }
    WordStyle { spaced: separate >= together, leading_zero: zeros > points, two_digits: two > one }
}

/// The text as an editor holds it, for the places of names.
pub(crate) fn program(job: &Job) -> Option<EditorProgram> {
    let texts = job.sources().iter().skip(1);
    let adjacent = texts.map(|(_, source)| (source.name().to_string(), source.text().to_vec()));
    let setup = EditorSetup {
        subprogram_texts: adjacent.collect(),
        ..EditorSetup::of(job.machine().clone())
    };
    let name = job.sources().get(FileId(0)).map_or("", |source| source.name());
    EditorProgram::set_up(name, first_text(job).to_vec(), setup).ok()
}

/// The program's own text.
pub(crate) fn first_text<'a>(job: &'a Job) -> &'a [u8] {
    job.sources().get(FileId(0)).map_or(&[], chordal::Source::text)
}
