//! The first lines of a file, with the predicates that the tests use.

/// How much of a file is examined, bytes.
const SAMPLE: usize = 16 * 1024;

/// The first lines of a file.
pub(super) struct TextSample {
    /// The non-empty lines, trimmed, and whether each was indented.
    lines: Vec<(String, bool)>,
}

impl TextSample {
    pub fn new(text: &[u8]) -> TextSample {
        // An incomplete last line is left out.
        let text = String::from_utf8_lossy(crate::head::whole_lines(text, SAMPLE));
        let lines = text.split(['\n', '\r']).map(|line| line.trim_matches('\0'));
        let lines = lines.filter(|line| !line.trim().is_empty());
        let lines = lines.map(|line| (line.trim().to_string(), line.starts_with([' ', '\t'])));
        TextSample { lines: lines.collect() }
    }

    /// The lines in order.
    pub fn lines(&self) -> impl Iterator<Item = &str> {
        self.lines.iter().map(|(line, _)| line.as_str())
    }

    /// The first line; empty when there is none.
    pub fn first(&self) -> &str {
        self.lines().next().unwrap_or("")
    }

    /// The first line that does not begin with one of these comment characters; empty when there is none.
    pub fn first_without(&self, mark: &[char]) -> &str {
        self.lines().find(|line| !line.starts_with(mark)).unwrap_or("")
    }

    /// Whether the first line begins with this text, ignoring case.
    pub fn begins(&self, with: &str) -> bool {
        let first = self.first().as_bytes();
        first.get(..with.len()).is_some_and(|first| first.eq_ignore_ascii_case(with.as_bytes()))
    }

    /// Whether some line contains this text.
    pub fn has(&self, piece: &str) -> bool {
        self.lines().any(|line| line.contains(piece))
    }

    /// The number of lines that pass a test.
    pub fn count(&self, test: impl Fn(&str) -> bool) -> usize {
        self.lines().filter(|line| test(line)).count()
    }

    /// Whether at least `least` lines begin with one of these texts.
    pub fn begin(&self, least: usize, pieces: &[&str]) -> bool {
        self.count(|line| pieces.iter().any(|piece| line.starts_with(piece))) >= least
    }

    /// Whether there are at least `least` lines and at least `percent` of them pass a test.
    pub fn share(&self, least: usize, percent: usize, test: impl Fn(&str) -> bool) -> bool {
        let all = self.lines.len();
        all >= least && self.count(test) * 100 >= all * percent
    }

    /// Whether some indented line passes a test.
    pub fn indented(&self, test: impl Fn(&str) -> bool) -> bool {
        self.lines.iter().any(|(line, indented)| *indented && test(line))
    }
}

/// Whether the line begins with this pattern: `9` matches a digit, `+` repeats the preceding character, any other
/// character matches itself.
pub(super) fn fits(line: &str, shape: &str) -> bool {
    let mut rest = line.as_bytes();
    let mut shape = shape.bytes().peekable();
    while let Some(expected) = shape.next() {
        let same =
            |byte: u8| if expected == b'9' { byte.is_ascii_digit() } else { byte == expected };
        let least = 1;
        let most = if shape.next_if_eq(&b'+').is_some() { usize::MAX } else { least };
        let count = rest.iter().take_while(|byte| same(**byte)).count().min(most);
        if count < least {
            return false;
        }
        rest = &rest[count..];
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shapes() {
        assert!(fits("{0}{25}Where", "{9+}{9+}") && !fits("{a}{25}", "{9+}{9+}"));
        assert!(fits("2024-03-11 08:03", "9999-99-99") && !fits("N10 G1", "9999"));
        assert!(fits("T12 P12 Z0.5", "T9+ +P9+") && !fits("T1 M6", "T9+ +P9+"));
    }
}
