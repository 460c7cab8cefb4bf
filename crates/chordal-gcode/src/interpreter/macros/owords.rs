//! Flow control by O words (LinuxCNC "O Codes").
//!
//! One pass finds the flow-control lines of a program when the first of them is reached, and links each with the
//! lines of its structure, so that a jump is a table lookup. Labels are local to their subroutine.

use std::collections::{BTreeMap, HashMap};
use std::rc::Rc;

use chordal_diagnostics::{Code, Diagnostic, Severity, TextRange};
use chordal_syntax::{
    Block, BlockKind, BlockPosition as TextPosition, BlockReader, ExpressionParser, FlowWord,
    OLabel, OWord, Word, WordValue as Written, parse_o_word,
};

mod labels;

use super::super::{BlockFlow, EndReason, Interpreter};
use super::ConditionOf;
use crate::macros::evaluate::ValuePurpose;
use crate::macros::names::normalized;
use crate::macros::value::MacroValue;

/// Largest number of arguments of a call.
const MAX_ARGUMENTS: usize = 30;

/// Index of no line.
const NONE: usize = usize::MAX;

/// A line of flow control.
#[derive(Clone, Copy, PartialEq, Debug)]
struct FlowLine {
    /// Its start.
    at: TextPosition,
    /// The start of the next line.
    after: TextPosition,
    word: FlowWord,
    /// Index of the first line of its structure, or its own.
    open: usize,
    /// Index of the next line of its structure.
    next: usize,
    /// Index of the last line of its structure.
    close: usize,
    /// Index of an earlier line with the same label.
    same: usize,
}

/// The flow-control lines of a program.
#[derive(Debug, Default)]
struct FlowIndex {
    lines: Vec<FlowLine>,
    /// Subroutines by label.
    subs: HashMap<String, usize>,
}

/// A running `repeat`.
#[derive(Clone, Copy, PartialEq, Debug)]
struct ActiveRepeat {
    /// The call depth.
    depth: usize,
    line: usize,
    remaining: u64,
}

/// The state of O words.
#[derive(Debug)]
pub(super) struct OWords {
    indexes: HashMap<usize, Rc<FlowIndex>>,
    /// Lines of each program that contain only a label (`O5`).
    heads: HashMap<usize, Vec<(u32, TextPosition)>>,
    /// The first program of each file, by the name of the file.
    files: Option<HashMap<String, usize>>,
    repeats: Vec<ActiveRepeat>,
    /// Labels that calls have found, by program and number.
    pub called: BTreeMap<(usize, u32), TextPosition>,
    /// The value that the last subroutine returned.
    pub value: MacroValue,
    /// The last subroutine returned a value.
    pub value_returned: bool,
}

impl Default for OWords {
    fn default() -> OWords {
        OWords {
            indexes: HashMap::new(),
            heads: HashMap::new(),
            files: None,
            repeats: Vec::new(),
            called: BTreeMap::new(),
            value: MacroValue::Number(0.0),
            value_returned: false,
        }
    }
}

impl OWords {
    /// True when no `repeat` is running.
    pub fn is_settled(&self) -> bool {
        self.repeats.is_empty()
    }
}

/// The label in the form for comparison: numbers without leading zeros.
fn label_text(text: &[u8]) -> String {
    let name = normalized(text);
    let name = name.trim();
    match name.parse::<u64>() {
        Ok(number) => number.to_string(),
        Err(_) => name.to_string(),
    }
}

impl FlowIndex {
    fn of<'a>(mut reader: BlockReader<'a>, mut parser: ExpressionParser<'a>) -> FlowIndex {
        let mut index = FlowIndex::default();
        // Lines of open structures, by subroutine and label.
        let mut open: HashMap<(usize, String), Vec<usize>> = HashMap::new();
        let mut labels: HashMap<(usize, String), usize> = HashMap::new();
        let mut sub = NONE;
        let mut block = Block::new();
        let text = reader.text();
        while reader.read(&mut block) {
            let BlockKind::Macro(range) = block.kind else { continue };
            if !range.slice(text).first().is_some_and(|b| b.eq_ignore_ascii_case(&b'O')) {
                continue;
            }
            parser.start(text, parser.file(), range);
            let OWord { label: OLabel::Text(label), word: Some(word), .. } =
                parse_o_word(&mut parser)
            else {
                continue;
            };
            let here = index.lines.len();
            let at = TextPosition { offset: block.range.start, line: block.line };
            let after = reader.position();
            index.lines.push(FlowLine {
                at,
                after,
                word,
                open: here,
                next: NONE,
                close: NONE,
                same: NONE,
            });
            let label = label_text(label.slice(text));
            let scope = match word {
                FlowWord::Sub => {
                    sub = here;
                    index.subs.entry(label.clone()).or_insert(here);
                    NONE
                }
                FlowWord::EndSub => {
                    sub = NONE;
                    NONE
                }
                FlowWord::Call | FlowWord::Return => continue,
                _ => sub,
            };
            // A subroutine may have the same label as a loop or branch outside of it.
            if !matches!(word, FlowWord::Sub | FlowWord::EndSub) {
                let first = *labels.entry((scope, label.clone())).or_insert(here);
                index.lines[here].same = if first == here { NONE } else { first };
            }
            index.join(open.entry((scope, label)).or_default(), here);
        }
        index
    }

    /// Links a line with the open structure of its label.
    fn join(&mut self, open: &mut Vec<usize>, here: usize) {
        let first = open.first().map(|first| self.lines[*first].word);
        let word = self.lines[here].word;
        let closes = match word {
            FlowWord::EndSub => first == Some(FlowWord::Sub),
            FlowWord::EndIf => first == Some(FlowWord::If),
            FlowWord::EndWhile => first == Some(FlowWord::While),
            FlowWord::EndRepeat => first == Some(FlowWord::Repeat),
            FlowWord::While => first == Some(FlowWord::Do),
            _ => false,
        };
        let begins = matches!(
            word,
            FlowWord::Sub | FlowWord::If | FlowWord::While | FlowWord::Do | FlowWord::Repeat
        );
        if begins && !closes {
            open.clear();
            open.push(here);
            return;
        }
        if let Some(last) = open.last() {
            self.lines[*last].next = here;
            self.lines[here].open = open[0];
        }
        open.push(here);
        if closes {
            for line in open.drain(..) {
                self.lines[line].close = here;
            }
        }
    }

    fn at(&self, offset: u32) -> Option<usize> {
        self.lines.binary_search_by_key(&offset, |line| line.at.offset).ok()
    }
}

impl<'a> Interpreter<'a> {
    /// A line of flow control.
    pub(super) fn flow_line(&mut self, range: TextRange) -> BlockFlow {
        let mut parser = self.take_parser();
        parser.start(self.reader.text(), self.file, range);
        let line = parse_o_word(&mut parser);
        let flow = match line.word {
            Some(FlowWord::Call) => self.call_sub(&mut parser, &line),
            Some(FlowWord::EndSub | FlowWord::Return) => self.return_value(&mut parser, &line),
            Some(_) if matches!(line.label, OLabel::Computed(_)) => {
                self.report_structure(&line, "a computed O word can only call a subroutine");
                BlockFlow::Next
            }
            Some(word) => self.structure(&mut parser, &line, word),
            None => BlockFlow::Next,
        };
        self.report_problems(&mut parser);
        self.macros.parser = parser;
        flow
    }

    fn index(&mut self, program: usize) -> Rc<FlowIndex> {
        self.look_at(program);
        if let Some(index) = self.macros.owords.indexes.get(&program) {
            return index.clone();
        }
        let lexicon = self.control.table.lexicon;
        let reader = self.reader_of(program);
        let file = self.program_at(program).file;
        let parser = ExpressionParser::new(reader.text(), file, lexicon.grammar);
        let index = Rc::new(FlowIndex::of(reader, parser));
        self.macros.owords.indexes.insert(program, index.clone());
        index
    }

    /// True when the value after the word is not zero.
    fn bracket_holds(&mut self, parser: &mut ExpressionParser<'a>, of: ConditionOf) -> bool {
        let start = parser.rest();
        let value = self.bracket(parser, ValuePurpose::CONDITION);
        value.is_some_and(|value| self.is_true(value, start, of))
    }

    /// The value of the required bracket here; `None` when it has none, which is reported.
    fn bracket(
        &mut self,
        parser: &mut ExpressionParser<'a>,
        purpose: ValuePurpose,
    ) -> Option<MacroValue> {
        let problems = parser.problems.len();
        let value = parser.value();
        if parser.problems.len() > problems {
            return None;
        }
        self.value_of(parser, value, purpose)
    }

    fn structure(
        &mut self,
        parser: &mut ExpressionParser<'a>,
        line: &OWord,
        word: FlowWord,
    ) -> BlockFlow {
        let index = self.index(self.program);
        let Some(here) = index.at(self.kernel.origin.span.range.start) else {
            return BlockFlow::Next;
        };
        let row = index.lines[here];
        let holds = match word {
            FlowWord::If => self.bracket_holds(parser, ConditionOf::Branch),
            FlowWord::While => self.bracket_holds(parser, ConditionOf::Loop),
            _ => false,
        };
        if !matches!(word, FlowWord::Repeat | FlowWord::ElseIf) {
            self.check_line_end(parser);
        }
        self.check_label(&index, line, here);
        match word {
            FlowWord::Sub if self.is_again(&index, line, here) => BlockFlow::Next,
            FlowWord::Sub => self.after(&index, line, row.close),
            FlowWord::If if holds => BlockFlow::Next,
            FlowWord::If => self.next_branch(parser, &index, line, row.next),
            // Reached from above: the previous branch was taken.
            FlowWord::ElseIf | FlowWord::Else => self.after(&index, line, row.close),
            FlowWord::Do => BlockFlow::Next,
            FlowWord::EndIf if row.open != here => BlockFlow::Next,
            FlowWord::While if row.open != here => match holds {
                // The end of do … while.
                true => self.after(&index, line, row.open),
                false => BlockFlow::Next,
            },
            FlowWord::While if holds => BlockFlow::Next,
            FlowWord::While => self.after(&index, line, row.close),
            FlowWord::EndWhile if row.open != here => {
                self.go_to(index.lines[row.open].at);
                BlockFlow::Next
            }
            FlowWord::Repeat => self.begin_repeat(parser, &index, line, here),
            FlowWord::EndRepeat if row.open != here => self.end_repeat(&index, line, here),
            FlowWord::Break if row.open != here => {
                if index.lines[row.open].word == FlowWord::Repeat {
                    self.report_structure(line, "break belongs in while and do, not in repeat");
                }
                self.drop_repeat(row.open);
                self.after(&index, line, row.close)
            }
            FlowWord::Continue if row.open != here && row.close != NONE => {
                if index.lines[row.open].word == FlowWord::Repeat {
                    self.report_structure(line, "continue belongs in while and do, not in repeat");
                }
                // On its way to the end of a `do`, the control carries out a break that it passes.
                let breaks = |line: &usize| index.lines[*line].word == FlowWord::Break;
                let ahead = |line: &usize| Some(index.lines[*line].next).filter(|n| *n != NONE);
                let mut passed = std::iter::successors(ahead(&here), ahead);
                if index.lines[row.open].word == FlowWord::Do && passed.any(|line| breaks(&line)) {
                    self.report_passed_break(line);
                    return self.after(&index, line, row.close);
                }
                self.go_to(index.lines[row.close].at);
                BlockFlow::Next
            }
            _ => {
                self.report_structure(line, "no structure with this label is open here");
                BlockFlow::Next
            }
        }
    }

    /// Continues after a line.
    fn after(&mut self, index: &FlowIndex, line: &OWord, to: usize) -> BlockFlow {
        match index.lines.get(to) {
            Some(row) => {
                self.go_to(row.after);
                BlockFlow::Next
            }
            None => {
                self.report_structure(line, "this structure is not closed");
                BlockFlow::End(EndReason::LostJump)
            }
        }
    }

    /// Continues with the next branch of an IF whose condition holds.
    fn next_branch(
        &mut self,
        parser: &mut ExpressionParser<'a>,
        index: &FlowIndex,
        line: &OWord,
        mut next: usize,
    ) -> BlockFlow {
        while let Some(row) = index.lines.get(next) {
            let taken = match row.word {
                FlowWord::Else | FlowWord::EndIf => true,
                FlowWord::ElseIf => {
                    self.report_problems(parser);
                    let counts = !self.frames.is_empty() || self.repeat_until != 0;
                    if counts && !self.kernel.count_repeated() {
                        return BlockFlow::End(EndReason::Budget);
                    }
                    let rest = TextRange::new(row.at.offset, row.after.offset);
                    parser.start(self.reader.text(), self.file, rest);
                    // Numbers before the O word.
                    let text = rest.slice(self.reader.text());
                    let o = text.iter().position(|b| b.eq_ignore_ascii_case(&b'O')).unwrap_or(0);
                    parser.go_to(TextRange::new(rest.start + o as u32, rest.end));
                    parse_o_word(parser);
                    self.bracket_holds(parser, ConditionOf::Branch)
                }
                _ => false,
            };
            if taken {
                return self.after(index, line, next);
            }
            next = row.next;
        }
        self.after(index, line, NONE)
    }

    fn begin_repeat(
        &mut self,
        parser: &mut ExpressionParser<'a>,
        index: &FlowIndex,
        line: &OWord,
        here: usize,
    ) -> BlockFlow {
        let times = match self.bracket(parser, ValuePurpose::VALUE).map(MacroValue::counted) {
            Some(Ok(times)) => times,
            Some(Err(cause)) => {
                self.lose_path_by(line.range, "how often this is repeated", cause);
                0.0
            }
            None => 0.0,
        };
        self.drop_repeat(here);
        // Half is rounded to the even number.
        let times = libm::rint(times);
        if times < 1.0 {
            return self.after(index, line, index.lines[here].close);
        }
        let depth = self.frames.len();
        let repeat = ActiveRepeat { depth, line: here, remaining: times as u64 };
        self.macros.owords.repeats.push(repeat);
        BlockFlow::Next
    }

    fn end_repeat(&mut self, index: &FlowIndex, line: &OWord, here: usize) -> BlockFlow {
        let open = index.lines[here].open;
        let depth = self.frames.len();
        let repeats = &mut self.macros.owords.repeats;
        let running = repeats.iter_mut().rfind(|r| r.depth == depth && r.line == open);
        let Some(repeat) = running else { return BlockFlow::Next };
        repeat.remaining -= 1;
        if repeat.remaining == 0 {
            self.drop_repeat(open);
            return BlockFlow::Next;
        }
        self.after(index, line, open)
    }

    /// Ends a repeat, and those inside it.
    fn drop_repeat(&mut self, line: usize) {
        let depth = self.frames.len();
        let repeats = &mut self.macros.owords.repeats;
        while repeats.pop_if(|last| (last.depth, last.line) >= (depth, line)).is_some() {}
    }

    fn call_sub(&mut self, parser: &mut ExpressionParser<'a>, line: &OWord) -> BlockFlow {
        let label = match line.label {
            OLabel::Text(range) => label_text(range.slice(self.reader.text())),
            OLabel::Computed(expression) => {
                let what = "the subroutine that is called";
                match self.number_of(parser, expression, ValuePurpose::VALUE, what) {
                    Some(number) => libm::round(number).to_string(),
                    None => return BlockFlow::Next,
                }
            }
        };
        let mut arguments = Vec::new();
        while parser.next_mark_after_comments() == b'[' {
            let Some(value) = self.bracket(parser, ValuePurpose::VALUE) else {
                return BlockFlow::Next;
            };
            arguments.push((arguments.len() as u32 + 1, value));
        }
        self.check_line_end(parser);
        if arguments.len() > MAX_ARGUMENTS {
            let count = arguments.len();
            self.report_once(
                Diagnostic::new(
                    Code::BadArgument,
                    self.span(line.range),
                    format!("{count} arguments are more than the {MAX_ARGUMENTS} of a call"),
                )
                .help("pass more values in #31 and above, or in named variables"),
            );
            return BlockFlow::Next;
        }
        let Some((program, start)) = self.find_sub(&label) else {
            self.report_once(
                Diagnostic::new(
                    Code::MissingSubprogram,
                    self.span(line.range),
                    format!(
                        "there is no subroutine `{label}` in this file, and no file {label}.ngc"
                    ),
                )
                .label("the call is skipped")
                .help(format!("write `o<{label}> sub`, or put it into the file {label}.ngc")),
            );
            return BlockFlow::Next;
        };
        let depth = self.frames.len();
        let repeats = &mut self.macros.owords.repeats;
        while repeats.pop_if(|last| last.depth > depth).is_some() {}
        let word = Word {
            letter: b'O',
            register: None,
            comma: false,
            value: Written::Missing,
            range: line.range,
        };
        if self.enter(&word, program, start, 1, false) {
            self.macros.store.enter(&arguments);
            self.macros.names.enter();
            self.macros.owords.value = MacroValue::Number(0.0);
            self.macros.owords.value_returned = false;
            if let Some(frame) = self.frames.last_mut() {
                frame.own_locals = true;
            }
        }
        BlockFlow::Next
    }

    /// The program and the first line of a subroutine: in this file, else in the file with its name.
    fn find_sub(&mut self, label: &str) -> Option<(usize, TextPosition)> {
        let here = self.program;
        if let Some(start) = self.sub_of(here, label) {
            return Some((here, start));
        }
        let library = self.library;
        let files = self.macros.owords.files.get_or_insert_with(|| library.files_by_name());
        let other = *files.get(label)?;
        self.sub_of(other, label).map(|start| (other, start))
    }

    /// The first line and the last line of a subroutine of this file.
    pub(in super::super) fn lines_of_sub(
        &mut self,
        label: &str,
    ) -> Option<(TextPosition, TextPosition)> {
        let index = self.index(self.program);
        let line = &index.lines[*index.subs.get(label)?];
        let end = index.lines.get(line.close)?;
        Some((line.after, end.at))
    }

    fn sub_of(&mut self, program: usize, label: &str) -> Option<TextPosition> {
        let index = self.index(program);
        let line = *index.subs.get(label)?;
        Some(index.lines[line].after)
    }

    /// `endsub [v]` and `return [v]`.
    fn return_value(&mut self, parser: &mut ExpressionParser<'a>, line: &OWord) -> BlockFlow {
        if !self.frames.last().is_some_and(|frame| frame.own_locals) {
            self.report_once(
                Diagnostic::new(
                    Code::ReturnWithoutCall,
                    self.span(line.range),
                    "a return where no subroutine was called",
                )
                .severity(Severity::Error)
                .alarm(format!("{}: not in a subroutine definition", self.control.table.title))
                .help("call the subroutine; its lines do not run by themselves"),
            );
            return BlockFlow::Next;
        }
        if parser.next_mark() == b'[' {
            let value = self.bracket(parser, ValuePurpose::VALUE);
            self.macros.owords.value = value.unwrap_or(MacroValue::Number(0.0));
            self.macros.owords.value_returned = true;
        }
        self.leave(None);
        BlockFlow::Next
    }

    fn report_structure(&mut self, line: &OWord, message: &str) {
        self.report_once(Diagnostic::new(Code::LoopMismatch, self.span(line.range), message).help(
            "each sub, if, while, do and repeat is closed by a line with the same label: \
                 endsub, endif, endwhile, while, endrepeat",
        ));
    }
}
