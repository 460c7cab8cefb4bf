//! Patterns of words: `G28|G30 U|W !Y`. `RecognitionSign::Block` describes their syntax.

use super::line::{SampleLine, SampleWord, bit};

/// A parsed pattern.
#[derive(Debug)]
pub struct Pattern {
    /// The letters that the line must all contain.
    all: u32,
    terms: Vec<PatternTerm>,
}

#[derive(Debug)]
struct PatternTerm {
    negated: bool,
    /// The letters of its alternatives.
    letters: u32,
    alternatives: Vec<PatternAlternative>,
}

#[derive(Debug)]
struct PatternAlternative {
    letter: u8,
    comma: bool,
    test: NumberTest,
}

/// The condition of a number.
#[derive(Debug)]
enum NumberTest {
    Any,
    Between(f64, f64),
    Below(f64),
    Above(f64),
    WithoutPoint,
    WithDecimals,
    Digits(u8, u8),
    /// This code, and no axis in the block.
    Bare(f64),
}

/// The letters of axes, for [`NumberTest::Bare`].
const AXES: &[u8] = b"XYZUVWABC";

/// True for the letters whose numbers are codes.
pub fn is_code(letter: u8) -> bool {
    matches!(letter, b'G' | b'M')
}

impl Pattern {
    /// Parses a pattern.
    pub fn new(text: &str) -> Pattern {
        let terms: Vec<PatternTerm> = text.split(' ').map(PatternTerm::new).collect();
        let single = terms.iter().filter(|term| !term.negated && term.letters.is_power_of_two());
        let all = single.fold(0, |all, term| all | term.letters);
        Pattern { all, terms }
    }

    /// True when a line with words of these letters may match.
    pub fn may_fit(&self, letters: u32) -> bool {
        let possible =
            |term: &PatternTerm| term.negated || term.is_comma() || letters & term.letters != 0;
        letters & self.all == self.all && self.terms.iter().all(possible)
    }

    /// False when only the values of codes and the presence of letters count.
    pub fn depends_on_numbers(&self) -> bool {
        self.terms.iter().flat_map(|term| &term.alternatives).any(|each| match each.test {
            NumberTest::Any => false,
            NumberTest::WithoutPoint | NumberTest::WithDecimals | NumberTest::Digits(..) => true,
            NumberTest::Between(..)
            | NumberTest::Below(_)
            | NumberTest::Above(_)
            | NumberTest::Bare(_) => !is_code(each.letter),
        })
    }

    /// True when the line matches.
    pub fn fits(&self, line: &SampleLine) -> bool {
        line.letters & self.all == self.all && self.terms.iter().all(|term| term.fits(line))
    }
}

impl PatternTerm {
    fn new(text: &str) -> PatternTerm {
        let (negated, text) = match text.strip_prefix('!') {
            Some(rest) => (true, rest),
            None => (false, text),
        };
        let alternatives: Vec<PatternAlternative> =
            text.split('|').map(PatternAlternative::new).collect();
        let letters = alternatives.iter().filter(|each| !each.comma);
        let letters = letters.fold(0, |all, each| all | bit(each.letter));
        PatternTerm { negated, letters, alternatives }
    }

    fn fits(&self, line: &SampleLine) -> bool {
        let may = self.is_comma() || line.letters & self.letters != 0;
        let found = may
            && self
                .alternatives
                .iter()
                .any(|each| line.words.iter().any(|word| each.fits(word, line)));
        found != self.negated
    }

    /// True for words after a comma, whose letters are not in [`SampleLine::letters`].
    fn is_comma(&self) -> bool {
        self.letters == 0
    }
}

impl PatternAlternative {
    fn new(text: &str) -> PatternAlternative {
        let (comma, text) = match text.strip_prefix(',') {
            Some(rest) => (true, rest),
            None => (false, text),
        };
        let letter = text.as_bytes().first().copied().unwrap_or(0);
        PatternAlternative { letter, comma, test: NumberTest::new(text.get(1..).unwrap_or("")) }
    }

    fn fits(&self, word: &SampleWord, line: &SampleLine) -> bool {
        word.letter == self.letter && word.comma == self.comma && self.test.holds(word, line)
    }
}

impl NumberTest {
    fn new(text: &str) -> NumberTest {
        let number = |text: &str| text.parse::<f64>().unwrap_or(f64::NAN);
        if let Some((code, "bare")) = text.split_once(':') {
            return NumberTest::Bare(number(code));
        }
        if let Some(kind) = text.strip_prefix(':') {
            return match kind {
                "int" => NumberTest::WithoutPoint,
                "dec" => NumberTest::WithDecimals,
                _ => {
                    let (from, to) = kind.split_once('-').unwrap_or((kind, kind));
                    NumberTest::Digits(from.parse().unwrap_or(0), to.parse().unwrap_or(0))
                }
            };
        }
        if let Some(limit) = text.strip_prefix('<') {
            return NumberTest::Below(number(limit));
        }
        if let Some(limit) = text.strip_prefix('>') {
            return NumberTest::Above(number(limit));
        }
        match text.split_once("..") {
            _ if text.is_empty() => NumberTest::Any,
            Some((from, to)) => NumberTest::Between(number(from), number(to)),
            None => NumberTest::Between(number(text), number(text)),
        }
    }

    fn holds(&self, word: &SampleWord, line: &SampleLine) -> bool {
        match self {
            NumberTest::Any => true,
            NumberTest::Between(from, to) => word.value >= *from && word.value <= *to,
            NumberTest::Below(limit) => word.value < *limit,
            NumberTest::Above(limit) => word.value > *limit,
            NumberTest::WithoutPoint => word.digits > 0 && word.decimals.is_none(),
            NumberTest::WithDecimals => word.decimals.is_some_and(|count| count > 0),
            NumberTest::Digits(from, to) => {
                word.decimals.is_none() && (*from..=*to).contains(&word.digits)
            }
            NumberTest::Bare(code) => {
                word.value == *code && AXES.iter().all(|axis| line.letters & bit(*axis) == 0)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns() {
        let fits = |pattern: &str, text: &str| {
            let mut line = SampleLine::default();
            line.read(text.as_bytes());
            Pattern::new(pattern).fits(&line)
        };
        assert!(fits("G28|G30 U|W", "G30 U0 W0") && !fits("G28|G30 U|W", "G28 Z0"));
        assert!(fits("E:int X|Y !G65", "X1. E2") && !fits("E:int X|Y !G65", "G65 P1 E2 X1."));
        assert!(!fits("E:int X", "X1 E.02") && fits("G1 E:dec", "G1 X1 E.02"));
        assert!(fits("G54.1 P", "G54.1 P3") && !fits("G54.1 P", "G54 P3"));
        assert!(fits("T:3-6 !M6", "T0101") && !fits("T:3-6 !M6", "T1 M6"));
        assert!(fits("G28:bare", "G28") && !fits("G28:bare", "G28 U0"));
        assert!(fits("G84 ,R", "G84 Z-1. ,R1") && !fits("G84 ,R", "G84 Z-1. R1."));
        assert!(fits("F<1", "G1 F.012") && !fits("F<1", "F1."));
    }
}
