//! All signs of all controls and languages, with their parsed patterns.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use chordal_dialect::ControlTable;
use chordal_dialect::not_read::{self, NotRead};
use chordal_dialect::recognition::{RecognitionEvidence, RecognitionSign, TextForm};
use chordal_machine::ControlName;

use super::line::bit;
use super::pattern::Pattern;

/// The control or language that a sign indicates.
#[derive(Clone, Copy, Debug)]
pub enum SignTarget {
    /// A control whose programs are read.
    Control(ControlName, &'static ControlTable),
    /// A language that is not read.
    NotRead(&'static NotRead),
}

/// A sign, prepared for the search.
#[derive(Debug)]
pub struct SignEntry {
    pub evidence: &'static RecognitionEvidence,
    pub kind: SignMatcher,
}

/// How a sign is searched for.
#[derive(Debug)]
pub enum SignMatcher {
    Block(Pattern),
    Share { of: Pattern, among: Pattern, percent: (u8, u8) },
    Letters { used: u32, unused: u32, least: u32 },
    Comment(&'static [&'static str]),
    Header(&'static [&'static str]),
    Code(&'static [&'static str]),
    Codes(&'static [&'static str]),
    Begins { pieces: &'static [&'static str], whole: bool },
    Form(TextForm),
}

impl SignMatcher {
    /// False for a sign that looks only at the codes and the letters of a line, and is not counted.
    pub fn depends_on_numbers(&self) -> bool {
        match self {
            SignMatcher::Block(pattern) => pattern.depends_on_numbers(),
            _ => true,
        }
    }
}

/// The signs of one language: a range of the entries; `own` is the index of the first that is not shared.
#[derive(Debug)]
pub struct LanguageSigns {
    pub language: SignTarget,
    pub first: usize,
    pub own: usize,
    pub end: usize,
}

/// All languages and their signs.
#[derive(Debug)]
pub struct Catalog {
    pub languages: Vec<LanguageSigns>,
    pub entries: Vec<SignEntry>,
    /// Signs at the start of a line, by its first byte in upper case: index of the sign, and the text.
    pub beginnings: BTreeMap<u8, Vec<(usize, &'static str)>>,
    /// The indices of the signs that only some lines can show, by what they look for.
    pub codes: Vec<usize>,
    pub pieces: Vec<usize>,
    pub forms: Vec<usize>,
    pub comments: Vec<usize>,
    /// The letters of the lines that `codes` look for.
    pub code_letters: u32,
}

/// The catalog, built once for all texts.
pub static CATALOG: LazyLock<Catalog> = LazyLock::new(Catalog::new);

impl Catalog {
    fn new() -> Catalog {
        let mut catalog = Catalog {
            languages: Vec::new(),
            entries: Vec::new(),
            beginnings: BTreeMap::new(),
            codes: Vec::new(),
            pieces: Vec::new(),
            forms: Vec::new(),
            comments: Vec::new(),
            code_letters: 0,
        };
        for name in ControlName::ALL.iter().copied() {
            let Some(table) = chordal_dialect::table(name) else { continue };
            let kind: &[RecognitionEvidence] = table.kind.map_or(&[], |kind| kind.signs);
            catalog.add(SignTarget::Control(name, table), kind, table.evidence);
        }
        for language in not_read::ALL.iter().copied() {
            catalog.add(SignTarget::NotRead(language), language.signs, language.own);
        }
        catalog.list_beginnings();
        catalog.list_kinds();
        catalog
    }

    fn list_beginnings(&mut self) {
        for (index, entry) in self.entries.iter().enumerate() {
            let SignMatcher::Begins { pieces, .. } = entry.kind else { continue };
            for piece in pieces {
                let first = piece.as_bytes().first().copied().unwrap_or(0);
                self.beginnings.entry(first).or_default().push((index, *piece));
            }
        }
    }

    fn list_kinds(&mut self) {
        for (index, entry) in self.entries.iter().enumerate() {
            match entry.kind {
                SignMatcher::Codes(lines) => {
                    self.codes.push(index);
                    let letters = lines.iter().flat_map(|line| line.bytes());
                    self.code_letters |= letters.fold(0, |all, letter| all | bit(letter));
                }
                SignMatcher::Code(_) => self.pieces.push(index),
                SignMatcher::Form(_) => self.forms.push(index),
                SignMatcher::Comment(_) | SignMatcher::Header(_) => self.comments.push(index),
                SignMatcher::Block(_)
                | SignMatcher::Share { .. }
                | SignMatcher::Letters { .. }
                | SignMatcher::Begins { .. } => {}
            }
        }
    }

    fn add(
        &mut self,
        language: SignTarget,
        signs: &'static [RecognitionEvidence],
        own: &'static [RecognitionEvidence],
    ) {
        let first = self.entries.len();
        self.entries.extend(signs.iter().map(SignEntry::new));
        let middle = self.entries.len();
        self.entries.extend(own.iter().map(SignEntry::new));
        self.languages.push(LanguageSigns {
            language,
            first,
            own: middle,
            end: self.entries.len(),
        });
    }
}

impl SignEntry {
    fn new(evidence: &'static RecognitionEvidence) -> SignEntry {
        let letters = |text: &str| text.bytes().fold(0, |all, letter| all | bit(letter));
        let kind = match evidence.sign {
            RecognitionSign::Block(pattern) => SignMatcher::Block(Pattern::new(pattern)),
            RecognitionSign::Share { of, among, percent } => {
                SignMatcher::Share { of: Pattern::new(of), among: Pattern::new(among), percent }
            }
            RecognitionSign::Letters { used, unused, least } => {
                SignMatcher::Letters { used: letters(used), unused: letters(unused), least }
            }
            RecognitionSign::Comment(names) => SignMatcher::Comment(names),
            RecognitionSign::Header(names) => SignMatcher::Header(names),
            RecognitionSign::Code(pieces) => SignMatcher::Code(pieces),
            RecognitionSign::Codes(lines) => SignMatcher::Codes(lines),
            RecognitionSign::Begins(pieces) => SignMatcher::Begins { pieces, whole: false },
            RecognitionSign::Line(pieces) => SignMatcher::Begins { pieces, whole: true },
            RecognitionSign::Form(form) => SignMatcher::Form(form),
        };
        SignEntry { evidence, kind }
    }
}
