//! Random expressions against an evaluator of another kind: two stacks over a list of tokens, computing with plain numbers.

use chordal_sinumerik::syntax::{Address, BlockReader, Expression, StatementKind, WordValue};
use chordal_sinumerik::values::{EvaluationError, SinumerikValue, VariableSource, evaluate};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, TestRunner};

/// A part of an expression in the order of the text.
#[derive(Clone, Debug)]
enum Piece {
    Number(&'static str),
    Register(u32),
    Prefix(&'static str),
    Function(&'static str),
    Open,
    Close,
    Infix(&'static str),
}

/// A number as the control has it: `is_whole` is INT or BOOL.
#[derive(Clone, Copy, Debug)]
struct Amount {
    number: f64,
    is_whole: bool,
}

/// The levels of the manual, the tightest first (Job Planning 07/2010, 1.7).
const LEVELS: [&[&str]; 8] = [
    &["*", "/", "DIV", "MOD"],
    &["+", "-"],
    &["B_AND"],
    &["B_XOR"],
    &["B_OR"],
    &["AND"],
    &["XOR"],
    &["OR"],
];

const COMPARISONS: [&str; 6] = ["==", "<>", ">", "<", ">=", "<="];

const REGISTERS: [f64; 6] = [0.0, 1.0, -2.5, 3.0, 0.125, 1e6];

fn level(operator: &str) -> usize {
    LEVELS.iter().position(|level| level.contains(&operator)).unwrap_or(LEVELS.len())
}

/// What an operator on the stack does when its operands are there.
#[derive(Clone, Copy, Debug)]
enum Waiting {
    Prefix(&'static str),
    Infix(&'static str),
    Open,
    Function(&'static str),
}

#[derive(Default)]
struct TwoStacks {
    amounts: Vec<Amount>,
    waiting: Vec<Waiting>,
}

impl TwoStacks {
    /// The value of the pieces; `None` for an alarm.
    fn value(pieces: &[Piece]) -> Option<Amount> {
        let mut stacks = TwoStacks::default();
        for piece in pieces {
            match piece {
                Piece::Number(text) => {
                    let number = decimal(text);
                    let is_whole = !text.contains(['.', 'E']);
                    stacks.amounts.push(Amount { number, is_whole });
                }
                Piece::Register(index) => stacks
                    .amounts
                    .push(Amount { number: REGISTERS[*index as usize], is_whole: false }),
                Piece::Prefix(operator) => stacks.waiting.push(Waiting::Prefix(operator)),
                Piece::Function(name) => stacks.waiting.push(Waiting::Function(name)),
                Piece::Open => stacks.waiting.push(Waiting::Open),
                Piece::Close => stacks.close()?,
                Piece::Infix(operator) => {
                    stacks.reduce(level(operator))?;
                    stacks.waiting.push(Waiting::Infix(operator));
                }
            }
        }
        stacks.reduce(usize::MAX)?;
        stacks.amounts.pop()
    }

    fn close(&mut self) -> Option<()> {
        self.reduce(usize::MAX)?;
        if let Some(Waiting::Function(name)) = self.waiting.pop() {
            let argument = self.amounts.pop()?.number;
            self.amounts.push(function(name, argument)?);
        }
        Some(())
    }

    /// Carries out what binds at least as tightly as a level, up to the next parenthesis.
    fn reduce(&mut self, greatest: usize) -> Option<()> {
        loop {
            match self.waiting.last().copied() {
                Some(Waiting::Prefix(operator)) => {
                    let amount = self.amounts.pop()?;
                    self.amounts.push(prefix(operator, amount)?);
                }
                Some(Waiting::Infix(operator)) if level(operator) <= greatest => {
                    let right = self.amounts.pop()?;
                    let left = self.amounts.pop()?;
                    self.amounts.push(infix(operator, left, right)?);
                }
                _ => return Some(()),
            }
            self.waiting.pop();
        }
    }
}

fn decimal(text: &str) -> f64 {
    text.replace("EX", "e").parse().expect("a number")
}

fn is_int(number: f64) -> bool {
    number.trunc() == number && (-2147483648.0..=2147483647.0).contains(&number)
}

/// INT by rounding; `None` out of range.
fn bits(amount: Amount) -> Option<i32> {
    let size = amount.number.abs();
    let (floor, part) = (size.floor(), size - size.floor());
    let rounded = (if part >= 0.5 { floor + 1.0 } else { floor }) * amount.number.signum();
    is_int(rounded).then_some(rounded as i32)
}

fn whole(number: f64) -> Option<Amount> {
    Some(Amount { number, is_whole: true })
}

/// A result that is INT when both operands are and it fits.
fn mixed(number: f64, both: bool) -> Option<Amount> {
    number.is_finite().then_some(Amount { number, is_whole: both && is_int(number) })
}

fn prefix(operator: &str, amount: Amount) -> Option<Amount> {
    match operator {
        "-" => mixed(-amount.number, amount.is_whole),
        "+" => Some(amount),
        "NOT " => whole(if amount.number == 0.0 { 1.0 } else { 0.0 }),
        _ => whole(-1.0 - f64::from(bits(amount)?)),
    }
}

fn function(name: &str, argument: f64) -> Option<Amount> {
    let number = match name {
        "SQRT" if argument >= 0.0 => argument.powf(0.5),
        "ABS" => argument.max(-argument),
        "POT" => argument * argument,
        "TRUNC" => argument - argument % 1.0,
        _ => return None,
    };
    Some(Amount { number, is_whole: false })
}

fn infix(operator: &str, left: Amount, right: Amount) -> Option<Amount> {
    let both = left.is_whole && right.is_whole;
    let (a, b) = (left.number, right.number);
    let truth = |value: bool| whole(f64::from(u8::from(value)));
    let (p, q) = (a != 0.0, b != 0.0);
    let near = a == b || ((a - b) / a.abs().max(b.abs())).abs() <= 1e-12;
    match operator {
        "+" => mixed(a + b, both),
        "-" => mixed(a - b, both),
        "*" => mixed(a * b, both),
        "/" if q => mixed(a / b, false),
        "DIV" if q => mixed((a / b) - (a / b) % 1.0, true),
        "MOD" if q => mixed(a % b, both),
        "B_AND" => whole(f64::from(bits(left)? & bits(right)?)),
        "B_XOR" => whole(f64::from(bits(left)? ^ bits(right)?)),
        "B_OR" => whole(f64::from(bits(left)? | bits(right)?)),
        "AND" => truth(p & q),
        "XOR" => truth(p ^ q),
        "OR" => truth(p | q),
        "==" => truth(near),
        "<>" => truth(!near),
        ">" => truth(a > b),
        "<" => truth(a < b),
        ">=" => truth(a > b || near),
        "<=" => truth(a < b || near),
        _ => None,
    }
}

fn numbers() -> impl Strategy<Value = Vec<Piece>> {
    let texts =
        vec!["0", "1", "2", "7", "13", "2147483647", "2.5", "0.5", ".25", "3.", "1.5EX-3", "1EX9"];
    prop_oneof![
        prop::sample::select(texts).prop_map(|text| vec![Piece::Number(text)]),
        (0..REGISTERS.len() as u32).prop_map(|index| vec![Piece::Register(index)]),
    ]
}

fn operators() -> impl Strategy<Value = &'static str> {
    let mut all: Vec<&str> = LEVELS.iter().flat_map(|level| level.iter().copied()).collect();
    all.extend(COMPARISONS);
    prop::sample::select(all)
}

fn expressions() -> impl Strategy<Value = Vec<Piece>> {
    numbers().prop_recursive(6, 40, 4, |inner| {
        let wrapped = |first: Piece, inner: Vec<Piece>| {
            let mut pieces = vec![first];
            pieces.extend(inner);
            pieces.push(Piece::Close);
            pieces
        };
        prop_oneof![
            inner.clone().prop_map(move |inner| wrapped(Piece::Open, inner)),
            (prop::sample::select(vec!["SQRT", "ABS", "POT", "TRUNC"]), inner.clone())
                .prop_map(move |(name, inner)| wrapped(Piece::Function(name), inner)),
            (prop::sample::select(vec!["-", "+", "NOT ", "B_NOT "]), inner.clone())
                .prop_map(|(operator, inner)| [vec![Piece::Prefix(operator)], inner].concat()),
            (inner.clone(), operators(), inner.clone(), operators(), inner).prop_map(
                |(a, first, b, second, c)| {
                    [a, vec![Piece::Infix(first)], b, vec![Piece::Infix(second)], c].concat()
                }
            ),
        ]
    })
}

/// The text of the pieces; blanks only around words.
fn text(pieces: &[Piece]) -> String {
    let mut text = String::from("R1=");
    for piece in pieces {
        match piece {
            Piece::Number(number) => text += number,
            Piece::Register(index) => text += &format!("R{index}"),
            Piece::Prefix(operator) => text += operator,
            Piece::Function(name) => text += &format!("{name}("),
            Piece::Open => text.push('('),
            Piece::Close => text.push(')'),
            Piece::Infix(word) if word.as_bytes()[0].is_ascii_alphabetic() => {
                text += &format!(" {word} ");
            }
            Piece::Infix(operator) => text += operator,
        }
    }
    text
}

struct RegisterSource;

impl VariableSource for RegisterSource {
    fn read(
        &mut self,
        address: &Address,
        _indices: &[i64],
    ) -> Result<SinumerikValue, EvaluationError> {
        let index = address.extension.expect("a register") as usize;
        Ok(SinumerikValue::Real(REGISTERS[index]))
    }

    fn call(
        &mut self,
        _name: &str,
        _arguments: &[Option<SinumerikValue>],
    ) -> Option<Result<SinumerikValue, EvaluationError>> {
        None
    }
}

fn parsed(line: &str) -> Expression {
    let block = BlockReader::new(line.as_bytes()).next().expect("a block");
    assert!(block.faults.is_empty() && block.statements.len() == 1, "{line}: {block:?}");
    match block.statements.into_iter().next().map(|statement| statement.kind) {
        Some(StatementKind::Word(word)) => match word.value {
            WordValue::Plain(value) => value,
            other => panic!("{line}: {other:?}"),
        },
        other => panic!("{line}: {other:?}"),
    }
}

#[test]
fn random_expressions_have_the_value_of_the_other_evaluator() {
    let mut runner = TestRunner::new(Config::with_cases(10_000));
    let (mut values, mut alarms) = (0, 0);
    let result = runner.run(&expressions(), |pieces| {
        let line = text(&pieces);
        let found = evaluate(&parsed(&line), &mut RegisterSource);
        match (TwoStacks::value(&pieces), found) {
            (None, Err(_)) => {}
            (Some(expected), Ok(found)) => {
                let number = found.to_real().expect("a number");
                let size = expected.number.abs().max(1.0);
                prop_assert!((number - expected.number).abs() <= 1e-9 * size, "{}", line);
            }
            (expected, found) => prop_assert!(false, "{}: {:?} {:?}", line, expected, found),
        }
        Ok(())
    });
    result.expect("every expression has the same value");
    // How many of a sample are values and how many are alarms, so that the test is not one of alarms alone.
    let mut sample = TestRunner::new(Config::with_cases(1000));
    for _ in 0..1000 {
        let tree = expressions().new_tree(&mut sample).expect("an expression");
        match TwoStacks::value(&tree.current()) {
            Some(_) => values += 1,
            None => alarms += 1,
        }
    }
    println!("{values} values, {alarms} alarms");
    assert!(values > 500 && alarms > 20);
}
