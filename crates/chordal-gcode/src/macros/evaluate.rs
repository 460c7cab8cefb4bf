//! Evaluates the steps of an expression.

use chordal_diagnostics::{Code, TextRange};
use chordal_dialect::macros::MacroRules;
use chordal_syntax::{ExpressionStep, Function, Operator, StackOp};

use super::functions::{self, FunctionError};
use super::value::{MacroValue, UnknownCause};

/// Reads variables while an expression is evaluated.
pub(crate) trait VariableReader {
    /// The variable of a number.
    fn read(&mut self, number: f64, range: TextRange) -> Result<MacroValue, EvaluationError>;

    /// The variable of a name.
    fn read_named(
        &mut self,
        name: TextRange,
        range: TextRange,
    ) -> Result<MacroValue, EvaluationError>;

    /// True when a named variable is set.
    fn is_set(&mut self, name: TextRange) -> bool;

    /// True when there is a variable with this number.
    fn is_number(&mut self, number: f64) -> bool {
        self.read(number, TextRange::default()).is_ok()
    }

    /// A variable written with letters: the index in the list of the grammar, and its number.
    fn read_letters(
        &mut self,
        letters: u8,
        number: f64,
        range: TextRange,
    ) -> Result<MacroValue, EvaluationError>;

    /// True when angles are radians, not degrees.
    fn radians(&self) -> bool {
        false
    }
}

/// Why an expression has no value.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct EvaluationError {
    pub code: Code,
    pub range: TextRange,
    pub message: String,
    pub help: &'static str,
}

impl EvaluationError {
    pub fn new(
        code: Code,
        range: TextRange,
        message: impl Into<String>,
        help: &'static str,
    ) -> EvaluationError {
        EvaluationError { code, range, message: message.into(), help }
    }

    /// An error that was already reported by the parser.
    pub fn already_reported(range: TextRange) -> EvaluationError {
        EvaluationError::new(Code::BadExpression, range, "", "")
    }

    pub fn is_reported(&self) -> bool {
        self.message.is_empty()
    }
}

/// The use of a value.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct ValuePurpose {
    /// Number of decimals of ROUND inside a word, those of its address; `None` elsewhere: whole numbers.
    pub round_digits: Option<u8>,
    /// The value may be a comparison.
    pub condition: bool,
}

impl ValuePurpose {
    pub const CONDITION: ValuePurpose = ValuePurpose { round_digits: None, condition: true };
    pub const VALUE: ValuePurpose = ValuePurpose { round_digits: None, condition: false };
}

/// Evaluates the steps of an expression; the caller keeps the stack to avoid allocations.
pub(crate) fn evaluate(
    steps: &[ExpressionStep],
    rules: &MacroRules,
    purpose: ValuePurpose,
    stack: &mut Vec<MacroValue>,
    variables: &mut dyn VariableReader,
) -> Result<MacroValue, EvaluationError> {
    stack.clear();
    for (index, step) in steps.iter().enumerate() {
        let value = match step.op {
            StackOp::Number(number) => MacroValue::Number(number),
            StackOp::Unreadable => return Err(EvaluationError::already_reported(step.range)),
            StackOp::Read => match pop(stack).counted() {
                Err(cause) => MacroValue::Unknown(cause),
                Ok(number) if is_exists_operand(steps, index) => truth(variables.is_number(number)),
                Ok(number) => variables.read(number, step.range)?,
            },
            StackOp::ReadNamed(name) if is_exists_operand(steps, index) => {
                truth(variables.is_set(name))
            }
            StackOp::ReadNamed(name) => variables.read_named(name, step.range)?,
            StackOp::Letters(letters) => match pop(stack).counted() {
                Err(cause) => MacroValue::Unknown(cause),
                Ok(number) => variables.read_letters(letters, number, step.range)?,
            },
            StackOp::Negate => match pop(stack).counted() {
                Err(cause) => MacroValue::Unknown(cause),
                Ok(number) => MacroValue::Number(-number),
            },
            StackOp::Binary(operator) => {
                let b = pop(stack);
                let a = pop(stack);
                check_comparison(operator, rules, purpose, step)?;
                // Division by zero is an alarm, even of an unknown value.
                let divides = matches!(operator, Operator::Divide | Operator::Modulo);
                if divides && b.known() == Some(0.0) {
                    return Err(undefined_fault(FunctionError::DivisionByZero, step));
                }
                match unknown_of(a, b) {
                    Some(cause) => MacroValue::Unknown(cause),
                    None => defined(functions::binary(operator, a, b, rules), step)?,
                }
            }
            StackOp::Call { function: Function::Exists, .. } => {
                let before = index.checked_sub(1).map(|index| steps[index].op);
                if !matches!(before, Some(StackOp::Read | StackOp::ReadNamed(_))) {
                    return Err(EvaluationError::new(
                        Code::BadExpression,
                        step.range,
                        "EXISTS needs a variable, not a value",
                        "write the variable with its `#`: `EXISTS[#<depth>]`",
                    ));
                }
                pop(stack)
            }
            StackOp::Call { function, two: false } => match pop(stack).counted() {
                Err(cause) => MacroValue::Unknown(cause),
                Ok(x) => {
                    let radians = variables.radians();
                    let x = if radians && takes_angle(function) { x.to_degrees() } else { x };
                    let value = functions::one(function, x, rules, purpose.round_digits);
                    let angle = radians && function == Function::Atan;
                    defined(
                        value.map(|value| if angle { value.to_radians() } else { value }),
                        step,
                    )?
                }
            },
            StackOp::Call { function, two: true } => {
                let b = pop(stack);
                let a = pop(stack);
                match (a.counted(), b.counted()) {
                    (Ok(a), Ok(b)) => defined(functions::two(function, a, b, rules), step)?,
                    (Err(cause), _) | (_, Err(cause)) => MacroValue::Unknown(cause),
                }
            }
        };
        stack.push(value);
    }
    Ok(pop(stack))
}

/// The cause of the first unknown value of two; `None` when both are known.
fn unknown_of(a: MacroValue, b: MacroValue) -> Option<UnknownCause> {
    a.counted().err().or(b.counted().err())
}

fn truth(holds: bool) -> MacroValue {
    MacroValue::Number(if holds { 1.0 } else { 0.0 })
}

/// True when the variable of a step is the operand of EXISTS.
fn is_exists_operand(steps: &[ExpressionStep], index: usize) -> bool {
    let next = steps.get(index + 1).map(|step| step.op);
    matches!(next, Some(StackOp::Call { function: Function::Exists, .. }))
}

fn takes_angle(function: Function) -> bool {
    matches!(function, Function::Sin | Function::Cos | Function::Tan)
}

fn pop(stack: &mut Vec<MacroValue>) -> MacroValue {
    stack.pop().unwrap_or(MacroValue::Vacant)
}

fn check_comparison(
    operator: Operator,
    rules: &MacroRules,
    purpose: ValuePurpose,
    step: &ExpressionStep,
) -> Result<(), EvaluationError> {
    if purpose.condition || rules.comparison_is_value || !operator.is_comparison() {
        return Ok(());
    }
    Err(EvaluationError::new(
        Code::ConditionAsValue,
        step.range,
        "a comparison has no value that could be used as a number",
        "put it into the condition of IF",
    ))
}

fn defined(
    result: Result<f64, FunctionError>,
    step: &ExpressionStep,
) -> Result<MacroValue, EvaluationError> {
    let value = match result {
        Ok(value) => value,
        Err(undefined) => return Err(undefined_fault(undefined, step)),
    };
    if value.is_finite() {
        return Ok(MacroValue::Number(value));
    }
    Err(EvaluationError::new(
        Code::NumberOverflow,
        step.range,
        "this value is too large for the control",
        "look for a divisor near zero, or a loop that multiplies without end",
    ))
}

#[cold]
fn undefined_fault(undefined: FunctionError, step: &ExpressionStep) -> EvaluationError {
    match undefined {
        FunctionError::DivisionByZero => EvaluationError::new(
            Code::DivisionByZero,
            step.range,
            "this divides by zero",
            "test the divisor with IF before; a variable that was never set counts as zero",
        ),
        FunctionError::Domain(x) => EvaluationError::new(
            Code::OutsideDomain,
            step.range,
            format!("this function has no value for {x}"),
            "test the argument with IF before",
        ),
        FunctionError::Unknown => EvaluationError::new(
            Code::UnsupportedMacro,
            step.range,
            "Chordal does not know the value of this function",
            "put the value into a variable, and give that in the machine file",
        ),
    }
}
