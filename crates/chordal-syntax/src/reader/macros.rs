//! Finds the beginning and the end of expressions and statements of macro languages in a block.

use super::*;
use crate::program_name::scan_program_name;

impl BlockReader<'_> {
    /// Whether the letter O at `self.at` begins flow control: a number, a name or a bracket, and then a word.
    #[cold]
    pub(super) fn flow_control(&self) -> bool {
        let line = &self.text[self.at + 1..self.end];
        let line = &line[..memchr::memchr2(b'\n', b'\r', line).unwrap_or(line.len())];
        let blank = |b: &u8| CLASSES[*b as usize] == CharClass::Blank;
        let mut at = line.iter().take_while(|b| blank(b)).count();
        match line.get(at) {
            Some(b'<' | b'#') => return true,
            Some(b'[') => {
                let mut depth = 0usize;
                for byte in &line[at..] {
                    at += 1;
                    match byte {
                        b'[' => depth += 1,
                        b']' => depth = depth.saturating_sub(1),
                        _ => {}
                    }
                    if depth == 0 {
                        break;
                    }
                }
            }
            _ => {
                let number = |b: &u8| b.is_ascii_digit() || blank(b);
                at += line[at..].iter().take_while(|b| number(b)).count();
            }
        }
        line[at..].iter().find(|b| !blank(b)).is_some_and(u8::is_ascii_alphabetic)
    }

    /// Reads `<NAME>`: the head of a program if only an N number is before it; in a call, the program that is called.
    #[cold]
    pub(super) fn program_name(&mut self, block: &mut Block) {
        let Some((number, length)) = scan_program_name(&self.text[self.at..self.end]) else {
            return self.unexpected(block);
        };
        let is_head = block.words.iter().all(|word| word.letter == b'N');
        let letter = if is_head { b'O' } else { b'P' };
        let range = TextRange::new(self.at as u32, (self.at + length) as u32);
        self.at += length;
        let value = WordValue::Number(Decimal::integer(i64::from(number)));
        block.push(Word { letter, register: None, comma: false, value, range });
    }

    /// The number of an N word that is directly followed by a statement or the head of a program: `N900#3000=1`,
    /// `N10[#1EQ2]M99`, `N1O75(BOX)`.
    #[cold]
    pub(super) fn number_of_packed_block(&mut self) -> Option<Decimal> {
        let rest = &self.text[self.at..self.end];
        let digits = rest.iter().take_while(|b| b.is_ascii_digit()).count();
        let number = Decimal::parse(&rest[..digits])?;
        let packed = match rest.get(digits)? {
            b'#' | b'[' => true,
            // `N1O0 G1`, with words after it, is a typing mistake.
            b'O' | b'o' => {
                let after = &rest[digits + 1..];
                let head = after.iter().take_while(|b| b.is_ascii_digit()).count();
                let mut next = after[head..].iter().filter(|b| !matches!(b, b' ' | b'\t'));
                head > 0 && matches!(next.next(), None | Some(b'(' | b';' | b'*' | b'\n' | b'\r'))
            }
            _ => false,
        };
        packed.then(|| {
            self.at += digits;
            number
        })
    }

    /// Whether the letters from `start` are a keyword of a macro language.
    pub(super) fn keyword(&self, start: usize) -> bool {
        const KEYWORDS: [&str; 27] = [
            "IF", "WHILE", "WH", "GOTO", "GO", "END", "DO", "THEN", "ELSE", "DPRNT", "BPRNT",
            "POPEN", "PCLOS", "SETVN", "SUB", "ENDSUB", "CALL", "RETURN", "REPEAT", "PRINT",
            "INPUT", "AX", "MSG", "BREAK", "CONTINUE", "ENDIF", "VC",
        ];
        let rest = &self.text[start..self.end];
        let letters = rest.iter().take_while(|b| b.is_ascii_alphabetic()).take(12);
        let word: String = letters.map(|b| b.to_ascii_uppercase() as char).collect();
        KEYWORDS.iter().any(|keyword| word == *keyword)
    }

    /// Goes to the end of a macro statement: the end of the line, or a semicolon outside of brackets and comments if
    /// that ends a block.
    pub(super) fn skip_statement(&mut self) {
        if self.lexicon.semicolon == Semicolon::Comment {
            return self.skip_to_line_end();
        }
        let mut depth = 0usize;
        while self.at < self.end {
            match self.text[self.at] {
                b'[' | b'(' => depth += 1,
                b']' | b')' => depth = depth.saturating_sub(1),
                b';' if depth == 0 => return,
                b'\n' | b'\r' => return,
                _ => {}
            }
            self.at += 1;
        }
    }

    /// Whether there is a function of the control with its bracket (`SIN[30.]`) at `at`.
    pub(super) fn function_at(&self, at: usize) -> bool {
        let rest = &self.text[at..self.end];
        let letters = rest.iter().take_while(|b| b.is_ascii_alphabetic()).count();
        let open = self.lexicon.grammar.bracket_bytes().0;
        let following = rest[letters..].iter().find(|b| !matches!(b, b' ' | b'\t'));
        let known = |(name, _): &(&str, _)| rest[..letters].eq_ignore_ascii_case(name.as_bytes());
        following == Some(&open) && self.lexicon.grammar.functions.iter().any(known)
    }

    /// Finds the end of `#12`, `#[…]`, `[…]` or `SIN[…]`, with a sign. Brackets are matched; the end of the line closes
    /// all. The expression itself is read when the block is executed.
    pub(super) fn expression(&mut self) -> WordValue {
        let start = self.at;
        self.operand();
        // `X#1+10.`: a sum without brackets.
        while !self.lexicon.grammar.operators_in_brackets_only
            && matches!(self.peek(), b'+' | b'-')
            && matches!(
                self.text[..self.end].get(self.at + 1),
                Some(b'#' | b'[' | b'0'..=b'9' | b'.')
            )
        {
            self.operand();
        }
        WordValue::Expression(TextRange::new(start as u32, self.at as u32))
    }

    pub(super) fn operand(&mut self) {
        let blank = |b: u8| CLASSES[b as usize] == CharClass::Blank;
        while self.at < self.end
            && (matches!(self.peek(), b'+' | b'-' | b'#') || blank(self.peek()))
        {
            self.at += 1;
        }
        match self.peek() {
            b'<' if self.lexicon.grammar.names => {
                let rest = &self.text[self.at..self.end];
                let end = memchr::memchr3(b'>', b'\n', b'\r', rest).unwrap_or(rest.len());
                self.at += end + usize::from(rest.get(end) == Some(&b'>'));
            }
            b'[' => self.brackets(),
            byte if byte.is_ascii_alphabetic() => {
                while self.peek().is_ascii_alphabetic() || blank(self.peek()) {
                    self.at += 1;
                }
                self.brackets();
                if self.peek() == b'/' && self.text[..self.end].get(self.at + 1) == Some(&b'[') {
                    self.at += 1;
                    self.brackets();
                }
            }
            _ => {
                while matches!(self.peek(), b'0'..=b'9' | b'.') {
                    self.at += 1;
                }
            }
        }
    }

    /// Goes from an opening bracket past the one that closes it.
    pub(super) fn brackets(&mut self) {
        let mut depth = 0usize;
        while self.at < self.end && !matches!(self.text[self.at], b'\n' | b'\r') {
            match self.text[self.at] {
                b'[' => depth += 1,
                b']' => depth = depth.saturating_sub(1),
                _ => {}
            }
            self.at += 1;
            if depth == 0 {
                return;
            }
        }
    }
}
