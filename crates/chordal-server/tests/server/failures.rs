//! A panic in Chordal ends one answer, and the page continues.

use crate::common::{FAILS, Live, Shown, serve};

const GOOD: &str = "G21 G90\nG0 X10. Y0 Z5.\nG1 X20. F100.\nM30\n";

/// Replaces the whole text.
fn edit(live: &mut Live, until: usize, text: &str) {
    let change = serde_json::json!({ "from": 0, "to": until, "insert": text });
    let replied = serde_json::json!({ "id": 5, "request": "edit", "changes": [change] });
    live.send(&replied.to_string());
}

#[test]
fn a_run_that_fails_is_reported_and_the_next_edit_runs() {
    let mut live = serve(Shown::text(GOOD)).live();
    assert_eq!(live.json("report")["errors"], 0);
    let bad = format!("G21\n{FAILS}\nG0 X1.\nM30\n");
    edit(&mut live, GOOD.len(), &bad);
    let refused = live.json("refused");
    let message = refused["message"].as_str().unwrap();
    assert!(message.starts_with("Chordal failed: ") && message.contains("a made-up failure"));
    assert_eq!(refused["run"], 2);
    edit(&mut live, bad.len(), GOOD);
    let report = live.json("report");
    assert_eq!((&report["run"], &report["errors"]), (&3.into(), &0.into()));
    live.json("times");
}

#[test]
fn a_program_that_fails_at_once_may_be_edited_and_queried() {
    let bad = format!("{FAILS}\nM30\n");
    let mut live = serve(Shown::text(&bad)).live();
    live.json("refused");
    live.send(r#"{ "id": 9, "request": "outline" }"#);
    assert_eq!(live.json("outline")["id"], 9);
    edit(&mut live, bad.len(), GOOD);
    assert_eq!(live.json("report")["errors"], 0);
}

#[test]
fn a_comparison_with_a_program_that_fails_leaves_the_page() {
    let other = format!("G21 G90\nG0 X1.\n{FAILS}\nM30\n");
    let mut live = serve(Shown::text(GOOD).compared(Shown::text(&other), false)).live();
    let received = live.json("no_comparison");
    assert!(received["message"].as_str().unwrap().contains("a made-up failure"), "{received}");
    edit(&mut live, 0, "(AGAIN)\n");
    live.json("report");
    live.json("no_comparison");
}
