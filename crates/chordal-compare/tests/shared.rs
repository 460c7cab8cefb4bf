//! A difference in every category must be found.

use chordal::{Job, Machine, Source, SourceMap};
use chordal_compare::{Category, ComparisonOptions, ComparisonVerdict, compare};

fn job(text: &str, machine: &str) -> Job<'static> {
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", text.as_bytes().to_vec()));
    Job::new(sources, Machine::from_builtin(machine).unwrap()).unwrap()
}

/// A machine, a line of its program, the replacement, and the category that then differs.
const PLANTED: &[(&str, &str, &str, Category)] = &[
    ("fanuc-0i", "G41 D1 X20. F100.", "G41 D2 X20. F100.", Category::RadiusOffset),
    ("fanuc-0i", "M10", "M11", Category::Code),
    ("fanuc-0i", "M10", "", Category::Code),
    ("fanuc-0i", "M51 P0", "M51 P1", Category::Code),
    ("fanuc-0i", "X20.", "/X20.", Category::BlockDelete),
    ("fanuc-0i", "M8", "/M8", Category::BlockDelete),
    ("fanuc-0i", "/G91", "G91", Category::BlockDelete),
    ("fanuc-0i", "/X20.", "/2X20.", Category::BlockDelete),
    ("fanuc-0i", "X#500", "X#501", Category::Value),
    ("fanuc-0i", "IF[#1000EQ1]GOTO9\nN9 X30.", "N9 X30.", Category::Value),
    (
        "fanuc-0i",
        "IF[#1000EQ1]GOTO8\nX5.\nGOTO9\nN8#3000=1(NO CLAMP)\nN9",
        "IF[#1000EQ1]GOTO8\nX5.\nGOTO9\nN8\nN9",
        Category::NotRun,
    ),
    (
        "fanuc-0i",
        "IF[#1000EQ1]THEN #3000=1(NO CLAMP)",
        "IF[#1000EQ1]THEN #3000=2(NO CLAMP)",
        Category::NotRun,
    ),
    ("fanuc-0i", "IF[#1000EQ1]THEN #3000=1(NO CLAMP)", "", Category::Value),
    ("fanuc-0i", "#3000=1(NO CLAMP)", "#3000=2(NO CLAMP)", Category::Alarm),
    ("fanuc-0i", "#3000=1(NO CLAMP)", "#3000=1(NO PART)", Category::Alarm),
    ("fanuc-0i", "#3006=1(TURN IT)", "#3006=1(MEASURE IT)", Category::Message),
    ("fanuc-0i", "G10 L2 P6 X10.", "G10 L2 P6 X11.", Category::Written),
    ("fanuc-0i", "G10 L2 P6 X10.", "", Category::Written),
    ("fanuc-0i", "G10 L12 P3 R5.", "G10 L12 P3 R6.", Category::Written),
    ("fanuc-0i", "#5241=10.", "#5241=11.", Category::Written),
    ("fanuc-0i", "#1100=1", "#1100=0", Category::Variable),
    ("fanuc-0i", "#501=7", "#501=8", Category::Variable),
    ("fanuc-0i", "G22 X100. Y100. Z100. I0 J0 K0", "", Category::Code),
    ("fanuc-0i", "G22 X100. Y100. Z100. I0 J0 K0", "G22 X90. Y100. Z100. I0 J0 K0", Category::Code),
    ("fanuc-0i", "M0", "M1", Category::Stop),
    ("linuxcnc-mill", "M62 P1", "M62 P2", Category::Code),
    ("linuxcnc-mill", "M62 P1", "M63 P1", Category::Code),
    ("linuxcnc-mill", "M68 E0 Q5", "M68 E0 Q6", Category::Code),
    ("linuxcnc-mill", "(MSG,one)", "(MSG,two)", Category::Message),
    ("linuxcnc-mill", "G10 L2 P6 X10", "G10 L2 P6 X11", Category::Written),
    ("linuxcnc-mill", "G10 L1 P3 Z10", "G10 L1 P3 Z11", Category::Written),
    ("linuxcnc-mill", "G28.1", "", Category::Written),
    ("linuxcnc-mill", "#5241=10", "#5241=11", Category::Written),
    ("linuxcnc-mill", "M61 Q1", "M61 Q2", Category::Tool),
    ("haas-vf2", "M10", "M11", Category::Code),
    ("mitsubishi-m700", "M10", "M11", Category::Code),
];

fn program(line: &str, machine: &str) -> String {
    let has_points = machine != "linuxcnc-mill";
    let point = if has_points { "." } else { "" };
    format!(
        "G21 G90 G94 G17 G40\nT1 M6\nS900 M3\nG0 X0 Y0 Z5{point}\nG1 Z-1{point} F100{point}\nX10{point}\n{line}\n\
         G1 X15{point} F100{point}\nG40 X40{point}\nG0 Z5{point}\nM30\n"
    )
}

#[test]
fn a_planted_difference_of_every_item_is_seen() {
    let mut missed = Vec::new();
    for (machine, line, other, category) in PLANTED {
        let jobs = [line, other].map(|line| job(&program(line, machine), machine));
        let found = compare(&jobs[0], &jobs[1], &ComparisonOptions::default());
        let categories: Vec<Category> =
            found.differences.iter().map(|difference| difference.category).collect();
        if found.verdict != ComparisonVerdict::Different || !categories.contains(category) {
            missed
                .push(format!("{machine}: {line:?} {other:?}: {:?} {categories:?}", found.verdict));
        }
    }
    assert!(missed.is_empty(), "{} of {}:\n{}", missed.len(), PLANTED.len(), missed.join("\n"));
}

#[test]
fn an_unchanged_program_has_no_difference() {
    for (machine, line, other, _) in PLANTED {
        for line in [line, other] {
            let jobs = [line, line].map(|line| job(&program(line, machine), machine));
            let found = compare(&jobs[0], &jobs[1], &ComparisonOptions::default());
            assert!(found.differences.is_empty(), "{machine}: {line}: {:?}", found.differences);
        }
    }
}

#[test]
fn the_time_of_a_rotary_move_is_compared() {
    let rotary = |feed: &str| {
        job(&format!("G21 G90 G94\nG0 X0 Y0 Z5. A0\nG1 A90. F{feed}\nM30\n"), "fanuc-30i")
    };
    for pair in [["135.", "60."], ["100.", "101."]] {
        let jobs = pair.map(rotary);
        assert_eq!(
            compare(&jobs[0], &jobs[1], &ComparisonOptions::default()).verdict,
            ComparisonVerdict::Different
        );
    }
}
