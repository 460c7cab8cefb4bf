//! The runner must fail where it should.

use crate::check::check;

/// Name, program, and a part of the failure's text (`None`: it passes).
pub const CASES: &[(&str, &str, Option<&str>)] = &[
    ("a right program passes", "G1 X2. (= line to X2 feed 10)", None),
    ("a rounded number", "G3 X2. R1.0024 (= arc radius 1.002)", None),
    (
        "a number not rounded but cut",
        "G3 X2. R1.0026 (= arc radius 1.002)",
        Some("start is 1.0026"),
    ),
    ("an end has no such step", "G1 X.1 (= line to X.2)", Some("end X is 0.1, not 0.2")),
    ("a wrong end", "G1 X2. (= line to X2.1)", Some("end X is 2, not 2.1")),
    ("a wrong feed", "G1 X2. (= line feed 11)", Some("feed is 10, not 11")),
    ("a wrong kind", "G1 X2. (= rapid to X2)", Some("it is no rapid")),
    ("a motion too many", "G1 X2. (= none)", Some("not expected: line")),
    ("a motion too few", "G1 X2. (= line x2)", Some("nothing moved")),
    ("a wrong radius", "G3 X2. R1. (= arc ccw radius 1.1)", Some("radius at the start is 1")),
    ("a wrong sweep", "G3 X2. R1. (= arc ccw sweep 90)", Some("sweep is 180, not 90")),
    ("a wrong direction", "G3 X2. R1. (= arc cw)", Some("the other way")),
    ("a wrong plane", "G3 X2. R1. (= arc plane zx)", Some("plane is xy")),
    ("a wrong centre", "G3 X2. R1. (= arc center X1 Y1)", Some("centre Y is 0")),
    ("a centre of another plane", "G3 X2. R1. (= arc center Z1)", Some("centre Z is NaN")),
    ("a wrong length", "G3 X2. R1. (= arc length 3)", Some("length is 3.14")),
    ("a helix that is none", "G3 X2. R1. (= helix)", Some("it is no helix")),
    ("a kink", "G1 X2.\nY1. (= line tangent .01)", Some("is 90, not 0")),
    ("an unexpected error", "G3 X2. I.5", Some("error not expected: CH401")),
    ("an unexpected warning", "G1 Z-1.\nG0 X1.\nG1 X2.", Some("warning not expected: CH602")),
    ("a missing diagnostic", "G1 X2. (= line | ! CH401)", Some("expected CH401")),
    ("a diagnostic with another text", "G3 X2. I.5 (= arc | ! CH401 \"9 in\")", Some("9 in")),
    ("a diagnostic on another line", "G1 X1. (= line | ! CH401)\nG3 X2. I.4", Some(":5: expected")),
    ("a misspelt item", "G1 X2. (= lien to X2)", Some("`lien` is none of")),
    ("a misspelt key", "G1 X2. (= line too X2)", Some("unknown word `too`")),
    ("a misspelt directive", "(machin: haas-vf2)\nG1 X2.", Some("unknown directive")),
    (
        "events in their order",
        "G82 X1. Z-1. R0 P.5 (= rapid to X1 | line | dwell .5 | rapid)\nG80 M5 (= spindle off)",
        None,
    ),
    ("a wrong dwell", "G4 P.5 (= dwell .6)", Some("dwell 0.5 after 0 motions")),
    ("a dwell too few", "G4 P.5 (= dwell .5 | dwell .5)", Some("dwell 0.5 after 0 motions, dwell")),
    (
        "a dwell at the wrong place",
        "G82 X1. Z-1. R0 P.5 (= rapid to X1 | dwell .5 | line | rapid)",
        Some("expected dwell 0.5 after 1"),
    ),
    ("a spindle event too many", "M3 G4 P1 M5 (= dwell 1)", Some("spindle")),
    ("a misspelt spindle", "M5 (= spindle of)", Some("`of` is none of")),
    ("a word after an event", "M5 (= spindle off on)", Some("unknown word `on`")),
    ("corners in the mode of the control", "G61.1 G1 X2. (= line corner stop)", None),
    ("another mode", "G1 X2. (= line corner stop)", Some("corner is round 0")),
    ("another distance", "G1 X2. (= line corner round .02)", Some("corner is round 0")),
    ("a misspelt mode", "G1 X2. (= line corner rounded)", Some("`rounded` is none of")),
    ("an unclosed expectation", "G1 X2. (= line", Some("no `)`")),
    ("a wrong total", "(total: lines 2)\nG1 X2.", Some("total lines is 1")),
    ("a wrong last place", "(ends at: X3)\nG1 X2.", Some("end X is 2")),
    (
        "another machine moves otherwise",
        "(same motion on: fanuc-30i)\nG1 X2\n(= ! CH305)",
        Some("on fanuc-30i"),
    ),
    ("expectations go on below", "G1 X2.\n(= line to X3)", Some("end X is 2, not 3")),
];

/// Runs one case.
pub fn run(case: &(&str, &str, Option<&str>)) -> Result<(), String> {
    let (_, body, wanted) = case;
    // Haas reads X2 as two increments; linuxcnc-mill is a calculator and starts in inches.
    let text =
        format!("(machine: linuxcnc-mill)\nG20 G90 F10 S900 M3\nG0 X0 Y0 Z0\nG17\n{body}\nM2\n");
    match (check("case", &text), wanted) {
        (Ok(()), None) => Ok(()),
        (Ok(()), Some(wanted)) => Err(format!("passed, and should fail with `{wanted}`")),
        (Err(error), Some(wanted)) if error.contains(wanted) => Ok(()),
        (Err(error), _) => Err(format!("{error}\nwanted: {wanted:?}")),
    }
}
