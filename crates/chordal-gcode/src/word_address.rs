//! Word-address blocks as a [`ProgrammingLanguage`], for all controls of the tables.

use std::any::Any;
use std::cell::OnceCell;
use std::ops::Deref;
use std::sync::Arc;

use chordal_command::{AxisMask, WorkName};
use chordal_diagnostics::{Diagnostic, FileId, SourceMap, TextRange};
use chordal_dialect::{Control, DecimalPoint};
use chordal_kernel::rules::Rules;
use chordal_kernel::{
    Checkpoint, CompletedRun, ConfiguredControl, ControlCandidate, ControlProfile, Offsets,
    ProgramName, ProgramPlace, ProgramSet, ProgrammingLanguage, RunOptions, RunSink, SettingError,
    Token,
};
use chordal_machine::{ControlName, Machine};
use chordal_syntax::{Block, BlockReader, Lexicon, ProgramHead, find_programs, is_program_name};

use crate::called_subroutines::called_subs;
use crate::initial_offsets::{initial_offsets, initial_work_offset};
use crate::interpreter::run_from;
use crate::library::{Library, referenced_programs};
use crate::macro_alone::missing_call;
use crate::recognize::{candidates, leaves_whole_numbers_open};
use crate::tokens::block_tokens;

/// The language of word-address blocks.
#[derive(Debug)]
pub struct WordAddressLanguage;

impl ProgrammingLanguage for WordAddressLanguage {
    fn title(&self) -> &'static str {
        "word-address blocks"
    }

    fn profile(&self, control: ControlName) -> Option<ControlProfile> {
        chordal_dialect::table(control).map(|table| table.profile())
    }

    fn configure(
        &self,
        machine: &Machine,
    ) -> Option<(Arc<dyn ConfiguredControl>, Vec<SettingError>)> {
        let (control, errors) = Control::of(machine)?;
        Some((Arc::new(WordAddressControl(control)), errors))
    }

    /// Whether some line begins like a block: with a letter and a number, a program head or a percent sign.
    fn has_program_line(&self, text: &[u8]) -> bool {
        text.split(|byte| matches!(byte, b'\n' | b'\r')).any(|line| {
            let mut bytes = line.iter().filter(|byte| !matches!(byte, b' ' | b'\t' | 0));
            match (bytes.next(), bytes.next()) {
                (Some(b'%'), _) => true,
                (Some(b'/' | b'#'), Some(next)) => next.is_ascii_alphanumeric(),
                (Some(first), Some(next)) => {
                    (first.is_ascii_alphabetic() || *first == b':')
                        && (next.is_ascii_digit() || matches!(next, b'.' | b'-' | b'+'))
                }
                _ => false,
            }
        })
    }

    fn recognize(&self, text: &[u8]) -> Vec<ControlCandidate> {
        candidates(text)
    }
}

/// A control with word-address blocks, with the settings of a machine applied.
#[derive(Clone, Debug)]
pub struct WordAddressControl(pub Control);

impl WordAddressControl {
    /// The tables of a control; `None` when its programs are written in another language.
    pub fn tables(control: &dyn ConfiguredControl) -> Option<&Control> {
        let own: &WordAddressControl = control.as_any().downcast_ref()?;
        Some(&own.0)
    }
}

impl Deref for WordAddressControl {
    type Target = Control;

    fn deref(&self) -> &Control {
        &self.0
    }
}

impl ConfiguredControl for WordAddressControl {
    fn profile(&self) -> ControlProfile {
        self.table.profile()
    }

    fn rules(&self) -> &Rules {
        &self.parameters.rules
    }

    fn axes(&self) -> AxisMask {
        self.0.axes()
    }

    fn initial_work_offset(&self) -> WorkName {
        initial_work_offset(self)
    }

    fn initial_offsets(&self, machine: &Machine) -> Offsets {
        initial_offsets(self, machine)
    }

    fn open<'a>(
        &'a self,
        sources: &'a SourceMap<'a>,
        machine: &'a Machine,
        options: &'a RunOptions,
    ) -> Box<dyn ProgramSet + 'a> {
        Box::new(WordAddress::new(sources, machine, self, options))
    }

    fn program_names(&self, text: &[u8]) -> Vec<ProgramName> {
        let heads = find_programs(text, &self.table.lexicon);
        heads.iter().filter_map(|head| name_of(head, text)).collect()
    }

    fn called_programs(&self, text: &[u8]) -> Vec<ProgramName> {
        if self.parameters.calls_within_file {
            return Vec::new();
        }
        let lexicon = &self.table.lexicon;
        let numbers = referenced_programs(text, lexicon).into_iter().map(ProgramName::Number);
        let names = called_subs(text, lexicon).into_iter();
        numbers.chain(names.map(ProgramName::from)).collect()
    }

    /// Whether some block sets the units with G20, G21, G70 or G71.
    fn names_units(&self, text: &[u8]) -> bool {
        // The control is a guess where this matters, so the words are read as most controls read them.
        let mut reader = BlockReader::new(text, FileId(0), Lexicon::COMMON);
        let mut block = Block::new();
        while reader.read(&mut block) {
            let codes = block.all(b'G').filter_map(|word| word.number()?.to_integer());
            if codes.into_iter().any(|code| matches!(code, 20 | 21 | 70 | 71)) {
                return true;
            }
        }
        false
    }

    /// True of whole numbers on a control that counts least increments: most have a setting for that.
    fn leaves_whole_numbers_open(&self, text: &[u8]) -> bool {
        self.parameters.decimal_point == DecimalPoint::LeastIncrement
            && leaves_whole_numbers_open(text)
    }

    fn subprogram_extensions(&self) -> &'static [&'static str] {
        &["ngc", "nc"]
    }

    fn as_any(&self) -> &dyn Any {
        self
    }
}

/// The programs of some texts with the machine and its control.
pub struct WordAddress<'a> {
    sources: &'a SourceMap<'a>,
    library: Library<'a>,
    places: OnceCell<Vec<ProgramPlace>>,
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
        WordAddress { sources, library, places: OnceCell::new(), machine, control, options }
    }

    fn text(&self) -> &'a [u8] {
        self.sources.get(FileId(0)).map_or(&[], |source| source.text())
    }

    /// The programs of all texts as places.
    fn find_places(&self) -> Vec<ProgramPlace> {
        let lexicon = &self.control.table.lexicon;
        let mains = self.library.mains(lexicon, &self.control.alias_programs());
        let place = |(index, program): (usize, &crate::Program)| {
            let head = &program.head;
            ProgramPlace {
                file: program.file,
                name: name_of(head, self.library.text(program.file)),
                head: head.head,
                range: TextRange::new(head.start.offset, head.end),
                line: head.start.line,
                is_main: mains.binary_search(&index).is_ok(),
            }
        };
        self.library.programs().iter().enumerate().map(place).collect()
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

/// The name of a program by its head.
fn name_of(head: &ProgramHead, text: &[u8]) -> Option<ProgramName> {
    let number = head.number?;
    Some(match is_program_name(number) {
        true => ProgramName::Text { text: head.title(text)?.into(), key: Some(number) },
        false => ProgramName::Number(number),
    })
}

impl ProgramSet for WordAddress<'_> {
    fn programs(&self) -> &[ProgramPlace] {
        self.places.get_or_init(|| self.find_places())
    }

    fn find(&self, key: u32) -> Option<usize> {
        self.library.find(key, FileId(0))
    }

    fn needs_caller(&self, program: usize) -> bool {
        let program = self.library.programs().get(program).copied();
        program.is_some_and(|program| missing_call(&self.library, program, self.control).is_some())
    }

    fn head_problems(&self) -> Vec<Diagnostic> {
        self.library.duplicate_diagnostics().collect()
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
