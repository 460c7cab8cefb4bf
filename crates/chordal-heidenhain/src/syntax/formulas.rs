//! Formulas, and the values of FN, which are formulas with words for some operators.

use chordal_diagnostics::TextRange;

use super::ast::{
    FormulaFunction, FormulaOperator, FormulaStep, KlartextFaultKind, KlartextFormula, TextPart,
};
use super::cursor::TokenCursor;
use super::tokens::{KlartextToken, KlartextTokenKind};

/// Brackets and functions inside each other; deeper formulas are refused.
const MAX_DEPTH: u32 = 100;

/// Reads a formula up to the end of the block; `None` if it has a fault, which is noted.
pub fn formula(cursor: &mut TokenCursor<'_>) -> Option<KlartextFormula> {
    let range = cursor.rest();
    let mut reader = FormulaReader { cursor, steps: Vec::new() };
    reader.sum(0)?;
    let steps = reader.steps;
    if let Some(token) = cursor.peek() {
        let message = match token.kind {
            KlartextTokenKind::Sign(b')') => "this bracket closes none".to_string(),
            _ => format!("`{}` is not expected in a formula here", cursor.shown(token.range)),
        };
        let kind = match token.kind {
            KlartextTokenKind::Sign(b')') => KlartextFaultKind::Bracket,
            _ => KlartextFaultKind::Unreadable,
        };
        cursor.fault(kind, token.range, message);
        cursor.take_rest();
        return None;
    }
    Some(KlartextFormula { steps, range })
}

/// Texts and QS parameters joined by `||`; `None` for another formula of texts.
pub fn text_formula(cursor: &mut TokenCursor<'_>) -> Option<Vec<TextPart>> {
    let mut parts = Vec::new();
    loop {
        if let Some(KlartextToken { kind: KlartextTokenKind::Text(text), .. }) = cursor.peek() {
            parts.push(TextPart::Literal(text.clone()));
            cursor.take();
        } else {
            let name = cursor.take_parameter()?;
            parts.push(TextPart::Parameter(name.number));
        }
        if cursor.is_at_end() {
            return Some(parts);
        }
        if !(cursor.take_sign(b'|') && cursor.take_sign(b'|')) {
            return None;
        }
    }
}

struct FormulaReader<'c, 't> {
    cursor: &'c mut TokenCursor<'t>,
    steps: Vec<(FormulaStep, TextRange)>,
}

impl FormulaReader<'_, '_> {
    fn push(&mut self, step: FormulaStep, range: TextRange) {
        self.steps.push((step, range));
    }

    /// The operator that comes next, if it is one of these.
    fn operator(&self, among: &[FormulaOperator]) -> Option<(FormulaOperator, TextRange)> {
        let token = self.cursor.peek()?;
        let operator = match &token.kind {
            KlartextTokenKind::Sign(b'+') => FormulaOperator::Add,
            KlartextTokenKind::Sign(b'-') => FormulaOperator::Subtract,
            KlartextTokenKind::Sign(b'*') => FormulaOperator::Multiply,
            KlartextTokenKind::Sign(b'/') => FormulaOperator::Divide,
            KlartextTokenKind::Sign(b'%') => FormulaOperator::Remainder,
            KlartextTokenKind::Sign(b'^') => FormulaOperator::Power,
            KlartextTokenKind::Word(word) => match word.as_str() {
                "DIV" => FormulaOperator::Divide,
                "LEN" => FormulaOperator::Length,
                "ANG" => FormulaOperator::Angle,
                _ => return None,
            },
            _ => return None,
        };
        among.contains(&operator).then_some((operator, token.range))
    }

    fn sum(&mut self, depth: u32) -> Option<()> {
        self.product(depth)?;
        while let Some((operator, range)) =
            self.operator(&[FormulaOperator::Add, FormulaOperator::Subtract])
        {
            self.cursor.take();
            self.product(depth)?;
            self.push(FormulaStep::Operator(operator), range);
        }
        Some(())
    }

    fn product(&mut self, depth: u32) -> Option<()> {
        self.power(depth)?;
        let among = [
            FormulaOperator::Multiply,
            FormulaOperator::Divide,
            FormulaOperator::Remainder,
            FormulaOperator::Length,
            FormulaOperator::Angle,
        ];
        while let Some((operator, range)) = self.operator(&among) {
            self.cursor.take();
            self.power(depth)?;
            self.push(FormulaStep::Operator(operator), range);
        }
        Some(())
    }

    fn power(&mut self, depth: u32) -> Option<()> {
        self.operand(depth)?;
        while let Some((operator, range)) = self.operator(&[FormulaOperator::Power]) {
            self.cursor.take();
            self.operand(depth)?;
            self.push(FormulaStep::Operator(operator), range);
        }
        Some(())
    }

    /// A number, a parameter, a bracket, or a function with its operand; signs may come before each.
    fn operand(&mut self, depth: u32) -> Option<()> {
        let here = self.cursor.rest();
        if depth > MAX_DEPTH {
            let message = format!("more than {MAX_DEPTH} brackets and functions inside each other");
            self.cursor.fault(KlartextFaultKind::Bracket, here, message);
            return None;
        }
        if self.cursor.take_sign(b'+') {
            return self.operand(depth + 1);
        }
        if self.cursor.take_sign(b'-') {
            self.operand(depth + 1)?;
            self.push(FormulaStep::Function(FormulaFunction::Negative), here);
            return Some(());
        }
        if self.cursor.take_sign(b'(') {
            self.sum(depth + 1)?;
            if self.cursor.take_sign(b')') {
                return Some(());
            }
            let open = TextRange::new(here.start, here.start + 1);
            self.cursor.fault(KlartextFaultKind::Bracket, open, "this bracket is not closed");
            self.cursor.take_rest();
            return None;
        }
        if let Some(name) = self.cursor.take_parameter() {
            let range = self.cursor.range_from(here_start(here));
            self.push(FormulaStep::Parameter(name), range);
            return Some(());
        }
        let Some(token) = self.cursor.peek() else {
            self.cursor.fault(KlartextFaultKind::MissingValue, here, "a value is missing here");
            return None;
        };
        match &token.kind {
            KlartextTokenKind::Number(value) => {
                self.cursor.take();
                self.push(FormulaStep::Number(*value), token.range);
                Some(())
            }
            KlartextTokenKind::Word(word) if word == "PI" => {
                self.cursor.take();
                self.push(FormulaStep::Number(std::f64::consts::PI), token.range);
                Some(())
            }
            KlartextTokenKind::Word(word) if word == "PI" => {
                self.cursor.take();
                self.push(FormulaStep::Number(std::f64::consts::PI), token.range);
                Some(())
            }
            KlartextTokenKind::Word(word) if function_of(word).is_some() => {
                let function = function_of(word)?;
                self.cursor.take();
                self.operand(depth + 1)?;
                self.push(FormulaStep::Function(function), token.range);
                Some(())
            }
            _ => {
                let message =
                    format!("`{}` is not read in a formula", self.cursor.shown(token.range));
                self.cursor.fault(KlartextFaultKind::Unreadable, token.range, message);
                self.cursor.take_rest();
                None
            }
        }
    }
}

/// The place where a range starts.
const fn here_start(range: TextRange) -> TextRange {
    TextRange::new(range.start, range.start)
}

/// The function with a name.
fn function_of(word: &str) -> Option<FormulaFunction> {
    Some(match word {
        "SIN" => FormulaFunction::Sine,
        "COS" => FormulaFunction::Cosine,
        "TAN" => FormulaFunction::Tangent,
        "ASIN" => FormulaFunction::ArcSine,
        "ACOS" => FormulaFunction::ArcCosine,
        "ATAN" => FormulaFunction::ArcTangent,
        "SQ" => FormulaFunction::Square,
        "SQRT" => FormulaFunction::SquareRoot,
        "LN" => FormulaFunction::NaturalLogarithm,
        "LOG" => FormulaFunction::DecimalLogarithm,
        "EXP" => FormulaFunction::Exponential,
        "ABS" => FormulaFunction::Absolute,
        "INT" => FormulaFunction::Integer,
        "FRAC" => FormulaFunction::Fraction,
        "NEG" => FormulaFunction::Negative,
        "SGN" => FormulaFunction::SignOf,
        _ => return None,
    })
}
