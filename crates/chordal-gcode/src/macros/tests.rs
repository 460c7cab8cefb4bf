//! Expressions with values that manuals and programs give.

use chordal_diagnostics::{Code, FileId, TextRange};
use chordal_dialect::macros::MacroRules;
use chordal_dialect::table;
use chordal_syntax::{ExpressionParser, MacroGrammar};

use super::evaluate::{EvaluationError, ValuePurpose, VariableReader, evaluate};
use super::value::{MacroValue, Truth, UnknownCause};

/// #1 = 1.00333, #2 = null, #20 = 4, #120 = 6; other variables hold their own number.
struct TestVariables;

impl VariableReader for TestVariables {
    fn read(&mut self, number: f64, _: TextRange) -> Result<MacroValue, EvaluationError> {
        Ok(match number as u32 {
            0 | 2 => MacroValue::Vacant,
            1 => MacroValue::Number(1.00333),
            20 => MacroValue::Number(4.0),
            120 => MacroValue::Number(6.0),
            700 => MacroValue::Unknown(UnknownCause::Variable(700)),
            _ => MacroValue::Number(number),
        })
    }

    fn read_named(&mut self, name: TextRange, _: TextRange) -> Result<MacroValue, EvaluationError> {
        Ok(MacroValue::Number(f64::from(name.len())))
    }

    fn is_set(&mut self, name: TextRange) -> bool {
        name.len() > 2
    }

    fn read_letters(
        &mut self,
        letters: u8,
        number: f64,
        _: TextRange,
    ) -> Result<MacroValue, EvaluationError> {
        Ok(MacroValue::Number(f64::from(letters) * 1000.0 + number))
    }

    fn radians(&self) -> bool {
        false
    }
}

fn run(
    text: &str,
    grammar: &'static MacroGrammar,
    rules: &MacroRules,
    purpose: ValuePurpose,
) -> Result<MacroValue, Code> {
    let mut parser = ExpressionParser::new(text.as_bytes(), FileId(0), grammar);
    parser.start(text.as_bytes(), FileId(0), TextRange::new(0, text.len() as u32));
    let expression = parser.expression();
    if let Some(problem) = parser.problems.first() {
        return Err(problem.code);
    }
    assert!(parser.rest().is_empty(), "{text}: left over at {:?}", parser.rest());
    let result =
        evaluate(parser.steps(expression), rules, purpose, &mut Vec::new(), &mut TestVariables);
    result.map_err(|fault| fault.code)
}

fn fanuc(text: &str) -> Result<MacroValue, Code> {
    let table = table(chordal_machine::ControlName::Fanuc).expect("a table");
    run(text, table.lexicon.grammar, table.macros, ValuePurpose::VALUE)
}

fn condition(text: &str) -> bool {
    let table = table(chordal_machine::ControlName::Fanuc).expect("a table");
    let value = run(text, table.lexicon.grammar, table.macros, ValuePurpose::CONDITION);
    Truth::from(value.expect(text)) == Truth::Holds
}

fn haas(text: &str, digits: Option<u8>) -> f64 {
    let table = table(chordal_machine::ControlName::Haas).expect("a table");
    let purpose = ValuePurpose { round_digits: digits, condition: false };
    run(text, table.lexicon.grammar, table.macros, purpose).expect(text).known().expect(text)
}

fn near(text: &str, expected: f64) {
    let value = fanuc(text).expect(text).known().expect(text);
    assert!((value - expected).abs() < 1e-9, "{text} is {value}, not {expected}");
}

#[test]
fn precedence_of_macro_b() {
    near("2+3*4", 14.0);
    near("[2+3]*4", 20.0);
    near("10-4-3", 3.0);
    near("100/10/5", 2.0);
    near("-2*-3", 6.0);
    near("-[2+3]", -5.0);
    near("#20*.6+-1.", 1.4);
    near("27 MOD 20", 7.0);
    near("12OR3", 15.0);
    near("2+12AND4", 6.0);
    // `IF[#120AND4EQ4]` of a probe maker's program is [#120 AND 4] EQ 4.
    assert!(condition("[#120AND4EQ4]"));
    assert!(condition("[[#120 EQ 6] AND [#20 EQ 4]]"));
    assert!(condition("ABS[#20-5]LT#20/2"));
}

#[test]
fn functions_of_macro_b() {
    near("SIN[30]", 0.5);
    near("COS[180]", -1.0);
    near("sin[360]+tan[45]", 1.0);
    near("ATAN[1]/[-1]", 135.0);
    near("ATAN[-1]/[-1]", 225.0);
    near("ATAN[-1,-1]", 225.0);
    near("ASIN[-.5]", 330.0);
    near("ACOS[-1]", 180.0);
    near("ROUND[-1.5]", -2.0);
    near("FIX[-1.5]", -1.0);
    near("FUP[-1.5]", -2.0);
    near("FU[1.1]+FI[1.9]+RO[1.5]", 5.0);
    near("BIN[BCD[1234]]", 1234.0);
    near("POW[2,10]", 1024.0);
    near("#[#20+#[#20]]", 8.0);
}

#[test]
fn rounding_inside_a_word_and_outside() {
    let sum = "ROUND[#1]+ROUND[#1]";
    assert!((haas(sum, Some(4)) - 2.0066).abs() < 1e-12);
    assert!((haas("#1+#1", Some(4)) - 2.00666).abs() < 1e-12);
    assert_eq!(haas(sum, None), 2.0);
}

#[test]
fn null_in_expressions() {
    assert_eq!(fanuc("#0"), Ok(MacroValue::Vacant));
    assert_eq!(fanuc("#2"), Ok(MacroValue::Vacant));
    assert_eq!(fanuc("#2*10"), Ok(MacroValue::Number(0.0)));
    assert_eq!(fanuc("#2+#2"), Ok(MacroValue::Number(0.0)));
    for (text, holds) in [
        ("#2EQ#0", true),
        ("#2NE#0", false),
        ("#2EQ0", false),
        ("#2NE0", true),
        ("#2GE0", true),
        ("#2LE0", true),
        ("#2GT0", false),
        ("#2LT0", false),
        ("#20NE#0", true),
    ] {
        assert_eq!(condition(text), holds, "{text}");
    }
}

#[test]
fn a_comparison_as_a_value() {
    assert_eq!(fanuc("[1EQ1]"), Err(Code::ConditionAsValue));
    assert_eq!(haas("[1EQ1]+[1EQ2]", None), 1.0);
}

#[test]
fn what_has_no_value() {
    assert_eq!(fanuc("1/0"), Err(Code::DivisionByZero));
    assert_eq!(fanuc("1/#2"), Err(Code::DivisionByZero));
    assert_eq!(fanuc("5MOD0"), Err(Code::DivisionByZero));
    assert_eq!(fanuc("SQRT[-1]"), Err(Code::OutsideDomain));
    assert_eq!(fanuc("LN[0]"), Err(Code::OutsideDomain));
    assert_eq!(fanuc("ASIN[1.1]"), Err(Code::OutsideDomain));
    assert_eq!(fanuc("TAN[90]"), Err(Code::OutsideDomain));
    assert_eq!(fanuc("EXP[10000]"), Err(Code::NumberOverflow));
    assert_eq!(fanuc("PRM[1]"), Err(Code::UnsupportedMacro));
}

#[test]
fn what_is_computed_from_an_unknown_value_is_unknown() {
    let unknown = MacroValue::Unknown(UnknownCause::Variable(700));
    for text in [
        "#700",
        "-#700",
        "#700+1",
        "0*#700",
        "#700*0",
        "1/#700",
        "SQRT[#700]",
        "ATAN[#700]/[0]",
        "POW[#700,2]",
        "#[#700]",
        "ABS[ROUND[#700*2]]",
        "#2+#700",
        "LN[#700-#700]",
    ] {
        assert_eq!(fanuc(text), Ok(unknown), "{text}");
    }
    // Whatever is divided by zero is an alarm.
    assert_eq!(fanuc("#700/0"), Err(Code::DivisionByZero));
    assert_eq!(fanuc("#700MOD#2"), Err(Code::DivisionByZero));
    let table = table(chordal_machine::ControlName::Fanuc).expect("a table");
    for text in ["#700EQ#0", "#700NE#0", "[#700GT1]OR[1EQ1]", "[1EQ2]AND[#700LT1]"] {
        let value = run(text, table.lexicon.grammar, table.macros, ValuePurpose::CONDITION);
        assert_eq!(
            value.map(Truth::from),
            Ok(Truth::Unknown(UnknownCause::Variable(700))),
            "{text}"
        );
    }
}

#[test]
fn what_cannot_be_read() {
    assert_eq!(fanuc("[1+2"), Err(Code::UnbalancedBrackets));
    assert_eq!(fanuc("1+"), Err(Code::BadExpression));
    assert_eq!(fanuc("(1+2)"), Err(Code::BadExpression));
    assert_eq!(fanuc("##20"), Err(Code::UnsupportedMacro));
    assert_eq!(fanuc("#<A>"), Err(Code::BadExpression));
    assert_eq!(fanuc("[[[[[1]]]]]"), Ok(MacroValue::Number(1.0)));
    assert_eq!(fanuc("[[[[[[1]]]]]]"), Err(Code::BracketsTooDeep));
    assert_eq!(fanuc("[[[[[SIN[1]]]]]]"), Err(Code::BracketsTooDeep));
    for text in ["[".repeat(100_000), "SIN[".repeat(100_000), "SIN".repeat(100_000)] {
        assert!(fanuc(&text).is_err());
    }
    assert_eq!(fanuc(&format!("{}1", "-".repeat(100_001))), Ok(MacroValue::Number(-1.0)));
    assert_eq!(fanuc(&format!("0{}", "+1".repeat(100_000))), Ok(MacroValue::Number(100_000.0)));
}

#[test]
fn linuxcnc_reads_its_own_grammar() {
    let table = table(chordal_machine::ControlName::Linuxcnc).expect("a table");
    let value = |text: &str| {
        run(text, table.lexicon.grammar, &MacroRules::NONE, ValuePurpose::VALUE).expect(text)
    };
    assert_eq!(value("[2 ** 3 * 2]"), MacroValue::Number(16.0));
    assert_eq!(value("##20"), MacroValue::Number(4.0));
    assert_eq!(value("#<width>"), MacroValue::Number(5.0));
    assert_eq!(value("EXISTS[#<width>]"), MacroValue::Number(1.0));
    assert_eq!(value("[-7 MOD 3]"), MacroValue::Number(2.0));
    assert_eq!(value("FIX[-1.5]"), MacroValue::Number(-2.0));
    // Comparisons come before AND there: 6 AND [4 EQ 4].
    assert_eq!(value("[#120 AND 4 EQ 4]"), MacroValue::Number(1.0));
}

#[test]
fn fadal_reads_its_own_grammar() {
    let grammar = table(chordal_machine::ControlName::Fadal).expect("a table").lexicon.grammar;
    let value =
        |text: &str| run(text, grammar, &MacroRules::NONE, ValuePurpose::VALUE).expect(text);
    let v = grammar.letter_variables.iter().position(|name| *name == "V").unwrap_or(0) as f64;
    assert_eq!(value("V2+V(1+1)"), MacroValue::Number(2.0 * (v * 1000.0 + 2.0)));
    assert_eq!(value("2*(3+4)-SGN(0)"), MacroValue::Number(13.0));
    assert_eq!(value("INT(7.9)<|>7"), MacroValue::Number(0.0));
}
