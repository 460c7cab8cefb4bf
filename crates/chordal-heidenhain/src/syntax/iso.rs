//! DIN/ISO programs of the same controls: blocks of G codes that end with `*`. What is the same in both forms becomes the
//! same statement.

use chordal_diagnostics::TextRange;

use super::ast::{
    AXIS_WORDS, FormulaFunction, FormulaOperator, FormulaStep, IsoWords, JumpComparison,
    JumpCondition, KlartextFaultKind, KlartextFormula, KlartextLabel, KlartextStatement, PathWords,
};
use super::cursor::TokenCursor;
use super::cycles::parameters;
use super::functions::{assignment, system_numbers};
use super::operands::{OperandWord, WordOperand};
use super::tokens::KlartextTokenKind;
use super::words::{function_word, unread_token};

/// Reads the statement of a block; `has_number` says whether N stands before it.
pub fn iso_statement(cursor: &mut TokenCursor<'_>, has_number: bool) -> KlartextStatement {
    if cursor.take_sign(b'%') {
        return program_line(cursor, has_number);
    }
    let Some(first) = cursor.peek() else { return KlartextStatement::Nothing };
    if first.kind == KlartextTokenKind::Sign(b'*') {
        cursor.take_rest();
        return KlartextStatement::Nothing;
    }
    if cursor.peek_word() == Some("D") {
        cursor.take();
        return numbered_function(cursor).unwrap_or_else(|| unread(cursor, first.range));
    }
    if matches!(cursor.peek_word(), Some("Q" | "QL" | "QR" | "QS")) {
        cursor.drop_last_sign(b'*');
        return assignment(cursor);
    }
    if cursor.peek_word() == Some("L")
        && let Some(call) = label_call(cursor)
    {
        return call;
    }
    words(cursor)
}

/// `%NAME G71`: the start of a program, or with a number before it its end.
fn program_line(cursor: &mut TokenCursor<'_>, has_number: bool) -> KlartextStatement {
    let rest = cursor.take_rest();
    let text = rest.slice(cursor.text);
    let length = text.iter().position(u8::is_ascii_whitespace).unwrap_or(text.len());
    let end = text[..length].strip_suffix(b"*").map_or(length, |name| name.len());
    let name = TextRange::new(rest.start, rest.start + end as u32);
    let after = text[length..].to_ascii_uppercase();
    let is_inch = after.windows(3).any(|word| word == b"G70");
    if text.first() == Some(&b':') {
        return KlartextStatement::CallProgram(TextRange::new(name.start + 1, name.end));
    }
    match has_number {
        true => KlartextStatement::End { name, is_inch },
        false => KlartextStatement::Begin { name, is_inch },
    }
}

fn unread(cursor: &mut TokenCursor<'_>, range: TextRange) -> KlartextStatement {
    cursor.take_rest();
    let message = format!("`{}` begins no block that is read", cursor.shown(range));
    cursor.fault(KlartextFaultKind::UnknownFunction, range, message);
    KlartextStatement::Unknown
}

/// `L1,0` calls label 1, `L2,3` repeats the part from label 2 on three times more.
fn label_call(cursor: &mut TokenCursor<'_>) -> Option<KlartextStatement> {
    let number = cursor.peek_after(1)?;
    let text = cursor.shown(number.range);
    let (label, repeats) = text.split_once([',', '.'])?;
    let label = KlartextLabel::Number(label.parse().ok()?);
    let repeats: u32 = repeats.parse().ok()?;
    cursor.take_rest();
    let repeats = (repeats > 0).then_some(WordOperand::Number(f64::from(repeats)));
    Some(KlartextStatement::CallLabel { label, repeats })
}

/// `D01 Q1 P01 +Q2 P02 +3`: the functions FN with their operands in P words.
fn numbered_function(cursor: &mut TokenCursor<'_>) -> Option<KlartextStatement> {
    let number = cursor.take_whole()?;
    let target = cursor.take_parameter();
    if number == 18 {
        let statement =
            KlartextStatement::SystemRead { target: target?, numbers: system_numbers(cursor) };
        cursor.take_sign(b'*');
        return Some(statement);
    }
    let mut operands = Vec::new();
    while cursor.take_word("P") {
        cursor.take_whole()?;
        let start = cursor.rest();
        let operand = cursor.take_operand()?;
        operands.push((operand, cursor.range_from(TextRange::new(start.start, start.start))));
    }
    cursor.take_sign(b'*');
    let operator = match number {
        0 => None,
        1 => Some(FormulaStep::Operator(FormulaOperator::Add)),
        2 => Some(FormulaStep::Operator(FormulaOperator::Subtract)),
        3 => Some(FormulaStep::Operator(FormulaOperator::Multiply)),
        4 => Some(FormulaStep::Operator(FormulaOperator::Divide)),
        5 => Some(FormulaStep::Function(FormulaFunction::SquareRoot)),
        6 => Some(FormulaStep::Function(FormulaFunction::Sine)),
        7 => Some(FormulaStep::Function(FormulaFunction::Cosine)),
        8 => Some(FormulaStep::Operator(FormulaOperator::Length)),
        13 => Some(FormulaStep::Operator(FormulaOperator::Angle)),
        9..=12 => return jump(number, &operands),
        14 => return Some(KlartextStatement::RaiseError(operands.first()?.0)),
        _ => return Some(KlartextStatement::OtherFunction { number, target }),
    };
    let target = target?;
    let count = if matches!(operator, Some(FormulaStep::Operator(_))) { 2 } else { 1 };
    if operands.len() != count {
        return None;
    }
    let mut steps = Vec::new();
    for (operand, range) in &operands {
        match operand {
            WordOperand::Number(value) => steps.push((FormulaStep::Number(*value), *range)),
            WordOperand::Parameter { is_negative, name } => {
                steps.push((FormulaStep::Parameter(*name), *range));
                if *is_negative {
                    steps.push((FormulaStep::Function(FormulaFunction::Negative), *range));
                }
            }
        }
    }
    let range = operands.iter().map(|(_, range)| *range).reduce(TextRange::cover)?;
    steps.extend(operator.map(|step| (step, range)));
    Some(KlartextStatement::Assign { target, formula: KlartextFormula { steps, range } })
}

/// D09 to D12: P03 is the label.
fn jump(number: u32, operands: &[(WordOperand, TextRange)]) -> Option<KlartextStatement> {
    let [(first, _), (second, _), (label, _)] = operands else { return None };
    let comparison = match number {
        9 => JumpComparison::Equal,
        10 => JumpComparison::NotEqual,
        11 => JumpComparison::Greater,
        _ => JumpComparison::Less,
    };
    let label = match label {
        WordOperand::Number(number) => KlartextLabel::Number(number.max(0.0) as u32),
        WordOperand::Parameter { name, .. } => KlartextLabel::Parameter(*name),
    };
    let condition = JumpCondition::Compared(*first, comparison, *second);
    Some(KlartextStatement::Jump { condition, label })
}

/// A block of words.
fn words(cursor: &mut TokenCursor<'_>) -> KlartextStatement {
    let mut words = IsoWords::default();
    while let Some(token) = cursor.peek() {
        if cursor.take_sign(b'*') {
            continue;
        }
        let KlartextTokenKind::Word(word) = &token.kind else {
            unread_token(cursor);
            continue;
        };
        if function_word(cursor, &mut words.functions) {
            continue;
        }
        if word == "G" {
            cursor.take();
            let Some(number) = cursor.take_whole() else {
                cursor.fault(KlartextFaultKind::MissingValue, token.range, "G has no number");
                continue;
            };
            // G120 to G125 are the contour cycles 20 to 25, G37 names their contours.
            if (120..=125).contains(&number) {
                let number = number - 100;
                return KlartextStatement::CycleParameters { number, values: parameters(cursor) };
            }
            if number == 37 {
                let (rest, words) = (cursor.take_rest(), Vec::new());
                return KlartextStatement::CycleLine { number: 14, line: 1, words, rest };
            }
            if (200..=299).contains(&number) {
                return KlartextStatement::CycleParameters { number, values: parameters(cursor) };
            }
            words.codes.push((number, cursor.range_from(token.range)));
            continue;
        }
        let place = match word.as_str() {
            "I" => &mut words.center[0],
            "J" => &mut words.center[1],
            "K" => &mut words.center[2],
            "R" => &mut words.radius,
            "H" => &mut words.angle,
            "F" => &mut words.feed,
            "S" => &mut words.speed,
            "T" => &mut words.tool,
            "L" => &mut words.length,
            _ => match AXIS_WORDS.iter().position(|axis| axis == word) {
                Some(axis) => {
                    words.named[axis] = true;
                    &mut words.axes[axis]
                }
                None => {
                    unread_token(cursor);
                    continue;
                }
            },
        };
        cursor.take();
        let Some(value) = cursor.take_operand() else {
            // The axes of a mirror image have no value.
            let is_mirror = words.codes.iter().any(|(code, _)| *code == 28);
            if !(is_mirror && AXIS_WORDS.contains(&word.as_str())) {
                let message = format!("{word} has no value");
                cursor.fault(KlartextFaultKind::MissingValue, token.range, message);
            }
            continue;
        };
        let is_double = place.is_some();
        let range = cursor.range_from(token.range);
        *place = place.or(Some(OperandWord { is_incremental: false, value, range }));
        if is_double {
            let message = format!("{word} is programmed twice in this block");
            cursor.fault(KlartextFaultKind::DoubleWord, range, message);
        }
    }
    statement_of(words)
}

/// The blocks that are the same in both forms of a program.
fn statement_of(words: IsoWords) -> KlartextStatement {
    let has = |code: u32| words.codes.iter().any(|(own, _)| *own == code);
    let radius_alone = || PathWords { radius: words.radius, ..PathWords::default() };
    if has(98)
        && let Some(OperandWord { value: WordOperand::Number(number), .. }) = words.length
    {
        return KlartextStatement::Label(KlartextLabel::Number(number.max(0.0) as u32));
    }
    if has(24) {
        return KlartextStatement::Chamfer(words.radius, Box::default());
    }
    if has(25) {
        return KlartextStatement::Rounding(Box::new(radius_alone()));
    }
    if has(99)
        && let Some(tool) = words.tool
    {
        return KlartextStatement::ToolDefinition {
            number: tool.value,
            length: words.length.map(|word| word.value),
            radius: words.radius.map(|word| word.value),
        };
    }
    KlartextStatement::Iso(Box::new(words))
}
