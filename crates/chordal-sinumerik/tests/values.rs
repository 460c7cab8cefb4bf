//! Conversions, operators and functions against the manual and the worked examples.

mod compact;

use chordal_sinumerik::syntax::{
    Address, AddressWord, BlockReader, Expression, StatementKind, VariableType, WordValue,
};
use chordal_sinumerik::values::{
    EvaluationError, NAMED_INDEX, SinumerikValue, VariableSource, evaluate,
};

/// R1 = 1, R2 = 2, R[n] = 10·n, the axes X and Y, and an array that notes its indices.
#[derive(Default)]
struct SampleSource {
    indices: Vec<i64>,
}

impl VariableSource for SampleSource {
    fn read(
        &mut self,
        address: &Address,
        indices: &[i64],
    ) -> Result<SinumerikValue, EvaluationError> {
        match (&*address.name, address.extension, indices) {
            ("R", Some(number), []) => Ok(SinumerikValue::Real(f64::from(number))),
            ("R", None, [index]) => Ok(SinumerikValue::Real(*index as f64 * 10.0)),
            ("X" | "Y", None, []) => Ok(SinumerikValue::Axis(address.name.to_string())),
            ("$P_UIFR", None, indices) => {
                self.indices = indices.to_vec();
                Ok(SinumerikValue::Real(7.0))
            }
            _ => Err(EvaluationError::unknown_name(address.range, &address.name)),
        }
    }

    fn call(
        &mut self,
        name: &str,
        arguments: &[Option<SinumerikValue>],
    ) -> Option<Result<SinumerikValue, EvaluationError>> {
        let error = EvaluationError::new(Default::default(), 14020, "bad");
        match name {
            "COUNT" => Some(Ok(SinumerikValue::Integer(arguments.len() as i32))),
            "BAD" => Some(Err(error)),
            _ => None,
        }
    }
}

/// The expression after `R1=`.
fn expression(text: &str) -> Expression {
    let line = format!("R1={text}");
    let block = BlockReader::new(line.as_bytes()).next().expect("a block");
    assert!(block.faults.is_empty(), "{line}: {:?}", block.faults);
    match block.statements.into_iter().next().expect("a statement").kind {
        StatementKind::Word(AddressWord { value: WordValue::Plain(value), .. }) => value,
        other => panic!("{other:?}"),
    }
}

fn value(text: &str) -> SinumerikValue {
    evaluate(&expression(text), &mut SampleSource::default())
        .unwrap_or_else(|error| panic!("{text}: {error:?}"))
}

fn alarm(text: &str) -> u32 {
    evaluate(&expression(text), &mut SampleSource::default()).expect_err(text).alarm
}

fn integer(value: i32) -> SinumerikValue {
    SinumerikValue::Integer(value)
}

fn real(value: f64) -> SinumerikValue {
    SinumerikValue::Real(value)
}

fn boolean(value: bool) -> SinumerikValue {
    SinumerikValue::Boolean(value)
}

fn text(value: &str) -> SinumerikValue {
    SinumerikValue::text(value)
}

#[test]
fn worked_examples() {
    assert_eq!(value("R1==1 AND R2==2"), boolean(false));
    assert_eq!(value("(R1==1) AND (R2==2)"), boolean(true));
    assert_eq!(real(2.5).converted(VariableType::Integer), Ok(integer(3)));
    assert_eq!(real(-2.5).converted(VariableType::Integer), Ok(integer(-3)));
    assert_eq!(value("7 DIV 2"), integer(3));
    assert_eq!(value("-7 MOD 4"), integer(-3));
    assert_eq!(compact::line("LL: X=IC(1)"), "LL> X=Incremental<1>");
    assert_eq!(compact::line("REPEAT LL P=2"), "REPEAT LL P=2");
    assert_eq!(compact::line("L100 P3"), "L:100 P:3");
    assert_eq!(compact::line("G4 S30"), "G:4 S:30");
}

#[test]
fn arithmetic() {
    for (source, expected) in [
        ("7/2", real(3.5)),
        ("6/2", real(3.0)),
        ("-7 DIV 2", integer(-3)),
        ("7.5 DIV 2", integer(3)),
        ("7.5 MOD 2", real(1.5)),
        ("2147483647+1", real(2_147_483_648.0)),
        ("2147483648", real(2_147_483_648.0)),
        ("-2147483648", integer(i32::MIN)),
        ("-2147483648 DIV -1", real(2_147_483_648.0)),
        ("-2147483648 MOD -1", integer(0)),
        ("TRUE+TRUE", integer(2)),
        ("'H0F' B_AND 'B101'", integer(5)),
        ("5 B_OR 2 B_XOR 1", integer(7)),
        ("B_NOT 0", integer(-1)),
        ("NOT 0.1", boolean(false)),
        ("1 XOR 2", boolean(false)),
        ("$PI", real(std::f64::consts::PI)),
        ("R[R1+1]", real(20.0)),
    ] {
        assert_eq!(value(source), expected, "{source}");
    }
}

#[test]
fn comparisons() {
    for (source, expected) in [
        ("0.1+0.2==0.3", true),
        ("0.1+0.2<>0.3", false),
        ("0.1+0.2>=0.3", true),
        ("0.1+0.2<=0.3", true),
        ("0.1+0.2>0.3", true),
        ("1==1.00000000001", false),
        ("1==1.0000000000001", true),
        ("0==0", true),
        ("1EX-300==0", false),
        ("\"A\"==\"A\"", true),
        ("\"A\"<\"B\"", true),
        ("\"A\"<>\"a\"", true),
        ("X==X", true),
        ("X==Y", false),
        ("TRUE==1", true),
    ] {
        assert_eq!(value(source), boolean(expected), "{source}");
    }
    assert_eq!(alarm("\"1\"==1"), 12150);
    assert_eq!(alarm("X==1"), 12150);
}

#[test]
fn texts() {
    for (source, expected) in [
        ("\"A\"<<1+2<<0.5<<-3.0<<TRUE", text("A30.5-31")),
        ("<<R1", text("1")),
        ("<<1/3", text("0.3333333333333333")),
        ("\"-\"<<0*-1.5", text("-0")),
        ("STRLEN(\"ABC\")", integer(3)),
        ("INDEX(\"ABCB\",\"B\")", integer(1)),
        ("RINDEX(\"ABCB\",\"B\")", integer(3)),
        ("INDEX(\"ABC\",\"Z\")", integer(-1)),
        ("MINDEX(\"ABC\",\"XC\")", integer(2)),
        ("MATCH(\"ABCD\",\"CD\")", integer(2)),
        ("SUBSTR(\"ABCDE\",1,2)", text("BC")),
        ("SUBSTR(\"ABCDE\",3)", text("DE")),
        ("SUBSTR(\"ABC\",9)", text("")),
        ("NUMBER(\"-1.5EX2\")", real(-150.0)),
        ("ISNUMBER(\"1.5\")", boolean(true)),
        ("ISNUMBER(\"NAN\")", boolean(false)),
        ("ISNUMBER(\"\")", boolean(false)),
        ("TOUPPER(\"aB\")", text("AB")),
        ("TOLOWER(\"aB\")", text("ab")),
    ] {
        assert_eq!(value(source), expected, "{source}");
    }
    assert_eq!(alarm("NUMBER(\"A\")"), 14051);
    assert_eq!(alarm("\"A\"<<X"), 14096);
    assert_eq!(alarm("\"A\"+1"), 12150);
}

#[test]
fn functions() {
    for (source, expected) in [
        ("SIN(90)", 1.0),
        ("SIN(30)", 0.5),
        ("COS(90)", 0.0),
        ("COS(-180)", -1.0),
        ("SIN(-450)", -1.0),
        ("COS(60)", 0.5),
        ("TAN(45)", 1.0),
        ("ASIN(1)", 90.0),
        ("ACOS(-1)", 180.0),
        ("ATAN2(1,-1)", 135.0),
        ("ATAN2(0,-1)", 180.0),
        ("ATAN2(0*-1.5,-1)", 180.0),
        ("ATAN2(30.5,80.1)", 20.8455),
        ("SQRT(16)", 4.0),
        ("ABS(-2.5)", 2.5),
        ("POT(3)", 9.0),
        ("TRUNC(-2.9)", -2.0),
        ("ROUND(2.5)", 3.0),
        ("ROUND(-2.5)", -3.0),
        ("ROUNDUP(3.1)", 4.0),
        ("ROUNDUP(-3.6)", -3.0),
        ("LN(EXP(2))", 2.0),
        ("MINVAL(3,-1)", -1.0),
        ("MAXVAL(3,-1)", 3.0),
        ("BOUND(1,5,7)", 5.0),
        ("BOUND(1,5,0)", 1.0),
        ("BOUND(1,5,2.5)", 2.5),
    ] {
        let found = value(source).to_real().unwrap();
        assert!((found - expected).abs() < 1e-4, "{source}: {found}");
    }
    assert_eq!(value("SIN(180)"), real(0.0));
    assert_eq!(value("COS(270)"), real(0.0));
}

#[test]
fn alarms() {
    for source in [
        "1/0",
        "1 DIV 0",
        "1 MOD 0",
        "SQRT(-1)",
        "LN(0)",
        "ASIN(2)",
        "TAN(90)",
        "EXP(1000)",
        "1EX300*1EX300",
    ] {
        assert_eq!(alarm(source), 14051, "{source}");
    }
    assert_eq!(alarm("UNKNOWN"), 12550);
    assert_eq!(alarm("UNKNOWN(1)"), 12550);
    assert_eq!(alarm("SIN()"), 14020);
    assert_eq!(alarm("SIN(1,2)"), 14020);
    assert_eq!(alarm("BOUND(1,,2)"), 14020);
    assert_eq!(alarm("B_NOT 1EX10"), 14096);
    let line = expression("2+BAD(1)");
    let error = evaluate(&line, &mut SampleSource::default()).expect_err("bad");
    assert_eq!((error.range.start, error.range.end), (5, 11));
}

#[test]
fn sources_get_indices_and_calls() {
    let mut source = SampleSource::default();
    let result = evaluate(&expression("$P_UIFR[R2-0.6,X,TR]"), &mut source);
    assert_eq!(result, Ok(real(7.0)));
    assert_eq!(source.indices, [1, NAMED_INDEX, NAMED_INDEX]);
    assert_eq!(value("COUNT(1,,X)"), integer(3));
    assert_eq!(alarm("R[1/0]"), 14051);
}

#[test]
fn conversions() {
    let alarm = |value: SinumerikValue, kind| value.converted(kind).expect_err("a fault").alarm;
    for (given, kind, expected) in [
        (integer(0), VariableType::Boolean, boolean(false)),
        (real(-0.1), VariableType::Boolean, boolean(true)),
        (text(""), VariableType::Boolean, boolean(false)),
        (text("A"), VariableType::Boolean, boolean(true)),
        (text("A"), VariableType::Character, SinumerikValue::Character(65)),
        (real(65.4), VariableType::Character, SinumerikValue::Character(65)),
        (SinumerikValue::Character(65), VariableType::Text(1), text("A")),
        (SinumerikValue::Character(65), VariableType::Real, real(65.0)),
        (boolean(true), VariableType::Integer, integer(1)),
        (integer(5), VariableType::Real, real(5.0)),
        (real(2147483647.4), VariableType::Integer, integer(i32::MAX)),
    ] {
        assert_eq!(given.clone().converted(kind), Ok(expected), "{given:?}");
    }
    assert_eq!(alarm(real(2147483647.5), VariableType::Integer), 14096);
    assert_eq!(alarm(integer(256), VariableType::Character), 14096);
    assert_eq!(alarm(text("AB"), VariableType::Character), 14096);
    assert_eq!(alarm(text("1"), VariableType::Real), 14096);
    assert_eq!(alarm(integer(1), VariableType::Text(9)), 14096);
    assert_eq!(alarm(text("ABC"), VariableType::Text(2)), 14096);
    assert_eq!(alarm(integer(1), VariableType::Axis), 14096);
    assert_eq!(SinumerikValue::initial(VariableType::Text(3)), Some(text("")));
}

#[test]
fn the_highest_expressions_are_evaluated() {
    let nested = format!("{}1{}", "ABS(".repeat(199), ")".repeat(199));
    assert_eq!(value(&nested), integer(1));
    let chain = format!("{}1{}{}", "(".repeat(190), ")".repeat(190), "+1".repeat(512));
    assert_eq!(value(&chain), integer(513));
}
