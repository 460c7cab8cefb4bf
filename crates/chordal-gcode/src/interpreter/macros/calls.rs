//! Macro calls: G65, G66, G66.1, G67, and codes that call macros by a setting.

use chordal_command::Units;
use chordal_diagnostics::{Code, Diagnostic};
use chordal_dialect::macros::ArgumentScale;
use chordal_dialect::{Action, CallCode, LengthCode, ModeCode, OnceCode};
use chordal_dialect::{CodeGroup, DecimalPoint, FIRST_ALIAS_SUBPROGRAM, code_number};
use chordal_machine::AXIS_LETTERS;
use chordal_syntax::{Block, Decimal, Letters, Word, WordValue as Written};

use super::super::custom_codes::CustomCodeCall;
use super::super::{BlockFlow, Interpreter};
use crate::macros::arguments::{ArgumentAssigner, reserved_variable};
use crate::macros::evaluate::ValuePurpose;
use crate::macros::value::MacroValue;

/// An active modal call.
#[derive(Clone, Debug)]
pub(in super::super) struct ModalCall {
    /// The word that names the program, for later messages.
    word: Word,
    program: u32,
    repeats: u32,
    arguments: Vec<(u32, MacroValue)>,
    /// G66.1: every block calls, with its words as arguments.
    every_block: bool,
    /// An L word calls a subroutine, not a program.
    subroutine: bool,
}

/// The kind of call of a block.
enum BlockCall {
    Once,
    Modal {
        every_block: bool,
    },
    /// A code that a setting makes a call: the program, and whether it gets arguments.
    Alias {
        program: u32,
        arguments: bool,
    },
}

/// Letters whose words move.
const AXIS_WORDS: Letters = Letters::of(AXIS_LETTERS);

impl Interpreter<'_> {
    /// True when a block calls a macro with its words as arguments.
    pub(super) fn is_macro_call(&self, block: &Block) -> bool {
        self.rules().macro_b && (self.call_of(block).is_some() || self.calls_every_block())
    }

    fn calls_every_block(&self) -> bool {
        let active = self.macros.active;
        active > 0 && self.macros.modal.get(active - 1).is_some_and(|call| call.every_block)
    }

    /// The call of a block and its word.
    fn call_of(&self, block: &Block) -> Option<(BlockCall, usize)> {
        block.words.iter().enumerate().find_map(|(at, word)| {
            let code = match word.letter {
                b'G' | b'M' => code_number(word.number()?)?,
                _ => return None,
            };
            if let Some(call) = self.alias(word.letter, code) {
                return Some((call, at));
            }
            if word.letter == b'M' {
                return None;
            }
            let Action::Call(call) = self.control.g_code(code)?.action else { return None };
            match call {
                CallCode::MacroCall => Some((BlockCall::Once, at)),
                CallCode::ModalMacroCall { every_block } => {
                    Some((BlockCall::Modal { every_block }, at))
                }
                CallCode::CallProgram
                | CallCode::CallLabel
                | CallCode::Return
                | CallCode::SubroutineEnd => None,
            }
        })
    }

    /// The program that a setting assigns to a code. Inside a program that was called this way the code has its
    /// own meaning.
    fn alias(&self, letter: u8, code: u16) -> Option<BlockCall> {
        let aliases = &self.control.parameters.aliases;
        if !aliases.any || self.macros.in_alias > 0 || code == 0 {
            return None;
        }
        let find = |codes: &[u16]| codes.iter().position(|alias| *alias > 0 && *alias * 10 == code);
        let rules = self.rules();
        if letter == b'G' {
            let at = find(&aliases.g)? as u32;
            return Some(BlockCall::Alias {
                program: rules.g_alias_programs + at,
                arguments: true,
            });
        }
        if let Some(at) = find(&aliases.m) {
            let program = rules.m_alias_programs + at as u32;
            return Some(BlockCall::Alias { program, arguments: rules.m_alias_arguments });
        }
        let at = find(&aliases.m_subprogram)? as u32;
        Some(BlockCall::Alias { program: FIRST_ALIAS_SUBPROGRAM + at, arguments: false })
    }

    /// Carries out a block that calls a macro; `None` for another kind of block.
    pub(in super::super) fn macro_call(&mut self, block: &Block) -> Option<BlockFlow> {
        if !self.rules().macro_b {
            return None;
        }
        let Some((call, at)) = self.call_of(block) else { return self.block_in_modal_call(block) };
        self.codes_before_call(block, at);
        match call {
            BlockCall::Alias { program, arguments } => {
                self.call_alias(block, at, program, arguments)
            }
            BlockCall::Once => self.call_once(block, at),
            BlockCall::Modal { every_block } => self.begin_modal_call(block, at, every_block),
        }
        Some(BlockFlow::Next)
    }

    /// True for a word that acts before the call of its block: a modal code, F, M, S or T in front of the calling code.
    /// Words after that code are arguments.
    fn acts_before_call(&self, block: &Block, call: Option<usize>, at: usize) -> bool {
        let word = &block.words[at];
        if call.is_none_or(|call| at >= call) {
            return false;
        }
        match word.letter {
            b'F' | b'M' | b'S' | b'T' => true,
            b'G' => {
                let code = word.number().and_then(code_number);
                code.and_then(|code| self.control.g_code(code)).is_some_and(|row| {
                    matches!(
                        row.action,
                        Action::Reading(_)
                            | Action::Mode(_)
                            | Action::Motion(_)
                            | Action::NoEffect
                            | Action::NotSimulated
                            | Action::Length(LengthCode::Cancel)
                    )
                })
            }
            _ => false,
        }
    }

    /// Carries out the codes in front of a call in its block.
    fn codes_before_call(&mut self, block: &Block, at: usize) {
        let mut before = Block::new();
        (before.range, before.line) = (block.range, block.line);
        for (place, word) in block.words.iter().enumerate() {
            if self.acts_before_call(block, Some(at), place) {
                before.push(*word);
            }
        }
        if !before.words.is_empty() {
            self.carry_out(&before);
        }
    }

    fn call_once(&mut self, block: &Block, at: usize) {
        let Some((word, program, repeats)) = self.called_program(block, at) else { return };
        let arguments = self.arguments(block, Some(at), false);
        self.enter_macro(&word, program, repeats, &arguments);
    }

    /// P and L of a call: the word, the program and its repeats.
    fn called_program(&mut self, block: &Block, at: usize) -> Option<(Word, u32, u32)> {
        let Some(word) = block.last(b'P').copied() else {
            let code = block.words[at];
            let span = self.span(code.range);
            let message = "a macro call without a program number".to_string();
            self.kernel.missing_word(span, message, "write P and the program's number");
            return None;
        };
        let program = self.count(&word)?;
        let repeats = match block.letters().has(b'L') {
            true => self.count_of(block, b'L').unwrap_or(1),
            false => 1,
        };
        Some((word, program, repeats))
    }

    fn begin_modal_call(&mut self, block: &Block, at: usize, every_block: bool) {
        let Some((word, program, repeats)) = self.called_program(block, at) else { return };
        let arguments = self.arguments(block, Some(at), false);
        let active = self.macros.active;
        self.macros.modal.truncate(active);
        if active as u32 >= self.rules().call_depth {
            let limit = self.rules().call_depth;
            self.report_macro_nesting(&word, active as u32 + 1, limit);
            return;
        }
        self.macros.modal.push(ModalCall {
            word,
            program,
            repeats,
            arguments,
            every_block,
            subroutine: false,
        });
        self.macros.active = active + 1;
    }

    /// Fadal G66 L: a subroutine after every move; only one such call can be active.
    pub(in super::super) fn begin_modal_subroutine(&mut self, block: &Block, at: usize) {
        let Some(word) = block.last(b'L').copied() else {
            let span = self.span(block.words[at].range);
            let message = "G66 without a subroutine".to_string();
            return self.kernel.missing_word(
                span,
                message,
                "write L and the subroutine: `G66 L201`",
            );
        };
        let Some(program) = self.count(&word) else { return };
        self.macros.modal.clear();
        self.macros.modal.push(ModalCall {
            word,
            program,
            repeats: 1,
            arguments: Vec::new(),
            every_block: false,
            subroutine: true,
        });
        self.macros.active = 1;
    }

    /// G67: ends the last modal call.
    pub(in super::super) fn end_modal_call(&mut self) {
        let active = self.macros.active.saturating_sub(1);
        self.macros.modal.truncate(active);
        self.macros.active = active;
    }

    /// Carries out a block under G66.1, whose words are arguments; `None` for a block that is not a call.
    fn block_in_modal_call(&mut self, block: &Block) -> Option<BlockFlow> {
        if !self.calls_every_block() || self.ends_modal_call(block) {
            return None;
        }
        if block.words.iter().all(|word| word.letter == b'N') {
            return None;
        }
        let call = self.macros.modal[self.macros.active - 1].clone();
        let mut arguments = call.arguments.clone();
        arguments.extend(self.arguments(block, None, true));
        self.enter_modal(&call, &arguments);
        Some(BlockFlow::Next)
    }

    fn ends_modal_call(&self, block: &Block) -> bool {
        block.words.iter().any(|word| {
            let code = word.number().and_then(code_number);
            match word.letter {
                b'G' => code
                    .and_then(|code| self.control.g_code(code))
                    .is_some_and(|row| row.action == Action::Mode(ModeCode::ModalCallOff)),
                // A return or program end is not an argument.
                b'M' => code.and_then(|code| self.control.m_code(code)).is_some_and(|row| {
                    matches!(row.group, CodeGroup::Calling | CodeGroup::Stopping)
                }),
                _ => false,
            }
        })
    }

    /// Makes the active modal call after a block that moved.
    pub(in super::super) fn modal_call_after(
        &mut self,
        block: &Block,
        flow: BlockFlow,
    ) -> BlockFlow {
        let moved = block.letters().meets(AXIS_WORDS) && matches!(flow, BlockFlow::Next);
        if !moved || self.calls_every_block() || self.takes_axes_alone(block) {
            return flow;
        }
        let call = self.macros.modal[self.macros.active - 1].clone();
        let arguments = call.arguments.clone();
        self.enter_modal(&call, &arguments);
        flow
    }

    /// True when the axis words do not move: G10, G52, G92, G4.
    fn takes_axes_alone(&self, block: &Block) -> bool {
        block.all(b'G').any(|word| {
            let row = word.number().and_then(code_number).and_then(|c| self.control.g_code(c));
            row.is_some_and(|row| {
                matches!(
                    row.action,
                    Action::Once(OnceCode::SetData)
                        | Action::Once(OnceCode::LocalShift)
                        | Action::Once(OnceCode::PresetPosition)
                        | Action::Once(OnceCode::Dwell)
                )
            })
        })
    }

    /// M45: makes the active modal call at the present position; false when there is none.
    pub(in super::super) fn run_modal_call_here(&mut self) -> bool {
        let Some(outer) = self.macros.active.checked_sub(1) else { return false };
        let call = self.macros.modal[outer].clone();
        self.enter_modal(&call, &call.arguments);
        true
    }

    fn enter_modal(&mut self, call: &ModalCall, arguments: &[(u32, MacroValue)]) {
        let outer = self.macros.active - 1;
        if call.subroutine {
            let depth = self.frames.len();
            self.call_subroutine(&call.word, call.program);
            if self.frames.len() > depth {
                self.macros.active = outer;
            }
            return;
        }
        if self.enter_macro(&call.word, call.program, call.repeats, arguments) {
            // Moves inside make the call that was active before this one.
            self.macros.active = outer;
        }
    }

    fn call_alias(&mut self, block: &Block, at: usize, program: u32, with_arguments: bool) {
        let word = block.words[at];
        for word in &block.words {
            let value = word.number().map(Decimal::to_f64);
            self.macros.last_words[(word.letter - b'A') as usize] = value;
        }
        let entered = if with_arguments {
            let arguments = self.arguments(block, Some(at), false);
            self.enter_macro(&word, program, 1, &arguments)
        } else {
            let call = CustomCodeCall { block: Some(block), arguments: &[] };
            self.enter_program(&word, program, 1, call)
        };
        if entered {
            self.macros.in_alias += 1;
            if let Some(frame) = self.frames.last_mut() {
                frame.by_alias = true;
            }
        }
    }

    /// The words of a block as arguments: variable and value. Argument types I and II may be mixed; the later counts.
    fn arguments(
        &mut self,
        block: &Block,
        call: Option<usize>,
        all_letters: bool,
    ) -> Vec<(u32, MacroValue)> {
        let mut assigner = ArgumentAssigner::new(self.rules().argument_sets);
        let mut arguments: Vec<(u32, MacroValue)> = Vec::new();
        for (at, word) in block.words.iter().enumerate() {
            let own = matches!(word.letter, b'P' | b'L' | b'N' | b'O') && !all_letters;
            let acts = self.acts_before_call(block, call, at);
            if Some(at) == call || own || acts || word.letter == b'N' {
                continue;
            }
            let variable = match assigner.next(word.letter) {
                None if all_letters => reserved_variable(word.letter),
                other => other,
            };
            let Some(variable) = variable else {
                self.report_argument(word);
                continue;
            };
            let value = match word.value {
                Written::Expression(range) => self.word_value(range, ValuePurpose::VALUE),
                _ => self
                    .literal(word)
                    .map(|number| MacroValue::Number(self.argument(word.letter, number))),
            };
            // A vacant argument stays vacant and replaces an earlier value of the variable.
            arguments.retain(|(earlier, _)| *earlier != variable);
            if let Some(value) = value.filter(|value| *value != MacroValue::Vacant) {
                arguments.push((variable, value));
            }
        }
        arguments
    }

    fn report_argument(&mut self, word: &Word) {
        let letter = word.letter as char;
        self.report_once(
            Diagnostic::new(
                Code::BadArgument,
                self.span(word.range),
                format!("`{letter}` cannot be an argument here"),
            )
            .label("skipped")
            .help("G, L, N, O and P belong to the call; I, J and K come in at most ten sets"),
        );
    }

    /// The value of a literal argument; without a point it counts in least increments of its address.
    fn argument(&self, letter: u8, number: Decimal) -> f64 {
        let rules = self.rules();
        let parameters = &self.control.parameters;
        let whole = number.has_point
            || parameters.decimal_point == DecimalPoint::Calculator
            || rules.argument_scale == ArgumentScale::Whole
            || rules.whole_arguments.has(letter);
        if whole {
            return number.to_f64();
        }
        let angle = matches!(letter, b'A' | b'B' | b'C');
        let digits = match self.kernel.state.units {
            _ if angle && rules.argument_scale == ArgumentScale::LeastIncrement => 3,
            Units::Inch => parameters.rules.increment_digits_inch,
            Units::Millimetre => parameters.rules.increment_digits_mm,
        };
        number.times(1, digits)
    }

    /// Enters a macro with its own local variables; false when that was not possible.
    fn enter_macro(
        &mut self,
        word: &Word,
        program: u32,
        repeats: u32,
        arguments: &[(u32, MacroValue)],
    ) -> bool {
        let depth = self.macros.store.level() + 1;
        let limit = self.rules().call_depth;
        if depth > limit {
            self.report_macro_nesting(word, depth, limit);
            return false;
        }
        let known: Vec<(u32, f64)> = arguments
            .iter()
            .filter_map(|(number, value)| Some((*number, value.known()?)))
            .collect();
        let call = CustomCodeCall { block: None, arguments: &known };
        if !self.enter_program(word, program, repeats, call) {
            return false;
        }
        self.macros.store.enter(arguments);
        if let Some(frame) = self.frames.last_mut() {
            frame.own_locals = true;
        }
        true
    }

    fn enter_program(
        &mut self,
        word: &Word,
        number: u32,
        repeats: u32,
        call: CustomCodeCall<'_>,
    ) -> bool {
        let Some(program) = self.library.find(number, self.file) else {
            return self.shop_program(word, number, repeats, call).unwrap_or_else(|| {
                self.report_missing_program(word, number);
                false
            });
        };
        let start = self.library.programs()[program].head.start;
        let repeats = self.cut_to_limit(word, repeats);
        repeats > 0 && self.enter(word, program, start, repeats, false)
    }

    fn report_macro_nesting(&mut self, word: &Word, depth: u32, limit: u32) {
        self.report_once(
            Diagnostic::new(
                Code::MacroNesting,
                self.span(word.range),
                format!("this macro call would be {depth} levels deep; the control allows {limit}"),
            )
            .label("not called")
            .help("a macro that calls itself never returns; check the calls above"),
        );
    }
}
