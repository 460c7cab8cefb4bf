//! Reads a line of an unknown control: words, comments, and the rest.
//!
//! The block reader needs the control, for the meaning of semicolon, asterisk and parenthesis. This one reads what all
//! controls share and remembers what is unusual.

/// A word: a letter and its number, if it is a plain one.
#[derive(Clone, Copy, Debug)]
pub struct SampleWord {
    /// In upper case.
    pub letter: u8,
    /// After a comma: `,R1`.
    pub comma: bool,
    /// NaN for an expression or a missing number.
    pub value: f64,
    /// Number of digits before and after the point.
    pub digits: u8,
    /// Number of digits after the point; `None` without a point.
    pub decimals: Option<u8>,
}

/// One line.
#[derive(Debug, Default)]
pub struct SampleLine {
    /// Its words in order.
    pub words: Vec<SampleWord>,
    /// The letters of the words, A in the lowest bit.
    pub letters: u32,
    /// Ranges of the comments in the line, without their delimiters.
    pub comments: Vec<(usize, usize)>,
    /// A comment in parentheses is not closed.
    pub open: bool,
    /// A comment in parentheses is closed.
    pub closed: bool,
    /// A comment after a semicolon has letters.
    pub semicolon: bool,
    /// It contains more than words: names, equals signs, brackets, strings, `$`.
    pub odd: bool,
    /// It has `#` or brackets.
    pub macros: bool,
    /// The end of the code, after which only a comment follows.
    pub code_end: usize,
}

/// The bit of an upper-case letter; 0 for other bytes.
pub fn bit(letter: u8) -> u32 {
    if letter.is_ascii_uppercase() { 1 << (letter - b'A') } else { 0 }
}

impl SampleLine {
    /// Reads a line without its end.
    pub fn read(&mut self, line: &[u8]) {
        self.clear(line.len());
        let mut at = 0;
        while let Some(byte) = line.get(at).copied() {
            at = match byte {
                b'A'..=b'Z' | b'a'..=b'z' => self.letter(line, at),
                b'(' => self.parenthesis(line, at),
                b';' => match self.semicolon(line, at) {
                    Some(next) => next,
                    None => return,
                },
                b'*' if !self.macros => {
                    self.end_with_comment(line, at);
                    return;
                }
                b'"' => {
                    self.odd = true;
                    end_of(line, at + 1, b'"').map_or(line.len(), |end| end + 1)
                }
                b'#' | b'[' => {
                    (self.odd, self.macros) = (true, true);
                    at + 1
                }
                b'=' | b'$' | b'<' | b'{' | b'%' | b'&' => {
                    self.odd = true;
                    at + 1
                }
                _ => at + 1,
            };
        }
    }

    fn clear(&mut self, length: usize) {
        self.words.clear();
        self.comments.clear();
        self.letters = 0;
        (self.open, self.closed, self.semicolon) = (false, false, false);
        (self.odd, self.macros) = (false, false);
        self.code_end = length;
    }

    /// A letter begins a word, or with more letters a name.
    fn letter(&mut self, line: &[u8], at: usize) -> usize {
        let next = line.get(at + 1).copied().unwrap_or(b'\n');
        if next.is_ascii_alphabetic() || next == b'_' {
            return self.name(line, at);
        }
        let letter = line[at].to_ascii_uppercase();
        let comma = line[..at].last() == Some(&b',');
        let (word, end) = number(line, at + 1);
        self.letters |= if comma { 0 } else { bit(letter) };
        self.words.push(SampleWord { letter, comma, ..word });
        end
    }

    /// Several letters. A parenthesis right after a name is a call, not a comment.
    fn name(&mut self, line: &[u8], at: usize) -> usize {
        self.odd = true;
        let mut end = at;
        while line.get(end).is_some_and(|byte| byte.is_ascii_alphanumeric() || *byte == b'_') {
            end += 1;
        }
        match line.get(end) {
            Some(b'(') => end_of(line, end, b')').map_or(line.len(), |close| close + 1),
            _ => end,
        }
    }

    fn parenthesis(&mut self, line: &[u8], at: usize) -> usize {
        match end_of(line, at, b')') {
            Some(end) => {
                self.closed = true;
                self.comments.push((at + 1, end));
                end + 1
            }
            None => {
                self.open = true;
                self.comments.push((at + 1, line.len()));
                line.len()
            }
        }
    }

    /// A semicolon: the end of a block with another one after it, or the start of a comment (`None`).
    fn semicolon(&mut self, line: &[u8], at: usize) -> Option<usize> {
        let rest = &line[at + 1..];
        // `G0X1;G1Y2`: another block follows.
        if let [first, second, ..] = rest
            && first.is_ascii_alphabetic()
            && (second.is_ascii_digit() || matches!(second, b'-' | b'.'))
            && at > 0
        {
            return Some(at + 1);
        }
        self.semicolon = rest.iter().any(u8::is_ascii_alphabetic);
        self.end_with_comment(line, at);
        None
    }

    fn end_with_comment(&mut self, line: &[u8], at: usize) {
        self.code_end = at;
        self.comments.push((at + 1, line.len()));
    }
}

fn end_of(line: &[u8], from: usize, byte: u8) -> Option<usize> {
    memchr::memchr(byte, &line[from..]).map(|end| from + end)
}

/// The number at a position after blanks, and its end. The caller fills in the letter.
fn number(line: &[u8], from: usize) -> (SampleWord, usize) {
    let mut at = from;
    while line.get(at).is_some_and(|byte| matches!(byte, b' ' | b'\t')) {
        at += 1;
    }
    let negative = line.get(at) == Some(&b'-');
    at += usize::from(matches!(line.get(at), Some(b'-' | b'+')));
    let (mut mantissa, mut digits, mut decimals) = (0.0, 0_u8, None);
    while let Some(byte) = line.get(at) {
        match byte {
            b'0'..=b'9' => {
                mantissa = mantissa * 10.0 + f64::from(byte - b'0');
                digits = digits.saturating_add(1);
                decimals = decimals.map(|count: u8| count.saturating_add(1));
            }
            b'.' if decimals.is_none() => decimals = Some(0),
            _ => break,
        }
        at += 1;
    }
    let scale = TENS[usize::from(decimals.unwrap_or(0)).min(TENS.len() - 1)];
    let sign = if negative { -1.0 } else { 1.0 };
    let value = if digits == 0 { f64::NAN } else { sign * mantissa / scale };
    // Without a number the letter is alone, and what follows is read separately.
    let end = if digits == 0 { from } else { at };
    (SampleWord { letter: 0, comma: false, value, digits, decimals }, end)
}

const TENS: [f64; 10] = [1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9];

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> (String, SampleLine) {
        let mut line = SampleLine::default();
        line.read(text.as_bytes());
        let words: Vec<String> = line
            .words
            .iter()
            .map(|word| format!("{}{}", char::from(word.letter), word.value))
            .collect();
        (words.join(" "), line)
    }

    #[test]
    fn words_and_comments() {
        assert_eq!(read("N10G01X-1.50 Y 2 (CUT)F.5").0, "N10 G1 X-1.5 Y2 F0.5");
        assert_eq!(read("G0 X1;").0, "G0 X1");
        assert_eq!(read("G0 X1;G1Y2;").0, "G0 X1 G1 Y2");
        let (words, line) = read("G0 X1 ; TO THE START");
        assert!(words == "G0 X1" && line.semicolon && line.code_end == 6);
        assert!(read("G0 (LEFT OPEN").1.open);
    }

    #[test]
    fn names_calls_and_expressions_are_no_words() {
        let (words, line) = read("MCALL CYCLE83(10,0,\"A\") X5");
        assert!(words == "X5" && line.odd && line.comments.is_empty());
        let (words, line) = read("X[#1*2] Y#3 Z1.");
        assert!(words == "XNaN YNaN Z1" && line.macros);
    }
}
