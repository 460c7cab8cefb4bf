//! All signs of all controls and languages, their patterns read once.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use chordal_dialect::not_read::{self, NotRead};
use chordal_dialect::recognition::{Evidence, Form, Sign};
use chordal_machine::ControlName;

use super::line::bit;
use super::pattern::Pattern;

/// Whom a sign speaks for.
#[derive(Clone, Copy, Debug)]
pub enum Language {
    /// A control whose programs are read.
    Control(ControlName),
    /// A language that is not.
    NotRead(&'static NotRead),
}

/// A sign ready to be looked for.
#[derive(Debug)]
pub struct Entry {
    pub evidence: &'static Evidence,
    pub kind: Kind,
}

/// How it is looked for.
#[derive(Debug)]
pub enum Kind {
    Block(Pattern),
    Share { of: Pattern, among: Pattern, percent: (u8, u8) },
    Letters { used: u32, unused: u32, least: u32 },
    Comment(&'static [&'static str]),
    Header(&'static [&'static str]),
    Code(&'static [&'static str]),
    Codes(&'static [&'static str]),
    Begins { pieces: &'static [&'static str], whole: bool },
    Form(Form),
}

/// The signs of one language: a range of the entries, and where those begin that are only its own.
#[derive(Debug)]
pub struct Listed {
    pub language: Language,
    pub first: usize,
    pub own: usize,
    pub end: usize,
}

/// All languages and their signs.
#[derive(Debug)]
pub struct Catalog {
    pub languages: Vec<Listed>,
    pub entries: Vec<Entry>,
    /// By the first byte of a line in capitals: signs of beginnings that it may show, and their piece.
    pub beginnings: BTreeMap<u8, Vec<(usize, &'static str)>>,
}

/// Read once for all texts.
pub static CATALOG: LazyLock<Catalog> = LazyLock::new(Catalog::new);

impl Catalog {
    fn new() -> Catalog {
        let mut catalog =
            Catalog { languages: Vec::new(), entries: Vec::new(), beginnings: BTreeMap::new() };
        for name in ControlName::ALL.iter().copied() {
            let table = chordal_dialect::table(name);
            let kind: &[Evidence] = table.kind.map_or(&[], |kind| kind.signs);
            catalog.add(Language::Control(name), kind, table.evidence);
        }
        for language in not_read::ALL.iter().copied() {
            catalog.add(Language::NotRead(language), language.signs, language.own);
        }
        catalog.list_beginnings();
        catalog
    }

    fn list_beginnings(&mut self) {
        for (index, entry) in self.entries.iter().enumerate() {
            let Kind::Begins { pieces, .. } = entry.kind else { continue };
            for piece in pieces {
                let first = piece.as_bytes().first().copied().unwrap_or(0);
                self.beginnings.entry(first).or_default().push((index, *piece));
            }
        }
    }

    fn add(&mut self, language: Language, signs: &'static [Evidence], own: &'static [Evidence]) {
        let first = self.entries.len();
        self.entries.extend(signs.iter().map(Entry::new));
        let middle = self.entries.len();
        self.entries.extend(own.iter().map(Entry::new));
        self.languages.push(Listed { language, first, own: middle, end: self.entries.len() });
    }
}

impl Entry {
    fn new(evidence: &'static Evidence) -> Entry {
        let letters = |text: &str| text.bytes().fold(0, |all, letter| all | bit(letter));
        let kind = match evidence.sign {
            Sign::Block(pattern) => Kind::Block(Pattern::new(pattern)),
            Sign::Share { of, among, percent } => {
                Kind::Share { of: Pattern::new(of), among: Pattern::new(among), percent }
            }
            Sign::Letters { used, unused, least } => {
                Kind::Letters { used: letters(used), unused: letters(unused), least }
            }
            Sign::Comment(names) => Kind::Comment(names),
            Sign::Header(names) => Kind::Header(names),
            Sign::Code(pieces) => Kind::Code(pieces),
            Sign::Codes(lines) => Kind::Codes(lines),
            Sign::Begins(pieces) => Kind::Begins { pieces, whole: false },
            Sign::Line(pieces) => Kind::Begins { pieces, whole: true },
            Sign::Form(form) => Kind::Form(form),
        };
        Entry { evidence, kind }
    }
}
