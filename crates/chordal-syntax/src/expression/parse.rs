//! Compiles the expressions of a line to steps.

use chordal_diagnostics::{Code, Diagnostic, FileId, TextRange};

use super::{BracketStyle, Expression, ExpressionStep, Function, MacroGrammar, StackOp};
use crate::decimal;

/// The deepest nesting of brackets on any control, so that the recursion of the parser is bounded.
const HARD_DEPTH: u32 = 64;

/// The largest number of problems that are reported in one line.
const PROBLEMS_PER_LINE: usize = 4;

/// Compiles expressions of one line to steps. Its memory is reused for the next line.
#[derive(Clone, Debug)]
pub struct ExpressionParser<'a> {
    pub(crate) text: &'a [u8],
    pub(crate) file: FileId,
    pub(crate) grammar: &'static MacroGrammar,
    pub(crate) at: usize,
    pub(crate) end: usize,
    steps: Vec<ExpressionStep>,
    depth: u32,
    deepest: u32,
    /// Diagnostics for text that could not be read.
    pub problems: Vec<Diagnostic>,
}

impl<'a> ExpressionParser<'a> {
    /// A parser for a text.
    pub fn new(text: &'a [u8], file: FileId, grammar: &'static MacroGrammar) -> Self {
        ExpressionParser {
            text,
            file,
            grammar,
            at: 0,
            end: 0,
            steps: Vec::new(),
            depth: 0,
            deepest: 0,
            problems: Vec::new(),
        }
    }

    /// Discards the steps and begins to read at `range`.
    pub fn start(&mut self, text: &'a [u8], file: FileId, range: TextRange) {
        self.text = text;
        self.file = file;
        self.steps.clear();
        self.problems.clear();
        self.go_to(range);
    }

    /// Continues to read at `range` and keeps the steps.
    pub fn go_to(&mut self, range: TextRange) {
        self.end = (range.end as usize).min(self.text.len());
        self.at = (range.start as usize).min(self.end);
        self.depth = 0;
        self.deepest = 0;
    }

    /// The grammar of the control.
    pub fn grammar(&self) -> &'static MacroGrammar {
        self.grammar
    }

    /// The file that the text is in.
    pub fn file(&self) -> FileId {
        self.file
    }

    /// The current position in the text, in bytes.
    pub fn position(&self) -> u32 {
        self.at as u32
    }

    /// The steps of an expression.
    pub fn steps(&self, expression: Expression) -> &[ExpressionStep] {
        &self.steps[expression.first as usize..expression.end as usize]
    }

    /// The rest of the line.
    pub fn rest(&self) -> TextRange {
        TextRange::new(self.at as u32, self.end as u32)
    }

    pub(crate) fn peek(&self) -> u8 {
        if self.at < self.end { self.text[self.at] } else { b'\n' }
    }

    /// The next byte that is not a blank, which is not consumed.
    pub fn next_mark(&mut self) -> u8 {
        while matches!(self.peek(), b' ' | b'\t' | 0 | 0x0b | 0x0c | 0x11..=0x14 | 0x1a | 0x7f)
            && self.at < self.end
        {
            self.at += 1;
        }
        self.peek()
    }

    /// True if the next byte that is not a blank is `byte`, which is then consumed.
    pub fn take(&mut self, byte: u8) -> bool {
        let found = self.next_mark() == byte && self.at < self.end;
        self.at += usize::from(found);
        found
    }

    /// True if the text continues with `word` in any case, which is then consumed.
    pub fn take_text(&mut self, word: &str) -> bool {
        self.next_mark();
        let found = self.begins_with(word);
        if found {
            self.at += word.len();
        }
        found
    }

    /// The same, also with blanks between the letters of `word`.
    pub(crate) fn take_spread(&mut self, word: &str) -> bool {
        self.next_mark();
        let mut at = self.at;
        for letter in word.bytes() {
            while at < self.end && matches!(self.text[at], b' ' | b'\t') {
                at += 1;
            }
            if at >= self.end || !self.text[at].eq_ignore_ascii_case(&letter) {
                return false;
            }
            at += 1;
        }
        self.at = at;
        true
    }

    /// The next byte that is neither a blank nor in a comment.
    pub fn next_mark_after_comments(&mut self) -> u8 {
        while self.next_mark() == b'(' && self.at < self.end {
            let rest = &self.text[self.at..self.end];
            self.at += rest.iter().position(|b| *b == b')').map_or(rest.len(), |at| at + 1);
        }
        self.peek()
    }

    pub(crate) fn begins_with(&self, word: &str) -> bool {
        let rest = &self.text[self.at..self.end];
        rest.get(..word.len()).is_some_and(|head| head.eq_ignore_ascii_case(word.as_bytes()))
    }

    /// Reads a whole expression with its operators.
    pub fn expression(&mut self) -> Expression {
        self.begin(|parser| parser.binary(0))
    }

    /// Reads one value: a number, a variable, a bracket or a function, with its signs.
    pub fn value(&mut self) -> Expression {
        self.begin(Self::unary)
    }

    fn begin(&mut self, read: impl FnOnce(&mut Self)) -> Expression {
        self.next_mark();
        let (first, start) = (self.steps.len() as u32, self.at as u32);
        self.deepest = 0;
        read(self);
        let range = TextRange::new(start, (self.at as u32).max(start));
        if let Some(limit) = self.grammar.bracket_limit
            && self.deepest > u32::from(limit)
        {
            let deepest = self.deepest;
            self.problem(Code::BracketsTooDeep, range, |d| {
                d.label("nested too deep")
                    .help(format!("this control reads {limit} levels; compute a part of it before"))
                    .note(format!(
                        "the brackets are {deepest} levels deep, those of functions included"
                    ))
            });
        }
        Expression { first, end: self.steps.len() as u32, range }
    }

    /// Reads the target of an assignment: the number of the variable, without the step that reads its value. That step is
    /// returned separately and shows the kind of the variable; `None` if there is no variable.
    pub fn variable(&mut self) -> (Expression, Option<StackOp>) {
        let mut whole = self.begin(Self::primary);
        let last = self.steps.last().map(|step| step.op).filter(|_| !whole.is_empty());
        match last {
            Some(op @ (StackOp::Read | StackOp::ReadNamed(_) | StackOp::Letters(_))) => {
                self.steps.pop();
                whole.end -= 1;
                (whole, Some(op))
            }
            _ => (whole, None),
        }
    }

    fn push(&mut self, op: StackOp, start: usize) {
        let range = TextRange::new(start as u32, self.at as u32);
        self.steps.push(ExpressionStep { op, range });
    }

    /// Reads operands joined by operators of at least a level. The loop takes operators of equal level from the left,
    /// so a long sum needs no recursion.
    fn binary(&mut self, level: u8) {
        self.next_mark();
        let start = self.at;
        self.unary();
        if self.grammar.operators_in_brackets_only && self.depth == 0 {
            return;
        }
        while let Some(row) = self.operator().filter(|row| row.level > level) {
            self.at += row.text.len();
            self.binary(row.level);
            self.push(StackOp::Binary(row.operator), start);
        }
    }

    fn operator(&mut self) -> Option<&'static super::OperatorRow> {
        let mark = self.next_mark().to_ascii_uppercase();
        let rows = self.grammar.operators;
        rows.iter().find(|row| row.text.as_bytes()[0] == mark && self.begins_with(row.text))
    }

    fn unary(&mut self) {
        self.next_mark();
        let start = self.at;
        let mut negative = false;
        while matches!(self.next_mark(), b'-' | b'+') {
            negative ^= self.peek() == b'-';
            self.at += 1;
        }
        self.primary();
        if negative {
            self.push(StackOp::Negate, start);
        }
    }

    fn primary(&mut self) {
        let (open, _) = self.grammar.bracket_bytes();
        let mark = self.next_mark();
        let start = self.at;
        match mark {
            b'#' => self.hash(start),
            b'0'..=b'9' | b'.' => self.number(start),
            _ if mark == open => self.bracket(),
            _ if mark.is_ascii_alphabetic() => self.name(start),
            _ => self.missing(start),
        }
    }

    fn number(&mut self, start: usize) {
        match decimal::scan(&self.text[self.at..self.end]) {
            Some((number, length)) => {
                self.at += length;
                self.push(StackOp::Number(number.to_f64()), start);
            }
            None => {
                let digits = |b: &u8| b.is_ascii_digit() || *b == b'.';
                let rest = &self.text[self.at..self.end];
                let length = rest.iter().take_while(|b| digits(b)).count();
                self.at += length.max(1);
                let long = std::str::from_utf8(&rest[..length]).ok();
                let long = long.and_then(|text| text.parse::<f64>().ok());
                if let Some(number) = long.filter(|_| self.grammar.names) {
                    return self.push(StackOp::Number(number), start);
                }
                self.push(StackOp::Unreadable, start);
                let range = TextRange::new(start as u32, self.at as u32);
                self.problem(Code::BadExpression, range, |d| d.label("this is not a number"));
            }
        }
    }

    /// `[…]`.
    fn bracket(&mut self) {
        let (_, close) = self.grammar.bracket_bytes();
        let start = self.at;
        self.at += 1;
        self.depth += 1;
        self.deepest = self.deepest.max(self.depth);
        if self.depth > HARD_DEPTH {
            self.at = self.end;
            self.push(StackOp::Unreadable, start);
            let range = TextRange::new(start as u32, start as u32 + 1);
            self.problem(Code::BracketsTooDeep, range, |d| {
                d.label("the rest of the line is not read").help("no control allows so many levels")
            });
        } else {
            self.binary(0);
            self.close(start, close);
        }
        self.depth -= 1;
    }

    fn close(&mut self, start: usize, close: u8) {
        if self.take(close) {
            return;
        }
        let range = TextRange::new(start as u32, start as u32 + 1);
        let at = TextRange::new(self.at as u32, self.at as u32);
        let file = self.file;
        let mark = close as char;
        self.problem(Code::UnbalancedBrackets, range, |d| {
            d.label("this bracket is not closed")
                .also(at.in_file(file), "reading stopped here")
                .help(format!("close it with `{mark}`"))
        });
        // Continues after the bracket, so that unreadable text in it is not reported again.
        if let Some(found) = self.text[self.at..self.end].iter().position(|b| *b == close) {
            self.at += found + 1;
        }
    }

    /// `#1`, `#[…]`, `##1`, `#<name>`.
    fn hash(&mut self, start: usize) {
        let mut marks = 0usize;
        while self.take(b'#') {
            marks += 1;
        }
        if marks > 1 && !self.grammar.chained {
            let range = TextRange::new(start as u32, self.at as u32);
            self.problem(Code::UnsupportedMacro, range, |d| {
                d.label("`##` is not known here").help("write `#[#1]`")
            });
        }
        let (open, _) = self.grammar.bracket_bytes();
        match self.next_mark() {
            b'0'..=b'9' => {
                let digits_at = self.at;
                let rest = &self.text[self.at..self.end];
                let digits = rest.iter().take_while(|b| b.is_ascii_digit()).count();
                // Decimals are read too, so that `#1.5` is not read as #1.
                let decimals = match rest.get(digits) {
                    Some(b'.') => {
                        rest[digits + 1..].iter().take_while(|b| b.is_ascii_digit()).count()
                    }
                    _ => 0,
                };
                let length = if decimals > 0 { digits + 1 + decimals } else { digits };
                self.at += length;
                let number = std::str::from_utf8(&rest[..length]).ok();
                let index = number.and_then(|text| text.parse().ok()).unwrap_or(f64::INFINITY);
                self.push(StackOp::Number(index), digits_at);
            }
            b'+' | b'-' if self.grammar.names => self.unary(),
            mark if mark == open => self.bracket(),
            b'<' if self.grammar.names => return self.named(start, marks),
            mark if mark.is_ascii_alphabetic() && self.grammar.names => self.name(start),
            _ => {
                self.push(StackOp::Unreadable, start);
                let range = TextRange::new(start as u32, self.at as u32);
                self.problem(Code::BadExpression, range, |d| {
                    d.label("which variable?").help("write its number after the `#`")
                });
                return;
            }
        }
        for _ in 0..marks {
            self.push(StackOp::Read, start);
        }
    }

    fn named(&mut self, start: usize, marks: usize) {
        self.at += 1;
        let name = self.at;
        let rest = &self.text[self.at..self.end];
        match rest.iter().position(|b| *b == b'>') {
            Some(length) => {
                self.at += length + 1;
                let name = TextRange::new(name as u32, (name + length) as u32);
                self.push(StackOp::ReadNamed(name), start);
                for _ in 1..marks {
                    self.push(StackOp::Read, start);
                }
            }
            None => {
                self.at = self.end;
                self.push(StackOp::Unreadable, start);
                let range = TextRange::new(start as u32, name as u32);
                self.problem(Code::BadExpression, range, |d| {
                    d.label("this name is not closed").help("close it with `>`")
                });
            }
        }
    }

    /// Reads a function, or a variable that is written with letters.
    fn name(&mut self, start: usize) {
        let letters = self.text[self.at..self.end].iter().take_while(|b| b.is_ascii_alphabetic());
        let length = letters.count();
        if let Some(function) = self.function(length) {
            self.at += length;
            return self.call(function, start);
        }
        let variables = self.grammar.letter_variables;
        let found =
            variables.iter().position(|name| name.len() == length && self.begins_with(name));
        if let Some(index) = found {
            self.at += length;
            return self.letter_variable(index, start);
        }
        self.at += length;
        self.push(StackOp::Unreadable, start);
        let range = TextRange::new(start as u32, self.at as u32);
        let known: Vec<&str> = self.grammar.functions.iter().map(|(name, _)| *name).collect();
        self.problem(Code::UnsupportedMacro, range, |d| {
            d.label("not a function of this control").help(format!("it has {}", known.join(", ")))
        });
        // The arguments of an unknown function would only give further problems.
        if self.next_mark() == self.grammar.bracket_bytes().0 {
            let problems = self.problems.len();
            let steps = self.steps.len();
            self.bracket();
            self.problems.truncate(problems);
            self.steps.truncate(steps);
        }
    }

    fn function(&self, length: usize) -> Option<Function> {
        let word = &self.text[self.at..self.at + length];
        let exact =
            self.grammar.functions.iter().find(|(name, _)| {
                name.len() == length && word.eq_ignore_ascii_case(name.as_bytes())
            });
        let short = || {
            let two = length == 2 && self.grammar.abbreviations;
            const CUT: [&str; 3] = ["ROUND", "FIX", "FUP"];
            let cut = |name: &str| CUT.contains(&name) && self.begins_with(&name[..2]);
            self.grammar.functions.iter().find(|(name, _)| two && cut(name))
        };
        exact.or_else(short).map(|(_, function)| *function)
    }

    fn call(&mut self, function: Function, start: usize) {
        let (open, close) = self.grammar.bracket_bytes();
        let mut two = false;
        if function == Function::Not {
            // NOT binds less tightly than a comparison: `NOT V1=2`.
            self.within_limit(start, |parser| parser.binary(1));
            return self.push(StackOp::Call { function, two }, start);
        }
        if self.next_mark() != open {
            // `SIN#1`: some programs omit the brackets, and most controls accept that.
            self.within_limit(start, Self::unary);
            return self.push(StackOp::Call { function, two }, start);
        }
        let bracket = self.at;
        self.at += 1;
        self.depth += 1;
        self.deepest = self.deepest.max(self.depth);
        if self.depth > HARD_DEPTH {
            self.depth -= 1;
            self.at = bracket;
            self.bracket();
        } else {
            self.binary(0);
            if self.take(b',') {
                two = true;
                self.binary(0);
            }
            self.close(bracket, close);
            self.depth -= 1;
        }
        let takes_two = matches!(function, Function::Atan | Function::Parameter);
        let before = self.at;
        if takes_two && !two && self.take(b'/') {
            if self.next_mark() == open {
                two = true;
                self.bracket();
            } else {
                self.at = before;
            }
        }
        self.push(StackOp::Call { function, two }, start);
    }

    fn within_limit(&mut self, start: usize, read: impl FnOnce(&mut Self)) {
        self.depth += 1;
        if self.depth > HARD_DEPTH {
            self.at = self.end;
            self.push(StackOp::Unreadable, start);
        } else {
            read(self);
        }
        self.depth -= 1;
    }

    /// `V1`, `V(V2+1)`, `G(1)`.
    fn letter_variable(&mut self, index: usize, start: usize) {
        let (open, _) = self.grammar.bracket_bytes();
        match self.next_mark() {
            b'0'..=b'9' => self.number(self.at),
            mark if mark == open => self.bracket(),
            // `VF`, `AX`: there is only one such variable.
            _ => self.push(StackOp::Number(0.0), start),
        }
        self.push(StackOp::Letters(index as u8), start);
    }

    fn missing(&mut self, start: usize) {
        self.push(StackOp::Unreadable, start);
        let mark = self.peek();
        let shown = self.at < self.end && self.grammar.brackets == BracketStyle::Square;
        let end = start as u32 + u32::from(self.at < self.end);
        self.problem(Code::BadExpression, TextRange::new(start as u32, end), |d| {
            let d = d.label("a value is missing here");
            if shown && mark == b'(' {
                d.help("brackets of expressions are `[` and `]`; `(` begins a comment")
            } else {
                d.help("a value is a number, a variable, a function or a bracket")
            }
        });
    }

    pub(crate) fn problem(
        &mut self,
        code: Code,
        range: TextRange,
        add: impl FnOnce(Diagnostic) -> Diagnostic,
    ) {
        if self.problems.len() >= PROBLEMS_PER_LINE {
            return;
        }
        let message = match code {
            Code::UnbalancedBrackets => "the brackets of this expression do not match",
            Code::BracketsTooDeep => "the brackets of this expression are nested too deep",
            Code::UnsupportedMacro => "this control does not have this form",
            Code::BadStatement => "this macro statement cannot be read",
            _ => "this expression cannot be read",
        };
        let diagnostic = Diagnostic::new(code, range.in_file(self.file), message);
        self.problems.push(add(diagnostic));
    }
}
