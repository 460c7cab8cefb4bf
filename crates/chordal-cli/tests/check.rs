//! `chordal check`: exit codes and formats.

#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_types,
    reason = "the tests of a shell have its files and processes"
)]

mod common;

use std::collections::BTreeSet;
use std::process::Command;

use common::{BROKEN, CLEAN, Folder};
use serde_json::{Value, json};

#[test]
fn a_clean_program_ends_with_zero() {
    let done = Folder::with_part().run(&["check", "part.nc", "-m", "haas-vf2"]).ends(0);
    assert_eq!(done.out, "");
    assert_eq!(done.err, "no problems\n");
}

#[test]
fn an_error_ends_with_one_and_is_underlined() {
    let folder = Folder::new();
    folder.write("bad.nc", BROKEN);
    folder.run(&["check", "bad.nc", "-m", "haas-vf2"]).ends(1).says(&[
        "error[CH401]",
        "bad.nc:6:",
        "G2 X1. Y1. I.4 J0",
        "^^",
        "alarm 304",
        "1 error",
    ]);
}

#[test]
fn the_severity_that_fails_can_be_chosen() {
    let folder = Folder::new();
    // A tool without a length in the machine file is a note.
    folder.write("note.nc", "O1\nG20 G90 T1 M6\nG43 H1 Z1.\nM30\n");
    let check = |severity: &str| {
        folder.run(&["check", "note.nc", "-m", "haas-vf2", "--fail-on", severity]).code
    };
    assert_eq!([check("note"), check("warning"), check("error"), check("never")], [1, 0, 0, 0]);
    folder.write("bad.nc", BROKEN);
    folder.run(&["check", "bad.nc", "--fail-on", "never"]).ends(0).says(&["error[CH401]"]);
}

#[test]
fn an_unreadable_file_is_one_line_and_the_others_are_checked() {
    let folder = Folder::with_part();
    folder.write("bad.nc", BROKEN);
    let done = folder
        .run(&["check", "none.nc", "bad.nc", "part.nc", "-m", "haas-vf2"])
        .ends(2)
        .says(&["error[CH401]"])
        .complains(&["error: cannot read none.nc: no such file", "1 error; 1 of 2 programs"]);
    assert_eq!(done.err.lines().count(), 2);
}

#[test]
fn a_folder_stands_for_its_programs_by_content() {
    let folder = Folder::new();
    folder
        .write("arch/O0001", CLEAN)
        .write("arch/deep/part", CLEAN)
        .write("arch/bad.tap", BROKEN)
        .write("arch/readme.md", "G1 X1.\n")
        .write("arch/notes", "nothing to run here\n")
        .write("arch/picture", b"\x89PNG\r\n\x1a\n\x00\x00\x00\x0dIHDR\x01\x02\x03\x04\x05\x06")
        .write("arch/.hidden", BROKEN)
        .write("arch/empty", "");
    folder
        .run(&["check", "arch", "-m", "haas-vf2"])
        .ends(1)
        .complains(&["1 error; 1 of 3 programs with problems"]);
    folder.write("nothing/notes", "nothing\n");
    folder.run(&["check", "nothing"]).ends(2).complains(&["there is no program in nothing"]);
}

#[test]
fn json_is_one_object_for_one_file_and_for_many() {
    let folder = Folder::with_part();
    folder.write("bad.nc", BROKEN);
    for files in [&["part.nc"][..], &["part.nc", "bad.nc"]] {
        let done = folder.run(&[&["check", "--format", "json"], files].concat());
        let object: Value = serde_json::from_str(&done.out).unwrap();
        assert_eq!(object["schema"], "chordal.check/1");
        let found = object["files"].as_array().unwrap();
        assert_eq!(found.len(), files.len());
        for (file, name) in found.iter().zip(files) {
            assert_eq!(file["file"], *name);
            assert_eq!(file["diagnostics"].as_array().unwrap().is_empty(), *name == "part.nc");
        }
    }
}

#[test]
fn json_has_the_readings_of_a_text_that_names_no_control() {
    let folder = Folder::with_part();
    folder.write("unclear.nc", "G0 X0 Y0 Z5\nG1 Z-1 F100\nX20 Y10\n");
    let check = |more: &[&str]| -> Value {
        let done = folder.run(&[&["check", "--format", "json", "unclear.nc"], more].concat());
        serde_json::from_str::<Value>(&done.out).unwrap()["files"][0].clone()
    };
    let readings = &check(&[])["readings"];
    assert_eq!(readings["difference"], json!({ "line": 1, "only_feed": false }));
    let possible = readings["possible"].as_array().unwrap();
    assert!(possible.len() >= 2, "{readings:#}");
    for reading in possible {
        assert_eq!(reading["control"], reading["controls"][0]);
        // What is typed gives this reading, and nothing is left to ask.
        let option: Vec<&str> = reading["option"].as_str().unwrap().split(' ').collect();
        let read = check(&option);
        assert_eq!(read["control"], reading["control"]);
        assert_eq!(read["machine"], reading["machine"]);
        assert_eq!(read.get("readings"), None);
        assert_eq!(read["verified"], true);
    }
    let size = |units: &str| {
        let found = possible.iter().find(|reading| reading["units"] == units);
        found.map(|reading| (reading["size_mm"].clone(), reading["motion"].clone()))
    };
    assert_eq!(size("mm"), Some((json!([20.0, 10.0, 6.0]), json!("Z 5 mm"))));
    assert_eq!(size("inch"), Some((json!([508.0, 254.0, 152.4]), json!("Z 127 mm"))));
}

#[test]
fn sarif_and_github_can_be_read() {
    let folder = Folder::with_part();
    folder.write("bad.nc", BROKEN);
    let done = folder.run(&["check", "--format", "sarif", "bad.nc", "part.nc"]).ends(1);
    let log: Value = serde_json::from_str(&done.out).unwrap();
    assert_eq!(log["version"], "2.1.0");
    assert!(log["runs"][0]["results"].as_array().unwrap().iter().any(|r| r["ruleId"] == "CH401"));

    let done = folder.run(&["check", "--format", "github", "bad.nc"]).ends(1);
    assert!(done.out.starts_with("::error "), "{}", done.out);
    assert!(done.out.contains("file=bad.nc,line=6"), "{}", done.out);
}

#[test]
fn problems_come_with_what_was_recognized() {
    let folder = Folder::with_part();
    folder.write("bad.nc", BROKEN).write("haas.nc", BROKEN.replace("G0 X0", "G154 P1 G0 X0"));
    folder.run(&["check", "bad.nc"]).says(&["bad.nc: assumed Fanuc", "error["]);
    folder.run(&["check", "haas.nc"]).says(&["recognized as Haas NGC mill by line 3 (G154"]);
    assert_eq!(folder.run(&["check", "part.nc"]).out, "");
    folder.run(&["commands", "haas.nc"]).complains(&["recognized as Haas NGC mill by line 3"]);
}

#[test]
fn colours_come_when_asked_for() {
    let folder = Folder::new();
    folder.write("bad.nc", BROKEN);
    assert!(!folder.run(&["check", "bad.nc"]).out.contains('\x1b'));
    assert!(!folder.run(&["check", "bad.nc", "--color", "never"]).out.contains('\x1b'));
    assert!(folder.run(&["check", "bad.nc", "--color", "always"]).out.contains('\x1b'));
}

#[test]
fn wrong_use_ends_with_two() {
    let folder = Folder::with_part();
    for arguments in [
        &["check"][..],
        &["check", "part.nc", "--format", "xml"],
        &["check", "part.nc", "--machine", "haas"],
        &["nothing"],
        &["chords", "part.nc", "--tolerance", "0.01"],
        &["run", "part.nc", "--program", "x"],
        &["run", "part.nc", "--program", "77"],
    ] {
        folder.run(arguments).ends(2);
    }
}

#[test]
fn a_run_that_is_not_verified_ends_with_one() {
    let folder = Folder::new();
    folder.write("polar.nc", "O1\nG21 G90 S900 M3\nG1 X9. F50.\nG33 Z-5. F2.\nX5.\nM30\n");
    let check = |severity: &str| {
        folder.run(&["check", "polar.nc", "-m", "fanuc-30i", "--fail-on", severity])
    };
    for severity in ["error", "warning", "note"] {
        check(severity).ends(1).says(&["error[CH312]", "polar.nc:4:"]);
    }
    check("never").ends(0).says(&["error[CH312]"]);
    folder.run(&["check", "polar.nc", "-m", "fanuc-30i"]).ends(1).says(&["not verified", "line 4"]);
    let done = folder.run(&["check", "polar.nc", "-m", "fanuc-30i", "--format", "json"]).ends(1);
    let told: Value = serde_json::from_str(&done.out).expect("JSON");
    let program = &told["files"][0];
    let program = if program.is_null() { &told } else { program };
    assert_eq!(program["verified"], false, "{told}");
    assert_eq!(program["not_verified_from"]["line"], 4, "{told}");
}

/// A program with an error behind thirty warnings.
fn many() -> Folder {
    let folder = Folder::new();
    let twice = "G2 X1. Y0 I.5 J0 R.5\nG1 X0 Y0\n".repeat(30);
    folder.write(
        "many.nc",
        format!("O1\nG20 G90 G17 S900 M3\nF10.\n{twice}G2 X9. Y1. I1. J0\nM30\n"),
    );
    folder
}

#[test]
fn problems_are_grouped_by_code_and_errors_come_first() {
    let folder = many();
    let done = folder.run(&["check", "many.nc", "-m", "fanuc-30i"]).ends(1);
    let heads: Vec<&str> = done.out.lines().filter(|line| line.contains("[CH")).collect();
    assert!(heads[0].starts_with("error["), "{heads:?}");
    let mut codes: Vec<&str> =
        heads.iter().filter(|head| head.starts_with("warning")).copied().collect();
    codes.dedup_by_key(|head| head.split(']').next());
    let warnings = heads.iter().filter(|head| head.starts_with("warning")).count();
    assert_eq!(codes.len(), warnings, "one place of each code: {heads:?}");
    assert!(
        done.out.contains(" = also CH409: lines 6, 8, 10, 12, 14, 16, 18, 20 and 21 more places"),
        "{}",
        done.out
    );
}

#[test]
fn how_much_is_shown_can_be_chosen() {
    let folder = many();
    let lines = |more: &[&str]| {
        let arguments = [&["check", "many.nc", "-m", "fanuc-30i"], more].concat();
        folder.run(&arguments).ends(1).out.lines().count()
    };
    let (quiet, usual, two, all) =
        (lines(&["--quiet"]), lines(&[]), lines(&["--max", "2"]), lines(&["--verbose"]));
    assert!(quiet < usual && usual < all && two < all, "{quiet} {usual} {two} {all}");
    assert!(quiet <= 8, "a line for each code, and the counts: {quiet}");
}

#[test]
fn json_keeps_every_place() {
    let folder = Folder::new();
    let far: String = (0..500).map(|_| "G2 X90. Y1. I1. J0\nG1 X0 Y0\n".to_string()).collect();
    folder.write("far.nc", format!("O1\nG20 G90 G17 S900 M3\nG1 X0 Y0 F10.\n{far}M30\n"));
    let done = folder.run(&["check", "far.nc", "-m", "fanuc-30i", "--format", "json"]).ends(1);
    let value: Value = serde_json::from_str(&done.out).expect("JSON");
    let found = value["files"][0]["diagnostics"].as_array().expect("a list");
    assert_eq!(found.iter().filter(|one| one["code"] == "CH401").count(), 500);
}

/// A git repository with a clean and a broken program, both committed.
fn repository() -> Folder {
    let folder = Folder::new();
    folder.write("parts/good.nc", CLEAN).write("parts/bad one.nc", BROKEN);
    folder.write("chordal.toml", "machine = \"haas-vf2\"\n");
    git(&folder, &["init", "--quiet"]);
    git(&folder, &["add", "."]);
    git(&folder, &["commit", "--quiet", "--message", "parts"]);
    folder
}

fn git(folder: &Folder, words: &[&str]) -> String {
    let who = ["-c", "user.name=A", "-c", "user.email=a@example.com"];
    let mut command = Command::new("git");
    let done = command.arg("-C").arg(folder.path(".")).args(who).args(words).output().expect("git");
    assert!(done.status.success(), "{words:?}: {}", String::from_utf8_lossy(&done.stderr));
    String::from_utf8(done.stdout).unwrap().trim().to_string()
}

#[test]
fn only_what_changed_is_checked() {
    let folder = repository();
    let since = ["check", ".", "--changed-since", "HEAD"];
    folder.run(&since).ends(0).complains(&["no program has changed since HEAD"]);
    folder.run(&["check", "."]).ends(1);
    // A changed one, one that is new, and one that is gone.
    folder.write("parts/good.nc", CLEAN.replace("I-.5", "I-.4"));
    folder.write("new.nc", BROKEN);
    std::fs::remove_file(folder.path("parts/bad one.nc")).unwrap();
    let done = folder.run(&[&since[..], &["--format", "github"]].concat()).ends(1);
    let errors: Vec<&str> = done.out.lines().filter(|line| line.starts_with("::error ")).collect();
    assert_eq!(errors.len(), 2, "{}", done.out);
    assert!(errors[0].starts_with("::error file=new.nc,line=6,"), "{}", done.out);
    assert!(errors[1].starts_with("::error file=parts/good.nc,line=9,"), "{}", done.out);
    // A branch is compared with where it left, not with what came later elsewhere.
    git(&folder, &["branch", "elsewhere"]);
    git(&folder, &["add", "."]);
    git(&folder, &["commit", "--quiet", "--message", "worse"]);
    folder.run(&["check", ".", "--changed-since", "elsewhere"]).ends(1);
    folder.run(&since).ends(0);

    let wrong = folder.run(&["check", ".", "--changed-since=--output=x"]).ends(2);
    assert!(!folder.path("x").exists(), "{}", wrong.err);
    let unknown = ["check", ".", "--changed-since", "nobody"];
    folder.run(&unknown).ends(2).complains(&["there is no commit `nobody`", "fetch-depth: 0"]);
    let outside = Folder::with_part();
    let asked = ["check", "part.nc", "--changed-since", "HEAD"];
    outside.run(&asked).ends(2).complains(&["is not in a git repository"]);
}

#[test]
fn gitlab_knows_a_problem_again() {
    let folder = Folder::new();
    let of = |text: &str| -> Vec<Value> {
        folder.write("bad.nc", text);
        let done = folder.run(&["check", "bad.nc", "--format", "gitlab"]).ends(1);
        serde_json::from_str(&done.out).unwrap()
    };
    let error = |found: &[Value]| {
        let of_arc = |problem: &&Value| problem["severity"] == "critical";
        found.iter().find(of_arc).cloned().unwrap()
    };
    let before = error(&of(BROKEN));
    assert_eq!(before["location"]["path"], "bad.nc");
    assert_eq!(before["location"]["lines"]["begin"], 6);
    assert!(before["check_name"].as_str().unwrap().starts_with("CH401 "));
    // A line above moves it; it is the same problem.
    let moved = error(&of(&BROKEN.replace("S900", "(A LINE ABOVE)\nS900")));
    assert_eq!(moved["location"]["lines"]["begin"], 7);
    assert_eq!(moved["fingerprint"], before["fingerprint"]);
    // The same arc twice is two problems.
    let arc = "G2 X1. Y1. I.4 J0\n";
    let twice = of(&BROKEN.replace(arc, &format!("{arc}G1 X0 Y0\n{arc}")));
    let prints: BTreeSet<&str> =
        twice.iter().map(|problem| problem["fingerprint"].as_str().unwrap()).collect();
    assert_eq!(prints.len(), twice.len());
}

#[cfg(unix)]
#[test]
fn the_step_of_a_workflow_marks_lines_and_writes_a_table() {
    let folder = repository();
    let base = git(&folder, &["rev-parse", "HEAD"]);
    folder.write("parts/good.nc", CLEAN.replace("I-.5", "I-.4"));
    git(&folder, &["add", "."]);
    git(&folder, &["commit", "--quiet", "--message", "worse"]);
    let step = |more: &[(&str, &str)]| {
        let script = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tools/action");
        let mut command = Command::new("bash");
        command.arg(script).current_dir(folder.path("."));
        command.env("CHORDAL", env!("CARGO_BIN_EXE_chordal")).env("BASE", &base);
        command.env("COMPARE", "parts").env("GITHUB_STEP_SUMMARY", folder.path("summary.md"));
        let done = command.envs(more.iter().copied()).output().expect("bash");
        (done.status.code(), String::from_utf8(done.stdout).unwrap())
    };
    let (code, out) = step(&[]);
    assert_eq!(code, Some(1), "{out}");
    assert!(out.starts_with("::error file=parts/good.nc,line=9,"), "{out}");
    let table = folder.read("summary.md");
    assert!(table.contains("**2 files: 1 same, 1 path; 1 new problem in 1 file**"), "{table}");
    assert!(table.contains("| good.nc | path | "), "{table}");
    // Nothing of it stays in the repository.
    assert_eq!(git(&folder, &["worktree", "list"]).lines().count(), 1);
    let (code, _) = step(&[("FAIL_ON", "never")]);
    assert_eq!(code, Some(0));
    let (code, _) = step(&[("BASE", "nobody")]);
    assert_eq!(code, Some(2));
}
