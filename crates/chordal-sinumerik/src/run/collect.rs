//! Statements → the words of a block, and the statements that stand alone in their block.

use chordal_command::CommandKind;
use chordal_diagnostics::{Code, Diagnostic, Severity, TextRange};
use chordal_kernel::EndReason;
use chordal_machine::AXIS_NAMES;

use super::interpreter::Interpreter;
use super::run_state::{BlockFlow, MAIN_SPINDLE};
use super::transformations::TRANSFORMATIONS;
use super::unknown_values::UnknownUse;
use super::words::{BlockWords, CENTER_NAMES, OTHER_ADDRESSES, ToolWord, ValueWord};
use crate::syntax::{
    AddressWord, CallStatement, Expression, ExpressionKind, ProgramBlock, StatementKind,
    ValueFunction, WordValue,
};
use crate::values::SinumerikValue;
use crate::vocabulary::{IGNORED_CALLS, is_known_name};

/// From this number on SETAL shows an alarm of the user.
const FIRST_USER_ALARM: f64 = 65_000.0;

/// Addresses that change the path and are not carried out.
const UNFOLLOWED_ADDRESSES: &[&str] = &["OFFN", "TOFFL", "TOFFR", "DISR", "DISCL", "DISC"];

/// Indexed addresses that move an axis by itself.
const POSITIONING_AXES: &[&str] = &["POS", "POSA", "POSP"];

/// Indexed addresses that change neither the path nor the position.
const IGNORED_INDEXED: &[&str] = &[
    "FA", "ACC", "OVRA", "VELOLIM", "ACCLIMA", "JERKLIM", "SPOS", "SPOSA", "FXS", "FXST", "FXSW",
    "FOC",
];

impl Interpreter<'_> {
    /// Carries out a block that calls something; `None` for other blocks.
    pub(super) fn call_statement(&mut self, block: &ProgramBlock) -> Option<BlockFlow> {
        for statement in &block.statements {
            match &statement.kind {
                StatementKind::Call(call) if TRANSFORMATIONS.contains(&call.name.as_str()) => {
                    self.transformation_call(call);
                    return (block.statements.len() == 1).then_some(BlockFlow::Next);
                }
                StatementKind::Call(call) => {
                    let is_known =
                        IGNORED_CALLS.contains(&call.name.as_str()) || call.name == "SETAL";
                    if !is_known {
                        self.check_call_alone(block, statement.range, &call.name);
                    }
                    return self.called(block, call);
                }
                StatementKind::ModalCall(call) => {
                    self.check_call_alone(block, statement.range, "MCALL");
                    self.set_modal_call(call.as_ref());
                    return Some(BlockFlow::Next);
                }
                StatementKind::IndirectCall(call) => {
                    return Some(self.indirect_call(statement.range, call));
                }
                StatementKind::Word(word) if word.address.name == "L" && !word.has_equals => {
                    self.check_call_alone(block, statement.range, "a call");
                    return Some(self.call_l(block, statement.range));
                }
                StatementKind::Name(name) if name == "SETMS" => self.choose_master_spindle(None),
                StatementKind::Name(name)
                    if IGNORED_CALLS.contains(&name.as_str())
                        && self.programs.find_name(name).is_none() => {}
                StatementKind::Name(name) if !is_known_name(name) => {
                    let is_alone = block.statements.len() == 1;
                    if self.programs.find_name(name).is_none() && !self.is_cycle(name) && !is_alone
                    {
                        continue;
                    }
                    let call = CallStatement {
                        name: name.clone(),
                        range: statement.range,
                        arguments: None,
                    };
                    let passes = self.passes(block);
                    return Some(self.call(&call, passes));
                }
                _ => {}
            }
        }
        None
    }

    /// `TRACYL(40)`: the arguments are numbers.
    fn transformation_call(&mut self, call: &CallStatement) {
        let arguments = call.arguments.as_deref().unwrap_or_default();
        let numbers: Vec<Option<f64>> = arguments
            .iter()
            .map(|argument| argument.as_ref().and_then(|number| self.number(number)))
            .collect();
        if call.name == "TRAFOOF" && !numbers.is_empty() {
            self.alarm(12090, Code::BadStatement, call.range, "TRAFOOF has no parameters");
        }
        self.choose_transformation(&call.name, &numbers, call.range);
    }

    /// `P3` of a call; `None` without.
    fn passes(&mut self, block: &ProgramBlock) -> Option<u32> {
        block.statements.iter().find_map(|statement| match &statement.kind {
            StatementKind::Word(word) if word.address.name == "P" => match &word.value {
                WordValue::Plain(value) => Some(self.count(value).unwrap_or(0)),
                _ => None,
            },
            _ => None,
        })
    }

    /// `L10`: the program L10; leading zeros count, so the name is that of the text.
    fn call_l(&mut self, block: &ProgramBlock, range: TextRange) -> BlockFlow {
        let name = String::from_utf8_lossy(range.slice(self.text())).to_ascii_uppercase();
        let call = CallStatement { name, range, arguments: None };
        let passes = self.passes(block);
        self.call(&call, passes)
    }

    /// A name with arguments: a message, a cycle, a program.
    fn called(&mut self, block: &ProgramBlock, call: &CallStatement) -> Option<BlockFlow> {
        let first = call.arguments.as_ref().and_then(|arguments| arguments.first()?.as_ref());
        match call.name.as_str() {
            "MSG" => {
                if let Some(Expression { range, kind: ExpressionKind::Text(_) }) = first {
                    self.kernel.emit(CommandKind::Message(*range));
                } else if let Some(text) = first {
                    // A text that is put together: its names must be defined.
                    self.value(text);
                }
                // A message may stand with other words in a block.
                (block.statements.len() == 1).then_some(BlockFlow::Next)
            }
            "SETMS" => {
                let number = first.and_then(|number| self.number(number));
                self.choose_master_spindle(number);
                (block.statements.len() == 1).then_some(BlockFlow::Next)
            }
            "SETAL" => {
                let number = first.and_then(|number| self.number(number)).unwrap_or(0.0);
                let span = self.span(call.range);
                let message = format!("the program shows the alarm {number}");
                let diagnostic = Diagnostic::new(Code::ProgramAlarm, span, message);
                if number >= FIRST_USER_ALARM {
                    self.report_alarm(number as u32, diagnostic);
                    return Some(BlockFlow::End(EndReason::Alarm));
                }
                self.kernel.report(diagnostic.severity(Severity::Warning));
                Some(BlockFlow::Next)
            }
            name if IGNORED_CALLS.contains(&name) && self.programs.find_name(name).is_none() => {
                Some(BlockFlow::Next)
            }
            _ => {
                let passes = self.passes(block);
                Some(self.call(call, passes))
            }
        }
    }

    /// The words of a block with their values.
    pub(super) fn collect(&mut self, block: &ProgramBlock) -> BlockWords {
        let mut words = BlockWords::default();
        for statement in &block.statements {
            match &statement.kind {
                StatementKind::Word(word) => self.take_word(&mut words, word, statement.range),
                StatementKind::Name(name) => {
                    if is_known_name(name) {
                        words.names.push((name.clone(), statement.range));
                    } else if !IGNORED_CALLS.contains(&name.as_str()) {
                        self.variables.undefined.push((name.clone(), statement.range));
                        self.report_undefined_names();
                    }
                }
                StatementKind::SynchronousAction => {
                    self.lose_path(statement.range, "what follows", "the synchronous action");
                }
                _ => {}
            }
        }
        for (name, word) in &words.others {
            let acts = UNFOLLOWED_ADDRESSES.contains(name) && word.value != 0.0;
            if acts {
                self.not_followed(word.range, format!("{name} is not followed"));
            }
        }
        words
    }

    fn take_word(&mut self, words: &mut BlockWords, word: &AddressWord, range: TextRange) {
        let address = &word.address;
        let name = &*address.name;
        if !address.indices.is_empty() || address.name.starts_with('$') || name == "R" {
            return self.assign_or_index(words, word, range);
        }
        if name == "T" {
            return self.take_tool(words, word, range);
        }
        let Some(kind) = AddressKind::of(name, address.extension) else {
            if matches!(name, "A" | "B" | "C") && matches!(address.extension, Some(2 | 4..=7)) {
                if self.is_first_report("tool direction") {
                    self.not_followed(
                        range,
                        "this way to give the direction of the tool is not followed",
                    );
                }
                return;
            }
            return self.assign(address, &word.value);
        };
        if matches!(name, "S" | "M")
            && let Some(spindle) = address.extension.filter(|number| *number != MAIN_SPINDLE)
        {
            return self.take_spindle_word(words, spindle, word, range);
        }
        let used_for = match kind {
            AddressKind::Axis(axis) => UnknownUse::Axis(axis),
            _ => UnknownUse::of_address(name),
        };
        let Some(value) = self.word_value(words, name, used_for, &word.value, range) else {
            return;
        };
        let slot = match kind {
            AddressKind::GCode => {
                return words.g_codes.push((value.value.round().max(0.0) as u32, range));
            }
            AddressKind::MCode => {
                return words.m_codes.push((value.value.round().max(0.0) as u32, range));
            }
            AddressKind::Axis(axis) => &mut words.axes[axis],
            AddressKind::Center(axis) => &mut words.centers[axis],
            AddressKind::Between(axis) => &mut words.between[axis],
            AddressKind::Direction(axis) => &mut words.directions[axis],
            AddressKind::Other(known) => {
                if words.other(known).is_some() {
                    let message = format!("{known} is programmed twice in this block");
                    return self.alarm(12010, Code::RepeatedWord, range, message);
                }
                return words.others.push((known, value));
            }
        };
        if slot.is_some() {
            let message = format!("{name} is programmed twice in this block");
            return self.alarm(12010, Code::RepeatedWord, range, message);
        }
        *slot = Some(value);
    }

    /// `R5=…`, `$TC_DP6[1,1]=…`, `NAME[2]=…`; `LIMS[2]=`, `AX[…]=` and other indexed addresses of the control are taken as
    /// their address.
    fn assign_or_index(&mut self, words: &mut BlockWords, word: &AddressWord, range: TextRange) {
        let name = &*word.address.name;
        let known = OTHER_ADDRESSES.iter().copied().find(|known| *known == name);
        match known.filter(|_| self.variables.named(name).is_none()) {
            Some(known) => {
                let used_for = UnknownUse::of_address(name);
                let value = self.word_value(words, name, used_for, &word.value, range);
                if let Some(value) = value {
                    words.others.push((known, value));
                }
            }
            None if POSITIONING_AXES.contains(&name) && self.variables.named(name).is_none() => {
                let moved = word.address.indices.first().and_then(|axis| match &axis.kind {
                    ExpressionKind::Variable(axis) => {
                        AXIS_NAMES.iter().position(|own| *own == axis.name)
                    }
                    _ => None,
                });
                match moved {
                    Some(axis) => words.positioned.insert(axis),
                    None => self.lose_path(range, "what moves", "the axis of the machine"),
                }
            }
            None if IGNORED_INDEXED.contains(&name) && self.variables.named(name).is_none() => {}
            None => self.assign(&word.address, &word.value),
        }
    }

    fn take_tool(&mut self, words: &mut BlockWords, word: &AddressWord, range: TextRange) {
        let WordValue::Plain(expression) = &word.value else { return };
        let tool = match self.value(expression) {
            Some(SinumerikValue::Text(name)) => ToolWord::Name(name.to_string()),
            Some(SinumerikValue::Unknown(cause)) => {
                self.lose_path(range, "T", &cause);
                ToolWord::Name(cause.to_string())
            }
            Some(value) => match value.to_real() {
                Ok(number) if (0.0..=f64::from(u32::MAX)).contains(&number) => {
                    ToolWord::Number(number.round() as u32)
                }
                _ => {
                    return self.alarm(
                        17190,
                        Code::BadWordValue,
                        range,
                        "this is no number of a tool",
                    );
                }
            },
            None => return,
        };
        words.tool = Some((tool, range));
    }

    /// The value of a word; `None` if it has none, or none that is known, which is reported.
    pub(super) fn word_value(
        &mut self,
        words: &mut BlockWords,
        name: &str,
        used_for: UnknownUse,
        value: &WordValue,
        range: TextRange,
    ) -> Option<ValueWord> {
        let (function, expression): (Option<ValueFunction>, &Expression) = match value {
            WordValue::Plain(expression) => (None, expression),
            WordValue::Function(function, expression) => (Some(*function), expression),
            WordValue::Set(_) | WordValue::Repeated(_) => return None,
        };
        let value = self.value(expression)?;
        if let Some(cause) = value.unknown_cause() {
            self.take_unknown_word(words, name, range, used_for, cause);
            return None;
        }
        let value = self.number_of(&value, expression.range)?;
        Some(ValueWord { value, function, range })
    }
}

/// What an address with a number is.
#[derive(Clone, Copy)]
enum AddressKind {
    GCode,
    MCode,
    /// X, Y, Z, A, B, C by their index.
    Axis(usize),
    /// I, J, K by the index of their axis.
    Center(usize),
    /// I1, J1, K1 by the index of their axis.
    Between(usize),
    /// A3, B3, C3 by the index of their axis.
    Direction(usize),
    /// One of [`OTHER_ADDRESSES`].
    Other(&'static str),
}

impl AddressKind {
    /// The kind of an address; `None` for a name that is none.
    fn of(name: &str, extension: Option<u32>) -> Option<AddressKind> {
        let is_first = matches!(extension, None | Some(1));
        let axis = |names: &[&str]| names.iter().position(|own| *own == name);
        match name {
            "G" => Some(AddressKind::GCode),
            "M" => Some(AddressKind::MCode),
            "I" | "J" | "K" if extension == Some(1) => {
                Some(AddressKind::Between(axis(&CENTER_NAMES)?))
            }
            "A" | "B" | "C" if extension == Some(3) => {
                Some(AddressKind::Direction(axis(&["A", "B", "C"])?))
            }
            "I" | "J" | "K" => Some(AddressKind::Center(axis(&CENTER_NAMES)?)),
            _ if is_first
                && name.len() == 1
                && let Some(axis) = axis(&AXIS_NAMES) =>
            {
                Some(AddressKind::Axis(axis))
            }
            _ => {
                let known = OTHER_ADDRESSES.iter().copied().find(|known| *known == name);
                known.map(AddressKind::Other)
            }
        }
    }
}
