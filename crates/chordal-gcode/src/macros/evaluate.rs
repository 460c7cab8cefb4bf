//! Runs the steps of an expression.

use chordal_diagnostics::{Code, TextRange};
use chordal_dialect::macros::MacroRules;
use chordal_syntax::{Function, Op, Operator, Step};

use super::functions::{self, Undefined};
use super::value::{Cause, Value};

/// What is read while an expression is evaluated.
pub(crate) trait Variables {
    /// The variable of a number.
    fn read(&mut self, number: f64, range: TextRange) -> Result<Value, Fault>;

    /// The variable of a name.
    fn read_named(&mut self, name: TextRange, range: TextRange) -> Result<Value, Fault>;

    /// True when a named variable is set.
    fn is_set(&mut self, name: TextRange) -> bool;

    /// True when there is a variable of this number.
    fn is_number(&mut self, number: f64) -> bool {
        self.read(number, TextRange::default()).is_ok()
    }

    /// A variable written with letters: its place in the grammar's list, and its number.
    fn read_letters(&mut self, letters: u8, number: f64, range: TextRange) -> Result<Value, Fault>;

    /// Angles are radians, not degrees.
    fn radians(&self) -> bool {
        false
    }
}

/// Why an expression has no value.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Fault {
    pub code: Code,
    pub range: TextRange,
    pub message: String,
    pub help: &'static str,
}

impl Fault {
    pub fn new(
        code: Code,
        range: TextRange,
        message: impl Into<String>,
        help: &'static str,
    ) -> Fault {
        Fault { code, range, message: message.into(), help }
    }

    /// What could not be read has been told; there is nothing to tell again.
    pub fn told(range: TextRange) -> Fault {
        Fault::new(Code::BadExpression, range, "", "")
    }

    pub fn is_told(&self) -> bool {
        self.message.is_empty()
    }
}

/// How a value is used.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Purpose {
    /// ROUND goes to this many decimals: those of the address, inside a word.
    pub round_digits: Option<u8>,
    /// A comparison may be the value.
    pub condition: bool,
}

impl Purpose {
    pub const CONDITION: Purpose = Purpose { round_digits: None, condition: true };
    pub const VALUE: Purpose = Purpose { round_digits: None, condition: false };
}

/// Evaluates; the stack is the caller's, to be used again.
pub(crate) fn evaluate(
    steps: &[Step],
    rules: &MacroRules,
    purpose: Purpose,
    stack: &mut Vec<Value>,
    variables: &mut dyn Variables,
) -> Result<Value, Fault> {
    stack.clear();
    for (index, step) in steps.iter().enumerate() {
        let value = match step.op {
            Op::Number(number) => Value::Number(number),
            Op::Unreadable => return Err(Fault::told(step.range)),
            Op::Read => match pop(stack).counted() {
                Err(cause) => Value::Unknown(cause),
                Ok(number) if is_asked(steps, index) => truth(variables.is_number(number)),
                Ok(number) => variables.read(number, step.range)?,
            },
            Op::ReadNamed(name) if is_asked(steps, index) => truth(variables.is_set(name)),
            Op::ReadNamed(name) => variables.read_named(name, step.range)?,
            Op::Letters(letters) => match pop(stack).counted() {
                Err(cause) => Value::Unknown(cause),
                Ok(number) => variables.read_letters(letters, number, step.range)?,
            },
            Op::Negate => match pop(stack).counted() {
                Err(cause) => Value::Unknown(cause),
                Ok(number) => Value::Number(-number),
            },
            Op::Binary(operator) => {
                let b = pop(stack);
                let a = pop(stack);
                check_comparison(operator, rules, purpose, step)?;
                // Whatever is divided by zero is an alarm.
                let divides = matches!(operator, Operator::Divide | Operator::Modulo);
                if divides && b.known() == Some(0.0) {
                    return Err(undefined_fault(Undefined::DivisionByZero, step));
                }
                match unknown_of(a, b) {
                    Some(cause) => Value::Unknown(cause),
                    None => defined(functions::binary(operator, a, b, rules), step)?,
                }
            }
            Op::Call { function: Function::Exists, .. } => {
                let before = index.checked_sub(1).map(|index| steps[index].op);
                if !matches!(before, Some(Op::Read | Op::ReadNamed(_))) {
                    return Err(Fault::new(
                        Code::BadExpression,
                        step.range,
                        "EXISTS needs a variable, not a value",
                        "write the variable with its `#`: `EXISTS[#<depth>]`",
                    ));
                }
                pop(stack)
            }
            Op::Call { function, two: false } => match pop(stack).counted() {
                Err(cause) => Value::Unknown(cause),
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
            Op::Call { function, two: true } => {
                let b = pop(stack);
                let a = pop(stack);
                match (a.counted(), b.counted()) {
                    (Ok(a), Ok(b)) => defined(functions::two(function, a, b, rules), step)?,
                    (Err(cause), _) | (_, Err(cause)) => Value::Unknown(cause),
                }
            }
        };
        stack.push(value);
    }
    Ok(pop(stack))
}

/// Why one of two values is not known, the first one first.
fn unknown_of(a: Value, b: Value) -> Option<Cause> {
    a.counted().err().or(b.counted().err())
}

fn truth(holds: bool) -> Value {
    Value::Number(if holds { 1.0 } else { 0.0 })
}

/// Whether EXISTS asks for the variable of a step.
fn is_asked(steps: &[Step], index: usize) -> bool {
    let next = steps.get(index + 1).map(|step| step.op);
    matches!(next, Some(Op::Call { function: Function::Exists, .. }))
}

fn takes_angle(function: Function) -> bool {
    matches!(function, Function::Sin | Function::Cos | Function::Tan)
}

fn pop(stack: &mut Vec<Value>) -> Value {
    stack.pop().unwrap_or(Value::Vacant)
}

fn check_comparison(
    operator: Operator,
    rules: &MacroRules,
    purpose: Purpose,
    step: &Step,
) -> Result<(), Fault> {
    if purpose.condition || rules.comparison_is_value || !operator.is_comparison() {
        return Ok(());
    }
    Err(Fault::new(
        Code::ConditionAsValue,
        step.range,
        "a comparison has no value that could be used as a number",
        "put it into the condition of IF",
    ))
}

fn defined(result: Result<f64, Undefined>, step: &Step) -> Result<Value, Fault> {
    let value = match result {
        Ok(value) => value,
        Err(undefined) => return Err(undefined_fault(undefined, step)),
    };
    if value.is_finite() {
        return Ok(Value::Number(value));
    }
    Err(Fault::new(
        Code::NumberOverflow,
        step.range,
        "this value is too large for the control",
        "look for a divisor near zero, or a loop that multiplies without end",
    ))
}

#[cold]
fn undefined_fault(undefined: Undefined, step: &Step) -> Fault {
    match undefined {
        Undefined::DivisionByZero => Fault::new(
            Code::DivisionByZero,
            step.range,
            "this divides by zero",
            "test the divisor with IF before; a variable that was never set counts as zero",
        ),
        Undefined::Domain(x) => Fault::new(
            Code::OutsideDomain,
            step.range,
            format!("this function has no value for {x}"),
            "test the argument with IF before",
        ),
        Undefined::Unknown => Fault::new(
            Code::UnsupportedMacro,
            step.range,
            "Chordal does not know the value of this function",
            "put the value into a variable, and give that in the machine file",
        ),
    }
}
