//! The word-address language as a [`Language`], for all controls of the tables.

use chordal_diagnostics::{FileId, SourceMap, Span, TextRange};
use chordal_dialect::Control;
use chordal_kernel::{Checkpoint, CompletedRun, Language, ProgramPlace, RunSink, Token};
use chordal_machine::Machine;
use chordal_syntax::{Block, BlockReader};

use crate::interpreter::run_from;
use crate::library::Library;
use crate::macro_alone::missing_call;
use crate::run_options::RunOptions;
use crate::tokens::block_tokens;

/// The programs of some texts with the machine and its control.
pub struct WordAddress<'a> {
    sources: &'a SourceMap<'a>,
    library: Library<'a>,
    machine: &'a Machine,
    control: &'a Control,
    options: &'a RunOptions,
}

impl<'a> WordAddress<'a> {
    /// Finds the programs of the texts.
    pub fn new(
        sources: &'a SourceMap<'a>,
        machine: &'a Machine,
        control: &'a Control,
        options: &'a RunOptions,
    ) -> WordAddress<'a> {
        let library = Library::new(sources, &control.table.lexicon);
        WordAddress { sources, library, machine, control, options }
    }

    /// The programs of all texts.
    pub fn library(&self) -> &Library<'a> {
        &self.library
    }

    /// The indices of the main programs, with which a run can begin.
    pub fn mains(&self) -> Vec<usize> {
        self.library.mains(&self.control.table.lexicon, &self.control.alias_programs())
    }

    /// True for a macro, which is not run without its caller.
    pub fn needs_caller(&self, program: usize) -> bool {
        let program = self.library.programs().get(program).copied();
        program.is_some_and(|program| missing_call(&self.library, program, self.control).is_some())
    }

    fn text(&self) -> &'a [u8] {
        self.sources.get(FileId(0)).map_or(&[], |source| source.text())
    }

    /// Each block of a part of the first text.
    fn blocks(&self, part: TextRange, mut each: impl FnMut(&Block)) {
        let text = self.text();
        let mut reader = BlockReader::new(text, FileId(0), self.control.table.lexicon);
        let mut block = Block::new();
        while reader.read(&mut block) && block.range.start < part.end {
            if block.range.end >= part.start {
                each(&block);
            }
        }
    }
}

impl Language for WordAddress<'_> {
    fn programs(&self) -> Vec<ProgramPlace> {
        let mains = self.mains();
        let programs = self.library.programs().iter();
        let own = programs.take_while(|program| program.file == FileId(0)).enumerate();
        own.map(|(place, program)| ProgramPlace {
            span: Span {
                file: FileId(0),
                range: TextRange::new(program.head.start.offset, program.head.end),
            },
            number: program.head.number,
            is_main: mains.binary_search(&place).is_ok(),
        })
        .collect()
    }

    fn run(
        &self,
        program: usize,
        from: Option<&Checkpoint>,
        sink: &mut dyn RunSink,
    ) -> Option<CompletedRun> {
        let (library, machine) = (&self.library, self.machine);
        run_from(library, program, machine, self.control, self.options, sink, from)
    }

    fn tokens(&self, part: TextRange) -> Vec<Token> {
        let mut tokens = Vec::new();
        let lexicon = &self.control.table.lexicon;
        self.blocks(part, |block| block_tokens(self.text(), lexicon, block, &mut tokens));
        tokens.retain(|token| token.range.start >= part.start && token.range.start < part.end);
        tokens
    }

    fn meaning(&self, at: u32) -> Option<(TextRange, String)> {
        let mut found = None;
        self.blocks(TextRange::new(at, at + 1), |block| {
            let mut words = block.words.iter();
            let Some(word) = words.find(|word| word.range.start <= at && at < word.range.end)
            else {
                return;
            };
            let row = self.control.row_of(word);
            found =
                row.map(|row| (word.range, format!("{}: {}", row.name(word.letter), row.title)));
        });
        found
    }
}
