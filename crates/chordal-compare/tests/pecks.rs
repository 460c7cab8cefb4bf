//! Holes drilled in different pecks: equal only where this is allowed and nothing else differs.

use std::collections::BTreeSet;

use chordal::{Job, Machine, Source, SourceMap};
use chordal_compare::{Category, Comparison, ComparisonOptions, ComparisonVerdict, compare};

fn job(cycle: &str, settings: &[&str]) -> Job<'static> {
    let text = format!(
        "G21 G90 G17 G54\nT1 M6\nS900 M3\nG0 X0 Y0 Z5.\n{cycle}\nX20.\nG80\nG0 Z50.\nM30\n"
    );
    let mut sources = SourceMap::new();
    sources.add(Source::new("part.nc", text.into_bytes()));
    let mut machine = Machine::from_builtin("fanuc-30i").expect("a built-in machine");
    for setting in settings {
        machine.set(setting).expect("a good setting");
    }
    Job::new(sources, machine).expect("good settings")
}

/// Lines 5 and 6 may drill in different pecks.
fn compared(a: &Job, b: &Job) -> Comparison {
    let lines = BTreeSet::from([5, 6]);
    let free_pecks = [lines.clone(), lines];
    compare(a, b, &ComparisonOptions { free_pecks, ..ComparisonOptions::default() })
}

const CYCLE: &str = "G98 G83 X10. Y0 Z-20. R2. Q6. F100.";

#[test]
fn other_steps_are_the_same_hole() {
    let [a, b] = [
        job(CYCLE, &[]),
        job(&CYCLE.replace("Q6.", "Q4."), &["settings.peck_clearance=\"0.5 mm\""]),
    ];
    let found = compared(&a, &b);
    assert_eq!(found.verdict, ComparisonVerdict::Same, "{:?}", found.differences);
    assert_eq!(found.pecks.len(), 2);
    let [one, other] = &found.pecks[0];
    assert_eq!(one.depths_mm, [6.0, 12.0, 18.0, 22.0]);
    assert_eq!(other.depths_mm, [4.0, 8.0, 12.0, 16.0, 20.0, 22.0]);
    assert_eq!((one.clearance_mm(), other.clearance_mm()), (Some(1.0), Some(0.5)));
    assert_eq!((one.largest_step_mm(), other.largest_step_mm()), (6.0, 4.0));
    assert_eq!((one.above_r_mm(), other.above_r_mm()), (Some(0.0), Some(0.0)));
    assert_eq!((one.place.line, other.place.line), (5, 5));
}

#[test]
fn the_same_steps_are_not_told() {
    let found = compared(&job(CYCLE, &[]), &job(CYCLE, &[]));
    assert_eq!((found.verdict, found.pecks.len()), (ComparisonVerdict::Same, 0));
}

#[test]
fn a_hole_in_one_cut_is_the_hole_of_the_pecks() {
    let [a, b] = [job(CYCLE, &[]), job(&CYCLE.replace("G83", "G81").replace("Q6. ", ""), &[])];
    let found = compared(&a, &b);
    assert_eq!(found.verdict, ComparisonVerdict::Same, "{:?}", found.differences);
    assert_eq!(found.pecks[0][1].depths_mm, [22.0]);
    assert_eq!(found.pecks[0][1].clearance_mm(), None);
}

#[test]
fn what_is_more_than_pecks_is_a_difference() {
    let old = job(CYCLE, &[]);
    for (from, to, category) in [
        ("Z-20.", "Z-21.", Category::Path),
        ("R2.", "R3.", Category::Path),
        ("X10.", "X10.1", Category::Path),
        ("G98", "G99", Category::Path),
        ("F100.", "F110.", Category::Feed),
    ] {
        let new = job(&CYCLE.replace(from, to), &[]);
        let found = compared(&old, &new);
        assert_eq!(found.verdict, ComparisonVerdict::Different, "{to}");
        assert!(found.differences.iter().any(|one| one.category == category), "{to}");
    }
}

#[test]
fn steps_of_other_lines_are_compared_move_by_move() {
    let [a, b] = [job(CYCLE, &[]), job(&CYCLE.replace("Q6.", "Q4."), &[])];
    assert_eq!(
        compare(&a, &b, &ComparisonOptions::default()).verdict,
        ComparisonVerdict::Different
    );
    // The second hole is drilled by line 6.
    let free_pecks = [BTreeSet::from([5]), BTreeSet::from([5])];
    let found = compare(&a, &b, &ComparisonOptions { free_pecks, ..ComparisonOptions::default() });
    assert_eq!(found.verdict, ComparisonVerdict::Different);
    let lines = found.differences.iter().filter_map(|one| one.blocks[0]).map(|at| at.lines());
    assert!(lines.into_iter().all(|lines| lines == (6, 6)), "{:?}", found.differences);
}

/// Pecks programmed as moves are not those of a cycle.
#[test]
fn pecks_by_hand_are_compared_move_by_move() {
    let [a, b] = ["Z-5.", "Z-6."].map(|depth| {
        let mut text = "G21 G90 G17 G54\nT1 M6\nS900 M3\nG0 X0 Y0 Z5.\n".to_string();
        text += &format!("G1 {depth} F100.\nG0 Z2.\nG0 Z-4.\nG1 Z-20.\nG0 Z5.\nM30\n");
        let mut sources = SourceMap::new();
        sources.add(Source::new("part.nc", text.into_bytes()));
        let machine = Machine::from_builtin("fanuc-30i").expect("a built-in machine");
        Job::new(sources, machine).expect("good settings")
    });
    let lines: BTreeSet<u32> = (1..=10).collect();
    let options =
        ComparisonOptions { free_pecks: [lines.clone(), lines], ..ComparisonOptions::default() };
    assert_eq!(compare(&a, &b, &options).verdict, ComparisonVerdict::Different);
}
