//! The tokens of a text for the colours of an editor. They are lexical: a line that cannot be read has tokens, too.

use chordal_diagnostics::TextRange;
use chordal_kernel::{Token, TokenClass};

use super::reader::BlockReader;
use super::scanner::{LineScanner, begins_name};
use super::units::{head_name, is_path_line};

/// The words of the language itself.
const KEYWORDS: [&str; 66] = [
    "ACTBLOCNO",
    "AND",
    "AS",
    "AXIS",
    "BLOCK",
    "BOOL",
    "B_AND",
    "B_NOT",
    "B_OR",
    "B_XOR",
    "CALL",
    "CASE",
    "CHAN",
    "CHAR",
    "DEF",
    "DEFAULT",
    "DEFINE",
    "DISPLOF",
    "DIV",
    "DO",
    "ELSE",
    "ENDFOR",
    "ENDIF",
    "ENDLOOP",
    "ENDWHILE",
    "EVERY",
    "EXTCALL",
    "EXTERN",
    "FALSE",
    "FOR",
    "FRAME",
    "FROM",
    "GOTO",
    "GOTOB",
    "GOTOC",
    "GOTOF",
    "GOTOS",
    "IF",
    "INT",
    "ISOCALL",
    "LOOP",
    "MCALL",
    "MOD",
    "NCK",
    "NOT",
    "OF",
    "OR",
    "PCALL",
    "PROC",
    "REAL",
    "REP",
    "REPEAT",
    "REPEATB",
    "RET",
    "SAVE",
    "SBLOF",
    "SET",
    "STRING",
    "TO",
    "TRUE",
    "UNTIL",
    "VAR",
    "WHEN",
    "WHENEVER",
    "WHILE",
    "XOR",
];

/// The tokens that begin in a part of the text, in order.
pub fn tokens(text: &[u8], part: TextRange) -> Vec<Token> {
    let from = (part.start as usize).min(text.len());
    let start = memchr::memrchr2(b'\n', b'\r', &text[..from]).map_or(0, |end| end + 1);
    let mut reader = BlockReader::new(text);
    reader.seek(start as u32, 1);
    let mut tokens = Vec::new();
    while reader.offset() < part.end
        && let Some((line, _)) = reader.next_line()
    {
        line_tokens(text, line, &mut tokens);
    }
    tokens.retain(|token| token.range.start >= part.start && token.range.start < part.end);
    tokens
}

fn line_tokens(text: &[u8], line: TextRange, tokens: &mut Vec<Token>) {
    let mut scan = LineScanner::new(text, line.start as usize, line.end as usize);
    scan.skip_blanks();
    let class = match scan.peek() {
        b'%' if head_name(scan.rest()).is_some() => Some(TokenClass::Program),
        b'%' => Some(TokenClass::Mark),
        b';' if is_path_line(scan.rest()) => Some(TokenClass::Mark),
        _ => None,
    };
    if let Some(class) = class {
        tokens.push(Token { range: TextRange::new(scan.at as u32, line.end), class });
        return;
    }
    head_tokens(&mut scan, tokens);
    while !scan.is_at_end() {
        let start = scan.at;
        if let Some(class) = read_token(&mut scan) {
            tokens.push(Token { range: scan.range_from(start), class });
        }
    }
    if scan.peek() == b';' {
        let range = TextRange::new(scan.at as u32, line.end);
        tokens.push(Token { range, class: TokenClass::Comment });
    }
}

/// The skip mark, the number and the label of a block.
fn head_tokens(scan: &mut LineScanner<'_>, tokens: &mut Vec<Token>) {
    let start = scan.at;
    if scan.take(b'/') {
        scan.at += usize::from(scan.peek().is_ascii_digit());
        tokens.push(Token { range: scan.range_from(start), class: TokenClass::Mark });
    }
    for length_of in [number_length, label_length] {
        scan.skip_blanks();
        let start = scan.at;
        scan.at += length_of(*scan);
        if scan.at > start {
            tokens.push(Token { range: scan.range_from(start), class: TokenClass::Label });
        }
    }
}

/// The length of `N10` or `:10`; 0 for anything else.
fn number_length(mut scan: LineScanner<'_>) -> usize {
    let start = scan.at;
    if !matches!(scan.peek(), b'N' | b'n' | b':') {
        return 0;
    }
    scan.at += 1;
    scan.skip_blanks();
    let digits = scan.count_digits();
    if digits == 0 { 0 } else { scan.at + digits - start }
}

/// The length of a label with its colon; 0 for anything else.
fn label_length(mut scan: LineScanner<'_>) -> usize {
    let start = scan.at;
    let is_label = scan.read_name().is_some_and(|name| name.len() > 1) && scan.take(b':');
    if is_label { scan.at - start } else { 0 }
}

/// Reads an element; `None` for an operator and for punctuation.
fn read_token(scan: &mut LineScanner<'_>) -> Option<TokenClass> {
    let byte = scan.peek();
    match byte {
        b'"' => {
            scan.skip_text();
            Some(TokenClass::Text)
        }
        b'\'' => {
            let close = scan.rest().get(1..).and_then(|rest| memchr::memchr(b'\'', rest));
            scan.at += close.map_or(1, |close| close + 2);
            Some(if close.is_some() { TokenClass::Number } else { TokenClass::Unknown })
        }
        b'0'..=b'9' | b'.' if scan.read_number().is_some() => Some(TokenClass::Number),
        _ if begins_name(byte) => scan.read_name().map(|name| name_class(scan, name)),
        b'=' | b'<' | b'>' | b'+' | b'-' | b'*' | b'/' | b'(' | b')' | b'[' | b']' | b','
        | b':' => {
            scan.at += 1;
            None
        }
        _ => {
            scan.at += 1;
            Some(TokenClass::Unknown)
        }
    }
}

/// The class of a name. A number directly after a letter belongs to the token.
fn name_class(scan: &mut LineScanner<'_>, name: TextRange) -> TokenClass {
    let text = scan.slice(name);
    if let [letter] = text {
        skip_value(scan);
        return letter_class(letter.to_ascii_uppercase());
    }
    if KEYWORDS.iter().any(|keyword| text.eq_ignore_ascii_case(keyword.as_bytes())) {
        return TokenClass::Keyword;
    }
    let mut after = *scan;
    match after.next_byte() {
        _ if text.starts_with(b"$") => TokenClass::Variable,
        b'(' => TokenClass::Keyword,
        b'=' | b'[' | b'<' | b'>' | b'+' | b'-' | b'*' | b'/' | b')' | b']' | b',' => {
            TokenClass::Variable
        }
        // A bare name sets a mode: TRANS, SUPA, STOPRE.
        _ => TokenClass::GCode,
    }
}

/// Skips the number directly after a letter, with its sign. Digits before an equals sign are an extension.
fn skip_value(scan: &mut LineScanner<'_>) {
    let mut value = *scan;
    if matches!(value.peek(), b'+' | b'-') {
        value.at += 1;
    }
    if value.read_number().is_some() {
        *scan = value;
    }
}

fn letter_class(letter: u8) -> TokenClass {
    match letter {
        b'G' => TokenClass::GCode,
        b'M' => TokenClass::MCode,
        b'X' | b'Y' | b'Z' | b'A' | b'B' | b'C' | b'U' | b'V' | b'W' => TokenClass::Axis,
        b'F' | b'S' => TokenClass::Speed,
        b'T' | b'D' => TokenClass::Tool,
        b'R' => TokenClass::Variable,
        _ => TokenClass::Parameter,
    }
}
