//! Finds the programs of a file by their heads.

use chordal_diagnostics::{TextRange, line_ends};

use crate::alignment::is_alignment_number;
use crate::lexicon::{Lexicon, Semicolon};
use crate::program_name::{is_program_name, scan_program_name};
use crate::reader::BlockPosition;

/// A program of a file: its head and the text up to the next head.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ProgramHead {
    /// The number after `O` or `:`, or the one that represents its name; `None` for text before the first head.
    pub number: Option<u32>,
    /// The text of the head.
    pub head: TextRange,
    /// The start of the program (of the line of its head).
    pub start: BlockPosition,
    /// Its end, in bytes: the next head, or the end of the file.
    pub end: u32,
}

impl ProgramHead {
    /// The program as it is called: `O1234`, or its name; `None` if it has neither.
    pub fn title(&self, text: &[u8]) -> Option<String> {
        let number = self.number?;
        let name = || String::from_utf8_lossy(self.head.slice(text)).into_owned();
        Some(if is_program_name(number) { name() } else { format!("O{number}") })
    }
}

/// Finds the programs of a text by their heads: `O1234`, `:1234` or `<NAME>` at the start of a line, also after an N
/// number or blanks. It is one pass that stops only at the characters that begin a head, so a gigabyte takes a fraction
/// of a second.
pub fn find_programs(text: &[u8], lexicon: &Lexicon) -> Vec<ProgramHead> {
    if !lexicon.program_heads {
        return vec![nameless(text.len() as u32)];
    }
    let mut heads: Vec<ProgramHead> = Vec::new();
    let mut counted = BlockPosition { offset: 0, line: 1 };
    let named = lexicon.named_programs.then(|| memchr::memchr_iter(b'<', text));
    let mut named = named.into_iter().flatten().peekable();
    let mut numbered = memchr::memchr3_iter(b'O', b'o', b':', text).peekable();
    loop {
        let at = match (numbered.peek(), named.peek()) {
            (None, None) => break,
            (Some(number), Some(name)) if name < number => named.next(),
            (None, Some(_)) => named.next(),
            (Some(_), _) => numbered.next(),
        };
        let Some(at) = at else { break };
        let Some((line_start, number, end)) = head_at(text, at, lexicon) else { continue };
        counted = advance(text, counted, line_start as u32);
        if let Some(last) = heads.last_mut() {
            last.end = line_start as u32;
        } else if holds_words(&text[..line_start]) {
            heads.push(nameless(line_start as u32));
        }
        heads.push(ProgramHead {
            number: Some(number),
            head: TextRange::new(at as u32, end as u32),
            start: counted,
            end: text.len() as u32,
        });
    }
    if heads.is_empty() {
        heads.push(nameless(text.len() as u32));
    }
    heads
}

fn nameless(end: u32) -> ProgramHead {
    let start = BlockPosition { offset: 0, line: 1 };
    ProgramHead { number: None, head: TextRange::default(), start, end }
}

/// Line start, number and end of the head whose letter is at `at`; `None` if it is not a head.
fn head_at(text: &[u8], at: usize, lexicon: &Lexicon) -> Option<(usize, u32, usize)> {
    if text[at] == b'<' {
        let (number, length) = scan_program_name(&text[at..])?;
        let line_start = memchr::memrchr2(b'\n', b'\r', &text[..at]).map_or(0, |end| end + 1);
        let is_first = text[line_start..at].iter().all(|b| matches!(b, b' ' | b'\t' | 0));
        return is_first.then_some((line_start, number, at + length));
    }
    let digits = text[at + 1..].iter().take_while(|b| b.is_ascii_digit()).count();
    if digits == 0 || digits > 9 {
        return None;
    }
    if text[at] == b':' && is_alignment_number(&text[at..]) {
        return None;
    }
    let end = at + 1 + digits;
    let number = std::str::from_utf8(&text[at + 1..end]).ok()?.parse().ok()?;
    // Goes back to the start of the line over blanks, NULs and one N number.
    let mut back = at;
    let mut seen_number = false;
    while back > 0 {
        match text[back - 1] {
            b'\n' | b'\r' => break,
            b' ' | b'\t' | 0 => {}
            // `%;O1`
            b'%' | b';' if lexicon.semicolon == Semicolon::EndOfBlock => {}
            b'0'..=b'9' | b'.' => seen_number = true,
            b'N' | b'n' if seen_number => {}
            _ => return None,
        }
        back -= 1;
    }
    Some((back, number, end))
}

/// The position at offset `to`, with the lines counted from a known position.
fn advance(text: &[u8], from: BlockPosition, to: u32) -> BlockPosition {
    let part = &text[from.offset as usize..to as usize];
    let ends = line_ends(part).count();
    BlockPosition { offset: to, line: from.line + ends as u32 }
}

/// True if a text has words, not only comments, percent and folder lines.
fn holds_words(text: &[u8]) -> bool {
    text.split(|b| matches!(b, b'\n' | b'\r')).any(|line| {
        let first = line.iter().find(|b| !matches!(b, b' ' | b'\t' | 0));
        first.is_some_and(|b| b.is_ascii_alphabetic() || *b == b'/' || *b == b'#')
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn heads(text: &str) -> Vec<(Option<u32>, u32)> {
        find_programs(text.as_bytes(), &Lexicon::COMMON)
            .iter()
            .map(|head| (head.number, head.start.line))
            .collect()
    }

    #[test]
    fn heads_stand_at_the_start_of_a_line() {
        let text = "%\n&F=/USER/\nO1 (NOT O2)\nG0 X1.\n(O3)\n:0097\nM99\nN5 O12\nM30\n%\n";
        assert_eq!(heads(text), [(Some(1), 3), (Some(97), 6), (Some(12), 8)]);
    }

    #[test]
    fn words_before_the_first_head_are_a_program() {
        assert_eq!(heads("G0 X1.\nM30\nO5\nM99\n"), [(None, 1), (Some(5), 3)]);
        assert_eq!(heads("G0 X1.\nM30\n"), [(None, 1)]);
        assert_eq!(heads(""), [(None, 1)]);
    }
}
