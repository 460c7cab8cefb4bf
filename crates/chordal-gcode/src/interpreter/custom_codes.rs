//! Custom M codes and programs: calls the answering hook and carries out its answer.

use chordal_command::{CommandKind, SpindleState};
use chordal_dialect::{Action, AfterCode, CallCode};
use chordal_dialect::{CodeGroup, CodeRow};
use chordal_kernel::{CustomCode, ShopAnswer, ShopCall};
use std::collections::HashMap;
use std::sync::Arc;

use chordal_diagnostics::{Code, Diagnostic, FileId, TextRange};
use chordal_syntax::{Block, BlockPosition as TextPosition, Decimal, Letters, ProgramHead, Word};

use super::Interpreter;
use super::literals::AXIS_OF;
use crate::library::Program;

/// The row of a code that the table does not contain. Letters that no other code uses are its words.
static SHOP_CODE: CodeRow = CodeRow {
    code: 0,
    group: CodeGroup::Auxiliary,
    action: Action::After(AfterCode::ShopCode),
    words: Letters::of("EIJKLPQRUVW"),
    title: "a custom M code",
};

/// The interpreter's state of custom codes.
pub(super) struct ShopState {
    main: usize,
    question_count: u32,
    /// The answers for the current block, by the index of their word.
    answers: Vec<(usize, CustomCode, ShopAnswer)>,
    /// An unknown M code uses the words of the current block as macro arguments.
    pub takes_words: bool,
    /// Texts received as answers.
    programs: Vec<Program>,
    by_file: HashMap<FileId, usize>,
}

/// What is passed with a call: the words of its block, or the macro arguments.
#[derive(Clone, Copy)]
pub(super) struct CustomCodeCall<'g> {
    pub block: Option<&'g Block>,
    pub arguments: &'g [(u32, f64)],
}

impl ShopState {
    pub fn new(main: usize) -> ShopState {
        ShopState {
            main,
            question_count: 0,
            answers: Vec::new(),
            takes_words: false,
            programs: Vec::new(),
            by_file: HashMap::new(),
        }
    }

    /// Forgets the answers for the previous block.
    #[inline]
    pub fn begin_block(&mut self) {
        self.answers.clear();
        self.takes_words = false;
    }

    /// The program of an answered text.
    pub fn program(&self, index: usize) -> Program {
        self.programs[index]
    }

    fn take(&mut self, at: usize) -> Option<(CustomCode, ShopAnswer)> {
        let place = self.answers.iter().position(|(place, ..)| *place == at)?;
        let (_, code, answer) = self.answers.swap_remove(place);
        Some((code, answer))
    }

    fn runs_text(&self, at: usize) -> bool {
        let text = |answer: &ShopAnswer| matches!(answer, ShopAnswer::Text(_));
        self.answers.iter().any(|(place, _, answer)| *place == at && text(answer))
    }
}

impl Interpreter<'_> {
    /// The row of an M code that the hook or the machine file answers; it is called here, before the block moves.
    pub(super) fn shop_row(
        &mut self,
        block: &Block,
        at: usize,
        tenths: u16,
    ) -> Option<&'static CodeRow> {
        let code = CustomCode::M(tenths);
        let answer = self.ask_shop(code, CustomCodeCall { block: Some(block), arguments: &[] });
        if answer == ShopAnswer::NotMine {
            return None;
        }
        self.shop.answers.push((at, code, answer));
        Some(&SHOP_CODE)
    }

    /// The row of an M code without any definition, on controls where it may be the machine builder's. It is reported
    /// once and moves nothing.
    pub(super) fn open_m_code(
        &mut self,
        block: &Block,
        at: usize,
        number: Decimal,
    ) -> Option<&'static CodeRow> {
        let word = &block.words[at];
        let is_open = self.control.table.open_m_codes && word.letter == b'M';
        let number = number.to_integer().filter(|number| is_open && *number >= 0)?;
        if self.waits_for_path(word, number) {
            return Some(&SHOP_CODE);
        }
        if self.calls_with_words(block, at) {
            self.shop.takes_words = true;
            self.report_call_with_words(word, number);
            return Some(&SHOP_CODE);
        }
        if self.reported.open_codes.insert(number) {
            let title = self.control.table.title;
            self.kernel.report(
                Diagnostic::new(
                    Code::NotSimulated,
                    self.span(word.range),
                    format!("{title} has no M{number}: what it does is up to the machine builder or the shop"),
                )
                .label("taken as a code that moves nothing and takes no time")
                .help(format!(
                    "say in the machine file what it does: `[shop_codes.M{number}]` with `label`, `time` or \
                     `blocks`"
                )),
            );
        }
        Some(&SHOP_CODE)
    }

    /// True when the words after an unknown M code are probably arguments of a macro. Then the code comes first and the
    /// block has no G code, which cannot be an argument; a code of the machine builder comes after the axis words.
    fn calls_with_words(&self, block: &Block, at: usize) -> bool {
        let axes = self.control.axes();
        let is_axis = |word: &Word| {
            let axis = AXIS_OF[usize::from(word.letter)] as usize;
            let axis = if axis < 6 { Some(axis) } else { self.increment_axis(word) };
            axis.is_some_and(|axis| axes.has(axis)) && !word.comma
        };
        let first = block.words.iter().position(is_axis);
        first.is_some_and(|first| at < first) && !block.letters().has(b'G')
    }

    fn report_call_with_words(&mut self, word: &Word, number: i64) {
        // Reported every time, as each loses its axis words.
        self.reported.open_codes.insert(number);
        let title = self.control.table.title;
        let message = format!(
            "{title} has no M{number}: with axis words after it, it is taken as the call of a macro, which is not followed"
        );
        self.kernel.report(
            Diagnostic::new(Code::NotFollowed, self.span(word.range), message)
                .label("its words are arguments; from here on the path is not known")
                .help(format!(
                    "say in the machine file what it does: `[shop_codes.M{number}]` with `label`, `time` or \
                     `blocks`; if the axes move in this block, write their words before the M code"
                )),
        );
    }

    /// Carries out the answer for the code at a word index of its block.
    pub(super) fn carry_out_shop_code(
        &mut self,
        block: &Block,
        codes: &[(&'static CodeRow, usize)],
        at: usize,
    ) {
        let word = block.words[at];
        let Some((code, answer)) = self.shop.take(at) else { return };
        let adjacent = codes.iter().find(|(row, place)| {
            *place != at && (leaves_block_order(row.action) || self.shop.runs_text(*place))
        });
        if let (ShopAnswer::Text(_), Some((_, other))) = (&answer, adjacent) {
            let other = self.span(block.words[*other].range);
            self.kernel.report(
                Diagnostic::new(
                    Code::NotAlone,
                    self.span(word.range),
                    format!("{code} runs custom blocks, together with a code that jumps or calls"),
                )
                .label("not carried out")
                .also(other, "this code jumps or calls")
                .help("write two blocks"),
            );
            return;
        }
        self.take_shop_answer(&word, code, answer, 1);
    }

    /// Calls the hook for a program that no text contains. `None` when it has no answer, otherwise true when a text was
    /// entered.
    pub(super) fn shop_program(
        &mut self,
        word: &Word,
        number: u32,
        repeats: u32,
        call: CustomCodeCall<'_>,
    ) -> Option<bool> {
        let code = CustomCode::Program(number);
        let answer = self.ask_shop(code, call);
        if answer == ShopAnswer::NotMine {
            return None;
        }
        let repeats = self.cut_to_limit(word, repeats);
        Some(repeats > 0 && self.take_shop_answer(word, code, answer, repeats))
    }

    /// The answer of the run's hook, else of the machine file.
    fn ask_shop(&mut self, code: CustomCode, call: CustomCodeCall<'_>) -> ShopAnswer {
        if let Some(shop) = &self.options.shop_codes {
            let words = self.passed_words(call.block);
            let sources = self.library.sources();
            let block = self.kernel.origin.span;
            let turns = matches!(self.kernel.state.spindle, SpindleState::Cw | SpindleState::Ccw);
            let answer = shop.answer(&ShopCall {
                code,
                main: self.shop.main,
                nth: self.shop.question_count,
                block,
                file: sources.get(block.file).map_or("", |source| source.name()),
                line: self.kernel.origin.line,
                text: &sources.words(block),
                words: &words,
                arguments: call.arguments,
                tool: self.kernel.state.tool,
                position: self.kernel.state.position,
                known: self.kernel.state.known,
                units: self.kernel.state.units,
                incremental: self.kernel.state.incremental,
                spindle_rpm: if turns { self.kernel.state.rpm } else { 0.0 },
            });
            self.shop.question_count += 1;
            if answer != ShopAnswer::NotMine {
                return answer;
            }
        }
        let own = match code {
            CustomCode::M(tenths) if tenths.is_multiple_of(10) => {
                self.machine.shop_codes.get(&(tenths / 10))
            }
            CustomCode::M(_) => None,
            CustomCode::Program(number) => self.machine.shop_programs.get(&number),
        };
        own.map_or(ShopAnswer::NotMine, |own| match &own.blocks {
            Some(blocks) => ShopAnswer::text(blocks),
            None => ShopAnswer::Wait {
                seconds: own.time_s.unwrap_or(0.0),
                label: own.label.as_deref().map(Arc::from),
            },
        })
    }

    fn passed_words(&self, block: Option<&Block>) -> Vec<(char, f64)> {
        let words = block.map_or(&[][..], |block| &block.words);
        let own = words.iter().filter(|word| word.letter != b'N');
        own.filter_map(|word| Some((char::from(word.letter), self.literal(word)?.to_f64())))
            .collect()
    }

    /// True when a text was entered.
    fn take_shop_answer(
        &mut self,
        word: &Word,
        code: CustomCode,
        answer: ShopAnswer,
        repeats: u32,
    ) -> bool {
        match answer {
            ShopAnswer::NotMine => false,
            ShopAnswer::Wait { seconds, label } => {
                self.shop_wait(word, code, seconds * f64::from(repeats), label);
                false
            }
            ShopAnswer::Refused(why) => {
                self.refuse_shop_code(word, code, &why);
                false
            }
            ShopAnswer::Text(text) => self.enter_shop_text(word, code, &text, repeats),
        }
    }

    fn shop_wait(&mut self, word: &Word, code: CustomCode, seconds: f64, label: Option<Arc<str>>) {
        if !(seconds >= 0.0 && seconds.is_finite()) {
            return self.refuse_shop_code(
                word,
                code,
                &format!("a time of {seconds} s is not possible"),
            );
        }
        if seconds > 0.0 {
            let label = label.unwrap_or_else(|| Arc::from(code.to_string()));
            self.kernel.emit(CommandKind::Dwell { seconds, label: Some(label) });
        }
    }

    fn refuse_shop_code(&mut self, word: &Word, code: CustomCode, why: &str) {
        self.kernel.report(
            Diagnostic::new(
                Code::ShopCodeRefused,
                self.span(word.range),
                format!("the rule for the custom code {code} refuses it: {why}"),
            )
            .label("not carried out")
            .help(format!("correct the block, or the rule for {code}")),
        );
    }

    /// Enters a received text as a subprogram.
    fn enter_shop_text(&mut self, word: &Word, code: CustomCode, text: &str, repeats: u32) -> bool {
        let Some(file) = self.library.sources().append(&format!("custom code {code}"), text) else {
            let why = "its blocks are more text than a run accepts (10,000 texts, 64 MiB)";
            self.refuse_shop_code(word, code, why);
            return false;
        };
        let index = self.shop_program_index(file, code, text.len() as u32);
        let start = self.program_at(index).head.start;
        let entered = self.enter(word, index, start, repeats, false);
        if let (true, Some(frame)) = (entered, self.frames.last_mut()) {
            frame.of_shop = true;
        }
        entered
    }

    /// The program index of a text in this run; each text has one, so that its labels are searched once.
    fn shop_program_index(&mut self, file: FileId, code: CustomCode, end: u32) -> usize {
        let own = self.library.programs().len();
        let programs = &mut self.shop.programs;
        let place = *self.shop.by_file.entry(file).or_insert_with(|| {
            let number = match code {
                CustomCode::Program(number) => Some(number),
                CustomCode::M(_) => None,
            };
            let start = TextPosition { offset: 0, line: 1 };
            let head = ProgramHead { number, head: TextRange::new(0, 0), start, end };
            programs.push(Program { file, head });
            programs.len() - 1
        });
        own + place
    }
}

/// Codes that jump or return, in whose block a custom text would not run at the right moment.
fn leaves_block_order(action: Action) -> bool {
    matches!(
        action,
        Action::After(AfterCode::ProgramEnd { .. })
            | Action::Call(CallCode::CallProgram)
            | Action::Call(CallCode::CallLabel)
            | Action::Call(CallCode::Return)
            | Action::Call(CallCode::SubroutineEnd)
    )
}
