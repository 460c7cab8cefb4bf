//! Recognizes the control that a program was written for, by weighted signs in the text.
//!
//! Every sign counts once, however often it occurs. The signs are defined in the folders of the controls and in
//! [`chordal_dialect::not_read`]; here they are searched for and weighed.

mod catalog;
mod forms;
mod line;
mod pattern;
mod sample;
mod style;
mod tally;

use chordal_dialect::not_read::NotRead;
use chordal_dialect::recognition::{
    ASSUMED_CONTROL, MIN_LEAD, MIN_LIKELY_WEIGHT, RecognitionEvidence,
};
use chordal_machine::ControlName;

use catalog::{CATALOG, LanguageSigns, SignTarget};
use line::SampleLine;
use tally::TextTally;

/// A sign that was found.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct FoundSign {
    /// The sign in words: `G154 chooses an extended work offset`.
    pub sign: &'static str,
    /// The first line that shows it.
    pub line: u32,
    /// Offset of that line.
    pub offset: u32,
    /// Its weight; negative when it is evidence against.
    pub weight: i32,
    /// The built-in machine of programs with this sign; `None` for the usual one of the control.
    pub machine: Option<&'static str>,
}

impl ControlCandidate {
    /// The built-in machine named by its signs; `None` for the usual one of the control.
    pub fn machine(&self) -> Option<&'static str> {
        self.signs.iter().find_map(|sign| sign.machine)
    }
}

/// A control or a language with its evidence.
#[derive(Clone, PartialEq, Debug)]
pub struct ControlCandidate {
    /// Its name: that of a control, or `fanuc-lathe`, `heidenhain`.
    pub name: &'static str,
    /// Its name in messages.
    pub title: &'static str,
    /// The control that reads the program, or that shows its text.
    pub control: ControlName,
    /// It is a language that is not read.
    pub not_read: bool,
    /// The sum of the weights of its signs.
    pub weight: i32,
    /// Its signs, the strongest first.
    pub signs: Vec<FoundSign>,
    /// Number of errors of a run on this control; `None` when it was not tried.
    pub errors: Option<u64>,
}

/// How certain the recognition is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum EvidenceStrength {
    /// A name or forms that no other control has, and no other candidate is near.
    Sure,
    /// It leads clearly.
    Likely,
    /// It leads by little, or because the others have errors.
    Weak,
    /// There is no evidence: the usual default.
    Assumed,
}

impl EvidenceStrength {
    /// As a word.
    pub fn as_str(self) -> &'static str {
        match self {
            EvidenceStrength::Sure => "sure",
            EvidenceStrength::Likely => "likely",
            EvidenceStrength::Weak => "weak",
            EvidenceStrength::Assumed => "assumed",
        }
    }
}

/// The result of a recognition.
#[derive(Clone, PartialEq, Debug)]
pub struct Recognition {
    /// All candidates, the chosen one first. Controls that are read are always included.
    pub ranking: Vec<ControlCandidate>,
}

/// The weight of a control for another kind of machine (mill or lathe) than the program's.
pub const ANOTHER_KIND: i32 = -1000;

/// With at least this weight and lead the recognition is certain.
const SURE_WEIGHT: i32 = 6;

impl Recognition {
    /// The chosen candidate.
    pub fn chosen(&self) -> &ControlCandidate {
        &self.ranking[0]
    }

    /// The control that reads the program, or shows its text.
    pub fn control(&self) -> ControlName {
        self.chosen().control
    }

    /// The second candidate, if it has evidence or was tried by a run; `None` otherwise.
    pub fn runner_up(&self) -> Option<&ControlCandidate> {
        let speaks = |other: &&ControlCandidate| other.weight > 0 || other.errors.is_some();
        self.ranking.get(1).filter(speaks)
    }

    /// The evidence for the chosen one, the strongest first; empty when it is assumed.
    pub fn evidence(&self) -> impl Iterator<Item = &FoundSign> {
        let assumed = self.strength() == EvidenceStrength::Assumed;
        self.chosen().signs.iter().filter(move |sign| !assumed && sign.weight > 0)
    }

    /// How certain the recognition is.
    pub fn strength(&self) -> EvidenceStrength {
        let chosen = self.chosen();
        match chosen.weight {
            weight if weight >= SURE_WEIGHT && self.lead() >= SURE_WEIGHT => EvidenceStrength::Sure,
            _ if chosen.not_read => EvidenceStrength::Likely,
            weight if weight >= MIN_LIKELY_WEIGHT && self.lead() >= MIN_LEAD => {
                EvidenceStrength::Likely
            }
            weight if weight >= MIN_LIKELY_WEIGHT => EvidenceStrength::Weak,
            _ => EvidenceStrength::Assumed,
        }
    }

    /// True when a name or a form that no other control has is evidence for it, and no other is near. Several weak
    /// signs of writing style are not enough: they indicate the author more than the control.
    pub fn is_certain(&self) -> bool {
        let strongest = self.chosen().signs.first();
        self.strength() == EvidenceStrength::Sure
            && strongest.is_some_and(|sign| sign.weight >= SURE_WEIGHT)
    }

    /// True when the signs decide; otherwise test runs may.
    pub fn is_decided(&self) -> bool {
        self.chosen().not_read
            || matches!(self.strength(), EvidenceStrength::Sure | EvidenceStrength::Likely)
    }

    /// The weight by which the chosen one leads.
    pub fn lead(&self) -> i32 {
        let next = self.ranking.iter().skip(1).map(|other| other.weight).max().unwrap_or(0);
        self.chosen().weight - next.max(0)
    }

    /// Moves the candidate with a name to the first position.
    pub fn choose(&mut self, name: &str) {
        if let Some(place) = self.ranking.iter().position(|each| each.name == name) {
            let chosen = self.ranking.remove(place);
            self.ranking.insert(0, chosen);
        }
    }
}

/// Searches for the signs of all controls and weighs them.
pub fn recognize(text: &[u8]) -> Recognition {
    let tally = tally(text);
    let mut lines = LineNumbers::new(text);
    let mut ranking: Vec<ControlCandidate> = CATALOG
        .languages
        .iter()
        .filter_map(|listed| candidate(listed, &tally, &mut lines))
        .collect();
    // The sort is stable for equal weights. Among these a lathe control that is read comes first, then the assumed
    // control.
    ranking.sort_by_key(|each| {
        let is_read_lathe = !each.not_read && chordal_dialect::table(each.control).turns();
        (-each.weight, !is_read_lathe, !each.not_read, each.control != ASSUMED_CONTROL)
    });
    let mut recognition = Recognition { ranking };
    if recognition.strength() == EvidenceStrength::Assumed {
        recognition.choose(ASSUMED_CONTROL.as_str());
    }
    recognition
}

fn tally(text: &[u8]) -> TextTally {
    let mut tally = TextTally::new();
    let mut line = SampleLine::default();
    for part in sample::parts(text) {
        let mut at = part.start;
        while at < part.end {
            let rest = &text[at..part.end];
            let end = memchr::memchr2(b'\n', b'\r', rest).unwrap_or(rest.len());
            // The rest of a very long line is not a sign.
            let words = &rest[..end.min(MAX_LINE_BYTES)];
            line.read(words);
            tally.line(words, &line, at);
            at += end + 1;
        }
    }
    tally
}

/// The examined part of a line, bytes.
const MAX_LINE_BYTES: usize = 512;

/// The candidate of a language; `None` for a language that is not read with too little evidence.
fn candidate(
    listed: &LanguageSigns,
    tally: &TextTally,
    lines: &mut LineNumbers,
) -> Option<ControlCandidate> {
    let of = |range: std::ops::Range<usize>| found(range, tally);
    let mut signs = of(listed.first..listed.own);
    let (name, title, control, not_read) = match listed.language {
        SignTarget::Control(name) => {
            (name.as_str(), chordal_dialect::table(name).title, name, None)
        }
        SignTarget::NotRead(language) => {
            (language.name, language.what, language.shown_on, Some(language))
        }
    };
    let kind = not_read.is_none().then(|| chordal_dialect::table(control).kind).flatten();
    let needed = not_read.map(|language| language.needed).or(kind.map(|kind| kind.needed));
    let of_kind = needed.is_none_or(|needed| weight(&signs) >= needed);
    if not_read.is_some() && !of_kind {
        return None;
    }
    signs.extend(of(listed.own..listed.end));
    // Signs that distinguish controls of one kind mean nothing in a program for another kind.
    let weight = if of_kind { weight(&signs) } else { ANOTHER_KIND };
    let mut signs: Vec<FoundSign> = signs
        .into_iter()
        .map(|(evidence, at)| FoundSign {
            sign: evidence.reason,
            line: lines.line_of(at),
            offset: at as u32,
            weight: evidence.weight,
            machine: evidence.machine,
        })
        .collect();
    signs.sort_by_key(|sign| (-sign.weight, sign.offset));
    Some(ControlCandidate {
        name,
        title,
        control,
        not_read: not_read.is_some(),
        weight,
        signs,
        errors: None,
    })
}

/// The signs found and their offsets; of several with the same text only the strongest.
fn found(
    range: std::ops::Range<usize>,
    tally: &TextTally,
) -> Vec<(&'static RecognitionEvidence, usize)> {
    let mut found: Vec<(&'static RecognitionEvidence, usize)> = Vec::new();
    for index in range {
        let evidence = CATALOG.entries[index].evidence;
        let Some(at) = tally.found(index) else { continue };
        match found.iter_mut().find(|(other, _)| other.reason == evidence.reason) {
            Some(same) if same.0.weight < evidence.weight => *same = (evidence, at),
            Some(_) => {}
            None => found.push((evidence, at)),
        }
    }
    found
}

fn weight(signs: &[(&'static RecognitionEvidence, usize)]) -> i32 {
    signs.iter().map(|(evidence, _)| evidence.weight).sum()
}

/// Finds line numbers of offsets; known ones are cached.
struct LineNumbers<'a> {
    text: &'a [u8],
    end: u8,
    known: std::collections::BTreeMap<usize, u32>,
}

impl<'a> LineNumbers<'a> {
    fn new(text: &'a [u8]) -> LineNumbers<'a> {
        let head = &text[..text.len().min(1 << 16)];
        let end = if memchr::memchr(b'\n', head).is_some() { b'\n' } else { b'\r' };
        LineNumbers { text, end, known: std::iter::once((0, 1)).collect() }
    }

    /// The line of an offset, counted from the nearest known one before it.
    fn line_of(&mut self, at: usize) -> u32 {
        let (from, line) =
            self.known.range(..=at).next_back().map_or((0, 1), |(from, line)| (*from, *line));
        let ends = self.text[from..at].iter().filter(|byte| **byte == self.end).count();
        let line = line + ends as u32;
        self.known.insert(at, line);
        line
    }
}

/// The language with a name that is not read; `None` for other names.
pub fn not_read(name: &str) -> Option<&'static NotRead> {
    chordal_dialect::not_read::ALL.iter().copied().find(|language| language.name == name)
}
