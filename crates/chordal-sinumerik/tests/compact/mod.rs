//! Prints blocks in a short form, so that a test shows what was read.
//!
//! `X:10` a word without an equals sign, `X=10` with one, `S.2` an extension, `NAME` a bare name, `NAME(…)` a call with `_`
//! for a missing argument; `N10`, `:10`, `/2` and `LABEL>` the head; `!message@text` a fault. Operations have parentheses.

#![allow(dead_code, reason = "each test uses a part")]

use chordal_sinumerik::syntax::*;

/// The blocks of a text, one a line.
pub fn blocks(text: &str) -> Vec<String> {
    BlockReader::new(text.as_bytes()).map(|block| block_text(text, &block)).collect()
}

/// The only block of a line.
pub fn line(text: &str) -> String {
    let blocks = blocks(text);
    assert_eq!(blocks.len(), 1, "{blocks:?}");
    blocks[0].clone()
}

pub fn block_text(text: &str, block: &ProgramBlock) -> String {
    let mut parts = Vec::new();
    parts.extend(block.skip_level.map(|level| format!("/{level}")));
    parts.extend(
        block
            .number
            .map(|number| format!("{}{}", if number.is_main { ":" } else { "N" }, number.number)),
    );
    parts.extend(block.label.iter().map(|label| format!("{}>", label.name)));
    parts.extend(block.statements.iter().map(|statement| statement_text(text, statement)));
    parts.extend(block.comment.map(|comment| slice(text, comment)));
    parts.extend(
        block.faults.iter().map(|fault| format!("!{}@{}", fault.message, slice(text, fault.range))),
    );
    parts.join(" ")
}

fn slice(text: &str, range: chordal_diagnostics::TextRange) -> String {
    String::from_utf8_lossy(range.slice(text.as_bytes())).into_owned()
}

fn statement_text(text: &str, statement: &BlockStatement) -> String {
    match &statement.kind {
        StatementKind::Word(word) => word_text(word),
        StatementKind::Name(name) => name.clone(),
        StatementKind::Call(call) => call_text(call),
        StatementKind::ModalCall(None) => "MCALL".to_string(),
        StatementKind::ModalCall(Some(call)) => format!("MCALL {}", call_text(call)),
        StatementKind::IndirectCall(call) => indirect_text(call),
        StatementKind::If(condition) => format!("IF {}", expression(condition)),
        StatementKind::Else => "ELSE".to_string(),
        StatementKind::EndIf => "ENDIF".to_string(),
        StatementKind::For { variable, from, to } => {
            format!("FOR {}={} TO {}", address(variable), expression(from), expression(to))
        }
        StatementKind::EndFor => "ENDFOR".to_string(),
        StatementKind::While(condition) => format!("WHILE {}", expression(condition)),
        StatementKind::EndWhile => "ENDWHILE".to_string(),
        StatementKind::RepeatLoop => "REPEAT".to_string(),
        StatementKind::Until(condition) => format!("UNTIL {}", expression(condition)),
        StatementKind::Loop => "LOOP".to_string(),
        StatementKind::EndLoop => "ENDLOOP".to_string(),
        StatementKind::RepeatPart(part) => repeat_text(part),
        StatementKind::Jump(jump) => jump_text(jump),
        StatementKind::Case { selector, branches, default } => {
            let mut out = format!("CASE {}", expression(selector));
            for (constant, jump) in branches {
                out += &format!(" {}:{}", expression(constant), jump_text(jump));
            }
            if let Some(jump) = default {
                out += &format!(" ELSE:{}", jump_text(jump));
            }
            out
        }
        StatementKind::Define(definition) => {
            let variables: Vec<String> = definition.variables.iter().map(variable_text).collect();
            format!("DEF {:?} {}", definition.kind, variables.join(" "))
        }
        StatementKind::Procedure(head) => procedure_text(head),
        StatementKind::External(name) => format!("EXTERN {name}"),
        StatementKind::Macro { name, text: range } => {
            format!("DEFINE {name} AS <{}>", slice(text, *range))
        }
        StatementKind::SynchronousAction => format!("SYNC<{}>", slice(text, statement.range)),
    }
}

fn word_text(word: &AddressWord) -> String {
    let sign = if word.has_equals { "=" } else { ":" };
    format!("{}{sign}{}", address(&word.address), value_text(&word.value))
}

fn value_text(value: &WordValue) -> String {
    match value {
        WordValue::Plain(value) => expression(value),
        WordValue::Function(function, value) => format!("{function:?}<{}>", expression(value)),
        WordValue::Set(values) => {
            let values: Vec<String> = values.iter().map(expression).collect();
            format!("SET<{}>", values.join(","))
        }
        WordValue::Repeated(value) => format!("REP<{}>", expression(value)),
    }
}

fn variable_text(variable: &DefinedVariable) -> String {
    let sizes: Vec<String> = variable.sizes.iter().map(expression).collect();
    let sizes = if sizes.is_empty() { String::new() } else { format!("[{}]", sizes.join(",")) };
    let initial =
        variable.initial.as_ref().map_or(String::new(), |v| format!("={}", value_text(v)));
    format!("{}{sizes}{initial}", variable.name)
}

fn procedure_text(head: &ProcedureHead) -> String {
    let parameters: Vec<String> = head
        .parameters
        .iter()
        .map(|parameter| {
            let reference = if parameter.is_reference { "VAR " } else { "" };
            let default =
                parameter.default.as_ref().map_or(String::new(), |v| format!("={}", expression(v)));
            format!("{reference}{:?} {}{default}", parameter.kind, parameter.name)
        })
        .collect();
    let save = if head.saves { " SAVE" } else { "" };
    format!("PROC {}({}){save}", head.name, parameters.join(", "))
}

fn repeat_text(part: &RepeatPart) -> String {
    let word = if part.is_single_block { "REPEATB" } else { "REPEAT" };
    let to = part.to.as_ref().map_or(String::new(), |label| format!(" to {label}"));
    let times = part.times.as_ref().map_or(String::new(), |v| format!(" P={}", expression(v)));
    format!("{word} {}{to}{times}", part.from)
}

fn jump_text(jump: &JumpStatement) -> String {
    let target = match &jump.target {
        None => "start".to_string(),
        Some(JumpTarget::Label(label)) => label.clone(),
        Some(JumpTarget::Number(number, false)) => format!("N{number}"),
        Some(JumpTarget::Number(number, true)) => format!(":{number}"),
        Some(JumpTarget::Computed(value)) => format!("?{}", expression(value)),
    };
    let condition =
        jump.condition.as_ref().map_or(String::new(), |value| format!("IF {} ", expression(value)));
    format!("{condition}{:?}->{target}", jump.direction)
}

fn indirect_text(call: &IndirectCall) -> String {
    match call {
        IndirectCall::Named(value) => format!("CALL {}", expression(value)),
        IndirectCall::Blocks { program, from, to } => {
            let program = program.as_ref().map_or(String::new(), |v| expression(v) + " ");
            format!("CALL {program}{from}..{to}")
        }
        IndirectCall::Path(call) => format!("PCALL {}", call_text(call)),
    }
}

fn call_text(call: &CallStatement) -> String {
    let arguments = call.arguments.as_ref().map_or(String::new(), |list| argument_text(list));
    format!("{}{arguments}", call.name)
}

fn argument_text(arguments: &[Option<Expression>]) -> String {
    let list: Vec<String> = arguments
        .iter()
        .map(|argument| argument.as_ref().map_or("_".to_string(), expression))
        .collect();
    format!("({})", list.join(","))
}

fn address(address: &Address) -> String {
    let extension = address.extension.map_or(String::new(), |number| format!(".{number}"));
    let indices: Vec<String> = address.indices.iter().map(expression).collect();
    let indices =
        if indices.is_empty() { String::new() } else { format!("[{}]", indices.join(",")) };
    format!("{}{extension}{indices}", address.name)
}

pub fn expression(value: &Expression) -> String {
    match &value.kind {
        ExpressionKind::Integer(value) => value.to_string(),
        ExpressionKind::Real(value) => format!("{value:?}"),
        ExpressionKind::Boolean(value) => value.to_string(),
        ExpressionKind::Text(text) => format!("{text:?}"),
        ExpressionKind::Variable(variable) => address(variable),
        ExpressionKind::Function(name, arguments) => format!("{name}{}", argument_text(arguments)),
        ExpressionKind::Unary(operator, operand) => {
            format!("({operator:?} {})", expression(operand))
        }
        ExpressionKind::Binary(operator, left, right) => {
            format!("({} {operator:?} {})", expression(left), expression(right))
        }
    }
}
