//! Subprograms, repeated parts and modal calls.

use std::collections::HashMap;

use chordal_diagnostics::{Code, Diagnostic, TextRange};
use chordal_kernel::{EndReason, ProgramName};

use super::interpreter::Interpreter;
use super::program_texts::{bare_name, procedure_of};
use super::run_state::{BlockFlow, ModalCycle, PartRepeat, RunningProgram};
use super::variables::{ProgramVariable, r_number, zero_of};
use crate::syntax::{
    Address, CallStatement, Expression, ExpressionKind, IndirectCall, JumpDirection, ProcedureHead,
    ProgramBlock, RepeatPart, VariableDefinition, WordValue,
};
use crate::values::{IndexValue, SinumerikValue, evaluate_index};

/// Levels of calls at most (MD of the channel: 16 of which the main program is one).
const MAX_LEVELS: usize = 16;

/// What a call runs.
struct CallRequest<'c> {
    name: &'c str,
    range: TextRange,
    arguments: Vec<Option<SinumerikValue>>,
    /// The caller's variables that are named alone as arguments, for `VAR` parameters.
    names: Vec<Option<String>>,
    passes: u32,
    is_modal: bool,
}

impl Interpreter<'_> {
    /// The value of an address as a number; `None` if it has none.
    pub(super) fn read(&mut self, address: &Address) -> Option<f64> {
        let kind = ExpressionKind::Variable(address.clone());
        self.number(&Expression { range: address.range, kind })
    }

    /// Writes a variable; a problem is reported.
    pub(super) fn write(&mut self, address: &Address, value: SinumerikValue) {
        let mut indices = Vec::with_capacity(address.indices.len());
        for index in &address.indices {
            match evaluate_index(index, &mut self.scope()) {
                Ok(IndexValue::Known(index)) => indices.push(index),
                Ok(IndexValue::Unknown(cause)) => {
                    self.report_undefined_names();
                    return self.variables.lose(&address.name, &cause);
                }
                Err(error) => return self.report_evaluation(error),
            }
        }
        if address.name.starts_with('$') {
            return self.write_system(address, &indices, value);
        }
        let written = match r_number(address, &indices) {
            Some(number) => self.variables.write_r(number, address.range, value),
            None => self.variables.write_named(address, &indices, value),
        };
        if let Err(error) = written {
            self.report_evaluation(error);
        }
        self.report_undefined_names();
    }

    /// `DEF`: variables of the running program.
    pub(super) fn define(&mut self, definition: &VariableDefinition) -> BlockFlow {
        for defined in &definition.variables {
            let Some(sizes) = self.sizes(&defined.sizes) else { continue };
            let mut variable = match ProgramVariable::new(definition.kind, sizes) {
                Ok(variable) => variable,
                Err(fault) => {
                    self.alarm(fault.alarm, Code::BadStatement, defined.range, fault.message);
                    continue;
                }
            };
            if let Some(initial) = &defined.initial {
                self.fill(&mut variable, initial);
            }
            if let Some(locals) = self.variables.locals.last_mut() {
                locals.insert(defined.name.clone(), variable);
            }
        }
        BlockFlow::Next
    }

    /// The sizes of an array; `None` if one has no value, which is reported.
    pub(super) fn sizes(&mut self, sizes: &[Expression]) -> Option<Vec<usize>> {
        sizes.iter().map(|size| self.count(size).map(|count| count as usize)).collect()
    }

    /// The element that an address names; the first one without indices. A problem is reported.
    fn element_of(&mut self, address: &Address, variable: &ProgramVariable) -> Option<usize> {
        if address.indices.is_empty() {
            return Some(0);
        }
        let mut indices = Vec::with_capacity(address.indices.len());
        for index in &address.indices {
            indices.push(self.number(index)?.round() as i64);
        }
        match variable.place(address.range, &indices) {
            Ok(place) => Some(place),
            Err(error) => {
                self.report_evaluation(error);
                None
            }
        }
    }

    /// Gives a variable its first values.
    pub(super) fn fill(&mut self, variable: &mut ProgramVariable, initial: &WordValue) {
        self.fill_from(variable, 0, initial);
    }

    /// Gives the elements of a variable values from one on.
    fn fill_from(&mut self, variable: &mut ProgramVariable, from: usize, initial: &WordValue) {
        let values: Vec<&Expression> = match initial {
            WordValue::Plain(value)
            | WordValue::Repeated(value)
            | WordValue::Function(_, value) => {
                vec![value; variable.values.len()]
            }
            WordValue::Set(values) => values.iter().collect(),
        };
        let places = from..variable.values.len();
        for (place, expression) in places.zip(values) {
            let Some(value) = self.value(expression) else { return };
            match value.converted(variable.kind) {
                Ok(value) => variable.values[place] = value,
                Err(fault) => {
                    return self.alarm(
                        fault.alarm,
                        Code::BadExpression,
                        expression.range,
                        fault.message,
                    );
                }
            }
        }
    }

    /// Assigns to an array, or to a single variable.
    pub(super) fn assign(&mut self, address: &Address, value: &WordValue) {
        if self.write_settable_shift(address, value) {
            return;
        }
        match value {
            WordValue::Plain(expression) | WordValue::Function(_, expression) => {
                if let Some(value) = self.value(expression) {
                    self.write(address, value);
                }
            }
            WordValue::Set(_) | WordValue::Repeated(_) => {
                if address.name.starts_with('$') {
                    return self.write(address, SinumerikValue::Real(0.0));
                }
                let Some(mut variable) = self.variables.named(&address.name).cloned() else {
                    self.variables.undefined.push((address.name.to_string(), address.range));
                    return self.report_undefined_names();
                };
                // `NAME[2]=SET(…)` fills from this element on.
                let from = match self.element_of(address, &variable) {
                    Some(place) => place,
                    None => return,
                };
                self.fill_from(&mut variable, from, value);
                if let Some(own) = self.variables.named(&address.name) {
                    *own = variable;
                }
            }
        }
    }

    /// `REPEAT LABEL`: runs a part again.
    pub(super) fn repeat_part(&mut self, block: &ProgramBlock, part: &RepeatPart) -> BlockFlow {
        let times = match &part.times {
            Some(times) => self.count(times).unwrap_or(0),
            None => 1,
        };
        let Some(start) = self.find_target(&part.from, JumpDirection::Both) else {
            let message = format!("no block has the label {}", part.from);
            self.alarm(14080, Code::MissingLabel, block.range, message);
            return BlockFlow::End(EndReason::LostJump);
        };
        let last = match (&part.to, part.is_single_block) {
            (_, true) => start.0,
            (Some(label), false) => match self.find_target(label, JumpDirection::Both) {
                Some(place) => place.0,
                None => {
                    let message = format!("no block has the label {label}");
                    self.alarm(14080, Code::MissingLabel, block.range, message);
                    return BlockFlow::End(EndReason::LostJump);
                }
            },
            (None, false) => self.end_label(start, block.range.start),
        };
        if times == 0 {
            return BlockFlow::Next;
        }
        let resume = (self.running().reader.offset(), self.running().reader.line());
        self.running().repeats.push(PartRepeat { start, last, left: times, resume });
        self.running().reader.seek(start.0, start.1);
        BlockFlow::Next
    }

    /// The last block of a part that begins at a label: the one with `ENDLABEL:`, or the one before the `REPEAT`.
    fn end_label(&mut self, start: (u32, u32), repeat: u32) -> u32 {
        let program = self.running().program;
        let mut reader = self.programs.reader(program);
        reader.seek(start.0, start.1);
        let mut last = start.0;
        for block in reader {
            if block.range.start >= repeat && repeat > start.0 {
                return last;
            }
            last = block.range.start;
            if block.label.as_ref().is_some_and(|label| label.name == "ENDLABEL") {
                return last;
            }
        }
        last
    }

    /// After the block that begins at an offset: whether the part that is repeated ends with it.
    pub(super) fn part_ends(&mut self, start: u32) -> BlockFlow {
        let ended = self.running().repeats.last().is_some_and(|repeat| repeat.last == start);
        if !ended {
            return BlockFlow::Next;
        }
        let running = self.running();
        let Some(repeat) = running.repeats.last_mut() else { return BlockFlow::Next };
        repeat.left -= 1;
        let place = if repeat.left > 0 { repeat.start } else { repeat.resume };
        if repeat.left == 0 {
            running.repeats.pop();
        }
        running.reader.seek(place.0, place.1);
        BlockFlow::Next
    }

    /// The end of a program's text, or M17, RET, M30: a return to the caller, the next pass, or the end of the run.
    pub(super) fn program_ends(&mut self) -> BlockFlow {
        if self.running().passes_left > 0 {
            let program = self.running().program;
            let reader = self.programs.reader(program);
            let running = self.running();
            running.passes_left -= 1;
            running.loops.clear();
            running.reader = reader;
            return BlockFlow::Next;
        }
        if self.stack.len() <= 1 {
            return BlockFlow::End(EndReason::EndOfText);
        }
        let Some(ended) = self.stack.pop() else { return BlockFlow::End(EndReason::EndOfText) };
        let locals = self.variables.locals.pop().unwrap_or_default();
        for (own, callers) in ended.references {
            if let (Some(from), Some(to)) = (locals.get(&own), self.variables.named(&callers)) {
                to.values.clone_from(&from.values);
            }
        }
        if let Some(saved) = ended.saved {
            self.restore_modes(*saved);
        }
        BlockFlow::Next
    }

    /// A call by name: of a cycle, or of a program.
    pub(super) fn call(&mut self, call: &CallStatement, passes: Option<u32>) -> BlockFlow {
        let arguments = call.arguments.as_deref().unwrap_or_default();
        let Some(values) = self.arguments(arguments) else { return BlockFlow::Next };
        if self.is_cycle(&call.name) && self.programs.find_name(&call.name).is_none() {
            self.run_cycle(&call.name, &values, call.range);
            return BlockFlow::Next;
        }
        let name_of =
            |argument: &Option<Expression>| match argument.as_ref().map(|value| &value.kind) {
                Some(ExpressionKind::Variable(address)) if address.indices.is_empty() => {
                    Some(address.name.to_string())
                }
                _ => None,
            };
        self.call_program(CallRequest {
            name: &call.name,
            range: call.range,
            arguments: values,
            names: arguments.iter().map(name_of).collect(),
            passes: passes.unwrap_or(1),
            is_modal: false,
        })
    }

    /// The values of arguments; `None` if one has no value, which is reported.
    fn arguments(
        &mut self,
        arguments: &[Option<Expression>],
    ) -> Option<Vec<Option<SinumerikValue>>> {
        arguments
            .iter()
            .map(|argument| match argument {
                None => Some(None),
                Some(expression) => self.value(expression).map(Some),
            })
            .collect()
    }

    fn call_program(&mut self, request: CallRequest<'_>) -> BlockFlow {
        let Some(program) = self.programs.find_name(request.name) else {
            let name = ProgramName::from(request.name.to_string());
            if !self.missing.contains(&name) {
                self.missing.push(name);
            }
            self.report_missing_program(request.name, request.range);
            return BlockFlow::Next;
        };
        if request.passes == 0 {
            let message = "the number of passes must be 1 or more";
            self.alarm(14013, Code::BadWordValue, request.range, message);
            return BlockFlow::Next;
        }
        if self.stack.len() >= MAX_LEVELS {
            let message = format!("more than {MAX_LEVELS} programs call each other");
            self.alarm(14012, Code::NestingTooDeep, request.range, message);
            return BlockFlow::End(EndReason::Alarm);
        }
        let block = self.span(self.here());
        let caller = self.running().call;
        let call = self.kernel.calls.enter(caller, block);
        let reader = self.programs.reader(program);
        let head = procedure_of(&mut self.programs.reader(program)).map(|(_, head)| head);
        let (locals, references) = self.parameters(head.as_ref(), &request);
        let saved = head.as_ref().filter(|head| head.saves).map(|_| Box::new(self.saved_modes()));
        self.variables.locals.push(locals);
        self.stack.push(RunningProgram {
            passes_left: request.passes - 1,
            saved,
            references,
            passed_parameters: request.arguments.iter().map(Option::is_some).collect(),
            is_modal_call: request.is_modal,
            ..RunningProgram::new(program, reader, call)
        });
        BlockFlow::Next
    }

    fn report_missing_program(&mut self, name: &str, range: TextRange) {
        let similar = self.similar_name(&name.to_ascii_uppercase());
        let message = format!("there is no program {name}");
        let diagnostic = Diagnostic::new(Code::MissingSubprogram, self.span(range), message);
        let diagnostic = match &similar {
            Some(similar) => diagnostic.help(format!("is {similar} meant?")),
            None => diagnostic.help(
                "give its file with the program, or put it into the same folder; what it moves is missing here",
            ),
        };
        self.report_missing_name(14011, diagnostic, similar.is_some());
        self.lose_path(range, "the path", &format!("the program {name}"));
        self.lose_state();
    }

    /// The variables of a program with parameters, and which of the caller's get their values back.
    fn parameters(
        &mut self,
        head: Option<&ProcedureHead>,
        request: &CallRequest<'_>,
    ) -> (HashMap<String, ProgramVariable>, Vec<(String, String)>) {
        let (mut locals, mut references) = (HashMap::new(), Vec::new());
        let parameters = head.map_or(&[][..], |head| &head.parameters);
        if request.arguments.len() > parameters.len() {
            let message = format!(
                "{} has {} parameters, and the call gives {}",
                request.name,
                parameters.len(),
                request.arguments.len()
            );
            self.alarm(12340, Code::BadArgument, request.range, message);
        }
        for (place, parameter) in parameters.iter().enumerate() {
            let argument = request.arguments.get(place).cloned().flatten();
            let argument = argument.or_else(|| self.value(parameter.default.as_ref()?));
            let value = argument.and_then(|value| value.converted(parameter.kind).ok());
            let value = value.unwrap_or_else(|| zero_of(parameter.kind));
            let variable =
                ProgramVariable { kind: parameter.kind, sizes: Vec::new(), values: vec![value] };
            locals.insert(parameter.name.clone(), variable);
            if parameter.is_reference
                && let Some(Some(name)) = request.names.get(place)
            {
                references.push((parameter.name.clone(), name.clone()));
            }
        }
        (locals, references)
    }

    /// `CALL`, `PCALL`, `EXTCALL`.
    pub(super) fn indirect_call(&mut self, range: TextRange, call: &IndirectCall) -> BlockFlow {
        match call {
            IndirectCall::Named(expression) => {
                let Some(value) = self.value(expression) else { return BlockFlow::Next };
                if let Some(cause) = value.unknown_cause() {
                    self.lose_path(range, "the called program", &cause.clone());
                    return BlockFlow::Next;
                }
                let name = value
                    .to_text()
                    .map_or_else(|_| String::new(), |text| text.to_ascii_uppercase());
                self.call_program(CallRequest {
                    name: bare_name(&name),
                    range,
                    arguments: Vec::new(),
                    names: Vec::new(),
                    passes: 1,
                    is_modal: false,
                })
            }
            IndirectCall::Path(call) => self.call(call, None),
            IndirectCall::Blocks { program: Some(_), .. } => {
                self.not_followed(range, "CALL BLOCK in another program is not followed");
                BlockFlow::Next
            }
            IndirectCall::Blocks { program: None, from, to } => {
                let part = RepeatPart {
                    from: from.clone(),
                    to: Some(to.clone()),
                    times: None,
                    is_single_block: false,
                };
                let block = ProgramBlock {
                    range,
                    line: self.kernel.origin.line,
                    skip_level: None,
                    number: None,
                    label: None,
                    statements: Vec::new(),
                    comment: None,
                    faults: Vec::new(),
                    doubtful_comparisons: Vec::new(),
                };
                self.repeat_part(&block, &part)
            }
        }
    }

    /// `MCALL`.
    pub(super) fn set_modal_call(&mut self, call: Option<&CallStatement>) {
        self.modal_call = None;
        let Some(call) = call else { return };
        let arguments = call.arguments.as_deref().unwrap_or_default();
        let Some(arguments) = self.arguments(arguments) else { return };
        self.modal_call = Some(ModalCycle { name: call.name.clone(), arguments });
    }

    /// After a block with path motion: the cycle or program of the modal call.
    pub(super) fn fire_modal_call(&mut self, range: TextRange) -> BlockFlow {
        if self.running().is_modal_call {
            return BlockFlow::Next;
        }
        let Some(modal) = self.modal_call.clone() else { return BlockFlow::Next };
        if self.is_cycle(&modal.name) && self.programs.find_name(&modal.name).is_none() {
            self.run_cycle(&modal.name, &modal.arguments, range);
            return BlockFlow::Next;
        }
        self.call_program(CallRequest {
            name: &modal.name,
            range,
            arguments: modal.arguments,
            names: Vec::new(),
            passes: 1,
            is_modal: true,
        })
    }
}
