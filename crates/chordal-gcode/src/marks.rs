//! Splits a macro statement or expression into marks, for colours and for finding its names. `chordal-syntax` reads its
//! meaning.

use chordal_diagnostics::TextRange;
use chordal_syntax::Lexicon;

/// The class of a piece of a macro statement.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum StatementMark {
    /// `#101`, `#<depth>`, `V12`, `R3`.
    Variable,
    /// A run of letters: `IF`, `GOTO`, `SIN`.
    Word,
    /// A number.
    Number,
    /// A text in quotation marks.
    Text,
    /// A comment, also at the end of a macro line.
    Comment,
}

/// The marks of a range in order, without operators and brackets.
pub fn marks<'a>(
    text: &'a [u8],
    range: TextRange,
    lexicon: &'a Lexicon,
) -> impl Iterator<Item = (StatementMark, TextRange)> + 'a {
    let end = (range.end as usize).min(text.len());
    let mut at = range.start as usize;
    // The `#` that opens a macro line is not a variable.
    if lexicon.macro_lines && text.get(at) == Some(&b'#') {
        at += 1;
    }
    std::iter::from_fn(move || {
        while at < end {
            let start = at;
            let mark = step(&text[..end], &mut at, lexicon);
            if let Some(mark) = mark {
                return Some((mark, TextRange::new(start as u32, at as u32)));
            }
        }
        None
    })
}

/// Advances over the next mark, by at least a byte; `None` for operators and brackets.
fn step(text: &[u8], at: &mut usize, lexicon: &Lexicon) -> Option<StatementMark> {
    let byte = text[*at];
    let run = |from: usize, of: fn(&u8) -> bool| text[from..].iter().take_while(|b| of(b)).count();
    let digits = |from: usize| run(from, u8::is_ascii_digit);
    *at += 1;
    match byte {
        b'#' if text.get(*at) == Some(&b'<') => {
            let name = run(*at, |byte| *byte != b'>');
            *at = (*at + name + 1).min(text.len());
            Some(StatementMark::Variable)
        }
        b'#' => {
            let count = digits(*at);
            *at += count;
            (count > 0).then_some(StatementMark::Variable)
        }
        b'"' => {
            let count = run(*at, |byte| *byte != b'"');
            *at = (*at + count + 1).min(text.len());
            Some(StatementMark::Text)
        }
        // On macro lines parentheses are arithmetic.
        b'(' if !lexicon.macro_lines => {
            let count = run(*at, |byte| *byte != b')');
            *at = (*at + count + 1).min(text.len());
            Some(StatementMark::Comment)
        }
        b'\'' if lexicon.macro_lines => {
            *at = text.len();
            Some(StatementMark::Comment)
        }
        b'V' | b'v' | b'R' | b'r' if lexicon.macro_lines && digits(*at) > 0 => {
            *at += digits(*at);
            Some(StatementMark::Variable)
        }
        b'0'..=b'9' => {
            *at += run(*at, |byte| byte.is_ascii_digit() || *byte == b'.');
            Some(StatementMark::Number)
        }
        byte if byte.is_ascii_alphabetic() => {
            *at += run(*at, u8::is_ascii_alphabetic);
            Some(StatementMark::Word)
        }
        _ => None,
    }
}
