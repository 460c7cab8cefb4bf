//! Counts the signs in the lines of a text.

use std::collections::HashMap;
use std::collections::hash_map::Entry;

use chordal_dialect::recognition::{MACHINE_WORDS, OTHER_MACHINE_WORDS, TextForm};

use super::catalog::{CATALOG, SignMatcher};
use super::forms;
use super::line::{SampleLine, bit};
use super::pattern::is_code;
use super::style::TextStyle;

/// Smallest number of lines for a share; a share of fewer is not significant.
const MIN_OF_A_SHARE: u32 = 3;

/// Lines with more words are not compared with [`SignMatcher::Codes`], which are short.
const WHOLE_LINE_WORDS: usize = 8;

/// The count of one sign.
#[derive(Clone, Copy, Debug, Default)]
pub struct SignTally {
    /// The offset of its first occurrence; `None` before one.
    pub at: Option<usize>,
    /// Number of lines that match, and of lines that count, for a share.
    of: u32,
    among: u32,
}

/// The counts of all signs.
#[derive(Debug)]
pub struct TextTally {
    seen: Vec<SignTally>,
    /// Number of lines with each letter, and the offset of the first.
    letters: [(u32, usize); 26],
    open: (u32, u32),
    /// The word signs that lines of a kind may still match after the first of them.
    possible: HashMap<LineKind, Vec<usize>>,
    /// No line so far has `%`, a program number, a tool change or a length offset.
    bare: bool,
    style: TextStyle,
    upper: Vec<u8>,
}

/// What signs that look at codes and letters only see of a line.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
struct LineKind {
    letters: u32,
    /// The letters after a comma.
    comma_letters: u32,
    /// A hash of the G and M codes in their order.
    codes: u64,
}

impl LineKind {
    fn of(line: &SampleLine) -> LineKind {
        let mut kind = LineKind { letters: line.letters, comma_letters: 0, codes: 0 };
        for word in &line.words {
            if word.comma {
                kind.comma_letters |= bit(word.letter);
            } else if is_code(word.letter) {
                let code = word.value.to_bits() ^ u64::from(word.letter);
                kind.codes = (kind.codes.rotate_left(7) ^ code).wrapping_mul(CODE_HASH_FACTOR);
            }
        }
        kind
    }
}

/// An odd number with well-mixed bits.
const CODE_HASH_FACTOR: u64 = 0x9E37_79B9_7F4A_7C15;

/// Compares a line with some word signs.
fn compare(signs: &[usize], seen: &mut [SignTally], line: &SampleLine, at: usize) {
    for index in signs.iter().copied() {
        let seen = &mut seen[index];
        match &CATALOG.entries[index].kind {
            SignMatcher::Block(pattern) if seen.at.is_none() && pattern.fits(line) => {
                seen.at = Some(at);
            }
            SignMatcher::Share { of, among, .. } if among.fits(line) => {
                seen.among += 1;
                if of.fits(line) {
                    seen.of += 1;
                    seen.at.get_or_insert(at);
                }
            }
            _ => {}
        }
    }
}

/// True when a comment contains one of the names.
fn is_about(comment: &[u8], words: &[&str]) -> bool {
    words.iter().any(|word| names(comment, word))
}

impl TextTally {
    pub fn new() -> TextTally {
        TextTally {
            seen: vec![SignTally::default(); CATALOG.entries.len()],
            letters: [(0, 0); 26],
            open: (0, 0),
            possible: HashMap::new(),
            bare: true,
            style: TextStyle::default(),
            upper: Vec::new(),
        }
    }

    /// Adds a line at an offset of the text.
    pub fn line(&mut self, text: &[u8], line: &SampleLine, at: usize) {
        if !line.words.is_empty() {
            self.words(line, at);
        }
        if line.odd || line.open || line.semicolon {
            self.odd(text, line, at);
        } else if line.letters & (bit(b'R') | bit(b'L')) != 0
            || line.closed
            || line.letters == bit(b'Z')
        {
            self.forms(text, line, at);
        }
        self.beginning(text, at);
        for (from, to) in &line.comments {
            self.comment(&text[*from..*to], at);
        }
        self.open.0 += u32::from(line.open);
        self.open.1 += u32::from(line.closed);
        self.bare &= !shows_a_memory(text, line);
        self.style.record_line(text, line, at);
        self.whole_line(line, at);
    }

    fn words(&mut self, line: &SampleLine, at: usize) {
        let mut left = line.letters;
        while left != 0 {
            let entry = &mut self.letters[left.trailing_zeros() as usize];
            if entry.0 == 0 {
                entry.1 = at;
            }
            entry.0 += 1;
            left &= left - 1;
        }
        // The first line of a kind decides for the others about all signs that look at codes and letters only.
        match self.possible.entry(LineKind::of(line)) {
            Entry::Occupied(known) => compare(known.get(), &mut self.seen, line, at),
            Entry::Vacant(new) => {
                let mut possible = possible(line.letters);
                compare(&possible, &mut self.seen, line, at);
                possible.retain(|index| CATALOG.entries[*index].kind.depends_on_numbers());
                new.insert(possible);
            }
        }
    }

    /// Counts a line that consists of certain codes only.
    fn whole_line(&mut self, line: &SampleLine, at: usize) {
        // The codes of these signs are short.
        if line.words.is_empty() || line.words.len() > WHOLE_LINE_WORDS || line.odd {
            return;
        }
        if line.letters & !(CATALOG.code_letters | bit(b'N')) != 0 {
            return;
        }
        let words = line.words.iter().filter(|word| word.letter != b'N');
        let mut code = String::new();
        for word in words {
            code.push(char::from(word.letter));
            code.push_str(&word.value.to_string());
        }
        for index in CATALOG.codes.iter().copied() {
            let seen = &mut self.seen[index];
            if let SignMatcher::Codes(lines) = CATALOG.entries[index].kind
                && seen.at.is_none()
                && lines.contains(&code.as_str())
            {
                seen.at = Some(at);
            }
        }
    }

    /// Counts a line with names, brackets or similar.
    fn odd(&mut self, text: &[u8], line: &SampleLine, at: usize) {
        self.upper.clear();
        self.upper.extend(text[..line.code_end].iter().map(u8::to_ascii_uppercase));
        for index in CATALOG.pieces.iter().copied() {
            let seen = &mut self.seen[index];
            if let SignMatcher::Code(pieces) = CATALOG.entries[index].kind
                && seen.at.is_none()
                && pieces
                    .iter()
                    .any(|piece| memchr::memmem::find(&self.upper, piece.as_bytes()).is_some())
            {
                seen.at = Some(at);
            }
        }
        self.forms(text, line, at);
    }

    /// Counts the start of a line.
    fn beginning(&mut self, text: &[u8], at: usize) {
        let text = text.trim_ascii();
        let Some(first) = text.first() else { return };
        let Some(listed) = CATALOG.beginnings.get(&first.to_ascii_uppercase()) else { return };
        for (index, piece) in listed {
            let seen = &mut self.seen[*index];
            let whole =
                matches!(CATALOG.entries[*index].kind, SignMatcher::Begins { whole: true, .. });
            if seen.at.is_none() && forms::begins(text, piece, whole) {
                seen.at = Some(at);
            }
        }
    }

    fn forms(&mut self, text: &[u8], line: &SampleLine, at: usize) {
        for index in CATALOG.forms.iter().copied() {
            let seen = &mut self.seen[index];
            if let SignMatcher::Form(form) = CATALOG.entries[index].kind
                && seen.at.is_none()
                && forms::shows(form, text, line)
            {
                seen.at = Some(at);
            }
        }
    }

    fn comment(&mut self, comment: &[u8], at: usize) {
        self.upper.clear();
        self.upper.extend(comment.iter().map(u8::to_ascii_uppercase));
        let comment = std::mem::take(&mut self.upper);
        let other = is_about(&comment, OTHER_MACHINE_WORDS);
        let machine = !other && is_about(&comment, MACHINE_WORDS);
        for index in CATALOG.comments.iter().copied() {
            let seen = &mut self.seen[index];
            let target = match CATALOG.entries[index].kind {
                _ if seen.at.is_some() => continue,
                SignMatcher::Comment(words) if !other => words,
                SignMatcher::Header(words) if machine => words,
                _ => continue,
            };
            if is_about(&comment, target) {
                seen.at = Some(at);
            }
        }
        self.upper = comment;
    }

    /// The offset of the first occurrence of a sign; `None` when it was not found.
    pub fn found(&self, index: usize) -> Option<usize> {
        let seen = self.seen[index];
        match &CATALOG.entries[index].kind {
            SignMatcher::Share { percent: (from, to), .. } => {
                let share = seen.of * 100;
                let inside =
                    share >= seen.among * u32::from(*from) && share <= seen.among * u32::from(*to);
                (seen.among >= MIN_OF_A_SHARE && inside).then_some(seen.at.unwrap_or(0))
            }
            SignMatcher::Letters { used, unused, least } => self.letters(*used, *unused, *least),
            SignMatcher::Form(TextForm::OpenComments) => {
                seen.at.filter(|_| self.open.0 > self.open.1)
            }
            SignMatcher::Form(TextForm::BareText) => self.bare.then_some(0),
            SignMatcher::Form(TextForm::MixedNumbers) => self.style.mixed_numbers(),
            SignMatcher::Form(TextForm::TrailingPoints) => self.style.trailing_points(),
            SignMatcher::Form(TextForm::SmallControl) => self.style.small_control_evidence(),
            SignMatcher::Form(TextForm::LengthWithoutTape) => self.style.length_without_tape(),
            SignMatcher::Block(_)
            | SignMatcher::Comment(_)
            | SignMatcher::Header(_)
            | SignMatcher::Code(_)
            | SignMatcher::Codes(_)
            | SignMatcher::Begins { .. }
            | SignMatcher::Form(_) => seen.at,
        }
    }

    fn letters(&self, used: u32, unused: u32, least: u32) -> Option<usize> {
        let of = |letters: u32| (0..26).filter(move |index| letters & (1 << index) != 0);
        let enough = of(used).all(|index| self.letters[index].0 >= least);
        let none = of(unused).all(|index| self.letters[index].0 == 0);
        let first = of(used).map(|index| self.letters[index].1).min();
        first.filter(|_| enough && none)
    }
}

/// The indices of the word signs that a line with these letters may match.
fn possible(letters: u32) -> Vec<usize> {
    let may = |(index, entry): (usize, &super::catalog::SignEntry)| match &entry.kind {
        SignMatcher::Block(pattern) | SignMatcher::Share { among: pattern, .. } => {
            pattern.may_fit(letters).then_some(index)
        }
        _ => None,
    };
    CATALOG.entries.iter().enumerate().filter_map(may).collect()
}

/// True for what simple controls without a program memory do not read: `%`, a program number, a tool change, a length
/// offset.
fn shows_a_memory(text: &[u8], line: &SampleLine) -> bool {
    line.letters & (bit(b'O') | bit(b'H') | bit(b'T')) != 0
        || text.trim_ascii_start().first() == Some(&b'%')
        || line.words.iter().any(|word| word.letter == b'G' && word.value == 43.0)
}

/// True when the comment contains the name as a whole word.
fn names(comment: &[u8], name: &str) -> bool {
    memchr::memmem::find_iter(comment, name.as_bytes()).any(|at| {
        let before = comment[..at].last().is_none_or(|byte| !byte.is_ascii_alphanumeric());
        let after = comment.get(at + name.len());
        let open = name.ends_with(|last: char| !last.is_ascii_alphanumeric());
        before && (open || after.is_none_or(|byte| !byte.is_ascii_alphanumeric()))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_whole_words() {
        assert!(names(b"VENDOR: HAAS AUTOMATION", "HAAS") && names(b"LINUXCNC_POST", "LINUXCNC"));
        assert!(!names(b"HAASTE", "HAAS") && names(b"$PATH=/_N_WKS", "$PATH=/"));
    }
}
