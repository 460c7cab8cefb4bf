//! Random formulas and FN blocks against a second evaluator: two stacks (shunting-yard) over tokens that it reads itself.
//!
//! Functions are calculated by another library here, so that every value carries a bound of its error; a formula whose
//! branch (a root, a whole part, a division) hangs on less than that bound is counted and left out.

mod support;

use chordal_heidenhain::syntax::{KlartextReader, KlartextStatement, ParameterBank, ParameterName};
use chordal_heidenhain::values::{FormulaError, ParameterStore, formula_value};
use support::NumberSequence;

const FORMULAS: u32 = 20_000;

// ---- Random texts ----

const FUNCTIONS: [&str; 16] = [
    "SIN", "COS", "TAN", "ASIN", "ACOS", "ATAN", "SQ", "SQRT", "LN", "LOG", "EXP", "ABS", "INT",
    "FRAC", "NEG", "SGN",
];

const NUMBERS: [&str; 16] = [
    "0", "1", "2", "3.5", "10", "30", "90", "45.", ".25", "0,75", "180", "360", "1000", "7.125",
    "PI", "12",
];

/// The parameters with a value; Q77 has none.
const PARAMETERS: [&str; 6] = ["Q1", "Q2", "Q3", "QL4", "QR5", "Q1650"];

fn operand_text(numbers: &mut NumberSequence, depth: u32) -> String {
    let space = numbers.one_of(&["", " "]);
    match numbers.below(if depth > 4 { 4 } else { 9 }) {
        0..=2 => numbers.one_of(&NUMBERS).to_string(),
        3 if numbers.below(20) == 0 => "Q77".to_string(),
        3 => numbers.one_of(&PARAMETERS).to_string(),
        4 => format!("({space}{}{space})", sum_text(numbers, depth + 1)),
        5 => format!("{}{space}{}", numbers.one_of(&["-", "+"]), operand_text(numbers, depth + 1)),
        _ => format!("{} {}", numbers.one_of(&FUNCTIONS), operand_text(numbers, depth + 1)),
    }
}

fn sum_text(numbers: &mut NumberSequence, depth: u32) -> String {
    let mut text = operand_text(numbers, depth);
    for _ in 0..numbers.below(if depth == 0 { 5 } else { 3 }) {
        let sign = numbers.one_of(&["+", "-", "*", "/", "^", "%"]);
        let space = numbers.one_of(&["", " "]);
        text += &format!("{space}{sign}{space}{}", operand_text(numbers, depth + 1));
    }
    text
}

/// A value of an FN block: a number or a parameter with a sign.
fn value_text(numbers: &mut NumberSequence) -> String {
    let sign = numbers.one_of(&["+", "-", "+", ""]);
    let value = match numbers.below(2) {
        0 => numbers.one_of(&["0", "1", "5", "2.5", "30", "90", "100"]),
        _ => numbers.one_of(&["Q1", "Q2", "Q3", "QL4"]),
    };
    format!("{sign}{value}")
}

/// An FN block and its formula.
fn block_text(numbers: &mut NumberSequence) -> (String, String) {
    let (first, second) = (value_text(numbers), value_text(numbers));
    let (number, formula) = match numbers.below(10) {
        0 => (0, first),
        1 => (1, format!("{first} + {second}")),
        2 => (2, format!("{first} - {second}")),
        3 => (3, format!("{first} * {second}")),
        4 => (4, format!("{first} DIV {second}")),
        5 => (5, format!("SQRT {first}")),
        6 => (6, format!("SIN {first}")),
        7 => (7, format!("COS {first}")),
        8 => (8, format!("{first} LEN {second}")),
        _ => (13, format!("{first} ANG {second}")),
    };
    let head = numbers.one_of(&["FN ", "FN"]);
    (format!("{head}{number}: Q20 = {formula}"), formula)
}

// ---- The second evaluator ----

/// A value and how far it may be off.
#[derive(Clone, Copy, Debug)]
struct FormulaBounds {
    value: f64,
    error: f64,
}

/// Why there is no value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Refusal {
    Division,
    Domain,
    Unset,
    TooLarge,
    /// The bounds do not decide.
    Doubt,
}

type Evaluated = Result<FormulaBounds, Refusal>;

#[derive(Clone, PartialEq, Debug)]
enum FormulaToken {
    Number(f64),
    Parameter(String),
    Name(String),
    Sign(char),
}

fn tokens(text: &str) -> Vec<FormulaToken> {
    let characters: Vec<char> = text.chars().collect();
    let mut found = Vec::new();
    let mut at = 0;
    while at < characters.len() {
        let from = at;
        let mut take = |allowed: fn(char) -> bool| {
            while characters.get(at).is_some_and(|own| allowed(*own)) {
                at += 1;
            }
            characters[from..at].iter().collect::<String>()
        };
        match characters[from] {
            ' ' => at += 1,
            'A'..='Z' => {
                let name = take(|own| own.is_ascii_alphabetic());
                if name.starts_with('Q') {
                    let digits = take(|own| own.is_ascii_alphanumeric());
                    found.push(FormulaToken::Parameter(digits));
                } else {
                    found.push(FormulaToken::Name(name));
                }
            }
            '0'..='9' | '.' => {
                let number = take(|own| own.is_ascii_digit() || own == '.' || own == ',');
                found.push(FormulaToken::Number(
                    number.replace(',', ".").parse().expect("a number"),
                ));
            }
            sign => {
                found.push(FormulaToken::Sign(sign));
                at += 1;
            }
        }
    }
    found
}

/// An entry of the stack of operators.
#[derive(Clone, PartialEq, Debug)]
enum Pending {
    Prefix(String),
    Infix(String),
    Open,
}

fn strength(operator: &str) -> u32 {
    match operator {
        "+" | "-" => 1,
        "^" => 3,
        _ => 2,
    }
}

struct StackEvaluator<'s> {
    store: &'s [(&'static str, f64)],
    values: Vec<FormulaBounds>,
    pending: Vec<Pending>,
}

impl StackEvaluator<'_> {
    fn evaluate(mut self, text: &str) -> Evaluated {
        let mut expects_operand = true;
        for token in tokens(text) {
            expects_operand = match token {
                FormulaToken::Number(value) => self.operand(value)?,
                FormulaToken::Parameter(name) => {
                    let found = self.store.iter().find(|(own, _)| *own == name);
                    self.operand(found.ok_or(Refusal::Unset)?.1)?
                }
                FormulaToken::Name(name) if name == "PI" => self.operand(std::f64::consts::PI)?,
                FormulaToken::Name(name) if !expects_operand => self.infix(name)?,
                FormulaToken::Name(name) => {
                    self.pending.push(Pending::Prefix(name));
                    true
                }
                FormulaToken::Sign('(') => {
                    self.pending.push(Pending::Open);
                    true
                }
                FormulaToken::Sign(')') => {
                    self.reduce(0)?;
                    assert_eq!(self.pending.pop(), Some(Pending::Open));
                    self.apply_prefixes()?;
                    false
                }
                FormulaToken::Sign(sign) if expects_operand => {
                    let name = if sign == '-' { "NEG" } else { "" };
                    self.pending.push(Pending::Prefix(name.to_string()));
                    true
                }
                FormulaToken::Sign(sign) => self.infix(sign.to_string())?,
            };
        }
        self.reduce(0)?;
        Ok(self.values.pop().expect("a value"))
    }

    fn operand(&mut self, value: f64) -> Result<bool, Refusal> {
        self.values.push(FormulaBounds { value, error: 0.0 });
        self.apply_prefixes()?;
        Ok(false)
    }

    fn infix(&mut self, name: String) -> Result<bool, Refusal> {
        self.reduce(strength(&name))?;
        self.pending.push(Pending::Infix(name));
        Ok(true)
    }

    /// Functions and signs take the operand that comes after them.
    fn apply_prefixes(&mut self) -> Result<(), Refusal> {
        while let Some(Pending::Prefix(name)) = self.pending.last().cloned() {
            self.pending.pop();
            let operand = self.values.pop().expect("an operand");
            self.values.push(checked(function_of(&name, operand)?)?);
        }
        Ok(())
    }

    /// Applies the operators that bind as strongly as this, from the left.
    fn reduce(&mut self, least: u32) -> Result<(), Refusal> {
        while let Some(Pending::Infix(name)) = self.pending.last().cloned() {
            if strength(&name) < least {
                break;
            }
            self.pending.pop();
            let second = self.values.pop().expect("an operand");
            let first = self.values.pop().expect("an operand");
            self.values.push(checked(operator_of(&name, first, second)?)?);
        }
        Ok(())
    }
}

fn checked(own: FormulaBounds) -> Evaluated {
    if !own.value.is_finite() {
        return Err(Refusal::TooLarge);
    }
    let is_doubtful = !own.error.is_finite() || own.value.abs() > 1e300;
    if is_doubtful { Err(Refusal::Doubt) } else { Ok(own) }
}

/// The sign of a value; doubtful within its error.
fn sign_of(own: FormulaBounds) -> Result<i32, Refusal> {
    match own.value.partial_cmp(&0.0).expect("a number") as i32 {
        sign if own.error == 0.0 || own.value.abs() > 2.0 * own.error => Ok(sign),
        _ => Err(Refusal::Doubt),
    }
}

/// A value whose whole part is sure.
fn surely_between_integers(own: FormulaBounds) -> Result<f64, Refusal> {
    let off = (own.value - own.value.round()).abs();
    if own.error == 0.0 || off > 2.0 * own.error { Ok(own.value) } else { Err(Refusal::Doubt) }
}

/// A value with an error that comes from that of the operand by a slope, and from the function.
fn calculated(value: f64, slope: f64, operand: FormulaBounds) -> Evaluated {
    let error = slope.abs() * operand.error + 1e-14 * value.abs().max(f64::MIN_POSITIVE);
    Ok(FormulaBounds { value, error })
}

fn function_of(name: &str, x: FormulaBounds) -> Evaluated {
    let radians = x.value.to_radians();
    let slope = 1_f64.to_radians();
    let quarters = x.value / 90.0;
    let is_quarter = x.error == 0.0 && quarters.fract() == 0.0;
    // Angles of many turns lose digits before the function is calculated.
    let angle = FormulaBounds { value: x.value, error: x.error + 1e-13 * x.value.abs() };
    match name {
        "" => Ok(x),
        "NEG" => Ok(FormulaBounds { value: -x.value, ..x }),
        "SIN" | "COS" if is_quarter => {
            let shift = if name == "COS" { 1.0 } else { 0.0 };
            let value = match (quarters + shift).rem_euclid(4.0) as i32 {
                1 => 1.0,
                3 => -1.0,
                _ => 0.0,
            };
            Ok(FormulaBounds { value, error: 0.0 })
        }
        "SIN" => calculated(radians.sin(), slope, angle),
        "COS" => calculated(radians.cos(), slope, angle),
        "TAN" if is_quarter && quarters.rem_euclid(2.0) == 1.0 => Err(Refusal::Domain),
        "TAN" if is_quarter => Ok(FormulaBounds { value: 0.0, error: 0.0 }),
        "TAN" => {
            let cos = radians.cos();
            if cos.abs() < 1e3 * angle.error * slope {
                return Err(Refusal::Doubt);
            }
            calculated(radians.tan(), 2.0 * slope / (cos * cos), angle)
        }
        "ASIN" | "ACOS" => {
            let room = 1.0 - x.value.abs();
            if x.error > 0.0 && room.abs() < 1e3 * x.error {
                return Err(Refusal::Doubt);
            }
            if room < 0.0 {
                return Err(Refusal::Domain);
            }
            let angle = if name == "ASIN" { x.value.asin() } else { x.value.acos() };
            let slope =
                if x.error == 0.0 { 0.0 } else { 60.0 / (room * (1.0 + x.value.abs())).sqrt() };
            calculated(angle.to_degrees(), slope, x)
        }
        "ATAN" => calculated(x.value.atan().to_degrees(), 60.0, x),
        "SQ" => Ok(FormulaBounds {
            value: x.value * x.value,
            error: 3.0 * x.value.abs() * x.error + x.error * x.error,
        }),
        "SQRT" => match sign_of(x)? {
            -1 => Err(Refusal::Domain),
            0 => Ok(FormulaBounds { value: 0.0, error: 0.0 }),
            _ if x.error == 0.0 => Ok(FormulaBounds { value: x.value.sqrt(), error: 0.0 }),
            _ => calculated(x.value.sqrt(), 1.0 / x.value.sqrt(), x),
        },
        "LN" | "LOG" => match sign_of(x)? {
            1 => {
                let value = if name == "LN" { x.value.ln() } else { x.value.log10() };
                // Near 1 the function is small, and its own error is not.
                let own = calculated(value, 2.0 / x.value, x)?;
                Ok(FormulaBounds { error: own.error + 1e-15, ..own })
            }
            _ => Err(Refusal::Domain),
        },
        "EXP" => {
            let value = x.value.exp();
            let own = calculated(value, 2.0 * value, x)?;
            Ok(FormulaBounds { error: own.error * (1.0 + x.value.abs()), ..own })
        }
        "ABS" => Ok(FormulaBounds { value: x.value.abs(), ..x }),
        "INT" => {
            let whole = surely_between_integers(x)?;
            let value = if whole < 0.0 { whole.ceil() } else { whole.floor() };
            Ok(FormulaBounds { value, error: 0.0 })
        }
        "FRAC" => {
            let whole = surely_between_integers(x)?;
            let trunc = if whole < 0.0 { whole.ceil() } else { whole.floor() };
            Ok(FormulaBounds { value: whole - trunc, error: x.error })
        }
        "SGN" => Ok(FormulaBounds { value: f64::from(sign_of(x)?), error: 0.0 }),
        name => panic!("{name} is no function"),
    }
}

fn operator_of(name: &str, first: FormulaBounds, second: FormulaBounds) -> Evaluated {
    let (a, b) = (first.value, second.value);
    let (da, db) = (first.error, second.error);
    // The same operation of the same numbers is the same to the last bit.
    let rounding = |value: f64| if da == 0.0 && db == 0.0 { 0.0 } else { 1e-15 * value.abs() };
    let of = |value: f64, error: f64| Ok(FormulaBounds { value, error: error + rounding(value) });
    match name {
        "+" => of(a + b, da + db),
        "-" => of(a - b, da + db),
        "*" => of(a * b, a.abs() * db + b.abs() * da + da * db),
        "/" | "DIV" => match sign_of(second)? {
            0 => Err(Refusal::Division),
            _ => of(a / b, 2.0 * (da + (a / b).abs() * db) / b.abs()),
        },
        "%" => match sign_of(second)? {
            0 => Err(Refusal::Division),
            _ if da == 0.0 && db == 0.0 => of(a - b * exact_whole(a, b)?, 1e-12 * b.abs()),
            _ => {
                let error = 2.0 * (da + (a / b).abs() * db) / b.abs();
                let whole = surely_between_integers(FormulaBounds { value: a / b, error })?.trunc();
                of(a - b * whole, da + whole.abs() * db + 1e-12 * a.abs())
            }
        },
        "^" => power_of(first, second),
        "LEN" => calculated(a.hypot(b), 2.0, FormulaBounds { value: 0.0, error: da + db }),
        "ANG" => {
            let degrees = a.atan2(b).to_degrees();
            calculated(if degrees < 0.0 { degrees + 360.0 } else { degrees }, 0.0, first)
        }
        name => panic!("{name} is no operator"),
    }
}

/// How often a divisor is contained in a number; doubtful where rounding decides.
fn exact_whole(a: f64, b: f64) -> Result<f64, Refusal> {
    let quotient = a / b;
    // Such numbers and their multiples have no rounding.
    let is_plain = |own: f64| (own * 64.0).fract() == 0.0 && own.abs() < 1e9;
    let off = (quotient - quotient.round()).abs();
    if quotient.abs() > 1e9 || !(is_plain(a) && is_plain(b)) && off < 1e-9 {
        return Err(Refusal::Doubt);
    }
    Ok(quotient.trunc())
}

fn power_of(first: FormulaBounds, second: FormulaBounds) -> Evaluated {
    let (a, b) = (first.value, second.value);
    let is_exact = first.error == 0.0 && second.error == 0.0;
    if sign_of(second)? == 0 {
        return Ok(FormulaBounds { value: 1.0, error: 0.0 });
    }
    match sign_of(first)? {
        0 if b < 0.0 => return Err(Refusal::Division),
        0 => return Ok(FormulaBounds { value: 0.0, error: 0.0 }),
        -1 if second.error > 0.0 => return Err(Refusal::Doubt),
        -1 if b.fract() != 0.0 => return Err(Refusal::Domain),
        _ => {}
    }
    // By its logarithm, with the sign of odd powers.
    let exponent = b * a.abs().ln();
    if exponent.abs() > 690.0 {
        return if exponent > 710.0 { Err(Refusal::TooLarge) } else { Err(Refusal::Doubt) };
    }
    let sign = if a < 0.0 && b.rem_euclid(2.0) == 1.0 { -1.0 } else { 1.0 };
    let value = sign * exponent.exp();
    let relative = match is_exact {
        true => 0.0,
        false => 2.0 * (b.abs() * first.error / a.abs() + second.error * a.abs().ln().abs()),
    };
    let error = value.abs() * (relative + 1e-14 * (1.0 + exponent.abs()));
    Ok(FormulaBounds { value, error })
}

// ---- The comparison ----

fn name_of(text: &str) -> ParameterName {
    let digits = text.trim_start_matches(|own: char| own.is_ascii_alphabetic());
    let bank = match &text[..text.len() - digits.len()] {
        "QL" => ParameterBank::Local,
        "QR" => ParameterBank::Retained,
        _ => ParameterBank::Shared,
    };
    ParameterName { bank, number: digits.parse().expect("a number") }
}

fn found_value(text: &str, store: &ParameterStore) -> Result<f64, Refusal> {
    let block = KlartextReader::new(text.as_bytes()).next().expect("a block");
    let KlartextStatement::Assign { formula, .. } = block.statement else {
        panic!("{text}: {:?}", block.faults);
    };
    formula_value(&formula, store).map_err(|error| match error {
        FormulaError::DivisionByZero(_) => Refusal::Division,
        FormulaError::OutsideDomain(..) => Refusal::Domain,
        FormulaError::Unset(..) => Refusal::Unset,
        FormulaError::Overflow(_) => Refusal::TooLarge,
    })
}

#[test]
fn random_formulas_have_the_value_of_a_second_evaluator() {
    let mut numbers = NumberSequence(20_250_711);
    let (mut values, mut refused, mut doubtful) = (0, 0, 0);
    for _ in 0..FORMULAS {
        let (text, formula) = match numbers.below(4) {
            0 => block_text(&mut numbers),
            _ => {
                let formula = sum_text(&mut numbers, 0);
                (format!("Q20 = {formula}"), formula)
            }
        };
        let mut set = Vec::new();
        for name in PARAMETERS {
            set.push((name, (numbers.next() * 400.0 - 200.0).round() / 4.0));
        }
        let mut store = ParameterStore::default();
        set.iter().for_each(|(name, value)| store.set(name_of(name), *value));
        let evaluator = StackEvaluator { store: &set, values: Vec::new(), pending: Vec::new() };
        let expected = evaluator.evaluate(&formula);
        let found = found_value(&text, &store);
        match (expected, found) {
            (Err(Refusal::Doubt), _) => doubtful += 1,
            (Ok(expected), Ok(found)) => {
                let off = (found - expected.value).abs();
                let allowed = 4.0 * expected.error + 1e-13 * expected.value.abs();
                assert!(off <= allowed, "{text} is {found}, not {expected:?}\n{set:?}");
                values += 1;
            }
            (Err(expected), Err(found)) => {
                assert_eq!(expected, found, "{text}\n{set:?}");
                refused += 1;
            }
            (expected, found) => panic!("{text} is {found:?}, not {expected:?}\n{set:?}"),
        }
    }
    println!("{values} values, {refused} errors, {doubtful} left out");
    assert!(doubtful < FORMULAS / 16, "{doubtful} are left out");
    assert!(refused > FORMULAS / 50, "{refused} errors are few");
}

#[test]
fn worked_values() {
    let store = ParameterStore::default();
    let near = |text: &str, expected: f64| {
        let found = found_value(text, &store).expect("a value");
        assert!((found - expected).abs() < 1e-9, "{text}: {found}");
    };
    near("Q12 = 400 % 360", 40.0);
    near("Q12 = -7 % 3", -1.0);
    near("Q12 = 2 * PI", std::f64::consts::TAU);
    near("Q12 = NEG PI", -std::f64::consts::PI);
    near("Q12 = SGN 0", 0.0);
    near("Q12 = SQ 3 ^ 2", 81.0);
    near("Q12 = 2 ^ 3 ^ 2", 64.0);
    // An angle of 0 to 360 degrees is below 360.
    near("FN 13: Q12 = -0.000000000000000000001 ANG +1", 0.0);
    assert_eq!(found_value("Q12 = 5 % 0", &store), Err(Refusal::Division));
    assert_eq!(found_value("Q12 = 0 ^ NEG 1", &store), Err(Refusal::Division));
}
