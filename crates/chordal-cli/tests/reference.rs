//! `explain`, `machines`, `completions` and the help: what can be looked up.

mod common;

use common::Folder;

#[track_caller]
fn says(arguments: &[&str], texts: &[&str]) {
    Folder::new().run(arguments).ends(0).says(texts);
}

#[test]
fn a_message_by_number_or_name_with_the_alarms() {
    for name in ["CH401", "ch401", "radius-mismatch"] {
        says(
            &["explain", name],
            &["CH401 radius-mismatch:", "Severity: error", "alarm 304", "PS0020"],
        );
    }
}

#[test]
fn a_code_on_one_control_and_on_all() {
    says(&["explain", "G154"], &["G154 on Haas", "takes     P", "Not on Fadal CNC 88, Fanuc"]);
    says(&["explain", "g02.1"], &["G2.1 on Mitsubishi", "#1272 ex08/bit2"]);
    says(
        &["explain", "CYCL DEF 203"],
        &["cycle 203: universal drilling", "Q213  number of chip breaks"],
    );
    says(&["explain", "Q214", "-m", "heidenhain-mill"], &["disengaging direction"]);
    says(&["explain", "CYCLE83"], &["Sinumerik", "deep"]);
    says(&["explain", "label number not found"], &["CH202"]);
    says(&["explain", "tool radius too large"], &["HEIDENHAIN TNC: TOOL RADIUS TOO LARGE"]);
    says(&["explain", "M97"], &["on Haas", "HEIDENHAIN conversational: M97"]);
    says(&["explain", "M17", "-m", "fadal-4020"], &["M17 on Fadal CNC 88: end of a subroutine"]);
    says(&["explain", "G4", "-m", "haas-vf2"], &["P1 is 0.001 s, P1. is 1 s"]);
    says(
        &["explain", "G3", "-m", "fanuc-30i"],
        &["motion, until G0 G1 G2", "No. 3410 = 0.0127 mm"],
    );
}

#[test]
fn a_letter_and_a_setting() {
    says(&["explain", "R", "-m", "fadal-4020"], &["radius of an arc", "a register", "taken by G2"]);
    says(&["explain", "L"], &["subroutine", "repeats its block"]);
    says(&["explain", "E"], &["work offset"]);
    says(&["explain", "Setting", "40"], &["Setting 40 on Haas", "diameter"]);
    says(&["explain", "radius_error_tolerance"], &["on Fadal CNC 88", "0.0005 in"]);
}

#[test]
fn what_nobody_knows_gets_a_suggestion() {
    let folder = Folder::new();
    for (word, said) in [
        ("radius-mismach", "did you mean `radius-mismatch`?"),
        ("G156", "G155 is"),
        ("G9999", "no control has G9999"),
        ("nonsense", "write a message"),
        ("", "write a message"),
        ("Ä", "write a message"),
    ] {
        folder.run(&["explain", word]).ends(2).complains(&[said]);
    }
}

#[test]
fn machines_are_listed_and_shown() {
    says(
        &["machines"],
        &["fadal-4020", "haas-vf2", "mitsubishi-m700-type2", "textbook-from-center"],
    );
    says(
        &["machines", "haas-vf2"],
        &[
            "Haas VF-2",
            "650 in/min",
            "X     -762 to 0 mm",
            "Setting 40",
            "documented",
            "arc_center",
        ],
    );
    says(&["machines", "--schema"], &["| `axes.<axis>.max_velocity` |"]);
    Folder::new()
        .run(&["machines", "hass"])
        .ends(2)
        .complains(&["there is no built-in machine `hass`"]);
}

#[test]
fn a_machine_as_a_file_is_the_same_machine() {
    let folder = Folder::new();
    let first = folder.run(&["machines", "fadal-4020", "--toml"]).ends(0).out;
    folder.write("mine.toml", &first);
    let again = folder.run(&["machines", "mine.toml", "--toml"]).ends(0).out;
    let keys = |text: &str| {
        text.lines().filter(|line| !line.starts_with('#')).collect::<Vec<_>>().join("\n")
    };
    assert_eq!(keys(&again), keys(&first));
    // What is true of the built-in figures only is a remark in the copy.
    assert!(first.contains("# There, acceleration and jerk are typical"), "{first}");
    assert!(!first.contains("notes ="), "{first}");
}

#[test]
fn every_shell_gets_its_completions() {
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        says(&["completions", shell], &["chordal"]);
    }
}

#[test]
fn help_has_examples() {
    for command in ["run", "check", "commands", "chords", "explain", "machines", "completions"] {
        says(&[command, "--help"], &["Usage: chordal", "Examples:\n  chordal"]);
    }
    says(&["--help"], &["Examples:", "Exit code: 0 clean, 1 problems"]);
    says(&["--version"], &["chordal 0."]);
}
