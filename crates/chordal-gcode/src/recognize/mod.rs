//! Which control a program was written for: signs with weights over the whole text.
//!
//! Every sign counts once, however often it stands there. What the signs are stands in the folders of the
//! controls and in [`chordal_dialect::not_read`]; here they are looked for and weighed.

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
    /// For people: `G154 chooses an extended work offset`.
    pub sign: &'static str,
    /// The first line that shows it.
    pub line: u32,
    /// Offset of that line.
    pub offset: u32,
    /// How much it says; below zero it speaks against.
    pub weight: i32,
    /// The built-in machine that programs with this sign are for, where it is not the usual one.
    pub machine: Option<&'static str>,
}

impl ControlCandidate {
    /// The built-in machine that its signs name, where it is not the usual one of the control.
    pub fn machine(&self) -> Option<&'static str> {
        self.signs.iter().find_map(|sign| sign.machine)
    }
}

/// A control or a language, and what speaks for it.
#[derive(Clone, PartialEq, Debug)]
pub struct ControlCandidate {
    /// Its name: that of a control, or `fanuc-lathe`, `heidenhain`.
    pub name: &'static str,
    /// Its name for people.
    pub title: &'static str,
    /// The control that reads it, or that shows its text.
    pub control: ControlName,
    /// It is not read.
    pub not_read: bool,
    /// All its signs together.
    pub weight: i32,
    /// Its signs, the strongest first.
    pub signs: Vec<FoundSign>,
    /// Errors of a run on it, where it was tried.
    pub errors: Option<u64>,
}

/// How much the signs say.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum EvidenceStrength {
    /// A name or forms that nobody else has, and nothing near.
    Sure,
    /// It leads clearly.
    Likely,
    /// It leads by little, or by the errors of the others.
    Weak,
    /// Nothing speaks: the common default.
    Assumed,
}

impl EvidenceStrength {
    /// In a word.
    pub fn as_str(self) -> &'static str {
        match self {
            EvidenceStrength::Sure => "sure",
            EvidenceStrength::Likely => "likely",
            EvidenceStrength::Weak => "weak",
            EvidenceStrength::Assumed => "assumed",
        }
    }
}

/// What a text was recognized as.
#[derive(Clone, PartialEq, Debug)]
pub struct Recognition {
    /// All candidates, the first chosen. Those that are read are always there.
    pub ranking: Vec<ControlCandidate>,
}

/// The weight of a control whose machines are of another kind than the program is for.
pub const ANOTHER_KIND: i32 = -1000;

/// From this weight and lead on there is no doubt.
const SURE_WEIGHT: i32 = 6;

impl Recognition {
    /// What was chosen.
    pub fn chosen(&self) -> &ControlCandidate {
        &self.ranking[0]
    }

    /// The control that reads the text, or shows it.
    pub fn control(&self) -> ControlName {
        self.chosen().control
    }

    /// What comes next: by its signs, or by a run with no more errors than the chosen one.
    pub fn runner_up(&self) -> Option<&ControlCandidate> {
        let speaks = |other: &&ControlCandidate| other.weight > 0 || other.errors.is_some();
        self.ranking.get(1).filter(speaks)
    }

    /// What speaks for it, the strongest first; empty where nothing does.
    pub fn evidence(&self) -> impl Iterator<Item = &FoundSign> {
        let assumed = self.strength() == EvidenceStrength::Assumed;
        self.chosen().signs.iter().filter(move |sign| !assumed && sign.weight > 0)
    }

    /// How much the signs say.
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

    /// A name, or a form that nobody else has, speaks for it, and nothing near. How a text is written says much of who
    /// wrote it, and not for certain which control it is for.
    pub fn is_certain(&self) -> bool {
        let strongest = self.chosen().signs.first();
        self.strength() == EvidenceStrength::Sure
            && strongest.is_some_and(|sign| sign.weight >= SURE_WEIGHT)
    }

    /// The signs decide; otherwise runs may.
    pub fn is_decided(&self) -> bool {
        self.chosen().not_read
            || matches!(self.strength(), EvidenceStrength::Sure | EvidenceStrength::Likely)
    }

    /// By how much the first leads.
    pub fn lead(&self) -> i32 {
        let next = self.ranking.iter().skip(1).map(|other| other.weight).max().unwrap_or(0);
        self.chosen().weight - next.max(0)
    }

    /// Puts the chosen one first, by its name.
    pub fn choose(&mut self, name: &str) {
        if let Some(place) = self.ranking.iter().position(|each| each.name == name) {
            let chosen = self.ranking.remove(place);
            self.ranking.insert(0, chosen);
        }
    }
}

/// Looks for the signs of all controls and weighs them.
pub fn recognize(text: &[u8]) -> Recognition {
    let tally = tally(text);
    let mut lines = LineNumbers::new(text);
    let mut ranking: Vec<ControlCandidate> = CATALOG
        .languages
        .iter()
        .filter_map(|listed| candidate(listed, &tally, &mut lines))
        .collect();
    // The sort keeps the order of those that weigh alike; the assumed one comes first then. Of the lathes
    // one that is read does.
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
            // What comes after so much of a line is no sign.
            let words = &rest[..end.min(MAX_LINE_BYTES)];
            line.read(words);
            tally.line(words, &line, at);
            at += end + 1;
        }
    }
    tally
}

/// So much of a line is looked at, bytes.
const MAX_LINE_BYTES: usize = 512;

/// What speaks for a language; nothing where it is one that is not read, and too little speaks for it.
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
    // What tells controls of a kind apart says nothing of a program that is for another kind.
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

/// Signs that were found and where. Of those with the same words the strongest.
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

/// Numbers of lines by offset; places near the beginning are counted quickly.
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

    /// From the nearest place before that was counted already.
    fn line_of(&mut self, at: usize) -> u32 {
        let (from, line) =
            self.known.range(..=at).next_back().map_or((0, 1), |(from, line)| (*from, *line));
        let ends = self.text[from..at].iter().filter(|byte| **byte == self.end).count();
        let line = line + ends as u32;
        self.known.insert(at, line);
        line
    }
}

/// The language of a name, where it is one that is not read.
pub fn not_read(name: &str) -> Option<&'static NotRead> {
    chordal_dialect::not_read::ALL.iter().copied().find(|language| language.name == name)
}
