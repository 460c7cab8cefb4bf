//! STL as text: `facet normal … outer loop vertex … vertex … vertex … endloop endfacet` between
//! `solid` and `endsolid` with a name up to the end of the line.

use super::{StlError, TriangleSoup};

/// What is wrong with a word of the text.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum TextProblem {
    /// A word is not the one that was expected.
    #[error("'{expected}' was expected, '{found}' is there")]
    Word {
        /// What belongs there.
        expected: &'static str,
        /// The word, cut at `MAX_SHOWN_CHARS` characters.
        found: String,
    },
    /// A word is not a number.
    #[error("'{found}' is no number")]
    Number {
        /// The word.
        found: String,
    },
    /// The text ends within a solid.
    #[error("the text ends where '{expected}' was expected")]
    End {
        /// What belongs there.
        expected: &'static str,
    },
}

/// Characters of a word that a message shows.
const MAX_SHOWN_CHARS: usize = 24;
/// Bytes of a binary head. It has zero bytes in its text or in its count (below 2²⁴ triangles); a text file has none.
const HEAD: usize = 84;

/// Whether bytes are STL text, if their size is not that of a binary STL.
pub(super) fn looks_like(bytes: &[u8]) -> bool {
    let mut words = StlWords::new(bytes);
    words.next().is_some_and(|word| word.is("solid"))
        && !bytes[..bytes.len().min(HEAD)].contains(&0)
}

pub(super) fn read(bytes: &[u8], soup: &mut TriangleSoup) -> Result<(), StlError> {
    let mut words = StlWords::new(bytes);
    words.expect("solid")?;
    loop {
        words.skip_line();
        loop {
            let word = words.take("endsolid")?;
            if word.is("endsolid") {
                words.skip_line();
                break;
            }
            if !word.is("facet") {
                return Err(word.wrong("facet"));
            }
            facet(&mut words, soup)?;
        }
        let Some(word) = words.next() else { return Ok(()) };
        if !word.is("solid") {
            return Err(word.wrong("solid"));
        }
    }
}

fn facet(words: &mut StlWords, soup: &mut TriangleSoup) -> Result<(), StlError> {
    words.expect("normal")?;
    for _ in 0..3 {
        // The normal is not read: it follows from the corners, and some writers put "nan" there for thin triangles.
        words.take("a number")?;
    }
    words.expect("outer")?;
    words.expect("loop")?;
    let corners = [corner(words)?, corner(words)?, corner(words)?];
    words.expect("endloop")?;
    words.expect("endfacet")?;
    soup.push(corners)
}

fn corner(words: &mut StlWords) -> Result<([f64; 3], usize), StlError> {
    let offset = words.expect("vertex")?;
    Ok(([words.number()?, words.number()?, words.number()?], offset))
}

struct StlWord<'a> {
    bytes: &'a [u8],
    line: usize,
    offset: usize,
}

impl StlWord<'_> {
    fn is(&self, word: &str) -> bool {
        self.bytes.eq_ignore_ascii_case(word.as_bytes())
    }

    fn shown(&self) -> String {
        String::from_utf8_lossy(self.bytes).chars().take(MAX_SHOWN_CHARS).collect()
    }

    fn problem(&self, problem: TextProblem) -> StlError {
        StlError::Text { line: self.line, offset: self.offset, problem }
    }

    fn wrong(&self, expected: &'static str) -> StlError {
        self.problem(TextProblem::Word { expected, found: self.shown() })
    }
}

/// Splits a text into words, and counts lines.
struct StlWords<'a> {
    bytes: &'a [u8],
    at: usize,
    line: usize,
}

impl<'a> StlWords<'a> {
    fn new(bytes: &'a [u8]) -> StlWords<'a> {
        const MARK: &[u8] = b"\xef\xbb\xbf";
        StlWords { bytes, at: if bytes.starts_with(MARK) { MARK.len() } else { 0 }, line: 1 }
    }

    fn next(&mut self) -> Option<StlWord<'a>> {
        while let Some(byte) = self.bytes.get(self.at).filter(|byte| byte.is_ascii_whitespace()) {
            self.line += usize::from(*byte == b'\n');
            self.at += 1;
        }
        let rest = &self.bytes[self.at..];
        let length = rest.iter().take_while(|byte| !byte.is_ascii_whitespace()).count();
        let word = StlWord { bytes: &rest[..length], line: self.line, offset: self.at };
        self.at += length;
        (length > 0).then_some(word)
    }

    fn take(&mut self, expected: &'static str) -> Result<StlWord<'a>, StlError> {
        let word = self.next();
        let (line, offset) = (self.line, self.at);
        word.ok_or(StlError::Text { line, offset, problem: TextProblem::End { expected } })
    }

    /// Takes a word that must be there, and returns its offset.
    fn expect(&mut self, expected: &'static str) -> Result<usize, StlError> {
        let word = self.take(expected)?;
        if word.is(expected) { Ok(word.offset) } else { Err(word.wrong(expected)) }
    }

    fn number(&mut self) -> Result<f64, StlError> {
        let word = self.take("a number")?;
        let value = std::str::from_utf8(word.bytes).ok().and_then(|text| text.parse().ok());
        value.ok_or_else(|| word.problem(TextProblem::Number { found: word.shown() }))
    }

    /// Skips the rest of the line, which is a name.
    fn skip_line(&mut self) {
        let rest = &self.bytes[self.at..];
        self.at += rest.iter().take_while(|byte| **byte != b'\n').count();
    }
}
