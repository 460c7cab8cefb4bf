//! The programs that a run can reach.

use std::collections::HashMap;

use chordal_diagnostics::{Code, Diagnostic, FileId, SourceMap, Span};
use chordal_syntax::{Block, BlockReader, Lexicon, ProgramHead, find_programs, is_program_name};

/// A program of one of the texts.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Program {
    /// Its file.
    pub file: FileId,
    /// Its head and its range.
    pub head: ProgramHead,
}

/// All programs of a job by number. The first one with a number counts.
#[derive(Debug)]
pub struct Library<'a> {
    sources: &'a SourceMap<'a>,
    programs: Vec<Program>,
    by_number: HashMap<u32, usize>,
    duplicates: Vec<(usize, usize)>,
}

impl<'a> Library<'a> {
    /// Finds the programs of all texts.
    pub fn new(sources: &'a SourceMap<'a>, lexicon: &Lexicon) -> Library<'a> {
        let mut library = Library {
            sources,
            programs: Vec::new(),
            by_number: HashMap::new(),
            duplicates: vec![],
        };
        for (file, source) in sources.iter() {
            for head in find_programs(source.text(), lexicon) {
                let index = library.programs.len();
                library.programs.push(Program { file, head });
                if let Some(number) = head.number {
                    let first = *library.by_number.entry(number).or_insert(index);
                    if first != index && library.programs[first].file == file {
                        library.duplicates.push((first, index));
                    }
                }
            }
        }
        library
    }

    /// The texts.
    pub fn sources(&self) -> &'a SourceMap<'a> {
        self.sources
    }

    /// All programs in order.
    pub fn programs(&self) -> &[Program] {
        &self.programs
    }

    /// The text of a file.
    pub fn text(&self, file: FileId) -> &'a [u8] {
        let sources: &'a SourceMap<'a> = self.sources;
        sources.get(file).map_or(&[], |source| source.text())
    }

    /// The index of the program with a number; one in `near` (the caller's file) takes precedence. `None` without one.
    pub fn find(&self, number: u32, near: FileId) -> Option<usize> {
        let first = *self.by_number.get(&number)?;
        if self.programs[first].file == near {
            return Some(first);
        }
        let here = self
            .programs
            .iter()
            .position(|program| program.file == near && program.head.number == Some(number));
        here.or(Some(first))
    }

    /// The first program of each file, by the name of the file in lower case without folder and extension.
    pub(crate) fn files_by_name(&self) -> HashMap<String, usize> {
        let mut files = HashMap::new();
        for (index, program) in self.programs.iter().enumerate() {
            let file = self.sources.get(program.file).map_or("", |source| source.name());
            let file = file.rsplit(['/', '\\']).next().unwrap_or(file);
            let stem = file.rsplit_once('.').map_or(file, |(stem, _)| stem);
            files.entry(stem.to_ascii_lowercase()).or_insert(index);
        }
        files
    }

    /// The main programs of the first file: those that no other program of it calls; the first one when each is
    /// called or a call computes its number. `also_called` are programs called from elsewhere.
    pub fn mains(&self, lexicon: &Lexicon, also_called: &[u32]) -> Vec<usize> {
        let here: Vec<usize> =
            (0..self.programs.len()).filter(|i| self.programs[*i].file == FileId(0)).collect();
        if here.len() <= 1 {
            return here;
        }
        let mut called = called_programs(self.text(FileId(0)), lexicon);
        if called.contains(&COMPUTED) {
            return here[..1].to_vec();
        }
        called.extend(also_called);
        let mains: Vec<usize> = here
            .iter()
            .copied()
            .filter(|i| self.programs[*i].head.number.is_none_or(|n| !called.contains(&n)))
            .collect();
        if mains.is_empty() { here[..1].to_vec() } else { mains }
    }

    /// A reader of one program.
    pub(crate) fn reader(&self, program: Program, lexicon: Lexicon) -> BlockReader<'a> {
        let Program { file, head } = program;
        let mut reader = BlockReader::new(self.text(file), file, lexicon);
        reader.seek(head.start);
        reader.limit(head.end);
        reader
    }

    /// Reports program numbers that occur twice in one file.
    pub fn duplicate_diagnostics(&self) -> impl Iterator<Item = Diagnostic> + '_ {
        self.duplicates.iter().map(|(first, again)| {
            let span = |index: usize| -> Span {
                self.programs[index].head.head.in_file(self.programs[index].file)
            };
            let Program { file, head } = self.programs[*again];
            let name = head.title(self.text(file)).unwrap_or_default();
            Diagnostic::new(
                Code::DuplicateProgram,
                span(*again),
                format!("there are two programs {name}"),
            )
            .label("this one is never called")
            .also(span(*first), "the first one")
            .help("give one of them another number")
        })
    }
}

/// Marks a call with a computed number in the list of called programs.
const COMPUTED: u32 = u32::MAX;

/// Longer lines are not searched for calls.
const LONGEST_CALL_BYTES: usize = 4096;

/// The program numbers that a text calls with literals: `M98 P1000`, `G65 P9000`; with packed repeats (`P51000`)
/// both 51000 and 1000.
pub fn referenced_programs(text: &[u8], lexicon: &Lexicon) -> Vec<u32> {
    let mut numbers = called_programs(text, lexicon);
    numbers.retain(|number| *number != COMPUTED);
    numbers
}

fn called_programs(text: &[u8], lexicon: &Lexicon) -> Vec<u32> {
    let mut numbers = Vec::new();
    // The lines with a P or a name in brackets are few.
    let mut line_end = 0;
    for at in memchr::memchr3_iter(b'P', b'p', b'<', text) {
        if at < line_end {
            continue;
        }
        let start = memchr::memrchr2(b'\n', b'\r', &text[line_end..at]);
        let start = start.map_or(line_end, |back| line_end + back + 1);
        line_end = memchr::memchr2(b'\n', b'\r', &text[at..]).map_or(text.len(), |i| at + i);
        calls_of_line(&text[start..line_end], lexicon, &mut numbers);
    }
    if lexicon.macro_lines {
        for at in memchr::memmem::find_iter(text, b"START") {
            started_at(text, at, &mut numbers);
        }
    }
    numbers.sort_unstable();
    numbers.dedup();
    numbers
}

/// Adds the program of `START 9200` on a macro line.
fn started_at(text: &[u8], at: usize, numbers: &mut Vec<u32>) {
    // Macro lines are short.
    let before = &text[at.saturating_sub(100)..at];
    let line = memchr::memrchr2(b'\n', b'\r', before).map_or(0, |i| i + 1);
    if memchr::memchr(b'#', &before[line..]).is_none() {
        return;
    }
    let rest = text[at + 5..].iter().copied().skip_while(|b| matches!(b, b' ' | b'O'));
    let digits: Vec<u8> = rest.take_while(u8::is_ascii_digit).take(9).collect();
    let digits = std::str::from_utf8(&digits).unwrap_or("");
    let number: Option<u32> = digits.parse().ok();
    numbers.extend(number);
}

/// Adds the numbers after P in a macro statement.
fn called_in_statement(words: &[u8], numbers: &mut Vec<u32>) {
    for at in memchr::memchr2_iter(b'P', b'p', words) {
        let rest = words[at + 1..].trim_ascii_start();
        let digits = rest.iter().take_while(|byte| byte.is_ascii_digit()).count();
        let number =
            std::str::from_utf8(&rest[..digits]).ok().and_then(|text| text.parse::<u32>().ok());
        numbers.extend(number);
    }
}

/// The codes that call a program by its P word. The outline of G150 may be a program.
const CALLS: [(u8, &[u8]); 4] = [(b'M', b"98"), (b'G', b"65"), (b'G', b"66"), (b'G', b"150")];

/// Adds the P words of a line that has a code of a call.
fn calls_of_line(line: &[u8], lexicon: &Lexicon, numbers: &mut Vec<u32>) {
    let has_call = CALLS.iter().any(|(letter, code)| {
        memchr::memmem::find_iter(line, code).any(|at| {
            let before = line[..at].iter().rev().find(|byte| !matches!(byte, b' ' | b'0'));
            before.is_some_and(|byte| byte.to_ascii_uppercase() == *letter)
        })
    });
    if !has_call || line.len() > LONGEST_CALL_BYTES {
        return;
    }
    let mut reader = BlockReader::new(line, FileId(0), *lexicon);
    let mut block = Block::new();
    while reader.read(&mut block) {
        // `IF[#1EQ2]THEN M98 P1000`: the call stands inside a macro statement.
        if let chordal_syntax::BlockKind::Macro(range) = block.kind {
            called_in_statement(range.slice(line), numbers);
        }
        for word in block.all(b'P') {
            if matches!(word.value, chordal_syntax::WordValue::Expression(_)) {
                numbers.push(COMPUTED);
            }
            let number = word.number().and_then(|d| d.to_integer());
            if let Some(number) = number.and_then(|n| u32::try_from(n).ok()) {
                numbers.push(number);
                if number > 9999 && !is_program_name(number) {
                    numbers.push(number % 10_000);
                }
            }
        }
    }
}
