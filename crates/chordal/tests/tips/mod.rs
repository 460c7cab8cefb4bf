//! Where the tip of a tool is, and what of it is proved.

mod forgotten;
mod frames;

use chordal::Code;
use chordal::stock::{StockReport, StockVerdict};

use crate::run;

/// A plate of 40 by 40 by 20 mm, two mills of which the second is 100 mm longer.
const TWO_MILLS: &str = r#"
machine = "fanuc-0i"
[work_offsets.G54]
X = "-200 mm"
Y = "-200 mm"
Z = "-300 mm"
[stock]
shape = "box"
from = { X = "0 mm", Y = "0 mm", Z = "-20 mm" }
to = { X = "40 mm", Y = "40 mm", Z = "0 mm" }
[tools.1]
kind = "flat"
diameter = "10 mm"
flute_length = "30 mm"
length = "100 mm"
[tools.2]
kind = "flat"
diameter = "10 mm"
flute_length = "30 mm"
length = "200 mm"
"#;

fn lowest_tip(report: &StockReport) -> f64 {
    report.tools.iter().map(|tool| tool.lowest_mm).fold(f64::INFINITY, f64::min)
}

#[test]
fn the_tip_is_at_the_programmed_point_plus_the_length_in_force_minus_that_of_the_tool() {
    // Z-5 with T2: H2 leaves the tip there, none puts it 200 mm lower, H1 100 mm lower, and a length that the
    // program has written 1 mm too large 1 mm higher.
    let cases = [
        ("G43 H2 Z25.", -5.0, StockVerdict::Clean),
        ("Z25.", -205.0, StockVerdict::Problems),
        ("G43 H0 Z25.", -205.0, StockVerdict::Problems),
        ("G43 H1 Z25.", -105.0, StockVerdict::Problems),
        ("G10 L10 P2 R201.\nG43 H2 Z25.", -4.0, StockVerdict::Clean),
    ];
    for (length, tip, verdict) in cases {
        let program = format!(
            "O1\nG21 G90 G17 G40 G49 G80\nT2 M6\nG0 G54 X20. Y20. S3000 M3\n{length}\nG1 Z-5. F300.\nG0 Z25.\nM30\n"
        );
        let found = run(TWO_MILLS, &program);
        assert_eq!(found.verdict, verdict, "{length}");
        assert!((lowest_tip(&found) - tip).abs() < 1e-6, "{length}: {}", lowest_tip(&found));
        let says = found.report.diagnostics.iter().any(|each| each.code == Code::TipDisplaced);
        assert_eq!(says, verdict == StockVerdict::Problems, "{length}");
    }
}

#[test]
fn a_tool_of_which_nobody_knows_the_tip_is_not_proved() {
    let unknown =
        TWO_MILLS.replace("length = \"100 mm\"\n", "").replace("length = \"200 mm\"\n", "");
    let program = |second: &str| {
        format!(
            "O1\nG21 G90 G17 G40 G49 G80\nT1 M6\nG0 G54 X10. Y20. S3000 M3\nG43 H1 Z25.\nG1 Z-5. F300.\nG0 Z25.\n\
             T2 M6\nG0 X30. Y20. S3000 M3\n{second}\nG1 Z-5. F300.\nG0 Z25.\nM30\n"
        )
    };
    assert_eq!(run(&unknown, &program("G43 H2 Z25.")).verdict, StockVerdict::Clean);
    for forgotten in ["Z25.", "G43 H1 Z25.", "G49 Z25."] {
        let found = run(&unknown, &program(forgotten));
        assert_eq!(found.verdict, StockVerdict::NotProved, "{forgotten}");
    }
}

#[test]
fn a_rapid_of_which_only_the_end_is_known_is_looked_at_there() {
    // Without work offsets the height before the first approach is not known.
    let offsets = TWO_MILLS.find("[work_offsets").unwrap()..TWO_MILLS.find("[stock]").unwrap();
    let mut unknown = TWO_MILLS.to_string();
    unknown.replace_range(offsets, "");
    let program = |approach: &str, after: &str| {
        format!(
            "O1\nG21 G90 G17 G40 G49 G80\nT2 M6\nG0 G54 X20. Y20. S3000 M3\nG43 H2 {approach}\nG1 Z-9. F300.\n\
             {after}\nM30\n"
        )
    };
    let verdict = |approach: &str, after: &str| run(&unknown, &program(approach, after)).verdict;
    assert_eq!(verdict("Z10.", "G0 Z25.\nG91 G28 X0 Y0"), StockVerdict::Clean);
    assert_eq!(verdict("Z10.", "G91 G28 Z0\nG28 X0 Y0"), StockVerdict::Clean);
    assert_eq!(verdict("Z-7.", "G0 Z25."), StockVerdict::Problems);
    assert_eq!(verdict("Z10.", "G91 G28 X0 Y0"), StockVerdict::NotProved);
    assert_eq!(verdict("Z10.", "G53 G0 X0 Y0"), StockVerdict::NotProved);
}

#[test]
fn a_spindle_without_speed_does_not_turn() {
    let program = "O1\nG21 G90 G17 G40 G49 G80\nT2 M6\nG0 G54 X20. Y20. S0 M3\nG43 H2 Z25.\nG1 Z-5. F300.\nG0 Z25.\nM30\n";
    assert_eq!(run(TWO_MILLS, program).verdict, StockVerdict::Problems);
}

#[test]
fn a_speed_that_nobody_knows_or_that_is_set_by_hand_is_no_stopped_spindle() {
    let program = |speed: &str| {
        format!(
            "O1\nG21 G90 G17 G40 G49 G80\nT2 M6\nG0 G54 X20. Y20.\n{speed} M3\nG43 H2 Z25.\nG1 Z-5. F300.\nG0 Z25.\nM30\n"
        )
    };
    let says_stopped = |setup: &str, speed: &str| {
        let found = run(setup, &program(speed));
        found
            .report
            .diagnostics
            .iter()
            .any(|each| matches!(each.code, Code::SpindleStopped | Code::CutsWithoutSpindle))
    };
    assert!(!says_stopped(TWO_MILLS, "S#500"));
    assert!(!says_stopped(&TWO_MILLS.replace("fanuc-0i", "mach3-mill"), ""));
    assert!(says_stopped(TWO_MILLS, ""));
}
