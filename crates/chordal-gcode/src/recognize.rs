//! Which control a program was written for, by the signs that the tables name.

use chordal_diagnostics::FileId;
use chordal_dialect::table::{Evidence, Sign};
use chordal_machine::ControlName;
use chordal_syntax::{
    Block, BlockKind, BlockReader, Letters, Lexicon, ParenthesisComment, Semicolon,
};

/// The control that a text speaks for.
#[derive(Clone, Debug, PartialEq)]
pub struct Recognition {
    /// The control.
    pub control: ControlName,
    /// What speaks for it: line of the file and reason, strongest first. Empty when nothing
    /// does and the common default was taken.
    pub evidence: Vec<(u32, &'static str)>,
}

/// How much of a text is looked at.
const SAMPLE: usize = 256 * 1024;

/// What a program without any sign is taken for.
const DEFAULT: ControlName = ControlName::Fanuc;

/// Looks for the signs of all controls and weighs them.
pub fn recognize(text: &[u8]) -> Recognition {
    let sample = &text[..text.len().min(SAMPLE)];
    let mut best: Option<(u32, Recognition)> = None;
    for name in ControlName::ALL.iter().copied() {
        let table = chordal_dialect::table(name);
        let mut found: Vec<(u32, u32, &'static str)> = Vec::new();
        let mut score = 0;
        for evidence in table.evidence {
            if found.iter().any(|(_, _, reason)| *reason == evidence.reason) {
                continue;
            }
            if let Some(line) = find(sample, evidence, &table.lexicon) {
                score += evidence.weight;
                found.push((evidence.weight, line, evidence.reason));
            }
        }
        found.sort_by_key(|(weight, line, _)| (std::cmp::Reverse(*weight), *line));
        let evidence = found.into_iter().map(|(_, line, reason)| (line, reason)).collect();
        if score > best.as_ref().map_or(1, |(score, _)| *score) {
            best = Some((score, Recognition { control: name, evidence }));
        }
    }
    best.map_or(Recognition { control: DEFAULT, evidence: Vec::new() }, |(_, best)| best)
}

/// The first line that shows a sign.
fn find(text: &[u8], evidence: &Evidence, lexicon: &Lexicon) -> Option<u32> {
    let mut reader = BlockReader::new(text, FileId(0), *lexicon);
    let mut block = Block::new();
    if evidence.sign == Sign::OpenComment && !mostly_open(text, lexicon) {
        return None;
    }
    while reader.read(&mut block) {
        if shows(&block, evidence.sign, text, lexicon) {
            return Some(block.line);
        }
    }
    None
}

/// More comments are left open than are closed: one that was broken over two lines says nothing.
fn mostly_open(text: &[u8], lexicon: &Lexicon) -> bool {
    let mut reader = BlockReader::new(text, FileId(0), *lexicon);
    let mut block = Block::new();
    let (mut open, mut closed) = (0_u32, 0_u32);
    while reader.read(&mut block) {
        for comment in &block.comments {
            let words = comment.slice(text);
            if words.first() == Some(&b'(') {
                let count = if words.contains(&b')') { &mut closed } else { &mut open };
                *count += 1;
            }
        }
    }
    open > closed
}

fn shows(block: &Block, sign: Sign, text: &[u8], lexicon: &Lexicon) -> bool {
    let letters = block.letters();
    let has_code = |letter: u8, code: u16| {
        block.all(letter).any(|word| {
            let tenths = word.number().map(|number| number.to_f64() * 10.0);
            tenths.is_some_and(|tenths| (tenths - f64::from(code)).abs() < 1e-6)
        })
    };
    match sign {
        Sign::G(code) => has_code(b'G', code),
        Sign::M(code) => has_code(b'M', code),
        Sign::Letters(wanted) => {
            Letters::of(wanted).within(letters) && !letters.meets(Letters::of("GM"))
        }
        Sign::With(wanted) => Letters::of(wanted).within(letters),
        Sign::Register => register_word(block.range.slice(text)),
        Sign::OpenComment => block.comments.iter().any(|comment| {
            let words = comment.slice(text);
            words.first() == Some(&b'(')
                && lexicon.parenthesis == ParenthesisComment::ToEndOfLine
                && !words.contains(&b')')
        }),
        Sign::SemicolonComment => {
            lexicon.semicolon == Semicolon::Comment
                && block.comments.iter().any(|comment| {
                    let words = comment.slice(text);
                    words.first() == Some(&b';') && words.iter().any(u8::is_ascii_alphabetic)
                })
        }
        Sign::FiveDigitProgram => block.word(b'O').is_some_and(|word| word.range.len() == 6),
        Sign::OWord => match block.kind {
            BlockKind::Macro(range) => {
                let words = range.slice(text).to_ascii_lowercase();
                words.first() == Some(&b'o') || letters.has(b'O')
            }
            _ => false,
        },
        Sign::SubroutineHead => {
            letters == Letters::of("L")
                && block.word(b'L').and_then(|word| word.number()).is_some_and(|number| {
                    number.to_integer().is_some_and(|value| value >= 100 && value % 100 == 0)
                })
        }
        Sign::MacroStatement => matches!(block.kind, BlockKind::Macro(_)),
        Sign::MachineCoordinatesWithOthers => has_code(b'G', 530) && block.all(b'G').count() > 1,
    }
}

/// `R0+1.5`, `R1-.2`: R, a digit, a sign, outside comments.
fn register_word(words: &[u8]) -> bool {
    let code = words.split(|b| *b == b'(').next().unwrap_or(words);
    code.windows(3).any(|w| {
        w[0].eq_ignore_ascii_case(&b'R') && w[1].is_ascii_digit() && matches!(w[2], b'+' | b'-')
    })
}
