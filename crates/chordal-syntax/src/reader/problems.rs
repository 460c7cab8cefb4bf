//! Diagnostics for text that is not a word.

use super::*;

impl BlockReader<'_> {
    /// Reports `X1O.5`, `XO` or `Xl.5`: the letter O instead of a zero, or a lower-case l instead of a one.
    #[cold]
    pub(super) fn letter_for_digit(
        &mut self,
        block: &mut Block,
        start: usize,
    ) -> Option<WordValue> {
        let rest = &self.text[self.at..self.end];
        let numeric = |b: &u8| b.is_ascii_digit() || matches!(b, b'.' | b'+' | b'-');
        let token: Vec<u8> = rest
            .iter()
            .copied()
            .take_while(|b| numeric(b) || matches!(b, b'O' | b'o' | b'l'))
            .collect();
        let mut letters = token.iter().filter(|b| b.is_ascii_alphabetic());
        // A keyword or an O word after a blank is no typing mistake.
        let next = rest.get(token.len()).copied().unwrap_or(b'\n');
        let in_packed_words = next.is_ascii_alphabetic() && is_packed_slip(&token);
        if letters.next().is_none() || next.is_ascii_alphabetic() && !in_packed_words {
            return None;
        }
        let mended: Vec<u8> = token
            .iter()
            .map(|b| match b {
                b'O' | b'o' => b'0',
                b'l' => b'1',
                other => *other,
            })
            .collect();
        let number = Decimal::parse(&mended)?;
        self.at += token.len();
        let range = TextRange::new(start as u32, self.at as u32);
        let letter = self.text[start] as char;
        let meant = format!("{letter}{}", String::from_utf8_lossy(&mended));
        self.problem(block, || {
            let span = range.in_file(self.file);
            Diagnostic::new(Code::LetterForDigit, span, "there is a letter inside this number")
                .label(format!("read as `{meant}`"))
                .help(format!("write `{meant}`"))
                .fix(Fix {
                    title: format!("write `{meant}`"),
                    span,
                    replacement: meant.clone(),
                    applicability: Applicability::Safe,
                })
        });
        Some(WordValue::Number(number))
    }

    /// Reports `(cut) o100 repeat [2]`: after a comment, the interpreter reads the O as a word, and there is no such
    /// word.
    #[cold]
    pub(super) fn o_word_after_comment(&self, block: &mut Block, start: usize) {
        self.problem(block, || {
            let span = Span::new(self.file, start as u32, start as u32 + 1);
            Diagnostic::new(Code::MixedBlock, span, "an O word behind a comment")
                .label("the control reads no O word here, and refuses the line")
                .help("write the comment behind the statement, or on a line of its own")
        });
    }

    #[cold]
    pub(super) fn bad_number(&mut self, block: &mut Block, start: usize) {
        let rest = &self.text[self.at..self.end];
        let token = rest.iter().take_while(|b| CLASSES[**b as usize] == CharClass::Digit).count();
        self.at += token;
        let words = &rest[..token];
        let points = words.iter().filter(|b| **b == b'.').count();
        let signs = words.iter().filter(|b| matches!(b, b'+' | b'-')).count();
        let digits = words.iter().filter(|b| b.is_ascii_digit()).count();
        let why = match (points, signs, digits) {
            (_, _, 0) => "it has no digit".to_string(),
            (_, _, 19..) => format!("it has {digits} digits"),
            (2.., _, _) => format!("it has {points} decimal points"),
            (_, 2.., _) => format!("it has {signs} signs"),
            _ => "its sign is in the middle".to_string(),
        };
        let range = TextRange::new(start as u32, self.at as u32);
        self.problem(block, || {
            Diagnostic::new(
                Code::BadNumber,
                range.in_file(self.file),
                format!("this is not a number: {why}"),
            )
            .label("this word is skipped")
            .help("a number is an optional sign, digits, and at most one decimal point")
        });
    }

    /// Reports a number without a letter: the letter is missing, or an `I` was typed as `1` (`12. J2.`).
    #[cold]
    pub(super) fn lone_number(&mut self, block: &mut Block) {
        let start = self.at;
        if block.words.is_empty() && self.remark(block, start) {
            return;
        }
        let rest = &self.text[start..self.end];
        let token = rest.iter().take_while(|b| CLASSES[**b as usize] == CharClass::Digit).count();
        self.at += token.max(1);
        let words = &rest[..token];
        // Only the words after it, not those of a comment.
        let line_end = memchr::memchr3(b'\n', b'\r', b'(', rest).unwrap_or(rest.len());
        let following = &rest[token..line_end.min(token + 200)];
        let has = |letter: u8| {
            block.letters().has(letter)
                || following.iter().any(|b| b.to_ascii_uppercase() == letter)
        };
        let one_for_i = words.len() > 1
            && words[0] == b'1'
            && !has(b'I')
            && (has(b'J') || has(b'K'))
            && Decimal::parse(&words[1..]).is_some();
        let range = TextRange::new(start as u32, self.at as u32);
        let shown = String::from_utf8_lossy(words).into_owned();
        self.problem(block, || {
            let span = range.in_file(self.file);
            let problem = Diagnostic::new(
                Code::MissingAddress,
                span,
                format!("`{shown}` has no address letter"),
            )
            .label("which axis or function is this?");
            if one_for_i {
                let meant = format!("I{}", &shown[1..]);
                problem.help(format!("the letter I was typed as the digit 1: write `{meant}`")).fix(
                    Fix {
                        title: format!("write `{meant}`"),
                        span,
                        replacement: meant,
                        applicability: Applicability::Unsafe,
                    },
                )
            } else {
                problem.help("write the letter before the number, or remove the number")
            }
        });
    }

    #[cold]
    pub(super) fn unexpected(&mut self, block: &mut Block) {
        let start = self.at;
        let strange = |b: &u8| {
            CLASSES[*b as usize] == CharClass::Other && !matches!(b, b'(' | b';' | b'/' | b'%')
        };
        let rest = &self.text[start..self.end];
        self.at += rest.iter().take_while(|b| strange(b)).count().max(1);
        let range = TextRange::new(start as u32, self.at as u32);
        self.problem(block, || {
            let words = &self.text[start..self.at.min(start + 12)];
            let shown = String::from_utf8_lossy(words).into_owned();
            Diagnostic::new(
                Code::UnexpectedCharacter,
                range.in_file(self.file),
                format!("`{shown}` means nothing here"),
            )
            .help("remove it, or put it into a comment")
        });
    }

    #[cold]
    pub(super) fn problem(&self, block: &mut Block, make: impl FnOnce() -> Diagnostic) {
        if block.problems.len() < PROBLEMS_PER_BLOCK {
            block.problems.push(make());
        }
    }
}

/// Whether a token has the letter O instead of a zero: `1O.` in `X1O.Y5.`, `.O0` in `X4.O00F90.`, `-O.` in `Z-O.5F30.`.
/// The O is before a point or a digit; at the start of the token, only before a point.
fn is_packed_slip(token: &[u8]) -> bool {
    let is_within = |part: &[u8]| {
        matches!(part[0], b'0'..=b'9' | b'.' | b'+' | b'-')
            && matches!(part[1], b'O' | b'o')
            && matches!(part[2], b'0'..=b'9' | b'.')
    };
    matches!(token, [b'O' | b'o', b'.', ..]) || token.windows(3).any(is_within)
}
